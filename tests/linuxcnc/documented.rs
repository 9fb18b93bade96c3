//! The coordinates that `LinuxCNC`'s own tests and the RS274/NGC handbook print.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::run::assert_moves;

const INCH: f64 = 25.4;

/// The part of the handbook's figures on entry moves: a rounded outline, reached by a straight move
/// and an arc.
#[test]
fn outline_reached_by_a_line_and_an_arc() {
    assert_moves(
        "G20 F60
        T4 M6
        G0 X1 Y5
        G41 G1 Y4
        G3 X2 Y3 I1 J0
        G2 X3 Y2 I0 J-1
        G1 Y-1
        G2 X2 Y-2 I-1 J0
        G1 X-2
        G2 X-2.6 Y-0.2 I0 J1
        G1 X1.4 Y2.8
        G2 X2 Y3 I0.6 J-0.8
        G40
        M2",
        &[(4, 1.0, 0)],
        INCH,
        "G0 1 5 0
        G1 1.5 4 0
        G3 2 3.5 0 2 4
        G2 3.5 2 0 2 2
        G1 3.5 -1 0
        G2 2 -2.5 0 2 -1
        G1 -2 -2.5 0
        G2 -2.9 0.2 0 -2 -1
        G1 1.1 3.2 0
        G2 2 3.5 0 2 2",
    );
}

/// Heights change in the lead-in, on the part and in the lead-out, which are an arc or a line.
#[test]
fn heights_change_on_the_way() {
    for (lead, part, exit) in [("Z0", "", ""), ("", "Z0", ""), ("", "", "Z0")] {
        let text = format!(
            "G20 F60
            G0 X0 Y0.5 Z0.25
            G1 X0.25
            G41 G2 D2 X0.5 Y0.75 I0.25 J0 {lead}
            G1 X0.75 {part}
            G40 X1 {exit}
            X1.25 Z0.25
            M2"
        );
        let (a, b) =
            (if lead.is_empty() { 0.25 } else { 0.0 }, if exit.is_empty() { 0.0 } else { 0.25 });
        assert_moves(
            &text,
            &[(2, 0.125, 0)],
            INCH,
            &format!(
                "G0 0 0.5 0.25
                G1 0.25 0.5 0.25
                G2 0.5 0.8125 {a} 0.5 0.5562
                G1 0.75 0.8125 {b}
                G1 1 0.75 0
                G1 1.25 0.75 0.25"
            ),
        );
        let text = format!(
            "G20 F60
            G0 X0 Y-0.5 Z0.25
            G1 X0.25
            G41 G1 D2 X0.5 Y-0.25 {lead}
            G1 X0.75 {part}
            G40 X1 {exit}
            X1.25 Z0.25
            M2"
        );
        assert_moves(
            &text,
            &[(2, 0.125, 0)],
            INCH,
            &format!(
                "G0 0 -0.5 0.25
                G1 0.25 -0.5 0.25
                G1 0.4558 -0.2058 {a}
                G2 0.5 -0.1875 {a} 0.5 -0.25
                G1 0.75 -0.1875 {b}
                G1 1 -0.25 0
                G1 1.25 -0.25 0.25"
            ),
        );
    }
}

/// D0 is the tool in the spindle, of which there is none: nothing is compensated.
#[test]
fn without_a_tool_in_the_spindle_nothing_is_compensated() {
    assert_moves(
        "G20 F60
        G0 X0 Y0.5 Z0.25
        G1 X0.25
        G41 G2 D0 X0.5 Y0.75 I0.25 J0
        G1 X0.75
        G40 X1
        X1.25 Z0.5
        M2",
        &[],
        INCH,
        "G0 0 0.5 0.25
        G1 0.25 0.5 0.25
        G2 0.5 0.75 0.25 0.5 0.5
        G1 0.75 0.75 0.25
        G1 1 0.75 0.25
        G1 1.25 0.75 0.5",
    );
}

