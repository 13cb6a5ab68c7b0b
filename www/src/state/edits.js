/**
 * Edits as pure functions from one document to the next.
 *
 * @import { Curve, CurvesDocument, Matching, Point, Sampling, Blend } from "../types.js"
 */
import { dropKnot } from "../spline.js";
import { moved, seen } from "./in-space.js";

/**
 * Control points that have a handle: a clamped curve repeats its first point at the end, and both share one.
 * @param {Curve} curve
 */
export function handleCount(curve) {
  return curve.form === "clamped" ? curve.points.length - 1 : curve.points.length;
}

/**
 * Whether control points can go: a curve of degree p keeps at least p + 1, and three handles.
 * @param {Curve} curve
 * @param {number} [count]
 */
export function canRemovePoints(curve, count = 1) {
  return curve.points.length - count > curve.degree && handleCount(curve) - count >= 3;
}

/**
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {(curve: Curve) => Curve} change
 * @returns {CurvesDocument}
 */
export function changeCurve(document, index, change) {
  const curve = document.curves[index];
  if (!curve) return document;
  const next = change(curve);
  if (next === curve) return document;
  return { ...document, curves: document.curves.map((other, i) => (i === index ? next : other)) };
}

/**
 * Puts some control points of a curve elsewhere on the canvas. The last point of a clamped curve goes with the first.
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {readonly number[]} points
 * @param {(at: Point) => Point} place
 */
export function placePoints(document, index, points, place) {
  return changeCurve(document, index, (curve) => {
    const chosen = new Set(points);
    const last = curve.points.length - 1;
    if (curve.form === "clamped" && chosen.has(0)) chosen.add(last);
    const shown = seen(curve);
    let isMoved = false;
    const next = curve.points.map((from, i) => {
      if (!chosen.has(i)) return from;
      const was = shown.points[i];
      const to = place(was);
      if (to[0] === was[0] && to[1] === was[1]) return from;
      isMoved = true;
      return moved(from, was, to);
    });
    return isMoved ? { ...curve, points: next } : curve;
  });
}

/**
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {readonly number[]} points
 * @param {Point} by
 */
export function movePoints(document, index, points, by) {
  return placePoints(document, index, points, ([x, y]) => [tidy(x + by[0]), tidy(y + by[1])]);
}

/**
 * Takes control points away, each with the knot that belonged to it; all of them, or none where too few would be left.
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {readonly number[]} points
 */
export function removePoints(document, index, points) {
  return changeCurve(document, index, (curve) => {
    if (points.length === 0 || !canRemovePoints(curve, points.length)) return curve;
    return [...points].sort((a, b) => b - a).reduce(withoutPoint, curve);
  });
}

/**
 * @param {Curve} curve
 * @param {number} point
 * @returns {Curve}
 */
function withoutPoint(curve, point) {
  let points = curve.points.filter((_, i) => i !== point);
  if (curve.form === "clamped" && point === 0) points = [...points.slice(0, -1), /** @type {any} */ ([...points[0]])];
  const { knots: _, ...rest } = curve;
  const knots = dropKnot(curve, point);
  return knots ? { ...rest, points, knots } : { ...rest, points };
}

/**
 * @template {"sampling" | "matching" | "blend"} Part
 * @param {CurvesDocument} document
 * @param {Part} part
 * @param {Partial<{sampling: Sampling, matching: Matching, blend: Blend}[Part]>} patch
 * @returns {CurvesDocument}
 */
export function patch(document, part, patch) {
  return { ...document, [part]: { ...document[part], ...patch } };
}

/**
 * Removes the noise of binary addition, so that 0.1 + 0.2 is written 0.3. Twelve significant digits stay.
 * @param {number} value
 */
export function tidy(value) {
  return Number(value.toPrecision(12));
}
