/**
 * A workbench that is on while a document of its kind is open and no lesson lies over it.
 *
 * @import { App } from "../state/app.js"
 * @import { Part } from "../later.js"
 */
import { isOf } from "../state/kind.js";

/**
 * @param {App} app
 * @param {"hyperpatch" | "part" | "laplace"} kind
 * @param {(app: App) => Part & {close: () => void}} enter puts it on the page; it is closed when it is left
 * @returns {Part}
 */
export function createWorkbench(app, kind, enter) {
  /** @type {ReturnType<typeof enter> | null} */
  let open = null;
  const root = document.documentElement;
  return {
    render() {
      const isOn = isOf(app.store.document, kind) && app.ui.value.workbench !== "lessons";
      if (isOn && !open) {
        root.dataset.workbench = kind;
        open = enter(app);
      }
      if (isOn) open?.render();
      else if (open) {
        open.close();
        open = null;
        if (root.dataset.workbench === kind) delete root.dataset.workbench;
      }
    },
  };
}
