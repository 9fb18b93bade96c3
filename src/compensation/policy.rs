//! What becomes of gouges: reported, avoided, or reason to make no path at all.

use std::ops::Range;

use super::as_arcs::{ARC_SHARE, as_arcs};
use super::assemble::{compensate, compensate_traced, usable};
use super::avoid::{avoid_all, avoid_beside};
use super::lookahead::{Passage, look_ahead};
use super::passes::{pocket, with_passes};
use super::whole::Trace;
use super::{GougePolicy, LeadStyle, Options, Output, Passes};
use crate::contour::{Contour, Tool, ToolPath};
use crate::diagnostic::Diagnostic;

/// The path of several contours, each with its tool, as [`Options::gouge`] wants it.
///
/// With [`GougePolicy::Stop`] a path that gouges anywhere is left empty; its gouges and diagnostics
/// stay.
#[must_use]
pub fn compensate_all(jobs: &[(&Contour, Tool)], options: &Options) -> ToolPath {
    if options.output == Output::Arcs {
        return with_arcs(options, &|cubics| compensate_all(jobs, cubics));
    }
    if options.gouge == GougePolicy::Avoid {
        let one = options.passes == Passes::One;
        return if one { avoid_all(jobs, options) } else { pocket(jobs, options) };
    }
    let mut path = ToolPath::default();
    // Contours that follow each other with the same tool are walls to each other.
    for group in jobs.chunk_by(|a, b| a.1.radius() == b.1.radius()) {
        if group.iter().any(|(contour, _)| looks_ahead(contour, options)) {
            for &(contour, tool) in group {
                path.append(if looks_ahead(contour, options) {
                    look_ahead(contour, tool, options, &Passage::default()).0
                } else {
                    compensate(contour, tool, options)
                });
            }
            continue;
        }
        let mut part = ToolPath::default();
        let (mut trace, mut tolerance) = (Trace::default(), 0.0_f64);
        for &(contour, tool) in group {
            let first_move = part.moves.len();
            part.append(compensate_traced(contour, tool, options, &mut trace, first_move));
            tolerance = tolerance.max(usable(contour, tool, options));
        }
        trace.report(&mut part, group, tolerance);
        path.append(part);
    }
    if options.gouge == GougePolicy::Stop {
        refuse_gouges(&mut path);
    }
    path
}

/// The path of a contour as [`super::compensate`] makes it, without a look at whether distant parts of
/// the contour are too near to each other: that is for whoever knows which of them are walls.
#[must_use]
pub fn compensate_locally(contour: &Contour, tool: Tool, options: &Options) -> ToolPath {
    if options.output == Output::Arcs {
        return with_arcs(options, &|cubics| compensate_locally(contour, tool, cubics));
    }
    compensate_traced(contour, tool, options, &mut Trace::default(), 0)
}

/// The path of an open contour of which only the segments of a range are walls, gouges avoided: what
/// runs in before them and out behind them is followed, and may be cut.
#[must_use]
pub fn compensate_beside(
    contour: &Contour,
    walls: Range<usize>,
    tool: Tool,
    options: &Options,
) -> ToolPath {
    if options.output == Output::Arcs {
        let along = |cubics: &Options| compensate_beside(contour, walls.clone(), tool, cubics);
        return with_arcs(options, &along);
    }
    avoid_beside(contour, walls, tool, options)
}

/// The path of [`compensate_beside`] as the first of several passes, the others along the closed contour
/// `inner`, which is its walls.
#[must_use]
pub fn clear_beside(
    contour: &Contour,
    walls: Range<usize>,
    inner: &Contour,
    tool: Tool,
    options: &Options,
) -> ToolPath {
    if options.output == Output::Arcs {
        let along = |cubics: &Options| clear_beside(contour, walls.clone(), inner, tool, cubics);
        return with_arcs(options, &along);
    }
    let first = avoid_beside(contour, walls, tool, options);
    with_passes(first, &[(inner.without_leads(), tool)], options)
}

/// A path of cubics made into arcs; each has its share of the tolerance.
fn with_arcs(options: &Options, compensate: &dyn Fn(&Options) -> ToolPath) -> ToolPath {
    let tolerance = options.usable_tolerance();
    let share = (1.0 - ARC_SHARE) * tolerance;
    let mut path = compensate(&Options { tolerance: share, output: Output::Cubics, ..*options });
    as_arcs(&mut path, ARC_SHARE * tolerance);
    path
}

/// Whether a contour is led into as by a control that looks one block ahead.
pub(super) fn looks_ahead(contour: &Contour, options: &Options) -> bool {
    options.lead == LeadStyle::LinuxCnc
        && options.gouge != GougePolicy::Avoid
        && contour.lead_in().is_some()
}

/// Takes all moves from a path that gouges, and says so.
pub fn refuse_gouges(path: &mut ToolPath) {
    let Some(deepest) = path.gouges.iter().max_by(|a, b| a.depth.total_cmp(&b.depth)) else {
        return;
    };
    let mut diagnostic = Diagnostic::error("stopped", "the path would gouge, so there is none")
        .with_point(deepest.at)
        .with_depth(deepest.depth)
        .with_hint("use a smaller tool, or let gouges be avoided")
        .with_segments(deepest.segments.as_slice());
    diagnostic.origin = deepest.segments.first().copied();
    path.moves.clear();
    path.contours.clear();
    path.transitions.clear();
    path.words.clear();
    path.diagnostics.push(diagnostic);
}
