//! Roundings and chamfers between lines and arcs: closed forms, and brute force along both moves.

use std::f64::consts::{FRAC_PI_2, PI};

use g41::geometry::{
    Arc, CornerCut, CornerMeasure, CornerSize, Curve, Line, cut_corner, perp, rotate, turn,
};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common::random::Random;
use crate::common::{near, near_point, p};

fn line(from: DVec2, to: DVec2) -> Curve {
    Curve::Line(Line::new(from, to).expect("a line with a length"))
}

fn arc(from: DVec2, center: DVec2, sweep: f64) -> Curve {
    Curve::Arc(Arc::from_sweep(from, center, sweep).expect("an arc with a length"))
}

fn radius(value: f64) -> CornerSize {
    CornerSize { measure: CornerMeasure::Radius, value }
}

fn legs(value: f64) -> CornerSize {
    CornerSize { measure: CornerMeasure::Legs, value }
}

fn length_of(value: f64) -> CornerSize {
    CornerSize { measure: CornerMeasure::Length, value }
}

/// A cut that must have been made: ends, centre, sense, rest.
#[track_caller]
fn made(cut: CornerCut) -> ([DVec2; 2], Option<DVec2>, bool, [f64; 2]) {
    match cut {
        CornerCut::Made { ends, center, clockwise, rest } => (ends, center, clockwise, rest),
        other => panic!("there should be an element: {other:?}"),
    }
}

#[test]
fn between_lines_a_rounding_begins_at_radius_times_tangent_of_half_the_turn() {
    for degrees in [2.0, 30.0, 90.0, 135.0, 178.0_f64] {
        for side in [1.0, -1.0] {
            let turned = side * degrees.to_radians();
            let second = rotate(DVec2::X, turned);
            let (first, second) =
                (line(p(-300.0, 0.0), p(0.0, 0.0)), line(p(0.0, 0.0), second * 300.0));
            let back = 2.0 * (0.5 * turned.abs()).tan();
            let (ends, center, clockwise, rest) = made(cut_corner(&first, &second, radius(2.0)));
            near_point(ends[0], p(-back, 0.0), 1e-11, "start");
            near_point(ends[1], rotate(DVec2::X, turned) * back, 1e-11, "end");
            near_point(center.expect("an arc"), p(-back, side * 2.0), 1e-11, "centre");
            assert_eq!(clockwise, side < 0.0, "sense at {turned}");
            near(rest[0], 300.0 - back, 1e-11, "what is left of the first");
            near(rest[1], 300.0 - back, 1e-11, "what is left of the second");
        }
    }
}

#[test]
fn a_chamfer_by_its_length_is_one_by_its_legs() {
    // Between lines the chamfer is 2 legs times the cosine of half the turn.
    for degrees in [2.0, 45.0, 90.0, 170.0_f64] {
        let turned = degrees.to_radians();
        let second = line(p(1.0, 2.0), p(1.0, 2.0) + rotate(DVec2::X, turned) * 50.0);
        let first = line(p(-49.0, 2.0), p(1.0, 2.0));
        let length = 6.0 * (0.5 * turned).cos();
        let by_legs = made(cut_corner(&first, &second, legs(3.0))).0;
        let by_length = made(cut_corner(&first, &second, length_of(length))).0;
        near_point(by_legs[0], p(-2.0, 2.0), 1e-12, "leg");
        near(by_legs[0].distance(by_legs[1]), length, 1e-12, "length");
        for i in 0..2 {
            near_point(by_length[i], by_legs[i], 1e-11, "the same chamfer");
        }
    }
}

