//! The moves whose end is still open, and the words between them.

use std::f64::consts::TAU;

use glam::DVec2;

use super::{Refused, SAME_LENGTH, swept};
use crate::contour::{
    Attributes, AuxiliaryWords, Event, EventKind, Move, MoveCurve, Role, ToolPath,
};
use crate::diagnostic::Diagnostic;
use crate::geometry::{Arc, Cubic, Line, MIN_LENGTH};

/// How much farther than programmed an arc may turn when its end is moved: 0.0254 rad in a program
/// in mm, 0.001 rad in one in inches. The control compares the angle with what is a length to it.
const MORE_TURN: [f64; 2] = [0.0254, 0.001];

/// How much the radius of an arc may change when its end is moved, in units of the program.
const MORE_RADIUS: f64 = 0.01;

/// Angle below which the end of a circle is its start [rad]; the motion controller's own.
const SAME_PLACE: f64 = 1e-6;

/// The curve of a move whose end is open.
#[derive(Debug, Clone, Copy)]
pub(super) enum Shape {
    Line {
        /// The direction in which it was programmed, of any length; zero where it has none.
        along: DVec2,
    },
    Arc {
        center: DVec2,
        clockwise: bool,
        /// How far it was programmed to turn [rad].
        sweep: f64,
        /// Full circles before that.
        turns: u32,
    },
}

/// A move whose end is open.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pending {
    /// Where it ends so far [mm].
    pub(super) to: DVec2,
    pub(super) shape: Shape,
    pub(super) attributes: Attributes,
    pub(super) role: Role,
}

enum Entry {
    Move(Pending),
    Words(AuxiliaryWords),
}

/// What waits for the next segment, and the path before it.
pub(super) struct Queue {
    pub(super) path: ToolPath,
    entries: Vec<Entry>,
    /// The first move that waits, or the last that did.
    front: Option<Shape>,
    /// Where the first move that waits begins [mm], where the control knows it.
    start: Option<DVec2>,
    /// Where the path ends [mm].
    pen: DVec2,
    tip: DVec2,
    inches: bool,
    unit: f64,
}

impl Queue {
    pub(super) fn new(pen: DVec2, tip: DVec2, unit: f64) -> Self {
        Self {
            path: ToolPath::default(),
            entries: Vec::new(),
            front: None,
            start: None,
            pen,
            tip,
            inches: unit > 1.0,
            unit,
        }
    }

    /// The move before the next segment, if there is one.
    pub(super) fn front(&self) -> Option<Shape> {
        self.front
    }

    /// Whether a move waits.
    pub(super) fn is_waiting(&self) -> bool {
        !self.entries.is_empty()
    }

    /// The next move begins at `start` [mm].
    pub(super) fn begin(&mut self, start: DVec2) {
        self.start = Some(start);
    }

    pub(super) fn push(&mut self, pending: Pending) {
        if self.entries.is_empty() {
            self.front = Some(pending.shape);
        }
        self.entries.push(Entry::Move(pending));
    }

    /// Words between two segments.
    pub(super) fn words(&mut self, event: &Event) {
        let EventKind::Words(words) = &event.kind else { return };
        let words = AuxiliaryWords {
            before: self.path.moves.len(),
            words: words.clone(),
            reset: None,
            origin: event.origin,
        };
        if self.entries.is_empty() {
            self.path.words.push(words);
        } else {
            self.entries.push(Entry::Words(words));
        }
    }

    /// Lets all that waits end at `end` [mm], and makes the moves.
    pub(super) fn end_at(&mut self, end: DVec2) -> Result<(), Refused> {
        if self.entries.is_empty() {
            return Ok(());
        }
        for entry in &mut self.entries {
            let Entry::Move(pending) = entry else { continue };
            match pending.shape {
                Shape::Line { along } => {
                    // What has exactly the width of the tool is cut short to nothing.
                    let backwards = |start| along.dot(end - start) < -SAME_LENGTH * along.length();
                    if self.start.is_some_and(backwards) {
                        return Err(TOO_SHORT);
                    }
                }
                Shape::Arc { center, clockwise, sweep, .. } => {
                    let change = center.distance(pending.to) - center.distance(end);
                    if change.abs() > MORE_RADIUS * self.unit {
                        return Err(TOO_SHORT);
                    }
                    let more = MORE_TURN[usize::from(self.inches)];
                    // Cut short to nothing it does not turn at all.
                    let turns = |start| swept(start - center, end - center, clockwise).abs();
                    let is_longer = |turns| turns > sweep.abs() + more && turns < TAU - SAME_PLACE;
                    if self.start.is_some_and(|start| is_longer(turns(start))) {
                        return Err(TOO_SHORT);
                    }
                }
            }
            pending.to = end;
        }
        self.release();
        self.start = Some(end);
        Ok(())
    }

