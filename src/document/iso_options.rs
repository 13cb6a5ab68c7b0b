//! What lines of equal fraction are asked for.

use super::{DocumentError, Json, Node};

/// A material and the levels of its fraction; see `docs/api.md`.
#[derive(Debug, Clone, PartialEq)]
pub struct IsoOptions {
    /// Index of the material.
    pub material: usize,
    /// Fractions, 0 to 1.
    pub levels: Vec<f64>,
}

/// Most levels of one request.
const MOST_LEVELS: usize = 100;

impl IsoOptions {
    /// Reads options for a document of `materials` materials; a material left out is the first.
    ///
    /// # Errors
    /// When a field is unknown, missing, of the wrong type or out of range.
    pub fn read(options: &Json, materials: usize) -> Result<Self, DocumentError> {
        let root = Node::root(options, "options");
        root.only(&["material", "levels"])?;
        let list = root.need("levels")?;
        let mut levels = Vec::new();
        for item in list.items()? {
            levels.push(item.within(0.0..=1.0)?);
        }
        list.check_count(levels.len(), " levels", 1..=MOST_LEVELS)?;
        let material = root.get("material")?.map_or(Ok(0), |node| node.index(materials, "material"))?;
        Ok(Self { material, levels })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Code;

    fn read(text: &str) -> Result<IsoOptions, DocumentError> {
        IsoOptions::read(&Json::parse(text)?, 3)
    }

    #[test]
    fn a_material_left_out_is_the_first() {
        let options = read(r#"{"levels": [0.5]}"#).expect("valid");
        assert_eq!((options.material, options.levels), (0, vec![0.5]));
        let options = read(r#"{"material": 2, "levels": [0, 0.25, 1]}"#).expect("valid");
        assert_eq!((options.material, options.levels), (2, vec![0.0, 0.25, 1.0]));
    }

    #[test]
    fn errors_name_the_option() {
        let many = format!("{{\"levels\": [{}0.5]}}", "0.5,".repeat(MOST_LEVELS));
        for (text, code, path) in [
            ("{}", Code::Missing, "options.levels"),
            (r#"{"levels": [1], "material": 3}"#, Code::Range, "options.material"),
            (r#"{"levels": [1], "material": -1}"#, Code::Type, "options.material"),
            (r#"{"levels": [1], "material": 0.5}"#, Code::Type, "options.material"),
            (r#"{"levels": []}"#, Code::Range, "options.levels"),
            (r#"{"levels": 0.5}"#, Code::Type, "options.levels"),
            (r#"{"levels": [0.5, 1.5]}"#, Code::Range, "options.levels[1]"),
            (r#"{"levels": [null]}"#, Code::Type, "options.levels[0]"),
            (r#"{"level": 0.5}"#, Code::UnknownField, "options.level"),
            (&many, Code::Limit, "options.levels"),
        ] {
            let error = read(text).expect_err("refused");
            assert_eq!((error.code, error.path.as_str()), (code, path), "{text}");
        }
    }
}
