//! Programs written for each target: its own words, numbers and comments, and what it does not know.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::compensation::{CornerStyle, GougePolicy, Options};
use g41::contour::ToolPath;
use g41::diagnostic::Severity;
use g41::program::{
    Dialect, EmitOptions, Emitted, Interpretation, Program, Rules, SplineOutput, Target, emit,
    interpret, programmed_path,
};
use g41::simulation::{Tools, compensate_program};

fn read(text: &str) -> Interpretation {
    interpret(&Program::parse(text, Dialect::Auto), Rules::default())
}

fn path_of(text: &str, radius: f64) -> ToolPath {
    compensate_program(&read(text), &Tools::all(radius), &Options::default())
}

fn write(text: &str, target: Target) -> Emitted {
    emit(&path_of(text, 0.0), &EmitOptions { target, ..EmitOptions::default() })
}

fn lines(text: &str) -> Vec<&str> {
    text.lines().collect()
}

/// A program with words of every kind.
const WORDS: &str = "(O12)\nG21 G90 G17\nT2 M6 (drill)\nG43 H2\nS1500 M3\nM8\nG0 X5 Y5 Z2.5\n\
                     G1 Z-1 F60.5\nG4 P0.25\nG61\nX10\nG54\nM9\nM30\n";

#[test]
fn linuxcnc_gets_all_words_as_they_are() {
    let written = write(WORDS, Target::LinuxCnc);
    assert!(written.diagnostics.is_empty(), "{written:?}");
    let expected = [
        "G21 G90 G91.1 G17 G40 G94",
        "(O12)",
        "T2 M6 (drill)",
        "G43 H2",
        "S1500 M3",
        "M8",
        "G0 X5 Y5 Z2.5",
        "G1 Z-1 F60.5",
        "G4 P0.25",
        "G61",
        "X10",
        "G54",
        "M9",
        "M30",
    ];
    assert_eq!(lines(&written.text), expected, "{}", written.text);
}

#[test]
fn what_no_word_ends_stands_between_percent_signs_for_linuxcnc() {
    // Its interpreter 2.9: «File ended with no percent sign or program end».
    let text = "%\nG21 G90\nG0 X1 Y2\nG1 X5 F100\n%\n";
    let written = write(text, Target::LinuxCnc).text;
    let expected = ["%", "G21 G90 G91.1 G17 G40 G94", "G0 X1 Y2", "G1 X5 F100", "%"];
    assert_eq!(lines(&written), expected, "{written}");
    assert_eq!(write(&written, Target::LinuxCnc).text, written, "and so it stays");
    for end in ["M2", "M30"] {
        let written = write(&format!("G0 X1 Y2\n{end}\n"), Target::LinuxCnc).text;
        assert!(!written.contains('%'), "{end} ends it: {written}");
    }
    assert!(!write(text, Target::Grbl).text.contains('%'), "grbl needs none");
}

#[test]
fn grbl_waits_for_the_tool_and_is_told_what_it_misses() {
    let written = write(WORDS, Target::Grbl);
    let text = &written.text;
    let found: Vec<_> = written.diagnostics.iter().map(|d| (d.code, d.severity)).collect();
    let expected = [("tool-change", Severity::Info), ("left-out", Severity::Warning)];
    assert_eq!(found, expected, "M6 and G43: {written:?}");
    assert!(text.contains("T2\n(drill)\n(change to tool 2)\nM0\nS1500 M3\n"), "{text}");
    assert!(!text.contains("G43") && !text.contains("M6"), "{text}");
}

#[test]
fn fanuc_gets_points_numbers_and_capitals() {
    let written = write(WORDS, Target::Fanuc0M);
    let expected = [
        "%",
        "O0012",
        "N10 G21 G17 G40 G49 G80 G90",
        "N20 T2 M6 (DRILL)",
        "N30 G43 H2",
        "N40 S1500 M3",
        "N50 M8",
        "N60 G0 X5. Y5. Z2.5",
        "N70 G1 Z-1. F61",
        "N80 G4 X0.25",
        "N90 G61",
        "N100 X10.",
        "N110 G54",
        "N120 M9",
        "N130 M30",
        "%",
    ];
    assert_eq!(lines(&written.text), expected, "{}", written.text);
    assert!(written.diagnostics.is_empty(), "{written:?}");
}

