/** Harmonic blends on the page, as pure functions: room for another curve, names, looks, places of names, and tables. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { load } from "directrix";
import { gradientCsv, levelsCsv } from "../../www/src/files/csv.js";
import { outermost, roomIn, withCurveInside } from "../../www/src/harmonic/edits.js";
import { levelPlaces } from "../../www/src/harmonic/labels.js";
import { curveName } from "../../www/src/state/app.js";
import { placeForCurve, putShape } from "../../www/src/state/curve-edits.js";
import { hasLooks, lookedAt, withBlend } from "../../www/src/state/look.js";

const dx = await load();

/** @param {string} name @returns {any} */
const preset = (name) => {
  const { view: _, ...document } = dx.defaults(JSON.parse(readFileSync(new URL(`../../www/presets/${name}.json`, import.meta.url), "utf8")));
  return document;
};

/** @param {number} x @param {number} y @param {number} radius @returns {any} */
function circle(x, y, radius) {
  const count = 32;
  const step = (2 * Math.PI) / count;
  const control = (radius * 3) / (2 + Math.cos(step));
  const points = Array.from({ length: count }, (_, k) => [x + control * Math.cos(k * step), y + control * Math.sin(k * step)]);
  return { degree: 3, form: "periodic", points, height: 0, composition: [{ at: 0, mix: [1, 0] }] };
}

test("room is looked for between the curves: the largest free circle", () => {
  const outer = circle(0, 0, 10);
  const alone = roomIn([outer]);
  assert.ok(alone && Math.hypot(...alone.center) < 0.1 && Math.abs(alone.radius - 10) < 0.1);
  // Beside a circle of radius 4 in the middle the largest circle has the radius 3; beside one at the edge the free one touches it and the outer one.
  const beside = roomIn([circle(0, 0, 4), outer]);
  assert.ok(beside && Math.abs(beside.radius - 3) < 0.05 && Math.abs(Math.hypot(...beside.center) - 7) < 0.05);
  const opposite = roomIn([outer, circle(-6, 0, 4)]);
  assert.ok(opposite && Math.abs(opposite.radius - 6) < 0.05 && Math.abs(opposite.center[0] - 4) < 0.2);
  assert.equal(outermost([circle(0, 0, 1), outer, circle(3, 0, 2)]), 1);
  assert.equal(roomIn([]), null);
});

test("curves that come in leave a harmonic blend, and are as many as fit", () => {
  let document = preset("three-cores");
  for (const copied of [undefined, 1, 0, undefined]) {
    const next = withCurveInside(document, copied === undefined ? undefined : document.curves[copied]);
    assert.ok(next);
    assert.equal(next.curves.length, document.curves.length + 1);
    assert.equal(next.sampling.counts.length, next.curves.length);
    assert.deepEqual(next.curves.slice(0, -1), document.curves);
    const { ok, harmonic, diagnostics } = dx.match(/** @type {any} */ (next), { coarse: true });
    assert.ok(ok, JSON.stringify(diagnostics));
    assert.deepEqual([harmonic?.outer, harmonic?.crossings], [0, 0]);
    document = next;
  }
  assert.deepEqual(document.curves[5].composition, document.curves[1].composition, "a copy has the composition of its curve");
});

test("a curve that is drawn comes inside, with a number of samples of its own", () => {
  const document = preset("three-cores");
  assert.deepEqual(placeForCurve(document, 2), { index: 4, replaces: false });
  const { degree, form, points } = circle(30, -25, 4);
  const next = putShape(document, 4, { degree, form, points });
  assert.deepEqual([next.curves.length, next.sampling.counts.length], [5, 5]);
  assert.deepEqual(dx.defaults(/** @type {any} */ (next)).curves.length, 5);
});

test("names say which curve is the outer one, wherever it stands in the list", () => {
  const document = { ...preset("three-cores") };
  document.curves = document.curves.toReversed().map((/** @type {any} */ { name: _, ...curve }) => curve);
  assert.deepEqual([0, 1, 2, 3].map((k) => curveName(document, k)), ["Inner A", "Inner B", "Inner C", "Outer"]);
  const ruled = withBlend(document, "ruled");
  assert.equal(curveName(ruled, 0), "Curve A");
});

test("a look is the other blend of the same curves, and changes nothing", () => {
  const document = preset("warm-band");
  const app = (/** @type {any} */ look, mode = "figure", own = document) => /** @type {any} */ ({ store: { document: own }, ui: { value: { look, mode } } });
  assert.equal(lookedAt(app(null)), document);
  assert.equal(lookedAt(app("harmonic")), document);
  const ruled = lookedAt(app("ruled"));
  assert.equal(ruled.blend.kind, "ruled");
  assert.equal(lookedAt(app("ruled")), ruled, "the same object, so that nothing is computed twice");
  assert.equal(lookedAt(app("ruled", "compare")), document);
  assert.equal(dx.match(ruled).ok, true);
  const plain = { ...ruled, blend: { kind: "ruled", stages: 5 } };
  assert.deepEqual(lookedAt(app("harmonic", "figure", plain)).blend, { lines: 44, segments: 200, kind: "harmonic", stages: 5 });
  assert.equal(hasLooks(preset("three-cores")), false);
  assert.equal(lookedAt(app("ruled", "figure", preset("three-cores"))).blend.kind, "harmonic");
});

test("names of levels stand on their levels, in order along one line", () => {
  const document = preset("warm-band");
  const places = levelPlaces(dx.harmonic(document), ([x, y]) => [x, -y], () => true);
  assert.deepEqual(places.map(({ s }) => s), [0.2, 0.4, 0.6, 0.8]);
  for (const { s, at } of places) assert.ok(Math.abs(Number(dx.probe(document, [at[0], -at[1]])?.s) - s) < 5e-3);
  assert.deepEqual(levelPlaces(dx.harmonic(document), (at) => at, () => false), []);
});

test("tables hold every point of the lines and of the level curves", () => {
  const found = dx.harmonic(preset("three-cores"), { coarse: true });
  const rows = (/** @type {string} */ csv) => csv.trimEnd().split("\n").map((row) => row.split(","));
  const [head, ...lines] = rows(gradientCsv(found));
  assert.deepEqual(head, ["line", "curve", "u", "v", "x", "y"]);
  assert.equal(lines.length, found.lines.reduce((sum, flat) => sum + flat.length / 2, 0));
  assert.deepEqual(lines[0].slice(4).map(Number), [...found.lines[0].subarray(0, 2)]);
  const [columns, ...levels] = rows(levelsCsv(found));
  assert.deepEqual(columns, ["stage", "s", "loop", "x", "y"]);
  assert.equal(levels.length, found.levels.flatMap(({ loops }) => loops).reduce((sum, flat) => sum + flat.length / 2, 0));
  assert.equal(levels.filter(([stage]) => stage === "1").at(-1)?.[2], String(found.levels[0].loops.length - 1));
});
