/** Parts in the package: presets, rasters, questions in steps, diagnostics, and what is refused. */
import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { describePart, load } from "directrix";
import { unzipSync } from "fflate";
import { PNG } from "pngjs";
import { remotePart } from "../../js/remote-part.js";
import { inTurns } from "../../js/turns.js";
import { root } from "../../scripts/lib/paths.mjs";
import { refusal } from "./refused.js";

const dx = await load();
const folder = join(root, "www/presets/part");
const names = (await readdir(folder)).map((file) => file.replace(".json", ""));
/** @type {Record<string, any>} */
const documents = Object.fromEntries(
  await Promise.all(names.map(async (name) => [name, JSON.parse(await readFile(join(folder, `${name}.json`), "utf8"))])),
);

/** @param {number} a @param {number} b @param {number} by */
const near = (a, b, by) => assert.ok(Math.abs(a - b) <= by, `${a}, not ${b}`);

test("every preset is a part without faults, whose features all act and whose fractions sum to one", () => {
  assert.equal(names.length, 9);
  for (const name of names) {
    const part = dx.part(documents[name]);
    assert.deepEqual(part.diagnostics, [], name);
    assert.ok(part.box && part.bodies.every(({ made, features }) => made && features.every(({ active }) => active)), name);
    const { body, fractions, leaves } = part.evaluate({ size: [200, 120] });
    let seen = new Uint32Array(part.bodies.length);
    body.forEach((number, at) => {
      const sum = fractions.reduce((sum, list) => sum + list[at], 0);
      near(sum, number === 0 ? 0 : 1, 1e-5);
      if (number > 0) seen[number - 1] |= leaves[at];
    });
    part.bodies.forEach(({ features }, n) => assert.equal(seen[n], 2 ** features.length - 1, `${name}: every feature holds some place`));
  }
});

/** A ring between two circles, copper inside and steel outside. @type {any} */
const ring = {
  directrix: 1,
  kind: "part",
  materials: [{ name: "copper", color: "#d55e00" }, { name: "steel", color: "#0072b2" }],
  shapes: [
    { name: "rim", kind: "circle", center: [0, 0], radius: 9 },
    { name: "bore", kind: "circle", center: [0, 0], radius: 3 },
  ],
  bodies: [{ name: "ring", outline: "rim", holes: ["bore"], blend: { kind: "laplace", elements: 200, boundaries: [{ on: "rim", value: [0, 1] }, { on: "bore", value: [1, 0] }] } }],
};

test("a blended ring is a logarithm of the radius in readings, rasters, lines, amounts and files alike", () => {
  const part = dx.part(ring);
  assert.deepEqual(part.diagnostics, []);
  near(part.bodies[0].blend ?? 0, 200, 8);
  const exact = (/** @type {number} */ radius) => Math.log(radius / 3) / Math.log(3);
  for (const radius of [3.01, 4, 6.5, 8.99]) near(part.probe([radius, 0])?.fractions?.[1] ?? NaN, exact(radius), 2e-3);
  const along = part.along([[0, 0], [0, 9]], 91);
  along.body.forEach((body, n) => body > 0 && near(along.fractions[1][n], exact(n / 10), 2e-3));
  // So many pixels that the blend is found in several bands of rows.
  const { size, body, fractions } = part.evaluate({ size: [700, 700] });
  for (let pixel = 0; pixel < body.length; pixel += 173) {
    const [x, y] = [((pixel % size[0]) + 0.5) / 700, (Math.floor(pixel / size[0]) + 0.5) / 700].map((share) => 18 * share - 9);
    if (body[pixel] > 0) near(fractions[1][pixel], exact(Math.hypot(x, y)), 3e-3);
  }
  const [{ lines }] = part.isolines({ material: 1, levels: [0.5], size: [200, 200] });
  assert.equal(lines.length, 1);
  for (const [x, y] of lines[0]) near(Math.hypot(x, y), Math.sqrt(27), 0.02);
  // 2 pi times the integral of ln(r / 3) / ln 3 times r from 3 to 9.
  const whole = 2 * Math.PI * ((81 / 2) * exact(9) - (81 - 9) / 4 / Math.log(3));
  near(part.amounts({ size: [400, 400] }).amounts[1], whole, whole * 3e-3);
  const rows = new TextDecoder().decode(part.file({ format: "csv", size: [9, 9] })).trim().split("\n");
  const cells = rows[1].split(",").map(Number);
  near(cells.at(-1) ?? NaN, exact(Math.hypot(cells[0], cells[1])), 5e-3);
  assert.deepEqual(part.defaults().bodies[0].blend, { kind: "laplace", elements: 200, boundaries: [{ on: "rim", within: 0, value: [0, 1] }, { on: "bore", within: 0, value: [1, 0] }] });
});

