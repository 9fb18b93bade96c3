//! Blocks and words to moves and contours.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::compensation::Options;
use g41::contour::{EventKind, MoveCurve, Role, Side};
use g41::diagnostic::Origin;
use g41::geometry::Curve;
use g41::program::{Item, RadiusSource};
use g41::simulation::{Tools, compensate_program};
use glam::DVec2;

use super::sample::{
    ERROR, INFO, WARNING, found, moves, near, only_contour, read, read_clean, words,
};

#[test]
fn modes_last_until_another_word_of_their_group() {
    let read = read_clean("G90 G1 X10 F600\nY5\nG0 X0\nG91\nX-2\nG1 Y1\n");
    let moves = moves(&read);
    let ends: Vec<_> = moves.iter().map(|m| m.curve.end().to_array()).collect();
    assert_eq!(ends, [[10.0, 0.0], [10.0, 5.0], [0.0, 5.0], [-2.0, 5.0], [-2.0, 6.0]], "ends");
    let feeds: Vec<_> = moves.iter().map(|m| m.feed).collect();
    assert_eq!(feeds, [Some(10.0), Some(10.0), None, None, Some(10.0)], "feeds in mm/s");
    let rapid: Vec<_> = moves.iter().map(|m| m.rapid).collect();
    assert_eq!(rapid, [false, false, true, true, false], "rapid moves");
}

#[test]
fn inches_are_read_as_millimetres() {
    let read = read_clean("G20 G1 X1 Y-0.5 F60\nG2 X2 I.5\nG21 G1 X2 Y0\n");
    let moves = moves(&read);
    assert!(near(moves[0].curve.end(), [25.4, -12.7]), "{moves:?}");
    assert_eq!(moves[0].feed, Some(25.4), "60 inch/min are 25.4 mm/s");
    let MoveCurve::Arc(arc) = moves[1].curve else { panic!("{moves:?}") };
    assert!(near(arc.center(), [38.1, -12.7]), "{arc:?}");
    assert!(near(moves[2].curve.end(), [2.0, 0.0]), "{moves:?}");
}

#[test]
fn an_arc_has_its_centre_relative_to_its_start_or_by_g90_1_absolute() {
    for text in [
        "G0 X10 Y20\nG3 X5 Y25 I-5 J0 F100",
        "G90.1\nG0 X10 Y20\nG3 X5 Y25 I5 J20 F100",
        "G0 X10 Y20\nG3 X5 Y25 R5 F100",
        "G0 X10 Y20\nG91 G3 X-5 Y5 I-5 F100",
    ] {
        let read = read_clean(text);
        let MoveCurve::Arc(arc) = moves(&read)[1].curve else { panic!("{text}") };
        assert!(near(arc.center(), [5.0, 20.0]), "{text}: {arc:?}");
        assert!((arc.sweep() - std::f64::consts::FRAC_PI_2).abs() < 1e-9, "{text}: {arc:?}");
    }
}

#[test]
fn a_negative_radius_is_the_larger_arc() {
    let read = read_clean("G0 X0 Y10\nG2 X10 Y0 R-10 F100");
    let MoveCurve::Arc(arc) = moves(&read)[1].curve else { panic!("{read:?}") };
    // The circle through (0, 10) and (10, 0) whose larger clockwise arc turns about (10, 10).
    assert!(near(arc.center(), [10.0, 10.0]), "{arc:?}");
    assert!((arc.sweep() + 1.5 * std::f64::consts::PI).abs() < 1e-9, "{arc:?}");
}

#[test]
fn an_arc_that_ends_where_it_starts_is_a_full_circle() {
    for text in ["G0 X10 Y0\nG2 I-10 F100", "G0 X10 Y0\nG2 X10 Y0 I-10 J0 F100"] {
        let read = read_clean(text);
        let MoveCurve::Arc(arc) = moves(&read)[1].curve else { panic!("{text}") };
        assert!(arc.is_full_circle() && arc.is_clockwise(), "{text}: {arc:?}");
    }
}

#[test]
fn an_arc_with_z_is_a_helix() {
    let read = read_clean("G0 X10 Y0 Z1\nG3 X10 Y0 Z-2 I-10 F100");
    let helix = moves(&read)[1];
    assert_eq!(helix.heights, [1.0, -2.0], "{helix:?}");
}

