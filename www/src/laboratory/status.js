/**
 * The status line of a problem: whether it is solved, and what certifies the solution.
 *
 * @import { Face } from "./face.js"
 * @import { Bench, Known } from "./state.js"
 */
import { h } from "../dom.js";
import { fixed, milliseconds } from "../format.js";
import { command, item, label, strong } from "../frame/status-parts.js";
import { icon } from "../icons.js";
import { fillStatus } from "../modes/status-line.js";
import { numberText } from "../space/measure.js";
import { strings } from "../strings.js";
import { solverOf } from "./edits.js";
import { words } from "./words.js";

/** Below this a share of the flux counts as rounding. */
const SPREAD = 1e-6;

/** What keeps a problem from being solved. @param {Known} known */
export const faultsOf = ({ boundary }) => boundary.diagnostics.filter(({ remark }) => !remark);

/**
 * What is said of a boundary, after the name of the group that it is about where the message has none.
 * @param {Known["boundary"]["diagnostics"][number]} diagnostic
 * @param {readonly {name: string}[]} groups
 */
export function diagnosticText({ code, path, message }, groups) {
  const [, index, rest] = /^(?:groups\[(\d+)\]|(rest)\b)/.exec(path) ?? [];
  const name = rest ? words.boundary.rest : groups[Number(index ?? -1)]?.name;
  return name && code !== "conflict" ? words.boundary.about(name, message) : message;
}

/** A fault in a few words. @param {ReturnType<typeof faultsOf>[number]} fault @param {Known} known */
const faultText = (fault, { document }) => (words.faults[fault.code] && fault.count ? words.faults[fault.code](fault.count) : diagnosticText(fault, document.groups));

/** The last entry of the largest list of residuals. @param {readonly ArrayLike<number>[]} residuals */
const lastOf = (residuals) => Math.max(0, ...residuals.map((list) => list[list.length - 1] ?? 0));

/**
 * @param {Bench} bench
 * @param {HTMLElement} element
 * @param {{reason: string | null, face: Face | null, cancel: () => void, retry: () => void, show: (place: readonly number[]) => void}} acts `reason`: why the document cannot be read
 */
export function renderStatus(bench, element, { reason, face, cancel, retry, show }) {
  const { known, isCurrent } = bench.now();
  const faults = known && isCurrent ? faultsOf(known) : [];
  const solution = known && isCurrent ? known.solution : null;
  const unsolved = known && isCurrent ? known.unsolved : null;
  const verdict = reason !== null || unsolved !== null ? "error" : faults.length > 0 ? "problems" : !solution ? "none" : solution.converged ? "verified" : "problems";
  const left =
    reason !== null || unsolved !== null
      ? [h("span", { class: "failed reason", "data-reason": "" }, reason ?? unsolved ?? "")]
      : faults.length > 0
        ? [...faults.slice(0, 2).map(problemOf), count()]
        : solution
          ? [
              solution.converged
                ? h("span", { class: "verdict" }, /** @type {any} */ (icon("check")), h("span", { class: "strong" }, words.status.verified))
                : h("span", { class: "item verdict failed" }, words.status.notConverged(Math.max(...solution.iterations))),
              count(),
              known && solverOf(known.document).method === "gmres" ? item("iterations", strong(solution.iterations.join(" + ")), label(words.status.iterations)) : item("iterations", label(words.status.lu)),
              item("residual", label(words.status.residual), strong(numberText(lastOf(solution.residuals)))),
              item("closure", label(words.status.closure), strong(numberText(solution.closure))),
              item("balance", label(words.status.balance), strong(numberText(Math.max(...solution.fluxBalance.map(Math.abs))))),
              face && item("clamped", label(words.status.clamped), strong(fixed(face.clamped, 0))),
              known?.accuracy && item("error", label(words.status.error), strong(numberText(known.accuracy.error))),
              item("ms", strong(milliseconds(solution.times.assembly + solution.times.solve)), label(words.status.ms)),
            ].filter((node) => node !== null && node !== undefined)
          : [label(words.loading), ...(known ? [count()] : [])];
  fillStatus(element, verdict, /** @type {Node[]} */ (left), remark());

  function count() {
    const elements = known?.mesh.count ?? 0;
    return item("elements", strong(fixed(elements, 0)), label(words.status.elements(elements, known?.boundary.dimension ?? 3)));
  }

  /** @param {ReturnType<typeof faultsOf>[number]} fault */
  function problemOf(fault) {
    const { code, place } = fault;
    const text = faultText(fault, /** @type {Known} */ (known));
    if (!place) return h("span", { class: "item verdict failed" }, text);
    return h("span", { class: "item verdict failed" }, h("button", { type: "button", class: "failed", title: words.status.show, "data-problem": code, onclick: () => show(place) }, text));
  }

  /** @returns {(Node | null)[]} */
  function remark() {
    const { note } = bench.app.ui.value;
    if (bench.app.results.value.slow) return [...(solution ? [label(words.loading)] : []), command("cancel", words.cancel, cancel)];
    if (note?.tone === "error") return [h("span", { class: "failed reason" }, note.text), note.text === strings.errors.trap ? command("retry", words.tryAgain, retry) : null];
    if (note) return [label(note.text), note.text === words.cancelled ? command("retry", words.tryAgain, retry) : null];
    return [solution && solution.imbalance > SPREAD ? h("span", { class: "warning" }, words.status.imbalance(numberText(solution.imbalance))) : null];
  }
}

/** A problem in words. @param {Bench} bench */
export function summaryOf(bench) {
  const { known, isCurrent } = bench.now();
  if (!known || !isCurrent) return words.loading;
  const faults = faultsOf(known);
  const { solution, accuracy, boundary, mesh } = known;
  return words.spoken.summary([
    (boundary.dimension === 2 ? words.kinds.plane : words.kinds.space)[0],
    `${fixed(mesh.count, 0)} ${words.status.elements(mesh.count, boundary.dimension)}`,
    ...faults.slice(0, 2).map((fault) => faultText(fault, known)),
    ...(known.unsolved ? [known.unsolved] : []),
    ...(solution ? [solution.converged ? words.status.verified : words.status.notConverged(Math.max(...solution.iterations)), `${words.status.residual} ${numberText(lastOf(solution.residuals))}`] : []),
    ...(accuracy ? [`${words.status.error} ${numberText(accuracy.error)}`] : []),
  ]);
}
