//! A tree over the units of a workpiece in program order: which of them can be near which.
//!
//! Successive units lie side by side, so four of them, four of those and so on are good boxes:
//! nothing is sorted, and one unit that changes changes one node of each level. Each node also tells
//! whether its stretch of the contour is *tame*, so that no place of its path is too near to any
//! place of the same stretch:
//!
//! Let every tangent of the stretch point into one half circle, let it bend towards the tool
//! nowhere tighter than the tool (`σκ ≤ 1/r`), and let its corners be outside corners. With x along
//! the middle of the half circle it is the graph of a function of slope angle θ, and
//! `d sin θ / dx ≤ 1/r` for a tool above it. The lower half of a tool that touches it has
//! `d sin θ / dx = 1/r` and the same slope where they touch, so the graph stays below the tool to
//! both sides. The same holds where the tool runs on along the end tangent of an obtuse corner, up
//! to `r tan(φ/2) ≤ r sin φ` beyond it.

use super::octants::Octants;
use crate::geometry::{Bounds, BoxTree, FAN, TOLD_BY, is_tangled, visit_leaves};

/// What is known of a unit, or of successive ones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::compensation) struct Node {
    /// Box around its part of the contour.
    pub(in crate::compensation) contour: Bounds,
    /// Box around its part of the raw path.
    pub(in crate::compensation) path: Bounds,
    /// Where the contour heads.
    pub(in crate::compensation) octants: Octants,
    /// Whether it is one stretch without a break, an inside corner or a bend tighter than the tool.
    pub(in crate::compensation) fits: bool,
}

impl Node {
    /// What stands between two stretches.
    pub(in crate::compensation) const BREAK: Self =
        Self { contour: Bounds::EMPTY, path: Bounds::EMPTY, octants: Octants::ALL, fits: false };

    fn union(&self, other: &Self) -> Self {
        Self {
            contour: self.contour.union(other.contour),
            path: self.path.union(other.path),
            octants: self.octants.union(other.octants),
            fits: self.fits && other.fits,
        }
    }

    /// Length of the diagonal of the box around its part of the contour [mm].
    pub(in crate::compensation) fn contour_size(&self) -> f64 {
        self.contour.size().length()
    }

    /// Whether its path is surely clear of its own stretch of the contour.
    fn is_tame(&self) -> bool {
        self.fits && self.octants.is_narrow()
    }
}

/// The units of one contour: a stretch of the list of all.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::compensation) struct Range {
    pub(in crate::compensation) from: usize,
    pub(in crate::compensation) to: usize,
    pub(in crate::compensation) closed: bool,
}

/// The tree.
#[derive(Debug)]
pub(in crate::compensation) struct OrderTree {
    /// The units, then groups of four of them, and so on to the root.
    levels: Vec<Vec<Node>>,
    /// The boxes around their parts of the contour by their places, where their order tells little.
    contours: Option<BoxTree>,
}

/// What came out about the units.
#[derive(Debug)]
pub(in crate::compensation) struct Marks {
    /// For each level, for each node: what is known of all units below.
    levels: Vec<Vec<u8>>,
}

/// Its path may be too near to the contour.
const SUSPECT: u8 = 1;
/// Its path is too near everywhere.
const GOUGED: u8 = 2;

impl Marks {
    pub(in crate::compensation) fn is_suspect(&self, unit: usize) -> bool {
        self.levels[0][unit] & SUSPECT != 0
    }

    pub(super) fn is_gouged(&self, unit: usize) -> bool {
        self.levels[0][unit] & GOUGED != 0
    }

    /// Marks all units below a node.
    fn all(&mut self, level: usize, index: usize, mark: u8) {
        if let Some(node) = self.levels[level].get_mut(index) {
            if *node & mark == mark {
                return;
            }
            *node |= mark;
            if level > 0 {
                for child in FAN * index..FAN * (index + 1) {
                    self.all(level - 1, child, mark);
                }
            }
        }
    }

    /// What all children of a node have in common.
    fn refresh(&mut self, level: usize, index: usize) {
        let below = &self.levels[level - 1];
        let children = &below[FAN * index..below.len().min(FAN * (index + 1))];
        let common = children.iter().fold(0xff, |common, child| common & child);
        self.levels[level][index] |= common;
    }
}

/// How near path and contour may come.
#[derive(Debug, Clone, Copy)]
pub(in crate::compensation) struct Limits {
    /// From this distance on there is nothing to look at [mm].
    pub(in crate::compensation) reach: f64,
    /// Nearer than this is too near [mm].
    pub(in crate::compensation) least: f64,
}

impl OrderTree {
    pub(in crate::compensation) fn new(units: Vec<Node>) -> Self {
        let mut levels = vec![units];
        while let Some(below) = levels.last()
            && below.len() > 1
        {
            let level = below.chunks(FAN).map(around).collect();
            levels.push(level);
        }
        Self { levels, contours: None }
    }

