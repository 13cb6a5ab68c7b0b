//! Marking the continuity that is wanted across a face, and bringing it about.

use super::draft::{Draft, settle};
use super::material::{Fractions, pair};
use super::nearest::nearest;
use super::star::{Joint, Kind, Star, Weave, pairs};
use super::{Change, OperationError};
use crate::hyperpatch::composite::{Body, BodyError, CellId, Mark, Match, Side};
use crate::hyperpatch::{Axis, Corner, Face};
use glam::DVec3;

/// Marks what continuity is wanted across a face, at one of its corners or at all four, for shape and material apart,
/// and brings it about (section 3.5 of the paper, Figs. 7 and 8). What is `None` stays as it is; in the rest
/// [`Match::None`] lets the two sides go, so that each is edited freely, [`Match::Block`] wants the coefficients of the
/// face equal, and [`Match::C1`] wants the derivatives across equal as well (Eq. 7).
///
/// Sides that are apart are moved towards each other with their blocks, each half of the way. Then the coefficients of
/// the face stay and those behind them go to the nearest places at which every line at the corner runs on that did so
/// or is wanted to: where two cells meet alone the tangents on both sides become their mean. Compositions on both sides
/// become the nearest that do so and stay in the simplex ([`pair`]); where more than two cells run on at the corner,
/// they are drawn towards the composition of the corner as far as needed.
///
/// # Errors
/// When there is no such cell, the corner is not on the face, no cell lies on the other side of it, or C1 is wanted at
/// a corner whose cells do not lie in a grid. Nothing is changed then.
pub fn set_continuity(
    body: &mut Body,
    cell: CellId,
    face: Face,
    corner: Option<Corner>,
    shape: Option<Match>,
    material: Option<Match>,
) -> Result<Change, OperationError> {
    if body.cell(cell).is_none() {
        return Err(BodyError::Unknown { id: cell }.into());
    }
    let is_on = |corner: &Corner| corner.0[face.axis as usize] == face.is_end;
    if let Some(corner) = corner.filter(|corner| !is_on(corner)) {
        return Err(OperationError::OffFace { corner, face });
    }
    let corners: Vec<Corner> = match corner {
        Some(corner) => vec![corner],
        None => Corner::all().into_iter().filter(is_on).collect(),
    };
    let wanted = [shape, material];
    let mut sides = Vec::with_capacity(corners.len());
    for corner in corners {
        let side = Side { cell, corner, axis: face.axis };
        let mark = partner(body, side)?;
        let (star, joint) = star_of(body, side, &mark)?;
        for kind in [Kind::Shape, Kind::Material] {
            if wanted[kind as usize] == Some(Match::C1) {
                let weave = weave_with(&star, joint, kind, Match::C1, body.tolerance());
                if !weave.is_regular[weave.frames[star.joints[joint].sides[0]].part] {
                    return Err(OperationError::Irregular { id: cell, corner });
                }
            }
        }
        sides.push((side, mark));
    }
    let before = body.clone();
    let mut touched = Vec::new();
    for (side, mark) in sides {
        touched.extend([side.cell, mark.other.cell]);
        let done = bring(body, side, mark, wanted);
        match done {
            Ok(list) => touched.extend(list),
            Err(error) => {
                *body = before;
                return Err(error);
            }
        }
    }
    touched.sort_unstable();
    touched.dedup();
    Ok(Change { touched, ..Change::default() })
}

/// The other side of a side: the one that a mark remembers, or that has the same block, or that lies on the same face
/// at another corner; with its mark, if there is one.
fn partner(body: &Body, side: Side) -> Result<Mark, OperationError> {
    if let Some(mark) = body.marks().get(side) {
        return Ok(*mark);
    }
    let face = side.face();
    let mut corners = Corner::all().to_vec();
    corners.retain(|corner| corner.0[side.axis as usize] == face.is_end);
    // The corner itself before the others.
    corners.sort_by_key(|corner| *corner != side.corner);
    for corner in corners {
        let here = Side { corner, ..side };
        let star = Star::new(body, &[(side.cell, corner)])?;
        let mark = match star.place(side.cell, corner).and_then(|place| star.mark_at(place, side.axis)) {
            Some(mark) => mark,
            None => match body.marks().get(here) {
                Some(mark) => *mark,
                None => continue,
            },
        };
        let mut other = mark.other;
        let mut axes = other.axis.others();
        if mark.is_swapped {
            axes.reverse();
        }
        for (axis, there) in side.axis.others().into_iter().zip(axes) {
            if corner.0[axis as usize] != side.corner.0[axis as usize] {
                other.corner.0[there as usize] = !other.corner.0[there as usize];
            }
        }
        return Ok(Mark { other, shape: None, material: None, ..mark });
    }
    Err(OperationError::Outer { id: side.cell, face })
}

