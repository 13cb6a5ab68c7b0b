/**
 * Edits of bodies and of their composition features, as pure functions from one document to the next. They return the same object where there is nothing to do.
 *
 * @import { PartBody, PartCourse, PartFeature, PartReference } from "../../../../js/directrix.js"
 * @import { WholePart } from "../document.js"
 *
 * @typedef {object} At A feature by its body and its place in the queue.
 * @property {number} body
 * @property {number} feature
 */
import { withSource } from "./conditions.js";
import { tidy, written } from "./numbers.js";

/** Most features of a body, and most bodies, as in docs/format.md. */
export const FEATURE_LIMIT = 32;
export const BODY_LIMIT = 64;
/** Largest length of the format. */
export const FAR = 1e9;
/** Most keys of a piecewise course. */
const KEY_LIMIT = 1000;
/** Shares of the way that two neighbouring keys keep between them. */
const KEY_GAP = 0.001;

/** The queue of a body. @param {PartBody | undefined} body @returns {readonly PartFeature[]} */
export const queueOf = (body) => body?.features ?? [];

/** The feature there is at a place, or null. @param {WholePart} document @param {At} at */
export const featureAt = ({ bodies }, { body, feature }) => queueOf(bodies[body])[feature] ?? null;

/** The composition of a body where no feature acts. @param {WholePart} document @param {number} body @returns {number[]} */
export const defaultOf = ({ bodies, materials = [] }, body) => bodies[body]?.default ?? pure(0, materials.length);

/** All of one material. @param {number} material @param {number} count */
export const pure = (material, count) => Array.from({ length: count }, (_, k) => (k === material ? 1 : 0));

/**
 * @param {WholePart} document
 * @param {number} index
 * @param {(body: PartBody) => PartBody} change
 * @returns {WholePart}
 */
export function changeBody(document, index, change) {
  const body = document.bodies[index];
  if (!body) return document;
  const next = change(body);
  return next === body ? document : { ...document, bodies: document.bodies.map((other, k) => (k === index ? next : other)) };
}

/**
 * @param {WholePart} document
 * @param {At} at
 * @param {(feature: PartFeature) => PartFeature} change
 * @returns {WholePart}
 */
function changeFeature(document, at, change) {
  return changeBody(document, at.body, (body) => {
    const feature = queueOf(body)[at.feature];
    if (!feature) return body;
    const next = change(feature);
    return next === feature ? body : { ...body, features: queueOf(body).map((other, k) => (k === at.feature ? next : other)) };
  });
}

/**
 * Gives fields of a feature other values; those that have them already stay.
 * @param {WholePart} document
 * @param {At} at
 * @param {Partial<PartFeature>} patch
 */
export function patchFeature(document, at, patch) {
  return changeFeature(document, at, (feature) => {
    const isSame = Object.entries(patch).every(([name, value]) => JSON.stringify(feature[/** @type {keyof PartFeature} */ (name)]) === JSON.stringify(value));
    return isSame ? feature : { ...feature, ...patch };
  });
}

/** A name that is not taken: the one wanted, or with the next free number. @param {string} wanted @param {readonly (string | undefined)[]} taken */
export function freeName(wanted, taken) {
  if (!taken.includes(wanted)) return wanted;
  const [, stem = wanted, number = "1"] = /^(.*?) (\d+)$/.exec(wanted) ?? [];
  let next = Number(number) + 1;
  while (taken.includes(`${stem} ${next}`)) next += 1;
  return `${stem} ${next}`;
}

/**
 * Puts a feature at a place of the queue, at its tail without one.
 * @param {WholePart} document
 * @param {number} body
 * @param {PartFeature} feature
 * @param {number} [place]
 */
export function addFeature(document, body, feature, place) {
  return changeBody(document, body, (before) => {
    const queue = queueOf(before);
    if (queue.length >= FEATURE_LIMIT) return before;
    const name = freeName(feature.name ?? "", queue.map((each) => each.name));
    const features = [...queue];
    features.splice(place ?? queue.length, 0, { ...feature, name });
    return { ...before, features };
  });
}

/** @param {WholePart} document @param {At} at */
export function removeFeature(document, at) {
  return changeBody(document, at.body, (body) =>
    queueOf(body)[at.feature] ? { ...body, features: queueOf(body).filter((_, k) => k !== at.feature) } : body,
  );
}

/** A copy of a feature right behind it. @param {WholePart} document @param {At} at */
export function duplicateFeature(document, at) {
  const feature = featureAt(document, at);
  return feature ? addFeature(document, at.body, feature, at.feature + 1) : document;
}

