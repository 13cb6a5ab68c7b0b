/**
 * The small picture of a problem in a list: in the plane its solution, in space its boundary in the colours of its conditions, cut by its section, painted as a figure on other
 * pages paints a body, without a graphics card.
 *
 * @import { RemoteLaplaceSolution } from "../../../js/directrix.js"
 * @import { Kernel, Size } from "../types.js"
 * @import { LaboratoryDocument } from "./document.js"
 */
import { paint } from "../../../js/element/body/picture.js";
import { fitted, STANDARD } from "../space/camera.js";
import { add, cornersOf, scaled } from "../space/vector.js";
import { inputOf } from "./document.js";
import { elementLabs } from "./element-colors.js";
import { boundsOf, countOf, soupOf } from "./mesh.js";
import { colorsOf, labOf, labsOfMaterials } from "./pixels.js";
import { faceFrame, pixelsOf, planeOf } from "./section-state.js";

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
  const bounds = boundsOf(boundary);
  const isQuick = boundary.ready && countOf(boundary) <= MOST;
  const solution = isQuick ? await kernel.solveLaplace(inputOf(boundary, document.solver ?? {}), control) : null;
  if (boundary.dimension === 3) {
    const soup = soupOf(boundary);
    const frame = { size, top: 0, bottom: 0 };
    const surface = { ...soup, edges: [], edgePositions: new Float32Array(0), corners: [] };
    const shape = { surface, labs: elementLabs(boundary, document.materials, null), bounds };
    const cut = solution && document.section ? await cutOf(solution, document, bounds, control) : null;
    paint(canvas, /** @type {any} */ (shape), /** @type {any} */ (cut), { camera: fitted(STANDARD.iso, frame, cornersOf(bounds)), frame, ratio, theme: "light", isFine: true, isSmall: true });
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

/**
 * The face of the section as squares, one for each pixel inside.
 * @param {RemoteLaplaceSolution} solution
 * @param {LaboratoryDocument} document with a section
 * @param {import("../space/vector.js").Bounds} bounds
 * @param {{signal?: AbortSignal}} control
 */
async function cutOf(solution, { section, materials }, bounds, control) {
  const plane = planeOf(/** @type {import("./section-state.js").Section} */ (section));
  const { origin, sides } = faceFrame(plane, Float32Array.from(cornersOf(bounds).flat()));
  const found = await solution.section({ origin, sides, size: pixelsOf(sides, PIXELS) }, control);
  const [wide, tall] = found.size;
  const labs = labsOfMaterials(materials);
  /** @type {{positions: number[], labs: number[], indices: number[]}} */
  const face = { positions: [], labs: [], indices: [] };
  for (let n = 0; n < wide * tall; n += 1) {
    if (Number.isNaN(found.values[0][n])) continue;
    const [i, j] = [n % wide, Math.floor(n / wide)];
    const first = face.positions.length / 3;
    const lab = labOf(labs, (material) => found.values[material][n]);
    for (const [u, v] of [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]]) {
      face.positions.push(...add(origin, add(scaled(sides[0], u / wide), scaled(sides[1], v / tall))));
      face.labs.push(...lab);
    }
    face.indices.push(first, first + 1, first + 2, first, first + 2, first + 3);
  }
  const mesh = { positions: Float32Array.from(face.positions), indices: Uint32Array.from(face.indices), outline: [] };
  return { plane, section: mesh, labs: Float32Array.from(face.labs) };
}
