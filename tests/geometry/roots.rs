//! Roots of polynomials in Bernstein form, made from their roots.

use g41::geometry::roots;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common::random::Random;

/// Bernstein coefficients of the product of `(t − r)`, by multiplying one factor at a time:
/// `c'ₖ = ((n − k) (0 − r) cₖ + k (1 − r) cₖ₋₁) / n`.
fn bernstein<const N: usize>(of: &[f64]) -> [f64; N] {
    assert_eq!(of.len(), N - 1, "one root for each degree");
    let mut c = vec![1.0];
    for (degree, r) in of.iter().enumerate() {
        let n = (degree + 1) as f64;
        let next = (0..=degree + 1).map(|k| {
            let kept = if k <= degree { (n - k as f64) * -r * c[k] } else { 0.0 };
            let raised = if k > 0 { k as f64 * (1.0 - r) * c[k - 1] } else { 0.0 };
            (kept + raised) / n
        });
        c = next.collect();
    }
    c.try_into().expect("N coefficients")
}

fn every_root_is_found<const N: usize>(seed: u64) {
    let mut random = Random::new(seed);
    for case in 0..400 {
        let mut expected: Vec<f64> = (0..N - 1).map(|_| random.within(-0.5, 1.5)).collect();
        expected.sort_by(f64::total_cmp);
        let gap = expected.windows(2).map(|w| w[1] - w[0]).fold(1.0, f64::min);
        let edge = expected.iter().map(|r| r.abs().min((r - 1.0).abs())).fold(1.0, f64::min);
        if gap < 0.02 || edge < 1e-6 {
            continue;
        }
        let scale = 10.0_f64.powf(random.within(-8.0, 8.0));
        let found = roots(&bernstein::<N>(&expected).map(|c| c * scale));
        expected.retain(|r| (0.0..=1.0).contains(r));
        assert_eq!(found.len(), expected.len(), "case {case}: {expected:?} found as {found:?}");
        for (f, e) in found.iter().zip(&expected) {
            // The coefficients carry rounding of 1e-16, a root's slope is at least gap^(N-2).
            let slack = 1e-14 / gap.powi(4);
            assert!((f - e).abs() < slack, "case {case}: {e} found as {f}, {expected:?}");
        }
    }
}

#[test]
fn every_root_is_found_at_every_degree() {
    every_root_is_found::<2>(21);
    every_root_is_found::<3>(22);
    every_root_is_found::<4>(23);
    every_root_is_found::<6>(24);
    every_root_is_found::<7>(25);
}

#[test]
fn two_roots_are_told_apart_down_to_their_conditioning() {
    for exponent in 1..=6 {
        let gap = 10.0_f64.powi(-exponent);
        for at in [0.1, 0.37, 0.5, 0.9] {
            let found = roots(&bernstein::<4>(&[at, at + gap, 3.0]));
            assert_eq!(found.len(), 2, "roots {at} and {gap:e} on found as {found:?}");
            for (f, e) in found.iter().zip([at, at + gap]) {
                // Rounding of 1e-16 in the values over a slope of the gap.
                assert!((f - e).abs() < 1e-14 / gap, "root {e} found as {f}, gap {gap:e}");
            }
        }
    }
}

#[test]
fn multiple_roots_are_found_near_their_place() {
    for at in [0.2, 0.25, 0.5, 0.7321] {
        for (name, found, slack) in [
            ("double", roots(&bernstein::<7>(&[at, at, -1.0, 2.0, 3.0, -2.0])), 1e-6),
            ("triple", roots(&bernstein::<4>(&[at, at, at])), 1e-4),
        ] {
            assert!(!found.is_empty(), "the {name} root at {at} is lost");
            for f in &found {
                assert!((f - at).abs() < slack, "the {name} root at {at} is found as {found:?}");
            }
        }
    }
}

#[test]
fn roots_at_the_ends_are_exact() {
    for others in [[0.5, 3.0], [-1.0, 2.0], [0.001, 0.999]] {
        let found = roots(&bernstein::<4>(&[0.0, others[0], others[1]]));
        assert_eq!(found.first(), Some(&0.0), "the root at 0 beside {others:?}: {found:?}");
        let found = roots(&bernstein::<4>(&[1.0, others[0], others[1]]));
        assert_eq!(found.last(), Some(&1.0), "the root at 1 beside {others:?}: {found:?}");
    }
    assert_eq!(roots(&bernstein::<3>(&[0.0, 1.0])), vec![0.0, 1.0], "both ends");
}

#[test]
fn what_is_not_a_number_has_no_root() {
    assert!(roots(&[f64::NAN, 1.0, -1.0]).is_empty(), "NaN");
    assert!(roots(&[f64::INFINITY, 1.0, -1.0]).is_empty(), "infinity");
}
