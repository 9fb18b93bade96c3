//! Exact offsets of splines against the equidistant itself, where the tool fits and where it does
//! not.

use g41::compensation::Options;
use g41::contour::{Shape, Side, SplineShape};
use g41::geometry::{Curve, Parameter};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::judge::{field_of_path, in_one_piece};
use super::sketch::Sketch;
use crate::common::oracle::{Field, Plain};
use crate::common::random::Random;

const CASES: u32 = if cfg!(target_arch = "wasm32") { 40 } else { 400 };

/// The equidistant of the one spline of a contour.
fn parallel(sketch: &Sketch, offset: f64) -> Vec<Plain> {
    let contour = sketch.contour();
    let Curve::Spline(spline) = &contour.segments()[0].curve else { panic!("{sketch:?}") };
    spline.pieces().iter().map(|piece| Plain::Parallel(piece.points, offset)).collect()
}

/// A spline that wanders with turns of up to `bend` rad at its type points.
fn wander(random: &mut Random, bend: f64) -> Sketch {
    let (start, mut way) = (random.point(50.0), random.within(0.0, 6.0));
    let (mut points, mut at) = (Vec::new(), start);
    for _ in 0..2 + random.index(9) {
        way += random.within(-bend, bend);
        at += DVec2::from_angle(way) * random.within(2.0, 15.0);
        points.push(at);
    }
    let parameter = if random.coin() { Parameter::Chord } else { Parameter::Centripetal };
    Sketch::open(
        start,
        [Shape::Spline(SplineShape { points, parameter, ..SplineShape::default() })],
    )
}

/// Asserts that path and equidistant are within `tolerance` of each other, both ways.
#[track_caller]
fn judge(sketch: &Sketch, side: Side, radius: f64, tolerance: f64) {
    let what = format!("{side:?}, r {radius}, {tolerance}: {sketch:?}");
    let options = Options { tolerance, ..Options::default() };
    let path = sketch.compensated(side, radius, &options);
    in_one_piece(&path, &what);
    let truth = parallel(sketch, side.sign() * radius);
    let on_truth = Field::new(truth.iter().map(|piece| (*piece, piece.samples())));
    for one in &path.moves {
        for k in 0..=10 {
            let point = one.curve.point(f64::from(k) / 10.0);
            let off = on_truth.distance(point);
            assert!(off <= tolerance, "{point} of the path is {off:e} off; {what}");
        }
    }
    let on_path = field_of_path(&path);
    for piece in &truth {
        for point in piece.sampled(40) {
            let off = on_path.distance(point);
            assert!(off <= tolerance, "{point} of the equidistant is {off:e} off; {what}");
        }
    }
}

#[test]
fn the_path_of_a_gentle_spline_is_its_equidistant_at_every_tolerance() {
    let mut random = Random::new(501);
    for _ in 0..CASES {
        let sketch = wander(&mut random, 0.4);
        let side = if random.coin() { Side::Left } else { Side::Right };
        let radius = random.within(0.01, 5.0);
        let tolerance = 10.0_f64.powi(-1 - i32::try_from(random.index(7)).expect("small"));
        judge(&sketch, side, radius, tolerance);
    }
}

#[test]
fn the_path_of_a_tight_spline_is_its_equidistant_with_all_its_cusps() {
    let mut random = Random::new(502);
    for _ in 0..CASES {
        let sketch = wander(&mut random, 1.6);
        let side = if random.coin() { Side::Left } else { Side::Right };
        let radius = random.within(0.5, 40.0);
        let tolerance = [0.1, 0.01, 0.001, 1e-4][random.index(4)];
        judge(&sketch, side, radius, tolerance);
    }
}

#[test]
fn a_finer_tolerance_takes_more_pieces_by_a_small_power() {
    // Sixth order: ten times finer takes 10^(1/6) = 1.47 times the pieces.
    let mut random = Random::new(503);
    let mut pieces = [0_usize; 6];
    for _ in 0..50 {
        let sketch = wander(&mut random, 0.5);
        for (exponent, count) in (3..).zip(&mut pieces) {
            let options = Options { tolerance: 10.0_f64.powi(-exponent), ..Options::default() };
            *count += sketch.compensated(Side::Left, 2.0, &options).moves.len();
        }
    }
    let growth = (pieces[5] as f64 / pieces[2] as f64).powf(1.0 / 3.0);
    assert!((1.2..2.0).contains(&growth), "{pieces:?} grow by {growth} a digit");
}
