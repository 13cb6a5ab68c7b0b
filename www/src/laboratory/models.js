/**
 * The bodies that documents name: their numbers, and the sizes in which a body is solved one after the other to see how its error falls.
 *
 * @import { Model } from "./document.js"
 *
 * @typedef {object} Field
 * @property {string} name of the field of the document
 * @property {number} min
 * @property {number} max
 * @property {number} first what it is where a document does not say
 * @property {boolean} whole
 * @property {number} step
 * @property {number[]} [choices] where it is chosen among powers of ten
 *
 * @typedef {object} ModelKind
 * @property {2 | 3} dimension
 * @property {Field[]} fields
 * @property {{field: string, values: number[]}} sizes
 */

/** @param {string} name @param {number} min @param {number} max @param {number} first @returns {Field} */
const count = (name, min, max, first) => ({ name, min, max, first, whole: true, step: 1 });
/** @param {string} name @param {number} min @param {number} max @param {number} first @param {number} step @returns {Field} */
const number = (name, min, max, first, step) => ({ name, min, max, first, whole: false, step });

/** @param {string} name @param {number[]} choices from the greatest to the least @param {number} first @returns {Field} */
const power = (name, choices, first) => ({ name, min: choices[choices.length - 1], max: choices[0], first, whole: false, step: 0, choices });

/** Greatest radius of the format. */
const FAR = 1e9;

/** Bodies in the order of the list, with their numbers as in docs/format.md. @type {Readonly<{[kind: string]: ModelKind}>} */
export const MODELS = {
  cube: { dimension: 3, fields: [count("divisions", 1, 51, 8)], sizes: { field: "divisions", values: [2, 4, 6, 8, 10, 12] } },
  "sliver-cube": {
    dimension: 3,
    fields: [count("divisions", 2, 50, 8), power("width", [0.01, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8], 1e-6)],
    sizes: { field: "divisions", values: [2, 4, 6, 8, 10] },
  },
  "hollow-box": { dimension: 3, fields: [count("divisions", 1, 36, 6), number("wall", 1e-3, 0.45, 0.05, 0.01)], sizes: { field: "divisions", values: [2, 3, 4, 6, 8] } },
  shell: {
    dimension: 3,
    fields: [number("inner", 1e-6, FAR, 0.5, 0.05), number("outer", 1e-6, FAR, 1, 0.05), count("level", 0, 4, 2)],
    sizes: { field: "level", values: [0, 1, 2, 3] },
  },
  sphere: { dimension: 3, fields: [number("radius", 1e-6, FAR, 1, 0.05), count("level", 0, 5, 3)], sizes: { field: "level", values: [0, 1, 2, 3] } },
  mug: { dimension: 3, fields: [count("sectors", 6, 120, 20), power("sliver", [0.01, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 0], 0)], sizes: { field: "sectors", values: [8, 12, 16, 20, 26] } },
  cylinder: { dimension: 3, fields: [count("divisions", 2, 29, 6)], sizes: { field: "divisions", values: [2, 3, 4, 6, 8] } },
  "fillet-block": { dimension: 3, fields: [count("divisions", 1, 40, 6)], sizes: { field: "divisions", values: [2, 3, 4, 6, 8] } },
  square: { dimension: 2, fields: [count("divisions", 1, 8000, 32)], sizes: { field: "divisions", values: [8, 16, 32, 64, 128, 256] } },
  annulus: {
    dimension: 2,
    fields: [number("inner", 1e-6, FAR, 0.5, 0.05), number("outer", 1e-6, FAR, 1, 0.05), count("segments", 6, 20_000, 128)],
    sizes: { field: "segments", values: [16, 32, 64, 128, 256, 512] },
  },
};

/** Whether a body lies in the plane or in space. @param {Model} model @returns {2 | 3} */
export const dimensionOf = ({ kind }) => (isNamed({ kind }) ? MODELS[kind].dimension : 3);

/** Whether a body is made of numbers; one of triangles has none. @param {Model} model */
export const isNamed = ({ kind }) => Object.hasOwn(MODELS, kind);

/** A number of a body. @param {Model} model @param {Field} field @returns {number} */
export const valueOf = (model, { name, first }) => model[name] ?? first;

/** Another body with its own numbers. @param {string} kind @returns {Model} */
export const modelOf = (kind) => ({ kind, ...Object.fromEntries(MODELS[kind].fields.map(({ name, first }) => [name, first])) });

/** The body in another size. @param {Model} model @param {number} size @returns {Model} */
export const inSize = (model, size) => ({ ...model, [MODELS[model.kind].sizes.field]: size });
