//! An involute by arc length.

use glam::{DVec2, DVec3};

use super::Frame;
use crate::contour::Plane;
use crate::geometry::{Involute, perp};

/// Least roll that a curvature is told for [rad]: on the base circle it has no bound. From there it
/// is 5e-9 of the base radius away.
const LEAST_ROLL: f64 = 1e-4;

/// An involute in space, climbing evenly along the normal of its plane.
///
/// Its arc length is half the square of its roll but for the base radius, so point and derivatives at
/// an arc length are known in closed form, and its feed is constant to the last digits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unwound {
    involute: Involute,
    plane: Plane,
    /// Height above the plane where the involute begins [mm].
    height: f64,
    /// Climb per length [1].
    climb: f64,
    /// Length in the plane per length [1].
    level: f64,
    /// Where it begins on the involute that it is a part of [mm].
    from: f64,
    /// Arc length [mm].
    pub(super) length: f64,
}

impl Unwound {
    /// The involute in its plane, climbing evenly from the first height to the second [mm].
    #[must_use]
    pub fn of_involute(involute: &Involute, plane: Plane, heights: [f64; 2]) -> Self {
        let (flat, rise) = (involute.length(), heights[1] - heights[0]);
        let length = flat.hypot(rise);
        Self {
            involute: *involute,
            plane,
            height: heights[0],
            climb: rise / length,
            level: flat / length,
            from: 0.0,
            length,
        }
    }

    /// Point and derivatives at the arc length `s` [mm]. Within 5e-9 of the base radius of the base
    /// circle the curvature is the one there.
    #[must_use]
    pub fn frame(&self, s: f64) -> Frame {
        let Self { involute, plane, climb, level, .. } = self;
        let s = self.from + s;
        let t = s * level / involute.length();
        let (tangent, radius) = (involute.tangent(t), involute.base_radius());
        let most = 1.0 / (radius * LEAST_ROLL);
        let curvature = involute.curvature(t).max(-most).min(most);
        // With κ = oh/(Rφ) and ds = oRφ dφ it is dκ/ds = −h/(R²φ³).
        let outward = if involute.is_outward() { 1.0 } else { -1.0 };
        let change = -outward * radius * curvature.powi(3);
        let normal = perp(tangent);
        let flat = |v: DVec2| -> DVec3 { plane.place(v, 0.0) };
        Frame {
            point: plane.place(involute.point(t), self.height + climb * s),
            tangent: plane.place(tangent * *level, *climb),
            curvature: flat(normal * (level * level * curvature)),
            sharpness: flat((normal * change - tangent * (curvature * curvature)) * level.powi(3)),
        }
    }

    /// The part from one arc length to another [mm].
    #[must_use]
    pub fn part(&self, from: f64, to: f64) -> Self {
        Self { from: self.from + from, length: to - from, ..*self }
    }
}
