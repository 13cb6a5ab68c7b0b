//! Lines of equal composition on a raster.

use super::Raster;
use glam::DVec2;
use std::collections::HashMap;

/// A line that parts the places with at least a fraction from the others.
#[derive(Debug, Clone, PartialEq)]
pub struct PartIsoline {
    /// Its points.
    pub points: Vec<DVec2>,
    /// Whether the last point is joined to the first.
    pub is_closed: bool,
}

/// Lines along which a material has a fraction, by marching squares between the centres of pixels; linear between neighbours. Squares that are
/// not in one body alone have none, so that lines end within a pixel of a boundary.
///
/// # Panics
/// When there is no such material.
#[must_use]
pub fn isolines(raster: &Raster, material: usize, level: f32) -> Vec<PartIsoline> {
    let [nx, ny] = raster.frame.size();
    let values = &raster.fractions[material];
    // The crossing on the side to the right of a pixel has the number 2 n, on the one below 2 n + 1.
    let mut joined: HashMap<usize, [usize; 2]> = HashMap::new();
    let mut join = |a: usize, b: usize| {
        for (from, to) in [(a, b), (b, a)] {
            let ends = joined.entry(from).or_insert([usize::MAX; 2]);
            let free = usize::from(ends[0] != usize::MAX);
            ends[free] = to;
        }
    };
    for j in 0..ny.saturating_sub(1) {
        for i in 0..nx.saturating_sub(1) {
            let n = j * nx + i;
            let corners = [n, n + 1, n + nx + 1, n + nx];
            let body = raster.body[n];
            if body == 0 || corners.iter().any(|corner| raster.body[*corner] != body) {
                continue;
            }
            let is_in = corners.map(|corner| values[corner] >= level);
            let sides = [2 * n, 2 * (n + 1) + 1, 2 * (n + nx), 2 * n + 1];
            let cut: Vec<usize> =
                (0..4).filter(|k| is_in[*k] != is_in[(k + 1) % 4]).map(|k| sides[k]).collect();
            match cut.as_slice() {
                [a, b] => join(*a, *b),
                [a, b, c, d] => {
                    let mean = corners.iter().map(|corner| values[*corner]).sum::<f32>() / 4.0;
                    // The sides a and b meet in the second corner, which is alone when the middle is of the other kind.
                    if (mean >= level) == is_in[1] {
                        join(*a, *d);
                        join(*b, *c);
                    } else {
                        join(*a, *b);
                        join(*c, *d);
                    }
                }
                _ => {}
            }
        }
    }
    let place = |side: usize| {
        let n = side / 2;
        let other = if side.is_multiple_of(2) { n + 1 } else { n + nx };
        let t = f64::from((level - values[n]) / (values[other] - values[n])).clamp(0.0, 1.0);
        let center = |n: usize| raster.frame.center(n % nx, n / nx);
        center(n).lerp(center(other), t)
    };
    chained(&joined)
        .into_iter()
        .map(|(sides, is_closed)| PartIsoline { points: sides.into_iter().map(place).collect(), is_closed })
        .collect()
}

/// Chains of joined things, open ones from end to end, in the order of their first numbers.
fn chained(joined: &HashMap<usize, [usize; 2]>) -> Vec<(Vec<usize>, bool)> {
    let mut numbers: Vec<usize> = joined.keys().copied().collect();
    numbers.sort_unstable();
    let is_end = |number: &usize| joined[number][1] == usize::MAX;
    let (ends, others): (Vec<usize>, Vec<usize>) = numbers.into_iter().partition(is_end);
    let mut seen = std::collections::HashSet::new();
    let mut chains = Vec::new();
    for start in ends.into_iter().chain(others) {
        if !seen.insert(start) {
            continue;
        }
        let (mut chain, mut here) = (vec![start], start);
        while let Some(next) =
            joined[&here].into_iter().find(|next| *next != usize::MAX && !seen.contains(next))
        {
            seen.insert(next);
            chain.push(next);
            here = next;
        }
        let is_closed = chain.len() > 2 && joined[&here].contains(&start);
        chains.push((chain, is_closed));
    }
    chains
}

#[cfg(test)]
mod tests {
    use super::super::Frame;
    use super::*;
    use crate::geom::Bounds;
    use glam::dvec2;

    fn raster(size: usize, value: impl Fn(DVec2) -> f64) -> Raster {
        let frame =
            Frame::new(Bounds { min: dvec2(-1.0, -1.0), max: dvec2(1.0, 1.0) }, [size, size]).unwrap();
        let values = (0..size * size).map(|n| value(frame.center(n % size, n / size)) as f32).collect();
        Raster { frame, body: vec![1; size * size], fractions: vec![values], leaves: vec![0; size * size] }
    }

    #[test]
    fn a_cone_has_circles() {
        let lines = isolines(&raster(80, |p| 1.0 - p.length()), 0, 0.5);
        assert_eq!(lines.len(), 1);
        assert!(lines[0].is_closed && lines[0].points.len() > 60);
        assert!(lines[0].points.iter().all(|point| (point.length() - 0.5).abs() < 1e-3));
    }

    #[test]
    fn a_gradient_has_an_open_line_and_a_saddle_two() {
        let straight = isolines(&raster(20, |p| 0.5 + 0.4 * p.x), 0, 0.5);
        assert_eq!((straight.len(), straight[0].is_closed, straight[0].points.len()), (1, false, 20));
        assert!(straight[0].points.iter().all(|point| point.x.abs() < 1e-6));
        let saddle = isolines(&raster(21, |p| 0.5 + p.x * p.y - 0.01), 0, 0.5);
        assert_eq!(saddle.iter().map(|line| line.is_closed).collect::<Vec<_>>(), [false, false]);
    }

    #[test]
    fn lines_stay_within_a_body() {
        let mut raster = raster(20, |p| 0.5 + 0.4 * p.x);
        raster.body[..200].fill(0);
        let lines = isolines(&raster, 0, 0.5);
        assert_eq!((lines.len(), lines[0].points.len()), (1, 10));
        raster.body.fill(0);
        assert!(isolines(&raster, 0, 0.5).is_empty());
    }
}
