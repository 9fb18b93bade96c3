//! Programs as FANUC, ISG and SINUMERIK compensate them, against closed forms and the table that
//! Beckhoff publishes of inserted blocks.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

mod common;

use common::{near, near_point, p};
use g41::compensation::{CornerStyle, LeadStyle, Options, TangentBand};
use g41::contour::{MoveCurve, Role, ToolPath};
use g41::diagnostic::Severity;
use g41::program::{
    Dialect, EmitOptions, Interpretation, Program, emit, interpret, programmed_path,
};
use g41::simulation::{ListedTool, Profile, ToolSize, Tools, check_program, compensate_program};
use glam::DVec2;

fn read(text: &str, profile: Profile) -> Interpretation {
    interpret(&Program::parse(text, Dialect::Auto), profile.rules())
}

/// Tool 1 has a radius of 2 mm, tool 2 of 3 mm.
fn tools() -> Tools {
    let tool =
        |number, radius| ListedTool { number, size: ToolSize::Radius(radius), orientation: 0 };
    Tools { listed: vec![tool(1, 2.0), tool(2, 3.0)], default_radius: None }
}

fn path_with(text: &str, profile: Profile, options: &Options) -> ToolPath {
    compensate_program(&read(text, profile), &tools(), options)
}

fn path_of(text: &str, profile: Profile) -> ToolPath {
    path_with(text, profile, &profile.options())
}

/// The codes of what is worth a warning.
fn codes(path: &ToolPath) -> Vec<&str> {
    let worth = path.diagnostics.iter().filter(|found| found.severity > Severity::Info);
    worth.map(|found| found.code).collect()
}

/// Asserts where the moves end, the first move apart, which goes to where the program starts.
#[track_caller]
fn assert_ends(path: &ToolPath, expected: &[DVec2]) {
    let ends: Vec<DVec2> = path.moves.iter().map(|step| step.curve.end()).collect();
    assert_eq!(ends.len(), expected.len(), "{ends:?} should be {expected:?}");
    for (end, expected) in ends.iter().zip(expected) {
        near_point(*end, *expected, 1e-9, &format!("{ends:?}"));
    }
    for pair in path.moves.windows(2) {
        near_point(pair[1].curve.start(), pair[0].curve.end(), 1e-9, "in one piece");
    }
}

fn arcs(path: &ToolPath) -> Vec<DVec2> {
    let arc = |curve| match curve {
        MoveCurve::Arc(arc) => Some(arc.center()),
        _ => None,
    };
    let inserted = path.moves.iter().filter(|step| step.role == Role::Transition);
    inserted.filter_map(|step| arc(step.curve)).collect()
}

/// Round three sides of a square of 30 mm from outside, with further words at each block.
fn square(words: [&str; 4]) -> String {
    let [lead, up, across, down] = words;
    format!(
        "G21 G90 G17\nG0 X0 Y-20\nG41 D1 G1 X0 Y0 F100 {lead}\n{up} Y30\n{across} X30\n{down} Y0\n\
         G40 X30 Y-20\nM30\n"
    )
}

// FANUC

const FANUC_LEAD: &str = "G21 G90\nG0 X-20 Y0\nG41 D1 G1 X0 Y0 F100\nY-30\nG40 X-20 Y-30\nM30\n";

#[test]
fn fanuc_leads_of_the_types_a_b_and_c() {
    // The lead-in along +x, then down, the tool on the left: an outside corner of 90°, where the
    // intersection is (2, 2). At the end, left of the way down, out along −x: likewise.
    let of = |lead| {
        let options = Options { lead, ..Profile::Fanuc.options() };
        path_with(FANUC_LEAD, Profile::Fanuc, &options)
    };
    assert_eq!(Profile::Fanuc.options().lead, LeadStyle::Perpendicular, "type A unless chosen");
    let start = p(-20.0, 0.0);
    let end = p(-20.0, -30.0);
    assert_ends(&of(LeadStyle::Perpendicular), &[start, p(2.0, 0.0), p(2.0, -30.0), end]);
    let around = [p(0.0, 2.0), p(2.0, 2.0), p(2.0, -32.0), p(0.0, -32.0)];
    assert_ends(
        &of(LeadStyle::Intersection),
        &[start, around[0], around[1], around[2], around[3], end],
    );
    let extra = [p(0.0, 0.0), p(2.0, 0.0), p(2.0, -30.0), p(0.0, -30.0)];
    assert_ends(&of(LeadStyle::ExtraMove), &[start, extra[0], extra[1], extra[2], extra[3], end]);
}

