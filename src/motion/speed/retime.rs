//! Making a law of motion faster: its time is stretched and shrunk until a limit holds everywhere.
//!
//! Let a law `s(u)` be given, by a parameter `u` that is about time, and with it the path `q(u)`.
//! Run at the rate `du/dt = √b(u)` the machine's acceleration is `b q'' + b' q'/2` and its jerk
//! `√b (b q''' + 3/2 b' q'' + b''/2 q')` (the chain rule): linear in `b` but for the root. So with
//! `b` a cubic spline the shortest time `∫ du/√b` within the limits is sought by an interior-point
//! method: barriers `−μ log(1 − g)` for each limit `g ≤ 1` at each knot, Newton's method with a
//! banded matrix, and a falling weight μ. That `b` is varied and not the velocity keeps stops out of
//! the way: there `q'` vanishes, and `b` stays regular.
//!
//! Where a limit is broken at the start it is widened, and drawn in while the iteration leaves room;
//! what is left is for the caller to judge.

use std::ops::Range;

use glam::DVec3;

use super::banded::{self, Rows};
use super::spline::Basis;

/// The path at a knot. Each interval of the spline `b` has one at its start and one half-way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Knot {
    /// The derivatives `q'`, `q''` and `q'''` by the parameter.
    pub(super) path: [DVec3; 3],
    /// What `b` may be at most for the sake of velocity and chord error.
    pub(super) most: f64,
    /// The time of the parameter to the next knot [s], and its share of the time of the path.
    pub(super) step: f64,
    pub(super) share: f64,
    /// Inverse squares of the shares of acceleration, jerk and snap that may be used.
    pub(super) strict: [f64; 3],
}

/// What the rates are held to.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Bounds {
    /// By what acceleration and jerk are multiplied, component by component, to have size 1 at their
    /// limits: for the vector, and for each axis that has limits.
    pub(super) scales: Vec<[DVec3; 2]>,
    /// Largest change of the jerk vector in time [mm/s⁴].
    pub(super) snap: f64,
}

/// How strongly the first and last coefficients are held together, so that `b` does not change while
/// the path stands still and nothing else decides on it.
const TIE: f64 = 1.0e3;

/// The weight of the barriers of limits that are broken: it draws `b` away from them.
const DRAWN: f64 = 5.0;

/// What the limits are widened by: velocity, acceleration and jerk, snap to the next knot.
type Slack = [f64; 3];

/// The most limits at a knot: velocity, acceleration and jerk of the vector and of three axes, snap.
const MOST_LIMITS: usize = 10;

/// A stretch of knots to be run faster.
#[derive(Debug)]
pub(super) struct Retiming<'a> {
    knots: &'a [Knot],
    bounds: &'a Bounds,
    /// The splines of `b` at the knots.
    basis: &'a [Basis],
    /// Whether `b` is even at the start and at the end.
    tied: [bool; 2],
}

/// `b` and its root at a knot, and acceleration and jerk, the latter over the root.
#[derive(Debug, Clone, Copy)]
struct Rates {
    b: f64,
    root: f64,
    acceleration: DVec3,
    jerk: DVec3,
}

impl<'a> Retiming<'a> {
    pub(super) fn new(
        knots: &'a [Knot],
        bounds: &'a Bounds,
        basis: &'a [Basis],
        tied: [bool; 2],
    ) -> Self {
        Self { knots, bounds, basis, tied }
    }

    /// The knots that some of the coefficients act on.
    fn reach(&self, free: &Range<usize>) -> Range<usize> {
        // The limit of snap at a knot is to the next.
        let first = (2 * free.start).saturating_sub(7);
        first..(2 * free.end + 1).min(self.knots.len())
    }

    /// The first coefficient and the basis at a knot.
    fn basis(&self, k: usize) -> (usize, &Basis) {
        (if k + 1 == self.knots.len() { k / 2 - 1 } else { k / 2 }, &self.basis[k])
    }

    /// `b`, `b'` and `b''` at a knot.
    pub(super) fn at(&self, c: &[f64], k: usize) -> [f64; 3] {
        let (first, basis) = self.basis(k);
        let c = &c[first..first + 4];
        let dot = |row: &[f64; 4]| row[0] * c[0] + row[1] * c[1] + row[2] * c[2] + row[3] * c[3];
        [dot(&basis[0]), dot(&basis[1]), dot(&basis[2])]
    }

    fn rates(&self, c: &[f64], k: usize) -> Rates {
        let [b, slope, bend] = self.at(c, k);
        let [first, second, third] = self.knots[k].path;
        Rates {
            b,
            root: b.max(0.0).sqrt(),
            acceleration: second * b + first * (0.5 * slope),
            jerk: third * b + second * (1.5 * slope) + first * (0.5 * bend),
        }
    }

