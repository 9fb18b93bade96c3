//! Where `LinuxCNC` stops, the path stops too, before the move whose end it does not know.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::run::{end, errors, run};
use glam::DVec3;

/// A program up to its fault, the code of the error, its line, and where the path ends.
const CASES: [(&str, &str, u32, [f64; 2]); 27] = [
    // The step of 0.1 is shorter than what two inside corners take of it.
    (
        "G21 G0 X0 Y0 F10\nG41.1 D0.25\nG1 X1\nG1 X2\nG1 Y0.1\nG1 X1\nG40\nG1 X2",
        "corner-refused",
        6,
        [1.875, 0.125],
    ),
    (
        "G21 G0 X0 Y0 F10\nG41.1 D0.25\nG1 X1\nG1 X2\nG40\nG2 I1 J0",
        "curved-lead-out",
        6,
        [2.0, 0.125],
    ),
    ("G21 G0 X0 Y0 F10\nG41.1 D4\nG1 X2\nG1 X9\nG40\nG1 X20", "short-lead-in", 3, [0.0, 0.0]),
    ("G21 G0 X0 Y0 Z5 F10\nG41.1 D4\nG1 Z0\nG1 X9\nG1 X20", "short-lead-in", 3, [0.0, 0.0]),
    ("G21 G0 X0 Y0 F10\nG41.1 D4\nG3 X0 Y1 R5\nG1 X9", "short-lead-in", 3, [0.0, 0.0]),
    ("G21 G0 X0 Y0 F10\nG41.1 D4\nG1 X9\nG3 X10 Y1 R1\nG1 Y9", "arc-refused", 4, [0.0, 0.0]),
    ("G21 G0 X0 Y0 F10\nG41.1 D4\nG1 X9\nG1 X20\nG42.1 D4\nG1 X30", "refused", 5, [9.0, 2.0]),
    ("G21 G0 X0 Y0 F10\nG41.1 D4\nG41.1 D4\nG1 X9\nG1 X20", "refused", 3, [0.0, 0.0]),
    ("G21 G0 X0 Y0 F10\nG41.1 D4\nG1 X9\nG1 X20\nG55\nG1 X30", "refused", 5, [9.0, 2.0]),
    ("G21 G0 X0 Y0 F10\nG41.1 D4\nG1 X9\nG1 X20\nT2 M6\nG1 X30", "refused", 5, [9.0, 2.0]),
    ("G21 G0 X0 Y0 F10\nG41.1 D4 L2\nG1 X9\nG1 X20", "refused", 2, [0.0, 0.0]),
    ("G21 T5 M6 G0 X0 Y0 F10\nG41\nG1 X9\nG1 X20", "refused", 2, [0.0, 0.0]),
    ("G21 G0 X0 Y0 F10\nG41.1 D4\nG1 X9\nG1 X20\nG92 X0\nG1 X30", "refused", 5, [9.0, 2.0]),
    ("G21 G0 X0 Y0 F10\nG41.1 D4\nG1 X9\nG1 X20\nG10 L2 P1 X5\nG1 X30", "refused", 5, [9.0, 2.0]),
    ("G21 G0 X0 Y0 F10\nG41.1 D4\nG1 X9\nG1 X20\nG28\nG1 X30", "refused", 5, [9.0, 2.0]),
    ("G21 G0 X0 Y0 F10\nG41.1 D4\nG1 X9\nG1 X20\nG53 G1 X3\nG1 X30", "refused", 5, [9.0, 2.0]),
    ("G21 G0 X0 Y0 F10\nG41.1 D4\nG1 X9\nG1 X20\nG18\nG1 X30", "refused", 5, [9.0, 2.0]),
    ("G21 G0 X0 Y0 F10\nG41.1 D4\nG1 X9\nG1 X20\nG64 P0.1\nG1 X30", "refused", 5, [9.0, 2.0]),
    ("G21 G0 X0 Y0 F10\nG41.1 D4\nG1 X9\nG1 X20\nG99\nG1 X30", "refused", 5, [9.0, 2.0]),
    ("G21 G0 X0 Y0 F10\nG41.1 D4\nG1 X9\nG1 X20\nG49\nG1 X30", "refused", 5, [9.0, 2.0]),
    ("G21 G0 X0 Y0 F10\nG41.1 D4\nG1 X9\nG1 X20\nM62 P1\nG1 X30", "refused", 5, [9.0, 2.0]),
    ("G21 G0 X0 Y0 F10\nG41.1 D4\nG1 X9\nG1 X20\nG81 X1 R2 Z-5\nG1 X30", "refused", 5, [9.0, 2.0]),
    ("G21 G19 G0 X0 Y0 F10\nG41.1 D4\nG1 Y9\nG1 Y20", "refused", 2, [0.0, 0.0]),
    // A tool that is not in the table.
    ("G21 G0 X0 Y0 F10\nG41 D8\nG1 X9\nG1 X20\nG40 G1 X30", "missing-radius", 2, [0.0, 0.0]),
    // Arcs that cannot be.
    ("G21 G0 X0 Y0 F10\nG41.1 D2\nG1 X9\nG3 X30 Y1 R5\nG1 X50", "radius-too-small", 4, [0.0, 0.0]),
    ("G21 G0 X5 Y0 F10\nG3 X30 Y1 I5 J0\nG1 X50", "radii-disagree", 2, [5.0, 0.0]),
    // Two arcs about one centre.
    (
        "G21 G0 X0 Y0 F10\nG41.1 D2\nG1 X9\nG3 X9 Y10 I0 J5\nG2 X9 Y0 I0 J-5\nG40\nG1 X0",
        "corner-refused",
        5,
        [9.0, 1.0],
    ),
];

