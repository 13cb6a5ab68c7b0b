//! How two cells lie to each other: apart, sharing parts, or overlapping.

use super::shared::{Feature, features};
use super::sharing::WELD;
use super::tree::Tree;
use super::{Body, CellId, Sharing};
use crate::hyperpatch::inversion::newton;
use crate::hyperpatch::validity::{Piece, are_separated};
use crate::hyperpatch::{Differences, Face, Net};
use glam::DVec3;
use std::collections::{HashSet, VecDeque};
use std::rc::Rc;

/// Most pairs of pieces of two cells that are looked at; each takes some ten microseconds.
const MOST_LOOKS: usize = 4000;

/// Pairs of pieces between two looks at the clock.
const LOOKS_A_STEP: usize = 16;

/// How far inside a cell, in parameters, a point of another one must lie to witness that they overlap.
const DEPTH: f64 = 1e-3;

/// Size in parameters below which pieces are tried for a witness.
const SMALL: f64 = 0.26;

/// Size of pieces, over that of the cells, below which pieces that are not apart count as touching.
const TOUCHING: f64 = 1e-6;

/// Size in parameters from which on pieces of cells that share something may count as touching.
const FINE: f64 = 0.125;

/// Sine of the angle by which a plane between two pieces may cut into the cells behind them.
const LEVEL: f64 = 1e-6;

/// How two cells lie to each other. Cells that are not sound themselves may lie in any way.
#[derive(Debug, Clone, PartialEq)]
pub enum Relation {
    /// No point in common, by proof.
    Disjoint,
    /// Exactly the faces, edges and corners of these numbers in common, by proof. Edges of the faces, and corners of
    /// either, are not counted again.
    Shares {
        /// Number of faces.
        faces: usize,
        /// Number of edges.
        edges: usize,
        /// Number of corners.
        corners: usize,
    },
    /// A point is inside both.
    Overlaps {
        /// The point.
        point: DVec3,
        /// Its parameters in each cell.
        at: [DVec3; 2],
    },
    /// They come closer than can be told, besides what they share; so do faces that share two edges at a corner, and
    /// with them the tangent plane there, and part behind it.
    Touches {
        /// Parameters in the first cell of a place where they do.
        at: DVec3,
    },
    /// Nothing was proven within the budget.
    Unproven,
}

impl Relation {
    /// The relation as it is written in results.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Disjoint => "disjoint",
            Self::Shares { .. } => "shares",
            Self::Overlaps { .. } => "overlaps",
            Self::Touches { .. } => "touches",
            Self::Unproven => "not-proven",
        }
    }
}

/// The job that finds the relation of every two cells of a body whose boxes meet.
#[derive(Debug)]
pub struct Pairs {
    cells: Vec<(CellId, Net)>,
    /// Cells of which a pair has at least one; without them all.
    chosen: Option<HashSet<CellId>>,
    sharing: Rc<Sharing>,
    /// Number of cells whose shared parts are known.
    joined: usize,
    tree: Tree,
    /// Number of cells whose partners are known.
    begun: usize,
    /// Partners of the last of these that are still to be looked at.
    partners: Vec<usize>,
    work: Option<(usize, usize, Work)>,
    found: Vec<([CellId; 2], Relation)>,
}

impl Pairs {
    /// The job for a body as it is now.
    #[must_use]
    pub fn new(body: &Body) -> Self {
        Self::start(body, Rc::new(Sharing::start(body)), None, 0)
    }

    /// The job for the pairs with at least one of some cells, of a body of which it is known what its cells share.
    #[must_use]
    pub fn with(body: &Body, sharing: Rc<Sharing>, chosen: HashSet<CellId>) -> Self {
        Self::start(body, sharing, Some(chosen), body.cells().len())
    }

