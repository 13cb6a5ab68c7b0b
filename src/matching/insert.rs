//! Vertex insertion: from stars of lines to pairs of points, one to one.

use super::join::{Gap, Join, Spot};
use super::passes::Passes;
use super::quadrature::Quadrature;
use super::{Ends, Layout, Matching, Outline, Problem, RulingLine, Totals, blocking_edge, measure::cross};
use crate::curve::{ArcLength, BSpline, Samples};
use crate::geom::segment_crossing;
use glam::DVec2;

/// A matching in which every line has its own ends, but for the gaps named in `failed`.
#[derive(Debug, Clone)]
pub struct OneToOne {
    /// The outlines refined by the inserted vertices, and the values of lines between them.
    pub problem: Problem,
    /// Lines between vertices of the refined outlines, in cyclic order.
    pub lines: Vec<RulingLine>,
    /// Parameters (u, v) of the ends of each line: both ascend, beyond the ends of their domains; the first u lies in its domain.
    pub places: Vec<(f64, f64)>,
    /// Whether each line meets no edge of the refined outlines and crosses no other line.
    pub verified: Vec<bool>,
    /// Gaps between two lines of the star matching in which inserted lines failed; they keep the star lines.
    pub failed: Vec<FailedGap>,
    /// What the lines are worth. J and its bound are integrals over the curves, by the midpoints of eight parts from each line
    /// to the next, so that inserted vertices count for nothing by themselves.
    pub totals: Totals,
}

/// A gap that keeps its star lines.
#[derive(Debug, Clone, PartialEq)]
pub struct FailedGap {
    /// Indices of the lines from one side of the gap to the other.
    pub lines: Vec<usize>,
    /// Where an inserted line met an edge or another line.
    pub at: DVec2,
}

/// What one step of a pass does: a line leaves the vertex it shares at one end for a new vertex on the curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inserted {
    /// The curve with the new vertex: 0 in the first pass, 1 in the second.
    pub curve: usize,
    /// The sample of the other curve at which the line keeps its end; its other line ends are elsewhere by then.
    pub vertex: usize,
    /// The new vertex.
    pub at: DVec2,
    /// Value f of the line from there.
    pub value: f64,
}

/// Vertex insertion (Eq. 13 and Fig. 6 of the paper) as a job that advances in steps.
///
/// The first pass keeps the best line of every vertex of the first curve; the vertices of the second that lie between the
/// partners of two neighbours get partners of their own there, at parameters in the same proportion. The second pass keeps
/// the best line of every vertex of the second curve and spreads the others in the same way; on open curves the first and the last line
/// keep both ends. The number of lines
/// stays, and the parameters of both ends ascend strictly.
///
/// The paper infers that inserted lines cannot intersect. They can, and they can meet a polygon; so every line is
/// verified against the outlines refined by the inserted vertices and against every other line, edge by edge and pair by
/// pair. A gap in which one fails keeps the lines it had, and all is verified again.
#[derive(Debug)]
pub struct Insertion {
    curves: [BSpline; 2],
    arc_lengths: [ArcLength; 2],
    problem: Problem,
    counts: [usize; 2],
    /// The vertices of the sampled outlines.
    samples: [Vec<Spot>; 2],
    gaps: Vec<Gap>,
    /// The set as it is now, and the owner of each inserted vertex of the refined outlines.
    joins: Vec<Join>,
    lines: Vec<RulingLine>,
    owners: [Vec<Option<usize>>; 2],
    verified: Vec<bool>,
    crossings: usize,
    blocked: usize,
    has_failed: bool,
    quadrature: Option<Quadrature>,
    progress: f64,
}

