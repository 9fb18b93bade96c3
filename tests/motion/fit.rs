//! Fitting: tolerance by brute force, continuity by finite differences, speed by the caps alone.

use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_2, TAU};

use g41::motion::{Fitted, Fitter, Frame, Piece};
use glam::{DVec3, dvec3};

use crate::common::random::Random;

/// The corner deviation of the limits that figures are told for [mm].
const TOLERANCE: f64 = 0.05;

/// Places of a piece that are looked at.
const PLACES: usize = 24;

fn fit(points: &[DVec3], tolerance: f64) -> Vec<Fitted> {
    let mut fitted = Vec::new();
    let mut fitter = Fitter::new(points[0], tolerance);
    for (i, point) in points.iter().enumerate().skip(1) {
        fitter.line(*point, u32::try_from(i - 1).expect("few"), 100.0, &mut fitted);
    }
    fitter.finish(&mut fitted);
    fitted
}

/// The largest distance of points from a polygon, looked for among the legs near them.
fn farthest(points: &[DVec3], polygon: &[DVec3]) -> f64 {
    const CELL: f64 = 0.5;
    #[expect(clippy::cast_possible_truncation, reason = "casts saturate")]
    let key = |p: DVec3| (p / CELL).floor().to_array().map(|x| x as i32);
    let mut cells: HashMap<[i32; 3], Vec<usize>> = HashMap::new();
    for (i, leg) in polygon.windows(2).enumerate() {
        let parts = (leg[0].distance(leg[1]) / (0.2 * CELL)).ceil().max(1.0);
        let mut at = 0.0;
        while at <= parts {
            let cell = cells.entry(key(leg[0].lerp(leg[1], at / parts))).or_default();
            if cell.last() != Some(&i) {
                cell.push(i);
            }
            at += 1.0;
        }
    }
    let mut most = 0.0_f64;
    for point in points {
        let [x, y, z] = key(*point);
        let mut least = f64::INFINITY;
        for i in 0..27 {
            let near = [x + i % 3 - 1, y + i / 3 % 3 - 1, z + i / 9 - 1];
            for leg in cells.get(&near).into_iter().flatten() {
                let (from, to) = (polygon[*leg], polygon[*leg + 1]);
                let along = to - from;
                let t = (*point - from).dot(along) / along.length_squared().max(1e-300);
                least = least.min((from + along * t.clamp(0.0, 1.0)).distance(*point));
            }
        }
        most = most.max(least);
    }
    most
}

/// What a fitted path is like.
#[derive(Debug)]
struct Found {
    /// Arc length, curvature and what limits the speed by jerk, along the path.
    course: Vec<[f64; 3]>,
    corners: usize,
    splines: usize,
    /// Largest curvature [1/mm], and largest `√(κ⁴ + κ'²)` [1/mm²].
    curvature: f64,
    sharpness: f64,
}

