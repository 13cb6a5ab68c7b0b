/**
 * The group Boundary: sets of elements with their conditions, chosen, renamed, added and deleted; what a chosen one has, and which elements belong to it.
 *
 * @import { Group as Panel } from "../inspector/group.js"
 * @import { Condition, Group } from "./document.js"
 * @import { By, ConditionKind } from "./edits.js"
 * @import { Bench, Picking } from "./state.js"
 * @import { createPreview } from "./preview.js"
 */
import { segment } from "../controls/choices.js";
import { mixingControl } from "../controls/mixing.js";
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { select } from "../controls/select.js";
import { slider } from "../controls/slider.js";
import { textField } from "../controls/text-field.js";
import { attribute, h, write } from "../dom.js";
import { fixed } from "../format.js";
import { mixed } from "../oklab.js";
import { measure } from "../space/measure.js";
import { addGroup, ANGLE, byOf, chosenBy, conditionOf, isFormula, kindOf, listOf, MOST_GROUPS, removeGroup, turnedOver, withFlux, withGroup, withRest } from "./edits.js";
import { formulaField } from "./formula-field.js";
import { diagnosticText } from "./status.js";
import { words } from "./words.js";

/** Largest coordinate and flux of the format. */
const FAR = 1e9;

const text = words.boundary;

/**
 * @param {Bench} bench
 * @param {ReturnType<typeof createPreview>} preview of the group that is dragged
 * @returns {Panel}
 */
export function boundaryGroup(bench, preview) {
  const list = h("div", { class: "lab-groups", role: "group", "aria-label": text.list });
  const add = h("button", { type: "button", class: "push", "data-lab-add": "", onclick: addOne }, text.add);
  const faults = h("div", { class: "lab-faults" });
  const details = createDetails(bench);
  const rest = createRest(bench);
  let drawn = "";
  let told = "";

  function addOne() {
    const { groups } = bench.now().document;
    bench.commit((document) => addGroup(document, text.group(groups.length + 1)));
    bench.change({ group: groups.length });
  }

  /** Counts and areas of the groups, and of the rest last. */
  function rowsOf() {
    const { document, known, isCurrent } = bench.now();
    const sets = known && isCurrent ? known.boundary.sets : [];
    return document.groups.map((group, index) => ({ group, set: sets[index] ?? null, count: preview.count(index) }));
  }

  return {
    name: "boundary",
    heading: text.heading,
    body: h("div", {}, faults, list, h("div", { class: "lab-acts" }, add), details.element, rest.element),
    phrase: () => text.phrase(bench.now().document.groups.length),
    render() {
      const { document, known, isCurrent, shown } = bench.now();
      const all = rowsOf();
      const unit = document.unit ?? "";
      const power = known?.boundary.dimension === 2 ? 1 : 2;
      const key = JSON.stringify([all, document.materials, unit]);
      if (key !== drawn) {
        drawn = key;
        const focused = globalThis.document.activeElement instanceof HTMLElement ? globalThis.document.activeElement.dataset.labGroup : undefined;
        list.replaceChildren(
          ...all.map(({ group, set, count }, index) =>
            h(
              "button",
              { type: "button", class: "lab-group", "data-lab-group": String(index), onclick: () => bench.change({ group: bench.now().shown.group === index ? null : index, picking: null }) },
              swatchOf(group.condition, document.materials),
              h("span", { class: "part-name" }, group.name),
              h("span", { class: "number" }, set ? text.count(fixed(set.count, 0), lengthOf(set.measure, unit, power)) : count === null ? "" : fixed(count, 0)),
            ),
          ),
        );
        if (focused !== undefined) /** @type {HTMLElement | null} */ (list.querySelector(`[data-lab-group="${focused}"]`))?.focus();
      }
      for (const [index, button] of [...list.children].entries()) attribute(button, "aria-pressed", String(shown.group === index));
      add.disabled = document.groups.length >= MOST_GROUPS;
      const diagnostics = known && isCurrent ? known.boundary.diagnostics : [];
      const faultKey = JSON.stringify([diagnostics, document.groups.map((group) => group.name), document.model.kind]);
      if (faultKey !== told) {
        told = faultKey;
        const turn = document.model.kind === "mesh" && diagnostics.some(({ code }) => code === "inverted") ? [h("div", { class: "lab-acts" }, h("button", { type: "button", class: "push", "data-lab-turn": "", onclick: () => bench.commit(turnedOver) }, text.turn))] : [];
        faults.replaceChildren(...diagnostics.map((each, nth) => h("p", { class: each.remark ? "lab-fault remark" : "lab-fault", "data-lab-fault": each.code, "data-nth": String(nth) }, diagnosticText(each, document.groups))), ...turn);
      }
      details.render();
      rest.render();
    },
  };
}

