//! Giving compositions to cells, corners and coefficients (section 4.2 of the paper, Fig. 15).

use super::draft::{Draft, check_mix, chosen};
use super::star::Star;
use super::{Change, OperationError};
use crate::hyperpatch::Corner;
use crate::hyperpatch::composite::{Body, CellId};
use crate::material::Composition;

/// Gives all 64 coefficients of cells one composition.
///
/// # Errors
/// When no cell is named or one is unknown, or the mix has another number of materials than the body.
pub fn mix_cells(body: &mut Body, cells: &[CellId], mix: &Composition) -> Result<Change, OperationError> {
    check_mix(body, mix)?;
    let mut draft = Draft::default();
    for id in chosen(body, cells)? {
        for at in 0..64 {
            draft.fill(body, id, at, mix.fractions())?;
        }
    }
    draft.commit(body)
}

/// Gives a corner one composition: the 8 coefficients of its block, in every cell at the corner or in those within a
/// choice.
///
/// It is the paper's rule for a material that runs on (section 3.5, Fig. 10): the composition goes over from corner to
/// corner by smoothsteps and has slope zero at each. Within a choice of cells it runs on among these and jumps to the
/// others (Fig. 15, right); the shape is untouched.
///
/// # Errors
/// When the cell is unknown, none of the chosen cells is at the corner, or the mix has another number of materials
/// than the body.
pub fn mix_corner(
    body: &mut Body,
    cell: CellId,
    corner: Corner,
    mix: &Composition,
    within: Option<&[CellId]>,
) -> Result<Change, OperationError> {
    check_mix(body, mix)?;
    let star = Star::new(body, &[(cell, corner)])?;
    let mut draft = Draft::default();
    let mut count = 0;
    for &(id, corner, _) in &star.cells {
        if within.is_some_and(|within| !within.contains(&id)) {
            continue;
        }
        count += 1;
        for at in corner.block() {
            draft.fill(body, id, at, mix.fractions())?;
        }
    }
    if count == 0 {
        return Err(OperationError::Elsewhere { id: cell, corner });
    }
    draft.commit(body)
}

/// Gives one coefficient of one cell a composition. What it does to the continuity with neighbours is as it falls out;
/// marks that do not hold any more are dropped.
///
/// # Errors
/// When there is no such cell or coefficient, or the mix has another number of materials than the body.
pub fn mix_coefficient(
    body: &mut Body,
    cell: CellId,
    at: usize,
    mix: &Composition,
) -> Result<Change, OperationError> {
    check_mix(body, mix)?;
    if at >= 64 {
        return Err(OperationError::Coefficient { at });
    }
    let mut draft = Draft::default();
    draft.fill(body, cell, at, mix.fractions())?;
    draft.commit(body)
}

#[cfg(test)]
mod tests {
    use super::super::test_bodies::{block, check_body, random_mix, shuffled};
    use super::*;
    use crate::hyperpatch::composite::{Match, Sharing};
    use glam::DVec3;

    /// Number of corners of shared faces where the material runs on, is continuous, jumps.
    fn count(body: &Body) -> [usize; 3] {
        let faces = Sharing::new(body).continuity(body);
        let of = |wanted: Match| {
            faces.iter().flat_map(|face| face.corners).filter(|corner| corner.material == wanted).count()
        };
        [of(Match::C1), of(Match::Block), of(Match::None)]
    }

    #[test]
    fn cells_get_one_composition_throughout() {
        let mut body = block([2, 2, 2]);
        let all: Vec<CellId> = (0..8).map(CellId).collect();
        mix_cells(&mut body, &all, &random_mix(1)).unwrap();
        assert_eq!(count(&body), [48, 0, 0]);
        let change = mix_cells(&mut body, &[CellId(3)], &random_mix(2)).unwrap();
        assert_eq!(change.touched, [CellId(3)]);
        let mix = random_mix(2);
        let lists = body.cell(CellId(3)).unwrap().fractions().iter().zip(mix.fractions());
        assert!(lists.clone().all(|(list, fraction)| *list == [*fraction; 64]));
        assert_eq!(count(&body), [36, 0, 12]);
        check_body(&body);
    }

    /// The paper's rule at a corner: smoothsteps of the distance along the parameters, in all cells.
    #[test]
    fn a_corner_runs_on_in_all_its_cells_or_within_a_choice() {
        let mut body = shuffled(&block([2, 2, 2]), 5);
        let all: Vec<CellId> = (0..8).map(CellId).collect();
        let (base, mix) = (random_mix(3), random_mix(4));
        mix_cells(&mut body, &all, &base).unwrap();
        let corner = |body: &Body| {
            let net = body.cell(CellId(2)).unwrap().net().corners();
            Corner::all()[net.iter().position(|p| p.distance(DVec3::ONE) < 1e-9).unwrap()]
        };
        let at = corner(&body);
        let change = mix_corner(&mut body, CellId(2), at, &mix, None).unwrap();
        assert_eq!(change.touched.len(), 8);
        assert_eq!(count(&body), [48, 0, 0]);
        for (_, cell) in body.cells() {
            let place = DVec3::new(0.3, 0.8, 0.45);
            let near = cell.net().corners().map(|p| p.distance(DVec3::ONE) < 1e-9);
            let corner = Corner::all()[near.iter().position(|is_near| *is_near).unwrap()].parameters();
            let t = DVec3::ONE - (place - corner).abs();
            let step = t * t * (3.0 - 2.0 * t);
            let expected = base.mix(&mix, step.x * step.y * step.z);
            let found = cell.composition(place);
            let pairs = found.fractions().iter().zip(expected.fractions());
            assert!(pairs.clone().all(|(a, b)| (a - b).abs() < 1e-14));
        }
        mix_cells(&mut body, &all, &base).unwrap();
        let change = mix_corner(&mut body, CellId(2), at, &mix, Some(&[CellId(0), CellId(1)])).unwrap();
        assert_eq!(change.touched, [CellId(0), CellId(1)]);
        // One face between the two; four faces lead to the other cells and jump at this corner.
        assert_eq!(count(&body), [44, 0, 4]);
        let outside = mix_corner(&mut body, CellId(0), Corner([false; 3]), &mix, Some(&[]));
        assert!(matches!(outside, Err(OperationError::Elsewhere { .. })));
        check_body(&body);
    }

    #[test]
    fn one_coefficient_is_one_coefficient() {
        let mut body = block([2, 1, 1]);
        let before = body.clone();
        mix_coefficient(&mut body, CellId(1), 22, &random_mix(6)).unwrap();
        let (now, was) = (body.cell(CellId(1)).unwrap(), before.cell(CellId(1)).unwrap());
        assert!((0..64).all(|at| (now.mix(at) == was.mix(at)) == (at != 22)));
        assert_eq!(now.net(), was.net());
        let wrong = mix_coefficient(&mut body, CellId(1), 0, &Composition::pure(0, 2));
        assert_eq!(wrong, Err(OperationError::Materials { count: 2, expected: 3 }));
        assert!(mix_coefficient(&mut body, CellId(1), 64, &random_mix(6)).is_err());
    }
}
