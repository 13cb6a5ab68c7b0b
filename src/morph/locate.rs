//! The place of a point in the band.

use super::{Band, Ruling};
use crate::material::Composition;
use glam::DVec2;

/// Where a point lies in the band.
#[derive(Debug, Clone, PartialEq)]
pub struct Place {
    /// Index of the nearest line of the matching.
    pub line: usize,
    /// Share of the way from the first curve (0) to the second (1).
    pub s: f64,
    /// Parameter on the first curve of the ruling through the point.
    pub u: f64,
    /// Parameter on the second curve of that ruling.
    pub v: f64,
    /// Composition at the point.
    pub composition: Composition,
}

/// How far outside a patch a point may lie, as a share of its size, before it counts as outside: points on a border belong
/// to either side.
const SLACK: f64 = 1e-9;

impl Band {
    /// Returns the place of a point in the band, or `None` when it lies outside.
    ///
    /// Between two rulings the place is that of the bilinear patch; where rough lines make patches overlap, the
    /// first one counts.
    #[must_use]
    pub fn locate(&self, point: DVec2) -> Option<Place> {
        let (per_line, lines) = (self.per_line(), self.lines().count());
        self.gaps().enumerate().find_map(|(gap, (this, next, (next_u, next_v)))| {
            let (t, s) = invert(this, next, point)?;
            let from_line = (gap % per_line) as f64 + t;
            let nearest = gap / per_line + usize::from(from_line > per_line as f64 / 2.0);
            Some(Place {
                line: nearest % lines,
                s,
                u: this.u + t * (next_u - this.u),
                v: this.v + t * (next_v - this.v),
                composition: this.composition(s).mix(&next.composition(s), t),
            })
        })
    }
}

/// Solves point = (1 - s) P(t) + s Q(t) on the patch between two rulings, for t and s in [0, 1].
///
/// P and Q are the sides on the two curves. The point lies on the ruling at t when (point - P(t)) and (Q(t) - P(t)) are
/// parallel, which is a quadratic in t.
fn invert(this: &Ruling, next: &Ruling, point: DVec2) -> Option<(f64, f64)> {
    let corners = [this.from, this.to, next.from, next.to];
    let (low, high) = corners.iter().fold((corners[0], corners[0]), |(l, h), &c| (l.min(c), h.max(c)));
    let slack = (high - low).max_element() * SLACK;
    if (point - low).min_element() < -slack || (high - point).min_element() < -slack {
        return None;
    }
    let (offset, along) = (point - this.from, this.to - this.from);
    let side = next.from - this.from;
    let turn = (next.to - next.from) - along;
    let (a, b, c) =
        (-side.perp_dot(turn), offset.perp_dot(turn) - side.perp_dot(along), offset.perp_dot(along));
    roots(a, b, c).into_iter().flatten().find_map(|t| {
        let t = t.clamp(0.0, 1.0);
        let ruling = along + t * turn;
        let s = ((offset - t * side).dot(ruling) / ruling.length_squared()).clamp(0.0, 1.0);
        // Near an end that both rulings share any t will do, so the place is what counts.
        ((offset - t * side - s * ruling).length() <= slack).then_some((t, s))
    })
}

/// Real roots of a t² + b t + c, without cancellation.
fn roots(a: f64, b: f64, c: f64) -> [Option<f64>; 2] {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return [None, None];
    }
    let q = -(b + discriminant.sqrt().copysign(b)) / 2.0;
    let finite = |x: f64| x.is_finite().then_some(x);
    [finite(c / q), finite(q / a)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec2;

    fn ruling(from: DVec2, to: DVec2) -> Ruling {
        let ends = [Composition::pure(0, 2), Composition::pure(1, 2)];
        Ruling { u: 0.0, v: 0.0, from, to, ends }
    }

    #[test]
    fn a_patch_is_inverted() {
        let patches = [
            (ruling(dvec2(0.0, 0.0), dvec2(0.0, 2.0)), ruling(dvec2(1.0, 0.0), dvec2(3.0, 2.5))),
            (ruling(dvec2(0.0, 0.0), dvec2(0.0, 2.0)), ruling(dvec2(1.0, 0.0), dvec2(1.0, 2.0))),
            (ruling(dvec2(0.0, 0.0), dvec2(0.0, 2.0)), ruling(dvec2(0.0, 0.0), dvec2(1.0, 2.0))),
            (ruling(dvec2(0.0, 0.0), dvec2(0.0, 2.0)), ruling(dvec2(1.0, 0.0), dvec2(0.0, 2.0))),
        ];
        for (this, next) in &patches {
            for (t, s) in [(0.5, 0.5), (0.1, 0.9), (0.0, 0.3), (1.0, 0.6), (0.7, 0.01)] {
                let point = this.point(s).lerp(next.point(s), t);
                let (found_t, found_s) = invert(this, next, point).expect("inside");
                assert!(
                    (found_t - t).abs() < 1e-9 && (found_s - s).abs() < 1e-9,
                    "{this:?} {next:?} {t} {s}"
                );
            }
            assert_eq!(invert(this, next, dvec2(-1.0, 1.0)), None);
        }
    }

    /// A ulp beside the ruling is a long way round the shared end: points there fell between the patches.
    #[test]
    fn points_of_a_ruling_near_a_shared_end_are_inside() {
        for k in 0..200 {
            let end = dvec2(31.7, 40.3 - 0.13 * f64::from(k));
            let rulings = [dvec2(7.1, 9.3), dvec2(7.6, 9.1), dvec2(8.2, 8.8)].map(|from| ruling(from, end));
            let point = rulings[1].point(1.0 - 0.1_f64.powf(f64::from(k) / 16.0));
            let found = [invert(&rulings[0], &rulings[1], point), invert(&rulings[1], &rulings[2], point)];
            assert!(found.iter().any(Option::is_some), "{k}");
        }
    }

    #[test]
    fn roots_of_quadratics() {
        let sorted = |a, b, c| {
            let mut found: Vec<f64> = roots(a, b, c).into_iter().flatten().collect();
            found.sort_by(f64::total_cmp);
            found
        };
        assert_eq!(sorted(1.0, -3.0, 2.0), [1.0, 2.0]);
        assert_eq!(sorted(0.0, 2.0, -1.0), [0.5], "a linear equation");
        assert!(sorted(1.0, 0.0, 1.0).is_empty());
        assert!(sorted(0.0, 0.0, 1.0).is_empty());
    }
}
