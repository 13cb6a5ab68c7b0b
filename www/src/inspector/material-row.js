/**
 * One material: swatch, name, the curves that are all of it, and below them, when opened, colours, order and removal.
 *
 * @import { App } from "../state/app.js"
 * @import { Curve, CurvesDocument } from "../types.js"
 */
import { checkBox } from "../controls/choices.js";
import { newRun } from "../controls/run.js";
import { textField } from "../controls/text-field.js";
import { attribute, h, write } from "../dom.js";
import { curveName, letterOf } from "../state/app.js";
import { setHatch } from "../state/hatch.js";
import { assignMaterial, changeMaterial, holds, isUsed, moveMaterial, removeMaterial } from "../state/materials.js";
import { inSentence, strings } from "../strings.js";

/** Colours told apart by colour-blind readers as well (Okabe and Ito), and a silver. */
export const PALETTE = ["#f0e442", "#009e73", "#0072b2", "#e69f00", "#56b4e9", "#d55e00", "#cc79a7", "#c3c9d2"];

/**
 * @param {App} app
 * @param {number} index
 * @param {(open: number | null) => void} show opens the details of a row in place of any other
 */
export function materialRow(app, index, show) {
  const words = strings.materials;
  let isOpen = false;
  /** @param {(document: CurvesDocument) => CurvesDocument} change */
  const commit = (change) => app.store.commit({ change });

  const swatch = h("button", { type: "button", class: "swatch", "data-swatch": index });
  swatch.addEventListener("click", () => show(isOpen ? null : index));
  const name = textField({ label: words.name(index), name: `material-${index}`, bare: true }, (text) =>
    commit((document) => changeMaterial(document, index, { name: text })),
  );
  /** @type {HTMLButtonElement[]} */
  const holders = [];
  const line = h("div", { class: "material-line" }, swatch, name.element);

  /** A button for every curve; those of curves that are gone hide. @param {number} count */
  function grow(count) {
    while (holders.length < count) {
      const curve = holders.length;
      const button = h("button", { type: "button", class: "holder", "data-holder": `${curve}-${index}` });
      button.addEventListener("click", () => commit((document) => assignMaterial(document, curve, index)));
      holders.push(button);
      line.append(button);
    }
  }
  const details = createDetails(app, index, show);
  details.element.id = `material-details-${index}`;
  attribute(swatch, "aria-controls", details.element.id);

  return {
    element: h(
      "div",
      { class: "material" },
      line,
      details.element,
    ),

    /** @param {CurvesDocument} document @param {boolean} open */
    render(document, open) {
      isOpen = open;
      const material = document.materials[index];
      swatch.style.setProperty("--color", material.color);
      setHatch(swatch, app.ui.value.patterns, index, material);
      swatch.classList.toggle("void", material.void === true);
      attribute(swatch, "aria-label", words.details(material.name));
      attribute(swatch, "title", words.details(material.name));
      attribute(swatch, "aria-expanded", String(open));
      name.set(material.name);
      grow(document.curves.length);
      line.classList.toggle("many", document.curves.length > 2);
      holders.forEach((button, curve) => {
        const shape = /** @type {Curve | undefined} */ (document.curves[curve]);
        button.hidden = !shape;
        if (!shape) return;
        const label = curveName(document, curve);
        write(button, document.curves.length > 2 ? letterOf(curve) : inSentence(label));
        attribute(button, "aria-label", words.on(label, material.name));
        attribute(button, "aria-pressed", String(holds(shape, index)));
      });
      details.render(document, open);
    },
  };
}

/**
 * @param {App} app
 * @param {number} index
 * @param {(open: number | null) => void} show
 */
function createDetails(app, index, show) {
  const words = strings.materials;
  let run = newRun("color");
  let isChoosing = false;
  /** @param {(document: CurvesDocument) => CurvesDocument} change */
  const commit = (change) => app.store.commit({ change });
  /** @param {string} color */
  const recolour = (color) => (/** @type {CurvesDocument} */ document) =>
    document.materials[index].color === color ? document : changeMaterial(document, index, { color });

  const chips = PALETTE.map((color, i) => {
    const chip = h("button", {
      type: "button",
      class: "swatch",
      "aria-label": words.palette[i],
      title: words.palette[i],
      "data-chip": `${index} ${color}`,
      onclick: () => commit(recolour(color)),
    });
    chip.style.setProperty("--color", color);
    return { chip, color };
  });
  const free = h("input", { type: "color", class: "free-color", "data-color": index });
  free.addEventListener("input", () => app.store.commit({ run, change: recolour(free.value) }));
  free.addEventListener("change", () => {
    run = newRun("color");
    app.store.endRun();
  });
  const empty = checkBox({ name: `void-${index}`, text: [words.void] }, (on) =>
    commit((document) => changeMaterial(document, index, { void: on })),
  );
  const button = (/** @type {string} */ action, /** @type {string} */ text, /** @type {() => void} */ act) =>
    h("button", { type: "button", class: "command-word", "data-action": `${action}-${index}`, onclick: act }, text);
  const up = button("up", words.up, () => move(-1));
  const down = button("down", words.down, () => move(1));
  const remove = button("remove", words.removeWord, () => {
    isChoosing = isUsed(app.store.document, index);
    if (isChoosing) show(index);
    else go(null);
  });
  remove.dataset.remove = String(index);
  const choices = h("div", { class: "replace", role: "group", "data-replace": index });
  const element = h(
    "div",
    { class: "material-details" },
    h("div", { class: "palette", role: "group" }, ...chips.map(({ chip }) => chip), free),
    h("div", { class: "material-commands" }, empty.element, up, down, remove),
    choices,
  );

  /** @param {number} by */
  function move(by) {
    const { isoMaterial } = app.ui.value;
    const to = index + by;
    commit((document) => moveMaterial(document, index, to));
    app.ui.set({ isoMaterial: isoMaterial === index ? to : isoMaterial === to ? index : isoMaterial });
    show(to);
    app.say(words.moved(app.store.document.materials[to].name, to + 1, app.store.document.materials.length));
  }

  /** @param {number | null} into */
  function go(into) {
    const { name } = app.store.document.materials[index];
    isChoosing = false;
    show(null);
    commit((document) => removeMaterial(document, index, into));
    app.say(words.removed(name));
  }

  return {
    element,
    /** @param {CurvesDocument} document @param {boolean} open */
    render(document, open) {
      element.hidden = !open;
      if (!open) {
        isChoosing = false;
        return;
      }
      const { materials } = document;
      const material = materials[index];
      const color = material.color.toLowerCase();
      for (const each of chips) attribute(each.chip, "aria-pressed", String(each.color === color));
      if (free.value !== color) free.value = color;
      attribute(free, "aria-label", words.color(material.name));
      attribute(free, "title", words.color(material.name));
      empty.set(material.void === true);
      up.disabled = index === 0;
      down.disabled = index === materials.length - 1;
      remove.disabled = materials.length < 2;
      attribute(remove, "aria-expanded", String(isChoosing));
      attribute(remove, "title", remove.disabled ? words.onlyOne : null);
      choices.hidden = !isChoosing;
      if (!isChoosing) return;
      attribute(choices, "aria-label", words.replace(material.name));
      choices.replaceChildren(
        h("span", { class: "row-label" }, words.replaceBy),
        ...materials.flatMap((other, i) =>
          i === index
            ? []
            : [h("button", { type: "button", class: "choice", "data-into": i, onclick: () => go(i) }, other.name)],
        ),
        h("button", { type: "button", class: "choice plain-choice", onclick: () => ((isChoosing = false), show(index)) }, words.keep),
      );
    },
  };
}
