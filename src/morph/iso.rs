//! Lines of equal composition across the band.

use super::{Band, Ruling};
use glam::DVec2;

/// A polyline along which the fraction of one material has one value.
#[derive(Debug, Clone, PartialEq)]
pub struct IsoLine {
    /// Points, in order round the band; a closed line does not repeat the first one.
    pub points: Vec<DVec2>,
    /// Whether the last point is followed by the first; an open line ends on the curves, or on the first or the last ruling of an open band.
    pub closed: bool,
}

/// Part of the way across the band that a line goes at most from one of its points to the next.
const STRIDE: f64 = 1.0 / 16.0;

impl Band {
    /// Lines that part the places with at least the fraction `level` of a material from the others.
    ///
    /// Every point has the fraction exactly, by [`locate`](Self::locate) as well unless patches overlap there: along a ruling fractions are
    /// linear, and between two rulings they are bilinear, so that a saddle is decided by its own middle. Where both curves have the fraction all along a
    /// stretch there is no line but an area, and nothing is returned for it.
    ///
    /// # Panics
    /// When there is no such material.
    #[must_use]
    pub fn iso_lines(&self, material: usize, level: f64) -> Vec<IsoLine> {
        let mut lines: Vec<IsoLine> = Vec::new();
        let mut line = Vec::new();
        let mut crosses_seam = false;
        for (this, next, _) in self.gaps() {
            let patch = Patch::new(this, next, material, level);
            let ends = patch.ends();
            crosses_seam = patch.crosses(1);
            for (k, piece) in ends.chunks_exact(2).enumerate() {
                patch.follow(piece[0], piece[1], &mut line);
                if !crosses_seam || 2 * k + 2 < ends.len() {
                    lines.push(IsoLine { points: std::mem::take(&mut line), closed: false });
                }
            }
        }
        if crosses_seam && !self.is_closed() {
            lines.push(IsoLine { points: line, closed: false });
        } else if crosses_seam {
            // The line came back to the first ruling: to the start of the line that began there, or to its own.
            if let Some(first) = lines.first_mut() {
                line.extend(first.points.drain(1..));
                first.points = line;
            } else {
                line.pop();
                lines.push(IsoLine { points: line, closed: true });
            }
        }
        // What only touches the level is a point.
        lines.retain(|line| line.points.len() > 1);
        lines
    }
}

/// A place on a patch: the share t of the way from its first ruling to the next, and the share s along the ruling.
type Place = (f64, f64);

/// The patch between two rulings, with the fraction above the level at its corners: on the first curve at both rulings, then on
/// the second.
struct Patch<'a> {
    this: &'a Ruling,
    next: &'a Ruling,
    sides: [[f64; 2]; 2],
}

impl<'a> Patch<'a> {
    fn new(this: &'a Ruling, next: &'a Ruling, material: usize, level: f64) -> Self {
        let above = |ruling: &Ruling, curve: usize| ruling.ends[curve].fractions()[material] - level;
        Self { this, next, sides: [0, 1].map(|curve| [above(this, curve), above(next, curve)]) }
    }

    /// Whether the line crosses the first ruling (0) or the next (1).
    fn crosses(&self, ruling: usize) -> bool {
        is_above(self.sides[0][ruling]) != is_above(self.sides[1][ruling])
    }

    /// Where the line enters and leaves the patch, by turns, in order of t. On a patch the line is the graph of a function of t, for t
    /// where the two curves lie on different sides of the level.
    fn ends(&self) -> Vec<Place> {
        let [a, b] = self.sides;
        let on_ruling = |k: usize| self.crosses(k).then(|| (k as f64, root(a[k], b[k])));
        let on_curve = |curve: usize| {
            let [x, y] = self.sides[curve];
            (is_above(x) != is_above(y)).then(|| (root(x, y), curve as f64))
        };
        let (mut first, mut second) = (on_curve(0), on_curve(1));
        if let (Some((t, _)), Some((u, _))) = (first, second)
            && u < t
        {
            std::mem::swap(&mut first, &mut second);
        }
        [on_ruling(0), first, second, on_ruling(1)].into_iter().flatten().collect()
    }