    /// The `g` of the limits at a knot, and how many they are: of the velocity, of acceleration and
    /// jerk in turns, and of the snap up to the next knot.
    fn values(&self, k: usize, rates: &Rates, next: Option<&Rates>) -> ([f64; MOST_LIMITS], usize) {
        let knot = &self.knots[k];
        let [strict_a, strict_j, strict_s] = knot.strict;
        let mut values = [0.0; MOST_LIMITS];
        values[0] = rates.b / knot.most;
        let mut count = 1;
        for [a, j] in &self.bounds.scales {
            values[count] = (rates.acceleration * *a).length_squared() * strict_a;
            values[count + 1] = rates.b * (rates.jerk * *j).length_squared() * strict_j;
            count += 2;
        }
        if let Some(next) = next {
            let change = next.jerk * next.root - rates.jerk * rates.root;
            let per = self.bounds.snap * knot.step;
            let size = change.length_squared() / (per * per);
            values[count] = 0.5 * (rates.b + next.b) * size * strict_s;
            count += 1;
        }
        (values, count)
    }

    /// Calls with each knot of a range, its rates and its limits.
    fn each(&self, c: &[f64], range: Range<usize>, call: &mut dyn FnMut(usize, &Rates, &[f64])) {
        if range.is_empty() {
            return;
        }
        let mut rates = self.rates(c, range.start);
        for k in range {
            let next = (k + 1 < self.knots.len()).then(|| self.rates(c, k + 1));
            let (values, count) = self.values(k, &rates, next.as_ref());
            call(k, &rates, &values[..count]);
            rates = next.unwrap_or(rates);
        }
    }

    /// The kind of a limit at a knot: 0 velocity, 1 acceleration, 2 jerk, 3 snap.
    fn kind(&self, index: usize) -> usize {
        match index {
            0 => 0,
            _ if index > 2 * self.bounds.scales.len() => 3,
            _ => 2 - index % 2,
        }
    }

    /// The constant of at most 1 that `b` is to be multiplied by for every limit to hold.
    pub(super) fn even(&self, c: &[f64]) -> f64 {
        let mut least = 1.0_f64;
        self.each(c, 0..self.knots.len(), &mut |_, _, values| {
            for (index, g) in values.iter().copied().enumerate() {
                if g > 1.0 {
                    least = least.min(match self.kind(index) {
                        0 => 1.0 / g,
                        1 => 1.0 / g.sqrt(),
                        2 => 1.0 / g.cbrt(),
                        _ => 1.0 / g.sqrt().sqrt(),
                    });
                }
            }
        });
        least
    }

    /// Improves the free ones of the coefficients of `b`; `true` where every limit holds that they
    /// act on.
    pub(super) fn improve(
        &self,
        c: &mut [f64],
        free: Range<usize>,
        [start, end]: [f64; 2],
        rounds: usize,
    ) -> bool {
        let range = self.reach(&free);
        // The first coefficient that acts there, and how many do.
        let base = range.start / 2;
        let n = c.len().min(range.end / 2 + 4) - base;
        let inner = free.start - base..free.end - base;
        let mut rows: Rows = vec![[0.0; 4]; n];
        let mut right = vec![0.0; n];
        let mut gradient = vec![0.0; n];
        let mut old = vec![0.0; n];
        let mut slack = vec![[f64::INFINITY; 3]; range.len()];
        let mut weight = start;
        let mut feasible = false;
        let mut size = 1.0;
        let mut now = [f64::INFINITY; 3];
        for round in 0..rounds {
            // What holds once is never broken again: the barriers see to it.
            if !feasible {
                feasible = self.widen(c, &range, &mut slack);
                if feasible && round > 0 {
                    weight = weight.max(start);
                }
                now = self.merit(c, &range, &slack);
            }
            self.assemble(c, &range, &slack, weight, &mut rows, &mut right);
            gradient.copy_from_slice(&right);
            if !banded::solve(&mut rows[inner.clone()], &mut right[inner.clone()]) {
                break;
            }
            let mut descent = 0.0;
            for i in inner.clone() {
                descent += gradient[i] * right[i];
            }
            let mut accepted = false;
            size = (2.0_f64 * size).min(1.0);
            old.copy_from_slice(&c[base..base + n]);
            while size > 1.0e-4 {
                for i in inner.clone() {
                    c[base + i] = old[i] + size * right[i];
                }
                let then = self.merit(c, &range, &slack);
                if sum(then, weight) <= sum(now, weight) - 0.1 * size * descent {
                    accepted = true;
                    now = then;
                    break;
                }
                size *= 0.5;
            }
            if !accepted {
                c[base..base + n].copy_from_slice(&old);
            }
            let small = descent < 0.5 * weight * range.len() as f64;
            if feasible && (!accepted || small || size > 0.5) {
                if weight <= end && (small || !accepted) {
                    break;
                }
                weight = (weight * if small { 0.1 } else { 0.3 }).max(end);
            } else if !accepted {
                break;
            }
        }
        feasible || self.widen(c, &range, &mut slack)
    }