#[test]
fn roundings_between_lines_and_arcs_have_their_centres_on_both_offsets() {
    // From +x into a circle about (0, 0) of 30, to the left: C = (√(22² − 8²), 8), and touching
    // points on the line and at 30/22 of it. This is an example of NCT's manual.
    let quarter = arc(p(30.0, 0.0), p(0.0, 0.0), FRAC_PI_2);
    let along = line(p(0.0, 0.0), p(30.0, 0.0));
    let (ends, center, clockwise, _) = made(cut_corner(&along, &quarter, radius(8.0)));
    let expected = p(420.0_f64.sqrt(), 8.0);
    near_point(center.expect("an arc"), expected, 1e-12, "centre");
    near_point(ends[0], p(expected.x, 0.0), 1e-12, "on the line");
    near_point(ends[1], expected * (30.0 / 22.0), 1e-12, "on the arc");
    assert!(!clockwise, "to the left");
    // Two circles of 10 about (±6, 0), over the top of both and through the notch at (0, 8).
    let (left, right) = (arc(p(-6.0, 10.0), p(-6.0, 0.0), -(0.6_f64.asin())), p(0.0, 8.0));
    let right = arc(right, p(6.0, 0.0), -(0.6_f64.asin()));
    let (ends, center, clockwise, _) = made(cut_corner(&left, &right, radius(5.0)));
    let expected = p(0.0, (15.0_f64 * 15.0 - 36.0).sqrt());
    near_point(center.expect("an arc"), expected, 1e-12, "centre between both");
    near_point(ends[1], p(6.0, 0.0) + (expected - p(6.0, 0.0)) * (10.0 / 15.0), 1e-12, "touches");
    assert!(!clockwise, "the notch turns left");
}

#[test]
fn a_rounding_may_take_all_of_its_moves_but_no_more() {
    let (first, second) = (line(p(-5.0, 0.0), p(0.0, 0.0)), line(p(0.0, 0.0), p(0.0, 7.0)));
    let rest = made(cut_corner(&first, &second, radius(5.0))).3;
    assert_eq!(rest, [0.0, 2.0], "all of the first");
    for size in [radius(5.001), legs(5.001), length_of(7.1)] {
        assert_eq!(cut_corner(&first, &second, size), CornerCut::Misfit, "{size:?}");
    }
    let within_1_degree = line(p(0.0, 0.0), p(10.0, 0.1));
    for size in [radius(1.0), legs(1.0), length_of(1.0)] {
        assert_eq!(cut_corner(&first, &within_1_degree, size), CornerCut::Tangent, "{size:?}");
    }
    let back = line(p(0.0, 0.0), p(-3.0, 0.0));
    let reversal = cut_corner(&first, &back, radius(1.0));
    assert_eq!(reversal, CornerCut::Misfit, "there is no arc in a reversal");
}

/// A line or an arc that starts at `at` in some direction.
fn any_curve(random: &mut Random, at: DVec2) -> Curve {
    let tangent = random.direction();
    if random.index(3) == 0 {
        return line(at, at + tangent * random.within(1.0, 30.0));
    }
    let radius = random.within(1.0, 30.0);
    let side = random.sign();
    arc(at, at + perp(tangent) * (side * radius), side * random.within(0.1, 5.5))
}

fn reversed(curve: &Curve) -> Curve {
    match curve {
        Curve::Line(line) => Curve::Line(line.reversed()),
        Curve::Arc(arc) => Curve::Arc(arc.reversed()),
        other => other.clone(),
    }
}

/// The parameter of `first` from which on, back from the corner, a circle of this radius beside it
/// no longer cuts `second`: by small steps, then by halving. `None` where it never does, where it
/// then touches an end, or has come to the other side.
fn by_force(first: &Curve, second: &Curve, radius: f64, side: f64) -> Option<f64> {
    let inside = |t: f64| {
        let center = first.point(t) + perp(first.tangent(t)) * (side * radius);
        let nearest = second.nearest(center);
        (center.distance(nearest.point) - radius, nearest.t)
    };
    let steps = 20_000;
    for i in 1..=steps {
        let at = |i: i32| 1.0 - f64::from(i) / f64::from(steps);
        if inside(at(i)).0 >= 0.0 {
            let (mut low, mut high) = (at(i), at(i - 1));
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if inside(middle).0 >= 0.0 { low = middle } else { high = middle }
            }
            let t = inside(low).1;
            let center = first.point(low) + perp(first.tangent(low)) * (side * radius);
            let beside = (center - second.point(t)).dot(perp(second.tangent(t))) * side > 0.0;
            return (beside && t > 1e-9 && t < 1.0 - 1e-9).then_some(low);
        }
    }
    None
}

