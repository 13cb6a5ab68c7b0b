//! Knot vectors: the uniform ones, and the checks of given ones.

use super::error::CurveError;

/// Largest absolute value of a knot; beyond it derivatives would lose their range.
const LARGEST: f64 = 1e12;
/// Shortest domain; below it derivatives by the parameter would overflow.
const SHORTEST_DOMAIN: f64 = 1e-12;
/// Largest knot relative to the domain: the rounding error of a parameter stays below 1e-9 of the domain.
const LARGEST_RELATIVE: f64 = 1e6;
/// Largest departure from exact periodicity that is put right in silence, relative to the period.
const PERIOD_TOLERANCE: f64 = 1e-9;

/// Distance below which two parameters count as one: a knot span shorter than this is empty.
///
/// 1e-10 of the domain, plus a few rounding errors. Much larger would merge knots that somebody meant to be
/// apart; much smaller leaves spans whose tangents are rounding noise.
pub(super) fn merging_distance(lo: f64, hi: f64) -> f64 {
    1e-10 * (hi - lo) + 1e-15 * lo.abs().max(hi.abs())
}

/// Uniform knots of a periodic curve with `count` points; domain [0, 1].
pub(super) fn uniform_periodic(degree: usize, count: usize) -> Vec<f64> {
    let n = count as f64;
    (0..=count + 2 * degree).map(|i| (i as f64 - degree as f64) / n).collect()
}

/// Uniform knots of a clamped curve with `count` points; domain [0, 1].
pub(super) fn uniform_clamped(degree: usize, count: usize) -> Vec<f64> {
    let spans = count - degree;
    (0..=count + degree).map(|i| i.saturating_sub(degree).min(spans) as f64 / spans as f64).collect()
}

/// Checks the knots of a periodic curve with `count` points, given in full or for the domain alone, merges
/// knots that are nearly equal and returns the full vector, exactly periodic up to rounding.
///
/// `count` is larger than the degree.
pub(super) fn periodic(degree: usize, count: usize, given: &[f64]) -> Result<Vec<f64>, CurveError> {
    let full = count + 2 * degree + 1;
    let start = match given.len() {
        n if n == full => degree,
        n if n == count + 1 => 0,
        n => return Err(CurveError::KnotCount { count: n, full, domain: Some(count + 1) }),
    };
    check_ascending(given)?;
    let (lo, hi) = (given[start], given[start + count]);
    check_domain(lo, hi, given)?;
    let period = hi - lo;
    for (index, &value) in given.iter().enumerate() {
        let expected = if index < start {
            given[index + count] - period
        } else if index > start + count {
            given[index - count] + period
        } else {
            continue;
        };
        if (value - expected).abs() > PERIOD_TOLERANCE * period + merging_distance(lo, hi) {
            return Err(CurveError::KnotsNotPeriodic { index, value, expected });
        }
    }
    let domain = merge(&given[start..=start + count]);
    let closing = domain.iter().filter(|&&u| u == hi).count() - 1;
    for (first, value, run) in runs(&domain) {
        let multiplicity = if value == lo { run + closing } else { run };
        if multiplicity > degree && value != hi {
            let index = first + start;
            return Err(CurveError::Multiplicity { index, value, multiplicity, limit: degree });
        }
    }
    Ok(extend_periodically(degree, &domain))
}

/// Continues the knots of a domain by `degree` knots on each side; they are more than `degree` + 1.
pub(super) fn extend_periodically(degree: usize, domain: &[f64]) -> Vec<f64> {
    let count = domain.len() - 1;
    let period = domain[count] - domain[0];
    let before = domain[count - degree..count].iter().map(|u| u - period);
    let after = domain[1..=degree].iter().map(|u| u + period);
    before.chain(domain.iter().copied()).chain(after).collect()
}

