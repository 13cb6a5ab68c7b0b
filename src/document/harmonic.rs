//! The harmonic blend of a document: which curve lies in which, the blend itself, and how it differs from the ruled one, in steps.

use super::solve::curve_remarks;
use super::stack::Ready;
use super::{BlendKind, CurvesDocument, Diagnostic, DocumentError, Model, Outcome, Solution, Solve};
use crate::curve::BSpline;
use crate::geom::{Location, first_contact, first_self_contact, locate};
use crate::laplace::LaplaceError;
use crate::morph::{Band, HarmonicBlend, HarmonicFineness, HarmonicWork, Ring, Rings};
use glam::DVec2;
use std::vec::IntoIter;

/// Greatest difference of a fraction from the solution in a picture.
const TOLERANCE: f64 = 1e-3;
/// The same while a document changes from frame to frame, and segments of each curve then.
const COARSE_TOLERANCE: f64 = 6e-3;
const COARSE_SEGMENTS: usize = 80;
/// Most segments of all curves together, about: beyond, a single level curve would take longer than a frame.
const MOST_SEGMENTS: usize = 2400;
/// Most of them where curves have so many corners, from each to the next one at least, that there are more.
const MOST_BETWEEN_CORNERS: usize = 2 * MOST_SEGMENTS;

/// The harmonic blend of a document.
#[derive(Debug, Clone)]
pub struct Harmonic {
    /// The blend.
    pub blend: HarmonicBlend,
    /// How it differs from the ruled one, where that was asked for.
    pub difference: Option<Difference>,
}

/// How a harmonic blend of two curves differs from the ruled one.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// Half the sum over the materials of the differences of the fractions, 0 to 1, at each vertex of the field; empty where there is no ruled blend.
    pub values: Vec<f64>,
    /// The largest of them.
    pub largest: f64,
    /// Where it is.
    pub at: DVec2,
    /// Their mean over the area.
    pub mean: f64,
}

impl Difference {
    /// What is to be said where there is nothing to compare with.
    #[must_use]
    pub fn remark(&self) -> Option<Diagnostic> {
        self.values.is_empty().then_some(Diagnostic::NoRuledBlend)
    }
}

/// A solved harmonic blend with fewer triangles, for a file whose size they decide; `None` of other documents, and where a difference belongs to the
/// triangles.
#[must_use]
pub fn lightened(solution: &Solution) -> Option<Solution> {
    let harmonic = solution.harmonic().filter(|harmonic| harmonic.difference.is_none())?;
    let light = Harmonic { blend: harmonic.blend.lightened(COARSE_TOLERANCE), difference: None };
    Some(Solution { outcome: Outcome::Harmonic(Box::new(light)), ..solution.clone() })
}

/// A harmonic blend of a document being made.
#[derive(Debug)]
pub(super) struct HarmonicJob {
    is_coarse: bool,
    work: Work,
    /// Share of the work that is done, as said last: it never falls.
    reached: f64,
}

#[derive(Debug)]
enum Work {
    /// Curves to look at by themselves and in pairs: what is left of these questions.
    Checking(IntoIter<(usize, usize)>),
    Beginning(Beginning),
    Blending(Box<HarmonicWork>),
}

impl HarmonicJob {
    pub(super) fn new(model: &Model, is_coarse: bool) -> Self {
        let count = model.curves().len();
        let pairs = (1..count).flat_map(|j| (0..j).map(move |i| (i, j)));
        let checks: Vec<(usize, usize)> = (0..count).map(|k| (k, k)).chain(pairs).collect();
        Self { is_coarse, work: Work::Checking(checks.into_iter()), reached: 0.0 }
    }

    /// Share of the work that is done.
    pub(super) fn progress(&self) -> f64 {
        self.reached
    }

