//! One sampled curve.

use crate::curve::Samples;
use glam::DVec2;

/// A closed curve sampled into a counter-clockwise polygon; the vertex at the seam counts once.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// Vertices, counter-clockwise.
    pub points: Vec<DVec2>,
    /// Outward unit normal of the curve at each vertex.
    pub normals: Vec<DVec2>,
    /// Share of the whole arc length between each vertex and the next; they sum to 1.
    pub shares: Vec<f64>,
}

impl Outline {
    /// Takes points with their normals; the shares are those of the chords.
    ///
    /// # Panics
    /// When there are fewer than three points, or as many normals as points are not given.
    #[must_use]
    pub fn new(points: Vec<DVec2>, normals: Vec<DVec2>) -> Self {
        assert!(points.len() >= 3 && points.len() == normals.len(), "three points at least, a normal each");
        let next = points.iter().cycle().skip(1);
        let chords: Vec<f64> = points.iter().zip(next).map(|(p, q)| p.distance(*q)).collect();
        let length: f64 = chords.iter().sum();
        let shares = chords.iter().map(|chord| chord / length).collect();
        Self { points, normals, shares }
    }

    /// Number of vertices.
    #[must_use]
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Tells whether there are no vertices; never true for an outline made by the functions of this module.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// Start and end of the edge that begins at vertex `i`.
    #[must_use]
    pub fn edge(&self, i: usize) -> (DVec2, DVec2) {
        (self.points[i], self.points[(i + 1) % self.len()])
    }
}
impl From<&Samples> for Outline {
    fn from(samples: &Samples) -> Self {
        let n = samples.arc.len();
        let end = |i: usize| if i + 1 < n { samples.arc[i + 1] } else { samples.arc[0] + samples.length };
        let shares = (0..n).map(|i| (end(i) - samples.arc[i]) / samples.length).collect();
        Self { points: samples.points.clone(), normals: samples.normals.clone(), shares }
    }
}
