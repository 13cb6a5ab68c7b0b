/** Bodies of hyperpatches over a connection; loaded when the first one is asked for. */
import { inNames, methods } from "./body.js";
import { isControl } from "./connect.js";
import { toText } from "./text.js";

/**
 * A body whose questions the worker answers. They carry the text of the document, so that a worker that was restarted answers them as well.
 *
 * @param {(args: any[]) => Promise<any>} send
 * @param {import("./directrix.js").HyperpatchDocument | string} document
 * @param {import("./directrix.js").Control} [control]
 * @returns {Promise<import("./directrix.js").RemoteHyperpatch>}
 */
export async function body(send, document, control) {
  const text = toText(document);
  const call = (/** @type {string} */ question, /** @type {object} */ rest, /** @type {unknown[]} */ last) =>
    send([text, { question, rest }, ...last]);
  const cells = await call("cells", {}, control ? [control] : []);
  const ask = (/** @type {import("./body.js").Question} */ question, /** @type {any[]} */ args) => {
    const last = args.at(-1);
    const own = typeof last === "object" && last !== null && isControl(last) ? 1 : 0;
    return call(question, inNames(question, args.slice(0, args.length - own)), args.slice(args.length - own));
  };
  return { cells, ...methods(ask) };
}
