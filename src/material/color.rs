//! Display colours: sRGB in eight bits, and Oklab for mixing.

use std::error::Error;
use std::fmt;

use palette::{FromColor, IntoColor, Srgb};

/// An opaque sRGB colour with eight bits for each channel, gamma encoded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Color {
    /// Red.
    pub r: u8,
    /// Green.
    pub g: u8,
    /// Blue.
    pub b: u8,
}

/// A colour in Oklab (Björn Ottosson, "A perceptual color space for image processing", 2020), relative to D65.
///
/// A difference of about 0.02 between two colours side by side is just visible.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oklab {
    /// Lightness, 0 (black) to 1 (white).
    pub l: f32,
    /// Green (negative) to red (positive).
    pub a: f32,
    /// Blue (negative) to yellow (positive).
    pub b: f32,
}

/// Why a text is not a colour.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ColorError {
    /// The text that was given.
    pub text: String,
}

impl fmt::Display for ColorError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\"{}\" was found; expected # and six hexadecimal digits, such as #0072b2", self.text)
    }
}

impl Error for ColorError {}

impl Color {
    /// Makes a colour from its three channels.
    #[must_use]
    pub const fn new(r: u8, g: u8, b: u8) -> Self {
        Self { r, g, b }
    }

    /// Reads `#rrggbb`; digits of either case.
    ///
    /// # Errors
    /// Any other text, including the short form `#rgb` and names.
    pub fn parse(text: &str) -> Result<Self, ColorError> {
        let refuse = || ColorError { text: text.to_owned() };
        let digits = text.strip_prefix('#').ok_or_else(refuse)?;
        if digits.len() != 6 || !digits.bytes().all(|b| b.is_ascii_hexdigit()) {
            return Err(refuse());
        }
        let value = u32::from_str_radix(digits, 16).map_err(|_| refuse())?;
        let [_, r, g, b] = value.to_be_bytes();
        Ok(Self { r, g, b })
    }

    /// The same colour in Oklab.
    #[must_use]
    pub fn to_oklab(self) -> Oklab {
        let srgb: Srgb<f32> = Srgb::new(self.r, self.g, self.b).into_format();
        let lab: palette::Oklab = srgb.into_color();
        Oklab { l: lab.l, a: lab.a, b: lab.b }
    }
}

impl fmt::Display for Color {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{:02x}{:02x}{:02x}", self.r, self.g, self.b)
    }
}

impl Oklab {
    /// The nearest eight-bit colour, each linear channel clipped to the range of sRGB.
    #[must_use]
    pub fn to_color(self) -> Color {
        let srgb = Srgb::from_color(palette::Oklab::new(self.l, self.a, self.b));
        let bytes: Srgb<u8> = srgb.into_format();
        Color { r: bytes.red, g: bytes.green, b: bytes.blue }
    }

    /// The colour a fraction `t` of the way to `other`.
    #[must_use]
    pub fn lerp(self, other: Self, t: f32) -> Self {
        Self {
            l: self.l + (other.l - self.l) * t,
            a: self.a + (other.a - self.a) * t,
            b: self.b + (other.b - self.b) * t,
        }
    }

    /// Euclidean distance in Oklab.
    #[must_use]
    pub fn distance(self, other: Self) -> f32 {
        let (l, a, b) = (self.l - other.l, self.a - other.a, self.b - other.b);
        (l * l + a * a + b * b).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_round_trip() {
        for text in ["#000000", "#ffffff", "#0072b2", "#f0e442"] {
            assert_eq!(Color::parse(text).unwrap().to_string(), text);
        }
        assert_eq!(Color::parse("#ABCDEF").unwrap(), Color::new(0xab, 0xcd, 0xef));
    }

    #[test]
    fn other_texts_are_refused() {
        for text in ["", "#", "#fff", "0072b2", "#0072b", "#0072b2f", "#+12345", "#é2345", "red", " #0072b2"]
        {
            let error = Color::parse(text).unwrap_err();
            assert!(error.to_string().contains("six hexadecimal digits"), "{text}");
        }
    }

    /// Reference values published with the definition of Oklab: white is (1, 0, 0), black is 0, and the lightness of a
    /// grey is the cube root of its linear value.
    #[test]
    fn oklab_of_known_colours() {
        let white = Color::new(255, 255, 255).to_oklab();
        assert!((white.l - 1.0).abs() < 1e-4 && white.a.abs() < 1e-4 && white.b.abs() < 1e-4);
        let linear = ((128.0_f64 / 255.0 + 0.055) / 1.055).powf(2.4);
        let grey = Color::new(128, 128, 128).to_oklab();
        assert!((f64::from(grey.l) - linear.cbrt()).abs() < 1e-4);
        let red = Color::new(255, 0, 0).to_oklab();
        assert!((red.l - 0.628).abs() < 1e-3 && (red.a - 0.225).abs() < 1e-3 && (red.b - 0.126).abs() < 1e-3);
    }

    #[test]
    fn round_trip_through_oklab_is_exact() {
        for value in (0..0x0100_0000_u32).step_by(4099) {
            let [_, r, g, b] = value.to_be_bytes();
            let color = Color { r, g, b };
            assert_eq!(color.to_oklab().to_color(), color);
        }
    }

    #[test]
    fn colours_outside_srgb_are_clipped() {
        assert_eq!(Oklab { l: 2.0, a: 0.0, b: 0.0 }.to_color(), Color::new(255, 255, 255));
        assert_eq!(Oklab { l: -1.0, a: 0.0, b: 0.0 }.to_color(), Color::new(0, 0, 0));
    }
}
