/**
 * Edits of the bodies of a part, as pure functions. What names a body follows when its name changes.
 *
 * @import { PartBody, PartReference } from "../../../../js/directrix.js"
 * @import { WholePart } from "../document.js"
 */
import { withSource } from "./conditions.js";
import { BODY_LIMIT, changeBody, freeName, pure, queueOf } from "./features.js";
import { written } from "./numbers.js";

/**
 * A body of a closed shape, over the others.
 * @param {WholePart} document
 * @param {string} outline name of the shape
 * @param {string} [name] that of the shape without one
 * @returns {WholePart}
 */
export function addBody(document, outline, name = outline) {
  const { bodies, materials = [] } = document;
  if (bodies.length >= BODY_LIMIT) return document;
  const own = freeName(name, bodies.map((body) => body.name));
  return { ...document, bodies: [...bodies, { name: own, outline, holes: [], default: pure(0, materials.length), rule: "repaired", features: [] }] };
}

/** Takes a body away; the last one stays, and so does one whose boundary a feature of another is measured to or whose composition a blend takes. @param {WholePart} document @param {number} index */
export function removeBody(document, index) {
  if (!document.bodies[index] || document.bodies.length < 2 || boundaryUsers(document, index).length > 0) return document;
  return { ...document, bodies: document.bodies.filter((_, k) => k !== index) };
}

/** Names of the features of other bodies that are measured to the boundary of one, and of the bodies whose blends take its composition. @param {WholePart} document @param {number} index */
export function boundaryUsers({ bodies }, index) {
  const { name } = bodies[index];
  const names = (/** @type {PartReference | undefined} */ reference) => typeof reference === "object" && reference.boundary === name;
  const isTaken = (/** @type {PartBody} */ { blend }) => blend?.boundaries?.some(({ from }) => from && "body" in from && from.body === name) ?? false;
  return bodies.flatMap((body, k) =>
    k === index
      ? []
      : [
          ...queueOf(body).flatMap((feature) => ([feature.reference, ...Object.values(feature.references ?? {})].some(names) ? [feature.name ?? ""] : [])),
          ...(isTaken(body) ? [body.name] : []),
        ],
  );
}

/**
 * Renames a body wherever it is named. A name that another body has is not taken.
 * @param {WholePart} document
 * @param {number} index
 * @param {string} name
 * @returns {WholePart}
 */
export function renameBody(document, index, name) {
  const body = document.bodies[index];
  if (!body || body.name === name || document.bodies.some((other) => other.name === name)) return document;
  const renamed = (/** @type {PartReference} */ reference) =>
    typeof reference === "object" && reference.boundary === body.name ? { ...reference, boundary: name } : reference;
  const bodies = document.bodies.map((other, k) => {
    const features = queueOf(other).map((feature) => {
      const { reference, references } = feature;
      if (references) {
        const next = Object.fromEntries(Object.entries(references).map(([key, value]) => [key, renamed(value)]));
        return Object.entries(next).every(([key, value]) => value === references[key]) ? feature : { ...feature, references: next };
      }
      if (reference === undefined) return feature;
      const next = renamed(reference);
      return next === reference ? feature : { ...feature, reference: next };
    });
    return withSource({ ...other, features, ...(k === index ? { name } : {}) }, "body", body.name, name);
  });
  return { ...document, bodies };
}

/** Puts a body at another place: later ones lie over earlier ones. @param {WholePart} document @param {number} from @param {number} to @returns {WholePart} */
export function moveBody(document, from, to) {
  const { bodies } = document;
  if (from === to || !bodies[from] || !bodies[to]) return document;
  const rest = bodies.filter((_, k) => k !== from);
  rest.splice(to, 0, bodies[from]);
  return { ...document, bodies: rest };
}

/** @param {WholePart} document @param {number} index @param {"repaired" | "depth" | "printed"} rule */
export const setRule = (document, index, rule) => changeBody(document, index, (body) => (body.rule === rule ? body : { ...body, rule }));

/**
 * Gives a body another default. Features that end at the default go on to end there, so that they stay continuous with it.
 * @param {WholePart} document
 * @param {number} index
 * @param {number[]} mix
 */
export function setDefault(document, index, mix) {
  const next = written(mix);
  return changeBody(document, index, (body) => {
    const before = body.default ?? [];
    if (isSame(before, next)) return body;
    const features = queueOf(body).map((feature) => (feature.end && isSame(feature.end, before) ? { ...feature, end: next } : feature));
    return { ...body, default: next, features };
  });
}

/** @param {readonly number[]} a @param {readonly number[]} b */
const isSame = (a, b) => a.length === b.length && a.every((value, k) => value === b[k]);
