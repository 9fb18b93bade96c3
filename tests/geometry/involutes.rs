//! Involutes against their definition, closed forms and brute force.

use std::f64::consts::{FRAC_PI_2, PI};

use g41::geometry::intersect::{Intersections, arc_cubic, cubic_cubic, involute_with, line_cubic};
use g41::geometry::{Curve, CurveError, Involute, cross};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::shapes;
use crate::common::oracle::Plain;
use crate::common::random::Random;
use crate::common::{near, near_point, p};

const CASES: u32 = if cfg!(target_arch = "wasm32") { 100 } else { 1000 };

/// The involute of the circle of radius 10 about the origin that begins on +x and leads outward
/// counter-clockwise, between two rolls.
fn plain(from: f64, to: f64) -> Involute {
    let at = |roll: f64| {
        let leaves = DVec2::from_angle(roll);
        (leaves - leaves.perp() * roll) * 10.0
    };
    Involute::new(at(from), at(to), DVec2::ZERO, 10.0, to < from, 1e-9).expect("it is one")
}

#[test]
fn the_unit_involute_is_where_a_thread_puts_it() {
    // A quarter turn has come off: the thread is at (0, 10) and leads to the right, 5π long.
    let quarter = plain(0.0, FRAC_PI_2);
    near_point(quarter.start(), p(10.0, 0.0), 1e-14, "on the circle");
    near_point(quarter.end(), p(5.0 * PI, 10.0), 1e-13, "off it");
    near_point(quarter.tangent(0.0), p(1.0, 0.0), 1e-14, "away from the circle");
    near_point(quarter.tangent(1.0), p(0.0, 1.0), 1e-14, "across the thread");
    near(quarter.length(), 5.0 * FRAC_PI_2 * FRAC_PI_2, 1e-13, "R φ² / 2");
    near(quarter.curvature(1.0), 1.0 / (5.0 * PI), 1e-15, "1 / thread");
    assert!(quarter.curvature(0.0) == f64::INFINITY, "no radius on the circle");
    assert!(!quarter.is_clockwise() && quarter.reversed().is_clockwise(), "senses");
}

#[test]
fn the_parameter_is_the_part_of_the_arc_length() {
    let mut random = Random::new(901);
    for case in 0..CASES {
        let (involute, at) = shapes::involute(&mut random, 40.0);
        let what = format!("case {case}: {involute:?}");
        let [from, to] = involute.rolls();
        let radius = involute.base_radius();
        near(involute.length(), 0.5 * radius * (to * to - from * from).abs(), 1e-9, &what);
        // By Simpson's rule for |dP/dφ| on the truth, whose speed is Rφ: exact.
        let t = random.unit();
        let roll = (from * from + t * (to * to - from * from)).max(0.0).sqrt();
        near_point(involute.point(t), at(roll), 1e-9, &what);
        let length: f64 = {
            let n = 2000;
            let point = |i: i32| at(from + (roll - from) * f64::from(i) / f64::from(n));
            (0..n).map(|i| point(i).distance(point(i + 1))).sum()
        };
        near(length, t * involute.length(), 1e-5 * (1.0 + involute.length()), &what);
        let h = 1e-4;
        if t > 0.05 && t < 0.95 && roll > 0.1 {
            let [before, here, after] = [t - h, t, t + h].map(|t| involute.point(t));
            let speed = (after - before) / (2.0 * h);
            let tangent = speed.normalize();
            near_point(involute.tangent(t), tangent, 1e-5, &what);
            near(speed.length(), involute.length(), 1e-4 * involute.length(), &what);
            let bend = (after - here * 2.0 + before) / (h * h);
            let curvature = cross(speed, bend) / speed.length().powi(3);
            near(involute.curvature(t), curvature, 1e-3 * curvature.abs() + 1e-6, &what);
            near_point(
                involute.tangent(t),
                involute
                    .tangent(0.0)
                    .rotate(DVec2::from_angle(involute.turn() * (roll - from) / (to - from))),
                1e-9,
                &what,
            );
        }
        let back = involute.reversed();
        near_point(back.point(1.0 - t), involute.point(t), 1e-9, &what);
        near_point(back.tangent(1.0 - t), -involute.tangent(t), 1e-9, &what);
        near(back.length_share(0.3), 1.0 - involute.length_share(0.7), 1e-9, &what);
    }
}

