/** Bodies of the person's own in the solver laboratory: their first problem, and the boxes by which groups pick elements. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { load } from "directrix";
import { root } from "../../scripts/lib/paths.mjs";
import { drawnBox, reachOf, stepped, wayOf, withSide, written } from "../../www/src/laboratory/box-edit.js";
import { withGroup, withRest } from "../../www/src/laboratory/edits.js";
import { firstProblem } from "../../www/src/laboratory/first-problem.js";
import { boundsOf } from "../../www/src/laboratory/mesh.js";
import { modelOf, MODELS } from "../../www/src/laboratory/models.js";
import { withElements } from "../../www/src/laboratory/preview.js";
import { sectionAlong } from "../../www/src/laboratory/section-along.js";
import { acrossOf } from "../../www/src/laboratory/section-state.js";

/** @import { LaboratoryDocument, Model } from "../../www/src/laboratory/document.js" */

const dx = await load();
const cube = JSON.parse(await readFile(join(root, "www/presets/laplace/cube.json"), "utf8"));
/** @param {unknown} document */
const boundaryOf = (document) => dx.boundary(/** @type {any} */ (document));
/** The cube's materials round another body, all of one value. @param {Model} model @returns {LaboratoryDocument} */
const round = (model) => ({ directrix: 1, kind: "laplace", title: "", materials: cube.materials, unit: "mm", model, groups: [], rest: { value: [1, 0] }, solver: {} });

/** Its first problem as the kernel reads it. @param {Model} model @param {LaboratoryDocument} [document] */
function first(model, document = round(model)) {
  const found = firstProblem(document, model, boundaryOf(round(model)), "own");
  return { ...found, boundary: boundaryOf(found.document) };
}

/** A tube of six sides along a line in the plane of y and z. @param {(z: number) => number} bend */
function tube(bend) {
  const [rings, sides] = [24, 6];
  const vertices = Array.from({ length: rings * sides }, (_, n) => {
    const [z, turn] = [(10 * Math.floor(n / sides)) / (rings - 1), (2 * Math.PI * (n % sides)) / sides];
    return [0.5 * Math.cos(turn), bend(z) + 0.5 * Math.sin(turn), z];
  });
  const triangles = [];
  for (let n = 0; n < (rings - 1) * sides; n += 1) {
    const [a, b] = [n, n - (n % sides) + ((n + 1) % sides)];
    triangles.push([a, b, b + sides], [a, b + sides, a + sides]);
  }
  const last = (rings - 1) * sides;
  for (let k = 1; k + 1 < sides; k += 1) triangles.push([0, k + 1, k], [last, last + k, last + k + 1]);
  return { kind: "mesh", vertices, triangles };
}

test("every body has a first problem that can be solved: both ends, each with elements, the rest insulated", () => {
  for (const kind of Object.keys(MODELS)) {
    const { boundary, document, told } = first(modelOf(kind));
    assert.deepEqual([boundary.ready, boundary.diagnostics.filter(({ remark }) => !remark)], [true, []], kind);
    assert.equal(boundary.sets.length, 3, kind);
    assert.ok(boundary.sets.every(({ count }) => count > 0), kind);
    assert.deepEqual(boundary.conditions, [{ value: [1, 0] }, { value: [0, 1] }, { flux: [0, 0] }], kind);
    assert.equal(document.materials, cube.materials);
    assert.equal("section" in document, MODELS[kind].dimension === 3);
    for (const { name } of document.groups) assert.ok(told.includes(name), told);
  }
});

test("a bar of twelve triangles has its end faces at two materials, so that its solution is linear", () => {
  const vertices = Array.from({ length: 8 }, (_, i) => [i & 1 ? 7 : 0, i & 2 ? 2 : 0, i & 4 ? 1 : 0]);
  const triangles = [[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4], [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]];
  const { boundary, document } = first({ kind: "mesh", vertices, triangles });
  assert.deepEqual(document.groups.map(({ name }) => name), ["left end", "right end"]);
  assert.deepEqual(boundary.sets.map(({ count, measure }) => [count, measure]), [[2, 2], [2, 2], [8, 42]]);
  assert.equal(boundary.exact, "linear");
  assert.ok(Math.abs(dx.exact(/** @type {any} */ (document), [1.75, 1, 0.5])[0] - 0.75) < 1e-12);
});

