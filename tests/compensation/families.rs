//! Families of seeded contours that avoidance finds hard: everything touches, coincides or collapses.
//!
//! Each family aims at one weakness. Where it matters the radius belongs to the shape: walls are
//! exactly one tool apart, bends exactly as tight as the tool, edges lie exactly on each other.

use std::f64::consts::{FRAC_PI_2, TAU};

use g41::compensation::CornerStyle;
use g41::contour::{Attributes, Tool};
use g41::contour::{Contour, ContourBuilder, Shape, Side, SplineShape};
use g41::diagnostic::Origin;
use glam::DVec2;

use super::random_contours::{star, wandering};
use super::sketch::{Sketch, arc, line, spline};
use super::walls::{comb, concentric_walls, corridor, lattice, parallel_splines};
use crate::common::p;
use crate::common::random::Random;

/// One contour with the tool that is to go along it.
#[derive(Debug, Clone)]
pub(crate) struct Case {
    #[cfg_attr(target_arch = "wasm32", expect(dead_code, reason = "for tables of native runs"))]
    pub(crate) family: &'static str,
    pub(crate) sketch: Sketch,
    pub(crate) radius: f64,
    pub(crate) side: Side,
    pub(crate) tolerance: f64,
    pub(crate) corner: CornerStyle,
}

type Family = fn(&mut Random) -> (Sketch, f64);

const FAMILIES: [(&str, Family); 18] = [
    ("wandering", |random| (wandering(random), any_radius(random))),
    ("star", |random| (star(random), any_radius(random))),
    ("tangle", tangle),
    ("corridor", corridor),
    ("concentric walls", concentric_walls),
    ("there and back", there_and_back),
    ("keyhole", keyhole),
    ("collapse", collapse),
    ("tangent arcs", tangent_arcs),
    ("spikes", spikes),
    ("near duplicates", near_duplicates),
    ("looping splines", looping_splines),
    ("lattice", lattice),
    ("comb", comb),
    ("circles on a line", circles_on_a_line),
    ("twice round", twice_round),
    ("parallel splines", parallel_splines),
    ("long", long),
];

impl Case {
    /// The case of a seed, always the same.
    pub(crate) fn of(seed: u64) -> Self {
        let mut random = Random::new(seed.wrapping_mul(0x2545_f491_4f6c_dd1d));
        let (family, make) = FAMILIES[random.index(FAMILIES.len())];
        let (sketch, radius) = make(&mut random);
        // Half of them in general position: axis-parallel ones keep exact coordinates.
        let sketch = if random.coin() {
            sketch
        } else {
            let (turn, shift) = (random.direction(), random.point(200.0));
            sketch.mapped(false, |point| turn.rotate(point) + shift)
        };
        let side = if random.coin() { Side::Left } else { Side::Right };
        let tolerance = [1e-3, 1e-3, 1e-2, 1e-4, 1e-5][random.index(5)];
        let corner = if random.coin() { CornerStyle::Arc } else { CornerStyle::Linear };
        Self { family, sketch, radius, side, tolerance, corner }
    }

    /// The contour, whatever its builder complains about; `None` if nothing of it can be made.
    pub(crate) fn contour(&self) -> Option<Contour> {
        let mut builder = ContourBuilder::new(self.sketch.start);
        for (index, shape) in (0_u32..).zip(&self.sketch.shapes) {
            builder.segment(shape.clone(), Attributes::at(Origin::Segment(index)));
        }
        builder.build(self.sketch.closed).contour
    }

    pub(crate) fn tool(&self) -> Tool {
        Tool::new(self.radius, self.side).expect("the families have finite radii")
    }
}

/// From far smaller than a part of 100 mm to larger than it.
pub(super) fn any_radius(random: &mut Random) -> f64 {
    10.0_f64.powf(random.within(-3.0, 2.5))
}

/// One, or so near to it that the difference is a matter of rounding or of the tolerance.
pub(super) fn about_one(random: &mut Random) -> f64 {
    let off = [0.0, 0.0, 1e-15, 1e-12, 1e-9, 1e-7, 1e-5, 1e-4, 1e-3, 1e-2][random.index(10)];
    1.0 + off * random.sign()
}

