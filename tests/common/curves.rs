//! The curves that offsets are compared on: type points about 5 mm apart.

use std::f64::consts::TAU;

use glam::DVec2;

/// A closed curve round a circle: `k = max(3, n / 20)` waves of 8 mm; the first point is repeated as
/// the last. No bend is tighter than 5 mm, all are tighter than 60 mm.
pub(crate) fn wave(n: usize) -> Vec<DVec2> {
    let (k, middle) = ((n / 20).max(3) as f64, 5.0 * n as f64 / TAU);
    let at = |i: usize| {
        let angle = TAU * i as f64 / n as f64;
        DVec2::from_angle(angle) * (middle + 8.0 * (k * angle).sin())
    };
    let mut points: Vec<DVec2> = (0..n).map(at).collect();
    points.push(points[0]);
    points
}

/// An open spiral whose turns are 40 mm apart: a tool of 25 mm does not fit between them.
pub(crate) fn spiral(n: usize) -> Vec<DVec2> {
    let growth = 40.0 / TAU;
    let mut angle = TAU;
    let mut points = Vec::with_capacity(n);
    for _ in 0..n {
        let reach = growth * angle;
        points.push(DVec2::from_angle(angle) * reach);
        angle += 5.0 / reach.hypot(growth);
    }
    points
}
