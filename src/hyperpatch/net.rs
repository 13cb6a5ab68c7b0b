//! The shape of a cell: a trivariate polynomial of degree 3 along each axis, from the unit cube to space.

use super::bernstein::{contract, cubic, cubic_slope, elevate, flat, restrict, split_net, stride};
use super::{Axis, Corner, Edge, Face};
use glam::DVec3;

/// 64 control points of a tricubic Bezier volume; coefficient (i, j, k) stands at `(i * 4 + j) * 4 + k`.
#[derive(Debug, Clone, PartialEq)]
pub struct Net(pub [DVec3; 64]);

/// Differences of neighbouring control points along each axis, 48 for each: a third of what the derivative is made of.
#[derive(Debug, Clone, PartialEq)]
pub struct Differences(pub [[DVec3; 48]; 3]);

impl Net {
    /// The trilinear volume between 8 corners in the order of [`Corner::all`].
    #[must_use]
    pub fn trilinear(corners: &[DVec3; 8]) -> Self {
        let cubic_line = |a: DVec3, b: DVec3| {
            let line = elevate(&elevate(&[a, b]));
            [line[0], line[1], line[2], line[3]]
        };
        let edges = [0, 2, 4, 6].map(|n| cubic_line(corners[n], corners[n + 1]));
        let mut points = [DVec3::ZERO; 64];
        for k in 0..4 {
            let sides = [cubic_line(edges[0][k], edges[1][k]), cubic_line(edges[2][k], edges[3][k])];
            for j in 0..4 {
                for (i, point) in cubic_line(sides[0][j], sides[1][j]).into_iter().enumerate() {
                    points[flat(i, j, k)] = point;
                }
            }
        }
        Self(points)
    }

    /// The box from `min` to `max`, axes along those of space.
    #[must_use]
    pub fn cuboid(min: DVec3, max: DVec3) -> Self {
        Self::trilinear(&Corner::all().map(|corner| min + corner.parameters() * (max - min)))
    }

    /// The net whose control points are those of this one, moved by `map`; affine maps move the whole volume.
    #[must_use]
    pub fn map(&self, map: impl Fn(DVec3) -> DVec3) -> Self {
        Self(self.0.map(map))
    }

    /// The point at parameters in [0, 1].
    #[must_use]
    pub fn point(&self, at: DVec3) -> DVec3 {
        contract(&self.0, &at.to_array().map(cubic))
    }

    /// The derivatives along u, v and w.
    #[must_use]
    pub fn derivatives(&self, at: DVec3) -> [DVec3; 3] {
        self.point_and_derivatives(at).1
    }

    /// The point and the derivatives along u, v and w.
    #[must_use]
    pub fn point_and_derivatives(&self, at: DVec3) -> (DVec3, [DVec3; 3]) {
        let values = at.to_array().map(cubic);
        let slopes = at.to_array().map(cubic_slope);
        let derivative = |axis: usize| {
            let mut weights = values;
            weights[axis] = slopes[axis];
            contract(&self.0, &weights)
        };
        (contract(&self.0, &values), [0, 1, 2].map(derivative))
    }

    /// The Jacobian determinant: how many times larger than in parameter space a small volume is; negative where it
    /// is turned inside out.
    #[must_use]
    pub fn jacobian(&self, at: DVec3) -> f64 {
        let [a, b, c] = self.derivatives(at);
        a.cross(b).dot(c)
    }

    /// The Jacobian determinant on a grid of at least two places along each axis, ends included; w runs fastest. Sums that places have in common
    /// are formed once.
    #[must_use]
    pub fn jacobians(&self, count: usize) -> Vec<f64> {
        let place = |n: usize| n as f64 / (count.max(2) - 1) as f64;
        let weights: Vec<[[f64; 4]; 2]> =
            (0..count).map(|n| [cubic(place(n)), cubic_slope(place(n))]).collect();
        let sum = |values: [DVec3; 4], weights: &[f64; 4]| -> DVec3 {
            values.into_iter().zip(weights).map(|(value, weight)| value * *weight).sum()
        };
        let mut found = Vec::with_capacity(count.pow(3));
        for u in &weights {
            let layers: [[DVec3; 16]; 2] = u
                .each_ref()
                .map(|u| std::array::from_fn(|n| sum([0, 1, 2, 3].map(|i| self.0[16 * i + n]), u)));
            for v in &weights {
                let lines: [[DVec3; 4]; 3] = [(1, 0), (0, 1), (0, 0)].map(|(along_u, along_v)| {
                    let layer = &layers[along_u];
                    std::array::from_fn(|n| sum([0, 1, 2, 3].map(|j| layer[4 * j + n]), &v[along_v]))
                });
                for [value, slope] in &weights {
                    let [a, b] = [sum(lines[0], value), sum(lines[1], value)];
                    found.push(a.cross(b).dot(sum(lines[2], slope)));
                }
            }
        }
        found
    }

    /// The two parts on either side of `t` along an axis, each on the unit cube.
    #[must_use]
    pub fn split(&self, axis: Axis, t: f64) -> [Self; 2] {
        split_net(&self.0, axis, t).map(Self)
    }

