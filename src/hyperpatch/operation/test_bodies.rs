//! Bodies for tests of operations, and checks of what must hold after every edit.

use super::draft::{exact, holds};
use crate::hyperpatch::composite::{Body, CellId, Match, Sharing};
use crate::hyperpatch::test_cells::{random, random_place, ring_cell};
use crate::hyperpatch::{Axis, Cell, Corner, Net};
use crate::material::Composition;
use glam::{DVec2, DVec3};

/// A composition of three materials that depends on the seed alone.
pub(super) fn random_mix(seed: u64) -> Composition {
    let parts = [0, 1, 2].map(|m| -random(seed * 3 + m).max(1e-9).ln());
    Composition::rounded(parts.to_vec())
}

/// A body of cells, each of one material of three in turn.
pub(super) fn body_of(nets: impl IntoIterator<Item = Net>) -> Body {
    let mut body = Body::new(3);
    for (n, net) in nets.into_iter().enumerate() {
        body.add(Cell::uniform(net, &Composition::pure(n % 3, 3)).unwrap()).unwrap();
    }
    body
}

/// A block of unit cubes; w runs fastest, then v.
pub(super) fn block(count: [usize; 3]) -> Body {
    let cube = |n: usize| {
        let place = [n / (count[1] * count[2]), n / count[2] % count[1], n % count[2]];
        let min = DVec3::from_array(place.map(|x| x as f64));
        Net::cuboid(min, min + 1.0)
    };
    body_of((0..count.iter().product()).map(cube))
}

/// A ring of cells about the z axis.
pub(super) fn ring(count: usize) -> Body {
    body_of((0..count).map(|n| ring_cell(count, n, 1.0, 2.0, 1.0)))
}

/// Cells round a straight edge, as sectors of a prism.
pub(super) fn fan(count: usize) -> Body {
    let corner = |n: usize| DVec2::from_angle(n as f64 / count as f64 * std::f64::consts::TAU);
    body_of((0..count).map(|n| {
        let (a, b) = (corner(n), corner((n + 1) % count));
        let plane = [DVec2::ZERO, b, a, (a + b) * 0.9];
        Net::trilinear(&Corner::all().map(|c| {
            plane[usize::from(c.0[0]) * 2 + usize::from(c.0[1])].extend(f64::from(u8::from(c.0[2])))
        }))
    }))
}

/// The same body with the axes of a cell in another order, and some of them reversed.
pub(super) fn turned(cell: &Cell, order: [usize; 3], signs: usize) -> Cell {
    let source = |at: usize| {
        let place = [at / 16, at / 4 % 4, at % 4];
        place[order[0]] * 16 + place[order[1]] * 4 + place[order[2]]
    };
    let net = Net(std::array::from_fn(|at| cell.net().0[source(at)]));
    let mixes: Vec<_> = (0..64).map(|at| cell.mix(source(at))).collect();
    let mut cell = Cell::new(net, &mixes).unwrap();
    for (n, axis) in Axis::ALL.into_iter().enumerate() {
        if signs & (1 << n) != 0 {
            cell = cell.reversed(axis);
        }
    }
    cell
}

/// The same body with every cell turned in some way.
pub(super) fn shuffled(body: &Body, seed: u64) -> Body {
    const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let mut result = Body::new(body.materials());
    for (n, (_, cell)) in body.cells().iter().enumerate() {
        let pick = |most: f64, m: u64| (random(seed * 100 + n as u64 * 2 + m) * most) as usize;
        result.add(turned(cell, ORDERS[pick(6.0, 0)], pick(8.0, 1))).unwrap();
    }
    result
}

/// The coefficient of a cell at a point.
pub(super) fn at_point(body: &Body, id: u32, point: DVec3) -> usize {
    let net = body.cell(CellId(id)).unwrap().net();
    (0..64).find(|at| net.0[*at].distance(point) < 1e-9).unwrap()
}

/// A vector of the cube from -1 to 1.
pub(super) fn random_vector(seed: u64) -> DVec3 {
    random_place(seed) * 2.0 - 1.0
}

/// Number of corners of shared faces that run on in shape, found from the coefficients alone.
pub(super) fn smooth_corners(body: &Body) -> usize {
    let faces = Sharing::new(body).continuity(body);
    faces.iter().flat_map(|face| face.corners).filter(|corner| corner.shape == Match::C1).count()
}

/// Whether everything that is marked holds within 1e-12, and every composition is in the simplex.
pub(super) fn check_body(body: &Body) {
    for (side, mark) in body.marks().iter() {
        let (shape, material) = holds(body, side, &mark, exact(body)).unwrap();
        assert!(mark.shape.is_none_or(|marked| shape >= marked), "{side:?}: {shape:?}, {mark:?}");
        assert!(mark.material.is_none_or(|marked| material >= marked), "{side:?}: {material:?}, {mark:?}");
    }
    for (id, cell) in body.cells() {
        for at in 0..64 {
            let mut sum = 0.0;
            for list in cell.fractions() {
                assert!(list[at] >= 0.0, "cell {id}, coefficient {at}: {}", list[at]);
                sum += list[at];
            }
            assert!((sum - 1.0_f64).abs() < 1e-12, "cell {id}, coefficient {at}: sum {sum}");
        }
    }
}