/// The cells at both sides, and the place of their joint, which need not be one yet.
fn star_of<'a>(body: &'a Body, side: Side, mark: &Mark) -> Result<(Star<'a>, usize), OperationError> {
    let ends = [side, mark.other].map(|side| (side.cell, side.corner));
    let mut star = Star::new(body, &ends)?;
    let [Some(a), Some(b)] = ends.map(|(id, corner)| star.place(id, corner)) else {
        return Err(OperationError::Outer { id: side.cell, face: side.face() });
    };
    let axes = [side.axis, mark.other.axis];
    let known = star.joints.iter().position(|joint| {
        (joint.sides, joint.axes) == ([a, b], axes)
            || (joint.sides, joint.axes) == ([b, a], [axes[1], axes[0]])
    });
    let joint = known.unwrap_or_else(|| {
        let is_swapped = mark.is_swapped;
        star.joints.push(Joint {
            sides: [a, b],
            axes,
            is_swapped,
            holds: [Match::None; 2],
            is_marked: [false; 2],
        });
        star.joints.len() - 1
    });
    Ok((star, joint))
}

/// What is one and what must run on when a joint holds something else than it does.
fn weave_with(star: &Star<'_>, joint: usize, kind: Kind, holds: Match, tolerance: f64) -> Weave {
    let mut joints = star.joints.clone();
    joints[joint].holds[kind as usize] = holds;
    Star { cells: star.cells.clone(), joints }.weave(kind, tolerance)
}

/// Brings about what is wanted between two sides, and marks it.
fn bring(
    body: &mut Body,
    side: Side,
    mark: Mark,
    wanted: [Option<Match>; 2],
) -> Result<Vec<CellId>, OperationError> {
    let mut touched = Vec::new();
    let mut mark = body.marks().get(side).copied().unwrap_or(mark);
    // Shapes first: materials run on where shapes lie on each other.
    if let Some(shape) = wanted[0] {
        if shape != Match::None {
            touched.extend(join_shapes(body, side, &mark)?);
        }
        if shape == Match::C1 {
            touched.extend(smooth_shapes(body, side, &mark)?);
        }
        mark.shape = Some(shape);
        body.mark(side, mark);
    }
    if let Some(material) = wanted[1] {
        if material != Match::None {
            touched.extend(join_materials(body, side, &mark, material)?);
        }
        mark.material = Some(material);
        body.mark(side, mark);
    }
    settle(body, &[side.cell]);
    Ok(touched)
}

/// Moves two sides to each other, each half of the way, with their blocks.
fn join_shapes(body: &mut Body, side: Side, mark: &Mark) -> Result<Vec<CellId>, OperationError> {
    let (star, joint) = star_of(body, side, mark)?;
    let weave = star.weave(Kind::Shape, body.tolerance());
    let joint = star.joints[joint];
    let mut values = positions(&star, &weave);
    let [a, b] = joint.sides;
    let half = (star.position(b * 8) - star.position(a * 8)) / 2.0;
    let (with_a, with_b) = (weave.together(a), weave.together(b));
    if !with_a.contains(&b) {
        for (places, by) in [(with_a, half), (with_b, -half)] {
            let mut classes: Vec<usize> =
                places.into_iter().flat_map(|place| weave.class[place * 8..place * 8 + 8].to_vec()).collect();
            classes.sort_unstable();
            classes.dedup();
            classes.into_iter().for_each(|class| values[class] += by);
        }
    }
    let mut conditions = weave.conditions();
    for [a, b] in pairs(&joint) {
        if weave.class[a] != weave.class[b] {
            conditions.push(vec![(weave.class[a], 1.0), (weave.class[b], -1.0)]);
        }
    }
    if conditions.len() == weave.lines.len() {
        return Ok(Vec::new());
    }
    let free = vec![false; values.len()];
    nearest(&mut values, &conditions, &free);
    // What has become one gets the same bits.
    for [a, b] in pairs(&joint) {
        values[weave.class[b]] = values[weave.class[a]];
    }
    let draft = placed(body, &star, &weave, &values)?;
    Ok(draft.commit(body)?.touched)
}

