import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { load } from "directrix";
import { root } from "../../scripts/lib/paths.mjs";
import { drawnBounds, drawnPositions, shiftsOf } from "../../www/src/hyperpatch/apart.js";
import { edgeSegments, sampleAt } from "../../www/src/hyperpatch/cell.js";
import { labsFor, relativeJacobian, viridis } from "../../www/src/hyperpatch/colors.js";
import { cellsIn, cellsOf } from "../../www/src/hyperpatch/document.js";
import { moved, placeOfCorner } from "../../www/src/hyperpatch/edits.js";
import { jointsOf } from "../../www/src/hyperpatch/joints.js";
import { neighboursOf } from "../../www/src/hyperpatch/neighbours.js";
import { boundsOf, neighbour, sharedCorner } from "../../www/src/hyperpatch/state.js";

/** @param {string} name */
const preset = async (name) => JSON.parse(await readFile(join(root, `www/presets/hyperpatch/${name}.json`), "utf8"));

const dx = await load();
const twisted = await preset("twisted");
const block = await preset("block");

test("a single place of a cell is where the kernel has it, with its composition", () => {
  const body = dx.hyperpatch(twisted);
  for (const uvw of /** @type {[number, number, number][]} */ ([[0, 0, 0], [1, 0, 1], [0.3, 0.6, 0.1], [0.5, 0.25, 0.9]])) {
    const expected = body.sample(0, uvw);
    const found = sampleAt(cellsOf(twisted)[0], uvw, twisted.materials.length);
    for (const axis of [0, 1, 2]) assert.ok(Math.abs(found.position[axis] - expected.position[axis]) < 1e-9, `${found.position}`);
    found.mix.forEach((fraction, i) => assert.ok(Math.abs(fraction - expected.mix[i]) < 1e-9));
  }
});

test("the boundary curves of a cell join its corners, each corner at three of them", () => {
  const [cell] = cellsOf(twisted);
  const segments = edgeSegments(cell);
  assert.equal(segments.length, 12 * 16 * 6);
  const ends = Array.from({ length: 12 }, (_, n) => [segments.slice(96 * n, 96 * n + 3), segments.slice(96 * n + 93, 96 * n + 96)]).flat();
  const [{ corners }] = dx.hyperpatch(twisted).cells;
  for (const corner of corners) {
    const near = ends.filter((end) => Math.hypot(...end.map((value, k) => value - corner[k])) < 1e-9);
    assert.equal(near.length, 3);
  }
});

test("corners follow each other round and round", () => {
  const sharing = dx.hyperpatch(block).sharing();
  const first = neighbour(sharing, null, 1);
  const last = neighbour(sharing, null, -1);
  assert.ok(first && last);
  assert.deepEqual(neighbour(sharing, last, 1), first);
  assert.deepEqual(neighbour(sharing, first, -1), last);
  // That in the middle of the block, which the boundary does not have, comes in its turn.
  let at = first;
  const seen = sharing.corners.map(() => (at = neighbour(sharing, at, 1) ?? at) && sharedCorner(sharing, at));
  assert.equal(new Set(seen).size, 27);
  assert.equal(neighbour({ ...sharing, corners: [] }, null, 1), null);
  assert.equal(sharedCorner(sharing, { cell: 99, corner: [0, 0, 0] }), null);
});

test("colours are the kernel's, those of one fraction, or those of each cell", () => {
  const { surface } = { surface: dx.hyperpatch(block).surface() };
  const count = surface.cells.length;
  assert.equal(labsFor(surface, { color: "material" }).length, 3 * count);
  const ends = labsFor(surface, { color: "jacobian", values: new Map([[surface.cells[0], 1]]) });
  assert.ok(ends[0] > 0.85, "the end of the scale is light");
  assert.deepEqual([viridis(0), viridis(1), viridis(2)], [[68, 1, 84], [253, 231, 37], [253, 231, 37]]);
  assert.equal(relativeJacobian({ leastJacobianBound: -3 }, -6), -0.5);
});

test("boxes", () => {
  assert.deepEqual(boundsOf([1, 2, 3, -1, 5, 0]), { min: [-1, 2, 0], max: [1, 5, 3] });
});

