//! Nearest points against dense sampling.

use g41::geometry::{Curve, Nearest};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::shapes;
use crate::common::oracle::Plain;
use crate::common::random::Random;
use crate::common::{near, near_point, p};

/// Asserts that `found` is a point of the curve and that none is nearer or it would be found.
#[track_caller]
fn judge(found: Nearest, on_curve: DVec2, pieces: &[Plain], point: DVec2, what: &str) {
    near_point(found.point, on_curve, 1e-9, what);
    near(found.distance, found.point.distance(point), 1e-12, what);
    let least = pieces.iter().map(|p| p.distance(point, 400)).fold(f64::INFINITY, f64::min);
    // Golden sections find the distance to half the digits of the parameter, so to all of their own.
    near(found.distance, least, 1e-9, what);
}

#[test]
fn no_point_of_a_curve_is_nearer_than_the_nearest() {
    let mut random = Random::new(51);
    for case in 0..400 {
        let point = random.point(60.0);
        let line = shapes::line(&mut random, 50.0);
        let arc = shapes::arc(&mut random, 20.0);
        let spline = shapes::spline(&mut random, 40.0);
        for (curve, pieces) in [
            (Curve::Line(line), vec![Plain::of_line(&line)]),
            (Curve::Arc(arc), vec![Plain::of_arc(&arc)]),
            (Curve::Spline(spline.clone()), spline.pieces().iter().map(Plain::of_cubic).collect()),
        ] {
            let found = curve.nearest(point);
            let what = format!("case {case}: {point} and {curve:?}");
            judge(found, curve.point(found.t), &pieces, point, &what);
        }
        let cubic = shapes::cubic(&mut random, 40.0);
        let found = cubic.nearest(point);
        let plain = Plain::of_cubic(&cubic);
        judge(found, plain.point(found.t), &[plain], point, &format!("case {case}: {cubic:?}"));
    }
}

#[test]
fn a_point_on_the_curve_is_its_own_nearest() {
    let mut random = Random::new(52);
    for case in 0..400 {
        let t = if case % 10 == 0 { f64::from(case / 10 % 2) } else { random.unit() };
        let cubic = shapes::cubic(&mut random, 40.0);
        let on = Plain::of_cubic(&cubic).point(t);
        near(cubic.nearest(on).distance, 0.0, 1e-9, &format!("case {case}: t {t} of {cubic:?}"));
        let arc = shapes::arc(&mut random, 40.0);
        let on = Plain::of_arc(&arc).point(t);
        near(arc.nearest(on).distance, 0.0, 1e-12, &format!("case {case}: t {t} of {arc:?}"));
    }
}

#[test]
fn the_centre_of_an_arc_is_its_radius_away() {
    let mut random = Random::new(53);
    for case in 0..50 {
        let arc = shapes::arc(&mut random, 20.0);
        near(arc.nearest(arc.center()).distance, arc.radius(), 1e-12, &format!("case {case}"));
        let found = arc.nearest(arc.center() + p(1e-13, 0.0));
        near(found.distance, arc.radius(), 1e-12, &format!("case {case}, beside the centre"));
    }
}
