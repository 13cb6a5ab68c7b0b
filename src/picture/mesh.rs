//! The mesh fill: one opaque layer of pixels, without seams and without double paint.
//!
//! Each pixel whose centre lies in the mesh belongs to exactly one triangle: vertices are snapped to 1/256 pixel, the edges are walked in
//! whole numbers, and a centre on an edge goes to the triangle on its right or below (the top-left rule). Two triangles
//! that share an edge walk the same numbers, so there is neither gap nor overlap, and opacity is applied to the finished layer.
//! Anti-aliasing is left to the outline, whose coverage the painter multiplies in; [`Layer::complete`] gives a colour to pixels
//! that the outline touches and the mesh misses.

use std::ops::Range;

use glam::DVec2;

use super::clip::{Frame, cut};
use super::lines::is_clear;
use super::shade::{Cones, Levels, Shader, cones, fixed, flat_span};
use super::window::Window;
use super::{Mesh, Viewport};

/// Steps of the snapped coordinates in a pixel.
const SUBPIXELS: f64 = 256.0;

/// Triangles that reach farther than this from the corner of the picture, in pixels, are cut first. Far enough that
/// ordinary zooms never cut, and near enough that the products of snapped coordinates stay below 2^60.
const SNAP_REACH: f64 = 1_048_576.0;

/// Pixels looked at together for one that is covered.
const BLOCK: usize = 16;

/// A rectangle of pixels with the colours of a mesh; alpha is 255 where the mesh is and 0 elsewhere.
pub(super) struct Layer {
    pub(super) window: Window,
    /// Row by row from the top.
    pub(super) pixels: Vec<[u8; 4]>,
    shader: Shader,
}

/// A mesh on the screen.
pub(super) struct PlacedMesh {
    vertices: Vec<Vertex>,
    /// Every vertex snapped to the subpixel raster, `None` when it is too far.
    snapped: Vec<Option<Snapped>>,
    triangles: Vec<[u32; 3]>,
    /// Whether the three values of a vertex are shares of the levels themselves, and no cone roots.
    is_plain: bool,
}

/// A vertex on the screen: pixels and colour.
#[derive(Debug, Clone, Copy)]
struct Vertex {
    at: DVec2,
    color: Cones,
}

/// A vertex snapped to the subpixel raster.
#[derive(Debug, Clone, Copy)]
struct Snapped {
    x: i64,
    y: i64,
    color: Cones,
    levels: Levels,
}

/// One side of a triangle, walked row by row: `column` is the first pixel whose centre lies right of the side or on it.
#[derive(Debug, Clone, Copy)]
struct Side {
    column: i64,
    rest: i64,
    step: i64,
    step_rest: i64,
    divisor: i64,
}

/// The sides of a triangle on a layer with the given columns.
struct Columns {
    left: [Side; 2],
    right: [Side; 2],
    within: Range<i64>,
}

/// Three values linear over the pixels of a triangle.
struct Plane {
    /// The pixel, in fractions, that has the values `base`.
    origin: [f64; 2],
    base: [f64; 3],
    /// Change from one pixel to the next on the right.
    per_x: [f64; 3],
    /// Change from one row to the next.
    per_y: [f64; 3],
}

impl PlacedMesh {
    /// Places a mesh, which must have passed its check.
    pub(super) fn new(mesh: &Mesh, viewport: &Viewport) -> Self {
        let shader = Shader::new();
        let pairs = mesh.vertices.iter().zip(&mesh.colors);
        let vertices: Vec<Vertex> =
            pairs.map(|(&p, &color)| Vertex { at: viewport.place(p), color: cones(color) }).collect();
        let snapped = vertices.iter().map(|v| v.snap(&shader, false)).collect();
        Self { vertices, snapped, triangles: mesh.triangles.clone(), is_plain: false }
    }

