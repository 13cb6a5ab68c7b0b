//! As many samples as the shape of a curve needs.

use super::arc_length::ArcLength;
use super::bezier::Bezier;
use super::bspline::BSpline;
use super::cone::Cone;
use super::flatten::reach_squared;
use super::sample::Samples;
use crate::geom::order_by_number;
use glam::DVec2;

/// How fine adaptive samples are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fineness {
    /// Greatest distance of the curve from the chord that joins two neighbouring samples, positive.
    pub tolerance: f64,
    /// Greatest angle in degrees between two tangents from one sample to the next, positive.
    pub max_turn: f64,
    /// Fewest samples, at least 3; they are spread evenly before any more are added.
    pub min_count: usize,
}

/// Most samples of one curve.
const MOST: usize = 1000;
/// A stretch shorter than this part of the curve is kept whole: what still turns there is as good as a corner.
const SHORTEST: f64 = 1e-9;
/// Legs of control polygons shorter than this part of their stretch have no direction: next to a cusp they are rounding noise.
const NOISE: f64 = 1e-7;

/// Takes samples of a curve such that between neighbours it stays near the chord and turns little; the first is at the start
/// of its domain. Also tells whether that holds everywhere: where it takes more than 1000 samples, the worst
/// places have them. On an open curve the last sample is at its end.
///
/// Corners always become samples. The smooth stretches between them are cut evenly by arc length into the fewest samples
/// asked for; then a stretch that is not fine enough is halved, near its middle at a knot where the curve is only C1 if there
/// is one. Deviation and turn are bounded by control points of a quarter of a knot span each, so both hold for
/// every point of the curve, and few samples more are taken than they need.
///
/// # Panics
/// When the fewest samples asked for are below 3.
#[must_use]
pub fn sample_adaptively(curve: &BSpline, fineness: Fineness) -> (Samples, bool) {
    assert!(fineness.min_count >= 3, "a curve needs at least 3 samples, not {}", fineness.min_count);
    let mut sampler = Sampler::new(curve, fineness);
    let mut stretches = sampler.first_stretches();
    let is_fine = loop {
        let worst = (0..stretches.len()).max_by(|&i, &k| stretches[i].excess.total_cmp(&stretches[k].excess));
        match worst {
            Some(worst) if stretches[worst].excess > 1.0 => {
                if stretches.len() == sampler.most {
                    break false;
                }
                let [first, second] = sampler.halves(&stretches[worst]);
                stretches[worst] = first;
                stretches.push(second);
            }
            _ => break sampler.all_corners,
        }
    };
    let order = order_by_number(stretches.len(), |i| stretches[i].start.s);
    let mut places: Vec<Place> = order.into_iter().map(|i| stretches[i].start).collect();
    if !curve.is_closed() {
        places.push(Place { u: curve.domain().1, s: sampler.arc_length.total() });
    }
    let parameters: Vec<f64> = places.iter().map(|place| place.u).collect();
    let samples = Samples {
        points: parameters.iter().map(|&u| curve.point(u)).collect(),
        normals: parameters.iter().map(|&u| curve.normal(u)).collect(),
        arc: places.iter().map(|place| place.s).collect(),
        length: sampler.arc_length.total(),
        parameters,
    };
    (samples, is_fine)
}

/// A place on a curve.
#[derive(Debug, Clone, Copy)]
struct Place {
    /// Parameter.
    u: f64,
    /// Arc length from the start of the domain.
    s: f64,
}

/// The curve from one sample to the next.
#[derive(Debug)]
struct Stretch {
    start: Place,
    end: Place,
    /// How many times coarser it is than it may be.
    excess: f64,
}

struct Sampler<'a> {
    curve: &'a BSpline,
    fineness: Fineness,
    arc_length: ArcLength,
    center: DVec2,
    pieces: Vec<Bezier>,
    /// Knots at which the curve is C1 or less, ascending.
    weak: Vec<Place>,
    /// Whether there was room for every corner.
    all_corners: bool,
    /// Most stretches, and the fewest: an open curve has one less than it has samples.
    most: usize,
    fewest: usize,
}

