//! Parts on pixels.

use super::{Body, Composing, Part};
use crate::field::{Grid, PrintedJob};
use crate::geom::Bounds;
use glam::{DVec2, dvec2};
use std::error::Error;
use std::fmt;
use std::ops::Deref;

/// Most pixels of a raster: 4096 x 4096.
pub const MOST_PIXELS: usize = 1 << 24;
/// Most memory that a raster may need, in bytes: half a gibibyte.
pub const MOST_MEMORY: usize = 1 << 29;
/// Pixels along the side of a tile.
const TILE: usize = 16;

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

/// What a part holds on pixels.
#[derive(Debug, Clone, PartialEq)]
pub struct Raster {
    /// The pixels.
    pub frame: Frame,
    /// 0 outside, else one more than the index of the body.
    pub body: Vec<u8>,
    /// Fraction of each material; 0 outside.
    pub fractions: Vec<Vec<f32>>,
    /// Which features hold a pixel, by bits; 0 outside.
    pub leaves: Vec<u32>,
}

/// A block of pixels.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tile {
    /// Centre of the first pixel.
    first: DVec2,
    step: DVec2,
    pub(super) width: usize,
    pub(super) height: usize,
}

impl Tile {
    pub(super) fn center(&self, i: usize, j: usize) -> DVec2 {
        dvec2(self.first.x + i as f64 * self.step.x, self.first.y - j as f64 * self.step.y)
    }

    pub(super) fn all(&self) -> [usize; 4] {
        [0, 0, self.width, self.height]
    }

    /// Centre and half diagonal of a block of centres: first column, first row, width and height.
    pub(super) fn disc(&self, [x, y, width, height]: [usize; 4]) -> (DVec2, f64) {
        let [a, b] = [self.center(x, y), self.center(x + width - 1, y + height - 1)];
        ((a + b) / 2.0, a.distance(b) / 2.0)
    }
}

/// The job that evaluates a part on pixels, in steps: rows of bodies first, then compositions in tiles, then bodies by the printed rule.
#[derive(Debug)]
pub struct RasterJob<P: Deref<Target = Part>> {
    part: P,
    raster: Raster,
    stage: Stage,
    /// Distances to the features of each body by the printed rule.
    near: Vec<Vec<Vec<f32>>>,
    work: Workspace,
}

#[derive(Debug)]
enum Stage {
    /// The row that is next.
    Rows(usize),
    /// The tile that is next, and the body.
    Tiles(usize, usize),
    /// The body that is next, and what is under way.
    Printing(usize, Option<Box<PrintedJob>>),
    Done,
}

/// What a tile needs and no other one has to make anew.
#[derive(Debug, Default)]
struct Workspace {
    /// Distances to the features, one list of pixels after the other.
    distances: Vec<f64>,
    /// Distances to the references of a feature.
    parts: Vec<f64>,
    list: Vec<u32>,
    own: Vec<f64>,
    fractions: Vec<f64>,
}

impl<P: Deref<Target = Part>> RasterJob<P> {
    /// # Errors
    /// When more memory is needed than [`MOST_MEMORY`].
    pub fn new(part: P, frame: Frame) -> Result<Self, FrameError> {
        let memory = frame.memory(&part);
        if memory > MOST_MEMORY {
            return Err(FrameError::Memory(memory));
        }
        let count = frame.count();
        let near = |body: &Option<Body>| {
            let printed = body.as_ref().filter(|body| body.composing == Composing::Printed);
            printed.map_or_else(Vec::new, |body| vec![vec![f32::INFINITY; count]; body.features.len()])
        };
        let raster = Raster {
            frame,
            body: vec![0; count],
            fractions: vec![vec![0.0; count]; part.materials],
            leaves: vec![0; count],
        };
        let near = part.bodies.iter().map(near).collect();
        let work = Workspace { fractions: vec![0.0; part.materials], ..Workspace::default() };
        Ok(Self { part, raster, stage: Stage::Rows(0), near, work })
    }

