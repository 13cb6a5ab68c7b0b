/**
 * The figure as a picture for elsewhere, at a size of its own.
 *
 * @import { App } from "../state/app.js"
 * @import { PaintOptions, Size } from "../types.js"
 *
 * @typedef {object} Appearance
 * @property {"light" | "dark"} theme
 * @property {boolean} transparent
 */
import { imageData } from "../kernel.js";
import { lookedAt } from "../state/look.js";

/** Longest side of a picture in pixels. */
export const LARGEST = 4096;

/** Widths of lines that the kernel paints, against those on the screen: smaller and larger pictures keep these. */
const FINEST = 0.1;
const WIDEST = 16;

/**
 * The size of a picture with so many pixels for one of the screen, as far as `LARGEST` allows.
 * @param {Size} size of the figure on the screen
 * @param {number} scale
 * @returns {Size}
 */
export function scaledSize({ width, height }, scale) {
  const most = Math.min(scale, LARGEST / Math.max(width, height));
  return { width: Math.max(1, Math.round(width * most)), height: Math.max(1, Math.round(height * most)) };
}

/**
 * What the kernel paints for a picture of what the figure shows. Where the shape of the picture is another, more of the plane is seen
 * beside it.
 * @param {App} app
 * @param {Size & Appearance} wanted in pixels
 * @returns {PaintOptions}
 */
export function paintOptions(app, { width, height, ...appearance }) {
  const { size, view } = app.ui.value;
  const magnified = Math.min(width / size.width, height / size.height);
  const pixelRatio = Math.min(WIDEST, Math.max(FINEST, magnified));
  return {
    ...options(app, appearance),
    ...(view ? { view: { center: view.center, scale: (view.scale * magnified) / pixelRatio } } : {}),
    width,
    height,
    pixelRatio,
  };
}

/**
 * PNG of what the figure shows.
 * @param {App} app
 * @param {Size & Appearance} wanted in pixels
 * @returns {Promise<Blob>}
 */
export async function pngOf(app, wanted) {
  return blobOf(await app.kernel.paint(lookedAt(app), paintOptions(app, wanted)));
}

/**
 * PNG of painted pixels.
 * @param {import("../types.js").Picture} picture
 * @returns {Promise<Blob>}
 */
export function blobOf(picture) {
  const canvas = new OffscreenCanvas(picture.width, picture.height);
  canvas.getContext("2d")?.putImageData(imageData(picture), 0, 0);
  return canvas.convertToBlob({ type: "image/png" });
}

/**
 * SVG of what the figure shows, one unit for each pixel of the screen.
 * @param {App} app
 * @param {Appearance} appearance
 * @param {{s?: null}} [place] `s: null` leaves the current in-between out
 * @returns {Promise<string>}
 */
export function svgOf(app, appearance, place = {}) {
  const { width, height } = app.ui.value.size;
  return app.kernel.svg(lookedAt(app), { ...options(app, appearance), ...place, width, height });
}

/**
 * @param {App} app
 * @param {Appearance} appearance
 * @returns {Omit<PaintOptions, "width" | "height">}
 */
function options(app, { theme, transparent }) {
  const { view, layers, s, isoMaterial, patterns } = app.ui.value;
  return { ...(view ? { view } : {}), layers, theme, s, isoMaterial, patterns, line: null, background: !transparent };
}
