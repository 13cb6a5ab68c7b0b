/**
 * A workbench that is on while a document of its kind is open and no lesson lies over it.
 *
 * @import { App } from "../state/app.js"
 * @import { Part } from "../later.js"
 *
 * @typedef {object} Place Where a workbench stands; taken away when it is left.
 * @property {HTMLElement} stage over the canvas
 * @property {HTMLElement} aside in the inspector, in place of the groups of curves
 */
import "../../styles/bench.css";
import { find, h } from "../dom.js";
import { isOf } from "../state/kind.js";

/**
 * @param {App} app
 * @param {"hyperpatch" | "part" | "laplace"} kind
 * @param {string} name of the classes of its places
 * @param {(app: App, place: Place) => Part & {close: () => void}} enter puts it on the page; it is closed when it is left
 * @returns {Part}
 */
export function createWorkbench(app, kind, name, enter) {
  /** @type {{bench: ReturnType<typeof enter>, place: Place} | null} */
  let open = null;
  const root = document.documentElement;

  function start() {
    root.dataset.workbench = kind;
    const stage = h("div", { class: `bench-stage ${name}-stage`, "data-furniture": "" });
    const aside = h("div", { class: `bench-aside ${name}-aside` });
    find("#stage").prepend(stage);
    find("#inspector").append(aside);
    return { bench: enter(app, { stage, aside }), place: { stage, aside } };
  }

  return {
    render() {
      const isOn = isOf(app.store.document, kind) && app.ui.value.workbench !== "lessons";
      if (isOn) (open ??= start()).bench.render();
      else if (open) {
        open.bench.close();
        for (const element of Object.values(open.place)) element.remove();
        open = null;
        if (root.dataset.workbench === kind) delete root.dataset.workbench;
      }
    },
  };
}
