//! The part that a document makes.

use super::super::model::materials as build_materials;
use super::super::{CurveForm, DocumentError};
use super::diagnostic::PartDiagnostic;
use super::plan::PlannedBlend;
use super::schema::{
    BodySpec, ComposingRule, CourseSpec, FeatureSpec, Geometry, PartDocument, ReferenceSpec, RuleQuantity,
    ShapeSpec,
};
use crate::curve::{BSpline, Form};
use crate::field::{
    Course, DesignRule, DistanceProfile, Expression, ExpressionError, MOST_PRINTED, Overlap, ProfileError,
    Quantity, Rule,
};
use crate::geom::{first_self_contact, segment_crossing, signed_area};
use crate::material::{Composition, Material};
use crate::part::{Body, Composing, Feature, Frame, Part, Path, RasterJob, Reference, Region, Shape};
use glam::DVec2;
use std::cell::OnceCell;
use std::rc::Rc;

/// Chord error of a path that follows a curve, over the size of the curve.
const CHORD: f64 = 2e-5;
/// Share of the area of its box below which a polygon has none.
const NO_AREA: f64 = 1e-12;
/// Pixels along the side of the raster that tells whether holes leave anything of a body.
const LOOK: usize = 64;

/// A part document with its part made, and what is to be said about it. What has a fault is skipped, and the rest works.
#[derive(Debug, Clone)]
pub struct PartModel {
    document: PartDocument,
    materials: Vec<Material>,
    part: Rc<Part>,
    blends: Vec<PlannedBlend>,
    rules: Vec<Option<DesignRule>>,
    diagnostics: Vec<PartDiagnostic>,
}

impl PartModel {
    /// Makes what can be made.
    ///
    /// # Errors
    /// When a colour is not valid, with the path of the field.
    pub fn new(document: PartDocument) -> Result<Self, DocumentError> {
        let materials = build_materials(&document.materials)?;
        let mut builder = Builder::new(&document);
        let (bodies, blends) = builder.bodies();
        let rules = builder.rules();
        let part = Rc::new(Part { materials: materials.len(), bodies });
        Ok(Self { materials, part, blends, rules, diagnostics: builder.diagnostics, document })
    }

    /// The document.
    #[must_use]
    pub fn document(&self) -> &PartDocument {
        &self.document
    }

    /// The materials.
    #[must_use]
    pub fn materials(&self) -> &[Material] {
        &self.materials
    }

    /// The blends that are still to be solved.
    pub(super) fn blends(&self) -> &[PlannedBlend] {
        &self.blends
    }

    /// The part without its blends, owned together with others.
    #[must_use]
    pub fn part(&self) -> &Rc<Part> {
        &self.part
    }

    /// The design rules; `None` where one has a fault.
    #[must_use]
    pub fn rules(&self) -> &[Option<DesignRule>] {
        &self.rules
    }

    /// Faults and remarks but for those that are found with the blends, in the order of the document.
    #[must_use]
    pub fn diagnostics(&self) -> &[PartDiagnostic] {
        &self.diagnostics
    }
}

pub(super) struct Builder<'a> {
    pub(super) document: &'a PartDocument,
    /// `None` where a shape could not be made.
    shapes: Vec<Option<Shape>>,
    /// Where shapes cross themselves, of those that were asked.
    crossings: Vec<OnceCell<Option<DVec2>>>,
    pub(super) diagnostics: Vec<PartDiagnostic>,
}

pub(super) type Made<T> = Result<T, PartDiagnostic>;

impl<'a> Builder<'a> {
    fn new(document: &'a PartDocument) -> Self {
        let crossings = vec![OnceCell::new(); document.shapes.len()];
        let mut builder = Self { document, shapes: Vec::new(), crossings, diagnostics: Vec::new() };
        for (number, spec) in document.shapes.iter().enumerate() {
            let shape = build_shape(spec, &format!("shapes[{number}]"));
            let shape = builder.kept(shape);
            builder.shapes.push(shape);
        }
        builder
    }

