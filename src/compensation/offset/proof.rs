//! A proof that a cubic is within a tolerance of the offset of another.
//!
//! For the curve `C` with unit tangent `T` and left normal `N`, its offset `O = C + δN` and a cubic
//! `H` with the same ends as `O`, let `D = H − C` on the same parameter, `h = D·N`, `r = |δ|` and
//! `σ = sign δ`. If
//!
//! * (a) every control vector of the hodographs of `H` and `C` has a positive dot product with
//!   every one of `C`: both curves advance all the way;
//! * (b) `σ C' × D > 0`: `H` stays on its side;
//! * (c) `0 < m₋ ≤ 1 − κh ≤ m₊`: the foot of `H(t)` on `C` moves with `t`;
//! * (d) `m₋ (|D|² − (r − tol)²) |C'|² − (D·C')²` and `m₊ ((r + tol)² − |D|²) |C'|² + (D·C')²`
//!   are nowhere negative: what `H` slips along the curve is allowed for,
//!
//! then every point of `H` is at a distance between `r − tol` and `r + tol` from `C`, and the
//! Hausdorff distance of `H` and `O` is at most `tol`. All four are checked on Bernstein
//! coefficients, which bound a polynomial by their least and largest.

use std::array::from_fn;

use glam::DVec2;

use crate::geometry::{Cubic, cross};

/// Binomial coefficients: products below are kept scaled by them, so that multiplying Bernstein
/// forms is plain convolution.
const BINOMIAL_2: [f64; 3] = [1.0, 2.0, 1.0];
const BINOMIAL_3: [f64; 4] = [1.0, 3.0, 3.0, 1.0];
const BINOMIAL_4: [f64; 5] = [1.0, 4.0, 6.0, 4.0, 1.0];
const BINOMIAL_5: [f64; 6] = [1.0, 5.0, 10.0, 10.0, 5.0, 1.0];
const BINOMIAL_6: [f64; 7] = [1.0, 6.0, 15.0, 20.0, 15.0, 6.0, 1.0];

/// Whether `piece`, which shares its ends with the offset of `curve` by `offset` [mm], is proved
/// to be within `tolerance` [mm] of it.
pub(super) fn is_proved(curve: &Cubic, piece: &Cubic, offset: f64, tolerance: f64) -> bool {
    let (r, sign) = (offset.abs(), offset.signum());
    let (v, w) = (curve.hodograph(), piece.hodograph());
    // (a)
    let advances = |a: &DVec2| v.iter().all(|b| a.dot(*b) > 0.0);
    if !(v.iter().all(advances) && w.iter().all(advances)) {
        return false;
    }
    let d: [DVec2; 4] = from_fn(|i| piece.points[i] - curve.points[i]);
    let d3: [DVec2; 4] = from_fn(|i| d[i] * BINOMIAL_3[i]);
    let v2: [DVec2; 3] = from_fn(|i| v[i] * BINOMIAL_2[i]);
    // (b)
    let across: [f64; 6] = product(&v2, &d3, cross);
    if across.iter().any(|c| sign * c <= 0.0) {
        return false;
    }
    // (c)
    let along: [f64; 6] = product(&d3, &v2, DVec2::dot);
    let distance: [f64; 7] = product(&d3, &d3, DVec2::dot);
    let speed: [f64; 5] = product(&v2, &v2, DVec2::dot);
    let (slowest, fastest) = range(&speed, &BINOMIAL_4);
    let (_, farthest) = range(&distance, &BINOMIAL_6);
    let (back, forth) = range(&along, &BINOMIAL_5);
    if slowest <= 0.0 {
        return false;
    }
    let slip = back.abs().max(forth.abs()).powi(2) / slowest;
    let inner = (r - tolerance).max(0.0).powi(2);
    let outer = (r + tolerance).powi(2);
    let heights = [(inner - slip).max(0.0).sqrt(), farthest.sqrt()];
    let Some([m_low, m_high]) = room(&v, sign, slowest.sqrt(), fastest.sqrt(), heights) else {
        return false;
    };
    // (d)
    let distance_speed: [f64; 11] = product(&distance, &speed, |a, b| a * b);
    let speed_10: [f64; 11] = product(&BINOMIAL_6, &speed, |a, b| a * b);
    let slip_squared: [f64; 11] = product(&along, &along, |a, b| a * b);
    (0..11).all(|k| {
        let (reach, unit, slip) = (distance_speed[k], speed_10[k], slip_squared[k]);
        m_low * (reach - inner * unit) >= slip && m_high * (outer * unit - reach) + slip >= 0.0
    })
}

