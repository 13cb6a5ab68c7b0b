//! From the matchings of neighbours to the blend of a stack, in steps.

use super::blend::{StackBlend, Strand};
use super::cubic::{fraction_tangent, height_tangents, tangent};
use super::thread::{Thread, join, of_span};
use crate::curve::BSpline;
use crate::material::Composition;

/// A job that weaves the matchings of all spans into one blend.
#[derive(Debug, Clone)]
pub struct Weave {
    curves: Vec<BSpline>,
    heights: Vec<f64>,
    is_cubic: bool,
    /// Spans whose lines are not in the threads yet, the last one first.
    spans: Vec<Vec<Thread>>,
    widths: Vec<f64>,
    threads: Vec<Thread>,
    /// Sum of the ways along the threads of every span, and of their weights.
    ways: Vec<[f64; 2]>,
    measured: usize,
    knots: Vec<f64>,
    /// Strands from one thread to the next.
    per_line: Refined,
    strands: Vec<Strand>,
}

/// How many strands there are from one thread to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refined {
    /// This many.
    By(usize),
    /// As many as make no more than this number of strands in all, from 1 to 32.
    Towards(usize),
}

impl Refined {
    fn count(self, threads: usize) -> usize {
        match self {
            Self::By(count) => count.max(1),
            Self::Towards(all) => (all / threads.max(1)).clamp(1, 32),
        }
    }
}

impl Weave {
    /// Prepares the blend of curves at their heights; `spans` has for each span the parameters (u, v) of its lines, in cyclic order and ascending beyond
    /// the ends of the domains.
    #[must_use]
    pub fn new(
        curves: Vec<BSpline>,
        heights: Vec<f64>,
        spans: &[Vec<(f64, f64)>],
        is_cubic: bool,
        per_line: Refined,
    ) -> Self {
        let width = |curve: &BSpline| curve.domain().1 - curve.domain().0;
        let widths: Vec<f64> = curves.iter().map(width).collect();
        let mut rest: Vec<Vec<Thread>> =
            spans.iter().enumerate().map(|(span, lines)| of_span(span, lines)).rev().collect();
        Self {
            ways: vec![[0.0; 2]; spans.len()],
            threads: rest.pop().unwrap_or_default(),
            spans: rest,
            // Two curves have no inner one to pass without a kink.
            is_cubic: is_cubic && spans.len() > 1,
            curves,
            heights,
            widths,
            measured: 0,
            knots: Vec::new(),
            per_line,
            strands: Vec::new(),
        }
    }

    /// Advances while `may_go_on` says so, at least by a little; returns the blend when it is woven, or `Some(None)` where no thread leads through all
    /// curves. `compose(curve, u)` is the composition along a curve, for `u` beyond the domain as well.
    pub fn step(
        &mut self,
        compose: &dyn Fn(usize, f64) -> Composition,
        may_go_on: &mut dyn FnMut() -> bool,
    ) -> Option<Option<StackBlend>> {
        while let Some(next) = self.spans.pop() {
            let widths = &self.widths[..self.widths.len() - self.spans.len()];
            self.threads = join(std::mem::take(&mut self.threads), next, widths, self.is_closed());
            if !may_go_on() {
                return None;
            }
        }
        let gaps = self.gaps();
        if self.threads.is_empty() {
            return Some(None);
        }
        while self.measured < gaps {
            self.measure(self.measured);
            self.measured += 1;
            if !may_go_on() {
                return None;
            }
        }
        if self.knots.is_empty() {
            self.knots = self.spaced();
        }
        let per_line = self.per_line.count(self.threads.len());
        // A strand at every thread of an open stack, and at the parts between.
        let count = gaps * per_line + usize::from(!self.is_closed());
        while self.strands.len() < count {
            let at = self.strands.len();
            let strand = self.strand(at / per_line, (at % per_line) as f64 / per_line as f64, compose);
            self.strands.push(strand);
            if !may_go_on() {
                return None;
            }
        }
        let end = self.is_closed().then(|| self.parameters(gaps, 0.0));
        Some(Some(StackBlend {
            climbs: if self.is_cubic { height_tangents(&self.knots, &self.heights) } else { Vec::new() },
            knots: std::mem::take(&mut self.knots),
            heights: self.heights.clone(),
            strands: std::mem::take(&mut self.strands),
            end,
            per_line,
            lines: self.threads.iter().map(|thread| thread.lines).collect(),
        }))
    }

