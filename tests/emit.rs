//! Programs as they are written: what a plain controller reads is the path that was asked for.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::f64::consts::TAU;

use g41::compensation::Options;
use g41::contour::{AuxiliaryWords, Move, MoveCurve, Plane, Role, ToolPath};
use g41::diagnostic::{Origin, Severity};
use g41::geometry::{Arc, Cubic, Line};
use g41::program::{Dialect, EmitOptions, Emitted, Program, Rules, emit, interpret};
use g41::simulation::{Tools, compensate_program};
use glam::DVec2;

/// The path of a program without compensation, or with tools of no radius.
fn path_of(text: &str) -> ToolPath {
    let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
    compensate_program(&read, &Tools::all(0.0), &Options::default())
}

fn write(path: &ToolPath) -> Emitted {
    emit(path, &EmitOptions::default())
}

/// Blocks after the header.
fn blocks(text: &str) -> Vec<&str> {
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("G21 G90 G17 G94"), "the header");
    lines.collect()
}

fn block(line: u32) -> Origin {
    Origin::Block { line, number: None, column: None }
}

/// A free feed move at 10 mm/s.
fn feed_move(curve: MoveCurve, heights: [f64; 2]) -> Move {
    Move {
        curve,
        role: Role::Free,
        rapid: false,
        feed: Some(10.0),
        plane: Plane::Xy,
        heights,
        origin: block(1),
    }
}

fn arc(start: [f64; 2], center: [f64; 2], sweep: f64) -> Arc {
    Arc::from_sweep(start.into(), center.into(), sweep).expect("a proper arc")
}

fn arcs_path(arcs: &[Arc]) -> ToolPath {
    let start = arcs[0].start();
    let mut moves = Vec::new();
    if let Ok(line) = Line::new(DVec2::ZERO, start) {
        moves.push(feed_move(MoveCurve::Line(line), [0.0; 2]));
    }
    moves.extend(arcs.iter().map(|&arc| feed_move(MoveCurve::Arc(arc), [0.0; 2])));
    ToolPath { moves, ..ToolPath::default() }
}

/// A controller with nothing but these words: the points it passes, taken densely. It shares no
/// code with the reader under test.
fn run(text: &str) -> Vec<[f64; 3]> {
    let mut at = [0.0_f64; 3];
    let mut motion = 0.0;
    let mut points = vec![at];
    for line in text.lines() {
        let line = line.split(['(', ';']).next().expect("a line has a beginning");
        let mut to = at;
        let mut center = [0.0; 2];
        let mut moves = false;
        for word in line.split_whitespace() {
            let value: f64 = word[1..].parse().expect("a number");
            match &word[..1] {
                "G" if value <= 3.0 => motion = value,
                "X" => (to[0], moves) = (value, true),
                "Y" => (to[1], moves) = (value, true),
                "Z" => (to[2], moves) = (value, true),
                "I" => center[0] = value,
                "J" => center[1] = value,
                _ => {}
            }
        }
        if !moves {
            continue;
        }
        let steps = 400;
        if motion >= 2.0 {
            let c = [at[0] + center[0], at[1] + center[1]];
            let (a0, a1) = ((at[1] - c[1]).atan2(at[0] - c[0]), (to[1] - c[1]).atan2(to[0] - c[0]));
            let mut turn = a1 - a0;
            if motion == 2.0 && turn >= -1e-12 {
                turn -= TAU;
            } else if motion == 3.0 && turn <= 1e-12 {
                turn += TAU;
            }
            let radii = [(at[0] - c[0]).hypot(at[1] - c[1]), (to[0] - c[0]).hypot(to[1] - c[1])];
            assert!((radii[0] - radii[1]).abs() < 5e-4, "radii disagree: {line}");
            for i in 1..=steps {
                let t = f64::from(i) / f64::from(steps);
                let (angle, radius) = (a0 + turn * t, radii[0] + (radii[1] - radii[0]) * t);
                points.push([
                    c[0] + radius * angle.cos(),
                    c[1] + radius * angle.sin(),
                    at[2] + (to[2] - at[2]) * t,
                ]);
            }
        } else {
            for i in 1..=steps {
                let t = f64::from(i) / f64::from(steps);
                points.push([0, 1, 2].map(|k| at[k] + (to[k] - at[k]) * t));
            }
        }
        at = to;
    }
    points
}

