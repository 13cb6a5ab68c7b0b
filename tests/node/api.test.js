/** The functions of the package in Node: shapes of their results, errors, and that the documentation names them all. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { load } from "directrix";
import { refused } from "./refused.js";

const root = new URL("../../", import.meta.url);
const dx = await load({ module: "figure" });
const full = await load();
const preset = JSON.parse(await readFile(new URL("www/presets/amoeba.json", root), "utf8"));
/** Its lines from sample to sample, as they grow. */
const amoeba = { ...preset, matching: { ...preset.matching, method: "greedy", oneToOne: false } };

test("match gives samples, lines in cyclic order and totals that certify them", () => {
  const match = dx.match(amoeba);
  assert.equal(match.ok, true);
  assert.deepEqual(match.diagnostics, []);
  assert.deepEqual(match.reversed, [false, false]);
  assert.deepEqual(match.samples.map((samples) => samples.points.length), [44, 44]);
  for (const { parameters, normals } of match.samples) {
    assert.ok(parameters.every((u, k) => k === 0 || u > parameters[k - 1]));
    assert.ok(normals.every(([x, y]) => Math.abs(Math.hypot(x, y) - 1) < 1e-12));
  }
  assert.ok(match.lines.every((line, k) => line.visible && (k === 0 || line.from >= match.lines[k - 1].from)));
  const totals = match.totals.lines;
  assert.ok(totals && totals.mean && totals.eta);
  assert.equal(totals.count, match.lines.length);
  assert.ok(Math.abs(totals.sum - match.lines.reduce((sum, line) => sum + line.value, 0)) < 1e-12);
  assert.ok(totals.eta > 0.8 && totals.eta <= 1);
  assert.deepEqual([totals.crossings, totals.blocked, totals.uncovered], [0, 0, [[], []]]);
  assert.deepEqual([match.pairs, match.totals.pairs], [[], null]);
  const { growth } = match.totals;
  assert.ok(growth && growth.count > totals.count && growth.sum > totals.sum, "redundant lines are removed, and each had a value");
  const ascending = (/** @type {0 | 1} */ axis) =>
    match.reparameterisation.every((pair, k, all) => k === 0 || pair[axis] >= all[k - 1][axis]);
  assert.ok(ascending(0) && ascending(1));
});

test("exact gives the optimum in any number of lines, keeps pins, and every method carries its figures", () => {
  const matched = (/** @type {object} */ matching) => dx.match({ ...amoeba, matching });
  const exact = matched({ method: "exact", oneToOne: true, lines: 50 });
  assert.equal(exact.ok, true);
  assert.equal(exact.pairs.length, 50);
  assert.equal(exact.gapKind, "supremum");
  assert.ok(exact.optimumChange !== null && exact.optimumChange < 1e-4);
  assert.ok(exact.gap !== null && exact.optimum !== null && exact.gap > 0 && exact.gap < 1e-3);
  assert.ok(Math.abs(1 - Number(exact.totals.pairs?.integral) / exact.optimum - exact.gap) < 1e-12);
  assert.equal(exact.totals.growth, null);
  for (const method of ["greedy", "one-per-vertex", "shift", "parameter"]) {
    const { totals } = matched({ method, oneToOne: true });
    assert.ok(totals.pairs && totals.lines, method);
    const { integral, bound, eta, spreadSum, leastCosine, longest } = totals.pairs;
    assert.ok(integral && bound && eta && Math.abs(integral / bound - eta) < 1e-12, method);
    assert.ok(spreadSum && leastCosine !== null && leastCosine <= 1 && longest && longest > 0, method);
    const best = exact.totals.pairs?.integral;
    const isSound = totals.pairs.crossings + totals.pairs.blocked === 0;
    assert.ok(!isSound || (best && integral <= best * 1.005), `${method}: ${integral} above ${best}`);
  }
  const pin = { u: exact.pairs[7].u, v: exact.pairs[8].v };
  const pinned = matched({ method: "exact", oneToOne: true, pins: [pin] });
  assert.ok(pinned.pairs.some(({ u, v }) => Math.abs(u - pin.u) < 1e-9 && Math.abs(v - pin.v) < 1e-9));
  const { ok, diagnostics } = matched({ method: "exact", pins: [{ u: 0.1, v: 0.2 }, { u: 0.2, v: 0.1 }] });
  assert.equal(ok, false);
  assert.ok(diagnostics.some(({ code, pins, reason }) => code === "pins" && pins?.length === 2 && reason === "cross"));
});

