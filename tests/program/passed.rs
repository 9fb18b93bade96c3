//! Moves that are passed on as words: of other axes, threads, probing, reference points.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::compensation::Options;
use g41::contour::ToolPath;
use g41::diagnostic::Severity;
use g41::program::{Dialect, EmitOptions, Program, Target, emit, interpret};
use g41::simulation::{Profile, Tools, compensate_program};

use super::sample::{codes, moves, read, read_as_fanuc, read_clean, words, xs};

fn path_of(text: &str, profile: Profile) -> ToolPath {
    let read = interpret(&Program::parse(text, Dialect::Auto), profile.rules());
    let options = if profile == Profile::LinuxCnc { profile.options() } else { Options::default() };
    compensate_program(&read, &Tools::all(3.0), &options)
}

/// The blocks written for a target behind its head, and the codes of what is found.
fn written(text: &str, target: Target) -> (Vec<String>, Vec<&'static str>) {
    let path = path_of(text, Profile::G41);
    let errors = path.diagnostics.iter().filter(|found| found.severity == Severity::Error);
    assert_eq!(errors.count(), 0, "{:?}", path.diagnostics);
    let written = emit(&path, &EmitOptions { target, ..EmitOptions::default() });
    let blocks = written.text.lines().skip(1).map(String::from).collect();
    (blocks, written.diagnostics.iter().map(|found| found.code).collect())
}

/// Where the moves of a path end [mm].
fn places(path: &ToolPath) -> Vec<[f64; 3]> {
    let end = |m: &g41::contour::Move| m.plane.place(m.curve.end(), m.heights[1]).to_array();
    path.moves.iter().map(end).collect()
}

#[test]
fn other_axes_move_with_their_block_or_alone() {
    let program = "G0 X0 Y0 A0\nG1 X20 A90 F300\nA180\nG91 A45 X5\nA45 F400\nG90\n\
                   G2 X25 Y10 J5 A0\nG20 G0 U1\nM2\n";
    let expected = [
        "G0 X0 Y0 A0",
        "G1 X20 A90 F300",
        "A180",
        "X25 A225",
        "A270 F400",
        "G2 Y10 A0 J5",
        "G0 U25.4",
        "M2",
    ];
    let (blocks, found) = written(program, Target::LinuxCnc);
    assert_eq!(
        (blocks.as_slice(), found.len()),
        (expected.map(String::from).as_slice(), 0),
        "all axes, in order"
    );
    let (blocks, found) = written(program, Target::Grbl);
    let flat = ["G0 X0 Y0", "G1 X20 F300", "X25", "G2 Y10 J5 F400", "M2"];
    assert_eq!(blocks, flat, "grbl has three axes");
    assert_eq!(found, ["left-out", "left-out", "left-out"], "A as 0, A and U, each once");
    let fanuc = written("G54 G0 X1 A90\nM2\n", Target::Fanuc0M).0;
    assert_eq!(fanuc[3], "N30 G0 X1. A90.", "with a point: {fanuc:?}");
}

#[test]
fn the_feed_of_what_turns_is_in_degrees() {
    assert_eq!(words(&read_clean("G20 G1 A90 F30\n")), ["G1 A90 F30"], "not in inches");
    assert_eq!(words(&read_clean("G20 G1 U1 F30\n")), ["G1 U25.4 F762"], "U is a length");
    let inverse = "G0 A0\nG93 G1 A90 F2\n";
    assert_eq!(words(&read_clean(inverse)), ["G0 A0", "G1 A90 F180"], "in half a minute");
}

#[test]
fn other_axes_turn_while_compensation_is_on() {
    let program = "G0 X-20 Y0 Z0\nG1 G41 D1 X0 F300\nY40 A10\nX30\nA20\nG40 Y60\nM2\n";
    let (blocks, found) = written(program, Target::LinuxCnc);
    assert!(found.is_empty(), "{found:?}");
    let expected = ["G0 X-20 Y0 Z0", "G1 X-3 F300", "Y43 A10", "X30", "A20", "Y60", "M2"];
    assert_eq!(blocks, expected, "each with its move");
}

