//! Where along a correspondence J still changes from one level of a refinement to the next.

use super::RulingLine;
use super::level::SMALL_CHANGE;
use crate::geom::order_by_number;

/// Stretches of equal length, in mean shares of arc length, into which a correspondence is cut.
const STRETCHES: usize = 512;
/// Share of the change at which a refinement ends that stretches may have changed by, all together, when they are left as they are.
const SETTLED: f64 = 0.5;

/// The integral of f over each stretch of a correspondence, and by how much it changed when the stretch was last refined.
#[derive(Debug, Clone)]
pub(super) struct Course {
    integrals: Vec<f64>,
    changes: Vec<f64>,
    /// Stretches that the next level refines.
    is_unsettled: Vec<bool>,
}

impl Course {
    /// The course of the first level: every stretch is to be refined.
    pub(super) fn new(lines: &[RulingLine], places: &[[f64; 2]]) -> Self {
        let integrals = integrals(lines, places);
        let changes = vec![f64::INFINITY; STRETCHES];
        Self { integrals, changes, is_unsettled: vec![true; STRETCHES] }
    }

    /// The course of the next level, on which the stretches that were not settled have been refined. The second level settles none: two
    /// levels may agree by chance.
    pub(super) fn next(&self, lines: &[RulingLine], places: &[[f64; 2]]) -> Self {
        let integrals = integrals(lines, places);
        let changes = (0..STRETCHES)
            .map(|k| if self.is_unsettled[k] { integrals[k] - self.integrals[k] } else { self.changes[k] });
        let changes: Vec<f64> = changes.collect();
        let most = SETTLED * SMALL_CHANGE * integrals.iter().sum::<f64>();
        let is_second = self.changes[0].is_infinite();
        let is_unsettled = if is_second { vec![true; STRETCHES] } else { unsettled(&changes, most) };
        Self { integrals, changes, is_unsettled }
    }

    /// Relative change of J, each stretch by the change when it was last refined; `None` on the first level.
    pub(super) fn change(&self) -> Option<f64> {
        let change = (self.changes.iter().sum::<f64>() / self.integrals.iter().sum::<f64>()).abs();
        change.is_finite().then_some(change)
    }

    /// Tells of both outlines, with so many vertices, at which of these the next level has to be finer.
    pub(super) fn unsettled_vertices(
        &self,
        lines: &[RulingLine],
        places: &[[f64; 2]],
        counts: (usize, usize),
    ) -> [Vec<bool>; 2] {
        let mut found = [vec![false; counts.0], vec![false; counts.1]];
        for (k, (begin, end)) in ways(places).enumerate() {
            let (first, last) = ((begin * STRETCHES as f64).floor(), (end * STRETCHES as f64).floor());
            let is_settled = (first as i64..=last as i64)
                .all(|at| !self.is_unsettled[at.rem_euclid(STRETCHES as i64) as usize]);
            if is_settled {
                continue;
            }
            for line in [lines[k], lines[(k + 1) % lines.len()]] {
                (found[0][line.from], found[1][line.to]) = (true, true);
            }
        }
        found
    }
}

/// Mean shares of arc length at which the way from each line to the next begins and ends, ascending.
fn ways(places: &[[f64; 2]]) -> impl Iterator<Item = (f64, f64)> + '_ {
    let mean = |k: usize| places[k % places.len()].iter().sum::<f64>() / 2.0 + (k / places.len()) as f64;
    (0..places.len()).map(move |k| (mean(k), mean(k + 1)))
}

/// Integrals over the stretches by the trapezoid rule.
fn integrals(lines: &[RulingLine], places: &[[f64; 2]]) -> Vec<f64> {
    let mut integrals = vec![0.0; STRETCHES];
    for (k, (begin, end)) in ways(places).enumerate() {
        let (f, g) = (lines[k].value, lines[(k + 1) % lines.len()].value);
        let mut from = begin;
        while from < end {
            let stretch = (from * STRETCHES as f64).floor();
            let to = ((stretch + 1.0) / STRETCHES as f64).min(end);
            // A step too small to be a number ends the way.
            let to = if to > from { to } else { end };
            let middle = ((from + to) / 2.0 - begin) / (end - begin);
            integrals[(stretch as i64).rem_euclid(STRETCHES as i64) as usize] +=
                (f + (g - f) * middle) * (to - from);
            from = to;
        }
    }
    integrals
}