test("coarse matching leaves the refinement out until it is asked for", () => {
  const document = { ...preset, title: "coarse" };
  const coarse = dx.match(document, { coarse: true });
  assert.deepEqual([coarse.ok, coarse.coarse, coarse.gapKind, coarse.pairs.length], [true, true, "lattice", 44]);
  assert.ok(coarse.pairs.every(({ verified }) => verified));
  const picture = dx.paint(document, { width: 64, height: 48, coarse: true });
  const fine = dx.match(document);
  assert.deepEqual([fine.ok, fine.coarse, fine.gapKind, fine.pairs.length], [true, false, "supremum", 44]);
  assert.ok(Number(fine.totals.pairs?.integral) > Number(coarse.totals.pairs?.integral));
  assert.deepEqual(dx.match(document, { coarse: true }), fine, "what is known is not made worse");
  assert.notDeepEqual(dx.paint(document, { width: 64, height: 48, coarse: true }).data, picture.data);
  assert.equal(dx.match(amoeba, { coarse: true }).coarse, false, "greedy lines are not refined");
  const job = dx.job({ ...preset, title: "coarse in steps" }, { coarse: true });
  while (!job.step(5).done);
  assert.equal(dx.match({ ...preset, title: "coarse in steps" }, { coarse: true }).coarse, true);
});

test("a line is explained by its parts, its rank and its rivals", async () => {
  for (const document of [amoeba, preset]) {
    const match = full.match(document);
    const toEnds = match.pairs.length > 0;
    const lines = toEnds ? match.pairs : match.lines;
    for (const line of [0, 7, lines.length - 1]) {
      const found = full.explain(document, line);
      assert.ok(found && found.line === line && found.value === lines[line].value);
      const { factors, cosine, length, ends } = found;
      assert.ok(Math.abs(factors[0] * factors[1] * factors[2] - found.value) < 1e-12);
      assert.ok(Math.abs(factors[0] - cosine) < 1e-12 && Math.abs(factors[1] * length ** 2 - 1) < 1e-9);
      ends.forEach(({ rank, visible, rivals }, end) => {
        assert.ok(rank !== null && rank >= 1 && rank <= visible && rivals.length === 4);
        const here = end === 0 ? "from" : "to";
        const there = end === 0 ? "to" : "from";
        assert.ok(rivals.every((rival) => `${rival[here]}` === `${found[here]}` && rival.fate !== undefined));
        assert.ok(rivals.every(({ value }, k) => k === 0 || value <= rivals[k - 1].value));
        const better = rivals.filter(({ value, fate }) => value > found.value && fate !== "blocked").length;
        assert.ok(better === Math.min(rank - 1, better), "those above it are above it");
        for (const rival of rivals) {
          const place = toEnds ? match.pairs[rival.other][there] : match.samples[1 - end].points[rival.other];
          assert.deepEqual(rival[there], place);
          assert.equal(rival.line !== null, rival.fate === "crosses");
        }
      });
    }
    assert.equal(full.explain(document, lines.length), null);
  }
  assert.equal(refused(() => full.explain(amoeba, -1)).path, "line");
  assert.equal(refused(() => dx.explain(amoeba, 0)).code, "not-in-module");
});

test("corners carry the bisector that stands for their normal", async () => {
  const square = JSON.parse(await readFile(new URL("www/presets/sharp-square.json", root), "utf8"));
  const corners = dx.match(square).diagnostics.filter(({ code }) => code === "corner");
  assert.equal(corners.length, 4);
  for (const { curve, turn, at, normal } of corners) {
    assert.ok(curve === 0 && Math.abs((turn ?? 0) - 90) < 1e-9 && at && normal);
    // The square lies about the origin: its diagonals bisect the sides.
    const [x, y] = at.map((value) => value / Math.hypot(...at));
    assert.ok(Math.hypot(normal[0] - x, normal[1] - y) < 1e-9, `${normal}`);
  }
});

test("one-to-one pairs ascend, are verified, and carry the band", () => {
  const document = { ...amoeba, matching: { ...amoeba.matching, oneToOne: true } };
  const match = dx.match(document);
  const { pairs } = match;
  assert.equal(match.ok, true);
  assert.deepEqual(match.lines, dx.match(amoeba).lines, "the lines between samples stay");
  assert.equal(pairs.length, match.lines.length);
  assert.ok(pairs.every(({ u, v, verified }, k) => verified && (k === 0 || (u > pairs[k - 1].u && v > pairs[k - 1].v))));
  assert.deepEqual(match.reparameterisation, pairs.map(({ u, v }) => [u, v]));
  const totals = match.totals.pairs;
  assert.ok(totals?.eta && totals.eta > 0.9 && totals.eta <= 1);
  assert.deepEqual([totals.count, totals.crossings, totals.blocked, totals.uncovered], [pairs.length, 0, 0, [[], []]]);
  const stages = dx.stages(document);
  pairs.forEach(({ from, to }, k) => {
    for (const [at, end] of /** @type {const} */ ([[stages[0].points[k], from], [stages[5].points[k], to]])) {
      assert.ok(Math.hypot(at[0] - end[0], at[1] - end[1]) < 1e-9);
    }
  });
  assert.equal(full.cells(document).length, 5 * pairs.length);
  const place = dx.probe(document, [45, 0]);
  assert.ok(place);
  assert.deepEqual([place.value, place.from, place.to], [pairs[place.line].value, pairs[place.line].from, pairs[place.line].to]);
  assert.equal(dx.defaults(document).matching.oneToOne, true);
});

