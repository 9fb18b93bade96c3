//! Several passes: a pocket is cleared by paths beside each other, and their nesting is told.

use g41::compensation::{CornerStyle, GougePolicy, Options, Passes, compensate_all};
use g41::contour::{Contour, MoveCurve, PathLoop, Role, Side, Tool, ToolPath};
use g41::gouge::check;
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::judge::samples;
use super::sketch::{Sketch, arc, line};
use crate::common::random::Random;
use crate::common::{near, p};

fn polygon(points: &[(f64, f64)]) -> Contour {
    let start = p(points[0].0, points[0].1);
    let rest = points[1..].iter().chain(&points[..1]);
    Sketch::closed(start, rest.map(|&(x, y)| line(p(x, y)))).contour()
}

fn square() -> Contour {
    polygon(&[(0.0, 0.0), (40.0, 0.0), (40.0, 40.0), (0.0, 40.0)])
}

fn cleared(contours: &[&Contour], radius: f64, passes: Passes) -> ToolPath {
    let tool = Tool::new(radius, Side::Left).expect("a radius");
    let jobs: Vec<_> = contours.iter().map(|&contour| (contour, tool)).collect();
    let (gouge, corner) = (GougePolicy::Avoid, CornerStyle::Linear);
    compensate_all(&jobs, &Options { gouge, corner, passes, ..Options::default() })
}

fn length(path: &ToolPath, one: &PathLoop) -> f64 {
    path.moves[one.first_move..one.moves_end].iter().map(|one| one.curve.length()).sum()
}

/// The moves that do not begin where the one before ends.
fn gaps(path: &ToolPath) -> Vec<usize> {
    let jumps = |&i: &usize| {
        path.moves[i - 1].curve.end().distance(path.moves[i].curve.start()) > 1e-6
            || path.moves[i - 1].heights[1] != path.moves[i].heights[0]
    };
    (1..path.moves.len()).filter(jumps).collect()
}

fn links(path: &ToolPath) -> Vec<MoveCurve> {
    path.moves.iter().filter(|one| one.role == Role::Link).map(|one| one.curve).collect()
}

#[test]
fn a_square_is_cleared_by_squares_one_in_the_other() {
    let path = cleared(&[&square()], 3.0, Passes::All { stepover: 4.0 });
    // 3, 7, 11, 15 and 19 mm from the walls; at 23 there is no room left.
    assert_eq!(path.loops.len(), 5, "{:?}", path.loops);
    for (k, one) in path.loops.iter().enumerate() {
        let from_wall = 3.0 + 4.0 * k as f64;
        near(length(&path, one), 4.0 * (40.0 - 2.0 * from_wall), 1e-6, "length of a square");
        assert_eq!((one.pass as usize, one.parent), (k, k.checked_sub(1)), "nesting of {k}");
    }
    assert_eq!(path.loops[4].moves_end, path.moves.len(), "all moves are in loops");
}

#[test]
fn a_count_of_passes_is_kept() {
    let path = cleared(&[&square()], 3.0, Passes::Several { count: 3, stepover: 4.0 });
    assert_eq!(path.loops.iter().map(|one| one.pass).collect::<Vec<_>>(), [0, 1, 2], "passes");
    let all = cleared(&[&square()], 3.0, Passes::Several { count: 99, stepover: 4.0 });
    assert_eq!(all.loops.len(), 5, "no more than there is room for");
}

