/**
 * Curves in space, which the module `figure` does not read.
 *
 * @import { Curve, CurvesDocument, Point } from "../directrix.js"
 */

/**
 * Whether the control points of a document lie in space; asked of what may be no document at all.
 *
 * @param {CurvesDocument | null | undefined} document
 */
export function isInSpace(document) {
  const point = document?.curves?.[0]?.points?.[0];
  return Array.isArray(point) && point.length > 2;
}

/** The control points of a curve in its plane, as all curves are that have handles. @param {Curve} curve */
export const planePoints = (curve) => /** @type {Point[]} */ (curve.points);
