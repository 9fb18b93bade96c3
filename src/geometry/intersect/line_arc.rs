//! Line and arc.

use glam::DVec2;

use super::{Crossing, END_SLACK, Intersections, within};
use crate::geometry::{Arc, Line, cross};

/// Where a line crosses an arc.
#[must_use]
pub fn line_arc(line: &Line, arc: &Arc) -> Intersections {
    let length = line.length();
    let mut crossings = Vec::new();
    for t in line_circle(line, arc.center(), arc.radius()) {
        let Some(t) = within(t, length) else { continue };
        let point = line.point(t);
        if let Some(u) = arc.parameter_within(point, END_SLACK) {
            crossings.push(Crossing { point, t, u });
        }
    }
    Intersections::Points(crossings)
}

/// Parameters, ascending, at which the line run on without end meets a full circle; one where it
/// touches.
#[must_use]
pub fn line_circle(line: &Line, center: DVec2, radius: f64) -> Vec<f64> {
    let length = line.length();
    let along = line.tangent();
    let foot = along.dot(center - line.start());
    let distance = cross(along, center - line.start()).abs();
    // Difference of squares as a product: it keeps its digits where the line nearly touches.
    let half_chord_squared = (radius - distance) * (radius + distance);
    if distance - radius > END_SLACK {
        return Vec::new();
    }
    if half_chord_squared <= 0.0 {
        return vec![foot / length];
    }
    let half_chord = half_chord_squared.sqrt();
    vec![(foot - half_chord) / length, (foot + half_chord) / length]
}
