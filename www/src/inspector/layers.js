/**
 * Layers: what the picture shows.
 *
 * @import { App } from "../state/app.js"
 * @import { Group } from "./group.js"
 */
import { runCommand } from "../commands.js";
import { checkBox } from "../controls/choices.js";
import { h } from "../dom.js";
import { symbol } from "../icons.js";
import { LAYERS } from "../state/app.js";
import { strings } from "../strings.js";

/**
 * @param {App} app
 * @returns {Group}
 */
export function layersGroup(app) {
  const words = strings.layers;
  const boxes = LAYERS.map((name) => ({
    name,
    ...checkBox(
      { name, text: name === "value" ? [`${words.names.value} `, symbol("f")] : [words.names[name]] },
      (on) => {
        const { layers } = app.ui.value;
        app.ui.set({ layers: LAYERS.filter((layer) => (layer === name ? on : layers.includes(layer))) });
      },
    ),
  }));
  const snap = checkBox({ name: "snap", text: [words.snap] }, () => void runCommand(app, "snap"));
  return {
    name: "layers",
    heading: words.heading,
    body: h("div", { class: "layers" }, ...boxes.map(({ element }) => element), snap.element),
    phrase: () => words.phrase(app.ui.value.layers.length, LAYERS.length),
    render() {
      for (const { name, set } of boxes) set(app.ui.value.layers.includes(name));
      snap.set(app.ui.value.snap);
    },
  };
}
