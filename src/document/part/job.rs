//! The job that answers a question about a part.

use super::{KnownPart, PartAsk};
use crate::part::{Part, PartIsoline, Place, Raster, RasterJob, Writer, isolines};
use std::collections::BTreeMap;
use std::rc::Rc;

/// Pixels that are looked at between two looks at the clock.
const BATCH: usize = 1 << 14;
/// Share of the work that blends are.
const BLENDS: f64 = 0.3;

/// An answer to a [question](PartAsk).
#[derive(Debug, Clone)]
pub enum PartAnswer {
    /// What the model of the part says.
    Model,
    /// The document, which the model has.
    Defaults,
    /// What there is on pixels, with colours (red, green, blue, alpha) where they were asked for.
    Raster(Rc<Raster>, Option<Vec<u8>>),
    /// What there is at a point.
    Place(Option<Place>),
    /// What there is along a line.
    Along(Along),
    /// Of each pixel which rules it breaks, by bits, and the number of pixels of each rule.
    Violations(Rc<Raster>, Vec<u32>, Vec<usize>),
    /// Area and amount of each material.
    Amounts(PartAmounts),
    /// Lines of each level.
    Isolines(Vec<(f64, Vec<PartIsoline>)>),
    /// The leaves that there are, body after body.
    Leaves(Vec<LeafRow>),
    /// The bytes of a file.
    File(Vec<u8>),
}

/// What there is along a line.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Along {
    /// Of each place 0 outside, else one more than the index of the body.
    pub body: Vec<u8>,
    /// Fraction of each material; no number outside, and in bodies by the printed rule.
    pub fractions: Vec<Vec<f64>>,
    /// Which features hold the place, by bits.
    pub leaves: Vec<u32>,
}

/// Area and amount of each material.
#[derive(Debug, Clone, PartialEq)]
pub struct PartAmounts {
    /// Area of each body, as far as it is seen.
    pub areas: Vec<f64>,
    /// Amount of each material in each body.
    pub amounts: Vec<Vec<f64>>,
}

/// A leaf of the subdivision of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct LeafRow {
    /// Index of the body.
    pub body: usize,
    /// Which features hold it, by bits.
    pub leaf: u32,
    /// Its area.
    pub area: f64,
}

/// The job that answers a question about a part in steps.
#[derive(Debug)]
pub struct PartJob {
    known: Rc<KnownPart>,
    ask: PartAsk,
    /// Whether blends had to be solved first.
    has_blends: bool,
    work: Work,
}

#[derive(Debug)]
enum Work {
    /// It is to be decided what comes next.
    Planning,
    /// Blends are being solved.
    Blending,
    Evaluating(Box<RasterJob<Rc<Part>>>),
    Coloring(Rc<Raster>, Vec<u8>),
    Following(usize, Along),
    /// The rule and the pixel that are next.
    Checking(Rc<Raster>, [usize; 2], Vec<u32>, Vec<usize>),
    Summing(Rc<Raster>, usize, PartAmounts),
    Tracing(Rc<Raster>, Vec<(f64, Vec<PartIsoline>)>),
    Counting(Rc<Raster>, usize, BTreeMap<(u8, u32), usize>),
    Writing(Rc<Raster>, Box<Writer>),
    Done(Option<PartAnswer>),
}

impl PartJob {
    /// The job for a question that was read for this part.
    #[must_use]
    pub fn new(known: Rc<KnownPart>, ask: PartAsk) -> Self {
        let has_blends = known.blended() < 1.0;
        Self { known, ask, has_blends, work: Work::Planning }
    }

    /// Advances while `may_go_on` says so, at least by a little; returns the answer, and nothing more ever after.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> Option<PartAnswer> {
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
    pub fn run(mut self) -> Option<PartAnswer> {
        self.step(&mut || true)
    }

