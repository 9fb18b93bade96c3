//! Segments of given cubics: their offsets against a brute-force equidistant, and what is special
//! about them.

use g41::compensation::{LiveContour, Options, SplineMethod, avoid, compensate};
use g41::contour::{Attributes, Contour, ContourBuilder, Shape, Side, Tool, ToolPath};
use g41::diagnostic::{Origin, Severity};
use g41::geometry::{Cubic, Curve};
use glam::DVec2;
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use super::sketch::{Sketch, line};
use crate::common::random::Random;
use crate::common::{near_point, p};

fn bezier(controls: &[DVec2]) -> Shape {
    Shape::Bezier { controls: controls.to_vec() }
}

/// Vertices of a path within `chord` of it.
fn vertices(path: &ToolPath, chord: f64) -> Vec<DVec2> {
    let mut points = Vec::new();
    for step in &path.moves {
        points.push(step.curve.start());
        step.curve.flatten(chord, &mut |point| points.push(point));
    }
    points
}

fn to_polyline(point: DVec2, points: &[DVec2]) -> f64 {
    let to = |pair: &[DVec2]| {
        let (chord, way) = (pair[1] - pair[0], point - pair[0]);
        let share = (way.dot(chord) / chord.length_squared().max(1e-300)).clamp(0.0, 1.0);
        (way - chord * share).length()
    };
    points.windows(2).map(to).fold(f64::INFINITY, f64::min)
}

/// Places of the centre of a tool beside a contour, by its definition.
fn equidistant(contour: &Contour, offset: f64) -> Vec<DVec2> {
    let mut points = Vec::new();
    for segment in contour.segments() {
        let Curve::Spline(spline) = &segment.curve else { continue };
        for cubic in spline.pieces() {
            for k in 0..=500 {
                let t = f64::from(k) / 500.0;
                let ahead = cubic.derivative(t).normalize();
                points.push(cubic.point(t) + ahead.perp() * offset);
            }
        }
    }
    points
}

/// A chain of gentle cubics with one tangent at each joint, and jumps of its curvature there.
fn gentle(random: &mut Random, count: usize) -> Vec<DVec2> {
    let mut from = DVec2::ZERO;
    let mut angle: f64 = 0.0;
    let mut controls = Vec::new();
    for _ in 0..count {
        let length = random.within(20.0, 40.0);
        let turn = random.within(-0.5, 0.5);
        let (ahead, next) = (DVec2::from_angle(angle), DVec2::from_angle(angle + turn));
        let to = from + DVec2::from_angle(angle + 0.5 * turn) * length;
        controls.push(from + ahead * (length * random.within(0.25, 0.4)));
        controls.push(to - next * (length * random.within(0.25, 0.4)));
        controls.push(to);
        (from, angle) = (to, angle + turn);
    }
    controls
}

#[test]
fn the_offset_of_gentle_cubics_is_their_equidistant_on_both_sides() {
    let mut random = Random::new(1405);
    for case in 0..30 {
        let controls = gentle(&mut random, 1 + case % 5);
        let sketch = Sketch::open(DVec2::ZERO, [bezier(&controls)]);
        let contour = sketch.contour();
        assert_eq!(contour.segments().len(), 1, "case {case}: one segment");
        for side in [Side::Left, Side::Right] {
            let tolerance = [1e-2, 1e-3, 1e-5][case % 3];
            let options = Options { tolerance, ..Options::default() };
            let path = sketch.compensated(side, 4.0, &options);
            assert!(path.diagnostics.is_empty(), "case {case}: {:?}", path.diagnostics);
            let truth = equidistant(&contour, side.sign() * 4.0);
            // Chords of the truth: 40 mm in 500 parts, bent to a radius of 10 mm at most.
            let slack = 1e-6 + (40.0_f64 / 500.0).powi(2) / 80.0;
            let own = vertices(&path, 1e-7);
            let forth = truth.iter().step_by(7).map(|&point| to_polyline(point, &own));
            let forth = forth.fold(0.0, f64::max);
            let step = (own.len() / 200).max(1);
            let back = own.iter().step_by(step).map(|&point| to_polyline(point, &truth));
            let back = back.fold(0.0, f64::max);
            assert!(forth <= tolerance + 2e-7, "case {case}, {side:?}: {forth:e} forth");
            assert!(back <= tolerance + slack, "case {case}, {side:?}: {back:e} back");
        }
    }
}