/// Moves what is behind the face of two joined sides to the nearest places at which all lines run on.
fn smooth_shapes(body: &mut Body, side: Side, mark: &Mark) -> Result<Vec<CellId>, OperationError> {
    let (star, joint) = star_of(body, side, mark)?;
    let weave = weave_with(&star, joint, Kind::Shape, Match::C1, body.tolerance());
    let mut values = positions(&star, &weave);
    let mut is_fixed = vec![false; values.len()];
    for [a, b] in pairs(&star.joints[joint]) {
        is_fixed[weave.class[a]] = true;
        is_fixed[weave.class[b]] = true;
    }
    nearest(&mut values, &weave.conditions(), &is_fixed);
    let draft = placed(body, &star, &weave, &values)?;
    Ok(draft.commit(body)?.touched)
}

/// Makes the compositions on two sides equal, and run on if that is wanted.
fn join_materials(
    body: &mut Body,
    side: Side,
    mark: &Mark,
    wanted: Match,
) -> Result<Vec<CellId>, OperationError> {
    let (star, at) = star_of(body, side, mark)?;
    let joint = star.joints[at];
    let apart = star.weave(Kind::Material, body.tolerance());
    let weave = weave_with(&star, at, Kind::Material, wanted, body.tolerance());
    let mut values = Fractions::new(&star, &weave);
    // Where the sides differ, the mean of both; the classes that are one now were two or one.
    for [a, b] in pairs(&joint) {
        if apart.class[a] != apart.class[b] {
            values.set_mean(&star, weave.class[a], [a, b]);
        }
    }
    let own: Vec<[usize; 3]> = if wanted == Match::C1 {
        let inner = joint.axes.map(|axis: Axis| 4 >> axis as usize);
        let line = |[a, b]: [usize; 2]| [a | inner[0], a, b | inner[1]].map(|number| weave.class[number]);
        pairs(&joint).map(line).to_vec()
    } else {
        Vec::new()
    };
    let seeds = pairs(&joint).map(|[a, _]| weave.class[a]);
    let linked = linked(&weave, &seeds);
    let count = weave.lines.iter().filter(|line| linked[line.classes[1]]).count();
    if count == own.len() {
        for [before, middle, after] in own {
            let [a, t] = [values.get(middle), values.half_difference(before, after)];
            let step = pair(&a, &t);
            values.set(before, a.iter().zip(&step).map(|(a, t)| a - t).collect());
            values.set(after, a.iter().zip(&step).map(|(a, t)| a + t).collect());
        }
    } else {
        let mut is_fixed = vec![false; weave.members.len()];
        seeds.iter().for_each(|class| is_fixed[*class] = true);
        values.fit(&weave.conditions(), &is_fixed);
        values.draw_in(weave.class[joint.sides[0] * 8], &linked);
    }
    let mut draft = Draft::default();
    values.write(body, &star, &weave, &mut draft)?;
    Ok(draft.commit(body)?.touched)
}

/// The classes that lines connect with some.
fn linked(weave: &Weave, seeds: &[usize]) -> Vec<bool> {
    let mut is_linked = vec![false; weave.members.len()];
    seeds.iter().for_each(|class| is_linked[*class] = true);
    let mut has_changed = true;
    while has_changed {
        has_changed = false;
        for line in &weave.lines {
            let count = line.classes.iter().filter(|class| is_linked[**class]).count();
            if count == 1 || count == 2 {
                line.classes.iter().for_each(|class| is_linked[*class] = true);
                has_changed = true;
            }
        }
    }
    is_linked
}

