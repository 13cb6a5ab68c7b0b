/** Parts over a connection; loaded when the first one is asked for. */
import { isControl } from "./connect.js";
import { partArguments, partMethods } from "./part.js";
import { toText } from "./text.js";

/**
 * A part whose questions the worker answers. They carry the text of the document, so that a worker that was restarted answers them as well.
 *
 * @param {(args: any[]) => Promise<any>} send
 * @param {import("./directrix.js").PartDocument | string} document
 * @param {import("./directrix.js").Control} [control]
 * @returns {Promise<import("./directrix.js").RemotePart>}
 */
export async function remotePart(send, document, control) {
  const text = toText(document);
  const call = (/** @type {string} */ question, /** @type {object} */ rest, /** @type {unknown[]} */ last) =>
    send([text, { question, rest }, ...last]);
  const summary = await call("part", {}, control ? [control] : []);
  const ask = (/** @type {import("./part.js").Question} */ question, /** @type {any[]} */ args) => {
    const last = args.at(-1);
    const own = typeof last === "object" && last !== null && isControl(last) ? 1 : 0;
    return call(question, partArguments(question, args.slice(0, args.length - own)), args.slice(args.length - own));
  };
  return { ...summary, ...partMethods(ask) };
}
