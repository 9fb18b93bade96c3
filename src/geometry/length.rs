//! Gauss–Legendre quadrature, and the arc length of cubics by it.

use super::Cubic;

/// Nodes and weights of the 8-point rule on `[-1, 1]` (Abramowitz and Stegun, table 25.4);
/// the rule is symmetric, so one of each pair stands here.
const NODES: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_5),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

/// Arc length of `cubic` to a relative error of about 1e-12.
pub(super) fn arc_length(cubic: &Cubic) -> f64 {
    let hull = cubic.hull_length();
    refine(cubic, 0.0, 1.0, rule(cubic, 0.0, 1.0), 1e-12 * hull, 0)
}

/// Halves the interval until both halves together agree with the whole.
fn refine(cubic: &Cubic, from: f64, to: f64, whole: f64, tolerance: f64, depth: u32) -> f64 {
    let middle = 0.5 * (from + to);
    let (left, right) = (rule(cubic, from, middle), rule(cubic, middle, to));
    // Speed has a kink where the derivative vanishes (a cusp); 30 halvings leave 1e-9 of it.
    if (left + right - whole).abs() <= tolerance || depth == 30 {
        return left + right;
    }
    refine(cubic, from, middle, left, 0.5 * tolerance, depth + 1)
        + refine(cubic, middle, to, right, 0.5 * tolerance, depth + 1)
}

/// One application of the 8-point rule over `[from, to]`.
fn rule(cubic: &Cubic, from: f64, to: f64) -> f64 {
    gauss_legendre(from, to, &mut |t| cubic.derivative(t).length())
}

/// The integral of a function over `[from, to]` by the 8-point Gauss–Legendre rule, which is exact
/// for polynomials of degree 15.
pub fn gauss_legendre(from: f64, to: f64, function: &mut dyn FnMut(f64) -> f64) -> f64 {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let mut sum = 0.0;
    for (node, weight) in NODES {
        sum += weight * (function(middle - half * node) + function(middle + half * node));
    }
    sum * half
}
