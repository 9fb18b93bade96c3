//! Involute and any other curve.
//!
//! Parts of the involute that turn little are held against the box around the other curve. Of those
//! that reach it, cubics nearer than [`END_SLACK`] are held against the curve itself. What they share
//! with it is brought onto the involute by its foot there, which is known in closed form.

use super::{Crossing, END_SLACK, Intersections};
use crate::geometry::{Bounds, Cubic, Involute};

/// How near the cubics are [mm]: a part of the slack, so that what counts as on both is on both.
const NEAR: f64 = 0.1 * END_SLACK;

/// Turn of a part that is cut no further [rad]: some twenty cubics of an ordinary gear.
const SHORT: f64 = 0.1;

/// Where an involute crosses a curve, which has `other` around it, and of which `with` tells where it
/// crosses a cubic (the first curve).
#[must_use]
pub fn involute_with(
    involute: &Involute,
    other: &Bounds,
    with: &dyn Fn(&Cubic) -> Intersections,
) -> Intersections {
    let other = other.inflated(END_SLACK);
    let mut crossings: Vec<Crossing> = Vec::new();
    let mut parts = vec![*involute];
    while let Some(part) = parts.pop() {
        if !part.bounds().meets(&other) {
            continue;
        }
        if part.turn().abs() > SHORT {
            let middle = part.length_share(0.5);
            parts.extend(part.part(0.0, middle));
            parts.extend(part.part(middle, 1.0));
            continue;
        }
        for cubic in part.cubics(NEAR) {
            if !cubic.hull_bounds().meets(&other) {
                continue;
            }
            let Intersections::Points(points) = with(&cubic) else {
                return Intersections::Coincident;
            };
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
    }
    Intersections::sorted(crossings)
}
