//! Eq. 2 as printed, on a grid.

use super::transform::{TransformError, distances};
use super::{DistanceProfile, Grid};
use crate::material::Composition;

/// Most profiles whose tree is carried out on a grid: 2^8 leaves, each with transforms of its own.
pub const MOST_PRINTED: usize = 8;

/// A composition for each voxel by Eq. 2.
#[derive(Debug, Clone, PartialEq)]
pub struct Printed {
    /// The fractions of each voxel, one material after the other; 0 outside the body.
    pub fractions: Vec<Vec<f32>>,
    /// The leaf of each voxel: bit k says that the band of profile k holds it. 0 outside the body.
    pub leaves: Vec<u32>,
}

/// Carries out the binary subdivision of Liu and others 2003, 3.2.2 (Eq. 2, Fig. 7) literally: profile after profile, every node N is parted into L = N and V_k, which mixes what it had with the
/// profile by the distances d1 to the rest of N and d2 to what V_k has outside N, both between voxels, and the rest, which keeps what it
/// had. Where V_k has nothing outside N, d2 is 0; where nothing is left of N, the profile alone holds; 0 / 0 is one half.
///
/// It shows what the printed rule does and is not the default: a profile alone fades away from an overlap, and the order of the queue
/// matters. `near` holds the distances of all voxels to the feature of each profile; `is_inside` says which voxels the body has.
///
/// # Errors
/// When lists do not have one number for each voxel.
///
/// # Panics
/// When there are more than [`MOST_PRINTED`] profiles, not as many lists of distances as profiles, or numbers of materials differ.
pub fn printed(
    grid: &Grid,
    is_inside: &[bool],
    default: &Composition,
    profiles: &[DistanceProfile],
    near: &[Vec<f32>],
) -> Result<Printed, TransformError> {
    assert!(profiles.len() <= MOST_PRINTED, "{} profiles", profiles.len());
    assert_eq!(profiles.len(), near.len(), "distances for each profile");
    let expected = grid.count();
    let lengths = near.iter().map(Vec::len).chain([is_inside.len()]);
    if let Some(found) = lengths.into_iter().find(|found| *found != expected) {
        return Err(TransformError::Length { found, expected });
    }
    let inside =
        |fraction: f64| is_inside.iter().map(|&is_in| if is_in { fraction as f32 } else { 0.0 }).collect();
    let mut made = Printed {
        fractions: default.fractions().iter().map(|fraction| inside(*fraction)).collect(),
        leaves: vec![0; expected],
    };
    let mut own = vec![0.0; default.fractions().len()];
    for (k, (profile, near)) in profiles.iter().zip(near).enumerate() {
        assert_eq!(profile.materials(), own.len(), "numbers of materials differ");
        let band: Vec<bool> =
            near.iter().zip(is_inside).map(|(d, is_in)| *is_in && profile.holds(f64::from(*d))).collect();
        let mut nodes: Vec<u32> = (0..expected).filter(|n| band[*n]).map(|n| made.leaves[n]).collect();
        nodes.sort_unstable();
        nodes.dedup();
        let before = made.leaves.clone();
        for node in nodes {
            let marked = |is_marked: &dyn Fn(usize) -> bool| -> Vec<u8> {
                (0..expected).map(|n| u8::from(is_marked(n))).collect()
            };
            let of_node = |n: usize| is_inside[n] && before[n] == node;
            let to_rest = distances(grid, &marked(&|n| of_node(n) && !band[n]), None)?;
            let to_others = distances(grid, &marked(&|n| band[n] && !of_node(n)), None)?;
            for n in (0..expected).filter(|n| of_node(*n) && band[*n]) {
                profile.fractions(f64::from(near[n]), &mut own);
                let share = share(to_rest[n], to_others[n]);
                for (fractions, own) in made.fractions.iter_mut().zip(&own) {
                    fractions[n] += share * (*own as f32 - fractions[n]);
                }
                made.leaves[n] |= 1 << k;
            }
        }
    }
    Ok(made)
}

