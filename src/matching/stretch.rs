//! Vertices that cannot all have a line at once.

use super::lattice::{ABSENT, Lattice};

/// Neighbouring vertices of one outline that cannot all have lines without crossings, although fewer of them might.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Stretch {
    /// 0 for the first curve, 1 for the second.
    pub outline: usize,
    /// The first vertex.
    pub first: usize,
    /// Number of vertices, counted on across the seam; all of them when no shorter stretch explains it.
    pub count: usize,
}

/// Laps looked at: a stretch that winds round farther is reported as the whole outline.
const LAPS: usize = 3;

/// Returns the shortest stretch of vertices of either outline that no monotone path passes; of a lattice without a closed path.
pub(super) fn shortest_stretch(lattice: &Lattice) -> Stretch {
    let second = Stretch { outline: 1, ..shortest_of_rows(&lattice.transposed()) };
    let first = shortest_of_rows(lattice);
    if second.count < first.count { second } else { first }
}

/// For every cell the earliest row in which a path to it can begin; a row whose earliest is e cannot be reached from row
/// e - 1.
fn shortest_of_rows(lattice: &Lattice) -> Stretch {
    let (a, _) = lattice.counts();
    let mut shortest = Stretch { outline: 0, first: 0, count: a };
    let (mut above_first, mut above): (i64, Vec<usize>) = (0, Vec::new());
    let laps = if lattice.ends().is_some() { 1 } else { LAPS };
    for row in 0..laps * a {
        let cells = lattice.row(row);
        let mut earliest = vec![usize::MAX; cells.values.len()];
        for (k, column) in (cells.first..).enumerate().take(earliest.len()) {
            if cells.values[k] == ABSENT {
                continue;
            }
            let reach = |column: i64| {
                let k = usize::try_from(column - above_first).ok();
                k.and_then(|k| above.get(k)).copied().unwrap_or(usize::MAX)
            };
            let left = if k > 0 { earliest[k - 1] } else { usize::MAX };
            earliest[k] = row.min(left).min(reach(column)).min(reach(column - 1));
        }
        let begin = earliest.iter().copied().min().unwrap_or(row + 1).min(row + 1);
        if begin > 0 && row + 2 - begin < shortest.count {
            shortest = Stretch { outline: 0, first: (begin - 1) % a, count: row + 2 - begin };
        }
        (above_first, above) = (cells.first, earliest);
    }
    shortest
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A lattice of 6 by 6 equal vertices with lines in a band about the diagonal, less those of some cells.
    fn banded(missing: impl Fn(usize, i64) -> bool) -> Lattice {
        let mut lattice = Lattice::new([vec![1.0 / 6.0; 6], vec![1.0 / 6.0; 6]], None);
        for row in 0..6 {
            let columns = (row as i64 - 1..=row as i64 + 1).filter(|&column| !missing(row, column));
            let cells: Vec<_> = columns.map(|column| (column, 1.0)).collect();
            lattice.push_row(&cells);
        }
        lattice
    }

    #[test]
    fn two_rows_without_a_step_between_them() {
        // Row 2 keeps column 1 alone, row 3 column 4: nothing joins them.
        let lattice = banded(|row, column| (row == 2 && column != 1) || (row == 3 && column != 4));
        assert_eq!(shortest_stretch(&lattice), Stretch { outline: 0, first: 2, count: 2 });
        // Seen from the other outline, columns 2 and 3 have their lines in rows 1 and 4.
        assert_eq!(shortest_of_rows(&lattice.transposed()), Stretch { outline: 0, first: 2, count: 2 });
    }

    #[test]
    fn a_stretch_over_the_seam() {
        let lattice = banded(|row, column| (row == 5 && column != 4) || (row == 0 && column != 1));
        assert_eq!(shortest_stretch(&lattice), Stretch { outline: 0, first: 5, count: 2 });
    }

    #[test]
    fn transposing_twice_changes_nothing() {
        let lattice = banded(|row, column| row == 3 && column == 3);
        let twice = lattice.transposed().transposed();
        for row in 0..6 {
            assert_eq!(
                lattice.row(row).columns().collect::<Vec<_>>(),
                twice.row(row).columns().collect::<Vec<_>>()
            );
        }
    }
}
