/**
 * Puts the kernel's pixels on the canvas. While a newer picture is on its way, the last one follows pan and zoom.
 *
 * @import { App } from "../state/app.js"
 * @import { Picture, View } from "../types.js"
 */
import { attribute, find } from "../dom.js";
import { imageData } from "../kernel.js";
import { strings } from "../strings.js";
import { toScreen } from "../view.js";

/** @param {App} app */
export function createCanvas(app) {
  const canvas = /** @type {HTMLCanvasElement} */ (find("#picture"));
  const context = canvas.getContext("2d", { alpha: false });
  const source = document.createElement("canvas");
  const sourceContext = source.getContext("2d");
  /** @type {Picture | null} */
  let held = null;
  /** @type {View | null} */
  let drawnFor = null;
  let drawnSize = "";
  let drawnTheme = "";

  return {
    render() {
      const { picture } = app.results.value;
      const { view, size, theme } = app.ui.value;
      const { title, curves } = app.store.document;
      attribute(canvas, "aria-label", strings.canvas.picture(title, curves.length));
      if (!picture || !view || !context || !sourceContext) return;
      const ratio = window.devicePixelRatio || 1;
      const width = Math.round(size.width * ratio);
      const height = Math.round(size.height * ratio);
      const sizeNow = `${width} ${height}`;
      if (picture === held && view === drawnFor && sizeNow === drawnSize && theme === drawnTheme) return;
      if (sizeNow !== drawnSize) {
        canvas.width = width;
        canvas.height = height;
      }
      if (picture !== held) {
        source.width = picture.width;
        source.height = picture.height;
        sourceContext.putImageData(imageData(picture), 0, 0);
      }
      [held, drawnFor, drawnSize, drawnTheme] = [picture, view, sizeNow, theme];
      blit(context, source, picture, view, size, ratio);
      document.documentElement.dataset.ready = "true";
    },
  };
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {HTMLCanvasElement} source
 * @param {Picture} picture
 * @param {View} view
 * @param {{width: number, height: number}} size
 * @param {number} ratio
 */
function blit(context, source, picture, view, size, ratio) {
  const grown = view.scale / picture.view.scale;
  const [x, y] = toScreen(view, size, picture.view.center);
  const moved = Math.abs(grown - 1) > 1e-9 || Math.abs(x - size.width / 2) + Math.abs(y - size.height / 2) > 0.01;
  if (!moved) {
    context.drawImage(source, 0, 0, context.canvas.width, context.canvas.height);
    return;
  }
  const width = size.width * grown;
  const height = size.height * grown;
  context.fillStyle = getComputedStyle(context.canvas).backgroundColor;
  context.fillRect(0, 0, context.canvas.width, context.canvas.height);
  context.drawImage(source, (x - width / 2) * ratio, (y - height / 2) * ratio, width * ratio, height * ratio);
}
