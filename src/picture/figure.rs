//! The picture of a solved document.

use super::{Blends, Cased, DisplayList, Item, Mesh, Path, StrokeStyle, Theme, Viewport};
use crate::curve::BSpline;
use crate::document::{Diagnostic, LayerName, Outcome, Solution};
use crate::material::{Oklab, mix_colors, viridis};
use crate::morph::{Band, IsoLine, Ruling, unit_cells};
use glam::DVec2;

/// What to show of a solved document.
#[derive(Debug, Clone, PartialEq)]
pub struct FigureOptions {
    /// Layers shown; the two curves are shown always.
    pub layers: Vec<LayerName>,
    /// Colours and strokes.
    pub theme: Theme,
    /// Whether the canvas is filled; else it is transparent.
    pub background: bool,
    /// Place of the current in-between curve, from 0 on the first curve to 1 on the second.
    pub s: Option<f64>,
    /// Index of a ruling line to lift out.
    pub line: Option<usize>,
    /// Index of the material whose lines of equal fraction are shown; of one that is not there are none.
    pub iso_material: usize,
    /// Whether hatches stand in for the colours of the materials.
    pub patterns: bool,
}

/// Chord error of the drawn curves in device pixels: below what anti-aliasing shows.
const CHORD_ERROR: f64 = 0.05;
/// Length of drawn normals, in CSS pixels.
const NORMAL_LENGTH: f64 = 14.0;
/// Radius of the ring round a vertex without a line, and size of the cross at a witness, in CSS pixels.
const RING_RADIUS: f32 = 5.0;
const CROSS_SIZE: f32 = 11.0;
/// Width of the current in-between curve where it wears its materials, in CSS pixels.
const WORN_WIDTH: f32 = 5.0;
/// Distance on the curves from one ruling of a hatched band to the next, in CSS pixels, and the change of a fraction that no two pass over.
const RULING_STEP: f64 = 12.0;
const MIX_STEP: f64 = 0.1;
/// Pictures whose shorter side is less than this, in CSS pixels, have thinner lines and no sample dots.
const SMALL: f64 = 420.0;

/// Draws a solved document for a view. Layers whose data are missing, such as the band of an incomplete matching, stay empty.
#[must_use]
pub fn figure(solution: &Solution, options: &FigureOptions, viewport: &Viewport) -> DisplayList {
    let is_small = f64::from(viewport.width.min(viewport.height)) < SMALL * viewport.pixel_ratio;
    let theme = if is_small { options.theme.compact() } else { options.theme };
    // Occluded lines that were added may cross: nothing is blended over them.
    let band = solution.band().filter(|_| solution.is_complete());
    let is_blended = band.is_some();
    #[cfg(feature = "stack")]
    let is_blended = is_blended || solution.stack().is_some_and(|stack| stack.is_complete);
    #[cfg(feature = "harmonic")]
    let is_blended = is_blended || solution.harmonic().is_some();
    let tolerance = (CHORD_ERROR / viewport.scale).max(solution.model.bounds().diagonal() * 1e-6);
    let mut drawing = Drawing {
        solution,
        options,
        theme,
        is_small,
        on_band: is_blended
            && !options.patterns
            && [LayerName::Material, LayerName::UnitCells, LayerName::Difference]
                .iter()
                .any(|layer| options.layers.contains(layer)),
        unit: viewport.pixel_ratio / viewport.scale,
        outlines: outlines(solution, tolerance),
        tolerance,
        list: DisplayList::new(options.background.then_some(theme.canvas)),
    };
    drawing.grid();
    if let Some(band) = band {
        drawing.material(band);
        drawing.in_betweens(band);
        drawing.iso_lines(&|material, level| band.iso_lines(material, level));
    }
    drawing.lines(solution, 0, None);
    if let (Some(band), Some(s)) = (band, options.s) {
        drawing.current(band, s);
    }
    #[cfg(feature = "stack")]
    if let Some(stack) = solution.stack() {
        drawing.stack(stack);
    }
    #[cfg(feature = "harmonic")]
    if let Some(harmonic) = solution.harmonic() {
        drawing.harmonic(harmonic);
    }
    drawing.boundaries();
    drawing.samples();
    drawing.witnesses();
    drawing.control_polygons();
    drawing.list
}

