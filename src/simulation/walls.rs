//! What of a programmed contour is a wall of the part.
//!
//! A contour may be gone round more than once: to finish what was left, as a spring pass does, or to
//! round a corner that the first lap leaves. Each lap has walls of its own, and those of the last are
//! what stays.

use std::borrow::Cow;

use glam::DVec2;

use crate::contour::{Contour, Segment, Side, Walls};
use crate::program::{ContourEnd, ContourStart, ProgrammedContour};

/// The shortest lap [mm]: far longer than segments that are as near to each other as they are short.
const SHORTEST: f64 = 1.0;

/// Cosine of the most that a lap may turn off from the one before where it begins.
const SAME_WAY: f64 = 0.999_9;

/// Once round a contour.
#[derive(Debug)]
pub(super) struct Lap<'a> {
    pub(super) walls: Cow<'a, Contour>,
    /// Index of its first segment on the contour.
    pub(super) first: usize,
}

/// The laps of a contour whose tool is on a side, each with its walls: without what only leads, runs
/// in or runs out, and without a segment on which the radius changes.
pub(super) fn laps(programmed: &ProgrammedContour, side: Side) -> Vec<Lap<'_>> {
    let whole = &programmed.contour;
    let segments = whole.segments();
    let from = programmed.leads_in || programmed.begins == ContourStart::Tapers;
    let until = segments.len() - usize::from(programmed.end == ContourEnd::Tapers);
    let mut laps = Vec::new();
    let mut first = usize::from(from);
    while first < until {
        let part = &segments[first..until];
        let count = lap_of(part);
        let walls = if count == segments.len() {
            Cow::Borrowed(whole)
        } else {
            Cow::Owned(Contour::of_segments(part[..count].to_vec(), false, [None, None]))
        };
        let alone = Walls::of(&walls, side).map(|alone| alone.alone(&walls));
        laps.push(Lap { walls: alone.map_or(walls, Cow::Owned), first });
        first += count;
    }
    laps
}

/// How many segments are the first lap of some that come back to where they began, go on the same way,
/// and come back again; otherwise all.
fn lap_of(segments: &[Segment]) -> usize {
    let goes_on = |count: usize| {
        let along = segments.get(count)?.curve.tangent(0.0);
        returns(segments, count, Some(along))
    };
    for count in 1..segments.len() {
        let Some(mut distance) = goes_on(count) else { continue };
        let rest = &segments[count..];
        if (1..=rest.len()).any(|count| returns(rest, count, None).is_some()) {
            // Short segments that come back beside the way in may be near to it before they end on it.
            let mut nearest = count;
            while let Some(next) = goes_on(nearest + 1).filter(|next| *next < distance) {
                (nearest, distance) = (nearest + 1, next);
            }
            return nearest;
        }
    }
    segments.len()
}

/// How far the end of the first `count` segments is from one of those that they ran in by, which goes on
/// `along` a direction there if one is given [mm]; `None` where that is no touch.
fn returns(segments: &[Segment], count: usize, along: Option<DVec2>) -> Option<f64> {
    let at = segments[count - 1].curve.end();
    let ran_in = segments[..count.min(Walls::MOST)].iter().enumerate();
    let mut distances = ran_in.filter_map(|(index, Segment { curve, .. })| {
        if curve.bounds().distance(at) > Walls::TOUCH {
            return None;
        }
        let nearest = curve.nearest(at);
        (nearest.distance <= Walls::TOUCH
            && along.is_none_or(|along| along.dot(curve.tangent(nearest.t)) >= SAME_WAY)
            && is_long(&segments[index + 1..count]))
        .then_some(nearest.distance)
    });
    distances.next()
}

/// Whether segments are long enough for a lap.
fn is_long(segments: &[Segment]) -> bool {
    let mut way = 0.0;
    segments.iter().any(|segment| {
        way += segment.curve.length();
        way >= SHORTEST
    })
}
