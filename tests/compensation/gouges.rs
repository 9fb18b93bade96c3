//! Local gouges: reported with a place and a depth that brute force confirms.

use g41::compensation::{CornerStyle, Options};
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
