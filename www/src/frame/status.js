/**
 * The status line: what the result is worth, and what to do where it fails.
 *
 * @import { App } from "../state/app.js"
 * @import { Match } from "../types.js"
 */
import { commandText, runCommand } from "../commands.js";
import { find, h } from "../dom.js";
import { fixed, milliseconds } from "../format.js";
import { icon, symbol } from "../icons.js";
import { numberNode } from "../number-node.js";
import { advice, explain } from "../explain.js";
import { command, item, label, strong } from "./status-parts.js";
import { patch } from "../state/edits.js";
import { spanName } from "../state/app.js";
import { keptGaps, shownTotals } from "../state/lines.js";
import { isHarmonic, lookedAt } from "../state/look.js";
import { strings } from "../strings.js";

/** @param {App} app */
export function createStatus(app) {
  const element = find("#status");
  let drawn = "";
  /** What is said of harmonic blends, once there is one. @type {typeof import("../harmonic/status.js") | null} */
  let flow = null;

  return {
    render() {
      const { match, matched, problem, ms, slow } = app.results.value;
      const { mode, note, drawing } = app.ui.value;
      if (mode !== "figure") {
        drawn = "";
        return;
      }
      const fresh = matched === lookedAt(app);
      const isFlow = isHarmonic(lookedAt(app)) || match?.diagnostics.some(({ code }) => code === "several-inner");
      if (isFlow && !flow) {
        void import("../harmonic/status.js").then((module) => {
          flow = module;
          drawn = "";
          this.render();
        });
      }
      const own = isFlow ? flow : null;
      const numbers = own && (match?.harmonic || isHarmonic(lookedAt(app))) ? own : null;
      const key = JSON.stringify([own && match?.harmonic, app.store.document.curves.map(({ name }) => name), match?.totals, match?.ok, match?.gap, match?.coarse, match?.diagnostics, problem, fresh ? ms : 0, slow, note, drawing, app.store.document.curves.length]);
      if (key === drawn) return;
      drawn = key;
      const focused = document.activeElement?.getAttribute("data-certificate");
      const left = problem
        ? [reason(explain(app.store.document, problem))]
        : match
          ? isIncomplete(match)
            ? [strong(strings.incomplete.verdict[app.store.document.curves.length] ?? "")]
            : (numbers?.certificates ?? certificates)(app, match, ms)
          : [label(strings.status.loading)];
      element.replaceChildren(
        h("div", { class: "certificates" }, ...left),
        h("div", { class: note?.tone === "error" ? "remark told" : "remark" }, ...remark(app, match, slow, own)),
      );
      element.dataset.verdict = problem
        ? "error"
        : match
          ? isIncomplete(match)
            ? "incomplete"
            : match.ok && (numbers?.failures ?? failures)(match) === 0
            ? "verified"
            : "problems"
          : "none";
      if (focused)
        /** @type {HTMLElement | null} */ (element.querySelector(`[data-certificate="${focused}"]`))?.focus();
    },
  };
}

/** Whether the document is still being drawn. @param {Match} match */
const isIncomplete = (match) => match.diagnostics.some(({ code }) => code === "incomplete");

/** @param {Match} match */
function failures(match) {
  const totals = shownTotals(match);
  if (!totals) return 1;
  const { crossings, blocked, uncovered } = totals;
  // Occluded lines go to vertices that no other line covers.
  const bare = Math.max(uncovered[0].length + uncovered[1].length, occluded(match));
  return crossings + blocked + bare + keptGaps(match).length;
}

/** Lines added by the policy `repair`. @param {Match} match */
const occluded = ({ diagnostics }) => diagnostics.find(({ code }) => code === "occluded")?.lines?.length ?? 0;

/**
 * @param {App} app
 * @param {Match} match
 * @param {number | null} ms
 * @returns {Node[]}
 */