#[test]
fn axes_that_g92_g28_and_g53_name_are_theirs() {
    let read = read_clean("G0 X0 Y0 Z0 A5\nG92 A0\nG28 A0\nG53 G0 B0 Z0\nM2\n");
    assert_eq!(
        words(&read),
        ["A5", "G0 X0 Y0 Z0", "G92 A0", "G28 A0", "G53 G0 Z0 B0", "M2"],
        "from where they are known"
    );
    let text = "G91 G0 A10\n";
    assert_eq!(codes(text, Dialect::Auto), ["unknown-start"], "from where is not known");
}

#[test]
fn threads_are_passed_on_with_their_lead() {
    let program = "G18\nS300 M3\nG0 X10 Z5\nG33 Z-20 K1.5\nG0 X12\nG33.1 Z-30 K1\nG0 Z5\n\
                   G76 P1.5 Z-20 I-1 J0.2 R1.5 K0.9 Q29.5 H2\nG0 X25\nM2\n";
    let expected = [
        "S300 M3",
        "G0 X10 Z5",
        "G33 Z-20 K1.5",
        "G0 X12",
        "G33.1 Z-30 K1",
        "G0 Z5",
        "G76 Z-20 P1.5 I-1 J0.2 K0.9 R1.5 Q29.5 H2",
        "G0 X25",
        "M2",
    ];
    let (blocks, found) = written(program, Target::LinuxCnc);
    assert_eq!(
        (blocks.as_slice(), found.len()),
        (expected.map(String::from).as_slice(), 0),
        "the thread as it is"
    );
    let path = path_of(program, Profile::G41);
    let feeds: Vec<Option<f64>> = path.moves.iter().map(|m| m.feed.map(|f| f * 60.0)).collect();
    let thread = [None, Some(450.0), None, Some(300.0), Some(300.0), None, None];
    assert_eq!(feeds, thread, "lead by speed; a tap goes back");
    assert_eq!(places(&path)[4], [12.0, 0.0, -20.0], "to where it began");
}

#[test]
fn fanucs_lead_is_its_f_word() {
    let program = "%\nO1\nG54 G0 X0 Y0 Z5\nG1 X1 F100\nS300 M3\nG33 Z-20 F2\nG1 Z5\nM30\n%\n";
    let (blocks, found) = written(program, Target::Fanuc0M);
    assert!(found.is_empty(), "{found:?}");
    let expected = ["N60 G33 Z-20. F2.", "N70 G1 Z5. F100"];
    assert_eq!(blocks[6..8], expected, "the feed is said again: {blocks:?}");
    let path = path_of(program, Profile::G41);
    assert_eq!(path.moves[2].feed, Some(10.0), "2 mm at 5 turns a second");
    assert_eq!(path.moves[3].feed, Some(100.0 / 60.0), "and the feed is that before");
    let other = written(program, Target::LinuxCnc).0;
    assert_eq!(other[5..7], ["G33 Z-20 K2", "G1 Z5 F100"], "{other:?}");
}

#[test]
fn a_program_ends_before_a_thread_or_a_probe_that_its_target_cannot_make() {
    let thread = "G0 X0 Y0 Z5\nG1 X5 F100\nG33 Z-20 K2\nG0 Z5\nG1 X9\nM5\nM2\n";
    for (target, text) in [
        (Target::Grbl, thread),
        (Target::Heidenhain, thread),
        (Target::Marlin, "G0 X0 Y0 Z5\nG1 X5 F100\nG38.2 Z-5 F50\nG0 Z5\nG1 X9\nM5\nM2\n"),
    ] {
        let path = path_of(text, Profile::G41);
        let written = emit(&path, &EmitOptions { target, ..EmitOptions::default() });
        let found: Vec<_> = written.diagnostics.iter().map(|d| (d.code, d.severity)).collect();
        assert_eq!(found[0], ("left-out", Severity::Error), "{target:?}: {written:?}");
        assert!(written.text.contains("M5") && !written.text.contains("X9"), "{}", written.text);
        assert!(!written.text.contains("+9") && !written.text.contains("-20"), "{}", written.text);
    }
}