/// The curves as polylines within a chord error in document units.
fn outlines(solution: &Solution, tolerance: f64) -> Path {
    let ring = |curve: &BSpline| curve.flatten(tolerance).into_iter().map(|(_, p)| p).collect();
    Path { rings: solution.model.curves().iter().map(ring).collect(), closed: is_closed(solution) }
}

/// Whether the curves are closed; both are, or neither is.
fn is_closed(solution: &Solution) -> bool {
    solution.model.ends().is_none()
}

/// The border of an open band between two curves: along the first from the first line to the last, and back along the second.
pub(super) fn border(curves: &[BSpline], band: &Band, tolerance: f64) -> Path {
    let (Some(first), Some(last), [one, other]) = (band.rulings().first(), band.rulings().last(), curves)
    else {
        return Path::default();
    };
    let stretch = |curve: &BSpline, from: f64, to: f64| {
        let inner =
            curve.flatten(tolerance).into_iter().filter(move |(u, _)| (from..to).contains(u) && *u > from);
        let mut points = vec![curve.point(from)];
        points.extend(inner.map(|(_, point)| point));
        points.push(curve.point(to));
        points
    };
    let mut ring = stretch(one, first.u, last.u);
    ring.extend(stretch(other, first.v, last.v).into_iter().rev());
    Path::closed(ring)
}

pub(super) struct Drawing<'a> {
    pub(super) solution: &'a Solution,
    pub(super) options: &'a FigureOptions,
    pub(super) theme: Theme,
    is_small: bool,
    /// Whether lines inside the band lie on its colours, and not on the canvas.
    on_band: bool,
    /// Document units in one CSS pixel.
    pub(super) unit: f64,
    pub(super) outlines: Path,
    /// Chord error of drawn curves in document units.
    pub(super) tolerance: f64,
    pub(super) list: DisplayList,
}

