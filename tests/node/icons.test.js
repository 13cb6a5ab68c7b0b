/** Outlines that were drawn for something else: icons of a public set, one inside the other, matched and checked by the hundred. */
import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { test } from "node:test";
import { DirectrixError, load } from "directrix";
import { faults } from "../../bench/support/checker.mjs";
import { diagonal } from "../../bench/support/compare.mjs";
import { ClosedCurve, polygonArea } from "../../bench/support/curve.mjs";

/** @import { Curve, CurvesDocument, Match, Point } from "directrix" */

const seed = 20_261_125;
const pairCount = 120;
/** Milliseconds that one matching may take, many times of what it does. */
const limit = 10_000;
const samples = 64;
const folder = new URL("../../node_modules/@primer/octicons/build/svg/", import.meta.url);
const dx = await load();

/** Numbers in [0, 1), always the same ones. */
function random() {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4_294_967_296;
  };
}

/** An outline, fit for a document. @typedef {{name: string, curve: Curve, polygon: Point[]}} Outline */

/**
 * The largest outline of an icon, as a curve within a thousandth of its size; `null` where that meets itself.
 *
 * @param {string} file
 * @returns {Promise<Outline | null>}
 */
async function outline(file) {
  const { shapes } = dx.readShapes(await readFile(new URL(file, folder), "utf8"));
  const shape = shapes.reduce((largest, each) => (each.area > largest.area ? each : largest));
  const { curve, simple } = dx.fitCurve(shape.points, {
    tolerance: diagonal(shape.points) / 1000,
    corners: "keep",
    cornerIndices: shape.corners,
  });
  return simple ? { name: file.replace(".svg", ""), curve, polygon: shape.points } : null;
}

/** @param {Point} p @param {Point[]} polygon */
function depthInside([x, y], polygon) {
  let [isInside, distance] = [false, Infinity];
  polygon.forEach(([ax, ay], k) => {
    const [bx, by] = polygon[(k + 1) % polygon.length];
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) isInside = !isInside;
    const [dx, dy] = [bx - ax, by - ay];
    const t = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
    distance = Math.min(distance, Math.hypot(ax + t * dx - x, ay + t * dy - y));
  });
  return isInside ? distance : -distance;
}

/** The place deepest inside a polygon, on a grid. @param {Point[]} polygon */
function deepest(polygon) {
  const [low, high] = [Math.min, Math.max].map((of) => [0, 1].map((axis) => of(...polygon.map((point) => point[axis]))));
  const grid = Array.from({ length: 25 * 25 }, (_, k) => {
    const place = [k % 25, Math.floor(k / 25)].map((cell, axis) => low[axis] + ((high[axis] - low[axis]) * cell) / 24);
    return /** @type {Point} */ (place);
  });
  return grid.map((place) => ({ place, depth: depthInside(place, polygon) })).reduce((a, b) => (b.depth > a.depth ? b : a));
}

/**
 * The first outline turned and made small enough to lie in the largest disc inside the second, filling a share of it.
 *
 * @param {Outline} inner
 * @param {Outline} outer
 * @param {number} angle
 * @param {number} share
 * @returns {Curve}
 */
function nested(inner, outer, angle, share) {
  const { place, depth } = deepest(outer.polygon);
  const middle = [0, 1].map((axis) => {
    const along = inner.polygon.map((point) => point[axis]);
    return (Math.min(...along) + Math.max(...along)) / 2;
  });
  // The control points lie farther out than the curve.
  const reach = Math.max(...inner.curve.points.map(([x, y]) => Math.hypot(x - middle[0], y - middle[1])));
  const [c, s] = [Math.cos(angle), Math.sin(angle)].map((x) => (x * share * depth) / reach);
  const points = inner.curve.points.map(([px, py]) => {
    const [x, y] = [px - middle[0], py - middle[1]];
    return /** @type {Point} */ ([place[0] + c * x - s * y, place[1] + s * x + c * y]);
  });
  return { ...inner.curve, points };
}

/** Solves in steps, so that a matching without end is found out. @param {CurvesDocument} document @param {string} name */
function solved(document, name) {
  const begin = performance.now();
  const job = dx.job(document);
  while (!job.step(50).done) assert.ok(performance.now() - begin < limit, `${name} takes longer than ${limit} ms`);
  const took = performance.now() - begin;
  assert.ok(took < limit, `${name} took ${took} ms`);
  return { match: dx.match(document), took };
}

