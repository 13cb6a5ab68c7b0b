//! Surfaces that are remembered, so that only what an edit changed is made anew.

use super::paint::{Outliner, Painter};
use super::{Boundary, Held, KnownBody, Painted, Stretch};
use crate::hyperpatch::composite::{Body, CellId, Sharing};
use crate::hyperpatch::{Corner, Face, Tessellation};
use std::collections::{HashSet, VecDeque};
use std::rc::Rc;

/// Surfaces that are kept: of an edit that is given up the one before is still wanted.
const KEPT: usize = 3;

/// The boundary of a body in triangles.
#[derive(Debug)]
pub struct KnownSurface {
    /// Its number, which no other surface has.
    pub id: u32,
    /// The triangles.
    pub painted: Painted,
    /// Its curves and corners.
    pub boundary: Boundary,
    body: Held,
    sharing: Rc<Sharing>,
    /// The tolerance that was asked for.
    tolerance: Option<f64>,
}

/// What of a surface differs from an earlier one, whose vertices, triangles and curves have the same places.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Renewal {
    /// The earlier surface.
    pub since: u32,
    /// Numbers of the stretches that were made anew.
    pub stretches: Vec<usize>,
    /// Numbers of the curves with other points.
    pub edges: Vec<usize>,
    /// Numbers of the corners that moved.
    pub corners: Vec<usize>,
}

/// The surfaces that were made last.
#[derive(Debug, Default)]
pub(super) struct Surfaces {
    count: u32,
    kept: VecDeque<Rc<KnownSurface>>,
}

impl Surfaces {
    fn find(&self, id: u32) -> Option<Rc<KnownSurface>> {
        self.kept.iter().find(|surface| surface.id == id).cloned()
    }

    /// Remembers a surface under a number of its own.
    pub(super) fn keep(
        &mut self,
        known: &KnownBody,
        (painted, boundary): (Painted, Boundary),
        tolerance: Option<f64>,
    ) -> Option<Rc<KnownSurface>> {
        let sharing = Rc::clone(known.sharing.get()?);
        self.count += 1;
        let (id, body) = (self.count, known.held());
        let surface = Rc::new(KnownSurface { id, painted, boundary, body, sharing, tolerance });
        self.kept.push_front(Rc::clone(&surface));
        self.kept.truncate(KEPT);
        Some(surface)
    }
}

/// The job that makes a surface of an earlier one.
#[derive(Debug)]
pub(super) struct Resurfacing {
    old: Rc<KnownSurface>,
    stretches: Vec<usize>,
    work: Work,
}

#[derive(Debug)]
enum Work {
    Meshing(Box<Tessellation<Held, Rc<Sharing>>>),
    Painting(Box<Painter>),
}

/// How far a surface that is made of an earlier one is.
#[derive(Debug)]
pub(super) enum Resurfaced {
    /// It is under way.
    Open,
    /// The vertices or triangles have no place in the earlier one: a whole surface has to be made.
    Unlike,
    /// It is done.
    Done(Box<(Painted, Boundary, Renewal)>),
}

impl Resurfacing {
    /// The job for the surface of some faces, or `None` when the earlier one is not known any more, was made to another tolerance, or has other
    /// faces.
    pub(super) fn new(
        known: &KnownBody,
        surfaces: &Surfaces,
        since: u32,
        tolerance: Option<f64>,
        faces: &[(CellId, Face)],
    ) -> Option<Self> {
        let old = surfaces.find(since).filter(|old| old.tolerance == tolerance)?;
        let sharing = known.sharing.get()?;
        let body = known.held();
        let segments: Vec<(CellId, Face, [usize; 4])> = old
            .painted
            .stretches
            .iter()
            .filter_map(|stretch| Some((stretch.cell, stretch.face?, stretch.segments)))
            .collect();
        let is_alike = segments.len() == faces.len()
            && segments.iter().zip(faces).all(|((cell, face, _), other)| (*cell, *face) == *other)
            && old.body.materials() == body.materials();
        if !is_alike {
            return None;
        }
        let renewed = renewed(&old, &body, sharing);
        let stretches: Vec<usize> =
            (0..segments.len()).filter(|n| renewed.contains(&segments[*n].0)).collect();
        let job = Tessellation::held(body, Rc::clone(sharing), &segments, stretches.clone())?;
        Some(Self { old, stretches, work: Work::Meshing(Box::new(job)) })
    }

