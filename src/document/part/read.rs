//! Reading of part documents.

use super::super::control_points::plane_points;
use super::super::fields::{materials, numbers};
use super::super::node::Node;
use super::super::read::check_kind;
use super::super::{Code, CurveForm, DocumentError, Json};
use super::read_blend::read_blend;
use super::schema::{
    BodySpec, ComposingRule, CourseKey, CourseSpec, FeatureSpec, Geometry, PartDocument, PartKind,
    PartRuleSpec, ReferenceSpec, RuleQuantity, ShapeSpec,
};
use crate::material::Composition;
use std::collections::BTreeMap;

/// Most shapes of a part document.
pub const MOST_SHAPES: usize = 500;
/// Most points of all shapes of a part document.
pub const MOST_PART_POINTS: usize = 10_000;
/// Most bodies of a part document.
pub const MOST_BODIES: usize = 64;
/// Most bodies with a blend.
pub const MOST_BLENDS: usize = 16;
/// Most features of a body.
pub const MOST_PART_FEATURES: usize = 32;
/// Most design rules of a part document.
pub const MOST_PART_RULES: usize = 32;
/// Most references of a feature.
const MOST_REFERENCES: usize = 8;
/// Most holes of a body, and shapes that a boundary leaves out.
const MOST_NAMES: usize = 100;
/// Longest name.
pub(super) const LONGEST_NAME: usize = 100;
/// Greatest coordinate and length.
pub(super) const LARGEST: f64 = 1e9;

type Read<T> = Result<T, DocumentError>;

/// Reads a part document and checks every field by itself.
///
/// # Errors
/// The first thing that is wrong, with the path of its field: a document of another kind, a missing or unknown field, a wrong type, a value out of range, a mix that is none, a
/// name that occurs twice, or too many of something. What fields mean together is for [`PartModel`](super::PartModel) to say.
pub fn read_part(document: &Json) -> Read<PartDocument> {
    let root = Node::root(document, "");
    check_kind(&root, "part")?;
    root.only(&["directrix", "kind", "title", "unit", "materials", "shapes", "bodies", "rules"])?;
    let text = |name: &str, most: usize, default: &str| match root.get(name)? {
        Some(node) => node.text(most),
        None => Ok(default.to_owned()),
    };
    let materials = materials(&root)?;
    let count = materials.len();
    Ok(PartDocument {
        directrix: 1,
        kind: PartKind::Part,
        title: text("title", 200, "Untitled")?,
        unit: text("unit", 16, "mm")?,
        shapes: root.get("shapes")?.map_or_else(|| Ok(Vec::new()), |list| shapes(&list))?,
        bodies: bodies(&root.need("bodies")?, count)?,
        rules: root.get("rules")?.map_or_else(|| Ok(Vec::new()), |list| rules(&list, count))?,
        materials,
    })
}

/// Refuses a name that one before has, or that is empty.
fn own_name(node: &Node<'_>, list: &str, names: &mut BTreeMap<String, usize>) -> Read<String> {
    let field = node.need("name")?;
    let name = field.text(LONGEST_NAME)?;
    if name.is_empty() {
        return Err(field.error(Code::Range, "the text is empty; expected a name".to_owned()));
    }
    let number = names.len();
    match names.insert(name.clone(), number) {
        None => Ok(name),
        Some(first) => {
            let message =
                format!("\"{name}\" is the name of {list}[{first}] as well; expected one of its own");
            Err(field.error(Code::Range, message))
        }
    }
}

fn shapes(list: &Node<'_>) -> Read<Vec<ShapeSpec>> {
    let items = list.items()?;
    list.check_count(items.len(), " shapes", 0..=MOST_SHAPES)?;
    let (mut shapes, mut names, mut points) = (Vec::with_capacity(items.len()), BTreeMap::new(), 0);
    for item in &items {
        let name = own_name(item, "shapes", &mut names)?;
        let geometry = geometry(item)?;
        points += match &geometry {
            Geometry::Polygon { points } | Geometry::Polyline { points } | Geometry::Curve { points, .. } => {
                points.len()
            }
            _ => 2,
        };
        list.check_count(points, " points up to here", 0..=MOST_PART_POINTS)?;
        shapes.push(ShapeSpec { name, geometry });
    }
    Ok(shapes)
}

