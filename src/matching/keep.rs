//! Lines of the optimum itself, where lines evenly spread along it fail.

use super::measure::cross;
use super::place::places_of_pairs;
use super::{FailedGap, OneToOne, blocking_edge};
use crate::curve::BSpline;
use crate::geom::segment_crossing;
use glam::DVec2;

/// Evenly spread lines, some of which may have to make way for the lines of the matching that they follow.
///
/// An evenly spread line lies between two lines of the best matching. That both of these are visible does not make it so: in a
/// narrow pocket it may meet a curve. Then the nearest line of the matching takes its place, and when that does not do, those of
/// its neighbours do as well, twice as many each time. Lines of the matching cross nothing, but they may share ends.
#[derive(Debug, Clone)]
pub struct Spread {
    /// Lines of the matching in shares of arc length, weakly ascending.
    path: Vec<[f64; 2]>,
    even: Vec<[f64; 2]>,
    /// Whether a line is one of the matching, and whether it was from the start.
    is_kept: Vec<bool>,
    is_held: Vec<bool>,
    /// Where lines failed, by their number.
    faults: Vec<(usize, DVec2)>,
    reach: usize,
}

/// Shares of arc length closer than this are one place.
const SAME: f64 = 1e-9;

fn mean([x, y]: [f64; 2]) -> f64 {
    f64::midpoint(x, y)
}

/// Distance of two numbers round a circle of length 1.
fn off(x: f64, y: f64) -> f64 {
    ((x - y + 0.5).rem_euclid(1.0) - 0.5).abs()
}

fn nearest(places: &[[f64; 2]], at: f64) -> usize {
    let by = |k: &usize| off(mean(places[*k]), at);
    (0..places.len()).min_by(|i, k| by(i).total_cmp(&by(k))).unwrap_or(0)
}

impl Spread {
    /// Takes lines that are `even` along the lines `path` of a matching, both in shares of arc length and in cyclic order; `held` are the places
    /// among the even ones that must stay, which are of the matching.
    #[must_use]
    pub fn new(path: Vec<[f64; 2]>, even: Vec<[f64; 2]>, held: &[[f64; 2]]) -> Self {
        let same = |p: &[f64; 2], q: &[f64; 2]| off(p[0], q[0]) < SAME && off(p[1], q[1]) < SAME;
        let is_held: Vec<bool> =
            even.iter().map(|place| held.iter().any(|other| same(place, other))).collect();
        Self { path, is_kept: is_held.clone(), is_held, even, faults: Vec::new(), reach: 0 }
    }

    /// The evenly spread lines.
    #[must_use]
    pub fn even(&self) -> &[[f64; 2]] {
        &self.even
    }

    /// The lines to try, in cyclic order: weakly ascending where lines of the matching were put in, else strictly.
    #[must_use]
    pub fn places(&self) -> Vec<[f64; 2]> {
        let place = |k: usize| {
            let place = self.even[k];
            if !self.is_kept[k] || self.is_held[k] {
                return place;
            }
            let near = self.path[nearest(&self.path, mean(place))];
            let laps = (mean(place) - mean(near)).round();
            near.map(|share| share + laps)
        };
        let mut all: Vec<([f64; 2], bool)> =
            (0..self.even.len()).map(|k| (place(k), self.is_kept[k])).collect();
        all.dedup_by(|next, before| next.0 == before.0);
        let lap = |place: [f64; 2]| place.map(|share| share + 1.0);
        if all.len() > 1 && all.last().map(|last| last.0) == all.first().map(|first| lap(first.0)) {
            all.pop();
        }
        // A line that is not kept makes way where it is not strictly between those that are.
        let least = 1.0 / (256 * self.even.len().max(1)) as f64;
        let ascends = |p: [f64; 2], q: [f64; 2]| q[0] - p[0] > least && q[1] - p[1] > least;
        let n = all.len();
        let Some(start) = all.iter().position(|line| line.1) else {
            return all.into_iter().map(|line| line.0).collect();
        };
        let turn = |k: usize| {
            let (place, kept) = all[k % n];
            (place.map(|share| share + (k / n) as f64), kept)
        };
        let mut places = Vec::with_capacity(n);
        let mut k = start;
        while k < start + n {
            let end = (k + 1..=start + n).find(|&next| turn(next).1).unwrap_or(start + n);
            let (from, to) = (turn(k).0, turn(end).0);
            places.push(from);
            let between = (k + 1..end).map(|k| turn(k).0);
            places.extend(between.filter(|&place| ascends(from, place) && ascends(place, to)));
            k = end;
        }
        places
    }

