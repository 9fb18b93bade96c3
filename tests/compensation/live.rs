//! A contour that is edited has the tool path that compensating it afresh gives.

use std::f64::consts::TAU;

use g41::compensation::{
    CornerStyle, EditError, GougePolicy, LiveContour, Options, SplineMethod, compensate,
};
use g41::contour::{
    Attributes, ContourBuilder, Lead, MoveCurve, Shape, Side, SplineShape, Tool, ToolPath,
};
use g41::diagnostic::Origin;
use glam::{DVec2, dvec2};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common::p;
use crate::common::random::Random;

const CHORD: f64 = 0.002;
const STEPS: usize = if cfg!(target_arch = "wasm32") { 150 } else { 3000 };

fn add(builder: &mut ContourBuilder, shape: Shape) {
    let index = u32::try_from(builder.len()).expect("there are few segments");
    builder.segment(shape, Attributes::at(Origin::Segment(index)));
}

fn spline(points: Vec<DVec2>) -> Shape {
    Shape::Spline(SplineShape { points, ..SplineShape::default() })
}

/// A closed curve of one periodic spline with waves.
fn ring(count: usize) -> ContourBuilder {
    let radius = 5.0 * count as f64 / TAU;
    let at = |i: usize| {
        let angle = TAU * (i % count) as f64 / count as f64;
        let waves = (count / 20).max(3) as f64;
        DVec2::from_angle(angle) * (radius + 8.0 * (waves * angle).sin())
    };
    let mut builder = ContourBuilder::new(at(0));
    add(&mut builder, spline((1..=count).map(at).collect()));
    builder
}

/// A wavy line of type points from `from` towards `to`.
fn wavy(from: DVec2, to: DVec2, random: &mut Random) -> Vec<DVec2> {
    let steps = 3 + random.index(30);
    let across = (to - from).perp().normalize();
    let mut points: Vec<DVec2> = (1..steps)
        .map(|k| from.lerp(to, k as f64 / steps as f64) + across * random.within(-1.0, 1.0))
        .collect();
    points.push(to);
    points
}

/// A star-shaped contour of lines, arcs and splines, closed or open, with smooth splines too.
fn mixed(random: &mut Random, closed: bool) -> ContourBuilder {
    let corners = 3 + random.index(5);
    let size = random.within(30.0, 150.0);
    let corner = |k: usize, random: &mut Random| {
        let angle = TAU * (k as f64 + random.within(-0.3, 0.3)) / corners as f64;
        DVec2::from_angle(angle) * (size * random.within(0.6, 1.4))
    };
    let start = corner(0, random);
    let mut builder = ContourBuilder::new(start);
    let mut from = start;
    for k in 1..=corners {
        let to = if closed && k == corners { start } else { corner(k, random) };
        let shape = match random.index(4) {
            0 => Shape::Line { to },
            1 => {
                let middle = from.midpoint(to);
                let center = middle + (to - from).perp() * random.within(-1.0, 1.0);
                Shape::Arc { to, center, clockwise: random.coin() }
            }
            _ => Shape::Spline(SplineShape {
                points: wavy(from, to, random),
                smooth: random.coin(),
                ..SplineShape::default()
            }),
        };
        add(&mut builder, shape);
        from = to;
    }
    if !closed && random.coin() {
        let lead = |point| Lead { point, attributes: Attributes::at(Origin::Segment(0)) };
        builder.lead_in(lead(start * 1.5));
        builder.lead_out(lead(from * 1.7));
    }
    builder
}

fn tool(radius: f64, side: Side) -> Tool {
    Tool::new(radius, side).expect("it is a radius")
}

fn polyline(points: &[f64]) -> Vec<DVec2> {
    let mut vertices: Vec<DVec2> = points.chunks_exact(2).map(|xy| dvec2(xy[0], xy[1])).collect();
    vertices.dedup_by(|a, b| a.distance(*b) < 1e-7);
    vertices
}

fn flattened(path: &ToolPath) -> Vec<DVec2> {
    let mut vertices: Vec<DVec2> = Vec::new();
    for step in &path.moves {
        vertices.push(step.curve.start());
        step.curve.flatten(CHORD, &mut |point| vertices.push(point));
    }
    vertices.dedup_by(|a, b| a.distance(*b) < 1e-7);
    vertices
}

fn to_segment(point: DVec2, from: DVec2, to: DVec2) -> f64 {
    let along = to - from;
    let t = ((point - from).dot(along) / along.length_squared()).clamp(0.0, 1.0);
    point.distance(from + along * t)
}