test("a first problem takes a solver that its elements allow, and leaves another as it is", () => {
  const sphere = { ...modelOf("sphere"), level: 4 };
  const withSolver = (/** @type {Model} */ model, /** @type {any} */ solver) => first(model, { ...round(model), solver }).document.solver;
  assert.deepEqual(withSolver(sphere, { method: "lu" }), {});
  assert.deepEqual(withSolver(modelOf("cube"), { method: "lu" }), { method: "lu" });
  assert.deepEqual(withSolver(sphere, { preconditioner: "ssor", omega: 1.2 }), { preconditioner: "ssor", omega: 1.2 });
  assert.deepEqual(withSolver({ ...sphere, level: 5 }, { preconditioner: "ssor", omega: 1.2, tolerance: 1e-8 }), { preconditioner: "jacobi", tolerance: 1e-8 });
});

test("the section of a body goes along it: through the middle of a straight one, and with the bend of a bent one", () => {
  const sectionOf = (/** @type {(z: number) => number} */ bend) => {
    const boundary = boundaryOf(round(tube(bend)));
    return sectionAlong(boundary, boundsOf(boundary), 2);
  };
  const straight = sectionOf(() => 0);
  assert.deepEqual([acrossOf(straight), straight.normal], ["y", [0, 1, 0]]);
  assert.ok(Math.abs(straight.origin[1]) < 1e-9);
  // In the middle of its box a plane across y would meet nothing but the legs of the arc.
  const arc = sectionOf((z) => 4 * Math.sin((Math.PI * z) / 10));
  assert.deepEqual([acrossOf(arc), arc.origin[0]], ["x", 0]);
  // A slight bow is followed by moving the plane towards its shaft.
  const bow = sectionOf((z) => 0.7 * Math.sin((Math.PI * z) / 10));
  assert.equal(acrossOf(bow), "y");
  assert.ok(bow.origin[1] > 0.1 && bow.origin[1] < 0.7, `${bow.origin[1]}`);
});

test("a side of a box moves on its way alone: never past the other side, and not far from the body", () => {
  const bounds = boundsOf(boundaryOf(cube));
  const box = [[0.9, -1e9, 0], [0.2, 1e9, 1]];
  const low = /** @type {const} */ ({ axis: 0, end: "min" });
  assert.deepEqual(drawnBox(box, bounds), { min: [0.2, -0.05, 0], max: [0.9, 1.05, 1] });
  assert.deepEqual(wayOf(box, low, bounds), [-0.05, 0.9]);
  assert.deepEqual(withSide(box, low, 0.31415926, bounds), [[0.314, -1e9, 0], [0.9, 1e9, 1]]);
  assert.deepEqual(withSide(box, low, 5, bounds)[0][0], 0.9);
  assert.deepEqual(withSide(box, low, -5, bounds)[0][0], -0.05);
  assert.deepEqual(stepped(box, low, 10, bounds)[0][0], 0.3);
  // A side far away is brought to where it is drawn by the first step, and stays where it is when it is to go farther.
  assert.deepEqual(stepped(box, { axis: 1, end: "min" }, 10, bounds)[0][1], 0.05);
  assert.deepEqual(stepped(box, { axis: 1, end: "min" }, -1, bounds)[0][1], -1e9);
  assert.equal(written(0.1 + 0.2, reachOf(bounds)), 0.3);
  assert.equal(written(123.456, { min: [0, 0, 0], max: [450, 1, 1] }), 123.5);
});

test("while a box is dragged the page picks the elements that the kernel picks", () => {
  const whole = { ...cube, groups: [{ name: "corner", where: { box: [[0, 0, 0], [0.5, 0.5, 0.5]] }, condition: { value: [1, 0] } }, { name: "end", where: { direction: [0, 0, 1], angle: 10, box: [[0, 0, 0.9], [1, 0.25, 1]] }, condition: { value: [0.5, 0.5] } }] };
  const moved = [{ index: 0, box: [[-1, 0.2, 0], [0.75, 2, 0.6]] }, { index: 0, box: [[3, 3, 3], [4, 4, 4]] }, { index: 1, box: [[0, 0.3, 0], [0.7, 1, 1]] }];
  for (const document of [whole, withRest(whole, null)]) {
    const before = boundaryOf(document);
    for (const { index, box } of moved) {
      const next = withGroup(document, index, { where: { ...document.groups[index].where, box } });
      const [known, shown] = [boundaryOf(next), withElements(before, index, next.groups[index], next.groups.length)];
      assert.ok(shown);
      assert.deepEqual(shown.members, known.members);
      const given = (/** @type {any} */ { conditions, groups }) => [...groups].map((condition) => conditions[condition] ?? null);
      assert.deepEqual(given(shown), given(known));
    }
  }
  assert.equal(withElements(boundaryOf(cube), 0, { ...cube.groups[0], where: { positive: "z", box: [[0, 0, 0], [1, 1, 1]] } }, 2), null);
});
