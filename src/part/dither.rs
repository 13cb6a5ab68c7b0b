//! Fractions as pixels that have one material each.

use super::Raster;
use super::blue_noise::{SIDE, ranks};

/// How fractions become pixels that have one material each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dither {
    /// What a pixel has too much or too little of goes to its neighbours (R. Floyd and L. Steinberg, "An adaptive algorithm for spatial greyscale", 1976), of all
    /// materials together: a pixel gets the one that is wanted most.
    Diffusion,
    /// A mask of thresholds that is repeated every 64 pixels and has no low frequencies (R. Ulichney, "The void-and-cluster method for dither array generation", 1993): each
    /// material has the pixels whose threshold lies in its share of 0 to 1. Where fractions are the same, each tile has each of them exactly, to 1 / 4096.
    BlueNoise,
}

/// A pixel outside of all bodies.
pub(super) const EMPTY: u8 = u8::MAX;

/// The dithering of a raster, row by row from the top.
#[derive(Debug)]
pub(super) struct Dithering {
    kind: Dither,
    materials: usize,
    /// Errors that the rows above left to this row and to the next one, of each material, with a pixel more on each side.
    errors: [Vec<f32>; 2],
}

impl Dithering {
    pub(super) fn new(kind: Dither, materials: usize, width: usize) -> Self {
        let count = if kind == Dither::Diffusion { materials * (width + 2) } else { 0 };
        Self { kind, materials, errors: [vec![0.0; count], vec![0.0; count]] }
    }

    /// The material of each pixel of the next row; [`EMPTY`] outside. No pixel gets a material of which it has nothing.
    pub(super) fn row(&mut self, raster: &Raster, row: usize) -> Vec<u8> {
        match self.kind {
            Dither::Diffusion => self.diffused(raster, row),
            Dither::BlueNoise => masked(raster, row),
        }
    }

    /// Empty pixels take no errors on.
    fn diffused(&mut self, raster: &Raster, row: usize) -> Vec<u8> {
        let nx = raster.frame.size()[0];
        let materials = self.materials;
        let [here, below] = &mut self.errors;
        below.fill(0.0);
        let mut made = Vec::with_capacity(nx);
        for i in 0..nx {
            let at = row * nx + i;
            if raster.body[at] == 0 {
                made.push(EMPTY);
                continue;
            }
            let place = (i + 1) * materials;
            let mut best: Option<(usize, f32)> = None;
            for (k, list) in raster.fractions.iter().enumerate() {
                let wanted = list[at] + here[place + k];
                if list[at] > 0.0 && best.is_none_or(|(_, most)| wanted > most) {
                    best = Some((k, wanted));
                }
            }
            let chosen = best.map_or(0, |(k, _)| k);
            made.push(chosen as u8);
            for (k, list) in raster.fractions.iter().enumerate() {
                let error = list[at] + here[place + k] - if k == chosen { 1.0 } else { 0.0 };
                here[place + materials + k] += error * 7.0 / 16.0;
                below[place - materials + k] += error * 3.0 / 16.0;
                below[place + k] += error * 5.0 / 16.0;
                below[place + materials + k] += error * 1.0 / 16.0;
            }
        }
        self.errors.swap(0, 1);
        made
    }
}

fn masked(raster: &Raster, row: usize) -> Vec<u8> {
    let nx = raster.frame.size()[0];
    let thresholds = &ranks()[row % SIDE * SIDE..][..SIDE];
    let material = |i: usize| {
        let at = row * nx + i;
        if raster.body[at] == 0 {
            return EMPTY;
        }
        let threshold = (f64::from(thresholds[i % SIDE]) + 0.5) / (SIDE * SIDE) as f64;
        let mut sum = 0.0;
        let mut last = 0;
        for (k, list) in raster.fractions.iter().enumerate().filter(|(_, list)| list[at] > 0.0) {
            sum += f64::from(list[at]);
            last = k;
            if threshold < sum {
                break;
            }
        }
        last as u8
    };
    (0..nx).map(material).collect()
}

#[cfg(test)]
mod tests {
    use super::super::Frame;
    use super::*;
    use crate::geom::Bounds;
    use glam::dvec2;

