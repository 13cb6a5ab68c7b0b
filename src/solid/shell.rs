//! A surface through rows, closed by caps.

use super::mesh::stored;
use super::{Cap, CapError, Group, Mesh, Part, Row};
use glam::{DVec2, DVec3};

/// What rounding may leave between two computations of one point, as a share of the largest coordinate of its row.
const ROUNDING: f64 = 1e-12;

/// Builds a mesh row by row, so that no more than one row has to be there at a time.
///
/// Neighbours along a row or across to the next become one vertex where they are stored alike, in 32 bits, or differ by rounding: so triangles shrink to an edge or a
/// point where rulings share an end or have no length, and are left out. Each quadrilateral is cut along its shorter diagonal.
#[derive(Debug, Clone)]
pub struct Shell {
    mesh: Mesh,
    /// Number of rulings that each scalar is the sum of.
    merged: Vec<u32>,
    is_closed: bool,
    axes: [DVec3; 2],
    first: Vec<u32>,
    last: Vec<u32>,
}

/// A finished surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Shelled {
    /// The triangles.
    pub mesh: Mesh,
    /// Why the rim of the first or of the last row has no cap, of those that were to have one.
    pub uncapped: [Option<CapError>; 2],
}

impl Shell {
    /// Begins a surface of closed or open rows with so many materials. Rims are triangulated, and oriented, in their projection on the plane of `axes`, two unit
    /// vectors at right angles.
    #[must_use]
    pub fn new(is_closed: bool, materials: usize, axes: [DVec3; 2]) -> Self {
        let mesh = Mesh { materials, ..Mesh::default() };
        Self { mesh, merged: Vec::new(), is_closed, axes, first: Vec::new(), last: Vec::new() }
    }

    /// Adds a row. `scalars` holds a number for each ruling, or none in all rows.
    ///
    /// # Panics
    /// When the row has another number of vertices than the first one, or of compositions.
    pub fn push(&mut self, row: &Row, scalars: &[f64]) {
        let count = row.points.len();
        assert_eq!(row.compositions.len(), count, "one composition for each vertex");
        assert!(self.last.is_empty() || self.last.len() == count, "rows of equal length");
        let size = row.points.iter().fold(0.0_f64, |size, point| size.max(point.abs().max_element()));
        let are_one =
            |a: DVec3, b: DVec3| (a - b).abs().max_element() <= ROUNDING * size || stored(a) == stored(b);
        let is_wrapped = |point: &&DVec3| self.is_closed && are_one(**point, row.points[0]);
        let wrapped = count - row.points.iter().skip(1).rev().take_while(is_wrapped).count();
        let mut row_vertices: Vec<u32> = Vec::with_capacity(count);
        for (k, &point) in row.points.iter().enumerate() {
            let is_here = |vertex: &u32| are_one(self.mesh.positions[*vertex as usize], point);
            let before = row_vertices.last().copied().filter(is_here);
            let below = || self.last.get(k).copied().filter(is_here);
            let known = if k >= wrapped { row_vertices.first().copied() } else { before.or_else(below) };
            let vertex = known.unwrap_or_else(|| {
                self.mesh.positions.push(point);
                self.mesh.fractions.extend_from_slice(row.compositions[k].fractions());
                if !scalars.is_empty() {
                    self.mesh.scalars.push(0.0);
                    self.merged.push(0);
                }
                self.mesh.positions.len() as u32 - 1
            });
            if let Some(scalar) = scalars.get(k) {
                self.mesh.scalars[vertex as usize] += scalar;
                self.merged[vertex as usize] += 1;
            }
            row_vertices.push(vertex);
        }
        if self.last.is_empty() {
            self.first.clone_from(&row_vertices);
        } else {
            self.join(&row_vertices);
        }
        self.last = row_vertices;
    }

