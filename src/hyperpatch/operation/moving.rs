//! Moving corners and their neighbours.

use super::draft::Draft;
use super::nearest::nearest;
use super::star::{Kind, Star, Weave};
use super::{Change, OperationError};
use crate::hyperpatch::Corner;
use crate::hyperpatch::composite::{Body, CellId, Match};
use glam::DVec3;

/// What a move takes along.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reach {
    /// A corner takes its block along in every cell that shares it; a neighbour of a corner, what must move for the
    /// shape to run on where it does.
    Block,
    /// The coefficient alone, with its equal copies in cells that share it.
    Single,
}

/// Rounding of a line, over the size of its coordinates, that is left as it is.
const ROUNDING: f64 = 1e-15;

/// What would move with a coefficient: cells, places in their lists of 64, and shares of the displacement.
///
/// A corner takes its whole block along (section 4.1 of the paper, Fig. 14b). A neighbour of a corner moves what must
/// follow for Eq. 7 to hold where the shape runs on (Fig. 14c, by the repaired rule), and nothing else (Fig. 14d): at a
/// regular corner of eight cells that run on across all faces 18 of the 26 neighbours when it lies on an edge, 12 on a
/// face, 8 inside a cell. Corners whose cells do not lie in a grid are creases: there only equal copies follow.
///
/// # Errors
/// When there is no such cell or coefficient, or more than 256 corners of cells lie at its corner.
pub fn moves(
    body: &Body,
    cell: CellId,
    at: usize,
    reach: Reach,
) -> Result<Vec<(CellId, usize, f64)>, OperationError> {
    let (star, number) = star_of(body, cell, at)?;
    let weave = star.weave(Kind::Shape, body.tolerance());
    let mut list = Vec::new();
    for (class, share) in shares(&weave, number, reach) {
        for &member in &weave.members[class] {
            let (id, at) = star.coefficient(member);
            list.push((id, at, share));
        }
    }
    list.sort_unstable_by_key(|(id, at, _)| (*id, *at));
    Ok(list)
}

/// Moves a coefficient, and with it what [`moves`] says.
///
/// Copies of a coefficient that cells share get the same bits. Where the shape is marked to run on it does so
/// afterwards up to rounding, however often it was moved before; a mark that a single coefficient breaks is dropped.
///
/// # Errors
/// When there is no such cell or coefficient, more than 256 corners of cells lie at its corner, or a coordinate is not
/// finite or too large.
pub fn move_coefficient(
    body: &mut Body,
    cell: CellId,
    at: usize,
    by: DVec3,
    reach: Reach,
) -> Result<Change, OperationError> {
    if let Some(value) = by.to_array().into_iter().find(|x| !x.is_finite()) {
        return Err(OperationError::Number { name: "the displacement", value, expected: "finite numbers" });
    }
    let (star, number) = star_of(body, cell, at)?;
    let weave = star.weave(Kind::Shape, body.tolerance());
    let mut values: Vec<DVec3> = weave.members.iter().map(|list| star.position(list[0])).collect();
    let before = values.clone();
    for (class, share) in shares(&weave, number, reach) {
        values[class] += by * share;
    }
    if reach == Reach::Block && is_marked(&star) {
        straighten(&mut values, &weave);
    }
    let mut draft = Draft::default();
    for (class, (value, old)) in values.iter().zip(&before).enumerate() {
        let is_moved = value != old;
        for &member in &weave.members[class] {
            if is_moved && star.position(member) != *value {
                let (id, at) = star.coefficient(member);
                draft.place(body, id, at, *value)?;
            }
        }
    }
    draft.commit(body)
}

/// The star of the corner whose block has a coefficient, and the number of the coefficient in it.
fn star_of(body: &Body, cell: CellId, at: usize) -> Result<(Star<'_>, usize), OperationError> {
    if at >= 64 {
        return Err(OperationError::Coefficient { at });
    }
    let (corner, bits) = Corner::of(at);
    let star = Star::new(body, &[(cell, corner)])?;
    let place = star.place(cell, corner).unwrap_or(0);
    Ok((star, place * 8 + bits))
}

/// Classes that move, with their shares.
fn shares(weave: &Weave, number: usize, reach: Reach) -> Vec<(usize, f64)> {
    match reach {
        Reach::Single => vec![(weave.class[number], 1.0)],
        Reach::Block if number.is_multiple_of(8) => {
            let together = weave.together(number / 8);
            let numbers = together.into_iter().flat_map(|place| (0..8).map(move |n| place * 8 + n));
            let mut classes: Vec<usize> = numbers.map(|number| weave.class[number]).collect();
            classes.sort_unstable();
            classes.dedup();
            classes.into_iter().map(|class| (class, 1.0)).collect()
        }
        Reach::Block => weave.follow(number),
    }
}

/// Whether somebody wants the shape to run on somewhere at a corner.
fn is_marked(star: &Star<'_>) -> bool {
    star.joints.iter().any(|joint| joint.is_marked[0] && joint.holds[0] == Match::C1)
}