test("cells drawn apart keep their shape, and no two of a block touch any more", () => {
  const body = dx.hyperpatch(block);
  const surface = body.surface({ faces: "all" });
  const bounds = boundsOf(surface.positions);
  const shifts = shiftsOf(body.cells, bounds);
  const drawn = drawnPositions(surface, shifts, 0.5);
  assert.equal(drawnPositions(surface, shifts, 0), surface.positions);
  const boxes = body.cells.map(({ id }) => boundsOf(Array.from(surface.cells).flatMap((cell, n) => (cell === id ? [...drawn.subarray(3 * n, 3 * n + 3)] : []))));
  for (const { min, max } of boxes) assert.ok([0, 1, 2].every((k) => Math.abs(max[k] - min[k] - 1) < 1e-6));
  for (const [n, a] of boxes.entries()) {
    for (const b of boxes.slice(n + 1)) assert.ok([0, 1, 2].some((k) => a.max[k] < b.min[k] - 0.2 || b.max[k] < a.min[k] - 0.2));
  }
  const [around, whole] = [drawnBounds(bounds, shifts, 0.5), boundsOf(drawn)];
  assert.ok([0, 1, 2].every((k) => around.min[k] <= whole.min[k] + 1e-6 && around.max[k] >= whole.max[k] - 1e-6));
});

test("a corner has seven neighbours in a cell, and 26 where eight cells meet", () => {
  const cells = cellsOf(block);
  const { corners } = dx.hyperpatch(block).sharing();
  const counts = new Map(corners.map(({ sides }) => [sides.length, neighboursOf(sides, (id) => cells[id], false)]));
  for (const [users, points, lines] of [[1, 7, 12], [2, 11, 20], [4, 17, 33], [8, 26, 54]]) {
    const found = counts.get(users);
    assert.deepEqual([found?.points.length, found?.lines.length], [points, lines], `${users} cells`);
  }
  const inner = corners.find(({ sides }) => sides.length === 8);
  assert.equal(neighboursOf(inner?.sides ?? [], (id) => cells[id], true).points.length, 56);
});

test("how cells continue each other is drawn from what the kernel says of their corners", () => {
  const of = (/** @type {any} */ document, /** @type {"shape" | "material"} */ aspect) => {
    const body = dx.hyperpatch(document);
    return { body, joints: jointsOf(body.continuity(), body.sharing(), cellsIn(body.cells, body.coefficients()), aspect) };
  };
  const { joints: smooth, body } = of(block, "shape");
  assert.deepEqual(smooth.counts, { C1: 48, C0: 0, none: 0, contacts: 0, gap: 0 });
  assert.equal(smooth.lines.length, 0);
  body.sharing().corners.forEach(({ sides }, n) => assert.equal(smooth.signs[n], sides.length > 1 ? 1 : 0));
  // A corner that moves alone: its faces have creases there, and lines lie on the halves of the curves that end in it.
  const inner = body.sharing().corners.find(({ sides }) => sides.length === 8);
  const { joints } = of(moved(block, [{ place: placeOfCorner(inner?.sides[0] ?? { cell: 0, corner: [0, 0, 0] }), by: [0.1, 0.05, 0] }], "single"), "shape");
  assert.equal(joints.counts.C0, 12);
  assert.equal(joints.lines.filter(({ isFirst }) => isFirst).length, 6 * 8);
  // Faces that part between their corners.
  const pair = { ...block, operations: [{ op: "cells", cells: cellsOf(block).slice(0, 2) }] };
  const bent = structuredClone(pair);
  const [{ corner }] = dx.hyperpatch(pair).sharing().faces.filter(({ sides }) => sides.length > 1).map(({ sides }) => ({ corner: sides[0].face }));
  const axis = "uvw".indexOf(corner[0]);
  for (const [n, coefficient] of cellsOf(/** @type {any} */ (bent))[0].coefficients.entries()) {
    const at = [n >> 4, (n >> 2) & 3, n & 3];
    if (at[axis] !== (corner[1] === "1" ? 3 : 0)) continue;
    const others = at.filter((_, k) => k !== axis);
    // Of the sixteen points of the face one corner's block stays where it was.
    if (!others.every((index) => index < 2)) coefficient.position[axis] += corner[1] === "1" ? -0.2 : 0.2;
  }
  const { joints: parted } = of(bent, "shape");
  assert.equal(parted.counts.contacts, 1);
  assert.ok(parted.counts.gap > 0.15 && parted.counts.gap < 0.25, `${parted.counts.gap}`);
  const ties = parted.lines.map(({ points }) => Math.hypot(points[0] - points[3], points[1] - points[4], points[2] - points[5]));
  assert.ok(Math.max(...ties) > 0.15 && Math.max(...ties) <= parted.counts.gap + 1e-9);
});
