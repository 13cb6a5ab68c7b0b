//! New cells on outer faces, along their normals.

use super::draft::{check_mix, identifiers, insert};
use super::{Change, OperationError};
use crate::hyperpatch::bernstein::stride;
use crate::hyperpatch::composite::{Body, BodyError, CellId, Weld};
use crate::hyperpatch::{Cell, Corner, Face, LARGEST_COORDINATE, Net};
use crate::material::Composition;
use glam::DVec3;
use std::collections::{HashMap, HashSet};

/// How an extruded cell begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Start {
    /// It runs on from its parent: the first layer is the mirror image of the parent's last one in the face (Eq. 8).
    /// The layers keep their order while the distance of these is at most two thirds of the length.
    C1,
    /// Its layers are evenly spaced; where it leaves the parent there may be an edge.
    Free,
}

/// Directions along which a face is extruded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Normals {
    /// At each corner the mean normal of the extruded faces there, and in between a mean of those of the corners: a
    /// single face moves as a whole along its own, whatever its shape.
    Mean,
    /// The normal of the surface at each point, for rounder walls: the new face lies at the same distance everywhere,
    /// as far as a cubic can follow (to fourth order in the size of the face).
    Surface,
}

/// What is extruded, and how.
#[derive(Debug, Clone, PartialEq)]
pub struct Extrusion {
    /// Faces of the outer boundary; those that meet in an edge share the new wall there.
    pub faces: Vec<(CellId, Face)>,
    /// Length along the normals, more than 0.
    pub by: f64,
    /// How the new cells begin.
    pub start: Start,
    /// Their directions.
    pub normals: Normals,
    /// Composition of the new cells; without one that of the face goes on, the same in all layers.
    pub mix: Option<Composition>,
}

/// Largest sine of an angle that counts as none: below it normals cancel out.
const NOTHING: f64 = 1e-9;

/// Abscissas of Gauss and Legendre on [0, 1], and weights: exact for polynomials of degree 5.
const GAUSS: [(f64, f64); 3] =
    [(0.112_701_665_379_258_31, 5.0 / 18.0), (0.5, 8.0 / 18.0), (0.887_298_334_620_741_7, 5.0 / 18.0)];

/// Adds cells on outer faces of a body along their normals (section 5 of the paper, Fig. 16). They get the identifiers
/// from `first` on, in the order of the faces, and run on along the axes of their parents.
///
/// Faces that meet in an edge share the new wall: its points move along the mean of the normals there. Where their
/// parents do not run on from one to the other, the wall begins free even when C1 is asked for, as it cannot run on
/// from both. A face that is named twice counts once.
///
/// # Errors
/// When no face is named, a cell is unknown, a face lies inside the body or gives no direction, the length is not more
/// than 0 or leads too far, the mix has another number of materials, an identifier is taken or the body full.
pub fn extrude(body: &mut Body, what: &Extrusion, first: CellId) -> Result<Change, OperationError> {
    if !(what.by > 0.0 && what.by <= LARGEST_COORDINATE) {
        let expected = "more than 0 and at most 1e9";
        return Err(OperationError::Number { name: "the length", value: what.by, expected });
    }
    if let Some(mix) = &what.mix {
        check_mix(body, mix)?;
    }
    let (mut faces, mut named) = (Vec::with_capacity(what.faces.len()), HashSet::new());
    for &(id, face) in &what.faces {
        if body.cell(id).is_none() {
            return Err(BodyError::Unknown { id }.into());
        }
        if named.insert((id, face)) {
            faces.push((id, face));
        }
    }
    if faces.is_empty() {
        return Err(OperationError::NoCells);
    }
    identifiers(body, first, faces.len(), 0)?;
    check_outer(body, &faces)?;
    let parents: Vec<Parent> = faces.iter().filter_map(|(id, face)| Parent::new(body, *id, *face)).collect();
    let cells = Walls::new(body, &parents, what)?.cells(&parents, what)?;
    let made = insert(body, first, cells)?;
    Ok(Change { made, ..Change::default() })
}

