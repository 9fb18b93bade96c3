//! What programs made by CAM systems and older controls have in their first and last lines.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::program::{Dialect, Program, Rules, interpret};

use super::sample::{ERROR, WARNING, codes, found, read, read_clean, steps, xs};

#[test]
fn the_end_of_cycles_beside_another_motion_word_leaves_that_one() {
    // LinuxCNC 2.9 makes the same moves of it.
    let read = read_clean("G0 G17 G40 G80 G90 X1 Y0 F9\nG80 G1 X5\nX9\n");
    assert_eq!(steps(&read), ["R 1 0 0", "5 0 0", "9 0 0"], "the other word stays");
    let drilling = read_clean("G0 X0 Y0 Z5\nG81 X1 Z-1 R1 F60\nG0 G80 X7\nX8\n");
    assert_eq!(steps(&drilling)[5..], ["R 7 0 5", "R 8 0 5"], "the cycle has ended");
}

#[test]
fn a_centre_of_zero_along_the_normal_is_as_good_as_none() {
    let read = read_clean("G0 X0 Y0\nG2 X20 Y20 I20 J0 K0.000 F100\n");
    assert_eq!(steps(&read).len(), 2, "FreeCAD writes it for every arc");
    // LinuxCNC stops there.
    let program = Program::parse("G0 X0 Y0\nG2 X20 Y20 I20 J0 K0 F100\n", Dialect::Auto);
    let strict = Rules { is_strict: true, ..Rules::default() };
    let codes: Vec<_> = interpret(&program, strict).diagnostics.iter().map(|d| d.code).collect();
    assert!(codes.contains(&"contradictory-words"), "{codes:?}");
}

#[test]
fn older_words_for_units_count_alone() {
    assert_eq!(steps(&read_clean("G70\nG0 X1 Y0\n")), ["R 25.4 0 0"], "G70: inches");
    assert_eq!(steps(&read_clean("G20\nG71 G91.1\nG0 X1 Y0\n")), ["R 1 0 0"], "G71: mm");
    let cycle = read("G0 X1\nG71 U2 R1\nG71 P10 Q20 U1 F1\n");
    let codes: Vec<_> = found(&cycle).iter().map(|f| f.0).collect();
    assert!(codes.contains(&"word-not-understood"), "the cycle of a lathe: {codes:?}");
}

#[test]
fn a_colon_is_the_o_of_a_program_number() {
    let called = read_clean("%\n:0040 (PART)\nG0 X1 Y0\nM98 P7\nM30\n:7\nX5\nM99\n%\n");
    let expected = ["(O40) (PART)", "R 1 0 0", "R 5 0 0", "M30"];
    assert_eq!(steps(&called), expected, "called by its number");
}

#[test]
fn a_block_without_frames_is_one_of_the_machine() {
    let read = interpret(
        &Program::parse("G0 X1 Y0 Z5\nSUPA Z0\nG1 X2 F9\n", Dialect::Sinumerik),
        Rules::default(),
    );
    assert_eq!(read.diagnostics, [], "SUPA is known");
    let expected = ["R 1 0 5", "G53 G0 Z0", "2 0 5"];
    assert_eq!(steps(&read), expected, "where it leads to the machine knows");
}

#[test]
fn orders_to_a_controller_are_left_out_a_line_each() {
    let read = read("$H\n$J=G91 X5 F100\nG0 X1 Y0\n");
    let expected = [("left-out", WARNING, 1, Some(1)), ("left-out", WARNING, 2, Some(1))];
    assert_eq!(found(&read), expected, "{:?}", read.diagnostics);
    assert_eq!(steps(&read), ["R 1 0 0"], "nothing of them moves");
}

#[test]
fn a_program_in_heidenhains_language_is_told_at_once() {
    let read = read("\n0 BEGIN PGM PART MM\n1 TOOL CALL 1 Z S3000\n2 L X+0 Y+10 RL F300\n");
    assert_eq!(found(&read), [("not-supported", ERROR, 2, None)], "{:?}", read.diagnostics);
    assert!(read.items.is_empty(), "and nothing of it is read");
}

#[test]
fn an_unknown_speed_is_told_once() {
    let read = read("G0 X1 Y0\nG96 S200 M3\nG95 G1 X2 F.2\nX3\nX4\n");
    let codes: Vec<_> = found(&read).iter().map(|f| (f.0, f.2)).collect();
    assert_eq!(codes, [("unknown-speed", 3)], "{:?}", read.diagnostics);
}

#[test]
fn a_lathe_program_that_does_not_say_its_plane_is_told() {
    let text = "G21\nG0 X44 Z5\nG42 D1 G0 X16 Z2\nG1 Z-20 F9\nX30\nG40 G0 X60 Z5\n";
    let codes: Vec<_> = read(text).diagnostics.iter().map(|d| d.code).collect();
    assert_eq!(codes, ["doubtful-plane"], "Y is never stated");
    let said = read(&text.replace("G21", "G21 G18"));
    assert_eq!(said.diagnostics, [], "with G18 all is well");
}

#[test]
fn a_lathe_program_that_counts_feeds_by_g99_is_told() {
    let lathe = "%\nO1\nG00 G18 G20 G40 G80 G99\nS500 M3\nG0 X1 Z1\nG1 Z0 F0.01\nM30\n%\n";
    assert_eq!(codes(lathe, Dialect::Fanuc), ["doubtful-feed"], "F.01 is no feed by the minute");
    for sure in [lathe.replace("G18", "G17"), lathe.replace("G99", "G95")] {
        assert_eq!(codes(&sure, Dialect::Fanuc), [""; 0], "{sure}");
    }
    let drilled = "G18 G0 X1 Y5 Z1\nG99 G81 X2 Y-3 R1 F60\nG80\n";
    assert_eq!(codes(drilled, Dialect::Fanuc), [""; 0], "a cycle goes back to R");
}

#[test]
fn what_stands_twice_excludes_nothing() {
    let read = read_clean("G0 G0 X1 Y0 F9\nG90 G1 G90 X2\n// no block\n");
    assert_eq!(steps(&read), ["R 1 0 0", "2 0 0"], "and two slashes begin a comment");
    let short = "#1=0\nG0 X9\nWH[#1LT3]DO1;\n#1=#1+1\nX#1\nEND1\nM30\n";
    assert_eq!(xs(short, Dialect::Fanuc), [9.0, 1.0, 2.0, 3.0], "two letters for WHILE");
}
