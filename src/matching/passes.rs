//! The two passes of vertex insertion.

use super::join::{Gap, Join, Spot};
use super::value::End;
use super::{Problem, RulingLine};
use crate::curve::{ArcLength, BSpline, Samples};

/// The two passes of insertion on a complete matching.
pub(super) struct Passes<'a> {
    pub(super) curves: &'a [BSpline; 2],
    pub(super) arc_lengths: &'a [ArcLength; 2],
    pub(super) samples: &'a [Samples; 2],
    pub(super) problem: &'a Problem,
    pub(super) lines: &'a [RulingLine],
}

/// A line after the first pass: its end on the second curve is a vertex, counted on through the laps.
#[derive(Debug, Clone, Copy)]
struct Spread {
    u: f64,
    /// The line of the star matching that it is, and how many laps on.
    star: Option<(usize, i64)>,
    lifted: i64,
}

impl Passes<'_> {
    /// Number of the sample, and parameter, of a vertex counted on through the laps.
    fn parameter(&self, axis: usize, lifted: i64) -> f64 {
        let parameters = &self.samples[axis].parameters;
        let (lo, hi) = self.curves[axis].domain();
        let count = parameters.len() as i64;
        parameters[lifted.rem_euclid(count) as usize] + lifted.div_euclid(count) as f64 * (hi - lo)
    }

    pub(super) fn vertex(&self, axis: usize, lifted: i64) -> Spot {
        let samples = &self.samples[axis];
        let count = samples.arc.len() as i64;
        let vertex = lifted.rem_euclid(count) as usize;
        Spot {
            vertex: Some(vertex),
            parameter: samples.parameters[vertex],
            arc: samples.arc[vertex],
            laps: lifted.div_euclid(count) as f64,
            end: self.problem.end(axis, vertex),
        }
    }

    fn inserted(&self, axis: usize, parameter: f64) -> Spot {
        let curve = &self.curves[axis];
        let end = End { point: curve.point(parameter), normal: curve.normal(parameter) };
        Spot { vertex: None, parameter, arc: self.arc_lengths[axis].at(parameter), laps: 0.0, end }
    }

    /// Line `k` of the star matching, some laps on.
    fn star(&self, k: usize, laps: i64, gap: usize) -> Join {
        let (line, (a, b)) = (&self.lines[k], self.problem.counts());
        let from = self.vertex(0, line.from as i64 + laps * a as i64);
        Join { ends: [from, self.vertex(1, line.lifted + laps * b as i64)], gap }
    }

    fn is_closed(&self) -> bool {
        self.problem.ends().is_none()
    }

    /// Tells whether line `k` is better than an earlier line `other`; of equal ones neither is. Between open outlines the first and the
    /// last line keep their ends.
    fn is_better(&self, k: usize, other: usize) -> bool {
        if !self.is_closed() && (other == 0 || k + 1 == self.lines.len()) {
            return other > 0;
        }
        let [(value, tie), (least, limit)] = [k, other].map(|k| {
            let line = &self.lines[k];
            self.problem.rank(line.from, line.to, line.value)
        });
        value > least || (value == least && tie < limit)
    }

    /// First pass: the best line of each vertex of the first curve, and new lines from points between.
    fn first(&self) -> Vec<Spread> {
        let (a, b) = self.problem.counts();
        let mut best: Vec<usize> = Vec::with_capacity(a);
        // What lies before the first line between open outlines is left out.
        let begin = if self.is_closed() { 0 } else { self.lines.first().map_or(0, |line| line.from) };
        for (k, line) in self.lines.iter().enumerate() {
            let i = line.from - begin;
            if i == best.len() {
                best.push(k);
            } else if self.is_better(k, best[i]) {
                best[i] = k;
            }
        }
        let mut spread = Vec::new();
        for (i, &k) in best.iter().enumerate() {
            let this = self.lines[k].lifted;
            let i = i + begin;
            let next = best.get(i + 1 - begin).map(|&k| self.lines[k].lifted);
            let Some(next) = next.or(self.is_closed().then(|| self.lines[best[0]].lifted + b as i64)) else {
                spread.push(Spread { u: self.parameter(0, i as i64), star: Some((k, 0)), lifted: this });
                break;
            };
            let [u, end] = [i, i + 1].map(|i| self.parameter(0, i as i64));
            let [v, reach] = [this, next].map(|lifted| self.parameter(1, lifted));
            spread.push(Spread { u, star: Some((k, 0)), lifted: this });
            spread.extend((this + 1..next).map(|lifted| {
                let share = (self.parameter(1, lifted) - v) / (reach - v);
                Spread { u: u + share * (end - u), star: None, lifted }
            }));
        }
        spread
    }

    /// Both passes: the lines that keep their ends, and between them what is inserted and what was there.
    pub(super) fn gaps(&self) -> Vec<Gap> {
        let mut spread = self.first();
        let count = spread.len();
        let (b, period) = (self.problem.counts().1 as i64, {
            let (lo, hi) = self.curves[0].domain();
            hi - lo
        });
        // Begin where one group of lines with a common end on the second curve ends and the next begins.
        let begins = |k: usize| k > 0 && spread[k].lifted != spread[k - 1].lifted;
        let start = (0..count).find(|&k| self.is_closed() && begins(k)).unwrap_or(0);
        spread.rotate_left(start);
        for line in &mut spread[count - start..] {
            line.u += period;
            line.lifted += b;
            line.star = line.star.map(|(k, laps)| (k, laps + 1));
        }
        // Second pass: the best of each group keeps its end.
        let mut best: Vec<usize> = Vec::new();
        for k in 0..count {
            match best.last().copied() {
                Some(last) if spread[last].lifted == spread[k].lifted => {
                    if let (Some((this, _)), Some((other, _))) = (spread[k].star, spread[last].star)
                        && self.is_better(this, other)
                    {
                        best.pop();
                        best.push(k);
                    }
                }
                _ => best.push(k),
            }
        }
        let on = |k: usize| {
            let line = spread[k % count];
            let laps = (k / count) as i64;
            Spread {
                u: line.u + laps as f64 * period,
                star: line.star.map(|(star, lap)| (star, lap + laps)),
                lifted: line.lifted + laps * b,
            }
        };
        let mut gaps: Vec<Gap> = Vec::new();
        let mut kept: Vec<(usize, i64)> = Vec::new();
        // Lines before the first that keeps both ends come after the last, a lap on.
        let first = (0..best.len()).find(|&g| spread[best[g]].star.is_some()).unwrap_or(0);
        for g in first..first + best.len() {
            let [this, next] = [g, g + 1].map(|g| best[g % best.len()] + g / best.len() * count);
            let is_last = !self.is_closed() && g + 1 == best.len();
            let next = if is_last { this } else { next };
            let (here, there) = (on(this), on(next));
            let end = self.vertex(1, here.lifted);
            let gap = match here.star {
                Some((star, laps)) => {
                    kept.push((star, laps));
                    let gap = gaps.len();
                    let kept = self.star(star, laps, gap);
                    gaps.push(Gap { kept, inserted: Vec::new(), stars: Vec::new(), failed: None });
                    gap
                }
                None => {
                    let gap = gaps.len() - 1;
                    gaps[gap].inserted.push(Join { ends: [self.inserted(0, here.u), end], gap });
                    gap
                }
            };
            let [start, reach] = [here, there].map(|line| self.parameter(1, line.lifted));
            for k in this + 1..next {
                let line = on(k);
                let v = start + (reach - start) * (line.u - here.u) / (there.u - here.u);
                let from = match line.star {
                    Some((star, laps)) => self.star(star, laps, gap).ends[0],
                    None => self.inserted(0, line.u),
                };
                gaps[gap].inserted.push(Join { ends: [from, self.inserted(1, v)], gap });
            }
        }
        let lines = self.lines.len() as i64;
        for (g, gap) in gaps.iter_mut().enumerate() {
            let place = |(star, laps): (usize, i64)| star as i64 + laps * lines;
            let end = || if self.is_closed() { place(kept[0]) + lines } else { lines };
            let next = kept.get(g + 1).map_or_else(end, |&kept| place(kept));
            let between = place(kept[g]) + 1..next;
            gap.stars =
                between.map(|at| self.star(at.rem_euclid(lines) as usize, at.div_euclid(lines), g)).collect();
        }
        gaps
    }
}
