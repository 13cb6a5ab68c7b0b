//! Lines evenly spread along a correspondence.

use super::spacing::APART;

/// Least share of its even step by which an end moves on from one line to the next: spreads fans a little, so that no two
/// lines share an end.
pub(super) const LEAST_STEP: f64 = 1.0 / 128.0;

/// Places `count` lines at equal steps of mu, the mean of the shares of arc length on both curves, along a correspondence.
///
/// `places` are ends in shares of arc length on both curves once round, weakly ascending, not all the same. `improve` may
/// move a line along its anti-diagonal: it gets the two ends and returns how much to add to the first and take
/// from the second. The places returned ascend strictly on both curves, within one lap: where many lines of
/// the correspondence share an end (a fan), their ends are drawn apart by the least squares of moves, and no end passes a corner, whose shares of
/// arc length `corners` holds.
pub(super) fn spread_evenly(
    places: &[[f64; 2]],
    count: usize,
    corners: &[Vec<f64>; 2],
    mut improve: impl FnMut([f64; 2]) -> f64,
) -> Vec<[f64; 2]> {
    let plain = at_even_means(places, true, count);
    let moved: Vec<[f64; 2]> = plain
        .iter()
        .map(|&[x, y]| {
            let by = improve([x, y]);
            [x + by, y - by]
        })
        .collect();
    let tries = [(&moved, true), (&plain, true), (&plain, false)];
    let mut tries = tries.map(|(places, keeps)| {
        let corners = if keeps { corners.each_ref().map(Vec::as_slice) } else { [[].as_slice(); 2] };
        strictly(places, corners)
    });
    tries.iter_mut().find(|places| ascends(places, true)).map(std::mem::take).unwrap_or_else(|| {
        // Any correspondence becomes strict when it is mixed with the rigid one.
        let offset = plain.iter().map(|[x, y]| x - y).sum::<f64>() / count as f64;
        let mix = |&[x, y]: &[f64; 2]| {
            let by = LEAST_STEP * (offset - (x - y)) / 2.0;
            [x + by, y - by]
        };
        plain.iter().map(mix).collect()
    })
}

/// Puts places that must be held among evenly spread ones: the nearest to each makes way, and so does every one that would be out
/// of order, or with one end so near that it could not be told from the held one.
///
/// Both lists ascend in cyclic order, within a lap: `places` strictly; those that are held may share an end, and then still do. On open
/// curves the first and the last of the places stay as well.
pub fn hold_places(places: &mut Vec<[f64; 2]>, closed: bool, held: &[[f64; 2]]) {
    let mut kept: Vec<[f64; 2]> = Vec::with_capacity(held.len() + 2);
    if let (false, [first, .., last]) = (closed, places.as_slice()) {
        kept.extend([*first, *last]);
    }
    let translates: &[f64] = if closed { &[-1.0, 0.0, 1.0] } else { &[0.0] };
    let least = LEAST_STEP / (2 * places.len().max(1)) as f64;
    let laps = |by: f64| move |place: &[f64; 2]| place.map(|share| share + by);
    for pin in held {
        let mean = |place: &[f64; 2]| (place[0] + place[1]) / 2.0;
        // The translate of the pin that lies among the places.
        let Some(first) = places.first().map(mean) else { return };
        let pin = if closed { laps((first - mean(pin)).ceil())(pin) } else { *pin };
        if kept.contains(&pin) {
            continue;
        }
        let distance = |place: &[f64; 2]| {
            let gap = (mean(place) - mean(&pin)).abs();
            if closed { gap.min(1.0 - gap) } else { gap }
        };
        let others = (0..places.len()).filter(|&k| !kept.contains(&places[k]));
        let nearest = others.min_by(|&i, &k| distance(&places[i]).total_cmp(&distance(&places[k])));
        if let Some(nearest) = nearest {
            places.remove(nearest);
        }
        let fits = |place: &[f64; 2]| {
            translates.iter().all(|&lap| {
                let [x, y] = laps(lap)(place);
                let [before, after] = [[pin[0] - x, pin[1] - y], [x - pin[0], y - pin[1]]];
                before.iter().all(|&step| step > least) || after.iter().all(|&step| step > least)
            })
        };
        places.retain(|place| kept.contains(place) || fits(place));
        let at = places.partition_point(|place| mean(place) < mean(&pin));
        places.insert(at, pin);
        kept.push(pin);
    }
}

