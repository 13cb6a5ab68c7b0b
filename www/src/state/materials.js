/**
 * Edits of the materials as pure functions. Every mix of the document follows.
 *
 * @import { Curve, CurvesDocument, Material } from "../types.js"
 */
import { changeCurve, tidy } from "./edits.js";

/** Most materials the format allows. */
export const MATERIAL_LIMIT = 16;

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
 * Takes a material away. Its fractions go to another; without one a material in use stays, and so does the last one.
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {number | null} [into]
 * @returns {CurvesDocument}
 */
export function removeMaterial(document, index, into = null) {
  const { materials } = document;
  if (materials.length < 2 || !materials[index] || into === index) return document;
  if (into === null && isUsed(document, index)) return document;
  return withMixes({ ...document, materials: materials.filter((_, i) => i !== index) }, (mix) =>
    mix
      .map((fraction, i) => (i === into && mix[index] > 0 ? tidy(fraction + mix[index]) : fraction))
      .filter((_, i) => i !== index),
  );
}

/**
 * Changes the order of the materials.
 * @param {CurvesDocument} document
 * @param {number} from
 * @param {number} to
 * @returns {CurvesDocument}
 */
export function moveMaterial(document, from, to) {
  const { materials } = document;
  if (from === to || !materials[from] || !materials[to]) return document;
  /** @template T @param {T[]} list */
  const moved = (list) => {
    const rest = list.filter((_, i) => i !== from);
    rest.splice(to, 0, list[from]);
    return rest;
  };
  return withMixes({ ...document, materials: moved(materials) }, moved);
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
 * Whether some curve holds some of the material.
 * @param {CurvesDocument} document
 * @param {number} material
 */
export const isUsed = (document, material) => document.curves.some((curve) => holds(curve, material));

/**
 * Indices of the materials that some curve holds.
 * @param {CurvesDocument} document
 */
export const usedMaterials = (document) => document.materials.map((_, i) => i).filter((i) => isUsed(document, i));

/**
 * The three materials that the mixing triangle is about: those in use when they are three, else all when they are. Null otherwise.
 * @param {CurvesDocument} document
 * @returns {[number, number, number] | null}
 */
export function threeMaterials(document) {
  const used = usedMaterials(document);
  const three = used.length === 3 || document.materials.length !== 3 ? used : [0, 1, 2];
  return three.length === 3 ? /** @type {[number, number, number]} */ (three) : null;
}

/**
 * @param {CurvesDocument} document
 * @param {(mix: number[]) => number[]} change
 * @returns {CurvesDocument}
 */
function withMixes(document, change) {
  const curves = document.curves.map((curve) => ({
    ...curve,
    composition: curve.composition.map((key) => ({ ...key, mix: change(key.mix) })),
  }));
  return { ...document, curves };
}
