//! Two outlines made ready for matching.

use super::value::End;
use super::{NegativeProducts, Outline, Weights, blocking_edge, round_to_40_bits};
use crate::geom::{
    Bounds, Location, ShownPlace, deepest_point, first_contact, first_self_contact, locate, segment_crossing,
    signed_area,
};
use glam::DVec2;
use std::f64::consts::{PI, TAU};
use std::fmt;

/// Which polygon lies inside the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layout {
    /// The first curve is the inner one.
    FirstInside,
    /// The second curve is the inner one.
    SecondInside,
    /// The curves lie at different heights and their projections cross.
    Crossing,
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

/// Two outlines, one inside the other, with the weights of their ruling lines.
///
/// Guarantees: both polygons are simple and counter-clockwise. They do not meet and one lies inside the other, or, at different
/// heights, they meet and have a common inside.
#[derive(Debug, Clone)]
pub struct Problem {
    outlines: [Outline; 2],
    weights: Weights,
    gap: f64,
    layout: Layout,
    shortest: f64,
    center: DVec2,
    angles: [Vec<f64>; 2],
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

    /// The same curves with other samples; lifts about the same centre, so that vertices at the same place keep their laps when
    /// both outlines start where they did.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub(super) fn resampled(&self, outlines: [Outline; 2]) -> Result<Self, ProblemError> {
        Self::about(Some(self.center), outlines, self.weights, self.gap)
    }

    fn about(
        center: Option<DVec2>,
        outlines: [Outline; 2],
        weights: Weights,
        gap: f64,
    ) -> Result<Self, ProblemError> {
        for (outline, Outline { points, .. }) in outlines.iter().enumerate() {
            if let Some((i, k)) = first_self_contact(points) {
                return Err(ProblemError::NotSimple { outline, at: meeting_place(points, i, points, k) });
            }
            if signed_area(points) <= 0.0 {
                return Err(ProblemError::NotCounterClockwise { outline });
            }
        }
        let (first, second) = (&outlines[0].points, &outlines[1].points);
        let contact = first_contact(first, second)
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
            Layout::Crossing => &both,
        };
        let is_inside = |center: &DVec2| polygons.iter().all(|p| locate(p, *center) == Location::Inside);
        let center = center
            .filter(is_inside)
            .or_else(|| deepest_point(polygons))
            .ok_or_else(|| contact.unwrap_or(ProblemError::Apart))?;
        let angles = outlines.each_ref().map(|outline| angles_about(center, &outline.points));
        let bounds = Bounds::of(first.iter().chain(second).copied());
        let diagonal = bounds.map_or(0.0, Bounds::diagonal);
        Ok(Self { outlines, weights, gap, layout, shortest: SHORTEST * diagonal, center, angles })
    }

    /// The same problem on other polygons of the same curves, which are not checked.
    pub(super) fn refined(&self, outlines: [Outline; 2]) -> Self {
        let angles = outlines.each_ref().map(|outline| angles_about(self.center, &outline.points));
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

    /// Which outline lies inside the other.
    #[must_use]
    pub fn layout(&self) -> Layout {
        self.layout
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

    /// Tells whether a line keeps the constraints, by looking at every edge: it meets no edge but those at its ends, and where
    /// the projections cross, its middle lies inside exactly one polygon.
    #[must_use]
    pub fn is_visible(&self, from: usize, to: usize) -> bool {
        let [first, second] = self.outlines.each_ref().map(|outline| outline.points.as_slice());
        let middle = (first[from] + second[to]) / 2.0;
        blocking_edge(&self.outlines, from, to).is_none()
            && (self.layout != Layout::Crossing
                || matches!(
                    [locate(first, middle), locate(second, middle)],
                    [Location::Inside, Location::Outside] | [Location::Outside, Location::Inside]
                ))
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
    /// Both ends have an angle about a point inside the inner polygon, unwrapped along their outline. The line subtends less
    /// than half a turn there, so the number of whole turns between the two angles is an integer that rounding finds.
    pub(super) fn lift(&self, from: usize, to: usize) -> i64 {
        let laps = ((self.angles[0][from] - self.angles[1][to]) / TAU).round();
        to as i64 + self.counts().1 as i64 * laps as i64
    }

    /// A vertex as the end of a line.
    pub(super) fn end(&self, outline: usize, vertex: usize) -> End {
        let outline = &self.outlines[outline];
        End { point: outline.points[vertex], normal: outline.normals[vertex] }
    }
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
