/**
 * What a file of a part takes: its pixels and the memory that evaluating them needs, known before anything is evaluated.
 *
 * @import { PartFileOptions } from "../../../js/directrix.js"
 * @import { Point } from "../types.js"
 * @import { WholePart } from "./document.js"
 *
 * @typedef {"png" | "csv" | "vti" | "nrrd" | "slices" | "json"} Format
 *
 * @typedef {object} Wanted
 * @property {Format} format
 * @property {"longer" | "pitch"} by what the resolution is given by
 * @property {number} longer pixels along the longer side
 * @property {number} pitch width of a pixel in document units
 * @property {number | null} material of a grey picture; null for the colours
 * @property {"none" | "diffusion" | "blue-noise"} dither
 */
import { needsVoxels, wholeFrame } from "./raster.js";

/** Pixels that the kernel evaluates at most, with a body by the rule `printed`, and bytes that this may take. */
export const MOST_PIXELS = 1 << 22;
export const MOST_VOXELS = 1 << 20;
export const MOST_MEMORY = 1 << 28;
/** What rounding may add to a whole number of pixels, as the kernel has it. */
const ROUNDING = 1e-9;

/**
 * Pixels along x and y.
 * @param {[Point, Point]} box
 * @param {Pick<Wanted, "by" | "longer" | "pitch">} wanted
 * @returns {[number, number]}
 */
export function pixelsOf(box, { by, longer, pitch }) {
  if (by === "longer") return wholeFrame(box, longer).size;
  const [[left, low], [right, high]] = box;
  const count = (/** @type {number} */ length) => Math.max(1, Math.ceil(length / pitch - ROUNDING));
  return [count(right - left), count(high - low)];
}

/**
 * Bytes that evaluating so many pixels takes: body, leaf, fractions and colour of each, and by the rule `printed` distances and two transforms.
 * @param {WholePart} document
 * @param {number} pixels
 */
export function memoryOf({ bodies, materials = [] }, pixels) {
  const printed = bodies.filter(({ rule }) => rule === "printed").map(({ features = [] }) => 4 * (features.length + materials.length) + 40);
  return pixels * (9 + 4 * materials.length + Math.max(0, ...printed));
}

/**
 * @param {WholePart} document
 * @param {[Point, Point]} box
 * @param {Wanted} wanted
 * @returns {{size: [number, number], pixels: number, memory: number, most: number, excess: "pixels" | "memory" | null}} `excess`: what is too much of
 */
export function estimated(document, box, wanted) {
  const size = pixelsOf(box, wanted);
  const pixels = size[0] * size[1];
  const memory = memoryOf(document, pixels);
  const most = needsVoxels(document) ? MOST_VOXELS : MOST_PIXELS;
  return { size, pixels, memory, most, excess: pixels > most ? "pixels" : memory > MOST_MEMORY ? "memory" : null };
}

/**
 * What the kernel is asked for.
 * @param {[Point, Point]} box
 * @param {Wanted} wanted
 * @returns {PartFileOptions}
 */
export function fileOptions(box, wanted) {
  const { format, by, pitch, material, dither } = wanted;
  const resolution = by === "pitch" ? { pitch } : { size: pixelsOf(box, wanted) };
  switch (format) {
    case "png":
      return { format, ...resolution, ...(material === null ? {} : { material }), dither };
    case "slices":
      return { format, ...resolution, dither };
    case "csv":
    case "vti":
    case "nrrd":
      return { format, ...resolution };
    case "json":
      throw new Error("a document is no raster");
  }
}

/** The ending of a file. @param {Format} format */
export const endingOf = (format) => (format === "slices" ? "zip" : format);
