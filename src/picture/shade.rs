//! Colours of the pixels of a mesh: the hot loop.
//!
//! Oklab is linear in the cube roots of the cone responses l, m, s, so these are interpolated in place of L, a, b and cubed at each
//! pixel; one matrix leads to linear sRGB and a table to gamma encoded bytes. Matrices: Björn Ottosson, "A perceptual color space
//! for image processing" (2020). The crate palette, the reference in the tests, does the same in more steps.
//!
//! Meshes of smooth figures have triangles of a few pixels, over which the encoded levels are linear to a fraction of a level. Such triangles
//! are filled linearly, with the exact colour at their corners.

use std::ops::RangeInclusive;
use std::sync::LazyLock;

use crate::material::Oklab;

/// Entries of the gamma table, a power of two. The curve climbs 13 levels for each 1/255 near black, where one entry is a fifth of a level;
/// with fewer the rounding of the index would show there.
const GAMMA_ENTRIES: usize = 1 << 14;

/// Steps of the interpolated table of levels: its chords depart from the curve by less than 0.01 level.
const LEVEL_STEPS: usize = 1 << 12;

/// How far levels may depart from linear in the middle of a side of a triangle that is filled linearly. In the middle of the
/// triangle a quadratic then departs by 4/3 of it, so that with rounding no pixel is off by more than one level.
const FLATNESS: f64 = 0.5;

/// Levels between which the gamma curve is gentle: from a linear value of 0.01 to just below the clip at white.
const SMOOTH_LEVELS: RangeInclusive<f64> = 25.0..=254.5;

/// Pixels computed together; wide enough for any SIMD unit that the compiler aims at.
const LANES: usize = 8;

/// From the cone responses to linear red, green and blue.
const TO_LINEAR: [[f32; 3]; 3] = [
    [4.076_741_7, -3.307_711_6, 0.230_969_94],
    [-1.268_438, 2.609_757_4, -0.341_319_38],
    [-0.004_196_086, -0.703_418_6, 1.707_614_7],
];

struct Tables {
    /// Byte for a linear value, rounded to the nearest entry.
    bytes: [u8; GAMMA_ENTRIES],
    /// Level for a linear value, to be interpolated.
    levels: [f32; LEVEL_STEPS + 1],
}

static TABLES: LazyLock<Box<Tables>> = LazyLock::new(|| {
    let mut tables = Box::new(Tables { bytes: [0; GAMMA_ENTRIES], levels: [0.0; LEVEL_STEPS + 1] });
    for (i, entry) in tables.bytes.iter_mut().enumerate() {
        *entry = level(i as f64 / (GAMMA_ENTRIES - 1) as f64).round() as u8;
    }
    for (i, entry) in tables.levels.iter_mut().enumerate() {
        *entry = level(i as f64 / LEVEL_STEPS as f64) as f32;
    }
    tables
});

/// The gamma curve of sRGB (IEC 61966-2-1), from a linear value in 0 to 1 to 0 to 255.
fn level(linear: f64) -> f64 {
    255.0 * if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}

/// Cube roots of the cone responses l, m, s: a linear image of Oklab.
pub(super) type Cones = [f64; 3];

/// The cone roots of a colour.
pub(super) fn cones(color: Oklab) -> Cones {
    let (l, a, b) = (f64::from(color.l), f64::from(color.a), f64::from(color.b));
    [
        l + 0.396_337_777_4 * a + 0.215_803_757_3 * b,
        l - 0.105_561_345_8 * a - 0.063_854_172_8 * b,
        l - 0.089_484_177_5 * a - 1.291_485_548_0 * b,
    ]
}

/// Red, green and blue as shares of 255 levels, gamma encoded and not rounded.
pub(super) type Levels = [f64; 3];

/// Turns cone roots into opaque pixels.
#[derive(Clone, Copy)]
pub(super) struct Shader {
    tables: &'static Tables,
}

impl Shader {
    pub(super) fn new() -> Self {
        Self { tables: &TABLES }
    }

    /// The levels of a colour, clipped to sRGB; within 0.01 of the definition.
    pub(super) fn levels(&self, at: Cones) -> Levels {
        let [l, m, s] = at.map(|root| (root * root * root) as f32);
        TO_LINEAR.map(|[from_l, from_m, from_s]| {
            let linear = from_l * l + from_m * m + from_s * s;
            let place = linear.clamp(0.0, 1.0) * LEVEL_STEPS as f32;
            let index = (place as usize).min(LEVEL_STEPS - 1);
            let (low, high) = (self.tables.levels[index], self.tables.levels[index + 1]);
            f64::from(low + (high - low) * (place - index as f32))
        })
    }

    /// One pixel.
    pub(super) fn pixel(&self, at: Cones) -> [u8; 4] {
        let [r, g, b] = self.levels(at).map(|level| level.round() as u8);
        [r, g, b, 255]
    }

    /// Whether the levels between these corners are near enough to linear for [`flat_span`]: no channel may come near the
    /// ends of its range, where the curve is steep and then cut off, and the middle of each side, where a smooth curve departs most
    /// from its chord, is tried.
    pub(super) fn is_flat(&self, cones: [&Cones; 3], levels: [&Levels; 3]) -> bool {
        levels.iter().all(|levels| levels.iter().all(|level| SMOOTH_LEVELS.contains(level)))
            && [(0, 1), (1, 2), (2, 0)].iter().all(|&(i, j)| {
                let middle = self.levels(std::array::from_fn(|k| (cones[i][k] + cones[j][k]) / 2.0));
                (0..3).all(|k| (middle[k] - (levels[i][k] + levels[j][k]) / 2.0).abs() <= FLATNESS)
            })
    }

