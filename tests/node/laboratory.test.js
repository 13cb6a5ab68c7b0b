/** What the solver laboratory computes beside the kernel: meshes, STL, pixels, sections, edits, accuracy, slopes. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { load } from "directrix";
import { faceOf, planeOf as sectionOf, shapeOf } from "../../js/element/problem/picture.js";
import { resultOf } from "../../js/element/problem/problem-scene.js";
import { root } from "../../scripts/lib/paths.mjs";
import { innerOf, lattice } from "../../www/src/laboratory/accuracy.js";
import { csvOf } from "../../www/src/laboratory/compare/csv.js";
import { greatest, slopeOf } from "../../www/src/laboratory/compare/runs.js";
import { addGroup, addMaterial, byOf, changeMaterial, chosenBy, conditionOf, kindOf, removeMaterial, withFlux, withGroup, withModel, withRest } from "../../www/src/laboratory/edits.js";
import { listOf, textOf } from "../../www/src/laboratory/formula-field.js";
import { boundsOf, countOf, grown, jointsOf, normalOf, rimOf, runsOf, soupOf } from "../../www/src/laboratory/mesh.js";
import { inSize, isNamed, modelOf, MODELS } from "../../www/src/laboratory/models.js";
import { colorsOf, grown as spread, levelLines } from "../../www/src/laboratory/pixels.js";
import { acrossOf, faceFrame, flipped, pixelsOf, placed, placeOf, planeOf, through } from "../../www/src/laboratory/section-state.js";

const dx = await load();
/** @param {string} name @returns {Promise<any>} */
const preset = async (name) => JSON.parse(await readFile(join(root, `www/presets/laplace/${name}.json`), "utf8"));
const cube = await preset("cube");
/** @param {unknown} document */
const boundaryOf = (document) => dx.boundary(/** @type {any} */ (document));
const boundary = boundaryOf(cube);

test("a cube has its normals, its edges once, and patches that end at its edges", () => {
  assert.equal(countOf(boundary), 768);
  assert.deepEqual(boundsOf(boundary), { min: [0, 0, 0], max: [1, 1, 1] });
  const joints = jointsOf(boundary);
  // Every edge of a closed surface of triangles is one of two of them.
  assert.equal(joints.size, (3 * 768) / 2);
  assert.ok([...joints.values()].every(({ elements }) => elements.length === 2));
  const top = boundary.members.indexOf(0);
  assert.deepEqual(normalOf(boundary, top).map((value) => value + 0), [0, 0, 1]);
  const patch = grown(boundary, joints, top, 10);
  assert.equal(patch.length, 128);
  assert.ok(patch.every((element) => boundary.members[element] === 0));
  assert.equal(grown(boundary, joints, top, 95).length, 768);
  // The rim of a face is its four sides, eight edges each.
  assert.equal(rimOf(joints, (element) => boundary.members[element] === 0).length, 6 * 32);
  assert.deepEqual(runsOf([0, 1, 2, 5, 7, 8]), [[0, 2], [5, 5], [7, 8]]);
  const { positions, normals, indices } = soupOf(boundary);
  assert.deepEqual([positions.length, normals.length, indices.length], [9 * 768, 9 * 768, 3 * 768]);
});

test("pixels have the colours of the materials, are grown beyond their edge, and have lines of equal fraction", () => {
  const materials = [{ color: "#ff0000" }, { color: "#0000ff" }];
  const values = [Float32Array.of(1, 0, NaN, 0.5), Float32Array.of(0, 1, NaN, 0.5)];
  const pixels = colorsOf({ size: [2, 2], values }, materials);
  assert.deepEqual([...pixels.slice(0, 8)], [255, 0, 0, 255, 0, 0, 255, 255]);
  assert.equal(pixels[11], 0);
  assert.deepEqual([...colorsOf({ size: [2, 2], values }, materials, true).slice(8, 12)], [255, 0, 0, 255]);
  assert.equal(spread(pixels, [2, 2], 1)[11], 255);
  // Across a ramp along x the line of one half stands in the middle, along all rows.
  const ramp = Float32Array.from({ length: 25 }, (_, n) => (n % 5) / 4);
  const lines = levelLines(ramp, [5, 5], 0.375);
  assert.equal(lines.length, 4 * 4);
  for (let k = 0; k < lines.length; k += 2) assert.equal(lines[k], 1.5);
  // Of a saddle two lines go through one square and never cross.
  assert.equal(levelLines([1, 0, 0, 1], [2, 2], 0.5).length, 8);
  assert.equal(levelLines([1, NaN, 0, 1], [2, 2], 0.5).length, 0);
});

test("a section moves along its way, within the body, and its face holds the body", () => {
  const section = through([0, 2, 0], [0.5, 0.5, 0.5]);
  assert.deepEqual([acrossOf(undefined), acrossOf(section), acrossOf(through([1, 1, 0], [0, 0, 0]))], ["off", "y", "own"]);
  assert.equal(placeOf(section), 0.5);
  assert.equal(placeOf(placed(section, 7, [0, 1])), 1);
  assert.deepEqual(planeOf(flipped(section)), { normal: [0, -1, 0], offset: -0.5 });
  const { positions } = soupOf(boundary);
  const { origin, sides } = faceFrame(planeOf(section), positions);
  assert.equal(origin[1], 0.5);
  assert.deepEqual(sides.map((side) => Math.round(1e6 * Math.hypot(...side)) / 1e6), [1, 1]);
  assert.deepEqual(pixelsOf([[2, 0, 0], [0, 1, 0]], 100), [100, 50]);
});

