//! Hyperpatch documents whose operations come one by one, read in steps.

use super::json::parse;
use crate::document::{
    BodyMemory, Code, DocumentError, DocumentKey, HyperpatchDocument, HyperpatchHead, Operation,
    OperationReading, check_cells, check_length, check_operations, read_hyperpatch,
};
use js_sys::Array;
use std::collections::VecDeque;
use std::sync::Arc;

/// A document on the way in.
pub(super) struct Reading {
    text: String,
    is_apart: bool,
    head: Option<HyperpatchHead>,
    /// The operations in their order; those that are missing or still to be read are empty.
    operations: Vec<Option<Arc<Operation>>>,
    texts: VecDeque<Text>,
    /// Number of operations that were supplied.
    count: usize,
    /// The operation whose cells are being read, and how many of them are.
    work: Option<(Text, OperationReading, u32)>,
}

/// The text of an operation.
struct Text {
    place: usize,
    text: String,
    /// Texts of its cells, and how many there are.
    cells: Option<(Array, usize)>,
}

impl Reading {
    pub(super) fn new(memory: &BodyMemory, key: &DocumentKey, is_apart: bool) -> Self {
        let operations = key.operations.iter().map(|key| memory.operation(*key)).collect();
        let (text, texts) = (key.head.clone(), VecDeque::new());
        Self { text, is_apart, head: None, operations, texts, count: 0, work: None }
    }

    pub(super) fn missing(&self) -> Vec<u32> {
        if check_operations(self.operations.len()).is_err() {
            return Vec::new();
        }
        (0_u32..).zip(&self.operations).filter(|(_, known)| known.is_none()).map(|(place, _)| place).collect()
    }

    pub(super) fn supply(&mut self, place: usize, text: &str, cells: Option<Array>, count: usize) {
        self.count += 1;
        self.texts.push_back(Text { place, text: text.to_owned(), cells: cells.map(|cells| (cells, count)) });
    }

    /// Share of the work that is done, from 0 to 1.
    pub(super) fn progress(&self) -> f64 {
        let part = self.work.as_ref().map_or(0.0, |(text, _, done)| {
            let count = text.cells.as_ref().map_or(1, |(_, count)| (*count).max(1));
            f64::from(*done) / count as f64
        });
        let left = self.texts.len() + usize::from(self.work.is_some());
        ((self.count - left.min(self.count)) as f64 + part) / self.count.max(1) as f64
    }

    /// Advances while `may_go_on` says so, at least by a little; returns the document when all is read.
    pub(super) fn step(
        &mut self,
        may_go_on: &mut dyn FnMut() -> bool,
    ) -> Result<Option<HyperpatchDocument>, DocumentError> {
        if !self.is_apart {
            check_length(&self.text)?;
            return read_hyperpatch(&parse(&self.text)?).map(Some);
        }
        loop {
            let Some(head) = &self.head else {
                self.begin()?;
                continue;
            };
            let materials = head.materials.len();
            if let Some((text, reading, done)) = &mut self.work {
                let cells = text.cells.as_ref().filter(|(cells, _)| *done < cells.length());
                if let Some((cells, _)) = cells {
                    reading.add(&parse(&cells.get(*done).as_string().unwrap_or_default())?)?;
                    *done += 1;
                } else if let Some((text, reading, _)) = self.work.take() {
                    self.operations[text.place] = Some(Arc::new(reading.finish()));
                }
            } else if let Some(text) = self.texts.pop_front() {
                check_length(&text.text)?;
                let reading =
                    OperationReading::new(&parse(&text.text)?, text.place, materials, text.cells.is_some())?;
                self.work = Some((text, reading, 0));
            } else {
                return self.finish(materials).map(Some);
            }
            if !may_go_on() {
                return Ok(None);
            }
        }
    }

    /// Reads the head, and counts.
    fn begin(&mut self) -> Result<(), DocumentError> {
        check_length(&self.text)?;
        let head = HyperpatchHead::read(&parse(&self.text)?)?;
        check_operations(self.operations.len())?;
        let known =
            |operation: &Option<Arc<Operation>>| operation.as_ref().map_or(0, |it| it.action.written());
        let mut counts: Vec<usize> = self.operations.iter().map(known).collect();
        for Text { place, cells, .. } in &self.texts {
            if let (Some(count), Some((_, found))) = (counts.get_mut(*place), cells) {
                *count = *found;
            }
        }
        check_cells(counts)?;
        self.texts.retain(|text| text.place < self.operations.len());
        self.head = Some(head);
        Ok(())
    }

    fn finish(&mut self, materials: usize) -> Result<HyperpatchDocument, DocumentError> {
        let mut operations = Vec::with_capacity(self.operations.len());
        for (place, operation) in self.operations.iter().enumerate() {
            let found = operation.as_ref().filter(|operation| operation.materials == materials);
            operations.push(Arc::clone(found.ok_or_else(|| {
                let message = "the operation is not known; expected it to be supplied".to_owned();
                DocumentError::new(Code::Missing, format!("operations[{place}]"), message)
            })?));
        }
        match self.head.take() {
            Some(head) => HyperpatchDocument::new(head, operations),
            None => Err(DocumentError::new(Code::Missing, "", "the document was read already".to_owned())),
        }
    }
}
