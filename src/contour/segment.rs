//! Contours: ordered segments with what belongs to each.

use std::ops::Range;

use glam::DVec2;

use super::{Plane, Wish};
use crate::diagnostic::Origin;
use crate::geometry::{Arc, Bounds, Curve, Line, MIN_LENGTH};

/// What a segment carries besides its curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attributes {
    /// Where it was programmed.
    pub origin: Origin,
    /// Programmed feed [mm/s].
    pub feed: Option<f64>,
    /// Time that its whole path is to take, where the feed is programmed so (G93) [s].
    pub time: Option<f64>,
    /// Whether it is a rapid move (G00).
    pub rapid: bool,
    /// The plane that it lies in.
    pub plane: Plane,
    /// Height above the plane at its start and at its end [mm].
    pub heights: [f64; 2],
    /// What the program asks of the corner at its start, or of the lead that it is.
    pub wish: Wish,
}

impl Attributes {
    /// A segment in the plane of x and y at height zero, without a feed.
    #[must_use]
    pub fn at(origin: Origin) -> Self {
        Self {
            origin,
            feed: None,
            time: None,
            rapid: false,
            plane: Plane::Xy,
            heights: [0.0, 0.0],
            wish: Wish::default(),
        }
    }
}

/// One line, arc, spline or involute of a contour.
#[derive(Debug, Clone, PartialEq)]
pub struct Segment {
    /// Its curve.
    pub curve: Curve,
    /// What else was programmed with it.
    pub attributes: Attributes,
}

/// The far end of a move that switches compensation on or off: where a lead-in comes from, or a
/// lead-out goes to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lead {
    /// The uncompensated end [mm].
    pub point: DVec2,
    /// What was programmed with the move.
    pub attributes: Attributes,
}

/// Something that happens between two segments while compensation is on.
#[derive(Debug, Clone, PartialEq)]
pub struct Event {
    /// Index of the segment before which it happens; the number of segments for the end.
    pub before: usize,
    /// Where it was programmed.
    pub origin: Origin,
    /// What happens.
    pub kind: EventKind,
}

/// What can happen between two segments.
#[derive(Debug, Clone, PartialEq)]
pub enum EventKind {
    /// Words that move nothing, to be passed through: M, S and T words, comments.
    Words(String),
    /// A move along z alone.
    Vertical(Attributes),
    /// The machine waits for its operator: what was made up to here is made to its end.
    Stop,
}

/// The programmed boundary of the part.
///
/// # Guarantees
/// There is at least one segment; each starts where the one before it ends, to within
/// [`MIN_LENGTH`](crate::geometry::MIN_LENGTH). A closed contour so ends where it starts.
#[derive(Debug, Clone, PartialEq)]
pub struct Contour {
    pub(super) segments: Vec<Segment>,
    pub(super) closed: bool,
    pub(super) lead_in: Option<Lead>,
    pub(super) lead_out: Option<Lead>,
    pub(super) wall: Option<DVec2>,
    pub(super) events: Vec<Event>,
}

impl Contour {
    /// A contour of segments that are known to follow each other.
    pub(crate) fn of_segments(
        segments: Vec<Segment>,
        closed: bool,
        [lead_in, lead_out]: [Option<Lead>; 2],
    ) -> Self {
        Self { segments, closed, lead_in, lead_out, wall: None, events: Vec::new() }
    }

    /// Its segments, in order.
    #[must_use]
    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    /// Whether its end is its start, with a corner or a smooth passage there.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// Where compensation is switched on, if it is by a move.
    #[must_use]
    pub fn lead_in(&self) -> Option<&Lead> {
        self.lead_in.as_ref()
    }

    /// Where compensation is switched off, if it is by a move.
    #[must_use]
    pub fn lead_out(&self) -> Option<&Lead> {
        self.lead_out.as_ref()
    }

    /// The direction of a wall behind its end: the lead-out begins where the path meets that along it
    /// (FANUC's G40 with I and J).
    #[must_use]
    pub fn wall(&self) -> Option<DVec2> {
        self.wall
    }

