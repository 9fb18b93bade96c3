//! The operators and functions of expressions.
//!
//! Angles are in degrees. Those functions that the standard library brings with kilobytes of code
//! are made from others here, to the last few bits.

use std::f64::consts::{LN_2, LOG2_E};

use super::dialect::Dialect;
use crate::geometry::sin_cos;

/// Numbers that differ by less are equal in RS274/NGC, as `LinuxCNC` has it.
const EQUAL: f64 = 1e-4;

/// Numbers that differ by less of themselves are equal in SINUMERIK's programs.
const NEARLY: f64 = 1e-12;

/// An operator between two numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Operator {
    Power,
    Times,
    Divide,
    DivideWhole,
    Modulo,
    Plus,
    Minus,
    Equal,
    NotEqual,
    Greater,
    GreaterOrEqual,
    Less,
    LessOrEqual,
    And,
    Or,
    ExclusiveOr,
}

use Operator::{
    And, Divide, DivideWhole, Equal, ExclusiveOr, Greater, GreaterOrEqual, Less, LessOrEqual,
    Minus, Modulo, NotEqual, Or, Plus, Power, Times,
};

/// How operators are written; where one begins like another, the longer comes first.
pub(super) const OPERATORS: [(&str, Operator); 22] = [
    ("**", Power),
    ("*", Times),
    ("/", Divide),
    ("MOD", Modulo),
    ("+", Plus),
    ("-", Minus),
    ("EQ", Equal),
    ("NE", NotEqual),
    ("GT", Greater),
    ("GE", GreaterOrEqual),
    ("LT", Less),
    ("LE", LessOrEqual),
    ("AND", And),
    ("OR", Or),
    ("XOR", ExclusiveOr),
    // SINUMERIK's.
    ("DIV", DivideWhole),
    ("==", Equal),
    ("<>", NotEqual),
    (">=", GreaterOrEqual),
    (">", Greater),
    ("<=", LessOrEqual),
    ("<", Less),
];

/// Why there is no result.
pub(super) type Impossible = (&'static str, &'static str);

const TOO_LARGE: Impossible = ("no-number", "the result is too large");

impl Operator {
    /// How tightly it binds. FANUC's bitwise operators bind like the arithmetic ones they resemble, and
    /// SINUMERIK's comparisons less tightly than what combines them.
    pub(super) fn rank(self, dialect: Dialect) -> u8 {
        let [and, exclusive_or, or, comparison] = match dialect {
            Dialect::Fanuc => [6, 5, 5, 4],
            Dialect::Sinumerik => [4, 3, 2, 1],
            _ => [1, 1, 1, 2],
        };
        match self {
            Power => 7,
            Times | Divide | DivideWhole | Modulo => 6,
            Plus | Minus => 5,
            And => and,
            ExclusiveOr => exclusive_or,
            Or => or,
            Equal | NotEqual | Greater | GreaterOrEqual | Less | LessOrEqual => comparison,
        }
    }

    /// The result; NaN stands for FANUC's vacant variable.
    pub(super) fn apply(self, a: f64, b: f64, dialect: Dialect) -> Result<f64, Impossible> {
        if dialect != Dialect::Fanuc {
            return self.apply_to_numbers(a, b, dialect);
        }
        // Vacant equals nothing but vacant; for everything else it is a zero.
        match self {
            Equal if a.is_nan() || b.is_nan() => Ok(f64::from(u8::from(a.is_nan() == b.is_nan()))),
            NotEqual if a.is_nan() || b.is_nan() => {
                Ok(f64::from(u8::from(a.is_nan() != b.is_nan())))
            }
            _ => self.apply_to_numbers(or_zero(a), or_zero(b), dialect),
        }
    }

    fn apply_to_numbers(self, a: f64, b: f64, dialect: Dialect) -> Result<f64, Impossible> {
        let fanuc = dialect == Dialect::Fanuc;
        let apart = (a - b).abs();
        // Whether numbers count as equal that are just nearly so also where one is to be greater.
        let mut nearly = false;
        let equal = match dialect {
            Dialect::Fanuc => a == b,
            Dialect::Sinumerik => {
                nearly = apart <= NEARLY * a.abs();
                nearly
            }
            _ => apart < EQUAL,
        };
        let truth = match self {
            Equal => equal,
            NotEqual => !equal,
            Greater => a > b && !nearly,
            GreaterOrEqual => a >= b || nearly,
            Less => a < b && !nearly,
            LessOrEqual => a <= b || nearly,
            And | Or | ExclusiveOr if fanuc => return bits(self, a, b),
            And => a != 0.0 && b != 0.0,
            Or => a != 0.0 || b != 0.0,
            ExclusiveOr => (a != 0.0) != (b != 0.0),
            Plus => return finite(a + b),
            Minus => return finite(a - b),
            Times => return finite(a * b),
            Divide | DivideWhole if b == 0.0 => {
                return Err(("division-by-zero", "division by zero"));
            }
            Divide => return finite(a / b),
            DivideWhole => return finite((a / b).trunc()),
            Modulo => return modulo(a, b, fanuc),
            Power => return power(a, b),
        };
        Ok(f64::from(u8::from(truth)))
    }
}

