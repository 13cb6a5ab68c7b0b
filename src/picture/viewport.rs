//! Which part of the plane a picture shows, and how large.

use glam::DVec2;

use super::PaintError;
use crate::geom::Bounds;

/// Longest side of a picture, in device pixels. A square of it takes 64 MB.
pub(super) const MAX_SIDE: u32 = 4096;

/// Scales that [`Viewport::fit`] chooses from, in device pixels per unit; the widest that a document of coordinates up to
/// 1e12 can need.
const FIT_SCALES: (f64, f64) = (1e-12, 1e12);

/// Pixels farther than this from the corner of the picture are moved to this distance, so that products of
/// coordinates stay finite. No picture can tell: a line would have to span 1e15 pixels to turn visibly.
const REACH: f64 = 1e15;

/// Which part of the plane a picture shows. Document units with y up; pixels with y down from the upper left corner, the
/// centre of the first pixel at (0.5, 0.5).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Viewport {
    /// Width in device pixels, 1 to 4096.
    pub width: u32,
    /// Height in device pixels, 1 to 4096.
    pub height: u32,
    /// The point in the middle of the picture, in document units.
    pub center: DVec2,
    /// Device pixels per document unit, positive.
    pub scale: f64,
    /// Device pixels per CSS pixel, 0.1 to 16: strokes, dots and dashes grow with it.
    pub pixel_ratio: f64,
}

/// Room to leave free along the sides of a picture, in CSS pixels.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Margins {
    /// Along the left side.
    pub left: f64,
    /// Along the right side.
    pub right: f64,
    /// Along the top.
    pub top: f64,
    /// Along the bottom.
    pub bottom: f64,
}

impl Margins {
    /// The same room on all sides.
    #[must_use]
    pub const fn all(room: f64) -> Self {
        Self { left: room, right: room, top: room, bottom: room }
    }
}

impl Viewport {
    /// The largest view that shows the whole box in the middle of the room the margins leave.
    ///
    /// `width` and `height` are in device pixels, the margins in CSS pixels. Margins that leave less than a quarter of a
    /// side are shrunk together until they do. A box without extent is shown one unit wide.
    #[must_use]
    pub fn fit(bounds: Bounds, width: u32, height: u32, pixel_ratio: f64, margins: Margins) -> Self {
        let (left, room_x) = room(f64::from(width), margins.left * pixel_ratio, margins.right * pixel_ratio);
        let (top, room_y) = room(f64::from(height), margins.top * pixel_ratio, margins.bottom * pixel_ratio);
        let size = bounds.max - bounds.min;
        let size = if size.max_element() > 0.0 { size } else { DVec2::ONE };
        let scale = (room_x / size.x).min(room_y / size.y).clamp(FIT_SCALES.0, FIT_SCALES.1);
        let shift = DVec2::new(
            left + room_x / 2.0 - f64::from(width) / 2.0,
            f64::from(height) / 2.0 - (top + room_y / 2.0),
        );
        Self { width, height, center: bounds.center() - shift / scale, scale, pixel_ratio }
    }

    /// Where a point of the plane lies on the picture, in device pixels.
    #[must_use]
    pub fn to_pixels(&self, point: DVec2) -> DVec2 {
        let offset = (point - self.center) * self.scale;
        self.middle() + DVec2::new(offset.x, -offset.y)
    }

    /// Which point of the plane a place on the picture shows.
    #[must_use]
    pub fn to_units(&self, pixels: DVec2) -> DVec2 {
        let offset = (pixels - self.middle()) / self.scale;
        self.center + DVec2::new(offset.x, -offset.y)
    }

    /// The part of the plane that the picture shows.
    #[must_use]
    pub fn visible(&self) -> Bounds {
        let half = self.middle() / self.scale;
        Bounds { min: self.center - half, max: self.center + half }
    }

    /// [`Self::to_pixels`] with far points moved to a finite distance.
    pub(super) fn place(&self, point: DVec2) -> DVec2 {
        self.to_pixels(point).clamp(DVec2::splat(-REACH), DVec2::splat(REACH))
    }

