//! A heterogeneous cell: shape and material in 64 coefficients.

use super::bernstein::{contract, cubic, split_net};
use super::{Axis, Net};
use crate::geom::Full;
use crate::material::Composition;
use glam::DVec3;
use std::error::Error;
use std::fmt;
use std::sync::Arc;

/// Largest absolute value of a coordinate: volumes are of the size of its cube, and products of those are far from
/// overflow.
pub const LARGEST_COORDINATE: f64 = 1e9;

/// Largest number of materials that a cell may mix.
pub const MOST_MATERIALS: usize = 16;

/// A tricubic Bezier hyperpatch: the shape and, independent of it, the fraction of each material, both as 64
/// coefficients.
///
/// # Guarantees
/// - Every coordinate is finite and at most [`LARGEST_COORDINATE`] in absolute value.
/// - Every coefficient has a composition of the same number of materials, so every point has one as well (a mean of
///   them).
///
/// Whether the shape is sound, no guarantee is given: see [`validity`](super::validity).
///
/// Copies share their coefficients, so that a body costs little to copy.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    net: Arc<Net>,
    /// The 64 fractions of each material.
    fractions: Arc<Vec<[f64; 64]>>,
}

/// Why coefficients do not make a cell. Indices count from zero.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum CellError {
    /// A coordinate is not finite or larger than the limit.
    Position {
        /// Index of the coefficient.
        index: usize,
        /// The position as given.
        position: DVec3,
    },
    /// Not 64 compositions.
    Count {
        /// Number of compositions given.
        count: usize,
    },
    /// A composition of another number of materials than the first one.
    Materials {
        /// Index of the coefficient.
        index: usize,
        /// Its number of materials.
        count: usize,
        /// The number expected.
        expected: usize,
    },
    /// More materials than a cell may mix.
    TooManyMaterials {
        /// Number of materials.
        count: usize,
    },
    /// A parameter outside the open interval from 0 to 1.
    Parameter {
        /// The parameter as given.
        value: f64,
    },
}

impl fmt::Display for CellError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Position { index, position } => write!(
                f,
                "coefficient {index} lies at ({}, {}, {}); expected finite coordinates of at most {LARGEST_COORDINATE:e} in absolute value",
                Full(position.x),
                Full(position.y),
                Full(position.z)
            ),
            Self::Count { count } => write!(f, "{count} compositions; expected 64"),
            Self::Materials { index, count, expected } => {
                write!(f, "coefficient {index} has {count} fractions; expected {expected}")
            }
            Self::TooManyMaterials { count } => {
                write!(f, "{count} materials; expected at most {MOST_MATERIALS}")
            }
            Self::Parameter { value } => {
                write!(f, "the parameter is {value}; expected more than 0 and less than 1")
            }
        }
    }
}

impl Error for CellError {}

impl Cell {
    /// Checks coefficients: positions and compositions in the order of [`flat`](super::flat).
    ///
    /// # Errors
    /// The first coefficient that breaks a guarantee.
    pub fn new(net: Net, mixes: &[Composition]) -> Result<Self, CellError> {
        check_positions(&net)?;
        if mixes.len() != 64 {
            return Err(CellError::Count { count: mixes.len() });
        }
        let count = mixes[0].fractions().len();
        if count > MOST_MATERIALS {
            return Err(CellError::TooManyMaterials { count });
        }
        if let Some((index, other)) = mixes.iter().enumerate().find(|(_, mix)| mix.fractions().len() != count)
        {
            return Err(CellError::Materials { index, count: other.fractions().len(), expected: count });
        }
        let fractions =
            (0..count).map(|material| std::array::from_fn(|n| mixes[n].fractions()[material])).collect();
        Ok(Self::of(net, fractions))
    }

    /// A cell of one composition throughout.
    ///
    /// # Errors
    /// As [`Cell::new`].
    pub fn uniform(net: Net, mix: &Composition) -> Result<Self, CellError> {
        Self::new(net, &vec![mix.clone(); 64])
    }

    /// A cell whose material goes over from corner to corner with slope zero there: every coefficient of a corner's
    /// block has the composition of the corner, in the order of [`Corner::all`](super::Corner::all).
    ///
    /// With `S_1(t) = 3 t^2 - 2 t^3` and `S_0 = 1 - S_1` the composition is the mean of those of the corners with the
    /// weights `S_a(u) S_b(v) S_c(w)`; so the paper keeps continuity of first order across faces (section 3.5, Fig.
    /// 10).
    ///
    /// # Errors
    /// As [`Cell::new`].
    pub fn with_corner_mixes(net: Net, mixes: &[Composition; 8]) -> Result<Self, CellError> {
        let corner = |n: usize| (n / 32) * 4 + (n / 8 % 2) * 2 + n / 2 % 2;
        let all: Vec<Composition> = (0..64).map(|n| mixes[corner(n)].clone()).collect();
        Self::new(net, &all)
    }

