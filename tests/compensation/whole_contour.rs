//! Gouges between distant parts of a contour, reported with both segments, place and depth.

use std::f64::consts::TAU;

use g41::compensation::{CornerStyle, GougePolicy, Options, compensate, compensate_all};
use g41::contour::{GougeKind, Side, Tool};
use g41::diagnostic::Origin;
use g41::gouge::check;
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::random_contours::{star, wandering};
use super::sketch::{Sketch, line, spline};
use crate::common::random::Random;
use crate::common::{near, near_point, p};

const CASES: u32 = if cfg!(target_arch = "wasm32") { 60 } else { 600 };

fn tool(radius: f64, side: Side) -> Tool {
    Tool::new(radius, side).expect("a radius")
}

#[test]
fn two_walls_of_one_slot_are_both_named() {
    // Down into a slot 4 mm wide, along its floor and up again: a tool of 3 mm on its left.
    let slot = [(0.0, 0.0), (4.0, 0.0), (4.0, 50.0)].map(|(x, y)| line(p(x, y)));
    let contour = Sketch::open(p(0.0, 50.0), slot).contour();
    let path = compensate(&contour, tool(3.0, Side::Left), &Options::default());
    let both = [Origin::Segment(0), Origin::Segment(2)];
    let found = path.gouges.iter().find(|gouge| both.iter().all(|o| gouge.segments.contains(o)));
    let gouge = found.unwrap_or_else(|| panic!("the walls are named: {:?}", path.gouges));
    // Three from one wall is one from the other.
    near(gouge.depth, 2.0, 1e-9, "depth");
    assert_eq!(gouge.kind, GougeKind::Bottleneck, "kind");
    assert!(gouge.at.x == 0.0 || gouge.at.x == 4.0, "the place is on a wall: {}", gouge.at);
    let said = path.diagnostics.iter().any(|d| d.code == "bottleneck-gouge" && d.depth.is_some());
    assert!(said, "a diagnostic says it: {:?}", path.diagnostics);
}

#[test]
fn a_spline_may_be_a_wall_to_itself() {
    // A spiral whose turns are 40 mm apart: a tool of 25 mm is 15 mm from the next turn.
    let growth = 40.0 / TAU;
    let at = |k: u32| DVec2::from_angle(f64::from(k) * 0.1) * (growth * f64::from(k) * 0.1);
    let points: Vec<DVec2> = (64..400).map(at).collect();
    let contour = Sketch::open(at(63), [spline(&points)]).contour();
    let path = compensate(&contour, tool(25.0, Side::Right), &Options::default());
    let deepest = path.gouges.iter().map(|gouge| gouge.depth).fold(0.0, f64::max);
    assert!(path.gouges.iter().any(|g| g.kind == GougeKind::Bottleneck), "{:?}", path.gouges);
    near(deepest, 10.0, 0.3, "25 less 15, and the turns are no circles");
}

#[test]
fn contours_of_one_workpiece_are_walls_to_each_other() {
    let low = Sketch::open(p(0.0, 0.0), [line(p(40.0, 0.0))]).contour();
    let high = Sketch::open(p(40.0, 5.0), [line(p(0.0, 5.0))]).contour();
    let mill = tool(3.0, Side::Left);
    let path = compensate_all(&[(&low, mill), (&high, mill)], &Options::default());
    assert_eq!(path.gouges.len(), 2, "each path cuts the other wall: {:?}", path.gouges);
    for gouge in &path.gouges {
        near(gouge.depth, 1.0, 1e-9, "3 of 5 mm");
    }
    let stop = Options { gouge: GougePolicy::Stop, ..Options::default() };
    let none = compensate_all(&[(&low, mill), (&high, mill)], &stop);
    assert!(none.moves.is_empty(), "a path that gouges is refused");
}

#[test]
fn a_tip_in_the_middle_of_a_long_move_is_found() {
    // A straight wall, and a thin tooth that comes down to 5 mm above its middle.
    let wall = Sketch::open(p(0.0, 0.0), [line(p(1000.0, 0.0))]).contour();
    let tooth = [line(p(437.0, 5.0)), line(p(437.5, 60.0))];
    let tooth = Sketch::open(p(436.5, 60.0), tooth).contour();
    let mill = tool(4.0, Side::Left);
    let path = compensate_all(&[(&wall, mill), (&tooth, mill)], &Options::default());
    let at_tip = path.gouges.iter().find(|gouge| gouge.at.distance(p(437.0, 5.0)) < 1e-6);
    let gouge = at_tip.unwrap_or_else(|| panic!("the tip is cut: {:?}", path.gouges));
    near(gouge.depth, 3.0, 1e-9, "4 mm above the wall is 1 mm below the tip");
    near_point(gouge.at, p(437.0, 5.0), 1e-9, "place");
}

