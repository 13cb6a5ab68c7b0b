/**
 * The game: where does the next line land? One guess for each step, counted. Pure functions.
 *
 * @import { Steps, VertexSets } from "../../../js/directrix.js"
 *
 * @typedef {object} Prediction
 * @property {number} seen the last step whose line is known
 * @property {number} tries
 * @property {number} right
 * @property {number | null} aim vertex of the second curve that is aimed at
 * @property {{at: number, guess: number, kind: "right" | "unseen" | "breaks" | "lower"} | null} told the last answer
 */

/** A game that begins after a step. @param {number} at @returns {Prediction} */
export const begun = (at) => ({ seen: at, tries: 0, right: 0, aim: null, told: null });

/**
 * Whether the line of a step is still to be guessed.
 * @param {Prediction | null} prediction
 * @param {Steps} steps
 * @param {number} at
 */
export const isHidden = (prediction, steps, at) =>
  prediction !== null && at > prediction.seen && at >= 1 && at <= steps.growth.length;

/**
 * @param {Prediction} prediction
 * @param {Steps} steps
 * @param {number} at the step
 * @param {VertexSets} sets of the vertex that the line starts at
 * @param {number} guess
 * @returns {Prediction}
 */
export function answered(prediction, steps, at, sets, guess) {
  const seen = sets.visible.find(({ vertex }) => vertex === guess);
  const isRight = steps.growth[at - 1]?.to === guess;
  const kind = isRight ? "right" : !seen ? "unseen" : seen.candidate ? "lower" : "breaks";
  return {
    seen: at,
    tries: prediction.tries + 1,
    right: prediction.right + Number(isRight),
    aim: null,
    told: { at, guess, kind },
  };
}
