//! Avoiding gouges on the whole contour: what the tool can reach without cutting too deep.
//!
//! 1. The whole offsets of all lines, arcs and spans and the arcs about outside corners make the raw
//!    pieces (`units`).
//! 2. A tree over them in program order tells which of them may be too near to which part of the
//!    contour (`tree`); all others are clear. Mostly that is all of them.
//! 3. What is too near all along is dropped (`sieve`), what is left is cut at all crossings with
//!    each other and where the other side and the free ends of the contour become too near (`cuts`,
//!    `fences`). Between two cuts a piece is either clear of the contour all along or too near all
//!    along, so a few places tell.
//! 4. What is clear is strung together at the crossings (`chains`), without what leads nowhere
//!    (`dead_ends`), and made into moves (`stitch`).
//! 5. What was cut out bounds the material that is not reached (`uncut`).
//! 6. Where walls are exactly a tool apart, or nearly parallel, an end may find nothing to go on with:
//!    then a tool that is smaller by a part of the tolerance, which leaves it the rest, is tried.

mod chains;
mod cuts;
mod dead_ends;
mod fences;
pub(super) mod octants;
mod points;
mod sieve;
mod stitch;
pub(super) mod tree;
mod uncut;
mod units;

use std::ops::Range;

use glam::DVec2;

use self::chains::{Chain, chains, lost_ends, remove_unreached, whole_chains};
use self::cuts::{Stretch, Survey};
use self::dead_ends::remove_dead_ends;
use self::sieve::{Clearance, Fate, sieve};
use self::stitch::Stitcher;
use self::tree::{Limits, OrderTree};
use self::uncut::{uncut, uncut_inside};
use self::units::{Job, Workpiece};
use super::assemble::finest_tolerance;
use super::path::PathBuilder;
use super::{Options, SplineMethod};
use crate::contour::{Contour, MoveCurve, Tool, ToolPath};
use crate::diagnostic::{Diagnostic, Origin};
use crate::geometry::{Curve, Decimal};

/// The largest tolerance, as a part of the radius: within one of about the radius a path that crosses a
/// wall is too near to it nowhere but there, and may be taken for clear.
const COARSEST: f64 = 0.1;

/// Part of the tolerance that offsets of splines may use up where the path is cut. Elsewhere they use
/// up all of it.
const OFFSET_SHARE: f64 = 0.1;

/// Part of the tolerance that the splines in the place of involutes may use up; the rest is for their
/// offsets.
const INVOLUTE_SHARE: f64 = 0.01;

/// Part of the tolerance by which a place may be too near and still count as clear where there are
/// splines: a piece and the one that cuts it may both be off by their share.
///
/// A place counts as clear or not much more sharply than the tolerance asks: between two cuts the
/// answer is the same all along only to that.
const CLEAR_SHARE: f64 = 0.22;

/// Chords of the outlines of what is left uncut, as a part of the tool radius: a tenth of a
/// thousandth of it in area.
const OUTLINE: f64 = 1e-4;

/// Longest dead end, and longest bridge, as a multiple of `√(r tolerance)`: on a chord of 2.8 of it, a
/// tool cuts as deep as the tolerance.
const DEAD_END: f64 = 4.0;

/// Part of the tolerance by which a bridge between two stretches may be too near.
const BRIDGE_SHARE: f64 = 0.9;

/// Part of the tolerance by which a place may be too near beyond that, where gaps were closed.
const GAP_SHARE: f64 = 0.6;

/// The slack where there are only lines and arcs, whose offsets are exact [mm].
const EXACT: f64 = 1e-7;

/// Longest piece of path that may get lost on both ends and be left out, in tolerances.
const STRAY: f64 = 10.0;

/// The slack of a tool that is said to fit exactly [mm].
const ROUNDING: f64 = 1e-9;

/// Parts of the tolerance by which the tool is taken to be smaller where the path got lost: what
/// touched exactly, or crossed at no angle to speak of, hardly does so for two radii.
const SMALLER: [f64; 3] = [0.0, 0.5, 0.3];

