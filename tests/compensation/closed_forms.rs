//! Inside corners of lines and arcs against closed forms, and elongated ones of every pair.

use g41::compensation::{CornerStyle, Options};
use g41::contour::{MoveCurve, Role, Side, ToolPath, TransitionKind};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::sketch::{Sketch, arc, line};
use crate::common::random::Random;
use crate::common::{near, near_point, p};

#[cfg(not(target_arch = "wasm32"))]
const CASES: u32 = 2000;
#[cfg(target_arch = "wasm32")]
const CASES: u32 = 300;

fn vertex(path: &ToolPath, what: &str) -> DVec2 {
    let found = path.transitions[0].construction.iter().find(|(name, _)| *name == "V");
    found.unwrap_or_else(|| panic!("{what}: no V in {:?}", path.transitions)).1
}

#[test]
fn a_square_becomes_a_square_inside_and_outside() {
    let corners = [p(40.0, 0.0), p(40.0, 30.0), p(0.0, 30.0), p(0.0, 0.0)];
    let square = Sketch::closed(p(0.0, 0.0), corners.map(line));
    for (side, grown) in [(Side::Left, -3.0), (Side::Right, 3.0)] {
        let path = square.compensated(side, 3.0, &Options::default());
        assert_eq!(path.moves.len(), 4, "{side:?}: {:?}", path.moves);
        let (low, high) = (p(-grown, -grown), p(40.0 + grown, 30.0 + grown));
        let expected = [p(high.x, low.y), high, p(low.x, high.y), low];
        for (one, corner) in path.moves.iter().zip(expected) {
            near_point(one.curve.end(), corner, 1e-12, &format!("{side:?}"));
        }
        near_point(path.moves[0].curve.start(), low, 1e-12, &format!("{side:?}"));
    }
}

#[test]
fn a_circle_becomes_a_concentric_circle() {
    for clockwise in [false, true] {
        let circle = Sketch::closed(p(13.0, 5.0), [arc(p(13.0, 5.0), p(5.0, 5.0), clockwise)]);
        for side in [Side::Left, Side::Right] {
            let path = circle.compensated(side, 3.0, &Options::default());
            assert_eq!(path.moves.len(), 1, "{side:?}: {:?}", path.moves);
            let MoveCurve::Arc(arc) = path.moves[0].curve else { panic!("{:?}", path.moves) };
            let inwards = (side == Side::Left) != clockwise;
            near(arc.radius(), if inwards { 5.0 } else { 11.0 }, 1e-12, "radius");
            near_point(arc.center(), p(5.0, 5.0), 1e-12, "centre");
            assert!(arc.is_full_circle() && arc.is_clockwise() == clockwise, "{arc:?}");
        }
    }
}

#[test]
fn lines_inside_meet_on_the_bisector() {
    let mut random = Random::new(201);
    for case in 0..CASES {
        let (heading, turn) = (random.within(0.0, 6.0), random.within(0.05, 2.9));
        let radius = random.within(0.1, 5.0);
        // Both legs must be longer than what is cut off.
        let leg = radius * (0.5 * turn).tan() + random.within(0.1, 20.0);
        for side in [Side::Left, Side::Right] {
            let turn = turn * side.sign();
            let (t1, t2) = (DVec2::from_angle(heading), DVec2::from_angle(heading + turn));
            let corner = random.point(100.0);
            let sketch = Sketch::open(corner - t1 * leg, [line(corner), line(corner + t2 * leg)]);
            let path = sketch.compensated(side, radius, &Options::default());
            let bisector = (t2 - t1).normalize();
            let what = format!("case {case}, {side:?}");
            let v = corner + bisector * radius / (0.5 * turn).cos();
            near_point(vertex(&path, &what), v, 1e-11 * (1.0 + v.distance(corner)), &what);
            assert_eq!(path.moves.len(), 2, "{what}: {:?}", path.moves);
            near_point(path.moves[0].curve.end(), v, 1e-10, &what);
        }
    }
}

/// Parameters s at which `from + s · along` is `radius` from `center`.
fn line_meets_circle(from: DVec2, along: DVec2, center: DVec2, radius: f64) -> Option<[f64; 2]> {
    let w = center - from;
    let (foot, off) = (w.dot(along), w.perp_dot(along));
    let half = radius * radius - off * off;
    (half > 0.0).then(|| [foot - half.sqrt(), foot + half.sqrt()])
}

