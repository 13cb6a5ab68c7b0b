/** Edits of bodies in the page as operations: what they add, how they are joined, and what stays the same object. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { load } from "directrix";
import { root } from "../../scripts/lib/paths.mjs";
import { faceSegments, edgeSegments } from "../../www/src/hyperpatch/cell.js";
import { cellsIn, cellsOf } from "../../www/src/hyperpatch/document.js";
import { mirroredWay, opposite } from "../../www/src/hyperpatch/editing/mirror.js";
import { appended, changed, idsOf, moved, movedSince, placeOfCorner, shifted, without } from "../../www/src/hyperpatch/edits.js";
import { toggled } from "../../www/src/hyperpatch/state.js";

/** @typedef {import("../../www/src/hyperpatch/document.js").BodyDocument} BodyDocument */

/** @param {string} name @returns {Promise<BodyDocument>} */
const preset = async (name) => JSON.parse(await readFile(join(root, `www/presets/hyperpatch/${name}.json`), "utf8"));

const dx = await load();
const block = await preset("block");
const pair = await preset("pair");

/** The corner of the block that all eight cells have. */
function innerCorner() {
  const found = dx.hyperpatch(block).sharing().corners.find(({ sides }) => sides.length === 8);
  assert.ok(found);
  return found;
}

/** @param {readonly number[]} found @param {readonly number[]} expected */
const near = (found, expected) => expected.forEach((value, k) => assert.ok(Math.abs(found[k] - value) < 1e-12, `${found} is not ${expected}`));

test("a corner moves in every cell that has it, by one operation, and the body stays joined", () => {
  const inner = innerCorner();
  const place = placeOfCorner(inner.sides[3]);
  const after = moved(block, [{ place, by: [0.05, -0.02, 0.03] }], "block");
  assert.deepEqual(after.operations.slice(1), [{ op: "move", id: 1, cell: place.cell, at: place.at, by: [0.05, -0.02, 0.03] }]);
  assert.equal(after.operations[0], block.operations[0]);
  const body = dx.hyperpatch(after);
  assert.deepEqual(body.sharing().shared, dx.hyperpatch(block).sharing().shared);
  const same = body.sharing().corners.find(({ sides }) => sides.length === 8);
  near(same?.position ?? [], inner.position.map((value, k) => value + [0.05, -0.02, 0.03][k]));
  // Nothing moves by nothing.
  assert.equal(moved(block, [{ place, by: [0, 0, 0] }], "block"), block);
});

test("moves of one run and target add up, those of another run or target do not", () => {
  const place = { cell: 0, at: [3, 3, 3] };
  const by = /** @type {[number, number, number]} */ ([0.1, 0, 0]);
  const one = moved(block, [{ place, by }], "block", "drag 1");
  const two = moved(one, [{ place, by }], "block", "drag 1");
  assert.deepEqual(two.operations.slice(1).map((operation) => "by" in operation && operation.by), [[0.2, 0, 0]]);
  const other = { cell: 0, at: [2, 3, 3] };
  const three = moved(two, [{ place: other, by }, { place, by }], "block", "drag 1");
  assert.deepEqual(three.operations.slice(1).map((operation) => "by" in operation && operation.by), [[0.30000000000000004, 0, 0].map((x) => Number(x.toPrecision(12))), [0.1, 0, 0]]);
  assert.equal(moved(three, [{ place, by }], "single", "drag 1").operations.length, 4);
  assert.equal(moved(three, [{ place, by }], "block", "drag 2").operations.length, 4);
  assert.equal(moved(three, [{ place, by }], "block").operations.length, 4);
  // There and back leaves nothing behind.
  assert.deepEqual(moved(one, [{ place, by: [-0.1, 0, 0] }], "block", "drag 1").operations, block.operations);
});

test("mixes and marks of one run and target take each other's place", () => {
  const first = appended(block, { op: "mix", cells: [0, 1], mix: [0.5, 0.5] }, "bar 1");
  const next = appended(first, { op: "mix", cells: [0, 1], mix: [0.25, 0.75] }, "bar 1");
  assert.deepEqual(next.operations[1], { op: "mix", id: 1, cells: [0, 1], mix: [0.25, 0.75] });
  assert.equal(next.operations.length, 2);
  assert.equal(appended(first, { op: "mix", cells: [0], mix: [0.25, 0.75] }, "bar 1").operations.length, 3);
});

test("what an edit has done before the module answers", () => {
  const place = { cell: 0, at: [3, 3, 3] };
  const one = moved(block, [{ place, by: [0.1, 0, 0] }], "block", "keys 1");
  const two = moved(one, [{ place, by: [0, 0.2, 0] }], "block", "keys 1");
  near(movedSince(two, block, place), [0.1, 0.2, 0]);
  near(movedSince(two, one, place), [0, 0.2, 0]);
  near(movedSince(block, two, place), [-0.1, -0.2, 0]);
  near(movedSince(two, one, { cell: 0, at: [0, 0, 0] }), [0, 0, 0]);
});

