/**
 * Documents of the kind `part` in the page: complete, with every default written out.
 *
 * @import { PartDocument } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Kernel } from "../types.js"
 */

/**
 * A document with every default written out, in the place of the documents that the page passes around. Rejects with a DirectrixError when it is none.
 * @param {Kernel} kernel
 * @param {PartDocument} raw
 */
export async function completedPart(kernel, raw) {
  const part = await kernel.part(raw);
  return /** @type {CurvesDocument} */ (/** @type {unknown} */ (await part.defaults()));
}

/** The open document as what it is while this workbench is on. @param {App} app */
export const partOf = ({ store }) => /** @type {WholePart} */ (/** @type {unknown} */ (store.document));

/** @typedef {import("../../../js/directrix.js").PartDocument} WholePart */
