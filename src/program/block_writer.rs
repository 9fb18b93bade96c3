//! Writing blocks: only what changes, in as few digits as it needs, as the target reads them.

use glam::DVec3;

use super::number::push_scaled;
use super::target::{Comments, Facts};
use crate::contour::{Plane, Reset};

/// Blocks are numbered in steps of ten, and again from ten where four digits do not suffice.
const NUMBERS: [u32; 2] = [10, 9990];

/// The letters of the axes, and those of the way from an arc's start to its centre along them.
pub(super) const AXES: [[char; 2]; 3] = [['X', 'I'], ['Y', 'J'], ['Z', 'K']];

/// What stands for the motion words of involutes, clockwise and not, and their numbers.
const INVOLUTES: [(char, &str); 2] = [('c', "2.2"), ('a', "3.2")];

/// What became of words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Written {
    /// There were none.
    Nothing,
    All,
    /// Some of them were left out.
    LeftOut,
}

/// A program as it is written, with the modes of the control that will read it.
#[derive(Debug)]
pub(super) struct BlockWriter {
    pub(super) facts: &'static Facts,
    pub(super) text: String,
    /// Units of the last decimal in a millimetre.
    pub(super) scale: f64,
    /// Where the control is, in units of the last decimal.
    pub(super) at: [i64; 3],
    /// Which coordinates a block in their plane need not say where they stay as they are.
    pub(super) known: [bool; 3],
    /// Which coordinates were written since they could be anything.
    pub(super) written: [bool; 3],
    /// Which coordinates the next block that moves says in any case.
    pub(super) states: [bool; 3],
    /// The motion word in effect.
    motion: Option<char>,
    pub(super) plane: Plane,
    /// The F word in effect, and the one asked for: mm/min in units of the last decimal.
    feed: [Option<i64>; 2],
    /// The number of the program.
    pub(super) program: u32,
    /// Whether a word has ended it.
    pub(super) has_ended: bool,
    /// The number of the last block; in Heidenhain's language of the next one.
    number: u32,
    /// Words that are to stand in the next block that moves.
    pub(super) prefix: String,
    /// Axes besides x, y and z that it moves.
    pub(super) suffix: String,
}

impl BlockWriter {
    /// A program of a number.
    pub(super) fn new(facts: &'static Facts, number: u32) -> Self {
        let mut writer = Self {
            facts,
            text: String::new(),
            // At most 4 decimals.
            scale: 10_u64.pow(facts.decimals) as f64,
            at: [0; 3],
            known: [true; 3],
            written: [false; 3],
            states: [false; 3],
            motion: None,
            plane: Plane::Xy,
            feed: [None; 2],
            program: number,
            has_ended: false,
            number: 0,
            prefix: String::new(),
            suffix: String::new(),
        };
        if facts.klartext {
            writer.prefix.push_str("R0");
            writer.program_line("BEGIN");
        }
        if facts.tape {
            let digits = number.to_string();
            writer.text.push_str("%\nO");
            writer.text.extend(std::iter::repeat_n('0', 4_usize.saturating_sub(digits.len())));
            writer.text.push_str(&digits);
            writer.text.push('\n');
        }
        for block in facts.header {
            writer.words(block);
        }
        writer
    }

    pub(super) fn finish(mut self) -> String {
        if self.facts.klartext {
            self.program_line("END");
        } else {
            let prefix = std::mem::take(&mut self.prefix);
            self.words(&prefix);
        }
        if self.facts.must_end && !self.has_ended {
            self.text.insert_str(0, "%\n");
        }
        if self.facts.tape || self.facts.must_end && !self.has_ended {
            self.text.push_str("%\n");
        }
        self.text
    }

    /// A length in units of the last decimal.
    pub(super) fn units(&self, length: f64) -> i64 {
        // Coordinates are at most 1e7 mm, and casts saturate.
        #[expect(clippy::cast_possible_truncation, reason = "at most 1e13")]
        let units = (length * self.scale).round() as i64;
        units
    }

    /// A point in units of the last decimal.
    pub(super) fn place(&self, point: DVec3) -> [i64; 3] {
        [self.units(point.x), self.units(point.y), self.units(point.z)]
    }

    /// Makes the next blocks say their coordinates, even where they seem not to change.
    pub(super) fn forget_place(&mut self) {
        self.known = [false; 3];
    }

    /// Takes the coordinates as words have left them, which were written, left out, or none.
    pub(super) fn reset(&mut self, reset: Reset, words: Written) {
        if words != Written::LeftOut {
            self.at = self.place(reset.at);
        }
        if words == Written::All {
            self.written = [false; 3];
        }
        for i in 0..3 {
            self.states[i] = reset.states[i] && !self.written[i];
        }
    }

