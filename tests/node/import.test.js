/** Reading and fitting shapes in Node, with the module `full`; and their refusal by the module `figure`. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { DirectrixError, load } from "directrix";
import { refused } from "./refused.js";

const dx = await load();
const figure = await load({ module: "figure" });

/** @import { Point } from "directrix" */

/** @param {number} count @param {number} rx @param {number} ry @returns {Point[]} */
const ellipse = (count, rx, ry) =>
  Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    return [rx * Math.cos(angle), ry * Math.sin(angle)];
  });

test("shapes come as plain pairs, with names, corners, areas and reasons", () => {
  const { shapes, skipped } = dx.readShapes(
    '<svg xmlns="http://www.w3.org/2000/svg"><rect id="plate" width="10" height="20"/><path d="M0 0h5"/></svg>',
  );
  assert.deepEqual(shapes, [
    { name: "plate", closed: true, area: 200, length: 60, points: [[0, 0], [10, 0], [10, -20], [0, -20]], corners: [0, 1, 2, 3] },
  ]);
  assert.equal(skipped.length, 1);
  assert.match(skipped[0].reason, /it is open/);
  assert.equal(dx.readShapes("0;0\n1,5;0\n0;1", { format: "points" }).shapes[0].points[1][0], 1.5);
  assert.equal(dx.readShapes(JSON.stringify(ellipse(5, 2, 1))).shapes[0].points.length, 5);
});

test("a fitted curve is fit for a document", () => {
  const [inner, outer] = [ellipse(500, 20, 12), ellipse(700, 50, 40)].map((points) => dx.fitCurve(points, { tolerance: 0.05 }));
  for (const { curve, error, corners, simple, trimmed } of [inner, outer]) {
    assert.deepEqual([curve.degree, curve.form, corners, simple, trimmed], [3, "periodic", [], true, 0]);
    assert.equal(curve.knots.length, curve.points.length + 1);
    assert.ok(error > 0 && error <= 0.05 && curve.points.length <= 20);
  }
  const match = dx.match({ directrix: 1, kind: "curves", curves: [inner.curve, outer.curve], matching: { method: "greedy" } });
  assert.equal(match.ok, true);
});

test("corners are found, given or smoothed, and points are met", () => {
  /** @type {Point[]} */
  const square = [[0, 0], [10, 0], [10, 10], [0, 10]];
  assert.deepEqual(dx.fitCurve(square, { tolerance: 0.1 }).corners, [0, 1, 2, 3]);
  assert.deepEqual(dx.fitCurve(square, { tolerance: 0.1, cornerIndices: [2] }).corners, [2]);
  assert.deepEqual(dx.fitCurve(square, { tolerance: 0.1, corners: "smooth" }).corners, []);
  const met = dx.fitCurve(ellipse(9, 3, 2), { tolerance: 0.1, corners: "smooth", through: true });
  assert.equal(met.curve.points.length, 9);
});

test("what is wrong is named by path or line", () => {
  /** @type {[() => unknown, string, string][]} */
  const cases = [
    [() => dx.readShapes(/** @type {any} */ (7)), "type", "text"],
    [() => dx.readShapes("1 2", { format: /** @type {any} */ ("dxf") }), "range", "options.format"],
    [() => dx.readShapes(""), "syntax", ""],
    [() => dx.readShapes("1 2\n3 x"), "type", "line 2, y"],
    [() => dx.readShapes("[[1, 2], [3]]"), "type", "[1]"],
    [() => dx.readShapes("[1e400, 2]"), "type", "[0]"],
    [() => dx.readShapes("<svg>\n</swg>"), "syntax", "line 2"],
    [() => dx.readShapes("[".repeat(5000) + "]".repeat(5000)), "limit", ""],
    [() => dx.readShapes(`<svg>${"<g>".repeat(90_000)}${"</g>".repeat(90_000)}</svg>`), "limit", "line 1"],
    [() => dx.readShapes(" ".repeat((8 << 20) + 1)), "limit", ""],
    [() => dx.fitCurve(/** @type {any} */ ("points"), { tolerance: 1 }), "type", "points"],
    [() => dx.fitCurve([[0, 0], [1, NaN], [2, 2]], { tolerance: 1 }), "non-finite", "points[1][1]"],
    [() => dx.fitCurve(/** @type {any} */ ([[0, 0], [1, "2"], [2, 2]]), { tolerance: 1 }), "type", "points[1][1]"],
    [() => dx.fitCurve(/** @type {any} */ ([[0, 0, 0]]), { tolerance: 1 }), "type", "points[0]"],
    [() => dx.fitCurve([[0, 0], [1, 1]], { tolerance: 1 }), "points", "points"],
    [() => dx.fitCurve([[0, 0], [1, 1], [2, 2]], { tolerance: 1 }), "points", "points"],
    [() => dx.fitCurve(ellipse(9, 1, 1), { tolerance: 0 }), "range", "options.tolerance"],
    [() => dx.fitCurve(ellipse(9, 1, 1), { tolerance: Infinity }), "non-finite", "options.tolerance"],
    [() => dx.fitCurve(ellipse(9, 1, 1), /** @type {any} */ ({})), "missing", "options.tolerance"],
    [() => dx.fitCurve(ellipse(9, 1, 1), { tolerance: 1, cornerIndices: [9] }), "range", "options.cornerIndices[0]"],
    [() => dx.fitCurve(ellipse(100_000, 1, 1), { tolerance: 1 }), "limit", "points"],
    [() => dx.fitCurve(ellipse(2001, 1, 1), { tolerance: 1, through: true }), "limit", "points"],
    [() => dx.fitCurve(ellipse(9, 1, 1), { tolerance: 1e-11, corners: "smooth" }), "limit", "options.tolerance"],
  ];
  for (const [call, code, path] of cases) {
    const error = refused(call);
    assert.deepEqual([error.code, error.path], [code, path], `${error.message} (${call})`);
  }
});

test("the module for figures says where the functions are", () => {
  for (const call of [() => figure.readShapes("0 0"), () => figure.fitCurve([], { tolerance: 1 })]) {
    const error = refused(call);
    assert.equal(error.code, "not-in-module");
    assert.match(error.message, /"full"/);
  }
});

test("random texts never stop the module", () => {
  let state = 20_261_123;
  const random = (/** @type {number} */ below) => (state = (state * 16_807) % 2_147_483_647) % below;
  const pieces = ["<svg>", "</svg>", '<path d="', "M0 0", "C1 2 3 4 5 6", "z", '"/>', "[[1,2],", "[3,4]]", "{", "}", ",", ";", "\n", "-", "1e9", "é", "&", "\0"];
  for (let run = 0; run < 3000; run++) {
    let text = ["", "<svg>", "[", "1 2\n"][random(4)];
    for (let i = random(12); i > 0; i--) text += pieces[random(pieces.length)];
    try {
      dx.readShapes(text);
    } catch (error) {
      assert.ok(error instanceof DirectrixError && error.code !== "trap", `seed 20261123, run ${run}: ${JSON.stringify(text)}: ${error}`);
    }
  }
});
