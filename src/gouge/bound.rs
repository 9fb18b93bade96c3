//! Lower bounds of the distance of two curves that are exact where one follows the other.

use std::f64::consts::PI;

use glam::DVec2;

use super::exact::approach;
use super::part::Part;
use crate::contour::MoveCurve;
use crate::geometry::{Arc, Cubic, cross, relative_to};

/// Newton steps to the foot of a point, from a guess on the chord; the bound holds whatever is left.
const FOOT_STEPS: usize = 4;

/// Feet nearer to each other than this part of a curve are also taken for one.
const NEARLY_ONE_FOOT: f64 = 0.1;

/// Whether the distance of these two is known exactly.
pub(super) fn is_exact(a: &Part, b: &Part) -> bool {
    let cubic = |part: &Part| matches!(part.curve, MoveCurve::Cubic(_));
    !cubic(a) && !cubic(b)
}

/// A lower bound of the distance of two parts [mm]; no better one than `enough` is looked for.
/// Directions may be off by `slack` [mm].
pub(super) fn lower_bound(a: &Part, b: &Part, enough: f64, slack: f64) -> f64 {
    let discs = a.middle.distance(b.middle) - a.reach - b.reach;
    if discs >= enough {
        return discs;
    }
    let known = match (&a.curve, &b.curve) {
        (MoveCurve::Arc(arc), _) => disc_bound(arc, b),
        (_, MoveCurve::Arc(arc)) => disc_bound(arc, a),
        _ => a.chord_bound(b),
    };
    if known >= enough {
        return known;
    }
    let finer = match (&a.curve, &b.curve) {
        (MoveCurve::Arc(arc), MoveCurve::Cubic(cubic))
        | (MoveCurve::Cubic(cubic), MoveCurve::Arc(arc)) => {
            arc_bound(arc, &cubic.points, enough, slack)
        }
        (MoveCurve::Cubic(_), _) | (_, MoveCurve::Cubic(_)) => follow_bound(&a.hull(), &b.hull()),
        (MoveCurve::Arc(_), _) | (_, MoveCurve::Arc(_)) => approach(&a.curve, &b.curve).0,
        _ => known,
    };
    known.max(finer)
}

/// The least distance of an arc from the disc around a part [mm].
fn disc_bound(arc: &Arc, part: &Part) -> f64 {
    let (middle, reach) = (part.middle, part.reach);
    let ends = middle.distance(arc.start()).min(middle.distance(arc.end())) - reach;
    if is_outside(arc, &[middle], -reach) {
        return ends;
    }
    let out = middle.distance(arc.center());
    ends.min((arc.radius() - out).abs() - reach)
}

/// Whether all points are outside an arc's sector, by more than `-slack` [mm].
fn is_outside(arc: &Arc, points: &[DVec2], slack: f64) -> bool {
    let sense = arc.sweep().signum() / arc.radius();
    let (first, last) = (arc.start() - arc.center(), arc.end() - arc.center());
    let before = |p: &DVec2| cross(first, *p - arc.center()) * sense <= slack;
    let after = |p: &DVec2| cross(*p - arc.center(), last) * sense <= slack;
    let (all_before, all_after) = (points.iter().all(before), points.iter().all(after));
    // The sector is what two half-planes share, or, beyond half a circle, what is in either.
    if arc.sweep().abs() <= PI { all_before || all_after } else { all_before && all_after }
}

/// The least distance of an arc from a cubic [mm]: to the circle within the arc's sector, to the
/// ends outside of it.
fn arc_bound(arc: &Arc, cubic: &[DVec2; 4], enough: f64, slack: f64) -> f64 {
    let mut least = f64::INFINITY;
    for end in [arc.start(), arc.end()] {
        let mut distance = range(&relative_to(end, *cubic))[0].max(0.0).sqrt();
        if distance < enough {
            distance = distance.max(follow_bound(&[end; 4], cubic));
        }
        least = least.min(distance);
        if least < enough {
            // The rest may be nearer still.
            return 0.0;
        }
    }
    if is_outside(arc, cubic, slack) {
        return least;
    }
    let [low, high] = range(&relative_to(arc.center(), *cubic));
    let (low, high) = (low.max(0.0).sqrt(), high.max(0.0).sqrt());
    least.min((arc.radius() - high).max(low - arc.radius()))
}

/// Bounds of `|D|²` by its Bernstein coefficients, of degree 6.
fn range(d: &[DVec2; 4]) -> [f64; 2] {
    let [d0, d1, d2, d3] = *d;
    let coefficients = [
        d0.length_squared(),
        d0.dot(d1),
        0.4 * d0.dot(d2) + 0.6 * d1.length_squared(),
        0.1 * d0.dot(d3) + 0.9 * d1.dot(d2),
        0.4 * d1.dot(d3) + 0.6 * d2.length_squared(),
        d2.dot(d3),
        d3.length_squared(),
    ];
    let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
    for c in coefficients {
        low = low.min(c);
        high = high.max(c);
    }
    [low, high]
}

