//! Which vertices see each other.

use super::Outline;
use crate::geom::{SegmentGrid, orient2d, segments_meet};
use glam::DVec2;

/// An edge of one of the two polygons: it starts at vertex `vertex` of outline `outline`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Edge {
    /// 0 for the first curve, 1 for the second.
    pub outline: usize,
    /// Index of the vertex at which the edge starts.
    pub vertex: usize,
}

/// Returns an edge that blocks the line from vertex `from` of the first polygon to vertex `to` of the second, or `None` when
/// the two see each other.
///
/// The closed line must meet no edge of either polygon other than the two edges at each of its own ends (constraint 2 of Eq.
/// 10 in the paper): grazing a vertex blocks, and so does running along an edge into its far end. Signs are exact. This is
/// the plain version that looks at every edge; [`Greedy`](super::Greedy) gets the same answers from a grid.
#[must_use]
pub fn blocking_edge(outlines: &[Outline; 2], from: usize, to: usize) -> Option<Edge> {
    let (p, q) = (outlines[0].points[from], outlines[1].points[to]);
    [(0, from), (1, to)].into_iter().find_map(|(outline, own)| {
        let polygon = &outlines[outline];
        let n = polygon.len();
        (0..n).filter(|&k| k != own && (k + 1) % n != own).find_map(|vertex| {
            let (a, b) = polygon.edge(vertex);
            segments_meet(p, q, a, b).then_some(Edge { outline, vertex })
        })
    })
}

/// Answers visibility from a grid over the edges of both polygons.
#[derive(Debug, Clone)]
pub(super) struct Sight {
    grid: SegmentGrid,
    counts: [usize; 2],
    /// The edge that blocked the last line asked for: its neighbours are often blocked by the same one.
    last_blocker: usize,
}

impl Sight {
    pub(super) fn new(outlines: &[Outline; 2]) -> Self {
        let edges = outlines.iter().flat_map(|o| (0..o.len()).map(|i| o.edge(i))).collect();
        let counts = [outlines[0].len(), outlines[1].len()];
        Self { grid: SegmentGrid::new(edges), counts, last_blocker: 0 }
    }

    /// Tells whether vertex `from` of the first polygon and vertex `to` of the second see each other.
    pub(super) fn is_clear(&mut self, from: usize, to: usize) -> bool {
        let [a, b] = self.counts;
        let previous = |i: usize, n: usize| if i == 0 { n - 1 } else { i - 1 };
        let own = [from, previous(from, a), a + to, a + previous(to, b)];
        let (p, q) = (self.grid.segments()[from].0, self.grid.segments()[a + to].0);
        let blocks = |k: usize, c: DVec2, d: DVec2| !own.contains(&k) && segments_meet(p, q, c, d);
        let (c, d) = self.grid.segments()[self.last_blocker];
        if blocks(self.last_blocker, c, d) {
            return false;
        }
        match self.grid.find(p, q, blocks) {
            Some(edge) => {
                self.last_blocker = edge;
                false
            }
            None => true,
        }
    }
}

/// The wedge of a polygon's inside at one vertex; of an open polyline, of what lies to its left. Its ends have all directions on either side.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wedge {
    before: DVec2,
    at: DVec2,
    after: DVec2,
    convex: bool,
    is_end: bool,
}

impl Wedge {
    pub(super) fn new(outline: &Outline, vertex: usize) -> Self {
        let n = outline.len();
        let point = |i: usize| outline.points[i % n];
        let (before, at, after) = (point(vertex + n - 1), point(vertex), point(vertex + 1));
        let is_end = !outline.closed && (vertex == 0 || vertex + 1 == n);
        Self { before, at, after, convex: orient2d(before, at, after) >= 0.0, is_end }
    }

    /// Tells whether the ray from the vertex through `point` starts strictly inside the polygon.
    pub(super) fn points_inside(&self, point: DVec2) -> bool {
        self.is_end
            || self.both(|edge_start, edge_end| orient2d(edge_start, edge_end, point) > 0.0, self.convex)
    }

    /// Tells whether the ray from the vertex through `point` starts strictly outside the polygon.
    pub(super) fn points_outside(&self, point: DVec2) -> bool {
        self.is_end
            || self.both(|edge_start, edge_end| orient2d(edge_start, edge_end, point) < 0.0, !self.convex)
    }

    fn both(&self, holds: impl Fn(DVec2, DVec2) -> bool, and: bool) -> bool {
        let first = holds(self.before, self.at);
        if first != and { first } else { holds(self.at, self.after) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec2;

    fn outline(points: &[(f64, f64)]) -> Outline {
        let points: Vec<DVec2> = points.iter().map(|&(x, y)| dvec2(x, y)).collect();
        let normals = vec![DVec2::X; points.len()];
        Outline::new(points, normals)
    }

    /// A square inside a square twice its size, both with collinear vertices in the middle of their sides.
    fn squares() -> [Outline; 2] {
        let side = |r: f64| [(r, 0.0), (r, r), (0.0, r), (-r, r), (-r, 0.0), (-r, -r), (0.0, -r), (r, -r)];
        [outline(&side(1.0)), outline(&side(2.0))]
    }

    #[test]
    fn grazing_a_vertex_and_running_along_an_edge_block() {
        let squares = squares();
        assert_eq!(blocking_edge(&squares, 0, 0), None, "straight across");
        assert!(blocking_edge(&squares, 0, 4).is_some(), "through the inner square");
        // From (0, 1) to (2, 1) would run along the inner side into its corner (1, 1).
        let squares = [squares[0].clone(), outline(&[(2.0, 1.0), (0.0, 3.0), (-3.0, 0.0), (0.0, -3.0)])];
        assert!(blocking_edge(&squares, 2, 0).is_some());
        assert_eq!(blocking_edge(&squares, 1, 0), None, "from the corner itself the way is free");
    }

    #[test]
    fn sight_by_grid_equals_sight_by_every_edge() {
        let squares = squares();
        let mut sight = Sight::new(&squares);
        for from in 0..8 {
            for to in 0..8 {
                assert_eq!(
                    sight.is_clear(from, to),
                    blocking_edge(&squares, from, to).is_none(),
                    "{from} to {to}"
                );
            }
        }
    }

    #[test]
    fn wedges_of_a_dart() {
        let dart = outline(&[(0.0, 0.0), (2.0, -1.0), (0.0, 2.0), (-2.0, -1.0)]);
        let tip = Wedge::new(&dart, 2);
        assert!(tip.points_inside(dvec2(0.0, 0.0)) && !tip.points_outside(dvec2(0.0, 0.0)));
        assert!(tip.points_outside(dvec2(3.0, 3.0)) && !tip.points_inside(dvec2(3.0, 3.0)));
        let notch = Wedge::new(&dart, 0);
        assert!(notch.points_inside(dvec2(1.5, 0.0)), "a reflex vertex opens wide");
        assert!(notch.points_outside(dvec2(0.0, -1.0)));
        let along = dvec2(4.0, -2.0);
        assert!(!notch.points_inside(along) && !notch.points_outside(along), "along an edge is neither");
    }
}