test("adaptive samples are spelt out and taken", () => {
  const document = { ...amoeba, sampling: { scheme: /** @type {const} */ ("adaptive"), tolerance: 0.05 } };
  const full = dx.defaults(document).sampling;
  assert.deepEqual(full, { scheme: "adaptive", counts: [44, 44], tolerance: 0.05, maxTurn: 15, minCount: 12 });
  const counts = dx.match(document).samples.map(({ parameters }) => parameters.length);
  const coarse = dx.match({ ...amoeba, sampling: { ...full, tolerance: 1, maxTurn: 40 } });
  assert.ok(coarse.samples.every(({ parameters }, k) => parameters.length >= 12 && parameters.length < counts[k]));
  const codes = dx.match({ ...amoeba, sampling: { ...full, maxTurn: 1, tolerance: 1e-9 } }).diagnostics;
  assert.deepEqual(codes.map(({ code, curve }) => [code, curve]), [["sample-limit", 0], ["sample-limit", 1]]);
});

test("stages, cells and probe agree with the lines", () => {
  const match = dx.match(amoeba);
  const stages = dx.stages(amoeba);
  assert.deepEqual(stages.map(({ s }) => s), [0, 0.2, 0.4, 0.6, 0.8, 1]);
  const near = (/** @type {number[]} */ p, /** @type {number[]} */ q) => Math.hypot(p[0] - q[0], p[1] - q[1]) < 1e-9;
  match.lines.forEach((line, k) => {
    assert.ok(near(stages[0].points[k], match.samples[0].points[line.from]));
    assert.ok(near(stages[5].points[k], match.samples[1].points[line.to]));
  });
  assert.equal(dx.stages(amoeba, { refine: 3 })[2].points.length, 3 * match.lines.length);

  const cells = full.cells(amoeba);
  assert.equal(cells.length, 5 * match.lines.length);
  assert.ok(cells.every(({ fractions }) => Math.abs(fractions.reduce((a, b) => a + b) - 1) < 1e-12));

  const place = dx.probe(amoeba, [45, 0]);
  assert.ok(place && place.s > 0 && place.s < 1);
  assert.ok(Math.abs(place.fractions.reduce((a, b) => a + b) - 1) < 1e-12);
  assert.equal(place.value, match.lines[place.line].value);
  assert.ok(Math.abs(place.fractions[0] - (1 - place.s)) < 1e-12, "the first material fades along the line");
  assert.equal(dx.probe(amoeba, [0, 0]), null);
});

test("isolines have the fraction that the probe reads", () => {
  const lines = dx.isolines(amoeba, { material: 1, levels: [0.25, 0.5] });
  assert.deepEqual(lines.map(({ level }) => level), [0.25, 0.5]);
  for (const { level, lines: polylines, closed } of lines) {
    assert.ok(polylines.length > 0 && closed.length === polylines.length);
    for (const point of polylines.flat()) {
      const fraction = dx.probe(amoeba, point)?.fractions[1];
      assert.ok(fraction !== undefined && Math.abs(fraction - level) < 1e-6, `${fraction} for ${level}`);
    }
  }
  assert.deepEqual(dx.isolines(amoeba).map(({ level }) => level), [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9]);
  assert.equal(refused(() => dx.isolines(amoeba, { material: 3 })).path, "options.material");
  assert.equal(refused(() => dx.isolines(amoeba, { levels: [2] })).path, "options.levels[0]");
  assert.equal(refused(() => dx.paint(amoeba, { width: 9, height: 9, isoMaterial: 3 })).path, "options.isoMaterial");
});

