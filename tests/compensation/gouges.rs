//! Local gouges: reported with a place and a depth that brute force confirms.

use g41::compensation::{CornerStyle, Options, SplineMethod};
use g41::contour::{Side, ToolPath};
use g41::diagnostic::Severity;
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::judge::{field_of, in_one_piece, samples};
use super::sketch::{Sketch, arc, line, spline};
use crate::common::{near, p};

/// How deep the path cuts into the contour, by dense sampling.
fn deepest(path: &ToolPath, sketch: &Sketch, radius: f64) -> f64 {
    let field = field_of(&sketch.contour());
    let depth = |point: DVec2| radius - field.distance(point);
    samples(path, 200).into_iter().map(depth).fold(0.0, f64::max)
}

/// Asserts that the deepest gouge reported is as deep as brute force finds the path anywhere, at a
/// place on the contour, with a diagnostic of the same.
#[track_caller]
fn judge(sketch: &Sketch, side: Side, radius: f64, what: &str) {
    for corner in [CornerStyle::Linear, CornerStyle::Arc] {
        let options = Options { corner, ..Options::default() };
        let path = sketch.compensated(side, radius, &options);
        let what = format!("{what}, {side:?}, r {radius}, {corner:?}");
        in_one_piece(&path, &what);
        let brute = deepest(&path, sketch, radius);
        let worst = path.gouges.iter().max_by(|a, b| a.depth.total_cmp(&b.depth));
        let worst = worst.unwrap_or_else(|| panic!("{what}: {brute} mm deep and not a word"));
        // Places of the tool are sampled, so the depth is known to a few percent.
        near(worst.depth, brute, 0.05 * brute + 2e-3, &what);
        let on = field_of(&sketch.contour()).distance(worst.at);
        near(on, 0.0, 1e-6, &format!("{what}: {} is not on the contour", worst.at));
        let told = path.diagnostics.iter().any(|d| {
            d.severity == Severity::Error && d.depth == Some(worst.depth) && d.at == Some(worst.at)
        });
        assert!(told, "{what}: no diagnostic of {worst:?}: {:?}", path.diagnostics);
    }
}

/// A valley of cosine shape: its tightest bend has the curvature `depth (π / half)² / 2`.
fn valley(half: f64, depth: f64) -> Sketch {
    let at = |i: i32| {
        let x = half * f64::from(i) / 6.0;
        let bowl = 0.5 * depth * (1.0 + (std::f64::consts::PI * x / half).cos());
        p(x, if i.abs() > 6 { 0.0 } else { -bowl })
    };
    let points: Vec<DVec2> = (-11..=12).map(at).collect();
    Sketch::open(at(-12), [spline(&points)])
}

#[test]
fn a_bend_tighter_than_the_tool_is_a_gouge_of_its_depth() {
    // Curvature 5 · (π / 10)² / 2 = 0.247 / mm: the bend has a radius of 4 mm.
    for radius in [5.0, 6.0, 8.0] {
        judge(&valley(10.0, 5.0), Side::Left, radius, "valley");
        judge(&valley(10.0, 5.0).reversed(), Side::Right, radius, "valley backwards");
    }
}

#[test]
fn a_bend_wider_than_the_tool_is_none() {
    for radius in [0.5, 2.0, 3.5] {
        for side in [Side::Left, Side::Right] {
            let sketch = valley(10.0, 5.0);
            let path = sketch.compensated(side, radius, &Options::default());
            assert!(path.gouges.is_empty(), "r {radius}, {side:?}: {:?}", path.gouges);
            near(deepest(&path, &sketch, radius), 0.0, 0.001, "depth");
        }
    }
}

#[test]
fn an_inside_arc_tighter_than_the_tool_is_a_gouge_of_its_depth() {
    // A pocket corner rounded by 3 mm between two walls.
    let sketch = Sketch::open(
        p(-30.0, 0.0),
        [line(p(0.0, 0.0)), arc(p(3.0, 3.0), p(0.0, 3.0), false), line(p(3.0, 33.0))],
    );
    for radius in [3.5, 4.5, 6.0] {
        judge(&sketch, Side::Left, radius, "rounded pocket corner");
        judge(&sketch.reversed(), Side::Right, radius, "rounded pocket corner backwards");
    }
    let path = sketch.compensated(Side::Left, 2.9, &Options::default());
    assert!(path.gouges.is_empty(), "a smaller tool fits: {:?}", path.gouges);
}

#[test]
fn an_inside_corner_whose_offsets_do_not_meet_is_a_gouge_at_the_corner() {
    // A step lower than the tool's radius: the short leg is used up.
    let step = Sketch::open(p(-30.0, 0.0), [line(p(0.0, 0.0)), line(p(-0.5, 1.0))]);
    judge(&step, Side::Left, 4.0, "short leg");
    judge(&step.reversed(), Side::Right, 4.0, "short leg backwards");
    // A line into an arc that turns its back: their offsets pass each other.
    let arc_away =
        Sketch::open(p(-30.0, 0.0), [line(p(0.0, 0.0)), arc(p(-2.0, 3.0), p(-2.5, 0.5), false)]);
    judge(&arc_away, Side::Left, 6.0, "small arc");
    let bump = Sketch::open(
        p(-30.0, 0.0),
        [line(p(0.0, 0.0)), spline(&[p(-0.5, 1.0), p(-1.0, 1.8), p(-2.0, 2.5)])],
    );
    judge(&bump, Side::Left, 6.0, "short spline");
}

