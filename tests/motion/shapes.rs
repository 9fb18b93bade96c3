//! The shapes that motion is measured on.
//!
//! `data/random-200-2d.csv` and `data/random-200-3d.csv` are seeded random polylines of 200 segments
//! of a few millimetres, whose cycle times other planners were measured on.

use std::f64::consts::{FRAC_PI_2, TAU};

use g41::compensation::Options;
use g41::contour::{Move, MoveCurve, Plane, Role};
use g41::diagnostic::Origin;
use g41::geometry::Line;
use g41::program::{Dialect, Program, Rules, interpret};
use g41::simulation::{Tools, compensate_program};
use glam::{DVec2, DVec3};

/// A move without a feed along a curve at height 0.
pub(crate) fn along(curve: MoveCurve) -> Move {
    Move {
        curve,
        role: Role::Free,
        rapid: false,
        feed: None,
        plane: Plane::Xy,
        heights: [0.0; 2],
        origin: Origin::Segment(0),
    }
}

/// Straight moves from point to point [mm].
pub(crate) fn polyline(points: &[DVec3]) -> Vec<Move> {
    let mut moves = Vec::new();
    for pair in points.windows(2) {
        let (from, to) = (pair[0].truncate(), pair[1].truncate());
        let curve = Line::new(from, to).map_or(MoveCurve::Vertical(from), MoveCurve::Line);
        moves.push(Move { heights: [pair[0].z, pair[1].z], ..along(curve) });
    }
    moves
}

fn flat(points: &[DVec2]) -> Vec<Move> {
    polyline(&points.iter().map(|point| point.extend(0.0)).collect::<Vec<_>>())
}

/// A square of 50 mm, and half a side on.
pub(crate) fn square() -> Vec<Move> {
    let points = [[0.0, 0.0], [50.0, 0.0], [50.0, 50.0], [0.0, 50.0], [0.0, 0.0], [25.0, 0.0]];
    flat(&points.map(DVec2::from_array))
}

/// Five points on a radius of 40 mm, every second one joined, from the top on.
pub(crate) fn star() -> Vec<Move> {
    let point = |k: i32| 40.0 * DVec2::from_angle(FRAC_PI_2 + f64::from(2 * k) * TAU / 5.0);
    flat(&(0..6).map(point).collect::<Vec<_>>())
}

pub(crate) fn random_2d() -> Vec<Move> {
    table(include_str!("data/random-200-2d.csv"))
}

pub(crate) fn random_3d() -> Vec<Move> {
    table(include_str!("data/random-200-3d.csv"))
}

fn table(text: &str) -> Vec<Move> {
    let mut points = Vec::new();
    for line in text.lines().filter(|line| !line.is_empty()) {
        let row: Vec<f64> =
            line.split(',').map(|number| number.parse().expect("a number")).collect();
        points.push(DVec3::new(row[0], row[1], row.get(2).copied().unwrap_or(0.0)));
    }
    polyline(&points)
}

/// A spiral of 12 turns from a radius of 5 mm to one of 50 mm, with points at equal arc lengths.
pub(crate) fn spiral(count: usize) -> Vec<Move> {
    let growth = 45.0 / (12.0 * TAU);
    let at = |angle: f64| (5.0 + growth * angle) * DVec2::from_angle(angle);
    let fine = 400_000;
    let angle = |step: usize| 12.0 * TAU * step as f64 / fine as f64;
    let mut lengths = vec![0.0];
    for step in 1..=fine {
        lengths.push(lengths[step - 1] + at(angle(step - 1)).distance(at(angle(step))));
    }
    let mut points = Vec::new();
    let mut step = 0;
    for index in 0..count {
        let meant = lengths[fine] * index as f64 / (count - 1) as f64;
        while step + 1 < fine && lengths[step + 1] < meant {
            step += 1;
        }
        let part = (meant - lengths[step]) / (lengths[step + 1] - lengths[step]);
        points.push(at(12.0 * TAU * (step as f64 + part) / fine as f64));
    }
    flat(&points)
}

/// The path of a tool along a program, with arcs and splines.
pub(crate) fn compensated(text: &str, radius: f64) -> Vec<Move> {
    let read = interpret(&Program::parse(text, Dialect::Auto), Rules::default());
    compensate_program(&read, &Tools::all(radius), &Options::default()).moves
}

/// Programs of the kinds that people run.
pub(crate) const PROGRAMS: [(&str, &str); 8] = [
    ("gear", include_str!("../programs/gear.ngc")),
    ("lettering", include_str!("../programs/lettering.ngc")),
    ("cam", include_str!("../programs/cam.ngc")),
    ("pocket", include_str!("../programs/pocket.ngc")),
    ("slot", include_str!("../programs/slot.ngc")),
    ("helix", include_str!("../programs/helix.ngc")),
    ("heart", include_str!("../programs/heart.ngc")),
    ("ellipse", include_str!("../programs/ellipse.ngc")),
];
