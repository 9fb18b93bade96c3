//! Contours of a program for a control with one block of look-ahead.

use super::judge::tell_gouges;
use super::tools::tip;
use super::walls::laps;
use crate::compensation::{Options, Passage, look_ahead};
use crate::contour::{Plane, Tool, ToolPath};
use crate::diagnostic::{Diagnostic, Origin, Severity};
use crate::geometry::sin_cos;
use crate::program::{ContourEnd, ProgrammedContour, RadiusSource};

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
    let is_listed = matches!(programmed.radius, RadiusSource::Tool(_));
    let passage = Passage { leads_in: *leads_in, is_cut_off, tip, unit: *unit, is_listed };
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
    let undercut = tool.radius() * (1.0 - sin_cos(options.band(tool.radius())).1);
    let tolerance = options.usable_tolerance() + undercut;
    let laps = laps(programmed, tool.side());
    tell_gouges(path, programmed, &laps, tool, tolerance, Severity::Warning);
}
