//! A path of arcs and lines, for those who have no use for cubics.
//!
//! The offsets of splines are cubics first, each proved to be within half of the tolerance of the
//! true offset. Runs of them are then followed by arcs and lines, proved to be within the other half
//! of the cubics, so the two halves add up to the tolerance.

use crate::contour::{Move, MoveCurve, ToolPath};
use crate::geometry::{ArcOrLine, Cubic, Line, MIN_LENGTH, fit_arcs};

/// Part of the tolerance for the arcs; the rest is for the cubics that they follow.
pub(super) const ARC_SHARE: f64 = 0.5;

/// Part of the tolerance of the arcs that the cubics along an involute may be off by.
const INVOLUTE_SHARE: f64 = 0.1;

/// Follows the cubics and involutes of a path by arcs and lines within `tolerance` [mm].
pub(super) fn as_arcs(path: &mut ToolPath, tolerance: f64) {
    let is_cubic = |step: &Move| matches!(step.curve, MoveCurve::Cubic(_) | MoveCurve::Involute(_));
    if !path.moves.iter().any(is_cubic) {
        return;
    }
    let cubics = std::mem::take(&mut path.moves);
    // Where a run must not go on: something happens there, or another loop begins.
    let mut breaks = vec![false; cubics.len() + 1];
    for words in &path.words {
        breaks[words.before.min(cubics.len())] = true;
    }
    for one in &path.loops {
        breaks[one.first_move] = true;
    }
    // The new index of each move, and of the end.
    let mut indices = Vec::with_capacity(cubics.len() + 1);
    let mut i = 0;
    while i < cubics.len() {
        indices.push(path.moves.len());
        let first = cubics[i];
        if let MoveCurve::Involute(involute) = &first.curve {
            // It is exact, so its cubics may be off by some of the first half.
            let run = involute.cubics(INVOLUTE_SHARE * tolerance);
            follow(&run, first, first.heights, tolerance, &mut path.moves);
            i += 1;
            continue;
        }
        let run = run_of(&cubics, i, &breaks);
        if run.is_empty() {
            path.moves.push(first);
            i += 1;
            continue;
        }
        let rise = [first.heights[0], cubics[i + run.len() - 1].heights[1]];
        follow(&run, first, rise, tolerance, &mut path.moves);
        indices.resize(indices.len() + run.len() - 1, path.moves.len());
        i += run.len();
    }
    indices.push(path.moves.len());
    for words in &mut path.words {
        words.before = indices[words.before.min(cubics.len())];
    }
    for one in &mut path.loops {
        one.first_move = indices[one.first_move];
        one.moves_end = indices[one.moves_end];
    }
}

/// The cubics from move `from` on that arcs may follow as one run: they carry the same, and none
/// but the first is behind a break.
fn run_of(moves: &[Move], from: usize, breaks: &[bool]) -> Vec<Cubic> {
    let mut run: Vec<Cubic> = Vec::new();
    let first = moves[from];
    for (i, step) in moves.iter().enumerate().skip(from) {
        let MoveCurve::Cubic(cubic) = step.curve else { break };
        if let Some(last) = run.last() {
            let level = first.heights == step.heights && step.heights[0] == step.heights[1];
            let alike = Move { curve: first.curve, heights: first.heights, ..*step } == first;
            if !level || !alike || breaks[i] || last.end().distance(cubic.start()) > MIN_LENGTH {
                break;
            }
        }
        run.push(cubic);
    }
    run
}

/// Appends arcs and lines along a run, which carry what `like` carries.
fn follow(run: &[Cubic], like: Move, [from, to]: [f64; 2], tolerance: f64, moves: &mut Vec<Move>) {
    let mut curves = Vec::new();
    let mut at = run[0].start();
    for piece in fit_arcs(run, tolerance) {
        let curve = match piece {
            ArcOrLine::Arc(arc) => MoveCurve::Arc(arc),
            ArcOrLine::Line(line) => MoveCurve::Line(line),
        };
        at = curve.end();
        curves.push(curve);
    }
    let end = run[run.len() - 1].end();
    // A cubic that comes to a point, and whatever rounding left over.
    if at.distance(end) > MIN_LENGTH {
        curves.extend(Line::new(at, end).map(MoveCurve::Line));
    }
    let total: f64 = curves.iter().map(MoveCurve::length).sum();
    let (mut length, mut height) = (0.0, from);
    let last = curves.len();
    for (k, curve) in curves.into_iter().enumerate() {
        length += curve.length();
        let next = if k + 1 == last { to } else { from + (to - from) * length / total };
        moves.push(Move { curve, heights: [height, next], ..like });
        height = next;
    }
}
