//! The two curves of a band as paths with the same commands.
//!
//! Where the matching joins a point of the first curve to one of the second, both paths are at the same share of the same
//! command. So whoever blends the numbers of the two paths evenly, as `animate` of SVG and transitions of CSS do, gets the
//! in-between curves of the band.

mod cubic;
mod error;

use super::cuts::cuts;
use crate::curve::BSpline;
use crate::geom::Bounds;
use cubic::{Piece, fit};
pub use error::PathError;
use glam::DVec2;
use std::fmt::Write;

/// Smallest tolerance, as a share of the diagonal of the box of both curves.
pub const SMALLEST_TOLERANCE: f64 = 1e-9;
/// Most commands of a path.
const MOST_COMMANDS: usize = 10_000;
/// Largest part of the way round that one command takes.
const LONGEST: f64 = 0.25;
/// Part of the tolerance that the fit may use; the rest is left to the digits of the numbers that are written.
const OF_THE_FIT: f64 = 0.95;

/// Two paths of cubics: closed ones, counter-clockwise with y up, or open ones.
#[derive(Debug, Clone, PartialEq)]
pub struct PathPair {
    /// Of each curve: the point that starts the path, then for each command its two handles and its end; the last end of
    /// a closed path is its start.
    pub points: [Vec<DVec2>; 2],
    /// Of each command, the parameters (u, v) at its middle, ascending beyond the ends of the domains.
    pub middles: Vec<(f64, f64)>,
    /// Bound of the distance of either path from its curve, at places that the matching joins; so of any even blend of the two
    /// from the in-between curve as well.
    pub error: f64,
    /// Number of decimals with which the tolerance holds for the text of the paths.
    pub decimals: usize,
    /// Whether the paths are closed.
    pub closed: bool,
}

impl PathPair {
    /// Number of commands of either path, all of which are cubics.
    #[must_use]
    pub fn commands(&self) -> usize {
        self.middles.len()
    }

    /// Box of all points and handles, which holds both paths and every blend of them.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        let [first, second] = &self.points;
        Bounds::around(first[0], first[1..].iter().chain(second).copied())
    }

    /// The paths as SVG writes them: y down, one `M`, the cubics, and `Z` where they are closed; and a bound of the distance from the curves, which
    /// counts the digits that are left out.
    #[must_use]
    pub fn svg(&self) -> ([String; 2], f64) {
        let unit = 10.0_f64.powi(-(self.decimals as i32));
        (
            self.points.each_ref().map(|points| written(points, self.decimals, self.closed)),
            self.error + unit * 0.5_f64.sqrt(),
        )
    }
}

/// A stretch between two neighbouring cuts: parameters at its ends, and the pieces of both curves.
#[derive(Debug, Clone)]
struct Stretch {
    from: (f64, f64),
    to: (f64, f64),
    pieces: [Piece; 2],
}

/// The paths of two matched curves; `places` are the parameters of the ends of the lines, in cyclic order and ascending beyond the
/// ends of the domains. Commands end at lines or at knots; there are as few of them as the tolerance allows.
///
/// With curves of degree 2 and 3 any tolerance is reached, since between two cuts they are cubics themselves.
///
/// # Errors
/// When the tolerance is not a number from [`SMALLEST_TOLERANCE`] to 1 times the diagonal of the box of both curves, or takes too
/// many commands.
pub fn path_pair(
    curves: &[BSpline; 2],
    places: &[(f64, f64)],
    tolerance: f64,
) -> Result<PathPair, PathError> {
    let bounds = curves[0].bounds().union(curves[1].bounds());
    let diagonal = (bounds.max - bounds.min).length();
    let least = SMALLEST_TOLERANCE * diagonal;
    if !(least..=diagonal).contains(&tolerance) {
        return Err(PathError::Tolerance { tolerance, least, most: diagonal });
    }
    let fine = OF_THE_FIT * tolerance;
    let origin = bounds.min.midpoint(bounds.max);
    let stretches = refined(stretches(curves, places, origin), fine)
        .ok_or(PathError::OutOfReach { tolerance, limit: MOST_COMMANDS })?;
    let ends = ends(&stretches);
    let mut pair = PathPair {
        points: [0, 1]
            .map(|curve| vec![stretches.first().map_or(origin, |s| s.pieces[curve].points[0] + origin)]),
        middles: Vec::new(),
        error: 0.0,
        decimals: decimals(tolerance),
        closed: curves[0].is_closed(),
    };
    let mut start = 0;
    while start < stretches.len() {
        let run = longest_run(&stretches, &ends, start, fine);
        for (points, cubic) in pair.points.iter_mut().zip(run.cubics) {
            points.extend(cubic[1..].iter().map(|&point| point + origin));
        }
        let (from, to) = (stretches[start].from, stretches[run.end - 1].to);
        pair.middles.push((f64::midpoint(from.0, to.0), f64::midpoint(from.1, to.1)));
        pair.error = pair.error.max(run.error);
        start = run.end;
    }
    if pair.commands() > MOST_COMMANDS {
        return Err(PathError::OutOfReach { tolerance, limit: MOST_COMMANDS });
    }
    for points in pair.points.iter_mut().filter(|_| pair.closed) {
        let first = points[0];
        if let Some(last) = points.last_mut() {
            *last = first;
        }
    }
    Ok(pair)
}

/// Decimals whose rounding, on either axis, is at most a fortieth of the tolerance.
fn decimals(tolerance: f64) -> usize {
    (20.0 / tolerance).log10().ceil().clamp(0.0, 20.0) as usize
}

