//! The smoothest spline inside a tube round a polygon.
//!
//! Of all quintic splines on given knots it looks for the one with the least `∫ |r'''|² du`, the
//! place `u` along the polygon standing for arc length, that is nowhere farther from the polygon
//! than the tolerance: the third derivative is what limits the speed once jerk is limited. The
//! method is that of multipliers with alternating directions (ADMM; Boyd and others, 2011, 3.1): a
//! least squares fit to targets, of which each then moves to where it draws the spline back into the
//! tube, if it was outside, and lets go if it was not. The equations stay the same for many fits, so
//! that they are decomposed once for them.
//!
//! Then every interval is proved to be within the tolerance. Where some are not, fits go on for those
//! and what is near them: the rest has settled.

use std::ops::Range;

use glam::{DVec3, DVec4, Vec4Swizzles};

use super::banded;
use super::basis::{powers, weights};
use super::layout::Vertex;

/// Samples of an interval that a fit looks at; the proof at the end looks at all of it.
const SAMPLES: usize = 8;

/// Fits before a proof is tried.
const ROUNDS: usize = 20;

/// Proofs that are tried, and after how many the weight grows.
const TRIALS: usize = 8;
const PATIENCE: usize = 2;

/// What the fits aim at, in tolerances, so that few fail the proof.
const AIM: f64 = 0.9;

/// The weight of a sample, in those at which a spline just follows a polygon with corners a few
/// knots apart (`step⁻⁶`), and by how much it grows: heavy ones find their way into the tube soon,
/// light ones find the smoothest way.
const WEIGHT: f64 = 100.0;
const GROWTH: f64 = 10.0;

/// The least speed of the spline by the place along the polygon: about twice that where it rounds the
/// sharpest corner; where it all but stands, its length is hard to tell.
const SLOWEST: f64 = 0.2;

/// By how much more than it would a target moves each time.
const RELAXATION: f64 = 1.6;

/// The weight of an end point, in the same measure.
const END_WEIGHT: f64 = 1e6;

/// How many intervals beside one that left the tube are fitted again with it: over so many its
/// influence dies away.
const MARGIN: usize = 10;

/// Where a fit compares the spline with the polygon.
#[derive(Debug, Clone, Copy)]
struct Sample {
    /// What the six control points count there.
    values: [f64; 6],
    /// The point of the polygon [mm].
    target: DVec3,
    /// How much it counts.
    weight: f64,
    /// Where relative to the target the spline may be, inside the tube [mm].
    inside: DVec3,
    /// By how much more than that it is drawn inwards, the sum over the fits [mm].
    pull: DVec3,
}

/// A spline along a polygon.
#[derive(Debug)]
pub(super) struct Tube<'a> {
    /// The polygon.
    pub(super) vertices: &'a [Vertex],
    /// Control points [mm], the fourth coordinate being the place along the polygon [mm], which
    /// grows.
    pub(super) controls: Vec<DVec4>,
    /// How many of the first and of the last control points are given.
    pub(super) fixed: [usize; 2],
    /// How far the spline may be from the polygon [mm].
    pub(super) tolerance: f64,
}

