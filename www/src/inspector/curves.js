/**
 * Curves: the rows, what is selected in numbers, its place, turn and scale, name, height and degree.
 *
 * @import { App } from "../state/app.js"
 * @import { Selection } from "../types.js"
 * @import { Alignment } from "../state/curve-edits.js"
 * @import { Group } from "./group.js"
 */
import { commandItems, commandReason, commandText, commandTitle, cornersOf, runCommand } from "../commands.js";
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { textField } from "../controls/text-field.js";
import { attribute, h, write } from "../dom.js";
import { later } from "../later.js";
import { attachMenu } from "../frame/menu-button.js";
import { curveMark, icon, symbol } from "../icons.js";
import { curveName, pointName } from "../state/app.js";
import { DEGREES, highestDegree, scalePoints, setDegree, turnPoints } from "../state/curve-edits.js";
import { changeCurve, handleCount, movePoints } from "../state/edits.js";
import { hasSpace, isInSpace } from "../state/in-space.js";
import { isHarmonic } from "../state/look.js";
import { middleOf, movedPoints, whole } from "../state/selection.js";
import { strings } from "../strings.js";
import { arrowStep } from "../view.js";
import { editing } from "./edit.js";

/** Largest coordinate and height the format allows. */
const FAR = 1e12;
/** Smallest and largest scale of one entry, in percent. */
const SCALES = { min: 1, max: 10000 };

/** Commands of the menu behind the three dots. */
const MORE = [
  ...["draw", "line", "select-all", "select-curve", "line", "duplicate-point", "duplicate-curve", "rename-curve"],
  ...["reverse-curve", "swap-curves", "smooth-curve", "line", "add-curve", "insert-curve", "line", "delete-curve"],
];

/** @type {Alignment[]} */
const EDGES = ["left", "center", "right", "top", "middle", "bottom"];
/** @type {Alignment[]} */
const SPREADS = ["across", "down"];

/**
 * @param {App} app
 * @returns {Group}
 */
