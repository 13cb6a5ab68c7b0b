/**
 * What the canvas is for: the figure to edit, or another look at the same document. A switch at the upper left of the
 * canvas goes from one to the other.
 *
 * @import { App } from "../state/app.js"
 *
 * @typedef {object} Place Where a mode other than the figure stands; emptied when it is left.
 * @property {HTMLElement} stage over the canvas, below the switch
 * @property {HTMLElement} aside in the inspector, in place of its groups
 * @property {HTMLElement} status the status line, which is the mode's own as long as it is on
 *
 * @typedef {object} View
 * @property {() => void} render
 * @property {() => void} close gives up running work
 *
 * @typedef {object} Mode
 * @property {App["ui"]["value"]["mode"]} name
 * @property {string} text
 * @property {() => Promise<(app: App, place: Place) => View>} [load] none for the figure itself
 */
import "../../styles/modes.css";
import { segment } from "../controls/choices.js";
import { find, h } from "../dom.js";
import { problem } from "../painter.js";
import { isHarmonic } from "../state/look.js";
import { isCurves } from "../state/kind.js";
import { words } from "./words.js";

/** @type {readonly Mode[]} */
const MODES = [
  { name: "figure", text: words.figure },
  { name: "steps", text: words.steps, load: async () => (await import("../steps/steps.js")).createSteps },
  {
    name: "compare",
    text: words.compare,
    load: async () => (await import("../compare/compare.js")).createCompare,
  },
  { name: "solid", text: words.solid, load: async () => (await import("../solid/solid.js")).createSolid },
];

/** @param {App} app */
export function createModes(app) {
  const { ui } = app;
  const stage = h("div", { class: "mode-stage", "data-furniture": "" });
  const aside = h("div", { class: "mode-aside" });
  const control = segment(
    { label: words.region, name: "mode", choices: MODES.map(({ name, text }) => ({ value: name, text })) },
    (mode) => ui.set({ mode }),
  );
  const element = h("div", { class: "modes", "data-furniture": "" }, control.element);
  // The switch comes before all else on the canvas for who goes by Tab.
  find("#stage").prepend(element, stage);
  find("#inspector").append(aside);

  let shown = "figure";
  /** Whether what is shown says why the mode is not to be had. */
  let refuses = false;
  /** @type {View | null} */
  let view = null;

  /** Modes look at ruling lines, which a harmonic blend does not have. @param {string} mode */
  const wouldRefuse = (mode) => mode !== "figure" && isCurves(app.store.document) && isHarmonic(app.store.document);

  /** @param {Mode} mode */
  async function enter({ name, load }) {
    const held = stage.contains(document.activeElement) || aside.contains(document.activeElement);
    shown = name;
    refuses = wouldRefuse(name);
    view?.close();
    view = null;
    stage.replaceChildren();
    aside.replaceChildren();
    app.tool?.close();
    document.documentElement.dataset.mode = refuses ? "refused" : name;
    ui.set({ playing: false, probe: null });
    control.set(name);
    if (held) /** @type {HTMLElement | null} */ (element.querySelector("input:checked"))?.focus();
    if (!load) return;
    find("#status").replaceChildren();
    try {
      if (name !== "figure" && wouldRefuse(name)) {
        const { createRefusal } = await import("../harmonic/refusal.js");
        if (shown === name && refuses) view = createRefusal(app, { stage, aside, status: find("#status") }, name);
        view?.render();
        return;
      }
      const [create, { spanApp, spanChoice }] = await Promise.all([load(), import("../stack/span-view.js")]);
      if (shown !== name || refuses) return;
      const inner = create(spanApp(app), { stage, aside, status: find("#status") });
      const choice = spanChoice(app);
      choice.render();
      element.append(choice.element);
      view = {
        render() {
          choice.render();
          inner.render();
        },
        close() {
          choice.element.remove();
          inner.close();
        },
      };
      view.render();
    } catch (error) {
      ui.set({ mode: "figure", note: { tone: "error", text: words.failed(problem(error).message) } });
    }
  }

  return {
    render() {
      const { mode } = ui.value;
      const known = MODES.find(({ name }) => name === mode);
      if (!known) ui.set({ mode: "figure" });
      else if (shown !== mode || refuses !== wouldRefuse(mode)) void enter(known);
      else view?.render();
      control.set(known?.name ?? "figure");
    },
  };
}