#[test]
fn fanuc_goes_round_acute_corners_by_a_straight_move() {
    // From +y the way turns by 135° to the right: A1 = P + r (n1 + T1), A2 = P + r (n2 − T2).
    let text = "G21 G90\nG0 X0 Y-20\nG41 D1 G1 X0 Y0 F100\nY30\nX20 Y10\nG40 X40 Y10\nM30\n";
    let path = path_of(text, Profile::Fanuc);
    let h = 2.0 * std::f64::consts::FRAC_1_SQRT_2;
    let (n2, t2) = (p(h, h), p(h, -h));
    let corner = p(0.0, 30.0);
    assert_ends(
        &path,
        &[
            p(0.0, -20.0),
            p(-2.0, 0.0),
            corner + p(-2.0, 2.0),
            corner + n2 - t2,
            p(20.0, 10.0) + n2,
            p(40.0, 10.0),
        ],
    );
    assert_eq!(codes(&path), [""; 0], "{:?}", path.diagnostics);
}

#[test]
fn a_negative_offset_is_the_other_side() {
    let text = square(["", "", "", ""]);
    let negative = Tools {
        listed: vec![ListedTool { number: 1, size: ToolSize::Radius(-2.0), orientation: 0 }],
        default_radius: None,
    };
    let options = Profile::Fanuc.options();
    let swapped = compensate_program(&read(&text, Profile::Fanuc), &negative, &options);
    let right = path_of(&text.replace("G41", "G42"), Profile::Fanuc);
    assert_eq!(swapped.moves, right.moves, "G41 with −2 mm is G42 with 2 mm");
}

#[test]
fn fanuc_refuses_arcs_that_switch_compensation() {
    let into = "G21 G90\nG0 X0 Y0\nG41 D1 G2 X10 Y10 I10 F100\nG1 X30\nG40 Y30\nM30\n";
    let path = path_of(into, Profile::Fanuc);
    assert!(codes(&path).contains(&"curved-lead-in"), "{:?}", path.diagnostics);
    let out = "G21 G90\nG0 X0 Y-20\nG41 D1 G1 Y0 F100\nY30\nG40 G2 X10 Y40 I10\nM30\n";
    let path = path_of(out, Profile::Fanuc);
    assert!(codes(&path).contains(&"curved-lead-out"), "{:?}", path.diagnostics);
}

#[test]
fn a_new_radius_counts_from_the_end_of_its_block_on() {
    // Beside (0, 30) with 2 mm, beside (30, 30) with 3 mm, the block between runs straight from one
    // to the other; whether D stands in it or before it.
    let expected =
        [p(0.0, -20.0), p(-2.0, 0.0), p(-2.0, 32.0), p(33.0, 33.0), p(33.0, 0.0), p(30.0, -20.0)];
    for profile in [Profile::Fanuc, Profile::Isg] {
        for words in ["D2", "D2\n", "G41 D2\n", "D2\nD1\nD2\n"] {
            let path = path_of(&square(["", "", words, ""]), profile);
            let lead = Options { lead: LeadStyle::Perpendicular, ..profile.options() };
            let path = if profile == Profile::Isg {
                path_with(&square(["", "", words, ""]), profile, &lead)
            } else {
                path
            };
            assert_ends(&path, &expected);
            assert_eq!(codes(&path), [""; 0], "{profile:?}: {:?}", path.diagnostics);
            let block = path.moves[3];
            assert_eq!(block.role, Role::Segment, "it is the programmed block");
        }
    }
    // Back to the same radius before any move: nothing has changed.
    let path = path_of(&square(["", "", "D2\nD1\n", ""]), Profile::Fanuc);
    let unchanged = path_of(&square([""; 4]), Profile::Fanuc);
    let ends: Vec<DVec2> = unchanged.moves.iter().map(|step| step.curve.end()).collect();
    assert_ends(&path, &ends);
}

