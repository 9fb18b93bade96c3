//! Editing a spline point by point gives what laying it through all its points afresh gives.

use std::f64::consts::TAU;

use g41::geometry::{CurveError, EndCondition, Least, Parameter, Spline, SplineEdit, SplineEnds};
use glam::{DVec2, dvec2};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common::random::Random;

const STEPS: usize = if cfg!(target_arch = "wasm32") { 300 } else { 2000 };

/// Nothing is too small to be told.
const LEAST: Least = Least { beside: 1.0, by: 0.0 };

fn ring(count: usize, random: &mut Random) -> Vec<DVec2> {
    let mut points: Vec<DVec2> = (0..count)
        .map(|i| {
            let angle = TAU * (i as f64 + random.within(0.0, 0.6)) / count as f64;
            DVec2::from_angle(angle) * (count as f64 + random.within(-1.0, 1.0))
        })
        .collect();
    points.push(points[0]);
    points
}

fn every_end() -> [SplineEnds; 4] {
    let tangent = EndCondition::Tangent(dvec2(1.0, 2.0));
    [
        SplineEnds::NATURAL,
        SplineEnds::Open { start: tangent, end: EndCondition::Natural },
        SplineEnds::Open { start: EndCondition::Natural, end: tangent },
        SplineEnds::Periodic,
    ]
}

/// Largest distance of control points from those of the spline laid afresh.
fn error(edit: &SplineEdit, ends: SplineEnds, parameter: Parameter) -> f64 {
    let fresh = Spline::through(edit.points().to_vec(), ends, parameter).expect("it is a spline");
    let distance = |span: usize| {
        let (own, other) = (edit.cubic(span).points, fresh.pieces()[span].points);
        own.iter().zip(other).map(|(a, b)| a.distance(b)).fold(0.0, f64::max)
    };
    (0..edit.spans()).map(distance).fold(0.0, f64::max)
}

#[test]
fn thousands_of_edits_leave_the_spline_through_its_points() {
    for (seed, count) in [(1, 9), (2, 40), (3, 117), (4, 400)] {
        for ends in every_end() {
            for parameter in [Parameter::Chord, Parameter::Centripetal] {
                let mut random = Random::new(seed);
                let points = ring(count, &mut random);
                let spline = Spline::through(points, ends, parameter).expect("it is a spline");
                let mut edit = SplineEdit::new(&spline);
                for step in 0..STEPS {
                    let last = edit.spans();
                    let index = random.index(last - 1) + 1;
                    let by = dvec2(random.within(-0.4, 0.4), random.within(-0.4, 0.4));
                    let done = match random.index(4) {
                        0 if last < 2 * count => {
                            let middle = edit.points()[index - 1].midpoint(edit.points()[index]);
                            edit.insert_point(index, middle + by, LEAST)
                        }
                        1 if last > count / 2 && last > 6 => edit.remove_point(index, LEAST),
                        2 => edit.move_point(
                            random.index(last + 1),
                            edit.points()[index] + by * 4.0,
                            LEAST,
                        ),
                        _ => edit.move_point(index, edit.points()[index] + by, LEAST),
                    };
                    done.expect("random points do not coincide");
                    if step % 100 == 99 {
                        let error = error(&edit, ends, parameter);
                        assert!(
                            error < 1e-10 * count as f64,
                            "seed {seed}, {ends:?}, {parameter:?}, step {step}: {error} mm"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn spans_that_are_not_told_have_not_moved() {
    let mut random = Random::new(7);
    for ends in every_end() {
        let spline = Spline::through(ring(300, &mut random), ends, Parameter::Chord);
        let mut edit = SplineEdit::new(&spline.expect("it is a spline"));
        for _ in 0..200 {
            let before = edit.clone();
            let index = random.index(300);
            let to = edit.points()[index] + dvec2(random.within(-1.0, 1.0), 0.3);
            let least = Least { beside: 5.0, by: 1e-6 };
            let changed = edit.move_point(index, to, least).expect("points stay apart");
            assert!(changed.count < 70, "most spans stay as they are: {changed:?}");
            let told: Vec<usize> = (0..changed.count).map(|k| (changed.first + k) % 300).collect();
            for span in (0..300).filter(|span| !told.contains(span)) {
                let (new, old) = (edit.cubic(span), before.cubic(span));
                let moved = new.points.iter().zip(old.points).map(|(a, b)| a.distance(b));
                let moved = moved.fold(0.0, f64::max);
                assert!(moved < 1e-6, "{ends:?}, point {index}: span {span} moved by {moved} mm");
            }
        }
    }
}

#[test]
fn an_end_that_changes_bends_only_its_neighbourhood() {
    let mut random = Random::new(11);
    let points = ring(500, &mut random);
    let ends = SplineEnds::NATURAL;
    let spline = Spline::through(points, ends, Parameter::Chord).expect("it is a spline");
    let mut edit = SplineEdit::new(&spline);
    assert_eq!(edit.set_ends(ends, LEAST), None, "nothing has changed");
    let start = EndCondition::Tangent(dvec2(-1.0, 0.5));
    let bent = SplineEnds::Open { start, end: EndCondition::Natural };
    assert!(edit.set_ends(bent, LEAST).is_some(), "the start has changed");
    assert!(error(&edit, bent, Parameter::Chord) < 1e-9, "as laid afresh");
}

#[test]
fn a_point_on_its_neighbour_is_refused_and_changes_nothing() {
    let mut random = Random::new(13);
    let spline = Spline::through(ring(20, &mut random), SplineEnds::Periodic, Parameter::Chord);
    let mut edit = SplineEdit::new(&spline.expect("it is a spline"));
    let before = edit.clone();
    let neighbour = edit.points()[4];
    let refused = Err(CurveError::CoincidentPoints { index: 5 });
    assert_eq!(edit.move_point(5, neighbour, LEAST), refused, "moved");
    assert_eq!(edit.insert_point(5, neighbour, LEAST), refused, "inserted");
    assert_eq!(edit, before, "nothing is changed");
}

#[test]
fn a_part_is_the_same_curve() {
    let mut random = Random::new(17);
    let spline = Spline::through(ring(60, &mut random), SplineEnds::Periodic, Parameter::Chord);
    let edit = SplineEdit::new(&spline.expect("it is a spline"));
    let part = edit.part(50, 10);
    for k in 0..10 {
        assert_eq!(part.pieces()[k], edit.cubic(50 + k), "span {k}");
    }
    assert_eq!(part.tangent(1.0), edit.cubic(59).tangent(1.0), "tangent at the end");
}
