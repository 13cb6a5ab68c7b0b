//! One sampled curve.

use crate::curve::Samples;
use glam::DVec2;

/// A sampled curve: a closed one as a counter-clockwise polygon, whose vertex at the seam counts once, or an open one as a polyline.
///
/// What is asked of the edges of a polygon may be asked of a polyline: the edge that would close it is its last vertex, without length.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// Vertices, counter-clockwise on a closed curve.
    pub points: Vec<DVec2>,
    /// Right-hand unit normal of the curve at each vertex, outward on a closed one.
    pub normals: Vec<DVec2>,
    /// Share of the whole arc length between each vertex and the next; they sum to 1. After the last vertex of an open curve it is 0.
    pub shares: Vec<f64>,
    /// Whether the last vertex is followed by the first.
    pub closed: bool,
}

impl Outline {
    /// Takes points of a closed curve with their normals; the shares are those of the chords.
    ///
    /// # Panics
    /// When there are fewer than three points, or as many normals as points are not given.
    #[must_use]
    pub fn new(points: Vec<DVec2>, normals: Vec<DVec2>) -> Self {
        assert!(points.len() >= 3 && points.len() == normals.len(), "three points at least, a normal each");
        Self::of_chords(points, normals, true)
    }

    /// Takes points of an open curve with their normals; the shares are those of the chords.
    ///
    /// # Panics
    /// As [`new`](Self::new).
    #[must_use]
    pub fn open(points: Vec<DVec2>, normals: Vec<DVec2>) -> Self {
        assert!(points.len() >= 3 && points.len() == normals.len(), "three points at least, a normal each");
        Self::of_chords(points, normals, false)
    }

    fn of_chords(points: Vec<DVec2>, normals: Vec<DVec2>, closed: bool) -> Self {
        let mut outline = Self { shares: vec![0.0; points.len()], points, normals, closed };
        let chord = |i: usize| {
            let (from, to) = outline.edge(i);
            from.distance(to)
        };
        let chords: Vec<f64> = (0..outline.len()).map(chord).collect();
        let length: f64 = chords.iter().sum();
        outline.shares = chords.iter().map(|chord| chord / length).collect();
        outline
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

    /// Start and end of the edge that begins at vertex `i`; twice the vertex at the end of an open curve.
    #[must_use]
    pub fn edge(&self, i: usize) -> (DVec2, DVec2) {
        let next = if i + 1 < self.len() {
            i + 1
        } else if self.closed {
            0
        } else {
            i
        };
        (self.points[i], self.points[next])
    }
}

impl From<&Samples> for Outline {
    fn from(samples: &Samples) -> Self {
        let n = samples.arc.len();
        let end = |i: usize| if i + 1 < n { samples.arc[i + 1] } else { samples.arc[0] + samples.length };
        let shares = (0..n).map(|i| (end(i) - samples.arc[i]) / samples.length).collect();
        // The last sample of an open curve is its end.
        let closed = samples.arc[n - 1] < samples.length;
        Self { points: samples.points.clone(), normals: samples.normals.clone(), shares, closed }
    }
}
