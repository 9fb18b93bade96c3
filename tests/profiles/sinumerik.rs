//! SINUMERIK: G450, G451, DISC, NORM, KONT and OFFN.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common::{near, near_point, p};

use g41::contour::{MoveCurve, Role};
use g41::program::programmed_path;
use g41::simulation::Profile;

use super::{FANUC_LEAD, arcs, assert_ends, codes, corner, inserted, path_of, read, square};

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
fn a_frame_before_compensation_moves_the_whole_path() {
    let plain = path_of(&square(["", "G450", "", ""]), Profile::Sinumerik);
    let text = format!("TRANS X10 Y5\n{}", square(["", "G450", "", ""]));
    let path = path_of(&text, Profile::Sinumerik);
    assert_eq!(codes(&path), [""; 0], "{:?}", path.diagnostics);
    assert_eq!(path.moves.len(), plain.moves.len(), "as many moves");
    for (moved, still) in path.moves.iter().zip(&plain.moves) {
        near_point(moved.curve.end(), still.curve.end() + p(10.0, 5.0), 1e-9, "10 and 5 farther");
    }
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