    /// Looks at the verified lines of [`places`](Self::places); returns whether other lines should be tried.
    pub fn learn(&mut self, curves: &[BSpline; 2], pairs: &OneToOne) -> bool {
        let places = places_of_pairs(curves, pairs);
        let failed = (0..pairs.lines.len()).filter(|&k| !pairs.verified[k]);
        let failed: Vec<(usize, usize)> = failed.map(|k| (nearest(&self.even, mean(places[k])), k)).collect();
        let n = self.even.len();
        let kept_before = self.is_kept.iter().filter(|kept| **kept).count();
        for &(line, pair) in &failed {
            if !self.is_kept[line] {
                self.faults.push((line, fault(pairs, pair)));
            }
            (0..=2 * self.reach.min(n))
                .for_each(|by| self.is_kept[(line + n + by - self.reach.min(n)) % n] = true);
        }
        self.reach = (2 * self.reach).max(1);
        !failed.is_empty()
            && (self.is_kept.iter().filter(|kept| **kept).count() > kept_before || self.reach < 2 * n)
    }

    /// The gaps in which lines of the matching were kept, with the lines on either side.
    #[must_use]
    pub fn gaps(&self, curves: &[BSpline; 2], pairs: &OneToOne) -> Vec<FailedGap> {
        let places = places_of_pairs(curves, pairs);
        let n = places.len();
        let was = |k: usize| nearest(&self.even, mean(places[k % n]));
        let is_kept: Vec<bool> = (0..n).map(|k| self.is_kept[was(k)] && !self.is_held[was(k)]).collect();
        let Some(start) = is_kept.iter().position(|kept| !kept) else {
            let at = self.faults.first().map(|fault| fault.1);
            return at.map(|at| FailedGap { lines: (0..n).collect(), at }).into_iter().collect();
        };
        let (mut gaps, mut k) = (Vec::new(), start);
        while k < start + n {
            let end = (k + 1..=start + n).find(|next| !is_kept[next % n]).unwrap_or(start + n);
            if end > k + 1 {
                let lines: Vec<usize> = (k..=end).map(|k| k % n).collect();
                let is_here = |line: &usize| {
                    let nearest = nearest(&places, mean(self.even[*line]));
                    lines[1..lines.len() - 1].contains(&nearest)
                };
                let fault = self.faults.iter().find(|(line, _)| is_here(line));
                gaps.extend(fault.map(|&(_, at)| FailedGap { lines: lines.clone(), at }));
            }
            k = end;
        }
        gaps
    }
}

/// Where a line meets an edge or another line; its middle when it runs outside the band.
fn fault(pairs: &OneToOne, k: usize) -> DVec2 {
    let outlines = pairs.problem.outlines();
    let segment = |k: usize| (outlines[0].points[pairs.lines[k].from], outlines[1].points[pairs.lines[k].to]);
    let (p, q) = segment(k);
    if let Some(edge) = blocking_edge(outlines, pairs.lines[k].from, pairs.lines[k].to) {
        let (a, b) = outlines[edge.outline].edge(edge.vertex);
        return segment_crossing(p, q, a, b);
    }
    let crossed = (0..pairs.lines.len())
        .find(|&other| other != k && cross(outlines, &pairs.lines[k], &pairs.lines[other]));
    crossed.map_or((p + q) / 2.0, |other| {
        let (r, s) = segment(other);
        segment_crossing(p, q, r, s)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strict(places: &[[f64; 2]]) -> bool {
        places.windows(2).all(|w| w[0][0] <= w[1][0] && w[0][1] <= w[1][1] && w[0] != w[1])
    }

    #[test]
    fn lines_of_the_matching_stand_in_and_those_in_their_way_go() {
        let path: Vec<[f64; 2]> = (0..12).map(|k| [f64::from(k / 2) / 6.0, f64::from(k) / 12.0]).collect();
        let even: Vec<[f64; 2]> = (0..9).map(|k| [f64::from(k) / 9.0, f64::from(k) / 9.0 - 0.04]).collect();
        let mut spread = Spread::new(path.clone(), even.clone(), &[]);
        assert_eq!(spread.places(), even);
        spread.is_kept[3] = true;
        let places = spread.places();
        assert!(strict(&places), "{places:?}");
        let kept = path[nearest(&path, mean(even[3]))];
        assert!(places.contains(&kept) && !places.contains(&even[3]));
        // With all kept they are lines of the matching, each once.
        spread.is_kept.fill(true);
        let places = spread.places();
        assert!(strict(&places) && places.len() <= 9);
        let is_of_path =
            |place: &[f64; 2]| path.iter().any(|p| off(p[0], place[0]) < 1e-9 && off(p[1], place[1]) < 1e-9);
        assert!(places.iter().all(is_of_path));
    }

    #[test]
    fn held_lines_stay_where_they_are() {
        let path: Vec<[f64; 2]> = (0..10).map(|k| [f64::from(k) / 10.0, f64::from(k) / 10.0]).collect();
        let even = vec![[0.05, 0.05], [0.3, 0.3], [0.31, 0.31], [0.75, 0.75]];
        let mut spread = Spread::new(path, even, &[[0.3, 0.3]]);
        assert_eq!(spread.is_held, [false, true, false, false]);
        spread.is_kept[2] = true;
        let places = spread.places();
        assert_eq!(places.iter().filter(|place| **place == [0.3, 0.3]).count(), 1, "{places:?}");
    }
}
