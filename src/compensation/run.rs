//! A run: one segment with its offset, ready to be joined to its neighbours.

use glam::DVec2;

use super::offset::{
    ArcOffset, Bend, SpanEnd, involute_bend, offset_arc, offset_line, offset_spline, spline_bends,
};
use super::transition::{Place, Terminal};
use super::type_points::Polygon;
use super::{Options, SplineMethod};
use crate::contour::{MoveCurve, Segment, Tool};
use crate::geometry::{Arc, Curve, Line, MIN_LENGTH};

/// One segment with its offset.
#[derive(Debug, Clone)]
pub(super) struct Run<'a> {
    pub(super) segment: &'a Segment,
    /// The whole offset, in order; empty where it is a single point. For type points it stands
    /// for the ends of the spline: the equidistants of its first and last leg.
    pub(super) pieces: Vec<MoveCurve>,
    /// For each span of a spline, where its pieces end; empty for anything else.
    pub(super) spans: Vec<SpanEnd>,
    /// Ends of the whole offset [mm].
    pub(super) ends: [DVec2; 2],
    /// Unit tangents at both ends that decide about corners.
    pub(super) tangents: [DVec2; 2],
    /// Curvatures there [1/mm].
    pub(super) curvatures: [f64; 2],
    /// The polygon of type points, where those are what is moved.
    pub(super) polygon: Option<Polygon<'a>>,
}

impl<'a> Run<'a> {
    pub(super) fn new(segment: &'a Segment, tool: Tool, options: &Options) -> Self {
        let curve = &segment.curve;
        let offset = tool.offset();
        let mut tangents = [curve.tangent(0.0), curve.tangent(1.0)];
        let mut curvatures = [curve.curvature(0.0), curve.curvature(1.0)];
        let mut polygon = None;
        let mut spans = Vec::new();
        let pieces = match curve {
            Curve::Line(line) => one(offset_line(line, offset).map(MoveCurve::Line)),
            Curve::Arc(arc) => match offset_arc(arc, offset) {
                ArcOffset::Arc(arc) | ArcOffset::Reversed(arc, _) => vec![MoveCurve::Arc(arc)],
                ArcOffset::Point => Vec::new(),
            },
            Curve::Involute(involute) => {
                let mut pieces = Vec::with_capacity(2);
                involute.offset(offset, &mut |piece| pieces.push(MoveCurve::Involute(piece)));
                pieces
            }
            // One of given cubics has no type points to move.
            Curve::Spline(spline)
                if options.spline == SplineMethod::TypePoints && spline.is_through_points() =>
            {
                let legs = Polygon::new(spline, tool);
                tangents = legs.tangents();
                curvatures = [0.0, 0.0];
                polygon = Some(legs);
                Vec::new()
            }
            Curve::Spline(spline) => {
                let whole = offset_spline(spline, offset, options.usable_tolerance());
                spans = whole.spans;
                whole.pieces
            }
        };
        let end = |point: DVec2, tangent: DVec2| point + crate::geometry::perp(tangent) * offset;
        let mut ends = [end(curve.start(), tangents[0]), end(curve.end(), tangents[1])];
        // What the pieces really end at differs by a rounding, and moves must follow each other.
        if let (Some(first), Some(last)) = (pieces.first(), pieces.last()) {
            ends = [first.start(), last.end()];
        }
        Self { segment, pieces, spans, ends, tangents, curvatures, polygon }
    }

    /// Whether its offset is one straight line, which a corner may run on.
    pub(super) fn is_straight(&self) -> bool {
        matches!(self.segment.curve, Curve::Line(_))
    }

    /// The stretches that bend tighter than a tool at `offset` [mm].
    pub(super) fn bends(&self, offset: f64) -> Vec<Bend> {
        match &self.segment.curve {
            Curve::Arc(arc) => match offset_arc(arc, offset) {
                ArcOffset::Reversed(_, bend) => vec![bend],
                ArcOffset::Arc(_) | ArcOffset::Point => Vec::new(),
            },
            Curve::Spline(spline)
                if self.polygon.is_some() || !self.spans.iter().all(|span| span.fits) =>
            {
                spline_bends(spline, offset)
            }
            Curve::Involute(involute) => involute_bend(involute, offset).into_iter().collect(),
            Curve::Line(_) | Curve::Spline(_) => Vec::new(),
        }
    }

    /// Whether nothing is cut off or run on between two terminals, and the start is moved by no more
    /// than a rounding.
    pub(super) fn is_whole(&self, start: Terminal, end: Terminal) -> bool {
        let starts = match start {
            Terminal::Whole => true,
            Terminal::Moved(point) => point.distance(self.ends[0]) <= MIN_LENGTH,
            Terminal::To(_) | Terminal::At(_) => false,
        };
        starts && matches!(end, Terminal::Whole) && !self.is_straight() && !self.pieces.is_empty()
    }

