/**
 * The presets, each with a small picture painted by the kernel.
 *
 * @import { App } from "../state/app.js"
 * @import { Size } from "../types.js"
 * @import { Item } from "./menu.js"
 *
 * @typedef {{id: string, title: string, line: string}} Preset
 */
import { h } from "../dom.js";
import { openDocument } from "../files/open.js";
import { completed, imageData } from "../kernel.js";
import { devicePixels } from "../painter.js";

/** @type {Size} */
const THUMBNAIL = { width: 84, height: 60 };
/** Lines of a thumbnail are this much thinner than in the figure, and its margins are a fifth as wide. */
const THIN = 0.6;
const MARGIN = 5;

/** @type {{[path: string]: unknown}} */
const files = import.meta.glob("../../presets/*.json", { eager: true, import: "default" });

/** The list of presets, in the order of the gallery; the first one opens with the page. */
export const presets = /** @type {Preset[]} */ (files["../../presets/index.json"]);

/** @param {string} id @returns {unknown} */
export function presetDocument(id) {
  return files[`../../presets/${id}.json`];
}

/**
 * @param {App} app
 * @returns {Item[]}
 */
export function galleryItems(app) {
  return presets.map(({ id, title, line }) => {
    const picture = h("canvas", { class: "thumbnail", "aria-hidden": "true" });
    void paintThumbnail(app, picture, presetDocument(id));
    return {
      name: id,
      text: title,
      line,
      lead: picture,
      act: () => void openDocument(app, presetDocument(id), title),
    };
  });
}

/**
 * @param {App} app
 * @param {HTMLCanvasElement} canvas
 * @param {unknown} raw
 */
async function paintThumbnail(app, canvas, raw) {
  try {
    const { view: _, ...preset } = await completed(app.kernel, raw);
    const { width, height } = THUMBNAIL;
    const whole = await app.kernel.fit(preset, { width: width * MARGIN, height: height * MARGIN, pixelRatio: 1 });
    const ratio = window.devicePixelRatio || 1;
    const picture = await app.kernel.paint(preset, {
      ...devicePixels(THUMBNAIL, ratio),
      pixelRatio: ratio * THIN,
      view: { center: whole.center, scale: whole.scale / MARGIN / THIN },
      layers: ["material"],
      theme: app.ui.value.theme,
      s: null,
      line: null,
      background: false,
    });
    canvas.width = picture.width;
    canvas.height = picture.height;
    canvas.getContext("2d")?.putImageData(imageData(picture), 0, 0);
  } catch {
    canvas.hidden = true;
  }
}
