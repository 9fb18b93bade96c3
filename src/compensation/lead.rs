//! Lead-in and lead-out: the straight moves that switch compensation on and off.
//!
//! "Tool radius compensation algorithm of spline curve", 2.4. Round an outside corner the lead-in
//! ends beside its own end, at `N1 = P + r n1`, and the corner follows as any other; into an inside
//! corner it goes straight to `N2 = P + r n2`, beside the start of the contour. The lead-out is the
//! same thing backwards.

use glam::DVec2;

use super::beyond::is_too_sharp;
use super::corner::{
    Solved, classify, corner_between, round_by_conic, round_the_corner, solve as solve_corner,
};
use super::run::Run;
use super::transition::{CornerFrame, Solution, Terminal, elongated, inserted, polyline};
use super::{CornerStyle, LeadStyle, Options};
use crate::contour::{
    Attributes, Corner, CornerKind, LeadWish, Role, Segment, Tool, TransitionKind, Wish,
};
use crate::geometry::{Curve, Line, direction, in_range};

/// How far a wall reaches [mm]: beyond all that a tool could meet.
const WALL: f64 = 1e6;

/// How a lead and the contour are joined.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct LeadSolution {
    /// Where the lead meets what it leads to or from [mm].
    pub(super) end: DVec2,
    /// The kind and angle of the corner, unless it is tangent or there is none.
    pub(super) corner: Option<(TransitionKind, f64)>,
    /// Moves between lead and contour, and the terminal of the contour.
    pub(super) solution: Solution,
    /// What these moves are.
    pub(super) role: Role,
}

/// The lead-in from `from` to the start of `outgoing`, as its program wishes.
pub(super) fn lead_in(
    from: DVec2,
    wish: LeadWish,
    outgoing: &Run,
    tool: Tool,
    options: &Options,
) -> LeadSolution {
    let options = &Options { lead: options.lead_of(wish), ..*options };
    let point = outgoing.segment.curve.start();
    let corner = direction(point - from).map(|along| Corner {
        point,
        incoming: along,
        outgoing: outgoing.tangents[0],
        incoming_curvature: 0.0,
        outgoing_curvature: outgoing.curvatures[0],
    });
    let lead = solve(corner, outgoing.ends[0], [None, Some(outgoing)], tool, options);
    if options.lead != LeadStyle::ExtraMove {
        return lead;
    }
    let moves = [point, lead.end];
    by_extra_move(lead, point, moves, Role::LeadIn)
}

/// The lead-out from the end of `incoming` to `to`, as its program wishes, maybe from where the path
/// meets that along a wall.
pub(super) fn lead_out(
    incoming: &Run,
    to: DVec2,
    wall: Option<DVec2>,
    wish: LeadWish,
    tool: Tool,
    options: &Options,
) -> LeadSolution {
    if let Some(wall) = wall
        && let Some(lead) = from_wall(incoming, wall, tool, options)
    {
        return lead;
    }
    let options = &Options { lead: options.lead_of(wish), ..*options };
    let point = incoming.segment.curve.end();
    let corner = direction(to - point).map(|along| Corner {
        point,
        incoming: incoming.tangents[1],
        outgoing: along,
        incoming_curvature: incoming.curvatures[1],
        outgoing_curvature: 0.0,
    });
    let lead = solve(corner, incoming.ends[1], [Some(incoming), None], tool, options);
    if options.lead != LeadStyle::ExtraMove {
        return lead;
    }
    let moves = [lead.end, point];
    by_extra_move(lead, point, moves, Role::LeadOut)
}

