/** Curves in space on the canvas: where their control points are seen, and what an edit there does to them, against the kernel. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { load } from "directrix";
import { root } from "../../scripts/lib/paths.mjs";
import { nearestParameter } from "../../www/src/spline.js";
import { reverseCurve, scalePoints, turnPoints } from "../../www/src/state/curve-edits.js";
import { movePoints, removePoints } from "../../www/src/state/edits.js";
import { hasSpace, isInSpace, seen, seenAlong } from "../../www/src/state/in-space.js";
import { meanAlong, movedAlong } from "../../www/src/state/in-space-edits.js";
import { middleOf, whole } from "../../www/src/state/selection.js";
import { deBoorAt } from "./curves.js";

/** @import { Point } from "../../www/src/types.js" */

const dx = await load();
/** @param {string} name @returns {Promise<any>} */
const preset = async (name) => dx.defaults(JSON.parse(await readFile(join(root, `www/presets/${name}.json`), "utf8")));
const branch = await preset("pipe-branch");
const amoeba = await preset("amoeba");
const { projection, samples } = dx.match(branch);
assert.ok(projection);
seenAlong(projection);

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const dot = (a, b) => [0, 1, 2].reduce((sum, k) => sum + a[k] * b[k], 0);
const all = [...branch.curves[0].points.keys()];

test("control points are seen where the kernel projects their curve", () => {
  branch.curves.forEach((/** @type {any} */ curve, /** @type {number} */ k) => {
    samples[k].parameters.forEach((u, i) => {
      const [x, y] = deBoorAt(seen(curve), u);
      const [a, b] = samples[k].points[i];
      assert.ok(Math.hypot(x - a, y - b) < 1e-9, `curve ${k}, sample ${i}`);
    });
  });
});

test("a plane curve is its own projection", () => {
  assert.ok(hasSpace(branch) && !hasSpace(amoeba) && isInSpace(branch.curves[1]) && !isInSpace(undefined));
  assert.equal(seen(amoeba.curves[0]), amoeba.curves[0]);
  assert.equal(seen(branch.curves[0]), seen(branch.curves[0]), "outlines are kept by it");
});

test("moves, turns and scales act in the plane, and every point keeps its distance from it", () => {
  const middle = middleOf(branch, whole(0));
  const edits = {
    move: movePoints(branch, 0, [2, 5], [3.25, -1.5]),
    turn: turnPoints(branch, 0, all, middle, 30),
    scale: scalePoints(branch, 0, all, middle, [1.5, 0.75]),
  };
  for (const [name, after] of Object.entries(edits)) {
    after.curves[0].points.forEach((/** @type {number[]} */ at, /** @type {number} */ i) => {
      const before = branch.curves[0].points[i];
      assert.ok(Math.abs(dot(at, projection.normal) - dot(before, projection.normal)) < 1e-7, `${name}, point ${i}`);
      const [[x, y], [a, b]] = [seen(branch.curves[0]).points[i], seen(after.curves[0]).points[i]];
      const angle = Math.PI / 6;
      const [u, v] = [x - middle[0], y - middle[1]];
      const expected = {
        move: [2, 5].includes(i) ? [x + 3.25, y - 1.5] : [x, y],
        turn: [middle[0] + u * Math.cos(angle) - v * Math.sin(angle), middle[1] + u * Math.sin(angle) + v * Math.cos(angle)],
        scale: [middle[0] + 1.5 * u, middle[1] + 0.75 * v],
      }[name] ?? [NaN, NaN];
      assert.ok(Math.hypot(a - expected[0], b - expected[1]) < 1e-7, `${name}, point ${i}: ${a}, ${b}`);
    });
    assert.equal(after.curves[1], branch.curves[1]);
  }
  assert.equal(edits.move.curves[0].points[0], branch.curves[0].points[0]);
});

test("a coordinate in space is changed alone, and the ends of a clamped curve go together", () => {
  const [curve] = branch.curves;
  const raised = movedAlong(curve, [1, 4], 2, 2.5);
  raised.points.forEach((at, i) => {
    const [x, y, z] = /** @type {number[]} */ (curve.points[i]);
    assert.deepEqual([...at].slice(0, 2), [x, y]);
    assert.ok(Math.abs(/** @type {number[]} */ (at)[2] - z - ([1, 4].includes(i) ? 2.5 : 0)) < 1e-12);
  });
  assert.ok(Math.abs(meanAlong(raised, [1, 4], 2) - meanAlong(curve, [1, 4], 2) - 2.5) < 1e-12);
  assert.equal(movedAlong(curve, [1], 0, 0), curve);
  const clamped = { ...curve, form: /** @type {const} */ ("clamped"), points: [...curve.points, curve.points[0]] };
  const { points } = movedAlong(clamped, [0], 1, 4);
  assert.deepEqual(points.at(-1), points[0]);
  const moved = movePoints({ ...branch, curves: [clamped, branch.curves[1]] }, 0, [0], [1, 1]).curves[0];
  assert.deepEqual(moved.points.at(-1), moved.points[0]);
  const fewer = removePoints({ ...branch, curves: [clamped, branch.curves[1]] }, 0, [0]).curves[0];
  assert.deepEqual(fewer.points.at(-1), curve.points[1]);
});

test("points are taken away, added and reversed in space", () => {
  assert.deepEqual(removePoints(branch, 0, [3]).curves[0].points, branch.curves[0].points.toSpliced(3, 1));
  const back = reverseCurve(reverseCurve(branch, 0), 0).curves[0];
  assert.deepEqual(back.points, branch.curves[0].points);
  const at = /** @type {Point} */ ([30, 20]);
  const u = nearestParameter(branch.curves[0], at);
  const more = /** @type {any} */ (dx.insertPoint(branch, 0, u));
  assert.equal(more.curves[0].points.length, all.length + 1);
  assert.ok(more.curves[0].points.every((/** @type {number[]} */ point) => point.length === 3));
  for (const share of [0, 0.1, 0.37, 0.8]) {
    const [[a, b], [c, d]] = [branch, more].map((document) => deBoorAt(seen(document.curves[0]), share));
    assert.ok(Math.hypot(a - c, b - d) < 1e-9, "the curve stays as it is");
  }
});
