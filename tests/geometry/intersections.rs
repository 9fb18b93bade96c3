//! Intersections of all six pairs against brute force; touching, coincident and ending curves.

use std::f64::consts::{PI, TAU};

use g41::geometry::intersect::{
    Crossing, Intersections, arc_arc, arc_cubic, cubic_cubic, line_arc, line_cubic, line_line,
};
use g41::geometry::{Arc, Cubic, Line};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::shapes;
use crate::common::oracle::Plain;
use crate::common::p;
use crate::common::random::Random;

const SAMPLES: usize = 1024;
const BLOCK: usize = 32;

/// Places where the polylines of two curves cross, as parameters of both.
fn brute_force(a: &Plain, b: &Plain) -> Vec<(f64, f64)> {
    let (pa, pb) = (a.sampled(SAMPLES), b.sampled(SAMPLES));
    let boxes = |points: &[DVec2]| -> Vec<(DVec2, DVec2)> {
        (0..SAMPLES / BLOCK)
            .map(|k| &points[k * BLOCK..=(k + 1) * BLOCK])
            .map(|part| {
                let low = part.iter().copied().reduce(DVec2::min).expect("not empty");
                (low, part.iter().copied().reduce(DVec2::max).expect("not empty"))
            })
            .collect()
    };
    let mut found = Vec::new();
    let n = SAMPLES as f64;
    for (i, (low_a, high_a)) in boxes(&pa).into_iter().enumerate() {
        for (j, (low_b, high_b)) in boxes(&pb).into_iter().enumerate() {
            if !(low_a.cmple(high_b).all() && low_b.cmple(high_a).all()) {
                continue;
            }
            for k in i * BLOCK..(i + 1) * BLOCK {
                for l in j * BLOCK..(j + 1) * BLOCK {
                    let (va, vb, w) = (pa[k + 1] - pa[k], pb[l + 1] - pb[l], pb[l] - pa[k]);
                    let area = va.perp_dot(vb);
                    let (s, t) = (w.perp_dot(vb) / area, w.perp_dot(va) / area);
                    if (0.0..1.0).contains(&s) && (0.0..1.0).contains(&t) {
                        found.push(((k as f64 + s) / n, (l as f64 + t) / n));
                    }
                }
            }
        }
    }
    found
}

/// Asserts that every crossing found is one, that they are in order and told apart, and that each
/// clear crossing of the brute force is among them. Returns the number of those.
fn judge(a: &Plain, b: &Plain, found: &Intersections, what: &str) -> usize {
    let Intersections::Points(found) = found else {
        panic!("{what}: random curves do not coincide");
    };
    for crossing in found {
        let Crossing { point, t, u } = *crossing;
        assert!((0.0..=1.0).contains(&t) && (0.0..=1.0).contains(&u), "{what}: {crossing:?}");
        let off = a.point(t).distance(point).max(b.point(u).distance(point));
        assert!(off < 1e-7, "{what}: {crossing:?} is {off:e} off");
    }
    for pair in found.windows(2) {
        assert!(pair[0].t <= pair[1].t, "{what}: out of order, {found:?}");
        let apart = (pair[1].t - pair[0].t).max((pair[1].u - pair[0].u).abs());
        assert!(apart > 1e-12, "{what}: found twice, {found:?}");
    }
    let mut clear = 0;
    for (t, u) in brute_force(a, b) {
        let (ta, tb) = (a.derivative(t).normalize(), b.derivative(u).normalize());
        let inside = t.min(u) > 0.002 && t.max(u) < 0.998;
        if ta.perp_dot(tb).abs() < 0.05 || !inside {
            continue;
        }
        clear += 1;
        let at = a.point(t);
        let nearest = found.iter().map(|c| c.point.distance(at)).fold(f64::INFINITY, f64::min);
        // Chords of the sampling are up to 0.1 mm long and cross at 0.05 rad or more.
        assert!(nearest < 0.05, "{what}: the crossing near {at} is missing in {found:?}");
    }
    assert!(found.len() <= clear + 9, "{what}: {} found where {clear} are clear", found.len());
    clear
}