/** Checks what a matching says of its lines and its pairs. @param {CurvesDocument} document @param {Match} match @param {string} name */
function check(document, match, name) {
  const curves = document.curves.map((curve) => new ClosedCurve(curve));
  const size = diagonal(curves.flatMap((curve) => curve.polygon));
  const polygons = match.samples.map(({ points }) => points);
  assert.ok(polygons.every((polygon) => polygonArea(polygon) > 0), `${name}: both run counter-clockwise`);

  // Lines speak of the sampled polygons.
  const visible = match.lines.filter((line) => line.visible);
  const lines = visible.map(({ from, to }) => /** @type {[Point, Point]} */ ([polygons[0][from], polygons[1][to]]));
  const found = faults(lines, polygons, 1e-9 * size);
  assert.deepEqual(found.blocked, [], `${name}: lines that pass for visible`);
  const totals = match.totals.lines;
  if (totals?.crossings === 0) assert.deepEqual(found.crossed, [], `${name}: lines that pass for free of crossings`);
  if (match.ok) assert.deepEqual([totals?.crossings, totals?.blocked, totals?.uncovered], [0, 0, [[], []]], name);

  // Pairs of `greedy` speak of these polygons with their own ends as further vertices; those of `exact` of polygons with at
  // least 320 vertices, which depart from the curves by no more than the depth allowed here.
  if (match.pairs.length === 0) return;
  const isExact = document.matching.method === "exact";
  const ends = match.pairs.flatMap(({ u, v, verified, from, to }) => {
    if (!verified) return [];
    const segment = /** @type {[Point, Point]} */ ([from, to]);
    for (const [axis, parameter] of [u, v].entries()) {
      const [x, y] = curves[axis].evaluate(parameter).point;
      const off = Math.hypot(x - segment[axis][0], y - segment[axis][1]);
      assert.ok(off < 1e-9 * size, `${name}: an end lies off its curve by ${off}`);
    }
    return [segment];
  });
  const refined = isExact ? curves.map((curve) => curve.polygon) : polygons.map((_, axis) => withEnds(match, axis, curves[axis]));
  const depth = isExact ? Math.max(...curves.map((curve) => departure(curve, 320))) : 1e-9 * size;
  assert.deepEqual(faults(ends, refined, depth), { crossed: [], blocked: [] }, `${name}: verified pairs`);
  if (match.ok) assert.equal(ends.length, match.pairs.length, `${name}: every pair is verified`);
}

/** The sampled polygon with the ends of the pairs. @param {Match} match @param {number} axis @param {ClosedCurve} curve */
function withEnds(match, axis, curve) {
  const { parameters, points } = match.samples[axis];
  const wrap = (/** @type {number} */ u) => u - Math.floor((u - curve.low) / (curve.high - curve.low)) * (curve.high - curve.low);
  const own = parameters.map((u, k) => ({ u, point: points[k] }));
  const ends = match.pairs.map(({ u, v, from, to }) => (axis === 0 ? { u: wrap(u), point: from } : { u: wrap(v), point: to }));
  const all = [...own, ...ends].sort((a, b) => a.u - b.u).map(({ point }) => point);
  const size = diagonal(all);
  return all.filter(([x, y], k) => {
    const [px, py] = all[(k + all.length - 1) % all.length];
    return Math.hypot(x - px, y - py) > 1e-11 * size;
  });
}

/** How far a curve lies from the polygon through so many equal arcs. @param {ClosedCurve} curve @param {number} count */
function departure(curve, count) {
  const corners = curve.samples(count).map((share) => curve.at(share).point);
  return curve.parameters.slice(0, -1).reduce((most, u) => {
    const k = Math.floor(curve.shareAt(u) * count + 1e-9) % count;
    const [[ax, ay], [bx, by]] = [corners[k], corners[(k + 1) % count]];
    const [x, y] = curve.evaluate(u).point;
    const off = Math.abs((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / Math.hypot(bx - ax, by - ay);
    return Math.max(most, off);
  }, 0);
}

test(`icons inside icons, ${pairCount} pairs, seed ${seed}: no panic, no hang, no false certificate`, async (t) => {
  const files = (await readdir(folder)).filter((file) => file.endsWith("-24.svg")).sort();
  assert.ok(files.length > 200, "the set is there");
  const next = random();
  const pick = () => files[Math.floor(next() * files.length)];
  let refined = 0;
  const counts = { pairs: 0, "not simple": 0, refused: 0 };
  /** @type {Record<string, {ok: number, partial: number, pairs: number, slowest: number}>} */
  const methods = {};
  while (counts.pairs < pairCount) {
    const [inner, outer] = [await outline(pick()), await outline(pick())];
    if (!inner || !outer) {
      counts["not simple"]++;
      continue;
    }
    counts.pairs++;
    const curves = [nested(inner, outer, 2 * Math.PI * next(), 0.5 + 0.45 * next()), outer.curve];
    for (const method of /** @type {const} */ (["exact", "greedy"])) {
      const name = `${inner.name} in ${outer.name}, ${method}`;
      /** @type {CurvesDocument} */
      const document = { directrix: 1, kind: "curves", curves, sampling: { counts: [samples, samples] }, matching: { method, oneToOne: true } };
      const sums = (methods[method] ??= { ok: 0, partial: 0, pairs: 0, slowest: 0 });
      try {
        const { match, took } = solved(document, name);
        check(document, match, name);
        if (match.optimumChange !== null) {
          refined++;
          assert.ok(match.optimumChange < 1e-4, `${name}: the optimum still changes by ${match.optimumChange}`);
        }
        sums[match.ok ? "ok" : "partial"]++;
        sums.pairs += match.pairs.length;
        sums.slowest = Math.max(sums.slowest, Math.round(took));
      } catch (error) {
        // Geometry that is refused is refused with a code of its own; anything else is a failure.
        if (!(error instanceof DirectrixError) || !["self-intersection", "contact"].includes(error.code)) throw error;
        counts.refused++;
      }
    }
  }
  t.diagnostic(`seed ${seed}: ${JSON.stringify({ ...counts, refined, methods })}`);
  assert.ok(refined >= pairCount / 10, `the optimum was refined for ${refined} pairs`);
  for (const [method, { ok }] of Object.entries(methods)) assert.ok(ok >= pairCount / 10, `${method} matches ${ok} of ${pairCount}`);
  assert.ok(counts.refused <= pairCount / 10, `${counts.refused} refused`);
});
