//! Cycle times beside those of other methods on the same shapes and machine: 200 mm/s, 2000 mm/s²,
//! 5e4 mm/s³, a deviation of 0.05 mm, 1 ms.
//!
//! The others were computed by a separate program: full stops with S-curves of seven segments (jerk
//! in steps); ramps of quintics with look-ahead and stops where they are faster; and the same with
//! trapezoids of acceleration whose edges are smooth. All keep the limit of jerk.

use g41::contour::{Move, MoveCurve};
use g41::geometry::{Arc, RadiusForm};
use g41::motion::{AxisLimits, CornerCurve, Limits, Mode, plan};
use glam::{DVec2, DVec3};

use crate::shapes;

fn time(moves: &[Move], limits: &Limits) -> f64 {
    plan(moves, limits).expect("limits").duration
}

#[test]
fn cycle_times_are_at_least_a_tenth_better_on_random_paths_and_no_worse_on_any() {
    // Full stops, quintics, smooth trapezoids [s], and the part of the better of the last two that
    // is asked for.
    let rows = [
        ("square", shapes::square(), [1.827_f64, 2.021, 1.932], 1.0),
        ("star", shapes::star(), [2.602, 2.822, 2.702], 1.0),
        ("random 2-D", shapes::random_2d(), [28.34, 28.62, 28.95], 0.9),
        ("random 3-D", shapes::random_3d(), [28.62, 27.40, 27.55], 0.9),
        ("spiral of 401", shapes::spiral(401), [59.62, 24.22, 24.37], 0.9),
        ("spiral of 1001", shapes::spiral(1001), [109.9, 25.80, 25.83], 0.9),
        ("spiral of 10001", shapes::spiral(10001), [510.1, 55.59, 55.59], 0.9),
    ];
    for (name, moves, [stops, quintics, trapezoids], part) in rows {
        let ours = time(&moves, &Limits::default());
        println!("{name}: {ours:.3} s; {stops}, {quintics}, {trapezoids}");
        let best = quintics.min(trapezoids);
        assert!(ours <= part * best, "{name}: {ours} s for {best} s");
        assert!(
            ours < 1.03 * stops,
            "{name}: {ours} s, with full stops and steps of jerk {stops} s"
        );
    }
}

#[test]
fn corners_between_a_rapid_move_and_a_slow_one_take_no_longer_than_stops() {
    // Drilling: down at 5 mm/s, up and on at the most that there is.
    let mut points = vec![DVec3::ZERO];
    for hole in 0..5_u32 {
        let x = 30.0 * f64::from(hole);
        points.extend([DVec3::new(x + 30.0, 0.0, 0.0), DVec3::new(x + 30.0, 0.0, -4.0)]);
        points.push(DVec3::new(x + 35.0, 0.0, -4.0));
        points.push(DVec3::new(x + 35.0, 0.0, 0.0));
    }
    let mut moves = shapes::polyline(&points);
    for (index, one) in moves.iter_mut().enumerate() {
        match index % 4 {
            1 => one.feed = Some(5.0),
            2 => one.feed = Some(20.0),
            _ => one.rapid = true,
        }
    }
    let stops = time(&moves, &Limits { exact_stop: true, ..Limits::default() });
    let mut last = stops;
    for corner_deviation in [0.01, 0.05, 0.2, 1.0] {
        let limits = Limits { corner_deviation, ..Limits::default() };
        let motion = plan(&moves, &limits).expect("limits");
        assert!(motion.violations(&moves, &limits).worst() < 1.0005, "{corner_deviation} mm");
        assert!(
            motion.duration < last + 1e-3,
            "{} s within {corner_deviation} mm, {last} s before",
            motion.duration
        );
        last = motion.duration;
    }
    assert!(last < 0.995 * stops, "{last} s, with stops {stops} s");
}

#[test]
fn a_line_takes_the_shortest_time_that_there_is() {
    // Ruckig's durations for the same limits: jerk for A/J brings the acceleration, which lasts until
    // the speed is there, or for half the way.
    let limits = Limits::default();
    let Limits { velocity, acceleration, jerk, .. } = limits;
    let rise = acceleration / jerk;
    for (length, closed) in [
        (1e-3, 4.0 * (1e-3 / (2.0 * jerk)).cbrt()),
        (1.0, 4.0 * (1.0 / (2.0 * jerk)).cbrt()),
        (20.0, 0.243_960_780_543_711),
        (100.0, 100.0 / velocity + velocity / acceleration + rise),
    ] {
        let moves = shapes::polyline(&[DVec3::ZERO, DVec3::new(0.6, 0.0, 0.8) * length]);
        let stepping = Limits { snap: Some(1e8 * jerk), ..limits };
        let found = time(&moves, &stepping);
        assert!((found / closed - 1.0).abs() < 1e-4, "{length} mm: {found} s, {closed} s");
        let bounded = time(&moves, &limits);
        let most = closed + 4.0 * jerk / limits.snap();
        assert!(bounded > closed && bounded < most, "{length} mm: {bounded} s, {closed} s");
    }
    // Each axis by its own limits: the one that needs longest, here x.
    let moves = shapes::polyline(&[DVec3::ZERO, DVec3::new(30.0, 20.0, 5.0)]);
    let axes = AxisLimits { velocity: [50.0; 3], acceleration: [400.0; 3], jerk: [8e3; 3] };
    let found = time(&moves, &Limits { axes: Some(axes), snap: Some(1e8 * jerk), ..limits });
    let closed = 30.0 / 50.0 + 50.0 / 400.0 + 400.0 / 8e3;
    assert!((found / closed - 1.0).abs() < 1e-4, "by axes: {found} s, {closed} s");
}