    fn start(body: &Body, sharing: Rc<Sharing>, chosen: Option<HashSet<CellId>>, joined: usize) -> Self {
        let slack = sharing.tolerance();
        let cells: Vec<_> = body.cells().iter().map(|(id, cell)| (*id, cell.net().clone())).collect();
        let boxes = cells.iter().map(|(_, net)| net.bounds()).map(|(lo, hi)| (lo - slack, hi + slack));
        let tree = Tree::new(boxes.collect());
        let (partners, found) = (Vec::new(), Vec::new());
        Self { cells, chosen, sharing, joined, tree, begun: 0, partners, work: None, found }
    }

    /// Share of the work that is done, from 0 to 1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        let count = 2 * self.cells.len();
        if self.is_done() { 1.0 } else { (self.joined + self.begun) as f64 / (count + 1) as f64 }
    }

    /// What has been found so far, by identifiers: every pair that is not disjoint.
    #[must_use]
    pub fn found(&self) -> &[([CellId; 2], Relation)] {
        &self.found
    }

    /// Advances while `may_go_on` says so, at least by a little; tells whether all pairs are done.
    pub fn step(&mut self, may_go_on: &mut dyn FnMut() -> bool) -> bool {
        loop {
            if let Some((id, net)) = self.cells.get(self.joined) {
                Rc::make_mut(&mut self.sharing).add(*id, net);
                self.joined += 1;
            } else {
                self.look();
            }
            if self.is_done() {
                return true;
            }
            if !may_go_on() {
                return false;
            }
        }
    }

    /// Runs the job to its end.
    #[must_use]
    pub fn run(mut self) -> Vec<([CellId; 2], Relation)> {
        while !self.step(&mut || true) {}
        self.found
    }

    fn is_done(&self) -> bool {
        let count = self.cells.len();
        self.joined == count && self.begun == count && self.partners.is_empty() && self.work.is_none()
    }

    /// Advances the pair at work, or takes up the next one.
    fn look(&mut self) {
        let Some((a, b, mut work)) = self.work.take().or_else(|| self.next()) else { return };
        match work.advance([&self.cells[a].1, &self.cells[b].1]) {
            Some(Relation::Disjoint) => {}
            Some(relation) => self.found.push(([self.cells[a].0, self.cells[b].0], relation)),
            None => self.work = Some((a, b, work)),
        }
    }

    /// The next pair, or `None` when the next cell has no partners of higher index.
    fn next(&mut self) -> Option<(usize, usize, Work)> {
        if self.partners.is_empty() && self.begun < self.cells.len() {
            let (lo, hi) = self.tree.bounds(self.begun);
            let met = self.tree.meeting(lo, hi);
            let is_chosen =
                |n: usize| self.chosen.as_ref().is_none_or(|chosen| chosen.contains(&self.cells[n].0));
            let is_wanted =
                |&other: &usize| other > self.begun && (is_chosen(self.begun) || is_chosen(other));
            self.partners = met.into_iter().rev().filter(is_wanted).collect();
            self.begun += 1;
        }
        let (a, b) = (self.begun.checked_sub(1)?, self.partners.pop()?);
        let numbers = [a, b].map(|n| self.sharing.points(self.cells[n].0));
        let features =
            if let [Some(first), Some(second)] = numbers { features(first, second) } else { Vec::new() };
        Some((a, b, Work::new([&self.cells[a].1, &self.cells[b].1], features)))
    }
}

/// The relation of two cells of a body, or `None` when one is missing or both are the same.
#[must_use]
pub fn relate(body: &Body, first: CellId, second: CellId) -> Option<Relation> {
    if first == second {
        return None;
    }
    let mut two = Body::new(body.materials());
    for id in [first, second] {
        two.add(body.cell(id)?.clone()).ok()?;
    }
    let found = Pairs::new(&two).run();
    Some(found.into_iter().next().map_or(Relation::Disjoint, |(_, relation)| relation))
}

/// Two cells on the way to their relation.
///
/// Their boundaries are halved into pieces. A pair of pieces is done with when a plane separates the two, when the
/// parts of the cells between them and what the cells share are proven to meet there alone, or when a plane touches
/// both.
#[derive(Debug)]
struct Work {
    features: Vec<Feature>,
    differences: [Differences; 2],
    /// Larger pairs come first, so that an overlap is found before the curve in which two surfaces meet is followed.
    pairs: VecDeque<[Piece; 2]>,
    looks: usize,
    /// Distance below which points are one.
    tolerance: f64,
    /// Size below which pieces are not halved any more.
    least: f64,
    /// Parameters in the first cell of a place where the two touch.
    touch: Option<DVec3>,
    has_begun: bool,
}

