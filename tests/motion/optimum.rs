//! The shortest time along a path within limits, by direct transcription in time.
//!
//! The law `s(t)` is a uniform spline of `N` intervals of unknown duration `H`: of degree 3, so that
//! jerk may step at each knot (third order), or of degree 4, whose jerk is bounded in its change
//! (fourth order). At the ends and in the middle of each interval the machine's velocity `q' ṡ`, its
//! acceleration `q' s̈ + q'' ṡ²` and its jerk `q' s⃛ + 3 q'' ṡ s̈ + q''' ṡ³` are held to their limits, and
//! `H` is made small: barriers `−μ ln(1 − g)` with falling μ, and Newton's method on coefficients and
//! `ln H` together, with Gauss' second derivatives. The planner varies something else: the square of
//! a rate over the path of a law that it has.
//!
//! What is found is the shortest time nearby. Of third order it is the same from two laws to begin
//! with and on finer grids. Of fourth order, places of a grid may be caught before a sharp corner whose
//! snap they cannot pass, so several beginnings are tried, and the shortest counts.

use g41::motion::{Frame, Motion, Placed};
use glam::DVec3;

/// Entries beside the diagonal.
const WIDTH: usize = 4;

/// Places of an interval where limits are held.
const PLACES: usize = 5;

/// A path by the parameter of its pieces one after the other.
pub(crate) struct Path {
    pieces: Vec<(f64, Placed)>,
    pub(crate) length: f64,
}

impl Path {
    pub(crate) fn new(track: Vec<Placed>) -> Self {
        let mut length = 0.0;
        let mut pieces = Vec::new();
        for placed in track {
            let from = length;
            length += placed.piece.length();
            pieces.push((from, placed));
        }
        Self { pieces, length }
    }

    /// The ways along the path to samples of a motion that are `period` [s] apart.
    pub(crate) fn ways(&self, motion: &Motion) -> Vec<f64> {
        let mut s = 0.0;
        let mut ways = Vec::new();
        for k in 0..motion.len() {
            // The last one was a little before it: the nearest place from there on.
            for _ in 0..60 {
                let frame = self.at(s).0;
                let on = (motion.point(k) - frame.point).dot(frame.tangent)
                    / frame.tangent.length_squared();
                s = (s + on).clamp(0.0, self.length);
                if on.abs() < 1e-12 {
                    break;
                }
            }
            ways.push(s);
        }
        ways
    }

    /// The frame at `s`, and the derivative of `q'''` by differences within its piece.
    fn at(&self, s: f64) -> (Frame, DVec3) {
        let s = s.clamp(0.0, self.length);
        let k = self.pieces.partition_point(|(from, _)| *from <= s).max(1) - 1;
        let (from, placed) = &self.pieces[k];
        let (piece, on) = (&placed.piece, s - from);
        let h = 1e-4 * piece.length();
        let (a, b) = ((on - h).max(0.0), (on + h).min(piece.length()));
        let slope = (piece.frame(b).sharpness - piece.frame(a).sharpness) / (b - a);
        (piece.frame(on), slope)
    }
}

/// What the machine can do.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Machine {
    /// Largest size of the velocity [mm/s].
    pub(crate) velocity: f64,
    /// Largest size of the acceleration [mm/s²].
    pub(crate) acceleration: f64,
    /// Largest size of the jerk [mm/s³].
    pub(crate) jerk: f64,
    /// Largest size of its change in time [mm/s⁴]; without one, jerk may step.
    pub(crate) snap: Option<f64>,
}

/// Values and derivatives of orders 1 to 3 of the uniform B-splines that are not zero at `x` of an
/// interval of length 1.
fn basis(degree: usize, x: f64) -> [[f64; 5]; 4] {
    // Values of all degrees up to it; a derivative is a difference of those of one degree less.
    let mut values = [[0.0; 5]; 5];
    values[0][0] = 1.0;
    for d in 1..=degree {
        for j in 0..=d {
            let scale = 1.0 / d as f64;
            if j > 0 {
                values[d][j] += scale * (x + (d - j) as f64) * values[d - 1][j - 1];
            }
            if j < d {
                values[d][j] += scale * ((j + 1) as f64 - x) * values[d - 1][j];
            }
        }
    }
    let mut found = [[0.0; 5]; 4];
    found[0] = values[degree];
    for (order, row) in found.iter_mut().enumerate().skip(1) {
        *row = values[degree - order];
        for _ in 0..order {
            for j in (0..5).rev() {
                row[j] = if j > 0 { row[j - 1] } else { 0.0 } - row[j];
            }
        }
    }
    found
}

