//! The Jacobian determinant of a cell as a polynomial of degree 8 along each axis, with exact integrals.

use super::bernstein::binomial;
use super::{Cell, Net};
use glam::DVec3;

/// Number of coefficients along an axis.
pub(super) const SIZE: usize = 9;
/// Number of all coefficients.
pub(super) const COUNT: usize = SIZE * SIZE * SIZE;

/// Half the distance from 1 to the next larger double.
const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// Places of the values at the 8 corners, in the order of [`Corner::all`](super::Corner::all).
pub(super) const CORNERS: [usize; 8] = {
    let mut places = [0; 8];
    let mut n = 0;
    while n < 8 {
        places[n] = 8 * ((n / 4 * SIZE + n / 2 % 2) * SIZE + n % 2);
        n += 1;
    }
    places
};

/// The Jacobian determinant of a cell in Bernstein form: 9 x 9 x 9 coefficients, the last index fastest.
///
/// The determinant lies between the least and the greatest coefficient, and takes the values of the coefficients at
/// the corners.
///
/// # References
/// A. Johnen, J.-F. Remacle and C. Geuzaine, "Geometrical validity of curvilinear finite elements", *Journal of
/// Computational Physics* 233 (2013).
#[derive(Debug, Clone, PartialEq)]
pub struct Jacobian {
    coefficients: Vec<f64>,
    error: f64,
}

impl Jacobian {
    /// Computes the coefficients: with `D` the differences of neighbouring control points,
    ///
    /// `J_pqr = 27 sum C(2,i1) C(3,i2) C(3,i3) / C(8,p) * ... * det(Du_{i1 j1 k1}, Dv_{i2 j2 k2}, Dw_{i3 j3 k3})`
    ///
    /// over `i1 + i2 + i3 = p` and so on. The cross products of the first two factors are collected by their places
    /// (252), so that 12,096 products take the place of 110,592 determinants.
    #[must_use]
    pub fn new(net: &Net) -> Self {
        let differences = net.differences();
        let [du, dv, dw] = &differences.0;
        let size = |list: &[DVec3; 48]| list.iter().map(|d| d.length_squared()).fold(0.0, f64::max).sqrt();
        // Sum of at most 48 terms twice, of products of three differences that are each rounded once; their absolute
        // values sum to less than 1.2 times the product of the lengths.
        let error = 27.0 * 384.0 * UNIT_ROUNDOFF * size(du) * size(dv) * size(dw);
        let (du, dv, dw) = (scaled(du, [3, 4, 4]), scaled(dv, [4, 3, 4]), scaled(dw, [4, 4, 3]));

        let mut normals = [[[0.0; 7]; 3]; 36];
        for (a, du) in du.chunks_exact(4).enumerate() {
            for (b, dv) in dv.chunks_exact(4).enumerate() {
                let [x, y, z] = &mut normals[(a / 4 + b / 3) * 6 + a % 4 + b % 3];
                for (k, du) in du.iter().enumerate() {
                    for (l, dv) in dv.iter().enumerate() {
                        x[k + l] += du.y * dv.z - du.z * dv.y;
                        y[k + l] += du.z * dv.x - du.x * dv.z;
                        z[k + l] += du.x * dv.y - du.y * dv.x;
                    }
                }
            }
        }
        let mut lines = [[0.0; SIZE]; SIZE * SIZE];
        for (a, [x, y, z]) in normals.iter().enumerate() {
            for (b, dw) in dw.chunks_exact(3).enumerate() {
                let line = &mut lines[(a / 6 + b / 4) * SIZE + a % 6 + b % 4];
                for (k, d) in dw.iter().enumerate() {
                    for (n, value) in line[k..k + 7].iter_mut().enumerate() {
                        *value += x[n] * d.x + y[n] * d.y + z[n] * d.z;
                    }
                }
            }
        }
        let mut coefficients = Vec::with_capacity(COUNT);
        for (place, line) in lines.iter().enumerate() {
            let scale = 27.0 / (binomial(8, place / SIZE) * binomial(8, place % SIZE));
            coefficients.extend(line.iter().enumerate().map(|(r, value)| value * scale / binomial(8, r)));
        }
        Self { coefficients, error }
    }

    /// The 729 coefficients.
    #[must_use]
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    /// How far any coefficient may be from the exact one, because sums and products are rounded.
    #[must_use]
    pub fn error(&self) -> f64 {
        self.error
    }

