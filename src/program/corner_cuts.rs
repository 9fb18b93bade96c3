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
use super::open::builder_at;
use super::report::Report;
use super::rules::{ControlWords, Rules};
use super::words::Words;
use crate::contour::{Attributes, MoveCurve, Shape};
use crate::diagnostic::{Diagnostic, Origin};
use crate::geometry::{Arc, CornerCut, CornerSize, Curve, Decimal, Line, MIN_LENGTH, cut_corner};

/// Most blocks from the first move of a SINUMERIK corner to the second: three without a move.
const MOST_BLOCKS: u32 = 4;

/// Halvings of what is taken off an element that does not fit: to a millionth of it.
const HALVINGS: u32 = 20;

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

impl CornerWord {
    /// Tells that the corner stays as it is, and why, where that is not plain.
    pub(super) fn left_out(&self, why: Option<&'static str>, report: &mut Report) {
        if self.is_modal {
            return;
        }
        let message = why.unwrap_or("no line or arc in the plane on both sides of the corner");
        let mut found = Diagnostic::error("corner-left", message);
        if self.yields {
            found = Diagnostic::warning("corner-left", message);
        }
        let hint = "the corner stays sharp: no rounding or chamfer is made";
        report.push(found.with_origin(self.origin).with_hint(hint));
    }
}

/// A corner at the end of a move that is made.
#[derive(Debug)]
pub(super) struct PendingCorner {
    word: CornerWord,
    curve: Curve,
    attributes: Attributes,
    place: Place,
    /// Blocks read since, the one that closes it included.
    blocks: u32,
}

/// Where the course has the first move.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Place {
    /// Among the items.
    Item(usize),
    /// Among the segments of the contour that is open.
    Segment(usize),
    /// It leads in.
    LeadIn,
}

impl Interpreter {
    /// Keeps what the words of a block ask of the corner at the end of its move.
    pub(super) fn ask_of_corner(&mut self, block: &Block, rapid: bool, words: &mut Words) {
        let yields = self.dialect == Dialect::Sinumerik;
        let unit = self.modal.unit();
        let mut asked = None;
        let mut column = 1;
        let kinds: [(char, fn(f64) -> CornerSize); 3] =
            [('r', CornerSize::Radius), ('c', CornerSize::Legs), ('f', CornerSize::Length)];
        for (letter, kind) in kinds {
            let Some(word) = words.take(letter) else { continue };
            let fault = if word.value < 0.0 {
                "the size of a rounding or chamfer is negative"
            } else if asked.is_some() && !yields {
                "a corner is rounded or chamfered, not both"
            } else {
                ""
            };
            if !fault.is_empty() {
                self.error("bad-corner", fault, block.origin_at(word.column), "it is left out");
            } else if asked.is_none() {
                column = word.column;
                asked = Some(kind(word.value * unit));
            }
        }
        let is_modal = asked.is_none();
        if is_modal && !rapid {
            asked = Some(CornerSize::Radius(self.modal.wishes.rounding));
        }
        let feed = words.take('g').map_or(self.modal.wishes.feed, |word| word.value * unit);
        let Some(size) = asked.filter(|size| size.value() > 0.0) else { return };
        let word = CornerWord {
            size: self.even_factor(block).map_or(size, |factor| size.scaled(factor)),
            feed: if feed > 0.0 { self.modal.feed.meant_by(feed) } else { None },
            origin: block.origin_at(column),
            yields,
            is_modal,
        };
        if rapid && !(yields && !matches!(size, CornerSize::Radius(_))) {
            word.left_out(Some(RAPID), &mut self.report);
        } else {
            self.course.asked = Some(word);
        }
    }
}

