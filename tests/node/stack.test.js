/** Stacks of more than two curves through the package: shapes of results, spans, refusals, the module without them. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "directrix";
import { stackCsv } from "../../www/src/files/csv.js";
import { animatedStack } from "../../www/src/morph/animated-stack.js";
import { eased } from "../../www/src/morph/motion.js";
import { refused } from "./refused.js";

/** @import { Curve, CurvesDocument } from "directrix" */

const dx = await load();

/** @param {number} radius @param {number} height @returns {Curve} */
function ring(radius, height = 0) {
  const points = Array.from({ length: 8 }, (_, k) => [radius * Math.cos((Math.PI * k) / 4), radius * Math.sin((Math.PI * k) / 4)]);
  return { degree: 3, form: "periodic", points: /** @type {any} */ (points), height };
}

/** @param {Partial<CurvesDocument>} [rest] @returns {CurvesDocument} */
const nest = (rest = {}) => ({
  directrix: 1,
  kind: "curves",
  materials: ["#f0e442", "#0072b2", "#009e73"].map((color) => ({ name: color, color })),
  curves: [ring(10), ring(20), ring(34)],
  matching: { method: "exact", oneToOne: true },
  blend: { kind: "cubic", stages: 4 },
  ...rest,
});

test("a stack has the results of its spans, and totals that add up", () => {
  const match = dx.match(nest());
  assert.deepEqual([match.ok, match.diagnostics], [true, []]);
  const { spans = [], knots = [], threads = [] } = match;
  assert.equal(spans.length, 2);
  assert.deepEqual([match.lines, match.pairs, match.samples.length], [[], [], 3]);
  for (const [k, span] of spans.entries()) {
    const alone = dx.match(dx.span(nest(), k));
    assert.deepEqual(span.pairs, alone.pairs, `span ${k}`);
    assert.deepEqual(span.totals, alone.totals);
    assert.ok(span.totals.pairs && span.totals.pairs.eta && span.totals.pairs.eta > 0.99);
  }
  assert.equal(match.totals.pairs?.count, 88);
  assert.ok(Math.abs(Number(match.totals.pairs?.sum) - spans.reduce((sum, { totals }) => sum + Number(totals.pairs?.sum), 0)) < 1e-12);
  assert.deepEqual([match.totals.pairs?.crossings, match.totals.pairs?.blocked, match.totals.pairs?.eta], [0, 0, null]);
  assert.deepEqual([knots[0], knots[2], knots.length], [0, 1, 3]);
  assert.ok(Math.abs(knots[1] - 10 / 24) < 0.01, "knots follow the ways between the curves");
  assert.ok(threads.length >= 44 && threads.every((thread) => thread.length === 3));
});

test("stages, cells, isolines and probes run through the whole stack", () => {
  const stages = dx.stages(nest());
  assert.deepEqual([stages.length, stages[0].s, stages[8].s], [9, 0, 1]);
  assert.ok(stages.every(({ s }, k) => k === 0 || s > stages[k - 1].s));
  const cells = dx.cells(nest());
  assert.deepEqual(new Set(cells.map(({ stage }) => stage)), new Set([0, 1, 2, 3, 4, 5, 6, 7]));
  assert.ok(cells.every(({ fractions }) => Math.abs(fractions.reduce((a, b) => a + b) - 1) < 1e-12));
  const [half] = dx.isolines(nest(), { material: 1, levels: [0.5] });
  assert.deepEqual(half.closed, [true, true]);
  const inside = dx.probe(nest(), [12, 0]);
  const outside = dx.probe(nest(), [25, 0]);
  assert.deepEqual([inside?.span, outside?.span], [0, 1]);
  assert.ok(inside && outside && inside.s < 0.5 && outside.s > 0.5);
  assert.equal(dx.probe(nest(), [0, 0]), null);
  const printed = nest({ matching: { method: "exact", printed: ["stages"] } });
  assert.deepEqual([dx.stages(printed).length, dx.stages(printed)[0].s], [11, 1]);
});

test("what takes two curves says so and names the way out", () => {
  for (const [name, call] of /** @type {[string, (document: CurvesDocument) => unknown][]} */ ([
    ["steps", dx.steps],
    ["sets", (document) => dx.sets(document, { step: 0, curve: 0, vertex: 0 })],
    ["explain", (document) => dx.explain(document, 0)],
    ["morphPaths", (document) => dx.morphPaths(document)],
  ])) {
    const { code, path, message } = refused(() => call(nest()));
    assert.deepEqual([code, path], ["range", "curves"], name);
    assert.match(message, new RegExp(`3 curves were found; \`${name}\` takes 2.*\`span\``));
    assert.ok(call(dx.span(nest(), 1)), name);
  }
  for (const span of [2, -1, 0.5]) assert.equal(refused(() => dx.span(nest(), span)).path, "span");
});

