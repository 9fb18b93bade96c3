//! The values of expressions, by hand and from `LinuxCNC`'s and FANUC's documentation.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::program::Dialect::{self, Auto, Fanuc, LinuxCnc, Sinumerik};
use g41::program::{Program, Rules, interpret};

use super::sample::{codes, ends, read, xs};

/// The number that an expression has as that of an X word.
fn value(expression: &str, dialect: Dialect) -> f64 {
    // A move of no length would be left out.
    ends(&format!("G0 X-123456. Y0\nX{expression}\n"), dialect)[1][0]
}

#[test]
fn expressions_have_their_value() {
    for (expression, expected) in [
        // Documented: the operators of one group from left to right.
        ("[2.0 / 3 * 1.5 - 5.5 / 11.0]", 0.5),
        ("[1 + acos[0] - [4 ** [4.0/2]]]", 75.0),
        ("fix[2.8]", 2.0),
        ("fix[-2.8]", -3.0),
        ("fup[2.8]", 3.0),
        ("fup[-2.8]", -2.0),
        ("round[2.5]", 3.0),
        ("round[-2.5]", -3.0),
        // By hand.
        ("[1+2*3]", 7.0),
        ("[[1+2]*3]", 9.0),
        ("[2*3**2]", 18.0),
        ("[2**3**2]", 64.0),
        ("[-2**2]", 4.0),
        ("[2**-1]", 0.5),
        ("[2**0.5]", std::f64::consts::SQRT_2),
        ("[-8**3]", -512.0),
        ("[7 mod 3]", 1.0),
        ("[-7 mod 3]", 2.0),
        ("[7 mod -3]", 1.0),
        ("[5.5 mod 2]", 1.5),
        ("[1 EQ 1.00009]", 1.0),
        ("[1 NE 1.00011]", 1.0),
        ("[1 LT 1.00001]", 1.0),
        ("[2 LE 1.9999999]", 0.0),
        ("[2 GE 2.0000001]", 0.0),
        ("[1 OR 5 MOD 0]", 1.0),
        ("[2 GE 3]", 0.0),
        ("[3 GT 2 AND 1 LT 0]", 0.0),
        ("[3 GT 2 OR 1 LT 0]", 1.0),
        ("[3 XOR 5]", 0.0),
        ("[0 XOR 5]", 1.0),
        ("[1 + 2 EQ 3]", 1.0),
        ("abs[-3]", 3.0),
        ("-abs[-3]", -3.0),
        ("sin[30]", 0.5),
        ("cos[60]", 0.5),
        ("cos[90]", 0.0),
        ("sin[-270]", 1.0),
        ("tan[45]", 1.0),
        ("asin[0.5]", 30.0),
        ("acos[-1]", 180.0),
        ("atan[1]/[1]", 45.0),
        ("atan[-1]/[-1]", -135.0),
        ("atan[0]/[-1]", 180.0),
        ("exp[1]", std::f64::consts::E),
        ("ln[exp[2]]", 2.0),
        ("sqrt[2]", std::f64::consts::SQRT_2),
        ("[ 1 2 + 3 . 5 ]", 15.5),
        ("[ S Q R T [ 9 ] ]", 3.0),
        ("+[3]", 3.0),
        ("--[3]", 3.0),
        ("[3 - -3]", 6.0),
        ("exists[#<nothing>]", 0.0),
        ("exists[#<_metric>]", 1.0),
    ] {
        let seen = value(expression, LinuxCnc);
        assert!((seen - expected).abs() < 1e-12, "{expression} is {expected}, not {seen}");
    }
}

