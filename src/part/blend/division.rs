//! The boundary of a body in elements: shorter where it bends, and where another part of it is near.

use super::job::{BlendFault, BlendFaultKind};
use super::ring::Ring;
use super::{BlendPlan, On};
use crate::geom::{first_contact, first_self_contact};
use crate::laplace::Mesh;
use crate::part::{Region, Shape};
use glam::DVec2;

/// Places of the whole boundary at which is looked whether it lies on a shape, and how dense its elements are to be.
const LOOKS: f64 = 1024.0;
/// Share of the size of the body within which its boundary lies on a shape.
const ON: f64 = 1e-4;
/// Share of the size of the body within which two places at which elements end are one.
const ONE: f64 = 1e-3;
/// Most segments of a shape whose ends are looked for on the boundary.
const FEW: usize = 16;
/// What a full turn weighs against the whole length of the boundary.
const BEND: f64 = 0.5;
/// What a stretch weighs whose distance to another part of the boundary is its length.
const NARROW: f64 = 0.05;
/// Places of a hole that tell whether it takes anything away.
const SAMPLES: u32 = 64;
/// Share of the length of the boundary below which such a distance does not count as less.
const NARROWEST: f64 = 1e-3;

/// An element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Element {
    /// Its middle on the boundary itself.
    pub(super) middle: DVec2,
    /// The piece of the plan that it is in.
    pub(super) edge: Option<usize>,
}

/// Rings being divided.
#[derive(Debug)]
pub(super) struct Division {
    /// Of each ring of the region the curve; `None` of a hole that takes nothing away.
    rings: Vec<Option<Ring>>,
    shapes: Vec<Shape>,
    size: f64,
    length: f64,
    /// Of each ring the places at which elements end, besides its corners.
    breaks: Vec<Vec<f64>>,
}

type Made<T> = Result<T, BlendFault>;

impl Division {
    pub(super) fn new(region: &Region, plan: &BlendPlan) -> Made<Self> {
        let shapes: Vec<Shape> = region.rings().cloned().collect();
        let mut rings = Vec::with_capacity(shapes.len());
        for (number, shape) in shapes.iter().enumerate() {
            let ring = Ring::new(shape, number > 0).ok_or_else(|| {
                BlendFault::new(BlendFaultKind::Apart, "a part of the boundary encloses no area")
            })?;
            let lies = |is_so: &dyn Fn(DVec2) -> bool| {
                (0..SAMPLES).all(|k| is_so(ring.at(ring.length() * f64::from(k) / f64::from(SAMPLES))))
            };
            let others = shapes.iter().enumerate().skip(1).filter(|(other, _)| *other != number);
            // Of holes that are alike the first one counts.
            let is_idle = number > 0
                && (lies(&|point| !shapes[0].contains(point))
                    || others.into_iter().any(|(other, hole)| {
                        (hole == shape && other < number) || lies(&|point| hole.contains(point))
                    }));
            rings.push((!is_idle).then_some(ring));
        }
        let length = rings.iter().flatten().map(Ring::length).sum();
        let corners: usize = rings.iter().flatten().map(|ring| ring.corners().len().max(1)).sum();
        if corners > plan.elements {
            let message = format!(
                "the boundary has {corners} corners; expected {} at most, the number of elements",
                plan.elements
            );
            return Err(BlendFault::new(BlendFaultKind::Limit, message));
        }
        let breaks = vec![Vec::new(); rings.len()];
        Ok(Self { rings, shapes, size: region.bounds().diagonal(), length, breaks })
    }

    /// Whether a point of the boundary is in a piece of it.
    fn is_on(&self, on: &On, ring: usize, point: DVec2) -> bool {
        match on {
            On::Ring(number) => *number == ring,
            On::Near(shape, within) => shape.distance(point) <= within.max(ON * self.size),
        }
    }

