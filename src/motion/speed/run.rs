//! The law of a run: a first law, made faster, and once more by its own time.

use glam::DVec3;

use super::course::Course;
use super::knots::bounds;
use super::law::{Phase, length};
use super::ramp::{Rates, cruise};
use super::reference::{reference, sampled};
use super::stage::{Stage, needed};
use super::verify::verify;
use crate::motion::{Limits, Piece};

/// What is left to rounding along a line.
const ROUNDED: f64 = 1.0 - 1.0e-6;

/// What a run that begins or ends on the move does so at, in parts of its cap.
const EVEN: f64 = 0.999;

/// The part of the limits that is taken where no law is found.
const SLOW: f64 = 0.5;

/// Distance of knots, in the time that jerk needs to reach its limit.
const RESOLUTION: f64 = 0.3;

/// Knots on a corner.
const ON_CORNER: f64 = 24.0;

/// The law of a run within the limits.
pub(in crate::motion) fn law(course: &Course, limits: &Limits) -> Vec<Phase> {
    if let Some(law) = along_line(course, limits) {
        return law;
    }
    let Some((mut law, mut factor)) = planned(course, limits, &[]) else { return Vec::new() };
    if !factor.is_finite() {
        (law, factor) = slowly(course, limits);
    }
    if factor > 1.0 {
        for phase in &mut law {
            *phase = phase.stretched(factor);
        }
    }
    law
}

/// The law of a run that goes on as a law before it, its head, did at first; nothing where none is
/// found within the limits.
pub(in crate::motion) fn law_from(
    course: &Course,
    limits: &Limits,
    head: &[Phase],
) -> Option<Vec<Phase>> {
    let (law, factor) = planned(course, limits, head)?;
    (factor <= 1.0).then_some(law)
}

/// A law, and the factor on time by which it still breaks limits.
fn planned(course: &Course, limits: &Limits, head: &[Phase]) -> Option<(Vec<Phase>, f64)> {
    let bounds = bounds(limits);
    let step = (RESOLUTION * limits.jerk / limits.snap()).max(0.5 * limits.period);
    let before = length(head);
    let (at, span) = reference(course, limits, 2.0 * step, head)?;
    let borders = (0..at.len() - 3).map(|k| span * k as f64).collect();
    let mut first = Stage::new(course, limits, &bounds, &at, span, borders, before);
    first.improve([0.3, 1.0e-2], 0);
    if !length(&first.law).is_finite() {
        return Some((first.law, f64::INFINITY));
    }
    let (at, span, borders) = resample(&first.law, course, step, !head.is_empty());
    let mut stage = Stage::new(course, limits, &bounds, &at, span, borders, before);
    let found = stage.improve([0.3, 1.0e-3], 12);
    let factor = stage.repair(found);
    Some((stage.law, factor))
}

/// A law for where the search finds none: evenly, far below what any bend allows.
fn slowly(course: &Course, limits: &Limits) -> (Vec<Phase>, f64) {
    let mut slowest = course.cap();
    for place in &course.places {
        slowest = slowest.min(place.speed);
    }
    let rates = Rates::along(DVec3::ONE, SLOW * slowest, limits).by(SLOW);
    let ends = course.moving.map(|moves| if moves { rates.velocity } else { 0.0 });
    let law = cruise(0.0, course.length, ends, &rates);
    let mut excess = vec![[0.0; 4]; law.len()];
    verify(course, limits, &bounds(limits), &law, 0..law.len(), &mut excess);
    let factor = needed(&excess);
    (law, factor)
}

/// The law of a run that is a single line: ramps are the quickest that there are.
fn along_line(course: &Course, limits: &Limits) -> Option<Vec<Phase>> {
    let mut pieces = course.pieces();
    let (placed, from, cap) = pieces.next()?;
    let Piece::Straight(line) = &placed.piece else { return None };
    if pieces.next().is_some() {
        return None;
    }
    let rates = Rates::along(line.tangent, cap, limits).by(ROUNDED);
    let ends = course.moving.map(|moves| if moves { EVEN * rates.velocity } else { 0.0 });
    Some(cruise(from, course.length, ends, &rates))
}

