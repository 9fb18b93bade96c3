//! Newton's equations for the coefficients of `b`.

use std::ops::Range;

use glam::DVec3;

use super::banded::Rows;
use super::limit::Limit;
use super::retime::{Found, Retiming, TIE};
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
    /// The first and second derivative of each barrier by the value of its limit: the second that is
    /// there where the limit bends, and that where it rises.
    barriers: Vec<[f64; 3]>,
}

/// What the coefficients at a knot change the jerk there by.
#[derive(Debug, Clone, Copy, Default)]
struct JerkAt {
    first: usize,
    /// What the coefficients count in `b`.
    values: [f64; 4],
    jerk: DVec3,
    by: [DVec3; 4],
}

impl Retiming<'_> {
    /// Writes the equations of Newton's step.
    ///
    /// What a limit at one knot adds is put together by `b`, `b'/2` and `b''/2` there, and carried over
    /// to the coefficients once for all of them. Of the second derivatives of the barriers only the
    /// part that is never negative is kept.
    pub(super) fn assemble(
        &self,
        c: &[f64],
        range: &Range<usize>,
        found: &Found,
        [weight, drawn]: [f64; 2],
        Work { rows, right, barriers, .. }: &mut Work,
    ) {
        let base = range.start / 2;
        let n = c.len().min(range.end / 2 + 4) - base;
        rows.clear();
        rows.resize(n, [1.0e-9, 0.0, 0.0, 0.0]);
        right.clear();
        right.resize(n, 0.0);
        let count = self.count();
        let limits = &found.limits[range.start * count..range.end * count];
        barriers.clear();
        barriers.resize(limits.len(), [0.0; 3]);
        for (barrier, limit) in barriers.iter_mut().zip(limits) {
            let Limit { value, slack, price } = *limit;
            let inverse = 1.0 / (slack - value);
            // Where limits may be broken on the way, what they are over 1 is taken back.
            let over = if drawn > weight { 0.0 } else { price * (slack - 1.0) };
            let weight = if slack > 1.0 { drawn } else { weight };
            let bend = if price > BENT { price } else { BENT };
            *barrier = [(weight + over) * inverse, 2.0 * bend, 4.0 * price * inverse];
        }
        let mut last = JerkAt::default();
        let end = (range.end + 1).min(self.knots.len());
        for k in range.start..end {
            let (first, basis) = self.basis(k);
            let place = first - base;
            let next = self.jerk_at(k, found);
            if k > range.start {
                let barrier = barriers[(k - range.start) * count - 1];
                let place = last.first - base;
                let part = rows[place..place + 4].iter_mut().zip(&mut right[place..place + 4]);
                self.snap(k, found, [&last, &next], barrier, part);
            }
            last = next;
            if k < range.end {
                let local = self.local(k, found, &barriers[(k - range.start) * count..]);
                local.carry(basis, &mut rows[place..place + 4], &mut right[place..place + 4]);
            }
        }
        self.tie(c, base, rows, right);
    }

    /// What the time, the velocity, acceleration and jerk at a knot add.
    fn local(&self, k: usize, found: &Found, barriers: &[[f64; 3]]) -> Local {
        let knot = &self.knots[k];
        let rates = &found.rates[k];
        let [b, h, e] = rates.b;
        let slope = 0.5 * knot.share / (b * rates.root);
        let [one, _, two] = barriers[0];
        let mut r0 = slope - one / knot.most;
        let (mut r1, mut r2) = (0.0, 0.0);
        let mut m00 = 1.5 * slope / b + 0.25 * two / (knot.most * knot.most);
        let (mut m10, mut m11, mut m20, mut m21, mut m22) = (0.0, 0.0, 0.0, 0.0, 0.0);
        let scales = &self.bounds.scales;
        for (n, (_, ratio)) in scales.iter().enumerate() {
            let [tt, st, ss, ut, us, uu] = found.products[k * scales.len() + n];
            // The acceleration: half of its slopes.
            let (x, y) = (ss * b + st * h, st * b + tt * h);
            let strict = knot.strict[0];
            let [one, bend, two] = barriers[2 * n + 1];
            let (one, bend, two) = (2.0 * one * strict, bend * strict, two * strict * strict);
            r0 -= one * x;
            r1 -= one * y;
            m00 += two * x * x + bend * ss;
            m10 += two * x * y + bend * st;
            m11 += two * y * y + bend * tt;
            // b |jerk|²: as if it were b times the slopes, and |jerk|² more by b itself.
            let (us, ss, st) = (3.0 * us, 9.0 * ss, 3.0 * st);
            let x = uu * b + us * h + ut * e;
            let y = us * b + ss * h + st * e;
            let z = ut * b + st * h + tt * e;
            let more = x + 0.5 * (x * b + y * h + z * e) / b;
            let strict = knot.strict[1] * ratio * b;
            let [one, bend, two] = barriers[2 * n + 2];
            let (one, bend, two) = (2.0 * one * strict, bend * strict, two * strict * strict);
            let x = more;
            r0 -= one * x;
            r1 -= one * y;
            r2 -= one * z;
            m00 += two * x * x + bend * uu;
            m10 += two * x * y + bend * us;
            m11 += two * y * y + bend * ss;
            m20 += two * x * z + bend * ut;
            m21 += two * y * z + bend * st;
            m22 += two * z * z + bend * tt;
        }
        Local { right: [r0, r1, r2], matrix: [m00, m10, m11, m20, m21, m22] }
    }

    /// The derivatives of the jerk at a knot.
    fn jerk_at(&self, k: usize, found: &Found) -> JerkAt {
        let (first, basis) = self.basis(k);
        let rates = &found.rates[k];
        let [tangent, second, third] = self.knots[k].path;
        let jerk = rates.jerk * rates.root;
        let x = third * rates.root + rates.jerk * (0.5 / rates.root);
        let y = second * (3.0 * rates.root);
        let z = tangent * rates.root;
        let mut at = JerkAt { first, jerk, ..JerkAt::default() };
        for (i, row) in basis.iter().enumerate() {
            at.values[i] = row[0];
            at.by[i] = x * row[0] + y * row[1] + z * row[2];
        }
        at
    }

    /// Adds the barrier of the change of jerk to a knot from the one before it.
    fn snap<'a>(
        &self,
        k: usize,
        found: &Found,
        [last, next]: [&JerkAt; 2],
        [one, bend, two]: [f64; 3],
        part: impl Iterator<Item = (&'a mut [f64; 4], &'a mut f64)>,
    ) {
        let knot = &self.knots[k - 1];
        let change = next.jerk - last.jerk;
        let strict = self.strictness(knot);
        let mean = 0.5 * (found.rates[k - 1].b[0] + found.rates[k].b[0]);
        let even = 0.25 * change.length_squared() * strict;
        let along = mean * strict;
        // Both knots are in one interval of the spline, whose coefficients are those of the first.
        let shift = next.first - last.first;
        let mut values = last.by;
        let mut slopes = [0.0; 4];
        for i in 0..4 {
            values[i] = -values[i];
            let mut sum = last.values[i];
            if i >= shift {
                values[i] += next.by[i - shift];
                sum += next.values[i - shift];
            }
            slopes[i] = even * sum + along * values[i].dot(change);
        }
        let bend = bend * along;
        for (i, (row, right)) in part.enumerate() {
            *right -= 2.0 * one * slopes[i];
            let (slope, value) = (two * slopes[i], values[i] * bend);
            for d in 0..4 {
                if d <= i {
                    row[d] += slope * slopes[i - d] + value.dot(values[i - d]);
                }
            }
        }
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

/// Newton's equations by `b`, `b'/2` and `b''/2` at a knot: the lower half of the matrix row by row.
#[derive(Debug, Clone, Copy)]
struct Local {
    right: [f64; 3],
    matrix: [f64; 6],
}

impl Local {
    /// Carries them over to the four coefficients.
    fn carry(&self, basis: &Basis, rows: &mut [[f64; 4]], right: &mut [f64]) {
        let [m00, m10, m11, m20, m21, m22] = self.matrix;
        for i in 0..4 {
            let [x, y, z] = basis[i];
            right[i] += self.right[0] * x + self.right[1] * y + self.right[2] * z;
            let a = m00 * x + m10 * y + m20 * z;
            let b = m10 * x + m11 * y + m21 * z;
            let c = m20 * x + m21 * y + m22 * z;
            for d in 0..4 {
                if d <= i {
                    let [x, y, z] = basis[i - d];
                    rows[i][d] += a * x + b * y + c * z;
                }
            }
        }
    }
}
