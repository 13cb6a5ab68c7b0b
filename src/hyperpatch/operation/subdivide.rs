//! Cutting cells in two, through the whole sheet of cells that the cut must go on through.

use super::draft::{identifiers, settle};
use super::{Change, OperationError};
use crate::hyperpatch::composite::{Body, BodyError, CellId, MOST_CELLS, Mark, Marks, Side};
use crate::hyperpatch::{Axis, Cell, CellError, Edge};
use glam::DVec3;
use std::collections::{BTreeMap, HashSet};

/// How a cell lies in the sheet: the axis that it is cut across, and whether the axis runs against that of the first
/// cell.
type Course = (Axis, bool);

/// Cuts a cell in two across an axis at `t`, and with it every cell that has a cut edge in common with it, and so on,
/// so that cells meet as before in whole corners, edges and faces. The cells of the sheet are removed, and for each, by
/// its identifier, two are made: that at the start of its axis and that at the end, with the identifiers from `first`
/// on.
///
/// By de Casteljau's algorithm nothing changes in shape or material; only on faces where the material jumps another side
/// may decide, as the parts have new identifiers and the lowest one decides there. Marks stay, and hold for the new corners where
/// they hold at both ends of an edge; across the ends of the cut cells the parameters run on at another rate, so that
/// marks of first order are dropped there unless the derivative is zero.
///
/// # Errors
/// When there is no such cell, `t` is not between 0 and 1, the sheet comes back to a cell that it has gone through
/// already along another axis or the other way round (which at `t` = 0.5 is the same place), an identifier is taken, or
/// there would be too many cells.
pub fn subdivide(
    body: &mut Body,
    cell: CellId,
    axis: Axis,
    t: f64,
    first: CellId,
) -> Result<Change, OperationError> {
    if !(t > 0.0 && t < 1.0) {
        return Err(OperationError::Number {
            name: "the parameter",
            value: t,
            expected: "more than 0 and less than 1",
        });
    }
    let sheet = sheet(body, cell, axis, t)?;
    let removed: Vec<CellId> = sheet.keys().copied().collect();
    let made = identifiers(body, first, 2 * removed.len(), removed.len())?;
    let mut parts = Vec::with_capacity(made.len());
    for (id, &(axis, is_reversed)) in &sheet {
        let Some(cell) = body.cell(*id) else { continue };
        let halves =
            halves(cell, axis, is_reversed, t).map_err(|error| OperationError::Cell { id: *id, error })?;
        parts.extend(halves);
    }
    let marks = marks_of_parts(body.marks(), &sheet, &removed, &made);
    body.remove_all(&removed);
    for (id, part) in made.iter().zip(parts) {
        body.add_as(*id, part)?;
    }
    marks.into_iter().for_each(|(side, mark)| body.mark(side, mark));
    settle(body, &made);
    Ok(Change { made, removed, ..Change::default() })
}

/// Every cell that a cut goes through, from edge to edge.
///
/// # Errors
/// When it meets itself, or there would be too many cells.
fn sheet(body: &Body, cell: CellId, axis: Axis, t: f64) -> Result<BTreeMap<CellId, Course>, OperationError> {
    if body.cell(cell).is_none() {
        return Err(BodyError::Unknown { id: cell }.into());
    }
    let tolerance = body.tolerance();
    let mut edges = Edges::default();
    let mut sheet = BTreeMap::from([(cell, (axis, false))]);
    let mut queue = vec![cell];
    while let Some(id) = queue.pop() {
        if body.cells().len() + sheet.len() > MOST_CELLS {
            return Err(BodyError::Full.into());
        }
        let (Some(cell), Some(&(axis, is_reversed))) = (body.cell(id), sheet.get(&id)) else { continue };
        for edge in Edge::all().into_iter().filter(|edge| edge.axis == axis) {
            let points = cell.net().edge(edge);
            // An edge without length is not cut.
            if points.iter().all(|p| p.distance(points[0]) <= tolerance) {
                continue;
            }
            for (other, axis, runs_back) in edges.take(body, id, edge, tolerance) {
                let course = (axis, is_reversed != runs_back);
                match sheet.get(&other) {
                    None => {
                        sheet.insert(other, course);
                        queue.push(other);
                    }
                    Some(&known) if known == course || known.0 == axis && t == 0.5 => {}
                    Some(_) => return Err(OperationError::SheetMeetsItself { id: other }),
                }
            }
        }
    }
    Ok(sheet)
}

/// Edges that a sheet has gone through.
#[derive(Default)]
struct Edges {
    /// Places of cells in the order of the body, with their edges.
    taken: HashSet<(usize, Edge)>,
}

