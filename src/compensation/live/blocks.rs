//! Blocks: some spans of a part, which are drawn together.

use super::joint::Joint;
use super::local::Local;
use super::part::End;
use super::slots::Slots;
use crate::geometry::{Bounds, sort_long};

/// Spans of a block; when edits have made it twice as many, it is cut in two.
pub(super) const BLOCK: usize = 4;

/// Blocks that have a box in common.
const YARD: usize = 64;

/// Some spans of a part, drawn together.
#[derive(Debug, Clone)]
pub(super) struct Block {
    pub(super) part: usize,
    /// Its first span, counted in its part.
    pub(super) first: usize,
    pub(super) spans: usize,
    /// A box around its spans.
    pub(super) bounds: Bounds,
    /// A box around its whole offset, where gouges are avoided.
    pub(super) path: Bounds,
    /// Where stretches of its path begin, counted in its vertices, the first apart.
    pub(super) breaks: Vec<u32>,
    /// Whether it is to be drawn again.
    pub(super) dirty: bool,
}

impl Local {
    /// Measures the boxes of a block.
    pub(super) fn measure(&mut self, block: usize) {
        let Block { part, first, spans, .. } = self.blocks[block];
        let body = &self.parts[part];
        self.blocks[block].bounds = body.bounds(first, spans);
        if self.avoids() {
            let path = body.reach(first, spans, self.tool, &self.options);
            self.blocks[block].path = path;
            let yard = self.yard(block / YARD);
            if let Some(around) = self.yards.get_mut(block / YARD) {
                *around = yard;
            }
        }
    }

    /// The box around some blocks that follow each other.
    fn yard(&self, yard: usize) -> Bounds {
        let from = yard * YARD;
        let mut around = Bounds::EMPTY;
        for block in &self.blocks[from..self.blocks.len().min(from + YARD)] {
            around = around.union(block.bounds).union(block.path);
        }
        around
    }

    /// Measures the boxes around many blocks again, where there are more or fewer.
    pub(super) fn measure_yards(&mut self) {
        self.yards.clear();
        for yard in 0..self.blocks.len().div_ceil(YARD) {
            self.yards.push(self.yard(yard));
        }
    }

    /// The blocks of which `is_near` holds, in order, all of which have a box that meets `around`.
    pub(super) fn blocks_near(
        &self,
        around: &Bounds,
        is_near: &dyn Fn(&Block) -> bool,
    ) -> Vec<usize> {
        let mut near = Vec::new();
        for (yard, bounds) in self.yards.iter().enumerate() {
            if bounds.meets(around) {
                let from = yard * YARD;
                for block in from..self.blocks.len().min(from + YARD) {
                    if is_near(&self.blocks[block]) {
                        near.push(block);
                    }
                }
            }
        }
        near
    }

    /// Takes a joint that came out otherwise than before.
    pub(super) fn replace(&mut self, index: usize, joint: Joint) {
        let span =
            |end: End, whole: usize| if let End::At(spot, _) = end { spot.span } else { whole };
        let parts = [index.checked_sub(1), Some(index).filter(|&i| i < self.parts.len())];
        let passed = |part: Option<usize>| part.is_some_and(|part| self.is_passed(part));
        let before = [passed(parts[0]), passed(parts[1])];
        let old = std::mem::replace(&mut self.joints[index], joint);
        for (k, part) in parts.into_iter().enumerate() {
            let Some(part) = part else { continue };
            let joint = &self.joints[index];
            let last = self.parts[part].spans() - 1;
            let (mut from, mut to) = if k == 0 {
                (span(old.incoming, last).min(span(joint.incoming, last)), last)
            } else {
                (0, span(old.outgoing, 0).max(span(joint.outgoing, 0)))
            };
            if before[k] || self.is_passed(part) {
                (from, to) = (0, last);
            }
            for block in self.block_of(part, from.min(last))..=self.block_of(part, to.min(last)) {
                self.mark(block);
            }
        }
    }

    /// Whether the ends of a part may pass each other: then its first block has all that is left,
    /// and the others rest.
    fn is_passed(&self, part: usize) -> bool {
        match (self.joints[part].outgoing, self.joints[part + 1].incoming) {
            (End::At(start, _), End::At(end, _)) => end.span <= start.span,
            _ => false,
        }
    }

    /// Cuts blocks in two that have grown to twice their size, and takes out empty ones; returns
    /// the blocks that are to be drawn.
    pub(super) fn tidied(&mut self, [path, outline]: [&mut Slots; 2]) -> Vec<usize> {
        let mut dirty = std::mem::take(&mut self.dirty);
        sort_long(&mut dirty, |a, b| a < b);
        let mut drawn: Vec<usize> = Vec::with_capacity(dirty.len());
        let mut moved = false;
        // From behind, so that those still to come stay where they are.
        for &block in dirty.iter().rev() {
            let spans = self.blocks[block].spans;
            if spans == 0 {
                self.blocks.remove(block);
                self.led = self.led.map(|led| led.saturating_sub(usize::from(led > block)));
                moved = true;
                path.remove(block);
                outline.remove(block);
                for later in &mut drawn {
                    *later -= 1;
                }
                let heir = block.saturating_sub(1);
                if !std::mem::replace(&mut self.blocks[heir].dirty, true) {
                    drawn.push(heir);
                }
                continue;
            }
            if spans >= 2 * BLOCK {
                let half = spans / 2;
                let mut second = self.blocks[block].clone();
                second.breaks.clear();
                (second.first, second.spans) = (second.first + half, spans - half);
                self.blocks[block].spans = half;
                self.blocks.insert(block + 1, second);
                self.measure(block);
                self.measure(block + 1);
                moved = true;
                self.led = self.led.map(|led| led.saturating_add(usize::from(led > block)));
                path.split(block);
                outline.split(block);
                for later in &mut drawn {
                    *later += 1;
                }
                drawn.push(block + 1);
            }
            drawn.push(block);
        }
        if moved && self.avoids() {
            self.measure_yards();
        }
        drawn
    }
}
