/**
 * The picture of a part on a canvas of its own: grid, pixels put where the view has them, hatching where design rules are broken. What was evaluated
 * last follows pan and zoom at once, until the next pixels come.
 *
 * @import { Point, Size, View } from "../types.js"
 * @import { Pixels } from "./pixels.js"
 *
 * @typedef {{pixels: Pixels, size: [number, number], box: [Point, Point]}} Sheet Pixels with their place in document units.
 */
import { h } from "../dom.js";
import { gridStep, toPlane, toScreen } from "../view.js";

/** Opacity of thin and strong grid lines, in a light and in a dark page. */
const GRID = { light: [0.45, 1], dark: [0.38, 0.9] };
/** Distance and width of the hatching, CSS pixels. */
const HATCH = { step: 7, width: 1.5 };

export function createCanvas() {
  const canvas = h("canvas", { class: "part-picture", role: "img" });
  const context = canvas.getContext("2d");
  /** Surfaces that pixels are put on, by their use. @type {{[use: string]: HTMLCanvasElement}} */
  const surfaces = {};
  /** What they hold. @type {{[use: string]: Pixels}} */
  const held = {};

  /** Pixels as something that can be drawn. @param {string} use @param {Sheet} sheet */
  function surfaceOf(use, { pixels, size: [wide, tall] }) {
    const surface = (surfaces[use] ??= document.createElement("canvas"));
    if (held[use] === pixels) return surface;
    held[use] = pixels;
    if (surface.width !== wide || surface.height !== tall) [surface.width, surface.height] = [wide, tall];
    surface.getContext("2d")?.putImageData(new ImageData(pixels, wide, tall), 0, 0);
    return surface;
  }

  return {
    canvas,
    /**
     * @param {object} picture
     * @param {View} picture.view
     * @param {Size} picture.size CSS pixels
     * @param {"light" | "dark"} picture.theme
     * @param {boolean} picture.hasGrid
     * @param {Sheet[]} picture.sheets from below; each covers those before it within its box
     * @param {Sheet | null} picture.broken opaque where design rules are broken
     */
    draw({ view, size, theme, hasGrid, sheets, broken }) {
      if (!context) return;
      const ratio = window.devicePixelRatio || 1;
      const [width, height] = [Math.round(size.width * ratio), Math.round(size.height * ratio)];
      if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
      context.setTransform(1, 0, 0, 1, 0, 0);
      context.clearRect(0, 0, width, height);
      /** @param {Sheet} sheet @returns {[number, number, number, number]} */
      const place = ({ box: [[left, low], [right, high]] }) => {
        const [x0, y0] = toScreen(view, size, [left, high]);
        const [x1, y1] = toScreen(view, size, [right, low]);
        return [x0 * ratio, y0 * ratio, (x1 - x0) * ratio, (y1 - y0) * ratio];
      };
      sheets.forEach((sheet, n) => {
        const at = place(sheet);
        context.clearRect(...at);
        const isSmall = at[2] < sheet.size[0];
        context.imageSmoothingEnabled = isSmall || at[2] < 3 * sheet.size[0];
        context.drawImage(surfaceOf(`sheet ${n}`, sheet), ...at);
      });
      if (broken) hatch(context, surfaceOf("broken", broken), place(broken), ratio, getComputedStyle(canvas).getPropertyValue("--error"));
      if (!hasGrid) return;
      context.globalCompositeOperation = "destination-over";
      drawGrid(context, view, size, ratio, GRID[theme], getComputedStyle(canvas).getPropertyValue("--line"));
      context.globalCompositeOperation = "source-over";
    },
  };

  /**
   * @param {CanvasRenderingContext2D} target
   * @param {HTMLCanvasElement} mask
   * @param {[number, number, number, number]} at
   * @param {number} ratio
   * @param {string} color
   */
  function hatch(target, mask, at, ratio, color) {
    const sheet = (surfaces.hatch ??= document.createElement("canvas"));
    [sheet.width, sheet.height] = [target.canvas.width, target.canvas.height];
    const layer = sheet.getContext("2d");
    if (!layer) return;
    layer.imageSmoothingEnabled = false;
    layer.drawImage(mask, ...at);
    layer.globalCompositeOperation = "source-in";
    layer.strokeStyle = color;
    layer.lineWidth = HATCH.width * ratio;
    layer.beginPath();
    const step = HATCH.step * Math.SQRT2 * ratio;
    for (let x = -sheet.height; x < sheet.width; x += step) {
      layer.moveTo(x, sheet.height);
      layer.lineTo(x + sheet.height, 0);
    }
    layer.stroke();
    target.drawImage(sheet, 0, 0);
  }
}

/**
 * The lines of the grid, as the kernel draws them behind curves: every fifth, fifth or fourth is strong.
 * @param {CanvasRenderingContext2D} context
 * @param {View} view
 * @param {Size} size
 * @param {number} ratio
 * @param {number[]} opacity of thin and of strong lines
 * @param {string} color
 */
function drawGrid(context, view, size, ratio, opacity, color) {
  const step = gridStep(view.scale);
  const strong = Math.round(step / 10 ** Math.floor(Math.log10(step) + 1e-9)) === 5 ? 4 : 5;
  const [left, low] = toPlane(view, size, [0, size.height]);
  const [right, high] = toPlane(view, size, [size.width, 0]);
  context.strokeStyle = color;
  context.lineWidth = ratio;
  for (const isStrong of [false, true]) {
    context.globalAlpha = opacity[Number(isStrong)];
    context.beginPath();
    for (const axis of [0, 1]) {
      const [first, last] = [Math.ceil((axis ? low : left) / step), Math.floor((axis ? high : right) / step)];
      for (let k = first; k <= last; k += 1) {
        if ((k % strong === 0) !== isStrong) continue;
        const at = (Math.round(toScreen(view, size, axis ? [0, k * step] : [k * step, 0])[axis] * ratio - 0.5 * ratio) + 0.5 * ratio);
        context.moveTo(axis ? 0 : at, axis ? at : 0);
        context.lineTo(axis ? context.canvas.width : at, axis ? at : context.canvas.height);
      }
    }
    context.stroke();
  }
  context.globalAlpha = 1;
}
