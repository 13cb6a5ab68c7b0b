/**
 * Where shapes and their handles lie on the screen, and which of them a pointer means.
 *
 * @import { Point, Size, View } from "../../types.js"
 * @import { WholePart } from "../document.js"
 * @import { NamedShape } from "./geometry.js"
 *
 * @typedef {{shape: string, point: number | null}} Held A handle of a shape; null is the whole of it.
 */
import { shapesOf, usedNames } from "../edits/shapes.js";
import { ending } from "../../spline.js";
import { toPlane, toScreen } from "../../view.js";
import { boxOf, chainOf, handleCount, isClosed, isReach, nearestPiece, pointsOf, unitOf } from "./geometry.js";

/** Pixels from the point of a line to the handle that turns it. */
const LEVER = 72;
/** Radius of the mark of a point. */
const DOT = 4;
/** Pixels within which outlines count as equally near. */
const ALIKE = 3;

/**
 * Where a handle lies. That of a rim is on the circle at an angle, to the right unless it was dragged elsewhere.
 * @param {View} view
 * @param {Size} size
 * @param {NamedShape} shape
 * @param {number} handle
 * @param {number} [rim] radians
 * @returns {Point} CSS pixels
 */
export function handleAt(view, size, shape, handle, rim = 0) {
  if (shape.kind === "line" && isReach(shape, handle)) {
    const [x, y] = toScreen(view, size, shape.through);
    const [ux, uy] = unitOf(shape);
    return [x + LEVER * ux, y - LEVER * uy];
  }
  if (shape.kind === "circle" && isReach(shape, handle)) {
    const { center, radius } = shape;
    return toScreen(view, size, [center[0] + radius * Math.cos(rim), center[1] + radius * Math.sin(rim)]);
  }
  return toScreen(view, size, pointsOf(shape)[handle]);
}

/** @param {readonly Point[]} chain CSS pixels */
const pathOf = (chain) => `M${chain.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}`;

/** A circle of two half turns, whose chord is twice the radius as it is written: a chord that is shorter would leave two arcs. @param {Point} at CSS pixels @param {number} radius */
function circlePath([x, y], radius) {
  const r = Number(radius.toFixed(2));
  return `M${(x - r).toFixed(2)} ${y.toFixed(2)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0Z`;
}

/**
 * The outline of a shape as a path: a line runs to the edges of the window, a point is a small ring.
 * @param {View} view
 * @param {Size} size
 * @param {import("../../../../js/directrix.js").PartShape} shape
 */
export function outlinePath(view, size, shape) {
  if (shape.kind === "point") return circlePath(toScreen(view, size, shape.at), DOT);
  if (shape.kind === "circle") return circlePath(toScreen(view, size, shape.center), shape.radius * view.scale);
  if (shape.kind === "line") {
    const [x, y] = toScreen(view, size, shape.through);
    const [ux, uy] = unitOf(shape);
    // The part of the line nearest to the window, and from there past its corners.
    const along = (size.width / 2 - x) * ux - (size.height / 2 - y) * uy;
    const half = Math.hypot(size.width, size.height);
    return pathOf([along - half, along + half].map((t) => /** @type {Point} */ ([x + t * ux, y - t * uy])));
  }
  const chain = chainOf(shape).map((at) => toScreen(view, size, at));
  return pathOf(chain) + (shape.kind === "curve" ? ending(shape) : isClosed(shape) ? "Z" : "");
}

/** The control polygon of a curve as a path; of other shapes none. @param {View} view @param {Size} size @param {NamedShape} shape */
export function controlPath(view, size, shape) {
  if (shape.kind !== "curve") return "";
  return pathOf(shape.points.map((at) => toScreen(view, size, at))) + (shape.form === "periodic" ? "Z" : "");
}

/**
 * How far a shape's outline is from a place.
 * @param {View} view
 * @param {Size} size
 * @param {NamedShape} shape
 * @param {Point} at CSS pixels
 * @param {number} reach pixels beyond which the answer may be Infinity
 * @returns {number} pixels
 */
