//! One cubic for a run of pieces of a curve, with a bound of its error.

use glam::DVec2;

/// Places on a piece at which a cubic is fitted to it.
const PLACES: [f64; 4] = [0.125, 0.375, 0.625, 0.875];

/// A piece of a curve in Bezier form.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    /// Bezier points; a single one where the curve stands still.
    pub(super) points: Vec<DVec2>,
    /// The curve at the places of a fit.
    at: [DVec2; 4],
}

impl Piece {
    pub(super) fn new(points: Vec<DVec2>) -> Self {
        let at = PLACES.map(|t| point(&points, t));
        Self { points, at }
    }

    fn first(&self) -> DVec2 {
        self.points[0]
    }

    fn last(&self) -> DVec2 {
        self.points[self.points.len() - 1]
    }

    /// The two halves.
    pub(super) fn halves(&self) -> [Self; 2] {
        let mut right = self.points.clone();
        let mut left = Vec::with_capacity(right.len());
        for last in (0..right.len()).rev() {
            left.push(right[0]);
            for i in 0..last {
                right[i] = right[i].midpoint(right[i + 1]);
            }
        }
        [Self::new(left), Self::new(right)]
    }

    /// Mean of the lengths of the chord and of the control polygon: nearly that of the piece.
    pub(super) fn length(&self) -> f64 {
        let polygon: f64 = self.points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        f64::midpoint(polygon, self.first().distance(self.last()))
    }

    /// The piece as a cubic, where it is one.
    pub(super) fn as_cubic(&self) -> Option<[DVec2; 4]> {
        elevated(&self.points, 3).try_into().ok()
    }
}

/// Fits a cubic to a run of pieces, over whose parameters `ends` it runs evenly; returns it with a bound of its distance from
/// the curve, at equal parameters.
///
/// The cubic starts and ends on the curve and leaves and arrives along its tangents; the two lengths left are those of least
/// squares. On each piece the difference is a polynomial, which its Bezier points bound. The bound is infinite where some place
/// shows that it would be above `enough`.
pub(super) fn fit(pieces: &[&Piece], ends: &[f64], enough: f64) -> ([DVec2; 4], f64) {
    let (first, last) = (pieces[0].first(), pieces[pieces.len() - 1].last());
    let (lo, width) = (ends[0], ends[ends.len() - 1] - ends[0]);
    let share = |k: usize| (ends[k] - lo) / width;
    let leave = direction(pieces.iter().flat_map(|piece| piece.points.iter().copied()), first);
    let arrive = direction(pieces.iter().rev().flat_map(|piece| piece.points.iter().rev().copied()), last);
    // Normal equations of the two lengths.
    let (mut aa, mut ab, mut bb, mut ar, mut br) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for (k, piece) in pieces.iter().enumerate() {
        let (from, to) = (share(k), share(k + 1));
        for (t, at) in PLACES.iter().zip(piece.at) {
            let x = from + t * (to - from);
            let y = 1.0 - x;
            let (b1, b2) = (3.0 * y * y * x, 3.0 * y * x * x);
            let rest = at - first * (y * y * y + b1) - last * (x * x * x + b2);
            let weight = to - from;
            aa += weight * b1 * b1 * leave.length_squared();
            ab += weight * b1 * b2 * leave.dot(arrive);
            bb += weight * b2 * b2 * arrive.length_squared();
            ar += weight * b1 * leave.dot(rest);
            br += weight * b2 * arrive.dot(rest);
        }
    }
    let (alpha, beta) = lengths([aa, ab, bb], [ar, br]).unwrap_or((0.0, 0.0));
    let cubic = [first, first + leave * alpha, last + arrive * beta, last];
    let is_off = |(k, piece): (usize, &&Piece)| {
        let (from, to) = (share(k), share(k + 1));
        PLACES.iter().zip(piece.at).any(|(t, at)| point(&cubic, from + t * (to - from)).distance(at) > enough)
    };
    if pieces.iter().enumerate().any(is_off) {
        return (cubic, f64::INFINITY);
    }
    let error = pieces
        .iter()
        .enumerate()
        .map(|(k, piece)| apart(&part(&cubic, share(k), share(k + 1)), &piece.points))
        .fold(0.0, f64::max);
    (cubic, error)
}

/// Unit vector to the first of the points that differs; zero where none does.
fn direction(points: impl Iterator<Item = DVec2>, from: DVec2) -> DVec2 {
    let far = points.map(|point| point - from).find(|way| way.length_squared() > 0.0);
    far.map_or(DVec2::ZERO, DVec2::normalize_or_zero)
}