/// Positions of all classes.
fn positions(star: &Star<'_>, weave: &Weave) -> Vec<DVec3> {
    weave.members.iter().map(|list| star.position(list[0])).collect()
}

/// The edit that puts classes where they belong.
fn placed(body: &Body, star: &Star<'_>, weave: &Weave, values: &[DVec3]) -> Result<Draft, OperationError> {
    let mut draft = Draft::default();
    for (members, value) in weave.members.iter().zip(values) {
        for &member in members {
            if star.position(member) != *value {
                let (id, at) = star.coefficient(member);
                draft.place(body, id, at, *value)?;
            }
        }
    }
    Ok(draft)
}

#[cfg(test)]
mod tests {
    use super::super::test_bodies::{
        block, body_of, check_body, fan, random_mix, random_vector, ring, shuffled, smooth_corners,
    };
    use super::super::{Reach, mix_cells, mix_coefficient, move_coefficient, moves, neighbourhood};
    use super::*;
    use crate::hyperpatch::composite::Sharing;
    use crate::hyperpatch::test_cells::random;
    use crate::hyperpatch::{Axis, Net, flat};

    const U1: Face = Face { axis: Axis::U, is_end: true };
    const AT: Corner = Corner([true, false, true]);
    const C1: Option<Match> = Some(Match::C1);
    const NONE: Option<Match> = Some(Match::None);

    /// Two cells that bend across their face.
    fn bent() -> Body {
        body_of([
            Net::cuboid(DVec3::ZERO, DVec3::ONE),
            Net::cuboid(DVec3::X, DVec3::new(3.0, 1.0, 1.0)).map(|p| p + DVec3::Z * (p.x - 1.0) * 0.3),
        ])
    }

    /// Where two cells meet alone the tangents become their mean, as Eq. 8 has it from either side, and the face stays.
    #[test]
    fn tangents_of_two_cells_become_their_mean() {
        let mut body = bent();
        let before = body.clone();
        let change = set_continuity(&mut body, CellId(0), U1, Some(AT), C1, None).unwrap();
        assert_eq!(change.touched, [0, 1].map(CellId));
        assert_eq!(smooth_corners(&body), 1);
        let point = |body: &Body, id: u32, i: usize| body.cell(CellId(id)).unwrap().net().0[flat(i, 0, 3)];
        let mean = (point(&before, 1, 1) - point(&before, 0, 2)) / 2.0;
        assert_eq!(point(&body, 0, 3), point(&before, 0, 3));
        assert!((point(&body, 1, 1) - point(&body, 0, 3) - mean).length() < 1e-15);
        assert!((point(&body, 0, 3) - point(&body, 0, 2) - mean).length() < 1e-15);
        set_continuity(&mut body, CellId(1), Face { axis: Axis::U, is_end: false }, None, C1, C1).unwrap();
        assert_eq!((smooth_corners(&body), body.marks().iter().count()), (4, 4));
        check_body(&body);
    }