/// The weight d1 / (d1 + d2) of the profile.
fn share(d1: f32, d2: f32) -> f32 {
    match (d1.is_finite(), d2.is_finite()) {
        (_, false) | (false, _) => 1.0,
        (true, true) if d1 + d2 > 0.0 => d1 / (d1 + d2),
        (true, true) => 0.5,
    }
}

#[cfg(test)]
mod tests {
    use super::super::Course;
    use super::*;

    /// The rectangle of Fig. 6: A on the left edge, B on the bottom edge, limits .3 of the width, the default the last of three materials.
    fn rectangle(n: usize, order: [usize; 2]) -> Printed {
        let step = 1.0 / n as f64;
        let grid = Grid::new([n, n, 1], [step; 3]).unwrap();
        let along = |axis: usize| -> Vec<f32> {
            (0..n * n).map(|index| ([index % n, index / n][axis] as f64 * step) as f32).collect()
        };
        let profile = |material: usize| {
            let mixes = [Composition::pure(material, 3), Composition::pure(2, 3)];
            DistanceProfile::new([0.0, 0.3], mixes, Course::Linear).unwrap()
        };
        let profiles = order.map(profile);
        printed(&grid, &vec![true; n * n], &Composition::pure(2, 3), &profiles, &order.map(along)).unwrap()
    }

    /// What is wrong with the rule: green asked for on the whole bottom edge is about .6 at mid-length and .3 at its far end (science of Fig. 21).
    #[test]
    fn a_profile_alone_fades_away_from_the_overlap() {
        let n = 200;
        let made = rectangle(n, [0, 1]);
        let at = |x: f64| f64::from(made.fractions[1][(x * n as f64) as usize]);
        assert!((at(0.5) - 0.6).abs() < 0.02, "{}", at(0.5));
        assert!((at(0.995) - 0.3).abs() < 0.02, "{}", at(0.995));
        assert!(at(0.31) > 0.95, "{}", at(0.31));
    }

    #[test]
    fn the_order_of_the_queue_matters() {
        let [forth, back] = [[0, 1], [1, 0]].map(|order| rectangle(100, order));
        let differ = |material: usize| {
            let pairs = forth.fractions[material].iter().zip(&back.fractions[material]);
            pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
        };
        assert!(differ(0) > 0.6 && differ(1) > 0.6, "{} and {}", differ(0), differ(1));
    }

    #[test]
    fn fractions_stay_in_the_simplex_and_leaves_are_those_of_the_bands() {
        let n = 60;
        let made = rectangle(n, [0, 1]);
        for index in 0..n * n {
            let fractions = [0, 1, 2].map(|material: usize| made.fractions[material][index]);
            assert!(
                (fractions.iter().sum::<f32>() - 1.0).abs() < 1e-5 && fractions.iter().all(|f| *f >= -1e-6)
            );
            let is_held = |at: usize| u32::from(f64::from((at as f64 * (1.0 / n as f64)) as f32) <= 0.3);
            assert_eq!(made.leaves[index], is_held(index % n) | is_held(index / n) << 1);
        }
    }

    /// One profile encloses what it acts on: d2 is 0, and it is its function.
    #[test]
    fn one_profile_alone_is_its_function() {
        let grid = Grid::new([20, 1, 1], [1.0; 3]).unwrap();
        let mixes = [Composition::pure(0, 2), Composition::pure(1, 2)];
        let profile = DistanceProfile::new([0.0, 10.0], mixes, Course::Linear).unwrap();
        let near: Vec<f32> = (0..20).map(|n| n as f32).collect();
        let is_inside: Vec<bool> = (0..20).map(|n| n != 3).collect();
        let made = printed(&grid, &is_inside, &Composition::pure(1, 2), &[profile], &[near]).unwrap();
        let expected = |n: usize| if n == 3 { 0.0 } else { (1.0 - n as f32 / 10.0).max(0.0) };
        assert!(
            (0..20).all(|n| (made.fractions[0][n] - expected(n)).abs() < 1e-6),
            "{:?}",
            made.fractions[0]
        );
        assert_eq!(made.fractions[1][3], 0.0);
        let short = printed(&grid, &[true; 19], &Composition::pure(1, 2), &[], &[]);
        assert_eq!(short, Err(TransformError::Length { found: 19, expected: 20 }));
    }
}
