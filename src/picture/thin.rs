//! Thin lines and dots: coverage from the distance to the line.
//!
//! A figure has hundreds of curve pieces a few pixels long. Outlining and supersampling them, as the general rasteriser does, took more than
//! twice as long as measuring the distance of each nearby pixel to each piece. Joins and ends come out round, pieces that meet or cross are
//! united (the largest coverage counts), so a translucent line has no darker joints, and a closed line has no seam.

use std::ops::Range;

use glam::{DVec2, Vec2};

/// Lines up to this width are drawn here, in device pixels. The cost of a piece grows with the square of the width, so that wider lines
/// are better outlined.
pub(super) const WIDEST: f32 = 12.0;

/// Pixels looked at together for one that is covered.
const BLOCK: usize = 32;

/// Half the diagonal of a pixel.
const HALF_DIAGONAL: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Coverage of the pixels of a picture, empty between two uses.
pub(super) struct ThinLines {
    width: usize,
    coverage: Vec<u8>,
    /// Rows that may be covered.
    rows: Range<usize>,
}

impl ThinLines {
    /// For pictures of the given size.
    pub(super) fn new(width: u32, height: u32) -> Self {
        let (width, height) = (width as usize, height as usize);
        Self { width, coverage: vec![0; width * height], rows: height..0 }
    }

    /// Adds the pixels within half the width of the segment; `a` may equal `b`. Both must be near the picture.
    pub(super) fn add(&mut self, a: DVec2, b: DVec2, width: f32) {
        let height = self.coverage.len() / self.width;
        let reach = f64::from(width) / 2.0 + HALF_DIAGONAL;
        let (low, high) = (a.min(b) - reach, a.max(b) + reach);
        let rows = pixels(low.y, high.y, height);
        let length = a.distance(b);
        let along = if length > 0.0 { (b - a) / length } else { DVec2::X };
        // Where the strip of all points within reach of the line crosses a row of centres.
        let half_run = if along.y.abs() > 1e-9 { reach / along.y.abs() } else { f64::INFINITY };
        let profile = Profile::new(along.as_vec2(), length as f32, width);
        for y in rows.clone() {
            let center_y = y as f64 + 0.5;
            let (left, right) = if half_run.is_finite() {
                let middle = a.x + (center_y - a.y) * along.x / along.y;
                (low.x.max(middle - half_run), high.x.min(middle + half_run))
            } else {
                (low.x, high.x)
            };
            let columns = pixels(left, right, self.width);
            let from_a = DVec2::new(columns.start as f64 + 0.5 - a.x, center_y - a.y).as_vec2();
            let row = &mut self.coverage[y * self.width..(y + 1) * self.width];
            for (i, value) in row[columns].iter_mut().enumerate() {
                *value = profile.coverage(from_a + Vec2::new(i as f32, 0.0)).max(*value);
            }
        }
        if !rows.is_empty() {
            self.rows = self.rows.start.min(rows.start)..self.rows.end.max(rows.end);
        }
    }

    /// Hands each covered pixel to `paint`, as its index and coverage, and empties the coverage.
    pub(super) fn drain(&mut self, mut paint: impl FnMut(usize, u8)) {
        let first = self.rows.start * self.width;
        let end = (self.rows.end * self.width).max(first);
        for (block, covers) in self.coverage[first..end].chunks_mut(BLOCK).enumerate() {
            if !is_clear(covers) {
                for (i, cover) in covers.iter_mut().enumerate().filter(|(_, cover)| **cover > 0) {
                    paint(first + block * BLOCK + i, *cover);
                    *cover = 0;
                }
            }
        }
        self.rows = self.coverage.len() / self.width..0;
    }
}

/// Whether nothing is covered. Without early end, which lets the compiler look at many at once.
pub(super) fn is_clear(covers: &[u8]) -> bool {
    covers.iter().fold(0, |all, cover| all | cover) == 0
}

/// A segment of a given width.
struct Profile {
    along: Vec2,
    length: f32,
    half_width: f32,
    pixel: Pixel,
}

/// A unit square seen along a line: how its area is spread across that line.
///
/// The spread is the convolution of two boxes, as wide as the normal's coordinates.
#[derive(Clone, Copy)]
struct Pixel {
    /// Half the width where the spread is even, then half the whole width.
    inner: f32,
    outer: f32,
    /// The height of the even part.
    height: f32,
    /// Scale of the parabolas at both ends.
    bend: f32,
}

impl Profile {
    fn new(along: Vec2, length: f32, width: f32) -> Self {
        Self { along, length, half_width: width / 2.0, pixel: Pixel::facing(along) }
    }

    /// How much of a pixel the segment covers; the place is relative to its start. Exact beside the segment, where it reaches far enough
    /// both ways; at the ends the round border is taken as straight over a pixel.
    fn coverage(&self, place: Vec2) -> u8 {
        let t = self.along.dot(place);
        let beyond = if t < 0.0 {
            t
        } else if t > self.length {
            t - self.length
        } else {
            0.0
        };
        let across = self.along.perp_dot(place).abs();
        if beyond == 0.0 && across >= self.half_width + self.pixel.outer {
            return 0;
        }
        let (distance, pixel) = if beyond == 0.0 {
            (across, self.pixel)
        } else {
            let distance = (across * across + beyond * beyond).sqrt();
            let end = if t < 0.0 { 0.0 } else { self.length };
            (distance, Pixel::facing((place - self.along * end) / distance))
        };
        let share = pixel.inside(self.half_width + distance) - pixel.inside(distance - self.half_width);
        (share * 255.0 + 0.5) as u8
    }
}