    /// Share of the work that is done, below 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        let later = |raster: &Raster, next: usize| 0.8 + 0.2 * next as f64 / raster.frame.count() as f64;
        let share = match &self.work {
            Work::Planning | Work::Done(_) => 0.0,
            Work::Blending => return BLENDS * self.known.blended(),
            Work::Evaluating(job) => 0.8 * job.progress(),
            Work::Coloring(raster, colors) => later(raster, colors.len() / 4),
            Work::Summing(raster, next, _) | Work::Counting(raster, next, _) => later(raster, *next),
            Work::Checking(_, [rule, _], ..) => {
                0.8 + 0.2 * *rule as f64 / self.known.model().rules().len().max(1) as f64
            }
            Work::Following(next, _) => match self.ask {
                PartAsk::Along { count, .. } => *next as f64 / count as f64,
                _ => 0.0,
            },
            Work::Tracing(_, lines) => match &self.ask {
                PartAsk::Isolines { levels, .. } => 0.8 + 0.2 * lines.len() as f64 / levels.len() as f64,
                _ => 0.0,
            },
            Work::Writing(raster, writer) => 0.8 + 0.2 * writer.progress(raster),
        };
        let before = if self.has_blends { BLENDS } else { 0.0 };
        (before + (1.0 - before) * share).min(0.999)
    }

    fn advance(&self, work: Work, may_go_on: &mut dyn FnMut() -> bool) -> Work {
        match work {
            Work::Planning => self.plan(),
            Work::Blending => {
                self.known.blend(may_go_on);
                self.plan()
            }
            Work::Evaluating(mut job) => {
                if !job.step(may_go_on) {
                    return Work::Evaluating(job);
                }
                self.use_of(self.known.keep(job.raster()))
            }
            Work::Coloring(raster, mut colors) => {
                let next = colors.len() / 4;
                let end = (next + BATCH).min(raster.body.len());
                self.color(&raster, next..end, &mut colors);
                if end < raster.body.len() {
                    return Work::Coloring(raster, colors);
                }
                Work::Done(Some(PartAnswer::Raster(raster, Some(colors))))
            }
            Work::Following(next, mut along) => {
                let PartAsk::Along { ends: [start, end], count } = self.ask else { return Work::Done(None) };
                if next == count {
                    return Work::Done(Some(PartAnswer::Along(along)));
                }
                let place = self.known.part().place(start.lerp(end, next as f64 / (count - 1) as f64));
                along.body.push(place.as_ref().map_or(0, |place| place.body as u8 + 1));
                along.leaves.push(place.as_ref().map_or(0, |place| place.leaf));
                let fractions = place.and_then(|place| place.fractions);
                for (k, list) in along.fractions.iter_mut().enumerate() {
                    list.push(fractions.as_ref().map_or(f64::NAN, |fractions| fractions[k]));
                }
                Work::Following(next + 1, along)
            }
            Work::Checking(raster, at, masks, counts) => self.check(raster, at, masks, counts),
            Work::Summing(raster, next, mut amounts) => {
                let end = (next + BATCH).min(raster.body.len());
                sum(&raster, next..end, &mut amounts);
                if end < raster.body.len() {
                    return Work::Summing(raster, end, amounts);
                }
                Work::Done(Some(PartAnswer::Amounts(amounts)))
            }
            Work::Tracing(raster, mut lines) => {
                let PartAsk::Isolines { material, levels, .. } = &self.ask else { return Work::Done(None) };
                let Some(level) = levels.get(lines.len()) else {
                    return Work::Done(Some(PartAnswer::Isolines(lines)));
                };
                lines.push((*level, isolines(&raster, *material, *level as f32)));
                Work::Tracing(raster, lines)
            }
            Work::Counting(raster, next, mut counts) => {
                let end = (next + BATCH).min(raster.body.len());
                for at in (next..end).filter(|at| raster.body[*at] > 0) {
                    *counts.entry((raster.body[at], raster.leaves[at])).or_default() += 1;
                }
                if end < raster.body.len() {
                    return Work::Counting(raster, end, counts);
                }
                let pixel = raster.frame.step().x * raster.frame.step().y;
                let row = |((body, leaf), count): ((u8, u32), usize)| LeafRow {
                    body: usize::from(body) - 1,
                    leaf,
                    area: count as f64 * pixel,
                };
                Work::Done(Some(PartAnswer::Leaves(counts.into_iter().map(row).collect())))
            }
            Work::Writing(raster, mut writer) => match writer.step(&raster, may_go_on) {
                None => Work::Writing(raster, writer),
                Some(bytes) => Work::Done(Some(PartAnswer::File(bytes))),
            },
            Work::Done(_) => Work::Done(None),
        }
    }

    fn plan(&self) -> Work {
        if self.known.blended() < 1.0 && self.ask != PartAsk::Defaults {
            return Work::Blending;
        }
        if let Some(frame) = self.ask.frame() {
            if let Some(raster) = self.known.raster(&frame) {
                return self.use_of(raster);
            }
            let job = RasterJob::new(self.known.part(), frame);
            return job.map_or(Work::Done(None), |job| Work::Evaluating(Box::new(job)));
        }
        match &self.ask {
            PartAsk::Defaults => Work::Done(Some(PartAnswer::Defaults)),
            PartAsk::Probe(point) => Work::Done(Some(PartAnswer::Place(self.known.part().place(*point)))),
            PartAsk::Along { .. } => {
                let along =
                    Along { fractions: vec![Vec::new(); self.known.part().materials], ..Along::default() };
                Work::Following(0, along)
            }
            _ => Work::Done(Some(PartAnswer::Model)),
        }
    }

    /// What is made of a raster.
    fn use_of(&self, raster: Rc<Raster>) -> Work {
        let model = self.known.model();
        match &self.ask {
            PartAsk::Evaluate { has_colors: true, .. } => {
                let colors = Vec::with_capacity(4 * raster.body.len());
                Work::Coloring(raster, colors)
            }
            PartAsk::Violations(_) => {
                let (masks, counts) = (vec![0; raster.body.len()], vec![0; model.rules().len()]);
                Work::Checking(raster, [0, 0], masks, counts)
            }
            PartAsk::Amounts(_) => {
                let bodies = model.part().bodies.len();
                let amounts = vec![vec![0.0; model.materials().len()]; bodies];
                Work::Summing(raster, 0, PartAmounts { areas: vec![0.0; bodies], amounts })
            }
            PartAsk::Isolines { .. } => Work::Tracing(raster, Vec::new()),
            PartAsk::Leaves(_) => Work::Counting(raster, 0, BTreeMap::new()),
            PartAsk::File { format, .. } => {
                let names = model.materials().iter().map(|material| material.name.clone()).collect();
                let writer = Writer::new(*format, &raster, names, self.known.palette().clone());
                Work::Writing(raster, Box::new(writer))
            }
            _ => Work::Done(Some(PartAnswer::Raster(raster, None))),
        }
    }

    fn color(&self, raster: &Raster, pixels: std::ops::Range<usize>, colors: &mut Vec<u8>) {
        let mut last = [0; 4];
        for at in pixels.clone() {
            // Neighbours are often alike: where no feature acts, and along the lines of a gradient.
            let is_alike = at > pixels.start
                && raster.body[at - 1] == raster.body[at]
                && raster.fractions.iter().all(|list| list[at - 1] == list[at]);
            if !is_alike {
                last = if raster.body[at] == 0 {
                    [0; 4]
                } else {
                    let [r, g, b] = self.known.palette().color(raster.fractions.iter().map(|list| list[at]));
                    [r, g, b, u8::MAX]
                };
            }
            colors.extend_from_slice(&last);
        }
    }

    fn check(
        &self,
        raster: Rc<Raster>,
        [number, next]: [usize; 2],
        mut masks: Vec<u32>,
        mut counts: Vec<usize>,
    ) -> Work {
        let Some(rule) = self.known.model().rules().get(number) else {
            return Work::Done(Some(PartAnswer::Violations(raster, masks, counts)));
        };
        let (Some(rule), Some(grid), true) = (rule, raster.frame.grid(), next < raster.body.len()) else {
            return Work::Checking(raster, [number + 1, 0], masks, counts);
        };
        let end = (next + BATCH).min(raster.body.len());
        let is_inside = |at: usize| raster.body[at] > 0;
        for at in rule.violations_within(&grid, &is_inside, &raster.fractions[rule.material], next..end) {
            masks[at as usize] |= 1 << number;
            counts[number] += 1;
        }
        Work::Checking(raster, [number, end], masks, counts)
    }
}

fn sum(raster: &Raster, pixels: std::ops::Range<usize>, amounts: &mut PartAmounts) {
    let pixel = raster.frame.step().x * raster.frame.step().y;
    for at in pixels {
        if let Some(body) = usize::from(raster.body[at]).checked_sub(1) {
            amounts.areas[body] += pixel;
            for (amount, list) in amounts.amounts[body].iter_mut().zip(&raster.fractions) {
                *amount += pixel * f64::from(list[at]);
            }
        }
    }
}
