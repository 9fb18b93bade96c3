//! The move of one block: where to, along which curve.

use glam::DVec3;

use super::axes::Axes;
use super::block::Block;
use super::g_words::Motion;
use super::interpret::{GEOMETRY, Interpreter};
use super::open::placed;
use super::words::Words;
use crate::contour::Attributes;
use crate::diagnostic::Severity;
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
        if self.rules.is_strict && !self.has_its_words(block, motion, stated, words) {
            return;
        }
        if matches!(motion, Motion::Arc { .. } | Motion::Cycle(_)) {
            let (others, _) = self.other_axes(block, words);
            self.pass_on(others, false, block.origin());
        }
        if matches!(
            motion,
            Motion::Rapid | Motion::Linear | Motion::Arc { .. } | Motion::Tangent | Motion::ByPoint
        ) {
            self.ask_of_corner(block, words);
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
                self.straight(block, motion == Motion::Rapid, stated, words);
            }
            Motion::Passed(tenths) => self.passed_move(block, tenths, words),
            Motion::Arc { clockwise } => self.arc(block, words, clockwise, false),
            Motion::Tangent | Motion::ByPoint => {
                self.arc_by_point(block, words, motion == Motion::ByPoint);
            }
            Motion::Involute { clockwise } => self.arc(block, words, clockwise, true),
            Motion::Cycle(number) => self.cycle(block, number, words),
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
        self.course.leave_asked(&mut self.report);
    }

    /// G00 and G01: the axes of the plane and the others, or the word alone.
    fn straight(&mut self, block: &Block, rapid: bool, stated: bool, words: &mut Words) {
        let (others, way) = self.other_axes(block, words);
        let target = self.target(block, words, "");
        // It stays where it is, and needs not even say so.
        let stays = target.as_ref().is_none_or(|(axes, to)| {
            let stated = self.modal.stated;
            let known = (0..3).all(|i| axes.words[i].is_none() || stated[i]);
            *to == self.modal.position && (known || !self.course.is_free())
        });
        if stays && !others.is_empty() {
            self.turn_others(block, rapid, &others, way);
        } else if !others.is_empty() {
            self.course.words(others, block.origin());
        }
        if let Some((axes, to)) = target {
            let attributes = self.attributes(block, rapid, to);
            self.line(&axes, to, attributes);
            self.arrive(&axes, to);
        } else if stated && self.course.takes_any_lead() {
            // The word alone leads to where the program is.
            let at = self.modal.position;
            let attributes = self.attributes(block, rapid, at);
            let from = attributes.plane.split(at).0;
            self.course.vertical(from, attributes, &mut self.report);
        }
    }

    /// Whether a control that is strict makes the move of a block: not without axes, and of some modes
    /// not without the word.
    fn has_its_words(
        &mut self,
        block: &Block,
        motion: Motion,
        stated: bool,
        words: &Words,
    ) -> bool {
        let others = words.has_any("ABCUVW");
        if others && matches!(motion, Motion::Cycle(_)) {
            self.refuse("in a cycle no other axis moves", block.start());
        }
        if stated && motion == Motion::Linear {
            // It asks for a feed even where it leads nowhere.
            self.feed_of_moves(block);
        }
        if matches!(motion, Motion::Rapid | Motion::Linear | Motion::Controls) {
            return !self.is_refused;
        }
        let arc = matches!(motion, Motion::Arc { .. });
        if arc && others && !words.has_any("IJKR") {
            self.error(
                "arc-without-centre",
                "the arc has neither centre nor radius",
                block.start(),
                "",
            );
        }
        if others || words.has_any("XYZ@^") || arc && words.has_any("IJK") {
            return !self.is_refused;
        }
        if stated {
            self.error("missing-axes", "the motion word has no axes", block.start(), "");
        }
        false
    }

    /// What belongs to a move to `to` besides its curve.
    pub(super) fn attributes(&mut self, block: &Block, rapid: bool, to: DVec3) -> Attributes {
        let plane = self.modal.plane;
        self.course.unit = self.modal.unit();
        let wish = self.wish(block, to);
        self.course.column(block, self.spline.is_none());
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
        let leads = self.course.takes_any_lead();
        if self.course.is_free() {
            self.state_axes(axes, to, moves || leads, &attributes);
        } else if !moves {
            let message = "the block leads to where the tool is already";
            let (code, origin, hint) = ("zero-length", attributes.origin, "it is left out");
            self.report.push(placed(Severity::Info, code, message, origin, end, hint));
        }
        if moves_in_plane {
            self.course.line(from, end, attributes, &mut self.report);
        } else if moves || leads {
            self.course.vertical(from, attributes, &mut self.report);
        }
    }
}
