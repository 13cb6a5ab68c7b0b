//! What a distance transform is asked for.

use super::{Code, DocumentError, Json, Node};
use crate::field::transform::{DistanceJob, MOST_TRACED, Trace, TransformError, trace};
use crate::field::{Grid, GridError, MOST_VOXELS};

/// Longest spacing, and the reciprocal of the shortest: beyond, squares leave what numbers can hold.
const LARGEST_SPACING: f64 = 1e12;

/// The grid of a distance transform and how far distances matter; see `docs/api.md`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TransformOptions {
    /// The voxels.
    pub grid: Grid,
    /// Distances above it are infinite.
    pub limit: Option<f64>,
}

impl TransformOptions {
    /// Reads options: `size` of two or three numbers of voxels, `spacing` of as many lengths, 1 by default, and `limit`.
    ///
    /// # Errors
    /// When a field is unknown, missing, of the wrong type or out of range, with its path.
    pub fn read(options: &Json) -> Result<Self, DocumentError> {
        let root = Node::root(options, "");
        root.only(&["size", "spacing", "limit"])?;
        let size = root.need("size")?;
        let items = size.items()?;
        size.check_count(items.len(), " numbers", 2..=3)?;
        let mut counts = [1; 3];
        for (count, item) in counts.iter_mut().zip(&items) {
            *count = item.count_within(1..=MOST_VOXELS)?;
        }
        let mut steps = [1.0; 3];
        if let Some(spacing) = root.get("spacing")? {
            let lengths = spacing.items()?;
            spacing.check_count(lengths.len(), " numbers", items.len()..=items.len())?;
            for (step, item) in steps.iter_mut().zip(&lengths) {
                *step = item.within(LARGEST_SPACING.recip()..=LARGEST_SPACING)?;
            }
        }
        let limit = match root.get("limit")? {
            Some(node) => Some(node.within(0.0..=f64::MAX)?),
            None => None,
        };
        let grid = Grid::new(counts, steps).map_err(|error| match error {
            GridError::Spacing { axis, .. } => {
                DocumentError::new(Code::Range, format!("spacing[{axis}]"), error.to_string())
            }
            _ => size.error(Code::Limit, error.to_string()),
        })?;
        Ok(Self { grid, limit })
    }

    /// Starts the transform of features, a number for each voxel, 0 for none.
    ///
    /// # Errors
    /// When there is another number of them than of voxels.
    pub fn start(&self, features: &[u8]) -> Result<DistanceJob, DocumentError> {
        DistanceJob::new(&self.grid, features, self.limit).map_err(|error| {
            let path = if matches!(error, TransformError::Limit { .. }) { "limit" } else { "features" };
            DocumentError::new(Code::Range, path.to_owned(), error.to_string())
        })
    }

    /// Follows the transform of features in the plane, in pixels.
    ///
    /// # Errors
    /// When there are several layers, more than [`MOST_TRACED`] pixels, unequal spacings, a limit, or another number of features than of pixels.
    pub fn trace(&self, features: &[u8]) -> Result<Trace, DocumentError> {
        let refuse =
            |code: Code, path: &str, message: String| Err(DocumentError::new(code, path.to_owned(), message));
        let count = self.grid.count();
        if self.grid.size()[2] > 1 {
            return refuse(
                Code::Range,
                "size",
                "expected one layer, which is what can be watched".to_owned(),
            );
        }
        if count > MOST_TRACED {
            return refuse(Code::Limit, "size", format!("{count} pixels; expected {MOST_TRACED} at most"));
        }
        if self.grid.common_spacing().is_none() {
            return refuse(Code::Range, "spacing", "expected the same along both axes".to_owned());
        }
        if let Some(limit) = self.limit {
            return refuse(Code::Range, "limit", format!("{limit} was found; expected none"));
        }
        if features.len() != count {
            let error = TransformError::Length { found: features.len(), expected: count };
            return refuse(Code::Range, "features", error.to_string());
        }
        Ok(trace(&self.grid, features))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::{Value, json};

    fn read(value: Value) -> Result<TransformOptions, DocumentError> {
        TransformOptions::read(&Json::from(value))
    }

    #[test]
    fn a_plane_is_a_grid_of_one_layer() {
        let options = read(json!({"size": [4, 3], "spacing": [0.5, 0.25], "limit": 2})).unwrap();
        assert_eq!((options.grid.size(), options.grid.spacing()), ([4, 3, 1], [0.5, 0.25, 1.0]));
        assert_eq!(options.limit, Some(2.0));
        assert_eq!(read(json!({"size": [4, 3, 2]})).unwrap().limit, None);
    }

    #[test]
    fn wrong_options_are_refused_with_their_path() {
        let refused = |value: Value| {
            let error = read(value).unwrap_err();
            (error.code, error.path)
        };
        assert_eq!(refused(json!({})), (Code::Missing, "size".into()));
        assert_eq!(refused(json!({"size": [4]})), (Code::Range, "size".into()));
        assert_eq!(refused(json!({"size": [4, 0]})), (Code::Range, "size[1]".into()));
        assert_eq!(refused(json!({"size": [4, 1.5]})), (Code::Type, "size[1]".into()));
        assert_eq!(refused(json!({"size": [100_000, 100_000]})), (Code::Limit, "size".into()));
        assert_eq!(refused(json!({"size": [4, 4], "spacing": [1, 1, 1]})), (Code::Limit, "spacing".into()));
        assert_eq!(refused(json!({"size": [4, 4], "spacing": [1, 0]})), (Code::Range, "spacing[1]".into()));
        assert_eq!(refused(json!({"size": [4, 4], "limit": -1})), (Code::Range, "limit".into()));
        assert_eq!(refused(json!({"size": [4, 4], "depth": 1})), (Code::UnknownField, "depth".into()));
        let error = read(json!({"size": [4, 4]})).unwrap().start(&[0; 15]).unwrap_err();
        assert_eq!((error.code, error.path.as_str()), (Code::Range, "features"));
    }

    #[test]
    fn only_a_small_plane_of_square_pixels_can_be_watched() {
        let refused = |value: Value, count: usize| {
            let error = read(value).unwrap().trace(&vec![0; count]).unwrap_err();
            (error.code, error.path)
        };
        assert_eq!(refused(json!({"size": [4, 4, 2]}), 32), (Code::Range, "size".into()));
        assert_eq!(refused(json!({"size": [129, 128]}), 129 * 128), (Code::Limit, "size".into()));
        assert_eq!(refused(json!({"size": [4, 4], "spacing": [1, 2]}), 16), (Code::Range, "spacing".into()));
        assert_eq!(refused(json!({"size": [4, 4], "limit": 2}), 16), (Code::Range, "limit".into()));
        assert_eq!(refused(json!({"size": [4, 4]}), 15), (Code::Range, "features".into()));
        assert_eq!(
            read(json!({"size": [128, 128]})).unwrap().trace(&[0; 1 << 14]).unwrap().columns.len(),
            128
        );
    }
}