    /// Advances while `may_go_on` says so, at least by a little.
    pub(super) fn step(&mut self, model: &Model, may_go_on: &mut dyn FnMut() -> bool) -> Option<Ready> {
        let ready = self.advance(model, may_go_on);
        let share = match &self.work {
            Work::Blending(work) => 0.05 + 0.95 * work.progress(),
            _ => 0.0,
        };
        self.reached = self.reached.max(share);
        ready
    }

    fn advance(&mut self, model: &Model, may_go_on: &mut dyn FnMut() -> bool) -> Option<Ready> {
        let without = |diagnostic: Diagnostic| {
            let mut diagnostics = curve_remarks(model);
            diagnostics.push(diagnostic);
            Some((Outcome::Unmatched, diagnostics, false))
        };
        let open: Vec<usize> =
            (0..model.curves().len()).filter(|k| !model.curves()[*k].is_closed()).collect();
        if !open.is_empty() {
            return without(Diagnostic::OpenCurves { curves: open });
        }
        loop {
            match &mut self.work {
                Work::Checking(checks) => match checks.next() {
                    Some((i, j)) if i == j => {
                        if let Some(fault) = model.self_contact(i) {
                            return Some((Outcome::Refused(fault), Vec::new(), false));
                        }
                    }
                    Some((i, j)) => {
                        if let Some(meeting) = model.curves()[i].contact(&model.curves()[j]) {
                            return without(Diagnostic::CurvesMeet { curves: [i, j], at: meeting.at });
                        }
                    }
                    None => self.work = Work::Beginning(Beginning::new(model, self.is_coarse)),
                },
                Work::Beginning(beginning) => match beginning.step(model) {
                    Ok(None) => {}
                    Ok(Some(work)) => self.work = Work::Blending(Box::new(work)),
                    Err(diagnostic) => return without(diagnostic),
                },
                Work::Blending(work) => {
                    return match work.step(may_go_on) {
                        Ok(blend) => self.finish(model, blend?),
                        Err(error) => without(no_field(error)),
                    };
                }
            }
            if !may_go_on() {
                return None;
            }
        }
    }

    fn finish(&self, model: &Model, blend: HarmonicBlend) -> Option<Ready> {
        let mut diagnostics = curve_remarks(model);
        diagnostics.extend(heights(model, blend.rings().outer()));
        if blend.lost() > 0 {
            diagnostics.push(Diagnostic::LostLines { count: blend.lost() });
        }
        let harmonic = Harmonic { blend, difference: None };
        Some((Outcome::Harmonic(Box::new(harmonic)), diagnostics, self.is_coarse))
    }
}

fn no_field(error: LaplaceError) -> Diagnostic {
    Diagnostic::NoField { at: error.at.map(|at| at.truncate()), reason: error.message }
}

/// Curves that do not meet being cut into rings, of which one contains all others.
#[derive(Debug)]
struct Beginning {
    fineness: HarmonicFineness,
    /// Of the curves so far.
    polygons: Vec<Vec<DVec2>>,
    rings: Vec<Ring>,
    outer: Option<usize>,
    /// Rings that were compared with themselves and all before.
    compared: usize,
}

impl Beginning {
    fn new(model: &Model, is_coarse: bool) -> Self {
        let blend = &model.document().blend;
        let most = MOST_SEGMENTS / model.curves().len();
        let wanted = blend.segments.unwrap_or(COARSE_SEGMENTS).min(most);
        let fineness = HarmonicFineness {
            segments: if is_coarse { wanted.min(COARSE_SEGMENTS) } else { wanted },
            lines: blend.lines.unwrap_or(1),
            stages: model.document().segments(),
            tolerance: if is_coarse { COARSE_TOLERANCE } else { TOLERANCE },
        };
        Self { fineness, polygons: Vec::new(), rings: Vec::new(), outer: None, compared: 0 }
    }

