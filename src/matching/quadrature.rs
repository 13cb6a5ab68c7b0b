//! J of lines whose ends lie anywhere on the curves, and its bound, by the same midpoints.

use super::parts::{PARTS, Parts};
use super::value::End;
use super::visibility::Sight;
use super::{Problem, RulingLine};
use crate::curve::{ArcLength, BSpline};

/// Ends of lines that are looked at all round a curve for a better partner; between many lines some are skipped at first.
const CANDIDATES: usize = 128;

/// The integral J of lines in cyclic order, or along open curves from the first to the last, and an upper bound of it, as a job that advances gap by gap.
///
/// Between neighbouring lines the correspondence is linear in arc length, and cut into parts, at corners if there are some. J is the sum of the values between corresponding
/// midpoints, each weighed with its share of both curves. The bound gives every midpoint its best partner instead: among
/// its own, the ends of all lines that an end of its gap sees, and the midpoints beside the best of these. So J never exceeds it.
#[derive(Debug)]
pub(super) struct Quadrature {
    lines: Vec<RulingLine>,
    /// Arc length of the ends of the lines on each curve, ascending.
    arcs: [Vec<f64>; 2],
    middles: [Vec<End>; 2],
    /// The width of each part, as a share of the way from its line to the next.
    widths: Vec<f64>,
    parts: Option<Parts>,
    sight: Sight,
    /// Whether the start of one line sees the end of another, as far as it was asked.
    seen: Vec<Option<bool>>,
    gap: usize,
    /// Ways from one line to the next: as many as lines round closed curves, one less along open ones.
    gaps: usize,
    integral: f64,
    bound: f64,
}

impl Quadrature {
    pub(super) fn new(problem: &Problem, lines: &[RulingLine], arcs: [Vec<f64>; 2]) -> Self {
        Self {
            sight: Sight::new(problem.outlines()),
            seen: vec![None; lines.len() * lines.len()],
            lines: lines.to_vec(),
            arcs,
            middles: [Vec::new(), Vec::new()],
            widths: Vec::with_capacity(lines.len() * PARTS),
            parts: None,
            gap: 0,
            gaps: if problem.ends().is_some() { lines.len().saturating_sub(1) } else { lines.len() },
            integral: 0.0,
            bound: 0.0,
        }
    }

    /// Goes on by one gap; returns the share done, 1 at the end.
    pub(super) fn advance(
        &mut self,
        problem: &Problem,
        curves: &[BSpline; 2],
        arc_lengths: &[ArcLength; 2],
    ) -> f64 {
        let count = self.gaps;
        if count == 0 {
            return 1.0;
        }
        if self.gap < count {
            let starts = [0, 1].map(|axis| self.arcs[axis][self.gap]);
            let spans = [0, 1].map(|axis| self.span(axis, self.gap, arc_lengths));
            let share = |axis: usize, arc: f64| arc / arc_lengths[axis].total();
            let from = [0, 1].map(|axis| share(axis, starts[axis]));
            let to = [0, 1].map(|axis| share(axis, starts[axis] + spans[axis]));
            let cuts = self.parts.get_or_insert_with(|| Parts::new(curves, arc_lengths)).cuts(from, to);
            self.widths.extend(cuts.windows(2).map(|w| w[1] - w[0]));
            for axis in 0..2 {
                for w in cuts.windows(2) {
                    let u = arc_lengths[axis].parameter(starts[axis] + spans[axis] * (w[0] + w[1]) / 2.0);
                    let end = End { point: curves[axis].point(u), normal: curves[axis].normal(u) };
                    self.middles[axis].push(end);
                }
            }
        } else {
            let gap = self.gap - count;
            // Half of J's measure lies on each curve.
            let weights =
                [0, 1].map(|axis| self.span(axis, gap, arc_lengths) / arc_lengths[axis].total() / 2.0);
            for k in gap * PARTS..(gap + 1) * PARTS {
                let weights = weights.map(|weight| weight * self.widths[k]);
                let own = problem.value_between(self.middles[0][k], self.middles[1][k]);
                self.integral += (weights[0] + weights[1]) * own;
                for (axis, weight) in weights.into_iter().enumerate() {
                    if weight > 0.0 {
                        self.bound += weight * self.best(problem, axis, k, own);
                    }
                }
            }
        }
        self.gap += 1;
        self.gap as f64 / (2 * count) as f64
    }

    /// J and its bound.
    pub(super) fn result(&self) -> (f64, f64) {
        (self.integral, self.bound)
    }

    /// Arc length from the end of one line to that of the next.
    fn span(&self, axis: usize, gap: usize, arc_lengths: &[ArcLength; 2]) -> f64 {
        let arcs = &self.arcs[axis];
        let next = arcs.get(gap + 1).copied().unwrap_or_else(|| arcs[0] + arc_lengths[axis].total());
        (next - arcs[gap]).max(0.0)
    }

    /// Value of midpoint `k` of one curve with its best partner on the other, at least `own`.
    fn best(&mut self, problem: &Problem, axis: usize, k: usize, own: f64) -> f64 {
        let (count, gap, middle) = (self.lines.len(), k / PARTS, self.middles[axis][k]);
        let value = |other: End| {
            if axis == 0 {
                problem.value_between(middle, other)
            } else {
                problem.value_between(other, middle)
            }
        };
        let (mut best, mut at) = (own, gap);
        let stride = count.div_ceil(CANDIDATES);
        // All round the curve in strides, then one by one beside the best.
        for is_beside in [false, true] {
            let (start, reach, step) =
                if is_beside { (at + count - stride, 2 * stride, 1) } else { (gap, count, stride) };
            for m in (start..start + reach).step_by(step).map(|m| m % count) {
                let line = self.lines[m];
                let end = problem.end(1 - axis, if axis == 0 { line.to } else { line.from });
                let partner = value(end);
                let next = (gap + 1) % count;
                if partner > best && (self.sees(axis, gap, m) || self.sees(axis, next, m)) {
                    (best, at) = (partner, m);
                }
            }
        }
        let before = (at + count - 1) % count;
        for beside in [before, at].into_iter().filter(|&gap| gap < self.gaps) {
            let middles = &self.middles[1 - axis][beside * PARTS..(beside + 1) * PARTS];
            best = middles.iter().fold(best, |best, &other| best.max(value(other)));
        }
        best
    }

    /// Tells whether the end of one line on a curve and the end of another on the other curve see each other.
    fn sees(&mut self, axis: usize, here: usize, there: usize) -> bool {
        let (from, to) = if axis == 0 { (here, there) } else { (there, here) };
        let sight = &mut self.sight;
        let (first, second) = (self.lines[from].from, self.lines[to].to);
        *self.seen[from * self.lines.len() + to].get_or_insert_with(|| sight.is_clear(first, second))
    }
}
