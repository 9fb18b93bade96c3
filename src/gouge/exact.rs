//! Distances of lines and arcs from each other, in closed form.

use glam::DVec2;

use crate::contour::MoveCurve;
use crate::geometry::{Arc, Line, cross, direction, perp};

/// The least distance of two lines or arcs [mm], and the point of the second where it is.
///
/// Where the least distance is: at an end of one of them, where they cross, or on the normal that
/// they share, which passes through the centre of an arc. A point near each of these is brought
/// onto the second curve, and from there onto the first.
pub(super) fn approach(a: &MoveCurve, b: &MoveCurve) -> (f64, DVec2) {
    let mut best = (f64::INFINITY, b.start());
    let mut consider = |raw: DVec2| {
        let at = b.nearest(raw).point;
        let distance = a.nearest(at).distance;
        if distance < best.0 {
            best = (distance, at);
        }
    };
    [a.start(), a.end(), b.start(), b.end()].into_iter().for_each(&mut consider);
    match (a, b) {
        (MoveCurve::Line(a), MoveCurve::Line(b)) => {
            let (u, v) = (a.vector(), b.vector());
            let area = cross(u, v);
            if area != 0.0 {
                consider(b.start() + v * (cross(a.start() - b.start(), u) / -area));
            }
        }
        (MoveCurve::Line(line), MoveCurve::Arc(arc))
        | (MoveCurve::Arc(arc), MoveCurve::Line(line)) => {
            line_and_circle(line, arc, &mut consider);
        }
        (MoveCurve::Arc(a), MoveCurve::Arc(b)) => circles(a, b, &mut consider),
        _ => {}
    }
    best
}

/// The foot of the centre on the line, and where the line crosses the circle.
fn line_and_circle(line: &Line, arc: &Arc, consider: &mut dyn FnMut(DVec2)) {
    let along = line.tangent();
    let foot = line.start() + along * (arc.center() - line.start()).dot(along);
    consider(foot);
    let off = foot.distance_squared(arc.center());
    let half = (arc.radius().powi(2) - off).max(0.0).sqrt();
    consider(foot + along * half);
    consider(foot - along * half);
}

/// Where the line through both centres meets the second circle, and where the circles cross.
fn circles(a: &Arc, b: &Arc, consider: &mut dyn FnMut(DVec2)) {
    let apart = a.center() - b.center();
    // About one centre they are everywhere equally far, and their ends tell it.
    let Some(along) = direction(apart) else { return };
    consider(b.center() + along * b.radius());
    consider(b.center() - along * b.radius());
    let (distance, ra, rb) = (apart.length(), a.radius(), b.radius());
    // Of the triangle of both centres and a crossing, the foot of its height.
    let x = 0.5 * (distance + (rb - ra) * (rb + ra) / distance);
    let height = (rb * rb - x * x).max(0.0).sqrt();
    consider(b.center() + along * x + perp(along) * height);
    consider(b.center() + along * x - perp(along) * height);
}
