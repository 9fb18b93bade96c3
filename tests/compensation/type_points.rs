//! The textbook's construction for splines, point by point ("Tool radius compensation algorithm of
//! spline curve", 2.3), computed here from the article alone.

use g41::compensation::{Options, SplineMethod};
use g41::contour::{Role, Side, ToolPath};
use g41::geometry::{EndCondition, Parameter, Spline, SplineEnds};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::judge::in_one_piece;
use super::sketch::{Sketch, arc, line, spline};
use crate::common::random::Random;
use crate::common::{near, near_point, p};

const RADIUS: f64 = 2.0;

fn options() -> Options {
    Options { spline: SplineMethod::TypePoints, ..Options::default() }
}

/// The point where the equidistants of two legs meet.
fn meet(a: [DVec2; 2], b: [DVec2; 2], offset: f64) -> DVec2 {
    let (ta, tb) = ((a[1] - a[0]).normalize(), (b[1] - b[0]).normalize());
    let (from, other) = (a[0] + ta.perp() * offset, b[0] + tb.perp() * offset);
    from + ta * ((other - from).perp_dot(tb) / ta.perp_dot(tb))
}

/// The moved inner points: r along the transition vector from the point to where the equidistants
/// of its legs meet.
fn moved_inside(points: &[DVec2], offset: f64) -> Vec<DVec2> {
    points
        .windows(3)
        .map(|w| {
            let vertex = meet([w[0], w[1]], [w[1], w[2]], offset);
            w[1] + (vertex - w[1]).normalize() * offset.abs()
        })
        .collect()
}

fn beside(at: DVec2, leg: [DVec2; 2], offset: f64) -> DVec2 {
    at + (leg[1] - leg[0]).normalize().perp() * offset
}

/// Asserts that the moves of the segment `which`, counted by origin, are the natural spline through
/// the given points.
#[track_caller]
fn spline_moves(path: &ToolPath, which: u32, through: &[DVec2], what: &str) {
    let origin = g41::diagnostic::Origin::Segment(which);
    let moves: Vec<_> =
        path.moves.iter().filter(|m| m.origin == origin && m.role == Role::Segment).collect();
    assert_eq!(moves.len(), through.len() - 1, "{what}: spans");
    for (one, ends) in moves.iter().zip(through.windows(2)) {
        near_point(one.curve.start(), ends[0], 1e-9, &format!("{what}: type point"));
        near_point(one.curve.end(), ends[1], 1e-9, &format!("{what}: type point"));
    }
    let expected = Spline::through(through.to_vec(), SplineEnds::NATURAL, Parameter::Chord)
        .expect("valid type points");
    for (one, piece) in moves.iter().zip(expected.pieces()) {
        for k in 0..=8 {
            let t = f64::from(k) / 8.0;
            near_point(one.curve.point(t), piece.point(t), 1e-9, &format!("{what}: spline"));
        }
    }
}

const POINTS: [DVec2; 5] = [
    DVec2::new(0.0, 0.0),
    DVec2::new(10.0, 4.0),
    DVec2::new(21.0, 5.0),
    DVec2::new(30.0, 0.0),
    DVec2::new(38.0, -9.0),
];

/// The type points before and behind, with `first` and `last` between which the spline runs.
fn through(first: DVec2, last: DVec2, offset: f64) -> Vec<DVec2> {
    let mut points = vec![first];
    points.extend(moved_inside(&POINTS, offset));
    points.push(last);
    points
}

#[test]
fn inner_points_move_by_r_along_their_transition_vectors_and_ends_aside() {
    for side in [Side::Left, Side::Right] {
        let offset = side.sign() * RADIUS;
        let path =
            Sketch::open(POINTS[0], [spline(&POINTS[1..])]).compensated(side, RADIUS, &options());
        let ends = [
            beside(POINTS[0], [POINTS[0], POINTS[1]], offset),
            beside(POINTS[4], [POINTS[3], POINTS[4]], offset),
        ];
        let expected = through(ends[0], ends[1], offset);
        for (moved, point) in expected.iter().zip(POINTS) {
            near(moved.distance(point), RADIUS, 1e-12, "each point moves by r");
        }
        spline_moves(&path, 0, &expected, &format!("{side:?}"));
    }
}

