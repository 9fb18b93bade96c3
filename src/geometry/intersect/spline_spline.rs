//! Spline and spline, span by span.
//!
//! The pair of cubics is halved until the boxes of its parts part, or until the parts can cross
//! at most once: when every tangent of one is on the same side of every tangent of the other, the
//! difference of the curves is one-to-one. Newton's method then finds the crossing.

use super::{Crossing, END_SLACK, Intersections};
use crate::geometry::{Cubic, cross};

/// Pairs of parts examined before the curves count as sharing a stretch. A crossing takes about
/// 20, a touch of two arcs of radius 100 about 2,000.
const MAX_PAIRS: usize = 20_000;

/// Part of a cubic over `[from, to]` of its parameter.
#[derive(Clone, Copy)]
struct Part {
    cubic: Cubic,
    from: f64,
    to: f64,
}

impl Part {
    fn halves(&self) -> [Self; 2] {
        let middle = 0.5 * (self.from + self.to);
        let (left, right) = self.cubic.split(0.5);
        [
            Self { cubic: left, from: self.from, to: middle },
            Self { cubic: right, from: middle, to: self.to },
        ]
    }
}

/// Where two cubics of splines cross.
#[must_use]
pub fn cubic_cubic(a: &Cubic, b: &Cubic) -> Intersections {
    let whole = |cubic: &Cubic| Part { cubic: *cubic, from: 0.0, to: 1.0 };
    let mut pairs = vec![(whole(a), whole(b))];
    let mut found: Vec<Crossing> = Vec::new();
    let mut examined = 0;
    while let Some((pa, pb)) = pairs.pop() {
        examined += 1;
        if examined > MAX_PAIRS {
            return Intersections::Coincident;
        }
        let (box_a, box_b) = (pa.cubic.hull_bounds(), pb.cubic.hull_bounds());
        if !box_a.inflated(END_SLACK).meets(&box_b) {
            continue;
        }
        if cross_at_most_once(&pa.cubic, &pb.cubic)
            && let Some(crossing) = newton(a, b, &pa, &pb)
        {
            add(&mut found, crossing);
            continue;
        }
        let (size_a, size_b) = (box_a.size().max_element(), box_b.size().max_element());
        if size_a.max(size_b) <= END_SLACK {
            // Two parts too small to tell apart: the curves touch here.
            let (t, u) = (0.5 * (pa.from + pa.to), 0.5 * (pb.from + pb.to));
            add(&mut found, Crossing { point: a.point(t), t, u });
        } else if size_a >= size_b {
            pairs.extend(pa.halves().map(|half| (half, pb)));
        } else {
            pairs.extend(pb.halves().map(|half| (pa, half)));
        }
    }
    Intersections::sorted(found)
}

/// Adds a crossing unless a neighbouring pair of parts found it already.
fn add(found: &mut Vec<Crossing>, crossing: Crossing) {
    // Touching parts next to each other give points up to a few slacks apart.
    let known = found.iter().any(|other| {
        other.point.distance(crossing.point) <= 10.0 * END_SLACK
            && (other.t - crossing.t).abs() < 1e-3
            && (other.u - crossing.u).abs() < 1e-3
    });
    if !known {
        found.push(crossing);
    }
}

/// Whether all tangents of `b` are strictly on the same side of all tangents of `a`.
fn cross_at_most_once(a: &Cubic, b: &Cubic) -> bool {
    let (da, db) = (a.hodograph(), b.hodograph());
    let sign = cross(da[0], db[0]).signum();
    da.iter().all(|va| db.iter().all(|vb| cross(*va, *vb) * sign > 0.0))
}

/// The crossing in the given parts by Newton's method, if it converges to one there.
fn newton(a: &Cubic, b: &Cubic, pa: &Part, pb: &Part) -> Option<Crossing> {
    let (mut t, mut u) = (0.5 * (pa.from + pa.to), 0.5 * (pb.from + pb.to));
    // Room beyond the parts: a crossing on their very end may come out a rounding beyond it.
    let reach = |part: &Part, cubic: &Cubic| {
        0.01 * (part.to - part.from) + 2.0 * END_SLACK / cubic.hull_length().max(END_SLACK)
    };
    let (reach_a, reach_b) = (reach(pa, a), reach(pb, b));
    for _ in 0..20 {
        let gap = b.point(u) - a.point(t);
        let (da, db) = (a.derivative(t), b.derivative(u));
        let determinant = cross(da, db);
        if determinant == 0.0 {
            return None;
        }
        let (step_t, step_u) = (cross(gap, db) / determinant, cross(gap, da) / determinant);
        t = (t + step_t).clamp(pa.from - reach_a, pa.to + reach_a);
        u = (u + step_u).clamp(pb.from - reach_b, pb.to + reach_b);
        if step_t.abs() < 1e-14 && step_u.abs() < 1e-14 {
            break;
        }
    }
    let (t, u) = (t.clamp(0.0, 1.0), u.clamp(0.0, 1.0));
    let point = a.point(t);
    (point.distance(b.point(u)) <= END_SLACK).then_some(Crossing { point, t, u })
}
