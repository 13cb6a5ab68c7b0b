//! Places where a curve meets itself or another curve.
//!
//! Both questions walk down trees of Bezier pieces. Two stretches are apart when their boxes, or their boxes along
//! either chord, are apart. They cross when each has its ends on different sides of the other's strip: then the
//! two must cut each other in the parallelogram of the strips, whatever they do inside. A stretch cannot meet itself
//! or the stretch after it while the directions of both stay within less than a half turn. What is undecided is
//! halved, until both stretches are chords and their distance decides.

use glam::DVec2;

use super::bezier::Bezier;
use super::bspline::BSpline;
use super::hull_tree::{HullTree, NodeId, Strip};
use super::nearest::nearest_of;

/// Distance below which stretches touch, relative to the diagonal of the control points. Far above rounding, far
/// below what a picture or a machine shows.
const TOUCH: f64 = 1e-9;
/// Two places touch only when the way between them along the curve leads farther than this, relative to the
/// diagonal; else the legs of every cusp would touch near its tip. Proper crossings count at every size.
const LOCAL: f64 = 1e-4;
/// Margin of a certified crossing and length of the shortest leg with a direction, relative to the diagonal.
const NOISE: f64 = 1e-13;
/// Comparisons a search may make, and additional ones for each piece. Ordinary curves of 14 points need a few
/// hundred; curves that run along each other at a distance of a few tolerances would need millions.
const BUDGET: usize = 20_000;
const BUDGET_PER_PIECE: usize = 100;
/// Points at which the way between two places is looked at.
const WAY_POINTS: u32 = 16;

/// A place where a curve meets itself or another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meeting {
    /// Parameter on the curve that was asked.
    pub u: f64,
    /// Parameter on the other curve, or the larger one of the two on the curve itself.
    pub v: f64,
    /// The place.
    pub at: DVec2,
}

impl BSpline {
    /// Finds a place where the curve crosses or touches itself, or `None` when it is simple. The ends of an open curve count like any
    /// other place.
    ///
    /// Stretches that come closer than about 1e-9 of the diagonal of the control points touch; closer legs of a cusp or
    /// of a sharp corner do not, within 1e-4 of the diagonal from its tip. Loops are found down to about 1e-9 of
    /// the diagonal. One place is reported, not all of them. A curve that goes back along itself is found as well.
    ///
    /// The answer `None` is certified by convex hulls, up to rounding. The work is bounded by 20 000 comparisons and
    /// 100 for each piece; past that, which happens only where stretches run along each other at nearly the
    /// tolerance, the closest undecided place is reported as if they met.
    ///
    /// # References
    /// T. Sederberg and T. Nishita, "Curve intersection using Bezier clipping", *Computer-Aided Design* 22 (1990), for the
    /// strips, without the clipping: halving also ends on tangent and on coincident curves.
    #[must_use]
    pub fn self_intersection(&self) -> Option<Meeting> {
        let bounds = self.bounds();
        let mut pieces = self.moving_pieces(bounds.center());
        while pieces.len() < 3 {
            pieces = pieces.iter().flat_map(|piece| <[Bezier; 2]>::from(piece.halves())).collect();
        }
        let mut search = Search::new(self, self, bounds.center(), bounds.diagonal());
        search.on_itself = true;
        search.budget += BUDGET_PER_PIECE * pieces.len();
        // Three arcs, since two would be neighbours at both ends of a closed curve.
        let (third, count) = (pieces.len() / 3, pieces.len());
        let a = search.tree.add(&pieces[..third]);
        let b = search.tree.add(&pieces[third..count - third]);
        let c = search.tree.add(&pieces[count - third..]);
        let seam = if self.is_closed() { Task::Joined(c, a) } else { Task::Between(a, c) };
        let joined = [Task::Joined(a, b), Task::Joined(b, c), seam];
        let found =
            search.run([Task::Within(a), Task::Within(b), Task::Within(c)].into_iter().chain(joined))?;
        Some(if found.u <= found.v { found } else { Meeting { u: found.v, v: found.u, at: found.at } })
    }

    /// Finds a place where the curve crosses or touches another one in the same plane, or `None` when they are apart.
    ///
    /// Curves closer than about 1e-9 of the diagonal of all control points touch; a curve touches itself. One
    /// place is reported. Accuracy and bounds of the work are those of [`self_intersection`](Self::self_intersection).
    #[must_use]
    pub fn contact(&self, other: &Self) -> Option<Meeting> {
        let bounds = self.bounds().union(other.bounds());
        let mut search = Search::new(self, other, bounds.center(), bounds.diagonal());
        let (first, second) = (self.moving_pieces(search.center), other.moving_pieces(search.center));
        search.budget += BUDGET_PER_PIECE * (first.len() + second.len());
        let (a, b) = (search.tree.add(&first), search.tree.add(&second));
        search.run([Task::Between(a, b)])
    }
}