#[test]
fn each_piece_of_a_free_spline_knows_its_block() {
    let read = read_clean("G1 X0 Y0 F100\nG5 X10 Y5\nX20 Y0\n(here)\nX30 Y5\nG1 X40\n");
    let lines: Vec<u32> = moves(&read)
        .iter()
        .map(|m| if let Origin::Block { line, .. } = m.origin { line } else { 0 })
        .collect();
    assert_eq!(lines, [2, 3, 5, 6], "{read:?}");
    let text = "G41 D1 G1 X0 Y0 F9\nG5 X9 Y5\nX20 Y0\nX30 Y5\nM30\n";
    let read = super::sample::read(&format!("G0 X-9 Y0\n{text}"));
    assert_eq!(only_contour(&read).blocks, [2, 5], "the contour reaches to the spline's last");
}

#[test]
fn each_piece_of_a_compensated_spline_knows_its_block() {
    let text = "G0 X-9 Y0\nG41 D1 G1 X0 Y0 F9\nG5 X9 Y5\nX20 Y0\nX30 Y5\nG1 X40\n\
                G5 X50 Y9\nX60 Y5\nG40 G1 X80\nM30\n";
    let read = read_clean(text);
    for radius in [0.0, 0.5] {
        let path = compensate_program(&read, &Tools::all(radius), &Options::default());
        let along = path.moves.iter().filter(|m| m.role == Role::Segment);
        let mut lines: Vec<(u32, f64)> = along
            .map(|m| {
                let Origin::Block { line, .. } = m.origin else { panic!("a block") };
                (line, m.curve.end().x)
            })
            .collect();
        // The last move of each block ends beside the block's point.
        lines.reverse();
        lines.dedup_by_key(|(line, _)| *line);
        lines.reverse();
        assert_eq!(lines.iter().map(|l| l.0).collect::<Vec<_>>(), [3, 4, 5, 6, 7, 8], "{radius}");
        for ((_, x), expected) in lines.iter().zip([9.0, 20.0, 30.0, 40.0, 50.0, 60.0]) {
            assert!((x - expected).abs() < 0.51, "{lines:?}");
        }
    }
}

#[test]
fn a_move_along_z_alone_is_vertical() {
    let read = read_clean("G0 X3 Y4 Z5\nG1 Z-1 F60");
    let plunge = moves(&read)[1];
    assert_eq!(plunge.curve, MoveCurve::Vertical(DVec2::new(3.0, 4.0)), "where");
    assert_eq!((plunge.heights, plunge.feed), ([5.0, -1.0], Some(1.0)), "how");
}

#[test]
fn words_that_move_nothing_stay_in_their_place() {
    let read = read_clean(
        "%\nO1234 (LID)\nT2 M6\nS12000 M3\nG4 X1.5\nG54\nG0 X1. M8 (first)\nX2. M0\n; end\nM30\n%\n",
    );
    let seen: Vec<String> = read
        .items
        .iter()
        .map(|item| match item {
            Item::Free(found) => format!("to {}", found.curve.end().x),
            Item::Words { words, .. } => words.clone(),
            Item::Contour(_) => "contour".into(),
        })
        .collect();
    let expected = [
        "(O1234) (LID)",
        "T2 M6",
        "S12000 M3",
        "G4 P1.5",
        "G54",
        "M8 (first)",
        "to 1",
        "to 2",
        "M0",
        "; end",
        "M30",
    ];
    assert_eq!(seen, expected, "in the order of RS274/NGC");
}

#[test]
fn coordinates_that_are_assumed_are_passed_on_where_they_are_first_stated() {
    assert_eq!(words(&read_clean("G0 X0 Y0\nG1 X5 F100")), ["G0 X0 Y0"], "nothing moves");
    for (text, states) in [
        ("G0 X0 Y0 Z5", [true, true, false]),
        ("G0 X5 Y5 Z5\nG54\nG0 X5 Z0", [true, false, false]),
        ("G0 X5 Y5 Z5\nG28 Z9\nG0 X5 Y8 Z5", [false, false, true]),
    ] {
        let read = read_clean(text);
        let reset = read.items.iter().rev().find_map(|item| match item {
            Item::Words { reset, .. } => *reset,
            _ => None,
        });
        assert_eq!(reset.expect("the move is to state them").states, states, "{text}");
    }
    assert_eq!(words(&read_clean("G0 Z5\nX3 Y4")), Vec::<&str>::new(), "the move says it");
}