    /// Finds where a piece of the plan begins and ends.
    pub(super) fn mark(&mut self, plan: &BlendPlan, edge: usize) -> Made<()> {
        let on = &plan.edges[edge].on;
        let mut is_somewhere = false;
        for number in 0..self.rings.len() {
            let Some(ring) = &self.rings[number] else { continue };
            if let On::Ring(own) = on {
                is_somewhere |= *own == number;
                continue;
            }
            let mut found = Vec::new();
            let places = self.places(ring, on);
            let is_member = |place: f64| self.is_on(on, number, ring.at(place));
            let members: Vec<bool> = places.iter().map(|place| is_member(*place)).collect();
            is_somewhere |= members.contains(&true);
            for k in 1..places.len() {
                if members[k - 1] == members[k] {
                    continue;
                }
                let (mut low, mut high) = (places[k - 1], places[k]);
                for _ in 0..48 {
                    let middle = (low + high) / 2.0;
                    if is_member(middle) == members[k - 1] { low = middle } else { high = middle }
                }
                found.push(high);
            }
            let length = ring.length();
            let own = &mut self.breaks[number];
            for place in found {
                let apart = |other: &f64| {
                    let along = (place - other).abs();
                    along.min(length - along) > ONE * self.size
                };
                if own.iter().all(apart) && ring.corners().iter().all(apart) && apart(&0.0) {
                    own.push(place);
                }
            }
        }
        if is_somewhere {
            return Ok(());
        }
        let fault =
            BlendFault::new(BlendFaultKind::Nothing, "no part of the boundary of the body lies there");
        Err(fault.of(edge))
    }

    /// Where on a ring is looked: at its corners, evenly in between, and where ends of a shape are near.
    fn places(&self, ring: &Ring, on: &On) -> Vec<f64> {
        let length = ring.length();
        let count = (LOOKS * length / self.length).ceil().max(16.0);
        let mut places: Vec<f64> = (0..=count as usize).map(|k| length * k as f64 / count).collect();
        places.extend(ring.corners());
        if let On::Near(shape, _) = on {
            match shape {
                Shape::Point(at) => places.push(ring.nearest(*at)),
                Shape::Open(path) | Shape::Closed(path) if path.ends().len() <= FEW => {
                    places.extend(path.ends().flat_map(|(start, end)| {
                        [start, (start + end) / 2.0, end].map(|point| ring.nearest(point))
                    }));
                }
                _ => {}
            }
        }
        places.sort_unstable_by(f64::total_cmp);
        places.dedup();
        places
    }

