//! A binary tree over the pieces of a curve, refined where a search needs it.

use glam::DVec2;

use super::bezier::Bezier;
use super::cone::Cone;
use crate::geom::Bounds;

/// Index of a node in a [`HullTree`].
pub(super) type NodeId = usize;

/// A stretch of a curve with what is known about it.
#[derive(Debug, Clone)]
pub(super) struct Node {
    /// Box that holds the stretch.
    pub(super) bounds: Bounds,
    /// Diagonal of the box.
    pub(super) size: f64,
    /// Cone of the directions in which the stretch runs.
    pub(super) cone: Cone,
    /// First and last parameter.
    pub(super) range: (f64, f64),
    content: Content,
    children: Option<(NodeId, NodeId)>,
}

#[derive(Debug, Clone)]
enum Content {
    Piece(Bezier, Strip),
    Several,
}

/// The box of a stretch in the direction of its chord, which runs from `start` to `end`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Strip {
    pub(super) start: DVec2,
    pub(super) end: DVec2,
    /// Unit vector along the box.
    pub(super) direction: DVec2,
    /// Smallest and largest coordinate along the direction, from `start`.
    pub(super) along: (f64, f64),
    /// Smallest and largest coordinate to the left of the direction, from `start`.
    pub(super) across: (f64, f64),
}

impl Strip {
    fn of(points: &[DVec2]) -> Self {
        let (start, end) = (points[0], points[points.len() - 1]);
        let far = points
            .iter()
            .copied()
            .max_by(|a, b| a.distance_squared(start).total_cmp(&b.distance_squared(start)));
        let toward = |p: DVec2| (p - start).try_normalize();
        // A closed stretch has no chord; the farthest control point gives a direction then.
        let direction = toward(end).or_else(|| far.and_then(toward)).unwrap_or(DVec2::X);
        let mut strip = Self { start, end, direction, along: (0.0, 0.0), across: (0.0, 0.0) };
        (strip.along, strip.across) = strip.extent_of(points);
        strip
    }

    /// Extent of points along and across this strip.
    pub(super) fn extent_of(&self, points: &[DVec2]) -> ((f64, f64), (f64, f64)) {
        let empty = (f64::INFINITY, f64::NEG_INFINITY);
        points.iter().fold((empty, empty), |(along, across), p| {
            let offset = *p - self.start;
            let (x, y) = (self.direction.dot(offset), self.direction.perp_dot(offset));
            ((along.0.min(x), along.1.max(x)), (across.0.min(y), across.1.max(y)))
        })
    }

    /// Whether the stretch is its chord up to `tolerance`.
    pub(super) fn is_chord(&self, tolerance: f64) -> bool {
        let length = self.start.distance(self.end);
        self.across.1 - self.across.0 <= tolerance
            && self.along.0 >= -tolerance
            && self.along.1 <= length + tolerance
    }
}

/// Tree over consecutive pieces of a curve; a leaf is halved when its children are asked for the first time.
#[derive(Debug, Clone)]
pub(super) struct HullTree {
    nodes: Vec<Node>,
    /// Legs of a control polygon shorter than this have no direction.
    noise: f64,
}

impl HullTree {
    /// An empty tree for a curve whose legs shorter than `noise` are rounding errors.
    pub(super) fn new(noise: f64) -> Self {
        Self { nodes: Vec::new(), noise }
    }

    /// Adds consecutive pieces, at least one, and returns the node that holds them all.
    pub(super) fn add(&mut self, pieces: &[Bezier]) -> NodeId {
        let mut row: Vec<NodeId> = pieces.iter().map(|piece| self.add_piece(piece.clone())).collect();
        while row.len() > 1 {
            row = row
                .chunks(2)
                .map(|pair| if let [a, b] = *pair { self.join(a, b) } else { pair[0] })
                .collect();
        }
        row[0]
    }

    pub(super) fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id]
    }

    /// The Bezier curve of a node of one piece and its strip.
    pub(super) fn piece(&self, id: NodeId) -> Option<(&Bezier, &Strip)> {
        match &self.nodes[id].content {
            Content::Piece(piece, strip) => Some((piece, strip)),
            Content::Several => None,
        }
    }

    /// The two halves of a node, in the order of the curve.
    pub(super) fn children(&mut self, id: NodeId) -> (NodeId, NodeId) {
        if let Some(children) = self.nodes[id].children {
            return children;
        }
        let halves = match &self.nodes[id].content {
            Content::Piece(piece, _) => piece.halves(),
            Content::Several => unreachable!("a node of several pieces is made from its children"),
        };
        let children = (self.add_piece(halves.0), self.add_piece(halves.1));
        self.nodes[id].children = Some(children);
        children
    }

    fn add_piece(&mut self, piece: Bezier) -> NodeId {
        let strip = Strip::of(&piece.points);
        let bounds = Bounds::around(piece.points[0], piece.points[1..].iter().copied());
        self.nodes.push(Node {
            bounds,
            size: bounds.diagonal(),
            cone: Cone::of_legs(&piece.points, self.noise),
            range: (piece.lo, piece.hi),
            content: Content::Piece(piece, strip),
            children: None,
        });
        self.nodes.len() - 1
    }

    fn join(&mut self, a: NodeId, b: NodeId) -> NodeId {
        let (first, second) = (&self.nodes[a], &self.nodes[b]);
        let bounds = first.bounds.union(second.bounds);
        self.nodes.push(Node {
            bounds,
            size: bounds.diagonal(),
            cone: first.cone.union(second.cone),
            range: (first.range.0, second.range.1),
            content: Content::Several,
            children: Some((a, b)),
        });
        self.nodes.len() - 1
    }
}
