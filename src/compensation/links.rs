//! Staying down between the passes of a room.
//!
//! A closed pass may begin anywhere. So it begins where it is nearest to the end of the pass round it,
//! and the tool goes there straight, down as it is, if nothing that should stay is near its way.

use super::Options;
use super::passes::GAP;
use super::run::part;
use crate::contour::{Contour, Move, MoveCurve, Role, Tool};
use crate::geometry::Line;

/// Most places of a link that are looked at: one that stays so near to a wall is not worth more.
const STEPS: usize = 200;

/// Share of a move that is none: the pass begins where the move does.
const SLIVER: f64 = 1e-6;

/// Share of the tolerance that makes a step.
const LEAST_STEP: f64 = 0.1;

/// What links must keep clear of.
pub(super) struct Links<'a> {
    /// The contours, each with the tool of the first pass.
    pub inner: &'a [(Contour, Tool)],
    pub options: &'a Options,
    pub stepover: f64,
}

impl Links<'_> {
    /// Adds a link from where `moves` end, and behind it a `closed` loop of the pass with this number
    /// from where the link meets it on; nothing where the tool cannot stay down, which is returned.
    pub(super) fn link(&self, moves: &mut Vec<Move>, pass: u32, closed: &[Move]) -> bool {
        let (Some(last), Some(first), Some(end)) = (moves.last(), closed.first(), closed.last())
        else {
            return false;
        };
        let (from, heights) = (last.curve.end(), [last.heights[1]; 2]);
        let is_level = |one: &Move| one.heights == heights && one.plane == last.plane;
        if first.curve.start().distance(end.curve.end()) > GAP || !closed.iter().all(is_level) {
            return false;
        }
        let (mut index, mut t, mut least) = (0, 0.0, f64::INFINITY);
        for (i, one) in closed.iter().enumerate() {
            let nearest = one.curve.nearest(from);
            if nearest.distance < least {
                (index, t, least) = (i, nearest.t, nearest.distance);
            }
        }
        if !(SLIVER..1.0 - SLIVER).contains(&t) {
            t = t.round();
        }
        let met = closed[index];
        let Ok(line) = Line::new(from, met.curve.point(t)) else { return false };
        // A place is nearer to a wall than either end by at most how far it is from that end, and both
        // ends keep away by the offsets of their passes.
        let reach = f64::from(2 * pass - 1) * self.stepover;
        let is_between_passes = pass > 1 && line.length() <= reach;
        if !is_between_passes && !self.is_clear(&line) {
            return false;
        }
        moves.push(Move { curve: MoveCurve::Line(line), role: Role::Link, ..met });
        if let Some(curve) = part(&met.curve, t, 1.0) {
            moves.push(Move { curve, ..met });
        }
        moves.extend_from_slice(&closed[index + 1..]);
        moves.extend_from_slice(&closed[..index]);
        if let Some(curve) = part(&met.curve, 0.0, t) {
            moves.push(Move { curve, ..met });
        }
        true
    }

    /// Whether the tool comes nowhere on a line nearer to a wall than the tolerance allows.
    fn is_clear(&self, line: &Line) -> bool {
        let tolerance = self.options.usable_tolerance();
        let mut gone = 0.0;
        for _ in 0..STEPS {
            let at = line.point(gone / line.length());
            let mut room = f64::INFINITY;
            for (contour, tool) in self.inner {
                for segment in contour.segments() {
                    room = room.min(segment.curve.nearest(at).distance - tool.radius());
                }
            }
            // As far as a place is from being too near, the tool may go in any direction.
            let step = room + tolerance;
            if step < LEAST_STEP * tolerance {
                return false;
            }
            gone += step;
            if gone >= line.length() {
                return true;
            }
        }
        false
    }
}