    /// The part on a box of parameters, as a net on the unit cube. The box may be flat.
    #[must_use]
    pub fn part(&self, lo: DVec3, hi: DVec3) -> Self {
        let mut points = self.0;
        for axis in Axis::ALL {
            let (lo, hi) = (lo[axis as usize], hi[axis as usize]);
            if (lo, hi) == (0.0, 1.0) {
                continue;
            }
            let step = stride(axis);
            for start in super::bernstein::lines(axis) {
                let line = restrict([0, 1, 2, 3].map(|n| points[start + n * step]), lo, hi);
                for (n, point) in line.into_iter().enumerate() {
                    points[start + n * step] = point;
                }
            }
        }
        Self(points)
    }

    /// The same volume run through in the opposite direction of an axis: the Jacobian changes its sign.
    #[must_use]
    pub fn reversed(&self, axis: Axis) -> Self {
        let step = stride(axis);
        Self(std::array::from_fn(|at| {
            let place = at / step % 4;
            self.0[at + (3 - place) * step - place * step]
        }))
    }

    /// The 8 corners, in the order of [`Corner::all`].
    #[must_use]
    pub fn corners(&self) -> [DVec3; 8] {
        Corner::all().map(|corner| self.0[corner.coefficient()])
    }

    /// Control points of a boundary curve.
    #[must_use]
    pub fn edge(&self, edge: Edge) -> [DVec3; 4] {
        edge.coefficients().map(|at| self.0[at])
    }

    /// Control points of a boundary face; the later of its two axes runs fastest.
    #[must_use]
    pub fn face(&self, face: Face) -> [DVec3; 16] {
        face.coefficients().map(|at| self.0[at])
    }

    /// Corners of the smallest box that holds the control points, and with them the volume.
    #[must_use]
    pub fn bounds(&self) -> (DVec3, DVec3) {
        self.0.iter().fold((self.0[0], self.0[0]), |(lo, hi), &point| (lo.min(point), hi.max(point)))
    }

    /// Differences of neighbouring control points.
    #[must_use]
    pub fn differences(&self) -> Differences {
        let mut all = [[DVec3::ZERO; 48]; 3];
        for axis in Axis::ALL {
            let (step, list) = (stride(axis), &mut all[axis as usize]);
            let inner = (0..64).filter(|at| at / step % 4 < 3);
            for (difference, at) in list.iter_mut().zip(inner) {
                *difference = self.0[at + step] - self.0[at];
            }
        }
        Differences(all)
    }
}

impl Differences {
    /// Number of coefficients of the derivative along each axis, as u, v, w.
    const SIZES: [[usize; 3]; 3] = [[3, 4, 4], [4, 3, 4], [4, 4, 3]];

    /// What the differences are on a box of parameters, which may be flat: a third of the derivatives there, not
    /// scaled to the box. Every derivative on the box is three times a mean of them.
    #[must_use]
    pub fn part(&self, lo: DVec3, hi: DVec3) -> Self {
        let mut all = self.0;
        for (list, sizes) in all.iter_mut().zip(Self::SIZES) {
            let strides = [sizes[1] * sizes[2], sizes[2], 1];
            for axis in 0..3 {
                if (lo[axis], hi[axis]) == (0.0, 1.0) {
                    continue;
                }
                let (count, step) = (sizes[axis], strides[axis]);
                for start in (0..48).filter(|at| at / step % count == 0) {
                    if count == 4 {
                        restrict_line::<4>(list, start, step, lo[axis], hi[axis]);
                    } else {
                        restrict_line::<3>(list, start, step, lo[axis], hi[axis]);
                    }
                }
            }
        }
        Self(all)
    }

    /// The differences of the same volume with its first axis reversed, but for their order.
    pub(super) fn reoriented(mut self) -> Self {
        self.0[0] = self.0[0].map(|d| -d);
        self
    }
}

