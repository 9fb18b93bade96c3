//! Axis words: where a block leads to, in program coordinates.

use glam::{DVec2, DVec3};

use super::auxiliary::append_word;
use super::block::{Block, Word};
use super::coordinates::AXES;
use super::frame::{polar_point, radians};
use super::interpret::{GEOMETRY, Interpreter, MINUTE};
use super::number::push_word;
use super::words::Words;
use crate::contour::{Attributes, Reset};
use crate::geometry::{MAX_COORDINATE, turn};

/// Coordinates nearer than this are one [mm]: what rounding leaves of turning there and back.
const SAME: f64 = 1e-9;

/// The words by which a block states x, y and z.
#[derive(Default)]
pub(super) struct Axes<'a> {
    pub(super) words: [Option<&'a Word>; 3],
}

impl Axes<'_> {
    fn first(&self) -> Option<&Word> {
        self.words.iter().flatten().min_by_key(|word| word.column).copied()
    }
}

impl Interpreter {
    /// The axis words, and where they lead to in program coordinates [mm]; `None` where there are
    /// none, nor one of `others`, or they lead too far out.
    pub(super) fn target<'a>(
        &mut self,
        block: &Block,
        words: &mut Words<'a>,
        others: &str,
    ) -> Option<(Axes<'a>, DVec3)> {
        let mut axes = Axes::default();
        let position = self.modal.position;
        let mut to = self.modal.frame.unmap(position);
        for (i, letter) in AXES.into_iter().enumerate() {
            axes.words[i] = words.take(letter);
        }
        self.polar(&mut axes, &mut to);
        self.polar_words(block, words, &mut axes, &mut to);
        self.about_pole(words, &mut axes, &mut to);
        let Some(first) = axes.first() else {
            return words.has_any(others).then_some((axes, position));
        };
        let mut to = self.modal.frame.map(to);
        for i in 0..3 {
            if (to[i] - position[i]).abs() < SAME {
                to[i] = position[i];
            }
        }
        if self.leads_too_far(block, first.column, to) {
            words.take_all(GEOMETRY);
            return None;
        }
        let unknown = (0..3).any(|i| axes.words[i].is_some() && !self.modal.stated[i]);
        if self.modal.relative && unknown {
            self.unknown_start(block, first.column);
            self.modal.stated = [true; 3];
        }
        Some((axes, to))
    }

    pub(super) fn unknown_start(&mut self, block: &Block, column: u32) {
        self.report.warning(
            "unknown-start",
            "incremental coordinates (G91) before the program says where the tool is",
            block.origin_at(column),
            "the start counts as zero; state it with G90 first",
        );
    }

    /// Moves `to` as the axis words say, in the plane by radius and angle under G16.
    fn polar(&mut self, axes: &mut Axes, to: &mut DVec3) {
        let relative = self.modal.relative;
        let plane = self.modal.plane;
        let [first, second, normal] = plane.axes();
        let from = plane.split(*to).0;
        for i in 0..3 {
            if let Some(word) = axes.words[i] {
                let value = self.modal.length_of(i, word.value);
                to[i] = if relative { to[i] + value } else { value };
            }
        }
        let (radius, turned) = (axes.words[first], axes.words[second]);
        let length = radius.map(|word| word.value * self.modal.unit());
        let Some(polar) = &mut self.modal.frame.polar else { return };
        if radius.is_none() && turned.is_none() {
            return;
        }
        if let Some(turned) = turned {
            let angle = radians(turned.value);
            polar.angle = if relative { polar.angle + angle } else { angle };
        }
        // An incremental radius counts from where the tool is.
        let pole = if relative && length.is_some() { from } else { polar.pole };
        let length = length.unwrap_or_else(|| from.distance(pole));
        *to = plane.place(polar_point(pole, length, polar.angle), to[normal]);
        axes.words[first] = radius.or(turned);
        axes.words[second] = turned.or(radius);
    }

    /// `@` and `^`: radius and angle in the plane of x and y, as `LinuxCNC` has them.
    fn polar_words<'a>(
        &mut self,
        block: &Block,
        words: &mut Words<'a>,
        axes: &mut Axes<'a>,
        to: &mut DVec3,
    ) {
        let (radius, turned) = (words.take('@'), words.take('^'));
        let Some(word) = radius.or(turned) else { return };
        let at = to.truncate();
        if axes.words[0].or(axes.words[1]).is_some() {
            self.error(
                "contradictory-words",
                "@ and ^ exclude X and Y",
                block.origin_at(word.column),
                "the polar words count",
            );
        }
        let angle = turn(DVec2::X, at);
        let (length, angle) = match (self.modal.relative, radius, turned) {
            (false, ..) => (
                radius.map_or(at.length(), |word| word.value * self.modal.unit()),
                turned.map_or(angle, |word| radians(word.value)),
            ),
            (true, ..) => (
                at.length() + radius.map_or(0.0, |word| word.value * self.modal.unit()),
                angle + turned.map_or(0.0, |word| radians(word.value)),
            ),
        };
        *to = polar_point(DVec2::ZERO, length, angle).extend(to.z);
        axes.words[0] = Some(word);
        axes.words[1] = Some(word);
    }

    /// Reports a point that is too far out.
    pub(super) fn leads_too_far(&mut self, block: &Block, column: u32, to: DVec3) -> bool {
        // A NaN is out of range too.
        let within = to.abs().max_element() <= MAX_COORDINATE && !to.is_nan();
        if !within {
            self.error(
                "out-of-range",
                "the block leads farther out than 1e7 mm",
                block.origin_at(column),
                "the block makes no move",
            );
        }
        !within
    }

    /// The tool is at `to` [mm], and the program has said so for these axes.
    pub(super) fn arrive(&mut self, axes: &Axes, to: DVec3) {
        for (i, word) in axes.words.into_iter().enumerate() {
            self.modal.stated[i] |= word.is_some();
            self.modal.restate[i] &= word.is_none();
        }
        self.modal.position = to;
    }

    /// Words for coordinates that are assumed already but were not stated: on the machine the tool
    /// may be elsewhere.
    pub(super) fn state_axes(
        &mut self,
        axes: &Axes,
        to: DVec3,
        moves: bool,
        attributes: &Attributes,
    ) {
        let (mut text, mut states) = (String::new(), [false; 3]);
        if self.modal.relative && self.course.is_beside {
            let reset = Reset { at: self.modal.position, states, moves: 0 };
            return self.course.reset(text, attributes.origin, reset);
        }
        for i in 0..3 {
            let known = self.modal.stated[i] && !self.modal.restate[i];
            if axes.words[i].is_none() || known || self.modal.position[i] != to[i] {
                continue;
            }
            states[i] = true;
            text.push_str(match (text.is_empty(), attributes.rapid) {
                (true, true) => "G0 ",
                (true, false) => "G1 ",
                (false, _) => " ",
            });
            push_word(&mut text, AXES[i], to[i]);
        }
        if text.is_empty() {
            return;
        }
        if moves {
            let reset = Reset { at: self.modal.position, states, moves: 0 };
            self.course.reset(String::new(), attributes.origin, reset);
            return;
        }
        if let Some(feed) = attributes.feed {
            append_word(&mut text, 'F', feed * MINUTE);
        }
        self.course.words(text, attributes.origin);
    }
}
