//! Bodies and the part that they make.

use super::{Blend, Reference, Shape};
use crate::field::{Expression, Overlap};
use crate::geom::Bounds;
use glam::DVec2;

/// A piece of the plane: what lies inside a closed shape and in none of its holes.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    outline: Shape,
    holes: Vec<Shape>,
    bounds: Bounds,
}

impl Region {
    /// `None` when the outline or a hole is not closed, or the outline has no width or no height.
    #[must_use]
    pub fn new(outline: Shape, holes: Vec<Shape>) -> Option<Self> {
        let bounds = outline.bounds().filter(|bounds| (bounds.max - bounds.min).min_element() > 0.0)?;
        let is_closed = outline.is_closed() && holes.iter().all(Shape::is_closed);
        is_closed.then_some(Self { outline, holes, bounds })
    }

    /// Whether a point lies in the region.
    #[must_use]
    pub fn contains(&self, point: DVec2) -> bool {
        self.outline.contains(point) && !self.holes.iter().any(|hole| hole.contains(point))
    }

    /// The outline and the holes.
    pub fn rings(&self) -> impl Iterator<Item = &Shape> {
        std::iter::once(&self.outline).chain(&self.holes)
    }

    /// The box of the outline.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Says of the points at `start + k step` of a height, for each k, whether they lie in the region.
    pub(super) fn row(
        &self,
        height: f64,
        start: f64,
        step: f64,
        mut inside: impl FnMut(usize),
        count: usize,
    ) {
        let mut list = Vec::new();
        let mut marks = vec![false; count];
        for (number, ring) in self.rings().enumerate() {
            list.clear();
            ring.crossings(height, &mut list);
            list.sort_unstable_by(f64::total_cmp);
            // Points lie between a crossing and the next one.
            for pair in list.chunks_exact(2) {
                let first = |x: f64| (((x - start) / step).ceil().max(0.0) as usize).min(count);
                marks[first(pair[0])..first(pair[1]).max(first(pair[0]))].fill(number == 0);
            }
        }
        (0..count).filter(|k| marks[*k]).for_each(&mut inside);
    }
}

/// How the profiles of a body compose.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Composing {
    /// By the rule of the [`Overlap`].
    #[default]
    Overlap,
    /// By Eq. 2 as printed, on the grid of a raster.
    Printed,
}

/// What the profile of a feature is a function of: the distance to a reference, or a function of several distances.
#[derive(Debug, Clone, PartialEq)]
pub struct Feature {
    references: Vec<Reference>,
    distance: Option<Expression>,
}

impl Feature {
    /// Distances to one reference.
    #[must_use]
    pub fn new(reference: Reference) -> Self {
        Self { references: vec![reference], distance: None }
    }

    /// An expression in the distances to several references, in their order.
    #[must_use]
    pub fn of_several(references: Vec<Reference>, distance: Expression) -> Self {
        Self { references, distance: Some(distance) }
    }

    /// The references.
    #[must_use]
    pub fn references(&self) -> &[Reference] {
        &self.references
    }

    /// What the profile is a function of: 0 or more, infinite where an expression has no value.
    #[must_use]
    pub fn distance(&self, point: DVec2) -> f64 {
        let distances: Vec<f64> = self.references.iter().map(|reference| reference.distance(point)).collect();
        self.combine(&distances)
    }

    /// The distance from those to the references.
    pub(super) fn combine(&self, distances: &[f64]) -> f64 {
        let value = match (&self.distance, distances) {
            (Some(expression), _) => expression.value(distances),
            (None, [distance, ..]) => *distance,
            (None, []) => f64::INFINITY,
        };
        if value.is_nan() { f64::INFINITY } else { value.max(0.0) }
    }

    /// Whether what the profile is a function of is the distance to one reference.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        self.single().is_some()
    }

    /// Whether distances are those to one reference, so that they change by no more than the way.
    pub(super) fn single(&self) -> Option<&Reference> {
        self.references.first().filter(|_| self.distance.is_none())
    }
}

/// A region with features, and how their profiles compose.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// Where the body is.
    pub region: Region,
    /// How its profiles compose.
    pub composing: Composing,
    /// The profiles, in the order of the features.
    pub overlap: Overlap,
    /// What stands in for the default composition, where it is not constant. Not by Eq. 2 as printed.
    pub blend: Option<Blend>,
    /// The features of the profiles.
    pub features: Vec<Feature>,
    /// The bit of each feature in a leaf, ascending.
    pub slots: Vec<u32>,
}

impl Body {
    /// The leaf with the bits of the features as the document numbers them.
    pub(super) fn leaf(&self, leaf: u32) -> u32 {
        let bit = |(k, slot): (usize, &u32)| ((leaf >> k) & 1) << slot;
        self.slots.iter().enumerate().map(bit).fold(0, |all, bit| all | bit)
    }

    /// The composition at a point of the body. By Eq. 2 as printed a point alone has none.
    #[must_use]
    pub fn place(&self, point: DVec2) -> Place {
        let distances: Vec<f64> = self.features.iter().map(|feature| feature.distance(point)).collect();
        let mut fractions = vec![0.0; self.overlap.default_composition().fractions().len()];
        let leaf = match &self.blend {
            None => self.overlap.fractions(&distances, &mut fractions),
            Some(blend) => {
                let mut base = fractions.clone();
                blend.fractions(point, &mut base);
                self.overlap.over(&base, &distances, &mut fractions)
            }
        };
        let fractions = (self.composing == Composing::Overlap).then_some(fractions);
        Place { body: 0, fractions, leaf: self.leaf(leaf), distances }
    }
}

/// What a part holds at a point.
#[derive(Debug, Clone, PartialEq)]
pub struct Place {
    /// Index of the body.
    pub body: usize,
    /// Fraction of each material; `None` by Eq. 2 as printed.
    pub fractions: Option<Vec<f64>>,
    /// Which features hold the point, by bits.
    pub leaf: u32,
    /// What each profile is a function of.
    pub distances: Vec<f64>,
}

/// Bodies, of which a later one lies over an earlier one.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Number of materials.
    pub materials: usize,
    /// The bodies; `None` where one could not be made.
    pub bodies: Vec<Option<Body>>,
}

impl Part {
    /// The box of all bodies; `None` without one.
    #[must_use]
    pub fn bounds(&self) -> Option<Bounds> {
        self.bodies.iter().flatten().map(|body| body.region.bounds()).reduce(Bounds::union)
    }

    /// What is at a point; `None` outside all bodies.
    #[must_use]
    pub fn place(&self, point: DVec2) -> Option<Place> {
        let holds = |body: &Option<Body>| body.as_ref().is_some_and(|body| body.region.contains(point));
        let index = self.bodies.iter().rposition(holds)?;
        let place = self.bodies[index].as_ref()?.place(point);
        Some(Place { body: index, ..place })
    }
}
