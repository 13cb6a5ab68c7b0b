//! The matrix of the equations, whole; or what is nearby, with expansions of what is far away made anew in every product.

use super::cloud::{Charges, Sums};
use super::cluster::{Cluster, Panels, Reach, SLOTS};
use super::error::{Fault, LaplaceError};
use super::expansion::{Expansions, Moments, Targets, is_beyond};
use super::panel::Space;
use super::single::LANES as TOGETHER;
use glam::DVec3;
use std::ops::Range;
use std::rc::Rc;

/// Most unknowns of a whole matrix: 256 MB.
pub const MOST_DENSE: usize = 8_000;

/// Most numbers kept of a matrix that is not whole: 256 MB. What is nearby is always kept, up to twice as many.
const MOST_KEPT: usize = 1 << 26;
const MOST_NEAR: usize = 1 << 27;

/// Numbers that get memory together: 16 MB.
const PIECE: usize = 1 << 22;

/// Numbers in double precision that are added up together.
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

/// Interactions of panels with clusters around them. Clusters far away are expanded in every product, and those between are recomputed where there was no
/// room for them.
#[derive(Debug)]
pub(super) struct Near {
    panels: Rc<Panels>,
    /// Of each panel whether its value is unknown; else its flux is.
    is_value_unknown: Vec<bool>,
    /// Of each panel the cluster that it is in.
    homes: Vec<u16>,
    rows: Vec<Kept>,
    /// The numbers that are kept, in pieces: memory grows slowly when it grows often.
    pieces: Vec<Vec<f32>>,
    /// Numbers kept so far.
    count: usize,
    /// In space, what clusters do far away.
    expansions: Option<Expansions>,
}

/// What is kept of a row.
#[derive(Debug)]
struct Kept {
    /// Clusters in ascending order.
    clusters: Box<[u16]>,
    /// The piece with a number for each slot of these, and where they start in it.
    piece: usize,
    start: usize,
}

/// A row being made.
#[derive(Debug, Default)]
pub(super) struct Keeping {
    clusters: Vec<u16>,
    entries: Vec<f32>,
}

/// A vector as charges of the slots.
#[derive(Debug, Clone, Default)]
pub(super) struct Spread {
    charges: Charges,
    /// Both charges, of which a slot has one.
    whole: Vec<f32>,
    /// Of each cluster, in space.
    moments: Vec<Moments>,
    mean: f64,
}

impl Near {
    pub(super) fn new(panels: Rc<Panels>, is_value_unknown: Vec<bool>) -> Self {
        let expansions = (panels.space == Space::Solid).then(Expansions::default);
        let mut homes = vec![0; panels.list.len()];
        for (slot, number) in panels.order.iter().enumerate() {
            if let Some(home) = homes.get_mut(*number as usize) {
                *home = (slot / SLOTS) as u16;
            }
        }
        Self { panels, is_value_unknown, homes, rows: Vec::new(), pieces: Vec::new(), count: 0, expansions }
    }

    /// Prepares the expansion of the next cluster; returns whether there was one.
    pub(super) fn expand(&mut self) -> bool {
        self.expansions.as_mut().is_some_and(|expansions| expansions.push(&self.panels))
    }

    /// Whether what a cluster does to a row is kept, when its panels are taken like this.
    pub(super) fn keeps(&self, row: usize, cluster: &Cluster, taken: Reach) -> bool {
        let home = &self.panels.clusters[usize::from(self.homes[row])];
        taken == Reach::Near
            || (self.count < MOST_KEPT && !(self.expansions.is_some() && is_beyond(home, cluster)))
    }

    /// Adds the row that comes next.
    ///
    /// # Errors
    /// When there is no room for it.
    pub(super) fn push(&mut self, row: Keeping) -> Result<(), LaplaceError> {
        self.count += row.entries.len();
        if self.count > MOST_NEAR {
            let message = format!(
                "the elements are so long that more than {MOST_NEAR} interactions of them are near; expected fewer or shorter ones"
            );
            return Err(LaplaceError::new(Fault::Limit, message));
        }
        let room = self.pieces.last().map_or(0, |piece| piece.capacity() - piece.len());
        if room < row.entries.len() {
            self.pieces.push(Vec::with_capacity(row.entries.len().max(PIECE)));
        }
        let piece = self.pieces.len().saturating_sub(1);
        let start = self.pieces.last().map_or(0, Vec::len);
        if let Some(last) = self.pieces.last_mut() {
            last.extend_from_slice(&row.entries);
        }
        self.rows.push(Kept { clusters: row.clusters.into(), piece, start });
        Ok(())
    }
}

impl Keeping {
    /// Adds the numbers of a cluster.
    pub(super) fn add(&mut self, cluster: usize, entries: &[f32; SLOTS]) {
        self.clusters.push(cluster as u16);
        self.entries.extend_from_slice(entries);
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
        let whole = near.panels.order.iter().map(|n| x.get(*n as usize).map_or(0.0, |x| *x as f32)).collect();
        Spread { moments: near.expansions.as_ref().map(expanded).unwrap_or_default(), charges, whole, mean }
    }

