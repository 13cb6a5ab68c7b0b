/** Edits of curves and selections as the page makes them: pure functions, checked without a browser and against the kernel. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { load } from "directrix";
import { root } from "../../scripts/lib/paths.mjs";
import { join } from "node:path";
import { deBoorAt, loop, polygonArea } from "./curves.js";
import {
  alignPoints,
  deleteCurve,
  duplicateCurve,
  duplicatePoint,
  placeForCurve,
  putShape,
  reverseCurve,
  reversedPoint,
  scalePoints,
  setDegree,
  swapCurves,
  turnPoints,
} from "../../www/src/state/curve-edits.js";
import { canRemovePoints, handleCount, movePoints, removePoints } from "../../www/src/state/edits.js";
import { allPoints, includes, isWhole, only, several, singlePoint, toggle, whole, within } from "../../www/src/state/selection.js";
import { curveThrough, solveCyclic } from "../../www/src/state/through.js";
import { snappedTo } from "../../www/src/stage/snap.js";
import { gridStep } from "../../www/src/view.js";

const dx = await load({ module: "figure" });
/** @param {string} name @returns {Promise<any>} */
const preset = async (name) =>
  dx.defaults(JSON.parse(await readFile(join(root, `www/presets/${name}.json`), "utf8")));
const amoeba = await preset("amoeba");
const star = await preset("star-in-circle");
const pocket = await preset("u-in-oval");
/** The amoeba with its first curve clamped: the last control point repeats the first. */
/** @type {any} */
const clamped = await dx.defaults({
  ...amoeba,
  curves: [{ degree: 3, form: "clamped", points: [...loop(9, 8), loop(9, 8)[0]] }, amoeba.curves[1]],
});

/** @param {[number, number]} a @param {[number, number]} b */
const apart = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

test("a selection adds and drops points, and never turns into the whole curve", () => {
  assert.ok(isWhole(whole(0)) && !isWhole(null) && !isWhole(only(0, 3)));
  assert.deepEqual(several(1, [4, 2, 4]).points, [2, 4]);
  assert.deepEqual(toggle(only(0, 3), 0, 1), { curve: 0, points: [1, 3] });
  assert.deepEqual(toggle(several(0, [1, 3]), 0, 1), only(0, 3));
  assert.deepEqual(toggle(only(0, 3), 0, 3), only(0, 3));
  assert.deepEqual(toggle(only(0, 3), 1, 2), only(1, 2));
  assert.deepEqual(toggle(whole(0), 0, 2), only(0, 2));
  assert.equal(singlePoint(several(0, [1, 2])), null);
  assert.ok(includes(several(0, [1, 2]), 0, 2) && !includes(several(0, [1, 2]), 1, 2));
});

test("a selection follows the document it is in", () => {
  assert.equal(within(only(1, 2), { ...amoeba, curves: [] }), null);
  assert.deepEqual(within(only(1, 2), { ...amoeba, curves: amoeba.curves.slice(0, 1) }), whole(0));
  const count = handleCount(amoeba.curves[0]);
  assert.deepEqual(within(several(0, [2, count + 3]), amoeba), only(0, 2));
  assert.deepEqual(within(only(0, count + 3), amoeba), only(0, count - 1));
  assert.equal(allPoints(clamped, 0).points.length, clamped.curves[0].points.length - 1);
});

test("points are removed together, or not at all where too few would be left", () => {
  const count = handleCount(amoeba.curves[0]);
  const fewer = removePoints(amoeba, 0, [1, 4, 5]);
  assert.deepEqual(fewer.curves[0].points, amoeba.curves[0].points.filter((/** @type {unknown} */ _, /** @type {number} */ i) => ![1, 4, 5].includes(i)));
  assert.equal(canRemovePoints(amoeba.curves[0], count - 4), true);
  assert.equal(canRemovePoints(amoeba.curves[0], count - 3), false);
  assert.equal(removePoints(amoeba, 0, [...Array(count - 3).keys()]), amoeba);
  const open = removePoints(clamped, 0, [0, 3]).curves[0];
  assert.deepEqual(open.points[0], open.points.at(-1));
  assert.doesNotThrow(() => dx.defaults(removePoints(clamped, 0, [0, 3])));
});