pub(super) fn closed_polygon(points: &[DVec2]) -> Sketch {
    let ends = points[1..].iter().chain(&points[..1]);
    Sketch::closed(points[0], ends.map(|&to| line(to)))
}

/// An arc from `from` with a heading, by its signed radius and the angle it turns.
fn turning(from: DVec2, heading: f64, bend: f64, angle: f64) -> Shape {
    let center = from + DVec2::from_angle(heading).perp() * bend;
    let sweep = angle * bend.signum();
    arc(center + DVec2::from_angle(sweep).rotate(from - center), center, bend < 0.0)
}

fn end_of(shape: &Shape) -> DVec2 {
    shape.end().expect("every shape of a family ends somewhere")
}

/// Segments of all kinds between points anywhere: the contour crosses itself many times.
fn tangle(random: &mut Random) -> (Sketch, f64) {
    let start = random.point(50.0);
    let mut from = start;
    let mut shapes = Vec::new();
    let count = 3 + random.index(8);
    let closed = random.coin();
    for i in 0..count {
        let to = if closed && i + 1 == count { start } else { random.point(50.0) };
        let chord = to - from;
        shapes.push(match random.index(3) {
            0 => line(to),
            1 => {
                let bend = chord.length() * random.within(0.501, 2.0) * random.sign();
                let off = (bend * bend - 0.25 * chord.length_squared()).sqrt() * random.sign();
                let center = from.midpoint(to) + chord.perp().normalize() * off;
                arc(to, center, random.coin())
            }
            _ => {
                let inner = 1 + random.index(5);
                let mut points: Vec<DVec2> = (0..inner).map(|_| random.point(50.0)).collect();
                points.push(to);
                spline(&points)
            }
        });
        from = to;
    }
    let sketch = if closed { Sketch::closed(start, shapes) } else { Sketch::open(start, shapes) };
    (sketch, any_radius(random))
}

/// A contour that comes back exactly on itself.
fn there_and_back(random: &mut Random) -> (Sketch, f64) {
    let there = wandering(random);
    let back = there.reversed();
    let mut shapes = there.shapes.clone();
    shapes.extend(back.shapes);
    let sketch = if random.coin() {
        Sketch::closed(there.start, shapes)
    } else {
        Sketch::open(there.start, shapes)
    };
    (sketch, any_radius(random))
}

/// An island joined to the boundary by a bridge without width.
fn keyhole(random: &mut Random) -> (Sketch, f64) {
    let radius = if random.coin() { 2.0 } else { any_radius(random) };
    let reach = random.within(15.0, 40.0);
    let hole = random.within(2.0, 10.0);
    let mut shapes = Vec::new();
    let start = p(reach, 0.0);
    shapes.push(line(p(hole, 0.0)));
    if random.coin() {
        shapes.push(arc(p(hole, 0.0), DVec2::ZERO, true));
    } else {
        shapes.extend([p(0.0, -hole), p(-hole, 0.0), p(0.0, hole), p(hole, 0.0)].map(line));
    }
    shapes.push(line(start));
    if random.coin() {
        shapes.push(arc(start, DVec2::ZERO, false));
    } else {
        let corners =
            [p(reach, reach), p(-reach, reach), p(-reach, -reach), p(reach, -reach), start];
        shapes.extend(corners.map(line));
    }
    (Sketch::closed(start, shapes), radius)
}

