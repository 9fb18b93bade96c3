//! Corners of every pair of segments: a contour of two segments that meet at a given turn.

use g41::contour::{Shape, SplineShape};
use glam::DVec2;

use super::sketch::{Sketch, arc, line};

/// A kind of segment, as it stands at a corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Leg {
    Line,
    /// Bends to the left where positive: radius of the arc, in tool radii.
    Arc(f64),
    /// Bends to the left where positive: radius of the circle on which its type points lie.
    Spline(f64),
    /// Bends to the left where positive: its radius of curvature at the corner, in tool radii.
    Involute(f64),
}

impl Leg {
    pub(crate) const ALL: [Self; 7] = [
        Self::Line,
        Self::Arc(14.0),
        Self::Arc(-14.0),
        Self::Spline(16.0),
        Self::Spline(-16.0),
        Self::Involute(12.0),
        Self::Involute(-12.0),
    ];

    pub(crate) fn is_straight(self) -> bool {
        self == Self::Line
    }
}

/// How far a leg reaches from the corner, in tool radii.
const REACH: f64 = 12.0;

/// Base radius of an involute, in tool radii.
const BASE: f64 = 9.0;

/// The leg out of `from` with the unit tangent `along` there, for a tool of `radius`.
fn outgoing(leg: Leg, from: DVec2, along: DVec2, radius: f64) -> Shape {
    match leg {
        Leg::Line => line(from + along * REACH * radius),
        Leg::Arc(bend) => {
            let center = from + along.perp() * bend * radius;
            let turn = DVec2::from_angle(REACH / bend);
            arc(center + turn.rotate(from - center), center, bend < 0.0)
        }
        Leg::Spline(bend) => {
            let center = from + along.perp() * bend * radius;
            // Unevenly spaced on the circle, so that the spline is one of its own.
            let at = |way: f64| center + DVec2::from_angle(way / bend).rotate(from - center);
            Shape::Spline(SplineShape {
                points: [2.0, 5.0, 8.0, REACH].map(at).to_vec(),
                start_tangent: Some(along),
                ..SplineShape::default()
            })
        }
        Leg::Involute(bend) => {
            let base = BASE * radius;
            // Outward: the thread leaves the circle along the normal, and its direction is `along`.
            let center = from + along.perp() * bend * radius - along * base;
            let first = bend.abs() / BASE;
            let last = (first * first + 2.0 * REACH / BASE).sqrt();
            let leaves = DVec2::from_angle((last - first) * bend.signum()).rotate(along);
            let to = center + leaves * base - leaves.perp() * (base * last * bend.signum());
            Shape::Involute { to, center, radius: base, clockwise: bend < 0.0 }
        }
    }
}

/// The contour that comes along `incoming` to the origin and goes on with `outgoing`, turned by
/// `turn` [rad].
pub(crate) fn corner(legs: [Leg; 2], heading: f64, turn: f64, radius: f64) -> Sketch {
    let (t1, t2) = (DVec2::from_angle(heading), DVec2::from_angle(heading + turn));
    // The incoming leg is an outgoing one run backwards: it then bends to the other side.
    let flipped = match legs[0] {
        Leg::Line => Leg::Line,
        Leg::Arc(bend) => Leg::Arc(-bend),
        Leg::Spline(bend) => Leg::Spline(-bend),
        Leg::Involute(bend) => Leg::Involute(-bend),
    };
    let back = Sketch::open(DVec2::ZERO, [outgoing(flipped, DVec2::ZERO, -t1, radius)]);
    let mut sketch = back.reversed();
    sketch.shapes.push(outgoing(legs[1], DVec2::ZERO, t2, radius));
    sketch
}