#[test]
fn fanuc_rounds_and_combines_in_its_own_way() {
    for (expression, expected) in [
        // Documented: by the absolute value.
        ("FIX[1.2]", 1.0),
        ("FIX[-1.2]", -1.0),
        ("FUP[1.2]", 2.0),
        ("FUP[-1.2]", -2.0),
        ("ROUND[-1.5]", -2.0),
        ("ATAN[1]/[-1]", 135.0),
        ("ATAN[-1]/[-1]", 225.0),
        ("ATAN[-1,1]", 315.0),
        ("ATAN[1]", 45.0),
        ("ASIN[-0.5]", 330.0),
        ("[6 AND 3]", 2.0),
        ("[6 OR 3]", 7.0),
        ("[6 XOR 3]", 5.0),
        // AND like *, OR like +.
        ("[1 + 6 AND 3]", 3.0),
        ("[8 - 6 OR 1]", 3.0),
        ("[-7 MOD 3]", -1.0),
        ("[7.4 MOD 2.6]", 1.0),
        ("POW[2,10]", 1024.0),
        ("BIN[18]", 12.0),
        ("BCD[12]", 18.0),
        ("[#5 + 2]", 2.0),
        ("[#5 EQ #0]", 1.0),
        ("[#5 EQ 0]", 0.0),
        ("[#5 NE 0]", 1.0),
        ("[#5 GE 0]", 1.0),
        ("[#5 LT 0]", 0.0),
    ] {
        let seen = value(expression, Fanuc);
        assert!((seen - expected).abs() < 1e-12, "{expression} is {expected}, not {seen}");
    }
}

#[test]
fn a_vacant_variable_makes_a_word_as_good_as_absent() {
    assert_eq!(ends("G0 X1 Y2\nX#1 Y5\n", Fanuc), [[1.0, 2.0], [1.0, 5.0]], "documented");
    assert_eq!(xs("#1=#0\n#2=#1+3\nG0 X#2 Y1\n", Fanuc), [3.0], "in a sum it is a zero");
}

#[test]
fn parameters_are_set_after_their_whole_block_was_read() {
    // Documented: X is 15, and #3 is 6 afterwards.
    assert_eq!(xs("#3=15\n#3=6 G0 X#3\nX#3\n", LinuxCnc), [15.0, 6.0], "#3=6 G1 X#3");
    assert_eq!(xs("#3=15 #3=6\nG0 X#3\n", LinuxCnc), [6.0], "the last setting counts");
    assert_eq!(xs("#2=7\n#7=9\nG0 X##2\nX#[1+6-5]\n", LinuxCnc), [9.0, 7.0], "indirection");
    assert_eq!(xs("#1=5\n#2=[#1+2]\nG0 X[#1+2]\nX-#1\n", LinuxCnc), [7.0, -5.0], "# binds first");
    assert_eq!(xs("#<P a R am>=3\nG0 X#<param>\n", LinuxCnc), [3.0], "names, documented");
    assert_eq!(xs("g 0 x +0. 12 34y 7\n", LinuxCnc), [0.1234], "spaces, documented");
    assert_eq!(xs("#100=2\n#101=#100*3+1\nG#0 X#101 G0\n", Fanuc), [7.0], "without brackets");
}

#[test]
fn the_position_and_the_modes_can_be_asked_for() {
    assert_eq!(xs("G0 X5 Y6\nX[#5421*2]\nX[#<_x>+1]\n", LinuxCnc), [5.0, 12.0, 13.0], "position");
    assert_eq!(xs("G20 G0 X1\nX[#5420+1]\n", LinuxCnc), [25.4, 50.8], "in inches");
    assert_eq!(xs("G91\nG0 G90 X[#<_incremental>]\n", LinuxCnc), [1.0], "as the block begins");
    assert_eq!(xs("T3 M6\nG0 X#5400\nX[#<_metric>+1]\n", LinuxCnc), [3.0, 2.0], "tool and unit");
    assert_eq!(xs("G0 X5 Y6\nX[#5002*2]\nX#4003\n", Fanuc), [5.0, 12.0, 90.0], "FANUC's");
}

