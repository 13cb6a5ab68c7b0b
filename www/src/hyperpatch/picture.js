/**
 * The picture of the open body for elsewhere: the workbench draws it, the panel Export asks for it.
 *
 * @import { PictureWanted } from "../files/picture-rows.js"
 * @import { Size } from "../types.js"
 *
 * @typedef {object} Maker
 * @property {Size} size of the picture on the screen
 * @property {(wanted: PictureWanted) => OffscreenCanvas | null} picture null where there is none of that size
 */
import { words } from "./words.js";

/** @type {Maker | null} */
let maker = null;

/** @param {Maker | null} next null where nothing is drawn any more */
export function offer(next) {
  maker = next;
}

/** The size of the picture on the screen; null where nothing is drawn. */
export const pictureSize = () => maker?.size ?? null;

/** PNG of what is seen. @param {PictureWanted} wanted @returns {Promise<Blob>} */
export async function bodyPicture(wanted) {
  const canvas = maker?.picture(wanted);
  if (!canvas) throw new Error(maker ? words.exports.tooLarge : words.exports.noPicture);
  return canvas.convertToBlob({ type: "image/png" });
}
