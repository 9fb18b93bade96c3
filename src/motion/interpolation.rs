//! Rules by which a control steps along a spline at constant feed, to compare them.
//!
//! Each finds from the parameter of one sample that of the next, one period's way along the curve.
//! The planner takes none of them: it traverses curves by their measured length, which errs by 1e-9
//! of a step. Steps of 0.1 mm and 0.4 mm on a flower of radius 20 mm, and on two wings that meet in a
//! tip of radius 0.12 mm, err by at most this part of themselves (`tests/motion/interpolation.rs`;
//! predictor–corrector by the chord, the others by the arc):
//!
//! | rule | flower, 0.1 | flower, 0.4 | near cusp, 0.1 | near cusp, 0.4 |
//! | --- | --- | --- | --- | --- |
//! | Taylor, first order | 1.4e-3 | 5.6e-3 | 1.2e-1 | 3.7e-1 |
//! | Taylor, second order | 1.5e-4 | 2.3e-3 | 3.1e-2 | 1.6e-1 |
//! | Runge–Kutta, order 4 | 2.2e-6 | 5.3e-5 | 3.8e-4 | 4.0e-2 |
//! | predictor, 1 corrector | 7.1e-10 | 5.4e-7 | 1.7e-2 | goes astray |
//! | predictor, 2 correctors | 3e-13 | 7e-14 | 3.0e-5 | 3.8e-3 |
//! | predictor, 3 correctors | 4e-13 | 8e-14 | 9.4e-11 | 5.9e-6 |
//! | arc length, 1 step | 2.2e-11 | 2.2e-8 | 1.2e-4 | 1.3e-2 |
//! | arc length, 2 steps | 9e-14 | 6e-14 | 1.2e-9 | 5.0e-5 |
//! | measured, as planned | 4e-13 | 7e-13 | 4e-10 | 2.5e-9 |

use glam::DVec2;

use crate::geometry::{Spline, gauss_legendre};

/// A rule that finds the next parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StepRule {
    /// `t + Δs/|r'|`: the first term of Taylor's series.
    TaylorFirst,
    /// With the second term, `−Δs² (r'·r'')/(2 |r'|⁴)`.
    TaylorSecond,
    /// The classical method of Runge and Kutta of order 4 on `dt/ds = 1/|r'|`.
    RungeKutta,
    /// Extrapolation of the three parameters before, and as many steps of Newton's method as said on
    /// the chord: the *chord* then has the length of a step, the arc is longer by `κ² Δs²/24` of it.
    PredictorCorrector(u8),
    /// The second order of Taylor's series, and as many steps of Newton's method as said on the arc
    /// length, by quadrature.
    ArcLength(u8),
}

/// Parameters, from 0 on, whose points are `step` [mm] apart along the spline, as a rule finds them;
/// none where the step is not a positive number.
#[must_use]
pub fn interpolate(spline: &Spline, step: f64, rule: StepRule) -> Vec<f64> {
    let mut found = vec![0.0];
    // A rule that overshoots may step back at a sharp bend; no more steps than these are ever due.
    let due = 4.0 * spline.length() / step + 16.0;
    if step <= 0.0 || step.is_nan() {
        return Vec::new();
    }
    let mut t = 0.0;
    while (found.len() as f64) < due {
        t = match rule {
            StepRule::TaylorFirst => t + step * rate(spline, t),
            StepRule::TaylorSecond => second_order(spline, t, step),
            StepRule::RungeKutta => {
                let k1 = rate(spline, t);
                let k2 = rate(spline, t + 0.5 * step * k1);
                let k3 = rate(spline, t + 0.5 * step * k2);
                let k4 = rate(spline, t + step * k3);
                t + step * (k1 + 2.0 * (k2 + k3) + k4) / 6.0
            }
            StepRule::PredictorCorrector(corrections) => {
                let mut next = match found.as_slice() {
                    [.., a, b, c] => 3.0 * (c - b) + a,
                    _ => second_order(spline, t, step),
                };
                let from = spline.point(t);
                for _ in 0..corrections {
                    let chord = spline.point(next.clamp(0.0, 1.0)) - from;
                    let length = chord.length();
                    let slope = chord.dot(derivative(spline, next)) / length;
                    next -= (length - step) / slope;
                }
                next
            }
            StepRule::ArcLength(corrections) => {
                let mut next = second_order(spline, t, step);
                for _ in 0..corrections {
                    next -= (length_between(spline, t, next) - step) * rate(spline, next);
                }
                next
            }
        };
        // Beyond the end, or where a rule has lost its way, there is no next point.
        if !(0.0..=1.0).contains(&t) {
            break;
        }
        found.push(t);
    }
    found
}

/// Arc length from the start of the spline to each of parameters that [`interpolate`] found [mm].
#[must_use]
pub fn lengths_at(spline: &Spline, parameters: &[f64]) -> Vec<f64> {
    let mut lengths = Vec::with_capacity(parameters.len());
    let (mut from, mut length) = (0.0, 0.0);
    for &t in parameters {
        length += length_between(spline, from, t);
        lengths.push(length);
        from = t;
    }
    lengths
}

/// Two terms of Taylor's series of the parameter by the arc length.
fn second_order(spline: &Spline, t: f64, step: f64) -> f64 {
    let (first, second) = (derivative(spline, t), spline.second_derivative(t.clamp(0.0, 1.0)));
    let square = first.length_squared();
    t + step / square.sqrt() - 0.5 * step * step * first.dot(second) / (square * square)
}

/// The parameter per length [1/mm].
fn rate(spline: &Spline, t: f64) -> f64 {
    1.0 / derivative(spline, t).length()
}

/// The derivative; beyond the ends that of the end.
fn derivative(spline: &Spline, t: f64) -> DVec2 {
    spline.derivative(t.clamp(0.0, 1.0))
}

/// Arc length between two parameters [mm], span by span.
fn length_between(spline: &Spline, from: f64, to: f64) -> f64 {
    if to < from {
        return -length_between(spline, to, from);
    }
    let mut length = 0.0;
    let mut at = from;
    let (first, last) = (spline.locate(from).0, spline.locate(to).0);
    for span in first..=last {
        let end = if span == last { to } else { spline.parameter_at(span, 1.0) };
        length += gauss_legendre(at, end, &mut |t| derivative(spline, t).length());
        at = end;
    }
    length
}
