//! Axes, corners, edges and faces of a cell by their coefficients.

use super::bernstein::{flat, lines, stride};
use glam::DVec3;
use std::fmt;

/// A parameter of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Axis {
    /// The first parameter; index i.
    U,
    /// The second parameter; index j.
    V,
    /// The third parameter; index k.
    W,
}

impl Axis {
    /// Every axis.
    pub const ALL: [Self; 3] = [Self::U, Self::V, Self::W];

    /// The two other axes, in order.
    #[must_use]
    pub fn others(self) -> [Self; 2] {
        match self {
            Self::U => [Self::V, Self::W],
            Self::V => [Self::U, Self::W],
            Self::W => [Self::U, Self::V],
        }
    }

    /// Unit vector of the axis in parameter space.
    #[must_use]
    pub fn unit(self) -> DVec3 {
        DVec3::AXES[self as usize]
    }
}

/// One of the 8 corners of a cell: whether it lies at the end (1) of each axis, or at the start (0).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Corner(pub [bool; 3]);

/// One of the 12 boundary curves of a cell: it runs along `axis`; `ends` says where it lies on the other two, in order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Edge {
    /// The axis along which the curve runs.
    pub axis: Axis,
    /// Whether it lies at the end of each of the other two axes.
    pub ends: [bool; 2],
}

/// One of the 6 boundary faces of a cell: the one at the start or the end of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Face {
    /// The axis that the face lies across.
    pub axis: Axis,
    /// Whether it lies at the end (1) of the axis.
    pub is_end: bool,
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(["u", "v", "w"][*self as usize])
    }
}

impl fmt::Display for Corner {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b, c] = self.0.map(u8::from);
        write!(f, "[{a}, {b}, {c}]")
    }
}

impl fmt::Display for Face {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.axis, u8::from(self.is_end))
    }
}

impl Corner {
    /// The corner whose block has a coefficient, by its place in a list of 64, and the place in the
    /// [block](Corner::block).
    #[must_use]
    pub fn of(at: usize) -> (Self, usize) {
        let index = [at / 16, at / 4 % 4, at % 4];
        let bit = |axis: usize| if index[axis] == 1 || index[axis] == 2 { 4 >> axis } else { 0 };
        (Self(index.map(|n| n >= 2)), bit(0) | bit(1) | bit(2))
    }

    /// Every corner; w runs fastest.
    #[must_use]
    pub fn all() -> [Self; 8] {
        std::array::from_fn(|n| Self([n & 4 != 0, n & 2 != 0, n & 1 != 0]))
    }

    /// Place of the coefficient at the corner in a list of 64.
    #[must_use]
    pub fn coefficient(self) -> usize {
        let [i, j, k] = self.0.map(|is_end| if is_end { 3 } else { 0 });
        flat(i, j, k)
    }

    /// Places of the 8 coefficients of the corner's block, which no other corner has; the corner itself comes first.
    ///
    /// Bits of the place in the list say along which axes a coefficient is one step inside: w is bit 0, v bit 1 and u
    /// bit 2.
    #[must_use]
    pub fn block(self) -> [usize; 8] {
        std::array::from_fn(|n| {
            let index = |axis: usize| {
                let inside = usize::from(n & (4 >> axis) != 0);
                if self.0[axis] { 3 - inside } else { inside }
            };
            flat(index(0), index(1), index(2))
        })
    }

    /// Parameters of the corner.
    #[must_use]
    pub fn parameters(self) -> DVec3 {
        DVec3::from_array(self.0.map(|is_end| if is_end { 1.0 } else { 0.0 }))
    }

    /// The three faces at the corner, one across each axis.
    #[must_use]
    pub fn faces(self) -> [Face; 3] {
        Axis::ALL.map(|axis| Face { axis, is_end: self.0[axis as usize] })
    }
}

impl Edge {
    /// Every boundary curve, axis by axis.
    #[must_use]
    pub fn all() -> [Self; 12] {
        std::array::from_fn(|n| Self { axis: Axis::ALL[n / 4], ends: [n & 2 != 0, n & 1 != 0] })
    }

    /// Places of its 4 coefficients in a list of 64, from the start.
    #[must_use]
    pub fn coefficients(self) -> [usize; 4] {
        let others = self.axis.others();
        let end = |n: usize| if self.ends[n] { 3 * stride(others[n]) } else { 0 };
        [0, 1, 2, 3].map(|n| n * stride(self.axis) + end(0) + end(1))
    }