/// A limit: a vector `r`, with its derivatives by the coefficients and by `ln H`; `|r|² ≤ 1`.
#[derive(Clone, Copy, Default)]
struct Limit {
    value: DVec3,
    slopes: [DVec3; 5],
    by_log: DVec3,
}

impl Limit {
    fn scaled(&self, factor: f64, power: f64) -> Self {
        let value = self.value * factor;
        Self { value, slopes: self.slopes.map(|one| one * factor), by_log: value * -power }
    }
}

/// A law of motion: coefficients of the spline, and the duration of an interval [s].
#[derive(Debug, Clone)]
pub(crate) struct Law {
    degree: usize,
    coefficients: Vec<f64>,
    step: f64,
}

impl Law {
    /// From rest to rest along the path: even accelerations below the speeds that bends allow at an
    /// even pace, smoothed.
    pub(crate) fn gentle(path: &Path, machine: &Machine, intervals: usize) -> Self {
        let degree = if machine.snap.is_some() { 4 } else { 3 };
        let fine = 4000_u32;
        let ds = path.length / f64::from(fine);
        let most = (0.3 * (machine.jerk * machine.jerk * path.length).cbrt())
            .min(0.5 * machine.acceleration);
        let mut squares: Vec<f64> = (0..=fine)
            .map(|k| {
                let frame = path.at(f64::from(k) * ds).0;
                let by_bend = machine.acceleration / frame.curvature.length().max(1e-9);
                let by_jerk = (machine.jerk / frame.sharpness.length().max(1e-9)).cbrt();
                by_bend.min(by_jerk * by_jerk).min(machine.velocity * machine.velocity)
            })
            .collect();
        squares[0] = 0.0;
        squares[fine as usize] = 0.0;
        for k in 1..squares.len() {
            squares[k] = squares[k].min(squares[k - 1] + 2.0 * most * ds);
        }
        for k in (1..squares.len()).rev() {
            squares[k - 1] = squares[k - 1].min(squares[k] + 2.0 * most * ds);
        }
        let mut times = vec![0.0];
        for pair in squares.windows(2) {
            times.push(times[times.len() - 1] + 2.0 * ds / (pair[0].sqrt() + pair[1].sqrt()));
        }
        let whole = times[times.len() - 1];
        // Boxes one after the other, so wide that jerk is small, before and behind which it rests.
        let margin = intervals / 10;
        let inner = intervals - 2 * margin;
        let step = whole / inner as f64;
        let mut on = 0;
        let mut coefficients = vec![0.0; intervals + degree];
        for (k, one) in coefficients.iter_mut().enumerate() {
            let time = (k as f64 - (margin + degree / 2) as f64) * step;
            while on + 2 < times.len() && times[on + 1] < time {
                on += 1;
            }
            let part = (time - times[on]) / (times[on + 1] - times[on]);
            *one = (on as f64 + part.clamp(0.0, 1.0)) * ds;
        }
        for _ in 0..margin - 1 {
            for pass in [1, 0] {
                let old = coefficients.clone();
                for k in 1..old.len() {
                    coefficients[k - pass] = 0.5 * (old[k] + old[k - 1]);
                }
            }
        }
        Self { degree, coefficients, step }
    }

    /// The same law of degree 3, its jerk averaged over an interval.
    pub(crate) fn smoothed(&self) -> Self {
        let (first, last) = (self.coefficients[0], self.coefficients[self.coefficients.len() - 1]);
        let coefficients = [&[first], &self.coefficients[..], &[last]].concat();
        Self { degree: 4, coefficients, step: self.step }
    }