    /// The volume of the cell, where the determinant is nowhere negative: the mean of the coefficients. Parts that
    /// are turned inside out count with a minus.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.coefficients.iter().sum::<f64>() / COUNT as f64
    }

    /// The integral of each Bernstein polynomial of degree 3 over the cell, in the order of its coefficients; they
    /// sum to the volume.
    ///
    /// `W_ijk = 12^-3 sum J_pqr C(3,i) C(8,p) / C(11,i+p) * ...`
    #[must_use]
    pub fn weights(&self) -> [f64; 64] {
        let product = |i: usize, p: usize| binomial(3, i) * binomial(8, p) / binomial(11, i + p) / 12.0;
        let table: [[f64; SIZE]; 4] = std::array::from_fn(|i| std::array::from_fn(|p| product(i, p)));
        let mut weights = [0.0; 64];
        for (place, line) in self.coefficients.chunks_exact(SIZE).enumerate() {
            let (p, q) = (place / SIZE, place % SIZE);
            let along: [f64; 4] =
                std::array::from_fn(|k| line.iter().zip(table[k]).map(|(a, b)| a * b).sum());
            for (at, weight) in weights.iter_mut().enumerate() {
                *weight += table[at / 16][p] * table[at / 4 % 4][q] * along[at % 4];
            }
        }
        weights
    }
}

impl Cell {
    /// The volume of each material in the cell: exact up to rounding. Their sum is the volume of the cell.
    #[must_use]
    pub fn amounts(&self) -> Vec<f64> {
        let weights = Jacobian::new(self.net()).weights();
        let amount =
            |list: &[f64; 64]| list.iter().zip(weights).map(|(fraction, weight)| fraction * weight).sum();
        self.fractions().iter().map(amount).collect()
    }
}

