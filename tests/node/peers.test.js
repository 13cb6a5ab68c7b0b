/** The comparison with other methods: its own measure and checker against closed forms, and what it says of the reference curves. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { load } from "directrix";
import { bound, faults, integral, isCut } from "../../bench/support/checker.mjs";
import { compare, isFeasible } from "../../bench/support/compare.mjs";
import { ClosedCurve } from "../../bench/support/curve.mjs";
import { flubberPairs, warpedPairs } from "../../bench/support/peers.mjs";
import { loop } from "./curves.js";

/**
 * @import { CurvesDocument, Point } from "directrix"
 * @import { Place } from "../../bench/support/checker.mjs"
 */

const dx = await load({ module: "figure" });
const read = async (/** @type {string} */ file) =>
  JSON.parse(await readFile(new URL(`../../www/presets/${file}.json`, import.meta.url), "utf8"));
/** @type {{id: string}[]} */
const listed = await read("index");
/** @type {CurvesDocument[]} */
const documents = await Promise.all(listed.map(({ id }) => read(id)));
/** The others match pairs of closed outlines in the plane alone. @param {unknown} _ @param {number} k */
const isClosed = (_, k) => {
  const { curves, blend } = documents[k];
  return curves[0].form !== "open" && curves.length === 2 && curves[0].points[0].length === 2 && blend?.kind !== "harmonic";
};
const [index, presets] = [listed.filter(isClosed), documents.filter(isClosed)];

/** Titles of those with samples at corners. */
const cornered = ["Sharp square", "Duct from square to round"];

/** A circle to nine digits, drawn either way. @param {number} radius @param {boolean} [clockwise] */
function circle(radius, clockwise = false) {
  const points = loop(200, radius);
  return new ClosedCurve({ degree: 3, form: "periodic", points: clockwise ? points.reverse() : points });
}

/** Where a curve starts, the ordinate first. @param {ClosedCurve} curve @returns {Point} */
const towards = (curve) => [curve.at(0).point[1], curve.at(0).point[0]];

/** @param {number} x @param {number} y */
const isNear = (x, y) => Math.abs(x - y) <= 1e-7 * Math.abs(y);

test("curves of the checker are those of the kernel, measured apart from it", () => {
  for (const document of presets) {
    const { samples } = dx.match(document);
    for (const [axis, { points, normals, parameters }] of samples.entries()) {
      const curve = new ClosedCurve(document.curves[axis]);
      const shares = curve.samples(points.length, document.sampling?.scheme === "parameter" ? "parameter" : "arc-length");
      points.forEach((point, k) => {
        assert.ok(Math.abs(curve.shareAt(parameters[k]) - shares[k]) < 1e-6, `${document.title}, sample ${k}`);
        const end = curve.at(curve.shareAt(parameters[k]));
        const off = Math.hypot(end.point[0] - point[0], end.point[1] - point[1]);
        assert.ok(off < 1e-9 * curve.length, `${document.title}, sample ${k} lies off by ${off}`);
        const cosine = end.normal[0] * normals[k][0] + end.normal[1] * normals[k][1];
        // At a corner the kernel takes the bisector.
        assert.ok(cosine > (cornered.includes(document.title ?? "") ? 0.7 : 1 - 1e-9), `${document.title}, normal ${k}`);
      });
    }
  }
});

test("J of turned circles is that of the closed form, and its bound is reached without a turn", () => {
  const weights = { normal: 1, distance: 2 };
  for (const clockwise of [false, true]) {
    /** @type {[ClosedCurve, ClosedCurve]} */
    const curves = [circle(1), circle(3, clockwise)];
    // The curve through these control points is a little smaller.
    const [r, s] = curves.map((curve) => curve.length / (2 * Math.PI));
    // Drawn the other way it starts elsewhere.
    const [start, end] = curves.map((curve) => Math.atan2(...towards(curve)) / (2 * Math.PI));
    for (const [count, turn] of [[7, 0], [40, 0.05], [40, 0.1]]) {
      const places = Array.from({ length: count }, (_, k) => /** @type {Place} */ ([k / count, k / count + turn + start - end]));
      const c = Math.cos(2 * Math.PI * turn);
      const expected = c / (r * r + s * s - 2 * r * s * c);
      assert.ok(isNear(integral(curves, places, weights), expected), `${count} lines, turned by ${turn}`);
    }
    assert.ok(isNear(bound(curves, weights, 1e-6), 1 / (s - r) ** 2));
  }
});