/// A lathe in G18: the same profile without a tool, with one that points down and towards the
/// chuck (2), and back along it with one that points towards the chuck (7).
#[test]
fn lathe_profile_both_ways() {
    assert_moves(
        "G20 G64 G18 F30
        T0 M6
        G0 X0.3 Z0
        G40
        G1 X0.1
        G3 X0 Z0.1 R0.1
        G1 Z1
        G2 R0.25 X-0.25 Z1.25
        G3 R0.25 X-0.5 Z1.5
        G1 Z1.75
        G0 X0.3
        T2 M6
        G0 Z0
        G41
        G1 X0.1
        G3 X0 Z0.1 R0.1
        G1 Z1
        G2 R0.25 X-0.25 Z1.25
        G3 R0.25 X-0.5 Z1.5
        G1 Z1.75
        G40
        G0 X0.3
        T7 M6
        G0 Z1.85
        G0 X-0.3
        G42
        G1 X-0.4
        G2 X-0.5 Z1.75 R0.1
        G1 Z1.5
        G2 R0.25 X-0.25 Z1.25
        G3 R0.25 X0 Z1
        G1 Z0.1
        G2 R0.1 X0.1 Z0
        G40
        G0 X0.3
        M2",
        &[(2, 0.1, 2), (7, 0.1, 7)],
        INCH,
        "G0 0.3 0 0
        G1 0.1 0 0
        G3 0 0 0.1 0.1 0.1
        G1 0 0 1
        G2 -0.25 0 1.25 1 -0.25
        G3 -0.5 0 1.5 1.5 -0.25
        G1 -0.5 0 1.75
        G0 0.3 0 1.75
        G0 0.3 0 0
        G1 0.05 0 0
        G3 0 0 0.05 0.05 0.05
        G1 0 0 0.95
        G2 -0.3 0 1.25 0.95 -0.3
        G3 -0.5 0 1.45 1.45 -0.3
        G1 -0.5 0 1.7
        G0 0.3 0 1.75
        G0 0.3 0 1.85
        G0 -0.3 0 1.85
        G1 -0.4 0 1.75
        G2 -0.45 0 1.7 1.7 -0.4
        G1 -0.45 0 1.45
        G2 -0.25 0 1.25 1.45 -0.25
        G3 0.05 0 0.95 0.95 -0.25
        G1 0.05 0 0.05
        G2 0.1 0 0 0.05 0.1
        G0 0.3 0 0",
    );
}

/// Absolute and incremental words, G92, R form, helices, a lead-in arc, outside corners of every kind,
/// and a rapid move up at the end that stays beside the part.
#[test]
fn every_outside_corner_after_an_arc_in_r_form() {
    assert_moves(
        "G20 T3 M6 F100
        G0 X1 Y0 Z1
        G92 Z0.5
        X2 Y0
        G41
        G3 X1 Y0 R0.70710678118 Z0
        G91 G2 X-1 Y1 R1
        G90 G3 X1 Y2 Z0.4 R2
        G91 G1 X1 Y-1 Z-0.2
        G90 X1 Y0 Z0
        G0 Z1
        G40
        G92.1
        M2",
        &[(3, 0.25, 0)],
        INCH,
        "G0 1 0 1
        G0 2 0 0.5
        G3 1.0884 -0.0884 0 1.5979 -0.5979
        G2 1 -0.125 0 1 0
        G2 -0.125 1 0 1 1
        G2 -0.0514 1.1139 0 0 1
        G3 0.8861 2.0514 0.4 -0.8229 2.8229
        G2 1.0884 2.0884 0.4 1 2
        G1 2.0884 1.0884 0.2
        G2 2.0884 0.9116 0.2 2 1
        G1 1.0884 -0.0884 0
        G0 1.0884 -0.0884 1",
    );
}

