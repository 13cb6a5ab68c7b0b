/**
 * Documents of the kind `laplace` in the page: with every default written out that the page needs.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Kernel, Material } from "../types.js"
 * @import { Section } from "./section-state.js"
 *
 * @typedef {{value: number | (number | string)[]} | {flux: number | (number | string)[]}} Condition As in docs/format.md.
 * @typedef {{direction?: number[], angle?: number, box?: number[][], positive?: string, elements?: number[][]}} Where
 * @typedef {{name: string, where: Where, condition: Condition}} Group
 * @typedef {{kind: string} & {[name: string]: any}} Model
 *
 * @typedef {object} Solver
 * @property {"gmres" | "lu"} [method]
 * @property {"none" | "jacobi" | "ssor"} [preconditioner]
 * @property {number} [omega]
 * @property {number} [restart]
 * @property {number} [tolerance]
 * @property {number} [maxIterations]
 * @property {number} [dense]
 *
 * @typedef {object} LaboratoryDocument
 * @property {1} directrix
 * @property {"laplace"} kind
 * @property {string} title
 * @property {Material[]} materials
 * @property {Model} model
 * @property {Group[]} groups
 * @property {Condition} [rest] of elements in no group
 * @property {Solver} solver
 * @property {string} [unit] of lengths
 * @property {Section} [section]
 *
 * @typedef {import("../../../js/directrix.js").LaplaceBoundary} Boundary
 */

/** Materials of a document that names none, as in docs/format.md. */
const MATERIALS = [
  { name: "yellow", color: "#f0e442" },
  { name: "green", color: "#009e73" },
];

/** What the solver does where a document does not say, as in docs/api.md. */
export const SOLVER = /** @type {const} */ ({ method: "gmres", preconditioner: "jacobi", omega: 0.5, restart: 100, tolerance: 1e-6 });

/** Elements up to which elimination and the estimate of the condition number are to be had, and the preconditioner SSOR. */
export const MOST = { lu: 2000, ssor: 8000 };

/**
 * A document with every default written out, in the place of the documents that the page passes around. Rejects with a DirectrixError when it is none.
 * @param {Kernel} kernel
 * @param {any} raw
 */
export async function completedLaboratory(kernel, raw) {
  await kernel.boundary(raw);
  return /** @type {CurvesDocument} */ (/** @type {unknown} */ (withDefaults(raw)));
}

/** A document with what may be left out. @param {any} raw @returns {LaboratoryDocument} */
export function withDefaults(raw) {
  const { title = "", unit = "mm", materials = MATERIALS, groups = [], solver = {} } = raw;
  return { ...raw, directrix: 1, kind: "laplace", title, unit, materials, groups, solver };
}

/** The open document as what it is while this workbench is on. @param {App} app */
export const laboratoryOf = ({ store }) => /** @type {LaboratoryDocument} */ (/** @type {unknown} */ (store.document));

/**
 * Whether two documents have the same boundary with the same conditions, whatever else they have.
 * @param {LaboratoryDocument} a
 * @param {LaboratoryDocument} b
 */
export const isSameProblem = (a, b) =>
  a.model === b.model && a.rest === b.rest && a.materials.length === b.materials.length && (a.groups === b.groups || JSON.stringify(a.groups) === JSON.stringify(b.groups));

/** Whether they are solved in the same way as well. @param {LaboratoryDocument} a @param {LaboratoryDocument} b */
export const isSameSolution = (a, b) => isSameProblem(a, b) && JSON.stringify(a.solver) === JSON.stringify(b.solver);

/**
 * The materials that something known is painted in: their names and colours as they stand, unless there are more or fewer of them by now.
 * @param {LaboratoryDocument} document as it stands
 * @param {{document: LaboratoryDocument}} known
 */
export const paintedIn = ({ materials }, { document: { materials: before } }) => (materials.length === before.length ? materials : before);

/** What the kernel takes of a boundary. @param {Boundary} boundary @param {Solver & {condition?: boolean}} solver */
export const inputOf = ({ dimension, vertices, elements, groups, conditions }, solver) =>
  /** @type {import("../../../js/directrix.js").LaplaceInput} */ ({ dimension, vertices, elements, groups, conditions, composition: true, solver });