impl Drawing<'_> {
    pub(super) fn shows(&self, layer: LayerName) -> bool {
        self.options.layers.contains(&layer)
    }

    pub(super) fn stroke(&mut self, layer: &str, path: Path, style: StrokeStyle) {
        if !path.rings.is_empty() {
            self.list.push(layer, Item::Stroke { path, style });
        }
    }

    /// The style of a line inside the band: on the bare canvas it takes the colour of the curves, which shows there.
    pub(super) fn inside(&self, style: StrokeStyle) -> StrokeStyle {
        if self.on_band {
            style
        } else {
            StrokeStyle { color: self.theme.boundary.color, opacity: 0.5, ..style }
        }
    }

    pub(super) fn cased(&mut self, layer: &str, path: Path, style: Cased) {
        self.stroke(layer, path.clone(), style.halo);
        self.stroke(layer, path, style.line);
    }

    fn grid(&mut self) {
        if self.shows(LayerName::Grid) {
            self.list.push("grid", Item::Grid { minor: self.theme.grid_minor, major: self.theme.grid_major });
        }
    }

    /// Display colours of the materials.
    pub(super) fn colors(&self) -> Vec<Oklab> {
        self.solution.model.materials().iter().map(|material| material.color.to_oklab()).collect()
    }

    fn material(&mut self, band: &Band) {
        if self.options.patterns {
            self.patterns(band);
            return;
        }
        let colors = self.colors();
        let mesh = if self.shows(LayerName::UnitCells) {
            flat_cells(band, self.solution.model.document().segments(), &colors)
        } else if self.shows(LayerName::Material) {
            smooth_band(band, &colors)
        } else {
            return;
        };
        let outline = if band.is_closed() {
            self.outlines.clone()
        } else {
            border(self.solution.model.curves(), band, self.tolerance)
        };
        self.list.push("material", Item::Mesh { mesh, outline, opacity: 1.0 });
    }

    /// One hatch for each material; empty space has none.
    fn patterns(&mut self, band: &Band) {
        let blends = if self.shows(LayerName::UnitCells) {
            cell_blends(band, self.solution.model.document().blend.stages)
        } else if self.shows(LayerName::Material) {
            band_blends(band, RULING_STEP * self.unit)
        } else {
            return;
        };
        let outline = self.outlines.clone();
        self.hatch(blends, outline);
    }

    /// Hatches inside an outline, one for each material that is there.
    pub(super) fn hatch(&mut self, blends: Blends, outline: Path) {
        let used = |&index: &usize| blends.mixes.iter().any(|mix| mix.fractions()[index] > 0.0);
        let solid = self.solution.model.materials().iter().enumerate().filter(|(_, material)| !material.void);
        let materials = solid.map(|(index, _)| index).filter(used).collect();
        let color = self.theme.boundary.color;
        self.list.push("material", Item::Hatch { blends, materials, outline, color });
    }

    fn in_betweens(&mut self, band: &Band) {
        if self.shows(LayerName::InBetweens) {
            let segments = self.solution.model.document().segments();
            let rings = (1..segments).map(|j| band.in_between(j as f64 / segments as f64)).collect();
            let path = Path { rings, closed: band.is_closed() };
            self.stroke("in-betweens", path, self.inside(self.theme.in_between));
        }
    }

    fn current(&mut self, band: &Band, s: f64) {
        let materials = self.colors();
        let shade = |ruling: &Ruling| {
            let [near, far] = end_colors(ruling, &materials);
            near.lerp(far, s as f32)
        };
        self.worn(band.in_between(s), band.is_closed(), || band.rulings().iter().map(shade).collect());
    }

    /// The current in-between curve. On the bare canvas, where no band shows the material, it wears that of its own points.
    pub(super) fn worn(&mut self, mut line: Vec<DVec2>, closed: bool, shades: impl FnOnce() -> Vec<Oklab>) {
        let is_shown = self.shows(LayerName::Material) || self.shows(LayerName::UnitCells);
        if is_shown || self.options.patterns {
            self.cased("current", Path { rings: vec![line], closed }, self.theme.current);
            return;
        }
        let casing = StrokeStyle { width_px: WORN_WIDTH + 2.0, ..self.theme.boundary };
        self.stroke("current", Path { rings: vec![line.clone()], closed }, casing);
        let shades = shades();
        let count = line.len();
        // The number of the last point; that of a closed line is the first again.
        let last = if closed { count } else { count - 1 };
        line.push(line[0]);
        let (mut start, mut worn) = (0, None);
        for k in 0..=last {
            let next = shades[k % count].lerp(shades[(k + 1) % count], 0.5).to_color();
            if let Some(color) = worn.filter(|&color| color != next || k == last) {
                let style = StrokeStyle::solid(WORN_WIDTH, color, 1.0);
                self.stroke("current", Path::open(line[start..=k].to_vec()), style);
                start = k;
            }
            worn = Some(next);
        }
    }

    /// Lines at every tenth of the fraction, each second one firm.
    pub(super) fn iso_lines(&mut self, lines: &dyn Fn(usize, f64) -> Vec<IsoLine>) {
        let material = self.options.iso_material;
        if !self.shows(LayerName::IsoComposition) || material >= self.solution.model.materials().len() {
            return;
        }
        for tenth in [1, 3, 5, 7, 9, 2, 4, 6, 8] {
            let style = self.inside(if tenth % 2 == 0 { self.theme.iso } else { self.theme.iso_minor });
            for line in lines(material, f64::from(tenth) / 10.0) {
                let path = Path { rings: vec![line.points], closed: line.closed };
                self.stroke("iso-composition", path, style);
            }
        }
    }

    /// The lines of a solution; `before` is the number of lines that stand before them in a stack, where they may be drawn curved.
    pub(super) fn lines(&mut self, solution: &Solution, before: usize, curved: Option<Vec<Vec<DVec2>>>) {
        let Some((problem, lines, _)) = solution.lines() else { return };
        // The module of figures knows pairs alone.
        let (before, curved) = if cfg!(feature = "stack") { (before, curved) } else { (0, None) };
        let [first, second] = problem.outlines();
        let segments: Vec<Vec<DVec2>> =
            lines.iter().map(|line| vec![first.points[line.from], second.points[line.to]]).collect();
        let broken = solution.broken();
        let these = |bad: bool| Path {
            rings: match &curved {
                Some(curved) if !bad => curved.clone(),
                _ => segments
                    .iter()
                    .enumerate()
                    .filter(|&(k, _)| broken.get(k).is_some_and(|&broken| broken) == bad)
                    .map(|(_, segment)| segment.clone())
                    .collect(),
            },
            closed: false,
        };
        if self.shows(LayerName::Value) {
            let values = lines.iter().map(|line| line.value);
            let (low, high) =
                values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), f| (l.min(f), h.max(f)));
            for (line, segment) in lines.iter().zip(&segments) {
                let share = if high > low { (line.value - low) / (high - low) } else { 1.0 };
                let style = StrokeStyle::solid(2.0, viridis(share), 1.0);
                self.stroke("value", Path::open(segment.clone()), style);
            }
        } else if self.shows(LayerName::RulingLines) {
            self.stroke("ruling-lines", these(false), self.inside(self.theme.ruling_line));
        }
        if self.shows(LayerName::RulingLines) {
            self.stroke("broken-lines", these(true), self.theme.error);
        }
        let lifted = self.options.line.and_then(|line| segments.get(line.checked_sub(before)?));
        if let Some(segment) = lifted {
            let miss = |line: &Vec<DVec2>| {
                line[0].distance_squared(segment[0]) + line[line.len() - 1].distance_squared(segment[1])
            };
            let curved = curved.iter().flatten().min_by(|a, b| miss(a).total_cmp(&miss(b)));
            self.cased("line", Path::open(curved.unwrap_or(segment).clone()), self.theme.probe);
        }
    }

    fn boundaries(&mut self) {
        self.stroke("curves", self.outlines.clone(), self.theme.boundary);
    }

    fn samples(&mut self) {
        let samples = self.solution.model.samples();
        if self.shows(LayerName::Normals) {
            let length = NORMAL_LENGTH * self.unit;
            let ends = samples.iter().flat_map(|samples| samples.points.iter().zip(&samples.normals));
            let rings = ends.map(|(&point, &normal)| vec![point, point + length * normal]).collect();
            self.stroke("normals", Path { rings, closed: false }, self.theme.normal);
        }
        let has_samples = !self.solution.model.document().is_harmonic() && !samples.is_empty();
        if self.shows(LayerName::Samples) && !self.is_small && has_samples {
            let dots = Item::Dots {
                centers: samples.iter().flat_map(|samples| &samples.points).copied().collect(),
                radius_px: self.theme.sample_radius,
                color: self.theme.sample,
                opacity: 1.0,
            };
            self.list.push("samples", dots);
        }
    }

    /// Marks what is wrong: vertices without a line, corners of a crossing, places where curves meet.
    fn witnesses(&mut self) {
        let style = StrokeStyle { dash: None, width_px: 2.0, ..self.theme.error };
        self.bare(self.solution, style);
        #[cfg(feature = "stack")]
        for span in self.solution.stack().iter().flat_map(|stack| &stack.spans) {
            self.bare(span, style);
        }
        let fault = match &self.solution.outcome {
            Outcome::Refused(error) => error.at,
            _ => None,
        };
        let mut centers: Vec<DVec2> = fault.into_iter().collect();
        #[cfg(feature = "stack")]
        centers.extend(super::stack::places(self.solution));
        centers.extend(self.solution.diagnostics.iter().find_map(meeting));
        if !centers.is_empty() {
            self.list.push("witness", Item::Crosses { centers, size_px: CROSS_SIZE, style });
        }
    }

    /// Rings round the vertices without a line.
    fn bare(&mut self, solution: &Solution, style: StrokeStyle) {
        if let (Outcome::Matched { matching, is_complete: false, .. }, true) =
            (&solution.outcome, self.shows(LayerName::Unconnected))
        {
            let bare = solution.model.samples().iter().zip(&matching.totals.uncovered);
            let centers: Vec<DVec2> =
                bare.flat_map(|(samples, bare)| bare.iter().map(|&vertex| samples.points[vertex])).collect();
            if !centers.is_empty() {
                self.list.push("unconnected", Item::Rings { centers, radius_px: RING_RADIUS, style });
            }
        }
    }

    fn control_polygons(&mut self) {
        if self.shows(LayerName::ControlPoints) {
            let rings = self.solution.model.curves().iter().map(|curve| curve.points().to_vec()).collect();
            let path = Path { rings, closed: is_closed(self.solution) };
            self.stroke("control-polygons", path, self.theme.control_polygon);
        }
    }
}

