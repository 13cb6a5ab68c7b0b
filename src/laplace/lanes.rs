//! Integrals over one panel for several points at once, in single precision for vector units.
//!
//! What cancels is taken in double precision: where a point is in the coordinates of the panel, in units of its longest side. The rest keeps about seven
//! digits, so that pictures are those of the exact integrals right up to the boundary.

use super::cluster::Reach;
use super::panel::{Panel, Space};
use super::single::{LANES, angle, inverse_root, ln};
use glam::DVec3;
use std::array::from_fn;
use std::f32::consts::{PI, TAU};

/// Least square of a distance, in units of the longest side: on an end the logarithm is multiplied by 0, and must be finite.
const LEAST: f32 = 1e-30;

/// Area of a triangle, over the square of its longest side, below which solid angles are not taken in single precision.
const SLENDER: f64 = 0.05;

/// Points that are worked on together.
#[derive(Debug, Clone, Copy)]
pub(super) struct Points {
    x: [f64; LANES],
    y: [f64; LANES],
    z: [f64; LANES],
}

/// Both layers of a panel at these points.
#[derive(Debug, Clone, Copy)]
#[repr(align(32))]
pub(super) struct Lanes {
    pub(super) single: [f32; LANES],
    pub(super) double: [f32; LANES],
}

impl Points {
    pub(super) fn new(point: impl Fn(usize) -> DVec3) -> Self {
        let points: [DVec3; LANES] = from_fn(point);
        Self { x: points.map(|p| p.x), y: points.map(|p| p.y), z: points.map(|p| p.z) }
    }

    /// Places along a direction from an origin, over a length; those of the origin from the points where it is negative.
    #[inline(always)]
    fn along(&self, origin: DVec3, direction: DVec3, length: f64) -> [f32; LANES] {
        let unit = direction / length;
        from_fn(|l| {
            let [x, y, z] = [self.x[l] - origin.x, self.y[l] - origin.y, self.z[l] - origin.z];
            (x * unit.x + y * unit.y + z * unit.z) as f32
        })
    }

    /// The way to a place, over a length.
    #[inline(always)]
    fn to(&self, place: DVec3, length: f64) -> [[f32; LANES]; 3] {
        let share = 1.0 / length;
        [
            from_fn(|l| ((place.x - self.x[l]) * share) as f32),
            from_fn(|l| ((place.y - self.y[l]) * share) as f32),
            from_fn(|l| ((place.z - self.z[l]) * share) as f32),
        ]
    }

    fn point(&self, lane: usize) -> DVec3 {
        DVec3::new(self.x[lane], self.y[lane], self.z[lane])
    }
}

/// The layers of a panel at points, exact or by places that stand for it. In the plane the exact integrals cost hardly more than two places, and are taken
/// at medium distances too.
#[inline(always)]
pub(super) fn layers(space: Space, panel: &Panel, reach: Reach, points: &Points) -> Lanes {
    match (reach, space) {
        (Reach::Near | Reach::Medium, Space::Plane) => segment(panel, points),
        (Reach::Near, Space::Solid) if panel.size < SLENDER * panel.diameter * panel.diameter => {
            one_by_one(space, panel, points)
        }
        (Reach::Near, Space::Solid) => triangle(panel, points),
        (Reach::Medium, _) | (Reach::Far, Space::Plane) => {
            let mut sum = Lanes { single: [0.0; LANES], double: [0.0; LANES] };
            let count = space.places();
            for number in 0..count {
                place(space, space.place(panel, number), panel, panel.size / count as f64, points, &mut sum);
            }
            sum
        }
        (Reach::Far, _) => {
            let mut sum = Lanes { single: [0.0; LANES], double: [0.0; LANES] };
            place(space, panel.centre, panel, panel.size, points, &mut sum);
            sum
        }
    }
}

/// Adds the layers of a place that stands for a panel, or a part of it, of this size.
#[inline(always)]
fn place(space: Space, place: DVec3, panel: &Panel, size: f64, points: &Points, sum: &mut Lanes) {
    let [dx, dy, dz] = points.to(place, 1.0);
    let normal = panel.normal.as_vec3();
    let weight = size as f32 / if space == Space::Plane { TAU } else { 2.0 * TAU };
    for l in 0..LANES {
        let square = (dx[l] * dx[l] + dy[l] * dy[l] + dz[l] * dz[l]).max(LEAST);
        let across = weight * (dx[l] * normal.x + dy[l] * normal.y + dz[l] * normal.z);
        if space == Space::Plane {
            sum.single[l] -= 0.5 * weight * ln(square);
            sum.double[l] += across / square;
        } else {
            let near = inverse_root(square);
            sum.single[l] += weight * near;
            sum.double[l] += across * near * near * near;
        }
    }
}

