//! Shortened: an inside corner, whose offsets are cut back to their intersection.
//!
//! Two straight offsets meet at `V`. Otherwise, of the points that both *finite* offsets share
//! and in which they cross as the corner does, `σ (T_in × T_out) > 0`, the last along the incoming
//! offset is taken: it is the one that cuts least off. Where there is none the tool does not fit
//! into the corner.

use glam::DVec2;

use super::{CornerFrame, Place, Solution, Terminal};
use crate::compensation::meet::meet;
use crate::contour::{MoveCurve, Tool};
use crate::geometry::{Bounds, cross, in_range};

/// Sine of the angle below which two offsets touch rather than cross: neighbouring pieces of one
/// offset share a tangent up to rounding.
const TOUCH: f64 = 1e-9;

/// How a shortened corner comes out.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::compensation) enum Shortening {
    /// Both offsets are cut back to this point.
    Met(Solution),
    /// The offsets do not meet: the tool does not fit. The solution is what a control without a
    /// further look would do.
    Missed(Solution),
}

/// An offset as seen from a corner: its pieces, or straight without end towards it.
#[derive(Debug, Clone, Copy)]
pub(in crate::compensation) struct Flank<'a> {
    /// Its pieces in order.
    pub(in crate::compensation) pieces: &'a [MoveCurve],
    /// Whether it is one straight line.
    pub(in crate::compensation) straight: bool,
}

/// Cuts two offsets back to their intersection. `same` tells that both are the same offset, of a
/// closed contour of one segment.
pub(in crate::compensation) fn shortened(
    frame: &CornerFrame,
    incoming: Flank,
    outgoing: Flank,
    tool: Tool,
    same: bool,
) -> Shortening {
    let mut construction = frame.construction();
    let v = frame.v();
    // Near a reversal the end tangents of two inside offsets meet beyond all coordinates.
    if incoming.straight && outgoing.straight && in_range(v) {
        construction.push(("V", v));
        let on = [on_line(incoming.pieces, v), on_line(outgoing.pieces, v)];
        // Off both, V may be anywhere: near a reversal, metres away.
        if on[0] || on[1] {
            let solution = Solution {
                incoming: Terminal::To(v),
                outgoing: Terminal::To(v),
                inserted: Vec::new(),
                construction,
            };
            let met = on[0] && on[1];
            return if met { Shortening::Met(solution) } else { Shortening::Missed(solution) };
        }
    }
    if let Some((place_in, place_out, point)) =
        last_crossing(incoming.pieces, outgoing.pieces, tool.side().sign(), same)
    {
        construction.push(("V", point));
        // A straight offset takes the point itself: it is exact, where a parameter is rounded.
        let terminal = |side: Flank, place| {
            if side.straight { Terminal::To(point) } else { Terminal::At(place) }
        };
        return Shortening::Met(Solution {
            incoming: terminal(incoming, place_in),
            outgoing: terminal(outgoing, place_out),
            inserted: Vec::new(),
            construction,
        });
    }
    Shortening::Missed(Solution {
        incoming: Terminal::Whole,
        outgoing: Terminal::Whole,
        inserted: super::polyline(&[frame.n1, frame.n2]),
        construction,
    })
}

/// Whether `point`, known to be on the line extended, is on the one straight piece.
fn on_line(pieces: &[MoveCurve], point: DVec2) -> bool {
    let [MoveCurve::Line(line)] = pieces else { return false };
    line.nearest(point).distance <= 1e-9 * (1.0 + line.length())
}

/// The last crossing along the incoming pieces that shortens both.
fn last_crossing(
    incoming: &[MoveCurve],
    outgoing: &[MoveCurve],
    sign: f64,
    same: bool,
) -> Option<(Place, Place, DVec2)> {
    let boxes: Vec<Bounds> = outgoing.iter().map(reach).collect();
    let whole = boxes.iter().copied().fold(Bounds::EMPTY, Bounds::union);
    for (i, a) in incoming.iter().enumerate().rev() {
        let reach_a = reach(a);
        if !reach_a.meets(&whole) {
            continue;
        }
        let mut best: Option<(Place, Place, DVec2)> = None;
        for (j, b) in outgoing.iter().enumerate() {
            if !reach_a.meets(&boxes[j]) || (same && j >= i) {
                continue;
            }
            for crossing in meet(a, b).points() {
                let (t, u) = (crossing.t, crossing.u);
                let shortens = sign * cross(a.tangent(t), b.tangent(u)) > TOUCH;
                if shortens && best.is_none_or(|(place, ..)| t > place.t) {
                    let places = (Place { piece: i, t }, Place { piece: j, t: u });
                    best = Some((places.0, places.1, crossing.point));
                }
            }
        }
        if best.is_some() {
            return best;
        }
    }
    None
}

/// A quick box around a piece, a little larger than it.
fn reach(piece: &MoveCurve) -> Bounds {
    piece.hull_bounds().inflated(crate::geometry::MIN_LENGTH)
}
