//! F and S words: the feed of a move by the way it is programmed.

use super::block::Block;
use super::dialect::Dialect;
use super::g_words::Motion;
use super::interpret::{Interpreter, MINUTE};
use super::words::Words;
use crate::geometry::Decimal;

/// How F words are meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum FeedMode {
    /// G94: mm/min or inch/min.
    PerMinute,
    /// G93: one over the minutes that the move takes. F is needed in every block that feeds.
    InverseTime,
    /// G95: mm or inch in one turn of the spindle.
    PerRevolution,
}

/// The feed in effect.
#[derive(Debug, Clone, Copy)]
pub(super) struct Feed {
    mode: FeedMode,
    /// The F word [mm/s, or mm in one turn].
    value: Option<f64>,
    /// Time of the moves of the present block [s].
    time: Option<f64>,
    /// Speed of the spindle [rev/s], where it is known.
    speed: Option<f64>,
    /// G96: S is the speed of the surface.
    surface_speed: bool,
    /// Whether it was said that the speed is not known.
    said: bool,
}

impl Feed {
    pub(super) const fn new() -> Self {
        Self {
            mode: FeedMode::PerMinute,
            value: None,
            time: None,
            speed: None,
            surface_speed: false,
            said: false,
        }
    }

    /// G93, G94 and G95. A number that was meant otherwise does not count any more, and on a control
    /// that is strict none does.
    pub(super) fn set_mode(&mut self, mode: FeedMode, is_strict: bool) {
        if self.mode != mode || is_strict {
            self.mode = mode;
            self.value = None;
        }
    }

    pub(super) fn is_inverse_time(&self) -> bool {
        self.mode == FeedMode::InverseTime
    }

    pub(super) fn mode(&self) -> FeedMode {
        self.mode
    }

    /// The F word, where it counts for more than its block, in programs of a unit [mm].
    pub(super) fn word(&self, unit: f64) -> Option<f64> {
        let value = self.value? / unit;
        Some(if self.mode == FeedMode::PerMinute { value * MINUTE } else { value })
    }

    /// G96 and G97; tells whether that is a change.
    pub(super) fn set_surface_speed(&mut self, on: bool) -> bool {
        let changes = self.surface_speed != on;
        self.said &= !changes;
        self.surface_speed = on;
        if changes {
            self.speed = None;
        }
        changes
    }

    pub(super) fn is_surface_speed(&self) -> bool {
        self.surface_speed
    }

    /// Speed of the spindle [rev/s], where it is known.
    pub(super) fn speed(&self) -> Option<f64> {
        self.speed
    }

    /// The feed that a number [mm/min, or mm in one turn] is [mm/s], where that is known.
    pub(super) fn meant_by(&self, value: f64) -> Option<f64> {
        match self.mode {
            FeedMode::PerRevolution => self.speed.map(|speed| value * speed),
            FeedMode::PerMinute | FeedMode::InverseTime => Some(value / MINUTE),
        }
    }

    /// An S word as programmed.
    pub(super) fn set_speed(&mut self, value: f64) {
        self.speed = (!self.surface_speed).then_some(value.abs() / MINUTE);
    }
}

impl Interpreter {
    /// The F word.
    pub(super) fn feed(&mut self, block: &Block, words: &mut Words) {
        let unit = self.modal.feed_unit;
        let feed = &mut self.modal.feed;
        feed.time = None;
        // FANUC's lead of a thread.
        let thread = matches!(self.modal.motion, Some(Motion::Passed(330 | 331)));
        if thread && self.dialect == Dialect::Fanuc {
            return;
        }
        let Some(word) = words.take('F') else { return };
        if word.value > 0.0 {
            match feed.mode {
                FeedMode::PerMinute => feed.value = Some(word.value * unit / MINUTE),
                FeedMode::PerRevolution => feed.value = Some(word.value * unit),
                FeedMode::InverseTime => feed.time = Some(MINUTE / word.value),
            }
        } else if word.value == 0.0 && self.rules.is_strict {
            feed.value = None;
        } else {
            self.error(
                "bad-feed",
                format!("the feed {} is not positive", Decimal::of(word.value)),
                block.origin_at(word.column),
                "the feed before it stays",
            );
        }
    }

    /// Feed [mm/s] or time [s] of the moves of a block.
    pub(super) fn feed_of_moves(&mut self, block: &Block) -> (Option<f64>, Option<f64>) {
        let feed = self.modal.feed;
        if self.rules.is_strict && feed.mode != FeedMode::InverseTime && feed.value.is_none() {
            self.error("missing-feed", "no word has said how fast to feed", block.start(), "");
        }
        match feed.mode {
            FeedMode::PerMinute => (feed.value, None),
            FeedMode::InverseTime => {
                if feed.time.is_none() {
                    self.error(
                        "missing-feed",
                        "inverse time feed (G93) needs an F word in every block",
                        block.start(),
                        "add F: one over the minutes that the move takes",
                    );
                }
                (None, feed.time)
            }
            FeedMode::PerRevolution => {
                if feed.speed.is_none() && !std::mem::replace(&mut self.modal.feed.said, true) {
                    self.error(
                        "unknown-speed",
                        "feed per revolution (G95) at a speed that is not known",
                        block.start(),
                        "give the speed by S before, with G97",
                    );
                }
                (feed.value.zip(feed.speed).map(|(feed, speed)| feed * speed), None)
            }
        }
    }
}
