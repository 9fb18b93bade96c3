//! Roundings and chamfers in the place of a corner: `,R` and `,C` of FANUC, RND, RNDM, CHF, CHR, FRC
//! and FRCM of SINUMERIK.
//!
//! A corner waits at the end of its first move, which the course has already. The next move cuts
//! it: the first one is shortened where it stands, and the element comes behind it, before the
//! words in between; what is compensated is the contour with the element in it.
//!
//! What stands in the manuals of FANUC's series 0i to 30i, and of NCT, whose words are the same: both
//! moves are G01 to G03 in the plane and follow each other, but for G04; what does not fit is an
//! alarm; legs at an arc are chords. Of SINUMERIK's 802D and 840D: up to three blocks without a
//! move may lie between; what does not fit is made smaller; the feed is that of the second move;
//! RND comes before CHF and CHR.

use glam::DVec2;

use super::block::Block;
use super::course::{Course, State};
use super::dialect::Dialect;
use super::interpret::Interpreter;
use super::items::{ContourStart, Item};
use super::lexer::LineReader;
use super::report::Report;
use super::rules::ControlWords;
use super::words::Words;
use crate::contour::{Attributes, Shape};
use crate::diagnostic::{Diagnostic, Origin, Severity};
use crate::geometry::{
    CornerCut, CornerMeasure, CornerSize, Curve, Decimal, MIN_LENGTH, cut_corner,
};

/// Most blocks from the first move of a SINUMERIK corner to the second: three without a move.
const MOST_BLOCKS: u32 = 4;

/// Halvings of what is taken off an element that does not fit: to a millionth of it.
const HALVINGS: u32 = 20;

/// The smallest element that one is made to fit by [mm]: the last digit of most controls.
const LEAST: f64 = 1e-3;

/// What a block asks of the corner at its end.
#[derive(Debug, Clone, Copy)]
pub(super) struct CornerWord {
    size: CornerSize,
    /// The feed in the element [mm/s], where it has its own.
    feed: Option<f64>,
    origin: Origin,
    /// SINUMERIK makes smaller what does not fit, and goes on where there is nothing to cut.
    yields: bool,
    /// RNDM: not all corners that it is for can be cut.
    is_modal: bool,
}

/// Why a corner is left where it is not between two moves as it has to be.
const ALONE: &str = "the corner is not between moves by G01 to G03 of one contour in one plane";

impl CornerWord {
    /// Tells that the corner stays as it is, and why.
    fn left_out(&self, why: &'static str, report: &mut Report) {
        if self.is_modal {
            return;
        }
        let mut found = Diagnostic::error("corner-left", why);
        if self.yields {
            found.severity = Severity::Warning;
        }
        report.push(found.with_origin(self.origin).with_hint("it stays sharp"));
    }
}

/// A corner at the end of a move that is made.
#[derive(Debug)]
pub(super) struct PendingCorner {
    word: CornerWord,
    curve: Curve,
    attributes: Attributes,
    /// How many items there were with its first move, or segments where that is one.
    count: usize,
    /// Blocks read since, the one that closes it included.
    blocks: u32,
}

impl LineReader<'_> {
    /// FANUC's words for corners and for the angle of a line, with a small letter.
    pub(super) fn comma_word(&mut self) -> bool {
        let from = self.cursor.at();
        self.cursor.skip();
        if matches!(self.dialect, Dialect::Auto | Dialect::Fanuc)
            && !self.interpreter.rules.is_strict
            && let Some(letter @ (b'A' | b'C' | b'R')) = self.cursor.peek()
        {
            self.word(letter.to_ascii_lowercase());
            return true;
        }
        self.cursor.set(from);
        false
    }
}

impl Interpreter {
    /// Keeps what the words of a block ask of the corner at the end of its move.
    pub(super) fn ask_of_corner(&mut self, block: &Block, words: &mut Words) {
        let yields = self.dialect == Dialect::Sinumerik;
        let unit = self.modal.unit();
        let mut asked = None;
        for (letter, measure) in MEASURES {
            let Some(word) = words.take(letter) else { continue };
            if word.value < 0.0 || asked.is_some() && !yields {
                let message = "a corner has one rounding or chamfer of a positive size";
                self.error("bad-corner", message, block.origin_at(word.column), "it is left out");
            } else if asked.is_none() {
                asked = Some((CornerSize { measure, value: word.value * unit }, word.column));
            }
        }
        let is_modal = asked.is_none();
        let rounding =
            CornerSize { measure: CornerMeasure::Radius, value: self.modal.wishes.rounding };
        let (mut size, column) = asked.unwrap_or((rounding, 1));
        let feed = words.take('g').map_or(self.modal.wishes.feed, |word| word.value * unit);
        if size.value > 0.0 {
            let feed = if feed > 0.0 { self.modal.feed.meant_by(feed) } else { None };
            let factor = self.modal.frame.factor(self.modal.plane);
            size.value *= factor.unwrap_or(1.0);
            let origin = block.origin_at(column);
            let word = CornerWord { size, feed, origin, yields, is_modal };
            if factor.is_some() {
                self.course.asked = Some(word);
            } else {
                word.left_out(
                    "scaling makes the rounding or chamfer another curve",
                    &mut self.report,
                );
            }
        }
    }
}

