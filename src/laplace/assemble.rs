//! Collocation: an equation for the middle of each panel.
//!
//! With g and d the layers of panel k at the middle of panel j, the direct formulation says sum_k d (phi_j - phi_k) = sum_k g q_k, where phi is the value
//! and q the outward flux (Liu and others 2003, Eq. 12). The free term is the sum of the d over the row, which is 1/2 but for the error of quadrature; so
//! constants are solutions to rounding. Rows of panels whose value is unknown have the opposite sign, so that the diagonal is positive.

use super::cloud::Values;
use super::cluster::{NOBODY, Panels, SLOTS};
use super::error::{Fault, LaplaceError};
use super::matrix::{Keeping, MOST_DENSE, Matrix, Near, Off};
use std::rc::Rc;

/// How far the sum of a row may be from 1/2: beyond, the boundary meets itself there.
const CLOSED: f64 = 0.2;

/// What is given, in the units of computing.
#[derive(Debug, Clone)]
pub(super) struct Given {
    /// Of each panel whether its value is given; else its flux is.
    pub(super) is_value: Vec<bool>,
    /// For each material what is given.
    pub(super) data: Vec<Vec<f64>>,
}

/// The equations, made row by row.
#[derive(Debug)]
pub(super) struct Assembly {
    panels: Rc<Panels>,
    given: Given,
    matrix: Matrix,
    sides: Vec<Vec<f64>>,
    closure: f64,
    /// With fluxes alone, the share of each panel in the boundary: the mean is added to every equation, and so is 0 in the solution.
    mean: Option<Vec<f64>>,
    slots: Slots,
    /// The next row.
    row: usize,
}

/// What is given in each slot; 0 where it is not.
#[derive(Debug)]
struct Slots {
    is_value: Vec<bool>,
    values: Vec<Vec<f32>>,
    fluxes: Vec<Vec<f32>>,
}

/// The equations.
#[derive(Debug)]
pub(super) struct Equations {
    pub(super) matrix: Matrix,
    /// For each material the right-hand side.
    pub(super) sides: Vec<Vec<f64>>,
    /// Largest difference between 1/2 and the sum over a row.
    pub(super) closure: f64,
}

impl Assembly {
    /// # Errors
    /// When there is no memory for the matrix.
    pub(super) fn new(panels: Rc<Panels>, given: Given, most_dense: usize) -> Result<Self, LaplaceError> {
        let n = panels.list.len();
        let off = if n <= most_dense.min(MOST_DENSE) {
            Off::Dense(Matrix::room(n)?)
        } else {
            Off::Near(Near::new(
                Rc::clone(&panels),
                given.is_value.iter().map(|is_value| !is_value).collect(),
            ))
        };
        let column = |data: &Vec<f64>, of_values: bool| -> Vec<f32> {
            let of = |panel: &u32| match data.get(*panel as usize) {
                Some(datum) if given.is_value[*panel as usize] == of_values => *datum as f32,
                _ => 0.0,
            };
            panels.order.iter().map(of).collect()
        };
        let slots = Slots {
            is_value: panels.order.iter().map(|n| *n == NOBODY || given.is_value[*n as usize]).collect(),
            values: given.data.iter().map(|data| column(data, true)).collect(),
            fluxes: given.data.iter().map(|data| column(data, false)).collect(),
        };
        let mean: Option<Vec<f64>> = (!given.is_value.contains(&true)).then(|| {
            let whole: f64 = panels.list.iter().map(|panel| panel.size).sum();
            panels.list.iter().map(|panel| panel.size / whole).collect()
        });
        let recomputed = mean.clone().filter(|_| matches!(off, Off::Near(_)));
        Ok(Self {
            matrix: Matrix { diagonal: Vec::with_capacity(n), mean: recomputed, off },
            mean,
            sides: vec![Vec::with_capacity(n); given.data.len()],
            closure: 0.0,
            slots,
            row: 0,
            given,
            panels,
        })
    }

    /// Makes rows while `may_go_on` says so; returns whether all are there.
    ///
    /// # Errors
    /// When the boundary meets itself, with the element.
    pub(super) fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Result<bool, LaplaceError> {
        let n = self.panels.list.len();
        let batch = ((1 << 16) / n.max(1)).max(1);
        while let Off::Near(near) = &mut self.matrix.off
            && near.expand()
        {
            if !may_go_on() {
                return Ok(false);
            }
        }
        while self.row < n {
            for _ in 0..batch.min(n - self.row) {
                self.make_row()?;
            }
            if !may_go_on() {
                break;
            }
        }
        Ok(self.row == n)
    }

