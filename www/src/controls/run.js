/**
 * What a control does with its value. All controls edit through these three.
 *
 * @template T
 * @typedef {object} Editing
 * @property {(value: T, run?: string) => void} change
 * @property {() => void} [end] the run is over
 * @property {(run: string) => void} [cancel] take the open run back
 */

let runs = 0;

/** A name for one run of edits that no other run has. @param {string} what */
export function newRun(what) {
  runs += 1;
  return `${what} ${runs}`;
}
