//! The cells round a corner: how they are joined, which of their coefficients are one, and which must run on.

use super::OperationError;
use crate::hyperpatch::composite::{Body, BodyError, CellId, Mark, Match, Side};
use crate::hyperpatch::{Axis, Cell, Corner};
use glam::DVec3;

/// Difference of fractions that counts as none.
const FRACTION: f64 = 1e-9;

/// Most corners of cells at one point: all pairs of them are looked at, which takes some ten milliseconds for so many.
pub(super) const MOST_AROUND: usize = 256;

/// Shape or material: continuity is told of each apart (section 3.5 of the paper).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Shape,
    Material,
}

/// Two cells with the same block of 2 x 2 control points on a face.
#[derive(Debug, Clone, Copy)]
pub(super) struct Joint {
    /// The two places in the list of the star.
    pub(super) sides: [usize; 2],
    /// The axes that the face lies across in each.
    pub(super) axes: [Axis; 2],
    /// Whether the first axis of the one face lies along the second of the other.
    pub(super) is_swapped: bool,
    /// What holds for shape and material: what is marked, or else what the coefficients are.
    pub(super) holds: [Match; 2],
    /// Whether that is marked.
    pub(super) is_marked: [bool; 2],
}

/// How the three axes of a cell lie in the grid round a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Frame {
    /// The part of the star that hangs together over faces.
    pub(super) part: usize,
    /// The axis of the grid along which each axis of the cell lies.
    axes: [usize; 3],
    /// On which side of the corner the cell lies along each axis of the grid.
    pub(super) signs: [i8; 3],
}

/// A coefficient of a face and its two neighbours across it, which must lie in a line with it in the middle (Eq. 7).
#[derive(Debug, Clone, Copy)]
pub(super) struct Line {
    /// Classes: before, in the middle, after.
    pub(super) classes: [usize; 3],
    /// The axis of the grid along which it runs.
    pub(super) axis: usize,
    /// The part of the star.
    pub(super) part: usize,
}

/// The cells round a corner.
pub(super) struct Star<'a> {
    /// The cells, each with the corner that lies here.
    pub(super) cells: Vec<(CellId, Corner, &'a Cell)>,
    pub(super) joints: Vec<Joint>,
}

/// What is one and what must run on in a star, for shape or for material. Coefficient n of the block of place e has the
/// number 8 e + n.
pub(super) struct Weave {
    /// Class of each coefficient: coefficients of a class are one.
    pub(super) class: Vec<usize>,
    /// Numbers of the coefficients of each class.
    pub(super) members: Vec<Vec<usize>>,
    /// Frames of the cells.
    pub(super) frames: Vec<Frame>,
    /// Whether the cells of each part of the star lie in a grid.
    pub(super) is_regular: Vec<bool>,
    /// What must run on, in regular parts.
    pub(super) lines: Vec<Line>,
    /// Whether sides were let go here, so that only faces hold cells together.
    is_loose: bool,
}

impl<'a> Star<'a> {
    /// The cells at the points of some corners. The boxes of all cells are looked at, nothing else of most of them.
    pub(super) fn new(body: &'a Body, seeds: &[(CellId, Corner)]) -> Result<Self, OperationError> {
        let tolerance = body.tolerance();
        let mut points = Vec::with_capacity(seeds.len());
        for &(id, corner) in seeds {
            let cell = body.cell(id).ok_or(BodyError::Unknown { id })?;
            points.push(cell.net().0[corner.coefficient()]);
        }
        let mut cells = Vec::new();
        for (index, (lo, hi)) in body.boxes().iter().enumerate() {
            let is_near = |p: &DVec3| (*lo - tolerance).cmple(*p).all() && p.cmple(*hi + tolerance).all();
            if !points.iter().any(is_near) {
                continue;
            }
            let (id, cell) = &body.cells()[index];
            let is_here = |corner: &Corner| {
                let at = cell.net().0[corner.coefficient()];
                points.iter().any(|point| point.distance(at) <= tolerance)
            };
            cells.extend(Corner::all().into_iter().filter(is_here).map(|corner| (*id, corner, cell)));
            if let (true, Some(&(id, corner))) = (cells.len() > MOST_AROUND, seeds.first()) {
                return Err(OperationError::Crowded { id, corner });
            }
        }
        let mut star = Self { cells, joints: Vec::new() };
        for first in 0..star.cells.len() {
            for second in first + 1..star.cells.len() {
                star.join(body, [first, second], tolerance);
            }
        }
        Ok(star)
    }