test("edits keep what they can, and make documents that the kernel reads", () => {
  const added = addGroup(cube, "side");
  assert.ok(boundaryOf(added).sets.some(({ name }) => name === "side"));
  assert.equal(withGroup(cube, 0, { name: "top" }), cube);
  assert.equal(withRest(cube, cube.rest), cube);
  const without = withRest(cube, null);
  assert.deepEqual(boundaryOf(without).diagnostics.map(({ code, count }) => [code, count]), [["missing", 512]]);
  // A problem in the plane has the height of that in space, and no section.
  const square = withModel(cube, modelOf("square"));
  assert.equal("section" in square, false);
  assert.deepEqual(square.groups.map(({ where }) => where.direction), [[0, 1], [0, -1]]);
  assert.ok(boundaryOf(square).ready);
  assert.deepEqual(withModel(square, modelOf("cube")).groups.map(({ where }) => where.direction), [[0, 0, 1], [0, 0, -1]]);
  assert.deepEqual([kindOf({ value: [1, 0] }), kindOf({ flux: [0, 0] }), kindOf({ flux: [1, -1] })], ["value", "insulated", "flux"]);
  assert.deepEqual(conditionOf(cube, { value: [1, 0] }, "flux"), { flux: [1, -1] });
  assert.deepEqual(withFlux([1, -1, 0], 0, 0.25), [0.25, -1, 0.75]);
  assert.deepEqual(withFlux([1, -1], 1, 0.5), [-0.5, 0.5]);
  const three = addMaterial(cube);
  assert.deepEqual([three.materials.length, three.groups[1].condition, three.rest], [3, { value: [0.5, 0.5, 0] }, { value: [0, 1, 0] }]);
  assert.ok(boundaryOf(three).ready);
  assert.deepEqual(removeMaterial(three, 2), cube);
  assert.equal(removeMaterial(three, 0), three);
  assert.equal(changeMaterial(cube, 0, { name: cube.materials[0].name }), cube);
  assert.equal(byOf(chosenBy({ positive: "x" }, "both", boundsOf(boundary), 3)), "both");
  assert.deepEqual(listOf("1 - max(x, y), 0.5"), ["1 - max(x, y)", 0.5]);
  assert.equal(textOf(listOf("1 - r, r")), "1 - r, r");
});

test("every body of the list is one that the kernel makes, in every size of its series", () => {
  for (const [kind, { dimension, sizes }] of Object.entries(MODELS)) {
    const model = modelOf(kind);
    assert.ok(isNamed(model));
    let last = 0;
    for (const size of sizes.values) {
      const made = dx.boundary({ ...cube, section: undefined, groups: [], model: /** @type {any} */ (inSize(model, size)) });
      assert.deepEqual([made.dimension, made.ready], [dimension, true], kind);
      assert.ok(countOf(made) > last, `${kind} ${size}`);
      last = countOf(made);
    }
  }
});

test("errors are looked for about a cell away from the boundary, where they fall with the elements", () => {
  const { points, size } = lattice(3, boundsOf(boundary));
  assert.deepEqual([size, points.length], [[15, 15, 15], 3 * 15 ** 3]);
  assert.equal(innerOf(size, () => true).length, 13 ** 3);
  assert.equal(innerOf([4, 4], (n) => n !== 0).length, 3);
  assert.deepEqual(innerOf([3, 3], (n) => n === 4), []);
});

test("curves of residuals are those of the worst material, slopes those of lines, and files keep every digit", () => {
  assert.deepEqual(greatest([[1, 0.5], [0.9, 0.6, 0.1]]), [1, 0.6, 0.5]);
  assert.deepEqual(greatest([[], [1]]), [1]);
  const slope = slopeOf([10, 100, 1000].map((x) => ({ x, y: 3 * x ** -1.4 })));
  assert.ok(slope !== null && Math.abs(slope + 1.4) < 1e-12);
  assert.equal(slopeOf([{ x: 1, y: 1 }, { x: 2, y: 0 }]), null);
  assert.equal(csvOf([["a,b", 'c"d'], [0.1, 1e-7]]), '"a,b","c""d"\n0.1,1e-7\n');
});

test("a figure has the boundary in the colours of its conditions, and the solution on its section within the body", async () => {
  const { conditions, dimension, elements, groups, vertices, composition, solver } = boundary;
  const solution = dx.solveLaplace({ conditions, dimension, elements, groups, vertices, composition, solver });
  const remote = /** @type {any} */ ({ section: async (/** @type {any} */ frame) => solution.section(frame) });
  const shape = shapeOf(boundary, cube.materials);
  assert.deepEqual(shape.bounds, { min: [0, 0, 0], max: [1, 1, 1] });
  assert.equal(shape.labs.length, 9 * 768);
  const plane = sectionOf(cube);
  assert.deepEqual(plane, { normal: [0, 1, 0], offset: 0.5 });
  const { section, labs } = await faceOf(remote, { boundary, materials: cube.materials, plane }, 24, {});
  // Every pixel of the square is inside: two triangles each, and the four sides of the cut as lines.
  assert.equal(section.indices.length, 6 * 24 * 24);
  assert.equal(labs.length, section.positions.length);
  assert.ok(section.outline.length >= 2 * 4 * 8);
  for (let k = 0; k < section.positions.length; k += 3) assert.ok(Math.abs(section.positions[k + 1] - 0.5) < 1e-6 && section.positions[k] > -1e-6 && section.positions[k + 2] < 1 + 1e-6);
  const told = resultOf(cube, boundary, /** @type {any} */ (solution));
  assert.equal(told.ok, true);
  assert.equal(told.text, `Cube: Section of a solution in space, 768 triangles, solved, ${solution.iterations[0]} iterations.`);
  const faulty = resultOf(cube, boundaryOf(withRest(cube, null)), null);
  assert.deepEqual([faulty.ok, faulty.diagnostics], [false, ["missing"]]);
});
