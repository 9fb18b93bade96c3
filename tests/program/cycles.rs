//! Canned cycles: the moves that `LinuxCNC` documents, and FANUC where it differs.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::program::{Dialect, Interpretation};

use super::sample::{ERROR, codes, found, moves, read, read_as_fanuc, read_clean, steps};

/// The steps after the first `skip`.
fn after(skip: usize, read: &Interpretation) -> Vec<String> {
    steps(read).into_iter().skip(skip).collect()
}

#[test]
fn drilling_goes_as_linuxcnc_documents_it() {
    // The three examples beside G81, from (1, 2, 3) twice and from (0, 0, 0).
    let first = read_clean("G0 X1 Y2 Z3\nG90 G81 G98 X4 Y5 Z1.5 R2.8 F60\n");
    assert_eq!(after(1, &first), ["R 4 5 3", "R 4 5 2.8", "4 5 1.5", "R 4 5 3"], "absolute");
    let second = read_clean("G0 X1 Y2 Z3\nG91 G81 G98 X4 Y5 Z-0.6 R1.8 L3 F60\n");
    let expected = [
        "R 1 2 4.8",
        "R 5 7 4.8",
        "5 7 4.2",
        "R 5 7 4.8",
        "R 9 12 4.8",
        "9 12 4.2",
        "R 9 12 4.8",
        "R 13 17 4.8",
        "13 17 4.2",
        "R 13 17 4.8",
    ];
    assert_eq!(after(1, &second), expected, "incremental, three times");
    let third = read_clean("G0 X1 Y1 Z1\nX0 Y0 Z0\nG90 G81 G98 X4 Y5 Z1.5 R2.8 F60\n");
    assert_eq!(after(2, &third), ["R 0 0 2.8", "R 4 5 2.8", "4 5 1.5", "R 4 5 2.8"], "from below");
}

#[test]
fn numbers_stay_from_hole_to_hole_and_g99_stays_at_r() {
    let read = read_clean("G0 X0 Y0 Z9\nG99 G81 X1 Z-2 R1 F60\nX2\nG98 Y3\nG80\nX5 G0\n");
    let expected = [
        "R 1 0 9", "R 1 0 1", "1 0 -2", "R 1 0 1", "R 2 0 1", "2 0 -2", "R 2 0 1", "R 2 3 1",
        "2 3 -2", "R 2 3 9", "R 5 3 9",
    ];
    assert_eq!(after(1, &read), expected, "the level before the first hole counts for G98");
}

#[test]
fn pecks_go_back_and_begin_a_hundredth_of_an_inch_off() {
    let start = "G0 X0 Y0 Z5\n";
    let deep = read_clean(&format!("{start}G83 X1 Z-5 R1 Q2.5 F60\n"));
    let expected = [
        "R 1 0 5",
        "R 1 0 1",
        "1 0 -1.5",
        "R 1 0 1",
        "R 1 0 -1.246",
        "1 0 -4",
        "R 1 0 1",
        "R 1 0 -3.746",
        "1 0 -5",
        "R 1 0 5",
    ];
    assert_eq!(after(1, &deep), expected, "G83 goes back to R, as LinuxCNC does");
    let chips = read_clean(&format!("{start}G73 G99 X1 Z-5 R1 Q3 F60\n"));
    let expected = ["R 1 0 5", "R 1 0 1", "1 0 -2", "R 1 0 -1.746", "1 0 -5", "R 1 0 1"];
    assert_eq!(after(1, &chips), expected, "G73 breaks the chip; the last step ends at the depth");
}

#[test]
fn each_cycle_leaves_the_bottom_in_its_way() {
    for (cycle, expected) in [
        ("G82 P0.5", vec!["1 0 -2", "G4 P0.5", "R 1 0 5"]),
        ("G85", vec!["1 0 -2", "1 0 1", "R 1 0 5"]),
        ("G86 P1", vec!["1 0 -2", "G4 P1", "M5", "R 1 0 5", "M3"]),
        ("G88 P1", vec!["1 0 -2", "G4 P1", "M5", "M0", "R 1 0 5", "M3"]),
        ("G89 P1", vec!["1 0 -2", "G4 P1", "1 0 5"]),
        ("G84", vec!["1 0 -2", "M5", "M4", "1 0 5", "M5", "M3"]),
        ("G74", vec!["1 0 -2", "M5", "M3", "1 0 5", "M5", "M4"]),
        ("G76 Q0.2", vec!["1 0 -2", "M19", "R 1.2 0 -2", "R 1.2 0 5", "R 1 0 5", "M3"]),
    ] {
        let read = read_clean(&format!("M3 S500\nG0 X0 Y0 Z5\n{cycle} X1 Z-2 R1 F60\n"));
        assert_eq!(after(4, &read), expected, "{cycle}");
    }
}