    /// Triangles from the last row to this one.
    fn join(&mut self, row: &[u32]) {
        let count = row.len();
        let gaps = if self.is_closed { count } else { count.saturating_sub(1) };
        for k in 0..gaps {
            let next = (k + 1) % count;
            let [a, b, c, d] = [self.last[k], self.last[next], row[next], row[k]];
            let at = |vertex: u32| self.mesh.positions[vertex as usize];
            let [falling, rising] = [at(b).distance_squared(at(d)), at(a).distance_squared(at(c))];
            let pieces = if rising <= falling { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
            let is_whole = |[a, b, c]: &[u32; 3]| a != b && b != c && c != a;
            self.mesh.triangles.extend(pieces.into_iter().filter(is_whole));
        }
    }

    /// Ends the surface with the last row, and closes it by caps where rows are closed and `capped`. A closed surface is then turned so that
    /// its outside is outside.
    #[must_use]
    pub fn finish(mut self, capped: bool) -> Shelled {
        let merged = std::mem::take(&mut self.merged);
        self.mesh.scalars.iter_mut().zip(merged).for_each(|(sum, count)| *sum /= f64::from(count.max(1)));
        let surface = 0..self.mesh.triangles.len();
        self.mesh.groups = vec![Group { part: Part::Surface, triangles: surface }];
        let mut uncapped = [None; 2];
        if self.is_closed {
            let rims = [rim(&self.first), rim(&self.last)];
            let is_inside_out = self.signed_volume(&rims) < 0.0;
            for (k, rim) in rims.iter().enumerate().filter(|(_, rim)| capped && rim.len() > 1) {
                uncapped[k] = self.close(k, rim).err();
            }
            if is_inside_out {
                self.mesh.turn_over();
            }
        }
        Shelled { mesh: self.mesh, uncapped }
    }

    /// Adds the cap of the first (0) or of the last row (1).
    fn close(&mut self, k: usize, rim: &[u32]) -> Result<(), CapError> {
        let flat = |vertex: &u32| {
            let position = self.mesh.positions[*vertex as usize];
            DVec2::new(position.dot(self.axes[0]), position.dot(self.axes[1]))
        };
        let cap = Cap::new(&rim.iter().map(flat).collect::<Vec<_>>())?;
        // The surface runs along the first rim as the row does, and against the last one; caps run the other way.
        let is_turned = cap.is_counter_clockwise == (k == 0);
        let start = self.mesh.triangles.len();
        self.mesh.triangles.extend(cap.triangles.into_iter().map(|triangle| {
            let [a, b, c] = triangle.map(|corner| rim[corner]);
            if is_turned { [a, c, b] } else { [a, b, c] }
        }));
        self.mesh.groups.push(Group { part: Part::Cap(k), triangles: start..self.mesh.triangles.len() });
        Ok(())
    }

    /// Six times the volume inside the surface when fans of triangles close its rims.
    fn signed_volume(&self, rims: &[Vec<u32>; 2]) -> f64 {
        let at = |vertex: u32| self.mesh.positions[vertex as usize];
        let Some(&origin) = self.mesh.positions.first() else { return 0.0 };
        let tetrahedron = |[a, b, c]: [u32; 3]| {
            let [a, b, c] = [a, b, c].map(|vertex| at(vertex) - origin);
            a.dot(b.cross(c))
        };
        let fan = |rim: &Vec<u32>| -> f64 {
            (1..rim.len().saturating_sub(1)).map(|k| tetrahedron([rim[0], rim[k], rim[k + 1]])).sum()
        };
        let surface: f64 = self.mesh.triangles.iter().map(|&triangle| tetrahedron(triangle)).sum();
        surface - fan(&rims[0]) + fan(&rims[1])
    }
}

/// The vertices of a closed row, each once.
fn rim(row: &[u32]) -> Vec<u32> {
    let mut rim = row.to_vec();
    rim.dedup();
    while rim.len() > 1 && rim.first() == rim.last() {
        rim.pop();
    }
    rim
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::Composition;
    use crate::solid::{is_watertight, volume};
    use glam::dvec3;

    fn build(rows: &[Vec<DVec3>], scalars: &[f64]) -> Shelled {
        let mut shell = Shell::new(true, 1, [DVec3::X, DVec3::Y]);
        for points in rows {
            let compositions = vec![Composition::pure(0, 1); points.len()];
            shell.push(&Row { points: points.clone(), compositions }, scalars);
        }
        shell.finish(true)
    }

    fn square(half: f64, z: f64) -> Vec<DVec3> {
        vec![dvec3(half, half, z), dvec3(-half, half, z), dvec3(-half, -half, z), dvec3(half, -half, z)]
    }

    #[test]
    fn a_box_has_eight_vertices() {
        let Shelled { mesh, uncapped } = build(&[square(1.0, 0.0), square(1.0, 3.0)], &[]);
        assert_eq!((mesh.positions.len(), mesh.triangles.len(), uncapped), (8, 12, [None; 2]));
        assert!(is_watertight(&mesh) && (volume(&mesh) - 12.0).abs() < 1e-12);
    }

    /// Lines that share an end in a fan, across the seam too; the number of a shared vertex is the mean.
    #[test]
    fn shared_ends_become_one_vertex() {
        let [a, b, c, d] = square(1.0, 0.0).try_into().expect("four points");
        let fan = vec![a, b, b, b, c, d, d + 1e-13, a + 1e-13];
        let upper: Vec<DVec3> =
            (0..8).map(|k| (3.0 * DVec2::from_angle((0.5 + f64::from(k)) * 0.785)).extend(2.0)).collect();
        let scalars: Vec<f64> = (0..8).map(f64::from).collect();
        let Shelled { mesh, uncapped } = build(&[fan, upper], &scalars);
        assert_eq!((mesh.positions.len(), uncapped), (12, [None; 2]));
        assert_eq!(mesh.triangles.len(), 12 + 2 + 6, "a triangle for each edge of either rim, and two caps");
        assert!(is_watertight(&mesh));
        assert_eq!(mesh.scalars[..4], [3.5, 2.0, 4.0, 5.5]);
    }

    /// A wedge: one side of both rims is the same, so that rulings have no length there.
    #[test]
    fn rulings_without_length_leave_an_edge() {
        let lower = square(1.0, 0.0);
        let mut upper = square(1.0, 2.0);
        (upper[1], upper[2]) = (lower[1], lower[2]);
        let Shelled { mesh, .. } = build(&[lower, upper], &[]);
        assert_eq!(mesh.positions.len(), 6);
        assert!(is_watertight(&mesh));
        assert!((volume(&mesh) - 4.0).abs() < 1e-12, "half of a box");
    }

    #[test]
    fn a_row_that_is_one_point_is_a_tip() {
        let Shelled { mesh, uncapped } = build(&[square(1.0, 0.0), vec![DVec3::Z * 3.0; 4]], &[]);
        assert_eq!((mesh.positions.len(), mesh.triangles.len(), uncapped), (5, 6, [None; 2]));
        assert!(is_watertight(&mesh) && (volume(&mesh) - 4.0).abs() < 1e-12);
    }

    #[test]
    fn a_rim_that_meets_itself_has_no_cap() {
        let bow =
            |z: f64| vec![dvec3(0.0, 0.0, z), dvec3(2.0, 1.0, z), dvec3(2.0, 0.0, z), dvec3(0.0, 2.0, z)];
        let Shelled { mesh, uncapped } = build(&[bow(0.0), square(1.0, 1.0)], &[]);
        assert!(matches!(uncapped, [Some(CapError::Crossing { .. }), None]));
        assert!(!is_watertight(&mesh));
    }
}
