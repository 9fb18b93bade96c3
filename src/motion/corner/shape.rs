//! What a corner curve is by its turn alone: length, leg, deviation and the limits of its bend.

use glam::DVec3;

use super::family::{CornerCurve, Series};

/// A corner curve of a given turn at scale 1: its parametric speed at both ends is 1 mm.
///
/// Lengths grow with the scale, curvature falls with it and its derivative with its square.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CornerShape {
    /// Which curve.
    pub(super) curve: CornerCurve,
    /// Cosine of a quarter of the turn.
    pub(super) cos: f64,
    /// Sine of a quarter of the turn.
    pub(super) sin: f64,
    /// Cosine of half the turn.
    pub(super) half_cos: f64,
    /// `e`: 1 − C where the middle of the curve is free, else 0.
    free: f64,
}

/// `w` of one turn: coefficients of `u` by powers of `y`, and of `v/x`.
pub(super) struct Root {
    even: [f64; 4],
    odd: [f64; 4],
}

impl CornerShape {
    /// The curve that turns one unit tangent into the other, in a plane of space; `None` for a
    /// reversal, whose plane and legs no number tells.
    ///
    /// No angle is taken: half the sum and half the difference of the tangents are as long as cosine
    /// and sine of half the turn.
    #[must_use]
    pub fn between(curve: CornerCurve, incoming: DVec3, outgoing: DVec3) -> Option<Self> {
        let (sum, difference) = ((incoming + outgoing).length(), (outgoing - incoming).length());
        let unit = sum.hypot(difference);
        let (half_cos, half_sin) = (sum / unit, difference / unit);
        let cos = (0.5 * (1.0 + half_cos)).sqrt();
        // Below this the legs are longer than any machine, 1e8 times the curve's scale.
        let sin = half_sin / (2.0 * cos);
        let free = if curve == CornerCurve::Ph13 { sin * sin / (1.0 + cos) } else { 0.0 };
        (half_cos > 1e-8).then_some(Self { curve, cos, sin, half_cos, free })
    }

    /// Distance from the corner for a leg of 1; for an eased corner `35/256` of the distance of the
    /// unit tangents.
    #[must_use]
    pub fn deviation_per_leg(&self) -> f64 {
        if self.curve == CornerCurve::Eased {
            35.0 / 64.0 * self.sin * self.cos
        } else {
            self.deviation() / self.leg()
        }
    }

    /// Which curve it is.
    #[must_use]
    pub fn curve(&self) -> CornerCurve {
        self.curve
    }

    /// Cosine of half the turn.
    #[must_use]
    pub fn half_cosine(&self) -> f64 {
        self.half_cos
    }

    /// How much the two unit tangents differ: twice the sine of half the turn.
    #[must_use]
    pub fn difference(&self) -> f64 {
        4.0 * self.sin * self.cos
    }

