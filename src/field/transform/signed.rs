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

    /// From any point, not only a centre, to a surface somewhere in its voxels: |t - d| is at most sqrt(3) voxels, sqrt(2) in the plane, and the squares obey Eq. 24. From
    /// centres half of it is enough. Features are the voxels that the surface meets, as the paper has them.
    #[test]
    fn digital_distances_of_any_point_keep_the_bounds_of_the_paper() {
        let mut state = 88_172_645_463_325_252_u64;
        let mut random = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        for (size, radius) in [([61, 57, 1], 17.3), ([25, 27, 23], 8.2)] {
            let space = if size[2] > 1 { 3.0_f64 } else { 2.0 };
            let middle =
                size.map(|count| count as f64 / 2.0 + 0.37).map(|at| if at < 1.0 { 0.5 } else { at });
            let away = |at: [f64; 3]| {
                let squares: f64 = (0..3).map(|axis| (at[axis] - middle[axis]).powi(2)).sum();
                (squares.sqrt() - radius).abs()
            };
            let place = |index: usize| {
                [index % size[0], index / size[0] % size[1], index / size[0] / size[1]].map(|i| i as f64)
            };
            let is_flat = size[2] == 1;
            // Nearest and farthest point of a voxel from the middle: the surface meets it where its radius lies between.
            let meets = |index: usize| {
                let along: Vec<[f64; 2]> = (0..3)
                    .map(|axis| {
                        if axis == 2 && is_flat {
                            return [0.0; 2];
                        }
                        let low = place(index)[axis] - middle[axis];
                        let [a, b] = [low.abs(), (low + 1.0).abs()];
                        [if (-1.0..=0.0).contains(&low) { 0.0 } else { a.min(b) }, a.max(b)]
                    })
                    .collect();
                let norm = |n: usize| along.iter().map(|pair| pair[n] * pair[n]).sum::<f64>().sqrt();
                norm(0) <= radius && radius <= norm(1)
            };
            let grid = Grid::new(size, [1.0; 3]).unwrap();
            let features: Vec<u8> = (0..grid.count()).map(|index| u8::from(meets(index))).collect();
            let found = DistanceJob::new(&grid, &features, None).unwrap().run();
            let (mut at_centers, mut anywhere) = (0.0_f64, 0.0_f64);
            for (index, &digital) in found.iter().enumerate() {
                let digital = f64::from(digital);
                let inside = |offset: [f64; 3]| {
                    let at = place(index);
                    away([
                        at[0] + offset[0],
                        at[1] + offset[1],
                        if is_flat { 0.5 } else { at[2] + offset[2] },
                    ])
                };
                at_centers = at_centers.max((inside([0.5; 3]) - digital).abs());
                for _ in 0..20 {
                    let exact = inside([random(), random(), random()]);
                    anywhere = anywhere.max((exact - digital).abs());
                    let allowed = space + 2.0 * space.sqrt() * digital;
                    assert!(
                        (exact * exact - digital * digital).abs() <= allowed + 1e-6,
                        "{exact} and {digital}"
                    );
                }
            }
            assert!(at_centers <= space.sqrt() / 2.0 + 1e-6, "{at_centers}");
            assert!(anywhere <= space.sqrt() + 1e-6 && anywhere > 0.7 * space.sqrt(), "{anywhere}");
        }
    }
}
