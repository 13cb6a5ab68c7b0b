//! Where the samples of a refinement lie on a curve.

use super::Outline;
use super::place::{end_at, shares_of};
use crate::curve::{ArcLength, BSpline};
use crate::geom::order_by_number;

/// Distance, in shares of arc length, between the two samples of a corner: far above rounding, and far below what an integral to 1e-4
/// notices.
pub(super) const APART: f64 = 1e-7;
/// Edges shorter than this share of the length are not cut.
const SHORTEST_CUT: f64 = 10.0 * APART;
/// Part of a step within which a corner takes the place of a sample.
const NEAR: f64 = 0.25;
/// Parts of each knot span, in which turns are measured.
const PARTS: usize = 64;
/// Share of the samples that are spread by turn, the others by arc length.
const BY_TURN: f64 = 0.3;

/// Spreads samples over a curve, half of them evenly by arc length and half evenly by turn, and two at each corner.
///
/// Values of lines change with the normals, so that an integral over samples that are even in both converges on tight bends as well. Of
/// the samples of a corner one lies a hair before it and has the normal of the side before, the other lies at it and has the normal of the
/// side after. So no line begins where the normal jumps: a correspondence passes a corner with lines to one side, then with lines to the
/// other, and between samples the values are smooth.
#[derive(Debug, Clone)]
pub(super) struct Spacing {
    curve: BSpline,
    arc_length: ArcLength,
    /// Corners in shares of arc length, ascending from 0 on.
    corners: Vec<f64>,
    /// Measures from 0 to 1 and the shares of arc length there; both ascend, straight from one to the next.
    measures: Vec<(f64, f64)>,
}

impl Spacing {
    pub(super) fn new(curve: &BSpline) -> Self {
        let arc_length = curve.arc_length();
        let corners = corner_shares(curve, &arc_length);
        let measures = measures(curve, &arc_length);
        Self { curve: curve.clone(), arc_length, corners, measures }
    }

    /// Takes `count` samples and those of the corners, the first at the start of the curve.
    pub(super) fn outline(&self, count: usize) -> Outline {
        let near = NEAR / count as f64;
        let corners: Vec<f64> = self.corners.iter().map(|&corner| self.measure(corner)).collect();
        let even = (0..count).map(|k| k as f64 / count as f64).filter(|&measure| {
            let away = |corner: &f64| ((measure - corner + 0.5).rem_euclid(1.0) - 0.5).abs() > near;
            // Places are counted from the start of the curve.
            (measure == 0.0 && corners.first() != Some(&0.0)) || corners.iter().all(away)
        });
        let sides = self.corners.iter().flat_map(|&corner| {
            let before = (corner - APART).rem_euclid(1.0);
            [(before, before), (corner, corner + APART)]
        });
        let even = even.map(|measure| self.share(measure));
        // Each with the place whose normal it has.
        let found: Vec<(f64, f64)> = even.map(|share| (share, share)).chain(sides).collect();
        let order = order_by_number(found.len(), |i| found[i].0);
        let mut places: Vec<(f64, f64)> = order.into_iter().map(|i| found[i]).collect();
        places.dedup_by(|next, before| next.0 - before.0 < APART / 2.0);
        let next = places.iter().map(|place| place.0).skip(1).chain([1.0]);
        let end = |share: f64| end_at(&self.curve, &self.arc_length, share);
        Outline {
            points: places.iter().map(|place| end(place.0).point).collect(),
            normals: places.iter().map(|place| end(place.1).normal).collect(),
            shares: places.iter().zip(next).map(|(place, next)| next - place.0).collect(),
            closed: true,
        }
    }

    /// Cuts each edge of an outline of these samples into parts of equal arc length, and tells the new number of each old vertex. An edge as
    /// short as that at a corner stays whole.
    pub(super) fn finer(&self, outline: &Outline, parts: &[usize]) -> (Outline, Vec<usize>) {
        let (mut points, mut normals, mut shares) = (Vec::new(), Vec::new(), Vec::new());
        let mut numbers = Vec::with_capacity(outline.len());
        for ((vertex, start), &parts) in shares_of(outline).into_iter().enumerate().zip(parts) {
            let edge = outline.shares[vertex];
            let parts = if edge < SHORTEST_CUT { 1 } else { parts };
            numbers.push(points.len());
            points.push(outline.points[vertex]);
            normals.push(outline.normals[vertex]);
            for k in 1..parts {
                let end = end_at(&self.curve, &self.arc_length, start + edge * k as f64 / parts as f64);
                points.push(end.point);
                normals.push(end.normal);
            }
            shares.extend(std::iter::repeat_n(edge / parts as f64, parts));
        }
        (Outline { points, normals, shares, closed: true }, numbers)
    }

    /// Share of arc length at a measure.
    fn share(&self, measure: f64) -> f64 {
        let after =
            self.measures.partition_point(|known| known.0 <= measure).clamp(1, self.measures.len() - 1);
        let ((m, s), (n, t)) = (self.measures[after - 1], self.measures[after]);
        s + (measure - m) / (n - m) * (t - s)
    }

    /// Measure at a share of arc length.
    fn measure(&self, share: f64) -> f64 {
        let after = self.measures.partition_point(|known| known.1 <= share).clamp(1, self.measures.len() - 1);
        let ((m, s), (n, t)) = (self.measures[after - 1], self.measures[after]);
        m + (share - s) / (t - s) * (n - m)
    }
}

