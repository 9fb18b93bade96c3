//! Coordinates: what words for coordinate systems and transformations make of them.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::contour::{MoveCurve, Side};
use g41::program::{Dialect, Item, RadiusSource};

use super::sample::{
    codes, found, moves, near, only_contour, read, read_as_fanuc, read_clean, steps, words,
};

#[test]
fn an_origin_that_is_moved_gives_the_place_another_number() {
    let read = read_clean("G0 X10 Y20 Z5\nG92 X0 Y0\nX5\nG91 Y3\nG90 G92.1\nX50\n");
    let expected = ["R 10 20 5", "G92 X0 Y0", "R 5 0 5", "R 5 3 5", "G92.1", "R 50 23 5"];
    assert_eq!(steps(&read), expected, "the tool was at X15 Y23 when G92.1 came");
    let starts: Vec<_> = moves(&read).iter().map(|m| m.curve.start().to_array()).collect();
    assert_eq!(starts, [[0.0, 0.0], [0.0, 0.0], [5.0, 0.0], [15.0, 23.0]], "where moves start");
    let kept = read_clean("G0 X10 Y20\nG92 X0\nG92.2\nX7\nG92.3\nX7\n");
    assert_eq!(steps(&kept)[2..], ["G92.2", "R 7 20 0", "G92.3", "R 7 20 0"], "kept and taken up");
    assert_eq!(moves(&kept)[2].curve.start().x, -3.0, "7 is -3 again");
}

#[test]
fn origins_that_the_program_sets_tell_the_way_from_one_to_another() {
    let text = "G10 L2 P1 X100 Y0 Z0\nG10 L2 P2 X130 Y10 Z0\nG54 G0 X40 Y20 Z5\nG55 X0\n";
    let read = read_clean(text);
    let moves = moves(&read);
    assert!(near(moves[1].curve.start(), [10.0, 10.0]), "30 and 10 less: {moves:?}");
    assert!(near(moves[1].curve.end(), [0.0, 10.0]), "{moves:?}");
    let expected = ["G10 L2 P1 X100 Y0 Z0", "G10 L2 P2 X130 Y10 Z0", "G54", "G55"];
    assert_eq!(words(&read), expected, "passed on");
    let by_place = read_clean("G54 G0 X5 Y5\nG20 G10 L20 P1 X1\nG91 X1\n");
    let ends: Vec<_> = super::sample::moves(&by_place).iter().map(|m| m.curve.end().x).collect();
    assert_eq!(ends, [5.0, 50.8], "the place is at an inch");
    assert_eq!(words(&by_place)[1], "G10 L20 P1 X25.4", "in millimetres");
}

#[test]
fn an_axis_that_is_not_stated_in_a_new_system_is_not_assumed() {
    let read = read_clean("G54 G0 X10 Y5 Z9\nG55 X20\nY5\nG0 Z9\n");
    assert_eq!(steps(&read), ["G54", "R 10 5 9", "G55", "R 20 5 9", "G0 Y5", "G0 Z9"], "{read:?}");
}

#[test]
fn moves_by_the_machine_are_passed_on_and_forget_their_axes() {
    for (text, expected) in [
        ("G91 G28 Z0\nG90 G0 X1 Y2\nZ9", vec!["G91 G28 Z0", "G90", "R 1 2 9", "G0 Z9"]),
        ("G28\nG0 X3 Y4", vec!["G28", "G0 X3 Y4"]),
        ("G53 G0 Z0\nX5\nZ9", vec!["G53 G0 Z0", "R 5 4 9", "G0 Z9"]),
        ("G20 G53 G1 X1 F10\nG0 Y1", vec!["G53 G1 X25.4 F254", "R 3 25.4 9"]),
        ("G30 X1 Y2\nG28.1", vec!["G30 X1 Y2", "G28.1"]),
        ("G30 P2 X1", vec!["G30 X1 P2"]),
    ] {
        let read = read_clean(&format!("G0 X3 Y4 Z9\n{text}\n"));
        assert_eq!(steps(&read)[1..], expected, "{text}");
    }
}

#[test]
fn a_local_system_is_resolved() {
    let read = read_clean("G0 X1 Y1\nG52 X100 Y50\nX1 Y1\nG91 X2\nG90 G52 X0 Y0\nX1\n");
    let expected = ["R 1 1 0", "R 101 51 0", "R 103 51 0", "R 1 51 0"];
    assert_eq!(steps(&read), expected, "in the coordinates of the machine's system");
}

#[test]
fn a_rotation_turns_points_and_centres() {
    let read = read_clean("G0 X0 Y0\nG68 X10 Y0 R90\nG1 X20 Y0 F60\nG3 X10 Y10 I-10\nG69\nG0 X1\n");
    let moves = moves(&read);
    let last = moves.len() - 1;
    assert!(near(moves[last - 2].curve.end(), [10.0, 10.0]), "{moves:?}");
    let MoveCurve::Arc(arc) = moves[last - 1].curve else { panic!("{moves:?}") };
    assert!(near(arc.center(), [10.0, 0.0]) && near(arc.end(), [0.0, 0.0]), "{arc:?}");
    assert!(arc.sweep() > 0.0, "it turns as before");
    assert!(near(moves[last].curve.end(), [1.0, 0.0]), "{moves:?}");
}

