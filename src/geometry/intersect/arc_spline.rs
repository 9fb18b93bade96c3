//! Arc and spline, span by span.

use super::{Crossing, END_SLACK, Intersections, with_ends, with_touches};
use crate::geometry::{Arc, Cubic, roots};

/// Where an arc crosses one cubic of a spline: the roots of `|C − centre|² − R²`, a polynomial of
/// degree 6 in Bernstein form.
#[must_use]
pub fn arc_cubic(arc: &Arc, cubic: &Cubic) -> Intersections {
    let c = cubic.points.map(|p| p - arc.center());
    // Product of two Bernstein forms of degree 3: weights C(3,i) C(3,j) / C(6,i+j).
    let mut squared = [0.0; 7];
    for (i, (ci, wi)) in c.iter().zip([1.0, 3.0, 3.0, 1.0]).enumerate() {
        for (j, (cj, wj)) in c.iter().zip([1.0, 3.0, 3.0, 1.0]).enumerate() {
            squared[i + j] += wi * wj * ci.dot(*cj);
        }
    }
    for (value, binomial) in squared.iter_mut().zip([1.0, 6.0, 15.0, 20.0, 15.0, 6.0, 1.0]) {
        *value = *value / binomial - arc.radius() * arc.radius();
    }
    let at_ends = [c[0], c[3]].map(|p| (p.length() - arc.radius()).abs() <= END_SLACK);
    // No cubic is a circle, so the two never coincide on a stretch longer than a point.
    // |d² − R²| at most this where |d − R| is at most the slack.
    let near = 2.0 * END_SLACK * (arc.radius() + END_SLACK);
    if squared.iter().all(|&s| s > near) || squared.iter().all(|&s| s < -near) {
        return Intersections::Points(Vec::new());
    }
    let mut slopes = [0.0; 6];
    for (slope, pair) in slopes.iter_mut().zip(squared.windows(2)) {
        *slope = pair[1] - pair[0];
    }
    let distance = |u| cubic.point(u).distance(arc.center()) - arc.radius();
    let mut crossings = Vec::new();
    for u in with_touches(with_ends(roots(&squared), at_ends), roots(&slopes), distance) {
        let point = cubic.point(u);
        if let Some(t) = arc.parameter_within(point, END_SLACK) {
            crossings.push(Crossing { point, t, u });
        }
    }
    Intersections::sorted(crossings)
}
