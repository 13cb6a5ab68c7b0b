/** Harmonic blends of nested curves: against closed forms, over the turns of a worker, beside the ruled blend, and what does not fit. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { describe, load } from "directrix";
import { inTurns } from "../../js/turns.js";
import { refusal } from "./refused.js";

const dx = await load();
const figure = await load({ module: "figure" });

/** @param {string} name */
const preset = (name) => JSON.parse(readFileSync(new URL(`../../www/presets/${name}.json`, import.meta.url), "utf8"));

/** A curve within a part in a hundred thousand of a circle. @param {number} x @param {number} y @param {number} radius */
function circle(x, y, radius) {
  const count = 64;
  const step = (2 * Math.PI) / count;
  const control = (radius * 3) / (2 + Math.cos(step));
  const points = Array.from({ length: count }, (_, k) => [x + control * Math.cos(k * step), y + control * Math.sin(k * step)]);
  return { degree: 3, form: "periodic", points };
}

/** @param {object[]} curves @param {object} [rest] @returns {any} */
const nested = (curves, rest) => ({ directrix: 1, kind: "curves", curves, matching: { method: "exact" }, blend: { kind: "harmonic" }, ...rest });

/** Distances of the points of a flat list from the origin. @param {Float64Array} flat */
const radii = (flat) => Array.from({ length: flat.length / 2 }, (_, k) => Math.hypot(flat[2 * k], flat[2 * k + 1]));

test("between concentric circles the potential is the logarithm of the radius, whatever the order of the curves", () => {
  for (const [outer, curves] of /** @type {[number, object[]][]} */ ([[1, [circle(0, 0, 1), circle(0, 0, 3)]], [0, [circle(0, 0, 3), circle(0, 0, 1)]]])) {
    const found = dx.harmonic(nested(curves));
    assert.deepEqual([found.ok, found.outer, found.segments, found.crossings, found.lost], [true, outer, 400, 0, 0]);
    assert.ok(found.residual < 1e-5 && found.iterations > 0 && found.fluxBalance < 1e-3);
    assert.ok(Math.abs((found.flux * Math.log(3)) / (2 * Math.PI) - 1) < 1e-3);
    assert.deepEqual(found.levels.map(({ value, loops }) => [value, loops.length]), [[0.2, 1], [0.4, 1], [0.6, 1], [0.8, 1]]);
    for (const { value, loops } of found.levels) assert.ok(radii(loops[0]).every((radius) => Math.abs(radius / 3 ** value - 1) < 1e-3));
    assert.equal(found.lines.length, 44);
    for (const [k, line] of found.lines.entries()) {
      const along = radii(line);
      assert.ok(along.every((radius, n) => n === 0 || radius > along[n - 1]), "outwards all the way");
      assert.ok(Math.abs(along[0] - 1) < 1e-4 && Math.abs(along[along.length - 1] - 3) < 1e-3);
      assert.equal(found.lineCurves[k], 1 - outer);
    }
    const place = dx.probe(nested(curves), [1.5, 0.8]);
    assert.ok(place?.gradient && Math.abs(place.s - Math.log(1.7) / Math.log(3)) < 5e-4);
    assert.ok(Math.abs(place.fractions[outer] - place.s) < 1e-9 && Math.abs(place.fractions[0] + place.fractions[1] - 1) < 1e-12);
    assert.ok(Math.abs(place.gradient[1] / place.gradient[0] - 0.8 / 1.5) < 2e-3);
    assert.equal(dx.probe(nested(curves), [0, 0]), null);
  }
});

