//! Threads: the matchings of neighbours joined from curve to curve.

use std::ops::Range;

/// A way through all curves of a stack.
#[derive(Debug, Clone, PartialEq)]
pub struct Thread {
    /// Parameter on every curve; from thread to thread each ascends or stays, beyond the ends of the domains.
    pub parameters: Vec<f64>,
    /// Spans of which the thread follows a line, one bit for each; bit 0 is the first span.
    pub lines: u32,
}

/// Parameters closer than this, as a share of the domain of their curve, are one.
const SAME: f64 = 1e-12;

/// Joins the lines of neighbouring spans to threads, in cyclic order, or from end to end where the curves are open.
///
/// `spans` has for each span the parameters (u, v) of its lines on its two curves, ascending beyond the ends of the domains. Between two lines
/// a matching is linear in both parameters, as the rulings of a band are. So every line is prolonged through all other spans, and a thread runs through
/// every line. `widths` are the lengths of the domains.
///
/// Where lines fan, a point of one curve is matched with a whole stretch of its neighbour, and a matching is a monotone relation, not a function.
/// Lines that end in one point share the rest of their thread. Where a fan from either side ends in the same point of an inner
/// curve, both are run through together at an even pace in their own parameters, so that threads stay in order.
///
/// Of open curves with free ends, threads lead through what all spans cover; there are none where that is nothing.
#[must_use]
pub fn threads(spans: &[Vec<(f64, f64)>], widths: &[f64], closed: bool) -> Vec<Thread> {
    let Some(first) = spans.first() else { return Vec::new() };
    let mut threads = of_span(0, first);
    for (span, lines) in spans.iter().enumerate().skip(1) {
        threads = join(threads, of_span(span, lines), &widths[..span + 2], closed);
    }
    threads
}

/// The lines of a span as threads through its two curves alone.
pub(super) fn of_span(span: usize, lines: &[(f64, f64)]) -> Vec<Thread> {
    lines.iter().map(|&(u, v)| Thread { parameters: vec![u, v], lines: 1 << span }).collect()
}

/// Joins the threads through some curves with those of the next span, `far`. `widths` are those of the curves of both.
pub(super) fn join(near: Vec<Thread>, far: Vec<Thread>, widths: &[f64], closed: bool) -> Vec<Thread> {
    if closed { join_closed(near, far, widths) } else { join_open(near, far, widths) }
}

/// Joins the threads `near` through some curves with those of the next span, `far`, both all round.
fn join_closed(near: Vec<Thread>, far: Vec<Thread>, widths: &[f64]) -> Vec<Thread> {
    let shared = widths.len() - 2;
    let (round, same) = (widths[shared], SAME * widths[shared]);
    let Some(near) = from_a_step(near, &widths[..=shared], same) else { return Vec::new() };
    let start = near[0].parameters[shared];
    let Some(mut far) = from_place(far, start - same, &widths[shared..]) else { return Vec::new() };
    if far[0].parameters[0] > start + same {
        let last = far.len() - 1;
        let before = moved(&far[last], &widths[shared..], -1.0);
        far.insert(0, between(&before, &far[0], 0, start));
    }
    let closing = |list: &mut Vec<Thread>, widths: &[f64]| list.push(moved(&list[0], widths, 1.0));
    let mut near = near;
    closing(&mut near, &widths[..=shared]);
    closing(&mut far, &widths[shared..]);
    let mut joined = merge(&near, &far, widths, same);
    // What is one lap on is the start again.
    joined.retain(|thread| thread.parameters[shared] < start + round - same);
    joined
}

/// Joins threads from end to end: where both lead through the shared curve.
fn join_open(near: Vec<Thread>, far: Vec<Thread>, widths: &[f64]) -> Vec<Thread> {
    let shared = widths.len() - 2;
    let same = SAME * widths[shared];
    let ends = |list: &[Thread], axis: usize| {
        let end = |thread: Option<&Thread>| thread.map_or(f64::NAN, |thread| thread.parameters[axis]);
        (end(list.first()), end(list.last()))
    };
    let ((a, b), (c, d)) = (ends(&near, shared), ends(&far, 0));
    let (lo, hi) = (a.max(c), b.min(d));
    if near.is_empty() || far.is_empty() || lo > hi + same {
        return Vec::new();
    }
    merge(&clipped(near, shared, lo, hi, same), &clipped(far, 0, lo, hi, same), widths, same)
}

