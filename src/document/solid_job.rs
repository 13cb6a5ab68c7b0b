//! From a solution to its solid, in steps.

use super::solid::{Solid, SolidRemark};
use super::solid_options::{SolidColor, SolidOptions};
use super::space::Space;
use super::{Code, DocumentError, Model, Solution};
use crate::curve::BSpline;
use crate::material::{Color, Oklab, mix_fractions, viridis};
use crate::morph::{Band, Ruling};
use crate::solid::{
    CapError, Mesh, Row, Shell, Shelled, area, flank_angle, is_watertight, stored_volume, twist_angle, volume,
};
use glam::DVec3;
use std::rc::Rc;

/// Most vertices of the surface of a solid: 1000 rulings in 200 stages, and some more at corners.
pub const MOST_VERTICES: usize = 210_000;

/// Fewest rulings that a surface has, unless lines share ends.
const RULINGS: usize = 176;

/// Smallest angle in degrees that the range of a map of angles spans, on either side of 0: less is not worth a colour.
const LEAST_ANGLE: f64 = 1.0;

/// Share of its volume that a solid may gain or lose by being stored in 32 bits.
const MOST_ROUNDED: f64 = 1e-3;

/// Distance from the drawn curves of the polylines that stand for them, as a share of the diagonal of their box.
const TOLERANCE: f64 = 1e-4;

/// A job that builds the solid of a solution.
#[derive(Debug)]
pub struct SolidJob {
    solution: Rc<Solution>,
    options: SolidOptions,
    space: Space,
    /// Rulings of the surface.
    band: Band,
    /// Number of steps from curve to curve.
    segments: usize,
    /// The angle of each ruling, where one is shown.
    scalars: Vec<f64>,
    stages: Vec<Vec<DVec3>>,
    work: Work,
}

/// What is done next.
#[derive(Debug)]
enum Work {
    Rows(Shell),
    Check(Shelled),
    /// With the volume inside, of a watertight mesh.
    Color(Shelled, Option<f64>),
    Done,
}

impl SolidJob {
    /// Prepares the solid of a solution, or the sheet between open curves. `Ok(None)` unless the matching is complete, or was repaired, and the
    /// heights differ; [`flat`](super::flat) tells the latter.
    ///
    /// # Errors
    /// With code `limit` when the surface would have more than [`MOST_VERTICES`].
    pub fn new(solution: Rc<Solution>, options: SolidOptions) -> Result<Option<Self>, DocumentError> {
        let model = &solution.model;
        let Some(((curves, _), known)) = model.pair().zip(solution.band()) else { return Ok(None) };
        let Some(space) = Space::of(model).filter(|space| !space.is_flat()) else { return Ok(None) };
        let segments = options.stages.unwrap_or_else(|| model.document().segments());
        let band = with_corners(model, curves, known);
        let count = band.rulings().len();
        if count * (segments + 1) > MOST_VERTICES {
            let most = (MOST_VERTICES / count).saturating_sub(1);
            let message = format!(
                "{segments} stages of {count} rulings were found; expected at most {most} stages, which have {MOST_VERTICES} vertices"
            );
            return Err(DocumentError::new(Code::Limit, "options.stages", message));
        }
        let scalars = angles(model, &band, &space, options.color);
        let [x, y, _] = space.axes();
        let shell = Shell::new(band.is_closed(), model.materials().len(), [x, y]);
        let stages = Vec::with_capacity(segments + 1);
        let work = Work::Rows(shell);
        Ok(Some(Self { options, space, band, segments, scalars, stages, work, solution }))
    }