    /// Makes the moves that wait, as they are.
    pub(super) fn release(&mut self) {
        self.start = None;
        for entry in std::mem::take(&mut self.entries) {
            match entry {
                Entry::Move(pending) => self.draw(&pending, pending.to + self.tip),
                Entry::Words(mut words) => {
                    words.before = self.path.moves.len();
                    self.path.words.push(words);
                }
            }
        }
    }

    /// The straight way off, to the programmed point itself [mm].
    pub(super) fn lead_out(&mut self, to: DVec2, attributes: Attributes) {
        let shape = Shape::Line { along: DVec2::ZERO };
        self.draw(&Pending { to, shape, attributes, role: Role::LeadOut }, to);
    }

    /// A spline as it is, at the height where it starts.
    pub(super) fn cubics(&mut self, pieces: &[Cubic], attributes: &Attributes) {
        let Attributes { origin, feed, rapid, plane, heights, .. } = *attributes;
        for piece in pieces {
            let (curve, role) = (MoveCurve::Cubic(*piece), Role::Segment);
            let heights = [heights[0]; 2];
            self.path.moves.push(Move { curve, role, rapid, feed, plane, heights, origin });
            self.pen = piece.end();
        }
    }

    /// Of an arc that ends where it begins the control makes a full circle: where a corner leaves nothing
    /// of it, and of the lead-in of a lathe tool, as the straight move before it already goes to its end.
    fn tell_circle(&mut self, attributes: &Attributes) {
        let message = "the control makes a full circle of this arc, as nothing is left of it";
        self.path.diagnostics.push(
            Diagnostic::warning("full-circle", message)
                .with_origin(attributes.origin)
                .with_point(self.pen)
                .with_hint("lead in with a straight move, or take a smaller tool"),
        );
    }

    fn draw(&mut self, pending: &Pending, to: DVec2) {
        let Pending { shape, mut attributes, role, .. } = *pending;
        let climbs = (attributes.heights[1] - attributes.heights[0]).abs() > MIN_LENGTH;
        let curve = match shape {
            Shape::Line { .. } => Line::new(self.pen, to).ok().map(MoveCurve::Line),
            Shape::Arc { center, clockwise, sweep, turns } => {
                let center = center + self.tip;
                let turned = swept(self.pen - center, to - center, clockwise).abs();
                self.full_circles(center, clockwise, turns, turned, role, &mut attributes);
                let is_circle = sweep.abs() > 0.999 * TAU;
                let is_point = self.pen.distance(to) < MIN_LENGTH;
                if is_point && !is_circle {
                    self.tell_circle(&attributes);
                }
                // A circle that ends a little behind its start goes round once more.
                let goes_round = (is_circle || is_point) && turned < SAME_PLACE;
                let to = if goes_round { self.pen } else { to };
                Arc::winding(self.pen, to, center, clockwise).ok().map(MoveCurve::Arc)
            }
        };
        let curve = curve.or(climbs.then_some(MoveCurve::Vertical(self.pen)));
        if let Some(curve) = curve {
            self.step(curve, role, attributes);
        }
    }

    /// The full circles of a helix before its last turn, whose angle is `turned` [rad]: each climbs its
    /// share, and what is left of that stays in the attributes.
    fn full_circles(
        &mut self,
        center: DVec2,
        clockwise: bool,
        turns: u32,
        turned: f64,
        role: Role,
        attributes: &mut Attributes,
    ) {
        let Ok(circle) = Arc::winding(self.pen, self.pen, center, clockwise) else { return };
        let [start, end] = attributes.heights;
        let climb = (end - start) / (f64::from(turns) + turned / TAU);
        for _ in 0..turns {
            let from = attributes.heights[0];
            let heights = [from, from + climb];
            self.step(MoveCurve::Arc(circle), role, Attributes { heights, ..*attributes });
            attributes.heights[0] = heights[1];
        }
    }

    fn step(&mut self, curve: MoveCurve, role: Role, attributes: Attributes) {
        let Attributes { origin, feed, rapid, plane, heights, .. } = attributes;
        self.path.moves.push(Move { curve, role, rapid, feed, plane, heights, origin });
        self.pen = curve.end();
    }
}

const TOO_SHORT: Refused = Refused(
    "corner-refused",
    "the move before the inside corner is too short for the tool, which would gouge",
);