/// Solves the normal equations for lengths that are not negative; `None` where there is nothing to solve for.
fn lengths([aa, ab, bb]: [f64; 3], [ar, br]: [f64; 2]) -> Option<(f64, f64)> {
    let alone = |square: f64, right: f64| if square > 0.0 { (right / square).max(0.0) } else { 0.0 };
    let determinant = aa * bb - ab * ab;
    if determinant <= 1e-12 * aa * bb || determinant <= 0.0 {
        return (aa + bb > 0.0).then(|| (alone(aa, ar), alone(bb, br)));
    }
    let (alpha, beta) = ((ar * bb - br * ab) / determinant, (br * aa - ar * ab) / determinant);
    Some(match (alpha >= 0.0, beta >= 0.0) {
        (true, true) => (alpha, beta),
        (true, false) => (alone(aa, ar), 0.0),
        (false, _) => (0.0, alone(bb, br)),
    })
}

/// Bezier points of the part of a cubic between two shares.
fn part(cubic: &[DVec2; 4], from: f64, to: f64) -> [DVec2; 4] {
    let [a, b, c, d] = *cubic;
    let at = |r: f64, s: f64, t: f64| {
        let (ab, bc, cd) = (a.lerp(b, r), b.lerp(c, r), c.lerp(d, r));
        ab.lerp(bc, s).lerp(bc.lerp(cd, s), t)
    };
    [at(from, from, from), at(from, from, to), at(from, to, to), at(to, to, to)]
}

/// Bound of the distance of two Bezier curves at equal parameters.
fn apart(a: &[DVec2], b: &[DVec2]) -> f64 {
    let degree = a.len().max(b.len()) - 1;
    let (a, b) = (elevated(a, degree), elevated(b, degree));
    a.iter().zip(b).map(|(p, q)| p.distance(q)).fold(0.0, f64::max)
}

/// The same curve with Bezier points of at least the given degree.
fn elevated(points: &[DVec2], degree: usize) -> Vec<DVec2> {
    let mut elevated = Vec::with_capacity(points.len().max(degree + 1));
    elevated.extend_from_slice(points);
    while elevated.len() <= degree {
        let n = elevated.len();
        elevated.push(elevated[n - 1]);
        for i in (1..n).rev() {
            elevated[i] = elevated[i].lerp(elevated[i - 1], i as f64 / n as f64);
        }
    }
    elevated
}

/// Value of a Bezier curve at t, by de Casteljau's algorithm.
pub(super) fn point(points: &[DVec2], t: f64) -> DVec2 {
    if let &[a, b, c, d] = points {
        let (ab, bc, cd) = (a.lerp(b, t), b.lerp(c, t), c.lerp(d, t));
        return ab.lerp(bc, t).lerp(bc.lerp(cd, t), t);
    }
    let mut row = points.to_vec();
    for last in (1..row.len()).rev() {
        for i in 0..last {
            row[i] = row[i].lerp(row[i + 1], t);
        }
    }
    row[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec2;

    #[test]
    fn elevation_keeps_the_curve() {
        let arch = [dvec2(0.0, 0.0), dvec2(1.0, 3.0), dvec2(4.0, 1.0)];
        for degree in [3, 5, 9] {
            let more = elevated(&arch, degree);
            assert_eq!(more.len(), degree + 1);
            for t in [0.0, 0.3, 0.8, 1.0] {
                assert!(point(&more, t).distance(point(&arch, t)) < 1e-13);
            }
        }
        assert_eq!(elevated(&[DVec2::X], 3), [DVec2::X; 4], "a place where the curve stands still");
    }

    #[test]
    fn a_cubic_in_pieces_is_found_again() {
        let whole = [dvec2(0.0, 0.0), dvec2(2.0, 4.0), dvec2(5.0, 4.0), dvec2(6.0, 1.0)];
        let ends = [0.0, 0.2, 0.55, 1.0];
        let pieces: Vec<_> =
            ends.windows(2).map(|pair| Piece::new(part(&whole, pair[0], pair[1]).to_vec())).collect();
        let (cubic, error) = fit(&pieces.iter().collect::<Vec<_>>(), &ends, 1.0);
        assert!(error < 1e-12, "{error}");
        assert!(cubic.iter().zip(whole).all(|(p, q)| p.distance(q) < 1e-12));
    }

    /// The bound is never below what dense samples attain, and not far above.
    #[test]
    fn the_bound_holds() {
        let wave = |t: f64| dvec2(t, (3.0 * t).sin());
        // Pieces of degree six through the wave are not needed: any polynomial pieces will do.
        let pieces: Vec<_> = (0..4)
            .map(|k| {
                let at = |i: usize| wave((f64::from(k) + i as f64 / 6.0) / 4.0);
                Piece::new((0..=6).map(at).collect())
            })
            .collect();
        let ends = [0.0, 0.25, 0.5, 0.75, 1.0];
        let (cubic, error) = fit(&pieces.iter().collect::<Vec<_>>(), &ends, 1.0);
        let mut attained = 0.0_f64;
        for (k, piece) in pieces.iter().enumerate() {
            for i in 0..=200 {
                let t = f64::from(i) / 200.0;
                let x = (k as f64 + t) / 4.0;
                attained = attained.max(point(&piece.points, t).distance(point(&cubic, x)));
            }
        }
        assert!(attained <= error && error < 2.5 * attained, "{attained} {error}");
    }
}