/// FANUC's logical operators work on the bits of whole numbers.
fn bits(operator: Operator, a: f64, b: f64) -> Result<f64, Impossible> {
    let (a, b) = (a.round(), b.round());
    if a.abs() > f64::from(u32::MAX) || b.abs() > f64::from(u32::MAX) {
        return Err(TOO_LARGE);
    }
    #[expect(clippy::cast_possible_truncation, reason = "checked")]
    let (a, b) = (a as i64, b as i64);
    Ok(match operator {
        And => a & b,
        Or => a | b,
        _ => a ^ b,
    } as f64)
}

/// In RS274/NGC the remainder is never negative; FANUC's has the sign of the dividend, and both
/// numbers are rounded first.
fn modulo(a: f64, b: f64, fanuc: bool) -> Result<f64, Impossible> {
    let (a, b) = if fanuc { (a.round(), b.round()) } else { (a, b) };
    if b == 0.0 && fanuc {
        return Err(("division-by-zero", "the remainder of a division by zero"));
    }
    let remainder = a - (a / b).trunc() * b;
    // The quotient may have been rounded up to the next whole number.
    if remainder.abs() >= b.abs() || remainder != 0.0 && (remainder < 0.0) != (a < 0.0) {
        return Ok(0.0);
    }
    Ok(if remainder < 0.0 && !fanuc { remainder + b.abs() } else { remainder })
}

fn power(a: f64, b: f64) -> Result<f64, Impossible> {
    if b.fract() == 0.0 && b.abs() <= 1024.0 {
        #[expect(clippy::cast_possible_truncation, reason = "checked")]
        return Ok(a.powi(b as i32));
    }
    match a {
        0.0 if b > 0.0 => Ok(0.0),
        _ if a > 0.0 => exponential(b * a.ln()),
        _ => Err(("no-number", "a negative number to a power that is not whole")),
    }
}

/// A function of one number, apart from ATAN, which may have two.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Function {
    Absolute,
    ArcCosine,
    ArcSine,
    ArcTangent,
    Cosine,
    Exponential,
    RoundDown,
    RoundUp,
    Round,
    Logarithm,
    Sine,
    SquareRoot,
    Tangent,
    Exists,
    Power,
    Square,
    FromDecimalCode,
    ToDecimalCode,
}

/// The names of functions; where one begins like another, the longer comes first.
pub(super) const FUNCTIONS: [(&str, Function); 21] = [
    ("ABS", Function::Absolute),
    ("ACOS", Function::ArcCosine),
    ("ASIN", Function::ArcSine),
    ("ATAN2", Function::ArcTangent),
    ("ATAN", Function::ArcTangent),
    ("COS", Function::Cosine),
    ("EXP", Function::Exponential),
    ("EXISTS", Function::Exists),
    ("FIX", Function::RoundDown),
    ("TRUNC", Function::RoundDown),
    ("FUP", Function::RoundUp),
    ("ROUND", Function::Round),
    ("LN", Function::Logarithm),
    ("SIN", Function::Sine),
    ("SQRT", Function::SquareRoot),
    ("TAN", Function::Tangent),
    ("POW", Function::Power),
    ("POT", Function::Square),
    ("BIN", Function::FromDecimalCode),
    ("BCD", Function::ToDecimalCode),
    ("SQR", Function::SquareRoot),
];

impl Function {
    /// The function of one number.
    pub(super) fn apply(self, x: f64, dialect: Dialect) -> Result<f64, Impossible> {
        let fanuc = dialect == Dialect::Fanuc;
        let x = if fanuc { or_zero(x) } else { x };
        // FANUC and SINUMERIK round towards zero and away from it, RS274/NGC down and up.
        let whole = !(fanuc || dialect == Dialect::Sinumerik);
        match self {
            Self::Absolute => Ok(x.abs()),
            Self::ArcCosine | Self::ArcSine if x.abs() > 1.0 => {
                Err(("no-number", "the inverse of a sine or cosine beyond 1"))
            }
            // Free of cancellation near ±1.
            Self::ArcCosine => Ok(arc_tangent(((1.0 - x) * (1.0 + x)).sqrt(), x)),
            Self::ArcSine => Ok(turned(arc_tangent(x, ((1.0 - x) * (1.0 + x)).sqrt()), fanuc)),
            Self::ArcTangent => Ok(arc_tangent(x, 1.0)),
            Self::Sine => sin_cos_degrees(x).map(|(sin, _)| sin),
            Self::Cosine => sin_cos_degrees(x).map(|(_, cos)| cos),
            Self::Tangent => match sin_cos_degrees(x)? {
                (_, 0.0) => Err(("no-number", "the tangent of a right angle")),
                (sin, cos) => finite(sin / cos),
            },
            Self::Exponential => exponential(x),
            Self::Logarithm if x <= 0.0 => {
                Err(("no-number", "the logarithm of a number that is not positive"))
            }
            Self::Logarithm => Ok(x.ln()),
            Self::RoundDown => Ok(if whole { x.floor() } else { x.trunc() }),
            Self::RoundUp => {
                Ok(if whole { x.ceil() } else { x.trunc() + x.fract().abs().ceil() * x.signum() })
            }
            Self::Round => Ok(x.round()),
            Self::SquareRoot if x < 0.0 => {
                Err(("no-number", "the square root of a negative number"))
            }
            Self::SquareRoot => Ok(x.sqrt()),
            Self::Square => finite(x * x),
            Self::FromDecimalCode => recoded(x, 16, 10),
            Self::ToDecimalCode => recoded(x, 10, 16),
            Self::Exists | Self::Power => {
                Err(("bad-expression", "the function has other arguments"))
            }
        }
    }