    /// Places triangles with three shares at each vertex, which become the levels of the pixels, linear between them.
    pub(super) fn plain(
        shares: impl Iterator<Item = (DVec2, [f64; 3])>,
        triangles: &[[u32; 3]],
        viewport: &Viewport,
    ) -> Self {
        let shader = Shader::new();
        let vertices: Vec<Vertex> =
            shares.map(|(p, color)| Vertex { at: viewport.place(p), color }).collect();
        let snapped = vertices.iter().map(|v| v.snap(&shader, true)).collect();
        Self { vertices, snapped, triangles: triangles.to_vec(), is_plain: true }
    }

    /// The corners of the triangles.
    pub(super) fn corners(&self) -> impl Iterator<Item = DVec2> + '_ {
        self.triangles.iter().flatten().map(|&i| self.vertices[i as usize].at)
    }
}

impl Layer {
    /// An empty rectangle of pixels of a picture.
    pub(super) fn new(window: Window) -> Self {
        Self { pixels: vec![[0; 4]; window.area()], window, shader: Shader::new() }
    }

    /// Fills the triangles of a mesh.
    pub(super) fn draw(&mut self, mesh: &PlacedMesh) {
        for corners in &mesh.triangles {
            let [a, b, c] = corners.map(|i| i as usize);
            match (mesh.snapped[a], mesh.snapped[b], mesh.snapped[c]) {
                (Some(a), Some(b), Some(c)) => self.triangle(a, b, c, mesh.is_plain),
                _ => self.far_triangle([a, b, c].map(|i| mesh.vertices[i]), mesh.is_plain),
            }
        }
    }

    /// Gives each pixel with coverage that the mesh misses the colour of a nearest pixel with colour, spreading from
    /// neighbour to neighbour among the pixels with coverage. Where a part of the outline has no pixel with colour at all
    /// (it is thinner than a pixel there), the edges of the mesh are drawn first.
    pub(super) fn complete(&mut self, coverage: &[u8], mesh: &PlacedMesh) {
        let mut missing = self.missing(coverage);
        if missing.is_empty() {
            return;
        }
        self.spread(&missing, coverage);
        missing.retain(|&i| self.pixels[i][3] == 0);
        if !missing.is_empty() {
            self.draw_edges(coverage, mesh);
            self.spread(&missing, coverage);
        }
    }

    fn missing(&self, coverage: &[u8]) -> Vec<usize> {
        let mut missing = Vec::new();
        for (block, (pixels, covers)) in self.pixels.chunks(BLOCK).zip(coverage.chunks(BLOCK)).enumerate() {
            if !is_clear(covers) {
                let pairs = pixels.iter().zip(covers).enumerate();
                let bare = pairs.filter(|(_, (pixel, cover))| pixel[3] == 0 && **cover > 0);
                missing.extend(bare.map(|(i, _)| block * BLOCK + i));
            }
        }
        missing
    }

    fn spread(&mut self, missing: &[usize], coverage: &[u8]) {
        let colored = |pixels: &[[u8; 4]], i: usize| pixels[i][3] != 0;
        let starts: Vec<(usize, [u8; 4])> = missing
            .iter()
            .filter(|&&i| !colored(&self.pixels, i))
            .filter_map(|&i| {
                self.neighbours(i).find(|&n| colored(&self.pixels, n)).map(|n| (i, self.pixels[n]))
            })
            .collect();
        let mut front: Vec<usize> = Vec::with_capacity(starts.len());
        for (i, color) in starts {
            self.pixels[i] = color;
            front.push(i);
        }
        while !front.is_empty() {
            let mut next = Vec::new();
            for i in front {
                for n in self.neighbours(i) {
                    if coverage[n] > 0 && !colored(&self.pixels, n) {
                        self.pixels[n] = self.pixels[i];
                        next.push(n);
                    }
                }
            }
            front = next;
        }
    }

