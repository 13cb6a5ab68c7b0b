//! A uniform grid over segments, to find those near a query segment.

use super::Bounds;
use glam::DVec2;

/// Segments sorted into the square cells of a uniform grid.
///
/// A query visits every segment that may meet the query segment, in no particular order and some more than once; a segment
/// that it does not visit certainly does not meet it (cells are entered with a margin above rounding error).
#[derive(Debug, Clone)]
pub struct SegmentGrid {
    segments: Vec<(DVec2, DVec2)>,
    origin: DVec2,
    cells_per_unit: f64,
    columns: usize,
    rows: usize,
    /// Where the list of each cell starts in `entries`; one more than there are cells.
    starts: Vec<u32>,
    entries: Vec<u32>,
}

/// Most cells along one side: keeps the memory of a grid below a megabyte whatever the segments are.
const MOST_CELLS_PER_SIDE: f64 = 256.0;
/// Widening of every traversal in cells: far above rounding error (about 1e-13 cells), far below a cell.
const MARGIN: f64 = 1e-6;

impl SegmentGrid {
    /// Sorts segments into a grid with about two cells per segment.
    #[must_use]
    pub fn new(segments: Vec<(DVec2, DVec2)>) -> Self {
        let bounds = Bounds::of(segments.iter().flat_map(|&(a, b)| [a, b]))
            .unwrap_or(Bounds { min: DVec2::ZERO, max: DVec2::ZERO });
        let size = bounds.max - bounds.min;
        let side = (2.0 * segments.len() as f64).sqrt().ceil().clamp(1.0, MOST_CELLS_PER_SIDE);
        let longest = size.max_element();
        let cells_per_unit = if longest > 0.0 { side / longest } else { 1.0 };
        let count = |length: f64| (length * cells_per_unit).floor() as usize + 1;
        let (columns, rows) = (count(size.x), count(size.y));
        let mut grid = Self {
            segments,
            origin: bounds.min,
            cells_per_unit,
            columns,
            rows,
            starts: vec![0; columns * rows + 1],
            entries: Vec::new(),
        };
        grid.fill();
        grid
    }

    /// Returns a segment, by index, near the segment `a b` for which `accept(index, start, end)` holds; `None` when there is
    /// none among those that may meet it.
    pub fn find(
        &self,
        a: DVec2,
        b: DVec2,
        mut accept: impl FnMut(usize, DVec2, DVec2) -> bool,
    ) -> Option<usize> {
        self.spans(a, b).find_map(|(row, first, last)| {
            let (start, end) = (row * self.columns + first, row * self.columns + last + 1);
            let range = self.starts[start] as usize..self.starts[end] as usize;
            self.entries[range].iter().map(|&k| k as usize).find(|&k| {
                let (c, d) = self.segments[k];
                accept(k, c, d)
            })
        })
    }

    /// Returns the segments in the order given.
    #[must_use]
    pub fn segments(&self) -> &[(DVec2, DVec2)] {
        &self.segments
    }

    fn fill(&mut self) {
        let mut counts = vec![0_u32; self.columns * self.rows];
        for &(a, b) in &self.segments {
            for (row, first, last) in self.spans(a, b) {
                for cell in &mut counts[row * self.columns + first..=row * self.columns + last] {
                    *cell += 1;
                }
            }
        }
        let mut sum = 0;
        for (start, count) in self.starts.iter_mut().zip(counts.iter().chain(&[0])) {
            *start = sum;
            sum += count;
        }
        let mut next = self.starts.clone();
        let mut entries = vec![0; sum as usize];
        for (k, &(a, b)) in self.segments.iter().enumerate() {
            for (row, first, last) in self.spans(a, b) {
                for slot in &mut next[row * self.columns + first..=row * self.columns + last] {
                    entries[*slot as usize] = k as u32;
                    *slot += 1;
                }
            }
        }
        self.entries = entries;
    }

    /// Yields (row, first column, last column) of the cells that a segment passes through, with the margin.
    fn spans(&self, a: DVec2, b: DVec2) -> impl Iterator<Item = (usize, usize, usize)> + use<> {
        let to_cells = |p: DVec2| (p - self.origin) * self.cells_per_unit;
        let (a, b) = (to_cells(a), to_cells(b));
        let (low, high) = if a.y <= b.y { (a, b) } else { (b, a) };
        let (columns, rows) = (self.columns, self.rows);
        let slope = (high.x - low.x) / (high.y - low.y);
        let index = move |value: f64, count: usize| (value.max(0.0) as usize).min(count - 1);
        let x_at = move |y: f64| {
            let x = low.x + (y - low.y) * slope;
            if x.is_finite() { x } else { low.x }
        };
        let outside = high.y < -MARGIN || low.y > rows as f64 + MARGIN;
        let last_row = index(high.y + MARGIN, rows);
        let first_row = if outside { last_row + 1 } else { index(low.y - MARGIN, rows) };
        let flat = high.y - low.y <= MARGIN;
        (first_row..=last_row).map(move |row| {
            let (bottom, top) = (row as f64 - MARGIN, (row + 1) as f64 + MARGIN);
            let (x0, x1) = if flat {
                (low.x, high.x)
            } else {
                (x_at(bottom.clamp(low.y, high.y)), x_at(top.clamp(low.y, high.y)))
            };
            (row, index(x0.min(x1) - MARGIN, columns), index(x0.max(x1) + MARGIN, columns))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::segments_meet;
    use super::*;
    use glam::dvec2;

    /// A small generator (Marsaglia's xorshift), so that the case repeats.
    struct Numbers(u64);

    impl Numbers {
        fn next(&mut self) -> f64 {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            (self.0 >> 11) as f64 / (1_u64 << 53) as f64
        }

        fn point(&mut self, lattice: bool) -> DVec2 {
            let p = dvec2(self.next(), self.next()) * 10.0;
            if lattice { p.round() } else { p }
        }
    }

    #[test]
    fn finds_the_same_contacts_as_looking_at_every_segment() {
        for lattice in [false, true] {
            let mut numbers = Numbers(88);
            let segments: Vec<_> =
                (0..60).map(|_| (numbers.point(lattice), numbers.point(lattice) * 0.9)).collect();
            let grid = SegmentGrid::new(segments.clone());
            for _ in 0..400 {
                let (a, b) = (numbers.point(lattice) * 1.4 - 2.0, numbers.point(lattice) * 1.4 - 2.0);
                let mut met: Vec<usize> = Vec::new();
                grid.find(a, b, |k, c, d| {
                    if segments_meet(a, b, c, d) {
                        met.push(k);
                    }
                    false
                });
                met.sort_unstable();
                met.dedup();
                let all: Vec<usize> = (0..segments.len())
                    .filter(|&k| segments_meet(a, b, segments[k].0, segments[k].1))
                    .collect();
                assert_eq!(met, all, "lattice {lattice}, query {a} to {b}");
            }
        }
    }

    #[test]
    fn no_segments_and_a_single_point_are_fine() {
        let empty = SegmentGrid::new(Vec::new());
        assert_eq!(empty.find(DVec2::ZERO, DVec2::ONE, |_, _, _| true), None);
        let point = SegmentGrid::new(vec![(DVec2::ONE, DVec2::ONE)]);
        assert_eq!(point.find(DVec2::ZERO, DVec2::ONE, |_, _, _| true), Some(0));
    }
}