    /// The words that were written last say where the control is: at zero.
    pub(super) fn at_zero(&mut self) {
        self.written = [true; 3];
    }

    /// Makes the next block that moves say how.
    pub(super) fn forget_motion(&mut self, feed: bool) {
        self.motion = None;
        if feed {
            self.feed[0] = None;
        }
    }

    /// Asks for a feed [mm/s] from the next feed move on.
    pub(super) fn set_feed(&mut self, feed: f64) {
        let scaled = self.feed_units(feed * 60.0);
        self.feed[1] = Some(scaled);
    }

    fn feed_units(&self, per_minute: f64) -> i64 {
        let scale = 10_u64.pow(self.facts.feed_decimals) as f64;
        #[expect(clippy::cast_possible_truncation, reason = "casts saturate")]
        let scaled = (per_minute * scale).round() as i64;
        scaled.max(1)
    }

    pub(super) fn has_feed(&self) -> bool {
        self.feed[1].is_some()
    }

    /// Words that are to stand at the beginning of the next block that moves.
    pub(super) fn prefix(&mut self, words: &str) {
        if !self.prefix.is_empty() {
            self.prefix.push(' ');
        }
        self.prefix.push_str(words);
    }

    /// Another axis moves with the next block.
    pub(super) fn also(&mut self, letter: char, value: f64) {
        if !self.suffix.is_empty() {
            self.suffix.push(' ');
        }
        let value = self.units(value);
        push_length(&mut self.suffix, letter, value, self.facts);
    }

    /// A block of words as they are.
    pub(super) fn words(&mut self, words: &str) {
        if words.is_empty() {
            return;
        }
        self.begin();
        self.space();
        self.text.push_str(words);
        self.text.push('\n');
    }

    /// A comment in a line of its own, from its text.
    pub(super) fn comment(&mut self, text: &str) {
        self.line_of_comments(&comment(self.facts.comments, text));
    }

    /// Comments in a line of their own, which needs no number.
    pub(super) fn line_of_comments(&mut self, comments: &str) {
        if self.facts.klartext {
            return self.words(comments);
        }
        self.text.push_str(comments);
        self.text.push('\n');
    }

    /// A block that states coordinates [mm] where the control is already, and a feed [mm/min].
    pub(super) fn state(&mut self, motion: char, axes: [Option<f64>; 3], feed: Option<f64>) {
        let mut says = [false; 3];
        for (i, axis) in axes.into_iter().enumerate() {
            if let Some(value) = axis {
                let value = self.units(value);
                says[i] = !self.written[i] || self.at[i] != value;
                self.at[i] = value;
            }
        }
        if let Some(feed) = feed {
            self.feed[1] = Some(self.feed_units(feed));
        }
        if says != [false; 3] || !self.suffix.is_empty() {
            self.block(motion, self.at, says, &[]);
        }
    }

    pub(super) fn rapid(&mut self, to: [i64; 3], plane: Plane) {
        self.straight('0', to, plane);
    }

    pub(super) fn line(&mut self, to: [i64; 3], plane: Plane) {
        self.straight('1', to, plane);
    }

    /// A move in a plane says both of the plane's coordinates where they could be anything.
    fn straight(&mut self, motion: char, to: [i64; 3], plane: Plane) {
        let mut says = [self.at[0] != to[0], self.at[1] != to[1], self.at[2] != to[2]];
        let [first, second, _] = plane.axes();
        if says[first] || says[second] || motion == '0' && self.at == to {
            says[first] |= !self.known[first];
            says[second] |= !self.known[second];
        }
        if says != [false; 3] || self.states != [false; 3] {
            self.block(motion, to, says, &[]);
        }
    }

    /// An arc in a plane to `to`, about the point that is `center` away from where the control is,
    /// along the plane's axes; a full circle where `to` is where the control is.
    pub(super) fn arc(&mut self, clockwise: bool, plane: Plane, to: [i64; 3], center: [i64; 2]) {
        self.round(if clockwise { '2' } else { '3' }, plane, to, center, 0);
    }

    /// An involute in a plane to `to`, of a circle of `radius` about the point that is `center` away
    /// from where the control is, along the plane's axes.
    pub(super) fn involute(
        &mut self,
        clockwise: bool,
        plane: Plane,
        to: [i64; 3],
        center: [i64; 2],
        radius: i64,
    ) {
        let motion = if clockwise { INVOLUTES[0].0 } else { INVOLUTES[1].0 };
        self.round(motion, plane, to, center, radius);
    }

    fn round(&mut self, motion: char, plane: Plane, to: [i64; 3], center: [i64; 2], radius: i64) {
        let mut says = [self.at[0] != to[0], self.at[1] != to[1], self.at[2] != to[2]];
        let [first, second, _] = plane.axes();
        let full = !says[first] && !says[second];
        says[first] |= full || !self.known[first];
        says[second] |= full || !self.known[second];
        self.choose(plane);
        let offsets = [(AXES[first][1], center[0]), (AXES[second][1], center[1]), ('R', radius)];
        self.block(motion, to, says, &offsets);
    }

