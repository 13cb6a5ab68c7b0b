/**
 * Edits of the design rules of a part, as pure functions.
 *
 * @import { WholePart } from "../document.js"
 *
 * @typedef {NonNullable<WholePart["rules"]>[number]} DesignRule
 */
import { FAR, freeName } from "./features.js";
import { tidy } from "./numbers.js";

/** Most design rules of a document, as in docs/format.md. */
export const RULE_LIMIT = 32;

/** @param {WholePart} document */
export const rulesOf = ({ rules = [] }) => rules;

/** A rule that all fractions keep. @param {WholePart} document @param {string} name @returns {WholePart} */
export function addRule(document, name) {
  const rules = rulesOf(document);
  if (rules.length >= RULE_LIMIT) return document;
  const own = freeName(name, rules.map((rule) => rule.name));
  return { ...document, rules: [...rules, { name: own, material: 0, of: "fraction", least: 0, most: 1 }] };
}

/** @param {WholePart} document @param {number} index @returns {WholePart} */
export function removeRule(document, index) {
  const rules = rulesOf(document);
  return rules[index] ? { ...document, rules: rules.filter((_, k) => k !== index) } : document;
}

/**
 * Changes a rule. `least` and `most` keep their order: the one that is set pushes the other before it.
 * @param {WholePart} document
 * @param {number} index
 * @param {Partial<DesignRule>} patch
 * @returns {WholePart}
 */
export function changeRule(document, index, patch) {
  const rule = rulesOf(document)[index];
  if (!rule) return document;
  const next = { ...rule, ...patch };
  const far = next.of === "gradient" ? FAR : 1;
  const bounded = (/** @type {number} */ value) => tidy(Math.min(far, Math.max(0, value)));
  let [least, most] = [bounded(next.least ?? 0), bounded(next.most ?? far)];
  if (least > most && patch.least !== undefined) most = least;
  else if (least > most) least = most;
  const whole = { ...next, least, most };
  if (JSON.stringify(whole) === JSON.stringify(rule)) return document;
  return { ...document, rules: rulesOf(document).map((other, k) => (k === index ? whole : other)) };
}