test("moving the first point of a clamped curve takes its last along", () => {
  const moved = movePoints(clamped, 0, [0, 2], [1, -2]).curves[0];
  assert.deepEqual(moved.points[0], moved.points.at(-1));
  const [x, y] = clamped.curves[0].points[2];
  assert.ok(apart(moved.points[2], [x + 1, y - 2]) < 1e-10);
  assert.equal(movePoints(amoeba, 0, [1, 2], [0, 0]), amoeba);
});

test("a curve through points passes every one of them, at its knots, for even and odd numbers of points", () => {
  for (const count of [3, 4, 5, 6, 7, 8, 13, 60]) {
    const given = loop(count, 20).map(([x, y], i) => /** @type {[number, number]} */ ([x * (1 + (i % 3) / 40), y * (1 - (i % 2) / 50)]));
    const shape = curveThrough(given);
    assert.ok(shape?.knots);
    assert.equal(shape.knots.length, shape.points.length + 1);
    assert.ok(shape.knots.every((knot, i, all) => i === 0 || knot > all[i - 1]));
    const at = shape.knots.slice(0, -1).map((u) => deBoorAt(/** @type {any} */ (shape), u));
    for (const point of given) assert.ok(Math.min(...at.map((each) => apart(each, point))) < 1e-10, `${count}: ${point}`);
    const document = { ...amoeba, curves: [{ ...shape }] };
    assert.deepEqual(dx.match(/** @type {any} */ (document)).diagnostics.map(({ code }) => code), ["incomplete"]);
  }
});

test("the curve through points keeps to them: a circle, converging with their number", () => {
  const error = (/** @type {number} */ count) => {
    const shape = /** @type {any} */ (curveThrough(loop(count, 10)));
    const steps = [...Array(400).keys()].map((k) => deBoorAt(shape, k / 400));
    return Math.max(...steps.map(([x, y]) => Math.abs(Math.hypot(x, y) - 10)));
  };
  const [coarse, fine] = [error(8), error(16)];
  // A cubic interpolant is of fourth order.
  assert.ok(coarse / fine > 12 && coarse / fine < 20, `${coarse} ${fine}`);
  assert.ok(error(3) < 0.1, "three points give about their circle");
});

test("points that cannot carry a closed curve are refused", () => {
  assert.equal(curveThrough([]), null);
  assert.equal(curveThrough([[0, 0], [1, 0]]), null);
  assert.equal(curveThrough([[0, 0], [1, 0], [2, 0]]), null);
  assert.equal(curveThrough([[0, 0], [0, 0], [1, 0], [1, 0]]), null);
});

test("the cyclic solver agrees with the equations it solves", () => {
  const rows = [...Array(9).keys()].map((i) => /** @type {[number, number, number]} */ ([0.3 + i / 50, 2 + i / 10, 0.4]));
  const right = rows.map((_, i) => Math.sin(3 * i));
  const x = solveCyclic(rows, right);
  rows.forEach(([low, middle, high], i) => {
    const left = low * x[(i + 8) % 9] + middle * x[i] + high * x[(i + 1) % 9];
    assert.ok(Math.abs(left - right[i]) < 1e-12);
  });
});

test("a drawn curve comes beside the first or in place of the chosen one, whose composition it keeps", () => {
  const shape = /** @type {any} */ (curveThrough(loop(6, 5)));
  const empty = { ...amoeba, curves: [] };
  assert.deepEqual(placeForCurve(empty, 1), { index: 0, replaces: false });
  const one = putShape(empty, 0, shape);
  assert.deepEqual(placeForCurve(one, 0), { index: 1, replaces: false });
  assert.deepEqual(one.curves[0].composition, [{ at: 0, mix: [1, 0, 0] }]);
  assert.deepEqual(putShape(one, 1, shape).curves[1].composition, [{ at: 0, mix: [0, 1, 0] }]);
  assert.deepEqual(placeForCurve(amoeba, 1), { index: 1, replaces: true });
  const replaced = putShape(amoeba, 1, shape);
  assert.equal(replaced.curves[1].composition, amoeba.curves[1].composition);
  assert.equal(replaced.curves[1].points, shape.points);
  assert.equal(replaced.curves[0], amoeba.curves[0]);
  dx.defaults(/** @type {any} */ (replaced));
});

