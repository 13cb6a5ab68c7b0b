/**
 * Edits as pure functions from one document to the next.
 *
 * @import { Curve, CurvesDocument, Matching, Point, Sampling, Blend, Material } from "../types.js"
 */
import { dropKnot } from "../spline.js";

/** Most materials the format allows. */
export const MATERIAL_LIMIT = 16;

/**
 * Control points that have a handle: a clamped curve repeats its first point at the end, and both share one.
 * @param {Curve} curve
 */
export function handleCount(curve) {
  return curve.form === "clamped" ? curve.points.length - 1 : curve.points.length;
}

/**
 * Whether a control point can go: a closed curve of degree p keeps at least p + 1.
 * @param {Curve} curve
 */
export function canRemovePoint(curve) {
  return curve.points.length > curve.degree + 1 && handleCount(curve) > 3;
}

/**
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {(curve: Curve) => Curve} change
 * @returns {CurvesDocument}
 */
export function changeCurve(document, index, change) {
  const curve = /** @type {Curve} */ (document.curves[index]);
  const next = change(curve);
  if (next === curve) return document;
  const curves = /** @type {[Curve, Curve]} */ (document.curves.map((other, i) => (i === index ? next : other)));
  return { ...document, curves };
}

/**
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {number} point
 * @param {Point} to
 */
export function movePoint(document, index, point, to) {
  return changeCurve(document, index, (curve) => {
    const from = curve.points[point];
    if (!from || (from[0] === to[0] && from[1] === to[1])) return curve;
    const seam = curve.form === "clamped" && point === 0 ? curve.points.length - 1 : point;
    /** @type {Point[]} */
    const points = curve.points.map((p, i) => (i === point || i === seam ? [to[0], to[1]] : p));
    return { ...curve, points };
  });
}

/**
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {Point} by
 */
export function moveCurve(document, index, by) {
  if (by[0] === 0 && by[1] === 0) return document;
  return changeCurve(document, index, (curve) => ({
    ...curve,
    points: curve.points.map(([x, y]) => /** @type {Point} */ ([tidy(x + by[0]), tidy(y + by[1])])),
  }));
}

/**
 * Takes a control point away, and the knot that belonged to it.
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {number} point
 */
export function removePoint(document, index, point) {
  return changeCurve(document, index, (curve) => {
    if (!canRemovePoint(curve) || point >= handleCount(curve)) return curve;
    let points = curve.points.filter((_, i) => i !== point);
    if (curve.form === "clamped" && point === 0) {
      const first = /** @type {Point} */ (points[0]);
      points = [...points.slice(0, -1), [first[0], first[1]]];
    }
    const { knots: _, ...rest } = curve;
    const knots = dropKnot(curve, point);
    return knots ? { ...rest, points, knots } : { ...rest, points };
  });
}

/**
 * @template {"sampling" | "matching" | "blend"} Part
 * @param {CurvesDocument} document
 * @param {Part} part
 * @param {Partial<{sampling: Sampling, matching: Matching, blend: Blend}[Part]>} patch
 * @returns {CurvesDocument}
 */
export function patch(document, part, patch) {
  return { ...document, [part]: { ...document[part], ...patch } };
}

/**
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {Partial<Material>} change
 * @returns {CurvesDocument}
 */
export function changeMaterial(document, index, change) {
  const materials = document.materials.map((material, i) => (i === index ? { ...material, ...change } : material));
  return { ...document, materials };
}

/**
 * @param {CurvesDocument} document
 * @param {Material} material
 * @returns {CurvesDocument}
 */
export function addMaterial(document, material) {
  if (document.materials.length >= MATERIAL_LIMIT) return document;
  return withMixes({ ...document, materials: [...document.materials, material] }, (mix) => [...mix, 0]);
}

/**
 * Takes a material away that no curve holds; otherwise the document stays as it is.
 * @param {CurvesDocument} document
 * @param {number} index
 */
export function removeMaterial(document, index) {
  if (document.materials.length < 2 || document.curves.some((curve) => holds(curve, index))) return document;
  const materials = document.materials.filter((_, i) => i !== index);
  return withMixes({ ...document, materials }, (mix) => mix.filter((_, i) => i !== index));
}

/**
 * Gives the whole of a curve one material.
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {number} material
 */
export function assignMaterial(document, index, material) {
  const mix = document.materials.map((_, i) => (i === material ? 1 : 0));
  return changeCurve(document, index, (curve) => ({ ...curve, composition: [{ at: 0, mix }] }));
}

/**
 * Whether some place of the curve holds some of the material.
 * @param {Curve} curve
 * @param {number} material
 */
export function holds(curve, material) {
  return curve.composition.some((key) => (key.mix[material] ?? 0) > 0);
}

/**
 * @param {CurvesDocument} document
 * @param {(mix: number[]) => number[]} change
 * @returns {CurvesDocument}
 */
function withMixes(document, change) {
  const curves = /** @type {[Curve, Curve]} */ (
    document.curves.map((curve) => ({
      ...curve,
      composition: curve.composition.map((key) => ({ ...key, mix: change(key.mix) })),
    }))
  );
  return { ...document, curves };
}

/**
 * Removes the noise of binary addition, so that 0.1 + 0.2 is written 0.3. Twelve significant digits stay.
 * @param {number} value
 */
export function tidy(value) {
  return Number(value.toPrecision(12));
}