/// Whether places ascend strictly on both curves and, on closed ones, keep within a lap.
pub(super) fn ascends(places: &[[f64; 2]], closed: bool) -> bool {
    let lap = places.first().filter(|_| closed).map(|[x, y]| [x + 1.0, y + 1.0]);
    let next = places.iter().copied().skip(1).chain(lap);
    places.iter().zip(next).all(|([x, y], [u, v])| *x < u && *y < v)
}

/// Points of the piecewise straight correspondence at equal steps of mu from its first place on, of open curves to its last one.
pub(super) fn at_even_means(places: &[[f64; 2]], closed: bool, count: usize) -> Vec<[f64; 2]> {
    let mean = |place: &[f64; 2]| (place[0] + place[1]) / 2.0;
    let mut chain = places.to_vec();
    // Closed curves come back to the first place a lap on, where no line is wanted again.
    chain.extend(places.first().filter(|_| closed).map(|place| place.map(|share| share + 1.0)));
    let steps = if closed { count } else { (count - 1).max(1) };
    let (begin, end) = (mean(&chain[0]), mean(&chain[chain.len() - 1]));
    let mut k = 0;
    let at = |line: usize| {
        let wanted = begin + (end - begin) * line as f64 / steps as f64;
        while k + 2 < chain.len() && mean(&chain[k + 1]) <= wanted {
            k += 1;
        }
        let (from, to) = (chain[k], chain[(k + 1).min(chain.len() - 1)]);
        let step = mean(&to) - mean(&from);
        let t = if step > 0.0 { ((wanted - mean(&from)) / step).clamp(0.0, 1.0) } else { 0.0 };
        // The ends of the correspondence are met exactly.
        [0, 1].map(|curve| if t < 1.0 { from[curve] + t * (to[curve] - from[curve]) } else { to[curve] })
    };
    (0..count).map(at).collect()
}

/// Moves lines along their anti-diagonals, as little as possible by least squares, until both ends ascend strictly, each on its own side
/// of every corner.
fn strictly(places: &[[f64; 2]], corners: [&[f64]; 2]) -> Vec<[f64; 2]> {
    let n = places.len();
    let least = |k: usize| {
        let [x, y] = places[k];
        let lap = if k + 1 < n { 0.0 } else { 1.0 };
        let [u, v] = places[(k + 1) % n].map(|share| share + lap);
        (u - x).min(v - y)
    };
    // Cut open where both ends move on most evenly, hence far from fans.
    let cut = (0..n).reduce(|best, k| if least(k) > least(best) { k } else { best }).map_or(0, |k| k + 1);
    let mut line: Vec<[f64; 2]> =
        (cut..cut + n).map(|k| places[k % n].map(|share| share + (k / n) as f64)).collect();
    for curve in 0..2 {
        let even: Vec<f64> = line.iter().map(|[x, y]| LEAST_STEP * (x + y) / 2.0).collect();
        let mut rest: Vec<f64> = line.iter().zip(&even).map(|(place, even)| place[curve] - even).collect();
        let mut walls = walls(&line, curve, corners[curve]);
        // Half a least step on this side of the corner for the last line before it, and on the other side for the first one after it.
        let half = LEAST_STEP / (2 * n) as f64;
        walls.iter_mut().for_each(|(first, at)| *at += half - even[*first]);
        let (mut begin, mut low) = (0, f64::NEG_INFINITY);
        for (end, high) in walls.into_iter().chain([(n, f64::INFINITY)]) {
            make_ascending(&mut rest[begin..end]);
            rest[begin..end].iter_mut().for_each(|number| *number = number.max(low).min(high));
            (begin, low) = (end, high);
        }
        for ((place, rest), even) in line.iter_mut().zip(rest).zip(even) {
            let by = rest + even - place[curve];
            place[curve] += by;
            place[1 - curve] -= by;
        }
    }
    let lap = |place: [f64; 2], by: f64| place.map(|share| share - by);
    let whole = (cut / n) as f64;
    (0..n)
        .map(|k| {
            let at = (k + n - cut % n) % n;
            lap(line[at], whole + if k < cut % n { 1.0 } else { 0.0 })
        })
        .collect()
}

