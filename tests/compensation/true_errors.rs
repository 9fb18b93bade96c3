//! The true error of offsets of splines, by an oracle of twice the digits.

use g41::compensation::{Options, avoid, compensate};
use g41::contour::{MoveCurve, Side, Tool, ToolPath};
use g41::geometry::Curve;
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::sketch::{Sketch, spline};
use crate::common::curves::{spiral, wave};
use crate::common::double::Double;
use crate::common::equidistant::{Bezier, Equidistant, Foot};

const SAMPLES: usize = if cfg!(target_arch = "wasm32") { 10_000 } else { 100_000 };

/// Largest distance of a path from the true equidistant [mm], its cubics in order.
fn error(path: &ToolPath, spans: &[Bezier], closed: bool, radius: f64, doubt: f64) -> f64 {
    let truth = Equidistant { spans, offset: radius, closed, doubt };
    let each = SAMPLES / path.moves.len();
    let mut foot = Foot { span: 0, t: 0.0 };
    let mut end: Option<DVec2> = None;
    let mut worst: f64 = 0.0;
    for one in &path.moves {
        let MoveCurve::Cubic(piece) = &one.curve else { return f64::INFINITY };
        if end.is_none_or(|end| end.distance(piece.start()) > 1e-6) {
            foot = truth.find(piece.start(), foot.span, 1e-2);
        }
        worst = worst.max(truth.error(&piece.points, each, &mut foot));
        end = Some(piece.end());
    }
    worst
}

#[test]
fn every_offset_of_wave_and_spiral_is_within_its_tolerance() {
    for (points, closed) in [(wave(100), true), (spiral(100), false)] {
        let shapes = [spline(&points[1..])];
        let sketch = if closed {
            Sketch::closed(points[0], shapes)
        } else {
            Sketch::open(points[0], shapes)
        };
        let contour = sketch.contour();
        let Curve::Spline(spline) = &contour.segments()[0].curve else { continue };
        let spans: Vec<Bezier> = spline.pieces().iter().map(|piece| piece.points).collect();
        let tool = Tool::new(5.0, Side::Left).expect("a radius");
        for tolerance in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9] {
            let options = Options { tolerance, ..Options::default() };
            let paths = [compensate(&contour, tool, &options), avoid(&contour, tool, &options)];
            for path in paths {
                let error = error(&path, &spans, closed, 5.0, tolerance);
                let what = format!("{} type points, closed: {closed}", points.len());
                assert!(error <= tolerance, "{what}: {error:e} for {tolerance:e}");
            }
        }
    }
}

#[test]
fn the_oracle_sees_an_error_that_f64_does_not() {
    // 10 / 3 has an error of half a unit in the last place, which its product with 3 shows.
    let third = Double::from(10.0) / Double::from(3.0);
    let rest = (third * Double::from(3.0) - Double::from(10.0)).value();
    assert!(rest.abs() < 1e-30, "32 digits: {rest:e}");
    let root = Double::from(2.0).sqrt();
    let rest = (root * root - Double::from(2.0)).value();
    assert!(rest.abs() < 1e-30, "32 digits: {rest:e}");
    // A straight piece 5 mm and a billionth beside a straight chain.
    let straight = |y: f64| [0.0, 1.0, 2.0, 3.0].map(|x| DVec2::new(1e3 + x, 1e3 + y));
    let chain = [straight(0.0)];
    let truth = Equidistant { spans: &chain, offset: 5.0, closed: false, doubt: 1.0 };
    let piece = straight(5.0 + 1e-9);
    let off = truth.error(&piece, 10, &mut Foot { span: 0, t: 0.0 });
    let exact = (piece[0].y - 1e3 - 5.0).abs();
    // The foot is as exact as an f64, which moves it along by 1e-13.
    assert!((off - exact).abs() < 1e-16, "{off:e} is not {exact:e}");
}
