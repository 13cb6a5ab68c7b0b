//! Corners, edges and faces that cells share, found by the numbers of their control points.

use super::weld::Weld;
use super::{Body, CellId};
use crate::hyperpatch::{Corner, Edge, Face, Net};
use glam::DVec3;
use std::collections::HashMap;

/// Distance within which control points are one, over the size of the body.
pub(super) const WELD: f64 = 1e-9;

/// A face of two cells with the same 16 control points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SharedFace {
    /// The two cells, the lower identifier first, with their faces.
    pub sides: [(CellId, Face); 2],
    /// How the face of the second lies on that of the first.
    pub matching: Matching,
}

/// One of the 8 ways in which a square lies on a square: how parameters (s, t) of the one become those of the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Matching {
    /// Whether s and t change places, before anything is reversed.
    pub is_swapped: bool,
    /// Whether each of the parameters of the other runs backwards.
    pub is_reversed: [bool; 2],
}

impl Matching {
    /// Every matching.
    #[must_use]
    pub fn all() -> [Self; 8] {
        std::array::from_fn(|n| Self { is_swapped: n & 4 != 0, is_reversed: [n & 2 != 0, n & 1 != 0] })
    }

    /// Parameters on the other face.
    #[must_use]
    pub fn parameters(self, s: f64, t: f64) -> (f64, f64) {
        let (s, t) = if self.is_swapped { (t, s) } else { (s, t) };
        let turn = |x: f64, is_reversed: bool| if is_reversed { 1.0 - x } else { x };
        (turn(s, self.is_reversed[0]), turn(t, self.is_reversed[1]))
    }

    /// Place on the other face of the coefficient at a place in the list of 16.
    #[must_use]
    pub fn coefficient(self, place: usize) -> usize {
        let (s, t) = if self.is_swapped { (place % 4, place / 4) } else { (place / 4, place % 4) };
        let turn = |x: usize, is_reversed: bool| if is_reversed { 3 - x } else { x };
        turn(s, self.is_reversed[0]) * 4 + turn(t, self.is_reversed[1])
    }
}

/// What the cells of a body share. The numbers of control points are those of [`Sharing::points`].
#[derive(Debug, Clone)]
pub struct Sharing {
    tolerance: f64,
    weld: Weld,
    /// Numbers of the 64 control points of each cell, in the order of the body; inner ones have none.
    numbers: Vec<(CellId, [u32; 64])>,
    corners: HashMap<u32, Vec<(CellId, Corner)>>,
    edges: HashMap<[u32; 4], Vec<(CellId, Edge)>>,
    faces: HashMap<[u32; 16], Vec<(CellId, Face)>>,
}

/// Stands for the number of a control point inside a cell, which is shared with none.
const INNER: u32 = u32::MAX;

impl Sharing {
    /// Finds what is shared within 1e-9 of the size of the body.
    #[must_use]
    pub fn new(body: &Body) -> Self {
        let mut sharing = Self::start(body);
        body.cells().iter().for_each(|(id, cell)| sharing.add(*id, cell.net()));
        sharing
    }

    /// The state before the first cell of a body is [added](Sharing::add), for work in steps.
    #[must_use]
    pub fn start(body: &Body) -> Self {
        let tolerance = body.tolerance();
        let origin = body.cells().first().map_or(DVec3::ZERO, |(_, cell)| cell.net().0[0]);
        Self {
            tolerance,
            weld: Weld::new(tolerance, origin),
            numbers: Vec::with_capacity(body.cells().len()),
            corners: HashMap::new(),
            edges: HashMap::new(),
            faces: HashMap::new(),
        }
    }

    /// Adds a cell of the body that is not there.
    pub fn add(&mut self, id: CellId, net: &Net) {
        fn insert<P>(list: &mut Vec<(CellId, P)>, id: CellId, part: P) {
            let at = list.partition_point(|(other, _)| *other <= id);
            list.insert(at, (id, part));
        }
        let is_inner = |at: usize| [at / 16, at / 4 % 4, at % 4].iter().all(|&n| n == 1 || n == 2);
        let weld = &mut self.weld;
        let numbers: [u32; 64] =
            std::array::from_fn(|at| if is_inner(at) { INNER } else { weld.number(net.0[at]) });
        for corner in Corner::all() {
            insert(self.corners.entry(numbers[corner.coefficient()]).or_default(), id, corner);
        }
        for edge in Edge::all() {
            let key = edge_key(edge.coefficients().map(|at| numbers[at]));
            insert(self.edges.entry(key).or_default(), id, edge);
        }
        for face in Face::all() {
            let key = face_key(face.coefficients().map(|at| numbers[at]));
            insert(self.faces.entry(key).or_default(), id, face);
        }
        let at = self.numbers.partition_point(|(other, _)| *other < id);
        self.numbers.insert(at, (id, numbers));
    }

