/**
 * Materials: colour, name, and which curve holds which.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument } from "../types.js"
 * @import { Group } from "./group.js"
 */
import { newRun } from "../controls/run.js";
import { textField } from "../controls/text-field.js";
import { attribute, h, write } from "../dom.js";
import { icon } from "../icons.js";
import { curveName } from "../state/app.js";
import { addMaterial, assignMaterial, changeMaterial, holds, MATERIAL_LIMIT, removeMaterial } from "../state/materials.js";
import { inSentence, strings } from "../strings.js";
import { compositionStrip } from "./composition.js";

/** Colours for new materials, told apart by colour-blind readers as well (Okabe and Ito). */
const PALETTE = ["#f0e442", "#009e73", "#0072b2", "#e69f00", "#56b4e9", "#d55e00", "#cc79a7", "#c3c9d2"];

/**
 * @param {App} app
 * @returns {Group}
 */
export function materialsGroup(app) {
  const words = strings.materials;
  const list = h("div", { class: "materials" });
  const strips = h("div", {});
  const add = h("button", { type: "button", class: "command-word", "data-action": "add-material" }, words.add);
  add.addEventListener("click", () =>
    app.store.commit({
      change: (document) => {
        const index = document.materials.length;
        const color = PALETTE.find((c) => document.materials.every((m) => m.color.toLowerCase() !== c)) ?? "#c3c9d2";
        return addMaterial(document, { name: words.fresh(index), color });
      },
    }),
  );
  /** @type {ReturnType<typeof materialRow>[]} */
  const rows = [];

  return {
    name: "materials",
    heading: words.heading,
    body: h("div", {}, list, strips),
    commands: [add],
    phrase: () => words.phrase(app.store.document.materials.map(({ name }) => name)),
    render() {
      const { document } = app.store;
      while (rows.length < document.materials.length) {
        const item = materialRow(app, rows.length);
        rows.push(item);
        list.append(item.element);
      }
      while (rows.length > document.materials.length) rows.pop()?.element.remove();
      for (const item of rows) item.render(document);
      add.disabled = document.materials.length >= MATERIAL_LIMIT;
      strips.replaceChildren(
        ...[0, 1].map((index) => compositionStrip(document, index)).filter((strip) => strip !== null),
      );
    },
  };
}

/**
 * @param {App} app
 * @param {number} index
 */
function materialRow(app, index) {
  const words = strings.materials;
  let run = newRun("color");
  const color = h("input", { type: "color", class: "swatch", "data-color": index });
  color.addEventListener("input", () =>
    app.store.commit({ run, change: (document) => changeMaterial(document, index, { color: color.value }) }),
  );
  color.addEventListener("change", () => {
    run = newRun("color");
    app.store.endRun();
  });
  const name = textField({ label: words.name(index), name: `material-${index}`, bare: true }, (text) =>
    app.store.commit({ change: (document) => changeMaterial(document, index, { name: text }) }),
  );
  const holders = /** @type {const} */ ([0, 1]).map((curve) => {
    const button = h("button", { type: "button", class: "holder", "data-holder": `${curve}-${index}` });
    button.addEventListener("click", () =>
      app.store.commit({ change: (document) => assignMaterial(document, curve, index) }),
    );
    return button;
  });
  const remove = h(
    "button",
    { type: "button", class: "bare icon-only remove", "data-remove": index },
    icon("cross", 12),
  );
  remove.addEventListener("click", () => app.store.commit({ change: (document) => removeMaterial(document, index) }));

  return {
    element: h("div", { class: "material" }, color, name.element, remove, ...holders),

    /** @param {CurvesDocument} document */
    render(document) {
      const material = document.materials[index];
      if (!material) return;
      if (color.value !== material.color.toLowerCase()) color.value = material.color;
      attribute(color, "aria-label", words.color(material.name));
      name.set(material.name);
      holders.forEach((button, curve) => {
        const shape = document.curves[curve];
        button.hidden = !shape;
        if (!shape) return;
        const label = curveName(document, curve);
        write(button, inSentence(label));
        attribute(button, "aria-label", words.on(label, material.name));
        attribute(button, "aria-pressed", String(holds(shape, index)));
      });
      remove.hidden = document.materials.length < 2 || document.curves.some((curve) => holds(curve, index));
      attribute(remove, "aria-label", words.remove(material.name));
      attribute(remove, "title", words.remove(material.name));
    },
  };
}