    /// Products of some rows with a vector; where the matrix is not whole, of the panels in slots of these numbers.
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
        let home = &panels.clusters[slots.start / SLOTS];
        let targets = Targets::new(home, rows.map(|row| panels.list[row].centre));
        let mut expanded = [0.0_f64; TOGETHER];
        let mut direct: Vec<u16> = Vec::with_capacity(panels.clusters.len());
        let mut sums = [0.0_f32; TOGETHER];
        for (number, cluster) in panels.clusters.iter().enumerate() {
            if number % FLUSHED == 0 {
                expanded.iter_mut().zip(&sums).for_each(|(far, sum)| *far += f64::from(*sum));
                sums = [0.0; TOGETHER];
            }
            match spread.moments.get(number) {
                Some(moments) if is_beyond(home, cluster) => targets.add(cluster, moments, &mut sums),
                _ => direct.push(number as u16),
            }
        }
        expanded.iter_mut().zip(&sums).for_each(|(far, sum)| *far += f64::from(*sum));
        let product = move |lane: usize| {
            let row = rows[lane];
            (row, self.product(row, &direct, expanded[lane], spread))
        };
        (0..slots.len()).map(product)
    }

    /// The product of a row, from that of the clusters that were expanded and those that were not.
    fn product(&self, row: usize, direct: &[u16], mut far: f64, spread: &Spread) -> f64 {
        let panels = &*self.panels;
        let x: DVec3 = panels.list[row].centre;
        let kept = &self.rows[row];
        let mut near = 0.0;
        let numbers = self.pieces.get(kept.piece).map_or(&[][..], |piece| &piece[kept.start..]);
        let mut next = kept.clusters.iter().zip(numbers.as_chunks::<SLOTS>().0).peekable();
        let mut sums = Sums::default();
        for (count, number) in direct.iter().enumerate() {
            let cluster = &panels.clusters[usize::from(*number)];
            if let Some((_, entries)) = next.next_if(|(kept, _)| *kept == number) {
                near += kept_product(entries, &spread.whole[cluster.slots.clone()]);
                continue;
            }
            if count % FLUSHED == 0 {
                far += sums.iter().map(|sum| f64::from(*sum)).sum::<f64>();
                sums = Sums::default();
            }
            let own = (x - cluster.centre).as_vec3();
            let charges = &spread.charges;
            if Panels::reach(cluster, x) == Reach::Far {
                panels.centres.sum(panels.space, &cluster.slots, own, charges, &mut sums);
            } else {
                for cloud in &panels.places {
                    cloud.sum(panels.space, &cluster.slots, own, charges, &mut sums);
                }
            }
        }
        far += sums.iter().map(|sum| f64::from(*sum)).sum::<f64>();
        // Rows of panels whose value is unknown have the opposite sign, which the entries that are kept have already.
        if self.is_value_unknown[row] { near - far } else { near + far }
    }
}

/// The product of the entries of a cluster with its charges.
#[inline(always)]
fn kept_product(entries: &[f32; SLOTS], charges: &[f32]) -> f64 {
    let mut sums = [0.0_f32; TOGETHER];
    for (entries, charges) in entries.as_chunks::<TOGETHER>().0.iter().zip(charges.as_chunks::<TOGETHER>().0)
    {
        sums.iter_mut()
            .zip(entries.iter().zip(charges))
            .for_each(|(sum, (entry, charge))| *sum += entry * charge);
    }
    f64::from(sums.iter().sum::<f32>())
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laplace::cloud::Values;
    use crate::laplace::samples;

    #[test]
    fn more_than_there_is_room_for_is_refused() {
        let mesh = samples::cube(3);
        let panels = Rc::new(Panels::new(mesh.space(), mesh.panels()));
        let mut near = Near::new(Rc::clone(&panels), vec![false; panels.list.len()]);
        let row = || {
            let mut row = Keeping::default();
            row.add(1, &[0.0; SLOTS]);
            row
        };
        assert!(near.push(row()).is_ok());
        near.count = MOST_KEPT;
        assert!(!near.keeps(0, &panels.clusters[1], Reach::Medium), "what is not near is recomputed then");
        assert!(near.keeps(0, &panels.clusters[1], Reach::Near));
        near.count = MOST_NEAR;
        assert_eq!(near.push(row()).unwrap_err().fault, Fault::Limit);
    }

    #[test]
    fn what_is_not_kept_is_recomputed() {
        let mesh = samples::cube(8);
        let panels = Rc::new(Panels::new(mesh.space(), mesh.panels()));
        let n = panels.list.len();
        let x: Vec<f64> = (0..n).map(|k| (k as f64).sin()).collect();
        let [all, few] = [0, MOST_KEPT].map(|count| {
            let mut near = Near::new(Rc::clone(&panels), vec![false; n]);
            near.count = count;
            while near.expand() {}
            for row in 0..n {
                let mut kept = Keeping::default();
                for (number, cluster) in panels.clusters.iter().enumerate() {
                    let mut values = Values::default();
                    let reach = panels.layers(cluster, panels.list[row].centre, &mut values);
                    if near.keeps(row, cluster, reach) {
                        kept.add(number, &values.single);
                    }
                }
                near.push(kept).unwrap();
            }
            let matrix = Matrix { diagonal: vec![0.0; n], mean: None, off: Off::Near(near) };
            let mut y = vec![0.0; n];
            matrix.multiply(&x, &matrix.spread(&x), 0..n, &mut y);
            y
        });
        let difference: Vec<f64> = all.iter().zip(&few).map(|(a, b)| a - b).collect();
        assert!(norm(&difference) < 1e-6 * norm(&all), "{} of {}", norm(&difference), norm(&all));
    }
}
