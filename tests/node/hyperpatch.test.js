/** Bodies of hyperpatches in Node: answers against closed forms, errors, files read back, the presets. */
import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { test } from "node:test";
import { describeBody, load } from "directrix";
import { inTurns } from "../../js/turns.js";
import { presets, textOf } from "../../scripts/hyperpatch-presets.mjs";
import { refusal } from "./refused.js";

/** @typedef {import("directrix").HyperpatchDocument} Document */

const dx = await load();
const folder = new URL("../../www/presets/hyperpatch/", import.meta.url);
const documents = /** @type {Record<string, any>} */ (presets());
const body = (/** @type {string} */ name) => dx.hyperpatch(documents[name]);

/** @param {number} found @param {number} expected @param {number} [tolerance] */
function near(found, expected, tolerance = 1e-8) {
  assert.ok(Math.abs(found - expected) <= tolerance, `${found} is not ${expected}`);
}

test("presets are what their script writes, and have the verdicts that they show", async () => {
  assert.deepEqual((await readdir(folder)).sort(), Object.keys(documents).map((name) => `${name}.json`).sort());
  for (const [name, document] of Object.entries(documents)) {
    assert.equal(await readFile(new URL(`${name}.json`, folder), "utf8"), textOf(document), name);
  }
  const said = Object.fromEntries(Object.keys(documents).map((name) => [name, describeBody(body(name).summary())]));
  assert.deepEqual(said, {
    cell: "1 cell, regular, materials sum to 1",
    twisted: "1 cell, regular, materials sum to 1",
    "nearly-invalid": "1 cell, valid but not regular, materials sum to 1",
    invalid: "1 cell, invalid, materials sum to 1",
    crossing: "1 cell, invalid, materials sum to 1",
    pair: "2 cells, all regular, none overlapping, materials sum to 1",
    block: "8 cells, all regular, none overlapping, materials sum to 1",
    ring: "8 cells, all regular, none overlapping, materials sum to 1",
    cylinder: "4 cells, all regular, none overlapping, materials sum to 1",
    sphere: "7 cells, all regular, none overlapping, materials sum to 1",
    seam: "2 cells, all regular, none overlapping, materials sum to 1",
    porous: "3 cells, all regular, none overlapping, materials sum to 1",
    contact: "2 cells, all regular, none overlapping, 1 pair touching, materials sum to 1",
    row: "4 cells, all regular, none overlapping, materials sum to 1",
  });
});

test("gradations made of corner materials have the shapes that they are named after", () => {
  const mixAt = (/** @type {string} */ name, /** @type {[number, number, number]} */ point) => body(name).probe(point)?.mix[1] ?? NaN;
  const r = 0.15;
  const circle = [0, 20, 45, 70].map((angle) => (angle * Math.PI) / 180).map((a) => mixAt("cylinder", [1 - r * Math.cos(a), 1 - r * Math.sin(a), 0.4]));
  const third = r / Math.sqrt(3);
  const sphere = [mixAt("sphere", [1 - r, 1, 1]), mixAt("sphere", [1 - third, 1 - third, 1 - third]), mixAt("sphere", [1 + third, 1 + third, 1 + third])];
  // By the smoothstep along each axis it is 1 - 3 r^2 but for the third power.
  for (const found of [...circle, ...sphere]) assert.ok(Math.abs(found - (1 - 3 * r * r)) < 3 * r ** 3, String(found));
  const [joint] = body("seam").continuity().faces;
  assert.deepEqual([joint.shape, joint.material], ["C1", "none"]);
  assert.deepEqual(joint.corners.map(({ corner, material }) => [corner[1], material]).sort(), [[0, "C1"], [0, "C1"], [1, "none"], [1, "none"]]);
  const [contact] = body("contact").continuity().contacts;
  assert.equal(contact.corners.length, 2);
  near(contact.gap, 0.6);
  const porous = body("porous");
  assert.equal(documents.porous.materials[1].void, true);
  near(porous.amounts().reduce((sum, each) => sum + each, 0), porous.volume());
});

