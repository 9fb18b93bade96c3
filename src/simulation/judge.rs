//! Judging the tool path of a whole program.

use super::Tools;
use super::ahead::part;
use crate::contour::{Gouge, ToolPath};
use crate::gouge::check;
use crate::program::{ContourEnd, ContourStart, Interpretation, Item};

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
        let is_whole = !programmed.leads_in
            && programmed.begins != ContourStart::Tapers
            && programmed.end != ContourEnd::Tapers;
        if is_whole {
            gouges.append(&mut check(&programmed.contour, &own, radius, tolerance));
        } else if let Some(contour) = part(programmed) {
            gouges.append(&mut check(&contour, &own, radius, tolerance));
        }
    }
    gouges
}