    /// Widens limits that are broken, and draws in those that were; `true` where none is wide.
    fn widen(&self, c: &[f64], range: &Range<usize>, slack: &mut [Slack]) -> bool {
        let mut feasible = true;
        self.each(c, range.clone(), &mut |k, _, values| {
            let mut found = [0.0_f64; 3];
            for (index, g) in values.iter().enumerate() {
                let group = GROUPS[self.kind(index)];
                found[group] = found[group].max(*g);
            }
            for (wide, g) in slack[k - range.start].iter_mut().zip(found) {
                let now = (1.1 * g).max(1.0);
                *wide = if g < 1.0 { 1.0 } else { wide.min(now) };
                feasible &= *wide <= 1.0;
            }
        });
        feasible
    }

    /// The time in steps, and what the barriers of limits that hold and of those that do not add at
    /// weight 1; infinite outside the limits.
    fn merit(&self, c: &[f64], range: &Range<usize>, slack: &[Slack]) -> [f64; 3] {
        let mut found = [0.0; 3];
        for (i, tied) in self.ties(c.len()) {
            found[0] += 0.5 * TIE * (c[i] - c[tied]) * (c[i] - c[tied]);
        }
        // Logarithms are dear: one for many factors.
        let mut products = [1.0_f64; 2];
        let mut inside = true;
        self.each(c, range.clone(), &mut |k, rates, values| {
            inside &= rates.b > 0.0;
            found[0] += self.knots[k].share / rates.root;
            for (index, g) in values.iter().enumerate() {
                let slack = slack[k - range.start][GROUPS[self.kind(index)]];
                let wide = usize::from(slack > 1.0);
                let room = if slack > 1.0 { 1.0 - g / slack } else { 1.0 - g };
                inside &= room > 0.0;
                products[wide] *= room;
            }
            for (product, found) in products.iter_mut().zip(&mut found[1..]) {
                if *product < 1.0e-100 {
                    *found -= product.ln();
                    *product = 1.0;
                }
            }
        });
        if !inside {
            return [f64::INFINITY; 3];
        }
        found[1] -= products[0].ln();
        found[2] -= products[1].ln();
        found
    }

    /// Writes the equations of Newton's step.
    ///
    /// What a limit at one knot adds is put together by `b`, `b'` and `b''` there, and carried over to
    /// the coefficients once for all of them. Of the second derivatives of the barriers only the part
    /// that is never negative is kept.
    fn assemble(
        &self,
        c: &[f64],
        range: &Range<usize>,
        slack: &[Slack],
        weight: f64,
        rows: &mut [[f64; 4]],
        right: &mut [f64],
    ) {
        rows.fill([1.0e-9, 0.0, 0.0, 0.0]);
        right.fill(0.0);
        let base = range.start / 2;
        let barrier = |slack: f64, g: f64| {
            let weight = if slack > 1.0 { weight.max(DRAWN) } else { weight };
            let one = weight / (slack - g);
            (one, one / (slack - g))
        };
        let mut rates = self.rates(c, range.start);
        for k in range.clone() {
            let knot = &self.knots[k];
            let Rates { b, root, .. } = rates;
            let [tangent, second, third] = knot.path;
            let [strict_a, strict_j, strict_s] = knot.strict;
            let (first, basis) = self.basis(k);
            let slack = &slack[k - range.start];
            let place = first - base;
            // The time 1/√b, and the velocity.
            let mut local = Local::default();
            let slope = 0.5 * knot.share / (b * root);
            let (one, two) = barrier(slack[0], b / knot.most);
            local.right[0] = slope - one / knot.most;
            local.matrix[0] = 1.5 * slope / b + two / (knot.most * knot.most);
            for [a, j] in &self.bounds.scales {
                let value = rates.acceleration * *a;
                let values = [second * *a, tangent * *a * 0.5, DVec3::ZERO];
                let (one, two) = barrier(slack[1], value.length_squared() * strict_a);
                local.add(&values, value, 0.0, [one * strict_a, two * strict_a * strict_a]);
                let value = rates.jerk * *j;
                let values = [third * *j, second * *j * 1.5, tangent * *j * 0.5];
                let size = value.length_squared();
                let (one, two) = barrier(slack[1], b * size * strict_j);
                // b |value|²: as if it were b times the slopes, and |value|² more by b itself.
                let factors = [one * strict_j * b, two * strict_j * strict_j * b * b];
                local.add(&values, value, size / b, factors);
            }
            local.carry(basis, &mut rows[place..place + 4], &mut right[place..place + 4]);
            if k + 1 == self.knots.len() {
                break;
            }
            let next = self.rates(c, k + 1);
            let (next_first, next_basis) = self.basis(k + 1);
            let change = next.jerk * next.root - rates.jerk * root;
            let per = self.bounds.snap * knot.step;
            let strict_s = strict_s / (per * per);
            let mean = 0.5 * (b + next.b);
            let size = change.length_squared();
            let (one, two) = barrier(slack[2], mean * size * strict_s);
            // Both knots are in one interval of the spline, whose coefficients are those of the first.
            let mut values = [DVec3::ZERO; 4];
            let mut slopes = [0.0; 4];
            let ends =
                [(k, &rates, basis, 0, -1.0), (k + 1, &next, next_basis, next_first - first, 1.0)];
            for (k, rates, basis, shift, sign) in ends {
                let [tangent, second, third] = self.knots[k].path;
                let root = sign * rates.root;
                let by = [
                    third * root + rates.jerk * (0.5 / root),
                    second * (1.5 * root),
                    tangent * (0.5 * root),
                ];
                for i in shift..4 {
                    let j = i - shift;
                    values[i] += by[0] * basis[0][j] + by[1] * basis[1][j] + by[2] * basis[2][j];
                    slopes[i] += 0.5 * basis[0][j] * size * strict_s;
                }
            }
            let bend = 2.0 * one * mean * strict_s;
            for i in 0..4 {
                slopes[i] += 2.0 * mean * strict_s * values[i].dot(change);
            }
            for i in 0..4 {
                right[place + i] -= one * slopes[i];
                let row = &mut rows[place + i];
                let (along, value) = (two * slopes[i], values[i] * bend);
                for j in 0..=i {
                    row[i - j] += along * slopes[j] + value.dot(values[j]);
                }
            }
            rates = next;
        }
        for (i, tied) in self.ties(c.len()) {
            if tied >= base && i < base + right.len() {
                let gap = c[i] - c[tied];
                right[i - base] -= TIE * gap;
                right[tied - base] += TIE * gap;
                rows[i - base][0] += TIE;
                rows[tied - base][0] += TIE;
                rows[i - base][1] -= TIE;
            }
        }
    }