test("verdicts carry witnesses", () => {
  const [nearly] = body("nearly-invalid").verdicts();
  near(nearly.leastJacobian, 1 - (27 / 32) * 1.15);
  assert.ok(nearly.leastJacobianBound > 0 && nearly.leastJacobianBound <= nearly.leastJacobian && nearly.witness === null);
  const [invalid] = body("invalid").verdicts();
  assert.ok(invalid.witness?.kind === "folded");
  near(invalid.leastJacobian, 1 - (27 / 32) * 1.6);
  invalid.witness.at.forEach((t) => near(t, 0.5));
  near(invalid.witness.jacobian, 1 - (27 / 32) * 1.6);
  const crossing = body("crossing");
  assert.equal(crossing.verdicts({ global: false })[0].verdict, "locally-valid");
  const { verdict, witness } = crossing.verdicts()[0];
  assert.ok(verdict === "invalid" && witness?.kind === "meeting");
  const [one, other] = [witness.at, witness.other].map((at) => crossing.sample(0, at).position);
  one.forEach((x, axis) => near(x, other[axis]));
  assert.ok(Math.abs(witness.at[0] - witness.other[0]) > 0.3, "two places far apart along the bar");
  assert.equal(crossing.verdicts({ global: false })[0].verdict, "invalid", "what is known is not made worse");
  // The first axis of the block runs backwards: every cell is mirrored, and as sound as before.
  const mirrored = structuredClone(documents.ring);
  for (const { coefficients } of mirrored.operations[0].cells) coefficients.push(...coefficients.splice(0, 48).reverse(), ...coefficients.splice(0, 16));
  const flipped = structuredClone(documents.cell);
  const [cell] = flipped.operations[0].cells;
  cell.coefficients = [3, 2, 1, 0].flatMap((i) => cell.coefficients.slice(16 * i, 16 * i + 16));
  const [turned] = dx.hyperpatch(flipped).verdicts();
  assert.deepEqual([turned.verdict, turned.mirrored], ["regular", true]);
  near(dx.hyperpatch(flipped).volume(), -8, 1e-6);
});

test("volume and amounts are exact", () => {
  near(body("cell").volume(), 8, 1e-6);
  // Half and half: the smoothstep is even about the middle.
  body("cell").amounts().forEach((amount) => near(amount, 4, 1e-6));
  const ring = body("ring");
  // Three pi, but for the cubic that stands for an arc of 45 degrees: the radius is too large by at most 4.2e-6 of it.
  assert.ok(Math.abs(ring.volume() / (3 * Math.PI) - 1) < 1e-5);
  near(ring.amounts().reduce((sum, amount) => sum + amount, 0), ring.volume(), 1e-9);
  near(ring.cells.reduce((sum, { volume }) => sum + volume, 0), ring.volume(), 1e-9);
});

test("samples, probes and grids agree", () => {
  const twisted = body("twisted");
  const { position, mix } = twisted.sample(0, [0.2, 0.7, 0.3]);
  near(mix[1], 3 * 0.3 ** 2 - 2 * 0.3 ** 3);
  const found = twisted.probe(position);
  assert.ok(found && found.cell === 0);
  found.uvw.forEach((t, axis) => near(t, [0.2, 0.7, 0.3][axis]));
  assert.equal(twisted.probe([9, 0, 0]), null);
  assert.equal(body("block").probe([1, 0.5, 0.5])?.cell, 0, "on a common face the lowest number answers");
  const grid = twisted.grid(0, [3, 11, 11]);
  const at = (1 * 11 + 2) * 11 + 4;
  const expected = twisted.sample(0, [0.5, 0.2, 0.4]);
  near(grid.x[at], expected.position[0], 1e-6);
  near(grid.z[at], expected.position[2], 1e-6);
  near(grid.fractions[1][at], expected.mix[1], 1e-6);
});