test("identifiers stay with operations that are put elsewhere or left when others go", () => {
  const { operations } = ["u", "v", "w"].reduce((document, axis) => appended(document, { op: "subdivide", cell: 0, axis: /** @type {"u"} */ (axis) }), block);
  const document = { ...block, operations };
  assert.deepEqual(idsOf(operations), [0, 1, 2, 3]);
  const fewer = without(document, 0);
  assert.deepEqual(idsOf(fewer.operations), [1, 2, 3]);
  const turned = shifted(document, 0, 1);
  assert.deepEqual(idsOf(turned.operations), [1, 0, 2, 3]);
  assert.equal(turned.operations[2], operations[2]);
  assert.equal(shifted(document, 0, -1), document);
  assert.equal(shifted(document, 3, 1), document);
  // What was written without identifiers gets them where the order no longer gives the same.
  const plain = { ...document, operations: operations.map((operation) => /** @type {any} */ ({ ...operation, id: undefined })) };
  assert.deepEqual(idsOf(without(plain, 1).operations), [0, 2, 3]);
  // The module agrees.
  assert.deepEqual(dx.hyperpatch(turned).operations.map(({ id }) => id), [1, 0, 2, 3]);
});

test("a number of an earlier operation is changed where it stands, and the body follows", () => {
  const place = placeOfCorner(innerCorner().sides[0]);
  const first = moved(block, [{ place, by: [0.1, 0, 0] }], "block");
  const second = appended(first, { op: "mix", cells: [0], mix: [0, 1, 0] });
  const after = changed(second, 1, { by: [0, 0.1, 0] });
  assert.equal(after.operations[2], second.operations[2]);
  const corner = dx.hyperpatch(after).sharing().corners.find(({ sides }) => sides.length === 8);
  near(corner?.position ?? [], innerCorner().position.map((value, k) => value + [0, 0.1, 0][k]));
});

test("coefficients of the module are the cells of the document", () => {
  const body = dx.hyperpatch(pair);
  const cellOf = cellsIn(body.cells, body.coefficients());
  cellsOf(pair).forEach((cell, n) => {
    cell.coefficients.forEach(({ position, mix }, k) => {
      near(cellOf(n)?.coefficients[k].position ?? [], position);
      near(cellOf(n)?.coefficients[k].mix ?? [], mix ?? [1, 0]);
    });
  });
  assert.equal(cellOf(7), undefined);
  // A face has four of the twelve curves of its cell.
  const whole = edgeSegments(cellsOf(pair)[0]);
  const face = faceSegments(cellsOf(pair)[0], "v1");
  assert.equal(3 * face.length, whole.length);
  assert.ok(face.every((value) => whole.includes(value)));
});

test("what lies opposite in a mirror plane, and its way", () => {
  const body = dx.hyperpatch(block);
  const cellOf = cellsIn(body.cells, body.coefficients());
  const sharing = body.sharing();
  const { position: middle } = innerCorner();
  const mirror = { axis: /** @type {const} */ (0), at: middle[0] };
  const bodyOf = { sharing, cellOf, size: 4 };
  let [pairs, own] = [0, 0];
  for (const { position, sides } of sharing.corners) {
    const found = opposite(sides[0], placeOfCorner(sides[0]), mirror, bodyOf);
    if (found === "itself") {
      own += 1;
      assert.ok(Math.abs(position[0] - middle[0]) < 1e-9);
      continue;
    }
    assert.ok(found);
    pairs += 1;
    const other = cellOf(found.cell)?.coefficients[(4 * found.at[0] + found.at[1]) * 4 + found.at[2]].position ?? [];
    near(other, [2 * middle[0] - position[0], position[1], position[2]]);
  }
  assert.deepEqual([pairs, own], [18, 9]);
  assert.equal(opposite(sharing.corners[0].sides[0], placeOfCorner(sharing.corners[0].sides[0]), { axis: 0, at: 77 }, bodyOf), null);
  assert.deepEqual(mirroredWay([1, 2, 3], 1), [1, -2, 3]);
});

test("lists that are chosen from", () => {
  assert.deepEqual(toggled([1, 2], 2), [1]);
  assert.deepEqual(toggled([1, 2], 3), [1, 2, 3]);
});

test("with what belongs to it a corner stays smooth, alone it does not", () => {
  const place = placeOfCorner(innerCorner().sides[0]);
  const isSmooth = (/** @type {import("../../www/src/hyperpatch/edits.js").Reach} */ reach) =>
    dx.hyperpatch(moved(block, [{ place, by: [0.1, 0.05, 0] }], reach)).continuity().faces.every(({ shape }) => shape === "C1");
  assert.equal(isSmooth("block"), true);
  assert.equal(isSmooth("single"), false);
});