    /// The law that goes the ways that are `period` [s] apart, and rests for a while at either end.
    pub(crate) fn through(ways: &[f64], period: f64, machine: &Machine, intervals: usize) -> Self {
        let degree = if machine.snap.is_some() { 4 } else { 3 };
        let duration = (ways.len() - 1) as f64 * period;
        let step = duration / (intervals - 2 * degree) as f64;
        let lead = degree as f64 + 0.5 * (degree as f64 - 1.0);
        let mut coefficients = Vec::new();
        for k in 0..intervals + degree {
            let mut left = ((k as f64 - lead) * step).clamp(0.0, duration) / period;
            let mut on = 0;
            while left > 1.0 && on + 2 < ways.len() {
                (left, on) = (left - 1.0, on + 1);
            }
            coefficients.push(ways[on] + (ways[on + 1] - ways[on]) * left);
        }
        Self { degree, coefficients, step }
    }

    fn intervals(&self) -> usize {
        self.coefficients.len() - self.degree
    }

    pub(crate) fn duration(&self) -> f64 {
        self.step * self.intervals() as f64
    }

    /// Velocity, acceleration and jerk at a place of an interval, not yet divided by the step.
    fn rates(&self, path: &Path, k: usize, basis: &[[f64; 5]; 4]) -> [Limit; 3] {
        let mut d = [0.0; 4];
        for (order, row) in basis.iter().enumerate() {
            for (value, coefficient) in row.iter().zip(&self.coefficients[k..=k + self.degree]) {
                d[order] += value * coefficient;
            }
        }
        let (frame, fourth) = path.at(d[0]);
        let [first, second, third] = [frame.tangent, frame.curvature, frame.sharpness];
        let [_, v, a, j] = d;
        let mut rates = [Limit::default(); 3];
        rates[0].value = first * v;
        rates[1].value = first * a + second * (v * v);
        rates[2].value = first * j + second * (3.0 * v * a) + third * (v * v * v);
        for i in 0..5 {
            let [s, dv, da, dj] = basis.map(|row| row[i]);
            rates[0].slopes[i] = second * (v * s) + first * dv;
            rates[1].slopes[i] =
                (second * a + third * (v * v)) * s + second * (2.0 * v * dv) + first * da;
            rates[2].slopes[i] = (second * j + third * (3.0 * v * a) + fourth * (v * v * v)) * s
                + (second * (3.0 * a) + third * (3.0 * v * v)) * dv
                + second * (3.0 * v * da)
                + first * dj;
        }
        rates
    }

    /// Calls with the interval and each limit at `places` of it: even ones, both ends among them.
    fn each(
        &self,
        path: &Path,
        machine: &Machine,
        places: usize,
        call: &mut dyn FnMut(usize, u8, &Limit),
    ) {
        let h = self.step;
        let spread = 1.0 / (places - 1) as f64;
        let bases: Vec<_> = (0..places).map(|i| basis(self.degree, i as f64 * spread)).collect();
        for k in 0..self.intervals() {
            let mut before: Option<Limit> = None;
            for basis in &bases {
                let [v, a, j] = self.rates(path, k, basis);
                call(k, 1, &v.scaled(1.0 / (machine.velocity * h), 1.0));
                call(k, 2, &a.scaled(1.0 / (machine.acceleration * h.powi(2)), 2.0));
                call(k, 3, &j.scaled(1.0 / (machine.jerk * h.powi(3)), 3.0));
                if let (Some(snap), Some(before)) = (machine.snap, before) {
                    let mut change = j;
                    change.value -= before.value;
                    for i in 0..5 {
                        change.slopes[i] -= before.slopes[i];
                    }
                    call(k, 4, &change.scaled(1.0 / (snap * h.powi(4) * spread), 4.0));
                }
                before = Some(j);
            }
        }
    }

    /// The factor on time that puts all limits right, looked at `places` of each interval.
    pub(crate) fn excess(&self, path: &Path, machine: &Machine, places: usize) -> f64 {
        let mut worst = 0.0_f64;
        self.each(path, machine, places, &mut |_, power, limit| {
            worst = worst.max(limit.value.length().powf(1.0 / f64::from(power)));
        });
        worst
    }

    fn merit(&self, path: &Path, machine: &Machine, weight: f64) -> f64 {
        let mut merit = self.duration();
        self.each(path, machine, PLACES, &mut |_, _, limit| {
            let room = 1.0 - limit.value.length_squared();
            merit -= weight * if room > 0.0 { room.ln() } else { f64::NEG_INFINITY };
        });
        merit
    }

