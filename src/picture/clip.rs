//! Geometry on the screen, cut to a frame round the picture.
//!
//! The coverage of lines is computed in `f32`, which loses the digits of far coordinates, and long dashed lines outside the picture
//! would cost time for nothing. So every line and polygon is cut here, in `f64`, to the picture and a margin wide enough that no
//! cut shows.

use glam::DVec2;

use super::{Path, Viewport};

/// Points nearer than this to the one before are dropped, in pixels: too near to be told apart.
const SAME_POINT: f64 = 1.0 / 64.0;

/// An axis-parallel box in pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frame {
    pub(super) min: DVec2,
    pub(super) max: DVec2,
}

/// A connected part of a line inside a frame.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Piece {
    /// At least two points, in pixels.
    pub(super) points: Vec<DVec2>,
    /// Whether it returns to its first point.
    pub(super) closed: bool,
    /// Length of the line before this piece, in pixels: where the pattern of dashes stands.
    pub(super) start: f64,
}

impl Piece {
    /// A single point.
    pub(super) fn dot(at: DVec2) -> Self {
        Self { points: vec![at, at], closed: false, start: 0.0 }
    }

    /// The points of each side, from the first on.
    pub(super) fn segments(&self) -> impl Iterator<Item = (DVec2, DVec2)> + '_ {
        let last = self.points.last().filter(|_| self.closed).map(|&last| (last, self.points[0]));
        self.points.windows(2).map(|pair| (pair[0], pair[1])).chain(last)
    }
}

impl Frame {
    /// The picture and a margin round it, in device pixels.
    pub(super) fn around(viewport: &Viewport, margin: f64) -> Self {
        let size = DVec2::new(f64::from(viewport.width), f64::from(viewport.height));
        Self { min: DVec2::splat(-margin), max: size + margin }
    }

    pub(super) fn contains(&self, point: DVec2) -> bool {
        point.cmpge(self.min).all() && point.cmple(self.max).all()
    }

    /// Whether the box of the points is apart from the frame, so that nothing of them can show.
    fn misses(&self, points: &[DVec2]) -> bool {
        let low = points.iter().fold(DVec2::INFINITY, |m, &p| m.min(p));
        let high = points.iter().fold(DVec2::NEG_INFINITY, |m, &p| m.max(p));
        low.cmpgt(self.max).any() || high.cmplt(self.min).any()
    }

    /// The part of the segment inside the frame, as parameters from `a` (0) to `b` (1). Method of Liang and Barsky (1984).
    pub(super) fn clip_segment(&self, a: DVec2, b: DVec2) -> Option<(f64, f64)> {
        let (mut low, mut high) = (0.0_f64, 1.0_f64);
        let d = b - a;
        let sides = [
            (-d.x, a.x - self.min.x),
            (d.x, self.max.x - a.x),
            (-d.y, a.y - self.min.y),
            (d.y, self.max.y - a.y),
        ];
        for (speed, room) in sides {
            if speed == 0.0 {
                if room < 0.0 {
                    return None;
                }
            } else if speed < 0.0 {
                low = low.max(room / speed);
            } else {
                high = high.min(room / speed);
            }
        }
        (low < high).then_some((low, high))
    }

    /// The polygon cut to the frame, side by side after Sutherland and Hodgman (1974). Where a cut splits it, the parts stay joined
    /// along the frame, which the even-odd rule does not paint.
    fn clip_ring(&self, ring: Vec<DVec2>) -> Vec<DVec2> {
        if ring.iter().all(|&p| self.contains(p)) {
            return ring;
        }
        let (min, max) = (self.min, self.max);
        let mut ring = ring;
        for (axis, bound, sign) in [(0, min.x, 1.0), (0, max.x, -1.0), (1, min.y, 1.0), (1, max.y, -1.0)] {
            ring = cut(&ring, |p| sign * (p[axis] - bound), |a, b, t| a.lerp(b, t));
        }
        ring
    }

