//! Proved bounds of the distance of a cubic from the offset of another.
//!
//! For the curve `C` with unit tangent `T`, left normal `N` and curvature `κ`, its offset
//! `O = C + δN` and a cubic `H` with the same ends as `O`, let `D = H − C` on the same parameter,
//! `s = D·T`, `h = σ D·N`, `r = |δ|` and `σ = sign δ`. Bernstein coefficients bound
//! `g = |D|² − r²`, `D·C'` and `|C'|²`, and with them `s²` and `h² = r² + g − s²`; where that stays
//! positive, `H` stays on its side, and `h − r = (g − s²) / (h + r)`.
//!
//! **At the same parameter**: `|H − O|² = (h − r)² + s²`. Nothing else is needed: this holds beside
//! cusps and between them.
//!
//! **At the foot**, which may stand elsewhere. Let `C` be extended by rays along its end tangents,
//! and
//!
//! 1. all control vectors of `C'` have positive dot products with each other, so that no two
//!    tangents are 90° apart;
//! 2. `σκR < 1` for `R = max |D|`. By 1, the curve then leaves the disk of radius `R` that touches
//!    it from the side of `σN`: every point at a distance of at most `R` on that side has one foot;
//! 3. `H` lies between the normals at both ends of `C`, so its feet lie on `C` itself;
//! 4. `h > R / 2`, so that between `C + σhN` and `H`, a step of `s` along `T`, the curve is not
//!    crossed.
//!
//! The distance `ψ` from the curve has the gradient `σN` and, along `T`, the second derivative
//! `−k cos²`, where `k = σκ/(1 − σκψ)` is the offset's curvature and `cos` that of the angle
//! between `T` and the tangent at the foot. So `ψ(H) = h − s² k̃ / 2`, with `k̃` between bounds of
//! `k cos²`, and
//!
//! `ψ(H) − r = (g − μ s²) / (h + r)` with `μ = 1 + k̃ (h + r) / 2`,
//!
//! which polynomials of degree 10 bound. The curve may be taken at any parameter that runs with that of
//! the piece, not only at the same. As the foot moves from one end of `C` to the other, the
//! largest `|ψ(H) − r|` is the Hausdorff distance of `H` and `O`, and the distance of any point of
//! `H` from `C` differs from `r` by no more.

use std::array::from_fn;

use glam::DVec2;

use crate::geometry::{Cubic, cross, halve, turn};

/// Binomial coefficients: products below are kept scaled by them, so that multiplying Bernstein
/// forms is plain convolution.
const BINOMIAL_2: [f64; 3] = [1.0, 2.0, 1.0];
const BINOMIAL_3: [f64; 4] = [1.0, 3.0, 3.0, 1.0];
const BINOMIAL_4: [f64; 5] = [1.0, 4.0, 6.0, 4.0, 1.0];
const BINOMIAL_5: [f64; 6] = [1.0, 5.0, 10.0, 10.0, 5.0, 1.0];
const BINOMIAL_6: [f64; 7] = [1.0, 6.0, 15.0, 20.0, 15.0, 6.0, 1.0];
const BINOMIAL_10: [f64; 11] =
    [1.0, 10.0, 45.0, 120.0, 210.0, 252.0, 210.0, 120.0, 45.0, 10.0, 1.0];

/// Largest `t² (1 − t)²` in `[0, 1]`.
const LARGEST_WEIGHT: f64 = 1.0 / 16.0;

/// Rounding of a sum of a few numbers, as a share of the largest.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The hodograph of a curve, and bounds of its speed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Speed {
    pub(super) hodograph: [DVec2; 3],
    /// Products of the control vectors 00, 01, 02, 11, 12, 22 [mm²].
    products: [f64; 6],
    /// Least and largest `|C'|²` [mm²].
    pub(super) squared: [f64; 2],
    /// What rounding may make of a control vector [mm].
    rounding: f64,
}

impl Speed {
    pub(super) fn new(hodograph: [DVec2; 3]) -> Self {
        let mut speed = Self::rounded(hodograph, 0.0);
        speed.rounding = ROUNDING * speed.squared[1].sqrt();
        speed
    }

