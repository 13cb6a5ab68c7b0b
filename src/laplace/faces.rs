//! The unit square and the unit cube with a constant on each side or face, exactly.
//!
//! The solution at a point is the mean of the constants over where a particle that wanders from the point leaves the body. Its coordinates wander
//! apart from each other, so that at each time there is a product of one function for each axis: how likely it is still between the two ends, or
//! how fast it leaves through one. Each of them is a series of images for short times and one of waves for long times, and what remains is an
//! integral over the logarithm of the time, which the trapezoidal rule does to rounding.

use glam::DVec3;
use std::f64::consts::PI;

/// Steps of the logarithm of time: the rule's error is about exp(-pi^2/step).
const STEP: f64 = 0.25;
/// Time from which waves take over from images; both are exact to rounding there, with the terms below.
const LATE: f64 = 0.02;
/// Last image to either side.
const IMAGES: i32 = 3;
/// Last wave.
const WAVES: i32 = 15;
/// Nearest that a point may be to a face that it is not on.
const NEAREST: f64 = 1e-9;
/// Where the error function is 1 or -1 to rounding.
const SATURATED: f64 = 6.0;

/// The error function, by a series of terms of one sign.
fn erf(x: f64) -> f64 {
    if x.abs() > SATURATED {
        return x.signum();
    }
    let (mut term, mut sum, mut n) = (x, x, 1.0);
    while term.abs() > 1e-17 * sum.abs() {
        term *= 2.0 * x * x / (2.0 * n + 1.0);
        sum += term;
        n += 1.0;
    }
    2.0 / PI.sqrt() * (-x * x).exp() * sum
}

/// How likely a particle from x is between 0 and 1 all the time up to t.
fn stays(x: f64, t: f64) -> f64 {
    if t >= LATE {
        let wave = |m: i32| {
            let k = f64::from(m) * PI;
            4.0 / k * (k * x).sin() * (-k * k * t).exp()
        };
        return (1..=WAVES).step_by(2).map(wave).sum();
    }
    let width = (4.0 * t).sqrt();
    let image = |k: i32| {
        let part = erf((f64::from(k + 1) - x) / width) - erf((f64::from(k) - x) / width);
        if k % 2 == 0 { part } else { -part }
    };
    (-IMAGES..=IMAGES).map(image).sum::<f64>() / 2.0
}

/// How fast a particle from x passes the end at 1 at time t without having met an end before.
fn passes(x: f64, t: f64) -> f64 {
    if t >= LATE {
        let wave = |m: i32| {
            let k = f64::from(m) * PI;
            let part = 2.0 * k * (k * x).sin() * (-k * k * t).exp();
            if m % 2 == 1 { part } else { -part }
        };
        return (1..=WAVES).map(wave).sum();
    }
    let image = |k: i32| {
        let away = 2.0 * f64::from(k) + 1.0 - x;
        away * (-away * away / (4.0 * t)).exp()
    };
    (-IMAGES..=IMAGES).map(image).sum::<f64>() / (4.0 * PI * t * t * t).sqrt()
}

