//! The two ends of a drawn stroke, where they overlap.

use glam::DVec2;

use crate::geom::{SegmentGrid, segment_crossing, segments_meet};

/// Longest part of the way, at either end, that may be left out.
const LONGEST: f64 = 0.15;
/// How far an end may lie beside the beginning to run along it. The stroke has size one: half its diagonal.
const BESIDE: f64 = 0.1;

/// What is left of a stroke without what its ends overlap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Joined {
    /// The first vertex kept.
    pub(super) first: usize,
    /// The last vertex kept.
    pub(super) last: usize,
    /// Where the ends cross: the place at which both are cut.
    pub(super) crossing: Option<DVec2>,
}

/// Looks for an overlap of the ends of an open list of vertices: a crossing near both of them, or an end that runs on
/// beside the beginning.
pub(super) fn overlap(points: &[DVec2]) -> Option<Joined> {
    let mut arc = vec![0.0];
    for pair in points.windows(2) {
        arc.push(arc[arc.len() - 1] + pair[0].distance(pair[1]));
    }
    let count = points.len();
    let reach = LONGEST * arc[count - 1];
    let head = arc.partition_point(|&s| s <= reach).min(count - 1);
    let tail = arc.partition_point(|&s| s < arc[count - 1] - reach).max(1);
    // Both are open intervals of edges: 0..head begin the stroke, tail - 1..count - 1 end it.
    if head + 2 >= tail {
        return None;
    }
    crossing(points, head, tail).or_else(|| beside(points, head, tail))
}

/// The crossing nearest to the beginning.
fn crossing(points: &[DVec2], head: usize, tail: usize) -> Option<Joined> {
    let grid = SegmentGrid::new(points[tail..].windows(2).map(|edge| (edge[0], edge[1])).collect());
    (0..head).find_map(|i| {
        let (a, b) = (points[i], points[i + 1]);
        let j = tail + grid.find(a, b, |_, c, d| segments_meet(a, b, c, d))?;
        let place = segment_crossing(a, b, points[j], points[j + 1]);
        Some(Joined { first: i + 1, last: j, crossing: Some(place) })
    })
}

/// Cuts the end where it is nearest to the first vertex, when the way back to that vertex would turn round and what is cut
/// lies beside the beginning.
fn beside(points: &[DVec2], head: usize, tail: usize) -> Option<Joined> {
    let last = points.len() - 1;
    let first = points[0];
    let nearest = (tail..=last)
        .min_by(|&a, &b| points[a].distance_squared(first).total_cmp(&points[b].distance_squared(first)))?;
    let forward = points[1..=head].iter().find(|p| p.distance(first) > BESIDE / 2.0).map(|p| *p - first)?;
    let turns_round = (first - points[last]).dot(forward) < 0.0;
    let near = |p: DVec2| {
        (0..head).any(|i| {
            let (a, along) = (points[i], points[i + 1] - points[i]);
            let share = ((p - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
            p.distance(a + along * share) <= BESIDE
        })
    };
    let cut = &points[nearest + 1..];
    let joins = turns_round && !cut.is_empty() && points[nearest].distance(first) <= BESIDE;
    (joins && cut.iter().all(|&p| near(p))).then_some(Joined { first: 0, last: nearest, crossing: None })
}
