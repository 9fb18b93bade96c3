//! Avoidance on the whole contour: never too near, everything reachable reached, the rest reported.

use std::f64::consts::{FRAC_PI_4, SQRT_2};

use g41::compensation::{CornerStyle, Options, avoid};
use g41::contour::{Contour, Role, Side, Tool, ToolPath};
use g41::diagnostic::Severity;
use g41::gouge::check;
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::judge::{field_of, field_of_path, samples};
use super::random_contours::{star, wandering};
use super::sketch::{Sketch, arc, line};
use crate::common::random::Random;
use crate::common::{near, near_point, p};

const CASES: u32 = if cfg!(target_arch = "wasm32") { 100 } else { 1_500 };
const TOLERANCE: f64 = 1e-3;

fn options(corner: CornerStyle) -> Options {
    Options { tolerance: TOLERANCE, corner, ..Options::default() }
}

fn avoided(contour: &Contour, side: Side, radius: f64) -> ToolPath {
    avoid(contour, Tool::new(radius, side).expect("a radius"), &options(CornerStyle::Arc))
}

fn polygon(points: &[(f64, f64)]) -> Sketch {
    let start = p(points[0].0, points[0].1);
    let rest = points[1..].iter().chain(&points[..1]);
    Sketch::closed(start, rest.map(|&(x, y)| line(p(x, y))))
}

/// Two rooms of 20 by 20 mm joined by a corridor 10 mm long and `width` wide.
fn rooms(width: f64) -> Contour {
    let (low, high) = (10.0 - 0.5 * width, 10.0 + 0.5 * width);
    let left = [(0.0, 0.0), (20.0, 0.0), (20.0, low), (30.0, low), (30.0, 0.0), (50.0, 0.0)];
    let right = [(50.0, 20.0), (30.0, 20.0), (30.0, high), (20.0, high), (20.0, 20.0), (0.0, 20.0)];
    polygon(&[left, right].concat()).contour()
}

/// First moves of the pieces of a path.
fn pieces(path: &ToolPath) -> usize {
    let broken =
        |pair: &&[g41::contour::Move]| pair[0].curve.end().distance(pair[1].curve.start()) > 1e-6;
    usize::from(!path.moves.is_empty()) + path.moves.windows(2).filter(broken).count()
}

#[test]
fn random_contours_are_never_cut_and_everything_reachable_is_reached() {
    for case in 0..CASES {
        let mut random = Random::new(u64::from(case) ^ 0xa1d);
        let sketch = if random.coin() { star(&mut random) } else { wandering(&mut random) };
        let contour = sketch.contour();
        // From far smaller than the part to larger than it.
        let radius = 10.0_f64.powf(random.within(-1.0, 2.0));
        let side = if random.coin() { Side::Left } else { Side::Right };
        let path = avoided(&contour, side, radius);
        let what = format!("case {case}, r = {radius}, {side:?}");
        let field = field_of(&contour);
        for point in samples(&path, 8) {
            let distance = field.distance(point);
            assert!(
                distance >= radius - TOLERANCE,
                "{what}: {point} is {distance} from {sketch:?}"
            );
        }
        assert!(
            check(&contour, &path, radius, TOLERANCE).is_empty(),
            "{what}: the judge disagrees"
        );
        let reached = field_of_path(&path);
        for segment in contour.segments() {
            for k in 0..12 {
                let t = (f64::from(k) + 0.5) / 12.0;
                let normal = segment.curve.tangent(t).perp() * side.sign();
                let center = segment.curve.point(t) + normal * radius;
                if field.distance(center) >= radius - 1e-7 {
                    let off = reached.distance(center);
                    assert!(off <= 2.0 * TOLERANCE, "{what}: {center} is left out by {off}");
                }
            }
        }
    }
}

#[test]
fn an_inside_corner_leaves_its_fillet_uncut() {
    let square = polygon(&[(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0)]).contour();
    let path = avoided(&square, Side::Left, 3.0);
    assert_eq!(path.moves.len(), 4, "the square inside");
    assert_eq!(path.uncut.len(), 4, "a fillet at each corner");
    for uncut in &path.uncut {
        // A square of r less a quarter of a circle; the outline's chords leave up to a tolerance
        // along the arc.
        near(uncut.area, 9.0 * (1.0 - FRAC_PI_4), 5.0 * TOLERANCE, "area of a fillet");
        assert_eq!(uncut.segments.len(), 2, "both walls of the corner are named");
    }
}

#[test]
fn a_bottleneck_parts_the_path_and_is_reported_with_its_area() {
    let path = avoided(&rooms(4.0), Side::Left, 3.0);
    assert_eq!(pieces(&path), 2, "one piece in each room");
    let corridor = path.uncut.iter().find(|u| u.segments.len() == 4).expect("the corridor");
    // The corridor less a circular segment of chord 4 at both ends: its half angle is asin(2/3).
    let half = (2.0_f64 / 3.0).asin();
    let segment = 9.0 * (half - half.sin() * half.cos());
    near(corridor.area, 40.0 - 2.0 * segment, 20.0 * TOLERANCE, "area of the corridor");
}

#[test]
fn a_bottleneck_as_wide_as_the_tool_is_passed() {
    for radius in [1.9, 2.0] {
        let path = avoided(&rooms(4.0), Side::Left, radius);
        assert_eq!(pieces(&path), 1, "r = {radius} in a corridor of 4 mm");
    }
    assert_eq!(pieces(&avoided(&rooms(4.0), Side::Left, 2.01)), 2, "r = 2.01 in 4 mm");
}

