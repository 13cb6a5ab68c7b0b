//! From a solution to its solid, in steps.

use super::solid::{Solid, SolidRemark};
use super::solid_options::{SolidColor, SolidOptions};
use super::space::Space;
use super::{Code, DocumentError, Model, Solution};
use crate::curve::BSpline;
use crate::material::{Color, Oklab, mix_fractions, viridis};
#[cfg(feature = "stack")]
use crate::morph::{self, StackBlend};
use crate::morph::{Band, Ruling};
use crate::solid::{
    CapError, Mesh, Part, Row, Shell, Shelled, area, flank_angle, is_watertight, stored_volume, twist_angle,
    volume,
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
    surface: Surface,
    /// Number of steps from the first curve to the last.
    segments: usize,
    /// The angle of each ruling, where one is shown; of a stack, of each span.
    scalars: Vec<Vec<f64>>,
    stages: Vec<Vec<DVec3>>,
    work: Work,
}

/// What carries the surface.
#[derive(Debug)]
enum Surface {
    /// The rulings between two curves.
    Band(Band),
    /// The strands through a stack, and the number of stages of each span.
    #[cfg(feature = "stack")]
    Stack(Box<StackBlend>, usize),
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
    /// heights differ; [`flat`](super::flat) tells the latter. Stages of a stack are counted from each curve to the next; there is no solid of a stack of
    /// curves in space.
    ///
    /// # Errors
    /// With code `limit` when the surface would have more than [`MOST_VERTICES`].
    pub fn new(solution: Rc<Solution>, options: SolidOptions) -> Result<Option<Self>, DocumentError> {
        let model = &solution.model;
        let Some(space) = Space::of(model).filter(|space| !space.is_flat()) else { return Ok(None) };
        let stages = options.stages.unwrap_or_else(|| model.document().segments());
        let (surface, scalars, segments) = match model.pair().zip(solution.band()) {
            Some(((curves, _), known)) => {
                let band = with_corners(model, curves, known);
                let angles = angles(model, band.rulings(), &space, options.color, 0);
                (Surface::Band(band), vec![angles], stages)
            }
            #[cfg(feature = "stack")]
            None if space.is_plane() => match surface_of_stack(&solution, &space, options.color, stages) {
                Some((surface, scalars)) => {
                    let spans = scalars.len();
                    (surface, scalars, stages * spans)
                }
                None => return Ok(None),
            },
            None => return Ok(None),
        };
        let count = surface.rulings();
        if count * (segments + 1) > MOST_VERTICES {
            let most = (MOST_VERTICES / count).saturating_sub(1) * stages / segments;
            let message = format!(
                "{stages} stages of {count} rulings were found; expected at most {most} stages, which have {MOST_VERTICES} vertices"
            );
            return Err(DocumentError::new(Code::Limit, "options.stages", message));
        }
        let [x, y, _] = space.axes();
        let shell = Shell::new(surface.is_closed(), model.materials().len(), [x, y]);
        let stages = Vec::with_capacity(segments + 1);
        let work = Work::Rows(shell);
        Ok(Some(Self { options, space, surface, segments, scalars, stages, work, solution }))
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
        let stage = self.stages.len();
        let (row, span) = match &self.surface {
            Surface::Band(band) => {
                let s = stage as f64 / self.segments as f64;
                let rulings = band.rulings();
                let points = rulings.iter().map(|ruling| {
                    let [from, to] = self.space.ends(ruling);
                    from.lerp(to, s)
                });
                let compositions = rulings.iter().map(|ruling| ruling.composition(s));
                (Row { points: points.collect(), compositions: compositions.collect() }, 0)
            }
            #[cfg(feature = "stack")]
            Surface::Stack(blend, stages) => {
                let span = (stage / stages).min(blend.spans() - 1);
                let morph::Row { points, compositions } =
                    blend.row(span, (stage - span * stages) as f64 / *stages as f64);
                (Row { points, compositions }, span)
            }
        };
        shell.push(&row, &self.scalars[span]);
        self.stages.push(row.points);
    }

