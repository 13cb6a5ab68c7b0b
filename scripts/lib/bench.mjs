/** Measuring one piece of work again and again. */

/**
 * @typedef {object} Case
 * @property {string} name
 * @property {number} [budget] milliseconds that the median may take
 * @property {(dx: any) => (() => unknown) | Promise<() => unknown>} prepare takes the API of the module `figure` in Node and
 *   returns the work to be measured, which may not be a promise; of a generator the longest step counts
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
/** Milliseconds after which no further run is started although there are few: a case that takes seconds tells enough in three. */
const tooLong = 10_000;
const fewestRuns = 3;

/**
 * Runs the work a few times unmeasured, until the engine has compiled it in full, then measures it.
 *
 * @param {() => unknown} work
 * @returns {Times}
 */
export function measure(work) {
  const begin = performance.now();
  for (let run = 0; run < warmUpRuns && performance.now() - begin < longEnough; run++) longestStep(work);
  /** @type {number[]} */
  const times = [];
  for (const first = performance.now(); !isEnough(times.length, performance.now() - first); ) {
    times.push(longestStep(work));
  }
  times.sort((a, b) => a - b);
  return { median: quantile(times, 0.5), p90: quantile(times, 0.9), runs: times.length };
}

/**
 * Milliseconds that the work takes, or the longest step of a generator.
 *
 * @param {() => unknown} work
 */
function longestStep(work) {
  const start = performance.now();
  const result = work();
  let longest = performance.now() - start;
  if (!isGenerator(result)) return longest;
  for (let done = false; !done; ) {
    const before = performance.now();
    ({ done = true } = result.next());
    longest = Math.max(longest, performance.now() - before);
  }
  return longest;
}

/**
 * @param {any} value
 * @returns {value is Generator}
 */
const isGenerator = (value) => typeof value?.next === "function";

/**
 * @param {number} runs
 * @param {number} elapsed milliseconds
 */
function isEnough(runs, elapsed) {
  return (runs >= leastRuns && elapsed >= longEnough) || (runs >= fewestRuns && elapsed >= tooLong);
}

/**
 * @param {number[]} sorted
 * @param {number} share
 */
function quantile(sorted, share) {
  return sorted[Math.ceil(share * sorted.length) - 1];
}
