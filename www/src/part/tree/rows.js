/**
 * The rows of the feature list: bodies with their default and their queue, then the shapes.
 *
 * @import { PartDiagnostic } from "../../../../js/directrix.js"
 * @import { WholePart } from "../document.js"
 * @import { Known, Shown } from "../state.js"
 *
 * @typedef {object} Row
 * @property {string} key by which it is the same row after an edit
 * @property {"body" | "default" | "feature" | "shapes" | "shape"} kind
 * @property {1 | 2} level
 * @property {number} body index; -1 of shapes
 * @property {number} feature index in the queue; -1 of what is none
 * @property {string} name
 * @property {string} mark
 * @property {number[] | null} mix whose colour it has
 * @property {string} aside
 * @property {boolean} hidden
 * @property {boolean | null} isOpen null of what has no rows of its own
 * @property {PartDiagnostic | null} fault the first thing there is to say about it
 */
import { mixesOf, queueOf } from "../edits/features.js";
import { shapesOf, usedNames } from "../edits/shapes.js";
import { words } from "./words.js";

/** Shapes beyond which their list is closed at first. */
const MANY = 12;

/**
 * @param {WholePart} document
 * @param {ReadonlyMap<string, boolean>} opened what was opened or closed by the person
 * @param {readonly PartDiagnostic[]} diagnostics
 * @returns {Row[]} the visible ones
 */
export function rowsOf(document, opened, diagnostics) {
  const { bodies } = document;
  const shapes = shapesOf(document);
  /** @type {Row[]} */
  const rows = [];
  const base = { feature: -1, mix: null, aside: "", hidden: false, isOpen: null, fault: null };
  for (const [body, spec] of bodies.entries()) {
    const key = `body ${body}`;
    const isOpen = opened.get(key) ?? true;
    const of = diagnostics.filter((each) => each.body === body);
    // Of a closed body its row says what is wrong with the blend as well.
    const isBlended = (/** @type {PartDiagnostic} */ { path }) => path.includes(".blend");
    const fault = of.find((each) => each.feature === undefined && !(isOpen && isBlended(each))) ?? null;
    rows.push({ ...base, key, kind: "body", level: 1, body, name: spec.name, mark: "body", isOpen, fault });
    if (!isOpen) continue;
    const interior = spec.blend ? { name: words.blend, mark: "blend", fault: of.find(isBlended) ?? null } : { name: words.standard, mark: "standard", mix: spec.default ?? [] };
    rows.push({ ...base, key: `default ${body}`, kind: "default", level: 2, body, ...interior });
    for (const [feature, { name = words.unnamed, hidden = false, ...rest }] of queueOf(spec).entries()) {
      const fault = of.find((each) => each.feature === feature) ?? null;
      rows.push({ ...base, key: `feature ${body}.${feature}`, kind: "feature", level: 2, body, feature, name, mark: "feature", mix: mixesOf(rest)[0] ?? [], hidden, fault });
    }
  }
  const isOpen = opened.get("shapes") ?? shapes.length <= MANY;
  rows.push({ ...base, key: "shapes", kind: "shapes", level: 1, body: -1, name: words.shapes, mark: "shapes", aside: String(shapes.length), isOpen });
  if (!isOpen) return rows;
  const used = usedNames(document);
  for (const [number, { name, kind }] of shapes.entries()) {
    const fault = diagnostics.find(({ path }) => path === `shapes[${number}]` || path.startsWith(`shapes[${number}].`)) ?? null;
    rows.push({ ...base, key: `shape ${name}`, kind: "shape", level: 2, body: -1, name, mark: kind, aside: used.has(name) ? "" : words.unused, fault });
  }
  return rows;
}

/**
 * The key of the row that is chosen, or null.
 * @param {Shown} shown
 * @param {string | null} last the row that was gone to last: body and default of a body are chosen by the same
 */
export function chosenKey({ body, feature, shape }, last) {
  if (shape !== null) return `shape ${shape}`;
  if (body === null) return null;
  if (feature !== null) return `feature ${body}.${feature}`;
  return last === `body ${body}` ? last : `default ${body}`;
}

/**
 * What there is to say about a document: what the kernel said of it, or, until it has answered, what it said of the one before, where that has as many of everything.
 * @param {WholePart} document
 * @param {Known | null} known
 * @returns {readonly PartDiagnostic[]}
 */
export function diagnosticsFor(document, known) {
  if (!known) return [];
  const count = (/** @type {WholePart} */ { bodies, shapes = [] }) => [shapes.length, ...bodies.map((body) => queueOf(body).length)].join();
  return count(known.document) === count(document) ? known.part.diagnostics : [];
}

/**
 * The row that typed letters go to: the next one from `here` on whose name begins with them.
 * @param {readonly Row[]} rows
 * @param {number} here
 * @param {string} typed
 */
export function typedTo(rows, here, typed) {
  const start = typed.length > 1 ? here : here + 1;
  const wanted = typed.toLowerCase();
  const order = rows.map((_, k) => (start + k + rows.length) % rows.length);
  return order.find((k) => rows[k].name.toLowerCase().startsWith(wanted)) ?? null;
}
