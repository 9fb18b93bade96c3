//! Whole programs compensated: every stage together, against closed forms.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::compensation::{CornerStyle, GougePolicy, Options};
use g41::contour::{Gouge, Move, MoveCurve, Role, ToolPath};
use g41::diagnostic::{Origin, Severity};
use g41::program::{Dialect, EmitOptions, Item, Program, Rules, emit, interpret};
use g41::simulation::{ListedTool, ToolSize, Tools, check_program, compensate_program};
use glam::DVec2;

const POCKET: &str = include_str!("programs/pocket.ngc");
const CAM: &str = include_str!("programs/cam.ngc");
const SLOT: &str = include_str!("programs/slot.ngc");
const LETTERING: &str = include_str!("programs/lettering.ngc");
const INCH_PLATE: &str = include_str!("programs/inch_plate.ngc");
const INCREMENTAL: &str = include_str!("programs/incremental.ngc");
const HELIX: &str = include_str!("programs/helix.ngc");
const ALL: [&str; 7] = [POCKET, CAM, SLOT, LETTERING, INCH_PLATE, INCREMENTAL, HELIX];

fn path_with(text: &str, tools: &Tools) -> ToolPath {
    let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
    compensate_program(&read, tools, &Options::default())
}

fn path_of(text: &str, radius: f64) -> ToolPath {
    path_with(text, &Tools::all(radius))
}

/// Radii of the arcs that follow segments, in order.
fn segment_radii(path: &ToolPath) -> Vec<f64> {
    let radius = |found: &Move| match (found.role, found.curve) {
        (Role::Segment, MoveCurve::Arc(arc)) => Some(arc.radius()),
        _ => None,
    };
    path.moves.iter().filter_map(radius).collect()
}

fn assert_radii(path: &ToolPath, expected: &[f64]) {
    let found = segment_radii(path);
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() < 1e-9, "{found:?} should be {expected:?}");
    }
}

/// The moves of contours, the diagnostics apart.
fn codes(path: &ToolPath) -> Vec<(&str, Severity)> {
    path.diagnostics.iter().map(|d| (d.code, d.severity)).collect()
}

#[test]
fn every_program_gives_a_path_without_gaps_and_without_findings() {
    for text in ALL {
        for radius in [0.0, 0.5, 2.0] {
            let path = path_of(text, radius);
            assert_eq!(codes(&path), [], "radius {radius}: {:?}", path.diagnostics);
            for pair in path.moves.windows(2) {
                let (a, b) = (&pair[0], &pair[1]);
                let gap = a.curve.end().distance(b.curve.start());
                assert!(gap < 1e-9, "radius {radius}: {gap} mm between\n{a:?}\n{b:?}");
                assert!(
                    (a.heights[1] - b.heights[0]).abs() < 1e-9,
                    "radius {radius}:\n{a:?}\n{b:?}"
                );
            }
        }
    }
}

#[test]
fn every_program_is_written_and_read_again_as_the_same_path() {
    for text in ALL {
        let path = path_of(text, 2.0);
        let written = emit(&path, &EmitOptions::default());
        let found = &written.diagnostics;
        assert!(found.iter().all(|found| found.severity == Severity::Info), "{found:?}");
        assert!(!written.text.contains("G4"), "{}", written.text);
        let again = path_of(&written.text, 2.0);
        assert_eq!(codes(&again), [], "{}", written.text);
        let ends = |path: &ToolPath| path.moves.last().map(|m| (m.curve.end(), m.heights[1]));
        let (a, b) = (ends(&path).expect("moves"), ends(&again).expect("moves"));
        assert!(a.0.distance(b.0) < 1e-4 && (a.1 - b.1).abs() < 1e-4, "{a:?} {b:?}");
        let length = |path: &ToolPath| path.moves.iter().map(|m| m.curve.length()).sum::<f64>();
        let (a, b) = (length(&path), length(&again));
        assert!(
            (a - b).abs() < 2e-3 * f64::from(u32::try_from(again.moves.len()).expect("few")),
            "{a} {b}"
        );
    }
}