test("sections lie in their plane, have their area and their material", () => {
  const block = body("block");
  const section = block.section({ normal: [0, 0, 2], point: [0, 0, 0.4] });
  near(section.area, 4, 1e-9);
  near(block.section({ normal: [1, 1, 1], offset: 3 }).area, 3 * Math.sqrt(3), 1e-9);
  assert.ok(section.positions.every((z, n) => n % 3 !== 2 || Math.abs(z - 0.4) < 1e-6));
  assert.deepEqual(section.patches.map(({ cell }) => cell), [0, 2, 4, 6]);
  for (const { cell, vertexStart, vertexCount } of section.patches) {
    assert.ok(section.cells.subarray(vertexStart, vertexStart + vertexCount).every((id) => id === cell));
  }
  const [u, v, w] = section.parameters.subarray(30, 33);
  const { mix } = block.sample(section.cells[10], [u, v, w]);
  mix.forEach((fraction, k) => near(fraction, section.fractions[10 * mix.length + k], 1e-6));
  const outline = [...section.outline].map((vertex) => [...section.positions.subarray(3 * vertex, 3 * vertex + 2)]);
  assert.ok(outline.every((point) => point.some((x) => [0, 1, 2].some((line) => Math.abs(x - line) < 1e-6))));
  assert.equal(block.section({ normal: [0, 0, 1], offset: 5 }).indices.length, 0);
});

/** Six times the volume inside triangles. @param {Float32Array} positions @param {Uint32Array} indices */
function enclosed(positions, indices) {
  let sum = 0;
  for (let n = 0; n < indices.length; n += 3) {
    const [[a, b, c], [d, e, f], [g, h, i]] = [0, 1, 2].map((k) => positions.subarray(3 * indices[n + k], 3 * indices[n + k] + 3));
    sum += a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g);
  }
  return sum;
}

test("the surface encloses the volume, with normals outwards, curves and corners", () => {
  const ring = body("ring");
  const surface = ring.surface({ tolerance: 1e-4 });
  assert.ok(surface.deviation <= 1e-4);
  near(enclosed(surface.positions, surface.indices) / 6, ring.volume(), 2e-3);
  assert.equal(surface.patches.length, 32);
  assert.deepEqual(new Set(surface.patches.map(({ face }) => face)), new Set(["v0", "v1", "w0", "w1"]));
  for (const { face, vertexStart, vertexCount } of surface.patches) {
    for (let n = vertexStart; n < vertexStart + vertexCount; n++) {
      const [[x, y], [p, q, r]] = [surface.positions.subarray(3 * n, 3 * n + 2), surface.normals.subarray(3 * n, 3 * n + 3)];
      near(Math.hypot(p, q, r), 1, 1e-6);
      if (face === "w1") near(r, 1, 1e-6);
      if (face === "v0") assert.ok(x * p + y * q > 1.99, "outwards at the outer radius");
      if (face === "v1") assert.ok(x * p + y * q < -0.99, "towards the axis at the inner radius");
    }
  }
  // Eight cells with 4 curves round and 4 across each; those across are shared by two.
  assert.deepEqual([surface.edges.length, surface.corners.length], [64, 32]);
  for (const { axis, cells, start, count } of surface.edges) {
    assert.equal(cells, axis === "u" ? 1 : 2);
    for (let n = start; n < start + count && axis === "u"; n++) {
      const radius = Math.hypot(surface.edgePositions[3 * n], surface.edgePositions[3 * n + 1]);
      assert.ok(Math.min(Math.abs(radius - 1), Math.abs(radius - 2)) < 1e-4);
    }
  }
  assert.ok(surface.corners.every(({ cells, position: [x, y] }) => cells === 2 && [1, 2].some((r) => Math.abs(Math.hypot(x, y) - r) < 1e-6)));
  const [red, green, blue, alpha] = surface.colors.subarray(0, 4);
  assert.ok(alpha === 255 && [red, green, blue].some((part) => part > 0));
  // Each cell with its own six faces is closed, so that together they enclose the same volume.
  const whole = ring.surface({ tolerance: 1e-4, faces: "all" });
  assert.equal(whole.patches.length, 48);
  assert.deepEqual(whole.patches.slice(0, 32).map(({ cell, face }) => [cell, face]), surface.patches.map(({ cell, face }) => [cell, face]));
  near(enclosed(whole.positions, whole.indices) / 6, ring.volume(), 2e-3);
});

