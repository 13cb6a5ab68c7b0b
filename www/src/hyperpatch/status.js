/**
 * The status line of a body: the verdict on the whole, and its measures. While checks run it says so and gives no verdict.
 *
 * @import { App } from "../state/app.js"
 * @import { Known } from "./runner.js"
 *
 * @typedef {"checking" | "verified" | "certified" | "problems"} Outcome
 */
import { h } from "../dom.js";
import { fixed, milliseconds, significantText } from "../format.js";
import { command, item, label, strong } from "../frame/status-parts.js";
import { icon, symbol } from "../icons.js";
import { fillStatus } from "../modes/status-line.js";
import { measure } from "../space/measure.js";
import { strings } from "../strings.js";
import { leastOf } from "./colors.js";
import { bodyOf } from "./document.js";
import { words } from "./words.js";

/**
 * What is wrong with a body, and its verdict. What the certificates have shown counts at once; that nothing is wrong is only said when
 * every check has run to its end.
 * @param {Pick<Known, "verdicts" | "summary">} known
 * @returns {{outcome: Outcome, problems: {text: string, cell: number}[], remarks: string[]}}
 */
export function judged({ verdicts, summary }) {
  const of = (/** @type {string} */ name) => verdicts.filter(({ verdict }) => verdict === name);
  const [invalid, degenerate, open] = ["invalid", "degenerate", "locally-valid"].map(of);
  const pairs = summary?.pairs ?? [];
  const are = (/** @type {string} */ name) => pairs.filter(({ relation }) => relation === name);
  const [overlaps, touches, unproven] = ["overlaps", "touches", "not-proven"].map(are);
  const problems = [
    ...(invalid.length ? [{ text: words.status.invalid(invalid.length), cell: invalid[0].cell }] : []),
    ...(degenerate.length ? [{ text: words.status.degenerate(degenerate.length), cell: degenerate[0].cell }] : []),
    ...(overlaps.length ? [{ text: words.status.overlap(overlaps.length), cell: overlaps[0].cells[0] }] : []),
  ];
  const mirrored = verdicts.filter((verdict) => verdict.mirrored).length;
  const remarks = [
    ...(summary && open.length ? [words.status.unprovenCells(open.length)] : []),
    ...(unproven.length ? [words.status.unproven(unproven.length)] : []),
    ...(touches.length ? [words.status.touches(touches.length)] : []),
    ...(mirrored ? [words.status.mirrored(mirrored)] : []),
  ];
  const isOpen = open.length > 0 || unproven.length > 0;
  const outcome = problems.length > 0 ? "problems" : !summary ? "checking" : isOpen ? "certified" : "verified";
  return { outcome, problems, remarks };
}

/** A body in words. @param {App} app @param {Known} known */
export function summaryOf(app, known) {
  const { outcome, problems, remarks } = judged(known);
  const verdict = { checking: words.status.checking, verified: words.status.verified, certified: words.status.valid, problems: problems.map(({ text }) => text).join(", ") }[outcome];
  const least = leastOf(known);
  return words.spoken.summary([
    verdict,
    words.cells.phrase(known.cells.length),
    ...(least === null ? [] : [`${words.cells.jacobian} ${fixed(least, 2)} ${words.cells.ofMean}`]),
    `${words.status.volume} ${measure(known.volume, bodyOf(app).unit, 3)}`,
    ...remarks,
  ]);
}

/**
 * @param {App} app
 * @param {HTMLElement} element
 * @param {{known: Known | null, isCurrent: boolean, reason: string | null, cancel: () => void, retry: () => void, show: (cell: number) => void}} shown
 */
export function renderStatus(app, element, { known, isCurrent, reason, cancel, retry, show }) {
  const { unit } = bodyOf(app);
  const fact = known && isCurrent ? judged(known) : null;
  const verdict = reason !== null ? "error" : (fact?.outcome ?? "none");
  const least = known && leastOf(known);
  const { summary = null } = known ?? {};
  const left =
    reason !== null
      ? [h("span", { class: "failed reason", "data-reason": "" }, reason)]
      : known && fact
        ? [
            ...verdictOf(fact, show),
            item("cells", strong(String(known.cells.length)), label(words.status.cells(known.cells.length))),
            summary && item("shared", label(words.status.shared), strong(String(summary.sharedFaces))),
            summary && item("overlaps", label(words.status.overlaps), strong(String(summary.pairs.filter(({ relation }) => relation === "overlaps").length))),
            least === null ? null : item("jacobian", label(words.status.least), /** @type {any} */ (symbol("J")), strong(fixed(least, 2)), label(words.cells.ofMean)),
            item("volume", label(words.status.volume), strong(measure(known.volume, unit, 3))),
            summary && item("sum", label(words.status.sum), strong(summary.sumError < 1e-9 ? "1" : `1 ± ${significantText(summary.sumError)}`)),
            item("ms", strong(milliseconds(known.ms)), label(words.status.ms)),
          ].filter((node) => node !== null)
        : [label(words.loading)];
  fillStatus(element, verdict, left, remark(app, fact, cancel, retry));
}

/** @param {ReturnType<typeof judged>} fact @param {(cell: number) => void} show */
function verdictOf({ outcome, problems }, show) {
  if (outcome === "problems") {
    return problems.map(({ text, cell }) =>
      h("span", { class: "item verdict failed" }, h("button", { type: "button", class: "failed", title: words.status.show, "data-problem": String(cell), onclick: () => show(cell) }, text)),
    );
  }
  if (outcome === "checking") return [h("span", { class: "verdict", "data-checking": "" }, words.status.checking)];
  if (outcome === "certified") return [h("span", { class: "verdict" }, words.status.valid)];
  return [h("span", { class: "verdict" }, /** @type {any} */ (icon("check")), h("span", { class: "strong" }, words.status.verified))];
}

/**
 * @param {App} app
 * @param {ReturnType<typeof judged> | null} fact
 * @param {() => void} cancel
 * @param {() => void} retry
 * @returns {(Node | null)[]}
 */
function remark(app, fact, cancel, retry) {
  const { note } = app.ui.value;
  if (app.results.value.slow) return [label(words.loading), command("cancel", words.cancel, cancel)];
  if (note?.tone === "error") {
    const again = note.text === strings.errors.trap ? command("retry", words.tryAgain, retry) : null;
    return [h("span", { class: "failed reason" }, note.text), again];
  }
  if (note) return [label(note.text), note.text === words.cancelled ? command("retry", words.checkAgain, retry) : null];
  return [fact?.outcome === "checking" ? command("cancel", words.cancel, cancel) : null, ...(fact?.remarks.map((text) => h("span", { class: "warning" }, text)) ?? [])];
}
