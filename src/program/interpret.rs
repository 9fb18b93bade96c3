//! From blocks to moves and contours: the modes of a control, block by block.
//!
//! Within a block the order is that of RS274/NGC: units and other modes, feed, words that move
//! nothing, compensation, coordinate systems, the move, stops; whatever has no meaning by then is
//! reported.

use super::auxiliary::Auxiliary;
use super::block::{Block, Word};
use super::course::Course;
use super::dialect::Dialect;
use super::g_words::Motion;
use super::modal::Modal;
use super::pending_spline::PendingSpline;
use super::points::Points;
use super::report::Report;
use super::rules::Rules;
use super::spline_blocks::Curves;
use super::words::Words;
use crate::diagnostic::{Diagnostic, Origin};
use crate::geometry::Decimal;

/// Letters that belong to the geometry of a block.
pub(super) const GEOMETRY: &str = "XYZABCUVWIJKRPQLDHE@^";

/// Seconds in a minute.
pub(super) const MINUTE: f64 = 60.0;

/// Most moves that cycles and arcs of several turns may become: they take memory, and a short text
/// can ask for any number of them.
const MOST_EXPANDED: u32 = 2_000_000;

/// Whether the program goes on after a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Flow {
    Next,
    End,
}

/// The state of a control while it runs through a program.
#[derive(Debug)]
pub(super) struct Interpreter {
    pub(super) dialect: Dialect,
    pub(super) modal: Modal,
    pub(super) course: Course,
    pub(super) report: Report,
    pub(super) spline: Option<PendingSpline>,
    /// Words since its last type point, whether they are comments only, and their block.
    pub(super) waiting: Vec<(String, bool, Origin)>,
    pub(super) curves: Curves,
    pub(super) rules: Rules,
    /// The control has refused to go on.
    pub(super) is_refused: bool,
    /// The items there were when it did; those that the rest of its block makes do not count.
    pub(super) made: usize,
    /// Why, where a control would have looked at the words of the block before it did anything.
    pub(super) fault: Option<Diagnostic>,
    /// Axes that the next move has to state, whatever its block says.
    pub(super) owed: [bool; 3],
    pub(super) points: Points,
    /// Moves that cycles and arcs of several turns have become.
    expanded: u32,
}

impl Interpreter {
    pub(super) fn new(rules: Rules) -> Self {
        Self {
            dialect: Dialect::Auto,
            modal: Modal::new(rules.is_strict),
            course: Course::new(rules),
            report: Report::default(),
            spline: None,
            waiting: Vec::new(),
            curves: Curves::default(),
            rules,
            is_refused: false,
            made: usize::MAX,
            fault: None,
            owed: [false; 3],
            points: Points::default(),
            expanded: 0,
        }
    }

    /// How many moves and words there are, those included that wait for what follows.
    pub(super) fn len(&self) -> usize {
        let points = self.spline.as_ref().map_or(0, PendingSpline::len);
        self.course.len() + self.waiting.len() + points
    }

    pub(super) fn block(&mut self, block: &Block) -> Flow {
        if self.is_refused {
            return Flow::End;
        }
        self.modal.feed_unit = self.modal.unit();
        let mut words = Words::new(block);
        if block.skippable {
            self.report.push(
                Diagnostic::info("block-delete", "the block can be skipped by a switch (/)")
                    .with_origin(block.origin())
                    .with_hint("it is read as if the switch were off"),
            );
        }
        let mut auxiliary = Auxiliary::new(block);
        let mut demands = self.g_words(block, &mut words, &mut auxiliary);
        if demands.is_unknown() && self.pattern(block) {
            return Flow::Next;
        }
        self.spline_words(&mut words, &mut demands);
        self.corner_names(block, &mut words);
        self.course.passes_block(block);
        if let Some((tenths, column)) = demands.family {
            self.spline_family(block, tenths, column, &mut words, &mut demands);
        }
        if self.is_refused {
            return Flow::End;
        }
        if self.modal.polar_interpolation {
            // Its moves are missing, and so is what switches beside them.
            (demands.no_move, demands.acts, demands.compensation) = (true, false, None);
        }
        if self.ends_spline(&demands, &words) {
            self.look_ahead(&words);
            self.finish_spline();
        }
        if let Some(dwell) = demands.dwell {
            self.dwell(block, dwell, &mut words, &mut auxiliary);
        }
        self.feed(block, &mut words);
        self.auxiliary_words(block, &mut words, &mut auxiliary);
        if demands.no_move {
            words.take_all(GEOMETRY);
        }
        let (end, stops, only_comments) = (auxiliary.end, auxiliary.stops, !auxiliary.has_words());
        let (before, after) = auxiliary.finish();
        self.compensation(block, demands.compensation, &mut words);
        if self.is_refused {
            return Flow::End;
        }
        if demands.length && self.rules.is_strict {
            self.modal.systems.held = None;
            self.pass_reset(block, before);
        } else {
            self.pass_on(before, only_comments, block.origin());
        }
        if demands.length {
            self.forget([false, false, true]);
        }
        if demands.acts {
            self.acts(block, &mut words);
        }
        self.programmable_frame(block, &mut words);
        if self.is_refused {
            return Flow::End;
        }
        let axis = words.unused().map(|(_, word)| word).find(|word| is_axis(word));
        if demands.once.or(self.modal.motion).is_none()
            && let Some(axis) = axis
            && !self.after_switching_on(block, axis)
        {
            words.take_all(GEOMETRY);
        }
        let moved = !demands.no_move && words.has_any("XYZjq");
        if let Some(motion) = demands.once.or(self.modal.motion)
            && !demands.no_move
        {
            let stated = demands.motion.or(demands.once).is_some();
            self.motion(block, motion, stated, &mut words);
        }
        self.is_refused |= self.course.is_cut_off;
        if self.is_refused {
            return Flow::End;
        }
        self.drill(block, &mut words, moved);
        self.not_understood(block, &words, demands.hint());
        if self.is_refused {
            return Flow::End;
        }
        if stops {
            self.course.stop(block.origin());
            // The operator may have moved the machine, above all to change a tool by hand.
            self.modal.restate = [self.course.is_free(); 3];
        }
        if end {
            self.finish_spline();
            self.course.end(Some(block.origin()), &mut self.report);
        }
        self.pass_on(after, false, block.origin());
        if end { Flow::End } else { Flow::Next }
    }