/// The place where a remark says that curves or polygons meet.
pub(super) fn meeting(diagnostic: &Diagnostic) -> Option<DVec2> {
    match diagnostic {
        Diagnostic::Crossing { at } => Some(*at),
        Diagnostic::CoarseSampling { at } => *at,
        #[cfg(feature = "harmonic")]
        Diagnostic::CurvesMeet { at, .. }
        | Diagnostic::NoOuter { at, .. }
        | Diagnostic::Nested { at, .. } => Some(*at),
        #[cfg(feature = "harmonic")]
        Diagnostic::NoField { at, .. } => *at,
        _ => None,
    }
}

/// The colours at both ends of a ruling.
fn end_colors(ruling: &Ruling, colors: &[Oklab]) -> [Oklab; 2] {
    ruling.ends.each_ref().map(|end| mix_colors(colors, end))
}

/// The band as a strip of triangles, with the colour of the composition at every end of a ruling.
///
/// Every second ruling serves where there are many: the colour is hardly bent, and the outline cuts the strip to the curves.
pub(super) fn smooth_band(band: &Band, colors: &[Oklab]) -> Mesh {
    let stride = if band.per_line().is_multiple_of(4) { 2 } else { 1 };
    let mut mesh = Mesh::default();
    for ruling in band.rulings().iter().step_by(stride) {
        mesh.vertices.extend([ruling.from, ruling.to]);
        mesh.colors.extend(end_colors(ruling, colors));
    }
    let count = mesh.vertices.len() as u32;
    let end = if band.is_closed() { count } else { count.saturating_sub(2) };
    for this in (0..end).step_by(2) {
        let next = (this + 2) % count;
        mesh.triangles.extend([[this, this + 1, next], [next, this + 1, next + 1]]);
    }
    mesh
}

