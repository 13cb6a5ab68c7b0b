//! A slow check of lines and of one-to-one pairs: plain geometry in floating point on whole lists, without lifts, grids or exact predicates.

use directrix::document::Model;
use directrix::matching::{OneToOne, RulingLine};
use glam::DVec2;

/// What a set of lines looks like from outside.
pub struct Picture {
    polygons: [Vec<DVec2>; 2],
    segments: Vec<(DVec2, DVec2)>,
    hair: f64,
    closed: bool,
}

impl Picture {
    /// Pairs, with polygons through all samples and all ends of pairs, by ascending parameter in the domain.
    pub fn of(model: &Model, pairs: &OneToOne) -> Self {
        let ends = |axis: usize| -> Vec<(f64, DVec2)> {
            let (lo, hi) = model.curves()[axis].domain();
            let wrap = |u: f64| lo + (u - lo).rem_euclid(hi - lo);
            let place = |&(u, v): &(f64, f64)| if axis == 0 { u } else { v };
            pairs.places.iter().map(place).map(|u| (wrap(u), model.curves()[axis].point(u))).collect()
        };
        let ends = [ends(0), ends(1)];
        let polygons = [0, 1].map(|axis| {
            let samples = &model.samples()[axis];
            let given = samples.parameters.iter().copied().zip(samples.points.iter().copied());
            let mut all: Vec<(f64, DVec2)> = given.chain(ends[axis].iter().copied()).collect();
            all.sort_by(|a, b| a.0.total_cmp(&b.0));
            let size = all.iter().fold(0.0_f64, |m, p| m.max(p.1.length()));
            all.dedup_by(|a, b| a.1.distance(b.1) < 1e-11 * size);
            if all.len() > 1 && all[0].1.distance(all[all.len() - 1].1) < 1e-11 * size {
                all.pop();
            }
            all.into_iter().map(|(_, point)| point).collect::<Vec<_>>()
        });
        let segments = ends[0].iter().zip(&ends[1]).map(|(p, q)| (p.1, q.1)).collect();
        Self { polygons, segments, hair: 1e-10 * model.bounds().diagonal(), closed: true }
    }

    /// Pairs, with the polygons that they were verified against, however fine.
    pub fn as_verified(model: &Model, pairs: &OneToOne) -> Self {
        let polygons = pairs.problem.outlines().each_ref().map(|outline| outline.points.clone());
        Self { polygons, ..Self::of(model, pairs) }
    }

    /// Lines between samples.
    pub fn of_lines(model: &Model, lines: &[RulingLine]) -> Self {
        let samples = model.samples();
        let polygons = [0, 1].map(|axis| samples[axis].points.clone());
        let segments = lines.iter().map(|line| (polygons[0][line.from], polygons[1][line.to])).collect();
        Self { polygons, segments, hair: 1e-10 * model.bounds().diagonal(), closed: true }
    }

    /// Pairs between open curves, with the polylines that they were verified against.
    pub fn as_verified_open(model: &Model, pairs: &OneToOne) -> Self {
        let polygons = pairs.problem.outlines().each_ref().map(|outline| outline.points.clone());
        let [first, second] = [&model.curves()[0], &model.curves()[1]];
        let segments = pairs.places.iter().map(|&(u, v)| (first.point(u), second.point(v))).collect();
        Self { polygons, segments, hair: 1e-10 * model.bounds().diagonal(), closed: false }
    }

    /// Lines between samples of open curves.
    pub fn of_open_lines(model: &Model, lines: &[RulingLine]) -> Self {
        Self { closed: false, ..Self::of_lines(model, lines) }
    }

    /// Whether two segments pass through each other by more than a hair.
    fn pass(&self, (a, b): (DVec2, DVec2), (c, d): (DVec2, DVec2)) -> bool {
        let side = |a: DVec2, b: DVec2, p: DVec2| (b - a).normalize().perp_dot(p - a);
        let splits = |a, b, c, d| {
            let (s, t) = (side(a, b, c), side(a, b, d));
            (s > self.hair && t < -self.hair) || (s < -self.hair && t > self.hair)
        };
        splits(a, b, c, d) && splits(c, d, a, b)
    }

    /// Pairs of lines that cross, and lines that cross an edge of a polygon.
    pub fn faults(&self) -> (Vec<(usize, usize)>, Vec<usize>) {
        let count = self.segments.len();
        let crossed = (0..count).flat_map(|i| (i + 1..count).map(move |k| (i, k)));
        let crossed = crossed.filter(|&(i, k)| self.pass(self.segments[i], self.segments[k])).collect();
        let blocked = |&k: &usize| {
            self.polygons.iter().any(|polygon| {
                let next = polygon.iter().cycle().skip(1);
                let edges = polygon.len() - usize::from(!self.closed);
                polygon.iter().zip(next).take(edges).any(|(&a, &b)| self.pass(self.segments[k], (a, b)))
            })
        };
        (crossed, (0..count).filter(blocked).collect())
    }

    /// Number of vertices of each polygon.
    pub fn vertices(&self) -> [usize; 2] {
        self.polygons.each_ref().map(Vec::len)
    }
}