test("pictures have the size asked for and show the view they say", () => {
  const picture = dx.paint(amoeba, { width: 320, height: 200 });
  assert.deepEqual([picture.width, picture.height, picture.data.length], [320, 200, 320 * 200 * 4]);
  assert.deepEqual(dx.fit(amoeba, { width: 320, height: 200 }), picture.view);
  assert.deepEqual([...picture.data.slice(0, 4)].map((level) => level > 200), [true, true, true, true]);
  const bare = dx.paint(amoeba, { width: 320, height: 200, layers: [], background: false });
  assert.equal(bare.data[3], 0, "transparent without a background");
  const svg = full.svg({ ...amoeba, title: "<b>&" }, { width: 320, height: 200 });
  assert.match(svg, /^<svg/);
  assert.match(svg, /&lt;b&gt;&amp;/);
  assert.ok(!svg.includes("<b>"));
  assert.ok(svg.length < 400_000, `${svg.length} bytes`);
  assert.equal(refused(() => dx.svg(amoeba, { width: 320, height: 200 })).code, "not-in-module");
});

test("a drawing in progress shows what is there and says what is missing", () => {
  for (const curves of [[], amoeba.curves.slice(0, 1)]) {
    const document = { ...amoeba, curves };
    const match = dx.match(document);
    assert.equal(match.ok, false);
    assert.deepEqual(match.diagnostics.map(({ code }) => code), ["incomplete"]);
    assert.ok(match.diagnostics[0].message.startsWith(`${curves.length} of 2 curves`));
    assert.deepEqual([match.totals, match.lines], [{ growth: null, lines: null, pairs: null }, []]);
    assert.deepEqual([match.samples.length, match.reversed.length], [curves.length, curves.length]);
    assert.deepEqual([dx.stages(document), full.cells(document), dx.probe(document, [0, 0])], [[], [], null]);
    assert.equal(dx.paint(document, { width: 60, height: 40 }).data.length, 60 * 40 * 4);
    assert.match(full.svg(document, { width: 60, height: 40 }), /^<svg/);
    assert.equal(dx.defaults(document).curves.length, curves.length);
  }
  const view = dx.fit({ ...amoeba, curves: [] }, { width: 400, height: 300 });
  assert.deepEqual(view.center, [0, 0]);
  assert.ok(view.scale > 2 && view.scale <= 3, "100 units fill the height but for a margin");
});

test("inserting a control point keeps the shape", () => {
  const finer = full.insertPoint(amoeba, 1, 0.3);
  assert.equal(finer.curves[1].points.length, amoeba.curves[1].points.length + 1);
  const [before, after] = [dx.match(amoeba), dx.match(finer)];
  after.samples[1].points.forEach(([x, y], k) => {
    const [p, q] = before.samples[1].points[k];
    assert.ok(Math.hypot(x - p, y - q) < 1e-6);
  });
});

test("defaults are spelt out and stay the same when read again", () => {
  const bare = { directrix: 1, kind: "curves", matching: { method: "greedy" }, curves: amoeba.curves };
  const full = dx.defaults(/** @type {any} */ ({ ...bare, materials: amoeba.materials }));
  assert.deepEqual(full.sampling, { scheme: "arc-length", counts: [44, 44] });
  assert.equal(full.matching.oneToOne, false);
  const plain = dx.defaults({ ...full, curves: full.curves.map(({ composition, ...curve }) => curve) });
  assert.deepEqual(plain.curves.map((curve) => curve.composition), [[{ at: 0, mix: [1, 0, 0] }], [{ at: 0, mix: [0, 1, 0] }]]);
  assert.deepEqual(dx.defaults(full), full);
  assert.deepEqual(dx.defaults(JSON.stringify(full)), full, "text does as well");
});

