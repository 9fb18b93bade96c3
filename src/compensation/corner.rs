//! Solving a corner: which transition two runs take, and how it comes out.

use std::f64::consts::PI;

use glam::DVec2;

use super::beyond::{conic, run_on};
use super::run::Run;
use super::transition::{
    CornerFrame, Flank, Place, Shortening, Solution, Terminal, elongated, inserted, shortened,
};
use super::type_points::{leg_meets_arc, parameter_beyond};
use super::{CornerStyle, Options};
use crate::contour::{Corner, CornerKind, MoveCurve, Tool, TransitionKind};
use crate::geometry::in_range;

/// Turns this near to ±180° may count as reversals [rad], however wide the tangent band is: a wider
/// one would take slender inside corners for spikes.
const MAX_REVERSAL_BAND: f64 = 0.01;

/// Turns this near to ±180° are reversals but for rounding [rad]: flanks of 100 mm are a tenth of a
/// thousandth of a micrometre apart.
const ROUNDED_REVERSAL: f64 = 1e-9;

/// Flanks that leave a corner at less than this may cross again near it [rad].
const THIN: f64 = 0.5;

/// Deepest that the flanks of a corner may cross near it and count as parted there already, as a
/// part of the tolerance.
const LENS_SHARE: f64 = 0.6;

/// How far beyond V the textbook's intersection of leg and circle may lie, as a multiple of the
/// way from the corner to V; farther off the circle only meets the leg elsewhere.
const LEG_REACH: f64 = 2.0;

/// What a corner came to.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Solved {
    /// Tangent: the outgoing offset starts where the incoming ends.
    Tangent,
    /// A transition.
    Transition {
        kind: TransitionKind,
        angle: f64,
        solution: Solution,
        /// Whether the offsets of an inside corner do not meet.
        missed: bool,
    },
}

/// The corner between two runs.
pub(super) fn corner_between(incoming: &Run, outgoing: &Run) -> Corner {
    Corner {
        point: incoming.segment.curve.end(),
        incoming: incoming.tangents[1],
        outgoing: outgoing.tangents[0],
        incoming_curvature: incoming.curvatures[1],
        outgoing_curvature: outgoing.curvatures[0],
    }
}

/// Classifies a corner.
pub(super) fn classify(corner: &Corner, tool: Tool, options: &Options) -> CornerKind {
    classify_with(corner, tool, options, MAX_REVERSAL_BAND)
}

/// Classifies a corner of a contour that is looked at as a whole: what comes out of a slit or a
/// spike is cut where the tool does not fit, so the thinnest are taken as they are. The second value
/// is the depth up to which the flanks do not keep to that [mm].
///
/// Flanks that leave the corner at a small angle θ may bend together by κ = κ1 + κ2 and cross
/// again. So far behind the corner as s they are `θs − κs²/2` apart: at most `θ²/2κ`, and they cross
/// at `s = 2θ/κ`. Where that is nothing, and both are as long as `length` [mm] at least, the bend tells
/// a spike from a slit.
pub(super) fn classify_sharply(
    corner: &Corner,
    length: f64,
    tool: Tool,
    options: &Options,
) -> (CornerKind, f64) {
    if corner.incoming.dot(corner.outgoing) < 0.0 {
        let turn = corner.turn();
        let opening = PI - turn.abs();
        // A left turn opens to the left, and flanks that bend to the left then close.
        let bend = (corner.incoming_curvature + corner.outgoing_curvature) * turn.signum();
        let depth = 0.5 * opening * opening / bend;
        let closes = opening < THIN && 2.0 * opening < bend * length;
        if closes && depth <= LENS_SHARE * options.usable_tolerance() {
            return (corner.kind(tool.side(), THIN), depth);
        }
    }
    (classify_with(corner, tool, options, ROUNDED_REVERSAL), 0.0)
}

fn classify_with(corner: &Corner, tool: Tool, options: &Options, most: f64) -> CornerKind {
    let band = options.band(tool.radius());
    match corner.kind(tool.side(), band) {
        CornerKind::Tangent => CornerKind::Tangent,
        CornerKind::Transition { .. } => corner.kind(tool.side(), band.min(most)),
    }
}