/// Restricts one line of `N` differences, `step` apart from `start` on.
fn restrict_line<const N: usize>(list: &mut [DVec3; 48], start: usize, step: usize, lo: f64, hi: f64) {
    let line: [DVec3; N] = restrict(std::array::from_fn(|n| list[start + n * step]), lo, hi);
    for (n, difference) in line.into_iter().enumerate() {
        list[start + n * step] = difference;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::test_cells::{quarter_ring, random_net, random_place};

    #[test]
    fn a_box_is_its_affine_map() {
        let (min, max) = (DVec3::new(-1.0, 2.0, 0.5), DVec3::new(3.0, 4.0, 1.0));
        let net = Net::cuboid(min, max);
        for seed in 0..20 {
            let at = random_place(seed);
            assert!((net.point(at) - (min + at * (max - min))).length() < 1e-14);
            assert!((net.jacobian(at) - 4.0).abs() < 1e-13);
        }
        assert_eq!((net.corners()[0], net.corners()[7]), (min, max));
        assert_eq!(net.bounds(), (min, max));
    }

    #[test]
    fn derivatives_are_those_of_central_differences() {
        let net = random_net(1, 0.4);
        for seed in 0..20 {
            let at = random_place(seed) * 0.8 + DVec3::splat(0.1);
            for axis in Axis::ALL {
                let h = axis.unit() * 1e-5;
                let near = (net.point(at + h) - net.point(at - h)) / 2e-5;
                assert!((net.derivatives(at)[axis as usize] - near).length() < 1e-8);
            }
        }
    }

    #[test]
    fn parts_are_the_volume_itself() {
        let net = random_net(2, 0.4);
        for axis in Axis::ALL {
            let parts = net.split(axis, 0.3);
            let (lo, hi) = (DVec3::ONE * 0.25, DVec3::new(0.5, 0.25, 1.0));
            let part = net.part(lo, hi);
            for seed in 0..20 {
                let at = random_place(seed);
                let stretch =
                    |from: f64, to: f64| at + axis.unit() * (from + at[axis as usize] * (to - from - 1.0));
                assert!((parts[0].point(at) - net.point(stretch(0.0, 0.3))).length() < 1e-14);
                assert!((parts[1].point(at) - net.point(stretch(0.3, 1.0))).length() < 1e-14);
                assert!((part.point(at) - net.point(lo + at * (hi - lo))).length() < 1e-14);
            }
        }
    }

    #[test]
    fn a_grid_of_jacobians_is_that_of_its_places() {
        let net = random_net(4, 0.2);
        for (n, found) in net.jacobians(5).into_iter().enumerate() {
            let at = DVec3::new((n / 25) as f64, (n / 5 % 5) as f64, (n % 5) as f64) / 4.0;
            assert!((net.jacobian(at) - found).abs() < 1e-12, "{at}");
        }
        assert_eq!(net.jacobians(2).len(), 8);
    }

    #[test]
    fn reversal_changes_the_sign_of_the_jacobian() {
        let net = random_net(3, 0.4);
        for axis in Axis::ALL {
            let back = net.reversed(axis);
            assert_eq!(back.reversed(axis), net);
            for seed in 0..10 {
                let at = random_place(seed);
                let mirrored = at + axis.unit() * (1.0 - 2.0 * at[axis as usize]);
                assert!((back.point(mirrored) - net.point(at)).length() < 1e-14);
                assert!((back.jacobian(mirrored) + net.jacobian(at)).abs() < 1e-12);
            }
        }
    }

    /// Edges and faces of the boundary are Bezier curves and surfaces of their own control points.
    #[test]
    fn boundary_parts_are_isoparametric() {
        let net = random_net(4, 0.4);
        for edge in Edge::all() {
            let weights = cubic(0.3);
            let point = net.edge(edge).iter().zip(weights).fold(DVec3::ZERO, |sum, (p, w)| sum + *p * w);
            assert!((point - net.point(edge.parameters(0.3))).length() < 1e-14);
        }
        for face in Face::all() {
            let (s, t) = (cubic(0.3), cubic(0.8));
            let points = net.face(face);
            let point = (0..16).fold(DVec3::ZERO, |sum, n| sum + points[n] * s[n / 4] * t[n % 4]);
            assert!((point - net.point(face.parameters(0.3, 0.8))).length() < 1e-14);
            let [first, second] =
                face.axis.others().map(|axis| net.derivatives(face.parameters(0.3, 0.8))[axis as usize]);
            let across = net.derivatives(face.parameters(0.3, 0.8))[face.axis as usize];
            let outward = across * if face.is_end { 1.0 } else { -1.0 };
            assert_eq!(first.cross(second).dot(outward) > 0.0, face.is_outward());
        }
    }

    /// Three times the mean of the differences of a part, weighted by Bernstein polynomials, is the derivative there.
    #[test]
    fn differences_of_a_part_hold_the_derivatives() {
        let net = random_net(5, 0.4);
        let (lo, hi) = (DVec3::new(0.0, 0.5, 0.25), DVec3::new(1.0, 0.5, 0.75));
        let part = net.differences().part(lo, hi);
        for (axis, list) in part.0.iter().enumerate() {
            let [first, last] = [(0, lo), (47, hi)];
            for (at, place) in [first, last] {
                assert!((list[at] * 3.0 - net.derivatives(place)[axis]).length() < 1e-13);
            }
        }
        assert_eq!(net.differences().part(DVec3::ZERO, DVec3::ONE), net.differences());
    }

    /// A quarter of a ring by cubics: radius within the known relative error 2.73e-4, and never below the true one.
    #[test]
    fn a_quarter_ring_keeps_its_radius_within_the_known_error() {
        let net = quarter_ring(1.0, 2.0, 1.0);
        let mut worst = 0.0_f64;
        for step in 0..=200 {
            let radius = net.point(DVec3::new(f64::from(step) / 200.0, 0.0, 0.5)).truncate().length();
            assert!(radius >= 2.0 - 1e-14);
            worst = worst.max(radius / 2.0 - 1.0);
        }
        assert!((2.70e-4..2.74e-4).contains(&worst), "{worst}");
    }
}
