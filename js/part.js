/**
 * Parts: what is asked of the module.
 *
 * @typedef {import("./directrix.js").Part} Part
 * @typedef {Exclude<keyof Part, "bodies" | "diagnostics" | "box">} Question
 */
import { toText } from "./text.js";

/**
 * The arguments of each method, as the module takes them: options apart from what must be there.
 *
 * @type {Record<Question, (...args: any[]) => object>}
 */
const QUESTIONS = {
  evaluate: (options = {}) => ({ options }),
  probe: (point) => ({ point }),
  along: (ends, count) => ({ ends, count }),
  violations: (options = {}) => ({ options }),
  amounts: (options = {}) => ({ options }),
  isolines: (options = {}) => ({ options }),
  leaves: (options = {}) => ({ options }),
  file: (options) => ({ options }),
  defaults: () => ({}),
};

/**
 * The methods of a part.
 *
 * @param {(question: Question, args: any[]) => any} ask
 * @returns {any}
 */
export function partMethods(ask) {
  const names = /** @type {Question[]} */ (Object.keys(QUESTIONS));
  return Object.fromEntries(names.map((name) => [name, (/** @type {any[]} */ ...args) => ask(name, args)]));
}

/**
 * The arguments of a method as the module takes them.
 *
 * @param {Question} question
 * @param {any[]} args
 */
export const partArguments = (question, args) => QUESTIONS[question](...args);

/**
 * A question under way.
 *
 * @param {import("./pkg/directrix_full.js").Engine} engine
 * @param {string} text of the document
 * @param {Question | "part"} question
 * @param {object} rest
 */
export function askingPart(engine, text, question, rest) {
  const asked = engine.part(text, question, toText(rest));
  return {
    /** Goes on for about so many milliseconds; returns the share done. @param {number} budget */
    step: (budget) => engine.answerPart(asked, budget),
    /** The answer, once it is there. */
    answer: () => asked.result(),
  };
}
