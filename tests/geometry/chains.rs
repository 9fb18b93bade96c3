//! Splines of given cubics, and C2 splines whose ends have no knot.

use g41::geometry::{Cubic, CurveError, EndCondition, Parameter, Spline, SplineEnds};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common::{near, near_point, p};

/// Cubics that follow each other, by their control points.
fn cubics(points: &[DVec2]) -> Vec<Cubic> {
    points.windows(4).step_by(3).map(|c| Cubic::new(c[0], c[1], c[2], c[3])).collect()
}

fn wave() -> Vec<Cubic> {
    let points = [
        p(0.0, 0.0),
        p(1.0, 2.0),
        p(3.0, 2.0),
        p(4.0, 0.0),
        p(4.5, -1.0),
        p(6.0, -1.0),
        p(7.0, 1.0),
    ];
    cubics(&points)
}

#[test]
fn smooth_cubics_are_one_spline_as_they_are() {
    let splines = Spline::of_cubics(&wave()).expect("cubics");
    let [spline] = &splines[..] else { panic!("one spline: {splines:?}") };
    assert_eq!(spline.pieces(), wave(), "its cubics");
    assert!(!spline.is_through_points(), "it is given by its cubics");
    assert_eq!(spline.points(), [p(0.0, 0.0), p(4.0, 0.0), p(7.0, 1.0)], "its joints");
    near(spline.length(), wave().iter().map(Cubic::length).sum(), 1e-12, "length");
    // The parameter runs on over the joint, and the tangent with it.
    let joint = spline.parameter_at(1, 0.0);
    near_point(spline.point(joint), p(4.0, 0.0), 1e-12, "the joint");
    near_point(spline.tangent(joint - 1e-9), spline.tangent(joint), 1e-6, "one tangent");
    let reversed = spline.reversed();
    assert!(!reversed.is_through_points(), "it stays what it is");
    for k in 0..=20 {
        let t = f64::from(k) / 20.0;
        near_point(reversed.point(1.0 - t), spline.point(t), 1e-12, "run backwards");
    }
    let (first, second) = spline.split(0.3).expect("a cut inside");
    near_point(first.end(), spline.point(0.3), 1e-15, "cut");
    assert!(!first.is_through_points() && !second.is_through_points(), "so do its parts");
    near(first.length() + second.length(), spline.length(), 1e-11, "both parts");
}

#[test]
fn a_corner_begins_a_new_spline() {
    let mut bent = wave();
    bent[1].points[1] = p(4.5, -1.0 + 1e-6);
    let splines = Spline::of_cubics(&bent).expect("cubics");
    assert_eq!(splines.len(), 2, "a turn of a millionth is a corner");
    near_point(splines[0].end(), splines[1].start(), 0.0, "which both meet in");
    bent[1].points[1] = p(4.5, -1.0 + 1e-12);
    assert_eq!(Spline::of_cubics(&bent).expect("cubics").len(), 1, "rounding is none");
    let square = [
        (p(0.0, 0.0), p(3.0, 0.0)),
        (p(3.0, 0.0), p(3.0, 3.0)),
        (p(3.0, 3.0), p(6.0, 3.0)),
        (p(6.0, 3.0), p(9.0, 3.0)),
    ];
    let lines: Vec<Cubic> =
        square.map(|(a, b)| Cubic::new(a, a.lerp(b, 1.0 / 3.0), a.lerp(b, 2.0 / 3.0), b)).to_vec();
    assert_eq!(Spline::of_cubics(&lines).expect("lines").len(), 3, "two of them are in one line");
}