    /// That of a part: halved as it is, since the control points of a short part have too few digits
    /// left to tell its curvature.
    pub(super) fn part(&self, from: f64, to: f64) -> Self {
        let [v0, v1, v2] = self.hodograph;
        let blossom = |a: f64, b: f64| v0.lerp(v1, a).lerp(v1.lerp(v2, a), b) * (to - from);
        let hodograph = [blossom(from, from), blossom(from, to), blossom(to, to)];
        Self::rounded(hodograph, self.rounding * (to - from))
    }

    /// `C'` and half of `C''` at `t` [mm].
    pub(super) fn derivatives(&self, t: f64) -> [DVec2; 2] {
        let [v0, v1, v2] = self.hodograph;
        let (a, b) = (v0.lerp(v1, t), v1.lerp(v2, t));
        [a.lerp(b, t), b - a]
    }

    fn rounded(hodograph: [DVec2; 3], rounding: f64) -> Self {
        let [v0, v1, v2] = hodograph;
        let products = [v0.dot(v0), v0.dot(v1), v0.dot(v2), v1.dot(v1), v1.dot(v2), v2.dot(v2)];
        let [p00, p01, p02, p11, p12, p22] = products;
        let squared = range(&[p00, p01, (p02 + 2.0 * p11) / 3.0, p12, p22]);
        Self { hodograph, products, squared, rounding }
    }

    /// Whether `1 − δκ` is proved to be positive all along.
    pub(super) fn surely_fits(&self, offset: f64) -> bool {
        let slow = self.squared[0];
        let [_, most] = self.bend(offset);
        slow > 0.0 && (most <= 0.0 || most * most < slow * slow * slow)
    }

    /// Least product of two control vectors [mm²].
    fn least_product(&self) -> f64 {
        range(&self.products)[0]
    }

    /// Least and largest `factor C' × C''`.
    fn bend(&self, factor: f64) -> [f64; 2] {
        let [v0, v1, v2] = self.hodograph;
        let (b0, b2) = (2.0 * cross(v0, v1), 2.0 * cross(v1, v2));
        range(&[factor * b0, factor * cross(v0, v2), factor * b2])
    }

    /// Least and largest `factor κ`; of a curve that nowhere stands still.
    fn curvature(&self, factor: f64) -> [f64; 2] {
        let [least, most] = self.bend(factor);
        let [slow, fast] = self.squared;
        let (slow, fast) = (slow * slow.sqrt(), fast * fast.sqrt());
        [least / if least > 0.0 { fast } else { slow }, most / if most > 0.0 { slow } else { fast }]
    }
}

/// A curve and a piece that follows its offset, compared at the same parameter.
#[derive(Debug)]
pub(super) struct Comparison<'a> {
    curve: &'a Cubic,
    speed: &'a Speed,
    piece: &'a Cubic,
    /// δ [mm].
    offset: f64,
    /// `|D|² − r²` [mm²], scaled.
    excess: [f64; 7],
    /// `D·C'` [mm²], scaled.
    slip: [f64; 6],
}

impl<'a> Comparison<'a> {
    pub(super) fn new(curve: &'a Cubic, speed: &'a Speed, piece: &'a Cubic, offset: f64) -> Self {
        let d: [DVec2; 4] = from_fn(|i| (piece.points[i] - curve.points[i]) * BINOMIAL_3[i]);
        let v: [DVec2; 3] = from_fn(|i| speed.hodograph[i] * BINOMIAL_2[i]);
        let mut excess: [f64; 7] = product(&d, &d, DVec2::dot);
        for (e, b) in excess.iter_mut().zip(BINOMIAL_6) {
            *e -= offset * offset * b;
        }
        let slip = product(&d, &v, DVec2::dot);
        Self { curve, speed, piece, offset, excess, slip }
    }

    /// A bound of the distance at the same parameter [mm]; infinite where none is proved.
    ///
    /// It is sharp for a piece that has the end derivatives of the offset too: then the bounded
    /// polynomials are `t² (1 − t)²` times others, whose coefficients are looked at.
    pub(super) fn at_same_parameter(&self) -> f64 {
        let [e0, e1, e2, e3, e4, e5, e6] = self.excess;
        let inner = largest(&[e2, 0.5 * e3, e4]);
        let excess = largest(&[e0, e1 / 6.0, e5 / 6.0, e6]) + LARGEST_WEIGHT * inner;
        let [s0, s1, s2, s3, s4, s5] = self.slip;
        let slip = largest(&[s0, 0.2 * s1, 0.2 * s4, s5]) + LARGEST_WEIGHT * largest(&[s2, s3]);
        self.same_parameter([-excess, excess], slip)
    }

