//! A closed cubic B-spline near a closed list of points, or through them.
//!
//! The list is taken for a polyline. Without corners it is one closed stretch; corners that are kept cut it into open ones,
//! which are fitted by themselves and share only their ends. See [`fit`].

mod distance;
mod ends;
mod error;
mod nodes;
mod outline;
mod polyline;
mod section;
mod spline;
mod squares;
mod through;
mod turns;

use glam::DVec2;

use super::bspline::{BSpline, Form};
use crate::geom::first_self_contact;
use distance::distance;
pub use error::FitError;
pub use outline::MOST_POINTS;
use outline::Outline;
use polyline::Polyline;
use section::{Effort, Section};
use spline::{Knots, Spline};

/// Most times that the ends are cut where they overlap.
const MOST_CUTS: usize = 4;
/// Most control points of a curve.
const MOST_CONTROLS: usize = 2000;
/// Corners nearer to each other than this, as a share of the whole way, are one.
const SAME_CORNER: f64 = 1e-6;
/// Comparisons of points with the spline that sparing knots may cost.
const EFFORT: usize = 400_000;
/// Tolerances tried, each a quarter of the one before, until the curve does not meet itself.
const TIGHTER: usize = 4;

/// What becomes of corners.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CornerRule {
    /// A corner of the points is a corner of the curve: a knot of multiplicity 3 at the point.
    Keep,
    /// Corners are rounded within the tolerance.
    Smooth,
}

/// What becomes of the ends of a list whose last point does not repeat the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum EndRule {
    /// A straight edge joins them.
    Join,
    /// The same, but where they overlap, as those of a drawn stroke do, what is too much is left out.
    Trim,
}

/// How a curve is to be fitted.
#[derive(Debug, Clone, PartialEq)]
pub struct FitOptions {
    /// Largest distance between curve and polyline, above 0.
    pub tolerance: f64,
    /// What becomes of corners.
    pub corners: CornerRule,
    /// Whether the curve meets every point; the tolerance then only tells which corners there are.
    pub through: bool,
    /// Indices of the corners; `None`: they are found by the angle, from 40 degrees, on the scale of the tolerance.
    pub corner_indices: Option<Vec<usize>>,
    /// What becomes of the ends.
    pub ends: EndRule,
}

/// A fitted curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// Periodic and cubic over [0, 1], from the first point on.
    pub curve: BSpline,
    /// Bound of the distance of every point of the curve from the polyline, of every point of the polyline from
    /// the curve, and of points that were left out from the curve. At most one per cent above the largest distance of opposite
    /// points.
    pub error: f64,
    /// Indices of the points that are corners of the curve, ascending.
    pub corners: Vec<usize>,
    /// Whether the curve does not meet itself.
    pub simple: bool,
    /// Number of points left out at the ends.
    pub trimmed: usize,
}

/// Fits a closed cubic B-spline to a closed list of points, with few control points.
///
/// Points that repeat the one before, and a last one that repeats the first, count once. Near the points, the curve keeps to
/// the polyline through them within the tolerance, in both directions, and is twice differentiable but at corners that are
/// kept. Through the points it meets each of them, and the error says how far it swings out of the polyline. When
/// the curve meets itself although the polyline does not, smaller tolerances are tried.
///
/// # Errors
/// See [`FitError`]. At most 20 000 points are taken, and at most 2000 to be met.
///
/// # References
/// T. Lyche and K. Morken, "Knot removal for parametric B-spline curves and surfaces", *Computer Aided Geometric Design* 4
/// (1987), for sparing knots; J. Hoschek, "Intrinsic parametrization for approximation", *Computer Aided Geometric
/// Design* 5 (1988), for the correction of parameters.
pub fn fit(points: &[DVec2], options: &FitOptions) -> Result<Fit, FitError> {
    if !(options.tolerance.is_finite() && options.tolerance > 0.0) {
        return Err(FitError::Tolerance { tolerance: options.tolerance });
    }
    let corner_indices = options.corner_indices.as_deref().unwrap_or_default();
    if let Some(position) = corner_indices.iter().position(|&index| index >= points.len()) {
        let index = corner_indices[position];
        return Err(FitError::CornerIndex { position, index, count: points.len() });
    }
    let mut outline = Outline::new(points)?;
    let trimmed = trim(&mut outline, options);
    let tolerance = options.tolerance / outline.size;
    let mut corners = match (options.corners, &options.corner_indices) {
        (CornerRule::Smooth, _) => Vec::new(),
        (CornerRule::Keep, Some(given)) => given_corners(&outline, given),
        (CornerRule::Keep, None) => turns::corners(&outline.points, tolerance),
    };
    keep_apart(&outline.points, &mut corners);
    let task = Task { outline: &outline, corners: &corners, through: options.through };
    let mut best = task.solve(tolerance)?;
    let mut simple = best.curve.self_intersection().is_none();
    if !simple && !options.through && first_self_contact(&outline.points, true).is_none() {
        for step in 1..TIGHTER {
            let Ok(tighter) = task.solve(tolerance * 0.25_f64.powi(step as i32)) else { break };
            if tighter.curve.self_intersection().is_none() {
                (best, simple) = (tighter, true);
                break;
            }
        }
    }
    let Found { curve, error } = best;
    let control = curve.points().iter().map(|&p| outline.place(p)).collect();
    let knots = curve.knots()[3..=3 + curve.points().len()].to_vec();
    let curve = BSpline::new(3, Form::Periodic, control, Some(knots)).map_err(FitError::Curve)?;
    let left_out = trimmed.iter().map(|&index| curve.nearest(points[index]).distance_sq.sqrt());
    let error = left_out.fold(outline.distance(error), f64::max);
    let corners = corners.iter().map(|&k| outline.indices[k]).collect();
    Ok(Fit { curve, error, corners, simple, trimmed: trimmed.len() })
}

