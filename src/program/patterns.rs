//! Haas' circular pockets (G12, G13) and patterns of holes (G70, G71, G72), written out as blocks.
//!
//! Haas, Mill Series Programming Workbook, "Circular Pocket Milling" and "Bolt Hole Patterns": a pocket
//! stands for G42 (G12) or G41 (G13) and circles of I, I + Q and so on up to K about where the tool is,
//! L times, each time by Z; the holes are those of the cycle in effect. How the tool comes to a circle
//! and leaves it is this package's choice: straight out from the centre, and back to it. Other
//! controls have no such words with these letters beside them.

use glam::DVec2;

use super::auxiliary::word as text_of;
use super::block::{Block, Word};
use super::dialect::Dialect;
use super::g_words::Motion;
use super::interpret::Interpreter;
use super::number::whole;
use crate::contour::Plane;
use crate::geometry::rotate;

/// Most holes, circles, and times to go deeper.
const MOST: u32 = 10_000;

/// The number of the word with a letter.
fn of(block: &Block, letter: char) -> Option<f64> {
    block.words.iter().find(|word| word.letter == letter).map(|word| word.value)
}

impl Interpreter {
    /// Runs the blocks that a block stands for; false where it is no pocket and no pattern.
    pub(super) fn pattern(&mut self, block: &Block) -> bool {
        let is_pattern = |word: &&Word| {
            word.letter == 'G' && matches!(whole(word.value), Some(12 | 13 | 70..=72))
        };
        let elsewhere =
            self.rules.is_strict || matches!(self.dialect, Dialect::LinuxCnc | Dialect::Sinumerik);
        let Some(word) = block.words.iter().find(is_pattern).filter(|_| !elsewhere) else {
            return false;
        };
        let is_pocket = word.value < 14.0;
        let (times, first) = (of(block, 'L'), of(block, 'I'));
        let Some(first) = first.filter(|_| is_pocket || times.is_some()) else { return false };
        let count = whole(times.unwrap_or(1.0)).filter(|count| (1..=MOST).contains(count));
        let free = self.course.switched().is_none() && !self.modal.absolute_center;
        let mut made = block.clone();
        let left_out = if is_pocket { "IJKLDQZ" } else { "IJKLXY" };
        made.words.retain(|w| {
            left_out.chars().all(|letter| letter != w.letter) && w.column != word.column
        });
        let made = count.filter(|_| free && self.modal.plane == Plane::Xy).and_then(|count| {
            if is_pocket {
                self.pocket(block, word, made, [count, 0], first)
            } else {
                self.hole_pattern(block, word, made, count, first)
            }
        });
        if made.is_none() {
            let what = if is_pocket { "I and D, K with Q" } else { "a cycle, I and L" };
            let message =
                format!("{} is not possible here: it needs {what}", text_of('G', word.value));
            let hint = "it needs G17, and G40 before";
            self.error("bad-pattern", message, block.origin_at(word.column), hint);
        }
        true
    }

    /// G12 and G13.
    fn pocket(
        &mut self,
        block: &Block,
        word: &Word,
        mut made: Block,
        [times, mut rings]: [u32; 2],
        first: f64,
    ) -> Option<()> {
        let (last, step) = (of(block, 'K').unwrap_or(first), of(block, 'Q').unwrap_or(0.0));
        let (number, depth) = (of(block, 'D')?, of(block, 'Z'));
        if last != first {
            // What rounding leaves is no ring more.
            rings = whole(((last - first) / step - 1e-9).ceil())?;
        }
        if first <= 0.0 || last < first || rings > MOST {
            return None;
        }
        if !self.may_expand(block, times.saturating_mul(3 * rings + 4)) {
            return Some(());
        }
        self.block(&made);
        made.comments.clear();
        let (motion, center) = (self.modal.motion, self.plane_place());
        let turn = word.value - 10.0;
        // D0 says that the centre of the tool is programmed.
        let side = if number == 0.0 { 40.0 } else { 44.0 - turn };
        for _ in 0..times {
            if let Some(depth) = depth {
                self.run_made(&mut made, word, &[('G', 1.0), ('Z', depth)]);
            }
            for ring in 0..=rings {
                let radius = last.min(first + f64::from(ring) * step);
                let [x, y] = self.words_to(center + DVec2::X * radius);
                self.run_made(&mut made, word, &[('G', side), ('D', number), ('G', 1.0), x, y]);
                self.run_made(&mut made, word, &[('G', turn), ('I', -radius), ('J', 0.0)]);
                let [x, y] = self.words_to(center);
                self.run_made(&mut made, word, &[('G', 40.0), ('G', 1.0), x, y]);
            }
        }
        self.modal.motion = motion;
        Some(())
    }

    /// G70, G71 and G72: a circle of holes from the angle J on, every K degrees of one, and a line.
    fn hole_pattern(
        &mut self,
        block: &Block,
        word: &Word,
        mut made: Block,
        count: u32,
        first: f64,
    ) -> Option<()> {
        let start = of(block, 'J').unwrap_or(0.0);
        let apart = match whole(word.value) {
            Some(70) => 360.0 / f64::from(count),
            Some(71) => of(block, 'K')?,
            _ => 0.0,
        };
        if !matches!(self.modal.motion, Some(Motion::Cycle(_))) {
            return None;
        }
        let mut center = self.plane_place();
        for (i, letter) in ['X', 'Y'].into_iter().enumerate() {
            if let Some(value) = of(block, letter) {
                center[i] = value + if self.modal.relative { center[i] } else { 0.0 };
            }
        }
        for hole in 0..count {
            let hole = f64::from(hole);
            let along = if word.value > 71.5 { hole * first } else { first };
            let angle = (start + hole * apart).to_radians();
            let words = self.words_to(center + rotate(DVec2::X * along, angle));
            made.words.extend(words.map(|new| new_word(new, word.column)));
            self.block(&made);
            made.words.clear();
            made.comments.clear();
        }
        Some(())
    }

    /// Where the program is in the plane, in its own unit.
    fn plane_place(&self) -> DVec2 {
        let place = self.modal.frame.unmap(self.modal.position) / self.modal.unit();
        DVec2::new(place.x, place.y)
    }

    /// The words that lead to a point of the plane, in the unit of the program.
    fn words_to(&self, to: DVec2) -> [(char, f64); 2] {
        let from = if self.modal.relative { self.plane_place() } else { DVec2::ZERO };
        [('X', to.x - from.x), ('Y', to.y - from.y)]
    }

    /// Runs a block of the words that are given.
    fn run_made(&mut self, block: &mut Block, at: &Word, words: &[(char, f64)]) {
        block.words.clear();
        block.words.extend(words.iter().map(|word| new_word(*word, at.column)));
        self.block(block);
    }
}

/// A word as if it were written with a point.
fn new_word((letter, value): (char, f64), column: u32) -> Word {
    Word { letter, value, column, point: true }
}
