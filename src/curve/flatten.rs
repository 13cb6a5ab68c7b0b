//! Polygons that follow a curve.

use glam::DVec2;

use super::bezier::Bezier;
use super::bspline::BSpline;

/// Smallest tolerance relative to the size of the curve; a finer polygon has millions of vertices.
const FINEST: f64 = 1e-9;
/// Most halvings of a piece; at the finest tolerance ordinary pieces need 16.
const MAX_DEPTH: usize = 24;

impl BSpline {
    /// The vertices of a polygon no farther than `tolerance` from the curve, with their parameters; of an open curve, of a polyline from end
    /// to end.
    ///
    /// Parameters ascend strictly from lo; the seam is there once, at the start; the polygon closes from the last
    /// vertex to the first. At least three vertices. Between two neighbours the curve stays within `tolerance` of
    /// the segment that joins them. The number of vertices grows like the root of 1 / `tolerance`; a
    /// tolerance below 1e-9 of the size of the curve counts as that, and so does one that is not a number.
    #[must_use]
    pub fn flatten(&self, tolerance: f64) -> Vec<(f64, DVec2)> {
        let bounds = self.bounds();
        let tolerance = tolerance.max(FINEST * bounds.diagonal());
        let pieces = self.pieces(bounds.center());
        // A curve of one or two pieces is cut so that even the coarsest polygon has three vertices.
        let least_depth = if pieces.len() < 3 { 2 } else { 0 };
        let mut vertices = Vec::with_capacity(4 * pieces.len());
        for piece in pieces {
            let mut open = vec![(piece, 0)];
            while let Some((part, depth)) = open.pop() {
                if depth >= least_depth && (depth == MAX_DEPTH || is_flat(&part, tolerance)) {
                    vertices.push((part.lo, self.point(part.lo)));
                } else {
                    let (left, right) = part.halves();
                    open.push((right, depth + 1));
                    open.push((left, depth + 1));
                }
            }
        }
        if !self.is_closed() {
            let end = self.domain().1;
            vertices.push((end, self.point(end)));
        }
        vertices
    }
}

/// Whether the control points, and with them the curve, stay within `tolerance` of the chord.
fn is_flat(piece: &Bezier, tolerance: f64) -> bool {
    reach_squared(&piece.points, piece.points[0], piece.points[piece.degree()]) <= tolerance * tolerance
}

/// Square of the greatest distance of control points, and so at least of their curve, from the segment `start end`.
pub(super) fn reach_squared(points: &[DVec2], start: DVec2, end: DVec2) -> f64 {
    let chord = end - start;
    let length_sq = chord.length_squared();
    points.iter().fold(0.0, |reach: f64, point| {
        let offset = *point - start;
        let along = if length_sq > 0.0 { (offset.dot(chord) / length_sq).clamp(0.0, 1.0) } else { 0.0 };
        reach.max(offset.distance_squared(chord * along))
    })
}
