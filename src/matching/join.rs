//! Lines on their way from stars to pairs.

use super::value::End;
use glam::DVec2;

/// One end of a line.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spot {
    /// Vertex of the sampled outline; an inserted one has no number.
    pub(super) vertex: Option<usize>,
    /// Parameter and arc length before whole laps are counted, so that equal ends have equal places.
    pub(super) parameter: f64,
    pub(super) arc: f64,
    pub(super) laps: f64,
    pub(super) end: End,
}

impl Spot {
    /// Parameter with the laps, on a curve of this period.
    pub(super) fn parameter(&self, period: f64) -> f64 {
        self.parameter + self.laps * period
    }

    /// Arc length with the laps, on a curve of this length.
    pub(super) fn arc(&self, length: f64) -> f64 {
        self.arc + self.laps * length
    }
}

/// A line of the set, with the gap it belongs to or begins.
#[derive(Debug, Clone, Copy)]
pub(super) struct Join {
    pub(super) ends: [Spot; 2],
    pub(super) gap: usize,
}

impl Join {
    pub(super) fn is_inserted(&self) -> bool {
        self.ends.iter().any(|end| end.vertex.is_none())
    }
}

/// From one line that insertion keeps to the next.
#[derive(Debug)]
pub(super) struct Gap {
    pub(super) kept: Join,
    pub(super) inserted: Vec<Join>,
    pub(super) stars: Vec<Join>,
    /// Where an inserted line failed.
    pub(super) failed: Option<DVec2>,
}
