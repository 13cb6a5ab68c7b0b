/**
 * The small picture of a document in a list: curves painted by the kernel, bodies as its figures on other pages are.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Size } from "../types.js"
 */
import { imageData } from "../kernel.js";
import { kindOf } from "../kinds/kinds.js";
import { devicePixels } from "../painter.js";

/** @type {Size} */
const THUMBNAIL = { width: 84, height: 60 };
/** Device pixels for one of the screen: sharp on most screens, and still a few kilobytes. */
const RATIO = 2;
/** Lines are this much thinner than in the figure, and margins are a fifth as wide. */
const THIN = 0.6;
const MARGIN = 5;
/** Milliseconds after which the list does without a new picture. */
const PATIENCE = 2000;

/**
 * Addresses of the picture on a light and on a dark ground, as data; null when it cannot be painted now.
 * @param {App} app
 * @param {CurvesDocument} document
 * @returns {Promise<{light: string, dark: string} | null>}
 */
export async function thumbnails(app, document) {
  const signal = AbortSignal.timeout(PATIENCE);
  try {
    const kind = await kindOf(document);
    if (kind) {
      const both = await kind.thumbnail(app.kernel, document, THUMBNAIL, RATIO, signal);
      return { light: both, dark: both };
    }
    const { width, height } = THUMBNAIL;
    const room = { width: width * MARGIN, height: height * MARGIN, pixelRatio: 1 };
    const whole = await app.kernel.fit(document, room, { signal });
    /** @param {"light" | "dark"} theme */
    const painted = async (theme) => {
      const options = {
        ...devicePixels(THUMBNAIL, RATIO),
        pixelRatio: RATIO * THIN,
        view: { center: whole.center, scale: whole.scale / MARGIN / THIN },
        layers: /** @type {["material"]} */ (["material"]),
        theme,
        s: null,
        line: null,
        background: false,
      };
      const picture = await app.kernel.paint(document, options, { signal });
      const canvas = globalThis.document.createElement("canvas");
      canvas.width = picture.width;
      canvas.height = picture.height;
      canvas.getContext("2d")?.putImageData(imageData(picture), 0, 0);
      return canvas.toDataURL("image/png");
    };
    return { light: await painted("light"), dark: await painted("dark") };
  } catch {
    return null;
  }
}
