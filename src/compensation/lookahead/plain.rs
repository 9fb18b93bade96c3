//! The path of a tool without a radius.

use glam::DVec2;

use super::queue::{Pending, Shape};
use super::{Control, climb, helix};
use crate::contour::{Contour, EventKind, Lead, Role};
use crate::geometry::Curve;

impl Control<'_> {
    /// Without a radius the tool goes where the program says.
    pub(super) fn as_programmed(&mut self, contour: &Contour) {
        let straight = |to, attributes, role| {
            let shape = Shape::Line { along: DVec2::ZERO };
            Pending { to, shape, attributes, role }
        };
        let mut at = self.programmed;
        let mut events = contour.events().iter().peekable();
        if let Some(lead) = contour.lead_in() {
            at = contour.start();
            let length = lead.point.distance(at).hypot(climb(&lead.attributes));
            let attributes = self.timed(&lead.attributes, length);
            self.queue.push(straight(at, attributes, Role::LeadIn));
        }
        for index in 0..=contour.segments().len() {
            while let Some(event) = events.next_if(|event| event.before <= index) {
                match &event.kind {
                    EventKind::Words(_) => self.queue.words(event),
                    EventKind::Stop => {}
                    EventKind::Vertical(attributes) => {
                        let attributes = self.timed(attributes, climb(attributes).abs());
                        self.queue.push(straight(at, attributes, Role::Segment));
                    }
                }
            }
            let Some(segment) = contour.segments().get(index) else { break };
            let (attributes, role) = (&segment.attributes, Role::Segment);
            at = segment.curve.end();
            match &segment.curve {
                Curve::Line(line) => {
                    let length = line.length().hypot(climb(attributes));
                    self.queue.push(straight(at, self.timed(attributes, length), role));
                }
                Curve::Arc(arc) => {
                    let (center, clockwise) = (arc.center(), arc.is_clockwise());
                    let shape = Shape::Arc { center, clockwise, sweep: arc.sweep(), turns: 0 };
                    let attributes = self.timed(attributes, helix(arc, 0, attributes));
                    self.queue.push(Pending { to: at, shape, attributes, role });
                }
                Curve::Spline(_) | Curve::Involute(_) => {
                    self.queue.release();
                    let along;
                    let pieces = match &segment.curve {
                        Curve::Spline(spline) => spline.pieces(),
                        Curve::Involute(involute) => {
                            along = involute.cubics(self.options.usable_tolerance());
                            &along
                        }
                        Curve::Line(_) | Curve::Arc(_) => &[],
                    };
                    self.queue.cubics(pieces, attributes);
                }
            }
        }
        if let Some(Lead { point, attributes }) = contour.lead_out() {
            let length = at.distance(*point).hypot(climb(attributes));
            self.queue.push(straight(*point, self.timed(attributes, length), Role::LeadOut));
        }
        self.queue.release();
    }
}
