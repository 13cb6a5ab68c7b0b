/**
 * What stands below a figure of a body: of a place the sum of the weighted coefficients, the material, or the Jacobian; of the body what
 * body-reading.js has.
 *
 * @import { CellVerdict, Material } from "../../../js/directrix.js"
 * @import { Cell } from "../hyperpatch/document.js"
 * @import { Vector } from "../space/vector.js"
 * @import { Rule, Shares } from "./body-edits.js"
 * @import { Known } from "./body-known.js"
 *
 * @typedef {object} State
 * @property {Cell} cell the one of the figure
 * @property {Cell[]} cells
 * @property {Vector} uvw
 * @property {Material[]} materials
 * @property {CellVerdict | null} verdict null until the kernel has judged the cell as it stands
 * @property {Known | null} known null until the kernel has answered for the body as it stands
 * @property {Shares} shares
 * @property {Rule | null} rule
 * @property {number} halvings
 */
import { h } from "../dom.js";
import { coordinate, fixed } from "../format.js";
import { sampleAt } from "../hyperpatch/cell.js";
import { INDICES, jacobianAt, leastAtCorners, weightsAt } from "./cell-sum.js";
import { READINGS } from "./body-reading.js";
import { words } from "./words-body.js";

/** Rows of single coefficients, those with the greatest weights. */
const ROWS = 5;

/** @param {"weights" | "material" | "jacobian" | keyof typeof READINGS} kind */
export function createReading(kind) {
  const element = h("div", { class: "cell-reading", "data-reading": kind });
  let shown = "";
  return {
    element,
    /** @param {State} state */
    render(state) {
      const key = JSON.stringify([state.cells, state.uvw, state.verdict, state.known?.moving, state.known?.around?.joints, state.known?.measures, state.shares, state.rule, state.halvings]);
      if (key === shown) return;
      shown = key;
      element.replaceChildren(...[({ weights, material, jacobian, ...READINGS })[kind](state)].flat());
    },
  };
}

/** @param {readonly number[]} position */
const placeText = (position) => `(${position.map(coordinate).join(", ")})`;

/** @param {string[]} head @param {{name: string, cells: string[], strong?: boolean}[]} rows */
function table(head, rows) {
  return h(
    "table",
    {},
    h("thead", {}, h("tr", {}, ...head.map((text) => h("th", { scope: "col" }, text)))),
    h("tbody", {}, ...rows.map(row)),
  );
}

/** @param {{name: string, cells: string[], strong?: boolean}} row */
function row({ name, cells, strong }) {
  const values = cells.map((text) => h("td", { class: "number" }, text));
  return h("tr", { class: strong ? "sum" : "" }, h("th", { scope: "row" }, name), ...values);
}

/** The greatest weights, the others together, and the whole sum. @param {State} state */
function weights({ cell, uvw }) {
  const all = weightsAt(uvw).map((weight, n) => ({ weight, index: INDICES[n], position: cell.coefficients[n].position }));
  const sorted = [...all].sort((a, b) => b.weight - a.weight);
  const part = (/** @type {typeof all} */ some) => [0, 1, 2].map((axis) => some.reduce((sum, { weight, position }) => sum + weight * position[axis], 0));
  const rest = sorted.slice(ROWS);
  const says = words.table;
  return table(
    [says.coefficient, says.weight, says.position, says.product],
    [
      ...sorted.slice(0, ROWS).map((each) => ({ name: words.coefficient(each.index), cells: [fixed(each.weight, 3), placeText(each.position), placeText(part([each]))] })),
      { name: says.others(rest.length), cells: [fixed(rest.reduce((sum, { weight }) => sum + weight, 0), 3), "", placeText(part(rest))] },
      { name: says.sum, cells: [fixed(all.reduce((sum, { weight }) => sum + weight, 0), 3), "", placeText(part(all))], strong: true },
    ],
  );
}

/** Where the place lies, and what it is made of. @param {State} state */
function material({ cell, uvw, materials }) {
  const { position, mix } = sampleAt(cell, uvw, materials.length);
  return h(
    "dl",
    {},
    h("dt", {}, words.table.place),
    h("dd", { class: "number", "data-lesson": "place" }, placeText(position)),
    ...materials.flatMap(({ name, color }, m) => {
      const swatch = h("span", { class: "cell-swatch" });
      swatch.style.background = color;
      return [h("dt", {}, swatch, name), h("dd", { class: "number", "data-lesson": `mix-${m}` }, `${fixed(100 * mix[m], 1)}\u00a0%`)];
    }),
  );
}

/** The Jacobian here, at the corners, and what is proven of it everywhere. @param {State} state */
function jacobian({ cell, uvw, verdict }) {
  const says = words.table;
  const row = (/** @type {string} */ name, /** @type {number | null} */ value, /** @type {string} */ key) => [
    h("dt", {}, name),
    h("dd", { class: `number${value !== null && value < 0 ? " failed" : ""}`, "data-lesson": key }, value === null ? "…" : fixed(value, 3)),
  ];
  return h(
    "dl",
    {},
    ...row(says.here, jacobianAt(cell, uvw), "jacobian"),
    ...row(says.corners, leastAtCorners(cell), "jacobian-corners"),
    ...row(says.least, verdict && verdict.leastJacobianBound, "jacobian-least"),
  );
}
