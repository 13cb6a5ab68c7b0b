//! Panels in clusters of neighbours, and the values of their layers at a point.

use super::cloud::{Cloud, Values};
use super::panel::{Panel, Space};
use glam::DVec3;
use std::ops::Range;

/// Panels of a cluster; the last one may have fewer.
pub(super) const SLOTS: usize = 32;

/// A slot without a panel.
pub(super) const NOBODY: u32 = u32::MAX;

/// Diameters of a panel from its centre within which its integrals are exact. Clusters that come so near by the largest of their panels are looked at panel
/// by panel, so that it does not depend on the clusters whose integrals are exact.
const EXACT: f64 = 2.5;
/// Diameters beyond which one place stands for a panel.
const FAR: f64 = 8.0;

/// Share of the radius of a cluster below which diameters do not count as less: single precision, in which places are kept, tells apart what is farther.
const FINE: f64 = 4e-5;

/// Neighbouring panels.
#[derive(Debug, Clone)]
pub(super) struct Cluster {
    /// Their slots.
    pub(super) slots: Range<usize>,
    pub(super) centre: DVec3,
    /// All of them are within this distance of the centre.
    pub(super) radius: f64,
    /// Of the largest panel; at least a small share of the radius.
    pub(super) diameter: f64,
}

/// How panels are taken at a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Reach {
    /// One by one.
    Near,
    /// By a rule of two or three places each.
    Medium,
    /// By one place each.
    Far,
}

/// How panels up to this diameter are taken at this distance.
#[inline(always)]
pub(super) fn reach(diameter: f64, distance: f64) -> Reach {
    if distance <= EXACT * diameter {
        Reach::Near
    } else if distance <= FAR * diameter {
        Reach::Medium
    } else {
        Reach::Far
    }
}

/// Panels with their clusters.
#[derive(Debug, Clone)]
pub(super) struct Panels {
    pub(super) space: Space,
    pub(super) list: Vec<Panel>,
    /// The panel in each slot.
    pub(super) order: Vec<u32>,
    pub(super) clusters: Vec<Cluster>,
    /// A place for each slot.
    pub(super) centres: Cloud,
    /// Two or three places for each slot.
    pub(super) places: Vec<Cloud>,
}

impl Panels {
    pub(super) fn new(space: Space, list: Vec<Panel>) -> Self {
        let mut all: Vec<u32> = (0..list.len() as u32).collect();
        halve(&mut all, &list);
        let mut panels = Self {
            space,
            order: Vec::with_capacity(all.len() + SLOTS),
            clusters: Vec::new(),
            centres: Cloud::default(),
            places: vec![Cloud::default(); space.places()],
            list,
        };
        for members in all.chunks(SLOTS) {
            panels.push(members);
        }
        panels
    }

    fn push(&mut self, members: &[u32]) {
        let own = || members.iter().map(|n| &self.list[*n as usize]);
        let corners = || own().flat_map(|panel| panel.corners);
        let low = corners().fold(DVec3::INFINITY, DVec3::min);
        let high = corners().fold(DVec3::NEG_INFINITY, DVec3::max);
        let centre = (low + high) / 2.0;
        let radius = corners().map(|corner| corner.distance(centre)).fold(0.0, f64::max);
        let diameter = own().map(|panel| panel.diameter).fold(FINE * radius, f64::max);
        let start = self.order.len();
        self.clusters.push(Cluster { slots: start..start + SLOTS, centre, radius, diameter });
        for slot in 0..SLOTS {
            let panel = members.get(slot).map(|n| self.list[*n as usize]);
            self.order.push(members.get(slot).copied().unwrap_or(NOBODY));
            // An empty slot weighs nothing, wherever it is.
            let shown = panel.unwrap_or(self.list[members[0] as usize]);
            let size = panel.map_or(0.0, |panel| panel.size);
            self.centres.push(self.space, shown.centre - centre, shown.normal, size);
            let count = self.places.len();
            for (number, cloud) in self.places.iter_mut().enumerate() {
                let place = self.space.place(&shown, number) - centre;
                cloud.push(self.space, place, shown.normal, size / count as f64);
            }
        }
    }

    /// The corners of the box of all panels.
    pub(super) fn bounds(&self) -> (DVec3, DVec3) {
        let corners = || self.list.iter().flat_map(|panel| panel.corners);
        (corners().fold(DVec3::INFINITY, DVec3::min), corners().fold(DVec3::NEG_INFINITY, DVec3::max))
    }

