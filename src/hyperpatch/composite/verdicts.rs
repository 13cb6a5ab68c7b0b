//! The verdicts on cells of a body, in steps.

use super::{Body, CellId};
use crate::hyperpatch::Net;
use crate::hyperpatch::validity::{Injectivity, Report, certify};

/// The job that judges cells: the certificates of each first, and then, one after the other, whether those meet
/// themselves that the certificates leave open.
///
/// It keeps the shapes that it was made with. When one of them is edited its report is stale: the job is dropped, and
/// a new one is made for the cells that were touched.
#[derive(Debug)]
pub struct Verdicts {
    cells: Vec<(CellId, Net)>,
    is_global: bool,
    reports: Vec<(CellId, Report)>,
    /// Number of reports that are final.
    settled: usize,
    work: Option<Injectivity>,
}

impl Verdicts {
    /// The job for some cells, in this order; those that the body does not have are left out. With `is_global` false
    /// it ends with the certificates.
    #[must_use]
    pub fn new(body: &Body, cells: impl IntoIterator<Item = CellId>, is_global: bool) -> Self {
        let find = |id: CellId| body.cell(id).map(|cell| (id, cell.net().clone()));
        let cells: Vec<_> = cells.into_iter().filter_map(find).collect();
        Self { reports: Vec::with_capacity(cells.len()), cells, is_global, settled: 0, work: None }
    }

    /// What is known so far; a verdict may still go from `LocallyValid` to another one.
    #[must_use]
    pub fn reports(&self) -> &[(CellId, Report)] {
        &self.reports
    }

    /// Share of the work that is done, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        let count = self.cells.len() * if self.is_global { 2 } else { 1 };
        if count == 0 { 1.0 } else { (self.reports.len() + self.settled) as f64 / count as f64 }
    }

    /// Advances while `may_go_on` says so, at least by a little; tells whether all is known.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> bool {
        loop {
            if let Some((id, net)) = self.cells.get(self.reports.len()) {
                self.reports.push((*id, certify(net)));
            } else if self.is_global && self.settled < self.cells.len() {
                self.settle(may_go_on);
            }
            if self.reports.len() == self.cells.len() && (!self.is_global || self.settled == self.cells.len())
            {
                return true;
            }
            if !may_go_on() {
                return false;
            }
        }
    }

    /// Runs the job to its end.
    #[must_use]
    pub fn run(mut self) -> Vec<(CellId, Report)> {
        while !self.step(&mut || true) {}
        self.reports
    }

    /// Advances the question whether the next cell meets itself, or passes over it when it is none.
    fn settle(&mut self, may_go_on: &mut dyn FnMut() -> bool) {
        let report = self.reports[self.settled].1;
        if report.is_open() {
            let net = &self.cells[self.settled].1;
            let work = self.work.get_or_insert_with(|| Injectivity::new(net, report.is_mirrored));
            let Some(finding) = work.step(may_go_on) else { return };
            self.work = None;
            self.reports[self.settled].1 = report.with(finding);
        }
        self.settled += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::Cell;
    use crate::hyperpatch::test_cells::{crossing_bar, folded, random_net, twisted};
    use crate::hyperpatch::validity::verdict;
    use crate::material::Composition;

    fn body() -> Body {
        let mut body = Body::new(1);
        for net in [random_net(1, 0.02), twisted(120.0), crossing_bar(), folded(2.0), random_net(2, 0.14)] {
            body.add(Cell::uniform(net, &Composition::pure(0, 1)).unwrap()).unwrap();
        }
        body
    }

    /// However often it is interrupted, the job ends with what each cell gets alone.
    #[test]
    fn the_job_finds_what_cells_get_alone() {
        let body = body();
        let ids = || body.cells().iter().map(|(id, _)| *id);
        let mut job = Verdicts::new(&body, ids(), true);
        let (mut steps, mut last) = (1, 0.0);
        while !job.step(&mut || false) {
            steps += 1;
            assert!(job.progress() >= last);
            last = job.progress();
        }
        assert!(steps > 10 && job.progress() == 1.0);
        for (id, report) in job.reports() {
            assert_eq!(*report, verdict(body.cell(*id).unwrap().net()));
        }
        assert_eq!(Verdicts::new(&body, ids(), true).run(), job.reports());
    }

    #[test]
    fn certificates_alone_leave_cells_open() {
        let body = body();
        let asked = [CellId(2), CellId(99), CellId(0)];
        let found = Verdicts::new(&body, asked, false).run();
        assert_eq!(found.iter().map(|(id, _)| id.0).collect::<Vec<_>>(), [2, 0]);
        assert!(found[0].1.is_open() && !found[1].1.is_open());
        assert!(Verdicts::new(&body, [], true).run().is_empty());
    }
}
