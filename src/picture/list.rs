//! What a picture is made of: items in layers, from below.

use glam::DVec2;

use super::PaintError;
use super::hatch::Blends;
use crate::material::{Color, Oklab};

/// Largest stroke width, radius or dash that is painted, in CSS pixels.
const MAX_STROKE: f32 = 1000.0;

/// Polygons or polylines that are drawn as one: where they overlap, nothing is painted twice.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Path {
    /// The points of each ring, in document units. A closed ring may repeat its first point at the end or not.
    pub rings: Vec<Vec<DVec2>>,
    /// Whether each ring returns to its first point.
    pub closed: bool,
}

impl Path {
    /// One closed ring.
    #[must_use]
    pub fn closed(ring: Vec<DVec2>) -> Self {
        Self { rings: vec![ring], closed: true }
    }

    /// One open polyline.
    #[must_use]
    pub fn open(points: Vec<DVec2>) -> Self {
        Self { rings: vec![points], closed: false }
    }
}

/// How a line is drawn. Joins and ends are round; the ends of dashes are flat.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StrokeStyle {
    /// Width in CSS pixels, 0 to 1000; 0 draws nothing.
    pub width_px: f32,
    /// Colour.
    pub color: Color,
    /// Opacity, 0 to 1.
    pub opacity: f32,
    /// Lengths of dash and gap in CSS pixels, 0 to 1000; a period below half a device pixel is drawn solid.
    pub dash: Option<[f32; 2]>,
}

impl StrokeStyle {
    /// A solid line.
    #[must_use]
    pub const fn solid(width_px: f32, color: Color, opacity: f32) -> Self {
        Self { width_px, color, opacity, dash: None }
    }

    /// The same line with dashes and gaps of the given lengths in CSS pixels.
    #[must_use]
    pub const fn dashed(self, dash: f32, gap: f32) -> Self {
        Self { dash: Some([dash, gap]), ..self }
    }
}

/// Triangles with a colour at each vertex, linear in Oklab between them. Triangles may turn either way.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    /// Vertices in document units.
    pub vertices: Vec<DVec2>,
    /// Colour of each vertex.
    pub colors: Vec<Oklab>,
    /// Indices of the three vertices of each triangle.
    pub triangles: Vec<[u32; 3]>,
}

/// One thing to draw.
#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// A coordinate grid whose step follows the zoom, see [`grid_step`](super::grid_step).
    Grid {
        /// Lines at the minor step.
        minor: StrokeStyle,
        /// Lines at the major step.
        major: StrokeStyle,
    },
    /// A mesh filled smoothly: every pixel once, no seams inside, the outline anti-aliased.
    Mesh {
        /// The triangles.
        mesh: Mesh,
        /// Closed rings round the mesh, even-odd. Pixels they cover take the colour of the mesh there or, where the mesh
        /// misses them, of the nearest pixel it does not miss; what lies outside is cut. Without rings the mesh is drawn as
        /// it is, with a stepped edge.
        outline: Path,
        /// Opacity, 0 to 1.
        opacity: f32,
    },
    /// A line.
    Stroke {
        /// Where.
        path: Path,
        /// How.
        style: StrokeStyle,
    },
    /// The inside of closed rings, even-odd. An open path is closed.
    Fill {
        /// Where.
        path: Path,
        /// Colour.
        color: Color,
        /// Opacity, 0 to 1.
        opacity: f32,
    },
    /// Hatches that tell the fractions of materials: the angle which, the share of the area that is covered how much.
    Hatch {
        /// The triangles.
        blends: Blends,
        /// Indices of the materials that have lines.
        materials: Vec<usize>,
        /// Closed rings round the triangles, even-odd, as of a mesh.
        outline: Path,
        /// Colour of the lines.
        color: Color,
    },
    /// Discs of one size on the screen.
    Dots {
        /// Middle points in document units.
        centers: Vec<DVec2>,
        /// Radius in CSS pixels.
        radius_px: f32,
        /// Colour.
        color: Color,
        /// Opacity, 0 to 1.
        opacity: f32,
    },
    /// Circles of one size on the screen.
    Rings {
        /// Middle points in document units.
        centers: Vec<DVec2>,
        /// Radius in CSS pixels.
        radius_px: f32,
        /// Line; its dash is left out.
        style: StrokeStyle,
    },
    /// Small diagonal crosses, the marks of witness points.
    Crosses {
        /// Middle points in document units.
        centers: Vec<DVec2>,
        /// Width and height in CSS pixels.
        size_px: f32,
        /// Line; its dash is left out.
        style: StrokeStyle,
    },
}

