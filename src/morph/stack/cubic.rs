//! The cubic through the curves of a stack: Hermite pieces with tangents of three-point parabolas.

use glam::DVec2;

/// Whether and how far a share of a fraction may be rounding.
const ROUNDING: f64 = 1e-14;

/// Weights of two secants in the tangent at a knot between steps of the lengths `before` and `after`: those of the parabola through three
/// values, which is exact for quadratic ones.
fn weights(before: f64, after: f64) -> [f64; 2] {
    [after / (before + after), before / (before + after)]
}

/// The tangent at knot `k`, as weights of the values at the three knots that it looks at.
///
/// At an inner knot it is that of the parabola through it and its neighbours, at the first and the last knot that of the parabola through the
/// three knots there: E. Catmull and R. Rom, "A class of local interpolating splines" (1974), for uneven knots.
pub(super) fn stencil(knots: &[f64], k: usize) -> [(usize, f64); 3] {
    let last = knots.len() - 1;
    if last == 1 {
        let step = knots[1] - knots[0];
        return [(0, -1.0 / step), (1, 1.0 / step), (1, 0.0)];
    }
    let middle = k.clamp(1, last - 1);
    let (before, after) = (knots[middle] - knots[middle - 1], knots[middle + 1] - knots[middle]);
    let [near, far] = weights(before, after);
    // Secants d of both steps: m = near d0 + far d1 in the middle, 2 d - m at either end.
    let [first, second] = match k {
        _ if k < middle => [2.0 - near, -far],
        _ if k > middle => [-near, 2.0 - far],
        _ => [near, far],
    };
    [(middle - 1, -first / before), (middle, first / before - second / after), (middle + 1, second / after)]
}

/// The tangent of places at knot `k`.
pub(super) fn tangent(knots: &[f64], points: &[DVec2], k: usize) -> DVec2 {
    // Differences to the knot's own place lose nothing to rounding far from the origin.
    stencil(knots, k).iter().map(|&(at, weight)| weight * (points[at] - points[k])).sum()
}

/// The tangents of heights, scaled back until the blend keeps between the heights of neighbouring curves.
pub(super) fn height_tangents(knots: &[f64], heights: &[f64]) -> Vec<f64> {
    (0..knots.len())
        .map(|k| {
            let slope: f64 =
                stencil(knots, k).iter().map(|&(at, weight)| weight * (heights[at] - heights[k])).sum();
            let mut scale = 1.0_f64;
            for (other, reach) in sides(knots, k) {
                let (step, room) = (slope * reach, heights[other] - heights[k]);
                // The control point on this side lies between the two heights.
                let most = if step * room > 0.0 { (room / step).min(1.0) } else { 0.0 };
                if step != 0.0 {
                    scale = scale.min(most);
                }
            }
            slope * scale
        })
        .collect()
}

/// The tangent of fractions at knot `k`, scaled back by the largest common factor, at most 1, with which the control points on both sides have no
/// fraction below 0. The changes of all fractions sum to 0, so that with any factor the sum stays 1.
pub(super) fn fraction_tangent(knots: &[f64], fractions: &[&[f64]], k: usize) -> Vec<f64> {
    let stencil = stencil(knots, k);
    let own = fractions[k];
    let mut slope: Vec<f64> = (0..own.len())
        .map(|material| {
            stencil.iter().map(|&(at, weight)| weight * (fractions[at][material] - own[material])).sum()
        })
        .collect();
    let mut scale = 1.0_f64;
    for (_, reach) in sides(knots, k) {
        for (change, fraction) in slope.iter().zip(own) {
            let step = change * reach;
            if fraction + step < 0.0 && step < -ROUNDING {
                scale = scale.min(fraction / -step);
            }
        }
    }
    slope.iter_mut().for_each(|change| *change *= scale);
    slope
}

/// The neighbours of a knot, each with the signed way from the knot to the control point on that side.
fn sides(knots: &[f64], k: usize) -> impl Iterator<Item = (usize, f64)> {
    let before = k.checked_sub(1).map(|other| (other, (knots[other] - knots[k]) / 3.0));
    let after = (k + 1 < knots.len()).then(|| (k + 1, (knots[k + 1] - knots[k]) / 3.0));
    before.into_iter().chain(after)
}

/// Bernstein polynomials of degree 3.
pub(super) fn bernstein(t: f64) -> [f64; 4] {
    let r = 1.0 - t;
    [r * r * r, 3.0 * r * r * t, 3.0 * r * t * t, t * t * t]
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec2;

    #[test]
    fn tangents_of_quadratics_are_exact() {
        let knots = [0.0, 0.3, 0.4, 1.0];
        let quadratic = |s: f64| dvec2(1.0 - 2.0 * s + 3.0 * s * s, 5.0 * s * s);
        let points: Vec<DVec2> = knots.iter().map(|&s| quadratic(s)).collect();
        for (k, s) in knots.iter().enumerate() {
            let found = tangent(&knots, &points, k);
            assert!((found - dvec2(-2.0 + 6.0 * s, 10.0 * s)).length() < 1e-12, "{k}");
        }
    }

    #[test]
    fn heights_keep_between_their_neighbours() {
        let knots = [0.0, 0.4, 0.5, 0.9, 1.0];
        let heights = [0.0, 0.0, 10.0, 11.0, 5.0];
        let tangents = height_tangents(&knots, &heights);
        for k in 0..4 {
            let step = (knots[k + 1] - knots[k]) / 3.0;
            let (low, high) = (heights[k].min(heights[k + 1]), heights[k].max(heights[k + 1]));
            for control in [heights[k] + step * tangents[k], heights[k + 1] - step * tangents[k + 1]] {
                assert!((low - 1e-12..=high + 1e-12).contains(&control), "{k}: {control}");
            }
        }
        let even = height_tangents(&[0.0, 0.5, 1.0], &[0.0, 2.0, 4.0]);
        assert!(
            even.iter().all(|tangent| (tangent - 4.0).abs() < 1e-12),
            "even steps keep their speed: {even:?}"
        );
    }

    #[test]
    fn fractions_are_scaled_back_only_as_far_as_they_must() {
        let knots = [0.0, 0.5, 1.0];
        let free: [&[f64]; 3] = [&[0.6, 0.4], &[0.5, 0.5], &[0.4, 0.6]];
        let tangent = fraction_tangent(&knots, &free, 1);
        assert!((tangent[0] + 0.2).abs() < 1e-12 && (tangent[1] - 0.2).abs() < 1e-12);
        // The first fraction is 0.05 and would fall by 0.15 to the control point.
        let tight: [&[f64]; 3] = [&[0.95, 0.05], &[0.05, 0.95], &[0.05, 0.95]];
        let tangent = fraction_tangent(&knots, &tight, 1);
        assert!((0.05 + tangent[0] / 6.0).abs() < 1e-12, "{tangent:?}");
        let pure: [&[f64]; 3] = [&[1.0, 0.0, 0.0], &[0.0, 1.0, 0.0], &[0.0, 0.0, 1.0]];
        assert_eq!(fraction_tangent(&knots, &pure, 1), [0.0; 3]);
    }
}