impl Tube<'_> {
    /// How many intervals there are.
    pub(super) fn count(&self) -> usize {
        self.controls.len() - 5
    }

    /// Finds the control points that are not given. `true` if all intervals keep the tolerance;
    /// else `broken` tells for each whether it does not.
    pub(super) fn smooth(&mut self, broken: &mut Vec<bool>) -> bool {
        let mut samples = self.samples();
        let count = self.count();
        broken.clear();
        broken.resize(count, true);
        for trial in 0..TRIALS {
            let mut from = 0;
            while let Some(range) = near(broken, from) {
                from = range.end;
                let samples = &mut samples[SAMPLES * range.start..SAMPLES * range.end];
                if trial > 0 && trial % PATIENCE == 0 {
                    for sample in &mut *samples {
                        sample.weight *= GROWTH;
                        sample.pull /= GROWTH;
                    }
                }
                self.fit(samples, range.clone());
                for k in range {
                    if !self.controls[k + 5].is_finite() {
                        return false;
                    }
                    broken[k] = self.farthest(k) > self.tolerance || !self.runs_on(k);
                }
            }
            if !broken.contains(&true) {
                return true;
            }
        }
        false
    }

    /// What a fit looks at: samples at equal distances, those next to a corner of the polygon moved
    /// to it, as the spline is farthest from the polygon there.
    fn samples(&self) -> Vec<Sample> {
        let mut all = Vec::with_capacity(SAMPLES * self.count());
        let mut leg = 0;
        for k in 0..self.count() {
            let places = Places::new(&powers(&self.controls[k..]));
            let step = self.controls[k + 3].w - self.controls[k + 2].w;
            let per_fifth = WEIGHT * step.powi(-5) / SAMPLES as f64;
            let mut at = [0.0; SAMPLES];
            for (i, at) in at.iter_mut().enumerate() {
                *at = (i as f64 + 0.5) / SAMPLES as f64;
            }
            let mut next = leg + 1;
            while next + 1 < self.vertices.len() && self.vertices[next].place <= places.end {
                let place = self.vertices[next].place;
                if place > places.powers[0] {
                    let t = places.find(place, 0.0);
                    let mut nearest = 0;
                    for i in 1..SAMPLES {
                        if (at[i] - t).abs() < (at[nearest] - t).abs() {
                            nearest = i;
                        }
                    }
                    at[nearest] = t;
                }
                next += 1;
            }
            for t in at {
                let values = weights(t);
                let place = places.at(t)[0];
                while leg + 2 < self.vertices.len() && self.vertices[leg + 1].place < place {
                    leg += 1;
                }
                let from = self.vertices[leg];
                let target = from.point + self.direction(leg) * (place - from.place);
                let [inside, pull] = [DVec3::ZERO; 2];
                all.push(Sample { values, target, weight: per_fifth, inside, pull });
            }
        }
        all
    }

    /// By how much the leg from a vertex moves on per place; nothing where it leads to the same.
    fn direction(&self, leg: usize) -> DVec3 {
        let [from, to] = [self.vertices[leg], self.vertices[leg + 1]];
        let length = to.place - from.place;
        if length > 0.0 { (to.point - from.point) / length } else { DVec3::ZERO }
    }

    /// Fits the intervals of a range, given their samples, a few times. Where it does not begin or end
    /// with the spline it goes on from what is there.
    fn fit(&mut self, samples: &mut [Sample], Range { start: from, end: to }: Range<usize>) {
        let ends = [from == 0, to == self.count()];
        let first = if ends[0] { self.fixed[0] } else { 5 };
        let last = if ends[1] { self.fixed[1] } else { 5 };
        let free = first..to - from + 5 - last;
        let (rows, base) = self.system(samples, from, &free);
        let mut points = base.clone();
        self.gather(samples, None, &mut points);
        let mut next = base.clone();
        for round in 0..ROUNDS {
            points[..free.start].copy_from_slice(&base[..free.start]);
            points[free.end..].copy_from_slice(&base[free.end..]);
            banded::solve(&rows, &mut points);
            self.pin(&mut points, &free, ends);
            next.copy_from_slice(&base);
            self.gather(samples, Some(&points), &mut next);
            if round + 1 < ROUNDS {
                std::mem::swap(&mut points, &mut next);
            }
        }
        for (control, point) in self.controls[from..].iter_mut().zip(&points) {
            *control = point.extend(control.w);
        }
    }

    /// Adds what the samples are to be near, by the control points. Where these are known, the targets
    /// of the samples that left the tube move first, and those that did not move back.
    fn gather(&self, samples: &mut [Sample], points: Option<&[DVec3]>, right: &mut [DVec3]) {
        let radius = AIM * self.tolerance;
        for (k, samples) in samples.chunks_exact_mut(SAMPLES).enumerate() {
            let mut wanted = [DVec3::ZERO; SAMPLES];
            for (sample, wanted) in samples.iter_mut().zip(&mut wanted) {
                if let Some(points) = points {
                    let off = weighted(&points[k..k + 6], &sample.values) - sample.target;
                    let off = off * RELAXATION + sample.inside * (1.0 - RELAXATION);
                    let drawn = off + sample.pull;
                    let square = drawn.length_squared();
                    let outside = square > radius * radius;
                    sample.inside = if outside { drawn * (radius / square.sqrt()) } else { drawn };
                    sample.pull = drawn - sample.inside;
                }
                *wanted = (sample.target + sample.inside - sample.pull) * sample.weight;
            }
            for (i, right) in right[k..k + 6].iter_mut().enumerate() {
                let mut sum = *right;
                for (sample, wanted) in samples.iter().zip(&wanted) {
                    sum = *wanted * sample.values[i] + sum;
                }
                *right = sum;
            }
        }
    }

    /// The equations of the fits, decomposed, and what is on the right side of all of them; there the
    /// control points that are not free have their values.
    fn system(
        &self,
        samples: &[Sample],
        from: usize,
        free: &Range<usize>,
    ) -> (Vec<banded::Row>, Vec<DVec3>) {
        let count = samples.len() / SAMPLES + 5;
        let controls = &self.controls[from..from + count];
        let mut rows = vec![[0.0; 6]; count];
        let mut right = vec![DVec3::ZERO; count];
        for (j, four) in controls.windows(4).enumerate() {
            // The root of what the third derivative adds to the integral (divided differences, of
            // which a parabola has none).
            let mut values = [6.0 * ((four[3].w - four[0].w) / 3.0).sqrt(); 4];
            for a in 0..4 {
                for b in 0..4 {
                    if a != b {
                        values[a] /= four[a].w - four[b].w;
                    }
                }
            }
            banded::add(&mut rows[j..], &values, 1.0);
        }
        for (i, sample) in samples.iter().enumerate() {
            banded::add(&mut rows[i / SAMPLES..], &sample.values, sample.weight);
        }
        for (end, k) in [0, count - 6].into_iter().enumerate() {
            if end == 0 && free.start == 0 || end == 1 && free.end == count {
                let step = controls[k + 3].w - controls[k + 2].w;
                let values = weights(end as f64);
                let weight = END_WEIGHT * step.powi(-5);
                banded::add(&mut rows[k..], &values, weight);
                for (right, value) in right[k..].iter_mut().zip(&values) {
                    *right += self.end(end) * (*value * weight);
                }
            }
        }
        for (i, right) in right.iter_mut().enumerate() {
            if !free.contains(&i) {
                *right = controls[i].xyz();
            }
        }
        banded::hold(&mut rows, &mut right, [free.start, free.end]);
        banded::decompose(&mut rows);
        (rows, right)
    }

    /// The first point of the polygon, or the last one.
    fn end(&self, end: usize) -> DVec3 {
        self.vertices[end * (self.vertices.len() - 1)].point
    }

    /// Moves the free ends the last tiny bit to where they are to be; what is farther away moves
    /// less, and the other end not at all.
    fn pin(&self, points: &mut [DVec3], free: &Range<usize>, ends: [bool; 2]) {
        let count = points.len();
        let reach = (count - 5).clamp(5, 9);
        for (end, is_end) in ends.into_iter().enumerate() {
            if self.fixed[end] > 0 || !is_end {
                continue;
            }
            let at = if end == 0 { 0 } else { count - 6 };
            let values = weights(end as f64);
            let missing = self.end(end) - weighted(&points[at..at + 6], &values);
            let index = |i: usize| if end == 0 { i } else { count - 1 - i };
            let part = |i: usize| ((reach - i) as f64 / (reach - 4) as f64).min(1.0);
            let mut moved = 0.0;
            for i in 0..5 {
                if free.contains(&index(i)) {
                    moved += values[index(i) - at] * part(i);
                }
            }
            for i in 0..reach.min(count) {
                if free.contains(&index(i)) && moved > 0.0 {
                    points[index(i)] += missing * (part(i) / moved);
                }
            }
        }
    }

    /// Whether an interval runs on along the polygon, without a place where it all but stands.
    fn runs_on(&self, k: usize) -> bool {
        let powers = powers(&self.controls[k..]);
        let mut runs_on = true;
        for i in 0..=SAMPLES {
            let t = i as f64 / SAMPLES as f64;
            let mut slope = DVec4::ZERO;
            for (i, power) in powers.iter().enumerate().skip(1).rev() {
                slope = slope * t + *power * i as f64;
            }
            let least = SLOWEST * slope.w;
            runs_on &= slope.xyz().length_squared() > least * least;
        }
        runs_on
    }

    /// A bound for how far an interval is from the polygon [mm], and a tight one if it is within
    /// the tolerance.
    ///
    /// Over one leg the difference between the spline and the point of the leg at the same place is
    /// a polynomial of degree five, which the coefficients of Bernstein bound. As both run on
    /// together from the start to the end, no point of one is farther from the other than that.
    pub(super) fn farthest(&self, k: usize) -> f64 {
        let powers = powers(&self.controls[k..]);
        let places = Places::new(&powers);
        let place = places.powers[0];
        let after = self.vertices.partition_point(|vertex| vertex.place <= place);
        let mut leg = after.clamp(1, self.vertices.len() - 1) - 1;
        let (mut from, mut most) = (0.0, 0.0_f64);
        while from < 1.0 {
            let next = self.vertices[leg + 1].place;
            let last = next >= places.end || leg + 2 == self.vertices.len();
            let to = if last { 1.0 } else { places.find(next, from) };
            let direction = self.direction(leg);
            let mut difference = [DVec3::ZERO; 6];
            for (difference, power) in difference.iter_mut().zip(&powers) {
                *difference = power.xyz() - direction * power.w;
            }
            difference[0] -= self.vertices[leg].point - direction * self.vertices[leg].place;
            most = most.max(bound(&difference, [from, to], self.tolerance, 3));
            (from, leg) = (to, leg + 1);
        }
        most
    }
}

