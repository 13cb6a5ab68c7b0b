/**
 * The colours of all mixes of three materials, on a canvas in the shape of a triangle: the first material at the lower left, the
 * second at the lower right, the third on top.
 */
import { h } from "../dom.js";
import { mixed } from "../oklab.js";

/** Stops of a row's gradient. The canvas blends between them in sRGB, which at this distance does not show. */
const STOPS = 12;

/** Height of a triangle whose side is 1. */
export const TALL = Math.sqrt(3) / 2;

/**
 * @param {number} side CSS pixels
 */
export function triangle(side) {
  const ratio = 2;
  const [width, height] = [side * ratio, Math.round(side * TALL * ratio)];
  const canvas = h("canvas", { width, height, class: "triangle-colors", "aria-hidden": "true" });
  canvas.style.width = `${side}px`;
  canvas.style.height = `${height / ratio}px`;
  let drawn = "";

  return {
    element: canvas,
    /** @param {string[]} colors of the three materials, `#rrggbb` */
    draw(colors) {
      const context = canvas.getContext("2d");
      if (!context || drawn === String(colors)) return;
      drawn = String(colors);
      context.clearRect(0, 0, width, height);
      for (let y = 0; y < height; y += 1) {
        const third = 1 - (y + 0.5) / height;
        const left = (third * width) / 2;
        const row = context.createLinearGradient(left, 0, width - left, 0);
        for (let i = 0; i <= STOPS; i += 1) {
          const second = ((1 - third) * i) / STOPS;
          row.addColorStop(i / STOPS, mixed(colors, [1 - third - second, second, third]));
        }
        context.fillStyle = row;
        context.fillRect(left, y, width - 2 * left, 1);
      }
    },
  };
}
