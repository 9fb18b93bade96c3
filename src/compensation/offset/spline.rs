//! The offset of a spline: cubics within the tolerance of the true equidistant.
//!
//! Each span is cut at the cusps of its offset, where `1 − δκ` changes its sign. A piece is the
//! plain Hermite cubic where that is proved to be within the tolerance, else the collocated one,
//! else the stretch is halved.

use glam::DVec2;

use super::Bend;
use super::bend::{Stretch, bends};
use super::cusps::{cusps, room};
use super::fit::{End, Source, hermite};
use super::proof::Speed;
use crate::contour::MoveCurve;
use crate::geometry::{Arc, Cubic, MIN_LENGTH, Spline};

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
}

/// The end of a span in the list of pieces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
    for cubic in spline.pieces() {
        let before = pieces.last().map(MoveCurve::end);
        let fits = offset_span(cubic, offset, tolerance, before, &mut pieces, &mut |_, _| {});
        let pieces = u32::try_from(pieces.len()).unwrap_or(u32::MAX);
        spans.push(SpanEnd { pieces, fits });
    }
    SplineOffset { pieces, spans }
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
    before: Option<DVec2>,
    pieces: &mut Vec<MoveCurve>,
    tight: &mut dyn FnMut(f64, f64),
) -> bool {
    let tolerance = Tolerances::even(tolerance);
    each_piece(cubic, offset, tolerance, before, tight, &mut |_, _, piece| pieces.push(piece))
        != Fit::No
}

/// Whether the tool fits all along a span.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Fit {
    /// It does, as quick bounds tell.
    Clearly,
    /// It does, but only a closer look told.
    Barely,
    /// It does not.
    No,
}

/// How near pieces are to the offset [mm].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::compensation) struct Tolerances {
    /// Along spans that the tool fits all along.
    pub(in crate::compensation) fitting: f64,
    /// Where it fits on other spans, as a part of their length where that is more.
    pub(in crate::compensation) roughness: f64,
    /// Where it does not fit; infinite where any piece will do.
    pub(in crate::compensation) tight: f64,
}

impl Tolerances {
    /// The same everywhere.
    pub(in crate::compensation) fn even(tolerance: f64) -> Self {
        Self { fitting: tolerance, roughness: 0.0, tight: tolerance }
    }

    /// Where the tool fits on a span along which it does not fit all along [mm].
    pub(in crate::compensation) fn beside_cusps(&self, cubic: &Cubic) -> f64 {
        self.fitting.max(self.roughness * cubic.hull_length())
    }
}

/// [`offset_span`] for a path that is going to be cut: what is cut out need not be near.
pub(in crate::compensation) fn offset_span_roughly(
    cubic: &Cubic,
    offset: f64,
    tolerances: Tolerances,
    before: Option<DVec2>,
    pieces: &mut Vec<MoveCurve>,
) -> bool {
    let from = pieces.len();
    let mut emit = |_: &Source, _, piece| pieces.push(piece);
    let fit = each_piece(cubic, offset, tolerances, before, &mut |_, _| {}, &mut emit);
    if fit == Fit::Barely && tolerances.beside_cusps(cubic) > tolerances.fitting {
        // There are no cusps after all.
        pieces.truncate(from);
        return offset_span(cubic, offset, tolerances.fitting, before, pieces, &mut |_, _| {});
    }
    fit != Fit::No
}

/// Calls `emit` with every piece of the offset of one span, what it is the offset of, and the range
/// of parameters of that; the rest is as in [`offset_span`].
pub(super) fn each_piece(
    cubic: &Cubic,
    offset: f64,
    tolerances: Tolerances,
    mut before: Option<DVec2>,
    tight: &mut dyn FnMut(f64, f64),
    emit: &mut Emit,
) -> Fit {
    let whole = Source::new(*cubic, offset);
    if offset.abs() <= MIN_LENGTH {
        // No proof tells the two sides of the curve apart, and none is needed.
        emit(&whole, [0.0, 1.0], MoveCurve::Cubic(*cubic));
        return Fit::Clearly;
    }
    let mut append = |source: &Source, range: [f64; 2], fits: bool, tolerance: f64| {
        let ends = [source.end(0.0), source.end(1.0)];
        let arc = before.and_then(|b| join(b, ends[0].point, source.cubic.start(), offset));
        if let Some(arc) = arc {
            emit(source, [range[0]; 2], MoveCurve::Arc(arc));
        }
        let effort = Effort { fits, tolerance, depth: 0 };
        fit(source, range, ends, effort, &mut |source, range, piece| {
            before = Some(piece.end());
            emit(source, range, piece);
        });
    };
    if whole.speed.surely_fits(offset) {
        append(&whole, [0.0, 1.0], true, tolerances.fitting);
        return Fit::Clearly;
    }
    let beside_cusps = tolerances.beside_cusps(cubic);
    let mut all_fit = true;
    each_stretch(cubic, offset, &mut |source, from, to, fits| {
        if !fits {
            all_fit = false;
            tight(from, to);
        }
        let tolerance = if fits { beside_cusps } else { tolerances.tight };
        append(source, [from, to], fits, tolerance);
    });
    if all_fit { Fit::Barely } else { Fit::No }
}

