/**
 * Edits of the materials of a part, as pure functions. Every mix and every design rule of the document follows.
 *
 * @import { WholePart } from "../document.js"
 *
 * @typedef {NonNullable<WholePart["materials"]>[number]} Material
 */
import { mixesOf, queueOf, withMixes } from "./features.js";
import { tidy, written } from "./numbers.js";
import { rulesOf } from "./rules.js";

import { MATERIAL_LIMIT } from "../../state/materials.js";

/** @param {WholePart} document */
export const materialsOf = ({ materials = [] }) => materials;

/** @param {WholePart} document @param {number} index @param {Partial<Material>} patch @returns {WholePart} */
export function changeMaterial(document, index, patch) {
  const material = materialsOf(document)[index];
  if (!material) return document;
  const next = { ...material, ...patch };
  if (JSON.stringify(next) === JSON.stringify(material)) return document;
  return { ...document, materials: materialsOf(document).map((other, k) => (k === index ? next : other)) };
}

/** @param {WholePart} document @param {Material} material @returns {WholePart} */
export function addMaterial(document, material) {
  if (materialsOf(document).length >= MATERIAL_LIMIT) return document;
  return withAllMixes({ ...document, materials: [...materialsOf(document), material] }, (mix) => [...mix, 0]);
}

/** Whether a mix holds some of a material, or a design rule is about it. @param {WholePart} document @param {number} index */
export function isUsed(document, index) {
  const holds = (/** @type {readonly number[] | undefined} */ mix) => (mix?.[index] ?? 0) > 0;
  const isHeld = document.bodies.some((body) => holds(body.default) || queueOf(body).some((feature) => mixesOf(feature).some(holds)));
  return isHeld || rulesOf(document).some(({ material }) => material === index);
}

/**
 * Takes a material away. Its fractions and its design rules go to another; without one a material in use stays, and so does the last one.
 * @param {WholePart} document
 * @param {number} index
 * @param {number | null} [into]
 * @returns {WholePart}
 */
export function removeMaterial(document, index, into = null) {
  const materials = materialsOf(document);
  if (materials.length < 2 || !materials[index] || into === index) return document;
  if (into === null && isUsed(document, index)) return document;
  const without = (/** @type {number[]} */ mix) => {
    const given = mix.map((fraction, k) => (k === into && mix[index] > 0 ? tidy(fraction + mix[index]) : fraction));
    const left = given.filter((_, k) => k !== index);
    // Mixes that have no say, such as the ends of a piecewise course, may hold some of it still.
    return into === null && mix[index] > 0 ? written(left) : left;
  };
  const moved = (/** @type {number} */ material) => (material > index ? material - 1 : material);
  const rules = rulesOf(document).map((rule) => ({ ...rule, material: moved(rule.material === index ? (into ?? 0) : rule.material) }));
  return withAllMixes({ ...document, materials: materials.filter((_, k) => k !== index), rules }, without);
}

/** @param {WholePart} document @param {(mix: number[]) => number[]} change @returns {WholePart} */
function withAllMixes(document, change) {
  const bodies = document.bodies.map((body) => ({
    ...body,
    ...(body.default ? { default: change(body.default) } : {}),
    features: queueOf(body).map((feature) => withMixes(feature, change)),
  }));
  return { ...document, bodies };
}
