/**
 * Two hyperpatch documents as one.
 *
 * @import { HyperpatchDocument, Material } from "./directrix.js"
 */
import { DirectrixError } from "./errors.js";

/** Most materials of a document. */
const MOST_MATERIALS = 16;

/**
 * A document with the cells of another one after its own operations. Materials of the same name and colour are one; others are appended, and mixes of
 * the document have none of them.
 *
 * @param {HyperpatchDocument} document
 * @param {Material[]} materials of the document, with defaults filled in
 * @param {HyperpatchDocument} cells the other one, with one operation that writes its cells out
 * @returns {HyperpatchDocument}
 * @throws {DirectrixError} with code `limit` when there would be more than 16 materials
 */
export function merged(document, materials, cells) {
  const all = [...materials];
  const places = (cells.materials ?? []).map((material) => {
    const known = all.findIndex((other) => isSame(other, material));
    return known >= 0 ? known : all.push(material) - 1;
  });
  if (all.length > MOST_MATERIALS) {
    throw new DirectrixError("limit", "materials", `${all.length} materials would be needed; expected at most ${MOST_MATERIALS}`);
  }
  const more = all.length - materials.length;
  const own = more === 0 ? document.operations : document.operations.map((operation) => widened(operation, more));
  const added = cells.operations.map((operation) => placed(operation, places, all.length));
  return { ...document, materials: all, operations: [...own, ...added] };
}

/** @param {Material} a @param {Material} b */
function isSame(a, b) {
  return a.name === b.name && a.color.toLowerCase() === b.color.toLowerCase() && (a.void ?? false) === (b.void ?? false);
}

/**
 * An operation whose mixes have none of so many further materials.
 *
 * @param {any} operation
 * @param {number} more
 */
function widened(operation, more) {
  return withMixes(operation, (mix) => [...mix, ...Array(more).fill(0)]);
}

/**
 * An operation whose mixes have the fractions of materials in other places.
 *
 * @param {any} operation
 * @param {number[]} places
 * @param {number} count
 */
function placed(operation, places, count) {
  return withMixes(operation, (mix) => {
    const list = Array(count).fill(0);
    mix.forEach((fraction, n) => (list[places[n]] += fraction));
    return list;
  });
}

/**
 * An operation with other mixes; one without any is the same object. What is no operation is left to the reader of documents to refuse.
 *
 * @param {any} operation
 * @param {(mix: number[]) => number[]} changed
 */
function withMixes(operation, changed) {
  const mixed = (/** @type {any} */ holder) => (Array.isArray(holder?.mix) ? { ...holder, mix: changed(holder.mix) } : holder);
  if (!Array.isArray(operation?.cells) || operation.op !== "cells") return mixed(operation);
  const cell = (/** @type {any} */ cell) => (Array.isArray(cell?.coefficients) ? { ...cell, coefficients: cell.coefficients.map(mixed) } : cell);
  return { ...operation, cells: operation.cells.map(cell) };
}
