//! G93, G94 and G95: the feed of a move by the way it is programmed.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::sample::{found, moves, only_contour, read, read_clean, words};

fn feeds(text: &str) -> Vec<Option<f64>> {
    moves(&read_clean(text)).iter().map(|m| m.feed).collect()
}

#[test]
fn inverse_time_feeds_make_each_move_in_its_time() {
    // F2 is half a minute: 30 mm of length, (10, 20, 20), at 1 mm/s.
    assert_eq!(feeds("G93 G1 X10 Y20 Z20 F2"), [Some(1.0)], "a line in space");
    // A quarter of a circle of radius 20: 31.416 mm in a second.
    let feed = feeds("G0 X20 Y0\nG93 G3 X0 Y20 I-20 F60")[1].expect("it feeds");
    assert!((feed - 10.0 * std::f64::consts::PI).abs() < 1e-9, "{feed}");
    let spline = feeds("G0 X0 Y0\nG93 G5 X10 Y0 F60\nX20 F60\nX40 F60");
    let each: Vec<f64> = spline.iter().flatten().copied().collect();
    assert!(each.len() == 3 && each.iter().all(|f| (f - 40.0 / 3.0).abs() < 1e-9), "{each:?}");
    let turns = feeds("G0 X10 Y0\nG93 G3 I-10 P2 F60");
    let each = 40.0 * std::f64::consts::PI;
    assert!(turns[1..].iter().all(|f| (f.expect("it feeds") - each).abs() < 1e-9), "{turns:?}");
    let again = feeds("G94 F60 G1 X1\nG93 X2 F60\nG94 X3 F120\nX4");
    assert_eq!(again, [Some(1.0), Some(1.0), Some(2.0), Some(2.0)], "and back");
}

#[test]
fn inverse_time_needs_a_feed_in_every_block_that_feeds() {
    let read = read("G93 G1 X1 F60\nX2\nG0 X3\nG1 X4 F60\n");
    let codes: Vec<_> = found(&read).iter().map(|f| (f.0, f.2)).collect();
    assert_eq!(codes, [("missing-feed", 2)], "{:?}", read.diagnostics);
    assert_eq!(moves(&read)[1].feed, None, "the feed before does not count");
}

#[test]
fn segments_under_inverse_time_carry_their_time() {
    let read = read_clean("G0 X0 Y-9\nG41 D1 G1 X0 Y0 F60\nG93 X30 F12\nG40 G94 Y-9 F60\n");
    let attributes = only_contour(&read).contour.segments()[0].attributes;
    assert_eq!((attributes.time, attributes.feed), (Some(5.0), None), "a twelfth of a minute");
}

#[test]
fn feeds_per_revolution_follow_the_speed() {
    assert_eq!(feeds("S600 M3\nG95 G1 X1 F0.2\nS1200\nX2"), [Some(2.0), Some(4.0)], "0.2 mm/rev");
    assert_eq!(feeds("G20 S600 M3\nG95 G1 X1 F.01"), [Some(2.54)], "0.01 inch/rev");
    let read = read("G96 S200 D3000 M3\nG95 G1 X1 F0.2\n");
    let codes: Vec<_> = found(&read).iter().map(|f| f.0).collect();
    assert_eq!(codes, ["unknown-speed"], "the surface speed alone: {:?}", read.diagnostics);
    assert_eq!(words(&read), ["G96 D3000 S200 M3"], "passed on");
}

#[test]
fn surface_speeds_in_feet_are_passed_on_in_metres() {
    let read = read_clean("G20 G96 S1000 M3\nG97 S800\n");
    assert_eq!(words(&read), ["G96 S304.8 M3", "G97 S800"], "1000 ft/min; G97 ends it");
    assert!(words(&read_clean("G97 G94")).is_empty(), "nothing ends where nothing began");
}

#[test]
fn a_feed_in_another_mode_does_not_count() {
    let feeds = feeds("G1 X1 F600\nG95 S60 M3\nX2\nG94\nX3");
    assert_eq!(feeds, [Some(10.0), None, None], "F is to be stated again");
}

#[test]
fn feeds_keep_their_speed_when_the_unit_changes() {
    let found = feeds("G20 G1 X1 F60\nG21 X1\nX2 F60");
    assert_eq!(found, [Some(25.4), Some(25.4), Some(1.0)], "in the unit of its word");
    assert_eq!(feeds("F120\nG1 X1\nF60\nX2"), [Some(2.0), Some(1.0)], "without a move");
}