/// Examines a fitted path: its distance from the given points, its ends, joints and derivatives.
fn examine(points: &[DVec3], tolerance: f64, name: &str) -> Found {
    let fitted = fit(points, tolerance);
    let mut found =
        Found { course: Vec::new(), corners: 0, splines: 0, curvature: 0.0, sharpness: 0.0 };
    let mut path = Vec::new();
    let mut last: Option<Frame> = None;
    let (mut s, mut block) = (0.0, 0);
    for one in &fitted {
        let length = one.piece.length();
        assert!(length > 0.0 && one.off <= tolerance, "{name}: {one:?}");
        let start = one.piece.frame(0.0);
        if let Some(end) = last {
            let gap = end.point.distance(start.point);
            assert!(gap < 1e-9, "{name}: a gap of {gap:e} at {s}");
            if one.smooth {
                let size = 1.0 + end.curvature.length();
                let turn = end.tangent.distance(start.tangent);
                let step = end.curvature.distance(start.curvature) / size;
                let change = end.sharpness.distance(start.sharpness) / (size * size);
                assert!(turn < 1e-9, "{name}: turns by {turn:e} at {s}");
                assert!(step < 1e-8, "{name}: curvature steps by {step:e} at {s}");
                assert!(change < 1e-6, "{name}: sharpness steps by {change:e} at {s}");
            } else {
                found.corners += 1;
            }
        }
        found.splines += usize::from(!matches!(one.piece, Piece::Straight(_)));
        for i in 0..PLACES {
            let at = length * i as f64 / PLACES as f64;
            let frame = one.piece.frame(at);
            path.push(frame.point);
            let [bend, change] = [frame.curvature.length(), frame.sharpness.length()];
            found.course.push([s + at, bend, change]);
            found.curvature = found.curvature.max(bend);
            found.sharpness = found.sharpness.max(change);
        }
        let mut before = 0.0;
        for (end, number) in &one.blocks {
            assert!(*end >= before && *end <= length + 1e-9, "{name}: block ends {:?}", one.blocks);
            assert!(*number >= block, "{name}: blocks in order");
            (before, block) = (*end, *number);
        }
        last = Some(one.piece.frame(length));
        s += length;
    }
    let end = last.expect("there are pieces").point;
    path.push(end);
    found.course.push([s, 0.0, 0.0]);
    let given = points[points.len() - 1];
    assert!(end.distance(given) < 1e-9, "{name}: ends at {end}, not at {given}");
    assert!(path[0].distance(points[0]) < 1e-9, "{name}: starts at {}", path[0]);
    assert_eq!(block as usize, points.len() - 2, "{name}: the last block");
    let off = farthest(&path, points).max(farthest(points, &path));
    assert!(off <= tolerance, "{name}: {off} from the points");
    found
}

/// The time along the path without limits of the tangential jerk: speed below the caps of curvature
/// and its derivative, and the tangential acceleration what the normal one leaves.
fn least_time(course: &[[f64; 3]]) -> f64 {
    let (velocity, acceleration, jerk) = (200.0_f64, 2000.0_f64, 5e4_f64);
    let mut speeds = Vec::new();
    for [_, bend, change] in course {
        let caps = (acceleration / bend).sqrt().min((jerk / change).cbrt());
        speeds.push(velocity.min(caps));
    }
    let last = speeds.len() - 1;
    (speeds[0], speeds[last]) = (1e-3, 1e-3);
    let reach = |from: f64, bend: f64, length: f64| {
        let across = from * from * bend;
        let along = (acceleration * acceleration - across * across).max(0.0).sqrt();
        (from * from + 2.0 * along * length).sqrt()
    };
    for i in 1..=last {
        let length = course[i][0] - course[i - 1][0];
        speeds[i] = speeds[i].min(reach(speeds[i - 1], course[i][1], length));
    }
    for i in (0..last).rev() {
        let length = course[i + 1][0] - course[i][0];
        speeds[i] = speeds[i].min(reach(speeds[i + 1], course[i][1], length));
    }
    let mut time = 0.0;
    for i in 1..=last {
        time += 2.0 * (course[i][0] - course[i - 1][0]) / (speeds[i] + speeds[i - 1]);
    }
    time
}

/// Radius 5 to 50 mm in 12 turns: the angle, given how far along 2069.8 mm it is.
fn spiral_angle(s: f64) -> f64 {
    let growth = 45.0 / (12.0 * TAU);
    let length = |angle: f64| {
        let r = 5.0 / growth + angle;
        let root = |x: f64| 0.5 * growth * (x * (1.0 + x * x).sqrt() + x.asinh());
        root(r) - root(5.0 / growth)
    };
    let whole = length(12.0 * TAU);
    let mut angle = 12.0 * TAU * s.sqrt();
    for _ in 0..30 {
        let r = 5.0 / growth + angle;
        angle -= (length(angle) - s * whole) / (growth * (1.0 + r * r).sqrt());
    }
    angle
}

