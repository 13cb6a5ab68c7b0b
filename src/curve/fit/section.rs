//! One smooth stretch of a curve: knots where the error is, and no more than needed.
//!
//! Spans that miss the tolerance are halved until none does. Then the knots are spread anew, so that every span takes its even
//! share of the fourth root of the fourth derivative, which the jumps of the third one tell, with as few spans as
//! still reach the tolerance. What is left over is taken out by trial.
//!
//! # References
//! C. de Boor, *A Practical Guide to Splines* (1978), chapter XII, for the density of the knots.

use super::distance::{Distance, distance, vertex_parameters};
use super::nodes::Nodes;
use super::polyline::Polyline;
use super::spline::{Knots, Spline};
use super::squares::least_squares;

/// Fewest spans of a closed cubic.
const FEWEST_CLOSED: usize = 4;
/// Shortest span, as a share of the whole curve: far above the distance at which knots merge.
const SHORTEST: f64 = 1e-8;
/// Corrections of the parameters in one fit, each followed by another solution.
const CORRECTIONS: usize = 3;
/// Parameters are corrected only when the spline is near its polyline, in tolerances; else points are drawn to wrong places.
const NEAR: f64 = 16.0;
/// Least share of the mean that every span has in the density of the knots.
const FLOOR: f64 = 0.05;
/// Most times that the knots are spread.
const SPREADS: usize = 3;
/// Rounds of halving after which a tolerance counts as out of reach.
const ROUNDS: usize = 48;

/// A spline that keeps to the tolerance, and its distance from the polyline.
#[derive(Debug, Clone)]
pub(super) struct Fitted {
    pub(super) spline: Spline,
    pub(super) error: f64,
    nodes: Nodes,
}

/// A stretch to be fitted.
#[derive(Debug, Clone, Copy)]
pub(super) struct Section<'a> {
    pub(super) line: &'a Polyline,
    pub(super) closed: bool,
    pub(super) tolerance: f64,
    /// Most spans it may take.
    pub(super) most: usize,
    /// Length of the whole curve, of which this is a part.
    pub(super) whole: f64,
}

/// How many comparisons of a node or a vertex with the spline may go into sparing knots; bounds the time of a fit.
#[derive(Debug, Clone, Copy)]
pub(super) struct Effort(pub(super) usize);

impl Effort {
    /// Takes the cost of one trial; false when too little is left.
    fn spend(&mut self, cost: usize) -> bool {
        let enough = self.0 >= cost;
        self.0 = self.0.saturating_sub(cost);
        enough
    }
}

/// A trial that keeps to the tolerance, or the distances of the spans of one that does not.
type Trial = Result<Fitted, Vec<f64>>;

