//! How the material slopes at a corner.

use super::draft::Draft;
use super::material::pair;
use super::star::{Kind, Star, Weave};
use super::{Change, OperationError};
use crate::hyperpatch::Corner;
use crate::hyperpatch::bernstein::flat;
use crate::hyperpatch::composite::{Body, BodyError, CellId};

/// Rules for the compositions round a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Slope {
    /// The paper's rule (section 3.5, Fig. 10): those of the corner, so that the slope is zero and a gradient over
    /// several cells becomes a staircase.
    Flat,
    /// The mean of the slopes to the next corners on either side, as far as both sides stay in the simplex: a gradient
    /// that is linear from corner to corner becomes linear throughout.
    Natural,
}

/// Gives the material a slope at a corner, in the cells round it whose compositions are those of the named one there;
/// cells across a jump keep theirs and their own. The composition of the corner stays.
///
/// By the natural rule the coefficient at offset n has the composition `a + sum n_k t_k`, without twist. Each `t_k` is
/// a sixth of the difference between the next corners along its axis, projected so that a - t and a + t are both
/// compositions ([`pair`]); at the end of the body, where one side is all there is, a third of the difference to it.
/// Several axes are scaled by the largest s up to 1 for which every coefficient is in the simplex, which for eight
/// cells is `min_i a_i / sum_k |t_k,i|`.
///
/// # Errors
/// When there is no such cell; for the natural rule, when the cells at the corner do not lie in a grid.
pub fn slope(body: &mut Body, cell: CellId, corner: Corner, rule: Slope) -> Result<Change, OperationError> {
    if body.cell(cell).is_none() {
        return Err(BodyError::Unknown { id: cell }.into());
    }
    let star = Star::new(body, &[(cell, corner)])?;
    let weave = star.weave(Kind::Material, body.tolerance());
    let place = star.place(cell, corner).unwrap_or(0);
    let part = weave.frames[place].part;
    if rule == Slope::Natural && !weave.is_regular[part] {
        return Err(OperationError::Irregular { id: cell, corner });
    }
    let class = weave.class[place * 8];
    let is_with = |n: &usize| weave.class[n * 8] == class && weave.frames[*n].part == part;
    let places: Vec<usize> = (0..star.cells.len()).filter(is_with).collect();
    let a: Vec<f64> = (0..body.materials()).map(|material| star.fraction(place * 8, material)).collect();
    let steps = match rule {
        Slope::Flat => [0, 1, 2].map(|_| vec![0.0; a.len()]),
        Slope::Natural => scaled(&star, &weave, &places, &a),
    };
    let mut draft = Draft::default();
    for place in places {
        for n in 0..8 {
            let offset = weave.frames[place].offset(n);
            let mix: Vec<f64> = at_offset(&a, &steps, offset).map(|fraction| fraction.max(0.0)).collect();
            let (id, at) = star.coefficient(place * 8 + n);
            draft.fill(body, id, at, &mix)?;
        }
    }
    draft.commit(body)
}

/// Fractions at an offset in the grid.
fn at_offset<'a>(a: &'a [f64], steps: &'a [Vec<f64>; 3], offset: [i8; 3]) -> impl Iterator<Item = f64> + 'a {
    a.iter().enumerate().map(move |(material, a)| {
        (0..3).fold(*a, |sum, axis| sum + f64::from(offset[axis]) * steps[axis][material])
    })
}

/// The natural steps along the axes of the grid, scaled so that all coefficients are compositions.
fn scaled(star: &Star<'_>, weave: &Weave, places: &[usize], a: &[f64]) -> [Vec<f64>; 3] {
    let mut steps = [0, 1, 2].map(|axis| natural(star, weave, places, a, axis));
    let mut scale = 1.0_f64;
    for &place in places {
        for n in 0..8 {
            let offset = weave.frames[place].offset(n);
            for (value, a) in at_offset(a, &steps, offset).zip(a) {
                if value < 0.0 {
                    scale = scale.min(a / (a - value));
                }
            }
        }
    }
    steps.iter_mut().flatten().for_each(|step| *step *= scale);
    steps
}

/// The natural step along an axis of the grid: from the mean compositions of the next corners on either side.
fn natural(star: &Star<'_>, weave: &Weave, places: &[usize], a: &[f64], axis: usize) -> Vec<f64> {
    let mut sides: [Option<Vec<f64>>; 2] = [None, None];
    for (side, mean) in sides.iter_mut().enumerate() {
        let sign = if side == 0 { -1 } else { 1 };
        let there: Vec<usize> =
            places.iter().copied().filter(|place| weave.frames[*place].signs[axis] == sign).collect();
        if there.is_empty() {
            continue;
        }
        let mut sum = vec![0.0; a.len()];
        for place in &there {
            let (_, corner, cell) = star.cells[*place];
            let mut next = corner;
            if let Some(local) = weave.frames[*place].local(axis) {
                next.0[local] = !next.0[local];
            }
            let [i, j, k] = next.0.map(|is_end| if is_end { 3 } else { 0 });
            let at = flat(i, j, k);
            sum.iter_mut()
                .zip(cell.fractions())
                .for_each(|(sum, list)| *sum += list[at] / there.len() as f64);
        }
        *mean = Some(sum);
    }
    let difference = |from: &[f64], to: &[f64], share: f64| -> Vec<f64> {
        from.iter().zip(to).map(|(from, to)| (to - from) * share).collect()
    };
    match sides {
        [Some(before), Some(after)] => pair(a, &difference(&before, &after, 1.0 / 6.0)),
        [Some(before), None] => difference(&before, a, 1.0 / 3.0),
        [None, Some(after)] => difference(a, &after, 1.0 / 3.0),
        [None, None] => vec![0.0; a.len()],
    }
}

