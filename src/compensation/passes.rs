//! Clearing a pocket: paths beside each other, each farther from the contour than the one before.
//!
//! On the way from any place to the wall nearest to it there is a pass within the stepover, so with a
//! stepover of at most the tool radius nothing within reach is left; with a wider one ridges may be.
//! Every pass is offset from the contour itself, so errors do not add up. A pass may fall into
//! several loops; each lies inside one loop of the pass before, and they are run room by room: where
//! a pocket falls into rooms, the tool crosses from one to the next once and not with every pass. Inside
//! a room it stays down where it can.

use glam::DVec2;

use super::avoid::avoid_all;
use super::links::Links;
use super::{Options, Passes};
use crate::contour::{Contour, MoveCurve, PathLoop, Tool, ToolPath};
use crate::diagnostic::Diagnostic;
use crate::geometry::{Bounds, cross};

/// Most passes; more than any machine has the time for.
const MOST: u32 = 10_000;

/// Chords of an outline that only tells inside from outside, as a part of the tool radius.
const COARSE: f64 = 0.01;

/// Farthest that two moves of one loop may be apart [mm].
pub(super) const GAP: f64 = 1e-6;

/// All passes along `jobs`, loop by loop.
pub(super) fn pocket(jobs: &[(&Contour, Tool)], options: &Options) -> ToolPath {
    // The tool is led to and from the first pass only.
    let inner: Vec<(Contour, Tool)> =
        jobs.iter().map(|&(contour, tool)| (contour.without_leads(), tool)).collect();
    with_passes(avoid_all(jobs, options), &inner, options)
}

/// The first pass as it was made, and the others along the contours `inner`.
pub(super) fn with_passes(
    first: ToolPath,
    inner: &[(Contour, Tool)],
    options: &Options,
) -> ToolPath {
    let (count, stepover) = match options.passes {
        Passes::One => (1, 0.0),
        Passes::Several { count, stepover } => (count.clamp(1, MOST), stepover),
        Passes::All { stepover } => (MOST, stepover),
    };
    let mut path = first;
    add_loops(&mut path, 0, 0);
    if matches!(options.passes, Passes::All { .. }) && !inner.iter().any(is_pocket) {
        path.diagnostics.push(
            Diagnostic::error("no-pocket", "passes without end: no contour closes round the tool")
                .with_point(inner[0].0.start())
                .with_hint("ask for a number of passes, or close the contour"),
        );
        return path;
    }
    if stepover > inner[0].1.radius() {
        path.diagnostics.push(
            Diagnostic::info("wide-stepover", "a stepover above the tool radius may leave ridges")
                .with_point(inner[0].0.start()),
        );
    }
    let mut before = 0;
    for pass in 1..count {
        if path.moves.is_empty() || stepover <= 0.0 {
            break;
        }
        let wider = |contour, tool: &Tool| {
            let radius = tool.radius() + f64::from(pass) * stepover;
            Some((contour, Tool::new(radius, tool.side())?))
        };
        let Some(wider) =
            inner.iter().map(|(contour, tool)| wider(contour, tool)).collect::<Option<Vec<_>>>()
        else {
            break;
        };
        let mut next = avoid_all(&wider, options);
        if next.moves.is_empty() {
            break;
        }
        // What the first pass says about the contour holds for all; the others leave nothing of it.
        next.diagnostics.clear();
        next.transitions.clear();
        next.words.clear();
        next.uncut.clear();
        let first_loop = path.loops.len();
        path.append(next);
        add_loops(&mut path, pass, before);
        before = first_loop;
    }
    room_by_room(&mut path, &Links { inner, options, stepover });
    path
}

