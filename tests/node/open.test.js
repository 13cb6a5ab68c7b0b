/** Open curves through the package and through the pure functions of the page. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { DirectrixError, load } from "directrix";
import { outline } from "../../www/src/spline.js";
import { afterKey, insertKey, mixAt, slideKey, wrapped } from "../../www/src/state/composition.js";
import { duplicateCurve, duplicatePoint, reverseCurve, reversedPoint, setDegree } from "../../www/src/state/curve-edits.js";
import { removePoints } from "../../www/src/state/edits.js";
import { joined, sideOf } from "../../www/src/state/open.js";
import { openCurveThrough } from "../../www/src/state/through-open.js";

/** @import { CurvesDocument, Point } from "../../www/src/types.js" */

const dx = await load({ module: "full" });
const text = await readFile(new URL("../../www/presets/graded-strip.json", import.meta.url), "utf8");
const strip = /** @type {CurvesDocument} */ (dx.defaults(text));

test("a strip is matched end to end, and nothing of it closes", () => {
  const match = dx.match(strip);
  assert.ok(match.ok);
  assert.deepEqual(match.reversed, [false, true], "drawn against each other");
  const { pairs } = match.totals;
  assert.ok(pairs && pairs.crossings === 0 && pairs.blocked === 0 && Number(pairs.eta) > 0.9);
  assert.ok(match.gapKind === "refined" || match.gapKind === "supremum", `${match.gapKind}`);
  const [first, last] = [match.pairs[0], match.pairs[match.pairs.length - 1]];
  assert.deepEqual([first.from, last.from], [strip.curves[0].points[0], strip.curves[0].points.at(-1)]);
  assert.deepEqual([first.to, last.to], [strip.curves[1].points.at(-1), strip.curves[1].points[0]]);
  const stages = dx.stages(strip);
  assert.equal(stages[0].points.length, match.pairs.length);
  assert.equal(dx.cells(strip).length, (match.pairs.length - 1) * strip.blend.stages);
  assert.ok(dx.isolines(strip, { material: 0, levels: [0.5] })[0].closed.every((closed) => !closed));
  assert.equal(dx.probe(strip, [0, 60]), null);
  const svg = dx.svg(strip, { width: 400, height: 300, layers: ["inBetweens"] });
  const curves = /<g id="layer-curves">([\s\S]*?)<\/g>/.exec(svg)?.[1] ?? "";
  assert.ok(curves.length > 0 && !/z["M]/.test(curves), "outlines do not return to their start");
  assert.deepEqual(dx.defaults(JSON.stringify(strip)), strip);
  assert.equal(strip.matching.ends, "tied");
});

test("free ends, other methods and the steps of the growth take open curves", () => {
  for (const ends of /** @type {const} */ (["tied", "free"])) {
    for (const method of /** @type {const} */ (["exact", "greedy", "parameter", "shift", "one-per-vertex"])) {
      const { lines: _, ...rest } = strip.matching;
      const match = dx.match({ ...strip, matching: { ...rest, method, ends } });
      assert.ok(match.ok, `${method} ${ends}: ${match.diagnostics.map(({ message }) => message)}`);
    }
  }
  const steps = dx.steps(strip);
  assert.deepEqual(steps.growth.slice(0, 2).map(({ from, to }) => [from, to]), [[0, 0], [59, 59]], "the ends come first");
  const sets = dx.sets(strip, { step: 2, curve: 0, vertex: 30 });
  assert.equal(sets.valid.length, 60);
});

test("a mixture of forms and a shift without a seam are refused by the field", () => {
  const refusal = (/** @type {any} */ document, /** @type {string} */ path) =>
    assert.throws(() => dx.match(document), (error) => error instanceof DirectrixError && error.code === "range" && error.path === path);
  const ring = { ...strip.curves[1], form: "periodic" };
  refusal({ ...strip, curves: [strip.curves[0], ring] }, "curves[1].form");
  refusal({ ...strip, matching: { ...strip.matching, method: "shift", shift: 3 } }, "matching.shift");
});

test("edits keep open curves valid and what they mean", () => {
  const valid = (/** @type {CurvesDocument} */ document) => dx.match(/** @type {any} */ (document));
  const inserted = /** @type {CurvesDocument} */ (dx.insertPoint(strip, 0, 0.4));
  assert.equal(inserted.curves[0].points.length, strip.curves[0].points.length + 1);
  const shape = (/** @type {CurvesDocument} */ document) => outline(document.curves[0], 60).map(({ at }) => at);
  const near = (/** @type {Point} */ at, /** @type {Point[]} */ chain) => Math.min(...chain.map(([x, y]) => Math.hypot(x - at[0], y - at[1])));
  for (const at of shape(inserted)) assert.ok(near(at, shape(strip)) < 0.5);
  for (const document of [
    duplicatePoint(inserted, 0, 3),
    removePoints(inserted, 0, [2]),
    removePoints(strip, 0, [0]),
    setDegree(strip, 0, 2),
    reverseCurve(inserted, 0),
    duplicateCurve(strip, 0),
  ]) {
    assert.ok(valid(document).samples[0].points.length > 0);
  }
  const reversed = reverseCurve(strip, 0);
  assert.deepEqual(reversed.curves[0].points, [...strip.curves[0].points].reverse());
  assert.equal(reversedPoint(strip.curves[0], 0), strip.curves[0].points.length - 1);
  assert.deepEqual(reversed.curves[0].composition.map(({ at }) => at), [0, 0.5, 1]);
  assert.deepEqual(reverseCurve(reversed, 0), strip);
  const [a, b] = [dx.match(strip), dx.match(/** @type {any} */ (reversed))];
  assert.ok(Math.abs(Number(a.totals.pairs?.integral) / Number(b.totals.pairs?.integral) - 1) < 1e-6);
  const beside = duplicateCurve({ ...strip, curves: [strip.curves[0]] }, 0);
  assert.ok(dx.match(/** @type {any} */ (beside)).ok, "a copy beside the curve faces it");
});

test("keys of an open curve stop at its ends", () => {
  const keys = strip.curves[1].composition;
  assert.deepEqual(mixAt(keys, 1, true), keys[2].mix);
  const [first] = keys;
  assert.deepEqual(mixAt(keys.slice(1), 0.1, true), keys[1].mix, "constant before the first");
  assert.deepEqual(mixAt([first, keys[1]], 0.9, true), keys[1].mix, "and after the last");
  assert.deepEqual([wrapped(1.2, true), wrapped(-0.1, true), wrapped(1, true)], [1, 0, 1]);
  const at = (/** @type {CurvesDocument} */ document) => document.curves[1].composition.map((key) => key.at);
  assert.deepEqual(at(slideKey(strip, 1, 2, -0.2)), [0, 0.45, 0.8]);
  assert.equal(slideKey(strip, 1, 0, -0.2), strip, "no way round");
  assert.deepEqual(at(insertKey(strip, 1, afterKey(keys, 2, true))), [0, 0.45, 0.725, 1]);
  // The kernel takes them.
  assert.ok(dx.match(/** @type {any} */ (insertKey(strip, 1, 0.2))).ok);
});

test("an open curve passes the points it is drawn through", () => {
  const given = /** @type {Point[]} */ ([[0, 0], [3, 1], [4, 5], [9, 4], [9, 4], [10, 0], [16, 2]]);
  for (const count of [2, 3, 4, 7]) {
    const shape = /** @type {import("../../www/src/types.js").Shape} */ (openCurveThrough(given.slice(0, count)));
    const chain = outline(shape, 1200).map(({ at }) => at);
    for (const [x, y] of given.slice(0, count)) {
      assert.ok(Math.min(...chain.map((at) => Math.hypot(at[0] - x, at[1] - y))) < 1e-9);
    }
    // Natural: it does not bend at its ends.
    const bend = (/** @type {number} */ i) =>
      Math.hypot(...[0, 1].map((axis) => chain[i - 1][axis] - 2 * chain[i][axis] + chain[i + 1][axis]));
    const most = Math.max(...chain.slice(1, -1).map((_, i) => bend(i + 1)));
    assert.ok(bend(1) <= most / 100 + 1e-12 && bend(chain.length - 2) <= most / 100 + 1e-12);
    const document = { directrix: 1, kind: "curves", matching: { method: "exact" }, curves: [shape] };
    assert.deepEqual(dx.match(/** @type {any} */ (document)).diagnostics.map(({ code }) => code), ["incomplete"]);
  }
  assert.equal(openCurveThrough([[1, 1]]), null);
  assert.equal(openCurveThrough([[1, 1], [1, 1]]), null);
});

test("the page knows what lies between two open curves", () => {
  const chains = strip.curves.map((curve) => outline(curve).map(({ at }) => at));
  const ring = joined(chains[0], chains[1]);
  assert.equal(ring.length, chains[0].length + chains[1].length);
  const gap = (/** @type {Point} */ a, /** @type {Point} */ b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
  assert.ok(gap(ring[chains[0].length - 1], ring[chains[0].length]) < 40);
  // The lower edge runs to the right with the other one on its left; the upper one runs to the left.
  assert.deepEqual([sideOf(strip.curves, 0), sideOf(strip.curves, 1)], [-1, -1]);
});
