//! A first law: constant accelerations below the speeds that the bends allow, and then smoothed.

use super::course::Course;
use super::law::State;
use crate::motion::Limits;

/// Time over which accelerations change, in units of what the jerk needs for the largest.
const SPREAD: f64 = 1.2;

/// What accelerations of the first law are at most, in parts of the limit.
const GENTLE: f64 = 0.7;

/// What a run that begins or ends on the move does so at, in parts of its cap.
const EVEN: f64 = 0.98;

/// A place of the first law: arc length [mm], square of speed, acceleration and cap from there on.
type Node = [f64; 4];

/// The coefficients of a spline over time, from rest to rest, as [`states`] takes them, and their
/// distance [s], which is about twice the step asked for.
pub(super) fn reference(course: &Course, limits: &Limits, step: f64) -> (Vec<f64>, f64) {
    let nodes = nodes(course, limits);
    let time = travel(&nodes, f64::INFINITY, &mut Vec::new());
    let span = time / (time / (2.0 * step)).ceil().max(1.0);
    // Boxes one after the other make of steps of the acceleration ramps, and of those bells.
    let (mut sum, mut whole) = (0.0, 0.0);
    for pair in nodes.windows(2) {
        sum += pair[0][2] * (pair[1][0] - pair[0][0]);
        whole += pair[1][0] - pair[0][0];
    }
    let wide = SPREAD * sum / (whole * limits.jerk);
    let boxes =
        [wide, wide.min(limits.jerk / limits.snap())].map(|width| count(width / span).max(1));
    let beyond = boxes[0] + boxes[1];
    // Where it does not rest it goes on evenly, far enough for what follows.
    let ends = [nodes[0][1].sqrt(), nodes[nodes.len() - 1][1].sqrt()].map(|speed| speed * span);
    let mut at = Vec::new();
    if course.moving[0] {
        for k in (1..=beyond + 3).rev() {
            at.push(-ends[0] * k as f64);
        }
    } else {
        at.extend([0.0; 3]);
    }
    let first = at.len();
    at.push(0.0);
    travel(&nodes, span, &mut at);
    // Steps of the time may round one place away or in.
    at.truncate(first + count(time / span));
    at.push(course.length);
    if course.moving[1] {
        for k in 1..=beyond + 3 {
            at.push(course.length + ends[1] * k as f64);
        }
    }
    for width in boxes {
        spread(&mut at, width, !course.moving[1]);
    }
    if course.moving[0] {
        at.drain(..beyond - 2);
    }
    if !course.moving[1] {
        at.extend([course.length; 3]);
    }
    (at, span)
}

fn nodes(course: &Course, limits: &Limits) -> Vec<Node> {
    let mut nodes: Vec<Node> = Vec::with_capacity(course.places.len() + 1);
    for place in &course.places {
        // From rest to rest over the length, by the jerk alone, the mean acceleration is about this.
        let half = (0.5 * place.length).max(0.3);
        let mean = 0.5 * (limits.jerk * limits.jerk * half).cbrt();
        let acceleration = mean.min(GENTLE * limits.acceleration);
        nodes.push([place.s, place.speed * place.speed, acceleration, place.cap]);
    }
    let last = course.places.last().map_or(0.0, |place| place.cap);
    let end = if course.moving[1] { EVEN * last } else { 0.0 };
    nodes.push([course.length, end * end, 1.0, last]);
    let start = if course.moving[0] { EVEN * nodes[0][3] } else { 0.0 };
    nodes[0][1] = start * start;
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