impl Work {
    fn new(nets: [&Net; 2], features: Vec<Feature>) -> Self {
        let pieces = nets.map(|net| Face::all().map(|face| Piece::new(net, face)));
        let pairs = pieces[0].iter().flat_map(|a| pieces[1].iter().map(move |b| [*a, *b])).collect();
        let size = nets.map(Net::bounds).map(|(lo, hi)| lo.distance(hi)).into_iter().fold(0.0, f64::max);
        let largest = nets.iter().flat_map(|net| net.0).map(|p| p.abs().max_element()).fold(0.0, f64::max);
        let tolerance = 4.0 * WELD * size + 1e-13 * largest;
        let differences = nets.map(Net::differences);
        Self {
            features,
            differences,
            pairs,
            looks: 0,
            tolerance,
            least: TOUCHING * size,
            touch: None,
            has_begun: false,
        }
    }

    /// Looks at the cells as wholes, and later at some pairs of pieces.
    fn advance(&mut self, sides: [&Net; 2]) -> Option<Relation> {
        if !self.has_begun {
            self.has_begun = true;
            return self.look_at_wholes(sides);
        }
        for _ in 0..LOOKS_A_STEP {
            let Some([a, b]) = self.pairs.pop_front() else {
                return Some(self.touch.map_or(self.apart(), |at| Relation::Touches { at }));
            };
            if self.looks == MOST_LOOKS {
                return Some(Relation::Unproven);
            }
            self.looks += 1;
            if let Some(overlap) = self.look(sides, a, b) {
                return Some(overlap);
            }
        }
        None
    }

    /// The relation when nothing else is in common.
    fn apart(&self) -> Relation {
        let count = |is: fn(&Feature) -> bool| self.features.iter().filter(|feature| is(feature)).count();
        if self.features.is_empty() {
            return Relation::Disjoint;
        }
        Relation::Shares {
            faces: count(|f| matches!(f, Feature::Face { .. })),
            edges: count(|f| matches!(f, Feature::Edge { .. })),
            corners: count(|f| matches!(f, Feature::Corner { .. })),
        }
    }

    fn look_at_wholes(&mut self, sides: [&Net; 2]) -> Option<Relation> {
        let [first, second] = sides;
        if self.features.is_empty() && are_separated(&first.0, &second.0) {
            return Some(Relation::Disjoint);
        }
        let whole = (DVec3::ZERO, DVec3::ONE);
        if let [feature] = &self.features[..]
            && feature.is_all(self.differences.each_ref(), [whole, whole])
        {
            return Some(self.apart());
        }
        // A point well inside one cell that is well inside the other: it finds what boundaries do not show, one cell
        // in another.
        for (n, (from, to)) in [(first, second), (second, first)].into_iter().enumerate() {
            let (lo, hi) = to.bounds();
            for place in 0..9 {
                let corner = [4, 2, 1].map(|bit| if place & bit == 0 { 0.25 } else { 0.75 });
                let at = if place == 8 { DVec3::splat(0.5) } else { DVec3::from_array(corner) };
                let point = from.point(at);
                if !(point.cmpge(lo).all() && point.cmple(hi).all()) {
                    continue;
                }
                if let Some(other) = to.invert(point).filter(|other| is_deep(*other)) {
                    let at = if n == 0 { [at, other] } else { [other, at] };
                    return Some(Relation::Overlaps { point, at });
                }
            }
        }
        None
    }

