//! The move of one block: where to, along which curve.

use glam::DVec3;

use super::auxiliary::{append_word, take_as_text};
use super::axes::Axes;
use super::block::Block;
use super::g_words::Motion;
use super::interpret::{GEOMETRY, Interpreter, MINUTE};
use super::words::Words;
use crate::contour::Attributes;
use crate::diagnostic::Diagnostic;
use crate::geometry::MIN_LENGTH;

impl Interpreter {
    /// Moves as the axis words of the block ask for. `stated` tells whether the motion word itself
    /// is in the block.
    pub(super) fn motion(
        &mut self,
        block: &Block,
        motion: Motion,
        stated: bool,
        words: &mut Words,
    ) {
        if motion != Motion::Cubic {
            self.curves.chained = None;
        }
        match motion {
            Motion::NotSupported(what) => {
                if stated || words.has_any("XYZIJKRPQ") {
                    let column = words.unused().next().map_or(1, |(_, word)| word.column);
                    self.not_supported(block, column, what);
                    // It is missing, but what follows starts where it would have led.
                    if let Some((axes, to)) = self.target(block, words, "") {
                        self.arrive(&axes, to);
                    }
                    words.take_all(GEOMETRY);
                }
            }
            Motion::Rapid | Motion::Linear => {
                if let Some((axes, to)) = self.target(block, words, "") {
                    let attributes = self.attributes(block, motion == Motion::Rapid, to);
                    self.line(&axes, to, attributes);
                    self.arrive(&axes, to);
                } else {
                    self.rotary(block, motion, words);
                }
            }
            Motion::Arc { clockwise } => {
                if let Some((axes, to)) = self.target(block, words, "IJKR") {
                    self.arc(block, words, &axes, to, clockwise);
                    self.arrive(&axes, to);
                }
            }
            Motion::Involute { clockwise } => {
                if let Some((axes, to)) = self.target(block, words, "IJKR") {
                    self.involute(block, words, &axes, to, clockwise);
                    self.arrive(&axes, to);
                }
            }
            Motion::Cycle(number) => self.cycle(block, number, stated, words),
            Motion::TypePoints | Motion::Cubic => self.g05(block, words),
            Motion::Quadratic => {
                if words.has_any("XYZIJK") {
                    self.quadratic(block, words);
                }
            }
            Motion::Controls | Motion::Through | Motion::Knots | Motion::Named(_) => {
                self.spline_point(block, motion, stated, words);
            }
        }
    }

    /// What belongs to a move to `to` besides its curve.
    pub(super) fn attributes(&mut self, block: &Block, rapid: bool, to: DVec3) -> Attributes {
        let plane = self.modal.plane;
        let wish = self.wish(block, to);
        let (feed, time) = if rapid { (None, None) } else { self.feed_of_moves(block) };
        Attributes {
            origin: block.origin(),
            feed,
            time,
            rapid,
            plane,
            heights: [plane.split(self.modal.position).1, plane.split(to).1],
            wish,
        }
    }

    /// A straight move, or one along the normal of the plane, or none.
    pub(super) fn line(&mut self, axes: &Axes, to: DVec3, attributes: Attributes) {
        let (from, height) = attributes.plane.split(self.modal.position);
        let (end, end_height) = attributes.plane.split(to);
        let moves_in_plane = from.distance(end) >= MIN_LENGTH;
        let moves = moves_in_plane || height != end_height;
        if self.course.is_free() {
            self.state_axes(axes, to, moves, &attributes);
        } else if !moves {
            self.report.push(
                Diagnostic::info("zero-length", "the block leads to where the tool is already")
                    .with_origin(attributes.origin)
                    .with_point(end)
                    .with_hint("it is left out"),
            );
        }
        if moves_in_plane {
            self.course.line(from, end, attributes, &mut self.report);
        } else if moves || self.course.takes_any_lead() {
            self.course.vertical(from, attributes, &mut self.report);
        }
    }

    /// A block that moves other axes than x, y and z alone is passed on.
    fn rotary(&mut self, block: &Block, motion: Motion, words: &mut Words) {
        if !words.has_any("ABC") || !self.course.is_free() {
            return;
        }
        let rapid = motion == Motion::Rapid;
        let mut text = String::from(match (self.modal.relative, rapid) {
            (false, true) => "G0",
            (false, false) => "G1",
            (true, true) => "G91 G0",
            (true, false) => "G91 G1",
        });
        take_as_text(words, "ABC", &mut text);
        if !rapid && let (Some(feed), _) = self.feed_of_moves(block) {
            append_word(&mut text, 'F', feed * MINUTE);
        }
        self.course.words(text, block.origin());
        if self.modal.relative {
            self.course.words("G90".into(), block.origin());
        }
    }
}
