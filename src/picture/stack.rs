//! The picture of a stack: its spans from below, its in-between curves, and its lines.

use super::figure::{Drawing, band_blends, border, cell_blends, flat_cells, meeting, smooth_band};
use super::{Blends, Item, Mesh, Path};
use crate::document::{Diagnostic, LayerName, Solution, Stacked};
use crate::material::mix_colors;
use crate::morph::{Band, StackBlend};
use glam::DVec2;

/// Distance on the curves from one ruling of a hatched band to the next, in CSS pixels.
const RULING_STEP: f64 = 12.0;

/// Strands that a picture shows at most; the others are passed over.
const MOST_STRANDS: usize = 600;

/// A part of a span that is painted at once: its strips, and the outline that cuts them.
struct Piece {
    strips: Vec<Band>,
    outline: Path,
}

impl Drawing<'_> {
    /// Draws all that lies between the curves of a stack.
    pub(super) fn stack(&mut self, stack: &Stacked) {
        let blend = stack.blend.as_ref().filter(|_| stack.is_complete);
        // Many samples on many curves make more strands than a picture can show.
        let thinned =
            blend.filter(|blend| blend.gaps() > MOST_STRANDS).map(|blend| blend.thinned(MOST_STRANDS));
        let shown = thinned.as_ref().or(blend);
        if let (Some(blend), Some(shown)) = (blend, shown) {
            for span in blend.from_below() {
                self.span(if self.shows(LayerName::UnitCells) { blend } else { shown }, span);
            }
            self.stages(shown);
            self.iso_lines(&|material, level| shown.iso_lines(material, level));
        }
        for (span, solution) in stack.spans.iter().enumerate() {
            let curved = blend.filter(|blend| blend.is_cubic()).map(|blend| blend.lines(span));
            self.lines(solution, stack.lines_before(span), curved);
        }
        if let (Some(blend), Some(s)) = (shown, self.options.s) {
            let (span, share) = blend.span_at(s);
            let colors = self.colors();
            let shades =
                || blend.row(span, share).compositions.iter().map(|mix| mix_colors(&colors, mix)).collect();
            self.worn(blend.in_between_at(span, share), blend.is_closed(), shades);
        }
    }

    /// The material of one span.
    fn span(&mut self, blend: &StackBlend, span: usize) {
        let has_cells = self.shows(LayerName::UnitCells);
        if !has_cells && !self.shows(LayerName::Material) {
            return;
        }
        let stages = self.solution.model.document().segments();
        // A strip of a cubic blend is one stage high where it has cells; a linear one is cut into its stages at once.
        let (parts, per_strip) = match blend.is_cubic() {
            true if has_cells => (stages, 1),
            true => (PARTS, 1),
            false => (1, stages),
        };
        let colors = self.colors();
        for Piece { strips, outline } in self.pieces(blend, span, parts) {
            if self.options.patterns {
                let mut blends = Blends::default();
                for strip in &strips {
                    let step = RULING_STEP * self.unit;
                    let own =
                        if has_cells { cell_blends(strip, per_strip) } else { band_blends(strip, step) };
                    let start = blends.vertices.len() as u32;
                    blends.vertices.extend(own.vertices);
                    blends.mixes.extend(own.mixes);
                    blends.triangles.extend(own.triangles.iter().map(|corners| corners.map(|k| start + k)));
                }
                self.hatch(blends, outline);
                continue;
            }
            let mut mesh = Mesh::default();
            for strip in &strips {
                let own = if has_cells {
                    flat_cells(strip, per_strip, &colors)
                } else {
                    smooth_band(strip, &colors)
                };
                let start = mesh.vertices.len() as u32;
                mesh.vertices.extend(own.vertices);
                mesh.colors.extend(own.colors);
                mesh.triangles.extend(own.triangles.iter().map(|corners| corners.map(|k| start + k)));
            }
            self.list.push("material", Item::Mesh { mesh, outline, opacity: 1.0 });
        }
    }

    /// A span in pieces that its outline bounds.
    ///
    /// A level span, and a linear one, lies between its two curves. A cubic one between two heights may bulge beyond both in the projection; so it is painted
    /// by a few strips at a time, with the strip before them underneath, so that nothing shines through where two meet.
    fn pieces(&self, blend: &StackBlend, span: usize, parts: usize) -> Vec<Piece> {
        let at = |part: usize| part as f64 / parts as f64;
        let strips: Vec<Band> = (0..parts).map(|part| blend.strip(span, at(part), at(part + 1))).collect();
        if !blend.is_cubic() || blend.is_level(span) {
            let outline = match strips.first() {
                Some(strip) if !blend.is_closed() => {
                    border(&self.solution.model.curves()[span..=span + 1], strip, self.tolerance)
                }
                _ => Path { rings: self.outlines.rings[span..=span + 1].to_vec(), closed: true },
            };
            return vec![Piece { strips, outline }];
        }
        let group = if parts == PARTS { GROUP } else { 1 };
        (0..parts)
            .step_by(group)
            .map(|part| {
                let first = part.saturating_sub(1);
                let last = parts.min(part + group);
                let near = blend.in_between_at(span, at(first));
                let mut far = blend.in_between_at(span, at(last));
                let outline = if blend.is_closed() {
                    Path { rings: vec![near, far], closed: true }
                } else {
                    far.reverse();
                    Path::closed([near, far].concat())
                };
                Piece { strips: strips[first..last].to_vec(), outline }
            })
            .collect()
    }

    fn stages(&mut self, blend: &StackBlend) {
        if self.shows(LayerName::InBetweens) {
            let segments = self.solution.model.document().segments();
            let inner = blend.stages(segments).filter(|&(_, share)| share > 0.0 && share < 1.0);
            let rings = inner.map(|(span, share)| blend.in_between_at(span, share)).collect();
            let path = Path { rings, closed: blend.is_closed() };
            self.stroke("in-betweens", path, self.inside(self.theme.in_between));
        }
    }
}

/// Parts of a span of a cubic blend, each painted as if it were straight.
const PARTS: usize = 8;
/// Parts that are painted together where a span bulges: over so short a way the outermost rows are its first and its last.
const GROUP: usize = 2;

/// Places at which remarks on a stack point: overlaps, curves out of order, and where curves or polygons of a span meet.
pub(super) fn places(solution: &Solution) -> Vec<DVec2> {
    let place = |diagnostic: &Diagnostic| match diagnostic {
        Diagnostic::Order { at, .. } | Diagnostic::Overlap { at, .. } => Some(*at),
        Diagnostic::InSpan { remark, .. } => meeting(remark),
        _ => None,
    };
    solution.diagnostics.iter().filter_map(place).collect()
}