#[test]
fn marlin_gets_one_command_in_a_line_and_every_motion_word() {
    let written = write(WORDS, Target::Marlin);
    let expected = [
        "G21",
        "G90",
        ";O12",
        ";drill",
        ";change to tool 2",
        "M0",
        "M3 S1500",
        "M8",
        "G0 X5 Y5 Z2.5",
        "G1 Z-1 F60.5",
        "G4 S0.25",
        "G1 X10",
        "M9",
    ];
    assert_eq!(lines(&written.text), expected, "{}", written.text);
    let left_out: Vec<&str> = written
        .diagnostics
        .iter()
        .filter(|found| found.code == "left-out")
        .filter_map(|found| found.message.split(' ').next())
        .collect();
    assert_eq!(left_out, ["T2", "G43", "G61", "G54"], "{written:?}");
}

#[test]
fn smoothieware_counts_dwells_in_seconds_and_waits_in_its_own_way() {
    let text = write(WORDS, Target::Smoothieware).text;
    assert!(text.contains("\nM600\n") && text.contains("\nG4 S0.25\n"), "{text}");
}

#[test]
fn a_program_without_a_frame_gets_that_of_the_control() {
    for (target, frame) in [(Target::Fanuc0M, "N20 G54"), (Target::Fanuc6M, "N20 G92 X0. Y0. Z0.")]
    {
        let written = write("G0 X1 Y1\nG1 X5 F100\nM2\n", target);
        assert_eq!(lines(&written.text)[3], frame, "{}", written.text);
        assert_eq!(written.diagnostics[0].code, "frame-added", "{written:?}");
        let own = write("G55\nG0 X1 Y1\nG1 X5 F100\nM2\n", target);
        assert_eq!(lines(&own.text)[3], "N20 G55", "{}", own.text);
    }
}

#[test]
fn arcs_say_their_plane_when_it_changes() {
    let program = "G17 G0 X0 Y0 Z0\nG1 X10 F300\nG3 X20 Y10 J10\nG18 G2 X30 Z-10 K-10\n\
                   G19 G3 Y20 Z0 K10\nG2 Y30 Z10 R10\nG17 G2 X40 Y40 I10\nM2\n";
    let text = write(program, Target::Grbl).text;
    let expected = [
        "G21 G90 G17 G94",
        "G0 X0 Y0 Z0",
        "G1 X10 F300",
        "G3 X20 Y10 J10",
        "G18 G2 X30 Z-10 K-10",
        "G19 G3 Y20 Z0 K10",
        "G2 Y30 Z10 J10",
        "G17 X40 Y40 I10",
        "M2",
    ];
    assert_eq!(lines(&text), expected, "{text}");
    // Marlin as delivered knows none but the first plane.
    let text = write(program, Target::Marlin).text;
    assert!(!text.contains("G18") && !text.contains('K'), "{text}");
    // Sagitta 1e-3 less rounding, 10 mm: a quarter circle takes at least 59 chords.
    assert!(lines(&text).len() > 3 * 59, "{} lines", lines(&text).len());
}

#[test]
fn inserted_moves_tell_why_they_are_there() {
    let program =
        "G0 X-10 Y-10\nG1 Z-1 F100\nG41 D1 X0 Y0\nX40 Y10\nX0 Y20\nX-10\nG40 X-20 Y30\nM2\n";
    let explained = |target, options: &Options| {
        let path = compensate_program(&read(program), &Tools::all(3.0), options);
        emit(&path, &EmitOptions { target, explain: true, ..EmitOptions::default() }).text
    };
    let avoid = Options { gouge: GougePolicy::Avoid, ..Options::default() };
    for options in [Options::default(), avoid] {
        let text = explained(Target::Grbl, &options);
        assert!(text.contains("(lead-in: compensation is switched on)\n"), "{text}");
        assert!(text.contains("(lead-out: compensation is switched off)\n"), "{text}");
    }
    let round = Options { corner: CornerStyle::Arc, ..Options::default() };
    // On the right the tip is an outside corner; its sides enclose 2 atan(10/40) = 28.1 degrees.
    let right = program.replace("G41", "G42");
    let path = compensate_program(&read(&right), &Tools::all(3.0), &round);
    let text = emit(&path, &EmitOptions { explain: true, ..EmitOptions::default() }).text;
    assert!(text.contains("(inserted: corner of 28.1 deg at X40 Y10)\nG3 "), "{text}");
    let fanuc = EmitOptions { target: Target::Fanuc0M, explain: true, ..EmitOptions::default() };
    let text = emit(&path, &fanuc).text;
    assert!(text.contains("\n(INSERTED: CORNER OF 28.1 DEG AT X40 Y10)\n"), "{text}");
    let plain = emit(&path, &EmitOptions::default()).text;
    assert!(!plain.contains('('), "only where it is asked for: {plain}");
}