#[cfg(test)]
mod tests {
    use super::super::test_bodies::{block, check_body, fan, random_mix, shuffled};
    use super::super::{mix_cells, mix_coefficient, mix_corner};
    use super::*;
    use crate::hyperpatch::composite::{Match, Probe, Sharing};
    use crate::material::Composition;
    use glam::DVec3;

    /// A block whose corners have the compositions of a map of space, by the flat rule.
    fn graded(count: [usize; 3], seed: u64, mix: impl Fn(DVec3) -> Composition) -> Body {
        let mut body = shuffled(&block(count), seed);
        for id in 0..body.cells().len() as u32 {
            for corner in Corner::all() {
                let point = body.cell(CellId(id)).unwrap().net().0[corner.coefficient()];
                mix_corner(&mut body, CellId(id), corner, &mix(point), None).unwrap();
            }
        }
        body
    }

    fn slope_all(body: &mut Body, rule: Slope) {
        let ids: Vec<CellId> = body.cells().iter().map(|(id, _)| *id).collect();
        for id in ids {
            for corner in Corner::all() {
                slope(body, id, corner, rule).unwrap();
            }
        }
    }

    fn smooth(body: &Body) -> bool {
        Sharing::new(body)
            .continuity(body)
            .iter()
            .all(|face| face.corners.iter().all(|c| c.material == Match::C1))
    }

    /// A linear gradient over several cells is a staircase by the flat rule, by smoothsteps, and linear by the natural
    /// one.
    #[test]
    fn a_linear_gradient_is_a_staircase_or_linear() {
        let line = |p: DVec3| {
            let share = (p.x + 2.0 * p.y + p.z) / 10.0;
            Composition::new(vec![1.0 - share, share * 0.75, share * 0.25]).unwrap()
        };
        let mut body = graded([3, 2, 2], 1, line);
        let places = [DVec3::new(0.25, 0.3, 0.1), DVec3::new(1.25, 1.7, 0.9), DVec3::new(2.5, 1.1, 1.6)];
        slope_all(&mut body, Slope::Flat);
        assert!(smooth(&body));
        for place in places {
            let (cell, t) = (place.floor(), place - place.floor());
            let expected = line(cell + t * t * (DVec3::splat(3.0) - 2.0 * t));
            let found = Probe::new(&body).composition(place).unwrap();
            assert!((found.fractions()[1] - expected.fractions()[1]).abs() < 1e-12);
        }
        slope_all(&mut body, Slope::Natural);
        assert!(smooth(&body));
        check_body(&body);
        for place in places {
            let found = Probe::new(&body).composition(place).unwrap();
            assert!((found.fractions()[1] - line(place).fractions()[1]).abs() < 1e-12, "{place}");
        }
    }

    /// Any compositions at the corners, pure ones among them: everything runs on and stays in the simplex.
    #[test]
    fn natural_slopes_stay_in_the_simplex() {
        for seed in 0..6 {
            let mix = |p: DVec3| match (p.x + p.y) as u64 % 3 {
                0 => Composition::pure((p.z + p.x) as usize % 3, 3),
                _ => random_mix(seed * 100 + (p.x * 25.0 + p.y * 5.0 + p.z) as u64),
            };
            let mut body = graded([2, 2, 2], seed, mix);
            slope_all(&mut body, Slope::Natural);
            assert!(smooth(&body));
            check_body(&body);
        }
    }

    #[test]
    fn jumps_and_creases_keep_what_they_are() {
        let mut body = block([2, 1, 1]);
        mix_coefficient(&mut body, CellId(0), 63, &random_mix(1)).unwrap();
        let jump = body.cell(CellId(1)).unwrap().clone();
        let change = slope(&mut body, CellId(0), Corner([true; 3]), Slope::Natural).unwrap();
        assert_eq!(change.touched, [CellId(0)]);
        assert_eq!(*body.cell(CellId(1)).unwrap(), jump);
        check_body(&body);

        let mut body = fan(5);
        let ids: Vec<CellId> = (0..5).map(CellId).collect();
        mix_cells(&mut body, &ids, &random_mix(2)).unwrap();
        let crease = slope(&mut body, CellId(0), Corner([false; 3]), Slope::Natural);
        assert!(matches!(crease, Err(OperationError::Irregular { .. })));
        assert_eq!(slope(&mut body, CellId(0), Corner([false; 3]), Slope::Flat).unwrap().touched, ids);
        assert!(slope(&mut body, CellId(7), Corner([false; 3]), Slope::Flat).is_err());
    }
}
