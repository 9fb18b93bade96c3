//! One segment of a contour that is edited, and where its offset begins and ends.

use glam::DVec2;

use crate::compensation::Options;
use crate::compensation::offset::offset_span;
use crate::compensation::run::{Run, part, reversed, with_start};
use crate::compensation::transition::Terminal;
use crate::contour::{Attributes, MoveCurve, Segment, Tool};
use crate::geometry::{Bounds, Cubic, Curve, SplineEdit, perp};

/// Length of a control vector of a cubic's derivative, as a part of its polygon, up to which it may
/// stand still and turn back.
const STANDS_STILL: f64 = 1e-5;

/// A segment.
#[derive(Debug, Clone)]
pub(super) enum Part {
    /// A line, an arc or an involute.
    Plain(Segment),
    /// A spline whose points can be moved one by one.
    Spline(SplineEdit, Attributes),
}

/// A place on the offset of a part; anything but a spline is a single span.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Spot {
    pub(super) span: usize,
    /// How many pieces of the span follow.
    pub(super) back: usize,
    /// Parameter on the piece.
    pub(super) t: f64,
}

impl Spot {
    fn is_before(&self, other: &Self) -> bool {
        if self.span != other.span {
            return self.span < other.span;
        }
        // The more pieces follow, the earlier it is.
        self.back > other.back || (self.back == other.back && self.t < other.t)
    }
}

/// How the offset of a part begins or ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum End {
    /// With all of it.
    Whole,
    /// At a place on it, the point of which is told [mm].
    At(Spot, DVec2),
    /// At a point on or beyond a straight one [mm].
    To(DVec2),
    /// Moved by a rounding to where the neighbour ends [mm].
    Moved(DVec2),
}

impl Part {
    pub(super) fn new(segment: Segment) -> Self {
        match &segment.curve {
            Curve::Spline(spline) => Self::Spline(SplineEdit::new(spline), segment.attributes),
            Curve::Line(_) | Curve::Arc(_) | Curve::Involute(_) => Self::Plain(segment),
        }
    }

    /// Number of spans.
    pub(super) fn spans(&self) -> usize {
        match self {
            Self::Plain(_) => 1,
            Self::Spline(spline, _) => spline.spans(),
        }
    }

    /// Some of its spans as a segment of their own.
    pub(super) fn section(&self, first: usize, count: usize) -> Segment {
        match self {
            Self::Plain(segment) => segment.clone(),
            Self::Spline(spline, attributes) => {
                let curve = Curve::Spline(spline.part(first, count));
                Segment { curve, attributes: *attributes }
            }
        }
    }

    /// Unit tangent at its start (0) or end (1), if it is no spline.
    pub(super) fn plain_tangent(&self, at_end: f64) -> Option<DVec2> {
        match self {
            Self::Plain(segment) => Some(segment.curve.tangent(at_end)),
            Self::Spline(..) => None,
        }
    }

    /// A box around some spans.
    pub(super) fn bounds(&self, first: usize, count: usize) -> Bounds {
        match self {
            Self::Plain(segment) => segment.curve.bounds(),
            Self::Spline(spline, _) => {
                let mut bounds = Bounds::EMPTY;
                for span in first..first + count {
                    bounds = bounds.union(spline.cubic(span).hull_bounds());
                }
                bounds
            }
        }
    }

    /// A box around the whole offset of some spans, and of the ways round the ends of the part.
    pub(super) fn reach(
        &self,
        first: usize,
        count: usize,
        tool: Tool,
        options: &Options,
    ) -> Bounds {
        let mut bounds = Bounds::EMPTY;
        let ends = match self {
            Self::Plain(segment) => {
                bounds = MoveCurve::hulls(&Run::new(segment, tool, options).pieces);
                [segment.curve.start(), segment.curve.end()]
            }
            Self::Spline(spline, _) => {
                for span in first..first + count {
                    bounds = bounds.union(beside(&spline.cubic(span), tool.offset()));
                }
                bounds = bounds.inflated(options.usable_tolerance());
                [first, first + count].map(|point| spline.points()[point])
            }
        };
        let at_ends = [first == 0, first + count == self.spans()];
        for (end, _) in ends.into_iter().zip(at_ends).filter(|(_, at_end)| *at_end) {
            // The straight way round a corner reaches out to √2 times the radius.
            bounds = bounds.union(Bounds::of([end]).inflated(1.5 * tool.radius()));
        }
        bounds
    }

    /// Appends the polyline of some spans.
    pub(super) fn outline(&self, first: usize, count: usize, pen: &mut Pen) {
        match self {
            Self::Plain(segment) => pen.programmed(&segment.curve),
            Self::Spline(spline, _) => {
                for span in first..first + count {
                    pen.curve(&MoveCurve::Cubic(spline.cubic(span)));
                }
            }
        }
    }

    /// Appends the polyline of the offset of some spans between two ends.
    pub(super) fn offset(
        &self,
        [first, count]: [usize; 2],
        [start, end]: [End; 2],
        tool: Tool,
        options: &Options,
        pen: &mut Pen,
    ) {
        let before = pen.vertices.len();
        match self {
            Self::Plain(segment) => {
                let run = Run::new(segment, tool, options);
                let last = run.pieces.len().saturating_sub(1);
                let terminal = |end| match end {
                    End::Whole => Terminal::Whole,
                    End::To(point) => Terminal::To(point),
                    End::Moved(point) => Terminal::Moved(point),
                    End::At(Spot { back, t, .. }, _) => {
                        let piece = last.saturating_sub(back);
                        Terminal::At(crate::compensation::transition::Place { piece, t })
                    }
                };
                let (moves, _) = run.between(terminal(start), terminal(end));
                for piece in &moves {
                    pen.curve(piece);
                }
                if pen.vertices.len() == before {
                    // It has come to a point.
                    pen.to(match start {
                        End::At(_, point) | End::To(point) | End::Moved(point) => point,
                        End::Whole => run.ends[0],
                    });
                }
            }
            Self::Spline(spline, _) => {
                let spans = [first, count];
                let rest = offset_spans(spline, spans, [start, end], tool, options, pen);
                if pen.vertices.len() == before {
                    pen.to(rest);
                }
            }
        }
    }
}