/// A lower bound of the distance of two cubics `A(t)` and `B(u)` [mm], exact where A follows B; zero
/// where it tells nothing.
///
/// With `g(t, u) = |A(t) − B(u)|²` and `e = (A(t) − B(u)) · B'(u)` it is `g_u = −2e` and
/// `g_uu = 2 (|B'|² − (A − B) · B'')`. Where a Bernstein bound shows `g_uu ≥ 2F > 0` for all t and
/// u, g is strongly convex along u, and so, for any `φ(t)`,
/// `g(t, u) ≥ g(t, φ) − 2e (u − φ) + F (u − φ)² ≥ g(t, φ) − e(t, φ)²/F`.
/// φ is linear and takes the ends of A to their feet on B; then `g(t, φ)` and `e(t, φ)` are
/// polynomials of degree 6 and 5, the second nearly zero. Where both ends of A have the same end of
/// B for their foot only an e that leads into B counts.
fn follow_bound(a: &[DVec2; 4], b: &[DVec2; 4]) -> f64 {
    let origin = b[0];
    let (a, b) = (relative_to(origin, *a), relative_to(origin, *b));
    let cubic = Cubic { points: b };
    let [d0, d1, d2] = cubic.hodograph();
    let [e0, e1] = [2.0 * (d1 - d0), 2.0 * (d2 - d1)];
    // |B'|² + B · B'', of degree 4; B starts at zero.
    let own = [
        d0.length_squared(),
        d0.dot(d1) + 0.75 * b[1].dot(e0),
        (2.0 * d1.length_squared() + d0.dot(d2)) / 3.0 + 0.5 * (b[1].dot(e1) + b[2].dot(e0)),
        d1.dot(d2) + 0.25 * (3.0 * b[2].dot(e1) + b[3].dot(e0)),
        d2.length_squared() + b[3].dot(e1),
    ];
    let mut convexity = f64::INFINITY;
    for p in a {
        let (from, to) = (p.dot(e0), p.dot(e1));
        for (k, own) in own.iter().enumerate() {
            convexity = convexity.min(own - from - (to - from) * (0.25 * k as f64));
        }
    }
    if convexity <= 0.0 {
        return 0.0;
    }
    let from = foot(&cubic, a[0]);
    let to = if a[3] == a[0] { from } else { foot(&cubic, a[3]) };
    let bound = |least: f64, slope: f64| (least - slope * slope / convexity).max(0.0).sqrt();
    let mut best = 0.0_f64;
    if (to - from).abs() < NEARLY_ONE_FOOT {
        let end = if from.min(to) < NEARLY_ONE_FOOT { 0.0 } else { 1.0 };
        let is_end = from.min(to) < NEARLY_ONE_FOOT || from.max(to) > 1.0 - NEARLY_ONE_FOOT;
        let u = if is_end { end } else { from };
        let (at, along) = (cubic.point(u), cubic.derivative(u));
        let away = relative_to(at, a);
        let (mut low, mut high) = (0.0_f64, 0.0_f64);
        for d in away {
            let slope = d.dot(along);
            (low, high) = (low.min(slope), high.max(slope));
        }
        let low = if u == 0.0 { 0.0 } else { -low };
        let high = if u == 1.0 { 0.0 } else { high };
        best = bound(range(&away)[0], low.max(high));
    }
    if (to - from).abs() > 1e-6 {
        let followed = cubic.part(from, to);
        let [c0, c1, c2, c3] = followed.points;
        let d @ [w0, w1, w2, w3] = [a[0] - c0, a[1] - c1, a[2] - c2, a[3] - c3];
        let [v0, v1, v2] = followed.hodograph();
        let slopes = [
            w0.dot(v0),
            0.4 * w0.dot(v1) + 0.6 * w1.dot(v0),
            0.1 * w0.dot(v2) + 0.6 * w1.dot(v1) + 0.3 * w2.dot(v0),
            0.3 * w1.dot(v2) + 0.6 * w2.dot(v1) + 0.1 * w3.dot(v0),
            0.6 * w2.dot(v2) + 0.4 * w3.dot(v1),
            w3.dot(v2),
        ];
        let steepest = slopes.into_iter().fold(0.0_f64, |most, s| most.max(s.abs()));
        best = best.max(bound(range(&d)[0], steepest / (to - from).abs()));
    }
    best
}

/// Parameter of the foot of `point`, where the distance has one minimum.
fn foot(cubic: &Cubic, point: DVec2) -> f64 {
    let at_start = (point - cubic.start()).dot(cubic.derivative(0.0));
    let at_end = (point - cubic.end()).dot(cubic.derivative(1.0));
    if at_start <= 0.0 {
        return 0.0;
    }
    if at_end >= 0.0 {
        return 1.0;
    }
    let mut u = at_start / (at_start - at_end);
    for _ in 0..FOOT_STEPS {
        let (away, along) = (point - cubic.point(u), cubic.derivative(u));
        let bend = along.length_squared() - away.dot(cubic.second_derivative(u));
        let step = away.dot(along) / bend;
        u = (u + step).clamp(0.0, 1.0);
        if step.abs() < 1e-8 {
            break;
        }
    }
    u
}
