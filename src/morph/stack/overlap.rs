//! Whether the in-between curves of a cubic blend keep apart in the plane.

use super::blend::{StackBlend, Strand};
use crate::geom::orient2d;
use glam::DVec2;

/// A place where a cubic blend lies over itself or over a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overlap {
    /// Number of the span.
    pub span: usize,
    /// The middle of a cell that is turned over.
    pub at: DVec2,
}

/// How far a cell may be turned over by rounding, as a share of the square of its size.
const ROUNDING: f64 = 1e-12;

impl StackBlend {
    /// Finds a cell between strand `strand` and the next that a cubic blend turns over, in a span whose curves have the same height; `None` where there is
    /// none.
    ///
    /// Between simple curves the in-between curves of a level span cross neither each other nor a curve when every cell between two strands and two of
    /// the curves keeps its sense of rotation; one that is turned over lies over its neighbours. Cells are those that are drawn. Where
    /// the straight lines are out of order themselves, which the certificates of the matching tell, the blend is not blamed.
    #[must_use]
    pub fn overlap_at(&self, strand: usize) -> Option<Overlap> {
        if !self.is_cubic() {
            return None;
        }
        let count = self.strands.len();
        let [this, next] = [&self.strands[strand], &self.strands[(strand + 1) % count]];
        (0..self.spans()).filter(|&span| self.is_level(span)).find_map(|span| {
            let corners = |a: f64, b: f64| {
                [(this, a), (this, b), (next, b), (next, a)]
                    .map(|(strand, share): (&Strand, f64)| self.point(strand, span, share))
            };
            let whole = corners(0.0, 1.0);
            let sense = if area(whole) < 0.0 { -1.0 } else { 1.0 };
            let slack = ROUNDING * whole.iter().map(|p| p.distance_squared(whole[0])).fold(0.0, f64::max);
            if !keeps(whole, sense, slack) {
                return None;
            }
            let cuts = self.cuts();
            let cell = |k: usize| corners(k as f64 / cuts as f64, (k + 1) as f64 / cuts as f64);
            let turned = (0..cuts).map(cell).find(|&cell| !keeps(cell, sense, slack))?;
            Some(Overlap { span, at: turned.iter().sum::<DVec2>() / 4.0 })
        })
    }

    /// Number of strands to ask [`overlap_at`](Self::overlap_at) about.
    #[must_use]
    pub fn gaps(&self) -> usize {
        if self.is_closed() { self.strands.len() } else { self.strands.len().saturating_sub(1) }
    }
}

/// Twice the area of a quadrilateral, signed.
fn area([a, b, c, d]: [DVec2; 4]) -> f64 {
    (c - a).perp_dot(d - b)
}

/// Whether a quadrilateral is cut by one of its diagonals into two triangles of a sense.
fn keeps([a, b, c, d]: [DVec2; 4], sense: f64, slack: f64) -> bool {
    let is = |x: DVec2, y: DVec2, z: DVec2| sense * orient2d(x, y, z) >= -slack;
    (is(a, b, c) && is(a, c, d)) || (is(a, b, d) && is(b, c, d))
}
