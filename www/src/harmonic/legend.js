/**
 * The legend of the difference between two blends: a bar from nothing to the largest difference, with the mean, once the picture rests.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument } from "../types.js"
 * @import { Harmonic } from "../../../js/directrix.js"
 */
import "../../styles/harmonic.css";
import { find, h } from "../dom.js";
import { fixed } from "../format.js";
import { currentMatch } from "../state/app.js";
import { Lane } from "../state/lane.js";
import { lookedAt } from "../state/look.js";
import { lookOf } from "./look.js";
import { words } from "./words.js";

/** Differences that are known, by document. @type {WeakMap<CurvesDocument, string>} */
const told = new WeakMap();

/** How far both blends of the document that is looked at are apart, in words; empty until it is known. @param {App} app */
export const differenceText = (app) => (lookOf(app) === "difference" && told.get(lookedAt(app))) || "";

/** @param {App} app */
export function createDifferenceLegend(app) {
  const element = h("div", { class: "legend", "data-legend": "difference", hidden: true });
  find("#legend").after(element);
  /** @type {CurvesDocument | null} */
  let asked = null;
  /** @type {{document: CurvesDocument, found: Harmonic} | null} */
  let known = null;
  let drawn = "";

  /** @type {Lane<CurvesDocument, Harmonic>} */
  const lane = new Lane({
    work: (document, signal) => app.kernel.harmonic(document, { difference: true }, { signal }),
    done: (found, document) => {
      known = { document, found };
      const { difference } = found;
      told.set(document, difference ? `${words.difference}: ${numbers(difference)}` : words.noRuled);
      // All that shows it is drawn again.
      app.ui.set({ layers: [...app.ui.value.layers] });
      render();
      app.say(differenceText(app));
    },
    // The status line says what is wrong with the document.
    failed: () => {},
  });

  function render() {
    const document = lookedAt(app);
    const match = currentMatch(app);
    element.hidden = lookOf(app) !== "difference" || !match?.ok;
    if (element.hidden) return;
    if (asked !== document && !match?.coarse && !app.store.running) {
      asked = document;
      lane.push(document);
    }
    const difference = known?.found.difference ?? null;
    const isMissing = known?.document === document && !difference;
    const key = JSON.stringify([difference, isMissing]);
    if (key === drawn) return;
    drawn = key;
    element.replaceChildren(...(isMissing ? [h("span", { class: "difference-none" }, words.noRuled)] : bar(difference)));
  }

  return { render };
}

/** @param {import("../../../js/directrix.js").HarmonicDifference} difference */
const numbers = ({ largest, mean }) => words.differenceNumbers(fixed(largest, 3), fixed(mean, 3));

/** @param {import("../../../js/directrix.js").HarmonicDifference | null} difference */
function bar(difference) {
  const row = (/** @type {string} */ kind, /** @type {Node} */ middle, label = "") =>
    h("div", { class: `legend-row ${kind}` }, h("span", {}, label), middle, h("span", {}));
  const ticks = difference ? ["0", fixed(difference.largest, 3)] : ["0", ""];
  return [
    row("", h("span", { class: "legend-bar viridis" }), words.difference),
    row("legend-ticks number", h("span", { class: "legend-scale" }, ...ticks.map((tick) => h("span", {}, tick)))),
    row("number", h("span", { "data-mean": "" }, difference ? words.mean(fixed(difference.mean, 3)) : "")),
  ];
}