    /// Drops a cell, if it is there.
    pub fn remove(&mut self, id: CellId) {
        fn drop<K: std::hash::Hash + Eq, P>(map: &mut HashMap<K, Vec<(CellId, P)>>, key: K, id: CellId) {
            if let Some(list) = map.get_mut(&key) {
                list.retain(|(other, _)| *other != id);
                if list.is_empty() {
                    map.remove(&key);
                }
            }
        }
        let Ok(at) = self.numbers.binary_search_by_key(&id, |(id, _)| *id) else { return };
        let (_, numbers) = self.numbers.remove(at);
        for corner in Corner::all() {
            drop(&mut self.corners, numbers[corner.coefficient()], id);
        }
        for edge in Edge::all() {
            drop(&mut self.edges, edge_key(edge.coefficients().map(|at| numbers[at])), id);
        }
        for face in Face::all() {
            drop(&mut self.faces, face_key(face.coefficients().map(|at| numbers[at])), id);
        }
        numbers.into_iter().filter(|number| *number != INNER).for_each(|number| self.weld.release(number));
    }

    /// Distance within which control points are one.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// Numbers of the 64 control points of a cell: equal ones are one point. Inner control points have no number of
    /// their own.
    #[must_use]
    pub fn points(&self, id: CellId) -> Option<&[u32; 64]> {
        self.numbers.binary_search_by_key(&id, |(id, _)| *id).ok().map(|index| &self.numbers[index].1)
    }

    /// Every cell at a corner with the number of its point, in the order of the body.
    #[must_use]
    pub fn at_corner(&self, point: u32) -> &[(CellId, Corner)] {
        self.corners.get(&point).map_or(&[], Vec::as_slice)
    }

    /// Every cell on an edge of a cell, that one included.
    #[must_use]
    pub fn at_edge(&self, id: CellId, edge: Edge) -> &[(CellId, Edge)] {
        let key = |numbers: &[u32; 64]| edge_key(edge.coefficients().map(|at| numbers[at]));
        self.points(id).and_then(|numbers| self.edges.get(&key(numbers))).map_or(&[], Vec::as_slice)
    }

    /// Every cell on a face of a cell, that one included; more than two overlap.
    #[must_use]
    pub fn at_face(&self, id: CellId, face: Face) -> &[(CellId, Face)] {
        let key = |numbers: &[u32; 64]| face_key(face.coefficients().map(|at| numbers[at]));
        self.points(id).and_then(|numbers| self.faces.get(&key(numbers))).map_or(&[], Vec::as_slice)
    }

    /// Every pair of faces that is shared, by the identifiers of the cells.
    #[must_use]
    pub fn shared_faces(&self) -> Vec<SharedFace> {
        let mut shared = Vec::new();
        for sides in self.faces.values() {
            for (n, a) in sides.iter().enumerate() {
                shared.extend(sides[n + 1..].iter().filter_map(|b| self.share(*a, *b)));
            }
        }
        shared.sort_unstable_by_key(|face| face.sides);
        shared
    }

    /// The faces that belong to one cell alone, by its identifier: with them the body ends.
    #[must_use]
    pub fn outer_faces(&self) -> Vec<(CellId, Face)> {
        let mut outer: Vec<_> = self.faces.values().filter(|s| s.len() == 1).map(|sides| sides[0]).collect();
        outer.sort_unstable();
        outer
    }

    /// How two faces with the same control points lie on each other.
    pub(super) fn share(&self, a: (CellId, Face), b: (CellId, Face)) -> Option<SharedFace> {
        let numbers =
            |(id, face): (CellId, Face)| self.points(id).map(|n| face.coefficients().map(|at| n[at]));
        let (first, second) = (numbers(a)?, numbers(b)?);
        let fits =
            |matching: &Matching| (0..16).all(|place| first[place] == second[matching.coefficient(place)]);
        Matching::all().into_iter().find(fits).map(|matching| SharedFace { sides: [a, b], matching })
    }
}

/// The numbers of an edge in the direction that comes first.
fn edge_key(numbers: [u32; 4]) -> [u32; 4] {
    let [a, b, c, d] = numbers;
    numbers.min([d, c, b, a])
}

