//! Random curves of every kind for the tests of geometry.

use std::f64::consts::{PI, TAU};

use g41::geometry::{Arc, Cubic, EndCondition, Involute, Line, Parameter, Spline, SplineEnds};
use glam::DVec2;

use crate::common::random::Random;

pub(crate) fn line(random: &mut Random, reach: f64) -> Line {
    Line::new(random.point(reach), random.point(reach)).expect("random points differ")
}

pub(crate) fn arc(random: &mut Random, reach: f64) -> Arc {
    let sweep = match random.index(8) {
        0 => TAU,
        1 => PI,
        2 => random.within(1e-3, 0.1),
        _ => random.within(0.1, TAU),
    };
    Arc::from_sweep(random.point(reach), random.point(reach), sweep * random.sign())
        .expect("a random arc has a length")
}

/// An involute of a circle of up to `reach` mm, and the point of it at a roll.
pub(crate) fn involute(
    random: &mut Random,
    reach: f64,
) -> (Involute, impl Fn(f64) -> DVec2 + use<>) {
    let (center, radius) = (random.point(reach), random.within(0.02, 1.0) * reach);
    let (first, sense) = (random.within(0.0, TAU), random.sign());
    let at = move |roll: f64| {
        let leaves = DVec2::from_angle(first + sense * roll);
        center + leaves * radius - leaves.perp() * (sense * radius * roll)
    };
    let inner = if random.index(4) == 0 { 0.0 } else { random.within(0.0, 2.0) };
    let outer = inner
        + if random.index(4) == 0 { random.within(0.01, 9.0) } else { random.within(0.05, 1.0) };
    let outward = random.coin();
    let [from, to] = if outward { [inner, outer] } else { [outer, inner] };
    let clockwise = outward == (sense < 0.0);
    let involute = Involute::new(at(from), at(to), center, radius, clockwise, 1e-6);
    (involute.expect("it is one"), at)
}

pub(crate) fn cubic(random: &mut Random, reach: f64) -> Cubic {
    Cubic::new(random.point(reach), random.point(reach), random.point(reach), random.point(reach))
}

pub(crate) fn spline(random: &mut Random, reach: f64) -> Spline {
    let count = 3 + random.index(9);
    let mut points: Vec<_> = (0..count).map(|_| random.point(reach)).collect();
    let mut end = || {
        if random.coin() {
            EndCondition::Natural
        } else {
            EndCondition::Tangent(random.direction() * random.within(0.1, 10.0))
        }
    };
    let mut ends = SplineEnds::Open { start: end(), end: end() };
    let parameter = if random.coin() { Parameter::Chord } else { Parameter::Centripetal };
    if random.index(3) == 0 {
        points.push(points[0]);
        ends = SplineEnds::Periodic;
    }
    Spline::through(points, ends, parameter).expect("random points differ")
}
