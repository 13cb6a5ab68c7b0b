//! Whether a boundary encloses one body: closed, with normals that point out of it.

use super::error::{Fault, LaplaceError};
use super::mesh::Mesh;
use super::panel::{Panel, Space};
use glam::DVec3;
use std::collections::HashMap;

/// Most connected parts of a boundary: each is looked at from all others.
pub const MOST_PARTS: usize = 1000;

/// Parts of which the closure is measured.
const MEASURED: usize = 32;

/// What a boundary encloses.
#[derive(Debug, Clone, PartialEq)]
pub struct Enclosed {
    /// Connected parts of the boundary: the outer one, and one for each cavity.
    pub parts: usize,
    /// Area or volume between them.
    pub measure: f64,
    /// Largest difference between 1 and the share of the full angle under which the boundary is seen from just inside of each of its parts, the first 32 of them.
    pub closure: f64,
}

/// Checks that every edge belongs to two elements that run along it in opposite directions, that there is one outer part with normals outwards, and
/// that all others are cavities in it with normals into the cavity.
///
/// # Errors
/// With the element and the place of the first fault.
pub fn enclosed(mesh: &Mesh) -> Result<Enclosed, LaplaceError> {
    let part_of = match mesh.space() {
        Space::Plane => joined_at_ends(mesh)?,
        Space::Solid => joined_at_edges(mesh)?,
    };
    let scaling = mesh.scaling();
    let panels: Vec<Panel> =
        (0..part_of.len()).map(|n| mesh.space().panel(mesh.corners(n).map(|p| scaling.inwards(p)))).collect();
    let count = part_of.iter().max().map_or(0, |last| last + 1);
    if count > MOST_PARTS {
        let message = format!("{count} parts of the boundary were found; expected {MOST_PARTS} at most");
        return Err(LaplaceError::new(Fault::Limit, message));
    }
    let mut parts: Vec<Vec<&Panel>> = vec![Vec::new(); count];
    panels.iter().zip(&part_of).for_each(|(panel, part)| parts[*part].push(panel));
    let mut measures = vec![0.0; count];
    let share = if mesh.space() == Space::Plane { 2.0 } else { 3.0 };
    for (panel, part) in panels.iter().zip(&part_of) {
        measures[*part] += panel.centre.dot(panel.normal) * panel.size / share;
    }
    let first = |part: usize| part_of.iter().position(|of| *of == part).unwrap_or(0);
    let seen = |x: DVec3, part: usize| -> f64 {
        parts[part].iter().map(|panel| mesh.space().layers(panel, x).double).sum()
    };
    let boxes: Vec<(DVec3, DVec3)> = parts
        .iter()
        .map(|part| {
            let corners = || part.iter().flat_map(|panel| panel.corners);
            (corners().fold(DVec3::INFINITY, DVec3::min), corners().fold(DVec3::NEG_INFINITY, DVec3::max))
        })
        .collect();
    let fault = |fault: Fault, part: usize, message: String| {
        let element = first(part);
        Err(LaplaceError::new(fault, message).of(element).at(scaling.outwards(panels[element].centre)))
    };
    let outer: Vec<usize> = (0..count).filter(|part| measures[*part] > 0.0).collect();
    let Some(body) = outer.iter().copied().max_by(|a, b| measures[*a].total_cmp(&measures[*b])) else {
        let message = "the normals of the boundary point into the material; expected them to point out of it: turn its elements over";
        return fault(Fault::Inverted, 0, message.to_owned());
    };
    for part in (0..count).filter(|part| *part != body) {
        let place = panels[first(part)].centre;
        let is_inside = seen(place, body) > 0.5;
        if measures[part] > 0.0 && is_inside {
            let message = "the element belongs to a part inside the body whose normals point out of it; expected those of a cavity, into the cavity: turn its elements over";
            return fault(Fault::Inverted, part, message.to_owned());
        }
        if measures[part] > 0.0 {
            let message =
                "the element belongs to a second body; expected one, and others to be solved by themselves";
            return fault(Fault::Apart, part, message.to_owned());
        }
        let is_about = |(low, high): (DVec3, DVec3)| place.clamp(low, high) == place;
        let others = (0..count).filter(|other| ![part, body].contains(other) && is_about(boxes[*other]));
        if !is_inside || others.map(|other| seen(place, other)).any(|angle| angle.abs() > 0.5) {
            let message = "the element belongs to a cavity that is not in the body, or in another cavity; expected each in the body";
            return fault(Fault::Apart, part, message.to_owned());
        }
    }
    let mut closure: f64 = 0.0;
    for part in 0..count.min(MEASURED) {
        let panel = &panels[first(part)];
        let inner = panel.centre - panel.normal * (1e-3 * panel.size.powf(1.0 / (share - 1.0)));
        let angle: f64 = (0..count).map(|part| seen(inner, part)).sum();
        // Where the boundary meets itself close by, the place is not inside; assembling finds that.
        if (angle - 1.0).abs() < 0.5 {
            closure = closure.max((angle - 1.0).abs());
        }
    }
    let back = scaling.scale().powf(share);
    Ok(Enclosed { parts: count, measure: measures.iter().sum::<f64>() / back, closure })
}