#[test]
fn line_and_arc_inside_meet_on_line_and_concentric_circle() {
    let mut random = Random::new(202);
    let mut judged = 0;
    for case in 0..CASES {
        let side = if random.coin() { Side::Left } else { Side::Right };
        let (sigma, radius) = (side.sign(), random.within(0.2, 3.0));
        let heading = random.within(0.0, 6.0);
        let turn = sigma * random.within(0.05, 2.6);
        let (t1, t2) = (DVec2::from_angle(heading), DVec2::from_angle(heading + turn));
        let bend = random.within(5.0, 40.0) * random.sign();
        let (corner, leg) = (random.point(50.0), 40.0);
        let center = corner + t2.perp() * bend;
        // Half a circle at most, so that each distance from its ends is reached once.
        let sweep = random.within(1.0, 3.0);
        let end = center + DVec2::from_angle(sweep * bend.signum()).rotate(corner - center);
        let sketch = Sketch::open(corner - t1 * leg, [line(corner), arc(end, center, bend < 0.0)]);
        // The offset line, and the offset circle of radius |bend| − σ r for a bend to the left.
        let from = corner - t1 * leg + t1.perp() * sigma * radius;
        let circle = bend.abs() - sigma * bend.signum() * radius;
        let Some(roots) = line_meets_circle(from, t1, center, circle) else { continue };
        let on_both = |s: f64| {
            let point = from + t1 * s;
            let start = corner - center;
            let mut angle = start.angle_to(point - center) * bend.signum();
            if angle < 0.0 {
                angle += std::f64::consts::TAU;
            }
            let tangent = (point - center).perp() * bend.signum();
            // Crossing as the corner turns, well inside both finite moves.
            let crosses = sigma * t1.perp_dot(tangent) > 1e-3 * circle;
            let inside = s > 1e-6 && s < leg - 1e-6 && angle > 1e-6 && angle < sweep - 1e-6;
            (crosses && inside).then_some(point)
        };
        let Some(v) = on_both(roots[1]).or_else(|| on_both(roots[0])) else { continue };
        judged += 1;
        for (sketch, side, name) in
            [(sketch.clone(), side, "line, arc"), (sketch.reversed(), side.opposite(), "arc, line")]
        {
            let what = format!("case {case}, {name}, {side:?}: {sketch:?}");
            let path = sketch.compensated(side, radius, &Options::default());
            assert_eq!(path.transitions[0].kind, TransitionKind::Shortened, "{what}");
            near_point(vertex(&path, &what), v, 1e-8, &what);
            assert_eq!(path.moves.len(), 2, "{what}: {:?}", path.moves);
        }
    }
    assert!(judged > CASES / 3, "only {judged} corners have an intersection");
}

#[test]
fn arcs_inside_meet_on_both_concentric_circles() {
    let mut random = Random::new(203);
    let mut judged = 0;
    for case in 0..CASES {
        let side = if random.coin() { Side::Left } else { Side::Right };
        let (sigma, radius) = (side.sign(), random.within(0.2, 3.0));
        let heading = random.within(0.0, 6.0);
        let turn = sigma * random.within(0.1, 2.5);
        let (t1, t2) = (DVec2::from_angle(heading), DVec2::from_angle(heading + turn));
        let bends = [0, 1].map(|_| random.within(6.0, 40.0) * random.sign());
        let corner = random.point(50.0);
        let centers = [corner + t1.perp() * bends[0], corner + t2.perp() * bends[1]];
        let sweep = 1.5;
        let turned =
            |center: DVec2, angle: f64| center + DVec2::from_angle(angle).rotate(corner - center);
        let start = turned(centers[0], -sweep * bends[0].signum());
        let end = turned(centers[1], sweep * bends[1].signum());
        let sketch = Sketch::open(
            start,
            [arc(corner, centers[0], bends[0] < 0.0), arc(end, centers[1], bends[1] < 0.0)],
        );
        let radii = bends.map(|bend| bend.abs() - sigma * bend.signum() * radius);
        // Law of cosines in the triangle of both centres and the intersection.
        let between = centers[1] - centers[0];
        let apart = between.length();
        let cosine =
            (radii[0].powi(2) + apart.powi(2) - radii[1].powi(2)) / (2.0 * radii[0] * apart);
        if cosine.abs() > 0.999 {
            continue;
        }
        // Way along each arc, in rad from the corner, backwards on the first.
        let way = |i: usize, point: DVec2| {
            let forwards = if i == 0 { -1.0 } else { 1.0 };
            (corner - centers[i]).angle_to(point - centers[i]) * bends[i].signum() * forwards
        };
        let meets = [1.0, -1.0].map(|sign| {
            let ray = DVec2::from_angle(between.to_angle() + sign * cosine.acos());
            let point = centers[0] + ray * radii[0];
            let tangents = [0, 1].map(|i| (point - centers[i]).perp() * bends[i].signum());
            let crosses = sigma * tangents[0].perp_dot(tangents[1]) > 0.0;
            let ways = [way(0, point), way(1, point)];
            let inside = ways.iter().all(|w| (1e-6..sweep - 1e-6).contains(w));
            (crosses && inside).then_some((ways[0], point))
        });
        let Some((_, v)) = meets.into_iter().flatten().min_by(|a, b| a.0.total_cmp(&b.0)) else {
            continue;
        };
        judged += 1;
        let what = format!("case {case}, {side:?}, {radius}: {sketch:?}");
        let path = sketch.compensated(side, radius, &Options::default());
        near_point(vertex(&path, &what), v, 1e-7, &what);
        assert_eq!(path.moves.len(), 2, "{what}: {:?}", path.moves);
    }
    assert!(judged > CASES / 3, "only {judged} corners have an intersection");
}

#[test]
fn an_arc_about_the_corner_has_the_radius_of_the_tool_and_turns_away_from_it() {
    let mut random = Random::new(204);
    let options = Options { corner: CornerStyle::Arc, ..Options::default() };
    for case in 0..CASES {
        let (heading, turn) = (random.within(0.0, 6.0), random.within(0.01, 3.1));
        let radius = random.within(0.1, 5.0);
        for side in [Side::Left, Side::Right] {
            let turn = -turn * side.sign();
            let (t1, t2) = (DVec2::from_angle(heading), DVec2::from_angle(heading + turn));
            let corner = random.point(100.0);
            let sketch = Sketch::open(corner - t1 * 9.0, [line(corner), line(corner + t2 * 9.0)]);
            let path = sketch.compensated(side, radius, &options);
            let what = format!("case {case}, {side:?}");
            let [_, inserted, _] = path.moves[..] else { panic!("{what}: {:?}", path.moves) };
            assert_eq!(inserted.role, Role::Transition, "{what}");
            let MoveCurve::Arc(arc) = inserted.curve else { panic!("{what}: {inserted:?}") };
            near_point(arc.center(), corner, 1e-10, &what);
            near(arc.radius(), radius, 1e-10, &what);
            near(arc.sweep(), turn, 1e-10, &what);
        }
    }
}
