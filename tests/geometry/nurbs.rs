//! NURBS curves against the Cox-de Boor recursion and closed forms.

use std::f64::consts::FRAC_1_SQRT_2;

use g41::geometry::{Cubic, Nurbs, NurbsError};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common::random::Random;
use crate::common::{near, near_point, p};

/// The basis function of an order by its definition.
fn basis(knots: &[f64], i: usize, order: usize, u: f64) -> f64 {
    if order == 1 {
        return f64::from(u8::from(knots[i] <= u && u < knots[i + 1]));
    }
    let share = |a: f64, b: f64| if b > 0.0 { a / b } else { 0.0 };
    share(u - knots[i], knots[i + order - 1] - knots[i]) * basis(knots, i, order - 1, u)
        + share(knots[i + order] - u, knots[i + order] - knots[i + 1])
            * basis(knots, i + 1, order - 1, u)
}

/// The point of a curve by the definition.
fn defined(order: usize, knots: &[f64], controls: &[(DVec2, f64)], u: f64) -> DVec2 {
    let (mut sum, mut total) = (DVec2::ZERO, 0.0);
    for (i, (point, weight)) in controls.iter().enumerate() {
        let share = basis(knots, i, order, u) * weight;
        sum += *point * share;
        total += share;
    }
    sum / total
}

fn random_curve(random: &mut Random, order: usize) -> (Vec<f64>, Vec<(DVec2, f64)>) {
    let count = order + random.index(6);
    let mut knots = vec![0.0; order];
    for _ in order..count {
        let last = knots[knots.len() - 1];
        // Some knots are double, where the order leaves the curve in one piece with a tangent.
        let double = order > 3 && last > 0.0 && knots[knots.len() - 2] < last;
        let step = if double && random.unit() < 0.3 { 0.0 } else { random.within(0.2, 3.0) };
        knots.push(last + step);
    }
    let end = knots[knots.len() - 1] + 1.0;
    knots.extend(vec![end; order]);
    let controls = (0..count)
        .map(|_| (p(random.within(-50.0, 50.0), random.within(-50.0, 50.0)), 1.0))
        .collect();
    (knots, controls)
}

/// The distinct knots at which spans begin and end.
fn spans(knots: &[f64]) -> Vec<[f64; 2]> {
    knots.windows(2).filter(|pair| pair[0] < pair[1]).map(|pair| [pair[0], pair[1]]).collect()
}

#[test]
fn without_weights_up_to_the_third_degree_the_cubics_are_the_curve() {
    let mut random = Random::new(620);
    for case in 0..300 {
        let order = 2 + random.index(3);
        let (knots, controls) = random_curve(&mut random, order);
        let curve = Nurbs::new(order, knots.clone(), &controls).expect("a curve");
        assert!(curve.is_cubic(), "case {case}");
        let cubics = curve.cubics(1e-4).expect("positive weights");
        let spans = spans(&knots);
        assert_eq!(cubics.len(), spans.len(), "case {case}: a cubic for each span");
        for (cubic, [from, to]) in cubics.iter().zip(spans) {
            for k in 0..16 {
                let t = f64::from(k) / 16.0;
                let u = from + (to - from) * t;
                let what = format!("case {case}, order {order}, at {u}");
                near_point(cubic.point(t), defined(order, &knots, &controls, u), 1e-11, &what);
            }
        }
    }
}

/// Largest distance from some cubics of dense points of a curve, and of dense points of the cubics
/// from the curve's, as far as the points are dense.
fn apart(cubics: &[Cubic], points: &[DVec2]) -> [f64; 2] {
    let nearest = |point: DVec2| {
        let distance = |cubic: &Cubic| cubic.nearest(point).distance;
        cubics.iter().map(distance).fold(f64::INFINITY, f64::min)
    };
    let forth = points.iter().map(|&point| nearest(point)).fold(0.0, f64::max);
    let mut back = 0.0_f64;
    for cubic in cubics {
        for k in 0..=8 {
            let point = cubic.point(f64::from(k) / 8.0);
            let to = |pair: &[DVec2]| {
                let (chord, way) = (pair[1] - pair[0], point - pair[0]);
                let share = (way.dot(chord) / chord.length_squared().max(1e-300)).clamp(0.0, 1.0);
                (way - chord * share).length()
            };
            back = back.max(points.windows(2).map(to).fold(f64::INFINITY, f64::min));
        }
    }
    [forth, back]
}

