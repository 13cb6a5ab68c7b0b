//! The way round a band cut where either curve, or what runs along it, is not smooth.

use crate::curve::BSpline;

/// Cuts nearer to each other than this, as a share of the way between two lines, are one.
const SAME_CUT: f64 = 1e-12;

/// Parameters (u, v) at the start and at the end of a part.
pub(super) type Cut = ((f64, f64), (f64, f64));

/// Cuts the way round at every line, at every knot of either curve, and at the parameters `more` of either, so that both curves are
/// polynomials in between.
///
/// `places` are the parameters of the ends of the lines, in cyclic order and ascending beyond the ends of the domains; so are those of
/// the parts.
pub(super) fn cuts(curves: &[BSpline; 2], places: &[(f64, f64)], more: [&[f64]; 2]) -> Vec<Cut> {
    let Some(&(u, v)) = places.first() else { return Vec::new() };
    let periods = curves.each_ref().map(|curve| curve.domain().1 - curve.domain().0);
    let marks = [curves[0].marks_from(u, more[0]), curves[1].marks_from(v, more[1])];
    let lap = curves[0].is_closed().then_some((u + periods[0], v + periods[1]));
    let next = places.iter().copied().skip(1).chain(lap);
    let mut cuts = Vec::new();
    let mut passed = [0, 0];
    for (&(u0, v0), (u1, v1)) in places.iter().zip(next) {
        let mut shares = vec![1.0];
        for (curve, (lo, hi)) in [(u0, u1), (v0, v1)].into_iter().enumerate() {
            while let Some(&mark) = marks[curve].get(passed[curve]).filter(|&&mark| mark < hi) {
                shares.push((mark - lo) / (hi - lo));
                passed[curve] += 1;
            }
        }
        shares.sort_by(f64::total_cmp);
        let mut reached = 0.0;
        for (i, &share) in shares.iter().enumerate() {
            // A cut beside the next one, or beside the line itself, is that one.
            let ahead = shares.get(i + 1).map_or(f64::INFINITY, |next| next - share);
            if share - reached <= SAME_CUT || ahead <= SAME_CUT {
                continue;
            }
            let at = |t: f64| (u0 + t * (u1 - u0), v0 + t * (v1 - v0));
            cuts.push((at(reached), if share < 1.0 { at(share) } else { (u1, v1) }));
            reached = share;
        }
    }
    cuts
}
