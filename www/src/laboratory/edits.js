/**
 * Edits of a problem as pure functions.
 *
 * @import { Condition, Group, LaboratoryDocument, Model, Solver, Where } from "./document.js"
 */
import { boxRound } from "./box-edit.js";
import { SOLVER } from "./document.js";
import { dimensionOf } from "./models.js";

/** Most groups of a document, as in docs/format.md. */
export const MOST_GROUPS = 64;
/** Colours of materials that are added, told apart by colour-blind readers as well (Okabe and Ito). */
const COLORS = ["#f0e442", "#009e73", "#0072b2", "#e69f00", "#56b4e9", "#d55e00", "#cc79a7"];
/** Coordinate beyond which no body of the page reaches. */
const DEEP = 1e9;
/** Degrees within which normals face alike, where a group does not say. */
export const ANGLE = 10;

/** @param {LaboratoryDocument} document @param {Model} model @returns {LaboratoryDocument} */
export function withModel(document, model) {
  if (JSON.stringify(model) === JSON.stringify(document.model)) return document;
  const dimension = dimensionOf(model);
  if (dimension === dimensionOf(document.model)) return { ...document, model };
  // Vectors have as many coordinates as the body, and a section is one of a body in space.
  const { section: _section, ...others } = document;
  return { ...others, model, groups: document.groups.map((group) => ({ ...group, where: fitting(group.where, dimension) })) };
}

/** A body of triangles with each of them turned over. @param {LaboratoryDocument} document @returns {LaboratoryDocument} */
export function turnedOver(document) {
  const { model } = document;
  if (model.kind !== "mesh") return document;
  return { ...document, model: { ...model, triangles: model.triangles.map((/** @type {number[]} */ [a, b, c]) => [a, c, b]) } };
}

/**
 * The same elements where the height of the plane is that of space, and the other way round.
 * @param {Where} where
 * @param {2 | 3} dimension that is wanted
 * @returns {Where}
 */
function fitting({ direction, box, ...rest }, dimension) {
  const turned = (/** @type {number[]} */ [x, y, z = 0], /** @type {number} */ deep) => (dimension === 2 ? [x, z] : [x, deep, y]);
  const along = direction && turned(direction, 0);
  return {
    ...rest,
    ...(along ? { direction: along.every((value) => value === 0) ? turned([1, 0, 0], 0) : along } : {}),
    ...(box ? { box: [turned(box[0], -DEEP), turned(box[1], DEEP)] } : {}),
  };
}

/** @param {LaboratoryDocument} document @param {Partial<Solver>} patch @returns {LaboratoryDocument} */
export function withSolver(document, patch) {
  const solver = { ...document.solver, ...patch };
  return JSON.stringify(solver) === JSON.stringify(document.solver) ? document : { ...document, solver };
}

/** The solver with every default that the page shows. @param {LaboratoryDocument} document */
export const solverOf = ({ solver }) => ({ ...SOLVER, ...solver });

/** @param {LaboratoryDocument} document @param {number} index @param {Partial<Group>} patch @returns {LaboratoryDocument} */
export function withGroup(document, index, patch) {
  const group = document.groups[index];
  if (!group) return document;
  const next = { ...group, ...patch };
  if (JSON.stringify(next) === JSON.stringify(group)) return document;
  return { ...document, groups: document.groups.map((other, k) => (k === index ? next : other)) };
}

/** @param {LaboratoryDocument} document @param {string} name @returns {LaboratoryDocument} */
export function addGroup(document, name) {
  if (document.groups.length >= MOST_GROUPS) return document;
  const dimension = dimensionOf(document.model);
  const axis = dimension - 1 - (document.groups.length % dimension);
  const direction = Array.from({ length: dimension }, (_, k) => (k === axis ? 1 : 0));
  const group = { name, where: { direction, angle: ANGLE }, condition: pure(document, 0) };
  return { ...document, groups: [...document.groups, group] };
}

/** @param {LaboratoryDocument} document @param {number} index @returns {LaboratoryDocument} */
export const removeGroup = (document, index) => ({ ...document, groups: document.groups.filter((_, k) => k !== index) });

/** The condition of elements in no group; without one they are a fault. @param {LaboratoryDocument} document @param {Condition | null} rest @returns {LaboratoryDocument} */
export function withRest(document, rest) {
  const { rest: before, ...others } = document;
  if (JSON.stringify(before ?? null) === JSON.stringify(rest)) return document;
  return rest ? { ...others, rest } : others;
}

/** One material alone. @param {LaboratoryDocument} document @param {number} material @returns {Condition} */
export const pure = ({ materials }, material) => ({ value: materials.map((_, k) => (k === material ? 1 : 0)) });

/** Nothing flows. @param {LaboratoryDocument} document @returns {Condition} */
export const insulated = ({ materials }) => ({ flux: materials.map(() => 0) });

