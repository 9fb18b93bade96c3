//! Random contours whose walls are about two tool radii apart, and their radii.

use glam::DVec2;

use super::families::{about_one, any_radius, closed_polygon};
use super::sketch::{Sketch, arc, line, spline};
use crate::common::p;
use crate::common::random::Random;

/// Rooms joined by corridors that are exactly as wide as the tool, or nearly.
pub(super) fn corridor(random: &mut Random) -> (Sketch, f64) {
    let radius = if random.coin() { 2.0 } else { random.within(0.5, 8.0) };
    let rooms = 2 + random.index(3);
    let mut below = Vec::new();
    let mut above = Vec::new();
    let mut x = 0.0;
    for room in 0..rooms {
        let (deep, long) = (random.within(1.0, 4.0) * radius, random.within(2.0, 6.0) * radius);
        below.extend([p(x, -deep), p(x + long, -deep)]);
        above.extend([p(x, deep), p(x + long, deep)]);
        x += long;
        if room + 1 < rooms {
            let half = radius * about_one(random);
            let slant = if random.coin() { 0.0 } else { random.within(-0.1, 0.1) * radius };
            let long = random.within(0.1, 5.0) * radius;
            below.extend([p(x, -half), p(x + long, -half + slant)]);
            above.extend([p(x, half), p(x + long, half + slant)]);
            x += long;
        }
    }
    above.reverse();
    below.extend(above);
    below.dedup_by(|a, b| a.distance(*b) < 1e-6);
    (closed_polygon(&below), radius)
}

/// Two concentric arcs, exactly one tool apart, closed at their ends.
pub(super) fn concentric_walls(random: &mut Random) -> (Sketch, f64) {
    let radius = if random.coin() { 3.0 } else { random.within(0.5, 8.0) };
    let inner = random.within(0.2, 5.0) * radius;
    let outer = inner + 2.0 * radius * about_one(random);
    let angle = random.within(0.3, 6.2);
    let end = DVec2::from_angle(angle);
    let cap = |from: DVec2, to: DVec2, random: &mut Random| match random.index(3) {
        0 => vec![line(to)],
        1 => vec![arc(to, from.midpoint(to), random.coin())],
        _ => {
            let out = (to - from).perp() * random.within(-2.0, 2.0);
            vec![line(from + out), line(to + out), line(to)]
        }
    };
    let mut shapes = vec![arc(end * outer, DVec2::ZERO, false)];
    shapes.extend(cap(end * outer, end * inner, random));
    shapes.push(arc(DVec2::X * inner, DVec2::ZERO, true));
    shapes.extend(cap(DVec2::X * inner, DVec2::X * outer, random));
    (Sketch::closed(DVec2::X * outer, shapes), radius)
}

/// A walk along the lines of a lattice, often along one it went before, and the tool as wide as a
/// mesh or half of it.
pub(super) fn lattice(random: &mut Random) -> (Sketch, f64) {
    let mesh = 10.0;
    let start = DVec2::ZERO;
    let mut at = start;
    let mut points = vec![start];
    for _ in 0..4 + random.index(20) {
        let along = [DVec2::X, DVec2::Y, -DVec2::X, -DVec2::Y][random.index(4)];
        at += along * mesh * (1 + random.index(3)) as f64;
        points.push(at);
    }
    let radius = match random.index(4) {
        0 => 0.5 * mesh * about_one(random),
        1 => mesh * about_one(random),
        2 => 0.25 * mesh,
        _ => any_radius(random),
    };
    if random.coin() {
        points.push(p(0.0, at.y));
        points.push(start);
        points.dedup();
        if points.len() > 3 {
            return (Sketch::closed(start, points[1..].iter().map(|&to| line(to))), radius);
        }
    }
    points.dedup();
    (Sketch::open(start, points[1..].iter().map(|&to| line(to))), radius)
}

/// A comb with slots narrower than the tool, as wide as it, and wider.
pub(super) fn comb(random: &mut Random) -> (Sketch, f64) {
    let radius = if random.coin() { 2.0 } else { random.within(0.5, 6.0) };
    let mut points = vec![p(0.0, 0.0)];
    let mut x = 0.0;
    for _ in 0..2 + random.index(5) {
        let deep = radius * random.within(0.1, 6.0);
        let times = [0.3, 0.9, 1.0, 1.0, about_one(random), 1.2, 3.0][random.index(7)];
        x += radius * [0.1, 0.5, 1.0, 2.0][random.index(4)];
        points.push(p(x, 0.0));
        points.push(p(x, -deep));
        x += 2.0 * radius * times;
        points.push(p(x, -deep));
        points.push(p(x, 0.0));
    }
    x += radius;
    points.push(p(x, 0.0));
    let sketch = if random.coin() {
        Sketch::open(points[0], points[1..].iter().map(|&to| line(to)))
    } else {
        points.extend([p(x, -10.0 * radius), p(0.0, -10.0 * radius)]);
        closed_polygon(&points)
    };
    (sketch, radius)
}

/// Two splines one tool apart, closed at their ends.
pub(super) fn parallel_splines(random: &mut Random) -> (Sketch, f64) {
    let radius = random.within(0.5, 6.0);
    let width = 2.0 * radius * about_one(random);
    let (mut at, mut heading) = (DVec2::ZERO, 0.0);
    let mut middle = vec![(at, heading)];
    for _ in 0..3 + random.index(6) {
        heading += random.within(-0.4, 0.4);
        at += DVec2::from_angle(heading) * random.within(1.0, 3.0) * radius;
        middle.push((at, heading));
    }
    let wall = |side: f64| -> Vec<DVec2> {
        let at = |(point, heading): &(DVec2, f64)| {
            *point + DVec2::from_angle(*heading).perp() * (0.5 * width * side)
        };
        middle.iter().map(at).collect()
    };
    let (right, mut left) = (wall(-1.0), wall(1.0));
    left.reverse();
    let shapes = [spline(&right[1..]), line(left[0]), spline(&left[1..]), line(right[0])];
    (Sketch::closed(right[0], shapes), radius)
}
