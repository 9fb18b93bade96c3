//! Words that move nothing, put together to be passed through.

use super::block::Block;
use super::number::push_word;

/// The words of a block that act before its move and after it, as text.
#[derive(Debug)]
pub(super) struct Auxiliary<'a> {
    before: String,
    after: String,
    comments: &'a [String],
    /// Whether the program ends with this block.
    pub(super) end: bool,
    /// Whether the machine waits after this block.
    pub(super) stops: bool,
}

impl<'a> Auxiliary<'a> {
    pub(super) fn new(block: &'a Block) -> Self {
        let (before, after) = (String::new(), String::new());
        Self { before, after, comments: &block.comments, end: false, stops: false }
    }

    /// A word that acts before the move.
    pub(super) fn word(&mut self, letter: char, value: f64) {
        space(&mut self.before);
        push_word(&mut self.before, letter, value);
    }

    /// Words that act before the move.
    pub(super) fn text(&mut self, words: &str) {
        space(&mut self.before);
        self.before.push_str(words);
    }

    /// An M word by ten times its number: stops act after the move.
    pub(super) fn m_word(&mut self, tenths: u32, value: f64) {
        match tenths {
            0 | 10 | 20 | 300 | 600 => {
                let ends = matches!(tenths, 20 | 300);
                self.end |= ends;
                self.stops |= !ends;
                space(&mut self.after);
                push_word(&mut self.after, 'M', value);
            }
            _ => self.word('M', value),
        }
    }

    /// The O word, which many controllers do not know: its number is kept as a comment.
    pub(super) fn program_number(&mut self, value: f64) {
        space(&mut self.before);
        self.before.push('(');
        push_word(&mut self.before, 'O', value);
        self.before.push(')');
    }

    /// Whether there are words besides comments.
    pub(super) fn has_words(&self) -> bool {
        !(self.before.is_empty() && self.after.is_empty())
    }

    /// What acts before the move, comments included, and what acts after it.
    pub(super) fn finish(mut self) -> (String, String) {
        for comment in self.comments {
            space(&mut self.before);
            self.before.push_str(comment);
        }
        (self.before, self.after)
    }
}

fn space(text: &mut String) {
    if !text.is_empty() {
        text.push(' ');
    }
}