/// Turns threads round so that the first one lies beyond the last one on their last curve; `None` for none.
fn from_a_step(mut threads: Vec<Thread>, widths: &[f64], same: f64) -> Option<Vec<Thread>> {
    let axis = widths.len() - 1;
    let count = threads.len();
    let at = |k: usize| threads[k].parameters[axis];
    let step = (0..count).find(|&k| {
        let before = if k == 0 { at(count - 1) - widths[axis] } else { at(k - 1) };
        at(k) - before > same
    })?;
    for thread in &mut threads[..step] {
        *thread = moved(thread, widths, 1.0);
    }
    threads.rotate_left(step);
    Some(threads)
}

/// Turns and moves the lines of a span so that the first one is the next from `start` on, and the last one within a lap of that; `None` for none.
fn from_place(mut lines: Vec<Thread>, start: f64, widths: &[f64]) -> Option<Vec<Thread>> {
    for line in &mut lines {
        let laps = ((line.parameters[0] - start) / widths[0]).floor();
        *line = moved(line, widths, -laps);
    }
    let falls =
        (1..lines.len()).find(|&k| lines[k].parameters[0] < lines[k - 1].parameters[0] - SAME * widths[0]);
    lines.rotate_left(falls.unwrap_or(0));
    (!lines.is_empty()).then_some(lines)
}

/// The part of threads with their parameter on one curve from `lo` to `hi`.
fn clipped(threads: Vec<Thread>, axis: usize, lo: f64, hi: f64, same: f64) -> Vec<Thread> {
    let at = |k: usize| threads[k].parameters[axis];
    let count = threads.len();
    let from = (0..count).find(|&k| at(k) >= lo - same).unwrap_or(count);
    let to = (0..count).rev().find(|&k| at(k) <= hi + same).map_or(0, |k| k + 1);
    let mut part = Vec::new();
    if from > 0 && from < count && at(from) > lo + same {
        part.push(between(&threads[from - 1], &threads[from], axis, lo));
    }
    if from < to {
        part.extend_from_slice(&threads[from..to]);
    }
    if to > 0 && to < count && at(to - 1) < hi - same {
        part.push(between(&threads[to - 1], &threads[to], axis, hi));
    }
    part
}

/// Runs through two lists that start and end at the same places of the shared curve, which is the last one of `near` and the first one of `far`.
fn merge(near: &[Thread], far: &[Thread], widths: &[f64], same: f64) -> Vec<Thread> {
    let shared = widths.len() - 2;
    let place = |list: &[Thread], k: usize, axis: usize| {
        list.get(k).map_or(f64::INFINITY, |thread| thread.parameters[axis])
    };
    let (mut i, mut j) = (0, 0);
    let mut joined = Vec::new();
    while i < near.len() || j < far.len() {
        let at = place(near, i, shared).min(place(far, j, 0));
        let group = |list: &[Thread], from: usize, axis: usize| {
            let beyond = list[from..].iter().position(|thread| thread.parameters[axis] > at + same);
            from..beyond.map_or(list.len(), |count| from + count)
        };
        let (a, b) = (group(near, i, shared), group(far, j, 0));
        (i, j) = (a.end, b.end);
        let near_here = here(near, &a, shared, at);
        let far_here = here(far, &b, 0, at);
        together(&near_here, &far_here, widths, at, &mut joined);
    }
    joined
}

/// The threads of a group at one place, or the one between its neighbours.
fn here(list: &[Thread], group: &Range<usize>, axis: usize, at: f64) -> Vec<Thread> {
    if !group.is_empty() {
        return list[group.clone()].to_vec();
    }
    match (group.start.checked_sub(1).and_then(|k| list.get(k)), list.get(group.start)) {
        (Some(before), Some(after)) => vec![between(before, after, axis, at)],
        (Some(only), None) | (None, Some(only)) => vec![Thread { lines: 0, ..only.clone() }],
        (None, None) => Vec::new(),
    }
}

/// Joins the threads that meet in one point of the shared curve.
fn together(near: &[Thread], far: &[Thread], widths: &[f64], at: f64, joined: &mut Vec<Thread>) {
    let shared = widths.len() - 2;
    let mut push = |a: &Thread, b: &Thread| {
        let mut parameters = a.parameters[..shared].to_vec();
        parameters.push(at);
        parameters.extend_from_slice(&b.parameters[1..]);
        joined.push(Thread { parameters, lines: a.lines | b.lines });
    };
    let near_pace = paces(near, &widths[..shared], 0);
    let far_pace = paces(far, &widths[shared + 1..], 1);
    let (mut i, mut j) = (0, 0);
    while i < near.len() || j < far.len() {
        let pace = |paces: &[f64], k: usize| paces.get(k).copied().unwrap_or(f64::INFINITY);
        let now = pace(&near_pace, i).min(pace(&far_pace, j));
        let a = at_pace(near, &near_pace, &mut i, now);
        let b = at_pace(far, &far_pace, &mut j, now);
        if let (Some(a), Some(b)) = (a, b) {
            push(&a, &b);
        }
    }
}

