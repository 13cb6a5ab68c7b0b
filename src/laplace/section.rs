//! The solution on the pixels of a plane, in steps.
//!
//! Pixels are taken in tiles. What panels away from a tile do to it is a smooth function, which is found at Chebyshev's places and interpolated; the others
//! are integrated exactly for every pixel. So a picture costs little more than its tiles.

use super::cloud::Values;
use super::cluster::NOBODY;
use super::error::{Fault, LaplaceError};
use super::panel::{Panel, Space};
use super::solution::{INSIDE, Solution};
use glam::DVec3;
use std::borrow::Borrow;
use std::f64::consts::PI;

/// Pixels along a side of a tile.
const TILE: usize = 32;

/// Places along a side of a tile between which is interpolated.
const NODES: usize = 8;

/// Panels that come nearer to the middle of a tile than so many times its half diagonal are integrated exactly; the others are interpolated, to about 1e-5.
const APART: f64 = 1.75;

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
    /// The corner and the sides in the coordinates of computing.
    origin: DVec3,
    steps: [DVec3; 2],
    /// Of each pixel of a tile the weights of the places along a side.
    weights: [[f64; NODES]; TILE],
    /// The next tile.
    tile: usize,
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
        let area = u.cross(v).length();
        if !(self.origin.is_finite() && area.is_finite() && area > 0.0) {
            return fault(Fault::Section, format!("the sides {u} and {v} at {} span no plane", self.origin));
        }
        if space == Space::Plane && [self.origin, u, v].iter().any(|part| part.z != 0.0) {
            return fault(
                Fault::Section,
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
        let count = frame.size[0] * frame.size[1];
        let section = Section {
            size: frame.size,
            values: vec![vec![f32::NAN; count]; known.materials()],
            inside: 0,
            clamped: 0,
        };
        let step = |axis: usize| frame.sides[axis] * (scaling.scale() / frame.size[axis] as f64);
        Ok(Self {
            origin: scaling.inwards(frame.origin),
            steps: [step(0), step(1)],
            weights: std::array::from_fn(|pixel| weights(2.0 * (pixel as f64 + 0.5) / TILE as f64 - 1.0)),
            tile: 0,
            solution,
            frame,
            section,
        })
    }

    /// Makes tiles while `may_go_on` says so, at least one; returns whether all are made.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> bool {
        let count = self.tiles();
        while self.tile < count {
            self.make();
            self.tile += 1;
            if !may_go_on() {
                break;
            }
        }
        self.tile == count
    }

    /// Share of the tiles that are made.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.tile as f64 / self.tiles() as f64
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

    fn tiles(&self) -> usize {
        self.frame.size.iter().map(|count| count.div_ceil(TILE)).product()
    }

    fn make(&mut self) {
        let solution: &Solution = self.solution.borrow();
        let panels = &*solution.panels;
        let across = self.frame.size[0].div_ceil(TILE);
        let corner = [self.tile % across * TILE, self.tile / across * TILE];
        let half = self.steps.map(|step| step * (TILE as f64 / 2.0));
        let middle = self.origin
            + self.steps[0] * corner[0] as f64
            + self.steps[1] * corner[1] as f64
            + half[0]
            + half[1];
        let reach = (half[0] + half[1]).length().max((half[0] - half[1]).length());
        let (low, high) = panels.bounds();
        if (middle - middle.clamp(low, high)).length() > reach {
            return;
        }
        let (near, masks) = self.parted(middle, APART * reach);
        let fields = solution.fields.len();
        // Sums of each material, and the share of the full angle as the last one.
        let mut nodes = vec![[[0.0; NODES]; NODES]; fields + 1];
        let mut sums = vec![0.0; fields];
        let mut values = Values::default();
        for row in 0..NODES {
            for column in 0..NODES {
                let x = middle + half[0] * place(column) + half[1] * place(row);
                sums.fill(0.0);
                let mut winding = 0.0;
                for (cluster, mask) in panels.clusters.iter().zip(&masks) {
                    if *mask == u32::MAX {
                        continue;
                    }
                    panels.layers(cluster, x, &mut values);
                    if *mask != 0 {
                        for slot in (0..u32::BITS as usize).filter(|slot| mask >> slot & 1 == 1) {
                            values.single[slot] = 0.0;
                            values.double[slot] = 0.0;
                        }
                    }
                    winding += solution.add(&values, cluster.slots.start, &mut sums);
                }
                for (node, sum) in nodes.iter_mut().zip(sums.iter().chain([&winding])) {
                    node[row][column] = *sum;
                }
            }
        }
        let counts = [0, 1].map(|axis| TILE.min(self.frame.size[axis] - corner[axis]));
        for j in 0..counts[1] {
            // The places of the row of pixels, first between the rows of nodes.
            let rows: Vec<[f64; NODES]> = nodes.iter().map(|node| between(node, &self.weights[j])).collect();
            for i in 0..counts[0] {
                let mut found: Vec<f64> = rows.iter().map(|row| product(row, &self.weights[i])).collect();
                let at = [corner[0] + i, corner[1] + j];
                let x =
                    self.origin + self.steps[0] * (at[0] as f64 + 0.5) + self.steps[1] * (at[1] as f64 + 0.5);
                for (number, panel) in &near {
                    let layers = panels.space.layers(panel, x);
                    for (sum, field) in found.iter_mut().zip(&solution.fields) {
                        *sum += layers.single * field.flux(*number) + layers.double * field.value(*number);
                    }
                    found[fields] += layers.double;
                }
                if found[fields] <= INSIDE {
                    continue;
                }
                let value = solution.shown(found[fields], &found[..fields]);
                let pixel = at[1] * self.frame.size[0] + at[0];
                for (list, value) in self.section.values.iter_mut().zip(&value.values) {
                    list[pixel] = *value as f32;
                }
                self.section.inside += 1;
                self.section.clamped += usize::from(value.is_clamped);
            }
        }
    }

    /// The panels near to a tile, and for each cluster which of its slots they are in, by bits.
    fn parted(&self, middle: DVec3, reach: f64) -> (Vec<(usize, Panel)>, Vec<u32>) {
        let panels = &*self.solution.borrow().panels;
        let mut near = Vec::new();
        let mut masks = Vec::with_capacity(panels.clusters.len());
        for cluster in &panels.clusters {
            let mut mask = 0;
            if !cluster.is_beyond(middle, reach) {
                for (slot, number) in panels.order[cluster.slots.clone()].iter().enumerate() {
                    let Some(panel) = panels.list.get(*number as usize) else {
                        debug_assert_eq!(*number, NOBODY);
                        mask |= 1_u32 << slot;
                        continue;
                    };
                    // No point of a panel is farther from its centre than two thirds of its longest side.
                    if panel.centre.distance(middle) - panel.diameter / 1.5 <= reach {
                        mask |= 1_u32 << slot;
                        near.push((*number as usize, *panel));
                    }
                }
            }
            masks.push(mask);
        }
        (near, masks)
    }
}

/// A place of Chebyshev's in [-1, 1].
fn place(number: usize) -> f64 {
    -(PI * (number as f64 + 0.5) / NODES as f64).cos()
}

/// Lagrange's polynomials of these places at x.
fn weights(x: f64) -> [f64; NODES] {
    std::array::from_fn(|own| {
        let factor = |other: usize| (x - place(other)) / (place(own) - place(other));
        (0..NODES).filter(|other| *other != own).map(factor).product()
    })
}

fn product(a: &[f64; NODES], b: &[f64; NODES]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn between(rows: &[[f64; NODES]; NODES], weights: &[f64; NODES]) -> [f64; NODES] {
    std::array::from_fn(|column| (0..NODES).map(|row| rows[row][column] * weights[row]).sum())
}