#[test]
fn nothing_reachable_is_an_empty_path_and_a_diagnostic() {
    let path = avoided(&rooms(4.0), Side::Left, 12.0);
    assert!(path.moves.is_empty(), "no room for the tool");
    let errors: Vec<_> = path.diagnostics.iter().map(|d| (d.severity, d.code)).collect();
    assert_eq!(errors, [(Severity::Error, "nothing-reachable")], "what it says");
}

#[test]
fn an_island_as_a_contour_of_its_own_is_gone_round() {
    // Round the outside of a square with arcs: four sides and four quarters of a circle.
    let square = polygon(&[(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0)]).contour();
    let path = avoided(&square, Side::Right, 3.0);
    let length: f64 = path.moves.iter().map(|one| one.curve.length()).sum();
    near(length, 80.0 + 6.0 * std::f64::consts::PI, 1e-9, "length of the way round");
    assert!(path.uncut.is_empty(), "everything is reached");
}

#[test]
fn a_step_lower_than_the_radius_is_rounded_by_its_upper_corner() {
    // A floor, a step of 1 mm up, and a floor again: a tool of 5 mm rolls about the step's edge.
    let sketch = Sketch::open(
        p(-30.0, 0.0),
        [(0.0, 0.0), (0.0, 1.0), (30.0, 1.0)].map(|(x, y)| line(p(x, y))),
    );
    let path = avoided(&sketch.contour(), Side::Left, 5.0);
    assert_eq!(pieces(&path), 1, "one path");
    // It leaves the lower floor where its distance from the edge is 5: (x, 5), x² + 4² = 5².
    near_point(path.moves[0].curve.end(), p(-3.0, 5.0), 1e-6, "where it leaves the floor");
    near_point(path.moves[path.moves.len() - 1].curve.end(), p(30.0, 6.0), 1e-9, "its end");
}

#[test]
fn the_free_end_of_a_wall_is_kept_clear_of() {
    // A hook: out, back at a distance of 8 and past the start, which the tool of 5 must not touch.
    let hook = [(40.0, 0.0), (40.0, 8.0), (-40.0, 8.0)].map(|(x, y)| line(p(x, y)));
    let contour = Sketch::open(p(0.0, 0.0), hook).contour();
    let path = avoided(&contour, Side::Left, 5.0);
    let field = field_of(&contour);
    for point in samples(&path, 50) {
        assert!(field.distance(point) >= 5.0 - TOLERANCE, "{point} is too near");
    }
    // Below the upper wall at y = 3, clear of the free end (0, 0) where x² + 3² = 5².
    let first = path.moves.iter().find(|one| one.role == Role::Segment).expect("a reachable part");
    near_point(first.curve.start(), p(-4.0, 3.0), 2.0 * TOLERANCE, "where the wall's end lets go");
}

#[test]
fn leads_are_kept_where_the_contour_is_reached() {
    let slot = [(40.0, 0.0), (40.0, 30.0)].map(|(x, y)| line(p(x, y)));
    let sketch = Sketch::open(p(0.0, 0.0), slot).led(p(-20.0, 15.0), p(25.0, 60.0));
    let path = avoided(&sketch.contour(), Side::Left, 4.0);
    assert_eq!(pieces(&path), 1, "one path");
    let roles: Vec<Role> = path.moves.iter().map(|one| one.role).collect();
    assert_eq!(roles, [Role::LeadIn, Role::Segment, Role::Segment, Role::LeadOut], "its moves");
    assert_eq!(path.moves[0].curve.start(), p(-20.0, 15.0), "where the lead-in starts");
    near_point(path.moves[3].curve.end(), p(25.0, 60.0), 1e-12, "where the lead-out ends");
}

#[test]
fn linear_corners_keep_clear_too() {
    let gable =
        polygon(&[(0.0, 0.0), (30.0, 0.0), (30.0, 10.0), (15.0, 25.0), (0.0, 10.0)]).contour();
    let tool = Tool::new(4.0, Side::Right).expect("a radius");
    let path = avoid(&gable, tool, &options(CornerStyle::Linear));
    let field = field_of(&gable);
    for point in samples(&path, 20) {
        let distance = field.distance(point);
        assert!(distance >= 4.0 - 1e-9, "{point} is too near: {distance}");
        assert!(distance <= 4.0 * SQRT_2 + 1e-9, "{point} is too far: {distance}");
    }
    assert_eq!(pieces(&path), 1, "one path");
}

#[test]
fn a_wave_too_tight_for_the_tool_is_bridged_where_it_touches_both_flanks() {
    // Half circles of radius 3 as grooves in a floor: a tool of 5 hangs on their edges.
    let groove =
        [line(p(10.0, 0.0)), arc(p(16.0, 0.0), DVec2::new(13.0, 0.0), false), line(p(30.0, 0.0))];
    let contour = Sketch::open(p(0.0, 0.0), groove).contour();
    let path = avoided(&contour, Side::Left, 5.0);
    // It hangs where both edges are 5 away: (13, √(5² − 3²)) = (13, 4).
    let field = field_of_path(&path);
    assert!(field.distance(p(13.0, 4.0)) <= TOLERANCE, "the tool hangs on both edges");
    near(path.uncut.iter().map(|u| u.area).sum(), groove_left(), 0.05, "what it leaves");
}

/// Area of a half circle of radius 3 less the segment of a circle of radius 5 that hangs into it.
fn groove_left() -> f64 {
    let half = (3.0_f64 / 5.0).asin();
    0.5 * std::f64::consts::PI * 9.0 - 25.0 * (half - half.sin() * half.cos())
}
