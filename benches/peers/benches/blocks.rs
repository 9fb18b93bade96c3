//! How many blocks a spline becomes, beside a plain bisection into biarcs and kurbo's flattening.
//!
//! Every figure is of the same cubics at the same tolerance. g41's are the blocks of the written
//! program, rounded to 0.1 µm as grbl reads them and still within the tolerance; the others' are
//! those of the curve alone, unrounded.

use g41::contour::{Move, MoveCurve, Plane, Role, ToolPath};
use g41::diagnostic::Origin;
use g41::geometry::{Cubic, Parameter, Spline, SplineEnds};
use g41::program::{EmitOptions, emit};
use glam::DVec2;
use kurbo::{BezPath, PathEl, Point};
use peers::curves::{spiral, wave};

fn main() {
    println!("| curve | spans | tolerance | g41 | biarcs by bisection | lines by kurbo |");
    println!("| --- | --- | --- | --- | --- | --- |");
    for (name, cubics) in curves() {
        for tolerance in [0.01, 0.001] {
            let (ours, biarcs, lines) = (
                written(&cubics, tolerance),
                bisected(&cubics, tolerance),
                flattened(&cubics, tolerance),
            );
            println!("| {name} | {} | {tolerance} | {ours} | {biarcs} | {lines} |", cubics.len());
            assert!(ours < biarcs && ours < lines, "{name} at {tolerance}: more than a peer");
        }
    }
}

fn curves() -> Vec<(&'static str, Vec<Cubic>)> {
    let through = |points: Vec<DVec2>, ends| {
        let spline = Spline::through(points, ends, Parameter::Chord).expect("it is a spline");
        spline.pieces().to_vec()
    };
    let turn = |i: i32, n: i32| std::f64::consts::TAU * f64::from(i) / f64::from(n);
    let ellipse = (0..=24).map(|i| {
        let angle = turn(i % 24, 24);
        DVec2::new(50.0 * angle.cos(), 30.0 * angle.sin())
    });
    // A cam with a fast rise: 20 mm of base circle, 12 mm of lift.
    let cam = (0..=36).map(|i| {
        let angle = turn(i % 36, 36);
        DVec2::from_angle(angle) * (26.0 + 6.0 * (angle.sin() * 1.5).tanh())
    });
    let letter = [[0, 0], [6, 24], [20, 30], [34, 22], [30, 12], [16, 10], [10, 2], [22, -6]];
    let letter = letter.map(|[x, y]: [i32; 2]| DVec2::new(f64::from(x), f64::from(y)));
    vec![
        ("wave, 1,000 type points", wave(1000).spline().pieces().to_vec()),
        ("spiral, 1,000", spiral(1000).spline().pieces().to_vec()),
        ("ellipse 50 × 30, 24", through(ellipse.collect(), SplineEnds::Periodic)),
        ("cam, 36", through(cam.collect(), SplineEnds::Periodic)),
        ("letter, 8", through(letter.to_vec(), SplineEnds::NATURAL)),
    ]
}

/// Blocks of the program that g41 writes, apart from its head and the way to the start.
fn written(cubics: &[Cubic], tolerance: f64) -> usize {
    let moves = cubics.iter().map(|cubic| Move {
        curve: MoveCurve::Cubic(*cubic),
        role: Role::Segment,
        rapid: false,
        feed: Some(10.0),
        plane: Plane::Xy,
        heights: [0.0; 2],
        origin: Origin::Segment(0),
    });
    let path = ToolPath { moves: moves.collect(), ..ToolPath::default() };
    let text = emit(&path, &EmitOptions { tolerance, ..EmitOptions::default() }).text;
    let is_cut = |line: &&str| !line.starts_with("G21") && !line.starts_with("G0");
    text.lines().filter(is_cut).count()
}

fn flattened(cubics: &[Cubic], tolerance: f64) -> usize {
    let point = |p: DVec2| Point::new(p.x, p.y);
    let mut path = BezPath::new();
    path.move_to(point(cubics[0].points[0]));
    for cubic in cubics {
        let [_, first, second, end] = cubic.points.map(point);
        path.curve_to(first, second, end);
    }
    let mut lines = 0;
    kurbo::flatten(path, tolerance, |piece| {
        lines += usize::from(matches!(piece, PathEl::LineTo(_)))
    });
    lines
}

/// Two arcs with the tangents of the ends where they follow a stretch of the chain, counted in
/// cubics, else those of its halves.
fn bisected(cubics: &[Cubic], tolerance: f64) -> usize {
    halves(cubics, [0.0, cubics.len() as f64], tolerance)
}

fn halves(cubics: &[Cubic], [from, to]: [f64; 2], tolerance: f64) -> usize {
    if to - from < 1e-6 || biarc_error(cubics, [from, to]) <= tolerance {
        return 2;
    }
    let middle = 0.5 * (from + to);
    halves(cubics, [from, middle], tolerance) + halves(cubics, [middle, to], tolerance)
}

/// Largest distance of 64 points a cubic from the biarc with the ends and tangents of a stretch,
/// whose control legs are equally long.
fn biarc_error(cubics: &[Cubic], [from, to]: [f64; 2]) -> f64 {
    let locate = |at: f64| {
        let index = (at.floor() as usize).min(cubics.len() - 1);
        (&cubics[index], at - index as f64)
    };
    let frame = |at: f64| {
        let (cubic, t) = locate(at);
        (cubic.point(t), cubic.tangent(t))
    };
    let ((start, t0), (end, t1)) = (frame(from), frame(to));
    let (a, way) = (2.0 * (1.0 - t0.dot(t1)), end - start);
    let (b, square) = (way.dot(t0 + t1), way.length_squared());
    let leg =
        if a.abs() < 1e-12 { square / (2.0 * b) } else { ((b * b + a * square).sqrt() - b) / a };
    let joint = (start + t0 * leg).midpoint(end - t1 * leg);
    let circles = [circle(start, t0, joint), circle(end, -t1, joint)];
    let steps = 64 * (to - from).ceil() as usize;
    let mut worst: f64 = 0.0;
    for i in 0..=steps {
        let (cubic, t) = locate(from + (to - from) * i as f64 / steps as f64);
        let point = cubic.point(t);
        let off = circles.iter().map(|off| off(point)).fold(f64::INFINITY, f64::min);
        worst = if off.is_nan() { f64::INFINITY } else { worst.max(off) };
    }
    worst
}

/// The distance from the circle through two points with a tangent at the first.
fn circle(from: DVec2, tangent: DVec2, to: DVec2) -> impl Fn(DVec2) -> f64 {
    let (chord, normal) = (to - from, tangent.perp());
    let bend = 2.0 * chord.dot(normal) / chord.length_squared();
    move |point| {
        if bend.abs() < 1e-12 {
            (point - from).dot(normal).abs()
        } else {
            (point.distance(from + normal / bend) - 1.0 / bend.abs()).abs()
        }
    }
}