function certificates(app, match, ms) {
  const totals = shownTotals(match);
  const words = strings.status;
  const count = Math.max(failures(match), match.ok ? 0 : 1);
  const gaps = keptGaps(match).length;
  const corners = match.diagnostics.filter(({ code }) => code === "corner").length;
  if (!totals) return [h("span", { class: "verdict failed" }, words.problems(count))];
  const [a, b] = totals.uncovered;
  const open = a.length + b.length > 0;
  const verdict =
    count === 0
      ? h("span", { class: "verdict" }, /** @type {any} */ (icon("check")), strong(words.verified))
      : h("span", { class: "verdict failed" }, words.problems(count));
  return [
    verdict,
    item("lines", strong(String(totals.count)), label(words.lines(totals.count))),
    totals.mean !== null ? item("mean", label(words.mean), symbol("f"), strong(numberNode(totals.mean))) : null,
    totals.integral !== null ? item("integral", symbol("J"), strong(numberNode(totals.integral))) : null,
    totals.eta !== null ? item("eta", symbol("η"), strong(fixed(totals.eta, 3)), ...(totals.span === undefined ? [] : [label(spanName(totals.span))])) : null,
    failure(app, "crossings", words.crossings, totals.crossings, String(totals.crossings)),
    failure(app, "blocked", words.blocked, totals.blocked, String(totals.blocked)),
    failure(app, "uncovered", words.uncovered, a.length + b.length, open ? `${a.length} + ${b.length}` : "0"),
    gaps > 0 ? failure(app, "gaps", words.gaps, gaps, String(gaps)) : null,
    occluded(match) > 0 ? failure(app, "occluded", words.occluded, occluded(match), String(occluded(match))) : null,
    corners > 0 ? showing("corners", words.corners(corners), String(corners), "", async () => (await import("../stage/corners.js")).nextCorner(app)) : null,
    ms === null ? null : item("ms", strong(milliseconds(ms)), label(words.ms)),
  ].filter((node) => node !== null);
}

/**
 * A count that should be zero: plain when it is, a button that shows the place when it is not.
 * @param {App} app
 * @param {keyof typeof import("../witness.js").CODES} name
 * @param {string} words
 * @param {number} count
 * @param {string} shown
 */
function failure(app, name, words, count, shown) {
  if (count === 0) return item(name, label(words), strong(shown));
  return showing(name, words, shown, "failed", async () => (await import("../witness.js")).nextWitness(app, name));
}

/**
 * A count whose button goes to the next place.
 * @param {string} name
 * @param {string} words
 * @param {string} shown
 * @param {string} look
 * @param {() => void} onclick
 */
function showing(name, words, shown, look, onclick) {
  const what = `${words} ${shown}`;
  const button = h(
    "button",
    {
      type: "button",
      class: look,
      "data-certificate": name,
      "aria-label": strings.status.show(what),
      title: strings.status.show(what),
      onclick,
    },
    label(words),
    " ",
    strong(shown),
  );
  return h("span", { class: "item", "data-total": name }, button);
}

/**
 * @param {App} app
 * @param {Match | null} match
 * @param {boolean} slow
 * @param {typeof import("../harmonic/status.js") | null} flow
 * @returns {Node[]}
 */
function remark(app, match, slow, flow) {
  const words = strings.status;
  const { note } = app.ui.value;
  if (slow) return [label(words.working), command("cancel", words.cancel, app.cancel)];
  if (note?.tone === "error") {
    const again = note.text === strings.errors.trap ? [command("retry", words.tryAgain, app.retry)] : [];
    return [reason(note.text), ...again];
  }
  if (note) return [label(note.text), ...(note.command ? [command(note.command.name, note.command.text, note.command.act)] : [])];
  if (!match) return [];
  if (isIncomplete(match)) {
    const text = label(strings.incomplete.reason[app.store.document.curves.length] ?? "");
    if (app.ui.value.drawing) return [text];
    return [text, command("draw", commandText(app, "draw"), () => void runCommand(app, "draw"))];
  }
  const more = flow?.remark(app, match);
  if (more) return more;
  if (match.harmonic) return match.coarse ? [label(words.refining)] : [];
  const text = advice(match);
  const { matching } = app.store.document;
  if (text) {
    const helps = matching.policy !== "repair" && REPAIRABLE.includes(matching.method) && match.diagnostics.some(({ code }) => REPAIRED.includes(code));
    return [reason(text), ...(helps ? [command("repair", words.repair, () => repair(app))] : [])];
  }
  if (match.coarse) return [label(words.refining)];
  const { gap } = match;
  const shown = gap === null ? null : gapText(gap);
  if (matching.method !== "exact") {
    const isBaseline = matching.method === "shift" || matching.method === "parameter";
    return [h("span", { class: "warning", "data-gap": "" }, words.rated(isBaseline, shown))];
  }
  return shown === null ? [] : [h("span", { "data-gap": "" }, label(words.gap), " ", strong(shown))];
}

/** Methods that keep to the policy `repair`, and what it repairs. */
const REPAIRABLE = ["exact", "greedy"];
const REPAIRED = ["orphan", "jammed", "stuck", "solvable"];

/** Lets occluded lines reach what no other line does. @param {App} app */
function repair(app) {
  app.store.commit({ change: (document) => patch(document, "matching", { policy: "repair" }) });
}

/** A gap in per cent, to a tenth; lines off the samples may lie above the optimum between these. @param {number} gap */
function gapText(gap) {
  return gap < 5e-4 ? "0" : `${fixed(gap * 100, 1)}\u00a0%`;
}


/** @param {string} text */
const reason = (text) => h("span", { class: "failed reason", "data-reason": "", title: text }, text);