#[test]
fn a_contour_lies_between_its_lead_in_and_lead_out() {
    let read = read_clean(
        "N10 G0 X-20 Y-10\nN20 G41 D3 G1 X0 Y0 F600\nN30 X50\nN40 G3 X60 Y10 J10 I0\nN50 G1 Y40\n\
         N60 G40 X80 Y50\nN70 G0 X0\n",
    );
    let programmed = only_contour(&read);
    assert_eq!((programmed.side, programmed.radius), (Side::Left, RadiusSource::Tool(3)), "whose");
    assert_eq!(programmed.blocks, [2, 6], "lines");
    let contour = &programmed.contour;
    assert!(near(contour.lead_in().expect("it has one").point, [-20.0, -10.0]), "lead-in");
    assert!(near(contour.lead_out().expect("it has one").point, [80.0, 50.0]), "lead-out");
    assert_eq!(contour.segments().len(), 3, "segments");
    assert!(near(contour.start(), [0.0, 0.0]) && near(contour.end(), [60.0, 40.0]), "ends");
    let origin = Origin::Block { line: 4, number: Some(40), column: None };
    assert_eq!(contour.segments()[1].attributes.origin, origin, "where the arc comes from");
    assert_eq!(moves(&read).len(), 2, "a move before and one after");
}

#[test]
fn compensation_waits_for_its_first_straight_move() {
    let read = read_clean("G0 X-9 Y0\nG42 D1\nG0 Z1\nG1 Z-2 F60\nX0 Y0\nX9\nG40\nG0 Z5\nX0 Y9\n");
    let contour = &only_contour(&read).contour;
    assert_eq!(moves(&read).iter().filter(|m| m.curve.length() == 0.0).count(), 2, "free z moves");
    assert_eq!(contour.events().len(), 1, "the retract is in the contour");
    assert!(near(contour.lead_out().expect("it has one").point, [0.0, 9.0]), "lead-out");
}

#[test]
fn the_radius_is_that_of_the_d_word_or_the_active_tool_or_given() {
    let radius = |switch: &str| {
        let text = format!("G0 X0 Y-9\n{switch}\nG1 X0 Y0 F100\nX9\nG40 Y-9\n");
        let read = read(&text);
        only_contour(&read).radius
    };
    assert_eq!(radius("T4 M6\nG41 D7"), RadiusSource::Tool(7), "D");
    assert_eq!(radius("T4 M6\nT5\nG41"), RadiusSource::Tool(4), "the tool in the spindle");
    assert_eq!(radius("T4\nG41"), RadiusSource::Tool(4), "a program without M6");
    assert_eq!(radius("T4 M6\nM6 T5\nG41"), RadiusSource::Tool(5), "T acts before M6");
    assert_eq!(radius("D6\nG41"), RadiusSource::Tool(6), "D in a block before");
    assert_eq!(radius("G41\nD6"), RadiusSource::Tool(6), "D in a block after, before the lead-in");
    assert_eq!(radius("G41 D5\nD6"), RadiusSource::Tool(6), "the later D");
    assert_eq!(radius("G40 D6\nG41"), RadiusSource::Tool(6), "D beside G40");
    assert_eq!(radius("D6 T2 M6\nT1\nG41"), RadiusSource::Tool(6), "D after the tool change");
    assert_eq!(radius("G41.1 D5"), RadiusSource::Given(2.5), "a diameter");
    assert_eq!(radius("G20 G42.1 D.25"), RadiusSource::Given(3.175), "a diameter in inches");
    assert_eq!(radius("G41"), RadiusSource::Tool(0), "nothing");
}

#[test]
fn words_and_moves_along_z_between_segments_are_events_of_the_contour() {
    let read = read_clean("G0 X0 Y-9\nG41 D1 G1 Y0 F100\nX9\nM8 (coolant)\nG1 Z-2\nX20\nG40 Y-9\n");
    let events = only_contour(&read).contour.events();
    assert_eq!(events.len(), 2, "{events:?}");
    assert_eq!(events[0].kind, EventKind::Words("M8 (coolant)".into()), "words");
    assert!(
        matches!(events[1].kind, EventKind::Vertical(a) if a.heights == [0.0, -2.0]),
        "{events:?}"
    );
    assert!(events.iter().all(|event| event.before == 1), "{events:?}");
}

#[test]
fn type_points_are_a_spline_from_the_current_point_on() {
    for text in [
        "G1 X10 Y0 F100\nG05 X20 Y5\nX30 Y0\nX40 Y-5\nG01 X50\n",
        "G1 X10 Y0 F100\nG05 X20 Y5\nG05 X30 Y0\nG05 X40 Y-5\nG01 X50\n",
        "G1 X10 Y0 F100\nG05\nX20 Y5\n(a comment)\nX30 Y0\nX40 Y-5\nG01 X50\n",
        "G1 X10 Y0 F100\nG05 X10 Y0\nX20 Y5\nX30 Y0\nX40 Y-5\nG01 X50\n",
        "G1 X10 Y0 F100\nG91 G05 X10 Y5\nX10 Y-5\nX10 Y-5\nG01 X10\n",
    ] {
        let text = format!("G41 D1 G1 X-10 Y0 F100\n{text}G40 Y30\n");
        let read = read_clean(&text);
        let segments = only_contour(&read).contour.segments();
        let Curve::Spline(spline) = &segments[1].curve else { panic!("{text}: {segments:?}") };
        let points: Vec<_> = spline.points().iter().map(DVec2::to_array).collect();
        assert_eq!(points, [[10.0, 0.0], [20.0, 5.0], [30.0, 0.0], [40.0, -5.0]], "{text}");
        assert_eq!(segments.len(), 3, "{text}");
    }
}

