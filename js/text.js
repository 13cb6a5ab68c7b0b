import { DirectrixError } from "./errors.js";

/** Deepest nesting that is looked at: a document has six levels. */
const DEEPEST = 64;

/**
 * Returns the JSON text of a document or of options. Text is taken as it is.
 *
 * Numbers that are not finite are refused by path here, because JSON would turn them into null.
 *
 * @param {unknown} value
 * @param {string} [name] path of the value itself
 * @returns {string}
 * @throws {DirectrixError} with code `non-finite`, `type` or `limit`
 */
export function toText(value, name = "") {
  if (typeof value === "string") return value;
  if (value === null || typeof value !== "object") {
    throw new DirectrixError("type", name, `${String(value)} was found; expected an object`);
  }
  refuse(value, name, 0);
  return JSON.stringify(value);
}

/**
 * @param {unknown} value
 * @param {string} path
 * @param {number} depth
 */
function refuse(value, path, depth) {
  if (typeof value === "number" && !Number.isFinite(value)) {
    throw new DirectrixError("non-finite", path, `${value} was found; expected a finite number`);
  }
  if (typeof value === "bigint") {
    throw new DirectrixError("type", path, `the bigint ${value} was found; expected a number`);
  }
  if (value === null || typeof value !== "object") return;
  if (depth === DEEPEST) throw new DirectrixError("limit", path, `expected at most ${DEEPEST} levels`);
  if (Array.isArray(value)) {
    value.forEach((item, index) => refuse(item, `${path}[${index}]`, depth + 1));
    return;
  }
  for (const [key, item] of Object.entries(value)) {
    refuse(item, path === "" ? key : `${path}.${key}`, depth + 1);
  }
}