    /// Whether the contour lies over itself so often that its order tells little of what is near.
    fn is_tangled(&self) -> bool {
        let around = &self.levels[self.levels.len() - 1][0].contour;
        self.levels.get(TOLD_BY).is_some_and(|level| is_tangled(&contours(level), around))
    }

    pub(in crate::compensation) fn unit(&self, unit: usize) -> &Node {
        &self.levels[0][unit]
    }

    /// Finds which paths may be too near to the contour.
    pub(in crate::compensation) fn marks(&mut self, ranges: &[Range], limits: Limits) -> Marks {
        self.contours = self.is_tangled().then(|| BoxTree::new(contours(&self.levels[0])));
        let marks =
            Marks { levels: self.levels.iter().map(|level| vec![0; level.len()]).collect() };
        let mut join = Join { tree: self, ranges, limits, marks };
        if join.tree.contours.is_some() {
            join.one_by_one();
        } else {
            join.within(join.tree.levels.len() - 1, 0);
        }
        join.marks
    }

    /// Calls `visit` with every unit whose contour's box is nearer to `bounds` than `distance` [mm],
    /// until it returns false; returns whether it never did.
    pub(in crate::compensation) fn near(
        &self,
        bounds: &Bounds,
        distance: f64,
        visit: &mut dyn FnMut(usize) -> bool,
    ) -> bool {
        if distance <= 0.0 {
            return true;
        }
        let around = bounds.inflated(distance);
        let is_far = |unit| self.unit(unit).contour.gap_squared(bounds) >= distance * distance;
        let visit = &mut |unit| is_far(unit) || visit(unit);
        match &self.contours {
            Some(contours) => contours.meeting(&around, visit),
            None => visit_leaves(&self.levels, &|node: &Node| node.contour.meets(&around), visit),
        }
    }

    /// Calls `visit` with every unit that `holds` is true of, and of all that it is part of, in order.
    pub(super) fn each(&self, holds: &dyn Fn(&Node) -> bool, visit: &mut dyn FnMut(usize)) {
        visit_leaves(&self.levels, &holds, &mut |unit| {
            visit(unit);
            true
        });
    }

    /// Where the contour heads along a stretch of units, if all of them fit.
    fn heading(&self, mut from: usize, to: usize) -> Option<Octants> {
        let mut octants = Octants::default();
        while from < to {
            // The highest node that begins here and does not reach beyond the end.
            let (mut level, mut index, mut width) = (0, from, 1);
            while index % FAN == 0 && from + FAN * width <= to && level + 1 < self.levels.len() {
                (level, index, width) = (level + 1, index / FAN, FAN * width);
            }
            let node = &self.levels[level][index];
            octants = octants.union(node.octants);
            if !node.fits || !octants.is_narrow() {
                return None;
            }
            from += width;
        }
        Some(octants)
    }

    /// The stretch of units around one that is tame all in all, at most `most` to each side.
    pub(in crate::compensation) fn tame_around(
        &self,
        unit: usize,
        range: Range,
        most: usize,
    ) -> [usize; 2] {
        let units = &self.levels[0];
        if !units[unit].fits {
            return [unit, unit];
        }
        let mut octants = units[unit].octants;
        let mut goes_on = |next: usize| {
            let wider = octants.union(units[next].octants);
            let is_tame = units[next].fits && wider.is_narrow();
            if is_tame {
                octants = wider;
            }
            is_tame
        };
        let (mut from, mut to) = (unit, unit + 1);
        while to < range.to && to - unit < most && goes_on(to) {
            to += 1;
        }
        while from > range.from && unit - from < most && goes_on(from - 1) {
            from -= 1;
        }
        [from, to]
    }
}

/// The boxes around the parts of the contour of some nodes.
fn contours(nodes: &[Node]) -> Vec<Bounds> {
    let mut boxes = Vec::with_capacity(nodes.len());
    for node in nodes {
        boxes.push(node.contour);
    }
    boxes
}

fn around(nodes: &[Node]) -> Node {
    let (first, rest) = (nodes[0], &nodes[1..]);
    rest.iter().fold(first, |all, node| all.union(node))
}

/// A walk over all pairs that may be near.
struct Join<'a> {
    tree: &'a OrderTree,
    ranges: &'a [Range],
    limits: Limits,
    marks: Marks,
}