#[test]
fn a_line_meets_the_first_leg_at_v_or_by_a1_and_a2() {
    // Turns at the start: left is inside for a tool on the left.
    for degrees in [70.0_f64, 20.0, -30.0, -80.0, -110.0, -150.0] {
        for side in [Side::Left, Side::Right] {
            let (sigma, offset) = (side.sign(), side.sign() * RADIUS);
            let leg = [POINTS[0], POINTS[1]];
            let t2 = (leg[1] - leg[0]).normalize();
            let t1 = DVec2::from_angle(-degrees.to_radians()).rotate(t2);
            let from = POINTS[0] - t1 * 15.0;
            let sketch = Sketch::open(from, [line(POINTS[0]), spline(&POINTS[1..])]);
            let what = format!("{degrees}°, {side:?}");
            let path = sketch.compensated(side, RADIUS, &options());
            in_one_piece(&path, &what);
            let end = beside(POINTS[4], [POINTS[3], POINTS[4]], offset);
            let inserted: Vec<_> =
                path.moves.iter().filter(|m| m.role == Role::Transition).collect();
            let line_end = path.moves[0].curve.end();
            // σφ < −90° is acute on the outside.
            if sigma * degrees < -90.0 {
                let beside1 = POINTS[0] + t1.perp() * offset;
                let beside2 = POINTS[0] + t2.perp() * offset;
                let (a1, a2) = (beside1 + t1 * RADIUS, beside2 - t2 * RADIUS);
                near_point(line_end, a1, 1e-9, &what);
                let ends: Vec<_> = inserted.iter().map(|m| m.curve.end()).collect();
                assert_eq!(ends.len(), 2, "{what}: A1 A2, A2 P': {ends:?}");
                near_point(ends[0], a2, 1e-9, &what);
                near_point(ends[1], beside2, 1e-9, &what);
                spline_moves(&path, 1, &through(beside2, end, offset), &what);
            } else {
                let v = meet([from, POINTS[0]], leg, offset);
                assert!(inserted.is_empty(), "{what}: {inserted:?}");
                near_point(line_end, v, 1e-9, &what);
                spline_moves(&path, 1, &through(v, end, offset), &what);
            }
            // The same backwards: the spline first, then the line.
            let back = sketch.reversed().compensated(side.opposite(), RADIUS, &options());
            let mut forth: Vec<_> = path.moves.iter().map(|m| m.curve.start()).collect();
            forth.reverse();
            assert_eq!(back.moves.len(), forth.len(), "{what}: backwards");
            for (one, expected) in back.moves.iter().zip(forth) {
                near_point(one.curve.end(), expected, 1e-9, &format!("{what}: backwards"));
            }
        }
    }
}

#[test]
fn the_concentric_circle_of_an_arc_meets_the_equidistant_of_the_first_leg() {
    let mut random = Random::new(301);
    let mut judged = [0, 0];
    for case in 0..600 {
        let side = if random.coin() { Side::Left } else { Side::Right };
        let (sigma, offset) = (side.sign(), side.sign() * RADIUS);
        let leg = [POINTS[0], POINTS[1]];
        let t2 = (leg[1] - leg[0]).normalize();
        let turn = random.within(-1.4, 1.4);
        let t1 = DVec2::from_angle(-turn).rotate(t2);
        let bend = random.within(10.0, 40.0) * random.sign();
        let center = POINTS[0] + t1.perp() * bend;
        let start = center + DVec2::from_angle(-1.2 * bend.signum()).rotate(POINTS[0] - center);
        let sketch =
            Sketch::open(start, [arc(POINTS[0], center, bend < 0.0), spline(&POINTS[1..])]);
        // The equidistant of the leg and the circle of radius |bend| − σ r for a left bend.
        let circle = bend.abs() - offset * bend.signum();
        let foot = leg[0] + t2.perp() * offset;
        let along = (center - foot).dot(t2);
        let off = (center - foot).perp_dot(t2);
        let Some(half) = Some(circle * circle - off * off).filter(|h| *h > 1.0).map(f64::sqrt)
        else {
            continue;
        };
        let v = meet([POINTS[0] - t1, POINTS[0]], leg, offset);
        let nearer = [along - half, along + half]
            .map(|s| foot + t2 * s)
            .into_iter()
            .min_by(|a, b| a.distance(v).total_cmp(&b.distance(v)))
            .expect("two points");
        let shortened = sigma * turn > 0.02;
        if !shortened && sigma * turn > -0.02 || nearer.distance(v) > 0.5 * RADIUS {
            continue;
        }
        judged[usize::from(shortened)] += 1;
        let what = format!("case {case}, {side:?}, turn {turn}, bend {bend}");
        let path = sketch.compensated(side, RADIUS, &options());
        in_one_piece(&path, &what);
        let end = beside(POINTS[4], [POINTS[3], POINTS[4]], offset);
        near_point(path.moves[0].curve.end(), nearer, 1e-8, &what);
        spline_moves(&path, 1, &through(path.moves[0].curve.end(), end, offset), &what);
    }
    assert!(judged.iter().all(|&n| n > 50), "too few corners: {judged:?}");
}