    /// Advances while `may_go_on` says so, at least by a little; returns whether all is done.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> bool {
        loop {
            let stage = std::mem::replace(&mut self.stage, Stage::Done);
            self.stage = match stage {
                Stage::Rows(row) if row < self.raster.frame.size[1] => {
                    self.fill_row(row);
                    Stage::Rows(row + 1)
                }
                Stage::Rows(_) => Stage::Tiles(0, 0),
                Stage::Tiles(tile, body) => self.advance(tile, body),
                Stage::Printing(body, job) => self.print(body, job, may_go_on),
                Stage::Done => return true,
            };
            if !may_go_on() {
                return matches!(self.stage, Stage::Done);
            }
        }
    }

    /// Share of the work that is done, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        match &self.stage {
            Stage::Rows(row) => 0.1 * *row as f64 / self.raster.frame.size[1] as f64,
            Stage::Tiles(tile, _) => 0.1 + 0.7 * *tile as f64 / self.tiles() as f64,
            Stage::Printing(body, job) => {
                let bodies = self.part.bodies.len().max(1) as f64;
                0.8 + 0.19 * (*body as f64 + job.as_ref().map_or(0.0, |job| job.progress())) / bodies
            }
            Stage::Done => 1.0,
        }
    }

    /// The raster, once all is done.
    #[must_use]
    pub fn raster(self) -> Raster {
        self.raster
    }

    /// Runs the job to its end.
    #[must_use]
    pub fn run(mut self) -> Raster {
        while !self.step(&mut || true) {}
        self.raster
    }

    fn fill_row(&mut self, row: usize) {
        let frame = self.raster.frame;
        let start = frame.center(0, row);
        let marks = &mut self.raster.body[row * frame.size[0]..(row + 1) * frame.size[0]];
        for (index, body) in self.part.bodies.iter().enumerate() {
            if let Some(body) = body {
                let mark = |column: usize| marks[column] = index as u8 + 1;
                body.region.row(start.y, start.x, frame.step().x, mark, frame.size[0]);
            }
        }
    }

    fn tiles(&self) -> usize {
        self.raster.frame.size.map(|along| along.div_ceil(TILE)).iter().product()
    }

    /// The next tile that has pixels of a body, and what comes after it.
    fn advance(&mut self, mut tile: usize, mut index: usize) -> Stage {
        let (count, bodies) = (self.tiles(), self.part.bodies.len());
        // A few tiles without work take no turn of their own.
        for _ in 0..64 * bodies.max(1) {
            if index >= bodies {
                (tile, index) = (tile + 1, 0);
            }
            if tile >= count {
                return Stage::Printing(0, None);
            }
            if self.compose(tile, index) {
                return Stage::Tiles(tile, index + 1);
            }
            index += 1;
        }
        Stage::Tiles(tile, index)
    }

    /// Evaluates the pixels that a body has in a tile; returns whether there are any.
    fn compose(&mut self, tile: usize, index: usize) -> bool {
        let (frame, part) = (self.raster.frame, &*self.part);
        let [nx, ny] = frame.size;
        let columns = nx.div_ceil(TILE);
        let [x, y] = [tile % columns * TILE, tile / columns * TILE];
        let [width, height] = [TILE.min(nx - x), TILE.min(ny - y)];
        let row = |j: usize| (y + j) * nx + x..(y + j) * nx + x + width;
        let number = index as u8 + 1;
        let Some(body) = &part.bodies[index] else { return false };
        if !(0..height).any(|j| self.raster.body[row(j)].contains(&number)) {
            return false;
        }
        let tile = Tile { first: frame.center(x, y), step: frame.step(), width, height };
        let pixels = width * height;
        let work = &mut self.work;
        work.distances.resize(body.features.len() * pixels, 0.0);
        let is_printed = body.composing == Composing::Printed;
        let mut is_free = true;
        for (k, (feature, profile)) in body.features.iter().zip(body.overlap.profiles()).enumerate() {
            let distances = &mut work.distances[k * pixels..(k + 1) * pixels];
            if let Some(reference) = feature.single() {
                let (center, radius) = tile.disc(tile.all());
                let distance = reference.distance(center);
                if !is_printed && (distance - radius > profile.to() || distance + radius < profile.from()) {
                    distances.fill(f64::INFINITY);
                    continue;
                }
                reference.measure(&tile, distances, &mut work.list);
            } else {
                let references = feature.references();
                work.parts.resize(references.len() * pixels, 0.0);
                for (part, reference) in work.parts.chunks_exact_mut(pixels).zip(references) {
                    reference.measure(&tile, part, &mut work.list);
                }
                for (pixel, distance) in distances.iter_mut().enumerate() {
                    work.own.clear();
                    work.own.extend(work.parts.iter().skip(pixel).step_by(pixels));
                    *distance = feature.combine(&work.own);
                }
            }
            is_free = false;
        }
        if is_printed {
            for (k, near) in self.near[index].iter_mut().enumerate() {
                for j in 0..height {
                    let distances = &work.distances[k * pixels + j * width..][..width];
                    near[row(j)].iter_mut().zip(distances).for_each(|(to, from)| *to = *from as f32);
                }
            }
            return true;
        }
        let default = body.overlap.default_composition().fractions();
        for j in 0..height {
            for (i, at) in row(j).enumerate() {
                if self.raster.body[at] != number {
                    continue;
                }
                if is_free {
                    self.raster
                        .fractions
                        .iter_mut()
                        .zip(default)
                        .for_each(|(to, from)| to[at] = *from as f32);
                    continue;
                }
                work.own.clear();
                work.own.extend(work.distances.iter().skip(j * width + i).step_by(pixels));
                let leaf = body.overlap.fractions(&work.own, &mut work.fractions);
                self.raster.leaves[at] = body.leaf(leaf);
                let fractions = self.raster.fractions.iter_mut().zip(&work.fractions);
                fractions.for_each(|(to, from)| to[at] = *from as f32);
            }
        }
        true
    }

    /// Goes on with the bodies by the printed rule.
    fn print(
        &mut self,
        index: usize,
        job: Option<Box<PrintedJob>>,
        may_go_on: &mut dyn FnMut() -> bool,
    ) -> Stage {
        let Some(body) = self.part.bodies.get(index) else { return Stage::Done };
        let printed = body.as_ref().filter(|body| body.composing == Composing::Printed);
        let (Some(body), Some(grid)) = (printed, self.raster.frame.grid()) else {
            return Stage::Printing(index + 1, None);
        };
        let number = index as u8 + 1;
        let Some(mut job) = job else {
            let is_inside = self.raster.body.iter().map(|body| *body == number).collect();
            let profiles = body.overlap.profiles().cloned().collect();
            let near = std::mem::take(&mut self.near[index]);
            let default = body.overlap.default_composition();
            return match PrintedJob::new(&grid, is_inside, default, profiles, near) {
                Ok(job) => Stage::Printing(index, Some(Box::new(job))),
                Err(_) => Stage::Printing(index + 1, None),
            };
        };
        if let Ok(false) = job.step(may_go_on) {
            return Stage::Printing(index, Some(job));
        }
        let made = job.made();
        for at in (0..self.raster.body.len()).filter(|at| self.raster.body[*at] == number) {
            self.raster.leaves[at] = body.leaf(made.leaves[at]);
            for (to, from) in self.raster.fractions.iter_mut().zip(&made.fractions) {
                to[at] = from[at];
            }
        }
        Stage::Printing(index + 1, None)
    }
}
