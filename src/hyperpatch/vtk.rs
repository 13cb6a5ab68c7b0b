//! Cells as a file of VTK: an unstructured grid of Lagrange hexahedra of order 3, which hold a tricubic cell exactly.

use super::composite::Body;
use glam::DVec3;
use std::fmt::Write;
use std::ops::Deref;

/// Number of the cell type in VTK.
const LAGRANGE_HEXAHEDRON: u8 = 72;

/// Points of a cell along an axis.
const POINTS: usize = 4;

/// The job that writes the cells of a body as XML (`.vtu`), cell by cell: 64 points each, at parameters in steps of a third, with
/// the fraction of each material there, and the number of each cell.
///
/// A polynomial of degree 3 along each axis is fixed by its values there, so nothing is lost but what decimals round, which read back as the same
/// `f64`. Cells share no points, because material may jump between them. A mirrored cell has its parameter u reversed, as VTK asks for
/// positive determinants.
///
/// # References
/// W. Schroeder et al., *VTK File Formats*, <https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html>; the order of the
/// points is that of `vtkHigherOrderHexahedron::PointIndexFromIJK` from VTK 9.1 on (file version 2.2).
#[derive(Debug)]
pub struct VtkJob<B> {
    body: B,
    next: usize,
    points: String,
    /// A column of fractions for each material.
    fractions: Vec<String>,
    names: Vec<String>,
}

impl<B: Deref<Target = Body>> VtkJob<B> {
    /// Begins a file. `materials` are the names of the materials.
    #[must_use]
    pub fn new(body: B, materials: &[String]) -> Self {
        let names = (0..body.materials())
            .map(|n| escaped(materials.get(n).map_or("", String::as_str), n))
            .collect::<Vec<_>>();
        Self { next: 0, points: String::new(), fractions: vec![String::new(); names.len()], names, body }
    }

    /// Share of the file that is written, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.next as f64 / self.body.cells().len().max(1) as f64
    }

    /// Advances while `may_go_on` says so, by one cell at least; returns the file when it is written.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Vec<u8>> {
        while let Some((_, cell)) = self.body.cells().get(self.next) {
            let is_mirrored = super::Jacobian::new(cell.net()).volume() < 0.0;
            for place in order() {
                let mut at = DVec3::from_array(place.map(|n| n as f64 / (POINTS - 1) as f64));
                if is_mirrored {
                    at.x = 1.0 - at.x;
                }
                let point = cell.point(at);
                // Writing to a text cannot fail.
                let _ = writeln!(self.points, "{} {} {}", point.x, point.y, point.z);
                for (column, fraction) in self.fractions.iter_mut().zip(cell.composition(at).fractions()) {
                    let _ = writeln!(column, "{fraction}");
                }
            }
            self.next += 1;
            if !may_go_on() {
                break;
            }
        }
        (self.next >= self.body.cells().len()).then(|| self.file().into_bytes())
    }

    fn file(&self) -> String {
        let cells = self.body.cells();
        let array = |kind: &str, name: &str, more: &str, text: &str| {
            format!(
                "<DataArray type=\"{kind}\" Name=\"{name}\"{more} format=\"ascii\">\n{text}</DataArray>\n"
            )
        };
        let list =
            |item: &dyn Fn(usize) -> String| -> String { (0..cells.len()).map(|n| item(n) + "\n").collect() };
        let columns: String = self
            .names
            .iter()
            .zip(&self.fractions)
            .map(|(name, text)| array("Float64", name, "", text))
            .collect();
        let connectivity =
            list(&|n| (64 * n..64 * n + 64).map(|point| point.to_string()).collect::<Vec<_>>().join(" "));
        format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"2.2\" byte_order=\"LittleEndian\">\n\
             <UnstructuredGrid>\n<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{count}\">\n\
             <PointData>\n{columns}</PointData>\n<CellData>\n{numbers}</CellData>\n\
             <Points>\n{positions}</Points>\n<Cells>\n{connectivity}{offsets}{types}</Cells>\n\
             </Piece>\n</UnstructuredGrid>\n</VTKFile>\n",
            points = 64 * cells.len(),
            count = cells.len(),
            numbers = array("Int32", "cell", "", &list(&|n| cells[n].0.to_string())),
            positions = array("Float64", "Points", " NumberOfComponents=\"3\"", &self.points),
            connectivity = array("Int64", "connectivity", "", &connectivity),
            offsets = array("Int64", "offsets", "", &list(&|n| (64 * (n + 1)).to_string())),
            types = array("UInt8", "types", "", &list(&|_| LAGRANGE_HEXAHEDRON.to_string())),
        )
    }
}

