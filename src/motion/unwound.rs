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

#[cfg(test)]
mod tests {
    use super::*;

    /// The involute of the circle of radius 10 between two rolls, climbing by 3 mm.
    fn unwound(from: f64, to: f64) -> Unwound {
        let at = |roll: f64| {
            let leaves = DVec2::from_angle(roll);
            (leaves - leaves.perp() * roll) * 10.0
        };
        let involute = Involute::new(at(from), at(to), DVec2::ZERO, 10.0, to < from, 1e-9);
        Unwound::of_involute(&involute.expect("it is one"), Plane::Zx, [1.0, 4.0])
    }

    #[test]
    fn equal_steps_are_equal_ways() {
        // The arc length from the base circle is R φ² / 2 in the plane.
        for (from, to) in [(0.0, 1.5), (0.4, 2.0), (2.0, 0.4), (1.0, 0.0)] {
            let unwound = unwound(from, to);
            let flat = 5.0 * (to * to - from * from).abs();
            assert!((unwound.length - flat.hypot(3.0)).abs() < 1e-12, "{from} to {to}");
            for k in 0..=20_u32 {
                let share = f64::from(k) / 20.0;
                let roll = (from * from + share * (to * to - from * from)).sqrt();
                let leaves = DVec2::from_angle(roll);
                let truth = (leaves - leaves.perp() * roll) * 10.0;
                let truth = Plane::Zx.place(truth, 1.0 + 3.0 * share);
                let found = unwound.frame(unwound.length * share).point;
                assert!(found.distance(truth) < 1e-12, "{from} to {to} at {share}: {found}");
            }
            let part = unwound.part(0.25 * unwound.length, 0.75 * unwound.length);
            let (a, b) = (part.frame(1.0), unwound.frame(0.25 * unwound.length + 1.0));
            assert!(a.point.distance(b.point) < 1e-12, "{from} to {to}: a part");
        }
    }

    #[test]
    fn derivatives_are_those_of_the_points() {
        for (from, to) in [(0.4, 2.0), (2.0, 0.4)] {
            let unwound = unwound(from, to);
            for k in 1..20 {
                let (s, h) = (unwound.length * f64::from(k) / 20.0, 1e-4);
                let [before, here, after] = [s - h, s, s + h].map(|s| unwound.frame(s));
                let slope = |a: DVec3, b: DVec3| (b - a) / (2.0 * h);
                for (found, truth, name) in [
                    (here.tangent, slope(before.point, after.point), "tangent"),
                    (here.curvature, slope(before.tangent, after.tangent), "curvature"),
                    (here.sharpness, slope(before.curvature, after.curvature), "sharpness"),
                ] {
                    assert!(found.distance(truth) < 1e-7, "{name} at {s}: {found} {truth}");
                }
            }
        }
    }

    #[test]
    fn on_the_base_circle_everything_is_finite() {
        let unwound = unwound(0.0, 1.0);
        let Frame { point, tangent, curvature, sharpness } = unwound.frame(0.0);
        assert!([point, tangent, curvature, sharpness].iter().all(|v| v.is_finite()), "finite");
        assert!((tangent.length() - 1.0).abs() < 1e-12, "a unit tangent");
    }
}
