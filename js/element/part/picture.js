/**
 * The colours of a part in a view, as pixels of the device.
 *
 * @import { Control, Point, RemotePart, View } from "../../directrix.js"
 * @import { Size } from "../plane.js"
 */

/** Pixels that are evaluated for one of the device either way, so that rims are smooth. */
const FINE = 2;
/** Pixels that are evaluated of a part by the printed rule. */
const MOST_PRINTED = 300_000;

/**
 * @param {RemotePart} part
 * @param {{ view: View, size: Size, ratio: number, most: number }} look `ratio`: device pixels for one of CSS; `most`: pixels that are evaluated
 * @param {Control} control
 * @returns {Promise<HTMLCanvasElement>} of the size of the device
 */
export async function pictureOf(part, { view: { center, scale }, size: { width, height }, ratio, most }, control) {
  const limit = part.bodies.some(({ rule }) => rule === "printed") ? Math.min(most, MOST_PRINTED) : most;
  const fine = Math.min(ratio * FINE, Math.sqrt(limit / (width * height)));
  const [across, up] = [width / 2 / scale, height / 2 / scale];
  const [columns, rows] = [width, height].map((side) => Math.max(1, Math.round(side * fine)));
  const box = /** @type {[Point, Point]} */ ([[center[0] - across, center[1] - up], [center[0] + across, center[1] + up]]);
  const { colors } = await part.evaluate({ box, size: [columns, rows], colors: true }, control);
  const found = canvasOf(columns, rows);
  const pixels = new Uint8ClampedArray(/** @type {Uint8Array<ArrayBuffer>} */ (colors));
  found.getContext("2d")?.putImageData(new ImageData(pixels, columns), 0, 0);
  const [w, h] = [width, height].map((side) => Math.max(1, Math.round(side * ratio)));
  if (columns === w && rows === h) return found;
  const canvas = canvasOf(w, h);
  canvas.getContext("2d")?.drawImage(found, 0, 0, w, h);
  return canvas;
}

/** @param {number} width @param {number} height */
function canvasOf(width, height) {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width, height];
  return canvas;
}