impl<'a> Sampler<'a> {
    fn new(curve: &'a BSpline, fineness: Fineness) -> Self {
        let (arc_length, center) = (curve.arc_length(), curve.bounds().center());
        let pieces = curve.pieces(center);
        let (knots, p) = (curve.knots(), curve.degree());
        let is_weak = |&u: &f64| knots.iter().filter(|&&knot| knot == u).count() + 1 >= p;
        let place = |u: f64| Place { u, s: arc_length.at(u) };
        let weak = pieces.iter().map(|piece| piece.lo).filter(is_weak).map(place).collect();
        let ends = usize::from(!curve.is_closed());
        let (most, fewest) = (MOST - ends, fineness.min_count - ends);
        Self { curve, fineness, center, pieces, weak, arc_length, all_corners: true, most, fewest }
    }

    /// The smooth stretches between corners, cut evenly into the fewest samples asked for.
    fn first_stretches(&mut self) -> Vec<Stretch> {
        let ((lo, hi), total) = (self.curve.domain(), self.arc_length.total());
        let mut ends = vec![Place { u: lo, s: 0.0 }];
        for corner in self.curve.corners() {
            let s = self.arc_length.at(corner.u);
            let is_apart = s - ends[ends.len() - 1].s > SHORTEST * total && total - s > SHORTEST * total;
            if is_apart && ends.len() < self.most {
                ends.push(Place { u: corner.u, s });
            } else {
                self.all_corners &= !is_apart;
            }
        }
        let mut room = self.most - ends.len();
        ends.push(Place { u: hi, s: total });
        let mut stretches = Vec::new();
        for pair in ends.windows(2) {
            let (start, end) = (pair[0], pair[1]);
            let share = (end.s - start.s) / total * self.fewest as f64;
            let parts = ((share - SHORTEST).ceil() as usize).clamp(1, room + 1);
            room -= parts - 1;
            let mut from = start;
            for part in 1..=parts {
                let s = start.s + (end.s - start.s) * part as f64 / parts as f64;
                let to = if part == parts { end } else { Place { u: self.arc_length.parameter(s), s } };
                stretches.push(self.stretch(from, to));
                from = to;
            }
        }
        stretches
    }

    /// Cuts a stretch near its middle.
    fn halves(&self, stretch: &Stretch) -> [Stretch; 2] {
        let Stretch { start, end, .. } = *stretch;
        let (length, s) = (end.s - start.s, (start.s + end.s) / 2.0);
        let off = |place: &Place| (place.s - s).abs();
        let weak = self.weak.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        let middle = match weak {
            Some(&place) if off(&place) <= length / 4.0 => place,
            _ => Place { u: self.arc_length.parameter(s), s },
        };
        [self.stretch(start, middle), self.stretch(middle, end)]
    }

    fn stretch(&self, start: Place, end: Place) -> Stretch {
        let length = end.s - start.s;
        let is_whole = length <= SHORTEST * self.arc_length.total();
        Stretch {
            start,
            end,
            excess: if is_whole { 0.0 } else { self.excess(start.u, end.u, NOISE * length) },
        }
    }

