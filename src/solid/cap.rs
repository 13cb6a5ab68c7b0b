//! The area inside a closed rim, in triangles.

use super::ties::settle;
use crate::geom::{Bounds, first_self_contact, signed_area};
use glam::DVec2;
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};

/// Coordinates of a rim are scaled to a box of 2 by 2; what is smaller than this is taken for 0.
const SMALLEST: f64 = 1e-40;

/// A triangulation of the area inside a polygon.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cap {
    /// Indices of the vertices of each triangle, counter-clockwise in the plane.
    pub triangles: Vec<[usize; 3]>,
    /// Whether the polygon runs counter-clockwise, as the triangles do.
    pub is_counter_clockwise: bool,
}

/// Why a rim has no cap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CapError {
    /// Fewer than three vertices, or no area.
    Empty,
    /// Two edges meet that are not neighbours.
    Crossing {
        /// A vertex of one of them.
        at: DVec2,
    },
}

impl Cap {
    /// Triangulates the area inside a simple polygon of either orientation: the constrained Delaunay triangulation, whose triangles are as blunt
    /// as they can be without a vertex off the rim (L. P. Chew, "Constrained Delaunay triangulations", Algorithmica 4, 1989).
    ///
    /// Where four vertices lie on a circle their numbers decide.
    ///
    /// # Errors
    /// When the polygon is not simple, which is decided exactly.
    pub fn new(rim: &[DVec2]) -> Result<Self, CapError> {
        let bounds = Bounds::of(rim.iter().copied()).ok_or(CapError::Empty)?;
        let (center, half) = (bounds.center(), (bounds.max - bounds.min).max_element() / 2.0);
        if rim.len() < 3 || !(half > 0.0 && half.is_finite()) {
            return Err(CapError::Empty);
        }
        let tiny_to_zero = |x: f64| if x.abs() < SMALLEST { 0.0 } else { x };
        let scaled = |point: &DVec2| ((*point - center) / half).map(tiny_to_zero);
        let polygon: Vec<DVec2> = rim.iter().map(scaled).collect();
        if let Some((edge, _)) = first_self_contact(&polygon, true) {
            return Err(CapError::Crossing { at: rim[edge] });
        }
        let area = signed_area(&polygon);
        let mut triangles = triangulate(&polygon, area > 0.0);
        settle(&polygon, &mut triangles);
        if triangles.len() + 2 == rim.len() {
            Ok(Self { triangles, is_counter_clockwise: area > 0.0 })
        } else {
            Err(CapError::Empty)
        }
    }
}

/// The triangles inside a simple polygon, found from its edges inwards.
fn triangulate(polygon: &[DVec2], is_counter_clockwise: bool) -> Vec<[usize; 3]> {
    let count = polygon.len();
    let points = polygon.iter().map(|point| Point2::new(point.x, point.y)).collect();
    let edges = (0..count).map(|k| [k, (k + 1) % count]).collect();
    // Of a simple polygon no two edges conflict.
    let Ok(net) = ConstrainedDelaunayTriangulation::<Point2<f64>>::try_bulk_load_cdt(points, edges, |_| {})
    else {
        return Vec::new();
    };
    let mut is_inside = vec![false; net.num_all_faces()];
    let mut open = Vec::new();
    for edge in net.directed_edges().filter(|edge| edge.is_constraint_edge()) {
        let [from, to] = edge.vertices().map(|vertex| vertex.index());
        if ((from + 1) % count == to) == is_counter_clockwise {
            open.extend(edge.face().as_inner());
        }
    }
    let mut triangles = Vec::with_capacity(count.saturating_sub(2));
    while let Some(face) = open.pop() {
        if std::mem::replace(&mut is_inside[face.index()], true) {
            continue;
        }
        triangles.push(face.vertices().map(|vertex| vertex.index()));
        for edge in face.adjacent_edges().into_iter().filter(|edge| !edge.is_constraint_edge()) {
            open.extend(edge.rev().face().as_inner());
        }
    }
    triangles
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::orient2d;
    use glam::dvec2;

    fn check(rim: &[DVec2]) -> Cap {
        let cap = Cap::new(rim).expect("a simple polygon");
        assert_eq!(cap.triangles.len(), rim.len() - 2);
        let areas = cap.triangles.iter().map(|t| {
            let [a, b, c] = t.map(|k| rim[k]);
            assert!(orient2d(a, b, c) > 0.0);
            (b - a).perp_dot(c - a) / 2.0
        });
        let area: f64 = areas.sum();
        assert!((area - signed_area(rim).abs()).abs() <= 1e-12 * area, "{area}");
        cap
    }

    /// A star with deep notches, wound both ways, far from the origin and tiny.
    #[test]
    fn covers_polygons_that_are_not_convex() {
        for (scale, shift) in [(1.0, 0.0), (1e-9, 0.0), (1e12, 0.0), (1.0, 1e6)] {
            let star = |k: u32| {
                let r = if k.is_multiple_of(2) { 1.0 } else { 0.2 };
                scale * r * DVec2::from_angle(f64::from(k) * std::f64::consts::TAU / 34.0) + shift
            };
            let mut rim: Vec<DVec2> = (0..34).map(star).collect();
            assert!(check(&rim).is_counter_clockwise);
            rim.reverse();
            assert!(!check(&rim).is_counter_clockwise);
        }
    }

    /// Of a convex quadrilateral the diagonal is the one whose circles hold no other vertex.
    #[test]
    fn is_the_delaunay_triangulation_where_edges_allow() {
        let rim = [dvec2(0.0, -2.0), dvec2(1.0, 0.0), dvec2(0.0, 2.0), dvec2(-1.0, 0.0)];
        let cap = check(&rim);
        assert!(cap.triangles.iter().all(|t| t.contains(&1) && t.contains(&3)));
    }

    #[test]
    fn vertices_on_straight_edges_are_kept() {
        let rim: Vec<DVec2> = (0..40)
            .map(|k| {
                let (side, t) = (k / 10, f64::from(k % 10) / 10.0);
                [dvec2(t, 0.0), dvec2(1.0, t), dvec2(1.0 - t, 1.0), dvec2(0.0, 1.0 - t)][side as usize]
            })
            .collect();
        let cap = check(&rim);
        let mut seen = [false; 40];
        cap.triangles.iter().flatten().for_each(|&k| seen[k] = true);
        assert!(seen.iter().all(|&seen| seen));
    }

    #[test]
    fn polygons_that_meet_themselves_are_refused() {
        let bow = [dvec2(0.0, 0.0), dvec2(1.0, 1.0), dvec2(1.0, 0.0), dvec2(0.0, 1.0)];
        assert!(matches!(Cap::new(&bow), Err(CapError::Crossing { .. })));
        assert_eq!(Cap::new(&bow[..2]), Err(CapError::Empty));
        assert_eq!(Cap::new(&[DVec2::ONE; 3]), Err(CapError::Empty));
        let pinched = [
            dvec2(0.0, 0.0),
            dvec2(2.0, 0.0),
            dvec2(1.0, 1.0),
            dvec2(2.0, 2.0),
            dvec2(0.0, 2.0),
            dvec2(1.0, 1.0),
        ];
        assert!(matches!(Cap::new(&pinched), Err(CapError::Crossing { .. })));
    }
}
