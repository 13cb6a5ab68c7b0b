//! Solutions that are known.

use glam::{DVec2, DVec3};
use std::f64::consts::PI;

/// sinh(g z)/sinh(g), without overflow.
fn share(g: f64, z: f64) -> f64 {
    ((g * (z - 1.0)).exp() - (-g * (z + 1.0)).exp()) / (1.0 - (-2.0 * g).exp())
}

/// 1 on the face w = 1 of the cube and 0 on the others; slow beside that face.
fn face(u: f64, v: f64, w: f64) -> f64 {
    let mut sum = 0.0;
    for m in (1..160).step_by(2).map(f64::from) {
        for n in (1..160).step_by(2).map(f64::from) {
            let height = share(PI * m.hypot(n), w);
            if height < 1e-13 {
                break;
            }
            sum += 16.0 / (PI * PI * m * n) * (m * PI * u).sin() * (n * PI * v).sin() * height;
        }
    }
    sum
}

/// The cube of the paper's Fig. 13: 1 at z = 1, 0.5 at z = 0, 0 on four sides.
pub(super) fn cube(p: DVec3) -> f64 {
    let sides = || {
        [p, DVec3::new(p.y, p.x, p.z)]
            .iter()
            .map(|p| face(p.y, p.z, p.x) + face(p.y, p.z, 1.0 - p.x))
            .sum::<f64>()
    };
    let [top, bottom] = [p.z, 1.0 - p.z].map(|w| (w < 0.92).then(|| face(p.x, p.y, w)));
    // All six faces make 1, so that beside one the others say what it does.
    match (top, bottom) {
        (Some(top), Some(bottom)) => top + bottom / 2.0,
        (None, Some(bottom)) => 1.0 - sides() - bottom / 2.0,
        (Some(top), None) => top + (1.0 - sides() - top) / 2.0,
        (None, None) => unreachable!("no place is beside both"),
    }
}

/// The same for the square: 1 at y = 1, 0.5 at y = 0, 0 at the sides.
pub(super) fn square(p: DVec2) -> f64 {
    let term = |m: f64| {
        4.0 / (PI * m) * (m * PI * p.x).sin() * (share(m * PI, p.y) + share(m * PI, 1.0 - p.y) / 2.0)
    };
    (1..400).step_by(2).map(|m| term(f64::from(m))).sum()
}

/// The error function by its series.
fn erf(x: f64) -> f64 {
    if x.abs() > 4.5 {
        return x.signum();
    }
    let (mut term, mut sum) = (x, x);
    for n in 1..120 {
        term *= -x * x / f64::from(n);
        sum += term / f64::from(2 * n + 1);
    }
    2.0 / PI.sqrt() * sum
}

/// The same as [`cube`] and [`square`], from images and time: where a particle that wanders from the point leaves the body. It is at time t still between two
/// walls with a probability that is a sum of error functions, and passes the upper end at a rate that is a sum of bells.
pub(super) fn wandering(sides: &[f64], z: f64) -> f64 {
    let mut sum = 0.0;
    let steps = 1500;
    let [from, to] = [1e-7_f64, 4.0].map(f64::ln);
    for k in 0..=steps {
        let t = (from + (to - from) * f64::from(k) / f64::from(steps)).exp();
        let width = (4.0 * t).sqrt();
        let stays = |x: f64| -> f64 {
            let image = |k: i32| {
                let k_f = f64::from(k);
                let part = erf((k_f + 1.0 - x) / width) - erf((k_f - x) / width);
                if k % 2 == 0 { part } else { -part }
            };
            0.5 * (-24..=24).map(image).sum::<f64>()
        };
        let passes = |z: f64| -> f64 {
            let image = |k: i32| {
                let away = 2.0 * f64::from(k) + 1.0 - z;
                away * (-away * away / (4.0 * t)).exp() / (4.0 * PI * t * t * t).sqrt()
            };
            (-12..=12).map(image).sum()
        };
        let all: f64 = sides.iter().map(|x| stays(*x)).product();
        // Integrated over the logarithm of the time.
        sum += t * all * (passes(z) + passes(1.0 - z) / 2.0);
    }
    sum * (to - from) / f64::from(steps)
}

#[test]
fn the_series_is_what_wandering_gives_and_has_the_published_values() {
    let axis = [
        (0.1, 0.397_624_538_404_640),
        (0.25, 0.280_059_812_031_930),
        (0.5, 0.25),
        (0.75, 0.483_595_016_951_470),
        (0.9, 0.769_167_292_367_583),
    ];
    for (z, expected) in axis {
        assert!((cube(DVec3::new(0.5, 0.5, z)) - expected).abs() < 1e-9, "at {z}");
    }
    for p in [DVec3::new(0.3, 0.6, 0.7), DVec3::new(0.15, 0.8, 0.2)] {
        assert!((wandering(&[p.x, p.y], p.z) - cube(p)).abs() < 1e-7);
        assert!((wandering(&[p.x], p.y) - square(DVec2::new(p.x, p.y))).abs() < 1e-7);
    }
}
