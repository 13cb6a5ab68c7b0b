/** Links to the steps of lessons: `#lesson=NAME&step=K`. */

/** @typedef {{lesson: string | null, step: number}} Place */

/** @param {string} hash @returns {Place} no lesson where the link names none; the step is 1 where it is none */
export function readPlace(hash) {
  const keys = new URLSearchParams(hash.replace(/^#/, ""));
  const step = Number(keys.get("step"));
  return { lesson: keys.get("lesson") || null, step: Number.isInteger(step) && step > 0 ? step : 1 };
}

/** @param {string} lesson @param {number} step from 1 */
export const linkTo = (lesson, step) => `#lesson=${encodeURIComponent(lesson)}&step=${step}`;