#[test]
fn a_pocket_with_a_waist_falls_into_two_with_one_parent() {
    // Two rooms of 20 by 20 mm and a corridor of 8 mm between them.
    let rooms = polygon(&[
        (0.0, 0.0),
        (20.0, 0.0),
        (20.0, 6.0),
        (30.0, 6.0),
        (30.0, 0.0),
        (50.0, 0.0),
        (50.0, 20.0),
        (30.0, 20.0),
        (30.0, 14.0),
        (20.0, 14.0),
        (20.0, 20.0),
        (0.0, 20.0),
    ]);
    let path = cleared(&[&rooms], 3.0, Passes::All { stepover: 3.0 });
    let of = |pass| path.loops.iter().filter(|one| one.pass == pass).collect::<Vec<_>>();
    assert_eq!((of(0).len(), of(1).len(), of(2).len()), (1, 2, 2), "loops: {:?}", path.loops);
    assert_eq!(of(1).iter().map(|one| one.parent).collect::<Vec<_>>(), [Some(0), Some(0)], "waist");
    let parents: Vec<_> = of(2).iter().map(|one| one.parent).collect();
    assert_eq!(parents, [Some(1), Some(3)], "each in its own room: {:?}", path.loops);
    let order: Vec<_> = path.loops.iter().map(|one| one.pass).collect();
    assert_eq!(order, [0, 1, 2, 1, 2], "one room after the other");
    let moves: Vec<_> = path.loops.iter().map(|one| [one.first_move, one.moves_end]).collect();
    let between: Vec<_> = moves.windows(2).map(|pair| pair[1][0] - pair[0][1]).collect();
    assert_eq!(
        between,
        [1, 1, 0, 1],
        "a link to each loop but the one in the other room: {moves:?}"
    );
    assert_eq!(gaps(&path), vec![moves[3][0]], "up and across to the other room only");
    assert_eq!(moves[4][1], path.moves.len(), "all moves");
    assert_eq!(check(&rooms, &path, 3.0, 1e-3), [], "the judge");
}

#[test]
fn an_island_is_gone_round_in_every_pass() {
    let pocket = polygon(&[(-40.0, -40.0), (40.0, -40.0), (40.0, 40.0), (-40.0, 40.0)]);
    // A round island, run clockwise so that the tool is outside it.
    let halves = [arc(p(-8.0, 0.0), p(0.0, 0.0), true), arc(p(8.0, 0.0), p(0.0, 0.0), true)];
    let island = Sketch::closed(p(8.0, 0.0), halves).contour();
    let path = cleared(&[&pocket, &island], 3.0, Passes::All { stepover: 3.0 });
    for contour in [&pocket, &island] {
        assert_eq!(check(contour, &path, 3.0, 1e-3), [], "the judge");
    }
    // With a stepover of the radius everything within reach is cut: the nearest pass lies on the way
    // to the nearest wall.
    let centers = samples(&path, 300);
    let mut k = 0;
    for x in -36..=36 {
        for y in -36..=36 {
            let place = p(f64::from(x), f64::from(y));
            if place.length() < 11.0 {
                continue;
            }
            k += 1;
            let nearest = centers.iter().map(|c| c.distance(place)).fold(f64::INFINITY, f64::min);
            assert!(nearest <= 3.05, "{place} is {nearest} from the nearest pass");
        }
    }
    assert!(k > 3000, "places examined: {k}");
}

#[test]
fn a_loop_that_bulges_out_of_the_one_before_has_it_for_its_parent() {
    // Where the island is near the wall the straight moves about its corner give way to the arc, which
    // is nearer to it than those of the pass before.
    let pocket = polygon(&[(38.1, 20.7), (5.3, 22.3), (1.5, -27.5)]);
    let island = polygon(&[(21.2, 6.4), (19.3, 8.7), (23.0, 8.3)]);
    let path = cleared(&[&pocket, &island], 1.0, Passes::All { stepover: 1.0 });
    assert!(path.loops.len() > 5, "{:?}", path.loops);
    for one in path.loops.iter().filter(|one| one.pass > 0) {
        let before = one.parent.map(|index| path.loops[index].pass + 1);
        assert_eq!(before, Some(one.pass), "{one:?}");
    }
}