#[test]
fn with_weights_or_of_a_higher_degree_the_cubics_are_within_the_tolerance() {
    let mut random = Random::new(621);
    for case in 0..40 {
        let order = 3 + random.index(5);
        let (knots, mut controls) = random_curve(&mut random, order);
        for (_, weight) in &mut controls {
            *weight = random.within(-1.5, 1.5).exp();
        }
        let tolerance = [1e-2, 1e-4, 1e-6][case % 3];
        let curve = Nurbs::new(order, knots.clone(), &controls).expect("a curve");
        let cubics = curve.cubics(tolerance).expect("positive weights");
        for pair in cubics.windows(2) {
            near_point(pair[0].end(), pair[1].start(), 1e-10, "the cubics follow each other");
        }
        let mut points = Vec::new();
        for [from, to] in spans(&knots) {
            for k in 0..600 {
                let u = from + (to - from) * f64::from(k) / 600.0;
                points.push(defined(order, &knots, &controls, u));
            }
        }
        points.push(controls[controls.len() - 1].0);
        let [forth, back] = apart(&cubics, &points);
        let what = format!("case {case}, order {order}, {} cubics", cubics.len());
        assert!(forth <= tolerance, "{what}: {forth:e} for {tolerance:e}");
        // Chords of the dense points cut off corners of their own.
        assert!(back <= tolerance + 5e-3, "{what}: {back:e} for {tolerance:e}");
    }
}

/// A circle of nine control points about the origin.
fn circle(radius: f64) -> Nurbs {
    let corners = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)];
    let controls: Vec<(DVec2, f64)> = (0..)
        .zip(corners)
        .map(|(i, (x, y))| {
            let weight = if i % 2 == 0 { 1.0 } else { FRAC_1_SQRT_2 };
            (p(f64::from(x), f64::from(y)) * radius, weight)
        })
        .collect();
    let knots = [0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 4.0, 4.0, 4.0];
    Nurbs::new(3, knots.to_vec(), &controls).expect("a circle")
}

#[test]
fn a_circle_is_one() {
    let mut counts = Vec::new();
    for tolerance in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9] {
        let cubics = circle(25.0).cubics(tolerance).expect("positive weights");
        let mut turned = 0.0;
        for cubic in &cubics {
            for k in 0..=100 {
                let radius = cubic.point(f64::from(k) / 100.0).length();
                near(radius, 25.0, tolerance, "distance from the centre");
            }
            turned += cubic.start().angle_to(cubic.end());
        }
        near(turned, std::f64::consts::TAU, 1e-9, "all the way round, to the left");
        counts.push(cubics.len());
    }
    assert!(counts[8] <= 1024, "of the fourth order: {counts:?}");
}

#[test]
fn a_quadratic_with_weights_is_a_conic() {
    // With weight w in the middle: parabola for 1, ellipse below, hyperbola above. On the conic
    // B² = 4 w² A C in barycentric coordinates A, B, C of the triangle of control points.
    for weight in [0.2, 0.7, 1.0, 1.5, 5.0] {
        let controls = [(p(0.0, 0.0), 1.0), (p(10.0, 20.0), weight), (p(30.0, 0.0), 1.0)];
        let knots = vec![2.0, 2.0, 2.0, 5.0, 5.0, 5.0];
        let curve = Nurbs::new(3, knots, &controls).expect("a conic");
        for cubic in curve.cubics(1e-7).expect("positive weights") {
            for k in 0..=20 {
                let point = cubic.point(f64::from(k) / 20.0);
                let b = point.y / 20.0;
                let c = (point.x - 10.0 * b) / 30.0;
                let a = 1.0 - b - c;
                near(b * b, 4.0 * weight * weight * a * c, 1e-6, &format!("weight {weight}"));
            }
        }
    }
}

