//! The point inside polygons that lies farthest from their edges.

use super::{Bounds, Location, locate};
use glam::{DVec2, dvec2};
use std::collections::BinaryHeap;

/// Squares looked at before the best point so far is taken: a few times what slender outlines need.
const MOST_SQUARES: usize = 4_000;
/// The search ends when no square can hold a point deeper than this multiple of the best one.
const GOOD_ENOUGH: f64 = 1.25;

/// Returns a point strictly inside all of the polygons that lies far from their edges, or `None` when none was found (they have no area
/// in common, or next to none).
///
/// Best-first search over squares, after Garcia-Castellanos and Lombardo, *Poles of inaccessibility* (2007); the depth is
/// within a quarter of the greatest one. It does not return the deepest point itself, which no caller needs.
#[must_use]
pub fn deepest_point(polygons: &[&[DVec2]]) -> Option<DVec2> {
    let boxes = polygons.iter().map(|polygon| Bounds::of(polygon.iter().copied()));
    let common = |a: Bounds, b: Bounds| Bounds { min: a.min.max(b.min), max: a.max.min(b.max) };
    let bounds = boxes.reduce(|a, b| Some(common(a?, b?)))??;
    let size = bounds.max - bounds.min;
    let half = size.min_element() / 2.0;
    if half <= 0.0 {
        return None;
    }
    let mut squares = BinaryHeap::new();
    let mut best = Square::new(polygons, bounds.center(), 0.0);
    let (columns, rows) = ((size.x / (2.0 * half)).ceil(), (size.y / (2.0 * half)).ceil());
    // A sliver as long as a thousand times its width is cut into at most as many squares as the search allows.
    for row in 0..rows.min(MOST_SQUARES as f64) as usize {
        for column in 0..columns.min(MOST_SQUARES as f64) as usize {
            let corner = bounds.min + 2.0 * half * dvec2(column as f64, row as f64);
            squares.push(Square::new(polygons, corner + half, half));
        }
    }
    for _ in 0..MOST_SQUARES {
        let Some(square) = squares.pop() else { break };
        if square.depth > best.depth {
            best = square;
        }
        if best.depth > 0.0 && square.reach <= best.depth * GOOD_ENOUGH {
            break;
        }
        let quarter = square.half / 2.0;
        for (dx, dy) in [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)] {
            let center = square.center + quarter * dvec2(dx, dy);
            squares.push(Square::new(polygons, center, quarter));
        }
    }
    let is_inside = |polygon: &&[DVec2]| locate(polygon, best.center) == Location::Inside;
    polygons.iter().all(is_inside).then_some(best.center)
}

#[derive(Clone, Copy)]
struct Square {
    center: DVec2,
    half: f64,
    /// Distance of the centre from the edges, negative outside.
    depth: f64,
    /// Greatest depth that a point of the square can have.
    reach: f64,
}

impl Square {
    fn new(polygons: &[&[DVec2]], center: DVec2, half: f64) -> Self {
        let depths = polygons.iter().map(|polygon| depth(polygon, center));
        let depth = depths.fold(f64::INFINITY, f64::min);
        Self { center, half, depth, reach: depth + half * std::f64::consts::SQRT_2 }
    }
}

impl PartialEq for Square {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Square {}

impl PartialOrd for Square {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Square {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.reach.total_cmp(&other.reach)
    }
}

/// Distance of a point from the outline, negative outside; rounded.
fn depth(polygon: &[DVec2], point: DVec2) -> f64 {
    let mut inside = false;
    let mut nearest = f64::INFINITY;
    let Some(&(mut a)) = polygon.last() else { return f64::NEG_INFINITY };
    for &b in polygon {
        let (edge, to_point) = (b - a, point - a);
        let t = (to_point.dot(edge) / edge.length_squared()).clamp(0.0, 1.0);
        let t = if t.is_nan() { 0.0 } else { t };
        nearest = nearest.min((to_point - t * edge).length_squared());
        if (a.y > point.y) != (b.y > point.y) && (edge.perp_dot(to_point) > 0.0) == (b.y > a.y) {
            inside = !inside;
        }
        a = b;
    }
    if inside { nearest.sqrt() } else { -nearest.sqrt() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn square_has_its_middle() {
        let square = [dvec2(0.0, 0.0), dvec2(2.0, 0.0), dvec2(2.0, 2.0), dvec2(0.0, 2.0)];
        let found = deepest_point(&[&square]).expect("a square has an inside");
        assert!(depth(&square, found) >= 1.0 / GOOD_ENOUGH);
    }

    #[test]
    fn narrow_u_has_a_point_inside_although_its_centre_is_outside() {
        let u = [
            dvec2(0.0, 0.0),
            dvec2(10.0, 0.0),
            dvec2(10.0, 10.0),
            dvec2(9.9, 10.0),
            dvec2(9.9, 0.1),
            dvec2(0.1, 0.1),
            dvec2(0.1, 10.0),
            dvec2(0.0, 10.0),
        ];
        let found = deepest_point(&[&u]).expect("the U has an inside");
        assert_eq!(locate(&u, found), Location::Inside);
        assert!(depth(&u, found) >= 0.05 / GOOD_ENOUGH);
    }

    #[test]
    fn flat_and_empty_polygons_have_none() {
        assert_eq!(deepest_point(&[&[]]), None);
        assert_eq!(deepest_point(&[&[dvec2(0.0, 0.0), dvec2(1.0, 0.0), dvec2(2.0, 0.0)]]), None);
    }

    #[test]
    fn common_point_of_two_squares() {
        let square = |x: f64| [(x, 0.0), (x + 2.0, 0.0), (x + 2.0, 2.0), (x, 2.0)].map(DVec2::from);
        let found = deepest_point(&[&square(0.0), &square(1.0)]).expect("they overlap");
        assert!(depth(&square(0.0), found).min(depth(&square(1.0), found)) >= 0.5 / GOOD_ENOUGH);
        assert_eq!(deepest_point(&[&square(0.0), &square(2.5)]), None);
    }
}
