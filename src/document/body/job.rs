//! The job that answers a question about a body.

use super::known::{Difference, Judged, Old, Relations};
use super::paint::Painter;
use super::resurface::{Resurfaced, Resurfacing};
use super::{
    Answer, BodyAsk, BodyFormat, Boundary, CellRow, Checks, Held, KnownBody, Painted, Parts, Renewal, Sample,
    Summary,
};
use crate::hyperpatch::composite::{CellId, Pairs, Probe, Relation, Sharing, Verdicts};
use crate::hyperpatch::operation::{moves, neighbourhood};
use crate::hyperpatch::validity::Report;
use crate::hyperpatch::{Face, Grid, Sectioning, Tessellation, VtkJob};
use crate::material::{Color, mix_fractions};
use crate::solid::{FileJob, Labels, Mesh, Skin};
use std::cell::OnceCell;
use std::collections::HashSet;
use std::rc::Rc;

/// Chord tolerance over the size of the body where none is asked for.
const TOLERANCE: f64 = 1e-3;

/// Colours that are found between two looks at the clock.
const BATCH: usize = 4096;

/// The job that answers a question about a body in steps. What it finds out on the way is kept with the body.
#[derive(Debug)]
pub struct BodyJob {
    known: Rc<KnownBody>,
    ask: BodyAsk,
    work: Work,
}

#[derive(Debug)]
enum Work {
    /// It is to be decided what comes next.
    Planning,
    Judging(Box<Verdicts>, bool),
    /// The cells that are still to be joined with the others come last first.
    Joining(Box<Sharing>, Vec<CellId>),
    /// With what is known of the other pairs.
    Pairing(Box<Pairs>, Relations),
    Listing(Vec<CellRow>),
    Integrating(usize, f64, Vec<f64>),
    Cutting(Box<Sectioning<Held>>),
    Meshing(Box<Tessellation<Held, Rc<Sharing>>>),
    Painting(Box<Painter>, f64),
    Resurfacing(Box<Resurfacing>),
    Skinning(Box<Skin<Held>>),
    Coloring(Box<Mesh>, Vec<Color>),
    Writing(Box<FileJob>),
    Gridding(Box<VtkJob<Held>>),
    Done(Option<Answer>),
}

impl BodyJob {
    /// The job for a question that was read for this body.
    #[must_use]
    pub fn new(known: Rc<KnownBody>, ask: BodyAsk) -> Self {
        Self { known, ask, work: Work::Planning }
    }

