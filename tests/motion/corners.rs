//! Corner curves against 50-digit arithmetic, tables of their figures, and differences of points.

use g41::motion::{Corner, CornerCurve, CornerShape};
use glam::{DVec2, DVec3};

use crate::common::near;

const CURVES: [CornerCurve; 4] =
    [CornerCurve::Ph13, CornerCurve::Ph11, CornerCurve::Ph9, CornerCurve::Ph5];

/// A few times the spacing of numbers below 1, relative and of control points [mm].
const ROUNDING: f64 = 2e-15;

/// A right-handed pair of unit vectors of space that no axis is in line with.
fn oblique() -> [DVec3; 2] {
    let x = DVec3::new(2.0, -1.0, 3.0).normalize();
    let y = x.cross(DVec3::new(1.0, 2.0, -1.0)).normalize();
    [x, y]
}

/// The tangents of a turn [°].
fn turn(degrees: f64) -> [DVec3; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let [x, y] = oblique();
    [x, x * cos + y * sin]
}

fn corner(curve: CornerCurve, degrees: f64, leg: f64) -> Corner {
    Corner::with_leg(curve, DVec3::ZERO, turn(degrees), leg).expect("it turns")
}

#[test]
fn closed_forms_and_control_points_agree_with_50_digits() {
    let table = include_str!("data/corners.txt");
    let mut rows = 0;
    for line in table.lines().filter(|line| !line.starts_with('#')) {
        let row: Vec<f64> = line.split(' ').map(|n| n.parse().expect("a number")).collect();
        let [degrees, x, y, scale, length, deviation, curvature, sharpness, jerk] =
            *row.first_chunk().expect("the row has columns");
        let outgoing = DVec3::new(x, y, 0.0);
        let tangents = [DVec3::X, outgoing];
        let shape = CornerShape::between(CornerCurve::Ph13, DVec3::X, outgoing).expect("a turn");
        let corner =
            Corner::with_leg(CornerCurve::Ph13, DVec3::ZERO, tangents, 1.0).expect("a turn");
        let same = |actual: f64, expected: f64, slack: f64, what: &str| {
            near(actual / expected, 1.0, slack, &format!("{degrees}°: {what}"));
        };
        same(corner.scale(), scale, ROUNDING, "scale");
        same(corner.length(), length, ROUNDING, "length");
        same(shape.deviation() * scale, deviation, ROUNDING, "deviation");
        same(shape.largest_curvature() / scale, curvature, ROUNDING, "largest curvature");
        let square = scale * scale;
        same(shape.largest_sharpness() / square, sharpness, 1.5e-4, "its largest derivative");
        let bound = shape.jerk_constant() / square;
        assert!(bound >= jerk && bound <= 1.018 * jerk, "{degrees}°: {bound} bounds {jerk}");

        let points = corner.control_points();
        let expected: Vec<DVec3> =
            row[9..].chunks(2).map(|p| DVec3::new(p[0], p[1], 0.0)).collect();
        assert_eq!(points.len(), expected.len(), "of degree 13");
        for (k, (point, expected)) in points.iter().zip(&expected).enumerate() {
            let error = point.distance(*expected);
            assert!(error <= ROUNDING, "{degrees}°: control point {k} is off by {error:e}");
        }
        rows += 1;
    }
    assert_eq!(rows, 27, "turns from 1e-6° to 179.9°");
}

#[test]
fn the_curve_by_arc_length_is_the_curve_of_its_control_points() {
    for curve in CURVES {
        for degrees in [1e-3, 10.0, 60.0, 90.0, 135.0, 170.0, 179.9] {
            let corner = corner(curve, degrees, 1.0);
            let points = corner.control_points();
            // The square root of the sum of squares of the hodograph, by Simpson's rule.
            let speed = |t: f64| derivative(&points, t).length();
            let mut length = 0.0;
            let places = 400;
            for i in 0..places {
                let [from, to] = [i, i + 1].map(|i| f64::from(i) / f64::from(places));
                let error = corner.frame(length).point.distance(bezier(&points, from));
                assert!(error < 3e-13, "{curve:?} {degrees}°, {from}: off by {error:e}");
                let mut inner = 0.0;
                for k in 0..8 {
                    let h = (to - from) / 8.0;
                    let a = from + h * f64::from(k);
                    inner += h / 6.0 * (speed(a) + 4.0 * speed(a + 0.5 * h) + speed(a + h));
                }
                length += inner;
            }
            near(corner.length(), length, 1e-12, "the length of the curve");
        }
    }
}

/// A point of a curve in Bernstein form (de Casteljau).
fn bezier(points: &[DVec3], t: f64) -> DVec3 {
    let mut points = points.to_vec();
    while points.len() > 1 {
        points = points.windows(2).map(|pair| pair[0].lerp(pair[1], t)).collect();
    }
    points[0]
}

fn derivative(points: &[DVec3], t: f64) -> DVec3 {
    let degree = (points.len() - 1) as f64;
    let steps: Vec<DVec3> = points.windows(2).map(|pair| (pair[1] - pair[0]) * degree).collect();
    bezier(&steps, t)
}

