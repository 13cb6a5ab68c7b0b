//! The ruled surface of a document in space, and the solid that it encloses.

use super::solid_options::{SolidColor, SolidOptions};
use super::{Code, DocumentError, Model, Solution};
use crate::curve::BSpline;
use crate::geom::ShownPlace;
use crate::material::{Color, Oklab, mix_fractions, viridis};
use crate::morph::{Band, Ruling};
use crate::solid::{CapError, Mesh, Row, Shell, Shelled, flank_angle, is_watertight, twist_angle};
use glam::{DVec2, DVec3};
use std::fmt;

/// Most vertices of the surface of a solid: 1000 rulings in 200 stages, and some more at corners.
pub const MOST_VERTICES: usize = 210_000;

/// Fewest rulings that a surface has, unless lines share ends.
const RULINGS: usize = 176;

/// Smallest angle in degrees that the range of a map of angles spans, on either side of 0: less is not worth a colour.
const LEAST_ANGLE: f64 = 1.0;

/// Distance from the drawn curves of the polylines that stand for them, as a share of the diagonal of their box.
const TOLERANCE: f64 = 1e-4;

/// The ruled surface of a document in space.
#[derive(Debug, Clone, PartialEq)]
pub struct Solid {
    /// The triangles; closed by caps where that was asked for and the curves are closed.
    pub mesh: Mesh,
    /// Colour of each vertex.
    pub colors: Vec<Color>,
    /// Least and greatest number on the map of colours, where they are one.
    pub range: Option<(f64, f64)>,
    /// The ruling lines of the matching.
    pub rulings: Vec<[DVec3; 2]>,
    /// In-between curves j = 0 to M from the first curve on, polylines over all rulings.
    pub stages: Vec<Vec<DVec3>>,
    /// The curves, as polylines.
    pub curves: Vec<Vec<DVec3>>,
    /// Whether the curves are closed.
    pub is_closed: bool,
    /// Whether the mesh is watertight.
    pub is_watertight: bool,
    /// What there is to say of the solid.
    pub remarks: Vec<SolidRemark>,
}

/// Something about a solid that a person should know, or why there is none.
#[derive(Debug, Clone, PartialEq)]
pub enum SolidRemark {
    /// The curves lie at the same height, so that there is no solid.
    Flat {
        /// That height.
        height: f64,
    },
    /// The curves are open, so that there is a surface but no solid.
    OpenSheet,
    /// The rim at a curve meets itself, so that it has no cap.
    Uncapped {
        /// Number of the curve.
        curve: usize,
        /// Where it meets itself, in the plane.
        at: Option<DVec2>,
    },
    /// In the 32 bits in which vertices are stored some that are apart become one.
    Rounded,
}

impl SolidRemark {
    /// Name of the kind, stable across releases.
    #[must_use]
    pub fn code(&self) -> &'static str {
        match self {
            Self::Flat { .. } => "flat",
            Self::OpenSheet => "open-sheet",
            Self::Uncapped { .. } => "uncapped",
            Self::Rounded => "rounded",
        }
    }
}

impl fmt::Display for SolidRemark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Flat { height } => write!(
                f,
                "a solid needs curves at different heights, and both are at {height}; give one of them another `height`"
            ),
            Self::OpenSheet => {
                write!(
                    f,
                    "between open curves the surface is a sheet, which has no caps and encloses nothing"
                )
            }
            Self::Uncapped { curve, at } => {
                write!(f, "the rim at curve {curve} meets itself")?;
                at.iter().try_for_each(|at| write!(f, " near {}", ShownPlace(*at)))?;
                write!(f, ", so that it has no cap; take more lines")
            }
            Self::Rounded => write!(
                f,
                "vertices that lie apart are the same in the 32 bits in which they are stored; move the curves nearer to the origin"
            ),
        }
    }
}

