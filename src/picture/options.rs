//! Options of a picture as a caller gives them.

use super::{FigureOptions, Margins, Theme, Viewport};
use crate::document::{Code, DocumentError, Json, LayerName, Model, Node, View, layers};
use glam::DVec2;

/// Size, view and content of a picture as a caller asks for them; see `docs/api.md`.
#[derive(Debug, Clone, PartialEq)]
pub struct PictureOptions {
    width: u32,
    height: u32,
    pixel_ratio: f64,
    /// Centre, and scale in CSS pixels per unit.
    view: Option<(DVec2, f64)>,
    layers: Option<Vec<LayerName>>,
    theme: Theme,
    background: bool,
    /// `Some(None)` hides the current in-between curve.
    s: Option<Option<f64>>,
    line: Option<usize>,
    iso_material: Option<usize>,
    patterns: Option<bool>,
}

/// Room along the sides of a fitted picture, in CSS pixels: handles and labels lie on the outermost control points.
const FIT_MARGIN: f64 = 32.0;

impl PictureOptions {
    /// Reads options; those left out have the defaults of `docs/api.md`.
    ///
    /// # Errors
    /// When a field is unknown, missing, of the wrong type or out of range.
    pub fn read(options: &Json) -> Result<Self, DocumentError> {
        let root = Node::root(options, "options");
        root.only(&[
            "width",
            "height",
            "pixelRatio",
            "view",
            "layers",
            "theme",
            "background",
            "s",
            "line",
            "isoMaterial",
            "patterns",
        ])?;
        let side = |name| Ok(root.need(name)?.within(1.0..=4096.0)?.floor() as u32);
        let given = |name| Ok::<_, DocumentError>(root.get(name)?.filter(|node| !node.is_null()));
        let is_dark = root.get("theme")?.map_or(Ok(0), |n| n.choice(&["light", "dark"]))? == 1;
        Ok(Self {
            width: side("width")?,
            height: side("height")?,
            pixel_ratio: root.get("pixelRatio")?.map_or(Ok(1.0), |n| n.within(0.1..=16.0))?,
            view: given("view")?.map(|n| view(&n)).transpose()?,
            layers: root.get("layers")?.map(|n| layers(&n)).transpose()?,
            theme: if is_dark { Theme::dark() } else { Theme::light() },
            background: root.get("background")?.map_or(Ok(true), |n| n.flag())?,
            s: match root.get("s")? {
                None => None,
                Some(node) if node.is_null() => Some(None),
                Some(node) => Some(Some(node.within(0.0..=1.0)?)),
            },
            line: given("line")?.map(|n| n.count()).transpose()?,
            iso_material: given("isoMaterial")?.map(|n| n.count()).transpose()?,
            patterns: given("patterns")?.map(|n| n.flag()).transpose()?,
        })
    }

    /// The view in use: the one asked for, else the document's, else the one that shows everything.
    #[must_use]
    pub fn viewport(&self, model: &Model) -> Viewport {
        let at = |center: DVec2, scale: f64| Viewport {
            width: self.width,
            height: self.height,
            center,
            scale,
            pixel_ratio: self.pixel_ratio,
        };
        if let Some((center, scale)) = self.view {
            return at(center, scale * self.pixel_ratio);
        }
        match model.document().view {
            Some(View { center: Some(center), span: Some(span), .. }) => {
                at(DVec2::from(center), f64::from(self.width.min(self.height)) / span)
            }
            _ => self.fit(model),
        }
    }

    /// The view that shows the curves with their control points.
    #[must_use]
    pub fn fit(&self, model: &Model) -> Viewport {
        Viewport::fit(model.bounds(), self.width, self.height, self.pixel_ratio, Margins::all(FIT_MARGIN))
    }

    /// Refuses what a document does not have.
    ///
    /// # Errors
    /// When `isoMaterial` is not the index of a material.
    pub fn check(&self, model: &Model) -> Result<(), DocumentError> {
        let count = model.materials().len();
        let Some(index) = self.iso_material.filter(|&index| index >= count) else { return Ok(()) };
        let message = format!("{index} was found; expected the index of one of {count} materials");
        Err(DocumentError::new(Code::Range, "options.isoMaterial", message))
    }

    /// What to show of a document.
    #[must_use]
    pub fn figure(&self, model: &Model) -> FigureOptions {
        let view = model.document().view.as_ref();
        let layers = self.layers.clone().or_else(|| view.and_then(|view| view.layers.clone()));
        FigureOptions {
            layers: layers.unwrap_or_else(|| LayerName::DEFAULT.to_vec()),
            theme: self.theme,
            background: self.background,
            s: self.s.unwrap_or_else(|| view.and_then(|view| view.s)),
            line: self.line,
            iso_material: self.iso_material.or_else(|| view.and_then(|view| view.iso_material)).unwrap_or(0),
            patterns: self.patterns.or_else(|| view.and_then(|view| view.patterns)).unwrap_or(false),
        }
    }
}

fn view(node: &Node<'_>) -> Result<(DVec2, f64), DocumentError> {
    node.only(&["center", "scale"])?;
    let center = node.need("center")?.pair()?;
    let scale = node.need("scale")?.within(1e-15..=1e15)?;
    Ok((DVec2::from(center), scale))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Code;

    fn read(text: &str) -> Result<PictureOptions, DocumentError> {
        PictureOptions::read(&Json::parse(text)?)
    }

    fn refusal(text: &str) -> (Code, String) {
        let error = read(text).expect_err("refused");
        (error.code, error.path)
    }

    #[test]
    fn defaults() {
        let options = read(r#"{"width": 800, "height": 600}"#).expect("valid");
        assert_eq!((options.width, options.height, options.pixel_ratio), (800, 600, 1.0));
        assert_eq!((options.theme, options.background), (Theme::light(), true));
        assert_eq!((options.s, options.line, options.view), (None, None, None));
    }

    #[test]
    fn null_hides_or_resets() {
        let text = r#"{"width": 8, "height": 6, "s": null, "line": null, "view": null}"#;
        let options = read(text).expect("valid");
        assert_eq!((options.s, options.line, options.view), (Some(None), None, None));
    }

    #[test]
    fn errors_name_the_option() {
        for (text, code, path) in [
            ("{}", Code::Missing, "options.width"),
            (r#"{"width": 0, "height": 6}"#, Code::Range, "options.width"),
            (r#"{"width": 5000, "height": 6}"#, Code::Range, "options.width"),
            (r#"{"width": 8, "height": "6"}"#, Code::Type, "options.height"),
            (r#"{"width": 8, "height": 6, "s": 2}"#, Code::Range, "options.s"),
            (r#"{"width": 8, "height": 6, "colour": 2}"#, Code::UnknownField, "options.colour"),
            (r#"{"width": 8, "height": 6, "patterns": 1}"#, Code::Type, "options.patterns"),
            (r#"{"width": 8, "height": 6, "theme": "blue"}"#, Code::Range, "options.theme"),
            (r#"{"width": 8, "height": 6, "layers": ["grid", "x"]}"#, Code::Range, "options.layers[1]"),
            (r#"{"width": 8, "height": 6, "view": {"center": [0]}}"#, Code::Type, "options.view.center"),
            ("[]", Code::Type, "options"),
        ] {
            assert_eq!(refusal(text), (code, path.to_owned()), "{text}");
        }
    }
}