/// Refuses faces that another cell lies on.
fn check_outer(body: &Body, faces: &[(CellId, Face)]) -> Result<(), OperationError> {
    let tolerance = body.tolerance();
    let mut weld =
        Weld::new(tolerance, body.cells().first().map_or(DVec3::ZERO, |(_, cell)| cell.net().0[0]));
    let mut users: HashMap<[u32; 4], Vec<(CellId, Face)>> = HashMap::new();
    let mut keys = HashMap::new();
    let wanted: HashSet<&(CellId, Face)> = faces.iter().collect();
    let points = |(id, face): (CellId, Face)| body.cell(id).map(|cell| cell.net().face(face));
    let (mut lo, mut hi) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for point in faces.iter().filter_map(|side| points(*side)).flatten() {
        (lo, hi) = (lo.min(point - tolerance), hi.max(point + tolerance));
    }
    for ((id, cell), bounds) in body.cells().iter().zip(body.boxes()) {
        if !(bounds.0.cmple(hi).all() && lo.cmple(bounds.1).all()) {
            continue;
        }
        let numbers = cell.net().corners().map(|point| weld.number(point));
        for face in Face::all() {
            let corners = Corner::all().into_iter().zip(numbers);
            let on_face = corners.filter(|(corner, _)| corner.0[face.axis as usize] == face.is_end);
            let mut key = [0; 4];
            key.iter_mut().zip(on_face).for_each(|(to, (_, number))| *to = number);
            key.sort_unstable();
            users.entry(key).or_default().push((*id, face));
            if wanted.contains(&(*id, face)) {
                keys.insert((*id, face), key);
            }
        }
    }
    for &side in faces {
        let (Some(key), Some(here)) = (keys.get(&side), points(side)) else { continue };
        let is_here = |point: &DVec3| here.iter().any(|p| p.distance(*point) <= tolerance);
        let lies_on = |other: &&(CellId, Face)| {
            **other != side && points(**other).is_some_and(|points| points.iter().all(is_here))
        };
        if let Some((other, _)) = users.get(key).into_iter().flatten().find(lies_on) {
            return Err(OperationError::Inner { id: side.0, face: side.1, other: *other });
        }
    }
    Ok(())
}

/// A face to be extruded.
struct Parent<'a> {
    id: CellId,
    face: Face,
    cell: &'a Cell,
    /// Control points of the face, and of the layer behind it.
    points: [DVec3; 16],
    behind: [DVec3; 16],
    /// 1 or -1: whether the cross product of the derivatives along the face points out of the cell.
    sign: f64,
}

/// Numbers of points of all faces, and where they go.
struct Walls {
    /// Numbers of the 16 control points of each face.
    numbers: Vec<[u32; 16]>,
    /// Where the points start, and how far they go.
    points: HashMap<u32, (DVec3, DVec3)>,
    /// Layers behind the points, unless faces differ in them.
    behind: HashMap<u32, Option<DVec3>>,
    /// How far the inner points of each face go, in the place of its 16 points.
    inner: Vec<[DVec3; 16]>,
}

impl<'a> Parent<'a> {
    fn new(body: &'a Body, id: CellId, face: Face) -> Option<Self> {
        let cell = body.cell(id)?;
        let points = cell.net().face(face);
        let behind = face.coefficients().map(|at| cell.net().0[face.inside(at)]);
        let mut parent = Self { id, face, cell, points, behind, sign: 1.0 };
        let outwards = points.iter().zip(behind).fold(DVec3::ZERO, |sum, (p, q)| sum + (*p - q));
        if parent.area().dot(outwards) < 0.0 {
            parent.sign = -1.0;
        }
        Some(parent)
    }

    /// The cross product of the derivatives of the face, out of the cell: its length is that of the area.
    fn normal(&self, s: f64, t: f64) -> DVec3 {
        let derivatives = self.cell.net().derivatives(self.face.parameters(s, t));
        let [a, b] = self.face.axis.others().map(|axis| derivatives[axis as usize]);
        a.cross(b) * self.sign
    }

    /// The integral of that over the face.
    fn area(&self) -> DVec3 {
        let places = GAUSS.into_iter().flat_map(|a| GAUSS.into_iter().map(move |b| (a, b)));
        places.fold(DVec3::ZERO, |sum, ((s, a), (t, b))| sum + self.normal(s, t) * (a * b))
    }

    fn no_normal(&self) -> OperationError {
        OperationError::NoNormal { id: self.id, face: self.face }
    }

    /// A direction, if there is one beside the extent of the face.
    fn direction(&self, vector: DVec3, scale: f64) -> Result<DVec3, OperationError> {
        if vector.length() > NOTHING * scale { Ok(vector.normalize()) } else { Err(self.no_normal()) }
    }