    /// The coefficients that are held together: each, and the one before it.
    fn ties(&self, n: usize) -> impl Iterator<Item = (usize, usize)> {
        let [start, end] = self.tied;
        let ends = [(1, start), (2, start), (3, start), (n - 3, end), (n - 2, end), (n - 1, end)];
        ends.into_iter().filter(|(_, tied)| *tied).map(|(i, _)| (i, i - 1))
    }
}

/// Which of the slacks each kind of limit has.
const GROUPS: [usize; 4] = [0, 1, 1, 2];

/// The merit: the time with the barriers at their weights.
fn sum([time, held, broken]: [f64; 3], weight: f64) -> f64 {
    time + weight * held + weight.max(DRAWN) * broken
}

/// Newton's equations by `b`, `b'` and `b''` at a knot: the lower half of the matrix row by row.
#[derive(Debug, Clone, Copy, Default)]
struct Local {
    right: [f64; 3],
    matrix: [f64; 6],
}

impl Local {
    /// Adds the barrier of `|value|²`, whose derivatives are `values`, and to whose slope by `b`
    /// `more` is added; its first and second derivative are the factors.
    fn add(&mut self, values: &[DVec3; 3], value: DVec3, more: f64, [one, two]: [f64; 2]) {
        let mut slopes = values.map(|slope| 2.0 * slope.dot(value));
        slopes[0] += more;
        let mut place = 0;
        for i in 0..3 {
            self.right[i] -= one * slopes[i];
            for j in 0..=i {
                self.matrix[place] +=
                    two * slopes[i] * slopes[j] + 2.0 * one * values[i].dot(values[j]);
                place += 1;
            }
        }
    }

    /// Carries them over to the four coefficients.
    fn carry(&self, basis: &Basis, rows: &mut [[f64; 4]], right: &mut [f64]) {
        let [m00, m10, m11, m20, m21, m22] = self.matrix;
        for i in 0..4 {
            let [x, y, z] = [basis[0][i], basis[1][i], basis[2][i]];
            right[i] += self.right[0] * x + self.right[1] * y + self.right[2] * z;
            let along = [
                m00 * x + m10 * y + m20 * z,
                m10 * x + m11 * y + m21 * z,
                m20 * x + m21 * y + m22 * z,
            ];
            let row = &mut rows[i];
            for j in 0..=i {
                row[i - j] +=
                    along[0] * basis[0][j] + along[1] * basis[1][j] + along[2] * basis[2][j];
            }
        }
    }
}
