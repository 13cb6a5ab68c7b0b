//! Filled polygons: how much of each pixel they cover, exactly.
//!
//! Every edge adds to the pixels of its rows the area on its right side, positive when it climbs the screen and written as the change from one
//! pixel to the next, so that it touches only the pixels that it crosses and the one behind. Running sums along the rows then give the
//! area times the winding number. Inside a pixel the number is averaged: only where edges of one pixel cross is the result not exact.

use glam::DVec2;

use super::window::Window;
use crate::geom::{Location, locate, signed_area};

/// Cells looked at together for a change.
const BLOCK: usize = 16;

/// How much of each pixel of a window the rings cover by the even-odd rule, in 255ths, row by row. Rings may reach
/// beyond the window.
pub(super) fn coverage(rings: &[Vec<DVec2>], window: &Window) -> Vec<u8> {
    let width = window.width();
    let mut covers = Vec::with_capacity(window.area());
    for row in changes(rings, window).chunks_exact(width + 1) {
        let mut sum = 0.0;
        for cells in row[..width].chunks(BLOCK) {
            if cells.iter().fold(0, |all, cell| all | cell.to_bits()) == 0 {
                covers.extend(std::iter::repeat_n(level(sum), cells.len()));
            } else {
                covers.extend(cells.iter().map(|cell| {
                    sum += cell;
                    level(sum)
                }));
            }
        }
    }
    covers
}

/// Turns rings that lie inside others so that winding numbers alternate between 0 and 1: then the average over a pixel is right also
/// where two rings run through it side by side.
pub(super) fn alternate(rings: &mut [Vec<DVec2>]) {
    let is_inside = |ring: &[DVec2], other: &[DVec2]| locate(other, ring[0]) == Location::Inside;
    let turned: Vec<bool> = (0..rings.len())
        .map(|i| {
            let others = rings.iter().enumerate().filter(|&(j, _)| j != i);
            let depth = others.filter(|(_, other)| is_inside(&rings[i], other)).count();
            (signed_area(&rings[i]) < 0.0) != (depth % 2 == 1)
        })
        .collect();
    rings.iter_mut().zip(turned).filter(|(_, turned)| *turned).for_each(|(ring, _)| ring.reverse());
}

/// The even-odd share of a winding number, in 255ths: its distance from the nearest even number.
fn level(winding: f32) -> u8 {
    let share = (winding - 2.0 * (winding / 2.0).round_ties_even()).abs();
    (share * 255.0 + 0.5) as u8
}

/// Changes of the winding number from each pixel to the next along every row of a window, with one more cell at the end of each row.
fn changes(rings: &[Vec<DVec2>], window: &Window) -> Vec<f32> {
    let (width, height) = (window.width(), window.height() as f64);
    let mut cells = vec![0.0; (width + 1) * window.height()];
    let corner = window.corner();
    for ring in rings {
        let Some(&last) = ring.last() else { continue };
        let mut from = last - corner;
        for &point in ring {
            let to = point - corner;
            let (sign, low, high) = if from.y < to.y { (-1.0, from, to) } else { (1.0, to, from) };
            from = to;
            let (top, bottom) = (low.y.max(0.0), high.y.min(height));
            if top >= bottom {
                continue;
            }
            let slope = (high.x - low.x) / (high.y - low.y);
            let at = |y: f64| low.x + (y - low.y) * slope;
            let mut start = (top, at(top));
            for row in top as usize..bottom.ceil() as usize {
                let y = bottom.min((row + 1) as f64);
                let end = (y, at(y));
                let cells = &mut cells[row * (width + 1)..(row + 1) * (width + 1)];
                cross(cells, start.1.min(end.1), start.1.max(end.1), sign * (end.0 - start.0));
                start = end;
            }
        }
    }
    cells
}

