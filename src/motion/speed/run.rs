//! The law of a run: a first law, made faster, once more by its own time, judged and repaired.

use glam::DVec3;

use super::course::{Course, across};
use super::law::{Phase, State};
use super::ramp::{Rates, cruise};
use super::reference::reference;
use super::retime::{Bounds, Knot, Retiming};
use super::verify::{Excess, verify};
use crate::motion::{Limits, Piece};

/// What is left to rounding, and between knots.
const SHARE: f64 = 0.9985;

/// What is left to rounding along a line.
const ROUNDED: f64 = 1.0 - 1.0e-6;

/// What a run that begins or ends on the move does so at, in parts of its cap.
const EVEN: f64 = 0.999;

/// What a peak may exceed the places by where a law is looked at, as a factor on time.
const SURE: f64 = 1.0004;

/// How often what is broken between knots is made stricter there.
const REPAIRS: usize = 4;

/// A factor on time that no repair is worth.
const ENOUGH: f64 = 1.002;

/// Distance of knots, in the time that jerk needs to reach its limit.
const RESOLUTION: f64 = 0.3;

/// The law of a run within the limits.
pub(in crate::motion) fn law(course: &Course, limits: &Limits) -> Vec<Phase> {
    if let Some(law) = along_line(course, limits) {
        return law;
    }
    let bounds = bounds(limits);
    let step = (RESOLUTION * limits.jerk / limits.snap()).max(0.5 * limits.period);
    let (states, coarse) = reference(course, limits, 2.0 * step);
    let (first, _) = faster(course, limits, &bounds, &states, coarse, [0.3, 1.0e-2], 0);
    let (states, step) = resample(&first, course, step);
    let (mut law, worst) = faster(course, limits, &bounds, &states, step, [0.05, 1.0e-3], REPAIRS);
    let factor = worst * SURE;
    if factor > 1.0 {
        for phase in &mut law {
            *phase = phase.stretched(factor);
        }
    }
    law
}

/// The law of a run that is a single line: ramps are the quickest that there are.
fn along_line(course: &Course, limits: &Limits) -> Option<Vec<Phase>> {
    let mut pieces = course.pieces();
    let (placed, from, cap) = pieces.next()?;
    let Piece::Straight(line) = &placed.piece else { return None };
    if pieces.next().is_some() {
        return None;
    }
    let rates = Rates::along(line.tangent, cap, limits).by(ROUNDED);
    let ends = course.moving.map(|moves| if moves { EVEN * rates.velocity } else { 0.0 });
    Some(cruise(from, course.length, ends, &rates))
}

fn bounds(limits: &Limits) -> Bounds {
    let even = DVec3::ONE;
    let mut scales = vec![[even / limits.acceleration, even / limits.jerk]];
    if let Some(axes) = &limits.axes {
        for (axis, unit) in [DVec3::X, DVec3::Y, DVec3::Z].into_iter().enumerate() {
            scales.push([unit / axes.acceleration[axis], unit / axes.jerk[axis]]);
        }
    }
    Bounds { scales, snap: limits.snap() }
}

/// The path at the states of a law.
fn knots(course: &Course, limits: &Limits, states: &[State]) -> Vec<Knot> {
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
        let most = SHARE / (square * chord.max(1.0 / (cap * cap))).max(1.0e-9);
        let path = [
            frame.tangent * v,
            frame.tangent * a + frame.curvature * square,
            frame.tangent * j + frame.curvature * (3.0 * v * a) + frame.sharpness * (square * v),
        ];
        // Half of the jerk is left to a step of curvature.
        let jerk = if steps { 4.0 * strict } else { strict };
        knots.push(Knot { path, most, strict: [strict, jerk, strict] });
    }
    knots
}

