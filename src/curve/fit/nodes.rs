//! The places at which a spline is compared with its polyline.

use glam::DVec2;

use super::polyline::Polyline;
use super::spline::{Knots, Spline};

/// Fewest and most nodes inside a span. Fewer than the least would leave the four basis functions of a span to chance; more
/// than the most cost time without telling a cubic anything new.
const FEWEST: f64 = 8.0;
const MOST: usize = 24;
/// Share of the way to its neighbour that a node may go in one correction.
const STEP: f64 = 0.49;

/// A place on the polyline and the parameter of the spline that belongs to it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    /// Length of the way along the polyline.
    pub(super) s: f64,
    /// Parameter of the spline.
    pub(super) u: f64,
    pub(super) at: DVec2,
    /// Length of the polyline that the node stands for.
    pub(super) weight: f64,
}

/// Nodes in ascending order of both s and u, from (0, 0) to (length, length).
#[derive(Debug, Clone)]
pub(super) struct Nodes(pub(super) Vec<Node>);

impl Nodes {
    /// The two ends alone: the parameter is the length of the way.
    pub(super) fn ends(line: &Polyline) -> Self {
        let node = |s: f64, at: DVec2| Node { s, u: s, at, weight: 0.0 };
        let last = line.points[line.points.len() - 1];
        Self(vec![node(0.0, line.points[0]), node(line.length(), last)])
    }

    /// Fresh nodes for other knots: enough in every span, the parameters interpolated between those of the nodes so far.
    ///
    /// Where a span holds few vertices of the polyline they are all among the nodes.
    pub(super) fn spread(&self, line: &Polyline, knots: &Knots) -> Self {
        let old = &self.0;
        let mut nodes = vec![Node { weight: 0.0, ..old[0] }];
        let mut backward = 0;
        let mut forward = 0;
        let mut edge = 0;
        let mut vertex = 1;
        let mut push = |s: f64| {
            while forward + 2 < old.len() && s >= old[forward + 1].s {
                forward += 1;
            }
            let (a, b) = (old[forward], old[forward + 1]);
            let u = a.u + (b.u - a.u) * ((s - a.s) / (b.s - a.s)).clamp(0.0, 1.0);
            let at = line.at(&mut edge, s);
            nodes.push(Node { s, u, at, weight: 0.0 });
        };
        let mut start = 0.0;
        for span in 0..knots.spans() {
            let end = if span + 1 == knots.spans() {
                line.length()
            } else {
                let u = knots.breaks[span + 1];
                while backward + 2 < old.len() && u >= old[backward + 1].u {
                    backward += 1;
                }
                let (a, b) = (old[backward], old[backward + 1]);
                a.s + (b.s - a.s) * ((u - a.u) / (b.u - a.u)).clamp(0.0, 1.0)
            };
            while line.arc[vertex] <= start && vertex + 1 < line.arc.len() {
                vertex += 1;
            }
            let count = line.arc[vertex..].iter().take(MOST).take_while(|&&s| s < end).count();
            if count == MOST {
                for i in 0..MOST {
                    push(start + (end - start) * ((i as f64 + 0.5) / MOST as f64));
                }
            } else {
                let longest = (end - start) / FEWEST;
                let mut from = start;
                for &to in line.arc[vertex..vertex + count].iter().chain([&end]) {
                    let parts = ((to - from) / longest).ceil().max(1.0);
                    for i in 1..parts as usize {
                        push(from + (to - from) * (i as f64 / parts));
                    }
                    if to < end {
                        push(to);
                    }
                    from = to;
                }
            }
            start = end;
        }
        nodes.push(Node { weight: 0.0, ..old[old.len() - 1] });
        // Rounding may have put two places on each other.
        nodes.dedup_by(|b, a| b.s <= a.s || b.u <= a.u);
        let last = nodes.len() - 1;
        nodes[last] = Node { weight: 0.0, ..old[old.len() - 1] };
        for i in 0..last {
            let half = (nodes[i + 1].s - nodes[i].s) / 2.0;
            nodes[i].weight += half;
            nodes[i + 1].weight += half;
        }
        Self(nodes)
    }

    /// Moves every parameter towards the nearest point of the spline by a step of Newton's method, keeping the order.
    pub(super) fn correct(&mut self, spline: &Spline) {
        let mut span = 0;
        let mut previous = self.0[0].u;
        for i in 1..self.0.len() - 1 {
            let Node { u, at, .. } = self.0[i];
            span = spline.knots.span_from(span, u);
            let next = self.0[i + 1].u;
            let moved = u + newton(spline, span, u, at);
            self.0[i].u = moved.clamp(u - STEP * (u - previous), u + STEP * (next - u));
            previous = u;
        }
    }

    /// Largest distance between a node and its point of the spline, for each span.
    pub(super) fn distances(&self, spline: &Spline) -> Vec<f64> {
        let mut largest = vec![0.0_f64; spline.pieces.len()];
        let mut span = 0;
        for node in &self.0 {
            span = spline.knots.span_from(span, node.u);
            largest[span] = largest[span].max(spline.pieces[span].point(node.u).distance_squared(node.at));
        }
        largest.iter().map(|square| square.sqrt()).collect()
    }
}

/// A step of Newton's method from `u` towards the parameter of the point nearest to `at`.
pub(super) fn newton(spline: &Spline, span: usize, u: f64, at: DVec2) -> f64 {
    let (value, first, second) = spline.pieces[span].derivatives(u);
    let gap = at - value;
    let speed = first.length_squared();
    let slope = speed - gap.dot(second);
    // Where the spline is bent more sharply than the distance, the step of Gauss and Newton still goes the right way.
    let slope = if slope > 0.25 * speed { slope } else { speed };
    if slope > 0.0 { gap.dot(first) / slope } else { 0.0 }
}