/// Sets of elements that hang together.
struct Union(Vec<u32>);

impl Union {
    fn root(&mut self, mut n: u32) -> u32 {
        while self.0[n as usize] != n {
            let above = self.0[self.0[n as usize] as usize];
            self.0[n as usize] = above;
            n = above;
        }
        n
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b) as usize] = a.min(b);
    }

    /// For each element the number of its set, in the order of their first elements.
    fn numbered(mut self) -> Vec<usize> {
        let mut numbers = HashMap::new();
        (0..self.0.len() as u32)
            .map(|n| {
                let root = self.root(n);
                let next = numbers.len();
                *numbers.entry(root).or_insert(next)
            })
            .collect()
    }
}

fn joined_at_ends(mesh: &Mesh) -> Result<Vec<usize>, LaplaceError> {
    let elements = mesh.elements();
    let mut starts: HashMap<u32, u32> = HashMap::new();
    let mut ends: HashMap<u32, u32> = HashMap::new();
    let fault = |element: u32, vertex: u32, message: String| {
        Err(LaplaceError::new(Fault::Open, message).of(element as usize).at(mesh.vertices()[vertex as usize]))
    };
    for ([a, b, _], number) in elements.iter().zip(0_u32..) {
        for (list, vertex, what) in [(&mut starts, a, "start"), (&mut ends, b, "end")] {
            if let Some(other) = list.insert(*vertex, number) {
                let message = format!(
                    "elements {other} and {number} {what} at one vertex; expected one that ends there and one that starts: one of the two is turned over, or the boundary meets itself"
                );
                return fault(number, *vertex, message);
            }
        }
    }
    let mut union = Union((0..elements.len() as u32).collect());
    for ([a, b, _], number) in elements.iter().zip(0_u32..) {
        match starts.get(b) {
            Some(next) => union.join(number, *next),
            None => {
                return fault(
                    number,
                    *b,
                    "the boundary is open where this element ends; expected another to start there"
                        .to_owned(),
                );
            }
        }
        if !ends.contains_key(a) {
            return fault(
                number,
                *a,
                "the boundary is open where this element starts; expected another to end there".to_owned(),
            );
        }
    }
    Ok(union.numbered())
}

