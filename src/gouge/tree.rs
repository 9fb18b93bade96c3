//! A tree of boxes over the pieces of contours, in their order.
//!
//! Successive pieces lie side by side, so grouping their list groups them in space well enough: no
//! sorting, and the tree is one array. Level 0 holds the boxes of the pieces, each further level one
//! box for four below it.

use super::part::Part;
use crate::geometry::Bounds;

/// Boxes under one of the level above.
const BRANCHES: usize = 4;

/// Boxes around pieces.
#[derive(Debug)]
pub(super) struct Tree {
    /// Boxes level by level, those of the pieces first, the root last.
    levels: Vec<Vec<Bounds>>,
}

impl Tree {
    pub(super) fn new(pieces: Vec<Bounds>) -> Self {
        let around = |boxes: &[Bounds]| boxes.iter().copied().fold(Bounds::EMPTY, Bounds::union);
        let mut levels = vec![pieces];
        while let Some(below) = levels.last()
            && below.len() > 1
        {
            let level = below.chunks(BRANCHES).map(around).collect();
            levels.push(level);
        }
        Self { levels }
    }

    /// Calls `visit` with every piece whose box is nearer than `distance` [mm] to a part.
    pub(super) fn near(&self, part: &Part, distance: f64, visit: &mut dyn FnMut(usize)) {
        let bounds = part.curve.hull_bounds();
        self.descend(
            self.levels.len() - 1,
            0,
            &|around| {
                let gap = (around.min - bounds.max).max(bounds.min - around.max);
                gap.max(glam::DVec2::ZERO).length_squared() < distance * distance
                    && around.distance(part.middle) < distance + part.reach
            },
            visit,
        );
    }

    fn descend(
        &self,
        level: usize,
        index: usize,
        is_near: &dyn Fn(&Bounds) -> bool,
        visit: &mut dyn FnMut(usize),
    ) {
        let Some(around) = self.levels[level].get(index) else { return };
        if !is_near(around) {
            return;
        }
        if level == 0 {
            visit(index);
            return;
        }
        for branch in 0..BRANCHES {
            self.descend(level - 1, BRANCHES * index + branch, is_near, visit);
        }
    }
}
