//! Parts on pixels.

use super::{Body, Composing, Frame, FrameError, Part};
use crate::field::PrintedJob;
use crate::laplace::{self, Section, SectionJob, Solution};
use glam::{DVec2, dvec2};
use std::ops::{Deref, Range};
use std::rc::Rc;

/// Pixels along the side of a tile.
const TILE: usize = 16;

/// Pixels of a band of a blend, about: what is found for it is held besides the raster.
const BAND: usize = 1 << 18;

/// What a part holds on pixels.
#[derive(Debug, Clone, PartialEq)]
pub struct Raster {
    /// The pixels.
    pub frame: Frame,
    /// 0 outside, else one more than the index of the body.
    pub body: Vec<u8>,
    /// Fraction of each material; 0 outside.
    pub fractions: Vec<Vec<f32>>,
    /// Which features hold a pixel, by bits; 0 outside.
    pub leaves: Vec<u32>,
}

/// A block of pixels.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tile {
    /// Centre of the first pixel.
    first: DVec2,
    step: DVec2,
    pub(super) width: usize,
    pub(super) height: usize,
}

impl Tile {
    pub(super) fn center(&self, i: usize, j: usize) -> DVec2 {
        dvec2(self.first.x + i as f64 * self.step.x, self.first.y - j as f64 * self.step.y)
    }

    pub(super) fn all(&self) -> [usize; 4] {
        [0, 0, self.width, self.height]
    }

    /// Centre and half diagonal of a block of centres: first column, first row, width and height.
    pub(super) fn disc(&self, [x, y, width, height]: [usize; 4]) -> (DVec2, f64) {
        let [a, b] = [self.center(x, y), self.center(x + width - 1, y + height - 1)];
        ((a + b) / 2.0, a.distance(b) / 2.0)
    }
}

/// The job that evaluates a part on pixels, in steps: rows of bodies first, then blends, then compositions in tiles, then bodies by the printed rule.
#[derive(Debug)]
pub struct RasterJob<P: Deref<Target = Part>> {
    part: P,
    raster: Raster,
    stage: Stage,
    /// Distances to the features of each body by the printed rule.
    near: Vec<Vec<Vec<f32>>>,
    work: Workspace,
}

#[derive(Debug)]
enum Stage {
    /// The row that is next.
    Rows(usize),
    /// The body whose blend is next, the first row of its next band, and the band that is under way.
    Blending(usize, usize, Option<Box<SectionJob<Rc<Solution>>>>),
    /// The body, a band of its blend, the pixel where this begins, and the row of it that is next.
    Laying(usize, Section, [usize; 2], usize),
    /// The tile that is next, and the body.
    Tiles(usize, usize),
    /// The body that is next, and what is under way.
    Printing(usize, Option<Box<PrintedJob>>),
    Done,
}

/// What a tile needs and no other one has to make anew.
#[derive(Debug, Default)]
struct Workspace {
    /// Distances to the features, one list of pixels after the other.
    distances: Vec<f64>,
    /// Distances to the references of a feature.
    parts: Vec<f64>,
    list: Vec<u32>,
    own: Vec<f64>,
    /// What profiles lie on.
    base: Vec<f64>,
    fractions: Vec<f64>,
}

impl<P: Deref<Target = Part>> RasterJob<P> {
    /// # Errors
    /// As [`Frame::check`].
    pub fn new(part: P, frame: Frame) -> Result<Self, FrameError> {
        frame.check(&part)?;
        let count = frame.count();
        let near = |body: &Option<Body>| {
            let printed = body.as_ref().filter(|body| body.composing == Composing::Printed);
            printed.map_or_else(Vec::new, |body| vec![vec![f32::INFINITY; count]; body.features.len()])
        };
        let raster = Raster {
            frame,
            body: vec![0; count],
            fractions: vec![vec![0.0; count]; part.materials],
            leaves: vec![0; count],
        };
        let near = part.bodies.iter().map(near).collect();
        let work = Workspace { fractions: vec![0.0; part.materials], ..Workspace::default() };
        Ok(Self { part, raster, stage: Stage::Rows(0), near, work })
    }

