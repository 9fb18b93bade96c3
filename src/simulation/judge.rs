//! Judging the tool path of a whole program.

use super::Tools;
use super::ahead::part;
use crate::contour::{Gouge, Move, ToolPath};
use crate::diagnostic::Origin;
use crate::gouge::check;
use crate::program::{Interpretation, Item, ProgrammedContour};

/// Finds where `path` comes nearer than the radius − `tolerance` [mm] to the contours of a program.
///
/// Each contour is held against the moves that its own blocks make: others are there for other
/// heights, or cut away first what it finishes. A contour whose tool has no radius is not judged.
#[must_use]
pub fn check_program(
    interpretation: &Interpretation,
    path: &ToolPath,
    tools: &Tools,
    tolerance: f64,
) -> Vec<Gouge> {
    let mut gouges = Vec::new();
    for item in &interpretation.items {
        let Item::Contour(programmed) = item else { continue };
        let Some(radius) = tools.radius_of(programmed) else { continue };
        let own = |step: &&Move| comes_from(step, programmed);
        let moves = path.moves.iter().filter(own).copied().collect();
        let own = ToolPath { moves, ..ToolPath::default() };
        if !programmed.leads_in {
            gouges.append(&mut check(&programmed.contour, &own, radius, tolerance));
        } else if let Some(contour) = part(programmed) {
            gouges.append(&mut check(&contour, &own, radius, tolerance));
        }
    }
    gouges
}

/// Whether a move was programmed in the blocks of a contour.
fn comes_from(step: &Move, programmed: &ProgrammedContour) -> bool {
    let [first, last] = programmed.blocks;
    match step.origin {
        Origin::Block { line, .. } => (first..=last).contains(&line),
        Origin::Segment(_) => false,
    }
}