    /// Parameters of the point at `t` along the curve.
    #[must_use]
    pub fn parameters(self, t: f64) -> DVec3 {
        let others = self.axis.others();
        let end = |n: usize| if self.ends[n] { others[n].unit() } else { DVec3::ZERO };
        self.axis.unit() * t + end(0) + end(1)
    }
}

impl Face {
    /// Every face: two for each axis, start before end.
    #[must_use]
    pub fn all() -> [Self; 6] {
        std::array::from_fn(|n| Self { axis: Axis::ALL[n / 2], is_end: n % 2 == 1 })
    }

    /// Places of its 16 coefficients in a list of 64; the later of the two axes of the face runs fastest.
    #[must_use]
    pub fn coefficients(self) -> [usize; 16] {
        let mut starts = lines(self.axis);
        let end = if self.is_end { 3 * stride(self.axis) } else { 0 };
        std::array::from_fn(|_| starts.next().map_or(0, |at| at + end))
    }

    /// Place of the coefficient one step inside from one on the face.
    #[must_use]
    pub fn inside(self, at: usize) -> usize {
        if self.is_end { at - stride(self.axis) } else { at + stride(self.axis) }
    }

    /// Parameters of the point at (`s`, `t`) on the face, along its two axes in order.
    #[must_use]
    pub fn parameters(self, s: f64, t: f64) -> DVec3 {
        let [first, second] = self.axis.others();
        let end = if self.is_end { self.axis.unit() } else { DVec3::ZERO };
        first.unit() * s + second.unit() * t + end
    }

    /// Whether the normal that points out of a cell of positive Jacobian is the cross product of the derivatives
    /// along the two axes of the face, in order, rather than its opposite.
    #[must_use]
    pub fn is_outward(self) -> bool {
        (self.axis == Axis::V) != self.is_end
    }

    /// The four boundary curves of the face: along its first axis at the start and the end of the second, then along
    /// its second axis at the start and the end of the first.
    #[must_use]
    pub fn edges(self) -> [Edge; 4] {
        let [first, second] = self.axis.others();
        let edge = |along: Axis, across: Axis, is_end: bool| {
            let of = |axis: Axis| if axis == across { is_end } else { self.is_end };
            Edge { axis: along, ends: along.others().map(of) }
        };
        [
            edge(first, second, false),
            edge(first, second, true),
            edge(second, first, false),
            edge(second, first, true),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_know_their_coefficients() {
        let mut blocks: Vec<usize> = Corner::all().iter().flat_map(|corner| corner.block()).collect();
        blocks.sort_unstable();
        assert_eq!(blocks, (0..64).collect::<Vec<_>>(), "every coefficient belongs to one corner");
        for corner in Corner::all() {
            assert_eq!(corner.block()[0], corner.coefficient());
            for (n, at) in corner.block().into_iter().enumerate() {
                assert_eq!(Corner::of(at), (corner, n));
            }
            for face in corner.faces() {
                assert!(face.coefficients().contains(&corner.coefficient()));
            }
        }
        assert_eq!(Edge { axis: Axis::V, ends: [true, false] }.coefficients(), [48, 52, 56, 60]);
        let face = Face { axis: Axis::W, is_end: true };
        assert_eq!(face.coefficients()[..5], [3, 7, 11, 15, 19]);
        assert_eq!([face.to_string(), Corner([true, false, true]).to_string()], ["w1", "[1, 0, 1]"]);
    }

    #[test]
    fn edges_of_a_face_lie_on_it() {
        for face in Face::all() {
            for (n, edge) in face.edges().into_iter().enumerate() {
                assert!(edge.coefficients().iter().all(|at| face.coefficients().contains(at)));
                let (s, t) = [(0.25, 0.0), (0.25, 1.0), (0.0, 0.25), (1.0, 0.25)][n];
                assert_eq!(edge.parameters(0.25), face.parameters(s, t));
            }
        }
    }

    #[test]
    fn every_edge_is_on_two_faces() {
        for edge in Edge::all() {
            assert_eq!(Face::all().iter().filter(|face| face.edges().contains(&edge)).count(), 2);
        }
    }
}