/// Samples at a corner lie this share of arc length before it, or at it.
const BEFORE: f64 = APART / 2.0;

/// Where the ends of lines in ascending order pass the corners of a curve: the first line beyond each, and the corner, laps counted.
fn walls(line: &[[f64; 2]], curve: usize, corners: &[f64]) -> Vec<(usize, f64)> {
    let (Some(first), Some(last)) = (line.first(), line.last()) else { return Vec::new() };
    let laps = first[curve].floor() as i64..=last[curve].floor() as i64;
    let all = laps.flat_map(|lap| corners.iter().map(move |corner| corner + lap as f64));
    let passed = all.map(|corner| (line.partition_point(|place| place[curve] < corner - BEFORE), corner));
    passed.filter(|(at, _)| (1..line.len()).contains(at)).collect()
}

/// Replaces numbers by the closest weakly ascending ones in the sense of least squares: pools neighbours that descend.
pub(super) fn make_ascending(numbers: &mut [f64]) {
    let mut pools: Vec<(f64, usize)> = Vec::new();
    for &number in numbers.iter() {
        let (mut sum, mut count) = (number, 1);
        while let Some(&(before, size)) = pools.last()
            && before / size as f64 > sum / count as f64
        {
            pools.pop();
            (sum, count) = (sum + before, count + size);
        }
        pools.push((sum, count));
    }
    let pooled = pools.iter().flat_map(|&(sum, count)| std::iter::repeat_n(sum / count as f64, count));
    numbers.iter_mut().zip(pooled).for_each(|(number, pooled)| *number = pooled);
}

#[cfg(test)]
mod tests {
    use super::super::test_shapes::Numbers;
    use super::*;

    fn means(places: &[[f64; 2]]) -> Vec<f64> {
        places.iter().map(|[x, y]| (x + y) / 2.0).collect()
    }

    #[test]
    fn a_rigid_correspondence_is_cut_into_equal_steps() {
        let places: Vec<[f64; 2]> =
            (0..10).map(|k| [f64::from(k) / 10.0, f64::from(k) / 10.0 + 0.3]).collect();
        let spread = spread_evenly(&places, 7, &[Vec::new(), Vec::new()], |_| 0.0);
        for (k, [x, y]) in spread.iter().enumerate() {
            assert!((x - k as f64 / 7.0).abs() < 1e-12 && (y - x - 0.3).abs() < 1e-12, "{k}: {x} {y}");
        }
    }

    #[test]
    fn fans_are_drawn_apart_and_every_count_is_one_to_one() {
        let mut numbers = Numbers(12);
        for case in 0..300 {
            // A monotone staircase of horizontal, vertical and diagonal pieces.
            let pieces = numbers.whole(2, 12);
            let mut place = [numbers.between(-2.0, 2.0), numbers.between(-2.0, 2.0)];
            let steps: Vec<[f64; 2]> = (0..pieces)
                .map(|_| [0.0, 1.0, 2.0].map(|_| numbers.next()))
                .map(|[x, y, kind]| {
                    if kind < 0.3 {
                        [x, 0.0]
                    } else if kind < 0.6 {
                        [0.0, y]
                    } else {
                        [x, y]
                    }
                })
                .collect();
            let total = steps.iter().fold([1e-9, 1e-9], |sum, step| [sum[0] + step[0], sum[1] + step[1]]);
            let places: Vec<[f64; 2]> = steps
                .iter()
                .map(|step| {
                    let here = place;
                    place = [place[0] + step[0] / total[0], place[1] + step[1] / total[1]];
                    here
                })
                .collect();
            if total[0] < 1e-3 || total[1] < 1e-3 {
                continue;
            }
            for count in [1, 2, 3, 7, 44, 500] {
                let noise = 0.3 / count as f64;
                let corners = [0, 1].map(|_| (0..case % 4).map(|k| (k as f64 + 0.37) / 4.0).collect());
                let spread = spread_evenly(&places, count, &corners, |_| numbers.between(-noise, noise));
                assert_eq!(spread.len(), count);
                assert!(ascends(&spread, true), "case {case}, {count} lines: {places:?}");
                for pair in means(&spread).windows(2) {
                    assert!(
                        (pair[1] - pair[0] - 1.0 / count as f64).abs() < 1e-9,
                        "case {case}: equal steps"
                    );
                }
            }
        }
    }

