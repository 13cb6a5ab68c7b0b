/**
 * Edits of the blend of a body as pure functions.
 *
 * @import { PartBlend, PartBody, PartBoundary } from "../../../../js/directrix.js"
 * @import { WholePart } from "../document.js"
 *
 * @typedef {"insulated" | "value" | "flux" | "body" | "feature"} Condition
 */
import { changeBody, defaultOf, pure, queueOf } from "./features.js";
import { tidy } from "./numbers.js";

/** Limits of the format. */
export const MOST_BLENDS = 16;
export const MOST_BOUNDARIES = 32;
export const ELEMENTS = { least: 32, usual: 300, most: 2000 };

/** The outline and the holes of a body. @param {PartBody} body */
export const loopsOf = ({ outline, holes = [] }) => [...new Set([outline, ...holes])];

/** @param {PartBody | undefined} body */
export const boundariesOf = (body) => body?.blend?.boundaries ?? [];

/** What is known on a piece of a boundary. @param {PartBoundary | undefined} boundary @returns {Condition} */
export function conditionOf(boundary) {
  if (boundary?.value) return "value";
  if (boundary?.flux) return "flux";
  if (boundary?.from) return "body" in boundary.from ? "body" : "feature";
  return "insulated";
}

/**
 * The pieces of the boundary of a body as they are listed: its outline and its holes, whether they have a condition or not, then the pieces told by other shapes.
 * @param {PartBody} body
 * @returns {{on: string, index: number | null, isLoop: boolean}[]} `index`: of the condition
 */
export function piecesOf(body) {
  const boundaries = boundariesOf(body);
  const loops = loopsOf(body);
  const first = loops.map((on) => {
    const index = boundaries.findIndex((each) => each.on === on);
    return { on, index: index < 0 ? null : index, isLoop: true };
  });
  const taken = new Set(first.map(({ index }) => index));
  const others = boundaries.map(({ on }, index) => ({ on, index, isLoop: false }));
  return [...first, ...others.filter(({ index }) => !taken.has(index))];
}

/**
 * Gives a body a blend that starts from its default outside and from one material after the other in its holes, or takes it away.
 * @param {WholePart} document
 * @param {number} index
 * @param {boolean} on
 */
export function setBlend(document, index, on) {
  const count = document.materials?.length ?? 0;
  if (on && document.bodies.filter(({ blend }) => blend).length >= MOST_BLENDS) return document;
  return changeBody(document, index, (body) => {
    if (on === (body.blend !== undefined)) return body;
    const { blend: _, ...rest } = body;
    if (!on) return rest;
    const standard = defaultOf(document, index);
    const main = standard.indexOf(Math.max(...standard));
    const boundaries = loopsOf(body).map((name, k) => ({ on: name, within: 0, value: k === 0 ? standard : pure((main + k) % count, count) }));
    return { ...rest, blend: { kind: /** @type {const} */ ("laplace"), elements: ELEMENTS.usual, boundaries: boundaries.slice(0, MOST_BOUNDARIES) } };
  });
}

/** @param {WholePart} document @param {number} index @param {(blend: PartBlend) => PartBlend} change */
function changeBlend(document, index, change) {
  return changeBody(document, index, (body) => {
    const next = body.blend && change(body.blend);
    return next === undefined || next === body.blend ? body : { ...body, blend: next };
  });
}

/** @param {WholePart} document @param {number} index @param {number} elements */
export const setElements = (document, index, elements) => changeBlend(document, index, (blend) => (blend.elements === elements ? blend : { ...blend, elements }));

/**
 * Puts a condition in the place of another one, or adds it where a loop has none.
 * @param {WholePart} document
 * @param {number} index of the body
 * @param {string} on
 * @param {number | null} piece index of the condition that is there
 * @param {PartBoundary} next
 */
export function setBoundary(document, index, on, piece, next) {
  return changeBlend(document, index, (blend) => {
    const boundaries = blend.boundaries ?? [];
    if (piece === null) return boundaries.length >= MOST_BOUNDARIES ? blend : { ...blend, boundaries: [...boundaries, { ...next, on }] };
    if (JSON.stringify(boundaries[piece]) === JSON.stringify(next)) return blend;
    return { ...blend, boundaries: boundaries.map((other, k) => (k === piece ? next : other)) };
  });
}

/**
 * The condition that a piece has first when it is given one of a kind.
 * @param {WholePart} document
 * @param {number} index of the body
 * @param {PartBoundary} before
 * @param {Condition} kind
 * @returns {PartBoundary | null} null where there is nothing to take a composition from
 */
export function firstCondition(document, index, { on, within = 0, value }, kind) {
  const base = { on, within };
  const count = document.materials?.length ?? 0;
  const [other] = document.bodies.filter((_, k) => k !== index);
  const [feature] = queueOf(document.bodies[index]);
  switch (kind) {
    case "insulated":
      return base;
    case "value":
      return { ...base, value: value ?? defaultOf(document, index) };
    case "flux":
      return { ...base, flux: pure(-1, count) };
    case "body":
      return other ? { ...base, from: { body: other.name } } : null;
    default:
      return feature ? { ...base, from: { feature: feature.name ?? "" } } : null;
  }
}

/** Adds a piece told by a shape. @param {WholePart} document @param {number} index of the body @param {string} on */
export const addPiece = (document, index, on) => setBoundary(document, index, on, null, { on, within: 0, value: defaultOf(document, index) });

/** @param {WholePart} document @param {number} index of the body @param {number} piece */
export const removePiece = (document, index, piece) =>
  changeBlend(document, index, (blend) => ({ ...blend, boundaries: (blend.boundaries ?? []).filter((_, k) => k !== piece) }));

/** A gradient with the number of one material changed; the last material makes the sum 0. @param {readonly number[]} flux @param {number} material @param {number} value */
export function withSlope(flux, material, value) {
  const next = flux.map((each, k) => (k === material ? value : each));
  const last = next.length - 1;
  next[last] = tidy(-next.slice(0, last).reduce((sum, each) => sum + each, 0));
  return next;
}
