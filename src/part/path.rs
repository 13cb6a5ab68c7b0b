//! Chains of segments.

use crate::geom::Bounds;
use glam::DVec2;

/// Segments that share a box.
const CHUNK: usize = 16;

/// Segments in the plane: the sides of a polygon, a polyline, or what is left of a boundary. Neighbours in the list share boxes, so that most
/// segments are never looked at.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    segments: Vec<Segment>,
    boxes: Vec<Bounds>,
    bounds: Bounds,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Segment {
    start: DVec2,
    along: DVec2,
    /// One over the squared length; 0 of a segment without length.
    inverse: f64,
}

impl Segment {
    fn distance_squared(&self, point: DVec2) -> f64 {
        let offset = point - self.start;
        let t = (offset.dot(self.along) * self.inverse).clamp(0.0, 1.0);
        (offset - t * self.along).length_squared()
    }
}

impl Path {
    /// The segments from each point to the next, and from the last one to the first where it closes. `None` without a point.
    #[must_use]
    pub fn through(points: &[DVec2], is_closed: bool) -> Option<Self> {
        let (first, last) = (*points.first()?, *points.last()?);
        let ends = points.windows(2).map(|pair| (pair[0], pair[1]));
        let closing = (is_closed || points.len() == 1).then_some((last, first));
        Self::of(ends.chain(closing).collect())
    }

    /// Segments by their ends; `None` without any.
    #[must_use]
    pub fn of(ends: Vec<(DVec2, DVec2)>) -> Option<Self> {
        let bounds = Bounds::of(ends.iter().flat_map(|(a, b)| [*a, *b]))?;
        let boxes =
            ends.chunks(CHUNK).filter_map(|chunk| Bounds::of(chunk.iter().flat_map(|(a, b)| [*a, *b])));
        let segment = |&(start, end): &(DVec2, DVec2)| {
            let along = end - start;
            let inverse = along.length_squared().recip();
            Segment { start, along, inverse: if inverse.is_finite() { inverse } else { 0.0 } }
        };
        Some(Self { segments: ends.iter().map(segment).collect(), boxes: boxes.collect(), bounds })
    }

    /// The ends of the segments, in order.
    pub fn ends(&self) -> impl ExactSizeIterator<Item = (DVec2, DVec2)> + '_ {
        self.segments.iter().map(|segment| (segment.start, segment.start + segment.along))
    }

    /// The box of all segments.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Distance of a point to the nearest segment.
    #[must_use]
    pub fn distance(&self, point: DVec2) -> f64 {
        self.nearest_squared(point).sqrt()
    }

    fn nearest_squared(&self, point: DVec2) -> f64 {
        let to_box = |chunk: usize| box_distance_squared(self.boxes[chunk], point);
        let first = (0..self.boxes.len()).min_by(|a, b| to_box(*a).total_cmp(&to_box(*b))).unwrap_or(0);
        let within = |chunk: usize, best: f64| {
            let segments = &self.segments[chunk * CHUNK..self.segments.len().min((chunk + 1) * CHUNK)];
            segments.iter().map(|segment| segment.distance_squared(point)).fold(best, f64::min)
        };
        let best = within(first, f64::INFINITY);
        (0..self.boxes.len()).fold(best, |best, chunk| {
            if chunk == first || to_box(chunk) >= best { best } else { within(chunk, best) }
        })
    }

    /// Appends every segment that can be the nearest one of a point no farther than `radius` from the centre: those within the
    /// distance of the centre and two radii.
    pub fn candidates(&self, center: DVec2, radius: f64, list: &mut Vec<u32>) {
        let reach = self.distance(center) + 2.0 * radius;
        // Rounding shall lose none.
        let reach = reach * reach * (1.0 + 1e-12);
        for (chunk, bounds) in self.boxes.iter().enumerate() {
            if box_distance_squared(*bounds, center) > reach {
                continue;
            }
            let first = chunk * CHUNK;
            for (k, segment) in self.segments[first..].iter().take(CHUNK).enumerate() {
                if segment.distance_squared(center) <= reach {
                    list.push((first + k) as u32);
                }
            }
        }
    }

    /// Of candidates for a larger neighbourhood, appends those for a smaller one.
    pub fn narrow(&self, center: DVec2, radius: f64, from: std::ops::Range<usize>, list: &mut Vec<u32>) {
        let reach = self.among(&list[from.clone()], center).sqrt() + 2.0 * radius;
        let reach = reach * reach * (1.0 + 1e-12);
        for at in from {
            if self.segments[list[at] as usize].distance_squared(center) <= reach {
                list.push(list[at]);
            }
        }
    }

    /// Squared distance to the nearest one of some segments.
    #[must_use]
    pub fn among(&self, list: &[u32], point: DVec2) -> f64 {
        let squared = list.iter().map(|index| self.segments[*index as usize].distance_squared(point));
        squared.fold(f64::INFINITY, f64::min)
    }

    /// Appends where the path, which is closed, crosses the horizontal line at a height.
    pub fn crossings(&self, height: f64, list: &mut Vec<f64>) {
        for (chunk, bounds) in self.boxes.iter().enumerate() {
            if bounds.min.y > height || bounds.max.y <= height {
                continue;
            }
            for segment in self.segments[chunk * CHUNK..].iter().take(CHUNK) {
                let (low, high) = (segment.start.y, segment.start.y + segment.along.y);
                if (low > height) != (high > height) {
                    list.push(segment.start.x + segment.along.x * (height - low) / segment.along.y);
                }
            }
        }
    }

    /// Whether the path, which is closed, has a point inside: the number of crossings to its right is odd.
    #[must_use]
    pub fn contains(&self, point: DVec2) -> bool {
        let mut list = Vec::new();
        self.crossings(point.y, &mut list);
        list.iter().filter(|x| **x > point.x).count() % 2 == 1
    }
}

