/** Bodies of hyperpatches among documents and presets, told apart before anything is loaded for them. */

/** @param {unknown} given a document, its text, or neither */
export function isBody(given) {
  if (typeof given !== "string") return /** @type {any} */ (given)?.kind === "hyperpatch";
  // What is no JSON is told where it is read.
  try {
    return JSON.parse(given)?.kind === "hyperpatch";
  } catch {
    return false;
  }
}

/** Presets of bodies, which have a folder of their own. @param {string | null} name */
export const isBodyPreset = (name) => name !== null && /^hyperpatch-[a-z0-9]/.test(name);
