//! The offset of a spline: cubics within the tolerance of the true equidistant.
//!
//! Each span is cut at the cusps of its offset, where `1 − δκ` changes its sign. A piece is the
//! plain Hermite cubic where that is proved to be within the tolerance, else the collocated one,
//! else the stretch is halved. Next to a cusp, where no proof can hold, the halving ends when
//! offset and piece are shorter than the tolerance. Where the tool does not fit, between two
//! cusps, the offset runs against the curve and the error is measured at sample points instead.

use std::f64::consts::PI;

use glam::DVec2;

use super::Bend;
use super::bend::{Stretch, bends};
use super::cusps::{cusps, room};
use super::fit::Source;
use super::proof::is_proved;
use crate::contour::MoveCurve;
use crate::geometry::{Arc, Cubic, MIN_LENGTH, Spline};

/// Parameters of a piece at which its error is measured where it cannot be proved. The error of a
/// Hermite cubic is `t² (1 − t)²` times a smooth function, so these see its largest value but for
/// a few percent.
const SAMPLES: [f64; 5] = [0.15, 0.32, 0.5, 0.68, 0.85];

/// Part of the tolerance that a measured error may use; the rest is for what lies between the
/// samples.
const SAFETY: f64 = 0.9;

/// Halvings of a stretch until it is taken as it is: 2⁻³⁰ of a span has no inner shape.
const DEEPEST: u32 = 30;

/// Standstills nearer to an end of a span than this are the end.
const AT_END: f64 = 1e-9;

/// The offset of a spline.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::compensation) struct SplineOffset {
    /// Cubics that follow each other, and arcs around cusps of the spline itself.
    pub(in crate::compensation) pieces: Vec<MoveCurve>,
    /// For each span, where its pieces end.
    pub(in crate::compensation) spans: Vec<SpanEnd>,
    /// Where the spline bends tighter than the tool.
    pub(in crate::compensation) bends: Vec<Bend>,
}

/// The end of a span in the list of pieces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(dead_code, reason = "live edits and avoidance look spans up")]
pub(in crate::compensation) struct SpanEnd {
    /// How many pieces there are up to its end.
    pub(in crate::compensation) pieces: u32,
    /// Whether the tool fits all along it.
    pub(in crate::compensation) fits: bool,
}

/// The spline offset by `offset` [mm] to its left, within `tolerance` [mm].
pub(in crate::compensation) fn offset_spline(
    spline: &Spline,
    offset: f64,
    tolerance: f64,
) -> SplineOffset {
    let mut pieces: Vec<MoveCurve> = Vec::with_capacity(spline.pieces().len());
    let mut spans = Vec::with_capacity(spline.pieces().len());
    let mut tight: Vec<Stretch> = Vec::new();
    for (span, cubic) in spline.pieces().iter().enumerate() {
        let before = pieces.last().map(MoveCurve::end);
        let fits = offset_span(cubic, offset, tolerance, before, &mut pieces, &mut |from, to| {
            tight.push(Stretch { span, from, to });
        });
        let pieces = u32::try_from(pieces.len()).unwrap_or(u32::MAX);
        spans.push(SpanEnd { pieces, fits });
    }
    let bends = bends(spline, offset, &tight);
    SplineOffset { pieces, spans, bends }
}

/// Appends the offset of one span, and tells whether the tool fits all along it; where it does not,
/// `tight` is told the range of parameters.
///
/// `before` is where the offset of the span before ends [mm]: where the spline turns back between
/// the two, an arc about that cusp is appended first.
pub(in crate::compensation) fn offset_span(
    cubic: &Cubic,
    offset: f64,
    tolerance: f64,
    mut before: Option<DVec2>,
    pieces: &mut Vec<MoveCurve>,
    tight: &mut dyn FnMut(f64, f64),
) -> bool {
    if offset.abs() <= MIN_LENGTH {
        // No proof tells the two sides of the curve apart, and none is needed.
        pieces.push(MoveCurve::Cubic(*cubic));
        return true;
    }
    let mut all_fit = true;
    each_stretch(cubic, offset, &mut |source, from, to, fits| {
        if !fits {
            all_fit = false;
            tight(from, to);
        }
        let piece = source.hermite();
        if let Some(before) = before {
            join(before, piece.start(), source.cubic.start(), offset, pieces);
        }
        fit(source, &piece, fits, tolerance, 0, pieces);
        before = pieces.last().map(MoveCurve::end).or(before);
    });
    all_fit
}

/// Where the spline bends tighter than a tool at `offset` [mm].
pub(in crate::compensation) fn spline_bends(spline: &Spline, offset: f64) -> Vec<Bend> {
    let mut tight: Vec<Stretch> = Vec::new();
    for (span, cubic) in spline.pieces().iter().enumerate() {
        each_stretch(cubic, offset, &mut |_, from, to, fits| {
            if !fits {
                tight.push(Stretch { span, from, to });
            }
        });
    }
    bends(spline, offset, &tight)
}

