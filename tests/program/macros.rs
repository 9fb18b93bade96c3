//! FANUC's subprograms, macros and jumps.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::program::Dialect::{Auto, Fanuc, LinuxCnc};

use super::sample::{codes, words, xs};

#[test]
fn m98_calls_by_every_form() {
    let called = |call: &str| {
        let text = format!("%\nO1\nG0 X10 Y1\nG91\n{call}\nX100\nM30\nO1234 (SUB)\nX1\nM99\n%\n");
        xs(&text, Auto).last().copied()
    };
    assert_eq!(called("M98 P1234"), Some(111.0), "once");
    assert_eq!(called("M98 P1234 L5"), Some(115.0), "L");
    assert_eq!(called("M98 P51234"), Some(115.0), "digits before the last four");
    assert_eq!(called("M98 P51234 L1"), Some(115.0), "digits and L");
    assert_eq!(called("M98 P1234 L0"), Some(110.0), "not at all");
    assert_eq!(called("X5 M98 P1234"), Some(116.0), "the move of the block comes first");
    assert_eq!(called("N5 M98P1234"), Some(111.0), "without space");
}

#[test]
fn parameters_are_shared_by_m98() {
    // LinuxCNC documents 5.25 for the last value of #1.
    let text = "O1 ; Main program 1\n#1 = 0\nM98 P100 L5 ; call\nG0 X#1\nM30\nO100\n#1 = [#1 + 1]\n\
                M98 P200 L5\nM99\nO200\n#1 = [#1 + 0.01]\nM99\n";
    assert_eq!(xs(text, LinuxCnc), [5.25], "{text}");
    assert_eq!(xs(text, Auto), [5.25], "{text}");
}

#[test]
fn g65_sets_the_parameters_of_its_letters() {
    // The manual's example of a mixture: #1 is 1, #2 is 2, #4 is −3, and D wins #7.
    let text = "G65 P1000 A1.0 B2.0 I-3.0 I4.0 D5.0\nM30\nO1000\nG0 X#1\nX#2\nX#4\nX#7\nM99\n";
    assert_eq!(xs(text, Fanuc), [1.0, 2.0, -3.0, 5.0], "{text}");
    let letters = "ABCIJKDEFHMQRSTUVWXYZ";
    let numbers = [1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 13, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26];
    for (letter, number) in letters.chars().zip(numbers) {
        let text = format!("G65 P9 {letter}42.5\nM30\nO9\nG0 X#{number}\nM99\n");
        assert_eq!(xs(&text, Fanuc), [42.5], "{letter} sets #{number}");
    }
    let groups =
        "G65 P9 A1 B2 C3 I4 J5 K6 I7 J8 K9 I10\nM30\nO9\nG0 X#6\nX#7\nX#8\nX#9\nX#10\nM99\n";
    assert_eq!(xs(groups, Fanuc), [6.0, 7.0, 8.0, 9.0, 10.0], "the second form");
}

#[test]
fn a_macro_has_parameters_of_its_own() {
    let text = "#1=5\n#100=1\nG65 P9 X7\nG0 X#1\nX#100\nM30\nO9\nIF [#1 EQ #0] THEN #1=8\nG0 X#1\n\
                X#24\n#100=3\nM99\n";
    assert_eq!(xs(text, Fanuc), [8.0, 7.0, 5.0, 3.0], "{text}");
    let again = "G0 X1\nG91 G65 P9 L3 A2\nM30\nO9\nX#1\n#1=50\nM99\n";
    assert_eq!(xs(again, Fanuc), [1.0, 3.0, 5.0, 7.0], "each time with its arguments");
}

#[test]
fn goto_looks_downwards_and_then_from_the_beginning() {
    let text = "#1=0\nN10 #1=#1+1\nG0 X#1\nIF [#1 LT 3] GOTO 10\nGOTO30\nX99\nN30 X7\nM30\n";
    assert_eq!(xs(text, Fanuc), [1.0, 2.0, 3.0, 7.0], "{text}");
    let computed = "#1=20\nGOTO#1\nN10 G0 X1\nN20 G0 X2\nGOTO[#1+10]\nX3\nN30 X4\nM30\n";
    assert_eq!(xs(computed, Fanuc), [2.0, 4.0], "a computed number");
    let own = "N10 G0 X1\nM98 P5\nM30\nO5\nGOTO 10\nG0 X2\nN10 G0 X3\nM99\n";
    assert_eq!(xs(own, Fanuc), [1.0, 3.0], "in its own program");
    assert_eq!(codes("G0 X1\nGOTO 5\nM30\n", Fanuc), ["missing-block"], "nowhere");
    assert_eq!(codes("G0 X1\nGOTO\nM30\n", Fanuc), ["bad-expression"], "no number");
}

