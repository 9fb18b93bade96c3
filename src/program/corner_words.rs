//! Words about corners and leads: FANUC's G39, G25, G26, G138 and G139 of ISG and Beckhoff controls,
//! G450, G451, DISC, NORM and KONT of SINUMERIK.

use glam::{DVec2, DVec3};

use super::block::{Block, Word};
use super::coordinates::AXES;
use super::dialect::Dialect;
use super::g_words::Motion;
use super::interpret::Interpreter;
use super::modes::Demands;
use super::number::whole;
use super::rules::ControlWords;
use super::words::{Words, tenths};
use crate::contour::{CornerWish, LeadWish, Wish};
use crate::geometry::{MIN_LENGTH, turn};

/// How far the direction that G39 gives may be off that of the next block [rad]: rounded numbers of
/// a tenth of a millimetre and more are that exact.
const DIRECTION_TOLERANCE: f64 = 0.01;

/// What words have asked of corners and leads.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Wishes {
    /// Until another word.
    modal: Wish,
    /// DISC, 0 to 100.
    disc: u8,
    /// RNDM: the radius of every corner [mm]; 0 for none.
    pub(super) rounding: f64,
    /// FRCM: the feed in roundings and chamfers [mm/min, or mm in one turn]; 0 for none.
    pub(super) feed: f64,
    /// G39, with the direction in which it says that the next block starts; none where it is zero.
    corner_arc: Option<DVec2>,
}

impl Interpreter {
    /// A G word about corners or leads; false where it is none.
    pub(super) fn corner_word(
        &mut self,
        block: &Block,
        word: &Word,
        words: &mut Words,
        demands: &mut Demands,
    ) -> bool {
        let Some(number) = tenths(word) else { return false };
        let wishes = &mut self.modal.wishes;
        let control = match self.rules.words {
            ControlWords::Common if self.dialect == Dialect::Sinumerik => ControlWords::Sinumerik,
            control => control,
        };
        match (number, control) {
            (250, ControlWords::Isg) => wishes.modal.corner = CornerWish::Linear,
            (260, ControlWords::Isg) => wishes.modal.corner = CornerWish::Arc,
            (1380, ControlWords::Isg) => wishes.modal.lead = LeadWish::Perpendicular,
            (1390, ControlWords::Isg) => wishes.modal.lead = LeadWish::Round,
            (4500, ControlWords::Sinumerik) => wishes.modal.corner = CornerWish::Conic(wishes.disc),
            (4510, ControlWords::Sinumerik) => wishes.modal.corner = CornerWish::Intersection,
            (7000, ControlWords::Sinumerik) => self.modal.inches = true,
            (7100, ControlWords::Sinumerik) => self.modal.inches = false,
            // Older controls have the units of RS-274-D. With more words they are cycles of lathes.
            (700 | 710, _) if !self.rules.is_strict && !words.has_any("PQUWRDI") => {
                self.modal.inches = number == 700;
            }
            // Exact stop, and limits of the spindle's speed.
            (4600 | 600, ControlWords::Sinumerik) => {}
            (250 | 260, ControlWords::Sinumerik) => words.take_all("SXYZ"),
            (1100 | 1110 | 1120, ControlWords::Sinumerik) => {
                self.pole(number, words);
                demands.no_move = true;
            }
            (4610 | 4620, ControlWords::Sinumerik) => {
                self.not_supported(
                    block,
                    word.column,
                    "a lead that seeks the contour (G461, G462)",
                );
            }
            (390, ControlWords::Common | ControlWords::Fanuc) if !self.rules.is_strict => {
                self.corner_arc(block, word, words);
                demands.no_move = true;
            }
            _ => return false,
        }
        true
    }

