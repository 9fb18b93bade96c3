//! Blocks and words: what one line of a program consists of.

use crate::diagnostic::Origin;

/// One word: a letter and a number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Word {
    /// Its letter, a capital; words with a name have a small one.
    pub letter: char,
    /// Its number, as programmed.
    pub value: f64,
    /// Column of the letter, counted from 1 in characters.
    pub column: u32,
    /// Whether its number was written with a decimal point.
    pub point: bool,
}

/// One block: the words and comments of one line.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Block {
    /// Line of the text, counted from 1.
    pub line: u32,
    /// The N word.
    pub number: Option<u32>,
    /// Whether it begins with `/`, so that a switch of the control can skip it.
    pub skippable: bool,
    /// Its words in order, the N word apart.
    pub words: Vec<Word>,
    /// Its comments with their brackets or semicolon, in order.
    pub comments: Vec<String>,
}

// Mostly never inlined: asked for wherever a diagnostic is made.
impl Block {
    /// Makes it the empty block of a line, and keeps its memory.
    pub(super) fn clear(&mut self, line: u32) {
        (self.line, self.number, self.skippable) = (line, None, false);
        self.words.clear();
        self.comments.clear();
    }

    /// The place of the block.
    #[inline(never)]
    #[must_use]
    pub fn origin(&self) -> Origin {
        Origin::Block { line: self.line, number: self.number, column: None }
    }

    /// The place of its first word.
    #[inline(never)]
    #[must_use]
    pub fn start(&self) -> Origin {
        self.origin_at(self.words.first().map_or(1, |word| word.column))
    }

    /// The place of a column of the block.
    #[inline(never)]
    #[must_use]
    pub fn origin_at(&self, column: u32) -> Origin {
        Origin::Block { line: self.line, number: self.number, column: Some(column) }
    }
}