#[test]
fn a_common_factor_of_all_weights_and_a_stretch_of_the_knots_change_nothing() {
    let mut random = Random::new(622);
    let (knots, controls) = random_curve(&mut random, 4);
    let cubics = |factor: f64, stretch: f64| {
        let knots = knots.iter().map(|knot| knot * stretch - 7.0).collect();
        let controls: Vec<_> = controls.iter().map(|(point, w)| (*point, w * factor)).collect();
        Nurbs::new(4, knots, &controls).expect("a curve").cubics(1e-4).expect("positive weights")
    };
    for (a, b) in cubics(1.0, 1.0).iter().zip(cubics(3.0, 5.0)) {
        for (a, b) in a.points.iter().zip(b.points) {
            near_point(*a, b, 1e-11, "control point");
        }
    }
}

#[test]
fn uniform_knots_are_clamped() {
    assert_eq!(Nurbs::uniform_knots(3, 5), [0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0], "order 3");
    assert_eq!(Nurbs::uniform_knots(4, 4), [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0], "one span");
}

#[test]
fn what_is_no_curve_is_refused() {
    let square = [(p(0.0, 0.0), 1.0), (p(1.0, 0.0), 1.0), (p(1.0, 1.0), 1.0), (p(0.0, 1.0), 1.0)];
    let weighted = |i: usize, weight: f64| {
        let mut controls = square;
        controls[i].1 = weight;
        controls
    };
    let mut nowhere = square;
    nowhere[2].0.x = f64::NAN;
    let knots = |list: &[f64]| list.to_vec();
    let fine = [0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0];
    for (order, knots, controls, error) in [
        (1, knots(&fine), square, NurbsError::Order),
        (17, knots(&fine), square, NurbsError::Order),
        (5, knots(&fine), square, NurbsError::TooFewPoints),
        (3, knots(&fine[1..]), square, NurbsError::KnotCount),
        (3, knots(&[0.0, 0.0, 0.0, f64::NAN, 2.0, 2.0, 2.0]), square, NurbsError::OutOfRange),
        (3, knots(&[0.0, 0.0, 0.0, 3.0, 2.0, 2.0, 2.0]), square, NurbsError::KnotOrder),
        (3, knots(&[0.0, 0.0, 0.5, 1.0, 2.0, 2.0, 2.0]), square, NurbsError::KnotEnds),
        (3, knots(&[0.0, 0.0, 0.0, 1.0, 1.5, 2.0, 2.0]), square, NurbsError::KnotEnds),
        (3, knots(&[0.0, 0.0, 0.0, 0.0, 2.0, 2.0, 2.0]), square, NurbsError::KnotRepeated),
        (3, knots(&[0.0; 7]), square, NurbsError::KnotRepeated),
        (3, knots(&fine), weighted(1, -1.0), NurbsError::Weight),
        (3, knots(&fine), weighted(3, 0.0), NurbsError::Weight),
        (3, knots(&fine), weighted(2, f64::INFINITY), NurbsError::OutOfRange),
        (3, knots(&fine), nowhere, NurbsError::OutOfRange),
    ] {
        let refused = Nurbs::new(order, knots, &controls).expect_err("it is refused");
        assert_eq!(refused, error, "{refused}");
    }
    // Two control points without weight leave nothing where their span meets the next.
    let mut hollow = weighted(1, 0.0);
    hollow[2].1 = 0.0;
    let curve = Nurbs::new(3, fine.to_vec(), &hollow).expect("its ends have weights");
    assert_eq!(curve.cubics(1e-4), Err(NurbsError::Weight), "nothing at the joint");
    let long: Vec<(DVec2, f64)> =
        (0..60).map(|i| (p(f64::from(i), f64::from(i % 2) * 1e6), f64::from(1 + i % 3))).collect();
    let curve = Nurbs::new(3, Nurbs::uniform_knots(3, 60), &long).expect("a curve");
    assert_eq!(curve.cubics(0.0), Err(NurbsError::TooFine), "but not without end");
}