#[test]
fn a_mirror_turns_arcs_and_sides_round() {
    let contour = "X0 Y-20\nG41 D1 G1 X10 Y0 F100\nX20\nG3 X30 Y10 J10\nG40 G1 X30 Y40\n";
    let plain = read_clean(&format!("G0 {contour}"));
    let mirrored = read_clean(&format!("G51.1 X0\nG0 {contour}G50.1 X0\nG0 X5\n"));
    let (a, b) = (only_contour(&plain), only_contour(&mirrored));
    assert_eq!((a.side, b.side), (Side::Left, Side::Right), "sides");
    for (a, b) in a.contour.segments().iter().zip(b.contour.segments()) {
        let [from, to] = [a.curve.end(), b.curve.end()];
        assert!(near(to, [-from.x, from.y]), "{a:?} {b:?}");
    }
    assert!(moves(&mirrored).last().expect("X5").curve.end().x == 5.0, "no mirror any more");
    let twice = read_clean(&format!("G51.1 X0 Y0\nG0 {contour}"));
    assert_eq!(only_contour(&twice).side, Side::Left, "two mirrors turn it back");
}

#[test]
fn scales_keep_arcs_round_or_say_that_they_do_not() {
    let read = read_clean("G51 X0 Y0 Z0 P2.\nG0 X10 Y0 Z5\nG3 X0 Y10 R10 F60\nG50 G0 X1\n");
    let MoveCurve::Arc(arc) = moves(&read)[1].curve else { panic!("{read:?}") };
    assert!((arc.radius() - 20.0).abs() < 1e-9, "{arc:?}");
    assert_eq!(moves(&read)[0].heights, [0.0, 10.0], "all axes");
    let uneven = super::sample::read("G51 X0 Y0 I2. J3.\nG0 X10 Y0\nG3 X0 Y10 R10 F60\n");
    let codes: Vec<_> = found(&uneven).iter().map(|f| f.0).collect();
    assert_eq!(codes, ["arc-distorted"], "{uneven:?}");
    let thousandths = super::sample::read("G51 X0 Y0 P500\nG0 X10 Y10\n");
    assert!(near(moves(&thousandths)[0].curve.end(), [5.0, 5.0]), "{thousandths:?}");
}

#[test]
fn polar_coordinates_count_from_the_origin_or_the_place() {
    let read = read_clean("G0 X5 Y5\nG16 X10 Y90\nY180\nG91 Y90\nG15 G90 X0\n");
    let ends: Vec<_> = moves(&read).iter().map(|m| m.curve.end()).collect();
    for (end, expected) in ends.iter().zip([[5.0, 5.0], [0.0, 10.0], [-10.0, 0.0], [0.0, -10.0]]) {
        assert!(near(*end, expected), "{ends:?}");
    }
    let read = read_clean("G0 X5 Y5\nG91 G16 X10 Y0\nX10 Y90\n");
    let ends: Vec<_> = moves(&read).iter().map(|m| m.curve.end()).collect();
    assert!(near(ends[1], [15.0, 5.0]) && near(ends[2], [15.0, 15.0]), "{ends:?}");
}

#[test]
fn polar_words_go_by_radius_and_angle() {
    // LinuxCNC: an omitted one keeps its value; incremental ones are added to the present.
    let ends = |text: &str| -> Vec<glam::DVec2> {
        moves(&read_clean(text)).iter().map(|m| m.curve.end()).collect()
    };
    let absolute = ends("G0 @10 ^0\n^90\n@5\n@3 ^180 Z2\n");
    for (end, expected) in absolute.iter().zip([[10.0, 0.0], [0.0, 10.0], [0.0, 5.0], [-3.0, 0.0]])
    {
        assert!(near(*end, expected), "{absolute:?}");
    }
    let incremental = ends("G0 X10 Y0\nG91 ^90\n@5 ^90\n");
    assert!(near(incremental[1], [0.0, 10.0]), "{incremental:?}");
    assert!(near(incremental[2], [-15.0, 0.0]), "{incremental:?}");
    let holes = ends("G0 X2 Y0 Z5\nG91 G99 G81 ^45 Z-3 R-4 L4 F60\n");
    let last = holes.last().expect("holes");
    assert!(near(*last, [-2.0, 0.0]), "each turns on by 45 degrees: {holes:?}");
}

#[test]
fn g10_gives_tools_their_radius() {
    let radius = |words: &str| {
        let text = format!("{words}\nG0 X0 Y-9\nG41 D3 G1 X0 Y0 F100\nX9\nG40 Y-9\n");
        only_contour(&read_clean(&text)).radius
    };
    assert_eq!(radius("G10 L1 P3 R2.5"), RadiusSource::Given(2.5), "in millimetres");
    assert_eq!(radius("G20 G10 L1 P3 R.1\nG21"), RadiusSource::Given(2.54), "in inches");
    assert_eq!(radius("G10 L1 P4 R2.5"), RadiusSource::Tool(3), "of another tool");
    assert_eq!(radius("G10 L12 P3 R4"), RadiusSource::Given(4.0), "FANUC's D");
}

