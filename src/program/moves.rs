//! The move of one block: where to, along which curve.

use glam::{DVec2, DVec3};

use super::block::{Block, Word};
use super::g_words::Motion;
use super::interpret::{GEOMETRY, Interpreter, MINUTE};
use super::number::push_word;
use super::type_points::{Added, PendingSpline, SplineWord, spline_word};
use super::words::Words;
use crate::contour::{Attributes, Plane, Shape};
use crate::diagnostic::Diagnostic;
use crate::geometry::{MAX_COORDINATE, MIN_LENGTH, RadiusForm};

/// The axis words of a block.
#[derive(Default)]
struct Axes<'a> {
    words: [Option<&'a Word>; 3],
}

impl Axes<'_> {
    fn first(&self) -> Option<&Word> {
        self.words.iter().flatten().min_by_key(|word| word.column).copied()
    }
}

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
        match motion {
            Motion::NotSupported(what) => {
                if stated || words.has_any("XYZIJKRPQ") {
                    let column = words.unused().next().map_or(1, |(_, word)| word.column);
                    self.not_supported(block, column, what);
                    // It is missing, but what follows starts where it would have led.
                    if let Some((mut axes, to)) = self.target(block, words) {
                        axes.words[2] = None;
                        self.arrive(&axes, to.truncate().extend(self.modal.position.z));
                    }
                    words.take_all(GEOMETRY);
                }
            }
            Motion::Rapid | Motion::Linear => {
                if let Some((axes, to)) = self.target(block, words) {
                    let attributes = self.attributes(block, motion, to);
                    self.line(&axes, to, attributes);
                    self.arrive(&axes, to);
                }
            }
            Motion::Arc { clockwise } => {
                if words.has_any("XYZIJ")
                    && let Some((axes, to)) = self.target(block, words)
                {
                    self.arc(block, words, &axes, to, clockwise);
                    self.arrive(&axes, to);
                }
            }
            Motion::TypePoints => {
                if !words.has_any("XYZ") {
                    return;
                }
                if let SplineWord::NotSupported(what) = spline_word(50, words) {
                    self.modal.motion = Some(Motion::NotSupported(what));
                    self.finish_spline();
                    self.motion(block, Motion::NotSupported(what), true, words);
                } else if let Some((axes, to)) = self.target(block, words) {
                    self.type_point(block, &axes, to);
                }
            }
        }
    }

    /// The axis words, and where they lead to [mm]; `None` where there are none or they lead too
    /// far out.
    fn target<'a>(&mut self, block: &Block, words: &mut Words<'a>) -> Option<(Axes<'a>, DVec3)> {
        let mut axes = Axes::default();
        let mut to = self.modal.position;
        for (i, letter) in ['X', 'Y', 'Z'].into_iter().enumerate() {
            if let Some(word) = words.take(letter) {
                axes.words[i] = Some(word);
                to[i] = self.modal.coordinate(word.value, to[i]);
            }
        }
        let first = axes.first();
        if first.is_none() && !words.has_any("IJ") {
            return None;
        }
        let column = first.map_or(1, |word| word.column);
        if to.abs().max_element() > MAX_COORDINATE {
            self.error(
                "out-of-range",
                "the block leads farther out than 1e7 mm",
                block.origin_at(column),
                "the block makes no move",
            );
            words.take_all(GEOMETRY);
            return None;
        }
        let unknown = (0..3).any(|i| axes.words[i].is_some() && !self.modal.stated[i]);
        if self.modal.relative && unknown {
            self.report.warning(
                "unknown-start",
                "incremental coordinates (G91) before the program says where the tool is",
                block.origin_at(column),
                "the start counts as zero; state it with G90 first",
            );
            self.modal.stated = [true; 3];
        }
        Some((axes, to))
    }

    /// What belongs to a move to `to` besides its curve.
    fn attributes(&self, block: &Block, motion: Motion, to: DVec3) -> Attributes {
        let rapid = motion == Motion::Rapid;
        Attributes {
            origin: block.origin(),
            feed: if rapid { None } else { self.modal.feed },
            time: None,
            rapid,
            plane: Plane::Xy,
            heights: [self.modal.position.z, to.z],
        }
    }

    fn arrive(&mut self, axes: &Axes, to: DVec3) {
        for (stated, word) in self.modal.stated.iter_mut().zip(axes.words) {
            *stated |= word.is_some();
        }
        self.modal.position = to;
    }

    /// A straight move, or one along z, or none.
    fn line(&mut self, axes: &Axes, to: DVec3, attributes: Attributes) {
        let from = self.modal.position;
        let moves_in_plane = from.truncate().distance(to.truncate()) >= MIN_LENGTH;
        if moves_in_plane {
            self.course.line(from.truncate(), to.truncate(), attributes, &mut self.report);
        } else if from.z != to.z || self.course.takes_any_lead() {
            self.course.vertical(from.truncate(), attributes, &mut self.report);
        }
        if self.course.is_free() {
            self.first_positions(axes, to, moves_in_plane, &attributes);
        } else if !moves_in_plane && from.z == to.z {
            self.report.push(
                Diagnostic::info("zero-length", "the block leads to where the tool is already")
                    .with_origin(attributes.origin)
                    .with_point(to.truncate())
                    .with_hint("it is left out"),
            );
        }
    }

    /// Words for coordinates that are assumed already but were never stated: on the machine the
    /// tool may be elsewhere.
    fn first_positions(
        &mut self,
        axes: &Axes,
        to: DVec3,
        moves_in_plane: bool,
        attributes: &Attributes,
    ) {
        let mut text = String::new();
        for (i, letter) in ['X', 'Y', 'Z'].into_iter().enumerate() {
            let by_the_move = if i < 2 { moves_in_plane } else { to.z != self.modal.position.z };
            if axes.words[i].is_some() && !self.modal.stated[i] && !by_the_move {
                text.push_str(match (text.is_empty(), attributes.rapid) {
                    (true, true) => "G0 ",
                    (true, false) => "G1 ",
                    (false, _) => " ",
                });
                push_word(&mut text, letter, to[i]);
            }
        }
        if !text.is_empty() {
            if let Some(feed) = attributes.feed {
                text.push(' ');
                push_word(&mut text, 'F', feed * MINUTE);
            }
            self.course.words(text, attributes.origin);
        }
    }

    /// G02 and G03.
    fn arc(&mut self, block: &Block, words: &mut Words, axes: &Axes, to: DVec3, clockwise: bool) {
        let attributes = self.attributes(block, Motion::Arc { clockwise }, to);
        let (from, end) = (self.modal.position.truncate(), to.truncate());
        match self.arc_shape(block, words, from, end, clockwise) {
            Some(shape) => self.course.curve(from, shape, attributes, &mut self.report),
            None => self.line(axes, to, attributes),
        }
    }

    /// The arc as described, `None` where a straight move has to stand in its place.
    fn arc_shape(
        &mut self,
        block: &Block,
        words: &mut Words,
        from: DVec2,
        to: DVec2,
        clockwise: bool,
    ) -> Option<Shape> {
        let [i, j, k, radius, turns] = ['I', 'J', 'K', 'R', 'P'].map(|letter| words.take(letter));
        if let Some(plane) = self.modal.other_plane {
            let message = format!("an arc in the plane {plane} is not supported");
            let hint = "a straight line stands in its place";
            self.error("not-supported", message, block.origin(), hint);
            return None;
        }
        if let Some(k) = k {
            self.error(
                "contradictory-words",
                "K belongs to the planes G18 and G19",
                block.origin_at(k.column),
                "in the plane G17 the centre is I J",
            );
        }
        if let Some(turns) = turns.filter(|turns| turns.value != 1.0) {
            self.not_supported(block, turns.column, "an arc of several turns (P)");
        }
        let unit = self.modal.unit();
        if let Some(radius) = radius {
            if let Some(center) = i.or(j) {
                self.error(
                    "contradictory-words",
                    "the arc has a radius and a centre",
                    block.origin_at(center.column),
                    "the radius counts; leave out R, or I and J",
                );
            }
            let form = if radius.value < 0.0 { RadiusForm::Major } else { RadiusForm::Minor };
            let radius = radius.value.abs() * unit;
            return Some(Shape::ArcByRadius { to, radius, form, clockwise });
        }
        if i.is_none() && j.is_none() {
            self.error(
                "arc-without-centre",
                "the arc has neither centre nor radius",
                block.origin(),
                "add I and J, or R; a straight line stands in its place",
            );
            return None;
        }
        if self.modal.absolute_center && (i.is_none() || j.is_none()) {
            self.error(
                "arc-without-centre",
                "an absolute centre (G90.1) needs both I and J",
                block.origin(),
                "the missing one is taken from the arc's start",
            );
        }
        let coordinate = |word: Option<&Word>, start: f64| match word {
            Some(word) if self.modal.absolute_center => word.value * unit,
            Some(word) => start + word.value * unit,
            None => start,
        };
        let center = DVec2::new(coordinate(i, from.x), coordinate(j, from.y));
        Some(Shape::Arc { to, center, clockwise })
    }

    /// G05 with axes alone.
    fn type_point(&mut self, block: &Block, axes: &Axes, to: DVec3) {
        if let Some(z) = axes.words[2]
            && to.z != self.modal.position.z
        {
            self.error(
                "z-in-spline",
                "a spline through type points has one height",
                block.origin_at(z.column),
                "the Z word has no effect; move along z before or after the spline",
            );
        }
        if axes.words[0].is_none() && axes.words[1].is_none() {
            return;
        }
        let from = self.modal.position.truncate();
        let to = to.truncate().extend(self.modal.position.z);
        if let Some(plane) = self.modal.other_plane {
            self.not_supported(block, 1, &format!("a spline in the plane {plane}"));
            let attributes = self.attributes(block, Motion::Linear, to);
            self.line(axes, to, attributes);
            self.arrive(axes, to);
            return;
        }
        let attributes = self.attributes(block, Motion::TypePoints, to);
        let spline = self.spline.get_or_insert_with(|| PendingSpline::new(from, attributes));
        let feed = spline.feed();
        let added = spline.add(to.truncate(), attributes);
        match added {
            Added::Point if feed.is_some() && feed != attributes.feed => self.report.warning("feed-in-spline", "the feed changes within a spline", block.origin(), "the spline runs at the feed of its first block; end it with a repeated point to change the feed"),
            Added::Point | Added::Repeated => {}
            Added::Corner(ended) => {
                if let Some((start, shape, attributes)) = ended.finish() {
                    self.course.curve(start, shape, attributes, &mut self.report);
                }
                self.release_words(false);
            }
        }
        self.release_words(true);
        self.arrive(axes, to);
    }
}
