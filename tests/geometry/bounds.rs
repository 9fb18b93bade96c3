//! Bounds against dense sampling.

use g41::geometry::{Bounds, Curve};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::shapes;
use crate::common::oracle::Plain;
use crate::common::p;
use crate::common::random::Random;

/// Asserts that `bounds` hold every sample and are nowhere larger than a sample's neighbourhood.
#[track_caller]
fn fit(bounds: Bounds, pieces: &[Plain], what: &str) {
    let points: Vec<_> = pieces.iter().flat_map(|piece| piece.sampled(4000)).collect();
    let sampled = Bounds::of(points);
    let outside = (bounds.min - sampled.min).max(sampled.max - bounds.max).max_element();
    assert!(outside <= 1e-11, "{what}: a sample is {outside:e} outside");
    let (low, high) = (sampled.min - bounds.min, bounds.max - sampled.max);
    // Sampling misses an extreme by at most |C''| / (8 · 4000²), and |C''| ≤ 2400 here.
    let room = low.max(high).max_element();
    assert!(room <= 2e-5, "{what}: larger than its samples by {room:e}");
}

#[test]
fn bounds_hold_the_curve_and_nothing_more() {
    let mut random = Random::new(41);
    for case in 0..200 {
        let line = shapes::line(&mut random, 50.0);
        fit(
            Curve::Line(line).bounds(),
            &[Plain::of_line(&line)],
            &format!("case {case}: {line:?}"),
        );
        let arc = shapes::arc(&mut random, 20.0);
        fit(Curve::Arc(arc).bounds(), &[Plain::of_arc(&arc)], &format!("case {case}: {arc:?}"));
        let cubic = shapes::cubic(&mut random, 50.0);
        fit(cubic.bounds(), &[Plain::of_cubic(&cubic)], &format!("case {case}: {cubic:?}"));
        let spline = shapes::spline(&mut random, 30.0);
        let pieces: Vec<_> = spline.pieces().iter().map(Plain::of_cubic).collect();
        fit(Curve::Spline(spline).bounds(), &pieces, &format!("case {case}: spline"));
    }
}

#[test]
fn distance_to_a_box_is_zero_inside_and_the_nearest_side_or_corner_outside() {
    let bounds = Bounds::of([p(-1.0, 2.0), p(3.0, 5.0)]);
    for (at, distance) in [
        (p(0.0, 3.0), 0.0),
        (p(-1.0, 5.0), 0.0),
        (p(7.0, 3.0), 4.0),
        (p(0.0, 0.0), 2.0),
        (p(6.0, 9.0), 5.0),
        (p(-4.0, -2.0), 5.0),
    ] {
        assert_eq!(bounds.distance(at), distance, "distance from {at}");
    }
    assert!(Bounds::EMPTY.is_empty(), "the empty box");
    assert_eq!(Bounds::EMPTY.union(bounds), bounds, "union with nothing");
    assert!(!Bounds::EMPTY.meets(&bounds), "nothing meets nothing");
    assert!(bounds.meets(&Bounds::of([p(3.0, 5.0), p(4.0, 6.0)])), "touching at a corner");
}
