//! Reading of the blend of a body.

use super::super::fields::numbers;
use super::super::node::Node;
use super::super::{Code, DocumentError};
use super::read::{LARGEST, LONGEST_NAME, read_mix};
use super::schema::{BoundarySpec, PartBlendKind, PartBlendSpec, SourceSpec};

/// Fewest and most elements of the boundary of a body.
pub(super) const ELEMENTS: std::ops::RangeInclusive<usize> = 32..=2000;
/// Elements of the boundary of a body that is not told how many.
const DEFAULT_ELEMENTS: usize = 300;
/// Most pieces of the boundary of a body.
pub const MOST_BOUNDARIES: usize = 32;
/// How far the sum of gradients may be from 0, over the largest of them.
const SUM: f64 = 1e-9;

type Read<T> = Result<T, DocumentError>;

/// Reads the blend of a body.
///
/// # Errors
/// The first thing that is wrong, with the path of its field.
pub(super) fn read_blend(node: &Node<'_>, materials: usize) -> Read<PartBlendSpec> {
    node.only(&["kind", "elements", "boundaries"])?;
    node.need("kind")?.choice(&["laplace"])?;
    let elements = node.get("elements")?;
    let elements = elements.map_or(Ok(DEFAULT_ELEMENTS), |count| count.count_within(ELEMENTS))?;
    let mut boundaries = Vec::new();
    if let Some(list) = node.get("boundaries")? {
        let items = list.items()?;
        list.check_count(items.len(), " boundaries", 0..=MOST_BOUNDARIES)?;
        for item in &items {
            boundaries.push(boundary(item, materials)?);
        }
    }
    Ok(PartBlendSpec { kind: PartBlendKind::Laplace, elements, boundaries })
}

fn boundary(node: &Node<'_>, materials: usize) -> Read<BoundarySpec> {
    node.only(&["on", "within", "value", "flux", "from"])?;
    let mut first = None;
    for name in ["value", "flux", "from"] {
        match (node.get(name)?, first) {
            (Some(field), Some(first)) => {
                let message = format!("expected either `{first}` or `{name}`, not both");
                return Err(field.error(Code::Range, message));
            }
            (Some(_), None) => first = Some(name),
            _ => {}
        }
    }
    Ok(BoundarySpec {
        on: node.need("on")?.text(LONGEST_NAME)?,
        within: node.get("within")?.map_or(Ok(0.0), |field| field.within(0.0..=LARGEST))?,
        value: node.get("value")?.map(|mix| read_mix(&mix, None, materials)).transpose()?,
        flux: node.get("flux")?.map(|list| flux(&list, materials)).transpose()?,
        from: node.get("from")?.map(|field| source(&field)).transpose()?,
    })
}

fn flux(list: &Node<'_>, materials: usize) -> Read<Vec<f64>> {
    for item in list.items()? {
        item.within(-LARGEST..=LARGEST)?;
    }
    let given = numbers(list)?;
    list.check_count(given.len(), " numbers", materials..=materials)?;
    let largest = given.iter().fold(0.0, |most: f64, number| most.max(number.abs()));
    let sum: f64 = given.iter().sum();
    if sum.abs() > SUM * largest {
        let message = format!("the sum is {sum}; expected 0, because fractions sum to 1 everywhere");
        return Err(list.error(Code::Range, message));
    }
    Ok(given)
}

fn source(node: &Node<'_>) -> Read<SourceSpec> {
    node.only(&["body", "feature"])?;
    match (node.get("body")?, node.get("feature")?) {
        (Some(_), Some(feature)) => {
            let message = "expected either `body` or `feature`, not both";
            Err(feature.error(Code::Range, message.to_owned()))
        }
        (None, Some(feature)) => Ok(SourceSpec::Feature(feature.text(LONGEST_NAME)?)),
        _ => Ok(SourceSpec::Body(node.need("body")?.text(LONGEST_NAME)?)),
    }
}
