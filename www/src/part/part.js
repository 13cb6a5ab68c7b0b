/**
 * The workbench Part: bodies in the plane whose composition is a function of the distances to features.
 *
 * @import { App } from "../state/app.js"
 */
import { isOf } from "../state/kind.js";

/** Of documents that are shown here. */
const KIND = "part";

/** @param {App} app */
export function createPart(app) {
  const root = document.documentElement;
  return {
    render() {
      const isOn = isOf(app.store.document, KIND) && app.ui.value.workbench !== "lessons";
      if (isOn) root.dataset.workbench = KIND;
      else if (root.dataset.workbench === KIND) delete root.dataset.workbench;
    },
  };
}