    /// Share of the work that is done.
    pub(super) fn progress(&self) -> f64 {
        match &self.work {
            Work::Meshing(_) => 0.3,
            Work::Painting(job) => 0.5 + 0.4 * job.progress(),
        }
    }

    /// Advances while `may_go_on` says so.
    pub(super) fn step(&mut self, known: &KnownBody, may_go_on: &mut dyn FnMut() -> bool) -> Resurfaced {
        match &mut self.work {
            Work::Meshing(job) => {
                let Some(surface) = job.step(may_go_on) else { return Resurfaced::Open };
                self.work = Work::Painting(Box::new(Painter::of_faces(known, surface)));
                Resurfaced::Open
            }
            Work::Painting(job) => match job.step(known, may_go_on) {
                None => Resurfaced::Open,
                Some((made, _)) => {
                    self.put(known, &made).map_or(Resurfaced::Unlike, |done| Resurfaced::Done(Box::new(done)))
                }
            },
        }
    }

    /// Puts what was made into the places of the earlier surface.
    fn put(&self, known: &KnownBody, made: &Painted) -> Option<(Painted, Boundary, Renewal)> {
        let old = &self.old;
        let mut painted = old.painted.clone();
        let materials = known.model().materials().len();
        if made.stretches.len() != self.stretches.len() {
            return None;
        }
        for (number, new) in self.stretches.iter().zip(&made.stretches) {
            let place = painted.stretches[*number].clone();
            if (place.vertices.len(), place.triangles.len()) != (new.vertices.len(), new.triangles.len()) {
                return None;
            }
            let (to, from) = (place.vertices.clone(), new.vertices.clone());
            painted.positions[to.clone()].copy_from_slice(&made.positions[from.clone()]);
            painted.normals[to.clone()].copy_from_slice(&made.normals[from.clone()]);
            painted.parameters[to.clone()].copy_from_slice(&made.parameters[from.clone()]);
            let wide = |range: &std::ops::Range<usize>, n: usize| range.start * n..range.end * n;
            painted.fractions[wide(&to, materials)].copy_from_slice(&made.fractions[wide(&from, materials)]);
            painted.colors[wide(&to, 4)].copy_from_slice(&made.colors[wide(&from, 4)]);
            for (to, from) in place.triangles.clone().zip(new.triangles.clone()) {
                let shift = |vertex: u32| vertex - new.vertices.start as u32 + place.vertices.start as u32;
                painted.triangles[to] = made.triangles[from].map(shift);
            }
            painted.stretches[*number] =
                Stretch { vertices: place.vertices, triangles: place.triangles, ..new.clone() };
        }
        painted.deviation = painted.stretches.iter().map(|stretch| stretch.deviation).fold(0.0, f64::max);
        let mut outliner = Outliner::new(Rc::clone(known.sharing.get()?));
        for stretch in &painted.stretches {
            outliner.add(known.model().body(), &painted, stretch);
        }
        let boundary = outliner.boundary;
        let renewal = self.renewal(&boundary)?;
        Some((painted, boundary, renewal))
    }

    /// What differs of the curves and corners, which must be the same ones.
    fn renewal(&self, boundary: &Boundary) -> Option<Renewal> {
        let old = &self.old.boundary;
        let corner = |n: usize| {
            let (cell, corner, users, _) = &boundary.corners[n];
            (*cell, *corner, *users)
        };
        let old_corner = |n: usize| {
            let (cell, corner, users, _) = &old.corners[n];
            (*cell, *corner, *users)
        };
        let is_alike = boundary.edges == old.edges
            && boundary.corners.len() == old.corners.len()
            && (0..old.corners.len()).all(|n| corner(n) == old_corner(n));
        if !is_alike {
            return None;
        }
        let has_moved = |n: &usize| {
            let range = boundary.edges[*n].3.clone();
            boundary.points[range.clone()] != old.points[range]
        };
        let corners = (0..old.corners.len()).filter(|n| boundary.corners[*n].3 != old.corners[*n].3);
        Some(Renewal {
            since: self.old.id,
            stretches: self.stretches.clone(),
            edges: (0..old.edges.len()).filter(has_moved).collect(),
            corners: corners.collect(),
        })
    }
}