#[test]
fn fanuc_counts_milliseconds_repeats_by_k_and_leaves_threads_at_r() {
    let start = "M3 S500\nG0 X0 Y0 Z5\n";
    let read = read_as_fanuc(&format!("{start}G82 X1 Z-2 R1 P500 F60\n"));
    assert_eq!(after(4, &read), ["1 0 -2", "G4 P0.5", "R 1 0 5"], "milliseconds");
    let read = read_as_fanuc(&format!("{start}G84 X1 Z-2 R1 F60\n"));
    assert_eq!(after(6, &read), ["M4", "1 0 1", "M5", "M3", "R 1 0 5"], "out to R at feed");
    let read = read_as_fanuc(&format!("{start}G91 G81 X1 Z-3 R-4 K2 F60\n"));
    let expected = ["R 1 0 5", "R 1 0 1", "1 0 -2", "R 1 0 5", "R 2 0 5", "R 2 0 1", "2 0 -2"];
    assert_eq!(after(2, &read)[..7], expected, "R from the first level, Z from R");
    let read = read_as_fanuc(&format!("{start}G81 X1 Z-3 R1 K0 F60\nX7\n"));
    assert_eq!(after(2, &read)[0], "R 7 0 5", "K0 only keeps the numbers");
}

#[test]
fn back_boring_goes_in_aside_and_bores_upwards() {
    let read = read_as_fanuc("M3 S500\nG0 X0 Y0 Z5\nG87 X10 Z-8 R-12 Q1 F60\n");
    let expected = [
        "R 10 0 5",
        "M19",
        "R 11 0 5",
        "R 11 0 -12",
        "R 10 0 -12",
        "M3",
        "10 0 -8",
        "10 0 -12",
        "M19",
        "R 11 0 -12",
        "R 11 0 5",
        "R 10 0 5",
        "M3",
    ];
    assert_eq!(after(2, &read), expected, "from R up to the depth");
}

#[test]
fn cycles_work_along_the_normal_of_each_plane() {
    let read = read_clean("G18 G0 X0 Y5 Z0\nG81 X1 Z2 Y-3 R1 F60\nX4\n");
    let expected = ["R 1 5 2", "R 1 1 2", "1 -3 2", "R 1 5 2", "R 4 5 2", "R 4 1 2", "4 -3 2"];
    assert_eq!(after(1, &read)[..7], expected, "G18: Y is the depth");
    let read = read_clean("G19 G0 X5 Y0 Z0\nG81 Y1 Z2 X-3 R1 F60\n");
    assert_eq!(after(1, &read)[..3], ["R 5 1 2", "R 1 1 2", "-3 1 2"], "G19: X");
}

#[test]
fn holes_on_a_circle_by_polar_coordinates() {
    let text = "G0 X0 Y0 Z5\nG17 G90 G16\nG99 G81 X100 Y30 Z-20 R1 F200\nY150\nY270\nG15 G80\n";
    let read = read_clean(text);
    let bottoms: Vec<[f64; 2]> =
        moves(&read).iter().filter(|m| !m.rapid).map(|m| m.curve.end().to_array()).collect();
    let (half, root) = (50.0, 50.0 * 3.0_f64.sqrt());
    let expected = [[root, half], [-root, half], [0.0, -100.0]];
    assert_eq!(bottoms.len(), 3, "{bottoms:?}");
    for (hole, expected) in bottoms.iter().zip(expected) {
        let [x, y] = [hole[0] - expected[0], hole[1] - expected[1]];
        assert!(x.hypot(y) < 1e-9, "{bottoms:?}");
    }
}