/** @param {number} value @param {string} unit @param {number} power */
const lengthOf = (value, unit, power) => (power === 2 ? measure(value, unit, 2) : `${fixed(value, 2)}\u00a0${unit}`.trim());

/** What a condition looks like. @param {Condition} condition @param {readonly {color: string}[]} materials */
function swatchOf(condition, materials) {
  const kind = kindOf(condition);
  const swatch = h("span", { class: `part-swatch lab-swatch ${kind}`, "aria-hidden": "true" });
  const values = listOf(condition);
  if (kind === "value" && !isFormula(condition)) swatch.style.backgroundColor = mixed(materials.map(({ color }) => color), values.map(Number));
  else if (kind === "value") swatch.style.backgroundImage = `linear-gradient(to right in oklab, ${materials.map(({ color }) => color).join(", ")})`;
  return swatch;
}

/**
 * What a condition gives: a mix, fluxes, or formulas.
 * @param {Bench} bench
 * @param {string} name before the names of the controls
 * @param {() => Condition | undefined} read
 * @param {(condition: Condition, run?: string) => void} write
 */
function conditionRows(bench, name, read, write) {
  const mixing = mixingControl({
    change: (mix, run) => write({ value: mix }, run),
    end: bench.endRun,
    cancel: bench.takeBack,
  });
  const fluxes = h("div", {});
  /** @type {ReturnType<typeof numberField>[]} */
  let fields = [];
  const fluxNote = h("p", { class: "lab-note" }, text.fluxNote);
  const formula = formulaField({ name: `${name}-formula`, label: text.formula, note: text.formulaNote }, (list) => {
    const now = read();
    if (now) write("flux" in now ? { flux: list } : { value: list });
  });
  return {
    element: h("div", {}, mixing.element, fluxes, fluxNote, formula.element),
    render() {
      const { materials } = bench.now().document;
      const condition = read();
      const kind = condition && kindOf(condition);
      const isWritten = condition !== undefined && isFormula(condition);
      mixing.element.hidden = kind !== "value" || isWritten;
      fluxes.hidden = fluxNote.hidden = kind !== "flux" || isWritten;
      formula.element.hidden = !condition || kind === "insulated";
      if (!condition) return;
      if (!formula.element.hidden) formula.render(listOf(condition), isWritten);
      if (!mixing.element.hidden) mixing.render({ materials: /** @type {any} */ (materials), mix: listOf(condition).map(Number), used: materials.map((_, k) => k), three: materials.length === 3 ? [0, 1, 2] : null });
      if (fluxes.hidden) return;
      if (fields.length !== materials.length) {
        fields = materials.map((_, k) =>
          numberField(
            { label: text.flux(materials[k].name), name: `${name}-flux-${k}`, min: -FAR, max: FAR, step: 0.1, decimals: 2 },
            { change: (value, run) => write({ flux: withFlux(listOf(/** @type {Condition} */ (read())).map(Number), k, value) }, run), end: bench.endRun, cancel: bench.takeBack },
          ),
        );
        fluxes.replaceChildren(...fields.map((field, k) => row(materials[k].name, field)));
      }
      listOf(condition).forEach((value, k) => fields[k]?.set(Number(value)));
    },
  };
}

