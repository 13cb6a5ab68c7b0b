//! Lines along the gradient of the potential, from the inner curves to the outer one.

use super::Rings;
use super::field::distance;
use super::flow::Flow;
use crate::curve::BSpline;
use crate::geom::{SegmentGrid, segments_meet};
use glam::DVec2;

/// Most steps of a line; ordinary ones take some twenty.
const MOST_STEPS: usize = 4000;
/// Error of a step over the size of the boundary, or over so many lengths in which the potential would pass from curve to curve where these are less: beside a
/// tiny curve lines are as near to each other as it is small.
const TOLERANCE: f64 = 2e-5;
const LENGTHS: f64 = 10.0;
/// Way across the boundary with which a line begins and ends, over the length of the segments there: nearer to it the flux, constant on segments, shows.
const BESIDE: f64 = 0.5;
/// Share of the potential that this way passes at most.
const SHARE: f64 = 0.25;
/// Potential from which a line that has not passed there ends at what is nearest.
const BEYOND: f64 = 1.5;
/// Most of this way that a curve may be off its segment.
const SAGITTA: f64 = 0.5;
/// Most of this way at a corner over that of its sides.
const MITRE: f64 = 1.25;

/// A line along the gradient.
#[derive(Debug, Clone, PartialEq)]
pub struct GradientLine {
    /// Number of the inner curve where it begins.
    pub curve: usize,
    /// Parameter there.
    pub u: f64,
    /// Parameter of its end on the outer curve.
    pub v: f64,
    /// Points, from the inner curve to the outer one.
    pub points: Vec<DVec2>,
}

/// Where a line begins.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Start {
    ring: usize,
    segment: usize,
    /// Share of the segment.
    share: f64,
}

/// Places on the inner rings that part their flux evenly, `count` in all, and at least one on each ring.
///
/// `fluxes` are those of all segments; what seems to flow against the others counts as nothing.
pub(super) fn starts(rings: &Rings, fluxes: &[f64], lengths: &[f64], count: usize) -> Vec<Start> {
    let inner: Vec<usize> = (0..rings.list().len()).filter(|ring| *ring != rings.outer()).collect();
    let flow = |ring: usize, segment: usize| {
        let number = rings.start(ring) + segment;
        (-fluxes[number]).max(0.0) * lengths[number]
    };
    let whole = |ring: usize| (0..rings.list()[ring].len()).map(|segment| flow(ring, segment)).sum::<f64>();
    let all: f64 = inner.iter().map(|ring| whole(*ring)).sum();
    let mut found = Vec::with_capacity(count);
    let (mut passed, mut given) = (0.0, 0);
    for (k, &ring) in inner.iter().enumerate() {
        let own = whole(ring);
        passed += own;
        // What is left for the rings to come is at least one each.
        let most = count.saturating_sub(given + inner.len() - 1 - k).max(1);
        let until = (count as f64 * passed / all).round() as usize;
        let lines = if all > 0.0 { until.saturating_sub(given).clamp(1, most) } else { 1 };
        given += lines;
        let (mut segment, mut before) = (0, 0.0);
        for line in 0..lines {
            let wanted = own * line as f64 / lines as f64;
            while segment + 1 < rings.list()[ring].len() && before + flow(ring, segment) <= wanted {
                before += flow(ring, segment);
                segment += 1;
            }
            let here = flow(ring, segment);
            let share = if here > 0.0 { ((wanted - before) / here).clamp(0.0, 1.0) } else { 0.5 };
            found.push(Start { ring, segment, share });
        }
    }
    found
}

/// What is needed to follow lines.
pub(super) struct Tracer<'a> {
    rings: &'a Rings,
    curves: &'a [BSpline],
    flow: &'a Flow,
    fluxes: &'a [f64],
    /// Diagonal of the boundary.
    size: f64,
    /// Where lines that come from inside begin to end: beside each vertex of the outer ring.
    gate: Vec<DVec2>,
}

