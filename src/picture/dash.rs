//! Dashes: the stretches of a line that are drawn.
//!
//! A dash that goes round a corner is drawn as two stretches joined by a disc, which shows whole where the dash is shorter than its width.

use std::ops::Range;

use glam::DVec2;

use super::clip::Piece;

/// A straight part of a line, in pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Stretch {
    pub(super) from: DVec2,
    pub(super) to: DVec2,
    /// Whether start and end are cut straight across; else they are round.
    pub(super) is_cut: [bool; 2],
}

impl Stretch {
    /// With round ends, which join it to others.
    pub(super) fn round(from: DVec2, to: DVec2) -> Self {
        Self { from, to, is_cut: [false; 2] }
    }
}

/// Hands on the dashes of a line, each cut at its ends and joined round at the corners of the line, as far as they come
/// between two heights. Lengths of dash and gap are in pixels, the gap positive; the pattern starts where the line does.
pub(super) fn dashes(piece: &Piece, [on, off]: [f64; 2], heights: Range<f64>, mut draw: impl FnMut(Stretch)) {
    let period = on + off;
    let sides = piece.points.len() - usize::from(!piece.closed);
    // How far the pattern has come at the start of a side.
    let mut begun = piece.start % period;
    for (side, (a, b)) in piece.segments().enumerate() {
        let length = a.distance(b);
        let (low, high) = between(a.y, b.y, &heights);
        let first = ((begun + low * length) / period).floor();
        let mut start = first * period - begun;
        while start < high * length {
            let end = start + on;
            let (from, to) = (start.max(0.0), end.min(length));
            if from < to && end > low * length {
                let is_cut = [start >= 0.0 || side == 0, end <= length || side + 1 == sides];
                draw(Stretch { from: a.lerp(b, from / length), to: a.lerp(b, to / length), is_cut });
            }
            start += period;
        }
        begun = (begun + length) % period;
    }
}

/// The part of the way from `a` to `b` that lies between two heights, as shares from 0 to 1; empty when none does.
fn between(a: f64, b: f64, heights: &Range<f64>) -> (f64, f64) {
    let share = |height: f64| ((height - a) / (b - a)).clamp(0.0, 1.0);
    if a == b {
        (0.0, if heights.contains(&a) { 1.0 } else { 0.0 })
    } else if a < b {
        (share(heights.start), share(heights.end))
    } else {
        (share(heights.end), share(heights.start))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: Range<f64> = f64::NEG_INFINITY..f64::INFINITY;

    fn found(piece: &Piece, pattern: [f64; 2], heights: Range<f64>) -> Vec<Stretch> {
        let mut found = Vec::new();
        dashes(piece, pattern, heights, |stretch| found.push(stretch));
        found
    }

    fn corner() -> Piece {
        let points = vec![DVec2::ZERO, DVec2::new(10.0, 0.0), DVec2::new(10.0, 9.0)];
        Piece { points, closed: false, start: 0.0 }
    }

    #[test]
    fn dashes_go_round_corners_and_end_with_the_line() {
        let stretch =
            |from: (f64, f64), to: (f64, f64), is_cut| Stretch { from: from.into(), to: to.into(), is_cut };
        assert_eq!(
            found(&corner(), [4.0, 3.0], ALL),
            [
                stretch((0.0, 0.0), (4.0, 0.0), [true, true]),
                stretch((7.0, 0.0), (10.0, 0.0), [true, false]),
                stretch((10.0, 0.0), (10.0, 1.0), [false, true]),
                stretch((10.0, 4.0), (10.0, 8.0), [true, true]),
            ]
        );
    }

    /// The drawn length is what a sum over the whole length gives, wherever the pattern starts.
    #[test]
    fn the_drawn_share_is_that_of_the_pattern() {
        let points: Vec<DVec2> =
            (0..40).map(|k| DVec2::from_angle(f64::from(k) * 0.157) * (20.0 + f64::from(k % 3))).collect();
        for start in [0.0, 1.0, 5.7, 1e6 + 0.25] {
            let piece = Piece { points: points.clone(), closed: true, start };
            let whole: f64 = piece.segments().map(|(a, b)| a.distance(b)).sum();
            let drawn: f64 = found(&piece, [2.0, 4.0], ALL).iter().map(|s| s.from.distance(s.to)).sum();
            let steps = 1_000_000;
            let on =
                (0..steps).filter(|k| (start + whole * (f64::from(*k) + 0.5) / f64::from(steps)) % 6.0 < 2.0);
            let expected = whole * on.count() as f64 / f64::from(steps);
            assert!((drawn - expected).abs() < 1e-3, "{start}: {drawn}, expected {expected}");
        }
    }

    #[test]
    fn dashes_outside_the_heights_are_left_out() {
        let all = found(&corner(), [4.0, 3.0], ALL);
        assert_eq!(found(&corner(), [4.0, 3.0], -1.0..0.5), all[..3]);
        assert_eq!(found(&corner(), [4.0, 3.0], 6.0..7.0), all[3..]);
        assert_eq!(found(&corner(), [4.0, 3.0], 20.0..30.0), []);
    }
}