    /// Advances while `may_go_on` says so, at least by a little; returns the answer, and nothing more ever after.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<Answer> {
        loop {
            let work = std::mem::replace(&mut self.work, Work::Planning);
            self.work = self.advance(work, may_go_on);
            if let Work::Done(answer) = &mut self.work {
                return answer.take();
            }
            if !may_go_on() {
                return None;
            }
        }
    }

    /// Runs the job to its end.
    #[must_use]
    pub fn run(mut self) -> Option<Answer> {
        self.step(&mut || true)
    }

    /// Share of the present part of the work that is done, below 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        let cells = self.known.model().body().cells().len().max(1) as f64;
        let share = match &self.work {
            Work::Planning => 0.0,
            Work::Judging(job, _) => job.progress(),
            Work::Joining(_, left) => 1.0 - left.len() as f64 / cells,
            Work::Integrating(count, ..) => *count as f64 / cells,
            Work::Pairing(job, _) => job.progress(),
            Work::Listing(rows) => rows.len() as f64 / cells,
            Work::Cutting(_) | Work::Meshing(_) => 0.3,
            Work::Painting(job, _) => 0.5 + 0.4 * job.progress(),
            Work::Resurfacing(job) => job.progress(),
            Work::Skinning(_) | Work::Coloring(..) => 0.4,
            Work::Writing(job) => 0.5 + 0.5 * job.progress(),
            Work::Gridding(job) => job.progress(),
            Work::Done(_) => 1.0,
        };
        share.min(0.99)
    }

    fn advance(&self, work: Work, may_go_on: &mut dyn FnMut() -> bool) -> Work {
        let body = self.known.model().body();
        match work {
            Work::Planning => self.plan(),
            Work::Judging(mut job, is_global) => {
                if !job.step(may_go_on) {
                    return Work::Judging(job, is_global);
                }
                let mut judged = self.known.judged.borrow_mut();
                for (id, report) in job.reports() {
                    if let Some(cell) = body.cell(*id) {
                        let is_final = is_global || !report.is_open();
                        let (volume, least) = (OnceCell::new(), OnceCell::new());
                        let cell = cell.clone();
                        judged.insert(*id, Judged { cell, report: *report, is_final, volume, least });
                    }
                }
                Work::Planning
            }
            Work::Joining(mut sharing, mut left) => {
                while let Some(id) = left.pop() {
                    sharing.remove(id);
                    if let Some(cell) = body.cell(id) {
                        sharing.add(id, cell.net());
                    }
                    if !may_go_on() {
                        return Work::Joining(sharing, left);
                    }
                }
                let _ = self.known.sharing.set(Rc::new(*sharing));
                self.known.old_sharing.take();
                Work::Planning
            }
            Work::Pairing(mut job, mut known) => {
                if !job.step(may_go_on) {
                    return Work::Pairing(job, known);
                }
                known.extend_from_slice(job.found());
                known.sort_unstable_by_key(|(cells, _)| *cells);
                let _ = self.known.relations.set(Rc::new(known));
                self.known.old_relations.take();
                Work::Planning
            }
            Work::Listing(mut rows) => {
                let reports = self.reports();
                while let Some((cell, made)) = body.cells().get(rows.len()) {
                    let volume = self.known.volume_of(*cell, made);
                    let margin = reports.get(rows.len()).map_or(-1.0, |(_, report)| report.margin);
                    rows.push(CellRow { cell: *cell, corners: made.net().corners(), margin, volume });
                    if !may_go_on() {
                        return Work::Listing(rows);
                    }
                }
                Work::Done(Some(Answer::Cells(rows)))
            }
            Work::Integrating(mut next, mut volume, mut amounts) => {
                while let Some((_, cell)) = body.cells().get(next) {
                    let shares = cell.amounts();
                    volume += shares.iter().sum::<f64>();
                    amounts.iter_mut().zip(shares).for_each(|(sum, share)| *sum += share);
                    next += 1;
                    if !may_go_on() {
                        return Work::Integrating(next, volume, amounts);
                    }
                }
                Work::Done(Some(Answer::Amounts { volume, amounts }))
            }
            Work::Cutting(mut job) => match job.step(may_go_on) {
                None => Work::Cutting(job),
                Some(section) => {
                    let area = section.area();
                    Work::Painting(Box::new(Painter::of_section(&self.known, section)), area)
                }
            },
            Work::Meshing(mut job) => match (job.step(may_go_on), self.known.sharing.get()) {
                (Some(surface), _) if matches!(self.ask, BodyAsk::File { .. }) => {
                    Work::Skinning(Box::new(Skin::new(self.known.held(), surface)))
                }
                (Some(surface), Some(sharing)) => {
                    let painter = Painter::of_surface(&self.known, surface, Rc::clone(sharing));
                    Work::Painting(Box::new(painter), 0.0)
                }
                _ => Work::Meshing(job),
            },
            Work::Painting(mut job, area) => match job.step(&self.known, may_go_on) {
                None => Work::Painting(job, area),
                Some((painted, boundary)) => match self.ask {
                    BodyAsk::Section { .. } => Work::Done(Some(Answer::Section(Box::new(painted), area))),
                    _ => self.surfaced(painted, boundary, None),
                },
            },
            Work::Resurfacing(mut job) => match job.step(&self.known, may_go_on) {
                Resurfaced::Open => Work::Resurfacing(job),
                Resurfaced::Unlike => self.meshing(),
                Resurfaced::Done(done) => {
                    let (painted, boundary, renewal) = *done;
                    self.surfaced(painted, boundary, Some(renewal))
                }
            },
            Work::Skinning(mut job) => match job.step(may_go_on) {
                None => Work::Skinning(job),
                Some(mesh) => Work::Coloring(Box::new(mesh), Vec::new()),
            },
            Work::Coloring(mesh, mut colors) => {
                while colors.len() < mesh.positions.len() {
                    let end = mesh.positions.len().min(colors.len() + BATCH);
                    let color = |vertex: usize| {
                        mix_fractions(self.known.colors(), mesh.fractions_at(vertex)).to_color()
                    };
                    colors.extend((colors.len()..end).map(color));
                    if !may_go_on() {
                        return Work::Coloring(mesh, colors);
                    }
                }
                match self.ask {
                    BodyAsk::File { format: BodyFormat::Surface(format), .. } => {
                        Work::Writing(Box::new(FileJob::new(format, *mesh, colors, &self.labels())))
                    }
                    _ => Work::Done(None),
                }
            }
            Work::Writing(mut job) => match job.step(may_go_on) {
                None => Work::Writing(job),
                Some(bytes) => Work::Done(Some(Answer::File(bytes))),
            },
            Work::Gridding(mut job) => match job.step(may_go_on) {
                None => Work::Gridding(job),
                Some(bytes) => Work::Done(Some(Answer::File(bytes))),
            },
            Work::Done(_) => Work::Done(None),
        }
    }

    /// The next part of the work: what the answer rests on first.
    fn plan(&self) -> Work {
        let (known, ask) = (&self.known, self.ask);
        let body = known.model().body();
        if let Some(is_global) = self.is_judged_globally() {
            let judged = known.judged.borrow();
            let is_known = |id: &CellId| judged.get(id).is_some_and(|found| found.is_final || !is_global);
            let open: Vec<CellId> = self.judged().into_iter().filter(|id| !is_known(id)).collect();
            if !open.is_empty() {
                return Work::Judging(Box::new(Verdicts::new(body, open, is_global)), is_global);
            }
        }
        let is_summary = matches!(ask, BodyAsk::Summary);
        let is_paired = is_summary || matches!(ask, BodyAsk::Relations | BodyAsk::Checks { .. });
        let is_joined = matches!(
            ask,
            BodyAsk::Surface { .. }
                | BodyAsk::File { format: BodyFormat::Surface(_), .. }
                | BodyAsk::Continuity
                | BodyAsk::Sharing
        );
        if (is_joined || is_paired) && known.sharing.get().is_none() {
            return self.joining();
        }
        if is_paired && known.relations.get().is_none() {
            return self.pairing();
        }
        match ask {
            BodyAsk::Cells => Work::Listing(Vec::with_capacity(body.cells().len())),
            BodyAsk::Amounts => Work::Integrating(0, 0.0, vec![0.0; body.materials()]),
            BodyAsk::Section { plane, steps } => match Sectioning::new(known.held(), plane, steps) {
                Ok(job) => Work::Cutting(Box::new(job)),
                Err(_) => Work::Done(None),
            },
            BodyAsk::Surface { tolerance, has_inner, since: Some(since) } => {
                let faces = self.faces(has_inner);
                let job = Resurfacing::new(known, &known.surfaces.borrow(), since, tolerance, &faces);
                job.map_or_else(|| self.meshing(), |job| Work::Resurfacing(Box::new(job)))
            }
            BodyAsk::Surface { .. } | BodyAsk::File { format: BodyFormat::Surface(_), .. } => self.meshing(),
            BodyAsk::File { format: BodyFormat::Vtk, .. } => {
                Work::Gridding(Box::new(VtkJob::new(known.held(), &self.labels().materials)))
            }
            _ => Work::Done(self.answer()),
        }
    }

    /// The job that finds what cells share; of most it is known when little has changed.
    fn joining(&self) -> Work {
        let body = self.known.model().body();
        let sharing = Sharing::start(body);
        if let Some(Old { body: old, found }) = &*self.known.old_sharing.borrow()
            && found.tolerance() == sharing.tolerance()
        {
            let mut difference = Difference::new(body, old);
            if difference.changed.len() + difference.gone.len() <= body.cells().len() / 2 {
                difference.gone.append(&mut difference.changed);
                return Work::Joining(Box::new(Sharing::clone(found)), difference.gone);
            }
        }
        Work::Joining(Box::new(sharing), body.cells().iter().rev().map(|(id, _)| *id).collect())
    }

    /// The job that finds the relations of all pairs; those of cells that have not changed are known.
    fn pairing(&self) -> Work {
        let body = self.known.model().body();
        let Some(sharing) = self.known.sharing.get() else { return Work::Done(None) };
        let mut known = Relations::new();
        let mut chosen: HashSet<CellId> = body.cells().iter().map(|(id, _)| *id).collect();
        if let Some(Old { body: old, found }) = &*self.known.old_relations.borrow() {
            let difference = Difference::new(body, old);
            chosen = difference.changed.into_iter().collect();
            let is_new: HashSet<CellId> = difference.gone.iter().chain(&chosen).copied().collect();
            let stays = |pair: &&([CellId; 2], Relation)| !pair.0.iter().any(|id| is_new.contains(id));
            known.extend(found.iter().filter(stays).cloned());
        }
        Work::Pairing(Box::new(Pairs::with(body, Rc::clone(sharing), chosen)), known)
    }

    /// Whether the question rests on verdicts, and on all checks.
    fn is_judged_globally(&self) -> Option<bool> {
        match self.ask {
            BodyAsk::Cells => Some(false),
            BodyAsk::Verdicts { is_global } => Some(is_global),
            BodyAsk::Summary | BodyAsk::Checks { .. } => Some(true),
            _ => None,
        }
    }

    /// The cells on whose verdicts the question rests.
    fn judged(&self) -> Vec<CellId> {
        let model = self.known.model();
        let is_there = |id: &CellId| model.body().cell(*id).is_some();
        match self.ask {
            BodyAsk::Checks { place } => {
                let made = model.stages().get(place).map_or(&[][..], |stage| &stage.row().made);
                made.iter().copied().filter(is_there).collect()
            }
            _ => model.body().cells().iter().map(|(id, _)| *id).collect(),
        }
    }

    /// The chord tolerance of a surface.
    fn tolerance(&self) -> f64 {
        let asked = match self.ask {
            BodyAsk::Surface { tolerance, .. } | BodyAsk::File { tolerance, .. } => tolerance,
            _ => None,
        };
        asked.unwrap_or(TOLERANCE * self.known.size())
    }

    /// The answer with a surface, which is remembered.
    fn surfaced(&self, painted: Painted, boundary: Boundary, renewal: Option<Renewal>) -> Work {
        let BodyAsk::Surface { tolerance, .. } = self.ask else { return Work::Done(None) };
        let kept = self.known.surfaces.borrow_mut().keep(&self.known, (painted, boundary), tolerance);
        Work::Done(kept.map(|surface| Answer::Surface(surface, renewal)))
    }

    /// The faces of a surface: the outer ones, and after them those between cells, once for each cell.
    fn faces(&self, has_inner: bool) -> Vec<(CellId, Face)> {
        let Some(sharing) = self.known.sharing.get() else { return Vec::new() };
        let mut faces = sharing.outer_faces();
        if has_inner {
            let outer: HashSet<_> = faces.iter().copied().collect();
            let cells = self.known.model().body().cells();
            let all = cells.iter().flat_map(|(id, _)| Face::all().map(|face| (*id, face)));
            faces.extend(all.filter(|side| !outer.contains(side)));
        }
        faces
    }

    fn meshing(&self) -> Work {
        let Some(sharing) = self.known.sharing.get() else { return Work::Done(None) };
        let has_inner = matches!(self.ask, BodyAsk::Surface { has_inner: true, .. });
        let (faces, tolerance) = (self.faces(has_inner), self.tolerance());
        let job = Tessellation::new(self.known.held(), Rc::clone(sharing), faces, tolerance);
        job.map_or(Work::Done(None), |job| Work::Meshing(Box::new(job)))
    }

    /// The answer to a question that needs no steps of its own.
    fn answer(&self) -> Option<Answer> {
        let known = &self.known;
        let body = known.model().body();
        Some(match self.ask {
            BodyAsk::Moves { cell, at, reach } => Answer::Moves(moves(body, cell, at, reach).ok()?),
            BodyAsk::Neighbourhood { cell, corner } => {
                Answer::Neighbourhood(Box::new(neighbourhood(body, cell, corner).ok()?))
            }
            BodyAsk::Checks { place } => {
                let (sharing, relations) = known.sharing.get().zip(known.relations.get())?;
                let made = &known.model().stages().get(place)?.row().made;
                Answer::Checks(Box::new(Checks::new(body, sharing, made, &self.reports(), relations)))
            }
            BodyAsk::CellsDocument => Answer::CellsDocument,
            BodyAsk::Sample { cell, at } => Answer::Sample(Sample::new(body, cell, at)?),
            BodyAsk::Verdicts { .. } => Answer::Verdicts(self.reports()),
            BodyAsk::Summary => {
                let (sharing, relations) = known.sharing.get().zip(known.relations.get())?;
                Answer::Summary(Box::new(Summary::new(body, sharing, &self.reports(), relations)))
            }
            BodyAsk::Probe(point) => {
                let probe = known.probe.get_or_init(|| Probe::new(known.held()));
                Answer::Probe(probe.place(point).and_then(|place| Sample::new(body, place.cell, place.at)))
            }
            BodyAsk::Relations => Answer::Relations(known.relations.get()?.to_vec()),
            BodyAsk::Continuity => {
                let sharing = known.sharing.get()?;
                Answer::Continuity(sharing.continuity(body), sharing.contacts(body))
            }
            BodyAsk::Sharing => Answer::Sharing(Box::new(Parts::new(body, known.sharing.get()?))),
            BodyAsk::Grid { cell, counts } => {
                let mut grid = Grid::new(counts).ok()?;
                grid.evaluate(body.cell(cell)?);
                Answer::Grid(Box::new(grid))
            }
            _ => return None,
        })
    }

    /// What is known of the cells, in their order.
    fn reports(&self) -> Vec<(CellId, Report)> {
        let judged = self.known.judged.borrow();
        let cells = self.known.model().body().cells().iter();
        cells.filter_map(|(id, _)| judged.get(id).map(|found| (*id, found.report))).collect()
    }

    fn labels(&self) -> Labels {
        let model = self.known.model();
        let document = model.document();
        Labels {
            title: document.head.title.clone(),
            unit: document.head.unit.clone(),
            materials: model.materials().iter().map(|material| material.name.clone()).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::{Json, read_hyperpatch};
    use super::super::{BodyMemory, DocumentKey};
    use super::*;
    use crate::document::HyperpatchModel;
    use crate::hyperpatch::validity::Verdict;
    use glam::DVec3;
    use serde_json::json;

    /// Two unit cubes side by side, the second one's inner coefficients moved by `shift` against each other.
    fn text(shift: f64) -> String {
        let cell = |start: f64, shift: f64| {
            let coefficient = |at: usize| {
                let [i, j, k] = [at / 16, at / 4 % 4, at % 4];
                let is_inside = [i, j, k].iter().all(|n| (1..3).contains(n));
                let moved = if is_inside { shift * if i == 1 { 1.0 } else { -1.0 } } else { 0.0 };
                let x = start + i as f64 / 3.0 + moved;
                json!({"position": [x, j as f64 / 3.0, k as f64 / 3.0], "mix": if i < 2 { [1, 0] } else { [0, 1] }})
            };
            json!({"coefficients": (0..64).map(coefficient).collect::<Vec<_>>()})
        };
        json!({
            "directrix": 1, "kind": "hyperpatch",
            "materials": [{"name": "a", "color": "#000000"}, {"name": "b", "color": "#ffffff"}],
            "operations": [{"op": "cells", "cells": [cell(0.0, 0.0), cell(1.0, shift)]}],
        })
        .to_string()
    }

    fn known(memory: &mut BodyMemory, text: &str) -> Rc<KnownBody> {
        let key = DocumentKey { head: text.to_owned(), operations: Vec::new() };
        memory.find(&key).unwrap_or_else(|| {
            let document = read_hyperpatch(&Json::parse(text).unwrap()).unwrap();
            memory.keep(key, HyperpatchModel::new(document).unwrap())
        })
    }

    fn verdicts(known: &Rc<KnownBody>) -> Vec<Verdict> {
        let job = BodyJob::new(Rc::clone(known), BodyAsk::Verdicts { is_global: true });
        let Some(Answer::Verdicts(reports)) = job.run() else { panic!("verdicts were asked for") };
        reports.iter().map(|(_, report)| report.verdict).collect()
    }

    /// A verdict stays with the shape that it is about.
    #[test]
    fn verdicts_are_taken_over_for_cells_that_stay() {
        let mut memory = BodyMemory::default();
        let sound = known(&mut memory, &text(0.0));
        assert!(sound.judged.borrow().is_empty());
        assert_eq!(verdicts(&sound), [Verdict::Regular, Verdict::Regular]);
        let edited = known(&mut memory, &text(1.5));
        assert_eq!(edited.judged.borrow().keys().collect::<Vec<_>>(), [&CellId(0)]);
        assert_eq!(verdicts(&edited), [Verdict::Regular, Verdict::Invalid]);
        assert!(Rc::ptr_eq(&known(&mut memory, &text(0.0)), &sound), "remembered by its text");
    }

    #[test]
    fn every_question_ends_in_short_steps_with_the_same_answer() {
        let mut memory = BodyMemory::default();
        let known = known(&mut memory, &text(0.2));
        let asks =
            ["cells", "verdicts", "summary", "amounts", "surface", "relations", "continuity", "sharing"];
        for name in asks {
            let ask = BodyAsk::read(name, &Json::Object(Vec::new()), known.model()).unwrap();
            let mut job = BodyJob::new(Rc::clone(&known), ask);
            let mut steps = 0;
            let stepped = loop {
                steps += 1;
                assert!(steps < 10_000, "{name}");
                if let Some(answer) = job.step(&mut || false) {
                    break answer;
                }
                assert!((0.0..1.0).contains(&job.progress()), "{name}");
            };
            assert!(job.step(&mut || true).is_none(), "{name}: nothing more ever after");
            let whole = BodyJob::new(Rc::clone(&known), ask).run().expect("an answer");
            // Surfaces have numbers of their own.
            let told = |answer: &Answer| match answer {
                Answer::Surface(surface, None) => format!("{:?}", (&surface.painted, &surface.boundary)),
                other => format!("{other:?}"),
            };
            assert_eq!(told(&stepped), told(&whole), "{name}");
        }
    }

    /// Colour goes from black to white as the material does, and the curves of the boundary are there once.
    #[test]
    fn surfaces_carry_material_and_curves() {
        let mut memory = BodyMemory::default();
        let known = known(&mut memory, &text(0.0));
        let job = BodyJob::new(
            Rc::clone(&known),
            BodyAsk::Surface { tolerance: None, has_inner: false, since: None },
        );
        let Some(Answer::Surface(surface, None)) = job.run() else { panic!("a surface was asked for") };
        let (painted, boundary) = (&surface.painted, &surface.boundary);
        for (vertex, point) in painted.positions.iter().enumerate() {
            let t = painted.parameters[vertex].x;
            assert!((point.x - (f64::from(painted.cells[vertex]) + t)).abs() < 1e-12);
            assert!((painted.fractions[2 * vertex + 1] - t * t * (3.0 - 2.0 * t)).abs() < 1e-12);
            if t == 0.0 || t == 1.0 {
                assert_eq!(painted.colors[4 * vertex], if t == 0.0 { 0 } else { 255 });
            }
        }
        assert_eq!((boundary.edges.len(), boundary.corners.len()), (20, 12));
        let place = boundary.corners.iter().filter(|(.., users, _)| *users == 2).map(|(.., place)| *place);
        assert!(place.map(|place: DVec3| place.x).all(|x| x == 1.0));

        // With the faces between cells, which follow the outer ones, every face of every cell is there, and the curves are the same.
        let job = BodyJob::new(
            Rc::clone(&known),
            BodyAsk::Surface { tolerance: None, has_inner: true, since: None },
        );
        let Some(Answer::Surface(whole, None)) = job.run() else { panic!("a surface was asked for") };
        assert_eq!((painted.stretches.len(), whole.painted.stretches.len()), (10, 12));
        assert!(
            painted
                .stretches
                .iter()
                .zip(&whole.painted.stretches)
                .all(|(a, b)| (a.cell, a.face) == (b.cell, b.face))
        );
        assert!(
            whole.painted.stretches[10..]
                .iter()
                .all(|inner| whole.painted.positions[inner.vertices.clone()].iter().all(|p| p.x == 1.0))
        );
        assert_eq!((whole.boundary.edges.len(), whole.boundary.corners.len()), (20, 12));
    }
}
