//! The pixel painter, on tiny-skia.

use glam::DVec2;
use tiny_skia::{
    FillRule, LineCap, LineJoin, Mask, Paint, PathBuilder, Pixmap, Stroke, StrokeDash, Transform,
};

use super::clip::{Frame, Piece};
use super::grid::{GridLine, grid_lines};
use super::mesh::Layer;
use super::thin::{ThinLines, WIDEST, is_clear};
use super::{DisplayList, Item, Mesh, PaintError, Path, StrokeStyle, Viewport};
use crate::material::Color;

/// Room round the picture in which geometry is kept, in device pixels on top of the width of the line: more than what
/// anti-aliasing and a cut end can touch.
const MARGIN: f64 = 16.0;

/// Dashes with a shorter period are drawn solid, in device pixels; finer ones cannot be seen.
const FINEST_DASH: f32 = 0.5;

/// Paints a picture: straight (not premultiplied) RGBA, eight bits each, row by row from the top.
///
/// The result is the same on every run. What lies outside the picture is cut early, so cost follows what shows.
///
/// # Errors
/// A side of 0 or above 4096 pixels, an unusable viewport, and items with numbers that cannot be drawn (not finite, opacities outside 0 to
/// 1, widths above 1000 pixels) or meshes whose parts do not fit together.
pub fn paint(list: &DisplayList, viewport: &Viewport) -> Result<Vec<u8>, PaintError> {
    viewport.check()?;
    for layer in &list.layers {
        layer.items.iter().try_for_each(|item| item.check(&layer.name))?;
    }
    let refuse = || PaintError::Size { width: viewport.width, height: viewport.height };
    let mut painter = Painter {
        pixmap: Pixmap::new(viewport.width, viewport.height).ok_or_else(refuse)?,
        thin: ThinLines::new(viewport.width, viewport.height),
        viewport,
        ratio: viewport.pixel_ratio as f32,
    };
    if let Some(color) = list.background {
        painter.pixmap.fill(tiny_skia::Color::from_rgba8(color.r, color.g, color.b, 255));
    }
    for item in list.layers.iter().flat_map(|layer| &layer.items) {
        painter.item(item);
    }
    let mut data = painter.pixmap.take();
    if list.background.is_none() {
        straighten(&mut data);
    }
    Ok(data)
}

/// Pixels composed together.
const BLOCK: usize = 16;

struct Painter<'a> {
    pixmap: Pixmap,
    thin: ThinLines,
    viewport: &'a Viewport,
    ratio: f32,
}