/// The band as unit cells, each in the one colour of its mean composition.
pub(super) fn flat_cells(band: &Band, stages: usize, colors: &[Oklab]) -> Mesh {
    let mut mesh = Mesh::default();
    for cell in unit_cells(band, stages) {
        let start = mesh.vertices.len() as u32;
        mesh.vertices.extend(cell.corners);
        mesh.colors.extend([mix_colors(colors, &cell.composition); 4]);
        mesh.triangles.extend([[start, start + 1, start + 2], [start, start + 2, start + 3]]);
    }
    mesh
}

/// The band as a strip of triangles with compositions. Rulings nearer to the one before than `step` at both ends are passed over, unless
/// a fraction would change much: hatches are many polygons.
pub(super) fn band_blends(band: &Band, step: f64) -> Blends {
    let mut blends = Blends::default();
    let mut before: Option<&Ruling> = None;
    for ruling in band.rulings() {
        let is_next = before.is_none_or(|last| {
            let far = last.from.distance(ruling.from).max(last.to.distance(ruling.to)) >= step;
            let fractions = |ruling: &Ruling, end: usize| ruling.ends[end].fractions().to_vec();
            let mixed = |end: usize| {
                let pairs = fractions(last, end).into_iter().zip(fractions(ruling, end));
                pairs.fold(0.0_f64, |most, (a, b)| most.max((a - b).abs())) >= MIX_STEP
            };
            far || mixed(0) || mixed(1)
        });
        if is_next {
            blends.vertices.extend([ruling.from, ruling.to]);
            blends.mixes.extend(ruling.ends.iter().cloned());
            before = Some(ruling);
        }
    }
    let count = blends.vertices.len() as u32;
    for this in (0..count).step_by(2) {
        let next = (this + 2) % count;
        blends.triangles.extend([[this, this + 1, next], [next, this + 1, next + 1]]);
    }
    blends
}

/// The band as unit cells, each of its mean composition.
pub(super) fn cell_blends(band: &Band, stages: usize) -> Blends {
    let mut blends = Blends::default();
    for cell in unit_cells(band, stages) {
        let start = blends.vertices.len() as u32;
        blends.vertices.extend(cell.corners);
        blends.mixes.extend(vec![cell.composition; 4]);
        blends.triangles.extend([[start, start + 1, start + 2], [start, start + 2, start + 3]]);
    }
    blends
}
