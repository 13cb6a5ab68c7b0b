//! The picture of a harmonic blend: its composition or its difference from the ruled one, level curves of the potential, lines along its gradient.

use super::figure::Drawing;
use super::{Blends, Item, Mesh, Path};
use crate::document::{Difference, Harmonic, LayerName};
use crate::material::{Composition, Oklab, mix_fractions, viridis};
use crate::morph::HarmonicBlend;
use glam::DVec2;

impl Drawing<'_> {
    /// Draws all that lies between the curves of a harmonic blend.
    pub(super) fn harmonic(&mut self, harmonic: &Harmonic) {
        let blend = &harmonic.blend;
        let difference = harmonic.difference.as_ref().filter(|_| self.shows(LayerName::Difference));
        match difference {
            Some(difference) if !difference.values.is_empty() => self.differing(blend, difference),
            _ => self.blended(blend),
        }
        if self.shows(LayerName::InBetweens) {
            let rings = blend.levels().concat();
            self.stroke("in-betweens", Path { rings, closed: true }, self.inside(self.theme.in_between));
        }
        self.iso_lines(&|material, level| blend.iso_lines(material, level));
        if self.shows(LayerName::RulingLines) || self.shows(LayerName::Value) {
            let rings = blend.lines().iter().map(|line| line.points.clone()).collect();
            self.stroke("ruling-lines", Path { rings, closed: false }, self.inside(self.theme.ruling_line));
        }
        if let Some(line) = self.options.line.and_then(|line| blend.lines().get(line)) {
            self.cased("line", Path::open(line.points.clone()), self.theme.probe);
        }
        if let Some(s) = self.options.s.filter(|s| *s > 0.0 && *s < 1.0) {
            for ring in blend.level(s) {
                let colors = self.colors();
                let shades = || {
                    let of = |point: &DVec2| {
                        let place = blend.locate(*point);
                        place.map_or(colors[0], |place| mix_fractions(&colors, place.composition.fractions()))
                    };
                    ring.iter().map(of).collect()
                };
                self.worn(ring.clone(), true, shades);
            }
        }
    }

    /// The composition.
    fn blended(&mut self, blend: &HarmonicBlend) {
        // The blend has no cells: it is shown smoothly in their place.
        if !self.shows(LayerName::Material) && !self.shows(LayerName::UnitCells) {
            return;
        }
        let field = blend.field();
        let count = field.points.len();
        if self.options.patterns {
            let mixes = (0..count).map(|k| Composition::rounded(field.at(k)[1..].to_vec())).collect();
            let blends = Blends { vertices: field.points.clone(), mixes, triangles: field.triangles.clone() };
            self.hatch(blends, self.outlines.clone());
            return;
        }
        let colors = self.colors();
        let shade = |k: usize| mix_fractions(&colors, &field.at(k)[1..]);
        self.filled("material", blend, (0..count).map(shade).collect());
    }

    /// How far the blend is from the ruled one, from nothing to the largest difference.
    fn differing(&mut self, blend: &HarmonicBlend, difference: &Difference) {
        let whole = difference.largest.max(f64::MIN_POSITIVE);
        let shades = difference.values.iter().map(|value| viridis(value / whole).to_oklab()).collect();
        self.filled("difference", blend, shades);
    }

    fn filled(&mut self, layer: &str, blend: &HarmonicBlend, colors: Vec<Oklab>) {
        let field = blend.field();
        let mesh = Mesh { vertices: field.points.clone(), colors, triangles: field.triangles.clone() };
        self.list.push(layer, Item::Mesh { mesh, outline: self.outlines.clone(), opacity: 1.0 });
    }
}
