//! Line and spline, span by span.

use super::{Crossing, END_SLACK, Intersections, with_ends, with_touches, within};
use crate::geometry::{Cubic, Line, cross, roots};

/// Where a line crosses one cubic of a spline: the roots of the cubic's distance from the line,
/// a cubic polynomial in Bernstein form.
#[must_use]
pub fn line_cubic(line: &Line, cubic: &Cubic) -> Intersections {
    let along = line.tangent();
    let length = line.length();
    let distances = cubic.points.map(|p| cross(along, p - line.start()));
    // Rounding of the cross product of coordinates around the line.
    let noise = 1e-14 * (length + cubic.points[0].distance(line.start()) + cubic.hull_length());
    if distances.iter().all(|d| d.abs() <= noise) {
        let bounds = cubic.points.map(|p| along.dot(p - line.start()));
        let low = bounds.iter().copied().fold(f64::INFINITY, f64::min);
        let high = bounds.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        return if high < 0.0 || low > length {
            Intersections::Points(Vec::new())
        } else {
            Intersections::Coincident
        };
    }
    let at_ends = [distances[0], distances[3]].map(|d| d.abs() <= END_SLACK);
    let touches = roots(&[
        distances[1] - distances[0],
        distances[2] - distances[1],
        distances[3] - distances[2],
    ]);
    let distance = |u| cross(along, cubic.point(u) - line.start());
    let mut crossings = Vec::new();
    for u in with_touches(with_ends(roots(&distances), at_ends), touches, distance) {
        let point = cubic.point(u);
        if let Some(t) = within(along.dot(point - line.start()) / length, length) {
            crossings.push(Crossing { point, t, u });
        }
    }
    Intersections::sorted(crossings)
}
