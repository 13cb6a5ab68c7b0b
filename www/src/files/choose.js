/**
 * Lets the person choose a file to open: with the browser's own picker where it gives a handle to save to, else with an input.
 *
 * @import { App } from "../state/app.js"
 */
import { h } from "../dom.js";
import { problem } from "../painter.js";
import { strings } from "../strings.js";
import { ACCEPTED, pickToOpen } from "./file-system.js";
import { openFile, refuse } from "./open.js";

/**
 * @param {App} app
 * @returns {{element: HTMLElement, choose: () => Promise<void>}} the hidden input, and what shows the picker
 */
export function createChooser(app) {
  const input = h("input", {
    type: "file",
    accept: ACCEPTED,
    hidden: true,
    "data-file": "",
    "aria-label": strings.file.open,
  });
  input.addEventListener("change", () => {
    const [chosen] = input.files ?? [];
    if (chosen) void openFile(app, chosen);
    input.value = "";
  });

  async function choose() {
    try {
      const handle = await pickToOpen();
      if (handle) await openFile(app, await handle.getFile(), handle);
      else if (handle === undefined) input.click();
    } catch (error) {
      refuse(app, strings.file.chosen, problem(error).message);
    }
  }
  return { element: input, choose };
}
