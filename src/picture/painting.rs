//! The pixel painter: a picture, strip by strip.

use super::shape::{Shape, shapes};
use super::strip::Strip;
use super::{DisplayList, PaintError, Viewport};
use crate::material::Color;

/// Pixels of a strip, about: the fewer, the sooner a painting can be given up, and the better its pixels stay in the cache.
const STRIP: usize = 1 << 18;

/// A picture under way: the iterator yields its strips from the top, each as straight (not premultiplied) RGBA, eight bits each, row by
/// row.
///
/// The result is the same on every run. What lies outside the picture is cut early, so cost follows what shows; a strip takes a few milliseconds.
pub struct Painting {
    shapes: Vec<Shape>,
    background: Option<Color>,
    width: usize,
    height: usize,
    /// Rows in a strip.
    step: usize,
    /// Rows painted.
    done: usize,
}

impl Painting {
    /// Places a picture on its pixels.
    ///
    /// # Errors
    /// A side of 0 or above 4096 pixels, an unusable viewport, and items with numbers that cannot be drawn (not finite, opacities outside 0 to
    /// 1, widths above 1000 pixels) or meshes whose parts do not fit together.
    pub fn new(list: &DisplayList, viewport: &Viewport) -> Result<Self, PaintError> {
        viewport.check()?;
        for layer in &list.layers {
            layer.items.iter().try_for_each(|item| item.check(&layer.name))?;
        }
        let items = list.layers.iter().flat_map(|layer| &layer.items);
        let (width, height) = (viewport.width as usize, viewport.height as usize);
        Ok(Self {
            shapes: items.flat_map(|item| shapes(item, viewport)).collect(),
            background: list.background,
            width,
            height,
            step: (STRIP / width).max(1),
            done: 0,
        })
    }

    /// The share of the picture that is painted, 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.done as f64 / self.height as f64
    }
}

impl Iterator for Painting {
    type Item = Vec<u8>;

    fn next(&mut self) -> Option<Vec<u8>> {
        let rows = self.done..self.height.min(self.done + self.step);
        if rows.is_empty() {
            return None;
        }
        self.done = rows.end;
        let mut strip = Strip::new(self.width, rows, self.background);
        self.shapes.iter().for_each(|shape| strip.paint(shape));
        Some(strip.finish())
    }
}

/// Paints a whole picture at once: straight (not premultiplied) RGBA, eight bits each, row by row from the top.
///
/// # Errors
/// Those of [`Painting::new`].
pub fn paint(list: &DisplayList, viewport: &Viewport) -> Result<Vec<u8>, PaintError> {
    let painting = Painting::new(list, viewport)?;
    let mut data = Vec::with_capacity(painting.width * painting.height * 4);
    painting.for_each(|strip| data.extend_from_slice(&strip));
    Ok(data)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use glam::DVec2;

    use super::super::{Item, Mesh, Path, StrokeStyle, Theme};
    use super::*;

    const VIEW: Viewport =
        Viewport { width: 90, height: 130, center: DVec2::ZERO, scale: 1.0, pixel_ratio: 1.5 };

    fn ring(radius: f64, count: usize) -> Vec<DVec2> {
        (0..count).map(|k| radius * DVec2::from_angle(TAU * k as f64 / count as f64)).collect()
    }

    /// Every kind of item, a band thinner than a pixel among them.
    fn list(background: Option<Color>) -> DisplayList {
        let theme = Theme::light();
        let mut list = DisplayList::new(background);
        list.push("grid", Item::Grid { minor: theme.grid_minor, major: theme.grid_major });
        for (inner, outer) in [(20.0, 41.0), (60.0, 60.3)] {
            let rings = vec![ring(inner, 60), ring(outer, 60)];
            let colors = [Color::new(0xf0, 0xe4, 0x42), Color::new(0, 0x72, 0xb2), Color::new(0, 0x9e, 0x73)];
            let mesh = Mesh {
                vertices: rings.concat(),
                colors: (0..120).map(|k| colors[k % 3].to_oklab()).collect(),
                triangles: (0..60_u32)
                    .flat_map(|k| {
                        let next = (k + 1) % 60;
                        [[k, next, k + 60], [next, next + 60, k + 60]]
                    })
                    .collect(),
            };
            list.push("mesh", Item::Mesh { mesh, outline: Path { rings, closed: true }, opacity: 0.9 });
        }
        let star = Path::closed(ring(50.0, 5));
        list.push("fill", Item::Fill { path: star.clone(), color: theme.sample, opacity: 0.4 });
        list.push("line", Item::Stroke { path: star.clone(), style: theme.boundary });
        let wide = StrokeStyle::solid(11.0, theme.sample, 0.5).dashed(13.0, 7.0);
        list.push("dashes", Item::Stroke { path: star, style: wide });
        let centers = ring(30.0, 7);
        list.push(
            "dots",
            Item::Dots { centers: centers.clone(), radius_px: 4.0, color: theme.sample, opacity: 1.0 },
        );
        list.push("rings", Item::Rings { centers: centers.clone(), radius_px: 9.0, style: theme.error });
        list.push("crosses", Item::Crosses { centers, size_px: 9.0, style: theme.error });
        list
    }

    #[test]
    fn strips_of_any_height_make_the_same_picture() {
        for list in [list(None), list(Some(Color::new(255, 255, 255)))] {
            let whole = paint(&list, &VIEW).expect("a picture");
            for step in [1, 7, 50, 129] {
                let painting = Painting { step, ..Painting::new(&list, &VIEW).expect("a picture") };
                let strips: Vec<Vec<u8>> = painting.collect();
                assert_eq!(strips.len(), 130_usize.div_ceil(step));
                let data = strips.concat();
                let apart = whole.iter().zip(&data).position(|(a, b)| a != b);
                assert_eq!((data.len(), apart), (whole.len(), None), "strips of {step}");
            }
        }
    }

    #[test]
    fn progress_goes_from_nothing_to_all() {
        let viewport = Viewport { height: 4000, width: 200, ..VIEW };
        let mut painting = Painting::new(&list(None), &viewport).expect("a picture");
        assert_eq!(painting.progress(), 0.0);
        let mut last = 0.0;
        while let Some(strip) = painting.next() {
            assert_eq!(strip.len() % 800, 0);
            assert!(painting.progress() > last);
            last = painting.progress();
        }
        assert_eq!(last, 1.0);
        assert_eq!(painting.next(), None);
    }
}