/// The cells whose faces are made anew: those that are not the same, and, of those whose shape is not, all cells that have or had a corner in
/// common with them, because points on edges come from the first cell that has the edge.
fn renewed(old: &KnownSurface, body: &Body, sharing: &Sharing) -> HashSet<CellId> {
    let mut renewed = HashSet::new();
    for (id, cell) in body.cells() {
        let Some(before) = old.body.cell(*id) else { continue };
        if before.is_same(cell) {
            continue;
        }
        renewed.insert(*id);
        if before.has_shape_of(cell) {
            continue;
        }
        for sharing in [sharing, &old.sharing] {
            let Some(numbers) = sharing.points(*id) else { continue };
            for corner in Corner::all() {
                let users = sharing.at_corner(numbers[corner.coefficient()]);
                renewed.extend(users.iter().map(|(id, _)| *id));
            }
        }
    }
    renewed
}

#[cfg(test)]
mod tests {
    use super::super::{Answer, BodyAsk, BodyJob, BodyMemory, DocumentKey};
    use super::*;
    use crate::document::{HyperpatchModel, Json, read_hyperpatch};
    use serde_json::{Value, json};
    use std::collections::HashMap;

    /// A block of 2 x 2 x 2 cells of two materials; the faces between them are a little bent, so that edges have several segments.
    fn block() -> Value {
        let cell = |n: usize| {
            let coefficient = |at: usize| {
                let node = [3 * (n / 4) + at / 16, 3 * (n / 2 % 2) + at / 4 % 4, 3 * (n % 2) + at % 4];
                let [x, y, z] = node.map(|k| k as f64 / 3.0);
                let bend = 0.2 * (x * 2.0).sin() * (y + z);
                json!({"position": [x, y + bend, z - bend], "mix": [x / 2.0, 1.0 - x / 2.0]})
            };
            json!({"coefficients": (0..64).map(coefficient).collect::<Vec<_>>()})
        };
        json!({"op": "cells", "cells": (0..8).map(cell).collect::<Vec<_>>()})
    }

    fn known(memory: &mut BodyMemory, operations: &[Value]) -> Rc<KnownBody> {
        let materials = json!([{"name": "a", "color": "#000000"}, {"name": "b", "color": "#ffffff"}]);
        let value =
            json!({"directrix": 1, "kind": "hyperpatch", "materials": materials, "operations": operations});
        let key = DocumentKey { head: value.to_string(), operations: Vec::new() };
        memory.find(&key).unwrap_or_else(|| {
            let document = read_hyperpatch(&Json::from(value)).unwrap();
            let model = HyperpatchModel::after(document, memory.models()).unwrap();
            memory.keep(key, model)
        })
    }

    fn surface(known: &Rc<KnownBody>, since: Option<u32>) -> (Rc<KnownSurface>, Option<Renewal>) {
        let ask = BodyAsk::Surface { tolerance: Some(0.02), has_inner: false, since };
        match BodyJob::new(Rc::clone(known), ask).run() {
            Some(Answer::Surface(surface, renewal)) => (surface, renewal),
            other => panic!("a surface was asked for: {other:?}"),
        }
    }

