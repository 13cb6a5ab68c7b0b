//! Corners, and the normals of a curve that may have them.

use glam::DVec2;

use super::bezier::Bezier;
use super::bspline::BSpline;
use super::cone::Cone;
use super::nearest::nearest_of;
use crate::geom::order_by_number;

/// Smallest turn in degrees that makes a corner. Control points written with six digits leave turns of about
/// 1e-4 where a smooth join was meant; no picture shows a hundredth of a degree.
const SMALLEST_TURN: f64 = 0.01;
/// A piece smaller than this, relative to the curve, is a place where the curve stands still.
const STANDSTILL: f64 = 1e-13;
/// A speed below this part of the largest on its piece is taken for zero: the cusp that rounding leaves of an exact one.
const CUSP_SPEED: f64 = 1e-7;
/// A derivative shorter than this part of its control vectors has lost half its digits or more to cancellation.
const SLOW: f64 = 1e-8;

/// A place where the tangent of a curve jumps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner {
    /// Parameter in the domain of the curve; where the curve stands still, the start of the stretch.
    pub u: f64,
    /// The point of the curve there.
    pub at: DVec2,
    /// Angle in degrees from the tangent before to the tangent after: positive to the left, in (-180, 180]; 180 where
    /// the curve turns back.
    pub turn: f64,
}

/// Unit tangents before and after a place.
#[derive(Debug, Clone, Copy)]
struct Tangents {
    before: DVec2,
    after: DVec2,
}

impl Tangents {
    /// Stands in where rounding leaves no direction at all.
    const UNKNOWN: Self = Self { before: DVec2::X, after: DVec2::X };

    /// Angle in radians from the tangent before to the one after, in (-pi, pi].
    fn turn(self) -> f64 {
        let turn = self.before.perp_dot(self.after).atan2(self.before.dot(self.after));
        // A rounding error must not decide between a half turn to the left and one to the right.
        if turn < 1e-9 - std::f64::consts::PI { std::f64::consts::PI } else { turn }
    }

    /// Unit vector that bisects the two right-hand normals; forwards along the tangent where the curve turns back.
    fn normal(self) -> DVec2 {
        let middle = DVec2::from_angle(self.turn() / 2.0).rotate(self.before);
        -middle.perp()
    }
}

impl BSpline {
    /// Right-hand unit normal at u, outward on a counter-clockwise curve.
    ///
    /// At a corner it bisects the normals on both sides, as on a stretch where the curve stands still; at a cusp it
    /// is the tangent before. A u within about 1e-10 of the domain of a knot counts as the knot. Always a
    /// unit vector, never NaN.
    #[must_use]
    pub fn normal(&self, u: f64) -> DVec2 {
        let wrapped = self.wrap(u);
        let snapped = self.snap(wrapped);
        let k = self.span_index(snapped);
        // A knot of lower multiplicity than the degree leaves the derivative continuous.
        let may_jump = self.knots()[k + 1 - self.degree()] == snapped;
        if !may_jump {
            let (derivative, scale) = self.derivative_and_scale(wrapped);
            if derivative.length() > SLOW * scale {
                return -derivative.normalize().perp();
            }
        }
        self.tangents(snapped).normal()
    }

    /// All corners in ascending order: places where the direction of the tangent jumps by more than 0.01 degrees.
    ///
    /// They come from knots whose multiplicity equals the degree, from coincident control points, from the seam of
    /// a clamped curve, and from cusps inside a span. A jump of speed alone, the direction being kept, is no corner.
    #[must_use]
    pub fn corners(&self) -> Vec<Corner> {
        let center = self.bounds().center();
        let pieces = self.moving_pieces(center);
        let mut found: Vec<Corner> = Vec::new();
        for (i, piece) in pieces.iter().enumerate() {
            let before = &pieces[(i + pieces.len() - 1) % pieces.len()];
            if (i > 0 || self.is_closed())
                && let (Some((incoming, _)), Some((_, outgoing))) =
                    (before.tangents(1.0), piece.tangents(0.0))
            {
                let u = self.wrap(before.hi);
                found.extend(self.corner(u, Tangents { before: incoming, after: outgoing }));
            }
            let cusp = cusp(piece);
            found.extend(cusp.and_then(|(u, tangents)| self.corner(u, tangents)));
        }
        order_by_number(found.len(), |i| found[i].u).into_iter().map(|i| found[i]).collect()
    }

