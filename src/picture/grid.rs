//! The coordinate grid, whose step follows the zoom.

use super::Viewport;

/// Least distance of minor grid lines, in CSS pixels: the step is the smallest of 1, 2, 5 times a power of ten that keeps it,
/// so lines are 48 to 120 CSS pixels apart.
const LEAST_DISTANCE: f64 = 48.0;

/// Steps of a grid, in document units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GridStep {
    /// From one line to the next.
    pub minor: f64,
    /// From one strong line to the next, a multiple of `minor`.
    pub major: f64,
}

/// A grid line across the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct GridLine {
    /// Its place along the other axis, in device pixels.
    pub(super) at: f64,
    /// Whether it is a strong one.
    pub(super) major: bool,
}

/// The steps of the grid in a view: the minor one is 1, 2 or 5 times a power of ten and 48 to 120 CSS pixels long, the
/// major one is 5, 10 or 20 times that power.
#[must_use]
pub fn grid_step(viewport: &Viewport) -> GridStep {
    let least = LEAST_DISTANCE * viewport.pixel_ratio / viewport.scale;
    let exponent = least.log10().floor() as i32;
    // The second decade covers a logarithm that rounding has put one too low.
    for power in [exponent, exponent + 1] {
        for (factor, multiple) in [(1, 5), (2, 5), (5, 4)] {
            let minor = decimal(factor, power);
            if minor >= least {
                return GridStep { minor, major: decimal(factor * multiple, power) };
            }
        }
    }
    GridStep { minor: decimal(1, exponent + 2), major: decimal(5, exponent + 2) }
}

/// The lines across the picture at constant x, then those at constant y.
pub(super) fn grid_lines(viewport: &Viewport) -> [Vec<GridLine>; 2] {
    let step = grid_step(viewport);
    let every = (step.major / step.minor).round();
    let visible = viewport.visible();
    let across = |low: f64, high: f64, place: &dyn Fn(f64) -> f64| {
        let first = (low / step.minor).ceil();
        // Positions far from the origin cannot be told apart any more; the count bounds the loop there.
        let count = ((high - low) / step.minor) as usize + 1;
        (0..count)
            .map(|i| first + i as f64)
            .map(|i| GridLine { at: place(i * step.minor), major: i.rem_euclid(every) == 0.0 })
            .collect()
    };
    let x = |at| viewport.to_pixels(glam::DVec2::new(at, 0.0)).x;
    let y = |at| viewport.to_pixels(glam::DVec2::new(0.0, at)).y;
    [across(visible.min.x, visible.max.x, &x), across(visible.min.y, visible.max.y, &y)]
}

/// `factor` times ten to the power, as near as a decimal literal would be.
fn decimal(factor: u32, power: i32) -> f64 {
    if power < 0 {
        f64::from(factor) / 10.0_f64.powi(-power)
    } else {
        f64::from(factor) * 10.0_f64.powi(power)
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;

    fn view(scale: f64, pixel_ratio: f64) -> Viewport {
        Viewport { width: 800, height: 600, center: DVec2::ZERO, scale, pixel_ratio }
    }

    #[test]
    fn steps_of_a_few_zooms() {
        for (scale, ratio, minor, major) in [
            (7.0, 1.0, 10.0, 50.0),
            (7.0, 2.0, 20.0, 100.0),
            (48.0, 1.0, 1.0, 5.0),
            (47.0, 1.0, 2.0, 10.0),
            (480.0, 1.0, 0.1, 0.5),
            (100.0, 1.0, 0.5, 2.0),
            (20.0, 1.0, 5.0, 20.0),
        ] {
            assert_eq!(grid_step(&view(scale, ratio)), GridStep { minor, major }, "{scale} {ratio}");
        }
    }

    #[test]
    fn lines_keep_their_distance_at_every_zoom() {
        for i in 0..600 {
            let view = view(10.0_f64.powf(f64::from(i) / 20.0 - 15.0), 1.0);
            let step = grid_step(&view);
            let pixels = step.minor * view.scale;
            assert!((47.999..=120.001).contains(&pixels), "{pixels} at {}", view.scale);
            let ratio = step.major / step.minor;
            assert!((ratio - ratio.round()).abs() < 1e-9);
            let [x, _] = grid_lines(&view);
            assert!((6..=18).contains(&x.len()), "{}", x.len());
        }
    }

    #[test]
    fn far_from_the_origin_the_number_of_lines_stays_bounded() {
        let far = Viewport { center: DVec2::splat(1e15), scale: 1e9, ..view(1.0, 1.0) };
        let [x, y] = grid_lines(&far);
        assert!(x.len() < 40 && y.len() < 40);
    }
}
