/**
 * Curves: the two rows, the selected point or the whole curve in numbers, name and height.
 *
 * @import { App } from "../state/app.js"
 * @import { Curve, Point } from "../types.js"
 * @import { Group } from "./group.js"
 */
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { textField } from "../controls/text-field.js";
import { attribute, h, write } from "../dom.js";
import { curveMark, symbol } from "../icons.js";
import { curveName, pointName } from "../state/app.js";
import { canRemovePoint, changeCurve, handleCount, moveCurve, movePoint } from "../state/edits.js";
import { centerOf } from "../stage/handles.js";
import { insertAfter, remove } from "../stage/points.js";
import { strings } from "../strings.js";
import { arrowStep } from "../view.js";
import { editing } from "./edit.js";

/** Largest coordinate and height the format allows. */
const FAR = 1e12;

/**
 * @param {App} app
 * @returns {Group}
 */
export function curvesGroup(app) {
  const words = strings.curves;
  const selection = () => app.ui.value.selection ?? { curve: /** @type {0 | 1} */ (1), point: null };
  const rows = /** @type {const} */ ([0, 1]).map((index) => {
    const name = h("span", {});
    const shape = h("span", { class: "aside number" });
    const button = h(
      "button",
      {
        type: "button",
        class: "curve-row",
        "data-curve-row": index,
        onclick: () => app.ui.set({ selection: { curve: index, point: null } }),
      },
      /** @type {any} */ (curveMark(index)),
      name,
      shape,
    );
    return { button, name, shape };
  });

  const place = (/** @type {0 | 1} */ axis) =>
    numberField(
      {
        label: axis === 0 ? "x" : "y",
        name: axis === 0 ? "x" : "y",
        prefix: symbol(axis === 0 ? "x" : "y"),
        min: -FAR,
        max: FAR,
        step: () => arrowStep(app.store.document),
        decimals: 2,
      },
      editing(app, (document, value) => {
        const { curve, point } = selection();
        const shape = document.curves[curve];
        if (point === null) {
          const by = value - centerOf(shape)[axis];
          return moveCurve(document, curve, axis === 0 ? [by, 0] : [0, by]);
        }
        const to = /** @type {Point} */ ([...(shape.points[point] ?? [0, 0])]);
        to[axis] = value;
        return movePoint(document, curve, point, to);
      }),
    );
  const x = place(0);
  const y = place(1);
  const placeRow = row("", x, y);
  placeRow.classList.add("place");
  const placeLabel = /** @type {HTMLElement} */ (placeRow.firstElementChild);

  const name = textField({ label: words.nameField, name: "curve-name" }, (text) =>
    app.store.commit({
      change: (document) => changeCurve(document, selection().curve, (curve) => ({ ...curve, name: text })),
    }),
  );
  const height = numberField(
    {
      label: words.height,
      name: "height",
      min: -FAR,
      max: FAR,
      step: () => arrowStep(app.store.document),
      decimals: 1,
    },
    editing(app, (document, value) =>
      changeCurve(document, selection().curve, (curve) =>
        curve.height === value ? curve : { ...curve, height: value },
      ),
    ),
  );
  height.element.classList.add("short");

  const command = (/** @type {string} */ action, /** @type {string} */ text, /** @type {string} */ title) =>
    h("button", { type: "button", class: "command-word", title, "data-action": action }, text);
  const add = command("add-point", words.add, words.addHelp);
  const removing = command("remove-point", words.remove, words.removeHelp);
  add.addEventListener("click", () => {
    const { curve, point } = selection();
    void insertAfter(app, curve, point ?? 0);
  });
  removing.addEventListener("click", () => {
    const { curve, point } = selection();
    if (point !== null) remove(app, curve, point);
  });

  const body = h("div", {}, ...rows.map(({ button }) => button), placeRow, row(words.name, name, height));

  return {
    name: "curves",
    heading: words.heading,
    body,
    commands: [add, removing],
    phrase() {
      const [a, b] = app.store.document.curves;
      return words.phrase(handleCount(a), handleCount(b));
    },
    render() {
      const { document } = app.store;
      const { curve, point } = selection();
      rows.forEach((item, index) => {
        const shape = /** @type {Curve} */ (document.curves[index]);
        write(item.name, curveName(document, index));
        write(item.shape, words.shape(shape.degree, handleCount(shape)));
        attribute(item.button, "aria-pressed", String(index === curve));
      });
      const shape = document.curves[curve];
      const at = point === null ? centerOf(shape) : shape.points[point];
      write(placeLabel, point === null ? words.center : words.point(pointName(curve, point)));
      if (at) {
        x.set(at[0]);
        y.set(at[1]);
      }
      name.set(curveName(document, curve));
      height.set(shape.height);
      removing.disabled = point === null || !canRemovePoint(shape);
      if (!removing.disabled) removing.title = words.removeHelp;
      else removing.title = point === null ? words.removeNone : strings.handles.tooFew(shape.degree);
    },
  };
}
