//! Involute and any other curve.
//!
//! Cubics that are nearer to the involute than [`END_SLACK`] are held against the other curve. What
//! they share with it is brought onto the involute by its foot there, which is known in closed form.

use super::{Crossing, END_SLACK, Intersections};
use crate::geometry::{Cubic, Involute};

/// How near the cubics are [mm]: a part of the slack, so that what counts as on both is on both.
const NEAR: f64 = 0.1 * END_SLACK;

/// Where an involute crosses a curve, of which `with` tells where it crosses a cubic (the first
/// curve).
#[must_use]
pub fn involute_with(involute: &Involute, with: &dyn Fn(&Cubic) -> Intersections) -> Intersections {
    let mut crossings: Vec<Crossing> = Vec::new();
    for cubic in involute.cubics(NEAR) {
        let Intersections::Points(points) = with(&cubic) else { return Intersections::Coincident };
        for crossing in points {
            let nearest = involute.nearest(crossing.point);
            let found = Crossing { point: nearest.point, t: nearest.t, u: crossing.u };
            // Cubics that join both find what is where they do.
            let known = crossings.iter().any(|other| {
                other.point.distance(found.point) <= 10.0 * END_SLACK
                    && (other.u - found.u).abs() < 1e-3
            });
            if !known {
                crossings.push(found);
            }
        }
    }
    Intersections::sorted(crossings)
}