#[test]
fn the_report_and_the_judge_agree() {
    for case in 0..CASES {
        let mut random = Random::new(u64::from(case) ^ 0x71d);
        let sketch = if random.coin() { star(&mut random) } else { wandering(&mut random) };
        let contour = sketch.contour();
        let radius = 10.0_f64.powf(random.within(-1.0, 1.6));
        let side = if random.coin() { Side::Left } else { Side::Right };
        let corner = if random.coin() { CornerStyle::Arc } else { CornerStyle::Linear };
        let options = Options { corner, ..Options::default() };
        let path = compensate(&contour, tool(radius, side), &options);
        let judged = check(&contour, &path, radius, options.tolerance);
        let deepest = |gouges: &[g41::contour::Gouge]| {
            gouges.iter().map(|gouge| gouge.depth).fold(0.0, f64::max)
        };
        let (told, found) = (deepest(&path.gouges), deepest(&judged));
        let what = format!("case {case}, r = {radius}, {side:?}, {corner:?}, {sketch:?}");
        // What is barely deeper than the tolerance may be found by one of the two only.
        if found > 2.0 * options.tolerance {
            assert!(told > 0.0, "{found} deep and not reported: {what}");
            assert!(
                (told - found).abs() <= 0.05 * found + 0.01 * radius,
                "{told} told, {found} found: {what}"
            );
        } else {
            assert!(told <= 3.0 * options.tolerance, "{told} told, {found} found: {what}");
        }
    }
}

#[test]
fn laps_over_each_other_are_told_and_avoided_as_the_judge_has_it() {
    // 25 laps of 80 lines, each of another radius than the last: paths cross and lie close.
    let at = |k: u32| {
        let angle = TAU * f64::from(k) / 80.0;
        DVec2::from_angle(angle) * (50.0 + 8.0 * (0.37 * angle).sin())
    };
    let contour = Sketch::open(at(0), (1..2_000).map(|k| line(at(k)))).contour();
    for side in [Side::Left, Side::Right] {
        let mill = tool(1.5, side);
        let options = Options { gouge: GougePolicy::Avoid, ..Options::default() };
        let avoided = compensate_all(&[(&contour, mill)], &options);
        assert!(!avoided.moves.is_empty(), "some of it is reached, {side:?}");
        let found = check(&contour, &avoided, 1.5, options.tolerance);
        assert!(found.is_empty(), "nothing is cut, {side:?}: {found:?}");
        let told = compensate(&contour, mill, &Options::default());
        let deepest =
            |gouges: &[g41::contour::Gouge]| gouges.iter().map(|g| g.depth).fold(0.0, f64::max);
        let judged = check(&contour, &told, 1.5, options.tolerance);
        near(deepest(&told.gouges), deepest(&judged), 1e-6, "the deepest gouge");
    }
}

#[test]
fn a_contour_gone_round_five_times_has_a_path_that_is_five_times_as_long() {
    let at = |k: u32| DVec2::from_angle(TAU * f64::from(k) / 500.0) * 50.0;
    let contour = Sketch::open(at(0), (1..=2_500).map(|k| line(at(k)))).contour();
    for gouge in [GougePolicy::Report, GougePolicy::Avoid] {
        let options = Options { gouge, ..Options::default() };
        let path = compensate_all(&[(&contour, tool(1.5, Side::Left))], &options);
        assert!(path.gouges.is_empty(), "the tool fits: {:?}", path.gouges);
        assert_eq!(path.moves.len(), 2_500, "one move for each line");
        let length: f64 = path.moves.iter().map(|one| one.curve.length()).sum();
        // Sides of a polygon about a circle that is smaller by the tool. Both ends are square, and so
        // beyond the corners of the other laps: less than the tolerance too near, and cut off where
        // gouges are avoided.
        let half = (TAU / 1_000.0).tan();
        let side = 2.0 * (50.0 * (TAU / 1_000.0).cos() - 1.5) * half;
        let square = if gouge == GougePolicy::Report { 2.0 * 1.5 * half } else { 0.0 };
        near(length, 2_500.0 * side + square, 1e-6, "length");
    }
}
