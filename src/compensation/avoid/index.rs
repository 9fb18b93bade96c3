//! A tree of boxes, to find the curves that may be near a place.
//!
//! The boxes are of pieces in the order of the contour, where those that follow each other lie side by
//! side: so nothing is sorted. Only where a contour lies over itself time and again, as one of many
//! laps does, are they: there a place is beside pieces from everywhere in the list.

use crate::geometry::{Bounds, sort_long};

/// Boxes of one node.
const FAN: usize = 4;

/// The level whose boxes, each of 256 that follow each other, tell whether the order is good.
const TOLD_BY: usize = 4;

/// How often they may cover the area of the box around all.
const COVERED: f64 = 4.0;

/// What is added to their sizes so that a line covers something, as a part of the size of all.
const THICK: f64 = 1e-3;

/// Boxes, boxes around four of them that follow each other, and so on to one around all.
#[derive(Debug)]
pub(super) struct BoxTree {
    levels: Vec<Vec<Bounds>>,
    /// The place in space of each box, along a curve that fills it, and its index in the list; nothing
    /// where they are in that order.
    order: Vec<(u32, usize)>,
}

impl BoxTree {
    pub(super) fn new(boxes: Vec<Bounds>) -> Self {
        let mut tree = Self { levels: levels(boxes), order: Vec::new() };
        if tree.is_tangled() {
            let boxes = std::mem::take(&mut tree.levels[0]);
            let all = tree.around();
            for (index, bounds) in boxes.iter().enumerate() {
                tree.order.push((place(bounds, &all), index));
            }
            sort_places(&mut tree.order);
            let mut sorted = Vec::with_capacity(boxes.len());
            for &(_, index) in &tree.order {
                sorted.push(boxes[index]);
            }
            tree.levels = levels(sorted);
        }
        tree
    }

    /// Whether the boxes lie over each other so often that they were sorted.
    pub(super) fn is_sorted(&self) -> bool {
        !self.order.is_empty()
    }

    fn around(&self) -> Bounds {
        self.levels[self.levels.len() - 1][0]
    }

    fn is_tangled(&self) -> bool {
        if self.levels.len() <= TOLD_BY + 1 {
            return false;
        }
        let size = self.around().size();
        let thick = THICK * size.max_element();
        let mut covered = 0.0;
        for bounds in &self.levels[TOLD_BY] {
            covered += (bounds.size() + thick).element_product();
        }
        covered > COVERED * (size + thick).element_product()
    }

    /// Whether any box meets `bounds`.
    pub(super) fn meets(&self, bounds: &Bounds) -> bool {
        !self.meeting(bounds, &mut |_| false)
    }

    /// Calls `visit` with the index of every box that meets `bounds`, until it returns false; returns
    /// whether it never did.
    pub(super) fn meeting(&self, bounds: &Bounds, visit: &mut dyn FnMut(usize) -> bool) -> bool {
        self.below(self.levels.len() - 1, 0, bounds, visit)
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
                    visit(self.order.get(index).map_or(index, |sorted| sorted.1))
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

/// All levels over some boxes.
fn levels(boxes: Vec<Bounds>) -> Vec<Vec<Bounds>> {
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
    levels
}

/// Where the middle of a box comes along a Z-order curve through the box around `all`: the bits of
/// its coordinates take turns (Morton, 1966). An empty box comes first.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "from 0 to 65535, and nothing matters for an empty box"
)]
fn place(bounds: &Bounds, all: &Bounds) -> u32 {
    let middle = (bounds.min.midpoint(bounds.max) - all.min) / all.size() * 65535.0;
    let (x, y) = (middle.x as u32, middle.y as u32);
    let mut place = 0;
    for bit in 0..16 {
        place |= (x >> bit & 1) << (2 * bit) | (y >> bit & 1) << (2 * bit + 1);
    }
    place
}

/// Sorts indices by the place that each has, and those of one place by themselves.
#[inline(never)]
pub(super) fn sort_places(list: &mut [(u32, usize)]) {
    sort_long(list, |a, b| a < b);
}