#[test]
fn figures_of_degree_13_are_those_of_the_table() {
    // Turn [°], leg, largest curvature, derivative of it and jerk constant for a deviation of 1 mm.
    let table = [
        (1.0, 366.7, 4.462e-5, 1.874e-7, 1.874e-7),
        (10.0, 36.60, 0.004_477, 1.886e-4, 1.886e-4),
        (30.0, 12.02, 0.041_35, 0.005_366, 0.005_376),
        (45.0, 7.850, 0.096_61, 0.019_55, 0.019_63),
        (60.0, 5.716, 0.1815, 0.051_85, 0.052_23),
        (90.0, 3.495, 0.4859, 0.2512, 0.2549),
        (120.0, 2.306, 1.171, 1.130, 1.372),
        (135.0, 1.888, 1.886, 2.672, 3.558),
        (150.0, 1.542, 3.339, 7.785, 11.15),
        (170.0, 1.163, 12.13, 95.97, 147.2),
        (179.0, 1.016, 131.1, 1.10e4, 1.72e4),
    ];
    for (degrees, leg, curvature, sharpness, jerk) in table {
        let corner = corner(CornerCurve::Ph13, degrees, 1.0);
        let unit = corner.scale() * corner.shape().deviation();
        let [mut most, mut sharpest, mut jerkiest] = [0.0_f64; 3];
        for i in 0..=4000 {
            let frame = corner.frame(corner.length() * f64::from(i) / 4000.0);
            let bend = frame.curvature.length();
            most = most.max(bend);
            let across = frame.sharpness + frame.tangent * (bend * bend);
            sharpest = sharpest.max(across.length());
            jerkiest = jerkiest.max(frame.sharpness.length());
        }
        let square = unit * unit;
        for (actual, expected, what) in [
            (1.0 / unit, leg, "leg"),
            (most * unit, curvature, "largest curvature"),
            (sharpest * square, sharpness, "its largest derivative"),
            (jerkiest * square, jerk, "jerk constant"),
        ] {
            // Four digits, the two of the last row three.
            let slack = if degrees == 179.0 { 6e-3 } else { 6e-4 };
            near(actual / expected, 1.0, slack, &format!("{degrees}°: {what}"));
        }
    }
}

#[test]
fn relatives_have_the_figures_of_their_table() {
    // Largest curvature, leg and jerk constant for a right angle and a deviation of 1 mm.
    let table = [
        (CornerCurve::Ph5, 0.655, 5.86, None),
        (CornerCurve::Ph9, 0.570, 3.91, Some(0.365)),
        (CornerCurve::Ph11, 0.517, 3.83, Some(0.280)),
        (CornerCurve::Ph13, 0.486, 3.49, Some(0.255)),
    ];
    for (curve, curvature, leg, jerk) in table {
        let [from, to] = turn(90.0);
        let shape = CornerShape::between(curve, from, to).expect("it turns");
        let unit = shape.deviation();
        near(shape.largest_curvature() * unit, curvature, 6e-4, "largest curvature");
        near(shape.leg() / unit, leg, 6e-3, "leg");
        if let Some(jerk) = jerk {
            near(shape.jerk_constant() * unit * unit, jerk, 2e-3, "jerk constant");
        }
    }
}

#[test]
fn bounds_hold_along_every_curve_and_are_close() {
    for curve in CURVES {
        for i in 1..=340 {
            let degrees = 0.5 * f64::from(i);
            let corner = corner(curve, degrees, 1.0);
            let (shape, scale) = (corner.shape(), corner.scale());
            let [mut bend, mut change, mut jerk] = [0.0_f64; 3];
            for k in 0..=500 {
                let frame = corner.frame(corner.length() * f64::from(k) / 500.0);
                let curvature = frame.curvature.length();
                bend = bend.max(curvature * scale);
                let across = frame.sharpness + frame.tangent * (curvature * curvature);
                change = change.max(across.length() * scale * scale);
                jerk = jerk.max(frame.sharpness.length() * scale * scale);
            }
            for (found, bound, what) in [
                (bend, shape.largest_curvature() * (1.0 + 1e-12), "curvature"),
                (change, shape.largest_sharpness(), "its derivative"),
                (jerk, shape.jerk_constant(), "jerk"),
            ] {
                assert!(found <= bound, "{curve:?} {degrees}°: {what} {found} above {bound}");
                assert!(found > 0.98 * bound, "{curve:?} {degrees}°: {what} {found}, {bound}");
            }
        }
    }
}

