//! Arc length against closed forms and a quadrature of its own.

use g41::geometry::Cubic;
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::shapes;
use crate::common::oracle::Plain;
use crate::common::random::Random;
use crate::common::{near, p};

/// Length by the tanh-sinh rule (Takahasi and Mori 1974), which bears a kink at an end, over
/// `panels` even panels.
fn quadrature(curve: &Plain, panels: u32) -> f64 {
    let mut sum = 0.0;
    let width = 1.0 / f64::from(panels);
    for panel in 0..panels {
        for k in -60..=60 {
            let u = f64::from(k) * 0.055;
            let (a, w) = (
                (0.5 * std::f64::consts::PI * u.sinh()).tanh(),
                0.5 * std::f64::consts::PI * u.cosh()
                    / (0.5 * std::f64::consts::PI * u.sinh()).cosh().powi(2),
            );
            let t = (f64::from(panel) + 0.5 * (1.0 + a)) * width;
            sum += curve.derivative(t).length() * w * 0.5 * width * 0.055;
        }
    }
    sum
}

#[test]
fn a_parabola_has_the_length_of_its_closed_form() {
    // y = a x² over [0, b], raised to degree 3.
    for (a, b) in [(1.0, 1.0), (0.01, 50.0), (100.0, 0.5), (1e-6, 10.0)] {
        let quadratic = [DVec2::ZERO, p(0.5 * b, 0.0), p(b, a * b * b)];
        let cubic = Cubic::new(
            quadratic[0],
            quadratic[0].lerp(quadratic[1], 2.0 / 3.0),
            quadratic[2].lerp(quadratic[1], 2.0 / 3.0),
            quadratic[2],
        );
        let v: f64 = 2.0 * a * b;
        let exact = (v * v.hypot(1.0) + v.asinh()) / (4.0 * a);
        near(cubic.length(), exact, 1e-11 * exact, &format!("y = {a} x² to {b}"));
    }
}

#[test]
fn straight_cubics_are_as_long_as_they_run() {
    let along = DVec2::from_angle(1.1);
    let straight = |s: [f64; 4]| Cubic::new(along * s[0], along * s[1], along * s[2], along * s[3]);
    near(straight([0.0, 1.0, 2.0, 3.0]).length(), 3.0, 1e-12, "even");
    near(straight([0.0, 0.0, 0.0, 3.0]).length(), 3.0, 1e-12, "standing at the start");
    // 3 s (1−s)² · 2: out to s = 1/3 and back, 2 · 6 · 4/27.
    near(straight([0.0, 2.0, 0.0, 0.0]).length(), 16.0 / 9.0, 1e-9, "there and back");
    near(straight([5.0, 5.0, 5.0, 5.0]).length(), 0.0, 0.0, "standing still");
}

#[test]
fn random_lengths_agree_with_the_quadrature() {
    let mut random = Random::new(31);
    for case in 0..60 {
        let cubic = shapes::cubic(&mut random, 20.0);
        let plain = Plain::of_cubic(&cubic);
        // Near a cusp the speed has a near-kink inside a panel: many panels, or it is missed.
        near(cubic.length(), quadrature(&plain, 256), 2e-9, &format!("case {case}: {cubic:?}"));
    }
}

#[test]
fn a_cusp_keeps_the_length_of_both_its_branches() {
    // (t², t³): a semicubical parabola, whose length to t is ((4 + 9 t²)^(3/2) − 8) / 27.
    let branch = |t: f64| ((4.0 + 9.0 * t * t).powf(1.5) - 8.0) / 27.0;
    // Control points of (t², t³) over [−1, 2] from its blossom.
    let at = |a: f64, b: f64, c: f64| p((a * b + a * c + b * c) / 3.0, a * b * c);
    let (a, b) = (-1.0, 2.0);
    let cubic = Cubic::new(at(a, a, a), at(a, a, b), at(a, b, b), at(b, b, b));
    near(cubic.length(), branch(1.0) + branch(2.0), 1e-10, "both branches");
}

#[test]
fn a_spline_is_as_long_as_its_spans() {
    let mut random = Random::new(32);
    for case in 0..15 {
        let spline = shapes::spline(&mut random, 20.0);
        let spans: f64 = spline.pieces().iter().map(|c| quadrature(&Plain::of_cubic(c), 256)).sum();
        near(spline.length(), spans, 1e-7, &format!("case {case}"));
    }
}
