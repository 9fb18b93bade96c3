//! Splines through type points: closed forms, continuity, convergence, reversing and cutting.

use std::f64::consts::{FRAC_PI_2, TAU};

use g41::geometry::{CurveError, EndCondition, Parameter, Spline, SplineEnds};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::shapes;
use crate::common::oracle::Plain;
use crate::common::random::Random;
use crate::common::{near, near_point, p};

fn tangents(start: DVec2, end: DVec2) -> SplineEnds {
    SplineEnds::Open { start: EndCondition::Tangent(start), end: EndCondition::Tangent(end) }
}

fn chord_spline(points: Vec<DVec2>, ends: SplineEnds) -> Spline {
    Spline::through(points, ends, Parameter::Chord).expect("valid type points")
}

/// First and second derivative by the spline's own parameter at both ends of a span.
fn end_derivatives(spline: &Spline, span: usize, h: f64) -> [(DVec2, DVec2); 2] {
    let [a, b, c, d] = spline.pieces()[span].points;
    [
        ((b - a) * 3.0 / h, (a - b * 2.0 + c) * 6.0 / (h * h)),
        ((d - c) * 3.0 / h, (b - c * 2.0 + d) * 6.0 / (h * h)),
    ]
}

#[test]
fn every_spline_passes_its_points_with_two_continuous_derivatives() {
    let mut random = Random::new(11);
    for case in 0..300 {
        let spline = shapes::spline(&mut random, 40.0);
        let points = spline.points();
        let interval = |i: usize| {
            let chord = points[i].distance(points[i + 1]);
            if spline.parameter() == Parameter::Chord { chord } else { chord.sqrt() }
        };
        let spans = spline.pieces().len();
        assert_eq!(spans, points.len() - 1, "case {case}: spans");
        for i in 0..spans {
            near_point(spline.pieces()[i].points[0], points[i], 0.0, "start of a span");
            near_point(spline.pieces()[i].points[3], points[i + 1], 0.0, "end of a span");
            if i + 1 == spans && !spline.is_periodic() {
                continue;
            }
            let next = (i + 1) % spans;
            let [_, (d0, dd0)] = end_derivatives(&spline, i, interval(i));
            let [(d1, dd1), _] = end_derivatives(&spline, next, interval(next));
            let scale = dd0.length().max(d0.length() / interval(i)).max(1.0);
            near_point(d0, d1, 1e-11 * scale * interval(i), &format!("case {case}: C1 at {i}"));
            near_point(dd0, dd1, 1e-9 * scale, &format!("case {case}: C2 at {i}"));
        }
        if let SplineEnds::Open { start, end } = spline.ends() {
            let [(d0, dd0), _] = end_derivatives(&spline, 0, interval(0));
            let [_, (d1, dd1)] = end_derivatives(&spline, spans - 1, interval(spans - 1));
            for (condition, d, dd) in [(start, d0, dd0), (end, d1, dd1)] {
                match condition {
                    EndCondition::NotAKnot => panic!("none is made here"),
                    EndCondition::Natural => near(dd.length(), 0.0, 1e-9 * (1.0 + d.length()), "M"),
                    EndCondition::Tangent(t) => {
                        near_point(d.normalize(), t.normalize(), 1e-10, "end tangent");
                    }
                }
            }
        }
    }
}

#[test]
fn natural_splines_solvable_by_hand_take_the_solved_values() {
    // Even chords: 3 points solve to y = (3 s − s³) / 2 on the first span.
    let hat = chord_spline(vec![p(0.0, 0.0), p(1.0, 1.0), p(2.0, 0.0)], SplineEnds::NATURAL);
    near_point(hat.point(0.25), p(0.5, 0.6875), 1e-15, "hat");
    near_point(hat.point(0.75), p(1.5, 0.6875), 1e-15, "hat");
    near_point(hat.tangent(0.5), p(1.0, 0.0), 1e-15, "top of the hat");
    // Zigzag 0 1 0 1: 4 M1 + M2 = −12 and M1 + 4 M2 = 12 give M = ∓4; the middle of a span is the
    // mean of its ends less (M + M') / 16.
    let points = vec![p(0.0, 0.0), p(1.0, 1.0), p(2.0, 0.0), p(3.0, 1.0)];
    let zigzag = chord_spline(points, SplineEnds::NATURAL);
    for (t, y) in [(1.0 / 6.0, 0.75), (0.5, 0.5), (5.0 / 6.0, 0.25)] {
        near_point(zigzag.point(t), p(3.0 * t, y), 1e-15, "zigzag");
    }
}

