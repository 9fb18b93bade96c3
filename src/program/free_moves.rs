//! Moves without compensation, as items of a program, and how the tool comes back from beside a contour.

use glam::DVec2;

use super::block::Block;
use super::course::{Course, State};
use super::interpret::MINUTE;
use super::items::{ContourEnd, Item};
use super::open::builder_at;
use super::report::Report;
use crate::contour::{Attributes, EventKind, Move, MoveCurve, Role, Shape};
use crate::diagnostic::{Diagnostic, Origin};
use crate::geometry::{Curve, Line};

impl Course {
    /// Keeps where a block begins that a contour is made of, or a free curve.
    pub(super) fn column(&mut self, block: &Block, is_first: bool) {
        if is_first && self.is_free() {
            self.columns.clear();
        }
        self.columns.push((block.line, block.words.first().map_or(1, |word| word.column)));
    }

    /// Reports what was found when a contour was built of its blocks, with the column of its block.
    pub(super) fn found(&self, mut found: Diagnostic, report: &mut Report) {
        if let Some(Origin::Block { line, column: column @ None, .. }) = &mut found.origin {
            // In order, but for loops.
            let first = self.columns.partition_point(|(other, _)| other < line);
            let known = self.columns.get(first).filter(|(other, _)| other == line);
            *column = known.map(|(_, column)| *column);
        }
        report.push(found);
    }

    /// Whether a move without way in the plane is nevertheless one that leads in or out.
    pub(super) fn takes_any_lead(&self) -> bool {
        self.rules.any_lead
            && match self.state {
                State::Off => self.needs_a_line || self.is_beside,
                State::Waiting(_) | State::Ending(_) => true,
                State::On(_) => false,
            }
    }

    /// The tool changes: after G40 a control that looks ahead takes where it is for where the program is.
    pub(super) fn change_tool(&mut self, report: &mut Report) {
        if self.rules.any_lead {
            self.end_without_line(ContourEnd::Beside, report);
        }
    }

    /// Ends a contour that is switched off, where no straight move leads out of it.
    pub(super) fn end_without_line(&mut self, end: ContourEnd, report: &mut Report) {
        match std::mem::replace(&mut self.state, State::Off) {
            State::Ending(open) => {
                self.close(open, None, end, report);
                self.needs_a_line = self.rules.any_lead;
            }
            state => self.state = state,
        }
    }

    /// A move along the normal of the plane at `at` [mm].
    pub(super) fn vertical(&mut self, at: DVec2, attributes: Attributes, report: &mut Report) {
        self.leave_corner(report);
        let is_off = matches!(self.state, State::Off);
        if !is_off && self.takes_any_lead() {
            self.line(at, at, attributes, report);
            return;
        }
        // It leads back to where the program is.
        self.needs_a_line &= !is_off;
        match &mut self.state {
            State::Off | State::Waiting(_) => self.free(MoveCurve::Vertical(at), &attributes),
            State::On(open) | State::Ending(open) => {
                open.event(EventKind::Vertical(attributes), attributes.origin);
            }
        }
    }

    pub(super) fn free_line(&mut self, from: DVec2, to: DVec2, attributes: &Attributes) {
        if let Ok(line) = Line::new(from, to) {
            self.free(MoveCurve::Line(line), attributes);
        }
    }

    /// The moves of one free curve, made as a contour of its own.
    pub(super) fn free_curve(
        &mut self,
        from: DVec2,
        shape: Shape,
        attributes: Attributes,
        report: &mut Report,
    ) {
        let mut builder = builder_at(from, self.rules);
        builder.segment(shape, attributes);
        let built = builder.build(false);
        // Why there is no segment is said by the diagnostic before.
        for found in built.diagnostics {
            if found.code != "empty-contour" {
                self.found(found, report);
            }
        }
        let Some(contour) = built.contour else { return };
        let mut attributes = attributes;
        if let Some(time) = attributes.time.take() {
            let mut length = 0.0;
            for segment in contour.segments() {
                length += segment.curve.length();
            }
            attributes.feed = Some(self.timed(length, &attributes, time));
        }
        for segment in contour.segments() {
            match &segment.curve {
                Curve::Line(line) => self.free(MoveCurve::Line(*line), &attributes),
                Curve::Arc(arc) => self.free(MoveCurve::Arc(*arc), &attributes),
                Curve::Involute(involute) => {
                    self.free(MoveCurve::Involute(*involute), &attributes);
                }
                Curve::Spline(spline) => {
                    for cubic in spline.pieces() {
                        self.free(MoveCurve::Cubic(*cubic), &attributes);
                    }
                }
            }
        }
    }

    /// The feed of a move that is so long in its plane [mm] and takes so long [s]; some controls are
    /// never slower than 0.1 units a minute.
    fn timed(&self, length: f64, attributes: &Attributes, time: f64) -> f64 {
        let [start, end] = attributes.heights;
        let least = if self.rules.any_lead { 0.1 * self.unit / MINUTE } else { 0.0 };
        (length.hypot(end - start) / time).max(least)
    }

    pub(super) fn free(&mut self, curve: MoveCurve, attributes: &Attributes) {
        let feed = match attributes.time {
            Some(time) => Some(self.timed(curve.length(), attributes, time)),
            None => attributes.feed,
        };
        self.items.push(Item::Free(Move {
            curve,
            role: Role::Free,
            rapid: attributes.rapid,
            feed,
            plane: attributes.plane,
            heights: attributes.heights,
            origin: attributes.origin,
        }));
    }
}
