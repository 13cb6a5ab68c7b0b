/**
 * The materials of a part: name, share of the part, colour, and removal with a choice of what takes their place.
 *
 * @import { Group } from "../../inspector/group.js"
 * @import { WholePart } from "../document.js"
 * @import { Bench } from "../state.js"
 */
import { checkBox } from "../../controls/choices.js";
import { newRun } from "../../controls/run.js";
import { textField } from "../../controls/text-field.js";
import { attribute, h, write } from "../../dom.js";
import { fixed } from "../../format.js";
import { PALETTE } from "../../inspector/material-row.js";
import { MATERIAL_LIMIT } from "../../state/materials.js";
import { strings } from "../../strings.js";
import { addMaterial, changeMaterial, isUsed, materialsOf, removeMaterial } from "../edits/materials.js";
import { words } from "./words.js";

/** @param {Bench} bench @returns {Group} */
export function materialsGroup(bench) {
  const said = strings.materials;
  const list = h("div", { class: "materials part-materials" });
  const add = h("button", { type: "button", class: "command-word", "data-action": "add-material" }, words.add);
  add.addEventListener("click", () =>
    bench.commit((document) => {
      const materials = materialsOf(document);
      const color = PALETTE.find((each) => materials.every((other) => other.color.toLowerCase() !== each)) ?? "#c3c9d2";
      return addMaterial(document, { name: said.fresh(materials.length), color, void: false });
    }),
  );
  /** The material whose details are open. */
  let opened = /** @type {number | null} */ (null);
  /** @type {ReturnType<typeof createRow>[]} */
  const rows = [];

  function render() {
    const { document, known } = bench.now();
    const materials = materialsOf(document);
    if (opened !== null && opened >= materials.length) opened = null;
    while (rows.length < materials.length) {
      const item = createRow(bench, rows.length, (open) => {
        opened = open;
        render();
      });
      rows.push(item);
      list.append(item.element);
    }
    while (rows.length > materials.length) rows.pop()?.element.remove();
    const measured = known?.measured;
    const isKnown = measured && known.document.materials?.length === materials.length && measured.area > 0;
    rows.forEach((item, k) => item.render(document, opened === k, isKnown ? measured.amounts[k] / measured.area : null));
    add.disabled = materials.length >= MATERIAL_LIMIT;
  }

  return {
    name: "materials",
    heading: words.groups.materials,
    body: list,
    commands: [add],
    phrase: () => said.phrase(materialsOf(bench.now().document).map(({ name }) => name)),
    render,
  };
}

/**
 * @param {Bench} bench
 * @param {number} index
 * @param {(open: number | null) => void} show opens the details of a material in place of any other
 */
function createRow(bench, index, show) {
  const said = strings.materials;
  let isOpen = false;
  let isChoosing = false;
  let run = newRun("color");
  /** @param {Partial<import("../edits/materials.js").Material>} patch @param {string} [own] */
  const change = (patch, own) => bench.commit((document) => changeMaterial(document, index, patch), own);

  const swatch = h("button", { type: "button", class: "swatch", "data-swatch": index });
  swatch.addEventListener("click", () => show(isOpen ? null : index));
  const name = textField({ label: said.name(index), name: `material-${index}`, bare: true }, (text) => change({ name: text }));
  const amount = h("span", { class: "part-amount number" });
  const chips = PALETTE.map((color, k) => {
    const chip = h("button", { type: "button", class: "swatch", "aria-label": said.palette[k], title: said.palette[k], "data-chip": `${index} ${color}`, onclick: () => change({ color }) });
    chip.style.setProperty("--color", color);
    return { chip, color };
  });
  const free = h("input", { type: "color", class: "free-color", "data-color": index });
  free.addEventListener("input", () => change({ color: free.value }, run));
  free.addEventListener("change", () => {
    run = newRun("color");
    bench.endRun();
  });
  const empty = checkBox({ name: `void-${index}`, text: [said.void] }, (on) => change({ void: on }));
  const remove = h("button", { type: "button", class: "command-word", "data-remove": index }, said.removeWord);
  remove.addEventListener("click", () => {
    isChoosing = isUsed(bench.now().document, index);
    if (isChoosing) show(index);
    else go(null);
  });
  const choices = h("div", { class: "replace", role: "group", "data-replace": index });
  const details = h(
    "div",
    { class: "material-details", id: `part-material-${index}` },
    h("div", { class: "palette", role: "group" }, ...chips.map(({ chip }) => chip), free),
    h("div", { class: "material-commands" }, empty.element, remove),
    choices,
  );
  attribute(swatch, "aria-controls", details.id);

  /** @param {number | null} into */
  function go(into) {
    const gone = materialsOf(bench.now().document)[index].name;
    const { isolines } = bench.now().shown;
    isChoosing = false;
    show(null);
    bench.commit((document) => removeMaterial(document, index, into));
    if (isolines !== null && isolines >= index) bench.change({ isolines: isolines > index ? isolines - 1 : null });
    bench.app.say(said.removed(gone));
  }

  return {
    element: h("div", { class: "material" }, h("div", { class: "material-line" }, swatch, name.element, amount), details),
    /** @param {WholePart} document @param {boolean} open @param {number | null} share of the part */
    render(document, open, share) {
      isOpen = open;
      const materials = materialsOf(document);
      const material = materials[index];
      const color = material.color.toLowerCase();
      swatch.style.setProperty("--color", material.color);
      swatch.classList.toggle("void", material.void === true);
      attribute(swatch, "aria-label", said.details(material.name));
      attribute(swatch, "title", said.details(material.name));
      attribute(swatch, "aria-expanded", String(open));
      name.set(material.name);
      write(amount, share === null ? "" : `${fixed(100 * share, 1)}\u00a0%`);
      attribute(amount, "title", share === null ? null : words.amount(material.name, amount.textContent ?? ""));
      details.hidden = !open;
      if (!open) {
        isChoosing = false;
        return;
      }
      for (const each of chips) attribute(each.chip, "aria-pressed", String(each.color === color));
      if (free.value !== color) free.value = color;
      attribute(free, "aria-label", said.color(material.name));
      attribute(free, "title", said.color(material.name));
      empty.set(material.void === true);
      remove.disabled = materials.length < 2;
      attribute(remove, "aria-expanded", String(isChoosing));
      attribute(remove, "title", remove.disabled ? said.onlyOne : null);
      choices.hidden = !isChoosing;
      if (!isChoosing) return;
      attribute(choices, "aria-label", said.replace(material.name));
      choices.replaceChildren(
        h("span", { class: "row-label" }, said.replaceBy),
        ...materials.flatMap((other, k) => (k === index ? [] : [h("button", { type: "button", class: "choice", "data-into": k, onclick: () => go(k) }, other.name)])),
        h(
          "button",
          {
            type: "button",
            class: "choice plain-choice",
            onclick: () => {
              isChoosing = false;
              show(index);
            },
          },
          said.keep,
        ),
      );
    },
  };
}
