//! A mask of thresholds whose patterns have no low frequencies.

use std::sync::OnceLock;

/// Pixels along the side of the tile, which is repeated in both directions.
pub(super) const SIDE: usize = 64;
const COUNT: usize = SIDE * SIDE;
/// Share of the pixels that the first pattern has.
const FIRST: usize = COUNT / 10;
/// Pixels to which a point reaches: beyond, its weight is below 1e-7.
const REACH: usize = 8;
/// exp(-1 / (2 sigma^2)) with sigma = 1.5 pixels, so that weights are products, which are the same on every machine.
const RATIO: f64 = 0.800_737_402_916_808;
/// Weights are whole numbers of this fraction, so that adding and taking away leaves nothing behind.
const UNIT: f64 = (1 << 24) as f64;

/// The rank of each pixel of the tile, 0 to 4095, each once: with the first n on, for any n, points keep away from each other.
///
/// By void and cluster (R. Ulichney, "The void-and-cluster method for dither array generation", 1993): from a first pattern whose tightest cluster was moved into its
/// largest void until that changes nothing, points go from the tightest clusters for the ranks below, and come into the largest voids for those above.
pub(super) fn ranks() -> &'static [u16] {
    static RANKS: OnceLock<Vec<u16>> = OnceLock::new();
    RANKS.get_or_init(|| {
        let mut ranks = vec![0; COUNT];
        let first = Pattern::first();
        let mut pattern = first.clone();
        for rank in (0..FIRST).rev() {
            let at = pattern.tightest_cluster();
            pattern.turn(at, false);
            ranks[at] = rank as u16;
        }
        let mut pattern = first;
        for rank in FIRST..COUNT {
            let at = pattern.largest_void();
            pattern.turn(at, true);
            ranks[at] = rank as u16;
        }
        ranks
    })
}

/// Points on a torus, with how crowded every pixel is.
#[derive(Debug, Clone)]
struct Pattern {
    /// All bits where there is a point, else none.
    points: Vec<u32>,
    /// Sum of the weights of all points at a pixel.
    crowd: Vec<u32>,
    /// Weights by the distance in rows and columns.
    weights: [[u32; REACH + 1]; REACH + 1],
}

impl Pattern {
    fn first() -> Self {
        let power = |count: usize| (0..count).fold(1.0, |product, _| product * RATIO);
        let weight = |y: usize| std::array::from_fn(|x| (UNIT * power(x * x) * power(y * y)).round() as u32);
        let mut pattern =
            Self { points: vec![0; COUNT], crowd: vec![0; COUNT], weights: std::array::from_fn(weight) };
        // Any pattern does; that of a generator of G. Marsaglia ("Xorshift RNGs", 2003) is always the same.
        let mut state = 2_463_534_242_u32;
        let mut placed = 0;
        while placed < FIRST {
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            let at = (state >> 8) as usize % COUNT;
            if pattern.points[at] == 0 {
                pattern.turn(at, true);
                placed += 1;
            }
        }
        // It comes to rest after a few hundred moves.
        for _ in 0..COUNT {
            let from = pattern.tightest_cluster();
            pattern.turn(from, false);
            let to = pattern.largest_void();
            pattern.turn(to, true);
            if from == to {
                break;
            }
        }
        pattern
    }

    fn turn(&mut self, at: usize, is_on: bool) {
        self.points[at] = if is_on { u32::MAX } else { 0 };
        let [column, row] = [at % SIDE, at / SIDE];
        let reach = REACH as isize;
        for dy in -reach..=reach {
            let start = (row as isize + dy).rem_euclid(SIDE as isize) as usize * SIDE;
            for dx in -reach..=reach {
                let other = start + (column as isize + dx).rem_euclid(SIDE as isize) as usize;
                let weight = self.weights[dy.unsigned_abs()][dx.unsigned_abs()];
                let crowd = &mut self.crowd[other];
                *crowd = if is_on { *crowd + weight } else { *crowd - weight };
            }
        }
    }

    /// The point that is crowded most; the first of equals.
    fn tightest_cluster(&self) -> usize {
        let held = || self.crowd.iter().zip(&self.points).map(|(crowd, point)| crowd & point);
        let most = held().max().unwrap_or(0);
        held().position(|crowd| crowd == most).unwrap_or(0)
    }

