//! Sine and cosine of the angles that arcs turn by.
//!
//! The standard library's are right for angles of any size, with a table of π that takes four
//! kilobytes of WebAssembly, and differ between platforms in their last bit. An arc turns by a full
//! circle at most, and these are the same everywhere.

use std::f64::consts::FRAC_2_PI;

/// π/2 as a sum: the first part ends in twenty zero bits, so that its small multiples are exact.
const HALF_PI: [f64; 2] = [1.570_796_326_734_125_6, 6.077_100_506_506_192e-11];

/// Taylor coefficients of the sine after x, by powers of x² from the highest. On ±π/4 the first one
/// left out is below the rounding of the sum.
const SINE: [f64; 7] = [
    -1.0 / 1_307_674_368_000.0,
    1.0 / 6_227_020_800.0,
    -1.0 / 39_916_800.0,
    1.0 / 362_880.0,
    -1.0 / 5_040.0,
    1.0 / 120.0,
    -1.0 / 6.0,
];

/// Taylor coefficients of the cosine after 1, in the same order.
const COSINE: [f64; 8] = [
    1.0 / 20_922_789_888_000.0,
    -1.0 / 87_178_291_200.0,
    1.0 / 479_001_600.0,
    -1.0 / 3_628_800.0,
    1.0 / 40_320.0,
    -1.0 / 720.0,
    1.0 / 24.0,
    -1.0 / 2.0,
];

/// Sine and cosine of `angle` [rad], to the last bit or the one before it for up to a thousand
/// turns.
#[must_use]
pub fn sin_cos(angle: f64) -> (f64, f64) {
    let quarters = (angle * FRAC_2_PI).round();
    let x = (angle - quarters * HALF_PI[0]) - quarters * HALF_PI[1];
    let square = x * x;
    let series = |coefficients: &[f64]| coefficients.iter().fold(0.0, |sum, c| sum * square + c);
    let (sin, cos) = (x + x * square * series(&SINE), 1.0 + square * series(&COSINE));
    #[expect(clippy::cast_possible_truncation, reason = "casts saturate")]
    match quarters as i64 & 3 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_agree_with_the_standard_library() {
        for i in -100_000..=100_000 {
            for angle in [f64::from(i) * 1e-4, f64::from(i) * std::f64::consts::FRAC_PI_4] {
                let ((sin, cos), truth) = (sin_cos(angle), angle.sin_cos());
                let error = (sin - truth.0).abs().max((cos - truth.1).abs());
                // Twice the spacing of numbers below 1.
                let allowed = if angle.abs() < 6300.0 { 2.3e-16 } else { 1e-14 };
                assert!(error < allowed, "{angle}: {sin} {cos} instead of {truth:?}");
            }
        }
        assert_eq!(sin_cos(0.0), (0.0, 1.0), "of nothing");
        assert_eq!(sin_cos(1e-9).0, 1e-9, "a tiny angle is its sine");
        assert!(sin_cos(f64::INFINITY).0.is_nan(), "infinity has none");
    }
}
