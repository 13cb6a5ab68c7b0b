//! The surface of a body of hyperpatches as a mesh, for the files that meshes are written to.

use super::{Group, Mesh, Part};
use crate::hyperpatch::Surface;
use crate::hyperpatch::composite::Body;
use std::ops::Deref;

/// The job that gives the vertices of a surface their fractions, face by face. `B` is a reference to a body, or
/// shared ownership of one.
///
/// Vertices stay those of the surface: at one place two cells may have two materials.
#[derive(Debug)]
pub struct Skin<B> {
    body: B,
    surface: Surface,
    fractions: Vec<f64>,
    next: usize,
}

impl<B: Deref<Target = Body>> Skin<B> {
    /// The job for a surface of a body.
    #[must_use]
    pub fn new(body: B, surface: Surface) -> Self {
        let fractions = Vec::with_capacity(surface.positions.len() * body.materials());
        Self { body, surface, fractions, next: 0 }
    }

    /// Advances while `may_go_on` says so, by one face at least. Returns the mesh when it is whole.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Mesh> {
        while let Some(patch) = self.surface.patches.get(self.next) {
            for vertex in patch.positions.clone() {
                match self.body.cell(patch.cell) {
                    Some(cell) => {
                        let mix = cell.composition(self.surface.parameters[vertex]);
                        self.fractions.extend(mix.fractions());
                    }
                    // A body that the surface is not of has no material there.
                    None => self.fractions.extend(std::iter::repeat_n(0.0, self.body.materials())),
                }
            }
            self.next += 1;
            if !may_go_on() {
                break;
            }
        }
        (self.next >= self.surface.patches.len()).then(|| {
            let surface = std::mem::take(&mut self.surface);
            Mesh {
                groups: vec![Group { part: Part::Surface, triangles: 0..surface.triangles.len() }],
                positions: surface.positions,
                fractions: std::mem::take(&mut self.fractions),
                scalars: Vec::new(),
                triangles: surface.triangles,
                materials: self.body.materials(),
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::composite::Sharing;
    use crate::hyperpatch::{Axis, Cell, Corner, Net, Tessellation, flat};
    use crate::material::{Color, Composition};
    use crate::solid::{FileJob, Format, Labels, is_watertight, volume};
    use glam::DVec3;

    /// A box with an arched top, split into cells of two materials.
    fn bent() -> (Body, f64) {
        let mut net = Net::cuboid(DVec3::ZERO, DVec3::new(4.0, 1.0, 1.0));
        for n in 0..16 {
            for i in 1..3 {
                net.0[flat(i, n / 4, n % 4)].z += 0.5 * (n % 4) as f64;
            }
        }
        let mixes = Corner::all().map(|corner| Composition::pure(usize::from(corner.0[1]), 2));
        let [first, second] = Cell::with_corner_mixes(net, &mixes).unwrap().split(Axis::U, 0.3).unwrap();
        let mut body = Body::new(2);
        for cell in [first, second.reversed(Axis::W)] {
            body.add(cell).unwrap();
        }
        let volume = body.cells().iter().map(|(_, cell)| cell.amounts().iter().sum::<f64>().abs()).sum();
        (body, volume)
    }

    fn mesh(body: &Body, tolerance: f64) -> Mesh {
        let sharing = Sharing::new(body);
        let surface = Tessellation::new(body, &sharing, sharing.outer_faces(), tolerance).unwrap().run();
        let mut job = Skin::new(body, surface);
        loop {
            if let Some(mesh) = job.step(&mut || false) {
                return mesh;
            }
        }
    }

    #[test]
    fn the_mesh_is_watertight_and_holds_the_volume() {
        let (body, exact) = bent();
        let errors = [1e-2, 1e-3].map(|tolerance| {
            let mesh = mesh(&body, tolerance);
            assert!(is_watertight(&mesh));
            (volume(&mesh) - exact).abs()
        });
        assert!(errors[0] < 0.2 && errors[1] < errors[0] / 3.0, "{errors:?}");
    }

    /// The material goes over by a smoothstep across the width, which y measures.
    #[test]
    fn vertices_have_the_fractions_of_their_place() {
        let mesh = mesh(&bent().0, 1e-3);
        for (vertex, place) in mesh.positions.iter().enumerate() {
            let step = place.y * place.y * (3.0 - 2.0 * place.y);
            assert!((mesh.fractions_at(vertex)[1] - step).abs() < 1e-12);
        }
    }

    #[test]
    fn files_hold_every_triangle() {
        let mesh = mesh(&bent().0, 1e-2);
        let (vertices, triangles) = (mesh.positions.len(), mesh.triangles.len());
        let colors = vec![Color::new(1, 2, 3); vertices];
        let labels =
            Labels { title: "Bent".into(), unit: "mm".into(), materials: vec!["a".into(), "b".into()] };
        let write = |format| {
            let mut job = FileJob::new(format, mesh.clone(), colors.clone(), &labels);
            job.step(&mut || true).expect("written at once")
        };
        assert_eq!(write(Format::Stl).len(), 84 + 50 * triangles);
        let text = String::from_utf8(write(Format::Obj)).unwrap();
        let count = |key: &str| text.lines().filter(|line| line.starts_with(key)).count();
        assert_eq!((count("v "), count("f ")), (vertices, triangles));
        let ply = write(Format::Ply);
        let head = String::from_utf8_lossy(&ply[..400]).into_owned();
        assert!(head.contains(&format!("element vertex {vertices}")), "{head}");
    }
}
