//! Best paths between lines that are fixed.

use super::lattice::{ABSENT, Lattice};
use super::path::{Begin, Bounds, Finish, Path, PathFinder, Rule};
use super::{Ends, Obstacle, Problem};

/// Returns the best paths from each pinned line to the next, in cyclic order; together they close. Between open outlines they run from one
/// end to the other.
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
    if lattice.ends().is_none() {
        cells.push((from + a, column + b as i64, pin));
    }
    let between = |w: &[(usize, i64, usize)]| [w[0].2, w[1].2];
    if let Some(crossing) = cells.windows(2).find(|w| w[0].1 > w[1].1) {
        let [i, k] = between(crossing);
        return Err(Obstacle::PinsCross { pins: [i.min(k), i.max(k)] });
    }
    let mut path = |begin: Begin, finish: Finish, pins: [usize; 2]| {
        finder.find(lattice, rule, begin, finish, &Bounds::default()).ok_or(Obstacle::NoRoom { pins })
    };
    let mut paths = Vec::with_capacity(cells.len() + 1);
    let after = |cell: &(usize, i64, usize)| Begin::After(cell.0, cell.1);
    let at = |cell: &(usize, i64, usize)| Finish::At(cell.0, cell.1);
    if let Some(ends) = lattice.ends() {
        let begin = if ends == Ends::Tied { Begin::At(0, 0) } else { Begin::Anywhere };
        paths.push(path(begin, at(&cells[0]), [pin; 2])?);
    }
    for w in cells.windows(2) {
        paths.push(path(after(&w[0]), at(&w[1]), between(w))?);
    }
    if let (Some(ends), Some(last)) = (lattice.ends(), cells.last()) {
        let finish = if ends == Ends::Tied { Finish::At(a - 1, b as i64 - 1) } else { Finish::Anywhere };
        paths.push(Path { ends: true, ..path(after(last), finish, [last.2; 2])? });
    }
    Ok(paths)
}
