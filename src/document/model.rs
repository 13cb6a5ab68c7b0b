//! The curves of a document, ready for evaluation.

use super::schema::{
    BLANK, CurveForm, CurveSpec, EndRule, Method, NegativeMode, PrintedRule, SamplingScheme,
};
use super::{Code, CurvesDocument, DocumentError};
#[cfg(feature = "solid")]
use super::{Projection, projection::projected};
use crate::curve::{BSpline, CurveError, Form, Samples, Scheme, sample, sample_adaptively};
use crate::geom::{Bounds, ShownPlace};
use crate::matching::{Ends, NegativeProducts, Weights};
use crate::material::{Color, Composition, Material, Profile};
use glam::DVec2;

/// A document with its curves built, turned counter-clockwise where they are closed, and sampled, and its compositions checked.
///
/// A drawing in progress has no curve or one; [`pair`](Self::pair) is there when it has two. The spans of a stack have models of their own.
#[derive(Debug, Clone)]
pub struct Model {
    document: CurvesDocument,
    curves: Vec<BSpline>,
    reversed: Vec<bool>,
    samples: Vec<Samples>,
    coarse: Vec<usize>,
    pins: Vec<(usize, usize)>,
    profiles: Vec<Profile>,
    materials: Vec<Material>,
    #[cfg(feature = "solid")]
    projection: Option<Projection>,
}

impl Model {
    /// Builds the curves and compositions of a document.
    ///
    /// # Errors
    /// When a curve, a colour or a composition is not valid, with the path of the field. Curves that meet themselves or
    /// each other are built; [`fault`](Self::fault) tells.
    pub fn new(document: CurvesDocument) -> Result<Self, DocumentError> {
        #[cfg(feature = "solid")]
        let (document, projection) = projected(document)?;
        let materials = materials(&document.materials)?;
        let (mut curves, mut reversed, mut profiles) = (Vec::new(), Vec::new(), Vec::new());
        for (k, spec) in document.curves.iter().enumerate() {
            profiles.push(profile(&document, k)?);
            let (curve, is_reversed) = curve(spec, k)?;
            curves.push(curve);
            reversed.push(is_reversed);
        }
        let (mut samples, mut coarse) = (Vec::new(), Vec::new());
        for (k, curve) in curves.iter().enumerate() {
            let (taken, is_fine) = samples_of(curve, k, &document);
            samples.push(taken);
            if !is_fine {
                coarse.push(k);
            }
        }
        if let ([first, second], Method::Shift | Method::Parameter) =
            (curves.as_slice(), document.matching.method)
        {
            samples = resample([first, second], &samples, document.sampling.scheme);
        }
        let pins = if document.matching.pins.is_empty() || curves.len() > 2 {
            Vec::new()
        } else {
            pins(&document, &curves, &reversed, &mut samples)
        };
        Ok(Self {
            curves,
            reversed,
            samples,
            coarse,
            pins,
            profiles,
            materials,
            document,
            #[cfg(feature = "solid")]
            projection,
        })
    }

    /// Reverses an open curve.
    pub(super) fn turn(&mut self, k: usize) {
        // Of a pair alone the second one is turned.
        let k = if cfg!(feature = "stack") { k } else { 1 };
        if let (Some(curve), Some(samples)) = (self.curves.get_mut(k), self.samples.get_mut(k)) {
            *samples = samples.reversed(curve);
            *curve = curve.reversed();
            self.reversed[k] = !self.reversed[k];
            let last = samples.arc.len() - 1;
            for pin in &mut self.pins {
                let end = if k == 0 { &mut pin.0 } else { &mut pin.1 };
                *end = last - *end;
            }
        }
    }

    /// How curves in space are seen in the plane; `None` of plane curves.
    #[cfg(feature = "solid")]
    #[must_use]
    pub fn projection(&self) -> Option<&Projection> {
        self.projection.as_ref()
    }

    /// What is wrong with the geometry, said of curves in space as it is of their projections.
    #[cfg(feature = "solid")]
    fn seen(&self, message: String) -> String {
        let place = "as they are seen on the plane that fits them best, ";
        if self.projection.is_some() { format!("{place}{message}") } else { message }
    }

