/**
 * The status line of a harmonic blend, and the notice of a stack that needs one.
 *
 * @import { App } from "../state/app.js"
 * @import { Diagnostic, Match, Point } from "../types.js"
 */
import "../../styles/harmonic.css";
import { h } from "../dom.js";
import { coordinate, fixed, milliseconds } from "../format.js";
import { command, item, label, strong } from "../frame/status-parts.js";
import { icon } from "../icons.js";
import { numberNode } from "../number-node.js";
import { curveName } from "../state/app.js";
import { inSentence, strings } from "../strings.js";
import { bring } from "../witness.js";
import { useHarmonic } from "./commands.js";
import { words } from "./words.js";

/** Codes after which there is no blend, in the words of the page. */
const FAULTS = /** @type {{[code: string]: (names: string[], where: string) => string}} */ (words.faults);
const REMARKS = /** @type {{[code: string]: string}} */ (words.remarks);

/** What keeps curves from having a harmonic blend. @param {Match} match */
const faultOf = ({ ok, diagnostics }) => (ok ? undefined : diagnostics.find(({ code }) => code in FAULTS));

/** Counts that should be zero. @param {Match} match */
export const failures = ({ ok, harmonic }) => (ok && harmonic ? harmonic.crossings + harmonic.lost : 1);

/**
 * @param {App} app
 * @param {Match} match
 * @param {number | null} ms
 * @returns {Node[]}
 */
export function certificates(app, match, ms) {
  const { harmonic } = match;
  const count = failures(match);
  const verdict =
    count === 0
      ? h("span", { class: "verdict" }, /** @type {any} */ (icon("check")), strong(strings.status.verified))
      : h("span", { class: "verdict failed" }, strings.status.problems(count));
  const time = ms === null ? [] : [item("ms", strong(milliseconds(ms)), label(strings.status.ms))];
  if (!harmonic) {
    const at = faultOf(match)?.at;
    return [verdict, ...(at ? [showing(app, at)] : []), ...time];
  }
  const { segments, lines, crossings, lost, iterations, residual, fluxBalance } = harmonic;
  return [
    verdict,
    item("segments", strong(String(segments)), label(words.status.segments(segments))),
    item("lines", strong(String(lines)), label(words.status.lines(lines))),
    counted("crossings", words.status.crossings, crossings),
    ...(lost > 0 ? [counted("lost", words.status.lost, lost)] : []),
    item("balance", label(words.status.balance), strong(share(fluxBalance))),
    item("iterations", strong(String(iterations)), label(words.status.iterations(iterations)), strong(numberNode(residual))),
    ...time,
  ];
}

/** A count, in the colour of failures where it is not zero. @param {string} name @param {string} text @param {number} value */
function counted(name, text, value) {
  const node = item(name, label(text), strong(String(value)));
  if (value > 0) node.classList.add("failed");
  return node;
}

/** @param {App} app @param {Point} at */
function showing(app, at) {
  const place = `x ${coordinate(at[0])}, y ${coordinate(at[1])}`;
  const show = () => {
    app.ui.set({ witness: at });
    bring(app, at);
    app.say(words.status.shown(place));
  };
  const button = h("button", { type: "button", class: "failed", "data-certificate": "place", title: place, onclick: show }, label(words.status.place));
  return h("span", { class: "item", "data-total": "place" }, button);
}

/** A share in per cent: as small as it is, without digits that mean nothing. @param {number} value */
function share(value) {
  const percent = 100 * value;
  return `${percent < 1e-4 ? "0" : percent < 0.01 ? percent.toPrecision(1) : fixed(percent, 2)}\u00a0%`;
}

/**
 * What is to be said of a match beside its numbers, and what can be done; null where there is nothing.
 * @param {App} app
 * @param {Match} match
 * @returns {Node[] | null}
 */
export function remark(app, match) {
  const several = match.diagnostics.find(({ code }) => code === "several-inner");
  if (several) return [reason(sentence(app, several)), command("use-harmonic", words.use, () => useHarmonic(app))];
  const fault = faultOf(match) ?? match.diagnostics.find(({ code }) => code in REMARKS);
  if (!fault) return null;
  return [fault.code in REMARKS ? label(REMARKS[fault.code]) : reason(sentence(app, fault))];
}

/** @param {App} app @param {Diagnostic} diagnostic */
function sentence(app, { code, curves = [], at }) {
  const names = curves.map((index, k) => (k === 0 ? curveName(app.store.document, index) : inSentence(curveName(app.store.document, index))));
  if (code === "several-inner") return words.several(names);
  return FAULTS[code](names, at ? strings.errors.near(coordinate(at[0]), coordinate(at[1])) : "");
}

/** @param {string} text */
const reason = (text) => h("span", { class: "failed reason", "data-reason": "", title: text }, text);
