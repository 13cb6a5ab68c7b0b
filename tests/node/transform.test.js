/** Distance transforms: against the comparison of all pairs, in steps, and what is refused. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { DirectrixError, load } from "directrix";

const dx = await load();

/** @param {number} seed */
function random(seed) {
  let state = seed;
  return () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;
}

/** @param {number[]} size @param {number[]} spacing @param {Uint8Array} features */
function allPairs(size, spacing, features) {
  const place = (/** @type {number} */ n) => [n % size[0], Math.floor(n / size[0]) % size[1], Math.floor(n / (size[0] * size[1]))].map((k, axis) => k * spacing[axis]);
  const marked = [...features.keys()].filter((n) => features[n] !== 0).map(place);
  const nearest = (/** @type {number} */ n) => {
    const [x, y, z] = place(n);
    return Math.min(...marked.map(([a, b, c]) => Math.hypot(x - a, y - b, z - c)));
  };
  return Array.from(features, (_, n) => nearest(n));
}

test("distances are those of all pairs, in the plane and in space, with unequal spacings and within a limit", () => {
  const next = random(20261126);
  for (const [size, spacing] of /** @type {[[number, number, number], [number, number, number]][]} */ ([
    [[23, 17, 1], [1, 1, 1]],
    [[11, 9, 7], [0.5, 0.5, 0.5]],
    [[11, 1, 9], [0.3, 1, 1.7]],
  ])) {
    const features = Uint8Array.from({ length: size[0] * size[1] * size[2] }, () => (next() < 0.03 ? 1 + Math.floor(200 * next()) : 0));
    const expected = allPairs(size, spacing, features);
    for (const limit of [undefined, 2.5]) {
      const found = dx.distanceTransform({ size, spacing, features, limit });
      expected.forEach((distance, n) => {
        const wanted = distance <= (limit ?? Infinity) ? distance : Infinity;
        assert.ok(found[n] === wanted || Math.abs(found[n] - wanted) < 1e-6 * wanted, `${found[n]}, not ${wanted}`);
      });
    }
  }
  const flat = dx.distanceTransform({ size: [3, 2], features: new Uint8Array([1, 0, 0, 0, 0, 0]) });
  assert.deepEqual([...flat], [0, 1, 2, 1, Math.fround(Math.SQRT2), Math.fround(Math.sqrt(5))]);
  assert.deepEqual([...dx.distanceTransform({ size: [2, 1], features: new Uint8Array(2) })], [Infinity, Infinity]);
});

test("a transform runs in short steps, whatever the method", () => {
  const features = new Uint8Array(64 ** 3);
  features[1000] = 1;
  for (const more of [{}, { limit: 10 }, { spacing: /** @type {[number, number, number]} */ ([1, 2, 3]) }]) {
    const input = { size: /** @type {[number, number, number]} */ ([64, 64, 64]), features, ...more };
    const job = dx.job(null, { distanceTransform: input });
    let steps = 1;
    let state = job.step(0);
    for (; !state.done; state = job.step(0)) steps += 1;
    assert.ok(steps > 100, `${steps} steps`);
    assert.deepEqual(state.distances, dx.distanceTransform(input));
  }
});

test("the transform that is watched is the one that is found", () => {
  const next = random(7);
  const size = /** @type {[number, number]} */ ([21, 17]);
  const features = Uint8Array.from({ length: 21 * 17 }, () => (next() < 0.03 ? 1 : 0));
  const { rows, levels, columns } = dx.transformSteps({ size, features });
  const distances = dx.distanceTransform({ size, features });
  distances.forEach((distance, n) => assert.ok(Math.abs(Math.sqrt(levels[n]) - distance) < 1e-5));
  columns.forEach(({ corners, searches }, x) => {
    for (let y = 0; y < 17; y += 1) {
      const least = Math.min(...corners.map((from) => rows[from * 21 + x] + (y - from) ** 2));
      assert.equal(levels[y * 21 + x], least, "the parabolas of the envelope are enough");
    }
    assert.ok(searches.every(({ count, reach }) => count >= 1 && count <= reach));
  });
  assert.throws(() => dx.transformSteps({ size: [129, 128], features: new Uint8Array(129 * 128) }), (error) => error instanceof DirectrixError && error.code === "limit");
});

test("wrong input is refused with its path", async () => {
  /** @param {object} input @param {string} code @param {string} path */
  const refused = (input, code, path) =>
    assert.throws(
      () => dx.distanceTransform(/** @type {any} */ (input)),
      (error) => error instanceof DirectrixError && error.code === code && error.path === path && error.message.length > 0,
    );
  const features = new Uint8Array(4);
  refused({ size: [2, 2], features: new Uint8Array(3) }, "range", "features");
  refused({ size: [2, 2], features: [0, 0, 0, 1] }, "type", "features");
  refused({ size: [2, 2], features, spacing: [1, -1] }, "range", "spacing[1]");
  refused({ size: [2, 2], features, spacing: [1, NaN] }, "non-finite", "spacing[1]");
  refused({ size: [1 << 14, 1 << 14], features }, "limit", "size");
  refused({ size: [2, 2], features, limit: -1 }, "range", "limit");
  refused({ size: [2, 2], features, depth: 1 }, "unknown-field", "depth");
  const figure = await load({ module: "figure" });
  assert.throws(
    () => figure.distanceTransform({ size: [2, 2], features }),
    (error) => error instanceof DirectrixError && error.code === "not-in-module",
  );
});
