//! The judge of motion, on motions made up from closed forms: it finds each limit that is broken, and
//! no other.
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use g41::contour::{Move, MoveCurve, Plane, Role};
use g41::diagnostic::Origin;
use g41::geometry::{Arc, Line};
use g41::motion::{AxisLimits, Limits, Motion, Peak};
use glam::{DVec2, DVec3, dvec2, dvec3};

const PERIOD: f64 = 1e-3;

fn one_move(curve: MoveCurve, feed: Option<f64>) -> Move {
    Move {
        curve,
        role: Role::Segment,
        rapid: false,
        feed,
        plane: Plane::Xy,
        heights: [0.0, 0.0],
        origin: Origin::Segment(0),
    }
}

fn line(from: DVec2, to: DVec2) -> Move {
    one_move(MoveCurve::Line(Line::new(from, to).expect("it has a length")), None)
}

/// Samples of positions, with channels that say nothing.
fn motion_of(count: usize, position: impl Fn(f64) -> DVec3) -> Motion {
    let mut motion = Motion::default();
    for index in 0..count {
        let time = index as f64 * PERIOD;
        let DVec3 { x, y, z } = position(time);
        motion.time.push(time);
        motion.x.push(x);
        motion.y.push(y);
        motion.z.push(z);
        for channel in [
            &mut motion.velocity,
            &mut motion.tangential_acceleration,
            &mut motion.normal_acceleration,
            &mut motion.jerk,
        ] {
            channel.push(0.0);
        }
        motion.block.push(0);
        motion.duration = time;
    }
    motion
}

/// A quarter of a circle of 10 mm at 20 mm/s: acceleration v²/R = 40, jerk v³/R² = 80.
fn circle() -> (Motion, Vec<Move>) {
    let turn = std::f64::consts::FRAC_PI_2;
    let samples = 786;
    let angle = turn / 785.0 / PERIOD;
    let motion = motion_of(samples, |time| {
        dvec3(10.0 * (angle * time).cos(), 10.0 * (angle * time).sin(), 0.0)
    });
    let arc = Arc::from_center(dvec2(10.0, 0.0), dvec2(0.0, 10.0), DVec2::ZERO, false, 1e-9)
        .expect("it is one");
    (motion, vec![one_move(MoveCurve::Arc(arc), None)])
}

fn loose() -> Limits {
    Limits { velocity: 21.0, acceleration: 41.0, jerk: 82.0, ..Limits::default() }
}

/// The names of all limits that are broken.
fn broken(motion: &Motion, moves: &[Move], limits: &Limits) -> Vec<&'static str> {
    let found = motion.violations(moves, limits);
    let end = Peak { value: found.end, limit: 1e-9, time: 0.0 };
    let mut peaks = vec![
        ("velocity", found.velocity),
        ("feed", found.feed),
        ("acceleration", found.acceleration),
        ("jerk", found.jerk),
        ("jerk change", found.jerk_change),
        ("deviation", found.deviation),
        ("chord error", found.chord_error),
        ("end", end),
    ];
    for peaks_of_axis in &found.axes {
        let names = ["axis velocity", "axis acceleration", "axis jerk"];
        peaks.extend(names.into_iter().zip(peaks_of_axis.iter().copied()));
    }
    let is_broken = |peak: &Peak| peak.value.is_nan() || peak.ratio() > 1.0 + 1e-6;
    peaks.iter().filter(|(_, peak)| is_broken(peak)).map(|(name, _)| *name).collect()
}

const NONE: [&str; 0] = [];

fn assert_near(value: f64, expected: f64, within: f64, what: &str) {
    assert!((value - expected).abs() <= within, "{what}: {value}, not {expected}");
}

#[test]
fn positions_alone_tell_velocity_acceleration_and_jerk() {
    let (motion, moves) = circle();
    assert_eq!(broken(&motion, &moves, &loose()), NONE, "within all limits");
    for (limits, name, expected) in [
        (Limits { velocity: 19.9, ..loose() }, "velocity", 20.0),
        (Limits { acceleration: 39.9, ..loose() }, "acceleration", 40.0),
        (Limits { jerk: 79.5, ..loose() }, "jerk", 80.0),
    ] {
        assert_eq!(broken(&motion, &moves, &limits), [name], "it alone");
        let found = motion.violations(&moves, &limits);
        let peak = match name {
            "velocity" => found.velocity,
            "acceleration" => found.acceleration,
            _ => found.jerk,
        };
        assert_near(peak.value, expected, 0.02 * expected, name);
    }
}

#[test]
fn limits_of_axes_are_those_of_x_y_and_z() {
    let (motion, moves) = circle();
    let axes = |velocity, acceleration, jerk| Limits {
        axes: Some(AxisLimits { velocity, acceleration, jerk }),
        ..loose()
    };
    let [v, a, j] = [[21.0; 3], [41.0; 3], [82.0; 3]];
    assert_eq!(broken(&motion, &moves, &axes(v, a, j)), NONE, "within all limits");
    assert_eq!(
        broken(&motion, &moves, &axes([21.0, 19.0, 1.0], a, j)),
        ["axis velocity"],
        "y is fastest where the circle begins, and z does not move"
    );
    assert_eq!(
        broken(&motion, &moves, &axes(v, [39.0, 41.0, 1.0], j)),
        ["axis acceleration"],
        "the acceleration of x alone"
    );
    assert_eq!(
        broken(&motion, &moves, &axes(v, a, [82.0, 75.0, 1.0])),
        ["axis jerk"],
        "the jerk of y alone"
    );
}