#[test]
fn a_block_on_which_the_radius_changes_is_judged_and_written_once() {
    // With leads into and out of inside corners, which do not cut.
    let text = square(["", "", "D2", ""]).replace("X0 Y-20", "X-20 Y0");
    let text = text.replace("X30 Y-20", "X50 Y0");
    let program = read(&text, Profile::Fanuc);
    let path = path_of(&text, Profile::Fanuc);
    assert_eq!(check_program(&program, &path, &tools(), 0.001), [], "no gouge");
    let programmed = programmed_path(&program);
    let ends: Vec<DVec2> = programmed.moves.iter().map(|step| step.curve.end()).collect();
    let square = [p(-20.0, 0.0), p(0.0, 0.0), p(0.0, 30.0), p(30.0, 30.0), p(30.0, 0.0)];
    assert_eq!(ends, [&square[..], &[p(50.0, 0.0)]].concat(), "each block once");
    let written = emit(&programmed, &EmitOptions::default()).text;
    assert_eq!(written.matches("X30").count(), 1, "{written}");
}

#[test]
fn a_new_radius_before_an_arc_is_a_step_and_is_told() {
    let text = "G21 G90\nG0 X0 Y-20\nG41 D1 G1 Y0 F100\nY30\nD2 G2 X30 Y30 I15\nG1 Y0\nG40 Y-20\n";
    let path = path_of(text, Profile::Fanuc);
    assert_eq!(codes(&path), ["radius-changed"], "{:?}", path.diagnostics);
    let radii: Vec<f64> = path
        .moves
        .iter()
        .filter_map(|step| match step.curve {
            MoveCurve::Arc(arc) => Some(arc.radius()),
            _ => None,
        })
        .collect();
    assert_eq!(radii, [18.0], "the arc has the new radius");
}

#[test]
fn where_the_side_changes_fanuc_goes_to_where_both_paths_cross() {
    // Left along +x: y = 2. Right along −y at x = 30: x = 28. They cross at (28, 2).
    let text = "G21 G90\nG0 X-20 Y0\nG41 D1 G1 X0 Y0 F100\nX30\nG42 Y-30\nG40 Y-50\nM30\n";
    let path = path_of(text, Profile::Fanuc);
    let along = [p(0.0, 2.0), p(28.0, 2.0), p(28.0, -30.0)];
    assert_ends(&path, &[p(-20.0, 0.0), along[0], along[1], along[2], p(30.0, -50.0)]);
    assert_eq!(codes(&path), [""; 0], "{:?}", path.diagnostics);
    // Down on an arc about (10, 0), its path on the right of radius 18: its circle crosses y = 2 at
    // x = 10 + √(18² − 2²).
    let text =
        "G21 G90\nG0 X-20 Y0\nG41 D1 G1 X0 Y0 F100\nX30\nG42 G2 X10 Y-20 I-20\nG40 G1 X-20\n";
    let path = path_of(text, Profile::Fanuc);
    let crossing = p(10.0 + 320.0_f64.sqrt(), 2.0);
    near_point(path.moves[2].curve.end(), crossing, 1e-9, "the end of the line");
    near_point(path.moves[3].curve.start(), crossing, 1e-9, "the start of the arc");
    near_point(path.moves[3].curve.end(), p(10.0, -18.0), 1e-9, "the end of the arc");
    // A reversal: the paths are parallel, and the tool goes from beside the one to beside the other.
    let text = "G21 G90\nG0 X-20 Y0\nG41 D1 G1 X0 Y0 F100\nX30\nG42 X0\nG40 X-20\nM30\n";
    let path = path_of(text, Profile::Fanuc);
    assert_ends(&path, &[p(-20.0, 0.0), p(0.0, 2.0), p(30.0, 2.0), p(0.0, 2.0), p(-20.0, 0.0)]);
}