/// How far along a fan its threads lie, from 0 to 1, by the parameters from `axis` on; a lone thread lies at 0 and stays.
fn paces(fan: &[Thread], widths: &[f64], axis: usize) -> Vec<f64> {
    let along = |thread: &Thread| -> f64 {
        widths.iter().zip(&thread.parameters[axis..]).map(|(width, parameter)| parameter / width).sum()
    };
    let (Some(first), Some(last)) = (fan.first().map(along), fan.last().map(along)) else {
        return Vec::new();
    };
    let count = fan.len() - 1;
    let even = |k: usize| if count == 0 { 0.0 } else { k as f64 / count as f64 };
    let whole = last - first;
    let pace = |(k, thread): (usize, &Thread)| {
        if k == count && k > 0 {
            1.0
        } else if whole > SAME {
            ((along(thread) - first) / whole).clamp(0.0, 1.0)
        } else {
            even(k)
        }
    };
    fan.iter().enumerate().map(pace).collect()
}

/// The thread of a fan at a pace; goes on to the next one where it is one of the fan's own.
fn at_pace(fan: &[Thread], paces: &[f64], next: &mut usize, now: f64) -> Option<Thread> {
    let k = *next;
    if k < fan.len() && paces[k] <= now {
        *next += 1;
        return Some(fan[k].clone());
    }
    let before = fan.get(k.checked_sub(1)?)?;
    let Some(after) = fan.get(k) else { return Some(Thread { lines: 0, ..before.clone() }) };
    let share = (now - paces[k - 1]) / (paces[k] - paces[k - 1]);
    Some(mixed(before, after, share))
}

