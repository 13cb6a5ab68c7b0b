/**
 * Snapping to the grid as the kernel draws it.
 *
 * @import { App } from "../state/app.js"
 * @import { Point } from "../types.js"
 */
import { aimed, gridStep } from "../view.js";

/**
 * Where a place that is aimed at comes to rest: on the grid with snapping, else on a decimal that can be aimed at.
 * @param {App} app
 * @param {Point} at document units
 * @param {boolean} invert whether Control is held
 * @returns {Point}
 */
export function rested({ ui }, at, invert) {
  const { view, snap } = ui.value;
  if (!view) return at;
  if (snap === invert) return [aimed(at[0], view), aimed(at[1], view)];
  return snappedTo(at, gridStep(view.scale));
}

/**
 * @param {Point} at
 * @param {number} step
 * @returns {Point}
 */
export function snappedTo([x, y], step) {
  const snapped = (/** @type {number} */ value) => Number((Math.round(value / step) * step).toPrecision(12)) + 0;
  return [snapped(x), snapped(y)];
}