/// Leaves out what the ends overlap; returns the indices of the points left out.
fn trim(outline: &mut Outline, options: &FitOptions) -> Vec<usize> {
    if options.through
        || options.ends == EndRule::Join
        || outline.repeats_first
        || options.corner_indices.is_some()
    {
        return Vec::new();
    }
    let mut left_out = Vec::new();
    // Jitter may make ends that run along each other cross several times.
    for _ in 0..MOST_CUTS {
        let Some(joined) = ends::overlap(&outline.points) else { break };
        left_out.extend(&outline.indices[..joined.first]);
        left_out.extend(&outline.indices[joined.last + 1..]);
        outline.points = outline.points[joined.first..=joined.last].to_vec();
        outline.indices = outline.indices[joined.first..=joined.last].to_vec();
        if let Some(place) = joined.crossing {
            let (first, last) = (outline.points[0], outline.points[outline.points.len() - 1]);
            if place.distance(first).min(place.distance(last)) > outline::SAME {
                outline.points.insert(0, place);
                outline.indices.insert(0, outline.indices[0]);
            }
        }
    }
    left_out
}

/// Corners given by index, as indices of the points that differ, those that coincide taken once.
fn given_corners(outline: &Outline, given: &[usize]) -> Vec<usize> {
    let count = outline.points.len();
    let mut corners: Vec<usize> = given
        .iter()
        .map(|&index| {
            let after = outline.indices.partition_point(|&first| first <= index);
            // A point that repeats the first closes the list.
            if after == 0 { 0 } else { after - 1 }
        })
        .collect();
    let closing = |index: usize| outline.repeats_first && index > outline.indices[count - 1];
    for (corner, &index) in corners.iter_mut().zip(given) {
        // Points after the last one kept repeat either that one or the first.
        if closing(index) {
            *corner = 0;
        }
    }
    corners.sort_unstable();
    corners.dedup();
    corners
}

/// Drops corners so near to the one before that the stretch between them would be too short for knots of its own.
fn keep_apart(points: &[DVec2], corners: &mut Vec<usize>) {
    let line = Polyline::new(points.iter().chain(&points[..1]).copied().collect());
    let apart = SAME_CORNER * line.length();
    corners.dedup_by(|b, a| line.arc[*b] - line.arc[*a] < apart);
    let around =
        |corners: &[usize]| line.arc[corners[0]] + line.length() - line.arc[corners[corners.len() - 1]];
    while corners.len() > 1 && around(corners) < apart {
        corners.pop();
    }
}

/// What is to be fitted.
struct Task<'a> {
    outline: &'a Outline,
    corners: &'a [usize],
    through: bool,
}

/// A curve in the coordinates of the outline.
struct Found {
    curve: BSpline,
    error: f64,
}