fn geometry(node: &Node<'_>) -> Read<Geometry> {
    const KINDS: [&str; 7] = ["point", "line", "segment", "circle", "polygon", "polyline", "curve"];
    const FIELDS: [&[&str]; 7] = [
        &["name", "kind", "at"],
        &["name", "kind", "through", "direction"],
        &["name", "kind", "from", "to"],
        &["name", "kind", "center", "radius"],
        &["name", "kind", "points"],
        &["name", "kind", "points"],
        &["name", "kind", "degree", "form", "points", "knots"],
    ];
    let kind = node.need("kind")?.choice(&KINDS)?;
    node.only(FIELDS[kind])?;
    let place = |name: &str| place(&node.need(name)?);
    let points = || -> Read<Vec<[f64; 2]>> {
        let list = node.need("points")?;
        for item in list.items()? {
            self::place(&item)?;
        }
        plane_points(&list)
    };
    Ok(match kind {
        0 => Geometry::Point { at: place("at")? },
        1 => Geometry::Line { through: place("through")?, direction: place("direction")? },
        2 => Geometry::Segment { from: place("from")?, to: place("to")? },
        3 => {
            Geometry::Circle { center: place("center")?, radius: node.need("radius")?.within(0.0..=LARGEST)? }
        }
        4 => Geometry::Polygon { points: points()? },
        5 => Geometry::Polyline { points: points()? },
        _ => Geometry::Curve {
            degree: node.need("degree")?.count()?,
            form: match node.need("form")?.choice(&["periodic", "clamped", "open"])? {
                0 => CurveForm::Periodic,
                1 => CurveForm::Clamped,
                _ => CurveForm::Open,
            },
            points: points()?,
            knots: node.get("knots")?.map(|list| numbers(&list)).transpose()?,
        },
    })
}

/// Two coordinates.
fn place(node: &Node<'_>) -> Read<[f64; 2]> {
    let pair = node.pair()?;
    for item in node.items()? {
        item.within(-LARGEST..=LARGEST)?;
    }
    Ok(pair)
}

fn bodies(list: &Node<'_>, materials: usize) -> Read<Vec<BodySpec>> {
    let items = list.items()?;
    list.check_count(items.len(), " bodies", 0..=MOST_BODIES)?;
    let (mut bodies, mut names, mut blends) = (Vec::with_capacity(items.len()), BTreeMap::new(), 0);
    for item in &items {
        item.only(&["name", "outline", "holes", "default", "blend", "rule", "features"])?;
        let name = own_name(item, "bodies", &mut names)?;
        let default = item.get("default")?.map_or_else(
            || Ok(Composition::pure(0, materials).fractions().to_vec()),
            |mix| read_mix(&mix, None, materials),
        )?;
        let mut features = Vec::new();
        if let Some(list) = item.get("features")? {
            let items = list.items()?;
            list.check_count(items.len(), " features", 0..=MOST_PART_FEATURES)?;
            for (number, item) in items.iter().enumerate() {
                features.push(feature(item, number, &default)?);
            }
        }
        let blend = item.get("blend")?.map(|node| read_blend(&node, materials)).transpose()?;
        blends += usize::from(blend.is_some());
        list.check_count(blends, " bodies with blends up to here", 0..=MOST_BLENDS)?;
        let rule = item.get("rule")?.map_or(Ok(0), |rule| rule.choice(&["repaired", "depth", "printed"]))?;
        bodies.push(BodySpec {
            name,
            outline: item.need("outline")?.text(LONGEST_NAME)?,
            holes: item.get("holes")?.map_or_else(|| Ok(Vec::new()), |list| names_of(&list))?,
            default,
            blend,
            rule: [ComposingRule::Repaired, ComposingRule::Depth, ComposingRule::Printed][rule],
            features,
        });
    }
    Ok(bodies)
}

