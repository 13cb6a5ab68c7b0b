/**
 * Which vertex lies nearest to a place on the screen.
 *
 * @import { Steps } from "../../../js/directrix.js"
 * @import { Point, Size, View } from "../types.js"
 * @import { Vertex } from "./picture.js"
 */
import { toScreen } from "../view.js";

/** Distance of a press from the vertex that it means, by pointer and by touch, CSS pixels. */
export const REACH = { mouse: 16, touch: 26 };

/**
 * @param {Steps} steps
 * @param {View} view
 * @param {Size} size
 * @param {Point} place on the screen
 * @param {readonly (0 | 1)[]} curves whose vertices count
 * @param {number} [reach] least distance that is too far, CSS pixels
 * @returns {Vertex | null}
 */
export function nearestVertex({ samples }, view, size, place, curves, reach = Infinity) {
  /** @type {Vertex | null} */
  let found = null;
  let least = reach;
  for (const curve of curves) {
    samples[curve]?.points.forEach((point, vertex) => {
      const [x, y] = toScreen(view, size, point);
      const distance = Math.hypot(x - place[0], y - place[1]);
      if (distance < least) [least, found] = [distance, { curve, vertex }];
    });
  }
  return found;
}
