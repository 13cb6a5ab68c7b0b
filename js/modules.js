/**
 * The two modules of the package by name, each with the code that binds it: `figure` reads curves documents, `full` is
 * to read part documents as well.
 */
const MODULES = {
  figure: { glue: () => import("./pkg/directrix.js"), file: "directrix_bg.wasm" },
  full: { glue: () => import("./pkg/directrix_full.js"), file: "directrix_full_bg.wasm" },
};

/**
 * @param {string} name
 * @returns {(typeof MODULES)["figure"]}
 */
export function moduleNamed(name) {
  const found = /** @type {Record<string, any>} */ (MODULES)[name];
  if (!Object.hasOwn(MODULES, name)) throw new RangeError(`module "${name}" was found; expected "figure" or "full"`);
  return found;
}
