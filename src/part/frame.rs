//! The pixels of a raster.

use super::{Body, Composing, Part};
use crate::field::Grid;
use crate::geom::Bounds;
use glam::{DVec2, dvec2};
use std::error::Error;
use std::fmt;

/// Most pixels of a raster: 2048 x 2048. More would take too long to hand over at once.
pub const MOST_PIXELS: usize = 1 << 22;
/// Most pixels of a raster with a body by the printed rule: 1024 x 1024.
pub const MOST_PRINTED_PIXELS: usize = 1 << 20;
/// Most memory that a raster may need, in bytes: 256 MiB.
pub const MOST_MEMORY: usize = 1 << 28;
/// A box in the plane, and how many pixels there are in it. Pixels stand in rows from the top, as in pictures; each is evaluated at its centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    bounds: Bounds,
    size: [usize; 2],
}

/// Why there is no such raster.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrameError {
    /// The box has no width or no height, or is not finite.
    Empty,
    /// There are no pixels, or more than [`MOST_PIXELS`].
    Pixels([usize; 2]),
    /// There are more than [`MOST_PRINTED_PIXELS`], and a body by the printed rule.
    Printed([usize; 2]),
    /// So many bytes would be needed, more than [`MOST_MEMORY`].
    Memory(usize),
}

impl fmt::Display for FrameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "the box has no area; expected a width and a height above 0"),
            Self::Pixels([x, y]) => {
                write!(f, "{x} x {y} pixels were found; expected 1 to {MOST_PIXELS} in all")
            }
            Self::Printed([x, y]) => write!(
                f,
                "{x} x {y} pixels were found; expected {MOST_PRINTED_PIXELS} in all at most, because a body is by the printed rule"
            ),
            Self::Memory(bytes) => {
                write!(f, "about {} MiB would be needed; expected {} at most", bytes >> 20, MOST_MEMORY >> 20)
            }
        }
    }
}

impl Error for FrameError {}

impl Frame {
    /// # Errors
    /// When the box has no area, or there are no pixels or too many.
    pub fn new(bounds: Bounds, size: [usize; 2]) -> Result<Self, FrameError> {
        let extent = bounds.max - bounds.min;
        if !(extent.is_finite() && extent.min_element() > 0.0) {
            return Err(FrameError::Empty);
        }
        match size[0].checked_mul(size[1]) {
            Some(1..=MOST_PIXELS) => Ok(Self { bounds, size }),
            _ => Err(FrameError::Pixels(size)),
        }
    }

    /// The box.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Pixels along x and y.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Number of pixels.
    #[must_use]
    pub fn count(&self) -> usize {
        self.size[0] * self.size[1]
    }

    /// Width and height of a pixel.
    #[must_use]
    pub fn step(&self) -> DVec2 {
        (self.bounds.max - self.bounds.min) / dvec2(self.size[0] as f64, self.size[1] as f64)
    }

    /// The centre of pixel `i` of row `j`.
    #[must_use]
    pub fn center(&self, i: usize, j: usize) -> DVec2 {
        let step = self.step();
        let offset = dvec2(i as f64 + 0.5, j as f64 + 0.5) * step;
        dvec2(self.bounds.min.x + offset.x, self.bounds.max.y - offset.y)
    }

    /// The grid of the pixels, for kernels on grids.
    #[must_use]
    pub fn grid(&self) -> Option<Grid> {
        let step = self.step();
        Grid::new([self.size[0], self.size[1], 1], [step.x, step.y, 1.0]).ok()
    }

    /// Refuses a raster of a part that is too large.
    ///
    /// # Errors
    /// When more memory is needed than [`MOST_MEMORY`], or a body by the printed rule has more than [`MOST_PRINTED_PIXELS`].
    pub fn check(&self, part: &Part) -> Result<(), FrameError> {
        let memory = self.memory(part);
        let is_printed = |body: &Body| body.composing == Composing::Printed;
        if self.count() > MOST_PRINTED_PIXELS && part.bodies.iter().flatten().any(is_printed) {
            return Err(FrameError::Printed(self.size));
        }
        if memory > MOST_MEMORY { Err(FrameError::Memory(memory)) } else { Ok(()) }
    }

    /// Bytes that the raster of a part needs.
    #[must_use]
    pub fn memory(&self, part: &Part) -> usize {
        // A number of the body, a leaf, a fraction of each material, and a colour.
        let each = 9 + 4 * part.materials;
        let printed = part.bodies.iter().flatten().filter(|body| body.composing == Composing::Printed);
        // Distances to each feature, what the job makes, and two transforms with their marks.
        let most = printed.map(|body| 4 * (body.features.len() + part.materials) + 40).max().unwrap_or(0);
        self.count() * (each + most)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_without_area_and_beyond_memory_are_refused() {
        let bounds = |width: f64| Bounds { min: DVec2::ZERO, max: dvec2(width, 1.0) };
        assert_eq!(Frame::new(bounds(0.0), [4, 4]), Err(FrameError::Empty));
        assert_eq!(Frame::new(bounds(f64::INFINITY), [4, 4]), Err(FrameError::Empty));
        assert_eq!(Frame::new(bounds(1.0), [0, 4]), Err(FrameError::Pixels([0, 4])));
        assert_eq!(Frame::new(bounds(1.0), [2049, 2048]), Err(FrameError::Pixels([2049, 2048])));
        let frame = Frame::new(bounds(1.0), [2048, 2048]).expect("a frame");
        let empty = |materials: usize| Part { materials, bodies: Vec::new() };
        assert!(matches!(frame.check(&empty(16)), Err(FrameError::Memory(bytes)) if bytes > MOST_MEMORY));
        assert_eq!(frame.check(&empty(2)), Ok(()));
    }

    /// Rows from the top: the first pixel is at the upper left.
    #[test]
    fn pixels_are_evaluated_at_their_centres() {
        let bounds = Bounds { min: dvec2(10.0, 20.0), max: dvec2(14.0, 22.0) };
        let frame = Frame::new(bounds, [4, 2]).expect("a frame");
        assert_eq!((frame.center(0, 0), frame.center(3, 1)), (dvec2(10.5, 21.5), dvec2(13.5, 20.5)));
    }
}
