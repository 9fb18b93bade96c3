//! Arc and arc.

use glam::DVec2;

use super::{Crossing, END_SLACK, Intersections};
use crate::geometry::{Arc, perp};

/// Where two arcs cross.
#[must_use]
pub fn arc_arc(a: &Arc, b: &Arc) -> Intersections {
    let distance = a.center().distance(b.center());
    if distance <= END_SLACK && (a.radius() - b.radius()).abs() <= END_SLACK {
        return same_circle(a, b);
    }
    match circles(a, b) {
        None => Intersections::Points(Vec::new()),
        // Closer than the slack the two points are one: the circles touch.
        Some([first, second]) if first.distance(second) <= 2.0 * END_SLACK => {
            among(&[first.midpoint(second)], a, b)
        }
        Some(points) => among(&points, a, b),
    }
}

/// The two points, which may be one, that the full circles of two arcs share.
#[must_use]
pub fn circles(a: &Arc, b: &Arc) -> Option<[DVec2; 2]> {
    let between = b.center() - a.center();
    let distance = between.length();
    let (ra, rb) = (a.radius(), b.radius());
    if distance > ra + rb + END_SLACK || distance < (ra - rb).abs() - END_SLACK || distance == 0.0 {
        return None;
    }
    let along = between / distance;
    // Distance of the radical line from a's centre (law of cosines, as a product of sums).
    let foot = 0.5 * (distance + (ra - rb) * (ra + rb) / distance);
    let half_chord = ((ra - foot) * (ra + foot)).max(0.0).sqrt();
    let middle = a.center() + along * foot;
    let offset = perp(along) * half_chord;
    Some([middle - offset, middle + offset])
}

/// The crossings among points of both circles.
fn among(points: &[DVec2], a: &Arc, b: &Arc) -> Intersections {
    let mut crossings = Vec::new();
    for &point in points {
        let t = a.parameter_within(point, END_SLACK);
        let u = b.parameter_within(point, END_SLACK);
        if let (Some(t), Some(u)) = (t, u) {
            crossings.push(Crossing { point, t, u });
        }
    }
    Intersections::sorted(crossings)
}

/// Two arcs of one circle share nothing, their ends, or a stretch.
fn same_circle(a: &Arc, b: &Arc) -> Intersections {
    // They share a stretch exactly where the middle of one, or some end, lies inside the other.
    let inside = |arc: &Arc, point| {
        let t = arc.parameter(point);
        let slack = END_SLACK / arc.length();
        t > slack && t < 1.0 - slack
    };
    let shares = [b.start(), b.point(0.5), b.end()].into_iter().any(|p| inside(a, p))
        || [a.start(), a.point(0.5), a.end()].into_iter().any(|p| inside(b, p));
    if shares {
        return Intersections::Coincident;
    }
    among(&[b.start(), b.end()], a, b)
}
