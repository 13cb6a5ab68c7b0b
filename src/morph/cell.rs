//! Unit cells: the quadrilaterals between lines and in-between curves.

use super::Band;
use crate::material::Composition;
use glam::DVec2;

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
    /// Composition in the middle: the mean over the four corners.
    pub composition: Composition,
}

/// Returns the unit cells of a band cut into `stages` stages, line by line and from the first curve to the second.
#[must_use]
pub fn unit_cells(band: &Band, stages: usize) -> Vec<UnitCell> {
    let lines: Vec<_> = band.lines().collect();
    let cell = |line: usize, stage: usize| {
        let (this, next) = (lines[line], lines[(line + 1) % lines.len()]);
        let (near, far) = (stage as f64 / stages as f64, (stage + 1) as f64 / stages as f64);
        let middle = (near + far) / 2.0;
        UnitCell {
            line,
            stage,
            corners: [this.point(near), this.point(far), next.point(far), next.point(near)],
            composition: this.composition(middle).mix(&next.composition(middle), 0.5),
        }
    };
    let gaps = if band.is_closed() { lines.len() } else { lines.len().saturating_sub(1) };
    (0..gaps).flat_map(|line| (0..stages).map(move |stage| (line, stage))).map(|(l, s)| cell(l, s)).collect()
}
