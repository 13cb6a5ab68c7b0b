/** A call answered in turns: whoever has the thread hears of other things in between. */
import { postedJob } from "./laplace.js";
import { toText } from "./text.js";

/** Milliseconds of work in one turn. */
const BUDGET = 12;

/** Functions that do not ask for the solution of a document. */
const UNSOLVED = new Set(["defaults", "span", "fit", "insertPoint", "readShapes", "readMesh", "fitCurve", "transformSteps"]);

/** Functions that ask for the greedy growth, whatever the method of the document. */
const GREEDY = new Set(["steps", "sets"]);

/** @typedef {{ name: import("./connect.js").Name, args: any[] }} Call */

/**
 * Solves the document of a call in steps; a picture is painted, a solid is built, distances are found, and questions about a body are answered in steps as well.
 *
 * @param {import("./directrix.js").Directrix} dx
 * @param {Call} call
 * @param {object} host
 * @param {() => boolean} host.isWanted whether the answer is still waited for; looked at between turns
 * @param {(progress: number) => void} host.onprogress
 * @returns {Promise<{ value: any, spent: number } | null>} the answer and the milliseconds that its turns took, `null` when it is no longer wanted
 */
export async function inTurns(dx, { name, args }, { isWanted, onprogress }) {
  const [first, ...rest] = args;
  if (UNSOLVED.has(name)) return { value: /** @type {any} */ (dx)[name](...args), spent: 0 };
  const isOfDocument = name !== "distanceTransform" && name !== "solveLaplace";
  const text = !isOfDocument ? "" : name === "hyperpatch" ? first : toText(first);
  const free = () => (name === "solveLaplace" ? postedJob(dx, first, rest[0]) : dx.job(text, { distanceTransform: first }));
  const job = isOfDocument ? dx.job(text, goal(name, rest[0])) : free();
  let spent = 0;
  const step = () => {
    const start = performance.now();
    const state = job.step(BUDGET);
    spent += performance.now() - start;
    return state;
  };
  let state = step();
  for (; !state.done; state = step()) {
    onprogress(state.progress);
    await nextMessage();
    if (!isWanted()) return null;
  }
  if ("answer" in state) return { value: state.answer, spent };
  if (state.distances) return { value: state.distances, spent };
  return { value: state.picture ?? state.solid ?? state.file ?? state.harmonic ?? /** @type {any} */ (dx)[name](text, ...rest), spent };
}

/**
 * What the job of a call is to do.
 *
 * @param {Call["name"]} name
 * @param {any} options
 */
function goal(name, options) {
  if (name === "paint") return { paint: options };
  if (name === "harmonic") return { harmonic: options ?? {} };
  if (name === "solid") return { solid: options ?? {} };
  if (name === "solidFile") return { solidFile: options };
  if (name === "hyperpatch") return { hyperpatch: options };
  if (name === "part") return { part: options };
  if (name === "boundary") return { boundary: {} };
  if (name === "exact") return { boundary: { points: options ?? null } };
  return name === "match" ? options : { greedy: GREEDY.has(name) };
}

/** @type {MessageChannel | undefined} */
let channel;

/** Lets the messages that wait be handled. */
function nextMessage() {
  const { port1, port2 } = (channel ??= new MessageChannel());
  return new Promise((resolve) => {
    port1.onmessage = resolve;
    port2.postMessage(null);
  });
}