    /// Arc length [mm]; for degree 13 `(13635 + 3488 C − 2108 C²)/15015`.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.along(1.0).iter().sum()
    }

    /// Distance from the corner to either end [mm]: the chord over `2 cos(θ/2)`; for degree 13 the
    /// chord is `(14922 C² + 3488 C − 3395)/15015`.
    #[must_use]
    pub fn leg(&self) -> f64 {
        let chord: f64 = self.along(-1.0).iter().sum();
        chord / (2.0 * self.half_cos)
    }

    /// Distance from the corner to the curve [mm], at its middle: also the greatest distance
    /// between the curve and the corner's two legs.
    #[must_use]
    pub fn deviation(&self) -> f64 {
        let sag: f64 = self.across().iter().sum();
        self.sin * (2.0 * self.cos * self.leg() - sag)
    }

    /// Largest curvature [1/mm], at the middle: `4 S γ(0)/u(0)³`, for degree 13 `7.5 S`.
    #[must_use]
    pub fn largest_curvature(&self) -> f64 {
        let family = self.curve.family();
        let middle = self.cos * family.even[0] + self.free * family.middle[0];
        4.0 * self.sin * family.odd[0] / (middle * middle * middle)
    }

    /// Largest derivative of the curvature by arc length [1/mm²].
    ///
    /// For degree 13 a polynomial of `S` that is right to 6.6e-5 for any turn, raised by as much;
    /// for its relatives the greatest of 96 places, each at most 0.2 % below the peak beside it.
    #[must_use]
    pub fn largest_sharpness(&self) -> f64 {
        if self.curve == CornerCurve::Ph13 {
            let square = self.sin * self.sin;
            let fit = ((3.1925 * square + 14.2169) * square - 3.4857) * square + 23.0950;
            return 1.000_07 * self.sin * fit;
        }
        self.sampled(|_, sharpness| sharpness.abs())
    }

    /// Largest `√(κ⁴ + κ'²)` [1/mm²]: at a steady speed `v` the jerk is `v³` times this.
    ///
    /// For degree 13 `1.016 max(κ'max, κmax²)`, which is never too small and at most 1.6 % too big.
    #[must_use]
    pub fn jerk_constant(&self) -> f64 {
        if self.curve == CornerCurve::Ph13 {
            let bend = self.largest_curvature();
            return 1.016 * self.largest_sharpness().max(bend * bend);
        }
        self.sampled(|curvature, sharpness| (curvature * curvature).hypot(sharpness))
    }

    /// Arc length (with `sign` 1) or progress along the tangent of the middle (with −1), both from
    /// the middle, over `x/2`: `∫ (u² ± v²) dx`.
    pub(super) fn along(&self, sign: f64) -> Series {
        let [even, both, middle, odd] = &self.curve.family().squares;
        let Self { cos, sin, free, .. } = *self;
        let factors = [cos * cos, 2.0 * cos * free, free * free, sign * sin * sin];
        let mut sum = [0.0; 7];
        for (k, sum) in sum.iter_mut().enumerate() {
            *sum = factors[0] * even[k]
                + factors[1] * both[k]
                + factors[2] * middle[k]
                + factors[3] * odd[k];
        }
        sum
    }

    /// Twice the part of [`along`](Self::along) by `v²`: what progress falls behind the length by.
    pub(super) fn behind(&self) -> Series {
        let mut double = self.curve.family().squares[3];
        for term in &mut double {
            *term *= 2.0 * self.sin * self.sin;
        }
        double
    }

    /// How far the curve has bent away from the tangent of its middle, over `S y`: `∫ u v dx`.
    pub(super) fn across(&self) -> Series {
        let [even, middle] = &self.curve.family().across;
        let mut sum = [0.0; 7];
        for (k, sum) in sum.iter_mut().enumerate() {
            *sum = self.cos * even[k] + self.free * middle[k];
        }
        sum
    }

    /// Its `w`.
    pub(super) fn root(&self) -> Root {
        let family = self.curve.family();
        let (mut even, mut odd) = ([0.0; 4], [0.0; 4]);
        for k in 0..4 {
            even[k] = self.cos * family.even[k] + self.free * family.middle[k];
            odd[k] = self.sin * family.odd[k];
        }
        Root { even, odd }
    }

    /// The greatest value of curvature and its derivative over the curve.
    fn sampled(&self, value: fn(f64, f64) -> f64) -> f64 {
        let root = self.root();
        let mut greatest = 0.0_f64;
        for i in 0..=96 {
            // The curve is symmetric.
            let (_, curvature, sharpness) = root.bend(f64::from(i) / 96.0);
            greatest = greatest.max(value(curvature, sharpness));
        }
        1.002 * greatest
    }
}

impl Root {
    /// Parametric speed at `x` [mm].
    pub(super) fn speed(&self, x: f64) -> f64 {
        let y = x * x;
        let (mut even, mut odd) = (0.0, 0.0);
        for k in (0..4).rev() {
            even = even * y + self.even[k];
            odd = odd * y + self.odd[k];
        }
        even * even + odd * odd * y
    }

    /// Direction as cosine and sine against the tangent of the middle, curvature [1/mm] and its
    /// derivative by arc length [1/mm²] at `x`.
    ///
    /// The angle is `2 arg w` and the arc length grows by `|w|²/2` with `x`: with
    /// `K = u v' − u' v` and `σ = u² + v²` the curvature is `4 K/σ²`, and its derivative
    /// `8 (K' σ − 2 K σ')/σ⁴`.
    pub(super) fn bend(&self, x: f64) -> ([f64; 2], f64, f64) {
        let y = x * x;
        // Horner's scheme for both polynomials and their derivatives by y, the second halved.
        let (mut even, mut odd) = ([0.0; 3], [0.0; 3]);
        for k in (0..4).rev() {
            for (values, coefficient) in [(&mut even, self.even[k]), (&mut odd, self.odd[k])] {
                values[2] = values[2] * y + values[1];
                values[1] = values[1] * y + values[0];
                values[0] = values[0] * y + coefficient;
            }
        }
        // By x: p(y)' = 2 x p', p'' = 2 p' + 4 y p''; x p has p + 2 y p' and x (6 p' + 4 y p'').
        let [u, du, ddu] = [even[0], 2.0 * x * even[1], 2.0 * even[1] + 8.0 * y * even[2]];
        let [v, dv, ddv] =
            [x * odd[0], odd[0] + 2.0 * y * odd[1], x * (6.0 * odd[1] + 8.0 * y * odd[2])];
        let inverse = 1.0 / (u * u + v * v);
        let square = inverse * inverse;
        let (turning, change) = (u * dv - du * v, u * ddv - ddu * v);
        let sharpness = change - 4.0 * inverse * turning * (u * du + v * dv);
        let direction = [(u * u - v * v) * inverse, 2.0 * u * v * inverse];
        (direction, 4.0 * turning * square, 8.0 * sharpness * square * inverse)
    }
}
