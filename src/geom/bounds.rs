//! Axis-parallel boxes.

use glam::DVec2;

/// An axis-parallel box, closed; `min` is its lower left corner and `max` its upper right one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds {
    /// Lower left corner.
    pub min: DVec2,
    /// Upper right corner.
    pub max: DVec2,
}

impl Bounds {
    /// Returns the smallest box that holds all points, or `None` when there are none.
    #[must_use]
    pub fn of(points: impl IntoIterator<Item = DVec2>) -> Option<Self> {
        let mut points = points.into_iter();
        let first = points.next()?;
        Some(Self::around(first, points))
    }

    /// Returns the smallest box that holds the first point and the others.
    #[must_use]
    pub fn around(first: DVec2, others: impl IntoIterator<Item = DVec2>) -> Self {
        let start = Self { min: first, max: first };
        others.into_iter().fold(start, |b, p| Self { min: b.min.min(p), max: b.max.max(p) })
    }

    /// Returns the smallest box that holds both boxes.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Tells whether the two closed boxes share a point.
    #[must_use]
    pub fn meets(self, other: Self) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }

    /// Tells whether the boxes are farther apart than `distance` along an axis.
    #[must_use]
    pub fn is_beyond(self, other: Self, distance: f64) -> bool {
        (self.min - other.max).max(other.min - self.max).max_element() > distance
    }

    /// Length of the diagonal, the scale that tolerances refer to.
    #[must_use]
    pub fn diagonal(self) -> f64 {
        (self.max - self.min).length()
    }

    /// Middle of the box.
    #[must_use]
    pub fn center(self) -> DVec2 {
        (self.min + self.max) / 2.0
    }
}
