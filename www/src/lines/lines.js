/**
 * Single ruling lines on the page: pins, and the line that is explained. Loaded when there is one.
 *
 * @import { App } from "../state/app.js"
 */
import "../../styles/lines.css";
import { createExplainPanel } from "./explain-panel.js";
import { createPinMarks } from "./pin-marks.js";

/** @param {App} app */
export function createLines(app) {
  const marks = createPinMarks(app);
  const panel = createExplainPanel(app, marks.contend);
  return {
    render() {
      // Lines are explained on the figure alone; the other modes have the canvas to themselves.
      const { mode, line } = app.ui.value;
      if (mode !== "figure" && line !== null) app.ui.set({ line: null });
      marks.render();
      panel.render();
    },
  };
}