    /// The same from bounds of `|D|² − r²` and `|D·C'|`.
    fn same_parameter(&self, excess: [f64; 2], slip: f64) -> f64 {
        let Some((height, slip_squared)) = self.least_height(excess[0], slip) else {
            return f64::INFINITY;
        };
        let across = excess[1].max(slip_squared - excess[0]) / (self.offset.abs() + height);
        (across * across + slip_squared).sqrt()
    }

    /// Least `h` [mm] and largest `s²` [mm²], if the piece is proved to stay on its side.
    fn least_height(&self, least_excess: f64, slip: f64) -> Option<(f64, f64)> {
        let slip_squared = slip * slip / self.speed.squared[0];
        let height_squared = self.offset * self.offset + least_excess - slip_squared;
        // Not a number where the curve stands still, and false then.
        let ahead = self.speed.squared[0] > 0.0 && height_squared > 0.0;
        ahead.then(|| (height_squared.sqrt(), slip_squared))
    }

    /// A bound of the distance at the feet [mm]; infinite where none is proved.
    ///
    /// Several parts make it sharper: each is held against the part of the curve between the feet of
    /// its ends, where next to no slip is left.
    pub(super) fn at_feet(&self, parts: u32) -> f64 {
        let [q0, q1, q2, q3] = self.piece.points;
        let [v0, _, v2] = self.speed.hodograph;
        // 1 and 3
        let forth = [q1, q2, q3].iter().all(|&q| (q - q0).dot(v0) >= 0.0);
        let back = [q0, q1, q2].iter().all(|&q| (q3 - q).dot(v2) >= 0.0);
        if !(forth && back && self.speed.least_product() > 0.0) {
            return f64::INFINITY;
        }
        let curvature = self.speed.curvature(self.offset.signum());
        if parts == 1 {
            return self.part_at_feet(self.speed, curvature).unwrap_or(f64::INFINITY);
        }
        let (mut before, mut bound) = (0.0, 0.0_f64);
        for k in 1..=parts {
            let part = |k: u32| f64::from(k) / f64::from(parts);
            let (from, to) = (part(k - 1), part(k));
            // Not `clamp`: what it says of wrong bounds brings all printing of numbers into the wasm.
            let next = if k == parts { 1.0 } else { self.foot(to).max(before).min(1.0) };
            let (curve, piece) = (self.curve.part(before, next), self.piece.part(from, to));
            let speed = self.speed.part(before, next);
            let part = Comparison::new(&curve, &speed, &piece, self.offset);
            let away = part.farthest_foot(curvature[1]) * (next - before);
            let around = self.speed.part((before - away).max(0.0), (next + away).min(1.0));
            let curvature = around.curvature(self.offset.signum());
            bound = bound.max(part.part_at_feet(&around, curvature).unwrap_or(f64::INFINITY));
            before = next;
        }
        bound
    }

    /// About the parameter of the foot of the piece at `t`: two steps of Newton's method.
    fn foot(&self, t: f64) -> f64 {
        let point = self.piece.point(t);
        let mut foot = t;
        for _ in 0..2 {
            let (first, away) = (self.curve.derivative(foot), point - self.curve.point(foot));
            let slope = first.length_squared() - away.dot(self.curve.second_derivative(foot));
            foot += away.dot(first) / slope;
        }
        foot
    }

    /// How far the parameter of a foot may be from that of its point, where `σκ` is at most
    /// `curvature` [1/mm]: along the curve, by no more than the slip over `1 − σκR`.
    fn farthest_foot(&self, curvature: f64) -> f64 {
        let slip = largest(&unscaled(&self.slip, &BINOMIAL_5));
        let reach = self.offset * self.offset + range(&unscaled(&self.excess, &BINOMIAL_6))[1];
        let away = slip / (self.speed.squared[0] * (1.0 - curvature.max(0.0) * reach.sqrt()));
        // Not a number where there is no bound.
        if away >= 0.0 { away } else { f64::INFINITY }
    }