/// The path of the centre of `tool` along `contour` without what it cannot reach.
///
/// The tool never comes nearer than `radius − tolerance` to any point of the contour, looked at as a
/// whole; leads apart, which are as programmed. Splines are offset exactly, whatever
/// `options.spline` says, and involutes as splines that a hundredth of the tolerance is kept for.
/// Where the tool does not fit between distant segments the path falls into several pieces, ordered
/// by where they begin on the contour; a closed contour gives closed pieces. Outside corners are gone round by an arc where `options.corner` asks for straight moves
/// but something else is in their way, or for anything but those; leads go straight to where the
/// path begins, where they do not go round a corner. [`ToolPath::uncut`] tells what is not reached. Nothing
/// reachable gives an empty path and a diagnostic.
#[must_use]
pub fn avoid(contour: &Contour, tool: Tool, options: &Options) -> ToolPath {
    avoid_all(&[(contour, tool)], options)
}

/// The same for several contours of one workpiece, as a pocket with its islands: no tool comes too
/// near to any of them.
///
/// Contours whose tools have the same radius are looked at together; those of another radius are
/// cut at another time, by another tool, and do not concern each other.
#[must_use]
pub fn avoid_all(contours: &[(&Contour, Tool)], options: &Options) -> ToolPath {
    let mut path = ToolPath::default();
    let mut done = vec![false; contours.len()];
    for first in 0..contours.len() {
        let radius = contours[first].1.radius();
        let mut jobs = Vec::new();
        for (&(contour, tool), done) in contours.iter().zip(&mut done) {
            if !*done && tool.radius() == radius {
                *done = true;
                jobs.push(Job::new(contour, tool));
            }
        }
        if !jobs.is_empty() {
            path.append(avoid_jobs(&jobs, radius, options));
        }
    }
    path
}

/// The same for one open contour of which only a range of segments is wall: what runs in before it
/// and out behind it is followed as far as the tool fits, and may be cut.
pub(super) fn avoid_beside(
    contour: &Contour,
    walls: Range<usize>,
    tool: Tool,
    options: &Options,
) -> ToolPath {
    let job = Job { contour, tool, walls: [walls.start, walls.end] };
    avoid_jobs(&[job], tool.radius(), options)
}

/// The clear moves along stretches of one contour, and which ends of their pieces got lost [mm].
///
/// Each stretch is looked at as if there were nothing else; `smaller` tells by which part of the
/// tolerance the tool is to be smaller.
pub(super) fn clear_path(
    stretches: &[Contour],
    tool: Tool,
    options: &Options,
    whole: &Whole,
    smaller: f64,
) -> (ToolPath, Vec<DVec2>) {
    let jobs: Vec<Job> = stretches.iter().map(|contour| Job::new(contour, tool)).collect();
    clear_jobs_by(&jobs, tool.radius(), options, whole, smaller)
}

/// What is to be known of the contour that stretches are part of.
pub(super) struct Whole<'a> {
    pub(super) closed: bool,
    pub(super) has_spline: bool,
    /// Whether a lost end on a segment of such an origin counts.
    pub(super) counts: &'a dyn Fn(Origin) -> bool,
    /// Whether it is to be told what is left uncut.
    pub(super) tells_uncut: bool,
}

fn avoid_jobs(jobs: &[Job], radius: f64, options: &Options) -> ToolPath {
    let tolerance = options.usable_tolerance();
    let share = INVOLUTE_SHARE * tolerance;
    let mut splined = Vec::with_capacity(jobs.len());
    for job in jobs {
        splined.push(job.contour.with_splines(share));
    }
    let Some(first) = splined.iter().position(Option::is_some) else {
        return avoid_curves(jobs, radius, options);
    };
    let mut others = Vec::with_capacity(jobs.len());
    for (job, splined) in jobs.iter().zip(&splined) {
        others.push(Job { contour: splined.as_ref().unwrap_or(job.contour), ..*job });
    }
    let rest = Options { tolerance: tolerance - share, ..*options };
    let mut path = avoid_curves(&others, radius, &rest);
    path.diagnostics.push(tell_splines(jobs[first].contour, share));
    path
}

/// Says that involutes were looked at as splines, and how near those are.
fn tell_splines(contour: &Contour, share: f64) -> Diagnostic {
    let message = format!("involutes count as splines {} mm from them", Decimal::new(share, 9));
    let diagnostic = Diagnostic::info("involutes-as-splines", message)
        .with_hint("where gouges are avoided; elsewhere the path has involutes");
    let involute =
        contour.segments().iter().find(|segment| matches!(segment.curve, Curve::Involute(_)));
    match involute {
        Some(segment) => diagnostic.with_origin(segment.attributes.origin),
        None => diagnostic,
    }
}