test("pictures of a stack show every span, and say what they show", () => {
  const { data, width } = dx.paint(nest(), { width: 120, height: 120, layers: ["material"], view: { center: [0, 0], scale: 1.6 } });
  const pixel = (/** @type {number} */ x) => [...data.slice((60 * width + x) * 4, (60 * width + x) * 4 + 3)];
  assert.deepEqual(pixel(60), pixel(2), "nothing inside the first curve and outside of the last one");
  assert.notDeepEqual(pixel(60 + 20), pixel(60 + 40));
  const svg = dx.svg(nest(), { width: 120, height: 120 });
  assert.match(svg, /<desc>3 curves, 88 lines, none crossing, none blocked, least eta \d\.\d{3} between curves \d and \d<\/desc>/);
});

test("an overlap is named with its place and not drawn", () => {
  const moved = { ...ring(60), points: ring(60).points.map(([x, y]) => /** @type {[number, number]} */ ([x + 38, y])) };
  const bad = nest({ curves: [ring(10), ring(12), moved] });
  const { ok, diagnostics } = dx.match(bad);
  const overlap = diagnostics.find(({ code }) => code === "overlap");
  assert.equal(ok, false);
  assert.ok(overlap?.at && overlap.span !== undefined && /ruled/.test(overlap.message));
  assert.deepEqual([dx.stages(bad), dx.cells(bad)], [[], []]);
  assert.equal(dx.match({ ...bad, blend: { kind: "ruled" } }).ok, true);
});

test("the module of figures leaves stacks to the whole one, and takes a cubic blend of two curves", async () => {
  const figure = await load({ module: "figure" });
  assert.equal(refused(() => figure.match(nest())).code, "not-in-module");
  const two = nest({ curves: [ring(10), ring(20)] });
  assert.deepEqual(figure.stages(two), figure.stages({ ...two, blend: { kind: "ruled", stages: 4 } }));
});

test("a stack plays as SVG through all its stages, each at its time", () => {
  const stages = dx.stages(nest());
  for (const repeat of /** @type {const} */ (["once", "swing"])) {
    const motion = { seconds: 2, easing: /** @type {const} */ ("ease"), repeat };
    const options = { stages, closed: true, motion, size: { width: 200, height: 100 } };
    const svg = animatedStack("<svg></svg>", { center: [0, 0], scale: 1 }, options);
    const [, values, times] = /values="([^"]*)" keyTimes="([^"]*)"/.exec(svg) ?? [];
    const paths = values.split(";");
    const at = times.split(";").map(Number);
    assert.equal(paths.length, repeat === "swing" ? 2 * stages.length - 1 : stages.length);
    assert.deepEqual([at.length, at[0], at.at(-1)], [paths.length, 0, 1]);
    assert.ok(at.every((time, k) => k === 0 || time > at[k - 1]));
    const half = repeat === "swing" ? 2 : 1;
    stages.forEach(({ s }, k) => assert.ok(Math.abs(eased("ease", half * at[k]) - s) < 1e-5, `${repeat} ${k}`));
    const counts = new Set(paths.map((path) => path.split("L").length));
    assert.deepEqual([...counts], [stages[0].points.length]);
    const [x, y] = stages[0].points[0];
    assert.ok(paths[0].startsWith(`M${(100 + x).toFixed(1)} ${(50 - y).toFixed(1)}L`) && paths[0].endsWith("Z"));
  }
});

test("the table of a stack has the lines of every span", () => {
  const { spans = [] } = dx.match(nest({ curves: [ring(10), ring(20, 3), ring(34, 7)] }));
  const [head, ...rows] = stackCsv(spans, [0, 3, 7]).trim().split("\n").map((line) => line.split(","));
  assert.deepEqual(head.slice(0, 4), ["span", "line", "u", "v"]);
  assert.deepEqual(rows.map((cells) => Number(cells[0])), [...Array(44).fill(0), ...Array(44).fill(1)]);
  const length = head.indexOf("length");
  const [x1, y1, x2, y2] = rows[50].slice(4, 8).map(Number);
  assert.ok(Math.abs(Number(rows[50][length]) - Math.hypot(x2 - x1, y2 - y1, 4)) < 1e-9, "the difference of the heights counts");
});
