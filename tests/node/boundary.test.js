/** Documents of boundary value problems: presets against what is known, diagnostics, meshes from files, over the turns of a worker. */
import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { DirectrixError, load } from "directrix";
import { inTurns } from "../../js/turns.js";
import { root } from "../../scripts/lib/paths.mjs";
import { PRESETS } from "../../www/src/laboratory/preset-words.js";

/** @import { LaplaceBoundary, LaplaceDocument } from "directrix" */

const dx = await load();
/** @param {string} name @returns {Promise<any>} */
const preset = async (name) => JSON.parse(await readFile(join(root, `www/presets/laplace/${name}.json`), "utf8"));
const cube = /** @type {LaplaceDocument} */ (await preset("cube"));

/** What `solveLaplace` takes of a boundary. @param {LaplaceBoundary} boundary */
const input = ({ dimension, vertices, elements, groups, conditions, composition, solver }) => ({ dimension, vertices, elements, groups, conditions, composition, solver });

/** @param {() => unknown} call @param {string} code @param {string} path */
function refused(call, code, path) {
  assert.throws(call, (error) => error instanceof DirectrixError && error.message.length > 0 && assert.deepEqual([error.code, error.path], [code, path]) === undefined);
}

test("a boundary goes to the solver as it is, and its exact solution is met", () => {
  const boundary = dx.boundary(cube);
  assert.deepEqual([boundary.dimension, boundary.elements.length, boundary.exact, boundary.ready], [3, 3 * 768, "cube", true]);
  assert.deepEqual(boundary.names, ["top", "bottom", "rest"]);
  assert.deepEqual(boundary.sets.map(({ name, known, count }) => [name, known, count]), [["top", "value", 128], ["bottom", "value", 128], ["rest", "value", 512]]);
  boundary.measures.forEach((area, k) => assert.ok(Math.abs(area - [1, 1, 4][k]) < 1e-12));
  assert.deepEqual(boundary.solver, { method: "gmres", preconditioner: "jacobi", restart: 100, tolerance: 1e-6, maxIterations: 500, condition: false, dense: 8000 });
  assert.deepEqual([boundary.diagnostics, boundary.groups], [[], boundary.members]);
  const solution = dx.solveLaplace(input(boundary));
  const points = [0.1, 0.25, 0.5, 0.75, 0.9].flatMap((z) => [0.5, 0.5, z]);
  const known = [0.39762453840464, 0.28005981203193, 0.25, 0.48359501695147, 0.769167292367583];
  const exact = dx.exact(cube, points);
  const { values } = solution.at(points);
  known.forEach((value, k) => {
    assert.ok(Math.abs(exact[2 * k] - value) < 1e-12 && Math.abs(exact[2 * k + 1] - 1 + value) < 1e-12);
    assert.ok(Math.abs(values[2 * k] - value) < 4e-3);
  });
});

test("every preset can be solved", async () => {
  const names = (await readdir(join(root, "www/presets/laplace"))).map((file) => file.replace(/\.json$/, ""));
  assert.deepEqual(names.sort(), PRESETS.map(({ file }) => file).sort(), "each stands in the list");
  for (const name of names) {
    const boundary = dx.boundary(await preset(name));
    assert.deepEqual([boundary.ready, boundary.diagnostics], [true, []], name);
    assert.equal(boundary.groups.length, boundary.elements.length / boundary.dimension);
    if (boundary.groups.length < 800) assert.ok(dx.solveLaplace(input(boundary)).converged, name);
  }
  const { conditions, names: own, sets } = dx.boundary(await preset("cylinder"));
  assert.ok(conditions.length > sets.length && own.filter((name) => name === "top").length > 5, "an expression has numbers of its own");
});

test("what is missing, twice there or open is said with its place, and solving refuses it", () => {
  const { rest: _, ...bare } = cube;
  const missing = dx.boundary(/** @type {LaplaceDocument} */ (bare));
  const [{ code, remark, count, element = -1, place = [], path }] = missing.diagnostics;
  assert.deepEqual([code, remark, count, path, missing.ready, missing.exact], ["missing", false, 512, "rest", false, null]);
  assert.equal(missing.groups[element], missing.conditions.length);
  assert.equal(place.length, 3);
  refused(() => dx.solveLaplace(input(missing)), "range", `groups[${element}]`);
  const groups = [...(cube.groups ?? []), { name: "all", where: { positive: "1" }, condition: { value: [0, 1] } }];
  const twice = dx.boundary({ ...cube, groups });
  assert.deepEqual(twice.diagnostics.map(({ code, path }) => [code, path]), [["conflict", "groups[2].where"], ["conflict", "groups[2].where"]]);
  const typed = dx.boundary({ ...cube, rest: { value: ["2 * ", 0] } });
  assert.deepEqual(typed.diagnostics.map(({ code, path, character }) => [code, path, character]), [["expression", "rest.value[0]", 4]]);
});

