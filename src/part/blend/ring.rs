//! Closed curves by their arc length.

use super::super::Shape;
use crate::geom::{order_by_number, signed_area};
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// Turn at a vertex, in radians, from which it is a corner: 5 degrees. Below, it belongs to a curve that the chain follows.
const CORNER: f64 = 5.0 * PI / 180.0;

/// The outline of a body counter-clockwise, or a hole clockwise: the body lies to its left.
#[derive(Debug, Clone)]
pub(super) struct Ring {
    points: Vec<DVec2>,
    /// Arc length up to each point, and the whole.
    starts: Vec<f64>,
    /// Turn up to each point and at it, corners left out.
    turns: Vec<f64>,
    /// Places of the corners; the first one is at 0.
    corners: Vec<f64>,
    /// Of a circle its centre, its radius, and 1 or -1 for its direction.
    circle: Option<(DVec2, f64, f64)>,
}

impl Ring {
    /// `None` of a shape that is not closed or has no area.
    pub(super) fn new(shape: &Shape, is_hole: bool) -> Option<Self> {
        match shape {
            Shape::Circle { center, radius } => {
                let direction = if is_hole { -1.0 } else { 1.0 };
                let circle = Some((*center, *radius, direction));
                let starts = vec![0.0, TAU * radius];
                Some(Self { points: Vec::new(), starts, turns: Vec::new(), corners: Vec::new(), circle })
            }
            Shape::Closed(path) => {
                let mut points: Vec<DVec2> = path.ends().map(|(start, _)| start).collect();
                points.dedup();
                while points.len() > 1 && points.first() == points.last() {
                    points.pop();
                }
                let area = signed_area(&points);
                if points.len() < 3 || area == 0.0 {
                    return None;
                }
                if (area < 0.0) != is_hole {
                    points.reverse();
                }
                Some(Self::through(points))
            }
            _ => None,
        }
    }

    fn through(mut points: Vec<DVec2>) -> Self {
        let n = points.len();
        let turn = |points: &[DVec2], k: usize| {
            let (before, after) = (points[k] - points[(k + n - 1) % n], points[(k + 1) % n] - points[k]);
            before.perp_dot(after).atan2(before.dot(after)).abs()
        };
        let first = order_by_number(n, |k| -turn(&points, k))[0];
        points.rotate_left(first);
        let (mut starts, mut turns, mut corners) = (Vec::with_capacity(n + 1), Vec::new(), Vec::new());
        let (mut length, mut turned) = (0.0, 0.0);
        for k in 0..n {
            starts.push(length);
            let own = turn(&points, k);
            if own >= CORNER {
                corners.push(length);
            } else {
                turned += own;
            }
            turns.push(turned);
            length += points[k].distance(points[(k + 1) % n]);
        }
        starts.push(length);
        Self { points, starts, turns, corners, circle: None }
    }

    /// Arc length of the whole.
    pub(super) fn length(&self) -> f64 {
        self.starts.last().copied().unwrap_or(0.0)
    }

    /// Places of the corners, ascending.
    pub(super) fn corners(&self) -> &[f64] {
        &self.corners
    }

    /// The point at a place, 0 to the length.
    pub(super) fn at(&self, place: f64) -> DVec2 {
        if let Some((center, radius, direction)) = self.circle {
            return center + radius * DVec2::from_angle(direction * place / radius);
        }
        let k = self.segment(place);
        let (start, end) = (self.points[k], self.points[(k + 1) % self.points.len()]);
        let length = self.starts[k + 1] - self.starts[k];
        start.lerp(end, if length > 0.0 { ((place - self.starts[k]) / length).clamp(0.0, 1.0) } else { 0.0 })
    }

    /// How far the curve turns between two places in radians, corners left out.
    pub(super) fn turn(&self, from: f64, to: f64) -> f64 {
        if let Some((_, radius, _)) = self.circle {
            return (to - from) / radius;
        }
        self.turns[self.segment(to)] - self.turns[self.segment(from)]
    }

    /// The place nearest to a point.
    pub(super) fn nearest(&self, point: DVec2) -> f64 {
        if let Some((center, radius, direction)) = self.circle {
            return (direction * (point - center).to_angle()).rem_euclid(TAU) * radius;
        }
        let n = self.points.len();
        let mut best = (f64::INFINITY, 0.0);
        for k in 0..n {
            let (start, along) = (self.points[k], self.points[(k + 1) % n] - self.points[k]);
            let share = ((point - start).dot(along) / along.length_squared()).clamp(0.0, 1.0);
            let distance = point.distance_squared(start + share * along);
            if distance < best.0 {
                best = (distance, self.starts[k] + share * along.length());
            }
        }
        best.1
    }

    /// The segment that holds a place.
    fn segment(&self, place: f64) -> usize {
        self.starts.partition_point(|start| *start <= place).saturating_sub(1).min(self.points.len() - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::Path;
    use super::*;
    use glam::dvec2;
    use std::rc::Rc;

    fn polygon(points: &[DVec2]) -> Shape {
        Shape::Closed(Rc::new(Path::through(points, true).unwrap()))
    }

    #[test]
    fn the_body_lies_to_the_left_whatever_the_direction_of_drawing() {
        let mut square =
            vec![dvec2(0.0, 0.0), dvec2(2.0, 0.0), dvec2(2.0, 2.0), dvec2(1.0, 2.0), dvec2(0.0, 2.0)];
        for _ in 0..2 {
            for is_hole in [false, true] {
                let ring = Ring::new(&polygon(&square), is_hole).unwrap();
                assert_eq!((ring.length(), ring.corners().len()), (8.0, 4));
                let around: Vec<DVec2> = (0..16).map(|k| ring.at(f64::from(k) * 0.5)).collect();
                assert_eq!(signed_area(&around), if is_hole { -4.0 } else { 4.0 });
                assert!((ring.at(ring.nearest(dvec2(0.5, -3.0))) - dvec2(0.5, 0.0)).length() < 1e-12);
            }
            square.reverse();
        }
        assert!(Ring::new(&polygon(&square[..2]), false).is_none());
        assert!(Ring::new(&Shape::Point(DVec2::ZERO), false).is_none());
    }

    /// A circle and the fine chain that follows it are the same, without corners.
    #[test]
    fn a_circle_turns_once() {
        let center = dvec2(3.0, -1.0);
        let chain: Vec<DVec2> =
            (0..720).map(|k| center + 2.0 * DVec2::from_angle(f64::from(k) * TAU / 720.0)).collect();
        for shape in [Shape::Circle { center, radius: 2.0 }, polygon(&chain)] {
            let ring = Ring::new(&shape, true).unwrap();
            assert!(ring.corners().is_empty());
            assert!((ring.length() - TAU * 2.0).abs() < 1e-3);
            assert!((ring.turn(0.0, ring.length() / 2.0) - PI).abs() < 0.02);
            let point = ring.at(1.0);
            assert!((point.distance(center) - 2.0).abs() < 1e-4 && (ring.nearest(point) - 1.0).abs() < 1e-3);
        }
    }
}
