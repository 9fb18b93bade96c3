//! What of a programmed contour is a wall of the part.
//!
//! Not what only leads in, nor a segment on which the radius changes; and not what runs over: programs
//! begin before a corner of the part and end behind it, so that the first and the last segment cross
//! where the corner is.

use std::borrow::Cow;

use crate::contour::{Contour, Side};
use crate::geometry::intersect::{arc_arc, line_arc, line_line};
use crate::geometry::{Curve, perp};
use crate::program::{ContourEnd, ContourStart, ProgrammedContour};

/// The walls of a contour whose tool is on a side; `None` where there are none.
pub(super) fn walls(programmed: &ProgrammedContour, side: Side) -> Option<Cow<'_, Contour>> {
    let first = programmed.leads_in || programmed.begins == ContourStart::Tapers;
    let last = programmed.end == ContourEnd::Tapers;
    if !first && !last {
        let whole = &programmed.contour;
        return Some(without_overrun(whole, side).map_or(Cow::Borrowed(whole), Cow::Owned));
    }
    let segments = programmed.contour.segments();
    let until = segments.len() - usize::from(last);
    let segments = segments.get(usize::from(first)..until).filter(|part| !part.is_empty())?;
    let part = Contour::of_segments(segments.to_vec(), false, [None, None]);
    Some(Cow::Owned(without_overrun(&part, side).unwrap_or(part)))
}

/// The contour without what runs over; `None` where nothing does.
///
/// What the first segment has before the crossing lies on the tool's side of the last one, and what
/// the last has behind it on the tool's side of the first: both are air to be cut, not part. Ends
/// that cross the other way round are a loop of the contour, and stay.
pub(super) fn without_overrun(contour: &Contour, side: Side) -> Option<Contour> {
    let [first, .., last] = contour.segments() else { return None };
    if contour.is_closed() {
        return None;
    }
    let crossings = match (&first.curve, &last.curve) {
        (Curve::Line(a), Curve::Line(b)) => line_line(a, b),
        (Curve::Line(a), Curve::Arc(b)) => line_arc(a, b),
        (Curve::Arc(a), Curve::Line(b)) => line_arc(b, a).exchanged(),
        (Curve::Arc(a), Curve::Arc(b)) => arc_arc(a, b),
        (Curve::Spline(_), _) | (_, Curve::Spline(_)) => return None,
    };
    for crossing in crossings.points() {
        let (along, leaving) = (first.curve.tangent(crossing.t), last.curve.tangent(crossing.u));
        if perp(along).dot(leaving) * side.sign() > 0.0 {
            let starts = after(&first.curve, crossing.t);
            let ends = before(&last.curve, crossing.u);
            let runs_over = starts.is_some() || ends.is_some();
            return runs_over.then(|| contour.with_ends([starts, ends]));
        }
    }
    None
}

/// What a curve has behind a place; `None` where that is all of it, or none.
fn after(curve: &Curve, t: f64) -> Option<Curve> {
    Some(match curve {
        Curve::Line(line) => Curve::Line(line.split(t).ok()?.1),
        Curve::Arc(arc) => Curve::Arc(arc.split(t).ok()?.1),
        Curve::Spline(_) => return None,
    })
}

/// What a curve has before a place; `None` where that is all of it, or none.
fn before(curve: &Curve, t: f64) -> Option<Curve> {
    Some(match curve {
        Curve::Line(line) => Curve::Line(line.split(t).ok()?.0),
        Curve::Arc(arc) => Curve::Arc(arc.split(t).ok()?.0),
        Curve::Spline(_) => return None,
    })
}
