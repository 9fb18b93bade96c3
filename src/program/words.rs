//! The words of one block as they are used up, so that none is passed over.

use super::block::{Block, Word};
use super::number::whole;

/// The words of a block, and which of them had a meaning.
#[derive(Clone, Copy)]
pub(super) struct Words<'a> {
    block: &'a Block,
    /// Bit i is set once word i was used; a block has at most 100 words.
    used: u128,
}

impl<'a> Words<'a> {
    pub(super) fn new(block: &'a Block) -> Self {
        Self { block, used: 0 }
    }

    /// The words not used yet, in order.
    pub(super) fn unused(&self) -> impl Iterator<Item = (usize, &'a Word)> + use<'a> {
        let used = self.used;
        self.block.words.iter().enumerate().filter(move |(i, _)| used >> i & 1 == 0)
    }

    /// Uses up word `index`.
    pub(super) fn use_up(&mut self, index: usize) {
        self.used |= 1 << index;
    }

    /// Whether word `index` was used up.
    pub(super) fn is_used(&self, index: usize) -> bool {
        self.used >> index & 1 == 1
    }

    /// The unused word with `letter`, without using it up.
    pub(super) fn find(&self, letter: char) -> Option<&'a Word> {
        self.unused().map(|(_, word)| word).find(|word| word.letter == letter)
    }

    /// Whether one of the letters is there.
    pub(super) fn has_any(&self, letters: &str) -> bool {
        self.unused().any(|(_, word)| letters.chars().any(|letter| letter == word.letter))
    }

    /// Takes the word with `letter`.
    pub(super) fn take(&mut self, letter: char) -> Option<&'a Word> {
        let (index, word) = self.unused().find(|(_, word)| word.letter == letter)?;
        self.use_up(index);
        Some(word)
    }

    /// Takes all words with one of the letters.
    pub(super) fn take_all(&mut self, letters: &str) {
        for (index, word) in self.block.words.iter().enumerate() {
            if letters.chars().any(|letter| letter == word.letter) {
                self.use_up(index);
            }
        }
    }
}

/// Ten times the number of a G or M word, where that is whole: G41.1 is 411.
pub(super) fn tenths(word: &Word) -> Option<u32> {
    let tenths = (word.value * 10.0).round();
    // Decimal tenths are not exact in binary; the next number that could be meant is 0.01 away.
    if (word.value * 10.0 - tenths).abs() < 1e-6 { whole(tenths) } else { None }
}