    /// Refuses sizes and numbers that no picture can be painted with.
    pub(super) fn check(&self) -> Result<(), PaintError> {
        let sides = 1..=MAX_SIDE;
        if !sides.contains(&self.width) || !sides.contains(&self.height) {
            return Err(PaintError::Size { width: self.width, height: self.height });
        }
        let refuse = |field, value, expected| Err(PaintError::View { field, value, expected });
        for (field, value) in [("center x", self.center.x), ("center y", self.center.y)] {
            if !(-REACH..=REACH).contains(&value) {
                return refuse(field, value, "a number of at most 1e15 either way");
            }
        }
        if !(1e-15..=1e15).contains(&self.scale) {
            return refuse("scale", self.scale, "1e-15 to 1e15 device pixels per unit");
        }
        if !(0.1..=16.0).contains(&self.pixel_ratio) {
            return refuse("pixel ratio", self.pixel_ratio, "0.1 to 16 device pixels per CSS pixel");
        }
        Ok(())
    }

    fn middle(&self) -> DVec2 {
        DVec2::new(f64::from(self.width), f64::from(self.height)) / 2.0
    }
}

/// Where the free room along one side starts, and how long it is.
fn room(side: f64, before: f64, after: f64) -> (f64, f64) {
    let (before, after) = (before.max(0.0), after.max(0.0));
    let most = 0.75 * side;
    let shrink = if before + after > most { most / (before + after) } else { 1.0 };
    (before * shrink, side - (before + after) * shrink)
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOX: Bounds = Bounds { min: DVec2::new(-10.0, -5.0), max: DVec2::new(30.0, 5.0) };

    #[test]
    fn y_points_up_and_the_round_trip_is_exact() {
        let view =
            Viewport { width: 800, height: 600, center: DVec2::new(3.0, -2.0), scale: 4.0, pixel_ratio: 1.0 };
        assert_eq!(view.to_pixels(DVec2::new(3.0, -2.0)), DVec2::new(400.0, 300.0));
        assert_eq!(view.to_pixels(DVec2::new(4.0, -1.0)), DVec2::new(404.0, 296.0));
        let p = DVec2::new(17.25, 8.5);
        assert_eq!(view.to_units(view.to_pixels(p)), p);
        assert_eq!(view.visible().max, view.to_units(DVec2::new(800.0, 0.0)));
    }

    #[test]
    fn fit_fills_the_room_and_keeps_the_margins() {
        let margins = Margins { left: 20.0, right: 60.0, top: 10.0, bottom: 30.0 };
        let view = Viewport::fit(BOX, 800, 600, 2.0, margins);
        let (low, high) = (view.to_pixels(BOX.min), view.to_pixels(BOX.max));
        assert!((low.x - 40.0).abs() < 1e-9 && (high.x - 680.0).abs() < 1e-9);
        let middle = (low.y + high.y) / 2.0;
        assert!((middle - (20.0 + 540.0) / 2.0).abs() < 1e-9);
    }

    #[test]
    fn fit_of_odd_input_is_still_a_view() {
        let dot = Bounds { min: DVec2::ONE, max: DVec2::ONE };
        let views = [
            Viewport::fit(dot, 100, 50, 1.0, Margins::all(8.0)),
            Viewport::fit(BOX, 10, 10, 1.0, Margins::all(1e6)),
            Viewport::fit(
                Bounds { min: DVec2::ZERO, max: DVec2::new(0.0, 3.0) },
                10,
                10,
                1.0,
                Margins::all(-5.0),
            ),
        ];
        for view in views {
            assert_eq!(view.check(), Ok(()), "{view:?}");
        }
        assert!((views[2].scale - 10.0 / 3.0).abs() < 1e-12);
    }

    #[test]
    fn unusable_views_are_refused_by_name() {
        let good = Viewport::fit(BOX, 100, 100, 1.0, Margins::default());
        let size = Viewport { width: 0, ..good };
        assert_eq!(size.check(), Err(PaintError::Size { width: 0, height: 100 }));
        let large = Viewport { height: 4097, ..good };
        assert!(large.check().unwrap_err().to_string().contains("1 to 4096"));
        for scale in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let error = Viewport { scale, ..good }.check().unwrap_err();
            assert!(matches!(error, PaintError::View { field: "scale", .. }));
        }
        assert!(Viewport { center: DVec2::NAN, ..good }.check().is_err());
        assert!(Viewport { pixel_ratio: 0.0, ..good }.check().is_err());
    }
}