test("errors carry code, path and place", () => {
  const moved = structuredClone(amoeba);
  moved.curves[1].points[2][1] = Number.NaN;
  const error = refused(() => dx.match(moved));
  assert.deepEqual([error.code, error.path], ["non-finite", "curves[1].points[2][1]"]);

  for (const [edit, code, path] of /** @type {[(d: any) => void, string, string][]} */ ([
    [(d) => (d.directrix = 2), "version", "directrix"],
    [(d) => (d.kind = "part"), "kind", "kind"],
    [(d) => (d.matching.method = "best"), "range", "matching.method"],
    [(d) => (d.matching.pins = [{ u: 0.1, v: 0.1 }]), "range", "matching.pins"],
    [(d) => (d.matching.colour = 1), "unknown-field", "matching.colour"],
    [(d) => delete d.curves, "missing", "curves"],
    [(d) => (d.curves[0].points = d.curves[0].points.slice(0, 2)), "points", "curves[0].points"],
    [(d) => (d.curves[0].knots = [0, 1]), "knots", "curves[0].knots"],
    [(d) => (d.sampling.counts = [44, 2000]), "limit", "sampling.counts[1]"],
    [(d) => (d.curves[0].height = 1e300), "range", "curves[0].height"],
    [(d) => (d.curves[0].points = [[1, 1], [1, 1], [1, 1], [1, 1]]), "zero-length", "curves[0].points"],
  ])) {
    const document = structuredClone(amoeba);
    edit(document);
    const found = refused(() => dx.match(document));
    assert.deepEqual([found.code, found.path], [code, path], found.message);
  }
  assert.equal(refused(() => dx.match("{")).code, "syntax");
  assert.equal(refused(() => dx.match('{"directrix": 1e999}')).code, "non-finite");
  assert.equal(refused(() => dx.match(/** @type {any} */ (null))).code, "type");
  assert.equal(refused(() => dx.match("[".repeat(100) + "]".repeat(100))).code, "limit");
  assert.equal(refused(() => dx.paint(amoeba, /** @type {any} */ ({ width: 10 }))).path, "options.height");

  const crossed = structuredClone(amoeba);
  crossed.curves[0].points[0] = [200, 0];
  const contact = refused(() => dx.match(crossed));
  assert.ok(["contact", "self-intersection"].includes(contact.code));
  assert.equal(contact.at?.length, 2);
  assert.ok(dx.paint(crossed, { width: 60, height: 40 }).data.length > 0, "the curves are drawn all the same");
});

test("a job solves in steps and gives the same matching", () => {
  const document = { ...amoeba, sampling: { scheme: "arc-length", counts: [300, 300] } };
  const job = dx.job(document);
  let last = 0;
  let steps = 0;
  for (let state = job.step(1); !state.done; state = job.step(1)) {
    assert.ok(state.progress >= last && state.progress < 1);
    last = state.progress;
    steps++;
  }
  assert.ok(steps > 1, `${steps} steps`);
  assert.equal(dx.match(document).ok, true);
  const inserting = dx.job({ ...document, matching: { ...amoeba.matching, oneToOne: true } });
  for (let state = inserting.step(1), last = 0; !state.done; last = state.progress, state = inserting.step(1)) {
    assert.ok(state.progress >= last && state.progress < 1, `${last} to ${state.progress}`);
  }
});

test("a job paints in steps and gives the same picture", () => {
  const document = { ...amoeba, title: "painted in steps" };
  const size = { width: 1500, height: 1100, pixelRatio: 2 };
  const job = dx.job(document, { paint: size });
  /** @type {number[]} */
  const shares = [];
  let state = job.step(0);
  for (; !state.done; state = job.step(0)) {
    assert.equal(state.picture, undefined);
    shares.push(state.progress);
  }
  assert.ok(shares.length > 5 && shares.every((share, i) => share < 1 && share >= (shares[i - 1] ?? 0)), `${shares}`);
  assert.deepEqual(state.picture, dx.paint(document, size));
  assert.equal(job.step(0), state, "a job that is done stays so");
  assert.equal(refused(() => dx.job(document, { paint: { ...size, width: 5000 } }).step(1000)).path, "options.width");
  const crossed = { ...amoeba, curves: [amoeba.curves[1], amoeba.curves[1]] };
  assert.ok(dx.job(crossed, { paint: size }).step(1000).progress > 0, "curves that cannot be matched are drawn");
});

test("both modules answer alike", async () => {
  assert.deepEqual(full.match(amoeba), dx.match(amoeba));
  assert.equal(await load(), full, "loaded once");
  await assert.rejects(load({ module: /** @type {any} */ ("half") }), RangeError);
});

test("docs/api.md names every function, option, layer and code", async () => {
  const read = (/** @type {string} */ path) => readFile(new URL(path, root), "utf8");
  const [api, format, types] = await Promise.all([read("docs/api.md"), read("docs/format.md"), read("js/directrix.d.ts")]);
  for (const name of Object.keys(dx)) assert.match(api, new RegExp(`\`${name}\\(`), name);
  for (const name of ["load", "connect", "DirectrixError"]) assert.match(api, new RegExp(`\`${name}`), name);
  const union = (/** @type {string} */ type) => {
    const body = types.split(`export type ${type} =`)[1].split(";")[0];
    return [...body.matchAll(/"([^"]+)"/g)].map(([, name]) => name);
  };
  for (const code of union("ErrorCode")) assert.match(api, new RegExp(`\`${code}\``), code);
  for (const layer of union("LayerName")) assert.match(format, new RegExp(`\`${layer}\``), layer);
  const options = types.split("export interface PictureOptions")[1].split("\n}")[0];
  for (const [, name] of options.matchAll(/^ {2}(\w+)\?:/gm)) assert.match(api, new RegExp(`\`${name}\``), name);
});