    fn is_watertight(painted: &Painted) -> bool {
        let bits = |n: u32| painted.positions[n as usize].to_array().map(f64::to_bits);
        let mut edges: HashMap<_, i32> = HashMap::new();
        for [a, b, c] in &painted.triangles {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                *edges.entry([bits(*from), bits(*to)]).or_default() += 1;
            }
        }
        edges.iter().all(|([a, b], count)| *count == 1 && edges.get(&[*b, *a]) == Some(&1))
    }

    fn edit(n: usize) -> Value {
        let [cell, i, j, k] = [n * 5 % 8, n % 4, n / 4 % 4, n / 3 % 4];
        match n % 4 {
            0 => json!({"op": "mix", "mix": [0.25, 0.75], "cells": [cell]}),
            1 => {
                json!({"op": "move", "cell": cell, "at": [3 * (i / 2), 3 * (j / 2), 3 * (k / 2)], "by": [0.03, -0.02, 0.01]})
            }
            _ => {
                json!({"op": "move", "cell": cell, "at": [i, j, k], "by": [0.01, 0.02, -0.02], "reach": "single"})
            }
        }
    }

    /// Whatever is edited, what is renewed lies on the body, has the material of it, and fits what stays without a crack.
    #[test]
    fn renewed_surfaces_are_those_of_the_body() {
        let mut memory = BodyMemory::default();
        let mut operations = vec![block()];
        let (mut last, renewal) = surface(&known(&mut memory, &operations), Some(7));
        assert!(renewal.is_none(), "no such surface");
        for n in 0..40 {
            operations.push(edit(n));
            let body = known(&mut memory, &operations);
            let (next, renewal) = surface(&body, Some(last.id));
            let renewal = renewal.expect("the same faces");
            assert_eq!(renewal.since, last.id);
            assert!(is_watertight(&next.painted), "edit {n}");
            for (vertex, point) in next.painted.positions.iter().enumerate() {
                let id = CellId(next.painted.cells[vertex]);
                let (cell, at) = (body.model().body().cell(id).unwrap(), next.painted.parameters[vertex]);
                assert!(cell.point(at).distance(*point) < 1e-12, "edit {n}");
                let fraction = cell.composition(at).fractions()[0];
                assert!((fraction - next.painted.fractions[2 * vertex]).abs() < 1e-12, "edit {n}");
            }
            for (number, (old, new)) in last.painted.stretches.iter().zip(&next.painted.stretches).enumerate()
            {
                assert_eq!((&old.vertices, &old.triangles), (&new.vertices, &new.triangles));
                if !renewal.stretches.contains(&number) {
                    let range = old.vertices.clone();
                    assert_eq!(last.painted.positions[range.clone()], next.painted.positions[range]);
                }
            }
            if n % 4 == 0 {
                assert!(renewal.edges.is_empty() && renewal.corners.is_empty(), "the shape stays");
            }
            last = next;
        }
    }

    /// Where faces come or go, or another tolerance is asked for, the whole surface is made.
    #[test]
    fn other_faces_make_another_surface() {
        let mut memory = BodyMemory::default();
        let mut operations = vec![block()];
        let (first, _) = surface(&known(&mut memory, &operations), None);
        operations.push(json!({"op": "delete", "cells": [3]}));
        let (second, renewal) = surface(&known(&mut memory, &operations), Some(first.id));
        assert!(renewal.is_none() && second.painted.stretches != first.painted.stretches);
        let body = known(&mut memory, &operations);
        let ask = BodyAsk::Surface { tolerance: None, has_inner: false, since: Some(second.id) };
        let Some(Answer::Surface(_, renewal)) = BodyJob::new(body, ask).run() else { panic!("a surface") };
        assert!(renewal.is_none());
    }

    /// What is taken over from body to body is what is found out about each alone.
    #[test]
    fn what_is_taken_over_is_true() {
        let mut memory = BodyMemory::default();
        let mut operations = vec![block()];
        let answers = |known: &Rc<KnownBody>| {
            ["verdicts", "relations", "continuity", "sharing", "summary", "cells"].map(|name| {
                let ask = BodyAsk::read(name, &Json::Object(Vec::new()), known.model()).unwrap();
                format!("{:?}", BodyJob::new(Rc::clone(known), ask).run())
            })
        };
        answers(&known(&mut memory, &operations));
        for n in 0..24 {
            operations.push(if n % 6 == 5 { json!({"op": "delete", "cells": [n / 6 * 2]}) } else { edit(n) });
            let body = known(&mut memory, &operations);
            // Not every body is asked, so that what is known is sometimes older than the one before.
            if n % 3 != 1 {
                assert_eq!(answers(&body), answers(&known(&mut BodyMemory::default(), &operations)), "{n}");
            }
        }
    }
}
