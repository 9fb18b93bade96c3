//! How far the textbook's spline is off the true equidistant, on a circle and an ellipse.
//!
//! Each inner point P moves by exactly r along the bisector of its legs. Where the legs span the
//! angles a and b of a circle of radius R, the bisector is off the normal by δ = (b − a) / 4, so the
//! moved point is off the equidistant by R r / (R + r) · δ² / 2: of second order in the spacing, or
//! of fourth where δ itself is of second order, as with even or smoothly changing spacing. Between
//! even points the spline through the moved points errs by (R + r) h⁴ / 384 and the programmed one
//! by R h⁴ / 384, h being the angle between points: r h⁴ / 384 are left. (R − r, −r to the inside.)

use std::f64::consts::TAU;

use g41::compensation::{Options, SplineMethod};
use g41::contour::{Side, ToolPath};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::judge::{field_of, samples};
use super::sketch::{Sketch, spline};
use crate::common::near;

const RADIUS: f64 = 5.0;

/// Half axes of the curve on which the type points lie.
#[derive(Debug, Clone, Copy)]
struct Ellipse(f64, f64);

const CIRCLE: Ellipse = Ellipse(40.0, 40.0);
const ELLIPSE: Ellipse = Ellipse(50.0, 30.0);

/// How type points are spaced.
#[derive(Debug, Clone, Copy)]
enum Spacing {
    /// By equal arcs.
    Even,
    /// By arcs of 1 : 2 in turn.
    Uneven,
}

/// `count` points of the ellipse, the first repeated as the last, spaced along its length.
fn type_points(shape: Ellipse, spacing: Spacing, count: usize) -> Vec<DVec2> {
    const STEPS: usize = 100_000;
    let at = |i: usize| {
        let angle = TAU * i as f64 / STEPS as f64;
        DVec2::new(shape.0 * angle.cos(), shape.1 * angle.sin())
    };
    let mut lengths = vec![0.0];
    for i in 0..STEPS {
        lengths.push(lengths[i] + at(i).distance(at(i + 1)));
    }
    let total = lengths[STEPS];
    let mut points: Vec<DVec2> = (0..count)
        .map(|i| match spacing {
            Spacing::Even => i as f64,
            Spacing::Uneven => i as f64 + if i % 2 == 1 { -1.0 / 3.0 } else { 0.0 },
        })
        .map(|place| {
            let length = total * place / count as f64;
            let i = lengths.partition_point(|l| *l <= length).min(STEPS);
            let t = (length - lengths[i - 1]) / (lengths[i] - lengths[i - 1]);
            let angle = TAU * (i as f64 - 1.0 + t) / STEPS as f64;
            DVec2::new(shape.0 * angle.cos(), shape.1 * angle.sin())
        })
        .collect();
    points.push(points[0]);
    points
}

fn path(sketch: &Sketch, side: Side) -> ToolPath {
    let options = Options { spline: SplineMethod::TypePoints, ..Options::default() };
    sketch.compensated(side, RADIUS, &options)
}

/// Largest difference between the distance of the path from the programmed spline and r.
fn deviation(shape: Ellipse, spacing: Spacing, count: usize, side: Side) -> f64 {
    let points = type_points(shape, spacing, count);
    let sketch = Sketch::closed(points[0], [spline(&points[1..])]);
    let path = path(&sketch, side);
    let field = field_of(&sketch.contour());
    let off = |point: DVec2| (field.distance(point) - RADIUS).abs();
    let measured = samples(&path, 24).into_iter().map(off).fold(0.0, f64::max);
    // What the path says of itself must be that.
    let told = path.diagnostics.iter().find(|d| d.code == "type-points-deviation");
    let told = told.and_then(|d| d.depth).expect("the deviation is reported");
    near(told, measured, 0.1 * measured, &format!("{shape:?} {spacing:?} {count} {side:?}"));
    measured
}

#[test]
fn the_deviation_falls_with_the_order_of_theory() {
    println!("| curve | spacing | side | 8 | 16 | 32 | 64 | 128 | order | theory |");
    println!("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
    for (shape, name) in [(CIRCLE, "circle R 40"), (ELLIPSE, "ellipse 50 × 30")] {
        for (spacing, theory) in [(Spacing::Even, 4.0), (Spacing::Uneven, 2.0)] {
            // Counter-clockwise, the left is inside.
            for (side, place) in [(Side::Right, "outside"), (Side::Left, "inside")] {
                let off = [8, 16, 32, 64, 128].map(|count| deviation(shape, spacing, count, side));
                let order = (off[3] / off[4]).log2();
                let spaced = if theory == 4.0 { "even" } else { "uneven 1 : 2" };
                let [a, b, c, d, e] = off.map(|mm| format!("{:.4}", mm * 1000.0));
                println!(
                    "| {name} | {spaced} | {place} | {a} | {b} | {c} | {d} | {e} | {order:.2} | {theory} |"
                );
                near(order, theory, 0.15, &format!("{name}, {spaced}, {place}: {off:?}"));
            }
        }
    }
}

#[test]
fn on_a_circle_the_deviation_is_that_of_the_derivation() {
    for count in [32, 64] {
        let step = TAU / count as f64;
        let even = deviation(CIRCLE, Spacing::Even, count, Side::Right);
        near(even, RADIUS * step.powi(4) / 384.0, 0.05 * even, "even, outside");
        for (side, outside) in [(Side::Right, 1.0), (Side::Left, -1.0)] {
            let off_normal = step / 6.0;
            let (r, big) = (RADIUS, CIRCLE.0);
            let expected = big * r / (big + outside * r) * off_normal * off_normal / 2.0;
            let uneven = deviation(CIRCLE, Spacing::Uneven, count, side);
            near(uneven, expected, 0.05 * uneven, &format!("uneven, {side:?}, {count}"));
        }
    }
}
