//! How cells continue each other across faces, in shape and in material apart.

use super::sharing::Matching;
use super::{Body, CellId, SharedFace, Sharing, Side};
use crate::hyperpatch::{Cell, Corner, Face};
use glam::DVec3;
use std::collections::{BTreeMap, HashMap};

/// Difference of fractions that counts as none.
const FRACTION: f64 = 1e-9;

/// Points along each side of a face on which a gap is measured.
const SAMPLES: usize = 17;

/// Continuity across a whole face.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Continuity {
    /// The 16 coefficients of the face differ.
    None,
    /// The 16 coefficients are equal: so is every point of the face.
    C0,
    /// The derivatives across the face are equal as well, of parameters that run on. It is stricter than a common
    /// tangent plane.
    C1,
}

/// Continuity at one corner of a face: of the block of 2 x 2 coefficients that belongs to the corner.
///
/// An equal block alone is contact: next to the corner the faces part with the square of the distance, unless the
/// other blocks are equal too.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Match {
    /// The blocks differ.
    None,
    /// The blocks are equal.
    Block,
    /// The blocks are equal, and each coefficient is the middle of its neighbours on either side (Eq. 7 of the paper).
    C1,
}

/// What holds at one corner of a shared face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CornerContinuity {
    /// The corner of the first cell.
    pub corner: Corner,
    /// In shape.
    pub shape: Match,
    /// In material.
    pub material: Match,
}

/// What holds on a shared face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FaceContinuity {
    /// The face.
    pub face: SharedFace,
    /// In shape; at least `C0`.
    pub shape: Continuity,
    /// In material.
    pub material: Continuity,
    /// At its four corners.
    pub corners: [CornerContinuity; 4],
}

/// Two faces that have some corners in common, with their blocks, but not all: they touch there and part.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// The two cells, the lower identifier first, with their faces.
    pub sides: [(CellId, Face); 2],
    /// How the face of the second lies on that of the first, as the common corners say.
    pub matching: Matching,
    /// The common corners, as those of the first cell.
    pub corners: Vec<Corner>,
    /// Largest distance of points of equal parameters, on 17 x 17 of them.
    pub gap: f64,
}

/// What is compared at a coefficient: whether both sides are equal, and whether they run on.
#[derive(Clone, Copy)]
struct Comparison {
    is_equal: bool,
    is_smooth: bool,
}

impl Sharing {
    /// Continuity across every shared face. The body must be the one that was looked at.
    #[must_use]
    pub fn continuity(&self, body: &Body) -> Vec<FaceContinuity> {
        self.shared_faces().into_iter().filter_map(|face| self.continuity_of(body, face)).collect()
    }

    /// Faces that have some corners and their blocks in common, but not all 16 control points.
    #[must_use]
    pub fn contacts(&self, body: &Body) -> Vec<Contact> {
        let mut blocks: HashMap<[u32; 4], Vec<(CellId, Face, Corner)>> = HashMap::new();
        for (id, _) in body.cells() {
            let Some(numbers) = self.points(*id) else { continue };
            for corner in Corner::all() {
                for face in corner.faces() {
                    let side = Side { cell: *id, corner, axis: face.axis };
                    let [at, a, b, across] = side.block().map(|at| numbers[at]);
                    blocks.entry([at, a.min(b), a.max(b), across]).or_default().push((*id, face, corner));
                }
            }
        }
        let mut contacts: BTreeMap<_, Vec<Corner>> = BTreeMap::new();
        for users in blocks.values() {
            for (n, first) in users.iter().enumerate() {
                for second in &users[n + 1..] {
                    let sides = [(first.0, first.1), (second.0, second.1)];
                    if first.0 != second.0 && self.share(sides[0], sides[1]).is_none() {
                        let matching = self.matching(*first, *second);
                        let key = (sides, matching.is_swapped, matching.is_reversed);
                        contacts.entry(key).or_default().push(first.2);
                    }
                }
            }
        }
        let contact = |((sides, is_swapped, is_reversed), mut corners): (_, Vec<Corner>)| {
            corners.sort_unstable();
            let matching = Matching { is_swapped, is_reversed };
            Some(Contact { sides, matching, corners, gap: gap(body, sides, matching)? })
        };
        contacts.into_iter().filter_map(contact).collect()
    }