test("several inner curves, pictures and words", () => {
  const document = preset("three-cores");
  const match = dx.match(document);
  assert.deepEqual([match.ok, match.lines, match.pairs, match.diagnostics], [true, [], [], []]);
  assert.equal(match.harmonic?.lines, document.blend.lines);
  assert.match(describe(match), /^Harmonic blend of 4 curves, 60 lines along the gradient, none crossing/);
  const found = dx.harmonic(document);
  assert.equal(found.levels.length, 7);
  assert.ok(found.levels[0].loops.length > 1, "near the cores a level is several loops");
  assert.deepEqual([...new Set(found.lineCurves)].toSorted(), [1, 2, 3]);
  const size = { width: 160, height: 160 };
  const picture = dx.paint(document, { ...size, layers: ["material"] });
  const scale = picture.view.scale;
  for (const [x, y, material] of [[-30, 19, null], [-12, 15, 1]]) {
    const [column, row] = [80 + (Number(x) - picture.view.center[0]) * scale, 80 - (Number(y) - picture.view.center[1]) * scale].map(Math.round);
    const place = dx.probe(document, [Number(x), Number(y)]);
    assert.equal(place === null, material === null, "inside a core there is nothing");
    const pixel = [...picture.data.subarray(4 * (row * 160 + column), 4 * (row * 160 + column) + 3)];
    assert.equal(pixel.join() === "255,255,255", material === null);
  }
  assert.match(dx.svg(document, size), /Harmonic blend of 4 curves/);
  const lines = dx.isolines(document, { material: 0, levels: [0.5] });
  assert.ok(lines[0].lines.length > 0 && lines[0].closed.every(Boolean));
  for (const [x, y] of lines[0].lines[0].slice(0, 20)) {
    assert.ok(Math.abs(Number(dx.probe(document, [x, y])?.fractions[0]) - 0.5) < 3e-3);
  }
});

test("the difference from the ruled blend of the same curves", async () => {
  const document = preset("warm-band");
  assert.equal(dx.harmonic(document).difference, null);
  const { difference, diagnostics } = dx.harmonic(document, { difference: true });
  assert.ok(difference && difference.largest > difference.mean && difference.mean > 0 && difference.largest < 1);
  assert.deepEqual(diagnostics, []);
  const ruled = dx.probe({ ...document, blend: { kind: "ruled" } }, difference.at);
  const own = dx.probe(document, difference.at);
  assert.ok(ruled && own);
  const apart = own.fractions.reduce((sum, fraction, k) => sum + Math.abs(fraction - ruled.fractions[k]) / 2, 0);
  assert.ok(Math.abs(apart - difference.largest) < 5e-3, `${apart}, ${difference.largest}`);
  // Where both compositions are the same all along the curves there is nothing between the blends.
  const mix = [{ at: 0, mix: [0.25, 0.75] }];
  const plain = nested([{ ...circle(0, 0, 1), composition: mix }, { ...circle(0.2, 0, 3), composition: mix }]);
  const none = dx.harmonic(plain, { difference: true }).difference;
  assert.ok(none && none.largest < 1e-6 && none.mean < 1e-6);
  const options = { width: 96, height: 96, layers: /** @type {any} */ (["difference"]) };
  const shown = dx.paint(document, options);
  assert.notDeepEqual(shown.data, dx.paint(document, { ...options, layers: ["material"] }).data);
  /** @type {number[]} */
  const shares = [];
  const renamed = { ...document, title: "In turns" };
  const turns = { isWanted: () => true, onprogress: (/** @type {number} */ share) => void shares.push(share) };
  assert.deepEqual((await inTurns(dx, { name: "paint", args: [renamed, options] }, turns))?.value.data, shown.data);
  const found = await inTurns(dx, { name: "harmonic", args: [{ ...document, title: "Again" }, { difference: true }] }, turns);
  assert.deepEqual(found?.value.difference, difference);
  assert.ok(shares.length > 2 && shares.every((share) => share >= 0 && share < 1));
  const open = dx.harmonic({ ...document, matching: { method: "greedy", normalWeight: 100, distanceWeight: 0 }, sampling: { counts: [3, 200] } }, { difference: true });
  assert.ok(open.ok, "the blend itself needs no matching");
});