/// What takes the pieces.
type Emit<'a> = dyn FnMut(&Source, [f64; 2], MoveCurve) + 'a;

/// What is to be achieved on a stretch.
#[derive(Debug, Clone, Copy)]
struct Effort {
    /// Whether the tool fits, so that the collocated piece is worth a try.
    fits: bool,
    /// [mm]
    tolerance: f64,
    /// How often the stretch has been halved.
    depth: u32,
}

/// Where the spline bends tighter than a tool at `offset` [mm].
pub(in crate::compensation) fn spline_bends(spline: &Spline, offset: f64) -> Vec<Bend> {
    let mut tight: Vec<Stretch> = Vec::new();
    for (span, cubic) in spline.pieces().iter().enumerate() {
        if Speed::new(cubic.hodograph()).surely_fits(offset) {
            continue;
        }
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
    let whole = [Part { cubic: *cubic, from: 0.0, to: 1.0 }];
    let parts = cut_at_standstill(cubic);
    for part in if parts.is_empty() { &whole[..] } else { &parts } {
        let whole = Source::new(part.cubic, offset);
        let mut from = 0.0;
        for to in cusps(&part.cubic, offset).into_iter().chain([1.0]) {
            let fits = room(&part.cubic, offset, 0.5 * (from + to)) >= 0.0;
            visit(&whole.part(from, to), part.at(from), part.at(to), fits);
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
/// line does that double back; no parts of those that do not, as most.
fn cut_at_standstill(cubic: &Cubic) -> Vec<Part> {
    let d = cubic.hodograph();
    let chord = cubic.end() - cubic.start();
    if d.iter().all(|v| v.dot(chord) > 0.0) {
        return Vec::new();
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
    let (mut parts, mut from) = (Vec::new(), 0.0);
    for t in crate::geometry::roots(&slope) {
        if t > AT_END && t < 1.0 - AT_END && stands(t) {
            parts.push(Part { cubic: cubic.part(from, t), from, to: t });
            from = t;
        }
    }
    if !parts.is_empty() {
        parts.push(Part { cubic: cubic.part(from, 1.0), from, to: 1.0 });
    }
    parts
}

/// Emits pieces within the tolerance of the offset of `source`, which has the given ends.
fn fit(source: &Source, range: [f64; 2], ends: [End; 2], effort: Effort, emit: &mut Emit) {
    if let Some(piece) = good_piece(source, &hermite(ends), effort) {
        let chord = piece.end() - piece.start();
        if chord.length_squared() > MIN_LENGTH * MIN_LENGTH || piece.hull_length() >= MIN_LENGTH {
            emit(source, range, MoveCurve::Cubic(piece));
        }
        return;
    }
    let [left, right] = source.halves();
    let at = 0.5 * (range[0] + range[1]);
    let middle = source.end(0.5).of_half();
    let (start, end) = (ends[0].of_half(), ends[1].of_half());
    let effort = Effort { depth: effort.depth + 1, ..effort };
    fit(&left, [range[0], at], [start, middle], effort, emit);
    fit(&right, [at, range[1]], [middle, end], effort, emit);
}

/// One piece for the whole of `source`, if one is good enough.
fn good_piece(source: &Source, hermite: &Cubic, effort: Effort) -> Option<Cubic> {
    let tolerance = effort.tolerance;
    if tolerance == f64::INFINITY
        || source.compared(hermite).at_same_parameter() <= tolerance
        || effort.depth == DEEPEST
        || source.by_length(hermite) <= tolerance
    {
        return Some(*hermite);
    }
    if !effort.fits {
        return None;
    }
    source.collocated(hermite).filter(|piece| source.compared(piece).at_feet(1) <= tolerance)
}

/// The way from the offset before to that behind a cusp of the spline itself, where its tangent
/// turns back: half a circle about the cusp, on the outside, so that nothing is gouged.
fn join(from: DVec2, to: DVec2, cusp: DVec2, offset: f64) -> Option<Arc> {
    // Neighbouring spans differ by rounding only.
    if from.distance(to) <= offset.abs() {
        return None;
    }
    Arc::from_center(from, to, cusp, offset > 0.0, f64::INFINITY).ok()
}
