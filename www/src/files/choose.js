/**
 * Lets the person choose a file to open: with the browser's own picker where it gives a handle to save to, else with an input.
 *
 * @import { App } from "../state/app.js"
 */
import { h } from "../dom.js";
import { problem } from "../painter.js";
import { strings } from "../strings.js";
import { ACCEPTED, pickToOpen } from "./file-system.js";

/** Loaded when a file has been chosen. */
const opening = () => import("./open.js");

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
    if (chosen) void opening().then(({ openFile }) => openFile(app, chosen));
    input.value = "";
  });

  async function choose() {
    try {
      const handle = await pickToOpen();
      if (handle) await (await opening()).openFile(app, await handle.getFile(), handle);
      else if (handle === undefined) input.click();
    } catch (error) {
      (await opening()).refuse(app, strings.file.chosen, problem(error).message);
    }
  }
  return { element: input, choose };
}