/// Squared distance of a point to a box.
fn box_distance_squared(bounds: Bounds, point: DVec2) -> f64 {
    (bounds.min - point).max(point - bounds.max).max(DVec2::ZERO).length_squared()
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec2;

    /// A number in [0, 1) that follows from the seed.
    fn random(seed: &mut u64) -> f64 {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn brute(ends: &[(DVec2, DVec2)], point: DVec2) -> f64 {
        let to = |&(a, b): &(DVec2, DVec2)| {
            let length = (b - a).length_squared();
            let t = if length > 0.0 { ((point - a).dot(b - a) / length).clamp(0.0, 1.0) } else { 0.0 };
            point.distance(a.lerp(b, t))
        };
        ends.iter().map(to).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn distances_and_candidates_agree_with_all_segments() {
        let mut seed = 5;
        for count in [1, 2, 3, 17, 200] {
            let points: Vec<DVec2> =
                (0..count).map(|_| dvec2(random(&mut seed), random(&mut seed))).collect();
            let path = Path::through(&points, true).expect("points");
            let ends: Vec<(DVec2, DVec2)> = path.ends().collect();
            for _ in 0..200 {
                let center = dvec2(3.0 * random(&mut seed) - 1.0, 3.0 * random(&mut seed) - 1.0);
                assert!((path.distance(center) - brute(&ends, center)).abs() < 1e-12);
                let radius = 0.1 * random(&mut seed);
                let mut list = Vec::new();
                path.candidates(center, radius, &mut list);
                let wide = list.len();
                path.narrow(center, radius / 2.0, 0..wide, &mut list);
                for share in [1.0, 0.5] {
                    let angle = 6.3 * random(&mut seed);
                    let point = center + share * radius * DVec2::from_angle(angle);
                    let kept = if share == 1.0 { &list[..wide] } else { &list[wide..] };
                    assert!((path.among(kept, point).sqrt() - brute(&ends, point)).abs() < 1e-12);
                }
            }
        }
    }

    #[test]
    fn a_closed_path_contains_what_is_inside() {
        let star: Vec<DVec2> = (0..60)
            .map(|k| DVec2::from_angle(f64::from(k) * std::f64::consts::TAU / 60.0) * f64::from(1 + k % 2))
            .collect();
        let path = Path::through(&star, true).expect("points");
        let mut seed = 9;
        for _ in 0..2000 {
            let point = dvec2(5.0 * random(&mut seed) - 2.5, 5.0 * random(&mut seed) - 2.5);
            let is_inside = crate::geom::locate(&star, point) == crate::geom::Location::Inside;
            assert_eq!(path.contains(point), is_inside, "{point}");
        }
    }

    #[test]
    fn there_is_no_path_without_points_and_one_point_is_a_place() {
        assert_eq!(Path::through(&[], true), None);
        let place = Path::through(&[dvec2(1.0, 2.0)], false).expect("a point");
        assert_eq!(place.distance(dvec2(4.0, 6.0)), 5.0);
    }
}