    /// What was made; a fault is noted.
    pub(super) fn kept<T>(&mut self, made: Made<T>) -> Option<T> {
        made.map_err(|fault| self.diagnostics.push(fault)).ok()
    }

    /// A shape by its name.
    pub(super) fn shape(&self, name: &str, path: &str) -> Made<(usize, &Shape)> {
        let Some(number) = self.document.shapes.iter().position(|shape| shape.name == name) else {
            let message = format!("there is no shape \"{name}\"");
            return Err(PartDiagnostic::new("unknown-name", path, message));
        };
        let made = self.shapes[number].as_ref().map(|shape| (number, shape));
        let fault = || format!("the shape \"{name}\" cannot be made, see shapes[{number}]");
        made.ok_or_else(|| PartDiagnostic::new("shape", path, fault()))
    }

    /// A shape that closes and does not cross itself.
    fn ring(&self, name: &str, path: &str) -> Made<Shape> {
        let (number, shape) = self.shape(name, path)?;
        if !shape.is_closed() {
            let message =
                format!("the shape \"{name}\" is open; expected a circle, a polygon or a closed curve");
            return Err(PartDiagnostic::new("open", path, message));
        }
        let geometry = &self.document.shapes[number].geometry;
        match self.crossings[number].get_or_init(|| crossing(geometry)) {
            None => Ok(shape.clone()),
            Some(at) => {
                let message = format!("the shape \"{name}\" crosses itself at ({}, {})", at.x, at.y);
                let fault = PartDiagnostic::new("self-intersection", path, message);
                Err(PartDiagnostic { at: Some(at.to_array()), ..fault })
            }
        }
    }

    fn region(&mut self, number: usize, spec: &BodySpec) -> Option<Region> {
        let path = format!("bodies[{number}].outline");
        let of_body = |fault: PartDiagnostic| PartDiagnostic { body: Some(number as u32), ..fault };
        let outline = self.ring(&spec.outline, &path).map_err(of_body);
        let outline = self.kept(outline)?;
        let mut holes = Vec::new();
        for (k, name) in spec.holes.iter().enumerate() {
            let hole = self.ring(name, &format!("bodies[{number}].holes[{k}]")).map_err(of_body);
            holes.extend(self.kept(hole));
        }
        let has_holes = !holes.is_empty();
        let has_area = match &outline {
            Shape::Closed(path) => {
                let points: Vec<DVec2> = path.ends().map(|(start, _)| start).collect();
                let extent = path.bounds().max - path.bounds().min;
                signed_area(&points).abs() > NO_AREA * extent.x * extent.y
            }
            _ => true,
        };
        let Some(region) = Region::new(outline, holes).filter(|_| has_area) else {
            let message = format!("the outline \"{}\" encloses no area", spec.outline);
            self.diagnostics.push(of_body(PartDiagnostic::new("empty", path, message)));
            return None;
        };
        if has_holes && is_empty(&region) {
            let message = "the holes leave nothing of the body: no place of a raster of 64 x 64 lies in it";
            let remark = PartDiagnostic::new("empty", format!("bodies[{number}].holes"), message).remark();
            self.diagnostics.push(of_body(remark));
        }
        Some(region)
    }

    fn bodies(&mut self) -> (Vec<Option<Body>>, Vec<PlannedBlend>) {
        let document = self.document;
        // Boundaries are geometry alone, so that a body may refer to any other one, and none waits for another.
        let regions: Vec<Option<Region>> =
            document.bodies.iter().enumerate().map(|(number, spec)| self.region(number, spec)).collect();
        let body = |(number, spec): (usize, &BodySpec)| {
            let region = regions[number].as_ref()?;
            self.body(number, spec, region, &regions)
        };
        let bodies = document.bodies.iter().enumerate().map(body).collect();
        (bodies, self.plans(&regions))
    }

