//! Two outlines made ready for matching.

use super::measure::cross;
use super::value::End;
use super::visibility::Wedge;
use super::{NegativeProducts, Outline, RulingLine, Weights, blocking_edge, round_to_40_bits};
use crate::geom::{
    Bounds, Location, ShownPlace, deepest_point, first_contact, first_self_contact, locate, segment_crossing,
    signed_area,
};
use glam::DVec2;
use std::f64::consts::{PI, TAU};
use std::fmt;

/// How two outlines lie to each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layout {
    /// The first curve is the inner one.
    FirstInside,
    /// The second curve is the inner one.
    SecondInside,
    /// The curves lie at different heights and their projections cross.
    Crossing,
    /// Two open curves bound a region together with the lines that join their starts and their ends; all lines keep inside it.
    Strip {
        /// Whether the second curve lies to the left of the first, else to the right.
        left: bool,
    },
    /// Two open curves without such a region: their ends are free, or one of the two lines is in the way of the other or meets a
    /// curve, or the projections cross. Each line leaves one curve to the left and reaches the other from the right.
    Loose,
}

/// What becomes of the ends of two open curves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Ends {
    /// The first vertices are joined, and the last ones.
    #[default]
    Tied,
    /// The first line starts at the first vertex of either outline, the last one at the last of either; what lies beyond them is left out.
    Free,
}

/// Why two outlines cannot be matched at all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ProblemError {
    /// The polygon of one outline meets itself.
    NotSimple {
        /// 0 for the first curve, 1 for the second.
        outline: usize,
        /// A place where it does.
        at: DVec2,
    },
    /// The polygon of one outline runs clockwise or has no area.
    NotCounterClockwise {
        /// 0 for the first curve, 1 for the second.
        outline: usize,
    },
    /// The two polygons meet, at equal heights or without a common inside.
    Meet {
        /// A place where they do.
        at: DVec2,
    },
    /// Neither polygon lies inside the other.
    Apart,
}

impl fmt::Display for ProblemError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotSimple { outline, at } => {
                write!(f, "the polygon sampled from curve {outline} meets itself near {}", ShownPlace(*at))
            }
            Self::NotCounterClockwise { outline } => {
                write!(f, "the polygon sampled from curve {outline} does not run counter-clockwise")
            }
            Self::Meet { at } => write!(f, "the sampled polygons meet near {}", ShownPlace(*at)),
            Self::Apart => write!(f, "neither curve lies inside the other"),
        }
    }
}

impl std::error::Error for ProblemError {}

/// Two outlines with the weights of their ruling lines: one inside the other, or both open.
///
/// Guarantees: closed polygons are simple and counter-clockwise. They do not meet and one lies inside the other, or, at different
/// heights, they meet and have a common inside. Open polylines are simple, and at equal heights they do not meet.
#[derive(Debug, Clone)]
pub struct Problem {
    outlines: [Outline; 2],
    weights: Weights,
    gap: f64,
    layout: Layout,
    shortest: f64,
    center: DVec2,
    angles: [Vec<f64>; 2],
    /// Of open outlines.
    ends: Option<Ends>,
}

/// Lengths below this multiple of the diagonal count as this: keeps the values of touching points finite.
const SHORTEST: f64 = 1e-9;

impl Problem {
    /// Checks two outlines and prepares them; `gap` is the distance between their planes, at least 0.
    ///
    /// # Errors
    /// When a polygon is not simple or not counter-clockwise, when the two meet although `gap` is 0, or when they have no common
    /// inside.
    pub fn new(outlines: [Outline; 2], weights: Weights, gap: f64) -> Result<Self, ProblemError> {
        Self::about(None, outlines, weights, gap)
    }

    /// Checks two open outlines and prepares them; both run in the direction in which they are matched.
    ///
    /// # Errors
    /// When a polyline is not simple, or when the two meet although `gap` is 0.
    pub fn open(
        outlines: [Outline; 2],
        weights: Weights,
        gap: f64,
        ends: Ends,
    ) -> Result<Self, ProblemError> {
        let [first, second] = outlines.each_ref().map(|outline| outline.points.as_slice());
        check_simple(&outlines)?;
        let contact = first_contact(first, second, false);
        if let Some((i, k)) = contact
            && gap == 0.0
        {
            return Err(ProblemError::Meet { at: meeting_place(first, i, second, k) });
        }
        let shortest = shortest(first, second);
        let layout = match ends {
            Ends::Tied if contact.is_none() => strip(&outlines),
            Ends::Tied | Ends::Free => Layout::Loose,
        };
        let (center, angles) = (DVec2::ZERO, [Vec::new(), Vec::new()]);
        Ok(Self { outlines, weights, gap, layout, shortest, center, angles, ends: Some(ends) })
    }