impl Task<'_> {
    fn solve(&self, tolerance: f64) -> Result<Found, FitError> {
        let points = &self.outline.points;
        if self.through && points.len() > MOST_CONTROLS {
            return Err(FitError::TooManyToMeet { count: points.len(), limit: MOST_CONTROLS });
        }
        let out_of_reach =
            FitError::OutOfReach { tolerance: tolerance * self.outline.size, limit: MOST_CONTROLS };
        let lines = self.lines();
        let whole = lines.iter().map(Polyline::length).sum();
        let closed = self.corners.is_empty();
        let mut effort = Effort(EFFORT);
        let mut room = MOST_CONTROLS;
        let mut splines = Vec::with_capacity(lines.len());
        let mut error = 0.0_f64;
        for line in &lines {
            let least = if closed { 0 } else { 2 };
            let Some(most) = room.checked_sub(least).filter(|&most| most > 0) else {
                return Err(out_of_reach);
            };
            let (spline, gap) = if self.through {
                let (spline, parameters) = through::through(line, closed).ok_or(out_of_reach)?;
                let gap = distance(&spline, line, &parameters).largest;
                (spline, gap)
            } else {
                let section = Section { line, closed, tolerance, most, whole };
                let fitted = section.fit(&mut effort).map_err(|_| out_of_reach)?;
                (fitted.spline, fitted.error)
            };
            let taken = spline.pieces.len() + least;
            let Some(left) = room.checked_sub(taken) else { return Err(out_of_reach) };
            room = left;
            error = error.max(gap);
            splines.push(spline);
        }
        let curve = self.joined(splines, whole)?;
        Ok(Found { curve, error })
    }

    /// The closed stretch, or the stretches from corner to corner, from the first corner on.
    fn lines(&self) -> Vec<Polyline> {
        let points = &self.outline.points;
        let count = points.len();
        let Some(&first) = self.corners.first() else {
            let mut ring = points.clone();
            ring.push(points[0]);
            return vec![Polyline::new(ring)];
        };
        let next = self.corners[1..].iter().copied().chain([first + count]);
        let stretch =
            |(from, to): (&usize, usize)| Polyline::new((*from..=to).map(|k| points[k % count]).collect());
        self.corners.iter().zip(next).map(stretch).collect()
    }

    /// One periodic curve over [0, 1] of the stretches, starting at the first point.
    fn joined(&self, splines: Vec<Spline>, whole: f64) -> Result<BSpline, FitError> {
        let closed = self.corners.is_empty();
        let total: f64 = splines.iter().map(|spline| spline.knots.length()).sum();
        debug_assert!(total > 0.0 && whole > 0.0);
        let mut control = Vec::new();
        let mut domain = vec![0.0];
        let mut start = 0.0;
        for spline in &splines {
            let Knots { breaks, .. } = &spline.knots;
            domain.extend(breaks[1..breaks.len() - 1].iter().map(|u| (start + u) / total));
            start += spline.knots.length();
            let times = if closed { 1 } else { 3 };
            domain.extend(std::iter::repeat_n(start / total, times));
            let kept = spline.control.len() - usize::from(!closed);
            control.extend_from_slice(&spline.control[..kept]);
        }
        let end = domain.len() - 1;
        let times = if closed { 1 } else { 3 };
        domain[end + 1 - times..].fill(1.0);
        let curve = if control.len() == 3 {
            // The cubic through three points; one more knot makes it a curve of four.
            let widest =
                (0..3).max_by(|&a, &b| (domain[a + 1] - domain[a]).total_cmp(&(domain[b + 1] - domain[b])));
            let widest = widest.unwrap_or(0);
            let middle = (domain[widest] + domain[widest + 1]) / 2.0;
            let knots = super::knots::extend_periodically(3, &domain);
            BSpline::from_checked(3, Form::Periodic, control, knots).insert_knot(middle)
        } else {
            BSpline::new(3, Form::Periodic, control, Some(domain))
        };
        let curve = curve.map_err(FitError::Curve)?;
        match self.corners.first() {
            Some(&corner) if corner > 0 => self.started(curve),
            _ => Ok(curve),
        }
    }

    /// The same curve with its seam at the first point, which is no corner.
    fn started(&self, curve: BSpline) -> Result<BSpline, FitError> {
        let u = curve.snap(curve.wrap(curve.nearest(self.outline.points[0]).u));
        let count = curve.points().len();
        let has = |curve: &BSpline, u: f64| curve.knots()[3..3 + curve.points().len()].contains(&u);
        let curve = if has(&curve, u) { curve } else { curve.insert_knot(u).map_err(FitError::Curve)? };
        debug_assert!(curve.points().len() <= count + 1);
        let count = curve.points().len();
        let knots = &curve.knots()[3..=3 + count];
        // The last of equal knots, so that the first span is not empty.
        let seam = knots[..count].partition_point(|&knot| knot <= u) - 1;
        let domain = (0..=count).map(|i| {
            let k = seam + i;
            let knot = if k <= count { knots[k] } else { knots[k - count] + 1.0 };
            if i == count { 1.0 } else { knot - u }
        });
        let control = (0..count).map(|i| curve.points()[(seam + i) % count]).collect();
        BSpline::new(3, Form::Periodic, control, Some(domain.collect())).map_err(FitError::Curve)
    }
}
