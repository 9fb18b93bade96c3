//! Roundings and chamfers that programs ask for: `,R` and `,C` of FANUC, RND, RNDM, CHF, CHR, FRC and
//! FRCM of SINUMERIK.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

use g41::contour::{EventKind, MoveCurve};
use g41::geometry::{Curve, rotate};
use g41::program::{Dialect, Interpretation, Item, Program, Rules, interpret};
use glam::DVec2;

use super::sample::{codes, contours, moves, only_contour, words};
use crate::common::{near, near_point, p};

fn read_as(text: &str, dialect: Dialect) -> Interpretation {
    interpret(&Program::parse(text, dialect), Rules::default())
}

/// Reads a program with nothing to be found fault with.
#[track_caller]
fn clean(text: &str, dialect: Dialect) -> Interpretation {
    let read = read_as(text, dialect);
    assert!(read.diagnostics.is_empty(), "{text}\n{:?}", read.diagnostics);
    read
}

/// Asserts where the moves end, that they follow each other, and which are arcs of which radius.
#[track_caller]
fn assert_moves(read: &Interpretation, expected: &[(DVec2, f64)]) {
    let moves = moves(read);
    let got: Vec<_> = moves.iter().map(|step| step.curve.end()).collect();
    assert_eq!(got.len(), expected.len(), "{got:?}");
    for (i, (step, (end, radius))) in moves.iter().zip(expected).enumerate() {
        near_point(step.curve.end(), *end, 1e-9, &format!("end of move {i} of {got:?}"));
        if i > 0 {
            near_point(step.curve.start(), expected[i - 1].0, 1e-9, "in one piece");
        }
        let found = match step.curve {
            MoveCurve::Arc(arc) => arc.radius() * arc.sweep().signum(),
            _ => 0.0,
        };
        near(found, *radius, 1e-9, &format!("radius of move {i}, negative where clockwise"));
    }
}

fn line(x: f64, y: f64) -> (DVec2, f64) {
    (p(x, y), 0.0)
}

fn arc(x: f64, y: f64, radius: f64) -> (DVec2, f64) {
    (p(x, y), radius)
}

/// The example of FANUC's manuals for machining centres, as far as lines alone are concerned.
#[test]
fn fanuc_rounds_and_chamfers_corners_of_lines() {
    let text = "G92 G90 X0 Y0\nG00 X10. Y10.\nG01 X50. F10. ,C5.\nY25. ,R8.\nX10. ,C5.\nY10.\n";
    assert_moves(
        &clean(text, Dialect::Fanuc),
        &[
            line(10.0, 10.0),
            line(45.0, 10.0),
            line(50.0, 15.0),
            line(50.0, 17.0),
            arc(42.0, 25.0, 8.0),
            line(15.0, 25.0),
            line(10.0, 20.0),
            line(10.0, 10.0),
        ],
    );
}

#[test]
fn fanuc_rounds_between_lines_and_arcs() {
    // Blocks N004 to N007 of the same example: up, G03 of 30 to (80, 50), back along −x, up. The
    // centres of the roundings lie 8 mm beside both, on the side to which the way turns.
    let text = "G90 G17 G00 X50. Y10.\nG01 Y25. F10. ,R8.\nG03 X80. Y50. R30. ,R8.\n\
                G01 X50. ,R8.\nY70.\n";
    let read = clean(text, Dialect::Fanuc);
    let moves = moves(&read);
    assert_eq!(moves.len(), 8, "{moves:?}");
    // The centre of G03: on the left of its chord.
    let (start, end) = (p(50.0, 25.0), p(80.0, 50.0));
    let half = 0.5 * start.distance(end);
    let left = rotate(end - start, FRAC_PI_2).normalize();
    let center = start.midpoint(end) + left * (900.0 - half * half).sqrt();
    let radius = |i: usize| match moves[i].curve {
        MoveCurve::Arc(arc) => (arc.center(), arc.radius()),
        other => panic!("move {i} is no arc: {other:?}"),
    };
    // From up the way turns right into the arc, whose centre is on its left: 8 mm outside it. At
    // its end it turns left, to the side of the centre.
    for (i, beside, across) in [(2, p(58.0, 0.0), 38.0), (4, p(0.0, 58.0), 22.0)] {
        let (at, r) = radius(i);
        near(r, 8.0, 1e-9, "radius");
        near(at.distance(center), across, 1e-9, "from the centre of G03");
        let off = if i == 2 { at.x - beside.x } else { at.y - (50.0 - 8.0) };
        near(off, 0.0, 1e-9, "from the line");
    }
    near(radius(3).1, 30.0, 1e-9, "G03 itself");
    near_point(radius(3).0, center, 1e-9, "about its centre");
    for pair in moves.windows(2) {
        near_point(pair[0].curve.end(), pair[1].curve.start(), 1e-9, "in one piece");
        if matches!(pair[1].curve, MoveCurve::Arc(_)) || matches!(pair[0].curve, MoveCurve::Arc(_))
        {
            let (before, after) = (tangent(&pair[0].curve, 1.0), tangent(&pair[1].curve, 0.0));
            near_point(before, after, 1e-7, "tangent");
        }
    }
}