export function curvesGroup(app) {
  const words = strings.curves;
  const selection = () => app.ui.value.selection ?? whole(Math.max(0, app.store.document.curves.length - 1));
  const list = h("div", { class: "curve-rows" });
  /** @type {{button: HTMLElement, name: HTMLElement, shape: HTMLElement}[]} */
  const rows = [];
  const addRow = (/** @type {number} */ index) => {
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
    rows.push({ button, name, shape });
    list.append(h("div", { class: "curve-line" }, button));
  };
  const tools = later(app, () => app.store.document.curves.length > 1, async () => {
    const { createStackRows } = await import("../stack/stack-rows.js");
    return () => createStackRows(app, list);
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
        rounded: true,
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

  const spaceRows = later(app, () => hasSpace(app.store.document), async () => {
    const { createSpaceRows } = await import("./in-space-rows.js");
    return () => createSpaceRows(app, placeRow, nameRow, selection);
  });

  const turn = relative(app, { label: words.turn, name: "turn", prefix: "°", rest: 0, min: -360, max: 360 }, (now, by) =>
    turnPoints(now.document, now.curve, now.points, now.middle, by),
  );
  const scale = relative(app, { label: words.scale, name: "scale", prefix: "%", rest: 100, ...SCALES }, (now, percent) =>
    scalePoints(now.document, now.curve, now.points, now.middle, [percent / 100, percent / 100]),
  );
  const turnRow = row(words.turnScale, turn, scale);

  const align = (/** @type {Alignment} */ how) =>
    h(
      "button",
      {
        type: "button",
        class: "bare icon-only",
        "aria-label": words.alignments[how],
        title: words.alignments[how],
        "data-align": how,
        onclick: async () => (await import("../stage/curve-commands.js")).align(app, how),
      },
      icon(`align-${how}`),
    );
  const group = (/** @type {Alignment[]} */ names) => ({
    element: h("span", { class: "icon-row" }, ...names.map(align)),
  });
  const alignRow = row(words.align, group(EDGES));
  const spreadRow = row(words.spread, group(SPREADS));

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
  const nameRow = row(words.name, name, height);

  const degree = numberField(
    { label: words.degree, name: "degree", ...DEGREES, step: 1, decimals: 0, whole: true },
    editing(app, (document, value) => {
      const { curve } = selection();
      const most = highestDegree(document.curves[curve]);
      if (value > most) {
        const text = words.degreeRange(most);
        app.say(text);
        queueMicrotask(() => app.ui.set({ note: { tone: "plain", text } }));
      }
      return setDegree(document, curve, Math.min(value, most));
    }),
  );
  degree.element.classList.add("short");
  const corners = h("span", { class: "number" });
  const smooth = h(
    "button",
    { type: "button", class: "command-word", "data-action": "smooth", onclick: () => void runCommand(app, "smooth-curve") },
    words.smooth,
  );
  const cornerNote = h("span", { class: "corner-note" }, corners, smooth);
  const degreeRow = row(words.degree, degree, { element: cornerNote });

  const command = (/** @type {string} */ action, /** @type {string} */ named) =>
    h(
      "button",
      { type: "button", class: "command-word", "data-action": action, onclick: () => void runCommand(app, named) },
      commandText(app, named),
    );
  const add = command("add-point", "insert-point");
  const removing = command("remove-point", "delete-points");
  const more = h(
    "button",
    { type: "button", class: "bare icon-only", "aria-label": words.more, title: words.more, "data-action": "more" },
    icon("more"),
  );
  attachMenu(more, () => commandItems(app, MORE));

  const details = h(
    "div",
    {},
    placeRow,
    alignRow,
    spreadRow,
    turnRow,
    nameRow,
    degreeRow,
  );
  const none = h("p", { class: "note" }, words.none);
  const body = h("div", {}, list, none, details);

  return {
    name: "curves",
    heading: words.heading,
    body,
    commands: [add, removing, more],
    phrase: () => words.phrase(app.store.document.curves.map(handleCount)),
    render() {
      const { document } = app.store;
      const chosen = selection();
      const { curve, points } = chosen;
      while (rows.length < document.curves.length) addRow(rows.length);
      rows.forEach((item, index) => {
        const shape = document.curves[index];
        /** @type {HTMLElement} */ (item.button.parentElement).hidden = !shape;
        if (!shape) return;
        write(item.name, curveName(document, index));
        write(item.shape, words.shape(shape.degree, handleCount(shape)));
        attribute(item.button, "aria-pressed", String(index === curve));
      });
      tools.render();
      const shape = document.curves[curve];
      details.hidden = !shape;
      none.hidden = Boolean(shape);
      add.disabled = !shape;
      add.title = commandTitle(app, "insert-point");
      write(removing, commandText(app, "delete-points"));
      removing.title = commandTitle(app, "delete-points");
      removing.disabled = commandReason(app, "delete-points") !== null;
      if (!shape) return;
      const [px, py] = middleOf(document, chosen);
      write(placeLabel, placeName(chosen));
      placeRow.hidden = height.element.hidden = isInSpace(shape);
      spaceRows.render();
      // The harmonic blend lies in one plane.
      const isFlow = isHarmonic(document);
      if (isFlow) height.element.hidden = true;
      write(/** @type {HTMLElement} */ (nameRow.firstElementChild), isFlow ? words.nameField : words.name);
      const decimals = points.length === 1 ? 12 : meanDecimals(arrowStep(document));
      x.set(Number(px.toFixed(decimals)));
      y.set(Number(py.toFixed(decimals)));
      alignRow.hidden = spreadRow.hidden = points.length < 2;
      turnRow.hidden = points.length === 1;
      turn.show();
      scale.show();
      name.set(curveName(document, curve));
      height.set(shape.height);
      degree.set(shape.degree);
      const count = cornersOf(app, curve);
      cornerNote.hidden = count === 0;
      // Degree and corners belong to the whole curve.
      degreeRow.hidden = points.length > 0;
      write(corners, words.corners(count));
    },
  };
}

/** Decimals of a mean, which has any number of its own. @param {number} step of an arrow key */
const meanDecimals = (step) => Math.min(12, Math.max(2, 1 - Math.floor(Math.log10(step))));

/** @param {Selection} selection */
function placeName({ curve, points }) {
  const words = strings.curves;
  if (points.length === 0) return words.center;
  return points.length === 1 ? words.point(pointName(curve, points[0])) : words.several(points.length);
}

/**
 * A field for a change that has no value of its own: it counts from the curves as they were when the entry began, and
 * goes back to rest when it is left.
 * @param {App} app
 * @param {{label: string, name: string, prefix: string, rest: number, min: number, max: number}} options
 * @param {(now: {document: import("../types.js").CurvesDocument, curve: number, points: number[],
 *   middle: import("../types.js").Point}, value: number) => import("../types.js").CurvesDocument} change
 */
function relative(app, { rest, ...options }, change) {
  let value = rest;
  /** @type {import("../types.js").Curve[] | null} */
  let start = null;
  /** @type {string | undefined} */
  let runNow;
  const over = () => {
    value = rest;
    start = null;
    runNow = undefined;
  };
  const field = numberField(
    { ...options, step: 1, decimals: 0 },
    {
      change(next, run) {
        const { selection } = app.ui.value;
        if (!selection) return;
        if (run === undefined || run !== runNow) over();
        const curves = (start ??= app.store.document.curves);
        runNow = run;
        value = run === undefined ? rest : next;
        app.store.commit({
          ...(run === undefined ? {} : { run }),
          change: (document) => {
            const now = { ...document, curves };
            const points = movedPoints(now, selection);
            const next2 = change({ document: now, curve: selection.curve, points, middle: middleOf(now, selection) }, next);
            return next2 === now ? document : next2;
          },
        });
        if (run === undefined) over();
        field.set(value);
      },
      end() {
        over();
        app.store.endRun();
        field.set(value);
      },
      cancel(run) {
        app.store.cancel(run);
        over();
        field.set(value);
      },
    },
  );
  return { ...field, show: () => field.set(value) };
}