    /// Is done with a pair of pieces, or halves it, or finds a point inside both cells.
    fn look(&mut self, [first, second]: [&Net; 2], a: Piece, b: Piece) -> Option<Relation> {
        let differences = self.differences.each_ref();
        let ranges = [a.range(), b.range()];
        if are_separated(&a.points, &b.points)
            || self.features.iter().any(|feature| feature.is_all(differences, ranges))
        {
            return None;
        }
        if a.size().max(b.size()) < SMALL {
            for (n, (piece, from, other, to)) in
                [(a, first, b, second), (b, second, a, first)].into_iter().enumerate()
            {
                let (lo, hi) = to.bounds();
                for at in piece.places() {
                    let point = from.point(at);
                    if !(point.cmpge(lo).all() && point.cmple(hi).all()) {
                        continue;
                    }
                    if let Some(found) = newton(to, point, other.middle()).filter(|found| is_deep(*found)) {
                        return Some(Relation::Overlaps {
                            point,
                            at: if n == 0 { [at, found] } else { [found, at] },
                        });
                    }
                }
            }
        }
        // Beside what is shared, pieces get the chance to be proven to meet there alone.
        let is_ready = self.features.is_empty() || a.size().max(b.size()) <= FINE;
        let is_flush = || are_flush([(first, &a), (second, &b)], self.tolerance);
        if is_ready && is_flush() || a.extent().max(b.extent()) < self.least {
            self.touch.get_or_insert(a.middle());
        } else if a.extent() >= b.extent() {
            self.pairs.extend(a.halves().map(|half| [half, b]));
        } else {
            self.pairs.extend(b.halves().map(|half| [a, half]));
        }
        None
    }
}

/// Whether a plane within the tolerance separates two pieces of the surfaces of two cells, and has the insides of the
/// cells on its two sides. The planes of the pieces are tried, and those upright on their sides.
fn are_flush(sides: [(&Net, &Piece); 2], tolerance: f64) -> bool {
    let outward = sides.map(|(net, piece)| {
        let [c0, c3, c12, c15] = [0, 3, 12, 15].map(|n| piece.points[n]);
        let normal = (c12 + c15 - c0 - c3).cross(c3 + c15 - c0 - c12).normalize_or_zero();
        let is_outward = piece.face.is_outward() == (net.jacobian(DVec3::splat(0.5)) > 0.0);
        (if is_outward { normal } else { -normal }, [c3 - c0, c12 - c0, c15 - c12, c15 - c3])
    });
    let upright =
        outward.iter().flat_map(|(normal, edges)| edges.map(|edge| edge.cross(*normal).normalize_or_zero()));
    let planes = outward.iter().map(|(normal, _)| *normal).chain(upright);
    let is_between = |direction: DVec3| {
        let least =
            |piece: &Piece, d: DVec3| piece.points.iter().map(|p| p.dot(d)).fold(f64::INFINITY, f64::min);
        direction != DVec3::ZERO
            && outward[0].0.dot(direction) <= LEVEL
            && outward[1].0.dot(direction) >= -LEVEL
            && least(sides[0].1, direction) + least(sides[1].1, -direction) >= -tolerance
    };
    planes.flat_map(|plane| [plane, -plane]).any(is_between)
}

