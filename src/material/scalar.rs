//! Colours of scalars.

use super::Color;

/// The colour of a scalar on the map viridis (Stéfan van der Walt and Nathaniel Smith, 2015): dark violet at 0, yellow at 1.
/// Values outside are clamped; a value that is not a number counts as 0.
#[must_use]
pub fn viridis(value: f64) -> Color {
    let value = if value.is_nan() { 0.0 } else { value.clamp(0.0, 1.0) };
    let color = colorous::VIRIDIS.eval_continuous(value);
    Color::new(color.r, color.g, color.b)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ends and middle as published with matplotlib.
    #[test]
    fn known_colours() {
        assert_eq!(viridis(0.0).to_string(), "#440154");
        assert_eq!(viridis(1.0).to_string(), "#fde725");
        let middle = viridis(0.5);
        assert!(middle.r.abs_diff(0x21) <= 1 && middle.g.abs_diff(0x91) <= 1 && middle.b.abs_diff(0x8c) <= 1);
    }

    #[test]
    fn lightness_rises_and_odd_values_are_clamped() {
        let light: Vec<f32> = (0..=64).map(|i| viridis(f64::from(i) / 64.0).to_oklab().l).collect();
        assert!(light.windows(2).all(|pair| pair[1] > pair[0]));
        assert_eq!(viridis(f64::NAN), viridis(0.0));
        assert_eq!(viridis(f64::INFINITY), viridis(1.0));
        assert_eq!(viridis(-3.0), viridis(0.0));
    }
}
