/**
 * The frames of a morph, painted by the kernel, and a zip of them.
 *
 * @import { App } from "../state/app.js"
 * @import { Appearance } from "../files/pictures.js"
 * @import { Picture, Size } from "../types.js"
 * @import { Motion } from "./motion.js"
 *
 * @typedef {object} Working
 * @property {AbortSignal} signal
 * @property {(done: number, of: number) => void} onframe
 *
 * @typedef {Size & Appearance & {motion: Motion, count: number}} Sequence
 */
import { Zip, ZipPassThrough } from "fflate";
import { blobOf, paintOptions } from "../files/pictures.js";
import { lookedAt } from "../state/look.js";
import { places } from "./motion.js";
import { words } from "./words.js";

/** Most frames of a sequence of pictures, and most pixels in all of them, which bounds the memory they take. */
export const MOST_FRAMES = 600;
export const MOST_PIXELS = 600e6;
export const FEWEST_FRAMES = 2;

/**
 * Paints the frames one after the other, all of the document and the view as they stand now.
 * @param {App} app
 * @param {Sequence} sequence
 * @param {Working} working
 * @returns {AsyncGenerator<Picture>}
 */
export async function* painted(app, { motion, count, ...wanted }, { signal, onframe }) {
  const document = lookedAt(app);
  const options = paintOptions(app, wanted);
  const all = places(motion, count);
  for (const [i, s] of all.entries()) {
    yield await app.kernel.paint(document, { ...options, s }, { signal });
    signal.throwIfAborted();
    onframe(i + 1, count);
  }
}

/**
 * @param {App} app
 * @param {Sequence} sequence
 * @param {string} name of the files, without number and ending
 * @param {Working} working
 * @returns {Promise<Blob>}
 */
export async function pngSequence(app, sequence, name, working) {
  const pixels = sequence.width * sequence.height * sequence.count;
  if (pixels > MOST_PIXELS) {
    throw new RangeError(words.tooMany(words.megapixels(Math.ceil(pixels / 1e6)), words.megapixels(MOST_PIXELS / 1e6)));
  }
  /** @type {BlobPart[]} */
  const parts = [];
  /** @type {Error | null} */
  let failure = null;
  const zip = new Zip((error, data) => {
    if (error) failure = error;
    else parts.push(new Uint8Array(data));
  });
  const digits = String(sequence.count).length;
  let number = 0;
  for await (const picture of painted(app, sequence, working)) {
    number += 1;
    // A PNG is packed already.
    const file = new ZipPassThrough(`${name}-${String(number).padStart(digits, "0")}.png`);
    zip.add(file);
    file.push(new Uint8Array(await (await blobOf(picture)).arrayBuffer()), true);
    if (failure) throw failure;
  }
  zip.end();
  return new Blob(parts, { type: "application/zip" });
}
