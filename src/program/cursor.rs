//! A place in a line, which moves on as the line is read.
//!
//! RS274/NGC allows spaces anywhere but in comments, inside numbers and names too, so whatever looks
//! at the next character here passes over them.

use super::number::{NumberError, parse_number};

/// A line and how far it was read.
#[derive(Debug, Clone)]
pub(super) struct Cursor<'a> {
    line: &'a str,
    at: usize,
    /// A place [bytes] and its column, from which the next is counted on.
    counted: (usize, u32),
}

impl<'a> Cursor<'a> {
    pub(super) fn new(line: &'a str, at: usize) -> Self {
        Self { line, at: at.min(line.len()), counted: (0, 1) }
    }

    /// How far the line was read [bytes].
    pub(super) fn at(&self) -> usize {
        self.at
    }

    pub(super) fn set(&mut self, at: usize) {
        self.at = at;
    }

    /// The column of a place, counted from 1 in characters.
    pub(super) fn column(&mut self, at: usize) -> u32 {
        // Without counting on, a long line of faults would take the square of its length.
        let (from, column) = if at < self.counted.0 { (0, 1) } else { self.counted };
        let before = self.line.as_bytes().get(from..at).unwrap_or_default();
        // Bytes that do not continue a character begin one.
        let characters = before.iter().filter(|&&byte| byte & 0xc0 != 0x80).count();
        let column = column.saturating_add(u32::try_from(characters).unwrap_or(u32::MAX));
        self.counted = (at, column);
        column
    }

    /// The text from `from` to where reading is.
    pub(super) fn since(&self, from: usize) -> &'a str {
        self.line.get(from..self.at).unwrap_or_default()
    }

    /// What was not read.
    pub(super) fn rest(&self) -> &'a str {
        self.line.get(self.at..).unwrap_or_default()
    }

    /// The next character, a capital, that is no space; reading moves up to it. Only the first byte
    /// of a character that is not ASCII.
    pub(super) fn peek(&mut self) -> Option<u8> {
        loop {
            let byte = *self.line.as_bytes().get(self.at)?;
            if byte > b' ' || !byte.is_ascii_whitespace() && byte != 0x0b {
                return Some(byte.to_ascii_uppercase());
            }
            self.at += 1;
        }
    }

    /// Moves over one character that [`Cursor::peek`] has shown, which has to be ASCII.
    pub(super) fn skip(&mut self) {
        self.at += 1;
    }

    /// Moves over everything.
    pub(super) fn skip_all(&mut self) {
        self.at = self.line.len();
    }

    /// Moves up to the first character that does not belong, without passing over spaces.
    pub(super) fn take_while(&mut self, belongs: &dyn Fn(char) -> bool) -> &'a str {
        let rest = self.rest();
        let taken = rest.find(|c| !belongs(c)).unwrap_or(rest.len());
        self.at += taken;
        rest.get(..taken).unwrap_or_default()
    }

    /// Moves up to the first `sign`, without passing over spaces.
    pub(super) fn until(&mut self, sign: char) -> &'a str {
        self.take_while(&|c: char| c != sign)
    }

    /// Moves over `sign` if it comes next.
    pub(super) fn eat(&mut self, sign: u8) -> bool {
        let is_next = self.peek() == Some(sign);
        self.at += usize::from(is_next);
        is_next
    }

    /// Moves over the capitals or signs of `text` if they come next.
    pub(super) fn eat_all(&mut self, text: &str) -> bool {
        let from = self.at;
        for sign in text.bytes() {
            if !self.eat(sign) {
                self.at = from;
                return false;
            }
        }
        true
    }

    /// Letters, digits and `_`, as far as they go.
    pub(super) fn identifier(&mut self) -> &'a str {
        self.take_while(&|c: char| c.is_ascii_alphanumeric() || c == '_')
    }

    /// The number that comes next: digits with points and, where `signed`, signs, as far as they
    /// go.
    pub(super) fn number(&mut self, signed: bool) -> Result<f64, NumberError> {
        let belongs = |c: char| c.is_ascii_digit() || c == '.' || signed && matches!(c, '+' | '-');
        self.peek();
        let text = self.take_while(&belongs);
        let end = self.at;
        if !self.peek().is_some_and(|c| belongs(char::from(c))) {
            self.at = end;
            return parse_number(text);
        }
        let mut text = text.to_owned();
        while self.peek().is_some_and(|c| belongs(char::from(c))) {
            text.push_str(self.take_while(&belongs));
        }
        parse_number(&text)
    }

    /// The digits that come next, if they are a number that can count something.
    pub(super) fn digits(&mut self) -> Option<u32> {
        let mut number = None::<u32>;
        while let Some(digit @ b'0'..=b'9') = self.peek() {
            self.skip();
            number =
                Some(number.unwrap_or(0).checked_mul(10)?.checked_add(u32::from(digit - b'0'))?);
        }
        number
    }

    /// The name in `<>` that comes next: small letters without spaces.
    pub(super) fn name(&mut self) -> Option<String> {
        if !self.eat(b'<') {
            return None;
        }
        let text = self.until('>');
        if !self.eat(b'>') {
            return None;
        }
        let name = text.chars().filter(|c| !c.is_whitespace());
        Some(name.map(|c| c.to_ascii_lowercase()).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spaces_are_passed_over_wherever_they_stand() {
        let mut cursor = Cursor::new(" g 0 x +0. 12 34y 7", 0);
        assert!(cursor.eat_all("G0X"), "letters");
        assert_eq!(cursor.number(true), Ok(0.1234), "the number of the documentation's example");
        assert!(cursor.eat(b'Y'), "the next word");
        assert_eq!(cursor.number(true), Ok(7.0), "its number");
        assert_eq!(cursor.peek(), None, "the end");
    }

    #[test]
    fn columns_count_characters() {
        let mut cursor = Cursor::new("(€) X1", 0);
        assert_eq!(cursor.column("(€) ".len()), 5, "the euro sign is one");
        assert_eq!(cursor.column("(€) X".len()), 6, "counted on");
        assert_eq!(cursor.column(1), 2, "back");
    }
}
