/**
 * Laplace's equation: input as lists of numbers, solutions, and questions about them.
 *
 * @import { Directrix, LaplaceInput, LaplaceSolution } from "./directrix.js"
 *
 * @typedef {import("./pkg/directrix_full.js").Engine} Engine
 * @typedef {import("./pkg/directrix_full.js").LaplaceSolved} Solved
 * @typedef {"at" | "gradientAt" | "section"} Question
 *
 * @typedef {object} Work
 * @property {(budget: number) => number} step goes on for about so many milliseconds; returns the share done
 * @property {() => any} answer what was asked for, once the share is 1
 */
import { DirectrixError } from "./errors.js";
import { toText } from "./text.js";

/** Most materials of a problem. */
const MOST_MATERIALS = 16;

/**
 * What the module keeps of each solution.
 *
 * @type {WeakMap<object, Solved>}
 */
const kept = new WeakMap();

/**
 * A value as a message tells it: of lists and objects their kind, as they may be long.
 *
 * @param {unknown} value
 * @returns {string}
 */
export function told(value) {
  if (typeof value === "string") return JSON.stringify(value.slice(0, 40));
  if (Array.isArray(value)) return `a list of ${value.length}`;
  if (typeof value === "object" && value !== null) return isList(value) ? `a ${value.constructor.name} of ${value.length}` : "an object";
  return String(value).slice(0, 40);
}

/** @param {string} code @param {string} path @param {string} found @param {string} expected @returns {never} */
function refuse(code, path, found, expected) {
  throw new DirectrixError(code, path, `${found} was found; expected ${expected}`);
}

/** Whether a value is a list, a plain or a typed one. @param {unknown} list @returns {list is ArrayLike<unknown>} */
const isList = (list) => Array.isArray(list) || (ArrayBuffer.isView(list) && !(list instanceof DataView));

/** @param {unknown} list @param {string} path @returns {Float64Array} */
function numbers(list, path) {
  if (list instanceof Float64Array) return list;
  if (!isList(list)) refuse("type", path, told(list), "a list of numbers, such as a Float64Array");
  return Float64Array.from(list, (value, n) => (typeof value === "number" ? value : refuse("type", `${path}[${n}]`, told(value), "a number")));
}

/** @param {unknown} list @param {string} path @returns {Uint32Array} */
function indices(list, path) {
  if (list instanceof Uint32Array) return list;
  if (!isList(list)) refuse("type", path, told(list), "a list of whole numbers, such as a Uint32Array");
  return Uint32Array.from(list, (value, n) =>
    typeof value === "number" && Number.isInteger(value) && value >= 0 && value < 2 ** 32
      ? value
      : refuse("type", `${path}[${n}]`, told(value), "a whole number from 0 on"),
  );
}

/**
 * One condition as numbers: those of each material.
 *
 * @param {unknown} condition
 * @param {string} path
 * @returns {{ isValue: boolean, data: number[] }}
 */
function conditionOf(condition, path) {
  if (typeof condition !== "object" || condition === null) refuse("missing", path, told(condition), "an object with `value` or `flux`");
  const { value, flux, ...rest } = /** @type {any} */ (condition);
  const [unknown] = Object.keys(rest);
  if (unknown !== undefined) throw new DirectrixError("unknown-field", `${path}.${unknown}`, "there is no such field; expected `value` or `flux`");
  if (value !== undefined && flux !== undefined) {
    throw new DirectrixError("range", path, "both `value` and `flux` were found; expected one of them");
  }
  if (value === undefined && flux === undefined) throw new DirectrixError("missing", path, "expected `value` or `flux`");
  const isValue = value !== undefined;
  const given = isValue ? value : flux;
  const own = `${path}.${isValue ? "value" : "flux"}`;
  const data = isList(given) ? Array.from(given) : [given];
  if (data.length < 1 || data.length > MOST_MATERIALS) refuse("range", own, told(given), `a number, or a list with one for each of 1 to ${MOST_MATERIALS} materials`);
  data.forEach((number, k) => {
    const place = isList(given) ? `${own}[${k}]` : own;
    if (typeof number !== "number") refuse("type", place, told(number), "a number, or a list with one for each material");
    if (!Number.isFinite(number)) refuse("non-finite", place, told(number), "a finite number");
  });
  return { isValue, data };
}