/// A question about stretches of the curves.
#[derive(Debug, Clone, Copy)]
enum Task {
    /// Does the stretch meet itself?
    Within(NodeId),
    /// Do the stretches, of which the second starts where the first ends, meet anywhere else?
    Joined(NodeId, NodeId),
    /// Do the stretches meet?
    Between(NodeId, NodeId),
}

struct Search<'a> {
    first: &'a BSpline,
    second: &'a BSpline,
    /// Whether the two are one curve that is asked about itself.
    on_itself: bool,
    /// Origin of the pieces in the tree.
    center: DVec2,
    diagonal: f64,
    tree: HullTree,
    open: Vec<Task>,
    budget: usize,
}

impl<'a> Search<'a> {
    fn new(first: &'a BSpline, second: &'a BSpline, center: DVec2, diagonal: f64) -> Self {
        let tree = HullTree::new(NOISE * diagonal);
        Self { first, second, on_itself: false, center, diagonal, tree, open: Vec::new(), budget: BUDGET }
    }

    fn run(&mut self, tasks: impl IntoIterator<Item = Task>) -> Option<Meeting> {
        self.open.extend(tasks);
        for _ in 0..self.budget {
            let found = match self.open.pop()? {
                Task::Within(a) => {
                    self.within(a);
                    None
                }
                Task::Joined(a, b) => {
                    self.joined(a, b);
                    None
                }
                Task::Between(a, b) => self.between(a, b),
            };
            if found.is_some() {
                return found;
            }
        }
        self.closest_open()
    }

    fn within(&mut self, a: NodeId) {
        let node = self.tree.node(a);
        if node.cone.is_narrow() || node.size <= TOUCH * self.diagonal {
            return;
        }
        let (left, right) = self.tree.children(a);
        self.open.extend([Task::Within(left), Task::Within(right), Task::Joined(left, right)]);
    }

    fn joined(&mut self, a: NodeId, b: NodeId) {
        let (first, second) = (self.tree.node(a), self.tree.node(b));
        let small = first.size + second.size <= TOUCH * self.diagonal;
        if small || first.cone.union(second.cone).is_narrow() {
            return;
        }
        let (a, b) = (self.tree.children(a), self.tree.children(b));
        self.open.extend([
            Task::Joined(a.1, b.0),
            Task::Between(a.0, b.0),
            Task::Between(a.1, b.1),
            Task::Between(a.0, b.1),
        ]);
    }

    fn between(&mut self, a: NodeId, b: NodeId) -> Option<Meeting> {
        let tolerance = TOUCH * self.diagonal;
        let (first, second) = (self.tree.node(a), self.tree.node(b));
        if first.bounds.is_beyond(second.bounds, tolerance) {
            return None;
        }
        let split_first = first.size >= second.size;
        if let (Some((p, p_strip)), Some((q, q_strip))) = (self.tree.piece(a), self.tree.piece(b)) {
            if lies_beyond(p_strip, q, tolerance) || lies_beyond(q_strip, p, tolerance) {
                return None;
            }
            let margin = NOISE * self.diagonal;
            if straddles(p_strip, q_strip, margin)
                && straddles(q_strip, p_strip, margin)
                && let Some(meeting) = self.crossing(p, q)
            {
                return Some(meeting);
            }
            if is_chord(p, p_strip, tolerance / 4.0) && is_chord(q, q_strip, tolerance / 4.0) {
                return self.touch(p, p_strip, q, q_strip);
            }
        }
        if split_first {
            let (left, right) = self.tree.children(a);
            self.open.extend([Task::Between(left, b), Task::Between(right, b)]);
        } else {
            let (left, right) = self.tree.children(b);
            self.open.extend([Task::Between(a, left), Task::Between(a, right)]);
        }
        None
    }

    /// The crossing of two pieces that are known to cross, by Newton's method; `None` when it does not settle.
    fn crossing(&self, p: &Bezier, q: &Bezier) -> Option<Meeting> {
        let (p_velocity, q_velocity) = (p.hodograph(), q.hodograph());
        let (mut s, mut t) = (0.5, 0.5);
        for _ in 0..12 {
            let gap = q.point(t) - p.point(s);
            let (a, b) = (p_velocity.point(s), q_velocity.point(t));
            let determinant = a.perp_dot(b);
            let (next_s, next_t) = (s + gap.perp_dot(b) / determinant, t + gap.perp_dot(a) / determinant);
            if !(next_s.is_finite() && next_t.is_finite()) {
                return None;
            }
            let step = (next_s - s).abs().max((next_t - t).abs());
            (s, t) = (next_s.clamp(0.0, 1.0), next_t.clamp(0.0, 1.0));
            if step <= 1e-14 {
                break;
            }
        }
        let (a, b) = (p.point(s), q.point(t));
        let settled = a.distance(b) <= NOISE * self.diagonal;
        settled.then(|| self.meeting(p.parameter(s), q.parameter(t), (a + b) / 2.0))
    }