/// The letters of sizes; the first counts.
const MEASURES: [(char, CornerMeasure); 3] =
    [('r', CornerMeasure::Radius), ('c', CornerMeasure::Legs), ('f', CornerMeasure::Length)];

impl Course {
    /// Counts a block since the corner that waits, unless it is a dwell or has comments only.
    pub(super) fn passes_block(&mut self, block: &Block) {
        if let Some(corner) = &mut self.corner
            && !block.words.is_empty()
            && !block.words.iter().any(|word| word.letter == 'G' && word.value == 4.0)
        {
            corner.blocks += 1;
        }
    }

    /// The corner that waits stays as it is: nothing in the plane follows.
    pub(super) fn leave_corner(&mut self, report: &mut Report) {
        if let Some(corner) = self.corner.take() {
            corner.word.left_out(ALONE, report);
        }
    }

    /// The corner that is asked for stays as it is: no move leads to it.
    pub(super) fn leave_asked(&mut self, report: &mut Report) {
        if let Some(word) = self.asked.take() {
            word.left_out(ALONE, report);
        }
    }

    /// A move that ends in a corner to be cut, before it is made.
    pub(super) fn ends_in_corner(
        &mut self,
        from: DVec2,
        shape: &Shape,
        attributes: &Attributes,
    ) -> Option<Box<PendingCorner>> {
        let word = self.asked.take()?;
        let curve = self.line_or_arc(from, shape)?;
        let attributes = *attributes;
        Some(Box::new(PendingCorner { word, curve, attributes, count: 0, blocks: 0 }))
    }

    /// The move was made: its corner waits for the next one.
    pub(super) fn wait_in_corner(
        &mut self,
        corner: Option<Box<PendingCorner>>,
        report: &mut Report,
    ) {
        self.corner = corner;
        let Some(corner) = &mut self.corner else { return };
        corner.count = match &self.state {
            // On a move over which the radius changes there are two contours.
            State::On(open) if open.begins != ContourStart::Tapers || open.builder.len() > 1 => {
                open.builder.len()
            }
            State::Off if matches!(self.items.last(), Some(Item::Free(_))) => self.items.len(),
            _ => return self.leave_corner(report),
        };
    }

    /// A line or an arc, where the move is one.
    fn line_or_arc(&self, from: DVec2, shape: &Shape) -> Option<Curve> {
        match shape {
            Shape::Spline(_) | Shape::Bezier { .. } | Shape::Involute { .. } => None,
            _ => shape.curve(from, self.rules.any_lead.then_some(f64::INFINITY)).ok(),
        }
    }

    /// The second move of the corner that waits, where it is one.
    fn second_of(
        &self,
        corner: &PendingCorner,
        from: DVec2,
        shape: &Shape,
        attributes: &Attributes,
    ) -> Option<Curve> {
        let PendingCorner { word, curve, attributes: first, count, .. } = corner;
        let [start, end] = first.heights;
        let in_plane = start == end
            && attributes.heights == first.heights
            && attributes.plane == first.plane
            && from.distance(curve.end()) < MIN_LENGTH;
        let bevels = word.yields && word.size.measure != CornerMeasure::Radius;
        let rapid = first.rapid || attributes.rapid;
        // FANUC's alarm 39 is for corners where compensation begins or ends.
        let alarms = !word.yields && self.rules.words == ControlWords::Fanuc;
        let is_last = match &self.state {
            State::On(open) | State::Ending(open) => {
                let leads = *count == 0 || matches!(self.state, State::Ending(_));
                open.builder.len() == *count
                    && (*count > 0 || open.lead_in.is_some())
                    && !(leads && alarms)
            }
            State::Off | State::Waiting(_) => {
                let leads = matches!(self.state, State::Waiting(_));
                let since = self.items.get(*count..).unwrap_or_default();
                let only_words = |item: &Item| match item {
                    Item::Words { reset: None, .. } => true,
                    Item::Words { words, reset: Some(reset), .. } => {
                        words.is_empty() && reset.moves == 0
                    }
                    _ => false,
                };
                *count > 0 && since.iter().all(only_words) && !(leads && alarms)
            }
        };
        let may_be = in_plane && (!rapid || bevels) && is_last;
        if may_be { self.line_or_arc(from, shape) } else { None }
    }

