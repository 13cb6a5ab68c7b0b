/**
 * The small picture of a body in a list, seen from a corner, painted as a figure on other pages paints it: without a graphics card.
 *
 * @import { HyperpatchDocument } from "../../../js/directrix.js"
 * @import { Kernel, Size } from "../types.js"
 */
import { paint, shapeOf, within } from "../../../js/element/body/picture.js";
import { fitted, STANDARD } from "../space/camera.js";
import { cornersOf } from "../space/vector.js";

/** Largest distance of the triangles from the boundary, as a share of the diagonal: far less than a pixel. */
const TOLERANCE = 4e-3;

/**
 * @param {Kernel} kernel
 * @param {HyperpatchDocument} document
 * @param {Size} size CSS pixels
 * @param {number} ratio device pixels for one of them
 * @param {AbortSignal} [signal]
 * @returns {Promise<string>} its address as data; it stands on a light and on a dark ground
 */
export async function bodyThumbnail(kernel, document, size, ratio, signal) {
  const control = signal ? { signal } : {};
  const body = await kernel.hyperpatch(document, control);
  const surface = await body.surface(within(body.cells, TOLERANCE), control);
  const shape = shapeOf(surface);
  const frame = { size, top: 0, bottom: 0 };
  const camera = fitted(STANDARD.iso, frame, cornersOf(shape.bounds));
  const canvas = globalThis.document.createElement("canvas");
  paint(canvas, shape, null, { camera, frame, ratio, theme: "light", isFine: true, isSmall: true });
  return canvas.toDataURL("image/png");
}
