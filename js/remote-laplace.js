/** Solutions of Laplace's equation over a connection; loaded when the first one is asked for. */
import { isControl } from "./connect.js";

/** The number of the next problem. */
let next = 1;

/**
 * A solution whose questions the worker answers. It keeps the problem, so that a worker that was restarted, or has forgotten it, solves it again.
 *
 * @param {(args: any[]) => Promise<any>} send
 * @param {import("./directrix.js").LaplaceInput} input
 * @param {import("./directrix.js").Control} [control]
 * @returns {Promise<import("./directrix.js").RemoteLaplaceSolution>}
 */
export async function remoteLaplace(send, input, control) {
  const key = next++;
  const own = structuredClone(input);
  const call = async (/** @type {string} */ question, /** @type {object} */ rest, /** @type {unknown[]} */ last, isNew = false) => {
    try {
      return await send([isNew ? { key, input: own } : { key }, { question, rest }, ...last]);
    } catch (error) {
      if (/** @type {any} */ (error)?.code !== "unsent") throw error;
      return send([{ key, input: own }, { question, rest }, ...last]);
    }
  };
  const summary = await call("solve", {}, control ? [control] : [], true);
  const method = (/** @type {string} */ question) => (/** @type {any} */ first, /** @type {any[]} */ ...more) => {
    const last = more.at(-1);
    const hasControl = typeof last === "object" && last !== null && isControl(last);
    const [options] = hasControl ? more.slice(0, -1) : more;
    return call(question, { first, options }, hasControl ? [last] : []);
  };
  return { ...summary, at: method("at"), gradientAt: method("gradientAt"), section: method("section") };
}