#[test]
fn g39_rounds_the_corner_where_it_stands_and_no_other() {
    for words in ["G39", "G39 I10", "G39 X30", "G39 X30 Y30", "G91 G39 X10\nG90", "G39\nG4 P1\nM8"]
    {
        let path = path_of(&square(["", "", &format!("{words}\n"), ""]), Profile::Fanuc);
        assert_eq!(codes(&path), [""; 0], "{words}: {:?}", path.diagnostics);
        let centers = arcs(&path);
        assert_eq!(centers.len(), 1, "{words}");
        near_point(centers[0], p(0.0, 30.0), 1e-9, words);
    }
    let path = path_of(&square(["", "", "G39 J10\n", ""]), Profile::Fanuc);
    assert_eq!(codes(&path), ["corner-arc-direction"], "up, but the next block goes across");
    let path = path_of("G21\nG0 X0 Y0\nG39\nG1 X10 F100\nM30\n", Profile::Fanuc);
    assert_eq!(codes(&path), ["corner-arc-off"], "there is no corner without compensation");
    let path = path_of(&square(["", "", "G39\n", ""]), Profile::LinuxCnc);
    assert!(codes(&path).contains(&"not-supported"), "LinuxCNC has no G39");
}

// ISG and Beckhoff

/// A corner at the origin where the way turns right by `degrees`, straight or on arcs of 40 mm.
fn corner(words: &str, degrees: f64, curved: [bool; 2]) -> String {
    let t2 = DVec2::from_angle(-degrees.to_radians());
    let end = |from: DVec2, to: DVec2| format!("X{:.9} Y{:.9}", to.x - from.x, to.y - from.y);
    // A quarter of a circle that turns right and ends along +x at the origin, and one that turns
    // left from there along T2.
    let (first, start) =
        if curved[0] { ("G2 X0 Y0 I40 J0", p(-40.0, -40.0)) } else { ("G1 X0 Y0", p(-40.0, 0.0)) };
    let second = if curved[1] {
        let center = t2.perp() * 40.0;
        let to = center + t2 * 40.0;
        format!("G3 {} I{:.9} J{:.9}", end(DVec2::ZERO, to), center.x, center.y)
    } else {
        format!("G1 {}", end(DVec2::ZERO, t2 * 40.0))
    };
    format!(
        "G21 G90 G17\nG0 X{} Y{}\nG41 D1 G1 X{} Y{} F100\n{first}\n{words} {second}\nM30\n",
        start.x - 20.0,
        start.y - 20.0,
        start.x,
        start.y
    )
}

/// Moves between the path of the first block and that of the second.
fn inserted(path: &ToolPath) -> Vec<MoveCurve> {
    let is_segment = |role| role == Role::Segment;
    let first = path.moves.iter().position(|step| is_segment(step.role)).expect("a segment");
    let last = path.moves.iter().rposition(|step| is_segment(step.role)).expect("a segment");
    path.moves[first + 1..last].iter().map(|step| step.curve).collect()
}

#[test]
fn isg_inserts_as_many_blocks_as_its_manual_says() {
    // Lines and circles inserted with G25 at 180–270° and 270–360°, which is a turn of 0–90° and
    // 90–180°; with G26 one circle each.
    for (curved, [elongated, acute]) in [
        ([false, false], [0, 1]),
        ([false, true], [1, 2]),
        ([true, false], [1, 2]),
        ([true, true], [2, 3]),
    ] {
        for (degrees, count) in
            [(30.0, elongated), (75.0, elongated), (100.0, acute), (160.0, acute)]
        {
            for words in ["", "G25"] {
                let path = path_of(&corner(words, degrees, curved), Profile::Isg);
                let lines = inserted(&path);
                let what = format!("{curved:?} {degrees}° {words}: {lines:?}");
                assert_eq!(lines.len(), count, "{what}");
                assert!(lines.iter().all(|one| matches!(one, MoveCurve::Line(_))), "{what}");
            }
            let path = path_of(&corner("G26", degrees, curved), Profile::Isg);
            let circles = inserted(&path);
            assert!(matches!(circles[..], [MoveCurve::Arc(_)]), "{degrees}°: {circles:?}");
        }
        // 0–180°: nothing is inserted.
        for words in ["G25", "G26"] {
            let path = path_of(&corner(words, -40.0, curved), Profile::Isg);
            assert_eq!(inserted(&path), [], "an inside corner");
        }
    }
}