    fn corner(&self, u: f64, tangents: Tangents) -> Option<Corner> {
        let turn = tangents.turn().to_degrees();
        (turn.abs() > SMALLEST_TURN).then(|| Corner { u, at: self.point(u), turn })
    }

    /// Bezier pieces relative to `origin` without those on which the curve stands still; at least one is left.
    pub(super) fn moving_pieces(&self, origin: DVec2) -> Vec<Bezier> {
        let mut pieces = self.pieces(origin);
        let largest = pieces.iter().map(Bezier::extent).fold(0.0, f64::max);
        let smallest = self.standstill().min(largest);
        pieces.retain(|piece| piece.extent() >= smallest);
        pieces
    }

    /// Extent below which the curve stands still on a piece.
    fn standstill(&self) -> f64 {
        let bounds = self.bounds();
        STANDSTILL * (bounds.max - bounds.min).max_element()
    }

    /// Tangents on both sides of u in the domain, a knot or a place where the derivative vanishes; at an end of an open curve both are the
    /// one there is.
    fn tangents(&self, u: f64) -> Tangents {
        let (center, smallest) = (self.bounds().center(), self.standstill());
        let moving = |k: usize| self.piece(k, center).filter(|piece| piece.extent() >= smallest);
        let (p, k) = (self.degree(), self.span_index(u));
        let spans = self.knots().len() - 1 - 2 * p;
        if let Some(piece) = moving(k).filter(|piece| u > piece.lo) {
            let inside = piece.tangents((u - piece.lo) / (piece.hi - piece.lo));
            return inside.map_or(Tangents::UNKNOWN, |(before, after)| Tangents { before, after });
        }
        let cyclic = |steps: usize| p + (k - p + steps) % spans;
        let (ahead, behind) = if self.is_closed() { (spans, spans) } else { (spans + p - k, k - p) };
        let after = (0..ahead).find_map(|i| moving(cyclic(i))?.tangents(0.0));
        let before = (1..=behind).find_map(|i| moving(cyclic(spans - i))?.tangents(1.0));
        match (before, after) {
            (Some((before, _)), Some((_, after))) => Tangents { before, after },
            (Some((only, _)), None) | (None, Some((_, only))) => Tangents { before: only, after: only },
            (None, None) => Tangents::UNKNOWN,
        }
    }
}