    /// A bound where all feet are on the part of the curve that `around` and `curvature`, the least
    /// and largest `σκ`, belong to; none if it does not fulfil 2 and 4.
    fn part_at_feet(&self, around: &Speed, curvature: [f64; 2]) -> Option<f64> {
        let r = self.offset.abs();
        let [slow, fast] = self.speed.squared;
        let [least, most] = range(&unscaled(&self.excess, &BINOMIAL_6));
        let slip = largest(&unscaled(&self.slip, &BINOMIAL_5));
        let (height, slip_squared) = self.least_height(least, slip)?;
        let reach = (r * r + most).sqrt();
        if !(curvature[1] * reach < 1.0 && 2.0 * height > reach) {
            return None;
        }
        // Bounds of ψ and h + r, of k̃, of μ and of μ / |C'|².
        let feet = [(height - slip_squared.sqrt()).max(0.0), reach];
        let sums = [height + r, reach + r];
        let cosine = (around.least_product() / around.squared[1]).powi(2).min(1.0);
        let bound = |i: usize| curvature[i] / (1.0 - curvature[i] * feet[i]);
        let bounds = [bound(0), bound(1)];
        let low = bounds[0] * if bounds[0] > 0.0 { cosine } else { 1.0 };
        let high = bounds[1] * if bounds[1] > 0.0 { 1.0 } else { cosine };
        let low = 1.0 + 0.5 * low * sums[usize::from(low < 0.0)];
        let high = 1.0 + 0.5 * high * sums[usize::from(high > 0.0)];
        let low = low / if low > 0.0 { fast } else { slow };
        let high = high / if high > 0.0 { slow } else { fast };
        let excess: [f64; 11] = product(&self.excess, &BINOMIAL_4, |a, b| a * b);
        let slip: [f64; 11] = product(&self.slip, &self.slip, |a, b| a * b);
        let mut most = 0.0_f64;
        for k in 0..11 {
            let inwards = high * slip[k] - excess[k];
            let outwards = excess[k] - low * slip[k];
            most = most.max(inwards.max(outwards) / BINOMIAL_10[k]);
        }
        Some(most / sums[0])
    }

    /// What rounding may make of a distance [mm].
    pub(super) fn rounding(&self) -> f64 {
        let start = self.curve.start().abs().max_element();
        let end = self.curve.end().abs().max_element();
        let r = self.offset.abs();
        // Rounded control vectors turn the normal.
        let turned = self.speed.rounding / self.speed.squared[0].sqrt();
        // Not a number where the curve stands still, and nothing is proved.
        ROUNDING * (start.max(end) + r) + turned.max(0.0) * r
    }

    /// The sharpest bound of either kind [mm].
    pub(super) fn sharp(&self) -> f64 {
        let [least, most] = extremes(&mut unscaled(&self.excess, &BINOMIAL_6), SHARP);
        let slip = extremes(&mut unscaled(&self.slip, &BINOMIAL_5), SHARP);
        let same = self.same_parameter([least, most], largest(&slip));
        same.min(self.at_feet(1 << SHARP))
    }
}

/// Halvings for the sharpest bound: each leaves a quarter of what it is too much.
const SHARP: u32 = 3;

/// A bound of the distance [mm] of two curves with common ends: no point of the offset of `curve`
/// is farther from an end than half its length, nor is one of `piece`.
///
/// The tangent turns by no more than the control vectors of `C'` do one after the other, as no
/// line through the origin crosses a Bézier curve more often than its polygon.
pub(super) fn by_length(curve: &Cubic, hodograph: &[DVec2; 3], piece: &Cubic, offset: f64) -> f64 {
    let mut turned = 0.0;
    let mut last: Option<DVec2> = None;
    for &v in hodograph.iter().filter(|v| **v != DVec2::ZERO) {
        turned += last.map_or(0.0, |last| turn(last, v).abs());
        last = Some(v);
    }
    0.5 * piece.hull_length().max(curve.hull_length() + offset.abs() * turned)
}

/// Product of two polynomials whose Bernstein coefficients are scaled by their binomials.
fn product<A: Copy, B: Copy, const N: usize, const M: usize, const K: usize>(
    a: &[A; N],
    b: &[B; M],
    multiply: impl Fn(A, B) -> f64,
) -> [f64; K] {
    const { assert!(K + 1 == N + M, "the degree of a product is the sum of the degrees") };
    let mut scaled = [0.0; K];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            scaled[i + j] += multiply(*x, *y);
        }
    }
    scaled
}

