//! What of a programmed contour is a wall of the part.

use std::borrow::Cow;

use crate::contour::{Contour, Side, Walls};
use crate::program::{ContourEnd, ContourStart, ProgrammedContour};

/// The walls of a contour whose tool is on a side: without what only leads, runs in or runs out, and
/// without a segment on which the radius changes. `None` where nothing is left.
pub(super) fn walls(programmed: &ProgrammedContour, side: Side) -> Option<Cow<'_, Contour>> {
    let first = programmed.leads_in || programmed.begins == ContourStart::Tapers;
    let last = programmed.end == ContourEnd::Tapers;
    if !first && !last {
        let whole = &programmed.contour;
        let alone = Walls::of(whole, side).map(|walls| walls.alone(whole));
        return Some(alone.map_or(Cow::Borrowed(whole), Cow::Owned));
    }
    let segments = programmed.contour.segments();
    let until = segments.len() - usize::from(last);
    let segments = segments.get(usize::from(first)..until).filter(|part| !part.is_empty())?;
    let part = Contour::of_segments(segments.to_vec(), false, [None, None]);
    Some(Cow::Owned(
        Walls::of(&part, side).map_or_else(|| part.clone(), |walls| walls.alone(&part)),
    ))
}