#[test]
fn while_loops_end_at_their_number() {
    let text = "#1=1\nWHILE [#1 LE 2] DO1\n#2=1\nWHILE[#2LE2]DO2\nG0X[10*#1+#2]\n#2=#2+1\nEND2\n\
                #1=#1+1\nEND1\nX0\nM30\n";
    assert_eq!(xs(text, Fanuc), [11.0, 12.0, 21.0, 22.0, 0.0], "{text}");
    let out = "#1=0\nDO1\n#1=#1+1\nG0 X#1\nIF [#1 GE 3] GOTO 9\nEND1\nN9 X8\nM30\n";
    assert_eq!(xs(out, Fanuc), [1.0, 2.0, 3.0, 8.0], "without a condition");
    assert_eq!(codes("WHILE [1 EQ 1] DO1\nG0 X1\n", Fanuc), ["unmatched-flow"], "no end");
    assert_eq!(codes("G0 X1\nEND1\n", Fanuc), ["unmatched-flow"], "no beginning");
}

#[test]
fn if_then_assigns() {
    let text = "#1=4\nIF [#1 GT 3] THEN #2=10\nIF [#1 GT 5] THEN #2=20\nG0 X#2\nM30\n";
    assert_eq!(xs(text, Fanuc), [10.0], "{text}");
}

#[test]
fn m99_returns_and_may_say_where_to() {
    let text = "O1\nG0 X1\nM98 P2\nX99\nN50 X3\nM30\nO2\nG0 X2\nM99 P50\n";
    assert_eq!(xs(text, Fanuc), [1.0, 2.0, 3.0], "{text}");
    assert_eq!(codes("O1\nG0 X1\nM99\n", Fanuc), ["endless-program"], "in the main program");
    let skipped = "O1\nG0 X1\nM99 P9\nX5\nN9 X2\nM30\n";
    assert_eq!(xs(skipped, Fanuc), [1.0, 2.0], "a jump in the main program");
}

#[test]
fn subprograms_without_end_return_with_a_warning() {
    assert_eq!(codes("M98 P2\nM30\nO2\nG0 X1\n", Fanuc), ["unfinished-subprogram"], "text ends");
    let next = "M98 P2\nG0 X5\nM30\nO2\nG0 X1\nO3\nG0 X9\nM99\n";
    assert_eq!(codes(next, Fanuc), ["unfinished-subprogram"], "another begins");
    assert_eq!(codes("O1\nG0 X1\nO2\nG0 X2\nM99\n", Fanuc), ["no-program-end"], "no M30");
}

#[test]
fn what_is_not_in_the_text_is_not_called() {
    for text in ["M98 P77\nG0 X1\n", "M98\nG0 X1\n", "G65 A1\nG0 X1\n", "G65 P77 A1\nG0 X1\n"] {
        assert_eq!(codes(text, Fanuc), ["missing-subprogram"], "{text}");
    }
    assert_eq!(codes("G66 P77 A1\nG0 X1\nG67\n", Fanuc), ["missing-subprogram"], "modal calls");
}

#[test]
fn an_alarm_of_the_program_ends_it() {
    let text = "G0 X1\nIF [#5001 GT 0] THEN #3000=1 (TOO FAR)\nX2\nM30\n";
    assert_eq!(codes(text, Fanuc), ["program-alarm"], "{text}");
}

#[test]
fn only_the_main_program_has_a_title() {
    let read = super::sample::read_clean("%\nO1 (LID)\nM98 P2\nM30\nO2 (HOLE)\nG0 X1\nM99\n%\n");
    assert_eq!(words(&read), ["(O1) (LID)", "(HOLE)", "M30"], "{read:?}");
}

#[test]
fn m97_and_m98_h_call_blocks_of_the_program_itself() {
    let text = "%\nO1\nG0 X10\nG91\nM97 P5 L2\nX100\nM30\nN5 X1\nX2\nM99\n%\n";
    assert_eq!(xs(text, Fanuc), [10.0, 11.0, 13.0, 14.0, 16.0, 116.0], "Haas, behind the end");
    assert_eq!(xs(&text.replace("M97 P5", "M98 H5"), Fanuc)[3..], [14.0, 16.0, 116.0], "FANUC");
    assert_eq!(codes("G0 X1\nM97 P7\nM30\n", Fanuc), ["missing-subprogram"], "no such block");
}