/** @typedef {"value" | "flux" | "insulated"} ConditionKind */

/** @param {Condition} condition @returns {ConditionKind} */
export function kindOf(condition) {
  if ("value" in condition) return "value";
  return listOf(condition).every((each) => Number(each) === 0) ? "insulated" : "flux";
}

/** What a condition gives for each material, numbers or formulas. @param {Condition} condition @returns {(number | string)[]} */
export function listOf(condition) {
  const given = "value" in condition ? condition.value : condition.flux;
  return Array.isArray(given) ? given : [given];
}

/** Whether it is written as formulas. @param {Condition} condition */
export const isFormula = (condition) => listOf(condition).some((each) => typeof each === "string");

/**
 * A condition of another kind, with what carries over.
 * @param {LaboratoryDocument} document
 * @param {Condition | undefined} condition
 * @param {ConditionKind} kind
 * @returns {Condition}
 */
export function conditionOf(document, condition, kind) {
  if (condition && kindOf(condition) === kind) return condition;
  if (kind === "value") return pure(document, 0);
  if (kind === "insulated") return insulated(document);
  // One flows in as much as another flows out.
  return { flux: document.materials.map((_, k) => (k === 0 ? 1 : k === 1 ? -1 : 0)) };
}

/**
 * Fluxes with one set: the last of the others takes what the sum lacks.
 * @param {readonly number[]} fluxes
 * @param {number} index
 * @param {number} value
 */
export function withFlux(fluxes, index, value) {
  const next = fluxes.map((flux, k) => (k === index ? value : flux));
  const last = index === next.length - 1 ? next.length - 2 : next.length - 1;
  if (last >= 0) next[last] = Number((next[last] - next.reduce((sum, flux) => sum + flux, 0)).toPrecision(12)) + 0;
  return next;
}

/** @typedef {"direction" | "box" | "both" | "positive" | "elements"} By */

/** What a group chooses elements by. @param {Where} where @returns {By} */
export function byOf({ direction, box, positive, elements }) {
  if (elements) return "elements";
  if (positive !== undefined) return "positive";
  return direction && box ? "both" : box ? "box" : "direction";
}

/**
 * The same elements chosen in another way, with what carries over.
 * @param {Where} where
 * @param {Exclude<By, "elements">} by
 * @param {import("../space/vector.js").Bounds} bounds of the body
 * @param {2 | 3} dimension
 * @returns {Where}
 */
export function chosenBy(where, by, bounds, dimension) {
  const { direction = [0, 1, 0].slice(0, dimension), angle = ANGLE, box = boxRound(bounds).map((corner) => corner.slice(0, dimension)) } = where;
  if (by === "positive") return { positive: where.positive ?? "1" };
  return { ...(by === "box" ? {} : { direction, angle }), ...(by === "direction" ? {} : { box }) };
}

/** @param {LaboratoryDocument} document @param {number} index @param {Partial<{name: string, color: string}>} patch @returns {LaboratoryDocument} */
export function changeMaterial(document, index, patch) {
  const material = document.materials[index];
  const next = { ...material, ...patch };
  if (JSON.stringify(next) === JSON.stringify(material)) return document;
  return { ...document, materials: document.materials.map((other, k) => (k === index ? next : other)) };
}

/** One material more, of which no condition has any yet. @param {LaboratoryDocument} document @returns {LaboratoryDocument} */
export function addMaterial(document) {
  const { materials } = document;
  const color = COLORS.find((each) => materials.every((other) => other.color.toLowerCase() !== each)) ?? COLORS[0];
  return withConditions({ ...document, materials: [...materials, { name: `material ${materials.length + 1}`, color }] }, (list) => [...list, 0]);
}

/** Whether a condition gives something of a material. @param {LaboratoryDocument} document @param {number} index */
export const isMaterialUsed = ({ groups, rest }, index) =>
  [...groups.map(({ condition }) => condition), ...(rest ? [rest] : [])].some((condition) => listOf(condition)[index] !== 0);

/** @param {LaboratoryDocument} document @param {number} index of one that is not used, of three or more @returns {LaboratoryDocument} */
export function removeMaterial(document, index) {
  if (document.materials.length <= 2 || isMaterialUsed(document, index)) return document;
  return withConditions({ ...document, materials: document.materials.filter((_, k) => k !== index) }, (list) => list.filter((_, k) => k !== index));
}

/** @param {LaboratoryDocument} document @param {(list: (number | string)[]) => (number | string)[]} change of what a condition gives for each material */
function withConditions(document, change) {
  const changed = (/** @type {Condition} */ condition) => ("value" in condition ? { value: change(listOf(condition)) } : { flux: change(listOf(condition)) });
  const groups = document.groups.map((group) => ({ ...group, condition: changed(group.condition) }));
  return { ...document, groups, ...(document.rest ? { rest: changed(document.rest) } : {}) };
}
