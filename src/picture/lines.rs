//! Lines, dashes and dots: coverage from the distance to the line.
//!
//! A figure has hundreds of curve pieces a few pixels long. Outlining and filling them, as a general rasteriser does, took more than
//! twice as long as measuring the distance of each nearby pixel to each piece. Joins and ends come out round, pieces that meet or cross are
//! united (the largest coverage counts), so a translucent line has no darker joints, and a closed line has no seam. The cost of a piece grows
//! with its length times its width, and for short pieces with the square of the width.

use std::ops::Range;

use glam::{DVec2, Vec2};

use super::dash::Stretch;

/// Pixels looked at together for one that is covered.
const BLOCK: usize = 32;

/// Half the diagonal of a pixel.
const HALF_DIAGONAL: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Coverage of some rows of a picture, empty between two uses.
pub(super) struct Lines {
    width: usize,
    rows: Range<usize>,
    coverage: Vec<u8>,
    /// Rows that may be covered.
    touched: Range<usize>,
}

impl Lines {
    /// For some rows of a picture of the given width.
    pub(super) fn new(width: usize, rows: Range<usize>) -> Self {
        let coverage = vec![0; width * rows.len()];
        Self { width, touched: rows.end..rows.start, rows, coverage }
    }

    /// Adds the pixels within half the width of a stretch of a line, a dot when it has no length. It must be near the picture.
    pub(super) fn add(&mut self, stretch: &Stretch, width: f32) {
        let Stretch { from: a, to: b, .. } = *stretch;
        let reach = f64::from(width) / 2.0 + HALF_DIAGONAL;
        let (low, high) = (a.min(b) - reach, a.max(b) + reach);
        let rows = pixels(low.y, high.y, &self.rows);
        if rows.is_empty() {
            return;
        }
        let length = a.distance(b);
        let along = if length > 0.0 { (b - a) / length } else { DVec2::X };
        // Where the strip of all points within reach of the line crosses a row of centres.
        let half_run = if along.y.abs() > 1e-9 { reach / along.y.abs() } else { f64::INFINITY };
        let profile = Profile::new(along.as_vec2(), length as f32, width, stretch.is_cut);
        for y in rows.clone() {
            let center_y = y as f64 + 0.5;
            let (left, right) = if half_run.is_finite() {
                let middle = a.x + (center_y - a.y) * along.x / along.y;
                (low.x.max(middle - half_run), high.x.min(middle + half_run))
            } else {
                (low.x, high.x)
            };
            let columns = pixels(left, right, &(0..self.width));
            let from_a = DVec2::new(columns.start as f64 + 0.5 - a.x, center_y - a.y).as_vec2();
            let start = (y - self.rows.start) * self.width;
            let row = &mut self.coverage[start..start + self.width];
            for (i, value) in row[columns].iter_mut().enumerate() {
                *value = profile.coverage(from_a + Vec2::new(i as f32, 0.0)).max(*value);
            }
        }
        self.touched = self.touched.start.min(rows.start)..self.touched.end.max(rows.end);
    }