#[test]
fn points_on_a_line_give_the_line_at_constant_speed() {
    let along = DVec2::from_angle(0.7);
    let at = [0.0, 0.01, 3.0, 3.5, 60.0, 61.0, 100.0];
    let points: Vec<DVec2> = at.iter().map(|s| p(5.0, -2.0) + along * *s).collect();
    for ends in [SplineEnds::NATURAL, tangents(along * 3.0, along)] {
        for parameter in [Parameter::Chord, Parameter::Centripetal] {
            let spline = Spline::through(points.clone(), ends, parameter).expect("valid");
            near(spline.length(), 100.0, 1e-9, "length");
            for i in 0..=100 {
                let t = f64::from(i) / 100.0;
                let off = (spline.point(t) - points[0]).perp_dot(along);
                near(off, 0.0, 1e-13, "distance from the line");
                if parameter == Parameter::Chord {
                    near_point(spline.derivative(t), along * 100.0, 1e-10, "speed");
                }
            }
        }
    }
}

#[test]
fn a_clamped_spline_reproduces_a_cubic_whose_parameter_is_its_chord() {
    // (a u + b u³, c u²) at u = −1, 0, 1: its chords are 1 where (a + b)² + c² = 1, and its speed
    // at the ends is 1, as the clamped end has it, where (a + 3b)² + 4c² = 1.
    for c in [0.1_f64, 0.3, -0.45] {
        let (sum, end) = ((1.0 - c * c).sqrt(), (1.0 - 4.0 * c * c).sqrt());
        let b = 0.5 * (end - sum);
        let a = sum - b;
        let cubic = |u: f64| p(a * u + b * u * u * u, c * u * u);
        let tangent = |u: f64| p(a + 3.0 * b * u * u, 2.0 * c * u);
        let points = vec![cubic(-1.0), cubic(0.0), cubic(1.0)];
        let spline = chord_spline(points, tangents(tangent(-1.0) * 5.0, tangent(1.0)));
        for i in 0..=40 {
            let t = f64::from(i) / 40.0;
            let u = 2.0 * t - 1.0;
            near_point(spline.point(t), cubic(u), 1e-15, "point");
            near_point(spline.derivative(t), tangent(u) * 2.0, 1e-14, "derivative");
            let second = p(6.0 * b * u, 2.0 * c) * 4.0;
            near_point(spline.second_derivative(t), second, 1e-13, "second derivative");
            let curvature = tangent(u).perp_dot(p(6.0 * b * u, 2.0 * c));
            near(spline.curvature(t), curvature / tangent(u).length().powi(3), 1e-13, "curvature");
        }
    }
}

fn polygon(count: usize, radius: f64) -> Vec<DVec2> {
    let corner = |i: usize| DVec2::from_angle(TAU * (i % count) as f64 / count as f64) * radius;
    (0..=count).map(corner).collect()
}

#[test]
fn a_periodic_spline_on_a_regular_polygon_has_its_symmetry_and_its_closed_form() {
    for count in [3, 4, 5, 8, 12, 64] {
        let spline = chord_spline(polygon(count, 10.0), SplineEnds::Periodic);
        let step = TAU / count as f64;
        // The cyclic system has the eigenvector e^(ikθ): h² M = −6 (2 − 2 cos θ) / (4 + 2 cos θ) P.
        let moment = 6.0 * (2.0 - 2.0 * step.cos()) / (4.0 + 2.0 * step.cos());
        let middle = 10.0 * (0.5 * step).cos() * (1.0 + moment / 8.0);
        for i in 0..count {
            let t = (i as f64 + 0.5) / count as f64;
            let angle = (i as f64 + 0.5) * step;
            near_point(spline.point(t), DVec2::from_angle(angle) * middle, 1e-12, "mid-span");
            let turned =
                DVec2::from_angle(i as f64 * step).rotate(spline.point(0.3 / count as f64));
            near_point(spline.point((i as f64 + 0.3) / count as f64), turned, 1e-12, "symmetry");
        }
        near_point(spline.tangent(0.0), DVec2::Y, 1e-12, "tangent at the joint");
        near_point(spline.tangent(1.0), DVec2::Y, 1e-12, "tangent at the joint");
    }
}

/// Largest distance of the spline from the circle of radius 1 about the origin.
fn off_the_circle(spline: &Spline) -> f64 {
    let off = |i: u32| (spline.point(f64::from(i) / 4096.0).length() - 1.0).abs();
    (0..=4096).map(off).fold(0.0, f64::max)
}

#[test]
fn the_error_on_a_circle_falls_with_the_fourth_power_of_the_spacing() {
    let mut closed = Vec::new();
    let mut clamped = Vec::new();
    for count in [8, 16, 32, 64] {
        closed.push(off_the_circle(&chord_spline(polygon(count, 1.0), SplineEnds::Periodic)));
        let quarter = (0..=count)
            .map(|i| DVec2::from_angle(FRAC_PI_2 * i as f64 / count as f64))
            .collect::<Vec<_>>();
        clamped.push(off_the_circle(&chord_spline(quarter, tangents(DVec2::Y, DVec2::NEG_X))));
    }
    for errors in [closed, clamped] {
        for pair in errors.windows(2) {
            let ratio = pair[0] / pair[1];
            assert!((14.0..18.0).contains(&ratio), "{errors:?} does not fall 16-fold");
        }
    }
}

