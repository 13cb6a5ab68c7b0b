//! The solution on the pixels of a plane, in steps.
//!
//! Pixels are taken in square tiles. What panels away from a tile do to it is a smooth function, which is found at Chebyshev's places and interpolated. A
//! tile with panels nearby is quartered: its quarters take the function over at their own places, and only panels that are away from them and were not from
//! the whole are added. In the smallest tiles the panels that are left are integrated for every pixel. So a picture costs little more than its pixels.

use super::cluster::{Reach, reach};
use super::error::{Fault, LaplaceError};
use super::lanes::{Points, layers};
use super::panel::Space;
use super::single::LANES;
use super::solution::{INSIDE, Solution};
use super::tile::{Grid, NODES, Weights, halves, place, quarter};
use glam::DVec3;
use std::borrow::Borrow;
use std::rc::Rc;

/// Pixels along a side of the largest tiles, and of the smallest; powers of 2.
const LARGEST: usize = 256;
const SMALLEST: usize = 16;

/// Panels that come nearer to the middle of a tile than so many times its half diagonal are left to its quarters or integrated for every pixel; the others are
/// interpolated, to about 1e-5.
const APART: f64 = 1.75;

/// A tile is quartered where its pixels times the panels nearby are more than this; below, its quarters would cost more.
const MANY: usize = 8192;

/// Panels added up in single precision before their sum goes into one in double precision.
const FLUSHED: usize = 32;

/// Panels times points between two looks at the clock, about.
const BATCH: usize = 1 << 14;

/// Sine of the angle between sides below which they span no plane.
const PARALLEL: f64 = 1e-12;

/// Most pixels of a section.
pub const MOST_PIXELS: usize = 1 << 22;

/// Pixels in a plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// The corner where the first pixel begins.
    pub origin: DVec3,
    /// The sides: pixels run along the first, rows along the second.
    pub sides: [DVec3; 2],
    /// Number of pixels along both.
    pub size: [usize; 2],
}

/// The solution on pixels.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// Number of pixels along both sides.
    pub size: [usize; 2],
    /// For each material the value in the middle of each pixel, row by row; no number outside.
    pub values: Vec<Vec<f32>>,
    /// Pixels inside.
    pub inside: usize,
    /// Pixels where a value was out of the range that the boundary allows, and was taken back to it.
    pub clamped: usize,
}

/// A section being made.
#[derive(Debug)]
pub struct SectionJob<S: Borrow<Solution>> {
    solution: S,
    frame: Frame,
    section: Section,
    /// The corner and the sides of a pixel in the coordinates of computing.
    origin: DVec3,
    steps: [DVec3; 2],
    /// The corners of the box of all panels.
    bounds: (DVec3, DVec3),
    /// Of tiles from the smallest to the largest.
    weights: Vec<Weights>,
    halves: [[[f64; NODES]; NODES]; 2],
    /// Pixels along a side of the first tiles, and the next one of them.
    side: usize,
    next: usize,
    /// Above all tiles: every panel is nearby.
    all: Rc<Made>,
    /// Quarters that wait.
    waiting: Vec<Tile>,
    /// A tile whose pixels are being made.
    open: Option<Rows>,
    /// Pixels that are done.
    done: usize,
    scratch: Scratch,
}

/// A tile to be made.
#[derive(Debug)]
struct Tile {
    /// Its first pixel, and pixels along a side.
    corner: [usize; 2],
    side: usize,
    above: Rc<Made>,
    /// Which quarter it is of the one above, where that has numbers.
    quarter: [usize; 2],
}

/// What was found of a tile.
#[derive(Debug)]
struct Made {
    /// What panels away from it do at its places: for each material, and last the share of the full angle. Empty where there are none yet.
    grids: Vec<Grid>,
    near: Vec<u32>,
}

/// A tile whose pixels are made row by row.
#[derive(Debug)]
struct Rows {
    corner: [usize; 2],
    side: usize,
    grids: Vec<Grid>,
    near: Vec<(u32, Reach)>,
    row: usize,
}

/// Sums at points that are worked on together, for each material and last for the share of the full angle.
#[derive(Debug)]
struct Scratch {
    sums: Vec<[f64; LANES]>,
    parts: Vec<[f32; LANES]>,
    values: Vec<f64>,
}

impl Frame {
    /// The box of a boundary in the plane, with square pixels, `longest` of them along the longer side.
    #[must_use]
    pub fn of_plane(solution: &Solution, longest: usize) -> Self {
        let (low, high) = solution.problem.mesh.bounds();
        let extent = high - low;
        let pixel = extent.x.max(extent.y) / longest.max(1) as f64;
        let size = [extent.x, extent.y].map(|side| ((side / pixel).ceil() as usize).clamp(1, longest.max(1)));
        let sides = [DVec3::X * (pixel * size[0] as f64), DVec3::Y * (pixel * size[1] as f64)];
        Self { origin: low, sides, size }
    }