impl Insertion {
    /// A job on a complete matching, that of `problem`, whose outlines are the `samples` of the `curves`.
    #[must_use]
    pub fn new(
        curves: &[BSpline; 2],
        samples: &[Samples; 2],
        problem: &Problem,
        matching: &Matching,
    ) -> Self {
        let arc_lengths = curves.each_ref().map(BSpline::arc_length);
        let (a, b) = problem.counts();
        let passes = Passes { curves, arc_lengths: &arc_lengths, samples, problem, lines: &matching.lines };
        let mut job = Self {
            gaps: passes.gaps(),
            samples: [0, 1]
                .map(|axis| (0..samples[axis].arc.len() as i64).map(|k| passes.vertex(axis, k)).collect()),
            curves: curves.clone(),
            arc_lengths,
            problem: problem.clone(),
            counts: [a, b],
            joins: Vec::new(),
            lines: Vec::new(),
            owners: [Vec::new(), Vec::new()],
            verified: Vec::new(),
            crossings: 0,
            blocked: 0,
            has_failed: false,
            quadrature: None,
            progress: 0.0,
        };
        job.refine();
        job
    }

    /// Advances while `may_go_on` says so, at least by a little; returns the pairs when they are found.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<OneToOne> {
        loop {
            if let Some(pairs) = self.advance() {
                return Some(pairs);
            }
            if !may_go_on() {
                return None;
            }
        }
    }

    /// Share of the work that is done, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.progress
    }

    /// What the two passes insert, in their order and that of the lines; asked before the first step, as long as no gap has failed.
    #[must_use]
    pub fn inserted(&self) -> Vec<Inserted> {
        let of_pass = |curve: usize| {
            self.joins.iter().zip(&self.lines).filter_map(move |(join, line)| {
                let [new, kept] = [&join.ends[curve], &join.ends[1 - curve]];
                let vertex = kept.vertex.filter(|_| new.vertex.is_none())?;
                Some(Inserted { curve, vertex, at: new.end.point, value: line.value })
            })
        };
        of_pass(0).chain(of_pass(1)).collect()
    }

    /// Verifies one line, or integrates over one gap.
    fn advance(&mut self) -> Option<OneToOne> {
        let count = self.lines.len();
        if let Some(quadrature) = &mut self.quadrature {
            let done = quadrature.advance(&self.problem, &self.curves, &self.arc_lengths);
            self.progress = 0.3 + 0.7 * done;
            return (done >= 1.0).then(|| self.finish());
        }
        if self.verified.len() < count {
            self.verify(self.verified.len());
            self.progress = self.progress.max(0.3 * self.verified.len() as f64 / count as f64);
        } else if self.has_failed {
            self.refine();
        } else {
            let lengths = self.arc_lengths.each_ref().map(ArcLength::total);
            let arcs =
                [0, 1].map(|axis| self.joins.iter().map(|join| join.ends[axis].arc(lengths[axis])).collect());
            self.quadrature = Some(Quadrature::new(&self.problem, &self.lines, arcs));
        }
        None
    }

    fn periods(&self) -> [f64; 2] {
        self.curves.each_ref().map(BSpline::domain).map(|(lo, hi)| hi - lo)
    }

    /// Puts the set together anew and begins to verify it.
    fn refine(&mut self) {
        let mut joins: Vec<Join> = Vec::new();
        for gap in &self.gaps {
            let others = if gap.failed.is_some() { &gap.stars } else { &gap.inserted };
            joins.push(gap.kept);
            joins.extend(others);
        }
        let (period, end, closed) = (self.periods()[0], self.curves[0].domain().1, self.is_closed());
        let is_beyond = |join: &&Join| closed && join.ends[0].parameter(period) >= end;
        let beyond = joins.iter().filter(is_beyond).count();
        joins.rotate_right(beyond);
        for join in &mut joins[..beyond] {
            for end in &mut join.ends {
                end.laps -= 1.0;
            }
        }
        let [(first, from, first_owners), (second, to, second_owners)] = [0, 1].map(|axis| {
            let (mut numbers, mut vertices) = vertices(&joins, axis);
            if let (false, [first, .., last]) = (closed, joins.as_slice()) {
                // Vertices beyond the first and the last line stay where they are.
                let [before, after] = self.left_out(axis, [first, last]);
                numbers.iter_mut().for_each(|number| *number += before.len());
                vertices = before.into_iter().chain(vertices).chain(after).collect();
            }
            let total = self.arc_lengths[axis].total();
            (outline(&vertices, axis, total, closed), numbers, owners(&vertices, axis))
        });
        self.problem = self.problem.refined([first, second]);
        let (a, b) = self.problem.counts();
        let line = |(&from, &to): (&usize, &usize)| {
            let (from, lifted) = (from % a, to as i64);
            RulingLine { from, to: to % b, lifted, value: self.problem.value(from, to % b) }
        };
        self.lines = from.iter().zip(&to).map(line).collect();
        self.owners = [first_owners, second_owners];
        self.joins = joins;
        self.verified.clear();
        (self.crossings, self.blocked, self.has_failed) = (0, 0, false);
    }

    fn is_free(&self) -> bool {
        self.problem.ends() == Some(Ends::Free)
    }

    fn is_closed(&self) -> bool {
        self.problem.ends().is_none()
    }

    /// Vertices of an open outline before its first line and after its last one.
    fn left_out(&self, axis: usize, [first, last]: [&Join; 2]) -> [Vec<Join>; 2] {
        let vertex = |join: &Join| join.ends[axis].vertex.unwrap_or(0);
        let join = |&spot: &Spot| Join { ends: [spot; 2], gap: 0 };
        let samples = &self.samples[axis];
        [
            samples[..vertex(first)].iter().map(join).collect(),
            samples[vertex(last) + 1..].iter().map(join).collect(),
        ]
    }

    /// Checks one line against every edge and every later line.
    fn verify(&mut self, k: usize) {
        let line = self.lines[k];
        let outlines = self.problem.outlines();
        let segment = |line: &RulingLine| (outlines[0].points[line.from], outlines[1].points[line.to]);
        let (p, q) = segment(&line);
        let mut faults: Vec<(Option<usize>, DVec2)> = Vec::new();
        let own = |k: usize| self.joins[k].is_inserted().then_some(self.joins[k].gap);
        let block = blocking_edge(outlines, line.from, line.to);
        if let Some(edge) = block {
            let outline = &outlines[edge.outline];
            let (a, b) = outline.edge(edge.vertex);
            let at = segment_crossing(p, q, a, b);
            let owners = &self.owners[edge.outline];
            match own(k) {
                Some(gap) => faults.push((Some(gap), at)),
                // A line of the star matching kept clear of the outlines: an inserted vertex is in the way.
                None => {
                    faults.extend([edge.vertex, (edge.vertex + 1) % outline.len()].map(|i| (owners[i], at)))
                }
            }
        }
        // Where the projections cross, a line that meets no edge may still run outside the band between them.
        let leaves = block.is_none()
            && !matches!(self.problem.layout(), Layout::FirstInside | Layout::SecondInside)
            && !self.problem.is_visible(line.from, line.to);
        if leaves {
            faults.push((own(k), (p + q) / 2.0));
        }
        let mut crossings = 0;
        for (other, later) in self.lines.iter().enumerate().skip(k + 1) {
            if cross(outlines, &line, later) {
                let (r, s) = segment(later);
                let at = segment_crossing(p, q, r, s);
                faults.extend([(own(k), at), (own(other), at)]);
                crossings += 1;
            }
        }
        self.crossings += crossings;
        self.blocked += usize::from(block.is_some() || leaves);
        self.verified.push(faults.is_empty());
        for (gap, at) in faults {
            if let Some(gap) = gap.map(|gap| &mut self.gaps[gap]).filter(|gap| gap.failed.is_none()) {
                gap.failed = Some(at);
                self.has_failed = true;
            }
        }
    }

    fn finish(&mut self) -> OneToOne {
        let count = self.lines.len();
        let sum: f64 = self.lines.iter().map(|line| line.value).sum();
        let (integral, bound) = self.quadrature.as_ref().map_or((0.0, 0.0), Quadrature::result);
        let mut uncovered = self.counts.map(|count| (0..count).collect::<Vec<usize>>());
        for (axis, bare) in uncovered.iter_mut().enumerate() {
            let mut covered = vec![false; bare.len()];
            for vertex in self.joins.iter().filter_map(|join| join.ends[axis].vertex) {
                covered[vertex] = true;
            }
            let first = covered.iter().position(|&covered| covered).filter(|_| self.is_free());
            let last = covered.iter().rposition(|&covered| covered).filter(|_| self.is_free());
            let reached = first.unwrap_or(0)..=last.unwrap_or(covered.len());
            bare.retain(|vertex| !covered[*vertex] && reached.contains(vertex));
        }
        let totals = Totals {
            count,
            sum,
            mean: (count > 0).then(|| sum / count as f64),
            integral: Some(integral),
            eta: (bound > 0.0).then(|| integral / bound),
            crossings: self.crossings,
            blocked: self.blocked,
            uncovered,
        };
        let failed = self.gaps.iter().enumerate().filter_map(|(k, gap)| {
            let of_gap = |i: &usize| self.joins[*i].gap == k;
            let mut lines: Vec<usize> = (0..count).filter(of_gap).collect();
            lines.extend((0..count).find(|i| {
                let join = &self.joins[*i];
                join.gap == (k + 1) % self.gaps.len() && of_gap(&((i + count - 1) % count))
            }));
            gap.failed.map(|at| FailedGap { lines, at })
        });
        let [along, across] = self.periods();
        let place = |join: &Join| (join.ends[0].parameter(along), join.ends[1].parameter(across));
        OneToOne {
            failed: failed.collect(),
            problem: self.problem.clone(),
            lines: std::mem::take(&mut self.lines),
            places: self.joins.iter().map(place).collect(),
            verified: std::mem::take(&mut self.verified),
            totals,
        }
    }
}