#[test]
fn a_repeated_type_point_is_a_corner_between_two_splines() {
    let read = read_clean(
        "G41 D1 G1 X0 Y0.5 F100\nX0 Y0\nG05 X5 Y5\nX10 Y0\nX10 Y0\nX15 Y5\nX20 Y0\nG40 G1 X30\n",
    );
    let segments = only_contour(&read).contour.segments();
    let splines: Vec<usize> = segments
        .iter()
        .filter_map(|s| if let Curve::Spline(s) = &s.curve { Some(s.points().len()) } else { None })
        .collect();
    assert_eq!(splines, [3, 3], "type points of each");
}

#[test]
fn a_feed_that_changes_within_a_spline_is_reported_once() {
    let read = read("G0 X0 Y0\nG5 X5 Y5 F300\nX10 Y0 F200\nX15 Y5\nX20 Y0\n");
    assert_eq!(found(&read), [("feed-in-spline", WARNING, 3, Some(1))], "one change");
    read_clean("G0 X0 Y0\nG5 X5 Y5 F300\nX10 Y0\nX10 Y0\nX15 Y5 F200\nX20 Y0\n");
}

#[test]
fn words_after_the_last_type_point_stay_behind_the_spline() {
    let order = |text: &str| -> Vec<String> {
        let item = |item: &Item| match item {
            Item::Words { words, .. } => words.clone(),
            _ => "move".into(),
        };
        let mut order: Vec<_> = read(text).items.iter().map(item).collect();
        order.dedup();
        order
    };
    let spline = "F60\nG5 X5 Y5\nX10 Y0 M8\n";
    let end = "X15 Y5\nM5 (DONE)\n";
    for last in ["G0 Z5\nM30\n", "M30\n", ""] {
        let text = format!("{spline}{end}{last}");
        assert_eq!(order(&text)[..3], ["M8", "move", "M5 (DONE)"], "{text}");
        assert_eq!(found(&read(&text)), [("words-in-spline", WARNING, 3, None)], "M8: {text}");
    }
    let corner = format!("{spline}X15 Y5\nM9\nX15 Y5\nX20 Y0\nX25 Y5\n");
    assert_eq!(order(&corner), ["M8", "move", "M9", "move"], "between two splines");
}

#[test]
fn free_type_points_are_cubics() {
    let read = read_clean("G0 X10 Y0\nG05 X20 Y5 F100\nX30 Y0\nX40 Y-5\n");
    let moves = moves(&read);
    assert_eq!(moves.len(), 4, "{moves:?}");
    assert!(moves[1..].iter().all(|m| matches!(m.curve, MoveCurve::Cubic(_))), "{moves:?}");
}

#[test]
fn a_spline_of_two_points_is_reported() {
    let read = read("G0 X10 Y0\nG05 X20 Y5 F100\nG01 X30\n");
    assert_eq!(found(&read), [("too-few-points", ERROR, 2, Some(1))], "the spline");
}

#[test]
fn the_family_of_g05_is_told_apart() {
    for (block, code, severity, says) in [
        ("G05 P10000", "noted", INFO, "high-speed"),
        ("G5 X20 Y5 P3", "not-supported", ERROR, "neither"),
        ("G05.1 Q1", "noted", INFO, "contour control"),
        ("G05.1 Q2 X0 Y0", "left-out", WARNING, "smooth interpolation"),
        ("G5.3", "nurbs-not-open", ERROR, "without G05.2"),
    ] {
        let read = read(&format!("G0 X10 Y0\n{block}\nG1 X30 F100\n"));
        assert_eq!(found(&read).len(), 1, "{block}: {:?}", read.diagnostics);
        let (seen, how, line, _) = found(&read)[0];
        assert_eq!((seen, how, line), (code, severity, 2), "{block}");
        assert!(read.diagnostics[0].message.contains(says), "{}", read.diagnostics[0]);
        let ends: Vec<_> = moves(&read).iter().map(|m| m.curve.end().x).collect();
        assert_eq!(ends, [10.0, 30.0], "{block}: nothing of it is misread as a move");
    }
}
