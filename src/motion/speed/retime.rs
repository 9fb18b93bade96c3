//! Making a law of motion faster: its time is stretched and shrunk until a limit holds everywhere.
//!
//! Let a law `s(u)` be given, by a parameter `u` that is about time, and with it the path `q(u)`.
//! Run at the rate `du/dt = √b(u)` the machine's acceleration is `b q'' + b' q'/2` and its jerk
//! `√b (b q''' + 3/2 b' q'' + b''/2 q')` (the chain rule): linear in `b` but for the root. So with
//! `b` a cubic spline the shortest time `∫ du/√b` within the limits is sought by an interior-point
//! method: barriers `−μ log(1 − g)` for each limit `g ≤ 1` at each knot, with a falling weight μ, and
//! Newton's method with a banded matrix, where each limit has a price that goes to `μ/(1 − g)` by its own
//! step of Newton's (primal and dual). That `b` is varied and not the velocity keeps stops out of the
//! way: there `q'` vanishes, and `b` stays regular.
//!
//! The first steps are whole ones, for all of the path: limits may be broken by them, and the next ones
//! take that back. Where something still changes or is broken after those it goes on from segment to
//! segment, so that a place where steps must be short does not hold up others. There a limit that is
//! broken is widened, and drawn in while the iteration leaves room; what is left is for the caller to
//! judge.

use std::ops::Range;

use glam::DVec3;

use super::banded;
use super::equations::Work;
use super::limit::{DRAWN, Limit, weight_of, widen};
use super::spline::Basis;
use crate::geometry::nth_root;

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
    /// By what acceleration is multiplied, component by component, to have size 1 at its limit, and
    /// the square of what jerk is multiplied by beyond that: for the vector, and for each axis that has
    /// limits.
    pub(super) scales: Vec<(DVec3, f64)>,
    /// Largest change of the jerk vector in time [mm/s⁴].
    pub(super) snap: f64,
}

/// How strongly the first and last coefficients are held together, so that `b` does not change while
/// the path stands still and nothing else decides on it.
pub(super) const TIE: f64 = 1.0e3;

/// What whole steps leave of the room of a limit at least, and what one has at the start.
const LEFT: f64 = 0.3;
const BEGUN: f64 = 0.1;

/// What a whole step takes of `b` at most.
const TAKEN: f64 = 0.7;

/// Whole steps at the last weight, but for the first.
const SETTLE: usize = 2;

/// What of a coefficient a whole step changes at most where it is the last one there, and how far
/// limits are then broken.
const MOVED: f64 = 0.01;
const BROKEN: f64 = 3.0e-4;

/// What the weight falls by from round to round.
const FALL: f64 = 0.2;

/// Coefficients of a segment.
const SEGMENT: usize = 128;

/// A segment is done where a step makes the merit smaller by less than this of the weight per knot.
const SMALL: f64 = 0.3;

/// Most steps on a segment in a round.
const STEPS: usize = 3;

/// A stretch of knots to be run faster.
#[derive(Debug)]
pub(super) struct Retiming<'a> {
    pub(super) knots: &'a [Knot],
    pub(super) bounds: &'a Bounds,
    /// The splines of `b` at the knots.
    basis: &'a [Basis],
    /// Whether `b` is even at the start and at the end.
    tied: [bool; 2],
}