test("a fault of a blend is said with its piece and place, and the body keeps its default", () => {
  const broken = structuredClone(ring);
  broken.bodies[0].blend.boundaries.push(/** @type {any} */ ({ on: "bore", value: [0, 1] }));
  const part = dx.part(broken);
  const [{ code, path, skipped, body, boundary, at }] = part.diagnostics;
  assert.deepEqual([code, path, skipped, body, boundary], ["conflict", "bodies[0].blend.boundaries[2]", true, 0, 2]);
  near(Math.hypot(...(at ?? [0, 0])), 3, 1e-6);
  assert.equal(part.bodies[0].blend, null);
  assert.deepEqual(part.probe([5, 0])?.fractions, [1, 0]);
});

test("a material fillet takes over what the bodies on both sides have, in steps of no more than their time", () => {
  const part = dx.part(documents.fillet);
  const at = (/** @type {[number, number]} */ point) => part.probe(point)?.fractions ?? [];
  // A little inside and outside of the shaft, and to the left and the right of the fillet.
  for (const [inside, outside] of /** @type {[[number, number], [number, number]][]} */ ([[[0, 14.99], [0, 15.01]], [[-33.0, 0], [-33.7, 0]]])) {
    at(inside).forEach((fraction, k) => near(fraction, at(outside)[k], 0.06));
  }
  const job = dx.job({ ...documents.fillet, title: "anew" }, { part: { question: "evaluate", rest: { options: { size: [60, 42] } } } });
  let [steps, last] = [0, { done: false, progress: 0 }];
  while (!last.done) {
    last = job.step(0);
    assert.ok(last.progress >= 0 && last.progress <= 1);
    steps += 1;
  }
  assert.ok(steps > 20, `${steps} steps`);
});

test("the rectangle of two profiles has four leaves, each named, with their areas", () => {
  const part = dx.part(documents.rectangle);
  const leaves = part.leaves({ size: [200, 120] });
  assert.deepEqual(leaves.map(({ names }) => names), [[], ["A"], ["B"], ["A", "B"]]);
  assert.deepEqual(leaves.map(({ area }) => Math.round(area)), [2100, 900, 2100, 900]);
  const place = part.probe([12, 45]);
  assert.ok(place?.fractions);
  near(place.fractions[0], 0.6, 1e-12);
  assert.deepEqual([place.body, place.leaf, place.nearest], [0, 1, 0]);
  assert.deepEqual(place.distances.map(({ name, distance, holds }) => [name, distance, holds]), [["A", 12, true], ["B", 45, false]]);
  assert.equal(part.probe([-1, 5]), null);
});

test("of a thin coating under a deep gradient the rules leave nearly all, next to nothing, and less than half", () => {
  const share = (/** @type {string} */ rule) => {
    const document = structuredClone(documents.coating);
    document.bodies[0].rule = rule;
    const { size, fractions } = dx.part(document).evaluate({ size: [160, 1000] });
    // The first row of pixels, .025 below the surface, at 5 from the gradient's edge.
    return fractions[0][Math.floor((5 / 80) * size[0])];
  };
  const [repaired, depth, printed] = ["repaired", "depth", "printed"].map(share);
  assert.ok(repaired > 0.95 && depth < 0.03 && printed < 0.5, `${repaired}, ${depth}, ${printed}`);
});

