/**
 * The button on the canvas that draws, and the tool that it begins.
 *
 * @import { Tool } from "../../state/app.js"
 * @import { Bench } from "../state.js"
 * @import { Drawn, Purpose } from "./drawing.js"
 */
import { h } from "../../dom.js";
import { attachMenu } from "../../frame/menu-button.js";
import { icon } from "../../icons.js";
import { KINDS, words } from "./draw-words.js";

/** Kinds in the menu: those that can be bodies, a line, and those that only refer. @type {(Drawn | "separator")[]} */
const MENU = ["polygon", "circle", "closed", "separator", "point", "segment", "line", "polyline", "open"];

/**
 * @param {Bench} bench
 * @param {HTMLElement} stage
 */
export function createTools(bench, stage) {
  const { app } = bench;
  /** What shapes are drawn for, as it was chosen last. @type {Purpose | null} */
  let purpose = null;
  /** @type {Tool | null} */
  let tool = null;
  const button = h("button", { type: "button", class: "command-word", "data-part-draw": "" }, words.draw, /** @type {any} */ (icon("down")));
  attachMenu(button, () =>
    MENU.map((drawn) => (drawn === "separator" ? "line" : { name: `draw-${drawn}`, text: KINDS[drawn], act: () => void begin(drawn) })),
  );
  const element = h("div", { class: "shape-tools", "data-furniture": "" }, button);
  (stage.querySelector(".modes") ?? stage).append(element);

  /** @param {Drawn} drawn */
  async function begin(drawn) {
    const { createDraw } = await import("./draw.js");
    app.tool?.close();
    const { document, view } = bench.now();
    if (!view) return;
    const first = purpose ?? (document.bodies.length === 0 ? "body" : "reference");
    tool = createDraw(bench, stage, { drawn, purpose: first }, (last, made) => {
      tool = null;
      purpose = last.purpose;
      bench.request();
      // What comes next is meant for the shape: keys act on what has the focus.
      requestAnimationFrame(() => requestAnimationFrame(() => focusAfter(made)));
    });
    app.ui.set({ note: null });
    bench.request();
  }

  /** Gives the focus that was the tool's to what came of it; one that has gone elsewhere stays. @param {string | null} made */
  function focusAfter(made) {
    if (document.activeElement !== document.body) return;
    const target = made === null ? button : stage.querySelector(`[data-part-shape="${CSS.escape(made)}"]`);
    if (target instanceof HTMLElement || target instanceof SVGElement) target.focus({ preventScroll: true });
  }

  return {
    get tool() {
      return tool;
    },
    isDrawing: () => tool !== null,
    /** Begins to draw. @param {Drawn} drawn */
    begin,
    render() {
      const { view, shown } = bench.now();
      element.hidden = tool !== null || view === null || shown.compare;
      tool?.render();
    },
    close() {
      tool?.close();
      element.remove();
    },
  };
}
