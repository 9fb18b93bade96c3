//! A tree of boxes, to find the curves that may be near a place.

use crate::geometry::{Bounds, select};

/// Boxes of one leaf.
const LEAF: usize = 6;

/// A binary tree over boxes, halved at the median of their centres along the longer side.
#[derive(Debug)]
pub(super) struct BoxTree {
    /// The boxes with their indices, ordered so that each node is a run of them.
    boxes: Vec<(Bounds, usize)>,
    nodes: Vec<Node>,
}

#[derive(Debug)]
struct Node {
    around: Bounds,
    from: usize,
    to: usize,
    /// Index of the first of two children that follow each other; none for a leaf.
    children: Option<usize>,
}

impl BoxTree {
    pub(super) fn new(boxes: impl IntoIterator<Item = Bounds>) -> Self {
        let boxes: Vec<_> = boxes.into_iter().enumerate().map(|(i, b)| (b, i)).collect();
        let mut tree = Self { nodes: Vec::new(), boxes };
        let count = tree.boxes.len();
        let root = tree.node(0, count);
        tree.nodes.push(root);
        let mut next = 0;
        while next < tree.nodes.len() {
            let (from, to) = (tree.nodes[next].from, tree.nodes[next].to);
            if to - from > LEAF {
                let size = tree.nodes[next].around.size();
                let key = |(bounds, _): &(Bounds, usize)| {
                    if size.x > size.y {
                        bounds.min.x + bounds.max.x
                    } else {
                        bounds.min.y + bounds.max.y
                    }
                };
                let middle = usize::midpoint(from, to);
                select(&mut tree.boxes[from..to], middle - from, key);
                tree.nodes[next].children = Some(tree.nodes.len());
                let halves = [tree.node(from, middle), tree.node(middle, to)];
                tree.nodes.extend(halves);
            }
            next += 1;
        }
        tree
    }

    fn node(&self, from: usize, to: usize) -> Node {
        let around =
            self.boxes[from..to].iter().map(|(b, _)| *b).fold(Bounds::EMPTY, Bounds::union);
        Node { around, from, to, children: None }
    }

    /// Whether any box meets `bounds`.
    pub(super) fn meets(&self, bounds: &Bounds) -> bool {
        let mut found = false;
        self.meeting(bounds, |_| {
            found = true;
            false
        });
        found
    }

    /// Calls `visit` with the index of every box that meets `bounds`, until it returns false.
    pub(super) fn meeting(&self, bounds: &Bounds, mut visit: impl FnMut(usize) -> bool) {
        let mut open = vec![0];
        while let Some(index) = open.pop() {
            let node = &self.nodes[index];
            if !node.around.meets(bounds) {
                continue;
            }
            if let Some(children) = node.children {
                open.extend([children, children + 1]);
                continue;
            }
            for (around, i) in &self.boxes[node.from..node.to] {
                if around.meets(bounds) && !visit(*i) {
                    return;
                }
            }
        }
    }
}
