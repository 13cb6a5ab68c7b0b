/**
 * Pins as pure functions: places of ruling lines as parameters of the curves as drawn, and edits of the list.
 *
 * @import { Curve, CurvesDocument, Match, Pin } from "../types.js"
 */
import { isOpen, unrolled } from "../spline.js";
import { patch, tidy } from "../state/edits.js";

/** Most pins of a document, and part of a domain within which two places are one. */
export const MOST = 200;
const NEAR = 1e-9;

/**
 * The knot domain of a curve.
 * @param {Curve} curve
 * @returns {[number, number]}
 */
export function domainOf(curve) {
  const { knots, points } = unrolled(curve);
  return [/** @type {number} */ (knots[curve.degree]), /** @type {number} */ (knots[points.length])];
}

/**
 * A parameter brought into the domain of a curve, round the seam, or to the end of an open one.
 * @param {Curve} curve
 * @param {number} u
 */
export function wrapped(curve, u) {
  const [low, high] = domainOf(curve);
  if (isOpen(curve)) return tidy(Math.min(high, Math.max(low, u)));
  const share = (u - low) / (high - low);
  const inside = tidy(low + (share - Math.floor(share)) * (high - low));
  return inside < high ? inside : low;
}

/**
 * The ends of a shown ruling line, as a pin would hold them.
 * @param {CurvesDocument} document
 * @param {Match} match its result
 * @param {number} line
 * @returns {Pin | null}
 */
export function pinOf({ curves }, match, line) {
  const pair = match.pairs[line];
  const between = match.pairs.length > 0 ? null : match.lines[line];
  const ends = pair
    ? [pair.u, pair.v]
    : between
      ? [match.samples[0]?.parameters[between.from], match.samples[1]?.parameters[between.to]]
      : [];
  const [u, v] = ends.map((at, i) => {
    const curve = /** @type {Curve} */ (curves[i]);
    const [low, high] = domainOf(curve);
    return wrapped(curve, match.reversed[i] ? low + high - Number(at) : Number(at));
  });
  return u === undefined || v === undefined ? null : { u, v };
}

/**
 * The number of the pin at the ends of a line, or -1.
 * @param {CurvesDocument} document
 * @param {Pin} ends
 */
export function pinAt({ curves, matching }, ends) {
  const same = (/** @type {number} */ i, /** @type {number} */ a, /** @type {number} */ b) => {
    const [low, high] = domainOf(/** @type {Curve} */ (curves[i]));
    const away = Math.abs(a - b) / (high - low);
    return (isOpen(curves[i]) ? away : Math.min(away, 1 - away)) < NEAR;
  };
  return (matching.pins ?? []).findIndex((pin) => same(0, pin.u, ends.u) && same(1, pin.v, ends.v));
}

/**
 * Adds a pin; the method becomes exact if it is another, which keeps no pins.
 * @param {CurvesDocument} document
 * @param {Pin} pin
 */
export function addPin(document, pin) {
  const { method, pins = [] } = document.matching;
  if (pins.length >= MOST) return document;
  const exact = method === "exact" ? {} : { method: /** @type {const} */ ("exact") };
  return patch(document, "matching", { ...exact, pins: [...pins, pin] });
}

/**
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {"u" | "v"} end
 * @param {number} value
 */
export function movePin(document, index, end, value) {
  const { pins = [] } = document.matching;
  if (!pins[index] || pins[index][end] === value) return document;
  return patch(document, "matching", { pins: pins.map((pin, i) => (i === index ? { ...pin, [end]: value } : pin)) });
}

/**
 * @param {CurvesDocument} document
 * @param {number} index
 * @returns {CurvesDocument}
 */
export function removePin(document, index) {
  const { pins = [], ...matching } = document.matching;
  const left = pins.filter((_, i) => i !== index);
  return { ...document, matching: { ...matching, ...(left.length > 0 ? { pins: left } : {}) } };
}
