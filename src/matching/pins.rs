//! Best paths between lines that are fixed.

use super::lattice::{ABSENT, Lattice};
use super::path::{Bounds, Path, PathFinder, Rule};
use super::{Obstacle, Problem};

/// Returns the best paths from each pinned line to the next, in cyclic order; together they close.
///
/// # Errors
/// When a pin names no vertex, is not a line of the lattice, crosses another, or when there is no path between two.
pub(super) fn pinned_paths(
    problem: &Problem,
    lattice: &Lattice,
    rule: Rule,
    pins: &[(usize, usize)],
    finder: &mut PathFinder,
) -> Result<Vec<Path>, Obstacle> {
    let (a, b) = lattice.counts();
    let mut cells = Vec::with_capacity(pins.len() + 1);
    for (pin, &(from, to)) in pins.iter().enumerate() {
        if from >= a || to >= b {
            return Err(Obstacle::NoSuchVertex { pin });
        }
        let column = problem.lift(from, to);
        if lattice.row(from).at(column) == ABSENT {
            return Err(Obstacle::PinBlocked { pin });
        }
        let cell = (from, column, pin);
        cells.insert(cells.partition_point(|other| *other < cell), cell);
    }
    let &(from, column, pin) = cells.first().ok_or(Obstacle::NoSuchVertex { pin: 0 })?;
    cells.push((from + a, column + b as i64, pin));
    let between = |w: &[(usize, i64, usize)]| [w[0].2, w[1].2];
    if let Some(crossing) = cells.windows(2).find(|w| w[0].1 > w[1].1) {
        let [i, k] = between(crossing);
        return Err(Obstacle::PinsCross { pins: [i.min(k), i.max(k)] });
    }
    let path = |w: &[(usize, i64, usize)]| {
        finder
            .find(lattice, rule, (w[0].0, w[0].1), (w[1].0, w[1].1), &Bounds::default())
            .ok_or(Obstacle::NoRoom { pins: between(w) })
    };
    cells.windows(2).map(path).collect()
}
