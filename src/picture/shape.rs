//! Items in pixels of a picture, cut to what can show.

use glam::DVec2;

use super::clip::{Frame, Piece};
use super::coverage::alternate;
use super::grid::{GridLine, grid_lines};
use super::hatch::{Blends, Lines};
use super::mesh::PlacedMesh;
use super::window::Window;
use super::{Item, Path, StrokeStyle, Viewport};
use crate::material::Color;

/// Room round the picture in which lines are kept, in device pixels on top of their width: more than what
/// anti-aliasing and a cut end can touch.
const MARGIN: f64 = 16.0;

/// Dashes with a shorter period are drawn solid, in device pixels; finer ones cannot be seen.
const FINEST_DASH: f64 = 0.5;

/// Largest error of the chords of a circle, in device pixels.
const CHORD_ERROR: f64 = 0.02;

/// A colour with the strength it is laid on with.
#[derive(Clone, Copy)]
pub(super) struct Ink {
    pub(super) color: Color,
    /// 0 to 255.
    pub(super) opacity: u32,
}

/// What is painted in one go: lines and the like are united before their ink is laid on.
pub(super) enum Shape {
    /// Whole columns and rows of pixels.
    Grid { columns: Vec<usize>, rows: Vec<bool>, ink: Ink },
    /// Lines of a width, and the lengths of dash and gap, in pixels.
    Lines { pieces: Vec<Piece>, width: f32, dash: Option<[f64; 2]>, ink: Ink },
    /// The inside of rings, even-odd.
    Fill { rings: Vec<Vec<DVec2>>, window: Window, ink: Ink },
    /// A mesh inside an outline, if it has one.
    Mesh { mesh: PlacedMesh, outline: Option<Vec<Vec<DVec2>>>, window: Window, opacity: u32 },
    /// The lines of up to three materials, whose fractions are the values of a plain mesh.
    Hatch { mesh: PlacedMesh, lines: Vec<Lines>, outline: Option<Vec<Vec<DVec2>>>, window: Window, ink: Ink },
}

impl Ink {
    fn new(color: Color, opacity: f32) -> Self {
        Self { color, opacity: (opacity * 255.0).round() as u32 }
    }

    fn of(style: &StrokeStyle) -> Self {
        Self::new(style.color, style.opacity)
    }
}

/// The shapes of an item that can show, from below.
pub(super) fn shapes(item: &Item, viewport: &Viewport) -> Vec<Shape> {
    let placing = Placing { viewport, ratio: viewport.pixel_ratio as f32 };
    match item {
        Item::Grid { minor, major } => placing.grid(minor, major).into(),
        Item::Mesh { mesh, outline, opacity } => {
            let mesh = PlacedMesh::new(mesh, viewport);
            placing.mesh(mesh, outline, *opacity).into_iter().collect()
        }
        Item::Stroke { path, style } => vec![placing.stroke(path, style)],
        Item::Fill { path, color, opacity } => {
            placing.fill(path, Ink::new(*color, *opacity)).into_iter().collect()
        }
        Item::Hatch { blends, materials, outline, color } => {
            let ink = Ink::new(*color, 1.0);
            materials.chunks(3).filter_map(|three| placing.hatch(blends, three, outline, ink)).collect()
        }
        Item::Dots { centers, radius_px, color, opacity } => {
            let pieces = placing.marks(centers, *radius_px).map(Piece::dot).collect();
            let width = 2.0 * radius_px * placing.ratio;
            vec![Shape::Lines { pieces, width, dash: None, ink: Ink::new(*color, *opacity) }]
        }
        Item::Rings { centers, radius_px, style } => {
            let radius = f64::from(radius_px * placing.ratio);
            let places = placing.marks(centers, radius_px + style.width_px);
            vec![placing.lines(places.map(|at| circle(at, radius)).collect(), style)]
        }
        Item::Crosses { centers, size_px, style } => {
            let arm = f64::from(size_px * placing.ratio / 2.0);
            let bars = |at: DVec2| {
                [DVec2::new(arm, arm), DVec2::new(arm, -arm)].map(|arm| Piece {
                    points: vec![at - arm, at + arm],
                    closed: false,
                    start: 0.0,
                })
            };
            let places = placing.marks(centers, size_px + style.width_px);
            vec![placing.lines(places.flat_map(bars).collect(), style)]
        }
    }
}

#[derive(Clone, Copy)]
struct Placing<'a> {
    viewport: &'a Viewport,
    ratio: f32,
}