#[test]
fn isg_takes_turns_of_three_degrees_for_none() {
    let options = Profile::Isg.options();
    for (degrees, limit, counts) in
        [(2.9, 3.0, 0), (3.1, 3.0, 1), (2.9, 0.1, 1), (0.11, 0.1, 1), (0.09, 0.1, 0)]
    {
        let tangent_band = TangentBand::Angle(f64::to_radians(limit));
        let options = Options { tangent_band, ..options };
        for sign in [1.0, -1.0] {
            let text = corner("", sign * degrees, [false, false]);
            let path = path_with(&text, Profile::Isg, &options);
            let at_corner = |corner: DVec2| corner.length() < 1.0;
            let found = path.transitions.iter().filter(|found| at_corner(found.corner)).count();
            assert_eq!(found, counts, "{degrees}° with a limit of {limit}°");
        }
    }
    let TangentBand::Angle(limit) = options.tangent_band else { panic!("a limit") };
    near(limit, 3.0_f64.to_radians(), 1e-12, "the default");
}

#[test]
fn g25_and_g26_hold_until_the_other_within_a_contour() {
    let centers = |words| arcs(&path_of(&square(words), Profile::Isg));
    assert_eq!(centers(["", "", "G26", "G25"]), [p(0.0, 30.0)], "the first corner");
    assert_eq!(centers(["", "", "", "G26"]), [p(30.0, 30.0)], "the second");
    assert_eq!(centers(["", "G26", "", ""]), [p(0.0, 30.0), p(30.0, 30.0)], "both");
    // They mean something else, or nothing, elsewhere.
    let path = path_of(&square(["", "G26", "", ""]), Profile::G41);
    assert_eq!(codes(&path), ["word-not-understood"], "the textbook has no G26");
}

#[test]
fn g138_leads_straight_and_g139_round() {
    let text = |word| FANUC_LEAD.replace("G41", &format!("{word} G41"));
    let path = path_of(&text("G138"), Profile::Isg);
    near_point(path.moves[1].curve.end(), p(2.0, 0.0), 1e-9, "direct");
    let path = path_of(&text("G139"), Profile::Isg);
    near_point(path.moves[1].curve.end(), p(0.0, 2.0), 1e-9, "indirect");
    assert_eq!(path.moves, path_of(FANUC_LEAD, Profile::Isg).moves, "G139 is the default");
}

// SINUMERIK

#[test]
fn sinumerik_goes_round_by_arcs_from_a_perpendicular_lead() {
    let path = path_of(&square(["", "", "", ""]), Profile::Sinumerik);
    assert_eq!(arcs(&path), [p(0.0, 30.0), p(30.0, 30.0)], "G450 is the default");
    near_point(path.moves[1].curve.end(), p(-2.0, 0.0), 1e-9, "NORM is the default");
}

#[test]
fn g451_goes_to_the_intersection_up_to_its_limit_angle() {
    let path = path_of(&square(["", "G451", "", "G450"]), Profile::Sinumerik);
    near_point(path.moves[2].curve.end(), p(-2.0, 32.0), 1e-9, "the intersection");
    assert_eq!(arcs(&path), [p(30.0, 30.0)], "G450 again");
    for (degrees, is_arc) in [(99.0, false), (101.0, true)] {
        let text = corner("G451", degrees, [false, false]);
        let inserted = inserted(&path_of(&text, Profile::Sinumerik));
        assert_eq!(matches!(inserted[..], [MoveCurve::Arc(_)]), is_arc, "{degrees}°: {inserted:?}");
        assert_eq!(inserted.is_empty(), !is_arc, "{degrees}°: {inserted:?}");
    }
    // A line and a circle run on to where they meet, with no further block.
    let path = path_of(&corner("G451", 60.0, [false, true]), Profile::Sinumerik);
    assert_eq!(inserted(&path), [], "a line runs on to an arc that does");
}

