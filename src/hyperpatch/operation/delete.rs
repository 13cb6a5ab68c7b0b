//! Taking cells out.

use super::draft::chosen;
use super::{Change, OperationError};
use crate::hyperpatch::composite::{Body, CellId};

/// Takes cells out of a body, with what is marked at them.
///
/// # Errors
/// When no cell is named, or one is unknown; none is taken out then.
pub fn delete(body: &mut Body, cells: &[CellId]) -> Result<Change, OperationError> {
    let removed = chosen(body, cells)?;
    body.remove_all(&removed);
    Ok(Change { removed, ..Change::default() })
}

#[cfg(test)]
mod tests {
    use super::super::test_bodies::block;
    use super::*;
    use crate::hyperpatch::composite::{BodyError, Sharing};

    #[test]
    fn deleted_cells_are_gone_and_the_others_as_they_were() {
        let mut body = block([3, 1, 1]);
        let change = delete(&mut body, &[2, 0, 2].map(CellId)).unwrap();
        assert_eq!(change.removed, [0, 2].map(CellId));
        assert_eq!(body.cells(), &block([3, 1, 1]).cells()[1..2]);
        assert_eq!(body.boxes(), &block([3, 1, 1]).boxes()[1..2]);
        assert!(Sharing::new(&body).shared_faces().is_empty());
        let unknown = OperationError::Body(BodyError::Unknown { id: CellId(7) });
        assert_eq!(delete(&mut body, &[1, 7].map(CellId)), Err(unknown));
        assert_eq!(delete(&mut body, &[]), Err(OperationError::NoCells));
        assert_eq!(body.cells().len(), 1);
    }
}
