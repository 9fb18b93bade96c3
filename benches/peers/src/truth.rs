//! Pieces and true errors of offsets, beside kurbo's, from at least 1e5 samples of each curve in
//! twice the digits.

use g41::compensation::{compensate, proved_offset};
use g41::contour::{MoveCurve, ToolPath};
use g41::geometry::Spline;
use glam::DVec2;

use crate::competitors::{kurbo_cubics, kurbo_offset};
use crate::curves::{Sample, options, spiral, tool, wave};
use crate::equidistant::{Bezier, Equidistant, Foot};

const TOLERANCES: [f64; 3] = [1e-3, 1e-6, 1e-9];

/// Samples of a curve in all, and least samples of a piece.
const SAMPLES: usize = 100_000;
const LEAST: usize = 16;

/// What is known of one way of offsetting a curve.
#[derive(Debug, Clone, Copy)]
pub struct Verdict {
    pub pieces: usize,
    /// Largest error [mm].
    pub error: f64,
}

/// The curve of a move as a cubic; arcs and involutes do not come up on curves without corners.
fn bezier(curve: &MoveCurve) -> Option<Bezier> {
    match curve {
        MoveCurve::Line(line) => {
            let [a, b] = [line.start(), line.end()];
            Some([a, a.lerp(b, 1.0 / 3.0), a.lerp(b, 2.0 / 3.0), b])
        }
        MoveCurve::Cubic(cubic) => Some(cubic.points),
        MoveCurve::Arc(_) | MoveCurve::Involute(_) | MoveCurve::Vertical(_) => None,
    }
}

fn judge(path: &ToolPath, spans: &[Bezier], sample: &Sample, radius: f64, doubt: f64) -> Verdict {
    let truth = Equidistant { spans, offset: radius, closed: sample.closed, doubt };
    let each = (SAMPLES / path.moves.len().max(1)).max(LEAST);
    let mut foot = Foot { span: 0, t: 0.0 };
    let mut end: Option<DVec2> = None;
    let mut error: f64 = 0.0;
    for one in &path.moves {
        let Some(piece) = bezier(&one.curve) else {
            error = f64::INFINITY;
            continue;
        };
        // After a part that was cut out the path goes on elsewhere.
        if end.is_none_or(|end| end.distance(piece[0]) > 1e-6) {
            foot = truth.find(piece[0], foot.span, 1e-2);
        }
        let mut next = foot;
        let mut off = truth.error(&piece, each, &mut next);
        // Where a loop was cut out within a chain the foot jumps though the path does not.
        if off > 1e-2 {
            let mut fresh = truth.find(piece[0].lerp(piece[3], 0.5), foot.span, 1e-2);
            off = truth.error(&piece, each, &mut fresh);
            next = fresh;
        }
        foot = next;
        error = error.max(off);
        end = Some(piece[3]);
    }
    Verdict { pieces: path.moves.len(), error }
}

fn judge_kurbo(
    spline: &Spline,
    spans: &[Bezier],
    radius: f64,
    tolerance: f64,
    doubt: f64,
) -> Verdict {
    let mut verdict = Verdict { pieces: 0, error: 0.0 };
    let each = (SAMPLES / spans.len()).max(LEAST);
    for (index, cubic) in kurbo_cubics(spline).into_iter().enumerate() {
        let truth =
            Equidistant { spans: &spans[index..=index], offset: radius, closed: false, doubt };
        let mut foot = Foot { span: 0, t: 0.0 };
        for piece in kurbo_offset(cubic, radius, tolerance) {
            verdict.pieces += 1;
            verdict.error = verdict.error.max(truth.error(&piece.points, each, &mut foot));
        }
    }
    verdict
}

/// Pieces whose bounds are looked at, evenly spread over the curve, and samples of each.
const BOUNDED: usize = 4_000;
const SAMPLES_OF_BOUNDED: usize = 200;