fn length(points: &[[f64; 3]]) -> f64 {
    points
        .windows(2)
        .map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1]).hypot(p[1][2] - p[0][2]))
        .sum()
}

#[test]
fn modal_words_are_not_repeated_and_numbers_are_short() {
    let path = path_of(
        "G0 X10 Y0 Z5\nG1 Z-1.50 F300\nX10.25\nX20 Y-0.00001\nF600 Y5\nG2 X25 Y10 I5 J0\n\
         G3 X30 Y5 I0 J-5\nG0 Z5\n",
    );
    let text = write(&path).text;
    assert_eq!(
        blocks(&text),
        [
            "G0 X10 Y0 Z5",
            "G1 Z-1.5 F300",
            "X10.25",
            "X20",
            "Y5 F600",
            "G2 X25 Y10 I5",
            "G3 X30 Y5 J-5",
            "G0 Z5",
        ],
        "{text}"
    );
}

#[test]
fn a_plain_program_comes_back_as_it_was() {
    for program in [
        include_str!("programs/pocket.ngc"),
        include_str!("programs/cam.ngc"),
        include_str!("programs/slot.ngc"),
        include_str!("programs/lettering.ngc"),
        include_str!("programs/inch_plate.ngc"),
        include_str!("programs/incremental.ngc"),
        include_str!("programs/helix.ngc"),
    ] {
        let path = path_of(program);
        let written = write(&path);
        let again = path_of(&written.text);
        assert!(again.diagnostics.is_empty(), "{:?}\n{}", again.diagnostics, written.text);
        let is_cubic = |m: &Move| matches!(m.curve, MoveCurve::Cubic(_));
        if path.moves.iter().any(is_cubic) {
            continue;
        }
        assert_eq!(write(&again).text, written.text, "writing it again changes nothing");
        assert_eq!(again.moves.len(), path.moves.len(), "{}", written.text);
        for (a, b) in again.moves.iter().zip(&path.moves) {
            assert!(a.curve.end().distance(b.curve.end()) < 1e-4, "{a:?}\n{b:?}");
            assert!(a.curve.point(0.5).distance(b.curve.point(0.5)) < 2e-4, "{a:?}\n{b:?}");
            assert!((a.heights[1] - b.heights[1]).abs() < 1e-4, "{a:?}\n{b:?}");
            assert_eq!(a.rapid, b.rapid, "{a:?}\n{b:?}");
            let feeds = (a.feed.unwrap_or(0.0), b.feed.unwrap_or(0.0));
            assert!((feeds.0 - feeds.1).abs() < 1e-4, "{a:?}\n{b:?}");
        }
    }
}

#[test]
fn words_keep_their_place_and_those_of_compensation_disappear() {
    let path = path_of(
        "%\nO7\nT1 M6\nG43 H1\nG0 X0 Y-9\nM3 S900\nG41 D1 G1 X0 Y0 F100\nX9 (side)\nX20\nG40 Y-9\nM30\n%\n",
    );
    let written = write(&path);
    assert_eq!(
        blocks(&written.text),
        [
            "(O7)",
            "T1",
            "(change to tool 1)",
            "M0",
            "G0 X0 Y-9",
            "S900 M3",
            "G1 Y0 F100",
            "(side)",
            "X9",
            "X20",
            "Y-9",
            "M30"
        ],
        "{}",
        written.text
    );
}

#[test]
fn a_first_position_at_zero_is_written() {
    let path = path_of("G0 X0 Y0\nG0 Z5\nG1 X5 F60\nM2\n");
    let text = write(&path).text;
    assert_eq!(blocks(&text), ["G0 X0 Y0", "Z5", "G1 X5 F60", "M2"], "{text}");
}