#[test]
fn reversing_keeps_every_point() {
    let mut random = Random::new(12);
    for case in 0..100 {
        let spline = shapes::spline(&mut random, 40.0);
        let back = spline.reversed();
        for i in 0..=50 {
            let t = f64::from(i) / 50.0;
            near_point(back.point(1.0 - t), spline.point(t), 1e-11, &format!("case {case}"));
            near_point(back.tangent(1.0 - t), -spline.tangent(t), 1e-7, &format!("case {case}"));
        }
        // Made anew from the reversed type points it is the same curve.
        let again = Spline::through(back.points().to_vec(), back.ends(), back.parameter())
            .expect("valid type points");
        for (a, b) in back.pieces().iter().zip(again.pieces()) {
            for (a, b) in a.points.iter().zip(b.points) {
                near_point(*a, b, 1e-8, &format!("case {case}: made anew"));
            }
        }
    }
}

#[test]
fn splitting_keeps_every_point_and_the_curvature_at_the_cut() {
    let mut random = Random::new(13);
    for case in 0..200 {
        let spline = shapes::spline(&mut random, 40.0);
        let spans = spline.pieces().len();
        let at_type_point = case % 4 == 0 && spans > 1;
        let cut = if at_type_point {
            spline.parameter_at(1 + random.index(spans - 1), 0.0)
        } else {
            random.within(0.01, 0.99)
        };
        let (first, second) = spline.split(cut).expect("both parts have a length");
        let extra = usize::from(!at_type_point);
        let parts = first.pieces().len() + second.pieces().len();
        assert_eq!(parts, spans + extra, "case {case}: spans after the cut");
        near_point(first.end(), second.start(), 0.0, "the cut");
        for (part, from, to) in [(&first, 0.0, cut), (&second, cut, 1.0)] {
            assert_eq!(part.points().len(), part.pieces().len() + 1, "case {case}");
            for i in 0..=40 {
                let t = f64::from(i) / 40.0;
                let whole = spline.point(from + (to - from) * t);
                near_point(part.point(t), whole, 1e-10, &format!("case {case} at {t}"));
            }
        }
    }
}

#[test]
fn knots_are_spaced_by_the_chord_or_its_root() {
    let points = vec![p(0.0, 0.0), p(1.0, 0.0), p(1.0, 4.0), p(10.0, 4.0)];
    for (parameter, knots) in
        [(Parameter::Chord, [0.0, 1.0, 5.0, 14.0]), (Parameter::Centripetal, [0.0, 1.0, 3.0, 6.0])]
    {
        let spline =
            Spline::through(points.clone(), SplineEnds::NATURAL, parameter).expect("valid");
        for (point, knot) in points.iter().zip(knots) {
            near_point(spline.point(knot / knots[3]), *point, 1e-14, "type point at its knot");
        }
        for span in 0..3 {
            let t = spline.parameter_at(span, 0.25);
            near(t, (knots[span] + 0.25 * (knots[span + 1] - knots[span])) / knots[3], 1e-15, "t");
            let on_piece = Plain::of_cubic(&spline.pieces()[span]).point(0.25);
            near_point(spline.point(t), on_piece, 1e-14, "a quarter into a span");
        }
    }
}

#[test]
fn what_cannot_be_a_spline_is_refused() {
    let natural = SplineEnds::NATURAL;
    let through = |points: &[DVec2], ends| Spline::through(points.to_vec(), ends, Parameter::Chord);
    let (a, b, c) = (p(0.0, 0.0), p(1.0, 0.0), p(2.0, 1.0));
    assert_eq!(
        through(&[a, b], natural).expect_err("two points"),
        CurveError::TooFewPoints { count: 2, least: 3 },
        "two points"
    );
    assert_eq!(
        through(&[a, b, a], SplineEnds::Periodic).expect_err("three points"),
        CurveError::TooFewPoints { count: 3, least: 4 },
        "two points and back"
    );
    assert_eq!(
        through(&[a, b, b, c], natural).expect_err("a repeated point"),
        CurveError::CoincidentPoints { index: 2 },
        "a repeated point"
    );
    assert_eq!(
        through(&[a, b, c, p(0.0, 1.0)], SplineEnds::Periodic).expect_err("open"),
        CurveError::NotClosed,
        "an open periodic one"
    );
    for bad in [f64::NAN, f64::NEG_INFINITY, -2e9] {
        let made = through(&[a, p(0.0, bad), c], natural);
        assert!(matches!(made, Err(CurveError::OutOfRange { .. })), "{made:?}");
    }
    assert!(through(&[a, c], tangents(DVec2::X, DVec2::Y)).is_ok(), "two points with tangents");
}
