//! What clusters do far away, as multipoles: the first terms of the expansion of 1/r about their centres.
//!
//! With u the direction from the centre to the point, R the distance, a the radius of the cluster and y a place in units of it, 1/r is the sum of
//! a^l P_l(u, y) / R^(l + 1), where P_l is |y|^l times Legendre's polynomial of the cosine between both. As a form of degree l in u it has 1, 3, 6 and 10
//! coefficients up to l = 3, which are added up over the places of the cluster. The double layer is the derivative against the normal, of every coefficient.

use super::cloud::Charges;
use super::cluster::{Cluster, NOBODY, Panels, Reach, SLOTS, reach};
use super::single::{LANES, inverse_root};
use glam::{DVec3, Vec3};
use std::f64::consts::PI;

/// Coefficients up to the third degree.
const TERMS: usize = 20;

/// Radii of a cluster from its centre beyond which it is expanded. What is left out falls with the fourth power of this; of a product with the matrix it is
/// some millionths, because few clusters are hardly farther than that, and charges are seldom all at the rim.
const BEYOND: f64 = 5.0;

/// Coefficients of a cluster.
pub(super) type Moments = [f32; TERMS];

/// For each slot the coefficients of its panel when it carries 1.
#[derive(Debug, Clone, Default)]
pub(super) struct Expansions {
    singles: Vec<Moments>,
    doubles: Vec<Moments>,
}

/// Points of one cluster that are worked on together.
#[derive(Debug, Clone, Copy)]
pub(super) struct Targets {
    /// The centre of their cluster, and the points relative to it.
    centre: DVec3,
    offsets: [[f32; LANES]; 3],
}

/// Whether a cluster is so far from all points of another that it may be expanded.
pub(super) fn is_beyond(home: &Cluster, cluster: &Cluster) -> bool {
    let distance = home.centre.distance(cluster.centre) - home.radius;
    distance > BEYOND * cluster.radius && reach(cluster.diameter, distance - cluster.radius) != Reach::Near
}

impl Targets {
    pub(super) fn new(own: &Cluster, points: [DVec3; LANES]) -> Self {
        let offsets = points.map(|point| (point - own.centre).as_vec3());
        Self {
            centre: own.centre,
            offsets: [offsets.map(|o| o.x), offsets.map(|o| o.y), offsets.map(|o| o.z)],
        }
    }

    /// Adds what an expanded cluster does at each of them.
    #[inline(always)]
    pub(super) fn add(&self, cluster: &Cluster, moments: &Moments, sums: &mut [f32; LANES]) {
        let way: Vec3 = (self.centre - cluster.centre).as_vec3();
        let radius = cluster.radius as f32;
        let m = moments;
        for (l, sum) in sums.iter_mut().enumerate() {
            let (x, y, z) =
                (way.x + self.offsets[0][l], way.y + self.offsets[1][l], way.z + self.offsets[2][l]);
            let near = inverse_root(x * x + y * y + z * z);
            let (x, y, z, share) = (x * near, y * near, z * near, radius * near);
            let first = m[1] * x + m[2] * y + m[3] * z;
            let second = x * (m[4] * x + m[5] * y + m[6] * z) + y * (m[7] * y + m[8] * z) + m[9] * z * z;
            let third = x
                * (x * (m[10] * x + m[11] * y + m[12] * z) + y * (m[13] * y + m[14] * z) + m[15] * z * z)
                + y * (y * (m[16] * y + m[17] * z) + m[18] * z * z)
                + m[19] * z * z * z;
            *sum += near * (m[0] + share * (first + share * (second + share * third)));
        }
    }
}

impl Expansions {
    /// Adds the slots of the next cluster; returns whether there was one.
    pub(super) fn push(&mut self, panels: &Panels) -> bool {
        let Some(cluster) = panels.clusters.get(self.singles.len() / SLOTS) else { return false };
        for number in &panels.order[cluster.slots.clone()] {
            let Some(panel) = panels.list.get(*number as usize) else {
                debug_assert_eq!(*number, NOBODY);
                self.singles.push([0.0; TERMS]);
                self.doubles.push([0.0; TERMS]);
                continue;
            };
            let count = panels.space.places();
            let weight = panel.size / (4.0 * PI * count as f64);
            let (mut single, mut double) = ([0.0; TERMS], [0.0; TERMS]);
            for place in 0..count {
                let y = (panels.space.place(panel, place) - cluster.centre) / cluster.radius;
                let at = |step: f64| terms(y - panel.normal * step);
                let (here, steps) = (at(0.0), [at(1.0), at(-1.0), at(2.0), at(-2.0)]);
                for term in 0..TERMS {
                    let [up, down, far_up, far_down] = steps.map(|terms| terms[term]);
                    single[term] += weight * here[term];
                    // Differences over five places are exact for these polynomials.
                    let slope = (8.0 * (up - down) - (far_up - far_down)) / 12.0;
                    double[term] += weight / cluster.radius * slope;
                }
            }
            self.singles.push(single.map(|x| x as f32));
            self.doubles.push(double.map(|x| x as f32));
        }
        true
    }

