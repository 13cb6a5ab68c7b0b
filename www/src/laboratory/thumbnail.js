/**
 * The small picture of a problem in a list: in the plane its solution, in space its boundary in the colours of its conditions, cut by its section, painted as a figure on other
 * pages paints a body, without a graphics card.
 *
 * @import { Kernel, Size } from "../types.js"
 * @import { LaboratoryDocument } from "./document.js"
 */
import { paint } from "../../../js/element/body/picture.js";
import { faceOf, planeOf, shapeOf } from "../../../js/element/problem/picture.js";
import { fitted, STANDARD } from "../space/camera.js";
import { cornersOf } from "../space/vector.js";
import { inputOf } from "./document.js";
import { countOf } from "./mesh.js";
import { colorsOf } from "./pixels.js";

/** Share of the picture that stays free at each edge. */
const MARGIN = 0.06;
/** Elements up to which a small picture is worth a solution, and pixels along the longer side of a section. */
const MOST = 1500;
const PIXELS = 80;

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
  const isQuick = boundary.ready && countOf(boundary) <= MOST;
  const solution = isQuick ? await kernel.solveLaplace(inputOf(boundary, document.solver ?? {}), control) : null;
  if (boundary.dimension === 3) {
    const frame = { size, top: 0, bottom: 0 };
    const shape = shapeOf(boundary, document.materials);
    const plane = planeOf(document);
    const cut = solution && plane ? await faceOf(solution, { boundary, materials: document.materials, plane }, PIXELS, control) : null;
    paint(canvas, shape, cut, { camera: fitted(STANDARD.iso, frame, cornersOf(shape.bounds)), frame, ratio, theme: "light", isFine: true, isSmall: true });
    return canvas.toDataURL("image/png");
  }
  if (!solution) return canvas.toDataURL("image/png");
  const longest = Math.round(Math.min(canvas.width, canvas.height) * (1 - 2 * MARGIN));
  const found = await solution.section({ longest }, control);
  const sheet = globalThis.document.createElement("canvas");
  [sheet.width, sheet.height] = found.size;
  sheet.getContext("2d")?.putImageData(new ImageData(colorsOf(found, document.materials, true), sheet.width), 0, 0);
  canvas.getContext("2d")?.drawImage(sheet, Math.round((canvas.width - sheet.width) / 2), Math.round((canvas.height - sheet.height) / 2));
  return canvas.toDataURL("image/png");
}
