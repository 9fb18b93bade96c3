//! The move that switches compensation on.

use glam::DVec2;

use super::queue::{Pending, Shape};
use super::{Control, Refused, SAME_LENGTH, TOO_TIGHT, climb, helix, swept};
use crate::contour::{Attributes, Role};
use crate::geometry::{Arc, direction, perp};

/// Cosine of the angle between the chord of a lead-in arc and the radius at its end, below which no
/// centre is equally far from both.
const MIN_COSINE: f64 = 1e-4;

impl Control<'_> {
    /// A straight lead-in to `to`: its end is beside its own.
    pub(super) fn lead_in(&mut self, to: DVec2, attributes: &Attributes) -> Result<(), Refused> {
        self.origin = attributes.origin;
        let (step, least) = (to - self.at, self.least_length());
        let Some(along) = direction(step).filter(|_| step.length() > least) else {
            return Err(Refused("short-lead-in", "the lead-in is not longer than the tool radius"));
        };
        let attributes = self.timed(attributes, step.length().hypot(climb(attributes)));
        self.queue.begin(self.at);
        let normal = perp(along) * self.tool.side().sign();
        self.programmed = to;
        self.at = to + normal * self.tool.radius();
        // Trimmed it may run backwards: it was long enough.
        let shape = Shape::Line { along: normal };
        self.queue.push(Pending { to: self.at, shape, attributes, role: Role::LeadIn });
        Ok(())
    }

    /// A lead-in along an arc, after as many full circles: it ends beside its own end, and its centre moves along the radius
    /// there to where it is equally far from both ends.
    pub(super) fn arc_lead_in(
        &mut self,
        arc: &Arc,
        turns: u32,
        attributes: &Attributes,
    ) -> Result<(), Refused> {
        self.origin = attributes.origin;
        let (from, end, radius) = (self.at, arc.end(), self.tool.radius());
        if from.distance(end) <= self.least_length() {
            let message = "the ends of the lead-in arc are not farther apart than the tool radius";
            return Err(Refused("short-lead-in", message));
        }
        let is_inside = self.is_inside(arc.is_clockwise());
        // An R word is compared as it is written, not as the centre that it gives lies.
        let more = if self.passage.is_listed { -SAME_LENGTH } else { SAME_LENGTH };
        if is_inside && arc.radius() <= radius + more {
            return Err(TOO_TIGHT);
        }
        let attributes = self.timed(attributes, helix(arc, turns, attributes));
        let inwards = direction(arc.center() - end).ok_or(TOO_TIGHT)?;
        let beside = end + inwards * if is_inside { radius } else { -radius };
        let chord = from - beside;
        let cosine = chord.normalize_or_zero().dot(inwards);
        if cosine.abs() < MIN_COSINE {
            return Err(TOO_TIGHT);
        }
        let center = beside + inwards * (0.5 * chord.length() / cosine);
        if self.passage.tip != DVec2::ZERO {
            // A lathe tool first puts the centre of its tip where its own point was.
            let along = DVec2::ZERO;
            let (shape, role) = (Shape::Line { along }, Role::LeadIn);
            let heights = [attributes.heights[0]; 2];
            let attributes = Attributes { heights, ..attributes };
            self.queue.begin(from);
            self.queue.push(Pending { to: from, shape, attributes, role });
        }
        let clockwise = arc.is_clockwise();
        let sweep = swept(from - center, beside - center, clockwise);
        (self.programmed, self.at) = (end, beside);
        let shape = Shape::Arc { center, clockwise, sweep, turns };
        self.queue.push(Pending { to: beside, shape, attributes, role: Role::LeadIn });
        Ok(())
    }
}
