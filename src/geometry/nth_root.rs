//! Roots of any degree, in little code: `powf` and `cbrt` bring two kilobytes each.

/// The real root of a number that is not negative, to its last few bits; of one that is, zero.
///
/// Newton's method from a value that has the exponent divided by the degree, and a mantissa made in the
/// same way: within a sixteenth, which six steps bring to the last bits for degrees up to twelve.
#[must_use]
pub fn nth_root(number: f64, degree: u32) -> f64 {
    if !(number > 0.0 && number < f64::INFINITY) {
        return number.max(0.0);
    }
    let one = 1.0_f64.to_bits();
    let n = u64::from(degree);
    let mut root = f64::from_bits(number.to_bits() / n + (one - one / n));
    for _ in 0..6 {
        let mut power = 1.0;
        for _ in 1..degree {
            power *= root;
        }
        root += (number / power - root) / f64::from(degree);
    }
    root
}

#[cfg(test)]
mod tests {
    use super::nth_root;

    #[test]
    fn roots_of_any_degree_are_found() {
        for degree in 1..=12 {
            for number in [1e-200, 1e-12, 0.3, 0.999, 1.0, 2.0, 7.5, 1e9, 1e12, 1e300] {
                let found = nth_root(number, degree);
                let exact = number.powf(1.0 / f64::from(degree));
                // The error of an exponent counts as often as the logarithm is large.
                let within = 1e-15 * (2.0 + number.ln().abs());
                assert!((found / exact - 1.0).abs() < within, "{degree} of {number}: {found}");
            }
        }
    }

    #[test]
    fn what_has_no_such_root_gives_zero_or_infinity() {
        let cases = [(0.0, 0.0), (-8.0, 0.0), (f64::INFINITY, f64::INFINITY), (f64::NAN, 0.0)];
        for (number, expected) in cases {
            assert_eq!(nth_root(number, 3), expected, "{number}");
        }
    }
}