    /// How the second face lies on the first when two corners with equal blocks lie on each other.
    fn matching(&self, first: (CellId, Face, Corner), second: (CellId, Face, Corner)) -> Matching {
        let along = |(id, face, corner): (CellId, Face, Corner)| {
            let side = Side { cell: id, corner, axis: face.axis };
            self.points(id).map(|numbers| numbers[side.block()[1]])
        };
        let ends =
            |(_, face, corner): (CellId, Face, Corner)| face.axis.others().map(|a| corner.0[a as usize]);
        let is_swapped = along(first) != along(second);
        let ([s, t], other) = (ends(first), ends(second));
        let turned = if is_swapped { [t, s] } else { [s, t] };
        Matching { is_swapped, is_reversed: [0, 1].map(|n| turned[n] != other[n]) }
    }

    fn continuity_of(&self, body: &Body, face: SharedFace) -> Option<FaceContinuity> {
        let [(first, first_face), (second, second_face)] = face.sides;
        let cells = [body.cell(first)?, body.cell(second)?];
        let places = (first_face.coefficients(), second_face.coefficients());
        let at = |n: usize| [places.0[n], places.1[face.matching.coefficient(n)]];
        let inner = |at: [usize; 2]| [first_face.inside(at[0]), second_face.inside(at[1])];
        let shape: [Comparison; 16] = std::array::from_fn(|n| {
            let points = |at: [usize; 2]| [cells[0].net().0[at[0]], cells[1].net().0[at[1]]];
            let ([a, b], [c, d]) = (points(at(n)), points(inner(at(n))));
            let is_small = |difference: DVec3| difference.length() <= self.tolerance();
            Comparison { is_equal: is_small(a - b), is_smooth: is_small((a - c) - (d - b)) }
        });
        let material: [Comparison; 16] =
            std::array::from_fn(|n| compare_materials(cells, at(n), inner(at(n))));
        let corner = |n: usize| {
            let ends = [n & 2 != 0, n & 1 != 0];
            let [s, t] = ends.map(|is_end| if is_end { [2, 3] } else { [0, 1] });
            let block = [s[0] * 4 + t[0], s[0] * 4 + t[1], s[1] * 4 + t[0], s[1] * 4 + t[1]];
            let mut corner = [first_face.is_end; 3];
            first_face
                .axis
                .others()
                .into_iter()
                .zip(ends)
                .for_each(|(axis, end)| corner[axis as usize] = end);
            CornerContinuity {
                corner: Corner(corner),
                shape: of_block(block.map(|at| shape[at])),
                material: of_block(block.map(|at| material[at])),
            }
        };
        Some(FaceContinuity {
            face,
            shape: of_face(&shape),
            material: of_face(&material),
            corners: [0, 1, 2, 3].map(corner),
        })
    }
}

/// Compares the fractions of two coefficients, and of their neighbours inside.
fn compare_materials([first, second]: [&Cell; 2], at: [usize; 2], inner: [usize; 2]) -> Comparison {
    let mut comparison = Comparison { is_equal: true, is_smooth: true };
    for (a, b) in first.fractions().iter().zip(second.fractions()) {
        comparison.is_equal &= (a[at[0]] - b[at[1]]).abs() <= FRACTION;
        comparison.is_smooth &= ((a[at[0]] - a[inner[0]]) - (b[inner[1]] - b[at[1]])).abs() <= FRACTION;
    }
    comparison
}

fn of_block(block: [Comparison; 4]) -> Match {
    match (block.iter().all(|c| c.is_equal), block.iter().all(|c| c.is_smooth)) {
        (false, _) => Match::None,
        (true, false) => Match::Block,
        (true, true) => Match::C1,
    }
}

fn of_face(face: &[Comparison; 16]) -> Continuity {
    match (face.iter().all(|c| c.is_equal), face.iter().all(|c| c.is_smooth)) {
        (false, _) => Continuity::None,
        (true, false) => Continuity::C0,
        (true, true) => Continuity::C1,
    }
}

