/** Bodies of hyperpatches over a connection; loaded when the first one is asked for. */
import { inNames, methods } from "./body.js";
import { isControl } from "./connect.js";
import { merged } from "./merge.js";
import { packed, valueOf } from "./operations.js";
import { posted } from "./post.js";

/** @typedef {{ call(name: "hyperpatch", args: any[]): Promise<any> }} Client */

/**
 * Keys of the operations that each connection was sent. They are numbers, and forgotten when there are too many: what is not known is sent
 * again.
 *
 * @type {WeakMap<Client, Set<number>>}
 */
const sent = new WeakMap();
const MOST_SENT = 100_000;

/**
 * A body whose questions the worker answers. They name the operations of the document and bring those that the worker was not sent before; a
 * worker that does not have them, because it was restarted or has forgotten them, says so, and gets them all.
 *
 * @param {Client} client
 * @param {import("./directrix.js").HyperpatchDocument | string} document
 * @param {import("./directrix.js").Control} [control]
 * @returns {Promise<import("./directrix.js").RemoteHyperpatch>}
 */
export async function body(client, document, control) {
  const parts = packed(document);
  const call = async (/** @type {string} */ question, /** @type {object} */ rest, /** @type {unknown[]} */ last) => {
    let known = sent.get(client);
    if (!known || known.size > MOST_SENT) sent.set(client, (known = new Set()));
    const send = () => client.call("hyperpatch", [posted(parts, known), { question, rest }, ...last]);
    try {
      return await send();
    } catch (error) {
      if (/** @type {any} */ (error)?.code !== "unsent") throw error;
      for (const key of parts.keys) known.delete(key);
      return send();
    }
  };
  const found = await call("body", {}, control ? [control] : []);
  const ask = (/** @type {import("./body.js").Question} */ question, /** @type {any[]} */ args) => {
    const last = args.at(-1);
    const own = typeof last === "object" && last !== null && isControl(last) ? 1 : 0;
    return call(question, inNames(question, args.slice(0, args.length - own)), args.slice(args.length - own));
  };
  return { ...found, ...methods(ask) };
}

/**
 * A document with the cells of another one.
 *
 * @param {Client} client
 * @param {import("./directrix.js").HyperpatchDocument | string} document
 * @param {import("./directrix.js").HyperpatchDocument | string} other
 * @param {import("./directrix.js").Control} [control]
 * @returns {Promise<import("./directrix.js").HyperpatchDocument>}
 */
export async function merge(client, document, other, control) {
  const own = /** @type {import("./directrix.js").HyperpatchDocument} */ (valueOf(document));
  const written = async (/** @type {typeof own | string} */ one) => (await body(client, one, control)).cellsDocument(control);
  const { materials = [] } = await written({ ...own, operations: [] });
  await body(client, own, control);
  const made = merged(own, materials, await written(other));
  await body(client, made, control);
  return made;
}