impl Painter<'_> {
    fn item(&mut self, item: &Item) {
        match item {
            Item::Grid { minor, major } => self.grid(minor, major),
            Item::Mesh { mesh, outline, opacity } => self.mesh(mesh, outline, *opacity),
            Item::Stroke { path, style } => self.stroke(path, style),
            Item::Fill { path, color, opacity } => {
                let rings = self.frame(0.0).polygons(path, self.viewport);
                self.fill_path(polygon_path(&rings, DVec2::ZERO), *color, *opacity, FillRule::EvenOdd);
            }
            Item::Dots { centers, radius_px, color, opacity } => {
                self.dots(centers, *radius_px, *color, *opacity);
            }
            Item::Rings { centers, radius_px, style } => self.rings(centers, *radius_px, style),
            Item::Crosses { centers, size_px, style } => self.crosses(centers, *size_px, style),
        }
    }

    /// The picture and as much round it as a mark of the given size in CSS pixels can reach in from.
    fn frame(&self, size_px: f32) -> Frame {
        Frame::around(self.viewport, MARGIN + f64::from(size_px * self.ratio))
    }

    /// Places of the marks that can show, in pixels.
    fn marks(&self, centers: &[DVec2], size_px: f32) -> Vec<DVec2> {
        let frame = self.frame(size_px);
        centers.iter().map(|&p| self.viewport.place(p)).filter(|&p| frame.contains(p)).collect()
    }

    fn dots(&mut self, centers: &[DVec2], radius_px: f32, color: Color, opacity: f32) {
        let radius = radius_px * self.ratio;
        let places = self.marks(centers, radius_px);
        if 2.0 * radius <= WIDEST {
            places.iter().for_each(|&p| self.thin.add(p, p, 2.0 * radius));
            self.lay_thin(color, opacity);
        } else {
            self.fill_path(circles(&places, radius), color, opacity, FillRule::Winding);
        }
    }

    fn rings(&mut self, centers: &[DVec2], radius_px: f32, style: &StrokeStyle) {
        let path = circles(&self.marks(centers, radius_px + style.width_px), radius_px * self.ratio);
        self.stroke_path(path, style, None);
    }

    fn crosses(&mut self, centers: &[DVec2], size_px: f32, style: &StrokeStyle) {
        let arm = f64::from(size_px * self.ratio / 2.0);
        let bar = |p: DVec2, rise: f64| {
            let arm = DVec2::new(arm, rise);
            Piece { points: vec![p - arm, p + arm], closed: false, start: 0.0 }
        };
        let places = self.marks(centers, size_px + style.width_px);
        let bars: Vec<Piece> = places.into_iter().flat_map(|p| [bar(p, arm), bar(p, -arm)]).collect();
        self.solid_line(&bars, style);
    }

    fn stroke(&mut self, path: &Path, style: &StrokeStyle) {
        let dash = style.dash.map(|dash| dash.map(|length| length * self.ratio));
        let dash = dash.filter(|[on, off]| on + off >= FINEST_DASH);
        let pieces = self.frame(style.width_px).pieces(path, self.viewport, dash.is_some());
        let Some([on, off]) = dash else {
            self.solid_line(&pieces, style);
            return;
        };
        for piece in &pieces {
            let offset = (piece.start % f64::from(on + off)) as f32;
            let dash = StrokeDash::new(vec![on, off], offset);
            self.stroke_path(pieces_path(std::slice::from_ref(piece)), style, dash);
        }
    }

    fn solid_line(&mut self, pieces: &[Piece], style: &StrokeStyle) {
        let width = style.width_px * self.ratio;
        if width > WIDEST {
            self.stroke_path(pieces_path(pieces), style, None);
        } else if width > 0.0 {
            for piece in pieces {
                piece.points.windows(2).for_each(|pair| self.thin.add(pair[0], pair[1], width));
                if let (true, [first, .., last]) = (piece.closed, &piece.points[..]) {
                    self.thin.add(*last, *first, width);
                }
            }
            self.lay_thin(style.color, style.opacity);
        }
    }

    /// Paints the lines collected in `thin`.
    fn lay_thin(&mut self, Color { r, g, b }: Color, opacity: f32) {
        let opacity = (opacity * 255.0).round() as u32;
        let data = self.pixmap.data_mut();
        self.thin.drain(|index, cover| {
            let alpha = (u32::from(cover) * opacity + 127) / 255;
            blend(&mut data[index * 4..index * 4 + 4], [r, g, b, 255], alpha);
        });
    }

    /// A line too wide for `thin`, or dashed.
    fn stroke_path(&mut self, path: Option<tiny_skia::Path>, style: &StrokeStyle, dash: Option<StrokeDash>) {
        let width = style.width_px * self.ratio;
        let Some(path) = path.filter(|_| width > 0.0) else { return };
        let line_cap = if dash.is_some() { LineCap::Butt } else { LineCap::Round };
        let stroke = Stroke { width, line_cap, line_join: LineJoin::Round, dash, ..Stroke::default() };
        let paint = solid(style.color, style.opacity);
        self.pixmap.stroke_path(&path, &paint, &stroke, Transform::identity(), None);
    }

    fn fill_path(&mut self, path: Option<tiny_skia::Path>, color: Color, opacity: f32, rule: FillRule) {
        if let Some(path) = path {
            self.pixmap.fill_path(&path, &solid(color, opacity), rule, Transform::identity(), None);
        }
    }

    fn mesh(&mut self, mesh: &Mesh, outline: &Path, opacity: f32) {
        let clipped = !outline.rings.is_empty();
        let rings = self.frame(0.0).polygons(outline, self.viewport);
        let extent =
            if clipped { self.extent(rings.iter().flatten().copied()) } else { self.extent_of(mesh) };
        let Some(([left, top], [width, height])) = extent else { return };

        let mut layer = Layer::new([left, top], width, height);
        layer.draw(mesh, self.viewport);
        let coverage = if clipped {
            let corner = DVec2::new(left.into(), top.into());
            let Some(coverage) = coverage(&rings, corner, width, height) else { return };
            layer.complete(&coverage, mesh, self.viewport);
            coverage
        } else {
            vec![255; layer.pixels.len()]
        };
        self.compose(&layer, &coverage, (opacity * 255.0).round() as u32);
    }

    /// The pixels that points reach, as upper left corner and size; `None` when they reach none.
    fn extent(&self, points: impl Iterator<Item = DVec2>) -> Option<([u32; 2], [u32; 2])> {
        let empty = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let (low, high) = points.fold(empty, |(low, high), p| (low.min(p), high.max(p)));
        let size = DVec2::new(self.viewport.width.into(), self.viewport.height.into());
        let low = low.floor().max(DVec2::ZERO);
        let high = high.ceil().min(size);
        let room = high - low;
        let within = room.x >= 1.0 && room.y >= 1.0;
        within.then_some(([low.x as u32, low.y as u32], [room.x as u32, room.y as u32]))
    }

    fn extent_of(&self, mesh: &Mesh) -> Option<([u32; 2], [u32; 2])> {
        let used = mesh.triangles.iter().flatten();
        self.extent(used.map(|&i| self.viewport.place(mesh.vertices[i as usize])))
    }

    /// Lays a layer over the picture, each pixel as strong as its coverage times the opacity (0 to 255).
    fn compose(&mut self, layer: &Layer, coverage: &[u8], opacity: u32) {
        let stride = self.viewport.width as usize * 4;
        let [left, top] = layer.corner.map(|v| v as usize);
        let data = self.pixmap.data_mut();
        let rows = layer.pixels.chunks_exact(layer.width).zip(coverage.chunks_exact(layer.width));
        for (y, (pixels, covers)) in rows.enumerate() {
            let start = (top + y) * stride + left * 4;
            let targets = data[start..start + layer.width * 4].chunks_mut(BLOCK * 4);
            for ((targets, pixels), covers) in targets.zip(pixels.chunks(BLOCK)).zip(covers.chunks(BLOCK)) {
                compose_block(targets, pixels, covers, opacity);
            }
        }
    }

    /// Paints grid lines on whole pixels, so that they stay crisp; no pixel twice, so that crossings do not show.
    fn grid(&mut self, minor: &StrokeStyle, major: &StrokeStyle) {
        let (width, height) = (self.viewport.width, self.viewport.height);
        let [columns, rows] = grid_lines(self.viewport);
        for (style, strong) in [(minor, false), (major, true)] {
            let band = style.width_px * self.ratio;
            let opacity = (style.opacity * 255.0).round() as u32;
            let Color { r, g, b } = style.color;
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
            let (columns, rows) = (across(&columns, width), across(&rows, height));
            let places: Vec<usize> = (0..columns.len()).filter(|&x| columns[x]).collect();
            for (row, whole) in self.pixmap.data_mut().chunks_exact_mut(width as usize * 4).zip(rows) {
                if whole {
                    row.chunks_exact_mut(4).for_each(|pixel| blend(pixel, [r, g, b, 255], opacity));
                } else {
                    places.iter().for_each(|x| blend(&mut row[x * 4..x * 4 + 4], [r, g, b, 255], opacity));
                }
            }
        }
    }
}

