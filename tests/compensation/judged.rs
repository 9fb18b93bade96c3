//! The judge of paths, held against closed forms and brute force.

use g41::compensation::{CornerStyle, Options, compensate};
use g41::contour::{GougeKind, Side, Tool};
use g41::diagnostic::Origin;
use g41::gouge::{check, check_all};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::families::Case;
use super::judge::{field_of, samples};
use super::random_contours::{star, wandering};
use super::sketch::{Sketch, arc, line};
use super::verdict::path_of;
use crate::common::random::Random;
use crate::common::{near, near_point, p};

const CASES: u32 = if cfg!(target_arch = "wasm32") { 60 } else { 800 };
const TOLERANCE: f64 = 0.01;

#[test]
fn the_judge_finds_a_gouge_exactly_where_brute_force_does() {
    let mut found = 0;
    for case in 0..CASES {
        let mut random = Random::new(u64::from(case) ^ 0x0d6e);
        let sketch = if random.coin() { star(&mut random) } else { wandering(&mut random) };
        let contour = sketch.contour();
        let radius = random.within(0.5, 20.0);
        let side = if random.coin() { Side::Left } else { Side::Right };
        let tool = Tool::new(radius, side).expect("a radius");
        let options = Options { corner: CornerStyle::Arc, ..Options::default() };
        let path = compensate(&contour, tool, &options);
        let gouges = check(&contour, &path, radius, TOLERANCE);
        let deepest = gouges.iter().map(|gouge| gouge.depth).fold(0.0, f64::max);
        let field = field_of(&contour);
        let brute = samples(&path, 60)
            .into_iter()
            .map(|point| radius - field.distance(point))
            .fold(0.0, f64::max);
        // Sampling sees a little less than the deepest point.
        let what = format!("case {case}: the judge says {deepest}, brute force {brute}");
        assert!(deepest >= brute - 1e-9 || brute < TOLERANCE, "{what}");
        assert!(brute >= 0.9 * deepest - TOLERANCE, "{what}");
        found += u32::from(!gouges.is_empty());
    }
    assert!(found > CASES / 10 && found < CASES, "{found} of {CASES} paths cut too deep");
}

#[test]
fn a_slot_narrower_than_the_tool_is_cut_on_both_walls() {
    // Three sides of a slot 6 mm wide; the offsets of a tool of 4 mm pass each other by 2 mm.
    let slot = [(0.0, 0.0), (6.0, 0.0), (6.0, 30.0)].map(|(x, y)| line(p(x, y)));
    let contour = Sketch::open(p(0.0, 30.0), slot).contour();
    let tool = Tool::new(4.0, Side::Left).expect("a radius");
    let path = compensate(&contour, tool, &Options::default());
    let gouges = check(&contour, &path, 4.0, TOLERANCE);
    assert_eq!(gouges.len(), 1, "one gouge all along: {gouges:?}");
    assert_eq!(gouges[0].kind, GougeKind::Bottleneck, "between two walls");
    near(gouges[0].depth, 2.0, 1e-6, "each wall is 2 mm from the other's tool");
    let named = &gouges[0].segments;
    assert!(
        named.contains(&Origin::Segment(0)) && named.contains(&Origin::Segment(2)),
        "{named:?}"
    );
}

#[test]
fn an_arc_tighter_than_the_tool_is_cut_by_twice_the_difference() {
    // Half a circle of radius 5 and a tool of 7: its centre runs 2 mm beyond the arc's.
    let contour = Sketch::open(p(0.0, -5.0), [arc(p(0.0, 5.0), p(0.0, 0.0), false)]).contour();
    let tool = Tool::new(7.0, Side::Left).expect("a radius");
    let path = compensate(&contour, tool, &Options::default());
    let gouges = check(&contour, &path, 7.0, TOLERANCE);
    assert_eq!(gouges.len(), 1, "one bend, one gouge");
    assert_eq!(gouges[0].kind, GougeKind::Curvature, "a bend of one segment");
    near(gouges[0].depth, 4.0, 1e-6, "2 (r − R)");
    near_point(gouges[0].at, p(0.0, 5.0), 1e-3, "deepest opposite to where the tool should be");
}

#[test]
fn a_path_at_the_radius_is_clean() {
    let square = [(20.0, 0.0), (20.0, 20.0), (0.0, 20.0), (0.0, 0.0)].map(|(x, y)| line(p(x, y)));
    let contour = Sketch::closed(p(0.0, 0.0), square).contour();
    for (side, radius) in [(Side::Left, 3.0), (Side::Left, 9.5), (Side::Right, 50.0)] {
        let tool = Tool::new(radius, side).expect("a radius");
        let path = compensate(&contour, tool, &Options::default());
        assert!(check(&contour, &path, radius, 1e-6).is_empty(), "r = {radius}, {side:?}");
        assert!(!check(&contour, &path, radius + 0.1, 1e-6).is_empty(), "a larger tool would cut");
    }
}

#[test]
fn paths_that_keep_at_a_large_radius_are_clean() {
    // Contours small beside the radius, tolerance 1e-5: the path is at the radius all along.
    for seed in [773, 1275, 1462, 5414] {
        let case = Case::of(seed);
        let contour = case.contour().expect("the families have these");
        let path = path_of(&case, &contour);
        let field = field_of(&contour);
        let nearest = samples(&path, 9)
            .into_iter()
            .map(|at| field.distance(at))
            .fold(f64::INFINITY, f64::min);
        assert!(nearest >= case.radius - case.tolerance, "seed {seed}: brute force, {nearest}");
        let gouges = check(&contour, &path, case.radius, case.tolerance);
        assert_eq!(gouges, [], "seed {seed}: the judge");
        let wider = check(&contour, &path, case.radius + 0.01, case.tolerance);
        assert!(!wider.is_empty(), "seed {seed}: a larger tool would cut");
    }
}

#[test]
fn several_contours_are_judged_together() {
    let ring = |reach: f64| {
        let corners = [(reach, -reach), (reach, reach), (-reach, reach), (-reach, -reach)];
        Sketch::closed(p(-reach, -reach), corners.map(|(x, y)| line(p(x, y)))).contour()
    };
    let (outer, island) = (ring(20.0), ring(12.0));
    let tool = Tool::new(5.0, Side::Left).expect("a radius");
    let path = compensate(&outer, tool, &Options::default());
    assert_eq!(check(&outer, &path, 5.0, TOLERANCE), [], "along the outer walls alone");
    // The path's square of 15 mm is 3 mm off the island's of 12 mm.
    let gouges = check_all(&[&outer, &island], &path, 5.0, TOLERANCE);
    assert!(!gouges.is_empty(), "the island is cut");
    near(gouges.iter().map(|gouge| gouge.depth).fold(0.0, f64::max), 2.0, 1e-9, "5 − 3");
}
