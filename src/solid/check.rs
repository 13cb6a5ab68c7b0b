//! What certifies a mesh, independently of how it was built.

use super::Mesh;
use super::mesh::stored;
use glam::DVec3;

/// Tells whether a mesh has an inside: every edge belongs to exactly two triangles, which run along it in opposite directions.
///
/// Vertices count as one where their stored coordinates, which have 32 bits, are the same: that is how readers of files see them.
/// A mesh without triangles is not watertight.
#[must_use]
pub fn is_watertight(mesh: &Mesh) -> bool {
    let place = places(&mesh.positions);
    let count = place.len();
    // For each lower end of an edge a stretch of a list holds the upper ends with their directions.
    let mut starts = vec![0_u32; count + 1];
    let edges = || {
        mesh.triangles.iter().flat_map(|triangle| {
            let [a, b, c] = triangle.map(|vertex| place[vertex as usize]);
            [(a, b), (b, c), (c, a)]
        })
    };
    for (from, to) in edges() {
        if from == to {
            return false;
        }
        starts[from.min(to) as usize + 1] += 1;
    }
    for k in 0..count {
        starts[k + 1] += starts[k];
    }
    let mut ends = vec![0_u32; 3 * mesh.triangles.len()];
    let mut free = starts.clone();
    for (from, to) in edges() {
        let next = &mut free[from.min(to) as usize];
        ends[*next as usize] = 2 * from.max(to) + u32::from(from < to);
        *next += 1;
    }
    let is_paired = |range: std::ops::Range<usize>| {
        let ends = &mut ends[range];
        ends.sort_unstable();
        ends.chunks(2).all(|pair| pair.len() == 2 && pair[0] ^ 1 == pair[1])
            && ends.chunks(2).zip(ends.chunks(2).skip(1)).all(|(this, next)| this[0] != next[0])
    };
    let mut is_paired = is_paired;
    !mesh.triangles.is_empty() && (0..count).all(|k| is_paired(starts[k] as usize..starts[k + 1] as usize))
}

/// For each vertex the first one that is stored with the same coordinates.
pub(super) fn places(positions: &[DVec3]) -> Vec<u32> {
    const FREE: u32 = u32::MAX;
    let size = (2 * positions.len()).next_power_of_two().max(2);
    let mut slots = vec![FREE; size];
    let keys: Vec<[u32; 3]> = positions.iter().map(|&position| stored(position).map(f32::to_bits)).collect();
    let mut places = Vec::with_capacity(positions.len());
    for (vertex, key) in keys.iter().enumerate() {
        let hash = key.iter().fold(0_u64, |hash, &part| {
            (hash ^ u64::from(part)).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(29)
        });
        let mut slot = hash as usize & (size - 1);
        while slots[slot] != FREE && keys[slots[slot] as usize] != *key {
            slot = (slot + 1) & (size - 1);
        }
        if slots[slot] == FREE {
            slots[slot] = vertex as u32;
        }
        places.push(slots[slot]);
    }
    places
}

/// Volume inside a watertight mesh, by the divergence theorem: the sum of the signed tetrahedra from one point to all triangles.
#[must_use]
pub fn volume(mesh: &Mesh) -> f64 {
    volume_of(mesh, |position| position)
}

/// Volume inside a watertight mesh as it is stored, in 32 bits: how far it is from the [`volume`] tells what rounding does to the shape.
#[must_use]
pub fn stored_volume(mesh: &Mesh) -> f64 {
    volume_of(mesh, |position| DVec3::from(stored(position).map(f64::from)))
}

fn volume_of(mesh: &Mesh, place: impl Fn(DVec3) -> DVec3) -> f64 {
    let Some((low, high)) = mesh.bounds() else { return 0.0 };
    let origin = (low + high) / 2.0;
    let six_fold = |triangle: &[u32; 3]| {
        let [a, b, c] = mesh.corners(*triangle).map(|corner| place(corner) - origin);
        a.dot(b.cross(c))
    };
    mesh.triangles.iter().map(six_fold).sum::<f64>() / 6.0
}

/// Area of all triangles.
#[must_use]
pub fn area(mesh: &Mesh) -> f64 {
    let double = |triangle: &[u32; 3]| {
        let [a, b, c] = mesh.corners(*triangle);
        (b - a).cross(c - a).length()
    };
    mesh.triangles.iter().map(double).sum::<f64>() / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;

    fn tetrahedron() -> Mesh {
        Mesh {
            positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z],
            triangles: vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]],
            ..Mesh::default()
        }
    }

    #[test]
    fn a_tetrahedron_is_closed_and_measured() {
        let mesh = tetrahedron();
        assert!(is_watertight(&mesh));
        assert!((volume(&mesh) - 1.0 / 6.0).abs() < 1e-15);
        assert!((area(&mesh) - 1.5 - 3.0_f64.sqrt() / 2.0).abs() < 1e-15);
    }

    #[test]
    fn holes_turned_triangles_and_doubled_ones_are_noticed() {
        let mut open = tetrahedron();
        open.triangles.pop();
        assert!(!is_watertight(&open));
        let mut turned = tetrahedron();
        turned.triangles[1].swap(0, 1);
        assert!(!is_watertight(&turned));
        let mut doubled = tetrahedron();
        doubled.triangles.extend(tetrahedron().triangles);
        assert!(!is_watertight(&doubled));
        assert!(!is_watertight(&Mesh::default()));
    }

    #[test]
    fn vertices_that_are_stored_alike_are_one() {
        let mut mesh = tetrahedron();
        mesh.positions.push(dvec3(0.0, -0.0, 1.0 + 1e-12));
        mesh.triangles[3] = [2, 0, 4];
        assert!(is_watertight(&mesh), "a seam");
        mesh.positions[4] = dvec3(0.0, 0.0, 1.001);
        assert!(!is_watertight(&mesh), "a slit");
        // Far from the origin 32 bits do not hold the vertices apart.
        let mut far = tetrahedron();
        far.positions.iter_mut().for_each(|position| position.x += 1e9);
        assert!(!is_watertight(&far));
    }
}
