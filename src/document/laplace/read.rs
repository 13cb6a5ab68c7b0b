//! Reading of documents of boundary value problems.

use super::super::fields::materials;
use super::super::laplace_options::solver;
use super::super::node::Node;
use super::super::read::check_kind;
use super::super::{Code, DocumentError, Json};
use super::schema::{
    BoundaryModel, ConditionSpec, Datum, GroupSpec, LaplaceDocument, SectionSpec, Selection,
};
use crate::field::LONGEST_EXPRESSION;
use crate::laplace::{LaplaceOptions, MOST_ELEMENTS, Space};
use glam::DVec3;
use std::f64::consts::PI;

/// Most groups of a document.
pub const MOST_GROUPS: usize = 64;
/// Most runs of elements of a group.
const MOST_RUNS: usize = 10_000;
/// Greatest coordinate, radius and flux.
const LARGEST: f64 = 1e9;
/// Smallest radius.
const SMALLEST: f64 = 1e-6;
/// Most of an outer radius that an inner one may be.
const THINNEST: f64 = 0.999;
/// How far fractions may be from the sum 1, and fluxes from the sum 0 over the largest of them.
const SUM: f64 = 1e-9;

type Read<T> = Result<T, DocumentError>;

/// Reads a document of a boundary value problem and checks every field by itself.
///
/// # Errors
/// The first thing that is wrong, with the path of its field: a document of another kind, a missing or unknown field, a wrong type, a value out of range, or
/// too many of something. What boundary and conditions are together is for [`BoundaryJob`](super::BoundaryJob) to say.
pub fn read_laplace(document: &Json) -> Read<LaplaceDocument> {
    let root = Node::root(document, "");
    check_kind(&root, "laplace")?;
    root.only(&[
        "directrix",
        "kind",
        "title",
        "unit",
        "materials",
        "model",
        "groups",
        "rest",
        "solver",
        "section",
    ])?;
    let text = |name: &str, most: usize, default: &str| match root.get(name)? {
        Some(node) => node.text(most),
        None => Ok(default.to_owned()),
    };
    let materials = materials(&root)?;
    let count = materials.len();
    if count < 2 {
        let message = format!("{count} material was found; expected 2 to 16, whose fractions sum to 1");
        return Err(root.need("materials")?.error(Code::Range, message));
    }
    let model = model(&root.need("model")?)?;
    let space = model.space();
    let groups = match root.get("groups")? {
        Some(list) => {
            let items = list.items()?;
            list.check_count(items.len(), " groups", 0..=MOST_GROUPS)?;
            items.iter().map(|item| group(item, space, count)).collect::<Read<_>>()?
        }
        None => Vec::new(),
    };
    Ok(LaplaceDocument {
        title: text("title", 200, "Untitled")?,
        unit: text("unit", 16, "mm")?,
        materials,
        groups,
        rest: root.get("rest")?.map(|node| condition(&node, count)).transpose()?,
        options: root.get("solver")?.map_or_else(|| Ok(LaplaceOptions::default()), |node| solver(&node))?,
        section: root.get("section")?.map(|node| section(&node, space)).transpose()?,
        model,
    })
}

