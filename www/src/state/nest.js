/**
 * A scaled copy of a curve that lies wholly inside or outside of it.
 *
 * @import { Curve, Point } from "../types.js"
 */
import { outline } from "../spline.js";

/** Scales tried for the smaller of the two, from the most to the least alike. */
const SCALES = [0.6, 0.5, 0.4, 0.3, 0.2, 0.1, 0.05];
/** Least gap between curve and copy, in parts of the diagonal of the curve. */
const GAP = 0.02;
/** Vertices looked at on the curve, and places tried along each side of its box for the centre. */
const VERTICES = 240;
const PLACES = 24;

/**
 * The centre and the scale below 1 at which a copy lies inside its curve. About the same centre a copy scaled by
 * 1 / scale lies outside.
 * @param {Curve} curve
 * @returns {{center: Point, scale: number}}
 */
export function nesting(curve) {
  const chain = outline(curve).map(({ at }) => at);
  const every = Math.max(1, Math.ceil(chain.length / VERTICES));
  const ring = chain.filter((_, i) => i % every === 0);
  const xs = ring.map(([x]) => x);
  const ys = ring.map(([, y]) => y);
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const diagonal = Math.hypot(right - left, high - low);
  /** @type {Point} */
  let center = [(left + right) / 2, (low + high) / 2];
  // The middle of the box is the place one expects; another one must be clearly deeper inside.
  let deepest = 1.25 * depth(ring, center);
  for (let i = 1; i < PLACES; i += 1) {
    for (let j = 1; j < PLACES; j += 1) {
      const at = /** @type {Point} */ ([left + ((right - left) * i) / PLACES, low + ((high - low) * j) / PLACES]);
      const here = depth(ring, at);
      if (here > deepest) [deepest, center] = [here, at];
    }
  }
  const [cx, cy] = center;
  const fits = (/** @type {number} */ scale) =>
    ring.every(([x, y]) => depth(ring, [cx + (x - cx) * scale, cy + (y - cy) * scale]) > GAP * diagonal * scale);
  return { center, scale: SCALES.find(fits) ?? SCALES[SCALES.length - 1] };
}

/**
 * Distance to the ring of a place inside it; negative outside.
 * @param {readonly Point[]} ring
 * @param {Point} at
 */
export function depth(ring, [x, y]) {
  let least = Infinity;
  let inside = false;
  let [ax, ay] = ring[ring.length - 1];
  for (const [bx, by] of ring) {
    const [dx, dy] = [bx - ax, by - ay];
    const length = dx * dx + dy * dy;
    const t = length > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / length)) : 0;
    least = Math.min(least, Math.hypot(ax + dx * t - x, ay + dy * t - y));
    if (ay > y !== by > y && x < ax + (dx * (y - ay)) / dy) inside = !inside;
    [ax, ay] = [bx, by];
  }
  return inside ? least : -least;
}