impl Solid {
    /// The solid of a solution, or the sheet between open curves. `Ok(None)` unless the matching is complete, or was repaired, and the
    /// heights differ; [`flat`] tells the latter.
    ///
    /// # Errors
    /// With code `limit` when the surface would have more than [`MOST_VERTICES`].
    pub fn new(solution: &Solution, options: &SolidOptions) -> Result<Option<Self>, DocumentError> {
        let model = &solution.model;
        let Some(((curves, _), band)) = model.pair().zip(solution.band()) else { return Ok(None) };
        if model.gap() == 0.0 {
            return Ok(None);
        }
        let segments = options.stages.unwrap_or_else(|| model.document().segments());
        let is_closed = band.is_closed();
        let fine = with_corners(model, curves, band);
        let count = fine.rulings().len();
        if count * (segments + 1) > MOST_VERTICES {
            let most = (MOST_VERTICES / count).saturating_sub(1);
            let message = format!(
                "{segments} stages of {count} rulings were found; expected at most {most} stages, so that there are no more than {MOST_VERTICES} vertices"
            );
            return Err(DocumentError::new(Code::Limit, "options.stages", message));
        }
        let lift = |curve: usize, point: DVec2| point.extend(model.document().curves[curve].height);
        let ends = |ruling: &Ruling| [lift(0, ruling.from), lift(1, ruling.to)];
        let scalars = angles(curves, &fine, options.color, ends);
        let mut shell = Shell::new(is_closed, model.materials().len(), [DVec3::X, DVec3::Y]);
        let mut stages = Vec::with_capacity(segments + 1);
        for j in 0..=segments {
            let s = j as f64 / segments as f64;
            let row = row(&fine, s, ends);
            shell.push(&row, &scalars);
            stages.push(row.points);
        }
        let Shelled { mesh, uncapped } = shell.finish(options.caps);
        let is_watertight = is_watertight(&mesh);
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
        } else if options.caps && remarks.is_empty() && !is_watertight {
            remarks.push(SolidRemark::Rounded);
        }
        let range = range(options.color, &mesh);
        let bounds = model.bounds();
        let outline = |curve: usize| {
            let vertices = curves[curve].flatten(TOLERANCE * bounds.diagonal());
            vertices.into_iter().map(|(_, point)| lift(curve, point)).collect()
        };
        Ok(Some(Self {
            colors: colors(model, &mesh, options.color, range),
            rulings: band.lines().map(ends).collect(),
            curves: vec![outline(0), outline(1)],
            mesh,
            range,
            stages,
            is_closed,
            is_watertight,
            remarks,
        }))
    }
}

/// The height at which both curves of a solution lie, where they lie at one.
#[must_use]
pub fn flat(solution: &Solution) -> Option<SolidRemark> {
    let [first, second] = solution.model.document().curves.as_slice() else { return None };
    (first.height == second.height).then_some(SolidRemark::Flat { height: first.height })
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

/// The polyline across all rulings at the share `s` of the way.
fn row(band: &Band, s: f64, ends: impl Fn(&Ruling) -> [DVec3; 2]) -> Row {
    let at = |ruling: &Ruling| {
        let [from, to] = ends(ruling);
        from.lerp(to, s)
    };
    Row {
        points: band.rulings().iter().map(at).collect(),
        compositions: band.rulings().iter().map(|ruling| ruling.composition(s)).collect(),
    }
}

/// The angle of each ruling where one is to be shown, else none at all.
fn angles(
    curves: &[BSpline; 2],
    band: &Band,
    color: SolidColor,
    ends: impl Fn(&Ruling) -> [DVec3; 2],
) -> Vec<f64> {
    let tangents = |ruling: &Ruling| {
        [curves[0].normal(ruling.u), curves[1].normal(ruling.v)].map(|n| n.perp().extend(0.0))
    };
    let angle = |ruling: &Ruling| match color {
        SolidColor::Twist => twist_angle(tangents(ruling), DVec3::Z),
        _ => {
            let [from, to] = ends(ruling);
            flank_angle(tangents(ruling), to - from)
        }
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
