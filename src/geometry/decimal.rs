//! Numbers as texts, and texts as numbers.
//!
//! The standard library does both exactly for every number there is, with tables that would be a
//! third of the whole WebAssembly. Lengths on machines have fewer digits, and whole numbers do.

use std::fmt;

/// Decimals of millimetres in messages: a tenth of a micrometre.
const PLACES: u32 = 4;

/// From here on, numbers are written with an exponent; below it, they fit a whole number exactly.
const LARGE: f64 = 1e15;

/// Most digits that are read; further ones do not change an `f64`.
const MOST_DIGITS: u64 = 10_u64.pow(18);

/// A number to be written with a few decimals, without trailing zeros.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Decimal {
    value: f64,
    places: u32,
}

impl Decimal {
    /// The number with up to `places` decimals, at most 15.
    #[must_use]
    pub fn new(value: f64, places: u32) -> Self {
        Self { value, places: places.min(15) }
    }

    /// The number as messages have it.
    #[must_use]
    pub fn of(value: f64) -> Self {
        Self::new(value, PLACES)
    }

    /// Adds it to a text; messages and JSON have millions of numbers, so nothing of `fmt` is here.
    pub fn push_to(self, out: &mut String) {
        let Self { value, places } = self;
        if value.is_nan() {
            out.push_str("not a number");
            return;
        }
        let (mut size, negative) = (value.abs(), value < 0.0);
        if size == f64::INFINITY {
            out.push_str(if negative { "-infinity" } else { "infinity" });
            return;
        }
        let mut exponent = 0;
        if size >= LARGE {
            while size >= 10.0 {
                size /= 10.0;
                exponent += 1;
            }
        }
        // Both parts are exact, and below 2^53.
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "see above")]
        let (whole, fraction) =
            (size.trunc() as u64, (size.fract() * 10_u64.pow(places) as f64).round() as u64);
        push_fixed(out, negative, [whole, fraction], places);
        if exponent > 0 {
            out.push('e');
            push_digits(out, exponent, 1);
        }
    }
}

impl fmt::Display for Decimal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = String::new();
        self.push_to(&mut text);
        f.write_str(&text)
    }
}

/// Adds `whole + fraction / 10^places` to a text, without trailing zeros and without a negative zero;
/// the fraction may be rounded up to one.
pub fn push_fixed(
    out: &mut String,
    negative: bool,
    [mut whole, mut fraction]: [u64; 2],
    mut places: u32,
) {
    let one = 10_u64.pow(places);
    if fraction >= one {
        (whole, fraction) = (whole + 1, fraction - one);
    }
    if negative && (whole > 0 || fraction > 0) {
        out.push('-');
    }
    push_digits(out, whole, 1);
    if fraction > 0 {
        while fraction % 10 == 0 {
            fraction /= 10;
            places -= 1;
        }
        out.push('.');
        push_digits(out, fraction, places);
    }
}

/// Adds a whole number of at least so many digits, at most nineteen.
fn push_digits(out: &mut String, number: u64, least: u32) {
    const NINE_DIGITS: u64 = 1_000_000_000;
    if number >= NINE_DIGITS {
        push_digits(out, number / NINE_DIGITS, least.saturating_sub(9));
        push_digits(out, number % NINE_DIGITS, 9);
        return;
    }
    // Numbers of 32 bits are divided much faster.
    let mut rest = u32::try_from(number).unwrap_or(u32::MAX);
    let mut digits = ['0'; 19];
    let mut at = digits.len();
    let last = at.saturating_sub(least as usize);
    while at > 0 && (rest > 0 || at > last) {
        at -= 1;
        digits[at] = char::from(b'0' + (rest % 10) as u8);
        rest /= 10;
    }
    for &digit in &digits[at..] {
        out.push(digit);
    }
}

/// The number that `text` consists of: an optional sign and digits with at most one point.
///
/// Up to fifteen digits it is the nearest number there is, beyond them within its last bit.
#[must_use]
pub fn parse_decimal(text: &str) -> Option<f64> {
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (mut digits, mut exponent) = (0_u64, 0);
    let (mut any, mut after_point) = (false, false);
    for letter in unsigned.bytes() {
        match letter {
            b'0'..=b'9' => {
                any = true;
                if digits < MOST_DIGITS / 10 {
                    digits = 10 * digits + u64::from(letter - b'0');
                    exponent -= i32::from(after_point);
                } else {
                    exponent += i32::from(!after_point);
                }
            }
            b'.' if !after_point => after_point = true,
            _ => return None,
        }
    }
    // Powers of ten up to 22 are exact, and so the quotient of exact numbers is rounded once.
    let size = if exponent < 0 {
        digits as f64 / 10_f64.powi(-exponent)
    } else {
        digits as f64 * 10_f64.powi(exponent)
    };
    any.then_some(if text.starts_with('-') { -size } else { size })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_rounded_to_the_nearest_decimal() {
        for (value, places, text) in [
            (0.0, 4, "0"),
            (-0.0, 4, "0"),
            (-0.00001, 4, "0"),
            (1.0, 4, "1"),
            (-12.5, 4, "-12.5"),
            (0.0101, 4, "0.0101"),
            (0.99996, 4, "1"),
            (2.999_951, 4, "3"),
            (1e9 + 0.125, 12, "1000000000.125"),
            (0.1, 15, "0.1"),
            (1.0 / 3.0, 15, "0.333333333333333"),
            (-1e300, 4, "-1e300"),
            (1.5e15, 4, "1.5e15"),
            (f64::NAN, 4, "not a number"),
            (f64::NEG_INFINITY, 4, "-infinity"),
        ] {
            assert_eq!(Decimal::new(value, places).to_string(), text, "{value:?}");
        }
    }

    #[test]
    fn numbers_of_up_to_fifteen_digits_are_read_exactly() {
        // Every seventh number of a sequence that mixes digits well.
        let mut state = 1_u64;
        for _ in 0..20_000 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(7);
            let digits = (state >> 14) % 10_u64.pow(u32::try_from(state >> 60).expect("small"));
            let digits = digits.to_string();
            let point = usize::try_from(state >> 8).expect("64 bits") % (digits.len() + 1);
            let text = format!("{}.{}", &digits[..point], &digits[point..]);
            let truth: f64 = text.parse().expect("it is a number");
            assert_eq!(parse_decimal(&text), Some(truth), "{text}");
            assert_eq!(parse_decimal(&format!("-{text}")), Some(-truth), "-{text}");
        }
    }

    #[test]
    fn long_numbers_are_read_to_their_last_bit() {
        for text in
            ["123456789.123456789123456789", "0.1234567890123456789", "98765432109876543210"]
        {
            let truth: f64 = text.parse().expect("it is a number");
            let read = parse_decimal(text).expect("it is a number");
            assert!((read - truth).abs() <= f64::EPSILON * truth, "{text}: {read:?}");
        }
        assert_eq!(parse_decimal(&"9".repeat(1000)), Some(f64::INFINITY), "too large");
        assert_eq!(parse_decimal(&format!(".{}1", "0".repeat(1000))), Some(0.0), "too small");
    }

    #[test]
    fn what_is_no_number_is_refused() {
        for text in ["", "+", "-", ".", "-.", "1.2.3", "--1", "1-", "1e5", "nan", "inf", " 1"] {
            assert_eq!(parse_decimal(text), None, "{text:?}");
        }
    }
}
