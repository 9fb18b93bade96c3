//! Reading one line of text: words, comments, assignments, block delete, and what is none of these.

use super::block::{Block, Word};
use super::cursor::Cursor;
use super::dialect::Dialect;
use super::expression::{Fault, is_system};
use super::flow::Destination;
use super::interpret::Interpreter;
use super::macros::calls;
use super::number::{NumberError, whole};
use super::parameters::{FAILED, Parameters, Setting, Target, UNSET};

/// Most words of a block. Controls allow about 250 characters; a line without end is no block.
const MOST_WORDS: usize = 100;

/// Most characters of the text that a message quotes.
const MOST_QUOTED: usize = 20;

/// Most letters that may be words whose numbers were forgotten, and no name.
const LONGEST_LETTERS: usize = 2;

/// Largest number a word may have, as [`super::number`] reads them.
const LARGEST: f64 = 1e9;

/// Reads one line into a block.
#[derive(Debug)]
pub(super) struct LineReader<'a> {
    pub(super) cursor: Cursor<'a>,
    pub(super) dialect: Dialect,
    pub(super) parameters: &'a Parameters,
    pub(super) interpreter: &'a mut Interpreter,
    pub(super) block: &'a mut Block,
    /// The assignments of the block.
    pub(super) settings: &'a mut Vec<Setting>,
    /// How deep an expression is nested.
    pub(super) depth: u32,
    /// Whether blocks with `/` are skipped.
    pub(super) block_delete: bool,
    /// Where GOTO leads to, and its column.
    pub(super) jump: Option<(Destination, u32)>,
    /// Whether a word calls a subprogram or returns from one.
    pub(super) calls: bool,
}

