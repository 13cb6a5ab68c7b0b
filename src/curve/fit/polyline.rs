//! The polyline that a spline follows.

use glam::DVec2;

/// Vertices in order, and the length of the way to each of them.
#[derive(Debug, Clone)]
pub(super) struct Polyline {
    /// At least two; the first one is repeated at the end of a closed polyline. Neighbours differ.
    pub(super) points: Vec<DVec2>,
    /// Ascending strictly from 0.
    pub(super) arc: Vec<f64>,
}

impl Polyline {
    pub(super) fn new(points: Vec<DVec2>) -> Self {
        let mut way = 0.0;
        let mut arc = Vec::with_capacity(points.len());
        arc.push(0.0);
        for pair in points.windows(2) {
            way += pair[0].distance(pair[1]);
            arc.push(way);
        }
        Self { points, arc }
    }

    pub(super) fn length(&self) -> f64 {
        self.arc[self.arc.len() - 1]
    }

    /// The point at a length of the way in `[0, length]`, its edge looked for from an earlier one on; updates the edge.
    pub(super) fn at(&self, edge: &mut usize, s: f64) -> DVec2 {
        while *edge + 2 < self.arc.len() && s >= self.arc[*edge + 1] {
            *edge += 1;
        }
        let (lo, hi) = (self.arc[*edge], self.arc[*edge + 1]);
        self.points[*edge].lerp(self.points[*edge + 1], ((s - lo) / (hi - lo)).clamp(0.0, 1.0))
    }
}
