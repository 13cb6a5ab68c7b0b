/**
 * Heights of a document, and the edit that gives one curve another.
 *
 * @import { CurvesDocument, Match } from "../types.js"
 */
import { advice } from "../explain.js";
import { editable } from "../format.js";
import { outline } from "../spline.js";
import { changeCurve } from "../state/edits.js";
import { hasSpace } from "../state/in-space.js";
import { niceBelow } from "../view.js";
import { words } from "./words.js";

/** What a curve is raised by at least, as a share of the diagonal of both. */
const SHARE = 0.45;

/** Whether the curves span a height: theirs differ, or points have heights of their own. @param {CurvesDocument} document */
function hasHeight({ curves }) {
  return hasSpace({ curves }) || curves.some(({ height }) => height !== curves[0].height);
}

/** What a document needs before its curves can bound a solid; null when there is nothing. @param {CurvesDocument} document */
export function lackOf(document) {
  if (document.curves.length < 2) return words.needsTwo;
  return hasHeight(document) ? null : words.level(editable(document.curves[0].height, 0));
}

/** Why curves with heights bound no surface. @param {Match | null} match */
export const reasonOf = (match) => (match && advice(match)) ?? words.unmatched;

/**
 * Which curve to raise, and by how much: the smaller one, so that the surface is seen from above.
 * @param {CurvesDocument} document with two curves or more
 * @returns {{curve: number, by: number}}
 */
export function proposal({ curves }) {
  const boxes = curves.map((curve) => {
    const points = outline(curve).map(({ at }) => at);
    return [0, 1].map((axis) => {
      const values = points.map((point) => point[axis]);
      return [Math.min(...values), Math.max(...values)];
    });
  });
  const span = [0, 1].map((axis) => Math.max(...boxes.map((box) => box[axis][1])) - Math.min(...boxes.map((box) => box[axis][0])));
  const areas = boxes.map(([x, y]) => (x[1] - x[0]) * (y[1] - y[0]));
  return { curve: areas.indexOf(Math.min(...areas)), by: niceBelow(SHARE * Math.hypot(...span)) };
}

/** @param {CurvesDocument} document @param {{curve: number, by: number}} raise */
export const raised = (document, { curve, by }) =>
  changeCurve(document, curve, (before) => ({ ...before, height: before.height + by }));
