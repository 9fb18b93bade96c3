//! Subprograms, conditions and loops of RS274/NGC, mostly as `LinuxCNC`'s documentation has them.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::diagnostic::Origin;
use g41::program::Dialect::{Auto, LinuxCnc};
use g41::program::{Program, Rules, interpret};

use super::sample::{codes, ends, moves, read_clean, words, xs};

#[test]
fn a_subprogram_gets_its_arguments_and_leaves_those_of_its_caller() {
    let text = "o100 sub\nG0 X[#1+#2] Y#3\n#1=77\no100 endsub\n#1=5\no100 call [100] [2] [325]\n\
                G0 X#1\nM2\n";
    assert_eq!(ends(text, LinuxCnc), [[102.0, 325.0], [5.0, 325.0]], "{text}");
    let nested = "o1 sub\no2 call [#1*2]\nG0 X#1\no1 endsub\no2 sub\nG0 X#1\no2 endsub\n\
                  o1 call [3]\nM2\n";
    assert_eq!(xs(nested, LinuxCnc), [6.0, 3.0], "{nested}");
}

#[test]
fn names_are_local_unless_they_begin_with_an_underscore() {
    let text = "o<part> sub\n#<a>=#1\n#<_b>=[#<_b>+1]\nG0 X#<a>\no<part> endsub\n#<a>=9\n#<_b>=1\n\
                O<P A RT> CALL [4]\nG0 X#<a>\nX#<_b>\nM2\n";
    assert_eq!(xs(text, LinuxCnc), [4.0, 9.0, 2.0], "{text}");
    let gone = "o<p> sub\n#<a>=1\no<p> endsub\no<p> call\nG0 X[exists[#<a>]+5]\nM2\n";
    assert_eq!(xs(gone, LinuxCnc), [5.0], "{gone}");
}

#[test]
fn a_subprogram_may_return_early_and_with_a_value() {
    let text = "o1 sub\no2 if [#1 GT 5]\no1 return [#1*2]\no2 endif\nG0 X1\no1 endsub [3*4]\n\
                o1 call [6]\nG0 X#<_value>\no1 call [2]\nX[#<_value>+#<_value_returned>]\nM2\n";
    assert_eq!(xs(text, LinuxCnc), [12.0, 1.0, 13.0], "{text}");
    let without = "o1 sub\no1 endsub\no1 call\nG0 X[#<_value_returned>+2]\nM2\n";
    assert_eq!(xs(without, LinuxCnc), [2.0], "{without}");
}

#[test]
fn the_first_branch_that_holds_is_run() {
    let feed = |value: f64| {
        let text = format!(
            "#2={value}\no102 if [#2 GT 5]\nF100\no102 elseif [#2 LT 2]\nF200\no102 elseif [#2 EQ 3]\n\
             F300\no102 else\nF150\no102 endif\nG1 X1\nM2\n"
        );
        moves(&read_clean(&text))[0].feed.map(|feed| (feed * 60.0).round())
    };
    for (value, expected) in [(6.0, 100.0), (1.0, 200.0), (3.0, 300.0), (4.0, 150.0)] {
        assert_eq!(feed(value), Some(expected), "#2={value}");
    }
    assert_eq!(xs("o1 if [0]\nG0 X1\no1 endif\nG0 X2\n", LinuxCnc), [2.0], "without else");
}

#[test]
fn a_while_loop_asks_first() {
    // Documented: a sawtooth of ten teeth.
    let text = "G0 X1 Y0\n#1=0\nF25\no101 while [#1 LT 10]\nG1 X0\nG1 Y[#1/10] X1\n#1=[#1+1]\n\
                o101 endwhile\nM2\n";
    let seen = ends(text, LinuxCnc);
    assert_eq!(seen.len(), 21, "{seen:?}");
    assert!((seen[20][1] - 0.9).abs() < 1e-12, "{seen:?}");
    assert_eq!(xs("o1 while [0]\nG0 X1\no1 endwhile\nG0 X2\n", LinuxCnc), [2.0], "never");
}

#[test]
fn a_do_loop_asks_afterwards_and_continue_asks_at_once() {
    // Documented: #1 is 0, 1, 2 (set to 3 and continued, which ends it).
    let text = "#1=0\no100 do\nG0 X[#1+10]\no110 if [#1 EQ 2]\n#1=3\no100 continue\no110 endif\n\
                #1=[#1+1]\no100 while [#1 LT 3]\nG0 X#1\nM2\n";
    assert_eq!(xs(text, LinuxCnc), [10.0, 11.0, 12.0, 3.0], "{text}");
    let once = "o1 do\nG0 X1\no1 while [0]\nG0 X2\n";
    assert_eq!(xs(once, LinuxCnc), [1.0, 2.0], "at least once");
}

#[test]
fn break_leaves_its_loop() {
    let text = "#1=0\no1 while [1]\n#1=[#1+1]\nG0 X#1\no2 if [#1 EQ 3]\no1 break\no2 endif\n\
                o1 endwhile\nG0 X9\nM2\n";
    assert_eq!(xs(text, LinuxCnc), [1.0, 2.0, 3.0, 9.0], "while");
    let outer =
        "o1 repeat [5]\no2 repeat [5]\nG91 G0 X1\no1 break\no2 endrepeat\no1 endrepeat\nX5\n";
    assert_eq!(outer_xs(outer), [1.0, 6.0], "the outer of two");
    let next = "#1=0\no1 repeat [3]\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\nG0 X#1\n\
                o1 endrepeat\n";
    assert_eq!(xs(next, LinuxCnc), [1.0, 3.0], "continue goes on with the next");
}