#[test]
fn a_first_height_at_zero_is_reached_as_programmed() {
    let down = "G0 X0 Y-9\nG1 Z0 F100\nX9\nM2\n";
    let text = write(&path_of(down)).text;
    assert_eq!(blocks(&text), ["G0 X0 Y-9", "G1 Z0 F100", "X9", "M2"], "{text}");

    let before_lead_in = "G20 G0 X0 Y-1\nG41 D1\nG1 Z0 F10\nX0 Y0\nX1\nG40 Y1\nM2\n";
    let text = write(&path_of(before_lead_in)).text;
    let expected = ["G0 X0 Y-25.4", "G1 Z0 F254", "Y0", "X25.4", "Y25.4", "M2"];
    assert_eq!(blocks(&text), expected, "{text}");
}

#[test]
fn positions_are_stated_again_in_another_coordinate_system() {
    let path = path_of("G54\nG0 X10 Y5\nZ2\nG55\nX10 Y5\nZ2\nG56\nX10 Y9 Z2\nM2\n");
    let text = write(&path).text;
    let expected = ["G54", "G0 X10 Y5", "Z2", "G55", "X10 Y5", "Z2", "G56", "X10 Y9 Z2", "M2"];
    assert_eq!(blocks(&text), expected, "{text}");
}

#[test]
fn a_path_of_a_contour_begins_with_a_rapid_move_to_its_start() {
    let line = Line::new(DVec2::ZERO, DVec2::new(9.0, 0.0)).expect("a line");
    let mut first = feed_move(MoveCurve::Line(line), [0.0; 2]);
    first.origin = Origin::Segment(0);
    first.role = Role::Segment;
    let path = ToolPath { moves: vec![first], ..ToolPath::default() };
    assert_eq!(blocks(&write(&path).text), ["G0 X0 Y0", "G1 X9 F600"], "from zero too");
}

#[test]
fn pieces_apart_are_not_crossed_where_no_height_is_known() {
    let mut path = apart(-2.0);
    path.words = [(0, "M3"), (2, "M8"), (3, "M30")]
        .map(|(before, words)| AuxiliaryWords {
            before,
            words: words.into(),
            reset: None,
            origin: block(1),
        })
        .into();
    let written = write(&path);
    let expected = ["M3", "G0 X0 Y0", "G1 Z-2 F600", "X5", "M8", "M30"];
    assert_eq!(blocks(&written.text), expected, "the moves end before the jump, the words do not");
    let [found] = &written.diagnostics[..] else { panic!("one finding: {written:?}") };
    assert_eq!((found.code, found.severity), ("no-clearance", Severity::Error), "what it says");
    assert_eq!(found.at, Some(DVec2::new(20.0, 0.0)), "where it would go");
    assert!(found.message.contains("from X5 Y0 to X20 Y0"), "{}", found.message);
}

#[test]
fn pieces_apart_are_crossed_at_the_height_given() {
    let at = |clearance| EmitOptions { clearance: Some(clearance), ..EmitOptions::default() };
    let written = emit(&apart(-2.0), &at(3.0));
    let [across, up] = ["X20 Y0", "G0 Z3"];
    let expected = [up, "X0 Y0", "G1 Z-2 F600", "X5", up, across, "G1 Z-2", "X25"];
    assert_eq!(blocks(&written.text), expected, "{written:?}");
    assert!(written.diagnostics.is_empty(), "{written:?}");
    // Straight across, where it is asked for; never down on the way.
    for height in [-2.0, -50.0] {
        let written = emit(&apart(-2.0), &at(height));
        let expected = ["G0 X0 Y0", "G1 Z-2 F600", "X5", "G0 X20 Y0", "G1 X25"];
        assert_eq!(blocks(&written.text), expected, "{height}: {written:?}");
    }
}

