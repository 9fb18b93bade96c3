//! How far a place is from the contour.

use glam::DVec2;

use super::index::BoxTree;
use crate::contour::{Contour, MoveCurve};
use crate::geometry::{Bounds, Curve};

/// The whole contour, to be asked for distances.
#[derive(Debug)]
pub(super) struct Clearance {
    pieces: Vec<MoveCurve>,
    tree: BoxTree,
}

impl Clearance {
    pub(super) fn new(contour: &Contour) -> Self {
        let mut pieces = Vec::new();
        for segment in contour.segments() {
            match &segment.curve {
                Curve::Line(line) => pieces.push(MoveCurve::Line(*line)),
                Curve::Arc(arc) => pieces.push(MoveCurve::Arc(*arc)),
                Curve::Spline(spline) => {
                    pieces.extend(spline.pieces().iter().copied().map(MoveCurve::Cubic));
                }
            }
        }
        let tree = BoxTree::new(pieces.iter().map(hull));
        Self { pieces, tree }
    }

    /// Whether `point` is at least `distance` [mm] from every point of the contour.
    pub(super) fn is_clear(&self, point: DVec2, distance: f64) -> bool {
        let mut clear = true;
        self.tree.meeting(&Bounds::of([point]).inflated(distance), |i| {
            let piece = &self.pieces[i];
            let near = match piece {
                MoveCurve::Line(line) => line.nearest(point).distance,
                MoveCurve::Arc(arc) => arc.nearest(point).distance,
                MoveCurve::Cubic(cubic) if cubic.hull_bounds().distance(point) < distance => {
                    cubic.nearest(point).distance
                }
                MoveCurve::Cubic(_) | MoveCurve::Vertical(_) => return true,
            };
            clear = near >= distance;
            clear
        });
        clear
    }
}

/// A quick box around a piece.
pub(super) fn hull(piece: &MoveCurve) -> Bounds {
    match piece {
        MoveCurve::Cubic(cubic) => cubic.hull_bounds(),
        MoveCurve::Line(_) | MoveCurve::Arc(_) | MoveCurve::Vertical(_) => piece.bounds(),
    }
}