/**
 * A problem as the module takes it.
 *
 * @param {LaplaceInput} input
 */
function read(input) {
  if (typeof input !== "object" || input === null) refuse("type", "", told(input), "an object");
  const { vertices, elements, conditions, groups, composition, dimension, solver, ...rest } = input;
  const [unknown] = Object.keys(rest);
  if (unknown !== undefined) throw new DirectrixError("unknown-field", unknown, "there is no such field");
  if (dimension !== 2 && dimension !== 3) refuse(dimension === undefined ? "missing" : "range", "dimension", told(dimension), "2 or 3");
  const places = numbers(vertices, "vertices");
  if (places.length % dimension !== 0) refuse("range", "vertices", told(vertices), `${dimension} numbers for each vertex`);
  const corners = indices(elements, "elements");
  if (corners.length % dimension !== 0) refuse("range", "elements", told(elements), `${dimension} numbers for each element`);
  const count = corners.length / dimension;
  if (!Array.isArray(conditions)) refuse(conditions === undefined ? "missing" : "type", "conditions", told(conditions), "a list");
  const of = groups === undefined ? null : indices(groups, "groups");
  if (of && of.length !== count) refuse("range", "groups", told(groups), `a number for each of ${count} elements`);
  if (!of && conditions.length !== count) {
    refuse("range", "conditions", told(conditions), `one for each of ${count} elements, or \`groups\``);
  }
  const list = /** @type {unknown[]} */ (Array.from(conditions)).map((condition, n) => conditionOf(condition, `conditions[${n}]`));
  const materials = list[0]?.data.length ?? 1;
  const odd = list.findIndex(({ data }) => data.length !== materials);
  if (odd >= 0) refuse("range", `conditions[${odd}]`, `a list of ${list[odd].data.length}`, `${materials}, as in the first condition`);
  const isValue = new Uint8Array(count);
  const data = new Float64Array(count * materials);
  for (let element = 0; element < count; element++) {
    const condition = list[of ? of[element] : element];
    if (!condition) refuse("range", `groups[${element}]`, told(of?.[element]), `the index of a condition, 0 to ${list.length - 1}`);
    isValue[element] = condition.isValue ? 1 : 0;
    data.set(condition.data, element * materials);
  }
  const options = toText({ dimension, materials, ...(composition === undefined ? {} : { composition }), ...(solver === undefined ? {} : { solver }) });
  return { options, places, corners, isValue, data, of };
}

/** @type {Question[]} */
const QUESTIONS = ["at", "gradientAt", "section"];

/** @param {number[] | ArrayLike<number>} lists @returns {any} */
const asLists = (lists) => Array.from(lists);

/**
 * A problem being solved.
 *
 * @param {Engine} engine
 * @param {LaplaceInput} input
 * @param {<T>(call: () => T) => T} ask turns errors of the module into ours
 * @returns {Work}
 */
export function solving(engine, input, ask) {
  const { options, places, corners, isValue, data, of } = read(input);
  /** An error about an element names its group, where there are groups. @template T @param {() => T} call @returns {T} */
  const inGroups = (call) => {
    try {
      return ask(call);
    } catch (error) {
      const element = error instanceof DirectrixError && /^conditions\[(\d+)\]$/.exec(error.path);
      if (!of || !element || !(error instanceof DirectrixError)) throw error;
      throw new DirectrixError(error.code, `conditions[${of[Number(element[1])]}]`, error.message, error.at, error.place);
    }
  };
  const work = inGroups(() => engine.laplace(options, places, corners, isValue, data));
  return {
    step: (budget) => inGroups(() => work.step(budget)),
    answer() {
      const solved = ask(() => work.result());
      if (!solved) throw new DirectrixError("failed", "", "the problem is not solved yet");
      return solutionOf(solved, ask);
    },
  };
}

/**
 * What is said about a solution.
 *
 * @param {Solved} solved
 */
function summaryOf(solved) {
  const { iterations, fluxBalance, ...summary } = solved.summary();
  return { ...summary, iterations: asLists(iterations), fluxBalance: asLists(fluxBalance) };
}