test("amounts, isolines, lines and rules agree with closed forms", () => {
  const part = dx.part({
    directrix: 1,
    kind: "part",
    materials: [{ name: "a", color: "#000000" }, { name: "b", color: "#ffffff" }],
    shapes: [
      { name: "disc", kind: "circle", center: [0, 0], radius: 10 },
      { name: "bore", kind: "circle", center: [0, 0], radius: 4 },
    ],
    bodies: [{ name: "ring", outline: "disc", holes: ["bore"], default: [0, 1], features: [{ reference: "bore", to: 5, start: [1, 0] }] }],
    rules: [{ name: "at most half", material: 0, most: 0.5 }, { material: 0, of: "gradient", most: 0.25 }],
  });
  const exact = 2 * Math.PI * (10 + 25 / 6);
  const error = (/** @type {number} */ size) => Math.abs(part.amounts({ size: [size, size] }).amounts[0] - exact) / exact;
  assert.ok(error(500) < 1e-3 && error(500) < error(50), `${error(50)}, ${error(500)}`);
  for (const { level, lines, closed } of part.isolines({ size: [200, 200], levels: [0.25, 0.5, 0.75] })) {
    assert.deepEqual(closed, [true]);
    for (const [x, y] of lines[0]) near(Math.hypot(x, y), 4 + 5 * (1 - level), 5e-3);
  }
  const { body, fractions } = part.along([[0, 0], [10, 0]], 101);
  assert.deepEqual([body[20], body[60]], [0, 1]);
  assert.ok(Number.isNaN(fractions[0][20]));
  near(fractions[0][60], 0.6, 1e-12);
  const { rules, pixels } = part.violations({ size: [400, 400] });
  assert.deepEqual(rules.map(({ name, count }) => [name, count > 0]), [["at most half", true], ["Rule 2", false]]);
  near(rules[0].area, Math.PI * (6.5 ** 2 - 16), 1);
  assert.equal(pixels.filter((mask) => mask === 1).length, rules[0].count);
});

test("a raster has its box and colours from the top", () => {
  const part = dx.part(documents.rectangle);
  const raster = part.evaluate({ box: [[-10, -10], [110, 70]], size: [120, 80], colors: true });
  assert.deepEqual([raster.size, raster.box, raster.fractions.length], [[120, 80], [[-10, -10], [110, 70]], 3]);
  assert.ok(raster.colors);
  const at = (/** @type {number} */ i, /** @type {number} */ j) => [.../** @type {Uint8Array} */ (raster.colors).subarray(4 * (120 * j + i), 4 * (120 * j + i) + 4)];
  assert.deepEqual(at(0, 0), [0, 0, 0, 0]);
  assert.deepEqual(at(105, 12), [240, 228, 66, 255], "yellow far from both edges");
  const [red, , , alpha] = at(10, 12);
  assert.ok(red > 205 && alpha === 255, "red at the left edge");
});

test("a question runs in short steps, whatever it is", () => {
  for (const [name, question, rest] of /** @type {const} */ ([
    ["tool", "evaluate", { options: { size: [300, 200], colors: true } }],
    ["scaffold", "violations", { options: { size: [300, 200] } }],
    ["lens", "file", { options: { format: "csv", size: [300, 100] } }],
  ])) {
    const job = dx.job(documents[name], { part: { question, rest } });
    let [steps, last] = [1, 0];
    let state = job.step(0);
    for (; !state.done; state = job.step(0)) {
      assert.ok(state.progress >= 0 && state.progress < 1);
      last = state.progress;
      steps += 1;
    }
    assert.ok(steps > 100 && last > 0.5, `${name}: ${steps} steps, ${last}`);
    assert.deepEqual(state.answer, dx.part({ ...documents[name], title: "anew" })[question](/** @type {any} */ (rest.options)), name);
  }
});

