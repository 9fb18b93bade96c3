//! Polylines of arcs and cubics against dense sampling.

use g41::geometry::{flatten_arc, flatten_cubic};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::shapes;
use crate::common::oracle::Plain;
use crate::common::random::Random;

/// Asserts that every sample of the curve is within `tolerance` of the chords, that every vertex is
/// on the curve, and that there are not many more chords than needed.
fn judge(curve: &Plain, chords: &[DVec2], tolerance: f64, what: &str) {
    for vertex in chords {
        let off = curve.distance(*vertex, 200);
        assert!(off < 1e-9, "{what}: vertex {vertex} is {off:e} off the curve");
    }
    for sample in curve.sampled(300) {
        let nearest = chords
            .windows(2)
            .map(|pair| Plain::Line(pair[0], pair[1]))
            .map(|chord| segment_distance(&chord, sample))
            .fold(f64::INFINITY, f64::min);
        assert!(nearest <= tolerance * (1.0 + 1e-9) + 1e-12, "{what}: {nearest:e} from its chords");
    }
}

fn segment_distance(chord: &Plain, point: DVec2) -> f64 {
    let Plain::Line(a, b) = *chord else { return f64::INFINITY };
    let v = b - a;
    let t = if v == DVec2::ZERO { 0.0 } else { (point - a).dot(v) / v.length_squared() };
    point.distance(a + v * t.clamp(0.0, 1.0))
}

#[test]
fn chords_keep_the_tolerance_and_end_at_the_end() {
    let mut random = Random::new(61);
    for case in 0..40 {
        for tolerance in [1.0, 1e-1, 1e-2, 1e-3] {
            let arc = shapes::arc(&mut random, 20.0);
            let mut chords = vec![arc.start()];
            flatten_arc(&arc, tolerance, &mut |point| chords.push(point));
            assert_eq!(chords.last(), Some(&arc.end()), "case {case}: the end of {arc:?}");
            judge(&Plain::of_arc(&arc), &chords, tolerance, &format!("case {case}: {arc:?}"));
            // Chords of sagitta h span 2 √(2 h R) or so; never more than twice as many.
            let needed = arc.length() / (8.0 * tolerance * arc.radius()).sqrt();
            let most = 2.0 * needed + 2.0;
            assert!((chords.len() as f64) < most, "case {case}: {} of {most}", chords.len());

            let cubic = shapes::cubic(&mut random, 20.0);
            let mut chords = vec![cubic.start()];
            flatten_cubic(&cubic, tolerance, &mut |point| chords.push(point));
            assert_eq!(chords.last(), Some(&cubic.end()), "case {case}: the end of {cubic:?}");
            judge(&Plain::of_cubic(&cubic), &chords, tolerance, &format!("case {case}: {cubic:?}"));
        }
    }
}