/// Shares of arc length at which a curve has corners, ascending from 0 on.
pub(super) fn corner_shares(curve: &BSpline, arc_length: &ArcLength) -> Vec<f64> {
    let share = |u: f64| (arc_length.at(u) / arc_length.total()).clamp(0.0, 1.0);
    let at_seam = |share: &f64| *share < APART || *share > 1.0 - APART;
    let mut shares: Vec<f64> = curve.corners().iter().map(|corner| share(corner.u)).collect();
    shares.iter_mut().filter(|share| at_seam(share)).for_each(|share| *share = 0.0);
    shares.sort_unstable_by(f64::total_cmp);
    shares.dedup_by(|next, before| *next - *before < 2.0 * APART);
    shares
}

/// Arc length and turn together, from the start of a curve on.
fn measures(curve: &BSpline, arc_length: &ArcLength) -> Vec<(f64, f64)> {
    let (lo, hi) = curve.domain();
    let mut knots: Vec<f64> = curve.knots().iter().copied().filter(|u| (lo..=hi).contains(u)).collect();
    knots.dedup();
    let cuts =
        knots.windows(2).flat_map(|w| (0..PARTS).map(|k| w[0] + (w[1] - w[0]) * k as f64 / PARTS as f64));
    let cuts: Vec<f64> = cuts.chain([hi]).collect();
    let parts: Vec<(f64, f64)> = cuts
        .windows(2)
        .map(|w| {
            // Just inside, so that the turn of a corner does not count.
            let inside = |t: f64| curve.normal(w[0] + t * (w[1] - w[0]));
            let turn = inside(1e-3).angle_to(inside(1.0 - 1e-3)).abs();
            ((arc_length.at(w[1]) - arc_length.at(w[0])).max(0.0), turn)
        })
        .collect();
    let (length, turn) = parts.iter().fold((0.0, 0.0), |sum, part| (sum.0 + part.0, sum.1 + part.1));
    let by_turn = if turn > 0.0 { BY_TURN / turn } else { 0.0 };
    let (mut measure, mut share) = (0.0, 0.0);
    let mut measures = vec![(0.0, 0.0)];
    for (arc, turn) in parts.into_iter().filter(|part| part.0 > APART * length / 100.0) {
        measure += (1.0 - BY_TURN) * arc / length + by_turn * turn;
        share += arc / length;
        measures.push((measure, share));
    }
    measures.iter_mut().for_each(|(m, s)| (*m, *s) = (*m / measure, *s / share));
    measures
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::Form;
    use glam::{DVec2, dvec2};

    fn clamped(points: &[(f64, f64)]) -> BSpline {
        let points = points.iter().copied().map(DVec2::from).collect();
        BSpline::new(2, Form::Clamped, points, None).expect("a curve")
    }

    /// A square of straight pieces with three of its corners inside the domain and one at the seam.
    fn square() -> BSpline {
        let [a, b, c, d] = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
        clamped(&[a, a, b, b, c, c, d, d, a])
    }

    #[test]
    fn corners_are_two_samples_with_the_normals_of_their_sides() {
        let outline = Spacing::new(&square()).outline(40);
        let all: f64 = outline.shares.iter().sum();
        assert!((all - 1.0).abs() < 1e-12 && outline.shares.iter().all(|&share| share > 0.0));
        let n = outline.len();
        let is_corner = |k: &usize| (outline.points[*k].abs() - DVec2::ONE).length() < 1e-9;
        let corners: Vec<usize> = (0..n).filter(is_corner).collect();
        assert_eq!((corners.len(), corners[0]), (4, 0), "the seam comes first");
        for at in corners {
            let (before, after) = (outline.normals[(at + n - 1) % n], outline.normals[at]);
            assert!(before.perp_dot(after) > 1.0 - 1e-9, "a quarter turn to the left: {before} {after}");
            assert!(outline.points[(at + n - 1) % n].distance(outline.points[at]) < 1e-6);
        }
    }

    #[test]
    fn half_of_the_samples_follow_the_arc_and_the_others_the_turn() {
        // An ellipse bends most at its narrow ends; a circle everywhere the same.
        let ellipse = |b: f64| {
            let point = |k: usize| {
                let angle = std::f64::consts::TAU * k as f64 / 40.0;
                dvec2(angle.cos(), b * angle.sin())
            };
            BSpline::new(3, Form::Periodic, (0..40).map(point).collect(), None).expect("a curve")
        };
        let shares = |curve: &BSpline| {
            let shares = Spacing::new(curve).outline(200).shares;
            let of = |f: fn(f64, f64) -> f64, start: f64| shares.iter().copied().fold(start, f);
            (of(f64::min, 1.0), of(f64::max, 0.0))
        };
        let (least, most) = shares(&ellipse(1.0));
        assert!(most / least < 1.01, "{least} {most}");
        let (least, most) = shares(&ellipse(0.2));
        assert!(most / least > 2.0 && most < 1.0 / 200.0 / (1.0 - BY_TURN) * 1.01, "{least} {most}");
    }

    #[test]
    fn cut_edges_keep_their_samples_and_the_hair_at_a_corner() {
        let spacing = Spacing::new(&square());
        let coarse = spacing.outline(12);
        let parts: Vec<usize> = (0..coarse.len()).map(|k| 1 + k % 3).collect();
        let (fine, numbers) = spacing.finer(&coarse, &parts);
        for (old, &new) in numbers.iter().enumerate() {
            assert_eq!((coarse.points[old], coarse.normals[old]), (fine.points[new], fine.normals[new]));
            let end = numbers.get(old + 1).copied().unwrap_or(fine.len());
            let is_hair = coarse.shares[old] < SHORTEST_CUT;
            assert_eq!(end - new, if is_hair { 1 } else { parts[old] });
            let together: f64 = fine.shares[new..end].iter().sum();
            assert!((together - coarse.shares[old]).abs() < 1e-15);
        }
        assert!(fine.points.iter().all(|point| (point.abs().max_element() - 1.0).abs() < 1e-9));
    }
}