/// Compares the polyline of an edited contour with the path computed afresh.
fn check(
    live: &LiveContour,
    built: &g41::contour::Contour,
    tool: Tool,
    options: &Options,
    case: &str,
) {
    let fresh = compensate(built, tool, options);
    let (own, other) = (polyline(live.path_points()), flattened(&fresh));
    let bound = options.tolerance / 100.0;
    if own.len() == other.len() {
        let error = own.iter().zip(&other).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
        if error <= bound {
            return;
        }
    }
    // A curve may be cut into one chord more; then each must lie on the other.
    let curves: Vec<&MoveCurve> = fresh.moves.iter().map(|step| &step.curve).collect();
    let mut at = 0;
    for &vertex in &own {
        let error = nearest(curves.len(), &mut at, bound, |k| {
            let far = curves[k].hull_bounds().distance(vertex) > bound;
            if far { f64::INFINITY } else { curves[k].nearest(vertex).distance }
        });
        assert!(error <= bound, "{case}: the vertex {vertex} is {error:e} mm from the fresh path");
    }
    let mut at = 0;
    for &vertex in &other {
        let bound = CHORD + bound;
        let error =
            nearest(own.len() - 1, &mut at, bound, |k| to_segment(vertex, own[k], own[k + 1]));
        assert!(error <= bound, "{case}: {vertex} of the fresh path is {error:e} mm off");
    }
}

/// The distance of something from a list of curves that it follows: around the place where it was
/// within `bound` last, or else anywhere.
fn nearest(count: usize, at: &mut usize, bound: f64, distance: impl Fn(usize) -> f64) -> f64 {
    let around = at.saturating_sub(8)..(*at + 8).min(count);
    if let Some(near) = around.into_iter().find(|&k| distance(k) <= bound) {
        *at = near;
        return distance(near);
    }
    let least = (0..count).min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
    *at = least.unwrap_or(0);
    distance(*at)
}

/// A random edit of the kinds a user makes by hand.
fn edit(live: &mut LiveContour, random: &mut Random, reach: f64) {
    let described = live.described().described();
    let segment = random.index(described.len());
    let by = random.point(reach);
    match &described[segment].0 {
        // None is made here: there is nothing to move that would leave it one.
        Shape::Bezier { .. } | Shape::Involute { .. } => {}
        Shape::Spline(shape) => {
            let (points, count) = (shape.points.clone(), shape.points.len());
            let index = random.index(count);
            let done = match random.index(10) {
                0 if count < 400 => {
                    let before =
                        if index > 0 { points[index - 1] } else { start_of(live, segment) };
                    live.insert_point(segment, index, before.midpoint(points[index]) + by * 0.3)
                }
                1 if count > 8 && index + 1 < count => live.remove_point(segment, index),
                _ => live.move_point(segment, index, points[index] + by),
            };
            done.expect("the point is there");
        }
        Shape::Arc { to, center, .. } => {
            // The centre moves along the bisector, and with an end, so that the radii agree.
            let (from, to, center) = (start_of(live, segment), *to, *center);
            let axis = (to - from).perp().normalize_or_zero();
            let height = (center - from.midpoint(to)).dot(axis) + by.x;
            let shape = Shape::Arc {
                to,
                center: from.midpoint(to) + axis * height,
                clockwise: random.coin(),
            };
            live.set_segment(segment, shape).expect("the segment is there");
        }
        Shape::Line { to } | Shape::ArcByRadius { to, .. } => {
            let to = *to;
            live.move_point(segment, 0, to + by).expect("a line has an end");
        }
    }
}

fn start_of(live: &LiveContour, segment: usize) -> DVec2 {
    let described = live.described();
    match segment.checked_sub(1) {
        None => described.start(),
        Some(before) => described.described()[before].0.end().expect("it has an end"),
    }
}