/// Which stretches are not among those that change least and by no more than `most` together, and are no neighbours of such.
fn unsettled(changes: &[f64], most: f64) -> Vec<bool> {
    let mut sum = 0.0;
    let mut is_large = vec![false; changes.len()];
    for k in order_by_number(changes.len(), |k| changes[k].abs()) {
        sum += changes[k].abs();
        is_large[k] = sum > most;
    }
    let n = changes.len();
    (0..n).map(|k| is_large[(k + n - 1) % n] || is_large[k] || is_large[(k + 1) % n]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A correspondence through `count` places with f(m) at the mean share m; its second curve runs a third of a lap ahead.
    fn correspondence(count: usize, f: impl Fn(f64) -> f64) -> (Vec<RulingLine>, Vec<[f64; 2]>) {
        let place = |k: usize| [k as f64 / count as f64, k as f64 / count as f64 + 2.0 / 3.0];
        let places: Vec<[f64; 2]> = (0..count).map(place).collect();
        let line = |(k, place): (usize, &[f64; 2])| RulingLine {
            from: k,
            to: (k + 2 * count / 3) % count,
            lifted: (k + 2 * count / 3) as i64,
            value: f((place[0] + place[1]) / 2.0),
        };
        (places.iter().enumerate().map(line).collect(), places)
    }

    #[test]
    fn stretches_add_up_to_the_trapezoid_rule() {
        for count in [7, 300, 5000] {
            let (lines, places) = correspondence(count, |m| 1.0 + (9.0 * m).sin());
            let expected = |k: usize| {
                // One lap on the line of the first place has the value that it has there.
                (lines[k].value + lines[(k + 1) % count].value) / (2.0 * count as f64)
            };
            let expected: f64 = (0..count).map(expected).sum();
            let sum: f64 = integrals(&lines, &places).iter().sum();
            assert!((sum - expected).abs() < 1e-12, "{count}: {sum} {expected}");
        }
    }

    #[test]
    fn only_where_values_change_is_refined_from_the_third_level_on() {
        // Between 0.5 and 0.6 the values of each level differ from those of the one before.
        let level =
            |by: f64| correspondence(900, move |m| 1.0 + if (0.5..0.6).contains(&m) { by } else { 0.0 });
        let all = |course: &Course, (lines, places): &(Vec<RulingLine>, Vec<[f64; 2]>)| {
            course
                .unsettled_vertices(lines, places, (900, 900))
                .map(|found| found.iter().filter(|at| **at).count())
        };
        let (first, second, third) = (level(0.0), level(0.4), level(0.6));
        let course = Course::new(&first.0, &first.1);
        assert_eq!((course.change(), all(&course, &first)), (None, [900, 900]));
        let course = course.next(&second.0, &second.1);
        assert_eq!(all(&course, &second), [900, 900]);
        let course = course.next(&third.0, &third.1);
        let change = course.change().expect("a third level");
        // The jumps lie somewhere between two lines.
        assert!((change - 0.02 / 1.06).abs() < 0.2 / 900.0, "{change}");
        let [rows, columns] = course.unsettled_vertices(&third.0, &third.1, (900, 900));
        // A place lies at its mean share less a third on the first curve, and plus a third on the second.
        let is_near = |k: usize, middle: f64| (k as f64 / 900.0 - middle).abs() < 0.05 + 3.0 / 512.0;
        assert!((0..900).all(|k| !rows[k] || is_near(k, 0.55 - 1.0 / 3.0)), "rows");
        assert!((0..900).all(|k| !columns[k] || is_near(k, 0.55 + 1.0 / 3.0)), "columns");
        let found = rows.iter().filter(|at| **at).count();
        assert!((85..=110).contains(&found), "{found}");
        // What is left alone keeps the change it had.
        let kept = course.next(&third.0, &third.1);
        assert!(kept.change().is_some_and(|change| change < 1e-9));
    }

    #[test]
    fn what_changes_least_is_settled_up_to_a_sum_and_not_beside_the_rest() {
        let changes = [0.0, 1.0, -1.0, 0.0, 0.0, 9.0, 0.0, -2.0, 0.0, 0.0];
        let found = |most| -> Vec<usize> {
            let is = unsettled(&changes, most);
            (0..changes.len()).filter(|&k| is[k]).collect()
        };
        assert_eq!(found(20.0), [] as [usize; 0]);
        assert_eq!(found(4.0), [4, 5, 6]);
        assert_eq!(found(2.0), [4, 5, 6, 7, 8]);
    }
}
