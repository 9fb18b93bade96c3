//! What the tests share: seeded random numbers, curves evaluated independently, comparisons.
#![allow(dead_code, reason = "each test program uses its own part")]

pub(crate) mod curves;
pub(crate) mod double;
pub(crate) mod equidistant;
pub(crate) mod oracle;
pub(crate) mod random;

use glam::DVec2;

/// A point, in as few letters as a table of cases wants.
pub(crate) fn p(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

/// Asserts that two numbers differ by at most `tolerance`.
#[track_caller]
pub(crate) fn near(actual: f64, expected: f64, tolerance: f64, what: &str) {
    assert!(
        (actual - expected).abs() <= tolerance,
        "{what}: {actual:e} is not within {tolerance:e} of {expected:e}"
    );
}

/// Asserts that two points are at most `tolerance` apart.
#[track_caller]
pub(crate) fn near_point(actual: DVec2, expected: DVec2, tolerance: f64, what: &str) {
    assert!(
        actual.distance(expected) <= tolerance,
        "{what}: {actual} is {:e} from {expected}, more than {tolerance:e}",
        actual.distance(expected)
    );
}