/// Largest distance of points of equal parameters on two faces.
fn gap(body: &Body, sides: [(CellId, Face); 2], matching: Matching) -> Option<f64> {
    let [(a, first), (b, second)] = sides;
    let (a, b) = (body.cell(a)?, body.cell(b)?);
    let distance = |n: usize| {
        let [s, t] = [n / SAMPLES, n % SAMPLES].map(|n| n as f64 / (SAMPLES - 1) as f64);
        let (s2, t2) = matching.parameters(s, t);
        a.point(first.parameters(s, t)).distance(b.point(second.parameters(s2, t2)))
    };
    Some((0..SAMPLES * SAMPLES).map(distance).fold(0.0, f64::max))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::test_cells::ring_cell;
    use crate::hyperpatch::{Axis, Net, flat};
    use crate::material::Composition;

    fn two(first: Net, second: Net, mixes: [[Composition; 8]; 2]) -> Body {
        let mut body = Body::new(2);
        for (net, mixes) in [first, second].into_iter().zip(mixes) {
            body.add(Cell::with_corner_mixes(net, &mixes).unwrap()).unwrap();
        }
        body
    }

    fn uniform() -> [Composition; 8] {
        std::array::from_fn(|_| Composition::pure(0, 2))
    }

    fn cubes() -> [Net; 2] {
        [0.0, 1.0].map(|x| Net::cuboid(DVec3::new(x, 0.0, 0.0), DVec3::new(x + 1.0, 1.0, 1.0)))
    }

    fn only(body: &Body) -> FaceContinuity {
        let found = Sharing::new(body).continuity(body);
        assert_eq!(found.len(), 1);
        found[0]
    }

    #[test]
    fn cells_of_a_ring_run_on_whichever_way_their_parameters_run() {
        let nets = [0, 1].map(|n| ring_cell(8, n, 1.0, 2.0, 1.0));
        for axis in Axis::ALL {
            let body = two(nets[0].clone(), nets[1].reversed(axis), [uniform(), uniform()]);
            let found = only(&body);
            assert_eq!((found.shape, found.material), (Continuity::C1, Continuity::C1));
            assert!(found.corners.iter().all(|c| (c.shape, c.material) == (Match::C1, Match::C1)));
            assert!(Sharing::new(&body).contacts(&body).is_empty());
        }
    }

    /// One inner coefficient moved: the corner that it belongs to loses its smoothness, and no other.
    #[test]
    fn shape_is_lost_at_one_corner_alone() {
        let [first, mut second] = cubes();
        second.0[flat(1, 0, 3)].z += 0.01;
        let found = only(&two(first, second, [uniform(), uniform()]));
        assert_eq!((found.shape, found.material), (Continuity::C0, Continuity::C1));
        for corner in found.corners {
            let expected =
                if corner.corner == Corner([true, false, true]) { Match::Block } else { Match::C1 };
            assert_eq!(corner.shape, expected);
        }
    }

    /// A jump of the material at one corner; elsewhere the paper's rule keeps it smooth.
    #[test]
    fn material_may_jump_at_one_corner_alone() {
        let [first, second] = cubes();
        let (a, mut b) = (uniform(), uniform());
        b[0] = Composition::pure(1, 2);
        let found = only(&two(first, second, [a, b]));
        assert_eq!((found.shape, found.material), (Continuity::C1, Continuity::None));
        for corner in found.corners {
            let expected =
                if corner.corner == Corner([true, false, false]) { Match::None } else { Match::C1 };
            assert_eq!(corner.material, expected);
        }
    }

    /// A gradient that is linear in the first cell and stops in the second is continuous, not smooth.
    #[test]
    fn material_may_bend() {
        let [first, second] = cubes();
        let linear: Vec<_> = (0..64)
            .map(|n| Composition::pure(0, 2).mix(&Composition::pure(1, 2), (n / 16) as f64 / 3.0))
            .collect();
        let mut body = Body::new(2);
        body.add(Cell::new(first, &linear).unwrap()).unwrap();
        body.add(Cell::uniform(second, &Composition::pure(1, 2)).unwrap()).unwrap();
        let found = only(&body);
        assert_eq!((found.shape, found.material), (Continuity::C1, Continuity::C0));
        assert!(found.corners.iter().all(|corner| corner.material == Match::Block));
    }

    /// One corner of the second cell drawn away: three corners stay in contact, the gap is that of the corner, and no
    /// face is shared.
    #[test]
    fn contact_at_corners_is_named_with_its_gap() {
        let [first, mut second] = cubes();
        for at in Corner([false, true, true]).block() {
            second.0[at].x += 0.25;
        }
        for net in [second.clone(), second.reversed(Axis::V), second.reversed(Axis::W)] {
            let body = two(first.clone(), net, [uniform(), uniform()]);
            let sharing = Sharing::new(&body);
            assert!(sharing.shared_faces().is_empty());
            let contacts = sharing.contacts(&body);
            let [contact] = &contacts[..] else { panic!("{contacts:?}") };
            let expected = [[true, false, false], [true, false, true], [true, true, false]].map(Corner);
            assert_eq!(contact.corners, expected);
            assert!((contact.gap - 0.25).abs() < 1e-12, "{}", contact.gap);
        }
        // Away from a corner in contact the gap grows with the square of the distance: to a quarter when it is halved.
        let cells = [first, second];
        let gap =
            |t: f64| cells[0].point(DVec3::new(1.0, t, t)).distance(cells[1].point(DVec3::new(0.0, t, t)));
        assert!(gap(0.01) / gap(0.005) > 12.0, "twice the square, as both parameters leave the corner");
    }
}
