//! Words that move nothing: M, S and T words, dwell, and what else is passed through in its place.

use super::block::{Block, Word};
use super::dialect::Dialect;
use super::interpret::Interpreter;
use super::number::{push_word, whole};
use super::words::{Words, tenths};
use crate::geometry::Decimal;

/// Millimetres of a foot, in thousandths: S under G96 is in m/min or ft/min.
const FOOT: f64 = 0.3048;

/// Where words stand in the order of execution of RS274/NGC; comments come last, stops after the
/// move.
pub(super) mod rank {
    pub(crate) const NAME: u8 = 0;
    pub(crate) const SPEED: u8 = 1;
    pub(crate) const TOOL: u8 = 2;
    pub(crate) const OUTPUT: u8 = 3;
    pub(crate) const CHANGE: u8 = 4;
    pub(crate) const SPINDLE: u8 = 5;
    pub(crate) const COOLANT: u8 = 6;
    pub(crate) const OVERRIDE: u8 = 7;
    pub(crate) const USER: u8 = 8;
    pub(crate) const DWELL: u8 = 9;
    pub(crate) const LENGTH: u8 = 10;
    pub(crate) const CONTROL: u8 = 11;
    pub(crate) const STOP: u8 = 12;
}

/// The words of a block that act before its move and after it, as text.
#[derive(Debug)]
pub(super) struct Auxiliary<'a> {
    before: Vec<(u8, String)>,
    after: String,
    comments: &'a [String],
    /// Whether the program ends with this block.
    pub(super) end: bool,
    /// Whether the machine waits after this block.
    pub(super) stops: bool,
    /// The groups of its M words.
    groups: u32,
}

impl<'a> Auxiliary<'a> {
    pub(super) fn new(block: &'a Block) -> Self {
        Self {
            before: Vec::new(),
            after: String::new(),
            comments: &block.comments,
            end: false,
            stops: false,
            groups: 0,
        }
    }

    /// Words by their place in the order of execution.
    pub(super) fn text(&mut self, rank: u8, text: String) {
        if rank == rank::STOP {
            append(&mut self.after, &text);
            return;
        }
        let place = self.before.iter().position(|(other, _)| *other > rank);
        self.before.insert(place.unwrap_or(self.before.len()), (rank, text));
    }

    /// Whether there are words besides comments.
    pub(super) fn has_words(&self) -> bool {
        !(self.before.is_empty() && self.after.is_empty())
    }

    /// What acts before the move, comments included, and what acts after it.
    pub(super) fn finish(self) -> (String, String) {
        let mut before = String::new();
        for (_, text) in &self.before {
            append(&mut before, text);
        }
        for comment in self.comments {
            append(&mut before, comment);
        }
        (before, self.after)
    }
}

fn append(text: &mut String, words: &str) {
    if !text.is_empty() {
        text.push(' ');
    }
    text.push_str(words);
}

/// A word as text.
pub(super) fn word(letter: char, value: f64) -> String {
    let mut text = String::new();
    push_word(&mut text, letter, value);
    text
}

/// Appends a word after a space.
pub(super) fn append_word(text: &mut String, letter: char, value: f64) {
    text.push(' ');
    push_word(text, letter, value);
}

/// Appends the words with these letters as they are.
pub(super) fn take_as_text(words: &mut Words, letters: &str, text: &mut String) {
    for letter in letters.chars() {
        if let Some(found) = words.take(letter) {
            append_word(text, letter, found.value);
        }
    }
}

/// The G50 or G92 of a block that has no axes: it limits the speed of the spindle.
fn speed_limit(block: &Block) -> Option<&Word> {
    let mut limit = None;
    for word in &block.words {
        match word.letter {
            'X' | 'Y' | 'Z' => return None,
            'G' if matches!(tenths(word), Some(500 | 920)) => limit = Some(word),
            _ => {}
        }
    }
    limit
}

/// When an M word acts, by ten times its number, and which letters belong to it.
fn m_word(tenths: u32) -> (u8, &'static str) {
    match tenths {
        0 | 10 | 20 | 300 | 600 => (rank::STOP, ""),
        30 | 40 | 50 => (rank::SPINDLE, ""),
        190 => (rank::SPINDLE, "RPQ"),
        60 => (rank::CHANGE, ""),
        610 => (rank::CHANGE, "Q"),
        70 | 80 | 90 => (rank::COOLANT, ""),
        480 | 490 => (rank::OVERRIDE, ""),
        500..=530 => (rank::OVERRIDE, "P"),
        620..=650 => (rank::OUTPUT, "P"),
        660..=680 => (rank::OUTPUT, "PELQ"),
        1000..=1990 => (rank::USER, "PQ"),
        // Those of firmware.
        2000.. => (rank::USER, "PQRS"),
        _ => (rank::USER, ""),
    }
}

/// Whether a P word of the block may be that of its G words or its cycle.
fn moves_or_waits(block: &Block) -> bool {
    block.words.iter().any(|word| matches!(word.letter, 'G' | 'X'..='Z'))
}