/// How likely a particle leaves through the lower and the upper end of each axis; those of all axes sum to 1. `dimension` is 2 or 3, and the
/// coordinates are from 0 to 1.
#[must_use]
pub fn leaving(point: DVec3, dimension: usize) -> [[f64; 2]; 3] {
    let point = &point.to_array()[..dimension];
    let mut shares = [[0.0; 2]; 3];
    let end = |x: f64| x.min(1.0 - x);
    let nearest = point.iter().copied().map(end).fold(1.0, f64::min);
    if nearest < NEAREST {
        let axis = point.iter().position(|x| end(*x) == nearest).unwrap_or(0);
        shares[axis][usize::from(point[axis] > 0.5)] = 1.0;
        return shares;
    }
    // Before and after there is less than rounding: exp(-38).
    let [first, last] = [nearest * nearest / 152.0, 38.0 / (PI * PI * dimension as f64)].map(f64::ln);
    for k in 0..=((last - first) / STEP).ceil() as usize {
        let t = (first + STEP * k as f64).exp();
        for (axis, x) in point.iter().enumerate() {
            let others = point.iter().enumerate().filter(|(other, _)| *other != axis);
            let weight = STEP * t * others.map(|(_, other)| stays(*other, t)).product::<f64>();
            shares[axis][0] += weight * passes(1.0 - x, t);
            shares[axis][1] += weight * passes(*x, t);
        }
    }
    shares
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sinh_share(g: f64, z: f64) -> f64 {
        ((g * (z - 1.0)).exp() - (-g * (z + 1.0)).exp()) / (1.0 - (-2.0 * g).exp())
    }

    /// The share of the upper face by the double series of the paper, slow beside it.
    fn series(p: DVec3) -> f64 {
        let odd = || (1..120).step_by(2).map(f64::from);
        let term = |m: f64, n: f64| {
            16.0 / (PI * PI * m * n)
                * (m * PI * p.x).sin()
                * (n * PI * p.y).sin()
                * sinh_share(PI * m.hypot(n), p.z)
        };
        odd().map(|m| odd().map(|n| term(m, n)).sum::<f64>()).sum()
    }

    #[test]
    fn the_error_function_has_its_published_values() {
        for (x, value) in [(0.0, 0.0), (0.5, 0.520_499_877_813_046_5), (2.0, 0.995_322_265_018_952_7)] {
            assert!((erf(x) - value).abs() < 1e-15 && (erf(-x) + value).abs() < 1e-15);
        }
    }

    #[test]
    fn images_and_waves_agree_where_one_takes_over() {
        for x in [0.01, 0.3, 0.5, 0.98] {
            let [before, after] = [LATE * (1.0 - 1e-12), LATE];
            assert!((stays(x, before) - stays(x, after)).abs() < 1e-10);
            assert!((passes(x, before) - passes(x, after)).abs() < 1e-9);
        }
    }

    /// The cube of Fig. 13 on its axis: 1 above, one half below, 0 at the sides; the values stand in the notes on the method.
    #[test]
    fn the_cube_has_the_values_of_its_series() {
        let axis = [
            (0.1, 0.397_624_538_404_640),
            (0.25, 0.280_059_812_031_930),
            (0.5, 0.25),
            (0.75, 0.483_595_016_951_470),
            (0.9, 0.769_167_292_367_583),
        ];
        for (z, value) in axis {
            let [_, _, [below, above]] = leaving(DVec3::new(0.5, 0.5, z), 3);
            assert!((above + below / 2.0 - value).abs() < 1e-12, "at {z}");
        }
        for p in [DVec3::new(0.3, 0.6, 0.7), DVec3::new(0.05, 0.9, 0.4)] {
            assert!((leaving(p, 3)[2][1] - series(p)).abs() < 1e-12);
        }
    }

    #[test]
    fn the_square_has_the_values_of_its_series() {
        for (x, y) in [(0.3, 0.7), (0.02, 0.5)] {
            let term = |m: f64| 4.0 / (PI * m) * (m * PI * x).sin() * sinh_share(m * PI, y);
            let series: f64 = (1..400).step_by(2).map(|m| term(f64::from(m))).sum();
            assert!((leaving(DVec3::new(x, y, 0.0), 2)[1][1] - series).abs() < 1e-12);
        }
        let middle = leaving(DVec3::new(0.5, 0.5, 0.0), 2);
        assert!(middle[..2].iter().flatten().all(|share| (share - 0.25).abs() < 1e-14));
    }

    #[test]
    fn a_particle_leaves_somewhere_even_from_a_corner() {
        for p in [DVec3::splat(0.5), DVec3::new(1e-6, 1.0 - 1e-5, 1e-3), DVec3::new(0.5, 1e-8, 0.2)] {
            for dimension in [2, 3] {
                let sum: f64 = leaving(p, dimension).iter().flatten().sum();
                assert!((sum - 1.0).abs() < 1e-11, "{p}: {sum}");
            }
        }
        assert_eq!(leaving(DVec3::new(0.2, 0.7, 1.0), 3)[2], [0.0, 1.0]);
        assert_eq!(leaving(DVec3::new(0.0, 0.7, 0.4), 3)[0], [1.0, 0.0]);
    }
}