/// [`avoid_jobs`] where there are no involutes.
fn avoid_curves(jobs: &[Job], radius: f64, options: &Options) -> ToolPath {
    let has_spline = |job: &Job| {
        job.contour.segments().iter().any(|segment| matches!(segment.curve, Curve::Spline(_)))
    };
    let has_spline = jobs.iter().any(has_spline);
    let whole = Whole { closed: false, has_spline, counts: &|_| true, tells_uncut: true };
    let mut paths = Vec::new();
    let best = best_of(&mut |smaller| {
        let (path, lost) = clear_jobs_by(jobs, radius, options, &whole, smaller);
        paths.push(path);
        lost
    });
    paths.swap_remove(best.index)
}

/// Looks for the path of which the fewest ends get lost, of one for the tool as it is and of others for
/// smaller ones; `path` is told by which part of the tolerance, and tells which ends got lost [mm].
pub(super) fn best_of(path: &mut dyn FnMut(f64) -> Vec<DVec2>) -> Best {
    let mut best = Best { index: 0, smaller: 0.0, lost: Vec::new() };
    let mut fewest = usize::MAX;
    for (index, smaller) in SMALLER.into_iter().enumerate() {
        let lost = path(smaller);
        if lost.len() < fewest {
            (best.index, best.smaller, fewest) = (index, smaller, lost.len());
        }
        if lost.is_empty() {
            break;
        }
        best.lost.extend(lost);
    }
    best
}

/// The best of some paths.
pub(super) struct Best {
    /// The how manyth it was.
    pub(super) index: usize,
    /// By which part of the tolerance its tool is smaller.
    pub(super) smaller: f64,
    /// Which ends of any of them got lost [mm].
    pub(super) lost: Vec<DVec2>,
}

/// The path of a tool that is smaller by a part of the tolerance, which leaves it the rest.
fn clear_jobs_by(
    jobs: &[Job],
    radius: f64,
    options: &Options,
    whole: &Whole,
    smaller: f64,
) -> (ToolPath, Vec<DVec2>) {
    if smaller == 0.0 {
        return clear_jobs(jobs, radius, options, whole);
    }
    let less = (smaller * options.usable_tolerance()).min(smaller * radius);
    let (radius, tolerance) = (radius - less, options.usable_tolerance() - less);
    let mut with_smaller = Vec::with_capacity(jobs.len());
    for job in jobs {
        let tool = Tool::new(radius, job.tool.side()).unwrap_or(job.tool);
        with_smaller.push(Job { tool, ..*job });
    }
    let finer = Options { tolerance, ..*options };
    clear_jobs(&with_smaller, radius, &finer, &Whole { has_spline: true, ..*whole })
}

