/**
 * Edits of the list of curves as pure functions: curves come in, and change places, with their sample counts and pins.
 *
 * @import { Curve, CurvesDocument, Point, Shape } from "../types.js"
 */
import { isOpen } from "../spline.js";
import { withPins } from "../state/curve-edits.js";
import { tidy } from "../state/edits.js";
import { nesting } from "../state/nest.js";
import { sideOf } from "../state/open.js";

/**
 * Puts a curve at a place of the list. A pin of the span that it comes into goes.
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {Curve} curve
 * @param {number} samples
 * @returns {CurvesDocument}
 */
export function putCurve(document, index, curve, samples) {
  const { curves, sampling } = document;
  const counts = sampling.counts.slice(0, curves.length).toSpliced(index, 0, samples);
  while (counts.length < 2) counts.push(samples);
  const next = { ...document, curves: curves.toSpliced(index, 0, curve), sampling: { ...sampling, counts } };
  return withPins(next, (pair) => (pair === index - 1 && index < curves.length ? null : pair >= index ? pair + 1 : pair));
}

/**
 * Puts a curve before or after its neighbour in the list. Pins between the two stay, with their ends exchanged; those of the spans beside
 * them go.
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {-1 | 1} by
 * @returns {CurvesDocument}
 */
export function moveCurve(document, index, by) {
  const { curves, sampling, matching } = document;
  const other = index + by;
  if (!curves[index] || !curves[other]) return document;
  const first = Math.min(index, other);
  /** @template T @param {T[]} list */
  const exchanged = (list) => list.toSpliced(first, 2, list[first + 1], list[first]);
  const turned = matching.pins?.map((pin) => ((pin.pair ?? 0) === first ? { ...pin, u: pin.v, v: pin.u } : pin));
  const next = {
    ...document,
    curves: exchanged(curves),
    sampling: { ...sampling, counts: exchanged(sampling.counts) },
    matching: turned ? { ...matching, pins: turned } : matching,
  };
  return withPins(next, (pair) => (pair === first - 1 || pair === first + 1 ? null : pair));
}

/**
 * A curve for an end of the list, from the curve that is there: farther out or in than its neighbour is, as high again, or beside an open one.
 * It is of the material that stands at its place.
 * @param {CurvesDocument} document
 * @param {"first" | "last"} end
 * @returns {Curve}
 */
export function beyond({ curves, materials }, end) {
  const at = end === "first" ? 0 : curves.length - 1;
  const curve = curves[at];
  const neighbour = /** @type {Curve | undefined} */ (curves[end === "first" ? 1 : at - 1]);
  const { degree, form, knots } = curve;
  const material = Math.min(curves.length, materials.length - 1);
  return {
    degree,
    form,
    points: isOpen(curve) ? beside(curves, at, neighbour) : round(curve, neighbour),
    ...(knots ? { knots: [...knots] } : {}),
    height: tidy(2 * curve.height - (neighbour?.height ?? curve.height)),
    composition: [{ at: 0, mix: materials.map((_, i) => (i === material ? 1 : 0)) }],
  };
}

/** Least and greatest factor from a curve to the next one out. */
const FACTORS = { least: 1.15, most: 1 / 0.6 };

/**
 * The points of a closed curve about its middle, away from its neighbour, by as much as the neighbour is away.
 * @param {Curve} curve
 * @param {Curve | undefined} neighbour
 * @returns {Point[]}
 */
function round(curve, neighbour) {
  const { center, scale } = nesting(curve);
  const ratio = neighbour ? Math.sqrt(extent(curve) / extent(neighbour)) : FACTORS.most;
  const isOut = ratio >= 1;
  const wanted = Math.min(FACTORS.most, Math.max(FACTORS.least, isOut ? ratio : 1 / ratio));
  // A copy that is only a little smaller may still meet a curve that winds; one at the scale found does not.
  const factor = neighbour && scale > 0.55 ? wanted : 1 / scale;
  return curve.points.map((at) => scaled(at, center, isOut ? factor : 1 / factor));
}

/**
 * The points of an open curve beside it, on the side away from its neighbour, a quarter of the way from end to end.
 * @param {Curve[]} curves
 * @param {number} at
 * @param {Curve | undefined} neighbour
 * @returns {Point[]}
 */
function beside(curves, at, neighbour) {
  const { points } = curves[at];
  const [[ax, ay], [bx, by]] = [points[0], points[points.length - 1]];
  const side = neighbour ? -sideOf([curves[at], neighbour], 0) : -1;
  return points.map(([x, y]) => [tidy(x + (side * (by - ay)) / 4), tidy(y - (side * (bx - ax)) / 4)]);
}

/** @param {Shape} curve */
function extent({ points }) {
  const span = (/** @type {number[]} */ values) => Math.max(...values) - Math.min(...values);
  return span(points.map(([x]) => x)) * span(points.map(([, y]) => y));
}

/** @param {Point} at @param {Point} about @param {number} by @returns {Point} */
const scaled = ([x, y], [cx, cy], by) => [tidy(cx + (x - cx) * by), tidy(cy + (y - cy) * by)];
