//! What is reported of a program, and what is not.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::diagnostic::Origin;
use g41::program::{Dialect, Interpretation, Program, Rules, interpret};

use super::sample::{
    ERROR, INFO, WARNING, codes, contours, found, moves, near, read, read_as_fanuc, read_clean,
    words,
};

#[test]
fn words_are_named_as_they_are_written() {
    let read = read_as_fanuc("G0 X0. Y0.\nG1 X20. ,A45. F100\n");
    let told: Vec<_> = read.diagnostics.iter().map(|found| found.message.as_str()).collect();
    assert_eq!(told, ["the word ,A45 is not understood here"], "with the comma");
}

#[test]
fn every_fault_is_reported_with_its_line_and_column() {
    for (text, code, severity, column) in [
        ("G1 X1 Q5 F1", "word-not-understood", ERROR, Some(7)),
        ("G1 X1 G6 F1", "word-not-understood", ERROR, Some(7)),
        ("G91 G1 X1 A90 F1", "unknown-start", WARNING, Some(11)),
        ("G1 X1 E F1", "missing-number", ERROR, Some(7)),
        ("G1 X1 Y1.2.3 F1", "garbled-number", ERROR, Some(7)),
        ("G1 X1 Y--3 F1", "garbled-number", ERROR, Some(7)),
        ("G1 X1 Y12345678901 F1", "number-too-large", ERROR, Some(7)),
        ("G1 X1 (c) 12 F1", "number-without-letter", ERROR, Some(11)),
        ("G1 X1 X2 F1", "repeated-word", ERROR, Some(7)),
        ("G1 X1 €€ F1", "unexpected-character", ERROR, Some(7)),
        ("(€) X1 €€ F1", "unexpected-character", ERROR, Some(8)),
        ("G1 X1 F1 (open", "unclosed-comment", WARNING, Some(10)),
        ("G1 X1 Y#3 F1", "unset-parameter", WARNING, Some(8)),
        ("G1 X1 Y#<a> F1", "unset-parameter", ERROR, Some(8)),
        ("G1 X1 Y[1/[2-2]] F1", "division-by-zero", ERROR, Some(10)),
        ("G1 X1 Y[1 F1", "bad-expression", ERROR, Some(11)),
        ("G1 X1 [1+1] F1", "bad-expression", ERROR, Some(7)),
        ("G1 X1 Y[1e3] F1", "bad-expression", ERROR, Some(10)),
        ("G1 X1 #1 F1", "bad-expression", ERROR, Some(7)),
        ("G1 X1 Y#5221 F1", "unknown-parameter", ERROR, Some(8)),
        ("#5221=3", "bad-parameter", ERROR, Some(1)),
        ("#1.5=3", "bad-parameter", ERROR, Some(2)),
        ("#99999=3", "bad-parameter", ERROR, Some(2)),
        ("#<a=3", "bad-parameter", ERROR, Some(2)),
        ("o<name> call", "missing-subprogram", ERROR, Some(1)),
        ("o<name>", "unknown-flow", ERROR, Some(1)),
        ("o1 endif", "unmatched-flow", ERROR, None),
        ("o1 if [1]", "unmatched-flow", ERROR, None),
        ("G0 G1 X1 F1", "conflicting-words", ERROR, Some(4)),
        ("G93 G1 X2", "missing-feed", ERROR, Some(1)),
        ("G95 G1 X2 F1", "unknown-speed", ERROR, Some(1)),
        ("G33 Z5", "missing-lead", ERROR, Some(1)),
        ("G12.1", "not-supported", ERROR, Some(1)),
        ("N5 G53 G2 X5 R9", "no-motion-mode", ERROR, Some(4)),
        ("G10 P1 X0", "not-supported", ERROR, Some(1)),
        ("G51 P0", "bad-scale", ERROR, Some(1)),
        ("G51 P2000", "scale-in-thousandths", INFO, Some(5)),
        ("G68 X0 Y0", "missing-angle", ERROR, Some(1)),
        ("@5 ^30 X2", "contradictory-words", ERROR, Some(1)),
        ("G18 G2 X5 Z5 J5 R9 F1", "contradictory-words", ERROR, Some(14)),
        ("G2 X5 Y0 I2 P0 F1", "bad-turns", ERROR, Some(13)),
        ("M70", "not-supported", ERROR, Some(1)),
        ("G1 X1 F-5", "bad-feed", ERROR, Some(7)),
        ("G4", "bad-dwell", ERROR, Some(1)),
        ("G4 P500", "long-dwell", WARNING, Some(4)),
        ("M98 P1000", "missing-subprogram", ERROR, Some(1)),
        ("T1.5", "word-not-understood", ERROR, Some(1)),
        ("G41 D1.5", "bad-tool-number", ERROR, Some(5)),
        ("G41 D0", "no-radius", WARNING, Some(1)),
        ("G41.1", "missing-diameter", ERROR, Some(1)),
        ("G2 X5 Y0 I1 R2 F1", "contradictory-words", ERROR, Some(10)),
        ("G2 X5 Y0 F1", "arc-without-centre", ERROR, Some(1)),
        ("G2 X5 Y0 I1 F1", "radii-disagree", ERROR, Some(1)),
        ("G2 X5 Y0 R1 F1", "radius-too-small", ERROR, Some(1)),
        ("G2 X1 R2 F1", "full-circle-by-radius", ERROR, Some(1)),
        ("/G1 X2 F1", "block-delete", INFO, None),
        ("X5", "", INFO, None),
    ] {
        let read = read(&format!("G0 X1 Y0\n{text}\n"));
        let expected: &[_] = if code.is_empty() { &[] } else { &[(code, severity, 2, column)] };
        assert_eq!(found(&read), expected, "{text}: {:?}", read.diagnostics);
    }
}

