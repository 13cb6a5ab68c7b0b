//! The blend through all curves of a stack.

use super::cubic::bernstein;
use crate::material::Composition;
use crate::morph::{Band, Ruling, UnitCell, unit_cells};
use glam::{DVec2, DVec3};

/// What a thread carries: its place and composition on every curve.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Strand {
    /// Parameter on every curve, ascending from strand to strand beyond the ends of the domains.
    pub(super) parameters: Vec<f64>,
    pub(super) points: Vec<DVec2>,
    pub(super) mixes: Vec<Composition>,
    /// Change of place and of fractions with s, on every curve; of a linear blend there are none.
    pub(super) tangents: Vec<DVec2>,
    pub(super) slopes: Vec<Vec<f64>>,
}

/// Shape and composition across a stack at one s.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Points in space, one on every strand.
    pub points: Vec<DVec3>,
    /// Composition at every point.
    pub compositions: Vec<Composition>,
}

/// One blend through all curves of a stack, along threads.
///
/// The place in the blend is s, from 0 on the first curve to 1 on the last one. The curves lie at the [`knots`](Self::knots), whose distances are
/// proportional to the mean way along the threads from curve to curve: so an even s passes through the stack at an even
/// speed, and the parts of a cubic blend meet without a kink however far apart the curves are.
///
/// A linear blend runs straight from curve to curve. A cubic one passes every curve with one tangent along every thread, that of the
/// parabola through the curve and its neighbours. Compositions follow the same rule, where the tangent of every strand is scaled back
/// until the Bezier control points of both pieces lie in the simplex; then all of each piece does. Heights keep between
/// those of the neighbouring curves by the same means.
#[derive(Debug, Clone, PartialEq)]
pub struct StackBlend {
    pub(super) knots: Vec<f64>,
    pub(super) heights: Vec<f64>,
    /// Change of the height with s on every curve; of a linear blend there is none.
    pub(super) climbs: Vec<f64>,
    pub(super) strands: Vec<Strand>,
    /// Parameters of the first strand after one lap, where the curves are closed.
    pub(super) end: Option<Vec<f64>>,
    pub(super) per_line: usize,
    /// Of each thread, the spans of which it follows a line, one bit for each.
    pub(super) lines: Vec<u32>,
}

/// Parts into which a span of a cubic blend is cut where it is taken for straight between rows.
const CUTS: usize = 8;

impl StackBlend {
    /// Number of spans.
    #[must_use]
    pub fn spans(&self) -> usize {
        self.knots.len() - 1
    }

    /// Place s of every curve, from 0 to 1.
    #[must_use]
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// Parameters of every thread, on every curve, in cyclic order.
    pub fn threads(&self) -> impl Iterator<Item = &[f64]> {
        self.strands.iter().step_by(self.per_line).map(|strand| strand.parameters.as_slice())
    }

    /// Parameters of every strand, on every curve.
    pub fn strands(&self) -> impl Iterator<Item = &[f64]> {
        self.strands.iter().map(|strand| strand.parameters.as_slice())
    }

    /// The blend on at most about `most` of its strands, evenly taken, for a picture that shows no more; it has no lines and no threads of its own.
    #[must_use]
    pub fn thinned(&self, most: usize) -> Self {
        let stride = self.strands.len().div_ceil(most.max(1)).max(1);
        let mut strands: Vec<Strand> = self.strands.iter().step_by(stride).cloned().collect();
        let last = self
            .strands
            .last()
            .filter(|_| self.end.is_none() && !(self.strands.len() - 1).is_multiple_of(stride));
        strands.extend(last.cloned());
        Self {
            knots: self.knots.clone(),
            heights: self.heights.clone(),
            climbs: self.climbs.clone(),
            end: self.end.clone(),
            per_line: 1,
            lines: vec![0; strands.len()],
            strands,
        }
    }