#[test]
fn pieces_apart_are_crossed_where_the_program_makes_rapid_moves() {
    // It comes at 8 mm, plunges at 100 mm/min, and cuts two pieces at different depths.
    let mut path = path_of("G0 X0 Y0 Z8\nG1 Z-1 F100\nX5 F600\n");
    let line = Line::new(DVec2::new(20.0, 3.0), DVec2::new(25.0, 3.0)).expect("a line");
    path.moves.push(feed_move(MoveCurve::Line(line), [-3.0; 2]));
    let written = write(&path);
    assert!(written.diagnostics.is_empty(), "{written:?}");
    let text = &written.text;
    let expected = ["X5 F600", "G0 Z8", "X20 Y3", "G1 Z-3 F100", "X25 F600"];
    assert_eq!(blocks(text)[blocks(text).len() - 5..], expected, "{text}");
    // A small controller of its own sees it: nothing below 8 mm between the pieces.
    let crossing = run(text).into_iter().filter(|[x, ..]| (5.001..19.999).contains(x));
    assert!(crossing.clone().count() > 100, "it crosses");
    assert!(crossing.clone().all(|[.., z]| z == 8.0), "{text}");
}

#[test]
fn a_program_whose_rapid_moves_are_no_higher_than_its_cuts_tells_no_height() {
    let mut path = path_of("G0 X1 Y1\nG1 X5 F600\n");
    path.moves.append(&mut apart(0.0).moves);
    let written = write(&path);
    assert_eq!(written.diagnostics[0].code, "no-clearance", "{written:?}");
    assert!(!written.text.contains("X20"), "{}", written.text);
}

/// Two pieces of 5 mm that are 15 mm apart, at one height.
fn apart(z: f64) -> ToolPath {
    let line = |x: f64| Line::new(DVec2::new(x, 0.0), DVec2::new(x + 5.0, 0.0)).expect("a line");
    let piece = |x: f64| {
        let origin = Origin::Segment(0);
        Move { origin, ..feed_move(MoveCurve::Line(line(x)), [z; 2]) }
    };
    ToolPath { moves: [0.0, 20.0].map(piece).to_vec(), ..ToolPath::default() }
}

#[test]
fn a_missing_feed_is_the_one_given_or_reported() {
    let path = path_of("G0 X1 Y1\nG1 X5\nX6\n");
    let written = write(&path);
    assert_eq!(written.diagnostics.len(), 1, "{written:?}");
    assert_eq!(written.diagnostics[0].code, "no-feed", "{written:?}");
    assert_eq!(written.diagnostics[0].origin, Some(block(2)), "{written:?}");
    let given = emit(&path, &EmitOptions { feed: Some(5.0), ..EmitOptions::default() });
    assert_eq!(blocks(&given.text), ["G0 X1 Y1", "G1 X5 F300", "X6"], "{given:?}");
    assert!(given.diagnostics.is_empty(), "{given:?}");
}

#[test]
fn a_full_circle_is_one_block_that_says_where_it_ends() {
    for (sweep, expected) in [(TAU, "G3 X10 Y5 I-5"), (-TAU, "G2 X10 Y5 I-5")] {
        let text = write(&arcs_path(&[arc([10.0, 5.0], [5.0, 5.0], sweep)])).text;
        assert_eq!(blocks(&text), ["G1 X10 Y5 F600", expected], "{text}");
    }
}