/// Edits at random and compares every now and then.
fn drag(
    live: &mut LiveContour,
    closed: bool,
    tool: Tool,
    options: &Options,
    seed: u64,
    steps: usize,
) {
    let mut random = Random::new(seed);
    let mut shown = (live.path_points().to_vec(), live.outline_points().to_vec());
    for step in 0..steps {
        edit(live, &mut random, 1.5);
        if random.index(3) == 0 {
            continue;
        }
        let update = live.update();
        let outside = |range: &std::ops::Range<usize>, old: &[f64], new: &[f64]| {
            (0..new.len() / 2).find(|i| {
                !range.contains(i) && old.get(2 * i..2 * i + 2) != new.get(2 * i..2 * i + 2)
            })
        };
        let told = outside(&update.path, &shown.0, live.path_points());
        assert_eq!(told, None, "seed {seed}, step {step}: vertex of {:?}", update.path);
        let told = outside(&update.outline, &shown.1, live.outline_points());
        assert_eq!(told, None, "seed {seed}, step {step}: outline {:?}", update.outline);
        shown = (live.path_points().to_vec(), live.outline_points().to_vec());
        if step % 30 == 0 || step + 3 > steps {
            let built = live.described().clone().build(closed);
            if let Some(contour) = built.contour.filter(|_| built.diagnostics.is_empty()) {
                check(live, &contour, tool, options, &format!("seed {seed}, step {step}"));
            }
        }
    }
}

#[test]
fn a_periodic_spline_dragged_for_thousands_of_steps_stays_the_fresh_one() {
    for (seed, count, radius) in [(1, 30, 3.0), (2, 130, 5.0), (3, 400, 5.0), (4, 150, 20.0)] {
        for (tolerance, side) in [(1e-3, Side::Left), (1e-6, Side::Right)] {
            let (tool, options) = (tool(radius, side), Options { tolerance, ..Options::default() });
            let mut live = LiveContour::new(ring(count), true, tool, options, CHORD);
            live.update();
            drag(&mut live, true, tool, &options, seed, STEPS / 4);
        }
    }
}

#[test]
fn contours_of_all_segments_edited_at_random_stay_the_fresh_ones() {
    let contours = if cfg!(target_arch = "wasm32") { 8 } else { 120 };
    for seed in 0..contours {
        let mut random = Random::new(1000 + seed);
        let closed = random.coin();
        let builder = mixed(&mut random, closed);
        let side = if random.coin() { Side::Left } else { Side::Right };
        let tool = tool(random.within(0.0, 12.0), side);
        let corner = if random.coin() { CornerStyle::Arc } else { CornerStyle::Linear };
        let options = Options { corner, ..Options::default() };
        let mut live = LiveContour::new(builder, closed, tool, options, CHORD);
        live.update();
        drag(&mut live, closed, tool, &options, seed, STEPS / 40);
    }
}

#[test]
fn an_edit_changes_as_much_of_a_long_contour_as_of_a_short_one() {
    let changed = |count: usize| {
        let tool = tool(5.0, Side::Left);
        let mut live = LiveContour::new(ring(count), true, tool, Options::default(), CHORD);
        live.update();
        let Shape::Spline(shape) = &live.described().described()[0].0 else { return [0, 0] };
        let at = shape.points[count / 2];
        live.move_point(0, count / 2, at + p(0.3, 0.2)).expect("the point is there");
        live.update();
        live.move_point(0, count / 2, at).expect("the point is there");
        let update = live.update();
        [update.path.len(), update.outline.len()]
    };
    let (short, long) = (changed(500), changed(20_000));
    for k in 0..2 {
        assert!(short[k] > 0 && short[k] < 3000, "{short:?} vertices");
        assert!(long[k] < 2 * short[k], "{long:?} after {short:?} vertices");
    }
}

/// Distance between the pieces of an edited contour's path and the path without gouges made afresh.
fn avoided_error(live: &LiveContour) -> f64 {
    let fresh = live.path();
    let points = live.path_points();
    let vertex = |i: usize| dvec2(points[2 * i], points[2 * i + 1]);
    let count = points.len() / 2;
    let mut chords: Vec<[DVec2; 2]> = Vec::new();
    let starts = live.path_starts();
    for i in 1..count {
        let from = vertex(i - 1);
        if !starts.contains(&u32::try_from(i).expect("it is small")) && from != vertex(i) {
            chords.push([from, vertex(i)]);
        }
    }
    let curves: Vec<&MoveCurve> = fresh.moves.iter().map(|step| &step.curve).collect();
    let mut worst = 0.0_f64;
    let mut at = 0;
    for [_, vertex] in &chords {
        worst = worst
            .max(nearest(curves.len(), &mut at, 1e-9, |k| curves[k].nearest(*vertex).distance));
    }
    let mut at = 0;
    for curve in &curves {
        let mut own = vec![curve.start()];
        curve.flatten(CHORD, &mut |point| own.push(point));
        for vertex in own {
            let error = nearest(chords.len(), &mut at, CHORD, |k| {
                to_segment(vertex, chords[k][0], chords[k][1])
            });
            worst = worst.max(error - CHORD);
        }
    }
    worst
}