impl Edges {
    /// Takes what lies on an edge of a cell, that one included: cells, axes along which their edges run, and whether
    /// they run the other way. What was taken before is not found again, so that equal edges are looked for once.
    fn take(&mut self, body: &Body, id: CellId, edge: Edge, tolerance: f64) -> Vec<(CellId, Axis, bool)> {
        let Ok(index) = body.cells().binary_search_by_key(&id, |(id, _)| *id) else { return Vec::new() };
        if self.taken.contains(&(index, edge)) {
            return Vec::new();
        }
        let points = body.cells()[index].1.net().edge(edge);
        let (lo, hi) = (points[0].min(points[3]) + tolerance, points[0].max(points[3]) - tolerance);
        let is_one = |a: DVec3, b: DVec3| a.distance(b) <= tolerance;
        let mut found = Vec::new();
        for (index, bounds) in body.boxes().iter().enumerate() {
            if !(bounds.0.cmple(lo).all() && hi.cmple(bounds.1).all()) {
                continue;
            }
            let (id, cell) = &body.cells()[index];
            for edge in Edge::all() {
                let other = cell.net().edge(edge);
                let runs_on = (0..4).all(|n| is_one(points[n], other[n]));
                let is_on = runs_on || (0..4).all(|n| is_one(points[n], other[3 - n]));
                if is_on && self.taken.insert((index, edge)) {
                    found.push((*id, edge.axis, !runs_on));
                }
            }
        }
        found
    }
}

/// The parts of a cell at the start and at the end of an axis. Cells that lie the other way round are cut the other way
/// round, so that coefficients that are equal are cut into equal ones, bit for bit.
fn halves(cell: &Cell, axis: Axis, is_reversed: bool, t: f64) -> Result<[Cell; 2], CellError> {
    if !is_reversed {
        return cell.split(axis, t);
    }
    let [end, start] = cell.reversed(axis).split(axis, t)?;
    Ok([start.reversed(axis), end.reversed(axis)])
}

