//! Where a tool does not fit beside an involute: near the base circle, on the side of its centre of
//! curvature.

use super::Bend;
use crate::geometry::{Involute, least, perp};

/// Steps of the search for the deepest place: each keeps 0.618 of the stretch.
const STEPS: usize = 40;

/// The stretch that bends tighter than a tool at `offset` [mm] to the left, if there is one.
///
/// The radius of curvature is the length of the thread, so it is the inner part of the curve.
pub(in crate::compensation) fn involute_bend(involute: &Involute, offset: f64) -> Option<Bend> {
    let inner = if involute.is_outward() { 0.0 } else { 1.0 };
    let curvature = involute.curvature(inner);
    if offset * curvature <= 1.0 {
        return None;
    }
    // Up to where the thread is as long as the offset.
    let [from, to] = involute.rolls();
    let roll = offset.abs() / involute.base_radius();
    let share = ((roll - from) / (to - from)).clamp(0.0, 1.0);
    let range = if inner == 0.0 { [0.0, share] } else { [share, 1.0] };
    let center = |share: f64| {
        let t = involute.length_share(share);
        involute.point(t) + perp(involute.tangent(t)) * offset
    };
    let deepest = least(range, STEPS, 0.0, &mut |share| involute.nearest(center(share)).distance);
    let center = center(deepest);
    let nearest = involute.nearest(center);
    let depth = offset.abs() - nearest.distance;
    Some(Bend { at: nearest.point, center, depth, radius: 1.0 / curvature.abs() })
}