#[test]
fn what_a_cycle_cannot_do_is_reported() {
    for (text, code) in [
        ("G81 X1 Z-2 F60", "missing-depth"),
        ("G81 X1 R1 F60", "missing-depth"),
        ("G81 X1 Z2 R1 F60", "retract-below-bottom"),
        ("G93 G81 X1 Z-2 R1 F60", "cycle-not-possible"),
        ("G83 X1 Z-2 R1 F60", "bad-peck"),
        ("G83 X1 Z-2 R1 Q0.00001 F60", "bad-peck"),
        ("G81 X1 Z-2 R1 L1.5 F60", "bad-repeats"),
        ("G81 X1 Z-2 R1 L1000000 F60", "bad-repeats"),
    ] {
        let read = read(&format!("G0 X0 Y0 Z5\n{text}\n"));
        let seen: Vec<_> = found(&read).iter().map(|f| (f.0, f.1, f.2)).collect();
        assert_eq!(seen, [(code, ERROR, 2)], "{text}: {:?}", read.diagnostics);
    }
}

#[test]
fn the_motion_before_fanucs_cycles_is_in_effect_after_them() {
    let read = read_as_fanuc("G0 X0 Y0 Z9\nG99 G81 X1 Z-2 R1 F60\nX2\nG80 Z20\nG80 X3\nM30\n");
    assert!(read.diagnostics.is_empty(), "{:?}", read.diagnostics);
    assert_eq!(after(8, &read), ["R 2 0 20", "R 3 0 20", "M30"], "{:?}", steps(&read));
    let cuts = read_as_fanuc("G0 X0 Y0 Z9\nG1 X1 F60\nG81 X1 Z-2 R1\nG80 Z20\n");
    assert_eq!(steps(&cuts).last().map(String::as_str), Some("1 0 20"), "G01, which was before");
}

#[test]
fn fanuc_keeps_the_heights_of_a_cycle_where_g91_comes_behind_them() {
    // A bolt circle whose first hole is absolute, and the others turn on by 120 degrees.
    let text = "G0 X0 Y0 Z5\nG16\nG99 G81 X50 Y30 Z-3 R2 F100\nG91 Y120\nY120\nG80 G15\n";
    let read = read_as_fanuc(text);
    let all = moves(&read);
    let cuts: Vec<_> = all.iter().filter(|one| !one.rapid).collect();
    assert_eq!(cuts.len(), 3, "a hole at each: {read:?}");
    for (cut, angle) in cuts.iter().zip([30.0_f64, 150.0, 270.0]) {
        let expected = glam::DVec2::from_angle(angle.to_radians()) * 50.0;
        assert!(cut.curve.start().distance(expected) < 1e-9, "{angle}: {cut:?}");
        assert_eq!(cut.heights, [2.0, -3.0], "{angle}: from R to the depth");
    }
    let incremental = read_as_fanuc("G0 X0 Y0 Z5\nG91 G99 G81 X9 Z-4 R-3 F60\nX9\nG90 X30\n");
    let expected = ["R 9 0 5", "R 9 0 2", "9 0 -2", "R 9 0 2", "R 18 0 2", "18 0 -2", "R 18 0 2"];
    let found = after(1, &incremental);
    assert_eq!(found[..7], expected, "R counts from where it began, the depth from R");
    assert_eq!(found[7..], ["R 30 0 2", "30 0 -2", "R 30 0 2"], "the same under G90");
}

#[test]
fn a_cycle_of_haas_without_r_begins_where_the_tool_is() {
    // As its users write it, on one spot too: everything is cut on the way down.
    let text = "G0 X20. Y45. Z2.\nG81 G98 Z-11. F90\nX30.\nG80\n";
    let read = read_as_fanuc(text);
    let expected = ["R 20 45 2", "20 45 -11", "R 20 45 2", "R 30 45 2", "30 45 -11", "R 30 45 2"];
    assert_eq!(steps(&read), expected, "{:?}", read.diagnostics);
    assert!(read.diagnostics.iter().all(|d| d.code == "no-retract"), "{:?}", read.diagnostics);
    assert!(!read.diagnostics.is_empty(), "it is told");
    for text in ["G81 X1. Z-11. F90\n", "G0 Z2.\nG81 X1. F90\n"] {
        assert_eq!(
            codes(text, Dialect::Fanuc),
            ["missing-depth"],
            "height or depth unknown: {text}"
        );
    }
}