#[test]
fn arcs_in_a_pocket_shrink_and_those_round_a_plate_grow_by_the_radius() {
    assert_radii(&path_of(POCKET, 3.0), &[5.0; 4]);
    assert_radii(&path_of(SLOT, 2.5), &[3.5; 4]);
    // Corners of 1/4 inch from outside, a bore of 1/2 inch radius from inside.
    let (corner, bore) = (6.35 + 2.0, 12.7 - 2.0);
    assert_radii(&path_of(INCH_PLATE, 2.0), &[corner, corner, corner, corner, bore]);
    // G41 to the right of an arc that turns left: inside it.
    assert_radii(&path_of(INCREMENTAL, 2.0), &[5.0 - 2.0]);
}

#[test]
fn the_path_of_a_cam_stays_at_the_radius_from_its_contour() {
    let read = interpret(&Program::parse(CAM, Dialect::Auto), Rules::default());
    let contour = read
        .items
        .iter()
        .find_map(|item| if let Item::Contour(found) = item { Some(&found.contour) } else { None })
        .expect("a contour");
    let radius = 4.0;
    let path = path_of(CAM, radius);
    // The contour as points 0.005 mm apart and less: nearer than that no point is missed by 1e-6.
    let mut points = Vec::new();
    for segment in contour.segments() {
        let steps = 20_000;
        points.extend((0..=steps).map(|i| segment.curve.point(f64::from(i) / f64::from(steps))));
    }
    for found in path.moves.iter().filter(|m| m.role == Role::Segment && m.heights[0] == -4.0) {
        for i in 0..=4 {
            let at = found.curve.point(f64::from(i) / 4.0);
            let nearest = points.iter().map(|p| p.distance(at)).fold(f64::INFINITY, f64::min);
            assert!((nearest - radius).abs() < 0.0011, "{nearest} at {at}: {found:?}");
        }
    }
}

#[test]
fn each_contour_has_the_radius_of_its_own_tool() {
    let text = "G0 X0 Y-20\nG41 D1 G1 X0 Y0 F600\nX50\nG40 X50 Y-20\nX0 Y-20\n\
                G41 D2 X0 Y0\nX50\nG40 X50 Y-20\nX0 Y-20\nG42.1 D8 X0 Y0\nX50\nG40 X50 Y-20\nM30\n";
    let [first, second] = [(1, 3.0), (2, 5.0)].map(|(number, radius)| ListedTool {
        number,
        size: ToolSize::Radius(radius),
        orientation: 0,
    });
    let tools = Tools { listed: vec![first, second], ..Tools::default() };
    let path = path_with(text, &tools);
    let heights: Vec<f64> =
        path.moves.iter().filter(|m| m.role == Role::Segment).map(|m| m.curve.end().y).collect();
    assert_eq!(heights, [3.0, 5.0, -4.0], "{:?}", path.diagnostics);
}

#[test]
fn a_diameter_without_a_unit_counts_in_the_unit_at_the_word_that_switches_on() {
    let quarter = ListedTool { number: 1, size: ToolSize::Diameter(0.25), orientation: 0 };
    let tools = Tools { listed: vec![quarter], default_radius: Some(9.0) };
    for (text, radius) in [
        ("G21\nG0 X0 Y-20\nG41 D1 G1 X0 Y0 F600\nX50\nG40 Y-20\n", 0.125),
        ("G20\nG0 X0 Y-2\nG41 D1 G1 X0 Y0 F60\nX5\nG40 Y-2\n", 3.175),
        ("G20 T1\nG0 X0 Y-2\nG42 G1 X0 Y0 F60\nG21 X50\nG40 Y-20\n", -3.175),
        ("G20\nG0 X0 Y-2\nG41 D2 G1 X0 Y0 F60\nX5\nG40 Y-2\n", 9.0),
    ] {
        let path = path_with(text, &tools);
        let cut = path.moves.iter().find(|step| step.role == Role::Segment).expect("one segment");
        assert!((cut.curve.end().y - radius).abs() < 1e-12, "{text}: {:?}", cut.curve);
    }
}

