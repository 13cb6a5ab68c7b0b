//! Why a picture cannot be painted.

use std::error::Error;
use std::fmt;

use super::viewport::MAX_SIDE;

/// Why a picture cannot be painted.
#[derive(Debug, Clone, PartialEq)]
pub enum PaintError {
    /// A side of the picture is zero or above the limit.
    Size {
        /// Width asked for, in device pixels.
        width: u32,
        /// Height asked for, in device pixels.
        height: u32,
    },
    /// A number of the viewport is not usable.
    View {
        /// Field of the viewport.
        field: &'static str,
        /// Its value.
        value: f64,
        /// What was expected.
        expected: &'static str,
    },
    /// A number of an item is not usable.
    Item {
        /// Layer of the item.
        layer: String,
        /// Field of the item.
        field: &'static str,
        /// Its value.
        value: f64,
        /// What was expected.
        expected: &'static str,
    },
    /// A mesh has another number of colours than of vertices.
    MeshColors {
        /// Layer of the mesh.
        layer: String,
        /// Number of colours.
        colors: usize,
        /// Number of vertices.
        vertices: usize,
    },
    /// A triangle names a vertex that is not there.
    MeshIndex {
        /// Layer of the mesh.
        layer: String,
        /// Position of the triangle, from 0.
        triangle: usize,
        /// The vertex it names.
        index: u32,
        /// Number of vertices.
        vertices: usize,
    },
}

impl fmt::Display for PaintError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Size { width, height } => {
                write!(f, "picture of {width} x {height} pixels: expected sides from 1 to {MAX_SIDE}")
            }
            Self::View { field, value, expected } => {
                write!(f, "viewport {field} is {value}: expected {expected}")
            }
            Self::Item { layer, field, value, expected } => {
                write!(f, "layer \"{layer}\", {field} is {value}: expected {expected}")
            }
            Self::MeshColors { layer, colors, vertices } => {
                write!(
                    f,
                    "layer \"{layer}\", mesh has {colors} colors: expected one for each of its {vertices} vertices"
                )
            }
            Self::MeshIndex { layer, triangle, index, vertices } => {
                write!(
                    f,
                    "layer \"{layer}\", mesh triangle {triangle} names vertex {index}: expected less than {vertices}"
                )
            }
        }
    }
}

impl Error for PaintError {}