#[test]
fn roundings_are_where_a_circle_rolled_back_first_touches_the_second_move() {
    let mut random = Random::new(41);
    let (mut fit, mut misfit) = (0, 0);
    let cases = if cfg!(target_arch = "wasm32") { 60 } else { 600 };
    for case in 0..cases {
        let corner = random.point(5.0);
        let first = reversed(&any_curve(&mut random, corner));
        let second = any_curve(&mut random, corner);
        let r = random.within(0.05, 12.0);
        let turned = turn(first.tangent(1.0), second.tangent(0.0));
        if turned.abs() < 0.02 || turned.abs() > 3.1 {
            continue;
        }
        let expected = by_force(&first, &second, r, turned.signum());
        let what = format!("case {case}: {first:?} {second:?} R {r}");
        match (cut_corner(&first, &second, radius(r)), expected) {
            (CornerCut::Made { ends, center, clockwise, rest }, Some(t)) => {
                fit += 1;
                near_point(ends[0], first.point(t), 1e-6, &what);
                near(rest[0], first.length() * t, 1e-6, &what);
                let center = center.expect("an arc");
                for end in ends {
                    near(end.distance(center), r, 1e-9, &what);
                }
                let at = second.nearest(ends[1]);
                near_point(at.point, ends[1], 1e-9, &what);
                near(rest[1], second.length() * (1.0 - at.t), 1e-8, &what);
                let leaves = perp(ends[1] - center) * if clockwise { -1.0 } else { 1.0 };
                near(turn(leaves, second.tangent(at.t)), 0.0, 1e-7, &what);
            }
            (CornerCut::Misfit, None) => misfit += 1,
            (got, expected) => panic!("{what}: {got:?}, by force {expected:?}"),
        }
    }
    assert!(fit > cases / 10 && misfit > cases / 10, "of both: {fit} fit, {misfit} do not");
}

#[test]
fn chamfers_between_arcs_have_legs_of_one_length() {
    let mut random = Random::new(42);
    let mut fit = 0;
    for case in 0..2000 {
        let corner = random.point(5.0);
        let first = reversed(&any_curve(&mut random, corner));
        let second = any_curve(&mut random, corner);
        let size = random.within(0.05, 8.0);
        for size in [legs(size), length_of(size)] {
            let what = format!("case {case}: {first:?} {second:?} {size:?}");
            let CornerCut::Made { ends, center, rest, .. } = cut_corner(&first, &second, size)
            else {
                continue;
            };
            fit += 1;
            assert_eq!(center, None, "{what}");
            let between = ends.map(|end| end.distance(corner));
            near(between[0], between[1], 1e-9, &what);
            let of_itself = size.measure == CornerMeasure::Length;
            let value = if of_itself { ends[0].distance(ends[1]) } else { between[0] };
            near(value, size.value, 1e-9, &what);
            let at = [first.nearest(ends[0]), second.nearest(ends[1])];
            near_point(at[0].point, ends[0], 1e-9, &what);
            near_point(at[1].point, ends[1], 1e-9, &what);
            // The chord of less than half a circle: nothing nearer along the move has this length.
            near(rest[0], first.length() * at[0].t, 1e-8, &what);
            near(rest[1], second.length() * (1.0 - at[1].t), 1e-8, &what);
        }
    }
    assert!(fit > 1500, "only {fit} fit");
    let half = arc(p(0.0, 0.0), p(0.0, 5.0), PI);
    let along = line(p(-20.0, 1.0), p(0.0, 0.0));
    let too_long = cut_corner(&along, &half, legs(10.1));
    assert_eq!(too_long, CornerCut::Misfit, "no chord of a circle of 5 is 10.1");
}