#[test]
fn a_tool_without_radius_is_reported_and_passes_as_programmed() {
    let text = "G0 X0 Y-20\nG41 D7 G1 X0 Y0 F600\nX50\nG40 Y-20\n";
    for (tools, says) in [
        (Tools::default(), "tool 7 is not known"),
        (Tools::all(f64::NAN), "no radius"),
        (Tools::all(f64::INFINITY), "no radius"),
    ] {
        let path = path_with(text, &tools);
        assert_eq!(codes(&path), [("missing-radius", Severity::Error)], "{says}");
        assert!(path.diagnostics[0].message.contains(says), "{}", path.diagnostics[0]);
        let ends: Vec<_> = path.moves.iter().map(|m| m.curve.end().to_array()).collect();
        assert_eq!(ends, [[0.0, -20.0], [0.0, 0.0], [50.0, 0.0], [50.0, -20.0]], "{says}");
    }
}

#[test]
fn without_a_lead_out_the_tool_goes_on_from_where_it_is() {
    let text = "G0 X0 Y-20\nG41 D1 G1 X0 Y0 F600\nX50\nG40\nG0 Z9\nM30\n";
    let path = path_of(text, 3.0);
    let last = path.moves[path.moves.len() - 1];
    assert_eq!(last.curve, MoveCurve::Vertical(DVec2::new(50.0, 3.0)), "it retracts in place");
    let end = path.words.last().expect("M30 is passed on");
    assert_eq!((end.words.as_str(), end.before), ("M30", path.moves.len()), "M30 comes last");

    let text = "G0 X0 Y-20\nG41 D1 G1 X0 Y0 F600\nX50\nG40\nG41 Y30\nX90\nG40 Y0\n";
    let path = path_of(text, 3.0);
    assert_eq!(codes(&path), [("no-lead-out", Severity::Warning)], "{:?}", path.diagnostics);
    let ends: Vec<_> = path.moves.iter().map(|m| m.curve.end().to_array()).collect();
    assert!(
        ends.windows(2).any(|p| p == [[50.0, 3.0], [47.0, 30.0]]),
        "clear of the part: {ends:?}"
    );

    let text = "G0 X0 Y-20\nG41 D1 G1 X0 Y0 F600\nX50\nG40 G2 X60 Y10 R10\n";
    let path = path_of(text, 3.0);
    assert_eq!(codes(&path), [("curved-lead-out", Severity::Error)], "an arc cannot lead out");
    let ends: Vec<_> = path.moves.iter().rev().take(3).map(|m| m.curve.end().to_array()).collect();
    assert_eq!(ends, [[60.0, 10.0], [50.0, 0.0], [50.0, 3.0]], "straight to the arc's start");
}

#[test]
fn a_change_of_side_goes_straight_across() {
    let text = "G0 X0 Y-20\nG41 D1 G1 X0 Y0 F600\nX50\nG42 X90\nG40 Y-20\n";
    let path = path_of(text, 3.0);
    assert_eq!(codes(&path), [("side-changed", Severity::Warning)], "{:?}", path.diagnostics);
    let ends: Vec<_> = path.moves.iter().map(|m| m.curve.end().to_array()).collect();
    assert!(ends.windows(2).any(|p| p == [[50.0, 3.0], [50.0, -3.0]]), "{ends:?}");
}

#[test]
fn words_between_segments_stand_between_their_moves() {
    let text = "G0 X0 Y-20\nM3 S800\nG41 D1 G1 X0 Y0 F600\nX50\nM8\nX90\nM9\nG40 Y-20\nM30\n";
    let path = path_of(text, 3.0);
    let written = emit(&path, &EmitOptions::default()).text;
    let lines: Vec<&str> = written.lines().collect();
    let place = |line: &str| lines.iter().position(|l| *l == line).expect("the line is there");
    assert!(place("S800 M3") < place("X50") && place("X50") < place("M8"), "{written}");
    assert!(place("M8") < place("M9") && place("M9") < place("X90 Y-20"), "{written}");
}