/// Adds an edge that crosses a row from `low` to `high`, climbing `rise` of the row's height. Left of the row it counts as
/// if it ran along the left side, and right of the row not at all.
fn cross(cells: &mut [f32], low: f64, high: f64, rise: f64) {
    let width = (cells.len() - 1) as f64;
    if high <= 0.0 {
        cells[0] += rise as f32;
        return;
    }
    if low >= width {
        return;
    }
    let (mut low, mut high, mut rise) = (low, high, rise);
    if low < 0.0 {
        let outside = rise * low / (low - high);
        cells[0] += outside as f32;
        (low, rise) = (0.0, rise - outside);
    }
    if high > width {
        rise *= (width - low) / (high - low);
        high = width;
    }
    // The area right of the edge in the pixels up to each one; what it gains from pixel to pixel is written down.
    let (first, end) = (low as usize, (high.ceil() as usize).max(low as usize + 1));
    let per_pixel = if end - first > 1 { rise / (high - low) } else { 0.0 };
    let mut before = 0.0;
    for (column, cell) in cells.iter_mut().enumerate().take(end + 1).skip(first) {
        let right = (column + 1) as f64;
        let area = if column == end {
            rise
        } else if end - first == 1 {
            rise * (right - (low + high) / 2.0)
        } else if column == first {
            per_pixel * (right - low) * (right - low) / 2.0
        } else if column + 1 == end {
            // All but the triangle that is left of the edge.
            let rest = high - column as f64;
            rise - per_pixel * (rest * rest / 2.0)
        } else {
            per_pixel * (right - 0.5 - low)
        };
        *cell += (area - before) as f32;
        before = area;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    fn window(width: u32, height: u32) -> Window {
        Window::whole(width, height)
    }

    fn ring(center: DVec2, radius: f64, count: usize) -> Vec<DVec2> {
        (0..count).map(|k| center + radius * DVec2::from_angle(TAU * k as f64 / count as f64)).collect()
    }

    /// The sum over the window of the area times the winding number.
    fn area(rings: &[Vec<DVec2>], window: &Window) -> f64 {
        let sums = |row: &[f32]| {
            let mut sum = 0.0;
            row[..window.width()].iter().fold(0.0, |total, &cell| {
                sum += f64::from(cell);
                total + sum
            })
        };
        changes(rings, window).chunks_exact(window.width() + 1).map(sums).sum()
    }

    #[test]
    fn areas_are_those_of_the_polygons() {
        for i in 0..500 {
            let shift = DVec2::new(f64::from(i) * 0.137 % 1.0, f64::from(i) * 0.071 % 1.0);
            let radius = 0.1 + f64::from(i) * 0.05;
            let polygon = ring(DVec2::splat(32.0) + shift, radius, 3 + i as usize % 60);
            let found = area(std::slice::from_ref(&polygon), &window(64, 64));
            let expected = signed_area(&polygon);
            assert!((found - expected).abs() < 1e-3, "{i}: {found}, expected {expected}");
        }
        let circle = ring(DVec2::new(31.3, 30.8), 25.0, 4000);
        assert!((area(&[circle], &window(64, 64)) - PI * 625.0).abs() < 2e-3);
    }

    #[test]
    fn single_pixels_are_exact() {
        let triangle = [vec![DVec2::new(0.0, 0.0), DVec2::new(4.0, 0.0), DVec2::new(0.0, 2.0)]];
        let found = coverage(&triangle, &window(5, 3));
        let level = |share: f64| (share * 255.0).round() as u8;
        let [three, one] = [level(0.75), level(0.25)];
        assert_eq!(found, [255, 255, three, one, 0, three, one, 0, 0, 0, 0, 0, 0, 0, 0]);
        let part = [vec![
            DVec2::new(1.25, 0.5),
            DVec2::new(1.75, 0.5),
            DVec2::new(1.75, 0.75),
            DVec2::new(1.25, 0.75),
        ]];
        assert_eq!(coverage(&part, &window(3, 1)), [0, level(0.125), 0]);
    }

    /// What lies outside is cut: the part in the window is that of the cut polygon, from any side.
    #[test]
    fn polygons_may_reach_beyond_the_window() {
        let view = Window { columns: 5..25, rows: 7..19 };
        let corner = |i: u32, k: u32| f64::from((i * 7 + k * 13) % 61) - 14.0;
        for i in 0..300 {
            let triangle: Vec<DVec2> =
                (0..3).map(|k| DVec2::new(corner(i, k), corner(i + 5, k * 3 + 1))).collect();
            let mut cut = triangle.clone();
            for (axis, bound, sign) in [(0, 5.0, 1.0), (0, 25.0, -1.0), (1, 7.0, 1.0), (1, 19.0, -1.0)] {
                cut = super::super::clip::cut(&cut, |p| sign * (p[axis] - bound), |a, b, t| a.lerp(b, t));
            }
            let (found, expected) = (area(&[triangle], &view), signed_area(&cut));
            assert!((found - expected).abs() < 1e-3, "{i}: {found}, expected {expected}");
        }
    }

    #[test]
    fn rings_inside_others_are_holes_also_within_a_pixel() {
        let center = DVec2::splat(20.0);
        for radii in [[12.0, 5.0], [12.0, 11.8], [12.4, 12.39]] {
            let mut rings: Vec<Vec<DVec2>> = radii.iter().map(|&radius| ring(center, radius, 300)).collect();
            rings[1].reverse();
            rings.push(ring(center, 1.0, 50));
            alternate(&mut rings);
            let expected = rings.iter().map(|ring| signed_area(ring).abs()).collect::<Vec<f64>>();
            let expected = expected[0] - expected[1] + expected[2];
            let found: f64 = coverage(&rings, &window(40, 40)).iter().map(|&c| f64::from(c) / 255.0).sum();
            // Levels are rounded: half a level for each pixel on a ring.
            assert!((found - expected).abs() < 0.02 * expected, "{radii:?}: {found}, expected {expected}");
        }
    }

    #[test]
    fn where_rings_overlap_the_even_odd_rule_holds() {
        let square = |x: f64| {
            vec![DVec2::new(x, 1.0), DVec2::new(x + 4.0, 1.0), DVec2::new(x + 4.0, 3.0), DVec2::new(x, 3.0)]
        };
        let found = coverage(&[square(1.0), square(3.0), square(3.0)], &window(9, 4));
        assert_eq!(found[9..18], [0, 255, 255, 255, 255, 0, 0, 0, 0]);
        let found = coverage(&[square(1.0), square(3.0)], &window(9, 4));
        assert_eq!(found[9..18], [0, 255, 255, 0, 0, 255, 255, 0, 0]);
    }

    /// tiny-skia looks at sixteen places of each pixel, so it may be off by some of them. Where edges cross, ours may be off.
    #[test]
    fn agrees_with_tiny_skia() {
        let star: Vec<DVec2> =
            (0..5).map(|k| DVec2::splat(32.0) + 29.0 * DVec2::from_angle(TAU * 0.4 * f64::from(k))).collect();
        let blob = ring(DVec2::new(30.2, 33.7), 21.3, 90);
        for (rings, crossings) in [(vec![star.clone()], 5), (vec![blob.clone()], 0), (vec![star, blob], 15)] {
            let mut builder = tiny_skia::PathBuilder::new();
            for ring in &rings {
                ring.iter().enumerate().for_each(|(i, p)| {
                    let (x, y) = (p.x as f32, p.y as f32);
                    if i == 0 { builder.move_to(x, y) } else { builder.line_to(x, y) }
                });
                builder.close();
            }
            let path = builder.finish().expect("a path");
            let mut mask = tiny_skia::Mask::new(64, 64).expect("a mask");
            mask.fill_path(&path, tiny_skia::FillRule::EvenOdd, true, tiny_skia::Transform::identity());
            let found = coverage(&rings, &window(64, 64));
            let apart: Vec<u8> = found.iter().zip(mask.data()).map(|(a, b)| a.abs_diff(*b)).collect();
            let far = apart.iter().filter(|&&d| d > 64).count();
            assert!(far <= 2 * crossings, "{far} pixels at {crossings} crossings: {:?}", apart.iter().max());
            let sum: f64 = apart.iter().map(|&d| f64::from(d)).sum();
            let touched = found.iter().filter(|&&c| c > 0 && c < 255).count();
            assert!(sum < 16.0 * touched as f64, "{sum} levels on {touched} pixels");
        }
    }
}