/// Shapes whose offset shrinks to a point or a line at exactly this radius.
fn collapse(random: &mut Random) -> (Sketch, f64) {
    let reach = if random.coin() { 10.0 } else { random.within(1.0, 40.0) };
    let radius = reach * about_one(random);
    let round = |count: usize| {
        let at = |i: usize| DVec2::from_angle(TAU * (i % count) as f64 / count as f64) * reach;
        Sketch::closed(at(0), (1..=count).map(|i| arc(at(i), DVec2::ZERO, false)))
    };
    let sketch = match random.index(6) {
        0 => round(1),
        1 => round(2 + random.index(4)),
        2 => {
            // A regular polygon about the circle.
            let count = 3 + random.index(6);
            let outer = reach / (0.5 * TAU / count as f64).cos();
            let corners: Vec<DVec2> = (0..count)
                .map(|i| DVec2::from_angle(TAU * i as f64 / count as f64) * outer)
                .collect();
            closed_polygon(&corners)
        }
        3 => {
            // A rectangle with two sides one tool apart.
            let long = reach * random.within(1.0, 4.0);
            closed_polygon(&[p(0.0, 0.0), p(long, 0.0), p(long, 2.0 * reach), p(0.0, 2.0 * reach)])
        }
        4 => {
            // A stadium whose ends are as round as the tool.
            let long = reach * random.within(0.1, 4.0);
            Sketch::closed(
                p(0.0, -reach),
                [
                    line(p(long, -reach)),
                    arc(p(long, reach), p(long, 0.0), false),
                    line(p(0.0, reach)),
                    arc(p(0.0, -reach), DVec2::ZERO, false),
                ],
            )
        }
        _ => rounded_rectangle(
            reach,
            random.within(0.1, 3.0) * reach,
            random.within(0.1, 3.0) * reach,
        ),
    };
    (sketch, radius)
}

/// A rectangle whose corners are rounded by `bend`, with straight sides of `long` and `wide`.
fn rounded_rectangle(bend: f64, long: f64, wide: f64) -> Sketch {
    let (x, y) = (long, wide);
    Sketch::closed(
        p(0.0, -bend),
        [
            line(p(x, -bend)),
            arc(p(x + bend, 0.0), p(x, 0.0), false),
            line(p(x + bend, y)),
            arc(p(x, y + bend), p(x, y), false),
            line(p(0.0, y + bend)),
            arc(p(-bend, y), p(0.0, y), false),
            line(p(-bend, 0.0)),
            arc(p(0.0, -bend), DVec2::ZERO, false),
        ],
    )
}

/// Arcs and lines that go on into each other, many as tight as the tool.
fn tangent_arcs(random: &mut Random) -> (Sketch, f64) {
    let radius = if random.coin() { 4.0 } else { random.within(0.5, 20.0) };
    let (start, mut heading) = (random.point(20.0), random.within(0.0, TAU));
    if random.coin() {
        heading = 0.0;
    }
    let mut at = start;
    let mut shapes = Vec::new();
    for _ in 0..2 + random.index(8) {
        if random.index(4) == 0 {
            let shape = line(at + DVec2::from_angle(heading) * random.within(0.1, 3.0) * radius);
            at = end_of(&shape);
            shapes.push(shape);
            continue;
        }
        let times = [1.0, 1.0, 0.5, 2.0, 3.0, random.within(0.1, 5.0)][random.index(6)];
        let bend = times * radius * about_one(random) * random.sign();
        let angle = if random.coin() { FRAC_PI_2 } else { random.within(0.1, 4.0) };
        let shape = turning(at, heading, bend, angle);
        heading += angle * bend.signum();
        at = end_of(&shape);
        shapes.push(shape);
    }
    (Sketch::open(start, shapes), radius)
}

/// A closed polygon with spikes and slits that come to nearly nothing.
fn spikes(random: &mut Random) -> (Sketch, f64) {
    let count = 3 + random.index(8);
    let mut corners = Vec::new();
    for i in 0..count {
        let angle = TAU * (i as f64 + random.within(-0.2, 0.2)) / count as f64;
        let half = 10.0_f64.powf(random.within(-7.0, -1.0));
        let (near, far) = (random.within(10.0, 20.0), random.within(1.0, 60.0));
        corners.push(DVec2::from_angle(angle - half) * near);
        corners.push(DVec2::from_angle(angle) * far);
        corners.push(DVec2::from_angle(angle + half) * near);
    }
    (closed_polygon(&corners), any_radius(random))
}

/// Contours with segments hardly longer than the least there can be.
fn near_duplicates(random: &mut Random) -> (Sketch, f64) {
    let sketch = if random.coin() { star(random) } else { wandering(random) };
    let mut shapes = Vec::new();
    let mut at = sketch.start;
    for shape in &sketch.shapes {
        if random.coin() {
            let short = 10.0_f64.powf(random.within(-8.5, -2.0));
            let aside = at + random.direction() * short;
            match shape {
                Shape::Line { .. } => {
                    shapes.push(line(aside));
                }
                Shape::Spline(spline) => {
                    let points = [&[aside], spline.points.as_slice()].concat();
                    at = end_of(shape);
                    shapes.push(Shape::Spline(SplineShape { points, ..spline.clone() }));
                    continue;
                }
                _ => {}
            }
        }
        at = end_of(shape);
        shapes.push(shape.clone());
    }
    (Sketch { shapes, ..sketch }, any_radius(random))
}

