/**
 * The two places where the kernel's looser types meet the page's own.
 *
 * @import { CurvesDocument, Kernel, Picture } from "./types.js"
 */

/**
 * A document with every default written out. Rejects with a DirectrixError when it is none.
 * @param {Kernel} kernel
 * @param {unknown} raw
 */
export async function completed(kernel, raw) {
  if (typeof raw === "object" && raw && "kind" in raw && raw.kind !== "curves") {
    const kind = await (await import("./kinds/kinds.js")).kindOf(raw);
    if (kind) return kind.completed(kernel, raw);
  }
  const checked = /** @type {CurvesDocument} */ (raw);
  return /** @type {CurvesDocument} */ (await kernel.defaults(checked));
}

/**
 * Pixels in the form that a canvas takes.
 * @param {Picture} picture
 */
export function imageData({ data, width, height }) {
  return new ImageData(/** @type {Uint8ClampedArray<ArrayBuffer>} */ (data), width, height);
}