impl Join<'_> {
    /// Where the contour lies over itself time and again nearly all pairs would be looked at. So each
    /// path is held against what is near it until something may be too near.
    fn one_by_one(&mut self) {
        let tree = self.tree;
        for (unit, node) in tree.levels[0].iter().enumerate() {
            let is_clear = node.fits
                && tree.near(&node.path, self.limits.reach, &mut |other| {
                    other == unit || self.is_tame_between(unit.min(other), unit.max(other))
                });
            self.marks.levels[0][unit] = if is_clear { 0 } else { SUSPECT };
        }
    }

    /// Pairs below one node.
    fn within(&mut self, level: usize, index: usize) {
        let node = &self.tree.levels[level][index];
        if node.is_tame() {
            return;
        }
        if level == 0 {
            if !node.fits {
                self.marks.levels[0][index] |= SUSPECT;
            }
            return;
        }
        let end = self.tree.levels[level - 1].len().min(FAN * (index + 1));
        for child in FAN * index..end {
            self.within(level - 1, child);
        }
        for child in FAN * index..end {
            for other in child + 1..end {
                self.pair_if_news(level - 1, child, other, [true, true]);
            }
        }
        self.marks.refresh(level, index);
    }

    /// The same as `pair`, unless all that is open there is known to be suspect.
    fn pair_if_news(&mut self, level: usize, a: usize, b: usize, mut open: [bool; 2]) {
        let marks = &self.marks.levels[level];
        open[0] &= marks[a] & SUSPECT == 0;
        open[1] &= marks[b] & SUSPECT == 0;
        if open[0] || open[1] {
            self.pair(level, a, b, open);
        }
    }

    /// Pairs of one unit below each of two nodes, `a` before `b`; `open` tells whether the path of
    /// `a` and whether that of `b` has still to be looked at.
    fn pair(&mut self, level: usize, a: usize, b: usize, mut open: [bool; 2]) {
        let tree = self.tree;
        let nodes = &tree.levels[level];
        let (node_a, node_b) = (&nodes[a], &nodes[b]);
        open[0] = open[0] && self.is_open(level, a, node_a, node_b);
        open[1] = open[1] && self.is_open(level, b, node_b, node_a);
        if !open[0] && !open[1] || self.is_tame_pair(level, a, b) {
            return;
        }
        if level == 0 {
            if self.is_tame_between(a, b) {
                return;
            }
            for (open, path) in open.into_iter().zip([a, b]) {
                if open {
                    self.marks.levels[0][path] |= SUSPECT;
                }
            }
            return;
        }
        let below = &tree.levels[level - 1];
        for child in FAN * a..below.len().min(FAN * (a + 1)) {
            let node = &below[child];
            let is_suspect = self.marks.levels[level - 1][child] & SUSPECT != 0;
            let open = [
                open[0] && !is_suspect && self.reaches(node, node_b),
                open[1] && self.reaches(node_b, node),
            ];
            if open[0] || open[1] {
                for other in FAN * b..below.len().min(FAN * (b + 1)) {
                    self.pair_if_news(level - 1, child, other, open);
                }
            }
        }
        self.marks.refresh(level, a);
        self.marks.refresh(level, b);
    }

    /// Whether the path of a node may come near to the contour of another.
    fn reaches(&self, path: &Node, contour: &Node) -> bool {
        path.path.gap_squared(&contour.contour) < self.limits.reach * self.limits.reach
    }

    /// Whether the path of a node can be too near to the contour of another; not where it surely is.
    fn is_open(&mut self, level: usize, index: usize, path: &Node, contour: &Node) -> bool {
        if !self.reaches(path, contour) {
            return false;
        }
        let (path, contour) = (&path.path, &contour.contour);
        let least = self.limits.least;
        if least > 0.0 && path.span_squared(contour) < least * least {
            self.marks.all(level, index, GOUGED | SUSPECT);
            return false;
        }
        true
    }

    /// Whether the stretch from one unit to another is tame, either way round a closed contour.
    ///
    /// What nodes tell depends on where their stretches begin; this does not, so that the same part of
    /// a contour gets the same marks wherever it lies in a list.
    fn is_tame_between(&self, a: usize, b: usize) -> bool {
        if !self.tree.unit(a).fits || !self.tree.unit(b).fits {
            return false;
        }
        let range = self.ranges.partition_point(|range| range.to <= a);
        let all = |from: usize, to: usize| self.tree.heading(from, to);
        let is_narrow = |octants: Option<Octants>| octants.is_some_and(Octants::is_narrow);
        is_narrow(all(a, b + 1))
            || self.ranges.get(range).is_some_and(|r| {
                let before = || all(r.from, a + 1);
                r.closed
                    && b < r.to
                    && all(b, r.to).is_some_and(|o| is_narrow(before().map(|p| o.union(p))))
            })
    }

    /// Whether two nodes follow each other and are tame together.
    fn is_tame_pair(&self, level: usize, a: usize, b: usize) -> bool {
        let nodes = &self.tree.levels[level];
        if !nodes[a].fits || !nodes[b].fits {
            return false;
        }
        // Four to the power of the level.
        let width = 1_usize << (2 * level);
        let follows = a + 1 == b || {
            // The start of a closed contour follows its end.
            let from = a * width;
            let to = ((b + 1) * width).min(self.tree.levels[0].len());
            let range = self.ranges.partition_point(|range| range.to <= from);
            self.ranges.get(range).is_some_and(|r| r.closed && r.from == from && r.to == to)
        };
        follows && nodes[a].octants.union(nodes[b].octants).is_narrow()
    }
}
