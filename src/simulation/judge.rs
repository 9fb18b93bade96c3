//! Judging the tool path of a whole program.

use super::Tools;
use super::walls::walls;
use crate::contour::{Contour, Gouge, Role, Tool, ToolPath};
use crate::diagnostic::{Diagnostic, Severity};
use crate::geometry::Decimal;
use crate::gouge::check;
use crate::program::{ContourStart, Interpretation, Item};

/// The code of a diagnostic about a path that is too near to a distant part of its contour.
const TOO_NEAR: &str = "bottleneck-gouge";

/// Part of its depth that a gouge must have been told with to be told.
const TOLD: f64 = 0.95;

/// Finds where `path` comes nearer than the radius − `tolerance` [mm] to the contours of a program.
///
/// Each contour is held against the moves that were made for it: others are there for other heights,
/// or cut away first what it finishes. A path that was not made from a program is held against all of
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
        let moves = path.moves[first + usize::from(tapers)..end].to_vec();
        let own = ToolPath { moves, ..ToolPath::default() };
        let Some(tool) = Tool::new(radius, programmed.side) else { continue };
        if let Some(walls) = walls(programmed, tool.side()) {
            gouges.append(&mut check(&walls, &own, radius, tolerance));
        }
    }
    gouges
}

/// Adds to a path where its own moves, leads apart, cut the `walls` too deep.
pub(super) fn tell_gouges(
    path: &mut ToolPath,
    walls: &Contour,
    tool: Tool,
    tolerance: f64,
    severity: Severity,
) {
    let mut own = ToolPath::default();
    for step in &path.moves {
        if matches!(step.role, Role::Segment | Role::Transition) {
            own.moves.push(*step);
        }
    }
    for gouge in check(walls, &own, tool.radius(), tolerance) {
        let is_told = |told: &Gouge| {
            told.at.distance(gouge.at) <= 2.0 * tool.radius() && told.depth >= TOLD * gouge.depth
        };
        if path.gouges.iter().any(is_told) {
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

/// Judges anew what of a path was found too near to distant parts of its contour, when parts of that
/// are no walls.
pub(super) fn judge_again(path: &mut ToolPath, walls: &Contour, tool: Tool, tolerance: f64) {
    let ToolPath { diagnostics, gouges, .. } = path;
    diagnostics.retain(|found| {
        let is_of = |gouge: &Gouge| found.at == Some(gouge.at) && found.depth == Some(gouge.depth);
        let judged_again = found.code == TOO_NEAR;
        if judged_again {
            gouges.retain(|gouge| !is_of(gouge));
        }
        !judged_again
    });
    tell_gouges(path, walls, tool, tolerance, Severity::Error);
}