test("cells of a body: what they share, how they continue, how they lie", () => {
  const [face] = body("pair").continuity().faces;
  assert.deepEqual(face.sides, [{ cell: 0, face: "u1" }, { cell: 1, face: "u0" }]);
  assert.deepEqual([face.shape, face.material, face.swapped, face.reversed], ["C0", "none", false, [false, false]]);
  assert.deepEqual(face.corners.map(({ corner, shape, material }) => [`${corner}`, shape, material]), [
    ["1,0,0", "C1", "none"],
    ["1,0,1", "C0", "C1"],
    ["1,1,0", "C1", "C1"],
    ["1,1,1", "C0", "C0"],
  ]);
  assert.deepEqual(body("pair").relations(), [{ cells: [0, 1], relation: "shares", faces: 1, edges: 0, corners: 0 }]);
  const sharing = body("block").sharing();
  assert.deepEqual([sharing.corners.length, sharing.edges.length, sharing.faces.length], [27, 54, 36]);
  assert.deepEqual(sharing.shared, { corners: 19, edges: 30, faces: 12 });
  assert.equal(sharing.corners.find(({ position }) => position.every((x) => x === 1))?.sides.length, 8);
  assert.equal(body("block").relations().length, 28, "each of the eight meets every other one");
  // The second cell half a cell to the left: they overlap, and a point shows it.
  const moved = structuredClone(documents.pair);
  for (const coefficient of moved.operations[0].cells[1].coefficients) coefficient.position[0] -= 0.5;
  const lying = dx.hyperpatch(moved);
  const { worst, pairs: [pair], sumError } = lying.summary();
  assert.ok(pair.relation === "overlaps" && pair.point && pair.at && worst && sumError === 0);
  pair.at.forEach((at, n) => lying.sample(n, /** @type {any} */ (at)).position.forEach((x, axis) => near(x, pair.point?.[axis] ?? NaN)));
  assert.match(describeBody(lying.summary()), /^2 cells, all regular, 1 pair overlapping, materials sum to 1$/);
  // A face raised at two corners: contact at the others, with its gap.
  const parted = structuredClone(documents.block);
  for (const at of [2, 3, 6, 7, 10, 11, 14, 15]) parted.operations[0].cells[4].coefficients[at].position[0] += 0.1;
  const [contact] = dx.hyperpatch(parted).continuity().contacts;
  assert.deepEqual(contact.corners.map(String), ["1,0,0", "1,1,0"]);
  near(contact.gap, 0.1);
});

test("what is wrong is named by code and path", () => {
  const without = (/** @type {(document: any) => void} */ edit) => {
    const document = structuredClone(documents.cell);
    edit(document);
    return refusal(() => dx.hyperpatch(document));
  };
  const first = "operations[0].cells[0].coefficients";
  const on = (/** @type {any} */ document) => document.operations[0].cells[0].coefficients;
  assert.deepEqual(without((d) => on(d).pop()), { code: "range", path: first });
  assert.deepEqual(without((d) => (on(d)[5].position[1] = NaN)), { code: "non-finite", path: `${first}[5].position[1]` });
  assert.deepEqual(without((d) => (on(d)[7].mix = [0.7, 0.7])), { code: "range", path: `${first}[7].mix` });
  assert.deepEqual(without((d) => (on(d)[7].mix = [1, 0, 0])), { code: "limit", path: `${first}[7].mix` });
  assert.deepEqual(without((d) => (d.operations[0].op = "melt")), { code: "range", path: "operations[0].op" });
  assert.deepEqual(without((d) => (d.directrix = 2)), { code: "version", path: "directrix" });
  assert.deepEqual(without((d) => (d.kind = "part")), { code: "kind", path: "kind" });
  assert.deepEqual(without((d) => (d.kind = "curves")), { code: "kind", path: "kind" });
  for (const ask of /** @type {const} */ (["match", "defaults", "solid", "amounts"])) {
    assert.deepEqual(refusal(() => dx[ask](documents.cell)), { code: "kind", path: "kind" }, ask);
  }
  const cell = body("cell");
  const any = (/** @type {any} */ value) => value;
  assert.deepEqual(refusal(() => cell.sample(1, [0, 0, 0])), { code: "range", path: "cell" });
  assert.deepEqual(refusal(() => cell.sample(0, [0, 0, 2])), { code: "range", path: "at[2]" });
  assert.deepEqual(refusal(() => cell.probe([0, NaN, 0])), { code: "non-finite", path: "point[1]" });
  assert.deepEqual(refusal(() => cell.section({ normal: [0, 0, 0] })), { code: "range", path: "options.normal" });
  assert.deepEqual(refusal(() => cell.section({ normal: [0, 0, 1] }, { steps: 65 })), { code: "limit", path: "options.steps" });
  assert.deepEqual(refusal(() => cell.section({ normal: [0, 0, 1], offset: 1, point: [0, 0, 0] })), { code: "range", path: "options.offset" });
  assert.deepEqual(refusal(() => cell.surface({ tolerance: 0 })), { code: "range", path: "options.tolerance" });
  assert.deepEqual(refusal(() => cell.surface(any({ tolerence: 1 }))), { code: "unknown-field", path: "options.tolerence" });
  assert.deepEqual(refusal(() => cell.surface(any({ faces: "inner" }))), { code: "range", path: "options.faces" });
  assert.deepEqual(refusal(() => cell.grid(0, [1, 4, 4])), { code: "range", path: "counts[0]" });
  assert.deepEqual(refusal(() => cell.grid(0, [512, 512, 512])), { code: "limit", path: "counts" });
  assert.deepEqual(refusal(() => cell.file(any({ format: "step" }))), { code: "range", path: "options.format" });
});

