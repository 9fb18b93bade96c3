//! The quintic B-spline on equidistant knots: on each interval six control points count.

use glam::DVec4;

/// The six functions on one interval, each by ascending powers of `t` in `[0, 1]`: de Boor's
/// recursion on the knots `-5, …, 6`.
const FUNCTIONS: [[f64; 6]; 6] = {
    let mut functions = [
        [1.0, -5.0, 10.0, -10.0, 5.0, -1.0],
        [26.0, -50.0, 20.0, 20.0, -20.0, 5.0],
        [66.0, 0.0, -60.0, 0.0, 30.0, -10.0],
        [26.0, 50.0, 20.0, -20.0, -20.0, 10.0],
        [1.0, 5.0, 10.0, 10.0, 5.0, -5.0],
        [0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
    ];
    let mut i = 0;
    while i < 36 {
        functions[i / 6][i % 6] /= 120.0;
        i += 1;
    }
    functions
};

/// The values of the six functions at `t` in `[0, 1]`; they are positive and sum up to 1.
pub(super) fn weights(t: f64) -> [f64; 6] {
    let mut values = [0.0; 6];
    for (value, function) in values.iter_mut().zip(&FUNCTIONS) {
        for c in function.iter().rev() {
            *value = *value * t + c;
        }
    }
    values
}

/// The sum of the first six control points, weighted.
pub(super) fn blend(controls: &[DVec4], weights: &[f64; 6]) -> DVec4 {
    let mut sum = DVec4::ZERO;
    for (control, weight) in controls.iter().zip(weights) {
        sum = *control * *weight + sum;
    }
    sum
}

/// The coefficients by ascending powers of `t` on the interval of the first six control points.
pub(super) fn powers(controls: &[DVec4]) -> [DVec4; 6] {
    let mut powers = [DVec4::ZERO; 6];
    for (control, function) in controls.iter().zip(&FUNCTIONS) {
        for (power, c) in powers.iter_mut().zip(function) {
            *power = *control * *c + *power;
        }
    }
    powers
}

/// The polynomial with the given coefficients by ascending powers, at `t`.
pub(super) fn value(powers: &[DVec4; 6], t: f64) -> DVec4 {
    powers.iter().rev().fold(DVec4::ZERO, |sum, power| sum * t + *power)
}
