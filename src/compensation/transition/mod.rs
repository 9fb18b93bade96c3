//! Transitions: how the offsets of two segments are joined at a corner, one file for each kind.
//!
//! With unit tangents `T1`, `T2` and `n = σ perp(T)` the points of a corner `P` are
//! `N1 = P + r n1` and `N2 = P + r n2`, the ends of both offsets;
//! `V = P + r (n1 + n2) / (1 + n1·n2)`, where their end tangents meet;
//! `A1 = P + r (n1 + T1)` and `A2 = P + r (n2 − T2)`, the ends of the inserted straight move.
//! ("Tool radius compensation algorithm of spline curve", 2.3.1; for lines the vectors are those
//! of FANUC's cutter compensation C.)

mod elongated;
mod inserted;
mod shortened;

use glam::DVec2;

pub(super) use elongated::elongated;
pub(super) use inserted::inserted;
pub(super) use shortened::{Flank, Shortening, shortened};

use crate::contour::{Corner, MoveCurve, Tool};
use crate::geometry::{Arc, Line, perp};

/// Where on a run's offset an intersection lies.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(super) struct Place {
    /// Index of the piece.
    pub(super) piece: usize,
    /// Parameter on it.
    pub(super) t: f64,
}

/// How the offset of a segment ends at a corner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Terminal {
    /// As it is.
    Whole,
    /// Cut back to, or for an arc run on along its circle to, a place on it.
    At(Place),
    /// For straight offsets: cut back or run on to a point [mm].
    To(DVec2),
    /// Its end moved by a rounding to where the neighbour ends [mm].
    Moved(DVec2),
}

/// How two offsets are joined.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Solution {
    /// End of the incoming offset.
    pub(super) incoming: Terminal,
    /// Start of the outgoing offset.
    pub(super) outgoing: Terminal,
    /// Moves between them.
    pub(super) inserted: Vec<MoveCurve>,
    /// Construction points by name.
    pub(super) construction: Vec<(&'static str, DVec2)>,
}

/// The points of a corner that depend on its tangents alone.
#[derive(Debug, Clone, Copy)]
pub(super) struct CornerFrame {
    pub(super) p: DVec2,
    pub(super) n1: DVec2,
    pub(super) n2: DVec2,
    t1: DVec2,
    t2: DVec2,
    /// Unit vectors towards the tool.
    u1: DVec2,
    u2: DVec2,
    radius: f64,
}

impl CornerFrame {
    pub(super) fn new(corner: &Corner, tool: Tool) -> Self {
        let (radius, sign) = (tool.radius(), tool.side().sign());
        let (u1, u2) = (perp(corner.incoming) * sign, perp(corner.outgoing) * sign);
        Self {
            p: corner.point,
            n1: corner.point + u1 * radius,
            n2: corner.point + u2 * radius,
            t1: corner.incoming,
            t2: corner.outgoing,
            u1,
            u2,
            radius,
        }
    }

    /// V: where the end tangents of both offsets meet. Far out for turns near a reversal.
    pub(super) fn v(&self) -> DVec2 {
        self.p + (self.u1 + self.u2) * (self.radius / (1.0 + self.u1.dot(self.u2)))
    }

    /// A1: r beyond the end of the incoming offset.
    pub(super) fn a1(&self) -> DVec2 {
        self.n1 + self.t1 * self.radius
    }

    /// A2: r before the start of the outgoing offset.
    pub(super) fn a2(&self) -> DVec2 {
        self.n2 - self.t2 * self.radius
    }

    /// The points that every construction starts from.
    pub(super) fn construction(&self) -> Vec<(&'static str, DVec2)> {
        vec![("P", self.p), ("N1", self.n1), ("N2", self.n2)]
    }

    /// The arc about the corner from N1 to N2, round the outside.
    pub(super) fn corner_arc(&self, tool: Tool) -> Option<MoveCurve> {
        let clockwise = tool.side().sign() > 0.0;
        let arc = Arc::from_center(self.n1, self.n2, self.p, clockwise, f64::INFINITY);
        arc.ok().map(MoveCurve::Arc)
    }
}

/// Straight moves along `points`, those without length left out.
pub(super) fn polyline(points: &[DVec2]) -> Vec<MoveCurve> {
    let mut moves = Vec::with_capacity(points.len());
    for pair in points.windows(2) {
        moves.extend(Line::new(pair[0], pair[1]).ok().map(MoveCurve::Line));
    }
    moves
}