#[test]
fn cubics_without_length_and_loops_are_no_trouble() {
    let here = Cubic::new(p(4.0, 0.0), p(4.0, 0.0), p(4.0, 0.0), p(4.0, 0.0));
    let with = [wave()[0], here, wave()[1]];
    assert_eq!(Spline::of_cubics(&with).expect("cubics").len(), 1, "a standstill is left out");
    assert_eq!(Spline::of_cubics(&[here]), Err(CurveError::ZeroLength), "nothing is left");
    assert_eq!(Spline::of_cubics(&[]), Err(CurveError::ZeroLength), "nothing was there");
    let drop = Cubic::new(p(0.0, 0.0), p(9.0, 0.0), p(0.0, 9.0), p(0.0, 0.0));
    let splines = Spline::of_cubics(&[drop]).expect("a loop");
    assert_eq!(splines[0].pieces().len(), 2, "a loop has two spans");
    near_point(splines[0].point(0.5), drop.point(0.5), 1e-12, "its far point");
    let far = Cubic::new(p(0.0, 0.0), p(1.0, 0.0), p(2e9, 0.0), p(3.0, 0.0));
    let refused = Spline::of_cubics(&[far]).expect_err("too far");
    assert!(matches!(refused, CurveError::OutOfRange { .. }), "{refused}");
    let gap = [wave()[0], wave()[1].with_start_moved(p(0.0, 1e-3))];
    let splines = Spline::of_cubics(&gap).expect("cubics");
    near_point(splines[1].start(), splines[0].end(), 0.0, "a gap is closed");
}

/// A cubic polynomial curve by x itself.
fn polynomial(x: f64) -> DVec2 {
    p(x, 0.02 * x * x * x - 0.3 * x * x + 0.5 * x + 2.0)
}

#[test]
fn without_knots_at_its_ends_a_spline_gives_a_cubic_back() {
    // Chords are not equally long, so the parameter is x only along the x axis: a curve of which
    // each coordinate is a cubic of the chord length is a straight line run at any speed, or one
    // whose points are equally far apart. Here both are tried.
    let free = SplineEnds::Open { start: EndCondition::NotAKnot, end: EndCondition::NotAKnot };
    let line: Vec<DVec2> = [0.0, 1.0, 2.5, 3.0, 7.0].map(|x| p(x, 2.0 * x)).to_vec();
    let spline = Spline::through(line, free, Parameter::Chord).expect("a spline");
    for k in 0..=20 {
        let point = spline.point(f64::from(k) / 20.0);
        near(point.y, 2.0 * point.x, 1e-13, "on the line");
    }
    // Third derivatives by the parameter agree over the first and the last inner joint.
    let points: Vec<DVec2> = [0.0, 2.0, 5.0, 6.0, 9.0, 11.0].map(polynomial).to_vec();
    let spline = Spline::through(points.clone(), free, Parameter::Chord).expect("a spline");
    let third = |span: usize| {
        let [a, b, c, d] = spline.pieces()[span].points;
        let h = points[span].distance(points[span + 1]);
        (d - c * 3.0 + b * 3.0 - a) * (6.0 / (h * h * h))
    };
    near_point(third(0), third(1), 1e-12, "at the start");
    near_point(third(3), third(4), 1e-12, "at the end");
    assert!(third(1).distance(third(2)) > 1e-4, "but not in between");
    for (i, &point) in points.iter().enumerate().skip(1).take(4) {
        let [before, behind] = [&spline.pieces()[i - 1], &spline.pieces()[i]];
        near_point(before.end(), point, 0.0, "through its points");
        let h = [i - 1, i].map(|span| points[span].distance(points[span + 1]));
        let second = [before.second_derivative(1.0), behind.second_derivative(0.0)];
        near_point(second[0] / (h[0] * h[0]), second[1] / (h[1] * h[1]), 1e-12, "C2");
    }
}

#[test]
fn three_points_make_a_parabola() {
    let free = SplineEnds::Open { start: EndCondition::NotAKnot, end: EndCondition::NotAKnot };
    let points = vec![p(-2.0, 4.0), p(0.0, 0.0), p(2.0, 4.0)];
    let spline = Spline::through(points, free, Parameter::Chord).expect("a parabola");
    for k in 0..=20 {
        let point = spline.point(f64::from(k) / 20.0);
        near(point.y, point.x * point.x, 1e-13, "y = x²");
    }
    let two = vec![p(0.0, 0.0), p(1.0, 0.0)];
    let refused = Spline::through(two, free, Parameter::Chord).expect_err("two are too few");
    assert_eq!(refused, CurveError::TooFewPoints { count: 2, least: 3 }, "{refused}");
}
