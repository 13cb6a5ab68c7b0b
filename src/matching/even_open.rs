//! Lines evenly spread along a correspondence of open curves.

use super::even::{LEAST_STEP, ascends, at_even_means, make_ascending};

/// Places `count` lines at equal steps of mu along a correspondence of open curves, as [`spread_evenly`](super::even::spread_evenly) does round closed
/// ones, from its first place to its last one, which stay; there are no lines where these do not move on strictly.
pub(super) fn spread_between(
    places: &[[f64; 2]],
    count: usize,
    mut improve: impl FnMut([f64; 2]) -> f64,
) -> Vec<[f64; 2]> {
    let [first, .., last] = places else { return Vec::new() };
    if !ascends(&[*first, *last], false) {
        return Vec::new();
    }
    let plain = at_even_means(places, false, count);
    let moved: Vec<[f64; 2]> = plain
        .iter()
        .enumerate()
        .map(|(k, &[x, y])| {
            let by = if k == 0 || k + 1 == count { 0.0 } else { improve([x, y]) };
            [x + by, y - by]
        })
        .collect();
    let spread = [strictly(&moved), strictly(&plain)].into_iter().find(|places| ascends(places, false));
    spread.unwrap_or_else(|| {
        // Any correspondence becomes strict when it is mixed with the rigid one.
        let offset = |[x, y]: [f64; 2]| x - y;
        let (first, last) = (offset(plain[0]), offset(plain[count - 1]));
        let mix = |(k, &[x, y]): (usize, &[f64; 2])| {
            let rigid = first + (last - first) * k as f64 / (count - 1) as f64;
            let by = LEAST_STEP * (rigid - (x - y)) / 2.0;
            [x + by, y - by]
        };
        plain.iter().enumerate().map(mix).collect()
    })
}

/// Moves lines along their anti-diagonals, as little as possible by least squares, until both ends ascend strictly; the first and the
/// last line stay.
fn strictly(places: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut line = places.to_vec();
    for curve in 0..2 {
        let even: Vec<f64> = line.iter().map(|[x, y]| LEAST_STEP * (x + y) / 2.0).collect();
        let mut rest: Vec<f64> = line.iter().zip(&even).map(|(place, even)| place[curve] - even).collect();
        if let [first, .., last] = rest.as_slice() {
            let (first, last) = (*first, *last);
            rest.iter_mut().for_each(|rest| *rest = rest.min(last).max(first));
        }
        make_ascending(&mut rest);
        for ((place, rest), even) in line.iter_mut().zip(rest).zip(even) {
            let by = rest + even - place[curve];
            place[curve] += by;
            place[1 - curve] -= by;
        }
    }
    if let ([first, .., last], [start, .., end]) = (line.as_mut_slice(), places) {
        (*first, *last) = (*start, *end);
    }
    line
}
