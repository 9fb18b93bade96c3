//! Akima's curve against the published formula worked by hand, and its symmetries.

use g41::geometry::{EndCondition, akima};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common::random::Random;
use crate::common::{near, near_point, p};

const PUBLISHED: [EndCondition; 2] = [EndCondition::NotAKnot; 2];

#[test]
fn directions_are_those_of_the_published_formula() {
    // Legs (3, 0), (4, 3), (1, 2), (-2, 2). At the third point |a3 × a4| = |1·2 + 2·2| = 6 weighs
    // the leg before and |a1 × a2| = 9 the leg behind: 6 (4, 3) + 9 (1, 2) = (33, 36).
    let points = [p(0.0, 0.0), p(3.0, 0.0), p(7.0, 3.0), p(8.0, 5.0), p(6.0, 7.0)];
    let curve = akima(&points, PUBLISHED);
    assert_eq!(curve.len(), 4, "a cubic for each leg");
    let third = p(33.0, 36.0).normalize();
    near_point(curve[2].derivative(0.0), third * 5.0_f64.sqrt(), 1e-13, "speed of the leg");
    near_point(curve[1].derivative(1.0), third * 5.0, 1e-13, "the same direction before");
    // At the second point the leg before the first is 2 (3, 0) − (4, 3) = (2, −3), with
    // |(2, −3) × (3, 0)| = 9 and |(4, 3) × (1, 2)| = 5: 5 (3, 0) + 9 (4, 3) = (51, 27).
    near_point(curve[1].tangent(0.0), p(51.0, 27.0).normalize(), 1e-14, "second point");
    // At the first point the legs are (1, −6), (2, −3), (3, 0), (4, 3):
    // |(3, 0) × (4, 3)| = 9 and |(1, −6) × (2, −3)| = 9, so the direction is (5, −3).
    near_point(curve[0].tangent(0.0), p(5.0, -3.0).normalize(), 1e-14, "first point");
}

#[test]
fn a_point_bends_two_spans_on_each_side_and_no_other() {
    let mut random = Random::new(70);
    let mut points: Vec<DVec2> =
        (0..12).map(|i| p(5.0 * f64::from(i), random.within(-4.0, 4.0))).collect();
    let before = akima(&points, PUBLISHED);
    points[6].y += 1.0;
    let after = akima(&points, PUBLISHED);
    for (span, (a, b)) in before.iter().zip(&after).enumerate() {
        assert_eq!(a != b, (3..=8).contains(&span), "span {span}");
    }
}

#[test]
fn straight_stretches_stay_straight() {
    let points = [p(0.0, 0.0), p(1.0, 0.0), p(3.0, 0.0), p(4.0, 0.0), p(6.0, 5.0), p(7.0, 9.0)];
    let curve = akima(&points, PUBLISHED);
    for cubic in &curve[..2] {
        for k in 0..=10 {
            near(cubic.point(f64::from(k) / 10.0).y, 0.0, 1e-15, "on the straight legs");
        }
    }
}

#[test]
fn ends_are_as_asked_for() {
    let points = [p(0.0, 0.0), p(3.0, 0.0), p(7.0, 3.0), p(8.0, 5.0)];
    let tangent = p(0.0, -2.0);
    let curve = akima(&points, [EndCondition::Tangent(tangent), EndCondition::Natural]);
    near_point(curve[0].tangent(0.0), p(0.0, -1.0), 1e-15, "the tangent");
    near_point(curve[0].derivative(0.0), p(0.0, -3.0), 1e-14, "at the speed of the leg");
    near_point(curve[2].second_derivative(1.0), DVec2::ZERO, 1e-13, "no curvature");
    // The spans that no end bends are the published ones.
    assert_eq!(curve[1], akima(&points, PUBLISHED)[1], "the span between");
}

#[test]
fn few_points_make_what_there_is_to_make() {
    assert!(akima(&[p(1.0, 2.0)], PUBLISHED).is_empty(), "one point has no span");
    let line = akima(&[p(0.0, 0.0), p(4.0, 2.0)], PUBLISHED);
    near_point(line[0].point(0.5), p(2.0, 1.0), 1e-15, "two points make a line");
    near_point(line[0].second_derivative(0.3), DVec2::ZERO, 1e-14, "which is straight");
    // Of three, the legs go on as those of a parabola on both sides: at the middle both weigh the
    // same.
    let curve = akima(&[p(-1.0, 1.0), p(0.0, 0.0), p(1.0, 1.0)], PUBLISHED);
    near_point(curve[0].tangent(1.0), DVec2::X, 1e-15, "level at the vertex");
}

#[test]
fn turned_moved_scaled_and_run_backwards_it_is_the_same_curve() {
    let mut random = Random::new(71);
    for case in 0..100 {
        let count = 3 + random.index(8);
        let points: Vec<DVec2> =
            (0..count).map(|_| p(random.within(-9.0, 9.0), random.within(-9.0, 9.0))).collect();
        let curve = akima(&points, PUBLISHED);
        let turn = DVec2::from_angle(random.within(0.0, 6.0)) * 3.0;
        let map = |point: DVec2| turn.rotate(point) + p(5.0, -7.0);
        let mapped: Vec<DVec2> = points.iter().copied().map(map).collect();
        for (a, b) in curve.iter().zip(akima(&mapped, PUBLISHED)) {
            near_point(map(a.point(0.4)), b.point(0.4), 1e-11, &format!("case {case}: mapped"));
        }
        let backwards: Vec<DVec2> = points.iter().rev().copied().collect();
        for (a, b) in curve.iter().zip(akima(&backwards, PUBLISHED).iter().rev()) {
            near_point(a.point(0.4), b.point(0.6), 1e-11, &format!("case {case}: backwards"));
        }
    }
}