    /// # Errors
    /// When there are no pixels or too many, a number is not finite, or the sides span no plane; in the plane also when they leave it.
    fn check(&self, space: Space) -> Result<(), LaplaceError> {
        let [nx, ny] = self.size;
        let fault = |fault, message| Err(LaplaceError::new(fault, message));
        if nx == 0 || ny == 0 || nx.saturating_mul(ny) > MOST_PIXELS {
            return fault(
                Fault::Section,
                format!("{nx} by {ny} pixels were asked for; expected 1 to {MOST_PIXELS} in all"),
            );
        }
        let [u, v] = self.sides;
        // Of unit length, so that bodies of any size have sections.
        let unit = |side: DVec3| (side / side.abs().max_element()).normalize_or_zero();
        if !(self.origin.is_finite() && unit(u).cross(unit(v)).length() > PARALLEL) {
            let [u, v] = self.sides.map(|side| format!("({:e}, {:e}, {:e})", side.x, side.y, side.z));
            let message = format!("{u} and {v} were found; expected two sides that span a plane");
            return fault(Fault::Sides, message);
        }
        if space == Space::Plane && [self.origin, u, v].iter().any(|part| part.z != 0.0) {
            return fault(
                Fault::Sides,
                "the section leaves the plane of the problem; expected no third coordinate".to_owned(),
            );
        }
        Ok(())
    }
}

impl<S: Borrow<Solution>> SectionJob<S> {
    /// # Errors
    /// When there are no pixels or more than [`MOST_PIXELS`], or the sides span no plane.
    pub fn new(solution: S, frame: Frame) -> Result<Self, LaplaceError> {
        let known = solution.borrow();
        frame.check(known.panels.space)?;
        let scaling = known.problem.scaling;
        let materials = vec![f32::NAN; frame.size[0] * frame.size[1]];
        let section =
            Section { size: frame.size, values: vec![materials; known.materials()], inside: 0, clamped: 0 };
        let step = |axis: usize| frame.sides[axis] * (scaling.scale() / frame.size[axis] as f64);
        let side = frame.size[0].max(frame.size[1]).next_power_of_two().clamp(SMALLEST, LARGEST);
        let sides = std::iter::successors(Some(SMALLEST), |side| Some(2 * side)).take_while(|s| *s <= side);
        let count = known.fields.len() + 1;
        Ok(Self {
            origin: scaling.inwards(frame.origin),
            steps: [step(0), step(1)],
            bounds: known.panels.bounds(),
            weights: sides.map(Weights::new).collect(),
            halves: halves(),
            side,
            next: 0,
            all: Rc::new(Made { grids: Vec::new(), near: (0..known.panels.list.len() as u32).collect() }),
            waiting: Vec::new(),
            open: None,
            done: 0,
            scratch: Scratch {
                sums: vec![[0.0; LANES]; count],
                parts: vec![[0.0; LANES]; count],
                values: Vec::with_capacity(known.materials()),
            },
            solution,
            frame,
            section,
        })
    }