/// Why there is nothing beside a rapid move.
const RAPID: &str = "no rounding or chamfer beside a rapid move (G00)";

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

    /// A move that ends in a corner to be cut, before it is made.
    pub(super) fn ends_in_corner(
        &mut self,
        from: DVec2,
        shape: &Shape,
        attributes: Attributes,
    ) -> Option<Box<PendingCorner>> {
        let word = self.asked.take()?;
        let curve = curve_of(from, shape, attributes, self.rules)?;
        Some(Box::new(PendingCorner { word, curve, attributes, place: Place::LeadIn, blocks: 0 }))
    }

    /// The move was made: its corner waits for the next one.
    pub(super) fn wait_in_corner(
        &mut self,
        corner: Option<Box<PendingCorner>>,
        report: &mut Report,
    ) {
        let Some(mut corner) = corner else { return };
        let place = match &self.state {
            State::On(open) if !open.builder.is_empty() => {
                Some(Place::Segment(open.builder.len() - 1))
                    .filter(|_| open.begins != ContourStart::Tapers || open.builder.len() > 1)
            }
            State::On(_) => Some(Place::LeadIn),
            _ if matches!(self.items.last(), Some(Item::Free(_))) => {
                Some(Place::Item(self.items.len() - 1))
            }
            _ => None,
        };
        match place {
            Some(place) => {
                corner.place = place;
                self.corner = Some(corner);
            }
            None => corner.word.left_out(Some(SWITCHED), report),
        }
    }

    /// The corner that waits stays as it is: nothing in the plane follows.
    pub(super) fn leave_corner(&mut self, report: &mut Report) {
        if let Some(corner) = self.corner.take() {
            corner.word.left_out(None, report);
        }
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
        let Some(corner) = self.corner.take() else { return true };
        let PendingCorner { word, curve, attributes: first, place, blocks } = *corner;
        let [before, after] = [first.heights, attributes.heights];
        let level = before[0] == before[1] && after == before && attributes.plane == first.plane;
        let second = curve_of(*from, shape, *attributes, self.rules)
            .filter(|_| level && from.distance(curve.end()) < MIN_LENGTH);
        let is_round = matches!(word.size, CornerSize::Radius(_));
        // A lead keeps its direction, and a move what its next corner takes.
        let leads = matches!(self.state, State::Waiting(_) | State::Ending(_));
        // FANUC's alarm 39 is for corners where compensation begins and ends.
        let fanuc = self.rules.words == ControlWords::Fanuc;
        let switches = fanuc && (leads || place == Place::LeadIn);
        let why = if blocks > if word.yields { MOST_BLOCKS } else { 1 } {
            Some("a block without a move stands between both moves of the corner")
        } else if (first.rapid || attributes.rapid) && (is_round || !word.yields) {
            Some(RAPID)
        } else if switches || !self.has_first(place) {
            Some(SWITCHED)
        } else {
            None
        };
        let (Some(second), None) = (second, why) else {
            word.left_out(why, report);
            return true;
        };
        let least = [place == Place::LeadIn, leads || self.asked.is_some()];
        let fits = |factor| match cut_corner(&curve, &second, word.size.scaled(factor)) {
            CornerCut::Made { rest, .. } if (0..2).any(|i| least[i] && rest[i] == 0.0) => {
                CornerCut::Misfit
            }
            cut => cut,
        };
        let mut cut = fits(1.0);
        if cut == CornerCut::Misfit && word.yields {
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                match fits(middle) {
                    CornerCut::Misfit => high = middle,
                    found => (low, cut) = (middle, found),
                }
            }
            if low > 0.0 {
                let message = format!(
                    "the rounding or chamfer is made smaller, to {} mm",
                    Decimal::of(word.size.value() * low)
                );
                report.warning("corner-reduced", message, word.origin, "more does not fit");
            }
        }
        let (ends, center, clockwise, rest) = match cut {
            CornerCut::Made { ends, center, clockwise, rest } => (ends, center, clockwise, rest),
            CornerCut::Tangent => return true,
            CornerCut::Misfit => {
                word.left_out(Some("the rounding or chamfer does not fit its moves"), report);
                return true;
            }
        };
        let [start, end] = ends;
        let element = match center {
            Some(center) => Shape::Arc { to: end, center, clockwise },
            None => Shape::Line { to: end },
        };
        let speed = |of: &Attributes, curve: &Curve| match of.time {
            Some(time) => Some(curve.length() / time),
            None => of.feed,
        };
        let own = word.feed.filter(|_| !attributes.rapid);
        let usual = if word.yields { speed(attributes, &second) } else { speed(&first, &curve) };
        let wish = attributes.wish;
        let made =
            Attributes { feed: own.or(usual), time: None, rapid: attributes.rapid, wish, ..first };
        let part = |of: &Attributes, curve: &Curve, rest: f64| Attributes {
            time: of.time.map(|time| time * rest / curve.length()),
            ..*of
        };
        let shorter =
            (rest[0] > 0.0).then(|| (part_of(&curve, start), part(&first, &curve, rest[0])));
        self.shorten(place, &curve, shorter, (element, made), report);
        *attributes = part(attributes, &second, rest[1]);
        *from = end;
        if let (Curve::Arc(arc), Some(to)) = (&second, shape.end()) {
            *shape = Shape::Arc { to, center: arc.center(), clockwise: arc.is_clockwise() };
        }
        rest[1] > 0.0
    }

    /// Whether the move at `place` is still the last one.
    fn has_first(&self, place: Place) -> bool {
        match (place, &self.state) {
            (Place::Item(item), _) => self.items.iter().skip(item + 1).all(|item| match item {
                Item::Words { reset: None, .. } => true,
                Item::Words { words, reset: Some(reset), .. } => {
                    words.is_empty() && reset.moves == 0
                }
                _ => false,
            }),
            (Place::Segment(last), State::On(open) | State::Ending(open)) => {
                open.builder.len() == last + 1
            }
            (Place::LeadIn, State::On(open) | State::Ending(open)) => {
                open.builder.is_empty() && open.lead_in.is_some()
            }
            _ => false,
        }
    }

    /// Makes the first move shorter, or leaves it out, and puts the element behind it.
    fn shorten(
        &mut self,
        place: Place,
        curve: &Curve,
        shorter: Option<(Shape, Attributes)>,
        (element, made): (Shape, Attributes),
        report: &mut Report,
    ) {
        let at = shorter.as_ref().and_then(|(shape, _)| shape.end()).unwrap_or(curve.start());
        let end = element.end().unwrap_or(at);
        match (place, &mut self.state) {
            (Place::Item(index), _) => {
                for item in self.items.iter_mut().skip(index + 1) {
                    if let Item::Words { reset: Some(reset), .. } = item {
                        reset.at = made.plane.place(end, made.heights[1]);
                    }
                }
                let words = self.items.len();
                self.free_curve(at, element, made, report);
                if self.items.len() > words {
                    self.items[index + 1..].rotate_right(1);
                }
                match (shorter, self.items.get_mut(index)) {
                    (Some((shape, _)), Some(Item::Free(step))) => {
                        if let Some(curve) = as_move(curve.start(), &shape) {
                            step.curve = curve;
                        }
                    }
                    _ => {
                        self.items.remove(index);
                    }
                }
            }
            (Place::Segment(_), State::On(open) | State::Ending(open)) => {
                match (shorter, open.builder.last_mut()) {
                    (Some(shorter), Some(last)) => {
                        *last = shorter;
                        open.builder.insert(element, made);
                    }
                    (_, Some(last)) => *last = (element, made),
                    _ => {}
                }
            }
            (Place::LeadIn, State::On(open) | State::Ending(open)) => {
                open.start = at;
                open.builder.move_start(at);
                if let (Some((_, attributes)), Some(lead)) = (shorter, &mut open.lead_in) {
                    lead.attributes = attributes;
                    open.builder.lead_in(*lead);
                }
                open.builder.insert(element, made);
            }
            _ => {}
        }
    }
}