/// The marks of the parts: those of the cells, and between these at the corners where the cut is those that both ends
/// of the edge have.
fn marks_of_parts(
    marks: &Marks,
    sheet: &BTreeMap<CellId, Course>,
    removed: &[CellId],
    made: &[CellId],
) -> Vec<(Side, Mark)> {
    let axis = |side: Side| sheet.get(&side.cell).map(|course| course.0);
    // The part of a side's cell at its corner, or at the other end of the edge that is cut.
    let part = |side: Side, is_far: bool| {
        let (Some(axis), Ok(place)) = (axis(side), removed.binary_search(&side.cell)) else { return side };
        let is_end = side.corner.0[axis as usize] != is_far;
        Side { cell: made[2 * place + usize::from(is_end)], ..side }
    };
    let far = |mut side: Side| {
        let end = &mut side.corner.0[axis(side)? as usize];
        *end = !*end;
        Some(side)
    };
    let mut found = Vec::new();
    for (side, mark) in marks.iter() {
        if axis(side).is_none() && axis(mark.other).is_none() {
            continue;
        }
        found.push((part(side, false), Mark { other: part(mark.other, false), ..mark }));
        let twin = far(side).filter(|_| axis(side) != Some(side.axis)).and_then(|side| marks.get(side));
        let Some((twin, end)) = twin.zip(far(mark.other)) else { continue };
        if twin.other == end {
            // The part here ends where the edge went on: its new corner is called as the far one was.
            let weaker = |a: Option<_>, b: Option<_>| a.zip(b).map(|(a, b)| Ord::min(a, b));
            let both = Mark {
                other: Side { cell: part(mark.other, false).cell, ..end },
                shape: weaker(mark.shape, twin.shape),
                material: weaker(mark.material, twin.material),
                ..mark
            };
            found.push((Side { cell: part(side, false).cell, ..far(side).unwrap_or(side) }, both));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::super::test_bodies::{
        block, body_of, check_body, fan, random_mix, random_vector, ring, shuffled, smooth_corners,
    };
    use super::super::{Reach, mix_coefficient, move_coefficient};
    use super::*;
    use crate::hyperpatch::composite::{Match, Probe, Sharing};
    use crate::hyperpatch::test_cells::{closed_bar, random_place};
    use crate::hyperpatch::{Corner, Net};

    /// A body with shapes and mixes of all sorts.
    fn rich(start: &Body, seed: u64) -> Body {
        let mut body = shuffled(start, seed);
        let ids: Vec<CellId> = body.cells().iter().map(|(id, _)| *id).collect();
        for (n, id) in ids.iter().enumerate() {
            for at in 0..64 {
                mix_coefficient(&mut body, *id, at, &random_mix(seed * 999 + n as u64 * 64 + at as u64))
                    .unwrap();
            }
            let by = random_vector(seed + n as u64) * 0.03;
            move_coefficient(&mut body, *id, (n * 13 + 5) % 64, by, Reach::Block).unwrap();
        }
        body
    }

    /// Every part of the body is what it was: volume, amounts, points and mixes; the parts meet in whole faces.
    #[test]
    fn the_body_stays_what_it_is_and_its_cells_meet_in_whole_faces() {
        for (seed, start) in [block([2, 2, 2]), ring(8), fan(5)].into_iter().enumerate() {
            for (axis, t) in [(Axis::U, 0.5), (Axis::V, 0.25), (Axis::W, 0.7)] {
                let before = rich(&start, seed as u64);
                let faces = Sharing::new(&before);
                let (inner, outer) = (faces.shared_faces().len(), faces.outer_faces().len());
                let mut body = before.clone();
                let change = subdivide(&mut body, CellId(1), axis, t, CellId(40_000)).unwrap();
                assert_eq!(change.made.len(), 2 * change.removed.len());
                assert!(change.removed.contains(&CellId(1)));
                assert!((body.volume() - before.volume()).abs() < 1e-12);
                let amounts = body.amounts().into_iter().zip(before.amounts());
                assert!(amounts.clone().all(|(a, b)| (a - b).abs() < 1e-12));
                // Each cut cell has four faces beside the cut; a shared one makes one more, and so does the cut.
                let now = Sharing::new(&body);
                let cut = change.removed.len();
                let (more_inner, more_outer) =
                    (now.shared_faces().len() - inner - cut, now.outer_faces().len() - outer);
                assert_eq!(2 * more_inner + more_outer, 4 * cut, "no face is cut on one side alone");
                assert!(now.contacts(&body).is_empty());
                for face in now.shared_faces() {
                    let [(a, f), (b, g)] = face.sides;
                    let [p, q] = [(a, f), (b, g)].map(|(id, f)| body.cell(id).unwrap().net().face(f));
                    assert!((0..16).all(|n| p[n].distance(q[face.matching.coefficient(n)]) < 1e-14));
                }
                let (probe, old) = (Probe::new(&body), Probe::new(&before));
                for (id, cell) in before.cells() {
                    for n in 0..8 {
                        let place = random_place(n + 8 * u64::from(id.0)) * 0.96 + 0.02;
                        let point = cell.point(place);
                        let found = probe.place(point).expect("the point is still inside");
                        let part = body.cell(found.cell).unwrap();
                        assert!(part.point(found.at).distance(point) < 1e-9);
                        let (a, b) = (part.composition(found.at), old.composition(point).unwrap());
                        assert!(a.fractions().iter().zip(b.fractions()).all(|(a, b)| (a - b).abs() < 1e-8));
                    }
                }
                check_body(&body);
            }
        }
    }

    /// Cut in the middle a smooth body stays smooth everywhere; elsewhere the parameters run on at two rates across the
    /// cut itself.
    #[test]
    fn a_smooth_body_cut_in_the_middle_is_smooth() {
        let mut body = ring(8);
        subdivide(&mut body, CellId(2), Axis::V, 0.5, CellId(100)).unwrap();
        assert_eq!((body.cells().len(), smooth_corners(&body)), (16, 4 * 24));
        let mut body = ring(8);
        subdivide(&mut body, CellId(2), Axis::V, 0.25, CellId(100)).unwrap();
        assert_eq!((body.cells().len(), smooth_corners(&body)), (16, 4 * 16));
        // Across the ends of the parts, too: the neighbours along u are not cut.
        let mut body = ring(8);
        let change = subdivide(&mut body, CellId(2), Axis::U, 0.5, CellId(100)).unwrap();
        assert_eq!((change.removed, change.made), (vec![CellId(2)], [100, 101].map(CellId).to_vec()));
        assert_eq!(smooth_corners(&body), 4 * 7);
    }

    #[test]
    fn marks_stay_with_the_parts_and_hold_where_both_ends_have_them() {
        let side = |cell: u32, end: bool, v: bool, w: bool| Side {
            cell: CellId(cell),
            corner: Corner([end, v, w]),
            axis: Axis::U,
        };
        let mut body = block([2, 1, 1]);
        for (v, w, shape) in [
            (false, false, Match::C1),
            (true, false, Match::Block),
            (false, true, Match::None),
            (true, true, Match::C1),
        ] {
            let other = side(1, false, v, w);
            let mark = Mark { other, is_swapped: false, shape: Some(shape), material: None };
            body.mark(side(0, true, v, w), mark);
        }
        subdivide(&mut body, CellId(1), Axis::V, 0.5, CellId(10)).unwrap();
        let found = |cell: u32, v: bool, w: bool| {
            let mark = body.marks().get(side(cell, true, v, w))?;
            assert_eq!(mark.other, side(cell + 2, false, v, w));
            mark.shape
        };
        let [c1, c0, none] = [Match::C1, Match::Block, Match::None].map(Some);
        assert_eq!([found(10, false, false), found(10, true, false)], [c1, c0]);
        assert_eq!([found(11, false, false), found(11, true, false)], [c0, c0]);
        assert_eq!([found(10, false, true), found(10, true, true)], [none, none]);
        assert_eq!([found(11, false, true), found(11, true, true)], [none, c1]);
        // Cut along the other way, what was smooth is no more in its parameters, and what was let go stays so.
        let mut body = block([2, 1, 1]);
        let mark = Mark { other: side(1, false, true, true), is_swapped: false, shape: c1, material: None };
        body.mark(side(0, true, true, true), mark);
        let mark =
            Mark { other: side(1, false, false, false), is_swapped: false, shape: none, material: None };
        body.mark(side(0, true, false, false), mark);
        subdivide(&mut body, CellId(0), Axis::U, 0.5, CellId(10)).unwrap();
        assert_eq!(body.marks().get(side(11, true, true, true)), None);
        let kept = body.marks().get(side(1, false, false, false)).unwrap();
        assert_eq!((kept.other, kept.shape), (side(11, true, false, false), none));
    }

    /// A cube, and a cell that leads from its end back to its start with the coefficients of the face in another order.
    fn band(order: impl Fn(usize, usize) -> (usize, usize)) -> Body {
        let cube = Net::cuboid(DVec3::ZERO, DVec3::ONE);
        let back = |n: usize| {
            let (j, k) = order(n / 4 % 4, n % 4);
            cube.0[48 + n % 16].lerp(cube.0[j * 4 + k], (n / 16) as f64 / 3.0)
        };
        body_of([cube.clone(), Net(std::array::from_fn(back))])
    }

    #[test]
    fn a_sheet_that_meets_itself_is_refused() {
        let cut = |body: &Body, axis: Axis, t: f64| {
            let mut cut = body.clone();
            let result = subdivide(&mut cut, CellId(0), axis, t, CellId(10));
            assert_eq!(cut == *body, result.is_err());
            result.map(|change| change.made.len())
        };
        let meets = Err(OperationError::SheetMeetsItself { id: CellId(1) });
        // Back as it was; upside down; turned by a quarter.
        let straight = band(|j, k| (j, k));
        assert_eq!((cut(&straight, Axis::V, 0.3), cut(&straight, Axis::U, 0.3)), (Ok(4), Ok(4)));
        let half = band(|j, k| (3 - j, 3 - k));
        assert_eq!((cut(&half, Axis::V, 0.3), cut(&half, Axis::V, 0.5)), (meets.clone(), Ok(4)));
        let quarter = band(|j, k| (k, 3 - j));
        assert_eq!((cut(&quarter, Axis::V, 0.3), cut(&quarter, Axis::V, 0.5)), (meets.clone(), meets));
        // A bar whose two ends are one face.
        let bar = body_of([closed_bar()]);
        assert_eq!((cut(&bar, Axis::U, 0.3), cut(&bar, Axis::V, 0.3)), (Ok(2), Ok(2)));
    }

    #[test]
    fn what_does_not_apply_is_refused_and_changes_nothing() {
        let mut body = block([2, 2, 1]);
        for t in [0.0, 1.0, f64::NAN, -3.0] {
            let error = subdivide(&mut body, CellId(0), Axis::U, t, CellId(10)).unwrap_err();
            assert!(error.to_string().contains("more than 0"), "{error}");
        }
        let taken = Err(OperationError::Body(BodyError::Taken { id: CellId(3) }));
        assert_eq!(
            subdivide(&mut body, CellId(0), Axis::U, 0.5, CellId(1)),
            Err(BodyError::Taken { id: CellId(1) }.into())
        );
        assert_eq!(subdivide(&mut body, CellId(1), Axis::U, 0.5, CellId(3)), taken);
        assert!(subdivide(&mut body, CellId(7), Axis::U, 0.5, CellId(10)).is_err());
        assert_eq!(body, block([2, 2, 1]));

        let mut full = Body::new(3);
        let cell = body.cells()[0].1.clone();
        for n in 0..MOST_CELLS as u32 {
            full.add_as(CellId(n), cell.clone()).unwrap();
        }
        let error = subdivide(&mut full, CellId(0), Axis::U, 0.5, CellId(20_000));
        assert_eq!(error, Err(OperationError::Body(BodyError::Full)));
        // Half as many in one place: all are cut.
        let half: Vec<CellId> = (0..MOST_CELLS as u32 / 2).map(CellId).collect();
        super::super::delete(&mut full, &half).unwrap();
        let change = subdivide(&mut full, CellId(7_000), Axis::U, 0.5, CellId(20_000)).unwrap();
        assert_eq!((change.made.len(), full.cells().len()), (MOST_CELLS, MOST_CELLS));
    }
}
