//! A first law: constant accelerations below the speeds that the bends allow, and then smoothed.

use super::course::Course;
use super::law::{Phase, State, length, state_at};
use crate::geometry::nth_root;
use crate::motion::Limits;

/// Time over which accelerations change, in units of what the jerk needs for the largest.
const SPREAD: f64 = 1.2;

/// What accelerations of the first law are at most, in parts of the limit.
const GENTLE: f64 = 0.7;

/// What a run that begins or ends on the move does so at, in parts of its cap.
const EVEN: f64 = 0.98;

/// How much of the time of a head is followed: the rest is for braking.
const FOLLOWED: f64 = 0.4;

/// A place of the first law: arc length [mm], square of speed, acceleration and cap from there on.
type Node = [f64; 4];

/// The coefficients of a spline over time, from rest to rest, as [`state`] takes them, and their
/// distance [s], which is about twice the step asked for.
///
/// With a head, the law that the course was run by so far, it begins as that, follows it for a while,
/// and is not of rest; nothing where the head is too short for it.
pub(super) fn reference(
    course: &Course,
    limits: &Limits,
    step: f64,
    head: &[Phase],
) -> Option<(Vec<f64>, f64)> {
    // How many coefficients follow the head, and where it then is, how fast.
    let (mut followed, mut from) = (0, [0.0; 2]);
    if !head.is_empty() {
        let long = length(head);
        if !long.is_finite() {
            return None;
        }
        followed = count(FOLLOWED * long / step);
        let [s, v, ..] = state_at(head, (followed as f64 - 1.5) * step);
        from = [s, v];
    }
    let nodes = nodes(course, limits, from);
    let time = travel(&nodes, f64::INFINITY, &mut Vec::new());
    let mut span = time / (time / (2.0 * step)).ceil().max(1.0);
    if followed > 0 {
        span = step;
    }
    // Boxes one after the other make of steps of the acceleration ramps, and of those bells.
    let (mut sum, mut whole) = (0.0, 0.0);
    for pair in nodes.windows(2) {
        sum += pair[0][2] * (pair[1][0] - pair[0][0]);
        whole += pair[1][0] - pair[0][0];
    }
    let wide = SPREAD * sum / (whole * limits.jerk);
    let mut boxes =
        [wide, wide.min(limits.jerk / limits.snap())].map(|width| count(width / span).max(1));
    // What they are late by is then a whole number.
    boxes[1] += usize::from(followed > 0 && (boxes[0] + boxes[1]) % 2 > 0);
    let beyond = boxes[0] + boxes[1];
    // Where it does not rest it goes on evenly, far enough for what follows.
    let ends = [nodes[0][1].sqrt(), nodes[nodes.len() - 1][1].sqrt()].map(|speed| speed * span);
    let mut at = Vec::new();
    if followed > 0 {
        if followed < 3 * beyond + 4 {
            return None;
        }
        at = sampled(head, span, followed);
    } else if course.moving[0] {
        for k in (1..=beyond + 3).rev() {
            at.push(-ends[0] * k as f64);
        }
    } else {
        at.extend([0.0; 3]);
    }
    let first = at.len();
    at.push(from[0]);
    travel(&nodes, span, &mut at);
    // Steps of the time may round one place away or in.
    at.truncate(first + count(time / span));
    at.push(course.length);
    if course.moving[1] {
        for k in 1..=beyond + 3 {
            at.push(course.length + ends[1] * k as f64);
        }
    }
    let sharp = at.clone();
    for width in boxes {
        spread(&mut at, width, !course.moving[1]);
    }
    if followed > 0 {
        at.drain(..beyond / 2 - 1);
        // From the head, as it was, over to what is smoothed, where both are nearly the same.
        for (k, smooth) in at.iter_mut().enumerate().take(followed - beyond) {
            let x = (k + 2 * beyond).saturating_sub(followed) as f64 / beyond as f64;
            *smooth += (sharp[k] - *smooth) * (1.0 - x * x * (3.0 - 2.0 * x));
        }
    } else if course.moving[0] {
        at.drain(..beyond - 2);
    }
    if !course.moving[1] {
        at.extend([course.length; 3]);
    }
    Some((at, span))
}

/// The coefficients of the spline of degree 4 that runs as a law does from its start on.
///
/// A cubic `p + v x + a x²/2 + j x³/6` has the coefficients `p + v g + a/2 (g² − 5/12) + j/6 (g³ − 5/4 g)`,
/// the symmetric means of the four knots of each about its middle `g`: the first four give the state at
/// the start exactly.
pub(super) fn sampled(law: &[Phase], span: f64, count: usize) -> Vec<f64> {
    let mut coefficients = Vec::with_capacity(count);
    let (mut on, mut start) = (0, 0.0);
    for k in 0..count {
        let g = k as f64 - 1.5;
        let middle = if k < 4 { 0.0 } else { g * span };
        while on + 1 < law.len() && start + law[on].duration < middle {
            start += law[on].duration;
            on += 1;
        }
        let [mut p, v, a, j] = state_at(&law[on..], middle - start);
        // Behind its end it goes on evenly.
        p += v * (middle - start - law[on].duration).max(0.0);
        let g = if k < 4 { g } else { 0.0 };
        let (v, a, j) = (v * span, a * span * span, j * span * span * span);
        coefficients
            .push(p + g * v + 0.5 * (g * g - 5.0 / 12.0) * a + (g * g - 1.25) * g / 6.0 * j);
    }
    coefficients
}