impl Section<'_> {
    /// A spline within the tolerance; the distance reached instead when the spans or their lengths come to an end.
    pub(super) fn fit(&self, effort: &mut Effort) -> Result<Fitted, f64> {
        let grown = self.grow()?;
        let spread = self.spread(grown, effort);
        Ok(self.thin(spread, effort))
    }

    fn fewest(&self) -> usize {
        if self.closed { FEWEST_CLOSED } else { 1 }
    }

    fn knots(&self, breaks: Vec<f64>) -> Knots {
        Knots::new(breaks, self.closed)
    }

    /// Halves spans until all keep to the tolerance.
    fn grow(&self) -> Result<Fitted, f64> {
        let (spans, length) = (self.fewest(), self.line.length());
        let mut breaks: Vec<f64> = (0..=spans).map(|i| length * (i as f64 / spans as f64)).collect();
        let mut nodes = Nodes::ends(self.line);
        let mut reached = f64::INFINITY;
        for _ in 0..ROUNDS {
            let spans = breaks.len() - 1;
            if spans > self.most {
                break;
            }
            let distances = match self.attempt(breaks.clone(), &nodes) {
                Some((Ok(fitted), _)) => return Ok(fitted),
                Some((Err(distances), corrected)) => {
                    nodes = corrected;
                    distances
                }
                // The corrected parameters left a span empty: start again from those by length.
                None => {
                    nodes = Nodes::ends(self.line);
                    vec![f64::INFINITY; spans]
                }
            };
            reached = distances.iter().copied().fold(0.0, f64::max);
            let mut finer = vec![0.0];
            for (pair, &distance) in breaks.windows(2).zip(&distances) {
                if distance > self.tolerance && pair[1] - pair[0] > 2.0 * SHORTEST * self.whole {
                    finer.push(pair[0] + (pair[1] - pair[0]) / 2.0);
                }
                finer.push(pair[1]);
            }
            if finer.len() == breaks.len() {
                break;
            }
            breaks = finer;
        }
        Err(reached)
    }

    /// The spline on given breaks with corrected parameters, and its nodes; `None` when it is not determined.
    fn attempt(&self, breaks: Vec<f64>, known: &Nodes) -> Option<(Trial, Nodes)> {
        let knots = self.knots(breaks);
        let mut nodes = known.spread(self.line, &knots);
        let mut spline = least_squares(&knots, &nodes)?;
        let mut distances = nodes.distances(&spline);
        let largest = |distances: &[f64]| distances.iter().copied().fold(0.0, f64::max);
        for _ in 0..CORRECTIONS {
            if largest(&distances) > NEAR * self.tolerance {
                break;
            }
            nodes.correct(&spline);
            spline = least_squares(&knots, &nodes)?;
            distances = nodes.distances(&spline);
        }
        if largest(&distances) > self.tolerance {
            return Some((Err(distances), nodes));
        }
        let parameters = vertex_parameters(&spline, self.line, &nodes);
        let Distance { largest, spans, .. } = distance(&spline, self.line, &parameters);
        if largest > self.tolerance {
            return Some((Err(spans), nodes));
        }
        Some((Ok(Fitted { spline, error: largest, nodes: nodes.clone() }), nodes))
    }

    /// An attempt that counts only when it keeps to the tolerance.
    fn reaches(&self, breaks: Vec<f64>, known: &Nodes) -> Option<Fitted> {
        self.attempt(breaks, known).and_then(|(trial, _)| trial.ok())
    }

    /// What an attempt costs at most.
    fn cost(&self, fitted: &Fitted) -> usize {
        (2 * CORRECTIONS + 1) * fitted.nodes.0.len() + 4 * self.line.points.len()
    }

    /// Spreads the knots by the density, over as few spans as reach the tolerance, and again by the density that this gives.
    fn spread(&self, grown: Fitted, effort: &mut Effort) -> Fitted {
        let mut best = grown;
        for _ in 0..SPREADS {
            let before = best.spline.pieces.len();
            best = self.spread_once(best, effort);
            if best.spline.pieces.len() == before {
                break;
            }
        }
        best
    }

    /// Halves the interval of the number of spans, spread by a density, that reach the tolerance.
    fn spread_once(&self, start: Fitted, effort: &mut Effort) -> Fitted {
        let fine = self.halved(&start);
        let reference = fine.as_ref().unwrap_or(&start.spline);
        let density = density(reference);
        let (mut low, mut high) = (self.fewest(), start.spline.pieces.len());
        let mut best = start.clone();
        while low < high && effort.spend(self.cost(&start)) {
            let spans = (low + high) / 2;
            match self.reaches(equal_shares(&reference.knots.breaks, &density, spans), &best.nodes) {
                Some(fitted) => (best, high) = (fitted, spans),
                None => low = spans + 1,
            }
        }
        best
    }

    /// The spline with every span halved: its third derivative tells the fourth one more truly.
    fn halved(&self, fitted: &Fitted) -> Option<Spline> {
        let mut breaks = vec![0.0];
        for pair in fitted.spline.knots.breaks.windows(2) {
            breaks.extend([pair[0] + (pair[1] - pair[0]) / 2.0, pair[1]]);
        }
        let knots = self.knots(breaks);
        least_squares(&knots, &fitted.nodes.spread(self.line, &knots))
    }

    /// Takes knots out while the tolerance allows, several at a time, those first that matter least.
    fn thin(&self, mut best: Fitted, effort: &mut Effort) -> Fitted {
        let mut at_once = best.spline.pieces.len() / 4;
        let mut needed: Vec<f64> = Vec::new();
        while best.spline.pieces.len() > self.fewest() && effort.spend(self.cost(&best)) {
            at_once = at_once.clamp(1, best.spline.pieces.len() - self.fewest());
            let gone = least(&best.spline, at_once, &needed);
            if gone.is_empty() {
                break;
            }
            let breaks = best.spline.knots.breaks.iter().copied().filter(|u| !gone.contains(u)).collect();
            match self.reaches(breaks, &best.nodes) {
                Some(fitted) => best = fitted,
                None if at_once == 1 => needed.extend(gone),
                None => at_once /= 2,
            }
        }
        best
    }
}

