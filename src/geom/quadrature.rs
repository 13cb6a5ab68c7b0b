//! Gauss-Legendre quadrature.

use std::sync::LazyLock;

/// The rule with 16 nodes, made once: exact for polynomials of degree 31, and near the rounding error for
/// smooth integrands on short intervals.
pub static GAUSS_16: LazyLock<GaussLegendre> = LazyLock::new(|| GaussLegendre::new(16));

/// A Gauss-Legendre rule: with `n` nodes it integrates polynomials of degree `2 n - 1` exactly, up to rounding.
///
/// # References
/// Abramowitz and Stegun, *Handbook of Mathematical Functions* (1964), 25.4.29 and 25.4.30.
#[derive(Debug, Clone, PartialEq)]
pub struct GaussLegendre {
    /// Nodes in (-1, 1), descending, with their weights.
    nodes: Vec<(f64, f64)>,
}

impl GaussLegendre {
    /// Makes the rule with `count` nodes, roots of the Legendre polynomial found by Newton's method.
    ///
    /// # Panics
    /// When `count` is zero.
    #[must_use]
    pub fn new(count: usize) -> Self {
        assert!(count > 0, "a quadrature rule needs a node");
        let n = count as f64;
        let node = |i: usize| {
            // Tricomi's estimate is close enough for Newton to converge to this root and no other.
            let mut x = (std::f64::consts::PI * (i as f64 + 0.75) / (n + 0.5)).cos();
            for _ in 0..8 {
                let (value, slope) = legendre(count, x);
                x -= value / slope;
            }
            let slope = legendre(count, x).1;
            (x, 2.0 / ((1.0 - x * x) * slope * slope))
        };
        Self { nodes: (0..count).map(node).collect() }
    }

    /// Integrates `f` from `a` to `b`; the sign follows the direction.
    #[must_use]
    pub fn integrate(&self, a: f64, b: f64, f: impl Fn(f64) -> f64) -> f64 {
        let (middle, half) = ((a + b) / 2.0, (b - a) / 2.0);
        half * self.nodes.iter().map(|&(x, weight)| weight * f(middle + half * x)).sum::<f64>()
    }

    /// Places between 0 and 1 with their weights, whose sum is 1.
    pub fn places(&self) -> impl Iterator<Item = (f64, f64)> {
        self.nodes.iter().map(|&(x, weight)| ((1.0 + x) / 2.0, weight / 2.0))
    }
}

/// Value and derivative of the Legendre polynomial of the given degree at `x` in (-1, 1).
fn legendre(degree: usize, x: f64) -> (f64, f64) {
    let (mut before, mut value) = (1.0, x);
    for k in 1..degree {
        let k = k as f64;
        (before, value) = (value, ((2.0 * k + 1.0) * x * value - k * before) / (k + 1.0));
    }
    (value, degree as f64 * (before - x * value) / (1.0 - x * x))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_exact_up_to_twice_the_nodes() {
        for count in 1..=33 {
            let rule = GaussLegendre::new(count);
            for power in 0..2 * count as i32 {
                let (a, b) = (-0.25_f64, 1.0_f64);
                let exact = (b.powi(power + 1) - a.powi(power + 1)) / f64::from(power + 1);
                let value = rule.integrate(a, b, |x| x.powi(power));
                assert!((value - exact).abs() < 1e-14, "{count} nodes, power {power}: {value} for {exact}");
            }
        }
    }

    #[test]
    fn smooth_functions_reach_rounding_and_direction_gives_the_sign() {
        let value = GAUSS_16.integrate(0.0, 1.0, f64::exp);
        assert!((value - (std::f64::consts::E - 1.0)).abs() < 1e-15);
        assert!((GAUSS_16.integrate(1.0, 0.0, f64::exp) + value).abs() < 1e-15);
    }
}
