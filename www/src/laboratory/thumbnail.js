/**
 * The small picture of a problem in a list: in the plane its solution, in space its boundary in the colours of its conditions, painted as a figure on other
 * pages paints a body, without a graphics card.
 *
 * @import { Kernel, Size } from "../types.js"
 * @import { LaboratoryDocument } from "./document.js"
 */
import { paint } from "../../../js/element/body/picture.js";
import { fitted, STANDARD } from "../space/camera.js";
import { cornersOf } from "../space/vector.js";
import { inputOf } from "./document.js";
import { elementLabs } from "./element-colors.js";
import { boundsOf, soupOf } from "./mesh.js";
import { colorsOf } from "./pixels.js";

/** Share of the picture that stays free at each edge. */
const MARGIN = 0.06;

/**
 * @param {Kernel} kernel
 * @param {any} raw
 * @param {Size} size CSS pixels
 * @param {number} ratio device pixels for one of them
 * @param {AbortSignal} [signal]
 * @returns {Promise<string>} its address as data; it stands on a light and on a dark ground
 */
export async function problemThumbnail(kernel, raw, size, ratio, signal) {
  const document = /** @type {LaboratoryDocument} */ (raw);
  const control = signal ? { signal } : {};
  const canvas = globalThis.document.createElement("canvas");
  [canvas.width, canvas.height] = [size.width * ratio, size.height * ratio];
  const boundary = await kernel.boundary(/** @type {any} */ (document));
  const bounds = boundsOf(boundary);
  if (boundary.dimension === 3) {
    const soup = soupOf(boundary);
    const frame = { size, top: 0, bottom: 0 };
    const surface = { ...soup, edges: [], edgePositions: new Float32Array(0), corners: [] };
    const shape = { surface, labs: elementLabs(boundary, document.materials, null), bounds };
    paint(canvas, /** @type {any} */ (shape), null, { camera: fitted(STANDARD.iso, frame, cornersOf(bounds)), frame, ratio, theme: "light", isFine: true, isSmall: true });
    return canvas.toDataURL("image/png");
  }
  if (!boundary.ready) return canvas.toDataURL("image/png");
  const solution = await kernel.solveLaplace(inputOf(boundary, document.solver ?? {}), control);
  const longest = Math.round(Math.min(canvas.width, canvas.height) * (1 - 2 * MARGIN));
  const found = await solution.section({ longest }, control);
  const sheet = globalThis.document.createElement("canvas");
  [sheet.width, sheet.height] = found.size;
  sheet.getContext("2d")?.putImageData(new ImageData(colorsOf(found, document.materials, true), sheet.width), 0, 0);
  canvas.getContext("2d")?.drawImage(sheet, Math.round((canvas.width - sheet.width) / 2), Math.round((canvas.height - sheet.height) / 2));
  return canvas.toDataURL("image/png");
}
