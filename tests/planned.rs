//! Programs in time: words that concern motion, tools, coordinates that jump, and bounds.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::compensation::{GougePolicy, Options};
use g41::contour::ToolPath;
use g41::motion::{Limits, Motion};
use g41::program::{Dialect, EmitOptions, Program, Rules, emit, interpret};
use g41::simulation::{Tools, compensate_program, plan_path, tool_changes};

fn path_of(text: &str) -> ToolPath {
    let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
    compensate_program(&read, &Tools::all(1.0), &Options::default())
}

fn motion_of(text: &str, limits: &Limits) -> Motion {
    plan_path(&path_of(text), limits).expect("the limits are right").motion().clone()
}

fn time_of(text: &str) -> f64 {
    motion_of(text, &Limits::default()).duration
}

fn assert_near(value: f64, expected: f64, what: &str) {
    assert!((value - expected).abs() < 1e-9, "{what}: {value}, not {expected}");
}

#[test]
fn a_dwell_takes_its_time_wherever_it_stands() {
    let line = time_of("G0 X0 Y0\nG1 X30 F6000\n");
    assert_near(time_of("G0 X0 Y0\nG1 X30 F6000\nG4 P1.25\n"), line + 1.25, "at the end");
    let two = "G0 X0 Y0\nG1 X30 F6000\nG4 P0.5\nX60\n";
    assert_near(time_of(two), 2.0 * line + 0.5, "between two moves");
    assert_near(
        time_of("G4 P3\nG0 X0 Y0\nG1 X30 F6000\n"),
        line,
        "before all moves it has no place",
    );
    assert_near(time_of("G0 X0 Y0\nG1 X30 F6000\n(G4 P9)\n"), line, "a comment is none");
}

#[test]
fn corners_are_passed_as_the_words_say() {
    let corner = "X30\nY30\n";
    let with = |words: &str| time_of(&format!("G0 X0 Y0\n{words}\nG1 F6000\n{corner}"));
    let given = |limits| motion_of(&format!("G0 X0 Y0\nG1 F6000\n{corner}"), &limits).duration;
    let limits = Limits::default();
    let wide = given(Limits { corner_deviation: 0.4, ..limits });
    let exact = given(Limits { exact_stop: true, ..limits });
    assert_near(with("G61.1"), exact, "G61.1");
    assert_near(with("G61"), exact, "G61 at a corner that is sharp");
    assert_near(with("G64 P0.4"), wide, "G64 P");
    assert_near(
        with("G20 G64 P0.4\nG21"),
        given(Limits { corner_deviation: 10.16, ..limits }),
        "in",
    );
    assert_near(with("G64"), given(limits), "G64");
    assert_near(with("G61.1\nG64"), given(limits), "G64 after G61.1");
    let inside = |words: &str| {
        time_of(&format!("G0 X0 Y0\nG1 X10 F6000\nX20 Y1\n{words}\nX30 Y0\nX40 Y1\nX50 Y0\n"))
    };
    assert!(inside("G61.1") > inside("G64"), "between lines that are fitted together");
    assert!(wide <= exact, "rounding is no slower: {wide} {exact}");
}

#[test]
fn where_coordinates_are_given_other_numbers_no_time_passes() {
    let line = time_of("G0 X0 Y0\nG1 X30 F6000\n");
    let moved = "G0 X0 Y0\nG1 X30 F6000\nG92 X0\nX30\n";
    assert_near(time_of(moved), 2.0 * line, "two lines, from rest to rest");
}

#[test]
fn moves_that_words_make_take_their_time() {
    let down = time_of("G0 X0 Y0 Z30\nG1 Z0 F6000\nG0 Z30\n");
    assert_near(time_of("G0 X0 Y0 Z30\nG38.2 Z0 F6000\nG0 Z30\n"), down, "a probe as a line");
    let text = "G21 G90\nG0 X0 Y0 Z10\nG38.2 Z0 F100\nG0 Z2\nX20\n";
    let (path, limits) = (path_of(text), Limits::default());
    let motion = plan_path(&path, &limits).expect("the limits are right");
    let found = motion.violations(&path, &limits);
    assert!(found.velocity.ratio() <= 1.0, "nothing jumps: {:?}", found.velocity);
}