#[test]
fn ends_that_are_rounded_are_met_and_the_curve_stays_near() {
    let mut random = Random::new(902);
    let mut by_radius = 0;
    for case in 0..CASES {
        let (truth, _) = shapes::involute(&mut random, 40.0);
        let off = 10_f64.powf(random.within(-6.0, -2.0));
        let (start, end) = (truth.start() + random.point(off), truth.end() + random.point(off));
        let center = truth.center() + random.point(off);
        let radius = truth.base_radius() + random.within(-off, off);
        if start.distance(end) < 20.0 * off {
            continue;
        }
        let made = Involute::new(start, end, center, radius, truth.is_clockwise(), 20.0 * off);
        let what = format!("case {case}: off {off} of {truth:?}");
        let made = made.unwrap_or_else(|error| panic!("{what}: {error}"));
        near_point(made.start(), start, 1e-9, &what);
        near_point(made.end(), end, 1e-9, &what);
        by_radius += u32::from(made.center() == center);
        let plain = Plain::of_involute(&truth);
        let allowed = 40.0 * off * (1.0 + truth.turn().abs());
        for i in 0..=20 {
            let point = made.point(f64::from(i) / 20.0);
            near(plain.distance(point, 400), 0.0, allowed, &what);
        }
    }
    assert!(by_radius > CASES / 2, "{by_radius} keep their centre");
}

#[test]
fn what_is_no_involute_is_told_why() {
    let make = |start, end, center, radius| {
        Involute::new(start, end, center, radius, false, 1e-3).expect_err("it is none")
    };
    let (start, end) = (plain(0.5, 1.0).start(), plain(0.5, 1.0).end());
    let o = DVec2::ZERO;
    for radius in [0.0, -10.0, 1e-4, f64::NAN, 0.01] {
        let found = make(start, end, o, radius);
        assert!(matches!(found, CurveError::NoBaseCircle { .. }), "{radius}: {found:?}");
    }
    let far = plain(0.5, 1.0);
    let turns = make(far.start(), p(6300.0, 0.0), o, 10.0);
    assert!(matches!(turns, CurveError::NoBaseCircle { .. }), "over 100 turns: {turns:?}");
    assert!(
        matches!(make(p(9.9, 0.0), end, o, 10.0), CurveError::InsideBaseCircle { .. }),
        "start"
    );
    assert!(
        matches!(make(start, p(9.9, 0.0), o, 10.0), CurveError::InsideBaseCircle { .. }),
        "end"
    );
    let CurveError::OffInvolute { off } =
        make(start, end + far.tangent(1.0).perp() * 0.01, o, 10.0)
    else {
        panic!("the end is off");
    };
    near(off, 0.01, 1e-5, "by as much as it is off across the curve");
    assert!(
        matches!(make(start, start.perp(), o, 10.0), CurveError::OffInvolute { .. }),
        "one roll"
    );
    assert_eq!(make(start, start, o, 10.0), CurveError::ZeroLength, "no way");
    assert!(matches!(make(start, p(1e10, 0.0), o, 10.0), CurveError::OutOfRange { .. }), "far out");
}

