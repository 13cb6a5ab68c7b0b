/**
 * How the place between the curves moves with time.
 *
 * @typedef {"linear" | "ease"} Easing
 * @typedef {"once" | "loop" | "swing"} Repeat `swing`: there and back
 *
 * @typedef {object} Motion
 * @property {number} seconds from one curve to the other
 * @property {Easing} easing
 * @property {Repeat} repeat
 */

/** Range of the seconds of a motion. */
export const SHORTEST = 0.2;
export const LONGEST = 60;

/**
 * The same easing for CSS and for `keySplines` of SVG, whose timing curve with these handles is 3 t² - 2 t³ exactly.
 * @type {{[easing in Easing]: [number, number, number, number]}}
 */
export const HANDLES = { linear: [0, 0, 1, 1], ease: [1 / 3, 0, 2 / 3, 1] };

/**
 * The place s after a share of the time from one curve to the other, both from 0 to 1.
 * @param {Easing} easing
 * @param {number} share
 */
export function eased(easing, share) {
  const t = Math.min(1, Math.max(0, share));
  return easing === "ease" ? t * t * (3 - 2 * t) : t;
}

/**
 * The share of the time after which a place is reached: the inverse of `eased`.
 * @param {Easing} easing
 * @param {number} s
 */
export function shareAt(easing, s) {
  const place = Math.min(1, Math.max(0, s));
  return easing === "ease" ? 0.5 - Math.sin(Math.asin(1 - 2 * place) / 3) : place;
}

/**
 * The places of evenly timed frames. Once or in a loop, the first lies on the first curve and the last on the second; there and back,
 * the frame after the last would be the first again.
 * @param {Pick<Motion, "easing" | "repeat">} motion
 * @param {number} count at least 2
 */
export function places({ easing, repeat }, count) {
  return Array.from({ length: count }, (_, i) => {
    const share = repeat === "swing" ? 1 - Math.abs(1 - (2 * i) / count) : i / (count - 1);
    return eased(easing, share);
  });
}

/** Seconds of one round. @param {Pick<Motion, "seconds" | "repeat">} motion */
export const round = ({ seconds, repeat }) => (repeat === "swing" ? 2 * seconds : seconds);