/// Splines through points anywhere, with loops, near-cusps, and places they visit twice.
fn looping_splines(random: &mut Random) -> (Sketch, f64) {
    let count = 4 + random.index(10);
    let mut points: Vec<DVec2> = (0..count)
        .map(|_| {
            let point = random.point(30.0);
            if random.coin() { point.round() } else { point }
        })
        .collect();
    if random.coin() {
        // Back to a place it was at before.
        points.push(points[random.index(count - 1)]);
    }
    if random.index(3) == 0 {
        // A needle: out and nearly back.
        let tip = points[points.len() - 1] + random.direction() * 20.0;
        let aside =
            points[points.len() - 1] + random.direction() * 10.0_f64.powf(random.within(-6.0, 0.0));
        points.extend([tip, aside]);
    }
    points.dedup_by(|a, b| a.distance(*b) < 1e-7);
    let start = points[0];
    let closed = random.coin() && points[points.len() - 1].distance(start) > 1e-7;
    if closed {
        points.push(start);
    }
    let sketch = if closed {
        Sketch::closed(start, [spline(&points[1..])])
    } else {
        Sketch::open(start, [spline(&points[1..])])
    };
    (sketch, any_radius(random))
}

/// Full circles that begin and end on a line, some as large as the tool, some tangent to it.
fn circles_on_a_line(random: &mut Random) -> (Sketch, f64) {
    let radius = if random.coin() { 2.0 } else { any_radius(random) };
    let mut at = DVec2::ZERO;
    let mut shapes = Vec::new();
    for _ in 0..=random.index(4) {
        let to = at + DVec2::X * random.within(0.5, 10.0) * radius.min(20.0);
        shapes.push(line(to));
        at = to;
        let bend = radius * [1.0, about_one(random), 2.0, random.within(0.1, 4.0)][random.index(4)];
        let aside = if random.coin() { DVec2::Y * random.sign() } else { random.direction() };
        shapes.push(arc(at, at + aside * bend, random.coin()));
        if random.index(4) == 0 {
            // Hardly an arc at all.
            let shape =
                turning(at, 0.0, 50.0 * random.sign(), 10.0_f64.powf(random.within(-8.0, -1.0)));
            at = end_of(&shape);
            shapes.push(shape);
        }
    }
    (Sketch::open(DVec2::ZERO, shapes), radius)
}

/// A closed contour run twice, exactly on itself.
fn twice_round(random: &mut Random) -> (Sketch, f64) {
    let (once, radius) = match random.index(3) {
        0 => (star(random), any_radius(random)),
        1 => collapse(random),
        _ => corridor(random),
    };
    let shapes = [once.shapes.as_slice(), once.shapes.as_slice()].concat();
    (Sketch { shapes, ..once }, radius)
}

/// Many segments: a wave of lines, arcs or one spline, closed round a circle or open.
fn long(random: &mut Random) -> (Sketch, f64) {
    let count = 40 + random.index(120);
    let high = random.within(0.5, 15.0);
    let waves = 3 + random.index(count / 4);
    let middle = 3.0 * count as f64 / TAU;
    let at = |i: usize| {
        let angle = TAU * (i % count) as f64 / count as f64;
        DVec2::from_angle(angle) * (middle + high * (waves as f64 * angle).sin())
    };
    let points: Vec<DVec2> = (0..=count).map(at).collect();
    let shapes: Vec<Shape> = match random.index(3) {
        0 => vec![spline(&points[1..])],
        1 => points[1..].iter().map(|&to| line(to)).collect(),
        _ => points
            .windows(2)
            .map(|pair| {
                let chord = pair[1] - pair[0];
                let side = random.sign();
                let off = random.within(0.3, 3.0);
                let center = pair[0].midpoint(pair[1]) + chord.perp() * (off * side);
                arc(pair[1], center, side < 0.0)
            })
            .collect(),
    };
    (Sketch::closed(points[0], shapes), any_radius(random))
}
