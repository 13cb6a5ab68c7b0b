//! Unit cells: the quadrilaterals between lines and in-between curves.

use super::Band;
use crate::material::Composition;
use glam::DVec2;

/// A corner is turned over where its Jacobian is below this share of the square of the longest diagonal, the wrong way.
const FLAT: f64 = 1e-12;

/// A quadrilateral between two neighbouring ruling lines and two neighbouring stages (Fig. 11 of the paper).
#[derive(Debug, Clone, PartialEq)]
pub struct UnitCell {
    /// Index of the ruling line at its start; the other side is the next line.
    pub line: usize,
    /// Index j of the stage at its side towards the first curve; the other side is stage j + 1.
    pub stage: usize,
    /// Corners, counter-clockwise where the first curve is the inner one, from the first line at stage j on: along the first
    /// line to stage j + 1, then on the next line back. Where lines share an end, two corners coincide.
    pub corners: [DVec2; 4],
    /// Area; parts that are turned over against the band as a whole count as negative.
    pub area: f64,
    /// Centre of the area; of a folded cell the mean of the corners.
    pub centroid: DVec2,
    /// Mean composition over the area; of a folded cell the mean over the corners.
    pub composition: Composition,
    /// Whether a part of the cell, or all of it, is turned over against the band as a whole.
    pub is_folded: bool,
}

/// Returns the unit cells of a band cut into `stages` stages, line by line and from the first curve to the second.
///
/// Each is the bilinear patch on its corners, and the composition is bilinear in it too, so that the means are exact.
#[must_use]
pub fn unit_cells(band: &Band, stages: usize) -> Vec<UnitCell> {
    let lines: Vec<_> = band.lines().collect();
    let cell = |line: usize, stage: usize| {
        let (this, next) = (lines[line], lines[(line + 1) % lines.len()]);
        let (near, far) = (stage as f64 / stages as f64, (stage + 1) as f64 / stages as f64);
        let corners = [this.point(near), this.point(far), next.point(far), next.point(near)];
        let patch = Patch::new(&corners);
        let mut weights = patch.weights();
        let area: f64 = weights.iter().sum();
        let turned = [1.0, -1.0].map(|sign| patch.is_turned(sign));
        if turned == [true; 2] || area.abs() < f64::MIN_POSITIVE {
            weights = [1.0; 4];
        }
        let [a, b, c, d] = weights;
        let side = |s: f64, from: f64, to: f64| {
            let share = to / (from + to);
            (this.point(s).lerp(next.point(s), share), this.composition(s).mix(&next.composition(s), share))
        };
        let (inner, outer, share) = (side(near, a, d), side(far, b, c), (b + c) / (a + b + c + d));
        let cell = UnitCell {
            line,
            stage,
            corners,
            area,
            centroid: inner.0.lerp(outer.0, share),
            composition: inner.1.mix(&outer.1, share),
            is_folded: turned[0],
        };
        (cell, turned[1])
    };
    let gaps = if band.is_closed() { lines.len() } else { lines.len().saturating_sub(1) };
    let cells = (0..gaps).flat_map(|line| (0..stages).map(move |stage| cell(line, stage)));
    let cells: Vec<_> = cells.collect();
    let is_clockwise = cells.iter().map(|(cell, _)| cell.area).sum::<f64>() < 0.0;
    let turned = |(mut cell, is_folded): (UnitCell, bool)| {
        if is_clockwise {
            cell.area = -cell.area;
            cell.is_folded = is_folded;
        }
        cell
    };
    cells.into_iter().map(turned).collect()
}

/// A bilinear patch on four corners.
pub(super) struct Patch {
    /// The Jacobian at each corner: positive where the polygon turns to the left.
    turns: [f64; 4],
    /// What counts as 0.
    flat: f64,
}

impl Patch {
    pub(super) fn new(corners: &[DVec2; 4]) -> Self {
        let turn = |k: usize| {
            let at = corners[k];
            (corners[(k + 1) % 4] - at).perp_dot(corners[(k + 3) % 4] - at)
        };
        let diagonals = corners[0].distance_squared(corners[2]).max(corners[1].distance_squared(corners[3]));
        Self { turns: [0, 1, 2, 3].map(turn), flat: FLAT * diagonals }
    }

    /// The weight of each corner in the integral of a bilinear function; their sum is the signed area.
    ///
    /// The Jacobian is bilinear as well, and the mass matrix of the square integrates the product of two bilinear functions.
    pub(super) fn weights(&self) -> [f64; 4] {
        let turn = |k: usize| self.turns[k % 4];
        [0, 1, 2, 3].map(|k| (4.0 * turn(k) + 2.0 * (turn(k + 1) + turn(k + 3)) + turn(k + 2)) / 36.0)
    }

    /// Tells whether a part turns to the right, with `sign` -1 to the left. The Jacobian is linear, so that the corners tell.
    pub(super) fn is_turned(&self, sign: f64) -> bool {
        self.turns.iter().any(|turn| turn * sign < -self.flat)
    }
}
