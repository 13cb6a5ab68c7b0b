//! The matrix of the equations, whole or recomputed in every product.

use super::cloud::{Charges, Sums};
use super::cluster::{Panels, Reach, SLOTS};
use super::error::{Fault, LaplaceError};
use super::expansion::{Expansions, Moments, Targets};
use super::panel::Space;
use super::single::LANES as TOGETHER;
use glam::DVec3;
use std::ops::Range;
use std::rc::Rc;

/// Most unknowns of a whole matrix: 256 MB.
pub const MOST_DENSE: usize = 8_000;

/// Numbers that are added up together.
const LANES: usize = 4;

/// Clusters whose sums in single precision are added up before they go into one in double precision.
const FLUSHED: usize = 16;

/// A square matrix of which products with vectors can be asked for, row by row.
#[derive(Debug)]
pub(super) struct Matrix {
    /// What stands on the diagonal; not in single precision, because it holds sums over whole rows.
    pub(super) diagonal: Vec<f64>,
    /// Added to every entry of a column besides, where it is not in them already: with fluxes alone the mean over the boundary, which fixes the constant.
    pub(super) mean: Option<Vec<f64>>,
    pub(super) off: Off,
}

/// What stands beside the diagonal.
#[derive(Debug)]
pub(super) enum Off {
    /// All of it, row by row, with zeros on the diagonal.
    Dense(Vec<f32>),
    /// What is near.
    Near(Near),
}

/// Interactions of panels with clusters near to them; the others are recomputed.
#[derive(Debug)]
pub(super) struct Near {
    panels: Rc<Panels>,
    /// Of each panel whether its value is unknown; else its flux is.
    is_value_unknown: Vec<bool>,
    /// Of each row where its near clusters start.
    starts: Vec<usize>,
    /// Near clusters, row after row.
    clusters: Vec<u16>,
    /// A number for each slot of these.
    entries: Vec<f32>,
    /// In space, what clusters do far away.
    expansions: Option<Expansions>,
}

/// A vector as charges of the slots.
#[derive(Debug, Clone, Default)]
pub(super) struct Spread {
    charges: Charges,
    /// Of each cluster, in space.
    moments: Vec<Moments>,
    mean: f64,
}

impl Near {
    pub(super) fn new(panels: Rc<Panels>, is_value_unknown: Vec<bool>) -> Self {
        let expansions = (panels.space == Space::Solid).then(|| Expansions::new(&panels));
        Self {
            panels,
            is_value_unknown,
            starts: vec![0],
            clusters: Vec::new(),
            entries: Vec::new(),
            expansions,
        }
    }

    /// Adds a near cluster to the row that comes next.
    pub(super) fn push(&mut self, cluster: usize, entries: &[f32; SLOTS]) {
        self.clusters.push(cluster as u16);
        self.entries.extend_from_slice(entries);
    }

    /// Ends a row.
    pub(super) fn end_row(&mut self) {
        self.starts.push(self.clusters.len());
    }
}

impl Matrix {
    /// Room for a whole matrix.
    ///
    /// # Errors
    /// When there is not so much memory.
    pub(super) fn room(n: usize) -> Result<Vec<f32>, LaplaceError> {
        let mut entries: Vec<f32> = Vec::new();
        let count = n.saturating_mul(n);
        if n > MOST_DENSE || entries.try_reserve_exact(count).is_err() {
            let message = format!("a matrix of {n} unknowns was asked for; there is no memory for it");
            return Err(LaplaceError::new(Fault::Limit, message));
        }
        entries.resize(count, 0.0);
        Ok(entries)
    }

    pub(super) fn len(&self) -> usize {
        self.diagonal.len()
    }

    /// A row of a whole matrix, without its diagonal.
    pub(super) fn row(&self, row: usize) -> Option<&[f32]> {
        match &self.off {
            Off::Dense(entries) => Some(&entries[row * self.len()..(row + 1) * self.len()]),
            Off::Near(_) => None,
        }
    }

    /// What products of rows with a vector have in common.
    pub(super) fn spread(&self, x: &[f64]) -> Spread {
        let mean = self.mean.as_ref().map_or(0.0, |mean| dot(mean, x));
        let Off::Near(near) = &self.off else { return Spread { mean, ..Spread::default() } };
        let has_values = near.is_value_unknown.contains(&true);
        let charge = |of_values: bool| {
            let of = |panel: &u32| match x.get(*panel as usize) {
                Some(x) if near.is_value_unknown[*panel as usize] == of_values => *x as f32,
                _ => 0.0,
            };
            near.panels.order.iter().map(of).collect()
        };
        let double = if has_values { charge(true) } else { Vec::new() };
        let charges = Charges { single: charge(false), double };
        let expanded = |expansions: &Expansions| expansions.moments(&near.panels, &charges);
        Spread { moments: near.expansions.as_ref().map(expanded).unwrap_or_default(), charges, mean }
    }