    /// The document; of one with curves in space its projection on a plane.
    #[must_use]
    pub fn document(&self) -> &CurvesDocument {
        &self.document
    }

    /// The curves that are there: counter-clockwise, or in the direction in which open ones are matched.
    #[must_use]
    pub fn curves(&self) -> &[BSpline] {
        &self.curves
    }

    /// Which curves run here against the direction in which they were drawn.
    #[must_use]
    pub fn reversed(&self) -> &[bool] {
        &self.reversed
    }

    /// Samples of the curves.
    #[must_use]
    pub fn samples(&self) -> &[Samples] {
        &self.samples
    }

    /// Numbers of the curves whose adaptive samples would have to be more than the format allows.
    #[must_use]
    pub fn coarse(&self) -> &[usize] {
        &self.coarse
    }

    /// Pinned pairs of two curves, by the numbers of their samples on the first and the second.
    #[must_use]
    pub fn pins(&self) -> &[(usize, usize)] {
        &self.pins
    }

    /// The curves and their samples where they are two.
    #[must_use]
    pub fn pair(&self) -> Option<(&[BSpline; 2], &[Samples; 2])> {
        self.curves.as_array().zip(self.samples.as_array())
    }

    /// Materials of the document.
    #[must_use]
    pub fn materials(&self) -> &[Material] {
        &self.materials
    }

    /// Weights of the ruling lines.
    #[must_use]
    pub fn weights(&self) -> Weights {
        let matching = &self.document.matching;
        Weights {
            normal: matching.normal_weight,
            distance: matching.distance_weight,
            alignment: matching.alignment_weight,
            heights: !matching.is_printed(PrintedRule::Heights),
            negative: match matching.negative {
                _ if matching.is_printed(PrintedRule::Negative) => NegativeProducts::Printed,
                NegativeMode::Signed => NegativeProducts::Signed,
                NegativeMode::Clamp => NegativeProducts::Clamp,
                NegativeMode::Half => NegativeProducts::Half,
            },
        }
    }

    /// Distance between the planes of two curves; 0 where they are not two.
    #[must_use]
    pub fn gap(&self) -> f64 {
        match self.document.curves.as_slice() {
            [first, second] => (first.height - second.height).abs(),
            _ => 0.0,
        }
    }

    /// Composition at the parameter `u` of a curve; parameters outside the domain of a closed one wrap round.
    #[must_use]
    pub fn composition(&self, curve: usize, u: f64) -> Composition {
        let (lo, hi) = self.curves[curve].domain();
        if !self.curves[curve].is_closed() {
            let fraction = ((u - lo) / (hi - lo)).clamp(0.0, 1.0);
            return self.profiles[curve].at(if self.reversed[curve] { 1.0 - fraction } else { fraction });
        }
        let fraction = ((u - lo) / (hi - lo)).rem_euclid(1.0);
        let drawn = if self.reversed[curve] { (1.0 - fraction).rem_euclid(1.0) } else { fraction };
        self.profiles[curve].at(if drawn < 1.0 { drawn } else { 0.0 })
    }

    /// Parameters of the keys of the composition along a curve, between which it is linear.
    #[cfg(feature = "amounts")]
    #[must_use]
    pub fn key_parameters(&self, curve: usize) -> Vec<f64> {
        let (lo, hi) = self.curves[curve].domain();
        let oriented = |at: f64| if self.reversed[curve] { 1.0 - at } else { at };
        self.profiles[curve].keys().iter().map(|&(at, _)| lo + oriented(at) * (hi - lo)).collect()
    }

    /// What becomes of the ends of open curves; `None` for closed ones.
    #[must_use]
    pub fn ends(&self) -> Option<Ends> {
        let is_open = self.curves.iter().any(|curve| !curve.is_closed());
        is_open.then_some(match self.document.matching.ends {
            Some(EndRule::Free) => Ends::Free,
            Some(EndRule::Tied) | None => Ends::Tied,
        })
    }