/// Makes a law faster; returns by what factor on time its limits then still are broken.
fn faster(
    course: &Course,
    limits: &Limits,
    bounds: &Bounds,
    states: &[State],
    step: f64,
    weights: [f64; 2],
    repairs: usize,
) -> (Vec<Phase>, f64) {
    let mut knots = knots(course, limits, states);
    let retiming = Retiming::new(&knots, bounds, step);
    let mut c = vec![1.0; retiming.coefficients()];
    slow(&retiming, &mut c);
    let start = c.clone();
    retiming.improve(&mut c, weights, 60);
    let mut law = phases(&retiming, states, step, &c);
    let mut found = verify(course, limits, bounds, &law);
    // Of all attempts the one that is shortest when it is within its limits.
    let mut best = law;
    let mut factor = found.factor;
    for _ in 0..repairs {
        if found.factor <= ENOUGH || !found.factor.is_finite() {
            break;
        }
        tighten(&mut knots, &found);
        let retiming = Retiming::new(&knots, bounds, step);
        slow(&retiming, &mut c);
        retiming.improve(&mut c, weights, 60);
        law = phases(&retiming, states, step, &c);
        found = verify(course, limits, bounds, &law);
        if found.factor.is_finite() && length(&law) * found.factor.max(1.0) < length(&best) * factor
        {
            (best, factor) = (law, found.factor.max(1.0));
        }
    }
    if !factor.is_finite() {
        let retiming = Retiming::new(&knots, bounds, step);
        best = phases(&retiming, states, step, &start);
        factor = verify(course, limits, bounds, &best).factor;
    }
    (best, factor)
}

/// How long a law lasts [s].
fn length(law: &[Phase]) -> f64 {
    let mut time = 0.0;
    for phase in law {
        time += phase.duration;
    }
    time
}

/// Slows down evenly, so that limits hold at the knots and the barriers are finite.
fn slow(retiming: &Retiming, c: &mut [f64]) {
    let even = 0.97 * retiming.even(c);
    for one in c {
        *one *= even;
    }
}

/// Takes from knots beside a phase what it exceeds its limits by.
fn tighten(knots: &mut [Knot], found: &Excess) {
    for (k, ratios) in found.phases.iter().enumerate() {
        let first = k.saturating_sub(1);
        let last = (k + 3).min(knots.len());
        for knot in &mut knots[first..last] {
            for (strict, ratio) in knot.strict.iter_mut().zip(ratios) {
                if *ratio > 1.0 {
                    // Knots share: more than the square of the ratio is needed.
                    *strict *= (ratio * ratio * 1.003).min(4.0);
                }
            }
        }
    }
}

/// The phases of a law with the rate `√b`.
fn phases(retiming: &Retiming, states: &[State], step: f64, c: &[f64]) -> Vec<Phase> {
    let state = |k: usize| -> State {
        let [b, slope, bend] = retiming.at(c, k);
        let [s, v, a, j] = states[k];
        let root = b.sqrt();
        [s, v * root, a * b + 0.5 * v * slope, root * (j * b + 1.5 * a * slope + 0.5 * v * bend)]
    };
    let mut phases = Vec::with_capacity(states.len());
    let mut last = state(0);
    for k in 0..states.len() - 1 {
        let next = state(k + 1);
        phases.push(Phase::between(time(&c[k / 2..], (k % 2) as f64, step), last, next));
        last = next;
    }
    phases
}

/// The time `∫ du/√b` of half an interval of the spline, the first or the second, by Gauss' rule with
/// four places.
fn time(c: &[f64], half: f64, step: f64) -> f64 {
    let rule = [
        (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
        (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
        (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
        (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
    ];
    let mut time = 0.0;
    for (place, weight) in rule {
        let x = 0.5 * (place + half);
        let y = 1.0 - x;
        let b = (y * y * y * c[0]
            + (4.0 - 6.0 * x * x + 3.0 * x * x * x) * c[1]
            + (4.0 - 6.0 * y * y + 3.0 * y * y * y) * c[2]
            + x * x * x * c[3])
            / 6.0;
        time += weight * step / b.sqrt();
    }
    time
}

/// The states of a law at even steps of its time; their number is odd.
fn resample(law: &[Phase], course: &Course, step: f64) -> (Vec<State>, f64) {
    let time = length(law);
    let count = 2.0 * (0.5 * time / step).ceil().max(3.0);
    let step = time / count;
    let mut states: Vec<State> = Vec::new();
    let mut start = 0.0;
    for phase in law {
        let end = start + phase.duration;
        while (states.len() as f64) < count && states.len() as f64 * step <= end {
            states.push(phase.at(states.len() as f64 * step - start));
        }
        start = end;
    }
    let last = law.last().map_or([0.0; 4], |phase| phase.at(phase.duration));
    states.push(if course.moving[1] { last } else { [course.length, 0.0, 0.0, 0.0] });
    (states, step)
}