/// Takes out of lines the rounding that moves have left, by the nearest positions.
pub(super) fn straighten(values: &mut [DVec3], weave: &Weave) {
    let largest = values.iter().fold(0.0_f64, |largest, p| largest.max(p.abs().max_element()));
    let bend = weave.lines.iter().map(|line| {
        let [a, b, c] = line.classes.map(|class| values[class]);
        ((b - a) - (c - b)).length()
    });
    if bend.fold(0.0, f64::max) > ROUNDING * largest {
        nearest(values, &weave.conditions(), &vec![false; values.len()]);
    }
}

#[cfg(test)]
mod tests {
    use super::super::test_bodies::{
        at_point, block, body_of, check_body, fan, random_vector, ring, shuffled, smooth_corners,
    };
    use super::*;
    use crate::hyperpatch::composite::{BodyError, Sharing};
    use crate::hyperpatch::test_cells::random;
    use crate::hyperpatch::{CellError, Net};

    /// The middle of a block of eight unit cubes.
    const MIDDLE: DVec3 = DVec3::ONE;

    fn distinct(list: &[(CellId, usize, f64)], body: &Body) -> Vec<(DVec3, f64)> {
        let mut points: Vec<(DVec3, f64)> = Vec::new();
        for (id, at, share) in list {
            let point = body.cell(*id).unwrap().net().0[*at];
            match points.iter().find(|(other, _)| other.distance(point) < 1e-9) {
                Some((_, known)) => assert_eq!(known, share, "copies move alike"),
                None => points.push((point, *share)),
            }
        }
        points
    }

    /// The repaired rule in its closed form, in all ways in which parameters of the cells may run.
    #[test]
    fn neighbours_of_a_regular_corner_follow_by_products_of_offsets() {
        for seed in 0..6 {
            let body = shuffled(&block([2, 2, 2]), seed);
            let expected = |offset: DVec3| offset.to_array().iter().filter(|x| **x == 0.0).count();
            for n in 0..27 {
                let offset = DVec3::new((n / 9) as f64, (n / 3 % 3) as f64, (n % 3) as f64) - 1.0;
                let point = MIDDLE + offset / 3.0;
                let id = Sharing::new(&body).points(CellId(0)).map_or(0, |_| {
                    let has = |id: &u32| {
                        body.cell(CellId(*id)).unwrap().net().0.iter().any(|p| p.distance(point) < 1e-9)
                    };
                    (0..8).find(has).unwrap()
                });
                let list = moves(&body, CellId(id), at_point(&body, id, point), Reach::Block).unwrap();
                let points = distinct(&list, &body);
                assert_eq!(points.len(), [8, 12, 18, 27][expected(offset)], "offset {offset}");
                for (point, share) in points {
                    let other = (point - MIDDLE) * 3.0;
                    let product: f64 = (0..3)
                        .filter(|axis| offset[*axis] != 0.0)
                        .map(|axis| (other[axis] * offset[axis]).round())
                        .product();
                    assert_eq!(share, product, "offset {offset}, other {other}");
                }
            }
        }
    }

    /// The paper's Eq. 8 moves the opposite neighbour alone: the shape breaks across the faces that the moved line lies
    /// in. The repaired rule keeps all twelve faces.
    #[test]
    fn the_printed_rule_breaks_the_shape_at_the_other_cells_and_the_repaired_one_does_not() {
        let by = DVec3::new(0.02, 0.05, -0.03);
        let [right, left] = [1.0, -1.0].map(|x| MIDDLE + DVec3::X * x / 3.0);
        let mut printed = block([2, 2, 2]);
        assert_eq!(smooth_corners(&printed), 48);
        let (a, b) = (at_point(&printed, 7, right), at_point(&printed, 0, left));
        move_coefficient(&mut printed, CellId(7), a, by, Reach::Single).unwrap();
        move_coefficient(&mut printed, CellId(0), b, -by, Reach::Single).unwrap();
        // Across the four faces that the line crosses it still runs on, across the eight beside it not.
        assert_eq!(smooth_corners(&printed), 40);

        let mut repaired = block([2, 2, 2]);
        move_coefficient(&mut repaired, CellId(7), a, by, Reach::Block).unwrap();
        assert_eq!(smooth_corners(&repaired), 48);
        assert_eq!(repaired.cell(CellId(0)).unwrap().net().0[b], left - by);
    }

    #[test]
    fn a_corner_takes_its_block_along_in_every_cell() {
        let mut body = shuffled(&block([2, 2, 2]), 3);
        let before = body.clone();
        let at = at_point(&body, 5, MIDDLE);
        let change = move_coefficient(&mut body, CellId(5), at, DVec3::Z * 0.1, Reach::Block).unwrap();
        assert_eq!(change.touched, (0..8).map(CellId).collect::<Vec<_>>());
        for ((_, now), (_, was)) in body.cells().iter().zip(before.cells()) {
            for (p, q) in now.net().0.iter().zip(&was.net().0) {
                let is_near = (*q - MIDDLE).abs().max_element() < 0.34;
                assert!((*p - *q - DVec3::Z * if is_near { 0.1 } else { 0.0 }).length() < 1e-15);
            }
        }
        assert_eq!(smooth_corners(&body), 48);
        move_coefficient(&mut body, CellId(5), at, DVec3::Z * -0.1, Reach::Block).unwrap();
        let pairs = body.cells().iter().zip(before.cells());
        assert!(
            pairs
                .flat_map(|(a, b)| a.1.net().0.into_iter().zip(b.1.net().0))
                .all(|(p, q)| { p.distance(q) < 1e-15 })
        );
    }