fn tangent(curve: &MoveCurve, t: f64) -> DVec2 {
    match curve {
        MoveCurve::Line(line) => line.tangent(),
        MoveCurve::Arc(arc) => arc.tangent(t),
        other => panic!("{other:?}"),
    }
}

#[test]
fn legs_at_an_arc_are_chords_as_nct_has_it() {
    // The examples of NCT's manual: two lines; and line, line, arc, line with a rounding outside.
    let text = "G0 X0 Y0\nG91 G1 X30 ,C10 F100\nX10 Y40\n";
    let to = p(10.0, 40.0) * (10.0 / 1700.0_f64.sqrt());
    assert_moves(
        &clean(text, Dialect::Fanuc),
        &[line(20.0, 0.0), line(30.0 + to.x, to.y), line(40.0, 40.0)],
    );
    let text = "G0 X100 Y0\nG1 Y40 ,C10 F100\nX60 ,R22\nG3 X20 Y80 R40 ,C10\nG1 Y110\n";
    // The rounding lies 22 mm above y = 40, 62 mm from (20, 40).
    let center = p(20.0 + 3360.0_f64.sqrt(), 62.0);
    let touches = p(20.0, 40.0) + (center - p(20.0, 40.0)) * (40.0 / 62.0);
    let angle = 2.0 * 0.125_f64.asin();
    assert_moves(
        &clean(text, Dialect::Fanuc),
        &[
            line(100.0, 0.0),
            line(100.0, 30.0),
            line(90.0, 40.0),
            line(center.x, 40.0),
            arc(touches.x, touches.y, -22.0),
            arc(20.0 + 40.0 * angle.sin(), 40.0 + 40.0 * angle.cos(), 40.0),
            line(20.0, 90.0),
            line(20.0, 110.0),
        ],
    );
}

#[test]
fn sinumerik_measures_chamfers_along_themselves_or_their_legs() {
    // CHF is 2 CHR cos α with α half the turn, as the manual of the 840D has it.
    let h = FRAC_1_SQRT_2;
    for word in ["CHR=2".to_string(), format!("CHF={}", 4.0 * h)] {
        let text = format!("R1=0\nG0 X0 Y0\nG1 X20 F100 {word}\nY20 RND=3\nX0\n");
        assert_moves(
            &clean(&text, Dialect::Auto),
            &[
                line(18.0, 0.0),
                line(20.0, 2.0),
                line(20.0, 17.0),
                arc(17.0, 20.0, 3.0),
                line(0.0, 20.0),
            ],
        );
    }
    let both = clean("G0 X5 Y5\nG1 X20 F100 CHR=2 RND=1\nY20\n", Dialect::Sinumerik);
    assert_moves(&both, &[line(5.0, 5.0), line(19.0, 5.0), arc(20.0, 6.0, 1.0), line(20.0, 20.0)]);
}

#[test]
fn sinumerik_rounds_every_corner_from_rndm_to_rndm_0() {
    let text = "G0 X5 Y5\nG1 X20 F100 RNDM=2\nY20\nX10 RNDM=0\nY30\nG0 X0\n";
    assert_moves(
        &clean(text, Dialect::Sinumerik),
        &[
            line(5.0, 5.0),
            line(18.0, 5.0),
            arc(20.0, 7.0, 2.0),
            line(20.0, 18.0),
            arc(18.0, 20.0, 2.0),
            line(10.0, 20.0),
            line(10.0, 30.0),
            line(0.0, 30.0),
        ],
    );
    // It is for all corners; those that cannot be are no fault.
    let text = "RNDM=2\nG0 X5 Y5\nG1 X20 F100\nZ-1\nX30\nG0 Z5\nG1 Y20\n";
    assert_eq!(moves(&clean(text, Dialect::Sinumerik)).len(), 6, "as they are programmed");
}

