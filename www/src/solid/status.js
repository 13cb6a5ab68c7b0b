/**
 * The status line of the solid: whether it is closed, and its measures.
 *
 * @import { App } from "../state/app.js"
 * @import { Whole } from "./state.js"
 *
 * @typedef {object} Known What is known of the open document's solid.
 * @property {Whole | null} solid
 * @property {{twist: number | null, flank: number | null}} worst degrees
 * @property {number | null} ms
 * @property {string | null} reason what keeps the kernel from making one
 * @property {string | null} lack what the document needs before there can be one
 */
import { h } from "../dom.js";
import { fixed, length, milliseconds } from "../format.js";
import { command, item, label, strong } from "../frame/status-parts.js";
import { icon } from "../icons.js";
import { fillStatus } from "../modes/status-line.js";
import { measure } from "../space/measure.js";
import { strings } from "../strings.js";
import { words } from "./words.js";

/**
 * @param {App} app
 * @param {HTMLElement} element
 * @param {Known & {cancel: () => void, retry: () => void, isClosed: boolean}} shown
 */
export function renderStatus(app, element, { solid, worst, ms, reason, lack, cancel, retry, isClosed }) {
  const { unit } = app.store.document;
  const verdict = reason !== null ? "error" : lack !== null ? "incomplete" : !solid ? "none" : solid.watertight ? "verified" : isClosed ? "problems" : "open";
  const left = solid
    ? [
        verdictOf(verdict),
        item("triangles", strong(fixed(solid.indices.length / 3, 0)), label(words.status.triangles(solid.indices.length / 3))),
        item("size", label(words.status.size), strong(words.body.phrase(sidesOf(solid), unit))),
        solid.volume === null ? null : item("volume", label(words.status.volume), strong(measure(solid.volume, unit, 3))),
        item("area", label(words.status.area), strong(measure(solid.area, unit, 2))),
        ...angles(worst),
        ms === null ? null : item("ms", strong(milliseconds(ms)), label(words.status.ms)),
      ].filter((node) => node !== null)
    : [reason !== null ? h("span", { class: "failed reason" }, reason) : label(lack ?? words.loading)];
  fillStatus(element, verdict, left, remark(app, solid, cancel, retry));
}

/** The three sides of the box. @param {Pick<Whole, "bounds">} solid */
export const sidesOf = ({ bounds: { min, max } }) => [0, 1, 2].map((axis) => fixed(max[axis] - min[axis], 1));

/** @param {string} verdict */
function verdictOf(verdict) {
  if (verdict === "problems") return h("span", { class: "verdict failed" }, words.status.leaks);
  if (verdict === "open") return label(words.status.open);
  return h("span", { class: "verdict" }, /** @type {any} */ (icon("check")), h("span", { class: "strong" }, words.status.watertight));
}

/** @param {Known["worst"]} worst */
function angles(worst) {
  return /** @type {const} */ (["twist", "flank"]).map((name) => {
    const degrees = worst[name];
    return degrees === null ? null : item(name, label(words.status[name]), strong(`${fixed(degrees, 1)}°`));
  });
}

/**
 * @param {App} app
 * @param {Whole | null} solid
 * @param {() => void} cancel
 * @param {() => void} retry
 * @returns {(Node | null)[]}
 */
function remark(app, solid, cancel, retry) {
  const { note } = app.ui.value;
  if (app.results.value.slow) return [label(words.working), command("cancel", words.cancel, cancel)];
  if (note?.tone === "error") {
    const again = note.text === strings.errors.trap ? command("retry", words.tryAgain, retry) : null;
    return [h("span", { class: "failed reason" }, note.text), again];
  }
  if (note) return [label(note.text)];
  const projection = solid?.projection ?? null;
  return [projection ? h("span", { class: "warning" }, words.status.projected(length(projection.deviation, app.store.document.unit))) : null];
}
