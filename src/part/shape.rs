//! Reference geometry.

use super::Path;
use super::raster::Tile;
use crate::geom::Bounds;
use glam::DVec2;
use std::rc::Rc;

/// Candidates for which a neighbourhood is not divided further.
const FEW: usize = 4;
/// Pixels of a neighbourhood that is not divided further.
const SMALL: usize = 4;

/// A shape in the plane to which distances are exact. Curves come as paths that follow them.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// A point.
    Point(DVec2),
    /// A line without ends, as an axis in its plane.
    Line {
        /// One of its points.
        through: DVec2,
        /// Its direction, of length 1.
        direction: DVec2,
    },
    /// A circle: the curve, not the disc.
    Circle {
        /// Its centre.
        center: DVec2,
        /// Its radius, above 0.
        radius: f64,
    },
    /// An open path.
    Open(Rc<Path>),
    /// A closed path.
    Closed(Rc<Path>),
}

impl Shape {
    /// Distance of a point to the shape, 0 on it.
    #[must_use]
    pub fn distance(&self, point: DVec2) -> f64 {
        match self {
            Self::Point(at) => point.distance(*at),
            Self::Line { through, direction } => (point - *through).perp_dot(*direction).abs(),
            Self::Circle { center, radius } => (point.distance(*center) - radius).abs(),
            Self::Open(path) | Self::Closed(path) => path.distance(point),
        }
    }

    /// Whether the shape parts the plane into an inside and an outside.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        matches!(self, Self::Circle { .. } | Self::Closed(_))
    }

    /// Whether a point lies inside; never of a shape that is not closed.
    #[must_use]
    pub fn contains(&self, point: DVec2) -> bool {
        match self {
            Self::Circle { center, radius } => point.distance_squared(*center) < radius * radius,
            Self::Closed(path) => path.contains(point),
            _ => false,
        }
    }

    /// The box of the shape; `None` of a line, which has no ends.
    #[must_use]
    pub fn bounds(&self) -> Option<Bounds> {
        match self {
            Self::Point(at) => Some(Bounds { min: *at, max: *at }),
            Self::Line { .. } => None,
            Self::Circle { center, radius } => {
                Some(Bounds { min: *center - DVec2::splat(*radius), max: *center + DVec2::splat(*radius) })
            }
            Self::Open(path) | Self::Closed(path) => Some(path.bounds()),
        }
    }

    /// Appends where a closed shape crosses the horizontal line at a height, in no order.
    pub(super) fn crossings(&self, height: f64, list: &mut Vec<f64>) {
        match self {
            Self::Circle { center, radius } => {
                let half = radius * radius - (height - center.y) * (height - center.y);
                if half > 0.0 {
                    list.extend([center.x - half.sqrt(), center.x + half.sqrt()]);
                }
            }
            Self::Closed(path) => path.crossings(height, list),
            _ => {}
        }
    }

    /// Lowers the squared distances of the pixels of a tile to those of this shape. `list` is a heap to work on.
    pub(super) fn lower(&self, tile: &Tile, squared: &mut [f64], list: &mut Vec<u32>) {
        match self {
            Self::Open(path) | Self::Closed(path) => {
                list.clear();
                let (center, radius) = tile.disc(tile.all());
                path.candidates(center, radius, list);
                lower(path, tile, tile.all(), 0..list.len(), list, squared);
            }
            _ => {
                for (index, least) in squared.iter_mut().enumerate() {
                    let distance = self.distance(tile.center(index % tile.width, index / tile.width));
                    *least = least.min(distance * distance);
                }
            }
        }
    }
}

/// Lowers the pixels of a block by candidates, which are narrowed down with the block.
fn lower(
    path: &Path,
    tile: &Tile,
    block: [usize; 4],
    candidates: std::ops::Range<usize>,
    list: &mut Vec<u32>,
    squared: &mut [f64],
) {
    let [x, y, width, height] = block;
    if candidates.len() <= FEW || width * height <= SMALL {
        for j in y..y + height {
            for i in x..x + width {
                let least = &mut squared[j * tile.width + i];
                *least = least.min(path.among(&list[candidates.clone()], tile.center(i, j)));
            }
        }
        return;
    }
    let halves = if width >= height {
        [[x, y, width / 2, height], [x + width / 2, y, width - width / 2, height]]
    } else {
        [[x, y, width, height / 2], [x, y + height / 2, width, height - height / 2]]
    };
    for half in halves {
        let start = list.len();
        let (center, radius) = tile.disc(half);
        path.narrow(center, radius, candidates.clone(), list);
        lower(path, tile, half, start..list.len(), list, squared);
        list.truncate(start);
    }
}

/// Whether a segment lies on a shape, to within a tolerance: its ends and the places between at every eighth do.
pub(super) fn lies_on(shape: &Shape, (start, end): (DVec2, DVec2), tolerance: f64) -> bool {
    let place = |n: u32| start.lerp(end, f64::from(n) / 8.0);
    (0..=8).all(|n| shape.distance(place(n)) <= tolerance)
}