    /// Advances while `may_go_on` says so, at least by a little; returns the solid when it is built, and `None` ever after.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Solid> {
        loop {
            self.work = match std::mem::replace(&mut self.work, Work::Done) {
                Work::Rows(mut shell) => {
                    self.add_row(&mut shell);
                    if self.stages.len() <= self.segments {
                        Work::Rows(shell)
                    } else {
                        Work::Check(shell.finish(self.options.caps))
                    }
                }
                Work::Check(shelled) => {
                    let volume = is_watertight(&shelled.mesh).then(|| volume(&shelled.mesh));
                    Work::Color(shelled, volume)
                }
                Work::Color(shelled, volume) => return Some(self.color(shelled, volume)),
                Work::Done => return None,
            };
            if !may_go_on() {
                return None;
            }
        }
    }

    /// Share of the work that is done, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        match self.work {
            Work::Rows(_) => 0.5 * self.stages.len() as f64 / (self.segments + 1) as f64,
            Work::Check(_) => 0.5,
            Work::Color(..) => 0.8,
            Work::Done => 1.0,
        }
    }

    /// Runs the job to its end; `None` where there is no solid.
    ///
    /// # Errors
    /// Those of [`new`](Self::new).
    pub fn run(solution: Rc<Solution>, options: SolidOptions) -> Result<Option<Solid>, DocumentError> {
        Ok(Self::new(solution, options)?.and_then(|mut job| job.step(&mut || true)))
    }

    /// The polyline across all rulings at the next stage.
    fn add_row(&mut self, shell: &mut Shell) {
        let s = self.stages.len() as f64 / self.segments as f64;
        let rulings = self.band.rulings();
        let points = rulings.iter().map(|ruling| {
            let [from, to] = self.space.ends(ruling);
            from.lerp(to, s)
        });
        let compositions = rulings.iter().map(|ruling| ruling.composition(s));
        let row = Row { points: points.collect(), compositions: compositions.collect() };
        shell.push(&row, &self.scalars);
        self.stages.push(row.points);
    }

    fn color(&mut self, Shelled { mesh, uncapped }: Shelled, volume: Option<f64>) -> Solid {
        let model = &self.solution.model;
        let is_closed = self.band.is_closed();
        let mut remarks: Vec<SolidRemark> = uncapped
            .iter()
            .enumerate()
            .filter_map(|(curve, error)| {
                let at = match (*error)? {
                    CapError::Crossing { at } => Some(at),
                    CapError::Empty => None,
                };
                Some(SolidRemark::Uncapped { curve, at })
            })
            .collect();
        if !is_closed {
            remarks.push(SolidRemark::OpenSheet);
        } else if self.options.caps && remarks.is_empty() {
            let is_kept = |volume: f64| (stored_volume(&mesh) - volume).abs() <= MOST_ROUNDED * volume;
            if !volume.is_some_and(is_kept) {
                remarks.push(SolidRemark::Rounded);
            }
        }
        let range = range(self.options.color, &mesh);
        let tolerance = TOLERANCE * model.bounds().diagonal();
        let outline = |(k, curve): (usize, &BSpline)| {
            let vertices = curve.flatten(tolerance);
            vertices.into_iter().map(|(u, point)| self.space.point(k, u, point)).collect()
        };
        let lines = self.solution.band().map_or_else(Vec::new, |band| band.lines().collect());
        Solid {
            colors: colors(model, &mesh, self.options.color, range),
            area: area(&mesh),
            volume,
            rulings: lines.into_iter().map(|ruling| self.space.ends(ruling)).collect(),
            curves: model.curves().iter().enumerate().map(outline).collect(),
            mesh,
            range,
            stages: std::mem::take(&mut self.stages),
            is_closed,
            is_watertight: volume.is_some(),
            may_be_open: !is_closed || !self.options.caps,
            remarks,
        }
    }
}