test("a body without cells has answers", () => {
  const empty = dx.hyperpatch({ directrix: 1, kind: "hyperpatch", operations: [] });
  assert.deepEqual([empty.cells, empty.verdicts(), empty.relations(), empty.volume()], [[], [], [], 0]);
  assert.equal(empty.surface().indices.length + empty.section({ normal: [1, 0, 0] }).indices.length, 0);
  assert.equal(empty.probe([0, 0, 0]), null);
  assert.equal(describeBody(empty.summary()), "No cell yet");
  assert.match(new TextDecoder().decode(empty.file({ format: "vtu" })), /NumberOfCells="0"/);
});

test("the module of figures says where hyperpatches are", async () => {
  const figure = await load({ module: "figure" });
  assert.deepEqual(refusal(() => figure.hyperpatch(documents.cell)), { code: "not-in-module", path: "" });
  assert.deepEqual(refusal(() => figure.match(documents.cell)), { code: "kind", path: "kind" });
});

test("in turns, each is short, the answer is the same, and one that is not wanted ends", async () => {
  /** @param {string} question @param {object} rest @param {() => boolean} [isWanted] */
  const asked = (question, rest, isWanted = () => true) =>
    inTurns(dx, { name: "hyperpatch", args: [{ ...documents.ring, title: "in turns" }, { question, rest }] }, { isWanted, onprogress: () => {} });
  const surface = await asked("surface", { options: { tolerance: 1e-5 } });
  const { id, ...whole } = body("ring").surface({ tolerance: 1e-5 });
  assert.deepEqual(surface?.value, { ...whole, id: surface?.value.id });
  assert.notEqual(id, surface?.value.id);
  assert.equal((await asked("probe", { point: [0, 0, 0] }))?.value, null);
  assert.equal(await asked("surface", { options: { tolerance: 1e-7 } }, () => false), null);
  const job = dx.job(documents.ring, { hyperpatch: { question: "surface", rest: { options: { tolerance: 1e-6 } } } });
  let turns = 0;
  for (; !job.step(0).done; turns++);
  assert.ok(turns > 64, `${turns} turns: one a face at least`);
  assert.equal(job.step(0), job.step(0), "a job that is done stays so");
});

