/** Every method on one pair of curves, ours and those of others, by one quadrature and one checker that are neither's. */
import { bound, faults, integral, weightsOf } from "./checker.mjs";
import { ClosedCurve } from "./curve.mjs";
import { flubberPairs, warpedPairs } from "./peers.mjs";

/**
 * @import { CurvesDocument, Directrix, Point } from "../../js/directrix.js"
 * @import { Place } from "./checker.mjs"
 * @import { Sampled } from "./peers.mjs"
 *
 * @typedef {object} Rating
 * @property {string} method one of `methods`
 * @property {number} milliseconds median of the runs
 * @property {Place[]} places none where the method refuses
 * @property {number} integral J
 * @property {number} eta J over a bound of it
 * @property {number} crossings pairs of lines that cross
 * @property {number} blocked lines that pass through a curve
 */

/** Ours first. */
export const methods = ["exact", "greedy", "k-shift", "parameter", "time warping", "flubber"];

/** What our documents call these methods. @type {Record<string, CurvesDocument["matching"]["method"]>} */
const ours = { exact: "exact", greedy: "greedy", "k-shift": "shift", parameter: "parameter" };

/**
 * Depth, in diagonals of the box round both curves, from which a passage counts: far below a pixel, and above what the fine polygons
 * of the checker leave out.
 */
const hair = 1e-5;

/**
 * Rates all methods on a document with two curves.
 *
 * The times of ours hold everything from the text of the document on; those of the others begin with the samples in hand.
 *
 * @param {Directrix} dx
 * @param {CurvesDocument} document
 * @param {number} runs
 * @returns {Rating[]}
 */
export function compare(dx, document, runs) {
  const [first, second] = document.curves.map((curve) => new ClosedCurve(curve));
  /** @type {[ClosedCurve, ClosedCurve]} */
  const curves = [first, second];
  const weights = weightsOf(document);
  const polygons = curves.map((curve) => curve.polygon);
  const depth = hair * diagonal(polygons.flat());
  const best = bound(curves, weights, depth);
  const samples = /** @type {[Sampled, Sampled]} */ (curves.map((curve, axis) => sampled(curve, document, axis)));
  return methods.map((method) => {
    const { places, milliseconds } = timed(runs, (run) => {
      if (method === "flubber") return flubberPairs(samples);
      return method === "time warping" ? warpedPairs(samples) : ownPairs(dx, document, curves, ours[method], run);
    });
    const segments = places.map(([x, y]) => /** @type {[Point, Point]} */ ([first.at(x).point, second.at(y).point]));
    const { crossed, blocked } = faults(segments, polygons, depth);
    const J = places.length > 0 ? integral(curves, places, weights) : NaN;
    return { method, milliseconds, places, integral: J, eta: J / best, crossings: crossed.length, blocked: blocked.length };
  });
}

/** Whether lines break no constraint. @param {Rating} rating */
export const isFeasible = ({ places, crossings, blocked }) => places.length > 0 && crossings + blocked === 0;

/**
 * Our pairs of a document that is new in every run, so that nothing is remembered.
 *
 * @param {Directrix} dx
 * @param {CurvesDocument} document
 * @param {[ClosedCurve, ClosedCurve]} curves
 * @param {CurvesDocument["matching"]["method"]} method
 * @param {number} run
 * @returns {Place[]}
 */
function ownPairs(dx, document, curves, method, run) {
  const { normalWeight, distanceWeight } = document.matching;
  const own = { ...document, title: `Run ${run}`, matching: { method, normalWeight, distanceWeight, oneToOne: true } };
  return dx.match(own).pairs.map(({ u, v }) => [curves[0].shareAt(u), curves[1].shareAt(v)]);
}

/**
 * @param {ClosedCurve} curve
 * @param {CurvesDocument} document
 * @param {number} axis
 * @returns {Sampled}
 */
function sampled(curve, { sampling }, axis) {
  const scheme = sampling?.scheme ?? "arc-length";
  if (scheme === "adaptive") throw new Error("adaptive samples are ours alone");
  const shares = curve.samples(sampling?.counts?.[axis] ?? 44, scheme);
  return { shares, ends: shares.map((share) => curve.at(share)) };
}

/**
 * @param {number} runs
 * @param {(run: number) => Place[]} work
 */
function timed(runs, work) {
  /** @type {Place[]} */
  let places = [];
  const times = Array.from({ length: runs }, (_, run) => {
    const begin = performance.now();
    places = work(run);
    return performance.now() - begin;
  });
  return { places, milliseconds: times.sort((a, b) => a - b)[runs >> 1] };
}

/** Of the box round points. @param {Point[]} points */
export function diagonal(points) {
  const sides = [0, 1].map((axis) => {
    const along = points.map((point) => point[axis]);
    return Math.max(...along) - Math.min(...along);
  });
  return Math.hypot(...sides);
}