/// A box around the offset of a cubic.
///
/// Its tangents lie between the control vectors of its derivative. Where those are less than 90° apart
/// unit vectors between two of them, at the angle φ, bulge by `1 − cos (φ/2) ≤ (1 − cos φ) / 2` beyond
/// their chord. Where the cubic may turn back, or nearly stand still, there may be an arc about it.
fn beside(cubic: &Cubic, offset: f64) -> Bounds {
    let hull = cubic.hull_bounds();
    let vectors = cubic.hodograph();
    let lengths = vectors.map(DVec2::length);
    let [n0, n1, n2] = [0, 1, 2].map(|i| perp(vectors[i]) * (offset / lengths[i]));
    let squared = offset * offset;
    let least = n0.dot(n1).min(n1.dot(n2)).min(n2.dot(n0)) / squared;
    let stands = lengths.iter().any(|&length| length <= STANDS_STILL * cubic.hull_length());
    if stands || least.is_nan() || least <= 0.0 {
        return hull.inflated(offset.abs());
    }
    let bulge = 0.5 * (1.0 - least) * offset.abs();
    let Bounds { min, max } = Bounds::of([n0, n1, n2]).inflated(bulge);
    Bounds { min: hull.min + min, max: hull.max + max }
}

/// Appends the polyline of the offset of some spans of a spline, as far as it lies between its
/// ends. Where it does not, the path rests at the point that is returned.
fn offset_spans(
    spline: &SplineEdit,
    [first, count]: [usize; 2],
    [start, end]: [End; 2],
    tool: Tool,
    options: &Options,
    pen: &mut Pen,
) -> DVec2 {
    let (offset, tolerance) = (tool.offset(), options.usable_tolerance());
    let at = |end| if let End::At(spot, point) = end { Some((spot, point)) } else { None };
    let (mut from, mut to) = (at(start), at(end));
    let rest = match (from, to) {
        (Some((spot, point)), _) if first <= spot.span => point,
        (_, Some((_, point))) => point,
        _ => {
            let cubic = spline.cubic(first);
            cubic.start() + perp(cubic.tangent(0.0)) * offset
        }
    };
    let backwards = from.zip(to).is_some_and(|((from, _), (to, _))| to.is_before(&from));
    let mut spans = first..first + count;
    if backwards {
        // What its corners leave of it runs backwards; the first block has all of it.
        if let (Some((_, point)), true) = (to, first > 0) {
            return point;
        }
        (from, to) = (to, from);
        spans = 0..spline.spans();
    }
    let (from, to) = (from.map(|(spot, _)| spot), to.map(|(spot, _)| spot));
    let skipped = from.map_or(0, |spot| spot.span);
    spans.start = spans.start.max(skipped);
    spans.end = spans.end.min(to.map_or(usize::MAX, |spot| spot.span + 1));
    let mut before = (spans.start > 0).then(|| {
        let cubic = spline.cubic(spans.start - 1);
        cubic.end() + perp(cubic.tangent(1.0)) * offset
    });
    let mut kept: Vec<MoveCurve> = Vec::new();
    let mut pieces: Vec<MoveCurve> = Vec::new();
    for span in spans {
        pieces.clear();
        let cubic = spline.cubic(span);
        offset_span(&cubic, offset, tolerance, before, &mut pieces, &mut |_, _| {});
        before = pieces.last().map(MoveCurve::end).or(before);
        let count = pieces.len();
        for (i, piece) in pieces.iter().enumerate() {
            let here = |t| Spot { span, back: count - 1 - i, t };
            let (low, high) = (from.unwrap_or(here(0.0)), to.unwrap_or(here(1.0)));
            if here(1.0).is_before(&low) || high.is_before(&here(0.0)) {
                continue;
            }
            let t = |spot: Spot, whole: f64| {
                if spot.span == span && spot.back == count - 1 - i { spot.t } else { whole }
            };
            if let Some(mut piece) = part(piece, t(low, 0.0), t(high, 1.0)) {
                if let (End::Moved(point), true) = (start, span == 0 && kept.is_empty()) {
                    piece = with_start(&piece, point);
                }
                kept.push(piece);
            }
        }
    }
    if backwards {
        kept.reverse();
        for piece in &mut kept {
            *piece = reversed(piece);
        }
    }
    for piece in &kept {
        pen.curve(piece);
    }
    rest
}

/// Draws polylines.
#[derive(Debug)]
pub(super) struct Pen {
    /// Largest distance of a chord from its curve [mm].
    pub(super) chord: f64,
    pub(super) vertices: Vec<DVec2>,
}

impl Pen {
    /// A straight line to a point, or the first vertex.
    pub(super) fn to(&mut self, point: DVec2) {
        if self.vertices.last() != Some(&point) {
            self.vertices.push(point);
        }
    }

    /// A curve of a contour.
    pub(super) fn programmed(&mut self, curve: &Curve) {
        self.to(curve.start());
        let vertices = &mut self.vertices;
        curve.flatten(self.chord, &mut |p| vertices.push(p));
    }

    /// A curve, and what leads to it.
    pub(super) fn curve(&mut self, curve: &MoveCurve) {
        self.to(curve.start());
        let vertices = &mut self.vertices;
        curve.flatten(self.chord, &mut |p| vertices.push(p));
    }
}
