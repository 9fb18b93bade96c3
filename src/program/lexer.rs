//! Reading one line of text: words, comments, block delete, and what is none of these.

use super::block::{Block, Word};
use super::number::{NumberError, parse_number, whole};
use super::report::Report;

/// Most words of a block. Controls allow about 250 characters; a line without end is no block.
const MOST_WORDS: usize = 100;

/// Most characters of the text that a message quotes.
const MOST_QUOTED: usize = 20;

/// What follows the number of an O word where it is control flow and not a program number.
const FLOW_WORDS: [&str; 13] = [
    "sub",
    "endsub",
    "call",
    "return",
    "do",
    "while",
    "endwhile",
    "if",
    "elseif",
    "else",
    "endif",
    "repeat",
    "endrepeat",
];

/// What one line is.
pub(super) enum Line {
    /// Nothing but space.
    Blank,
    /// `%`, which opens and ends a program.
    Percent,
    /// A block, maybe without words.
    Block(Block),
}

/// Reads line number `line`, counted from 1.
pub(super) fn read_line(text: &str, line: u32, report: &mut Report) -> Line {
    let block = Block { line, ..Block::default() };
    let mut lexer = Lexer { rest: text, column: 1, block, report, at_start: true };
    lexer.skip_space();
    if lexer.rest.is_empty() {
        return Line::Blank;
    }
    if lexer.rest.starts_with('%') {
        return Line::Percent;
    }
    while let Some(c) = lexer.peek() {
        lexer.element(c);
        lexer.skip_space();
    }
    Line::Block(lexer.block)
}

/// A place in a line, and the block as read so far.
struct Lexer<'a> {
    rest: &'a str,
    column: u32,
    block: Block,
    report: &'a mut Report,
    /// Whether nothing but space, `/` and N was read yet.
    at_start: bool,
}

impl<'a> Lexer<'a> {
    fn peek(&self) -> Option<char> {
        self.rest.chars().next()
    }