    /// NORM, KONT and DISC, which SINUMERIK's programs alone have.
    pub(super) fn corner_names(&mut self, block: &Block, words: &mut Words) {
        if let Some(word) = words.take('k') {
            if word.value > 1.0 {
                let what = "a lead along a polynomial (KONTT, KONTC)";
                self.not_supported(block, word.column, what);
            }
            self.modal.wishes.modal.lead =
                if word.value == 0.0 { LeadWish::Perpendicular } else { LeadWish::Round };
        }
        let unit = self.modal.unit();
        if let Some(word) = words.take('m') {
            self.modal.wishes.rounding = word.value * unit;
        }
        if let Some(word) = words.take('h') {
            self.modal.wishes.feed = word.value * unit;
        }
        let Some(word) = words.take('v') else { return };
        let disc = whole(word.value).and_then(|disc| u8::try_from(disc).ok());
        let Some(disc) = disc.filter(|disc| *disc <= 100) else {
            let message = "DISC is a whole number from 0 to 100";
            self.error("bad-disc", message, block.origin_at(word.column), "it is left out");
            return;
        };
        let wishes = &mut self.modal.wishes;
        wishes.disc = disc;
        if wishes.modal.corner != CornerWish::Intersection {
            wishes.modal.corner = CornerWish::Conic(disc);
        }
    }

    /// G39: an arc about the corner where the next block starts; X Y, a point, or I J, a vector, tell
    /// in which direction that is.
    fn corner_arc(&mut self, block: &Block, word: &Word, words: &mut Words) {
        if self.course.side().is_none() {
            let message = "a corner arc (G39) needs compensation to be on";
            let hint = "it is left out; put it between two moves after G41 or G42";
            self.error("corner-arc-off", message, block.origin_at(word.column), hint);
            return;
        }
        self.finish_spline();
        let position = self.modal.position;
        let from = self.modal.frame.unmap(position);
        let mut to = from;
        for (i, letter) in AXES.into_iter().enumerate() {
            let vector = words.take(['I', 'J', 'K'][i]);
            let is_vector = vector.is_some();
            if let Some(word) = vector.or_else(|| words.take(letter)) {
                let relative = is_vector || self.modal.relative;
                let start = if relative { from[i] } else { 0.0 };
                to[i] = start + self.modal.length_of(i, word.value);
            }
        }
        let to = self.modal.frame.map(to);
        self.modal.wishes.corner_arc = Some(self.in_plane(to));
    }

    /// The vector of G40: I and J, or those of another plane.
    pub(super) fn wall(&mut self, words: &mut Words) {
        let fanuc = matches!(self.rules.words, ControlWords::Common | ControlWords::Fanuc);
        let straight = matches!(self.modal.motion, Some(Motion::Rapid | Motion::Linear));
        if !fanuc || !straight || self.rules.is_strict || self.course.side().is_none() {
            return;
        }
        let vector = ['I', 'J', 'K'].map(|letter| words.take(letter).map_or(0.0, |w| w.value));
        let from = self.modal.frame.unmap(self.modal.position);
        let way = self.in_plane(self.modal.frame.map(from + DVec3::from(vector)));
        if way.length() > MIN_LENGTH {
            self.course.wall(way);
        }
    }

    /// The way in the plane from where the program is [mm].
    fn in_plane(&self, to: DVec3) -> DVec2 {
        let plane = self.modal.plane;
        plane.split(to).0 - plane.split(self.modal.position).0
    }

    /// What is asked of a move to `to` [mm].
    pub(super) fn wish(&mut self, block: &Block, to: DVec3) -> Wish {
        let mut wish = self.modal.wishes.modal;
        if self.modal.wishes.corner_arc.is_none() {
            return wish;
        }
        let way = self.in_plane(to);
        let straight = matches!(self.modal.motion, Some(Motion::Linear | Motion::Rapid));
        if straight && way.length() < MIN_LENGTH {
            return wish;
        }
        wish.corner = CornerWish::Arc;
        if let Some(direction) = self.modal.wishes.corner_arc.take()
            && straight
            && turn(direction, way).abs() > DIRECTION_TOLERANCE
        {
            self.report.warning(
                "corner-arc-direction",
                "the corner arc (G39) points elsewhere than its next block",
                block.origin(),
                "it ends beside the start of the block all the same",
            );
        }
        wish
    }
}
