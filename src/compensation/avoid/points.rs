//! What of a contour is too short to shape a path, and counts as a point.

use crate::contour::{MoveCurve, Segment};
use crate::geometry::{Cubic, Curve};

/// Segments that lead no farther than this shape no path of their own, as a part of the tolerance.
pub(super) const SHORTEST: f64 = 0.1;

/// The segments that shape the path, by their indices.
///
/// Those that lead no farther than `shortest` [mm] from the end of the last one kept are points: a
/// corner at each of their ends would turn far, and often there and back, where there is one.
pub(super) fn shaping(segments: &[Segment], shortest: f64) -> Vec<usize> {
    let mut kept = Vec::with_capacity(segments.len());
    let mut end = segments[0].curve.start();
    for (index, Segment { curve, .. }) in segments.iter().enumerate() {
        let is_point = match curve {
            Curve::Line(line) => line.length() < shortest,
            Curve::Arc(arc) => arc.length() < shortest,
            Curve::Spline(_) | Curve::Involute(_) => false,
        };
        if !is_point || curve.end().distance(end) >= shortest {
            kept.push(index);
            end = curve.end();
        }
    }
    if kept.is_empty() { (0..segments.len()).collect() } else { kept }
}

/// The spans that shape the path of a spline: the first and the last ones are points where they
/// lead no farther than `shortest` [mm] from the end that they are at.
pub(super) fn shaping_spans(spans: &[Cubic], shortest: f64) -> std::ops::Range<usize> {
    let (mut from, mut to) = (0, spans.len());
    let (start, end) = (spans[0].start(), spans[to - 1].end());
    let is_point = |span: &Cubic| span.hull_length() < shortest;
    while from + 1 < to && is_point(&spans[from]) && spans[from].end().distance(start) < shortest {
        from += 1;
    }
    while from + 1 < to
        && is_point(&spans[to - 1])
        && spans[to - 1].start().distance(end) < shortest
    {
        to -= 1;
    }
    from..to
}

/// The first and the last part of a segment that shape the path.
pub(super) fn ends(curve: &Curve, shortest: f64) -> [MoveCurve; 2] {
    let spans = match curve {
        Curve::Spline(spline) => shaping_spans(spline.pieces(), shortest),
        _ => 0..1,
    };
    [spans.start, spans.end - 1].map(|span| MoveCurve::of(curve, span))
}