/// A band with enough rulings for a smooth surface, and one at each corner of either curve.
fn with_corners(model: &Model, curves: &[BSpline; 2], band: &Band) -> Band {
    let lines: Vec<(f64, f64)> = band.lines().map(|ruling| (ruling.u, ruling.v)).collect();
    let per_line = RULINGS.div_ceil(lines.len().max(1)).clamp(1, 32);
    let periods = curves.each_ref().map(|curve| curve.domain().1 - curve.domain().0);
    let end = lines.first().filter(|_| band.is_closed()).map(|&(u, v)| (u + periods[0], v + periods[1]));
    let corners = curves.each_ref().map(|curve| curve.corners());
    let next: Vec<(f64, f64)> = lines.iter().copied().skip(1).chain(end).collect();
    let mut places = Vec::with_capacity(per_line * lines.len());
    for (&from, &to) in lines.iter().zip(&next) {
        let mut shares: Vec<f64> = (0..per_line).map(|k| k as f64 / per_line as f64).collect();
        for (curve, (start, stop)) in [(from.0, to.0), (from.1, to.1)].into_iter().enumerate() {
            for corner in &corners[curve] {
                let laps = if band.is_closed() { ((start - corner.u) / periods[curve]).ceil() } else { 0.0 };
                let share = (corner.u + laps * periods[curve] - start) / (stop - start);
                if share > 0.0 && share < 1.0 {
                    shares.push(share);
                }
            }
        }
        shares.sort_by(f64::total_cmp);
        places.extend(shares.iter().map(|t| (from.0 + t * (to.0 - from.0), from.1 + t * (to.1 - from.1))));
    }
    if !band.is_closed() {
        places.extend(lines.last());
    }
    Band::new(curves, &places, |curve, u| model.composition(curve, u), 1)
}

/// The angle of each ruling where one is to be shown, else none at all.
fn angles(model: &Model, band: &Band, space: &Space, color: SolidColor) -> Vec<f64> {
    let [.., axis] = space.axes();
    let angle = |ruling: &Ruling| {
        let tangents = [space.tangent(model, 0, ruling.u), space.tangent(model, 1, ruling.v)];
        if color == SolidColor::Twist {
            return twist_angle(tangents, axis);
        }
        let [from, to] = space.ends(ruling);
        flank_angle(tangents, to - from)
    };
    match color {
        SolidColor::Twist | SolidColor::Flank => band.rulings().iter().map(angle).collect(),
        SolidColor::Material | SolidColor::Fraction(_) => Vec::new(),
    }
}

/// What the ends of the map of colours stand for: 0 and 1 for a fraction; angles from 0, or evenly about 0, to the greatest.
fn range(color: SolidColor, mesh: &Mesh) -> Option<(f64, f64)> {
    let greatest = || mesh.scalars.iter().fold(LEAST_ANGLE, |most, angle| most.max(angle.abs()));
    match color {
        SolidColor::Material => None,
        SolidColor::Fraction(_) => Some((0.0, 1.0)),
        SolidColor::Twist => Some((-greatest(), greatest())),
        SolidColor::Flank => Some((0.0, greatest())),
    }
}

fn colors(model: &Model, mesh: &Mesh, color: SolidColor, range: Option<(f64, f64)>) -> Vec<Color> {
    let vertices = 0..mesh.positions.len();
    let (low, high) = range.unwrap_or((0.0, 1.0));
    let share = |value: f64| viridis((value - low) / (high - low));
    match color {
        SolidColor::Material => {
            let pure: Vec<Oklab> =
                model.materials().iter().map(|material| material.color.to_oklab()).collect();
            let mut last: Option<(usize, Color)> = None;
            let mut mixed = |vertex: usize| {
                // Along a row of two pure materials all vertices are alike.
                let known = last.filter(|(other, _)| mesh.fractions_at(*other) == mesh.fractions_at(vertex));
                let color = known.map_or_else(
                    || mix_fractions(&pure, mesh.fractions_at(vertex)).to_color(),
                    |(_, color)| color,
                );
                last = Some((vertex, color));
                color
            };
            vertices.map(&mut mixed).collect()
        }
        SolidColor::Fraction(material) => vertices.map(|k| share(mesh.fractions_at(k)[material])).collect(),
        SolidColor::Twist | SolidColor::Flank => mesh.scalars.iter().map(|&angle| share(angle)).collect(),
    }
}