    /// Products of some rows with a vector; where the matrix is recomputed, of the panels in slots of these numbers.
    pub(super) fn multiply(&self, x: &[f64], spread: &Spread, rows: Range<usize>, y: &mut [f64]) {
        let n = self.len();
        match &self.off {
            Off::Dense(entries) => {
                for row in rows {
                    y[row] = product(&entries[row * n..(row + 1) * n], x)
                        + self.diagonal[row] * x[row]
                        + spread.mean;
                }
            }
            Off::Near(near) => {
                let mut start = rows.start;
                while start < rows.end {
                    let end = (start - start % TOGETHER + TOGETHER).min(rows.end);
                    for (row, product) in near.products(start..end, spread) {
                        y[row] = product + self.diagonal[row] * x[row] + spread.mean;
                    }
                    start = end;
                }
            }
        }
    }

    /// Rows between two looks at the clock.
    pub(super) fn batch(&self) -> usize {
        ((1 << 20) / self.len().max(1)).max(1)
    }
}

impl Near {
    /// The products of a few rows, those of the panels in these slots, which are of one cluster.
    fn products(&self, slots: Range<usize>, spread: &Spread) -> impl Iterator<Item = (usize, f64)> {
        let panels = &*self.panels;
        let rows: [usize; TOGETHER] =
            std::array::from_fn(|lane| panels.order[(slots.start + lane).min(slots.end - 1)] as usize);
        let targets =
            Targets::new(&panels.clusters[slots.start / SLOTS], rows.map(|row| panels.list[row].centre));
        let mut expanded = [0.0_f64; TOGETHER];
        let mut direct: Vec<u16> = Vec::with_capacity(panels.clusters.len());
        let mut sums = [0.0_f32; TOGETHER];
        for (number, cluster) in panels.clusters.iter().enumerate() {
            if number % FLUSHED == 0 {
                expanded.iter_mut().zip(&sums).for_each(|(far, sum)| *far += f64::from(*sum));
                sums = [0.0; TOGETHER];
            }
            match spread.moments.get(number) {
                Some(moments) if targets.is_beyond(cluster) => targets.add(cluster, moments, &mut sums),
                _ => direct.push(number as u16),
            }
        }
        expanded.iter_mut().zip(&sums).for_each(|(far, sum)| *far += f64::from(*sum));
        let product = move |lane: usize| {
            let row = rows[lane];
            (row, self.product(row, &direct, expanded[lane], &spread.charges))
        };
        (0..slots.len()).map(product)
    }

    /// The product of a row, from that of the clusters that were expanded and those that were not.
    fn product(&self, row: usize, direct: &[u16], mut far: f64, charges: &Charges) -> f64 {
        let panels = &*self.panels;
        let x: DVec3 = panels.list[row].centre;
        let mut near = 0.0;
        let mut at = self.starts[row];
        let mut sums = Sums::default();
        for (count, number) in direct.iter().enumerate() {
            let cluster = &panels.clusters[*number as usize];
            if count % FLUSHED == 0 {
                far += sums.iter().map(|sum| f64::from(*sum)).sum::<f64>();
                sums = Sums::default();
            }
            let own = (x - cluster.centre).as_vec3();
            match Panels::reach(cluster, x) {
                Reach::Far => panels.centres.sum(panels.space, &cluster.slots, own, charges, &mut sums),
                Reach::Medium => {
                    for cloud in &panels.places {
                        cloud.sum(panels.space, &cluster.slots, own, charges, &mut sums);
                    }
                }
                Reach::Near => {
                    let entries = &self.entries[at * SLOTS..(at + 1) * SLOTS];
                    let single = charges.single[cluster.slots.clone()].iter();
                    for (entry, charge) in entries.iter().zip(single) {
                        near += f64::from(entry * charge);
                    }
                    if !charges.double.is_empty() {
                        let double = charges.double[cluster.slots.clone()].iter();
                        for (entry, charge) in entries.iter().zip(double) {
                            near += f64::from(entry * charge);
                        }
                    }
                    at += 1;
                }
            }
        }
        far += sums.iter().map(|sum| f64::from(*sum)).sum::<f64>();
        // Rows of panels whose value is unknown have the opposite sign, which the near entries have already.
        if self.is_value_unknown[row] { near - far } else { near + far }
    }
}

/// The product of a row in single precision with a vector, in double precision.
pub(super) fn product(row: &[f32], x: &[f64]) -> f64 {
    let mut sums = [[0.0; LANES]; 2];
    let (rows, rest) = row.as_chunks::<{ 2 * LANES }>();
    let (xs, more) = x.as_chunks::<{ 2 * LANES }>();
    for (row, x) in rows.iter().zip(xs) {
        for l in 0..LANES {
            sums[0][l] += f64::from(row[l]) * x[l];
            sums[1][l] += f64::from(row[LANES + l]) * x[LANES + l];
        }
    }
    let tail: f64 = rest.iter().zip(more).map(|(a, x)| f64::from(*a) * x).sum();
    tail + sums.iter().flatten().sum::<f64>()
}

/// The product of two vectors.
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    let (first, rest) = a.as_chunks::<LANES>();
    let (second, more) = b.as_chunks::<LANES>();
    for (a, b) in first.iter().zip(second) {
        for l in 0..LANES {
            sums[l] += a[l] * b[l];
        }
    }
    rest.iter().zip(more).map(|(a, b)| a * b).sum::<f64>() + sums.iter().sum::<f64>()
}

/// The Euclidean length of a vector.
pub(super) fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}
