//! From blocks to moves and contours: the modes of a control, block by block.
//!
//! Within a block the order is that of RS274/NGC: units and other modes, feed, words that move
//! nothing, compensation, the move, stops; whatever has no meaning by then is reported.

use super::auxiliary::Auxiliary;
use super::block::{Block, Word};
use super::course::Course;
use super::g_words::{Compensation, GWord, Motion, g_word};
use super::modal::Modal;
use super::number::{push_word, whole};
use super::report::Report;
use super::rules::Rules;
use super::type_points::{PendingSpline, SplineWord, spline_word};
use super::words::{Words, tenths};
use crate::diagnostic::{Diagnostic, Origin};
use crate::geometry::Decimal;

/// Letters that belong to the geometry of a block.
pub(super) const GEOMETRY: &str = "XYZABCUVWIJKRPQLDHE";

/// Seconds in a minute.
pub(super) const MINUTE: f64 = 60.0;

/// Whether the program goes on after a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Flow {
    Next,
    End,
}

/// What the G words of a block ask for besides modes.
#[derive(Debug, Default)]
struct Demands<'a> {
    /// A motion word was there.
    motion: Option<Motion>,
    /// A word of the G05 family by ten times its number, and where it is.
    family: Option<(u32, u32)>,
    dwell: Option<&'a Word>,
    compensation: Option<(Compensation, &'a Word)>,
    /// The block cannot be turned into moves.
    no_move: bool,
    groups: u8,
}

/// The state of a control while it runs through a program.
pub(super) struct Interpreter {
    pub(super) modal: Modal,
    pub(super) course: Course,
    pub(super) report: Report,
    pub(super) spline: Option<PendingSpline>,
    /// Words since its last type point, whether they are comments only, and their block.
    waiting: Vec<(String, bool, Origin)>,
    pub(super) rules: Rules,
    /// The control has refused to go on.
    pub(super) is_refused: bool,
}

impl Interpreter {
    pub(super) fn new(rules: Rules) -> Self {
        let (modal, course) = (Modal::new(), Course::new(rules));
        let report = Report::default();
        Self { modal, course, report, spline: None, waiting: Vec::new(), rules, is_refused: false }
    }

    pub(super) fn block(&mut self, block: &Block) -> Flow {
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
        if let Some((tenths, column)) = demands.family {
            self.spline_family(block, tenths, column, &mut words, &mut demands);
        }
        if self.is_refused {
            return Flow::End;
        }
        if self.ends_spline(&demands, &words) {
            self.finish_spline();
        }
        self.feed(block, &mut words);
        self.auxiliary_words(block, &mut words, &mut auxiliary);
        if let Some(dwell) = demands.dwell {
            self.dwell(block, dwell, &mut words, &mut auxiliary);
        }
        if demands.no_move {
            words.take_all(GEOMETRY);
        }
        let (end, stops, only_comments) = (auxiliary.end, auxiliary.stops, !auxiliary.has_words());
        let (before, after) = auxiliary.finish();
        self.pass_on(before, only_comments, block.origin());
        self.compensation(block, demands.compensation, &mut words);
        if self.is_refused {
            return Flow::End;
        }
        if let Some(motion) = self.modal.motion
            && !demands.no_move
        {
            self.motion(block, motion, demands.motion.is_some(), &mut words);
        } else if let Some(axis) = words.unused().map(|(_, word)| word).find(|w| is_axis(w)) {
            self.error(
                "no-motion-mode",
                "no word has said yet how the axes move",
                block.origin_at(axis.column),
                "put G00 or G01 into the block",
            );
            words.take_all(GEOMETRY);
        }
        self.not_understood(block, &words);
        if stops {
            self.course.stop(block.origin());
        }
        if end {
            self.finish_spline();
            self.course.end(Some(block.origin()), &mut self.report);
        }
        self.pass_on(after, false, block.origin());
        if end { Flow::End } else { Flow::Next }
    }

    /// The control goes no further: what it is asked for may not be while compensation is on.
    pub(super) fn refuse(&mut self, message: &str, origin: Origin) {
        let hint = "the control stops here, and so does the path";
        self.error("refused", message, origin, hint);
        self.finish_spline();
        self.course.cut_off(&mut self.report);
        self.is_refused = true;
    }

    pub(super) fn error(
        &mut self,
        code: &'static str,
        message: impl Into<String>,
        origin: Origin,
        hint: &str,
    ) {
        self.report.error(code, message, origin, hint);
    }