    /// The pixels round a pixel: those beside it first, then those across its corners.
    fn neighbours(&self, index: usize) -> impl Iterator<Item = usize> + use<> {
        const AROUND: [(isize, isize); 8] =
            [(0, -1), (-1, 0), (1, 0), (0, 1), (-1, -1), (1, -1), (-1, 1), (1, 1)];
        let (width, height) = (self.window.width(), self.window.height());
        let (x, y) = (index % width, index / width);
        AROUND.into_iter().filter_map(move |(dx, dy)| {
            let nx = x.checked_add_signed(dx).filter(|&v| v < width)?;
            let ny = y.checked_add_signed(dy).filter(|&v| v < height)?;
            Some(ny * width + nx)
        })
    }

    fn draw_edges(&mut self, coverage: &[u8], mesh: &PlacedMesh) {
        let Window { columns, rows } = &self.window;
        let max = DVec2::new(columns.end as f64, rows.end as f64);
        let frame = Frame { min: self.window.corner(), max };
        for corners in &mesh.triangles {
            for k in 0..3 {
                let (a, b) =
                    (mesh.vertices[corners[k] as usize], mesh.vertices[corners[(k + 1) % 3] as usize]);
                let Some((low, high)) = frame.clip_segment(a.at, b.at) else { continue };
                let steps = (2.0 * (high - low) * a.at.distance(b.at)).ceil().max(1.0);
                for i in 0..=steps as usize {
                    let vertex = a.lerp(b, low + (high - low) * i as f64 / steps);
                    let (x, y) = (vertex.at.x as usize, vertex.at.y as usize);
                    // Rounding may put an end of the edge just outside.
                    let x = x.clamp(columns.start, columns.end - 1);
                    let index = self.window.index(x, y.clamp(rows.start, rows.end - 1));
                    if coverage[index] > 0 && self.pixels[index][3] == 0 {
                        self.pixels[index] = if mesh.is_plain {
                            let [r, g, b] = vertex.color.map(|share| (share * 255.0).round() as u8);
                            [r, g, b, 255]
                        } else {
                            self.shader.pixel(vertex.color)
                        };
                    }
                }
            }
        }
    }

    /// A triangle that reaches too far to be snapped: cut to a polygon, then filled as a fan.
    fn far_triangle(&mut self, corners: [Vertex; 3], is_plain: bool) {
        let mut ring = corners.to_vec();
        for (axis, sign) in [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0)] {
            // Just inside the reach, so that the new corners can be snapped whatever they round to.
            ring = cut(&ring, |v| 0.999 * SNAP_REACH + sign * v.at[axis], Vertex::lerp);
        }
        for i in 2..ring.len() {
            let snap = |i: usize| ring[i].snap(&self.shader, is_plain);
            if let (Some(a), Some(b), Some(c)) = (snap(0), snap(i - 1), snap(i)) {
                self.triangle(a, b, c, is_plain);
            }
        }
    }

    fn triangle(&mut self, a: Snapped, b: Snapped, c: Snapped, is_plain: bool) {
        let doubled = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        let (b, c) = if doubled < 0 { (c, b) } else { (b, c) };
        let [columns, rows] =
            [&self.window.columns, &self.window.rows].map(|range| range.start as i64..range.end as i64);
        let top = first_center(a.y.min(b.y).min(c.y)).max(rows.start);
        let bottom = first_center(a.y.max(b.y).max(c.y)).min(rows.end);
        let scale = SUBPIXELS as i64;
        let apart =
            a.x.max(b.x).max(c.x) < columns.start * scale || a.x.min(b.x).min(c.x) >= columns.end * scale;
        if doubled == 0 || top >= bottom || apart {
            return;
        }

        // A triangle has one or two sides either way; a single one is counted twice.
        let sides = [(a, b), (b, c), (c, a)].map(|(from, to)| Side::new(from, to, top));
        let rises = [b.y < a.y, c.y < b.y, a.y < c.y];
        let falls = [b.y > a.y, c.y > b.y, a.y > c.y];
        let columns = Columns { left: pair(&sides, rises), right: pair(&sides, falls), within: columns };
        let rows = top..bottom;
        if is_plain || self.shader.is_flat([&a.color, &b.color, &c.color], [&a.levels, &b.levels, &c.levels])
        {
            let plane = Plane::new([a, b, c], |v| v.levels);
            let (origin, per_x, per_y) = (fixed(plane.at(0, 0)), fixed(plane.per_x), fixed(plane.per_y));
            self.walk(columns, rows, |pixels, x, y| {
                flat_span(pixels, std::array::from_fn(|i| origin[i] + per_x[i] * x + per_y[i] * y), per_x);
            });
        } else {
            let plane = Plane::new([a, b, c], |v| v.color);
            let step = plane.per_x.map(|v| v as f32);
            let shader = self.shader;
            self.walk(columns, rows, |pixels, x, y| {
                shader.span(pixels, plane.at(x, y).map(|v| v as f32), step)
            });
        }
    }

    /// Calls back with the pixels of each row between the sides, and the place of the first.
    fn walk(
        &mut self,
        mut columns: Columns,
        rows: Range<i64>,
        mut fill: impl FnMut(&mut [[u8; 4]], i64, i64),
    ) {
        let width = self.window.width();
        let (left, top) = (self.window.columns.start as i64, self.window.rows.start as i64);
        let band = (rows.start - top) as usize * width..(rows.end - top) as usize * width;
        for (row, y) in self.pixels[band].chunks_exact_mut(width).zip(rows) {
            let (start, end) = columns.advance();
            if start < end {
                fill(&mut row[(start - left) as usize..(end - left) as usize], start, y);
            }
        }
    }
}

