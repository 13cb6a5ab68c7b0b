//! Copies, mirror images and reversed cells.

use super::draft::{chosen, insert, settle};
use super::{Change, OperationError};
use crate::hyperpatch::composite::{Body, CellId, Side};
use crate::hyperpatch::{Axis, Cell, CellError};
use glam::DVec3;

/// Copies cells to another place, with what is marked between them. The copies get the identifiers from `first` on, in
/// the order of the originals.
///
/// # Errors
/// When no cell is named or one is unknown, the displacement is not finite or leads too far, an identifier is taken or
/// the body full.
pub fn copy(body: &mut Body, cells: &[CellId], by: DVec3, first: CellId) -> Result<Change, OperationError> {
    check_vector("the displacement", by)?;
    let originals = chosen(body, cells)?;
    let copies = mapped(body, &originals, |p| p + by)?;
    let made = insert(body, first, copies)?;
    let renamed = |side: Side| Some(Side { cell: made[originals.binary_search(&side.cell).ok()?], ..side });
    body.repeat_marks(renamed);
    settle(body, &made);
    Ok(Change { made, ..Change::default() })
}

/// Mirrors cells in the plane through the point at `offset` along `normal`, across it. With `keep` the originals stay
/// and the images are new cells with the identifiers from `first` on; without it the cells become their images.
///
/// An image is turned inside out, so its first index is reversed, which makes it sound again. Points on the plane stay
/// what they are, so that an original and its image share them. What is marked between two of the cells holds for their
/// images.
///
/// # Errors
/// When no cell is named or one is unknown, the normal has no length, numbers are not finite or lead too far, an
/// identifier is taken or the body full.
pub fn mirror(
    body: &mut Body,
    cells: &[CellId],
    normal: DVec3,
    offset: f64,
    keep: bool,
    first: CellId,
) -> Result<Change, OperationError> {
    check_vector("the normal", normal)?;
    if !offset.is_finite() {
        return Err(OperationError::Number {
            name: "the offset",
            value: offset,
            expected: "a finite number",
        });
    }
    // Scaled first: the square of a tiny or huge vector is not a number to divide by.
    let unit = (normal / normal.abs().max_element()).normalize_or_zero();
    if unit == DVec3::ZERO {
        let value = normal.length();
        return Err(OperationError::Number {
            name: "the length of the normal",
            value,
            expected: "more than 0",
        });
    }
    let originals = chosen(body, cells)?;
    let tolerance = body.tolerance();
    let image = |p: DVec3| {
        let height = p.dot(unit) - offset;
        if height.abs() <= tolerance { p } else { p - unit * (2.0 * height) }
    };
    let images: Vec<Cell> =
        mapped(body, &originals, image)?.into_iter().map(|cell| cell.reversed(Axis::U)).collect();
    if !keep {
        return replace_reversed(body, originals, images);
    }
    let made = insert(body, first, images)?;
    let renamed = |side: Side| {
        let cell = made[originals.binary_search(&side.cell).ok()?];
        Some(Side { cell, ..reversed(side) })
    };
    body.repeat_marks(renamed);
    settle(body, &made);
    Ok(Change { made, ..Change::default() })
}

/// Runs through cells in the opposite direction of their first index: a mirrored cell becomes a sound one. Bodies and
/// marks stay what they are.
///
/// # Errors
/// When no cell is named, or one is unknown.
pub fn reorient(body: &mut Body, cells: &[CellId]) -> Result<Change, OperationError> {
    let cells = chosen(body, cells)?;
    let turned = mapped(body, &cells, |p| p)?.into_iter().map(|cell| cell.reversed(Axis::U)).collect();
    replace_reversed(body, cells, turned)
}

/// Puts cells with their first index reversed in the place of others. Marks between two of them go with them; those to
/// other cells stay as far as they hold.
fn replace_reversed(
    body: &mut Body,
    cells: Vec<CellId>,
    turned: Vec<Cell>,
) -> Result<Change, OperationError> {
    for (id, cell) in cells.iter().zip(turned) {
        body.replace(*id, cell)?;
    }
    body.rename_marks(|side| if cells.binary_search(&side.cell).is_ok() { reversed(side) } else { side });
    settle(body, &cells);
    Ok(Change { touched: cells, ..Change::default() })
}

/// The side after the first index of its cell was reversed.
fn reversed(mut side: Side) -> Side {
    side.corner.0[0] = !side.corner.0[0];
    side
}

/// Cells with their control points moved by a map.
fn mapped(body: &Body, cells: &[CellId], map: impl Fn(DVec3) -> DVec3) -> Result<Vec<Cell>, OperationError> {
    let moved = |id: &CellId| {
        let cell = body.cell(*id)?;
        let error = |error: CellError| OperationError::Cell { id: *id, error };
        Some(cell.with_net(cell.net().map(&map)).map_err(error))
    };
    cells.iter().filter_map(moved).collect()
}

