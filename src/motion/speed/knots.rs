//! What a law is held to at its knots: the path there, and how fast it may be run.

use glam::DVec3;

use super::course::{Course, across};
use super::law::State;
use super::retime::{Bounds, Knot};
use super::verify::BETWEEN;
use crate::motion::Limits;

/// What is left to rounding, and between knots.
const SHARE: f64 = 0.9985;

/// The same of the square of the velocity, which changes little between them.
const PACE: f64 = 0.999;

/// What changes of the jerk are held to between two knots, inversely squared.
const CHANGES: f64 = 1.04;

/// The limits by which a law is sought.
pub(super) fn bounds(limits: &Limits) -> Bounds {
    let even = DVec3::ONE;
    let ratio = limits.acceleration / limits.jerk;
    let mut scales = vec![(even / limits.acceleration, ratio * ratio)];
    if let Some(axes) = &limits.axes {
        for (axis, unit) in [DVec3::X, DVec3::Y, DVec3::Z].into_iter().enumerate() {
            let ratio = axes.acceleration[axis] / axes.jerk[axis];
            scales.push((unit / axes.acceleration[axis], ratio * ratio));
        }
    }
    Bounds { scales, snap: BETWEEN * limits.snap() }
}

/// The path at the states of a law.
pub(super) fn knots(
    course: &Course,
    limits: &Limits,
    states: &[State],
    times: &[f64],
    span: f64,
) -> Vec<Knot> {
    let mut at = 0;
    let last = states.len() - 1;
    let strict = 1.0 / (SHARE * SHARE);
    let mut knots = Vec::with_capacity(states.len());
    for (k, [s, v, a, j]) in states.iter().copied().enumerate() {
        let frame = course.frame(s, &mut at);
        let (before, after) = (states[k.saturating_sub(1)][0], states[(k + 1).min(last)][0]);
        let (mut cap, steps) = course.between(before, after, at, limits);
        let pace = frame.tangent.length();
        if let Some(axes) = &limits.axes {
            for axis in 0..3 {
                let share = frame.tangent[axis].abs() / pace;
                cap = cap.min(axes.velocity[axis] / share.max(1.0e-9));
            }
        }
        cap /= pace;
        let chord = across(&frame) * limits.period * limits.period / (8.0 * limits.chord_error);
        let square = v * v;
        // Where the path stands still, b would be free.
        let most = PACE / (square * chord.max(1.0 / (cap * cap))).max(1.0e-9);
        let path = [
            frame.tangent * v,
            frame.tangent * a + frame.curvature * square,
            frame.tangent * j + frame.curvature * (3.0 * v * a) + frame.sharpness * (square * v),
        ];
        // Half of the jerk and of its change is left to a step of curvature.
        let jerk = if steps { 4.0 * strict } else { strict };
        let step = times[(k + 1).min(last)] - times[k];
        let share = (times[(k + 1).min(last)] - times[k.saturating_sub(1)]) / span;
        knots.push(Knot { path, most, step, share, strict: [strict, jerk, jerk * CHANGES] });
    }
    knots
}