/// Visits the stretches of a span between cusps of the offset and standstills of the spline, and
/// tells their ranges of parameters and whether the tool fits there.
fn each_stretch(cubic: &Cubic, offset: f64, visit: &mut dyn FnMut(&Source, f64, f64, bool)) {
    for part in &cut_at_standstill(cubic) {
        let mut from = 0.0;
        for to in cusps(&part.cubic, offset).into_iter().chain([1.0]) {
            let fits = room(&part.cubic, offset, 0.5 * (from + to)) >= 0.0;
            let source = Source { cubic: part.cubic.part(from, to), offset };
            visit(&source, part.at(from), part.at(to), fits);
            from = to;
        }
    }
}

/// A part of a span between two standstills of the spline.
struct Part {
    cubic: Cubic,
    from: f64,
    to: f64,
}

impl Part {
    /// Parameter on the span of `t` on the part.
    fn at(&self, t: f64) -> f64 {
        self.from + (self.to - self.from) * t
    }
}

/// Cuts a cubic where it stands still and turns back, as a spline through type points on one
/// line does that double back; most cubics are left whole.
fn cut_at_standstill(cubic: &Cubic) -> Vec<Part> {
    let whole = || vec![Part { cubic: *cubic, from: 0.0, to: 1.0 }];
    let d = cubic.hodograph();
    let chord = cubic.end() - cubic.start();
    if d.iter().all(|v| v.dot(chord) > 0.0) {
        return whole();
    }
    // |C'|² is least where C' · C'' = 0, a cubic in Bernstein form.
    let (e0, e1) = (d[1] - d[0], d[2] - d[1]);
    let slope = [
        d[0].dot(e0),
        (2.0 * d[1].dot(e0) + d[0].dot(e1)) / 3.0,
        (d[2].dot(e0) + 2.0 * d[1].dot(e1)) / 3.0,
        d[2].dot(e1),
    ];
    let scale = cubic.hull_length();
    let stands = |t: f64| cubic.derivative(t).length() <= 1e-7 * scale;
    let still: Vec<f64> = crate::geometry::roots(&slope)
        .into_iter()
        .filter(|&t| t > AT_END && t < 1.0 - AT_END && stands(t))
        .collect();
    if still.is_empty() {
        return whole();
    }
    let ends = [0.0].into_iter().chain(still).chain([1.0]).collect::<Vec<_>>();
    ends.windows(2).map(|w| Part { cubic: cubic.part(w[0], w[1]), from: w[0], to: w[1] }).collect()
}

/// Appends pieces within `tolerance` of the offset of `source`, of which `hermite` is the plain
/// one. `fits` tells that the tool does, so that a piece can be proved.
fn fit(
    source: &Source,
    hermite: &Cubic,
    fits: bool,
    tolerance: f64,
    depth: u32,
    pieces: &mut Vec<MoveCurve>,
) {
    if let Some(piece) = good_piece(source, hermite, fits, tolerance, depth) {
        if piece.hull_length() >= MIN_LENGTH {
            pieces.push(MoveCurve::Cubic(piece));
        }
        return;
    }
    let (left, right) = source.cubic.split(0.5);
    for half in [left, right] {
        let half = Source { cubic: half, ..*source };
        fit(&half, &half.hermite(), fits, tolerance, depth + 1, pieces);
    }
}

/// One piece for the whole of `source`, if one is good enough.
fn good_piece(
    source: &Source,
    hermite: &Cubic,
    fits: bool,
    tolerance: f64,
    depth: u32,
) -> Option<Cubic> {
    // Piece and offset share their ends, so neither is farther from the other than half of the
    // longer one is long; the offset of a stretch that turns little is about as long as its piece.
    if depth == DEEPEST || hermite.hull_length() <= tolerance {
        return Some(*hermite);
    }
    if !fits {
        return (measured_error(source, hermite) <= SAFETY * tolerance).then_some(*hermite);
    }
    let proved = |piece: &Cubic| is_proved(&source.cubic, piece, source.offset, tolerance);
    // The middle, where the plain piece errs most, spares most proofs that would fail.
    let (error, _) = source.excess(hermite, 0.5)?;
    if error.abs() <= tolerance && proved(hermite) {
        return Some(*hermite);
    }
    source.collocated(hermite).filter(proved)
}

/// Largest measured distance of `piece` from the offset [mm].
fn measured_error(source: &Source, piece: &Cubic) -> f64 {
    SAMPLES.into_iter().map(|t| source.distance(piece, t)).fold(0.0, f64::max)
}

/// Joins the offsets before and behind a cusp of the spline itself, where its tangent turns back:
/// half a circle about the cusp, on the outside, so that nothing is gouged.
fn join(from: DVec2, to: DVec2, cusp: DVec2, offset: f64, pieces: &mut Vec<MoveCurve>) {
    // Neighbouring spans differ by rounding only.
    if from.distance(to) > offset.abs() {
        let sweep = if offset > 0.0 { -PI } else { PI };
        if let Ok(arc) = Arc::from_center(from, to, cusp, sweep < 0.0, f64::INFINITY) {
            pieces.push(MoveCurve::Arc(arc));
        }
    }
}