test("files hold the surface", () => {
  const ring = body("ring");
  const surface = ring.surface();
  const [vertices, triangles] = [surface.positions.length / 3, surface.indices.length / 3];
  const stl = ring.file({ format: "stl" });
  assert.equal(new DataView(stl.buffer).getUint32(80, true), triangles);
  assert.equal(stl.length, 84 + 50 * triangles);
  const ply = ring.file({ format: "ply" });
  const head = new TextDecoder().decode(ply).split("end_header\n")[0];
  assert.match(head, new RegExp(`element vertex ${vertices}\n`));
  // x, y, z, three bytes of colour, two fractions.
  const at = head.length + "end_header\n".length + 23 * 100;
  const row = new DataView(ply.buffer, at, 23);
  [0, 1, 2].forEach((axis) => near(row.getFloat32(4 * axis, true), surface.positions[300 + axis]));
  [0, 1, 2].forEach((part) => assert.equal(row.getUint8(12 + part), surface.colors[400 + part]));
  [0, 1].forEach((k) => near(row.getFloat32(15 + 4 * k, true), surface.fractions[200 + k], 1e-6));
  const obj = new TextDecoder().decode(ring.file({ format: "obj" }));
  assert.equal(obj.match(/^v /gm)?.length, vertices);
  assert.equal(obj.match(/^f /gm)?.length, triangles);
});

/**
 * Parameters of the 64 points of a Lagrange hexahedron of order 3 in VTK's order, from its description (VTK File Formats; the class
 * vtkHigherOrderHexahedron of VTK 9.1 and later): corners as in a linear hexahedron, then two points on each edge in the order of the quadratic
 * hexahedron, edges along an axis running upwards; then the faces -i, +i, -j, +j, -k, +k, and the inside, the first free axis fastest.
 */
function vtkPlaces() {
  const corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];
  const ends = [[0, 1], [1, 2], [3, 2], [0, 3], [4, 5], [5, 6], [7, 6], [4, 7], [0, 4], [1, 5], [2, 6], [3, 7]];
  const thirds = [1 / 3, 2 / 3];
  const edges = ends.flatMap(([a, b]) => thirds.map((t) => corners[a].map((x, axis) => x + t * (corners[b][axis] - x))));
  const faces = [0, 1, 2].flatMap((axis) =>
    [0, 1].flatMap((end) =>
      thirds.flatMap((second) =>
        thirds.map((first) => {
          const free = [first, second];
          return [0, 1, 2].map((n) => (n === axis ? end : /** @type {number} */ (free.shift())));
        }),
      ),
    ),
  );
  const inside = thirds.flatMap((w) => thirds.flatMap((v) => thirds.map((u) => [u, v, w])));
  return [...corners, ...edges, ...faces, ...inside];
}

test("a grid of VTK holds the cells exactly, read by its own rules", () => {
  const twisted = body("twisted");
  const document = structuredClone(documents.pair);
  document.materials[1].name = 'a "b" <c> & d';
  const pair = dx.hyperpatch(document);
  for (const [read, names] of /** @type {const} */ ([[twisted, ["polymer", "titanium"]], [pair, ["polymer", "a &quot;b&quot; &lt;c&gt; &amp; d", "ceramic"]]])) {
    const text = new TextDecoder().decode(read.file({ format: "vtu" }));
    assert.match(text, /<VTKFile type="UnstructuredGrid" version="2.2"/);
    const array = (/** @type {string} */ name) => {
      const found = [...text.matchAll(/<DataArray type="\w+" Name="([^"]*)"[^>]*>([^<]*)<\/DataArray>/g)].find(([, own]) => own === name);
      assert.ok(found, name);
      return found[2].trim().split(/\s+/).map(Number);
    };
    const [points, connectivity, offsets, types] = ["Points", "connectivity", "offsets", "types"].map(array);
    assert.deepEqual([offsets.length, offsets.at(-1)], [read.cells.length, 64 * read.cells.length]);
    assert.ok(types.every((type) => type === 72));
    read.cells.forEach(({ id }, n) => {
      vtkPlaces().forEach((at, k) => {
        const point = connectivity[64 * n + k];
        const { position, mix } = read.sample(id, /** @type {any} */ (at));
        position.forEach((x, axis) => near(points[3 * point + axis], x, 1e-12));
        mix.forEach((fraction, m) => near(array(names[m])[point], fraction, 1e-12));
      });
    });
  }
});
