//! Judging the tool path of a whole program.

use glam::DVec2;

use super::Tools;
use super::walls::{Lap, laps};
use crate::contour::{Contour, Gouge, Move, MoveCurve, Role, Segment, Tool, ToolPath};
use crate::diagnostic::{Diagnostic, Severity};
use crate::geometry::Decimal;
use crate::gouge::check_all;
use crate::program::{ContourStart, Interpretation, Item, ProgrammedContour};

/// The code of a diagnostic about a path that is too near to a distant part of its contour.
const TOO_NEAR: &str = "bottleneck-gouge";

/// Part of its depth that a gouge must have been told with to be told.
const TOLD: f64 = 0.95;

/// Finds where `path` comes nearer than the radius − `tolerance` [mm] to the contours of a program.
///
/// Each contour is held against the moves that were made for it: others are there for other heights,
/// or cut away first what it finishes. Of a contour that is gone round more than once each lap is held
/// against itself and the last one. A path that was not made from a program is held against all of
/// them. A contour whose tool has no radius is not judged.
#[must_use]
pub fn check_program(
    interpretation: &Interpretation,
    path: &ToolPath,
    tools: &Tools,
    tolerance: f64,
) -> Vec<Gouge> {
    let mut gouges = Vec::new();
    let mut ranges = path.contours.iter();
    for item in &interpretation.items {
        let Item::Contour(programmed) = item else { continue };
        let [first, end] = match ranges.next() {
            Some(range) => *range,
            None if path.contours.is_empty() => [0, path.moves.len()],
            None => break,
        };
        let Some(radius) = tools.radius_of(programmed) else { continue };
        // The block on which the radius changes is the path of neither radius.
        let tapers = programmed.begins == ContourStart::Tapers && first < end;
        let moves = &path.moves[first + usize::from(tapers)..end];
        let Some(tool) = Tool::new(radius, programmed.side) else { continue };
        let laps = laps(programmed, tool.side());
        gouges.append(&mut judged(programmed, &laps, moves, tool, tolerance));
    }
    gouges
}

/// Where the moves along a contour cut its walls too deep, each place once.
///
/// A lap may cut away what those before it left: it is held against its own walls and those of the
/// last one, which are what stays.
fn judged(
    programmed: &ProgrammedContour,
    laps: &[Lap<'_>],
    moves: &[Move],
    tool: Tool,
    tolerance: f64,
) -> Vec<Gouge> {
    let segments = programmed.contour.segments();
    let mut gouges: Vec<Gouge> = Vec::new();
    let (mut next, mut segment) = (0, 0);
    for (index, lap) in laps.iter().enumerate() {
        let mut own = ToolPath::default();
        while let Some(step) = moves.get(next) {
            if let Some(later) = laps.get(index + 1) {
                // Blocks may be run again, so their order tells.
                let rest = &segments[segment..];
                let is_of = |of: &Segment| of.attributes.origin == step.origin;
                if !matches!(step.curve, MoveCurve::Vertical(_)) {
                    segment += rest.iter().position(is_of).unwrap_or(0);
                }
                if segment >= later.first {
                    break;
                }
            }
            own.moves.push(*step);
            next += 1;
        }
        let mut walls: Vec<&Contour> = vec![&lap.walls];
        if let Some(last) = laps[index + 1..].last() {
            walls.push(&last.walls);
        }
        let before = gouges.len();
        for gouge in check_all(&walls, &own, tool.radius(), tolerance) {
            if !is_told(&gouges[..before], &gouge, tool) {
                gouges.push(gouge);
            }
        }
    }
    gouges
}

/// Whether one of some gouges tells of another.
fn is_told(gouges: &[Gouge], gouge: &Gouge, tool: Tool) -> bool {
    gouges.iter().any(|told| {
        told.at.distance(gouge.at) <= 2.0 * tool.radius() && told.depth >= TOLD * gouge.depth
    })
}

/// Adds to a path where its own moves, leads apart, cut the walls of their contour too deep.
pub(super) fn tell_gouges(
    path: &mut ToolPath,
    programmed: &ProgrammedContour,
    laps: &[Lap<'_>],
    tool: Tool,
    tolerance: f64,
    severity: Severity,
) {
    let mut own = Vec::with_capacity(path.moves.len());
    for step in &path.moves {
        if matches!(step.role, Role::Segment | Role::Transition | Role::Link) {
            own.push(*step);
        }
    }
    for gouge in judged(programmed, laps, &own, tool, tolerance) {
        if is_told(&path.gouges, &gouge, tool) {
            continue;
        }
        let message = format!("the path cuts {} mm too deep", Decimal::of(gouge.depth));
        let mut diagnostic = Diagnostic::warning(TOO_NEAR, message)
            .with_point(gouge.at)
            .with_depth(gouge.depth)
            .with_hint("use a smaller tool, or let gouges be avoided")
            .with_segments(gouge.segments.as_slice());
        diagnostic.origin = gouge.segments.first().copied();
        path.diagnostics.push(Diagnostic { severity, ..diagnostic });
        path.gouges.push(gouge);
    }
}

/// Judges the path of a contour of which parts are no walls, or that is gone round more than once; so
/// far it tells what single segments and corners cut.
pub(super) fn judge_laps(
    path: &mut ToolPath,
    programmed: &ProgrammedContour,
    laps: &[Lap<'_>],
    tool: Tool,
    tolerance: f64,
) {
    if laps.len() > 1 {
        leave_out_repeated(path, tolerance);
    }
    tell_gouges(path, programmed, laps, tool, tolerance, Severity::Error);
}

/// Leaves out what is told of a lap and was told of one before: what is wrong with every lap is told of
/// the first.
fn leave_out_repeated(path: &mut ToolPath, tolerance: f64) {
    let mut told: Vec<(&str, DVec2)> = Vec::new();
    let mut repeated = Vec::new();
    // Laps tell in one order, so what follows what was found last is looked at first.
    let mut next = 0;
    path.diagnostics.retain(|found| {
        let (Some(at), Some(depth)) = (found.at, found.depth) else { return true };
        let is_known =
            |&(code, place): &(&str, DVec2)| code == found.code && place.distance(at) <= tolerance;
        if !told.get(next).is_some_and(is_known) {
            let Some(index) = told.iter().position(is_known) else {
                told.push((found.code, at));
                return true;
            };
            next = index;
        }
        next += 1;
        repeated.push((at, depth));
        false
    });
    // They are in the order of what is told.
    let mut repeated = repeated.into_iter().peekable();
    path.gouges.retain(|gouge| repeated.next_if_eq(&(gouge.at, gouge.depth)).is_none());
}