#[test]
fn run_backwards_on_the_other_side_it_is_the_same_path() {
    let mut random = Random::new(1406);
    for case in 0..20 {
        let sketch =
            Sketch::open(DVec2::ZERO, [bezier(&gentle(&mut random, 3)), line(p(0.0, 60.0))]);
        let options = Options::default();
        let there = vertices(&sketch.compensated(Side::Left, 3.0, &options), 1e-6);
        let back = vertices(&sketch.reversed().compensated(Side::Right, 3.0, &options), 1e-6);
        let mirrored = sketch.mapped(true, |point| p(point.x, -point.y));
        let mirrored = vertices(&mirrored.compensated(Side::Right, 3.0, &options), 1e-6);
        for (k, point) in there.iter().enumerate().step_by(11) {
            let what = format!("case {case}, vertex {k}");
            assert!(to_polyline(*point, &back) < 2e-3, "{what}: backwards");
            assert!(to_polyline(p(point.x, -point.y), &mirrored) < 2e-3, "{what}: mirrored");
        }
    }
}

/// Random cubics, many of them with cusps, loops, doubled control points or a straight polygon.
fn wild(random: &mut Random) -> Vec<DVec2> {
    let mut from = DVec2::ZERO;
    let mut controls = Vec::new();
    for k in 0..=random.index(4) {
        let at = p(30.0 * (k + 1) as f64, 0.0);
        let near = |random: &mut Random, about: DVec2| {
            about + p(random.within(-20.0, 20.0), random.within(-20.0, 20.0))
        };
        let (mut a, mut b, mut to) = (near(random, from), near(random, at), near(random, at));
        match random.index(8) {
            0 => a = from,
            1 => b = to,
            2 => (a, b) = (from, to),
            3 => (a, b) = (from.lerp(to, 1.3), from.lerp(to, -0.3)),
            4 => (a, b) = (b, a),
            5 => to = from,
            6 => b = a,
            _ => {}
        }
        controls.extend([a, b, to]);
        from = to;
    }
    controls
}

fn built(controls: &[DVec2]) -> Option<Contour> {
    let mut builder = ContourBuilder::new(DVec2::ZERO);
    builder.segment(bezier(controls), Attributes::at(Origin::Segment(0)));
    builder.build(false).contour
}

#[test]
fn where_gouges_are_avoided_no_tool_comes_too_near_to_cubics_of_any_kind() {
    let mut random = Random::new(1407);
    for case in 0..90 {
        let controls = wild(&mut random);
        let Some(contour) = built(&controls) else { continue };
        let radius = [0.5, 3.0, 12.0][case % 3];
        let side = if random.coin() { Side::Left } else { Side::Right };
        let tool = Tool::new(radius, side).expect("a radius");
        let tolerance = 1e-3;
        let options = Options { tolerance, ..Options::default() };
        let path = avoid(&contour, tool, &options);
        let mut points = Vec::new();
        for segment in contour.segments() {
            let Curve::Spline(spline) = &segment.curve else { continue };
            for cubic in spline.pieces() {
                points.extend((0..=400).map(|k| cubic.point(f64::from(k) / 400.0)));
            }
        }
        for vertex in vertices(&path, 1e-4) {
            let reach = points.iter().map(|point| point.distance(vertex));
            let reach = reach.fold(f64::INFINITY, f64::min);
            assert!(
                reach >= radius - tolerance - 2e-4,
                "case {case}: {reach} of {radius} at {vertex}, {controls:?}"
            );
        }
        // As a control without a view ahead cuts it: it ends, and its moves follow each other.
        let path = compensate(&contour, tool, &options);
        for pair in path.moves.windows(2) {
            let (end, start) = (pair[0].curve.end(), pair[1].curve.start());
            near_point(end, start, 1e-6, &format!("case {case}: {controls:?}"));
        }
        assert!(
            path.moves.iter().all(|step| step.curve.start().is_finite()),
            "case {case}: {controls:?}"
        );
    }
}

#[test]
fn a_corner_between_cubics_is_one_of_the_contour() {
    // Up to a corner, and from there to the right: outside for the tool on the left.
    let controls =
        [p(0.0, 5.0), p(0.0, 8.0), p(0.0, 12.0), p(4.0, 12.0), p(8.0, 12.0), p(12.0, 12.0)];
    let sketch = Sketch::open(DVec2::ZERO, [bezier(&controls)]);
    assert_eq!(sketch.contour().segments().len(), 2, "two segments");
    let path = sketch.compensated(Side::Left, 2.0, &Options::default());
    assert_eq!(path.transitions.len(), 1, "a transition between them");
    near_point(path.transitions[0].corner, p(0.0, 12.0), 1e-12, "at the corner");
    let points = vertices(&path, 1e-6);
    assert!(points.iter().any(|point| point.distance(p(-2.0, 14.0)) < 1e-9), "{points:?}");
}