/// The next intervals from one on to be fitted: those that left the tube, and what is near them.
fn near(broken: &[bool], from: usize) -> Option<Range<usize>> {
    let first = from + broken[from..].iter().position(|broken| *broken)?;
    let mut last = first;
    while let Some(next) = broken[last + 1..].iter().take(2 * MARGIN).position(|broken| *broken) {
        last += 1 + next;
    }
    Some(first.saturating_sub(MARGIN)..(last + MARGIN + 1).min(broken.len()))
}

/// The sum of six points, weighted.
fn weighted(points: &[DVec3], values: &[f64; 6]) -> DVec3 {
    let mut sum = DVec3::ZERO;
    for (point, value) in points.iter().zip(values) {
        sum = *point * *value + sum;
    }
    sum
}

/// The places along an interval [mm], which grow.
struct Places {
    /// Their coefficients by ascending powers of `t`.
    powers: [f64; 6],
    /// The last one.
    end: f64,
}

impl Places {
    fn new(powers: &[DVec4; 6]) -> Self {
        let mut places = Self { powers: [0.0; 6], end: 0.0 };
        for (place, power) in places.powers.iter_mut().zip(powers) {
            *place = power.w;
        }
        places.end = places.at(1.0)[0];
        places
    }

    /// The place at `t`, and its slope.
    fn at(&self, t: f64) -> [f64; 2] {
        let (mut value, mut slope) = (0.0, 0.0);
        for power in self.powers.iter().rev() {
            slope = slope * t + value;
            value = value * t + power;
        }
        [value, slope]
    }