#[test]
fn between_pieces_the_tool_goes_as_programs_are_written() {
    // A room, a corridor that the tool is too wide for, and another room.
    let text = "G21 G90\nG0 X10 Y10 Z5\nG1 Z-2 F120\nG41 Y0 F400\nX30\nY12\nX40\nY0\nX70\nY30\n\
                X40\nY18\nX30\nY30\nX0\nY0\nX10\nG40 Y10\nG0 Z5\n";
    let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
    let avoiding = Options { gouge: GougePolicy::Avoid, ..Options::default() };
    let path = compensate_program(&read, &Tools::all(5.0), &avoiding);
    let written = emit(&path, &EmitOptions::default()).text;
    assert!(written.contains("G0 Z5\nX"), "there are two pieces:\n{written}");
    let again = path_of(&written);
    let limits = Limits { velocity: 200.0, acceleration: 2000.0, ..Limits::default() };
    let planned = plan_path(&path, &limits).expect("the limits are right");
    let rewritten = plan_path(&again, &limits).expect("the limits are right").motion().duration;
    let took = planned.motion().duration;
    assert!((took - rewritten).abs() < 1e-3 * took, "as written: {took} s, {rewritten} s");
    let found = planned.violations(&path, &limits);
    assert!(found.worst() < 1.0005, "on the way too: {found:?}");
    let blocks = planned.blocks();
    let most = path.moves.len() - 1;
    assert_eq!(blocks.last().map(|block| *block as usize), Some(most), "the last move");
    assert!(blocks.is_sorted(), "each way counts to the move that follows");
}

#[test]
fn tools_are_in_the_spindle_from_m6_on_where_there_is_one() {
    let with = |text: &str| tool_changes(&path_of(text));
    assert_eq!(with("G0 X0\nT2 M6\nX5\nT3\nX6\nM6\nX7\n"), [(0, 2.0), (2, 3.0)], "M6");
    assert_eq!(with("T1\nG0 X5\nT0202\nX6\n"), [(0, 1.0), (1, 202.0)], "T alone");
    assert_eq!(with("G0 X5\n(T4)\n"), [], "a comment");
}

#[test]
fn a_motion_of_too_many_samples_is_refused() {
    let limits = Limits { period: 1e-5, ..Limits::default() };
    for text in ["G0 X0\nG1 X1000 F1\n", "G0 X0\nG1 X1 F100\nG4 P100000\n"] {
        let refused = plan_path(&path_of(text), &limits).expect_err(text);
        assert_eq!(refused.name, "period", "{text}");
    }
}

#[test]
fn programs_in_time_keep_to_their_limits() {
    // Feeds that differ at corners, long even stretches, rapids and arcs beside each other.
    for (name, text) in [
        ("two_tools", include_str!("programs/two_tools.ngc")),
        ("coolant", include_str!("programs/coolant.ngc")),
        ("keyhole", include_str!("programs/keyhole.ngc")),
        ("inch_letter", include_str!("programs/inch_letter.ngc")),
    ] {
        let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
        let path = compensate_program(&read, &Tools::all(2.0), &Options::default());
        let limits = Limits::default();
        let motion = plan_path(&path, &limits).expect("the limits are right");
        let found = motion.violations(&path, &limits);
        for (what, peak) in [
            ("velocity", found.velocity),
            ("acceleration", found.acceleration),
            ("jerk", found.jerk),
            ("change of jerk", found.jerk_change),
            ("chord error", found.chord_error),
        ] {
            assert!(peak.value <= peak.limit, "{name}: {what} {peak:?}");
        }
        // A corner is as far from the samples as from the path, and what the chord between two of
        // them adds; it is told to what its own search makes of it.
        let most = 1.0005 * limits.corner_deviation + found.chord_error.value;
        assert!(found.deviation.value <= most, "{name}: {found:?}");
        assert!(found.end < 1e-9, "{name}: {found:?}");
    }
}
