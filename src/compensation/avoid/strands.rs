//! The raw material: whole offsets and outside corners, before anything is cut.
//!
//! Every place that a tool beside the contour can take, touching it, lies on the whole offset of
//! some segment or on the way round some outside corner. At an inside corner the two offsets cross;
//! no way round it exists, so the strand breaks there.

use crate::compensation::corner::{Solved, solve};
use crate::compensation::run::Run;
use crate::compensation::transition::{Solution, Terminal};
use crate::compensation::{CornerStyle, Options};
use crate::contour::{MoveCurve, Role, Tool, TransitionKind};
use crate::geometry::{Arc, MIN_LENGTH};

/// One piece of raw path.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    pub(super) curve: MoveCurve,
    pub(super) role: Role,
    /// Index of the run it belongs to, or leads to.
    pub(super) run: usize,
    /// Where the tool touches its segment: everywhere along it, or, round a corner, at this
    /// parameter.
    pub(super) touches: Option<f64>,
    /// Whether the piece after it starts where it ends.
    pub(super) continues: bool,
}

/// Outside corners between contour and leads: their moves, and how the contour's offset starts and
/// ends there.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Leads<'a> {
    pub(super) lead_in: Option<&'a Solution>,
    pub(super) lead_out: Option<&'a Solution>,
}

/// The raw pieces of `runs` in program order.
pub(super) fn strands(
    runs: &[Run],
    closed: bool,
    leads: Leads,
    tool: Tool,
    options: &Options,
) -> Vec<Piece> {
    let last = runs.len() - 1;
    let corner = |i: usize, j: usize| solve(&runs[i], &runs[j], tool, options, i == j);
    let corners: Vec<Option<Solved>> = (0..runs.len())
        .map(|i| if i < last { Some(corner(i, i + 1)) } else { closed.then(|| corner(i, 0)) })
        .collect();
    let around = |i: usize| corners[i].as_ref().and_then(outside);
    let mut pieces: Vec<Piece> = Vec::new();
    let mut add = |curves: &[MoveCurve], run, touches: Option<f64>| {
        let role = if touches.is_some() { Role::Transition } else { Role::Segment };
        let piece = |&curve| Piece { curve, role, run, touches, continues: false };
        pieces.extend(curves.iter().map(piece));
    };
    if let Some(solution) = leads.lead_in {
        add(&solution.inserted, 0, Some(0.0));
    }
    for (i, run) in runs.iter().enumerate() {
        let before = if i > 0 { Some(i - 1) } else { closed.then_some(last) };
        let start = match before {
            Some(b) if matches!(corners[b], Some(Solved::Tangent)) => {
                Terminal::Moved(runs[b].ends[1])
            }
            Some(b) => around(b).map_or(Terminal::Whole, |solution| solution.outgoing),
            None => leads.lead_in.map_or(Terminal::Whole, |solution| solution.outgoing),
        };
        let solution = if i == last && !closed { leads.lead_out } else { around(i) };
        let end = solution.map_or(Terminal::Whole, |solution| solution.incoming);
        let (moves, _) = run.between(start, end);
        add(&moves, i, None);
        if let Some(solution) = solution {
            add(&solution.inserted, i, Some(1.0));
        }
    }
    // Where the next piece starts elsewhere, at inside corners and at the end, the strand breaks.
    let count = pieces.len();
    for i in 0..count {
        let next = if i + 1 < count { Some(i + 1) } else { closed.then_some(0) };
        let end = pieces[i].curve.end();
        let joins = |n: usize| pieces[n].curve.start().distance(end) <= 2.0 * MIN_LENGTH;
        pieces[i].continues = next.is_some_and(joins);
    }
    pieces
}

/// The solution of an outside corner.
fn outside(solved: &Solved) -> Option<&Solution> {
    match solved {
        Solved::Transition {
            kind: TransitionKind::Elongated | TransitionKind::Inserted,
            solution,
            ..
        } => Some(solution),
        Solved::Transition { .. } | Solved::Tangent => None,
    }
}

/// Curves beyond which a tool beside the contour comes too near to its other side or to its free
/// ends: they cut the raw pieces, but the tool never follows them.
pub(super) fn fences(runs: &[Run], closed: bool, tool: Tool, options: &Options) -> Vec<MoveCurve> {
    let Some(other) = Tool::new(tool.radius(), tool.side().opposite()) else { return Vec::new() };
    let around = Options { corner: CornerStyle::Arc, ..*options };
    let mirrored: Vec<Run> = runs.iter().map(|run| Run::new(run.segment, other, &around)).collect();
    let mut fences: Vec<MoveCurve> = strands(&mirrored, closed, Leads::default(), other, &around)
        .into_iter()
        .map(|piece| piece.curve)
        .collect();
    if !closed {
        for (run, end) in [(&runs[0], 0), (&runs[runs.len() - 1], 1)] {
            let at = run.segment.curve.point(end as f64);
            let cap = Arc::from_sweep(run.ends[end], at, std::f64::consts::TAU);
            fences.extend(cap.ok().map(MoveCurve::Arc));
        }
    }
    fences
}
