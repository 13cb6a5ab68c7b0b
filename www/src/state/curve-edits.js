/**
 * Edits of whole curves and of several control points, as pure functions from one document to the next.
 *
 * @import { CompositionKey, Curve, CurvesDocument, Point, Shape } from "../types.js"
 */
import { isOpen, unrolled } from "../spline.js";
import { changeCurve, handleCount, placePoints, tidy } from "./edits.js";
import { seen } from "./in-space.js";
import { isHarmonic } from "./look.js";
import { nesting } from "./nest.js";

/** Most control points and the highest degree the format allows. */
export const POINT_LIMIT = 2000;
export const DEGREES = { min: 2, max: 32 };

/**
 * Where a new curve goes: beside the one that is there, or in place of the chosen one of two.
 * @param {CurvesDocument} document
 * @param {number} chosen
 * @returns {{index: number, replaces: boolean}}
 */
export function placeForCurve(document, chosen) {
  const { curves } = document;
  // Inside of the outer curve of a harmonic blend there is room for more.
  if (isHarmonic(document) && curves.length > 1) return { index: curves.length, replaces: false };
  if (curves.length < 2) return { index: curves.length === 0 ? 0 : 1, replaces: false };
  return { index: chosen === 0 ? 0 : 1, replaces: true };
}

/**
 * Puts a shape on a place of the document: a new curve of the material that stands at the same place, or, in place of
 * another, with the name, the height and the composition of that one.
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {Shape} shape
 * @returns {CurvesDocument}
 */
export function putShape(document, index, shape) {
  if (document.curves[index]) return changeCurve(document, index, (curve) => withShape(curve, shape));
  const material = Math.min(index, document.materials.length - 1);
  const mix = document.materials.map((_, i) => (i === material ? 1 : 0));
  const curve = { ...shape, height: 0, composition: [{ at: 0, mix }] };
  const { sampling } = document;
  const counts = sampling.counts.slice(0, Math.max(2, index));
  if (counts.length <= index) counts.push(counts[counts.length - 1]);
  return { ...document, curves: [...document.curves, curve], sampling: { ...sampling, counts } };
}

/**
 * @param {Curve} curve
 * @param {Shape} shape
 * @returns {Curve}
 */
function withShape({ knots: _, ...rest }, { degree, form, points, knots }) {
  return { ...rest, degree, form, points, ...(knots ? { knots } : {}) };
}

/**
 * Takes a curve away, with its sample count and the pins of the spans at its sides.
 * @param {CurvesDocument} document
 * @param {number} index
 * @returns {CurvesDocument}
 */
export function deleteCurve(document, index) {
  const { curves, sampling } = document;
  if (!curves[index]) return document;
  const counts = sampling.counts.toSpliced(index, 1);
  // A drawing in progress has counts for two.
  if (counts.length < 2) counts.push(sampling.counts[index]);
  const rest = { ...document, curves: curves.toSpliced(index, 1), sampling: { ...sampling, counts } };
  if (curves.length < 3) return rest;
  return withPins(rest, (pair) => (pair === index || pair === index - 1 ? null : pair > index ? pair - 1 : pair));
}

/**
 * Gives pins the numbers that their spans have now; those whose span is gone go with it.
 * @param {CurvesDocument} document
 * @param {(pair: number) => number | null} change
 * @returns {CurvesDocument}
 */
export function withPins(document, change) {
  const { pins, ...matching } = document.matching;
  if (!pins) return document;
  const kept = pins.flatMap(({ u, v, pair = 0 }) => {
    const now = change(pair);
    return now === null ? [] : [now === 0 ? { u, v } : { u, v, pair: now }];
  });
  return { ...document, matching: kept.length > 0 ? { ...matching, pins: kept } : matching };
}

/**
 * The first curve becomes the last: the morph runs the other way.
 * @param {CurvesDocument} document
 * @returns {CurvesDocument}
 */
