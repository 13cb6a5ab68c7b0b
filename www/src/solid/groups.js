/**
 * The groups beside the solid: its measures, the heights of the curves, what is shown, and the section.
 *
 * @import { App } from "../state/app.js"
 * @import { Group } from "../inspector/group.js"
 * @import { NumberField } from "../controls/number-field.js"
 * @import { StandardView } from "../space/camera.js"
 * @import { Known } from "./status.js"
 * @import { SolidColor } from "./state.js"
 *
 * @typedef {object} Now
 * @property {Known} known
 * @property {[number, number] | null} extent of the section plane's way, document units
 * @property {boolean} hasFace whether a cut has a face
 */
import { checkBox } from "../controls/choices.js";
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { select } from "../controls/select.js";
import { h, write } from "../dom.js";
import { editable, fixed } from "../format.js";
import { editing } from "../inspector/edit.js";
import { fact } from "../space/card.js";
import { sectionRows } from "../space/section-group.js";
import { viewButtons } from "../space/stand.js";
import { curveName } from "../state/app.js";
import { changeCurve } from "../state/edits.js";
import { hasSpace } from "../state/in-space.js";
import { arrowStep } from "../view.js";
import { changeSolid, SOLID_LAYERS, solidUi } from "./state.js";
import { measure } from "../space/measure.js";
import { sidesOf } from "./status.js";
import { words } from "./words.js";

/** Largest height the format allows. */
const FAR = 1e12;

/**
 * @param {App} app
 * @param {() => Now} now
 * @param {{look: (view: StandardView) => void}} acts
 * @returns {Group[]}
 */
export function createSolidGroups(app, now, { look }) {
  return [showGroup(app, look), sectionGroup(app, now), heightsGroup(app), bodyGroup(app, now)];
}

/** @param {App} app @param {() => Now} now @returns {Group} */
function bodyGroup(app, now) {
  const body = h("div", {});
  let drawn = "";
  return {
    name: "body",
    heading: words.groups.body,
    body,
    phrase() {
      const { solid } = now().known;
      return solid ? words.body.phrase(sidesOf(solid), app.store.document.unit) : words.body.none;
    },
    render() {
      const { solid, worst, reason, lack } = now().known;
      const { unit } = app.store.document;
      const facts = /** @type {[string, string, string][]} */ (
        solid
          ? [
              [words.body.size, words.body.phrase(sidesOf(solid), unit), "size"],
              [words.body.volume, solid.volume === null ? words.body.open : measure(solid.volume, unit, 3), "volume"],
              [words.body.area, measure(solid.area, unit, 2), "area"],
              [words.body.triangles, fixed(solid.indices.length / 3, 0), "triangles"],
              ...(worst.twist === null ? [] : [[words.body.twist, `${fixed(worst.twist, 1)}°`, "twist"]]),
              ...(worst.flank === null ? [] : [[words.body.flank, `${fixed(worst.flank, 1)}°`, "flank"]]),
            ]
          : []
      );
      const key = JSON.stringify([facts, reason, lack]);
      if (key === drawn) return;
      drawn = key;
      body.replaceChildren(...facts.map((each) => fact(...each)), ...(facts.length === 0 ? [h("p", { class: "solid-note" }, reason ?? lack ?? words.loading)] : []));
    },
  };
}

/** @param {App} app @returns {Group} */
function heightsGroup(app) {
  const list = h("div", {});
  const note = h("p", { class: "solid-note" });
  /** @type {{label: HTMLElement, field: NumberField}[]} */
  let rows = [];
  return {
    name: "heights",
    heading: words.groups.heights,
    body: h("div", {}, list, note),
    phrase: () => hasSpace(app.store.document) ? words.heights.inSpace : words.heights.phrase(app.store.document.curves.map(({ height }) => editable(height, 0))),
    render() {
      const { document } = app.store;
      if (rows.length !== document.curves.length) {
        rows = document.curves.map((_, i) => heightRow(app, i));
        list.replaceChildren(...rows.map(({ label, field }) => row(label, field)));
      }
      const inSpace = hasSpace(document);
      list.hidden = inSpace;
      document.curves.forEach((curve, i) => {
        write(rows[i].label, curveName(document, i));
        rows[i].field.set(curve.height);
      });
      write(note, inSpace ? words.heights.space : words.heights.note);
    },
  };
}

/** @param {App} app @param {number} index */
function heightRow(app, index) {
  const name = curveName(app.store.document, index);
  const field = numberField(
    { label: words.heights.of(name), name: `solid-height-${index}`, min: -FAR, max: FAR, step: () => arrowStep(app.store.document), decimals: 1 },
    editing(app, (document, value) => changeCurve(document, index, (curve) => (curve.height === value ? curve : { ...curve, height: value }))),
  );
  return { label: h("span", {}), field };
}

/** @param {App} app @param {(view: StandardView) => void} look @returns {Group} */
function showGroup(app, look) {
  const color = select(
    {
      label: words.show.color,
      name: "solid-color",
      choices: /** @type {const} */ (["material", "fraction", "twist", "flank"]).map((value) => ({ value, text: words.show.colors[value] })),
    },
    (value) => changeSolid(app, { color: /** @type {SolidColor} */ (value) }),
  );
  const material = h("select", { "aria-label": words.show.material, "data-select": "solid-material" });
  material.addEventListener("change", () => changeSolid(app, { material: Number(material.value) }));
  const materialRow = row(words.show.material, { element: h("span", { class: "field select" }, material) });
  const note = h("p", { class: "solid-note" });
  const boxes = SOLID_LAYERS.map((name) => ({
    name,
    ...checkBox({ name: `solid-${name}`, text: [words.show.layers[name]] }, (on) => {
      const { layers } = solidUi(app);
      changeSolid(app, { layers: SOLID_LAYERS.filter((layer) => (layer === name ? on : layers.includes(layer))) });
    }),
  }));
  const body = h(
    "div",
    {},
    row(words.show.color, color),
    materialRow,
    note,
    h("div", { class: "layers solid-layers" }, ...boxes.map(({ element }) => element)),
    viewButtons("solid", words.show, look),
  );
  return {
    name: "show",
    heading: words.groups.show,
    body,
    phrase: () => words.show.colors[solidUi(app).color],
    render() {
      const shown = solidUi(app);
      const { materials } = app.store.document;
      color.set(shown.color);
      materialRow.hidden = shown.color !== "fraction";
      while (material.options.length < materials.length) material.append(h("option", {}));
      while (material.options.length > materials.length) material.remove(materials.length);
      materials.forEach(({ name }, i) => {
        write(material.options[i], name);
        material.options[i].value = String(i);
      });
      const chosen = String(Math.min(shown.material, materials.length - 1));
      if (material.value !== chosen) material.value = chosen;
      write(note, words.show.notes[shown.color]);
      note.hidden = note.textContent === "";
      for (const { name, set } of boxes) set(shown.layers.includes(name));
    },
  };
}

/** @param {App} app @param {() => Now} now @returns {Group} */
function sectionGroup(app, now) {
  const rows = sectionRows(
    { name: "section", words: words.section, step: () => arrowStep(app.store.document), decimals: 1 },
    () => ({ section: solidUi(app).section, extent: now().extent, unit: app.store.document.unit }),
    (section) => changeSolid(app, { section }),
  );
  const note = h("p", { class: "solid-note" });
  rows.on.append(note);
  return {
    name: "section",
    heading: words.groups.section,
    body: rows.element,
    phrase: rows.phrase,
    render() {
      rows.render();
      write(note, now().hasFace ? words.section.note : words.section.openNote);
    },
  };
}
