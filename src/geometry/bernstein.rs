//! Roots in `[0, 1]` of polynomials in Bernstein form.
//!
//! The coefficients bound the polynomial (convex hull) and their sign changes bound its number of
//! roots (Descartes' rule in Bernstein form), so halving isolates every root without a guess:
//! no sign change, no root; one, exactly one root; more, halve again.

/// Depth at which an interval with several sign changes counts as one multiple root: 2⁻⁴⁰ wide,
/// where the coefficients of a double root are down at the rounding of their sum.
const MAX_DEPTH: u32 = 40;

/// Coefficients below this fraction of the largest count as zero: rounding of de Casteljau's sums.
const ZERO_FRACTION: f64 = 1e-15;

/// Most coefficients of a polynomial whose roots are asked for: an arc and a cubic take 7.
const MOST: usize = 8;

/// The roots in `[0, 1]` of the polynomial with the given Bernstein coefficients, at most 8 of
/// them, ascending.
///
/// A root where the polynomial touches zero without crossing, up to rounding, is listed once. A
/// polynomial that is zero throughout, or not finite, has no isolated root: the list is empty.
#[must_use]
pub fn roots(coefficients: &[f64]) -> Vec<f64> {
    let scale = coefficients.iter().fold(0.0_f64, |m, c| m.max(c.abs()));
    let mut found = Vec::new();
    if scale == 0.0 || !coefficients.iter().all(|c| c.is_finite()) {
        return found;
    }
    let zero = scale * ZERO_FRACTION;
    isolate(coefficients, 0.0, 1.0, 0, zero, &mut found);
    // Intervals next to each other find a root between them, or the flat bottom of one, twice.
    found.dedup_by(|b, a| {
        let same = *b - *a < 1e-13 || value(coefficients, 0.5 * (*a + *b)).abs() <= zero;
        if same && *b == 1.0 {
            *a = 1.0;
        }
        same
    });
    found
}

/// Appends the roots of the part of the polynomial over `[from, to]`.
fn isolate(coefficients: &[f64], from: f64, to: f64, depth: u32, zero: f64, found: &mut Vec<f64>) {
    let last = coefficients.len() - 1;
    let starts_at_zero = coefficients[0].abs() <= zero;
    let ends_at_zero = coefficients[last].abs() <= zero;
    // A zero at an end is that end; the other coefficients tell of the roots between.
    let between = &coefficients[usize::from(starts_at_zero)..=last - usize::from(ends_at_zero)];
    if starts_at_zero {
        found.push(from);
    }
    let changes = sign_changes(coefficients, zero);
    let apart = between.iter().all(|&c| c > zero) || between.iter().all(|&c| c < -zero);
    if changes == 1 && !starts_at_zero && !ends_at_zero {
        let t = bracketed_root(coefficients);
        found.push(from + (to - from) * t);
    } else if !apart {
        if depth == MAX_DEPTH || coefficients.iter().all(|c| c.abs() <= zero) {
            found.push(0.5 * (from + to));
        } else {
            let middle = 0.5 * (from + to);
            let (mut left, mut right) = ([0.0; MOST], [0.0; MOST]);
            let (left, right) = (&mut left[..=last], &mut right[..=last]);
            right.copy_from_slice(coefficients);
            halve(right, left);
            isolate(left, from, middle, depth + 1, zero, found);
            isolate(right, middle, to, depth + 1, zero, found);
        }
    }
    if ends_at_zero {
        found.push(to);
    }
}

/// Number of sign changes, zeros passed over.
fn sign_changes(coefficients: &[f64], zero: f64) -> usize {
    let mut changes = 0;
    let mut sign = 0.0;
    for &c in coefficients {
        if c.abs() > zero {
            if sign * c < 0.0 {
                changes += 1;
            }
            sign = c.signum();
        }
    }
    changes
}