#[test]
fn the_offset_is_everywhere_at_its_distance_also_beyond_its_cusp() {
    let mut random = Random::new(903);
    let (mut cusps, mut reversed) = (0, 0);
    for case in 0..CASES {
        let (involute, _) = shapes::involute(&mut random, 40.0);
        let offset = random.within(0.01, 30.0) * random.sign();
        let what = format!("case {case}: {offset} beside {involute:?}");
        let mut pieces = Vec::new();
        involute.offset(offset, &mut |piece| pieces.push(piece));
        assert!((1..=2).contains(&pieces.len()), "{what}: {pieces:?}");
        cusps += u32::from(pieces.len() == 2);
        let side = |t: f64| involute.point(t) + involute.tangent(t).perp() * offset;
        near_point(pieces[0].start(), side(0.0), 1e-8, &what);
        near_point(pieces[pieces.len() - 1].end(), side(1.0), 1e-8, &what);
        let plain = Plain::of_involute(&involute);
        for piece in &pieces {
            near_point(piece.center(), involute.center(), 0.0, &what);
            near(piece.base_radius(), involute.base_radius(), 0.0, &what);
            for i in 0..=8 {
                let t = f64::from(i) / 8.0;
                let (point, tangent) = (piece.point(t), piece.tangent(t));
                // The normal hits the curve at the offset, on the one side or, run back, the other.
                let feet = [point - tangent.perp() * offset, point + tangent.perp() * offset];
                let off = feet.map(|foot| plain.distance(foot, 600));
                near(off[0].min(off[1]), 0.0, 1e-7, &what);
                let bends =
                    offset * involute.curvature(if involute.is_outward() { 0.0 } else { 1.0 });
                if bends < 1.0 && involute.turn().abs() < 3.0 {
                    assert!(off[0] <= 1e-7, "{what}: it runs as the curve");
                    near(involute.nearest(point).distance, offset.abs(), 1e-7, &what);
                }
            }
        }
        if pieces.len() == 2 {
            near_point(pieces[0].end(), pieces[1].start(), 1e-9, &what);
            let cusp = pieces[0].end().distance(involute.center());
            near(cusp, involute.base_radius(), 1e-9, &what);
            near_point(pieces[0].tangent(1.0), -pieces[1].tangent(0.0), 1e-9, &what);
        } else {
            reversed += u32::from(pieces[0].is_outward() != involute.is_outward());
        }
        // There and back again.
        if let [piece] = pieces[..]
            && piece.is_outward() == involute.is_outward()
        {
            let mut back = Vec::new();
            piece.offset(-offset, &mut |piece| back.push(piece));
            for i in 0..=4 {
                let t = f64::from(i) / 4.0;
                near_point(back[0].point(t), involute.point(t), 1e-7, &what);
            }
        }
    }
    assert!(cusps > CASES / 20 && reversed > CASES / 20, "{cusps} cusps, {reversed} reversed");
}

#[test]
fn no_point_is_nearer_and_none_outside_the_box() {
    let mut random = Random::new(904);
    for case in 0..CASES {
        let (involute, _) = shapes::involute(&mut random, 20.0);
        let what = format!("case {case}: {involute:?}");
        let plain = Plain::of_involute(&involute);
        let point = random.point(80.0);
        let found = Curve::Involute(involute).nearest(point);
        near_point(found.point, involute.point(found.t), 1e-9, &what);
        near(found.distance, plain.distance(point, 1500), 1e-8, &what);
        let on = involute.point(random.unit());
        near(involute.nearest(on).distance, 0.0, 1e-9, &what);
        let bounds = involute.bounds();
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for point in plain.sampled(4000) {
            (low, high) = (low.min(point), high.max(point));
            assert!(bounds.inflated(1e-9).distance(point) == 0.0, "{what}: {point} outside");
        }
        let chord = involute.length() / 4000.0;
        near_point(bounds.min, low, chord, &what);
        near_point(bounds.max, high, chord, &what);
    }
}

