//! Bodies that are remembered by their documents, and operations that were read.

use super::super::{HyperpatchModel, Operation};
use super::KnownBody;
use std::collections::{HashMap, HashSet, VecDeque};
use std::rc::Rc;
use std::sync::Arc;

/// Bodies that are kept.
const KEPT: usize = 4;

/// What tells one document from another: the text of all but its operations, and a key for each of these.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct DocumentKey {
    /// The text.
    pub head: String,
    /// The keys; whoever gives them gives the same one only for the same operation.
    pub operations: Vec<u32>,
}

/// The bodies that were used last; all but 4 are forgotten, and so are operations that none of them has.
#[derive(Debug, Default)]
pub struct BodyMemory {
    /// The one used last comes first.
    bodies: VecDeque<(DocumentKey, Rc<KnownBody>)>,
    operations: HashMap<u32, Arc<Operation>>,
}

impl BodyMemory {
    /// The body of a document if it is known.
    #[must_use]
    pub fn find(&mut self, key: &DocumentKey) -> Option<Rc<KnownBody>> {
        let found = self.bodies.iter().position(|(known, _)| known == key)?;
        let entry = self.bodies.remove(found)?;
        let body = Rc::clone(&entry.1);
        self.bodies.push_front(entry);
        Some(body)
    }

    /// An operation by its key if it is known.
    #[must_use]
    pub fn operation(&self, key: u32) -> Option<Arc<Operation>> {
        self.operations.get(&key).cloned()
    }

    /// The models of the bodies, the one used last first.
    pub fn models(&self) -> impl Iterator<Item = &HyperpatchModel> {
        self.bodies.iter().map(|(_, body)| body.model())
    }

    /// Remembers a body, and its operations.
    pub fn keep(&mut self, key: DocumentKey, model: HyperpatchModel) -> Rc<KnownBody> {
        let list = model.document().operations.iter().map(|(_, operation)| Arc::clone(operation));
        self.operations.extend(key.operations.iter().copied().zip(list));
        let body = Rc::new(KnownBody::new(model, self.bodies.front().map(|(_, body)| body.as_ref())));
        self.bodies.push_front((key, Rc::clone(&body)));
        if self.bodies.len() > KEPT {
            self.bodies.truncate(KEPT);
            let used: HashSet<u32> =
                self.bodies.iter().flat_map(|(key, _)| &key.operations).copied().collect();
            self.operations.retain(|key, _| used.contains(key));
        }
        body
    }
}
