//! Limits of planned motion, judged from its samples, on many shapes and two machines.

use g41::contour::Move;
use g41::motion::{AxisLimits, CornerCurve, CurvatureSteps, Limits, Motion, Planner, plan};

use glam::{DVec2, DVec3};

use crate::common::random::Random;
use crate::shapes;

/// What rounding may add to a limit's whole.
const ROUNDED: f64 = 1.0e-5;

fn fast() -> Limits {
    Limits {
        velocity: 500.0,
        acceleration: 5000.0,
        jerk: 5.0e5,
        corner_deviation: 0.02,
        ..Limits::default()
    }
}

/// Plans moves, and holds the samples to every limit.
fn hold(name: &str, moves: &[Move], limits: &Limits) -> Motion {
    let motion = plan(moves, limits).expect("limits within reason");
    let found = motion.violations(moves, limits);
    for (what, peak, most) in [
        ("velocity", found.velocity, 1.0),
        ("feed", found.feed, 1.0),
        ("acceleration", found.acceleration, 1.0),
        ("jerk", found.jerk, 1.0),
        ("change of jerk", found.jerk_change, 1.0),
        ("deviation", found.deviation, 1.0),
        ("chord error", found.chord_error, 1.0),
    ] {
        let ratio = peak.ratio();
        assert!(ratio < most + ROUNDED, "{name}: {what} {ratio} of its limit, {peak:?}");
    }
    for (axis, peaks) in found.axes.iter().enumerate() {
        for peak in peaks {
            assert!(peak.ratio() < 1.0 + ROUNDED, "{name}: axis {axis}: {peak:?}");
        }
    }
    assert!(found.end < 1e-9, "{name}: ends {} off", found.end);
    motion
}

#[test]
fn no_limit_is_broken_on_polylines() {
    for limits in [Limits::default(), fast()] {
        hold("square", &shapes::square(), &limits);
        hold("star", &shapes::star(), &limits);
        hold("random 2-D", &shapes::random_2d(), &limits);
        hold("random 3-D", &shapes::random_3d(), &limits);
    }
}

#[test]
fn no_limit_is_broken_at_sharp_corners_beside_tiny_lines() {
    // What rounding to four decimals leaves between two moves, and far less.
    let mut random = Random::new(41);
    for case in 0..150 {
        let limits = Limits { fit: case % 2 == 0, ..fast() };
        let tiny = 10.0_f64.powf(random.within(-7.5, -2.0));
        let mut points = vec![DVec3::ZERO];
        let mut angle = 0.0;
        for k in 0..5 {
            let length = if k == 2 { tiny } else { random.within(2.0, 12.0) };
            points.push(points[k] + DVec2::from_angle(angle).extend(0.0) * length);
            angle += random.within(-2.8, 2.8);
        }
        let mut moves = shapes::polyline(&points);
        let feed = 10.0_f64.powf(random.within(-1.0, 2.0));
        for one in &mut moves {
            one.feed = Some(feed);
        }
        hold(&format!("case {case}: a line of {tiny:e} mm at {feed} mm/s"), &moves, &limits);
    }
}

#[test]
fn no_limit_is_broken_on_spirals() {
    for limits in [Limits::default(), fast()] {
        for count in [401, 1001, 10001] {
            hold(&format!("spiral of {count}"), &shapes::spiral(count), &limits);
        }
    }
}

#[test]
fn no_limit_is_broken_along_compensated_arcs_and_splines() {
    for limits in [Limits::default(), fast()] {
        for (name, text) in shapes::PROGRAMS {
            hold(name, &shapes::compensated(text, 1.5), &limits);
        }
    }
}

#[test]
fn no_limit_is_broken_with_any_corner_curve_or_with_exact_stops() {
    // The corner of degree 5 has steps of the jerk, so its change is not asked about.
    for corner in [CornerCurve::Ph13, CornerCurve::Ph11, CornerCurve::Ph9] {
        hold("star", &shapes::star(), &Limits { corner, ..Limits::default() });
    }
    let stops = Limits { exact_stop: true, ..Limits::default() };
    let motion = hold("stops", &shapes::square(), &stops);
    let rests = motion.velocity.iter().filter(|velocity| **velocity < 1.0).count();
    assert!(rests >= 6, "the tool rests at each corner: {rests}");
}

