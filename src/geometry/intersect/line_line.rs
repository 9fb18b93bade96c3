//! Line and line.

use glam::DVec2;

use super::{Crossing, END_SLACK, Intersections, within};
use crate::geometry::{Line, cross};

/// Where two lines cross.
#[must_use]
pub fn line_line(a: &Line, b: &Line) -> Intersections {
    match lines_extended(a, b) {
        Some((t, u)) => {
            let crossing = within(t, a.length())
                .zip(within(u, b.length()))
                .map(|(t, u)| Crossing { point: a.point(t), t, u });
            Intersections::Points(crossing.into_iter().collect())
        }
        None => parallel(a, b),
    }
}

/// Parameters at which the two lines, run on without end, cross; `None` where they are parallel.
#[must_use]
pub fn lines_extended(a: &Line, b: &Line) -> Option<(f64, f64)> {
    let (va, vb, between) = (a.vector(), b.vector(), b.start() - a.start());
    let denominator = cross(va, vb);
    // Sine of the angle between them; below 1e-14 it is made of rounding.
    if denominator.abs() <= 1e-14 * va.length() * vb.length() {
        return None;
    }
    Some((cross(between, vb) / denominator, cross(between, va) / denominator))
}

/// Parallel lines share nothing, an end, or a stretch.
fn parallel(a: &Line, b: &Line) -> Intersections {
    let along = a.tangent();
    let off = |p: DVec2| cross(along, p - a.start()).abs();
    if off(b.start()) > END_SLACK && off(b.end()) > END_SLACK {
        return Intersections::Points(Vec::new());
    }
    let length = a.length();
    let (s0, s1) = (along.dot(b.start() - a.start()), along.dot(b.end() - a.start()));
    let (low, high) = (s0.min(s1).max(0.0), s0.max(s1).min(length));
    if high - low > END_SLACK {
        return Intersections::Coincident;
    }
    let touches = high - low >= -END_SLACK;
    let s = 0.5 * (low + high);
    let crossing = touches.then(|| Crossing {
        point: a.start() + along * s,
        t: (s / length).clamp(0.0, 1.0),
        u: ((s - s0) / (s1 - s0)).clamp(0.0, 1.0),
    });
    Intersections::Points(crossing.into_iter().collect())
}
