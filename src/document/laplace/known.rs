//! Boundaries that are remembered by the text of their documents.

use super::BoundaryProblem;
use std::collections::VecDeque;
use std::rc::Rc;

/// Boundaries that are kept.
const KEPT: usize = 4;

/// The boundaries that were used last; all but 4 are forgotten.
#[derive(Debug, Default)]
pub struct BoundaryMemory {
    /// The one used last comes first.
    known: VecDeque<(String, Rc<BoundaryProblem>)>,
}

impl BoundaryMemory {
    /// The boundary of a document if it is known.
    #[must_use]
    pub fn find(&mut self, text: &str) -> Option<Rc<BoundaryProblem>> {
        let found = self.known.iter().position(|(known, _)| known == text)?;
        let entry = self.known.remove(found)?;
        let boundary = Rc::clone(&entry.1);
        self.known.push_front(entry);
        Some(boundary)
    }

    /// Remembers a boundary.
    pub fn keep(&mut self, text: &str, boundary: BoundaryProblem) -> Rc<BoundaryProblem> {
        let boundary = Rc::new(boundary);
        self.known.push_front((text.to_owned(), Rc::clone(&boundary)));
        self.known.truncate(KEPT);
        boundary
    }
}