#[test]
fn sinumerik_has_a_feed_for_corners() {
    let feeds = |text: &str| -> Vec<f64> {
        let moves = moves(&clean(text, Dialect::Sinumerik));
        moves.iter().map(|step| step.feed.unwrap_or(0.0) * 60.0).map(f64::round).collect()
    };
    let text = "G0 X5 Y5\nG1 X20 F600 RND=2 FRC=120\nY20 F300 RND=2\nX0\n";
    assert_eq!(feeds(text), [0.0, 600.0, 120.0, 300.0, 300.0, 300.0], "FRC is for one corner");
    let text = "G0 X5 Y5\nG1 X20 F600 RND=2\nY20 F300 CHR=2 FRCM=60\nX0 RND=1\nY0 FRCM=0\n";
    assert_eq!(
        feeds(text),
        [0.0, 600.0, 300.0, 300.0, 60.0, 300.0, 60.0, 300.0],
        "without, that of the move away from the corner; FRCM from its block on"
    );
    let text = "G0 X5 Y5\nS600 M3 G95 F0.5\nG1 X20 CHR=2 FRC=0.1\nY20\n";
    assert_eq!(feeds(text), [0.0, 300.0, 60.0, 300.0], "in one turn under G95");
    let fanuc = clean("G0 X5 Y5\nG1 X20 F600 ,R2\nY20 F300\n", Dialect::Fanuc);
    assert_eq!(moves(&fanuc)[2].feed, Some(10.0), "FANUC: that of the first move");
}

#[test]
fn times_of_moves_go_down_with_their_lengths() {
    // 10 mm in 6 s each: what is left of both goes on at that speed, and so does the chamfer.
    let read = clean("G0 X0 Y0.5\nG93 G1 X10. F10 ,C4\nY10.5 F10\n", Dialect::Fanuc);
    for step in &moves(&read)[1..] {
        near(step.feed.unwrap_or(0.0), 10.0 / 6.0, 1e-9, "feed");
    }
}

#[test]
fn the_rounded_contour_is_what_is_compensated() {
    let text = "G0 X0 Y-20\nG41 D1 G1 X0 Y0 F100\nY30 ,R5\nX30 ,C4\nY0\nG40 X30 Y-20\nM30\n";
    let read = clean(text, Dialect::Fanuc);
    let contour = &only_contour(&read).contour;
    let ends: Vec<_> = contour.segments().iter().map(|s| s.curve.end()).collect();
    let expected = [p(0.0, 25.0), p(5.0, 30.0), p(26.0, 30.0), p(30.0, 26.0), p(30.0, 0.0)];
    assert_eq!(ends.len(), expected.len(), "{ends:?}");
    for (end, expected) in ends.iter().zip(expected) {
        near_point(*end, expected, 1e-9, "end of a segment");
    }
    let Curve::Arc(arc) = &contour.segments()[1].curve else { panic!("{contour:?}") };
    near_point(arc.center(), p(5.0, 25.0), 1e-9, "its centre");
    assert!(arc.is_clockwise(), "to the right");
    assert_eq!(contour.lead_out().map(|lead| lead.point), Some(p(30.0, -20.0)), "lead-out");
}

#[test]
fn corners_at_leads_are_cut_too() {
    let text = "G0 X-20 Y0\nG41 D1 G1 X0 Y0 F100 ,R3\nY-30 ,R4\nG40 X-20 ,R1\nY0\nM30\n";
    let read = read_as(text, Dialect::Fanuc);
    let found: Vec<_> = read.diagnostics.iter().map(|found| found.code).collect();
    assert_eq!(found, ["corner-left"], "compensation has ended at the last corner");
    let contour = &only_contour(&read).contour;
    near_point(contour.start(), p(-3.0, 0.0), 1e-9, "the lead-in ends before the corner");
    let ends: Vec<_> = contour.segments().iter().map(|s| s.curve.end()).collect();
    for (end, expected) in ends.iter().zip([p(0.0, -3.0), p(0.0, -26.0), p(-4.0, -30.0)]) {
        near_point(*end, expected, 1e-9, "end of a segment");
    }
    assert_eq!(ends.len(), 3, "{ends:?}");
    // FANUC's control stops there with an alarm.
    let rules = Rules { words: g41::program::ControlWords::Fanuc, ..Rules::default() };
    let read = interpret(&Program::parse(text, Dialect::Fanuc), rules);
    let found: Vec<_> = read.diagnostics.iter().map(|found| found.code).collect();
    assert_eq!(found, ["corner-left"; 3], "the start, the end, and behind");
    assert_eq!(contours(&read)[0].contour.segments().len(), 1, "as programmed");
}