/** Renames a feature; a blend that takes its composition from it follows. @param {WholePart} document @param {At} at @param {string} name */
export function renameFeature(document, at, name) {
  const before = featureAt(document, at)?.name ?? "";
  // The first one of a name is meant.
  const isMeant = queueOf(document.bodies[at.body]).findIndex((other) => other.name === before) === at.feature;
  const renamed = patchFeature(document, at, { name });
  return isMeant && renamed !== document ? changeBody(renamed, at.body, (body) => withSource(body, "feature", before, name)) : renamed;
}

/** @param {WholePart} document @param {At} at @param {boolean} hidden */
export const hideFeature = (document, at, hidden) => patchFeature(document, at, { hidden });

/**
 * Puts a feature at another place: of its own queue, or of that of another body, where there is room. What it goes to at its end stays, as written.
 * @param {WholePart} document
 * @param {At} from
 * @param {At} to `feature` counts places without the one that moves
 */
export function moveFeature(document, from, to) {
  const feature = featureAt(document, from);
  const target = document.bodies[to.body];
  if (!feature || !target) return document;
  if (from.body === to.body && from.feature === to.feature) return document;
  if (from.body !== to.body && queueOf(target).length >= FEATURE_LIMIT) return document;
  const bodies = document.bodies.map((body, k) => {
    if (k !== from.body && k !== to.body) return body;
    const features = queueOf(body).filter((each) => each !== feature);
    if (k === to.body) features.splice(to.feature, 0, feature);
    return { ...body, features };
  });
  return { ...document, bodies };
}

/**
 * The place of a feature one up or down the list, through the queues of all bodies; null at either end.
 * @param {WholePart} document
 * @param {At} at
 * @param {1 | -1} by
 * @returns {At | null} as `moveFeature` takes it
 */
export function placeBeside({ bodies }, at, by) {
  const next = at.feature + by;
  if (next >= 0 && next < queueOf(bodies[at.body]).length) return { ...at, feature: next };
  const body = at.body + by;
  const queue = bodies[body];
  if (!queue || queueOf(queue).length >= FEATURE_LIMIT) return null;
  return { body, feature: by > 0 ? 0 : queueOf(queue).length };
}

/**
 * Measures a feature to a shape or to the boundary of a body.
 * @param {WholePart} document
 * @param {At} at
 * @param {PartReference} reference
 */
export function setReference(document, at, reference) {
  return changeFeature(document, at, (feature) => {
    if (!feature.references && JSON.stringify(feature.reference) === JSON.stringify(reference)) return feature;
    const { references, distance, ...rest } = feature;
    return { ...rest, reference };
  });
}

/**
 * Measures a feature to several things, with the distance as an expression in their names.
 * @param {WholePart} document
 * @param {At} at
 * @param {{[name: string]: PartReference}} references
 * @param {string} distance
 */
export function setReferences(document, at, references, distance) {
  return changeFeature(document, at, (feature) => {
    if (feature.distance === distance && JSON.stringify(feature.references) === JSON.stringify(references)) return feature;
    const { reference, ...rest } = feature;
    return { ...rest, references, distance };
  });
}

/**
 * Moves one limit of the band; it stays on its side of the other one.
 * @param {WholePart} document
 * @param {At} at
 * @param {"from" | "to"} limit
 * @param {number} value
 */
export function setLimit(document, at, limit, value) {
  const feature = featureAt(document, at);
  if (!feature || !Number.isFinite(value)) return document;
  const { from = 0, to } = feature;
  const least = gapOf(limit === "from" ? to : Math.max(from, value));
  const bounded = limit === "from" ? Math.min(Math.max(0, value), Math.max(0, to - least)) : Math.min(FAR, Math.max(value, from + least));
  return patchFeature(document, at, { [limit]: tidy(bounded) });
}

/** The least width of a band whose far limit is about so far away. @param {number} length */
const gapOf = (length) => Math.max(1e-6, Math.abs(length) * 1e-6);

/** @param {WholePart} document @param {At} at @param {"start" | "end"} end @param {number[]} mix */
export const setEnd = (document, at, end, mix) => patchFeature(document, at, { [end]: written(mix) });

/**
 * Gives the profile another course, with the numbers given or those that keep it as near as can be to what it was.
 * @param {WholePart} document
 * @param {At} at
 * @param {PartCourse} course
 */
export const setCourse = (document, at, course) => patchFeature(document, at, { course });