    /// Marked corners stay smooth however they are moved, those that are let go move freely and come back together.
    #[test]
    fn sides_are_let_go_and_brought_together_again() {
        let mut body = shuffled(&block([2, 1, 1]), 4);
        let state = neighbourhood(&body, CellId(0), corner_at(&body, 0, DVec3::new(1.0, 1.0, 0.0))).unwrap();
        let side = state.joints[0].sides[0];
        let set = |body: &mut Body, shape: Option<Match>| {
            set_continuity(body, side.cell, side.face(), Some(side.corner), shape, None).unwrap()
        };
        set(&mut body, NONE);
        let at = side.corner.coefficient();
        assert_eq!(moves(&body, side.cell, at, Reach::Block).unwrap().len(), 8);
        let start = body.clone();
        move_coefficient(&mut body, side.cell, at, DVec3::new(0.1, 0.2, -0.4), Reach::Block).unwrap();
        assert!(Sharing::new(&body).shared_faces().is_empty());
        assert_eq!(Sharing::new(&body).contacts(&body)[0].corners.len(), 3);
        set(&mut body, C1);
        assert_eq!((Sharing::new(&body).shared_faces().len(), smooth_corners(&body)), (1, 4));
        let corner = body.cell(side.cell).unwrap().net().0[at];
        let half = start.cell(side.cell).unwrap().net().0[at] + DVec3::new(0.05, 0.1, -0.2);
        assert!(corner.distance(half) < 1e-15, "each side came half of the way");
        assert_eq!(moves(&body, side.cell, at, Reach::Block).unwrap().len(), 16);
        // Without a memory the corner is found by the others of the face.
        let mut body = shuffled(&block([2, 1, 1]), 4);
        for at in side.corner.block() {
            let by = DVec3::new(0.0, 0.3, 0.1);
            let id = side.cell;
            set_continuity(&mut body, id, side.face(), Some(side.corner), NONE, None).unwrap();
            move_coefficient(&mut body, id, at, by, Reach::Single).unwrap();
        }
        let mut forgetful = Body::new(3);
        body.cells().iter().for_each(|(_, cell)| forgetful.add(cell.clone()).map(|_| ()).unwrap());
        assert!(Sharing::new(&forgetful).shared_faces().is_empty());
        set(&mut forgetful, C1);
        assert_eq!(smooth_corners(&forgetful), 4);
    }

    fn corner_at(body: &Body, id: u32, point: DVec3) -> Corner {
        let corners = body.cell(CellId(id)).unwrap().net().corners();
        Corner::all()[corners.iter().position(|p| p.distance(point) < 1e-9).unwrap()]
    }

    /// Eight cells with every coefficient disturbed, one side after the other: in the end all twelve are smooth at once,
    /// and stay so.
    #[test]
    fn all_sides_of_a_corner_become_smooth_one_after_the_other() {
        for seed in 0..3 {
            let mut body = shuffled(&block([2, 2, 2]), seed);
            for n in 0..40 {
                let id = CellId((random(seed * 91 + n) * 8.0) as u32);
                let at = (random(seed * 57 + n) * 64.0) as usize;
                move_coefficient(&mut body, id, at, random_vector(n) * 0.05, Reach::Single).unwrap();
                mix_coefficient(&mut body, id, at, &random_mix(n)).unwrap();
            }
            let corner = corner_at(&body, 0, {
                // The common corner of all, wherever it went.
                let shared = Sharing::new(&body);
                let is_common = |c: &&Corner| {
                    shared.at_corner(shared.points(CellId(0)).unwrap()[c.coefficient()]).len() == 8
                };
                let all = Corner::all();
                body.cell(CellId(0)).unwrap().net().0[all.iter().find(is_common).unwrap().coefficient()]
            });
            let joints = neighbourhood(&body, CellId(0), corner).unwrap().joints;
            assert_eq!(joints.len(), 12);
            assert!(joints.iter().any(|joint| joint.shape < Match::C1 && joint.material < Match::C1));
            for joint in &joints {
                let side = joint.sides[0];
                set_continuity(&mut body, side.cell, side.face(), Some(side.corner), C1, C1).unwrap();
                check_body(&body);
            }
            for _ in 0..2 {
                let joints = neighbourhood(&body, CellId(0), corner).unwrap().joints;
                assert!(joints.iter().all(|joint| joint.shape == Match::C1 && joint.is_shape_marked));
                assert!(joints.iter().all(|joint| joint.material == Match::C1 && joint.is_material_marked));
                for (n, at) in corner.block().into_iter().enumerate() {
                    let by = random_vector(seed + n as u64) * 0.1;
                    move_coefficient(&mut body, CellId(0), at, by, Reach::Block).unwrap();
                    check_body(&body);
                }
            }
        }
    }