fn outer_xs(text: &str) -> Vec<f64> {
    xs(&format!("G0 X0 Y1\n{text}"), LinuxCnc)[1..].to_vec()
}

#[test]
fn repeat_counts() {
    let text = "o103 repeat [5]\nG91 G0 X1 Y1\no103 endrepeat\nG90\n";
    assert_eq!(outer_xs(text), [1.0, 2.0, 3.0, 4.0, 5.0], "documented");
    assert_eq!(outer_xs("o1 repeat [0]\nX1\no1 endrepeat\nX2\n"), [2.0], "not at all");
    let nested = "G91\no1 repeat [3]\no2 repeat [2]\nX1\no2 endrepeat\nX10\no1 endrepeat\n";
    let last = outer_xs(nested).last().copied();
    assert_eq!(last, Some(36.0), "three times two of 1, and three of 10");
    let recursive = "o1 sub\no2 repeat [2]\nG91 G0 X1\no3 if [#1 GT 1]\no1 call [#1-1]\no3 endif\n\
                     o2 endrepeat\no1 endsub\no1 call [3]\n";
    let last = outer_xs(recursive).last().copied();
    assert_eq!(last, Some(14.0), "2 + 4 + 8: each level counts for itself");
}

#[test]
fn the_number_of_a_call_can_be_computed() {
    let text = "o102 sub\nG0 X1\no102 endsub\no103 sub\nG0 X2\no103 endsub\n#101=100\n\
                o[#101+3] call\no[#101+2] call\n#1=103\no#1 call\nM2\n";
    assert_eq!(xs(text, LinuxCnc), [2.0, 1.0, 2.0], "{text}");
}

#[test]
fn subprograms_may_stand_behind_the_end() {
    let text = "o1 call\nG0 X5\nM2\no1 sub\nG0 X1\no1 endsub\n";
    assert_eq!(xs(text, Auto), [1.0, 5.0], "{text}");
    assert_eq!(xs(&format!("%\n{text}%\n"), Auto), [1.0, 5.0], "between two signs");
}

#[test]
fn a_move_comes_from_its_own_block_whoever_called() {
    let read = read_clean(
        "G0 X9\nG91\nN10 o1 call\nM2\no1 sub\nN50 G0 X1\no2 repeat [2]\nN60 X1\no2 endrepeat\n\
         o1 endsub\n",
    );
    let origin = |line, number| Origin::Block { line, number: Some(number), column: None };
    let seen: Vec<_> = moves(&read).iter().skip(1).map(|m| m.origin).collect();
    assert_eq!(seen, [origin(6, 50), origin(8, 60), origin(8, 60)], "lines and N");
}

#[test]
fn comments_stay_where_they_are_run() {
    let read = read_clean("o1 sub\n(DEBUG, one #1)\nG0 X1\no1 endsub\no1 call (MSG, now)\nM2\n");
    assert_eq!(words(&read), ["(MSG, now)", "(DEBUG, one #1)", "M2"], "as they come");
}

#[test]
fn every_unfinished_construct_is_reported_and_comes_to_an_end() {
    for text in [
        "o1 sub",
        "o1 endsub",
        "o1 call",
        "o1 return",
        "o1 do",
        "o1 while",
        "o1 while [",
        "o1 while [1]",
        "o1 endwhile",
        "o1 if",
        "o1 if [",
        "o1 if [1]",
        "o1 if []",
        "o1 elseif [1]",
        "o1 else",
        "o1 endif",
        "o1 repeat",
        "o1 repeat [",
        "o1 repeat [3]",
        "o1 endrepeat",
        "o1 break",
        "o1 continue",
        "o",
        "o<",
        "o<a",
        "o<a>",
        "o[",
        "o[1",
        "o[1]",
        "o#",
        "o#1 call",
        "o[1/0] call",
        "o1 if [1]\no1 else\no1 else\no1 endif",
        "o1 if [0]\no2 endif\no1 endif",
        "o1 if [0]\no1 elseif [0]",
        "o1 if [1]\no1 elseif [0]\nG0 X2",
        "o1 do\no2 while [0]",
        "o1 while [0]\no2 endwhile",
        "o1 sub\no2 sub\no2 endsub\no1 endsub\no1 call",
        "o1 sub\no1 if [1]\no1 endsub\no1 call",
        "o1 repeat [2]\no2 repeat [2]\no1 endrepeat\no2 endrepeat",
        "o1 call [1/0]\no1 sub\nG0 X#1\no1 endsub",
        "o1 call [1] 5\no1 sub\no1 endsub",
        "o1 if [#<a>]\no1 endif",
        "o1 break\no1 while [0]\no1 endwhile",
    ] {
        for around in ["", "%\n", "G0 X1\n"] {
            let found = codes(&format!("{around}{text}\n"), LinuxCnc);
            assert!(!found.is_empty(), "{text}");
        }
    }
}

#[test]
fn faults_of_conditions_count_as_false() {
    let found = codes("o1 while [1/0]\nG0 X1\no1 endwhile\n", LinuxCnc);
    assert_eq!(found, ["division-by-zero"], "the loop is not run");
    let text = "o1 if [#<a>]\nG0 X1\no1 else\nG0 X2\no1 endif\n";
    let read = interpret(&Program::parse(text, LinuxCnc), Rules::default());
    let seen: Vec<_> = moves(&read).iter().map(|m| m.curve.end().x).collect();
    assert_eq!(seen, [2.0], "the other branch");
}
