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
        let tree = BoxTree::new(pieces.iter().map(MoveCurve::hull_bounds));
        Self { pieces, tree }
    }

    /// Whether `point` is at least `distance` [mm] from every point of the contour.
    pub(super) fn is_clear(&self, point: DVec2, distance: f64) -> bool {
        let mut clear = true;
        self.tree.meeting(&Bounds::of([point]).inflated(distance), |i| {
            let piece = &self.pieces[i];
            // The box of a cubic that reaches this far may still be too far off.
            if piece.hull_bounds().distance(point) >= distance {
                return true;
            }
            let near = piece.nearest(point).distance;
            clear = near >= distance;
            clear
        });
        clear
    }
}
