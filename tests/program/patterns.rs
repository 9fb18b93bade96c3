//! Haas' circular pockets and patterns of holes.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::compensation::{Options, compensate};
use g41::contour::{MoveCurve, Side, Tool};
use g41::program::{Dialect, Interpretation};
use glam::DVec2;

use super::sample::{codes, contours, moves, read, read_as_fanuc, steps};

const HEAD: &str = "G21 G90 G17\nG0 X10 Y20 Z5\n";

/// Where the holes are: the ends of the moves down.
fn holes(read: &Interpretation) -> Vec<[f64; 2]> {
    let all = moves(read);
    let down = all.iter().filter(|m| !m.rapid && m.heights[1] < m.heights[0]);
    down.map(|m| m.curve.end().to_array().map(|v| (v * 1e6).round() / 1e6)).collect()
}

fn drilled(blocks: &str) -> Vec<[f64; 2]> {
    let read = read_as_fanuc(&format!("{HEAD}{blocks}\nG80\nM30\n"));
    assert!(read.diagnostics.is_empty(), "{blocks}: {:?}", read.diagnostics);
    holes(&read)
}

#[test]
fn holes_lie_on_circles_arcs_and_lines() {
    let cycle = "G81 G98 Z-3 R1 F90 L0";
    let cross = [[20.0, 20.0], [10.0, 30.0], [0.0, 20.0], [10.0, 10.0]];
    for (blocks, expected) in [
        (format!("{cycle}\nG70 I10 J0 L4"), cross.to_vec()),
        // In one block with the cycle, and with the centre; no hole is there.
        ("G81 G70 X10 Y20 Z-3 R1 F90 I10 J0 L4".into(), cross.to_vec()),
        ("G81 G91 G70 X0 Y0 Z-4 R-4 F90 I10 J0 L4\nG90".into(), cross.to_vec()),
        (format!("{cycle}\nG71 I10 J90 K-90 L2"), vec![cross[1], cross[0]]),
        (format!("{cycle}\nG72 I5 J90 L3"), vec![[10.0, 20.0], [10.0, 25.0], [10.0, 30.0]]),
        (format!("{cycle}\nG70 X0 Y0 I1 J180 L2"), vec![[-1.0, 0.0], [1.0, 0.0]]),
    ] {
        assert_eq!(drilled(&blocks), expected, "{blocks}");
    }
    let inches = read("G20 G90\nG0 X0 Y0 Z1\nG81 Z-1 R.1 F9 L0\nG70 I1 J0 L1\nG80\n");
    assert_eq!(holes(&inches), [[25.4, 0.0]], "in the unit of the program");
}

#[test]
fn a_pocket_is_circles_about_its_centre() {
    let text = |word: &str| format!("{HEAD}{word}\nG0 Z5\nM30\n");
    // Haas' own words: finished in one pass, and roughed and finished.
    for (word, side, radii) in [
        ("G12 I15 F100 Z-12 D1", Side::Right, vec![15.0]),
        ("G13 I3 K15 Q5 F100 Z-12 D1", Side::Left, vec![3.0, 8.0, 13.0, 15.0]),
        ("G13 I5 K15 Q5 F100 Z-12 D1", Side::Left, vec![5.0, 10.0, 15.0]),
        // The depth may have been gone to before.
        ("G1 Z-12 F50\nG12 I5 K15 Q10 F100 D1", Side::Right, vec![5.0, 15.0]),
    ] {
        let read = read_as_fanuc(&text(word));
        assert!(read.diagnostics.is_empty(), "{word}: {:?}", read.diagnostics);
        let found = contours(&read);
        assert_eq!(found.len(), radii.len(), "{word}");
        for (programmed, radius) in found.iter().zip(radii) {
            let case = format!("{word}, {radius}");
            assert_eq!(programmed.side, side, "{case}");
            let tool = Tool::new(2.0, programmed.side).expect("a radius");
            let path = compensate(&programmed.contour, tool, &Options::default());
            let circles: Vec<_> = path.moves.iter().filter(|m| is_circle(&m.curve)).collect();
            assert!(!circles.is_empty(), "{case}: {:?}", path.moves);
            for circle in circles {
                let middle = circle.curve.point(0.5);
                let distance = middle.distance(DVec2::new(10.0, 20.0));
                assert!((distance - (radius - 2.0)).abs() < 1e-9, "{case}: {distance}");
                assert_eq!(circle.heights, [-12.0; 2], "{case}: at its depth");
            }
        }
    }
}

fn is_circle(curve: &MoveCurve) -> bool {
    matches!(curve, MoveCurve::Arc(_))
}

#[test]
fn a_pocket_goes_deeper_by_each_repetition() {
    // Each time by Z, as Haas shows it, under G91.
    let text = "G0 X0 Y0 Z5\nG1 Z0 F50\nG13 G91 Z-2 I5 D0 L3 F80\nG90 G0 Z5\n";
    let read = read_as_fanuc(text);
    assert!(read.diagnostics.is_empty(), "{:?}", read.diagnostics);
    // D0: what is programmed is the way of the tool's centre.
    let circles = moves(&read).iter().filter(|m| is_circle(&m.curve)).count();
    assert_eq!((circles, contours(&read).len()), (3, 0), "three circles, none compensated");
    let steps = steps(&read);
    let expected = ["0 0 -2", "5 0 -2", "5 0 -2", "0 0 -2", "0 0 -4", "5 0 -4"];
    assert_eq!(steps[2..8], expected, "down, out, round and back: {steps:?}");
    assert_eq!(steps[13], "0 0 -6", "three times: {steps:?}");
    assert_eq!(steps.last().map(String::as_str), Some("R 0 0 5"), "the words before still count");
}

#[test]
fn words_that_are_missing_are_told() {
    for (block, code) in [
        ("G13 I10 Z-3 F50", "bad-pattern"),
        ("G13 I10 K5 Q1 D1 Z-3 F50", "bad-pattern"),
        ("G13 I1 K5 D1 Z-3 F50", "bad-pattern"),
        ("G13 I1 K5 Q0 D1 Z-3 F50", "bad-pattern"),
        ("G13 I1 K5 Q.00001 D1 Z-3 F50", "bad-pattern"),
        ("G13 I1 D1 Z-3 L0 F50", "bad-pattern"),
        ("G81 Z-1 R1 F50 G70 I10 J0 L10001", "bad-pattern"),
        ("G18 G13 I1 D1 Z-3 F50", "bad-pattern"),
        ("G70 I10 J0 L4", "bad-pattern"),
        ("G81 Z-1 R1 F50 G71 I10 J0 L4", "bad-pattern"),
        ("G13 Z-3", "word-not-understood"),
        ("G71 P10 Q20 U1 W1 D5 F50", "word-not-understood"),
        ("G150 P1 Z-3 I1 F50", "word-not-understood"),
    ] {
        let text = format!("{HEAD}{block}\nM30\n");
        assert_eq!(codes(&text, Dialect::Fanuc), [code], "{block}");
    }
    for dialect in [Dialect::LinuxCnc, Dialect::Sinumerik] {
        let found = codes(&format!("{HEAD}G13 I10 Z-3 D1 F50\nM30\n"), dialect);
        assert_eq!(found, ["word-not-understood"], "{dialect:?} has no such word");
    }
}