#[test]
fn disc_lifts_the_transition_towards_the_intersection() {
    // At 90° the arc's peak is r from the corner, the intersection √2 r: half way at DISC=50.
    for words in ["G450 DISC=50", "DISC=50", "DISC=50\nG450", "G450\nDISC=50\n"] {
        let path = path_of(&square(["", words, "", ""]), Profile::Sinumerik);
        assert_eq!(codes(&path), [""; 0], "{words}: {:?}", path.diagnostics);
        let corner = p(0.0, 30.0);
        let mut farthest = 0.0_f64;
        for step in path.moves.iter().filter(|step| step.role == Role::Transition) {
            for k in 0..=100 {
                let point = step.curve.point(f64::from(k) / 100.0);
                if point.x < 10.0 {
                    farthest = farthest.max(point.distance(corner));
                }
            }
        }
        near(farthest, 1.0 + std::f64::consts::SQRT_2, 1e-3, words);
    }
    let path = path_of(&square(["", "G450 DISC=100", "", ""]), Profile::Sinumerik);
    near_point(path.moves[2].curve.end(), p(-2.0, 32.0), 1e-9, "the intersection");
    let path = path_of(&square(["", "G450 DISC=101", "", ""]), Profile::Sinumerik);
    assert_eq!(codes(&path), ["bad-disc"], "{:?}", path.diagnostics);
}

#[test]
fn kont_goes_round_the_start_from_behind_it_and_norm_does_not() {
    let of = |word| {
        let text = FANUC_LEAD.replace("G41", &format!("G450 {word} G41"));
        path_of(&text, Profile::Sinumerik)
    };
    assert_ends(&of("NORM"), &[p(-20.0, 0.0), p(2.0, 0.0), p(2.0, -30.0), p(-20.0, -30.0)]);
    let path = of("KONT");
    near_point(path.moves[1].curve.end(), p(0.0, 2.0), 1e-9, "beside the lead-in");
    near_point(path.moves[2].curve.end(), p(2.0, 0.0), 1e-9, "round the start");
    // From before the contour, an inside corner, both are the same.
    let from_before = |word| {
        let text = FANUC_LEAD.replace("X-20 Y0", "X20 Y0").replace("X-20 Y-30", "X20 Y-30");
        path_of(&text.replace("G41", &format!("G450 {word} G41")), Profile::Sinumerik).moves
    };
    assert_eq!(from_before("KONT"), from_before("NORM"), "from before the contour");
}

#[test]
fn sinumerik_never_runs_a_spline_on() {
    let text = "G21 G90 G17 G451\nG0 X0 Y-20\nG41 D1 G1 X0 Y0 F100\nY30\nBNAT ENAT CSPLINE X20 Y35\n\
                X40 Y30\nX60 Y35\nG1 X60 Y0\nG40 X60 Y-20\nM30\n";
    let path = path_of(text, Profile::Sinumerik);
    assert_eq!(codes(&path), [""; 0], "{:?}", path.diagnostics);
    let centers = arcs(&path);
    assert_eq!(centers.len(), 2, "an arc on either side of the spline");
    near_point(centers[0], p(0.0, 30.0), 1e-9, "before it");
    near_point(centers[1], p(60.0, 35.0), 1e-9, "behind it");
}

#[test]
fn frames_of_sinumerik_are_told_and_not_passed_over() {
    let text = format!("TRANS X10 Y5\n{}", square(["", "G450", "", ""]));
    let path = path_of(&text, Profile::Sinumerik);
    assert_eq!(codes(&path), ["unknown-name"], "{:?}", path.diagnostics);
}

#[test]
fn the_profiles_are_options_that_may_be_given_otherwise() {
    assert_eq!(Profile::Fanuc.options().corner, CornerStyle::Linear, "linear insertion");
    assert_eq!(Profile::Isg.options().corner, CornerStyle::Linear, "G25");
    assert_eq!(Profile::Sinumerik.options().corner, CornerStyle::Arc, "G450");
    let options = Options { corner: CornerStyle::Intersection, ..Profile::Sinumerik.options() };
    let path = path_with(&square([""; 4]), Profile::Sinumerik, &options);
    assert_eq!(arcs(&path), [], "an option given explicitly wins");
}

