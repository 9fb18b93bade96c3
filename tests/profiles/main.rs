//! Programs as FANUC, ISG and SINUMERIK compensate them, against closed forms and the table that
//! Beckhoff publishes of inserted blocks.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

#[path = "../common/mod.rs"]
mod common;
mod fanuc;
mod isg;
mod sinumerik;

use common::{near_point, p};
use g41::compensation::{CornerStyle, Options};
use g41::contour::{MoveCurve, Role, ToolPath};
use g41::diagnostic::Severity;
use g41::program::{Dialect, Interpretation, Program, interpret};
use g41::simulation::{ListedTool, Profile, ToolSize, Tools, compensate_program};
use glam::DVec2;

pub(crate) fn read(text: &str, profile: Profile) -> Interpretation {
    interpret(&Program::parse(text, Dialect::Auto), profile.rules())
}

/// Tool 1 has a radius of 2 mm, tool 2 of 3 mm.
pub(crate) fn tools() -> Tools {
    let tool =
        |number, radius| ListedTool { number, size: ToolSize::Radius(radius), orientation: 0 };
    Tools { listed: vec![tool(1, 2.0), tool(2, 3.0)], default_radius: None }
}

pub(crate) fn path_with(text: &str, profile: Profile, options: &Options) -> ToolPath {
    compensate_program(&read(text, profile), &tools(), options)
}

pub(crate) fn path_of(text: &str, profile: Profile) -> ToolPath {
    path_with(text, profile, &profile.options())
}

/// The codes of what is worth a warning.
pub(crate) fn codes(path: &ToolPath) -> Vec<&str> {
    let worth = path.diagnostics.iter().filter(|found| found.severity > Severity::Info);
    worth.map(|found| found.code).collect()
}

/// Asserts where the moves end, the first move apart, which goes to where the program starts.
#[track_caller]
pub(crate) fn assert_ends(path: &ToolPath, expected: &[DVec2]) {
    let ends: Vec<DVec2> = path.moves.iter().map(|step| step.curve.end()).collect();
    assert_eq!(ends.len(), expected.len(), "{ends:?} should be {expected:?}");
    for (end, expected) in ends.iter().zip(expected) {
        near_point(*end, *expected, 1e-9, &format!("{ends:?}"));
    }
    for pair in path.moves.windows(2) {
        near_point(pair[1].curve.start(), pair[0].curve.end(), 1e-9, "in one piece");
    }
}

pub(crate) fn arcs(path: &ToolPath) -> Vec<DVec2> {
    let arc = |curve| match curve {
        MoveCurve::Arc(arc) => Some(arc.center()),
        _ => None,
    };
    let inserted = path.moves.iter().filter(|step| step.role == Role::Transition);
    inserted.filter_map(|step| arc(step.curve)).collect()
}

/// Round three sides of a square of 30 mm from outside, with further words at each block.
pub(crate) fn square(words: [&str; 4]) -> String {
    let [lead, up, across, down] = words;
    format!(
        "G21 G90 G17\nG0 X0 Y-20\nG41 D1 G1 X0 Y0 F100 {lead}\n{up} Y30\n{across} X30\n{down} Y0\n\
         G40 X30 Y-20\nM30\n"
    )
}

/// In along +x, down with the tool on the left, and out.
pub(crate) const FANUC_LEAD: &str =
    "G21 G90\nG0 X-20 Y0\nG41 D1 G1 X0 Y0 F100\nY-30\nG40 X-20 Y-30\nM30\n";

/// A corner at the origin where the way turns right by `degrees`, straight or on arcs of 40 mm.
pub(crate) fn corner(words: &str, degrees: f64, curved: [bool; 2]) -> String {
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
pub(crate) fn inserted(path: &ToolPath) -> Vec<MoveCurve> {
    let is_segment = |role| role == Role::Segment;
    let first = path.moves.iter().position(|step| is_segment(step.role)).expect("a segment");
    let last = path.moves.iter().rposition(|step| is_segment(step.role)).expect("a segment");
    path.moves[first + 1..last].iter().map(|step| step.curve).collect()
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
fn a_text_without_signs_is_read_in_the_language_of_its_control() {
    let dialect = |profile: Profile, text: &str| profile.rules().dialect(Dialect::Auto, text);
    for (profile, expected) in [
        (Profile::G41, Dialect::Auto),
        (Profile::LinuxCnc, Dialect::LinuxCnc),
        (Profile::Fanuc, Dialect::Fanuc),
        (Profile::Isg, Dialect::Auto),
        (Profile::Sinumerik, Dialect::Sinumerik),
    ] {
        assert_eq!(dialect(profile, "G0 X1\nM30\n"), expected, "{profile:?}");
        let asked = profile.rules().dialect(Dialect::Fanuc, "R1=5\n");
        assert_eq!(asked, Dialect::Fanuc, "what is asked for counts");
    }
    assert_eq!(dialect(Profile::Sinumerik, "%\nO1234\n"), Dialect::Fanuc, "its signs count");
}
