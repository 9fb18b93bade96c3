//! A law of a run that is made faster: sought at its knots, looked at between them, and repaired.

use std::ops::Range;

use super::course::Course;
use super::knots::knots;
use super::law::{Phase, State, length};
use super::reference::state;
use super::retime::{Bounds, Found, Knot, Retiming};
use super::spline::{Basis, bases};
use super::verify::{factor, verify};
use crate::motion::Limits;

/// What a peak may exceed the places by where a law is looked at, as a factor on time.
const SURE: f64 = 1.0004;

/// How often what is broken between knots is made stricter there.
const REPAIRS: usize = 12;

/// In how many rounds of that the law is sought again; in others it is slowed down.
const SOUGHT: usize = 2;

/// How far about such a place it is slowed down, in the time that jerk needs to reach its limit.
const DIP: f64 = 3.0;

/// How soon behind a head the law may be another, in the time that jerk needs to reach its limit.
const LOOSE: f64 = 10.0;

/// From what limits behind a head are exceeded by on the law is sought there once more, and what part
/// of the time of the head is then given back to the law that was given.
const ASTRAY: f64 = 1.1;
const BACK: f64 = 0.15;

/// How much more is taken than what it exceeds.
const DEEPER: f64 = 1.3;

/// Coefficients on either side of such a place that are sought again.
const MARGIN: usize = 16;

/// A law that is made faster.
pub(super) struct Stage<'a> {
    course: &'a Course,
    limits: &'a Limits,
    bounds: &'a Bounds,
    /// The law that was given, at the knots.
    states: Vec<State>,
    knots: Vec<Knot>,
    /// The intervals of the spline [s]; each has a knot at its start and one half-way.
    borders: Vec<f64>,
    bases: Vec<Basis>,
    /// The coefficients of the square of the rate that it is run at.
    c: Vec<f64>,
    /// The law that comes of it.
    pub(super) law: Vec<Phase>,
    /// How long the law before it would have gone on [s], whose state at the start is kept; 0 where it
    /// begins otherwise.
    head: f64,
}

impl<'a> Stage<'a> {
    /// With the coefficients of the law that is given as [`state`] takes them, the borders between which
    /// it is made faster, and how long a law before it would have gone on.
    pub(super) fn new(
        course: &'a Course,
        limits: &'a Limits,
        bounds: &'a Bounds,
        at: &[f64],
        span: f64,
        borders: Vec<f64>,
        head: f64,
    ) -> Self {
        let mut times = Vec::with_capacity(2 * borders.len());
        for pair in borders.windows(2) {
            times.extend([pair[0], f64::midpoint(pair[0], pair[1])]);
        }
        times.extend(borders.last());
        let states: Vec<State> = times.iter().map(|time| state(at, span, *time)).collect();
        let knots = knots(course, limits, &states, &times, span);
        let c = vec![1.0; borders.len() + 2];
        let bases = bases(&borders);
        Self { course, limits, bounds, states, knots, borders, bases, c, law: Vec::new(), head }
    }

    fn is_head(&self) -> bool {
        self.head > 0.0
    }

    /// The first coefficient that is free: three before it keep the state at the start.
    fn first(&self) -> usize {
        if self.is_head() { 3 } else { 0 }
    }

    /// How freely a coefficient may change, from 0 to 1: behind a head more and more.
    fn free(&self, i: usize) -> f64 {
        if !self.is_head() {
            return 1.0;
        }
        smooth(self.place(i) / (LOOSE * self.limits.jerk / self.limits.snap()))
    }

    /// Where a coefficient begins to act on what is behind the first three [s].
    fn place(&self, i: usize) -> f64 {
        self.borders[i.saturating_sub(3).min(self.borders.len() - 1)]
    }

