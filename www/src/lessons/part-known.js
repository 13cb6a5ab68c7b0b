/**
 * Parts of lessons: the document of a figure with what the reader has changed, and what is asked about it. Pure but for the questions.
 *
 * @import { Control, PartDocument, PartPlace, PartRaster, Point, RemotePart } from "../../../js/directrix.js"
 * @import { Figure } from "../../../scripts/lib/lesson.mjs"
 *
 * @typedef {"repaired" | "depth" | "printed"} Rule
 * @typedef {{body: Uint8Array, fractions: Float64Array[], leaves: Uint32Array}} Along
 * @typedef {{rule: Rule, here: number, along: number[]}} RuleRow fraction of a material at the place and along the line, by a rule
 */

export const RULES = /** @type {const} */ (["repaired", "depth", "printed"]);
/** Courses that a reader can choose. */
export const COURSES = /** @type {const} */ ({
  linear: { kind: "linear" },
  smoothstep: { kind: "smoothstep" },
  power: { kind: "power", power: 3 },
  exponential: { kind: "exponential", rate: 4 },
  periodic: { kind: "periodic", waves: 3 },
});
/** Places along a line. */
const PLACES = 201;
/** Pixels along the longer side of a part by the printed rule, which are its voxels. */
const VOXELS = 160;

/**
 * @param {PartDocument} document
 * @param {Figure["feature"]} which
 * @param {object} change of that feature
 * @returns {PartDocument}
 */
export function withFeature(document, [body, feature], change) {
  const features = (document.bodies[body]?.features ?? []).map((each, k) => (k === feature ? { ...each, ...change } : each));
  return { ...document, bodies: document.bodies.map((each, k) => (k === body ? { ...each, features } : each)) };
}

/** @param {PartDocument} document @param {Rule} rule of all bodies @returns {PartDocument} */
export const withRule = (document, rule) => ({ ...document, bodies: document.bodies.map((body) => ({ ...body, rule })) });

/** The document of a figure at first. @param {PartDocument} document @param {Figure} figure */
export const firstPart = (document, { overlap }) => (overlap ? withRule(document, overlap) : document);

/** @param {PartDocument} document @param {Figure["feature"]} which */
export const featureOf = (document, [body, feature]) => document.bodies[body]?.features?.[feature];

/** The first material of a feature's start. @param {PartDocument} document @param {Figure["feature"]} which */
export function materialOf(document, which) {
  const { start = [] } = featureOf(document, which) ?? {};
  return Math.max(0, start.findIndex((fraction) => fraction > 0.5));
}

/** Places from one end of a line to the other. @param {readonly number[]} line @returns {Point[]} */
export const placesOf = ([x, y, u, v]) => Array.from({ length: PLACES }, (_, n) => [x + ((u - x) * n) / (PLACES - 1), y + ((v - y) * n) / (PLACES - 1)]);

/** Pixels of a part by the printed rule. @param {readonly (readonly number[])[]} box @returns {[number, number]} */
export function voxels([[left, low], [right, high]]) {
  const edge = Math.max(right - left, high - low) / VOXELS;
  return [Math.max(1, Math.round((right - left) / edge)), Math.max(1, Math.round((high - low) / edge))];
}

/**
 * The fraction of a material by a rule: by the printed one of the voxel that holds a place.
 *
 * @param {(document: PartDocument) => Promise<RemotePart> | RemotePart} open
 * @param {PartDocument} document
 * @param {Rule} rule
 * @param {number} material
 * @param {Point} place
 * @param {readonly number[]} line
 * @param {Control} [control]
 * @returns {Promise<RuleRow>}
 */
export async function ruleRow(open, document, rule, material, place, line, control) {
  const part = await open(withRule(document, rule));
  const more = /** @type {[Control?]} */ (control ? [control] : []);
  if (rule !== "printed" || !part.box) {
    const { fractions } = await part.along([[line[0], line[1]], [line[2], line[3]]], PLACES, ...more);
    return { rule, here: (await part.probe(place, ...more))?.fractions?.[material] ?? NaN, along: [...fractions[material]] };
  }
  const size = voxels(part.box);
  const at = sampled(await part.evaluate({ size }, ...more), material);
  return { rule, here: at(place), along: placesOf(line).map(at) };
}

/**
 * The fraction of a material in the pixel that holds a place; no number outside.
 *
 * @param {PartRaster} raster
 * @param {number} material
 */
export const sampled =
  ({ size, box, body, fractions }, material) =>
  (/** @type {Point} */ [x, y]) => {
    const column = Math.min(size[0] - 1, Math.max(0, Math.floor(((x - box[0][0]) / (box[1][0] - box[0][0])) * size[0])));
    const row = Math.min(size[1] - 1, Math.max(0, Math.floor(((box[1][1] - y) / (box[1][1] - box[0][1])) * size[1])));
    const index = row * size[0] + column;
    return body[index] > 0 ? fractions[material][index] : NaN;
  };

/** The distances of a place to the features that take part, by number. @param {PartPlace | null} place @param {number} feature */
export const distanceOf = (place, feature) => place?.distances.find((each) => each.feature === feature)?.distance ?? NaN;