/// Runs what lies in a loop right behind that loop, linked to it where the tool can stay down.
fn room_by_room(path: &mut ToolPath, links: &Links<'_>) {
    const NONE: usize = usize::MAX;
    let count = path.loops.len();
    // The first loop in each, and at the end the first that is in none; and the next one in the same.
    let (mut inside, mut next) = (vec![NONE; count + 1], vec![NONE; count]);
    for (index, one) in path.loops.iter().enumerate().rev() {
        let first = &mut inside[one.parent.unwrap_or(count)];
        next[index] = std::mem::replace(first, index);
    }
    let moves = std::mem::take(&mut path.moves);
    let loops = std::mem::take(&mut path.loops);
    path.moves.reserve(moves.len());
    // Where each loop went, for those that lie in it.
    let mut placed = vec![NONE; count];
    let mut waiting = vec![inside[count]];
    while let Some(index) = waiting.pop() {
        let Some(one) = loops.get(index) else { continue };
        placed[index] = path.loops.len();
        let own = &moves[one.first_move..one.moves_end];
        let parent = one.parent.map(|parent| placed[parent]);
        let follows = parent.is_some_and(|parent| parent + 1 == path.loops.len());
        let mut first_move = path.moves.len();
        if follows && links.link(&mut path.moves, one.pass, own) {
            // The link is part of neither loop.
            first_move += 1;
        } else {
            path.moves.extend_from_slice(own);
        }
        path.loops.push(PathLoop { first_move, moves_end: path.moves.len(), parent, ..*one });
        waiting.extend([next[index], inside[index]]);
    }
    // Words stay behind the move that they follow; only the first pass has any.
    for words in &mut path.words {
        let index = loops.partition_point(|one| one.moves_end < words.before);
        if let Some(one) = loops.get(index)
            && words.before > 0
        {
            let to = &path.loops[placed[index]];
            words.before = to.first_move + words.before - one.first_move;
        }
    }
}

/// Whether a contour closes round the tool beside it.
fn is_pocket((contour, tool): &(Contour, Tool)) -> bool {
    let mut area = 0.0;
    let origin = contour.start();
    let mut last = origin;
    for segment in contour.segments() {
        let mut add = |point: DVec2| {
            area += cross(last - origin, point - origin);
            last = point;
        };
        let coarse = COARSE * tool.radius().max(1e-3);
        segment.curve.flatten(coarse, &mut add);
    }
    contour.is_closed() && area * tool.offset() > 0.0
}

/// Names the loops among the moves behind those that have been named; `from` is the first loop of
/// the pass before.
fn add_loops(path: &mut ToolPath, pass: u32, from: usize) {
    let candidates = path.loops.len();
    let mut first = path.loops.last().map_or(0, |last| last.moves_end);
    while first < path.moves.len() {
        let mut end = first + 1;
        while end < path.moves.len()
            && path.moves[end - 1].curve.end().distance(path.moves[end].curve.start()) <= GAP
            && (path.moves[end - 1].curve.end().distance(path.moves[first].curve.start()) > GAP
                || end == first + 1 && path.moves[first].curve.length() <= GAP)
        {
            end += 1;
        }
        // Where one of them goes round a corner by straight moves and the other, for want of room, by
        // an arc, the loop of a later pass may bulge out of the one before.
        let parent = path.moves[first..end].iter().find_map(|one| {
            let at = one.curve.start();
            (from..candidates).find(|&index| pass > 0 && surrounds(path, &path.loops[index], at))
        });
        path.loops.push(PathLoop { first_move: first, moves_end: end, pass, parent });
        first = end;
    }
}

/// Whether a loop of the path lies round a point: how often a ray from there crosses it.
fn surrounds(path: &ToolPath, one: &PathLoop, point: DVec2) -> bool {
    let moves = &path.moves[one.first_move..one.moves_end];
    let curves = moves.iter().map(|one| &one.curve);
    let bounds = curves.clone().map(MoveCurve::hull_bounds).fold(Bounds::EMPTY, Bounds::union);
    if bounds.distance(point) > 0.0 {
        return false;
    }
    let coarse = 1e-3 * bounds.size().max_element();
    let mut inside = false;
    let mut last = moves[0].curve.start();
    for curve in curves {
        curve.flatten(coarse, &mut |next| {
            if (last.y > point.y) != (next.y > point.y) {
                let along = (point.y - last.y) / (next.y - last.y);
                if last.x + (next.x - last.x) * along > point.x {
                    inside = !inside;
                }
            }
            last = next;
        });
    }
    inside
}
