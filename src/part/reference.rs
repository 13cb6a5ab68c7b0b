//! What distances are measured to.

use super::Shape;
use super::raster::Tile;
use super::shape::lies_on;
use super::{Path, Region};
use glam::DVec2;
use std::rc::Rc;

/// Share of the size of a body within which a piece of its boundary lies on a shape.
const ON: f64 = 1e-6;

/// One shape or several, of which the nearest counts.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference(Vec<Shape>);

impl Reference {
    /// A shape.
    #[must_use]
    pub fn shape(shape: Shape) -> Self {
        Self(vec![shape])
    }

    /// The boundary of a region, without what lies on some shapes: "everything but" them. `None` when nothing is left.
    ///
    /// A circle of the boundary is left out as a whole, where it is one of the shapes; of paths every segment that lies on one of them.
    #[must_use]
    pub fn boundary(region: &Region, except: &[Shape]) -> Option<Self> {
        let tolerance = ON * region.bounds().diagonal();
        let is_left_out = |ends: (DVec2, DVec2)| except.iter().any(|shape| lies_on(shape, ends, tolerance));
        let left = region.rings().filter(|ring| !except.contains(ring)).filter_map(|ring| match ring {
            Shape::Closed(path) if !except.is_empty() => {
                let kept: Vec<(DVec2, DVec2)> = path.ends().filter(|ends| !is_left_out(*ends)).collect();
                if kept.len() == path.ends().len() {
                    return Some(ring.clone());
                }
                Path::of(kept).map(|path| Shape::Open(Rc::new(path)))
            }
            _ => Some(ring.clone()),
        });
        let left: Vec<Shape> = left.collect();
        (!left.is_empty()).then_some(Self(left))
    }

    /// The shapes.
    #[must_use]
    pub fn shapes(&self) -> &[Shape] {
        &self.0
    }

    /// Distance of a point to the nearest shape.
    #[must_use]
    pub fn distance(&self, point: DVec2) -> f64 {
        self.0.iter().map(|shape| shape.distance(point)).fold(f64::INFINITY, f64::min)
    }

    /// Writes the distances of the pixels of a tile.
    pub(super) fn measure(&self, tile: &Tile, distances: &mut [f64], list: &mut Vec<u32>) {
        distances.fill(f64::INFINITY);
        // A shape that is farther from the centre than the nearest one by the width of the tile is the nearest one of no pixel.
        let (center, radius) = tile.disc(tile.all());
        let reach = self.distance(center) + 2.0 * radius;
        for shape in &self.0 {
            if self.0.len() == 1 || shape.distance(center) <= reach * (1.0 + 1e-12) {
                shape.lower(tile, distances, list);
            }
        }
        distances.iter_mut().for_each(|distance| *distance = distance.sqrt());
    }
}
