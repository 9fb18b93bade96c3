//! The curves that a move consists of, by arc length.

use super::{ByLength, Helix, Piece, Straight, Unwound};
use crate::contour::{Move, MoveCurve};

/// The pieces of a move: none where nothing moves, several for a cubic with cusps.
#[must_use]
pub fn pieces(one: &Move) -> Vec<Piece> {
    let Move { plane, heights, .. } = *one;
    match &one.curve {
        MoveCurve::Line(_) | MoveCurve::Vertical(_) => {
            let from = plane.place(one.curve.start(), heights[0]);
            let to = plane.place(one.curve.end(), heights[1]);
            Straight::between(from, to).map(Piece::Straight).into_iter().collect()
        }
        MoveCurve::Arc(arc) => {
            let reached = arc.center().distance(arc.end());
            // Its end is on its circle, but for what rounding left.
            if (reached - arc.radius()).abs() <= 1e-9 {
                vec![Piece::Helix(Helix::of_arc(arc, plane, heights))]
            } else {
                let curve = ByLength::of_winding_arc(arc, plane, heights);
                vec![Piece::Curve(Box::new(curve))]
            }
        }
        MoveCurve::Involute(involute) => {
            vec![Piece::Unwound(Unwound::of_involute(involute, plane, heights))]
        }
        MoveCurve::Cubic(cubic) => {
            let parts = ByLength::of_cubic(cubic, plane, heights);
            parts.into_iter().map(|part| Piece::Curve(Box::new(part))).collect()
        }
    }
}

/// Most chords that an arc is fitted by: CAM systems write arcs as short as their lines.
const MOST_CHORDS: u8 = 4;

/// How many lines stand for a move within a tolerance [mm]; 0 where they are too many, or none do.
pub(super) fn chords(one: &Move, tolerance: f64) -> u8 {
    let gap = match &one.curve {
        MoveCurve::Line(_) | MoveCurve::Vertical(_) => 0.0,
        // The sagitta of a chord over the angle φ is at most R φ²/8.
        MoveCurve::Arc(arc) => arc.radius() * arc.sweep() * arc.sweep() / 8.0,
        _ => f64::INFINITY,
    };
    (1..=MOST_CHORDS).find(|n| gap <= tolerance * f64::from(n * n)).unwrap_or(0)
}