    fn retiming(&self) -> Retiming<'_> {
        Retiming::new(&self.knots, self.bounds, &self.bases, [!self.is_head(), true])
    }

    /// Makes all of the law faster; returns what is then known at its knots.
    pub(super) fn improve(&mut self, weights: [f64; 2], rounds: usize) -> Found {
        let mut c = std::mem::take(&mut self.c);
        let retiming = self.retiming();
        // Slowed down evenly, so that most limits hold at the knots.
        let even = 0.97 * retiming.even(&c);
        for (i, one) in c.iter_mut().enumerate() {
            *one *= 1.0 + (even - 1.0) * self.free(i);
        }
        let all = self.first()..c.len();
        let mut found = retiming.begin();
        retiming.improve(&mut c, &mut found, all, weights, rounds);
        if self.is_head() && rounds > 0 {
            self.begin_again(&retiming, &mut c, &mut found, weights, rounds);
        }
        self.c = c;
        self.law.clear();
        self.phases(0..self.knots.len() - 1);
        found
    }

    /// Seeks the law behind a head once more, from the law that was given, where slowing it down in so
    /// short a time broke limits by more than was taken back.
    fn begin_again(
        &self,
        retiming: &Retiming<'_>,
        c: &mut Vec<f64>,
        found: &mut Found,
        weights: [f64; 2],
        rounds: usize,
    ) {
        let until = |time: f64| self.borders.partition_point(|border| *border < time);
        let worst = |found: &Found, time: f64| {
            let limits = &found.limits[..(2 * until(time) - 1) * retiming.count()];
            limits.iter().fold(0.0_f64, |worst, limit| worst.max(limit.value))
        };
        if worst(found, self.head) < ASTRAY {
            return;
        }
        let old = (c.clone(), found.clone());
        for (i, one) in c.iter_mut().enumerate() {
            let on = (self.place(i) - BACK * self.head) / (self.head - BACK * self.head);
            *one = 1.0 + (*one - 1.0) * smooth(on);
        }
        let last = until(2.0 * self.head).min(c.len());
        retiming.improve(c, found, self.first()..last, weights, rounds);
        if worst(found, 2.0 * self.head) > worst(&old.1, 2.0 * self.head) {
            (*c, *found) = old;
        }
    }

    /// Writes phases of the law.
    fn phases(&mut self, range: Range<usize>) {
        let mut law = std::mem::take(&mut self.law);
        let retiming = self.retiming();
        let state = |k: usize| -> (State, [f64; 3]) {
            let now = retiming.at(&self.c, k);
            let [b, slope, bend] = now;
            let [s, v, a, j] = self.states[k];
            let root = b.sqrt();
            let jerk = root * (j * b + 3.0 * a * slope + v * bend);
            ([s, v * root, a * b + v * slope, jerk], now)
        };
        let mut last = state(range.start);
        for k in range {
            let next = state(k + 1);
            let time = time(last.1, next.1, self.knots[k].step);
            let phase = Phase::between(time, last.0, next.0);
            if k < law.len() {
                law[k] = phase;
            } else {
                law.push(phase);
            }
            last = next;
        }
        self.law = law;
    }

    /// Looks at the law between its knots, and repairs it where it breaks limits; returns the factor
    /// on time that puts right what is left.
    pub(super) fn repair(&mut self, mut found: Found) -> f64 {
        let mut excess = vec![[0.0; 4]; self.law.len()];
        verify(self.course, self.limits, self.bounds, &self.law, 0..self.law.len(), &mut excess);
        let mut best = (self.law.clone(), needed(&excess));
        for round in 0..REPAIRS {
            let ranges = self.tighten(&excess);
            if ranges.is_empty() {
                break;
            }
            let ranges = if round < SOUGHT { ranges } else { self.dip(&excess) };
            for free in ranges {
                if round < SOUGHT {
                    let mut c = std::mem::take(&mut self.c);
                    self.retiming().improve(&mut c, &mut found, free.clone(), [1.0e-3, 1.0e-3], 12);
                    self.c = c;
                }
                let first = (2 * free.start).saturating_sub(6);
                let last = (2 * free.end).min(self.law.len());
                self.phases(first..last);
                // What follows within a period sees other jerks before it.
                let seen = first..(last + 6).min(self.law.len());
                verify(self.course, self.limits, self.bounds, &self.law, seen, &mut excess);
            }
            let factor = needed(&excess);
            if self.cost(&self.law, factor) < self.cost(&best.0, best.1) {
                best = (self.law.clone(), factor);
            }
        }
        let factor = needed(&excess);
        if self.cost(&best.0, best.1) < self.cost(&self.law, factor) {
            self.law = best.0;
            return best.1;
        }
        factor
    }

    /// How long a law lasts once it is put right by a factor on time [s]; one that begins on the move
    /// cannot be.
    fn cost(&self, law: &[Phase], factor: f64) -> f64 {
        match factor {
            ..=1.0 => length(law),
            _ if self.is_head() => f64::INFINITY,
            _ => length(law) * factor,
        }
    }

    /// Slows down gently about phases that exceed limits.
    fn dip(&mut self, excess: &[[f64; 4]]) -> Vec<Range<usize>> {
        let mut ranges = Vec::new();
        let Limits { acceleration, jerk, .. } = *self.limits;
        let mut k = 0;
        while k < excess.len() {
            let from = self.borders[k / 2];
            let (mut to, mut worst) = (from, 0.0_f64);
            // So wide that what slowing down itself takes is less than what it gives.
            let v = self.states[k][1].max(0.0);
            let wide = (v / jerk).sqrt().max(v / acceleration);
            let reach = wide.max(DIP * jerk / self.limits.snap());
            // Those that are close are one, or slowing down would have a kink between them.
            while k < excess.len() && self.borders[k / 2] - to < reach {
                let factor = factor(&excess[k]) * SURE;
                if factor > 1.0 {
                    (to, worst) = (self.borders[k / 2 + 1], worst.max(factor));
                } else if worst == 0.0 {
                    break;
                }
                k += 1;
            }
            k += usize::from(worst == 0.0);
            if worst > 0.0 {
                let part = (DEEPER * (1.0 - 1.0 / (worst * worst)) + 2.0e-4).min(0.5);
                let mut changed = self.c.len()..0;
                let last = self.borders.len() - 1;
                for i in self.first()..self.c.len() {
                    // Where the coefficient has its place in the spline.
                    let border = |k: usize| self.borders[k.saturating_sub(2).min(last)];
                    let place = (border(i) + border(i + 1) + border(i + 2)) / 3.0;
                    let off = (place.clamp(from, to) - place) / reach;
                    if off.abs() < 8.0 {
                        let bump = 1.0 / (1.0 + off * off / 8.0);
                        let bump = bump * bump * bump * bump;
                        self.c[i] *= 1.0 - part * bump * self.free(i);
                        changed.start = changed.start.min(i);
                        changed.end = i + 1;
                    }
                }
                ranges.push(changed);
            }
        }
        ranges
    }

    /// Takes from knots beside a phase what it exceeds its limits by; returns which coefficients are
    /// to be sought again.
    fn tighten(&mut self, excess: &[[f64; 4]]) -> Vec<Range<usize>> {
        let mut ranges: Vec<Range<usize>> = Vec::new();
        for (k, ratios) in excess.iter().enumerate() {
            if factor(ratios) * SURE <= 1.0 {
                continue;
            }
            let first = k.saturating_sub(1);
            let last = (k + 3).min(self.knots.len());
            for knot in &mut self.knots[first..last] {
                for (strict, ratio) in knot.strict.iter_mut().zip(ratios) {
                    if *ratio > 1.0 {
                        // Knots share: more than the square of the ratio is needed.
                        *strict *= (ratio * ratio * 1.003).min(4.0);
                    }
                }
            }
            let from = (k / 2).saturating_sub(MARGIN).max(self.first());
            let to = (k / 2 + 3 + MARGIN).min(self.c.len());
            match ranges.last_mut() {
                Some(range) if range.end + 4 >= from => range.end = to,
                _ => ranges.push(from..to),
            }
        }
        ranges
    }
}

/// A smooth step from 0 to 1.
fn smooth(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

/// The factor on time that puts all phases right, for sure.
pub(super) fn needed(excess: &[[f64; 4]]) -> f64 {
    let mut worst = 0.0_f64;
    for one in excess {
        worst = worst.max(factor(one));
    }
    worst * SURE
}

/// The time `∫ du/√b` between two knots, where `b` is a cubic, by Gauss' rule with four places.
fn time([from, out, _]: [f64; 3], [to, on, _]: [f64; 3], step: f64) -> f64 {
    let rule = [
        (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
        (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
        (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
        (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
    ];
    let mut time = 0.0;
    for (place, weight) in rule {
        let x = place;
        let y = 1.0 - x;
        let b = y * y * ((1.0 + 2.0 * x) * from + 2.0 * x * step * out)
            + x * x * ((1.0 + 2.0 * y) * to - 2.0 * y * step * on);
        time += weight * step / b.sqrt();
    }
    time
}