/// Density of the knots on each span: the fourth root of the size of the fourth derivative, and a floor.
fn density(spline: &Spline) -> Vec<f64> {
    let jumps = spline.jumps();
    let count = jumps.len();
    let width = |span: usize| spline.pieces[span].hi - spline.pieces[span].lo;
    let closed = spline.knots.closed;
    let estimate = |span: usize| {
        let before = if span > 0 || closed { width((span + count - 1) % count) } else { 0.0 };
        let after = if span + 1 < count || closed { width((span + 1) % count) } else { 0.0 };
        let next = if span + 1 < count || closed { jumps[(span + 1) % count] } else { 0.0 };
        (jumps[span] / (before + width(span)) + next / (width(span) + after)).sqrt().sqrt()
    };
    let roots: Vec<f64> = (0..count).map(estimate).collect();
    let length = spline.knots.length();
    let mean = roots.iter().enumerate().map(|(span, root)| root * width(span)).sum::<f64>() / length;
    let floor = if mean > 0.0 { FLOOR * mean } else { 1.0 };
    let smooth = |span: usize| {
        let (before, after) = match closed {
            true => ((span + count - 1) % count, (span + 1) % count),
            false => (span.saturating_sub(1), (span + 1).min(count - 1)),
        };
        (roots[before] + 2.0 * roots[span] + roots[after]) / 4.0
    };
    (0..count).map(|span| smooth(span) + floor).collect()
}

/// Breaks of `spans` spans over which a density, constant between the given breaks, is spread evenly.
fn equal_shares(breaks: &[f64], density: &[f64], spans: usize) -> Vec<f64> {
    let width = |i: usize| breaks[i + 1] - breaks[i];
    let total: f64 = (0..density.len()).map(|i| density[i] * width(i)).sum();
    let (mut index, mut sum) = (0, 0.0);
    let mut result = vec![0.0];
    for k in 1..spans {
        let share = total * (k as f64 / spans as f64);
        while index + 1 < density.len() && sum + density[index] * width(index) < share {
            sum += density[index] * width(index);
            index += 1;
        }
        result.push(breaks[index] + ((share - sum) / density[index]).clamp(0.0, width(index)));
    }
    result.push(breaks[breaks.len() - 1]);
    result
}

/// The `count` inner breaks whose removal changes the spline least, but for those that are needed; no two are neighbours.
///
/// A jump J of the third derivative between spans of lengths a and b is worth about J (a b / (a + b))^3.
fn least(spline: &Spline, count: usize, needed: &[f64]) -> Vec<f64> {
    let breaks = &spline.knots.breaks;
    let jumps = spline.jumps();
    let worth = |i: usize| {
        let (a, b) = (breaks[i] - breaks[i - 1], breaks[i + 1] - breaks[i]);
        jumps[i] * (a * b / (a + b)).powi(3)
    };
    let inner = (1..breaks.len() - 1).filter(|&i| !needed.contains(&breaks[i]));
    let mut order: Vec<(usize, f64)> = inner.map(|i| (i, worth(i))).collect();
    order.sort_by(|a, b| a.1.total_cmp(&b.1));
    let mut gone = vec![false; breaks.len()];
    let mut result = Vec::new();
    for (i, _) in order {
        if result.len() < count && !gone[i - 1] && !gone[i + 1] {
            gone[i] = true;
            result.push(breaks[i]);
        }
    }
    result
}
