//! Moves as numbers, a fixed count for each; the layout is that of `records()` in `types.d.ts`.

use super::numbering::Numbering;
use crate::contour::{Move, MoveCurve, Plane, Role};
use crate::diagnostic::Origin;

/// Numbers of one move.
pub const STRIDE: usize = 19;

const RAPID: f64 = 0.0;
const LINE: f64 = 1.0;
const ARC: f64 = 2.0;
const CUBIC: f64 = 3.0;
const INVOLUTE: f64 = 4.0;

/// Stands where there is nothing.
const NONE: f64 = f64::NAN;

/// All moves, [`STRIDE`] numbers each.
pub(super) fn move_records(moves: &[Move], numbering: &Numbering) -> Vec<f64> {
    let mut records = Vec::with_capacity(moves.len() * STRIDE);
    for step in moves {
        add_record(&mut records, step, numbering);
    }
    records
}

/// Adds the numbers of one move.
#[inline(never)]
pub(super) fn add_record(records: &mut Vec<f64>, step: &Move, numbering: &Numbering) {
    records.extend_from_slice(&record(step, numbering));
}

fn record(step: &Move, numbering: &Numbering) -> [f64; STRIDE] {
    let Move { curve, role, rapid, feed, plane, heights, origin } = step;
    let (kind, shape) = match curve {
        // A rapid move is straight: an arc or a cubic must be followed as it is.
        MoveCurve::Line(_) | MoveCurve::Vertical(_) if *rapid => (RAPID, [0.0; 4]),
        MoveCurve::Line(_) | MoveCurve::Vertical(_) => (LINE, [0.0; 4]),
        MoveCurve::Arc(arc) => {
            let clockwise = f64::from(u8::from(arc.is_clockwise()));
            (ARC, [arc.center().x, arc.center().y, arc.radius(), clockwise])
        }
        MoveCurve::Cubic(cubic) => (CUBIC, {
            let [_, control1, control2, _] = cubic.points;
            [control1.x, control1.y, control2.x, control2.y]
        }),
        MoveCurve::Involute(involute) => {
            let (center, radius) = (involute.center(), involute.base_radius());
            let clockwise = f64::from(u8::from(involute.is_clockwise()));
            (INVOLUTE, [center.x, center.y, radius, clockwise])
        }
    };
    let role = match role {
        Role::Segment => 0.0,
        Role::Transition => 1.0,
        Role::LeadIn => 2.0,
        Role::LeadOut => 3.0,
        Role::Free => 4.0,
        Role::Link => 5.0,
    };
    let from = plane.place(curve.start(), heights[0]);
    let to = plane.place(curve.end(), heights[1]);
    let plane = match plane {
        Plane::Xy => 0.0,
        Plane::Zx => 1.0,
        Plane::Yz => 2.0,
    };
    let feed = feed.map_or(NONE, per_minute);
    let place = |number: Option<u32>| number.map_or(NONE, f64::from);
    let [block, number, column] = match *origin {
        Origin::Block { line, number, column } => [f64::from(line), place(number), place(column)],
        Origin::Segment(_) => [NONE; 3],
    };
    let place = numbering.place_of(*origin);
    let contour = place.and_then(|place| place.contour).map_or(NONE, f64::from);
    let segment = place.map_or(NONE, |place| place.segment.into());
    let [a, b, c, d] = shape;
    [
        kind, role, plane, feed, block, number, column, contour, segment, from.x, from.y, from.z,
        to.x, to.y, to.z, a, b, c, d,
    ]
}

/// A feed of the core [mm/s] in JavaScript's unit [mm/min], without what seconds and back make of its last
/// digits.
pub(super) fn per_minute(per_second: f64) -> f64 {
    (per_second * 60e9).round_ties_even() / 1e9
}

/// A feed of JavaScript [mm/min] in the core's unit [mm/s].
pub(super) fn per_second(per_minute: f64) -> f64 {
    per_minute / 60.0
}