    /// The plane of the next block, which other languages tell by its axes.
    fn choose(&mut self, plane: Plane) {
        if self.plane != plane && !self.facts.klartext {
            self.prefix(["G17", "G18", "G19"][plane as usize]);
        }
        self.plane = plane;
    }

    /// A cubic in the plane of x and y whose inner control points are so far from its ends.
    pub(super) fn cubic(&mut self, to: [i64; 3], controls: [[i64; 2]; 2]) {
        let says = [true, true, self.at[2] != to[2]];
        self.choose(Plane::Xy);
        let [[i, j], [p, q]] = controls;
        self.block('5', to, says, &[('I', i), ('J', j), ('P', p), ('Q', q)]);
    }

    fn block(&mut self, motion: char, to: [i64; 3], says: [bool; 3], offsets: &[(char, i64)]) {
        if self.facts.klartext {
            return self.klartext(motion, to, says, offsets);
        }
        self.begin();
        if !self.prefix.is_empty() {
            self.space();
            self.text.push_str(&self.prefix);
            self.prefix.clear();
        }
        if self.motion != Some(motion) || !self.facts.modal {
            self.space();
            self.text.push('G');
            match INVOLUTES.iter().find(|(letter, _)| *letter == motion) {
                Some((_, number)) => self.text.push_str(number),
                None => self.text.push(motion),
            }
            self.motion = Some(motion);
        }
        let stated = std::mem::take(&mut self.states);
        for i in 0..3 {
            if says[i] || stated[i] {
                self.length(AXES[i][0], to[i]);
                self.known[i] = true;
                self.written[i] = true;
            }
        }
        self.others();
        for &(letter, value) in offsets {
            // A cubic says all four: left out they would be those of the cubic before.
            if value != 0 || motion == '5' {
                self.length(letter, value);
            }
        }
        if motion != '0' {
            self.feed();
        }
        self.text.push('\n');
        self.at = to;
    }

    /// The other axes that move with the block.
    pub(super) fn others(&mut self) {
        if !self.suffix.is_empty() {
            self.space();
            self.text.push_str(&self.suffix);
            self.suffix.clear();
        }
    }

    /// The F word, where it is not in effect yet.
    pub(super) fn feed(&mut self) {
        let [in_effect, wanted] = self.feed;
        if wanted != in_effect
            && let Some(feed) = wanted
        {
            self.space();
            self.text.push('F');
            push_scaled(&mut self.text, feed, self.facts.feed_decimals);
            self.feed[0] = wanted;
        }
    }

    /// The number of a block, where blocks have one.
    pub(super) fn begin(&mut self) {
        if self.facts.tape {
            let [step, most] = NUMBERS;
            self.number = if self.number >= most { step } else { self.number + step };
            self.text.push('N');
            push_scaled(&mut self.text, i64::from(self.number), 0);
        } else if self.facts.klartext {
            push_scaled(&mut self.text, i64::from(self.number), 0);
            self.number += 1;
        }
    }

    /// A space before every word but the first.
    pub(super) fn space(&mut self) {
        if !self.text.is_empty() && !self.text.ends_with('\n') {
            self.text.push(' ');
        }
    }

    pub(super) fn length(&mut self, letter: char, scaled: i64) {
        self.space();
        push_length(&mut self.text, letter, scaled, self.facts);
    }
}

/// Writes a word of a length in units of the last decimal.
pub(super) fn push_length(text: &mut String, letter: char, scaled: i64, facts: &Facts) {
    text.push(letter);
    if facts.klartext && scaled >= 0 {
        text.push('+');
    }
    let before = text.len();
    push_scaled(text, scaled, facts.decimals);
    if facts.point && !text.as_bytes()[before..].contains(&b'.') {
        text.push('.');
    }
}

/// A comment as a target knows them, from its text.
pub(super) fn comment(style: Comments, text: &str) -> String {
    let mut comment = String::with_capacity(text.len() + 2);
    comment.push(if style == Comments::Semicolon { ';' } else { '(' });
    for letter in text.chars() {
        comment.push(match (style, letter) {
            (Comments::Semicolon, letter) => letter,
            (_, '(') => '[',
            (_, ')') => ']',
            (Comments::Parentheses, letter) if !letter.is_ascii() => '?',
            (Comments::Parentheses, letter) => letter.to_ascii_uppercase(),
            (Comments::Both, letter) => letter,
        });
    }
    if style != Comments::Semicolon {
        comment.push(')');
    }
    comment
}
