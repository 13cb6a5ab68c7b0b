import { loader } from "./loader.js";
import { moduleNamed } from "./modules.js";

export { connect } from "./connect.js";
export { DirectrixError } from "./errors.js";
export { renewSurface } from "./renew.js";
export { describePart } from "./part-sentence.js";
export { describe, describeBody, describeCurves } from "./sentence.js";

/** Loads a module over the network once and returns its functions. See docs/api.md. */
export const load = loader(async (module, wasm) => {
  const { default: init, Engine } = await moduleNamed(module).glue();
  await init(wasm === undefined ? undefined : { module_or_path: wasm });
  return new Engine();
});