fn spiral(count: usize) -> Vec<DVec3> {
    let mut points = Vec::new();
    for i in 0..count {
        let angle = spiral_angle(i as f64 / (count - 1) as f64);
        let r = 5.0 + angle * 45.0 / (12.0 * TAU);
        points.push(dvec3(r * angle.cos(), r * angle.sin(), 0.0));
    }
    points
}

fn rounded(points: &[DVec3]) -> Vec<DVec3> {
    points.iter().map(|p| (p * 1000.0).round() / 1000.0).collect()
}

fn circle(radius: f64, count: u32, noise: f64) -> Vec<DVec3> {
    let mut random = Random::new(3);
    let mut points = Vec::new();
    for i in 0..=count {
        let angle = TAU * f64::from(i) / f64::from(count);
        let r = radius + random.within(-noise, noise);
        points.push(dvec3(r * angle.cos(), r * angle.sin(), 0.0));
    }
    points
}

/// Arcs that touch each other, lines between some and corners now and then, as 0.01 mm chords.
fn lettering(count: usize) -> Vec<DVec3> {
    let mut random = Random::new(9);
    let (mut at, mut angle) = (DVec3::ZERO, 0.0_f64);
    let mut points = vec![at];
    for _ in 0..count {
        let (radius, sweep) = (random.within(0.4, 4.4), random.within(-2.5, 2.5));
        let parts = (sweep.abs() / (2.0 * (1.0 - 0.01 / radius).acos())).ceil().max(1.0);
        let left = |angle: f64| dvec3(-angle.sin(), angle.cos(), 0.0) * (radius * sweep.signum());
        let center = at + left(angle);
        let mut i = 1.0;
        while i <= parts {
            points.push(center - left(angle + sweep * i / parts));
            i += 1.0;
        }
        angle += sweep;
        at = center - left(angle);
        if random.index(3) == 0 {
            at += dvec3(angle.cos(), angle.sin(), 0.0) * random.within(0.1, 5.0);
            points.push(at);
        }
        if random.index(6) == 0 {
            angle += random.within(-1.5, 1.5);
        }
    }
    rounded(&points)
}

#[test]
fn the_finer_a_spiral_is_the_time_stays_the_same() {
    let mut course = Vec::new();
    let mut arc = 0.0;
    let growth = 45.0 / (12.0 * TAU);
    for i in 0..=40_000 {
        let angle = 12.0 * TAU * f64::from(i) / 40_000.0;
        let r = 5.0 + growth * angle;
        let square = r * r + growth * growth;
        let bend = (r * r + 2.0 * growth * growth) / square.powf(1.5);
        // To first order in the growth per radius.
        course.push([arc, bend, bend.powi(2).hypot(growth / r.powi(3))]);
        arc += square.sqrt() * 12.0 * TAU / 40_000.0;
    }
    let truth = least_time(&course);
    for (count, most) in [(1001, 1.03), (5001, 1.02), (10_001, 1.02), (50_001, 1.02)] {
        let found = examine(&spiral(count), TOLERANCE, &format!("spiral {count}"));
        let time = least_time(&found.course);
        assert!((time / truth - 1.0).abs() < most - 1.0, "{count}: {time} instead of {truth}");
        assert_eq!(found.corners, 0, "{count}: it has no corners");
        let rough = examine(&rounded(&spiral(count)), TOLERANCE, "in whole micrometres");
        let time = least_time(&rough.course);
        assert!((time / truth - 1.0).abs() < most - 1.0, "{count} rounded: {time} not {truth}");
    }
}

#[test]
fn noise_within_the_tolerance_is_not_followed() {
    for (noise, most) in [(0.0, 1.2), (0.002, 1.3), (0.01, 1.6)] {
        let found = examine(&circle(20.0, 20_000, noise), TOLERANCE, "circle");
        assert!(found.curvature < most / 20.0, "{noise}: curvature {}", found.curvature);
        assert!(found.splines < 120, "{noise}: {} splines", found.splines);
    }
}