    #[test]
    fn lines_of_a_fan_stay_on_their_side_of_a_corner() {
        // Both fans of a corner at 0.5: most lines arrive from the side before it.
        let before = 0.5 - APART;
        let places = [[0.0, 0.0], [before, 0.4], [before, 0.62], [0.5, 0.62], [0.5, 0.7]];
        for count in [20, 100, 1000] {
            let corners = [vec![0.5], Vec::new()];
            let plain = at_even_means(&places, true, count);
            let spread = spread_evenly(&places, count, &corners, |_| 0.0);
            assert!(ascends(&spread, true));
            for (place, plain) in spread.iter().zip(&plain) {
                assert_eq!(place[0] < 0.5, plain[0] < 0.5 - APART / 2.0, "{count}: {plain:?} to {place:?}");
                assert!((place[0] - plain[0]).abs() < 3e-3, "{count}: {plain:?} to {place:?}");
            }
        }
    }

    #[test]
    fn pooling_gives_the_least_squares() {
        let mut numbers = vec![1.0, 3.0, 2.0, 2.0, 5.0, 4.0];
        make_ascending(&mut numbers);
        let third = 7.0 / 3.0;
        assert_eq!(numbers, [1.0, third, third, third, 4.5, 4.5]);
    }

    #[test]
    fn held_places_are_kept_to_the_last_bit_and_order_stays_strict() {
        let mut numbers = Numbers(33);
        for case in 0..200 {
            let count = numbers.whole(3, 40);
            let places: Vec<[f64; 2]> =
                (0..count).map(|k| [k as f64 / count as f64, k as f64 / count as f64 + 0.4]).collect();
            let mut shares = [numbers.next(), numbers.next()];
            shares.sort_by(f64::total_cmp);
            let wobble = numbers.between(-0.1, 0.1);
            let held = shares.map(|x| [x, x + 0.4 + wobble]);
            let mut found = places.clone();
            hold_places(&mut found, true, &held);
            assert!(ascends(&found, true), "case {case}: {found:?}");
            for pin in held {
                let is_pin = |place: &[f64; 2]| {
                    let off = [place[0] - pin[0], place[1] - pin[1]];
                    (off[0] - off[0].round()).abs() < 1e-12 && (off[1] - off[0].round()).abs() < 1e-12
                };
                assert!(found.iter().any(is_pin), "case {case}: {pin:?}");
            }
            assert!(found.len() <= count.max(2), "case {case}");
        }
    }

    #[test]
    fn lines_of_a_fan_keep_off_the_end_of_a_held_place() {
        for ulps in [-1, 0, 1] {
            // One line leans on the vertex that the held one ends in, or lies a bit beside it.
            let share = f64::from_bits((0.5_f64.to_bits() as i64 + ulps) as u64);
            let mut places = vec![[0.1, 0.1], [share, 0.4], [0.52, 0.6], [0.8, 0.8]];
            hold_places(&mut places, true, &[[0.5, 0.55]]);
            assert_eq!(places, [[0.1, 0.1], [0.5, 0.55], [0.8, 0.8]]);
        }
        let mut places = vec![[0.1, 0.1], [0.3, 0.3], [0.6, 0.6], [0.8, 0.8]];
        let held = [[0.5, 0.5], [0.5 + 1e-6, 0.5 + 1e-6]];
        hold_places(&mut places, true, &held);
        assert!(held.iter().all(|pin| places.contains(pin)), "held places may be as near as they like");
        for held in [[[0.5, 0.5], [0.5, 0.7]], [[0.5, 0.7], [0.5, 0.5]], [[0.4, 0.5], [0.7, 0.5]]] {
            let mut places = vec![[0.1, 0.1], [0.3, 0.3], [0.6, 0.6], [0.8, 0.8]];
            hold_places(&mut places, true, &held);
            assert!(held.iter().all(|pin| places.contains(pin)), "{places:?}");
            assert!(places.windows(2).all(|w| w[0][0] <= w[1][0] && w[0][1] <= w[1][1]), "{places:?}");
        }
    }
}
