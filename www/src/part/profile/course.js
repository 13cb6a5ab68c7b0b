/**
 * The mixes of a feature over its distance, as `src/field/profile.rs` has them; the tests compare the values.
 *
 * @import { PartCourse, PartFeature } from "../../../../js/directrix.js"
 *
 * @typedef {object} Profile
 * @property {number} from
 * @property {number} to
 * @property {[boolean, boolean]} meets whether it has the default at `from` (or `from` is 0) and at `to`
 * @property {number} taper the width over which it is led there where it does not, a tenth of the band
 * @property {(t: number) => number[]} plain mix at a share of the way
 * @property {(distance: number) => number[]} alone mix of a body whose only feature it is
 */
import { expression, smoothstep } from "./expression.js";

/** Share of the band over which a profile is led to the default. */
const TAPER = 0.1;
/** How near two compositions are the same. */
const SAME = 1e-9;

/** What a text says; of texts that were read before, so that plots need not read them again. @type {{text: string, value: ReturnType<typeof expression>}} */
let last = { text: "", value: null };

/**
 * The share of `end` at the share t of the way; 1 where there is no value, as the kernel has it. Not of piecewise courses.
 * @param {PartCourse} course
 * @param {number} t
 * @param {number} distance
 */
function shareAt(course, t, distance) {
  switch (course.kind) {
    case "power":
      return t ** course.power;
    case "exponential":
      return Math.expm1(-course.rate * t) / Math.expm1(-course.rate);
    case "smoothstep":
      return smoothstep(t);
    case "periodic":
      return 0.5 - 0.5 * Math.cos((2 * course.waves - 1) * Math.PI * t);
    case "expression": {
      if (last.text !== course.text || !last.value) last = { text: course.text, value: expression(course.text, ["d", "t"]) };
      const value = last.value?.([distance, t]) ?? 1;
      return Number.isNaN(value) ? 1 : Math.min(1, Math.max(0, value));
    }
    default:
      return t;
  }
}

/**
 * @param {PartFeature} feature
 * @param {readonly number[]} standard the default of its body
 * @returns {Profile}
 */
export function profileOf(feature, standard) {
  const { from = 0, to, start = [...standard], end = [...standard], course = { kind: "linear" } } = feature;
  const width = to - from;
  const plain = (/** @type {number} */ t) => {
    if (course.kind === "piecewise") return between(course.keys, t);
    const share = shareAt(course, t, from + t * width);
    return blend(start, end, share);
  };
  const isMet = (/** @type {number} */ t) => plain(t).every((fraction, k) => Math.abs(fraction - standard[k]) <= SAME);
  /** @type {[boolean, boolean]} */
  const meets = [from === 0 || isMet(0), isMet(1)];
  const taper = TAPER * width;
  return {
    from,
    to,
    meets,
    taper,
    plain,
    alone(distance) {
      if (distance < from || distance > to || to === from) return [...standard];
      const mix = plain((distance - from) / width);
      const nearest = Math.min(meets[0] ? Infinity : distance - from, meets[1] ? Infinity : to - distance);
      return nearest === Infinity ? mix : blend(standard, mix, smoothstep(nearest / taper));
    },
  };
}

/** @param {readonly number[]} a @param {readonly number[]} b @param {number} share */
const blend = (a, b, share) => a.map((fraction, k) => fraction * (1 - share) + b[k] * share);

/** @param {readonly {at: number, mix: number[]}[]} keys @param {number} t */
function between(keys, t) {
  const next = keys.findIndex(({ at }) => at > t);
  if (next === 0) return [...keys[0].mix];
  if (next < 0) return [...keys[keys.length - 1].mix];
  const [a, b] = [keys[next - 1], keys[next]];
  return blend(a.mix, b.mix, (t - a.at) / (b.at - a.at));
}

/** Numbers of the courses that have their range, as in docs/format.md. */
const MOST_POWER = 100;
const MOST_RATE = 100;

/**
 * The course that has a share of `end` half way, of the kinds with one number; straight ones become powers. Null of the others.
 * @param {PartCourse} course
 * @param {number} share
 * @returns {PartCourse | null}
 */
export function throughMiddle(course, share) {
  const inside = Math.min(1 - 1e-6, Math.max(1e-6, share));
  if (course.kind === "exponential") {
    // At t = 1/2 the share is 1 / (1 + exp(-k / 2)).
    const rate = Math.min(MOST_RATE, Math.max(-MOST_RATE, 2 * Math.log(inside / (1 - inside))));
    const rounded = Number(rate.toFixed(2));
    return { kind: "exponential", rate: rounded === 0 ? 0.01 : rounded };
  }
  if (course.kind !== "power" && course.kind !== "linear") return null;
  const power = Number(Math.min(MOST_POWER, Math.max(0.01, -Math.log2(inside))).toPrecision(3));
  return { kind: "power", power };
}

/** Whether a course has a number that its middle sets. @param {PartCourse} course */
export const hasMiddle = ({ kind }) => kind === "linear" || kind === "power" || kind === "exponential";