fn nodes(course: &Course, limits: &Limits, [from, speed]: [f64; 2]) -> Vec<Node> {
    let mut nodes: Vec<Node> = Vec::with_capacity(course.places.len() + 1);
    for place in &course.places {
        // From rest to rest over the length, by the jerk alone, the mean acceleration is about this.
        let half = (0.5 * place.length).max(0.3);
        let mean = 0.5 * nth_root(limits.jerk * limits.jerk * half, 3);
        let acceleration = mean.min(GENTLE * limits.acceleration);
        let node = [place.s, place.speed * place.speed, acceleration, place.cap];
        if place.s > from || nodes.is_empty() {
            nodes.push(node);
        } else {
            // The last place before the start stands for it.
            nodes[0] = node;
        }
    }
    let last = course.places.last().map_or(0.0, |place| place.cap);
    let end = if course.moving[1] { EVEN * last } else { 0.0 };
    nodes.push([course.length, end * end, 1.0, last]);
    let start = if course.moving[0] { EVEN * nodes[0][3] } else { speed };
    (nodes[0][0], nodes[0][1]) = (from, start * start);
    for k in 1..nodes.len() {
        let most = nodes[k - 1][1] + 2.0 * nodes[k - 1][2] * (nodes[k][0] - nodes[k - 1][0]);
        nodes[k][1] = nodes[k][1].min(most);
    }
    for k in (1..nodes.len()).rev() {
        let most = nodes[k][1] + 2.0 * nodes[k - 1][2] * (nodes[k][0] - nodes[k - 1][0]);
        nodes[k - 1][1] = nodes[k - 1][1].min(most);
    }
    nodes
}

/// Travels from node to node: on, cruise, off. Adds where it is at multiples of the step, and returns
/// the time it takes [s].
fn travel(nodes: &[Node], step: f64, at: &mut Vec<f64>) -> f64 {
    let (mut time, mut next) = (0.0, step);
    for pair in nodes.windows(2) {
        let [from, square, acceleration, cap] = pair[0];
        let [to, last, ..] = pair[1];
        let length = to - from;
        if length <= 0.0 {
            continue;
        }
        let peak = (0.5 * (square + last) + acceleration * length).min(cap * cap);
        let peak = peak.max(square).max(last).sqrt();
        let (v0, v1) = (square.sqrt(), last.sqrt());
        let (up, down) = ((peak - v0) / acceleration, (peak - v1) / acceleration);
        let (on, off) = (0.5 * (v0 + peak) * up, 0.5 * (peak + v1) * down);
        let cruise = ((length - on - off) / peak).max(0.0);
        let total = up + cruise + down;
        while next <= time + total {
            let t = next - time;
            let s = if t < up {
                v0 * t + 0.5 * acceleration * t * t
            } else if t < up + cruise {
                on + peak * (t - up)
            } else {
                let left = total - t;
                length - v1 * left - 0.5 * acceleration * left * left
            };
            at.push(from + s.clamp(0.0, length));
            next += step;
        }
        time += total;
    }
    time
}

/// The nearest whole number.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "times over a step")]
fn count(ratio: f64) -> usize {
    ratio.round() as usize
}

/// Replaces each value by the mean of `count` up to it; before the first one it rests, and behind the
/// last one where it `rests` there.
fn spread(at: &mut Vec<f64>, count: usize, rests: bool) {
    let Some(end) = at.last().copied() else { return };
    let old = std::mem::take(at);
    let more = if rests { count - 1 } else { 0 };
    let mut sum = 0.0;
    for i in 0..old.len() + more {
        sum += if i < old.len() { old[i] } else { end };
        if i >= count {
            sum -= old[i - count];
        }
        let mean = sum / count as f64;
        at.push(if rests { mean.min(end) } else { mean });
    }
}

/// The state of the uniform spline of degree 4 with these coefficients, a distance `span` [s] apart, at
/// a time since the first knot that five of them act on [s].
pub(super) fn state(spline: &[f64], span: f64, time: f64) -> State {
    let last = (spline.len() - 5) as f64;
    let interval = (time / span + 1.0e-9).floor().clamp(0.0, last);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most the last")]
    let first = interval as usize;
    let x = time / span - interval;
    let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|i| spline[first + i]);
    let (square, cube) = (span * span, span * span * span);
    // The state at the knot in units of the distance, and Taylor's series from there.
    let position = (a + 11.0 * (b + c) + d) / 24.0;
    let velocity = (d - a + 3.0 * (c - b)) / 6.0;
    let acceleration = 0.5 * (a - b - c + d);
    let jerk = d - a + 3.0 * (b - c);
    let snap = a + e + 6.0 * c - 4.0 * (b + d);
    [
        position + x * (velocity + x * (acceleration / 2.0 + x * (jerk / 6.0 + x * snap / 24.0))),
        (velocity + x * (acceleration + x * (jerk / 2.0 + x * snap / 6.0))) / span,
        (acceleration + x * (jerk + x * snap / 2.0)) / square,
        (jerk + x * snap) / cube,
    ]
}
