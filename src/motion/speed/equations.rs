//! Newton's equations for the coefficients of `b`.

use std::ops::Range;

use glam::DVec3;

use super::banded::Rows;
use super::limit::Limit;
use super::retime::{Found, Rates, Retiming, TIE};
use super::spline::Basis;

/// The least price that bends the merit: where a limit has none, a step would take it far beyond.
const BENT: f64 = 0.03;

/// Room for the equations of a segment, and what was before a step.
#[derive(Debug, Default)]
pub(super) struct Work {
    pub(super) rows: Rows,
    pub(super) right: Vec<f64>,
    pub(super) gradient: Vec<f64>,
    pub(super) old: Vec<f64>,
    pub(super) was: Vec<Limit>,
}

impl Retiming<'_> {
    /// Writes the equations of Newton's step.
    ///
    /// What a limit at one knot adds is put together by `b`, `b'` and `b''` there, and carried over to
    /// the coefficients once for all of them. Of the second derivatives of the barriers only the part
    /// that is never negative is kept.
    pub(super) fn assemble(
        &self,
        c: &[f64],
        range: &Range<usize>,
        found: &Found,
        [weight, drawn]: [f64; 2],
        Work { rows, right, .. }: &mut Work,
    ) {
        let base = range.start / 2;
        let n = c.len().min(range.end / 2 + 4) - base;
        rows.clear();
        rows.resize(n, [1.0e-9, 0.0, 0.0, 0.0]);
        right.clear();
        right.resize(n, 0.0);
        let count = self.count();
        for k in range.clone() {
            let knot = &self.knots[k];
            let rates = &found.rates[k];
            let Rates { b, root, .. } = *rates;
            let barrier = |index: usize| {
                let Limit { value, slack, price } = found.limits[k * count + index];
                let inverse = 1.0 / (slack - value);
                // Where limits may be broken on the way, what they are over 1 is taken back.
                let over = if drawn > weight { 0.0 } else { price * (slack - 1.0) };
                let weight = if slack > 1.0 { drawn } else { weight };
                [(weight + over) * inverse, price.max(BENT), price * inverse]
            };
            let [tangent, second, third] = knot.path;
            let [strict_a, strict_j, strict_s] = knot.strict;
            let (first, basis) = self.basis(k);
            let place = first - base;
            // The time 1/√b, and the velocity.
            let mut local = Local::default();
            let slope = 0.5 * knot.share / (b * root);
            let [one, _, two] = barrier(0);
            local.right[0] = slope - one / knot.most;
            local.matrix[0] = 1.5 * slope / b + two / (knot.most * knot.most);
            let mut index = 1;
            for [a, j] in &self.bounds.scales {
                let value = rates.acceleration * *a;
                let values = [second * *a, tangent * *a * 0.5, DVec3::ZERO];
                let [one, bend, two] = barrier(index);
                local.add(
                    &values,
                    value,
                    0.0,
                    [one * strict_a, bend * strict_a, two * strict_a * strict_a],
                );
                let value = rates.jerk * *j;
                let values = [third * *j, second * *j * 1.5, tangent * *j * 0.5];
                let size = value.length_squared();
                let [one, bend, two] = barrier(index + 1);
                // b |value|²: as if it were b times the slopes, and |value|² more by b itself.
                let strict = strict_j * b;
                local.add(
                    &values,
                    value,
                    size / b,
                    [one * strict, bend * strict, two * strict * strict],
                );
                index += 2;
            }
            local.carry(basis, &mut rows[place..place + 4], &mut right[place..place + 4]);
            if k + 1 == self.knots.len() {
                break;
            }
            let next = &found.rates[k + 1];
            let (next_first, next_basis) = self.basis(k + 1);
            let change = next.jerk * next.root - rates.jerk * root;
            let per = self.bounds.snap * knot.step;
            let strict_s = strict_s / (per * per);
            let mean = 0.5 * (b + next.b);
            let size = change.length_squared();
            let [one, bend, two] = barrier(index);
            // Both knots are in one interval of the spline, whose coefficients are those of the first.
            let mut values = [DVec3::ZERO; 4];
            let mut slopes = [0.0; 4];
            let ends =
                [(k, rates, basis, 0, -1.0), (k + 1, next, next_basis, next_first - first, 1.0)];
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
            let bend = 2.0 * bend * mean * strict_s;
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
        }
        self.tie(c, base, rows, right);
    }

    /// Adds what holds coefficients together.
    fn tie(&self, c: &[f64], base: usize, rows: &mut Rows, right: &mut [f64]) {
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
    fn add(&mut self, values: &[DVec3; 3], value: DVec3, more: f64, [one, bend, two]: [f64; 3]) {
        let mut slopes = values.map(|slope| 2.0 * slope.dot(value));
        slopes[0] += more;
        let mut place = 0;
        for i in 0..3 {
            self.right[i] -= one * slopes[i];
            for j in 0..=i {
                self.matrix[place] +=
                    two * slopes[i] * slopes[j] + 2.0 * bend * values[i].dot(values[j]);
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
