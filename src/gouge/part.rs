//! Parts of curves, with what tells quickly how far they can be from each other.

use glam::DVec2;

use crate::contour::MoveCurve;
use crate::geometry::{cross, relative_to};

/// A curve or a part of one; an involute comes as cubics.
#[derive(Debug, Clone, Copy)]
pub(super) struct Part {
    pub(super) curve: MoveCurve,
    /// Parameters on the curve that it is a part of.
    pub(super) span: [f64; 2],
    /// Centre of a disc around it [mm].
    pub(super) middle: DVec2,
    /// Radius of that disc [mm].
    pub(super) reach: f64,
    /// It stays within this distance of its chord [mm].
    pub(super) sagitta: f64,
}

impl Part {
    pub(super) fn new(curve: MoveCurve) -> Self {
        let span = [0.0, 1.0];
        let [start, end] = [curve.start(), curve.end()];
        let middle = start.midpoint(end);
        let half = 0.5 * start.distance(end);
        match &curve {
            MoveCurve::Arc(arc) => {
                let apothem = middle.distance(arc.center());
                if arc.sweep().abs() < std::f64::consts::PI {
                    Self { curve, span, middle, reach: half, sagitta: arc.radius() - apothem }
                } else {
                    let (middle, reach) = (arc.center(), arc.radius());
                    Self { curve, span, middle, reach, sagitta: reach + apothem }
                }
            }
            MoveCurve::Cubic(cubic) => {
                let [p0, p1, p2, p3] = cubic.points;
                // |C''| / 8, and C'' is linear.
                let bend = (p0 - p1 + (p2 - p1)).length_squared();
                let bend = bend.max((p1 - p2 + (p3 - p2)).length_squared());
                let sagitta = 0.75 * bend.sqrt();
                // The control points are within their hull, the curve within its sagitta.
                Self { curve, span, middle, reach: half + sagitta, sagitta }
            }
            MoveCurve::Line(_) | MoveCurve::Involute(_) | MoveCurve::Vertical(_) => {
                Self { curve, span, middle, reach: half, sagitta: 0.0 }
            }
        }
    }

    /// Its halves; none where it is too short to have any.
    pub(super) fn halves(&self) -> Option<[Self; 2]> {
        let (first, second) = match &self.curve {
            MoveCurve::Line(line) => {
                let (first, second) = line.split(0.5).ok()?;
                (MoveCurve::Line(first), MoveCurve::Line(second))
            }
            MoveCurve::Arc(arc) => {
                let (first, second) = arc.split(0.5).ok()?;
                (MoveCurve::Arc(first), MoveCurve::Arc(second))
            }
            MoveCurve::Cubic(cubic) => {
                let (first, second) = cubic.split(0.5);
                (MoveCurve::Cubic(first), MoveCurve::Cubic(second))
            }
            MoveCurve::Involute(_) | MoveCurve::Vertical(_) => return None,
        };
        let [from, to] = self.span;
        let middle = 0.5 * (from + to);
        let first = Self { span: [from, middle], ..Self::new(first) };
        Some([first, Self { span: [middle, to], ..Self::new(second) }])
    }

    /// Control points of the part as a cubic; an arc, which is none, gives a triangle around it
    /// where it is less than half a circle.
    pub(super) fn hull(&self) -> [DVec2; 4] {
        let [start, end] = [self.curve.start(), self.curve.end()];
        match &self.curve {
            MoveCurve::Cubic(cubic) => cubic.points,
            MoveCurve::Arc(arc) => {
                let out = self.middle - arc.center();
                let apex = arc.center() + out * (arc.radius().powi(2) / out.length_squared());
                [start, apex, apex, end]
            }
            MoveCurve::Line(_) | MoveCurve::Involute(_) | MoveCurve::Vertical(_) => {
                [start, start.lerp(end, 1.0 / 3.0), start.lerp(end, 2.0 / 3.0), end]
            }
        }
    }

    /// A distance from `point` [mm] that none of its points exceeds.
    pub(super) fn farthest(&self, point: DVec2) -> f64 {
        match &self.curve {
            MoveCurve::Arc(arc) if arc.sweep().abs() > std::f64::consts::FRAC_PI_2 => {
                arc.center().distance(point) + arc.radius()
            }
            _ => {
                let [a, b, c, d] = relative_to(point, self.hull());
                a.length().max(b.length()).max(c.length()).max(d.length())
            }
        }
    }

    /// The least distance that its chord and that of another leave them [mm]; not for arcs, which
    /// are closer to a circle.
    pub(super) fn chord_bound(&self, other: &Self) -> f64 {
        let a = [self.curve.start(), self.curve.end()];
        let b = [other.curve.start(), other.curve.end()];
        segment_distance(a, b) - self.sagitta - other.sagitta
    }
}

/// Distance of two straight segments [mm]: zero where they cross, else between an end of one and
/// the other.
fn segment_distance([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> f64 {
    let side = |from: DVec2, to: DVec2, p: DVec2| cross(to - from, p - from);
    let (sc, sd) = (side(a, b, c), side(a, b, d));
    let (sa, sb) = (side(c, d, a), side(c, d, b));
    if sc * sd <= 0.0 && sa * sb <= 0.0 && (sc != 0.0 || sd != 0.0) {
        return 0.0;
    }
    let from = |p: DVec2, [a, b]: [DVec2; 2]| {
        let along = b - a;
        let length_squared = along.length_squared();
        let t = if length_squared > 0.0 {
            ((p - a).dot(along) / length_squared).clamp(0.0, 1.0)
        } else {
            0.0
        };
        p.distance_squared(a + along * t)
    };
    let first = from(a, [c, d]).min(from(b, [c, d]));
    first.min(from(c, [a, b])).min(from(d, [a, b])).sqrt()
}