export function swapCurves(document) {
  const { curves, sampling, matching } = document;
  if (curves.length < 2) return document;
  const pins = matching.pins?.map(({ u, v, pair = 0 }) => {
    const span = curves.length - 2 - pair;
    return span === 0 ? { u: v, v: u } : { u: v, v: u, pair: span };
  });
  return {
    ...document,
    curves: curves.toReversed(),
    sampling: { ...sampling, counts: sampling.counts.toReversed() },
    matching: pins ? { ...matching, pins } : matching,
  };
}

/**
 * Draws a curve in the other direction. Its shape and what it is made of at each place stay.
 * @param {CurvesDocument} document
 * @param {number} index
 */
export function reverseCurve(document, index) {
  return changeCurve(document, index, (curve) => {
    const points = curve.points.map((_, i) => curve.points[reversedPoint(curve, i)]);
    const composition = curve.composition
      .map(({ at, mix }) => /** @type {CompositionKey} */ ({ at: at === 0 && !isOpen(curve) ? 0 : tidy(1 - at), mix }))
      .sort((a, b) => a.at - b.at);
    if (!curve.knots) return { ...curve, points, composition };
    const first = curve.knots[0];
    const last = curve.knots[curve.knots.length - 1];
    return { ...curve, points, composition, knots: curve.knots.map((knot) => first + last - knot).reverse() };
  });
}

/**
 * The index that a control point has after its curve was reversed; the map is its own inverse.
 * @param {Curve} curve
 * @param {number} point
 */
export function reversedPoint(curve, point) {
  const n = curve.points.length;
  return curve.form !== "periodic" ? n - 1 - point : (curve.degree - 1 - point + n) % n;
}

/**
 * A copy of a curve that nests with it: larger round it or, where only a far larger one would clear it, smaller
 * inside; of an open curve one beside it. It comes second, or in place of the other curve, on whose side of the original it then lies.
 * @param {CurvesDocument} document
 * @param {number} index
 * @returns {CurvesDocument}
 */
export function duplicateCurve(document, index) {
  const curve = document.curves[index];
  if (!curve) return document;
  if (isOpen(curve)) return putBeside(document, index, curve);
  const { center, scale } = nesting(curve);
  const other = document.curves[1 - index];
  const outside = other ? extent(other) > extent(curve) : scale > 0.35;
  const factor = outside ? 1 / scale : scale;
  const points = curve.points.map((at) => scaled(at, center, factor, factor));
  const { degree, form, knots } = curve;
  const target = other ? 1 - index : document.curves.length;
  return putShape(document, target, { degree, form, points, ...(knots ? { knots: [...knots] } : {}) });
}

/**
 * A copy of an open curve on its left, a quarter of the way from end to end away.
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {Curve} curve
 * @returns {CurvesDocument}
 */
function putBeside(document, index, { degree, form, points, knots }) {
  const [[ax, ay], [bx, by]] = [points[0], points[points.length - 1]];
  const moved = points.map(([x, y]) => /** @type {Point} */ ([tidy(x - (by - ay) / 4), tidy(y + (bx - ax) / 4)]));
  const target = document.curves[1 - index] ? 1 - index : document.curves.length;
  return putShape(document, target, { degree, form, points: moved, ...(knots ? { knots: [...knots] } : {}) });
}

/** @param {Curve} curve */
function extent({ points }) {
  const span = (/** @type {number[]} */ values) => Math.max(...values) - Math.min(...values);
  return span(points.map(([x]) => x)) * span(points.map(([, y]) => y));
}

/**
 * Doubles a control point: the curve is drawn closer to it. A curve with knots of its own gets one more in the middle
 * of the stretch that the point governs.
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {number} point
 */
export function duplicatePoint(document, index, point) {
  return changeCurve(document, index, (curve) => {
    if (curve.points.length >= POINT_LIMIT || point >= handleCount(curve)) return curve;
    const points = curve.points.toSpliced(point, 0, /** @type {any} */ ([...curve.points[point]]));
    return curve.knots ? { ...curve, points, knots: withKnot(curve, point) } : { ...curve, points };
  });
}

/**
 * @param {Curve} curve
 * @param {number} point
 */