/// The Bernstein coefficients over both halves of `[0, 1]` (de Casteljau): those over the second
/// take the place of the given ones, those over the first are put into `left`.
pub fn halve(coefficients: &mut [f64], left: &mut [f64]) {
    let last = coefficients.len() - 1;
    for (level, edge) in left.iter_mut().enumerate() {
        *edge = coefficients[0];
        for i in 0..last - level {
            coefficients[i] = 0.5 * (coefficients[i] + coefficients[i + 1]);
        }
    }
}

/// Value at `t` by de Casteljau's algorithm.
pub(super) fn value(coefficients: &[f64], t: f64) -> f64 {
    let last = coefficients.len() - 1;
    let mut work = [0.0; MOST];
    work[..=last].copy_from_slice(coefficients);
    for level in 0..last {
        for i in 0..last - level {
            work[i] += t * (work[i + 1] - work[i]);
        }
    }
    work[0]
}

/// The one root of a polynomial whose values at 0 and 1 have opposite signs.
///
/// Regula falsi in the Illinois variant: it keeps the bracket and converges superlinearly.
fn bracketed_root(coefficients: &[f64]) -> f64 {
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    let (mut at_low, mut at_high) = (coefficients[0], coefficients[coefficients.len() - 1]);
    let mut last = f64::NAN;
    let mut moved_low = None;
    for _ in 0..100 {
        let secant = (low * at_high - high * at_low) / (at_high - at_low);
        let t = if secant > low && secant < high { secant } else { 0.5 * (low + high) };
        let here = value(coefficients, t);
        if here == 0.0 || high - low < 1e-15 || (t - last).abs() < 1e-16 {
            return t;
        }
        last = t;
        // An end that stays put twice gets half its weight, or it would stay for ever.
        if here * at_high < 0.0 {
            (low, at_low) = (t, here);
            if moved_low == Some(true) {
                at_high *= 0.5;
            }
            moved_low = Some(true);
        } else {
            (high, at_high) = (t, here);
            if moved_low == Some(false) {
                at_low *= 0.5;
            }
            moved_low = Some(false);
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bernstein coefficients of a cubic with the given roots.
    fn cubic_with_roots(r: [f64; 3]) -> [f64; 4] {
        // Blossom of (t - r0)(t - r1)(t - r2): symmetric in its three arguments.
        let blossom = |a: f64, b: f64, c: f64| {
            let mut sum = 0.0;
            for p in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
                sum += (a - r[p[0]]) * (b - r[p[1]]) * (c - r[p[2]]);
            }
            sum / 6.0
        };
        [
            blossom(0.0, 0.0, 0.0),
            blossom(0.0, 0.0, 1.0),
            blossom(0.0, 1.0, 1.0),
            blossom(1.0, 1.0, 1.0),
        ]
    }

    #[test]
    fn simple_roots_are_found_to_rounding() {
        for r in [[0.2, 0.5, 0.9], [0.1, 0.1001, 0.7], [-3.0, 0.5, 4.0], [0.0, 0.3, 1.0]] {
            let expected: Vec<f64> = r.into_iter().filter(|t| (0.0..=1.0).contains(t)).collect();
            let found = roots(&cubic_with_roots(r));
            assert_eq!(found.len(), expected.len(), "roots {r:?} found as {found:?}");
            for (f, e) in found.iter().zip(&expected) {
                assert!((f - e).abs() < 1e-11, "root {e} found as {f}");
            }
        }
    }

    #[test]
    fn a_double_root_is_found_once_and_near() {
        let found = roots(&cubic_with_roots([0.4, 0.4, 7.0]));
        assert!(!found.is_empty(), "the double root is lost");
        for f in &found {
            assert!((f - 0.4).abs() < 1e-6, "double root found as {f}");
        }
    }

    #[test]
    fn no_root_and_zero_polynomial_give_none() {
        assert!(roots(&[1.0, 0.5, 2.0]).is_empty(), "a positive polynomial has no root");
        assert!(roots(&[0.0; 5]).is_empty(), "zero throughout has no isolated root");
    }
}
