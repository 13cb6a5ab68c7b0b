/** Solids as data and as files, which readers that are not ours read back. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { load } from "directrix";
import { OBJLoader } from "three/addons/loaders/OBJLoader.js";
import { PLYLoader } from "three/addons/loaders/PLYLoader.js";
import { STLLoader } from "three/addons/loaders/STLLoader.js";
import { completed } from "../../www/src/kernel.js";
import { refused } from "./refused.js";

/** @import { BufferGeometry, Mesh } from "three" */
/** @import { CurvesDocument, Solid, SolidFileOptions, SpaceDocument, SpacePoint } from "directrix" */

const dx = await load();

/** @param {string} name @returns {CurvesDocument} */
const preset = (name) => JSON.parse(readFileSync(new URL(`../../www/presets/${name}.json`, import.meta.url), "utf8"));

/** A preset whose second curve is lifted. @param {string} name @param {number} [height] */
function lifted(name, height = 30) {
  const document = preset(name);
  document.curves[1].height = height;
  return document;
}

/**
 * What triangles enclose, read by coordinates alone: every edge has to be there once each way.
 *
 * @param {ArrayLike<number>} positions
 * @param {ArrayLike<number>} indices
 */
function enclosed(positions, indices) {
  /** @type {Map<string, number>} */
  const edges = new Map();
  const at = (/** @type {number} */ k) => [0, 1, 2].map((axis) => positions[3 * k + axis] + 0);
  let volume = 0;
  let area = 0;
  for (let k = 0; k < indices.length; k += 3) {
    const [a, b, c] = [0, 1, 2].map((corner) => at(indices[k + corner]));
    for (const [from, to] of [[a, b], [b, c], [c, a]]) edges.set(`${from} ${to}`, (edges.get(`${from} ${to}`) ?? 0) + 1);
    const cross = (/** @type {number[]} */ p, /** @type {number[]} */ q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
    const less = (/** @type {number[]} */ p, /** @type {number[]} */ q) => p.map((x, i) => x - q[i]);
    const normal = cross(less(b, a), less(c, a));
    volume += (a[0] * normal[0] + a[1] * normal[1] + a[2] * normal[2]) / 6;
    area += Math.hypot(...normal) / 2;
  }
  const closed = [...edges].every(([edge, count]) => {
    const [from, to] = edge.split(" ");
    return count === 1 && edges.get(`${to} ${from}`) === 1;
  });
  return { closed, volume, area };
}

/** @param {Solid} solid */
function checked(solid) {
  const { positions, normals, colors, indices, groups } = solid;
  const vertices = positions.length / 3;
  assert.deepEqual([normals.length, colors.length], [3 * vertices, 4 * vertices]);
  assert.ok(indices.every((k) => k < vertices));
  for (let k = 0; k < normals.length; k += 3) {
    assert.ok(Math.abs(Math.hypot(normals[k], normals[k + 1], normals[k + 2]) - 1) < 1e-6);
    assert.equal(colors[(4 * k) / 3 + 3], 255);
  }
  assert.equal(groups.reduce((end, { start, count }) => (start === end ? end + count : NaN), 0), indices.length);
  return enclosed(positions, indices);
}

test("a lifted pair is a watertight solid, with what is drawn of it", () => {
  for (const name of ["amoeba", "sharp-square", "u-in-oval", "gear", "three-materials"]) {
    const document = lifted(name);
    const solid = dx.solid(document, { stages: 7 });
    assert.equal(solid.ok, true, name);
    const { closed, volume, area } = checked(solid);
    assert.ok(closed && solid.watertight, name);
    assert.ok(volume > 0 && Math.abs(volume / Number(solid.volume) - 1) < 1e-5, `${name}: ${volume}, ${solid.volume}`);
    assert.ok(Math.abs(area / solid.area - 1) < 1e-5);
    assert.deepEqual(solid.groups.map(({ name, curve }) => [name, curve]), [["surface", undefined], ["cap", 0], ["cap", 1]]);
    const match = dx.match(document);
    const lines = Math.max(match.pairs.length, match.pairs.length ? 0 : match.lines.length);
    assert.deepEqual([solid.rulings.length, solid.stages.length, solid.curves.length], [6 * lines, 8, 2]);
    const materials = document.materials?.length ?? 2;
    assert.equal(solid.fractions.length, (solid.positions.length / 3) * materials);
    for (let k = 0; k < solid.fractions.length; k += materials) {
      const mix = solid.fractions.slice(k, k + materials);
      assert.ok(mix.every((part) => part >= 0) && Math.abs(mix.reduce((sum, part) => sum + part) - 1) < 1e-6);
    }
    assert.deepEqual([solid.scalar, solid.range, solid.projection], [null, null, null]);
    assert.deepEqual([solid.bounds?.min[2], solid.bounds?.max[2]], [0, 30]);
    solid.stages.forEach((stage, j) => stage.forEach((z, k) => k % 3 !== 2 || assert.ok(Math.abs(z - (30 * j) / 7) < 1e-5)));
  }
});

test("a map of angles has a number at each vertex and a range for its colours", () => {
  const document = lifted("nested-ellipses");
  for (const color of /** @type {const} */ (["twist", "flank"])) {
    const { scalar, range, positions, colors } = dx.solid(document, { color });
    assert.ok(scalar && range && scalar.length === positions.length / 3);
    const [low, high] = range;
    assert.ok(scalar.every((angle) => angle >= low - 1e-5 && angle <= high + 1e-5));
    assert.ok(color === "twist" ? low === -high : low === 0 && high > 10, `${range}`);
    const most = scalar.indexOf(scalar.reduce((a, b) => Math.max(a, b)));
    if (color === "flank") assert.deepEqual([...colors.slice(4 * most, 4 * most + 3)], [0xfd, 0xe7, 0x25]);
  }
  const { scalar, range } = dx.solid(document, { color: { material: 0 } });
  assert.deepEqual([scalar, range], [null, [0, 1]]);
});

test("where there is no solid the reason is told", () => {
  const flat = dx.solid(preset("amoeba"));
  assert.deepEqual([flat.ok, flat.watertight, flat.volume, flat.area, flat.bounds], [false, false, null, 0, null]);
  assert.deepEqual([flat.positions.length, flat.indices.length, flat.groups, flat.stages], [0, 0, [], []]);
  const reason = flat.diagnostics.find(({ code }) => code === "flat");
  assert.match(String(reason?.message), /give one of them another `height`/);
  const file = refused(() => dx.solidFile(preset("amoeba"), { format: "stl" }));
  assert.deepEqual([file.code, file.path], ["no-solid", "curves[1].height"]);
  const blocked = lifted("closed-pocket");
  assert.equal(dx.solid(blocked).ok, false);
  assert.ok(dx.solid(blocked).diagnostics.some(({ code }) => code === "orphan"));
  assert.equal(refused(() => dx.solidFile(blocked, { format: "ply" })).code, "no-solid");
  const open = dx.solid(lifted("graded-strip"));
  assert.deepEqual([open.ok, open.watertight, open.volume, open.groups.length], [true, false, null, 1]);
  assert.ok(open.area > 0 && open.diagnostics.some(({ code }) => code === "open-sheet"));
});

test("wrong options are refused by name", () => {
  const document = lifted("amoeba");
  const options = (/** @type {any} */ value) => refused(() => dx.solid(document, value)).path;
  assert.equal(options({ stages: 0 }), "options.stages");
  assert.equal(options({ stages: 201 }), "options.stages");
  assert.equal(options({ color: "heat" }), "options.color");
  assert.equal(options({ color: { material: 3 } }), "options.color.material");
  assert.equal(options({ stage: 3 }), "options.stage");
  const { code, path } = refused(() => dx.solidFile(document, /** @type {any} */ ({ format: "step" })));
  assert.deepEqual([code, path], ["range", "options.format"]);
  assert.equal(refused(() => dx.solidFile(document, /** @type {any} */ ({}))).code, "missing");
});

test("a job builds the same solid in steps, none of which takes long", () => {
  const document = lifted("amoeba");
  document.matching = { method: "exact", oneToOne: true, lines: 200 };
  dx.match(document);
  const whole = dx.solid(document, { stages: 40 });
  const job = dx.job(document, { solid: { stages: 40 } });
  let state = job.step(0);
  let steps = 1;
  const shares = [state.progress];
  for (; !state.done; steps++, shares.push(state.progress)) state = job.step(0);
  assert.ok(steps > 40 && shares.every((share, k) => k === 0 || share >= shares[k - 1]), `${steps}: ${shares}`);
  assert.deepEqual(state.solid, whole);
  assert.equal(job.step(0).solid, state.solid, "done");
  const file = dx.job(document, { solidFile: { format: "stl", stages: 40 } });
  for (state = file.step(0); !state.done; ) state = file.step(0);
  assert.deepEqual(state.file, dx.solidFile(document, { format: "stl", stages: 40 }));
});

/** @param {BufferGeometry} geometry */
function indicesOf(geometry) {
  const count = geometry.getAttribute("position").count;
  return geometry.index ? geometry.index.array : Uint32Array.from({ length: count }, (_, k) => k);
}

/** @param {CurvesDocument} document @param {SolidFileOptions} options */
function bytes(document, options) {
  const file = dx.solidFile(document, options);
  return /** @type {ArrayBuffer} */ (file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength));
}

