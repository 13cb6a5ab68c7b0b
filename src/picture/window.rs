//! A rectangle of pixels of a picture.

use std::ops::Range;

use glam::DVec2;

/// Columns and rows of a picture, counted from its upper left corner.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Window {
    pub(super) columns: Range<usize>,
    pub(super) rows: Range<usize>,
}

impl Window {
    /// All of a picture.
    pub(super) fn whole(width: u32, height: u32) -> Self {
        Self { columns: 0..width as usize, rows: 0..height as usize }
    }

    pub(super) fn width(&self) -> usize {
        self.columns.len()
    }

    pub(super) fn height(&self) -> usize {
        self.rows.len()
    }

    /// Number of pixels.
    pub(super) fn area(&self) -> usize {
        self.width() * self.height()
    }

    /// The upper left corner.
    pub(super) fn corner(&self) -> DVec2 {
        DVec2::new(self.columns.start as f64, self.rows.start as f64)
    }

    /// Place of a pixel in a buffer of the window, row by row.
    pub(super) fn index(&self, column: usize, row: usize) -> usize {
        (row - self.rows.start) * self.width() + column - self.columns.start
    }

    /// The part that points reach; `None` when they reach none.
    pub(super) fn around(&self, points: impl Iterator<Item = DVec2>) -> Option<Self> {
        let empty = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let (low, high) = points.fold(empty, |(low, high), p| (low.min(p), high.max(p)));
        let low = low.floor().max(self.corner());
        let high = high.ceil().min(DVec2::new(self.columns.end as f64, self.rows.end as f64));
        low.cmplt(high).all().then_some(Self {
            columns: low.x as usize..high.x as usize,
            rows: low.y as usize..high.y as usize,
        })
    }

    /// The part in some rows; `None` when there is none.
    pub(super) fn in_rows(&self, rows: Range<usize>) -> Option<Self> {
        let rows = rows.start.max(self.rows.start)..rows.end.min(self.rows.end);
        (!rows.is_empty()).then(|| Self { columns: self.columns.clone(), rows })
    }
}
