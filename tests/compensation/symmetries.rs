//! Random contours through their symmetries: the path follows the contour through each.

use g41::compensation::{CornerStyle, Options, SplineMethod};
use g41::contour::{Contour, Side, ToolPath, TransitionKind};
use g41::diagnostic::Severity;
use g41::geometry::Curve;
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::judge::{field_of, field_of_path, same_path, samples};
use super::random_contours::{check, star, wandering};
use super::sketch::Sketch;
use crate::common::random::Random;

const CASES: u32 = if cfg!(target_arch = "wasm32") { 60 } else { 600 };

fn has_spline(contour: &Contour) -> bool {
    contour.segments().iter().any(|segment| matches!(segment.curve, Curve::Spline(_)))
}

fn kinds(path: &ToolPath) -> Vec<TransitionKind> {
    path.transitions.iter().map(|t| t.kind).collect()
}

/// Calls `judge` with gouge-free contours, closed ones or open ones.
fn for_each(
    seed: u64,
    closed: bool,
    judge: impl Fn(&Sketch, Side, f64, &Options, &mut Random, &str),
) {
    let mut random = Random::new(seed);
    let mut judged = 0;
    while judged < CASES {
        let sketch = if closed { star(&mut random) } else { wandering(&mut random) };
        let side = if random.coin() { Side::Left } else { Side::Right };
        let radius = random.within(0.3, 4.0);
        let corner = if random.coin() { CornerStyle::Linear } else { CornerStyle::Arc };
        let spline =
            if random.index(3) == 0 { SplineMethod::TypePoints } else { SplineMethod::Exact };
        let contour = sketch.contour();
        if check(&contour, &field_of(&contour), side, radius).is_err() {
            continue;
        }
        let options = Options { corner, spline, tolerance: 1e-4, ..Options::default() };
        // The polygon of type points may double back where the curve does not.
        let path = sketch.compensated(side, radius, &options);
        if path.diagnostics.iter().any(|d| d.severity == Severity::Error) {
            continue;
        }
        let what = format!("contour {judged}, {side:?}, r {radius}, {options:?}: {sketch:?}");
        judge(&sketch, side, radius, &options, &mut random, &what);
        judged += 1;
    }
}

/// Asserts that the image of one path is the other path.
fn image(path: &ToolPath, map: impl Fn(DVec2) -> DVec2, other: &ToolPath, slack: f64, what: &str) {
    let field = field_of_path(other);
    for point in samples(path, 5) {
        let off = field.distance(map(point));
        assert!(off <= slack, "{what}: {point} is {off:e} off");
    }
    assert_eq!(kinds(path), kinds(other), "{what}");
}

#[test]
fn a_closed_contour_has_the_same_path_from_every_start() {
    for_each(401, true, |sketch, side, radius, options, _, what| {
        let path = sketch.compensated(side, radius, options);
        for first in 1..sketch.shapes.len() {
            let other = sketch.starting_at(first).compensated(side, radius, options);
            same_path(&path, &other, 1e-8, &format!("start {first} of {what}"));
        }
    });
}

#[test]
fn mirroring_contour_and_side_mirrors_the_path() {
    for closed in [false, true] {
        for_each(402, closed, |sketch, side, radius, options, _, what| {
            let mirror = |p: DVec2| DVec2::new(p.x, -p.y);
            let path = sketch.compensated(side, radius, options);
            let other = sketch.mapped(true, mirror).compensated(side.opposite(), radius, options);
            image(&path, mirror, &other, 1e-8, what);
        });
    }
}

#[test]
fn turning_moving_and_scaling_the_contour_does_so_to_the_path() {
    for closed in [false, true] {
        for_each(403, closed, |sketch, side, radius, options, random, what| {
            let (ray, by) = (random.direction(), random.point(500.0));
            let scale = 10.0_f64.powf(random.within(-1.0, 1.0));
            let map = |p: DVec2| ray.rotate(p) * scale + by;
            let path = sketch.compensated(side, radius, options);
            let scaled = Options { tolerance: options.tolerance * scale, ..*options };
            let other = sketch.mapped(false, map).compensated(side, radius * scale, &scaled);
            // The spline's pieces may be cut elsewhere where a proof is close.
            let slack = if has_spline(&sketch.contour()) { 2.0 * scaled.tolerance } else { 1e-8 };
            image(&path, map, &other, slack.max(1e-8), what);
        });
    }
}

#[test]
fn reversing_contour_and_side_reverses_the_path() {
    for closed in [false, true] {
        for_each(404, closed, |sketch, side, radius, options, _, what| {
            let path = sketch.compensated(side, radius, options);
            let other = sketch.reversed().compensated(side.opposite(), radius, options);
            let slack = if has_spline(&sketch.contour()) { 2.0 * options.tolerance } else { 1e-8 };
            same_path(&path, &other, slack, what);
        });
    }
}

#[test]
fn cutting_a_segment_in_two_changes_nothing() {
    for closed in [false, true] {
        for_each(405, closed, |sketch, side, radius, options, random, what| {
            let path = sketch.compensated(side, radius, options);
            let index = random.index(sketch.shapes.len());
            // Away from the ends: an inside corner may use up the parts beside it.
            let Some(cut) = sketch.split(index, 0.5) else { return };
            let contour = cut.contour();
            if check(&contour, &field_of(&contour), side, radius).is_err() {
                return;
            }
            let other = cut.compensated(side, radius, options);
            same_path(&path, &other, 1e-7, &format!("segment {index} of {what}"));
        });
    }
}