    /// Decides whether two pieces that are chords touch.
    fn touch(&self, p: &Bezier, p_strip: &Strip, q: &Bezier, q_strip: &Strip) -> Option<Meeting> {
        let (a, b) = closest_on_segments((p_strip.start, p_strip.end), (q_strip.start, q_strip.end));
        if a.distance(b) > TOUCH * self.diagonal {
            return None;
        }
        let at = (a + b) / 2.0;
        let parameter = |piece: &Bezier| {
            let points = piece.points.iter().map(|point| *point - at).collect();
            nearest_of(vec![Bezier { points, ..*piece }]).u
        };
        let meeting = self.meeting(parameter(p), parameter(q), at);
        (!self.on_itself || self.is_far_along(&meeting)).then_some(meeting)
    }

    fn meeting(&self, u: f64, v: f64, at: DVec2) -> Meeting {
        Meeting { u: self.first.wrap(u), v: self.second.wrap(v), at: at + self.center }
    }

    /// Whether both ways along the curve between the two places of a meeting lead away from it; an open curve has one way.
    fn is_far_along(&self, meeting: &Meeting) -> bool {
        let (lo, hi) = self.first.domain();
        let forward = (meeting.v - meeting.u).rem_euclid(hi - lo);
        let leads_away = |from: f64, step: f64| {
            let far = |i: u32| {
                let u = from + step * f64::from(i) / f64::from(WAY_POINTS);
                self.first.point(u).distance(meeting.at) > LOCAL * self.diagonal
            };
            (1..WAY_POINTS).any(far)
        };
        if !self.first.is_closed() {
            return leads_away(meeting.u.min(meeting.v), (meeting.v - meeting.u).abs());
        }
        leads_away(meeting.u, forward) && leads_away(meeting.v, hi - lo - forward)
    }

    /// The undecided stretches whose middles are closest, as a meeting.
    fn closest_open(&self) -> Option<Meeting> {
        let meeting = |task: &Task| {
            let (a, b) = match *task {
                Task::Within(a) => (a, a),
                Task::Joined(a, b) | Task::Between(a, b) => (a, b),
            };
            let (first, second) = (self.tree.node(a), self.tree.node(b));
            let (u, v) = (middle(first.range), middle(second.range));
            let (p, q) = (self.first.point(u), self.second.point(v));
            (matches!(task, Task::Between(..)), p.distance(q), Meeting { u, v, at: (p + q) / 2.0 })
        };
        let order =
            |a: &(bool, f64, Meeting), b: &(bool, f64, Meeting)| b.0.cmp(&a.0).then(a.1.total_cmp(&b.1));
        self.open.iter().map(meeting).min_by(order).map(|(_, _, meeting)| meeting)
    }
}

fn middle(range: (f64, f64)) -> f64 {
    range.0 + (range.1 - range.0) / 2.0
}

/// Whether a piece lies outside the box along a chord by more than `tolerance`.
fn lies_beyond(strip: &Strip, piece: &Bezier, tolerance: f64) -> bool {
    let (along, across) = strip.extent_of(&piece.points);
    let beyond =
        |own: (f64, f64), other: (f64, f64)| other.0 > own.1 + tolerance || other.1 < own.0 - tolerance;
    beyond(strip.along, along) || beyond(strip.across, across)
}

/// Whether the ends of the other stretch lie on different sides of the strip, by more than `margin`.
fn straddles(strip: &Strip, other: &Strip, margin: f64) -> bool {
    let side = |p: DVec2| strip.direction.perp_dot(p - strip.start);
    let (start, end) = (side(other.start), side(other.end));
    start.min(end) < strip.across.0 - margin && start.max(end) > strip.across.1 + margin
}

/// Whether a piece is its chord, or a point, up to `tolerance`.
fn is_chord(piece: &Bezier, strip: &Strip, tolerance: f64) -> bool {
    strip.is_chord(tolerance) || piece.extent() <= tolerance
}

/// The closest points of two segments, each of which may be a point.
fn closest_on_segments(p: (DVec2, DVec2), q: (DVec2, DVec2)) -> (DVec2, DVec2) {
    let (d, e, gap) = (p.1 - p.0, q.1 - q.0, q.0 - p.0);
    let determinant = d.perp_dot(e);
    if determinant != 0.0 {
        let (s, t) = (gap.perp_dot(e) / determinant, gap.perp_dot(d) / determinant);
        if (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t) {
            return (p.0 + d * s, q.0 + e * t);
        }
    }
    // Segments that do not cross are closest at an end of one of them.
    let onto = |point: DVec2, segment: (DVec2, DVec2)| {
        let along = segment.1 - segment.0;
        let length_sq = along.length_squared();
        let t =
            if length_sq > 0.0 { ((point - segment.0).dot(along) / length_sq).clamp(0.0, 1.0) } else { 0.0 };
        segment.0 + along * t
    };
    let candidates = [(p.0, onto(p.0, q)), (p.1, onto(p.1, q)), (onto(q.0, p), q.0), (onto(q.1, p), q.1)];
    let shorter = |a: (DVec2, DVec2), b: (DVec2, DVec2)| {
        if b.0.distance_squared(b.1) < a.0.distance_squared(a.1) { b } else { a }
    };
    candidates.into_iter().fold(candidates[0], shorter)
}
