//! Contours that are gone round more than once, gouges avoided: each lap as if it were alone.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::f64::consts::TAU;

use g41::compensation::{GougePolicy, Options};
use g41::contour::{Move, Role, ToolPath};
use g41::program::{Dialect, Program, Rules, interpret};
use g41::simulation::{Tools, check_program, compensate_program};

/// The path of a program that avoids gouges, and how many the judge finds on it.
fn avoided(text: &str, radius: f64) -> (ToolPath, usize) {
    let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
    let tools = Tools::all(radius);
    let options = Options { gouge: GougePolicy::Avoid, ..Options::default() };
    let path = compensate_program(&read, &tools, &options);
    let found = check_program(&read, &path, &tools, 1e-3).len();
    (path, found)
}

/// Laps one millimetre below each other, coolant switched between them, and the end of the way out.
fn laps(start: &str, lap: &str, out: &str, count: u32) -> String {
    let laps = (1..=count).map(|depth| format!("M8\nG1 Z-{depth}\n{lap}")).collect::<Vec<_>>();
    format!("G21 G90\n{start}{}G40 G1 {out}\nM30\n", laps.concat())
}

/// How far the tool cuts at each millimetre of depth [mm].
fn lengths(path: &ToolPath, count: u32) -> Vec<f64> {
    let cuts = |role| matches!(role, Role::Segment | Role::Transition);
    let cut = |depth: u32| {
        let at_depth = |step: &&Move| cuts(step.role) && step.heights[1] == -f64::from(depth);
        path.moves.iter().filter(at_depth).map(|step| step.curve.length()).sum()
    };
    (1..=count).map(cut).collect()
}

const TO_SQUARE: &str = "G0 X-20 Y20\nG41 D1 G1 X0 Y25 F600\n";
const SQUARE: &str = "Y50\nX50\nY0\nX0\nY25\n";
const OUT: &str = "X-20 Y30";

#[test]
fn each_lap_is_as_long_as_one_alone() {
    let radius = 3.0;
    let square = 4.0 * (50.0 + 2.0 * radius);
    let circle = |r: f64| TAU * r;
    for (start, lap, out, length) in [
        (TO_SQUARE, SQUARE, OUT, square),
        ("G0 X-20 Y20\nG41 D1 G1 X0 Y25 F600\n", "G2 X0 Y25 I20 J0\n", OUT, circle(20.0 + radius)),
        (
            "G0 X10 Y24\nG41 D1 G1 X0 Y25 F600\n",
            "G3 X0 Y25 I20 J0\n",
            "X10 Y26",
            circle(20.0 - radius),
        ),
        // As SQUARE, from the corner, with a way in that ends there.
        ("G0 X-20 Y-30\nG41 D1 G1 X0 Y-20 F600\n", "Y50\nX50\nY0\nX0\n", "X-20 Y-30", square),
    ] {
        for count in [1, 2, 3, 6] {
            let text = laps(start, lap, out, count);
            let (path, found) = avoided(&text, radius);
            assert_eq!((found, path.gouges.len()), (0, 0), "gouges in {text}");
            let lengths = lengths(&path, count);
            let last = lengths.len() - 1;
            let inner = lengths.get(1..last).unwrap_or(&[]);
            for one in inner {
                assert!((one - length).abs() < 1e-6, "{lengths:?}, not {length}: {text}");
            }
            // The way in and the way out count too, and where they meet the contour.
            for end in [lengths[0], lengths[last]] {
                assert!((end - length).abs() < 30.0, "{lengths:?}, not {length}: {text}");
            }
            let joined = path.moves.windows(2).skip_while(|pair| pair[0].role == Role::Free);
            for pair in joined {
                let gap = pair[0].curve.end().distance(pair[1].curve.start());
                assert!(gap < 1e-6, "a gap of {gap} mm at {}: {text}", pair[1].curve.start());
            }
        }
    }
}

#[test]
fn what_is_between_laps_happens_between_them() {
    let (path, _) = avoided(&laps(TO_SQUARE, SQUARE, OUT, 3), 3.0);
    let coolant: Vec<_> = path.words.iter().filter(|words| words.words == "M8").collect();
    assert_eq!(coolant.len(), 3, "{:?}", path.words);
    for (words, depth) in coolant.iter().zip([-1.0, -2.0, -3.0]) {
        let down = path.moves[words.before];
        assert_eq!(down.heights, [depth + 1.0, depth], "behind M8 it goes down: {down:?}");
        let at = down.curve.start();
        assert!((at.x + 3.0).abs() < 1e-9 && (at.y - 25.0).abs() < 1e-9, "beside the part: {at}");
    }
}

#[test]
fn what_no_lap_reaches_is_told_once() {
    // A slot of 4 mm, and a tool of 6.
    let slotted = "Y50\nX20\nY30\nX24\nY50\nX50\nY0\nX0\nY25\n";
    let (alone, _) = avoided(&laps(TO_SQUARE, slotted, OUT, 1), 3.0);
    for count in [2, 3, 5] {
        let (path, found) = avoided(&laps(TO_SQUARE, slotted, OUT, count), 3.0);
        assert_eq!(found, 0, "{count} laps");
        let areas = |path: &ToolPath| path.uncut.iter().map(|one| one.area).collect::<Vec<_>>();
        assert_eq!(areas(&path), areas(&alone), "{count} laps");
        let codes = |path: &ToolPath| path.diagnostics.iter().map(|d| d.code).collect::<Vec<_>>();
        assert_eq!(codes(&path), codes(&alone), "{count} laps");
    }
}

#[test]
fn the_way_down_is_beside_the_part_where_the_way_in_is_cut_off() {
    // The tool does not come to where the contour begins.
    let start = "G0 X4.074 Y-11.316\nG41 D1 G1 X12.23 Y-5.597 F600\n";
    let lap = "X9.244 Y3.868\nG2 X1.059 Y22.488 R60\nG1 X-17.088 Y20.382\nX-13.58 Y-2.565\n\
               X-9.343 Y-17.217\nX15.217 Y-15.061\nX12.23 Y-5.597\n";
    for count in 1..4 {
        let text = laps(start, lap, "X2.26 Y-5.61", count);
        let (path, found) = avoided(&text, 9.0);
        assert_eq!(found, path.gouges.len(), "what cuts is told, which are leads: {text}");
        for step in path.moves.iter().filter(|step| step.role == Role::Segment) {
            let from_start = step.curve.start().distance(glam::DVec2::new(12.23, -5.597));
            assert!(from_start > 8.99, "on the contour: {step:?}");
        }
    }
}