    /// The same curves with other samples; lifts about the same centre, so that vertices at the same place keep their laps when
    /// both outlines start where they did.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub(super) fn resampled(&self, outlines: [Outline; 2]) -> Result<Self, ProblemError> {
        match self.ends {
            Some(ends) => Self::open(outlines, self.weights, self.gap, ends),
            None => Self::about(Some(self.center), outlines, self.weights, self.gap),
        }
    }

    fn about(
        center: Option<DVec2>,
        outlines: [Outline; 2],
        weights: Weights,
        gap: f64,
    ) -> Result<Self, ProblemError> {
        check_simple(&outlines)?;
        for (outline, Outline { points, .. }) in outlines.iter().enumerate() {
            if signed_area(points) <= 0.0 {
                return Err(ProblemError::NotCounterClockwise { outline });
            }
        }
        let (first, second) = (&outlines[0].points, &outlines[1].points);
        let contact = first_contact(first, second, true)
            .map(|(i, k)| ProblemError::Meet { at: meeting_place(first, i, second, k) });
        let layout = match contact {
            Some(meet) if gap == 0.0 => return Err(meet),
            Some(_) => Layout::Crossing,
            None if locate(second, first[0]) == Location::Inside => Layout::FirstInside,
            None if locate(first, second[0]) == Location::Inside => Layout::SecondInside,
            None => return Err(ProblemError::Apart),
        };
        // A point inside both polygons; where one contains the other, inside the inner one.
        let both: [&[DVec2]; 2] = [first, second];
        let polygons: &[&[DVec2]] = match layout {
            Layout::FirstInside => &both[..1],
            Layout::SecondInside => &both[1..],
            Layout::Crossing | Layout::Strip { .. } | Layout::Loose => &both,
        };
        let is_inside = |center: &DVec2| polygons.iter().all(|p| locate(p, *center) == Location::Inside);
        let center = center
            .filter(is_inside)
            .or_else(|| deepest_point(polygons))
            .ok_or_else(|| contact.unwrap_or(ProblemError::Apart))?;
        let angles = outlines.each_ref().map(|outline| angles_about(center, &outline.points));
        let shortest = shortest(first, second);
        Ok(Self { outlines, weights, gap, layout, shortest, center, angles, ends: None })
    }

    /// The same problem on other polygons of the same curves, which are not checked.
    pub(super) fn refined(&self, outlines: [Outline; 2]) -> Self {
        let about = |outline: &Outline| {
            if outline.closed { angles_about(self.center, &outline.points) } else { Vec::new() }
        };
        let angles = outlines.each_ref().map(about);
        Self { outlines, angles, ..*self }
    }

    /// The two outlines.
    #[must_use]
    pub fn outlines(&self) -> &[Outline; 2] {
        &self.outlines
    }

    /// Numbers of vertices (a, b) of the first and the second outline.
    #[must_use]
    pub fn counts(&self) -> (usize, usize) {
        (self.outlines[0].len(), self.outlines[1].len())
    }

    /// What the value of a line weighs.
    #[must_use]
    pub fn weights(&self) -> Weights {
        self.weights
    }

    /// Distance between the planes of the outlines.
    #[must_use]
    pub fn gap(&self) -> f64 {
        self.gap
    }

    /// How the outlines lie to each other.
    #[must_use]
    pub fn layout(&self) -> Layout {
        self.layout
    }

    /// What becomes of the ends of open outlines; `None` when they are closed.
    #[must_use]
    pub fn ends(&self) -> Option<Ends> {
        self.ends
    }

    /// The lines that join the first and the last vertices where they have to be joined.
    #[must_use]
    pub fn tied(&self) -> Option<[(usize, usize); 2]> {
        let (a, b) = self.counts();
        (self.ends == Some(Ends::Tied)).then_some([(0, 0), (a - 1, b - 1)])
    }

    /// Value f of the line from vertex `from` of the first outline to vertex `to` of the second.
    #[must_use]
    pub fn value(&self, from: usize, to: usize) -> f64 {
        self.value_between(self.end(0, from), self.end(1, to))
    }

    /// Value f of the line between any two points of the curves.
    pub(super) fn value_between(&self, p: End, q: End) -> f64 {
        self.weights.value(p, q, self.gap, self.shortest)
    }

    /// Tells whether a line keeps the constraints, by looking at every edge: it meets no edge but those at its ends; where
    /// the projections of closed curves cross, its middle lies inside exactly one polygon; and between open curves it keeps to
    /// their region, or to a left and a right side, as the [`Layout`] says.
    #[must_use]
    pub fn is_visible(&self, from: usize, to: usize) -> bool {
        let [first, second] = self.outlines.each_ref().map(|outline| outline.points.as_slice());
        let (p, q) = (first[from], second[to]);
        let middle = (p + q) / 2.0;
        let keeps_inside = || match self.layout {
            Layout::FirstInside | Layout::SecondInside => true,
            Layout::Crossing => matches!(
                [locate(first, middle), locate(second, middle)],
                [Location::Inside, Location::Outside] | [Location::Outside, Location::Inside]
            ),
            Layout::Strip { .. } => {
                self.tied().is_some_and(|ends| ends.contains(&(from, to)))
                    || self.clears_ends(from, to)
                        && locate(&region(first, second), middle) == Location::Inside
            }
            Layout::Loose => {
                let [at_p, at_q] = [(0, from), (1, to)].map(|(k, i)| Wedge::new(&self.outlines[k], i));
                at_p.points_inside(q) && at_q.points_outside(p)
                    || at_p.points_outside(q) && at_q.points_inside(p)
            }
        };
        blocking_edge(&self.outlines, from, to).is_none() && keeps_inside()
    }

    /// Tells whether a line keeps clear of the lines that join the ends of open outlines.
    pub(super) fn clears_ends(&self, from: usize, to: usize) -> bool {
        let line = |(from, to): (usize, usize)| RulingLine { from, to, lifted: 0, value: 0.0 };
        let crossed =
            |end: (usize, usize)| end != (from, to) && cross(&self.outlines, &line(end), &line((from, to)));
        self.tied().is_none_or(|ends| !ends.into_iter().any(crossed))
    }

    /// Product of the outward unit normals at the ends of a line, from -1 to 1.
    #[must_use]
    pub fn cosine(&self, from: usize, to: usize) -> f64 {
        self.outlines[0].normals[from].dot(self.outlines[1].normals[to])
    }

    /// Length of a line, with the gap between the planes.
    #[must_use]
    pub fn length(&self, from: usize, to: usize) -> f64 {
        (self.outlines[1].points[to] - self.outlines[0].points[from]).length().hypot(self.gap)
    }

    /// The factors of the value of a line: of the normals, of the length, and of the alignment; each is 1 where its weight is 0.
    #[must_use]
    pub fn factors(&self, from: usize, to: usize) -> [f64; 3] {
        let alone = Weights { normal: 0.0, distance: 0.0, alignment: 0.0, ..self.weights };
        let Weights { normal, distance, alignment, .. } = self.weights;
        let value =
            |weights: Weights| weights.value(self.end(0, from), self.end(1, to), self.gap, self.shortest);
        [
            value(Weights { normal, ..alone }),
            value(Weights { distance, ..alone }),
            value(Weights { alignment, ..alone }),
        ]
    }

    /// Product of the cosines between a line and each of the normals at its ends, from -1 to 1: 1 where the line runs along both.
    #[must_use]
    pub fn alignment(&self, from: usize, to: usize) -> f64 {
        let (p, q) = (self.end(0, from), self.end(1, to));
        let along = (q.point - p.point) / self.length(from, to).max(self.shortest);
        (along.dot(p.normal) * along.dot(q.normal)).clamp(-1.0, 1.0)
    }

    /// Rank of a line in the greedy order: higher values come first, and among equal ones (to 40 significant bits) the
    /// smaller second number, which is the length where negative products are clamped and 0 elsewhere.
    pub(super) fn rank(&self, from: usize, to: usize, value: f64) -> (f64, f64) {
        let tie = match self.weights.negative {
            NegativeProducts::Clamp => round_to_40_bits(self.length(from, to)),
            NegativeProducts::Signed | NegativeProducts::Half | NegativeProducts::Printed => 0.0,
        };
        (round_to_40_bits(value), tie)
    }

    /// Lift of a line that stays between the polygons: the vertex of the second outline counted on through its laps, such
    /// that lines do not cross if and only if their lifts ascend together round the band.
    ///
    /// On open curves there are no laps. On closed ones both ends have an angle about a point inside the inner polygon, unwrapped along their outline. The line subtends less
    /// than half a turn there, so the number of whole turns between the two angles is an integer that rounding finds.
    pub(super) fn lift(&self, from: usize, to: usize) -> i64 {
        if self.ends.is_some() {
            return to as i64;
        }
        let laps = ((self.angles[0][from] - self.angles[1][to]) / TAU).round();
        to as i64 + self.counts().1 as i64 * laps as i64
    }

    /// A vertex as the end of a line.
    pub(super) fn end(&self, outline: usize, vertex: usize) -> End {
        let outline = &self.outlines[outline];
        End { point: outline.points[vertex], normal: outline.normals[vertex] }
    }
}