    #[test]
    fn compositions_of_two_cells_become_the_nearest_pair() {
        let mut body = block([2, 1, 1]);
        let mixes = [[0.5, 0.5, 0.0], [0.2, 0.8, 0.0], [0.0, 0.6, 0.4]].map(|m| m.to_vec());
        let [inner, face, other] = mixes.map(|mix| crate::material::Composition::new(mix).unwrap());
        mix_cells(&mut body, &[CellId(0), CellId(1)], &face).unwrap();
        mix_coefficient(&mut body, CellId(0), flat(2, 0, 3), &inner).unwrap();
        mix_coefficient(&mut body, CellId(1), flat(1, 0, 3), &other).unwrap();
        set_continuity(&mut body, CellId(0), U1, Some(AT), None, C1).unwrap();
        check_body(&body);
        let found =
            |id: u32, i: usize| body.cell(CellId(id)).unwrap().mix(flat(i, 0, 3)).fractions().to_vec();
        let step = pair(&[0.2, 0.8, 0.0], &[-0.25, 0.05, 0.2]);
        let is_near = |a: &[f64], b: &[f64], sign: f64| {
            let sides = a.iter().zip(face.fractions()).zip(b);
            sides.into_iter().all(|((a, middle), step)| (a - middle - sign * step).abs() < 1e-15)
        };
        assert!(is_near(&found(1, 1), &step, 1.0) && is_near(&found(0, 2), &step, -1.0));
        // A jump becomes its mean on both sides.
        let mut body = block([2, 1, 1]);
        set_continuity(&mut body, CellId(0), U1, Some(AT), None, Some(Match::Block)).unwrap();
        let at = |id: u32, i: usize| body.cell(CellId(id)).unwrap().mix(flat(i, 0, 3)).fractions().to_vec();
        assert_eq!((at(0, 3), at(1, 0)), (vec![0.5, 0.5, 0.0], vec![0.5, 0.5, 0.0]));
        assert_eq!((at(0, 2), at(1, 1)), (vec![1.0, 0.0, 0.0], vec![0.0, 1.0, 0.0]));
        check_body(&body);
    }

    /// What is edited against a mark takes the mark away; what was let go stays so although it coincides.
    #[test]
    fn marks_that_do_not_hold_are_dropped() {
        let mut body = ring(8);
        let face = U1;
        set_continuity(&mut body, CellId(0), face, Some(AT), C1, C1).unwrap();
        let mark =
            |body: &Body| body.marks().get(Side { cell: CellId(0), corner: AT, axis: Axis::U }).copied();
        assert_eq!(mark(&body).map(|mark| (mark.shape, mark.material)), Some((C1, C1)));
        move_coefficient(&mut body, CellId(0), flat(2, 0, 3), DVec3::Z * 0.1, Reach::Block).unwrap();
        assert_eq!(mark(&body).map(|mark| (mark.shape, mark.material)), Some((C1, C1)));
        move_coefficient(&mut body, CellId(0), flat(2, 0, 3), DVec3::Z * 0.1, Reach::Single).unwrap();
        assert_eq!(mark(&body).map(|mark| (mark.shape, mark.material)), Some((None, C1)));
        mix_cells(&mut body, &[CellId(0)], &random_mix(3)).unwrap();
        assert_eq!(mark(&body), None);
        set_continuity(&mut body, CellId(0), face, Some(AT), NONE, None).unwrap();
        mix_cells(&mut body, &[CellId(1)], &random_mix(3)).unwrap();
        assert_eq!(mark(&body).map(|mark| mark.shape), Some(NONE));
    }

    #[test]
    fn what_does_not_apply_is_refused_and_changes_nothing() {
        let mut body = fan(5);
        let before = body.clone();
        let face = Face { axis: Axis::U, is_end: false };
        let crease = set_continuity(&mut body, CellId(0), face, None, C1, None).unwrap_err();
        assert!(matches!(crease, OperationError::Irregular { .. }), "{crease}");
        let outer = set_continuity(&mut body, CellId(0), U1, None, C1, None).unwrap_err();
        assert_eq!(outer, OperationError::Outer { id: CellId(0), face: U1 });
        let wrong = set_continuity(&mut body, CellId(0), face, Some(AT), C1, None).unwrap_err();
        assert_eq!(wrong.to_string(), "corner [1, 0, 1] is not on face u0");
        assert!(set_continuity(&mut body, CellId(9), face, None, C1, None).is_err());
        assert_eq!(body, before);
        assert!(set_continuity(&mut body, CellId(0), face, None, Some(Match::Block), NONE).is_ok());
    }
}