#[test]
fn sinumerik_assigns_to_addresses() {
    assert_eq!(xs("R1=5 R2=3\nG0 X=R1*(R2+1) Y0\nX=R1\n", Sinumerik), [20.0, 5.0], "R parameters");
    assert_eq!(xs("N10 G0 X=SIN(30)*10 Y=POT(3)\n", Sinumerik), [5.0], "functions");
    let read = read("R1=5\nG0 X0 Y0\nG2 X=R1+R1 Y0 CR=5 F100\n");
    assert!(read.diagnostics.is_empty(), "{read:?}");
}

#[test]
fn what_has_no_value_is_reported_and_moves_nothing() {
    for (expression, code) in [
        ("[1/0]", "division-by-zero"),
        ("[1 MOD 0]", "no-number"),
        ("[0**-1]", "no-number"),
        ("[-2**0.5]", "no-number"),
        ("LN[0]", "no-number"),
        ("LN[-1]", "no-number"),
        ("SQRT[-1]", "no-number"),
        ("ASIN[1.1]", "no-number"),
        ("ACOS[-2]", "no-number"),
        ("TAN[90]", "no-number"),
        ("EXP[1000]", "no-number"),
        ("[999999999**999]", "no-number"),
        ("[999999999*999999999]", "number-too-large"),
        ("[1000000001]", "number-too-large"),
        ("FOO[1]", "unknown-name"),
        ("ATAN[1]", "bad-expression"),
        ("SIN[1,2]", "bad-expression"),
        ("EXISTS[5]", "bad-expression"),
        ("EXISTS[5]", "bad-expression"),
        ("[", "bad-expression"),
        ("[]", "bad-expression"),
        ("[1", "bad-expression"),
        ("[1+", "bad-expression"),
        ("[1+]", "bad-expression"),
        ("[1 1 X]", "bad-expression"),
        ("[(]", "bad-expression"),
        ("SIN[", "bad-expression"),
        ("#", "bad-parameter"),
        ("#[", "bad-expression"),
        ("#<", "bad-parameter"),
        ("#<a", "bad-parameter"),
        ("##", "bad-parameter"),
        ("#[0.5]", "bad-parameter"),
        ("#[-1]", "bad-parameter"),
        ("#10000", "bad-parameter"),
        ("#99999999999999999999", "number-too-large"),
        ("#<_abs_x>", "unknown-parameter"),
        ("#5410", "unknown-parameter"),
        ("#5420", "unknown-parameter"),
    ] {
        let text = format!("G0 Y1\nX{expression}\n");
        let found = codes(&text, LinuxCnc);
        assert_eq!(found.first(), Some(&code), "{expression}: {found:?}");
        let read = interpret(&Program::parse(&text, LinuxCnc), Rules::default());
        let moved = super::sample::moves(&read).iter().any(|m| m.curve.end().x != 0.0);
        assert!(!moved, "{expression}: {read:?}");
    }
    let deep = format!("G0 X{}1{}\n", "[".repeat(500), "]".repeat(500));
    assert_eq!(codes(&deep, Auto), ["bad-expression"], "deep brackets");
    let deep = format!("G0 X[{}1]\n", "-".repeat(500));
    assert_eq!(codes(&deep, Auto), ["bad-expression"], "signs");
}

#[test]
fn whoever_uses_a_parameter_whose_assignment_failed_is_told() {
    let found = codes("G0 X1\n#1=[1/0]\nX#1\n#1=3\nX#1\n", LinuxCnc);
    assert_eq!(found, ["division-by-zero", "unset-parameter"], "until it is set again");
}

#[test]
fn the_other_words_of_a_block_with_a_fault_count() {
    let read = read("G0 X1 Y1\nX[1/0] Y5\nX ATAN[0]/[0+LN[0]] Y7 (C)\n");
    let last: Vec<_> = super::sample::moves(&read).iter().map(|m| m.curve.end().y).collect();
    assert_eq!(last, [1.0, 5.0, 7.0], "{read:?}");
}