/// The user's manual draws an outside profile: corners, a rounding and a chamfer, gone round by a tool
/// of diameter 1 on either side.
#[test]
fn outside_profile_on_both_sides() {
    assert_moves(
        "G21 F60
        G40
        G0 X0 Y-2
        G41 D1 G1 X0 Y0
        Y3
        X3
        G2 X4 Y2 I0 J-1
        G1 Y0
        X1
        X0 Y1
        G40 X-2 Y1
        M2",
        &[(1, 1.0, 0)],
        1.0,
        "G0 0 -2 0
        G1 -0.5 0 0
        G1 -0.5 3 0
        G2 0 3.5 0 0 3
        G1 3 3.5 0
        G2 4.5 2 0 3 2
        G1 4.5 0 0
        G2 4 -0.5 0 4 0
        G1 1 -0.5 0
        G2 0.6464 -0.3536 0 1 0
        G1 -0.3536 0.6464 0
        G1 -2 1 0",
    );
    // Mirrored in y = x, and so on the other side.
    assert_moves(
        "G21 F60
        G40
        G0 X-2 Y0
        G42 D1 G1 X0 Y0
        X3
        Y3
        G3 X2 Y4 I-1 J0
        G1 X0
        Y1
        X1 Y0
        G40 X1 Y-2
        M2",
        &[(1, 1.0, 0)],
        1.0,
        "G0 -2 0 0
        G1 0 -0.5 0
        G1 3 -0.5 0
        G3 3.5 0 0 3 0
        G1 3.5 3 0
        G3 2 4.5 0 2 3
        G1 0 4.5 0
        G3 -0.5 4 0 0 4
        G1 -0.5 1 0
        G3 -0.3536 0.6464 0 0 1
        G1 0.6464 -0.3536 0
        G1 1 -2 0",
    );
}

/// And an inside profile, entered and left along arcs.
#[test]
fn inside_profile_entered_along_an_arc() {
    assert_moves(
        "G21 F60
        G40
        G0 X2 Y2 Z1
        G41 D1 G1 X2 Y1
        G3 X3 Y0 I1 J0 Z0
        G1 X6
        Y4
        X0
        Y0
        X3
        G3 X4 Y1 I0 J1
        G40 G1 X4 Y2
        M2",
        &[(1, 1.0, 0)],
        1.0,
        "G0 2 2 1
        G1 2.5 1 1
        G3 3 0.5 0 3 1
        G1 5.5 0.5 0
        G1 5.5 3.5 0
        G1 0.5 3.5 0
        G1 0.5 0.5 0
        G1 3 0.5 0
        G3 3.5 1 0 3 1
        G1 4 2 0",
    );
}

/// The manual's arcs by their centres and by a radius, a helix and one of two turns, without a tool.
#[test]
fn arcs_of_every_form() {
    assert_moves(
        "G21 F60
        G0 X0 Y0 Z0
        G2 X1 Y1 I1 J0
        G0 X0 Y0
        G2 X0 Y1 I1 J0.5
        G3 X0 Y0 I1 J-0.5
        G2 X0 Y1 Z-1 I1 J0.5 P2
        G0 X0 Y0 Z0
        G17 G2 X10 Y15 R20 Z5
        M2",
        &[],
        1.0,
        "G2 1 1 0 1 0
        G0 0 0 0
        G2 0 1 0 1 0.5
        G3 0 0 0 1 0.5
        G2 0 0 -0.8714 1 0.5
        G2 0 1 -1 1 0.5
        G0 0 0 0
        G2 10 15 5 19.8551 -2.4034",
    );
}

/// Circles that a loop makes of one block are no arc of several turns: each ends beside its own end.
#[test]
fn circles_of_a_loop_are_circles_of_their_own() {
    assert_moves(
        "G21 G18 G90 F100
        G0 X0 Y0 Z0
        G42.1 D12 G1 X0 Z30
        o1 repeat [3]
        G91
        G2 K-30 Y-1
        G90
        o1 endrepeat
        G40 G1 X0 Z0
        M2",
        &[],
        1.0,
        "G1 -6 0 23.2379
        G2 0 -1 24 0 0
        G2 0 -2 24 0 0
        G2 0 -3 24 0 0
        G1 0 -3 0",
    );
}
