//! The ordered chain of lifted lines.

/// Lines kept in the one order in which none crosses another.
///
/// A line is the lattice point (i, J): vertex i of the first outline, lifted vertex J of the second. The lines
/// repeat under the deck translation (a, b), once round the band. Visible lines of nested polygons do not
/// cross if and only if i and J ascend together, weakly, over all of them and their translates. Open outlines have one lap, and
/// translates that are beyond everything.
#[derive(Debug, Clone)]
pub(super) struct Chain {
    period: i64,
    /// Vertices of the second outline, where it is open.
    open: Option<i64>,
    /// Least and greatest lifted end at each vertex of the first outline, where it has a line.
    ends: Vec<Option<(i64, i64)>>,
    /// One bit for each vertex that has a line.
    occupied: Vec<u64>,
}

/// The lap of open outlines: more than any vertex, and few enough to count with.
const BEYOND: i64 = 1 << 40;

impl Chain {
    /// An empty chain for outlines of `a` and `b` vertices.
    pub(super) fn new(a: usize, b: usize) -> Self {
        Self { period: b as i64, open: None, ends: vec![None; a], occupied: vec![0; a.div_ceil(64)] }
    }

    /// An empty chain for open outlines of `a` and `b` vertices.
    pub(super) fn open(a: usize, b: usize) -> Self {
        Self { period: BEYOND, open: Some(b as i64), ..Self::new(a, b) }
    }

    /// Tells whether the line (i, J) crosses none of the chain.
    pub(super) fn admits(&self, i: usize, lifted: i64) -> bool {
        let above = self.before(i).is_none_or(|(_, greatest)| greatest <= lifted);
        above && self.after(i).is_none_or(|(least, _)| lifted <= least)
    }

    /// Least and greatest lifted end that a line at vertex `i` may have; `None` when the chain is empty and all may be.
    pub(super) fn range(&self, i: usize) -> Option<(i64, i64)> {
        let (first, last) = (self.before(i)?.1, self.after(i)?.0);
        Some(self.open.map_or((first, last), |b| (first.max(0), last.min(b - 1))))
    }

    /// Tells whether the line (i, j) keeps the index interval of the paper (Eq. 12): it lies, counted upwards from the end at the last
    /// vertex before `i` that has a line to that at the first vertex after it, among these; lines at `i` itself are skipped. With all
    /// ends at one vertex the interval is that vertex alone, and laps are not told apart.
    pub(super) fn admits_as_printed(&self, i: usize, j: usize) -> bool {
        let a = self.ends.len();
        let after = self.first_occupied(i + 1, a).or_else(|| self.first_occupied(0, i));
        let before = self.last_occupied(0, i).or_else(|| self.last_occupied(i + 1, a));
        let ends = before.and_then(|k| self.ends[k]).zip(after.and_then(|k| self.ends[k]));
        let Some(((_, greatest), (least, _))) = ends else { return true };
        (j as i64 - greatest).rem_euclid(self.period) <= (least - greatest).rem_euclid(self.period)
    }

    /// Adds a line.
    pub(super) fn insert(&mut self, i: usize, lifted: i64) {
        let (least, greatest) = self.ends[i].unwrap_or((lifted, lifted));
        self.ends[i] = Some((least.min(lifted), greatest.max(lifted)));
        self.occupied[i / 64] |= 1 << (i % 64);
    }

    /// Ends at the nearest vertex before `i` that has lines, itself a lap earlier when it is the only one.
    fn before(&self, i: usize) -> Option<(i64, i64)> {
        if let Some(k) = self.last_occupied(0, i) {
            return self.ends[k];
        }
        let k = self.last_occupied(i, self.ends.len())?;
        self.ends[k].map(|(least, greatest)| (least - self.period, greatest - self.period))
    }

    /// Ends at the nearest vertex after `i` that has lines, itself a lap later when it is the only one.
    fn after(&self, i: usize) -> Option<(i64, i64)> {
        if let Some(k) = self.first_occupied(i + 1, self.ends.len()) {
            return self.ends[k];
        }
        let k = self.first_occupied(0, i + 1)?;
        self.ends[k].map(|(least, greatest)| (least + self.period, greatest + self.period))
    }

    fn first_occupied(&self, start: usize, end: usize) -> Option<usize> {
        let mut at = start;
        while at < end {
            let word = self.occupied[at / 64] >> (at % 64);
            if word != 0 {
                let found = at + word.trailing_zeros() as usize;
                return (found < end).then_some(found);
            }
            at = (at / 64 + 1) * 64;
        }
        None
    }

    fn last_occupied(&self, start: usize, end: usize) -> Option<usize> {
        let mut at = end;
        while at > start {
            let last = at - 1;
            let word = self.occupied[last / 64] << (63 - last % 64);
            if word != 0 {
                let found = last - word.leading_zeros() as usize;
                return (found >= start).then_some(found);
            }
            at = last / 64 * 64;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_line_admits_everything_within_a_lap() {
        let mut chain = Chain::new(200, 5);
        assert!(chain.admits(0, -40), "an empty chain admits everything");
        chain.insert(70, 2);
        assert!(chain.admits(70, 7) && chain.admits(70, -3), "a fan of one whole lap");
        assert!(!chain.admits(70, 8) && !chain.admits(70, -4));
        assert!(chain.admits(130, 2) && chain.admits(130, 7));
        assert!(!chain.admits(130, 1) && !chain.admits(130, 8));
        assert!(chain.admits(3, 2) && chain.admits(3, -3));
        assert!(!chain.admits(3, 3) && !chain.admits(3, -4));
    }

    #[test]
    fn neighbours_bound_a_line_across_words() {
        let mut chain = Chain::new(200, 100);
        for (i, lifted) in [(10, 5), (64, 30), (64, 34), (190, 90)] {
            chain.insert(i, lifted);
        }
        for (i, range) in
            [(0, -10..=5), (10, -10..=30), (63, 5..=30), (64, 5..=90), (65, 34..=90), (199, 90..=105)]
        {
            for lifted in -20..130 {
                assert_eq!(chain.admits(i, lifted), range.contains(&lifted), "({i}, {lifted})");
            }
        }
    }

    #[test]
    fn the_printed_interval_loses_the_lap() {
        let mut chain = Chain::new(8, 5);
        assert!(chain.admits_as_printed(0, 3), "without lines everything is valid");
        assert_eq!(chain.range(0), None);
        chain.insert(2, 3);
        assert!(
            chain.admits_as_printed(0, 3) && !chain.admits_as_printed(0, 4),
            "one vertex, not the whole cycle"
        );
        assert_eq!(chain.range(0), Some((-2, 3)), "repaired, it is the whole cycle");
        chain.insert(5, 6);
        // From end 3 at vertex 2 on to end 1 at vertex 5, through the seam.
        let valid: Vec<usize> = (0..5).filter(|&j| chain.admits_as_printed(3, j)).collect();
        assert_eq!(valid, [0, 1, 3, 4]);
    }
}