/// The numbers of a face in that of its 8 arrangements that comes first.
fn face_key(numbers: [u32; 16]) -> [u32; 16] {
    let arranged = |matching: Matching| std::array::from_fn(|place| numbers[matching.coefficient(place)]);
    Matching::all().into_iter().map(arranged).min().unwrap_or(numbers)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::test_cells::ring_cell;
    use crate::hyperpatch::{Axis, Cell, Net};
    use crate::material::Composition;

    fn body(nets: impl IntoIterator<Item = Net>) -> Body {
        let mut body = Body::new(1);
        for net in nets {
            body.add(Cell::uniform(net, &Composition::pure(0, 1)).unwrap()).unwrap();
        }
        body
    }

    /// A block of cubes.
    fn block(count: [usize; 3]) -> Body {
        let cube = |n: usize| {
            let min = DVec3::new(
                (n / (count[1] * count[2])) as f64,
                (n / count[2] % count[1]) as f64,
                (n % count[2]) as f64,
            );
            Net::cuboid(min, min + 1.0)
        };
        body((0..count.iter().product()).map(cube))
    }

    #[test]
    fn a_block_shares_what_its_grid_says() {
        let body = block([2, 2, 2]);
        let sharing = Sharing::new(&body);
        assert_eq!(sharing.shared_faces().len(), 12);
        assert_eq!(sharing.outer_faces().len(), 24);
        assert_eq!(sharing.corners.len(), 27);
        assert_eq!(sharing.edges.len(), 54);
        let middle = sharing.points(CellId(0)).unwrap()[63];
        assert_eq!(sharing.at_corner(middle).len(), 8);
        let inner = Edge { axis: Axis::U, ends: [true, true] };
        assert_eq!(sharing.at_edge(CellId(0), inner).len(), 4);
        assert_eq!(sharing.at_face(CellId(0), Face { axis: Axis::V, is_end: true }).len(), 2);
        assert!(sharing.at_face(CellId(99), Face { axis: Axis::V, is_end: true }).is_empty());
    }

    /// After any changes the parts are those that are found at once.
    #[test]
    fn changed_cells_are_found_anew() {
        let mut body = block([3, 2, 2]);
        let mut sharing = Sharing::new(&body);
        let listed = |sharing: &Sharing, body: &Body| {
            let faces = (sharing.shared_faces(), sharing.outer_faces());
            let mut corners: Vec<_> = sharing.corners.values().cloned().collect();
            let mut edges: Vec<_> = sharing.edges.values().cloned().collect();
            corners.sort_unstable();
            edges.sort_unstable();
            (faces, corners, edges, sharing.contacts(body).len(), sharing.numbers.len())
        };
        for seed in 0..60_u64 {
            let id = CellId((seed * 7 % 12) as u32);
            sharing.remove(id);
            if seed % 5 == 4 {
                let _ = body.remove(id);
            } else {
                let place = DVec3::new((id.0 / 4) as f64, (id.0 / 2 % 2) as f64, (id.0 % 2) as f64);
                let shift = if seed % 3 == 0 { DVec3::splat(0.25) } else { DVec3::ZERO };
                let net = Net::cuboid(place + shift, place + 1.0);
                let cell = Cell::uniform(net, &Composition::pure(0, 1)).unwrap();
                if body.cell(id).is_some() {
                    body.replace(id, cell).unwrap();
                } else {
                    body.add_as(id, cell).unwrap();
                }
                sharing.add(id, body.cell(id).unwrap().net());
            }
            assert_eq!(listed(&sharing, &body), listed(&Sharing::new(&body), &body), "{seed}");
        }
        body.cells().iter().for_each(|(id, _)| sharing.remove(*id));
        assert!(sharing.corners.is_empty() && sharing.edges.is_empty() && sharing.faces.is_empty());
    }

    #[test]
    fn a_ring_closes() {
        for count in [4, 8] {
            let sharing = Sharing::new(&body((0..count).map(|n| ring_cell(count, n, 1.0, 2.0, 1.0))));
            assert_eq!(sharing.shared_faces().len(), count);
            assert_eq!(sharing.outer_faces().len(), 4 * count);
        }
    }

    /// Whatever way a neighbour's parameters run, the face is found, and the matching takes points to points.
    #[test]
    fn faces_are_found_in_all_matchings() {
        let first = ring_cell(8, 0, 1.0, 2.0, 1.0);
        let second = ring_cell(8, 1, 1.0, 2.0, 1.0);
        let turned = |order: [usize; 3], signs: usize| {
            let mut net = Net(std::array::from_fn(|at| {
                let place = [at / 16, at / 4 % 4, at % 4];
                second.0[place[order[0]] * 16 + place[order[1]] * 4 + place[order[2]]]
            }));
            for (n, axis) in Axis::ALL.into_iter().enumerate() {
                if signs & (1 << n) != 0 {
                    net = net.reversed(axis);
                }
            }
            net
        };
        let mut matchings = Vec::new();
        for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            for signs in 0..8 {
                let body = body([first.clone(), turned(order, signs)]);
                let shared = Sharing::new(&body).shared_faces();
                let [SharedFace { sides, matching }] = shared[..] else { panic!("{shared:?}") };
                for (s, t) in [(0.2, 0.7), (0.9, 0.1)] {
                    let (s2, t2) = matching.parameters(s, t);
                    let a = body.cell(sides[0].0).unwrap().point(sides[0].1.parameters(s, t));
                    let b = body.cell(sides[1].0).unwrap().point(sides[1].1.parameters(s2, t2));
                    assert!(a.distance(b) < 1e-13);
                }
                if !matchings.contains(&matching) {
                    matchings.push(matching);
                }
            }
        }
        assert_eq!(matchings.len(), 8, "all eight occur");
    }

    #[test]
    fn nearly_equal_points_are_shared_and_distant_ones_are_not() {
        let cube = Net::cuboid(DVec3::ZERO, DVec3::ONE);
        for (shift, count) in [(1e-11, 1), (1e-6, 0)] {
            let body = body([cube.clone(), cube.map(|p| p + DVec3::new(1.0 + shift, shift, 0.0))]);
            assert_eq!(Sharing::new(&body).shared_faces().len(), count);
        }
        assert!(Sharing::new(&Body::new(1)).outer_faces().is_empty());
    }
}
