//! The flow of heat: the gradient of a potential that is constant on every ring.
//!
//! Where the potential is constant on closed curves, their double layers are constant inside, so that the gradient is that of the single layers alone:
//! the sum over the segments of the flux times the gradient of -(1/2 pi) times the integral of ln r.

use crate::laplace::{Scaling, Solution};
use glam::DVec2;
use std::f64::consts::TAU;

/// Segments nearer than so many of their lengths are integrated exactly; the middle stands for the others, whose errors telescope round a ring.
const EXACT: f64 = 4.0;

/// Numbers that are worked on together.
const LANES: usize = 4;

/// The ends of a segment, and its flux.
type Segment = ([DVec2; 2], f64);

/// Segments with their fluxes, in the coordinates of computing.
#[derive(Debug, Clone)]
pub(super) struct Flow {
    scaling: Scaling,
    /// Ends of each segment, along the boundary with the material on its left, and its flux.
    segments: Vec<Segment>,
    /// Middle of each segment, its flux times its length over 2 pi, and the square of the distance within which it is near; filled up with segments of no weight.
    x: Vec<f64>,
    y: Vec<f64>,
    weight: Vec<f64>,
    near: Vec<f64>,
}

impl Flow {
    /// The flow of the first quantity of a solution.
    pub(super) fn new(solution: &Solution) -> Self {
        let mesh = solution.problem().mesh();
        let scaling = mesh.scaling();
        let fluxes = solution.fluxes().into_iter().next().unwrap_or_default();
        let place = |element: usize| {
            let [a, b, _] = mesh.corners(element).map(|corner| scaling.inwards(corner).truncate());
            [a, b]
        };
        let segments: Vec<Segment> =
            fluxes.iter().enumerate().map(|(k, flux)| (place(k), flux / scaling.scale())).collect();
        let count = segments.len().next_multiple_of(LANES);
        let column = |of: &dyn Fn(&Segment) -> f64, rest: f64| {
            let mut column: Vec<f64> = segments.iter().map(of).collect();
            column.resize(count, rest);
            column
        };
        let length = |ends: &[DVec2; 2]| ends[0].distance(ends[1]);
        Self {
            x: column(&|(ends, _)| (ends[0].x + ends[1].x) / 2.0, 1e3),
            y: column(&|(ends, _)| (ends[0].y + ends[1].y) / 2.0, 1e3),
            weight: column(&|(ends, flux)| flux * length(ends) / TAU, 0.0),
            near: column(&|(ends, _)| (EXACT * length(ends)).powi(2), 0.0),
            scaling,
            segments,
        }
    }

    /// The gradient at a point inside.
    pub(super) fn gradient(&self, point: DVec2) -> DVec2 {
        let at = self.scaling.inwards(point.extend(0.0)).truncate();
        let (mut gx, mut gy) = ([0.0; LANES], [0.0; LANES]);
        let mut near: Vec<usize> = Vec::with_capacity(64);
        let [xs, ys, weights, reaches] =
            [&self.x, &self.y, &self.weight, &self.near].map(|column| column.as_chunks::<LANES>().0);
        for (k, (((x, y), weight), reach)) in xs.iter().zip(ys).zip(weights).zip(reaches).enumerate() {
            let mut nearest = f64::INFINITY;
            for l in 0..LANES {
                let (dx, dy) = (x[l] - at.x, y[l] - at.y);
                let square = dx * dx + dy * dy;
                nearest = nearest.min(square - reach[l]);
                let share = weight[l] / square.max(1e-30);
                gx[l] += share * dx;
                gy[l] += share * dy;
            }
            if nearest < 0.0 {
                near.push(k);
            }
        }
        let mut sum = DVec2::new(gx.iter().sum(), gy.iter().sum());
        for k in near.into_iter().flat_map(|k| LANES * k..LANES * (k + 1)) {
            let away = DVec2::new(self.x[k], self.y[k]) - at;
            let square = away.length_squared();
            if square < self.near[k] {
                let (ends, flux) = self.segments[k];
                sum += flux * of_segment(ends, at) - self.weight[k] / square.max(1e-30) * away;
            }
        }
        sum * self.scaling.scale()
    }
}

/// The gradient of a single layer of flux 1, exact.
fn of_segment([a, b]: [DVec2; 2], x: DVec2) -> DVec2 {
    let along = (b - a).normalize_or_zero();
    let (from, to) = (a - x, b - x);
    let squares = [from, to].map(|end| end.length_squared().max(1e-30));
    let angle = from.perp_dot(to).atan2(from.dot(to));
    let normal = DVec2::new(along.y, -along.x);
    (0.5 * (squares[1] / squares[0]).ln() * along + angle * normal) / TAU
}