#[test]
fn chords_and_cubics_are_within_the_tolerance() {
    let mut random = Random::new(905);
    let mut cubics = 0;
    for case in 0..CASES / 4 {
        let (involute, _) = shapes::involute(&mut random, 40.0);
        let tolerance = 10_f64.powf(random.within(-6.0, -1.0));
        let what = format!("case {case}: {tolerance} of {involute:?}");
        let plain = Plain::of_involute(&involute);
        let mut from = involute.start();
        let mut chords = 0;
        involute.flatten(tolerance, &mut |to| {
            chords += 1;
            if chords < 200 {
                let middle = from.midpoint(to);
                let off = involute.nearest(middle).distance;
                assert!(off <= tolerance * (1.0 + 1e-6), "{what}: chord {off}");
            }
            near(involute.nearest(to).distance, 0.0, 1e-8, &what);
            from = to;
        });
        near_point(from, involute.end(), 1e-9, &what);
        let found = involute.cubics(tolerance);
        cubics += found.len();
        near_point(found[0].start(), involute.start(), 0.0, &what);
        let mut tangent = involute.tangent(0.0);
        let mut at = involute.start();
        let count = found.len();
        for (i, cubic) in found.iter().enumerate() {
            near_point(cubic.start(), at, 0.0, &what);
            near_point(cubic.tangent(0.0), tangent, 1e-6, &what);
            (tangent, at) = (cubic.tangent(1.0), cubic.end());
            assert!(cubic.hodograph().iter().all(|v| v.length() > 0.0), "{what}: it stands still");
            if i < 40 || i + 1 == count {
                for k in 1..8 {
                    let point = cubic.point(f64::from(k) / 8.0);
                    let off = plain.distance(point, 400);
                    assert!(off <= tolerance + 1e-9, "{what}: cubic {i} is {off} off");
                }
            }
        }
        near_point(at, involute.end(), 0.0, &what);
        near_point(tangent, involute.tangent(1.0), 1e-9, &what);
        let spline = involute.spline(tolerance);
        assert_eq!(spline.pieces(), &found[..], "{what}");
    }
    assert!(cubics > 100, "{cubics} cubics");
}

/// Samples in a box.
const BLOCK: usize = 20;

/// Crossings of two sampled curves: points where they cross between samples.
fn by_brute_force(a: &Plain, b: &Plain, count: usize) -> Vec<DVec2> {
    let (a, b) = (a.sampled(count), b.sampled(count));
    let mut found = Vec::new();
    let boxes = |points: &[DVec2]| -> Vec<(DVec2, DVec2)> {
        (0..(points.len() - 1).div_ceil(BLOCK))
            .map(|k| &points[k * BLOCK..((k + 1) * BLOCK + 1).min(points.len())])
            .map(|part| {
                let low = part.iter().copied().fold(DVec2::INFINITY, DVec2::min);
                (low, part.iter().copied().fold(DVec2::NEG_INFINITY, DVec2::max))
            })
            .collect()
    };
    let (boxes_a, boxes_b) = (boxes(&a), boxes(&b));
    for (i, (low_a, high_a)) in boxes_a.iter().enumerate() {
        for (j, (low_b, high_b)) in boxes_b.iter().enumerate() {
            if !(low_a.cmple(*high_b).all() && low_b.cmple(*high_a).all()) {
                continue;
            }
            for k in i * BLOCK..((i + 1) * BLOCK).min(a.len() - 1) {
                for l in j * BLOCK..((j + 1) * BLOCK).min(b.len() - 1) {
                    let (va, vb, w) = (a[k + 1] - a[k], b[l + 1] - b[l], b[l] - a[k]);
                    let area = cross(va, vb);
                    let (s, t) = (cross(w, vb) / area, cross(w, va) / area);
                    if (0.0..1.0).contains(&s) && (0.0..1.0).contains(&t) {
                        found.push(a[k] + va * s);
                    }
                }
            }
        }
    }
    found
}