    /// The cell of checked coefficients.
    fn of(net: Net, fractions: Vec<[f64; 64]>) -> Self {
        Self { net: Arc::new(net), fractions: Arc::new(fractions) }
    }

    /// Whether two cells have the same shape, number for number.
    #[must_use]
    pub fn has_shape_of(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.net, &other.net) || self.net == other.net
    }

    /// Whether two cells are the same in shape and in material, number for number.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        self.has_shape_of(other)
            && (Arc::ptr_eq(&self.fractions, &other.fractions) || self.fractions == other.fractions)
    }

    /// The shape.
    #[must_use]
    pub fn net(&self) -> &Net {
        &self.net
    }

    /// Number of materials.
    #[must_use]
    pub fn materials(&self) -> usize {
        self.fractions.len()
    }

    /// The 64 fractions of each material.
    #[must_use]
    pub fn fractions(&self) -> &[[f64; 64]] {
        &self.fractions
    }

    /// Composition of the coefficient at a place in the list of 64.
    ///
    /// # Panics
    /// When `index` is not below 64.
    #[must_use]
    pub fn mix(&self, index: usize) -> Composition {
        Composition::rounded(self.fractions.iter().map(|list| list[index]).collect())
    }

    /// The point at parameters in [0, 1].
    #[must_use]
    pub fn point(&self, at: DVec3) -> DVec3 {
        self.net.point(at)
    }

    /// The composition at parameters, which are clamped to [0, 1].
    #[must_use]
    pub fn composition(&self, at: DVec3) -> Composition {
        let weights = at.clamp(DVec3::ZERO, DVec3::ONE).to_array().map(cubic);
        Composition::rounded(self.fractions.iter().map(|list| contract(list, &weights)).collect())
    }

    /// The same material in another shape: what is inside moves with it.
    ///
    /// # Errors
    /// When a coordinate is not finite or too large.
    pub fn with_net(&self, net: Net) -> Result<Self, CellError> {
        check_positions(&net)?;
        Ok(Self { net: Arc::new(net), fractions: Arc::clone(&self.fractions) })
    }

    /// The control points to be changed in place; whoever does so [checks](Cell::check) them afterwards.
    pub(super) fn net_mut(&mut self) -> &mut Net {
        Arc::make_mut(&mut self.net)
    }

    /// The fractions to be changed in place; whoever does so keeps the compositions in the simplex.
    pub(super) fn fractions_mut(&mut self) -> &mut [[f64; 64]] {
        Arc::make_mut(&mut self.fractions).as_mut_slice()
    }

    /// Whether positions that were changed in place are finite and not too large.
    ///
    /// # Errors
    /// The first that is not.
    pub(super) fn check(&self) -> Result<(), CellError> {
        check_positions(&self.net)
    }

    /// The two cells on either side of `t` along an axis. Together they are the cell: neither shape nor material
    /// changes.
    ///
    /// # Errors
    /// When `t` does not lie between 0 and 1.
    pub fn split(&self, axis: Axis, t: f64) -> Result<[Self; 2], CellError> {
        if !(t > 0.0 && t < 1.0) {
            return Err(CellError::Parameter { value: t });
        }
        let [first, second] = self.net.split(axis, t);
        let (mut before, mut after) = (Vec::new(), Vec::new());
        for list in self.fractions.iter() {
            let [a, b] = split_net(list, axis, t);
            before.push(a);
            after.push(b);
        }
        Ok([Self::of(first, before), Self::of(second, after)])
    }

    /// The same body run through in the opposite direction of an axis; it turns a mirrored cell into a sound one.
    #[must_use]
    pub fn reversed(&self, axis: Axis) -> Self {
        let step = super::bernstein::stride(axis);
        let source = |at: usize| at + (3 - at / step % 4) * step - at / step % 4 * step;
        let fractions =
            self.fractions.iter().map(|list| std::array::from_fn(|at| list[source(at)])).collect();
        Self::of(self.net.reversed(axis), fractions)
    }
}

