/**
 * The group Materials: names and colours, one more, and away with one that no condition holds.
 *
 * @import { Group } from "../inspector/group.js"
 * @import { Bench } from "./state.js"
 */
import { newRun } from "../controls/run.js";
import { textField } from "../controls/text-field.js";
import { attribute, h } from "../dom.js";
import { PALETTE } from "../inspector/material-row.js";
import { MATERIAL_LIMIT } from "../state/materials.js";
import { strings } from "../strings.js";
import { addMaterial, changeMaterial, isMaterialUsed, removeMaterial } from "./edits.js";
import { words } from "./words.js";

const text = strings.materials;

/** @param {Bench} bench @returns {Group} */
export function materialsGroup(bench) {
  const rows = h("div", {});
  const add = h("button", { type: "button", class: "push", "data-lab-material-add": "", onclick: () => bench.commit(addMaterial) }, words.materials.add);
  /** @type {ReturnType<typeof createRow>[]} */
  let made = [];
  /** The material whose colours are open. @type {number | null} */
  let open = null;
  const show = (/** @type {number | null} */ index) => {
    open = index;
    bench.request();
  };
  return {
    name: "lab-materials",
    heading: words.materials.heading,
    body: h("div", {}, rows, h("div", { class: "lab-acts" }, add), h("p", { class: "lab-note" }, words.materials.note)),
    phrase: () => bench.now().document.materials.map(({ name }) => name).slice(0, 3).join(", "),
    render() {
      const { materials } = bench.now().document;
      if (made.length !== materials.length) {
        open = null;
        made = materials.map((_, index) => createRow(bench, index, show));
        rows.replaceChildren(...made.map(({ element }) => element));
      }
      made.forEach((row, index) => row.render(open === index));
      add.disabled = materials.length >= MATERIAL_LIMIT;
    },
  };
}

/** @param {Bench} bench @param {number} index @param {(open: number | null) => void} show */
function createRow(bench, index, show) {
  let run = newRun("color");
  let isOpen = false;
  const swatch = h("button", { type: "button", class: "swatch", "data-lab-swatch": index, onclick: () => show(isOpen ? null : index) });
  const name = textField({ label: text.name(index), name: `lab-material-${index}`, bare: true }, (value) => bench.commit((document) => changeMaterial(document, index, { name: value })));
  const chips = PALETTE.map((color, k) => {
    const chip = h("button", {
      type: "button",
      class: "swatch",
      "aria-label": text.palette[k],
      title: text.palette[k],
      "data-lab-chip": `${index} ${color}`,
      onclick: () => bench.commit((document) => changeMaterial(document, index, { color })),
    });
    chip.style.setProperty("--color", color);
    return { chip, color };
  });
  const free = h("input", { type: "color", class: "free-color" });
  free.addEventListener("input", () => bench.commit((document) => changeMaterial(document, index, { color: free.value }), run));
  free.addEventListener("change", () => {
    run = newRun("color");
    bench.endRun();
  });
  const remove = h("button", { type: "button", class: "push", "data-lab-material-remove": index, onclick: () => bench.commit((document) => removeMaterial(document, index)) }, words.materials.remove);
  const details = h("div", { class: "material-details", id: `lab-material-details-${index}` }, h("div", { class: "palette", role: "group" }, ...chips.map(({ chip }) => chip), free), h("div", { class: "lab-acts" }, remove));
  attribute(swatch, "aria-controls", details.id);
  return {
    element: h("div", { class: "material" }, h("div", { class: "material-line" }, swatch, name.element), details),
    /** @param {boolean} next whether its colours are open */
    render(next) {
      isOpen = next;
      const { document } = bench.now();
      const material = document.materials[index];
      const color = material.color.toLowerCase();
      swatch.style.setProperty("--color", color);
      attribute(swatch, "aria-label", text.details(material.name));
      attribute(swatch, "aria-expanded", String(isOpen));
      name.set(material.name);
      details.hidden = !isOpen;
      for (const each of chips) attribute(each.chip, "aria-pressed", String(each.color === color));
      if (free.value !== color) free.value = color;
      attribute(free, "aria-label", text.color(material.name));
      const reason = document.materials.length <= 2 ? words.materials.fewest : isMaterialUsed(document, index) ? words.materials.used : null;
      remove.disabled = reason !== null;
      attribute(remove, "title", reason);
    },
  };
}