    /// Moves axes though no word has said how: straight, as controls do that were just switched on, and
    /// never faster than at the feed once there is one. `LinuxCNC` refuses; then it is false.
    fn after_switching_on(&mut self, block: &Block, axis: &Word) -> bool {
        let message = "no word has said yet how the axes move";
        let at = block.origin_at(axis.column);
        if self.rules.is_strict {
            self.error("no-motion-mode", message, at, "");
            return false;
        }
        let hint = "it goes straight, at the feed if there is one; put G00 or G01 into the block";
        self.report.warning("no-motion-mode", message, at, hint);
        let feeds = self.modal.feed.word(1.0).is_some();
        self.modal.motion = Some(if feeds { Motion::Linear } else { Motion::Rapid });
        true
    }

    /// Whether one block may become `moves` moves more.
    pub(super) fn may_expand(&mut self, block: &Block, moves: u32) -> bool {
        self.expanded = self.expanded.saturating_add(moves);
        let may = self.expanded <= MOST_EXPANDED;
        if !may {
            let message = "cycles and turns of arcs make more moves than a program can have";
            self.error("too-many-moves", message, block.start(), "the block makes no move");
        }
        may
    }

    /// The control goes no further: what it is asked for may not be now.
    pub(super) fn refuse(&mut self, message: &str, origin: Origin) {
        self.error("refused", message, origin, "");
    }

    /// Reports what cannot be done; a control that is strict goes no further.
    pub(super) fn error(
        &mut self,
        code: &'static str,
        message: impl Into<String>,
        origin: Origin,
        hint: &str,
    ) {
        self.error_or_stop(code, message.into(), origin, hint);
    }

    #[inline(never)]
    fn error_or_stop(&mut self, code: &'static str, message: String, origin: Origin, hint: &str) {
        if !self.rules.is_strict {
            self.report.error(code, message, origin, hint);
        } else if !self.is_refused {
            self.stop_at(fault(code, message, origin));
        }
    }

    /// The control goes no further.
    pub(super) fn stop_at(&mut self, fault: Diagnostic) {
        self.report.push(fault);
        self.is_refused = true;
        self.finish_spline();
        self.course.cut_off(&mut self.report);
        self.made = self.course.items.len();
    }

    pub(super) fn changed_while_on(&mut self, block: &Block, word: &Word, what: &str) {
        if self.rules.is_strict && self.course.switched().is_some() {
            let message = format!("{what} may not change while compensation is on");
            self.refuse(&message, block.origin_at(word.column));
        } else if self.course.side().is_some() {
            let message = format!("{what} changes while compensation is on");
            self.report.warning(
                "changed-while-on",
                message,
                block.origin_at(word.column),
                "switch compensation off with G40 before",
            );
        }
    }

    pub(super) fn not_supported(&mut self, block: &Block, column: u32, what: &str) {
        self.error(
            "not-supported",
            format!("{what} is not supported"),
            block.origin_at(column),
            "what it would do is missing from the path",
        );
    }

    pub(super) fn not_understood(&mut self, block: &Block, words: &Words, hint: &str) {
        for (_, word) in words.unused() {
            let code = "word-not-understood";
            let number = Decimal::of(word.value);
            // Small letters are those behind a comma.
            let comma = if word.letter.is_ascii_lowercase() { "," } else { "" };
            let letter = word.letter.to_ascii_uppercase();
            let message = format!("the word {comma}{letter}{number} is not understood here");
            let at = block.origin_at(word.column);
            if self.rules.is_strict {
                self.fault = Some(fault(code, message, at));
                self.is_refused = true;
                return;
            }
            self.report.error(code, message, at, hint);
        }
    }
}

fn fault(code: &'static str, message: impl Into<String>, origin: Origin) -> Diagnostic {
    Diagnostic::error(code, message)
        .with_origin(origin)
        .with_hint("the control stops here, and so does the path")
}

pub(super) fn is_axis(word: &Word) -> bool {
    matches!(word.letter, 'X' | 'Y' | 'Z' | 'j' | 'q')
}