    /// Moves on by the first `bytes` of the rest, which are whole characters, and returns them.
    fn take(&mut self, bytes: usize) -> &'a str {
        let (taken, rest) = self.rest.split_at_checked(bytes).unwrap_or((self.rest, ""));
        self.rest = rest;
        let characters = u32::try_from(taken.chars().count()).unwrap_or(u32::MAX);
        self.column = self.column.saturating_add(characters);
        taken
    }

    fn take_while(&mut self, belongs: impl Fn(char) -> bool) -> &'a str {
        let bytes = self.rest.find(|c| !belongs(c)).unwrap_or(self.rest.len());
        self.take(bytes)
    }

    fn skip_space(&mut self) {
        self.take_while(char::is_whitespace);
    }

    fn error(&mut self, code: &'static str, message: impl Into<String>, column: u32, hint: &str) {
        self.report.error(code, message, self.block.origin_at(column), hint);
    }

    /// Reads what begins with `c`.
    fn element(&mut self, c: char) {
        let at_start = std::mem::replace(&mut self.at_start, false);
        match c {
            '/' if at_start => {
                self.take(1);
                // A digit names the switch.
                if self.peek().is_some_and(|c| c.is_ascii_digit()) {
                    self.take(1);
                }
                self.block.skippable = true;
                self.at_start = true;
            }
            '(' | ';' => self.comment(c),
            'O' | 'o' if at_start && self.is_flow() => {
                let column = self.column;
                self.error(
                    "unsupported-flow",
                    "subprograms and loops (O words) are not supported",
                    column,
                    "the block is left out; write the blocks out one by one",
                );
                self.skip_block();
            }
            c if c.is_ascii_alphabetic() => self.word(c.to_ascii_uppercase(), at_start),
            '#' | '[' => {
                self.expression();
                self.skip_block();
            }
            c if is_number(c) => {
                let column = self.column;
                let text = self.take_while(is_number);
                let message = format!("the number {} has no letter", quote(text));
                self.error("number-without-letter", message, column, "it is left out");
            }
            _ => {
                let column = self.column;
                let text = self.take_while(|c| {
                    let known = matches!(c, '(' | ';' | '#' | '[' | '+' | '-' | '.');
                    !(c.is_ascii_alphanumeric() || c.is_whitespace() || known)
                });
                let message = format!("{} is no part of a program", quote(text));
                self.error("unexpected-character", message, column, "it is left out");
            }
        }
    }

    fn comment(&mut self, opening: char) {
        let column = self.column;
        let end = if opening == '(' { self.rest.find(')').map(|i| i + 1) } else { None };
        let text = self.take(end.unwrap_or(self.rest.len()));
        let mut comment: String = text.trim_end().chars().filter(|c| !c.is_control()).collect();
        if opening == '(' && end.is_none() {
            comment.push(')');
            let origin = self.block.origin_at(column);
            let hint = "the rest of the line counts as comment";
            self.report.warning("unclosed-comment", "the comment has no end", origin, hint);
        }
        self.block.comments.push(comment);
    }

    /// Whether the O word ahead calls or defines a subprogram.
    fn is_flow(&self) -> bool {
        let after = self.rest.get(1..).unwrap_or_default().trim_start();
        let name = after.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start();
        let word = name.split(|c: char| !c.is_ascii_alphabetic()).next().unwrap_or_default();
        after.starts_with('<') || FLOW_WORDS.iter().any(|flow| word.eq_ignore_ascii_case(flow))
    }

    fn word(&mut self, letter: char, at_start: bool) {
        let column = self.column;
        self.take(1);
        self.skip_space();
        if matches!(self.peek(), Some('#' | '[')) {
            self.expression();
            return;
        }
        let text = self.take_while(is_number);
        match parse_number(text) {
            Ok(value) if letter == 'N' && at_start => {
                self.block.number = whole(value.trunc());
                self.at_start = true;
            }
            Ok(value) => self.accept(Word { letter, value, column }),
            Err(NumberError::Missing) => {
                let message = format!("the word {letter} has no number");
                self.error("missing-number", message, column, "the word is left out");
            }
            Err(NumberError::Garbled) => {
                let message = format!("{letter}{} has no number that can be read", quote(text));
                self.error("garbled-number", message, column, "the word is left out");
            }
            Err(NumberError::TooLarge) => {
                let message = format!("the number of {letter}{} is beyond 1e9", quote(text));
                self.error("number-too-large", message, column, "the word is left out");
            }
        }
    }

    /// Adds a word; of two with one letter the later counts, G and M words apart.
    fn accept(&mut self, word: Word) {
        if self.block.words.len() == MOST_WORDS {
            let message = format!("the block has more than {MOST_WORDS} words");
            self.error("too-many-words", message, word.column, "the rest of it is left out");
            self.skip_block();
            return;
        }
        if !matches!(word.letter, 'G' | 'M')
            && let Some(i) = self.block.words.iter().position(|w| w.letter == word.letter)
        {
            let message = format!("the block has two {} words", word.letter);
            self.error("repeated-word", message, word.column, "the later one counts");
            self.block.words.remove(i);
        }
        self.block.words.push(word);
    }

    /// Reports a variable or an expression and moves over it.
    fn expression(&mut self) {
        let column = self.column;
        self.error(
            "unsupported-expression",
            "variables (#) and expressions ([ ]) are not supported",
            column,
            "the word is left out; write its number",
        );
        let end = if self.peek() == Some('[') {
            let mut depth = 0_u32;
            self.rest.char_indices().find_map(|(i, c)| {
                match c {
                    '[' => depth += 1,
                    ']' => depth -= 1,
                    _ => {}
                }
                (depth == 0).then_some(i + 1)
            })
        } else {
            self.take_while(|c| c == '#');
            match self.peek() {
                Some('<') => self.rest.find('>').map(|i| i + 1),
                _ => self.rest.find(|c: char| !c.is_ascii_digit()),
            }
        };
        self.take(end.unwrap_or(self.rest.len()));
    }

    fn skip_block(&mut self) {
        self.take(self.rest.len());
    }
}

fn is_number(c: char) -> bool {
    c.is_ascii_digit() || matches!(c, '+' | '-' | '.')
}

/// The text for a message: short, and without characters that cannot be shown.
fn quote(text: &str) -> String {
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