    /// The place of a cell's corner in the list.
    pub(super) fn place(&self, id: CellId, corner: Corner) -> Option<usize> {
        self.cells.iter().position(|(other, at, _)| (*other, *at) == (id, corner))
    }

    /// A side of a cell here.
    pub(super) fn side(&self, place: usize, axis: Axis) -> Side {
        let (cell, corner, _) = self.cells[place];
        Side { cell, corner, axis }
    }

    /// What a side has on its other side, as a mark that says nothing.
    pub(super) fn mark_at(&self, place: usize, axis: Axis) -> Option<Mark> {
        let end =
            |joint: &Joint| [0, 1].into_iter().find(|n| (joint.sides[*n], joint.axes[*n]) == (place, axis));
        let (joint, n) = self.joints.iter().find_map(|joint| Some((joint, end(joint)?)))?;
        let other = self.side(joint.sides[1 - n], joint.axes[1 - n]);
        Some(Mark { other, is_swapped: joint.is_swapped, shape: None, material: None })
    }

    /// Position of a coefficient.
    pub(super) fn position(&self, number: usize) -> DVec3 {
        let (_, corner, cell) = self.cells[number / 8];
        cell.net().0[corner.block()[number % 8]]
    }

    /// Fraction of a material at a coefficient.
    pub(super) fn fraction(&self, number: usize, material: usize) -> f64 {
        let (_, corner, cell) = self.cells[number / 8];
        cell.fractions()[material][corner.block()[number % 8]]
    }

    /// Place of a coefficient in the list of 64 of its cell.
    pub(super) fn coefficient(&self, number: usize) -> (CellId, usize) {
        let (id, corner, _) = self.cells[number / 8];
        (id, corner.block()[number % 8])
    }

    /// Finds the face that two cells have in common at the corner.
    fn join(&mut self, body: &Body, sides: [usize; 2], tolerance: f64) {
        for a in Axis::ALL {
            for b in Axis::ALL {
                let (first, second) = (self.side(sides[0], a), self.side(sides[1], b));
                let [p, q] = sides.map(|side| &self.cells[side].2.net().0);
                let is_one = |a: usize, b: usize| p[a].distance(q[b]) <= tolerance;
                let ([_, s, t, across], [_, u, v, far]) = (first.block(), second.block());
                if !is_one(across, far) {
                    continue;
                }
                let is_straight = is_one(s, u) && is_one(t, v);
                if is_straight || is_one(s, v) && is_one(t, u) {
                    let joint = self.judge(body, sides, [a, b], !is_straight, tolerance);
                    self.joints.push(joint);
                    return;
                }
            }
        }
    }

    /// What holds across a joint.
    fn judge(
        &self,
        body: &Body,
        sides: [usize; 2],
        axes: [Axis; 2],
        is_swapped: bool,
        tolerance: f64,
    ) -> Joint {
        let (side, other) = (self.side(sides[0], axes[0]), self.side(sides[1], axes[1]));
        let known = body.marks().get(side).filter(|mark| mark.other == other);
        let mark = known.copied().unwrap_or(Mark { other, is_swapped, shape: None, material: None });
        let (mut shape, mut material) = (Match::C1, Match::C1);
        let [first, second] = sides.map(|side| self.cells[side].2);
        for (a, b) in side.block().into_iter().zip(mark.other_block()) {
            let (c, d) = (side.inside(a), other.inside(b));
            let (p, q) = (&first.net().0, &second.net().0);
            if ((p[a] - p[c]) - (q[d] - q[b])).length() > tolerance {
                shape = Match::Block;
            }
            for (p, q) in first.fractions().iter().zip(second.fractions()) {
                if (p[a] - q[b]).abs() > FRACTION {
                    material = Match::None;
                } else if ((p[a] - p[c]) - (q[d] - q[b])).abs() > FRACTION {
                    material = material.min(Match::Block);
                }
            }
        }
        Joint {
            sides,
            axes,
            is_swapped: mark.is_swapped,
            holds: [mark.shape.unwrap_or(shape), mark.material.unwrap_or(material)],
            is_marked: [mark.shape.is_some(), mark.material.is_some()],
        }
    }

    /// What is one and what must run on.
    pub(super) fn weave(&self, kind: Kind, tolerance: f64) -> Weave {
        self.weave_from(kind, tolerance, 0)
    }