/// Bounds of `1 − κh`, if they are positive: from those of `σ C' × C''` (its three Bernstein
/// coefficients), of the speed, and of `σh`.
fn room(
    v: &[DVec2; 3],
    sign: f64,
    slowest: f64,
    fastest: f64,
    heights: [f64; 2],
) -> Option<[f64; 2]> {
    let bends = [2.0 * cross(v[0], v[1]), cross(v[0], v[2]), 2.0 * cross(v[1], v[2])];
    let least = bends.iter().map(|b| sign * b).fold(f64::INFINITY, f64::min);
    let most = bends.iter().map(|b| sign * b).fold(f64::NEG_INFINITY, f64::max);
    let over = |bend: f64, small: f64, large: f64| {
        bend / if bend > 0.0 { large * large * large } else { small * small * small }
    };
    let curvature_low = over(least, slowest, fastest);
    let curvature_high = over(most, fastest, slowest);
    let times = |curvature: f64, when_positive: f64, when_negative: f64| {
        curvature * if curvature > 0.0 { when_positive } else { when_negative }
    };
    let m_low = 1.0 - times(curvature_high, heights[1], heights[0]);
    let m_high = 1.0 - times(curvature_low, heights[0], heights[1]);
    (m_low > 0.0).then_some([m_low, m_high])
}

/// Product of two polynomials whose Bernstein coefficients are scaled by their binomials.
fn product<A: Copy, const N: usize, const M: usize, const K: usize>(
    a: &[A; N],
    b: &[A; M],
    multiply: impl Fn(A, A) -> f64,
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

/// Least and largest Bernstein coefficient.
fn range<const N: usize>(scaled: &[f64; N], binomial: &[f64; N]) -> (f64, f64) {
    scaled
        .iter()
        .zip(binomial)
        .map(|(value, weight)| value / weight)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), c| (least.min(c), most.max(c)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cubic near a quarter of the unit circle, scaled.
    fn quarter(radius: f64) -> Cubic {
        let k = 0.552_284_749_830_793_4;
        let p = |x: f64, y: f64| DVec2::new(x, y) * radius;
        Cubic::new(p(1.0, 0.0), p(1.0, k), p(k, 1.0), p(0.0, 1.0))
    }

    /// The error of that cubic is 2.73e-4 of its radius, at most outwards.
    const QUARTER_ERROR: f64 = 2.73e-4;

    #[test]
    fn a_concentric_quarter_is_proved_at_its_error_and_not_below() {
        // Half the circle's angle, where the control vectors still agree in direction.
        let (inner, outer) = (quarter(10.0).split(0.5).0, quarter(7.0).split(0.5).0);
        // Scaling the cubic by 0.7 moves it by 3 mm along its radii, to within 3e-4 of 3 mm.
        assert!(is_proved(&inner, &outer, 3.0, 3.0 * QUARTER_ERROR + 2e-3), "proved");
        assert!(!is_proved(&inner, &outer, 3.0, 1e-5), "not nearer than it is");
        assert!(!is_proved(&inner, &outer, -3.0, 0.1), "not on the other side");
        assert!(!is_proved(&inner, &outer, 3.1, 0.05), "not at another distance");
    }

    #[test]
    fn a_piece_that_slips_back_along_the_curve_is_not_proved() {
        let curve = quarter(10.0).split(0.5).0;
        let fair = quarter(7.0).split(0.5).0;
        let [p0, p1, p2, p3] = fair.points;
        let looped = Cubic::new(p0, p0 + (p3 - p0) * 1.5, p0 - (p3 - p0) * 0.5, p3);
        assert!(is_proved(&curve, &fair, 3.0, 0.01), "the fair piece");
        assert!(!is_proved(&curve, &looped, 3.0, 0.5), "the looped piece {p1} {p2}");
    }
}