impl Placing<'_> {
    fn window(self) -> Window {
        Window::whole(self.viewport.width, self.viewport.height)
    }

    /// The picture and as much round it as a mark of the given size in CSS pixels can reach in from.
    fn frame(self, size_px: f32) -> Frame {
        Frame::around(self.viewport, MARGIN + f64::from(size_px * self.ratio))
    }

    /// Places of the marks that can show.
    fn marks(self, centers: &[DVec2], size_px: f32) -> impl Iterator<Item = DVec2> {
        let frame = self.frame(size_px);
        centers.iter().map(move |&p| self.viewport.place(p)).filter(move |&p| frame.contains(p))
    }

    /// Solid lines.
    fn lines(self, pieces: Vec<Piece>, style: &StrokeStyle) -> Shape {
        Shape::Lines { pieces, width: style.width_px * self.ratio, dash: None, ink: Ink::of(style) }
    }

    fn stroke(self, path: &Path, style: &StrokeStyle) -> Shape {
        let dash = style.dash.map(|dash| dash.map(|length| f64::from(length * self.ratio)));
        let dash = dash.filter(|[on, off]| on + off >= FINEST_DASH && *off > 0.0);
        let pieces = self.frame(style.width_px).pieces(path, self.viewport, dash.is_some());
        Shape::Lines { pieces, width: style.width_px * self.ratio, dash, ink: Ink::of(style) }
    }

    /// The rings of a path on the picture and the pixels that they reach.
    fn polygons(self, path: &Path) -> Option<(Vec<Vec<DVec2>>, Window)> {
        let mut rings = Frame::around(self.viewport, 0.0).polygons(path, self.viewport);
        alternate(&mut rings);
        let window = self.window().around(rings.iter().flatten().copied())?;
        Some((rings, window))
    }

    fn fill(self, path: &Path, ink: Ink) -> Option<Shape> {
        self.polygons(path).map(|(rings, window)| Shape::Fill { rings, window, ink })
    }

    fn mesh(self, mesh: PlacedMesh, outline: &Path, opacity: f32) -> Option<Shape> {
        let opacity = (opacity * 255.0).round() as u32;
        let (outline, window) = self.extent(&mesh, outline)?;
        Some(Shape::Mesh { mesh, outline, window, opacity })
    }

    fn hatch(self, blends: &Blends, materials: &[usize], outline: &Path, ink: Ink) -> Option<Shape> {
        let shares = |vertex: usize| {
            std::array::from_fn(|k| {
                materials.get(k).map_or(0.0, |&material| blends.fraction(vertex, material))
            })
        };
        let vertices = blends.vertices.iter().enumerate().map(|(i, &p)| (p, shares(i)));
        let mesh = PlacedMesh::plain(vertices, &blends.triangles, self.viewport);
        let lines = materials.iter().map(|&material| Lines::new(material, self.viewport)).collect();
        let (outline, window) = self.extent(&mesh, outline)?;
        Some(Shape::Hatch { mesh, lines, outline, window, ink })
    }

    /// The outline of a mesh on the screen, if it has one, and the pixels that the mesh may touch.
    fn extent(self, mesh: &PlacedMesh, outline: &Path) -> Option<(Option<Vec<Vec<DVec2>>>, Window)> {
        if outline.rings.is_empty() {
            return Some((None, self.window().around(mesh.corners())?));
        }
        let (rings, window) = self.polygons(outline)?;
        Some((Some(rings), window))
    }

    /// Grid lines on whole pixels, so that they stay crisp; no pixel twice, so that crossings do not show.
    fn grid(self, minor: &StrokeStyle, major: &StrokeStyle) -> [Shape; 2] {
        let [columns, rows] = grid_lines(self.viewport);
        [(minor, false), (major, true)].map(|(style, strong)| {
            let band = style.width_px * self.ratio;
            let across = |lines: &[GridLine], side: u32| {
                let mut marked = vec![false; side as usize];
                for line in lines.iter().filter(|line| line.major == strong && band > 0.0) {
                    let thick = f64::from(band).round().max(1.0);
                    let first = (line.at - thick / 2.0).round();
                    let range = first.max(0.0) as usize..(first + thick).clamp(0.0, side.into()) as usize;
                    marked.get_mut(range).into_iter().flatten().for_each(|mark| *mark = true);
                }
                marked
            };
            let columns = across(&columns, self.viewport.width);
            let columns = (0..columns.len()).filter(|&x| columns[x]).collect();
            Shape::Grid { columns, rows: across(&rows, self.viewport.height), ink: Ink::of(style) }
        })
    }
}

/// A circle as a closed line.
fn circle(center: DVec2, radius: f64) -> Piece {
    let step = 2.0 * (1.0 - (CHORD_ERROR / radius).min(0.5)).acos();
    let count = (std::f64::consts::TAU / step).ceil() as usize;
    let points = (0..count).map(|k| center + radius * DVec2::from_angle(k as f64 * step)).collect();
    Piece { points, closed: true, start: 0.0 }
}