#[test]
fn every_clear_crossing_of_random_curves_is_found() {
    let mut random = Random::new(81);
    let mut clear = [0; 6];
    for case in 0..300 {
        let (line_a, line_b) = (shapes::line(&mut random, 30.0), shapes::line(&mut random, 30.0));
        let (arc_a, arc_b) = (shapes::arc(&mut random, 20.0), shapes::arc(&mut random, 20.0));
        let (cubic_a, cubic_b) =
            (shapes::cubic(&mut random, 30.0), shapes::cubic(&mut random, 30.0));
        let (la, lb) = (Plain::of_line(&line_a), Plain::of_line(&line_b));
        let (aa, ab) = (Plain::of_arc(&arc_a), Plain::of_arc(&arc_b));
        let (ca, cb) = (Plain::of_cubic(&cubic_a), Plain::of_cubic(&cubic_b));
        let pairs = [
            (la, lb, line_line(&line_a, &line_b), format!("{line_a:?} {line_b:?}")),
            (la, aa, line_arc(&line_a, &arc_a), format!("{line_a:?} {arc_a:?}")),
            (aa, ab, arc_arc(&arc_a, &arc_b), format!("{arc_a:?} {arc_b:?}")),
            (la, ca, line_cubic(&line_a, &cubic_a), format!("{line_a:?} {cubic_a:?}")),
            (aa, ca, arc_cubic(&arc_a, &cubic_a), format!("{arc_a:?} {cubic_a:?}")),
            (ca, cb, cubic_cubic(&cubic_a, &cubic_b), format!("{cubic_a:?} {cubic_b:?}")),
        ];
        for (i, (a, b, found, what)) in pairs.into_iter().enumerate() {
            clear[i] += judge(&a, &b, &found, &format!("case {case}: {what}"));
        }
    }
    assert!(clear.iter().all(|&count| count > 50), "too few crossings to judge by: {clear:?}");
}

#[test]
fn exchanging_the_curves_exchanges_the_parameters() {
    let mut random = Random::new(82);
    for case in 0..200 {
        let (a, b) = (shapes::arc(&mut random, 20.0), shapes::arc(&mut random, 20.0));
        let (one, other) = (arc_arc(&a, &b).points(), arc_arc(&b, &a).exchanged().points());
        assert_eq!(one.len(), other.len(), "case {case}: {a:?} {b:?}");
        let (a, b) = (shapes::cubic(&mut random, 20.0), shapes::cubic(&mut random, 20.0));
        let (one, other) = (cubic_cubic(&a, &b).points(), cubic_cubic(&b, &a).exchanged().points());
        assert_eq!(one.len(), other.len(), "case {case}: {a:?} {b:?}");
        for (x, y) in one.iter().zip(&other) {
            assert!(x.point.distance(y.point) < 1e-7, "case {case}: {x:?} and {y:?}");
        }
    }
}

fn only_near(found: Intersections, at: DVec2, slack: f64, what: &str) {
    let Intersections::Points(found) = found else { panic!("{what}: coincident") };
    assert!(!found.is_empty(), "{what}: the touch is lost");
    for crossing in found {
        let off = crossing.point.distance(at);
        assert!(off < slack, "{what}: {crossing:?} is {off:e} from the touch at {at}");
    }
}

#[test]
fn curves_that_touch_meet_at_the_touch() {
    let mut random = Random::new(83);
    for case in 0..200 {
        let (center, radius) = (random.point(50.0), random.within(0.5, 50.0));
        let out = random.direction();
        let at = center + out * radius;
        let start = center - out * radius;
        let circle = Arc::from_sweep(start, center, TAU * random.sign()).expect("a circle");
        let tangent = Line::new(at - out.perp() * 7.0, at + out.perp() * 4.0).expect("a line");
        // A rounding of 1e-14 R across the touch is √(2e-14) R ≈ 1.4e-7 R along it; the slack of
        // 1e-9 mm is √(2e-9 R).
        let slack = 4e-7 * radius + 3.0 * (2e-9 * radius).sqrt();
        only_near(line_arc(&tangent, &circle), at, slack, &format!("case {case}: line, circle"));
        let other = random.within(0.5, 50.0);
        let outside =
            Arc::from_sweep(at + out * 2.0 * other, at + out * other, TAU).expect("a circle");
        let slack = 4e-6 * (radius + other);
        only_near(arc_arc(&circle, &outside), at, slack, &format!("case {case}: outside"));
        if other < 0.9 * radius {
            let inside =
                Arc::from_sweep(at - out * 2.0 * other, at - out * other, TAU).expect("a circle");
            let slack = slack * radius / (radius - other);
            only_near(arc_arc(&circle, &inside), at, slack, &format!("case {case}: inside"));
        }
    }
}

