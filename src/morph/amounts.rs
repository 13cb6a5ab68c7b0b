//! How much of each material a band holds.

use super::cell::Patch;
use super::cuts::cuts;
use super::{Band, Ruling};
use crate::curve::BSpline;
use crate::geom::GaussLegendre;
use crate::material::Composition;

/// Degree of curves up to which the quadrature is exact: as many nodes and one more.
const EXACT_DEGREE: usize = 7;
/// Nodes on all parts together, above that degree: it bounds the time. Many parts are short, and few nodes serve.
const NODES_IN_ALL: usize = 4000;

/// Area of a band in the plane and of each material in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Amounts {
    /// Area of the band, in the square of the unit.
    pub area: f64,
    /// Integral of the fraction of each material over the area; their sum is the area.
    pub materials: Vec<f64>,
}

impl Amounts {
    fn none(count: usize) -> Self {
        Self { area: 0.0, materials: vec![0.0; count] }
    }

    fn add(&mut self, weight: f64, composition: &Composition) {
        self.area += weight;
        for (amount, fraction) in self.materials.iter_mut().zip(composition.fractions()) {
            *amount += weight * fraction;
        }
    }

    /// Counts the other side as the front where the area is negative.
    fn turned(mut self) -> Self {
        if self.area < 0.0 {
            self.area = -self.area;
            self.materials.iter_mut().for_each(|amount| *amount = -*amount);
        }
        self
    }

    /// Largest difference from other amounts, of the area or of a material.
    #[must_use]
    pub fn difference(&self, other: &Self) -> f64 {
        let pairs = self.materials.iter().zip(&other.materials);
        pairs.fold((self.area - other.area).abs(), |most, (a, b)| most.max((a - b).abs()))
    }
}

/// Integrates over the band between two curves themselves, and estimates the error of the area and of every amount.
///
/// `places` are the parameters (u, v) of the ends of the lines, in cyclic order and ascending beyond the ends of the domains; between
/// two lines both run evenly. `compose(curve, u)` is the composition along a curve, and `keys` are the parameters where it is not
/// linear.
///
/// The point at the share s of a ruling is (1 - s) C1 + s C2, so that along a ruling the integrand is a polynomial of degree 2, which is
/// integrated as such. From ruling to ruling it is one of twice the degree of the curves between two lines, knots or keys: Gauss quadrature is
/// exact there up to degree 7. The estimate is the difference from the rule with one more node, or the rounding error.
///
/// Parts of a band that are turned over against the band as a whole count as negative. So the area of a closed band is always that between
/// its curves.
#[must_use]
pub fn amounts(
    curves: &[BSpline; 2],
    places: &[(f64, f64)],
    keys: [&[f64]; 2],
    compose: impl Fn(usize, f64) -> Composition,
) -> (Amounts, f64) {
    let parts = cuts(curves, places, keys);
    let degree = curves[0].degree().max(curves[1].degree());
    let nodes = if degree <= EXACT_DEGREE {
        degree + 1
    } else {
        (NODES_IN_ALL / parts.len().max(1)).clamp(2, EXACT_DEGREE + 1)
    };
    let count = places.first().map_or(0, |&(u, _)| compose(0, u).fractions().len());
    let [found, finer] = [nodes, nodes + 1].map(|nodes| {
        let rule = GaussLegendre::new(nodes);
        let mut sum = Amounts::none(count);
        for &((u0, v0), (u1, v1)) in &parts {
            for (t, weight) in rule.places() {
                let (u, v) = (u0 + t * (u1 - u0), v0 + t * (v1 - v0));
                let (first, second) = (curves[0].derivatives(u, 1), curves[1].derivatives(v, 1));
                let along = second[0] - first[0];
                // The Jacobian at either end of the ruling; in between it is linear.
                let near = along.perp_dot(first[1] * (u1 - u0)) * weight;
                let far = along.perp_dot(second[1] * (v1 - v0)) * weight;
                sum.add(near / 3.0 + far / 6.0, &compose(0, u));
                sum.add(near / 6.0 + far / 3.0, &compose(1, v));
            }
        }
        sum.turned()
    });
    let error = found.difference(&finer).max(f64::EPSILON * finer.area);
    (finer, error)
}

/// Sums up the unit cells of a band: the bilinear patches on the ends of its lines, which in-between curves cut without a rest. Tells of
/// how many patches a part is turned over, too.
///
/// Their chords lie off the curves: the difference from [`amounts`] falls with the square of the distance of the lines.
#[must_use]
pub fn cell_amounts(band: &Band) -> (Amounts, usize) {
    let lines: Vec<&Ruling> = band.lines().collect();
    let count = lines.first().map_or(0, |line| line.ends[0].fractions().len());
    let mut sum = Amounts::none(count);
    let gaps = if band.is_closed() { lines.len() } else { lines.len().saturating_sub(1) };
    let mut turned = [0, 0];
    for (line, this) in lines.iter().enumerate().take(gaps) {
        let next = lines[(line + 1) % lines.len()];
        let patch = Patch::new(&[this.from, this.to, next.to, next.from]);
        let [a, b, c, d] = patch.weights();
        for (turned, sign) in turned.iter_mut().zip([1.0, -1.0]) {
            *turned += usize::from(patch.is_turned(sign));
        }
        sum.add(a, &this.ends[0]);
        sum.add(b, &this.ends[1]);
        sum.add(c, &next.ends[1]);
        sum.add(d, &next.ends[0]);
    }
    let folded = turned[usize::from(sum.area < 0.0)];
    (sum.turned(), folded)
}