    /// The same, with the grid of one of its cells laid out along the axes of that cell.
    pub(super) fn weave_from(&self, kind: Kind, tolerance: f64, first: usize) -> Weave {
        let is_loose = self.joints.iter().any(|joint| joint.holds[Kind::Shape as usize] == Match::None);
        // Material runs through faces that coincide, whether or not their shapes were let go.
        let holds = |joint: &Joint| kind == Kind::Material || joint.holds[0] != Match::None;
        let (frames, is_regular) = self.frames(&holds, first);
        // Each coefficient leads to an earlier one of its class, the first of them to itself.
        let mut class: Vec<usize> = (0..self.cells.len() * 8).collect();
        let mut unite = |a: usize, b: usize| {
            let (a, b) = (first_of(&mut class, a), first_of(&mut class, b));
            class[a.max(b)] = a.min(b);
        };
        for joint in self.joints.iter().filter(|joint| joint.holds[kind as usize] != Match::None) {
            for [a, b] in pairs(joint) {
                unite(a, b);
            }
        }
        if kind == Kind::Shape && !is_loose {
            for first in 0..self.cells.len() {
                for second in first + 1..self.cells.len() {
                    let edges = (0..9).map(|n| (first * 8 + (1 << (n / 3)), second * 8 + (1 << (n % 3))));
                    for (a, b) in std::iter::once((first * 8, second * 8)).chain(edges) {
                        if self.position(a).distance(self.position(b)) <= tolerance {
                            unite(a, b);
                        }
                    }
                }
            }
        }
        let mut members: Vec<Vec<usize>> = Vec::new();
        let mut numbers = vec![usize::MAX; class.len()];
        for number in 0..class.len() {
            let first = first_of(&mut class, number);
            if numbers[first] == usize::MAX {
                numbers[first] = members.len();
                members.push(Vec::new());
            }
            members[numbers[first]].push(number);
        }
        for (class, list) in members.iter().enumerate() {
            list.iter().for_each(|number| numbers[*number] = class);
        }
        let class = numbers;
        let mut lines = Vec::new();
        for joint in
            self.joints.iter().filter(|joint| joint.holds[kind as usize] == Match::C1 && holds(joint))
        {
            let frame = frames[joint.sides[0]];
            if !is_regular[frame.part] {
                continue;
            }
            let inner = joint.axes.map(|axis| 4 >> axis as usize);
            for [a, b] in pairs(joint) {
                let classes = [class[a | inner[0]], class[a], class[b | inner[1]]];
                lines.push(Line { classes, axis: frame.axes[joint.axes[0] as usize], part: frame.part });
            }
        }
        Weave { class, members, frames, is_regular, lines, is_loose }
    }

    /// Lays the cells out in a grid from face to face; where they do not fit, the part is irregular.
    fn frames(&self, holds: &dyn Fn(&Joint) -> bool, first: usize) -> (Vec<Frame>, Vec<bool>) {
        let mut frames: Vec<Option<Frame>> = vec![None; self.cells.len()];
        let mut is_regular: Vec<bool> = Vec::new();
        for start in std::iter::once(first).chain(0..self.cells.len()) {
            if frames[start].is_some() {
                continue;
            }
            let part = is_regular.len();
            is_regular.push(true);
            let signs = self.cells[start].1.0.map(|is_end| if is_end { -1 } else { 1 });
            frames[start] = Some(Frame { part, axes: [0, 1, 2], signs });
            let mut queue = vec![start];
            while let Some(place) = queue.pop() {
                let Some(frame) = frames[place] else { continue };
                for joint in self.joints.iter().filter(|joint| holds(joint)) {
                    let Some(n) = joint.sides.iter().position(|side| *side == place) else { continue };
                    let next = frame.across(joint, n);
                    match frames[joint.sides[1 - n]] {
                        None => {
                            frames[joint.sides[1 - n]] = Some(next);
                            queue.push(joint.sides[1 - n]);
                        }
                        Some(known) => is_regular[part] &= known == next,
                    }
                }
            }
            let octants: Vec<_> = frames.iter().flatten().filter(|f| f.part == part).collect();
            for (n, frame) in octants.iter().enumerate() {
                is_regular[part] &= octants[n + 1..].iter().all(|other| other.signs != frame.signs);
            }
        }
        let frame = |frame: Option<Frame>| frame.unwrap_or(Frame { part: 0, axes: [0, 1, 2], signs: [1; 3] });
        (frames.into_iter().map(frame).collect(), is_regular)
    }
}

impl Frame {
    /// The frame of the cell on the other side of a joint, whose side `n` has this one.
    fn across(&self, joint: &Joint, n: usize) -> Self {
        let (here, there) = (joint.axes[n], joint.axes[1 - n]);
        let mut next = *self;
        next.axes[there as usize] = self.axes[here as usize];
        let mut others = here.others();
        if joint.is_swapped {
            others.reverse();
        }
        for (axis, other) in others.into_iter().zip(there.others()) {
            next.axes[other as usize] = self.axes[axis as usize];
        }
        next.signs[self.axes[here as usize]] *= -1;
        next
    }

