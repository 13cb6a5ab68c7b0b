/**
 * The method of a document as one choice, and the printed rules, as pure functions from one document to the next.
 *
 * @import { CurvesDocument, Matching, PrintedRule } from "../types.js"
 *
 * @typedef {"integral" | "sum" | "sum-less-price" | "greedy" | "one-per-vertex" | "shift" | "parameter"} Choice
 *   A method; the exact ones by what they make greatest.
 */
import { patch } from "./edits.js";

/** @type {readonly Choice[]} */
export const CHOICES = ["integral", "sum", "sum-less-price", "greedy", "one-per-vertex", "shift", "parameter"];

/** Rules of any method, and those of the greedy growth alone. @type {readonly PrintedRule[]} */
const ANY = ["normals", "negative", "heights", "stages"];
/** @type {readonly PrintedRule[]} */
const GROWTH = ["order", "removal", "stop"];

/** @param {Choice} choice */
const isExact = (choice) => choice === "integral" || choice === "sum" || choice === "sum-less-price";

/** @param {Matching} matching @returns {Choice} */
export const choiceOf = ({ method, objective = "integral" }) => (method === "exact" ? objective : method);

/**
 * Pins belong to the exact methods: they go with them.
 * @param {CurvesDocument} document
 * @param {Choice} choice
 */
export function choose(document, choice) {
  if (choiceOf(document.matching) === choice) return document;
  if (isExact(choice)) {
    return patch(document, "matching", { method: "exact", objective: choice });
  }
  const { pins: _, ...matching } = document.matching;
  return { ...document, matching: { ...matching, method: choice } };
}

/** The rules that a method has. @param {Matching} matching @returns {PrintedRule[]} */
export const rulesOf = ({ method }) => (method === "greedy" ? [...ANY, ...GROWTH] : [...ANY]);

/**
 * All rules as printed or none. The stop of the pseudo-code stays out, which contradicts the text beside it and ends with one line; it
 * can be taken singly.
 * @param {CurvesDocument} document
 * @param {boolean} on
 */
export function printAll(document, on) {
  const printed = on ? rulesOf(document.matching).filter((rule) => rule !== "stop") : [];
  return patch(document, "matching", { printed });
}

/**
 * @param {CurvesDocument} document
 * @param {PrintedRule} rule
 * @param {boolean} on
 */
export function printRule(document, rule, on) {
  const before = document.matching.printed ?? [];
  const printed = on ? [...before.filter((other) => other !== rule), rule] : before.filter((other) => other !== rule);
  return patch(document, "matching", { printed });
}

/** One-to-one lines of the exact methods: a number of their own, or as many as the larger number of samples.
 * @param {CurvesDocument} document
 * @param {number} count
 * @param {number} samples
 */
export function setLines(document, count, samples) {
  const { lines, ...matching } = document.matching;
  if ((lines ?? samples) === count) return document;
  return { ...document, matching: { ...matching, ...(count === samples ? {} : { lines: count }) } };
}
