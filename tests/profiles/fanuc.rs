//! FANUC: vectors of cutter compensation C, G39, G40 with a vector, radius and side that change.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common::{near, near_point, p};
use g41::compensation::{LeadStyle, Options};
use g41::contour::{Contour, CornerWish, MoveCurve, Role};
use g41::program::{EmitOptions, Interpretation, Item, Target, emit, programmed_path};
use g41::simulation::{ListedTool, Profile, ToolSize, Tools, check_program, compensate_program};
use glam::DVec2;

use super::{FANUC_LEAD, arcs, assert_ends, codes, path_of, path_with, read, square, tools};

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
    assert!(codes(&path).contains(&"word-not-understood"), "LinuxCNC has no G39");
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
fn corner_arcs_are_asked_for_of_a_control_that_compensates_itself() {
    let text = square(["", "", "G39 I10 J0\n", ""]);
    let program = read(&text, Profile::Fanuc);
    let kept = programmed_path(&program);
    for target in [Target::Fanuc0M, Target::Fanuc6M, Target::Fanuc30I] {
        let written = emit(&kept, &EmitOptions { target, ..EmitOptions::default() });
        let asked = written.text.lines().filter(|line| line.contains("G39")).count();
        assert_eq!(asked, 1, "of one corner:\n{}", written.text);
        let again = read(&written.text, Profile::Fanuc);
        let wishes = |read: &Interpretation| -> Vec<CornerWish> {
            let contours = read.items.iter().filter_map(|item| match item {
                Item::Contour(found) => Some(&found.contour),
                _ => None,
            });
            contours.flat_map(Contour::segments).map(|s| s.attributes.wish.corner).collect()
        };
        assert_eq!(wishes(&again), wishes(&program), "{target:?}:\n{}", written.text);
        assert!(wishes(&again).contains(&CornerWish::Arc), "asked for: {}", written.text);
    }
    // Where the control does not know it, it is told.
    let grbl = emit(&kept, &EmitOptions::default());
    assert!(grbl.diagnostics.iter().any(|found| found.message.contains("G39")), "{grbl:?}");
}

#[test]
fn a_rounded_corner_outside_has_the_radius_and_that_of_the_tool() {
    // The tool of 2 mm on the left, outside; then on the right, where it must fit into the corner.
    let text = square(["", "", "", ""]).replace("Y30\n", "Y30 ,R5\n").replace("X30\n", "X30 ,C4\n");
    for (side, radius) in [("G41", 7.0), ("G42", 3.0)] {
        let path = path_of(&text.replace("G41", side), Profile::Fanuc);
        let round = path.moves.iter().find_map(|step| match step.curve {
            MoveCurve::Arc(arc) if step.role == Role::Segment => Some(arc),
            _ => None,
        });
        let round = round.expect("the rounding is a segment");
        near(round.radius(), radius, 1e-9, side);
        near_point(round.center(), p(5.0, 25.0), 1e-9, side);
        assert_eq!(codes(&path), [""; 0], "{side}: {:?}", path.diagnostics);
    }
}