/** The chosen group. @param {Bench} bench */
function createDetails(bench) {
  const index = () => bench.now().shown.group;
  const group = () => {
    const { document, shown } = bench.now();
    return shown.group === null ? null : (document.groups[shown.group] ?? null);
  };
  /** @param {Partial<Group>} patch @param {string} [run] */
  const change = (patch, run) => {
    const at = index();
    if (at !== null) bench.commit((document) => withGroup(document, at, patch), run);
  };
  const where = () => group()?.where ?? {};
  const name = textField({ label: text.name, name: "lab-group-name" }, (value) => change({ name: value }));
  const remove = h(
    "button",
    {
      type: "button",
      class: "push",
      "data-lab-remove": "",
      onclick() {
        const at = index();
        if (at === null) return;
        bench.commit((document) => removeGroup(document, at));
        bench.change({ group: null, picking: null });
      },
    },
    text.remove,
  );
  const kind = segment({ label: text.condition, name: "lab-condition", choices: /** @type {const} */ (["value", "flux", "insulated"]).map((value) => ({ value, text: text.kinds[value] })) }, (value) =>
    change({ condition: conditionOf(bench.now().document, group()?.condition, /** @type {ConditionKind} */ (value)) }),
  );
  kind.element.classList.add("wide");
  const condition = conditionRows(bench, "lab", () => group()?.condition, (next, run) => change({ condition: next }, run));
  const by = select({ label: text.where, name: "lab-by", choices: /** @type {const} */ (["direction", "box", "both", "positive", "elements"]).map((value) => ({ value, text: text.by[value] })) }, (value) => {
    const { known } = bench.now();
    if (known && value !== "elements") change({ where: chosenBy(where(), /** @type {Exclude<By, "elements">} */ (value), known.mesh.bounds, known.boundary.dimension) });
    bench.request();
  });
  const editing = (/** @type {(value: number, run?: string) => void} */ put) => ({ change: put, end: bench.endRun, cancel: bench.takeBack });
  const three = (/** @type {string} */ label, /** @type {string} */ of, /** @type {() => number[]} */ read, /** @type {(list: number[], run?: string) => void} */ put) =>
    [0, 1, 2].map((axis) =>
      numberField(
        { label: `${label} ${text.axes[axis]}`, name: `${of}-${text.axes[axis]}`, prefix: text.axes[axis], min: -FAR, max: FAR, step: 0.05, decimals: 2 },
        editing((value, run) => put(read().map((each, k) => (k === axis ? value : each)), run)),
      ),
    );
  const direction = three(text.direction, "lab-direction", () => where().direction ?? [0, 0, 1], (list, run) => change({ where: { ...where(), direction: list } }, run));
  const corner = (/** @type {0 | 1} */ which) =>
    three(text.box[which], `lab-box-${which}`, () => where().box?.[which] ?? [0, 0, 0], (list, run) => change({ where: { ...where(), box: (where().box ?? []).map((each, k) => (k === which ? list : each)) } }, run));
  const corners = [corner(0), corner(1)];
  const angle = slider({ label: text.angle, name: "lab-angle", min: 1, max: 180, step: 1 }, /** @type {any} */ (editing((value, run) => change({ where: { ...where(), angle: value } }, run))));
  const angleField = numberField({ label: text.angle, name: "lab-angle-value", min: 0, max: 180, step: 1, decimals: 0 }, editing((value, run) => change({ where: { ...where(), angle: value } }, run)));
  angleField.element.classList.add("short");
  const positive = textField({ label: text.positive, name: "lab-positive" }, (value) => change({ where: { ...where(), positive: value } }));
  positive.element.classList.add("lab-wide");
  const fieldsOf = (/** @type {ReturnType<typeof numberField>[]} */ fields) => h("div", { class: "lab-fields" }, ...fields.map(({ element }) => element), ...fields.map(({ error }) => error));
  const rows = {
    direction: h("div", {}, h("p", { class: "lab-label" }, text.direction), fieldsOf(direction), row(text.angle, angle, angleField)),
    box: h("div", {}, ...corners.map((fields, k) => h("div", {}, h("p", { class: "lab-label" }, text.box[k]), fieldsOf(fields)))),
    positive: h("div", {}, h("p", { class: "lab-label" }, text.positive), positive.element, h("p", { class: "lab-note" }, text.positiveNote)),
    elements: h("p", { class: "lab-note" }),
  };
  const picking = segment({ label: text.pick, name: "lab-picks", choices: /** @type {const} */ (["direction", "patch"]).map((value) => ({ value, text: text.picks[value] })) }, (value) => bench.change({ picking: /** @type {Picking} */ (value) }));
  picking.element.classList.add("wide");
  const pick = h("button", { type: "button", class: "push", "data-lab-pick": "", onclick: () => bench.change({ picking: bench.now().shown.picking ? null : "direction" }) }, text.pick);
  const pickNote = h("p", { class: "lab-note" }, text.picking);
  const pickRows = h("div", { class: "lab-picks" }, picking.element, pickNote);
  const element = h(
    "div",
    { class: "lab-details", "data-lab-details": "" },
    row(text.name, name),
    h("p", { class: "lab-label" }, text.condition),
    kind.element,
    condition.element,
    row(text.where, by),
    rows.direction,
    rows.box,
    rows.positive,
    rows.elements,
    h("div", { class: "lab-acts" }, pick, remove),
    pickRows,
  );
  return {
    element,
    render() {
      const now = group();
      const { shown, known } = bench.now();
      element.hidden = !now;
      if (!now) return;
      const chosen = byOf(now.where);
      name.set(now.name);
      kind.set(kindOf(now.condition));
      condition.render();
      by.set(chosen);
      for (const option of by.element.querySelectorAll("option")) option.hidden = option.value === "elements" && chosen !== "elements";
      const isFlat = known?.boundary.dimension === 2;
      for (const fields of [direction, ...corners]) fields[2].element.hidden = isFlat;
      rows.direction.hidden = chosen !== "direction" && chosen !== "both";
      rows.box.hidden = chosen !== "box" && chosen !== "both";
      rows.positive.hidden = chosen !== "positive";
      rows.elements.hidden = chosen !== "elements";
      if (now.where.positive !== undefined) positive.set(now.where.positive);
      const { direction: along = [0, 0, 1], angle: within = ANGLE, box, elements = [] } = now.where;
      along.forEach((value, k) => direction[k]?.set(value));
      angle.set(within);
      angleField.set(within);
      box?.forEach((point, which) => point.forEach((value, k) => corners[which]?.[k]?.set(value)));
      write(rows.elements, text.listed(elements.length));
      pickRows.hidden = shown.picking === null;
      attribute(pick, "aria-pressed", String(shown.picking !== null));
      if (shown.picking) picking.set(shown.picking);
    },
  };
}

/** The condition of everything else. @param {Bench} bench */
function createRest(bench) {
  const kind = segment(
    { label: text.rest, name: "lab-rest", choices: /** @type {const} */ (["none", "value", "flux", "insulated"]).map((value) => ({ value, text: text.kindsOfRest[value] })) },
    (value) => bench.commit((document) => withRest(document, value === "none" ? null : conditionOf(document, document.rest, /** @type {ConditionKind} */ (value)))),
  );
  kind.element.classList.add("wide");
  const condition = conditionRows(bench, "lab-rest", () => bench.now().document.rest, (next, run) => bench.commit((document) => withRest(document, next), run));
  return {
    element: h("div", { class: "lab-rest" }, h("p", { class: "lab-label" }, text.rest), kind.element, condition.element),
    render() {
      const { rest } = bench.now().document;
      kind.set(rest ? kindOf(rest) : "none");
      condition.render();
    },
  };
}
