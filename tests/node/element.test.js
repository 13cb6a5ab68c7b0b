/** The parts of the element that need no page: import without one, its arithmetic, its words, and the messages of the page for iframes. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "directrix";
import { DirectrixFigure } from "directrix/element";
import { arrowStep, fitting, toPlane, toScreen } from "../../js/element/plane.js";
import { summary } from "../../js/element/result.js";
import { presetAddress } from "../../js/element/source.js";
import { readMessage } from "../../www/src/embed/protocol.js";
import { base } from "./hostile.js";

test("generators of sites may import the element without a page", () => {
  assert.equal(typeof DirectrixFigure, "function");
  assert.match(String(DirectrixFigure.presets), /\/js\/presets\/$/);
});

test("a view shows all points inside its margin, and places go there and back", () => {
  const size = { width: 640, height: 360 };
  /** @type {[number, number][]} */
  const points = [[-3, 2], [7, 2], [1, -8.5], [4, 11]];
  const view = fitting(points, size, 20);
  const places = points.map((at) => toScreen(view, size, at));
  for (const [x, y] of places) assert.ok(x >= 20 && x <= 620 && y >= 20 && y <= 340, `${x} ${y}`);
  const ys = places.map(([, y]) => y);
  assert.ok(Math.abs(Math.min(...ys) - 20) < 1e-9 && Math.abs(Math.max(...ys) - 340) < 1e-9, "as large as can be");
  points.forEach((at, i) => {
    const [x, y] = toPlane(view, size, places[i]);
    assert.ok(Math.hypot(x - at[0], y - at[1]) * view.scale < 0.2);
  });
  assert.ok(fitting([[1e12, 1e12]], size, 20).scale > 0, "one point has a view as well");
  assert.equal(arrowStep(base), 1);
});

test("the result is stated in words that agree with the numbers", async () => {
  const dx = await load({ module: "figure" });
  const match = dx.match(base);
  const found = summary(match, base);
  const totals = match.totals.pairs ?? match.totals.lines;
  assert.ok(totals && found.verified && found.lines === totals.count);
  assert.match(found.text, new RegExp(`^${totals.count} lines, none crossing, η ${totals.eta?.toFixed(2)}`));
  const alone = { ...base, curves: base.curves.slice(0, 1) };
  assert.equal(summary(dx.match(alone), alone).text, "Unfinished: a figure needs two curves");
  const worse = structuredClone(match);
  const lines = worse.totals.lines;
  assert.ok(lines);
  Object.assign(lines, { crossings: 2, blocked: 1, uncovered: [[3], []] });
  worse.totals.pairs = null;
  assert.match(summary({ ...worse, ok: false }, base).text, /, 2 crossing, 1 through a curve, 1 sample without a line, /);
});

test("a preset is named by a word, not by a path", () => {
  assert.equal(presetAddress("drop-in-leaf", "https://a.example/p/").href, "https://a.example/p/drop-in-leaf.json");
  for (const name of ["", "../x", "a/b", "A", "a.json", "//b.example/x", "-a"]) {
    assert.throws(() => presetAddress(name, "https://a.example/p/"), { code: "range", path: "preset" });
  }
});

test("what is no message to a figure is let pass, and a faulty one is answered by its field", () => {
  for (const other of [undefined, null, 1, "x", [], {}, { type: "other" }, { type: ["directrix:set"], v: 1 }]) assert.equal(readMessage(other), null);
  assert.deepEqual(readMessage({ type: "directrix:set", v: 1 }), { wish: {} });
  assert.deepEqual(readMessage({ type: "directrix:set", v: 1, s: 0, playing: false }), { wish: { s: 0, playing: false } });
  /** @param {object} fields */
  const fault = (fields) => /** @type {any} */ (readMessage({ type: "directrix:set", v: 1, ...fields })).error;
  assert.equal(fault({ v: "1" }).path, "v");
  assert.equal(fault({ s: NaN }).path, "s");
  assert.equal(fault({ s: -0.1 }).message, "-0.1 was found; expected a number from 0 to 1");
  assert.equal(fault({ document: [] }).path, "document");
  assert.equal(fault({ preset: "a", document: "{}" }).path, "preset");
  assert.equal(fault({ alt: "x".repeat(2000) }).message.length < 120, true);
  assert.equal(fault({ constructor: 1 }).code, "unknown-field");
  assert.equal(fault(JSON.parse('{"__proto__": 1}')).code, "unknown-field");
  assert.equal(fault({ ["y".repeat(500)]: 1 }).path.length, 41);
});
