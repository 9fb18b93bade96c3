//! Corners along which the velocity changes evenly from one line's direction to the other's.
//!
//! A tool that runs at an even pace along the incoming line, and changes its velocity to the same
//! along the outgoing one by `f(τ) = 35 τ⁴ − 84 τ⁵ + 70 τ⁶ − 20 τ⁷`, draws a curve of degree 8. As
//! three derivatives of `f` vanish at both ends, curvature and two of its derivatives do, and jerk
//! comes and goes gently. The tool slows down by the cosine of half the turn in it, so that a sharp
//! turn takes far less jerk than one traversed evenly.

use glam::DVec3;

use super::{Frame, Limits};
use crate::geometry::nth_root;

/// What a leg is longer than the limits ask for: what holds between knots, and a corner that begins
/// and ends gently, take some.
const LONGER: f64 = 1.25;

/// The largest third derivative of `f`: what the change of the jerk in time goes with.
const CHANGE: f64 = 52.5;

/// About the shortest leg [mm] of a corner between two unit tangents that differ by `turn`, with which
/// a speed [mm/s] is kept.
///
/// Along the corner of two legs `l` acceleration is at most `35/16 v² turn/(2 l)`, jerk `84/√125 v³
/// turn/(2 l)²`, and its change in time `105/2 v⁴ turn/(2 l)³`: the largest of the derivatives of `f`.
pub(super) fn shortest_leg(turn: f64, speed: f64, limits: &Limits) -> f64 {
    let square = speed * speed;
    let acceleration = 35.0 / 16.0 * turn * square / limits.acceleration;
    let jerk = (84.0 / 125.0_f64.sqrt() * turn * square * speed / limits.jerk).sqrt();
    let snap = nth_root(CHANGE * turn * square * square / limits.snap(), 3);
    0.5 * LONGER * acceleration.max(jerk).max(snap)
}

/// Whether a corner of some legs [mm] is passed before the jerk can have come and gone, at the speed that
/// its change in time allows and at most at a feed [mm/s], which is one that is come to from rest in as
/// little time: no law would be found for it, and a stop takes hardly longer.
pub(super) fn is_too_short(turn: f64, leg: f64, feed: f64, limits: &Limits) -> bool {
    let whole = 2.0 * leg;
    let fourth = whole * whole * whole * limits.snap() / (CHANGE * turn);
    let speed = fourth.sqrt().sqrt().min(feed);
    let least = 2.0 * limits.jerk / limits.snap();
    whole < least * speed && speed < 0.25 * limits.jerk * least * least
}

/// A corner between two lines, traversed by its pace: the way that the tool would have gone
/// meanwhile on the lines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Eased {
    /// The corner [mm].
    at: DVec3,
    /// Unit tangents before and behind it.
    tangents: [DVec3; 2],
    /// Where it begins before the corner and ends behind it [mm].
    leg: f64,
    /// The part of it: from one pace to another [mm].
    part: [f64; 2],
}

impl Eased {
    /// The curve that rounds the corner at `at` [mm] between two unit tangents, its ends `leg` [mm]
    /// from it.
    #[must_use]
    pub fn with_leg(at: DVec3, tangents: [DVec3; 2], leg: f64) -> Self {
        Self { at, tangents, leg, part: [0.0, 2.0 * leg] }
    }

    /// The way on the lines that it takes the place of [mm].
    #[must_use]
    pub fn length(&self) -> f64 {
        self.part[1] - self.part[0]
    }

    /// The part from one pace to another [mm].
    #[must_use]
    pub fn part(&self, from: f64, to: f64) -> Self {
        Self { part: [self.part[0] + from, self.part[0] + to], ..*self }
    }

    /// Point, and derivatives by the pace, at a pace [mm]. The first is a unit vector at the ends
    /// only.
    ///
    /// With `F = ∫ f = 7 τ⁵ − 14 τ⁶ + 10 τ⁷ − 5/2 τ⁸` the point is `P + 2 l ((τ − ½) T0 + F (T1 − T0))`: at the
    /// start `l` before the corner, at the end, where `F = ½`, as far behind it, and half-way, where
    /// `F = 35/512`, `35/256` of the legs from it along either line.
    #[must_use]
    pub fn frame(&self, pace: f64) -> Frame {
        let length = 2.0 * self.leg;
        let t = (self.part[0] + pace) / length;
        let [incoming, outgoing] = self.tangents;
        let turn = outgoing - incoming;
        let (square, left) = (t * t, 1.0 - t);
        let fourth = square * square;
        let whole = fourth * t * (7.0 + t * (t * (10.0 - 2.5 * t) - 14.0));
        let f = fourth * (35.0 + t * (t * (70.0 - 20.0 * t) - 84.0));
        let slope = 140.0 * square * t * left * left * left;
        let bend = 420.0 * square * left * left * (1.0 - 2.0 * t);
        Frame {
            point: self.at + (incoming * (t - 0.5) + turn * whole) * length,
            tangent: incoming + turn * f,
            curvature: turn * (slope / length),
            sharpness: turn * (bend / (length * length)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_joins_the_lines_without_curvature_and_passes_at_its_deviation() {
        for degrees in [0.1_f64, 10.0, 90.0, 150.0, 170.0] {
            let (sin, cos) = degrees.to_radians().sin_cos();
            let tangents = [DVec3::X, DVec3::new(cos, sin, 0.0)];
            let at = DVec3::new(3.0, -2.0, 1.0);
            let curve = Eased::with_leg(at, tangents, 0.4);
            for (pace, sign, tangent) in [(0.0, -0.4, tangents[0]), (0.8, 0.4, tangents[1])] {
                let frame = curve.frame(pace);
                assert!(frame.point.distance(at + tangent * sign) < 1e-12, "end at {degrees}");
                assert!(frame.tangent.distance(tangent) < 1e-12, "tangent at {degrees}");
                assert!(frame.curvature.length() < 1e-12, "curvature at {degrees}");
                assert!(frame.sharpness.length() < 1e-12, "sharpness at {degrees}");
            }
            let middle = curve.frame(0.4).point.distance(at);
            let meant = 0.4 * 35.0 / 256.0 * (tangents[1] - tangents[0]).length();
            assert!((middle - meant).abs() < 1e-12, "deviation at {degrees}: {middle} of {meant}");
        }
    }

    #[test]
    fn its_derivatives_are_those_of_its_points() {
        let curve = Eased::with_leg(DVec3::ZERO, [DVec3::X, DVec3::new(-0.6, 0.8, 0.0)], 0.5);
        let h = 1e-4;
        for pace in [0.1, 0.35, 0.5, 0.8] {
            let [before, here, after] = [pace - h, pace, pace + h].map(|pace| curve.frame(pace));
            let slope = |from: DVec3, to: DVec3| (to - from) / (2.0 * h);
            assert!(slope(before.point, after.point).distance(here.tangent) < 1e-5, "{pace}");
            assert!(slope(before.tangent, after.tangent).distance(here.curvature) < 1e-5, "{pace}");
            let third = slope(before.curvature, after.curvature);
            assert!(third.distance(here.sharpness) < 1e-4, "{pace}");
        }
    }
}