/** An STL file of a tetrahedron, as text. @param {number} faces */
function tetrahedron(faces) {
  const corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
  const facet = (/** @type {number[]} */ face) => `facet normal 0 0 0\nouter loop\n${face.map((k) => `vertex ${corners[k].join(" ")}\n`).join("")}endloop\nendfacet\n`;
  const text = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]].slice(0, faces).map(facet).join("");
  return new TextEncoder().encode(`solid t\n${text}endsolid t\n`);
}

test("a mesh from a file is a model, and an open one says where", () => {
  const triples = (/** @type {ArrayLike<number>} */ list) => Array.from({ length: list.length / 3 }, (_, n) => /** @type {[number, number, number]} */ (Array.from(list).slice(3 * n, 3 * n + 3)));
  const of = (/** @type {Uint8Array} */ bytes) => {
    const { vertices, triangles } = dx.readMesh(bytes);
    return { ...cube, model: { kind: /** @type {const} */ ("mesh"), vertices: triples(vertices), triangles: triples(triangles) }, groups: [] };
  };
  const whole = tetrahedron(4);
  const { dropped, format, triangles } = dx.readMesh(/** @type {ArrayBuffer} */ (whole.buffer));
  assert.deepEqual([dropped, format, triangles.length], [0, "text", 12]);
  const boundary = dx.boundary(of(whole));
  assert.deepEqual([boundary.ready, boundary.exact, boundary.vertices.length], [true, "constant", 12]);
  refused(() => dx.boundary(of(tetrahedron(3))), "range", "model.triangles");
  const five = of(whole);
  five.model.triangles.push([3, 1, 0]);
  five.model.triangles[0] = [3, 0, 1];
  const [fault] = dx.boundary(five).diagnostics;
  assert.ok(["open", "meeting"].includes(fault.code) && fault.element !== undefined && fault.place?.length === 3, fault.code);
  refused(() => dx.readMesh(whole.slice(0, 200)), "syntax", "line 17");
  refused(() => dx.readMesh(new Uint8Array(100)), "syntax", "");
  refused(() => dx.readMesh(/** @type {any} */ ("solid")), "type", "bytes");
});

test("a connection gives the same in short turns", async () => {
  const shares = /** @type {number[]} */ ([]);
  const ask = async (/** @type {"boundary" | "exact" | "readMesh"} */ name, /** @type {any[]} */ ...args) =>
    (await inTurns(dx, { name, args }, { isWanted: () => true, onprogress: (share) => shares.push(share) }))?.value;
  const fresh = { ...cube, title: "in turns", model: { kind: "cube", divisions: 40 } };
  assert.deepEqual(await ask("boundary", fresh), dx.boundary(/** @type {any} */ (fresh)));
  assert.ok(shares.every((share) => share >= 0 && share < 1));
  const points = Array.from({ length: 900 }, (_, k) => 0.05 + 0.9 * ((k * 0.618) % 1));
  assert.deepEqual(await ask("exact", fresh, points), dx.exact(/** @type {any} */ (fresh), points));
  assert.deepEqual(await ask("readMesh", tetrahedron(4)), dx.readMesh(tetrahedron(4)));
});

test("points outside, problems without a known solution and other kinds are refused", async () => {
  refused(() => dx.exact(cube, [0.5, 0.5, 0.5, 0.5, 0.5, 1.5]), "outside", "points[1]");
  refused(() => dx.exact(cube, [0.5, 0.5]), "range", "points");
  refused(() => dx.exact(cube, [0.5, 0.5, Number.NaN]), "range", "points[0]");
  refused(() => dx.exact(cube, /** @type {any} */ (undefined)), "type", "points");
  const box = await preset("hollow-box");
  refused(() => dx.exact(box, [0.02, 0.5, 0.5]), "no-exact", "model");
  refused(() => dx.boundary(/** @type {any} */ ({ ...cube, kind: "part" })), "kind", "kind");
  refused(() => dx.boundary(/** @type {any} */ ({ ...cube, kind: "heat" })), "range", "kind");
  for (const ask of /** @type {const} */ (["match", "part", "hyperpatch"])) refused(() => dx[ask](/** @type {any} */ (cube)), "kind", "kind");
  refused(() => dx.boundary({ ...cube, model: { kind: "cube", divisions: Infinity } }), "non-finite", "model.divisions");
  const figure = await load({ module: "figure" });
  refused(() => figure.boundary(cube), "not-in-module", "");
  refused(() => figure.exact(cube, []), "not-in-module", "");
  refused(() => figure.readMesh(tetrahedron(4)), "not-in-module", "");
});