/// `b`, `b'/2`, `b''/2` and the root of `b` at a knot, and the jerk over that.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rates {
    pub(super) b: [f64; 3],
    pub(super) root: f64,
    pub(super) jerk: DVec3,
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
    pub(super) fn basis(&self, k: usize) -> (usize, &Basis) {
        (if k + 1 == self.knots.len() { k / 2 - 1 } else { k / 2 }, &self.basis[k])
    }

    /// `b`, `b'/2` and `b''/2` at a knot.
    pub(super) fn at(&self, c: &[f64], k: usize) -> [f64; 3] {
        let (first, basis) = self.basis(k);
        let (mut b, mut slope, mut bend) = (0.0, 0.0, 0.0);
        for (c, row) in c[first..].iter().zip(basis) {
            b += c * row[0];
            slope += c * row[1];
            bend += c * row[2];
        }
        [b, slope, bend]
    }

    /// What the square of the change of jerk to the next knot is multiplied by to be 1 at its limit.
    pub(super) fn strictness(&self, knot: &Knot) -> f64 {
        let per = self.bounds.snap * knot.step;
        knot.strict[2] / (per * per)
    }

    /// How many limits there are at a knot: of the velocity, of acceleration and jerk in turns, and of
    /// the snap up to the next knot.
    pub(super) fn count(&self) -> usize {
        2 * self.bounds.scales.len() + 2
    }

    /// The kind of a limit at a knot: 0 velocity, 1 acceleration, 2 jerk, 3 snap.
    fn kind(&self, index: usize) -> usize {
        match index {
            0 => 0,
            _ if index + 1 == self.count() => 3,
            _ => 2 - index % 2,
        }
    }

    /// Finds the rates at some knots, and what the limits are there.
    fn evaluate(&self, c: &[f64], range: &Range<usize>, found: &mut Found) {
        let count = self.count();
        let end = (range.end + 1).min(self.knots.len());
        let (mut last, mut last_jerk) = (0.0, DVec3::ZERO);
        let scales = &self.bounds.scales;
        for k in range.start..end {
            let knot = &self.knots[k];
            let [tangent, second, third] = knot.path;
            let [b, h, e] = self.at(c, k);
            let root = if b > 0.0 { b.sqrt() } else { 0.0 };
            let over = third * b + second * (3.0 * h) + tangent * e;
            found.rates[k] = Rates { b: [b, h, e], root, jerk: over };
            let jerk = over * root;
            if k > range.start {
                let size = (jerk - last_jerk).length_squared();
                found.limits[k * count - 1].value =
                    0.5 * (last + b) * size * self.strictness(&self.knots[k - 1]);
            }
            (last, last_jerk) = (b, jerk);
            if k == range.end {
                break;
            }
            let limits = &mut found.limits[k * count..(k + 1) * count];
            limits[0].value = b / knot.most;
            for (n, (_, ratio)) in scales.iter().enumerate() {
                let [tt, st, ss, ut, us, uu] = found.products[k * scales.len() + n];
                limits[2 * n + 1].value =
                    (b * (ss * b + 2.0 * st * h) + tt * h * h) * knot.strict[0];
                let square = b * (uu * b + 6.0 * us * h + 2.0 * ut * e)
                    + h * (9.0 * ss * h + 6.0 * st * e)
                    + tt * e * e;
                limits[2 * n + 2].value = b * square * knot.strict[1] * ratio;
            }
        }
    }

    /// The time in steps, and the barriers, at some knots; infinite outside the limits.
    fn merit(&self, c: &[f64], range: &Range<usize>, found: &Found, weight: f64) -> f64 {
        let count = self.count();
        let mut merit = 0.0;
        for (i, tied) in self.ties(c.len()) {
            merit += 0.5 * TIE * (c[i] - c[tied]) * (c[i] - c[tied]);
        }
        // Logarithms are dear: one for many factors.
        let mut products = [1.0_f64; 2];
        for k in range.clone() {
            let rates = &found.rates[k];
            if rates.b[0] <= 0.0 {
                return f64::INFINITY;
            }
            merit += self.knots[k].share / rates.root;
            for limit in &found.limits[k * count..(k + 1) * count] {
                let room = 1.0 - limit.value / limit.slack;
                if room <= 0.0 || room.is_nan() {
                    return f64::INFINITY;
                }
                products[usize::from(limit.slack > 1.0)] *= room;
            }
            for (product, weight) in products.iter_mut().zip([weight, weight.max(DRAWN)]) {
                if *product < 1.0e-100 || k + 1 == range.end {
                    merit -= weight * product.ln();
                    *product = 1.0;
                }
            }
        }
        merit
    }

    /// The constant of at most 1 that `b` is to be multiplied by for every limit to hold.
    pub(super) fn even(&self, c: &[f64]) -> f64 {
        let mut found = self.begin();
        self.evaluate(c, &(0..self.knots.len()), &mut found);
        let mut least = 1.0_f64;
        for (index, limit) in found.limits.iter().enumerate() {
            let g = limit.value;
            if g > 1.0 {
                least = least.min(match self.kind(index % self.count()) {
                    0 => 1.0 / g,
                    1 => 1.0 / g.sqrt(),
                    2 => 1.0 / nth_root(g, 3),
                    _ => 1.0 / g.sqrt().sqrt(),
                });
            }
        }
        least
    }

    /// What is to be known at the knots.
    pub(super) fn begin(&self) -> Found {
        let rates = Rates { b: [0.0; 3], root: 0.0, jerk: DVec3::ZERO };
        let limit = Limit { value: 0.0, slack: f64::INFINITY, price: 0.0 };
        let n = self.knots.len();
        let mut products = Vec::with_capacity(n * self.bounds.scales.len());
        for knot in self.knots {
            for (scale, _) in &self.bounds.scales {
                let [t, s, u] = knot.path.map(|derivative| derivative * *scale);
                products.push([t.dot(t), s.dot(t), s.dot(s), u.dot(t), u.dot(s), u.dot(u)]);
            }
        }
        Found { rates: vec![rates; n], limits: vec![limit; n * self.count()], products }
    }

    /// Improves the free ones of the coefficients of `b`: where the weight is to fall from a larger one,
    /// first by whole steps; then in rounds where something still changes or is broken.
    pub(super) fn improve(
        &self,
        c: &mut [f64],
        found: &mut Found,
        free: Range<usize>,
        [start, end]: [f64; 2],
        rounds: usize,
    ) {
        let mut work = Work::default();
        // Segments, from every second of which on the next round has others.
        let half = SEGMENT / 2;
        let mut moving = vec![start <= end; free.len() / half + 2];
        // What they are held to may be another by now.
        self.evaluate(c, &self.reach(&free), found);
        if start > end {
            for i in self.sweep(c, found, &free, [start, end], &mut work) {
                moving[(i - free.start) / half] = true;
            }
        }
        for round in 0..rounds {
            let mut moves = vec![false; moving.len()];
            let mut any = false;
            let mut from = 0;
            while from < free.len() {
                let mut to = from + SEGMENT;
                if from == 0 && round % 2 == 1 {
                    to = half;
                }
                if to + half > free.len() {
                    to = free.len();
                }
                let parts = from / half..to.div_ceil(half);
                if moving[parts.clone()].contains(&true) {
                    let free = free.start + from..free.start + to;
                    let moved = self.segment(c, found, free, end, &mut work);
                    if moved {
                        moves[parts].fill(true);
                        any = true;
                    }
                }
                from = to;
            }
            if !any {
                break;
            }
            moving = moves;
        }
    }

    /// Takes whole steps with falling weights, and marks where that is not enough.
    fn sweep(
        &self,
        c: &mut [f64],
        found: &mut Found,
        free: &Range<usize>,
        [start, end]: [f64; 2],
        work: &mut Work,
    ) -> Vec<usize> {
        let mut weight = start;
        for limit in &mut found.limits {
            limit.slack = limit.value + (1.0 - limit.value).max(BEGUN);
            limit.price = weight / (limit.slack - limit.value);
        }
        let mut left = SETTLE;
        loop {
            self.step(c, found, free.clone(), weight, work);
            if weight <= end {
                if left == 0 {
                    break;
                }
                left -= 1;
            }
            weight = (weight * FALL).max(end);
        }
        let mut marked = Vec::new();
        let count = 2 * self.count();
        for i in free.clone() {
            let moved = (c[i] - work.old[i - free.start]).abs() > MOVED * c[i].abs();
            let limits = i * count..((i + 1) * count).min(found.limits.len());
            let broken = |limit: &Limit| limit.value > 1.0 + BROKEN;
            if moved || found.limits.get(limits).is_some_and(|limits| limits.iter().any(broken)) {
                marked.push(i);
            }
        }
        marked
    }

    /// Takes one whole step: limits may be broken by it, and what they and their rooms then are over 1
    /// is taken back by the next one.
    fn step(
        &self,
        c: &mut [f64],
        found: &mut Found,
        free: Range<usize>,
        weight: f64,
        work: &mut Work,
    ) {
        let range = self.reach(&free);
        let base = range.start / 2;
        let inner = free.start - base..free.end - base;
        self.assemble(c, &range, found, [weight, weight], work);
        let Work { rows, right, old, was, .. } = work;
        old.clear();
        old.extend_from_slice(&c[free.clone()]);
        if !banded::solve(&mut rows[inner.clone()], &mut right[inner.clone()]) {
            return;
        }
        right[..inner.start].fill(0.0);
        right[inner.end..].fill(0.0);
        let mut size = 1.0_f64;
        for k in range.clone() {
            let (first, basis) = self.basis(k);
            let mut change = 0.0;
            for (right, row) in right[first - base..].iter().zip(basis) {
                change += row[0] * right;
            }
            let most = TAKEN * found.rates[k].b[0];
            if size * change < -most {
                size = -most / change;
            }
        }
        for i in inner {
            c[base + i] += size * right[i];
        }
        was.clone_from(&found.limits);
        self.evaluate(c, &range, found);
        for (limit, was) in found.limits.iter_mut().zip(was.iter()) {
            let room = was.slack - was.value;
            let now = (1.0 - limit.value).max(LEFT * room);
            limit.slack = limit.value + now;
            let over = size * (was.slack - 1.0);
            limit.price = was.price(weight, size, over + limit.value - was.value, weight / now);
        }
    }

    /// Takes some steps with some of the coefficients; whether more would help.
    fn segment(
        &self,
        c: &mut [f64],
        found: &mut Found,
        free: Range<usize>,
        weight: f64,
        work: &mut Work,
    ) -> bool {
        let range = self.reach(&free);
        // The first coefficient that acts there, and how many do.
        let base = range.start / 2;
        let n = c.len().min(range.end / 2 + 4) - base;
        let inner = free.start - base..free.end - base;
        let count = self.count();
        let limits = range.start * count..range.end * count;
        let mut feasible = false;
        let mut now = f64::INFINITY;
        let mut size = 1.0;
        for _ in 0..STEPS {
            // What holds once is never broken again: the barriers see to it.
            if !feasible {
                feasible = widen(&mut found.limits[limits.clone()], weight);
                now = self.merit(c, &range, found, weight);
            }
            self.assemble(c, &range, found, [weight, weight.max(DRAWN)], work);
            let Work { rows, right, old, gradient, was, .. } = work;
            gradient.clone_from(right);
            if !banded::solve(&mut rows[inner.clone()], &mut right[inner.clone()]) {
                return false;
            }
            let mut descent = 0.0;
            for i in inner.clone() {
                descent += gradient[i] * right[i];
            }
            old.clear();
            old.extend_from_slice(&c[base..base + n]);
            was.clear();
            was.extend_from_slice(&found.limits[limits.clone()]);
            let mut accepted = false;
            size = (2.0_f64 * size).min(1.0);
            while size > 1.0e-3 {
                for i in inner.clone() {
                    c[base + i] = old[i] + size * right[i];
                }
                self.evaluate(c, &range, found);
                let then = self.merit(c, &range, found, weight);
                if then <= now - 0.1 * size * descent {
                    accepted = true;
                    now = then;
                    break;
                }
                size *= 0.5;
            }
            if !accepted {
                c[base..base + n].copy_from_slice(old);
                self.evaluate(c, &range, found);
            }
            for (limit, was) in found.limits[limits.clone()].iter_mut().zip(was.iter()) {
                let weight = weight_of(limit.slack, weight);
                let even = weight / (limit.slack - limit.value);
                limit.price = even;
                if accepted {
                    limit.price = was.price(weight, size, limit.value - was.value, even);
                }
            }
            if !accepted {
                return false;
            }
            if feasible && descent < SMALL * weight * range.len() as f64 {
                return false;
            }
        }
        true
    }

    /// The coefficients that are held together: each, and the one before it.
    pub(super) fn ties(&self, n: usize) -> impl Iterator<Item = (usize, usize)> {
        let [start, end] = self.tied;
        let ends = [(1, start), (2, start), (3, start), (n - 3, end), (n - 2, end), (n - 1, end)];
        ends.into_iter().filter(|(_, tied)| *tied).map(|(i, _)| (i, i - 1))
    }
}

/// What is known at the knots: rates, and limits.
#[derive(Debug, Clone)]
pub(super) struct Found {
    pub(super) rates: Vec<Rates>,
    /// The products of the derivatives of the path, for each scale: those of the first, the second and
    /// the third with each up to itself, of which the squares of acceleration and jerk are made.
    pub(super) products: Vec<[f64; 6]>,
    /// As many for each knot: of velocity, acceleration and jerk in turns, and snap to the next knot.
    pub(super) limits: Vec<Limit>,
}