fn joined_at_edges(mesh: &Mesh) -> Result<Vec<usize>, LaplaceError> {
    let elements = mesh.elements();
    let edges = |[a, b, c]: [u32; 3]| [(a, b), (b, c), (c, a)];
    let fault = |element: u32, (a, b): (u32, u32), message: String| {
        let [a, b] = [a, b].map(|vertex| mesh.vertices()[vertex as usize]);
        Err(LaplaceError::new(Fault::Open, message).of(element as usize).at((a + b) / 2.0))
    };
    let mut owners: HashMap<(u32, u32), u32> = HashMap::with_capacity(3 * elements.len());
    for (element, number) in elements.iter().zip(0_u32..) {
        for edge in edges(*element) {
            if let Some(other) = owners.insert(edge, number) {
                let message = format!(
                    "elements {other} and {number} run along one edge in the same direction; expected opposite ones: one of the two is turned over or is there twice"
                );
                return fault(number, edge, message);
            }
        }
    }
    let mut union = Union((0..elements.len() as u32).collect());
    for (element, number) in elements.iter().zip(0_u32..) {
        for (a, b) in edges(*element) {
            match owners.get(&(b, a)) {
                Some(other) => union.join(number, *other),
                None => {
                    let message =
                        "the boundary is open at an edge of this element; expected another element along it";
                    return fault(number, (a, b), message.to_owned());
                }
            }
        }
    }
    Ok(union.numbered())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laplace::samples;
    use glam::DVec2;
    use std::f64::consts::PI;

    /// A boundary of several, each moved and turned over or not.
    fn several(parts: &[(&Mesh, DVec3, f64, bool)]) -> Result<Mesh, LaplaceError> {
        let (mut vertices, mut elements) = (Vec::new(), Vec::new());
        for (mesh, by, scale, is_turned) in parts {
            let start = vertices.len() as u32;
            vertices.extend(mesh.vertices().iter().map(|v| *v * *scale + *by));
            for [a, b, c] in mesh.elements() {
                let [a, b, c] = [a, b, c].map(|v| v + start);
                elements.push(if *is_turned { [a, c, b] } else { [a, b, c] });
            }
        }
        Mesh::solid(vertices, elements)
    }

    #[test]
    fn samples_are_closed_and_their_measure_is_known() {
        let cube = enclosed(&samples::cube(4)).unwrap();
        assert_eq!(cube.parts, 1);
        assert!((cube.measure - 1.0).abs() < 1e-12 && cube.closure < 1e-10, "{cube:?}");
        let shell = enclosed(&samples::shell(0.5, 1.0, 3)).unwrap();
        assert_eq!(shell.parts, 2);
        assert!(
            (shell.measure / (4.0 / 3.0 * PI * 0.875) - 1.0).abs() < 0.01 && shell.closure < 1e-10,
            "{shell:?}"
        );
        let annulus = enclosed(&samples::annulus(0.5, 1.0, 256)).unwrap();
        assert_eq!(annulus.parts, 2);
        assert!((annulus.measure / (PI * 0.75) - 1.0).abs() < 1e-3 && annulus.closure < 1e-12, "{annulus:?}");
    }

    #[test]
    fn faults_are_named_with_their_element_and_place() {
        let cube = samples::cube(2);
        let fault = |mesh: Result<Mesh, LaplaceError>| {
            let error = enclosed(&mesh.unwrap()).unwrap_err();
            assert!(error.at.is_some() && error.index.is_some() && !error.message.is_empty());
            (error.fault, error.index.unwrap())
        };
        let elements = cube.elements().to_vec();
        let with = |elements: Vec<[u32; 3]>| Mesh::solid(cube.vertices().to_vec(), elements);
        let open = enclosed(&with(elements[1..].to_vec()).unwrap()).unwrap_err();
        assert_eq!(open.fault, Fault::Open);
        let gap = cube.corners(0);
        let sides = [0, 1, 2].map(|k| (gap[k] + gap[(k + 1) % 3]) / 2.0);
        assert!(sides.contains(&open.at.unwrap()), "the place is a side of what is missing");
        let mut turned = elements.clone();
        turned[5].swap(0, 1);
        assert_eq!(fault(with(turned)).0, Fault::Open);
        let mut twice = elements.clone();
        twice.push(elements[3]);
        assert_eq!(fault(with(twice)), (Fault::Open, elements.len()));
        let whole = |by: DVec3, scale, is_turned| (&cube, by, scale, is_turned);
        let far = DVec3::new(3.0, 0.0, 0.0);
        let mid = DVec3::splat(0.25);
        let n = elements.len();
        assert_eq!(fault(several(&[whole(DVec3::ZERO, 1.0, true)])).0, Fault::Inverted);
        assert_eq!(
            fault(several(&[whole(DVec3::ZERO, 1.0, false), whole(far, 1.0, false)])),
            (Fault::Apart, n)
        );
        assert_eq!(
            fault(several(&[whole(DVec3::ZERO, 1.0, false), whole(far, 0.5, true)])),
            (Fault::Apart, n)
        );
        assert_eq!(
            fault(several(&[whole(DVec3::ZERO, 1.0, false), whole(mid, 0.5, false)])),
            (Fault::Inverted, n)
        );
        let nested = several(&[
            whole(DVec3::ZERO, 1.0, false),
            whole(mid, 0.5, true),
            whole(DVec3::splat(0.4), 0.2, true),
        ]);
        assert_eq!(fault(nested).0, Fault::Apart);
        assert_eq!(
            enclosed(&several(&[whole(DVec3::ZERO, 1.0, false), whole(mid, 0.5, true)]).unwrap())
                .unwrap()
                .parts,
            2
        );
    }

    #[test]
    fn vertices_of_one_place_are_one_and_flat_elements_are_refused() {
        let cube = samples::cube(2);
        let soup: Vec<DVec3> = (0..cube.elements().len()).flat_map(|n| cube.corners(n)).collect();
        let triples = (0..soup.len() as u32 / 3).map(|n| [3 * n, 3 * n + 1, 3 * n + 2]).collect();
        assert_eq!(enclosed(&Mesh::solid(soup.clone(), triples).unwrap()).unwrap().parts, 1);
        let mut flat = cube.elements().to_vec();
        flat[4][2] = flat[4][1];
        let error = Mesh::solid(cube.vertices().to_vec(), flat).unwrap_err();
        assert_eq!((error.fault, error.index), (Fault::Degenerate, Some(4)));
        let square = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        let open = Mesh::plane(&square, &[[0, 1], [1, 2], [2, 3]]).unwrap();
        let error = enclosed(&open).unwrap_err();
        assert_eq!((error.fault, error.index, error.at), (Fault::Open, Some(0), Some(DVec3::ZERO)));
        let clockwise = Mesh::plane(&square, &[[1, 0], [2, 1], [3, 2], [0, 3]]).unwrap();
        assert_eq!(enclosed(&clockwise).unwrap_err().fault, Fault::Inverted);
        assert_eq!(Mesh::plane(&square, &[[0, 1], [1, 9], [2, 3]]).unwrap_err().index, Some(1));
        assert_eq!(Mesh::plane(&[DVec2::NAN], &[]).unwrap_err().fault, Fault::Vertices);
    }

    #[test]
    fn many_cavities_are_looked_at_in_a_short_time_and_too_many_are_refused() {
        let [body, hole] = [samples::cube(1), samples::cube(1)];
        let with = |side: usize| {
            let holes = (0..side * side * side).map(|n| {
                let at = [n % side, n / side % side, n / side / side].map(|k| (k as f64 + 0.3) / side as f64);
                (&hole, DVec3::from_array(at), 0.4 / side as f64, true)
            });
            let parts: Vec<_> = std::iter::once((&body, DVec3::ZERO, 1.0, false)).chain(holes).collect();
            enclosed(&several(&parts).unwrap())
        };
        let found = with(6).unwrap();
        assert!(found.parts == 217 && (found.measure - (1.0 - 0.064)).abs() < 1e-12, "{found:?}");
        assert_eq!(with(10).unwrap_err().fault, Fault::Limit);
    }

    #[test]
    fn wherever_a_body_is_and_whatever_its_size_it_is_found_closed() {
        for (mesh, measure) in [(samples::cube(3), 1.0), (samples::square(4), 1.0)] {
            for (size, by) in [(1e-9, 0.0), (1e9, 0.0), (1e60, 0.0), (1e-3, 10.0), (1.0, 1e6)] {
                let moved = |v: &DVec3| *v * size + DVec3::new(by, by, 0.0);
                let vertices: Vec<DVec3> = mesh.vertices().iter().map(moved).collect();
                let same = match mesh.space() {
                    Space::Solid => Mesh::solid(vertices, mesh.elements().to_vec()),
                    Space::Plane => {
                        let flat: Vec<DVec2> = vertices.iter().map(|v| v.truncate()).collect();
                        let ends: Vec<[u32; 2]> = mesh.elements().iter().map(|[a, b, _]| [*a, *b]).collect();
                        Mesh::plane(&flat, &ends)
                    }
                };
                let found = enclosed(&same.unwrap()).unwrap();
                let exact: f64 = measure * size.powi(mesh.space().dimension() as i32);
                assert!(
                    (found.measure / exact - 1.0).abs() < 1e-6 && found.closure < 1e-6,
                    "{size} {found:?}"
                );
            }
        }
    }

    #[test]
    fn changed_meshes_are_refused_or_solved_and_never_stop_the_program() {
        use crate::laplace::{Conditions, LaplaceOptions, Problem, solve};
        let mut state = 20_261_126_u64;
        let mut random = move |below: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as usize % below.max(1)
        };
        let (mut refused, mut solved) = (0, 0);
        for run in 0..300 {
            let mesh = if run % 2 == 0 { samples::cube(2) } else { samples::hollow_box(1, 0.2) };
            let (mut vertices, mut elements) = (mesh.vertices().to_vec(), mesh.elements().to_vec());
            for _ in 0..=random(3) {
                let (v, e) = (random(vertices.len()), random(elements.len()));
                match random(8) {
                    0 => vertices[v] = [DVec3::NAN, DVec3::INFINITY, DVec3::splat(1e300)][random(3)],
                    1 => vertices[v] = vertices[random(vertices.len())],
                    2 => vertices[v] *= [1.3, -1.0, 1e-12, 1e12][random(4)],
                    3 => elements[e].swap(0, 1),
                    4 => elements[e][random(3)] = random(vertices.len() + 1) as u32,
                    5 => drop(elements.swap_remove(e)),
                    6 => elements.push(elements[e]),
                    _ => vertices[v] += DVec3::new(0.1, -0.2, 0.05),
                }
            }
            let made = Mesh::solid(vertices, elements).and_then(|mesh| {
                let conditions = Conditions::single(mesh.panels().iter().map(|panel| Ok(panel.centre.x)));
                solve(Problem::new(mesh, conditions)?, LaplaceOptions::default())
            });
            match made {
                Ok(_) => solved += 1,
                Err(error) => {
                    refused += 1;
                    assert!(!error.message.is_empty());
                }
            }
        }
        assert!(refused > 100 && solved > 20, "{refused} refused, {solved} solved");
    }
}
