//! Why a line and not another at the same vertex.

use super::row::{Wedges, visible_lines};
use super::visibility::Sight;
use super::{Problem, RulingLine};
use std::iter::once;

/// What became of a line that was not the one looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fate {
    /// It is a ruling line as well.
    Taken,
    /// It meets a curve.
    Blocked,
    /// It crosses another ruling line, the one of this number.
    Crosses(usize),
    /// Nothing forbids it. Where its value is the higher one, the matching as a whole would be worth less.
    Free,
}

/// Another line at one end of the line looked at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rival {
    /// The line, lifted.
    pub line: RulingLine,
    /// What became of it.
    pub fate: Fate,
}

/// Where a line stands among all lines of one of its vertices.
#[derive(Debug, Clone, PartialEq)]
pub struct Standing {
    /// Its rank by value among the lines that meet no curve, from 1; lines of equal value share the better rank. `None` when it meets a
    /// curve itself.
    pub rank: Option<usize>,
    /// How many lines of the vertex meet no curve.
    pub visible: usize,
    /// The best of the other lines, best first.
    pub rivals: Vec<Rival>,
}

/// Compares line number `line` with other lines of its vertices: those from its end on the first outline to the vertices `others[1]` of the
/// second, and those from `others[0]` to its end there. At most `most` rivals are given at each end.
///
/// Returns `None` when there is no such line.
#[must_use]
pub fn standings(
    problem: &Problem,
    lines: &[RulingLine],
    line: usize,
    others: [&[usize]; 2],
    most: usize,
) -> Option<[Standing; 2]> {
    let this = *lines.get(line)?;
    let wedges = Wedges::new(problem);
    let mut sight = Sight::new(problem.outlines());
    let mut is_visible =
        |from, to| visible_lines(problem, &wedges, &mut sight, from, once(to)).next().is_some();
    let mut standing = |ends: Vec<(usize, usize)>| {
        let mut others: Vec<(RulingLine, bool)> = ends
            .into_iter()
            .map(|(from, to)| {
                let line =
                    RulingLine { from, to, lifted: problem.lift(from, to), value: problem.value(from, to) };
                (line, is_visible(from, to))
            })
            .filter(|(line, _)| line.value > f64::NEG_INFINITY)
            .collect();
        others.sort_by(|(p, _), (q, _)| q.value.total_cmp(&p.value));
        let is_this = |other: &RulingLine| (other.from, other.to) == (this.from, this.to);
        let seen = others.iter().filter(|(_, is_visible)| *is_visible);
        let better = seen.clone().filter(|(other, _)| other.value > this.value).count();
        let rank = seen.clone().any(|(other, _)| is_this(other)).then_some(better + 1);
        let rivals = others.iter().filter(|(other, _)| !is_this(other)).take(most);
        Standing {
            rank,
            visible: seen.count(),
            rivals: rivals
                .map(|&(other, is_visible)| Rival {
                    line: other,
                    fate: fate(&other, is_visible, lines, line, problem.counts()),
                })
                .collect(),
        }
    };
    Some([
        standing(others[1].iter().map(|&to| (this.from, to)).collect()),
        standing(others[0].iter().map(|&from| (from, this.to)).collect()),
    ])
}

/// What became of a line, next to all ruling lines but number `except`.
fn fate(
    rival: &RulingLine,
    is_visible: bool,
    lines: &[RulingLine],
    except: usize,
    (a, b): (usize, usize),
) -> Fate {
    if lines.iter().any(|line| (line.from, line.to) == (rival.from, rival.to)) {
        return Fate::Taken;
    }
    if !is_visible {
        return Fate::Blocked;
    }
    let crosses = |line: &RulingLine| {
        (-1..=1).any(|lap| {
            let along = line.from as i64 + lap * a as i64 - rival.from as i64;
            let lifted = line.lifted + lap * b as i64 - rival.lifted;
            along.signum() * lifted.signum() < 0
        })
    };
    let mut others = (0..lines.len()).filter(|&k| k != except);
    others.find(|&k| crosses(&lines[k])).map_or(Fate::Free, Fate::Crosses)
}

#[cfg(test)]
mod tests {
    use super::super::test_shapes::{Numbers, random_crossing, random_problem};
    use super::*;
    use crate::geom::segments_meet;
    use crate::matching::{Exact, ExactOptions, Weights};

