/**
 * Kinds among documents and presets, told apart before anything is loaded for them.
 *
 * @typedef {"curves" | "hyperpatch" | "part" | "laplace"} Kind
 */

/** The kind of a document or of its text; what is none is told where it is read. @param {unknown} given @returns {Kind} */
export function kindOf(given) {
  let read = given;
  if (typeof given === "string") {
    try {
      read = JSON.parse(given);
    } catch {
      read = null;
    }
  }
  const kind = /** @type {any} */ (read)?.kind;
  return kind === "hyperpatch" || kind === "part" || kind === "laplace" ? kind : "curves";
}

/** The kind of a preset: those of bodies, parts and boundary value problems have folders of their own. @param {string | null} name @returns {Kind} */
export const presetKind = (name) => /** @type {Kind} */ (/^(hyperpatch|part|laplace)-[a-z0-9]/.exec(name ?? "")?.[1] ?? "curves");
