/**
 * Lines of a cell in space: its net, its edges, and those of parameters through a place. Pure functions.
 *
 * @import { Vector } from "../space/vector.js"
 * @import { Cell } from "../hyperpatch/document.js"
 */
import { edgeSegments, placeOf, sampleAt } from "../hyperpatch/cell.js";
import { INDICES } from "./cell-sum.js";

/** Pieces of a line of parameters as it is drawn. */
const PIECES = 24;

/** The lines of a net, from coefficient to coefficient, among some of them. @param {Cell} cell @param {readonly (readonly number[])[]} among @returns {Vector[][]} */
export function netOf({ coefficients }, among) {
  const is = new Set(among.map(String));
  const at = (/** @type {readonly number[]} */ [i, j, k]) => coefficients[placeOf(i, j, k)].position;
  return among.flatMap((index) =>
    [0, 1, 2].flatMap((axis) => {
      const next = index.map((each, k) => (k === axis ? each + 1 : each));
      return is.has(String(next)) ? [[at(index), at(next)]] : [];
    }),
  );
}

/** Indices of the eight coefficients next to a corner. @param {readonly number[]} corner 0 or 1 along each parameter */
export const blockOf = (corner) => INDICES.filter((index) => index.every((each, axis) => (each > 1 ? 1 : 0) === corner[axis]));

/** The twelve edges, in short pieces. @param {Cell} cell @returns {Vector[][]} */
export function edgesOf(cell) {
  const ends = edgeSegments(cell);
  const end = (/** @type {number} */ start) => /** @type {Vector} */ (ends.slice(start, start + 3));
  return Array.from({ length: ends.length / 6 }, (_, n) => [end(6 * n), end(6 * n + 3)]);
}

/** A line of parameters through a place. @param {Cell} cell @param {readonly number[]} uvw @param {number} axis the parameter that runs @returns {Vector[]} */
export const lineThrough = (cell, uvw, axis) =>
  Array.from({ length: PIECES + 1 }, (_, n) => sampleAt(cell, uvw.map((own, k) => (k === axis ? n / PIECES : own)), 1).position);
