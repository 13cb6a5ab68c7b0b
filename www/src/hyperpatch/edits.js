/**
 * Edits of bodies as pure functions.
 *
 * @import { BodyDocument, Cell } from "./document.js"
 * @import { Vector } from "../space/vector.js"
 *
 * @typedef {{cell: number, corner: readonly number[]}} Side A corner as one cell has it: 0 or 1 along u, v and w.
 * @typedef {"block" | "corner"} Reach With its block of 2 x 2 x 2 coefficients a corner keeps the tangents of all its cells; alone it does not.
 */
import { add } from "../space/vector.js";
import { placeOf } from "./cell.js";

/**
 * The places of the coefficients that go with a corner of a cell.
 * @param {readonly number[]} corner
 * @param {Reach} reach
 */
export function coefficientsAt(corner, reach) {
  const along = corner.map((end) => (reach === "corner" ? [3 * end] : end ? [3, 2] : [0, 1]));
  return along[0].flatMap((i) => along[1].flatMap((j) => along[2].map((k) => placeOf(i, j, k))));
}

/**
 * Moves a corner in every cell that has it.
 * @param {BodyDocument} document
 * @param {readonly Side[]} sides all of them
 * @param {Vector} by document units
 * @param {Reach} reach
 * @returns {BodyDocument} the same one when nothing moves
 */
export function moveCorner(document, sides, by, reach) {
  if (by.every((length) => length === 0)) return document;
  /** @type {Map<number, Set<number>>} */
  const moved = new Map();
  for (const { cell, corner } of sides) {
    const places = moved.get(cell) ?? new Set();
    for (const place of coefficientsAt(corner, reach)) places.add(place);
    moved.set(cell, places);
  }
  let id = -1;
  const operations = document.operations.map((operation) => {
    if (operation.op !== "cells") return operation;
    const cells = /** @type {Cell[]} */ (operation.cells).map((cell) => {
      id += 1;
      const places = moved.get(id);
      if (!places) return cell;
      const coefficients = cell.coefficients.map((each, n) => (places.has(n) ? { ...each, position: add(each.position, by) } : each));
      return { ...cell, coefficients };
    });
    return { ...operation, cells };
  });
  return { ...document, operations };
}
