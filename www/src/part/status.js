/**
 * The status line of a part: what was evaluated, and whether it holds what it promises.
 *
 * @import { Bench } from "./state.js"
 */
import { h } from "../dom.js";
import { fixed, milliseconds, percent, significantText } from "../format.js";
import { command, item, label, strong } from "../frame/status-parts.js";
import { icon } from "../icons.js";
import { fillStatus } from "../modes/status-line.js";
import { measure } from "../space/measure.js";
import { strings } from "../strings.js";
import { choiceOf, faultsOf, isOne } from "./problems.js";
import { words } from "./words.js";

/**
 * @param {Bench} bench
 * @param {HTMLElement} element
 * @param {{reason: string | null, cancel: () => void, retry: () => void}} acts `reason`: why the part cannot be evaluated
 */
export function renderStatus(bench, element, { reason, cancel, retry }) {
  const { document, known, isCurrent } = bench.now();
  const { unit = "mm" } = document;
  const measured = known?.measured ?? null;
  // What an edit has overtaken has measures, and no verdict.
  const faults = known && isCurrent ? faultsOf(known) : null;
  const count = faults ? faults.skipped.length + faults.broken.length + (faults.isMixed ? 0 : 1) : 0;
  const verdict = reason !== null ? "error" : !faults ? "none" : count > 0 ? "problems" : "verified";
  // Of no pixel at all nothing is verified.
  const tried = measured?.pixels ? measured : null;
  const left =
    reason !== null
      ? [h("span", { class: "failed reason", "data-reason": "" }, reason)]
      : known
        ? [
            ...(faults && count > 0 ? problems(faults) : faults && measured && !tried ? [h("span", { class: "strong" }, words.status.nothing)] : faults && measured ? [h("span", { class: "verdict" }, /** @type {any} */ (icon("check")), h("span", { class: "strong" }, words.status.verified))] : []),
            item("pixels", strong(fixed(known.raster.size[0] * known.raster.size[1], 0)), label(words.status.pixels)),
            measured && item("area", label(words.status.area), strong(measure(measured.area, unit, 2))),
            tried && item("sum", label(words.status.sum), strong(isOne(tried.sumError) ? "1" : `1 ± ${significantText(tried.sumError)}`)),
            tried && item("clamped", label(words.status.clamped), strong(fixed(tried.clamped, 0))),
            tried && faults && item("violations", label(words.status.violations), strong(fixed(faults.broken.length, 0))),
            item("ms", strong(milliseconds(known.ms)), label(words.status.ms)),
          ].filter((node) => node !== null)
        : [label(words.loading)];
  fillStatus(element, verdict, left, remark());

  /** @param {ReturnType<typeof faultsOf>} found */
  function problems({ skipped, broken, isMixed }) {
    const button = (/** @type {string} */ text, /** @type {string} */ name, /** @type {() => void} */ act) =>
      h("span", { class: "item verdict failed" }, h("button", { type: "button", class: "failed", title: words.status.show, "data-problem": name, onclick: act }, text));
    return [
      ...(skipped.length > 0 ? [button(words.status.skipped(skipped.length), "skipped", () => bench.change(choiceOf(document, skipped[0])))] : []),
      ...(broken.length > 0 ? [button(words.status.broken(broken.length, broken[0].name), "rule", () => bench.change({ rule: broken[0].rule, violations: true, leaves: false }))] : []),
      ...(isMixed ? [] : [h("span", { class: "item verdict failed" }, words.status.unmixed)]),
    ];
  }

  /** @returns {(Node | null)[]} */
  function remark() {
    const { note } = bench.app.ui.value;
    if (bench.app.results.value.slow) return [label(words.loading), command("cancel", words.cancel, cancel)];
    if (note?.tone === "error") return [h("span", { class: "failed reason" }, note.text), note.text === strings.errors.trap ? command("retry", words.tryAgain, retry) : null];
    if (note) return [label(note.text), note.text === words.cancelled ? command("retry", words.tryAgain, retry) : null];
    return [measured && isCurrent && measured.overlap > 0 ? h("span", { "data-overlap": "" }, words.status.overlap(percent(measured.overlap))) : null];
  }
}

/** A part in words. @param {Bench} bench */
export function summaryOf(bench) {
  const { document, known, isCurrent } = bench.now();
  if (!known || !isCurrent) return words.loading;
  const { skipped, broken } = faultsOf(known);
  const { measured } = known;
  return words.card.spoken([
    words.summary.bodies(document.bodies.length),
    ...(measured ? [`${words.status.area} ${measure(measured.area, document.unit ?? "mm", 2)}`] : []),
    ...(skipped.length > 0 ? [words.status.skipped(skipped.length)] : []),
    ...(broken.length > 0 ? [words.status.broken(broken.length, broken[0].name)] : []),
  ]);
}