/// Items under one name, which becomes the id of their group in SVG.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// Name.
    pub name: String,
    /// Items, from below.
    pub items: Vec<Item>,
}

/// A picture: layers over a background.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DisplayList {
    /// Colour behind everything; without one the picture is transparent.
    pub background: Option<Color>,
    /// Layers, from below.
    pub layers: Vec<Layer>,
}

impl DisplayList {
    /// A picture without layers.
    #[must_use]
    pub const fn new(background: Option<Color>) -> Self {
        Self { background, layers: Vec::new() }
    }

    /// Adds an item on top, to the uppermost layer when it has that name, else to a new layer.
    pub fn push(&mut self, layer: &str, item: Item) {
        match self.layers.last_mut() {
            Some(last) if last.name == layer => last.items.push(item),
            _ => self.layers.push(Layer { name: layer.to_owned(), items: vec![item] }),
        }
    }
}

impl Item {
    /// Refuses numbers that cannot be drawn; `layer` is named in the error.
    pub(super) fn check(&self, layer: &str) -> Result<(), PaintError> {
        let number = |field, value: f32, most: f32, expected| {
            if (0.0..=most).contains(&value) {
                return Ok(());
            }
            Err(PaintError::Item { layer: layer.to_owned(), field, value: value.into(), expected })
        };
        let opacity = |value| number("opacity", value, 1.0, "0 to 1");
        let pixels = |field, value| number(field, value, MAX_STROKE, "0 to 1000 pixels");
        let stroke = |style: &StrokeStyle| {
            pixels("stroke width", style.width_px)?;
            style.dash.iter().flatten().try_for_each(|&length| pixels("dash", length))?;
            opacity(style.opacity)
        };
        let finite = |points: &[DVec2]| match points.iter().find(|p| !p.is_finite()) {
            None => Ok(()),
            Some(p) => Err(PaintError::Item {
                layer: layer.to_owned(),
                field: "coordinate",
                value: if p.x.is_finite() { p.y } else { p.x },
                expected: "a finite number",
            }),
        };
        let rings = |path: &Path| path.rings.iter().try_for_each(|ring| finite(ring));
        match self {
            Self::Grid { minor, major } => stroke(minor).and_then(|()| stroke(major)),
            Self::Mesh { mesh, outline, opacity: value } => {
                opacity(*value)?;
                finite(&mesh.vertices)?;
                rings(outline)?;
                mesh.check(layer)
            }
            Self::Stroke { path, style } => stroke(style).and_then(|()| rings(path)),
            Self::Fill { path, opacity: value, .. } => opacity(*value).and_then(|()| rings(path)),
            Self::Hatch { blends, outline, .. } => {
                finite(&blends.vertices)?;
                rings(outline)?;
                check_mesh(layer, blends.vertices.len(), blends.mixes.len(), &blends.triangles)
            }
            Self::Dots { centers, radius_px, opacity: value, .. } => {
                pixels("radius", *radius_px)?;
                opacity(*value)?;
                finite(centers)
            }
            Self::Rings { centers, radius_px: size, style }
            | Self::Crosses { centers, size_px: size, style } => {
                pixels("size", *size)?;
                stroke(style)?;
                finite(centers)
            }
        }
    }
}

impl Mesh {
    fn check(&self, layer: &str) -> Result<(), PaintError> {
        check_mesh(layer, self.vertices.len(), self.colors.len(), &self.triangles)?;
        for color in &self.colors {
            if let Some(&value) = [color.l, color.a, color.b].iter().find(|v| !(-10.0..=10.0).contains(*v)) {
                return Err(PaintError::Item {
                    layer: layer.to_owned(),
                    field: "mesh color",
                    value: value.into(),
                    expected: "an Oklab coordinate of at most 10 either way",
                });
            }
        }
        Ok(())
    }
}

/// Refuses a mesh without a colour for each vertex, or whose triangles name others.
fn check_mesh(layer: &str, vertices: usize, colors: usize, triangles: &[[u32; 3]]) -> Result<(), PaintError> {
    if colors != vertices {
        return Err(PaintError::MeshColors { layer: layer.to_owned(), colors, vertices });
    }
    for (triangle, corners) in triangles.iter().enumerate() {
        if let Some(&index) = corners.iter().find(|&&i| i as usize >= vertices) {
            return Err(PaintError::MeshIndex { layer: layer.to_owned(), triangle, index, vertices });
        }
    }
    Ok(())
}
