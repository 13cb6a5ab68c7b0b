//! A hyperpatch document with its body made, and what was found about it.

use super::super::HyperpatchModel;
use super::resurface::Surfaces;
use crate::hyperpatch::composite::{Body, CellId, Probe, Relation, Sharing};
use crate::hyperpatch::validity::Report;
use crate::hyperpatch::{Cell, Jacobian};
use crate::material::{Material, Oklab};
use std::cell::{OnceCell, RefCell};
use std::collections::HashMap;
use std::ops::Deref;
use std::rc::Rc;

/// Shared ownership of a body.
#[derive(Debug, Clone)]
pub struct Held(Rc<HyperpatchModel>);

impl Deref for Held {
    type Target = Body;

    fn deref(&self) -> &Body {
        self.0.body()
    }
}

/// A verdict with the shape that it is about, so that it is never taken for another one.
#[derive(Debug, Clone)]
pub(super) struct Judged {
    pub(super) cell: Cell,
    pub(super) report: Report,
    /// Whether every check ran to its end.
    pub(super) is_final: bool,
    /// Volume, once it was asked for.
    pub(super) volume: OnceCell<f64>,
    /// The least determinant that is found, once it was asked for.
    pub(super) least: OnceCell<f64>,
}

/// How every two cells lie to each other that are not disjoint.
pub(super) type Relations = Vec<([CellId; 2], Relation)>;

/// What was found about a body that was there before, to go on from.
#[derive(Debug)]
pub(super) struct Old<T> {
    pub(super) body: Held,
    pub(super) found: Rc<T>,
}

/// The cells whose shape a body has and another one has not.
#[derive(Debug, Default)]
pub(super) struct Difference {
    /// Cells that are new or of another shape.
    pub(super) changed: Vec<CellId>,
    /// Cells that are gone.
    pub(super) gone: Vec<CellId>,
}

/// A hyperpatch document with its body made, and what was found about it so far.
#[derive(Debug)]
pub struct KnownBody {
    model: Rc<HyperpatchModel>,
    colors: Vec<Oklab>,
    size: f64,
    pub(super) sharing: OnceCell<Rc<Sharing>>,
    pub(super) probe: OnceCell<Probe<Held>>,
    pub(super) relations: OnceCell<Rc<Relations>>,
    pub(super) judged: RefCell<HashMap<CellId, Judged>>,
    /// What cells of an earlier body shared, while it is not known of this one.
    pub(super) old_sharing: RefCell<Option<Old<Sharing>>>,
    /// How cells of an earlier body lay to each other, while it is not known of this one.
    pub(super) old_relations: RefCell<Option<Old<Relations>>>,
    /// The surfaces that were made last, of this body or of others.
    pub(super) surfaces: Rc<RefCell<Surfaces>>,
}

impl<T> Clone for Old<T> {
    fn clone(&self) -> Self {
        Self { body: self.body.clone(), found: Rc::clone(&self.found) }
    }
}

impl Difference {
    /// The difference of a body from an earlier one.
    pub(super) fn new(body: &Body, old: &Body) -> Self {
        let has = |body: &Body, id: &CellId, cell: &Cell| {
            body.cell(*id).is_some_and(|other| other.has_shape_of(cell))
        };
        let changed = body.cells().iter().filter(|(id, cell)| !has(old, id, cell)).map(|(id, _)| *id);
        let gone = old.cells().iter().filter(|(id, _)| body.cell(*id).is_none()).map(|(id, _)| *id);
        Self { changed: changed.collect(), gone: gone.collect() }
    }
}

impl KnownBody {
    /// A document about which nothing was asked yet. What is known of `before` is taken over for cells that have the same shape in it.
    #[must_use]
    pub fn new(model: HyperpatchModel, before: Option<&Self>) -> Self {
        let colors = model.materials().iter().map(|Material { color, .. }| color.to_oklab()).collect();
        let is_same = |(id, judged): &(&CellId, &Judged)| {
            model.body().cell(**id).is_some_and(|cell| cell.has_shape_of(&judged.cell))
        };
        let judged = before.map_or_else(HashMap::new, |before| {
            let old = before.judged.borrow();
            old.iter().filter(is_same).map(|(id, judged)| (*id, judged.clone())).collect()
        });
        let size = model.body().size();
        let old_sharing = before.and_then(|before| {
            let own = before.sharing.get().map(|found| Old { body: before.held(), found: Rc::clone(found) });
            own.or_else(|| before.old_sharing.borrow().clone())
        });
        let old_relations = before.and_then(|before| {
            let own =
                before.relations.get().map(|found| Old { body: before.held(), found: Rc::clone(found) });
            own.or_else(|| before.old_relations.borrow().clone())
        });
        Self {
            model: Rc::new(model),
            colors,
            size,
            sharing: OnceCell::new(),
            probe: OnceCell::new(),
            relations: OnceCell::new(),
            judged: RefCell::new(judged),
            old_sharing: RefCell::new(old_sharing),
            old_relations: RefCell::new(old_relations),
            surfaces: before.map_or_else(Rc::default, |before| Rc::clone(&before.surfaces)),
        }
    }

    /// The document with its body.
    #[must_use]
    pub fn model(&self) -> &HyperpatchModel {
        &self.model
    }

    /// The body, owned together with others.
    #[must_use]
    pub fn held(&self) -> Held {
        Held(Rc::clone(&self.model))
    }

    /// Colours of the materials.
    #[must_use]
    pub fn colors(&self) -> &[Oklab] {
        &self.colors
    }

    /// The least Jacobian determinant that is found for a cell on which there is a report: that of the certificate, or one of 5 x 5 x 5 places.
    /// Of a mirrored cell it is that of the reoriented one.
    #[must_use]
    pub fn least_determinant(&self, id: CellId, report: &Report) -> f64 {
        let judged = self.judged.borrow();
        let known = judged.get(&id).filter(|judged| judged.report == *report);
        known.map_or_else(
            || self.find_least(id, report),
            |judged| *judged.least.get_or_init(|| self.find_least(id, report)),
        )
    }

    fn find_least(&self, id: CellId, report: &Report) -> f64 {
        let Some(cell) = self.model.body().cell(id) else { return report.certificate.upper };
        let sign = if report.is_mirrored { -1.0 } else { 1.0 };
        let found = cell.net().jacobians(5).into_iter().map(|jacobian| sign * jacobian);
        found.fold(report.certificate.upper, f64::min)
    }

    /// Volume of a cell; negative where it is mirrored.
    pub(super) fn volume_of(&self, id: CellId, cell: &Cell) -> f64 {
        let volume = || Jacobian::new(cell.net()).volume();
        self.judged.borrow().get(&id).map_or_else(volume, |judged| *judged.volume.get_or_init(volume))
    }

    /// Length of the diagonal of the box of all control points; never zero.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.size
    }
}