#[test]
fn a_control_that_compensates_gets_the_contour_with_its_words() {
    let program = "%\nO3\nG54 G0 X-30 Y-10\nG43 H1 Z2 M8\nG1 Z-6 F80\nG41 D1 X0 Y0 F120\nY40\n\
                   M9\nG2 X20 Y60 I20\nG1 X50\nG42 D2 Y40\nG40 X-30 Y-10\nM30\n%\n";
    let path = programmed_path(&read(program));
    let written = emit(&path, &EmitOptions { target: Target::Fanuc0M, ..EmitOptions::default() });
    let text = &written.text;
    for block in
        ["G43 H1", "G41 D1 X0. Y0. F120", "Y40.", "M9", "G2 X20. Y60. I20.", "G40 X-30. Y-10."]
    {
        assert!(text.contains(&format!(" {block}\n")), "{block} is missing\n{text}");
    }
    assert!(written.diagnostics.iter().all(|d| d.severity < Severity::Error), "{written:?}");
    // What it means is unchanged.
    let again = programmed_path(&read(text));
    let ends = |path: &ToolPath| -> Vec<_> { path.moves.iter().map(|m| m.curve.end()).collect() };
    assert_eq!(ends(&again), ends(&path), "{text}");
    // A controller without compensation must not run it unawares.
    let grbl = emit(&path, &EmitOptions::default());
    assert!(grbl.diagnostics.iter().any(|d| d.code == "not-compensated"), "{grbl:?}");
    assert!(!grbl.text.contains("G41"), "{}", grbl.text);
}

#[test]
fn linuxcnc_compensates_itself_by_number_and_by_diameter() {
    let program = "G20\nG0 X-1 Y0\nG1 G41.1 D0.25 X0 Y0 F10\nY2\nG42 D2 X1\nG40 Y3\nM2\n";
    let path = programmed_path(&read(program));
    let options = EmitOptions { target: Target::LinuxCnc, ..EmitOptions::default() };
    let written = emit(&path, &options);
    // A diameter of a quarter of an inch, in mm as all that is written.
    for words in ["G41.1 D6.35", "G42 D2", "G40"] {
        assert!(written.text.contains(words), "{words} is missing\n{}", written.text);
    }
    assert!(written.diagnostics.iter().all(|d| d.severity < Severity::Error), "{written:?}");
}

#[test]
fn cubics_are_native_on_demand_and_exact_up_to_rounding() {
    let program = "G0 X0 Y0\nG1 X1 F100\nG05 X10 Y5\nX20 Y-3\nX30 Y0\nM2\n";
    let path = path_of(program, 0.0);
    let native = |target| {
        let splines = SplineOutput::Native;
        emit(&path, &EmitOptions { target, splines, ..EmitOptions::default() }).text
    };
    let text = native(Target::LinuxCnc);
    let blocks =
        lines(&text).iter().filter(|line| line.contains(" I") && line.contains(" Q")).count();
    assert_eq!(blocks, 3, "one for each span\n{text}");
    assert!(text.contains("\nG5 X10 Y5 I"), "{text}");
    assert!(!native(Target::Grbl).contains("G5"), "grbl has none");
    let arcs =
        emit(&path, &EmitOptions { target: Target::LinuxCnc, ..EmitOptions::default() }).text;
    assert!(!arcs.contains("G5"), "only on demand\n{arcs}");
}

