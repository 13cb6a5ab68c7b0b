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

/**
 * The cells that the module has made, each put together when it is first asked for.
 * @param {readonly {id: number}[]} cells
 * @param {{positions: Float64Array, mixes: Float64Array}} coefficients of all cells, in their order
 * @returns {(id: number) => Cell | undefined}
 */
export function cellsIn(cells, { positions, mixes }) {
  const places = new Map(cells.map(({ id }, n) => [id, n]));
  const materials = (3 * mixes.length) / Math.max(1, positions.length);
  /** @type {Map<number, Cell>} */
  const made = new Map();
  return (id) => {
    const place = places.get(id);
    if (place === undefined) return undefined;
    let cell = made.get(id);
    if (!cell) {
      const coefficients = Array.from({ length: 64 }, (_, k) => {
        const n = 64 * place + k;
        return { position: /** @type {Vector} */ ([...positions.subarray(3 * n, 3 * n + 3)]), mix: [...mixes.subarray(materials * n, materials * (n + 1))] };
      });
      made.set(id, (cell = { coefficients }));
    }
    return cell;
  };
}

/** Cells that a document writes out, in their order. @param {BodyDocument} document @returns {Cell[]} */
export const cellsOf = ({ operations }) =>
  operations.flatMap((operation) => (operation.op === "cells" ? /** @type {Cell[]} */ (operation.cells) : []));