#[test]
fn axes_without_a_motion_word_move_as_after_switching_on() {
    let read = read("X5 Y5\nX9\n");
    assert_eq!(found(&read), [("no-motion-mode", WARNING, 1, Some(1))], "before G00 or G01");
    assert!(moves(&read).len() == 2 && moves(&read)[1].rapid, "{read:?}");
    let feeds = super::sample::read("F100 X5 Y5\n");
    assert!(!moves(&feeds)[0].rapid, "at the feed: {feeds:?}");
    let strict = Rules { is_strict: true, ..Rules::default() };
    let read = interpret(&Program::parse("X5 Y5\nX9\n", Dialect::Auto), strict);
    assert_eq!(found(&read), [("no-motion-mode", ERROR, 1, Some(1))], "LinuxCNC stops");
    assert!(moves(&read).is_empty(), "{read:?}");
}

#[test]
fn faults_of_compensation_are_reported() {
    const START: &str = "G0 X0 Y-9\n";
    for (text, code, severity, contours_made) in [
        ("G41 D1\nG2 X9 Y0 R9 F100\nG40 G1 X20", "curved-lead-in", ERROR, 1),
        ("G41 D1 G5 X5 Y1\nX9 Y0 F100\nG40 G1 X20", "curved-lead-in", ERROR, 1),
        ("G41 D1 G1 Y0 F100\nX9\nG40 G2 X20 R9", "curved-lead-out", ERROR, 1),
        ("G41 D1 G1 Y0 F100\nX9\nM30", "compensation-left-on", WARNING, 1),
        ("G41 D1 G1 Y0 F100\nX9\nG42 X20\nG40 Y9", "side-changed", WARNING, 2),
        ("G41 D1 G1 Y0 F100\nX9\nG41 D2 X20\nG40 Y9", "radius-changed", WARNING, 2),
        ("G41 D1 G1 Y0 F100\nX9\nD2 X20\nG40 Y9", "radius-changed", WARNING, 2),
        ("G41 D1 G1 Y0 F100\nX9\nG40\nG41 X20\nX30\nG40 Y9", "no-lead-out", WARNING, 2),
        ("G41 D1 G1 Y0 F100\nG40 Y9", "empty-compensation", WARNING, 0),
        ("G41 D1 G1 Y0 F100\nX9\nX9\nG40 Y9", "zero-length", INFO, 1),
        ("G41 D1 G1 Y0 F100\nX9\nT2 M6\nX20\nG40 Y9", "changed-while-on", WARNING, 1),
        ("G41 D1 G1 Y0 F100\nX9\nG55\nX20\nG40 Y9", "changed-while-on", ERROR, 2),
        ("G41 D1 G1 Y0 F100\nX9\nG18\nX20\nG40 Y9", "changed-while-on", ERROR, 2),
        ("G41 D1 G1 Y0 F100\nX9\nG81 X20 Z-1 R0\nG40 G0 Y9", "cycle-not-possible", ERROR, 1),
    ] {
        let read = read(&format!("{START}{text}\n"));
        let seen: Vec<_> = found(&read).iter().map(|f| (f.0, f.1)).collect();
        assert_eq!(seen, [(code, severity)], "{text}: {:?}", read.diagnostics);
        assert_eq!(contours(&read).len(), contours_made, "{text}");
    }
}

#[test]
fn what_changes_nothing_is_not_reported() {
    let read = read_clean(
        "G17 G21 G40 G49 G80 G90 G94 G61\nG0 X0 Y-9\nG41 D1\nG40\nG41 D1 G1 Y0 F100\nX9\nG41 D1\n\
         G41 X20\nG40 Y-9\nG40\nM5\n",
    );
    assert_eq!(contours(&read).len(), 1, "repeating G41 goes on");
}