test("coarse work is coarser, and a job goes in small steps", () => {
  const document = { ...preset("three-cores"), title: "Coarse" };
  const coarse = dx.harmonic(document, { coarse: true });
  const fine = dx.harmonic(document);
  assert.deepEqual([coarse.coarse, fine.coarse, coarse.segments, fine.segments], [true, false, 320, 800]);
  assert.ok(coarse.vertices < fine.vertices / 2);
  const job = dx.job({ ...document, title: "Steps" }, { paint: { width: 64, height: 64 } });
  let [steps, last] = [0, 0];
  let state = job.step(0);
  for (; !state.done; state = job.step(0)) {
    steps += 1;
    assert.ok(state.progress >= last - 1e-9, `${state.progress} after ${last}`);
    last = state.progress;
  }
  assert.ok(steps > 100 && state.picture, `${steps} steps`);
});

test("what does not fit is named with its curves and a place", () => {
  const told = (/** @type {object[]} */ curves) => {
    const { ok, outer, lines, diagnostics } = dx.harmonic(nested(curves));
    assert.deepEqual([ok, outer, lines], [false, null, []]);
    assert.equal(dx.match(nested(curves)).ok, false);
    const { code, curves: named, at } = diagnostics[diagnostics.length - 1];
    return { code, named, at: at?.map(Math.round) };
  };
  const big = circle(0, 0, 5);
  assert.deepEqual(told([circle(0, 0, 1), circle(3, 0, 1)]), { code: "no-outer", named: [0, 1], at: [4, 0] });
  assert.deepEqual(told([big, circle(0, 0, 3), circle(1, 0, 1)]), { code: "nested", named: [2, 1], at: [2, 0] });
  const meeting = told([big, circle(-1, 0, 1.5), circle(1, 0, 1.5)]);
  assert.deepEqual([meeting.code, meeting.named, meeting.at?.[0]], ["curves-meet", [1, 2], 0]);
  assert.equal(told([{ ...big, height: 4 }, circle(5, 0, 1)]).code, "curves-meet");
  const open = (/** @type {number} */ y) => ({ degree: 3, form: "open", points: [[0, y], [1, y], [2, y], [3, y]] });
  assert.deepEqual(told([open(0), open(1)]), { code: "open-curves", named: [0, 1], at: undefined });
  assert.equal(told([big]).code, "incomplete");
  const lifted = dx.harmonic(nested([{ ...circle(0, 0, 1), height: 7 }, big]));
  assert.deepEqual([lifted.ok, lifted.diagnostics.map(({ code, curves }) => [code, curves])], [true, [["heights-ignored", [0]]]]);
  // Of a stack whose curves lie side by side in one, the notice points here.
  const stack = dx.match(nested([circle(-2, 0, 1), circle(2, 0, 1), big], { blend: { kind: "ruled" } }));
  const notice = stack.diagnostics.find(({ code }) => code === "several-inner");
  assert.deepEqual([stack.ok, notice?.curves], [false, [0, 1]]);
  assert.match(String(notice?.message), /curves 0 and 1 lie side by side in curve 2.*`harmonic`/);
});

test("functions about ruling lines refuse it, and the small module leaves it to the whole one", () => {
  const document = nested([circle(0, 0, 1), circle(0, 0, 3)]);
  const expected = { code: "range", path: "blend.kind" };
  for (const call of [() => dx.steps(document), () => dx.sets(document, { step: 0, curve: 0, vertex: 0 }), () => dx.morphPaths(document), () => dx.explain(document, 0)]) {
    assert.deepEqual(refusal(call), expected);
  }
  for (const call of [() => dx.harmonic({ ...document, blend: { kind: "ruled" } }), () => dx.cells(document), () => dx.amounts(document)]) {
    assert.deepEqual(refusal(call), expected);
  }
  assert.deepEqual(refusal(() => figure.match(document)), { code: "not-in-module", path: "blend.kind" });
  assert.deepEqual(refusal(() => figure.harmonic(document)), { code: "not-in-module", path: "" });
  const kept = { ...document, blend: { kind: "ruled", lines: 60, segments: 300 } };
  assert.equal(figure.match(kept).ok, true, "what belongs to another kind is passed over");
  assert.deepEqual(dx.defaults(document).blend, { kind: "harmonic", stages: 5, lines: 44, segments: 200 });
});