/// Numbers of the ends of the lines among the vertices of a refined outline, in ascending order, and a line at each vertex.
fn vertices(joins: &[Join], axis: usize) -> (Vec<usize>, Vec<Join>) {
    let (mut numbers, mut vertices) = (Vec::with_capacity(joins.len()), Vec::<Join>::new());
    let vertex = |join: &Join| join.ends[axis].vertex;
    for join in joins {
        let repeats = vertex(join).is_some() && vertices.last().map(vertex) == Some(vertex(join));
        if !repeats {
            vertices.push(*join);
        }
        numbers.push(vertices.len() - 1);
    }
    let closes = vertices.len() > 1 && vertices.last().map(vertex) == vertices.first().map(vertex);
    if closes && vertices.first().and_then(vertex).is_some() {
        vertices.pop();
    }
    (numbers, vertices)
}

fn outline(vertices: &[Join], axis: usize, length: f64, closed: bool) -> Outline {
    let spot = |k: usize| vertices[k % vertices.len()].ends[axis];
    let all = 0..vertices.len();
    let next = |k: usize| {
        if k + 1 < vertices.len() {
            spot(k + 1).arc(length)
        } else if closed {
            spot(0).arc(length) + length
        } else {
            spot(k).arc(length)
        }
    };
    Outline {
        points: all.clone().map(|k| spot(k).end.point).collect(),
        normals: all.clone().map(|k| spot(k).end.normal).collect(),
        shares: all.map(|k| (next(k) - spot(k).arc(length)) / length).collect(),
        closed,
    }
}

