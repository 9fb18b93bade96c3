//! Rules that step along a spline, judged by the arc length of each step.

use std::f64::consts::TAU;

use g41::contour::Plane;
use g41::geometry::{Parameter, Spline, SplineEnds};
use g41::motion::{ByLength, Piece, StepRule, interpolate, lengths_at};
use glam::DVec2;

use crate::common::p;

/// A closed flower of five petals, radius 20 mm, through 60 points.
fn flower() -> Spline {
    let mut points: Vec<DVec2> = Vec::new();
    for i in 0..60 {
        let angle = f64::from(i) * TAU / 60.0;
        points.push(DVec2::from_angle(angle) * (20.0 + 4.0 * (5.0 * angle).cos()));
    }
    points.push(points[0]);
    Spline::through(points, SplineEnds::Periodic, Parameter::Chord).expect("a spline")
}

/// Two wings that meet in a tip of radius 0.12 mm: almost a cusp.
fn near_cusp() -> Spline {
    let wing = [(0.0, 0.0), (4.0, 6.0), (9.5, 9.0), (10.0, 9.6), (10.5, 9.0), (16.0, 6.0)];
    let mut points: Vec<DVec2> = wing.iter().map(|&(x, y)| p(x, y)).collect();
    points.push(p(20.0, 0.0));
    Spline::through(points, SplineEnds::NATURAL, Parameter::Chord).expect("a spline")
}

/// Arc length between two parameters of a spline (Simpson's rule between its knots).
fn arc(spline: &Spline, from: f64, to: f64) -> f64 {
    let mut sum = 0.0;
    let mut at = from;
    for span in spline.locate(from).0..=spline.locate(to).0 {
        let end = to.min(spline.parameter_at(span, 1.0));
        let h = (end - at) / 64.0;
        for i in 0..64 {
            let a = at + h * f64::from(i);
            // Just inside its ends, where the span itself speaks.
            let speed = |t: f64| spline.derivative(t.clamp(at + 1e-9 * h, end - 1e-9 * h)).length();
            sum += h / 6.0 * (speed(a) + 4.0 * speed(a + 0.5 * h) + speed(a + h));
        }
        at = end;
    }
    sum
}

/// The largest relative error of the feed of a rule, by the chord where it is made for chords.
fn fluctuation(spline: &Spline, step: f64, rule: StepRule) -> f64 {
    let found = interpolate(spline, step, rule);
    let mut worst = 0.0_f64;
    for pair in found.windows(2) {
        let way = match rule {
            StepRule::PredictorCorrector(_) => {
                spline.point(pair[0]).distance(spline.point(pair[1]))
            }
            _ => arc(spline, pair[0].min(pair[1]), pair[0].max(pair[1])),
        };
        worst = worst.max((way / step - 1.0).abs());
    }
    assert!(found.len() > 50, "{rule:?} went {} steps", found.len());
    worst
}

#[test]
fn each_rule_errs_as_its_table_says() {
    // The largest error of the feed on the flower with steps of 0.1 and 0.4 mm, and on the near cusp.
    let table = [
        (StepRule::TaylorFirst, [1.4e-3, 5.6e-3, 1.2e-1, 3.7e-1]),
        (StepRule::TaylorSecond, [1.5e-4, 2.3e-3, 3.1e-2, 1.6e-1]),
        (StepRule::RungeKutta, [2.2e-6, 5.3e-5, 3.8e-4, 4.0e-2]),
        (StepRule::PredictorCorrector(1), [7.1e-10, 5.4e-7, 1.7e-2, 1.5e-1]),
        (StepRule::PredictorCorrector(2), [1e-12, 1e-12, 3.0e-5, 3.8e-3]),
        (StepRule::PredictorCorrector(3), [1e-12, 1e-12, 9.4e-11, 5.9e-6]),
        (StepRule::ArcLength(1), [2.2e-11, 2.2e-8, 1.2e-4, 1.3e-2]),
        (StepRule::ArcLength(2), [1e-12, 1e-12, 1.2e-9, 5.0e-5]),
    ];
    let splines = [flower(), near_cusp()];
    for (rule, errors) in table {
        for (i, said) in errors.into_iter().enumerate() {
            let found = fluctuation(&splines[i / 2], [0.1, 0.4][i % 2], rule);
            assert!(found <= 1.05 * said, "{rule:?}, column {i}: {found:e}, not {said:e}");
            let rounding = said <= 1e-12;
            assert!(rounding || found >= 0.5 * said, "{rule:?}, column {i}: {found:e}");
        }
    }
}

#[test]
fn the_measured_length_beats_every_rule_but_those_that_measure_each_step() {
    for (spline, slack) in [(flower(), 1e-10), (near_cusp(), 5e-9)] {
        for step in [0.1, 0.4] {
            let mut worst = 0.0_f64;
            for (span, cubic) in spline.pieces().iter().enumerate() {
                let part = ByLength::of_cubic(cubic, Plane::Xy, [0.0, 0.0]).swap_remove(0);
                let piece = Piece::Curve(Box::new(part));
                let at = |s: f64| {
                    let nearest = cubic.nearest(piece.frame(s).point.truncate());
                    spline.parameter_at(span, nearest.t)
                };
                let mut s = 0.0;
                while s + step <= piece.length() {
                    worst = worst.max((arc(&spline, at(s), at(s + step)) / step - 1.0).abs());
                    s += step;
                }
            }
            assert!(worst <= slack, "steps of {step} mm err by {worst:e}");
        }
    }
}

#[test]
fn lengths_are_those_of_the_arcs_between() {
    let spline = near_cusp();
    let found = interpolate(&spline, 0.1, StepRule::ArcLength(3));
    let lengths = lengths_at(&spline, &found);
    assert_eq!(lengths.len(), found.len(), "a length for each point");
    for (i, (&t, &length)) in found.iter().zip(&lengths).enumerate().step_by(20) {
        let expected = arc(&spline, 0.0, t);
        assert!((length - expected).abs() < 1e-8, "{length} mm to point {i}, not {expected}");
    }
}

#[test]
fn a_step_that_is_none_gives_no_points() {
    for step in [0.0, -1.0, f64::NAN] {
        let found = interpolate(&near_cusp(), step, StepRule::RungeKutta);
        assert!(found.is_empty(), "steps of {step} mm");
    }
}