#[test]
fn a_move_along_z_while_compensated_happens_beside_the_contour() {
    let text = "G0 X0 Y-20\nG41 D1 G1 X0 Y0 F600\nX50\nZ-2\nX90\nG40 Y-20\n";
    let path = path_of(text, 3.0);
    let plunge = path.moves.iter().find(|m| m.curve.length() == 0.0).expect("it is there");
    assert_eq!(plunge.curve, MoveCurve::Vertical(DVec2::new(50.0, 3.0)), "beside");
    assert_eq!(plunge.heights, [0.0, -2.0], "down");
}

#[test]
fn a_lead_that_starts_or_ends_beside_the_contour_keeps_its_change_of_height() {
    for text in [
        "G0 X0 Y3 Z5\nG41 D1 G1 X0 Y0 Z-2 F600\nX50\nG40 X50 Y9\nG0 Z9\n",
        "G0 X0 Y-9 Z5\nG41 D1 G1 X0 Y0 F600\nX50\nG40 X50 Y3 Z8\nG0 Z9\n",
    ] {
        let path = path_of(text, 3.0);
        assert_eq!(codes(&path), [], "{:?}", path.diagnostics);
        for pair in path.moves.windows(2) {
            assert!(
                (pair[0].heights[1] - pair[1].heights[0]).abs() < 1e-9,
                "{text}\n{:?}",
                path.moves
            );
        }
        let plunge = path.moves.iter().find(|m| m.curve.length() == 0.0).expect("it is there");
        assert_eq!(plunge.feed, Some(10.0), "at its own feed: {plunge:?}");
    }
}

#[test]
fn what_follows_a_cycle_starts_where_it_led() {
    let text = "G0 X0 Y0 Z5\nG81 X20 Y20 Z-3 R1 F600\nG80 G41 G1 X30\nX50\nG40 X60\n";
    let ends: Vec<_> = path_of(text, 3.0).moves.iter().map(|m| m.curve.end().to_array()).collect();
    let mut expected = [[20.0, 20.0]; 8];
    expected[0] = [0.0, 0.0];
    expected[5..].copy_from_slice(&[[30.0, 23.0], [50.0, 23.0], [60.0, 20.0]]);
    assert_eq!(ends, expected, "over the hole to the lead-in");
}

#[test]
fn a_lead_shorter_than_the_radius_is_reported() {
    let text = "G0 X-2 Y0\nG41 D1 G1 X0 Y0 F600\nX50\nG40 X52\n";
    let warning = Severity::Warning;
    let expected = [("short-lead-in", warning), ("short-lead-out", warning)];
    assert_eq!(codes(&path_of(text, 3.0)), expected, "3 mm");
    assert_eq!(codes(&path_of(text, 1.0)), [], "1 mm");
}

/// A contour without a bend, then one with a round groove of radius 3 mm.
const TOO_NARROW: &str = "G0 X-20 Y-20\nG1 G41 D1 X0 Y0 F300\nY20\nG40 X-20\nG41 D1 X0 Y0\nX20\n\
     G3 X26 Y0 I3 J0\nG1 X40\nG40 X60\n";

#[test]
fn one_gouge_stops_the_whole_program() {
    let read = interpret(&Program::parse(TOO_NARROW, Dialect::Auto), Rules::default());
    let with = |radius, gouge| {
        let options = Options { gouge, ..Options::default() };
        compensate_program(&read, &Tools::all(radius), &options)
    };
    let stopped = with(4.0, GougePolicy::Stop);
    assert!(stopped.moves.is_empty() && stopped.words.is_empty(), "{stopped:?}");
    assert_eq!(stopped.diagnostics.last().map(|d| d.code), Some("stopped"), "what it says");
    assert!(!with(4.0, GougePolicy::Report).moves.is_empty(), "reported only");
    assert_eq!(with(2.0, GougePolicy::Stop), with(2.0, GougePolicy::Report), "a tool that fits");
}

fn avoided(text: &str, radius: f64) -> ToolPath {
    let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
    let options = Options { gouge: GougePolicy::Avoid, ..Options::default() };
    compensate_program(&read, &Tools::all(radius), &options)
}

