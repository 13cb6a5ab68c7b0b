/**
 * Materials: colour, name, which curve holds which, and how the composition runs along each curve.
 *
 * @import { App } from "../state/app.js"
 * @import { Group } from "./group.js"
 */
import { attribute, h } from "../dom.js";
import { later } from "../later.js";
import { currentMatch } from "../state/app.js";
import { isWhole } from "../state/selection.js";
import { addMaterial, MATERIAL_LIMIT } from "../state/materials.js";
import { strings } from "../strings.js";
import { compositionStrip } from "./composition.js";
import { materialRow, PALETTE } from "./material-row.js";

/**
 * @param {App} app
 * @returns {Group}
 */
export function materialsGroup(app) {
  const words = strings.materials;
  const list = h("div", { class: "materials" });
  /** @type {ReturnType<typeof compositionStrip>[]} */
  const strips = [];
  const stripPlace = h("div", {});
  const panel = h("div", {});
  const place = h("div", {});
  const amounts = later(app, () => currentMatch(app) !== null, async () => {
    const { createAmounts } = await import("../cells/amounts.js");
    return () => createAmounts(app, place);
  });
  const toggle = h(
    "button",
    { type: "button", class: "command-word", title: strings.composition.toggleHelp, "data-action": "compose" },
    strings.composition.toggle,
  );
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
  toggle.addEventListener("click", () => {
    const { composing, selection } = app.ui.value;
    const curve = selection && (isWhole(selection) || app.ui.value.key === null) ? selection.curve : null;
    app.ui.set({ composing: !composing, ...(curve === null || composing ? {} : { key: { curve, index: 0 } }) });
    app.say(composing ? strings.composition.left : strings.composition.entered);
    requestAnimationFrame(reveal);
  });
  /** @type {{render: () => void} | null} */
  let keyPanel = null;
  let asked = false;
  /** @type {ReturnType<typeof materialRow>[]} */
  const rows = [];
  /** The row whose details are open. @type {number | null} */
  let opened = null;

  /** Brings the chosen key's numbers into view. */
  function reveal() {
    if (!panel.hidden) panel.scrollIntoView({ block: "nearest" });
  }

  function renderKeyPanel() {
    panel.hidden = !app.ui.value.composing;
    if (panel.hidden) return;
    if (keyPanel) keyPanel.render();
    else if (!asked) {
      asked = true;
      void import("./key-panel.js").then(({ createKeyPanel }) => {
        const made = createKeyPanel(app);
        panel.append(made.element);
        keyPanel = made;
        renderKeyPanel();
        reveal();
      });
    }
  }

  function render() {
    const { document } = app.store;
    const { composing } = app.ui.value;
    while (rows.length < document.materials.length) {
      const index = rows.length;
      const item = materialRow(app, index, (/** @type {number | null} */ open) => {
        opened = open;
        render();
      });
      rows.push(item);
      list.append(item.element);
    }
    while (rows.length > document.materials.length) rows.pop()?.element.remove();
    rows.forEach((item, index) => item.render(document, opened === index));
    add.disabled = document.materials.length >= MATERIAL_LIMIT;
    attribute(toggle, "aria-pressed", String(composing));
    toggle.disabled = document.curves.length === 0;
    while (strips.length < document.curves.length) {
      const strip = compositionStrip(app, strips.length);
      strips.push(strip);
      stripPlace.append(strip.element);
    }
    for (const strip of strips) strip.render();
    renderKeyPanel();
    amounts.render();
  }

  return {
    name: "materials",
    heading: words.heading,
    body: h("div", {}, list, stripPlace, panel, place),
    commands: [toggle, add],
    phrase: () => words.phrase(app.store.document.materials.map(({ name }) => name)),
    render,
  };
}
