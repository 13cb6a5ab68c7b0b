/** Measuring one piece of work again and again. */

/**
 * @typedef {object} Case
 * @property {string} name
 * @property {number} [budget] milliseconds that the median may take
 * @property {(dx: any) => (() => unknown) | Promise<() => unknown>} prepare takes the API of the module `figure` in Node and
 *   returns the work to be measured, which may not be a promise
 *
 * @typedef {object} Times
 * @property {number} median milliseconds
 * @property {number} p90 milliseconds: nine runs of ten take at most this long
 * @property {number} runs
 */

const warmUpRuns = 5;
const leastRuns = 20;
/** Milliseconds after which no further run is started once there are enough. */
const longEnough = 1500;

/**
 * Runs the work a few times unmeasured, until the engine has compiled it in full, then measures it.
 *
 * @param {() => unknown} work
 * @returns {Times}
 */
export function measure(work) {
  for (let run = 0; run < warmUpRuns; run++) work();
  /** @type {number[]} */
  const times = [];
  const begin = performance.now();
  while (times.length < leastRuns || performance.now() - begin < longEnough) {
    const start = performance.now();
    work();
    times.push(performance.now() - start);
  }
  times.sort((a, b) => a - b);
  return { median: quantile(times, 0.5), p90: quantile(times, 0.9), runs: times.length };
}

/**
 * @param {number[]} sorted
 * @param {number} share
 */
function quantile(sorted, share) {
  return sorted[Math.ceil(share * sorted.length) - 1];
}