/// The chosen sides, of which there are one or two, as two.
fn pair(sides: &[Side; 3], chosen: [bool; 3]) -> [Side; 2] {
    let first = chosen.iter().position(|&c| c).unwrap_or(0);
    let last = chosen.iter().rposition(|&c| c).unwrap_or(0);
    [sides[first], sides[last]]
}

impl Columns {
    /// The first column inside and the one past the last in this row; moves on to the next.
    fn advance(&mut self) -> (i64, i64) {
        let start = self.left[0].column.max(self.left[1].column).max(self.within.start);
        let end = self.right[0].column.min(self.right[1].column).min(self.within.end);
        self.left.iter_mut().chain(&mut self.right).for_each(Side::advance);
        (start, end)
    }
}

impl Plane {
    /// The plane through the values at three corners that turn right on the screen, in `f64` so that slivers keep their
    /// digits.
    fn new([a, b, c]: [Snapped; 3], value: impl Fn(&Snapped) -> [f64; 3]) -> Self {
        let (u, v) = ((b.x - a.x, b.y - a.y), (c.x - a.x, c.y - a.y));
        let inverse = SUBPIXELS / (u.0 * v.1 - u.1 * v.0) as f64;
        let (base, to_b, to_c) = (value(&a), value(&b), value(&c));
        let slope = |i: usize, at_b: i64, at_c: i64| {
            ((to_b[i] - base[i]) * at_b as f64 + (to_c[i] - base[i]) * at_c as f64) * inverse
        };
        Self {
            origin: [a.x as f64 / SUBPIXELS - 0.5, a.y as f64 / SUBPIXELS - 0.5],
            base,
            per_x: std::array::from_fn(|i| slope(i, v.1, -u.1)),
            per_y: std::array::from_fn(|i| slope(i, -v.0, u.0)),
        }
    }

    /// The values at the centre of a pixel.
    fn at(&self, x: i64, y: i64) -> [f64; 3] {
        let (dx, dy) = (x as f64 - self.origin[0], y as f64 - self.origin[1]);
        std::array::from_fn(|i| self.base[i] + self.per_x[i] * dx + self.per_y[i] * dy)
    }
}

impl Vertex {
    fn lerp(self, other: Self, t: f64) -> Self {
        Self {
            at: self.at.lerp(other.at, t),
            color: std::array::from_fn(|i| self.color[i] + (other.color[i] - self.color[i]) * t),
        }
    }