#[test]
fn words_between_both_moves_come_behind_the_element() {
    let text = "G0 X5 Y5\nG1 X20 F100 RND=2\nM8\nG4 F1\n; here\nY20\n";
    let read = clean(text, Dialect::Sinumerik);
    let order: Vec<_> = read.items.iter().map(|item| matches!(item, Item::Free(_))).collect();
    let moves_before = order.iter().take_while(|is_move| **is_move).count();
    assert_eq!(moves_before, 3, "two moves and the rounding: {:?}", read.items);
    assert_eq!(words(&read).len(), 3, "M8, the dwell and the comment");
    let text = "G0 X-9 Y0\nG41 D1 G1 X0 F100\nX20 RND=2\nM8\nY20\nG40 X30\nM30\n";
    let read = clean(text, Dialect::Sinumerik);
    let events = contours(&read)[0].contour.events();
    let m8 = events.iter().find(|event| event.kind == EventKind::Words("M8".into()));
    assert_eq!(m8.map(|event| event.before), Some(2), "before the third segment: {events:?}");
    let read = clean("G0 X5 Y5\nG1 X20 F100 ,R2\n(HERE)\nG4 P1\nY20\n", Dialect::Fanuc);
    assert_eq!(moves(&read).len(), 4, "FANUC lets a dwell and comments pass");
}

#[test]
fn a_corner_that_cannot_be_stays_and_is_told_with_its_place() {
    let start = "G21 G90 G17 G0 X5 Y5\n";
    for (text, dialect, code) in [
        ("G1 X20 F100 ,R16\nY20\n", Dialect::Fanuc, "corner-left"),
        ("G1 X20 F100 ,R2\nM30\n", Dialect::Fanuc, "corner-left"),
        ("G1 X20 F100 ,R2\nM8\nY20\n", Dialect::Fanuc, "corner-left"),
        ("G1 X20 F100 ,R2\nZ-1\nY20\n", Dialect::Fanuc, "corner-left"),
        ("G1 X20 F100 ,R2\nX30 Y20 Z-1\n", Dialect::Fanuc, "corner-left"),
        ("G1 X20 F100 ,R2\nG0 Y20\n", Dialect::Fanuc, "corner-left"),
        ("G0 X20 ,R2\nG1 Y20 F100\n", Dialect::Fanuc, "corner-left"),
        ("G1 Z-5 F100 ,R2\nG1 Y20 F100\n", Dialect::Fanuc, "corner-left"),
        ("G1 X20 F100 ,C2\nG28 Z0\nG1 Y20\n", Dialect::Fanuc, "corner-left"),
        ("G1 X20 F100 ,C2\nG18 G1 Z20\n", Dialect::Fanuc, "corner-left"),
        ("G1 X20 F100 ,C2\nX5\n", Dialect::Fanuc, "corner-left"),
        ("G1 X20 F100 ,C2 ,R1\nY20\n", Dialect::Fanuc, "bad-corner"),
        ("G1 X20 F100 ,C-2\nY20\n", Dialect::Fanuc, "bad-corner"),
        ("G1 X20 F100 ,A30\nY20\n", Dialect::Fanuc, "word-not-understood"),
        ("G1 X20 F100 RND=16\nY20\n", Dialect::Sinumerik, "corner-reduced"),
        ("G1 X20 F100 RND=2\nM8\nM9\nM8\nM9\nY20\n", Dialect::Sinumerik, "corner-left"),
        ("G1 X20 F100 CHF=2\nG0 Z5\nG1 Y20\n", Dialect::Sinumerik, "corner-left"),
    ] {
        let text = format!("{start}{text}");
        let read = read_as(&text, dialect);
        let told = read.diagnostics.iter().find(|found| found.code == code);
        let place = told.and_then(|found| found.origin);
        assert!(
            matches!(place, Some(g41::diagnostic::Origin::Block { line: 2, column: Some(_), .. })),
            "{text}{:?}",
            read.diagnostics
        );
        assert_eq!(read.diagnostics.len(), 1, "{text}{:?}", read.diagnostics);
    }
    let scaled = codes("G0 X5. Y5.\nG51 X0 Y0 I2. J3.\nG1 X20. F100 ,C2\nY20.\n", Dialect::Fanuc);
    assert_eq!(scaled, ["corner-left"], "unevenly scaled it is another curve");
    assert!(
        codes("G1 X20 F100 ,R2\nY20\n", Dialect::LinuxCnc).contains(&"unexpected-character"),
        "LinuxCNC has no such words"
    );
}