function distanceTo(view, size, shape, at, reach) {
  const place = toPlane(view, size, at);
  if (shape.kind === "line") {
    const [ux, uy] = unitOf(shape);
    return Math.abs((place[0] - shape.through[0]) * uy - (place[1] - shape.through[1]) * ux) * view.scale;
  }
  if (shape.kind === "circle") {
    return Math.abs(Math.hypot(place[0] - shape.center[0], place[1] - shape.center[1]) - shape.radius) * view.scale;
  }
  const [low, high] = boxOf(shape);
  const by = (reach + DOT) / view.scale;
  if (place.some((value, k) => value < low[k] - by || value > high[k] + by)) return Infinity;
  if (shape.kind === "point") return Math.max(0, Math.hypot(place[0] - shape.at[0], place[1] - shape.at[1]) * view.scale - DOT);
  return nearestPiece(chainOf(shape), isClosed(shape), place).distance * view.scale;
}

/** Which of equally near shapes is meant: points before pieces before rings. @param {NamedShape} shape */
const rank = (shape) => (shape.kind === "point" ? 0 : isClosed(shape) ? 2 : 1);

/**
 * Names of the shapes under a place, the one that is most likely meant first.
 * @param {WholePart} document
 * @param {View} view
 * @param {Size} size
 * @param {Point} at CSS pixels
 * @param {number} reach
 * @returns {string[]}
 */
export function under(document, view, size, at, reach) {
  return shapesOf(document)
    .map((shape, index) => ({ shape, index, distance: distanceTo(view, size, shape, at, reach) }))
    .filter(({ distance }) => distance <= reach)
    .sort((a, b) => Math.floor(a.distance / ALIKE) - Math.floor(b.distance / ALIKE) || rank(a.shape) - rank(b.shape) || b.index - a.index)
    .map(({ shape }) => shape.name);
}

/**
 * The handle of a shape nearest to a place, not farther than `reach` pixels.
 * @param {View} view
 * @param {Size} size
 * @param {NamedShape} shape
 * @param {Point} at CSS pixels
 * @param {number} reach
 * @param {number} [rim]
 * @returns {number | null}
 */
export function nearestHandle(view, size, shape, at, reach, rim) {
  let best = null;
  let least = reach;
  for (let handle = 0; handle < handleCount(shape); handle += 1) {
    const [x, y] = handleAt(view, size, shape, handle, rim);
    const distance = Math.max(Math.abs(x - at[0]), Math.abs(y - at[1]));
    // Of points in one place the last one lies on top.
    if (distance <= least) [best, least] = [handle, distance];
  }
  return best;
}

/** What each shape is for. @param {WholePart} document @returns {(name: string) => "boundary" | "reference" | "unused"} */
export function rolesOf(document) {
  const boundaries = new Set(document.bodies.flatMap(({ outline, holes = [] }) => [outline, ...holes]));
  const used = usedNames(document);
  return (name) => (boundaries.has(name) ? "boundary" : used.has(name) ? "reference" : "unused");
}

/**
 * Names of the shapes that a feature is measured to.
 * @param {WholePart} document
 * @param {number | null} body
 * @param {number | null} feature
 * @returns {Set<string>}
 */
export function litBy({ bodies }, body, feature) {
  const spec = body === null || feature === null ? undefined : bodies[body]?.features?.[feature];
  if (!spec) return new Set();
  const references = [...(spec.reference === undefined ? [] : [spec.reference]), ...Object.values(spec.references ?? {})];
  return new Set(
    references.flatMap((reference) => {
      if (typeof reference === "string") return [reference];
      const of = bodies.find(({ name }) => name === reference.boundary);
      return of ? [of.outline, ...(of.holes ?? [])].filter((name) => !reference.except?.includes(name)) : [];
    }),
  );
}
