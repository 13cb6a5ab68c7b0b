import { readFile } from "node:fs/promises";
import { loader } from "./loader.js";
import { moduleNamed } from "./modules.js";

export { DirectrixError } from "./errors.js";
export { renewSurface } from "./renew.js";
export { describePart } from "./part-sentence.js";
export { describe, describeBody, describeCurves } from "./sentence.js";

/** Loads a module from disk once and returns its functions. See docs/api.md. */
export const load = loader(async (module, wasm) => {
  const { glue, file } = moduleNamed(module);
  const { initSync, Engine } = await glue();
  const isAddress = wasm === undefined || wasm instanceof URL || typeof wasm === "string";
  const bytes = isAddress ? await readFile(wasm ?? new URL(`./pkg/${file}`, import.meta.url)) : wasm;
  initSync({ module: /** @type {BufferSource} */ (bytes) });
  return new Engine();
});

/** A connection needs a worker of the browser's kind; in Node the functions of `load()` do the same work. */
export function connect() {
  return Promise.reject(new TypeError("connect() needs a browser; in Node use load()"));
}