    fn raster(size: [usize; 2], mix: impl Fn(usize, usize) -> Option<[f32; 3]>) -> Raster {
        let frame = Frame::new(Bounds { min: dvec2(0.0, 0.0), max: dvec2(1.0, 1.0) }, size).unwrap();
        let all: Vec<Option<[f32; 3]>> =
            (0..size[0] * size[1]).map(|n| mix(n % size[0], n / size[0])).collect();
        let fractions =
            (0..3).map(|k| all.iter().map(|mix| mix.map_or(0.0, |mix| mix[k])).collect()).collect();
        let body = all.iter().map(|mix| u8::from(mix.is_some())).collect();
        Raster { frame, body, fractions, leaves: vec![0; all.len()] }
    }

    fn dithered(kind: Dither, raster: &Raster) -> Vec<u8> {
        let [nx, ny] = raster.frame.size();
        let mut dithering = Dithering::new(kind, 3, nx);
        (0..ny).flat_map(|row| dithering.row(raster, row)).collect()
    }

    fn counts(made: &[u8]) -> [usize; 3] {
        [0, 1, 2].map(|k| made.iter().filter(|material| **material == k).count())
    }

    /// Any numbers of 4096 pixels.
    #[test]
    fn a_tile_of_blue_noise_has_each_fraction_exactly() {
        for parts in [[0, 1, 4095], [1024, 1024, 2048], [17, 0, 4079], [1333, 2700, 63], [4096, 0, 0]] {
            let even = raster([64, 64], |_, _| Some(parts.map(|part: u16| f32::from(part) / 4096.0)));
            assert_eq!(counts(&dithered(Dither::BlueNoise, &even)), parts.map(usize::from));
        }
    }

    #[test]
    fn errors_that_go_on_keep_the_fractions_of_several_materials_in_the_mean() {
        for mix in [[0.1, 0.2, 0.7], [1.0 / 3.0; 3], [0.02, 0.0, 0.98], [0.5, 0.25, 0.25]] {
            let even = raster([256, 256], |_, _| Some(mix));
            let found = counts(&dithered(Dither::Diffusion, &even)).map(|count| count as f32 / 65_536.0);
            assert!(found.iter().zip(mix).all(|(a, b)| (a - b).abs() < 2e-3), "{found:?} of {mix:?}");
        }
    }

    /// Along a ramp every block of 32 x 32 has the mean of its fractions, as near as its rim allows.
    #[test]
    fn blocks_of_a_gradient_have_their_means() {
        let ramp = raster([256, 64], |x, _| {
            let t = x as f32 / 255.0;
            Some([1.0 - t, t * t, t - t * t])
        });
        for kind in [Dither::Diffusion, Dither::BlueNoise] {
            let made = dithered(kind, &ramp);
            for block in 0..16 {
                let inside = |n: &usize| n % 256 / 32 == block % 8 && n / 256 / 32 == block / 8;
                for k in 0..3 {
                    let at: Vec<usize> = (0..made.len()).filter(inside).collect();
                    let wanted = at.iter().map(|n| ramp.fractions[k][*n]).sum::<f32>() / 1024.0;
                    let found = at.iter().filter(|n| usize::from(made[**n]) == k).count() as f32 / 1024.0;
                    assert!((wanted - found).abs() < 0.025, "{kind:?}, {block}, {k}: {found} of {wanted}");
                }
            }
        }
    }

    #[test]
    fn no_pixel_has_what_it_has_nothing_of_and_outside_there_is_nothing() {
        let halves = raster([60, 40], |x, y| {
            let mix = if x < 30 { [0.6, 0.4, 0.0] } else { [0.0, 0.0, 1.0] };
            (y > 3 && (x + y) % 11 > 0).then_some(mix)
        });
        for kind in [Dither::Diffusion, Dither::BlueNoise] {
            for (at, material) in dithered(kind, &halves).into_iter().enumerate() {
                match halves.body[at] {
                    0 => assert_eq!(material, EMPTY),
                    _ => assert!(halves.fractions[usize::from(material)][at] > 0.0, "{kind:?} at {at}"),
                }
            }
        }
    }
}