#[test]
fn g40_with_a_vector_leads_out_from_where_the_path_meets_that_along_a_wall() {
    let program = |words: &str, wall: &str| {
        format!("G0 X0 Y-20\nG41 D1 G1 X0 Y0 F100\nY30\n{words}\nG40 {wall} X60 Y60\nM30\n")
    };
    // The wall goes up at 45° behind a line to the right: an inside corner for the tool above, at
    // y = 32, where the wall's own path is 2√2 to the left of it.
    let inside = path_of(&program("X30", "I10 J10"), Profile::Fanuc);
    let meets = p(30.0 + 2.0 - 2.0 * 2.0_f64.sqrt(), 32.0);
    near_point(inside.moves[3].curve.end(), meets, 1e-9, "cut back");
    near_point(inside.moves[4].curve.start(), meets, 1e-9, "and out from there");
    near_point(inside.moves[4].curve.end(), p(60.0, 60.0), 1e-9, "to the end");
    assert_eq!(inside.moves.len(), 5, "{:?}", inside.moves);
    // Down at 45° it is an outside corner, and the line is run on.
    let outside = path_of(&program("X30", "I10 J-10"), Profile::Fanuc);
    let v = p(30.0 - 2.0 + 2.0 * 2.0_f64.sqrt(), 32.0);
    near_point(outside.moves[3].curve.end(), v, 1e-9, "run on");
    // However sharp: back at 135° from the direction of the line.
    let sharp = path_of(&program("X30", "I-10 J-10"), Profile::Fanuc);
    let v = p(30.0 + 2.0 / (22.5_f64).to_radians().tan(), 32.0);
    near_point(sharp.moves[3].curve.end(), v, 1e-9, "far on");
    // Along the line itself there is no intersection, and without a vector none is sought.
    for wall in ["I10 J0", ""] {
        let plain = path_of(&program("X30", wall), Profile::Fanuc);
        near_point(plain.moves[3].curve.end(), p(30.0, 32.0), 1e-9, wall);
        assert_eq!(codes(&plain), [""; 0], "{wall}");
    }
    // An arc's path, of radius 12 about (10, 30), meets the wall's path, x = 22 − 2.
    let arc = path_of(&program("G2 X20 Y30 I10 J0", "G1 I0 J10"), Profile::Fanuc);
    let end = arc.moves[3].curve.end();
    near(end.distance(p(10.0, 30.0)), 12.0, 1e-9, "on the arc's path");
    near(end.x, 18.0, 1e-9, "and on the wall's");
    let text = emit(
        &programmed_path(&read(&program("X30", "I10 J10"), Profile::Fanuc)),
        &EmitOptions { target: g41::program::Target::Fanuc0M, ..EmitOptions::default() },
    )
    .text;
    assert!(text.contains("G40 I10. J10. X60. Y60."), "kept for a control that has it: {text}");
}

#[test]
fn offn_is_left_on_the_contour() {
    let program = square(["OFFN=0.5", "", "", ""]);
    let path = path_of(&program, Profile::Sinumerik);
    near_point(path.moves[1].curve.end(), p(-2.5, 0.0), 1e-9, "2 mm and 0.5 mm");
    near(arcs(&path)[0].distance(p(0.0, 30.0)), 0.0, 1e-9, "about the corner");
    let inch = path_of(&program.replace("G21", "G70"), Profile::Sinumerik);
    near(inch.moves[1].curve.end().x, -(2.0 + 0.5 * 25.4), 1e-9, "in inches it is one, too");
    // A new allowance takes effect over the next straight block, as a new radius does.
    let changed = path_of(&square(["", "", "OFFN=1", ""]), Profile::Sinumerik);
    let tapered = changed.moves.iter().any(|step| {
        let [a, b] = [step.curve.start(), step.curve.end()];
        (a.y - 32.0).abs() < 1e-9 && (b.y - 33.0).abs() < 1e-9
    });
    assert!(tapered, "{:?}", changed.moves);
    let kept = programmed_path(&read(&program, Profile::Sinumerik));
    assert!(codes(&kept).contains(&"left-out"), "{:?}", kept.diagnostics);
}

#[test]
fn leads_of_sinumerik_that_are_not_known_are_told() {
    for (words, what) in
        [("KONTT", "KONTT"), ("KONTC", "KONTC"), ("G461", "G461"), ("G462", "G462")]
    {
        let path = path_of(&square([words, "", "", ""]), Profile::Sinumerik);
        assert_eq!(codes(&path), ["not-supported"], "{words}: {:?}", path.diagnostics);
        assert!(path.diagnostics[0].message.contains(what), "{:?}", path.diagnostics);
        assert!(path.moves.len() > 4, "the rest of the block counts");
    }
    let path = path_of(&square(["G460", "", "", ""]), Profile::Sinumerik);
    assert_eq!(codes(&path), [""; 0], "G460 is what there is anyway");
}
