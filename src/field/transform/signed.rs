//! Signed distances.

use super::job::{DistanceJob, TransformError};
use crate::field::Grid;

/// Distances with a sign: outside a feature the distance to its nearest voxel, inside minus the distance to the nearest voxel outside, both between
/// centres. So no voxel is at 0: the surface runs halfway between a voxel and its neighbour of the other kind, where these distances have the same
/// size, and interpolation between them finds it. Infinite where there is no voxel of the other kind.
///
/// # Errors
/// When there are not as many features as voxels.
pub fn signed(grid: &Grid, features: &[u8]) -> Result<Vec<f32>, TransformError> {
    let run = |job: Result<DistanceJob, TransformError>| job.map(DistanceJob::run);
    let outside = run(DistanceJob::new(grid, features, None))?;
    let others: Vec<u8> = features.iter().map(|feature| u8::from(*feature == 0)).collect();
    let inside = run(DistanceJob::new(grid, &others, None))?;
    Ok(outside.into_iter().zip(inside).map(|(out, within)| if out > 0.0 { out } else { -within }).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sign_says_on_which_side_a_voxel_is() {
        let grid = Grid::new([6, 1, 1], [0.5, 9.0, 9.0]).unwrap();
        let found = signed(&grid, &[0, 0, 1, 1, 1, 0]).unwrap();
        assert_eq!(found, [1.0, 0.5, -0.5, -1.0, -0.5, 0.5]);
        assert!(signed(&grid, &[1; 6]).unwrap().iter().all(|distance| *distance == f32::NEG_INFINITY));
        assert!(signed(&grid, &[0; 6]).unwrap().iter().all(|distance| *distance == f32::INFINITY));
    }

    /// Half a voxel of a ball's surface at most, as the error of a digital distance is bounded (Liu and others 2003, Eq. 24).
    #[test]
    fn a_ball_is_known_to_within_the_bound_of_the_paper() {
        let (n, radius) = (40, 14.3);
        let grid = Grid::new([n; 3], [1.0; 3]).unwrap();
        let middle = (n as f64 - 1.0) / 2.0;
        let exact = |index: usize| {
            let away = [index % n, index / n % n, index / n / n].map(|i| i as f64 - middle);
            away.iter().map(|x| x * x).sum::<f64>().sqrt() - radius
        };
        let features: Vec<u8> = (0..grid.count()).map(|index| u8::from(exact(index) <= 0.0)).collect();
        let found = signed(&grid, &features).unwrap();
        let worst =
            (0..grid.count()).map(|index| (f64::from(found[index]) - exact(index)).abs()).fold(0.0, f64::max);
        assert!(worst <= 3.0_f64.sqrt(), "{worst}");
        assert!(worst > 0.3, "{worst}: voxels cannot know better");
    }
}