/// The path, and the ends of its pieces that got lost [mm].
fn clear_jobs(
    jobs: &[Job],
    radius: f64,
    options: &Options,
    whole: &Whole,
) -> (ToolPath, Vec<DVec2>) {
    let finest = jobs.iter().map(|job| finest_tolerance(job.contour, job.tool)).fold(0.0, f64::max);
    let tolerance = options.usable_tolerance().min(COARSEST * radius).max(finest);
    let options = &Options { tolerance, spline: SplineMethod::Exact, ..*options };
    let (mut work, nodes) = Workpiece::new(jobs, options);
    let mut tree = OrderTree::new(nodes);
    let loose = CLEAR_SHARE * tolerance;
    let slack = if whole.has_spline { loose } else { EXACT.max(finest).min(loose) };
    let slack = slack + work.gap.min(GAP_SHARE * tolerance);
    let least = radius - slack;
    let marks = tree.marks(&work.ranges, Limits { reach: radius + tolerance, least });
    let fates = sieve(&work, &marks, &mut Clearance::new(&work, &tree, least), tolerance);
    let whole_chains = whole_chains(&work, &fates);
    let is_whole = whole_chains.is_some();
    if is_whole && work.corners.is_empty() {
        // Nothing more is asked; the moves take its place in memory.
        tree = OrderTree::new(Vec::new());
    }
    let Strung { stretches, chained, lost } = match whole_chains {
        Some(chained) => Strung { stretches: Vec::new(), chained, lost: Vec::new() },
        None => cut_out(&mut work, &tree, fates, Fit { radius, tolerance, slack, finest }, whole),
    };
    let mut stitcher = Stitcher {
        work: &work,
        stretches: &stretches,
        clearance: Clearance::new(&work, &tree, least),
        options,
        builder: PathBuilder::default(),
        events: vec![0; jobs.len()],
    };
    stitcher.build(&chained);
    let mut path = stitcher.builder.path;
    if is_whole || !whole.tells_uncut {
        return (path, lost);
    }
    // The outline of a region need not be as fine as the path.
    let outline = tolerance.max(OUTLINE * radius);
    path.uncut = uncut(&work, &stretches, jobs[0].tool, outline);
    for (index, range) in work.ranges.iter().enumerate() {
        let pieces = work.pieces_of_range(*range);
        let first = stretches.partition_point(|stretch| stretch.piece < pieces.start);
        if stretches.get(first).is_some_and(|stretch| stretch.piece < pieces.end) {
            continue;
        }
        let contour = jobs[index].contour;
        path.uncut.extend(uncut_inside(&work, index, outline).filter(|_| jobs.len() == 1));
        path.diagnostics.push(
            Diagnostic::error("nothing-reachable", "the tool fits nowhere along the contour")
                .with_point(contour.start())
                .with_origin(contour.segments()[0].attributes.origin)
                .with_hint("use a smaller tool, or the other side"),
        );
    }
    (path, lost)
}

/// How a tool is to fit [mm].
#[derive(Clone, Copy)]
struct Fit {
    radius: f64,
    tolerance: f64,
    /// How much too near counts as clear.
    slack: f64,
    /// What rounding may make of a distance.
    finest: f64,
}

/// What the tool can follow.
struct Strung {
    stretches: Vec<Stretch>,
    chained: Vec<Chain>,
    /// Ends that got lost [mm].
    lost: Vec<DVec2>,
}

/// Cuts what is too near out of the raw path, and strings the rest together.
fn cut_out(
    work: &mut Workpiece,
    tree: &OrderTree,
    mut fates: Vec<Fate>,
    fit: Fit,
    whole: &Whole,
) -> Strung {
    let Fit { radius, tolerance, slack, finest } = fit;
    let least = radius - slack;
    let finer = OFFSET_SHARE * tolerance;
    if fates.contains(&Fate::Open) {
        fates = work.refine(finer, tolerance, tree, &fates);
        let mut clearance = Clearance::new(work, tree, least);
        for (piece, fate) in work.pieces.iter().zip(&mut fates) {
            let unit = piece.unit as usize;
            // Cubics are new, but for the one piece that there is still.
            if *fate == Fate::Open
                && matches!(work.curve(unit), Some(MoveCurve::Cubic(_)))
                && !(tree.unit(unit).fits && work.pieces_of(unit).len() == 1)
            {
                *fate = clearance.fate(&piece.curve, unit, 0.0);
            }
        }
    }
    let mut clearance = Clearance::new(work, tree, least);
    let survey = Survey { work, tree, fates: &fates, radius, tolerance: finer };
    let mut stretches = survey.clear_stretches(&mut clearance);
    let short = DEAD_END * (radius * tolerance).sqrt();
    let mut exact = Clearance::new(work, tree, radius - finest.max(ROUNDING));
    let mut reaches = |stretch: &Stretch| {
        fates[stretch.piece] == Fate::Clear || exact.fits_along(stretch, radius)
    };
    remove_dead_ends(work, &mut stretches, short, &mut reaches);
    let mut bridges = Clearance::new(work, tree, radius - BRIDGE_SHARE * tolerance);
    // Short enough for a few places to tell whether a bridge is clear.
    let gap = short.min(0.25 * radius);
    let mut chained = chains(work, &stretches, gap, &mut bridges);
    let stray = STRAY * tolerance;
    if remove_unreached(work, &mut stretches, &chained, stray, whole, &mut reaches) {
        chained = chains(work, &stretches, gap, &mut bridges);
    }
    let mut lost = Vec::new();
    for chain in &chained {
        lost.extend(lost_ends(work, &stretches, chain, whole));
    }
    Strung { stretches, chained, lost }
}
