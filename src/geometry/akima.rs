//! Akima's curve through points: smooth, and so local that a point bends two spans on each side.
//!
//! H. Akima, "A new method of interpolation and smooth curve fitting based on local procedures",
//! J. ACM 17 (1970), the case of multiple-valued functions: the direction at a point follows from
//! the two legs before and the two legs behind it, and the speed on a span is the length of its leg.

use glam::DVec2;

use super::{Cubic, EndCondition, cross};

/// Akima's curve through `points` [mm], at least two, no two successive ones of which coincide.
///
/// Its ends are natural (curvature zero), tangent to a direction, or, for
/// [`EndCondition::NotAKnot`], as published: the legs go on beyond the end as those of a parabola.
#[must_use]
pub fn akima(points: &[DVec2], [start, end]: [EndCondition; 2]) -> Vec<Cubic> {
    let spans = points.len().saturating_sub(1);
    if spans == 0 {
        return Vec::new();
    }
    let leg = |i: usize| points[i + 1] - points[i];
    // The legs, and two more beyond each end: differences of a parabola's points are evenly spaced.
    let beyond = |near: DVec2, next: DVec2| [near * 3.0 - next * 2.0, near * 2.0 - next];
    let mut legs: Vec<DVec2> = Vec::with_capacity(spans + 4);
    legs.extend(beyond(leg(0), leg(1.min(spans - 1))));
    for i in 0..spans {
        legs.push(leg(i));
    }
    let [far, near] = beyond(leg(spans - 1), leg(spans.max(2) - 2));
    legs.extend([near, far]);
    let mut tangents: Vec<DVec2> = (0..=spans).map(|i| tangent(&legs[i..i + 4])).collect();
    for (at, other, span, condition) in [(0, 1, 0, start), (spans, spans - 1, spans - 1, end)] {
        let chord = leg(span);
        match condition {
            EndCondition::NotAKnot => {}
            EndCondition::Tangent(tangent) => {
                tangents[at] = tangent.normalize_or(chord.normalize());
            }
            // 2 d + d' = 3 chord makes the second derivative zero; the speed is then its own.
            EndCondition::Natural => {
                tangents[at] = (chord * 3.0 / chord.length() - tangents[other]) * 0.5;
            }
        }
    }
    let cubic = |i: usize| {
        let speed = leg(i).length();
        Cubic::hermite(points[i], tangents[i] * speed, points[i + 1], tangents[i + 1] * speed)
    };
    (0..spans).map(cubic).collect()
}

/// Unit tangent at the point between the second and the third of four legs.
fn tangent(legs: &[DVec2]) -> DVec2 {
    let (before, behind) = (cross(legs[0], legs[1]).abs(), cross(legs[2], legs[3]).abs());
    // Straight on both sides: neither leg counts more.
    let (before, behind) = if before + behind == 0.0 { (1.0, 1.0) } else { (before, behind) };
    (legs[1] * behind + legs[2] * before).normalize_or(legs[1].normalize())
}
