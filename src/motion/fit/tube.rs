//! The smoothest spline inside a tube round a polygon.
//!
//! Of all quintic splines on given knots it looks for the one with the least `∫ |r'''|² du`, the
//! place `u` along the polygon standing for arc length, that is nowhere farther from the polygon
//! than the tolerance: the third derivative is what limits the speed once jerk is limited. The
//! method is that of multipliers with alternating directions (ADMM; Boyd and others, 2011, 3.1): a
//! least squares fit to targets, of which each then moves to where it draws the spline back into the
//! tube, if it was outside, and lets go if it was not. The equations stay the same for all fits, so
//! that they are decomposed once.
//!
//! Then every interval is proved to be within the tolerance.

use glam::{DVec3, DVec4, Vec4Swizzles};

use super::banded;
use super::basis::{blend, powers, value, weights};
use super::layout::Vertex;

/// Samples of an interval that a fit looks at; the proof at the end looks at all of it.
const SAMPLES: usize = 8;

/// Fits before a proof is tried.
const ROUNDS: usize = 10;

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
        let (mut rows, mut right) = self.system(&samples);
        for trial in 0..TRIALS {
            if trial > 0 && trial % PATIENCE == 0 {
                for sample in samples.as_flattened_mut() {
                    sample.weight *= GROWTH;
                    sample.pull /= GROWTH;
                }
                (rows, right) = self.system(&samples);
            }
            for _ in 0..ROUNDS {
                self.fit(&samples, &rows, &right);
                self.draw(&mut samples);
            }
            if !self.controls.iter().all(|control| control.is_finite()) {
                return false;
            }
            broken.clear();
            for k in 0..samples.len() {
                broken.push(self.farthest(k) > self.tolerance || !self.runs_on(k));
            }
            if !broken.contains(&true) {
                return true;
            }
        }
        false
    }

    /// Moves the targets of the samples that left the tube, and back those that did not.
    fn draw(&self, samples: &mut [[Sample; SAMPLES]]) {
        let radius = AIM * self.tolerance;
        for (k, samples) in samples.iter_mut().enumerate() {
            for sample in samples {
                let off = blend(&self.controls[k..], &sample.values).xyz() - sample.target;
                let off = off * RELAXATION + sample.inside * (1.0 - RELAXATION);
                let wanted = off + sample.pull;
                let far = wanted.length();
                sample.inside = if far > radius { wanted * (radius / far) } else { wanted };
                sample.pull = wanted - sample.inside;
            }
        }
    }

    /// What a fit looks at: samples at equal distances, those next to a corner of the polygon moved
    /// to it, as the spline is farthest from the polygon there.
    fn samples(&self) -> Vec<[Sample; SAMPLES]> {
        let mut all = Vec::with_capacity(self.count());
        let mut leg = 0;
        for k in 0..self.count() {
            let powers = powers(&self.controls[k..]);
            let end = value(&powers, 1.0).w;
            let step = self.controls[k + 3].w - self.controls[k + 2].w;
            let per_fifth = WEIGHT * step.powi(-5) / SAMPLES as f64;
            let mut at = [0.0; SAMPLES];
            for (i, at) in at.iter_mut().enumerate() {
                *at = (i as f64 + 0.5) / SAMPLES as f64;
            }
            let mut next = leg + 1;
            while next + 1 < self.vertices.len() && self.vertices[next].place <= end {
                let place = self.vertices[next].place;
                if place > powers[0].w {
                    let t = parameter(&powers, place, 0.0);
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
            all.push(at.map(|t| {
                let values = weights(t);
                let place = blend(&self.controls[k..], &values).w;
                while leg + 2 < self.vertices.len() && self.vertices[leg + 1].place < place {
                    leg += 1;
                }
                let from = self.vertices[leg];
                let target = from.point + self.direction(leg) * (place - from.place);
                Sample { values, target, weight: per_fifth, inside: DVec3::ZERO, pull: DVec3::ZERO }
            }));
        }
        all
    }

    /// By how much the leg from a vertex moves on per place; nothing where it leads to the same.
    fn direction(&self, leg: usize) -> DVec3 {
        let [from, to] = [self.vertices[leg], self.vertices[leg + 1]];
        let length = to.place - from.place;
        if length > 0.0 { (to.point - from.point) / length } else { DVec3::ZERO }
    }

    /// The equations of the fits, decomposed, and what is on the right side of all of them.
    fn system(&self, samples: &[[Sample; SAMPLES]]) -> (Vec<banded::Row>, Vec<DVec3>) {
        let count = self.controls.len();
        let mut rows = vec![[0.0; 6]; count];
        let mut right = vec![DVec3::ZERO; count];
        for (j, four) in self.controls.windows(4).enumerate() {
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
        for (k, samples) in samples.iter().enumerate() {
            for sample in samples {
                banded::add(&mut rows[k..], &sample.values, sample.weight);
            }
        }
        let last = self.count() - 1;
        let ends = [self.vertices[0].point, self.vertices[self.vertices.len() - 1].point];
        for (end, k) in [0, last].into_iter().enumerate() {
            if self.fixed[end] == 0 {
                let step = self.controls[k + 3].w - self.controls[k + 2].w;
                let values = weights(end as f64);
                let weight = END_WEIGHT * step.powi(-5);
                banded::add(&mut rows[k..], &values, weight);
                for (right, value) in right[k..].iter_mut().zip(&values) {
                    *right += ends[end] * (*value * weight);
                }
            }
        }
        let [first, last] = [self.fixed[0], count - self.fixed[1]];
        for (i, right) in right.iter_mut().enumerate() {
            if i < first || i >= last {
                *right = self.controls[i].xyz();
            }
        }
        banded::hold(&mut rows, &mut right, [first, last]);
        banded::decompose(&mut rows);
        (rows, right)
    }

    /// The least squares fit to the targets.
    fn fit(&mut self, samples: &[[Sample; SAMPLES]], rows: &[banded::Row], base: &[DVec3]) {
        let mut right = base.to_vec();
        let free = self.fixed[0]..base.len() - self.fixed[1];
        for (k, samples) in samples.iter().enumerate() {
            let mut sums = [DVec3::ZERO; 6];
            for sample in samples {
                let wanted = (sample.target + sample.inside - sample.pull) * sample.weight;
                for (sum, value) in sums.iter_mut().zip(&sample.values) {
                    *sum += wanted * *value;
                }
            }
            for (i, sum) in sums.iter().enumerate() {
                if free.contains(&(k + i)) {
                    right[k + i] += *sum;
                }
            }
        }
        banded::solve(rows, &mut right);
        for (control, point) in self.controls.iter_mut().zip(&right) {
            *control = point.extend(control.w);
        }
        let ends = [self.vertices[0].point, self.vertices[self.vertices.len() - 1].point];
        self.pin(ends);
    }

    /// Moves the free ends the last tiny bit to where they are to be; what is farther away moves
    /// less, and the other end not at all.
    fn pin(&mut self, ends: [DVec3; 2]) {
        let count = self.controls.len();
        let free = self.fixed[0]..count - self.fixed[1];
        let reach = (count - 5).clamp(5, 9);
        for (end, point) in ends.into_iter().enumerate() {
            if self.fixed[end] > 0 {
                continue;
            }
            let at = if end == 0 { 0 } else { count - 6 };
            let values = weights(end as f64);
            let missing = point - blend(&self.controls[at..], &values).xyz();
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
                    self.controls[index(i)] += (missing * (part(i) / moved)).extend(0.0);
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
            runs_on &= slope.xyz().length() > SLOWEST * slope.w;
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
        let end = value(&powers, 1.0).w;
        let place = powers[0].w;
        let after = self.vertices.partition_point(|vertex| vertex.place <= place);
        let mut leg = after.clamp(1, self.vertices.len() - 1) - 1;
        let (mut from, mut most) = (0.0, 0.0_f64);
        while from < 1.0 {
            let next = self.vertices[leg + 1].place;
            let last = next >= end || leg + 2 == self.vertices.len();
            let to = if last { 1.0 } else { parameter(&powers, next, from) };
            let direction = self.direction(leg);
            let mut difference = powers.map(|power| power.xyz() - direction * power.w);
            difference[0] -= self.vertices[leg].point - direction * self.vertices[leg].place;
            most = most.max(bound(&difference, [from, to], self.tolerance, 3));
            (from, leg) = (to, leg + 1);
        }
        most
    }
}

/// Where after `from` the fourth coordinate, which grows, reaches a value: Newton's steps kept
/// inside what is left by halving.
fn parameter(powers: &[DVec4; 6], place: f64, from: f64) -> f64 {
    let (mut low, mut high) = (from, 1.0);
    let mut t = 0.5 * (low + high);
    for _ in 0..30 {
        let (mut value, mut slope) = (0.0, 0.0);
        for power in powers.iter().rev() {
            slope = slope * t + value;
            value = value * t + power.w;
        }
        if value < place {
            low = t;
        } else {
            high = t;
        }
        let next = t - (value - place) / slope;
        let next = if low < next && next < high { next } else { 0.5 * (low + high) };
        if (next - t).abs() < 1e-14 {
            break;
        }
        t = next;
    }
    t
}

/// A bound for the length of a polynomial over a range, halved a few times where the bound is above
/// the limit.
fn bound(powers: &[DVec3; 6], [from, to]: [f64; 2], limit: f64, halvings: u32) -> f64 {
    let mut c = *powers;
    for i in 0..5 {
        for j in (i..5).rev() {
            let next = c[j + 1];
            c[j] += next * from;
        }
    }
    let mut scale = 1.0;
    for (c, binomial) in c.iter_mut().zip([1.0, 5.0, 10.0, 10.0, 5.0, 1.0]) {
        *c *= scale / binomial;
        scale *= to - from;
    }
    for i in 1..6 {
        for j in (i..6).rev() {
            let before = c[j - 1];
            c[j] += before;
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