/// The thread between two others whose parameter on one curve is `at`.
fn between(before: &Thread, after: &Thread, axis: usize, at: f64) -> Thread {
    let (from, to) = (before.parameters[axis], after.parameters[axis]);
    let share = if to > from { ((at - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
    let mut thread = mixed(before, after, share);
    thread.parameters[axis] = at;
    thread
}

fn mixed(before: &Thread, after: &Thread, share: f64) -> Thread {
    let pairs = before.parameters.iter().zip(&after.parameters);
    Thread { parameters: pairs.map(|(from, to)| from + share * (to - from)).collect(), lines: 0 }
}

/// The same thread some laps on.
fn moved(thread: &Thread, widths: &[f64], laps: f64) -> Thread {
    let pairs = thread.parameters.iter().zip(widths);
    Thread {
        parameters: pairs.map(|(parameter, width)| parameter + laps * width).collect(),
        lines: thread.lines,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use proptest::test_runner::{Config, RngSeed, TestRunner};

    fn parameters(threads: &[Thread]) -> Vec<Vec<f64>> {
        threads.iter().map(|thread| thread.parameters.clone()).collect()
    }

    #[test]
    fn one_span_keeps_its_lines() {
        let lines = vec![(0.0, 0.1), (0.5, 0.6)];
        let found = threads(std::slice::from_ref(&lines), &[1.0, 1.0], true);
        assert_eq!(parameters(&found), [[0.0, 0.1], [0.5, 0.6]]);
        assert!(found.iter().all(|thread| thread.lines == 1));
    }

    #[test]
    fn lines_are_prolonged_through_the_other_span() {
        // On the shared curve the lines of the first span end at 0 and 0.5, those of the second begin at 0.25 and 0.75.
        let spans = [vec![(0.0, 0.0), (0.5, 0.5)], vec![(0.25, 0.0), (0.75, 0.5)]];
        let found = threads(&spans, &[1.0, 1.0, 1.0], true);
        let expected = [[0.0, 0.0, -0.25], [0.25, 0.25, 0.0], [0.5, 0.5, 0.25], [0.75, 0.75, 0.5]];
        assert_eq!(parameters(&found), expected);
        assert_eq!(found.iter().map(|thread| thread.lines).collect::<Vec<_>>(), [1, 2, 1, 2]);
    }

    #[test]
    fn fans_that_meet_in_a_point_are_run_through_together() {
        // Both fans of three end in the place 0.5 of the shared curve.
        let spans = [
            vec![(0.0, 0.0), (0.4, 0.5), (0.5, 0.5), (0.6, 0.5)],
            vec![(0.0, 0.0), (0.5, 0.3), (0.5, 0.4), (0.5, 0.7)],
        ];
        let found = threads(&spans, &[1.0, 1.0, 1.0], true);
        let middle: Vec<_> = found.iter().filter(|thread| thread.parameters[1] == 0.5).collect();
        let expected = [[0.4, 0.3], [0.45, 0.4], [0.5, 0.5], [0.6, 0.7]];
        assert_eq!(middle.len(), expected.len());
        for (thread, [first, last]) in middle.iter().zip(expected) {
            assert!(
                (thread.parameters[0] - first).abs() < 1e-12 && (thread.parameters[2] - last).abs() < 1e-12
            );
        }
        assert_eq!(middle.iter().map(|thread| thread.lines).collect::<Vec<_>>(), [3, 2, 1, 3]);
    }

    #[test]
    fn a_fan_across_the_seam_stays_whole() {
        // The fan at 0 of the shared curve has lines on both sides of the seam, of either span.
        let spans = [vec![(0.05, 0.0), (0.5, 0.5), (0.95, 1.0)], vec![(0.0, 0.1), (0.5, 0.5), (1.0, 0.9)]];
        let found = threads(&spans, &[1.0, 1.0, 1.0], true);
        assert_eq!(found.len(), 3);
        assert_ordered(&found, &[1.0, 1.0, 1.0], true);
    }

    #[test]
    fn open_threads_lead_through_what_all_spans_cover() {
        let spans = [vec![(0.0, 0.2), (1.0, 1.0)], vec![(0.0, 0.0), (0.6, 1.0)]];
        let found = threads(&spans, &[1.0, 1.0, 1.0], false);
        let ends = [found.first().map(|t| t.parameters[1]), found.last().map(|t| t.parameters[1])];
        assert_eq!(ends, [Some(0.2), Some(0.6)]);
        let apart = [vec![(0.0, 0.0), (1.0, 0.3)], vec![(0.6, 0.0), (1.0, 1.0)]];
        assert!(threads(&apart, &[1.0, 1.0, 1.0], false).is_empty());
    }

    fn assert_ordered(threads: &[Thread], widths: &[f64], closed: bool) {
        let mut list = threads.to_vec();
        if closed {
            list.push(moved(&threads[0], widths, 1.0));
        }
        for pair in list.windows(2) {
            for (from, to) in pair[0].parameters.iter().zip(&pair[1].parameters) {
                assert!(to - from >= -1e-9, "{:?} {:?}", pair[0], pair[1]);
            }
        }
    }

    /// Steps of a monotone path: along the first curve, along the second, or along both, by some way each.
    fn path() -> impl Strategy<Value = Vec<(u8, u8, u8)>> {
        prop::collection::vec((0_u8..3, 1_u8..4, 1_u8..4), 3..20)
    }

    #[test]
    fn threads_keep_order_and_run_through_every_line() {
        let strategy = (prop::collection::vec((path(), -1.0..1.0), 2..5), any::<bool>());
        let seed = 20_261_126;
        let config = Config {
            cases: 300,
            rng_seed: RngSeed::Fixed(seed),
            failure_persistence: None,
            ..Config::default()
        };
        TestRunner::new(config)
            .run(&strategy, |(paths, closed)| {
                let spans: Vec<Vec<(f64, f64)>> =
                    paths.iter().map(|(steps, shift)| lines(steps, *shift, closed)).collect();
                let widths = vec![1.0; spans.len() + 1];
                let found = threads(&spans, &widths, closed);
                assert_ordered(&found, &widths, closed);
                for (span, lines) in spans.iter().enumerate() {
                    let own: Vec<_> = found.iter().filter(|thread| thread.lines & 1 << span != 0).collect();
                    prop_assert_eq!(own.len(), lines.len());
                    for &(u, v) in lines {
                        let near = |x: f64, y: f64| (x - y - (x - y).round()).abs() < 1e-9;
                        let is_it =
                            |t: &&&Thread| near(t.parameters[span], u) && near(t.parameters[span + 1], v);
                        prop_assert!(own.iter().any(|thread| is_it(&thread)), "line {u} {v} of span {span}");
                    }
                }
                Ok(())
            })
            .unwrap_or_else(|failure| panic!("seed {seed}: {failure}"));
    }

    /// A monotone staircase through both domains, once round from a random place, or from end to end.
    fn lines(steps: &[(u8, u8, u8)], shift: f64, closed: bool) -> Vec<(f64, f64)> {
        let mut places = vec![(0.0, 0.0)];
        let (mut u, mut v) = (0.0, 0.0);
        for &(kind, a, b) in steps.iter().chain(&[(2, 1, 1)]) {
            u += if kind == 1 { 0.0 } else { f64::from(a) };
            v += if kind == 0 { 0.0 } else { f64::from(b) };
            places.push((u, v));
        }
        let scaled = places.iter().map(|&(x, y)| (x / u, y / v));
        if closed {
            // The end is the start again. Eighths make places of neighbouring spans coincide now and then.
            let shift = (shift * 8.0).round() / 8.0;
            scaled.take(places.len() - 1).map(|(x, y)| (x + shift, y)).collect()
        } else {
            scaled.collect()
        }
    }
}