#[test]
fn sinumerik_makes_smaller_what_does_not_fit() {
    let read = read_as("G0 X5 Y5\nG1 X20 F100 RND=30\nY15\nX0\n", Dialect::Sinumerik);
    let made = moves(&read);
    let MoveCurve::Arc(arc) = made[2].curve else { panic!("{made:?}") };
    near(arc.radius(), 10.0, 1e-4, "all of the shorter move");
    assert!(read.diagnostics[0].message.contains("10"), "{:?}", read.diagnostics);
    // Two roundings on one move: the first comes first.
    let read = read_as("G0 X5 Y5\nG1 X20 F100 RND=8\nY15 RND=8\nX0\n", Dialect::Sinumerik);
    let radii: Vec<f64> = moves(&read)
        .iter()
        .filter_map(
            |step| if let MoveCurve::Arc(arc) = step.curve { Some(arc.radius()) } else { None },
        )
        .collect();
    near(radii[0], 8.0, 1e-9, "as programmed");
    near(radii[1], 2.0, 1e-4, "what was left");
    let found = codes("G0 X5 Y5\nG1 X20 F100 RND=30\nY15 CHF=4\nX0\n", Dialect::Sinumerik);
    assert_eq!(found, ["corner-reduced", "corner-left"], "nothing is left for the second");
}

#[test]
fn roundings_that_take_all_of_a_side_make_a_half_circle() {
    let text = "G0 X5 Y5\nG1 X30 F100 ,R5\nY15 ,R5\nX5\n";
    assert_moves(
        &clean(text, Dialect::Fanuc),
        &[
            line(5.0, 5.0),
            line(25.0, 5.0),
            arc(30.0, 10.0, 5.0),
            arc(25.0, 15.0, 5.0),
            line(5.0, 15.0),
        ],
    );
    let text = "G0 X-20 Y5\nG42 D1 G1 X5 F100\nX30 ,R5\nY15 ,R5\nX5\nG40 X-20\nM30\n";
    let contour = &only_contour(&clean(text, Dialect::Fanuc)).contour.clone();
    let lengths: Vec<_> = contour.segments().iter().map(|s| s.curve.length()).collect();
    assert_eq!(lengths.len(), 4, "line, two quarters, line: {lengths:?}");
    near(lengths[1] + lengths[2], 5.0 * std::f64::consts::PI, 1e-9, "half a circle");
    // A chamfer that takes all of its second move.
    let text = "G0 X5 Y5\nG1 X30 F100 ,C5\nY10\nX50\n";
    assert_moves(
        &clean(text, Dialect::Fanuc),
        &[line(5.0, 5.0), line(25.0, 5.0), line(30.0, 10.0), line(50.0, 10.0)],
    );
}

#[test]
fn corners_are_cut_in_every_plane_turned_mirrored_and_in_inches() {
    let read = clean("G18 G0 X0 Z0.5\nG1 Z10. F100 ,R2\nX10.\n", Dialect::Fanuc);
    let made = moves(&read);
    let MoveCurve::Arc(arc) = made[2].curve else { panic!("{made:?}") };
    near_point(arc.center(), p(8.0, 2.0), 1e-9, "z, x");
    let read = clean("G20 G0 X1 Y1\nG1 X2 F10 ,R.5\nY3\n", Dialect::Fanuc);
    let MoveCurve::Arc(arc) = moves(&read)[2].curve else { panic!("{read:?}") };
    near(arc.radius(), 12.7, 1e-9, "in inches");
    let read = clean("G0 X1 Y1\nG68 X0 Y0 R90\nG1 X20 Y0 F10 ,R5\nY20\nG69\n", Dialect::Fanuc);
    let MoveCurve::Arc(arc) = moves(&read)[2].curve else { panic!("{read:?}") };
    near(arc.radius(), 5.0, 1e-9, "turned");
    let read =
        clean("G0 X1. Y1.\nG51 X0 Y0 I2. J2.\nG1 X20. Y1. F10 ,R5\nY20.\nG50\n", Dialect::Fanuc);
    let MoveCurve::Arc(arc) = moves(&read)[2].curve else { panic!("{read:?}") };
    near(arc.radius(), 10.0, 1e-9, "scaled");
    let read = clean("G0 X1 Y1\nG51.1 X0\nG1 X20 Y1 F10 ,R5\nY20\nG50.1 X0\n", Dialect::Fanuc);
    let MoveCurve::Arc(arc) = moves(&read)[2].curve else { panic!("{read:?}") };
    assert!(arc.is_clockwise(), "mirrored: {arc:?}");
}
