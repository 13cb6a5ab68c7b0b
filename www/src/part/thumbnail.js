/**
 * The small picture of a part in a list: its colours, with room round them.
 *
 * @import { PartDocument } from "../../../js/directrix.js"
 * @import { Kernel, Size } from "../types.js"
 */

/** Share of the picture that stays free at each edge. */
const MARGIN = 0.05;

/**
 * @param {Kernel} kernel
 * @param {PartDocument} document
 * @param {Size} size CSS pixels
 * @param {number} ratio device pixels for one of them
 * @param {AbortSignal} [signal]
 * @returns {Promise<string>} its address as data; it stands on a light and on a dark ground
 */
export async function partThumbnail(kernel, document, size, ratio, signal) {
  const control = signal ? { signal } : {};
  const part = await kernel.part(document, control);
  const canvas = globalThis.document.createElement("canvas");
  canvas.width = size.width * ratio;
  canvas.height = size.height * ratio;
  if (!part.box) return canvas.toDataURL("image/png");
  const [[left, low], [right, high]] = part.box;
  const free = 1 - 2 * MARGIN;
  const scale = Math.max((right - left) / canvas.width, (high - low) / canvas.height) / free;
  const [x, y] = [(left + right) / 2, (low + high) / 2];
  const [across, up] = [(scale * canvas.width) / 2, (scale * canvas.height) / 2];
  const { colors } = await part.evaluate(
    { box: [[x - across, y - up], [x + across, y + up]], size: [canvas.width, canvas.height], colors: true },
    control,
  );
  const pixels = new Uint8ClampedArray(/** @type {Uint8Array<ArrayBuffer>} */ (colors));
  canvas.getContext("2d")?.putImageData(new ImageData(pixels, canvas.width), 0, 0);
  return canvas.toDataURL("image/png");
}