    /// Smallest box that holds the curves and their control points; 100 units about the origin where there are none.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        self.curves
            .iter()
            .map(BSpline::bounds)
            .reduce(Bounds::union)
            .unwrap_or(Bounds { min: DVec2::splat(-BLANK / 2.0), max: DVec2::splat(BLANK / 2.0) })
    }

    /// Finds a place where a curve meets itself, or where two meet at equal heights, on the curves themselves.
    #[must_use]
    pub fn fault(&self) -> Option<DocumentError> {
        let count = self.curves.len();
        let itself = (0..count).find_map(|k| self.self_contact(k));
        if cfg!(not(feature = "stack")) {
            return itself.or_else(|| (count > 1).then(|| self.contact(0, 1)).flatten());
        }
        itself.or_else(|| (1..count).find_map(|j| (0..j).find_map(|i| self.contact(i, j))))
    }

    /// A place where a curve meets itself.
    pub(super) fn self_contact(&self, k: usize) -> Option<DocumentError> {
        let curve = &self.curves[k];
        let meeting = curve.self_intersection()?;
        let expected = match curve.domain() {
            ends if !curve.is_closed() && (meeting.u, meeting.v) == ends => {
                "an open curve whose ends keep apart, or the form `clamped`"
            }
            _ => "a simple curve",
        };
        let message = format!("the curve meets itself near {}; expected {expected}", ShownPlace(meeting.at));
        #[cfg(feature = "solid")]
        let message = self.seen(message);
        let error = DocumentError::new(Code::SelfIntersection, format!("curves[{k}].points"), message);
        Some(error.with_place(meeting.at))
    }

    /// A place where two curves of the same height meet.
    pub(super) fn contact(&self, i: usize, j: usize) -> Option<DocumentError> {
        let curves = &self.document.curves;
        if curves[i].height != curves[j].height {
            return None;
        }
        let meeting = self.curves[i].contact(&self.curves[j])?;
        let near = ShownPlace(meeting.at);
        let message = if cfg!(feature = "stack") && curves.len() > 2 {
            format!("the curve meets curve {i} near {near}; expected curves that keep apart")
        } else {
            format!("the two curves meet near {near}; expected curves that keep apart")
        };
        #[cfg(feature = "solid")]
        let message = self.seen(message);
        Some(DocumentError::new(Code::Contact, format!("curves[{j}].points"), message).with_place(meeting.at))
    }
}

/// The materials with their colours read.
pub(super) fn materials(specs: &[super::MaterialSpec]) -> Result<Vec<Material>, DocumentError> {
    let build = |(k, spec): (usize, &super::MaterialSpec)| {
        let color = Color::parse(&spec.color)
            .map_err(|e| DocumentError::new(Code::Range, format!("materials[{k}].color"), e.to_string()))?;
        Ok(Material { name: spec.name.clone(), color, void: spec.void })
    };
    specs.iter().enumerate().map(build).collect()
}

/// Composition along a curve as drawn.
fn profile(document: &CurvesDocument, curve: usize) -> Result<Profile, DocumentError> {
    let count = document.materials.len();
    let path = |rest: &str| format!("curves[{curve}].composition{rest}");
    let compositions = document.curves[curve].composition.iter().enumerate().map(|(k, key)| {
        if key.mix.len() != count {
            let message =
                format!("{} fractions were found; expected {count}, one for each material", key.mix.len());
            return Err(DocumentError::new(Code::Range, path(&format!("[{k}].mix")), message));
        }
        let composition = Composition::new(key.mix.clone())
            .map_err(|e| DocumentError::new(Code::Range, path(&format!("[{k}].mix")), e.to_string()))?;
        Ok((key.at, composition))
    });
    let keys = compositions.collect::<Result<Vec<_>, _>>()?;
    let closed = document.curves[curve].form != CurveForm::Open;
    Profile::new(keys, closed).map_err(|e| DocumentError::new(Code::Range, path(""), e.to_string()))
}