#[test]
fn a_segment_used_up_between_two_inside_corners_is_told() {
    let slot =
        Sketch::open(p(0.0, 30.0), [line(p(0.0, 0.0)), line(p(5.0, 0.0)), line(p(5.0, 30.0))]);
    for radius in [2.6, 3.0, 4.0] {
        judge(&slot, Side::Left, radius, "slot");
    }
    let path = slot.compensated(Side::Left, 2.4, &Options::default());
    assert!(path.gouges.is_empty(), "a smaller tool fits: {:?}", path.gouges);
}

#[test]
fn a_bend_that_its_corner_cuts_away_is_no_gouge() {
    let points = [
        p(1.679_719_707_238_776_2, 1.018_929_336_667_703_5),
        p(2.735_358_149_822_022_5, 2.675_824_857_377_692),
        p(2.949_074_959_062_633_4, 4.628_771_455_074_726),
    ];
    let sketch =
        Sketch::open(p(-13.394_262_038_762_614, 0.0), [line(p(0.0, 0.0)), spline(&points)]);
    let path = sketch.compensated(Side::Left, 4.190_435_986_032_43, &Options::default());
    assert!(path.gouges.is_empty(), "the path is clear of it: {:?}", path.gouges);
}

#[test]
fn the_depth_of_a_bend_counts_the_segment_before_it() {
    let points = [
        p(0.420_010_655_340_467_7, 0.045_642_943_938_139_48),
        p(0.782_729_639_834_305_4, 0.262_269_736_414_574_5),
        p(1.022_076_610_260_707, 0.610_415_189_750_637_1),
    ];
    let sketch = Sketch::open(p(-0.697_586_012_282_791, 0.0), [line(p(0.0, 0.0)), spline(&points)]);
    let radius = 3.688_850_578_825_207_7;
    let path = sketch.compensated(Side::Left, radius, &Options::default());
    let reported = path.gouges.iter().map(|gouge| gouge.depth).fold(0.0, f64::max);
    let brute = deepest(&path, &sketch, radius);
    near(reported, brute, 0.05 * brute, "depth against brute force");
}

#[test]
fn a_bend_too_tight_for_the_tool_is_a_gouge_with_type_points_too() {
    // Its smallest bend is 4 mm.
    let sketch = valley(10.0, 5.0);
    let options = Options { spline: SplineMethod::TypePoints, ..Options::default() };
    assert!(sketch.compensated(Side::Left, 3.5, &options).gouges.is_empty(), "3.5 mm fits");
    let path = sketch.compensated(Side::Left, 6.0, &options);
    assert_eq!(path.gouges.len(), 1, "6 mm does not fit");
    near(path.gouges[0].at.x.abs(), 0.0, 6.0, "the bend is in the middle");
    near(path.gouges[0].depth, 0.445, 0.1, "its depth, as brute force has it");
}

#[test]
fn an_inside_corner_without_an_intersection_is_not_travelled_far_for() {
    // Legs that nearly double back: their equidistants meet kilometres away.
    let legs = [line(p(20.0, 0.0)), line(p(0.0, 0.001))];
    for options in [Options::default(), Options { corner: CornerStyle::Arc, ..Options::default() }]
    {
        let sketch = Sketch::open(p(0.0, 0.0), legs.clone());
        let path = sketch.compensated(Side::Left, 5.0, &options);
        assert!(!path.diagnostics.is_empty(), "it is reported");
        for point in samples(&path, 4) {
            assert!(point.abs().max_element() < 40.0, "the path leads to {point}");
        }
    }
}

#[test]
fn a_bend_across_the_seam_of_a_closed_spline_is_told_once() {
    // An ellipse whose ends have a radius of 10² / 20 = 5 mm; it starts at one of them.
    let at = |i: i32| {
        let angle = std::f64::consts::TAU * f64::from(i % 24) / 24.0;
        p(20.0 * angle.cos(), 10.0 * angle.sin())
    };
    for start in [0, 1, 6] {
        let points: Vec<DVec2> = (1..=24).map(|i| at(i + start)).collect();
        let sketch = Sketch::closed(at(start), [spline(&points)]);
        let path = sketch.compensated(Side::Left, 6.0, &Options::default());
        assert_eq!(path.gouges.len(), 2, "one at either end: {:?}", path.gouges);
        let [first, second] = [0, 1].map(|k| path.gouges[k].depth);
        near(first, second, 0.05 * first, "both ends are alike");
    }
}