impl Interpreter {
    /// M, S, T and O words.
    pub(super) fn auxiliary_words(
        &mut self,
        block: &Block,
        words: &mut Words,
        auxiliary: &mut Auxiliary,
    ) {
        // The T word acts before M6, wherever in the block it stands.
        if let Some(number) = words.find('T').and_then(|word| whole(word.value)) {
            self.modal.select_tool(number);
        }
        for (index, found) in block.words.iter().enumerate() {
            match found.letter {
                // The time of a dwell.
                'S' if words.is_used(index) => continue,
                'S' => auxiliary.text(rank::SPEED, self.speed(block, found)),
                // Many controllers do not know it: its number is kept as a comment.
                'O' if index == 0 => {
                    let text = format!("({})", word('O', found.value));
                    auxiliary.text(rank::NAME, text);
                }
                'T' if whole(found.value).is_some() => {
                    auxiliary.text(rank::TOOL, word('T', found.value));
                }
                'M' => match tenths(found) {
                    Some(700..=739) => {
                        self.not_supported(block, found.column, "saving modes (M70 to M73)");
                    }
                    Some(number) => self.m_word(block, found, number, words, auxiliary),
                    None => continue,
                },
                _ => continue,
            }
            words.use_up(index);
        }
    }

    /// The S word as it is passed on.
    fn speed(&mut self, block: &Block, found: &Word) -> String {
        // The fastest that the spindle may turn is no speed to turn at.
        if let Some(limit) = speed_limit(block) {
            let mut text = word('G', limit.value);
            append_word(&mut text, 'S', found.value);
            return text;
        }
        if self.rules.is_strict && found.value < 0.0 {
            self.refuse("the speed is negative", block.origin_at(found.column));
        }
        self.modal.feed.set_speed(found.value);
        let feet = self.modal.inches && self.modal.feed.is_surface_speed();
        word('S', if feet { found.value * FOOT } else { found.value })
    }

    fn m_word(
        &mut self,
        block: &Block,
        found: &Word,
        tenths: u32,
        words: &mut Words,
        auxiliary: &mut Auxiliary,
    ) {
        let at = block.origin_at(found.column);
        match tenths {
            20 | 300 => auxiliary.end = true,
            // M600 is Smoothieware's: it stands there for a change of tool.
            0 | 10 | 600 | 6000 => auxiliary.stops = true,
            30 | 40 => self.modal.spindle = Some(tenths / 10),
            50 => self.modal.spindle = None,
            60 | 610 => {
                let number = words.find('Q').filter(|_| tenths == 610);
                if let Some(number) = number.and_then(|word| whole(word.value)) {
                    self.modal.select_tool(number);
                }
                if tenths == 60 || number.is_some() {
                    self.modal.change_tool();
                    self.course.change_tool(&mut self.report);
                }
                if tenths == 60 {
                    self.changed_while_on(block, found, "the tool");
                }
            }
            _ => {}
        }
        let (rank, mut letters) = m_word(tenths);
        if self.rules.is_strict {
            let group = 1 << rank;
            let alone = rank != rank::USER || matches!(tenths, 700..=730 | 980 | 990);
            if !alone && tenths < 1000 {
                self.refuse(&format!("M{} is not known", Decimal::of(found.value)), at);
            } else if auxiliary.groups & group != 0 {
                self.refuse("two M words of one group", at);
            } else if tenths == 610 && block.words.iter().all(|word| word.letter != 'Q') {
                self.refuse("M61 has no Q word", at);
            }
            auxiliary.groups |= group;
        }
        if rank == rank::OUTPUT || rank == rank::OVERRIDE {
            self.not_while_on(block, found);
        }
        if rank == rank::USER && letters.is_empty() && !moves_or_waits(block) {
            // Builders of machines tell their clamps and pallets apart by it.
            letters = "P";
        }
        let mut text = word('M', found.value);
        take_as_text(words, letters, &mut text);
        auxiliary.text(rank, text);
    }

    /// G04: passed on in seconds.
    pub(super) fn dwell(
        &mut self,
        block: &Block,
        dwell: &Word,
        words: &mut Words,
        auxiliary: &mut Auxiliary,
    ) {
        // Firmware for printers takes seconds beside S.
        let letters: &[char] = match self.dialect {
            _ if self.rules.is_strict => &['P'],
            Dialect::Sinumerik => &['F', 'P', 'X'],
            _ => &['P', 'X', 'U', 'S'],
        };
        let time = letters.iter().find_map(|&letter| words.take(letter));
        let Some(time) = time.filter(|time| time.value >= 0.0) else {
            let at = block.origin_at(dwell.column);
            self.error("bad-dwell", "the dwell (G04) has no time", at, "add P in seconds");
            return;
        };
        let seconds = if time.letter == 'P' { self.seconds(block, time) } else { time.value };
        auxiliary.text(rank::DWELL, format!("G4 {}", word('P', seconds)));
    }

    /// The seconds of a P word.
    pub(super) fn seconds(&mut self, block: &Block, time: &Word) -> f64 {
        if self.dialect == Dialect::Fanuc && !time.point {
            return time.value / 1000.0;
        }
        if self.dialect == Dialect::Fanuc {
            let message = format!("P{} with a point is read as seconds", Decimal::of(time.value));
            self.report.warning(
                "dwell-point",
                message,
                block.origin_at(time.column),
                "FANUC takes P in milliseconds, without a point; for seconds write X",
            );
        }
        // No one waits that long on purpose; FANUC counts P in milliseconds.
        if time.value >= 100.0 && self.dialect == Dialect::Auto {
            let message =
                format!("the dwell of {} is passed on in seconds", Decimal::of(time.value));
            self.report.warning(
                "long-dwell",
                message,
                block.origin_at(time.column),
                "where P counts milliseconds, divide it by 1000",
            );
        }
        time.value
    }
}