    /// The function of two numbers.
    pub(super) fn apply_to_two(self, a: f64, b: f64, dialect: Dialect) -> Result<f64, Impossible> {
        let (a, b) = (or_zero(a), or_zero(b));
        match self {
            Self::ArcTangent => Ok(turned(arc_tangent(a, b), dialect == Dialect::Fanuc)),
            _ => power(a, b),
        }
    }
}

/// FANUC counts the angles of inverse functions from 0 to 360 unless a parameter says otherwise.
fn turned(angle: f64, fanuc: bool) -> f64 {
    if fanuc && angle < 0.0 { angle + 360.0 } else { angle }
}

fn or_zero(value: f64) -> f64 {
    if value.is_nan() { 0.0 } else { value }
}

fn finite(value: f64) -> Result<f64, Impossible> {
    if value.is_finite() { Ok(value) } else { Err(TOO_LARGE) }
}

fn arc_tangent(y: f64, x: f64) -> f64 {
    y.atan2(x).to_degrees()
}

/// Sine and cosine, exact for multiples of a right angle.
fn sin_cos_degrees(angle: f64) -> Result<(f64, f64), Impossible> {
    if angle.abs() > 1e9 {
        return Err(TOO_LARGE);
    }
    let quarters = (angle / 90.0).round();
    let (sin, cos) = sin_cos((angle - 90.0 * quarters).to_radians());
    #[expect(clippy::cast_possible_truncation, reason = "at most 1e9/90")]
    Ok(match quarters as i64 & 3 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    })
}

/// eˣ: with x = k ln 2 + y and |y| ≤ ln 2 / 2, 2ᵏ times the Taylor series of eʸ.
fn exponential(x: f64) -> Result<f64, Impossible> {
    if x.abs() > 700.0 {
        return if x < 0.0 { Ok(0.0) } else { Err(TOO_LARGE) };
    }
    let k = (x * LOG2_E).round();
    let y = x - k * LN_2;
    let (mut sum, mut n) = (1.0, 17.0);
    while n > 0.0 {
        (sum, n) = (1.0 + sum * y / n, n - 1.0);
    }
    #[expect(clippy::cast_possible_truncation, reason = "at most 1010")]
    Ok(sum * 2.0_f64.powi(k as i32))
}

/// The digits of a whole number in base `from`, read in base `to`: BIN and BCD.
fn recoded(x: f64, from: u32, to: u32) -> Result<f64, Impossible> {
    if x < 0.0 || x > f64::from(u32::MAX) {
        return Err(TOO_LARGE);
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked")]
    let mut rest = x.round() as u32;
    let (mut sum, mut place) = (0.0, 1.0);
    while rest > 0 {
        let digit = rest % from;
        if digit > 9 {
            return Err(("no-number", "a digit of a decimal code beyond 9"));
        }
        sum += place * f64::from(digit);
        place *= f64::from(to);
        rest /= from;
    }
    Ok(sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_agree_with_the_standard_library() {
        for i in -2_000..=2_000 {
            let x = f64::from(i) * 0.037;
            let e = exponential(x).expect("small");
            assert!((e - x.exp()).abs() <= 4e-14 * e, "exp {x}: {e}");
            let y = x.abs() + 1e-9;
            let p = power(y, 1.37).expect("positive");
            assert!((p - y.powf(1.37)).abs() <= 1e-13 * p.max(1e-300), "{y} to 1.37: {p}");
            let (sin, cos) = sin_cos_degrees(x * 10.0).expect("small");
            let truth = (x * 10.0).to_radians().sin_cos();
            assert!((sin - truth.0).abs() < 1e-14 && (cos - truth.1).abs() < 1e-14, "{x}");
            let z = x / 75.0;
            let asin = Function::ArcSine.apply(z, Dialect::LinuxCnc).expect("below 1");
            let acos = Function::ArcCosine.apply(z, Dialect::LinuxCnc).expect("below 1");
            assert!((asin - z.asin().to_degrees()).abs() < 1e-12, "asin {z}");
            assert!((acos - z.acos().to_degrees()).abs() < 1e-12, "acos {z}");
            let m = modulo(x, 0.7, false).expect("no zero");
            assert!((0.0..0.7).contains(&m), "{x} mod 0.7: {m}");
            let quotient = (x - m) / 0.7;
            assert!((quotient - quotient.round()).abs() < 1e-12, "{x} mod 0.7: {m}");
        }
    }
}