    /// Share of the rows that are there.
    pub(super) fn progress(&self) -> f64 {
        self.row as f64 / self.panels.list.len().max(1) as f64
    }

    /// The equations, once all rows are there.
    pub(super) fn finish(self) -> Equations {
        Equations { matrix: self.matrix, sides: self.sides, closure: self.closure }
    }

    fn make_row(&mut self) -> Result<(), LaplaceError> {
        let row = self.row;
        let panels = Rc::clone(&self.panels);
        let n = panels.list.len();
        let own = &panels.list[row];
        let is_value = self.given.is_value[row];
        let sign = if is_value { 1.0 } else { -1.0 };
        let mut values = Values::default();
        let mut whole = 0.0;
        let mut sums = vec![0.0; self.sides.len()];
        let mut kept = Keeping::default();
        for (number, cluster) in panels.clusters.iter().enumerate() {
            let reach = panels.layers(cluster, own.centre, &mut values);
            let slots = cluster.slots.clone();
            whole += values.double.iter().map(|double| f64::from(*double)).sum::<f64>();
            for ((sum, given), fluxes) in sums.iter_mut().zip(&self.slots.values).zip(&self.slots.fluxes) {
                let mut part = [0.0_f32; 8];
                let columns =
                    values.double.as_chunks::<8>().0.iter().zip(given[slots.clone()].as_chunks::<8>().0);
                let others =
                    values.single.as_chunks::<8>().0.iter().zip(fluxes[slots.clone()].as_chunks::<8>().0);
                for ((double, value), (single, flux)) in columns.zip(others) {
                    for l in 0..8 {
                        part[l] += double[l] * value[l] + single[l] * flux[l];
                    }
                }
                *sum += part.iter().map(|part| f64::from(*part)).sum::<f64>();
            }
            let mut entries = [0.0_f32; SLOTS];
            let layers = values.single.iter().zip(&values.double).zip(&self.slots.is_value[slots.clone()]);
            for (entry, ((single, double), of_flux)) in entries.iter_mut().zip(layers) {
                *entry = sign * if *of_flux { *single } else { *double };
            }
            let members = &panels.order[slots];
            match &mut self.matrix.off {
                Off::Dense(dense) => {
                    let dense = &mut dense[row * n..(row + 1) * n];
                    for (entry, member) in entries.iter().zip(members) {
                        if let Some(place) = dense.get_mut(*member as usize) {
                            *place = *entry;
                        }
                    }
                }
                Off::Near(near) if near.keeps(row, cluster, reach) => {
                    if let Some(slot) = members.iter().position(|member| *member == row as u32) {
                        entries[slot] = 0.0;
                    }
                    kept.add(number, &entries);
                }
                Off::Near(_) => {}
            }
        }
        // Products without a whole matrix add the mean by themselves.
        let mut mean_here = 0.0;
        match &mut self.matrix.off {
            Off::Dense(dense) => {
                let dense = &mut dense[row * n..(row + 1) * n];
                if let Some(mean) = &self.mean {
                    dense.iter_mut().zip(mean).for_each(|(entry, mean)| *entry += *mean as f32);
                    mean_here = mean[row];
                }
                dense[row] = 0.0;
            }
            Off::Near(near) => near.push(kept).map_err(|error| error.of(row).at(own.centre))?,
        }
        if (whole - 0.5).abs() > CLOSED {
            let message = "the boundary meets itself at this element, or the element lies outside of the body; expected a boundary that does not";
            return Err(LaplaceError::new(Fault::Meeting, message).of(row).at(own.centre));
        }
        self.closure = self.closure.max((whole - 0.5).abs());
        let diagonal = if is_value { panels.space.layers(own, own.centre).single } else { whole };
        self.matrix.diagonal.push(diagonal + mean_here);
        for (material, (side, sum)) in self.sides.iter_mut().zip(sums).enumerate() {
            // For a panel with a given value the flux has its own layer on the left; its value times the row's sum is on the right.
            side.push(if is_value { self.given.data[material][row] * whole - sum } else { sum });
        }
        self.row += 1;
        Ok(())
    }
}
