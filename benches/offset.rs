//! Nanoseconds per type point: building a spline and compensating it, beside kurbo's offset of the
//! same cubics in the same run.
//!
//! `npm run bench` runs it natively and, compiled together with kurbo, as WebAssembly in Node.
//! Competitors take turns, and medians are printed, so that a machine's moods fall on all alike.
#![cfg_attr(target_arch = "wasm32", no_main)]

use std::hint::black_box;

use g41::compensation::{Options, compensate};
use g41::contour::{Attributes, Contour, ContourBuilder, Shape, Side, SplineShape, Tool};
use g41::diagnostic::Origin;
use g41::geometry::{Cubic, Curve, Parameter, Spline, SplineEnds};
use glam::DVec2;
use kurbo::{BezPath, CubicBez, Point};

#[path = "../tests/common/curves.rs"]
mod curves;

use curves::{spiral, wave};

/// Tool radius [mm]: no bend of the curves is tighter, so neither side has cusps to deal with.
const RADIUS: f64 = 5.0;

const TOLERANCES: [f64; 2] = [1e-3, 1e-6];

/// Type points handled by each competitor in all, so that short curves repeat more often.
const WORK: usize = 400_000;

fn contour(points: &[DVec2], closed: bool) -> Contour {
    let mut builder = ContourBuilder::new(points[0]);
    let shape = SplineShape { points: points[1..].to_vec(), ..SplineShape::default() };
    builder.segment(Shape::Spline(shape), Attributes::at(Origin::Segment(0)));
    builder.build(closed).contour.expect("the test curves are splines")
}

fn kurbo_cubics(pieces: &[Cubic]) -> Vec<CubicBez> {
    let point = |p: DVec2| Point::new(p.x, p.y);
    pieces
        .iter()
        .map(|c| c.points.map(point))
        .map(|[a, b, c, d]| CubicBez::new(a, b, c, d))
        .collect()
}

/// What one competitor took and made.
struct Timed {
    nanoseconds: Vec<f64>,
    pieces: usize,
}

/// Runs the competitors in turn; each tells how many pieces it made.
fn race<const N: usize>(
    runs: usize,
    mut competitors: [&mut dyn FnMut() -> usize; N],
) -> [Timed; N] {
    let mut timed = [(); N].map(|()| Timed { nanoseconds: Vec::with_capacity(runs), pieces: 0 });
    for run in 0..=runs {
        for (competitor, timed) in competitors.iter_mut().zip(&mut timed) {
            let start = now();
            timed.pieces = black_box(competitor());
            let taken = now() - start;
            // The first run warms up.
            if run > 0 {
                timed.nanoseconds.push(taken);
            }
        }
    }
    timed
}

impl Timed {
    /// Median nanoseconds for each of `points`, and pieces for each.
    fn per(mut self, points: usize) -> String {
        self.nanoseconds.sort_by(f64::total_cmp);
        let median = self.nanoseconds[self.nanoseconds.len() / 2];
        let points = points as f64;
        format!("{:.0} ({:.2})", median / points, self.pieces as f64 / points)
    }
}

fn print_table() {
    print("ns per type point, in brackets the pieces made for each");
    print("| curve | spline | g41 1e-3 | kurbo 1e-3 | g41 1e-6 | kurbo 1e-6 |");
    print("| --- | --- | --- | --- | --- | --- |");
    let tool = Tool::new(RADIUS, Side::Left).expect("a valid radius");
    for (name, closed) in [("wave", true), ("spiral", false)] {
        for n in [100, 1000, 10_000] {
            let points = if closed { wave(n) } else { spiral(n) };
            let contour = contour(&points, closed);
            let Curve::Spline(programmed) = &contour.segments()[0].curve else { continue };
            let cubics = kurbo_cubics(programmed.pieces());
            let ends = if closed { SplineEnds::Periodic } else { SplineEnds::NATURAL };
            let mut build = || {
                let points = black_box(&points).clone();
                let spline = Spline::through(points, ends, Parameter::Chord);
                spline.map_or(0, |spline| spline.pieces().len())
            };
            let ours = |tolerance| {
                let options = Options { tolerance, ..Options::default() };
                let contour = &contour;
                move || compensate(black_box(contour), tool, &options).moves.len()
            };
            let theirs = |tolerance| {
                let cubics = &cubics;
                move || {
                    let (mut pieces, mut path) = (0, BezPath::new());
                    for cubic in black_box(cubics) {
                        path.truncate(0);
                        kurbo::offset::offset_cubic(*cubic, RADIUS, tolerance, &mut path);
                        pieces += path.elements().len() - 1;
                    }
                    pieces
                }
            };
            let [coarse, fine] = TOLERANCES;
            let timed = race(
                (WORK / n).clamp(25, 1000),
                [
                    &mut build,
                    &mut ours(coarse),
                    &mut theirs(coarse),
                    &mut ours(fine),
                    &mut theirs(fine),
                ],
            );
            let cells = timed.map(|timed| timed.per(n));
            print(&format!("| {name} {n} | {} |", cells.join(" | ")));
        }
    }
}

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    print_table();
}

#[cfg(not(target_arch = "wasm32"))]
fn print(line: &str) {
    println!("{line}");
}

/// Nanoseconds since the first call.
#[cfg(not(target_arch = "wasm32"))]
fn now() -> f64 {
    use std::sync::OnceLock;
    use std::time::Instant;
    static START: OnceLock<Instant> = OnceLock::new();
    START.get_or_init(Instant::now).elapsed().as_secs_f64() * 1e9
}

#[cfg(target_arch = "wasm32")]
use in_wasm::{now, print};

#[cfg(target_arch = "wasm32")]
mod in_wasm {
    //! The clock and the console of the host.

    use wasm_bindgen::prelude::wasm_bindgen;
    use wasm_bindgen_test::wasm_bindgen_test;

    #[wasm_bindgen]
    extern "C" {
        #[wasm_bindgen(js_namespace = performance, js_name = now)]
        fn milliseconds() -> f64;
        #[wasm_bindgen(js_namespace = console, js_name = log)]
        pub(crate) fn print(line: &str);
    }

    /// Nanoseconds.
    pub(crate) fn now() -> f64 {
        milliseconds() * 1e6
    }

    #[wasm_bindgen_test]
    fn table() {
        super::print_table();
    }
}