/// The stretches between the lines and the knots of either curve, on which both are polynomials.
fn stretches(curves: &[BSpline; 2], places: &[(f64, f64)], origin: DVec2) -> Vec<Stretch> {
    let cuts = cuts(curves, places, [&[], &[]]);
    let ends = [
        cuts.iter().map(|&((from, _), (to, _))| (from, to)).collect::<Vec<_>>(),
        cuts.iter().map(|&((_, from), (_, to))| (from, to)).collect(),
    ];
    let first = curves[0].stretches(&ends[0], origin);
    let second = curves[1].stretches(&ends[1], origin);
    let pieces = first.into_iter().zip(second).map(|(a, b)| [a, b].map(Piece::new));
    cuts.iter().zip(pieces).map(|(&(from, to), pieces)| Stretch { from, to, pieces }).collect()
}

/// Halves stretches of a high degree until each has cubics within the tolerance; `None` when that takes too many.
fn refined(stretches: Vec<Stretch>, tolerance: f64) -> Option<Vec<Stretch>> {
    let mut fine = Vec::with_capacity(stretches.len());
    let mut open: Vec<Stretch> = stretches.into_iter().rev().collect();
    while let Some(stretch) = open.pop() {
        if single(&stretch, tolerance).error <= tolerance {
            fine.push(stretch);
            continue;
        }
        if fine.len() + open.len() > 2 * MOST_COMMANDS {
            return None;
        }
        let Stretch { from, to, pieces } = stretch;
        let middle = (f64::midpoint(from.0, to.0), f64::midpoint(from.1, to.1));
        let [[a, b], [c, d]] = pieces.map(|piece| piece.halves());
        open.push(Stretch { from: middle, to, pieces: [b, d] });
        open.push(Stretch { from, to: middle, pieces: [a, c] });
    }
    Some(fine)
}

/// The common parameter at every cut: the mean of both lengths as shares of their sums, from 0 to 1.
fn ends(stretches: &[Stretch]) -> Vec<f64> {
    let lengths: Vec<[f64; 2]> =
        stretches.iter().map(|stretch| stretch.pieces.each_ref().map(Piece::length)).collect();
    let whole =
        [0, 1].map(|curve| lengths.iter().map(|pair| pair[curve]).sum::<f64>().max(f64::MIN_POSITIVE));
    let mut ends = vec![0.0];
    for pair in &lengths {
        // Where a stretch is below all measure, it still has a length, so that no share is the quotient of two zeros.
        let step = (pair[0] / whole[0] + pair[1] / whole[1]) / 2.0;
        ends.push(ends[ends.len() - 1] + step.max(1e-15));
    }
    ends
}

/// A run of stretches and its cubic on either curve.
#[derive(Debug)]
struct Run {
    /// Index of the stretch after it.
    end: usize,
    cubics: [[DVec2; 4]; 2],
    error: f64,
}

/// The cubics of one stretch: the curves themselves where they are cubics.
fn single(stretch: &Stretch, tolerance: f64) -> Run {
    let cubics = stretch.pieces.each_ref().map(|piece| match piece.as_cubic() {
        Some(cubic) => (cubic, 0.0),
        None => fit(&[piece], &[0.0, 1.0], tolerance),
    });
    Run { end: 0, error: cubics[0].1.max(cubics[1].1), cubics: cubics.map(|(cubic, _)| cubic) }
}

/// The longest run of stretches from `start` that has cubics within the tolerance, found by doubling and bisection.
fn longest_run(stretches: &[Stretch], ends: &[f64], start: usize, tolerance: f64) -> Run {
    let mut best = Run { end: start + 1, ..single(&stretches[start], tolerance) };
    let reach = ends[start] + LONGEST * ends[ends.len() - 1];
    let most = ends.partition_point(|&end| end <= reach).saturating_sub(1).max(start + 1);
    let attempt = |end: usize| {
        let run = &stretches[start..end];
        let cubics = [0, 1].map(|curve| {
            let pieces: Vec<&Piece> = run.iter().map(|stretch| &stretch.pieces[curve]).collect();
            fit(&pieces, &ends[start..=end], tolerance)
        });
        let error = cubics[0].1.max(cubics[1].1);
        (error <= tolerance).then(|| Run { end, error, cubics: cubics.map(|(cubic, _)| cubic) })
    };
    let mut failed = most + 1;
    let mut step = 1;
    while best.end < most {
        let end = (start + 2 * step).min(most);
        match attempt(end) {
            Some(run) => best = run,
            None => {
                failed = end;
                break;
            }
        }
        step *= 2;
    }
    while failed - best.end > 1 && failed <= most {
        let middle = usize::midpoint(best.end, failed);
        match attempt(middle) {
            Some(run) => best = run,
            None => failed = middle,
        }
    }
    best
}

/// A path with y down.
fn written(points: &[DVec2], decimals: usize, closed: bool) -> String {
    let mut text = String::new();
    for (k, point) in points.iter().enumerate() {
        text.push_str(match k {
            0 => "M",
            _ if k % 3 == 1 => "C",
            _ => " ",
        });
        number(&mut text, point.x, decimals);
        text.push(' ');
        number(&mut text, -point.y, decimals);
    }
    if closed {
        text.push('Z');
    }
    text
}

/// Writes a number without zeros at its end.
fn number(text: &mut String, value: f64, decimals: usize) {
    let start = text.len();
    // Writing to a string does not fail.
    let _ = write!(text, "{value:.decimals$}");
    if decimals > 0 {
        let kept = text.trim_end_matches('0').trim_end_matches('.').len();
        text.truncate(kept.max(start + 1));
    }
    if &text[start..] == "-0" {
        text.truncate(start);
        text.push('0');
    }
}

#[cfg(test)]
mod tests;
