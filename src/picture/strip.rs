//! Some rows of a picture.

use std::ops::Range;

use super::blend::{blend, compose_block, straighten};
use super::clip::Piece;
use super::coverage::coverage;
use super::dash::{Stretch, dashes};
use super::hatch;
use super::lines::{Lines, is_clear};
use super::mesh::{Layer, PlacedMesh};
use super::shape::{Ink, Shape};
use super::window::Window;
use crate::material::Color;
use glam::DVec2;

/// Pixels composed together.
const BLOCK: usize = 16;

/// Rows of a mesh that are painted beyond those wanted, so that colours spread over the border from either side.
const OVERLAP: usize = 4;

/// Rows of a picture in premultiplied RGBA.
pub(super) struct Strip {
    width: usize,
    rows: Range<usize>,
    is_opaque: bool,
    data: Vec<u8>,
    lines: Lines,
}

impl Strip {
    /// Rows of the given width, filled with the background; without one they are transparent.
    pub(super) fn new(width: usize, rows: Range<usize>, background: Option<Color>) -> Self {
        let pixel = background.map_or([0; 4], |Color { r, g, b }| [r, g, b, 255]);
        let data = pixel.repeat(width * rows.len());
        Self { width, lines: Lines::new(width, rows.clone()), rows, is_opaque: background.is_some(), data }
    }

    /// Paints what a shape shows in these rows.
    pub(super) fn paint(&mut self, shape: &Shape) {
        match shape {
            Shape::Grid { columns, rows, ink } => self.grid(columns, rows, *ink),
            Shape::Lines { pieces, width, dash, ink } => self.line(pieces, *width, *dash, *ink),
            Shape::Fill { rings, window, ink } => self.fill(rings, window, *ink),
            Shape::Mesh { mesh, outline, window, opacity } => {
                self.mesh(mesh, outline.as_deref(), window, *opacity);
            }
            Shape::Hatch { mesh, lines, outline, window, ink } => {
                self.hatch(mesh, lines, outline.as_deref(), window, *ink);
            }
        }
    }

    /// The pixels, straight (not premultiplied).
    pub(super) fn finish(mut self) -> Vec<u8> {
        if !self.is_opaque {
            straighten(&mut self.data);
        }
        self.data
    }

    fn grid(&mut self, columns: &[usize], rows: &[bool], ink: Ink) {
        let pixels = self.data.chunks_exact_mut(self.width * 4);
        for (row, whole) in pixels.zip(&rows[self.rows.clone()]) {
            if *whole {
                row.chunks_exact_mut(4).for_each(|pixel| lay(pixel, ink, 255));
            } else {
                columns.iter().for_each(|x| lay(&mut row[x * 4..x * 4 + 4], ink, 255));
            }
        }
    }

    fn line(&mut self, pieces: &[Piece], width: f32, dash: Option<[f64; 2]>, ink: Ink) {
        if width <= 0.0 {
            return;
        }
        let reach = f64::from(width) / 2.0 + 1.0;
        let heights = self.rows.start as f64 - reach..self.rows.end as f64 + reach;
        for piece in pieces {
            match dash {
                None => piece.segments().for_each(|(a, b)| self.lines.add(&Stretch::round(a, b), width)),
                Some(dash) => dashes(piece, dash, heights.clone(), |stretch| self.lines.add(&stretch, width)),
            }
        }
        let data = &mut self.data;
        self.lines.drain(|index, cover| lay(&mut data[index * 4..index * 4 + 4], ink, cover));
    }

    fn fill(&mut self, rings: &[Vec<DVec2>], window: &Window, ink: Ink) {
        let Some(window) = window.in_rows(self.rows.clone()) else { return };
        let covers = coverage(rings, &window);
        for (row, covers) in window.rows.clone().zip(covers.chunks_exact(window.width())) {
            let start = self.start(row, &window);
            let pixels = self.data[start..].chunks_exact_mut(4).zip(covers);
            pixels.filter(|(_, cover)| **cover > 0).for_each(|(pixel, cover)| lay(pixel, ink, *cover));
        }
    }

    fn mesh(&mut self, mesh: &PlacedMesh, outline: Option<&[Vec<DVec2>]>, window: &Window, opacity: u32) {
        let Some((shown, layer, covers)) = self.layer(mesh, outline, window) else { return };
        let width = shown.width();
        for row in shown.rows.clone() {
            let (start, first) = (self.start(row, &shown), layer.window.index(shown.columns.start, row));
            let targets = self.data[start..start + width * 4].chunks_mut(BLOCK * 4);
            let pixels = layer.pixels[first..first + width].chunks(BLOCK);
            let covers = covers[first..first + width].chunks(BLOCK);
            for ((targets, pixels), covers) in targets.zip(pixels).zip(covers).filter(|(_, c)| !is_clear(c)) {
                compose_block(targets, pixels, covers, opacity);
            }
        }
    }

    fn hatch(
        &mut self,
        mesh: &PlacedMesh,
        lines: &[hatch::Lines],
        outline: Option<&[Vec<DVec2>]>,
        window: &Window,
        ink: Ink,
    ) {
        let Some((shown, layer, covers)) = self.layer(mesh, outline, window) else { return };
        for row in shown.rows.clone() {
            let (start, first) = (self.start(row, &shown), layer.window.index(shown.columns.start, row));
            for (k, column) in shown.columns.clone().enumerate() {
                let (shares, cover) = (layer.pixels[first + k], covers[first + k]);
                if cover == 0 || shares[3] == 0 {
                    continue;
                }
                let center = DVec2::new(column as f64 + 0.5, row as f64 + 0.5);
                let bare =
                    lines.iter().zip(shares).filter(|(_, share)| *share > 0).fold(1.0, |bare, (l, share)| {
                        bare * (1.0 - l.coverage(center, f64::from(share) / 255.0))
                    });
                let strength = (f64::from(cover) * (1.0 - bare)).round() as u8;
                let at = start + k * 4;
                lay(&mut self.data[at..at + 4], ink, strength);
            }
        }
    }

    /// A mesh in these rows and some round them: the pixels that show, all that are painted, and how much of each the outline covers.
    fn layer(
        &self,
        mesh: &PlacedMesh,
        outline: Option<&[Vec<DVec2>]>,
        window: &Window,
    ) -> Option<(Window, Layer, Vec<u8>)> {
        let shown = window.in_rows(self.rows.clone())?;
        let rows = shown.rows.start.saturating_sub(OVERLAP)..shown.rows.end + OVERLAP;
        let mut layer = Layer::new(window.in_rows(rows)?);
        layer.draw(mesh);
        let covers = if let Some(rings) = outline {
            let covers = coverage(rings, &layer.window);
            layer.complete(&covers, mesh);
            covers
        } else {
            vec![255; layer.pixels.len()]
        };
        Some((shown, layer, covers))
    }

    /// Where the pixels of a window start in a row.
    fn start(&self, row: usize, window: &Window) -> usize {
        ((row - self.rows.start) * self.width + window.columns.start) * 4
    }
}

/// Lays ink on a pixel, as strong as the coverage says.
fn lay(pixel: &mut [u8], Ink { color: Color { r, g, b }, opacity }: Ink, cover: u8) {
    blend(pixel, [r, g, b, 255], (u32::from(cover) * opacity + 127) / 255);
}
