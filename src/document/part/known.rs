//! Parts that are remembered by the text of their documents.

use super::blends::BlendsJob;
use super::{PartDiagnostic, PartModel};
use crate::material::Oklab;
use crate::part::{BlendMemory, Frame, Palette, Part, Raster};
use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;

/// Parts that are kept.
const KEPT: usize = 4;
/// Most pixels of a raster that is kept.
const MOST_KEPT: usize = 1 << 20;

/// A part document with its part made, its blends, and the raster that was asked for last.
#[derive(Debug)]
pub struct KnownPart {
    model: PartModel,
    palette: Palette,
    raster: RefCell<Option<Rc<Raster>>>,
    blends: RefCell<Blends>,
    /// Blends of other documents too.
    solved: Rc<RefCell<BlendMemory>>,
}

/// The blends of a part.
#[derive(Debug)]
enum Blends {
    UnderWay(Box<BlendsJob>),
    /// The part with them, and what was found.
    Solved(Rc<Part>, Vec<PartDiagnostic>),
}

impl KnownPart {
    /// A part about which nothing was asked yet.
    #[must_use]
    pub fn new(model: PartModel) -> Self {
        Self::remembering(model, Rc::default())
    }

    /// The same with blends that are known already.
    fn remembering(model: PartModel, solved: Rc<RefCell<BlendMemory>>) -> Self {
        let colors: Vec<Oklab> = model.materials().iter().map(|material| material.color.to_oklab()).collect();
        let blends = if model.blends().is_empty() {
            Blends::Solved(Rc::clone(model.part()), Vec::new())
        } else {
            Blends::UnderWay(Box::new(BlendsJob::new(&model)))
        };
        Self {
            palette: Palette::new(&colors),
            raster: RefCell::new(None),
            blends: RefCell::new(blends),
            solved,
            model,
        }
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

    /// The part, with its blends once they are solved.
    #[must_use]
    pub fn part(&self) -> Rc<Part> {
        match &*self.blends.borrow() {
            Blends::UnderWay(_) => Rc::clone(self.model.part()),
            Blends::Solved(part, _) => Rc::clone(part),
        }
    }

    /// Faults and remarks, those of the blends last, once these are solved.
    #[must_use]
    pub fn diagnostics(&self) -> Vec<PartDiagnostic> {
        let of_blends = match &*self.blends.borrow() {
            Blends::UnderWay(_) => Vec::new(),
            Blends::Solved(_, diagnostics) => diagnostics.clone(),
        };
        self.model.diagnostics().iter().cloned().chain(of_blends).collect()
    }

    /// Share of the blends that is solved; 1 when all are, and where there are none.
    pub(super) fn blended(&self) -> f64 {
        match &*self.blends.borrow() {
            Blends::UnderWay(job) => job.progress(),
            Blends::Solved(..) => 1.0,
        }
    }

    /// Goes on with the blends while `may_go_on` says so, at least by a little.
    pub(super) fn blend(&self, may_go_on: &mut dyn FnMut() -> bool) {
        let mut blends = self.blends.borrow_mut();
        let Blends::UnderWay(job) = &mut *blends else { return };
        if job.step(&mut self.solved.borrow_mut(), may_go_on) {
            let nothing = Blends::Solved(Rc::clone(self.model.part()), Vec::new());
            if let Blends::UnderWay(job) = std::mem::replace(&mut *blends, nothing) {
                let (part, diagnostics) = job.finish();
                *blends = Blends::Solved(part, diagnostics);
            }
        }
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
    blends: Rc<RefCell<BlendMemory>>,
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
        let part = Rc::new(KnownPart::remembering(model, Rc::clone(&self.blends)));
        self.parts.push_front((text.to_owned(), Rc::clone(&part)));
        self.parts.truncate(KEPT);
        part
    }
}
