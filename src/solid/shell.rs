//! A surface through rows, closed by caps.

use super::mesh::stored;
use super::{Cap, CapError, Group, Mesh, Part, Row};
use glam::{DVec2, DVec3};

/// Builds a mesh row by row, so that no more than one row has to be there at a time.
///
/// Neighbours along a row or across to the next become one vertex where they are stored alike, in 32 bits: so triangles shrink to an edge or a
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
        let keys: Vec<[f32; 3]> = row.points.iter().map(|&point| stored(point)).collect();
        let is_wrapped = |k: &&[f32; 3]| self.is_closed && **k == keys[0];
        let wrapped = count - keys.iter().skip(1).rev().take_while(is_wrapped).count();
        let mut row_vertices: Vec<u32> = Vec::with_capacity(count);
        for (k, key) in keys.iter().enumerate() {
            let is_here = |vertex: &u32| stored(self.mesh.positions[*vertex as usize]) == *key;
            let before = row_vertices.last().copied().filter(is_here);
            let below = || self.last.get(k).copied().filter(is_here);
            let known = if k >= wrapped { row_vertices.first().copied() } else { before.or_else(below) };
            let vertex = known.unwrap_or_else(|| {
                self.mesh.positions.push(row.points[k]);
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
