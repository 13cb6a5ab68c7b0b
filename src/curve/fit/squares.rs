//! The spline with given knots that is nearest to given nodes in the sense of least squares.

use glam::DVec2;

use super::nodes::Nodes;
use super::spline::{Knots, Spline};
use crate::geom::BandMatrix;

/// The spline of least squares; an open one starts and ends exactly at the first and the last node. `None` when the nodes do
/// not determine it.
pub(super) fn least_squares(knots: &Knots, nodes: &Nodes) -> Option<Spline> {
    let (first, last) = (nodes.0[0].at, nodes.0[nodes.0.len() - 1].at);
    let control = solve(knots, nodes, first, last)?;
    Some(Spline::new(knots.clone(), control))
}

/// The control points of least squares; those at the ends of an open spline are given.
pub(super) fn solve(knots: &Knots, nodes: &Nodes, first: DVec2, last: DVec2) -> Option<Vec<DVec2>> {
    let count = knots.controls();
    // The control points asked for are those from `start` on.
    let (start, order) = if knots.closed { (0, count) } else { (1, count - 2) };
    let mut matrix = BandMatrix::new(order, 3, knots.closed);
    let mut right = vec![DVec2::ZERO; order];
    let mut span = 0;
    for node in &nodes.0 {
        span = knots.span_from(span, node.u);
        let basis = knots.basis(span, node.u);
        let rows = [0, 1, 2, 3].map(|j| knots.control(span, j).wrapping_sub(start));
        let mut target = node.at;
        for (j, &row) in rows.iter().enumerate() {
            if row >= order {
                target -= basis[j] * if row == order { last } else { first };
            }
        }
        for (j, &row) in rows.iter().enumerate().filter(|&(_, &row)| row < order) {
            let weighted = basis[j] * node.weight;
            right[row] += target * weighted;
            for (k, &column) in rows.iter().enumerate() {
                // A spline of three spans meets the same control point at both ends of a span.
                if column <= row {
                    matrix.add(row, column, weighted * basis[k]);
                }
            }
        }
    }
    let mut control = matrix.solve(right)?;
    if !knots.closed {
        control.insert(0, first);
        control.push(last);
    }
    Some(control)
}