impl<'a> Tracer<'a> {
    /// `size` is the diagonal of the boundary.
    pub(super) fn new(
        rings: &'a Rings,
        curves: &'a [BSpline],
        flow: &'a Flow,
        fluxes: &'a [f64],
        size: f64,
    ) -> Self {
        let mut tracer = Self { rings, curves, flow, fluxes, size, gate: Vec::new() };
        let outer = &rings.list()[rings.outer()];
        tracer.gate = (0..outer.len()).map(|k| outer.points[k] + tracer.way(rings.outer(), k)).collect();
        tracer
    }

    /// Follows the gradient from a start to the outer curve; `None` where it does not come there.
    pub(super) fn line(&self, start: Start) -> Option<GradientLine> {
        let ring = &self.rings.list()[start.ring];
        let u = ring.parameter(start.segment, start.share);
        let first = self.curves[start.ring].point(u);
        let (from, to) = (ring.points[start.segment], ring.points[(start.segment + 1) % ring.len()]);
        let along = to - from;
        let [leaving, next] =
            [start.segment, (start.segment + 1) % ring.len()].map(|k| self.way(start.ring, k));
        let way = leaving.lerp(next, start.share);
        let foot = from.lerp(to, start.share);
        // A needle that is thinner than its segments are long goes on beyond them: lines begin nearer to these.
        let first = foot + (first - foot).clamp_length_max(SAGITTA * way.length());
        let mut at = foot + way;
        let flux = self.fluxes[self.rings.start(start.ring) + start.segment].abs();
        let mut reached = flux * way.dot(outwards(along));
        let mut points = vec![first, at];
        let mut slope = self.flow.gradient(at);
        let mut step = along.length().min(self.size * 0.01);
        for _ in 0..MOST_STEPS {
            let steepness = slope.length();
            if !(steepness > 0.0 && steepness.is_finite()) {
                return None;
            }
            let left = (1.0 - reached) / steepness;
            step = step.min((0.5 * left).max(1e-3 * self.size));
            let (next, next_slope, gained, error) = self.stride(at, slope, step);
            let size = self.size.min(LENGTHS / steepness);
            let allowed = TOLERANCE * size;
            if error > allowed && step > 1e-7 * size {
                step *= (0.9 * (allowed / error).cbrt()).max(0.2);
                continue;
            }
            let end = match self.passing(at, next) {
                Some((point, segment, share)) => {
                    points.push(point);
                    Some((segment, share))
                }
                None if reached > BEYOND => Some(self.nearest(at)),
                None => None,
            };
            if let Some((segment, share)) = end {
                let outer = self.rings.outer();
                let v = self.rings.list()[outer].parameter(segment, share);
                points.push(self.curves[outer].point(v));
                return Some(GradientLine { curve: start.ring, u, v, points });
            }
            at = next;
            reached += gained;
            slope = next_slope;
            points.push(at);
            step *= (0.9 * (allowed / error.max(1e-30)).cbrt()).clamp(0.3, 3.0);
            step = step.min(0.05 * self.size);
        }
        None
    }

    /// The way from a vertex of a ring into the material with which lines beside it begin, or end. Between the ways of two neighbours those of a segment lie as in a fan, so that
    /// they do not cross, where normals of segments do.
    fn way(&self, ring: usize, vertex: usize) -> DVec2 {
        let list = &self.rings.list()[ring];
        let (count, sign) = (list.len(), if ring == self.rings.outer() { -1.0 } else { 1.0 });
        let side = |k: usize| {
            let along = list.points[(k + 1) % count] - list.points[k];
            let flux = self.fluxes[self.rings.start(ring) + k].abs();
            (sign * outwards(along), (BESIDE * along.length()).min(SHARE / flux.max(1e-300)))
        };
        let ((before, arriving), (after, leaving)) = (side((vertex + count - 1) % count), side(vertex));
        let bisector = (before + after).try_normalize().unwrap_or(after);
        let mitre = 1.0 / bisector.dot(after).max(1.0 / MITRE);
        bisector * (arriving.min(leaving) * mitre)
    }