/**
 * @param {Solved} solved
 * @param {<T>(call: () => T) => T} ask
 * @returns {LaplaceSolution}
 */
function solutionOf(solved, ask) {
  /** @type {any} */
  const solution = ask(() => summaryOf(solved));
  kept.set(solution, solved);
  for (const question of QUESTIONS) {
    solution[question] = (/** @type {any} */ first, /** @type {any} */ options) => {
      const work = asking(solution, question, { first, options }, ask);
      work.step(Infinity);
      return work.answer();
    };
  }
  return solution;
}

/**
 * A question about a solution.
 *
 * @param {LaplaceSolution} solution
 * @param {Question} question
 * @param {{ first: any, options?: any }} rest
 * @param {<T>(call: () => T) => T} ask
 * @returns {Work}
 */
export function asking(solution, question, { first, options }, ask) {
  const solved = kept.get(solution);
  if (!solved) refuse("type", "", told(solution), "a solution of solveLaplace");
  if (!QUESTIONS.includes(question)) refuse("range", "question", told(question), QUESTIONS.join(", "));
  const start = () => {
    if (question === "section") return solved.section(toText(first, "frame"));
    const points = numbers(first, "points");
    if (points.length % solution.dimension !== 0) {
      refuse("range", "points", told(first), `${solution.dimension} numbers for each point`);
    }
    const { outside = "refuse", ...rest } = options ?? {};
    const [unknown] = Object.keys(rest);
    if (unknown !== undefined) throw new DirectrixError("unknown-field", `options.${unknown}`, "there is no such field; expected `outside`");
    if (outside !== "refuse" && outside !== "skip") refuse("range", "options.outside", told(outside), "`refuse` or `skip`");
    return solved.points(points, question === "gradientAt", outside === "refuse");
  };
  const work = ask(start);
  return { step: (budget) => ask(() => work.step(budget)), answer: () => ask(() => work.result()) };
}

/**
 * The boundary of a document, or with points the exact fractions there.
 *
 * @param {Engine} engine
 * @param {string} text of the document
 * @param {unknown} points `undefined` for the boundary
 * @returns {Work}
 */
export function askingBoundary(engine, text, points) {
  const asked = engine.boundary(text, points === undefined ? undefined : numbers(points, "points"));
  return { step: (budget) => engine.answerBoundary(asked, budget), answer: () => asked.result() };
}

/** Solutions that a worker keeps for the questions that come; the oldest goes first. */
const MOST_KEPT = 4;

/** @type {Map<number, LaplaceSolution>} */
const remembered = new Map();

/**
 * A call over a connection, in steps: the problem has a number, and comes with the first call and when the worker says that it does not have it.
 *
 * @param {Directrix} dx
 * @param {{ key: number, input?: LaplaceInput }} problem
 * @param {{ question: Question | "solve", rest: { first: any, options?: any } }} asked
 * @returns {import("./directrix.js").Job}
 */
export function postedJob(dx, { key, input }, { question, rest }) {
  let solution = remembered.get(key);
  if (!solution && !input) {
    throw new DirectrixError("unsent", "", "the problem is not known here any more; expected it to be sent again");
  }
  /** @type {import("./directrix.js").Job | undefined} */
  let job;
  const answer = (/** @type {LaplaceSolution} */ solution) => {
    const solved = /** @type {Solved} */ (kept.get(solution));
    return { progress: 1, done: true, answer: summaryOf(solved) };
  };
  return {
    step(budget) {
      if (!solution) {
        job ??= dx.job(null, { solveLaplace: input });
        const state = job.step(budget);
        if (!state.done) return { progress: question === "solve" ? state.progress : state.progress / 2, done: false };
        job = undefined;
        solution = /** @type {LaplaceSolution} */ (state.answer);
        remembered.set(key, solution);
        for (const old of remembered.keys()) {
          if (remembered.size <= MOST_KEPT) break;
          remembered.delete(old);
        }
        if (question !== "solve") return { progress: 0.5, done: false };
      }
      if (question === "solve") return answer(solution);
      job ??= dx.job(null, { laplace: { solution, question, ...rest } });
      return job.step(budget);
    },
  };
}