    /// Makes pixels while `may_go_on` says so, at least some; returns whether all are made.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> bool {
        loop {
            if let Some(rows) = self.open.take() {
                self.open = self.paint(rows);
            } else if let Some(tile) = self.waiting.pop().or_else(|| self.first()) {
                self.make(tile);
            } else {
                return true;
            }
            if !may_go_on() {
                return false;
            }
        }
    }

    /// Share of the pixels that are made.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.done as f64 / (self.frame.size[0] * self.frame.size[1]) as f64
    }

    /// The section, once [`step`](Self::step) has returned true.
    #[must_use]
    pub fn section(self) -> Section {
        self.section
    }

    /// Runs the job to its end.
    #[must_use]
    pub fn run(mut self) -> Section {
        self.step(&mut || true);
        self.section
    }

    /// The next of the largest tiles.
    fn first(&mut self) -> Option<Tile> {
        let [across, along] = self.frame.size.map(|count| count.div_ceil(self.side));
        if self.next == across * along {
            return None;
        }
        let corner = [self.next % across * self.side, self.next / across * self.side];
        self.next += 1;
        Some(Tile { corner, side: self.side, above: Rc::clone(&self.all), quarter: [0; 2] })
    }

    /// Pixels of a tile that are in the frame, along both sides.
    fn counts(&self, corner: [usize; 2], side: usize) -> [usize; 2] {
        [0, 1].map(|axis| side.min(self.frame.size[axis].saturating_sub(corner[axis])))
    }

    /// Finds what panels away from a tile do at its places, and quarters it or opens its pixels.
    fn make(&mut self, tile: Tile) {
        let Tile { corner, side, above, quarter: [right, up] } = tile;
        let counts = self.counts(corner, side);
        let half = self.steps.map(|step| step * (side as f64 / 2.0));
        let middle = self.origin
            + self.steps[0] * corner[0] as f64
            + self.steps[1] * corner[1] as f64
            + half[0]
            + half[1];
        let radius = (half[0] + half[1]).length().max((half[0] - half[1]).length());
        let (low, high) = self.bounds;
        if (middle - middle.clamp(low, high)).length() > radius {
            self.done += counts[0] * counts[1];
            return;
        }
        let solution: &Solution = self.solution.borrow();
        let (mut near, mut away) = (Vec::new(), Vec::new());
        for number in &above.near {
            let panel = &solution.panels.list[*number as usize];
            let distance = panel.centre.distance(middle);
            let taken = reach(panel.diameter, distance - radius);
            // No point of a panel is farther from its centre than two thirds of its longest side.
            if distance - panel.diameter / 1.5 <= APART * radius {
                near.push((*number, taken));
            } else {
                away.push((*number, taken));
            }
        }
        let fields = solution.fields.len();
        let inherited = |grid: &Grid| quarter(grid, &self.halves[right], &self.halves[up]);
        let mut grids: Vec<Grid> = above.grids.iter().map(inherited).collect();
        grids.resize(fields + 1, [[0.0; NODES]; NODES]);
        for row in 0..NODES {
            let points = Points::new(|column| middle + half[0] * place(column) + half[1] * place(row));
            self.scratch.sums.iter_mut().zip(&grids).for_each(|(sum, grid)| *sum = grid[row]);
            self.scratch.add(solution, &away, &points);
            self.scratch.sums.iter().zip(&mut grids).for_each(|(sum, grid)| grid[row] = *sum);
        }
        if near.is_empty() && grids[fields][0][0] < 0.5 {
            // All of it is outside.
            self.done += counts[0] * counts[1];
        } else if side > SMALLEST && near.len() * side * side > MANY {
            let above = Rc::new(Made { grids, near: near.into_iter().map(|(number, _)| number).collect() });
            let half = side / 2;
            for quarter in [[1, 1], [0, 1], [1, 0], [0, 0]] {
                let corner = [corner[0] + quarter[0] * half, corner[1] + quarter[1] * half];
                if self.counts(corner, half).iter().all(|count| *count > 0) {
                    self.waiting.push(Tile { corner, side: half, above: Rc::clone(&above), quarter });
                }
            }
        } else {
            self.open = Some(Rows { corner, side, grids, near, row: 0 });
        }
    }

    /// Makes some rows of pixels; returns the tile where it has more.
    fn paint(&mut self, mut rows: Rows) -> Option<Rows> {
        let solution: &Solution = self.solution.borrow();
        let fields = solution.fields.len();
        let [across, along] = self.counts(rows.corner, rows.side);
        let weights = self.weights.get((rows.side / SMALLEST).ilog2() as usize)?;
        let some = (BATCH / (across * (rows.near.len() + SMALLEST))).max(1);
        let end = (rows.row + some).min(along);
        let mut numbers = vec![[0.0; NODES]; fields + 1];
        for row in rows.row..end {
            let y = rows.corner[1] + row;
            numbers.iter_mut().zip(&rows.grids).for_each(|(own, grid)| *own = weights.row(grid, row));
            for first in (0..across).step_by(LANES) {
                let x = rows.corner[0] + first;
                let sums = &mut self.scratch.sums;
                sums.iter_mut().zip(&numbers).for_each(|(sum, row)| *sum = weights.pixels(row, first));
                let start = self.origin + self.steps[1] * (y as f64 + 0.5);
                let points = Points::new(|lane| start + self.steps[0] * ((x + lane) as f64 + 0.5));
                self.scratch.add(solution, &rows.near, &points);
                for lane in 0..LANES.min(across - first) {
                    let winding = self.scratch.sums[fields][lane];
                    if winding <= INSIDE {
                        continue;
                    }
                    let sums = self.scratch.sums[..fields].iter().map(|sum| sum[lane]);
                    let is_clamped = solution.show(winding, sums, &mut self.scratch.values);
                    let pixel = y * self.frame.size[0] + x + lane;
                    for (list, value) in self.section.values.iter_mut().zip(&self.scratch.values) {
                        list[pixel] = *value as f32;
                    }
                    self.section.inside += 1;
                    self.section.clamped += usize::from(is_clamped);
                }
            }
        }
        self.done += (end - rows.row) * across;
        rows.row = end;
        (end < along).then_some(rows)
    }
}

impl Scratch {
    /// Adds what panels do at points to the sums.
    fn add(&mut self, solution: &Solution, list: &[(u32, Reach)], points: &Points) {
        let panels = &*solution.panels;
        for some in list.chunks(FLUSHED) {
            self.parts.fill([0.0; LANES]);
            for (number, taken) in some {
                let number = *number as usize;
                let lanes = layers(panels.space, &panels.list[number], *taken, points);
                let [fields @ .., winding] = &mut self.parts[..] else { return };
                for (part, field) in fields.iter_mut().zip(&solution.fields) {
                    let (value, flux) = (field.value(number) as f32, field.flux(number) as f32);
                    for (part, (single, double)) in
                        part.iter_mut().zip(lanes.single.iter().zip(&lanes.double))
                    {
                        *part += single * flux + double * value;
                    }
                }
                winding.iter_mut().zip(&lanes.double).for_each(|(sum, double)| *sum += double);
            }
            for (sum, part) in self.sums.iter_mut().zip(&self.parts) {
                sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += f64::from(*part));
            }
        }
    }
}