/// A lead-out from where the path meets that along a wall; `None` where they do not meet.
fn from_wall(incoming: &Run, wall: DVec2, tool: Tool, options: &Options) -> Option<LeadSolution> {
    let from = incoming.segment.curve.end();
    let line = Line::new(from, from + wall.try_normalize()? * WALL).ok()?;
    let attributes = Attributes { wish: Wish::default(), ..incoming.segment.attributes };
    let segment = Segment { curve: Curve::Line(line), attributes };
    let options = &Options { corner: CornerStyle::Intersection, ..*options };
    let beyond = Run::new(&segment, tool, options);
    let solved = solve_corner(incoming, &beyond, tool, options, false);
    let Solved::Transition { kind, angle, mut solution, missed: false } = solved else {
        return None;
    };
    let frame = CornerFrame::new(&corner_between(incoming, &beyond), tool);
    if kind != TransitionKind::Shortened && incoming.is_straight() && in_range(frame.v()) {
        // However sharp the corner.
        solution = elongated(&frame, true, true);
    }
    let end = solution.construction.iter().find(|(name, _)| *name == "V")?.1;
    solution.outgoing = Terminal::Whole;
    Some(LeadSolution { end, corner: Some((kind, angle)), solution, role: Role::Transition })
}

/// A lead that ends on the contour, with a move at right angles between there and beside it.
fn by_extra_move(lead: LeadSolution, end: DVec2, moves: [DVec2; 2], role: Role) -> LeadSolution {
    let solution = Solution { inserted: polyline(&moves), ..lead.solution };
    LeadSolution { end, solution, role, ..lead }
}

/// The corner between a lead and the contour, whose run is given on its side and ends at `beside`.
/// There is no corner where compensation is switched without a move: nothing gives a direction.
fn solve(
    corner: Option<Corner>,
    beside: DVec2,
    runs: [Option<&Run>; 2],
    tool: Tool,
    options: &Options,
) -> LeadSolution {
    let role = Role::Transition;
    let mut lead = LeadSolution { end: beside, corner: None, solution: whole(Vec::new()), role };
    let Some(corner) = corner else { return lead };
    let CornerKind::Transition { kind, angle } = classify(&corner, tool, options) else {
        return lead;
    };
    let frame = CornerFrame::new(&corner, tool);
    lead.corner = Some((kind, angle));
    if options.lead.goes_round() && kind != TransitionKind::Shortened {
        // The lead ends beside its own end.
        lead.end = if runs[0].is_none() { frame.n1 } else { frame.n2 };
        lead.solution = around_corner(kind, corner.turn(), &frame, runs, tool, options);
    } else {
        lead.solution = whole(frame.construction());
    }
    lead
}

/// Round an outside corner; the lead itself is not run on, as it does not lie beside its line.
fn around_corner(
    kind: TransitionKind,
    turn: f64,
    frame: &CornerFrame,
    [incoming, outgoing]: [Option<&Run>; 2],
    tool: Tool,
    options: &Options,
) -> Solution {
    // Words that choose it hold for the contour beside the lead.
    let beside = outgoing.or(incoming);
    let style = beside.map_or(options.corner, |run| options.corner_of(&run.segment.attributes));
    match (style, kind) {
        (CornerStyle::Arc, _) => round_the_corner(frame, tool),
        (CornerStyle::Conic(disc), _) => round_by_conic(frame, turn, disc, tool, options),
        (CornerStyle::Intersection, _) if is_too_sharp(turn) => round_the_corner(frame, tool),
        (CornerStyle::Linear, TransitionKind::Inserted) => {
            let is_straight = Run::is_straight;
            inserted(frame, incoming.is_some_and(is_straight), outgoing.is_some_and(is_straight))
        }
        (CornerStyle::Linear | CornerStyle::Intersection, _) => {
            // A spline through moved type points itself begins or ends at V.
            let leg = |run: &Run| run.is_straight() || run.polygon.is_some();
            elongated(frame, incoming.is_some_and(leg), outgoing.is_some_and(leg))
        }
    }
}

fn whole(construction: Vec<(&'static str, DVec2)>) -> Solution {
    Solution {
        incoming: Terminal::Whole,
        outgoing: Terminal::Whole,
        inserted: Vec::new(),
        construction,
    }
}
