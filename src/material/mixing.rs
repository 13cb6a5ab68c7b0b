//! Materials and the display colour of their mixtures.

use super::{Color, Composition, Oklab};

/// A material of a document.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Material {
    /// Name, as the document gives it.
    pub name: String,
    /// Display colour of the pure material.
    pub color: Color,
    /// Whether the material stands for empty space.
    pub void: bool,
}

/// The display colour of a mixture: the mean of the material colours in Oklab, weighted by volume fraction.
///
/// Linear in the fractions, so that colours may be interpolated where fractions are. It pictures a mixture; it does not
/// predict how a real one looks.
///
/// # Panics
/// When the numbers of colours and of fractions differ.
#[must_use]
pub fn mix_colors(colors: &[Oklab], composition: &Composition) -> Oklab {
    mix_fractions(colors, composition.fractions())
}

/// As [`mix_colors`], for fractions that come from compositions.
///
/// # Panics
/// When the numbers of colours and of fractions differ.
#[must_use]
pub fn mix_fractions(colors: &[Oklab], fractions: &[f64]) -> Oklab {
    assert_eq!(colors.len(), fractions.len(), "one colour for each fraction");
    let start = Oklab { l: 0.0, a: 0.0, b: 0.0 };
    colors.iter().zip(fractions).fold(start, |sum, (color, &fraction)| {
        let weight = fraction as f32;
        Oklab { l: sum.l + color.l * weight, a: sum.a + color.a * weight, b: sum.b + color.b * weight }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pure_materials_keep_their_colour() {
        let colors = [Color::new(240, 228, 66), Color::new(0, 158, 115), Color::new(0, 114, 178)];
        let labs = colors.map(Color::to_oklab);
        for (i, &color) in colors.iter().enumerate() {
            assert_eq!(mix_colors(&labs, &Composition::pure(i, 3)).to_color(), color);
        }
    }

    /// Black and white in equal parts: lightness one half, and the linear grey is its cube, 1/8.
    #[test]
    fn half_black_half_white() {
        let labs = [Color::new(0, 0, 0).to_oklab(), Color::new(255, 255, 255).to_oklab()];
        let half = mix_colors(&labs, &Composition::new(vec![0.5, 0.5]).unwrap()).to_color();
        let expected = (1.055 * 0.125_f64.powf(1.0 / 2.4) - 0.055) * 255.0;
        for channel in [half.r, half.g, half.b] {
            assert!((f64::from(channel) - expected).abs() <= 1.0, "{channel}, expected {expected}");
        }
    }
}