    /// The ruling lines of the matching, of a cubic stack piece by piece.
    fn rulings(&self) -> Vec<[DVec3; 2]> {
        match &self.surface {
            Surface::Band(_) => {
                let lines = self.solution.band().map_or_else(Vec::new, |band| band.lines().collect());
                lines.into_iter().map(|ruling| self.space.ends(ruling)).collect()
            }
            #[cfg(feature = "stack")]
            Surface::Stack(blend, _) => {
                let on_span = |span: usize| {
                    let lines = blend.lines(span).into_iter();
                    lines.flat_map(move |line| {
                        let last = (line.len() - 1) as f64;
                        let place = |k: usize| self.space.at(line[k], blend.height(span, k as f64 / last));
                        (1..line.len()).map(|k| [place(k - 1), place(k)]).collect::<Vec<_>>()
                    })
                };
                (0..blend.spans()).flat_map(on_span).collect()
            }
        }
    }

    fn color(&mut self, Shelled { mut mesh, uncapped }: Shelled, volume: Option<f64>) -> Solid {
        let model = &self.solution.model;
        let is_closed = self.surface.is_closed();
        // The second rim is that of the last curve.
        let last = model.curves().len() - 1;
        for group in &mut mesh.groups {
            if let Part::Cap(curve @ 1..) = &mut group.part {
                *curve = last;
            }
        }
        let mut remarks: Vec<SolidRemark> = uncapped
            .iter()
            .enumerate()
            .filter_map(|(curve, error)| {
                let at = match (*error)? {
                    CapError::Crossing { at } => Some(at),
                    CapError::Empty => None,
                };
                Some(SolidRemark::Uncapped { curve: curve * last, at })
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
        Solid {
            colors: colors(model, &mesh, self.options.color, range),
            area: area(&mesh),
            volume,
            rulings: self.rulings(),
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

impl Surface {
    /// Number of rulings, which is that of the vertices of a row.
    fn rulings(&self) -> usize {
        match self {
            Self::Band(band) => band.rulings().len(),
            #[cfg(feature = "stack")]
            Self::Stack(blend, _) => blend.strands().count(),
        }
    }

    fn is_closed(&self) -> bool {
        match self {
            Self::Band(band) => band.is_closed(),
            #[cfg(feature = "stack")]
            Self::Stack(blend, _) => blend.is_closed(),
        }
    }
}

/// The strands of a stack with a blend, and the angles of every span where they are shown: between straight rulings from curve to curve.
#[cfg(feature = "stack")]
fn surface_of_stack(
    solution: &Solution,
    space: &Space,
    color: SolidColor,
    stages: usize,
) -> Option<(Surface, Vec<Vec<f64>>)> {
    let (model, stack) = (&solution.model, solution.stack()?);
    let threads = stack.blend.as_ref()?.threads().count();
    let blend = stack.blend_with(model, RULINGS.div_ceil(threads.max(1)).clamp(1, 32))?;
    let of_span = |span: usize| {
        let strip = blend.strip(span, 0.0, 1.0);
        angles(model, strip.rulings(), space, color, span)
    };
    let scalars = (0..blend.spans()).map(of_span).collect();
    Some((Surface::Stack(Box::new(blend), stages), scalars))
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

/// The angle of each ruling of a span where one is to be shown, else none at all.
fn angles(model: &Model, rulings: &[Ruling], space: &Space, color: SolidColor, span: usize) -> Vec<f64> {
    let [.., axis] = space.axes();
    let angle = |ruling: &Ruling| {
        let tangents = [space.tangent(model, span, ruling.u), space.tangent(model, span + 1, ruling.v)];
        if color == SolidColor::Twist {
            return twist_angle(tangents, axis);
        }
        let [from, to] =
            [space.point(span, ruling.u, ruling.from), space.point(span + 1, ruling.v, ruling.to)];
        flank_angle(tangents, to - from)
    };
    match color {
        SolidColor::Twist | SolidColor::Flank => rulings.iter().map(angle).collect(),
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
