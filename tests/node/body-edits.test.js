/** Edits of bodies in the page as operations: what they add, how they are joined, and what stays the same object. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { load } from "directrix";
import { root } from "../../scripts/lib/paths.mjs";
import { faceSegments, edgeSegments } from "../../www/src/hyperpatch/cell.js";
import { cellsIn, cellsOf } from "../../www/src/hyperpatch/document.js";
import { nodesOf } from "../../www/src/hyperpatch/editing/grid.js";
import { mixTarget, wholePercents } from "../../www/src/hyperpatch/editing/mix.js";
import { mirroredWay, opposite } from "../../www/src/hyperpatch/editing/mirror.js";
import { appended, changed, idsOf, moved, movedSince, placeOfCorner, shifted, without } from "../../www/src/hyperpatch/edits.js";
import { along, flat } from "../../www/src/hyperpatch/editing/profile.js";
import { newlyInvalid, reasonOf } from "../../www/src/hyperpatch/editing/refusal.js";
import { words } from "../../www/src/hyperpatch/editing/words.js";
import { FIRST_SHOWN, toggled, withoutGone } from "../../www/src/hyperpatch/state.js";

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

test("what a mix goes to follows what is chosen", () => {
  const corner = { cell: 3, corner: [1, 0, 1] };
  const chosen = { cells: [1, 2], corner, at: null };
  assert.deepEqual(mixTarget("cells", chosen), { cells: [1, 2] });
  assert.deepEqual(mixTarget("corner", chosen), { cell: 3, corner: [1, 0, 1] });
  assert.deepEqual(mixTarget("within", chosen), { cell: 3, corner: [1, 0, 1], within: [1, 2] });
  assert.deepEqual(mixTarget("at", chosen), { cell: 3, at: [3, 0, 3] });
  assert.deepEqual(mixTarget("at", { ...chosen, at: { cell: 4, at: [2, 0, 1] } }), { cell: 4, at: [2, 0, 1] });
  assert.equal(mixTarget("within", { ...chosen, cells: [] }), null);
  assert.equal(mixTarget("corner", { ...chosen, corner: null }), null);
  assert.equal(mixTarget("cells", { ...chosen, cells: [] }), null);
  assert.deepEqual(wholePercents([0.406, 0.344, 0.25]), [0.41, 0.34, 0.25]);
  for (const mix of [[1 / 3, 1 / 3, 1 / 3], [0.005, 0.995], [1]]) assert.ok(Math.abs(wholePercents(mix).reduce((sum, each) => sum + each, 0) - 1) < 1e-12);
});

test("the grid of a corner has every coefficient once, the corner in the middle", () => {
  const body = dx.hyperpatch(block);
  for (const { sides } of body.sharing().corners) {
    const [side] = sides;
    const neighbourhood = body.neighbourhood(side.cell, /** @type {[number, number, number]} */ (side.corner));
    const nodes = nodesOf({ neighbourhood, side });
    assert.equal(nodes.length, neighbourhood.points.length);
    assert.equal(new Set(nodes.map(({ at }) => String(at))).size, nodes.length);
    assert.deepEqual(nodes.filter(({ isCorner }) => isCorner).map(({ at }) => at), [[0, 0, 0]]);
  }
  // At a crease there is no grid of all: those of the cell alone.
  const neighbourhood = { ...body.neighbourhood(0, [1, 1, 1]), regular: false };
  assert.equal(nodesOf({ neighbourhood, side: { cell: 0, corner: [1, 1, 1] } }).length, 8);
});

test("the profile across two cells is that of the kernel, and flat where the flat rule holds", () => {
  const [cell] = cellsOf(block);
  const body = dx.hyperpatch(block);
  const list = along(cell, { face: "u1", corner: [1, 0, 1] }, 3);
  for (const share of [0, 0.25, 0.5, 1]) near(list[24 * share], body.sample(0, [share, 0, 1]).mix);
  // The presets follow the paper's rule.
  flat(list[0], list[24]).forEach((mix, n) => mix.forEach((fraction, i) => assert.ok(Math.abs(fraction - list[n][i]) < 1e-9)));
});

test("an edit is refused for cells that were not invalid before", async () => {
  const verdicts = dx.hyperpatch(await preset("invalid")).verdicts();
  assert.equal(newlyInvalid(verdicts, new Set([0])).length, 0);
  const bad = newlyInvalid(verdicts, new Set());
  assert.equal(bad.length, 1);
  assert.match(reasonOf(bad), /^Cell 0 is turned inside out/);
  assert.match(reasonOf([...bad, ...bad]), /1 other is invalid/);
});

test("every operation has a sentence", () => {
  const said = [
    { op: "cells", cells: [{}, {}] },
    { op: "move", cell: 3, at: [0, 3, 3], by: [0.25, 0, -1] },
    { op: "move", cell: 3, at: [1, 3, 3], by: [0, 0, 1], reach: "single" },
    { op: "continuity", cell: 0, face: "u1", corner: [1, 0, 0], shape: "C0" },
    { op: "mix", mix: [0.25, 0.75], cells: [1, 2] },
    { op: "mix", mix: [0, 1], cell: 1, corner: [0, 0, 1], within: [1] },
    { op: "slope", cell: 0, corner: [0, 0, 0], rule: "natural" },
    { op: "delete", cells: [1, 2, 3, 4, 5] },
    { op: "copy", cells: [1], by: [7, 0, 0] },
    { op: "mirror", cells: [1], normal: [0, 2, 0], offset: 1 },
    { op: "reorient", cells: [10000] },
    { op: "extrude", faces: [{ cell: 0, face: "w1" }], by: 0.5 },
    { op: "subdivide", cell: 0, axis: "v" },
  ].map((operation) => words.sentence(/** @type {any} */ (operation)));
  assert.deepEqual(said, [
    "2 cells as given",
    "Move corner of cell 3 by 0.25, 0, \u22121",
    "Move coefficient 133 of cell 3 by 0, 0, 1, alone",
    "Corner 100 of face u1 of cell 0: shape C0",
    "Mix 25 : 75 in cells 1, 2",
    "Mix 0 : 100 in corner 001 of cell 1, within cell 1",
    "Natural slope of material at corner 000 of cell 0",
    "Delete 5 cells",
    "Copy cell 1 by 7, 0, 0",
    "Mirror cell 1 across y = 0.5",
    "Turn the parameters of cell 10000 round",
    "Extrude face w1 of cell 0 by 0.5",
    "Subdivide cell 0 along v at 0.5",
  ]);
});

test("what the body does not have any more is not chosen any more", () => {
  const body = dx.hyperpatch(block);
  const known = { cells: body.cells.slice(0, 4), sharing: body.sharing() };
  const shown = { ...FIRST_SHOWN, cells: [1, 6], cell: 6, corner: { cell: 6, corner: [0, 0, 0] }, others: [{ cell: 1, corner: [0, 0, 0] }], at: { cell: 6, at: [1, 0, 0] } };
  const left = withoutGone(shown, known);
  assert.deepEqual([left.cells, left.cell, left.corner, left.others, left.at], [[1], 1, null, shown.others, null]);
  assert.equal(withoutGone(left, known), left);
});
