/**
 * A shape as one of another kind, where that has a meaning.
 *
 * @import { PartShape } from "../../../../js/directrix.js"
 * @import { Point } from "../../types.js"
 *
 * @typedef {"polygon" | "polyline" | "curve" | "control" | "outline"} Target what to make of a shape. `curve` passes its points, `control` takes
 *   them for control points or back, `outline` follows it
 */
import { curveThrough } from "../../state/through.js";
import { openCurveThrough } from "../../state/through-open.js";
import { chainOf, isClosed, keptPoint, reachOf } from "../shapes/geometry.js";

/** Farthest that a chain of segments lies from the curve that it stands for, over half the diagonal of the curve. */
const TOLERANCE = 1e-3;
/** Points of a circle that its curve passes: it is then nowhere farther from it than 5e-5 of the radius. */
const ROUND = 16;
/** Segments of a polygon that stands for a circle within the tolerance. */
const SIDES = 72;

/**
 * What a shape can become.
 * @param {PartShape} shape
 * @returns {Target[]}
 */
export function targetsOf(shape) {
  switch (shape.kind) {
    case "circle":
      return ["curve", "outline"];
    case "segment":
      return ["polyline"];
    case "polygon":
      return ["curve", "control", "polyline"];
    case "polyline":
      return [...(shape.points.length > 2 ? /** @type {Target[]} */ (["polygon"]) : []), "curve", ...(shape.points.length > 2 ? /** @type {Target[]} */ (["control"]) : [])];
    case "curve":
      return ["outline", "control"];
    default:
      return [];
  }
}

/**
 * The shape as what it becomes, without a name; null where its points allow none.
 * @param {PartShape} shape
 * @param {Target} target
 * @returns {PartShape | null}
 */
export function converted(shape, target) {
  if (!targetsOf(shape).includes(target)) return null;
  if (shape.kind === "circle") {
    const chain = round(shape.center, shape.radius, target === "curve" ? ROUND : SIDES);
    return target === "curve" ? through(chain, true) : { kind: "polygon", points: chain };
  }
  if (shape.kind === "segment") return { kind: "polyline", points: [shape.from, shape.to] };
  if (shape.kind === "curve") return ofCurve(shape, target);
  if (shape.kind !== "polygon" && shape.kind !== "polyline") return null;
  const { points } = shape;
  const closed = isClosed(shape);
  if (target === "polygon" || target === "polyline") return { kind: target, points };
  if (target === "curve") return through(points, closed);
  const degree = Math.min(3, points.length - 1);
  return { kind: "curve", degree, form: closed ? "periodic" : "open", points };
}

/** @param {Extract<PartShape, {kind: "curve"}>} curve @param {Target} target @returns {PartShape} */
function ofCurve(curve, target) {
  const closed = isClosed(curve);
  const kind = closed ? "polygon" : "polyline";
  if (target === "control") return { kind, points: curve.form === "clamped" ? curve.points.slice(0, -1) : curve.points };
  const chain = chainOf(curve);
  const ring = closed && chain.length > 1 ? chain.slice(0, -1) : chain;
  const points = thinned(closed ? [...ring, ring[0]] : ring, TOLERANCE * reachOf(curve)).map(keptPoint);
  if (!closed) return { kind, points };
  const distinct = points.slice(0, -1);
  return { kind, points: distinct.length >= 3 ? distinct : ring.map(keptPoint) };
}

/** @param {readonly Point[]} points @param {boolean} closed @returns {PartShape | null} */
function through(points, closed) {
  const shape = closed ? curveThrough(points) : openCurveThrough(points);
  return shape && { kind: "curve", ...shape, points: shape.points.map(keptPoint) };
}

/** @param {Point} center @param {number} radius @param {number} count @returns {Point[]} */
function round([x, y], radius, count) {
  return Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    return keptPoint([x + radius * Math.cos(angle), y + radius * Math.sin(angle)]);
  });
}

/**
 * The points of a chain that are needed to stay within a distance of it (U. Ramer 1972; D. Douglas, T. Peucker 1973), both ends among them. The first split of a
 * chain that closes is at the point farthest from its ends.
 * @param {readonly Point[]} chain
 * @param {number} tolerance
 * @returns {Point[]}
 */
export function thinned(chain, tolerance) {
  const needed = new Set([0, chain.length - 1]);
  /** @type {[number, number][]} */
  const open = [[0, chain.length - 1]];
  for (let stretch = open.pop(); stretch; stretch = open.pop()) {
    const [first, last] = stretch;
    let [worst, farthest] = [-1, tolerance];
    for (let i = first + 1; i < last; i += 1) {
      const distance = fromSegment(chain[i], chain[first], chain[last]);
      if (distance > farthest) [worst, farthest] = [i, distance];
    }
    if (worst < 0) continue;
    needed.add(worst);
    open.push([first, worst], [worst, last]);
  }
  return [...needed].sort((a, b) => a - b).map((i) => chain[i]);
}

/** @param {Point} at @param {Point} a @param {Point} b */
function fromSegment([x, y], [ax, ay], [bx, by]) {
  const [dx, dy] = [bx - ax, by - ay];
  const length = dx * dx + dy * dy;
  const t = length > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / length)) : 0;
  return Math.hypot(ax + dx * t - x, ay + dy * t - y);
}