    /// The offset between two terminals. The flag tells whether it came out running backwards:
    /// the terminals have passed each other.
    pub(super) fn between(&self, start: Terminal, end: Terminal) -> (Vec<MoveCurve>, bool) {
        if self.is_straight() {
            return self.straight_between(start, end);
        }
        let (from, to) = (self.place(start, 0), self.place(end, 1));
        let Some((from, to)) = from.zip(to) else { return (Vec::new(), false) };
        let backwards = to < from;
        let (low, high) = if backwards { (to, from) } else { (from, to) };
        let mut moves = Vec::with_capacity(high.piece + 1 - low.piece);
        for i in low.piece..=high.piece {
            let t0 = if i == low.piece { low.t } else { 0.0 };
            let t1 = if i == high.piece { high.t } else { 1.0 };
            moves.extend(part(&self.pieces[i], t0, t1));
        }
        if backwards {
            moves.reverse();
            for piece in &mut moves {
                *piece = reversed(piece);
            }
        }
        if let (Terminal::Moved(point), Some(first)) = (start, moves.first_mut()) {
            *first = with_start(first, point);
        }
        (moves, backwards)
    }

    fn straight_between(&self, start: Terminal, end: Terminal) -> (Vec<MoveCurve>, bool) {
        let point = |terminal, whole| match terminal {
            Terminal::To(point) | Terminal::Moved(point) => point,
            Terminal::Whole | Terminal::At(_) => whole,
        };
        let (from, to) = (point(start, self.ends[0]), point(end, self.ends[1]));
        let backwards = (to - from).dot(self.tangents[0]) < 0.0;
        (one(Line::new(from, to).ok().map(MoveCurve::Line)), backwards)
    }

    /// Where on the pieces a terminal stands; `None` where there are no pieces.
    fn place(&self, terminal: Terminal, end: usize) -> Option<Place> {
        let last = self.pieces.len().checked_sub(1)?;
        Some(match (terminal, end) {
            (Terminal::At(place), _) => place,
            (_, 0) => Place { piece: 0, t: 0.0 },
            (_, _) => Place { piece: last, t: 1.0 },
        })
    }
}

/// A list of one piece, or none.
fn one(piece: Option<MoveCurve>) -> Vec<MoveCurve> {
    match piece {
        Some(piece) => vec![piece],
        None => Vec::new(),
    }
}

/// The part of a piece between two parameters; for an arc they may lie beyond its ends.
pub(super) fn part(piece: &MoveCurve, from: f64, to: f64) -> Option<MoveCurve> {
    if from == 0.0 && to == 1.0 {
        return Some(*piece);
    }
    match piece {
        MoveCurve::Line(line) => {
            Line::new(line.point(from), line.point(to)).ok().map(MoveCurve::Line)
        }
        MoveCurve::Arc(arc) => {
            let sweep = arc.sweep() * (to - from);
            Arc::from_sweep(arc.point(from), arc.center(), sweep).ok().map(MoveCurve::Arc)
        }
        MoveCurve::Cubic(cubic) => {
            let part = cubic.part(from, to);
            (part.hull_length() >= MIN_LENGTH).then_some(MoveCurve::Cubic(part))
        }
        MoveCurve::Involute(involute) => involute.part(from, to).map(MoveCurve::Involute),
        MoveCurve::Vertical(_) => None,
    }
}

pub(super) fn reversed(piece: &MoveCurve) -> MoveCurve {
    match piece {
        MoveCurve::Line(line) => MoveCurve::Line(line.reversed()),
        MoveCurve::Arc(arc) => MoveCurve::Arc(arc.reversed()),
        MoveCurve::Cubic(cubic) => MoveCurve::Cubic(cubic.reversed()),
        MoveCurve::Involute(involute) => MoveCurve::Involute(involute.reversed()),
        MoveCurve::Vertical(at) => MoveCurve::Vertical(*at),
    }
}

/// The piece with its start moved by a rounding, its end kept.
pub(super) fn with_start(piece: &MoveCurve, start: DVec2) -> MoveCurve {
    let moved = match piece {
        MoveCurve::Line(line) => Line::new(start, line.end()).ok().map(MoveCurve::Line),
        MoveCurve::Arc(arc) if arc.is_full_circle() => {
            Arc::from_sweep(start, arc.center(), arc.sweep()).ok().map(MoveCurve::Arc)
        }
        MoveCurve::Arc(arc) => {
            let clockwise = arc.is_clockwise();
            Arc::from_center(start, arc.end(), arc.center(), clockwise, f64::INFINITY)
                .ok()
                // An arc shorter than the move would come out as nearly a full circle.
                .filter(|moved| (moved.sweep() - arc.sweep()).abs() < 1.0)
                .map(MoveCurve::Arc)
                .or_else(|| Line::new(start, arc.end()).ok().map(MoveCurve::Line))
        }
        MoveCurve::Cubic(cubic) => {
            Some(MoveCurve::Cubic(cubic.with_start_moved(start - cubic.start())))
        }
        MoveCurve::Involute(involute) => {
            involute.between(start, involute.end()).map(MoveCurve::Involute)
        }
        MoveCurve::Vertical(_) => None,
    };
    moved.unwrap_or(*piece)
}
