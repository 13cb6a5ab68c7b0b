/**
 * The status line of the step view: lines, their sum and what is not covered, or why there are no steps.
 *
 * @import { Note } from "../state/app.js"
 * @import { Now } from "./groups.js"
 */
import { h } from "../dom.js";
import { milliseconds } from "../format.js";
import { item, label, strong } from "../frame/status-parts.js";
import { symbol } from "../icons.js";
import { fillStatus } from "../modes/status-line.js";
import { numberNode } from "../number-node.js";
import { shownTotals } from "../state/lines.js";
import { totalOf } from "./film.js";
import { words } from "./words.js";

/** Text in the colour of an error, or plain. @param {boolean} isError @param {string} text */
const reason = (isError, text) => h("span", { class: isError ? "failed reason" : "" }, text);

/**
 * @param {HTMLElement} element
 * @param {object} state
 * @param {Now | null} state.now
 * @param {string} state.why there is nothing to show, where there is not
 * @param {boolean} state.isFailure whether that is an error
 * @param {Note | null} state.note
 * @param {number} state.ms time of the solver
 */
export function renderStatus(element, { now, why, isFailure, note, ms }) {
  const left = now ? measures(now) : [reason(isFailure, why || words.loading)];
  const trace = now ? h("span", { class: "number" }, `${words.status.trace(totalOf(now.steps))} · ${milliseconds(ms)} ${words.status.ms}`) : null;
  fillStatus(element, isFailure ? "error" : "steps", left, [note ? reason(note.tone === "error", note.text) : trace]);
}

/** @param {Now} now */
function measures(now) {
  const { steps, scene, hidden } = now;
  const { phase, chosen } = scene;
  const w = words.status;
  const isCounted = chosen && !hidden && phase !== "removal" && phase !== "growth";
  const lines = isCounted ? [...scene.lines, chosen] : scene.lines;
  const totals = phase === "end" ? shownTotals(steps) : null;
  const [a, b] = scene.degrees.map((degrees, curve) => degrees.filter((degree, vertex) => degree === ownEnd(now, curve, vertex)).length);
  return [
    item("lines", strong(String(lines.length)), label(w.lines(lines.length))),
    item("sum", label(w.sum), symbol("f"), strong(numberNode(lines.reduce((sum, { value }) => sum + value, 0)))),
    ...(totals
      ? [item("crossings", label(w.crossings), strong(String(totals.crossings))), item("blocked", label(w.blocked), strong(String(totals.blocked)))]
      : []),
    ...(phase === "end" && steps.pairs.length > 0 ? [] : [item("uncovered", label(w.uncovered), strong(a + b === 0 ? "0" : `${a} + ${b}`))]),
  ];
}

/** 1 where the line of a growing step ends, which is not accepted yet. @param {Now} now @param {number} curve @param {number} vertex */
function ownEnd({ scene: { phase, chosen } }, curve, vertex) {
  if (phase !== "growth" || !chosen) return 0;
  return (curve === 0 ? chosen.from : chosen.to) === vertex ? 1 : 0;
}
