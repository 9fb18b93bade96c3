//! Bad input: whatever is read, there is an answer in bounded time, and never a panic.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::fmt::Write;
use std::ops::Range;

use g41::compensation::{GougePolicy, Options};
use g41::contour::{MoveCurve, ToolPath};
use g41::diagnostic::Diagnostic;
use g41::program::{
    Dialect, EmitOptions, Emitted, Interpretation, Item, Program, Rules, RunOptions, Runner,
    Target, emit, interpret,
};
use g41::simulation::{Tools, compensate_program};

mod vocabulary;
use vocabulary::{Random, bytes, characters, corners, curves, involutes, line, words};

/// How many programs of each kind.
const CASES: u64 = if cfg!(target_arch = "wasm32") { 200 } else { 2_000 };

/// Length of the long ones [bytes].
const LONG: usize = if cfg!(target_arch = "wasm32") { 500_000 } else { 5_000_000 };

/// Reads, interprets, compensates and writes.
fn all_stages(text: &str) -> (ToolPath, Emitted) {
    let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
    assert_bounded(&read.diagnostics);
    let path = compensate_program(&read, &Tools::all(1.5), &Options::default());
    let written = emit(&path, &EmitOptions::default());
    (path, written)
}

/// At most a hundred diagnostics of a code, and none long.
fn assert_bounded(diagnostics: &[Diagnostic]) {
    assert!(diagnostics.len() < 6_000, "{} diagnostics", diagnostics.len());
    for diagnostic in diagnostics {
        assert!(diagnostic.message.chars().count() < 300, "{diagnostic}");
    }
}
/// From which seed to which programs of the language are made: `G41_SEEDS=FROM..TO`.
fn seeds() -> Range<u64> {
    let Ok(text) = std::env::var("G41_SEEDS") else { return 0..5 * CASES };
    let (from, to) = text.split_once("..").expect("G41_SEEDS is FROM..TO");
    from.parse().expect("a seed")..to.parse().expect("a seed")
}

/// Runs in slices of a seeded size, within bounds that small programs of loops reach.
fn run(text: &str, dialect: Dialect, slice: u64) -> Interpretation {
    let bounds = RunOptions {
        most_blocks: 500,
        most_text: 100_000,
        most_items: 500,
        deepest: 20,
        ..RunOptions::default()
    };
    let mut runner = Runner::new(&Program::parse(text, dialect), bounds);
    let mut slices = 0;
    while runner.step(slice) {
        slices += 1;
        assert!(slices <= 110_000, "it does not end");
    }
    runner.finish()
}

#[test]
fn programs_of_loops_and_macros_in_no_order_come_to_an_end() {
    for seed in seeds() {
        let mut random = Random(seed);
        let lines = 3 + random.below(25);
        let text: String = (0..lines).map(|_| line(&mut random) + "\n").collect();
        let dialects = [Dialect::Auto, Dialect::LinuxCnc, Dialect::Fanuc, Dialect::Sinumerik];
        let dialect = dialects[usize::try_from(random.below(4)).expect("an index")];
        let caught = std::panic::catch_unwind(|| run(&text, dialect, u64::MAX));
        let Ok(read) = caught else { panic!("seed {seed}: {dialect:?}\n{text}") };
        // What cycles are expanded to has a bound of its own; rapid moves between their pecks count too.
        assert!(read.items.len() < 4_005_000, "seed {seed}: {} items", read.items.len());
        assert_bounded(&read.diagnostics);
        for item in &read.items {
            if let Item::Free(found) = item {
                let [a, b] = [found.curve.start(), found.curve.end()];
                assert!(a.is_finite() && b.is_finite(), "seed {seed}: {found:?}");
            }
        }
        if seed % 16 == 0 {
            let slices = run(&text, dialect, 1 + random.below(9));
            assert_eq!(slices, read, "seed {seed}: in slices\n{text}");
        }
    }
}

#[test]
fn random_bytes_are_reported() {
    for seed in 0..CASES {
        let text = bytes(&mut Random(seed), 300);
        let (path, written) = all_stages(&text);
        assert!(!path.diagnostics.is_empty(), "seed {seed}");
        assert!(written.text.starts_with("G21"), "seed {seed}");
    }
}

#[test]
fn random_characters_of_programs_are_read() {
    for seed in 0..CASES {
        let text = characters(&mut Random(seed), 500);
        let (path, _) = all_stages(&text);
        assert!(path.moves.len() < 500, "seed {seed}");
    }
}

#[test]
fn random_words_give_paths_that_can_be_written_and_read_again() {
    for seed in 0..CASES {
        let text = words(&mut Random(seed), 120);
        let (path, written) = all_stages(&text);
        for found in &path.moves {
            let [a, b] = [found.curve.start(), found.curve.end()];
            assert!(a.is_finite() && b.is_finite(), "seed {seed}: {found:?}");
        }
        // A move that has length is a move that is written.
        let again = interpret(&Program::parse(&written.text, Dialect::Auto), Rules::default());
        // Offsets of centres may be twice as large as coordinates can be.
        let wrong = |d: &&Diagnostic| {
            matches!(
                d.code,
                "word-not-understood"
                    | "no-motion-mode"
                    | "arc-without-centre"
                    | "garbled-number"
                    | "missing-number"
                    | "number-without-letter"
                    | "repeated-word"
                    | "unexpected-character"
            )
        };
        let fault = again.diagnostics.iter().find(wrong);
        assert!(fault.is_none(), "seed {seed}: {fault:?}\n{}", written.text);
    }
}

