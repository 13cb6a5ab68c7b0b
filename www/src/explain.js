/**
 * Failures in the words of the page: where, and what to do.
 *
 * @import { CurvesDocument, Diagnostic, Match, Problem } from "./types.js"
 */
import { coordinate } from "./format.js";
import { curveName, spanName } from "./state/app.js";
import { strings } from "./strings.js";

/**
 * Why there is no result for a document.
 * @param {CurvesDocument} document
 * @param {Problem} problem
 */
export function explain(document, { code, path = "", message, at }) {
  const words = strings.errors;
  const where = at ? words.near(coordinate(at[0]), coordinate(at[1])) : "";
  switch (code) {
    case "self-intersection": {
      const index = /curves\[(\d+)\]/.exec(path)?.[1];
      const curve = index === undefined ? words.aCurve : words.curve(curveName(document, Number(index)));
      return words.selfIntersection(curve, where);
    }
    case "contact":
      return words.contact(where);
    case "zero-length":
      return words.zeroLength;
    default:
      return words.document(path, message);
  }
}

/** Which pins cannot be kept, and why. @param {Diagnostic} diagnostic */
export const pinFault = ({ pins = [], reason = "blocked" }) => strings.advice.pins(pins.map((index) => index + 1).join(" and "), reason);

/** Remarks on a whole result that the person should act on. */
const SHORTFALLS = ["unverified-gap", "sample-limit"];

/**
 * What to do about a partial result, or null when it is whole.
 * @param {Match} match
 * @returns {string | null}
 */
export function advice({ ok, diagnostics, totals, spans }) {
  const words = strings.advice;
  // Of a stack, the first span that falls short.
  const short = spans?.findIndex((span) => !span.ok) ?? -1;
  if (spans && short >= 0) return `${spanName(short)}: ${advice(spans[short])}`;
  const has = (/** @type {string} */ name) => diagnostics.find(({ code }) => code === name);
  const bad = has("pins");
  if (bad) return pinFault(bad);
  const occluded = has("occluded")?.lines?.length;
  if (occluded) return words.occluded(occluded);
  const [a, b] = totals.lines?.uncovered ?? [[], []];
  if (!ok && a.length + b.length > 0) {
    const why = has("orphan")
      ? words.openPocket
      : has("jammed")
        ? words.jammed
        : has("solvable")
          ? words.solvable
          : has("stuck")
            ? words.moveApart
            : words.unpaired;
    return `${words.notCovered(a.length, b.length)} ${why}`;
  }
  // A whole result may still hold less than was asked for.
  const first = ok ? diagnostics.find(({ code }) => SHORTFALLS.includes(code)) : (has("unverified") ?? diagnostics.find(({ code }) => code !== "corner"));
  if (!first) return null;
  const known = /** @type {{[code: string]: unknown}} */ (words)[first.code];
  return typeof known === "string" ? known : first.message;
}