/// Refuses coordinates that are not finite or too large.
fn check_positions(net: &Net) -> Result<(), CellError> {
    let is_good = |p: &DVec3| p.is_finite() && p.abs().max_element() <= LARGEST_COORDINATE;
    match net.0.iter().position(|point| !is_good(point)) {
        Some(index) => Err(CellError::Position { index, position: net.0[index] }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::Corner;
    use crate::hyperpatch::test_cells::{random, random_net, random_place};

    fn random_cell(seed: u64) -> Cell {
        let mix = |n: u64| {
            let parts = [0, 1, 2].map(|m| random(seed * 500 + n * 3 + m));
            let sum: f64 = parts.iter().sum();
            Composition::new(parts.map(|part| part / sum).to_vec()).unwrap()
        };
        let mixes: Vec<Composition> = (0..64).map(mix).collect();
        Cell::new(random_net(seed, 0.2), &mixes).unwrap()
    }

    #[test]
    fn splitting_keeps_shape_and_material() {
        let cell = random_cell(1);
        for axis in Axis::ALL {
            let parts = cell.split(axis, 0.375).unwrap();
            for seed in 0..20 {
                let at = random_place(seed);
                for (part, from, to) in [(&parts[0], 0.0, 0.375), (&parts[1], 0.375, 1.0)] {
                    let whole = at + axis.unit() * (from + at[axis as usize] * (to - from - 1.0));
                    assert!((part.point(at) - cell.point(whole)).length() < 1e-14);
                    let (a, b) = (part.composition(at), cell.composition(whole));
                    assert!(a.fractions().iter().zip(b.fractions()).all(|(a, b)| (a - b).abs() < 1e-14));
                }
            }
        }
        for t in [0.0, 1.0, -0.5, f64::NAN] {
            assert!(matches!(cell.split(Axis::U, t), Err(CellError::Parameter { .. })), "{t}");
        }
    }

    /// The closed form of the paper's rule for materials: smoothsteps of the parameters.
    #[test]
    fn corner_mixes_go_over_by_smoothsteps() {
        let corners = Corner::all().map(|corner| {
            let share = random(corner.coefficient() as u64);
            Composition::new(vec![share, 1.0 - share]).unwrap()
        });
        let cell = Cell::with_corner_mixes(random_net(2, 0.2), &corners).unwrap();
        for seed in 0..50 {
            let at = random_place(seed);
            let step = at * at * (DVec3::splat(3.0) - 2.0 * at);
            let mut share = 0.0;
            for (corner, mix) in Corner::all().iter().zip(&corners) {
                let weight = |n: usize| if corner.0[n] { step[n] } else { 1.0 - step[n] };
                share += mix.fractions()[0] * weight(0) * weight(1) * weight(2);
            }
            assert!((cell.composition(at).fractions()[0] - share).abs() < 1e-14);
        }
        for (corner, mix) in Corner::all().iter().zip(&corners) {
            assert!(corner.block().iter().all(|&at| cell.mix(at) == *mix));
        }
    }

    #[test]
    fn reversal_keeps_the_body() {
        let cell = random_cell(3);
        for axis in Axis::ALL {
            let (back, at) = (cell.reversed(axis), DVec3::new(0.2, 0.6, 0.9));
            let mirrored = at + axis.unit() * (1.0 - 2.0 * at[axis as usize]);
            assert!((back.point(mirrored) - cell.point(at)).length() < 1e-14);
            let (a, b) = (back.composition(mirrored), cell.composition(at));
            assert!((a.fractions()[2] - b.fractions()[2]).abs() < 1e-14);
        }
    }

    #[test]
    fn the_material_follows_the_shape() {
        let cell = random_cell(4);
        let moved = cell.with_net(cell.net().map(|p| p * 3.0 + DVec3::X)).unwrap();
        let at = DVec3::new(0.2, 0.6, 0.9);
        assert_eq!(moved.composition(at), cell.composition(at));
        assert!((moved.point(at) - (cell.point(at) * 3.0 + DVec3::X)).length() < 1e-13);
    }

    #[test]
    fn wrong_coefficients_are_refused_with_their_place() {
        let net = random_net(5, 0.1);
        let mix = Composition::pure(0, 2);
        for bad in [f64::NAN, f64::INFINITY, 2e9] {
            let mut wrong = net.clone();
            wrong.0[17].y = bad;
            assert!(matches!(Cell::uniform(wrong.clone(), &mix), Err(CellError::Position { index: 17, .. })));
            let cell = Cell::uniform(net.clone(), &mix).unwrap();
            assert!(cell.with_net(wrong).unwrap_err().to_string().contains("coefficient 17"));
        }
        let mut mixes = vec![mix; 64];
        mixes[40] = Composition::pure(0, 3);
        assert_eq!(
            Cell::new(net.clone(), &mixes),
            Err(CellError::Materials { index: 40, count: 3, expected: 2 })
        );
        assert_eq!(Cell::new(net.clone(), &mixes[..63]), Err(CellError::Count { count: 63 }));
        let many = Composition::pure(0, MOST_MATERIALS + 1);
        assert_eq!(Cell::uniform(net, &many), Err(CellError::TooManyMaterials { count: MOST_MATERIALS + 1 }));
    }
}
