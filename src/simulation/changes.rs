//! Radius and side that change while compensation is on, as controls do it that have rules for it.
//!
//! FANUC: the block that first has the new radius starts beside its start with the old one, and ends
//! beside its end with the new one; where the side changes, the tool goes to where the paths on both
//! sides cross, or else straight from beside the end of the one block to beside the start of the
//! other.

use std::f64::consts::FRAC_PI_2;

use glam::DVec2;

use crate::contour::{Move, MoveCurve, Role};
use crate::diagnostic::Origin;
use crate::geometry::intersect::{circles, line_circle, lines_extended};
use crate::geometry::{Arc, Line};

/// Takes the last straight move from a path, of the block on which the radius changes; what is left
/// ends beside its start.
pub(super) fn leave_out_last(moves: &mut Vec<Move>, block: Origin) {
    let is_its = |last: &Move| {
        last.origin == block
            && last.role == Role::Segment
            && matches!(last.curve, MoveCurve::Line(_))
    };
    if moves.last().is_some_and(is_its) {
        moves.pop();
    }
}

/// Lets a straight move start elsewhere [mm].
pub(super) fn start_from(first: &mut Move, at: DVec2) {
    if let (MoveCurve::Line(line), Role::Segment) = (&first.curve, first.role)
        && let Ok(line) = Line::new(at, line.end())
    {
        first.curve = MoveCurve::Line(line);
    }
}

/// Lets two moves, on either side of the contour, end and start where they cross, lines run on
/// straight and arcs on their circles.
pub(super) fn cross_over(last: &mut Move, first: &mut Move) {
    if last.role != Role::Segment || first.role != Role::Segment || last.plane != first.plane {
        return;
    }
    let corner = 0.5 * (last.curve.end() + first.curve.start());
    let mut best: Option<DVec2> = None;
    for point in crossings(&last.curve, &first.curve) {
        if best.is_none_or(|best| point.distance(corner) < best.distance(corner)) {
            best = Some(point);
        }
    }
    let Some(point) = best else { return };
    let ends = between(&last.curve, last.curve.start(), point);
    let starts = between(&first.curve, point, first.curve.end());
    if let (Some(ends), Some(starts)) = (ends, starts) {
        (last.curve, first.curve) = (ends, starts);
    }
}

/// Where two moves that run on cross [mm].
fn crossings(a: &MoveCurve, b: &MoveCurve) -> Vec<DVec2> {
    match (a, b) {
        (MoveCurve::Line(a), MoveCurve::Line(b)) => {
            lines_extended(a, b).into_iter().map(|(t, _)| a.point(t)).collect()
        }
        (MoveCurve::Line(line), MoveCurve::Arc(arc))
        | (MoveCurve::Arc(arc), MoveCurve::Line(line)) => {
            let at = line_circle(line, arc.center(), arc.radius());
            at.into_iter().map(|t| line.point(t)).collect()
        }
        (MoveCurve::Arc(a), MoveCurve::Arc(b)) => circles(a, b).into_iter().flatten().collect(),
        _ => Vec::new(),
    }
}

/// The part of a move, or of what it runs on to, between two points on it; `None` where that is
/// another way.
fn between(curve: &MoveCurve, from: DVec2, to: DVec2) -> Option<MoveCurve> {
    match curve {
        MoveCurve::Line(line) => {
            let part = Line::new(from, to).ok()?;
            (part.vector().dot(line.vector()) > 0.0).then_some(MoveCurve::Line(part))
        }
        MoveCurve::Arc(arc) => {
            let tolerance = f64::INFINITY;
            let part = Arc::from_center(from, to, arc.center(), arc.is_clockwise(), tolerance);
            let part = part.ok()?;
            let differs = (part.sweep() - arc.sweep()).abs() > FRAC_PI_2;
            (!differs).then_some(MoveCurve::Arc(part))
        }
        _ => None,
    }
}
