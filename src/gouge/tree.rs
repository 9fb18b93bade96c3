//! A tree of boxes over chords in the order of their curve.
//!
//! Successive chords lie side by side, so halving their list halves space well enough: no sorting,
//! and the tree is two arrays. Level 0 holds the boxes of groups of chords, each further level one
//! box for two below it.

use glam::DVec2;

use super::chord::Chord;
use crate::geometry::Bounds;

/// Chords of one leaf: few enough to look at each, enough to keep the tree small.
const LEAF: usize = 4;

/// Boxes around chords.
#[derive(Debug)]
pub(super) struct Tree {
    chords: Vec<Chord>,
    /// Boxes level by level, the leaves first, the root last.
    levels: Vec<Vec<Bounds>>,
}

impl Tree {
    pub(super) fn new(chords: Vec<Chord>) -> Self {
        let around = |boxes: &[Bounds]| boxes.iter().copied().fold(Bounds::EMPTY, Bounds::union);
        let leaves: Vec<Bounds> = chords
            .chunks(LEAF)
            .map(|leaf| leaf.iter().map(Chord::bounds).fold(Bounds::EMPTY, Bounds::union))
            .collect();
        let mut levels = vec![leaves];
        while let Some(below) = levels.last()
            && below.len() > 1
        {
            let level = below.chunks(2).map(around).collect();
            levels.push(level);
        }
        Self { chords, levels }
    }

    /// Calls `visit` with every chord whose box is within `distance` [mm] of `bounds`.
    pub(super) fn near(&self, bounds: &Bounds, distance: f64, mut visit: impl FnMut(&Chord)) {
        // By the true distance of the boxes: a large tool goes round the part at arm's length, and a
        // square about its centre would hold all of the contour.
        let is_near = |around: &Bounds| {
            let gap = (bounds.min - around.max).max(around.min - bounds.max).max(DVec2::ZERO);
            gap.length_squared() <= distance * distance
        };
        let mut open = vec![(self.levels.len() - 1, 0)];
        while let Some((level, index)) = open.pop() {
            let Some(around) = self.levels[level].get(index) else { continue };
            if !is_near(around) {
                continue;
            }
            if level > 0 {
                open.extend([(level - 1, 2 * index + 1), (level - 1, 2 * index)]);
                continue;
            }
            let from = index * LEAF;
            self.chords[from..(from + LEAF).min(self.chords.len())].iter().for_each(&mut visit);
        }
    }
}