    /// The vertex on the subpixel raster, or `None` when it is too far.
    fn snap(&self, shader: &Shader, is_plain: bool) -> Option<Snapped> {
        let near = self.at.abs().max_element() <= SNAP_REACH;
        let snap = |v: f64| (v * SUBPIXELS + 0.5).floor() as i64;
        near.then(|| {
            let levels =
                if is_plain { self.color.map(|share| share * 255.0) } else { shader.levels(self.color) };
            Snapped { x: snap(self.at.x), y: snap(self.at.y), color: self.color, levels }
        })
    }
}

impl Side {
    /// The side through two corners at the given row; meaningless when they are of the same height.
    ///
    /// With w = |to.y - from.y| the side crosses the centres of row y at x = n / (256 w) pixels right of the first centre, n
    /// a whole number linear in y; `column` is that quotient rounded up and `rest` what the rounding added. Both directions of an
    /// edge give the same n.
    fn new(from: Snapped, to: Snapped, row: i64) -> Self {
        let (from, to) = if to.y < from.y { (to, from) } else { (from, to) };
        let scale = SUBPIXELS as i64;
        let (dx, dy) = (to.x - from.x, to.y - from.y);
        let center = row * scale + scale / 2;
        let n = (from.x - scale / 2) * dy + (center - from.y) * dx;
        let divisor = (dy * scale).max(1);
        let column = -(-n).div_euclid(divisor);
        let per_row = dx * scale;
        Self {
            column,
            rest: column * divisor - n,
            step: per_row.div_euclid(divisor),
            step_rest: per_row.rem_euclid(divisor),
            divisor,
        }
    }

    fn advance(&mut self) {
        self.column += self.step;
        self.rest -= self.step_rest;
        if self.rest < 0 {
            self.column += 1;
            self.rest += self.divisor;
        }
    }
}

