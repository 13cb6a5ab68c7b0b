//! The cone condition: a proof that a cell meets itself nowhere.

use crate::hyperpatch::{Differences, Net};
use glam::{DMat3, DVec3};

/// Margin from which the cone condition counts as met: quarter rings and twists by 90 degrees have a margin of
/// exactly 0, which rounding moves to either side.
pub const REGULAR_MARGIN: f64 = 1e-9;

/// Number of vectors of a group whose determinants are bounded together.
const GROUP: usize = 6;
/// Number of groups of an axis.
const GROUPS: usize = 48 / GROUP;

/// How regular a cell is, from -1 to 1: the least determinant of three unit vectors, one along a difference of
/// neighbouring control points for each axis.
///
/// A box has 1, a cell of a ring of n has cos(360 / n degrees), a box twisted by 90 degrees 0. Above 0 the cell is
/// injective: two parameters `q` and `q'` differ by steps along u, v and w, and their points by `du a + dv b + dw c`
/// with `a`, `b` and `c` means of differences of each axis. The determinant is linear in each of them, so it is
/// positive for the means as well, and the sum is zero only where all steps are.
#[must_use]
pub fn margin(net: &Net) -> f64 {
    least(&net.differences(), f64::NEG_INFINITY)
}

/// Whether differences, of a cell or of a part of it, meet the cone condition.
#[must_use]
pub fn is_regular(differences: &Differences) -> bool {
    is_axis_aligned(differences) || least(differences, REGULAR_MARGIN) > REGULAR_MARGIN
}

/// A condition that is quicker and stricter than the cone condition: in the frame of the mean differences, every
/// difference along an axis is longer along that axis than along both others together. Then all determinants are
/// those of matrices with a dominant diagonal.
#[must_use]
pub fn is_axis_aligned(differences: &Differences) -> bool {
    let [u, v, w] = differences.0.map(|list| list.iter().sum::<DVec3>() / 48.0);
    let frame = DMat3::from_cols(u, v, w);
    let size = u.length() * v.length() * w.length();
    if frame.determinant() <= REGULAR_MARGIN * size {
        return false;
    }
    let to_frame = frame.inverse();
    let dominates = |axis: usize, d: DVec3| {
        let part = to_frame * d;
        part[axis] - (part.abs().element_sum() - part[axis].abs()) > REGULAR_MARGIN
    };
    differences.0.iter().enumerate().all(|(axis, list)| list.iter().all(|&d| dominates(axis, d)))
}

/// The least determinant, or the first one found that is no greater than `enough`.
///
/// The vectors of each axis go into groups of similar direction. Three groups bound their determinants together, so
/// that most of the 110,592 need not be computed.
fn least(differences: &Differences, enough: f64) -> f64 {
    let units = differences.0.map(|list| grouped(list.map(DVec3::normalize_or_zero)));
    let [u, v, w] = units.each_ref().map(|list| list.as_chunks::<GROUP>().0);
    let [groups_u, groups_v, groups_w] =
        [u, v, w].map(|list| list.iter().map(Group::new).collect::<Vec<_>>());
    let bounds = bounds(&groups_u, &groups_v, &groups_w);
    let first = (0..bounds.len()).min_by(|&a, &b| bounds[a].total_cmp(&bounds[b]));
    let mut best = 1.0_f64;
    for triple in first.into_iter().chain(0..bounds.len()) {
        if best <= enough {
            return best;
        }
        if bounds[triple] >= best {
            continue;
        }
        let group = triple % GROUPS;
        let Group { centre, radius, .. } = groups_w[group];
        for a in &u[triple / (GROUPS * GROUPS)] {
            for b in &v[triple / GROUPS % GROUPS] {
                let normal = a.cross(*b);
                if normal.dot(centre) - radius < best {
                    best = w[group].iter().map(|c| normal.dot(*c)).fold(best, f64::min);
                }
            }
        }
    }
    best
}

/// Vectors, none longer than 1, by their mean and how far they are from it.
struct Group {
    centre: DVec3,
    /// Direction of the mean.
    direction: DVec3,
    /// Largest distance from the mean, and its largest parts along the direction and across.
    radius: f64,
    along: f64,
    across: f64,
}

impl Group {
    fn new(vectors: &[DVec3; GROUP]) -> Self {
        let centre = vectors.iter().sum::<DVec3>() / GROUP as f64;
        let direction = centre.normalize_or_zero();
        let mut squares = DVec3::ZERO;
        for vector in vectors {
            let offset = *vector - centre;
            let along = offset.dot(direction);
            let length = offset.length_squared();
            squares = squares.max(DVec3::new(length, along * along, length - along * along));
        }
        let [radius, along, across] = squares.to_array().map(f64::sqrt);
        Self { centre, direction, radius, along, across }
    }
}