    /// Square of the extent of the face.
    fn extent(&self) -> f64 {
        let lo = self.points.into_iter().fold(DVec3::INFINITY, DVec3::min);
        let hi = self.points.into_iter().fold(DVec3::NEG_INFINITY, DVec3::max);
        (hi - lo).length_squared()
    }
}

impl Walls {
    fn new(body: &Body, parents: &[Parent<'_>], what: &Extrusion) -> Result<Self, OperationError> {
        let tolerance = body.tolerance();
        let mut weld = Weld::new(tolerance, parents.first().map_or(DVec3::ZERO, |parent| parent.points[0]));
        let numbers: Vec<[u32; 16]> =
            parents.iter().map(|parent| parent.points.map(|point| weld.number(point))).collect();
        let targets = match what.normals {
            Normals::Mean => mean_targets(parents, &numbers)?,
            Normals::Surface => surface_targets(parents, tolerance)?,
        };
        let mut walls =
            Self { numbers, points: HashMap::new(), behind: HashMap::new(), inner: targets.clone() };
        for ((parent, numbers), targets) in parents.iter().zip(&walls.numbers).zip(&targets) {
            let steps = parent.points.into_iter().zip(targets);
            for ((number, (start, step)), layer) in numbers.iter().zip(steps).zip(parent.behind) {
                // The first face to have a point decides on it, so that the others get the same bits.
                walls.points.entry(*number).or_insert((start, *step));
                let behind = walls.behind.entry(*number).or_insert(Some(layer));
                if behind.is_some_and(|known| known.distance(layer) > tolerance) {
                    *behind = None;
                }
            }
        }
        Ok(walls)
    }

    /// The new cells.
    fn cells(&self, parents: &[Parent<'_>], what: &Extrusion) -> Result<Vec<Cell>, OperationError> {
        let mut cells = Vec::with_capacity(parents.len());
        for (n, parent) in parents.iter().enumerate() {
            let (axis, steps) = (parent.face.axis, parent.face.axis.others().map(stride));
            let mut net = [DVec3::ZERO; 64];
            let mut sources = [0; 64];
            for (at, source) in parent.face.coefficients().into_iter().enumerate() {
                let number = self.numbers[n][at];
                let (start, step) =
                    self.points.get(&number).copied().unwrap_or((parent.points[at], self.inner[n][at]));
                let end = start + step * what.by;
                let behind = self.behind.get(&number).copied().flatten();
                let first = match (what.start, behind) {
                    (Start::C1, Some(behind)) => start * 2.0 - behind,
                    _ => start + step * (what.by / 3.0),
                };
                let line = [start, first, start + step * (what.by * 2.0 / 3.0), end];
                for (layer, point) in line.into_iter().enumerate() {
                    let place = if parent.face.is_end { layer } else { 3 - layer };
                    let to = (at / 4) * steps[0] + (at % 4) * steps[1] + place * stride(axis);
                    (net[to], sources[to]) = (point, source);
                }
            }
            let mixes: Vec<Composition> = match &what.mix {
                Some(mix) => vec![mix.clone(); 64],
                None => sources.iter().map(|at| parent.cell.mix(*at)).collect(),
            };
            let error = |error| OperationError::Cell { id: parent.id, error };
            cells.push(Cell::new(Net(net), &mixes).map_err(error)?);
        }
        Ok(cells)
    }
}

/// How far the points of faces go for a length of 1, by the mean normals of faces at each corner.
fn mean_targets(parents: &[Parent<'_>], numbers: &[[u32; 16]]) -> Result<Vec<[DVec3; 16]>, OperationError> {
    let mut normals = Vec::with_capacity(parents.len());
    let mut sums: HashMap<u32, DVec3> = HashMap::new();
    for (parent, numbers) in parents.iter().zip(numbers) {
        let normal = parent.direction(parent.area(), parent.extent())?;
        normals.push(normal);
        for at in [0, 3, 12, 15] {
            *sums.entry(numbers[at]).or_insert(DVec3::ZERO) += normal;
        }
    }
    let mut targets = Vec::with_capacity(parents.len());
    for ((parent, numbers), normal) in parents.iter().zip(numbers).zip(normals) {
        let mut corners = [DVec3::ZERO; 4];
        for (corner, at) in corners.iter_mut().zip([0, 3, 12, 15]) {
            *corner = parent.direction(sums.get(&numbers[at]).copied().unwrap_or(normal), 1.0)?;
        }
        let [a, b, c, d] = corners;
        targets.push(std::array::from_fn(|at| {
            let (s, t) = ((at / 4) as f64 / 3.0, (at % 4) as f64 / 3.0);
            if a == b && a == c && a == d { a } else { a.lerp(c, s).lerp(b.lerp(d, s), t) }
        }));
    }
    Ok(targets)
}

/// How far the points of faces go for a length of 1, by the normals of the surface at 4 x 4 points of each face, which
/// the Bezier coefficients returned interpolate.
fn surface_targets(parents: &[Parent<'_>], tolerance: f64) -> Result<Vec<[DVec3; 16]>, OperationError> {
    let mut weld = Weld::new(tolerance, parents.first().map_or(DVec3::ZERO, |parent| parent.points[0]));
    let mut sums: HashMap<u32, DVec3> = HashMap::new();
    let mut all = Vec::with_capacity(parents.len());
    for parent in parents {
        let extent = parent.extent();
        let mut samples = [(0, DVec3::ZERO); 16];
        for (at, sample) in samples.iter_mut().enumerate() {
            let (s, t) = ((at / 4) as f64 / 3.0, (at % 4) as f64 / 3.0);
            let normal = parent.direction(parent.normal(s, t), extent)?;
            let number = weld.number(parent.cell.point(parent.face.parameters(s, t)));
            *sums.entry(number).or_insert(DVec3::ZERO) += normal;
            *sample = (number, normal);
        }
        all.push(samples);
    }
    let mut targets = Vec::with_capacity(parents.len());
    for (parent, samples) in parents.iter().zip(all) {
        let mut net = [DVec3::ZERO; 16];
        for (target, (number, normal)) in net.iter_mut().zip(samples) {
            *target = parent.direction(sums.get(&number).copied().unwrap_or(normal), 1.0)?;
        }
        for (start, step) in (0..4).map(|n| (n * 4, 1)).chain((0..4).map(|n| (n, 4))) {
            let line = interpolate([0, 1, 2, 3].map(|n| net[start + n * step]));
            (0..4).for_each(|n| net[start + n * step] = line[n]);
        }
        targets.push(net);
    }
    Ok(targets)
}

/// Bezier coefficients of the cubic with given values at 0, 1/3, 2/3 and 1.
fn interpolate([a, b, c, d]: [DVec3; 4]) -> [DVec3; 4] {
    [a, (b * 18.0 - a * 5.0 - c * 9.0 + d * 2.0) / 6.0, (c * 18.0 - d * 5.0 - b * 9.0 + a * 2.0) / 6.0, d]
}

#[cfg(test)]
mod tests {
    use super::super::test_bodies::{block, body_of, check_body, random_mix, ring, shuffled, smooth_corners};
    use super::super::{Reach, mix_coefficient, move_coefficient};
    use super::*;
    use crate::hyperpatch::composite::{MOST_CELLS, Sharing, relate};
    use crate::hyperpatch::test_cells::random_net;
    use crate::hyperpatch::validity::{Verdict, verdict};
    use crate::hyperpatch::{Axis, Jacobian};

    fn extrusion(faces: Vec<(CellId, Face)>, by: f64, start: Start, normals: Normals) -> Extrusion {
        Extrusion { faces, by, start, normals, mix: None }
    }

    fn volume_of(body: &Body, ids: &[CellId]) -> f64 {
        ids.iter().map(|id| Jacobian::new(body.cell(*id).unwrap().net()).volume().abs()).sum()
    }

    /// A flat face of any outline: area times length, for every face of the cell.
    #[test]
    fn the_volume_over_a_flat_face_is_area_times_length() {
        let cell = random_net(5, 0.1);
        for face in Face::all() {
            let mut net = cell.clone();
            let end = if face.is_end { 1.0 } else { 0.0 };
            for at in face.coefficients() {
                net.0[at][face.axis as usize] = end;
            }
            let [a, b] = face.axis.others().map(|axis| axis as usize);
            // The area of a plane patch by fine triangles.
            let corner = |i: usize, j: usize| net.point(face.parameters(i as f64 / 400.0, j as f64 / 400.0));
            let mut area = 0.0;
            for i in 0..400 {
                for j in 0..400 {
                    let (p, q, r, s) =
                        (corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
                    let (d, e) = (r - p, s - q);
                    area += (d[a] * e[b] - d[b] * e[a]) / 2.0;
                }
            }
            for normals in [Normals::Mean, Normals::Surface] {
                let mut body = body_of([net.clone()]);
                let what = extrusion(vec![(CellId(0), face)], 0.4, Start::Free, normals);
                let made = extrude(&mut body, &what, CellId(10_000)).unwrap().made;
                assert_eq!(made, [CellId(10_000)]);
                let volume = volume_of(&body, &made);
                assert!((volume - area.abs() * 0.4).abs() < 1e-5, "{face}: {volume}, {area}");
                assert_eq!(Sharing::new(&body).shared_faces().len(), 1);
            }
        }
        let mut body = block([1, 1, 1]);
        let face = Face { axis: Axis::V, is_end: false };
        let what = extrusion(vec![(CellId(0), face)], 2.5, Start::C1, Normals::Mean);
        let made = extrude(&mut body, &what, CellId(1)).unwrap().made;
        assert!((volume_of(&body, &made) - 2.5).abs() < 1e-13);
    }

    /// Three faces in a row at once (Fig. 16), with parents that lie in any way: they share their walls, and run on from
    /// their parents and into each other.
    #[test]
    fn faces_beside_each_other_share_their_walls_and_run_on() {
        for seed in 0..8 {
            let mut body = shuffled(&block([3, 1, 1]), seed);
            let top = |body: &Body, id: u32| {
                let net = body.cell(CellId(id)).unwrap().net();
                let is_top = |face: &Face| net.face(*face).iter().all(|p| p.z == 1.0);
                Face::all().into_iter().find(is_top).unwrap()
            };
            let faces = (0..3).map(|id| (CellId(id), top(&body, id))).collect();
            let what = extrusion(faces, 0.8, Start::C1, Normals::Mean);
            let change = extrude(&mut body, &what, CellId(70_000)).unwrap();
            assert_eq!(change.made, [70_000, 70_001, 70_002].map(CellId));
            assert_eq!(Sharing::new(&body).shared_faces().len(), 7);
            assert_eq!(smooth_corners(&body), 28);
            assert!((volume_of(&body, &change.made) - 2.4).abs() < 1e-12);
            for id in change.made {
                let cell = body.cell(id).unwrap();
                let parent = body.cell(CellId(id.0 - 70_000)).unwrap();
                assert_eq!(cell.mix(0), parent.mix(0));
                assert!((cell.net().jacobian(DVec3::splat(0.5)) * parent.net().jacobian(DVec3::ZERO)) > 0.0);
            }
        }
    }

    /// The outside of a ring along its normals is a ring again: round within the error of its own arcs.
    #[test]
    fn a_ring_grows_to_a_ring() {
        let outside = Face { axis: Axis::V, is_end: false };
        for (normals, within) in [(Normals::Surface, 2e-4), (Normals::Mean, 0.04)] {
            let mut body = ring(8);
            let faces = (0..8).map(|n| (CellId(n), outside)).collect();
            let change =
                extrude(&mut body, &extrusion(faces, 0.25, Start::Free, normals), CellId(8)).unwrap();
            let sharing = Sharing::new(&body);
            assert_eq!((sharing.shared_faces().len(), sharing.outer_faces().len()), (24, 48));
            let mut worst = 0.0_f64;
            for id in &change.made {
                for n in 0..=20 {
                    let point = body.cell(*id).unwrap().point(DVec3::new(f64::from(n) / 20.0, 0.0, 0.5));
                    worst = worst.max((point.truncate().length() - 2.25).abs());
                }
            }
            assert!(worst < within, "{normals:?}: {worst}");
            let bits = |id: u32, face: Face| body.cell(CellId(id)).unwrap().net().face(face);
            for n in 0..8 {
                let (end, start) =
                    (Face { axis: Axis::U, is_end: true }, Face { axis: Axis::U, is_end: false });
                assert_eq!(bits(8 + n, end), bits(8 + (n + 1) % 8, start), "the same bits on both sides");
            }
            for id in change.made {
                assert_eq!(verdict(body.cell(id).unwrap().net()).verdict, Verdict::Regular);
            }
        }
    }

    /// Two faces of one cube at a right angle: the wall goes out along the diagonal, and begins free.
    #[test]
    fn faces_at_an_edge_share_a_slanted_wall() {
        let mut body = block([1, 1, 1]);
        let faces = [Axis::U, Axis::V].map(|axis| (CellId(0), Face { axis, is_end: true })).to_vec();
        let change = extrude(&mut body, &extrusion(faces, 0.3, Start::C1, Normals::Mean), CellId(1)).unwrap();
        assert_eq!(Sharing::new(&body).shared_faces().len(), 3);
        let far = body.cell(CellId(1)).unwrap().net().0[Corner([true, true, false]).coefficient()];
        let expected = DVec3::new(1.0, 1.0, 0.0) * (1.0 + 0.3 / 2.0_f64.sqrt());
        assert!(far.distance(expected) < 1e-14);
        assert!(change.made.iter().all(|id| {
            let report = verdict(body.cell(*id).unwrap().net());
            matches!(report.verdict, Verdict::Regular | Verdict::Valid)
        }));
        assert_eq!(relate(&body, CellId(1), CellId(2)).unwrap().name(), "shares");
    }

    #[test]
    fn the_material_of_the_face_goes_on_or_another_one_is_given() {
        let mut body = body_of([random_net(3, 0.05)]);
        for at in 0..64 {
            mix_coefficient(&mut body, CellId(0), at, &random_mix(at as u64)).unwrap();
        }
        move_coefficient(&mut body, CellId(0), 63, DVec3::splat(0.1), Reach::Block).unwrap();
        let face = Face { axis: Axis::W, is_end: true };
        let mut what = extrusion(vec![(CellId(0), face); 2], 0.5, Start::C1, Normals::Surface);
        extrude(&mut body, &what, CellId(1)).unwrap();
        assert_eq!(body.cells().len(), 2, "a face that is named twice counts once");
        for at in 0..64 {
            let (new, old) =
                (body.cell(CellId(1)).unwrap().mix(at), body.cell(CellId(0)).unwrap().mix(at | 3));
            assert!(new.fractions().iter().zip(old.fractions()).all(|(a, b)| (a - b).abs() < 1e-15));
        }
        assert_eq!(smooth_corners(&body), 4);
        what.mix = Some(random_mix(500));
        what.faces = vec![(CellId(1), face)];
        extrude(&mut body, &what, CellId(2)).unwrap();
        assert_eq!(body.cell(CellId(2)).unwrap().mix(9), body.cell(CellId(2)).unwrap().mix(0));
        check_body(&body);
    }

    #[test]
    fn what_does_not_apply_is_refused_and_changes_nothing() {
        let mut body = block([2, 1, 1]);
        let before = body.clone();
        let face = |axis: Axis| Face { axis, is_end: true };
        let what = |id: u32, axis: Axis, by: f64| {
            extrusion(vec![(CellId(id), face(axis))], by, Start::Free, Normals::Mean)
        };
        let inner = extrude(&mut body, &what(0, Axis::U, 1.0), CellId(9)).unwrap_err();
        assert_eq!(inner, OperationError::Inner { id: CellId(0), face: face(Axis::U), other: CellId(1) });
        assert!(inner.to_string().contains("face u1 of cell 0 is inside the body: cell 1"), "{inner}");
        for by in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(
                extrude(&mut body, &what(0, Axis::V, by), CellId(9)),
                Err(OperationError::Number { name: "the length", .. })
            ));
        }
        assert!(extrude(&mut body, &what(5, Axis::V, 1.0), CellId(9)).is_err());
        assert!(extrude(&mut body, &what(0, Axis::V, 1.0), CellId(1)).is_err());
        assert!(extrude(&mut body, &extrusion(vec![], 1.0, Start::C1, Normals::Mean), CellId(9)).is_err());
        let two = Extrusion { mix: Some(Composition::pure(0, 2)), ..what(0, Axis::V, 1.0) };
        assert!(matches!(extrude(&mut body, &two, CellId(9)), Err(OperationError::Materials { .. })));
        assert_eq!(body, before);

        let mut pinched = Net::cuboid(DVec3::ZERO, DVec3::ONE);
        for at in face(Axis::W).coefficients() {
            pinched.0[at] = DVec3::new(0.5, 0.5, 1.0);
        }
        let mut body = body_of([pinched]);
        let none = extrude(&mut body, &what(0, Axis::W, 1.0), CellId(9));
        assert_eq!(none, Err(OperationError::NoNormal { id: CellId(0), face: face(Axis::W) }));

        let mut full = Body::new(3);
        let cell = body.cells()[0].1.clone();
        for n in 0..MOST_CELLS as u32 {
            full.add_as(
                CellId(n),
                cell.with_net(cell.net().map(|p| p + DVec3::X * f64::from(n) * 2.0)).unwrap(),
            )
            .unwrap();
        }
        let error = extrude(&mut full, &what(7, Axis::U, 0.5), CellId(20_000));
        assert_eq!(error, Err(OperationError::Body(BodyError::Full)));
    }
}