/// Differences times the binomials of their places.
fn scaled(differences: &[DVec3; 48], sizes: [usize; 3]) -> [DVec3; 48] {
    std::array::from_fn(|at| {
        let places = [at / (sizes[1] * sizes[2]), at / sizes[2] % sizes[1], at % sizes[2]];
        let factor = |n: usize| binomial(sizes[n] - 1, places[n]);
        differences[at] * (factor(0) * factor(1) * factor(2))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::GaussLegendre;
    use crate::hyperpatch::Corner;
    use crate::hyperpatch::test_cells::{quarter_ring, random, random_net, random_place, ring_cell};
    use crate::material::Composition;

    /// The coefficients of integral control points times `C(8,p) C(8,q) C(8,r) / 27`, from all 110,592 determinants
    /// in integers.
    fn exact(net: &[[i128; 3]; 64]) -> Vec<i128> {
        let choose = |n: usize, k: usize| binomial(n, k) as i128;
        let list = |step: usize, sizes: [usize; 3]| {
            let mut all = Vec::new();
            for i in 0..sizes[0] {
                for j in 0..sizes[1] {
                    for k in 0..sizes[2] {
                        let at = (i * 4 + j) * 4 + k;
                        let scale =
                            choose(sizes[0] - 1, i) * choose(sizes[1] - 1, j) * choose(sizes[2] - 1, k);
                        all.push(([i, j, k], [0, 1, 2].map(|n| scale * (net[at + step][n] - net[at][n]))));
                    }
                }
            }
            all
        };
        let mut sums = vec![0; COUNT];
        for (at_u, a) in list(16, [3, 4, 4]) {
            for (at_v, b) in list(4, [4, 3, 4]) {
                let normal =
                    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
                for (at_w, c) in list(1, [4, 4, 3]) {
                    let [p, q, r] = [0, 1, 2].map(|n| at_u[n] + at_v[n] + at_w[n]);
                    sums[(p * SIZE + q) * SIZE + r] += normal[0] * c[0] + normal[1] * c[1] + normal[2] * c[2];
                }
            }
        }
        sums
    }

    #[test]
    fn coefficients_are_those_of_rational_arithmetic() {
        for seed in 0..3 {
            let integral: [[i128; 3]; 64] = std::array::from_fn(|n| {
                let place = [n / 16, n / 4 % 4, n % 4];
                std::array::from_fn(|axis| {
                    let jitter = random(seed * 192 + n as u64 * 3 + axis as u64) * 600.0 - 300.0;
                    place[axis] as i128 * 1000 + jitter as i128
                })
            });
            let net = Net(integral.map(|p| DVec3::new(p[0] as f64, p[1] as f64, p[2] as f64)));
            let jacobian = Jacobian::new(&net);
            let mut sum = 0.0;
            for (at, exact) in exact(&integral).into_iter().enumerate() {
                let [p, q, r] = [at / 81, at / 9 % 9, at % 9].map(|n| binomial(8, n));
                let expected = exact as f64 * 27.0 / (p * q * r);
                let found = jacobian.coefficients()[at];
                assert!((found - expected).abs() <= 1e-15 * expected.abs(), "{found}, expected {expected}");
                assert!((found - expected).abs() <= jacobian.error());
                sum += expected;
            }
            assert!((jacobian.volume() - sum / 729.0).abs() < 1e-13 * sum / 729.0);
        }
    }

    /// The polynomial of the coefficients against the determinant of the derivatives, within the stated error of
    /// either.
    #[test]
    fn the_polynomial_is_the_determinant() {
        for seed in 0..10 {
            let net = random_net(seed, 0.5);
            let jacobian = Jacobian::new(&net);
            let power = |t: f64, n: usize| binomial(8, n) * t.powi(n as i32) * (1.0 - t).powi(8 - n as i32);
            for n in 0..20 {
                let at = random_place(n);
                let weight = |k: usize| power(at.x, k / 81) * power(at.y, k / 9 % 9) * power(at.z, k % 9);
                let value: f64 = (0..COUNT).map(|k| jacobian.coefficients()[k] * weight(k)).sum();
                assert!((value - net.jacobian(at)).abs() < 1e-13, "{value}");
            }
            for (corner, place) in Corner::all().iter().zip(CORNERS) {
                let value = net.jacobian(corner.parameters());
                assert!((jacobian.coefficients()[place] - value).abs() <= jacobian.error() + 1e-15);
            }
        }
    }

    /// The error bound is of the size of roundings: neither hides a thin cell nor promises too much.
    #[test]
    fn moving_a_cell_far_away_stays_within_the_error() {
        let net = random_net(3, 0.2).map(|p| (p * 1024.0).round() / 1024.0);
        let far = net.map(|p| p + DVec3::splat(1_048_576.0));
        let (near, far) = (Jacobian::new(&net), Jacobian::new(&far));
        assert_eq!(near.coefficients(), far.coefficients(), "differences of short numbers are exact");
        assert!(near.error() < 1e-11);
    }

    #[test]
    fn volumes_of_known_bodies() {
        let cuboid = Jacobian::new(&Net::cuboid(DVec3::ZERO, DVec3::new(2.0, 3.0, 5.0)));
        assert!((cuboid.volume() - 30.0).abs() < 1e-12);
        assert!(cuboid.coefficients().iter().all(|c| (c - 30.0).abs() < 1e-12));
        // A ring of twelve cells against the exact ring: the area within twice the known radial error, 3.7e-7.
        let ring: f64 = (0..12).map(|n| Jacobian::new(&ring_cell(12, n, 1.0, 2.0, 1.0)).volume()).sum();
        let exact = 3.0 * std::f64::consts::PI;
        assert!(ring > exact && ring < exact * (1.0 + 2.0 * 3.7e-7), "{ring}, exact {exact}");
    }

    /// Amounts against Gauss quadrature of fraction times determinant, which is exact for these degrees.
    #[test]
    fn amounts_of_material_are_integrals() {
        let mixes = Corner::all().map(|corner| {
            let share = random(corner.coefficient() as u64);
            Composition::new(vec![share, 0.5 * (1.0 - share), 0.5 * (1.0 - share)]).unwrap()
        });
        let cell = Cell::with_corner_mixes(quarter_ring(1.0, 2.0, 1.5), &mixes).unwrap();
        let rule = GaussLegendre::new(6);
        let integral = |material: usize| {
            rule.integrate(0.0, 1.0, |u| {
                rule.integrate(0.0, 1.0, |v| {
                    rule.integrate(0.0, 1.0, |w| {
                        let at = DVec3::new(u, v, w);
                        cell.composition(at).fractions()[material] * cell.net().jacobian(at)
                    })
                })
            })
        };
        let amounts = cell.amounts();
        for (material, amount) in amounts.iter().enumerate() {
            assert!((amount - integral(material)).abs() < 1e-12, "{amount}, expected {}", integral(material));
        }
        let volume = Jacobian::new(cell.net()).volume();
        assert!((amounts.iter().sum::<f64>() - volume).abs() < 1e-13);
    }

    #[test]
    fn splitting_keeps_the_volume() {
        let net = random_net(4, 0.15);
        let parts = net.split(crate::hyperpatch::Axis::V, 0.3);
        let sum: f64 = parts.iter().map(|part| Jacobian::new(part).volume()).sum();
        assert!((sum - Jacobian::new(&net).volume()).abs() < 1e-14);
    }
}
