/** Unit cells and amounts of materials as data, and what is written of them. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { load } from "directrix";
import { cellsCsv, cellsJson } from "../../www/src/cells/tables.js";

const dx = await load();
const figure = await load({ module: "figure" });

/** @param {string} name */
const preset = (name) => JSON.parse(readFileSync(new URL(`../../www/presets/${name}.json`, import.meta.url), "utf8"));

/** @param {number[]} numbers */
const sum = (numbers) => numbers.reduce((a, b) => a + b, 0);

/** The documents of a ring of a solid material in a void one, at heights. @param {number} height */
function ring(height) {
  const circle = (/** @type {number} */ radius) =>
    Array.from({ length: 24 }, (_, k) => [radius * Math.cos((k * Math.PI) / 12), radius * Math.sin((k * Math.PI) / 12)]);
  const curve = (/** @type {number} */ radius, /** @type {number[]} */ mix, /** @type {number} */ z) => ({
    ...{ degree: 3, form: "periodic", points: circle(radius), height: z, composition: [{ at: 0, mix }] },
  });
  return /** @type {any} */ ({
    ...{ directrix: 1, kind: "curves", unit: "cm", matching: { method: "exact", lines: 32 } },
    materials: [{ name: "steel", color: "#0072b2" }, { name: "air", color: "#ffffff", void: true }],
    curves: [curve(10, [1, 0], 0), curve(20, [0, 1], height)],
  });
}

test("cells tile the band, and their amounts are those of the band but for the chords", () => {
  for (const name of ["amoeba", "three-materials", "graded-strip", "small-in-large"]) {
    const document = preset(name);
    const cells = dx.cells(document);
    const amounts = dx.amounts(document);
    assert.ok(amounts, name);
    assert.equal(amounts.cells.folded, 0, name);
    assert.ok(cells.every(({ area, folded }) => area > 0 && !folded), name);
    const near = (/** @type {number} */ a, /** @type {number} */ b) => assert.ok(Math.abs(a - b) < 1e-9 * amounts.area, `${name}: ${a}, ${b}`);
    near(sum(cells.map(({ area }) => area)), amounts.cells.area);
    amounts.materials.forEach(({ amount, share }, k) => {
      near(sum(cells.map(({ area, fractions }) => area * fractions[k])), amounts.cells.amounts[k]);
      near(amount, share * amounts.area);
      assert.ok(Math.abs(amount - amounts.cells.amounts[k]) <= amounts.cells.difference, name);
    });
    near(sum(amounts.materials.map(({ amount }) => amount)), amounts.area);
    assert.ok(amounts.error < 1e-12 * amounts.area && amounts.cells.difference < 0.02 * amounts.area, name);
    for (const { corners, centroid } of cells) {
      const [xs, ys] = [0, 1].map((axis) => corners.map((corner) => corner[axis]));
      assert.ok(centroid[0] >= Math.min(...xs) && centroid[0] <= Math.max(...xs));
      assert.ok(centroid[1] >= Math.min(...ys) && centroid[1] <= Math.max(...ys));
    }
  }
});

test("empty space is counted apart, and heights are said", () => {
  const flat = dx.amounts(ring(0));
  assert.ok(flat);
  const { unit, area, body, rise, materials } = flat;
  assert.deepEqual([unit, rise, ...materials.map((each) => each.void)], ["cm", 0, false, true]);
  // The first material fades along the radius: 4/9 of the area between radii as 1 to 2.
  assert.ok(Math.abs(materials[0].share - 4 / 9) < 1e-6);
  assert.ok(Math.abs(body - materials[0].amount) < 1e-9 * area);
  assert.ok(Math.abs(area / (300 * Math.PI) - 1) < 0.03, "control points lie a little outside");
  const raised = dx.amounts(ring(7));
  assert.ok(raised && raised.rise === 7 && Math.abs(raised.area - area) < 1e-9 * area);
});

test("without a band there are no amounts, and the small module says where they are", () => {
  const { curves, ...rest } = preset("amoeba");
  assert.equal(dx.amounts({ ...rest, curves: curves.slice(1) }), null);
  assert.equal(dx.amounts(preset("letter-s")) === null, dx.cells(preset("letter-s")).length === 0);
  assert.throws(() => figure.amounts(preset("amoeba")), { code: "not-in-module" });
  assert.throws(() => figure.cells(preset("amoeba")), { code: "not-in-module" });
  assert.throws(() => dx.amounts(/** @type {any} */ ({ directrix: 1 })), { name: "DirectrixError" });
});

test("tables name units, tell equal names apart, and come back digit for digit", () => {
  const document = preset("three-materials");
  const [cells, amounts] = [dx.cells(document), dx.amounts(document)];
  assert.ok(amounts);
  const names = ['glass, "clear"', "steel", "steel"];
  const [head, ...rows] = cellsCsv(cells, names, "µm").trimEnd().split("\n");
  assert.ok(head.startsWith("line,stage,x1 [µm],y1 [µm],"));
  assert.ok(head.endsWith(',area [µm²],centroid x [µm],centroid y [µm],folded,"glass, ""clear""",steel,steel 2'));
  assert.deepEqual(
    rows.map((row) => row.split(",").map((cell, k) => (k === 13 ? cell === "true" : Number(cell)))),
    cells.map(({ line, stage, corners, area, centroid, folded, fractions }) => [
      ...[line, stage, ...corners.flat(), area, ...centroid, folded, ...fractions],
    ]),
  );
  assert.ok(cellsCsv(cells, names, "").startsWith("line,stage,x1,y1,"), "no unit, no brackets");
  const materials = amounts.materials.map((material, k) => ({ ...material, name: names[k] }));
  const read = JSON.parse(cellsJson(cells, { ...amounts, materials }, "Three"));
  assert.deepEqual([read.title, read.unit, read.area, read.body, read.rise], ["Three", amounts.unit, amounts.area, amounts.body, 0]);
  assert.deepEqual(read.materials.map((/** @type {any} */ { name, amount }) => [name, amount]), [
    ...["glass, \"clear\"", "steel", "steel 2"].map((name, k) => [name, amounts.materials[k].amount]),
  ]);
  assert.deepEqual(
    read.cells.map((/** @type {any} */ { mix, ...cell }) => ({ ...cell, fractions: [mix[names[0]], mix.steel, mix["steel 2"]] })),
    cells.map(({ line, stage, corners, area, centroid, folded, fractions }) => ({ line, stage, corners, area, centroid, folded, fractions })),
  );
});