    fn is_closed(&self) -> bool {
        self.curves.iter().all(BSpline::is_closed)
    }

    /// Number of gaps between threads.
    fn gaps(&self) -> usize {
        if self.is_closed() { self.threads.len() } else { self.threads.len().saturating_sub(1) }
    }

    /// Parameters at a share of the way from a thread to the next.
    fn parameters(&self, thread: usize, share: f64) -> Vec<f64> {
        let count = self.threads.len();
        let of = |k: usize, curve: usize| {
            let laps = if k >= count { self.widths[curve] } else { 0.0 };
            self.threads[k % count].parameters[curve] + laps
        };
        let at = |curve: usize| {
            let from = of(thread, curve);
            if share == 0.0 { from } else { from + share * (of(thread + 1, curve) - from) }
        };
        (0..self.curves.len()).map(at).collect()
    }

    /// Adds the ways along a thread and the next, weighted by how far apart the two are.
    fn measure(&mut self, thread: usize) {
        let [this, next] = [thread, thread + 1].map(|k| {
            let parameters = self.parameters(k, 0.0);
            let places = self.curves.iter().zip(parameters).zip(&self.heights);
            places.map(|((curve, u), &height)| curve.point(u).extend(height)).collect::<Vec<_>>()
        });
        for (span, way) in self.ways.iter_mut().enumerate() {
            let weight = this[span].distance(next[span]) + this[span + 1].distance(next[span + 1]);
            let lengths = this[span].distance(this[span + 1]) + next[span].distance(next[span + 1]);
            *way = [way[0] + weight * lengths / 2.0, way[1] + weight];
        }
    }

    /// Knots from 0 to 1 whose distances are proportional to the mean ways.
    fn spaced(&self) -> Vec<f64> {
        let mean = |[sum, weight]: &[f64; 2]| if *weight > 0.0 { sum / weight } else { 0.0 };
        let means: Vec<f64> = self.ways.iter().map(mean).collect();
        let whole: f64 = means.iter().sum();
        // No span vanishes however close its curves are.
        let least = if whole > 0.0 { whole * LEAST } else { 1.0 };
        let steps: Vec<f64> = means.iter().map(|mean| mean.max(least)).collect();
        let whole: f64 = steps.iter().sum();
        let mut reached = 0.0;
        let mut knots = vec![0.0];
        for step in &steps[..steps.len() - 1] {
            reached += step / whole;
            knots.push(reached);
        }
        knots.push(1.0);
        knots
    }

    fn strand(&self, thread: usize, share: f64, compose: &dyn Fn(usize, f64) -> Composition) -> Strand {
        let parameters = self.parameters(thread, share);
        let points: Vec<_> = self.curves.iter().zip(&parameters).map(|(curve, &u)| curve.point(u)).collect();
        let mixes: Vec<_> = parameters.iter().enumerate().map(|(curve, &u)| compose(curve, u)).collect();
        let (mut tangents, mut slopes) = (Vec::new(), Vec::new());
        if self.is_cubic {
            let fractions: Vec<&[f64]> = mixes.iter().map(Composition::fractions).collect();
            for k in 0..points.len() {
                tangents.push(tangent(&self.knots, &points, k));
                slopes.push(fraction_tangent(&self.knots, &fractions, k));
            }
        }
        Strand { parameters, points, mixes, tangents, slopes }
    }
}

/// Least part of the whole way that a span takes.
const LEAST: f64 = 1e-6;
