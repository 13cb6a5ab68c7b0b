//! Colours of many compositions.

use crate::material::Oklab;
use std::sync::OnceLock;

/// Steps of the table of linear light: the steepest step is 0.2 of one of 255.
const LEVELS: usize = 16_384;

/// Colours of materials, mixed in Oklab as [`mix_fractions`](crate::material::mix_fractions) mixes them, with a table in the place of powers.
#[derive(Debug, Clone, PartialEq)]
pub struct Palette(Vec<[f32; 3]>);

impl Palette {
    /// The colours of all materials.
    #[must_use]
    pub fn new(colors: &[Oklab]) -> Self {
        Self(colors.iter().map(|color| [color.l, color.a, color.b]).collect())
    }

    /// The sRGB bytes of a mixture, within 1 of the exact ones. Each linear channel is clipped.
    ///
    /// The matrices are those of B. Ottosson, "A perceptual color space for image processing" (2020).
    pub fn color(&self, fractions: impl Iterator<Item = f32>) -> [u8; 3] {
        let mut lab = [0.0_f32; 3];
        for (fraction, color) in fractions.zip(&self.0) {
            lab.iter_mut().zip(color).for_each(|(sum, part)| *sum += fraction * part);
        }
        let [l, a, b] = lab;
        let cube = |x: f32| x * x * x;
        let l_ = cube(l + 0.396_337_78 * a + 0.215_803_76 * b);
        let m_ = cube(l - 0.105_561_346 * a - 0.063_854_17 * b);
        let s_ = cube(l - 0.089_484_18 * a - 1.291_485_5 * b);
        let linear = [
            4.076_741_7 * l_ - 3.307_711_6 * m_ + 0.230_969_94 * s_,
            -1.268_438 * l_ + 2.609_757_4 * m_ - 0.341_319_38 * s_,
            -0.004_196_086_3 * l_ - 0.703_418_6 * m_ + 1.707_614_7 * s_,
        ];
        let table = table();
        linear.map(|x| table[(x.clamp(0.0, 1.0) * (LEVELS - 1) as f32 + 0.5) as usize])
    }
}

/// sRGB bytes of linear light.
fn table() -> &'static [u8] {
    static TABLE: OnceLock<Vec<u8>> = OnceLock::new();
    TABLE.get_or_init(|| {
        let encoded = |n: usize| {
            let x = n as f64 / (LEVELS - 1) as f64;
            let y = if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 };
            (255.0 * y).round() as u8
        };
        (0..LEVELS).map(encoded).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::{Color, mix_fractions};

    #[test]
    fn colours_are_those_of_the_exact_mixture() {
        let colors = [Color::new(240, 228, 66), Color::new(0, 0, 0), Color::new(0, 114, 178)];
        let labs = colors.map(Color::to_oklab);
        let palette = Palette::new(&labs);
        for i in 0..=20_u8 {
            for j in 0..=20 - i {
                let mix = [i, j, 20 - i - j].map(|part| f64::from(part) / 20.0);
                let exact = mix_fractions(&labs, &mix).to_color();
                let found = palette.color(mix.iter().map(|part| *part as f32));
                for (a, b) in found.into_iter().zip([exact.r, exact.g, exact.b]) {
                    assert!(a.abs_diff(b) <= 1, "{mix:?}: {found:?} and {exact}");
                }
            }
        }
        for (k, color) in colors.iter().enumerate() {
            let pure = palette.color((0..3).map(|n| if n == k { 1.0 } else { 0.0 }));
            assert_eq!(pure, [color.r, color.g, color.b]);
        }
    }
}
