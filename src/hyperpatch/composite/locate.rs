//! Which cells a point lies in, and its material.

use super::tree::Tree;
use super::{Body, CellId};
use crate::hyperpatch::inversion::{SLACK, newton};
use crate::material::Composition;
use glam::DVec3;
use std::ops::Deref;

/// How far inside a cell, in parameters, a point lies in no other one.
const INSIDE: f64 = 1e-6;

/// A place in a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// The cell.
    pub cell: CellId,
    /// Parameters in the cell.
    pub at: DVec3,
}

/// A body prepared for questions about points. `B` is a reference to a body, or shared ownership of one.
#[derive(Debug, Clone)]
pub struct Probe<B> {
    body: B,
    tree: Tree,
}

impl<B: Deref<Target = Body>> Probe<B> {
    /// Prepares a body.
    #[must_use]
    pub fn new(body: B) -> Self {
        let bounds = |(lo, hi): (DVec3, DVec3)| {
            let slack = (hi - lo).max_element() * SLACK;
            (lo - slack, hi + slack)
        };
        let tree = Tree::new(body.cells().iter().map(|(_, cell)| bounds(cell.net().bounds())).collect());
        Self { body, tree }
    }

    /// Every cell that holds a point, by its identifier: one inside, several on what they share, none outside the body.
    #[must_use]
    pub fn places(&self, point: DVec3) -> Vec<Place> {
        self.search(point).collect()
    }

    /// The place that decides the material of a point: that in the cell with the lowest identifier of those that hold
    /// it, on inner boundaries as well as where they reach the outer one. Later deletions of other cells do not
    /// change it.
    #[must_use]
    pub fn place(&self, point: DVec3) -> Option<Place> {
        self.search(point).next()
    }

    /// The same place, found sooner when a point nearby was found at `last`: where the cell of that one holds the
    /// point well inside, no other cell is asked. In bodies whose cells overlap this may be another place than that
    /// of [`Probe::place`].
    #[must_use]
    pub fn place_from(&self, point: DVec3, last: Option<Place>) -> Option<Place> {
        let near = last.and_then(|last| {
            let at = newton(self.body.cell(last.cell)?.net(), point, last.at)?;
            let is_inside = at.min_element() > INSIDE && at.max_element() < 1.0 - INSIDE;
            is_inside.then_some(Place { at, ..last })
        });
        near.or_else(|| self.place(point))
    }

    /// The composition at a point, or `None` outside the body.
    #[must_use]
    pub fn composition(&self, point: DVec3) -> Option<Composition> {
        let place = self.place(point)?;
        self.body.cell(place.cell).map(|cell| cell.composition(place.at))
    }

    fn search(&self, point: DVec3) -> impl Iterator<Item = Place> {
        self.tree.meeting(point, point).into_iter().filter_map(move |index| {
            let (id, cell) = &self.body.cells()[index];
            cell.net().invert(point).map(|at| Place { cell: *id, at })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::test_cells::{random_place, ring_cell};
    use crate::hyperpatch::{Cell, Net};

    fn ring() -> Body {
        let mut body = Body::new(8);
        for n in 0..8 {
            body.add(Cell::uniform(ring_cell(8, n, 1.0, 2.0, 1.0), &Composition::pure(n, 8)).unwrap())
                .unwrap();
        }
        body
    }

    #[test]
    fn the_angle_says_which_cell_holds_a_point() {
        let body = ring();
        let probe = Probe::new(&body);
        for seed in 0..500 {
            let point = (random_place(seed) * 2.0 - DVec3::ONE) * DVec3::new(2.1, 2.1, 0.99);
            let (radius, turn) =
                (point.truncate().length(), point.y.atan2(point.x).rem_euclid(std::f64::consts::TAU));
            let found = probe.places(point);
            if point.z < 0.0 || !(0.999..2.001).contains(&radius) {
                assert!(found.is_empty());
            } else if (1.001..1.999).contains(&radius) {
                let id = CellId((turn / std::f64::consts::TAU * 8.0) as u32);
                assert_eq!(found.iter().map(|place| place.cell).collect::<Vec<_>>(), [id]);
                assert_eq!(probe.composition(point), Some(Composition::pure(id.0 as usize, 8)));
            }
        }
    }

    /// On a face that two cells share the lower identifier decides, also at the outer boundary, and also after
    /// deletions.
    #[test]
    fn the_lowest_identifier_decides_on_shared_faces() {
        let mut body = ring();
        for (inner, height) in [(1.5, 0.5), (1.0, 0.5), (2.0, 1.0)] {
            for n in 0..8 {
                let shared = body.cell(CellId(n)).unwrap().point(DVec3::new(0.0, 2.0 - inner, height));
                let cells: Vec<u32> =
                    Probe::new(&body).places(shared).iter().map(|place| place.cell.0).collect();
                let mut expected = [n, (n + 7) % 8];
                expected.sort_unstable();
                assert_eq!(cells, expected);
                let mix = Probe::new(&body).composition(shared).unwrap();
                assert_eq!(mix, Composition::pure(expected[0] as usize, 8));
            }
        }
        let shared = body.cell(CellId(3)).unwrap().point(DVec3::new(0.0, 0.5, 0.5));
        body.remove(CellId(0)).unwrap();
        assert_eq!(Probe::new(&body).place(shared).map(|place| place.cell), Some(CellId(2)));
        body.remove(CellId(2)).unwrap();
        assert_eq!(Probe::new(&body).place(shared).map(|place| place.cell), Some(CellId(3)));
    }

    #[test]
    fn a_walk_finds_the_same_places() {
        let body = ring();
        let probe = Probe::new(&body);
        let mut last = None;
        for n in 0..4000 {
            let angle = 0.01 * f64::from(n);
            let point =
                DVec3::new(angle.cos(), angle.sin(), 0.0) * (0.9 + 3e-4 * f64::from(n)) + DVec3::Z * 0.4;
            let (found, expected) = (probe.place_from(point, last), probe.place(point));
            assert_eq!(found.map(|place| place.cell), expected.map(|place| place.cell));
            if let (Some(a), Some(b)) = (found, expected) {
                assert!(a.at.distance(b.at) < 1e-9);
            }
            last = found.or(last);
        }
    }

    #[test]
    fn an_empty_body_holds_nothing() {
        assert!(Probe::new(&Body::new(1)).places(DVec3::ZERO).is_empty());
        let cube = Cell::uniform(Net::cuboid(DVec3::ZERO, DVec3::ONE), &Composition::pure(0, 1)).unwrap();
        let mut body = Body::new(1);
        body.add(cube).unwrap();
        assert_eq!(Probe::new(&body).places(DVec3::splat(0.5)).len(), 1);
        assert!(Probe::new(&body).places(DVec3::splat(f64::NAN)).is_empty());
    }
}
