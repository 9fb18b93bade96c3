//! The proved bounds of the offset of splines, held against sampling.

use std::f64::consts::TAU;

use g41::compensation::{ProvedPiece, proved_offset};
use g41::contour::MoveCurve;
use g41::geometry::{Cubic, Parameter, Spline, SplineEnds, perp};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common::p;
use crate::common::random::Random;

/// Samples of all pieces of one offset together.
const SAMPLES: usize = if cfg!(target_arch = "wasm32") { 5_000 } else { 100_000 };

const TOLERANCES: [f64; 9] = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];

/// The point of the offset at `t`.
fn beside(curve: &Cubic, offset: f64, t: f64) -> DVec2 {
    curve.point(t) + perp(curve.tangent(t)) * offset
}

/// Distance of `point` from the offset of `curve` over `range`: the least that Newton's method and
/// golden-section search find from the parameter `t`.
fn distance(curve: &Cubic, offset: f64, range: [f64; 2], point: DVec2, t: f64) -> f64 {
    let at = |u: f64| point.distance(beside(curve, offset, u));
    let mut foot = t;
    for _ in 0..6 {
        let (first, away) = (curve.derivative(foot), point - curve.point(foot));
        let slope = away.dot(curve.second_derivative(foot)) - first.length_squared();
        foot = (foot - away.dot(first) / slope).clamp(range[0], range[1]);
    }
    let reach = 0.05 * (range[1] - range[0]);
    let (mut from, mut to) = ((t - reach).max(range[0]), (t + reach).min(range[1]));
    let mut least = at(foot).min(at(t));
    for _ in 0..30 {
        let (left, right) = (from + 0.4 * (to - from), from + 0.6 * (to - from));
        let values = (at(left), at(right));
        least = least.min(values.0).min(values.1);
        if values.0 < values.1 { to = right } else { from = left }
    }
    if least.is_nan() { at(t) } else { least }
}

/// Largest distance of the samples of a piece from the offset [mm].
fn measured(spline: &Spline, offset: f64, piece: &ProvedPiece, samples: usize) -> f64 {
    let curve = &spline.pieces()[piece.span];
    (0..=samples).fold(0.0, |most: f64, k| {
        let s = k as f64 / samples as f64;
        let t = piece.from + (piece.to - piece.from) * s;
        let point = piece.curve.point(s);
        most.max(distance(curve, offset, [piece.from, piece.to], point, t))
    })
}

/// The share of the coordinates that double precision leaves the samples themselves.
fn noise(spline: &Spline, offset: f64) -> f64 {
    let reach = spline.points().iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    4e-15 * (reach + offset.abs())
}

/// Checks every piece, and gives the ratios of bound and measured error.
fn ratios(spline: &Spline, offset: f64, tolerance: f64) -> Vec<f64> {
    let pieces = proved_offset(spline, offset, tolerance);
    let noise = noise(spline, offset);
    let samples = (SAMPLES / pieces.len()).clamp(20, 400);
    let mut at: Option<DVec2> = None;
    let mut ratios = Vec::new();
    for piece in &pieces {
        let what = || format!("{piece:?} of {:?} at {offset}", spline.pieces()[piece.span]);
        if let Some(at) = at {
            assert!(at.distance(piece.curve.start()) <= noise.max(2e-9), "no gap, {}", what());
        }
        at = Some(piece.curve.end());
        if !matches!(piece.curve, MoveCurve::Cubic(_)) {
            continue;
        }
        // Short parts of the curve turn by the rounding of their control points.
        assert!(piece.bound <= tolerance + 1e4 * noise, "within {tolerance}: {}", what());
        let error = measured(spline, offset, piece, samples);
        assert!(error <= piece.bound + noise, "{error} measured, {}", what());
        if error > 1e2 * noise {
            ratios.push(piece.bound / error);
        }
    }
    ratios
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(1.0)
}

/// Waves of 8 mm round a circle, type points about 5 mm apart.
fn wave(n: usize) -> Spline {
    let (waves, middle) = ((n / 20).max(3) as f64, 5.0 * n as f64 / TAU);
    let mut points: Vec<DVec2> = (0..n)
        .map(|i| TAU * i as f64 / n as f64)
        .map(|angle| DVec2::from_angle(angle) * (middle + 8.0 * (waves * angle).sin()))
        .collect();
    points.push(points[0]);
    Spline::through(points, SplineEnds::Periodic, Parameter::Chord).expect("a wave")
}

#[test]
fn bounds_of_a_wave_hold_and_are_at_most_twice_the_error() {
    let spline = wave(60);
    for tolerance in TOLERANCES {
        for offset in [5.0, -5.0, 60.0, -60.0] {
            let median = median(ratios(&spline, offset, tolerance));
            assert!(median <= 2.0, "median {median} at {tolerance}, {offset}");
        }
    }
}

#[test]
fn bounds_of_random_splines_hold_at_any_radius() {
    let cases = if cfg!(target_arch = "wasm32") { 20 } else { 200 };
    let mut all = Vec::new();
    for case in 0..cases {
        let mut random = Random::new(0x9e37 + case);
        let points: Vec<DVec2> =
            (0..6).map(|_| p(random.within(-20.0, 20.0), random.within(-20.0, 20.0))).collect();
        let Ok(spline) = Spline::through(points, SplineEnds::NATURAL, Parameter::Chord) else {
            continue;
        };
        let tolerance = 10_f64.powf(random.within(-9.0, -1.0));
        let offset = 10_f64.powf(random.within(-4.0, 4.0));
        let offset = if random.coin() { offset } else { -offset };
        all.extend(ratios(&spline, offset, tolerance));
    }
    let median = median(all);
    assert!(median <= 2.0, "median {median}");
}