    /// Looks at one curve; returns the work on the blend when all are fine.
    fn step(&mut self, model: &Model) -> Result<Option<HarmonicWork>, Diagnostic> {
        if let Some(curve) = model.curves().get(self.rings.len()) {
            self.polygons.push(polygon(model, curve));
            self.rings.push(Ring::new(curve, self.fineness.segments));
            return Ok(None);
        }
        let Some(outer) = self.outer else {
            self.outer = Some(outermost(model, &self.polygons)?);
            let count: usize = self.rings.iter().map(Ring::len).sum();
            if count > MOST_BETWEEN_CORNERS {
                let reason = format!(
                    "between their corners the curves have {count} segments; expected {MOST_BETWEEN_CORNERS} at most: fewer corners or fewer curves"
                );
                return Err(Diagnostic::NoField { reason, at: None });
            }
            return Ok(None);
        };
        if let Some(ring) = self.rings.get(self.compared) {
            if let Some((edge, _)) = first_self_contact(&ring.points, true) {
                return Err(Diagnostic::CoarseSampling { at: Some(ring.points[edge]) });
            }
            for other in &self.rings[..self.compared] {
                if let Some((edge, _)) = first_contact(&ring.points, &other.points, true) {
                    return Err(Diagnostic::CoarseSampling { at: Some(ring.points[edge]) });
                }
            }
            self.compared += 1;
            return Ok(None);
        }
        let compose = |curve: usize, u: f64| model.composition(curve, u);
        let rings = Rings::new(std::mem::take(&mut self.rings), outer);
        HarmonicWork::new(model.curves().to_vec(), rings, &compose, self.fineness).map(Some).map_err(no_field)
    }
}

/// A curve as the polygon by which it is told what lies in it.
fn polygon(model: &Model, curve: &BSpline) -> Vec<DVec2> {
    let tolerance = 1e-5 * model.bounds().diagonal();
    curve.flatten(tolerance).into_iter().map(|(_, p)| p).collect()
}

/// For each curve the numbers of those that it lies in.
fn containers(polygons: &[Vec<DVec2>]) -> Vec<Vec<usize>> {
    let is_in = |i: usize, j: usize| locate(&polygons[j], polygons[i][0]) == Location::Inside;
    let count = polygons.len();
    (0..count).map(|i| (0..count).filter(|&j| j != i && is_in(i, j)).collect()).collect()
}

/// The curve that contains all others, none of which contains another.
fn outermost(model: &Model, polygons: &[Vec<DVec2>]) -> Result<usize, Diagnostic> {
    let within = containers(polygons);
    let point = |curve: usize| model.curves()[curve].point(model.curves()[curve].domain().0);
    let free: Vec<usize> = (0..within.len()).filter(|k| within[*k].is_empty()).collect();
    let [outer] = free[..] else {
        let at = point(free.get(1).or(free.first()).copied().unwrap_or(0));
        return Err(Diagnostic::NoOuter { curves: free, at });
    };
    for (k, own) in within.iter().enumerate() {
        if let Some(&container) = own.iter().find(|j| **j != outer) {
            return Err(Diagnostic::Nested { curves: [k, container], at: point(k) });
        }
    }
    Ok(outer)
}

/// The remark that several curves lie side by side in one, of curves that are a stack out of order.
pub(super) fn several_inner(model: &Model) -> Option<Diagnostic> {
    let is_closed = model.ends().is_none();
    let polygons = || model.curves().iter().map(|curve| polygon(model, curve)).collect::<Vec<_>>();
    let outer = is_closed.then(|| outermost(model, &polygons()).ok()).flatten()?;
    let curves: Vec<usize> = (0..model.curves().len()).filter(|k| *k != outer).collect();
    (curves.len() > 1).then_some(Diagnostic::SeveralInner { outer, curves })
}

fn heights(model: &Model, outer: usize) -> Option<Diagnostic> {
    let specs = &model.document().curves;
    let curves: Vec<usize> = (0..specs.len()).filter(|k| specs[*k].height != specs[outer].height).collect();
    (!curves.is_empty()).then_some(Diagnostic::HeightsIgnored { curves })
}

/// A harmonic blend of two curves being compared with the ruled one.
#[derive(Debug)]
pub struct Comparing {
    ruled: Box<Solve>,
    band: Option<Band>,
    values: Vec<f64>,
    next: usize,
}

