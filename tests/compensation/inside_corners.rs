//! Random inside corners, fitting and not: no local gouge goes without a word.

use g41::compensation::{CornerStyle, Options};
use g41::contour::{Shape, Side};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::judge::{field_of, in_one_piece, samples};
use super::sketch::{Sketch, arc, line, spline};
use crate::common::random::Random;

const CASES: u32 = if cfg!(target_arch = "wasm32") { 300 } else { 5000 };

/// A leg from the origin along `along` that turns by less than half a circle.
fn leg(random: &mut Random, along: DVec2) -> Shape {
    let length = random.within(0.5, 20.0);
    match random.index(3) {
        0 => line(along * length),
        1 => {
            let bend = random.within(1.0, 30.0) * random.sign();
            let center = along.perp() * bend;
            let turn = DVec2::from_angle(random.within(0.1, 1.5) * bend.signum());
            arc(center - turn.rotate(center), center, bend < 0.0)
        }
        _ => {
            let turn = DVec2::from_angle(random.within(-0.6, 0.6));
            let (mut at, mut way, mut points) = (DVec2::ZERO, along, Vec::new());
            for _ in 0..3 {
                at += way * length / 3.0;
                way = turn.rotate(way);
                points.push(at);
            }
            spline(&points)
        }
    }
}

/// Whether the two segments come near each other again away from their corner, as far as the tool
/// is concerned: then the gouge is a bottleneck, and not of this corner.
fn comes_back(sketch: &Sketch, radius: f64) -> bool {
    let contour = sketch.contour();
    let points = |i: usize| {
        let curve = &contour.segments()[i].curve;
        (0..=60).map(|k| curve.point(f64::from(k) / 60.0)).collect::<Vec<_>>()
    };
    let (first, second) = (points(0), points(1));
    // Distances between both grow with the way from the corner, unless they come back.
    let farthest = |points: &[DVec2], near: &[DVec2]| {
        let gap = |p: &DVec2| near.iter().map(|q| q.distance(*p)).fold(f64::INFINITY, f64::min);
        let gaps: Vec<f64> = points.iter().map(gap).collect();
        let mut most: f64 = 0.0;
        gaps.iter().any(|gap| {
            most = most.max(*gap);
            *gap < most - 0.05 * radius
        })
    };
    let back: Vec<DVec2> = first.iter().rev().copied().collect();
    farthest(&back, &second) || farthest(&second, &first)
}

#[test]
fn no_gouge_of_an_inside_corner_goes_without_a_word() {
    let mut random = Random::new(601);
    let (mut clear, mut told) = (0, 0);
    for case in 0..CASES {
        let side = if random.coin() { Side::Left } else { Side::Right };
        let turn = side.sign() * random.within(0.05, 2.9);
        let incoming = leg(&mut random, DVec2::NEG_X);
        let outgoing = leg(&mut random, DVec2::from_angle(turn));
        let mut sketch = Sketch::open(DVec2::ZERO, [incoming]).reversed();
        sketch.shapes.push(outgoing);
        let radius = random.within(0.2, 8.0);
        let corner = if random.coin() { CornerStyle::Linear } else { CornerStyle::Arc };
        let options = Options { corner, ..Options::default() };
        let path = sketch.compensated(side, radius, &options);
        let what = format!("case {case}, {side:?}, r {radius}, {corner:?}: {sketch:?}");
        in_one_piece(&path, &what);
        let field = field_of(&sketch.contour());
        let depth = |point: DVec2| radius - field.distance(point);
        let deepest = samples(&path, 60).into_iter().map(depth).fold(0.0, f64::max);
        if deepest < 0.01 {
            clear += 1;
            continue;
        }
        if comes_back(&sketch, radius) {
            continue;
        }
        told += 1;
        assert!(!path.gouges.is_empty(), "{what}: {deepest} mm deep and not a word");
    }
    assert!(clear > CASES / 5 && told > CASES / 5, "{clear} clear and {told} told of {CASES}");
}