#[test]
fn cubics_that_touch_meet_at_the_touch() {
    let mut random = Random::new(84);
    for case in 0..100 {
        // A parabola with its apex at the origin, turned and moved: everything touches it there.
        let (bend, turn, origin) =
            (random.within(0.02, 0.5), random.direction(), random.point(9.0));
        let (left, right) = (random.within(1.0, 6.0), random.within(1.0, 6.0));
        let place = |v: DVec2| origin + turn.rotate(v);
        let blossom = |bend: f64, a: f64, b: f64, c: f64| {
            place(p((a + b + c) / 3.0, bend * (a * b + a * c + b * c) / 3.0))
        };
        let parabola = |bend: f64, a: f64, b: f64| {
            Cubic::new(
                blossom(bend, a, a, a),
                blossom(bend, a, a, b),
                blossom(bend, a, b, b),
                blossom(bend, b, b, b),
            )
        };
        let cubic = parabola(bend, -left, right);
        let line = Line::new(place(p(-8.0, 0.0)), place(p(5.0, 0.0))).expect("a line");
        only_near(line_cubic(&line, &cubic), origin, 1e-3, &format!("case {case}: line"));
        let radius = random.within(0.3, 3.0);
        let below = Arc::from_sweep(place(p(0.0, -2.0 * radius)), place(p(0.0, -radius)), TAU)
            .expect("a circle");
        only_near(arc_cubic(&below, &cubic), origin, 1e-3, &format!("case {case}: arc"));
        let other = parabola(-random.within(0.02, 0.5), -left, right);
        only_near(cubic_cubic(&cubic, &other), origin, 1e-3, &format!("case {case}: cubic"));
    }
}

#[test]
fn curves_that_share_a_stretch_coincide() {
    let line = |a: DVec2, b: DVec2| Line::new(a, b).expect("a line");
    let way = |s: f64| p(3.0, 1.0) + DVec2::from_angle(0.3) * s;
    for (from, to) in [(2.0, 8.0), (-5.0, 1.0), (-1.0, 11.0), (8.0, 2.0), (0.0, 10.0)] {
        let found = line_line(&line(way(0.0), way(10.0)), &line(way(from), way(to)));
        assert_eq!(found, Intersections::Coincident, "lines over {from} to {to}");
    }
    let arc = |from: f64, sweep: f64| {
        Arc::from_sweep(p(1.0, 2.0) + DVec2::from_angle(from) * 6.0, p(1.0, 2.0), sweep)
            .expect("an arc")
    };
    for (from, sweep) in [(0.5, 1.0), (-1.0, 2.0), (2.0, -1.5), (0.0, TAU), (0.0, 2.0), (2.0, -2.0)]
    {
        let found = arc_arc(&arc(0.0, 2.0), &arc(from, sweep));
        assert_eq!(found, Intersections::Coincident, "arcs from {from} over {sweep}");
    }
    let cubic = Cubic::new(p(0.0, 0.0), p(1.0, 3.0), p(4.0, -2.0), p(6.0, 1.0));
    for other in [cubic, cubic.reversed(), cubic.part(0.2, 0.7), cubic.part(0.9, 0.4)] {
        let found = cubic_cubic(&cubic, &other);
        assert_eq!(found, Intersections::Coincident, "a cubic and {other:?}");
    }
    let straight = Cubic::new(way(0.0), way(1.0), way(2.0), way(3.0));
    assert_eq!(
        line_cubic(&line(way(-1.0), way(2.0)), &straight),
        Intersections::Coincident,
        "a line and a straight cubic"
    );
}

