//! Parts that are remembered by the text of their documents.

use super::PartModel;
use crate::material::Oklab;
use crate::part::{Frame, Palette, Raster};
use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;

/// Parts that are kept.
const KEPT: usize = 4;
/// Most pixels of a raster that is kept.
const MOST_KEPT: usize = 1 << 20;

/// A part document with its part made, and the raster that was asked for last.
#[derive(Debug)]
pub struct KnownPart {
    model: PartModel,
    palette: Palette,
    raster: RefCell<Option<Rc<Raster>>>,
}

impl KnownPart {
    /// A part about which nothing was asked yet.
    #[must_use]
    pub fn new(model: PartModel) -> Self {
        let colors: Vec<Oklab> = model.materials().iter().map(|material| material.color.to_oklab()).collect();
        Self { palette: Palette::new(&colors), raster: RefCell::new(None), model }
    }

    /// The document with its part.
    #[must_use]
    pub fn model(&self) -> &PartModel {
        &self.model
    }

    /// The colours of the materials.
    #[must_use]
    pub fn palette(&self) -> &Palette {
        &self.palette
    }

    /// The raster of a frame if it is known.
    #[must_use]
    pub(super) fn raster(&self, frame: &Frame) -> Option<Rc<Raster>> {
        self.raster.borrow().clone().filter(|raster| raster.frame == *frame)
    }

    /// Remembers a raster that is not too large.
    pub(super) fn keep(&self, raster: Raster) -> Rc<Raster> {
        let raster = Rc::new(raster);
        let kept = (raster.frame.count() <= MOST_KEPT).then(|| Rc::clone(&raster));
        *self.raster.borrow_mut() = kept;
        raster
    }
}

/// The parts that were used last; all but 4 are forgotten.
#[derive(Debug, Default)]
pub struct PartMemory {
    /// The one used last comes first.
    parts: VecDeque<(String, Rc<KnownPart>)>,
}

impl PartMemory {
    /// The part of a document if it is known.
    #[must_use]
    pub fn find(&mut self, text: &str) -> Option<Rc<KnownPart>> {
        let found = self.parts.iter().position(|(known, _)| known == text)?;
        let entry = self.parts.remove(found)?;
        let part = Rc::clone(&entry.1);
        self.parts.push_front(entry);
        Some(part)
    }

    /// Remembers a part.
    pub fn keep(&mut self, text: &str, model: PartModel) -> Rc<KnownPart> {
        let part = Rc::new(KnownPart::new(model));
        self.parts.push_front((text.to_owned(), Rc::clone(&part)));
        self.parts.truncate(KEPT);
        part
    }
}