#[test]
fn random_curves_are_read_compensated_and_written() {
    for seed in 0..CASES / 4 {
        let text = curves(&mut Random(seed), 60);
        for dialect in [Dialect::LinuxCnc, Dialect::Sinumerik] {
            let read = interpret(&Program::parse(&text, dialect), Rules::default());
            assert_bounded(&read.diagnostics);
            let path = compensate_program(&read, &Tools::all(1.5), &Options::default());
            for found in &path.moves {
                let [a, b] = [found.curve.start(), found.curve.end()];
                assert!(a.is_finite() && b.is_finite(), "seed {seed}: {found:?}\n{text}");
            }
            let written = emit(&path, &EmitOptions::default());
            assert!(written.text.starts_with("G21"), "seed {seed}");
        }
    }
}

#[test]
fn five_megabytes_of_noise_come_to_an_end() {
    let mut random = Random(41);
    let inputs = [
        ("bytes", bytes(&mut random, LONG)),
        ("characters", characters(&mut random, LONG)),
        ("characters in one line", characters(&mut random, LONG).replace('\n', " ")),
        ("zeros", "\0".repeat(LONG)),
        ("digits", "7".repeat(LONG)),
        ("one number", format!("X{}", "7".repeat(LONG))),
        ("a fraction", format!("G0 X0.{}", "7".repeat(LONG))),
        ("brackets", "[".repeat(LONG)),
        ("brackets of words", "X[".repeat(LONG / 2)),
        ("comments", "(".repeat(LONG)),
        ("words of one line", "G1X1".repeat(LONG / 4)),
        ("empty lines", "\n".repeat(LONG)),
        ("slashes", "/".repeat(LONG)),
        ("per cent", "%\n".repeat(LONG / 2)),
        ("variables", "#<".repeat(LONG / 2)),
    ];
    for (name, text) in inputs {
        let (_, written) = all_stages(&text);
        assert!(written.text.starts_with("G21"), "{name}");
    }
}

#[test]
fn five_megabytes_of_words_come_to_an_end() {
    let text = words(&mut Random(42), LONG / 5);
    let read = interpret(&Program::parse(&text, Dialect::Auto), Rules::default());
    assert_bounded(&read.diagnostics);
    // The later stages on a part of it: what they make of it is many times as large.
    let (path, _) = all_stages(&text[..LONG / 10]);
    assert!(!path.moves.is_empty(), "there is a path");
}

#[test]
fn a_contour_of_many_segments_and_events_comes_to_an_end() {
    let mut text = String::from("G0 X0 Y-9\nG41 D1 G1 X0 Y0 F600\n");
    let mut x = 0.0;
    while text.len() < LONG / 5 {
        x += 0.5;
        let y = if x % 1.0 == 0.0 { 0 } else { 3 };
        writeln!(text, "X{x} Y{y}\nM8").expect("a string takes everything");
    }
    text.push_str("G40 Y-9\nM30\n");
    let (path, _) = all_stages(&text);
    assert!(!path.moves.is_empty(), "there is a path");
}

#[test]
fn a_spline_of_many_type_points_comes_to_an_end() {
    let mut text = String::from("G0 X0 Y-20\nG41 D1 G1 X0 Y0 F600\nG05 ");
    let mut x = 0.0_f64;
    while text.len() < LONG / 25 {
        x += 1.0;
        let y = 20.0 * (0.02 * x).sin();
        writeln!(text, "X{x} Y{y:.4}").expect("a string takes everything");
    }
    text.push_str("G40 G1 Y-50\nM30\n");
    let (_, written) = all_stages(&text);
    assert!(written.text.lines().count() > 100, "there is a path");
}

#[test]
fn involutes_of_any_size_go_through_every_stage() {
    let mut random = Random(77);
    let mut read = 0;
    for case in 0..CASES / 20 {
        let text = involutes(&mut random, 3);
        let (path, _) = all_stages(&text);
        let mut finite = |path: &ToolPath| {
            for one in &path.moves {
                for t in [0.0, 0.3, 1.0] {
                    assert!(one.curve.point(t).is_finite(), "case {case}: {one:?} of\n{text}");
                    read += usize::from(matches!(one.curve, MoveCurve::Involute(_)));
                }
            }
        };
        finite(&path);
        for gouge in [GougePolicy::Avoid, GougePolicy::Stop] {
            let found = interpret(&Program::parse(&text, Dialect::Auto), Rules::default());
            let options = Options { gouge, ..Options::default() };
            finite(&compensate_program(&found, &Tools::all(1.5), &options));
        }
        for target in [Target::Fanuc30I, Target::Marlin] {
            let written = emit(&path, &EmitOptions { target, ..EmitOptions::default() });
            assert!(!written.text.contains("NaN") && !written.text.contains("inf"), "{text}");
        }
    }
    assert!(read > 100, "{read} places on involutes");
}

#[test]
fn corners_cut_in_any_program_leave_its_moves_in_one_piece() {
    let mut cut = 0;
    for seed in 0..CASES {
        let text = corners(&mut Random(seed), 20);
        let (path, written) = all_stages(&text);
        assert_bounded(&path.diagnostics);
        assert_bounded(&written.diagnostics);
        let read = interpret(&Program::parse(&text, Dialect::Auto), Rules::default());
        for pair in read.items.windows(2) {
            let [Item::Free(one), Item::Free(two)] = pair else { continue };
            if one.plane == two.plane {
                let gap = one.curve.end().distance(two.curve.start());
                assert!(gap < 1e-6, "{gap} mm between moves, seed {seed}:\n{text}{:?}", read.items);
            }
            cut += usize::from(one.origin == two.origin);
        }
    }
    assert!(cut > 100, "{cut} corners cut");
}