impl LineReader<'_> {
    /// `/` with the number of its switch, and N. False where the block is to be skipped.
    pub(super) fn head(&mut self) -> bool {
        while let Some(c) = self.cursor.peek() {
            let from = self.cursor.at();
            match c {
                b'/' => {
                    self.cursor.skip();
                    // Two of them begin a comment.
                    if !self.interpreter.rules.is_strict && self.cursor.eat(b'/') {
                        self.cursor.skip_all();
                        return false;
                    }
                    // A digit names the switch.
                    if matches!(self.cursor.peek(), Some(b'0'..=b'9')) {
                        self.cursor.skip();
                    }
                    self.block.skippable = true;
                    if self.block_delete {
                        self.cursor.skip_all();
                        return false;
                    }
                }
                b'N' => {
                    self.cursor.skip();
                    match self.cursor.number(true) {
                        Ok(number) => self.block.number = whole(number.trunc()),
                        Err(_) if self.name_follows() => {
                            self.cursor.set(from);
                            return true;
                        }
                        Err(error) => self.bad_number(error, from),
                    }
                }
                _ => return true,
            }
        }
        true
    }

    /// Reads the words, assignments and comments up to the end of the line.
    pub(super) fn elements(&mut self) {
        while let Some(c) = self.cursor.peek() {
            self.element(c);
        }
    }

    /// Reads comments; of other words after an O word it is said that they have no effect.
    pub(super) fn only_comments(&mut self) {
        while let Some(c) = self.cursor.peek() {
            if matches!(c, b'(' | b';') {
                self.comment(c);
                continue;
            }
            let from = self.cursor.at();
            self.cursor.skip_all();
            let message = format!("{} has no meaning here", quote(self.cursor.since(from)));
            self.error("words-after-flow", message, from, "put it into a block of its own");
        }
    }

    /// A value, or [`FAILED`] where there is none.
    pub(super) fn argument(&mut self) -> f64 {
        self.cursor.peek();
        let from = self.cursor.at();
        self.value().unwrap_or_else(|fault| {
            self.report_fault(&fault, from, "it has no value");
            self.cursor.skip_all();
            FAILED
        })
    }

    /// Whether the condition that comes next holds: not 0.
    pub(super) fn holds(&mut self) -> bool {
        self.cursor.peek();
        let from = self.cursor.at();
        // Others put it into brackets.
        let bare = self.dialect == Dialect::Sinumerik;
        match if bare { self.expression(1) } else { self.value() } {
            Ok(value) => value != 0.0 && !value.is_nan(),
            Err(fault) => {
                self.report_fault(&fault, from, "it counts as false");
                self.cursor.skip_all();
                false
            }
        }
    }

    /// Reads what begins with `c`.
    fn element(&mut self, c: u8) {
        let from = self.cursor.at();
        match c {
            b'(' | b';' => self.comment(c),
            b'I' if self.cursor.eat_all("IF[") => self.condition(),
            b'G' if self.dialect != Dialect::Sinumerik && self.cursor.eat_all("GOTO") => {
                let column = self.cursor.column(from);
                match self.value() {
                    Ok(number) => self.jump = Some((Destination::Number(number), column)),
                    Err(fault) => self.report_fault(&fault, from, "it is left out"),
                }
                self.cursor.skip_all();
            }
            // LinuxCNC has the signs for polar coordinates.
            b'A'..=b'Z' | b'@' | b'^' => self.word(c),
            b'_' | b'$' if self.dialect == Dialect::Sinumerik => self.word(c),
            // The number of a program, as O.
            b':' if self.block.words.is_empty() && self.dialect != Dialect::Sinumerik => {
                self.word(b'O');
            }
            b'#' => self.assignment(),
            b',' if self.comma_word() => {}
            b'[' => {
                let value = self.value();
                let nothing =
                    Fault { code: "bad-expression", message: "it has no letter", at: from };
                self.report_fault(value.as_ref().err().unwrap_or(&nothing), from, "it is left out");
            }
            b'0'..=b'9' | b'+' | b'-' | b'.' => {
                // What it is, does not matter.
                let _ = self.cursor.number(true);
                let message =
                    format!("the number {} has no letter", quote(self.cursor.since(from)));
                self.error("number-without-letter", message, from, "it is left out");
            }
            _ => self.unexpected(),
        }
    }

    fn unexpected(&mut self) {
        let from = self.cursor.at();
        let text = self.cursor.take_while(&|c: char| {
            let known = matches!(c, '(' | ';' | '#' | '[' | '+' | '-' | '.' | '@' | '^');
            !(c.is_ascii_alphanumeric() || c.is_ascii_whitespace() || c == '\x0b' || known)
        });
        if from == 0 && text.starts_with('$') {
            self.cursor.skip_all();
            let hint = "it is left out; give it to the controller by hand";
            return self.warn("left-out", from, "no block, but an order to a controller", hint);
        }
        // Spaces of other alphabets are spaces.
        if !text.chars().all(char::is_whitespace) {
            let message = format!("{} is no part of a program", quote(text));
            self.error("unexpected-character", message, from, "it is left out");
        }
    }

    fn comment(&mut self, opening: u8) {
        let from = self.cursor.at();
        let text = self.cursor.rest();
        let end = if opening == b'(' { text.find(')').map(|i| i + 1) } else { None };
        let text = text.get(..end.unwrap_or(text.len())).unwrap_or_default();
        self.cursor.set(from + text.len());
        let mut comment: String = text.trim_end().chars().filter(|c| !c.is_control()).collect();
        if opening == b'(' && end.is_none() {
            comment.push(')');
            let origin = self.block.origin_at(self.cursor.column(from));
            let hint = "the rest of the line counts as comment";
            let report = &mut self.interpreter.report;
            report.warning("unclosed-comment", "the comment has no end", origin, hint);
        }
        // Comments that say nothing; FANUC's blocks end with `;`.
        if !matches!(&*comment, ";" | "()") {
            self.block.comments.push(comment);
        }
    }

    /// `IF […]` before GOTO or THEN: what follows counts only where it is true.
    fn condition(&mut self) {
        // The bracket was read already.
        self.cursor.set(self.cursor.at() - 1);
        if self.holds() {
            self.cursor.eat_all("THEN");
        } else {
            self.cursor.skip_all();
        }
    }

    /// `#1=…`.
    fn assignment(&mut self) {
        let from = self.cursor.at();
        self.cursor.skip();
        match self.target() {
            Ok(target) if self.cursor.eat(b'=') => self.set(target, from),
            Ok(_) => {
                let nothing =
                    Fault { code: "bad-expression", message: "it has no letter", at: from };
                self.report_fault(&nothing, from, "it is left out");
            }
            Err(fault) => {
                self.report_fault(&fault, from, "the rest of the block is left out");
                self.cursor.skip_all();
            }
        }
    }

    /// The value after `=`.
    pub(super) fn set(&mut self, target: Target, from: usize) {
        let column = self.cursor.column(from);
        let value = match self.expression(1) {
            Ok(value) => value,
            Err(fault) => {
                self.report_fault(
                    &fault,
                    from,
                    "the parameter has no value now; the rest is left out",
                );
                self.cursor.skip_all();
                FAILED
            }
        };
        let system = match &target {
            // FANUC's vacant variable cannot be filled.
            Target::Number(0) => self.dialect != Dialect::Sinumerik,
            // 3000 raises an alarm, 3006 shows a message and stops.
            Target::Number(3000 | 3006) => false,
            // Whether DEBUG comments are shown anyone may say.
            Target::Number(5599) => self.dialect == Dialect::Fanuc,
            Target::Number(number) => is_system(*number, self.dialect),
            Target::Name(name) | Target::Whole(name) => {
                self.interpreter.system_name(name).is_some()
            }
        };
        if system {
            let fault =
                Fault { code: "bad-parameter", message: "the parameter cannot be set", at: from };
            self.report_fault(&fault, from, "the assignment is left out; set it on the machine");
        } else {
            self.settings.push(Setting { target, value, column });
        }
    }

    pub(super) fn word(&mut self, letter: u8) {
        let from = self.cursor.at();
        let point;
        if self.dialect == Dialect::Sinumerik && self.name_word() {
            return;
        }
        self.cursor.skip();
        let value = match self.cursor.peek() {
            Some(b'0'..=b'9' | b'.' | b'+' | b'-') => {
                let at = self.cursor.at();
                let number = self.cursor.number(true);
                point = self.cursor.since(at).as_bytes().contains(&b'.');
                let signs =
                    !self.cursor.since(at).contains(|c: char| c.is_ascii_digit() || c == '.');
                match number {
                    Ok(value) if self.cursor.peek() == Some(b'=') => {
                        self.address(letter, value, from);
                        return;
                    }
                    Ok(value) => self.pointed(letter, value, point, from),
                    Err(NumberError::Garbled) if signs && self.value_follows() => {
                        self.cursor.set(at);
                        return self.evaluated_word(letter, from);
                    }
                    Err(error) => return self.bad_number(error, from),
                }
            }
            Some(b'=') => {
                self.cursor.skip();
                return self.assigned(letter, from);
            }
            _ if self.value_follows() => return self.evaluated_word(letter, from),
            _ => {
                // Of a name it is said once that it is none.
                self.cursor.set(from);
                let name = self.cursor.identifier();
                if name.len() > LONGEST_LETTERS {
                    return self.unknown_name(name, from);
                }
                self.cursor.set(from + 1);
                let homes = |word: &Word| word.letter == 'G' && word.value == 28.0;
                if self.dialect != Dialect::Auto
                    || !matches!(letter, b'X' | b'Y' | b'Z')
                    || !self.block.words.iter().any(homes)
                {
                    return self.bad_number(NumberError::Missing, from);
                }
                // `G28 X` of controllers of printers: that axis goes home, from where it is.
                point = false;
                UNSET
            }
        };
        let column = self.cursor.column(from);
        self.accept(Word { letter: char::from(letter), value, column, point }, from);
        let shows = letter == b'M' && matches!(whole(value), Some(117 | 118));
        if shows && self.dialect == Dialect::Auto && !self.interpreter.rules.is_strict {
            // What follows is a text for the display.
            let text = self.cursor.rest().trim();
            self.block.comments.push(format!("({})", text.replace(['(', ')'], "")));
            self.cursor.skip_all();
        }
    }

    /// Whether something comes next that is evaluated.
    fn value_follows(&mut self) -> bool {
        match self.cursor.peek() {
            Some(b'#' | b'[') => true,
            Some(b'A'..=b'Z') => {
                let at = self.cursor.at();
                let function = self.function_name();
                self.cursor.set(at);
                function.is_some()
            }
            _ => false,
        }
    }

    fn evaluated_word(&mut self, letter: u8, from: usize) {
        let value = self.value();
        self.accept_value(letter, value, from);
    }

    pub(super) fn accept_value(&mut self, letter: u8, value: Result<f64, Fault>, from: usize) {
        match value {
            // A word with FANUC's vacant variable is as good as not there.
            Ok(value) if value.is_nan() => {}
            Ok(value) if value.abs() > LARGEST => self.bad_number(NumberError::TooLarge, from),
            Ok(value) => {
                let column = self.cursor.column(from);
                // Whole numbers out of expressions are rarely whole to the last bit.
                let round = value.round();
                let near = matches!(letter, b'G' | b'M' | b'T' | b'D' | b'H' | b'P' | b'L')
                    && (value - round).abs() < 1e-4;
                let value = if near { round } else { value };
                self.accept(Word { letter: char::from(letter), value, column, point: false }, from);
            }
            Err(fault) => {
                self.report_fault(&fault, from, "the word is left out");
                self.resume(from);
            }
        }
    }

    /// After a fault in the value of a word: goes on behind the value.
    fn resume(&mut self, from: usize) {
        if self.parentheses() {
            self.cursor.take_while(&|c: char| !c.is_ascii_whitespace());
            return;
        }
        self.cursor.set(from);
        self.cursor.skip();
        let mut depth = 0_u32;
        while let Some(c) = self.cursor.peek() {
            match c {
                b'(' | b';' if depth == 0 => return,
                b'<' => {
                    self.cursor.until('>');
                }
                b'[' => depth += 1,
                b']' => {
                    depth = depth.saturating_sub(1);
                    self.cursor.skip();
                    // The second argument of ATAN.
                    if depth == 0 && self.cursor.peek() != Some(b'/') {
                        return;
                    }
                    continue;
                }
                b'A'..=b'Z' if depth == 0 && self.function_name().is_none() => return,
                _ => {}
            }
            if self.cursor.peek().is_some_and(|c| c.is_ascii()) {
                self.cursor.skip();
            } else {
                self.cursor.take_while(&|c: char| !c.is_ascii());
            }
        }
    }

    /// Whether a name of two letters or more comes next.
    fn name_follows(&mut self) -> bool {
        let rest = self.cursor.rest().as_bytes();
        rest.first().is_some_and(u8::is_ascii_alphabetic)
    }

    /// Adds a word that no number was written for.
    pub(super) fn push(&mut self, letter: char, value: f64, from: usize) {
        let column = self.cursor.column(from);
        self.accept(Word { letter, value, column, point: false }, from);
    }

    /// Adds a word; of two with one letter the later counts, G and M words and the arguments of a
    /// macro apart.
    fn accept(&mut self, word: Word, from: usize) {
        if self.returns(&word) {
            self.jump = Some((Destination::Return, word.column));
            return;
        }
        let words = &mut self.block.words;
        if words.len() == MOST_WORDS {
            let message = format!("the block has more than {MOST_WORDS} words");
            self.error("too-many-words", message, from, "the rest of it is left out");
            self.cursor.skip_all();
            return;
        }
        match word.letter {
            'G' => self.calls |= matches!(whole(word.value), Some(65..=67)),
            'M' => self.calls |= calls(word.value, self.interpreter.rules.is_strict),
            'I' | 'J' | 'K' if self.calls => {}
            _ => {
                if let Some(i) = words.iter().position(|w| w.letter == word.letter) {
                    words.remove(i);
                    let message = format!("the block has two {} words", word.letter);
                    self.error("repeated-word", message, from, "the later one counts");
                }
            }
        }
        self.block.words.push(word);
    }

    fn bad_number(&mut self, error: NumberError, from: usize) {
        let text = quote(self.cursor.since(from).trim_end());
        let (code, message) = match error {
            NumberError::Missing => ("missing-number", format!("the word {text} has no number")),
            NumberError::Garbled => {
                ("garbled-number", format!("{text} has no number that can be read"))
            }
            NumberError::TooLarge => {
                ("number-too-large", format!("the number of {text} is beyond 1e9"))
            }
        };
        self.error(code, message, from, "the word is left out");
    }

    pub(super) fn error(&mut self, code: &'static str, message: String, from: usize, hint: &str) {
        let origin = self.block.origin_at(self.cursor.column(from));
        self.interpreter.error(code, message, origin, hint);
    }

    /// Reports why there is no value of what began at `from`.
    pub(super) fn report_fault(&mut self, fault: &Fault, from: usize, hint: &str) {
        let message = format!("{}: {}", quote(self.cursor.since(from).trim()), fault.message);
        self.error(fault.code, message, fault.at, hint);
    }

    pub(super) fn warn(&mut self, code: &'static str, at: usize, what: &str, hint: &str) {
        let message = format!("{}: {what}", quote(self.cursor.since(at)));
        let origin = self.block.origin_at(self.cursor.column(at));
        self.interpreter.report.warning(code, message, origin, hint);
    }
}

/// The text for a message: short, and without characters that cannot be shown.
pub(super) fn quote(text: &str) -> String {
    let mut quoted: String = text
        .chars()
        .take(MOST_QUOTED)
        .map(|c| if c.is_control() { '\u{fffd}' } else { c })
        .collect();
    if text.chars().nth(MOST_QUOTED).is_some() {
        quoted.push('…');
    }
    quoted
}