/// As in `segment.rs`, with the length as the unit.
#[inline(always)]
fn segment(panel: &Panel, points: &Points) -> Lanes {
    let [from, to, _] = panel.corners;
    let along = (to - from) / panel.size;
    // Both ends are taken in double precision, because a point may be close to either of them.
    let ends = [from, to].map(|end| points.along(end, along, -panel.size));
    let heights = points.along(from, panel.normal, -panel.size);
    let weight = panel.size as f32 / TAU;
    let unit = panel.size.ln() as f32 - 1.0;
    let none = (panel.rounding() / panel.size) as f32;
    let mut lanes = Lanes { single: [0.0; LANES], double: [0.0; LANES] };
    for l in 0..LANES {
        let (a, b, height) = (ends[0][l], ends[1][l], heights[l]);
        let square = height * height;
        let turn = angle(height, a * b + square);
        let turn = if height.abs() <= none { 0.0 } else { turn };
        let logarithms = b * ln((b * b + square).max(LEAST)) - a * ln((a * a + square).max(LEAST));
        lanes.single[l] = -weight * (0.5 * logarithms + height * turn + unit);
        lanes.double[l] = turn / TAU;
    }
    lanes
}

/// As in `triangle.rs`, with the longest side as the unit.
#[inline(always)]
fn triangle(panel: &Panel, points: &Points) -> Lanes {
    let corners = panel.corners.map(|corner| points.to(corner, panel.diameter));
    let height = points.along(panel.corners[0], panel.normal, -panel.diameter);
    let twice = (2.0 * panel.size / (panel.diameter * panel.diameter)) as f32;
    let far: [[f32; LANES]; 3] =
        corners.map(|[x, y, z]| from_fn(|l| (x[l] * x[l] + y[l] * y[l] + z[l] * z[l]).sqrt()));
    let dot = |p: usize, q: usize, l: usize| {
        let ([a, b, c], [x, y, z]) = (&corners[p], &corners[q]);
        a[l] * x[l] + b[l] * y[l] + c[l] * z[l]
    };
    let mut lanes = Lanes { single: [0.0; LANES], double: [0.0; LANES] };
    let mut turns = [0.0; LANES];
    let none = (panel.rounding() / panel.diameter) as f32;
    for l in 0..LANES {
        let [a, b, c] = [far[0][l], far[1][l], far[2][l]];
        let below = a * b * c + dot(0, 1, l) * c + dot(1, 2, l) * a + dot(2, 0, l) * b;
        let turn = 2.0 * angle(height[l] * twice, below);
        turns[l] = if height[l].abs() <= none { 0.0 } else { turn };
    }
    let mut sums = [0.0; LANES];
    for k in 0..3 {
        let next = (k + 1) % 3;
        let side = panel.corners[next] - panel.corners[k];
        let length = side.length();
        let along = side / length;
        let past = points.along(panel.corners[k], along, -panel.diameter);
        let distance = points.along(panel.corners[k], along.cross(panel.normal), -panel.diameter);
        let length = (length / panel.diameter) as f32;
        for l in 0..LANES {
            let (a, b) = (past[l], past[l] + length);
            let square = (distance[l] * distance[l] + height[l] * height[l]).max(LEAST);
            let (over_a, over_b) = (far[k][l] + a.abs(), far[next][l] + b.abs());
            // The integral of 1/r along the side, in the form whose sums do not cancel.
            let over = if a >= 0.0 {
                over_b
            } else if b >= 0.0 {
                over_a * over_b
            } else {
                over_a
            };
            let under = if a >= 0.0 {
                over_a
            } else if b >= 0.0 {
                square
            } else {
                over_b
            };
            sums[l] += distance[l] * ln((over / under.max(LEAST)).max(LEAST));
        }
    }
    let weight = panel.diameter as f32 / (4.0 * PI);
    for l in 0..LANES {
        lanes.single[l] = weight * (sums[l] - height[l] * turns[l]);
        lanes.double[l] = turns[l] / (4.0 * PI);
    }
    lanes
}

/// In double precision, for triangles whose solid angles need it.
#[inline(never)]
fn one_by_one(space: Space, panel: &Panel, points: &Points) -> Lanes {
    let exact: [_; LANES] = from_fn(|lane| space.layers(panel, points.point(lane)));
    Lanes {
        single: exact.map(|layers| layers.single as f32),
        double: exact.map(|layers| layers.double as f32),
    }
}