#[test]
fn block_numbers_begin_again_before_they_have_five_digits() {
    let mut program = String::from("G0 X0 Y0\nG1 F100\n");
    for i in 0..1200 {
        program.push_str(if i % 2 == 0 { "X1\n" } else { "X2\n" });
    }
    let text = write(&program, Target::Fanuc0M).text;
    assert!(text.contains("\nN9990 ") && !text.contains("\nN10000"), "{}", text.len());
    assert_eq!(text.matches("\nN10 ").count(), 2, "from ten again");
}

#[test]
fn the_way_home_keeps_its_increments() {
    // By way of where the tool is: absolute, Z0 would be a rapid move down to the part's zero.
    let text = "G21 G90\nG0 X1 Y2 Z9\nG91 G28 Z0\nG28 X0 Y0\nG90\nG0 X5\n";
    for target in [Target::Grbl, Target::GrblHal, Target::LinuxCnc, Target::Smoothieware] {
        let written = write(text, target);
        let lines = lines(&written.text);
        let home = lines.iter().position(|line| *line == "G91 G28 Z0");
        let home = home.unwrap_or_else(|| panic!("{target:?}: {lines:?}"));
        assert_eq!(lines[home + 1..home + 4], ["G90", "G91 G28 X0 Y0", "G90"], "{target:?}");
        assert_eq!(written.diagnostics, [], "{target:?}");
    }
    let fanuc = write(text, Target::Fanuc0M);
    assert!(fanuc.text.contains("G91 G28 Z0.\n"), "{}", fanuc.text);
    let marlin = write(text, Target::Marlin);
    assert!(!marlin.text.contains("G91"), "{}", marlin.text);
    let told = &marlin.diagnostics[0].message;
    assert_eq!(told, "G28 is left out: the target does not know it", "and nothing about G91");
}

#[test]
fn heidenhain_gets_blocks_of_its_own_language() {
    let written = write(WORDS, Target::Heidenhain);
    let expected = [
        "0 BEGIN PGM 12 MM",
        "1 TOOL CALL 2 Z",
        "2 ;drill",
        "3 TOOL CALL S1500",
        "4 M3",
        "5 M8",
        "6 L X+5 Y+5 Z+2.5 R0 FMAX",
        "7 L Z-1 F60.5",
        "8 CYCL DEF 9.0 DWELL TIME",
        "9 CYCL DEF 9.1 DWELL 0.25",
        "10 L X+10",
        "11 M9",
        "12 M30",
        "13 END PGM 12 MM",
    ];
    assert_eq!(lines(&written.text), expected, "{}", written.text);
    let found: Vec<_> = written.diagnostics.iter().map(|d| d.message.as_str()).collect();
    assert_eq!(found.len(), 3, "{found:?}");
    for (message, word) in found.into_iter().zip(["G43", "G61", "G54"]) {
        assert!(message.starts_with(word), "{message}");
    }
}

#[test]
fn heidenhain_gets_centres_helices_and_moves_of_the_machine() {
    let program = "S800 T3 M6\nG53 G0 Z-1\nG0 X10 Y0 Z5\nG3 X0 Y10 I-10 F200\nG2 X0 Y-10 Z0 J-10\n\
                   G2 J10\nG0 Z5\nG18 G3 X10 Z15 I10\nT4\nM2\n";
    let expected = [
        "0 BEGIN PGM 1 MM",
        "1 TOOL CALL 3 Z S800",
        "2 L Z-1 FMAX M91",
        "3 L X+10 Y+0 Z+5 R0 FMAX",
        "4 CC X+0 Y+0",
        "5 C X+0 Y+10 DR+ F200",
        "6 CC X+0 Y+0",
        "7 CP IPA-180 IZ-5 DR-",
        "8 CC X+0 Y+0",
        "9 C X+0 Y-10 DR-",
        "10 L Z+5 FMAX",
        "11 CC Z+5 X+10",
        "12 C Z+15 X+10 DR+",
        "13 TOOL DEF 4",
        "14 M2",
        "15 END PGM 1 MM",
    ];
    let written = write(program, Target::Heidenhain);
    assert_eq!(lines(&written.text), expected, "{}", written.text);
    assert!(written.diagnostics.is_empty(), "{written:?}");
}

