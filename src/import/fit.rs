//! Options and errors of fitting, as they cross the boundary.

use crate::curve::{CornerRule, EndRule, FitError, FitOptions};
use crate::document::{Code, DocumentError, Json, Node};

/// Reads the options of `fitCurve`: `tolerance`, `corners`, `through`, `cornerIndices` and `ends`, all but the first of which
/// may be left out.
///
/// # Errors
/// The first field that is wrong, with its path.
pub fn read_fit_options(json: &Json) -> Result<FitOptions, DocumentError> {
    let root = Node::root(json, "options");
    root.only(&["tolerance", "corners", "through", "cornerIndices", "ends"])?;
    let corner_indices = match root.get("cornerIndices")? {
        Some(list) => Some(list.items()?.iter().map(Node::count).collect::<Result<Vec<_>, _>>()?),
        None => None,
    };
    let second = |name: &str, names: &[&str]| match root.get(name)? {
        Some(node) => node.choice(names).map(|index| index == 1),
        None => Ok(false),
    };
    Ok(FitOptions {
        tolerance: root.need("tolerance")?.number()?,
        corners: if second("corners", &["keep", "smooth"])? { CornerRule::Smooth } else { CornerRule::Keep },
        through: root.get("through")?.map_or(Ok(false), |node| node.flag())?,
        corner_indices,
        ends: if second("ends", &["trim", "join"])? { EndRule::Join } else { EndRule::Trim },
    })
}

/// Why no curve was fitted, with the path of what was given.
#[must_use]
pub fn fit_error(error: FitError) -> DocumentError {
    let (code, path) = match error {
        FitError::TooManyPoints { .. } | FitError::TooManyToMeet { .. } => (Code::Limit, "points".to_owned()),
        FitError::Point { index, point, .. } => {
            let code = if point.is_finite() { Code::Range } else { Code::NonFinite };
            (code, format!("points[{index}]"))
        }
        FitError::Tolerance { .. } => (Code::Range, "options.tolerance".to_owned()),
        FitError::OutOfReach { .. } => (Code::Limit, "options.tolerance".to_owned()),
        FitError::CornerIndex { position, .. } => (Code::Range, format!("options.cornerIndices[{position}]")),
        _ => (Code::Points, "points".to_owned()),
    };
    DocumentError::new(code, path, error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<FitOptions, DocumentError> {
        read_fit_options(&Json::parse(text).unwrap())
    }

    #[test]
    fn options_have_defaults_and_are_checked() {
        let plain = read(r#"{"tolerance": 0.5}"#).unwrap();
        let expected = FitOptions {
            tolerance: 0.5,
            corners: CornerRule::Keep,
            through: false,
            corner_indices: None,
            ends: EndRule::Trim,
        };
        assert_eq!(plain, expected);
        let all = r#"{"tolerance": 1, "corners": "smooth", "through": true, "cornerIndices": [3, 5], "ends": "join"}"#;
        let expected = FitOptions {
            tolerance: 1.0,
            corners: CornerRule::Smooth,
            through: true,
            corner_indices: Some(vec![3, 5]),
            ends: EndRule::Join,
        };
        assert_eq!(read(all).unwrap(), expected);
        for (text, code, path) in [
            ("{}", Code::Missing, "options.tolerance"),
            (r#"{"tolerance": "1"}"#, Code::Type, "options.tolerance"),
            (r#"{"tolerance": 1, "corners": "round"}"#, Code::Range, "options.corners"),
            (r#"{"tolerance": 1, "cornerIndices": [1.5]}"#, Code::Type, "options.cornerIndices[0]"),
            (r#"{"tolerance": 1, "closed": true}"#, Code::UnknownField, "options.closed"),
        ] {
            let error = read(text).unwrap_err();
            assert_eq!((error.code, error.path.as_str()), (code, path), "{text}");
        }
    }
}
