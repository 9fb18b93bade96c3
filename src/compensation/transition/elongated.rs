//! Elongated: an obtuse outside corner, whose offsets run on to where their end tangents meet.
//!
//! A straight offset is itself run on to `V`. Arcs and splines are not extended: a straight move
//! runs along their end tangent, so line–line inserts nothing, line–arc and line–spline one move,
//! any two curves two moves.

use super::{CornerFrame, Solution, Terminal, polyline};

/// Joins two offsets at their common vertex V; the flags tell which of them are straight.
pub(in crate::compensation) fn elongated(
    frame: &CornerFrame,
    incoming_straight: bool,
    outgoing_straight: bool,
) -> Solution {
    let v = frame.v();
    let mut construction = frame.construction();
    construction.push(("V", v));
    let mut points = Vec::with_capacity(3);
    if !incoming_straight {
        points.push(frame.n1);
    }
    points.push(v);
    if !outgoing_straight {
        points.push(frame.n2);
    }
    let terminal = |straight| if straight { Terminal::To(v) } else { Terminal::Whole };
    Solution {
        incoming: terminal(incoming_straight),
        outgoing: terminal(outgoing_straight),
        inserted: polyline(&points),
        construction,
    }
}