#[test]
fn every_program_avoids_what_it_need_not_cut_and_keeps_its_frame() {
    for text in ALL {
        let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
        for radius in [0.5, 2.0, 6.0] {
            let path = avoided(text, radius);
            let tools = Tools::all(radius);
            let leads = path.diagnostics.iter().filter(|d| d.code == "lead-gouge").count();
            let gouges = check_program(&read, &path, &tools, 1e-3);
            assert!(gouges.len() <= leads, "radius {radius}: {gouges:?}\n{:?}", path.diagnostics);
            let frame = |path: &ToolPath| {
                let free = path.moves.iter().filter(|step| step.role == Role::Free);
                (free.count(), path.words.iter().map(|w| w.words.clone()).collect::<Vec<_>>())
            };
            assert_eq!(frame(&path), frame(&path_of(text, radius)), "radius {radius}: {text}");
        }
    }
}

/// Two rooms of 20 by 20 mm, a corridor of 6 by 10 mm between them; led in to the first, and out of it.
const ROOMS: &str = "G0 Z8\nG0 X10 Y10\nG1 Z-2 F100\nG1 G41 D1 X10 Y0 F400\nX20\nY7\nX30\nY0\nX50\n\
     Y20\nX30\nY13\nX20\nY20\nX0\nY0\nX10\nG40 Y10\nG0 Z8\nM30\n";

#[test]
fn a_room_behind_a_corridor_is_crossed_to_above_the_part() {
    let read = interpret(&Program::parse(ROOMS, Dialect::Auto), Rules::default());
    let options =
        Options { gouge: GougePolicy::Avoid, corner: CornerStyle::Arc, ..Options::default() };
    let path = compensate_program(&read, &Tools::all(4.0), &options);
    assert_eq!(check_program(&read, &path, &Tools::all(4.0), 1e-3), [], "the judge");
    let written = emit(&path, &EmitOptions::default());
    assert_eq!(written.diagnostics, [], "{}", written.text);
    // Down twice as the program goes down, up between.
    assert_eq!(written.text.matches("G1 Z-2 F100").count(), 2, "{}", written.text);
    assert_eq!(written.text.matches("F400").count(), 2, "{}", written.text);
    let flat = ROOMS.replace("G0 Z8\n", "");
    let read = interpret(&Program::parse(&flat, Dialect::Auto), Rules::default());
    let path = compensate_program(&read, &Tools::all(4.0), &options);
    let written = emit(&path, &EmitOptions::default());
    let codes: Vec<_> = written.diagnostics.iter().map(|d| d.code).collect();
    assert_eq!(codes, ["no-clearance"], "it comes at the height 0 only: {}", written.text);
}

/// Inverse-time feed (G93): the moves of each block take as long as it says, whatever
/// compensation has made of them.
#[test]
fn the_moves_of_a_block_together_take_the_time_that_it_says() {
    let text = "G21 G0 X-20 Y0 Z5\nG93 G1 Z0 F4\nG42 D1 X0 F2\nX40 F1\nY20 F0.5\nG1 Z-1 F8\n\
                G2 X50 Y30 I10 J0 F2\nG3 X50 Y50 I0 J10 Z2 F0.25\nG40 G1 Y90 F3\nX0 F5\nM2\n";
    let minutes = [
        (2, 4.0),
        (3, 2.0),
        (4, 1.0),
        (5, 0.5),
        (6, 8.0),
        (7, 2.0),
        (8, 0.25),
        (9, 3.0),
        (10, 5.0),
    ];
    let path = path_of(text, 3.0);
    assert_eq!(codes(&path), [], "{:?}", path.diagnostics);
    for (line, per_minute) in minutes {
        let is_own =
            |step: &&Move| matches!(step.origin, Origin::Block { line: l, .. } if l == line);
        let own: Vec<&Move> = path.moves.iter().filter(is_own).collect();
        assert!(!own.is_empty(), "line {line} moves");
        let time: f64 = own
            .iter()
            .map(|step| {
                let climb = step.heights[1] - step.heights[0];
                step.curve.length().hypot(climb) / step.feed.expect("a feed")
            })
            .sum();
        assert!((time * per_minute - 60.0).abs() < 1e-9, "line {line}: {time} s");
    }
}