for (const name of ["amoeba", "star-in-circle", "void-core"]) {
  test(`files of ${name} are watertight for other readers and hold what the kernel holds`, () => {
    const document = lifted(name);
    const options = { stages: 6 };
    const solid = dx.solid(document, options);
    const isSame = (/** @type {ArrayLike<number>} */ positions, /** @type {ArrayLike<number>} */ indices) => {
      const { closed, volume, area } = enclosed(positions, indices);
      assert.ok(closed);
      assert.equal(indices.length, solid.indices.length);
      assert.ok(Math.abs(volume / Number(solid.volume) - 1) < 1e-5 && Math.abs(area / solid.area - 1) < 1e-5);
    };

    const stl = new STLLoader().parse(bytes(document, { ...options, format: "stl" }));
    isSame(stl.getAttribute("position").array, indicesOf(stl));

    const reader = new PLYLoader();
    reader.setCustomPropertyNameMapping({ fractions: document.materials?.map((_, k) => `fraction_${k}`) ?? [] });
    const ply = reader.parse(bytes(document, { ...options, format: "ply" }));
    const positions = ply.getAttribute("position").array;
    isSame(positions, indicesOf(ply));
    assert.ok(positions.length < solid.positions.length, "rims are there once");
    const fractions = ply.getAttribute("fractions").array;
    const materials = document.materials?.length ?? 2;
    assert.equal(fractions.length / materials, positions.length / 3);
    const text = new TextDecoder("latin1").decode(new Uint8Array(bytes(document, { ...options, format: "ply" })).slice(0, 800));
    document.materials?.forEach(({ name }, k) => assert.ok(text.includes(`comment fraction_${k}: ${name}\n`)));
    assert.match(text, new RegExp(`element vertex ${positions.length / 3}\n`));

    const obj = new OBJLoader().parse(new TextDecoder().decode(bytes(document, { ...options, format: "obj" })));
    const parts = /** @type {Mesh[]} */ (obj.children);
    assert.deepEqual(parts.map(({ name }) => name), ["surface", "cap_0", "cap_1"]);
    const points = parts.flatMap(({ geometry }) => [...geometry.getAttribute("position").array]);
    isSame(points, Uint32Array.from({ length: points.length / 3 }, (_, k) => k));
    assert.ok(parts.every(({ geometry }) => geometry.getAttribute("color").count === geometry.getAttribute("position").count));

    // Every vertex that was read is one of the kernel's, with its fractions.
    const known = new Map();
    for (let k = 0; k < solid.positions.length / 3; k++) {
      known.set(`${solid.positions.slice(3 * k, 3 * k + 3)}`, solid.fractions.slice(materials * k, materials * (k + 1)));
    }
    for (let k = 0; k < positions.length / 3; k++) {
      const mix = known.get(`${positions.slice(3 * k, 3 * k + 3)}`);
      assert.deepEqual([...fractions.slice(materials * k, materials * (k + 1))], [...mix]);
    }
    for (let k = 0; k < points.length / 3; k++) assert.ok(known.has(`${Float32Array.from(points.slice(3 * k, 3 * k + 3))}`));
  });
}

