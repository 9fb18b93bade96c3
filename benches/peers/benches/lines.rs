//! Times along single lines, from rest to rest, beside Ruckig's, which are the shortest where jerk may
//! step; and what planning one costs. `cargo bench --package peers --bench lines`.
//!
//! On these lines the limits of one axis are the narrowest of velocity, acceleration and jerk alike: where
//! they are those of different axes, Ruckig leaves the line.

use std::hint::black_box;
use std::time::Instant;

use g41::contour::{Move, MoveCurve, Plane, Role};
use g41::diagnostic::Origin;
use g41::geometry::Line;
use g41::motion::{AxisLimits, Limits, Planner, plan};
use glam::{DVec3, dvec3};
use rsruckig::prelude::*;

/// Rounds of what is timed.
const ROUNDS: u32 = 20_000;

fn main() {
    // What the vector may do is out of the way: Ruckig has limits of axes alone.
    let axes = AxisLimits { velocity: [200.0; 3], acceleration: [2000.0; 3], jerk: [5.0e4; 3] };
    let uneven = AxisLimits {
        velocity: [200.0, 150.0, 60.0],
        acceleration: [2000.0, 1500.0, 500.0],
        jerk: [5.0e4, 4.0e4, 1.0e4],
    };
    println!(
        "| way in mm | Ruckig, s | jerk steps, s | jerk changes in 5 ms, s | Ruckig, µs | ours, µs |"
    );
    println!("| --- | --- | --- | --- | --- | --- |");
    for (way, axes) in [
        (dvec3(0.001, 0.0, 0.0), axes),
        (dvec3(1.0, 0.0, 0.0), axes),
        (dvec3(20.0, 0.0, 0.0), axes),
        (dvec3(100.0, 0.0, 0.0), axes),
        (dvec3(30.0, 20.0, 5.0), axes),
        (dvec3(30.0, 20.0, 5.0), uneven),
        (dvec3(-30.0, 20.0, -4.0), uneven),
        (dvec3(0.5, -0.4, 0.3), uneven),
    ] {
        row(way, axes);
    }
}

fn row(way: DVec3, axes: AxisLimits) {
    let limits = Limits {
        velocity: 1.0e4,
        acceleration: 1.0e6,
        jerk: 1.0e8,
        axes: Some(axes),
        snap: Some(1.0e7),
        ..Limits::default()
    };
    let moves = [line(way)];
    let ours = plan(&moves, &limits).map_or(f64::NAN, |motion| motion.duration);
    let stepping = Limits { snap: Some(1.0e15), ..limits };
    let free = plan(&moves, &stepping).map_or(f64::NAN, |motion| motion.duration);

    let mut ruckig = Ruckig::<3, ThrowErrorHandler>::new(None, 0.001);
    let mut input = InputParameter::new(None);
    // Along a line: all axes follow the same profile.
    input.synchronization = Synchronization::Phase;
    input.target_position = daov_stack![way.x, way.y, way.z];
    let [v, a, j] = [axes.velocity, axes.acceleration, axes.jerk];
    input.max_velocity = daov_stack![v[0], v[1], v[2]];
    input.max_acceleration = daov_stack![a[0], a[1], a[2]];
    input.max_jerk = daov_stack![j[0], j[1], j[2]];
    let mut trajectory = Trajectory::new(None);
    let its = time(|| {
        let _ = black_box(ruckig.calculate(black_box(&input), &mut trajectory));
    });
    let shortest = trajectory.get_duration();
    // Few samples: a period of as long as it takes. Neither limit of a period matters on a line.
    let sparse = Limits { period: 1.0, ..limits };
    let each = time(|| {
        let mut motion = g41::motion::Motion::default();
        if let Ok(mut planner) = Planner::new(black_box(&sparse)) {
            planner.push(&moves[0], &mut motion);
            planner.finish(&mut motion);
        }
        black_box(motion.duration);
    });
    println!("| {way} | {shortest:.6} | {free:.6} | {ours:.6} | {its:.2} | {each:.2} |");
}

/// Microseconds a round takes.
fn time(mut round: impl FnMut()) -> f64 {
    let begun = Instant::now();
    for _ in 0..ROUNDS {
        round();
    }
    begun.elapsed().as_secs_f64() * 1.0e6 / f64::from(ROUNDS)
}

fn line(way: DVec3) -> Move {
    let curve = Line::new(DVec3::ZERO.truncate(), way.truncate());
    Move {
        curve: curve.map_or(MoveCurve::Vertical(DVec3::ZERO.truncate()), MoveCurve::Line),
        role: Role::Free,
        rapid: false,
        feed: None,
        plane: Plane::Xy,
        heights: [0.0, way.z],
        origin: Origin::Segment(0),
    }
}