/// Solves the corner between two runs; `same` tells that both are one run, closed on itself.
pub(super) fn solve(
    incoming: &Run,
    outgoing: &Run,
    tool: Tool,
    options: &Options,
    same: bool,
) -> Solved {
    let corner = corner_between(incoming, outgoing);
    let CornerKind::Transition { kind, angle } = classify(&corner, tool, options) else {
        return Solved::Tangent;
    };
    let frame = CornerFrame::new(&corner, tool);
    let solved = |solution, missed| Solved::Transition { kind, angle, solution, missed };
    let style = options.corner_of(&outgoing.segment.attributes);
    match (kind, style) {
        (TransitionKind::Shortened, _) => {
            let (leg_in, leg_out) = (leg_of(incoming, 1), leg_of(outgoing, 0));
            let shortening = shortened(
                &frame,
                flank_of(incoming, leg_in.as_ref()),
                flank_of(outgoing, leg_out.as_ref()),
                tool,
                same,
            );
            match shortening {
                Shortening::Met(solution) => solved(solution, false),
                Shortening::Missed(solution) => solved(solution, true),
            }
        }
        (TransitionKind::Elongated, CornerStyle::Linear) => {
            let solution = elongated_on_circle(incoming, outgoing, &frame).unwrap_or_else(|| {
                let leg = |run: &Run| run.is_straight() || run.polygon.is_some();
                elongated(&frame, leg(incoming), leg(outgoing))
            });
            solved(solution, false)
        }
        (TransitionKind::Inserted, CornerStyle::Linear) => {
            let solution = inserted(&frame, incoming.is_straight(), outgoing.is_straight());
            solved(solution, false)
        }
        (_, CornerStyle::Intersection | CornerStyle::Conic(100..)) => {
            let solution = run_on(incoming, outgoing, &frame, corner.turn());
            solved(solution.unwrap_or_else(|| round_the_corner(&frame, tool)), false)
        }
        (_, CornerStyle::Arc) => solved(round_the_corner(&frame, tool), false),
        (_, CornerStyle::Conic(disc)) => {
            let solution = round_by_conic(&frame, corner.turn(), disc, tool, options);
            solved(solution, false)
        }
    }
}

/// The solution of an outside corner with an arc about it.
pub(super) fn round_the_corner(frame: &CornerFrame, tool: Tool) -> Solution {
    Solution {
        incoming: Terminal::Whole,
        outgoing: Terminal::Whole,
        inserted: frame.corner_arc(tool).into_iter().collect(),
        construction: frame.construction(),
    }
}

/// The solution of an outside corner with a conic between both offsets, or an arc where that is
/// too sharp.
pub(super) fn round_by_conic(
    frame: &CornerFrame,
    turn: f64,
    disc: u8,
    tool: Tool,
    options: &Options,
) -> Solution {
    let mut solution = round_the_corner(frame, tool);
    if let Some(moves) = conic(frame, turn, disc, options.usable_tolerance()) {
        solution.construction.push(("V", frame.v()));
        solution.inserted = moves;
    }
    solution
}

/// The equidistant of the polygon's leg at an end, as one piece.
fn leg_of(run: &Run, end: usize) -> Option<[MoveCurve; 1]> {
    Some([MoveCurve::Line(run.polygon?.leg(end)?)])
}

/// A run as an inside corner sees it: its offset, or the leg's where type points are moved.
fn flank_of<'a>(run: &'a Run, leg: Option<&'a [MoveCurve; 1]>) -> Flank<'a> {
    match leg {
        Some(leg) => Flank { pieces: leg, straight: true },
        None => Flank { pieces: &run.pieces, straight: run.is_straight() },
    }
}

/// The textbook's elongated corner of an arc and a spline: the arc's concentric circle runs on to
/// the equidistant of the leg ("Tool radius compensation algorithm of spline curve", 2.3.2).
fn elongated_on_circle(incoming: &Run, outgoing: &Run, frame: &CornerFrame) -> Option<Solution> {
    let v = frame.v();
    let near = |point: DVec2| {
        point.distance(frame.p) <= LEG_REACH * v.distance(frame.p) && in_range(point)
    };
    let solution = |incoming, outgoing, point| {
        let mut construction = frame.construction();
        construction.push(("V", point));
        Solution { incoming, outgoing, inserted: Vec::new(), construction }
    };
    match (&incoming.polygon, &outgoing.polygon) {
        (None, Some(polygon)) => {
            let [MoveCurve::Arc(arc)] = incoming.pieces.as_slice() else { return None };
            let point = leg_meets_arc(&polygon.leg(0)?, arc, v).filter(|&p| near(p))?;
            let place = Place { piece: 0, t: parameter_beyond(arc, point, 1) };
            Some(solution(Terminal::At(place), Terminal::To(point), point))
        }
        (Some(polygon), None) => {
            let [MoveCurve::Arc(arc)] = outgoing.pieces.as_slice() else { return None };
            let point = leg_meets_arc(&polygon.leg(1)?, arc, v).filter(|&p| near(p))?;
            let place = Place { piece: 0, t: parameter_beyond(arc, point, 0) };
            Some(solution(Terminal::To(point), Terminal::At(place), point))
        }
        _ => None,
    }
}