fn check_simple(outlines: &[Outline; 2]) -> Result<(), ProblemError> {
    for (outline, Outline { points, closed, .. }) in outlines.iter().enumerate() {
        if let Some((i, k)) = first_self_contact(points, *closed) {
            return Err(ProblemError::NotSimple { outline, at: meeting_place(points, i, points, k) });
        }
    }
    Ok(())
}

/// The least length that counts.
fn shortest(first: &[DVec2], second: &[DVec2]) -> f64 {
    SHORTEST * Bounds::of(first.iter().chain(second).copied()).map_or(0.0, Bounds::diagonal)
}

/// The polygon along one polyline, and back along another one.
fn region(first: &[DVec2], second: &[DVec2]) -> Vec<DVec2> {
    first.iter().chain(second.iter().rev()).copied().collect()
}

/// Finds the region between simple open outlines that do not meet, if there is one: then neither of the lines between their ends meets
/// an outline or the other line.
fn strip(outlines: &[Outline; 2]) -> Layout {
    let [first, second] = outlines.each_ref().map(|outline| outline.points.as_slice());
    let ends = [(0, 0), (first.len() - 1, second.len() - 1)];
    let line = |(from, to): (usize, usize)| RulingLine { from, to, lifted: 0, value: 0.0 };
    let is_clear = ends.into_iter().all(|(from, to)| blocking_edge(outlines, from, to).is_none());
    if !is_clear || cross(outlines, &line(ends[0]), &line(ends[1])) {
        return Layout::Loose;
    }
    Layout::Strip { left: signed_area(&region(first, second)) > 0.0 }
}

