//! Radii: zero, negative, larger than the part.

use std::f64::consts::FRAC_PI_6;

use g41::compensation::{CornerStyle, Options, SplineMethod};
use g41::contour::{Side, Tool};
use g41::diagnostic::Severity;
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::corners::{Leg, corner};
use super::judge::{field_of, field_of_path, in_one_piece, samples};
use super::sketch::{Sketch, arc, line, spline};
use crate::common::{near, p};

fn all_options() -> Vec<Options> {
    let mut all = Vec::new();
    for corner in [CornerStyle::Linear, CornerStyle::Arc] {
        for spline in [SplineMethod::Exact, SplineMethod::TypePoints] {
            all.push(Options { corner, spline, ..Options::default() });
        }
    }
    all
}

#[test]
fn radius_zero_gives_the_contour_itself() {
    for first in Leg::ALL {
        for second in Leg::ALL {
            for turn in [-2.9, -1.0, 0.0, 0.5, 2.9] {
                for options in all_options() {
                    let sketch = corner([first, second], 0.2, turn, 2.0);
                    let what = format!("{first:?} {second:?} {turn} {options:?}");
                    for side in [Side::Left, Side::Right] {
                        let path = sketch.compensated(side, 0.0, &options);
                        in_one_piece(&path, &what);
                        assert!(path.moves.len() <= 8, "{what}: {} moves", path.moves.len());
                        let field = field_of(&sketch.contour());
                        for point in samples(&path, 9) {
                            near(field.distance(point), 0.0, 0.001, &what);
                        }
                        let back = field_of_path(&path);
                        for segment in sketch.contour().segments() {
                            for i in 0..=20 {
                                let point = segment.curve.point(f64::from(i) / 20.0);
                                near(back.distance(point), 0.0, 0.001, &what);
                            }
                        }
                        let length: f64 = path.moves.iter().map(|m| m.curve.length()).sum();
                        let programmed: f64 =
                            sketch.contour().segments().iter().map(|s| s.curve.length()).sum();
                        near(length, programmed, 0.01, &what);
                    }
                }
            }
        }
    }
}

#[test]
fn a_negative_radius_is_the_other_side() {
    for first in Leg::ALL {
        for second in Leg::ALL {
            for turn in [-2.0, -1.0, 0.5, 2.0] {
                for options in all_options() {
                    let sketch = corner([first, second], 0.2, turn, 2.0);
                    let negative = sketch.compensated(Side::Left, -2.0, &options);
                    let positive = sketch.compensated(Side::Right, 2.0, &options);
                    assert_eq!(negative, positive, "{first:?} {second:?} {turn} {options:?}");
                }
            }
        }
    }
}

#[test]
fn a_radius_that_is_no_number_makes_no_tool() {
    for radius in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
        assert_eq!(Tool::new(radius, Side::Left), None, "radius {radius}");
    }
}

#[test]
fn a_tool_larger_than_the_part_is_reported_and_harms_nothing() {
    let square = [p(10.0, 0.0), p(10.0, 10.0), p(0.0, 10.0), p(0.0, 0.0)];
    let circle = arc(p(10.0, 0.0), p(5.0, 0.0), false);
    let wave: Vec<DVec2> = (1..=12)
        .map(|i| DVec2::from_angle(f64::from(i) * FRAC_PI_6) * if i % 2 == 0 { 10.0 } else { 7.0 })
        .collect();
    let mut closed_wave = wave.clone();
    closed_wave[11] = p(10.0, 0.0);
    let parts = [
        ("square", Sketch::closed(p(0.0, 0.0), square.map(line))),
        ("circle", Sketch::closed(p(10.0, 0.0), [circle])),
        ("wave", Sketch::closed(p(10.0, 0.0), [spline(&closed_wave)])),
    ];
    for (name, sketch) in parts {
        for radius in [20.0, 1e3, 1e6] {
            for options in all_options() {
                let what = format!("{name}, radius {radius}, {options:?}");
                let inside = sketch.compensated(Side::Left, radius, &options);
                let told = inside.diagnostics.iter().any(|d| d.severity >= Severity::Warning);
                assert!(told, "{what}: no word about it: {:?}", inside.diagnostics);
                in_one_piece(&inside, &what);
                assert!(inside.moves.len() < 10_000, "{what}: {} moves", inside.moves.len());
                let outside = sketch.compensated(Side::Right, radius, &options);
                in_one_piece(&outside, &what);
            }
        }
    }
}

#[test]
fn an_inside_arc_of_the_tools_radius_comes_to_its_centre() {
    for radius in [5.0, 5.0 - 1e-10, 5.0 + 1e-10] {
        let sketch = Sketch::open(
            p(-30.0, 0.0),
            [line(p(0.0, 0.0)), arc(p(5.0, 5.0), p(0.0, 5.0), false), line(p(5.0, 40.0))],
        );
        for options in all_options() {
            let what = format!("r {radius}, {options:?}");
            let path = sketch.compensated(Side::Left, radius, &options);
            in_one_piece(&path, &what);
            assert!(path.gouges.is_empty(), "{what}: {:?}", path.gouges);
            let field = field_of(&sketch.contour());
            for point in samples(&path, 20) {
                near(field.distance(point), 5.0, 1e-8, &what);
            }
            near(field_of_path(&path).distance(p(0.0, 5.0)), 0.0, 1e-8, &what);
            let back = sketch.reversed().compensated(Side::Right, radius, &options);
            in_one_piece(&back, &what);
        }
    }
}

#[test]
fn a_full_circle_between_two_lines_is_run_round_once() {
    // In along a tangent, round the hole, and on along the tangent.
    let hole = p(0.0, 10.0);
    let sketch = Sketch::open(
        p(-15.0, 0.0),
        [line(p(0.0, 0.0)), arc(p(0.0, 0.0), hole, false), line(p(15.0, 0.0))],
    );
    for (side, expected) in [(Side::Left, 8.0), (Side::Right, 12.0)] {
        let path = sketch.compensated(side, 2.0, &Options::default());
        in_one_piece(&path, "circle between lines");
        let length: f64 = path.moves.iter().map(|m| m.curve.length()).sum();
        near(length, 30.0 + std::f64::consts::TAU * expected, 1e-9, "length");
    }
}