#[test]
fn gouges_are_avoided_around_an_edit_as_they_are_afresh() {
    for (seed, count, radius, side) in [
        (1, 60, 5.0, Side::Right),
        (2, 200, 5.0, Side::Left),
        (3, 400, 12.0, Side::Left),
        (4, 300, 30.0, Side::Right),
    ] {
        let options = Options { gouge: GougePolicy::Avoid, ..Options::default() };
        let tool = tool(radius, side);
        let mut live = LiveContour::new(ring(count), true, tool, options, CHORD);
        live.update();
        assert!(avoided_error(&live) <= 1e-5, "at first");
        let mut random = Random::new(seed);
        let mut shown = live.path_points().to_vec();
        for step in 0..STEPS / 60 {
            edit(&mut live, &mut random, 1.5);
            let update = live.update();
            let new = live.path_points();
            let told = (0..new.len() / 2).find(|i| {
                !update.path.contains(i) && shown.get(2 * i..2 * i + 2) != new.get(2 * i..2 * i + 2)
            });
            assert_eq!(told, None, "seed {seed}, step {step}: vertex of {:?}", update.path);
            shown = new.to_vec();
            if step % 5 == 0 {
                let (error, bound) = (avoided_error(&live), options.tolerance / 100.0);
                assert!(error <= bound, "seed {seed}, step {step}: {error:e} mm");
                clear_of_the_contour(&live, radius - options.tolerance);
            }
        }
    }
}

/// Asserts that no vertex of the path is nearer than `least` to any point of the contour.
fn clear_of_the_contour(live: &LiveContour, least: f64) {
    let built = live.described().clone().build(true).contour.expect("it is a contour");
    for xy in live.path_points().chunks_exact(2).step_by(7) {
        let vertex = dvec2(xy[0], xy[1]);
        let distances = built.segments().iter().map(|s| s.curve.nearest(vertex).distance);
        let distance = distances.fold(f64::INFINITY, f64::min);
        // Blocks of which nothing is left rest on the contour.
        assert!(distance >= least - 1e-9 || distance < 1e-9, "{vertex} is {distance} mm off");
    }
}

#[test]
fn gouges_of_all_segments_are_avoided_around_an_edit_as_they_are_afresh() {
    // Beside the first ones: leads that go far into the path, closed contours that cross themselves, and
    // corners beside which alone something changes.
    let first = if cfg!(target_arch = "wasm32") { 3 } else { 50 };
    for seed in (0..first).chain([90, 168, 340, 415]) {
        let mut random = Random::new(5000 + seed);
        let closed = random.coin();
        let builder = mixed(&mut random, closed);
        let side = if random.coin() { Side::Left } else { Side::Right };
        let tool = tool(random.within(0.5, 20.0), side);
        let options = Options { gouge: GougePolicy::Avoid, ..Options::default() };
        let mut live = LiveContour::new(builder, closed, tool, options, CHORD);
        live.update();
        for step in 0..STEPS / 150 {
            edit(&mut live, &mut random, 1.5);
            live.update();
            let (error, bound) = (avoided_error(&live), options.tolerance / 100.0);
            assert!(error <= bound, "seed {seed}, step {step}: {error:e} mm");
        }
    }
}

#[test]
fn an_arc_that_comes_to_end_elsewhere_opens_the_contour() {
    for gouge in [GougePolicy::Report, GougePolicy::Avoid] {
        let arc = |x: f64| Shape::Arc { to: p(0.0, 0.0), center: p(x, 10.0), clockwise: false };
        let mut builder = ContourBuilder::new(p(0.0, 0.0));
        add(&mut builder, Shape::Line { to: p(2.0, 0.0) });
        add(&mut builder, arc(1.0));
        let options = Options { gouge, ..Options::default() };
        let mut live = LiveContour::new(builder, true, tool(1.0, Side::Left), options, CHORD);
        live.update();
        // Off its middle by 0.1 mm the centre is 0.02 mm nearer to the end of the arc than to its start:
        // few enough for the end to be taken onto the circle, where it does not meet the line.
        for (x, closed) in [(1.1, false), (1.0, true), (1.1, false)] {
            live.move_point(1, 1, p(x, 10.0)).expect("it is the centre of an arc");
            live.update();
            let says_so = live.path().diagnostics.iter().any(|said| said.code == "not-closed");
            assert_eq!(says_so, !closed, "about x {x}");
            let error = avoided_error(&live);
            assert!(error <= 1e-5, "{gouge:?}, about x {x}: {error:e} mm");
        }
    }
}

