//! Arcs: both senses, full circles, the two arcs of a radius, programs that round.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use g41::geometry::{Arc, CurveError, RadiusForm};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::shapes;
use crate::common::oracle::Plain;
use crate::common::random::Random;
use crate::common::{near, near_point, p};

#[test]
fn quarter_and_three_quarter_circles_follow_sine_and_cosine() {
    let (start, end, center) = (p(7.0, 3.0), p(5.0, 5.0), p(5.0, 3.0));
    for (clockwise, sweep) in [(false, FRAC_PI_2), (true, -1.5 * PI)] {
        let arc = Arc::from_center(start, end, center, clockwise, 1e-9).expect("a valid arc");
        near(arc.sweep(), sweep, 1e-15, "sweep");
        near(arc.length(), 2.0 * sweep.abs(), 1e-14, "length");
        near(arc.curvature(), 0.5 * sweep.signum(), 1e-15, "curvature");
        assert_eq!(arc.is_clockwise(), clockwise, "sense of {arc:?}");
        for i in 0..=8 {
            let t = f64::from(i) / 8.0;
            let (sin, cos) = (t * sweep).sin_cos();
            near_point(arc.point(t), p(5.0 + 2.0 * cos, 3.0 + 2.0 * sin), 1e-14, "point");
            near_point(arc.tangent(t), p(-sin, cos) * sweep.signum(), 1e-14, "tangent");
        }
    }
}

#[test]
fn an_arc_that_ends_at_its_start_is_a_full_circle() {
    for clockwise in [false, true] {
        let at = p(-1.0, 4.0);
        let arc = Arc::from_center(at, at, p(2.0, 0.0), clockwise, 0.01).expect("a valid circle");
        assert!(arc.is_full_circle(), "{arc:?} is not full");
        near(arc.length(), TAU * 5.0, 1e-13, "circumference");
        near_point(arc.point(0.5), p(5.0, -4.0), 1e-14, "opposite point");
        assert_eq!((arc.start(), arc.end()), (at, at), "ends");
        let by_radius = Arc::from_radius(at, at, 5.0, RadiusForm::Major, clockwise, 0.01);
        assert_eq!(by_radius, Err(CurveError::FullCircleByRadius), "a circle by its radius");
    }
}

#[test]
fn a_radius_gives_a_short_and_a_long_arc_of_either_sense() {
    let mut random = Random::new(1);
    for case in 0..500 {
        let (start, end) = (random.point(50.0), random.point(50.0));
        let radius = 0.5 * start.distance(end) * random.within(1.001, 20.0);
        for (form, clockwise) in [
            (RadiusForm::Minor, false),
            (RadiusForm::Minor, true),
            (RadiusForm::Major, false),
            (RadiusForm::Major, true),
        ] {
            let arc = Arc::from_radius(start, end, radius, form, clockwise, 0.0)
                .unwrap_or_else(|e| panic!("case {case}: {e}"));
            let slack = 1e-9 * radius;
            near(arc.center().distance(start), radius, slack, "radius at the start");
            near(arc.center().distance(end), radius, slack, "radius at the end");
            assert_eq!(arc.sweep() < 0.0, clockwise, "case {case}: sense of {arc:?}");
            let long = form == RadiusForm::Major;
            assert_eq!(arc.sweep().abs() > PI, long, "case {case}: length of {arc:?}");
            // The sweep must lead from the start to the end.
            near_point(Plain::of_arc(&arc).point(1.0), end, slack, "end of the sweep");
        }
    }
}

#[test]
fn a_radius_rounded_below_half_the_chord_is_a_half_circle() {
    let (start, end) = (p(0.0, 0.0), p(20.0, 0.0));
    for (clockwise, top) in [(false, p(10.0, -10.0)), (true, p(10.0, 10.0))] {
        let arc = Arc::from_radius(start, end, 9.995, RadiusForm::Minor, clockwise, 0.01)
            .expect("within the tolerance");
        near_point(arc.center(), p(10.0, 0.0), 1e-12, "centre");
        near_point(arc.point(0.5), top, 1e-12, "middle");
    }
    let refused = Arc::from_radius(start, end, 9.98, RadiusForm::Minor, true, 0.01);
    assert!(matches!(refused, Err(CurveError::RadiusTooSmall { .. })), "{refused:?}");
}

#[test]
fn tiny_and_nearly_full_sweeps_keep_their_length() {
    for sweep in [1e-9, 1e-7, 1e-5, 1e-3, 3.0, TAU - 1e-3, TAU - 1e-5, TAU - 1e-7] {
        for sign in [1.0, -1.0] {
            let (center, radius) = (p(3.0, -2.0), 1000.0);
            let made = Arc::from_sweep(center + p(radius, 0.0), center, sign * sweep)
                .expect("longer than nothing");
            let arc = Arc::from_center(made.start(), made.end(), center, sign < 0.0, 1e-6)
                .expect("a valid arc");
            // Ends are rounded to about 1e-13 of 1000 mm.
            near(arc.sweep(), sign * sweep, 1e-15 + 1e-12 / radius, "sweep");
            near(arc.length(), radius * sweep, 1e-9, "length");
        }
    }
}