/// Lower bounds of the determinants of each three groups, the third one fastest.
///
/// The determinant of three means changes by the product of each offset with the cross product of the other two
/// means, of which the part across the mean is small in cells that are nearly boxes, and by no more than the products
/// of two radii.
fn bounds(groups_u: &[Group], groups_v: &[Group], groups_w: &[Group]) -> Vec<f64> {
    let crosses = |first: &[Group], second: &[Group]| -> Vec<DVec3> {
        first.iter().flat_map(|a| second.iter().map(move |b| a.centre.cross(b.centre))).collect()
    };
    let (uv, vw, wu) =
        (crosses(groups_u, groups_v), crosses(groups_v, groups_w), crosses(groups_w, groups_u));
    let change = |group: &Group, normal: DVec3| {
        let along = normal.dot(group.direction);
        group.along * along.abs() + group.across * (normal.length_squared() - along * along).max(0.0).sqrt()
    };
    let mut bounds = Vec::with_capacity(GROUPS * GROUPS * GROUPS);
    for (i, a) in groups_u.iter().enumerate() {
        for (j, b) in groups_v.iter().enumerate() {
            let normal = uv[i * GROUPS + j];
            for (k, c) in groups_w.iter().enumerate() {
                let first = change(a, vw[j * GROUPS + k]) + change(b, wu[k * GROUPS + i]) + change(c, normal);
                let (ab, rest) = (a.radius * b.radius, (a.radius + b.radius) * c.radius);
                bounds.push(normal.dot(c.centre) - first - ab - rest - ab * c.radius);
            }
        }
    }
    bounds
}

/// Vectors in an order in which groups of [`GROUP`] have similar directions: halved three times across the axis of
/// the widest spread.
fn grouped(mut vectors: [DVec3; 48]) -> [DVec3; 48] {
    for size in [48, 24, 12] {
        for part in vectors.chunks_exact_mut(size) {
            let (lo, hi) = part.iter().fold((part[0], part[0]), |(lo, hi), &v| (lo.min(v), hi.max(v)));
            let axis = (hi - lo).max_position();
            part.select_nth_unstable_by(size / 2, |a, b| a[axis].total_cmp(&b[axis]));
        }
    }
    vectors
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::Jacobian;
    use crate::hyperpatch::test_cells::{folded, random_net, ring_cell, twisted};

    #[test]
    fn margins_of_known_cells() {
        assert!((margin(&Net::cuboid(DVec3::ZERO, DVec3::new(1.0, 20.0, 0.3))) - 1.0).abs() < 1e-15);
        for count in [4, 5, 6, 8, 12, 40] {
            let expected = (std::f64::consts::TAU / count as f64).cos();
            let found = margin(&ring_cell(count, 1, 1.0, 2.0, 1.0));
            assert!((found - expected).abs() < 1e-14, "ring of {count}: {found}, expected {expected}");
        }
        assert!(margin(&twisted(90.0)).abs() < 1e-14);
        assert!(margin(&twisted(60.0)) > 0.3 && margin(&twisted(120.0)) < -0.3);
    }

    /// The shortcuts find the same minimum as all determinants.
    #[test]
    fn the_margin_is_the_least_of_all_determinants() {
        for seed in 0..6 {
            let net = random_net(seed, 0.04 * seed as f64);
            let [u, v, w] = net.differences().0.map(|list| list.map(DVec3::normalize));
            let mut least = 1.0_f64;
            for a in u {
                for b in v {
                    least = w.iter().map(|c| a.cross(b).dot(*c)).fold(least, f64::min);
                }
            }
            assert!((margin(&net) - least).abs() < 1e-15);
            assert_eq!(is_regular(&net.differences()), least > REGULAR_MARGIN);
        }
    }

    /// Each condition of the chain implies the next: axis, cone, positive determinant.
    #[test]
    fn axis_implies_cone_implies_positive() {
        let (mut aligned, mut regular) = (0, 0);
        for seed in 0..200 {
            let net = random_net(seed, 0.15 * seed as f64 / 200.0);
            if is_axis_aligned(&net.differences()) {
                aligned += 1;
                assert!(margin(&net) > REGULAR_MARGIN);
            }
            if margin(&net) > REGULAR_MARGIN {
                regular += 1;
                let jacobian = Jacobian::new(&net);
                assert!(jacobian.coefficients().iter().all(|&c| c > jacobian.error()));
            }
        }
        assert!(aligned > 30 && regular > aligned && regular < 200, "{aligned} {regular}");
    }

    #[test]
    fn mirrored_flat_and_folded_cells_are_not_regular() {
        let cube = Net::cuboid(DVec3::ZERO, DVec3::ONE);
        let flat = cube.map(|p| DVec3::new(p.x, p.y, 0.0));
        for net in [cube.reversed(crate::hyperpatch::Axis::V), flat, folded(0.5), cube.map(|_| DVec3::ONE)] {
            assert!(margin(&net) <= 0.0);
            assert!(!is_regular(&net.differences()) && !is_axis_aligned(&net.differences()));
        }
    }
}