test("over a connection a part answers the same, and not what nobody waits for", async () => {
  let isWanted = true;
  const send = async (/** @type {any[]} */ args) => {
    const found = await inTurns(dx, { name: "part", args: args.slice(0, 2) }, { isWanted: () => isWanted, onprogress: () => {} });
    return found?.value ?? null;
  };
  const document = { ...documents.base, title: "over a connection" };
  const [there, here] = [await remotePart(send, document), dx.part(documents.base)];
  assert.deepEqual([there.bodies, there.diagnostics, there.box], [here.bodies, here.diagnostics, here.box]);
  const size = /** @type {[number, number]} */ ([80, 60]);
  assert.deepEqual(await there.evaluate({ size, colors: true }), here.evaluate({ size, colors: true }));
  assert.deepEqual(await there.probe([60, 50], { onprogress: () => {} }), here.probe([60, 50]));
  assert.deepEqual(await there.along([[0, 15], [120, 15]], 5), here.along([[0, 15], [120, 15]], 5));
  assert.deepEqual(await there.defaults(), { ...here.defaults(), title: "over a connection" });
  isWanted = false;
  assert.equal(await there.evaluate({ size: [900, 700] }), null);
});

test("files have what their formats promise", () => {
  const part = dx.part(documents.lens);
  const text = (/** @type {Uint8Array} */ bytes) => new TextDecoder("latin1").decode(bytes);
  const csv = text(part.file({ format: "csv", size: [40, 20] })).trim().split("\n");
  assert.equal(csv[0], "x,y,body,leaf,crown glass,flint glass,coating");
  const inside = part.evaluate({ size: [40, 20] }).body.filter((number) => number > 0).length;
  assert.equal(csv.length - 1, inside);
  const size = /** @type {[number, number]} */ ([40, 20]);
  assert.match(text(part.file({ format: "vti", size })), /^<\?xml[^]*<ImageData WholeExtent="0 39 0 19 0 0"[^]*Name="1 flint glass"/);
  assert.match(text(part.file({ format: "nrrd", size })), /^NRRD0004\n[^]*sizes: 40 20 3\n/);
  for (const options of [{}, { material: 1 }, { material: 1, dither: /** @type {const} */ ("diffusion") }]) {
    assert.equal(text(part.file({ format: "png", size, ...options }).subarray(1, 4)), "PNG");
  }
});

test("dithered slices of all materials have each pixel once, with the fractions of the part, at a printer's pitch", () => {
  const part = dx.part(documents.base);
  const pitch = 0.5;
  const { size, fractions, body } = part.evaluate({ pitch });
  assert.deepEqual(size, [240, Math.round((/** @type {any} */ (part.box)[1][1] - /** @type {any} */ (part.box)[0][1]) / pitch)]);
  const inside = body.filter((number) => number > 0).length;
  for (const dither of /** @type {const} */ (["diffusion", "blue-noise"])) {
    const slices = [0, 1, 2].map((material) => PNG.sync.read(Buffer.from(part.file({ format: "png", material, dither, pitch }))).data);
    const counts = slices.map((slice) => slice.filter((value, n) => n % 4 === 0 && value === 255).length);
    body.forEach((number, at) => assert.equal(slices.filter((slice) => slice[4 * at] === 255).length, number > 0 ? 1 : 0));
    fractions.forEach((list, material) => near(counts[material] / inside, list.reduce((sum, each) => sum + each, 0) / inside, 0.004));
    const archive = unzipSync(part.file({ format: "slices", dither, pitch }));
    assert.deepEqual(Object.keys(archive), ["1 red.png", "2 green.png", "3 yellow.png"]);
    Object.values(archive).forEach((bytes, material) => assert.deepEqual(bytes, part.file({ format: "png", material, dither, pitch })));
  }
  assert.deepEqual(refusal(() => part.file(/** @type {any} */ ({ format: "csv", dither: "diffusion" }))), { code: "range", path: "options.dither" });
  assert.deepEqual(refusal(() => part.evaluate({ pitch: 1e-7 })), { code: "limit", path: "options.pitch" });
});

test("edits in any order, with questions between, equal a part made afresh", () => {
  /** @type {((document: any) => void)[]} */
  const edits = [
    (d) => (d.bodies[0].features[0].to = 22),
    (d) => (d.bodies[0].features[1].course = { kind: "smoothstep" }),
    (d) => (d.bodies[0].rule = "depth"),
    (d) => (d.shapes[1].to = [3, 60]),
  ];
  const [forth, back] = [structuredClone(documents.rectangle), structuredClone(documents.rectangle)];
  for (const edit of edits) {
    edit(forth);
    dx.part(forth).leaves({ size: [40, 24] });
  }
  for (const edit of [...edits].reverse()) {
    edit(back);
    dx.part(back).evaluate({ size: [50, 30] });
  }
  const size = /** @type {[number, number]} */ ([60, 36]);
  assert.deepEqual(dx.part(forth).evaluate({ size }), dx.part(back).evaluate({ size }));
  assert.deepEqual(dx.part(forth).evaluate({ size }), dx.part({ ...forth, title: "afresh" }).evaluate({ size }));
});