    /// What happens between its segments, in order.
    #[must_use]
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// How many events are before those that happen before a segment.
    fn events_before(&self, segment: usize) -> usize {
        self.events.partition_point(|event| event.before < segment)
    }

    /// What happens before one segment.
    pub(crate) fn events_at(&self, segment: usize) -> &[Event] {
        &self.events[self.events_before(segment)..self.events_before(segment + 1)]
    }

    /// Its first point [mm].
    #[must_use]
    pub fn start(&self) -> DVec2 {
        self.segments[0].curve.start()
    }

    /// An open contour of some of its segments, with what happens between them; the lead-in, and what
    /// happens behind it, comes with the first segment, and the lead-out with the last.
    #[must_use]
    pub(crate) fn part(&self, range: Range<usize>) -> Self {
        let ends = range.end == self.segments.len();
        let from = if range.start == 0 { 0 } else { self.events_before(range.start + 1) };
        let to = if ends { self.events.len() } else { self.events_before(range.end) };
        let mut events = self.events[from..to].to_vec();
        for event in &mut events {
            event.before -= range.start;
        }
        Self {
            closed: false,
            lead_in: self.lead_in.filter(|_| range.start == 0),
            lead_out: self.lead_out.filter(|_| ends),
            wall: self.wall.filter(|_| ends),
            events,
            segments: self.segments[range].to_vec(),
        }
    }

    /// Puts a segment before the first, and one behind the last.
    pub(crate) fn extend(&mut self, first: Option<Segment>, last: Option<Segment>) {
        if let Some(first) = first {
            self.segments.insert(0, first);
            for event in &mut self.events {
                event.before += 1;
            }
        }
        self.segments.extend(last);
    }

    /// Gives each of its points another place, in order [mm]; the centre of an arc moves with its start.
    pub(crate) fn place(&mut self, place: &mut dyn FnMut(DVec2) -> DVec2) {
        if let Some(lead) = &mut self.lead_in {
            lead.point = place(lead.point);
        }
        let mut from = place(self.start());
        for segment in &mut self.segments {
            let (start, to) = (segment.curve.start(), place(segment.curve.end()));
            let moved = match &segment.curve {
                Curve::Arc(arc) => {
                    let center = arc.center() + (from - start);
                    Arc::winding(from, to, center, arc.is_clockwise()).map(Curve::Arc)
                }
                _ => Line::new(from, to).map(Curve::Line),
            };
            if let Ok(moved) = moved {
                segment.curve = moved;
            }
            from = to;
        }
        if let Some(lead) = &mut self.lead_out {
            lead.point = place(lead.point);
        }
    }

    /// The same segments without leads, and without what happens between them; closed if they end
    /// where they start.
    #[must_use]
    pub fn without_leads(&self) -> Self {
        let meets = self.end().distance(self.start()) <= MIN_LENGTH;
        Self {
            segments: self.segments.clone(),
            closed: self.closed || meets,
            lead_in: None,
            lead_out: None,
            wall: None,
            events: Vec::new(),
        }
    }

    /// The same contour with splines in the place of its involutes, each proved to be within
    /// `tolerance` [mm]; `None` where it has no involute.
    #[must_use]
    pub fn with_splines(&self, tolerance: f64) -> Option<Self> {
        let mut with = None;
        for (i, segment) in self.segments.iter().enumerate() {
            if let Curve::Involute(involute) = &segment.curve {
                let with = with.get_or_insert_with(|| self.clone());
                with.segments[i].curve = Curve::Spline(involute.spline(tolerance));
            }
        }
        with
    }

    /// Its last point [mm].
    #[must_use]
    pub fn end(&self) -> DVec2 {
        self.segments[self.segments.len() - 1].curve.end()
    }

    /// The smallest box around it, leads apart.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        self.segments.iter().map(|s| s.curve.bounds()).fold(Bounds::EMPTY, Bounds::union)
    }
}