    /// The lines of a path inside the frame. Rings that lie inside stay closed, so that their joins have no bump; a
    /// ring that leaves the frame is walked from a point outside, so that no cut falls inside. With `dashed`, rings start where they
    /// were given, as the dashes do.
    pub(super) fn pieces(&self, path: &Path, viewport: &Viewport, dashed: bool) -> Vec<Piece> {
        let mut pieces = Vec::new();
        for ring in &path.rings {
            let mut points = on_screen(ring, path.closed, viewport);
            if points.len() < 2 || self.misses(&points) {
                continue;
            }
            match points.iter().position(|&p| !self.contains(p)) {
                None => pieces.push(Piece { points, closed: path.closed, start: 0.0 }),
                Some(outside) => {
                    if path.closed {
                        if !dashed {
                            points.rotate_left(outside);
                        }
                        points.push(points[0]);
                    }
                    self.walk(&points, &mut pieces);
                }
            }
        }
        pieces
    }

    /// The rings of a path on the screen, cut to the frame as polygons.
    pub(super) fn polygons(&self, path: &Path, viewport: &Viewport) -> Vec<Vec<DVec2>> {
        path.rings
            .iter()
            .map(|ring| on_screen(ring, true, viewport))
            .filter(|points| points.len() >= 3 && !self.misses(points))
            .map(|points| self.clip_ring(points))
            .filter(|points| points.len() >= 3)
            .collect()
    }

    fn walk(&self, points: &[DVec2], pieces: &mut Vec<Piece>) {
        let mut length = 0.0;
        let mut open: Option<Piece> = None;
        for pair in points.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            let whole = a.distance(b);
            if let Some((low, high)) = self.clip_segment(a, b) {
                let piece = open.get_or_insert_with(|| Piece {
                    points: vec![a.lerp(b, low)],
                    closed: false,
                    start: length + low * whole,
                });
                piece.points.push(a.lerp(b, high));
                if high < 1.0 {
                    pieces.extend(open.take());
                }
            } else {
                pieces.extend(open.take());
            }
            length += whole;
        }
        pieces.extend(open);
    }
}

/// One cut of a polygon: keeps where `height` is not negative. `between(a, b, t)` is the corner a fraction `t` of the way
/// from `a` to `b`; it is always called from the corner nearer to the cut to the farther one, which keeps digits when the other is
/// very far, and gives two polygons that share an edge the same new corner.
pub(super) fn cut<T: Copy>(
    ring: &[T],
    height: impl Fn(&T) -> f64,
    between: impl Fn(T, T, f64) -> T,
) -> Vec<T> {
    let mut kept = Vec::with_capacity(ring.len() + 2);
    let Some(mut previous) = ring.last() else { return kept };
    let mut before = height(previous);
    for corner in ring {
        let now = height(corner);
        if (before < 0.0) != (now < 0.0) {
            // At equal distances the inner corner counts as the nearer one.
            let from_previous = before.abs() < now.abs() || (before.abs() == now.abs() && before > now);
            let (near, far, a, b) =
                if from_previous { (before, now, previous, corner) } else { (now, before, corner, previous) };
            kept.push(between(*a, *b, near / (near - far)));
        }
        if now >= 0.0 {
            kept.push(*corner);
        }
        (previous, before) = (corner, now);
    }
    kept
}