fn names_of(list: &Node<'_>) -> Read<Vec<String>> {
    let items = list.items()?;
    list.check_count(items.len(), " names", 0..=MOST_NAMES)?;
    items.iter().map(|item| item.text(LONGEST_NAME)).collect()
}

/// A mix of all materials, or of some of them by their indices.
pub(super) fn read_mix(list: &Node<'_>, some: Option<&[usize]>, materials: usize) -> Read<Vec<f64>> {
    let given = numbers(list)?;
    let expected = some.map_or(materials, <[usize]>::len);
    list.check_count(given.len(), " fractions", expected..=expected)?;
    let mix = match some {
        None => given,
        Some(some) => {
            let mut mix = vec![0.0; materials];
            some.iter().zip(given).for_each(|(material, fraction)| mix[*material] = fraction);
            mix
        }
    };
    match Composition::new(mix.clone()) {
        Ok(_) => Ok(mix),
        Err(error) => Err(list.error(Code::Range, error.to_string())),
    }
}

fn feature(node: &Node<'_>, number: usize, default: &[f64]) -> Read<FeatureSpec> {
    node.only(&[
        "name",
        "hidden",
        "reference",
        "references",
        "distance",
        "from",
        "to",
        "start",
        "end",
        "materials",
        "course",
    ])?;
    let materials = default.len();
    let some = match node.get("materials")? {
        None => None,
        Some(list) => {
            let items = list.items()?;
            list.check_count(items.len(), " materials", 1..=materials)?;
            let indices: Vec<usize> =
                items.iter().map(|item| item.index(materials, "material")).collect::<Read<_>>()?;
            if let Some(second) = (1..indices.len()).find(|k| indices[..*k].contains(&indices[*k])) {
                let message = format!("material {} occurs twice; expected each once", indices[second]);
                return Err(items[second].error(Code::Range, message));
            }
            Some(indices)
        }
    };
    let course = match node.get("course")? {
        Some(course) => self::course(&course, some.as_deref(), materials)?,
        None => CourseSpec::Linear,
    };
    let mix = |name: &str| node.get(name)?.map(|mix| read_mix(&mix, some.as_deref(), materials)).transpose();
    let start = match (mix("start")?, &course) {
        (Some(start), _) => start,
        (None, CourseSpec::Piecewise { .. }) => default.to_vec(),
        (None, _) => node.need("start").map(|_| default.to_vec())?,
    };
    let limit = |field: Node<'_>| field.within(0.0..=LARGEST);
    let (reference, references, distance) = measured(node)?;
    Ok(FeatureSpec {
        name: node
            .get("name")?
            .map_or_else(|| Ok(format!("Feature {}", number + 1)), |n| n.text(LONGEST_NAME))?,
        hidden: node.get("hidden")?.map_or(Ok(false), |node| node.flag())?,
        reference,
        references,
        distance,
        from: node.get("from")?.map_or(Ok(0.0), limit)?,
        to: limit(node.need("to")?)?,
        start,
        end: mix("end")?.unwrap_or_else(|| default.to_vec()),
        course,
    })
}

/// What a feature is measured to: `reference`, or `references` with `distance`.
type Measured = (Option<ReferenceSpec>, Option<BTreeMap<String, ReferenceSpec>>, Option<String>);

