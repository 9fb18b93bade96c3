//! A contour of a program with its gouges avoided: in one pass or in several, along all its laps.

use super::lap_by_lap::{avoid_laps, has_laps};
use crate::compensation::{Options, Passes, clear_beside, compensate_all, compensate_beside};
use crate::contour::{Tool, ToolPath, Walls};
use crate::diagnostic::Diagnostic;
use crate::program::ProgrammedContour;

/// The path of a contour without what the tool cannot reach.
pub(super) fn avoided(
    programmed: &ProgrammedContour,
    walls: Option<&Walls>,
    tool: Tool,
    options: &Options,
) -> ToolPath {
    let contour = &programmed.contour;
    if options.passes != Passes::One && has_laps(contour) {
        // Passes beside laps that lie on each other would be parts of one lap and parts of the next.
        let options = Options { passes: Passes::One, ..*options };
        let mut path = avoided(programmed, walls, tool, &options);
        path.diagnostics.push(
            Diagnostic::error("several-laps", "only one pass: the contour is gone round again")
                .with_origin(contour.segments()[0].attributes.origin)
                .with_point(contour.start())
                .with_hint("write each lap as a contour of its own, with G40 before the next"),
        );
        return path;
    }
    if options.passes != Passes::One {
        return match (walls, Walls::of_lap(contour)) {
            (Some(walls), _) => {
                let inner = walls.closed(contour);
                let (contour, walls) = walls.split(contour.clone());
                clear_beside(&contour, walls, &inner, tool, options)
            }
            (None, Some(lap)) => {
                let all = 0..contour.segments().len();
                clear_beside(contour, all, &lap.closed(contour), tool, options)
            }
            (None, None) => compensate_all(&[(contour, tool)], options),
        };
    }
    let by_lap = || avoid_laps(programmed, tool, options);
    by_lap().unwrap_or_else(|| match walls {
        Some(walls) => {
            let (contour, walls) = walls.split(contour.clone());
            compensate_beside(&contour, walls, tool, options)
        }
        None => compensate_all(&[(contour, tool)], options),
    })
}