/// Samples a curve as the document says; tells whether the samples are as fine as they should be.
fn samples_of(curve: &BSpline, k: usize, document: &CurvesDocument) -> (Samples, bool) {
    let sampling = &document.sampling;
    let scheme = match sampling.scheme {
        SamplingScheme::Parameter => Scheme::Parameter,
        SamplingScheme::ArcLength => Scheme::ArcLength,
        SamplingScheme::Adaptive => return sample_adaptively(curve, sampling.fineness(&document.curves)),
    };
    (sample(curve, scheme, sampling.counts[k]), true)
}

/// Samples both curves at the larger of their counts: by parameter where the scheme says so, else by arc length.
fn resample(curves: [&BSpline; 2], samples: &[Samples], scheme: SamplingScheme) -> Vec<Samples> {
    let count = samples.iter().map(|samples| samples.parameters.len()).max().unwrap_or(3);
    let scheme = match scheme {
        SamplingScheme::Parameter => Scheme::Parameter,
        SamplingScheme::ArcLength | SamplingScheme::Adaptive => Scheme::ArcLength,
    };
    curves.iter().map(|curve| sample(curve, scheme, count)).collect()
}

/// Adds samples at the ends of the pins; returns their numbers.
fn pins(
    document: &CurvesDocument,
    curves: &[BSpline],
    reversed: &[bool],
    samples: &mut [Samples],
) -> Vec<(usize, usize)> {
    let mut numbers = Vec::new();
    for ((k, curve), samples) in curves.iter().enumerate().zip(samples) {
        let (lo, hi) = curve.domain();
        let ends = document.matching.pins.iter().map(|pin| if k == 0 { pin.u } else { pin.v });
        let oriented: Vec<f64> = ends.map(|u| if reversed[k] { lo + hi - u } else { u }).collect();
        numbers.push(samples.insert(curve, &oriented));
    }
    let mut numbers = numbers.into_iter();
    let (first, second) = (numbers.next().unwrap_or_default(), numbers.next().unwrap_or_default());
    first.into_iter().zip(second).collect()
}

/// Builds a curve as drawn.
pub(super) fn drawn_curve(spec: &CurveSpec, k: usize) -> Result<BSpline, DocumentError> {
    let form = match spec.form {
        CurveForm::Periodic => Form::Periodic,
        CurveForm::Clamped => Form::Clamped,
        CurveForm::Open => Form::Open,
    };
    let points = spec.points.iter().map(|&p| DVec2::from(p)).collect();
    BSpline::new(spec.degree, form, points, spec.knots.clone())
        .map_err(|error| refuse(&error, k, spec.points.len()))
}

/// Builds a curve and turns a closed one counter-clockwise; tells whether it was reversed.
fn curve(spec: &CurveSpec, k: usize) -> Result<(BSpline, bool), DocumentError> {
    let curve = drawn_curve(spec, k)?;
    let is_reversed = curve.is_closed() && curve.signed_area() < 0.0;
    if is_reversed { Ok((curve.reversed(), true)) } else { Ok((curve, false)) }
}

/// Says of an error in a curve which field of the document it concerns.
fn refuse(error: &CurveError, k: usize, points: usize) -> DocumentError {
    let (code, field) = match *error {
        CurveError::Degree { .. } => (Code::Range, "degree".to_owned()),
        CurveError::TooFewPoints { .. } => (Code::Points, "points".to_owned()),
        CurveError::TooManyPoints { .. } => (Code::Limit, "points".to_owned()),
        CurveError::PointNotFinite { index, .. } => (Code::NonFinite, format!("points[{index}]")),
        CurveError::PointTooLarge { index, .. } => (Code::Range, format!("points[{index}]")),
        CurveError::NotClosed { .. } => (Code::Points, format!("points[{}]", points.saturating_sub(1))),
        CurveError::ZeroLength { .. } => (Code::ZeroLength, "points".to_owned()),
        CurveError::KnotNotFinite { index, .. }
        | CurveError::KnotsDecrease { index, .. }
        | CurveError::KnotsNotPeriodic { index, .. }
        | CurveError::KnotsNotClamped { index, .. }
        | CurveError::Multiplicity { index, .. } => (Code::Knots, format!("knots[{index}]")),
        _ => (Code::Knots, "knots".to_owned()),
    };
    DocumentError::new(code, format!("curves[{k}].{field}"), error.to_string())
}
