//! What a solid is asked for.

use super::{DocumentError, Json, Node};
use crate::solid::Format;

/// How finely a solid is cut, and what it shows; see `docs/api.md`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolidOptions {
    /// Number of steps from curve to curve; that of the document without it.
    pub stages: Option<usize>,
    /// Whether the rims of closed curves get caps.
    pub caps: bool,
    /// What the colours of the vertices say.
    pub color: SolidColor,
}

/// What the colours of the vertices of a solid say.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SolidColor {
    /// The mix of materials, in its colour.
    Material,
    /// The fraction of one material, by its index.
    Fraction(usize),
    /// The twist of the ruling lines.
    Twist,
    /// The angle between the normals of the surface at both ends of a ruling line.
    Flank,
}

impl Default for SolidOptions {
    fn default() -> Self {
        Self { stages: None, caps: true, color: SolidColor::Material }
    }
}

impl SolidOptions {
    /// Reads options for a document of `materials` materials; all may be left out.
    ///
    /// # Errors
    /// When a field is unknown, of the wrong type or out of range.
    pub fn read(options: &Json, materials: usize) -> Result<Self, DocumentError> {
        let root = Node::root(options, "options");
        root.only(&["stages", "caps", "color"])?;
        Self::of(&root, materials)
    }

    /// Reads options that name the format of a file as well.
    ///
    /// # Errors
    /// As for [`read`](Self::read), and when the format is missing.
    pub fn read_file(options: &Json, materials: usize) -> Result<(Format, Self), DocumentError> {
        let root = Node::root(options, "options");
        root.only(&["format", "stages", "caps", "color"])?;
        let format = match root.need("format")?.choice(&["stl", "ply", "obj"])? {
            0 => Format::Stl,
            1 => Format::Ply,
            _ => Format::Obj,
        };
        Ok((format, Self::of(&root, materials)?))
    }

    /// Reads the fields of an object that may have others.
    fn of(root: &Node<'_>, materials: usize) -> Result<Self, DocumentError> {
        Ok(Self {
            stages: root.get("stages")?.map(|node| node.count_within(1..=200)).transpose()?,
            caps: root.get("caps")?.map_or(Ok(true), |node| node.flag())?,
            color: root.get("color")?.map_or(Ok(SolidColor::Material), |node| color(&node, materials))?,
        })
    }
}

fn color(node: &Node<'_>, materials: usize) -> Result<SolidColor, DocumentError> {
    if node.is_object() {
        node.only(&["material"])?;
        return Ok(SolidColor::Fraction(node.need("material")?.index(materials, "material")?));
    }
    Ok(match node.choice(&["material", "twist", "flank"])? {
        0 => SolidColor::Material,
        1 => SolidColor::Twist,
        _ => SolidColor::Flank,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Code;

    fn read(text: &str) -> Result<SolidOptions, DocumentError> {
        SolidOptions::read(&Json::parse(text)?, 2)
    }

    #[test]
    fn everything_may_be_left_out() {
        assert_eq!(read("{}"), Ok(SolidOptions::default()));
        let all = read(r#"{"stages": 40, "caps": false, "color": {"material": 1}}"#);
        assert_eq!(all, Ok(SolidOptions { stages: Some(40), caps: false, color: SolidColor::Fraction(1) }));
        assert_eq!(read(r#"{"color": "flank"}"#).map(|options| options.color), Ok(SolidColor::Flank));
    }

    #[test]
    fn errors_name_the_option() {
        for (text, code, path) in [
            (r#"{"stages": 0}"#, Code::Range, "options.stages"),
            (r#"{"stages": 201}"#, Code::Limit, "options.stages"),
            (r#"{"stages": "5"}"#, Code::Type, "options.stages"),
            (r#"{"caps": 1}"#, Code::Type, "options.caps"),
            (r#"{"color": "red"}"#, Code::Range, "options.color"),
            (r#"{"color": 1}"#, Code::Type, "options.color"),
            (r#"{"color": {"material": 2}}"#, Code::Range, "options.color.material"),
            (r#"{"color": {}}"#, Code::Missing, "options.color.material"),
            (r#"{"color": {"materials": 0}}"#, Code::UnknownField, "options.color.materials"),
            (r#"{"cap": true}"#, Code::UnknownField, "options.cap"),
        ] {
            let error = read(text).expect_err("refused");
            assert_eq!((error.code, error.path.as_str()), (code, path), "{text}");
        }
    }
}
