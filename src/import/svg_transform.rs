//! Transforms, lengths and views of SVG.

use kurbo::{Affine, Vec2};
use roxmltree::Node;
use std::str::FromStr;
use svgtypes::{Align, AspectRatio, Length, LengthUnit, TransformListParser, TransformListToken, ViewBox};

/// User units of an inch.
const INCH: f64 = 96.0;
/// User units of a letter's height, for lengths that count in those.
const LETTER: f64 = 16.0;

/// The transform of an element's attribute; `None` when it cannot be read.
pub(super) fn transform(node: Node<'_, '_>) -> Option<Affine> {
    let Some(text) = node.attribute("transform") else { return Some(Affine::IDENTITY) };
    let mut result = Affine::IDENTITY;
    for token in TransformListParser::from(text) {
        result *= match token.ok()? {
            TransformListToken::Matrix { a, b, c, d, e, f } => Affine::new([a, b, c, d, e, f]),
            TransformListToken::Translate { tx, ty } => Affine::translate((tx, ty)),
            TransformListToken::Scale { sx, sy } => Affine::scale_non_uniform(sx, sy),
            TransformListToken::Rotate { angle } => Affine::rotate(angle.to_radians()),
            TransformListToken::SkewX { angle } => Affine::skew(angle.to_radians().tan(), 0.0),
            TransformListToken::SkewY { angle } => Affine::skew(0.0, angle.to_radians().tan()),
        };
    }
    result.as_coeffs().iter().all(|c| c.is_finite()).then_some(result)
}

/// A length in user units, or nothing when it is not there or cannot be read; `whole` is what per cent refer to.
pub(super) fn length(node: Node<'_, '_>, name: &str, whole: f64) -> Option<f64> {
    let Length { number, unit } = Length::from_str(node.attribute(name)?).ok()?;
    let size = match unit {
        LengthUnit::None | LengthUnit::Px => 1.0,
        LengthUnit::Em => LETTER,
        LengthUnit::Ex => LETTER / 2.0,
        LengthUnit::In => INCH,
        LengthUnit::Cm => INCH / 2.54,
        LengthUnit::Mm => INCH / 25.4,
        LengthUnit::Pt => INCH / 72.0,
        LengthUnit::Pc => INCH / 6.0,
        LengthUnit::Percent => whole / 100.0,
    };
    Some(number * size)
}

/// The view box of an element.
pub(super) fn view_box(node: Node<'_, '_>) -> Option<ViewBox> {
    ViewBox::from_str(node.attribute("viewBox")?).ok()
}

/// The transform of what stands in a view box to a viewport of the given size, as `preserveAspectRatio` asks.
pub(super) fn fitted(node: Node<'_, '_>, view: ViewBox, size: Vec2) -> Affine {
    let ratio = node.attribute("preserveAspectRatio").and_then(|text| AspectRatio::from_str(text).ok());
    let (align, slice) = ratio.map_or((Align::XMidYMid, false), |ratio| (ratio.align, ratio.slice));
    let (sx, sy) = (size.x / view.w, size.y / view.h);
    if align == Align::None {
        return Affine::scale_non_uniform(sx, sy) * Affine::translate((-view.x, -view.y));
    }
    let scale = if slice { sx.max(sy) } else { sx.min(sy) };
    let room = size - Vec2::new(view.w, view.h) * scale;
    let x = match align {
        Align::XMinYMin | Align::XMinYMid | Align::XMinYMax => 0.0,
        Align::XMaxYMin | Align::XMaxYMid | Align::XMaxYMax => 1.0,
        _ => 0.5,
    };
    let y = match align {
        Align::XMinYMin | Align::XMidYMin | Align::XMaxYMin => 0.0,
        Align::XMinYMax | Align::XMidYMax | Align::XMaxYMax => 1.0,
        _ => 0.5,
    };
    Affine::translate((room.x * x, room.y * y)) * Affine::scale(scale) * Affine::translate((-view.x, -view.y))
}