#[test]
fn probing_ends_anywhere() {
    let program = "G0 X0 Y0 Z10\nG38.2 Z-10 F50\nG1 Z-10 F100\nG38.3 X30 F40\nG0 Z10\nM2\n";
    let expected =
        ["G0 X0 Y0 Z10", "G38.2 Z-10 F50", "G1 Z-10 F100", "G38.3 X30 F40", "G0 Z10", "M2"];
    for target in [Target::LinuxCnc, Target::Grbl, Target::GrblHal] {
        let (blocks, found) = written(program, target);
        assert!(found.is_empty(), "{found:?}");
        assert_eq!(blocks, expected, "Z is said again: it is not known");
    }
    let skip = read_as_fanuc("G0 X0 Z5\nG31 Z-5 F50\nX10\nM30\n");
    assert_eq!(words(&skip), ["G31 Z-5 F50", "M30"], "G31 holds for its block");
    assert!(moves(&skip)[2].rapid, "{skip:?}");
}

#[test]
fn neither_a_probe_nor_a_thread_is_compensated() {
    for word in ["G38.2", "G33", "G76 P1 I-1 J0.1 K0.5"] {
        let text = format!("G0 X-20 Y0\nG1 G41 D1 X0 F300\nY40\n{word} Z-5\nG1 X30\nG40 Y60\nM2\n");
        assert_eq!(codes(&text, Dialect::LinuxCnc), ["not-while-on"], "{text}");
        let refused = path_of(&text, Profile::LinuxCnc);
        assert!(refused.diagnostics.iter().any(|d| d.code == "refused"), "{refused:?}");
    }
}

#[test]
fn after_a_contour_without_a_lead_out_a_probe_starts_beside_it() {
    let text = "G0 X-20 Y0\nG1 G41 D1 X0 F300\nY40\nG40 G38.2 X-30\nM2\n";
    let path = path_of(text, Profile::G41);
    let last = path.moves.last().expect("it moves");
    assert_eq!(last.curve.start().to_array(), [-3.0, 40.0], "{last:?}");
}

#[test]
fn g60_is_a_rapid_move_of_its_block() {
    let text = "G1 X5 F100\nG60 X10\nX20\n";
    let found = read(text);
    assert_eq!(
        moves(&found).iter().map(|m| m.rapid).collect::<Vec<_>>(),
        [false, true, false],
        "the overrun is a move of its own"
    );
    assert_eq!(codes(text, Dialect::Fanuc), ["noted"], "the overrun is not made");
}

#[test]
fn polar_interpolation_is_left_out_as_a_whole() {
    let text = "G0 X40 Z5\nG12.1\nG42 D1 G1 X20 F100\nC10\nX-20\nG40 X40\nG13.1\nG0 X50 Z10\n";
    assert_eq!(codes(text, Dialect::Fanuc), ["not-supported"], "said once");
    assert_eq!(moves(&read_as_fanuc(text)).len(), 2, "nothing between");
}

#[test]
fn g66_calls_its_macro_after_each_block_that_moves() {
    let text = "%\nO1\nG66 P9100 A5 L2\nG0 X10\nM8\nX20\nG67\nX30\nM30\n\
                O9100\nG91 X#1\nG90\nM99\n%\n";
    assert_eq!(xs(text, Dialect::Auto), [10.0, 15.0, 20.0, 25.0, 30.0], "called after each move");
    let missing = "%\nO1\nG66 P77\nG0 X10\nX20\nG67\nM30\n%\n";
    assert_eq!(
        codes(missing, Dialect::Auto),
        ["missing-subprogram", "missing-subprogram"],
        "told at each call"
    );
}

