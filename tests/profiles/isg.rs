//! ISG and Beckhoff: the table of inserted blocks, G25, G26, G138 and G139.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common::{near, near_point, p};
use g41::compensation::{Options, TangentBand};
use g41::contour::MoveCurve;

use g41::simulation::Profile;
use glam::DVec2;

use super::{FANUC_LEAD, arcs, codes, corner, inserted, path_of, path_with, square};

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
