//! Flat elements of a boundary and what they do to a point.

use super::{segment, triangle};
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// Where a problem is posed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Space {
    /// In the plane z = 0; elements are segments.
    Plane,
    /// In space; elements are triangles.
    Solid,
}

/// A segment or a triangle with its outward normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Panel {
    /// Its ends or its corners, counter-clockwise from outside; the third of a segment is its second.
    pub corners: [DVec3; 3],
    /// Its middle or its centroid, where its equation is taken.
    pub centre: DVec3,
    /// Unit normal, outwards: to the right of the direction of a segment.
    pub normal: DVec3,
    /// Length or area.
    pub size: f64,
    /// Length of the longest side.
    pub diameter: f64,
}

/// Integrals over a panel for a point x, y on the panel and r = |y - x|.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Layers {
    /// Of the fundamental solution: 1/(4 pi r) in space, -ln r/(2 pi) in the plane.
    pub single: f64,
    /// Of minus its normal derivative: the solid angle over 4 pi, or the angle over 2 pi, under which the panel is seen; positive from inside, 0 in its own plane.
    pub double: f64,
}

/// Gradients of both integrals by the point.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct LayerGradients {
    /// Of the single layer.
    pub single: DVec3,
    /// Of the double layer.
    pub double: DVec3,
}

impl Space {
    /// 2 or 3.
    #[must_use]
    pub fn dimension(self) -> usize {
        match self {
            Self::Plane => 2,
            Self::Solid => 3,
        }
    }

    /// The panel with these corners.
    #[must_use]
    pub fn panel(self, corners: [DVec3; 3]) -> Panel {
        let [a, b, c] = corners;
        match self {
            Self::Plane => {
                let along = b - a;
                let size = along.length();
                let normal = DVec3::new(along.y, -along.x, 0.0) / size;
                Panel { corners: [a, b, b], centre: (a + b) / 2.0, normal, size, diameter: size }
            }
            Self::Solid => {
                let cross = (b - a).cross(c - a);
                let twice = cross.length();
                let diameter = [b - a, c - b, a - c].iter().map(|side| side.length()).fold(0.0, f64::max);
                Panel {
                    corners,
                    centre: (a + b + c) / 3.0,
                    normal: cross / twice,
                    size: twice / 2.0,
                    diameter,
                }
            }
        }
    }

    /// Both integrals over a panel, exact wherever the point is.
    #[must_use]
    pub fn layers(self, panel: &Panel, x: DVec3) -> Layers {
        match self {
            Self::Plane => segment::layers(panel, x),
            Self::Solid => triangle::layers(panel, x),
        }
    }

    /// Their gradients; the point must not be on a corner or a side.
    #[must_use]
    pub fn gradients(self, panel: &Panel, x: DVec3) -> LayerGradients {
        match self {
            Self::Plane => segment::gradients(panel, x),
            Self::Solid => triangle::gradients(panel, x),
        }
    }

    /// Gradients of both layers of a place at `r` from the point that stands for a panel, or a part of it, of this size.
    #[must_use]
    pub(super) fn point_gradients(self, r: DVec3, normal: DVec3, size: f64) -> [DVec3; 2] {
        let square = r.length_squared();
        let across = r.dot(normal);
        match self {
            Self::Plane => {
                let weight = size / (TAU * square);
                [r * weight, (r * (2.0 * across / square) - normal) * weight]
            }
            Self::Solid => {
                let weight = size / (4.0 * PI * square * square.sqrt());
                [r * weight, (r * (3.0 * across / square) - normal) * weight]
            }
        }
    }

    /// Number of places of the rule for medium distances: Gauss' two on a segment, three inside a triangle.
    #[must_use]
    pub fn places(self) -> usize {
        match self {
            Self::Plane => 2,
            Self::Solid => 3,
        }
    }

    /// A place of that rule; all have the same weight.
    #[must_use]
    pub fn place(self, panel: &Panel, number: usize) -> DVec3 {
        let [a, b, c] = panel.corners;
        match self {
            Self::Plane => {
                let share = if number == 0 { -1.0 } else { 1.0 } / 12.0_f64.sqrt();
                panel.centre + (b - a) * share
            }
            Self::Solid => {
                let corner = [a, b, c][number];
                (panel.centre + corner) / 2.0
            }
        }
    }
}

impl Panel {
    /// Height above the line or the plane of the panel that counts as none: what rounding makes of points on it. Small panels away from the origin have lost more.
    #[inline(always)]
    pub(super) fn rounding(&self) -> f64 {
        1e-14 * self.diameter + 4.0 * f64::EPSILON * self.corners[0].abs().max_element()
    }

    /// The point of the panel that is nearest to `x`.
    #[must_use]
    pub fn nearest(&self, x: DVec3) -> DVec3 {
        let [a, b, c] = self.corners;
        let inside = [(a, b), (b, c), (c, a)]
            .iter()
            .all(|(from, to)| (*to - *from).cross(x - *from).dot(self.normal) >= 0.0);
        if b != c && inside {
            return x - self.normal * (x - a).dot(self.normal);
        }
        let on_side = |(from, to): (DVec3, DVec3)| {
            let along = to - from;
            let length = along.length_squared();
            let share = if length > 0.0 { ((x - from).dot(along) / length).clamp(0.0, 1.0) } else { 0.0 };
            from + along * share
        };
        let sides = [(a, b), (b, c), (c, a)].map(on_side);
        let nearer = |p: DVec3, q: DVec3| if q.distance_squared(x) < p.distance_squared(x) { q } else { p };
        nearer(nearer(sides[0], sides[1]), sides[2])
    }
}