    fn body(
        &mut self,
        number: usize,
        spec: &BodySpec,
        region: &Region,
        regions: &[Option<Region>],
    ) -> Option<Body> {
        let default = Composition::new(spec.default.clone()).ok()?;
        let (mut features, mut profiles, mut slots) = (Vec::new(), Vec::new(), Vec::new());
        for (k, feature) in spec.features.iter().enumerate().filter(|(_, feature)| !feature.hidden) {
            let path = format!("bodies[{number}].features[{k}]");
            let of_feature = |fault: PartDiagnostic| PartDiagnostic {
                body: Some(number as u32),
                feature: Some(k as u32),
                ..fault
            };
            if spec.rule == ComposingRule::Printed && features.len() == MOST_PRINTED {
                let message = format!("the printed rule takes {MOST_PRINTED} features at most");
                self.diagnostics.push(of_feature(PartDiagnostic::new("limit", path, message)));
                continue;
            }
            // Both are looked at, so that all that is wrong with a feature is said at once.
            let profile = build_profile(feature, &path).map_err(of_feature);
            let profile = self.kept(profile);
            let measured = self.feature(feature, &path, regions).map_err(of_feature);
            let measured = self.kept(measured);
            let Some((profile, measured)) = profile.zip(measured) else { continue };
            if is_far(&profile, &measured, region) {
                let message = "the band does not reach the body, so that the feature has no effect";
                self.diagnostics.push(of_feature(PartDiagnostic::new("far", path, message).remark()));
            }
            profiles.push(profile);
            features.push(measured);
            slots.push(k as u32);
        }
        let rule = if spec.rule == ComposingRule::Depth { Rule::Depth } else { Rule::Repaired };
        let composing = match spec.rule {
            ComposingRule::Printed => Composing::Printed,
            _ => Composing::Overlap,
        };
        let overlap = Overlap::new(rule, region.bounds().diagonal(), default, profiles);
        Some(Body { region: region.clone(), composing, overlap, blend: None, features, slots })
    }

    pub(super) fn feature(
        &self,
        spec: &FeatureSpec,
        path: &str,
        regions: &[Option<Region>],
    ) -> Made<Feature> {
        if let Some(reference) = &spec.reference {
            return self.reference(reference, &format!("{path}.reference"), regions).map(Feature::new);
        }
        let (mut names, mut references) = (Vec::new(), Vec::new());
        for (name, reference) in spec.references.iter().flatten() {
            references.push(self.reference(reference, &format!("{path}.references.{name}"), regions)?);
            names.push(name.as_str());
        }
        let text = spec.distance.as_deref().unwrap_or_default();
        let expression =
            Expression::new(text, &names).map_err(|error| unreadable(&error, format!("{path}.distance")))?;
        Ok(Feature::of_several(references, expression))
    }

    fn reference(&self, spec: &ReferenceSpec, path: &str, regions: &[Option<Region>]) -> Made<Reference> {
        let (boundary, except) = match spec {
            ReferenceSpec::Shape(name) => {
                return self.shape(name, path).map(|(_, shape)| Reference::shape(shape.clone()));
            }
            ReferenceSpec::Boundary { boundary, except } => (boundary, except),
        };
        let at = format!("{path}.boundary");
        let Some(number) = self.document.bodies.iter().position(|body| body.name == *boundary) else {
            let message = format!("there is no body \"{boundary}\"");
            return Err(PartDiagnostic::new("unknown-name", at, message));
        };
        let Some(region) = &regions[number] else {
            let message = format!("the body \"{boundary}\" cannot be made, see bodies[{number}]");
            return Err(PartDiagnostic::new("shape", at, message));
        };
        let mut without = Vec::new();
        for (k, name) in except.iter().enumerate() {
            without.push(self.shape(name, &format!("{path}.except[{k}]"))?.1.clone());
        }
        Reference::boundary(region, &without).ok_or_else(|| {
            let message = format!("nothing is left of the boundary of \"{boundary}\"");
            PartDiagnostic::new("empty", format!("{path}.except"), message)
        })
    }

