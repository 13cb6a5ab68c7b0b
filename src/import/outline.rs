//! A closed polyline and its corners, while it is being read.

use crate::geom::{Bounds, signed_area};
use glam::DVec2;

/// Largest absolute value of a coordinate, that of curves.
pub(super) const LARGEST_COORDINATE: f64 = 1e12;
/// An area below this, relative to the square of the size, is none.
const FLAT: f64 = 1e-9;

/// Vertices, the first one not repeated, and the indices of corners among them, ascending.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Outline {
    pub(super) points: Vec<DVec2>,
    pub(super) corners: Vec<usize>,
}

impl Outline {
    /// Leaves out vertices that repeat the one before and a last one that repeats the first, and refuses what has no area.
    pub(super) fn checked(self) -> Result<Self, String> {
        let mut outline = Self::default();
        let mut corners = self.corners.iter().peekable();
        for (index, &point) in self.points.iter().enumerate() {
            let is_corner = corners.next_if(|&&corner| corner == index).is_some();
            if outline.points.last() != Some(&point) {
                outline.points.push(point);
            }
            if is_corner {
                outline.corners.push(outline.points.len() - 1);
            }
        }
        while outline.points.len() > 1 && outline.points.first() == outline.points.last() {
            outline.points.pop();
            if outline.corners.pop_if(|corner| *corner == outline.points.len()).is_some() {
                outline.corners.insert(0, 0);
            }
        }
        outline.corners.dedup();
        let Some(bounds) = Bounds::of(outline.points.iter().copied()) else {
            return Err("it has no points".to_owned());
        };
        if !(bounds.min.is_finite() && bounds.max.is_finite())
            || bounds.min.abs().max(bounds.max.abs()).max_element() > LARGEST_COORDINATE
        {
            return Err(format!("its coordinates are not all within {LARGEST_COORDINATE:e}"));
        }
        if outline.points.len() < 3 {
            return Err(format!(
                "it has {} different points; a closed shape has at least 3",
                outline.points.len()
            ));
        }
        // A figure eight has an area for each lobe, which may cancel: what is flat has no width either.
        let size = bounds.max - bounds.min;
        let is_thin = size.min_element() <= FLAT * size.max_element();
        let has_area = signed_area(&outline.points).abs() > FLAT * size.length_squared();
        if is_thin || !(has_area || has_width(&outline.points, size.length())) {
            return Err("it encloses no area".to_owned());
        }
        Ok(outline)
    }
}

/// Whether some point lies off the line through the first one and the one farthest from it.
fn has_width(points: &[DVec2], size: f64) -> bool {
    let first = points[0];
    let farther =
        |a: DVec2, b: DVec2| if b.distance_squared(first) > a.distance_squared(first) { b } else { a };
    let along = (points.iter().copied().fold(first, farther) - first).normalize_or_zero();
    points.iter().any(|p| along.perp_dot(*p - first).abs() > FLAT * size)
}

/// Length of a closed polyline.
pub(super) fn length(points: &[DVec2]) -> f64 {
    (0..points.len()).map(|i| points[i].distance(points[(i + 1) % points.len()])).sum()
}