#[test]
fn a_subprogram_called_at_two_places_is_judged_place_by_place() {
    // The second call runs 4 mm beside the first: nearer to its wall than the radius.
    let text = "o1 sub\nG91\nG1 G41 D1 Y-10 F300\nX30\nG40 Y10\nG90\no1 endsub\n\
                G0 X0 Y20\no1 call\nG0 X0 Y16\no1 call\nM2\n";
    let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
    let tools = Tools::all(3.0);
    let path = compensate_program(&read, &tools, &Options::default());
    assert_eq!(path.contours.len(), 2, "{:?}", path.contours);
    assert_eq!(check_program(&read, &path, &tools, 1e-3), [], "each is clear of its own");
    let mut swapped = path;
    swapped.contours.swap(0, 1);
    let found = check_program(&read, &swapped, &tools, 1e-3);
    assert!(!found.is_empty(), "held against each other they are too near");
}

/// The places of gouges, sorted, with their depths.
fn places(gouges: &[Gouge]) -> Vec<(f64, f64, f64)> {
    let tidy = |value: f64| (value * 1e6).round() / 1e6;
    let mut places: Vec<_> =
        gouges.iter().map(|g| (tidy(g.at.x), tidy(g.at.y), tidy(g.depth))).collect();
    places.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
    places
}

/// What the path of a program tells, and what the judge finds on it.
fn gouges_of(text: &str, radius: f64) -> [Vec<(f64, f64, f64)>; 2] {
    let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
    let tools = Tools::all(radius);
    let path = compensate_program(&read, &tools, &Options::default());
    let found = check_program(&read, &path, &tools, 1e-3);
    [places(&path.gouges), places(&found)]
}

/// A program that goes round so often, from the left and away to it.
fn rounds(laps: &[&str]) -> String {
    let blocks = laps.concat();
    format!("G21 G90\nG0 X-20 Y-20\nG41 D1 G1 X0 F600\n{blocks}G40 X-20 Y-20\nM30\n")
}

const SQUARE: &str = "Y50\nX50\nY0\nX0\n";

#[test]
fn a_contour_gone_round_twice_or_more_is_not_cut_by_its_laps() {
    for count in 1..5 {
        for text in [
            rounds(&vec![SQUARE; count]),
            // The same blocks each time.
            format!("O100 sub\n{SQUARE}O100 endsub\n{}", rounds(&vec!["O100 call\n"; count])),
        ] {
            assert_eq!(gouges_of(&text, 3.0), [[], []], "{text}");
        }
    }
}

#[test]
fn a_lap_may_cut_off_what_the_lap_before_it_left() {
    // A corner is rounded, and another cut off: no wall of the second lap.
    let second = "Y50\nX40\nG2 X50 Y40 J-10\nG1 Y0\nX15\nX0 Y10\n";
    for radius in [1.0, 3.0, 6.35] {
        assert_eq!(gouges_of(&rounds(&[SQUARE, second]), radius), [[], []], "r {radius}");
        let [told, found] = gouges_of(&rounds(&[second, SQUARE]), radius);
        assert!(
            !told.is_empty() && !found.is_empty(),
            "the first lap cuts the corners of the second: r {radius}"
        );
    }
}

#[test]
fn what_every_lap_cuts_is_told_once() {
    // A slot 4 mm wide and 20 deep, and a tool of 6.
    let slotted = "Y50\nX20\nY30\nX24\nY50\nX50\nY0\nX0\n";
    let [told, found] = gouges_of(&rounds(&[slotted]), 3.0);
    assert!(!told.is_empty() && !found.is_empty(), "the slot is too narrow");
    for count in 2..4 {
        let again = gouges_of(&rounds(&vec![slotted; count]), 3.0);
        assert_eq!(again, [told.clone(), found.clone()], "{count} laps");
    }
    for laps in [[SQUARE, slotted], [slotted, SQUARE]] {
        let [told, found] = gouges_of(&rounds(&laps), 3.0);
        let at_slot = |&(x, y, _): &(f64, f64, f64)| (19.0..25.0).contains(&x) && y > 29.0;
        assert!(told.iter().any(at_slot), "{laps:?}: {told:?}");
        assert!(found.iter().any(at_slot), "{laps:?}: {found:?}");
    }
}