    fn excess(&self, from: f64, to: f64, noise: f64) -> f64 {
        let ends = [from, to].map(|u| self.curve.point(u) - self.center);
        let (mut reach, mut cone) = (0.0_f64, Cone::Empty);
        let first = self.pieces.partition_point(|piece| piece.hi <= from);
        for piece in self.pieces[first..].iter().take_while(|piece| piece.lo < to) {
            let (left, right) = piece.between(from, to).halves();
            let quarters = [left.halves(), right.halves()];
            for quarter in quarters.iter().flat_map(|(left, right)| [left, right]) {
                reach = reach.max(reach_squared(&quarter.points, ends[0], ends[1]));
                cone = cone.union(Cone::of_legs(&quarter.points, noise));
            }
        }
        // The angle of evenly cut circles may be the limit itself, give or take rounding.
        let turn = cone.angle().to_degrees() / (self.fineness.max_turn * (1.0 + 1e-9));
        turn.max(reach.sqrt() / self.fineness.tolerance)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::Form;

    fn curve(degree: usize, points: &[(f64, f64)]) -> BSpline {
        let points = points.iter().copied().map(DVec2::from).collect();
        BSpline::new(degree, Form::Periodic, points, None).expect("a valid curve")
    }

    /// A cubic that follows a circle of radius 1 to about 1e-6: its control points lie a little outside.
    fn circle() -> BSpline {
        let step = std::f64::consts::TAU / 64.0;
        let reach = 3.0 / (2.0 + step.cos());
        let points: Vec<_> =
            (0..64).map(|k| (reach * DVec2::from_angle(step * f64::from(k))).into()).collect();
        curve(3, &points)
    }

    #[test]
    fn a_circle_has_the_number_of_samples_that_its_sagitta_and_turn_ask_for() {
        let circle = circle();
        // n chords of a circle lie 1 - cos(pi / n) inside, and the tangent turns by 360 / n from one end to the other.
        for (tolerance, max_turn, min_count, expected) in [
            (1.0, 90.0, 7, 7),
            (1.0, 31.0, 12, 12),
            (1.0, 29.0, 12, 24),
            (1.0, 14.0, 12, 48),
            (0.035, 90.0, 12, 12),
            (0.033, 90.0, 12, 24),
            (0.002, 90.0, 12, 96),
            (0.002, 90.0, 10, 80),
            (0.035, 1.1, 12, 384),
        ] {
            let (samples, is_fine) = sample_adaptively(&circle, Fineness { tolerance, max_turn, min_count });
            assert!(is_fine);
            assert_eq!(samples.points.len(), expected, "{tolerance} {max_turn} {min_count}");
            let even = samples.length / expected as f64;
            assert!(samples.arc.windows(2).all(|w| (w[1] - w[0] - even).abs() < 1e-9));
        }
    }

    #[test]
    fn an_s_whose_middle_lies_on_the_chord_is_cut() {
        // The first span has control points that are symmetric about the origin, through which its chord passes.
        let wave = curve(3, &[(-3.0, 0.0), (-1.0, 2.0), (1.0, -2.0), (3.0, 0.0), (3.0, -9.0), (-3.0, -9.0)]);
        let sampler = Sampler::new(&wave, Fineness { tolerance: 0.01, max_turn: 90.0, min_count: 3 });
        let ends = [wave.domain().0, wave.domain().0 + 1.0 / 6.0];
        let chord = wave.point(ends[1]) - wave.point(ends[0]);
        let off = |share: f64| {
            let point = wave.point(ends[0] + share * (ends[1] - ends[0]));
            chord.normalize().perp_dot(point - wave.point(ends[0]))
        };
        assert!(off(0.5).abs() < 1e-12 && off(0.25).abs() > 0.02, "an S through its chord");
        assert!(sampler.excess(ends[0], ends[1], 0.0) > 2.0);
    }

    #[test]
    fn beyond_the_limit_the_worst_places_have_the_samples() {
        let fineness = Fineness { tolerance: 1e-12, max_turn: 90.0, min_count: 3 };
        let (samples, is_fine) = sample_adaptively(&circle(), fineness);
        assert!(!is_fine);
        assert_eq!(samples.points.len(), MOST);
        let steps: Vec<f64> = samples.arc.windows(2).map(|w| w[1] - w[0]).collect();
        let longest = steps.iter().fold(0.0, |a: f64, &b| a.max(b));
        assert!(longest < 2.1 * samples.length / MOST as f64, "spread over the whole circle: {longest}");
    }
}