#[test]
fn two_splines_meet_as_their_legs_do() {
    for degrees in [80.0_f64, 25.0, -40.0, -120.0] {
        for side in [Side::Left, Side::Right] {
            let (sigma, offset) = (side.sign(), side.sign() * RADIUS);
            // The second spline is the first one, moved to its end and turned.
            let corner = POINTS[4];
            let t1 = (POINTS[4] - POINTS[3]).normalize();
            let t2 = DVec2::from_angle(degrees.to_radians()).rotate(t1);
            let second: Vec<DVec2> = [p(0.0, 0.0), p(9.0, 0.0), p(17.0, 2.0), p(25.0, 1.0)]
                .map(|q| corner + t2.rotate(q))
                .to_vec();
            let sketch = Sketch::open(POINTS[0], [spline(&POINTS[1..]), spline(&second[1..])]);
            let what = format!("{degrees}°, {side:?}");
            let path = sketch.compensated(side, RADIUS, &options());
            in_one_piece(&path, &what);
            let start = beside(POINTS[0], [POINTS[0], POINTS[1]], offset);
            let end = beside(second[3], [second[2], second[3]], offset);
            let (last, first) = (
                beside(corner, [POINTS[3], corner], offset),
                beside(corner, [corner, second[1]], offset),
            );
            let rest = moved_inside(&second, offset);
            let continued = |from: DVec2| [vec![from], rest.clone(), vec![end]].concat();
            let hinted = path.diagnostics.iter().any(|d| d.code == "splines-meet-elongated");
            let inserted: Vec<_> =
                path.moves.iter().filter(|m| m.role == Role::Transition).collect();
            if sigma * degrees < -90.0 {
                let ends: Vec<_> = inserted.iter().map(|m| m.curve.end()).collect();
                assert_eq!(ends.len(), 3, "{what}: P' A1, A1 A2, A2 P': {ends:?}");
                near_point(ends[0], last + t1 * RADIUS, 1e-9, &what);
                near_point(ends[1], first - t2 * RADIUS, 1e-9, &what);
                spline_moves(&path, 0, &through(start, last, offset), &what);
                spline_moves(&path, 1, &continued(first), &what);
            } else {
                let v = meet([POINTS[3], corner], [corner, second[1]], offset);
                assert!(inserted.is_empty(), "{what}: {inserted:?}");
                spline_moves(&path, 0, &through(start, v, offset), &what);
                spline_moves(&path, 1, &continued(v), &what);
            }
            assert_eq!(hinted, (-90.0..0.0).contains(&(sigma * degrees)), "{what}: the hint");
        }
    }
}

#[test]
fn a_closed_spline_moves_every_point_along_its_bisector() {
    let mut random = Random::new(302);
    for case in 0..100 {
        let count = 5 + random.index(12);
        let points: Vec<DVec2> = (0..count)
            .map(|i| DVec2::from_angle(std::f64::consts::TAU * i as f64 / count as f64))
            .map(|ray| ray * random.within(25.0, 35.0))
            .collect();
        for side in [Side::Left, Side::Right] {
            let offset = side.sign() * RADIUS;
            let mut rest = points[1..].to_vec();
            rest.push(points[0]);
            let path =
                Sketch::closed(points[0], [spline(&rest)]).compensated(side, RADIUS, &options());
            let around = [&points[count - 1..], &points[..], &points[..1]].concat();
            let moved = moved_inside(&around, offset);
            assert_eq!(path.moves.len(), count, "case {case}: spans");
            for (one, expected) in path.moves.iter().zip(&moved) {
                near_point(one.curve.start(), *expected, 1e-9, &format!("case {case}, {side:?}"));
            }
            let (first, last) = (&path.moves[0].curve, &path.moves[count - 1].curve);
            near_point(last.end(), first.start(), 1e-9, "closed");
            near_point(last.tangent(1.0), first.tangent(0.0), 1e-9, "smooth at its start");
        }
    }
}

#[test]
fn given_end_tangents_are_kept() {
    let tangents = [p(1.0, 1.0), p(0.3, -1.0)];
    let mut sketch = Sketch::open(POINTS[0], [spline(&POINTS[1..])]);
    let g41::contour::Shape::Spline(shape) = &mut sketch.shapes[0] else { panic!("a spline") };
    (shape.start_tangent, shape.end_tangent) = (Some(tangents[0]), Some(tangents[1]));
    let path = sketch.compensated(Side::Left, RADIUS, &options());
    let ends = SplineEnds::Open {
        start: EndCondition::Tangent(tangents[0]),
        end: EndCondition::Tangent(tangents[1]),
    };
    let moved: Vec<DVec2> = path
        .moves
        .iter()
        .map(|m| m.curve.start())
        .chain([path.moves[path.moves.len() - 1].curve.end()])
        .collect();
    for (moved, inner) in moved[1..4].iter().zip(moved_inside(&POINTS, RADIUS)) {
        near_point(*moved, inner, 1e-9, "inner point");
    }
    let expected = Spline::through(moved, ends, Parameter::Chord).expect("valid");
    for (one, piece) in path.moves.iter().zip(expected.pieces()) {
        near_point(one.curve.point(0.5), piece.point(0.5), 1e-9, "clamped spline");
    }
}
