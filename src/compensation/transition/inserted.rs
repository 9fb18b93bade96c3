//! Inserted: an acute outside corner, rounded by further moves.
//!
//! Each offset runs on by r along its end tangent, to `A1` and `A2`, and a straight move joins
//! them. A straight offset is itself run on, so line–line inserts one move, line–arc and
//! line–spline two, any two curves three.

use super::{CornerFrame, Solution, Terminal, polyline};

/// Joins two offsets through A1 and A2; the flags tell which of them are straight.
pub(in crate::compensation) fn inserted(
    frame: &CornerFrame,
    incoming_straight: bool,
    outgoing_straight: bool,
) -> Solution {
    let (a1, a2) = (frame.a1(), frame.a2());
    let mut construction = frame.construction();
    construction.extend([("A1", a1), ("A2", a2)]);
    let mut points = Vec::with_capacity(4);
    if !incoming_straight {
        points.push(frame.n1);
    }
    points.extend([a1, a2]);
    if !outgoing_straight {
        points.push(frame.n2);
    }
    Solution {
        incoming: if incoming_straight { Terminal::To(a1) } else { Terminal::Whole },
        outgoing: if outgoing_straight { Terminal::To(a2) } else { Terminal::Whole },
        inserted: polyline(&points),
        construction,
    }
}