fn model(node: &Node<'_>) -> Read<BoundaryModel> {
    const KINDS: [&str; 11] = [
        "cube",
        "sliver-cube",
        "hollow-box",
        "shell",
        "sphere",
        "mug",
        "cylinder",
        "fillet-block",
        "square",
        "annulus",
        "mesh",
    ];
    const FIELDS: [&[&str]; 11] = [
        &["kind", "divisions"],
        &["kind", "divisions", "width"],
        &["kind", "divisions", "wall"],
        &["kind", "inner", "outer", "level"],
        &["kind", "radius", "level"],
        &["kind", "sectors", "sliver"],
        &["kind", "divisions"],
        &["kind", "divisions"],
        &["kind", "divisions"],
        &["kind", "inner", "outer", "segments"],
        &["kind", "vertices", "triangles"],
    ];
    let kind = node.need("kind")?.choice(&KINDS)?;
    node.only(FIELDS[kind])?;
    // The greatest numbers are those whose elements are at most as many as the solver takes.
    let count = |name: &str, least: usize, most: usize, default: usize| {
        node.get(name)?.map_or(Ok(default), |node| node.count_within(least..=most))
    };
    let number = |name: &str, least: f64, most: f64, default: f64| {
        node.get(name)?.map_or(Ok(default), |node| node.within(least..=most))
    };
    let radii = |widest: f64| -> Read<(f64, f64)> {
        let outer = number("outer", SMALLEST, LARGEST, 1.0)?;
        Ok((number("inner", 1e-3 * outer, widest * outer, 0.5 * outer)?, outer))
    };
    Ok(match kind {
        0 => BoundaryModel::Cube { divisions: count("divisions", 1, 51, 8)? },
        1 => {
            let divisions = count("divisions", 2, 50, 8)?;
            BoundaryModel::SliverCube {
                divisions,
                width: number("width", 1e-8, 0.5 / divisions as f64, 1e-6)?,
            }
        }
        2 => BoundaryModel::HollowBox {
            divisions: count("divisions", 1, 36, 6)?,
            wall: number("wall", 1e-3, 0.45, 0.05)?,
        },
        3 => {
            let (inner, outer) = radii(THINNEST)?;
            BoundaryModel::Shell { inner, outer, level: count("level", 0, 4, 2)? }
        }
        4 => BoundaryModel::Sphere {
            radius: number("radius", SMALLEST, LARGEST, 1.0)?,
            level: count("level", 0, 5, 3)?,
        },
        5 => BoundaryModel::Mug {
            sectors: count("sectors", 6, 120, 20)?,
            sliver: number("sliver", 0.0, 1e-2, 0.0)?,
        },
        6 => BoundaryModel::Cylinder { divisions: count("divisions", 2, 29, 6)? },
        7 => BoundaryModel::FilletBlock { divisions: count("divisions", 1, 40, 6)? },
        8 => BoundaryModel::Square { divisions: count("divisions", 1, 8000, 32)? },
        9 => {
            let segments = count("segments", 6, 20_000, 128)?;
            // The corners of the inner polygon stay within the sides of the outer one.
            let (inner, outer) = radii(THINNEST * (PI / segments as f64).cos())?;
            BoundaryModel::Annulus { inner, outer, segments }
        }
        _ => mesh(node)?,
    })
}

fn mesh(node: &Node<'_>) -> Read<BoundaryModel> {
    let list = node.need("vertices")?;
    let items = list.items()?;
    list.check_count(items.len(), " vertices", 4..=3 * MOST_ELEMENTS)?;
    let vertices: Vec<DVec3> = items.iter().map(|item| vector(item, Space::Solid)).collect::<Read<_>>()?;
    let list = node.need("triangles")?;
    let items = list.items()?;
    list.check_count(items.len(), " triangles", 4..=MOST_ELEMENTS)?;
    let triangle = |item: &Node<'_>| -> Read<[u32; 3]> {
        let corners = item.items()?;
        item.check_count(corners.len(), " vertices", 3..=3)?;
        let mut triangle = [0; 3];
        for (corner, node) in triangle.iter_mut().zip(&corners) {
            *corner = node.index(vertices.len(), "vertex")? as u32;
        }
        Ok(triangle)
    };
    let triangles = items.iter().map(triangle).collect::<Read<_>>()?;
    Ok(BoundaryModel::Mesh { vertices, triangles })
}

/// As many coordinates as there are dimensions.
fn vector(node: &Node<'_>, space: Space) -> Read<DVec3> {
    let items = node.items()?;
    let dimension = space.dimension();
    node.check_count(items.len(), " coordinates", dimension..=dimension)?;
    let mut vector = [0.0; 3];
    for (part, item) in vector.iter_mut().zip(&items) {
        *part = item.within(-LARGEST..=LARGEST)?;
    }
    Ok(DVec3::from_array(vector))
}

fn direction(node: &Node<'_>, space: Space) -> Read<DVec3> {
    let vector = vector(node, space)?;
    vector
        .try_normalize()
        .ok_or_else(|| node.error(Code::Range, "it has no length; expected a direction".to_owned()))
}

fn group(node: &Node<'_>, space: Space, materials: usize) -> Read<GroupSpec> {
    node.only(&["name", "where", "condition"])?;
    Ok(GroupSpec {
        name: node.need("name")?.text(100)?,
        selection: selection(&node.need("where")?, space)?,
        condition: condition(&node.need("condition")?, materials)?,
    })
}