#[test]
fn channels_that_are_beyond_a_limit_are_told_with_place_and_time() {
    let (mut motion, moves) = circle();
    motion.jerk[100] = 90.0;
    motion.jerk[101] = 95.0;
    let expected = Peak { value: 95.0, limit: 82.0, time: motion.time[101] };
    assert_eq!(motion.violations(&moves, &loose()).jerk, expected, "the peak, and when it is");
    motion.jerk[100] = f64::NAN;
    assert_eq!(broken(&motion, &moves, &loose()), ["jerk"], "what is no number is broken");
    let (mut motion, moves) = circle();
    motion.tangential_acceleration[5] = 30.0;
    motion.normal_acceleration[5] = 30.0;
    assert_eq!(broken(&motion, &moves, &loose()), ["acceleration"], "of the vector");
    let (mut motion, moves) = circle();
    motion.normal_acceleration[5] = 40.0;
    // The sagitta of a chord is v² κ Ts²/8.
    let limits = Limits { chord_error: 4.9e-6, ..loose() };
    assert_eq!(broken(&motion, &moves, &limits), ["chord error"], "5e-6 mm");
}

#[test]
fn a_programmed_feed_is_a_limit_with_its_override() {
    let (mut motion, mut moves) = circle();
    moves[0].feed = Some(18.0);
    motion.velocity[7] = 20.0;
    assert_eq!(broken(&motion, &moves, &loose()), ["feed"], "faster than the feed");
    let faster = Limits { feed_override: 1.2, ..loose() };
    assert_eq!(broken(&motion, &moves, &faster), NONE, "an override allows it");
    moves[0].rapid = true;
    assert_eq!(broken(&motion, &moves, &loose()), NONE, "a rapid move has none");
}

#[test]
fn samples_beside_the_path_or_short_of_its_end_are_found() {
    let moves = [line(dvec2(0.0, 0.0), dvec2(1.0, 0.0)), line(dvec2(1.0, 0.0), dvec2(1.0, 1.0))];
    let along = |off: f64, end: f64| {
        let mut motion = motion_of(201, |time| {
            let s = time / 0.1;
            if s <= 1.0 { dvec3(s, off, 0.0) } else { dvec3(1.0, (s - 1.0).min(end), 0.0) }
        });
        motion.block[101..].fill(1);
        motion
    };
    // These have corners, so their accelerations are beyond every limit, and no matter here.
    let limits = Limits {
        velocity: 100.0,
        acceleration: 1e9,
        jerk: 1e12,
        corner_deviation: 0.05,
        chord_error: 1.0,
        ..Limits::default()
    };
    assert_eq!(broken(&along(0.049, 1.0), &moves, &limits), NONE, "within the deviation");
    assert_eq!(
        broken(&along(0.051, 1.0), &moves, &limits),
        ["deviation"],
        "a micrometre beyond the deviation"
    );
    assert_eq!(
        broken(&along(0.0, 1.0 - 1e-8), &moves, &limits),
        ["end"],
        "ten nanometres short of the end"
    );
}

#[test]
fn the_distance_from_a_steep_helix_is_taken_in_space() {
    // A quarter of a circle of 1 mm while the tool goes down by 20 mm, and samples that are moved off it
    // along the helix's binormal.
    let turn = std::f64::consts::FRAC_PI_2;
    let arc = Arc::from_center(dvec2(1.0, 0.0), dvec2(0.0, 1.0), DVec2::ZERO, false, 1e-9)
        .expect("it is one");
    let moves = [Move { heights: [20.0, 0.0], ..one_move(MoveCurve::Arc(arc), None) }];
    let (rise, count) = (-20.0 / turn, 200);
    let beside = |off: f64| {
        motion_of(count + 1, |time| {
            let angle = turn * time / (count as f64 * PERIOD);
            let (sin, cos) = angle.sin_cos();
            let binormal = dvec3(rise * sin, -rise * cos, 1.0) / rise.hypot(1.0);
            let room = (10.0 * (turn - angle) * angle).min(1.0);
            dvec3(cos, sin, 20.0 + rise * angle) + binormal * (off * room)
        })
    };
    let limits =
        Limits { velocity: 1e3, acceleration: 1e9, jerk: 1e12, chord_error: 1.0, ..loose() };
    for off in [0.049, 0.0499] {
        assert_eq!(broken(&beside(off), &moves, &limits), NONE, "{off} is within the deviation");
    }
    assert_eq!(broken(&beside(0.0503), &moves, &limits), ["deviation"], "it is beyond");
    let found = beside(0.06).violations(&moves, &limits).deviation.value;
    assert_near(found, 0.06, 1e-4, "by as much as the samples are");
}

#[test]
fn a_jump_of_coordinates_is_no_motion() {
    let moves = [line(dvec2(0.0, 0.0), dvec2(1.0, 0.0)), line(dvec2(50.0, 0.0), dvec2(51.0, 0.0))];
    let mut motion = motion_of(201, |time| {
        let s = time / 0.1;
        dvec3(if s < 1.0 { s } else { 49.0 + s }, 0.0, 0.0)
    });
    motion.block[100..].fill(1);
    let limits = Limits { acceleration: 1e4, jerk: 1e7, ..Limits::default() };
    assert_eq!(broken(&motion, &moves, &limits), NONE, "where a move begins elsewhere");
    motion.block[100..].fill(0);
    assert!(
        broken(&motion, &moves[..1], &limits).contains(&"velocity"),
        "in the middle of a move it is"
    );
}