/// How the proved bounds of pieces compare with their true errors.
#[derive(Debug, Clone, Copy)]
struct Bounds {
    /// Largest bound [mm].
    largest: f64,
    /// Least and median quotient of bound and true error.
    least: f64,
    median: f64,
    /// Pieces without a bound.
    unproved: usize,
}

fn bounds(spline: &Spline, spans: &[Bezier], radius: f64, tolerance: f64) -> Bounds {
    let pieces = proved_offset(spline, radius, tolerance);
    let mut quotients = Vec::new();
    for proved in pieces.iter().step_by(pieces.len().div_ceil(BOUNDED)) {
        let Some(piece) = bezier(&proved.curve) else { continue };
        let span = &spans[proved.span..=proved.span];
        let truth = Equidistant { spans: span, offset: radius, closed: false, doubt: proved.bound };
        let mut foot = Foot { span: 0, t: proved.from };
        let error = truth.error(&piece, SAMPLES_OF_BOUNDED, &mut foot);
        // The feet are f64s, and so are the control points that the piece was rounded to.
        let reach = piece[0].abs().max_element() + radius;
        if error > 1e-14 * reach {
            quotients.push(proved.bound / error);
        }
    }
    quotients.sort_by(f64::total_cmp);
    let bounds = pieces.iter().map(|piece| piece.bound);
    Bounds {
        largest: bounds.clone().filter(|bound| bound.is_finite()).fold(0.0, f64::max),
        least: quotients.first().copied().unwrap_or(f64::NAN),
        median: quotients.get(quotients.len() / 2).copied().unwrap_or(f64::NAN),
        unproved: bounds.filter(|bound| !bound.is_finite()).count(),
    }
}

/// Prints a row for each curve, radius and tolerance; `largest` leaves out longer curves.
pub fn table(largest: usize) {
    println!("pieces per type point (largest true error in tolerances)");
    println!(
        "bound: the largest in tolerances; then bound / true error of a piece, least and median"
    );
    println!(
        "| curve, r, tolerance | g41 offset | kurbo | g41 without loops | bound | least | median |"
    );
    println!("| --- | --- | --- | --- | --- | --- | --- |");
    for make in [wave, spiral] {
        for n in [100, 1_000, 10_000, 100_000].into_iter().filter(|n| *n <= largest) {
            let sample = make(n);
            for (loops, radius) in sample.radii.into_iter().enumerate() {
                for tolerance in TOLERANCES {
                    row(&sample, loops == 1, radius, tolerance);
                }
            }
        }
    }
}

fn row(sample: &Sample, loops: bool, radius: f64, tolerance: f64) {
    let contour = sample.contour();
    let spline = sample.spline();
    let spans: Vec<Bezier> = spline.pieces().iter().map(|piece| piece.points).collect();
    let farthest = sample.points.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    // Coordinates have no digits left for a finer one.
    let held = tolerance.max(1e-11 * (farthest + radius));
    let cell = |verdict: Verdict| {
        let each = verdict.pieces as f64 / sample.count as f64;
        let kept = if verdict.error <= held { "" } else { " ✗" };
        format!("{each:.3} ({:.3}){kept}", verdict.error / held)
    };
    let raw = compensate(&contour, tool(radius), &options(tolerance));
    let ours = judge(&raw, &spans, sample, radius, held);
    let theirs = judge_kurbo(&spline, &spans, radius, tolerance, held);
    let avoided = judge(&sample.avoided(radius, tolerance), &spans, sample, radius, held);
    let proved = bounds(&spline, &spans, radius, held);
    let more = ours.pieces > theirs.pieces && theirs.error <= held && !loops;
    println!(
        "| {} {}, {radius}, {tolerance:e}{} | {}{} | {} | {} | {:.3}{} | {:.3} | {:.3} |",
        sample.name,
        sample.count,
        if held > tolerance { format!(" (held {held:.1e})") } else { String::new() },
        cell(ours),
        if more { " more" } else { "" },
        cell(theirs),
        cell(avoided),
        proved.largest / held,
        if proved.unproved > 0 { format!(", {} unproved", proved.unproved) } else { String::new() },
        proved.least,
        proved.median,
    );
}
