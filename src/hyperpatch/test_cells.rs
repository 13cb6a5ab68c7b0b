//! Cells that tests know the answers for.

use super::Net;
use super::bernstein::flat;
use glam::{DMat2, DVec2, DVec3};
use std::f64::consts::TAU;

/// A number in [0, 1) that depends on the seed alone (splitmix64).
pub(super) fn random(seed: u64) -> f64 {
    let mut z = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15).wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
}

/// A place in the unit cube.
pub(super) fn random_place(seed: u64) -> DVec3 {
    DVec3::from_array([0, 1, 2].map(|n| random(seed * 3 + n + 1000)))
}

/// The unit cube with every control point moved by at most `jitter` along each axis.
pub(super) fn random_net(seed: u64, jitter: f64) -> Net {
    let cube = Net::cuboid(DVec3::ZERO, DVec3::ONE);
    let offset = |n: usize| (random_place(seed * 64 + n as u64) * 2.0 - DVec3::ONE) * jitter;
    Net(std::array::from_fn(|n| cube.0[n] + offset(n)))
}

/// Cell `index` of a ring of `count` about the z axis: u runs round, v from the outer to the inner radius, w upwards.
pub(super) fn ring_cell(count: usize, index: usize, inner: f64, outer: f64, height: f64) -> Net {
    let angle = TAU / count as f64;
    let kappa = 4.0 / 3.0 * (angle / 4.0).tan();
    let [start, end] = [index, (index + 1) % count].map(|n| DVec2::from_angle(angle * n as f64));
    let arc = [start, start + start.perp() * kappa, end - end.perp() * kappa, end];
    let mut points = [DVec3::ZERO; 64];
    for (i, direction) in arc.into_iter().enumerate() {
        for j in 0..4 {
            for k in 0..4 {
                let radius = outer + (inner - outer) * j as f64 / 3.0;
                points[flat(i, j, k)] = (direction * radius).extend(height * k as f64 / 3.0);
            }
        }
    }
    Net(points)
}

/// The first quarter of a ring of four.
pub(super) fn quarter_ring(inner: f64, outer: f64, height: f64) -> Net {
    ring_cell(4, 0, inner, outer, height)
}

/// A box [-1, 1] x [-1, 1] x [0, 2] whose layers are turned about z in even steps, by `degrees` in all.
pub(super) fn twisted(degrees: f64) -> Net {
    let cube = Net::cuboid(DVec3::new(-1.0, -1.0, 0.0), DVec3::new(1.0, 1.0, 2.0));
    Net(std::array::from_fn(|n| {
        let turn = DMat2::from_angle(degrees.to_radians() * (n % 4) as f64 / 3.0);
        (turn * cube.0[n].truncate()).extend(cube.0[n].z)
    }))
}

/// The unit cube whose inner control points are moved by `shift` against each other along x: its edges stay straight
/// and J is 1 at its corners.
pub(super) fn folded(shift: f64) -> Net {
    let mut net = Net::cuboid(DVec3::ZERO, DVec3::ONE);
    for (i, sign) in [(1, 1.0), (2, -1.0)] {
        for j in 1..3 {
            for k in 1..3 {
                net.0[flat(i, j, k)].x += sign * shift;
            }
        }
    }
    net
}

/// A thin bar along u that runs round a loop in the plane z = 0 and through itself.
pub(super) fn crossing_bar() -> Net {
    bar([DVec2::ZERO, DVec2::new(12.0, 8.0), DVec2::new(-6.0, 8.0), DVec2::new(6.0, 0.0)], 0.55)
}

/// A thin bar along u that runs round a loop to where it began, so that its two ends are one face.
pub(super) fn closed_bar() -> Net {
    bar([DVec2::ZERO, DVec2::new(12.0, 8.0), DVec2::new(-12.0, 8.0), DVec2::ZERO], 0.0)
}

/// A bar along a path that turns left all the way round; its ends lean outwards.
fn bar(path: [DVec2; 4], lean: f64) -> Net {
    let sides =
        [DVec2::new(-lean, 0.83), DVec2::new(-1.0, -0.9), DVec2::new(1.0, -0.9), DVec2::new(lean, 0.83)];
    let mut points = [DVec3::ZERO; 64];
    for i in 0..4 {
        for j in 0..4 {
            for k in 0..4 {
                let across = sides[i] * 0.2 * (j as f64 / 3.0 - 0.5);
                points[flat(i, j, k)] = (path[i] + across).extend(0.2 * k as f64 / 3.0);
            }
        }
    }
    Net(points)
}
