//! How far a law exceeds limits between the places where it was made to hold them.

use std::ops::Range;

use glam::DVec3;

use super::course::{Course, across};
use super::law::Phase;
use super::retime::Bounds;
use crate::geometry::nth_root;
use crate::motion::Limits;

/// Places per phase.
const PLACES: usize = 4;

/// Part of the change of jerk in a period that is left to what lies between the places.
pub(super) const BETWEEN: f64 = 0.95;

/// What of a limit is well within it: as much as is left to peaks between the places.
const HOLDS: f64 = 0.9986;

/// Halvings of a step that find the border of two pieces.
const HALVINGS: u32 = 12;

/// The factor on time that puts a phase right: acceleration, jerk, snap and velocity over their limits
/// go with its powers. Where all are well within them it is 0.
pub(super) fn factor([a, j, s, v]: &[f64; 4]) -> f64 {
    if *a < HOLDS && *j < HOLDS && *s < HOLDS && *v < HOLDS {
        return 0.0;
    }
    let factor = v.max(a.sqrt()).max(nth_root(*j, 3)).max(s.sqrt().sqrt());
    if (a + j + s + v).is_finite() { factor } else { f64::INFINITY }
}

/// Looks at some phases of a law between its knots; writes their acceleration, jerk, snap and velocity
/// over their limits.
pub(super) fn verify(
    course: &Course,
    limits: &Limits,
    bounds: &Bounds,
    law: &[Phase],
    range: Range<usize>,
    excess: &mut [[f64; 4]],
) {
    let mut at = 0;
    // Jerks of the last period or so, which begins some phases before.
    let mut before: Vec<(f64, DVec3)> = Vec::new();
    let mut oldest = 0;
    let mut start = 0.0;
    let mut places = Vec::with_capacity(2 * PLACES);
    let mut first = range.start;
    let mut back = 0.0;
    while first > 0 && back < 1.5 * limits.period {
        first -= 1;
        back += law[first].duration;
    }
    for k in first..range.end {
        let phase = &law[k];
        let mut worst = [0.0_f64; 4];
        times(course, phase, at, &mut places);
        for time in places.iter().copied() {
            let [s, v, a, j] = phase.at(time);
            let frame = course.frame(s, &mut at);
            let acceleration = frame.tangent * a + frame.curvature * (v * v);
            let jerk =
                frame.tangent * j + frame.curvature * (3.0 * v * a) + frame.sharpness * (v * v * v);
            for (scale, ratio) in &bounds.scales {
                raise(&mut worst[0], (acceleration * *scale).length());
                raise(&mut worst[1], ((jerk * *scale).length_squared() * ratio).sqrt());
            }
            let (cap, _) = course.between(s, s, at, limits);
            let mut over = v * frame.tangent.length() / cap;
            if let Some(axes) = &limits.axes {
                for axis in 0..3 {
                    raise(&mut over, v * frame.tangent[axis].abs() / axes.velocity[axis]);
                }
            }
            let chord = across(&frame) / (8.0 * limits.chord_error);
            raise(&mut over, v * limits.period * chord.sqrt());
            raise(&mut worst[3], over);
            if !(v + a + j).is_finite() || v < -1.0e-6 {
                worst[3] = f64::INFINITY;
            }
            // Against the jerk a period ago, or a little more.
            let now = start + time;
            before.push((now, jerk));
            while oldest + 1 < before.len() && before[oldest + 1].0 <= now - limits.period {
                oldest += 1;
            }
            // Between the places on either side of a period ago.
            let (then, mut old) = before[oldest];
            let back = now - limits.period;
            if back > then && oldest + 1 < before.len() {
                let (next, following) = before[oldest + 1];
                old = old.lerp(following, (back - then) / (next - then));
            }
            let most = bounds.snap * limits.period;
            raise(&mut worst[2], (jerk - old).length() / most);
            if oldest > 1000 {
                before.drain(..oldest);
                oldest = 0;
            }
        }
        start += phase.duration;
        if k >= range.start {
            excess[k] = worst;
        }
    }
}

/// Makes a value at least another one.
fn raise(value: &mut f64, other: f64) {
    if other > *value {
        *value = other;
    }
}

/// Where a phase is looked at: at even steps, and where it comes to other pieces, as jerk has a kink
/// there.
fn times(course: &Course, phase: &Phase, mut at: usize, times: &mut Vec<f64>) {
    times.clear();
    course.find(phase.at(0.0)[0], &mut at);
    let mut end = at;
    course.find(phase.at(phase.duration)[0], &mut end);
    let step = phase.duration / PLACES as f64;
    for place in 0..PLACES {
        let time = step * place as f64;
        times.push(time);
        if at == end {
            continue;
        }
        let before = at;
        course.find(phase.at(time + step)[0], &mut at);
        if at > before {
            let (border, mut from, mut to) = (course.start(at), time, time + step);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (from + to);
                if phase.at(middle)[0] < border { from = middle } else { to = middle }
            }
            times.push(to);
        }
    }
}