    /// The law of the shortest time that is found from this one on; the barriers cost at most `gap` of
    /// it.
    pub(crate) fn shortest(mut self, path: &Path, machine: &Machine, gap: f64) -> Self {
        self.step *= 1.05 * self.excess(path, machine, PLACES);
        let fixed = self.degree;
        let free = self.coefficients.len() - 2 * fixed;
        let mut limits = 0.0;
        self.each(path, machine, PLACES, &mut |_, _, _| limits += 1.0);
        let mut weight = 3.0 * self.duration() / limits;
        let mut rows = vec![[0.0; WIDTH + 1]; free];
        let mut right = vec![0.0; free];
        let mut border = vec![0.0; free];
        for _ in 0..2000 {
            rows.fill([0.0; WIDTH + 1]);
            right.fill(0.0);
            border.fill(0.0);
            let whole = self.duration();
            let (mut corner, mut last) = (whole, -whole);
            self.each(path, machine, PLACES, &mut |k, _, limit| {
                let room = 1.0 - limit.value.length_squared();
                let (one, two) = (2.0 * weight / room, 4.0 * weight / (room * room));
                let slopes = limit.slopes.map(|slope| slope.dot(limit.value));
                let by_log = limit.by_log.dot(limit.value);
                last -= one * by_log;
                corner += one * limit.by_log.length_squared() + two * by_log * by_log;
                for i in 0..=fixed {
                    let Some(row) = (k + i).checked_sub(fixed).filter(|row| *row < free) else {
                        continue;
                    };
                    right[row] -= one * slopes[i];
                    border[row] +=
                        one * limit.slopes[i].dot(limit.by_log) + two * slopes[i] * by_log;
                    for j in i.saturating_sub(row)..=i {
                        rows[row][i - j] += one * limit.slopes[i].dot(limit.slopes[j])
                            + two * slopes[i] * slopes[j];
                    }
                }
            });
            let gradient = (right.clone(), last);
            let mut across = border.clone();
            solve(&mut rows, &mut [&mut right, &mut across]);
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let log = (last - dot(&border, &right)) / (corner - dot(&border, &across));
            for (one, across) in right.iter_mut().zip(&across) {
                *one -= across * log;
            }
            let descent = dot(&gradient.0, &right) + gradient.1 * log;
            let (now, mut size) = (self.merit(path, machine, weight), 1.0);
            let trial = loop {
                let mut trial = self.clone();
                for (one, change) in trial.coefficients[fixed..].iter_mut().zip(&right) {
                    *one += size * change;
                }
                trial.step *= (size * log).exp();
                if trial.merit(path, machine, weight) <= now - 0.1 * size * descent {
                    break Some(trial);
                }
                size *= 0.5;
                if size < 1e-7 {
                    break None;
                }
            };
            let stuck = trial.is_none();
            if let Some(trial) = trial {
                self = trial;
            }
            if stuck || descent < 3.0 * weight {
                if weight * limits < gap * whole {
                    break;
                }
                weight *= 0.4;
            }
        }
        self
    }
}

/// Solves band equations for several right sides in place, by Cholesky's rule.
fn solve(rows: &mut [[f64; WIDTH + 1]], sides: &mut [&mut Vec<f64>]) {
    for i in 0..rows.len() {
        let reach = i.min(WIDTH);
        for d in (0..=reach).rev() {
            let column = i - d;
            let mut sum = rows[i][d];
            for e in d + 1..=reach {
                if e - d <= WIDTH {
                    sum -= rows[i][e] * rows[column][e - d];
                }
            }
            rows[i][d] = if d == 0 { sum.max(1e-300).sqrt() } else { sum / rows[column][0] };
        }
        for side in sides.iter_mut() {
            for d in 1..=reach {
                side[i] -= rows[i][d] * side[i - d];
            }
            side[i] /= rows[i][0];
        }
    }
    for i in (0..rows.len()).rev() {
        for side in sides.iter_mut() {
            for d in 1..=WIDTH.min(rows.len() - 1 - i) {
                side[i] -= rows[i + d][d] * side[i + d];
            }
            side[i] /= rows[i][0];
        }
    }
}