#[test]
fn length_compensation_leaves_the_height_to_be_stated() {
    let read = read_clean("G49\nG0 X1 Y1 Z5\nG43 H3 Z5\nG1 X4 F60\nG49\nG43.1 Z2\n");
    let expected = ["R 1 1 5", "G43 H3", "G0 Z5", "4 1 5", "G49", "G43.1 Z2"];
    assert_eq!(steps(&read), expected, "a G49 that ends nothing is left out");
}

#[test]
fn after_g40_coordinates_may_change_without_a_lead_out() {
    for words in ["G53 G0 Z0", "G28 Z9", "G92 Z0", "G55"] {
        let text = format!("G0 X0 Y-9\nG41 D1 G1 Y0 F100\nX9\nG40\n{words}\nG0 X20\n");
        let read = read_clean(&text);
        let states = read.items.iter().find_map(|item| match item {
            Item::Words { reset: Some(reset), words, .. } if !words.is_empty() => {
                Some(reset.states)
            }
            _ => None,
        });
        // Beside the contour the tool is not where the program is: the next move says both.
        assert_eq!(states, Some([true, true, false]), "{words}: {read:?}");
    }
    let read = read_clean("G0 X0 Y-9 Z5\nG41 D1 G1 Y0 F100\nX9\nG40\nG81 X20 Z-1 R1 F60\n");
    let lead = only_contour(&read).contour.lead_out().copied().expect("it is there");
    assert!(near(lead.point, [20.0, 0.0]), "a cycle leads out: {lead:?}");
}

#[test]
fn a_frame_that_changes_in_a_contour_ends_it() {
    for words in ["G92 X0", "G52 X1", "G28 Z9", "G53 G0 Z0", "G68 X0 Y0 R10", "G10 L2 P1 X0"] {
        let text = format!("G0 X0 Y-9\nG41 D1 G1 Y0 F100\nX9\n{words}\nG1 X20\nG40 Y-9\n");
        let read = read(&text);
        let seen: Vec<_> = found(&read).iter().map(|f| (f.0, f.2)).collect();
        assert_eq!(seen, [("changed-while-on", 4)], "{words}: {:?}", read.diagnostics);
    }
}

#[test]
fn fanuc_adds_the_wear_of_a_tool_to_its_radius_and_under_g91_to_what_is_there() {
    let text =
        |words: &str| format!("{words}\nG90 G0 X0 Y-9.\nG41 D3 G1 X0 Y0 F100\nX9.\nG40 Y-9.\n");
    let cases = [
        ("G10 L12 P3 R4.\nG10 L13 P3 R.5", 4.5),
        ("G10 L13 P3 R-.5\nG10 L12 P3 R4.", 3.5),
        ("G10 L12 P3 R4.\nG10 L13 P2 R.5", 4.0),
        ("G10 L12 P3 R4.\nG91 G10 L12 P3 R-1.", 3.0),
        ("G10 L12 P3 R4.\nG10 L13 P3 R.5\nG91 G10 L13 P3 R.25", 4.75),
        ("G10 L12 P3 R4.\nG10 L13 P3 R.5\nG10 L13 P3 R0", 4.0),
    ];
    for (words, radius) in cases {
        let read = read_as_fanuc(&text(words));
        assert_eq!(only_contour(&read).radius, RadiusSource::Given(radius), "{words}");
        assert!(read.diagnostics.is_empty(), "{words}: {:?}", read.diagnostics);
    }
    let read = read_as_fanuc("G10 L12 P3 R4\nG91 G10 L12 P3 R-1\n");
    assert_eq!(words(&read), ["G10 L12 P3 R4", "G10 L12 P3 R3"], "written programs are absolute");
    let refused = [
        ("G10 L13 P3 R.5", "missing-radius", "only the machine knows the radius"),
        ("G91 G10 L12 P3 R.5", "not-supported", "only the machine knows the radius that is there"),
        ("G91 G10 L2 P1 X5.", "not-supported", "only the machine knows the origin that is there"),
    ];
    for (words, code, why) in refused {
        assert_eq!(codes(&text(words), Dialect::Fanuc), [code], "{words}: {why}");
    }
}

#[test]
fn words_of_safe_starts_and_clamps_are_no_errors() {
    let start = read_clean("G53 G90 G40\nG0 X5\nM10 P1\nM60\nG53\n");
    assert_eq!(words(&start), ["M10 P1", "M60"], "G53 leads nowhere without axes");
    let dwell = read_as_fanuc("M10 G4 P1500\n");
    assert_eq!(words(&dwell), ["M10 G4 P1.5"], "P is the time of the dwell");
}
