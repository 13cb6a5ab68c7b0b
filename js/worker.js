import { DirectrixError, fromModule } from "./errors.js";
import { load } from "./index.js";
import { toText } from "./text.js";

/** Milliseconds of work between two looks at the mailbox. */
const BUDGET = 12;

/** Functions that do not ask for the solution of a document. */
const UNSOLVED = new Set(["defaults", "fit", "insertPoint", "readShapes", "fitCurve"]);

/** Functions that ask for the greedy growth, whatever the method of the document. */
const GREEDY = new Set(["steps", "sets"]);

/** @typedef {{ id: number, name: import("./connect.js").Name, args: any[] }} Call */

const scope = /** @type {any} */ (globalThis);
/** @type {Call[]} */
const calls = [];
/** @type {number | undefined} */
let current;
/** @type {import("./directrix.js").Directrix | undefined} */
let dx;

/** @param {MessageEvent} event */
scope.onmessage = async ({ data }) => {
  if (data.type === "open") {
    try {
      dx = await load(data.options);
      scope.postMessage({ type: "ready" });
    } catch (error) {
      scope.postMessage({ type: "failed", error: plain(error) });
    }
    return work();
  }
  if (data.type === "cancel") {
    const index = calls.findIndex((call) => call.id === data.id);
    if (index >= 0) calls.splice(index, 1);
    if (current === data.id) current = undefined;
    return;
  }
  calls.push(data);
  work();
};

let working = false;

/** Answers the calls in the order in which they came. */
async function work() {
  if (working || !dx) return;
  working = true;
  for (let call = calls.shift(); call; call = calls.shift()) {
    current = call.id;
    try {
      const { picture, spent } = await solve(dx, call);
      if (current === call.id) answer(call.id, picture ?? run(dx, call), spent);
    } catch (error) {
      scope.postMessage({ type: "error", id: call.id, error: plain(error) });
    }
  }
  current = undefined;
  working = false;
}

/**
 * Solves the document of a call in steps, so that messages get through in between. A picture is painted in steps as well.
 *
 * @param {import("./directrix.js").Directrix} dx
 * @param {Call} call
 * @returns {Promise<{picture?: import("./directrix.js").Picture | undefined, spent: number}>} the answer to a call for a
 *   picture, and the milliseconds that the steps took
 */
async function solve(dx, { id, name, args }) {
  if (UNSOLVED.has(name)) return { spent: 0 };
  args[0] = toText(args[0]);
  const job = dx.job(args[0], name === "paint" ? { paint: args[1] } : name === "match" ? args[1] : { greedy: GREEDY.has(name) });
  let spent = 0;
  const step = () => {
    const start = performance.now();
    const state = job.step(BUDGET);
    spent += performance.now() - start;
    return state;
  };
  let state = step();
  for (; !state.done && current === id; state = step()) {
    scope.postMessage({ type: "progress", id, progress: state.progress });
    await nextMessage();
  }
  return { picture: state.picture, spent };
}

/**
 * @param {import("./directrix.js").Directrix} dx
 * @param {Call} call
 */
function run(dx, { name, args }) {
  return /** @type {any} */ (dx)[name](...args);
}

/**
 * @param {number} id
 * @param {any} value
 * @param {number} spent milliseconds
 */
function answer(id, value, spent) {
  const transfer = value?.data instanceof Uint8ClampedArray ? [value.data.buffer] : [];
  scope.postMessage({ type: "result", id, value, spent }, transfer);
}

const { port1, port2 } = new MessageChannel();

/** Lets the messages that wait be handled. */
function nextMessage() {
  return new Promise((resolve) => {
    port1.onmessage = resolve;
    port2.postMessage(null);
  });
}

/** @param {unknown} error */
function plain(error) {
  const known = fromModule(error);
  if (known instanceof DirectrixError) {
    return { code: known.code, path: known.path, message: known.message, at: known.at };
  }
  return { code: "failed", path: "", message: known instanceof Error ? known.message : String(known) };
}