fn solid(color: Color, opacity: f32) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color_rgba8(color.r, color.g, color.b, (opacity * 255.0).round() as u8);
    paint
}

/// Lays a few pixels over others; blocks that are wholly covered or wholly free go without arithmetic.
fn compose_block(targets: &mut [u8], pixels: &[[u8; 4]], covers: &[u8], opacity: u32) {
    if is_clear(covers) {
        return;
    }
    if opacity == 255
        && covers.iter().fold(255, |all, cover| all & cover) == 255
        && pixels.iter().fold(255, |all, p| all & p[3]) == 255
    {
        targets.copy_from_slice(pixels.as_flattened());
        return;
    }
    for ((target, source), &cover) in targets.chunks_exact_mut(4).zip(pixels).zip(covers) {
        if source[3] != 0 {
            blend(target, *source, (u32::from(cover) * opacity + 127) / 255);
        }
    }
}

fn circles(places: &[DVec2], radius: f32) -> Option<tiny_skia::Path> {
    let mut builder = PathBuilder::new();
    for place in places {
        builder.push_circle(place.x as f32, place.y as f32, radius);
    }
    builder.finish()
}

/// How much of each pixel of a rectangle the rings cover, even-odd; `None` when the rectangle cannot be allocated.
fn coverage(rings: &[Vec<DVec2>], corner: DVec2, width: u32, height: u32) -> Option<Vec<u8>> {
    let mut mask = Mask::new(width, height)?;
    if let Some(path) = polygon_path(rings, corner) {
        mask.fill_path(&path, FillRule::EvenOdd, true, Transform::identity());
    }
    Some(mask.take())
}

