//! Diagonals that the Delaunay rule leaves open.

use crate::geom::orient2d;
use glam::DVec2;
use std::collections::HashMap;
use std::f64::consts::PI;

/// Two opposite angles of a quadrilateral that differ from a half turn by less, in radians, tell that its vertices lie on one circle.
const ON_CIRCLE: f64 = 1e-7;
/// What one diagonal has to be lower than the other by.
const LOWER: f64 = 1e-12;
/// Flips for each vertex after which the triangulation stays as it is.
const MOST_FLIPS: usize = 64;

/// Decides by the numbers of the vertices where four of them lie on a circle, so that rounding does not: vertices whose number has many factors of
/// two keep the diagonals. Round rims then have triangles of all sizes in place of slivers.
///
/// Vertices get heights, half as much for each factor of two, and a diagonal is flipped when the other one is lower where they cross: so the surface
/// over the triangles only falls, and the flips end.
pub(super) fn settle(polygon: &[DVec2], triangles: &mut [[usize; 3]]) {
    let height = |k: usize| 0.5_f64.powi(k.trailing_zeros() as i32) + 1e-7 * k as f64;
    // For each directed edge the triangle on its left.
    let mut left: HashMap<(usize, usize), usize> = HashMap::with_capacity(3 * triangles.len());
    let mut open = Vec::new();
    for (number, triangle) in triangles.iter().enumerate() {
        for k in 0..3 {
            let edge = (triangle[k], triangle[(k + 1) % 3]);
            left.insert(edge, number);
            open.push(edge);
        }
    }
    let mut flips = MOST_FLIPS * polygon.len();
    while let Some((a, c)) = open.pop() {
        let (Some(&right), Some(&above)) = (left.get(&(c, a)), left.get(&(a, c))) else { continue };
        let apex = |triangle: usize| triangles[triangle].into_iter().find(|&k| k != a && k != c);
        // Counter-clockwise a, b, c, d.
        let (Some(b), Some(d)) = (apex(right), apex(above)) else { continue };
        let [pa, pb, pc, pd] = [a, b, c, d].map(|k| polygon[k]);
        if !is_tie([pa, pb, pc, pd]) {
            continue;
        }
        let across = |from: usize, to: usize, at: f64| height(from) + at * (height(to) - height(from));
        let [ta, tb] = [crossing(pb, pd, pa, pc), crossing(pa, pc, pb, pd)];
        if across(b, d, tb) + LOWER >= across(a, c, ta) || flips == 0 {
            continue;
        }
        flips -= 1;
        left.remove(&(a, c));
        left.remove(&(c, a));
        (triangles[right], triangles[above]) = ([a, b, d], [b, c, d]);
        for (number, triangle) in [(right, [a, b, d]), (above, [b, c, d])] {
            for k in 0..3 {
                left.insert((triangle[k], triangle[(k + 1) % 3]), number);
            }
        }
        open.extend([(a, b), (b, c), (c, d), (d, a)]);
    }
}

/// Whether a quadrilateral is convex and its vertices lie on a circle.
fn is_tie([a, b, c, d]: [DVec2; 4]) -> bool {
    let angle = |at: DVec2, from: DVec2, to: DVec2| (from - at).angle_to(to - at).abs();
    let is_round = (angle(b, c, a) + angle(d, a, c) - PI).abs() < ON_CIRCLE;
    is_round && orient2d(a, b, d) > 0.0 && orient2d(b, c, d) > 0.0
}

/// Share of the way from `from` to `to` at which the line through `a` and `b` is crossed.
fn crossing(a: DVec2, b: DVec2, from: DVec2, to: DVec2) -> f64 {
    let [here, there] = [from, to].map(|point| (b - a).perp_dot(point - a));
    here / (here - there)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn fan(count: usize, hub: usize) -> Vec<[usize; 3]> {
        (1..count - 1).map(|k| [hub, (hub + k) % count, (hub + k + 1) % count]).collect()
    }

    fn sorted(mut triangles: Vec<[usize; 3]>) -> Vec<[usize; 3]> {
        for triangle in &mut triangles {
            let least = (0..3).min_by_key(|&k| triangle[k]).unwrap_or(0);
            triangle.rotate_left(least);
        }
        triangles.sort_unstable();
        triangles
    }

    /// From whatever triangulation of a round rim, turned however, the same one is reached, and it is a balanced one.
    #[test]
    fn round_rims_have_one_triangulation() {
        for count in [7, 64, 100, 1000] {
            let settled = |hub: usize, turn: f64| {
                let rim: Vec<DVec2> =
                    (0..count).map(|k| DVec2::from_angle(turn + TAU * k as f64 / count as f64)).collect();
                let mut triangles = fan(count, hub);
                settle(&rim, &mut triangles);
                let area: f64 =
                    triangles.iter().map(|t| orient2d(rim[t[0]], rim[t[1]], rim[t[2]]) / 2.0).sum();
                assert!((area - count as f64 * (TAU / count as f64).sin() / 2.0).abs() < 1e-9);
                assert!(triangles.iter().all(|t| orient2d(rim[t[0]], rim[t[1]], rim[t[2]]) > 0.0));
                sorted(triangles)
            };
            let expected = settled(0, 0.0);
            for (hub, turn) in [(count / 3, 0.0), (1, 0.7), (count - 1, 2.0)] {
                assert_eq!(settled(hub, turn), expected, "{count}");
            }
            let ears =
                expected.iter().filter(|t| t[1] == t[0] + 1 && t[2] == t[1] + 1 && t[1] % 2 == 1).count();
            assert!(ears + 1 >= count / 2 - 1, "{ears} of {count}");
        }
    }

    #[test]
    fn other_diagonals_stay() {
        let kite = [DVec2::new(0.0, -2.0), DVec2::X, DVec2::new(0.0, 2.0), -DVec2::X];
        let mut triangles = vec![[0, 1, 3], [1, 2, 3]];
        settle(&kite, &mut triangles);
        assert_eq!(triangles, [[0, 1, 3], [1, 2, 3]]);
    }
}
