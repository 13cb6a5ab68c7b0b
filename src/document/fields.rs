//! The fields of a curves document, read and checked one by one, with the defaults of those left out.

use super::control_points::control_points;
use super::node::Node;
use super::schema::{
    BestShift, Blend, BlendKind, CompositionKey, CurveForm, CurveSpec, CurvesDocument, EndRule, Kind,
    LARGEST, LayerName, MatchingSpec, MaterialSpec, Method, NegativeMode, ObjectiveName, Pin, Policy,
    PrintedRule, SMALLEST, Sampling, SamplingScheme, Shift, View,
};
use super::{Code, DocumentError};
use crate::curve::Fineness;

/// Lines and segments of a harmonic blend that names none.
#[cfg(feature = "harmonic")]
const HARMONIC_LINES: usize = 44;
#[cfg(feature = "harmonic")]
const HARMONIC_SEGMENTS: usize = 200;

type Read<T> = Result<T, DocumentError>;

/// Most curves of a stack.
const MOST_CURVES: usize = 16;
/// Greatest exponent in the value of a line.
const LARGEST_WEIGHT: f64 = 100.0;

/// Reads a document whose version and kind are known to be right.
pub(super) fn curves_document(node: &Node<'_>) -> Read<CurvesDocument> {
    node.only(&[
        "directrix",
        "kind",
        "title",
        "unit",
        "materials",
        "curves",
        "sampling",
        "matching",
        "blend",
        "view",
    ])?;
    let text = |name: &str, most: usize, default: &str| match node.get(name)? {
        Some(node) => node.text(most),
        None => Ok(default.to_owned()),
    };
    let materials = materials(node)?;
    let curves = curves(&node.need("curves")?, materials.len())?;
    let is_open = all_open(&curves)?;
    let spans = curves.len().saturating_sub(1).max(1);
    let materials_count = materials.len();
    Ok(CurvesDocument {
        directrix: 1,
        kind: Kind::Curves,
        title: text("title", 200, "Untitled")?,
        unit: text("unit", 16, "mm")?,
        materials,
        sampling: node
            .get("sampling")?
            .map_or_else(|| Ok(Sampling::of(curves.len())), |n| sampling(&n, &curves))?,
        curves,
        matching: matching(&node.need("matching")?, is_open, spans)?,
        blend: node.get("blend")?.map_or_else(|| Ok(Blend::default()), |n| blend(&n))?,
        view: node.get("view")?.map(|n| view(&n, materials_count)).transpose()?,
    })
}

/// Materials, two where the document names none.
pub(super) fn materials(node: &Node<'_>) -> Read<Vec<MaterialSpec>> {
    let Some(list) = node.get("materials")? else { return Ok(two_materials()) };
    let items = list.items()?;
    list.check_count(items.len(), " materials", 1..=16)?;
    let mut materials = Vec::with_capacity(items.len());
    for item in &items {
        item.only(&["name", "color", "void"])?;
        materials.push(MaterialSpec {
            name: item.need("name")?.text(100)?,
            color: item.need("color")?.text(100)?,
            void: item.get("void")?.map_or(Ok(false), |n| n.flag())?,
        });
    }
    Ok(materials)
}

fn curves(list: &Node<'_>, materials: usize) -> Read<Vec<CurveSpec>> {
    let items = list.items()?;
    list.check_count(items.len(), " curves", 0..=MOST_CURVES)?;
    if cfg!(not(feature = "stack")) && items.len() > 2 {
        let message = "stacks of more than 2 curves need the module \"full\"";
        return Err(list.error(Code::NotInModule, message.to_owned()));
    }
    let mut curves = Vec::with_capacity(items.len());
    for (number, item) in items.iter().enumerate() {
        curves.push(curve(item, &pure(number.min(materials - 1), materials))?);
    }
    #[cfg(feature = "solid")]
    same_space(&items, &curves)?;
    Ok(curves)
}

/// Tells whether the curves are open, of which closed ones are refused beside them.
fn all_open(curves: &[CurveSpec]) -> Read<bool> {
    let is_open = |curve: &CurveSpec| curve.form == CurveForm::Open;
    let first = curves.first().is_some_and(is_open);
    if let Some(other) = curves.iter().position(|curve| is_open(curve) != first) {
        let [found, others] = if first { ["closed", "open"] } else { ["open", "closed"] };
        let message = format!(
            "the curve is {found} and the first one {others}; expected all curves open, or all closed"
        );
        return Err(DocumentError::new(Code::Range, format!("curves[{other}].form"), message));
    }
    Ok(first)
}