#[test]
fn without_type_points_the_offset_is_exact() {
    let sketch = Sketch::open(DVec2::ZERO, [bezier(&gentle(&mut Random::new(3), 2))]);
    let type_points = Options { spline: SplineMethod::TypePoints, ..Options::default() };
    let path = sketch.compensated(Side::Left, 3.0, &type_points);
    let exact = sketch.compensated(Side::Left, 3.0, &Options::default());
    assert_eq!(path.moves, exact.moves, "the moves");
    let codes: Vec<_> = path.diagnostics.iter().map(|d| (d.code, d.severity)).collect();
    assert_eq!(codes, [("no-type-points", Severity::Info)], "and a word about it");
}

#[test]
fn what_makes_no_cubics_is_reported_and_a_line_stands_in() {
    let far = p(2e7, 0.0);
    for (controls, code) in [
        (vec![p(1.0, 1.0), p(2.0, 1.0)], "too-few-points"),
        (vec![p(1.0, 1.0), p(2.0, 1.0), p(3.0, 0.0), p(4.0, 0.0)], "too-few-points"),
        (vec![far, p(2.0, 1.0), p(3.0, 0.0)], "out-of-range"),
        (vec![p(1.0, f64::NAN), p(2.0, 1.0), p(3.0, 0.0)], "out-of-range"),
    ] {
        let mut builder = ContourBuilder::new(DVec2::ZERO);
        builder.segment(bezier(&controls), Attributes::at(Origin::Segment(0)));
        let built = builder.build(false);
        assert_eq!(built.diagnostics[0].code, code, "{:?}", built.diagnostics);
        let contour = built.contour.expect("a line");
        assert!(matches!(contour.segments()[0].curve, Curve::Line(_)), "{controls:?}");
        assert_eq!(contour.end(), controls[controls.len() - 1], "to its end");
    }
    let nothing = built(&[DVec2::ZERO; 3]);
    assert!(nothing.is_none(), "a standstill is no segment: {nothing:?}");
    assert!(built(&[]).is_none(), "nor is nothing");
}

#[test]
fn a_live_contour_follows_edits_of_cubics() {
    let mut builder = ContourBuilder::new(DVec2::ZERO);
    let at = |i| Attributes::at(Origin::Segment(i));
    builder.segment(line(p(20.0, 0.0)), at(0));
    builder.segment(bezier(&[p(30.0, 0.0), p(40.0, 10.0), p(40.0, 20.0)]), at(1));
    builder.segment(line(p(40.0, 50.0)), at(2));
    let tool = Tool::new(3.0, Side::Left).expect("a radius");
    let mut live = LiveContour::new(builder, false, tool, Options::default(), 1e-6);
    let polyline = |live: &mut LiveContour| -> Vec<DVec2> {
        live.update();
        live.path_points().chunks_exact(2).map(|xy| p(xy[0], xy[1])).collect()
    };
    let agree = |live: &mut LiveContour, what: &str| {
        let own = polyline(live);
        let contour = live.described().clone().build(false).contour.expect("a contour");
        let fresh = vertices(&compensate(&contour, tool, &Options::default()), 1e-6);
        for point in own.iter().step_by(5) {
            assert!(to_polyline(*point, &fresh) < 1e-5, "{what}: {point}");
        }
        assert!(own.len() > 10, "{what}: {} vertices", own.len());
    };
    agree(&mut live, "as made");
    live.move_point(1, 1, p(43.0, 12.0)).expect("a control point");
    agree(&mut live, "a control point moved");
    live.move_point(1, 2, p(41.0, 22.0)).expect("its end");
    agree(&mut live, "its end moved");
    assert!(live.insert_point(1, 0, p(1.0, 1.0)).is_err(), "it has no type points");
    live.set_segment(1, line(p(41.0, 22.0))).expect("a segment");
    agree(&mut live, "a line in its place");
    live.set_segment(1, bezier(&[p(20.0, 9.0), p(30.0, 22.0), p(41.0, 22.0)])).expect("a segment");
    agree(&mut live, "cubics again, and a corner");
}

#[test]
fn a_cubic_is_offset_as_the_spline_that_it_is() {
    // A natural spline of one span with its own tangents is one cubic; both ways to make it agree.
    let cubic = Cubic::new(p(0.0, 0.0), p(10.0, 5.0), p(20.0, 5.0), p(30.0, 0.0));
    let sketch = Sketch::open(DVec2::ZERO, [bezier(&cubic.points[1..])]);
    let contour = sketch.contour();
    let Curve::Spline(spline) = &contour.segments()[0].curve else { panic!("a spline") };
    assert_eq!(spline.pieces(), [cubic], "as it is given");
}
