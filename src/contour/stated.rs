//! Arcs as a program states them, though centre and ends are rounded.

use glam::DVec2;

use super::shape::RELATIVE_ARC_TOLERANCE;
use crate::geometry::{Arc, CurveError};

/// How many times the tolerance of stated arcs they may differ, however large the arc.
const MOST_TOLERANCES: f64 = 100.0;

/// How much the radius of an arc that is kept as it is stated may be less than half its chord, and
/// the least that its radii may be [mm]: 0.00005 inch, as `LinuxCNC` has it.
pub(super) const RADIUS_TOLERANCE: f64 = 0.000_05 * 25.4;

/// An arc with its centre and ends as they are stated.
pub(super) fn stated_arc(
    start: DVec2,
    end: DVec2,
    center: DVec2,
    clockwise: bool,
    tolerance: f64,
) -> Result<Arc, CurveError> {
    let radii = [start.distance(center), end.distance(center)];
    let (least, largest) = (radii[0].min(radii[1]), radii[0].max(radii[1]));
    let allowed = (RELATIVE_ARC_TOLERANCE * largest).clamp(tolerance, MOST_TOLERANCES * tolerance);
    if largest - least > allowed || least < RADIUS_TOLERANCE {
        return Err(CurveError::RadiiDisagree { start: radii[0], end: radii[1] });
    }
    Arc::winding(start, end, center, clockwise)
}