#[test]
fn the_tool_stays_down_from_pass_to_pass() {
    // From the middle of a side each pass begins in the middle of that side.
    let points = [(20.0, 0.0), (40.0, 0.0), (40.0, 40.0), (0.0, 40.0), (0.0, 0.0)];
    let sides = polygon(&points);
    let path = cleared(&[&sides], 3.0, Passes::All { stepover: 4.0 });
    assert!(gaps(&path).is_empty(), "without a gap: {:?}", gaps(&path));
    let ends: Vec<_> = links(&path).iter().map(|one| [one.start(), one.end()]).collect();
    assert_eq!(ends.len(), 4, "{ends:?}");
    for (k, [from, to]) in (0..).zip(ends) {
        let y = 3.0 + 4.0 * f64::from(k);
        near(from.distance(p(20.0, y)), 0.0, 1e-9, "from the end of the pass before");
        near(to.distance(p(20.0, y + 4.0)), 0.0, 1e-9, "to the nearest place of the next");
    }
    for (k, one) in path.loops.iter().enumerate() {
        let from_wall = 3.0 + 4.0 * k as f64;
        near(length(&path, one), 4.0 * (40.0 - 2.0 * from_wall), 1e-6, "all of the square");
    }
    assert_eq!(check(&sides, &path, 3.0, 1e-3), [], "the judge");
}

#[test]
fn a_link_cuts_no_wall() {
    let mut random = Random::new(41);
    let (mut down, mut up) = (0, 0);
    let cases = if cfg!(target_arch = "wasm32") { 40 } else { 400 };
    for case in 0..cases {
        // A star, with an island in some.
        let count = 5 + random.index(9);
        let mut corner = |i: usize, most: f64| {
            let angle = std::f64::consts::TAU * i as f64 / count as f64;
            let radius = most * random.within(0.3, 1.0);
            let at = radius * DVec2::from_angle(angle);
            (at.x, at.y)
        };
        let outside: Vec<_> = (0..count).map(|i| corner(i, 40.0)).collect();
        let inside: Vec<_> = (0..count).rev().map(|i| corner(i, 8.0)).collect();
        let (pocket, island) = (polygon(&outside), polygon(&inside));
        let contours = if case % 3 == 0 { vec![&pocket, &island] } else { vec![&pocket] };
        let radius = random.within(0.5, 3.0);
        let stepover = radius * random.within(0.3, 1.9);
        let path = cleared(&contours, radius, Passes::All { stepover });
        for contour in contours {
            assert_eq!(check(contour, &path, radius, 1e-3), [], "case {case}");
        }
        let ends = path.loops.last().map_or(0, |last| last.moves_end);
        assert_eq!(ends, path.moves.len(), "case {case}: no link leads nowhere");
        down += links(&path).len();
        up += gaps(&path).len();
    }
    assert!(down > up, "down {down} times, up {up} times");
}

#[test]
fn passes_without_end_need_a_pocket() {
    let wall = Sketch::open(p(0.0, 0.0), [line(p(40.0, 0.0))]).contour();
    let path = cleared(&[&wall], 3.0, Passes::All { stepover: 2.0 });
    assert!(path.diagnostics.iter().any(|d| d.code == "no-pocket"), "{:?}", path.diagnostics);
    assert_eq!(path.loops.len(), 1, "one pass");
    let some = cleared(&[&wall], 3.0, Passes::Several { count: 4, stepover: 2.0 });
    let heights: Vec<f64> = some.moves.iter().map(|one| one.curve.start().y).collect();
    assert_eq!(heights, [3.0, 5.0, 7.0, 9.0], "beside a wall: {:?}", some.loops);
}

#[test]
fn the_tool_is_led_to_the_first_pass_only() {
    let corners = [(40.0, 0.0), (40.0, 40.0), (0.0, 40.0), (0.0, 0.0), (20.0, 0.0)];
    let sketch = Sketch::open(p(20.0, 0.0), corners.map(|(x, y)| line(p(x, y))));
    let pocket = sketch.led(p(18.0, 12.0), p(22.0, 12.0)).contour();
    let path = cleared(&[&pocket], 3.0, Passes::All { stepover: 4.0 });
    assert_eq!(path.loops.len(), 5, "{:?}", path.loops);
    for (k, one) in path.loops.iter().enumerate().skip(1) {
        let from_wall = 3.0 + 4.0 * k as f64;
        near(length(&path, one), 4.0 * (40.0 - 2.0 * from_wall), 1e-6, "length of a square");
    }
    let led = path.moves.iter().filter(|one| matches!(one.role, Role::LeadIn | Role::LeadOut));
    assert_eq!(led.count(), 2, "one way in and one out");
}