/// Checks the knots of a clamped curve with `count` points, merges knots that are nearly equal and returns them.
pub(super) fn clamped(degree: usize, count: usize, given: &[f64]) -> Result<Vec<f64>, CurveError> {
    let full = count + degree + 1;
    if given.len() != full {
        return Err(CurveError::KnotCount { count: given.len(), full, domain: None });
    }
    check_ascending(given)?;
    let (lo, hi) = (given[degree], given[count]);
    check_domain(lo, hi, given)?;
    for (index, &value) in given.iter().enumerate() {
        let expected = if index <= degree { lo } else { hi };
        if (index <= degree || index >= count) && value != expected {
            return Err(CurveError::KnotsNotClamped { index, value, expected });
        }
    }
    let knots = merge(given);
    for (index, value, multiplicity) in runs(&knots) {
        let limit = if value == lo || value == hi { degree + 1 } else { degree };
        if multiplicity > limit {
            return Err(CurveError::Multiplicity { index, value, multiplicity, limit });
        }
    }
    Ok(knots)
}

fn check_ascending(knots: &[f64]) -> Result<(), CurveError> {
    for (index, &value) in knots.iter().enumerate() {
        if value.is_nan() || value.abs() > LARGEST {
            return Err(CurveError::KnotNotFinite { index, value, limit: LARGEST });
        }
        if index > 0 && value < knots[index - 1] {
            return Err(CurveError::KnotsDecrease { index, previous: knots[index - 1], value });
        }
    }
    Ok(())
}

fn check_domain(lo: f64, hi: f64, knots: &[f64]) -> Result<(), CurveError> {
    let largest = knots.iter().fold(0.0_f64, |m, u| m.max(u.abs()));
    let needed = SHORTEST_DOMAIN.max(largest / LARGEST_RELATIVE);
    if hi - lo < needed { Err(CurveError::EmptyDomain { lo, hi, needed }) } else { Ok(()) }
}

/// Sets knots that lie within the merging distance of an earlier one equal to it; the two ends stay.
fn merge(knots: &[f64]) -> Vec<f64> {
    let (lo, hi) = (knots[0], knots[knots.len() - 1]);
    let distance = merging_distance(lo, hi);
    let mut anchor = lo;
    let mut nearby = |u: f64| {
        if hi - u <= distance {
            anchor = hi;
        } else if u - anchor > distance {
            anchor = u;
        }
        anchor
    };
    knots.iter().map(|&u| nearby(u)).collect()
}

/// Runs of equal knots: index of the first, value, length.
fn runs(knots: &[f64]) -> impl Iterator<Item = (usize, f64, usize)> + '_ {
    let mut first = 0;
    knots.chunk_by(|a, b| a == b).map(move |run| {
        let index = first;
        first += run.len();
        (index, run[0], run.len())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn uniform_vectors_have_the_unit_domain() {
        let knots = uniform_periodic(3, 5);
        assert_eq!((knots.len(), knots[3], knots[8]), (12, 0.0, 1.0));
        assert_eq!(uniform_clamped(2, 4), [0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0]);
    }

    #[test]
    fn the_domain_alone_gives_the_full_vector() {
        let full = periodic(2, 4, &[0.0, 1.0, 1.5, 3.0, 4.0]).unwrap();
        assert_eq!(full, [-2.5, -1.0, 0.0, 1.0, 1.5, 3.0, 4.0, 5.0, 5.5]);
        assert_eq!(periodic(2, 4, &full).unwrap(), full);
    }

    #[test]
    fn nearly_equal_knots_become_equal() {
        let knots = clamped(2, 5, &[0.0, 0.0, 0.0, 0.5, 0.5 + 1e-13, 1.0, 1.0, 1.0]).unwrap();
        assert_eq!(knots[4], 0.5);
        let knots = periodic(2, 4, &[0.0, 1e-14, 0.5, 1.0 - 1e-14, 1.0]);
        assert_eq!(knots, Err(CurveError::Multiplicity { index: 0, value: 0.0, multiplicity: 3, limit: 2 }));
    }

    #[test]
    fn a_knot_that_breaks_the_period_is_named() {
        let mut knots = uniform_periodic(3, 5);
        knots[10] += 0.01;
        assert!(matches!(periodic(3, 5, &knots), Err(CurveError::KnotsNotPeriodic { index: 10, .. })));
    }
}