/// The places of the points of a cell, in steps along u, v and w, in VTK's order.
fn order() -> [[usize; 3]; 64] {
    let mut places = [[0; 3]; 64];
    for n in 0..64 {
        let place = [n / 16, n / 4 % 4, n % 4];
        places[index(place)] = place;
    }
    places
}

/// The number of a point in VTK's order: corners, then points of edges, of faces, and inside.
///
/// Corners and edges run as in a linear and a quadratic hexahedron, faces go u = 0, u = 1, v = 0, v = 1, w = 0, w = 1. On edges, faces
/// and inside the parameter that comes first runs fastest.
fn index([i, j, k]: [usize; 3]) -> usize {
    let last = POINTS - 1;
    let inner = last - 1;
    let is_end = [i, j, k].map(|n| n == last);
    let is_on = [i, j, k].map(|n| n == 0 || n == last);
    let side =
        |a: usize, b: usize, rest: usize| 8 + 12 * inner + rest * inner * inner + (a - 1) + inner * (b - 1);
    match is_on {
        [true, true, true] => {
            let around = match (is_end[0], is_end[1]) {
                (false, false) => 0,
                (true, false) => 1,
                (true, true) => 2,
                (false, true) => 3,
            };
            around + if is_end[2] { 4 } else { 0 }
        }
        [false, true, true] => {
            8 + inner * (if is_end[1] { 2 } else { 0 } + if is_end[2] { 4 } else { 0 }) + i - 1
        }
        [true, false, true] => {
            8 + inner * (if is_end[0] { 1 } else { 3 } + if is_end[2] { 4 } else { 0 }) + j - 1
        }
        [true, true, false] => {
            let around = match (is_end[0], is_end[1]) {
                (false, false) => 0,
                (true, false) => 1,
                (true, true) => 2,
                (false, true) => 3,
            };
            8 + inner * (8 + around) + k - 1
        }
        [true, false, false] => side(j, k, usize::from(is_end[0])),
        [false, true, false] => side(i, k, 2 + usize::from(is_end[1])),
        [false, false, true] => side(i, j, 4 + usize::from(is_end[2])),
        [false, false, false] => {
            8 + 12 * inner + 6 * inner * inner + (i - 1) + inner * ((j - 1) + inner * (k - 1))
        }
    }
}

/// The name of a material as an attribute; its number where it has none.
fn escaped(name: &str, number: usize) -> String {
    if name.is_empty() {
        return format!("material {number}");
    }
    let mut text = String::new();
    for letter in name.chars() {
        match letter {
            '&' => text.push_str("&amp;"),
            '<' => text.push_str("&lt;"),
            '>' => text.push_str("&gt;"),
            '"' => text.push_str("&quot;"),
            letter if letter.is_control() => text.push(' '),
            letter => text.push(letter),
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::super::test_cells::{random_net, ring_cell};
    use super::super::{Axis, Cell, Corner};
    use super::*;
    use crate::material::Composition;

    fn file(body: &Body) -> String {
        let mut job = VtkJob::new(body, &["a<b".to_owned()]);
        loop {
            if let Some(bytes) = job.step(&mut || false) {
                return String::from_utf8(bytes).unwrap();
            }
        }
    }

    #[test]
    fn every_point_has_a_place_of_its_own() {
        let mut places = order();
        places.sort_unstable();
        assert!(places.iter().enumerate().all(|(n, place)| *place == [n / 16, n / 4 % 4, n % 4]));
    }

    /// The corners of the cells, first of all, are those of a linear hexahedron: two quadrilaterals, counter-clockwise from above.
    #[test]
    fn cells_begin_with_their_corners_the_right_way_round() {
        let mixes = Corner::all().map(|corner| Composition::pure(usize::from(corner.0[2]), 2));
        let mut body = Body::new(2);
        for net in [random_net(3, 0.1), random_net(4, 0.1).reversed(Axis::V), ring_cell(8, 1, 1.0, 2.0, 1.0)]
        {
            body.add(Cell::with_corner_mixes(net, &mixes).unwrap()).unwrap();
        }
        let text = file(&body);
        let points = text.split("Name=\"Points\"").nth(1).and_then(|rest| rest.split('>').nth(1)).unwrap();
        let numbers: Vec<f64> = points.split_whitespace().map_while(|number| number.parse().ok()).collect();
        assert_eq!(numbers.len(), 3 * 64 * 3);
        for cell in numbers.chunks_exact(3 * 64) {
            let point = |n: usize| DVec3::from_slice(&cell[3 * n..]);
            let (along, across, up) = (point(1) - point(0), point(3) - point(0), point(4) - point(0));
            assert!(along.cross(across).dot(up) > 0.0);
        }
        assert!(text.contains("Name=\"a&lt;b\"") && text.contains("Name=\"material 1\""));
    }
}
