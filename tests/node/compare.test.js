/** The comparison of methods without the page: which settings are compared, what is best, and the line nearest to a point. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "directrix";
import { bestOf, faultsOf, median, measured, METHODS, methodOf, qualityOf, withMethod } from "../../www/src/compare/methods.js";
import { nearestLine } from "../../www/src/compare/nearest.js";
import { base } from "./hostile.js";

/** @type {any} */
const document = base;

test("every method is a valid setting of a document, and is found again in it", async () => {
  const dx = await load();
  const whole = /** @type {any} */ (dx.defaults(document));
  for (const [i, method] of METHODS.entries()) {
    const own = withMethod(whole, method);
    assert.equal(methodOf(own.matching), i);
    assert.equal(methodOf(/** @type {any} */ (dx.defaults(own)).matching), i);
    const match = dx.match(own);
    const { eta, integral, bound } = qualityOf(dx.match(measured(own)));
    assert.ok(eta !== null && integral !== null && bound !== null && Math.abs(integral / bound - eta) < 1e-12);
    assert.equal(faultsOf(match).feasible, match.ok);
    for (const name of ["normalWeight", "distanceWeight", "negative"]) assert.equal(/** @type {any} */ (own.matching)[name], whole.matching[name]);
  }
  assert.equal(methodOf({ ...whole.matching, method: "shift", shift: 3 }), -1);
  assert.equal(methodOf({ ...whole.matching, method: "exact", objective: "sum-less-price" }), -1);
});

test("pins stay with the exact methods, and the others have none, which the format refuses", async () => {
  const dx = await load();
  const whole = /** @type {any} */ (dx.defaults(document));
  const pinned = { ...whole, matching: { ...whole.matching, method: "exact", pins: [{ u: 0.2, v: 0.2 }] } };
  for (const method of METHODS) {
    const own = withMethod(pinned, method);
    assert.deepEqual(own.matching.pins, method.settings.method === "exact" ? pinned.matching.pins : undefined);
    dx.match(own);
  }
});

test("the exact method is never below another one that keeps the constraints", async () => {
  const dx = await load();
  const whole = /** @type {any} */ (dx.defaults(document));
  const results = METHODS.map((method) => {
    const own = withMethod(whole, method);
    return { feasible: faultsOf(dx.match(own)).feasible, eta: qualityOf(dx.match(measured(own))).eta };
  });
  const best = results[bestOf(results)].eta ?? 0;
  assert.ok((results[METHODS.length - 1].eta ?? 0) > best - 1e-3, JSON.stringify(results));
});

test("the best is the greatest of the feasible ones", () => {
  const result = (/** @type {boolean} */ feasible, /** @type {number | null} */ eta) => ({ feasible, eta });
  assert.equal(bestOf([result(false, 0.99), result(true, 0.4), null, result(true, 0.6), result(true, null)]), 3);
  assert.equal(bestOf([result(true, -0.5), result(false, 0)]), 0);
  assert.equal(bestOf([result(false, 1), null]), -1);
});

test("the median of runs", () => {
  assert.equal(median([]), null);
  assert.equal(median([3]), 3);
  assert.equal(median([9, 1, 2]), 2);
  assert.equal(median([4, 1, 9, 2]), 3);
});

test("the nearest line is that of a search along every one", () => {
  let seed = 7;
  const random = () => {
    seed = (seed * 16807) % 2147483647;
    return seed / 2147483647;
  };
  const point = () => /** @type {[number, number]} */ ([random(), random()]);
  for (let turn = 0; turn < 200; turn += 1) {
    const lines = Array.from({ length: 12 }, () => ({ from: point(), to: turn % 10 === 0 ? /** @type {[number, number]} */ ([0.5, 0.5]) : point() }));
    const at = point();
    const distances = lines.map(({ from, to }) => {
      let least = Infinity;
      for (let k = 0; k <= 2000; k += 1) {
        const s = k / 2000;
        least = Math.min(least, Math.hypot(from[0] + (to[0] - from[0]) * s - at[0], from[1] + (to[1] - from[1]) * s - at[1]));
      }
      return least;
    });
    assert.ok(distances[nearestLine(lines, at)] <= Math.min(...distances) + 1e-3);
  }
  assert.equal(nearestLine([], [0, 0]), -1);
  const same = /** @type {[number, number]} */ ([1, 1]);
  assert.equal(nearestLine([{ from: [5, 5], to: [6, 6] }, { from: same, to: same }], [1, 1.1]), 1, "a line of no length");
});