test("a sentence says what a part is made of and which design rules it breaks", () => {
  const said = (/** @type {any} */ document) => {
    const part = dx.part(document);
    return describePart(part, { materials: document.materials, amounts: part.amounts(), rules: part.violations().rules });
  };
  assert.match(said(documents.rectangle), /^1 body, 2 features, red 12\.\d %, green 22\.\d % and yellow 65\.\d %, broken: red changes slowly$/);
  const faulty = structuredClone(documents.tool);
  faulty.bodies[0].features[0].reference = "nothing";
  assert.match(said(faulty), /^1 body, 2 features, 1 left out, tool steel/);
});

test("a fault is said at the feature, and the rest works", () => {
  const document = structuredClone(documents.rectangle);
  document.bodies[0].features[0].course = { kind: "expression", text: "1 - exp(-d / )" };
  const part = dx.part(document);
  assert.equal(part.diagnostics.length, 1);
  const [{ code, path, body, feature, character, skipped }] = part.diagnostics;
  assert.deepEqual({ code, path, body, feature, character, skipped }, {
    code: "expression",
    path: "bodies[0].features[0].course.text",
    body: 0,
    feature: 0,
    character: 13,
    skipped: true,
  });
  assert.deepEqual(part.bodies[0].features.map(({ active }) => active), [false, true]);
  assert.equal(part.probe([70, 10])?.leaf, 2);
});

test("defaults are spelt out and stay the same document", () => {
  for (const name of names) {
    const whole = dx.part(documents[name]).defaults();
    assert.deepEqual(dx.part(whole).defaults(), whole, name);
    assert.equal(whole.bodies[0].rule, "repaired");
    const [found, expected] = [whole, documents[name]].map((document) => dx.part(document).evaluate({ size: [60, 40] }));
    assert.deepEqual(found, expected, name);
  }
});

test("what is wrong is named by code and path", async () => {
  const without = (/** @type {(document: any) => void} */ edit) => {
    const document = structuredClone(documents.rectangle);
    edit(document);
    return refusal(() => dx.part(document));
  };
  assert.deepEqual(without((d) => (d.kind = "curves")), { code: "kind", path: "kind" });
  assert.deepEqual(without((d) => (d.directrix = 2)), { code: "version", path: "directrix" });
  assert.deepEqual(without((d) => (d.bodies[0].features[1].to = NaN)), { code: "non-finite", path: "bodies[0].features[1].to" });
  assert.deepEqual(without((d) => (d.bodies[0].features[1].start = [0, 1, 1])), { code: "range", path: "bodies[0].features[1].start" });
  assert.deepEqual(without((d) => (d.shapes[1].name = "edge B")), { code: "range", path: "shapes[2].name" });
  for (const ask of /** @type {const} */ (["match", "defaults", "solid", "amounts", "hyperpatch"])) {
    assert.deepEqual(refusal(() => dx[ask](documents.rectangle)), { code: "kind", path: "kind" }, ask);
  }
  const part = dx.part(documents.rectangle);
  assert.deepEqual(refusal(() => part.evaluate({ size: [4096, 4096] })), { code: "limit", path: "options.size" });
  assert.deepEqual(refusal(() => part.evaluate(/** @type {any} */ ({ size: [3] }))), { code: "range", path: "options.size" });
  assert.deepEqual(refusal(() => part.probe([0, Infinity])), { code: "non-finite", path: "point[1]" });
  assert.deepEqual(refusal(() => part.isolines({ material: 3 })), { code: "range", path: "options.material" });
  const figure = await load({ module: "figure" });
  assert.equal(refusal(() => figure.part(documents.rectangle)).code, "not-in-module");
  assert.equal(refusal(() => figure.match(documents.rectangle)).code, "kind");
});