/// The cusp inside a piece, if it has one: parameter and tangents.
fn cusp(piece: &Bezier) -> Option<(f64, Tangents)> {
    // The velocity can vanish only when its hull holds the origin.
    if Cone::of_legs(&piece.points, STANDSTILL * piece.extent()).is_narrow() {
        return None;
    }
    let velocity = piece.hodograph();
    let largest = velocity.points.iter().fold(0.0_f64, |m, v| m.max(v.length_squared()));
    let slowest = nearest_of(vec![velocity]);
    let t = (slowest.u - piece.lo) / (piece.hi - piece.lo);
    let margin = 1e-9;
    if slowest.distance_sq > CUSP_SPEED * CUSP_SPEED * largest || !(margin..=1.0 - margin).contains(&t) {
        return None;
    }
    // The velocity is taken for zero at the slowest place, so the acceleration gives the direction.
    let acceleration = piece.hodograph().hodograph().point(t);
    let after = acceleration.try_normalize()?;
    Some((slowest.u, Tangents { before: -after, after }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::Form;

    fn curve(degree: usize, form: Form, points: &[(f64, f64)]) -> BSpline {
        BSpline::new(degree, form, points.iter().copied().map(DVec2::from).collect(), None).unwrap()
    }

    fn assert_near(a: DVec2, b: DVec2) {
        assert!((a - b).length() < 1e-9, "{a} and {b}");
    }

    #[test]
    fn a_smooth_curve_has_no_corner() {
        let smooth = curve(3, Form::Periodic, &[(2.0, 0.0), (0.0, 1.0), (-2.0, 0.0), (0.0, -1.0)]);
        assert_eq!(smooth.corners(), []);
        let right = smooth.domain().1 * 0.75;
        let derivative = smooth.derivative(right);
        assert_near(smooth.normal(right), -derivative.perp().normalize());
    }

    #[test]
    fn coincident_points_make_corners_with_bisector_normals() {
        // A square in straight cubic pieces: every corner of it three times.
        let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
        let tripled: Vec<_> = corners.iter().flat_map(|&c| [c; 3]).collect();
        let square = curve(3, Form::Periodic, &tripled);
        let found = square.corners();
        assert_eq!(found.len(), 4, "{found:?}");
        for corner in found {
            assert!((corner.turn - 90.0).abs() < 1e-9);
            assert_near(square.normal(corner.u), corner.at.normalize());
        }
    }

    #[test]
    fn a_stretch_at_a_standstill_is_one_corner() {
        let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
        let fivefold: Vec<_> = corners.iter().flat_map(|&c| [c; 5]).collect();
        let square = curve(3, Form::Periodic, &fivefold);
        let found = square.corners();
        assert_eq!(found.len(), 4, "{found:?}");
        for corner in found {
            // Two spans of length 1/20 stand still.
            for u in [0.0, 0.02, 0.05, 0.07, 0.1] {
                assert_near(square.normal(corner.u + u), corner.at.normalize());
            }
        }
    }

    #[test]
    fn the_clamped_seam_is_measured() {
        let smooth =
            curve(2, Form::Clamped, &[(0.0, -1.0), (1.0, -1.0), (0.0, 2.0), (-1.0, -1.0), (0.0, -1.0)]);
        assert_eq!(smooth.corners(), []);
        let tip = curve(2, Form::Clamped, &[(0.0, -1.0), (1.0, 0.0), (0.0, 2.0), (-1.0, 0.0), (0.0, -1.0)]);
        let found = tip.corners();
        assert_eq!((found.len(), found[0].u), (1, 0.0));
        assert!((found[0].turn - 90.0).abs() < 1e-9);
        assert_near(tip.normal(0.0), DVec2::NEG_Y);
        assert_near(tip.normal(1.0), DVec2::NEG_Y);
    }

    #[test]
    fn a_knot_of_full_multiplicity_is_a_corner_only_when_the_legs_turn() {
        let round =
            curve(3, Form::Periodic, &[(2.0, 0.0), (0.0, 1.0), (-2.0, 0.0), (0.0, -1.0), (1.0, -1.0)]);
        let full = (0..3).fold(round, |c, _| c.insert_knot(0.43).unwrap());
        assert_eq!(full.corners(), []);
        let at = full.point(0.43);
        let mut points = full.points().to_vec();
        let index = points.iter().position(|p| p.distance(at) < 1e-12).unwrap();
        points[index] += DVec2::new(-0.3, 0.4);
        let bent = BSpline::new(3, Form::Periodic, points, Some(full.knots().to_vec())).unwrap();
        assert_eq!(bent.corners().len(), 1);
        assert_eq!(bent.corners()[0].u, 0.43);
    }

    #[test]
    fn cusps_turn_back_and_have_a_normal() {
        // One clamped cubic piece with a cusp: the legs cross so that the velocity vanishes inside.
        let cusp = [(0.25, -0.125), (-1.0 / 12.0, 0.125), (-1.0 / 12.0, -0.125), (0.25, 0.125)];
        let mut points = cusp.to_vec();
        points.extend([(1.0, 1.0), (2.0, 0.0), (1.0, -1.0), (0.25, -0.125)]);
        let mut knots = vec![0.0; 4];
        knots.extend([1.0, 1.0, 1.0, 2.0, 3.0, 3.0, 3.0, 3.0]);
        let points = points.into_iter().map(DVec2::from).collect();
        let curve = BSpline::new(3, Form::Clamped, points, Some(knots)).unwrap();
        let found = curve.corners();
        let turned: Vec<_> = found.iter().filter(|c| (c.u - 0.5).abs() < 1e-6).collect();
        assert_eq!(turned.len(), 1, "{found:?}");
        assert!((turned[0].turn - 180.0).abs() < 1e-6);
        assert_near(curve.normal(0.5), DVec2::NEG_X);
    }

    #[test]
    fn a_spike_out_and_back_has_finite_normals_everywhere() {
        let spike = curve(2, Form::Clamped, &[(0.0, 0.0), (1.0, 0.0), (0.0, 0.0)]);
        let turns: Vec<_> = spike.corners().iter().map(|c| c.turn).collect();
        assert_eq!(turns, [180.0, 180.0]);
        for i in 0..=20 {
            assert!((spike.normal(f64::from(i) / 20.0).length() - 1.0).abs() < 1e-12);
        }
    }
}
