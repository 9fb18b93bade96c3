//! Words that are not known, and what else of their block counts then.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::diagnostic::Severity;
use g41::program::{Dialect, Program, Rules, interpret};

use super::sample::{ERROR, WARNING, codes, found, read, read_as_fanuc, read_clean, steps, xs};

#[test]
fn axes_beside_an_unknown_g_word_do_not_move() {
    // A pocket of Haas (G150), whose Z is its depth, not a rapid move to it.
    let pocket = read_as_fanuc("G0 X2 Y1 Z5\nG150 Z-3 I1 K2 Q1 D2 F10\nG1 X3\n");
    let expected = [("word-not-understood", ERROR, 2, Some(1))];
    assert_eq!(found(&pocket), expected, "one for the block: {:?}", pocket.diagnostics);
    assert_eq!(steps(&pocket), ["R 2 1 5", "3 1 5"], "nothing goes to its depth");
    let hint = "it has no effect, and its block moves nothing";
    assert_eq!(pocket.diagnostics[0].hint, Some(hint.into()), "and that is said");
    // A cycle of lathes, D of which is no tool.
    let roughing = read("G18 G90 G0 X3 Y0 Z1\nG71 P10 Q20 U0.1 W0.1 D0.05 F0.1\n");
    assert_eq!(found(&roughing), [("word-not-understood", ERROR, 2, Some(1))], "told once");
    // With a motion word beside it the axes are that one's.
    assert_eq!(steps(&read("G0 X1 Y0\nG1 G777 X5 F9\n")), ["R 1 0 0", "5 0 0"], "as it says");
    // What is modal beside it counts.
    assert_eq!(steps(&read("G91 G777\nG1 X5 F9\nX5\n")), ["5 0 0", "10 0 0"], "G91 counts");
    // LinuxCNC 2.9 stops: «Unknown g code used».
    let program = Program::parse("G0 X1 Y0\nG70 Q1 X5 D3\nG0 X7\n", Dialect::LinuxCnc);
    let strict = interpret(&program, Rules { is_strict: true, ..Rules::default() });
    let codes: Vec<_> = strict.diagnostics.iter().map(|d| (d.code, d.severity)).collect();
    assert_eq!(codes, [("word-not-understood", Severity::Error)], "before it looks at D");
    assert_eq!(steps(&strict), ["R 1 0 0"], "and goes no further");
}

#[test]
fn an_axis_without_number_beside_g28_goes_home_alone() {
    // As Marlin documents it: only the axes that are named, with a number or without.
    let home = read_clean("G0 X5 Y6 Z7\nG28 X\n");
    assert_eq!(steps(&home), ["R 5 6 7", "G91 G28 X0", "G90"], "not all of them");
    let two = read_clean("G0 X5 Y6 Z7\nG28 X Y\n");
    assert_eq!(steps(&two), ["R 5 6 7", "G91 G28 X0 Y0", "G90"], "two of them");
    assert_eq!(found(&read("G1 X F9\n"))[0].0, "missing-number", "in other blocks it is wrong");
    assert_eq!(codes("%\nO1\nG28 X\n%\n", Dialect::Fanuc), ["missing-number"], "for FANUC too");
}

#[test]
fn what_follows_do_is_told() {
    let text = "#1=3\nWHILE [#1 GT 0] DO1 #1=#1-1\nX#1\n#1=#1-2\nEND1\n";
    let read = read_as_fanuc(&format!("G0 X9\n{text}"));
    let expected = ("words-after-flow", ERROR, 3, Some(21));
    assert_eq!(found(&read).first(), Some(&expected), "{:?}", read.diagnostics);
    let comment = "#1=2\nG0\nWHILE [#1 GT 0] DO1 (UP TO 2)\n#1=#1-1\nX#1\nEND1\n";
    assert_eq!(xs(comment, Dialect::Fanuc), [1.0, 0.0], "a comment may stand there");
}

#[test]
fn parameters_that_some_controls_let_programs_set() {
    // LinuxCNC 2.9 takes it: it says whether DEBUG comments are shown.
    assert_eq!(xs("#5599=0\nG0 X[#5599+2]\n", Dialect::LinuxCnc), [2.0], "#5599");
    // Haas has #10000 to #10999.
    assert_eq!(xs("#10100=-2.5\nG0 X#10100\n", Dialect::Fanuc), [-2.5], "#10100");
    assert_eq!(codes("#11000=1\n", Dialect::Fanuc), ["bad-parameter"], "and no more");
    let machine = read("G0 X0 Y#<_task>\n");
    assert_eq!(found(&machine)[0].0, "unknown-parameter", "what only LinuxCNC knows at work");
}

#[test]
fn texts_for_the_display_are_no_words() {
    let shown = read("G21\nM117 Hello World 5%\nG0 X1 Y0\n");
    assert_eq!(shown.diagnostics, [], "nothing is wrong");
    assert!(steps(&shown)[0].contains("Hello World 5%"), "{:?}", steps(&shown));
    assert_eq!(
        steps(&read_clean("G0 X1 Y0;\n;\n()\nX2 ; ONE\n"))[..2],
        ["R 1 0 0", "; ONE"],
        "and what says nothing is none"
    );
    let warned = found(&read("M117\nG0 X1 Y0\n")).iter().any(|found| found.1 == WARNING);
    assert!(!warned, "nor without a text");
}