fn meeting_place(first: &[DVec2], i: usize, second: &[DVec2], k: usize) -> DVec2 {
    let edge = |polygon: &[DVec2], i: usize| (polygon[i], polygon[(i + 1) % polygon.len()]);
    let ((a, b), (c, d)) = (edge(first, i), edge(second, k));
    segment_crossing(a, b, c, d)
}

/// Angles of the vertices about `center`, unwrapped along the polygon.
fn angles_about(center: DVec2, polygon: &[DVec2]) -> Vec<f64> {
    let mut last = 0.0;
    polygon
        .iter()
        .map(|&p| {
            let angle = (p - center).to_angle();
            let turn = angle - last;
            last += turn - TAU * ((turn + PI) / TAU).floor();
            last
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec2;

    fn circle(radius: f64, count: usize, center: DVec2) -> Outline {
        let normals: Vec<DVec2> =
            (0..count).map(|i| DVec2::from_angle(TAU * i as f64 / count as f64)).collect();
        Outline::new(normals.iter().map(|&n| center + radius * n).collect(), normals)
    }

    fn problem(first: Outline, second: Outline) -> Result<Problem, ProblemError> {
        Problem::new([first, second], Weights::default(), 0.0)
    }

    #[test]
    fn layouts_of_nested_circles() {
        let inner = circle(1.0, 12, DVec2::ZERO);
        let outer = circle(2.0, 15, dvec2(0.3, 0.1));
        let layout = |a: &Outline, b: &Outline| problem(a.clone(), b.clone()).map(|p| p.layout());
        assert_eq!(layout(&inner, &outer), Ok(Layout::FirstInside));
        assert_eq!(layout(&outer, &inner), Ok(Layout::SecondInside));
    }

    #[test]
    fn what_cannot_be_matched_is_told_apart() {
        let unit = || circle(1.0, 12, DVec2::ZERO);
        assert_eq!(problem(unit(), circle(1.0, 12, dvec2(5.0, 0.0))).err(), Some(ProblemError::Apart));
        let meets = problem(unit(), circle(1.0, 12, dvec2(1.0, 0.0)));
        assert!(matches!(meets, Err(ProblemError::Meet { at }) if at.length() < 1.1));
        let mut clockwise = circle(2.0, 12, DVec2::ZERO);
        clockwise.points.reverse();
        let expected = Some(ProblemError::NotCounterClockwise { outline: 1 });
        assert_eq!(problem(unit(), clockwise).err(), expected);
        let mut crossed = circle(2.0, 12, DVec2::ZERO);
        crossed.points.swap(2, 3);
        assert!(matches!(problem(unit(), crossed), Err(ProblemError::NotSimple { outline: 1, .. })));
    }

    #[test]
    fn lifts_follow_the_line_across_the_seams() {
        let problem = problem(circle(1.0, 12, DVec2::ZERO), circle(2.0, 12, DVec2::ZERO));
        let problem = problem.expect("nested circles");
        assert_eq!(problem.lift(3, 3), 3);
        assert_eq!(problem.lift(0, 11), -1, "one step back from the seam");
        assert_eq!(problem.lift(11, 0), 12, "one step on beyond it");
    }
}
