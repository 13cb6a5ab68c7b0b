/**
 * What changes a figure of a body: which coefficient, its coordinates and what moves with it, a twist, the material of a row, and the place
 * that is marked.
 *
 * @import { Figure } from "../../../scripts/lib/lesson.mjs"
 * @import { Vector } from "../space/vector.js"
 * @import { Chosen, Reach, Rule, Shares } from "./body-edits.js"
 *
 * @typedef {object} State What the controls show.
 * @property {Vector} uvw
 * @property {readonly number[]} own position of the chosen coefficient
 * @property {Chosen} chosen
 * @property {Chosen[]} choices coefficients to be chosen from
 * @property {Reach | null} reach
 * @property {number} twist
 * @property {Shares} shares
 * @property {Rule | null} rule
 * @property {number} halvings
 *
 * @typedef {object} Acts
 * @property {(axis: number, value: number) => void} place
 * @property {(chosen: Chosen) => void} choose
 * @property {(axis: number, value: number) => void} moveTo
 * @property {() => void} rest a drag of a field is over
 * @property {() => number} nudge step of a coordinate
 * @property {(reach: Reach) => void} reach
 * @property {(degrees: number) => void} twist
 * @property {(shares: Partial<Shares>) => void} shares
 * @property {(rule: Rule) => void} rule
 * @property {(count: number) => void} halve
 */
import { segment } from "../controls/choices.js";
import { numberField } from "../controls/number-field.js";
import { select } from "../controls/select.js";
import { h } from "../dom.js";
import { fixed } from "../format.js";
import { label as named, parameter } from "./parameter.js";
import { words } from "./words-body.js";

/** Steps of the sliders of parameters and fractions, and of a twist in degrees; most halvings of a cell. */
const STEP = 0.01;
const TURN = 5;
const HALVINGS = 24;

/** @param {Chosen} chosen */
const keyOf = ({ cell, at }) => `${cell} ${at.join(" ")}`;

/**
 * @param {Figure} figure
 * @param {HTMLElement | null} reading
 * @param {Acts} acts
 */
export function createBodyControls(figure, reading, acts) {
  const canMove = figure.controls === "full";
  /**
   * @param {string} name
   * @param {string} label
   * @param {Node} shown
   * @param {{max: number, step: number, text: (value: number) => string}} range
   * @param {(value: number) => void} change
   */
  const labelled = (name, label, shown, { max, step, text }, change) => {
    const { row, set } = parameter({ label, shown, name, max, step }, change);
    return { row, set: (/** @type {number} */ next) => set(next, text(next)) };
  };
  const share = { max: 1, step: STEP, text: (/** @type {number} */ value) => fixed(value, 2) };
  const sliders = /** @type {const} */ (["u", "v", "w"]).map((name, axis) =>
    labelled(name, words.parameter(name), h("i", {}, name), share, (next) => acts.place(axis, next)),
  );
  const twist = labelled("twist", words.twist, named(words.twist), { max: 180, step: TURN, text: (value) => `${fixed(value, 0)}°` }, acts.twist);
  const halvings = labelled("halvings", words.halvings, named(words.halvings), { max: HALVINGS, step: 1, text: (value) => fixed(value, 0) }, acts.halve);
  const before = labelled("before", words.before, named(words.before), share, (next) => acts.shares({ before: next }));
  const at = labelled("at", words.at, named(words.at), share, (next) => acts.shares({ at: next }));
  const fields = /** @type {const} */ (["x", "y", "z"]).map((name, axis) =>
    numberField(
      { label: words.coordinate(name), name: `lesson-${name}`, prefix: name, min: -1000, max: 1000, step: () => acts.nudge() / 2, decimals: 2, rounded: true },
      { change: (next) => acts.moveTo(axis, next), end: () => acts.rest() },
    ),
  );
  const which = h("span", { class: "cell-which" });
  const reach = select(
    { label: words.reach, name: "lesson-reach", choices: /** @type {Reach[]} */ (["block", "pair", "single"]).map((value) => ({ value, text: words.reaches[value] })) },
    acts.reach,
  );
  reach.element.classList.add("cell-reach");
  const rule = segment(
    { label: words.rule, name: "lesson-rule", choices: /** @type {Rule[]} */ (["reflect", "flat", "natural"]).map((value) => ({ value, text: words.rules[value] })) },
    acts.rule,
  );
  const element = h(
    "div",
    { class: "cell-controls" },
    canMove ? h("div", { class: "cell-coefficient" }, named(words.which), which, ...fields.map(({ element }) => element), ...fields.map(({ error }) => error)) : null,
    canMove && figure.reach ? h("div", { class: "cell-coefficient" }, named(words.reach), reach.element) : null,
    figure.twist === null ? null : h("div", { class: "cell-parameters" }, twist.row),
    figure.rule ? h("div", { class: "cell-coefficient" }, named(words.rule), rule.element) : null,
    figure.rule ? h("div", { class: "cell-parameters" }, before.row, at.row) : null,
    figure.point ? h("div", { class: "cell-parameters" }, ...sliders.map(({ row }) => row)) : null,
    figure.reading === "certificate" ? h("div", { class: "cell-parameters" }, halvings.row) : null,
    reading,
  );
  let listed = "";
  /** @type {ReturnType<typeof select> | null} */
  let list = null;

  /** @param {Chosen[]} choices */
  function offer(choices) {
    const keys = choices.map(keyOf);
    if (String(keys) === listed) return;
    listed = String(keys);
    const hasMany = new Set(choices.map(({ cell }) => cell)).size > 1;
    const named = choices.map((each, n) => ({ value: keys[n], text: hasMany ? words.ofCell(each.at, each.cell) : words.coefficient(each.at) }));
    list = select({ label: words.which, name: "lesson-coefficient", choices: named }, (value) => acts.choose(choices[keys.indexOf(value)]));
    which.replaceChildren(list.element);
  }

  return {
    element: element.childElementCount > 0 && figure.controls !== "none" ? element : null,
    /** @param {State} state */
    render(state) {
      if (canMove) {
        offer(state.choices);
        list?.set(keyOf(state.chosen));
        fields.forEach(({ set }, axis) => set(state.own[axis]));
      }
      if (state.reach) reach.set(state.reach);
      if (state.rule) rule.set(state.rule);
      before.row.hidden = state.rule !== "reflect";
      before.set(state.shares.before);
      at.set(state.shares.at);
      twist.set(state.twist);
      halvings.set(state.halvings);
      sliders.forEach(({ set }, axis) => set(state.uvw[axis]));
    },
  };
}