    /// Hands each covered pixel to `paint`, as its index from the first of the rows and its coverage, and empties the coverage.
    pub(super) fn drain(&mut self, mut paint: impl FnMut(usize, u8)) {
        let first = (self.touched.start - self.rows.start) * self.width;
        let end = (self.touched.end - self.rows.start) * self.width;
        for (block, covers) in self.coverage[first.min(end)..end].chunks_mut(BLOCK).enumerate() {
            if !is_clear(covers) {
                for (i, cover) in covers.iter_mut().enumerate().filter(|(_, cover)| **cover > 0) {
                    paint(first + block * BLOCK + i, *cover);
                    *cover = 0;
                }
            }
        }
        self.touched = self.rows.end..self.rows.start;
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
    /// Whether start and end are cut straight across.
    is_cut: [bool; 2],
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
    fn new(along: Vec2, length: f32, width: f32, is_cut: [bool; 2]) -> Self {
        Self { along, length, half_width: width / 2.0, is_cut, pixel: Pixel::facing(along) }
    }

    /// How much of a pixel the segment covers; the place is relative to its start. Exact beside the segment, where it reaches far enough
    /// both ways; at round ends the border is taken as straight over a pixel, and at a cut the shares across and along are multiplied.
    fn coverage(&self, place: Vec2) -> u8 {
        let t = self.along.dot(place);
        let [cut_start, cut_end] = self.is_cut;
        let beyond = if t < 0.0 && !cut_start {
            t
        } else if t > self.length && !cut_end {
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
        let mut share = pixel.inside(self.half_width + distance) - pixel.inside(distance - self.half_width);
        if cut_start {
            share *= self.pixel.inside(t);
        }
        if cut_end {
            share *= self.pixel.inside(self.length - t);
        }
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

/// Those of some rows or columns whose centres lie between two coordinates.
fn pixels(low: f64, high: f64, among: &Range<usize>) -> Range<usize> {
    let clip = |v: f64| (v - 0.5).ceil().clamp(among.start as f64, among.end as f64) as usize;
    let (first, end) = (clip(low), clip(high));
    first..end.max(first)
}

#[cfg(test)]
mod tests {
    use super::*;

    type Place = (f64, f64);

    fn coverage_of(stretches: &[Stretch], width: f32) -> Vec<u8> {
        let mut lines = Lines::new(32, 0..32);
        stretches.iter().for_each(|stretch| lines.add(stretch, width));
        let mut found = vec![0; 32 * 32];
        lines.drain(|i, cover| found[i] = cover);
        lines.drain(|i, _| panic!("pixel {i} was left"));
        found
    }

    fn coverage(segments: &[(Place, Place)], width: f32) -> Vec<u8> {
        let stretch = |&(from, to): &(Place, Place)| Stretch::round(from.into(), to.into());
        coverage_of(&segments.iter().map(stretch).collect::<Vec<_>>(), width)
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
    /// A stretch with cut ends covers a rectangle, whatever its direction.
    #[test]
    fn cut_ends_are_straight() {
        for i in 0..48 {
            let direction = DVec2::from_angle(f64::from(i) * std::f64::consts::TAU / 48.0);
            for (width, length) in [(1.0_f32, 6.0), (4.0, 3.0), (9.0, 12.5)] {
                let middle = DVec2::new(16.2, 15.9);
                let half = direction * length / 2.0;
                let stretch = Stretch { from: middle - half, to: middle + half, is_cut: [true; 2] };
                let found = coverage_of(&[stretch], width);
                let sum: f64 = found.iter().map(|&c| f64::from(c) / 255.0).sum();
                let area = f64::from(width) * length;
                assert!((sum - area).abs() < 0.01 * area + 0.1, "{i}, width {width}: {sum}, expected {area}");
            }
        }
        let from = DVec2::new(8.0, 16.5);
        let stretch = Stretch { from, to: from + DVec2::new(4.25, 0.0), is_cut: [true, true] };
        let row = &coverage_of(&[stretch], 1.0)[16 * 32 + 6..16 * 32 + 14];
        assert_eq!(row, [0, 0, 255, 255, 255, 255, 64, 0]);
    }

    #[test]
    fn rows_painted_apart_are_the_rows_painted_together() {
        let stretches = [((3.0, 2.0), (29.0, 30.0)), ((30.0, 7.5), (2.0, 9.0)), ((16.0, 16.0), (16.0, 16.0))]
            .map(|(from, to): (Place, Place)| Stretch::round(from.into(), to.into()));
        let whole = coverage_of(&stretches, 5.0);
        let mut parts = Vec::new();
        for rows in [0..7, 7..8, 8..32] {
            let mut lines = Lines::new(32, rows.clone());
            stretches.iter().for_each(|stretch| lines.add(stretch, 5.0));
            let mut part = vec![0; 32 * rows.len()];
            lines.drain(|i, cover| part[i] = cover);
            parts.extend(part);
        }
        assert_eq!(parts, whole);
    }
}