/// Why there is nothing where the moves do not belong to one contour.
const SWITCHED: &str = "compensation changes between both moves of the corner, or its place";

/// A line or an arc, where the move is one.
fn curve_of(from: DVec2, shape: &Shape, attributes: Attributes, rules: Rules) -> Option<Curve> {
    if !matches!(shape, Shape::Line { .. } | Shape::Arc { .. } | Shape::ArcByRadius { .. }) {
        return None;
    }
    let mut builder = builder_at(from, rules);
    builder.segment(shape.clone(), attributes);
    let built = builder.build(false);
    let contour = built.contour.filter(|_| built.diagnostics.is_empty())?;
    Some(contour.segments()[0].curve.clone())
}

/// The part of a line or an arc up to a point on it.
fn part_of(curve: &Curve, to: DVec2) -> Shape {
    match curve {
        Curve::Arc(arc) => Shape::Arc { to, center: arc.center(), clockwise: arc.is_clockwise() },
        _ => Shape::Line { to },
    }
}

/// A line or an arc as a move.
fn as_move(from: DVec2, shape: &Shape) -> Option<MoveCurve> {
    match *shape {
        Shape::Arc { to, center, clockwise } => {
            Arc::from_center(from, to, center, clockwise, f64::INFINITY).ok().map(MoveCurve::Arc)
        }
        Shape::Line { to } => Line::new(from, to).ok().map(MoveCurve::Line),
        _ => None,
    }
}
