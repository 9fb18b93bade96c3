//! The offset of an arc: a concentric one.

use std::f64::consts::PI;

use super::Bend;
use crate::geometry::{Arc, MIN_LENGTH, sin_cos};

/// What the offset of an arc can be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::compensation) enum ArcOffset {
    /// A concentric arc of the same sense.
    Arc(Arc),
    /// The centre alone: the tool just fits into the arc.
    Point,
    /// An arc on the far side of the centre, run against the programmed direction: the tool does
    /// not fit.
    Reversed(Arc, Bend),
}

/// The arc offset by `offset` [mm] to its left.
pub(in crate::compensation) fn offset_arc(arc: &Arc, offset: f64) -> ArcOffset {
    // 1 − δκ: the centre is on the left of an arc that turns left.
    let factor = 1.0 - offset * arc.curvature();
    let start = arc.center() + (arc.start() - arc.center()) * factor;
    let end = arc.center() + (arc.end() - arc.center()) * factor;
    let concentric = if arc.is_full_circle() {
        Arc::from_sweep(start, arc.center(), arc.sweep())
    } else if start.distance(end) < MIN_LENGTH {
        return ArcOffset::Point;
    } else {
        Arc::from_center(start, end, arc.center(), arc.is_clockwise(), f64::INFINITY)
    };
    match concentric {
        Err(_) => ArcOffset::Point,
        Ok(offset_arc) if factor >= 0.0 => ArcOffset::Arc(offset_arc),
        Ok(offset_arc) => ArcOffset::Reversed(offset_arc, bend(arc, &offset_arc, offset.abs())),
    }
}

/// How deep a tool of radius `r` cuts that does not fit into the arc.
///
/// Its centre runs on a circle of radius `ρ = r − R` opposite to the point it should touch. The
/// point of the arc nearest to any of its places is an end, as seen from beside the other end: at
/// the angle `max(0, π − sweep)` about the centre, so by the law of cosines at the distance
/// `√(R² + ρ² − 2 R ρ cos)`.
fn bend(arc: &Arc, offset_arc: &Arc, r: f64) -> Bend {
    let (radius, rho) = (arc.radius(), r - arc.radius());
    let angle = (PI - arc.sweep().abs()).max(0.0);
    let squared = radius * radius + rho * rho - 2.0 * radius * rho * sin_cos(angle).1;
    let depth = r - squared.max(0.0).sqrt();
    Bend { at: arc.end(), center: offset_arc.start(), depth, radius }
}
