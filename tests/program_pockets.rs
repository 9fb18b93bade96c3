//! Pockets that programs go round, cleared in several passes.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::compensation::{GougePolicy, Options, Passes};
use g41::contour::{Role, ToolPath};
use g41::program::{Dialect, EmitOptions, Program, Rules, emit, interpret};
use g41::simulation::{Tools, compensate_program};
use glam::DVec2;

#[test]
fn words_stay_behind_their_move_where_a_pocket_is_cleared_room_by_room() {
    // Three rooms, and M8 in the last but one; with one pass the tool is too wide for the corridors.
    let text = "G21 G90\nG0 X5 Y10 Z5\nG1 Z-2 F120\nG41 X10 Y0 F400\nX20\nY8\nX30\nY0\nX50\nM8\nY8\n\
                X60\nY0\nX80\nY20\nX60\nY12\nX50\nY20\nX30\nY12\nX20\nY20\nX0\nY0\nX10\nG40 X15 Y10\n\
                M9\nG0 Z5\n";
    let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
    let with = |passes| {
        let options = Options { gouge: GougePolicy::Avoid, passes, ..Options::default() };
        compensate_program(&read, &Tools::all(3.0), &options)
    };
    let (one, all) = (with(Passes::One), with(Passes::All { stepover: 2.0 }));
    let passes: Vec<_> = all.loops.iter().map(|one| one.pass).collect();
    assert!(!passes.is_sorted(), "room by room: {passes:?}");
    let behind = |path: &ToolPath, text: &str| {
        let words = path.words.iter().find(|words| words.words == text).expect("they are kept");
        path.moves[words.before - 1].curve
    };
    assert_eq!(behind(&all, "M8"), behind(&one, "M8"), "beside the same wall");
    assert_eq!(
        all.words.last().map(|words| words.before),
        Some(all.loops[passes.len() - 1].moves_end),
        "M9 behind all"
    );
}

#[test]
fn a_pocket_is_cleared_without_lifting_the_tool() {
    let text = "G21 G90\nG0 X20 Y10 Z5\nG1 Z-2 F120\nG41 D1 X20 Y0 F400\nX40\nY30\nX0\nY0\nX20\n\
                G40 X20 Y10\nG0 Z5\n";
    let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
    let passes = Passes::All { stepover: 3.0 };
    let options = Options { gouge: GougePolicy::Avoid, passes, ..Options::default() };
    let path = compensate_program(&read, &Tools::all(3.0), &options);
    let written = emit(&path, &EmitOptions { explain: true, ..EmitOptions::default() });
    assert_eq!(written.diagnostics, [], "{}", written.text);
    // 40 by 30 mm: walls at 3, 6, 9 and 12 mm, and at 15 mm there and back along a line.
    assert_eq!(written.text.matches("(link: to the next pass)").count(), 4, "{}", written.text);
    assert_eq!(written.text.matches('Z').count(), 3, "down once and up once: {}", written.text);
    assert!(written.text.contains("Y6\nX34\nY24\nX6\nY6\nX20\n"), "{}", written.text);
}

#[test]
fn a_pocket_is_cleared_whose_program_runs_past_its_start() {
    let around = "G1 X22\nG3 X30 Y-12 J8\nG1 Y12\nG3 X22 Y20 I-8\nG1 X-22\nG3 X-30 Y12 J-8\nG1 Y-12\n\
                  G3 X-22 Y-20 I8\n";
    let led = |way_in: &str, way_out: &str| {
        format!(
            "G21 G90\nG0 X0 Y0 Z5\nG1 Z-3 F150\nG41 D1 {way_in}\n{around}{way_out}\nG40 G1 X0 Y0\nG0 Z50\n"
        )
    };
    // On along the wall, at the bottom and at the top; by arcs that touch it; and by a rounding past the
    // start or short of it.
    let turned = ["X", "Y", "I", "J"].iter().fold(led("G1 X0 Y-20 F500", "G1 X3"), |text, word| {
        text.replace(word, &format!("{word}-")).replace("--", "")
    });
    for text in [
        led("G1 Y-20 F500", "G1 X3"),
        turned,
        led("G1 X-8 Y-12 F500\nG3 X0 Y-20 I8", "G1 X0\nG3 X8 Y-12 J8"),
        led("G1 X0 Y-20 F500", "G1 X0.004"),
        led("G1 X0 Y-20 F500", "G1 X-0.004"),
    ] {
        let read = interpret(&Program::parse(&text, Dialect::Auto), Rules::default());
        let passes = Passes::All { stepover: 3.0 };
        let options = Options { gouge: GougePolicy::Avoid, passes, ..Options::default() };
        let path = compensate_program(&read, &Tools::all(3.0), &options);
        assert_eq!(path.diagnostics, [], "{text}");
        // 20 mm from wall to middle: the tool is there at 3, 6, … 18 mm.
        let passes: Vec<_> = path.loops.iter().map(|one| one.pass).collect();
        assert_eq!(passes, [0, 1, 2, 3, 4, 5], "{text}");
        let links = path.moves.iter().filter(|one| one.role == Role::Link).count();
        assert_eq!(links, 5, "it stays down: {text}");
        let inner = &path.moves[path.loops[1].first_move..path.loops[5].moves_end];
        let reach = |of: &dyn Fn(DVec2) -> f64| {
            inner.iter().map(|one| of(one.curve.end())).fold(0.0, f64::max)
        };
        let [x, y] = [reach(&|at| at.x.abs()), reach(&|at| at.y.abs())];
        assert!((x.max(y) - 24.0).abs() < 0.011, "6 mm from the ends: {x} {y} of {text}");
        assert!((x.min(y) - 14.0).abs() < 0.011, "6 mm from the sides: {x} {y} of {text}");
    }
}

#[test]
fn laps_at_several_depths_are_no_pocket_in_passes() {
    let lap = "X40 F400\nY30\nX0\nY0\nX20\n";
    let text = format!(
        "G21 G90\nG0 X20 Y10 Z5\nG1 Z-2 F120\nG41 D1 X20 Y0 F400\n{lap}G1 Z-4 F120\n{lap}G40 X20 Y10\nG0 Z5\n"
    );
    let read = interpret(&Program::parse(&text, Dialect::Auto), Rules::default());
    let with = |passes| {
        let options = Options { gouge: GougePolicy::Avoid, passes, ..Options::default() };
        compensate_program(&read, &Tools::all(3.0), &options)
    };
    let (one, all) = (with(Passes::One), with(Passes::All { stepover: 3.0 }));
    assert_eq!(all.moves, one.moves, "both laps along the wall");
    let codes: Vec<_> = all.diagnostics.iter().map(|found| found.code).collect();
    assert_eq!(codes, ["several-laps"], "it is told");
}
