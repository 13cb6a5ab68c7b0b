//! Colours and strokes of figures, light and dark.

use super::StrokeStyle;
use crate::material::Color;

const WHITE: Color = Color::new(0xff, 0xff, 0xff);
const BLACK: Color = Color::new(0, 0, 0);
const INK: Color = Color::new(0x10, 0x12, 0x16);

/// A line drawn over a wider one, so that it shows on every colour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cased {
    /// The wider line below.
    pub halo: StrokeStyle,
    /// The line itself.
    pub line: StrokeStyle,
}

/// Colours and strokes of a figure. Material colours are data and not part of it; the strokes that lie on the material
/// band are the same in both themes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Theme {
    /// Behind the figure.
    pub canvas: Color,
    /// Grid lines at the minor step.
    pub grid_minor: StrokeStyle,
    /// Grid lines at the major step.
    pub grid_major: StrokeStyle,
    /// In-between curves.
    pub in_between: StrokeStyle,
    /// Lines of equal fraction of a material, at every second tenth.
    pub iso: StrokeStyle,
    /// Lines of equal fraction at the tenths between.
    pub iso_minor: StrokeStyle,
    /// Ruling lines.
    pub ruling_line: StrokeStyle,
    /// The in-between curve at the current s.
    pub current: Cased,
    /// Boundary curves.
    pub boundary: StrokeStyle,
    /// Colour of the sample dots.
    pub sample: Color,
    /// Radius of the sample dots in CSS pixels.
    pub sample_radius: f32,
    /// The probed ruling line.
    pub probe: Cased,
    /// Radius of the ring at the probed point, in CSS pixels.
    pub probe_radius: f32,
    /// Blocked and crossing lines, rings round uncovered vertices, witness crosses.
    pub error: StrokeStyle,
    /// Control polygons.
    pub control_polygon: StrokeStyle,
    /// Normals at the samples.
    pub normal: StrokeStyle,
}

impl Theme {
    /// Dark ink on white.
    #[must_use]
    pub const fn light() -> Self {
        let line = Color::new(0xe2, 0xe3, 0xe7);
        let ink = Color::new(0x17, 0x19, 0x1d);
        let error = Color::new(0xb3, 0x26, 0x1e);
        Self::build(
            WHITE,
            (line, 0.45, 1.0),
            ink,
            error,
            Color::new(0x6a, 0x70, 0x7c),
            Color::new(0x58, 0x5d, 0x68),
        )
    }

    /// Light ink on near black.
    #[must_use]
    pub const fn dark() -> Self {
        let line = Color::new(0x28, 0x2b, 0x31);
        let ink = Color::new(0xf3, 0xf4, 0xf7);
        let error = Color::new(0xff, 0x8d, 0x85);
        Self::build(
            Color::new(0x0e, 0x0f, 0x12),
            (line, 0.38, 0.9),
            ink,
            error,
            Color::new(0x8c, 0x92, 0x9e),
            Color::new(0xa3, 0xa8, 0xb4),
        )
    }

    /// The same theme for small pictures: thinner boundary and ruling lines, smaller dots.
    #[must_use]
    pub const fn compact(mut self) -> Self {
        self.boundary.width_px = 1.5;
        self.ruling_line.width_px = 0.6;
        self.sample_radius = 1.5;
        self
    }

    const fn build(
        canvas: Color,
        (grid, minor, major): (Color, f32, f32),
        ink: Color,
        error: Color,
        polygon: Color,
        normal: Color,
    ) -> Self {
        let halo = StrokeStyle::solid(4.5, WHITE, 0.9);
        Self {
            canvas,
            grid_minor: StrokeStyle::solid(1.0, grid, minor),
            grid_major: StrokeStyle::solid(1.0, grid, major),
            in_between: StrokeStyle::solid(1.0, WHITE, 0.8),
            iso: StrokeStyle::solid(1.0, BLACK, 0.55),
            iso_minor: StrokeStyle::solid(0.75, BLACK, 0.3),
            ruling_line: StrokeStyle::solid(0.75, INK, 0.5),
            current: Cased { halo, line: StrokeStyle::solid(1.75, INK, 1.0) },
            boundary: StrokeStyle::solid(2.0, ink, 1.0),
            sample: ink,
            sample_radius: 1.9,
            probe: Cased { halo, line: StrokeStyle::solid(2.0, INK, 1.0) },
            probe_radius: 3.5,
            error: StrokeStyle::solid(1.25, error, 1.0).dashed(4.0, 3.0),
            control_polygon: StrokeStyle::solid(1.0, polygon, 0.75).dashed(2.0, 4.0),
            normal: StrokeStyle::solid(1.0, normal, 0.9),
        }
    }
}