    /// Three, five or six cells round an edge: equal copies follow, nothing else.
    #[test]
    fn irregular_corners_are_creases() {
        for count in [3, 5, 6] {
            let body = shuffled(&fan(count), count as u64);
            let spoke = at_point(&body, 0, DVec3::X / 3.0);
            let list = moves(&body, CellId(0), spoke, Reach::Block).unwrap();
            assert_eq!(list.len(), 2, "{count} cells");
            let axis = at_point(&body, 0, DVec3::Z / 3.0);
            assert_eq!(moves(&body, CellId(0), axis, Reach::Block).unwrap().len(), count);
            let middle = at_point(&body, 0, DVec3::ZERO);
            assert_eq!(moves(&body, CellId(0), middle, Reach::Block).unwrap().len(), 8 * count);
        }
    }

    /// Where the shape bends already, nothing is kept that is not there.
    #[test]
    fn a_crease_between_two_cells_stays_free() {
        let body =
            body_of([Net::cuboid(DVec3::ZERO, DVec3::ONE), Net::cuboid(DVec3::X, DVec3::new(3.0, 1.0, 1.0))]);
        let at = at_point(&body, 1, DVec3::X * (1.0 + 2.0 / 3.0));
        assert_eq!(moves(&body, CellId(1), at, Reach::Block).unwrap(), [(CellId(1), at, 1.0)]);
    }

    /// Cells that only have an edge in common share its coefficients and nothing else.
    #[test]
    fn cells_at_an_edge_move_it_together() {
        let body = body_of([DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)].map(|p| Net::cuboid(p, p + 1.0)));
        let at = at_point(&body, 0, DVec3::new(1.0, 1.0, 1.0 / 3.0));
        assert_eq!(moves(&body, CellId(0), at, Reach::Block).unwrap().len(), 2);
        let corner = at_point(&body, 0, DVec3::new(1.0, 1.0, 1.0));
        assert_eq!(moves(&body, CellId(0), corner, Reach::Block).unwrap().len(), 16);
    }

    /// Shared coefficients keep equal bits, and what runs on goes on doing so.
    #[test]
    fn many_moves_keep_shared_coefficients_equal() {
        for start in [shuffled(&block([2, 2, 2]), 1), ring(8)] {
            let mut body = start.clone();
            let smooth = smooth_corners(&body);
            for seed in 0..60 {
                let id = CellId((random(seed * 7) * 8.0) as u32);
                let at = (random(seed * 7 + 1) * 64.0) as usize;
                move_coefficient(&mut body, id, at, random_vector(seed) * 0.02, Reach::Block).unwrap();
            }
            assert_eq!(smooth_corners(&body), smooth);
            check_body(&body);
            let sharing = Sharing::new(&body);
            for face in sharing.shared_faces() {
                let [(a, f), (b, g)] = face.sides;
                let (p, q) = (body.cell(a).unwrap().net().face(f), body.cell(b).unwrap().net().face(g));
                assert!((0..16).all(|n| p[n] == q[face.matching.coefficient(n)]));
            }
        }
    }

    /// As many cells in one place as a body may have are refused, not compared pair by pair.
    #[test]
    fn crowded_corners_are_refused() {
        let cube = || Net::cuboid(DVec3::ZERO, DVec3::ONE);
        let mut few = body_of((0..256).map(|_| cube()));
        let change = move_coefficient(&mut few, CellId(3), 63, DVec3::X, Reach::Block).unwrap();
        assert_eq!(change.touched.len(), 256);
        let mut many = body_of((0..10_000).map(|_| cube()));
        let error = move_coefficient(&mut many, CellId(3), 63, DVec3::X, Reach::Block).unwrap_err();
        assert!(error.to_string().contains("more than 256 corners of cells"), "{error}");
    }

    #[test]
    fn what_does_not_apply_is_refused_and_changes_nothing() {
        let mut body = block([2, 1, 1]);
        let before = body.clone();
        let mut go = |id: u32, at: usize, by: DVec3| {
            move_coefficient(&mut body, CellId(id), at, by, Reach::Block).unwrap_err()
        };
        assert_eq!(go(9, 0, DVec3::X), OperationError::Body(BodyError::Unknown { id: CellId(9) }));
        assert_eq!(go(0, 64, DVec3::X), OperationError::Coefficient { at: 64 });
        assert!(matches!(go(0, 0, DVec3::X * f64::NAN), OperationError::Number { .. }));
        let far = go(0, 63, DVec3::X * 2e9);
        assert!(matches!(&far, OperationError::Cell { error: CellError::Position { .. }, .. }), "{far}");
        assert_eq!(body, before);
    }
}