#[test]
fn axes_keep_their_own_limits() {
    let axes = AxisLimits {
        velocity: [150.0, 80.0, 20.0],
        acceleration: [1500.0, 900.0, 300.0],
        jerk: [4.0e4, 2.0e4, 1.0e4],
    };
    let limits = Limits { axes: Some(axes), ..Limits::default() };
    let slow = hold("random 3-D", &shapes::random_3d(), &limits).duration;
    let quick = plan(&shapes::random_3d(), &Limits::default()).expect("limits").duration;
    assert!(slow > quick, "slower axes take longer: {slow} than {quick}");
    hold("square", &shapes::square(), &limits);
}

#[test]
fn steps_of_curvature_are_passed_slowly_or_at_rest() {
    let (_, slot) = shapes::PROGRAMS[4];
    let moves = shapes::compensated(slot, 1.5);
    for curvature_steps in [CurvatureSteps::Slow, CurvatureSteps::Stop] {
        let limits = Limits { curvature_steps, ..Limits::default() };
        let motion = plan(&moves, &limits).expect("limits");
        let found = motion.violations(&moves, &limits);
        assert!(found.acceleration.ratio() < 1.0005, "{curvature_steps:?}: {found:?}");
        assert!(found.jerk.ratio() < 1.0005, "{curvature_steps:?}: {found:?}");
        assert!(found.jerk_change.ratio() < 1.0005, "{curvature_steps:?}: {found:?}");
    }
}

#[test]
fn arcs_of_opposite_bends_with_too_little_between_them_to_round_are_passed_slowly() {
    // What compensation leaves of rounded coordinates: a line of some nanometres between two arcs.
    let text = "G17 G21 G90\nG41 D1 G0 X34.3468 Y-9.1397\nG1 G91 X-5.1962 Y-3 F600\n\
                G3 X-3.6602 Y-13.6603 I5 J-8.6603\nG2 I-12.9904 J-7.5\nG3 X13.6602 Y-3.6603 I8.6602 J5\n\
                G40 G1 X5.1962 Y3\nM2\n";
    let moves = shapes::compensated(text, 3.0);
    let limits = Limits { corner_deviation: 0.02, ..Limits::default() };
    hold("opposite arcs", &moves, &limits);
}

#[test]
fn long_paths_go_on_from_window_to_window_without_a_rest() {
    let rows: Vec<DVec3> = (0..=4000_u32)
        .map(|k| {
            let (row, on) = (k / 400, k % 400);
            let x = 0.2 * f64::from(if row % 2 == 0 { on } else { 399 - on });
            let y = (0.16 * x).sin() + 0.4 * (0.47 * x + 2.0).sin();
            DVec3::new(x, 0.5 * f64::from(row) + 8.0 * y, 2.4 * (0.24 * x).cos())
        })
        .collect();
    for (name, moves, least) in [
        ("random 2-D", shapes::random_2d(), 20.0),
        ("random 3-D", shapes::random_3d(), 20.0),
        ("rows of waves", shapes::polyline(&rows), 15.0),
    ] {
        let motion = hold(name, &moves, &Limits::default());
        assert!(motion.duration > least, "{name}: longer than a window: {} s", motion.duration);
        let moving = &motion.velocity[10..motion.len() - 10];
        let slowest = moving.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(slowest > 0.05, "{name}: rests on the way: {slowest} mm/s");
    }
}

#[test]
fn no_limit_is_broken_between_the_places_where_a_law_is_looked_at() {
    // Lines of 3 to 40 mm.
    let points = [
        [0.0, 0.0],
        [19.21, -1.46],
        [2.73, -28.25],
        [-2.61, -13.5],
        [-6.6, -1.09],
        [4.44, -17.73],
        [-15.68, -24.51],
        [-14.95, -13.39],
        [6.25, -28.66],
        [5.56, 3.13],
        [-12.27, -25.12],
        [2.92, -26.8],
        [-14.28, -0.09],
        [-9.6, -1.73],
        [15.27, -6.54],
        [13.17, -13.38],
        [-6.61, -14.18],
        [-1.5, -3.3],
        [2.59, -4.99],
        [0.08, -2.76],
        [-15.36, -4.7],
        [13.09, -27.02],
        [15.48, -2.87],
        [-8.85, -25.48],
        [18.45, -9.01],
        [4.85, -24.71],
        [13.25, -11.7],
        [-8.56, -16.38],
        [2.75, -25.43],
        [-9.72, -0.91],
        [4.24, -7.95],
        [18.93, -10.82],
        [-4.93, -25.98],
        [4.14, -18.02],
        [-15.01, -31.96],
        [1.52, -6.71],
        [7.43, -11.24],
        [4.41, 1.37],
        [-11.51, -19.07],
        [-2.71, -2.18],
        [13.27, -14.18],
    ];
    let points = points.map(|[x, y]| DVec3::new(x, y, 0.0));
    hold("long lines", &shapes::polyline(&points), &Limits::default());
}

