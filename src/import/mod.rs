//! Shapes from elsewhere: closed outlines in SVG text and in lists of points, and triangles in STL files.
//!
//! Whatever is read becomes a [`Shape`], a closed polyline with y up, dense enough to be fitted by [`crate::curve::fit`].
//! What cannot become one is listed with the reason. Text that is none of the kinds is refused with the line
//! or the path of the value, what was found and what was expected.

mod fit;
mod outline;
mod points;
mod stl;
mod svg;
mod svg_path;
mod svg_transform;

#[cfg(not(target_arch = "wasm32"))]
use crate::document::Json;
use crate::document::{Code, DocumentError};
use glam::DVec2;

pub use fit::{fit_error, read_fit_options};
pub use points::{from_json, from_lines};
pub use stl::{LONGEST_STL, MOST_TRIANGLES, ReadMesh, from_stl};
pub use svg::from_svg;

/// Longest text that is read, in bytes.
pub const LONGEST_TEXT: usize = 8 << 20;
/// Most points of lists, all lists together, and most points that an outline of SVG is drawn with.
pub const MOST_POINTS: usize = crate::curve::MOST_FIT_POINTS;
/// Most shapes that are read; more are skipped.
pub const MOST_SHAPES: usize = 200;
/// Longest name of a shape, in characters: that of a curve of a document.
const LONGEST_NAME: usize = 100;

/// A closed outline.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// The name it has where it comes from, or what it is and the how manieth.
    pub name: String,
    /// Whether it was drawn closed; else a straight edge joins its ends.
    pub closed: bool,
    /// Vertices in order, the first one not repeated; at least three that differ, around an area.
    pub points: Vec<DVec2>,
    /// Indices of the vertices that were drawn as corners, ascending; empty for lists of points.
    pub corners: Vec<usize>,
    /// Area inside, not negative; parts wound twice count twice.
    pub area: f64,
    /// Length of the outline.
    pub length: f64,
}

/// Something that was found and did not become a shape.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Skipped {
    /// Its name, as that of a shape.
    pub name: String,
    /// Why.
    pub reason: String,
}

/// What was read from a text.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Shapes {
    /// The shapes, in the order of the text.
    pub shapes: Vec<Shape>,
    /// What was skipped, in the order of the text.
    pub skipped: Vec<Skipped>,
}

/// What kind of text to read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Format {
    /// Told by the first character.
    Auto,
    /// SVG.
    Svg,
    /// Lists of points: lines of numbers, or JSON.
    Points,
}

/// How a text is to be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    /// By [`from_svg`].
    Svg,
    /// By [`from_json`].
    Json,
    /// By [`from_lines`].
    Lines,
}

/// Tells how a text is to be read: markup and JSON by their first character, anything else as lines of numbers.
///
/// # Errors
/// With code `limit` beyond [`LONGEST_TEXT`] bytes; with code `syntax` when there is nothing but space.
pub fn kind_of(text: &str, format: Format) -> Result<Kind, DocumentError> {
    if text.len() > LONGEST_TEXT {
        let message = format!("the text has {} bytes; at most {LONGEST_TEXT} are read", text.len());
        return Err(DocumentError::new(Code::Limit, "", message));
    }
    match (text.trim_start_matches(|c: char| c.is_whitespace() || c == '\u{feff}').chars().next(), format) {
        (None, _) => Err(DocumentError::new(Code::Syntax, "", "the text is empty; expected SVG or points")),
        (_, Format::Svg) | (Some('<'), Format::Auto) => Ok(Kind::Svg),
        (Some('[' | '{'), _) => Ok(Kind::Json),
        _ => Ok(Kind::Lines),
    }
}

/// Reads the shapes of a text.
///
/// # Errors
/// When the text is empty, too long, or not what it seems to be; see [`from_svg`], [`from_json`], [`from_lines`].
#[cfg(not(target_arch = "wasm32"))]
pub fn read_shapes(text: &str, format: Format) -> Result<Shapes, DocumentError> {
    match kind_of(text, format)? {
        Kind::Svg => from_svg(text),
        Kind::Json => from_json(&Json::parse(text)?),
        Kind::Lines => from_lines(text),
    }
}

impl Shapes {
    /// Adds an outline as a shape, or says why it is none.
    fn push(&mut self, name: &str, closed: bool, outline: Result<outline::Outline, String>) {
        let name: String = name.chars().take(LONGEST_NAME).collect();
        let outline = outline.and_then(|outline| {
            if self.shapes.len() < MOST_SHAPES {
                outline.checked()
            } else {
                Err(format!("at most {MOST_SHAPES} shapes are read"))
            }
        });
        match outline {
            Ok(outline::Outline { points, corners }) => {
                let (area, length) = (crate::geom::signed_area(&points).abs(), outline::length(&points));
                self.shapes.push(Shape { name, closed, points, corners, area, length });
            }
            Err(reason) => self.skipped.push(Skipped { name, reason }),
        }
    }
}
