/**
 * Documents of the kind `hyperpatch` in the page: complete, with every default written out.
 *
 * @import { HyperpatchDocument, Material } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Kernel } from "../types.js"
 * @import { Vector } from "../space/vector.js"
 *
 * @typedef {{position: Vector, mix?: number[]}} Coefficient
 * @typedef {{coefficients: Coefficient[]}} Cell
 * @typedef {HyperpatchDocument & {title: string, unit: string, materials: Material[]}} BodyDocument
 */

/** Materials of a document that names none, as in docs/format.md. */
const MATERIALS = [
  { name: "yellow", color: "#f0e442" },
  { name: "green", color: "#009e73" },
];

/**
 * A document with every default written out, in the place of the documents that the page passes around. Rejects with a DirectrixError
 * when it is none.
 * @param {Kernel} kernel
 * @param {HyperpatchDocument} raw
 */
export async function completedBody(kernel, raw) {
  await kernel.hyperpatch(raw);
  const { title = "", unit = "mm", materials = MATERIALS, operations } = raw;
  const whole = /** @type {BodyDocument} */ ({ directrix: 1, kind: "hyperpatch", title, unit, materials, operations });
  return /** @type {CurvesDocument} */ (/** @type {unknown} */ (whole));
}

/** The open document as what it is while this workbench is on. @param {App} app */
export const bodyOf = ({ store }) => /** @type {BodyDocument} */ (/** @type {unknown} */ (store.document));

/** Cells of a document in the order of their identifiers: that of their creation. @param {BodyDocument} document @returns {Cell[]} */
export const cellsOf = ({ operations }) =>
  operations.flatMap((operation) => (operation.op === "cells" ? /** @type {Cell[]} */ (operation.cells) : []));