    /// The free pixel that is crowded least; the first of equals.
    fn largest_void(&self) -> usize {
        let free = || self.crowd.iter().zip(&self.points).map(|(crowd, point)| crowd | point);
        let least = free().min().unwrap_or(0);
        free().position(|crowd| crowd == least).unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn every_rank_stands_once_and_the_mask_is_always_the_same() {
        let mut sorted = ranks().to_vec();
        sorted.sort_unstable();
        assert!(sorted.iter().enumerate().all(|(n, rank)| usize::from(*rank) == n));
        // FNV-1a of the mask: another one would change what a printer is given.
        let hash = ranks().iter().fold(0xcbf2_9ce4_8422_2325_u64, |hash, rank| {
            (hash ^ u64::from(*rank)).wrapping_mul(0x0100_0000_01b3)
        });
        assert_eq!(hash, 0x8cb7_f614_1cce_226b, "{hash:#x}");
    }

    /// The power of the frequencies (u, v), in multiples of that of white noise with the same share of points.
    fn spectrum(points: &[bool]) -> Vec<f64> {
        let share = points.iter().filter(|on| **on).count() as f64 / COUNT as f64;
        let turn = |n: usize| {
            let angle = TAU * (n % SIDE) as f64 / SIDE as f64;
            (angle.cos(), -angle.sin())
        };
        let times = |(a, b): (f64, f64), (c, d): (f64, f64)| (a * c - b * d, a * d + b * c);
        let sum = |terms: &mut dyn Iterator<Item = (f64, f64)>| {
            terms.fold((0.0, 0.0), |(a, b), (c, d)| (a + c, b + d))
        };
        let value = |on: bool| (f64::from(u8::from(on)) - share, 0.0);
        let rows: Vec<(f64, f64)> = (0..COUNT)
            .map(|n| {
                let (row, u) = (n / SIDE, n % SIDE);
                sum(&mut (0..SIDE).map(|x| times(value(points[row * SIDE + x]), turn(u * x))))
            })
            .collect();
        (0..COUNT)
            .map(|n| {
                let (v, u) = (n / SIDE, n % SIDE);
                let (a, b) = sum(&mut (0..SIDE).map(|y| times(rows[y * SIDE + u], turn(v * y))));
                (a * a + b * b) / (COUNT as f64 * share * (1.0 - share))
            })
            .collect()
    }

    /// The mean over frequencies below a share of the principal one: sqrt(g) cycles a pixel for the share g of points, or of free pixels where these are fewer, and at
    /// most the half that a square grid can hold (D. Lau and R. Ulichney, "Blue-noise halftoning for hexagonal grids", 2006).
    fn low(points: &[bool], below: f64) -> f64 {
        let share = points.iter().filter(|on| **on).count() as f64 / COUNT as f64;
        let limit = below * share.min(1.0 - share).sqrt().min(0.5);
        let along = |n: usize| n.min(SIDE - n) as f64 / SIDE as f64;
        let inside = |n: &usize| *n > 0 && along(n % SIDE).hypot(along(n / SIDE)) < limit;
        let all = spectrum(points);
        let found: Vec<f64> = (0..COUNT).filter(inside).map(|n| all[n]).collect();
        assert!(found.len() > 20, "{}", found.len());
        found.iter().sum::<f64>() / found.len() as f64
    }

    /// Below half of the principal frequency less than a tenth of what points at random have.
    #[test]
    fn patterns_have_next_to_nothing_at_low_frequencies() {
        for share in [0.1, 0.25, 0.5, 0.75, 0.9] {
            let points: Vec<bool> =
                ranks().iter().map(|rank| f64::from(*rank) < share * COUNT as f64).collect();
            let found = low(&points, 0.5);
            assert!(found < 0.1, "{share}: {found}");
            // What has the same points at random, as a control.
            let white: Vec<bool> =
                (0..COUNT).map(|n| (n * 2_654_435_761 % 65_537) as f64 / 65_537.0 < share).collect();
            let white = low(&shuffled(&white), 0.5);
            assert!((0.6..1.5).contains(&white), "{share}: {white}");
        }
    }

    fn shuffled(points: &[bool]) -> Vec<bool> {
        let mut points = points.to_vec();
        let mut state = 88_172_645_463_325_252_u64;
        for n in (1..points.len()).rev() {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            points.swap(n, (state >> 11) as usize % (n + 1));
        }
        points
    }
}