#[test]
fn an_empty_compensation_leaves_its_moves_and_words_in_order() {
    let read = read("G0 X0 Y-9\nG41 D1 G1 Y0 F100\nM8\nG40 Y9\n");
    let ends: Vec<_> = moves(&read).iter().map(|m| m.curve.end().y).collect();
    assert_eq!(ends, [-9.0, 0.0, 9.0], "{read:?}");
    assert_eq!(words(&read), ["M8"], "{read:?}");
}

#[test]
fn nothing_after_the_end_is_read() {
    for text in ["G0 X1\nM30\nX2\nX3\n", "G0 X1\nM2\n\nG0 X2", "%\nG0 X1\n%\nG0 X2\n"] {
        let read = read(text);
        let codes: Vec<_> = found(&read).iter().map(|f| f.0).collect();
        assert_eq!(codes, ["after-end"], "{text}");
        assert_eq!(moves(&read).len(), 1, "{text}");
    }
}

#[test]
fn comments_may_stand_before_the_program() {
    let read = read_clean("(POST X)\n; V2\n%\nO7\nG0 X1\nM30\n%\n");
    assert_eq!(moves(&read).len(), 1, "{read:?}");
    assert_eq!(words(&read), ["(POST X)", "; V2", "(O7)", "M30"], "{read:?}");
}

#[test]
fn every_fault_of_a_line_has_a_hint() {
    let read = read("5 $ G6 X1.2.3 Y #1 [2] o1 call X1e99\nX99999999999\nG2 X5 (\n");
    assert!(read.diagnostics.len() > 8, "{read:?}");
    for found in &read.diagnostics {
        assert!(found.hint.is_some(), "{found}");
    }
}

#[test]
fn line_ends_of_every_system_are_read() {
    for text in
        ["G0 X1\nX2\nX3", "G0 X1\r\nX2\r\nX3\r\n", "G0 X1\rX2\rX3\r", "\u{feff}G0 X1\nX2\nX3"]
    {
        let read = read_clean(text);
        let lines: Vec<_> = moves(&read).iter().map(|m| m.origin).collect();
        let line = |line| Origin::Block { line, number: None, column: None };
        assert_eq!(lines, [line(1), line(2), line(3)], "{text:?}");
    }
}

#[test]
fn spaces_and_small_letters_do_not_matter() {
    let spread = read_clean("n 10 g 1 x 10 y -2.5 f 600");
    let dense = read_clean("N10G1X10Y-2.5F600");
    let moves_of = |read: &Interpretation| {
        let found = moves(read)[0];
        (found.curve, found.feed, found.origin)
    };
    assert_eq!(moves_of(&spread), moves_of(&dense), "the same move");
}

#[test]
fn coordinates_out_of_range_do_not_move() {
    let read = read("G1 X1 F1\nG20 X999999999\nX1\n");
    assert_eq!(found(&read), [("out-of-range", ERROR, 2, Some(5))], "1e9 inches");
    assert!(near(moves(&read)[1].curve.end(), [25.4, 0.0]), "{read:?}");
}

#[test]
fn incremental_moves_from_an_unknown_place_are_reported_once() {
    let read = read("G91 G1 X5 F100\nX5 Y5\n");
    assert_eq!(found(&read), [("unknown-start", WARNING, 1, Some(8))], "once");
}

#[test]
fn lengths_without_a_point_are_told_once_where_fanuc_may_count_thousandths() {
    for (text, line) in [
        // Among others with one.
        ("G0 X10.5 Y2.\nX3\nX4\n", Some(2)),
        ("G0 X3 Y0\nX10.5\n", Some(1)),
        // Too far for whole units.
        ("G0 X50 Y0\nX20000\nY10000\n", Some(1)),
        ("G0 X50 Y0\nG2 X60 R5 F100\n", None),
        ("G0 X10.5 Y0\nG4 X2\nM98 P2000\nG65 P2000 X3\nM30\nO2000\nM99\n", None),
        ("#1=3\nG0 X1.5\nX#1\nX[3+1]\n", None),
    ] {
        let read = read_as_fanuc(text);
        let told = read.diagnostics.iter().filter(|d| d.code == "no-point");
        let lines: Vec<_> = told.map(|d| d.origin.map(line_of)).collect();
        let expected: Vec<_> = line.map(Some).into_iter().collect();
        assert_eq!(lines, expected, "{text}: {:?}", read.diagnostics);
    }
    assert!(codes("G0 X10.5 Y2.\nX3\n", Dialect::Auto).is_empty(), "elsewhere it is a number");
}

fn line_of(origin: Origin) -> u32 {
    if let Origin::Block { line, .. } = origin { line } else { 0 }
}
