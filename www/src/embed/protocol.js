/**
 * The messages between an embedded figure and the page around it: their form, and what is wrong with one. See docs/embedding.md.
 *
 * @import { DocumentInput } from "../../../js/directrix.js"
 */

/** The version of the messages. */
export const VERSION = 1;

/**
 * A message `directrix:set`, all of whose fields may be left out.
 *
 * @typedef {object} Wish
 * @property {DocumentInput} [document]
 * @property {string} [preset]
 * @property {number} [s]
 * @property {string} [controls]
 * @property {string} [theme]
 * @property {string} [alt]
 * @property {boolean} [playing]
 */

/** @param {...string} values */
const oneOf = (...values) => ({
  expected: values.join(", "),
  fits: (/** @type {unknown} */ value) => typeof value === "string" && values.includes(value),
});

/** @type {{ [name: string]: { expected: string, fits: (value: unknown) => boolean } }} */
const FIELDS = {
  document: {
    expected: "a document or its JSON text",
    fits: (value) => typeof value === "string" || (typeof value === "object" && value !== null && !Array.isArray(value)),
  },
  preset: {
    expected: "the name of a preset, of small letters, digits and hyphens",
    fits: (value) => typeof value === "string" && value.length <= 64 && /^[a-z0-9]+(-[a-z0-9]+)*$/.test(value),
  },
  s: { expected: "a number from 0 to 1", fits: (value) => typeof value === "number" && value >= 0 && value <= 1 },
  controls: oneOf("full", "minimal", "none"),
  theme: oneOf("auto", "light", "dark"),
  alt: {
    expected: "a text of at most 1000 characters",
    fits: (value) => typeof value === "string" && value.length <= 1000,
  },
  playing: { expected: "true or false", fits: (value) => typeof value === "boolean" },
};

/** Fields of every message. */
const ENVELOPE = ["type", "v"];

/**
 * Reads what another page has sent.
 *
 * @param {unknown} data
 * @returns {{ wish: Wish } | { error: { code: string, path: string, message: string } } | null} `null` for what is no message to a figure
 */
export function readMessage(data) {
  if (typeof data !== "object" || data === null || !("type" in data) || data.type !== "directrix:set") return null;
  const given = /** @type {{ [name: string]: unknown }} */ (data);
  if (given.v !== VERSION) return refused("version", "v", given.v, `expected ${VERSION}`);
  for (const [name, value] of Object.entries(given)) {
    if (ENVELOPE.includes(name) || value === undefined) continue;
    const field = Object.hasOwn(FIELDS, name) ? FIELDS[name] : null;
    if (!field) return { error: { code: "unknown-field", path: shortened(name), message: `expected one of ${Object.keys(FIELDS).join(", ")}` } };
    if (!field.fits(value)) return refused("range", name, value, `expected ${field.expected}`);
  }
  if (given.document !== undefined && given.preset !== undefined) return refused("range", "preset", given.preset, "expected a document or a preset, not both");
  const { type: _, v: __, ...wish } = given;
  return { wish };
}

/** @param {string} code @param {string} path @param {unknown} value @param {string} expected */
function refused(code, path, value, expected) {
  const found = typeof value === "string" ? `"${shortened(value)}"` : typeof value === "object" && value !== null ? `a value of type object` : String(value);
  return { error: { code, path, message: `${found} was found; ${expected}` } };
}

/** @param {string} text */
const shortened = (text) => (text.length > 40 ? `${text.slice(0, 40)}…` : text);