    /// The boundary in elements, once all pieces are marked.
    pub(super) fn divide(&self, plan: &BlendPlan) -> Made<(Mesh, Vec<Element>)> {
        let mut stretches = Vec::new();
        for (number, ring) in self.rings.iter().enumerate() {
            let Some(ring) = ring else { continue };
            let mut ends: Vec<f64> = [0.0, ring.length()].into_iter().collect();
            ends.extend(ring.corners().iter().chain(&self.breaks[number]));
            ends.sort_unstable_by(f64::total_cmp);
            ends.dedup();
            for pair in ends.windows(2) {
                stretches.push((number, ring, self.weights(number, ring, pair[0], pair[1])));
            }
        }
        let whole: f64 = stretches.iter().map(|(_, _, (_, sums))| sums.last().copied().unwrap_or(0.0)).sum();
        let least = if 2 * stretches.len() <= plan.elements { 2.0 } else { 1.0 };
        let (mut vertices, mut segments, mut elements) = (Vec::<DVec2>::new(), Vec::new(), Vec::new());
        let mut starts = vec![0];
        for (index, (number, ring, (places, sums))) in stretches.iter().enumerate() {
            let last = sums.last().copied().unwrap_or(0.0);
            let count = (plan.elements as f64 * last / whole).round().max(least) as usize;
            let edge = self.edge(plan, *number, ring.at(place_at(places, sums, last / 2.0)))?;
            for k in 0..count {
                let place = |share: f64| place_at(places, sums, last * share / count as f64);
                vertices.push(ring.at(place(k as f64)));
                elements.push(Element { middle: ring.at(place(k as f64 + 0.5)), edge });
            }
            if stretches.get(index + 1).is_none_or(|(next, ..)| next != number) {
                let first = starts.last().copied().unwrap_or(0);
                let end = vertices.len();
                segments.extend(
                    (first..end).map(|k| [k as u32, if k + 1 == end { first as u32 } else { k as u32 + 1 }]),
                );
                starts.push(end);
            }
        }
        let chains: Vec<&[DVec2]> = starts.windows(2).map(|pair| &vertices[pair[0]..pair[1]]).collect();
        for (k, chain) in chains.iter().enumerate() {
            let meeting =
                |at: DVec2, message: &str| Err(BlendFault::new(BlendFaultKind::Apart, message).at(at));
            if chain.len() < 3 {
                return meeting(
                    chain[0],
                    "a part of the boundary has too few elements; expected more in all",
                );
            }
            if let Some((at, _)) = first_self_contact(chain, true) {
                let message = "the elements are too long to follow the boundary here; expected more in all";
                return meeting(chain[at], message);
            }
            for other in &chains[..k] {
                if let Some((at, _)) = first_contact(chain, other, true) {
                    let message = "two parts of the boundary meet here, or are too near for so few elements; expected holes inside the outline and apart from each other";
                    return meeting(chain[at], message);
                }
            }
        }
        let mesh = Mesh::plane(&vertices, &segments).map_err(|error| BlendFault::of_solver(&error))?;
        Ok((mesh, elements))
    }

    /// Places along a stretch, and the weight of it up to each.
    fn weights(&self, number: usize, ring: &Ring, from: f64, to: f64) -> (Vec<f64>, Vec<f64>) {
        let count = (LOOKS * (to - from) / self.length).ceil().max(8.0);
        let (mut places, mut sums) = (vec![from], vec![0.0]);
        let mut sum = 0.0;
        for k in 1..=count as usize {
            let (before, place) = (places[k - 1], from + (to - from) * k as f64 / count);
            let length = (place - before) / self.length;
            let middle = ring.at((before + place) / 2.0);
            let others = self.shapes.iter().enumerate();
            let others = others.filter(|(other, _)| *other != number && self.rings[*other].is_some());
            let gap = others.map(|(_, shape)| shape.distance(middle)).fold(f64::INFINITY, f64::min);
            let gap = (gap / self.length).max(NARROWEST);
            sum += length + BEND * ring.turn(before, place) / std::f64::consts::TAU + NARROW * length / gap;
            places.push(place);
            sums.push(sum);
        }
        (places, sums)
    }

    /// The piece of the plan that a point of a ring is in: one near a shape, else one of the ring as a whole.
    fn edge(&self, plan: &BlendPlan, ring: usize, point: DVec2) -> Made<Option<usize>> {
        let mut found: [Option<usize>; 2] = [None; 2];
        for (number, edge) in plan.edges.iter().enumerate() {
            if !self.is_on(&edge.on, ring, point) {
                continue;
            }
            let own = &mut found[usize::from(matches!(edge.on, On::Ring(_)))];
            match own {
                Some(other) if plan.edges[*other].condition != edge.condition => {
                    let message = format!("boundaries[{other}] has another condition for the same place");
                    return Err(BlendFault::new(BlendFaultKind::Conflict, message).of(number).at(point));
                }
                Some(_) => {}
                None => *own = Some(number),
            }
        }
        Ok(found[0].or(found[1]))
    }
}

/// The place up to which a stretch has a weight.
fn place_at(places: &[f64], sums: &[f64], weight: f64) -> f64 {
    let k = sums.partition_point(|sum| *sum <= weight).clamp(1, sums.len() - 1);
    let share = (weight - sums[k - 1]) / (sums[k] - sums[k - 1]);
    places[k - 1] + share.clamp(0.0, 1.0) * (places[k] - places[k - 1])
}