#[test]
fn all_kinds_of_paths_are_kept_to() {
    let mut random = Random::new(41);
    let helix = |i: u32| {
        let a = f64::from(i) * 0.003;
        dvec3(15.0 * a.cos(), 15.0 * a.sin(), 0.5 * a)
    };
    let helix: Vec<DVec3> = (0..20_000).map(helix).collect();
    let found = examine(&helix, TOLERANCE, "helix");
    let truth = 15.0 / (15.0 * 15.0 + 0.25);
    assert!(found.corners == 0 && found.curvature < 1.2 * truth, "helix: {}", found.curvature);

    let found = examine(&lettering(150), TOLERANCE, "lettering");
    assert!(least_time(&found.course) < 12.0, "lettering: {}", least_time(&found.course));

    let mut raster = Vec::new();
    for row in 0..20 {
        for i in 0..=250 {
            let x = 0.2 * f64::from(if row % 2 == 0 { i } else { 250 - i });
            let y = 0.3 * f64::from(row);
            raster.push(dvec3(x, y, 2.0 * (0.3 * x).sin() + (0.2 * y).cos()));
        }
    }
    examine(&rounded(&raster), TOLERANCE, "raster");

    let tiny: Vec<DVec3> = (0..=100_000)
        .map(|i| 10.0 * dvec3((1e-7 * f64::from(i)).cos(), (1e-7 * f64::from(i)).sin(), 0.0))
        .collect();
    assert!(examine(&tiny, TOLERANCE, "1 nm apart").curvature < 0.15, "1 nm apart");

    for (size, name) in [(50.0, "random"), (0.2, "random, small")] {
        let mut place = || random.within(0.0, size);
        let points: Vec<DVec3> = (0..500).map(|_| dvec3(place(), place(), place())).collect();
        examine(&points, TOLERANCE, name);
        examine(&points, 0.002, name);
    }
    let mut at = DVec3::ZERO;
    let mut walk = vec![at];
    for _ in 0..1200 {
        let mut step = || random.within(-0.05, 0.05);
        at += dvec3(step(), step(), step());
        walk.push(at);
    }
    examine(&walk, TOLERANCE, "walk");
    examine(&circle(20.0, 5000, 0.06), TOLERANCE, "more noise than the tolerance");
}

#[test]
fn lines_and_their_corners_stay() {
    let corners = [[0.0, 0.0], [50.0, 0.0], [50.0, 50.0], [0.0, 50.0], [0.0, 0.0], [25.0, 0.0]];
    let square: Vec<DVec3> = corners.iter().map(|[x, y]| dvec3(*x, *y, 0.0)).collect();
    let fitted = fit(&square, TOLERANCE);
    assert_eq!(fitted.len(), 5, "{fitted:?}");
    for (i, one) in fitted.iter().enumerate() {
        assert!(!one.smooth && one.off == 0.0 && one.blocks.len() == 1, "{one:?}");
        assert_eq!(one.piece.frame(0.0).point, square[i], "as given");
    }
    // The same in steps of 0.01 mm: a line is a line however it is given.
    let mut fine = vec![DVec3::ZERO];
    for pair in square.windows(2) {
        let count = (pair[0].distance(pair[1]) * 100.0).round();
        let mut i = 1.0;
        while i <= count {
            fine.push(pair[0].lerp(pair[1], i / count));
            i += 1.0;
        }
    }
    let found = examine(&fine, TOLERANCE, "fine square");
    assert_eq!((found.corners, found.splines), (4, 0), "the four corners of the fine square");
}