/**
 * The course of a kind that a profile gets first: keys start where the profile runs already.
 * @param {PartCourse["kind"]} kind
 * @param {PartFeature} feature
 * @param {(t: number) => number[]} mixAt the mix of the profile at a share of the way
 * @returns {PartCourse}
 */
export function firstCourse(kind, feature, mixAt) {
  switch (kind) {
    case "power":
      return { kind, power: 2 };
    case "exponential":
      return { kind, rate: 3 };
    case "periodic":
      return { kind, waves: 2 };
    case "piecewise":
      return { kind, keys: [0, 0.5, 1].map((at) => ({ at, mix: written(mixAt(at)) })) };
    case "expression":
      return { kind, text: expressionOf(feature.course ?? { kind: "linear" }) };
    default:
      return { kind };
  }
}

/** A course as the text of an expression, so that typing goes on from what is there; t where there is no such text. @param {PartCourse} course */
function expressionOf(course) {
  switch (course.kind) {
    case "power":
      return `t^${course.power}`;
    case "exponential":
      return `(1 - exp(${-course.rate} * t)) / (1 - exp(${-course.rate}))`;
    case "smoothstep":
      return "smoothstep(0, 1, t)";
    case "periodic":
      return `(1 - cos(${2 * course.waves - 1} * pi * t)) / 2`;
    case "expression":
      return course.text;
    default:
      return "t";
  }
}

/** The keys of a piecewise course. @param {PartFeature | null} feature */
export const keysOf = (feature) => (feature?.course?.kind === "piecewise" ? feature.course.keys : []);

/**
 * Changes one key: it stays between its neighbours.
 * @param {WholePart} document
 * @param {At} at
 * @param {number} index
 * @param {{at?: number, mix?: number[]}} change
 */
export function setKey(document, at, index, change) {
  const keys = keysOf(featureAt(document, at));
  const key = keys[index];
  if (!key) return document;
  const low = index > 0 ? keys[index - 1].at + KEY_GAP : 0;
  const high = index + 1 < keys.length ? keys[index + 1].at - KEY_GAP : 1;
  // Between two keys that stand closer than the gap there is no room to move.
  const place = change.at === undefined || low > high ? key.at : tidy(Math.min(high, Math.max(low, change.at)));
  const next = { at: place, mix: change.mix ? written(change.mix) : key.mix };
  return setCourse(document, at, { kind: "piecewise", keys: keys.map((other, k) => (k === index ? next : other)) });
}

/**
 * A new key at a share of the way.
 * @param {WholePart} document
 * @param {At} at
 * @param {number} place
 * @param {number[]} mix
 * @returns {{document: WholePart, index: number | null}} the key; null where there is no room for one
 */
export function addKey(document, at, place, mix) {
  const keys = keysOf(featureAt(document, at));
  const share = tidy(Math.min(1, Math.max(0, place)));
  const index = keys.filter((key) => key.at < share).length;
  const isFree = keys.every((key) => Math.abs(key.at - share) >= KEY_GAP);
  if (keys.length === 0 || keys.length >= KEY_LIMIT || !isFree) return { document, index: null };
  const next = [...keys];
  next.splice(index, 0, { at: share, mix: written(mix) });
  return { document: setCourse(document, at, { kind: "piecewise", keys: next }), index };
}

/** Takes a key away; the last one stays. @param {WholePart} document @param {At} at @param {number} index */
export function removeKey(document, at, index) {
  const keys = keysOf(featureAt(document, at));
  if (keys.length < 2 || !keys[index]) return document;
  return setCourse(document, at, { kind: "piecewise", keys: keys.filter((_, k) => k !== index) });
}

/**
 * A feature with every mix of it changed.
 * @param {PartFeature} feature
 * @param {(mix: number[]) => number[]} change
 * @returns {PartFeature}
 */
export function withMixes(feature, change) {
  const { course } = feature;
  return {
    ...feature,
    ...(feature.start ? { start: change(feature.start) } : {}),
    ...(feature.end ? { end: change(feature.end) } : {}),
    ...(course?.kind === "piecewise" ? { course: { kind: /** @type {const} */ ("piecewise"), keys: course.keys.map((key) => ({ ...key, mix: change(key.mix) })) } } : {}),
  };
}

/** Every mix of a feature that has a say. @param {PartFeature} feature @returns {readonly number[][]} */
export function mixesOf({ start, end, course }) {
  if (course?.kind === "piecewise") return course.keys.map(({ mix }) => mix);
  return [start, end].filter((mix) => mix !== undefined);
}
