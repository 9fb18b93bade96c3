//! A tree of boxes, to find the curves that may be near a place.
//!
//! The boxes are of pieces in the order of the contour, where those that follow each other lie side by
//! side: so nothing is sorted. Only where a contour lies over itself time and again, as one of many
//! laps does, are they: there a place is beside pieces from everywhere in the list.

use super::{Bounds, sort_pairs};

/// Boxes of one node.
pub const FAN: usize = 4;

/// The level whose boxes, each of 64 that follow each other, tell whether the order is good.
///
/// Of turns of a spiral the boxes of many more would lie over each other, though nothing of it does.
pub const TOLD_BY: usize = 3;

/// How often they may cover the area of the box around all.
const COVERED: f64 = 2.3;

/// What is added to their sizes so that a line covers something, as a part of the size of all.
const THICK: f64 = 1e-3;

/// Boxes, boxes around four of them that follow each other, and so on to one around all.
#[derive(Debug)]
pub struct BoxTree {
    levels: Vec<Vec<Bounds>>,
    /// The place in space of each box, along a curve that fills it, and its index in the list; nothing
    /// where they are in that order.
    order: Vec<(u32, usize)>,
}

impl BoxTree {
    /// A tree over boxes in their order, or in one of their places.
    #[must_use]
    pub fn new(boxes: Vec<Bounds>) -> Self {
        let mut tree = Self { levels: levels(boxes), order: Vec::new() };
        let told_by = tree.levels.get(TOLD_BY);
        if told_by.is_some_and(|boxes| is_tangled(boxes, &tree.around())) {
            let boxes = std::mem::take(&mut tree.levels[0]);
            let all = tree.around();
            for (index, bounds) in boxes.iter().enumerate() {
                tree.order.push((place(bounds, &all), index));
            }
            sort_pairs(&mut tree.order);
            let mut sorted = Vec::with_capacity(boxes.len());
            for &(_, index) in &tree.order {
                sorted.push(boxes[index]);
            }
            tree.levels = levels(sorted);
        }
        tree
    }

    #[cfg(test)]
    fn is_sorted(&self) -> bool {
        !self.order.is_empty()
    }

    fn around(&self) -> Bounds {
        self.levels[self.levels.len() - 1][0]
    }

    /// Whether any box meets `bounds`.
    #[must_use]
    pub fn meets(&self, bounds: &Bounds) -> bool {
        !self.meeting(bounds, &mut |_| false)
    }

    /// Calls `visit` with the index of every box that meets `bounds`, until it returns false; returns
    /// whether it never did.
    pub fn meeting(&self, bounds: &Bounds, visit: &mut dyn FnMut(usize) -> bool) -> bool {
        let visit = &mut |index| visit(self.order.get(index).map_or(index, |sorted| sorted.1));
        visit_leaves(&self.levels, &|around: &Bounds| around.meets(bounds), visit)
    }
}

/// Calls `visit` with the index of every leaf of a tree that `holds` is true of, and of all that it is
/// part of, in order and until it returns false; returns whether it never did. The levels are the leaves,
/// groups of [`FAN`] of them, and so on to the root.
pub fn visit_leaves<T>(
    levels: &[Vec<T>],
    holds: &impl Fn(&T) -> bool,
    visit: &mut dyn FnMut(usize) -> bool,
) -> bool {
    visit_below(levels, 0, holds, visit)
}

/// The same below some nodes that follow each other on the highest level.
fn visit_below<T>(
    levels: &[Vec<T>],
    from: usize,
    holds: &impl Fn(&T) -> bool,
    visit: &mut dyn FnMut(usize) -> bool,
) -> bool {
    let Some((nodes, below)) = levels.split_last() else { return true };
    for (index, node) in (from..).zip(&nodes[from..nodes.len().min(from + FAN)]) {
        if holds(node) {
            let goes_on = if below.is_empty() {
                visit(index)
            } else {
                visit_below(below, FAN * index, holds, visit)
            };
            if !goes_on {
                return false;
            }
        }
    }
    true
}

/// Whether boxes lie over each other so often that they are to be sorted; `around` is the one around
/// all of them.
#[inline(never)]
#[must_use]
pub fn is_tangled(boxes: &[Bounds], around: &Bounds) -> bool {
    if boxes.len() <= FAN {
        return false;
    }
    let size = around.size();
    let thick = THICK * size.max_element();
    let mut covered = 0.0;
    for bounds in boxes {
        covered += (bounds.size() + thick).element_product();
    }
    covered > COVERED * (size + thick).element_product()
}

/// All levels over some boxes.
fn levels(boxes: Vec<Bounds>) -> Vec<Vec<Bounds>> {
    let mut levels = vec![boxes];
    while let Some(below) = levels.last()
        && below.len() > 1
    {
        let mut level = vec![Bounds::EMPTY; below.len().div_ceil(FAN)];
        for (index, bounds) in below.iter().enumerate() {
            let around = &mut level[index / FAN];
            *around = around.union(*bounds);
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

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use glam::DVec2;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    /// Boxes of the sides of a polygon gone round so many times, and of nothing in between.
    fn laps(sides: u32, laps: u32) -> Vec<Bounds> {
        let at = |k: u32| DVec2::from_angle(TAU * f64::from(k) / f64::from(sides)) * 50.0;
        let side = |k: u32| {
            if k % 97 == 13 { Bounds::EMPTY } else { Bounds::of([at(k), at(k + 1)]) }
        };
        (0..sides * laps).map(side).collect()
    }

    #[test]
    fn every_box_that_meets_another_is_found_once() {
        for (sides, times, sorted) in
            [(0, 1, false), (1, 1, false), (7, 3, false), (1500, 1, false), (100, 60, true)]
        {
            let boxes = laps(sides, times);
            let tree = BoxTree::new(boxes.clone());
            assert_eq!(tree.is_sorted(), sorted, "{times} laps of {sides}");
            for k in 0..100 {
                let angle = f64::from(k) * 0.7;
                let middle = DVec2::from_angle(angle) * (40.0 + f64::from(k % 20));
                let place = Bounds::of([middle]).inflated(f64::from(k % 7) * 1.3);
                let mut found = Vec::new();
                tree.meeting(&place, &mut |index| {
                    found.push(index);
                    true
                });
                found.sort_unstable();
                let expected: Vec<usize> =
                    (0..boxes.len()).filter(|&i| boxes[i].meets(&place)).collect();
                assert_eq!(found, expected, "{times} laps of {sides}, {place:?}");
                assert_eq!(tree.meets(&place), !expected.is_empty(), "{place:?}");
            }
        }
    }
}