#[test]
fn a_line_runs_into_an_arc_as_gently_as_the_tolerance_allows() {
    let mut points = vec![dvec3(-30.0, -10.0, 0.0)];
    for i in 0..=1000 {
        let angle = f64::from(i) * 0.0015 - FRAC_PI_2;
        points.push(dvec3(10.0 * angle.cos(), 10.0 * angle.sin(), 0.0));
    }
    let found = examine(&points, TOLERANCE, "line and arc");
    assert_eq!(found.corners, 0, "they touch");
    assert!(found.curvature < 1.15 * 0.1, "curvature {}", found.curvature);
    // A step of curvature rounded over a length a strays by 0.1 a²/24 at least, so that its
    // derivative is at least 0.1/a; two sides of the tolerance allow twice of it.
    let least = 0.1 / (24.0 * 2.0 * TOLERANCE / 0.1_f64).sqrt();
    assert!(found.sharpness < 2.0 * least, "sharpness {} against {least}", found.sharpness);
}

#[test]
fn derivatives_are_those_of_the_sampled_path() {
    for one in fit(&lettering(20), TOLERANCE) {
        let (length, h) = (one.piece.length(), 1e-5);
        for i in 1..5 {
            let s = length * f64::from(i) / 5.0;
            let [before, at, after] = [s - h, s, s + h].map(|s| one.piece.frame(s));
            let tangent = (after.point - before.point) / (2.0 * h);
            let bend = (after.tangent - before.tangent) / (2.0 * h);
            let change = (after.curvature - before.curvature) / (2.0 * h);
            let size = 1.0 + at.curvature.length();
            assert!(tangent.distance(at.tangent) < 1e-6, "tangent {tangent} {at:?}");
            assert!(bend.distance(at.curvature) < 1e-5 * size * size, "curvature {bend} {at:?}");
            let wanted = 1e-3 * size.powi(3);
            assert!(change.distance(at.sharpness) < wanted, "sharpness {change} {at:?}");
        }
    }
}

#[test]
fn each_place_names_the_block_that_it_is_nearest_to() {
    let points = spiral(10_001);
    for one in fit(&points, TOLERANCE) {
        for (end, block) in &one.blocks {
            let place = one.piece.frame(*end).point;
            let corner = points[*block as usize + 1];
            let within = end + 1e-9 < one.piece.length();
            let off = place.distance(corner);
            assert!(!within || off < 2.0 * TOLERANCE, "block {block} ends {off} away");
        }
    }
}

#[test]
fn feeds_are_kept_where_they_are_programmed() {
    let points = circle(20.0, 4000, 0.0);
    let mut fitted = Vec::new();
    let mut fitter = Fitter::new(points[0], TOLERANCE);
    for (i, point) in points.iter().enumerate().skip(1) {
        let feed = if i <= 2000 { 50.0 } else { 20.0 };
        fitter.line(*point, u32::try_from(i).expect("few"), feed, &mut fitted);
    }
    fitter.finish(&mut fitted);
    let mut slow = 0.0;
    for one in &fitted {
        let slowest = one.blocks.iter().any(|(_, block)| *block > 2000);
        assert_eq!(one.feed, if slowest { 20.0 } else { 50.0 }, "{one:?}");
        slow += if slowest { one.piece.length() } else { 0.0 };
    }
    assert!((62.8..68.0).contains(&slow), "half of the circle is slow: {slow}");
}

#[test]
fn what_is_known_is_handed_out() {
    // Blocks that wait while the path goes on: a window, however long the path is.
    let mut most = [0; 2];
    for (case, points) in [spiral(20_001), spiral(80_001)].iter().enumerate() {
        let mut fitted = Vec::new();
        let mut fitter = Fitter::new(points[0], TOLERANCE);
        let mut done = 0;
        for (i, point) in points.iter().enumerate().skip(1) {
            fitter.line(*point, u32::try_from(i).expect("few"), 100.0, &mut fitted);
            for one in fitted.drain(..) {
                done = one.blocks.last().map_or(done, |(_, block)| *block as usize);
            }
            most[case] = most[case].max(i - done);
        }
    }
    // A fixed length of path, as the noise-free spiral is thinned to the same polygon.
    assert!(most[0] < 6000 && most[1] < 5 * most[0], "{most:?} blocks wait");
}