/// Bernstein coefficients from scaled ones.
fn unscaled<const N: usize>(scaled: &[f64; N], binomial: &[f64; N]) -> [f64; N] {
    from_fn(|i| scaled[i] / binomial[i])
}

/// Largest absolute value.
fn largest(values: &[f64]) -> f64 {
    let [least, most] = range(values);
    let most = if -least > most { -least } else { most };
    if most > 0.0 { most } else { 0.0 }
}

/// Least and largest value, whatever is not a number left out.
pub(super) fn range(values: &[f64]) -> [f64; 2] {
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for &value in values {
        // Not `min` and `max`, which are calls of functions in WebAssembly.
        if value < least {
            least = value;
        }
        if value > most {
            most = value;
        }
    }
    [least, most]
}

/// Bounds of a polynomial of degree 10 at most from its Bernstein coefficients, after as many
/// halvings.
fn extremes(coefficients: &mut [f64], halvings: u32) -> [f64; 2] {
    if halvings == 0 {
        return range(coefficients);
    }
    let mut left = [0.0; 11];
    let left = &mut left[..coefficients.len()];
    halve(coefficients, left);
    let [before, behind] = [extremes(left, halvings - 1), extremes(coefficients, halvings - 1)];
    [before[0].min(behind[0]), before[1].max(behind[1])]
}

#[cfg(test)]
mod tests {
    use super::super::fit::{Source, hermite};
    use super::*;
    use crate::geometry::perp;

    /// A seeded number in `[0, 1)`.
    fn random(seed: &mut u64) -> f64 {
        *seed =
            seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Largest distance of points of the piece from the offset at the same parameter, and largest
    /// difference of their distances from the curve to the radius.
    fn measured(source: &Source, piece: &Cubic) -> [f64; 2] {
        let (curve, r) = (&source.cubic, source.offset.abs());
        (0..=2000).map(|k| f64::from(k) / 2000.0).fold([0.0_f64; 2], |[same, foot], t| {
            let point = piece.point(t);
            let beside = curve.point(t) + perp(curve.tangent(t)) * source.offset;
            [same.max(point.distance(beside)), foot.max((curve.nearest(point).distance - r).abs())]
        })
    }

    #[test]
    fn no_bound_is_below_what_is_measured_and_most_are_near() {
        let mut seed = 20_260_101;
        let mut ratios = [Vec::new(), Vec::new()];
        for case in 0..3000 {
            let size = 10_f64.powf(3.0 * random(&mut seed) - 2.0);
            let offset = (random(&mut seed) - 0.5) * 10_f64.powf(3.0 * random(&mut seed) - 1.0);
            let points = from_fn(|i| {
                let wild = DVec2::new(random(&mut seed), random(&mut seed)) - 0.5;
                (DVec2::new(i as f64, 0.0) + wild) * size
            });
            let source = Source::new(Cubic { points }, offset);
            let hermite = hermite([source.end(0.0), source.end(1.0)]);
            let collocated = source.collocated(&hermite);
            for (kind, piece) in [Some(hermite), collocated].into_iter().enumerate() {
                let Some(piece) = piece else { continue };
                let compared = Comparison::new(&source.cubic, &source.speed, &piece, offset);
                let [same, foot] = measured(&source, &piece).map(|m| m - compared.rounding());
                let what = format!("case {case}: {source:?} and {piece:?}");
                let bound = compared.at_same_parameter();
                assert!(bound >= same, "{bound} at the same parameter, {same} measured, {what}");
                let feet = compared.at_feet(1);
                assert!(feet >= foot, "{feet} at the feet, {foot} measured, {what}");
                let sharp = compared.at_feet(1 << SHARP);
                assert!(sharp <= feet, "halving makes it sharper: {sharp} and {feet}, {what}");
                assert!(sharp >= foot, "{sharp} at the feet, {foot} measured, {what}");
                let either = compared.sharp();
                assert!(either >= foot.min(same), "{either}, {foot} measured, {what}");
                if sharp.is_finite() {
                    ratios[kind].push(sharp / foot);
                }
            }
        }
        // The curves turn by up to 90°, far more than pieces within a tolerance do.
        for (ratios, most) in ratios.iter_mut().zip([1.1, 2.2]) {
            ratios.sort_by(f64::total_cmp);
            let median = ratios[ratios.len() / 2];
            assert!(ratios.len() > 900 && median < most, "{median} of {}", ratios.len());
        }
    }
}
