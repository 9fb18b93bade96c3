//! A tree of boxes, to find the curves that may be near a place.
//!
//! The boxes are of pieces of paths in the order of the contour, where those that follow each other lie
//! side by side: so nothing is sorted, as in the tree over the units.

use crate::geometry::Bounds;

/// Boxes of one node.
const FAN: usize = 4;

/// Boxes, boxes around four of them that follow each other, and so on to one around all.
#[derive(Debug)]
pub(super) struct BoxTree {
    levels: Vec<Vec<Bounds>>,
}

impl BoxTree {
    pub(super) fn new(boxes: Vec<Bounds>) -> Self {
        let mut levels = vec![boxes];
        while let Some(below) = levels.last()
            && below.len() > 1
        {
            let mut level = Vec::with_capacity(below.len().div_ceil(FAN));
            for group in below.chunks(FAN) {
                let mut around = group[0];
                for bounds in &group[1..] {
                    around = around.union(*bounds);
                }
                level.push(around);
            }
            levels.push(level);
        }
        Self { levels }
    }

    /// Whether any box meets `bounds`.
    pub(super) fn meets(&self, bounds: &Bounds) -> bool {
        let mut found = false;
        self.meeting(bounds, &mut |_| {
            found = true;
            false
        });
        found
    }

    /// Calls `visit` with the index of every box that meets `bounds`, until it returns false.
    pub(super) fn meeting(&self, bounds: &Bounds, visit: &mut dyn FnMut(usize) -> bool) {
        self.below(self.levels.len() - 1, 0, bounds, visit);
    }

    /// Visits what is below some boxes that follow each other; returns whether to go on.
    fn below(
        &self,
        level: usize,
        from: usize,
        bounds: &Bounds,
        visit: &mut dyn FnMut(usize) -> bool,
    ) -> bool {
        let boxes = &self.levels[level];
        for (index, around) in boxes.iter().enumerate().skip(from).take(FAN) {
            let goes_on = !around.meets(bounds)
                || if level == 0 {
                    visit(index)
                } else {
                    self.below(level - 1, FAN * index, bounds, visit)
                };
            if !goes_on {
                return false;
            }
        }
        true
    }
}