/// Corners that turn to and fro by an angle [rad], a length [mm] apart.
fn zigzag(count: usize, turn: f64, length: f64) -> Vec<Move> {
    let mut points = vec![DVec3::ZERO];
    for index in 0..count {
        let angle = if index % 2 == 0 { 0.0 } else { turn };
        points.push(points[index] + (DVec2::from_angle(angle) * length).extend(0.0));
    }
    shapes::polyline(&points)
}

#[test]
fn corner_after_corner_takes_the_time_of_the_third_order_optimum() {
    // Half of the way from corner to corner of the curve of degree 13, by sequential quadratic
    // programming in a separate program: turn [°], length [mm], and time [ms].
    for (degrees, half, jerk, deviation, optimum) in [
        (90.0_f64, 2.5, 5.0e4, 0.05, 75.2),
        (45.0, 2.5, 5.0e4, 0.05, 64.5),
        (90.0, 10.0, 5.0e4, 0.05, 124.5),
        (30.0, 2.5, 5.0e5, 0.02, 30.9),
    ] {
        let fast = jerk > 1.0e5;
        let mut limits = Limits {
            velocity: if fast { 500.0 } else { 200.0 },
            acceleration: if fast { 5000.0 } else { 2000.0 },
            jerk,
            corner_deviation: deviation,
            corner: CornerCurve::Ph13,
            fit: false,
            // Of third order: jerk may do nearly what it likes.
            snap: Some(jerk / 0.5e-3),
            ..Limits::default()
        };
        let half_way = |limits: &Limits| {
            let of = |count| time(&zigzag(count, degrees.to_radians(), 2.0 * half), limits);
            (of(14) - of(8)) / 12.0 * 1e3
        };
        let third = half_way(&limits);
        assert!(third < 1.05 * optimum, "{degrees}°, {half} mm: {third} ms for {optimum} ms");
        assert!(third > 0.97 * optimum, "{degrees}°, {half} mm: {third} ms are too good");
        (limits.snap, limits.corner) = (None, CornerCurve::Eased);
        let eased = half_way(&limits);
        println!(
            "{degrees}°, {half} mm: {third:.2} ms for {optimum}; eased, snap bounded {eased:.2}"
        );
        assert!(eased < 1.17 * optimum, "{degrees}°, {half} mm: eased {eased} ms");
    }
}

#[test]
fn short_arcs_are_fitted_with_the_lines_around_them() {
    // A wave in steps of 0.4 mm: lines, arcs, and both by turns.
    let at = |k: u32| {
        let x = 0.4 * f64::from(k);
        DVec2::new(x, 6.0 * (x / 6.4).sin())
    };
    let moves = |is_arc: fn(u32) -> bool| -> Vec<Move> {
        let points: Vec<DVec3> = (0..=200).map(|k| at(k).extend(0.0)).collect();
        let mut moves = shapes::polyline(&points);
        for (k, one) in (0..).zip(&mut moves) {
            let (from, to) = (one.curve.start(), one.curve.end());
            // As curved as the wave is half-way, or so little that it is a line.
            let x = 0.5 * (from.x + to.x) / 6.4;
            let bend =
                -6.0 / 6.4_f64.powi(2) * x.sin() / (1.0 + (6.0 / 6.4 * x.cos()).powi(2)).powf(1.5);
            if is_arc(k) && bend.abs() > 1e-3 {
                let radius = 1.0 / bend.abs();
                let arc = Arc::from_radius(from, to, radius, RadiusForm::Minor, bend < 0.0, 1e-9);
                one.curve = MoveCurve::Arc(arc.expect("longer than its chord"));
            }
        }
        moves
    };
    let limits = Limits::default();
    let lines = time(&moves(|_| false), &limits);
    for is_arc in [|k| k % 2 == 1, |_| true] {
        let moves = moves(is_arc);
        let motion = plan(&moves, &limits).expect("limits");
        let arcs = motion.duration;
        assert!(arcs < 1.03 * lines, "{arcs} s with arcs, {lines} s without");
        let found = motion.violations(&moves, &limits);
        assert!(found.worst() < 1.0005, "{found:?}");
    }
}

#[test]
fn the_textbook_is_slow_on_long_lines_and_breaks_the_limit_of_jerk() {
    let textbook = Limits { mode: Mode::Textbook, ..Limits::default() };
    // One quintic from midpoint to midpoint never exceeds the faster of the two.
    let square = time(&shapes::square(), &textbook);
    assert!((square / 38.1 - 1.0).abs() < 0.05, "the square took 38.1 s elsewhere: {square}");
    let star = time(&shapes::star(), &textbook);
    assert!((star / 203.3 - 1.0).abs() < 0.05, "the star took 203.3 s elsewhere: {star}");
    // At a turn of 10° the jerk is 9.4 times what ∛(Jmax/κ²) takes it for, at constant speed.
    let moves = zigzag(12, 10.0_f64.to_radians(), 5.0);
    let motion = plan(&moves, &textbook).expect("limits");
    let corner = motion.time.iter().position(|time| *time > 0.5 * motion.duration).expect("half");
    let most = motion.jerk[corner / 2..corner].iter().fold(0.0_f64, |most, jerk| most.max(*jerk));
    assert!(most > 5.0 * 5.0e4, "jerk {most}");
}
