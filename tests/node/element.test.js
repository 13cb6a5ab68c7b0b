/** The parts of the element that need no page: import without one, its arithmetic, its words, and the messages of the page for iframes. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { describeBody, load } from "directrix";
import { DirectrixFigure } from "directrix/element";
import { Raster, projection } from "../../js/element/body/raster.js";
import { bodyResult } from "../../js/element/body/result.js";
import { arrowStep, fitting, toPlane, toScreen } from "../../js/element/plane.js";
import { summary } from "../../js/element/result.js";
import { presetAddress } from "../../js/element/source.js";
import { seenAt } from "../../www/src/space/camera.js";
import { labsOf } from "../../www/src/space/colors.js";
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

test("a body is verified only when every check has run, and its faults are counted", async () => {
  const dx = await load({ module: "full" });
  for (const [name, before, after] of /** @type {const} */ ([
    ["ring", "8 cells, being checked", "8 cells, verified"],
    ["invalid", "1 cell, invalid", "1 cell, invalid"],
    // No part of it is folded, so that certificates alone do not show it.
    ["crossing", "1 cell, being checked", "1 cell, invalid"],
  ])) {
    const document = await readFile(new URL(`../../www/presets/hyperpatch/${name}.json`, import.meta.url), "utf8");
    const body = dx.hyperpatch(document);
    const first = bodyResult(body.verdicts({ global: false }), body.volume(), null);
    assert.deepEqual([first.brief, first.verified, first.body?.checked], [before, false, false]);
    const last = bodyResult(body.verdicts(), body.volume(), body.summary());
    assert.deepEqual([last.brief, last.verified, last.body?.checked], [after, name === "ring", true]);
    assert.equal(last.text, describeBody(body.summary()));
  }
});

test("a raster shows the nearest of what it is given, to the colour and the depth", () => {
  const camera = { target: /** @type {[number, number, number]} */ ([0, 0, 0]), azimuth: -90, elevation: 0, distance: 10 };
  const frame = { size: { width: 40, height: 30 }, top: 0, bottom: 0 };
  // Squares across the view at y = 0 and, in another colour and half as large, before it at y = -2; x runs to the right, z up.
  const square = (/** @type {number} */ y, /** @type {number} */ half) => Float32Array.from([-half, y, -half, half, y, -half, half, y, half, -half, y, half]);
  const of = (/** @type {number[]} */ bytes) => labsOf(Uint8Array.from([0, 1, 2, 3].flatMap(() => bytes)));
  const indices = Uint32Array.from([0, 1, 2, 0, 2, 3]);
  const [far, near] = [[0, 114, 178, 255], [240, 228, 66, 255]];
  for (const order of [0, 1]) {
    const raster = new Raster(80, 60);
    const seen = projection(camera, frame, 2);
    const meshes = [{ positions: square(0, 1), labs: of(far), indices }, { positions: square(-2, 0.5), labs: of(near), indices }];
    for (const mesh of order === 0 ? meshes : meshes.reverse()) raster.fill(mesh, seen);
    const at = (/** @type {[number, number, number]} */ point) => {
      const [x, y] = seenAt(camera, frame, point).at.map((each) => Math.floor(2 * each));
      const n = y * 80 + x;
      return { color: [...raster.pixels.slice(4 * n, 4 * n + 4)], depth: 1 / raster.nearness[n] };
    };
    const middle = at([0, 0, 0]);
    assert.ok(middle.color.every((byte, k) => Math.abs(byte - near[k]) <= 1), middle.color.join());
    assert.ok(Math.abs(middle.depth - 8) < 1e-4, "two before the target");
    const beside = at([0.9, 0, 0.9]);
    assert.ok(beside.color.every((byte, k) => Math.abs(byte - far[k]) <= 1), beside.color.join());
    assert.ok(Math.abs(beside.depth - 10) < 1e-4);
    assert.equal(raster.pixels[3], 0, "nothing there");
    const covered = raster.nearness.reduce((sum, each) => sum + Number(each > 0), 0);
    const side = 2 * (seenAt(camera, frame, [1, 0, 0]).at[0] - seenAt(camera, frame, [-1, 0, 0]).at[0]);
    assert.ok(Math.abs(Math.sqrt(covered) - side) < 1, `${covered} pixels, ${side} a side`);
    // A plane that keeps the right half of what is far.
    const half = new Raster(80, 60);
    half.fill({ positions: square(0, 1), labs: of(far), indices }, seen, { normal: [1, 0, 0], offset: 0 });
    const kept = half.nearness.reduce((sum, each) => sum + Number(each > 0), 0);
    assert.ok(Math.abs(kept / covered - 0.5) < 0.03, `${kept} of ${covered}`);
  }
});

test("a preset is named by a word, not by a path", () => {
  assert.equal(presetAddress("drop-in-leaf", "https://a.example/p/").href, "https://a.example/p/drop-in-leaf.json");
  assert.equal(presetAddress("hyperpatch-nearly-invalid", "https://a.example/p/").href, "https://a.example/p/hyperpatch/nearly-invalid.json");
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
