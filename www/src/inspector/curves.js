/**
 * Curves: the two rows, the selected point or the whole curve in numbers, name and height.
 *
 * @import { App } from "../state/app.js"
 * @import { Selection } from "../types.js"
 * @import { Group } from "./group.js"
 */
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { textField } from "../controls/text-field.js";
import { attribute, h, write } from "../dom.js";
import { curveMark, symbol } from "../icons.js";
import { curveName, pointName } from "../state/app.js";
import { canRemovePoints, changeCurve, handleCount, movePoints } from "../state/edits.js";
import { middleOf, movedPoints, whole } from "../state/selection.js";
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
  const selection = () => app.ui.value.selection ?? whole(app.store.document.curves.length === 2 ? 1 : 0);
  const rows = /** @type {const} */ ([0, 1]).map((index) => {
    const name = h("span", {});
    const shape = h("span", { class: "aside number" });
    const button = h(
      "button",
      {
        type: "button",
        class: "curve-row",
        "data-curve-row": index,
        onclick: () => app.ui.set({ selection: whole(index) }),
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
        const chosen = selection();
        const by = value - middleOf(document, chosen)[axis];
        return movePoints(document, chosen.curve, movedPoints(document, chosen), axis === 0 ? [by, 0] : [0, by]);
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
    const { curve, points } = selection();
    void insertAfter(app, curve, points[0] ?? 0);
  });
  removing.addEventListener("click", () => {
    const { curve, points } = selection();
    if (points.length > 0) remove(app, curve, points);
  });

  const details = h("div", {}, placeRow, row(words.name, name, height));
  const none = h("p", { class: "note" }, words.none);
  const body = h("div", {}, ...rows.map(({ button }) => button), none, details);

  return {
    name: "curves",
    heading: words.heading,
    body,
    commands: [add, removing],
    phrase: () => words.phrase(app.store.document.curves.map(handleCount)),
    render() {
      const { document } = app.store;
      const chosen = selection();
      const { curve, points } = chosen;
      rows.forEach((item, index) => {
        const shape = document.curves[index];
        item.button.hidden = !shape;
        if (!shape) return;
        write(item.name, curveName(document, index));
        write(item.shape, words.shape(shape.degree, handleCount(shape)));
        attribute(item.button, "aria-pressed", String(index === curve));
      });
      const shape = document.curves[curve];
      details.hidden = !shape;
      none.hidden = Boolean(shape);
      add.disabled = !shape;
      removing.disabled = !shape || points.length === 0 || !canRemovePoints(shape, points.length);
      if (!removing.disabled) removing.title = words.removeHelp;
      else removing.title = shape && points.length > 0 ? strings.handles.tooFew(shape.degree) : words.removeNone;
      if (!shape) return;
      const [px, py] = middleOf(document, chosen);
      write(placeLabel, placeName(chosen));
      x.set(px);
      y.set(py);
      name.set(curveName(document, curve));
      height.set(shape.height);
    },
  };
}

/** @param {Selection} selection */
function placeName({ curve, points }) {
  const words = strings.curves;
  if (points.length === 0) return words.center;
  return points.length === 1 ? words.point(pointName(curve, points[0])) : words.several(points.length);
}
