/**
 * The scales of the plot: what distances it shows, and how pixels and values go together.
 *
 * @typedef {object} Scales
 * @property {number} most distance at the right end
 * @property {number} tick between two numbers of the axis
 * @property {number} step to which dragged distances are rounded
 * @property {(distance: number) => number} x CSS pixels
 * @property {(fraction: number) => number} y CSS pixels
 * @property {(x: number) => number} distance
 * @property {(y: number) => number} fraction
 * @property {{left: number, top: number, right: number, bottom: number}} frame CSS pixels
 */

/** CSS pixels round the plot. */
const ROOM = { left: 32, right: 10, top: 34, bottom: 20 };
export const HEIGHT = 176;

/** The least number of 1, 2, 3 or 5 times a power of ten that is no less. @param {number} value */
export function nice(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  const digit = [1, 2, 3, 5, 10].find((each) => each * power >= value * (1 - 1e-9)) ?? 10;
  return Number((digit * power).toPrecision(6));
}

/** Where the axis ends for a limit, with room to drag it farther, and the distance between its numbers. @param {number} to */
export function reachOf(to) {
  const tick = nice(to / 4);
  return { tick, most: Number((Math.ceil((to * 1.2) / tick - 1e-9) * tick).toPrecision(9)) };
}

/**
 * @param {number} width of the whole in CSS pixels
 * @param {{tick: number, most: number}} reach
 * @returns {Scales}
 */
export function scalesOf(width, { tick, most }) {
  const frame = { left: ROOM.left, top: ROOM.top, right: Math.max(ROOM.left + 1, width - ROOM.right), bottom: HEIGHT - ROOM.bottom };
  const [wide, tall] = [frame.right - frame.left, frame.bottom - frame.top];
  return {
    most,
    tick,
    step: nice(most / 500),
    frame,
    x: (distance) => frame.left + (wide * distance) / most,
    y: (fraction) => frame.bottom - tall * fraction,
    distance: (x) => Math.min(most, Math.max(0, ((x - frame.left) / wide) * most)),
    fraction: (y) => Math.min(1, Math.max(0, (frame.bottom - y) / tall)),
  };
}

/** Rounded to a step, without the traces of binary fractions. @param {number} value @param {number} step */
export const rounded = (value, step) => Number((Math.round(value / step) * step).toPrecision(9));