#[test]
fn no_edit_is_no_change() {
    let tool = tool(5.0, Side::Left);
    let mut live = LiveContour::new(ring(100), true, tool, Options::default(), CHORD);
    let first = live.update();
    assert_eq!(first.path, 0..live.path_points().len() / 2, "at first everything is new");
    assert_eq!(live.path_starts(), [0], "one piece");
    let second = live.update();
    assert!(second.path.is_empty() && second.outline.is_empty(), "{second:?}");
}

#[test]
fn what_depends_on_the_whole_contour_is_made_anew() {
    for options in [
        Options { gouge: GougePolicy::Stop, ..Options::default() },
        Options { spline: SplineMethod::TypePoints, ..Options::default() },
    ] {
        let tool = tool(5.0, Side::Left);
        let mut live = LiveContour::new(ring(60), true, tool, options, CHORD);
        live.update();
        live.move_point(0, 20, p(-30.0, 40.0)).expect("the point is there");
        let update = live.update();
        assert_eq!(update.path, 0..live.path_points().len() / 2, "{options:?}");
        let (own, fresh) = (polyline(live.path_points()), flattened(&live.path()));
        let missing = own.iter().find(|a| !fresh.iter().any(|b| a.distance(*b) < 1e-6));
        assert_eq!(missing, None, "{options:?}");
    }
}

#[test]
fn a_contour_with_a_fault_is_followed_until_the_fault_is_gone() {
    let tool = tool(2.0, Side::Left);
    let mut builder = ContourBuilder::new(p(0.0, 0.0));
    add(&mut builder, Shape::Line { to: p(20.0, 0.0) });
    add(&mut builder, spline(vec![p(25.0, 5.0), p(20.0, 12.0), p(24.0, 20.0), p(10.0, 24.0)]));
    add(&mut builder, Shape::Line { to: p(0.0, 20.0) });
    let options = Options::default();
    let mut live = LiveContour::new(builder, false, tool, options, CHORD);
    live.update();
    live.move_point(1, 0, p(20.0, 0.0)).expect("the point is there");
    live.update();
    assert!(!live.path().diagnostics.is_empty(), "two type points coincide");
    live.move_point(1, 1, p(21.0, 12.0)).expect("the point is there");
    live.update();
    live.move_point(1, 0, p(24.0, 4.0)).expect("the point is there");
    live.update();
    let built = live.described().clone().build(false);
    assert_eq!(built.diagnostics, [], "nothing is wrong any more");
    check(&live, &built.contour.expect("it is one"), tool, &options, "after the fault");
}

#[test]
fn an_edit_of_nothing_is_refused() {
    let tool = tool(2.0, Side::Left);
    let mut builder = ContourBuilder::new(p(0.0, 0.0));
    add(&mut builder, Shape::Line { to: p(20.0, 0.0) });
    add(&mut builder, spline(vec![p(25.0, 5.0), p(20.0, 12.0)]));
    let mut live = LiveContour::new(builder, false, tool, Options::default(), CHORD);
    let at = p(1.0, 1.0);
    assert_eq!(live.move_point(2, 0, at), Err(EditError::NoSegment), "moved");
    assert_eq!(live.move_point(0, 1, at), Err(EditError::NoPoint), "moved");
    assert_eq!(live.move_point(1, 2, at), Err(EditError::NoPoint), "moved");
    assert_eq!(live.insert_point(0, 0, at), Err(EditError::NotASpline), "inserted");
    assert_eq!(live.insert_point(1, 3, at), Err(EditError::NoPoint), "inserted");
    assert_eq!(live.remove_point(1, 2), Err(EditError::NoPoint), "removed");
    assert_eq!(live.remove_point(1, 0), Ok(()), "one is left");
    assert_eq!(live.remove_point(1, 0), Err(EditError::LastPoint), "removed");
    assert_eq!(live.set_segment(2, Shape::Line { to: at }), Err(EditError::NoSegment), "set");
    assert_eq!(live.set_segment(1, spline(Vec::new())), Ok(()), "a spline without points");
    assert_eq!(live.move_point(1, 0, at), Err(EditError::NoPoint), "moved");
    live.update();
    assert_eq!(live.path_starts(), [0], "the line is left");
}
