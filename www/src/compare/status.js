/**
 * The status line of the comparison: how many methods, on what, the best one, and how many fail.
 *
 * @import { App } from "../state/app.js"
 * @import { Result } from "./runner.js"
 */
import { h } from "../dom.js";
import { explain } from "../explain.js";
import { editable, fixed, milliseconds } from "../format.js";
import { command, item, label, strong } from "../frame/status-parts.js";
import { symbol } from "../icons.js";
import { words as sampling } from "../inspector/sampling-words.js";
import { fillStatus } from "../modes/status-line.js";
import { strings } from "../strings.js";
import { bestOf, faultsOf, median, METHODS } from "./methods.js";
import { words } from "./words.js";

/**
 * @param {App} app
 * @param {HTMLElement} element
 * @param {{results: (Result | null)[], cancel: () => void, retry: () => void}} shown
 */
export function renderStatus(app, element, { results, cancel, retry }) {
  const { document } = app.store;
  if (document.curves.length < 2) {
    fillStatus(element, "incomplete", [strong(strings.incomplete.verdict[document.curves.length] ?? "")], remark(app, null, cancel, retry));
    return;
  }
  const done = results.filter((result) => result !== null);
  const rated = results.map((result) =>
    result?.match ? { feasible: faultsOf(result.match).feasible, eta: result.quality.eta } : null,
  );
  const whole = done.length === METHODS.length;
  const failing = rated.filter((each) => !each?.feasible).length;
  const refused = done.find(({ match }) => match === null)?.problem ?? null;
  const left = refused
    ? [h("span", { class: "failed reason" }, explain(document, refused))]
    : [
        item("methods", strong(String(METHODS.length)), label(words.methodCount(METHODS.length).text)),
        item("sampling", label(words.sampling), strong(samples(app, done))),
        item("weights", label(words.weights), strong(weights(app))),
        whole ? best(rated) : app.ui.value.note ? null : label(strings.status.loading),
        whole ? item("ms", strong(milliseconds(done.reduce((sum, { times }) => sum + (median(times) ?? 0), 0))), label(words.inAll)) : null,
      ].filter((node) => node !== null);
  const verdict = !whole ? "none" : refused ? "error" : failing > 0 ? "problems" : "verified";
  const note = whole && !refused ? label(words.failing(failing, METHODS.length)) : null;
  fillStatus(element, verdict, left, remark(app, note, cancel, retry));
}

/** @param {App} app @param {Result[]} done */
function samples({ store }, done) {
  // The rotations take the larger number on both curves, the others the document's own.
  const taken = done.at(-1)?.match?.samples ?? [];
  return sampling.taken(store.document.sampling.counts.map((count, k) => taken[k]?.points.length ?? count));
}

/** @param {App} app */
function weights({ store }) {
  const { normalWeight, distanceWeight } = store.document.matching;
  return `${editable(normalWeight, 0)}, ${editable(distanceWeight, 0)}`;
}

/** @param {({feasible: boolean, eta: number | null} | null)[]} rated */
function best(rated) {
  const i = bestOf(rated);
  if (i < 0) return item("best", label(words.noneFeasible));
  const { name } = words.methods[METHODS[i].name];
  return item("best", label(words.best), symbol("η"), h("span", {}, strong(fixed(rated[i]?.eta ?? 0, 3)), `, ${name}`));
}

/**
 * @param {App} app
 * @param {Node | null} note
 * @param {() => void} cancel
 * @param {() => void} retry
 * @returns {(Node | null)[]}
 */
function remark(app, note, cancel, retry) {
  const said = app.ui.value.note;
  if (app.results.value.slow) return [label(strings.status.working), command("cancel", strings.status.cancel, cancel)];
  if (said?.tone === "error") {
    const again = said.text === strings.errors.trap ? command("retry", strings.status.tryAgain, retry) : null;
    return [h("span", { class: "failed reason" }, said.text), again];
  }
  return [said ? label(said.text) : note];
}