/// Vertices that are compared at a time.
const AT_ONCE: usize = 64;

impl Comparing {
    /// Begins with the matching of a document, as its `matching` says.
    ///
    /// # Errors
    /// When a curve or a composition is not valid, as for the harmonic blend itself.
    pub fn new(document: &CurvesDocument, is_coarse: bool) -> Result<Self, DocumentError> {
        let mut ruled = document.clone();
        ruled.blend.kind = BlendKind::Ruled;
        // Both are compared in one plane.
        ruled.curves.iter_mut().for_each(|curve| curve.height = 0.0);
        let ruled = if is_coarse { Solve::coarse(ruled)? } else { Solve::new(ruled)? };
        Ok(Self { ruled: Box::new(ruled), band: None, values: Vec::new(), next: 0 })
    }

    /// Share of the work that is done, below 1.
    #[must_use]
    pub fn progress(&self, blend: &HarmonicBlend) -> f64 {
        let count = blend.field().points.len().max(1);
        let share = if self.band.is_some() {
            0.5 + 0.5 * self.next as f64 / count as f64
        } else {
            0.5 * self.ruled.progress()
        };
        share.min(0.999)
    }

    /// Advances while `may_go_on` says so, at least by a little; returns the difference when it is there. It has no values where the ruled blend is
    /// not complete.
    pub fn step(&mut self, blend: &HarmonicBlend, may_go_on: &mut dyn FnMut() -> bool) -> Option<Difference> {
        if self.band.is_none() {
            let solution: Solution = self.ruled.step(may_go_on)?;
            let band = solution.band().filter(|_| solution.is_complete()).cloned();
            let Some(band) = band else {
                return Some(Difference { values: Vec::new(), largest: 0.0, at: DVec2::ZERO, mean: 0.0 });
            };
            self.band = Some(band);
            // On the curves themselves both have the composition of the curve.
            self.next = blend.rings().count();
            self.values = vec![0.0; self.next];
        }
        let band = self.band.as_ref()?;
        let field = blend.field();
        while self.next < field.points.len() {
            for vertex in self.next..field.points.len().min(self.next + AT_ONCE) {
                let place = band.locate(field.points[vertex]);
                let value = place.map_or(f64::NAN, |place| {
                    let pairs = place.composition.fractions().iter().zip(&field.at(vertex)[1..]);
                    pairs.map(|(a, b)| (a - b).abs()).sum::<f64>() / 2.0
                });
                self.values.push(value);
            }
            self.next = self.values.len();
            if !may_go_on() && self.next < field.points.len() {
                return None;
            }
        }
        Some(self.summed(blend))
    }

    fn summed(&mut self, blend: &HarmonicBlend) -> Difference {
        let field = blend.field();
        let mut values = std::mem::take(&mut self.values);
        let (mut area, mut sum) = (0.0, 0.0);
        for corners in &field.triangles {
            let [a, b, c] = corners.map(|k| field.points[k as usize]);
            let own: Vec<f64> =
                corners.iter().map(|k| values[*k as usize]).filter(|value| value.is_finite()).collect();
            if !own.is_empty() {
                let size = (b - a).perp_dot(c - a) / 2.0;
                area += size;
                sum += size * own.iter().sum::<f64>() / own.len() as f64;
            }
        }
        // Beside the curves a vertex may lie between a curve and the chord of the ruled band: nothing is known of it.
        values.iter_mut().filter(|value| !value.is_finite()).for_each(|value| *value = 0.0);
        let largest = (0..values.len()).max_by(|a, b| values[*a].total_cmp(&values[*b])).unwrap_or(0);
        Difference {
            largest: values.get(largest).copied().unwrap_or(0.0),
            at: field.points.get(largest).copied().unwrap_or(DVec2::ZERO),
            mean: if area > 0.0 { sum / area } else { 0.0 },
            values,
        }
    }
}
