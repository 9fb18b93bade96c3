//! A contour that is gone round the same way more than once, gouges avoided lap by lap.
//!
//! Programs finish at one depth after the other, or once more where a cutter springs back. Walls that
//! lie on each other are one wall, so each lap is looked at alone. The segments before and behind it are
//! followed too, for the corners between laps, and what was made for them is left out.

use std::ops::Range;

use crate::compensation::{Options, Output, compensate_beside};
use crate::contour::{Contour, Move, MoveCurve, Role, Segment, Side, Tool, ToolPath, Walls};
use crate::diagnostic::Origin;
use crate::geometry::{Curve, Line, MIN_LENGTH};
use crate::program::{ContourEnd, ContourStart, ProgrammedContour};

/// How far laps that are the same may be apart [mm]: what rounding makes of places that are counted from
/// each other.
const SAME: f64 = 1e-6;

/// Marks the segments beside a lap.
const BESIDE: Origin = Origin::Segment(u32::MAX);

/// The path along laps of which each goes the way of the first, gouges avoided; `None` where they do
/// not, or there is one alone.
pub(super) fn avoid_laps(
    programmed: &ProgrammedContour,
    tool: Tool,
    options: &Options,
) -> Option<ToolPath> {
    let contour = &programmed.contour;
    let segments = contour.segments();
    let is_whole = !programmed.leads_in
        && programmed.begins != ContourStart::Tapers
        && programmed.end != ContourEnd::Tapers
        && options.output == Output::Cubics;
    let (mut next, count) = is_whole.then(|| repeated(segments))??;
    let mut path = ToolPath::default();
    let mut from = 0;
    while from < segments.len() {
        let until = if segments.len() - next < count { segments.len() } else { next };
        let (along, walls) = with_neighbours(contour, from..until, tool.side());
        let mut own = compensate_beside(&along, walls, tool, options);
        leave_out_beside(&mut own);
        for event in if from > 0 { contour.events_at(from) } else { &[] } {
            path.happen(event, contour.start());
        }
        follow(&mut path, own, options.usable_tolerance());
        (from, next) = (until, until + count);
    }
    Some(path)
}

/// Whether a contour goes round itself more than once, the same way.
pub(super) fn has_laps(contour: &Contour) -> bool {
    repeated(contour.segments()).is_some()
}

/// Where the second of several laps begins, and of how many segments each is: all that runs in before
/// belongs to the first, and what runs out to the last. `None` where segments are not repeated.
fn repeated(segments: &[Segment]) -> Option<(usize, usize)> {
    for runs_in in 0..=Walls::MOST.min(segments.len() - 1) {
        let is_again = |one: &Segment| are_same(&segments[runs_in], one);
        let Some(count) = segments[runs_in + 1..].iter().position(is_again) else { continue };
        let count = count + 1;
        let pairs = segments[runs_in..].iter().zip(&segments[runs_in + count..]);
        let same = pairs.take_while(|(a, b)| are_same(a, b)).count();
        let ends = runs_in + count + same;
        if same < count || segments.len() - ends > Walls::MOST {
            continue;
        }
        // It is where the first lap comes nearest to the way in.
        let (mut nearest, mut second) = (f64::INFINITY, runs_in + count);
        for next in count..=runs_in + count {
            let at = segments[next].curve.start();
            let mut distance = f64::INFINITY;
            for segment in &segments[..=next - count] {
                distance = distance.min(segment.curve.nearest(at).distance);
            }
            if distance < nearest - SAME {
                (nearest, second) = (distance, next);
            }
        }
        return Some((second, count));
    }
    None
}

/// Whether two segments lie on each other.
fn are_same(a: &Segment, b: &Segment) -> bool {
    let (a, b) = (&a.curve, &b.curve);
    let spans = |curve: &Curve| match curve {
        Curve::Spline(spline) => spline.pieces().len(),
        Curve::Line(_) | Curve::Arc(_) | Curve::Involute(_) => 1,
    };
    a.start().distance(b.start()) <= SAME
        && std::mem::discriminant(a) == std::mem::discriminant(b)
        && spans(a) == spans(b)
        && (0..spans(a)).all(|span| {
            let (a, b) = (MoveCurve::of(a, span), MoveCurve::of(b, span));
            // Four points make a cubic, and three an arc.
            (0..4).map(|k| f64::from(k) / 3.0).all(|t| a.point(t).distance(b.point(t)) <= SAME)
        })
}

/// A lap with the segments of the contour before and behind it, and which of its segments are walls.
fn with_neighbours(contour: &Contour, lap: Range<usize>, side: Side) -> (Contour, Range<usize>) {
    let segments = contour.segments();
    // Where the tool goes round no corner, its path ends and begins at the same place.
    let beside = |index: usize, joint: usize| {
        let mut beside = segments.get(index)?.clone();
        beside.attributes.origin = BESIDE;
        let ends = segments[joint - 1].curve.tangent(1.0);
        let begins = segments[joint].curve.tangent(0.0);
        let is_inside = (ends.perp_dot(begins) > 0.0) == (side == Side::Left);
        (!is_inside || ends.perp_dot(begins).abs() <= f64::EPSILON).then_some(beside)
    };
    let before = lap.start.checked_sub(1).and_then(|index| beside(index, lap.start));
    let behind = beside(lap.end, lap.end);
    let alone = contour.part(lap);
    let all = 0..alone.segments().len();
    let (mut along, mut walls) =
        if let Some(walls) = Walls::of(&alone, side) { walls.split(alone) } else { (alone, all) };
    if before.is_some() {
        walls = walls.start + 1..walls.end + 1;
    }
    along.extend(before, behind);
    (along, walls)
}

/// Leaves out what was made for the segments beside a lap.
fn leave_out_beside(path: &mut ToolPath) {
    let mut words = path.words.iter_mut().peekable();
    let mut kept = 0;
    for (index, step) in path.moves.iter().enumerate() {
        while let Some(word) = words.next_if(|word| word.before <= index) {
            word.before = kept;
        }
        kept += usize::from(step.origin != BESIDE);
    }
    for word in words {
        word.before = kept;
    }
    path.moves.retain(|step| step.origin != BESIDE);
    path.transitions.retain(|transition| transition.origin != BESIDE);
    path.diagnostics.retain(|found| found.origin != Some(BESIDE));
    for uncut in &mut path.uncut {
        uncut.segments.retain(|segment| *segment != BESIDE);
    }
}

/// Appends the path of a lap to that of those before it. What is wrong with every lap is told of the
/// first.
fn follow(path: &mut ToolPath, mut lap: ToolPath, tolerance: f64) {
    let Some(last) = path.moves.last().copied() else {
        return path.append(lap);
    };
    lap.diagnostics.retain(|found| path.diagnostics.iter().all(|told| told.code != found.code));
    lap.uncut.clear();
    let at = last.curve.end();
    if let Some(next) = lap.moves.first().copied() {
        let gap = at.distance(next.curve.start());
        // What a lap leaves to the next is far within the tolerance.
        if gap > MIN_LENGTH
            && gap <= tolerance
            && let Ok(line) = Line::new(at, next.curve.start())
        {
            let curve = MoveCurve::Line(line);
            let heights = [next.heights[0]; 2];
            lap.moves.insert(0, Move { curve, role: Role::Segment, heights, ..next });
            for words in &mut lap.words {
                words.before += 1;
            }
        }
    }
    path.append(lap);
}
