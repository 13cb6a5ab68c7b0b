import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { load } from "directrix";
import { root } from "../../scripts/lib/paths.mjs";
import { edgeSegments, sampleAt } from "../../www/src/hyperpatch/cell.js";
import { labsFor, relativeJacobian, viridis } from "../../www/src/hyperpatch/colors.js";
import { cellsOf } from "../../www/src/hyperpatch/document.js";
import { isBody } from "../../www/src/hyperpatch/kind.js";
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

test("kinds and boxes", () => {
  assert.equal(isBody(block), true);
  assert.equal(isBody({ kind: "curves" }), false);
  assert.deepEqual(boundsOf([1, 2, 3, -1, 5, 0]), { min: [-1, 2, 0], max: [1, 5, 3] });
});
