//! Nanoseconds per type point, from raw type points to a path that was held against the whole
//! contour, beside kurbo's untrimmed offset of the same cubics, cavalier_contours on a biarc fit of
//! them, and Clipper2 on a polygon; all in one run.
//!
//! `npm run bench` runs it natively and as WebAssembly in Node, and `cargo bench --package peers`
//! natively. A number as argument leaves out curves of more type points.
#![cfg_attr(target_arch = "wasm32", no_main)]

use std::hint::black_box;

use peers::competitors::{
    biarcs, cavalier_pieces, clipper_vertices, kurbo_cubics, kurbo_pieces, polygon,
};
use peers::curves::{Sample, spiral, wave};
use peers::race::{Timed, print, race};

const SIZES: [usize; 4] = [100, 1_000, 10_000, 100_000];
const TOLERANCES: [f64; 2] = [1e-3, 1e-6];

/// Tolerance of the biarc fit, of the polygon, and of Clipper2's arcs [mm]: the others know no
/// finer one at a bearable size.
const PEERS_TOLERANCE: f64 = 1e-3;

/// Type points handled by each competitor in all, so that short curves repeat more often.
const WORK: usize = 200_000;

/// Time that one competitor may take on one curve [ns].
const PATIENCE: f64 = 4e9;

/// From this many type points on Clipper2 is left out: it would take minutes.
const CLIPPER_LIMIT: usize = 10_000;

fn table(largest: usize) {
    print("ns per type point; in brackets pieces per type point; ours / theirs = ratio (target)");
    for (loops, what) in [(false, "without loops"), (true, "with loops")] {
        print(&format!("\n{what}"));
        print(
            "| curve, r | spline | g41 1e-3 | g41 1e-6 | kurbo 1e-3 | kurbo 1e-6 | cavalier arcs \
             | + biarc fit | Clipper2 |",
        );
        print("| --- | --- | --- | --- | --- | --- | --- | --- | --- |");
        let mut ratios = Vec::new();
        for make in [wave, spiral] {
            for n in SIZES.into_iter().filter(|n| *n <= largest) {
                let (row, ratio) = line(&make(n), loops);
                print(&row);
                ratios.push(ratio);
            }
        }
        print(&format!("\n{what}, ratios"));
        print(
            "| curve, r | g41 / kurbo 1e-3 | g41 / kurbo 1e-6 | g41 / cavalier with its fit | without it | g41 / Clipper2 |",
        );
        print("| --- | --- | --- | --- | --- | --- |");
        ratios.iter().for_each(|ratio| print(ratio));
    }
}

/// A row of times, and one of ratios.
fn line(sample: &Sample, loops: bool) -> (String, String) {
    let radius = sample.radii[usize::from(loops)];
    let (n, closed) = (sample.count, sample.closed);
    let spline = sample.spline();
    let cubics = kurbo_cubics(&spline);
    let arcs = biarcs(&spline, closed, PEERS_TOLERANCE);
    let chords = polygon(&spline, closed, PEERS_TOLERANCE);
    let ours = |tolerance| move || black_box(sample).avoided(radius, tolerance).moves.len();
    let theirs = |tolerance| {
        let cubics = &cubics;
        move || kurbo_pieces(black_box(cubics), radius, tolerance)
    };
    let [coarse, fine] = TOLERANCES;
    let timed = race(
        (WORK / n).clamp(7, 300),
        PATIENCE,
        [
            &mut || black_box(sample).spline().pieces().len(),
            &mut ours(coarse),
            &mut ours(fine),
            &mut theirs(coarse),
            &mut theirs(fine),
            &mut || cavalier_pieces(black_box(&arcs), radius),
            &mut || biarcs(black_box(&spline), closed, PEERS_TOLERANCE).vertex_data.len(),
            &mut || {
                if n > CLIPPER_LIMIT {
                    return 0;
                }
                clipper_vertices(black_box(&chords), closed, radius, PEERS_TOLERANCE)
            },
        ],
    );
    let title = format!("{} {n}, r {radius}", sample.name);
    let per = |timed: &Timed| timed.median() / n as f64;
    let cell = |timed: &Timed| format!("{:.0} ({:.2})", per(timed), timed.pieces as f64 / n as f64);
    let [spline, g41, g41_fine, kurbo, kurbo_fine, cavalier, fit, clipper] = &timed;
    let with_fit = per(cavalier) + per(fit);
    let no_clipper = n > CLIPPER_LIMIT;
    let row = format!(
        "| {title} | {} | {} | {} | {} | {} | {} | {:.0} | {} |",
        cell(spline),
        cell(g41),
        cell(g41_fine),
        cell(kurbo),
        cell(kurbo_fine),
        cell(cavalier),
        with_fit,
        if no_clipper { "left out".into() } else { cell(clipper) },
    );
    let against = |ratio: f64, target: f64| {
        let kept = if ratio <= target { "" } else { " ✗" };
        format!("{ratio:.2} (≤ {target:.2}){kept}")
    };
    let only = |ratio: f64| format!("{ratio:.2}");
    let (to_kurbo, to_kurbo_fine) = (per(g41) / per(kurbo), per(g41_fine) / per(kurbo_fine));
    let (to_fit, to_cavalier) = (per(g41) / with_fit, per(g41) / per(cavalier));
    let ratio = format!(
        "| {title} | {} | {} | {} | {} | {} |",
        if loops { only(to_kurbo) } else { against(to_kurbo, 1.0) },
        if loops { only(to_kurbo_fine) } else { against(to_kurbo_fine, 1.0 / 3.0) },
        if loops { against(to_fit, 0.5) } else { only(to_fit) },
        only(to_cavalier),
        if no_clipper { "left out".into() } else { against(per(g41) / per(clipper), 0.02) },
    );
    (row, ratio)
}

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    let largest = std::env::args().filter_map(|argument| argument.parse().ok()).next();
    table(largest.unwrap_or(usize::MAX));
}

#[cfg(target_arch = "wasm32")]
#[wasm_bindgen_test::wasm_bindgen_test]
fn print_table() {
    table(usize::MAX);
}