test("swapping twice gives the document back, and sample counts go with their curves", () => {
  const document = { ...amoeba, sampling: { ...amoeba.sampling, counts: [30, 50] } };
  const swapped = swapCurves(document);
  assert.deepEqual(swapped.curves, [document.curves[1], document.curves[0]]);
  assert.deepEqual(swapped.sampling.counts, [50, 30]);
  assert.deepEqual(swapCurves(swapped), document);
  const [forth, back] = [dx.match(/** @type {any} */ (document)), dx.match(/** @type {any} */ (swapped))];
  assert.equal(forth.ok && back.ok, true);
  assert.deepEqual(deleteCurve(document, 0).sampling.counts, [50, 30]);
  assert.deepEqual(deleteCurve(deleteCurve(document, 1), 0).curves, []);
});

test("a reversed curve runs through the same places backwards, with the same composition there", () => {
  for (const document of [amoeba, star, pocket, clamped, { ...amoeba, curves: [curveWithKnots(), amoeba.curves[1]] }]) {
    for (const index of [0, 1]) {
      const curve = document.curves[index];
      const turned = reverseCurve(document, index).curves[index];
      for (let k = 0; k <= 40; k += 1) {
        const t = k / 40;
        assert.ok(apart(deBoorAt(curve, t), deBoorAt(turned, 1 - t)) < 1e-9, `${index} at ${t}`);
      }
      assert.ok(Math.abs(polygonArea(curve.points) + polygonArea(turned.points)) < 1e-9);
      for (let i = 0; i < handleCount(curve); i += 1) {
        assert.deepEqual(turned.points[reversedPoint(curve, i)], curve.points[i]);
        assert.equal(reversedPoint(turned, reversedPoint(curve, i)), i);
      }
      const at = turned.composition.map((/** @type {any} */ key) => key.at);
      const mirrored = curve.composition.map((/** @type {any} */ key) => (key.at === 0 ? 0 : 1 - key.at)).sort();
      at.forEach((/** @type {number} */ a, /** @type {number} */ k) => assert.ok(Math.abs(a - mirrored[k]) < 1e-12));
      const back = reverseCurve(reverseCurve(document, index), index).curves[index];
      assert.deepEqual(back.points, curve.points);
    }
  }
  const turned = reverseCurve(amoeba, 1);
  assert.deepEqual(dx.match(/** @type {any} */ (turned)).reversed, [false, true]);
  const match = dx.match(amoeba);
  const [from, to] = [match.samples[0].points[match.lines[9].from], match.samples[1].points[match.lines[9].to]];
  const middle = /** @type {[number, number]} */ ([(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]);
  const [before, after] = [dx.probe(amoeba, middle), dx.probe(/** @type {any} */ (turned), middle)];
  assert.ok(before && after);
  before.fractions.forEach((f, i) => assert.ok(Math.abs(f - after.fractions[i]) < 0.05, `${before.fractions} ${after.fractions}`));
});

test("a duplicate nests with its original, even of a curve that folds back on itself", () => {
  for (const [document, index] of /** @type {const} */ ([
    [amoeba, 0],
    [amoeba, 1],
    [star, 0],
    [pocket, 0],
  ])) {
    const alone = { ...document, curves: [document.curves[index]] };
    const pair = duplicateCurve(alone, 0);
    assert.equal(pair.curves.length, 2);
    const match = dx.match(/** @type {any} */ (pair));
    const codes = match.diagnostics.map(({ code }) => code);
    assert.ok(!codes.includes("disjoint") && !codes.includes("crossing"), `${document.title}: ${codes}`);
  }
  // With two curves the copy takes the other's side: outside of the inner one, inside of the outer one.
  for (const index of /** @type {const} */ ([0, 1])) {
    const copied = duplicateCurve(amoeba, index);
    assert.equal(copied.curves[index], amoeba.curves[index]);
    assert.equal(copied.curves[1 - index].composition, amoeba.curves[1 - index].composition);
    const [a, b] = copied.curves.map((curve) => Math.abs(polygonArea(curve.points)));
    assert.ok(a < b);
    assert.equal(dx.match(/** @type {any} */ (copied)).totals.lines?.crossings, 0);
  }
});

test("a doubled point keeps the document valid and draws the curve to it", () => {
  for (const document of [amoeba, clamped, { ...amoeba, curves: [curveWithKnots(), amoeba.curves[1]] }]) {
    const count = handleCount(document.curves[0]);
    for (let i = 0; i < count; i += 1) {
      const next = duplicatePoint(document, 0, i);
      assert.equal(handleCount(next.curves[0]), count + 1);
      dx.defaults(/** @type {any} */ (next));
      const near = (/** @type {any} */ curve) =>
        Math.min(...[...Array(200).keys()].map((k) => apart(deBoorAt(curve, k / 200), document.curves[0].points[i])));
      assert.ok(near(next.curves[0]) < near(document.curves[0]) + 1e-9);
    }
  }
});

test("the degree changes within what the points allow", () => {
  assert.equal(setDegree(amoeba, 0, 5).curves[0].degree, 5);
  assert.equal(setDegree(amoeba, 0, amoeba.curves[0].points.length), amoeba);
  assert.equal(setDegree(amoeba, 0, 1), amoeba);
  dx.defaults(/** @type {any} */ (setDegree(clamped, 0, 5)));
  dx.defaults(/** @type {any} */ (setDegree({ ...amoeba, curves: [curveWithKnots(), amoeba.curves[1]] }, 0, 2)));
});

test("turning and scaling keep what they must", () => {
  const all = allPoints(amoeba, 0).points;
  const turned = turnPoints(amoeba, 0, all, [3, -2], 90).curves[0].points;
  turned.forEach(([x, y], i) => {
    const [px, py] = amoeba.curves[0].points[i];
    assert.ok(apart([x, y], [3 - (py + 2), -2 + (px - 3)]) < 1e-9);
  });
  const round = [...Array(24).keys()].reduce((document) => turnPoints(document, 0, all, [1, 1], 15), amoeba);
  round.curves[0].points.forEach((/** @type {any} */ point, /** @type {number} */ i) =>
    assert.ok(apart(point, amoeba.curves[0].points[i]) < 1e-8),
  );
  const scaled = scalePoints(amoeba, 0, all, [1, 2], [2, 0.5]).curves[0];
  assert.ok(Math.abs(polygonArea(scaled.points) - polygonArea(amoeba.curves[0].points)) < 1e-8);
  assert.equal(turnPoints(amoeba, 0, all, [0, 0], 0), amoeba);
});

test("points align with an edge of their box and spread evenly", () => {
  const three = [1, 4, 7];
  const of = (/** @type {any} */ document) => three.map((i) => document.curves[0].points[i]);
  const [xs, ys] = [of(amoeba).map(([x]) => x), of(amoeba).map(([, y]) => y)];
  for (const [how, axis, value] of /** @type {const} */ ([
    ["left", 0, Math.min(...xs)],
    ["right", 0, Math.max(...xs)],
    ["center", 0, (Math.min(...xs) + Math.max(...xs)) / 2],
    ["top", 1, Math.max(...ys)],
    ["bottom", 1, Math.min(...ys)],
    ["middle", 1, (Math.min(...ys) + Math.max(...ys)) / 2],
  ])) {
    const points = of(alignPoints(amoeba, 0, three, how));
    for (const [k, point] of points.entries()) {
      assert.ok(Math.abs(point[axis] - value) < 1e-9, how);
      assert.equal(point[1 - axis], of(amoeba)[k][1 - axis]);
    }
  }
  const spread = of(alignPoints(amoeba, 0, three, "across")).map(([x]) => x).sort((a, b) => a - b);
  assert.ok(Math.abs(spread[1] - spread[0] - (spread[2] - spread[1])) < 1e-9);
  assert.deepEqual([spread[0], spread[2]], [Math.min(...xs), Math.max(...xs)]);
  assert.equal(alignPoints(amoeba, 0, [2], "left"), amoeba);
});

test("the snapping step is that of the drawn grid, and snapped places lie on it", () => {
  for (let scale = 1e-7; scale < 1e7; scale *= 1.37) {
    const step = gridStep(scale);
    assert.ok(step * scale >= 48 - 1e-9 && step * scale <= 120 + 1e-9, `${scale}`);
    const lead = step / 10 ** Math.floor(Math.log10(step) + 1e-9);
    assert.ok([1, 2, 5].some((each) => Math.abs(each - lead) < 1e-9), `${step}`);
    const [x, y] = snappedTo([3.3 * step, -7.6 * step], step);
    assert.ok(Math.abs(x - 3 * step) < 1e-9 * step && Math.abs(y + 8 * step) < 1e-9 * step);
  }
  assert.deepEqual(snappedTo([0.29999, -0.04], 0.1), [0.3, 0]);
  assert.ok(Object.is(snappedTo([0, -0.04], 0.1)[1], 0));
});

/** A curve whose knots are its own. @returns {any} */
function curveWithKnots() {
  return {
    ...amoeba.curves[0],
    points: loop(7, 9),
    knots: [0, 0.1, 0.25, 0.5, 0.55, 0.7, 0.9, 1],
  };
}