#[test]
fn heidenhain_compensates_itself_where_it_is_to() {
    let program = "T1 M6\nG0 X-20 Y0 Z5\nG1 G41 D1 X0 F300\nY40\nX30\nG40 Y60\nM30\n";
    let written = emit(
        &programmed_path(&read(program)),
        &EmitOptions { target: Target::Heidenhain, ..EmitOptions::default() },
    );
    let moves: Vec<&str> =
        written.text.lines().filter_map(|line| line.split_once(' ')).map(|(_, b)| b).collect();
    let expected = ["L X+0 RL F300", "L Y+40", "L X+30", "L Y+60 R0"];
    assert_eq!(moves[3..7], expected, "{}", written.text);
    assert!(written.diagnostics.is_empty(), "the radius is that of the tool: {written:?}");
    let other = program.replace("D1", "D2");
    let written = emit(
        &programmed_path(&read(&other)),
        &EmitOptions { target: Target::Heidenhain, ..EmitOptions::default() },
    );
    assert!(written.diagnostics[0].message.starts_with("D2"), "another radius: {written:?}");
}

#[test]
fn heidenhain_gets_cubics_about_their_ends() {
    // Bernstein to powers about the end, by hand: ends (0,0) and (30,0), controls (10,20), (20,20).
    let program = "G17 G90 G0 X0 Y0 Z0\nG5 I10 J20 P-10 Q20 X30 Y0 F100\nM2\n";
    let path = compensate_program(
        &interpret(&Program::parse(program, Dialect::LinuxCnc), Rules::default()),
        &Tools::all(0.0),
        &Options::default(),
    );
    let options = EmitOptions {
        target: Target::Heidenhain,
        splines: SplineOutput::Native,
        ..EmitOptions::default()
    };
    let text = emit(&path, &options).text;
    let expected = ["2 SPL X+30 Y+0 ~", "K3X+0 K2X+0 K1X-3E+1 ~", "K3Y+0 K2Y-6E+1 K1Y+6E+1 F100"];
    assert_eq!(lines(&text)[2..5], expected, "{text}");
}

#[test]
fn axes_that_a_target_lacks_go_nowhere_with_g28_and_only_their_moves_are_errors() {
    let text = "G0 X1 Y2 A0\nG91 G28 X0 Y0 A0\nG28 U0\nG90 G0 X1 Y2 Z3\nA90\nM30\n";
    let written = write(text, Target::Grbl);
    let found: Vec<_> = written.diagnostics.iter().map(|d| (d.code, d.severity)).collect();
    let (warning, error) = (("left-out", Severity::Warning), ("left-out", Severity::Error));
    assert_eq!(found, [warning, warning, error], "A0, U0 and A90: {written:?}");
    assert!(written.text.contains("G91 G28 X0 Y0\n"), "{}", written.text);
    assert!(!written.text.contains("G28\n"), "all axes would move: {}", written.text);
    let kept = write(text, Target::LinuxCnc).text;
    assert!(kept.contains("G28 X0 Y0 A0") && kept.contains("A90"), "{kept}");
}

#[test]
fn the_fastest_speed_is_said_to_those_alone_who_know_it_by_g92() {
    let text = "G92 S2500\nG0 X1 Y2 Z3\n";
    let written = write(text, Target::Grbl);
    assert!(!written.text.contains("G92"), "{}", written.text);
    assert_eq!(written.diagnostics.len(), 1, "it is told: {written:?}");
    assert!(write(text, Target::Fanuc0M).text.contains("G92 S2500"), "FANUC knows it");
}

#[test]
fn after_a_tool_change_places_are_stated_as_they_were() {
    let text = "G0 X1 Y2 Z50\nT2 M6\nG0 X1 Y2\nZ5\nX1 Y2\nG1 Z-1 F100\nM30\n";
    let written = write(text, Target::Grbl).text;
    let expected = "M0\nX1 Y2\nZ5\nG1 Z-1";
    assert!(written.contains(expected), "the operator may have moved the tool: {written}");
}
