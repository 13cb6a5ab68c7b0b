import { createApi } from "./api.js";

/**
 * Makes a `load()` that starts each module once; a start that failed can be tried again.
 *
 * @param {(module: "figure" | "full", wasm: import("./directrix.js").LoadOptions["wasm"]) => Promise<import("./pkg/directrix.js").Engine>} start
 * @returns {typeof import("./directrix.js").load}
 */
export function loader(start) {
  /** @type {Map<string, Promise<import("./directrix.js").Directrix>>} */
  const loaded = new Map();
  return ({ module = "full", wasm } = {}) => {
    let api = loaded.get(module);
    if (!api) {
      api = start(module, wasm).then(createApi);
      loaded.set(module, api);
      api.catch(() => loaded.delete(module));
    }
    return api;
  };
}