fn check_vector(name: &'static str, vector: DVec3) -> Result<(), OperationError> {
    match vector.to_array().into_iter().find(|x| !x.is_finite()) {
        Some(value) => Err(OperationError::Number { name, value, expected: "finite numbers" }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::test_bodies::{block, body_of, random_vector, ring, smooth_corners};
    use super::*;
    use crate::hyperpatch::composite::{BodyError, MOST_CELLS, Mark, Match, Sharing};
    use crate::hyperpatch::test_cells::random_net;
    use crate::hyperpatch::{Corner, Jacobian};

    fn marked(body: &mut Body) -> Side {
        let side = Side { cell: CellId(0), corner: Corner([true, false, true]), axis: Axis::U };
        let other = Side { cell: CellId(1), corner: Corner([false, false, true]), axis: Axis::U };
        let mark = Mark { other, is_swapped: false, shape: Some(Match::C1), material: Some(Match::None) };
        body.mark(side, mark);
        side
    }

    #[test]
    fn copies_lie_beside_and_keep_their_marks() {
        let mut body = block([2, 1, 1]);
        let side = marked(&mut body);
        let change = copy(&mut body, &[1, 0].map(CellId), DVec3::Z, CellId(30_000)).unwrap();
        assert_eq!(change.made, [30_000, 30_001].map(CellId));
        let net = body.cell(CellId(1)).unwrap().net().map(|p| p + DVec3::Z);
        assert_eq!(*body.cell(CellId(30_001)).unwrap().net(), net);
        assert_eq!(Sharing::new(&body).shared_faces().len(), 4);
        let mark = body.marks().get(Side { cell: CellId(30_000), ..side }).unwrap();
        assert_eq!((mark.other.cell, mark.material), (CellId(30_001), Some(Match::None)));
        assert_eq!(body.marks().iter().count(), 2);
        let taken = copy(&mut body, &[CellId(0)], DVec3::X, CellId(30_001));
        assert_eq!(taken, Err(OperationError::Body(BodyError::Taken { id: CellId(30_001) })));
        assert!(copy(&mut body, &[CellId(0)], DVec3::X * 3e9, CellId(7)).is_err());
        assert!(copy(&mut body, &[CellId(0)], DVec3::X * f64::NAN, CellId(7)).is_err());
    }

    /// An image has the volume of the original, a positive Jacobian, and shares what lies on the plane bit for bit.
    #[test]
    fn images_keep_volume_orientation_and_marks() {
        let net = random_net(4, 0.05).map(|p| if p.x < 0.2 { DVec3::new(0.3, p.y, p.z) } else { p });
        for normal in [DVec3::X, DVec3::new(3.0, 0.0, 0.0), DVec3::NEG_X] {
            let mut body = body_of([net.clone()]);
            let offset = 0.3 * normal.x.signum();
            let change = mirror(&mut body, &[CellId(0)], normal, offset, true, CellId(1)).unwrap();
            assert_eq!(change.made, [CellId(1)]);
            let [a, b] = [0, 1].map(|n| Jacobian::new(body.cell(CellId(n)).unwrap().net()).volume());
            assert!((a - b).abs() < 1e-14 && b > 0.0, "{a}, {b}");
            assert_eq!(Sharing::new(&body).shared_faces().len(), 1);
        }
        let mut body = ring(8);
        let side = marked(&mut body);
        let normal = random_vector(3);
        let all: Vec<CellId> = (0..8).map(CellId).collect();
        let volume = body.volume();
        let change = mirror(&mut body, &all, normal, 5.0, true, CellId(100)).unwrap();
        assert!((body.volume() - 2.0 * volume).abs() < 1e-11);
        assert_eq!((change.made.len(), smooth_corners(&body)), (8, 64));
        let image = Side { cell: CellId(100), ..reversed(side) };
        assert_eq!(body.marks().get(image).unwrap().shape, Some(Match::C1));

        let mut body = block([2, 1, 1]);
        marked(&mut body);
        let change = mirror(&mut body, &[CellId(0)], DVec3::X, 1.0, false, CellId(9)).unwrap();
        assert_eq!((change.touched, change.made.len()), (vec![CellId(0)], 0));
        assert_eq!(body.cell(CellId(0)).unwrap().net().bounds().1, DVec3::new(2.0, 1.0, 1.0));
        assert!(mirror(&mut body, &[CellId(0)], DVec3::ZERO, 1.0, true, CellId(9)).is_err());
        assert!(mirror(&mut body, &[CellId(0)], DVec3::X, f64::INFINITY, true, CellId(9)).is_err());
    }

    #[test]
    fn reversed_cells_are_the_same_body() {
        let mut body = block([2, 2, 2]);
        let side = marked(&mut body);
        // What is marked is between the first cell and the fifth in this block.
        let mark = *body.marks().get(side).unwrap();
        body.mark(side, Mark { other: Side { cell: CellId(4), ..mark.other }, ..mark });
        let before = body.clone();
        reorient(&mut body, &[0, 3].map(CellId)).unwrap();
        assert_eq!(smooth_corners(&body), 48);
        assert!((body.cell(CellId(0)).unwrap().net().jacobian(DVec3::splat(0.4)) + 1.0).abs() < 1e-12);
        let mark = body.marks().get(reversed(side)).unwrap();
        assert_eq!((mark.other.cell, mark.shape), (CellId(4), Some(Match::C1)));
        reorient(&mut body, &[0, 3].map(CellId)).unwrap();
        assert_eq!(body, before);
    }

    #[test]
    fn a_full_body_takes_no_copies() {
        let mut body = Body::new(3);
        let cell = block([1, 1, 1]).cells()[0].1.clone();
        for n in 0..MOST_CELLS as u32 - 1 {
            body.add_as(CellId(n), cell.clone()).unwrap();
        }
        let full = Err(OperationError::Body(BodyError::Full));
        assert_eq!(copy(&mut body, &[0, 1].map(CellId), DVec3::X, CellId(20_000)), full);
        assert_eq!(body.cells().len(), MOST_CELLS - 1);
    }
}