fn polygon_path(rings: &[Vec<DVec2>], corner: DVec2) -> Option<tiny_skia::Path> {
    let mut builder = PathBuilder::new();
    for ring in rings {
        push_line(&mut builder, ring, corner);
        builder.close();
    }
    builder.finish()
}

fn pieces_path(pieces: &[Piece]) -> Option<tiny_skia::Path> {
    let mut builder = PathBuilder::new();
    for piece in pieces {
        push_line(&mut builder, &piece.points, DVec2::ZERO);
        if piece.closed {
            builder.close();
        }
    }
    builder.finish()
}

fn push_line(builder: &mut PathBuilder, points: &[DVec2], corner: DVec2) {
    for (i, &point) in points.iter().enumerate() {
        let p = (point - corner).as_vec2();
        if i == 0 { builder.move_to(p.x, p.y) } else { builder.line_to(p.x, p.y) }
    }
}

/// Lays an opaque colour over a premultiplied pixel, as strong as `alpha` (0 to 255).
fn blend(target: &mut [u8], source: [u8; 4], alpha: u32) {
    let [t0, t1, t2, t3] = [target[0], target[1], target[2], target[3]];
    let (below, above) = (u32::from_le_bytes([t0, t1, t2, t3]), u32::from_le_bytes(source));
    let even = mix_pair(below & PAIR, above & PAIR, alpha);
    let odd = mix_pair(below >> 8 & PAIR, above >> 8 & PAIR, alpha);
    target.copy_from_slice(&(even | odd << 8).to_le_bytes());
}

/// Two channels of eight bits in a word, each with eight bits free above it.
const PAIR: u32 = 0x00ff_00ff;

/// Mixes two channels at once, each rounded to the nearest: x / 255 is (y + y / 256) / 256 with y = x + 128, for all products x of
/// two bytes.
fn mix_pair(below: u32, above: u32, alpha: u32) -> u32 {
    let y = above * alpha + below * (255 - alpha) + 0x0080_0080;
    (y + (y >> 8 & PAIR)) >> 8 & PAIR
}

/// Turns premultiplied pixels into straight ones.
fn straighten(data: &mut [u8]) {
    for pixel in data.chunks_exact_mut(4) {
        let alpha = u32::from(pixel[3]);
        if alpha != 0 && alpha != 255 {
            for value in &mut pixel[..3] {
                *value = ((u32::from(*value) * 255 + alpha / 2) / alpha).min(255) as u8;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_of_channels_mix_to_the_nearest_level() {
        for alpha in 0..=255_u32 {
            for (below, above) in (0..=255).step_by(5).flat_map(|b| (0..=255).step_by(3).map(move |a| (b, a)))
            {
                let exact =
                    |b: u32, a: u32| (f64::from(a * alpha + b * (255 - alpha)) / 255.0).round() as u32;
                let found = mix_pair(below << 16 | above, above << 16 | below, alpha);
                assert_eq!(found, exact(below, above) << 16 | exact(above, below), "{below} {above} {alpha}");
            }
        }
    }
}
