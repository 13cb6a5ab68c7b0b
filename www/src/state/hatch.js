/**
 * Hatches that stand in for the colours of materials, as the kernel draws them: by index 0, 45, 90 and 135 degrees, counter-clockwise from the
 * horizontal, then the same with lines farther apart.
 *
 * @import { Material } from "../types.js"
 */

/** CSS pixels from one line to the next in a swatch, and the width of a line. */
const PERIOD = 5;
const WIDTH = 1.5;

/**
 * The hatch of a material as an image for a background; none for empty space.
 * @param {number} index
 * @param {Material} material
 */
export function hatch(index, { void: isVoid }) {
  if (isVoid) return "none";
  // A gradient runs across its lines, and its angle is clockwise from the top.
  const angle = (180 - (index % 4) * 45) % 180;
  const period = PERIOD * (1 + Math.floor(index / 4) / 2);
  return `repeating-linear-gradient(${angle}deg, currentcolor 0 ${WIDTH}px, transparent ${WIDTH}px ${period}px)`;
}

/**
 * Gives an element the hatch of a material, or takes it away.
 * @param {HTMLElement} element
 * @param {boolean} on
 * @param {number} index
 * @param {Material} material
 */
export function setHatch(element, on, index, material) {
  element.classList.toggle("hatched", on);
  if (on) element.style.setProperty("--hatch", hatch(index, material));
}