/// A law as a spline to begin with, with the borders between which to make it faster: closer where
/// the path turns quickly.
fn resample(law: &[Phase], course: &Course, step: f64, is_head: bool) -> (Vec<f64>, f64, Vec<f64>) {
    let count = (0.5 * length(law) / step).ceil().max(3.0);
    let span = length(law) / count;
    let (first, last) = match (law.first(), law.last()) {
        (Some(first), Some(last)) => (first.at(0.0), last.at(last.duration)),
        _ => ([0.0; 4], [0.0; 4]),
    };
    let mut at: Vec<f64> = Vec::new();
    for k in [3.0, 2.0, 1.0] {
        at.push(if course.moving[0] { first[0] - first[1] * span * k } else { 0.0 });
    }
    // How many parts each interval has. The spline is behind the law by one and a half of them.
    let mut parts = vec![1; at.len() - 2];
    let (mut start, mut next, mut piece) = (0.0, 0.0, 0);
    for phase in law {
        let end = start + phase.duration;
        while next < count && next * span <= end {
            let [s, v, ..] = phase.at(next * span - start);
            at.push(s);
            course.find(s, &mut piece);
            let fine = ON_CORNER * v * span / (2.0 * course.turning(piece));
            parts.push(if fine > 2.0 {
                4
            } else if fine > 1.0 {
                2
            } else {
                1
            });
            next += 1.0;
        }
        start = end;
    }
    for k in [0.0, 1.0, 2.0, 3.0] {
        at.push(if course.moving[1] { last[0] + last[1] * span * k } else { course.length });
    }
    if is_head {
        // It runs through the law and not behind it, so fewer stand at its end.
        at = sampled(law, span, at.len() - 3);
        if !course.moving[1] {
            // To rest, it must not run beyond.
            for one in &mut at {
                *one = one.min(course.length);
            }
        }
    }
    let mut borders = Vec::new();
    for k in 0..at.len() - 4 {
        let mut count = 1;
        for near in k.saturating_sub(1)..(k + 3) {
            count = count.max(parts.get(near).copied().unwrap_or(1));
        }
        for part in 0..count {
            borders.push(span * (k as f64 + f64::from(part) / f64::from(count)));
        }
    }
    borders.push(span * (at.len() - 4) as f64);
    (at, span, borders)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contour::{Move, MoveCurve, Plane, Role};
    use crate::geometry::Line;
    use crate::motion::TrackBuilder;
    use glam::DVec2;

    #[test]
    fn where_no_law_is_found_a_slow_one_keeps_the_limits() {
        let limits = Limits::default();
        let mut builder = TrackBuilder::new(&limits);
        let mut track = Vec::new();
        let corners = [[0.0, 0.0], [30.0, 0.0], [30.0, 20.0], [2.0, 25.0]].map(DVec2::from);
        for ends in corners.windows(2) {
            let line = Line::new(ends[0], ends[1]).expect("a line");
            let one = Move {
                curve: MoveCurve::Line(line),
                role: Role::Free,
                rapid: false,
                feed: Some(150.0),
                plane: Plane::Xy,
                heights: [0.0; 2],
                origin: crate::diagnostic::Origin::Segment(0),
            };
            builder.push(&one, &mut track);
        }
        builder.finish(&mut track);
        let mut course = Course::default();
        for placed in track {
            course.push(placed, &limits);
        }
        let (slow, factor) = slowly(&course, &limits);
        assert!(factor.is_finite() && factor <= 1.0, "within the limits: {factor}");
        let last = slow.last().expect("phases");
        let end = last.at(last.duration)[0];
        assert!((end - course.length).abs() < 1e-9, "to the end: {end} of {}", course.length);
        assert!(length(&slow) > length(&law(&course, &limits)), "slower than what is sought");
    }
}