    /// Random pairs that can be matched, with their best lines; every fourth one crosses in projection.
    fn matched(count: usize) -> Vec<(Problem, Vec<RulingLine>)> {
        let mut numbers = Numbers(41);
        let problems = (0..).map(|k| match k % 4 {
            0 => random_crossing(&mut numbers, 8, 24),
            _ => random_problem(&mut numbers, 8, 24),
        });
        let solved = problems.filter_map(|problem| {
            let mut job = Exact::new(problem.clone(), ExactOptions::default());
            let lines = job.step(&mut || true)?.ok()?.lines;
            Some((problem, lines))
        });
        solved.take(count).collect()
    }

    #[test]
    fn fates_are_what_segments_and_edges_say() {
        for (problem, lines) in matched(24) {
            let [first, second] = problem.outlines();
            let (a, b) = problem.counts();
            let ends = |line: &RulingLine| (first.points[line.from], second.points[line.to]);
            let all: [Vec<usize>; 2] = [(0..a).collect(), (0..b).collect()];
            for k in 0..lines.len() {
                let standings = standings(&problem, &lines, k, all.each_ref().map(Vec::as_slice), usize::MAX)
                    .expect("a line");
                for (end, standing) in standings.iter().enumerate() {
                    let all = if end == 0 { b } else { a };
                    assert_eq!(standing.rivals.len() + 1, all, "every other vertex");
                    let seen = (0..all).filter(|&other| match end {
                        0 => problem.is_visible(lines[k].from, other),
                        _ => problem.is_visible(other, lines[k].to),
                    });
                    assert_eq!(standing.visible, seen.count());
                    let above = |rival: &&Rival| {
                        rival.line.value > lines[k].value
                            && problem.is_visible(rival.line.from, rival.line.to)
                    };
                    assert_eq!(standing.rank, Some(standing.rivals.iter().filter(above).count() + 1));
                    assert!(standing.rivals.is_sorted_by(|p, q| p.line.value >= q.line.value));
                    for Rival { line, fate } in &standing.rivals {
                        let (p, q) = ends(line);
                        let is_visible = problem.is_visible(line.from, line.to);
                        let crosses = |other: &RulingLine| {
                            let (c, d) = ends(other);
                            segments_meet(p, q, c, d) && other.from != line.from
                        };
                        match *fate {
                            Fate::Taken => {
                                assert!(lines.iter().any(|l| (l.from, l.to) == (line.from, line.to)));
                            }
                            Fate::Blocked => assert!(!is_visible),
                            Fate::Crosses(other) => {
                                assert!(is_visible && other != k && crosses(&lines[other]));
                            }
                            Fate::Free => {
                                assert!(is_visible);
                                let clear = |other: &RulingLine| other.to == line.to || !crosses(other);
                                assert!((0..lines.len()).all(|o| o == k || clear(&lines[o])));
                            }
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn factors_multiply_to_the_value() {
        for (problem, lines) in matched(8) {
            let (outlines, weights, gap) = (problem.outlines().clone(), problem.weights(), problem.gap());
            let weights = Weights { normal: 1.5, alignment: 0.7, ..weights };
            let problem = Problem::new(outlines, weights, gap).expect("the same outlines");
            for line in lines {
                let [normal, distance, alignment] = problem.factors(line.from, line.to);
                let value = problem.value(line.from, line.to);
                assert!((normal * distance * alignment - value).abs() <= 1e-12 * value.abs());
                assert!((distance * problem.length(line.from, line.to).powi(2) - 1.0).abs() < 1e-12);
                let half = f64::midpoint(1.0, problem.alignment(line.from, line.to));
                assert!((alignment - half.powf(0.7)).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn no_more_rivals_than_asked_for_and_none_of_a_line_that_is_not_there() {
        let (problem, lines) = matched(1).remove(0);
        let ask = |line| standings(&problem, &lines, line, [&[0, 1, 2], &[0, 1, 2, 3, 4, 5]], 3);
        let [at_first, at_second] = ask(0).expect("a line");
        assert_eq!(at_first.rivals.len(), 3);
        assert!(at_second.rivals.len() <= 3 && at_second.visible <= 3);
        assert_eq!(ask(lines.len()), None);
    }
}
