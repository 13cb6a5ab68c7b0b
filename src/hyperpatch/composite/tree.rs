//! A tree of boxes.

use glam::DVec3;

/// Axis-parallel boxes, each given by its lowest and highest corner, in a binary tree: halved by their middles along
/// the longest axis until few are left.
#[derive(Debug, Clone)]
pub(super) struct Tree {
    nodes: Vec<Node>,
    /// Indices of the boxes; each leaf has a stretch of them.
    order: Vec<u32>,
    boxes: Vec<(DVec3, DVec3)>,
}

#[derive(Debug, Clone)]
struct Node {
    lo: DVec3,
    hi: DVec3,
    content: Content,
}

#[derive(Debug, Clone)]
enum Content {
    /// Stretch of the order.
    Leaf(usize, usize),
    /// The other child is the next node.
    Inner { second: usize },
}

/// Most boxes of a leaf.
const LEAF: usize = 4;

impl Tree {
    pub(super) fn new(boxes: Vec<(DVec3, DVec3)>) -> Self {
        let count = boxes.len();
        let mut tree = Self { nodes: Vec::new(), order: (0..count as u32).collect(), boxes };
        if count > 0 {
            tree.build(0, count);
        }
        tree
    }

    /// Indices of the boxes that share a point with a box, ascending.
    pub(super) fn meeting(&self, lo: DVec3, hi: DVec3) -> Vec<usize> {
        let meets = |a: DVec3, b: DVec3| a.cmple(hi).all() && lo.cmple(b).all();
        let mut found = Vec::new();
        let mut stack = if self.nodes.is_empty() { Vec::new() } else { vec![0] };
        while let Some(at) = stack.pop() {
            let node = &self.nodes[at];
            if !meets(node.lo, node.hi) {
                continue;
            }
            match node.content {
                Content::Inner { second } => stack.extend([at + 1, second]),
                Content::Leaf(from, to) => {
                    let indices = self.order[from..to].iter().map(|&n| n as usize);
                    found.extend(indices.filter(|&n| meets(self.boxes[n].0, self.boxes[n].1)));
                }
            }
        }
        found.sort_unstable();
        found
    }

    /// The box at an index.
    pub(super) fn bounds(&self, index: usize) -> (DVec3, DVec3) {
        self.boxes[index]
    }

    /// Adds the node of a stretch of the order, and those below it.
    fn build(&mut self, from: usize, to: usize) {
        let start = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let boxes = &self.boxes;
        let (lo, hi) = self.order[from..to]
            .iter()
            .map(|&n| boxes[n as usize])
            .fold(start, |(lo, hi), (a, b)| (lo.min(a), hi.max(b)));
        let node = self.nodes.len();
        self.nodes.push(Node { lo, hi, content: Content::Leaf(from, to) });
        if to - from <= LEAF {
            return;
        }
        let axis = (hi - lo).max_position();
        let middle = |n: u32| boxes[n as usize].0[axis] + boxes[n as usize].1[axis];
        let half = (to - from) / 2;
        self.order[from..to].select_nth_unstable_by(half, |&a, &b| middle(a).total_cmp(&middle(b)));
        self.build(from, from + half);
        self.nodes[node].content = Content::Inner { second: self.nodes.len() };
        self.build(from + half, to);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::test_cells::random_place;

    #[test]
    fn the_tree_finds_what_a_list_finds() {
        let boxes: Vec<_> = (0..300)
            .map(|n| {
                let lo = random_place(n);
                (lo, lo + random_place(n + 1000) * 0.1)
            })
            .collect();
        let tree = Tree::new(boxes.clone());
        for n in 0..100 {
            let lo = random_place(n + 5000);
            let hi = lo + random_place(n + 6000) * 0.2;
            let expected: Vec<usize> =
                (0..300).filter(|&i| boxes[i].0.cmple(hi).all() && lo.cmple(boxes[i].1).all()).collect();
            assert_eq!(tree.meeting(lo, hi), expected);
        }
        assert!(Tree::new(Vec::new()).meeting(DVec3::ZERO, DVec3::ONE).is_empty());
    }
}