fn selection(node: &Node<'_>, space: Space) -> Read<Selection> {
    const WAYS: [&str; 5] = ["direction", "angle", "box", "positive", "elements"];
    node.only(&WAYS)?;
    let angle = node.get("angle")?;
    let degrees = angle.map_or(Ok(10.0), |node| node.within(0.0..=180.0))?;
    let way = node.get("direction")?.map(|node| direction(&node, space)).transpose()?;
    if let (Some(angle), None) = (angle, way) {
        let message = "it was found without a `direction`, from which it is measured";
        return Err(angle.error(Code::Range, message.to_owned()));
    }
    let corners = |node: &Node<'_>| -> Read<[DVec3; 2]> {
        let items = node.items()?;
        node.check_count(items.len(), " corners", 2..=2)?;
        let [a, b] = [vector(&items[0], space)?, vector(&items[1], space)?];
        Ok([a.min(b), a.max(b)])
    };
    let found = Selection {
        direction: way.map(|way| (way, degrees)),
        bounds: node.get("box")?.map(|node| corners(&node)).transpose()?,
        positive: node.get("positive")?.map(|node| node.text(LONGEST_EXPRESSION)).transpose()?,
        elements: node.get("elements")?.map(|node| runs(&node)).transpose()?,
    };
    if found == Selection::default() {
        let message = "nothing was found; expected `direction`, `box`, `positive` or `elements`, of which all must hold";
        return Err(node.error(Code::Missing, message.to_owned()));
    }
    Ok(found)
}

fn runs(node: &Node<'_>) -> Read<Vec<[usize; 2]>> {
    let items = node.items()?;
    node.check_count(items.len(), " runs", 0..=MOST_RUNS)?;
    let mut runs = Vec::with_capacity(items.len());
    for item in &items {
        let ends = item.items()?;
        item.check_count(ends.len(), " indices", 2..=2)?;
        let first = ends[0].index(MOST_ELEMENTS, "element")?;
        let last = ends[1].index(MOST_ELEMENTS, "element")?;
        if last < first {
            let message =
                format!("{last} was found; expected the last element of a run that begins at {first}");
            return Err(ends[1].error(Code::Range, message));
        }
        runs.push([first, last]);
    }
    Ok(runs)
}

fn condition(node: &Node<'_>, materials: usize) -> Read<ConditionSpec> {
    node.only(&["value", "flux"])?;
    let (is_value, list) = match (node.get("value")?, node.get("flux")?) {
        (Some(_), Some(_)) => {
            let message = "both `value` and `flux` were found; expected one of them";
            return Err(node.error(Code::Range, message.to_owned()));
        }
        (None, None) => return Err(node.error(Code::Missing, "expected `value` or `flux`".to_owned())),
        (Some(_), None) => (true, node.need("value")?),
        (None, Some(_)) => (false, node.need("flux")?),
    };
    let items = list.items()?;
    list.check_count(items.len(), if is_value { " fractions" } else { " fluxes" }, materials..=materials)?;
    let range = if is_value { 0.0..=1.0 } else { -LARGEST..=LARGEST };
    let mut data = Vec::with_capacity(items.len());
    for item in &items {
        data.push(if item.is_text() {
            Datum::Text(item.text(LONGEST_EXPRESSION)?)
        } else {
            Datum::Number(item.within(range.clone())?)
        });
    }
    let numbers: Option<Vec<f64>> =
        data.iter().map(|datum| if let Datum::Number(x) = datum { Some(*x) } else { None }).collect();
    if let Some(numbers) = numbers {
        let (sum, expected) = (numbers.iter().sum::<f64>(), f64::from(u8::from(is_value)));
        let largest = numbers.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        if (sum - expected).abs() > SUM * if is_value { 1.0 } else { largest } {
            let message = format!("the sum {sum} was found; expected {expected}");
            return Err(list.error(Code::Range, message));
        }
    }
    Ok(ConditionSpec { is_value, data })
}

fn section(node: &Node<'_>, space: Space) -> Read<SectionSpec> {
    if space == Space::Plane {
        let message = "it was found for a problem in the plane; expected it for bodies in space alone";
        return Err(node.error(Code::Range, message.to_owned()));
    }
    node.only(&["origin", "normal"])?;
    Ok(SectionSpec {
        origin: vector(&node.need("origin")?, space)?,
        normal: direction(&node.need("normal")?, space)?,
    })
}
