//! The plane that fits curves in space best.

use glam::DVec3;

/// Right-handed axes: two in the plane, and its normal.
pub type Axes = [DVec3; 3];

/// Components below this part of a unit vector do not decide which way it points.
const NOTHING: f64 = 1e-9;
/// Middle to greatest spread below which, in squares, points count as lying on a line.
const LINE: f64 = 1e-18;
/// Most rounds of rotations; a matrix of three by three takes about five.
const ROUNDS: usize = 40;

/// The direction of parallel planes, one through the mean of each polyline, from which all of them together have the least sum of squared
/// distances, weighted by length. `None` where all run along one line.
///
/// Each polyline has a plane of its own, so that two level rings far above each other are level. The normal points up; where it has no upward
/// part, along y, or else along x. The first axis is that of x as seen on the plane, or of y where x is within 26 degrees of the normal. So
/// curves that lie level keep their x and y. Where no direction is better than another, as for polylines that are spread evenly in space, one
/// of the best is taken, always the same.
#[must_use]
pub fn best_axes(polylines: &[Vec<DVec3>]) -> Option<Axes> {
    let mut spread = [[0.0; 3]; 3];
    for line in polylines {
        let mean = mean(line);
        for (middle, length) in pieces(line) {
            let offset = (middle - mean).to_array();
            for (i, row) in spread.iter_mut().enumerate() {
                row.iter_mut().zip(offset).for_each(|(entry, part)| *entry += length * offset[i] * part);
            }
        }
    }
    let (values, vectors) = eigen(spread);
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| values[i].total_cmp(&values[j]));
    let is_spread = values[order[1]] > LINE * values[order[2]];
    is_spread.then(|| axes_of(vectors[order[0]]))
}

/// Mean of a polyline by length; the first point of one without length.
#[must_use]
pub fn mean(line: &[DVec3]) -> DVec3 {
    let first = line.first().copied().unwrap_or_default();
    let (sum, length) = pieces(line).fold((DVec3::ZERO, 0.0), |(sum, all), (middle, length)| {
        (sum + (middle - first) * length, all + length)
    });
    if length > 0.0 { first + sum / length } else { first }
}

/// Middle and length of each edge.
fn pieces(line: &[DVec3]) -> impl Iterator<Item = (DVec3, f64)> + '_ {
    line.windows(2).map(|ends| (ends[0].midpoint(ends[1]), ends[0].distance(ends[1])))
}

fn axes_of(normal: DVec3) -> Axes {
    let decides = |part: f64| part.abs() > NOTHING;
    let sign = [normal.z, normal.y, normal.x].into_iter().find(|&part| decides(part)).unwrap_or(1.0);
    let z = normal * sign.signum();
    let seen = if z.x.abs() < 0.9 { DVec3::X } else { DVec3::Y };
    let x = (seen - z * seen.dot(z)).normalize_or(DVec3::X);
    [x, z.cross(x), z]
}

/// Eigenvalues of a symmetric matrix and their unit vectors, by Jacobi's rotations.
fn eigen(mut a: [[f64; 3]; 3]) -> ([f64; 3], [DVec3; 3]) {
    let mut vectors = [DVec3::X, DVec3::Y, DVec3::Z];
    for _ in 0..ROUNDS {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if a[p][q] == 0.0 {
                continue;
            }
            let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let t = theta.signum() / (theta.abs() + theta.hypot(1.0));
            let c = 1.0 / t.hypot(1.0);
            let s = t * c;
            for row in &mut a {
                (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
            }
            let [first, second] = [a[p], a[q]];
            a[p] = std::array::from_fn(|k| c * first[k] - s * second[k]);
            a[q] = std::array::from_fn(|k| s * first[k] + c * second[k]);
            (vectors[p], vectors[q]) = (vectors[p] * c - vectors[q] * s, vectors[p] * s + vectors[q] * c);
        }
    }
    ([a[0][0], a[1][1], a[2][2]], vectors.map(|vector| vector.normalize_or_zero()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DQuat, dvec3};
    use std::f64::consts::TAU;

    fn ring(radius: f64, at: DVec3, wave: f64, turn: DQuat) -> Vec<DVec3> {
        let point = |k: u32| {
            let angle = TAU * f64::from(k) / 400.0;
            turn * dvec3(radius * angle.cos(), radius * angle.sin(), wave * (3.0 * angle).sin()) + at
        };
        (0..=400).map(point).collect()
    }

    #[test]
    fn level_rings_keep_x_and_y_however_far_apart() {
        let rings = [
            ring(1.0, DVec3::ZERO, 0.0, DQuat::IDENTITY),
            ring(2.0, dvec3(0.3, 0.0, 500.0), 0.2, DQuat::IDENTITY),
        ];
        let axes = best_axes(&rings).expect("a plane");
        for (axis, expected) in axes.into_iter().zip([DVec3::X, DVec3::Y, DVec3::Z]) {
            assert!((axis - expected).length() < 1e-9, "{axis}");
        }
    }

    #[test]
    fn a_turned_ring_has_its_own_normal() {
        for (axis, angle) in
            [(DVec3::X, 0.4), (dvec3(1.0, 2.0, -1.0), 2.5), (DVec3::Y, TAU / 4.0), (DVec3::X, TAU / 4.0)]
        {
            let turn = DQuat::from_axis_angle(axis.normalize(), angle);
            let [x, y, z] = best_axes(&[ring(3.0, dvec3(5.0, -7.0, 1e3), 0.3, turn)]).expect("a plane");
            assert!((z.dot(turn * DVec3::Z).abs() - 1.0).abs() < 1e-9);
            assert!(z.z > 1e-9 || z.z > -1e-9 && (z.y > 1e-9 || z.x > 0.0), "{z}");
            assert!((x.cross(y) - z).length() < 1e-12 && x.dot(y).abs() < 1e-12);
        }
    }

    #[test]
    fn points_on_a_line_have_no_plane() {
        let line: Vec<DVec3> = (0..9).map(|k| dvec3(1.0, 2.0, 3.0) * f64::from(k)).collect();
        assert_eq!(best_axes(&[line.clone(), line]), None);
        assert_eq!(best_axes(&[vec![DVec3::ONE; 5]]), None);
    }
}
