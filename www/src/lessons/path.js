/**
 * Path data of what lies over a figure, in CSS pixels. Pure functions.
 *
 * @import { Point } from "../types.js"
 */

/** Straight pieces of a circle where it is a line of points. */
const PIECES = 64;

/** @param {readonly number[]} point */
export const written = ([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`;

/** @param {readonly Point[]} points */
export const polyline = (points) => `M${points.map(written).join("L")}`;

/** A stroke of no length, which a round cap makes a dot. @param {readonly number[]} point */
export const dot = (point) => `M${written(point)}h.01`;

/** @param {readonly number[]} center @param {number} radius */
export const circle = ([x, y], radius) => `M${x - radius} ${y}a${radius} ${radius} 0 1 0 ${2 * radius} 0a${radius} ${radius} 0 1 0 ${-2 * radius} 0Z`;

/** Points round a circle, the first one again at the end. @param {readonly number[]} center @param {number} radius @returns {Point[]} */
export const roundOf = ([x, y], radius) =>
  Array.from({ length: PIECES + 1 }, (_, n) => [x + radius * Math.cos((2 * Math.PI * n) / PIECES), y + radius * Math.sin((2 * Math.PI * n) / PIECES)]);