    /// The coefficients of each cluster when its slots carry these charges.
    pub(super) fn moments(&self, panels: &Panels, charges: &Charges) -> Vec<Moments> {
        let of = |cluster: &Cluster| {
            let mut sums = [0.0_f32; TERMS];
            let mut add = |charges: &[f32], slots: &[Moments]| {
                for (charge, terms) in charges.iter().zip(slots) {
                    sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += charge * term);
                }
            };
            add(&charges.single[cluster.slots.clone()], &self.singles[cluster.slots.clone()]);
            if !charges.double.is_empty() {
                add(&charges.double[cluster.slots.clone()], &self.doubles[cluster.slots.clone()]);
            }
            sums
        };
        panels.clusters.iter().map(of).collect()
    }
}

/// The coefficients of the forms P_0 to P_3 for a place. Those of P_2 and P_3 that multiply |u|^2 = 1 are written out in the same degree.
fn terms(place: DVec3) -> [f64; TERMS] {
    let DVec3 { x, y, z } = place;
    let square = place.length_squared();
    let (half, more) = (0.5 * square, 1.5 * square);
    [
        1.0,
        x,
        y,
        z,
        1.5 * x * x - half,
        3.0 * x * y,
        3.0 * x * z,
        1.5 * y * y - half,
        3.0 * y * z,
        1.5 * z * z - half,
        x * (2.5 * x * x - more),
        y * (7.5 * x * x - more),
        z * (7.5 * x * x - more),
        x * (7.5 * y * y - more),
        15.0 * x * y * z,
        x * (7.5 * z * z - more),
        y * (2.5 * y * y - more),
        z * (7.5 * y * y - more),
        y * (7.5 * z * z - more),
        z * (2.5 * z * z - more),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laplace::samples;

    #[test]
    fn far_away_an_expansion_is_what_it_stands_for_and_closer_by_it_errs_with_the_fourth_power() {
        let mesh = samples::sphere(1.0, 3);
        let panels = Panels::new(mesh.space(), mesh.panels());
        let charge = |k: usize| if panels.order[k] == NOBODY { 0.0 } else { 1.0 + (k as f32).cos() };
        let list: Vec<f32> = (0..panels.order.len()).map(charge).collect();
        let zeros = vec![0.0; list.len()];
        let mut expansions = Expansions::default();
        while expansions.push(&panels) {}
        let cluster = &panels.clusters[7];
        for (name, single, double) in [("single", &list, &zeros), ("double", &zeros, &list)] {
            let charges = Charges { single: single.clone(), double: double.clone() };
            let moments = expansions.moments(&panels, &charges)[7];
            // Of the sum over places, relative to what the places do without signs.
            let error = |radii: f64| {
                let x = cluster.centre + DVec3::new(0.6, -0.64, 0.48) * (radii * cluster.radius);
                let (mut sum, mut whole) = (0.0, 0.0);
                for slot in cluster.slots.clone() {
                    let panel = &panels.list[panels.order[slot] as usize];
                    for place in 0..3 {
                        let way = panels.space.place(panel, place) - x;
                        let weight = panel.size / (12.0 * PI * way.length());
                        let across = way.dot(panel.normal) / way.length_squared();
                        let part = weight * (f64::from(single[slot]) + f64::from(double[slot]) * across);
                        sum += part;
                        whole += part.abs();
                    }
                }
                let targets = Targets::new(cluster, [x; LANES]);
                let mut sums = [0.0; LANES];
                targets.add(cluster, &moments, &mut sums);
                (f64::from(sums[3]) - sum).abs() / whole
            };
            assert!(error(BEYOND) < 1e-3, "{name}: {}", error(BEYOND));
            let order = (error(BEYOND) / error(4.0 * BEYOND)).ln() / 4.0_f64.ln();
            assert!(order > 3.5, "{name}: of order {order}");
        }
        assert!(!is_beyond(cluster, cluster));
    }
}