    /// A row of pixels: the first has the cone roots `start`, each next one `step` more.
    pub(super) fn span(&self, row: &mut [[u8; 4]], start: [f32; 3], step: [f32; 3]) {
        for (block, pixels) in row.chunks_mut(LANES).enumerate() {
            let first = (block * LANES) as f32;
            let [l, m, s]: [[f32; LANES]; 3] = std::array::from_fn(|i| {
                std::array::from_fn(|lane| {
                    let root = start[i] + step[i] * (first + lane as f32);
                    root * root * root
                })
            });
            let [r, g, b] = TO_LINEAR.map(|[from_l, from_m, from_s]| {
                std::array::from_fn::<_, LANES, _>(|lane| {
                    gamma_index(from_l * l[lane] + from_m * m[lane] + from_s * s[lane])
                })
            });
            for (lane, pixel) in pixels.iter_mut().enumerate() {
                let packed = self.byte(r[lane]) | self.byte(g[lane]) << 8 | self.byte(b[lane]) << 16;
                *pixel = (packed | 0xff00_0000).to_le_bytes();
            }
        }
    }

    fn byte(&self, index: u32) -> u32 {
        self.tables.bytes[index as usize & (GAMMA_ENTRIES - 1)].into()
    }
}

/// Fraction bits of [`flat_span`].
const FIXED_BITS: u32 = 20;

/// Levels as fixed-point numbers for [`flat_span`].
pub(super) fn fixed(levels: Levels) -> [i64; 3] {
    levels.map(|level| (level * (1 << FIXED_BITS) as f64) as i64)
}

/// A row of pixels whose levels are linear: the first has the levels `start`, each next one `step` more, all as fixed-point numbers
/// within 0 to 255 up to rounding.
pub(super) fn flat_span(row: &mut [[u8; 4]], start: [i64; 3], step: [i64; 3]) {
    const HALF: i64 = 1 << (FIXED_BITS - 1);
    const MOST: i64 = (256 << FIXED_BITS) - 1;
    let [mut r, mut g, mut b] = start.map(|level| (level + HALF).clamp(0, MOST) as u32);
    // Steps too large for the type belong to slivers one pixel wide, where they are not used.
    let [dr, dg, db] = step.map(|level| level as u32);
    for pixel in row {
        let packed = r >> FIXED_BITS | g >> FIXED_BITS << 8 | b >> FIXED_BITS << 16;
        *pixel = (packed | 0xff00_0000).to_le_bytes();
        r = r.wrapping_add(dr);
        g = g.wrapping_add(dg);
        b = b.wrapping_add(db);
    }
}

/// The entry for a linear value, clipped to the table and rounded to the nearest.
///
/// Comparisons, unlike `clamp`, become one instruction each; adding 2^23 leaves the whole number in the lowest bits, which
/// is quicker than a cast with its rules for values out of range.
fn gamma_index(linear: f32) -> u32 {
    const MOST: f32 = (GAMMA_ENTRIES - 1) as f32;
    const SHIFT: f32 = (1 << 23) as f32;
    let scaled = linear * MOST;
    let low = if scaled > 0.0 { scaled } else { 0.0 };
    (if low < MOST { low } else { MOST } + SHIFT).to_bits()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::Color;

    #[test]
    fn levels_follow_the_definition() {
        let shader = Shader::new();
        for i in 0..=20_000 {
            let linear = f64::from(i) / 20_000.0;
            let grey = shader.levels([linear.cbrt(); 3]);
            // The rows of the matrix add up to 1 within 1e-6, which the slope near black multiplies by 13 * 255.
            assert!((grey[1] - level(linear)).abs() < 0.015, "{linear}: {} {}", grey[1], level(linear));
        }
    }

    fn apart(pixel: [u8; 4], color: Color) -> u8 {
        pixel[0].abs_diff(color.r).max(pixel[1].abs_diff(color.g)).max(pixel[2].abs_diff(color.b))
    }

    #[test]
    fn every_colour_of_a_coarse_cube_comes_back() {
        let shader = Shader::new();
        for value in (0..0x0100_0000_u32).step_by(1013) {
            let [_, r, g, b] = value.to_be_bytes();
            let color = Color::new(r, g, b);
            let pixel = shader.pixel(cones(color.to_oklab()));
            assert!(apart(pixel, color) <= 1, "{color}: {pixel:?}");
            assert_eq!(pixel[3], 255);
        }
    }

    /// A span between two colours agrees with palette at each pixel, clipped colours included.
    #[test]
    fn spans_agree_with_palette() {
        let shader = Shader::new();
        let pairs =
            [("#f0e442", "#0072b2"), ("#000000", "#ffffff"), ("#00ff00", "#ff00ff"), ("#0000ff", "#ffff00")];
        for (from, to) in pairs {
            let (from, to) = (Color::parse(from).unwrap().to_oklab(), Color::parse(to).unwrap().to_oklab());
            for count in [1_usize, 2, 7, 8, 9, 100] {
                let (a, b) = (cones(from), cones(to));
                let step = std::array::from_fn(|i| ((b[i] - a[i]) / count as f64) as f32);
                let mut row = vec![[0; 4]; count];
                shader.span(&mut row, a.map(|v| v as f32), step);
                for (i, &pixel) in row.iter().enumerate() {
                    let expected = from.lerp(to, i as f32 / count as f32).to_color();
                    assert!(apart(pixel, expected) <= 1, "{i} of {count}: {pixel:?}, expected {expected}");
                }
            }
        }
    }
}