    /// Tells whether the last strand is followed by the first.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.end.is_some()
    }

    /// Tells whether the blend is cubic.
    #[must_use]
    pub fn is_cubic(&self) -> bool {
        !self.climbs.is_empty()
    }

    /// Tells whether both curves of a span have the same height, so that the whole span lies in a plane.
    #[must_use]
    pub fn is_level(&self, span: usize) -> bool {
        self.heights[span] == self.heights[span + 1]
    }

    /// Span in which s lies, and the share of the way through it. A curve between two spans belongs to the second.
    #[must_use]
    pub fn span_at(&self, s: f64) -> (usize, f64) {
        let span = self.knots[1..self.spans()].partition_point(|&knot| knot <= s);
        let (from, to) = (self.knots[span], self.knots[span + 1]);
        (span, ((s - from) / (to - from)).clamp(0.0, 1.0))
    }

    /// Place s at a share of the way through a span.
    #[must_use]
    pub fn s_at(&self, span: usize, share: f64) -> f64 {
        let (from, to) = (self.knots[span], self.knots[span + 1]);
        if share >= 1.0 { to } else { from + share * (to - from) }
    }

    /// Span and share of every stage: each span is cut into `stages` even parts. Both ends of the stack are among them.
    pub fn stages(&self, stages: usize) -> impl Iterator<Item = (usize, f64)> {
        let last = self.spans() - 1;
        let of_span = move |span| (0..stages).map(move |j| (span, j as f64 / stages as f64));
        (0..=last).flat_map(of_span).chain([(last, 1.0)])
    }

    /// In-between curve at s, as a polyline over all strands, closed where the curves are.
    #[must_use]
    pub fn in_between(&self, s: f64) -> Vec<DVec2> {
        let (span, share) = self.span_at(s);
        self.in_between_at(span, share)
    }

    /// In-between curve at a share of the way through a span.
    #[must_use]
    pub fn in_between_at(&self, span: usize, share: f64) -> Vec<DVec2> {
        self.strands.iter().map(|strand| self.point(strand, span, share)).collect()
    }

    /// Points in space and compositions at a share of the way through a span, on every strand.
    #[must_use]
    pub fn row(&self, span: usize, share: f64) -> Row {
        let height = self.height(span, share);
        Row {
            points: self.in_between_at(span, share).into_iter().map(|point| point.extend(height)).collect(),
            compositions: self.strands.iter().map(|strand| self.mix(strand, span, share)).collect(),
        }
    }

    /// The rows of all stages, from the first curve to the last; each span is cut into `stages` parts.
    #[must_use]
    pub fn rows(&self, stages: usize) -> Vec<Row> {
        self.stages(stages).map(|(span, share)| self.row(span, share)).collect()
    }

    /// Height at a share of the way through a span.
    #[must_use]
    pub fn height(&self, span: usize, share: f64) -> f64 {
        let (from, to) = (self.heights[span], self.heights[span + 1]);
        match self.climbs.get(span..=span + 1) {
            Some([leaving, arriving]) if from != to => {
                let step = (self.knots[span + 1] - self.knots[span]) / 3.0;
                let [a, b, c, d] = bernstein(share);
                a * from + b * (from + step * leaving) + c * (to - step * arriving) + d * to
            }
            _ if from == to => from,
            _ => from * (1.0 - share) + to * share,
        }
    }

    /// The rulings of a span from one share of its way to another as a band, whose patches are straight between the two.
    #[must_use]
    pub fn strip(&self, span: usize, from: f64, to: f64) -> Band {
        let ruling = |strand: &Strand| Ruling {
            u: strand.parameters[span],
            v: strand.parameters[span + 1],
            from: self.point(strand, span, from),
            to: self.point(strand, span, to),
            ends: [self.mix(strand, span, from), self.mix(strand, span, to)],
        };
        let end = self.end.as_ref().map(|end| (end[span], end[span + 1]));
        Band::of_rulings(self.strands.iter().map(ruling).collect(), end, self.per_line)
    }

    /// A span as strips that are straight enough to be seen as curved: one where the blend is linear.
    pub fn strips(&self, span: usize) -> impl Iterator<Item = Strip> {
        let count = self.cuts();
        (0..count).map(move |k| {
            let [from, to] = [k, k + 1].map(|cut| cut as f64 / count as f64);
            Strip { from, to, band: self.strip(span, from, to) }
        })
    }

    /// Number of strips in which a span is drawn and asked.
    pub(super) fn cuts(&self) -> usize {
        if self.is_cubic() { CUTS } else { 1 }
    }

    /// Unit cells between threads and stages, of which each span has `stages`; numbered on through the stack. They are
    /// ordered by span, then by thread.
    #[must_use]
    pub fn unit_cells(&self, stages: usize) -> Vec<UnitCell> {
        let mut cells = Vec::new();
        for span in 0..self.spans() {
            let before = span * stages;
            if !self.is_cubic() {
                let own = unit_cells(&self.strip(span, 0.0, 1.0), stages);
                cells.extend(own.into_iter().map(|cell| UnitCell { stage: before + cell.stage, ..cell }));
                continue;
            }
            for stage in 0..stages {
                let [from, to] = [stage, stage + 1].map(|j| j as f64 / stages as f64);
                let own = unit_cells(&self.strip(span, from, to), 1);
                cells.extend(own.into_iter().map(|cell| UnitCell { stage: before + stage, ..cell }));
            }
        }
        cells
    }

    /// The lines of the matching of a span as polylines along their threads: two points where the blend is linear.
    #[must_use]
    pub fn lines(&self, span: usize) -> Vec<Vec<DVec2>> {
        let own = self.strands.iter().step_by(self.per_line).zip(&self.lines);
        let cuts = self.cuts();
        own.filter(|(_, lines)| *lines & 1 << span != 0)
            .map(|(strand, _)| (0..=cuts).map(|k| self.point(strand, span, k as f64 / cuts as f64)).collect())
            .collect()
    }

    pub(super) fn point(&self, strand: &Strand, span: usize, share: f64) -> DVec2 {
        let (from, to) = (strand.points[span], strand.points[span + 1]);
        let Some([leaving, arriving]) = strand.tangents.get(span..=span + 1) else {
            return from.lerp(to, share);
        };
        let step = (self.knots[span + 1] - self.knots[span]) / 3.0;
        let [_, b, c, d] = bernstein(share);
        // The first weight is the rest: so the ends are exact.
        from + b * step * *leaving + c * (to - step * *arriving - from) + d * (to - from)
    }

    fn mix(&self, strand: &Strand, span: usize, share: f64) -> Composition {
        let (from, to) = (&strand.mixes[span], &strand.mixes[span + 1]);
        let Some([leaving, arriving]) = strand.slopes.get(span..=span + 1) else {
            return from.mix(to, share);
        };
        let step = (self.knots[span + 1] - self.knots[span]) / 3.0;
        let [a, b, c, d] = bernstein(share);
        let fraction = |k: usize| {
            let (from, to) = (from.fractions()[k], to.fractions()[k]);
            a * from + b * (from + step * leaving[k]) + c * (to - step * arriving[k]) + d * to
        };
        Composition::rounded((0..from.fractions().len()).map(fraction).collect())
    }
}

/// A part of a span between two shares of its way.
#[derive(Debug, Clone, PartialEq)]
pub struct Strip {
    /// Share of the way through the span where it begins.
    pub from: f64,
    /// Share where it ends.
    pub to: f64,
    /// Its rulings.
    pub band: Band,
}
