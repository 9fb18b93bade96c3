//! The order in which a block's words act, which is that of RS274/NGC.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::sample::{moves, read_clean, steps, words};

#[test]
fn words_act_in_the_order_of_execution() {
    let read = read_clean("M9 G61 M0 X5 G0 M3 M6 T2 S900 (a) G54 M48 M64 P1\n");
    let expected = ["S900 T2 M64 P1 M6 M3 M9 M48 G61 (a)", "G54", "R 5 0 0", "M0"];
    assert_eq!(steps(&read), expected, "stops come last");
}

#[test]
fn units_and_distance_modes_act_before_the_move_wherever_they_stand() {
    let ends = |text: &str| -> Vec<f64> {
        moves(&read_clean(text)).iter().map(|m| m.curve.end().x).collect()
    };
    assert_eq!(ends("G0 X1\nX1 G20 G91\n"), [1.0, 26.4], "inches, incremental");
    assert_eq!(ends("X2 G1 F60\nX3 G0\n"), [2.0, 3.0], "the motion word may come last");
}

#[test]
fn words_take_their_own_letters_with_them() {
    for (text, expected) in [
        ("M19 R90 Q1", "M19 R90 Q1"),
        ("M66 P0 L3 Q5", "M66 P0 L3 Q5"),
        ("M67 E2 Q100", "M67 E2 Q100"),
        ("M62 P1", "M62 P1"),
        ("M50 P0", "M50 P0"),
        ("M61 Q5", "M61 Q5"),
        ("M100 P1 Q2", "M100 P1 Q2"),
        ("G64 P0.01 Q0.02", "G64 P0.01 Q0.02"),
        ("G20 G64 P0.01", "G64 P0.254"),
        ("G61.1", "G61.1"),
        ("M60", "M60"),
        ("G50 S2000", "G50 S2000"),
        ("G92 S2000", "G92 S2000"),
        ("G0 A90", "G0 A90"),
        ("G1 B-5 C3 F60", "G1 B-5 C3 F60"),
    ] {
        assert_eq!(words(&read_clean(text)), [expected], "{text}");
    }
    assert_eq!(words(&read_clean("G0 A1\nG91 A90")), ["G0 A1", "G0 A91"], "incremental");
}