    /// Adds the points of the line from one end to another, without those that repeat the last one.
    fn follow(&self, from: Place, to: Place, line: &mut Vec<DVec2>) {
        let [a, b] = self.sides;
        let steps = ((to.1 - from.1).abs() / STRIDE).ceil().max(1.0);
        let inner = (1..steps as u32).map(|step| {
            let s = from.1 + (to.1 - from.1) * f64::from(step) / steps;
            let [x, y] = [0, 1].map(|k| a[k] + s * (b[k] - a[k]));
            // Where rounding leaves no single t on the line, an end does.
            (root(x, y).max(from.0).min(to.0), s)
        });
        for place in std::iter::once(from).chain(inner).chain([to]) {
            let point = self.point(place);
            if line.last() != Some(&point) {
                line.push(point);
            }
        }
    }

    fn point(&self, (t, s): Place) -> DVec2 {
        self.this.point(s).lerp(self.next.point(s), t)
    }
}

/// Whether a fraction reaches the level.
fn is_above(difference: f64) -> bool {
    difference >= 0.0
}

/// Where a linear function from `x` at 0 to `y` at 1 is zero.
fn root(x: f64, y: f64) -> f64 {
    x / (x - y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::{BSpline, Form};
    use crate::material::{Composition, Profile};
    use glam::dvec2;
    use proptest::prelude::*;

    /// A round curve and one three times its size, matched at `lines` places, with two materials: `keys` of each curve
    /// give the place and the fraction of the first.
    fn band(lines: usize, keys: [&[(f64, f64)]; 2]) -> Band {
        let curve = |r: f64| {
            let points = (0..24).map(|k| r * DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / 24.0));
            BSpline::new(3, Form::Periodic, points.collect(), None).expect("a valid curve")
        };
        let parameters = (0..lines).map(|k| k as f64 / lines as f64);
        let straight: Vec<(f64, f64)> = parameters.map(|u| (u, u)).collect();
        let profiles = keys.map(|keys| {
            let pair = |f: f64| Composition::new(vec![f, 1.0 - f]).expect("a composition");
            Profile::new(keys.iter().map(|&(at, f)| (at, pair(f))).collect(), true).expect("a profile")
        });
        let compose = |curve: usize, u: f64| profiles[curve].at(u);
        Band::new(&[curve(1.0), curve(3.0)], &straight, compose, 4)
    }

    fn fraction(band: &Band, point: DVec2) -> f64 {
        band.locate(point).expect("inside the band").composition.fractions()[0]
    }

    #[test]
    fn between_two_pure_curves_the_lines_are_in_betweens() {
        let band = band(44, [&[(0.0, 1.0)], &[(0.0, 0.0)]]);
        for level in [0.1, 0.5, 0.75] {
            let lines = band.iso_lines(0, level);
            assert_eq!(lines.len(), 1);
            assert!(lines[0].closed);
            assert_eq!(lines[0].points.len(), 176);
            for (found, expected) in lines[0].points.iter().zip(band.in_between(1.0 - level)) {
                assert!((*found - expected).length() < 1e-12);
            }
            // The round curve is a circle to one part in 10,000, so the line is one of the known radius.
            let radius = band.rulings()[0].from.length();
            for point in &lines[0].points {
                assert!((point.length() / radius - (1.0 + 2.0 * (1.0 - level))).abs() < 1e-3);
            }
        }
        assert_eq!(band.iso_lines(1, 0.25)[0].points.len(), 176, "the other material mirrors it");
    }

    #[test]
    fn a_level_that_a_curve_has_all_along_follows_the_curve_or_is_an_area() {
        let half = band(20, [&[(0.0, 0.5)], &[(0.0, 0.0)]]);
        let lines = half.iso_lines(0, 0.5);
        assert_eq!(lines[0].points, half.in_between(0.0));
        assert!(half.iso_lines(0, 0.6).is_empty());
        let flat = band(20, [&[(0.0, 0.5)], &[(0.0, 0.5)]]);
        assert!(flat.iso_lines(0, 0.5).is_empty());
    }

    /// The outer curve goes from all of the material to none and back; the inner one has none. The line of the level is
    /// s = level / outer fraction, open where the outer fraction falls below the level.
    #[test]
    fn a_heterogeneous_curve_gives_the_line_of_the_closed_form() {
        let band = band(40, [&[(0.0, 0.0)], &[(0.0, 0.0), (0.5, 1.0)]]);
        for level in [0.25, 0.5, 0.8] {
            let lines = band.iso_lines(0, level);
            assert_eq!(lines.len(), 1);
            assert!(!lines[0].closed);
            for end in [lines[0].points[0], lines[0].points[lines[0].points.len() - 1]] {
                let place = band.locate(end).expect("inside");
                assert!((place.s - 1.0).abs() < 1e-9, "ends on the outer curve");
            }
            for &point in &lines[0].points {
                let place = band.locate(point).expect("inside");
                let outer = 1.0 - (2.0 * place.v - 1.0).abs();
                assert!((place.s - level / outer).abs() < 1e-9, "{place:?}");
            }
        }
    }

    #[test]
    fn a_line_over_the_seam_is_one_line() {
        let band = band(30, [&[(0.0, 0.0)], &[(0.1, 0.2), (0.3, 0.0), (0.9, 1.0)]]);
        let lines = band.iso_lines(0, 0.5);
        assert_eq!(lines.len(), 1);
        let longest = lines[0].points.windows(2).map(|w| w[0].distance(w[1])).fold(0.0, f64::max);
        assert!(longest < 0.3, "no jump: {longest}");
    }

    /// On one patch the corners lie above and below the level by turns: the middle decides which of them are joined.
    #[test]
    fn a_saddle_is_decided_by_its_middle() {
        let corner = |x: f64, y: f64, near: f64, far: f64| Ruling {
            u: 0.0,
            v: 0.0,
            from: dvec2(x, y),
            to: dvec2(x, y + 1.0),
            ends: [near, far].map(|f| Composition::new(vec![f, 1.0 - f]).expect("a composition")),
        };
        let (this, next) = (corner(0.0, 0.0, 0.9, 0.1), corner(1.0, 0.0, 0.2, 0.8));
        // The value of the saddle itself: (ad - bc) / (a + d - b - c) for corners a, b, c, d.
        let saddle = (0.9 * 0.8 - 0.1 * 0.2) / (0.9 + 0.8 - 0.1 - 0.2);
        for (level, joined) in [(saddle - 0.01, true), (saddle + 0.01, false)] {
            let ends = Patch::new(&this, &next, 0, level).ends();
            assert_eq!(ends.len(), 4);
            // Below the saddle the high corners are joined, so that the line cuts off the low ones, at the second curve
            // on the first ruling and at the first curve on the next.
            assert_eq!(ends[1].1, if joined { 1.0 } else { 0.0 }, "{ends:?}");
            assert!(ends[1].0 < ends[2].0);
        }
    }

    /// Every point has the fraction, and inside a ruling there is a point exactly where its ends lie on different sides.
    #[test]
    fn lines_part_the_band_for_random_profiles() {
        let profile =
            prop::collection::vec((0.0..1.0, 0.0..1.0), 1..5).prop_filter_map("ascending", |mut keys| {
                keys.sort_by(|a, b| f64::total_cmp(&a.0, &b.0));
                keys.windows(2).all(|w| w[1].0 - w[0].0 > 0.01).then_some(keys)
            });
        let config = ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() };
        proptest!(config, |(inner in profile.clone(), outer in profile, level in 0.02..0.98)| {
            let band = band(24, [&inner, &outer]);
            let lines = band.iso_lines(0, level);
            for line in &lines {
                prop_assert!(line.points.len() > 1);
                for &point in &line.points {
                    prop_assert!((fraction(&band, point) - level).abs() < 1e-6, "{}", fraction(&band, point));
                }
                if !line.closed {
                    for end in [line.points[0], line.points[line.points.len() - 1]] {
                        let s = band.locate(end).expect("inside").s;
                        prop_assert!(s.min(1.0 - s) < 1e-9, "an open line ends on a curve: {}", s);
                    }
                }
            }
            for ruling in band.rulings() {
                let side = |curve: usize| ruling.ends[curve].fractions()[0] >= level;
                let along = ruling.to - ruling.from;
                let met = lines.iter().flat_map(|line| &line.points).any(|&point| {
                    let s = (point - ruling.from).dot(along) / along.length_squared();
                    (1e-9..1.0 - 1e-9).contains(&s) && point.distance(ruling.point(s)) < 1e-12
                });
                prop_assert_eq!(met, side(0) != side(1));
            }
        });
    }
}
