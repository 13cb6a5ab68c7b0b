/**
 * Layers: what the picture shows.
 *
 * @import { App } from "../state/app.js"
 * @import { Group } from "./group.js"
 */
import { runCommand } from "../commands.js";
import { checkBox } from "../controls/choices.js";
import { row } from "../controls/row.js";
import { attribute, h, write } from "../dom.js";
import { symbol } from "../icons.js";
import { LAYERS } from "../state/app.js";
import { hasLooks, isHarmonic, lookedAt } from "../state/look.js";
import { strings } from "../strings.js";

/**
 * @param {App} app
 * @returns {Group}
 */
export function layersGroup(app) {
  const words = strings.layers;
  /** Blends differ where there are two. @param {string} name */
  const has = (name) => name !== "difference" || (hasLooks(app.store.document) && isHarmonic(lookedAt(app)));
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
  const patterns = checkBox({ name: "patterns", text: [words.patterns] }, (on) => app.ui.set({ patterns: on }));
  attribute(patterns.element, "title", words.patternsHelp);
  const snap = checkBox({ name: "snap", text: [words.snap] }, () => void runCommand(app, "snap"));
  const select = h("select", { "aria-label": words.isoMaterialField, "data-select": "iso-material" });
  select.addEventListener("change", () => app.ui.set({ isoMaterial: Number(select.value) }));
  const material = row(words.isoMaterial, { element: h("span", { class: "field select" }, select) });
  return {
    name: "layers",
    heading: words.heading,
    body: h("div", {}, h("div", { class: "layers" }, ...boxes.map(({ element }) => element), patterns.element, snap.element), material),
    phrase: () => words.phrase(app.ui.value.layers.filter(has).length, LAYERS.filter(has).length),
    render() {
      const { layers, isoMaterial, patterns: hatched, snap: snaps } = app.ui.value;
      const { materials } = app.store.document;
      for (const { name, element, set } of boxes) {
        element.hidden = !has(name);
        set(layers.includes(name));
      }
      patterns.set(hatched);
      snap.set(snaps);
      material.hidden = !layers.includes("isoComposition");
      while (select.options.length < materials.length) select.append(h("option", {}));
      while (select.options.length > materials.length) select.remove(materials.length);
      materials.forEach(({ name }, i) => {
        write(select.options[i], name);
        attribute(select.options[i], "value", String(i));
      });
      if (select.value !== String(isoMaterial)) select.value = String(isoMaterial);
    },
  };
}