    /// Advances while `may_go_on` says so, at least by a little; returns whether all is done.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> bool {
        loop {
            let stage = std::mem::replace(&mut self.stage, Stage::Done);
            self.stage = match stage {
                Stage::Rows(row) if row < self.raster.frame.size()[1] => {
                    self.fill_row(row);
                    Stage::Rows(row + 1)
                }
                Stage::Rows(_) => Stage::Blending(0, 0, None),
                Stage::Blending(body, row, job) => self.blend(body, row, job, may_go_on),
                Stage::Laying(body, section, start, row) => self.lay(body, section, start, row),
                Stage::Tiles(tile, body) => self.advance(tile, body),
                Stage::Printing(body, job) => self.print(body, job, may_go_on),
                Stage::Done => return true,
            };
            if !may_go_on() {
                return matches!(self.stage, Stage::Done);
            }
        }
    }

    /// Share of the work that is done, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        match &self.stage {
            Stage::Rows(row) => 0.1 * *row as f64 / self.raster.frame.size()[1] as f64,
            Stage::Blending(body, row, _) | Stage::Laying(body, _, [_, row], _) => {
                let done = *body as f64 + *row as f64 / self.raster.frame.size()[1] as f64;
                0.1 + 0.3 * done / (self.part.bodies.len() + 1) as f64
            }
            Stage::Tiles(tile, _) => 0.4 + 0.4 * *tile as f64 / self.tiles() as f64,
            Stage::Printing(body, job) => {
                let bodies = self.part.bodies.len().max(1) as f64;
                0.8 + 0.19 * (*body as f64 + job.as_ref().map_or(0.0, |job| job.progress())) / bodies
            }
            Stage::Done => 1.0,
        }
    }

    /// The raster, once all is done.
    #[must_use]
    pub fn raster(self) -> Raster {
        self.raster
    }

    /// Runs the job to its end.
    #[must_use]
    pub fn run(mut self) -> Raster {
        while !self.step(&mut || true) {}
        self.raster
    }

    fn fill_row(&mut self, row: usize) {
        let frame = self.raster.frame;
        let start = frame.center(0, row);
        let marks = &mut self.raster.body[row * frame.size()[0]..(row + 1) * frame.size()[0]];
        for (index, body) in self.part.bodies.iter().enumerate() {
            if let Some(body) = body {
                let mark = |column: usize| marks[column] = index as u8 + 1;
                body.region.row(start.y, start.x, frame.step().x, mark, frame.size()[0]);
            }
        }
    }

    /// The pixels of the box of a body: columns and rows.
    fn columns_and_rows(&self, body: &Body) -> [Range<usize>; 2] {
        let (frame, step) = (self.raster.frame, self.raster.frame.step());
        let (own, all) = (body.region.bounds(), frame.bounds());
        let pixel = |along: f64, count: usize| (along.max(0.0) as usize).min(count);
        let [nx, ny] = frame.size();
        [
            pixel((own.min.x - all.min.x) / step.x, nx)..pixel((own.max.x - all.min.x) / step.x + 1.0, nx),
            pixel((all.max.y - own.max.y) / step.y, ny)..pixel((all.max.y - own.min.y) / step.y + 1.0, ny),
        ]
    }

    /// Goes on with the blends of bodies, each on the pixels of its box, in bands of rows.
    fn blend(
        &mut self,
        index: usize,
        row: usize,
        job: Option<Box<SectionJob<Rc<Solution>>>>,
        may_go_on: &mut dyn FnMut() -> bool,
    ) -> Stage {
        let Some(body) = self.part.bodies.get(index) else { return Stage::Tiles(0, 0) };
        let Some((body, blend)) = body.as_ref().and_then(|body| Some((body, body.blend.as_ref()?))) else {
            return Stage::Blending(index + 1, 0, None);
        };
        let [columns, rows] = self.columns_and_rows(body);
        let start = [columns.start, row.max(rows.start)];
        if let Some(mut job) = job {
            return if job.step(may_go_on) {
                Stage::Laying(index, job.section(), start, 0)
            } else {
                Stage::Blending(index, row, Some(job))
            };
        }
        let height = (BAND / columns.len().max(1)).max(TILE).min(rows.end.saturating_sub(start[1]));
        let step = self.raster.frame.step();
        let corner = self.raster.frame.center(start[0], start[1]) + dvec2(-0.5, 0.5) * step;
        let side = |along: f64, up: f64| dvec2(along, up).extend(0.0);
        let frame = laplace::Frame {
            origin: corner.extend(0.0),
            sides: [side(step.x * columns.len() as f64, 0.0), side(0.0, -step.y * height as f64)],
            size: [columns.len(), height],
        };
        // Without pixels left there is no section.
        match SectionJob::new(Rc::clone(blend.solution()), frame) {
            Ok(job) => Stage::Blending(index, row, Some(Box::new(job))),
            Err(_) => Stage::Blending(index + 1, 0, None),
        }
    }

    /// Gives the pixels of a body in a row the fractions of its blend, on which its profiles lie later.
    fn lay(&mut self, index: usize, section: Section, start: [usize; 2], row: usize) -> Stage {
        let [width, height] = section.size;
        let blend = self.part.bodies[index].as_ref().and_then(|body| body.blend.as_ref());
        let (Some(blend), true) = (blend, row < height) else {
            return Stage::Blending(index, start[1] + height, None);
        };
        let fractions = &mut self.work.fractions;
        for column in 0..width {
            let at = (start[1] + row) * self.raster.frame.size()[0] + start[0] + column;
            if usize::from(self.raster.body[at]) != index + 1 {
                continue;
            }
            let values = section.values.iter().map(|list| f64::from(list[row * width + column]));
            fractions.iter_mut().zip(values).for_each(|(to, from)| *to = from);
            if fractions[0].is_nan() {
                blend.nearest(self.raster.frame.center(start[0] + column, start[1] + row), fractions);
            } else {
                blend.finish(fractions);
            }
            let lists = self.raster.fractions.iter_mut().zip(&*fractions);
            lists.for_each(|(list, from)| list[at] = *from as f32);
        }
        Stage::Laying(index, section, start, row + 1)
    }

    fn tiles(&self) -> usize {
        self.raster.frame.size().map(|along| along.div_ceil(TILE)).iter().product()
    }

    /// The next tile that has pixels of a body, and what comes after it.
    fn advance(&mut self, mut tile: usize, mut index: usize) -> Stage {
        let (count, bodies) = (self.tiles(), self.part.bodies.len());
        // A few tiles without work take no turn of their own.
        for _ in 0..64 * bodies.max(1) {
            if index >= bodies {
                (tile, index) = (tile + 1, 0);
            }
            if tile >= count || bodies == 0 {
                return Stage::Printing(0, None);
            }
            if self.compose(tile, index) {
                return Stage::Tiles(tile, index + 1);
            }
            index += 1;
        }
        Stage::Tiles(tile, index)
    }

    /// Evaluates the pixels that a body has in a tile; returns whether there are any.
    fn compose(&mut self, tile: usize, index: usize) -> bool {
        let (frame, part) = (self.raster.frame, &*self.part);
        let [nx, ny] = frame.size();
        let columns = nx.div_ceil(TILE);
        let [x, y] = [tile % columns * TILE, tile / columns * TILE];
        let [width, height] = [TILE.min(nx - x), TILE.min(ny - y)];
        let row = |j: usize| (y + j) * nx + x..(y + j) * nx + x + width;
        let number = index as u8 + 1;
        let Some(body) = &part.bodies[index] else { return false };
        if !(0..height).any(|j| self.raster.body[row(j)].contains(&number)) {
            return false;
        }
        let tile = Tile { first: frame.center(x, y), step: frame.step(), width, height };
        let pixels = width * height;
        let work = &mut self.work;
        work.distances.resize(body.features.len() * pixels, 0.0);
        let is_printed = body.composing == Composing::Printed;
        let mut is_free = true;
        for (k, (feature, profile)) in body.features.iter().zip(body.overlap.profiles()).enumerate() {
            let distances = &mut work.distances[k * pixels..(k + 1) * pixels];
            if let Some(reference) = feature.single() {
                let (center, radius) = tile.disc(tile.all());
                let distance = reference.distance(center);
                if !is_printed && (distance - radius > profile.to() || distance + radius < profile.from()) {
                    distances.fill(f64::INFINITY);
                    continue;
                }
                reference.measure(&tile, distances, &mut work.list);
            } else {
                let references = feature.references();
                work.parts.resize(references.len() * pixels, 0.0);
                for (part, reference) in work.parts.chunks_exact_mut(pixels).zip(references) {
                    reference.measure(&tile, part, &mut work.list);
                }
                for (pixel, distance) in distances.iter_mut().enumerate() {
                    work.own.clear();
                    work.own.extend(work.parts.iter().skip(pixel).step_by(pixels));
                    *distance = feature.combine(&work.own);
                }
            }
            is_free = false;
        }
        if is_printed {
            for (k, near) in self.near[index].iter_mut().enumerate() {
                for j in 0..height {
                    let distances = &work.distances[k * pixels + j * width..][..width];
                    near[row(j)].iter_mut().zip(distances).for_each(|(to, from)| *to = *from as f32);
                }
            }
            return true;
        }
        let default = body.overlap.default_composition().fractions();
        for j in 0..height {
            for (i, at) in row(j).enumerate() {
                if self.raster.body[at] != number {
                    continue;
                }
                if is_free && body.blend.is_some() {
                    continue;
                }
                if is_free {
                    self.raster
                        .fractions
                        .iter_mut()
                        .zip(default)
                        .for_each(|(to, from)| to[at] = *from as f32);
                    continue;
                }
                let pixel = j * width + i;
                work.own.resize(body.features.len(), 0.0);
                for (k, distance) in work.own.iter_mut().enumerate() {
                    *distance = work.distances[k * pixels + pixel];
                }
                let leaf = if body.blend.is_some() {
                    work.base.clear();
                    work.base.extend(self.raster.fractions.iter().map(|list| f64::from(list[at])));
                    body.overlap.over(&work.base, &work.own, &mut work.fractions)
                } else {
                    body.overlap.fractions(&work.own, &mut work.fractions)
                };
                self.raster.leaves[at] = body.leaf(leaf);
                let fractions = self.raster.fractions.iter_mut().zip(&work.fractions);
                fractions.for_each(|(to, from)| to[at] = *from as f32);
            }
        }
        true
    }

    /// Goes on with the bodies by the printed rule.
    fn print(
        &mut self,
        index: usize,
        job: Option<Box<PrintedJob>>,
        may_go_on: &mut dyn FnMut() -> bool,
    ) -> Stage {
        let Some(body) = self.part.bodies.get(index) else { return Stage::Done };
        let printed = body.as_ref().filter(|body| body.composing == Composing::Printed);
        let (Some(body), Some(grid)) = (printed, self.raster.frame.grid()) else {
            return Stage::Printing(index + 1, None);
        };
        let number = index as u8 + 1;
        let Some(mut job) = job else {
            let is_inside = self.raster.body.iter().map(|body| *body == number).collect();
            let profiles = body.overlap.profiles().cloned().collect();
            let near = std::mem::take(&mut self.near[index]);
            let default = body.overlap.default_composition();
            return match PrintedJob::new(&grid, is_inside, default, profiles, near) {
                Ok(job) => Stage::Printing(index, Some(Box::new(job))),
                Err(_) => Stage::Printing(index + 1, None),
            };
        };
        if let Ok(false) = job.step(may_go_on) {
            return Stage::Printing(index, Some(job));
        }
        let made = job.made();
        for at in (0..self.raster.body.len()).filter(|at| self.raster.body[*at] == number) {
            self.raster.leaves[at] = body.leaf(made.leaves[at]);
            for (to, from) in self.raster.fractions.iter_mut().zip(&made.fractions) {
                to[at] = from[at];
            }
        }
        Stage::Printing(index + 1, None)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Feature, Path, Reference, Region, Shape};
    use super::*;
    use crate::field::{Course, DistanceProfile, Expression, Overlap, Rule};
    use crate::geom::Bounds;
    use crate::material::Composition;
    use std::rc::Rc;

    fn polygon(points: &[[f64; 2]]) -> Shape {
        let points: Vec<DVec2> = points.iter().copied().map(DVec2::from_array).collect();
        Shape::Closed(Rc::new(Path::through(&points, true).expect("points")))
    }

    fn rectangle(width: f64, height: f64) -> Shape {
        polygon(&[[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]])
    }

    fn edge(from: [f64; 2], to: [f64; 2]) -> Shape {
        let ends = [DVec2::from_array(from), DVec2::from_array(to)];
        Shape::Open(Rc::new(Path::through(&ends, false).expect("points")))
    }

    /// From one material to the last of three.
    fn profile(material: usize, from: f64, to: f64, course: Course) -> DistanceProfile {
        let mixes = [Composition::pure(material, 3), Composition::pure(2, 3)];
        DistanceProfile::new([from, to], mixes, course).expect("a profile")
    }

    fn body(outline: Shape, holes: Vec<Shape>, rule: Rule, parts: Vec<(Shape, DistanceProfile)>) -> Body {
        let region = Region::new(outline, holes).expect("a region");
        let slots = (0..parts.len() as u32).collect();
        let (shapes, profiles): (Vec<Shape>, Vec<DistanceProfile>) = parts.into_iter().unzip();
        let overlap = Overlap::new(rule, region.bounds().diagonal(), Composition::pure(2, 3), profiles);
        let features = shapes.into_iter().map(|shape| Feature::new(Reference::shape(shape))).collect();
        Body { region, composing: Composing::Overlap, overlap, blend: None, features, slots }
    }

    fn part(bodies: Vec<Body>) -> Part {
        Part { materials: 3, bodies: bodies.into_iter().map(Some).collect() }
    }

    fn raster(part: &Part, size: [usize; 2]) -> Raster {
        let frame = Frame::new(part.bounds().expect("a body"), size).expect("a frame");
        RasterJob::new(part, frame).expect("a job").run()
    }

    /// The rectangle of Fig. 6 with limits of 30.
    fn two_profiles(rule: Rule) -> Part {
        let [a, b] = [[0.0, 60.0], [100.0, 0.0]].map(|end| edge([0.0, 0.0], end));
        let parts =
            vec![(a, profile(0, 0.0, 30.0, Course::Linear)), (b, profile(1, 0.0, 30.0, Course::Linear))];
        part(vec![body(rectangle(100.0, 60.0), Vec::new(), rule, parts)])
    }

    /// Also over many tiles, as a page asks for it of a new document.
    #[test]
    fn a_part_without_bodies_is_empty_everywhere() {
        let bounds = Bounds { min: DVec2::ZERO, max: dvec2(4.0, 3.0) };
        let nothing = part(Vec::new());
        let frame = Frame::new(bounds, [200, 150]).expect("a frame");
        let found = RasterJob::new(&nothing, frame).expect("a job").run();
        assert!(found.body.iter().all(|number| *number == 0));
        assert!(found.fractions.iter().flatten().all(|fraction| *fraction == 0.0));
    }

    /// Tiles, narrowed candidates and skipped bands give what every pixel by itself gives.
    #[test]
    fn a_raster_is_every_pixel_by_itself() {
        let wavy: Vec<[f64; 2]> = (0..300)
            .map(|k| {
                let angle = f64::from(k) * std::f64::consts::TAU / 300.0;
                let radius = 30.0 + 6.0 * (7.0 * angle).sin();
                [50.0 + radius * angle.cos(), 40.0 + radius * angle.sin()]
            })
            .collect();
        let outline = polygon(&wavy);
        let hole = Shape::Circle { center: dvec2(45.0, 42.0), radius: 9.0 };
        let line = Shape::Line { through: dvec2(0.0, 35.0), direction: dvec2(0.8, 0.6) };
        let parts = vec![
            (outline.clone(), profile(0, 0.0, 5.0, Course::Smoothstep)),
            (hole.clone(), profile(1, 2.0, 8.0, Course::Linear)),
            (line, profile(0, 0.0, 6.0, Course::Power(2.0))),
            (Shape::Point(dvec2(70.0, 40.0)), profile(1, 0.0, 7.0, Course::Linear)),
        ];
        let mut first = body(outline, vec![hole], Rule::Repaired, parts);
        let references = [dvec2(60.0, 60.0), dvec2(30.0, 20.0)].map(|at| Reference::shape(Shape::Point(at)));
        let sum = Expression::new("(a + b) / 2", &["a", "b"]).expect("an expression");
        first.features[3] = Feature::of_several(references.to_vec(), sum);
        let over = body(rectangle(30.0, 25.0), Vec::new(), Rule::Depth, Vec::new());
        let part = part(vec![first, over]);
        let found = raster(&part, [93, 71]);
        let mut leaves = std::collections::BTreeSet::new();
        for at in 0..93 * 71 {
            let point = found.frame.center(at % 93, at / 93);
            let place = part.place(point);
            assert_eq!(
                usize::from(found.body[at]),
                place.as_ref().map_or(0, |place| place.body + 1),
                "{point}"
            );
            let fractions: Vec<f32> = found.fractions.iter().map(|list| list[at]).collect();
            let Some(place) = place else {
                assert_eq!((fractions, found.leaves[at]), (vec![0.0; 3], 0));
                continue;
            };
            assert_eq!(found.leaves[at], place.leaf, "{point}");
            leaves.insert(place.leaf);
            let expected = place.fractions.expect("by its overlap");
            assert!(
                fractions.iter().zip(&expected).all(|(a, b)| (f64::from(*a) - b).abs() < 1e-6),
                "{point}"
            );
            assert!((expected.iter().sum::<f64>() - 1.0).abs() < 1e-12 && expected.iter().all(|f| *f >= 0.0));
        }
        assert!(leaves.len() > 6, "{leaves:?}");
    }

    #[test]
    fn two_profiles_have_four_leaves_and_full_strength_on_their_own_features() {
        let part = two_profiles(Rule::Repaired);
        let found = raster(&part, [100, 60]);
        let leaves: std::collections::BTreeSet<u32> = found.leaves.iter().copied().collect();
        assert_eq!(leaves.into_iter().collect::<Vec<_>>(), [0, 1, 2, 3]);
        let at = |x: f64, y: f64| part.place(dvec2(x, y)).and_then(|place| place.fractions).expect("inside");
        for k in 1..30 {
            let along = f64::from(k);
            assert!((at(1e-9, along)[0] - 1.0).abs() < 1e-6 && (at(along, 1e-9)[1] - 1.0).abs() < 1e-6);
        }
        // Outside the other band each is its function.
        assert!((at(12.0, 45.0)[0] - 0.6).abs() < 1e-12 && (at(70.0, 21.0)[1] - 0.3).abs() < 1e-12);
    }

    #[test]
    fn compositions_are_continuous_across_leaves_and_the_order_has_no_say() {
        for rule in [Rule::Repaired, Rule::Depth] {
            let part = two_profiles(rule);
            let mut turned = part.clone();
            let body = turned.bodies[0].as_mut().expect("a body");
            body.features.reverse();
            body.slots.reverse();
            let profiles = body.overlap.profiles().rev().cloned().collect();
            let default = body.overlap.default_composition().clone();
            body.overlap = Overlap::new(rule, body.region.bounds().diagonal(), default, profiles);
            let frame = Frame::new(part.bounds().expect("a body"), [400, 240]).expect("a frame");
            let [found, other] =
                [&part, &turned].map(|part| RasterJob::new(part, frame).expect("a job").run());
            assert_eq!(found.leaves, other.leaves);
            for (a, b) in found.fractions.iter().zip(&other.fractions) {
                assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-6));
                // Beyond 5 of the common corner slopes stay below 1 / 5.
                for at in 0..400 * 240 - 400 {
                    let place = frame.center(at % 400, at / 400);
                    for next in [at + 1, at + 400] {
                        let is_row = at % 400 < 399 || next == at + 400;
                        let step = 0.25 * if is_row { 1.0 } else { f64::INFINITY };
                        assert!(
                            place.length() < 5.0 || f64::from((a[at] - a[next]).abs()) < 0.3 * step,
                            "{rule:?} at {place}"
                        );
                    }
                }
            }
        }
    }

    /// The amount of the first material in a rectangle with a linear gradient from an edge, and in a ring about a circle.
    #[test]
    fn amounts_converge_to_those_of_closed_forms() {
        let amount = |raster: &Raster| {
            let step = raster.frame.step();
            raster.fractions[0].iter().map(|fraction| f64::from(*fraction)).sum::<f64>() * step.x * step.y
        };
        let gradient = vec![(edge([0.0, 0.0], [0.0, 50.0]), profile(0, 0.0, 80.0, Course::Linear))];
        let straight = part(vec![body(rectangle(100.0, 50.0), Vec::new(), Rule::Repaired, gradient)]);
        // Half of 80 x 50; pixels meet the limit, so that the midpoint rule is exact.
        assert!((amount(&raster(&straight, [100, 50])) - 2000.0).abs() < 1e-3);

        let circle = |radius: f64| Shape::Circle { center: dvec2(3.0, -2.0), radius };
        let ring = vec![(circle(4.0), profile(0, 0.0, 5.0, Course::Linear))];
        let ring = part(vec![body(circle(10.0), vec![circle(4.0)], Rule::Repaired, ring)]);
        // 2 pi times the integral of (1 - (r - 4) / 5) r from 4 to 9.
        let exact = std::f64::consts::TAU * (5.0 * 4.0 / 2.0 + 25.0 / 6.0);
        let error = |size: usize| (amount(&raster(&ring, [size, size])) - exact).abs() / exact;
        let errors = [40, 160, 640].map(error);
        assert!(errors[1] < errors[0] / 4.0 && errors[2] < errors[1] / 4.0 && errors[2] < 1e-4, "{errors:?}");
    }

    /// The far end of the lone profile fades by Eq. 2 as printed, which the raster carries out; everything else of it is as elsewhere.
    #[test]
    fn the_printed_rule_runs_on_the_pixels() {
        let mut part = two_profiles(Rule::Repaired);
        part.bodies[0].as_mut().expect("a body").composing = Composing::Printed;
        let found = raster(&part, [200, 120]);
        let at = |x: usize| found.fractions[1][119 * 200 + x];
        assert!(at(190) < 0.5 && at(62) > 0.9, "{} and {}", at(190), at(62));
        let repaired = raster(&two_profiles(Rule::Repaired), [200, 120]);
        assert_eq!((&found.leaves, &found.body), (&repaired.leaves, &repaired.body));
        let alone = found.leaves.iter().enumerate().filter(|(_, leaf)| **leaf == 0).map(|(at, _)| at);
        assert!(alone.into_iter().all(|at| found.fractions[2][at] == 1.0));
    }

    #[test]
    fn steps_give_what_one_call_gives() {
        let mut part = two_profiles(Rule::Depth);
        part.bodies.push(two_profiles(Rule::Repaired).bodies.remove(0));
        part.bodies[1].as_mut().expect("a body").composing = Composing::Printed;
        let frame = Frame::new(part.bounds().expect("a body"), [37, 21]).expect("a frame");
        let mut job = RasterJob::new(&part, frame).expect("a job");
        let (mut steps, mut last) = (0, 0.0);
        while !job.step(&mut || false) {
            assert!(job.progress() >= last && job.progress() < 1.0);
            last = job.progress();
            steps += 1;
        }
        assert!(steps > 30, "{steps}");
        assert_eq!((job.progress(), job.raster()), (1.0, raster(&part, [37, 21])));
    }

    #[test]
    fn too_many_pixels_for_the_printed_rule_are_refused_before_the_work_begins() {
        let mut part = two_profiles(Rule::Repaired);
        let frame = Frame::new(part.bounds().expect("a body"), [2048, 2048]).expect("a frame");
        assert!(RasterJob::new(&part, frame).is_ok());
        part.bodies[0].as_mut().expect("a body").composing = Composing::Printed;
        assert_eq!(RasterJob::new(&part, frame).err(), Some(FrameError::Printed([2048, 2048])));
    }

    #[test]
    fn a_boundary_without_a_side_is_the_rest() {
        let region =
            Region::new(rectangle(10.0, 6.0), vec![Shape::Circle { center: dvec2(5.0, 3.0), radius: 1.0 }]);
        let region = region.expect("a region");
        let rest = Reference::boundary(&region, &[edge([0.0, 0.0], [10.0, 0.0])]).expect("sides");
        assert_eq!(
            (rest.shapes().len(), rest.distance(dvec2(2.0, 0.0)), rest.distance(dvec2(5.0, 2.5))),
            (2, 2.0, 0.5)
        );
        let holes = Reference::boundary(&region, &[rectangle(10.0, 6.0)]).expect("the hole");
        assert_eq!(holes.shapes().len(), 1);
        let all = [rectangle(10.0, 6.0), Shape::Circle { center: dvec2(5.0, 3.0), radius: 1.0 }];
        assert_eq!(Reference::boundary(&region, &all), None);
    }
}
