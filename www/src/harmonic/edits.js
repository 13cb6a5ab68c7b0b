/**
 * Edits of documents whose blend is harmonic, as pure functions: another curve inside, where there is most room.
 *
 * @import { Curve, CurvesDocument, Point, Shape } from "../types.js"
 */
import { outline } from "../spline.js";
import { tidy } from "../state/edits.js";
import { seen } from "../state/in-space.js";
import { depth } from "../state/nest.js";

/** Places tried along each side of the box of all curves, and how often the best one is looked at more closely. */
const PLACES = 32;
const CLOSER = 3;
/** Share of the free radius that a new curve takes, so that heat has a way round it. */
const SHARE = 0.55;
/** Control points of the circle, and the factor from its radius to theirs. */
const CORNERS = 8;
const CONTROL = 3 / (2 + Math.cos((2 * Math.PI) / CORNERS));

/** The number of the curve with the largest box, which contains all others where one does. @param {readonly Curve[]} curves */
export function outermost(curves) {
  const sizes = curves.map((curve) => {
    const [width, height] = boxOf(seen(curve).points);
    return width * height;
  });
  return sizes.lastIndexOf(Math.max(...sizes));
}

/**
 * The middle and the radius of the largest circle between the curves, about: inside the outer one and outside of all others.
 * @param {readonly Curve[]} curves closed
 * @returns {{center: Point, radius: number} | null} null where there is no place between them
 */
export function roomIn(curves) {
  const rings = curves.map((curve) => outline(curve).map(({ at }) => at));
  const outer = outermost(curves);
  if (!rings[outer]) return null;
  /** Free radius about a place; negative where it is not between the curves. @param {Point} at */
  const free = (at) => Math.min(...rings.map((ring, k) => (k === outer ? depth(ring, at) : -depth(ring, at))));
  const [left, right, low, high] = edgesOf(rings[outer]);
  /** @type {Point} */
  let center = [(left + right) / 2, (low + high) / 2];
  let [width, height] = [right - left, high - low];
  let radius = free(center);
  for (let turn = 0; turn < CLOSER; turn += 1) {
    const [cx, cy] = center;
    for (let i = 0; i < PLACES; i += 1) {
      for (let j = 0; j < PLACES; j += 1) {
        const at = /** @type {Point} */ ([cx + width * ((i + 0.5) / PLACES - 0.5), cy + height * ((j + 0.5) / PLACES - 0.5)]);
        const here = free(at);
        if (here > radius) [radius, center] = [here, at];
      }
    }
    // About the best place so far, one step of the grid to either side.
    [width, height] = [(2 * width) / PLACES, (2 * height) / PLACES];
  }
  return radius > 0 ? { center, radius } : null;
}

/**
 * The document with one more curve inside, of the material at its place unless it has its own: a circle, or a given curve, as large as it is where there
 * is room for that.
 * @param {CurvesDocument} document
 * @param {Shape & {composition?: Curve["composition"]}} [source]
 * @returns {CurvesDocument | null} null where there is no room
 */
export function withCurveInside(document, source) {
  const { curves, materials, sampling } = document;
  const room = roomIn(curves);
  if (!room) return null;
  const radius = SHARE * room.radius;
  const shape = source ? copyAt(source, room.center, radius, source === curves[outermost(curves)]) : circleAt(room.center, radius);
  const material = Math.min(curves.length, materials.length - 1);
  const composition = source?.composition ?? [{ at: 0, mix: materials.map((_, i) => (i === material ? 1 : 0)) }];
  const height = curves[0]?.height ?? 0;
  const counts = sampling.counts.slice(0, curves.length);
  return {
    ...document,
    curves: [...curves, { ...shape, height, composition }],
    sampling: { ...sampling, counts: [...counts, counts[counts.length - 1]] },
  };
}

/** @param {Point} center @param {number} radius @returns {Shape} */
function circleAt([x, y], radius) {
  const points = Array.from({ length: CORNERS }, (_, k) => {
    const turn = (2 * Math.PI * k) / CORNERS;
    return /** @type {Point} */ ([rounded(x + radius * CONTROL * Math.cos(turn), radius), rounded(y + radius * CONTROL * Math.sin(turn), radius)]);
  });
  return { degree: 3, form: "periodic", points };
}

/**
 * A copy of a curve about another place, no larger than the radius and, unless it has to shrink, as large as it was.
 * @param {Shape} curve
 * @param {Point} center
 * @param {number} radius
 * @param {boolean} shrinks
 * @returns {Shape}
 */
function copyAt(curve, center, radius, shrinks) {
  const { degree, form, knots } = curve;
  const ring = outline(curve).map(({ at }) => at);
  const [left, right, low, high] = edgesOf(ring);
  const [cx, cy] = [(left + right) / 2, (low + high) / 2];
  const reach = Math.max(...ring.map(([x, y]) => Math.hypot(x - cx, y - cy)));
  const scale = shrinks ? radius / reach : Math.min(1, radius / (SHARE * reach) / 1.2);
  const points = seen(curve).points.map(([x, y]) => /** @type {Point} */ ([rounded(center[0] + (x - cx) * scale, radius), rounded(center[1] + (y - cy) * scale, radius)]));
  return { degree, form, points, ...(knots ? { knots: [...knots] } : {}) };
}

/** A coordinate without digits that nobody could aim at. @param {number} value @param {number} size of the curve */
function rounded(value, size) {
  const unit = 10 ** Math.floor(Math.log10(size) - 2);
  return tidy(Math.round(value / unit) * unit);
}

/** @param {readonly Point[]} points @returns {[number, number, number, number]} left, right, low, high */
function edgesOf(points) {
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  return [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
}

/** @param {readonly Point[]} points @returns {[number, number]} width and height */
function boxOf(points) {
  const [left, right, low, high] = edgesOf(points);
  return [right - left, high - low];
}
