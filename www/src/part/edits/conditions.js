/**
 * The conditions of the blend of a body: what follows when something that they name changes, as pure functions.
 *
 * @import { PartBody, PartBoundary } from "../../../../js/directrix.js"
 */
/** A body with every condition of its blend changed; null takes one out. @param {PartBody} body @param {(boundary: PartBoundary) => PartBoundary | null} change @returns {PartBody} */
export function withConditions(body, change) {
  const { blend } = body;
  if (!blend?.boundaries) return body;
  const next = blend.boundaries.map(change);
  if (next.every((each, k) => each === blend.boundaries?.[k])) return body;
  return { ...body, blend: { ...blend, boundaries: next.filter((each) => each !== null) } };
}

/**
 * A body with the mixes and the gradients of its blend changed.
 * @param {PartBody} body
 * @param {(mix: number[]) => number[]} mix
 * @param {(flux: number[]) => number[]} flux
 */
export const withBlended = (body, mix, flux) =>
  withConditions(body, (boundary) => ({ ...boundary, ...(boundary.value ? { value: mix(boundary.value) } : {}), ...(boundary.flux ? { flux: flux(boundary.flux) } : {}) }));

/** A body whose blend names a source by another name. @param {PartBody} body @param {"body" | "feature"} as @param {string} from @param {string} to */
export const withSource = (body, as, from, to) =>
  withConditions(body, (boundary) => (boundary.from && Reflect.get(boundary.from, as) === from ? { ...boundary, from: /** @type {any} */ ({ [as]: to }) } : boundary));