#[test]
fn it_crosses_every_other_curve_where_samples_do() {
    let mut random = Random::new(906);
    let mut crossings = [0; 4];
    for case in 0..2 * CASES {
        let (a, _) = shapes::involute(&mut random, 15.0);
        let kind = random.index(4);
        let (plain, meets): (Plain, Intersections) = match kind {
            0 => {
                let line = shapes::line(&mut random, 40.0);
                let with = involute_with(&a, &line.bounds(), &|cubic| {
                    line_cubic(&line, cubic).exchanged()
                });
                (Plain::of_line(&line), with)
            }
            1 => {
                let arc = shapes::arc(&mut random, 25.0);
                let with =
                    involute_with(&a, &arc.bounds(), &|cubic| arc_cubic(&arc, cubic).exchanged());
                (Plain::of_arc(&arc), with)
            }
            2 => {
                let other = shapes::cubic(&mut random, 40.0);
                let with = involute_with(&a, &other.bounds(), &|cubic| cubic_cubic(cubic, &other));
                (Plain::of_cubic(&other), with)
            }
            _ => {
                let (other, _) = shapes::involute(&mut random, 15.0);
                let with = involute_with(&a, &other.bounds(), &|first| {
                    involute_with(&other, &first.hull_bounds(), &|second| {
                        cubic_cubic(second, first)
                    })
                    .exchanged()
                });
                (Plain::of_involute(&other), with)
            }
        };
        let what = format!("case {case}: {a:?} and {plain:?}");
        let points = meets.points();
        let own = Plain::of_involute(&a);
        for crossing in &points {
            near_point(crossing.point, a.point(crossing.t), 1e-8, &what);
            near(plain.distance(crossing.point, 500), 0.0, 1e-8, &what);
        }
        let count = 2000;
        let sampled = by_brute_force(&own, &plain, count);
        crossings[kind] += sampled.len();
        // Near an end, or where they touch, samples may tell one more or one less.
        let sagitta = 1e-3 * (a.length() + 60.0) / 10.0;
        for point in &sampled {
            let nearest =
                points.iter().map(|c| c.point.distance(*point)).fold(f64::INFINITY, f64::min);
            assert!(nearest < 0.05, "{what}: {point} is missing in {points:?} ({nearest})");
        }
        let clear = |at: DVec2| {
            let others = points.iter().filter(|c| c.point.distance(at) > 1e-9);
            let ends = [a.start(), a.end(), plain.point(0.0), plain.point(1.0)];
            others.map(|c| c.point).chain(ends).all(|q| q.distance(at) > 50.0 * sagitta)
        };
        for crossing in points.iter().filter(|c| clear(c.point)) {
            let near = sampled.iter().filter(|q| q.distance(crossing.point) < 0.05).count();
            let tangent = a.tangent(crossing.t);
            let touches = {
                let side = |d: f64| {
                    let q = crossing.point + tangent * d;
                    plain.distance(q, 500)
                };
                side(0.02).max(side(-0.02)) < 1e-3
            };
            assert!(near == 1 || touches, "{what}: {crossing:?} is seen {near} times");
        }
    }
    assert!(crossings.iter().all(|&count| count > CASES as usize / 80), "{crossings:?} crossings");
}

#[test]
fn two_that_share_a_stretch_have_no_single_point() {
    let (a, b) = (plain(0.5, 1.5), plain(1.0, 2.0));
    let meets = involute_with(&a, &b.bounds(), &|first| {
        involute_with(&b, &first.hull_bounds(), &|second| cubic_cubic(second, first)).exchanged()
    });
    assert_eq!(meets, Intersections::Coincident, "they share a stretch");
    // Opposite hands about one circle cross on their axis of symmetry.
    let mirrored = plain(0.2, 4.0);
    let flip = |v: DVec2| p(-v.x, v.y);
    let other =
        Involute::new(flip(mirrored.start()), flip(mirrored.end()), DVec2::ZERO, 10.0, true, 1e-9)
            .expect("it is one");
    let meets = involute_with(&mirrored, &other.bounds(), &|first| {
        involute_with(&other, &first.hull_bounds(), &|second| cubic_cubic(second, first))
            .exchanged()
    });
    let points = meets.points();
    assert_eq!(points.len(), 1, "{points:?}");
    near(points[0].point.x, 0.0, 1e-9, "on the axis");
    near(points[0].t, points[0].u, 1e-9, "at the same place of both");
}
