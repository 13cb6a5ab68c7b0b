/**
 * The numbers of one operation, to be changed where it stands in the list.
 *
 * @import { App } from "../../state/app.js"
 * @import { BodyDocument } from "../document.js"
 * @import { Operation } from "../edits.js"
 */
import { segment } from "../../controls/choices.js";
import { mixingControl } from "../../controls/mixing.js";
import { numberField } from "../../controls/number-field.js";
import { row } from "../../controls/row.js";
import { h } from "../../dom.js";
import { words } from "./words.js";

const said = words.operations;
/** Largest coordinate of the format, and the places of a subdivision. */
const FAR = 1e9;
const INSIDE = 1e-3;
const AXES = /** @type {const} */ ([0, 1, 2]);

/** The three materials of a triangle, where there are as many. @param {{length: number}} materials @returns {[number, number, number] | null} */
export const threeOf = ({ length }) => (length === 3 ? [0, 1, 2] : null);

/**
 * @param {App} app
 * @param {object} of
 * @param {() => number} of.step of lengths
 * @param {(patch: object, run?: string) => void} of.change
 */
export function createNumbers(app, { step, change }) {
  /** @type {Operation | null} */
  let operation = null;
  const ends = { end: () => app.store.endRun(), cancel: (/** @type {string} */ run) => void app.store.cancel(run) };
  const vector = (/** @type {"by" | "normal"} */ name) => {
    const fields = AXES.map((axis) => {
      const field = numberField(
        { label: said[name]("xyz"[axis]), name: `operation-${name}-${"xyz"[axis]}`, prefix: "xyz"[axis], min: -FAR, max: FAR, step, decimals: 2, rounded: true },
        {
          ...ends,
          change(value, run) {
            const now = /** @type {number[]} */ (/** @type {any} */ (operation)?.[name] ?? [0, 0, 0]);
            change({ [name]: now.map((old, k) => (k === axis ? value : old)) }, run);
          },
        },
      );
      return field;
    });
    const element = h("div", {}, h("div", { class: "body-fields" }, ...fields.map((field) => field.element)), ...fields.map(({ error }) => error));
    return { element, set: (/** @type {readonly number[]} */ values) => fields.forEach((field, axis) => field.set(values[axis])) };
  };
  /** @param {"by" | "at" | "offset"} name @param {string} label @param {number} min @param {number} max */
  const scalar = (name, label, min, max) => {
    const field = numberField(
      { label, name: `operation-${name}`, min, max, step: name === "at" ? 0.05 : step, decimals: 2, rounded: true },
      { ...ends, change: (value, run) => change({ [name]: value }, run) },
    );
    return { element: row(label, field), set: field.set };
  };
  const kinds = /** @type {const} */ (["C1", "C0", "none"]).map((value) => ({ value, text: words.continuity.kinds[value] }));
  const mark = (/** @type {"shape" | "material"} */ what) => {
    const control = segment({ label: said[what], name: `operation-${what}`, choices: kinds }, (value) => change({ [what]: value }));
    return { element: row(said[what], control), set: control.set };
  };
  const rule = segment(
    { label: said.rule, name: "operation-rule", choices: /** @type {const} */ (["flat", "natural"]).map((value) => ({ value, text: words.material[value] })) },
    (value) => change({ rule: value }),
  );
  const parts = {
    by: vector("by"),
    normal: vector("normal"),
    offset: scalar("offset", said.offset, -FAR, FAR),
    length: scalar("by", said.length, 1e-9, FAR),
    at: scalar("at", said.at, INSIDE, 1 - INSIDE),
    shape: mark("shape"),
    material: mark("material"),
    rule: { element: row(said.rule, rule) },
  };
  const mixing = mixingControl({ ...ends, change: (mix, run) => change({ mix }, run) });
  const element = h("div", {}, ...Object.values(parts).map((part) => part.element), mixing.element);

  return {
    element,
    /** @param {Operation} next @param {Pick<BodyDocument, "materials">} document */
    render(next, { materials }) {
      operation = next;
      /** @param {keyof typeof parts} name @param {boolean} isThere */
      const show = (name, isThere) => {
        parts[name].element.hidden = !isThere;
        return isThere;
      };
      if (show("by", next.op === "move" || next.op === "copy")) parts.by.set(/** @type {any} */ (next).by);
      if (show("normal", next.op === "mirror")) parts.normal.set(/** @type {any} */ (next).normal);
      if (show("offset", next.op === "mirror")) parts.offset.set(/** @type {any} */ (next).offset ?? 0);
      if (show("length", next.op === "extrude")) parts.length.set(/** @type {any} */ (next).by);
      if (show("at", next.op === "subdivide")) parts.at.set(/** @type {any} */ (next).at ?? 0.5);
      for (const what of /** @type {const} */ (["shape", "material"])) {
        if (show(what, next.op === "continuity" && next[what] !== undefined)) parts[what].set(/** @type {any} */ (next)[what]);
      }
      if (show("rule", next.op === "slope")) rule.set(/** @type {any} */ (next).rule);
      mixing.element.hidden = next.op !== "mix";
      if (next.op === "mix") mixing.render({ materials, mix: next.mix, used: materials.map((_, i) => i), three: threeOf(materials) });
    },
  };
}