    /// Where after `from` a place is: Newton's steps, as if knots were even to begin with, kept inside
    /// what is left by halving.
    fn find(&self, place: f64, from: f64) -> f64 {
        let (mut low, mut high) = (from, 1.0);
        let mut t = ((place - self.powers[0]) / (self.end - self.powers[0])).clamp(low, high);
        for _ in 0..30 {
            let [value, slope] = self.at(t);
            if value < place {
                low = t;
            } else {
                high = t;
            }
            let next = t - (value - place) / slope;
            if (next - t).abs() < 1e-14 {
                break;
            }
            t = if low < next && next < high { next } else { 0.5 * (low + high) };
        }
        t
    }
}

/// A bound for the length of a polynomial over a range, halved a few times where the bound is above
/// the limit.
fn bound(powers: &[DVec3; 6], [from, to]: [f64; 2], limit: f64, halvings: u32) -> f64 {
    let mut c = *powers;
    for i in 0..5 {
        for j in (i..5).rev() {
            c[j] = c[j + 1] * from + c[j];
        }
    }
    let mut scale = 1.0;
    for (c, binomial) in c.iter_mut().zip([1.0, 5.0, 10.0, 10.0, 5.0, 1.0]) {
        *c *= scale / binomial;
        scale *= to - from;
    }
    for i in 1..6 {
        for j in (i..6).rev() {
            c[j] = c[j - 1] + c[j];
        }
    }
    let most = c.iter().fold(0.0, |most: f64, c| most.max(c.length_squared())).sqrt();
    if most > limit && halvings > 0 && c[0].length().max(c[5].length()) <= limit {
        let middle = 0.5 * (from + to);
        let left = bound(powers, [from, middle], limit, halvings - 1);
        return left.max(bound(powers, [middle, to], limit, halvings - 1));
    }
    most
}
