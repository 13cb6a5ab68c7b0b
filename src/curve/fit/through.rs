//! The cubic spline through every vertex.

use glam::DVec2;

use super::nodes::{Node, Nodes};
use super::polyline::Polyline;
use super::spline::{Knots, Spline};
use super::squares::solve;

/// Corrections of the solution by its own residual; each gains the digits that squaring the matrix lost.
const REFINEMENTS: usize = 3;

/// The interpolating spline, twice differentiable, and the parameters of the vertices. Parameters are centripetal: their
/// steps are the roots of the lengths.
///
/// A closed polyline gives a closed spline with a knot at each vertex, which has at least three spans. An open one leaves out
/// the knots next to its ends; of two or three vertices it is a line or a parabola.
///
/// # References
/// E. T. Y. Lee, "Choosing nodes in parametric curve interpolation", *Computer-Aided Design* 21 (1989).
pub(super) fn through(line: &Polyline, closed: bool) -> Option<(Spline, Vec<f64>)> {
    let mut u = 0.0;
    let mut parameters = vec![0.0];
    for pair in line.points.windows(2) {
        u += pair[0].distance(pair[1]).sqrt();
        parameters.push(u);
    }
    let points = &line.points;
    let last = points.len() - 1;
    let breaks: Vec<f64> = match (closed, last) {
        (true, _) => parameters.clone(),
        (false, 1..=3) => vec![0.0, u],
        (false, _) => {
            let inner = parameters[2..last - 1].iter().copied();
            [0.0].into_iter().chain(inner).chain([u]).collect()
        }
    };
    let knots = Knots::new(breaks, closed);
    let control = match (closed, last) {
        (false, 1) => [0.0, 1.0, 2.0, 3.0].map(|i| points[0].lerp(points[1], i / 3.0)).to_vec(),
        (false, 2) => parabola(points, parameters[1] / u),
        _ => interpolated(&knots, line, &parameters)?,
    };
    Some((Spline::new(knots, control), parameters))
}

/// Cubic Bezier points of the parabola through three points, the middle one at the share `t`.
fn parabola(points: &[DVec2], t: f64) -> Vec<DVec2> {
    let (a, b, c) = (points[0], points[1], points[2]);
    let s = 1.0 - t;
    let top = (b - a * (s * s) - c * (t * t)) / (2.0 * s * t);
    vec![a, a.lerp(top, 2.0 / 3.0), c.lerp(top, 2.0 / 3.0), c]
}

fn interpolated(knots: &Knots, line: &Polyline, parameters: &[f64]) -> Option<Vec<DVec2>> {
    let last = line.points.len() - 1;
    // The last vertex of a closed polyline is the first one.
    let count = if knots.closed { last } else { last + 1 };
    let node = |i: usize| Node { s: line.arc[i], u: parameters[i], at: line.points[i], weight: 1.0 };
    let mut nodes = Nodes((0..count).map(node).collect());
    let mut control = solve(knots, &nodes, line.points[0], line.points[last])?;
    for _ in 0..REFINEMENTS {
        let spline = Spline::new(knots.clone(), control);
        let mut span = 0;
        for (i, node) in nodes.0.iter_mut().enumerate() {
            span = knots.span_from(span, node.u);
            node.at = line.points[i] - spline.pieces[span].point(node.u);
        }
        let more = solve(knots, &nodes, DVec2::ZERO, DVec2::ZERO)?;
        control = spline.control.iter().zip(more).map(|(a, b)| *a + b).collect();
    }
    Some(control)
}