/// The points in pixels, without repetitions; of a ring without the repeated first point.
fn on_screen(ring: &[DVec2], closed: bool, viewport: &Viewport) -> Vec<DVec2> {
    let mut points: Vec<DVec2> = Vec::with_capacity(ring.len() + 1);
    for &point in ring {
        let place = viewport.place(point);
        if points.last().is_none_or(|last| last.distance_squared(place) > SAME_POINT * SAME_POINT) {
            points.push(place);
        }
    }
    while closed
        && points.len() > 1
        && points[0].distance_squared(points[points.len() - 1]) <= SAME_POINT * SAME_POINT
    {
        points.pop();
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Frame = Frame { min: DVec2::ZERO, max: DVec2::new(100.0, 50.0) };
    /// Pixels are units, y down as in `on(x, y)`.
    const VIEW: Viewport =
        Viewport { width: 100, height: 50, center: DVec2::new(50.0, 25.0), scale: 1.0, pixel_ratio: 1.0 };

    fn on(points: &[(f64, f64)]) -> Vec<DVec2> {
        points.iter().map(|&(x, y)| DVec2::new(x, 50.0 - y)).collect()
    }

    fn area(ring: &[DVec2]) -> f64 {
        (0..ring.len()).map(|i| ring[i].perp_dot(ring[(i + 1) % ring.len()])).sum::<f64>() / 2.0
    }

    #[test]
    fn segments() {
        let clip = |a: (f64, f64), b: (f64, f64)| FRAME.clip_segment(a.into(), b.into());
        assert_eq!(clip((10.0, 10.0), (20.0, 20.0)), Some((0.0, 1.0)));
        assert_eq!(clip((-100.0, 25.0), (100.0, 25.0)), Some((0.5, 1.0)));
        assert_eq!(clip((-10.0, 60.0), (110.0, 60.0)), None);
        assert_eq!(clip((-10.0, 20.0), (20.0, -10.0)), Some((1.0 / 3.0, 2.0 / 3.0)));
        assert_eq!(clip((5.0, 5.0), (5.0, 5.0)), Some((0.0, 1.0)));
        assert_eq!(clip((-1e15, 25.0), (1e15, 25.0)).map(|(a, b)| a < b), Some(true));
    }

    #[test]
    fn a_ring_inside_stays_closed_and_loses_its_repeated_point() {
        let path = Path::closed(on(&[(10.0, 10.0), (90.0, 10.0), (50.0, 40.0), (10.0, 10.0)]));
        let pieces = FRAME.pieces(&path, &VIEW, false);
        assert_eq!(pieces.len(), 1);
        assert!(pieces[0].closed);
        assert_eq!(pieces[0].points.len(), 3);
    }

    #[test]
    fn a_ring_that_leaves_is_cut_only_at_the_frame() {
        let path = Path::closed(on(&[(50.0, 10.0), (150.0, 25.0), (50.0, 40.0), (20.0, 25.0)]));
        let pieces = FRAME.pieces(&path, &VIEW, false);
        assert_eq!(pieces.len(), 1);
        let ends = [pieces[0].points[0], *pieces[0].points.last().unwrap()];
        assert!(ends.iter().all(|p| (p.x - 100.0).abs() < 1e-9), "{ends:?}");
        let dashed = FRAME.pieces(&path, &VIEW, true);
        assert_eq!(dashed.len(), 2);
        assert_eq!(dashed[0].start, 0.0);
        assert!(dashed[1].start > 150.0);
    }

    #[test]
    fn polygons_keep_the_area_inside() {
        let square = Path::closed(on(&[(50.0, 10.0), (1e12, 10.0), (1e12, 40.0), (50.0, 40.0)]));
        let cut = FRAME.polygons(&square, &VIEW);
        assert!((area(&cut[0]).abs() - 50.0 * 30.0).abs() < 1e-6);
        let whole = Path::closed(on(&[(-1e9, -1e9), (1e9, -1e9), (1e9, 1e9), (-1e9, 1e9)]));
        assert!((area(&FRAME.polygons(&whole, &VIEW)[0]).abs() - 5000.0).abs() < 1e-6);
        let apart = Path::closed(on(&[(200.0, 0.0), (300.0, 0.0), (200.0, 50.0)]));
        assert!(FRAME.polygons(&apart, &VIEW).is_empty());
    }

    #[test]
    fn neighbours_share_the_corner_of_a_cut() {
        let (a, b) = (DVec2::new(-13.7, 3.1), DVec2::new(41.9, 17.3));
        let above = cut(&[a, b, DVec2::new(0.0, 90.0)], |p| p.x, |a, b, t| a.lerp(b, t));
        let below = cut(&[b, a, DVec2::new(0.0, -90.0)], |p| p.x, |a, b, t| a.lerp(b, t));
        assert_eq!(above.iter().filter(|p| below.contains(p)).count(), 2);
    }
}