    /// Where a coefficient of the block lies in the grid: -1, 0 or 1 along each axis.
    pub(super) fn offset(&self, bits: usize) -> [i8; 3] {
        let mut offset = [0; 3];
        for axis in 0..3 {
            if bits & (4 >> axis) != 0 {
                offset[self.axes[axis]] = self.signs[self.axes[axis]];
            }
        }
        offset
    }

    /// The axis of the cell that lies along an axis of the grid.
    pub(super) fn local(&self, axis: usize) -> Option<usize> {
        self.axes.iter().position(|other| *other == axis)
    }
}

impl Weave {
    /// The places that move together with one: all at its point, or where sides were let go, those that faces hold
    /// together.
    pub(super) fn together(&self, place: usize) -> Vec<usize> {
        let is_with = |n: &usize| match self.is_loose {
            true => self.frames[*n].part == self.frames[place].part,
            false => self.class[*n * 8] == self.class[place * 8],
        };
        (0..self.frames.len()).filter(is_with).collect()
    }

    /// What moves when the class of a coefficient is moved, with its share: by the repaired rule all that must for the
    /// lines to stay lines, symmetrically.
    ///
    /// Eq. 8 of the paper moves the opposite coefficient alone. Where more than two cells meet that breaks the lines
    /// along the other axes. Here coefficient n moves by the product, over the axes along which the moved one o is
    /// displaced from the corner, of `n_axis * o_axis`, if lines lead to it.
    pub(super) fn follow(&self, number: usize) -> Vec<(usize, f64)> {
        let mut shares: Vec<Option<f64>> = vec![None; self.members.len()];
        let mut aside: Vec<Option<[bool; 3]>> = vec![None; self.is_regular.len()];
        shares[self.class[number]] = Some(1.0);
        let mut has_changed = true;
        while has_changed {
            has_changed = false;
            for line in &self.lines {
                let Some((n, share)) = (0..3).find_map(|n| Some((n, shares[line.classes[n]]?))) else {
                    continue;
                };
                let aside = *aside[line.part]
                    .get_or_insert_with(|| self.offset(line.classes[n], line.part).map(|place| place != 0));
                let moved = if aside[line.axis] {
                    // The one in the middle lies in the plane that stays.
                    if n == 1 {
                        continue;
                    }
                    let mut moved = [None; 3];
                    (moved[n], moved[2 - n]) = (Some(share), Some(-share));
                    moved
                } else {
                    [Some(share); 3]
                };
                for (class, share) in line.classes.into_iter().zip(moved) {
                    if share.is_some() && shares[class].is_none() {
                        shares[class] = share;
                        has_changed = true;
                    }
                }
            }
        }
        let share = |(class, share): (usize, Option<f64>)| share.map(|share| (class, share));
        shares.into_iter().enumerate().filter_map(share).collect()
    }

    /// Where a class lies in the grid of a part.
    fn offset(&self, class: usize, part: usize) -> [i8; 3] {
        let member = self.members[class].iter().find(|number| self.frames[*number / 8].part == part);
        member.map_or([0; 3], |number| self.frames[number / 8].offset(number % 8))
    }

    /// The lines as conditions on the classes.
    pub(super) fn conditions(&self) -> Vec<Vec<(usize, f64)>> {
        let condition = |line: &Line| line.classes.into_iter().zip([1.0, -2.0, 1.0]).collect();
        self.lines.iter().map(condition).collect()
    }
}

/// The first of a class, and a shorter way to it.
fn first_of(class: &mut [usize], mut number: usize) -> usize {
    while class[number] != number {
        class[number] = class[class[number]];
        number = class[number];
    }
    number
}

/// Numbers of the coefficients on either side of a joint that lie on each other.
pub(super) fn pairs(joint: &Joint) -> [[usize; 2]; 4] {
    let bits = joint.axes.map(|axis| axis.others().map(|axis| 4 >> axis as usize));
    let [mut c, mut d] = bits[1];
    if joint.is_swapped {
        (c, d) = (d, c);
    }
    let [a, b] = bits[0];
    let at = |n: usize, m: usize| [joint.sides[0] * 8 + n, joint.sides[1] * 8 + m];
    [at(0, 0), at(a, c), at(b, d), at(a | b, c | d)]
}