#[test]
fn a_rounded_centre_moves_to_the_nearest_place_equally_far_from_both_ends() {
    let mut random = Random::new(2);
    for case in 0..300 {
        let exact = shapes::arc(&mut random, 100.0);
        if exact.is_full_circle() || exact.start().distance(exact.end()) < 0.1 {
            continue;
        }
        let given = exact.center() + random.point(0.002);
        let (start, end) = (exact.start(), exact.end());
        let arc = Arc::from_center(start, end, given, exact.is_clockwise(), 0.01)
            .unwrap_or_else(|e| panic!("case {case}: {e}"));
        let center = arc.center();
        let radii = (given.distance(start), given.distance(end));
        let apart = (radii.0 - radii.1).abs();
        near(center.distance(arc.start()), center.distance(arc.end()), 1e-10, "radii");
        if arc.sweep().abs() > PI && arc.end() != end {
            near_point(center, given, 0.0, "where the end moves, the centre stays");
            assert!(arc.end().distance(end) < apart + 1e-10, "case {case}: {arc:?} ends at {end}");
            continue;
        }
        if arc.sweep().abs() > PI {
            assert!(
                center.distance(given) < apart + 1e-10,
                "case {case}: {given} moves to {center}"
            );
        }
        // Nearest: the way from the given centre is along the chord.
        near((center - given).perp_dot((end - start).normalize()), 0.0, 1e-10, "way of the centre");
        near(arc.radius(), center.distance(start), 1e-10, "radius");
    }
    let refused = Arc::from_center(p(0.0, 0.0), p(10.0, 0.0), p(5.1, 0.0), false, 0.01);
    assert!(matches!(refused, Err(CurveError::RadiiDisagree { .. })), "{refused:?}");
}

#[test]
fn a_nearly_full_circle_stays_in_its_place_though_its_radii_differ() {
    // A circle of 1 m, written with ends rounded to a micrometre: 0.02 mm apart, or one on the
    // other's radius.
    let (center, start) = (p(0.0, 0.0), p(1000.0, 0.0));
    for end in [[1000.001, -0.02], [999.999, -0.02], [1000.001, 0.0], [999.999, 0.0]] {
        let arc = Arc::from_center(start, end.into(), center, false, 0.01).expect("an arc");
        let half = arc.point(0.5);
        assert!(half.distance(p(-1000.0, 0.0)) < 0.02, "{arc:?}: {half} is half round");
        assert!(arc.end().distance(end.into()) < 0.0011, "{arc:?} ends at {end:?}");
    }
}

#[test]
fn reversing_and_splitting_keep_every_point() {
    let mut random = Random::new(3);
    for case in 0..200 {
        let arc = shapes::arc(&mut random, 30.0);
        let plain = Plain::of_arc(&arc);
        let back = arc.reversed();
        let cut = random.within(0.05, 0.95);
        let (first, second) = arc.split(cut).expect("both parts have a length");
        near_point(first.end(), second.start(), 0.0, "the cut");
        for i in 0..=20 {
            let t = f64::from(i) / 20.0;
            near_point(arc.point(t), plain.point(t), 1e-12, "point");
            near_point(back.point(t), plain.point(1.0 - t), 1e-12, "reversed");
            near_point(first.point(t), plain.point(cut * t), 1e-12, "first part");
            near_point(second.point(t), plain.point(cut + (1.0 - cut) * t), 1e-12, "second part");
        }
        near(first.length() + second.length(), arc.length(), 1e-11, &format!("case {case}"));
    }
}

#[test]
fn the_parameter_of_a_point_is_where_it_was_taken() {
    let mut random = Random::new(4);
    for case in 0..500 {
        let arc = shapes::arc(&mut random, 30.0);
        let t = random.within(0.001, 0.999);
        let off = arc.center() + (Plain::of_arc(&arc).point(t) - arc.center()) * 1.7;
        near(arc.parameter(off), t, 1e-10, &format!("case {case}: {arc:?}"));
    }
}

#[test]
fn what_cannot_be_an_arc_is_refused() {
    let (a, b, c) = (p(0.0, 0.0), p(2.0, 0.0), p(1.0, 0.0));
    for bad in [f64::NAN, f64::INFINITY, 1e10] {
        let bad = p(bad, 0.0);
        for (start, end, center) in [(bad, b, c), (a, bad, c), (a, b, bad)] {
            let made = Arc::from_center(start, end, center, false, 0.01);
            assert!(matches!(made, Err(CurveError::OutOfRange { .. })), "{made:?}");
        }
    }
    assert_eq!(Arc::from_center(a, b, a, false, 10.0), Err(CurveError::ZeroLength), "on the start");
    assert_eq!(Arc::from_center(a, a, a, false, 0.01), Err(CurveError::ZeroLength), "no radius");
    assert_eq!(Arc::from_sweep(a, c, 0.0), Err(CurveError::ZeroLength), "no sweep");
    assert_eq!(Arc::from_sweep(a, c, f64::NAN), Err(CurveError::ZeroLength), "no number");
    let not_a_radius = Arc::from_radius(a, b, f64::NAN, RadiusForm::Minor, false, 0.01);
    assert!(matches!(not_a_radius, Err(CurveError::RadiusTooSmall { .. })), "{not_a_radius:?}");
}
