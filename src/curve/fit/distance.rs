//! How far a spline and its polyline are apart, never understated.
//!
//! Vertices are given parameters in their order. Between two of them the difference of the spline and of a point that runs
//! evenly along the edge is a cubic in Bezier form, and its control points bound it. That bounds the distance of every
//! point of either line from the other (the distance of Frechet, which is never less than that of Hausdorff). Where the
//! bound is not sharp, the stretch is halved, and the point on the edge is taken opposite to the spline's.

use glam::DVec2;

use super::nodes::{Nodes, newton};
use super::polyline::Polyline;
use super::spline::Spline;

/// A bound this close to a distance that is attained is sharp.
const SHARP: f64 = 1.01;
/// Most halvings of a stretch.
const DEEPEST: u32 = 12;
/// Steps of Newton's method for each vertex.
const STEPS: usize = 2;

/// Bounds of the distance, of all and of each span.
#[derive(Debug, Clone)]
pub(super) struct Distance {
    pub(super) largest: f64,
    pub(super) spans: Vec<f64>,
    /// Largest distance met between a point of the spline and its opposite.
    attained: f64,
}

/// A parameter for each vertex of the polyline: interpolated between the nodes, then corrected.
pub(super) fn vertex_parameters(spline: &Spline, line: &Polyline, nodes: &Nodes) -> Vec<f64> {
    let nodes = &nodes.0;
    let mut index = 0;
    let guess: Vec<f64> = line
        .arc
        .iter()
        .map(|&s| {
            while index + 2 < nodes.len() && s >= nodes[index + 1].s {
                index += 1;
            }
            let (a, b) = (nodes[index], nodes[index + 1]);
            a.u + (b.u - a.u) * ((s - a.s) / (b.s - a.s)).clamp(0.0, 1.0)
        })
        .collect();
    let last = guess.len() - 1;
    let mut parameters = guess.clone();
    (parameters[0], parameters[last]) = (0.0, spline.knots.length());
    let mut span = 0;
    for i in 1..last {
        // The span of the guess may lie behind that of a corrected parameter, but not behind the guess before.
        span = spline.knots.span_from(span, guess[i - 1]);
        let (low, high) = (parameters[i - 1].max(guess[i - 1]), guess[i + 1]);
        let mut u = guess[i].clamp(low, high.max(low));
        for _ in 0..STEPS {
            let here = spline.knots.span_from(span, u);
            u = (u + newton(spline, here, u, line.points[i])).clamp(low, high.max(low));
        }
        parameters[i] = u;
    }
    parameters
}

/// Bounds the distance between a spline and a polyline whose vertices have the given ascending parameters.
pub(super) fn distance(spline: &Spline, line: &Polyline, parameters: &[f64]) -> Distance {
    let mut found = Distance { largest: 0.0, spans: vec![0.0; spline.pieces.len()], attained: 0.0 };
    let mut span = 0;
    for (i, edge) in line.points.windows(2).enumerate() {
        let (mut from, to) = (parameters[i], parameters[i + 1]);
        let (start, along) = (edge[0], edge[1] - edge[0]);
        let mut reached = 0.0;
        loop {
            span = spline.knots.span_from(span, from);
            let piece_end = spline.pieces[span].hi;
            let is_last = to <= piece_end || span + 1 == spline.pieces.len();
            let end = if is_last { to } else { piece_end };
            let opposite = if is_last {
                1.0
            } else {
                opposite(spline.pieces[span].point(end), start, along).clamp(reached, 1.0)
            };
            found.bound(spline, span, (start, along), Stretch { from, to: end, reached, opposite, depth: 0 });
            if is_last {
                break;
            }
            (from, reached) = (end, opposite);
        }
    }
    found
}

/// A part of a piece, and the shares of an edge at which it starts and ends.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    from: f64,
    to: f64,
    reached: f64,
    opposite: f64,
    depth: u32,
}

/// The share of an edge at which it is nearest to a point.
fn opposite(point: DVec2, start: DVec2, along: DVec2) -> f64 {
    (point - start).dot(along) / along.length_squared()
}

impl Distance {
    fn bound(&mut self, spline: &Spline, span: usize, (start, along): (DVec2, DVec2), whole: Stretch) {
        let piece = &spline.pieces[span];
        let mut open = vec![whole];
        while let Some(stretch) = open.pop() {
            let Stretch { from, to, reached, opposite: end, depth } = stretch;
            let points = piece.part(from, to);
            let gap = |i: usize| {
                let share = reached + (end - reached) * (i as f64 / 3.0);
                points[i].distance(start + along * share)
            };
            let gaps = [gap(0), gap(1), gap(2), gap(3)];
            let bound = gaps.iter().copied().fold(0.0, f64::max);
            self.attained = self.attained.max(gaps[0]).max(gaps[3]);
            if bound <= SHARP * self.attained || depth == DEEPEST || to <= from {
                self.largest = self.largest.max(bound);
                self.spans[span] = self.spans[span].max(bound);
                continue;
            }
            let middle = from + (to - from) / 2.0;
            let share = opposite(piece.point(middle), start, along).clamp(reached, end);
            let depth = depth + 1;
            open.push(Stretch { from: middle, reached: share, depth, ..stretch });
            open.push(Stretch { to: middle, opposite: share, depth, ..stretch });
        }
    }
}