    /// Cuts the corner that waits before a move: shortens both, and makes what is between them. False
    /// where nothing of the second is left.
    pub(super) fn cut_corner(
        &mut self,
        from: &mut DVec2,
        shape: &mut Shape,
        attributes: &mut Attributes,
        report: &mut Report,
    ) -> bool {
        let Some(mut corner) = self.corner.take() else { return true };
        let word = corner.word;
        let Some(second) = self.second_of(&corner, *from, shape, attributes) else {
            word.left_out(ALONE, report);
            return true;
        };
        if corner.blocks > if word.yields { MOST_BLOCKS } else { 1 } {
            word.left_out("a block without a move is between both moves of the corner", report);
            return true;
        }
        // A lead keeps its direction, and a move what its next corner takes.
        let leads = matches!(self.state, State::Waiting(_) | State::Ending(_));
        let keeps = [corner.count == 0, leads || self.asked.is_some()];
        let (mut size, mut step, mut cut) = (word.size, word.size.value, None);
        // What is asked for comes first.
        for _ in 0..if word.yields { HALVINGS } else { 1 } {
            step *= 0.5;
            match cut_corner(&corner.curve, &second, size) {
                CornerCut::Tangent => return true,
                CornerCut::Made { ends, center, clockwise, rest }
                    if (rest[0] > 0.0 || !keeps[0])
                        && (rest[1] > 0.0 || !keeps[1])
                        && size.value >= LEAST.min(word.size.value) =>
                {
                    cut = Some((ends, center, clockwise, rest, size.value));
                    if size == word.size {
                        break;
                    }
                    size.value += step;
                }
                _ => size.value -= step,
            }
        }
        let Some(([start, end], center, clockwise, rest, value)) = cut else {
            word.left_out("the rounding or chamfer is too large for its moves", report);
            return true;
        };
        if value < word.size.value {
            let message = format!("the corner is cut by {} mm only", Decimal::of(value));
            report.warning("corner-reduced", message, word.origin, "more does not fit");
        }
        let first = &mut corner.attributes;
        let (like, along) =
            if word.yields { (&*attributes, &second) } else { (&*first, &corner.curve) };
        let mut feed = like.time.map_or(like.feed, |time| Some(along.length() / time));
        if !attributes.rapid {
            feed = word.feed.or(feed);
        }
        let (rapid, wish) = (attributes.rapid, attributes.wish);
        let made = Attributes { feed, time: None, rapid, wish, ..*first };
        let element = match center {
            Some(center) => Shape::Arc { to: end, center, clockwise },
            None => Shape::Line { to: end },
        };
        first.time = first.time.map(|time| time * rest[0] / corner.curve.length());
        attributes.time = attributes.time.map(|time| time * rest[1] / second.length());
        *from = end;
        if let Some(to) = shape.end() {
            *shape = ending_at(&second, to);
        }
        self.shorten(&corner, (rest[0] > 0.0).then_some(start), element, made, report);
        rest[1] > 0.0
    }

    /// Lets the first move of a corner end at `to`, or leaves it out, and puts the element behind it.
    fn shorten(
        &mut self,
        corner: &PendingCorner,
        to: Option<DVec2>,
        element: Shape,
        made: Attributes,
        report: &mut Report,
    ) {
        let PendingCorner { curve, attributes, count, .. } = corner;
        let at = to.unwrap_or(curve.start());
        if let State::On(open) | State::Ending(open) = &mut self.state {
            if *count == 0 {
                open.start = at;
                open.builder.move_start(at);
                if let Some(lead) = &mut open.lead_in {
                    lead.attributes = *attributes;
                    open.builder.lead_in(*lead);
                }
            } else if let Some(last) = open.builder.last_mut() {
                if to.is_none() {
                    *last = (element, made);
                    return;
                }
                *last = (ending_at(curve, at), *attributes);
            }
            open.builder.insert(element, made);
            return;
        }
        let mut words = self.items.split_off(*count);
        let exit = element.end().unwrap_or(at);
        for item in &mut words {
            if let Item::Words { reset: Some(reset), .. } = item {
                reset.at = made.plane.place(exit, made.heights[1]);
            }
        }
        self.items.pop();
        if to.is_some() {
            self.free_curve(curve.start(), ending_at(curve, at), *attributes, report);
        }
        self.free_curve(at, element, made, report);
        self.items.append(&mut words);
    }
}

/// A line or an arc as it is described, with another end on it.
fn ending_at(curve: &Curve, to: DVec2) -> Shape {
    match curve {
        Curve::Arc(arc) => Shape::Arc { to, center: arc.center(), clockwise: arc.is_clockwise() },
        _ => Shape::Line { to },
    }
}