    fn rules(&mut self) -> Vec<Option<DesignRule>> {
        let document = self.document;
        let rule = |(number, spec): (usize, &super::PartRuleSpec)| {
            if spec.least > spec.most {
                let message =
                    format!("most is {}; expected least, which is {}, or more", spec.most, spec.least);
                self.diagnostics.push(PartDiagnostic::new(
                    "limits",
                    format!("rules[{number}].most"),
                    message,
                ));
                return None;
            }
            let of = match spec.of {
                RuleQuantity::Fraction => Quantity::Fraction,
                RuleQuantity::Gradient => Quantity::Gradient,
            };
            Some(DesignRule { material: spec.material, of, least: spec.least, most: spec.most })
        };
        document.rules.iter().enumerate().map(rule).collect()
    }
}

fn build_shape(spec: &ShapeSpec, path: &str) -> Made<Shape> {
    let fault = |field: &str, message: &str| PartDiagnostic::new("shape", format!("{path}.{field}"), message);
    let points =
        |points: &[[f64; 2]]| -> Vec<DVec2> { points.iter().copied().map(DVec2::from_array).collect() };
    let chain = |list: &[[f64; 2]], least: usize, is_closed: bool| {
        let path = Path::through(&points(list), is_closed).filter(|_| list.len() >= least);
        let message = format!("{} points were found; expected {least} or more", list.len());
        path.map(Rc::new).ok_or_else(|| fault("points", &message))
    };
    match &spec.geometry {
        Geometry::Point { at } => Ok(Shape::Point(DVec2::from_array(*at))),
        Geometry::Line { through, direction } => {
            let direction = DVec2::from_array(*direction).try_normalize();
            let direction =
                direction.ok_or_else(|| fault("direction", "it has no length; expected a direction"))?;
            Ok(Shape::Line { through: DVec2::from_array(*through), direction })
        }
        Geometry::Segment { from, to } => chain(&[*from, *to], 2, false).map(Shape::Open),
        Geometry::Circle { radius, .. } if *radius == 0.0 => {
            Err(fault("radius", "0 was found; expected a number above 0"))
        }
        Geometry::Circle { center, radius } => {
            Ok(Shape::Circle { center: DVec2::from_array(*center), radius: *radius })
        }
        Geometry::Polygon { points } => chain(points, 3, true).map(Shape::Closed),
        Geometry::Polyline { points } => chain(points, 2, false).map(Shape::Open),
        Geometry::Curve { degree, form, points: control, knots } => {
            let curve = build_curve(*degree, *form, points(control), knots.clone());
            let curve = curve.map_err(|error| fault("points", &error.to_string()))?;
            let vertices = curve.flatten(CHORD * curve.bounds().diagonal());
            let vertices: Vec<DVec2> = vertices.into_iter().map(|(_, point)| point).collect();
            let made = Path::through(&vertices, curve.is_closed()).map(Rc::new);
            let made = made.ok_or_else(|| fault("points", "the curve has no points"))?;
            Ok(if curve.is_closed() { Shape::Closed(made) } else { Shape::Open(made) })
        }
    }
}

fn build_curve(
    degree: usize,
    form: CurveForm,
    points: Vec<DVec2>,
    knots: Option<Vec<f64>>,
) -> Result<BSpline, crate::curve::CurveError> {
    let form = match form {
        CurveForm::Periodic => Form::Periodic,
        CurveForm::Clamped => Form::Clamped,
        CurveForm::Open => Form::Open,
    };
    BSpline::new(degree, form, points, knots)
}

/// A place where a closed shape crosses itself.
fn crossing(geometry: &Geometry) -> Option<DVec2> {
    match geometry {
        Geometry::Polygon { points } => {
            let mut points: Vec<DVec2> = points.iter().copied().map(DVec2::from_array).collect();
            // A point that is repeated is no crossing.
            points.dedup();
            if points.len() > 1 && points.first() == points.last() {
                points.pop();
            }
            if points.len() < 3 {
                return None;
            }
            let (i, k) = first_self_contact(&points, true)?;
            let next = |n: usize| points[(n + 1) % points.len()];
            let is_neighbour = (i + 1) % points.len() == k || (k + 1) % points.len() == i;
            let at = segment_crossing(points[i], next(i), points[k], next(k));
            Some(if is_neighbour || !at.is_finite() { points[k] } else { at })
        }
        Geometry::Curve { degree, form, points, knots } => {
            let points = points.iter().copied().map(DVec2::from_array).collect();
            let curve = build_curve(*degree, *form, points, knots.clone()).ok()?;
            curve.self_intersection().map(|meeting| meeting.at)
        }
        _ => None,
    }
}