#[test]
fn arcs_keep_their_length_however_nearly_full_or_short_they_are() {
    for radius in [6e-4, 0.001, 0.01, 0.5, 10.0, 1000.0] {
        for gap in [1e-9, 1e-7, 1e-5, 4e-5, 6e-5, 1e-4, 1.5e-4, 1e-3, 0.02, 0.5, 1.0] {
            for start_angle in [0.0, 0.3, 1.2, 2.5, 4.0] {
                for sign in [1.0, -1.0] {
                    let start = [
                        1.0 + radius * f64::cos(start_angle),
                        2.0 + radius * f64::sin(start_angle),
                    ];
                    let missing = (gap / radius).min(3.0);
                    for sweep in [missing, TAU - missing, TAU] {
                        let made =
                            Arc::from_sweep(start.into(), DVec2::new(1.0, 2.0), sweep * sign);
                        let Ok(arc) = made else { continue };
                        let path = arcs_path(&[arc]);
                        let text = write(&path).text;
                        let points = run(&text);
                        let approach = arc.start().length();
                        let written = length(&points) - approach;
                        // Rounding moves the start, the end, the centre; 400 chords are 1e-5 short.
                        let slack = 1e-3 + 1.1e-5 * arc.length();
                        assert!(
                            (written - arc.length()).abs() < slack,
                            "r {radius}, gap {gap}, sweep {sweep}: {written} for {}\n{text}",
                            arc.length()
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn a_helix_climbs_evenly_even_when_it_is_split() {
    let nearly = arc([10.0, 0.0], [0.0, 0.0], TAU - 1e-6);
    let moves = vec![
        feed_move(
            MoveCurve::Line(Line::new(DVec2::ZERO, nearly.start()).expect("a line")),
            [0.0; 2],
        ),
        feed_move(MoveCurve::Arc(nearly), [0.0, -3.0]),
    ];
    let text = write(&ToolPath { moves, ..ToolPath::default() }).text;
    assert_eq!(blocks(&text), ["G1 X10 F600", "G3 X-10 Z-1.5 I-10", "X10 Z-3 I10"], "{text}");
}

#[test]
fn cubics_are_followed_within_the_tolerance_without_gaps() {
    // A quarter of an S: curvature changes its sign within.
    let cubic = Cubic::new(
        DVec2::ZERO,
        DVec2::new(20.0, 25.0),
        DVec2::new(10.0, -25.0),
        DVec2::new(30.0, 5.0),
    );
    for tolerance in [0.1, 0.01, 0.001] {
        for parts in [1, 2, 7] {
            let cut = |i: i32| f64::from(i) / f64::from(parts);
            let moves = (0..parts)
                .map(|i| {
                    let mut part = cubic.part(cut(i), cut(i + 1));
                    // Successive moves meet up to rounding.
                    part.points[0] = cubic.point(cut(i)) + DVec2::splat(1e-15 * f64::from(i));
                    part.points[3] = cubic.point(cut(i + 1));
                    feed_move(MoveCurve::Cubic(part), [0.0; 2])
                })
                .collect();
            let path = ToolPath { moves, ..ToolPath::default() };
            let written = emit(&path, &EmitOptions { tolerance, ..EmitOptions::default() });
            let points = run(&written.text);
            for point in &points {
                let distance = cubic.nearest(DVec2::new(point[0], point[1])).distance;
                assert!(distance < tolerance + 2e-4, "{distance} at {point:?}\n{}", written.text);
            }
            let end = points[points.len() - 1];
            assert!((end[0] - 30.0).hypot(end[1] - 5.0) < 1e-9, "it arrives: {end:?}");
            // Curvature changes by about 0.06/mm²; a biarc of h mm deviates by 0.06 h³ / 324, so
            // 38 mm take 21 of them at 1e-3 mm.
            let expected = 42.0 * (0.001 / tolerance).cbrt();
            let count = blocks(&written.text).len();
            assert!((count as f64) < 1.3 * expected + 2.0, "{count} blocks\n{}", written.text);
        }
    }
}

#[test]
fn a_climbing_cubic_climbs_evenly() {
    let cubic =
        Cubic::new(DVec2::ZERO, DVec2::new(9.0, 9.0), DVec2::new(20.0, 9.0), DVec2::new(30.0, 0.0));
    let moves = vec![feed_move(MoveCurve::Cubic(cubic), [0.0, 6.0])];
    let points = run(&write(&ToolPath { moves, ..ToolPath::default() }).text);
    let total = cubic.length();
    let mut done = 0.0;
    for pair in points.windows(2) {
        done += (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
        assert!((pair[1][2] - 6.0 * done / total).abs() < 0.01, "{pair:?} after {done} mm");
    }
    assert!((points[points.len() - 1][2] - 6.0).abs() < 1e-9, "the top is reached");
}

#[test]
fn words_after_the_last_move_are_written() {
    let words = AuxiliaryWords { before: 0, words: "M30".into(), reset: None, origin: block(1) };
    let path = ToolPath { words: vec![words], ..ToolPath::default() };
    assert_eq!(blocks(&write(&path).text), ["M30"], "a path of words alone");
}