impl Pixel {
    /// Seen along a unit vector or across it, which is the same.
    fn facing(direction: Vec2) -> Self {
        let direction = direction.abs();
        let (a, b) = (direction.max_element(), direction.min_element());
        // Without a slope there are no parabolas, and their scale does not matter.
        let bend = if b > 0.0 { 0.5 / (a * b) } else { 0.0 };
        Self { inner: (a - b) / 2.0, outer: (a + b) / 2.0, height: 1.0 / a, bend }
    }

    /// The area on one side of a line at the given distance, 1 when the line is far on the other side.
    fn inside(self, distance: f32) -> f32 {
        let away = distance.abs();
        let half = if away >= self.outer {
            0.5
        } else if away <= self.inner {
            away * self.height
        } else {
            0.5 - (self.outer - away) * (self.outer - away) * self.bend
        };
        0.5 + half.copysign(distance)
    }
}

/// The pixels with centres between two coordinates, of a side of the picture.
fn pixels(low: f64, high: f64, side: usize) -> Range<usize> {
    let clip = |v: f64| (v - 0.5).ceil().clamp(0.0, side as f64) as usize;
    let (first, end) = (clip(low), clip(high));
    first..end.max(first)
}

#[cfg(test)]
mod tests {
    use super::*;

    type Place = (f64, f64);

    fn coverage(segments: &[(Place, Place)], width: f32) -> Vec<u8> {
        let mut lines = ThinLines::new(32, 32);
        for &(a, b) in segments {
            lines.add(a.into(), b.into(), width);
        }
        let mut found = vec![0; 32 * 32];
        lines.drain(|i, cover| found[i] = cover);
        lines.drain(|i, _| panic!("pixel {i} was left"));
        found
    }

    #[test]
    fn upright_and_level_lines_cover_exactly() {
        let found = coverage(&[((8.0, 16.25), (24.0, 16.25))], 1.0);
        let column: Vec<u8> = (14..19).map(|y| found[y * 32 + 16]).collect();
        assert_eq!(column, [0, 64, 191, 0, 0]);
        let found = coverage(&[((16.5, 24.0), (16.5, 8.0))], 3.0);
        let row: Vec<u8> = (13..20).map(|x| found[16 * 32 + x]).collect();
        assert_eq!(row, [0, 0, 255, 255, 255, 0, 0]);
        let found = coverage(&[((8.0, 16.5), (24.0, 16.5))], 0.5);
        assert_eq!(found[16 * 32 + 16], 128);
    }

    /// The sum of the coverage is the area of the line with its round ends, whatever its direction.
    #[test]
    fn the_area_is_right_in_every_direction() {
        for i in 0..48 {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 48.0).sin_cos();
            for (width, length) in [(1.0_f32, 20.0), (2.0, 20.0), (4.5, 16.0), (0.75, 20.0)] {
                let (dx, dy) = (cos * length / 2.0, sin * length / 2.0);
                let found = coverage(&[((16.0 - dx, 16.0 - dy), (16.0 + dx, 16.0 + dy))], width);
                let sum: f64 = found.iter().map(|&c| f64::from(c) / 255.0).sum();
                let radius = f64::from(width) / 2.0;
                let area = 2.0 * radius * length + std::f64::consts::PI * radius * radius;
                // The profile is that of a facing pixel; ends of thin lines are rounded to whole distances.
                assert!(
                    (sum - area).abs() < 0.035 * area + 0.35,
                    "{i}, width {width}: {sum}, expected {area}"
                );
            }
        }
    }

    #[test]
    fn pieces_unite_without_joints() {
        let whole = coverage(&[((4.0, 9.0), (28.0, 21.0))], 1.5);
        let parts = coverage(&[((4.0, 9.0), (16.0, 15.0)), ((28.0, 21.0), (16.0, 15.0))], 1.5);
        assert!(whole.iter().zip(&parts).all(|(a, b)| a.abs_diff(*b) <= 1));
    }

    #[test]
    fn dots_are_discs_and_far_lines_are_nothing() {
        let disc = coverage(&[((16.0, 16.0), (16.0, 16.0))], 8.0);
        let sum: f64 = disc.iter().map(|&c| f64::from(c) / 255.0).sum();
        assert!((sum - std::f64::consts::PI * 16.0).abs() < 0.5, "{sum}");
        assert!(coverage(&[((-50.0, -50.0), (-40.0, 90.0))], 3.0).iter().all(|&c| c == 0));
        assert!(
            coverage(&[((-500.0, 16.5), (500.0, 16.5))], 1.0)[16 * 32..17 * 32].iter().all(|&c| c == 255)
        );
    }
}