#[test]
fn frames_are_the_derivatives_of_the_points() {
    for curve in CURVES {
        for degrees in [0.01, 5.0, 45.0, 90.0, 150.0] {
            let corner = corner(curve, degrees, 2.0);
            let h = 1e-4 * corner.length();
            let bend = corner.shape().largest_curvature() / corner.scale();
            for i in 1..40 {
                let s = corner.length() * f64::from(i) / 40.0;
                let [before, here, after] = [s - h, s, s + h].map(|s| corner.frame(s));
                let what = format!("{curve:?} {degrees}° at {s}");
                let slope = |a: DVec3, b: DVec3| (b - a) / (2.0 * h);
                let close = |found: DVec3, said: DVec3, scale: f64, order: &str| {
                    let error = found.distance(said) / scale;
                    assert!(error < 3e-5, "{what}: {order} off by {error:e}");
                };
                close(slope(before.point, after.point), here.tangent, 1.0, "tangent");
                close(slope(before.tangent, after.tangent), here.curvature, bend, "curvature");
                let sharp = corner.shape().jerk_constant() / corner.scale().powi(2);
                close(slope(before.curvature, after.curvature), here.sharpness, sharp, "sharpness");
                near(here.tangent.length(), 1.0, 1e-14, &what);
            }
        }
    }
}

#[test]
fn the_path_has_a_continuous_third_derivative_where_line_and_curve_meet() {
    // Third differences of points along line, curve and line: what the jerk is made of at a steady
    // speed. Over a joint they are of the size of the step of the jerk, or vanish with their span.
    for curve in CURVES {
        for degrees in [1.0, 30.0, 90.0, 150.0] {
            let corner = corner(curve, degrees, 1.0);
            let [incoming, outgoing] = corner.legs();
            let along = |s: f64| {
                if s < 0.0 {
                    incoming.start + incoming.tangent * s
                } else if s <= corner.length() {
                    corner.frame(s).point
                } else {
                    let beyond = outgoing.length + s - corner.length();
                    outgoing.start + outgoing.tangent * beyond
                }
            };
            let unit = corner.shape().jerk_constant() / corner.scale().powi(2);
            let across = |joint: f64, h: f64| {
                let third = |s: f64| {
                    let p = [-1.5, -0.5, 0.5, 1.5].map(|k| along(s + k * h));
                    ((p[3] - p[0]) - (p[2] - p[1]) * 3.0) / (h * h * h)
                };
                third(joint - h).distance(third(joint + h)) / unit
            };
            for joint in [0.0, corner.length()] {
                let step = across(joint, 1e-3 * corner.length());
                let coarse = across(joint, 2e-3 * corner.length());
                if curve == CornerCurve::Ph5 {
                    let stays = step > 0.001 && step > 0.9 * coarse;
                    assert!(stays, "degree 5 has a step, not {step} and {coarse} at {degrees}°");
                } else {
                    assert!(step < 0.25, "{curve:?} {degrees}°: a step of {step}");
                    assert!(step < 0.7 * coarse, "{curve:?}: {step} does not vanish, {coarse}");
                }
            }
        }
    }
}

#[test]
fn the_deviation_is_that_of_the_nearest_points() {
    for curve in CURVES {
        for degrees in [0.1, 10.0, 45.0, 90.0, 135.0, 170.0] {
            let corner = corner(curve, degrees, 1.0);
            let [incoming, outgoing] = turn(degrees);
            let said = corner.shape().deviation() * corner.scale();
            let (mut nearest, mut farthest) = (f64::INFINITY, 0.0_f64);
            for i in 0..=2000 {
                let point = corner.frame(corner.length() * f64::from(i) / 2000.0).point;
                nearest = nearest.min(point.length());
                let to = |tangent: DVec3, from: f64, to: f64| {
                    point.distance(tangent * point.dot(tangent).clamp(from, to))
                };
                farthest = farthest.max(to(incoming, -1.0, 0.0).min(to(outgoing, 0.0, 1.0)));
            }
            near(nearest / said, 1.0, 1e-6, "the corner is farthest from the curve at its middle");
            let half = (0.5 * degrees).to_radians().cos();
            near(farthest / (said * half), 1.0, 1e-5, "and the curve from the lines");
        }
    }
}

#[test]
fn curvature_rises_to_the_middle_and_falls_again() {
    for curve in CURVES {
        for degrees in [1e-3, 1.0, 30.0, 90.0, 150.0, 179.0] {
            let corner = corner(curve, degrees, 1.0);
            let mut last = -1.0;
            for i in 0..=200 {
                let bend = corner.frame(corner.length() * f64::from(i) / 400.0).curvature.length();
                assert!(bend > last, "{curve:?} {degrees}°: falls at {i}");
                last = bend;
            }
        }
    }
}

#[test]
fn what_does_not_turn_or_goes_back_has_no_corner() {
    for curve in CURVES {
        let straight = Corner::with_leg(curve, DVec3::ZERO, [DVec3::X, DVec3::X], 1.0);
        assert_eq!(straight, None, "no turn, no plane");
        assert_eq!(CornerShape::between(curve, DVec3::X, DVec3::NEG_X), None, "a reversal");
    }
    // The least turn that two unit vectors can tell.
    let least = DVec2::new(1.0, 1e-15).extend(0.0);
    let corner = Corner::with_leg(CornerCurve::Ph13, DVec3::ZERO, [DVec3::X, least], 1.0);
    let frame = corner.expect("it turns").frame(0.7);
    near(frame.point.x, -0.3, 1e-15, "it is almost the line");
    assert!(frame.sharpness.is_finite(), "and can be traversed");
}