/// Refuses plane curves beside curves in space, and heights of the latter.
#[cfg(feature = "solid")]
fn same_space(items: &[Node<'_>], curves: &[CurveSpec]) -> Read<()> {
    let is_in_space = |curve: &CurveSpec| curve.points.in_space().is_some();
    let first = curves.first().is_some_and(is_in_space);
    if let Some(third) = items.get(2).filter(|_| first) {
        return Err(third.not_yet("stacks of curves in space"));
    }
    for (item, curve) in items.iter().zip(curves) {
        if is_in_space(curve) != first {
            let [found, expected] = if first { [2, 3] } else { [3, 2] };
            let message = format!(
                "points of {found} coordinates were found; expected {expected}, as the first curve has"
            );
            return Err(item.need("points")?.error(Code::Type, message));
        }
        if first && curve.height != 0.0 {
            let message =
                format!("{} was found; expected 0, because the points have a z of their own", curve.height);
            return Err(item.need("height")?.error(Code::Range, message));
        }
    }
    Ok(())
}

/// The composition of one material alone, all along a curve.
fn pure(material: usize, materials: usize) -> Vec<CompositionKey> {
    let mix = (0..materials).map(|k| if k == material { 1.0 } else { 0.0 }).collect();
    vec![CompositionKey { at: 0.0, mix }]
}

fn curve(node: &Node<'_>, own: &[CompositionKey]) -> Read<CurveSpec> {
    node.only(&["name", "degree", "form", "points", "knots", "height", "composition"])?;
    let form = node.need("form")?;
    let form = match form.choice(&["periodic", "clamped", "open"])? {
        0 => CurveForm::Periodic,
        1 => CurveForm::Clamped,
        _ => CurveForm::Open,
    };
    let points = control_points(&node.need("points")?)?;
    Ok(CurveSpec {
        name: node.get("name")?.map(|n| n.text(100)).transpose()?,
        degree: node.need("degree")?.count()?,
        form,
        points,
        knots: node.get("knots")?.map(|n| numbers(&n)).transpose()?,
        height: node.get("height")?.map_or(Ok(0.0), |n| n.within(-LARGEST..=LARGEST))?,
        composition: node.get("composition")?.map_or_else(|| Ok(own.to_vec()), |n| composition(&n))?,
    })
}

fn composition(node: &Node<'_>) -> Read<Vec<CompositionKey>> {
    let mut keys = Vec::new();
    for key in node.items()? {
        key.only(&["at", "mix"])?;
        keys.push(CompositionKey { at: key.need("at")?.number()?, mix: numbers(&key.need("mix")?)? });
    }
    Ok(keys)
}

/// A list of finite numbers.
pub(super) fn numbers(node: &Node<'_>) -> Read<Vec<f64>> {
    let items = node.items()?;
    let mut numbers = Vec::with_capacity(items.len());
    for item in items {
        numbers.push(item.number()?);
    }
    Ok(numbers)
}

fn sampling(node: &Node<'_>, curves: &[CurveSpec]) -> Read<Sampling> {
    node.only(&["scheme", "counts", "tolerance", "maxTurn", "minCount"])?;
    let mut sampling = Sampling::of(curves.len());
    if let Some(scheme) = node.get("scheme")? {
        sampling.scheme = match scheme.choice(&["parameter", "arc-length", "adaptive"])? {
            0 => SamplingScheme::Parameter,
            1 => SamplingScheme::ArcLength,
            _ => SamplingScheme::Adaptive,
        };
    }
    if let Some(counts) = node.get("counts")? {
        let items = counts.items()?;
        let wanted = sampling.counts.len();
        counts.check_count(items.len(), " counts", wanted..=wanted)?;
        for (count, item) in sampling.counts.iter_mut().zip(&items) {
            *count = item.count_within(3..=1000)?;
        }
    }
    sampling.tolerance = node.get("tolerance")?.map(|n| n.within(SMALLEST..=LARGEST)).transpose()?;
    sampling.max_turn = node.get("maxTurn")?.map(|n| n.within(1.0..=90.0)).transpose()?;
    sampling.min_count = node.get("minCount")?.map(|n| n.count_within(3..=1000)).transpose()?;
    if sampling.scheme == SamplingScheme::Adaptive {
        let Fineness { tolerance, max_turn, min_count } = sampling.fineness(curves);
        sampling.tolerance = Some(tolerance);
        sampling.max_turn = Some(max_turn);
        sampling.min_count = Some(min_count);
    }
    Ok(sampling)
}

fn matching(node: &Node<'_>, is_open: bool, spans: usize) -> Read<MatchingSpec> {
    node.only(&[
        "method",
        "objective",
        "linePrice",
        "normalWeight",
        "distanceWeight",
        "alignmentWeight",
        "negative",
        "oneToOne",
        "lines",
        "shift",
        "policy",
        "ends",
        "pins",
        "printed",
    ])?;
    let method = node.need("method")?;
    let method = match method.choice(&["greedy", "exact", "one-per-vertex", "shift", "parameter"])? {
        0 => Method::Greedy,
        1 => Method::Exact,
        2 => Method::OnePerVertex,
        3 => Method::Shift,
        _ => Method::Parameter,
    };
    let objective =
        node.get("objective")?.map(|n| n.choice(&["integral", "sum", "sum-less-price"])).transpose()?;
    let objective = match objective {
        Some(1) => Some(ObjectiveName::Sum),
        Some(2) => Some(ObjectiveName::SumLessPrice),
        None if method != Method::Exact => None,
        _ => Some(ObjectiveName::Integral),
    };
    let line_price = node.get("linePrice")?.map(|n| n.within(0.0..=LARGEST)).transpose()?;
    let shift = match node.get("shift")? {
        Some(shift) if shift.is_text() => {
            shift.choice(&["best"])?;
            Some(Shift::Best(BestShift::Best))
        }
        Some(shift) => {
            let by = shift.count_within(0..=999)?;
            if by > 0 && is_open && method == Method::Shift {
                let message =
                    format!("{by} was found; expected 0 or `best`, because open curves have no seam");
                return Err(shift.error(Code::Range, message));
            }
            Some(Shift::By(by))
        }
        None => (method == Method::Shift).then_some(Shift::Best(BestShift::Best)),
    };
    let pins = node.get("pins")?.map_or_else(|| Ok(Vec::new()), |n| pins(&n, method, spans))?;
    let weight =
        |name: &str, default: f64| node.get(name)?.map_or(Ok(default), |n| n.within(0.0..=LARGEST_WEIGHT));
    Ok(MatchingSpec {
        method,
        objective,
        line_price: line_price.or_else(|| (objective == Some(ObjectiveName::SumLessPrice)).then_some(0.0)),
        lines: node.get("lines")?.map(|n| n.count_within(3..=1000)).transpose()?,
        shift,
        normal_weight: weight("normalWeight", 1.0)?,
        distance_weight: weight("distanceWeight", 2.0)?,
        alignment_weight: weight("alignmentWeight", 0.0)?,
        negative: match node.get("negative")?.map_or(Ok(0), |n| n.choice(&["signed", "clamp", "half"]))? {
            0 => NegativeMode::Signed,
            1 => NegativeMode::Clamp,
            _ => NegativeMode::Half,
        },
        one_to_one: node.get("oneToOne")?.map_or(Ok(false), |n| n.flag())?,
        policy: match node.get("policy")?.map_or(Ok(0), |n| n.choice(&["strict", "repair"]))? {
            0 => Policy::Strict,
            _ => Policy::Repair,
        },
        ends: match node.get("ends")?.map(|n| n.choice(&["tied", "free"])).transpose()? {
            Some(0) => Some(EndRule::Tied),
            None => is_open.then_some(EndRule::Tied),
            Some(_) => Some(EndRule::Free),
        },
        pins,
        printed: node.get("printed")?.map_or_else(|| Ok(Vec::new()), |n| printed(&n))?,
    })
}

/// Most pins of a document.
const MOST_PINS: usize = 200;

fn pins(list: &Node<'_>, method: Method, spans: usize) -> Read<Vec<Pin>> {
    let items = list.items()?;
    if !items.is_empty() && method != Method::Exact {
        let message = "pins were found; expected none, because only the method `exact` can keep them";
        return Err(list.error(Code::Range, message.to_owned()));
    }
    list.check_count(items.len(), " pins", 0..=MOST_PINS)?;
    let mut pins = Vec::with_capacity(items.len());
    for item in &items {
        item.only(&["u", "v", "pair"])?;
        let place = |name: &str| item.need(name)?.within(-LARGEST..=LARGEST);
        let pair = item.get("pair")?.map_or(Ok(0), |node| node.index(spans, "span"))?;
        pins.push(Pin { u: place("u")?, v: place("v")?, pair });
    }
    Ok(pins)
}

fn printed(list: &Node<'_>) -> Read<Vec<PrintedRule>> {
    let mut rules = Vec::new();
    for item in list.items()? {
        rules.push(PrintedRule::ALL[item.choice(&PrintedRule::NAMES)?]);
    }
    Ok(PrintedRule::ALL.into_iter().filter(|rule| rules.contains(rule)).collect())
}

fn blend(node: &Node<'_>) -> Read<Blend> {
    node.only(&["kind", "stages", "lines", "segments"])?;
    let default = Blend::default();
    let kind = match node.get("kind")? {
        None => default.kind,
        Some(kind) => match kind.choice(&["ruled", "cubic", "harmonic"])? {
            0 => BlendKind::Ruled,
            1 => BlendKind::Cubic,
            #[cfg(feature = "harmonic")]
            _ => BlendKind::Harmonic,
            #[cfg(not(feature = "harmonic"))]
            _ => {
                let message = "the blend `harmonic` needs the module \"full\"";
                return Err(kind.error(Code::NotInModule, message.to_owned()));
            }
        },
    };
    let stages = node.get("stages")?.map_or(Ok(default.stages), |n| n.count_within(1..=200))?;
    // The module of figures computes no harmonic blend: it passes over what belongs to one.
    #[cfg(not(feature = "harmonic"))]
    let (lines, segments) = (None, None);
    #[cfg(feature = "harmonic")]
    let (lines, segments) = {
        let own = |default: usize| (kind == BlendKind::Harmonic).then_some(default);
        let lines = node.get("lines")?.map(|n| n.count_within(1..=400)).transpose()?;
        let segments = node.get("segments")?.map(|n| n.count_within(16..=1000)).transpose()?;
        (lines.or(own(HARMONIC_LINES)), segments.or(own(HARMONIC_SEGMENTS)))
    };
    Ok(Blend { kind, stages, lines, segments })
}

fn view(node: &Node<'_>, materials: usize) -> Read<View> {
    node.only(&["layers", "center", "span", "s", "isoMaterial", "patterns"])?;
    Ok(View {
        layers: node.get("layers")?.map(|n| layers(&n)).transpose()?,
        center: node.get("center")?.map(|n| center(&n)).transpose()?,
        span: node.get("span")?.map(|n| n.within(1e-9..=LARGEST)).transpose()?,
        s: node.get("s")?.map(|n| n.within(0.0..=1.0)).transpose()?,
        iso_material: node.get("isoMaterial")?.map(|n| n.index(materials, "material")).transpose()?,
        patterns: node.get("patterns")?.map(|n| n.flag()).transpose()?,
    })
}

fn center(node: &Node<'_>) -> Read<[f64; 2]> {
    for coordinate in node.items()? {
        coordinate.within(-LARGEST..=LARGEST)?;
    }
    node.pair()
}

/// Reads a list of layers.
pub(crate) fn layers(node: &Node<'_>) -> Read<Vec<LayerName>> {
    let mut layers = Vec::new();
    for item in node.items()? {
        layers.push(LayerName::ALL[item.choice(&LayerName::NAMES)?]);
    }
    Ok(layers)
}

/// Two materials whose half-way mix stays clean.
fn two_materials() -> Vec<MaterialSpec> {
    let material = |name: &str, color: &str| MaterialSpec {
        name: name.to_owned(),
        color: color.to_owned(),
        void: false,
    };
    vec![material("Material 1", "#f0e442"), material("Material 2", "#009e73")]
}