    /// Sets the modes, and collects what else the G words ask for.
    fn g_words<'a>(
        &mut self,
        block: &'a Block,
        words: &mut Words<'a>,
        auxiliary: &mut Auxiliary,
    ) -> Demands<'a> {
        let mut demands = Demands::default();
        for (index, word) in block.words.iter().enumerate().filter(|(_, w)| w.letter == 'G') {
            let Some((number, meaning)) = tenths(word).and_then(|n| Some((n, g_word(n)?))) else {
                continue;
            };
            words.use_up(index);
            if let Some(group) = meaning.group() {
                if demands.groups >> group & 1 == 1 {
                    self.error(
                        "conflicting-words",
                        format!(
                            "G{} excludes a G word before it in the block",
                            Decimal::of(word.value)
                        ),
                        block.origin_at(word.column),
                        "the later one counts; put them into blocks of their own",
                    );
                }
                demands.groups |= 1 << group;
            }
            match meaning {
                GWord::Motion(motion) => {
                    demands.motion = Some(motion);
                    demands.family = None;
                    self.modal.motion = Some(motion);
                }
                GWord::SplineFamily => demands.family = Some((number, word.column)),
                GWord::EndOfCycle => self.modal.motion = None,
                GWord::Dwell => demands.dwell = Some(word),
                GWord::Plane(other) => {
                    self.modal.other_plane = other;
                    if let Some(plane) = other {
                        self.not_supported(block, word.column, &format!("the plane {plane}"));
                    }
                }
                GWord::Inches(inches) => self.modal.inches = inches,
                GWord::Relative(relative) => self.modal.relative = relative,
                GWord::AbsoluteCenter(absolute) => self.modal.absolute_center = absolute,
                GWord::FeedMode(other) => {
                    self.modal.feed_per_minute = other.is_none();
                    if let Some(mode) = other {
                        self.modal.feed = None;
                        self.not_supported(block, word.column, mode);
                    }
                }
                GWord::Compensation(compensation) => {
                    demands.compensation = Some((compensation, word));
                }
                GWord::Harmless => {}
                GWord::PassedOn => {
                    auxiliary.word('G', word.value);
                    self.changed_while_on(block, word, "the coordinate system");
                    // The same numbers are another place now.
                    self.modal.stated = [false; 3];
                }
                GWord::LeftOut(what, letters) => {
                    words.take_all(letters);
                    self.report.warning(
                        "left-out",
                        format!("{what} is left out"),
                        block.origin_at(word.column),
                        "set it on the machine",
                    );
                }
                GWord::Noted(what, letters) => {
                    words.take_all(letters);
                    self.noted(block, word.column, what);
                }
                GWord::NotSupported(what) => {
                    self.not_supported(block, word.column, what);
                    demands.no_move = true;
                }
            }
        }
        demands
    }

    /// G05 and its namesakes, told apart by the words beside them.
    fn spline_family(
        &mut self,
        block: &Block,
        tenths: u32,
        column: u32,
        words: &mut Words,
        demands: &mut Demands,
    ) {
        let motion = match spline_word(tenths, words) {
            SplineWord::TypePoint => Motion::TypePoints,
            SplineWord::Setting(what) => {
                words.take_all("PQR");
                self.noted(block, column, what);
                return;
            }
            SplineWord::Smoothing(what) => {
                words.take_all("PQRXYZ");
                self.report.warning(
                    "left-out",
                    format!("{what} is left out"),
                    block.origin_at(column),
                    "the path is the one programmed, not smoothed",
                );
                return;
            }
            SplineWord::NotSupported(what) => Motion::NotSupported(what),
        };
        demands.motion = Some(motion);
        self.modal.motion = Some(motion);
    }

    /// Whether the block cannot continue the spline before it.
    fn ends_spline(&self, demands: &Demands, words: &Words) -> bool {
        demands.no_move
            || demands.compensation.is_some()
            || words.has_any("D")
            || self.modal.motion != Some(Motion::TypePoints)
    }

    pub(super) fn finish_spline(&mut self) {
        if let Some((start, shape, attributes)) = self.spline.take().and_then(PendingSpline::finish)
        {
            self.course.curve(start, shape, attributes, &mut self.report);
        }
        self.release_words(false);
    }

    /// Words that move nothing. While it is open whether the spline goes on, they wait for that.
    fn pass_on(&mut self, words: String, only_comments: bool, origin: Origin) {
        if words.is_empty() {
            return;
        }
        if self.spline.as_ref().is_some_and(|spline| !spline.is_empty()) {
            self.waiting.push((words, only_comments, origin));
        } else {
            self.course.words(words, origin);
        }
    }

    /// The words that waited: after the spline, or before it where it goes on.
    pub(super) fn release_words(&mut self, goes_on: bool) {
        for (words, only_comments, origin) in std::mem::take(&mut self.waiting) {
            if goes_on && !only_comments {
                self.report.warning(
                    "words-in-spline",
                    "words between type points act before them",
                    origin,
                    "put them before or after the spline",
                );
            }
            self.course.words(words, origin);
        }
    }

    fn feed(&mut self, block: &Block, words: &mut Words) {
        let Some(word) = words.take('F') else { return };
        if !self.modal.feed_per_minute {
            return;
        }
        if word.value > 0.0 {
            self.modal.feed = Some(word.value * self.modal.unit() / MINUTE);
        } else {
            self.error(
                "bad-feed",
                format!("the feed {} is not positive", Decimal::of(word.value)),
                block.origin_at(word.column),
                "the feed before it stays",
            );
        }
    }

    /// M, S, T and O words.
    fn auxiliary_words(&mut self, block: &Block, words: &mut Words, auxiliary: &mut Auxiliary) {
        // The T word acts before M6, wherever in the block it stands.
        if let Some(number) = words.find('T').and_then(|word| whole(word.value)) {
            self.modal.select_tool(number);
        }
        for (index, word) in block.words.iter().enumerate() {
            match word.letter {
                'S' => auxiliary.word('S', word.value),
                'O' if index == 0 => auxiliary.program_number(word.value),
                'T' if whole(word.value).is_some() => auxiliary.word('T', word.value),
                'M' => match tenths(word) {
                    Some(970 | 980 | 990) => {
                        self.not_supported(block, word.column, "a subprogram");
                        words.take_all("PLQ");
                    }
                    Some(number) => {
                        if number == 60 {
                            self.modal.change_tool();
                            self.changed_while_on(block, word, "the tool");
                        }
                        auxiliary.m_word(number, word.value);
                    }
                    None => continue,
                },
                _ => continue,
            }
            words.use_up(index);
        }
    }

    fn dwell(&mut self, block: &Block, word: &Word, words: &mut Words, auxiliary: &mut Auxiliary) {
        let time = ['P', 'X', 'U'].into_iter().find_map(|letter| words.take(letter));
        let Some(time) = time.filter(|time| time.value >= 0.0) else {
            let at = block.origin_at(word.column);
            self.error("bad-dwell", "the dwell (G04) has no time", at, "add P in seconds");
            return;
        };
        // No one waits that long on purpose; FANUC counts P in milliseconds.
        if time.letter == 'P' && time.value >= 100.0 {
            let message =
                format!("the dwell of {} is passed on in seconds", Decimal::of(time.value));
            self.report.warning(
                "long-dwell",
                message,
                block.origin_at(time.column),
                "where P counts milliseconds, divide it by 1000",
            );
        }
        let mut text = String::from("G4 ");
        push_word(&mut text, 'P', time.value);
        auxiliary.text(&text);
    }

    fn changed_while_on(&mut self, block: &Block, word: &Word, what: &str) {
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

    fn noted(&mut self, block: &Block, column: u32, what: &str) {
        let message = format!("{what} is left out; it does not change the path");
        self.report.push(Diagnostic::info("noted", message).with_origin(block.origin_at(column)));
    }

    pub(super) fn not_supported(&mut self, block: &Block, column: u32, what: &str) {
        self.error(
            "not-supported",
            format!("{what} is not supported"),
            block.origin_at(column),
            "what it would do is missing from the path",
        );
    }

    fn not_understood(&mut self, block: &Block, words: &Words) {
        for (_, word) in words.unused() {
            let what = if matches!(word.letter, 'A' | 'B' | 'C' | 'U' | 'V' | 'W') {
                "moves an axis that is not supported"
            } else {
                "is not understood here"
            };
            self.error(
                "word-not-understood",
                format!("the word {}{} {what}", word.letter, Decimal::of(word.value)),
                block.origin_at(word.column),
                "it has no effect",
            );
        }
    }
}

fn is_axis(word: &Word) -> bool {
    matches!(word.letter, 'X' | 'Y' | 'Z')
}
