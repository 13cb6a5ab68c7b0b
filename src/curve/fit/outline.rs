//! The points as the fit works on them: without repetitions, about the origin, of size one.

use glam::DVec2;

use super::error::FitError;
use crate::geom::Bounds;

/// Most points that are taken.
pub const MOST_POINTS: usize = 20_000;
/// Largest absolute value of a coordinate, that of curves.
const LARGEST_COORDINATE: f64 = 1e12;
/// Points closer than this, in sizes of the whole, are one.
pub(super) const SAME: f64 = 1e-9;
/// Points within this distance of a line, in sizes of the whole, are on it.
const FLAT: f64 = 1e-9;

/// A closed list of different points in coordinates about the middle of their box, in halves of its diagonal.
#[derive(Debug, Clone)]
pub(super) struct Outline {
    /// The first one is not repeated.
    pub(super) points: Vec<DVec2>,
    /// The index of each point in the list given; the first of those that coincide.
    pub(super) indices: Vec<usize>,
    center: DVec2,
    /// Length of one unit.
    pub(super) size: f64,
    /// Whether the last point of the list repeats the first.
    pub(super) repeats_first: bool,
}

impl Outline {
    pub(super) fn new(given: &[DVec2]) -> Result<Self, FitError> {
        if given.len() > MOST_POINTS {
            return Err(FitError::TooManyPoints { count: given.len(), limit: MOST_POINTS });
        }
        for (index, &point) in given.iter().enumerate() {
            if !(point.is_finite() && point.abs().max_element() <= LARGEST_COORDINATE) {
                return Err(FitError::Point { index, point, limit: LARGEST_COORDINATE });
            }
        }
        let Some(bounds) = Bounds::of(given.iter().copied()) else {
            return Err(FitError::TooFewPoints { count: 0 });
        };
        let (center, size) = (bounds.center(), bounds.diagonal() / 2.0);
        // Where coordinates are large for their differences, or tiny, digits are missing.
        let noise = 1e-13 * bounds.min.abs().max(bounds.max.abs()).max_element();
        if size <= noise.max(1e-60) {
            return Err(FitError::TooFewPoints { count: 1 });
        }
        let mut outline =
            Self { points: Vec::new(), indices: Vec::new(), center, size, repeats_first: false };
        for (index, &point) in given.iter().enumerate() {
            let point = (point - center) / size;
            if outline.points.last().is_none_or(|last| last.distance(point) > SAME) {
                outline.points.push(point);
                outline.indices.push(index);
            }
        }
        while outline.points.len() > 1
            && outline.points[0].distance(outline.points[outline.points.len() - 1]) <= SAME
        {
            outline.points.pop();
            outline.indices.pop();
            outline.repeats_first = true;
        }
        if outline.points.len() < 3 {
            return Err(FitError::TooFewPoints { count: outline.points.len() });
        }
        if is_flat(&outline.points) {
            return Err(FitError::Flat { at: given[0] });
        }
        Ok(outline)
    }

    /// A point in the coordinates given.
    pub(super) fn place(&self, point: DVec2) -> DVec2 {
        self.center + point * self.size
    }

    /// A distance in the lengths given, with the rounding that the coordinates have suffered.
    pub(super) fn distance(&self, distance: f64) -> f64 {
        let rounding = 4.0 * f64::EPSILON * (self.center.abs().max_element() + self.size);
        distance * self.size + rounding
    }
}

/// Whether points lie on one line.
fn is_flat(points: &[DVec2]) -> bool {
    let first = points[0];
    let farther =
        |a: DVec2, b: DVec2| if b.distance_squared(first) > a.distance_squared(first) { b } else { a };
    let along = (points.iter().copied().fold(first, farther) - first).normalize_or_zero();
    points.iter().all(|p| along.perp_dot(*p - first).abs() <= FLAT)
}
