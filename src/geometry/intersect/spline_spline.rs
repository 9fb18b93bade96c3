//! Spline and spline, span by span.
//!
//! The pair of cubics is halved until the boxes of its parts part, or until the parts can cross
//! at most once: when every tangent of one is on the same side of every tangent of the other, the
//! difference of the curves is one-to-one. Newton's method then finds the crossing. Where the
//! curves only touch, halving goes on until both parts are straight lines side by side.

use super::{Crossing, END_SLACK, Intersections};
use crate::geometry::{Cubic, cross};

/// Pairs of parts examined before the curves count as sharing a stretch: a crossing takes about
/// 20, a touch a few hundred.
const MAX_PAIRS: usize = 20_000;

/// Pairs of straight parts side by side before the curves count as sharing a stretch: curves that
/// touch in a point leave each other within a few, unless their curvatures agree to 1e-3.
const MAX_TOUCHES: usize = 64;

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
    let (mut examined, mut touches) = (0, 0);
    while let Some((pa, pb)) = pairs.pop() {
        examined += 1;
        if examined > MAX_PAIRS {
            return Intersections::Coincident;
        }
        let (box_a, box_b) = (pa.cubic.hull_bounds(), pb.cubic.hull_bounds());
        if !box_a.inflated(END_SLACK).meets(&box_b)
            || apart(&pa.cubic, &pb.cubic)
            || apart(&pb.cubic, &pa.cubic)
        {
            continue;
        }
        if cross_at_most_once(&pa.cubic, &pb.cubic)
            && let Some(crossing) = newton(a, b, &pa, &pb)
        {
            add(&mut found, crossing);
            continue;
        }
        let (size_a, size_b) = (box_a.size().max_element(), box_b.size().max_element());
        if is_straight(&pa.cubic) && is_straight(&pb.cubic) {
            if let Some((t, u)) = touch(&pa, &pb) {
                touches += 1;
                if touches > MAX_TOUCHES {
                    return Intersections::Coincident;
                }
                add_touch(&mut found, a, b, Crossing { point: a.point(t), t, u });
            }
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

/// Adds a touch unless it continues one found already: between the two the curves stay together.
fn add_touch(found: &mut Vec<Crossing>, a: &Cubic, b: &Cubic, touch: Crossing) {
    let known = found.iter().any(|other| {
        let (t, u) = (0.5 * (other.t + touch.t), 0.5 * (other.u + touch.u));
        let apart = b.point(u) - a.point(t);
        let across = cross(b.tangent(u), apart).abs().max(cross(a.tangent(t), apart).abs());
        // Both parameters are middles of parts, so the points may be off along the curves.
        across <= 2.0 * END_SLACK
            && apart.length() <= 1e-3 * (1.0 + a.hull_length())
            && (other.t - touch.t).abs() < 1e-2
    });
    if !known {
        found.push(touch);
    }
}

/// Whether a part is a straight line to within a small part of the slack.
fn is_straight(cubic: &Cubic) -> bool {
    let [p0, p1, p2, p3] = cubic.points;
    let chord = p3 - p0;
    let length = chord.length();
    if length <= END_SLACK {
        return cubic.hull_length() <= END_SLACK;
    }
    // The curve is no farther from the chord than 3/4 of its farthest control point.
    let off = |p| cross(chord, p - p0).abs() / length;
    off(p1).max(off(p2)) <= 0.1 * END_SLACK
}

/// Parameters at which two straight parts are nearest to each other, if they come within the
/// slack.
fn touch(pa: &Part, pb: &Part) -> Option<(f64, f64)> {
    let parameter = |part: &Part, t: f64| part.from + (part.to - part.from) * t;
    let at = |t: f64, u: f64| (pa.cubic.point(t).distance(pb.cubic.point(u)), t, u);
    let onto = |cubic: &Cubic, p: glam::DVec2| {
        let chord = cubic.end() - cubic.start();
        let along = (p - cubic.start()).dot(chord) / chord.length_squared();
        if along.is_finite() { along.clamp(0.0, 1.0) } else { 0.0 }
    };
    // Two segments are nearest at an end of one of them, or they cross.
    [
        at(0.0, onto(&pb.cubic, pa.cubic.start())),
        at(1.0, onto(&pb.cubic, pa.cubic.end())),
        at(onto(&pa.cubic, pb.cubic.start()), 0.0),
        at(onto(&pa.cubic, pb.cubic.end()), 1.0),
    ]
    .into_iter()
    .min_by(|x, y| x.0.total_cmp(&y.0))
    .filter(|(distance, ..)| *distance <= END_SLACK)
    .map(|(_, t, u)| (parameter(pa, t), parameter(pb, u)))
}

/// Whether `b` is all on one side of `a`, seen across the chord of `a`: boxes of curves that run side
/// by side at a slant part only when they are as small as the gap.
fn apart(a: &Cubic, b: &Cubic) -> bool {
    let chord = a.end() - a.start();
    let slack = END_SLACK * chord.length();
    let range = |cubic: &Cubic| {
        let across = cubic.points.map(|p| cross(chord, p - a.start()));
        let low = across.into_iter().fold(f64::INFINITY, f64::min);
        (low, across.into_iter().fold(f64::NEG_INFINITY, f64::max))
    };
    let ((low_a, high_a), (low_b, high_b)) = (range(a), range(b));
    low_b > high_a + slack || low_a > high_b + slack
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
        // Not `clamp`, whose refusal of a wrong range prints numbers, with all that this takes.
        t = (t + step_t).max(pa.from - reach_a).min(pa.to + reach_a);
        u = (u + step_u).max(pb.from - reach_b).min(pb.to + reach_b);
        if step_t.abs() < 1e-14 && step_u.abs() < 1e-14 {
            break;
        }
    }
    let (t, u) = (t.clamp(0.0, 1.0), u.clamp(0.0, 1.0));
    let point = a.point(t);
    (point.distance(b.point(u)) <= END_SLACK).then_some(Crossing { point, t, u })
}