#[test]
fn the_path_ends_before_the_move_that_was_not_sure() {
    for (text, code, line, [x, y]) in CASES {
        let path = run(text, &[(5, 2.0, 3)]);
        assert_eq!(errors(&path), [code], "{text}\n{:?}", path.diagnostics);
        let found = path.diagnostics.iter().find(|found| found.code == code).expect("the error");
        let at = match found.origin {
            Some(g41::diagnostic::Origin::Block { line, .. }) => line,
            _ => 0,
        };
        assert_eq!(at, line, "{text}");
        let last = path.moves.last().map_or(DVec3::ZERO, end);
        assert!(last.truncate().distance(glam::DVec2::new(x, y)) < 1e-9, "{text}\nends at {last}");
    }
}

#[test]
fn what_comes_after_g40_in_its_block_is_not_refused() {
    let path = run("G21 G0 X0 Y0 F10\nG41.1 D4\nG1 X9\nG1 X20\nG40 G49 G64 P0.1\nG1 X30", &[]);
    assert_eq!(errors(&path), [""; 0], "{:?}", path.diagnostics);
    assert_eq!(path.moves.last().map(|last| end(last).x), Some(30.0), "{:?}", path.moves);
}

#[test]
fn without_a_radius_the_same_programs_run_to_their_ends() {
    for text in [
        "G21 G0 X0 Y0 F10\nG41.1 D0\nG1 X1\nG1 X2\nG40\nG2 I1 J0\nG1 X5",
        "G21 G0 X0 Y0 F10\nG41.1 D0\nG1 Z5\nG3 X2 Y2 R2\nG40 G1 X5",
    ] {
        let path = run(text, &[]);
        assert_eq!(errors(&path), [""; 0], "{:?}", path.diagnostics);
        assert_eq!(path.moves.last().map(|last| end(last).x), Some(5.0), "{text}");
    }
}

#[test]
fn a_circle_made_of_an_arc_that_a_corner_takes_away_is_told() {
    let arc = |radius: f64| {
        let text = format!(
            "G21 G0 X-40 Y0 F10\nG41.1 D4\nG1 X-20\nX0\nG3 X{radius} Y{radius} J{radius}\nG1 X-8\nG40 X-20 Y20"
        );
        let path = run(&text, &[]);
        assert_eq!(errors(&path), [""; 0], "{text}\n{:?}", path.diagnostics);
        path.diagnostics.iter().any(|found| found.code == "full-circle")
    };
    assert!(arc(4.0), "half as wide as the arc, the tool meets the way back where the arc begins");
    assert!(!arc(9.0), "there is an arc left for a small tool");
}
