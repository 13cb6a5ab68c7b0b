/**
 * Edits of the composition along a curve, as pure functions. Keys ascend, in [0, 1) round a closed curve and in [0, 1] along an open one, and there
 * is always one.
 *
 * @import { CompositionKey, CurvesDocument } from "../types.js"
 */
import { isOpen } from "../spline.js";
import { changeCurve } from "./edits.js";
import { blended, written } from "./mix.js";

/** Least distance between two keys: they do not pass each other. */
const KEY_GAP = 1e-6;
/** Decimals of a place. */
const DECIMALS = 6;

/**
 * A place in [0, 1), past either end round the seam; on an open curve in [0, 1], past either end at the end.
 * @param {number} at
 * @param {boolean} [open]
 */
export function wrapped(at, open = false) {
  if (open) return Number(Math.min(1, Math.max(0, at)).toFixed(DECIMALS));
  const place = Number((at - Math.floor(at)).toFixed(DECIMALS));
  return place < 1 ? place : 0;
}

/**
 * The shorter way from one place to another round the curve, more than -1/2 and at most 1/2; the one way along an open curve.
 * @param {number} from
 * @param {number} to
 * @param {boolean} [open]
 */
export function shortWay(from, to, open = false) {
  if (open) return to - from;
  const way = ahead(from, to);
  return way > 0.5 ? way - 1 : way;
}

/**
 * The mix at a place: linear between the keys, round the seam as well; on an open curve constant beyond the keys.
 * @param {CompositionKey[]} keys
 * @param {number} at
 * @param {boolean} [open]
 */
export function mixAt(keys, at, open = false) {
  const next = keys.findIndex((key) => key.at > at);
  if (open && next <= 0) return [...keys[next < 0 ? keys.length - 1 : 0].mix];
  const to = keys[Math.max(0, next)];
  const from = keys[(next > 0 ? next : keys.length) - 1];
  const span = ahead(from.at, to.at);
  return span > 0 ? blended(from.mix, to.mix, ahead(from.at, at) / span) : [...from.mix];
}

/**
 * Moves a key along its curve by a part of the domain, as far as its neighbours let it. It may go round the seam, and is then first or last
 * of the list.
 * @param {CurvesDocument} document
 * @param {number} curve
 * @param {number} index
 * @param {number} by
 * @returns {CurvesDocument}
 */
export function slideKey(document, curve, index, by) {
  return changeCurve(document, curve, (shape) => {
    const keys = shape.composition;
    const key = keys[index];
    if (!key) return shape;
    const open = isOpen(shape);
    const to = wrapped(key.at + (open ? between(keys, index, by) : within(keys, index, by)), open);
    const others = keys.filter((_, i) => i !== index);
    if (to === key.at || others.some((other) => other.at === to)) return shape;
    return { ...shape, composition: sorted([...others, { ...key, at: to }]) };
  });
}

/**
 * The index of a key after an edit that may have moved it in the list.
 * @param {CurvesDocument} before
 * @param {CurvesDocument} after
 * @param {number} curve
 * @param {number} index
 */
export function followed(before, after, curve, index) {
  const old = before.curves[curve].composition;
  const now = after.curves[curve].composition;
  const fresh = now.findIndex((key) => !old.includes(key));
  return fresh < 0 ? index : fresh;
}

/**
 * A chosen key as far as the document has it.
 * @param {{curve: number, index: number} | null} key
 * @param {CurvesDocument} document
 */
export function keyWithin(key, document) {
  const count = key ? document.curves[key.curve]?.composition.length : 0;
  if (!key || !count) return null;
  return key.index < count ? key : { curve: key.curve, index: count - 1 };
}

/**
 * Adds a key with the mix that is there, so that the profile keeps its shape. Where one stands already, nothing happens.
 * @param {CurvesDocument} document
 * @param {number} curve
 * @param {number} at
 * @returns {CurvesDocument}
 */
export function insertKey(document, curve, at) {
  return changeCurve(document, curve, (shape) => {
    const keys = shape.composition;
    const open = isOpen(shape);
    const place = wrapped(at, open);
    if (keys.some((key) => Math.abs(shortWay(key.at, place, open)) < KEY_GAP)) return shape;
    return { ...shape, composition: sorted([...keys, { at: place, mix: written(mixAt(keys, place, open)) }]) };
  });
}

/**
 * Takes a key away; the last one stays.
 * @param {CurvesDocument} document
 * @param {number} curve
 * @param {number} index
 * @returns {CurvesDocument}
 */
export function removeKey(document, curve, index) {
  return changeCurve(document, curve, (shape) => {
    const { composition } = shape;
    if (composition.length < 2 || index >= composition.length) return shape;
    return { ...shape, composition: composition.filter((_, i) => i !== index) };
  });
}

/**
 * @param {CurvesDocument} document
 * @param {number} curve
 * @param {number} index
 * @param {number[]} mix
 * @returns {CurvesDocument}
 */
export function setMix(document, curve, index, mix) {
  return changeCurve(document, curve, (shape) => {
    const key = shape.composition[index];
    const next = written(mix);
    if (!key || key.mix.every((fraction, i) => fraction === next[i])) return shape;
    return { ...shape, composition: shape.composition.map((other, i) => (i === index ? { ...key, mix: next } : other)) };
  });
}

/**
 * The place half-way from a key to the next; from the last one of an open curve to the end, or back to the one before when it is there.
 * @param {CompositionKey[]} keys
 * @param {number} index
 * @param {boolean} [open]
 */
export function afterKey(keys, index, open = false) {
  const { at } = keys[index];
  if (open) return wrapped((at + (keys[index + 1]?.at ?? (at < 1 ? 1 : (keys[index - 1]?.at ?? 0)))) / 2, true);
  return wrapped(at + (ahead(at, keys[(index + 1) % keys.length].at) || 1) / 2);
}

/**
 * How far a key goes of the way asked for.
 * @param {CompositionKey[]} keys
 * @param {number} index
 * @param {number} by
 */
function within(keys, index, by) {
  if (keys.length < 2) return by;
  const { at } = keys[index];
  const farthest = ahead(at, keys[(index + 1) % keys.length].at) - KEY_GAP;
  const nearest = KEY_GAP - ahead(keys[(index + keys.length - 1) % keys.length].at, at);
  return farthest < 0 || nearest > 0 ? 0 : Math.min(farthest, Math.max(nearest, by));
}

/**
 * As `within`, along an open curve.
 * @param {CompositionKey[]} keys
 * @param {number} index
 * @param {number} by
 */
function between(keys, index, by) {
  const { at } = keys[index];
  const farthest = Math.max(0, (keys[index + 1] ? keys[index + 1].at - KEY_GAP : 1) - at);
  const nearest = Math.min(0, (keys[index - 1] ? keys[index - 1].at + KEY_GAP : 0) - at);
  return Math.min(farthest, Math.max(nearest, by));
}

/**
 * The way forward from one place to another, in [0, 1).
 * @param {number} from
 * @param {number} to
 */
function ahead(from, to) {
  const way = to - from;
  return way - Math.floor(way);
}

/** @param {CompositionKey[]} keys */
const sorted = (keys) => keys.sort((a, b) => a.at - b.at);