fn owners(vertices: &[Join], axis: usize) -> Vec<Option<usize>> {
    vertices.iter().map(|join| join.ends[axis].vertex.is_none().then_some(join.gap)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::{Form, Scheme, sample};
    use crate::matching::{Weights, greedy};
    use std::collections::BTreeSet;
    use std::f64::consts::TAU;

    /// A job on two rings with their seams at the given angles.
    fn job(counts: [usize; 2], turns: [f64; 2]) -> (Insertion, Matching) {
        let ring = |radius: f64, turn: f64| {
            let point = |k: usize| radius * DVec2::from_angle(turn + TAU * k as f64 / 8.0);
            BSpline::new(3, Form::Periodic, (0..8).map(point).collect(), None).expect("a ring")
        };
        let curves = [ring(1.0, turns[0]), ring(3.0, turns[1])];
        let samples = [0, 1].map(|k| sample(&curves[k], Scheme::ArcLength, counts[k]));
        let problem =
            Problem::new(samples.each_ref().map(Outline::from), Weights::default(), 0.0).expect("nested");
        let matching = greedy(&problem);
        (Insertion::new(&curves, &samples, &problem, &matching), matching)
    }

    fn run(mut job: Insertion, may_go_on: bool) -> OneToOne {
        loop {
            if let Some(pairs) = job.step(&mut || may_go_on) {
                return pairs;
            }
        }
    }

    #[test]
    fn gaps_that_all_fail_give_back_the_star_matching() {
        for counts in [[3, 17], [17, 3], [5, 7], [9, 9]] {
            for turn in 0..8 {
                let (mut job, matching) = job(counts, [0.3, 0.8 * f64::from(turn)]);
                for gap in &mut job.gaps {
                    gap.failed = Some(DVec2::ZERO);
                }
                job.refine();
                let ends = |join: &Join| (join.ends[0].vertex, join.ends[1].vertex);
                let found: BTreeSet<_> = job.joins.iter().map(ends).collect();
                let stars = matching.lines.iter().map(|line| (Some(line.from), Some(line.to)));
                assert_eq!(found, stars.collect(), "{counts:?} {turn}");
                assert_eq!(job.joins.len(), matching.lines.len());
                assert_eq!(job.problem.counts(), (counts[0], counts[1]));
                let pairs = run(job, true);
                assert!(pairs.places.windows(2).all(|w| w[0].0 <= w[1].0 && w[0].1 <= w[1].1));
                assert!(pairs.verified.iter().all(|&verified| verified));
                assert_eq!(pairs.totals.sum, pairs.lines.iter().map(|line| line.value).sum::<f64>());
                assert!((pairs.totals.sum - matching.totals.sum).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn the_two_passes_move_one_end_of_each_line_that_shares_one() {
        for counts in [[3, 17], [17, 3], [5, 7], [9, 9], [20, 31]] {
            for turn in 0..8 {
                let (job, matching) = job(counts, [0.3, 0.8 * f64::from(turn)]);
                let inserted = job.inserted();
                // Lines that neither pass moves have both ends to themselves: the best of their stars.
                let mut left: Vec<(usize, usize)> =
                    matching.lines.iter().map(|line| (line.from, line.to)).collect();
                for Inserted { curve, vertex, at, .. } in &inserted {
                    let of_vertex: Vec<usize> = (0..left.len())
                        .filter(|&k| if *curve == 0 { left[k].1 == *vertex } else { left[k].0 == *vertex })
                        .collect();
                    assert_eq!(of_vertex.len(), 1, "{counts:?} {turn}: one line is there to be moved");
                    left.remove(of_vertex[0]);
                    let radius = if *curve == 0 { 1.0 } else { 3.0 };
                    assert!((at.length() / radius - 0.9).abs() < 0.1, "{at} lies on curve {curve}");
                }
                let all = |ends: Vec<usize>| ends.iter().collect::<BTreeSet<_>>().len() == ends.len();
                assert!(all(left.iter().map(|ends| ends.0).collect()), "{counts:?} {turn}");
                assert!(all(left.iter().map(|ends| ends.1).collect()), "{counts:?} {turn}");
                let pairs = run(job, true);
                assert_eq!(pairs.lines.len(), left.len() + inserted.len());
                assert!(inserted.is_sorted_by_key(|step| step.curve));
                for Inserted { curve, at, value, .. } in inserted {
                    let is_it = |line: &RulingLine| {
                        let end = if curve == 0 { line.from } else { line.to };
                        line.value == value && pairs.problem.outlines()[curve].points[end] == at
                    };
                    assert!(!pairs.failed.is_empty() || pairs.lines.iter().any(is_it), "{at}");
                }
            }
        }
    }

    #[test]
    fn small_steps_lead_to_the_same_pairs() {
        let (whole, parts) =
            (run(job([20, 31], [0.0, 2.0]).0, true), run(job([20, 31], [0.0, 2.0]).0, false));
        assert_eq!(whole.places, parts.places);
        assert_eq!(whole.totals, parts.totals);
    }
}
