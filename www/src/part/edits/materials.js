/**
 * Edits of the materials of a part, as pure functions. Every mix and every design rule of the document follows.
 *
 * @import { WholePart } from "../document.js"
 *
 * @typedef {NonNullable<WholePart["materials"]>[number]} Material
 */
import { withBlended } from "./conditions.js";
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
  const longer = (/** @type {number[]} */ list) => [...list, 0];
  return withAllMixes({ ...document, materials: [...materialsOf(document), material] }, longer, longer);
}

/** Whether a mix holds some of a material, or a design rule is about it. @param {WholePart} document @param {number} index */
export function isUsed(document, index) {
  const holds = (/** @type {readonly number[] | undefined} */ mix) => (mix?.[index] ?? 0) > 0;
  const isKnown = (/** @type {WholePart["bodies"][number]} */ { blend }) => blend?.boundaries?.some(({ value, flux }) => holds(value) || (flux?.[index] ?? 0) !== 0);
  const isHeld = document.bodies.some((body) => holds(body.default) || isKnown(body) || queueOf(body).some((feature) => mixesOf(feature).some(holds)));
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
  const moveSlope = (/** @type {number[]} */ flux) => flux.map((slope, k) => (k === into ? tidy(slope + flux[index]) : slope)).filter((_, k) => k !== index);
  return withAllMixes({ ...document, materials: materials.filter((_, k) => k !== index), rules }, without, moveSlope);
}

/** @param {WholePart} document @param {(mix: number[]) => number[]} change @param {(flux: number[]) => number[]} changeSlope @returns {WholePart} */
function withAllMixes(document, change, changeSlope) {
  const bodies = document.bodies.map((body) => ({
    ...withBlended(body, change, changeSlope),
    ...(body.default ? { default: change(body.default) } : {}),
    features: queueOf(body).map((feature) => withMixes(feature, change)),
  }));
  return { ...document, bodies };
}
