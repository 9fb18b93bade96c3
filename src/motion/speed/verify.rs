//! How far a law exceeds limits between the places where it was made to hold them.

use std::ops::Range;

use glam::DVec3;

use super::course::{Course, across};
use super::law::Phase;
use super::retime::Bounds;
use crate::geometry::nth_root;
use crate::motion::Limits;

/// Places per phase: the fewest and the most.
const PLACES: usize = 4;
const MOST: usize = 64;

/// How far apart they are at most, in the time that jerk needs to reach its limit.
const LONGEST: f64 = 0.1;

/// Part of the change of jerk in a period that is left to what lies between the places.
pub(super) const BETWEEN: f64 = 0.95;

/// What of a limit is well within it: as much as is left to peaks between the places.
const HOLDS: f64 = 0.9996;

/// From what part of a limit on a top between places is looked for, and which places have a kink between
/// them, as a part of the distance to the next one.
const HIGH: f64 = 0.97;
const NEAR: f64 = 0.01;

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
    // The last two places: when, acceleration and jerk over their limits, and in which phase.
    let mut seen = [(0.0, [0.0; 2], first); 2];
    while first > 0 && back < 1.5 * limits.period {
        first -= 1;
        back += law[first].duration;
    }
    for k in first..range.end {
        let phase = &law[k];
        let mut worst = [0.0_f64; 4];
        times(course, phase, limits, at, &mut places);
        for time in places.iter().copied() {
            let [s, v, a, j] = phase.at(time);
            let frame = course.frame(s, &mut at);
            let acceleration = frame.tangent * a + frame.curvature * (v * v);
            let jerk =
                frame.tangent * j + frame.curvature * (3.0 * v * a) + frame.sharpness * (v * v * v);
            let mut sizes = [0.0_f64; 2];
            for (scale, ratio) in &bounds.scales {
                raise(&mut sizes[0], (acceleration * *scale).length());
                raise(&mut sizes[1], ((jerk * *scale).length_squared() * ratio).sqrt());
            }
            let here = (start + time, sizes, k);
            for (index, size) in sizes.iter().enumerate() {
                raise(&mut worst[index], *size);
                let top = top([seen[0], seen[1], here].map(|(t, sizes, _)| [t, sizes[index]]));
                let phase = seen[1].2;
                if phase == k {
                    raise(&mut worst[index], top);
                } else if phase >= range.start {
                    raise(&mut excess[phase][index], top);
                }
            }
            seen = [seen[1], here];
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

/// The top of the parabola through three places with values where it is between them; 0 where it is not,
/// or where two are on either side of a kink.
fn top([before, here, after]: [[f64; 2]; 3]) -> f64 {
    let (back, on) = (here[0] - before[0], after[0] - here[0]);
    if here[1] < HIGH || back < NEAR * on || on < NEAR * back {
        return 0.0;
    }
    let (rise, fall) = ((here[1] - before[1]) / back, (here[1] - after[1]) / on);
    let bend = (rise + fall) / (back + on);
    let slope = (rise * on - fall * back) / (back + on);
    if slope > 2.0 * bend * on || slope < -2.0 * bend * back {
        return 0.0;
    }
    here[1] + slope * slope / (4.0 * bend).max(1.0e-300)
}

/// Makes a value at least another one.
fn raise(value: &mut f64, other: f64) {
    if other > *value {
        *value = other;
    }
}

/// Where a phase is looked at: at even steps, and on either side of where it comes to other pieces, as
/// jerk has a kink there.
fn times(course: &Course, phase: &Phase, limits: &Limits, mut at: usize, times: &mut Vec<f64>) {
    times.clear();
    let longest = LONGEST * limits.jerk / limits.snap();
    let mut count = PLACES;
    while count < MOST && phase.duration > longest * count as f64 {
        count *= 2;
    }
    let step = phase.duration / count as f64;
    course.find(phase.at(0.0)[0], &mut at);
    let mut end = at;
    course.find(phase.at(phase.duration)[0], &mut end);
    for place in 0..count {
        let (time, to) = (step * place as f64, step * (place + 1) as f64);
        times.push(time);
        let mut from = time;
        while at < end && course.start(at + 1) <= phase.at(to)[0] {
            at += 1;
            let mut on = to;
            for _ in 0..HALVINGS {
                let middle = f64::midpoint(from, on);
                if phase.at(middle)[0] < course.start(at) { from = middle } else { on = middle }
            }
            times.extend([from, on]);
            from = on;
        }
    }
}