test("a file of a map has the angles too", () => {
  const document = lifted("blade");
  const reader = new PLYLoader();
  reader.setCustomPropertyNameMapping({ degrees: ["degrees"] });
  const ply = reader.parse(bytes(document, { format: "ply", stages: 2, color: "flank" }));
  const { range } = dx.solid(document, { stages: 2, color: "flank" });
  const degrees = [...ply.getAttribute("degrees").array];
  assert.ok(range && Math.abs(Math.max(...degrees) - range[1]) < 1e-4 && Math.min(...degrees) >= 0);
});

/** Two rings that wave, each about a level of its own. @returns {SpaceDocument} */
function inSpace() {
  const ring = (/** @type {number} */ radius, /** @type {number} */ height) => ({
    degree: 3,
    form: /** @type {const} */ ("periodic"),
    points: Array.from({ length: 24 }, (_, k) => {
      const angle = (2 * Math.PI * k) / 24;
      return /** @type {SpacePoint} */ ([radius * Math.cos(angle), radius * Math.sin(angle), height + 2 * Math.sin(2 * angle)]);
    }),
  });
  return { directrix: 1, kind: "curves", matching: { method: "exact", oneToOne: true }, curves: [ring(10, 0), ring(25, 30)] };
}

test("curves in space are matched as they are seen, say so, and are the rims of their solid", async () => {
  const document = inSpace();
  const match = dx.match(document);
  const { projection } = match;
  assert.ok(match.ok && projection);
  assert.ok(Math.abs(projection.normal[2] - 1) < 1e-9 && projection.deviation > 1 && projection.deviation < 2);
  assert.ok(Math.abs(projection.heights[1] - projection.heights[0] - 30) < 1e-6);
  assert.match(projection.assumed, /seen along the normal/);
  const solid = dx.solid(document, { stages: 4 });
  assert.ok(solid.ok && solid.watertight && checked(solid).closed);
  assert.deepEqual(solid.projection, projection);
  const rim = solid.stages[0].filter((_, k) => k % 3 === 2);
  assert.ok(Math.max(...rim) > 1 && Math.min(...rim) < -1, "not flattened");
  assert.equal(dx.match(preset("amoeba")).projection, undefined);
  const [first] = dx.defaults(document).curves;
  assert.deepEqual([first.points[3].length, first.height], [3, 0]);
  const figure = await load({ module: "figure" });
  const { code, path } = refused(() => figure.match(document));
  assert.deepEqual({ code, path }, { code: "not-in-module", path: "curves[0].points" });
  const shown = await completed(/** @type {any} */ (dx), document);
  assert.deepEqual(shown.curves.map(({ points }) => points[0].length), [3, 3], "the page takes them as they are");
});