/// The first row whose centre is at or below a snapped height.
fn first_center(y: i64) -> i64 {
    let scale = SUBPIXELS as i64;
    -(scale / 2 - y).div_euclid(scale)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::Color;

    const VIEW: Viewport =
        Viewport { width: 64, height: 64, center: DVec2::splat(32.0), scale: 1.0, pixel_ratio: 1.0 };

    fn mesh(points: &[(f64, f64)], triangles: &[[u32; 3]]) -> Mesh {
        let grey = Color::new(90, 90, 90).to_oklab();
        Mesh {
            vertices: points.iter().map(|&(x, y)| DVec2::new(x, y)).collect(),
            colors: vec![grey; points.len()],
            triangles: triangles.to_vec(),
        }
    }

    fn painted(mesh: &Mesh) -> Vec<bool> {
        let mut layer = Layer::new(Window::whole(64, 64));
        layer.draw(&PlacedMesh::new(mesh, &VIEW));
        layer.pixels.iter().map(|p| p[3] != 0).collect()
    }

    /// A small generator of whole numbers (splitmix64), fixed seed.
    fn numbers(mut state: u64) -> impl FnMut(u64) -> u64 {
        move |below| {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            (z ^ (z >> 31)) % below
        }
    }

    /// Brute force: the sign of the three edge functions at each centre, on coordinates that snap exactly.
    #[test]
    fn triangles_cover_the_centres_inside_them() {
        let mut number = numbers(7);
        for case in 0..300 {
            let corner = |n: &mut dyn FnMut(u64) -> u64| {
                DVec2::new(n(96 * 256) as f64, n(96 * 256) as f64) / 256.0 - 16.0
            };
            let p = [corner(&mut number), corner(&mut number), corner(&mut number)];
            let found = painted(&mesh(&p.map(|p| (p.x, p.y)), &[[0, 1, 2]]));
            for (i, &found) in found.iter().enumerate() {
                let center = DVec2::new((i % 64) as f64 + 0.5, 64.0 - (i / 64) as f64 - 0.5);
                let signs = [0, 1, 2].map(|k| (p[(k + 1) % 3] - p[k]).perp_dot(center - p[k]));
                let inside = signs.iter().all(|&s| s > 0.0) || signs.iter().all(|&s| s < 0.0);
                let outside = signs.iter().any(|&s| s > 0.0) && signs.iter().any(|&s| s < 0.0);
                assert!(if found { !outside } else { !inside }, "case {case}, pixel {i}, {p:?}");
            }
        }
    }

    /// Fans round random points, with corners on pixel centres among them: the triangles of a square cover each
    /// of its pixels once, whatever way they turn.
    #[test]
    fn neighbours_neither_overlap_nor_leave_gaps() {
        let mut number = numbers(11);
        for _ in 0..200 {
            let half = |n: &mut dyn FnMut(u64) -> u64| n(127) as f64 / 2.0 + 0.5;
            let hub = (half(&mut number), half(&mut number));
            let square = mesh(&[(0.0, 0.0), (64.0, 0.0), (64.0, 64.0), (0.0, 64.0), hub], &[]);
            let mut times = vec![0; 64 * 64];
            for triangle in [[0, 1, 4], [2, 1, 4], [2, 3, 4], [4, 0, 3]] {
                let one = Mesh { triangles: vec![triangle], ..square.clone() };
                painted(&one).iter().zip(&mut times).for_each(|(&p, t)| *t += u32::from(p));
            }
            assert!(times.iter().all(|&t| t == 1), "hub {hub:?}");
        }
    }

    /// The same with the square blown up far beyond what can be snapped.
    #[test]
    fn huge_triangles_meet_without_gaps() {
        for reach in [1e5, 1.1e6, 1e9, 1e14] {
            let hub = (31.25, 17.5);
            let square =
                mesh(&[(-reach, -reach), (reach, -reach * 0.7), (reach, reach), (-reach, reach), hub], &[]);
            let mut times = vec![0; 64 * 64];
            for triangle in [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]] {
                let one = Mesh { triangles: vec![triangle], ..square.clone() };
                painted(&one).iter().zip(&mut times).for_each(|(&p, t)| *t += u32::from(p));
            }
            assert!(times.iter().all(|&t| t == 1), "reach {reach}: {:?}", times.iter().position(|&t| t != 1));
        }
    }

    #[test]
    fn missed_pixels_take_the_colour_of_their_neighbours() {
        let square = mesh(&[(10.0, 10.0), (20.0, 10.0), (20.0, 20.0), (10.0, 20.0)], &[[0, 1, 2], [0, 2, 3]]);
        let square = PlacedMesh::new(&square, &VIEW);
        let mut layer = Layer::new(Window::whole(64, 64));
        layer.draw(&square);
        let coverage: Vec<u8> = (0..64 * 64).map(|i| if i % 64 < 25 { 9 } else { 0 }).collect();
        layer.complete(&coverage, &square);
        for (i, pixel) in layer.pixels.iter().enumerate() {
            assert_eq!(pixel[3] != 0, i % 64 < 25, "pixel {i}");
        }
    }

    /// A sliver between pixel centres paints nothing; completing it draws its edges.
    #[test]
    fn slivers_still_have_a_colour() {
        let sliver = mesh(&[(5.0, 10.1), (50.0, 10.1), (50.0, 10.3), (5.0, 10.3)], &[[0, 1, 2], [0, 2, 3]]);
        let sliver = PlacedMesh::new(&sliver, &VIEW);
        let mut layer = Layer::new(Window::whole(64, 64));
        layer.draw(&sliver);
        assert!(layer.pixels.iter().all(|p| p[3] == 0));
        let row = 64 - 11;
        let coverage: Vec<u8> =
            (0..64 * 64).map(|i| if i / 64 == row && (5..50).contains(&(i % 64)) { 51 } else { 0 }).collect();
        layer.complete(&coverage, &sliver);
        assert!((5..50).all(|x| layer.pixels[row * 64 + x][3] == 255));
    }
}