    /// A step along the gradient by the method of order three of Bogacki and Shampine, with the difference from that of order two; returns the place, its
    /// gradient, what the potential gained, and the error.
    fn stride(&self, at: DVec2, slope: DVec2, step: f64) -> (DVec2, DVec2, f64, f64) {
        let unit = |slope: DVec2| slope.normalize_or_zero();
        let k1 = unit(slope);
        let s2 = self.flow.gradient(at + 0.5 * step * k1);
        let k2 = unit(s2);
        let s3 = self.flow.gradient(at + 0.75 * step * k2);
        let k3 = unit(s3);
        let next = at + step / 9.0 * (2.0 * k1 + 3.0 * k2 + 4.0 * k3);
        let s4 = self.flow.gradient(next);
        let k4 = unit(s4);
        let error = step * (-5.0 / 72.0 * k1 + k2 / 12.0 + k3 / 9.0 - k4 / 8.0).length();
        let gained = step / 9.0 * (2.0 * slope.length() + 3.0 * s2.length() + 4.0 * s3.length());
        (next, s4, gained, error)
    }

    /// Where a piece of a line comes so near to the outer ring that it ends there: the first such place, and the segment and the share of it where it ends.
    fn passing(&self, from: DVec2, to: DVec2) -> Option<(DVec2, usize, f64)> {
        let (way, count) = (to - from, self.gate.len());
        let hit = |k: usize| {
            let (a, b) = (self.gate[k], self.gate[(k + 1) % count]);
            let cross = way.perp_dot(b - a);
            let (t, share) = ((a - from).perp_dot(b - a) / cross, (a - from).perp_dot(way) / cross);
            ((0.0..=1.0).contains(&t) && (0.0..=1.0).contains(&share)).then_some((t, k, share))
        };
        let (t, segment, share) = (0..count).filter_map(hit).min_by(|a, b| a.0.total_cmp(&b.0))?;
        Some((from + t * way, segment, share))
    }

    /// The segment of the outer ring that is nearest to a point, and the share of it.
    fn nearest(&self, point: DVec2) -> (usize, f64) {
        let ring = &self.rings.list()[self.rings.outer()];
        let ends = |k: usize| [ring.points[k], ring.points[(k + 1) % ring.len()]];
        let apart = |k: &usize| distance(ends(*k), point);
        let segment = (0..ring.len()).min_by(|a, b| apart(a).total_cmp(&apart(b))).unwrap_or(0);
        let [a, b] = ends(segment);
        (segment, ((point - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0))
    }
}

/// The unit normal of a segment of a counter-clockwise ring, which points out of it, so into the material of an inner one.
fn outwards(along: DVec2) -> DVec2 {
    DVec2::new(along.y, -along.x).normalize_or_zero()
}

/// Number of pairs of lines that meet, decided exactly.
#[must_use]
pub fn crossings(lines: &[Vec<DVec2>]) -> usize {
    let edges: Vec<(DVec2, DVec2)> =
        lines.iter().flat_map(|line| line.windows(2).map(|pair| (pair[0], pair[1]))).collect();
    let owners: Vec<usize> = lines
        .iter()
        .enumerate()
        .flat_map(|(k, line)| std::iter::repeat_n(k, line.len().max(1) - 1))
        .collect();
    let grid = SegmentGrid::new(edges.clone());
    let mut pairs = std::collections::BTreeSet::new();
    for (edge, (a, b)) in edges.iter().enumerate() {
        let own = owners[edge];
        grid.find(*a, *b, |k, c, d| {
            if owners[k] > own && segments_meet(*a, *b, c, d) {
                pairs.insert((own, owners[k]));
            }
            false
        });
    }
    pairs.len()
}