function withKnot(curve, point) {
  const { knots } = unrolled(curve);
  const { degree: p, form } = curve;
  const n = curve.points.length;
  const spans = form !== "periodic" ? knots.slice(p, n + 1) : knots.slice(p, n + p + 1);
  let middle = 0;
  for (let i = 1; i <= p; i += 1) middle += knots[point + i] / p;
  const first = spans[0];
  const period = spans[spans.length - 1] - first;
  const wrapped = form !== "periodic" ? middle : first + ((((middle - first) % period) + period) % period);
  const nearest = (/** @type {number} */ i) => Math.abs((spans[i] + spans[i + 1]) / 2 - wrapped);
  let best = -1;
  for (let i = 0; i + 1 < spans.length; i += 1) {
    if (spans[i + 1] > spans[i] && (best < 0 || nearest(i) < nearest(best))) best = i;
  }
  const knot = (spans[best] + spans[best + 1]) / 2;
  const longer = spans.toSpliced(best + 1, 0, knot);
  return form !== "periodic" ? [...knots.slice(0, p), ...longer, ...knots.slice(n + 1)] : longer;
}

/**
 * Gives a curve another degree. The control points stay, the knots become uniform: a higher degree is smoother and
 * keeps farther from its control points.
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {number} degree
 */
export function setDegree(document, index, degree) {
  return changeCurve(document, index, (curve) => {
    if (degree === curve.degree || degree < DEGREES.min || degree > highestDegree(curve)) return curve;
    const { knots: _, ...rest } = curve;
    return { ...rest, degree };
  });
}

/**
 * The highest degree that the control points of a curve allow.
 * @param {Curve} curve
 */
export const highestDegree = (curve) => Math.min(DEGREES.max, curve.points.length - 1);

/**
 * Scales control points about a place.
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {readonly number[]} points
 * @param {Point} about
 * @param {[number, number]} by factors along x and y
 */
export function scalePoints(document, index, points, about, by) {
  return placePoints(document, index, points, (at) => scaled(at, about, by[0], by[1]));
}

/**
 * Turns control points about a place.
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {readonly number[]} points
 * @param {Point} about
 * @param {number} degrees counter-clockwise
 */
export function turnPoints(document, index, points, [cx, cy], degrees) {
  const angle = (degrees * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  if (degrees === 0) return document;
  return placePoints(document, index, points, ([x, y]) => [
    tidy(cx + (x - cx) * cos - (y - cy) * sin),
    tidy(cy + (x - cx) * sin + (y - cy) * cos),
  ]);
}

/** @typedef {"left" | "center" | "right" | "top" | "middle" | "bottom" | "across" | "down"} Alignment */

/**
 * Aligns control points with an edge or the middle of their box, or spaces them evenly across or down.
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {readonly number[]} points
 * @param {Alignment} how
 * @returns {CurvesDocument}
 */
export function alignPoints(document, index, points, how) {
  const curve = document.curves[index];
  if (!curve || points.length < 2) return document;
  const axis = how === "left" || how === "center" || how === "right" || how === "across" ? 0 : 1;
  const shown = seen(curve);
  const values = points.map((point) => shown.points[point][axis]);
  const [low, high] = [Math.min(...values), Math.max(...values)];
  const moved = (/** @type {Point} */ [x, y], /** @type {number} */ to) =>
    /** @type {Point} */ (axis === 0 ? [to, y] : [x, to]);
  if (how === "across" || how === "down") {
    const order = points.map((_, k) => k).sort((a, b) => values[a] - values[b]);
    return order.reduce(
      (now, k, place) =>
        placePoints(now, index, [points[k]], (at) => moved(at, tidy(low + ((high - low) * place) / (order.length - 1)))),
      document,
    );
  }
  const to = { left: low, bottom: low, right: high, top: high, center: (low + high) / 2, middle: (low + high) / 2 }[how];
  return placePoints(document, index, points, (at) => moved(at, tidy(to)));
}

/**
 * @param {Point} at
 * @param {Point} about
 * @param {number} fx
 * @param {number} fy
 * @returns {Point}
 */
const scaled = ([x, y], [cx, cy], fx, fy) => [tidy(cx + (x - cx) * fx), tidy(cy + (y - cy) * fy)];