pub(super) fn build_profile(spec: &FeatureSpec, path: &str) -> Made<DistanceProfile> {
    let composition = |mix: &[f64], field: &str| {
        let fault = |error: String| PartDiagnostic::new("course", format!("{path}.{field}"), error);
        Composition::new(mix.to_vec()).map_err(|error| fault(error.to_string()))
    };
    let mixes = [composition(&spec.start, "start")?, composition(&spec.end, "end")?];
    let course = match &spec.course {
        CourseSpec::Linear => Course::Linear,
        CourseSpec::Power { power } => Course::Power(*power),
        CourseSpec::Exponential { rate } => Course::Exponential(*rate),
        CourseSpec::Smoothstep => Course::Smoothstep,
        CourseSpec::Periodic { waves } => Course::Periodic(*waves),
        CourseSpec::Piecewise { keys } => {
            let mut built = Vec::with_capacity(keys.len());
            for (k, key) in keys.iter().enumerate() {
                built.push((key.at, composition(&key.mix, &format!("course.keys[{k}].mix"))?));
            }
            Course::Piecewise(built)
        }
        CourseSpec::Expression { text } => {
            let expression = Expression::new(text, &["d", "t"]);
            Course::Expression(expression.map_err(|error| unreadable(&error, format!("{path}.course.text")))?)
        }
    };
    DistanceProfile::new([spec.from, spec.to], mixes, course).map_err(|error| {
        let (code, field) = match &error {
            ProfileError::Limit { name, .. } => ("limits", (*name).to_owned()),
            ProfileError::Order { .. } => ("limits", "to".to_owned()),
            ProfileError::Number { name, .. } => ("course", format!("course.{name}")),
            ProfileError::Key { index, .. } => ("course", format!("course.keys[{index}].at")),
            ProfileError::Undefined { .. } => ("expression", "course.text".to_owned()),
            ProfileError::Materials { .. } => ("course", "course".to_owned()),
        };
        PartDiagnostic::new(code, format!("{path}.{field}"), error.to_string())
    })
}

fn unreadable(error: &ExpressionError, path: String) -> PartDiagnostic {
    let fault = PartDiagnostic::new("expression", path, error.to_string());
    PartDiagnostic { character: Some(error.at as u32), ..fault }
}

/// Whether it is certain that no point of the box of a body has a distance within the band of a profile; not said of functions of distances.
fn is_far(profile: &DistanceProfile, feature: &Feature, region: &Region) -> bool {
    let ([reference], true) = (feature.references(), feature.is_plain()) else { return false };
    let bounds = region.bounds();
    let cell = (bounds.max - bounds.min) / 4.0;
    let radius = cell.length() / 2.0;
    (0..16).all(|n| {
        let place = bounds.min + cell * DVec2::new(f64::from(n % 4) + 0.5, f64::from(n / 4) + 0.5);
        let distance = reference.distance(place);
        distance - radius > profile.to() || distance + radius < profile.from()
    })
}

/// Whether no pixel of a small raster lies in a region.
fn is_empty(region: &Region) -> bool {
    let overlap = Overlap::new(Rule::Repaired, 1.0, Composition::pure(0, 1), Vec::new());
    let body = Body {
        region: region.clone(),
        composing: Composing::Overlap,
        overlap,
        blend: None,
        features: Vec::new(),
        slots: Vec::new(),
    };
    let part = Part { materials: 1, bodies: vec![Some(body)] };
    let frame = Frame::new(region.bounds(), [LOOK, LOOK]);
    let job = frame.and_then(|frame| RasterJob::new(&part, frame));
    job.is_ok_and(|job| job.run().body.iter().all(|number| *number == 0))
}