/// Whether parameters are well inside.
fn is_deep(at: DVec3) -> bool {
    at.min_element() >= DEPTH && at.max_element() <= 1.0 - DEPTH
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hyperpatch::test_cells::{random_net, random_place, ring_cell, twisted};
    use crate::hyperpatch::{Axis, Cell, Corner};
    use crate::material::Composition;

    fn body(nets: impl IntoIterator<Item = Net>) -> Body {
        let mut body = Body::new(1);
        for net in nets {
            body.add(Cell::uniform(net, &Composition::pure(0, 1)).unwrap()).unwrap();
        }
        body
    }

    fn two(first: Net, second: Net) -> Relation {
        relate(&body([first, second]), CellId(0), CellId(1)).unwrap()
    }

    fn cube(x: f64, y: f64, z: f64) -> Net {
        let min = DVec3::new(x, y, z);
        Net::cuboid(min, min + 1.0)
    }

    fn shares(faces: usize, edges: usize, corners: usize) -> Relation {
        Relation::Shares { faces, edges, corners }
    }

    #[test]
    fn cubes_lie_in_every_way() {
        let first = cube(0.0, 0.0, 0.0);
        assert_eq!(two(first.clone(), cube(1.0, 0.0, 0.0)), shares(1, 0, 0));
        assert_eq!(two(first.clone(), cube(1.0, 1.0, 0.0)), shares(0, 1, 0));
        assert_eq!(two(first.clone(), cube(1.0, 1.0, 1.0)), shares(0, 0, 1));
        assert_eq!(two(first.clone(), cube(1.001, 0.0, 0.0)), Relation::Disjoint);
        for turn in [0.0, 0.7] {
            let turn = glam::DMat3::from_axis_angle(DVec3::new(3.0, 1.0, -2.0).normalize(), turn);
            for (y, z) in [(0.5, 0.0), (0.3, 0.2), (0.0, -0.9)] {
                let relation = two(first.map(|p| turn * p), cube(1.0, y, z).map(|p| turn * p));
                assert!(matches!(relation, Relation::Touches { .. }), "shifted faces: {relation:?}");
            }
        }
        for other in
            [cube(0.5, 0.5, 0.5), cube(0.995, 0.2, 0.3), first.clone(), first.map(|p| p * 0.1 + 0.45)]
        {
            let Relation::Overlaps { point, at } = two(first.clone(), other.clone()) else {
                panic!("they overlap")
            };
            for (net, at) in [(&first, at[0]), (&other, at[1])] {
                assert!(net.point(at).distance(point) < 1e-9);
            }
        }
    }

    #[test]
    fn rings_share_their_faces_whichever_way_parameters_run() {
        for count in [3, 4, 8] {
            let nets = [0, 1].map(|n| ring_cell(count, n, 1.0, 2.0, 1.0));
            for axis in Axis::ALL {
                assert_eq!(two(nets[0].clone(), nets[1].reversed(axis)), shares(1, 0, 0), "ring of {count}");
            }
        }
        // Opposite quarters are apart, two halves share both ends.
        assert_eq!(two(ring_cell(4, 0, 1.0, 2.0, 1.0), ring_cell(4, 2, 1.0, 2.0, 1.0)), Relation::Disjoint);
        assert_eq!(two(ring_cell(2, 0, 1.0, 2.0, 1.0), ring_cell(2, 1, 1.0, 2.0, 1.0)), shares(2, 0, 0));
        let block = two(ring_cell(8, 0, 1.0, 2.0, 1.0), ring_cell(8, 1, 2.0, 3.0, 1.0));
        assert_eq!(block, shares(0, 1, 0));
    }

    /// How deep points of the boundary of one cell lie in another one, in parameters.
    fn deepest(a: &Net, b: &Net) -> f64 {
        let places = (0..101 * 101).map(|n| ((n / 101) as f64 / 100.0, (n % 101) as f64 / 100.0));
        let points = Face::all()
            .into_iter()
            .flat_map(|f| places.clone().map(move |(s, t)| a.point(f.parameters(s, t))));
        let depth = |at: DVec3| at.min_element().min(1.0 - at.max_element());
        points.filter_map(|point| b.invert(point)).map(depth).fold(0.0, f64::max)
    }

    /// Against points: none of either cell lies in the other when they are apart, and the witness of an overlap is in both.
    #[test]
    fn relations_agree_with_points() {
        let mut seen = [0, 0];
        for seed in 0..60 {
            let turn = glam::DMat3::from_axis_angle(random_place(seed).normalize(), seed as f64);
            let shift = (random_place(seed + 100) - 0.5) * 2.6;
            let first = random_net(seed, 0.08);
            let second = random_net(seed + 500, 0.08).map(|p| turn * (p - 0.5) + 0.5 + shift);
            match two(first.clone(), second.clone()) {
                Relation::Disjoint => {
                    seen[0] += 1;
                    for n in 0..7 * 7 * 7 {
                        let at = DVec3::new((n / 49) as f64, (n / 7 % 7) as f64, (n % 7) as f64) / 6.0;
                        assert_eq!(second.invert(first.point(at)), None, "seed {seed}");
                        assert_eq!(first.invert(second.point(at)), None, "seed {seed}");
                    }
                }
                Relation::Overlaps { point, at } => {
                    seen[1] += 1;
                    assert!(
                        first.point(at[0]).distance(point) < 1e-9
                            && second.point(at[1]).distance(point) < 1e-9
                    );
                    assert!(at.iter().all(|at| at.min_element() >= 0.0 && at.max_element() <= 1.0));
                }
                _ => {
                    let depth = deepest(&first, &second).max(deepest(&second, &first));
                    assert!(depth < 2.0 * DEPTH, "seed {seed}: {depth} deep");
                }
            }
        }
        assert!(seen.iter().all(|&count| count > 10), "{seen:?}");
    }

    /// A bulge of a face into its neighbour, and a gap under one.
    #[test]
    fn bulges_and_gaps_are_told_apart() {
        let (first, second) = (cube(0.0, 0.0, 0.0), cube(1.0, 0.0, 0.0));
        let bulged = |by: f64| {
            let mut net = second.clone();
            for at in [5, 6, 9, 10] {
                net.0[at].x += by;
            }
            net
        };
        assert!(matches!(two(first.clone(), bulged(-0.1)), Relation::Overlaps { .. }));
        // The four edges are shared, so at the corners the faces have one tangent plane: closer than can be told.
        assert!(matches!(two(first, bulged(0.1)), Relation::Touches { .. }));
    }

    /// Several cells round one edge, of any valence.
    #[test]
    fn wedges_round_an_edge_share_it() {
        for count in [3, 5, 6] {
            let wedge = |n: usize| {
                let direction =
                    |n: usize| glam::DVec2::from_angle(std::f64::consts::TAU * n as f64 / count as f64);
                let (a, b) = (direction(n), direction(n + 1));
                let corners = Corner::all().map(|corner| {
                    let [u, v, w] = corner.0.map(|is_end| f64::from(u8::from(is_end)));
                    (a * u + b * v).extend(w)
                });
                Net::trilinear(&corners)
            };
            let found = Pairs::new(&body((0..count).map(wedge))).run();
            assert_eq!(found.len(), count * (count - 1) / 2);
            for ([a, b], relation) in found {
                let is_next = b.0 - a.0 == 1 || (b.0 - a.0) as usize == count - 1;
                assert_eq!(
                    relation,
                    if is_next { shares(1, 0, 0) } else { shares(0, 1, 0) },
                    "{a} {b} of {count}"
                );
            }
        }
    }

    #[test]
    fn a_block_is_sound_and_the_job_stops_when_it_is_told_to() {
        let block = body((0..27).map(|n| cube((n / 9) as f64, (n / 3 % 3) as f64, (n % 3) as f64)));
        let mut job = Pairs::new(&block);
        let mut steps = 1;
        while !job.step(&mut || false) {
            steps += 1;
            assert!((0.0..=1.0).contains(&job.progress()));
        }
        assert!(steps > 100 && job.progress() == 1.0);
        let count = |relation: Relation| job.found().iter().filter(|(_, found)| *found == relation).count();
        assert_eq!([count(shares(1, 0, 0)), count(shares(0, 1, 0)), count(shares(0, 0, 1))], [54, 72, 32]);
        assert_eq!(job.found().len(), 54 + 72 + 32);
    }

    #[test]
    fn twisted_neighbours_share_their_face() {
        let lower = twisted(60.0);
        let upper = {
            let turn = glam::DMat3::from_rotation_z(60.0_f64.to_radians());
            twisted(60.0).map(|p| turn * p + DVec3::Z * 2.0)
        };
        assert_eq!(two(lower.clone(), upper.clone()), shares(1, 0, 0));
        assert!(matches!(two(lower, upper.map(|p| p - DVec3::Z * 0.1)), Relation::Overlaps { .. }));
        let one = body([cube(0.0, 0.0, 0.0)]);
        assert_eq!(relate(&one, CellId(0), CellId(0)), None);
        assert_eq!(relate(&one, CellId(0), CellId(7)), None);
        assert!(Pairs::new(&one).run().is_empty());
    }
}