fn measured(node: &Node<'_>) -> Read<Measured> {
    let Some(list) = node.get("references")? else {
        if let Some(distance) = node.get("distance")? {
            let message = "a distance was found; expected `references` beside it, which it is made of";
            return Err(distance.error(Code::Range, message.to_owned()));
        }
        return Ok((Some(reference(&node.need("reference")?)?), None, None));
    };
    if let Some(other) = node.get("reference")? {
        let message = "expected either `reference` or `references`, not both";
        return Err(other.error(Code::Range, message.to_owned()));
    }
    let entries = list.entries()?;
    list.check_count(entries.len(), " references", 1..=MOST_REFERENCES)?;
    let mut references = BTreeMap::new();
    for (name, node) in &entries {
        let is_letter = |c: char| c.is_ascii_alphabetic() || c == '_';
        let is_name = name.len() <= 32
            && name.starts_with(is_letter)
            && name.chars().all(|c| is_letter(c) || c.is_ascii_digit());
        if !is_name {
            let message = "expected a name of up to 32 letters, digits and _, the first no digit";
            return Err(node.error(Code::Range, message.to_owned()));
        }
        references.insert((*name).to_owned(), reference(node)?);
    }
    let distance = node.need("distance")?.text(crate::field::LONGEST_EXPRESSION)?;
    Ok((None, Some(references), Some(distance)))
}

fn reference(node: &Node<'_>) -> Read<ReferenceSpec> {
    if !node.is_object() {
        return Ok(ReferenceSpec::Shape(node.text(LONGEST_NAME)?));
    }
    node.only(&["boundary", "except"])?;
    Ok(ReferenceSpec::Boundary {
        boundary: node.need("boundary")?.text(LONGEST_NAME)?,
        except: node.get("except")?.map_or_else(|| Ok(Vec::new()), |list| names_of(&list))?,
    })
}

fn course(node: &Node<'_>, some: Option<&[usize]>, materials: usize) -> Read<CourseSpec> {
    const KINDS: [&str; 7] =
        ["linear", "power", "exponential", "smoothstep", "periodic", "piecewise", "expression"];
    const FIELDS: [&str; 7] = ["kind", "power", "rate", "kind", "waves", "keys", "text"];
    let kind = node.need("kind")?.choice(&KINDS)?;
    node.only(&["kind", FIELDS[kind]])?;
    let field = || node.need(FIELDS[kind]);
    Ok(match kind {
        0 => CourseSpec::Linear,
        1 => CourseSpec::Power { power: field()?.number()? },
        2 => CourseSpec::Exponential { rate: field()?.number()? },
        3 => CourseSpec::Smoothstep,
        4 => CourseSpec::Periodic { waves: field()?.count()? },
        5 => {
            let list = field()?;
            let items = list.items()?;
            list.check_count(items.len(), " keys", 1..=1000)?;
            let mut keys = Vec::with_capacity(items.len());
            for item in &items {
                item.only(&["at", "mix"])?;
                let mix = read_mix(&item.need("mix")?, some, materials)?;
                keys.push(CourseKey { at: item.need("at")?.within(0.0..=1.0)?, mix });
            }
            CourseSpec::Piecewise { keys }
        }
        _ => CourseSpec::Expression { text: field()?.text(crate::field::LONGEST_EXPRESSION)? },
    })
}

fn rules(list: &Node<'_>, materials: usize) -> Read<Vec<PartRuleSpec>> {
    let items = list.items()?;
    list.check_count(items.len(), " rules", 0..=MOST_PART_RULES)?;
    let mut rules = Vec::with_capacity(items.len());
    for (number, item) in items.iter().enumerate() {
        item.only(&["name", "material", "of", "least", "most"])?;
        let of = match item.get("of")?.map_or(Ok(0), |of| of.choice(&["fraction", "gradient"]))? {
            0 => RuleQuantity::Fraction,
            _ => RuleQuantity::Gradient,
        };
        let value = |field: Node<'_>| field.within(0.0..=LARGEST);
        let most = match (item.get("most")?, of) {
            (Some(most), _) => value(most)?,
            (None, RuleQuantity::Fraction) => 1.0,
            (None, RuleQuantity::Gradient) => value(item.need("most")?)?,
        };
        rules.push(PartRuleSpec {
            name: item
                .get("name")?
                .map_or_else(|| Ok(format!("Rule {}", number + 1)), |n| n.text(LONGEST_NAME))?,
            material: item.need("material")?.index(materials, "material")?,
            of,
            least: item.get("least")?.map_or(Ok(0.0), value)?,
            most,
        });
    }
    Ok(rules)
}
