import { DirectrixError, fromModule } from "./errors.js";
import { load } from "./index.js";
import { countFrom } from "./operations.js";
import { receive } from "./post.js";
import { inTurns } from "./turns.js";

/** @typedef {{ id: number, name: import("./connect.js").Name, args: any[] }} Call */

const scope = /** @type {any} */ (globalThis);
/** @type {Call[]} */
const calls = [];
/** @type {number | undefined} */
let current;
/** @type {import("./directrix.js").Directrix | undefined} */
let dx;

// Documents that come as text get keys of their own, apart from those of documents that come in parts.
countFrom(2 ** 31);

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
  receive(data.args[0]);
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
      const { id } = call;
      const found = await inTurns(dx, call, {
        isWanted: () => current === id,
        onprogress: (progress) => scope.postMessage({ type: "progress", id, progress }),
      });
      if (found && current === id) answer(id, found.value, found.spent);
    } catch (error) {
      scope.postMessage({ type: "error", id: call.id, error: plain(error) });
    }
  }
  current = undefined;
  working = false;
}

/**
 * @param {number} id
 * @param {any} value
 * @param {number} spent milliseconds
 */
function answer(id, value, spent) {
  scope.postMessage({ type: "result", id, value, spent }, buffersOf(value));
}

/**
 * The buffers of arrays of numbers that an answer is, has, or has lists of: those of pictures, solids and files. They are not copied.
 *
 * @param {any} value
 * @returns {Transferable[]}
 */
function buffersOf(value) {
  if (ArrayBuffer.isView(value)) return [/** @type {ArrayBuffer} */ (value.buffer)];
  if (typeof value !== "object" || value === null || Array.isArray(value)) return [];
  const arrays = Object.values(value).flatMap((field) => (Array.isArray(field) && ArrayBuffer.isView(field[0]) ? field : [field]));
  return arrays.filter((array) => ArrayBuffer.isView(array)).map((array) => array.buffer);
}

/** @param {unknown} error */
function plain(error) {
  const known = fromModule(error);
  if (known instanceof DirectrixError) {
    return { code: known.code, path: known.path, message: known.message, at: known.at, place: known.place };
  }
  return { code: "failed", path: "", message: known instanceof Error ? known.message : String(known) };
}