#[test]
fn curves_apart_on_one_carrier_share_nothing_and_touching_ones_one_end() {
    let line = |a: DVec2, b: DVec2| Line::new(a, b).expect("a line");
    let way = |s: f64| p(3.0, 1.0) + DVec2::from_angle(0.3) * s;
    let base = line(way(0.0), way(10.0));
    for (from, to, ends) in [(11.0, 12.0, None), (10.0, 12.0, Some(10.0)), (-3.0, 0.0, Some(0.0))] {
        let found = line_line(&base, &line(way(from), way(to)));
        match ends {
            None => assert_eq!(found, Intersections::Points(Vec::new()), "lines apart"),
            Some(s) => only_near(found, way(s), 1e-9, "lines end to end"),
        }
    }
    let arc = |from: f64, sweep: f64| {
        Arc::from_sweep(p(1.0, 2.0) + DVec2::from_angle(from) * 6.0, p(1.0, 2.0), sweep)
            .expect("an arc")
    };
    let found = arc_arc(&arc(0.0, 2.0), &arc(2.5, 1.0));
    assert_eq!(found, Intersections::Points(Vec::new()), "arcs apart");
    let found = arc_arc(&arc(0.0, 2.0), &arc(2.0, 1.0));
    only_near(found, arc(0.0, 2.0).end(), 1e-8, "arcs end to end");
    let halves = arc_arc(&arc(0.0, PI), &arc(PI, PI)).points();
    assert_eq!(halves.len(), 2, "two halves of a circle share both ends: {halves:?}");
    let concentric = Arc::from_sweep(p(9.0, 2.0), p(1.0, 2.0), TAU).expect("an arc");
    let found = arc_arc(&arc(0.0, TAU), &concentric);
    assert_eq!(found, Intersections::Points(Vec::new()), "concentric circles");
}

#[test]
fn curves_meet_where_one_ends_on_the_other() {
    let mut random = Random::new(85);
    for case in 0..300 {
        let at = random.point(20.0);
        let line = Line::new(at, at + random.direction() * 8.0).expect("a line");
        let across = random.direction();
        let other_line = Line::new(at - across * 4.0, at + across * 3.0).expect("a line");
        let arc =
            Arc::from_sweep(at, at + random.point(9.0), random.within(-6.0, 6.0)).expect("an arc");
        let mut cubic = shapes::cubic(&mut random, 20.0);
        cubic.points[0] = at;
        let mut other = shapes::cubic(&mut random, 20.0);
        other.points[3] = at;
        for (name, found) in [
            ("line, line", line_line(&line, &other_line)),
            ("line, arc", line_arc(&line, &arc)),
            ("line across, arc", line_arc(&other_line, &arc)),
            ("line, cubic", line_cubic(&line, &cubic)),
            ("line across, cubic", line_cubic(&other_line, &cubic)),
            ("arc, cubic", arc_cubic(&arc, &cubic)),
            ("arc, cubic's end", arc_cubic(&arc, &other)),
            ("cubic, cubic's end", cubic_cubic(&cubic, &other)),
        ] {
            let found = found.points();
            let near = found.iter().any(|c| c.point.distance(at) < 1e-7);
            assert!(near, "case {case}: {name} do not meet at {at}: {found:?}");
        }
    }
}

#[test]
fn cubics_that_leave_a_common_end_side_by_side_meet_there() {
    // Their tangents at the common end are 1e-4 rad apart, and so they stay for a millimetre.
    let at = p(18.822_648_582_736_768, 12.486_721_352_198_472);
    let a = Cubic::new(
        at,
        p(1.266_298_238_303_093_6, -13.095_903_462_233_31),
        p(13.490_939_081_952_988, -6.642_072_533_119_428),
        p(-15.327_243_813_466_707, -6.870_079_020_809_934),
    );
    let b = Cubic::new(
        p(14.838_070_441_661_507, 6.290_237_903_835_518),
        p(6.954_042_591_201_968_5, -17.496_745_535_485_605),
        p(2.610_318_122_120_816, -11.134_121_987_864_605),
        at,
    );
    let Intersections::Points(found) = cubic_cubic(&a, &b) else { panic!("not one curve") };
    assert!(found.iter().any(|c| c.point.distance(at) < 1e-7), "the common end: {found:?}");
}
