//! Points with weights that stand for panels far away, in columns of single precision for vector units.
//!
//! Places are kept relative to the centre of their cluster, so that small panels lose nothing.

use super::cluster::SLOTS;
use super::panel::Space;
use super::single::{LANES, inverse_root, ln};
use glam::{DVec3, Vec3};
use std::f64::consts::{PI, TAU};
use std::ops::Range;

/// Least squared distance: places on the point itself, whose values are never used, must not divide by 0.
const LEAST: f32 = 1e-24;

/// One place for each slot.
#[derive(Debug, Clone, Default)]
pub(super) struct Cloud {
    x: Vec<f32>,
    y: Vec<f32>,
    z: Vec<f32>,
    weight: Vec<f32>,
    /// Normals times weights.
    dipoles: [Vec<f32>; 3],
}

/// Values of the layers of each slot of a cluster.
#[derive(Debug, Clone, Copy)]
#[repr(align(32))]
pub(super) struct Values {
    pub(super) single: [f32; SLOTS],
    pub(super) double: [f32; SLOTS],
}

impl Default for Values {
    fn default() -> Self {
        Self { single: [0.0; SLOTS], double: [0.0; SLOTS] }
    }
}

/// How much of each layer the slots carry.
#[derive(Debug, Clone, Default)]
pub(super) struct Charges {
    pub(super) single: Vec<f32>,
    /// Empty where there are none.
    pub(super) double: Vec<f32>,
}

/// Sums that are worked on together.
pub(super) type Sums = [f32; LANES];

impl Values {
    /// The sum of the double layers.
    #[inline(always)]
    pub(super) fn double_sum(&self) -> f64 {
        let mut sums = [0.0_f32; LANES];
        for part in self.double.as_chunks::<LANES>().0 {
            for l in 0..LANES {
                sums[l] += part[l];
            }
        }
        sums.iter().map(|sum| f64::from(*sum)).sum()
    }
}

impl Cloud {
    /// Adds a place relative to its cluster that stands for a panel, or for a part of it, of this size.
    pub(super) fn push(&mut self, space: Space, place: DVec3, normal: DVec3, size: f64) {
        let place = place.as_vec3();
        let weight = match space {
            Space::Plane => size / TAU,
            Space::Solid => size / (4.0 * PI),
        };
        self.x.push(place.x);
        self.y.push(place.y);
        self.z.push(place.z);
        self.weight.push(weight as f32);
        for (column, part) in self.dipoles.iter_mut().zip((normal * weight).to_array()) {
            column.push(part as f32);
        }
    }

    /// Adds the layers of the slots of a cluster at a point relative to its centre.
    #[inline(always)]
    pub(super) fn add(&self, space: Space, slots: &Range<usize>, x: Vec3, values: &mut Values) {
        match space {
            Space::Plane => self.add_by::<false>(slots, x, values),
            Space::Solid => self.add_by::<true>(slots, x, values),
        }
    }

    #[inline(always)]
    fn add_by<const SOLID: bool>(&self, slots: &Range<usize>, x: Vec3, values: &mut Values) {
        let [xs, ys, zs, weights] =
            [&self.x, &self.y, &self.z, &self.weight].map(|column| lanes(column, slots));
        let [ps, qs, rs] = self.dipoles.each_ref().map(|column| lanes(column, slots));
        let singles = values.single.as_chunks_mut::<LANES>().0;
        let doubles = values.double.as_chunks_mut::<LANES>().0;
        for k in 0..SLOTS / LANES {
            for l in 0..LANES {
                let (dx, dy) = (xs[k][l] - x.x, ys[k][l] - x.y);
                let dz = if SOLID { zs[k][l] - x.z } else { 0.0 };
                let square = (dx * dx + dy * dy + dz * dz).max(LEAST);
                let across = dx * ps[k][l] + dy * qs[k][l] + dz * rs[k][l];
                if SOLID {
                    let near = 1.0 / square.sqrt();
                    singles[k][l] += weights[k][l] * near;
                    doubles[k][l] += across * near * near * near;
                } else {
                    singles[k][l] -= 0.5 * weights[k][l] * ln(square);
                    doubles[k][l] += across / square;
                }
            }
        }
    }

    /// Adds charges times layers of the slots of a cluster at a point relative to its centre to sums, whose own sum counts.
    #[inline(always)]
    pub(super) fn sum(
        &self,
        space: Space,
        slots: &Range<usize>,
        x: Vec3,
        charges: &Charges,
        sums: &mut Sums,
    ) {
        match (space, charges.double.is_empty()) {
            (Space::Plane, _) => {
                let mut values = Values::default();
                self.add(space, slots, x, &mut values);
                let double = (!charges.double.is_empty()).then(|| &charges.double[slots.clone()]);
                sums[0] += sum_of(&values, &charges.single[slots.clone()], double) as f32;
            }
            (Space::Solid, true) => self.sum_singles(slots, x, charges, sums),
            (Space::Solid, false) => self.sum_both(slots, x, charges, sums),
        }
    }

    #[inline(always)]
    fn sum_singles(&self, slots: &Range<usize>, x: Vec3, charges: &Charges, sums: &mut Sums) {
        let [xs, ys, zs, weights] =
            [&self.x, &self.y, &self.z, &self.weight].map(|column| lanes(column, slots));
        let charges = lanes(&charges.single, slots);
        for k in 0..SLOTS / LANES {
            for l in 0..LANES {
                let (dx, dy, dz) = (xs[k][l] - x.x, ys[k][l] - x.y, zs[k][l] - x.z);
                let square = (dx * dx + dy * dy + dz * dz).max(LEAST);
                sums[l] += weights[k][l] * charges[k][l] * inverse_root(square);
            }
        }
    }

    #[inline(always)]
    fn sum_both(&self, slots: &Range<usize>, x: Vec3, charges: &Charges, sums: &mut Sums) {
        let [xs, ys, zs, weights] =
            [&self.x, &self.y, &self.z, &self.weight].map(|column| lanes(column, slots));
        let [ps, qs, rs] = self.dipoles.each_ref().map(|column| lanes(column, slots));
        let (singles, doubles) = (lanes(&charges.single, slots), lanes(&charges.double, slots));
        for k in 0..SLOTS / LANES {
            for l in 0..LANES {
                let (dx, dy, dz) = (xs[k][l] - x.x, ys[k][l] - x.y, zs[k][l] - x.z);
                let square = (dx * dx + dy * dy + dz * dz).max(LEAST);
                let near = inverse_root(square);
                let across = dx * ps[k][l] + dy * qs[k][l] + dz * rs[k][l];
                sums[l] += near * (weights[k][l] * singles[k][l] + doubles[k][l] * across * near * near);
            }
        }
    }
}

/// The sum over the slots of a cluster of charges times layers that are there.
#[inline(always)]
pub(super) fn sum_of(values: &Values, single: &[f32], double: Option<&[f32]>) -> f64 {
    let mut sums = [0.0_f32; LANES];
    let mut add = |values: &[f32; SLOTS], charges: &[f32]| {
        for (values, charges) in values.as_chunks::<LANES>().0.iter().zip(charges.as_chunks::<LANES>().0) {
            for l in 0..LANES {
                sums[l] += values[l] * charges[l];
            }
        }
    };
    add(&values.single, single);
    if let Some(double) = double {
        add(&values.double, double);
    }
    sums.iter().map(|sum| f64::from(*sum)).sum()
}

#[inline(always)]
fn lanes<'a>(column: &'a [f32], slots: &Range<usize>) -> &'a [[f32; LANES]] {
    column[slots.clone()].as_chunks::<LANES>().0
}