test("the checker finds lines that cross and lines through a wall, wherever the polygon starts, and lets touching pass", () => {
  /** @type {Point[]} */
  const square = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
  /** @type {[Point, Point][]} */
  const through = [[[0, 0], [3, 0.2]], [[-3, 0.1], [3, 0]], [[0, 0], [2, 2]], [[-2, 0.5], [0, 0]], [[0, 3], [0, -0.5]]];
  /** @type {[Point, Point][]} */
  const clear = [[[1, 0], [3, 0]], [[1, 1], [2, 2]], [[1.5, -3], [1.5, 3]], [[-0.5, 0], [0.5, 0.2]], [[1, 0.5], [2, -3]], [[1, -3], [1, 3]]];
  const dense = square.flatMap(([x, y], k) => {
    const [nx, ny] = square[(k + 1) % 4];
    return Array.from({ length: 50 }, (_, i) => /** @type {Point} */ ([x + ((nx - x) * i) / 50, y + ((ny - y) * i) / 50]));
  });
  for (const polygon of [square, dense]) {
    for (let k = 0; k < polygon.length; k++) {
      const turned = [...polygon.slice(k), ...polygon.slice(0, k)];
      for (const points of [turned, turned.toReversed()]) {
        for (const segment of through) assert.ok(isCut(segment, points, 1e-6), JSON.stringify([segment, points[0]]));
        for (const segment of clear) assert.ok(!isCut(segment, points, 1e-6), JSON.stringify([segment, points[0]]));
      }
    }
  }
  // A bump counts when it is higher than the hair.
  /** @type {Point[]} */
  const bump = [[-5, -2], [5, -2], [1, -0.5], [0, 0.01], [-1, -0.5]];
  assert.ok(isCut([[-4, 0], [4, 0]], bump, 0.005));
  assert.ok(!isCut([[-4, 0], [4, 0]], bump, 0.02));
  /** @type {[Point, Point][]} */
  const lines = [[[0, 0], [2, 2]], [[0, 2], [2, 0]], [[0, 0], [0, 3]], [[5, 5], [6, 6]]];
  assert.deepEqual(faults(lines, [], 1e-9), { crossed: [[0, 1]], blocked: [] });
});

test("the other methods find the turn of a turned copy, each in its way", () => {
  const outline = loop(9, 10).map(([x, y], k) => /** @type {Point} */ ([x * (1 + 0.06 * k), y]));
  const inner = new ClosedCurve({ degree: 3, form: "periodic", points: outline });
  const outer = new ClosedCurve({ degree: 3, form: "periodic", points: [...outline.slice(3), ...outline.slice(0, 3)] });
  const count = 90;
  const sampled = (/** @type {ClosedCurve} */ curve) => {
    const shares = curve.samples(count);
    return { shares, ends: shares.map((share) => curve.at(share)) };
  };
  const start = inner.shareAt(3 / 9);
  for (const pair of [flubberPairs, warpedPairs]) {
    const places = pair([sampled(inner), sampled(outer)]);
    assert.ok(places.length >= count);
    places.forEach(([x, y], k) => {
      const off = (x - y - start) % 1;
      assert.ok(Math.abs(off - Math.round(off)) < 1.5 / count, `${pair.name}: ${x} ${y}`);
      assert.ok(k === 0 || (x >= places[k - 1][0] - 1e-9 && y >= places[k - 1][1] - 1e-9), `${pair.name} ascends at ${k}`);
    });
  }
});

test("on the reference curves exact is feasible wherever a method is, and no feasible J is above its own", () => {
  for (const [k, document] of presets.entries()) {
    const [exact, ...others] = compare(dx, document, 1);
    const { id } = index[k];
    assert.equal(isFeasible(exact), id !== "closed-pocket", id);
    for (const rating of [exact, ...others].filter(isFeasible)) {
      const { method, integral: own, eta } = rating;
      assert.ok(isFeasible(exact) && own <= exact.integral * (1 + 1e-6), `${id}: ${method} has ${own}, exact ${exact.integral}`);
      assert.ok(eta <= 1 + 1e-3, `${id}: ${method} has η ${eta}`);
    }
    // The package says the same of its own lines.
    for (const method of /** @type {const} */ (["exact", "greedy"])) {
      const rating = [exact, ...others].find((each) => each.method === method);
      const { normalWeight, distanceWeight } = document.matching;
      const totals = dx.match({ ...document, matching: { method, normalWeight, distanceWeight, oneToOne: true } }).totals.pairs;
      assert.equal(totals !== null, rating !== undefined && rating.places.length > 0, id);
      if (!totals || !rating) continue;
      assert.deepEqual([rating.crossings, rating.blocked], [totals.crossings, totals.blocked], `${id}, ${method}`);
      assert.ok(Math.abs(Number(totals.integral) / rating.integral - 1) < 2e-4, `${id}, ${method}: ${totals.integral} ${rating.integral}`);
    }
  }
});