#[test]
fn reference_points_are_reached_where_origins_are_known() {
    let text = "G54\nG10 L2 P1 X10 Y20 Z30\nG0 X0 Y0 Z5\nG28 Z10\nG53 G0 X0 Y0\nG91 G28 Z3\n\
                G90 G0 Z7\nG28\nM2\n";
    let path = path_of(text, Profile::LinuxCnc);
    let expected = [
        [0.0, 0.0, 5.0],
        [0.0, 0.0, 10.0],
        [0.0, 0.0, -30.0],
        [-10.0, -20.0, -30.0],
        [-10.0, -20.0, -27.0],
        [-10.0, -20.0, -30.0],
        [-10.0, -20.0, 7.0],
        [-10.0, -20.0, -30.0],
    ];
    assert_eq!(places(&path), expected, "by way of a point to the zero");
    assert!(path.moves.iter().all(|m| m.rapid), "all are traverses");
    let said: Vec<&str> = path.diagnostics.iter().map(|found| found.code).collect();
    assert_eq!(said, ["assumed-origins"], "once");
    // They are written as they are, and nothing beside them.
    let written = emit(&path, &EmitOptions { target: Target::LinuxCnc, ..EmitOptions::default() });
    let blocks: Vec<&str> = written.text.lines().skip(4).collect();
    let expected = ["G28 Z10", "G53 G0 X0 Y0", "G91 G28 Z3", "G90", "G0 Z7", "G28", "M2"];
    assert_eq!(blocks, expected, "{}", written.text);
    assert!(written.diagnostics.is_empty(), "{written:?}");
}

#[test]
fn reference_points_are_the_machines_zero_less_what_the_program_shifts() {
    for (length, height) in [("", 0.0), ("G43 H1", 0.0), ("G43.1 Z4", -4.0)] {
        let text = format!("G54\nG0 X0 Y0 Z5\n{length}\nG28 Z10\nM2\n");
        let path = path_of(&text, Profile::LinuxCnc);
        // A length from the table of tools counts as none, and the path says so.
        assert_eq!(places(&path).last(), Some(&[0.0, 0.0, height]), "{text}");
        let codes: Vec<_> = path.diagnostics.iter().map(|found| found.code).collect();
        assert!(codes.contains(&"assumed-origins"), "{text}: {codes:?}");
    }
    let text = "G54\nG0 X0 Y0 Z5\nG28 Z10\nM2\n";
    assert_eq!(path_of(text, Profile::G41).moves.len(), 1, "other controls assume nothing");
    let shifted = path_of("G0 X1 Y0 Z5\nG92 X11\nG28 X11\nM2\n", Profile::LinuxCnc);
    assert_eq!(places(&shifted).last(), Some(&[10.0, 0.0, 5.0]), "G92 has taken 10 off");
}

#[test]
fn dwells_of_fanuc_count_milliseconds_unless_they_have_a_point() {
    assert_eq!(words(&read_as_fanuc("G4 P1500\n")), ["G4 P1.5"], "a thousandth of a second");
    assert_eq!(words(&read_as_fanuc("G4 X1.5\n")), ["G4 P1.5"], "seconds");
    for text in ["G4 P1.5\n", "G4 P2.\n"] {
        let seconds = if text.contains('5') { "G4 P1.5" } else { "G4 P2" };
        assert_eq!(words(&read_as_fanuc(text)), [seconds], "{text}");
        assert_eq!(codes(text, Dialect::Fanuc), ["dwell-point"], "{text}");
    }
}

#[test]
fn the_end_of_a_length_that_was_left_out_is_left_out_each_time() {
    let ends = |text: &str| {
        written(text, Target::Grbl).0.iter().filter(|block| block.contains("G49")).count()
    };
    assert_eq!(ends("G0 Z9\nG43 H1 Z5\nG0 X1\nG49\nG0 X2\nG49 X3\nM2\n"), 0, "grbl has no H");
    assert_eq!(ends("G0 Z9\nG43.1 Z5\nG0 X1\nG49\nM2\n"), 1, "what it has it ends");
}
