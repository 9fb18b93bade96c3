//! The Pythagorean-hodograph curves that round a corner, as polynomials.
//!
//! The hodograph of such a curve is the square of a complex polynomial `w`, so that its parametric
//! speed `|w|²`, its arc length and its direction are polynomials or quotients of them (Farouki,
//! "Pythagorean-Hodograph Curves", 2008, ch. 17). Seen from the middle of a symmetric corner, with
//! `x` in `[-1, 1]` and `y = x²`, `w = u + i v` with `u = C α(y) + e β(y)` even and `v = S x γ(y)`
//! odd; `C` and `S` are cosine and sine of a quarter of the turn, and `e = 1 − C` where the middle
//! coefficient of `w` is free, else 0.

/// Which Pythagorean-hodograph curve rounds a corner between two lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum CornerCurve {
    /// Degree 13, `w = (1, 1, 1, c q, E, E, E)`: curvature and its derivative vanish at both ends,
    /// and the parametric speed is even to 0.9 %.
    #[default]
    Ph13,
    /// Degree 11, `w = (1, 1, 1, E, E, E)`: the same, but `c q` left out.
    Ph11,
    /// Degree 9, `w = (1, 3, 0, 3 E, E)`: the same contact with the lines in fewer terms.
    Ph9,
    /// Degree 5, `w = (1, 0, E)`: only the curvature vanishes at both ends, so its derivative, and
    /// the jerk with it, jumps there.
    Ph5,
    /// No Pythagorean-hodograph curve, but the one along which a velocity changes evenly from one
    /// line's direction to the other's, of degree 8: the tool slows down in it, and takes less time
    /// where jerk is what limits.
    Eased,
}

/// Coefficients by powers of `y`, the lowest first.
pub(super) type Series = [f64; 7];

/// The fixed polynomials of one kind of curve.
pub(super) struct Family {
    /// Even part of `w` times `C`.
    pub(super) even: Series,
    /// Even part of `w` times `e`.
    pub(super) middle: Series,
    /// Odd part of `w` over `x`, times `S`.
    pub(super) odd: Series,
    /// `∫ α² dx`, `∫ α β dx`, `∫ β² dx` and `∫ x² γ² dx`, each over `x`.
    pub(super) squares: [Series; 4],
    /// `∫ α x γ dx` and `∫ β x γ dx`, each over `y`.
    pub(super) across: [Series; 2],
    /// Coefficients of `w` in Bernstein form: a factor (of `c` where the last is true), and the
    /// angle in quarters of the turn.
    pub(super) control: &'static [(f64, usize, bool)],
    /// Newton steps that the inverse of the arc length takes to rounding for any turn.
    pub(super) steps: usize,
}

/// The smooth step of degree 5 from −1 to 1, `x (15 − 10 y + 3 y²)/8`, over `x`.
const STEP: [f64; 3] = [15.0 / 8.0, -10.0 / 8.0, 3.0 / 8.0];

const PH13: Family = Family::new(
    &[1.0],
    &[1.0, -3.0, 3.0, -1.0],
    &STEP,
    &[
        (1.0, 0, false),
        (1.0, 0, false),
        (1.0, 0, false),
        (1.0, 1, true),
        (1.0, 2, false),
        (1.0, 2, false),
        (1.0, 2, false),
    ],
    2,
);
const PH11: Family = Family::new(
    &[1.0],
    &[],
    &STEP,
    &[
        (1.0, 0, false),
        (1.0, 0, false),
        (1.0, 0, false),
        (1.0, 2, false),
        (1.0, 2, false),
        (1.0, 2, false),
    ],
    12,
);
const PH9: Family = Family::new(
    &[13.0 / 8.0, 6.0 / 8.0, -11.0 / 8.0],
    &[],
    &[7.0 / 2.0, -5.0 / 2.0],
    &[(1.0, 0, false), (3.0, 0, false), (0.0, 0, false), (3.0, 2, false), (1.0, 2, false)],
    12,
);
const PH5: Family =
    Family::new(&[0.5, 0.5], &[], &[1.0], &[(1.0, 0, false), (0.0, 0, false), (1.0, 2, false)], 12);

impl CornerCurve {
    pub(super) fn family(self) -> &'static Family {
        match self {
            // An eased corner has no such curve, and asks for none.
            Self::Ph13 | Self::Eased => &PH13,
            Self::Ph11 => &PH11,
            Self::Ph9 => &PH9,
            Self::Ph5 => &PH5,
        }
    }
}

impl Family {
    const fn new(
        even: &[f64],
        middle: &[f64],
        odd: &[f64],
        control: &'static [(f64, usize, bool)],
        steps: usize,
    ) -> Self {
        Self {
            even: series(even),
            middle: series(middle),
            odd: series(odd),
            // x² = y raises each term by a power.
            squares: [
                integral(even, even, 0, 1.0),
                integral(even, middle, 0, 1.0),
                integral(middle, middle, 0, 1.0),
                integral(odd, odd, 1, 1.0),
            ],
            across: [integral(even, odd, 0, 2.0), integral(middle, odd, 0, 2.0)],
            control,
            steps,
        }
    }
}

const fn series(given: &[f64]) -> Series {
    let mut all = [0.0; 7];
    let mut i = 0;
    while i < given.len() {
        all[i] = given[i];
        i += 1;
    }
    all
}

/// The integral from 0 to `x` of the product of two polynomials of `y`, raised by `y^raised`: term
/// `k` of the product becomes `x^(2k + least)/(2k + least)`, with `least` 1 for an even integrand
/// and 2 for one that has another factor of `x`; the power of `x` in front is left out.
const fn integral(a: &[f64], b: &[f64], raised: usize, least: f64) -> Series {
    let mut sum = [0.0; 7];
    let mut i = 0;
    while i < a.len() {
        let mut j = 0;
        while j < b.len() {
            let k = i + j + raised;
            sum[k] += a[i] * b[j] / (2.0 * k as f64 + least);
            j += 1;
        }
        i += 1;
    }
    sum
}