#[test]
fn jerk_changes_slowly_enough_on_blocks_of_micrometres_beside_long_ones() {
    let points = [
        [0.0, 0.0],
        [0.2985, -1.6457],
        [0.4036, -2.0202],
        [5.8318, 2.9578],
        [5.875, 3.2232],
        [5.7291, 3.17],
        [5.783, 3.1031],
        [4.7218, 4.6663],
        [4.5847, 4.5],
        [4.8266, 4.3977],
        [4.8327, 4.9119],
        [2.6993, 3.8921],
        [3.0758, 3.5207],
        [3.1006, 3.587],
        [-1.5827, 3.1968],
    ];
    let points = points.map(|[x, y]| DVec3::new(x, y, 0.0));
    hold("long and short", &shapes::polyline(&points), &Limits::default());
}

#[test]
fn feeds_are_kept_and_overridden() {
    let mut moves = shapes::square();
    for (one, feed) in moves.iter_mut().zip([20.0, 60.0, 5.0, 40.0, 100.0]) {
        one.feed = Some(feed);
    }
    let plain = hold("feeds", &moves, &Limits::default()).duration;
    let limits = Limits { feed_override: 0.5, ..Limits::default() };
    let halved = hold("half the feeds", &moves, &limits).duration;
    assert!(halved > 1.8 * plain, "half the feed takes nearly twice as long: {halved}, {plain}");
    let ideal = 50.0 / 20.0 + 50.0 / 60.0 + 50.0 / 5.0 + 50.0 / 40.0 + 25.0 / 100.0;
    assert!(plain > ideal && plain < 1.05 * ideal, "{plain} for {ideal} at the bare feeds");
}

#[test]
fn dwells_stand_still_for_their_time() {
    let moves = shapes::square();
    let mut planner = Planner::new(&Limits::default()).expect("limits");
    let mut motion = Motion::default();
    for (index, one) in moves.iter().enumerate() {
        if index == 2 {
            planner.pause(0.25, &mut motion);
        }
        planner.push(one, &mut motion);
    }
    planner.finish(&mut motion);
    let corner = glam::dvec3(50.0, 50.0, 0.0);
    let there = (0..motion.len()).filter(|k| motion.point(*k).distance(corner) < 1e-9).count();
    assert!((250..=252).contains(&there), "{there} periods at the corner");
    let bad = motion.violations(&moves, &Limits::default()).worst();
    assert!(bad < 1.0005, "{bad} of a limit");
}

#[test]
fn tiny_and_awkward_paths_are_planned() {
    let at = |x: f64, y: f64| glam::dvec3(x, y, 0.0);
    for (name, points) in [
        ("a micrometre", vec![at(0.0, 0.0), at(1e-3, 0.0)]),
        ("there and back", vec![at(0.0, 0.0), at(10.0, 0.0), at(0.0, 0.0)]),
        ("collinear", vec![at(0.0, 0.0), at(1.0, 0.0), at(2.0, 0.0), at(30.0, 0.0)]),
        ("nearly straight", vec![at(0.0, 0.0), at(10.0, 0.0), at(20.0, 1e-4)]),
        ("nearly back", vec![at(0.0, 0.0), at(10.0, 0.0), at(0.0, 0.2)]),
        ("steps of a micrometre", (0..60).map(|k| at(f64::from(k) * 1e-3, 0.0)).collect()),
        ("a long way", vec![at(0.0, 0.0), at(2000.0, 0.0), at(2000.0, 1.0)]),
    ] {
        let moves = shapes::polyline(&points);
        for limits in [Limits::default(), fast()] {
            let motion = hold(name, &moves, &limits);
            assert!(motion.duration < 60.0, "{name}: {} s", motion.duration);
        }
    }
    assert!(plan(&[], &Limits::default()).expect("limits").is_empty(), "no moves, no samples");
}

#[test]
fn bad_limits_are_named() {
    for (name, limits) in [
        ("velocity", Limits { velocity: 0.0, ..Limits::default() }),
        ("jerk", Limits { jerk: f64::NAN, ..Limits::default() }),
        ("period", Limits { period: -1.0, ..Limits::default() }),
        ("cornerDeviation", Limits { corner_deviation: -0.1, ..Limits::default() }),
    ] {
        let error = plan(&shapes::square(), &limits).expect_err("a limit that cannot be held");
        assert_eq!(error.name, name, "the limit at fault");
    }
}