    /// How the panels of a cluster are taken at a point.
    #[inline(always)]
    pub(super) fn reach(cluster: &Cluster, x: DVec3) -> Reach {
        reach(cluster.diameter, x.distance(cluster.centre) - cluster.radius)
    }

    /// The layers of the panels of a cluster at a point, and how they were taken.
    #[inline(always)]
    pub(super) fn layers(&self, cluster: &Cluster, x: DVec3, values: &mut Values) -> Reach {
        *values = Values::default();
        let own = (x - cluster.centre).as_vec3();
        let reach = Self::reach(cluster, x);
        if reach == Reach::Far {
            self.centres.add(self.space, &cluster.slots, own, values);
            return reach;
        }
        for cloud in &self.places {
            cloud.add(self.space, &cluster.slots, own, values);
        }
        if reach == Reach::Near {
            self.correct(cluster, x, values);
        }
        reach
    }

    /// Puts exact values in place of those of panels that are near.
    #[inline(never)]
    fn correct(&self, cluster: &Cluster, x: DVec3, values: &mut Values) {
        for (slot, number) in self.order[cluster.slots.clone()].iter().enumerate() {
            let Some(panel) = self.list.get(*number as usize) else { continue };
            let reach = EXACT * panel.diameter.max(FINE * cluster.radius);
            if panel.centre.distance_squared(x) <= reach * reach {
                let exact = self.space.layers(panel, x);
                values.single[slot] = exact.single as f32;
                values.double[slot] = exact.double as f32;
            }
        }
    }
}

/// Sorts panels so that every run of [`SLOTS`] of them is of neighbours: halves along the longest side of the box of their centres, again and again.
fn halve(members: &mut [u32], list: &[Panel]) {
    if members.len() <= SLOTS {
        return;
    }
    let centre = |n: u32| list[n as usize].centre;
    let low = members.iter().fold(DVec3::INFINITY, |low, n| low.min(centre(*n)));
    let high = members.iter().fold(DVec3::NEG_INFINITY, |high, n| high.max(centre(*n)));
    let size = high - low;
    let axis = if size.x >= size.y.max(size.z) {
        DVec3::X
    } else if size.y >= size.z {
        DVec3::Y
    } else {
        DVec3::Z
    };
    let half = members.len().div_ceil(SLOTS).div_ceil(2) * SLOTS;
    let by = |a: &u32, b: &u32| centre(*a).dot(axis).total_cmp(&centre(*b).dot(axis)).then(a.cmp(b));
    members.select_nth_unstable_by(half, by);
    let (first, second) = members.split_at_mut(half);
    halve(first, list);
    halve(second, list);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laplace::samples;

    #[test]
    fn every_panel_has_one_slot_and_its_layers_are_those_of_the_panel() {
        for mesh in [samples::cube(8), samples::annulus(0.4, 1.0, 192)] {
            let panels = Panels::new(mesh.space(), mesh.panels());
            let mut found: Vec<u32> = panels.order.iter().copied().filter(|n| *n != NOBODY).collect();
            found.sort_unstable();
            assert_eq!(found, (0..panels.list.len() as u32).collect::<Vec<_>>());
            let x = DVec3::new(0.78, 0.41, if mesh.space() == Space::Solid { 0.9 } else { 0.0 });
            let mut kinds = Vec::new();
            for cluster in &panels.clusters {
                let mut values = Values::default();
                kinds.push(panels.layers(cluster, x, &mut values));
                for (slot, number) in panels.order[cluster.slots.clone()].iter().enumerate() {
                    let (single, double) = (f64::from(values.single[slot]), f64::from(values.double[slot]));
                    let Some(panel) = panels.list.get(*number as usize) else {
                        assert_eq!([single, double], [0.0; 2]);
                        continue;
                    };
                    let exact = panels.space.layers(panel, x);
                    let scale = panels.list[*number as usize].size;
                    assert!((single - exact.single).abs() < 2e-3 * scale, "{single} {exact:?}");
                    assert!((double - exact.double).abs() < 2e-2 * scale, "{double} {exact:?}");
                }
            }
            assert!(kinds.contains(&Reach::Near) && kinds.contains(&Reach::Medium));
        }
    }
}
