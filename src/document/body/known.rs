//! A hyperpatch document with its body made, and what was found about it.

use super::super::HyperpatchModel;
use crate::hyperpatch::Net;
use crate::hyperpatch::composite::{Body, CellId, Probe, Relation, Sharing};
use crate::hyperpatch::validity::Report;
use crate::material::{Material, Oklab};
use glam::DVec3;
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
    pub(super) net: Net,
    pub(super) report: Report,
    /// Whether every check ran to its end.
    pub(super) is_final: bool,
}

/// A hyperpatch document with its body made, and what was found about it so far.
#[derive(Debug)]
pub struct KnownBody {
    model: Rc<HyperpatchModel>,
    colors: Vec<Oklab>,
    size: f64,
    pub(super) sharing: OnceCell<Rc<Sharing>>,
    pub(super) probe: OnceCell<Probe<Held>>,
    pub(super) relations: OnceCell<Vec<([CellId; 2], Relation)>>,
    pub(super) judged: RefCell<HashMap<CellId, Judged>>,
}

impl KnownBody {
    /// A document about which nothing was asked yet. Verdicts on cells that `before` has with the same shape are taken over.
    #[must_use]
    pub fn new(model: HyperpatchModel, before: Option<&Self>) -> Self {
        let colors = model.materials().iter().map(|Material { color, .. }| color.to_oklab()).collect();
        let is_same = |(id, judged): &(&CellId, &Judged)| {
            model.body().cell(**id).is_some_and(|cell| *cell.net() == judged.net)
        };
        let judged = before.map_or_else(HashMap::new, |before| {
            let old = before.judged.borrow();
            old.iter().filter(is_same).map(|(id, judged)| (*id, judged.clone())).collect()
        });
        let bounds = model.body().cells().iter().map(|(_, cell)| cell.net().bounds());
        let (lo, hi) =
            bounds.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(lo, hi), (a, b)| (lo.min(a), hi.max(b)));
        let size = Some(lo.distance(hi)).filter(|size| size.is_finite() && *size > 0.0).unwrap_or(1.0);
        Self {
            model: Rc::new(model),
            colors,
            size,
            sharing: OnceCell::new(),
            probe: OnceCell::new(),
            relations: OnceCell::new(),
            judged: RefCell::new(judged),
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
        let Some(cell) = self.model.body().cell(id) else { return report.certificate.upper };
        let sign = if report.is_mirrored { -1.0 } else { 1.0 };
        let place = |n: usize| DVec3::new((n / 25) as f64, (n / 5 % 5) as f64, (n % 5) as f64) / 4.0;
        (0..125).map(|n| sign * cell.net().jacobian(place(n))).fold(report.certificate.upper, f64::min)
    }

    /// Length of the diagonal of the box of all control points; never zero.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.size
    }
}
