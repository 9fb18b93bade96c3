//! Contours of a program for a control with one block of look-ahead.

use super::tools::tip;
use crate::compensation::{Options, Passage, look_ahead};
use crate::contour::{Contour, Plane, Role, Tool, ToolPath};
use crate::diagnostic::{Diagnostic, Origin};
use crate::geometry::{Decimal, sin_cos};
use crate::gouge::check;
use crate::program::{ContourEnd, ContourStart, ProgrammedContour};

/// The path of a contour, and whether the control goes on after it. `orientation` is that of the
/// tool, `origin` the block that switches on.
pub(super) fn with_look_ahead(
    programmed: &ProgrammedContour,
    tool: Tool,
    orientation: u8,
    options: &Options,
    origin: Origin,
) -> (ToolPath, bool) {
    let ProgrammedContour { contour, unit, leads_in, .. } = programmed;
    let is_cut_off = programmed.end == ContourEnd::CutOff;
    let tip = tip(orientation, tool.radius());
    if !matches!(orientation, 0 | 9) && contour.segments()[0].attributes.plane != Plane::Zx {
        let message = "a lathe tool is compensated in the plane G18 alone";
        let refused = Diagnostic::error("refused", message)
            .with_origin(origin)
            .with_hint("the control stops here, and so does the path");
        return (ToolPath { diagnostics: vec![refused], ..ToolPath::default() }, false);
    }
    let passage = Passage { leads_in: *leads_in, is_cut_off, tip, unit: *unit };
    let (mut path, mut finished) = look_ahead(contour, tool, options, &passage);
    if let ContourEnd::Refused(why) = &programmed.end
        && finished
        && tool.radius() > 0.0
    {
        path.diagnostics.push((**why).clone());
        finished = false;
    }
    if finished && tip == glam::DVec2::ZERO {
        judge(&mut path, programmed, tool, options);
    }
    (path, finished)
}

/// Tells where the path cuts too deep; the control itself looks at one corner at a time, and makes
/// it all the same. What a corner within the tangent band costs is not counted.
fn judge(path: &mut ToolPath, programmed: &ProgrammedContour, tool: Tool, options: &Options) {
    let Some(contour) = part(programmed) else { return };
    let mut own = ToolPath::default();
    for step in &path.moves {
        if matches!(step.role, Role::Segment | Role::Transition) {
            own.moves.push(*step);
        }
    }
    let undercut = tool.radius() * (1.0 - sin_cos(options.band(tool.radius())).1);
    let tolerance = options.usable_tolerance() + undercut;
    for gouge in check(&contour, &own, tool.radius(), tolerance) {
        let message = format!("the path cuts {} mm too deep", Decimal::of(gouge.depth));
        let mut diagnostic = Diagnostic::warning("bottleneck-gouge", message)
            .with_point(gouge.at)
            .with_depth(gouge.depth)
            .with_hint("use a smaller tool, or let gouges be avoided")
            .with_segments(gouge.segments.as_slice());
        diagnostic.origin = gouge.segments.first().copied();
        path.diagnostics.push(diagnostic);
        path.gouges.push(gouge);
    }
}

/// The contour without what leads in, and without segments on which the radius changes; `None` where
/// that is all.
pub(super) fn part(programmed: &ProgrammedContour) -> Option<Contour> {
    let segments = programmed.contour.segments();
    let first = programmed.leads_in || programmed.begins == ContourStart::Tapers;
    let until = segments.len() - usize::from(programmed.end == ContourEnd::Tapers);
    let segments = segments.get(usize::from(first)..until).unwrap_or(&[]);
    (!segments.is_empty()).then(|| Contour::of_segments(segments.to_vec(), false, [None, None]))
}
