//! What there is round a corner, for whoever wants to show or edit it.

use super::OperationError;
use super::star::{Kind, Star};
use crate::hyperpatch::Corner;
use crate::hyperpatch::composite::{Body, CellId, Match, Side};
use crate::material::Composition;
use glam::DVec3;

/// The cells and coefficients round a corner: its grid of immediate neighbours (section 4.1 of the paper, Fig. 12).
#[derive(Debug, Clone, PartialEq)]
pub struct Neighbourhood {
    /// The cells at the point, each with the corner that lies there.
    pub cells: Vec<(CellId, Corner)>,
    /// Whether the cells lie in a grid of two by two by two, which may have gaps; at an irregular corner (Fig. 13)
    /// nothing runs on by itself.
    pub is_regular: bool,
    /// The coefficients of their blocks, equal ones once; at a corner of eight cells 27, the corner itself among them.
    pub points: Vec<Neighbour>,
    /// The faces between cells at the corner.
    pub joints: Vec<JointState>,
}

/// A coefficient at a corner.
#[derive(Debug, Clone, PartialEq)]
pub struct Neighbour {
    /// Where it lies in the grid, along the axes of the cell that was asked about: -1, 0 or 1 each, towards the end
    /// of the axis positive. `None` at an irregular corner and in cells that no face leads to.
    pub offset: Option<[i8; 3]>,
    /// Its position.
    pub position: DVec3,
    /// Its composition in the first cell that has it.
    pub mix: Composition,
    /// Whether other cells have another composition there.
    pub jumps: bool,
    /// The cells that have it, with its place in their lists of 64.
    pub users: Vec<(CellId, usize)>,
}

/// What holds between two cells at a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct JointState {
    /// The two sides.
    pub sides: [Side; 2],
    /// Continuity of the shape: what is marked, or what the coefficients are.
    pub shape: Match,
    /// Continuity of the material.
    pub material: Match,
    /// Whether that of the shape is marked.
    pub is_shape_marked: bool,
    /// Whether that of the material is marked.
    pub is_material_marked: bool,
}

/// Difference of fractions that counts as none.
const FRACTION: f64 = 1e-9;

/// What there is round a corner of a cell.
///
/// # Errors
/// When there is no such cell.
pub fn neighbourhood(body: &Body, cell: CellId, corner: Corner) -> Result<Neighbourhood, OperationError> {
    let star = Star::new(body, &[(cell, corner)])?;
    let weave = star.weave_from(Kind::Shape, body.tolerance(), star.place(cell, corner).unwrap_or(0));
    let part = weave.frames[star.place(cell, corner).unwrap_or(0)].part;
    let is_regular = weave.is_regular[part];
    let mix = |number: usize| {
        let (id, at) = star.coefficient(number);
        body.cell(id).map_or_else(|| Composition::pure(0, body.materials()), |cell| cell.mix(at))
    };
    let neighbour = |members: &Vec<usize>| {
        let first = mix(members[0]);
        let differs = |number: &usize| {
            let other = mix(*number);
            let mut pairs = first.fractions().iter().zip(other.fractions());
            pairs.any(|(a, b)| (a - b).abs() > FRACTION)
        };
        let jumps = members.iter().any(differs);
        let here = members.iter().find(|number| weave.frames[**number / 8].part == part);
        Neighbour {
            offset: here.filter(|_| is_regular).map(|n| weave.frames[n / 8].offset(n % 8)),
            position: star.position(members[0]),
            mix: first,
            jumps,
            users: members.iter().map(|number| star.coefficient(*number)).collect(),
        }
    };
    let points = weave.members.iter().map(neighbour).collect();
    let state = |joint: &super::star::Joint| JointState {
        sides: [0, 1].map(|n| star.side(joint.sides[n], joint.axes[n])),
        shape: joint.holds[0],
        material: joint.holds[1],
        is_shape_marked: joint.is_marked[0],
        is_material_marked: joint.is_marked[1],
    };
    Ok(Neighbourhood {
        cells: star.cells.iter().map(|(id, corner, _)| (*id, *corner)).collect(),
        is_regular: is_regular && weave.is_regular.len() == 1,
        points,
        joints: star.joints.iter().map(state).collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::super::test_bodies::{block, fan, shuffled};
    use super::*;

    #[test]
    fn a_regular_corner_has_26_neighbours_in_a_grid() {
        for seed in 0..4 {
            let body = shuffled(&block([2, 2, 2]), seed);
            let net = body.cell(CellId(3)).unwrap().net();
            let corner = Corner::all().into_iter().find(|c| net.0[c.coefficient()] == DVec3::ONE).unwrap();
            let found = neighbourhood(&body, CellId(3), corner).unwrap();
            assert_eq!((found.cells.len(), found.points.len(), found.joints.len()), (8, 27, 12));
            assert!(found.is_regular && found.joints.iter().all(|joint| joint.shape == Match::C1));
            assert!(found.joints.iter().all(|joint| !joint.is_shape_marked && joint.material == Match::None));
            // Offsets run along the axes of the cell that was asked about.
            let slopes = net.derivatives(corner.parameters());
            for point in &found.points {
                let offset = DVec3::from_array(point.offset.unwrap().map(f64::from));
                let expected = (0..3).fold(DVec3::ONE, |sum, n| sum + slopes[n] * offset[n] / 3.0);
                assert!(point.position.distance(expected) < 1e-12);
                let zeros = offset.to_array().iter().filter(|x| **x == 0.0).count();
                assert_eq!((point.users.len(), point.jumps), (1 << zeros, zeros > 0));
            }
        }
    }

    #[test]
    fn corners_of_one_cell_have_seven_and_irregular_ones_no_grid() {
        let body = block([2, 1, 1]);
        let found = neighbourhood(&body, CellId(0), Corner([false; 3])).unwrap();
        assert_eq!((found.cells.len(), found.points.len(), found.joints.len()), (1, 8, 0));
        let found = neighbourhood(&fan(5), CellId(2), Corner([false; 3])).unwrap();
        assert!(!found.is_regular && found.points.iter().all(|point| point.offset.is_none()));
        // Five cells: the corner, the axis, five spokes, those above, five inner ones, and those above.
        assert_eq!((found.cells.len(), found.points.len(), found.joints.len()), (5, 2 * (1 + 5 + 5), 5));
        assert!(neighbourhood(&body, CellId(5), Corner([false; 3])).is_err());
    }
}
