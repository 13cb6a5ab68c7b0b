//! Why visible lines cannot be matched.

use super::Stretch;
use std::fmt;

/// What stands in the way of a matching.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Obstacle {
    /// A pin names a vertex that does not exist.
    NoSuchVertex {
        /// Index of the pin.
        pin: usize,
    },
    /// The line of a pin meets a polygon.
    PinBlocked {
        /// Index of the pin.
        pin: usize,
    },
    /// The lines of two pins cross.
    PinsCross {
        /// Indices of the pins, ascending.
        pins: [usize; 2],
    },
    /// The vertices from one pin to the next cannot all have lines, although without pins they can.
    NoRoom {
        /// Indices of the two pins in cyclic order, equal when there is one pin.
        pins: [usize; 2],
    },
    /// The line that joins the first ends of open outlines, or the last ones, meets an outline.
    EndBlocked {
        /// Whether it is that of the last ends.
        last: bool,
    },
    /// The lines that join the ends of open outlines cross.
    EndsCross,
    /// Some vertices see no vertex of the other outline.
    Orphans,
    /// Each vertex sees some, but a stretch of neighbours cannot all have lines at once.
    Jammed(Stretch),
}

impl fmt::Display for Obstacle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NoSuchVertex { pin } => write!(f, "pin {pin} names a vertex that does not exist"),
            Self::PinBlocked { pin } => write!(f, "the line of pin {pin} meets a curve"),
            Self::PinsCross { pins: [i, k] } => write!(f, "the lines of pins {i} and {k} cross"),
            Self::NoRoom { pins: [i, k] } if i == k => {
                write!(f, "no matching holds pin {i}: not every vertex can have a line beside it")
            }
            Self::NoRoom { pins: [i, k] } => {
                write!(f, "no matching holds pins {i} and {k}: not every vertex between them can have a line")
            }
            Self::EndBlocked { last } => write!(
                f,
                "the line that joins the {} of the curves meets a curve",
                if last { "ends" } else { "starts" }
            ),
            Self::EndsCross => write!(f, "the lines that join the starts and the ends of the curves cross"),
            Self::Orphans => write!(f, "some vertices see no vertex of the other curve"),
            Self::Jammed(Stretch { outline, first, count }) => write!(
                f,
                "the {count} vertices of curve {outline} from vertex {first} on cannot all have lines at once"
            ),
        }
    }
}
