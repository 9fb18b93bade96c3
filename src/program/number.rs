//! Numbers as programs write them: strict to read, short to write.

use crate::geometry::{parse_decimal, push_fixed};

/// Largest number a word may have: the range of coordinates in mm.
const MAX_NUMBER: f64 = 1e9;

/// Why a word's number cannot be used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum NumberError {
    /// There is none.
    Missing,
    /// It has two signs, two points, or no digit.
    Garbled,
    /// It is beyond [`MAX_NUMBER`].
    TooLarge,
}

/// The number that `text` consists of: an optional sign, digits with at most one point. No
/// exponent: in a program an E is a letter of its own.
pub(super) fn parse_number(text: &str) -> Result<f64, NumberError> {
    if text.is_empty() {
        return Err(NumberError::Missing);
    }
    let value = parse_decimal(text).ok_or(NumberError::Garbled)?;
    if value.abs() > MAX_NUMBER { Err(NumberError::TooLarge) } else { Ok(value) }
}

/// How far from a whole number one may be that an expression gave: `LinuxCNC`'s own.
const NEARLY_WHOLE: f64 = 1e-4;

/// The value as a whole number that a word can carry, if it is one.
pub(super) fn whole(value: f64) -> Option<u32> {
    let number = value.round();
    let is_near = (value - number).abs() < NEARLY_WHOLE;
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked")]
    (is_near && number >= 0.0 && number <= f64::from(u32::MAX)).then_some(number as u32)
}

/// Writes `scaled / 10^decimals` without trailing zeros and without a negative zero.
pub(super) fn push_scaled(text: &mut String, scaled: i64, decimals: u32) {
    let (units, one) = (scaled.unsigned_abs(), 10_u64.pow(decimals));
    push_fixed(text, scaled < 0, [units / one, units % one], decimals);
}

/// Writes a word with up to six decimals, as programs do not carry more.
pub(super) fn push_word(text: &mut String, letter: char, value: f64) {
    text.push(letter);
    // Words hold at most 1e9, so this stays below 2^53.
    #[expect(clippy::cast_possible_truncation, reason = "at most 1e15")]
    push_scaled(text, (value * 1e6).round() as i64, 6);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_a_sign_digits_and_one_point() {
        for (text, value) in
            [("0", 0.0), ("+5.", 5.0), ("-.5", -0.5), ("007", 7.0), ("1000000000", 1e9)]
        {
            assert_eq!(parse_number(text), Ok(value), "{text}");
        }
        for text in ["+", "-", ".", "1.2.3", "--1", "1-", "1e5", "nan", "inf"] {
            assert_eq!(parse_number(text), Err(NumberError::Garbled), "{text}");
        }
        assert_eq!(parse_number(""), Err(NumberError::Missing), "nothing");
        assert_eq!(parse_number("1000000001"), Err(NumberError::TooLarge), "beyond the range");
        assert_eq!(parse_number(&"9".repeat(1000)), Err(NumberError::TooLarge), "infinity");
    }

    #[test]
    fn numbers_are_written_with_as_few_digits_as_they_need() {
        for (scaled, text) in [
            (0, "0"),
            (1, "0.0001"),
            (-1, "-0.0001"),
            (10_000, "1"),
            (-125_000, "-12.5"),
            (100, "0.01"),
            (1_000_500, "100.05"),
        ] {
            let mut written = String::new();
            push_scaled(&mut written, scaled, 4);
            assert_eq!(written, text, "{scaled} / 10^4");
        }
    }
}
