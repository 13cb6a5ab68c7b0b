/**
 * The chosen shape in numbers, where it is used, and what it can become.
 *
 * @import { Group } from "../../inspector/group.js"
 * @import { Point } from "../../types.js"
 * @import { WholePart } from "../document.js"
 * @import { Target } from "../edits/convert.js"
 * @import { Use } from "../edits/shapes.js"
 * @import { Bench } from "../state.js"
 * @import { NamedShape } from "./geometry.js"
 */
import { checkBox } from "../../controls/choices.js";
import { numberField } from "../../controls/number-field.js";
import { row } from "../../controls/row.js";
import { select } from "../../controls/select.js";
import { textField } from "../../controls/text-field.js";
import { attribute, h, write } from "../../dom.js";
import { icon, symbol } from "../../icons.js";
import { gridStep } from "../../view.js";
import { converted, targetsOf } from "../edits/convert.js";
import {
  bodyShapes,
  copyName,
  countAll,
  duplicateShape,
  fillHole,
  freshName,
  LONGEST_NAME,
  makeBody,
  makeHole,
  MOST_BODIES,
  MOST_POINTS,
  moveShapes,
  renameShape,
  setAngle,
  setCoordinate,
  setDirection,
  setGeometry,
  setRadius,
  shapeNames,
  shapeOf,
  usesOf,
  whyNotAdd,
  whyNotName,
} from "../edits/shapes.js";
import { canRemove, whyNotInsert } from "../edits/points.js";
import { bodyFor } from "./drawing.js";
import { angleOf, countOf, FAR, handleCount, hasList, isClosed, middleOf, pointsOf } from "./geometry.js";
import { insertAfter, removePoint, removeShape } from "./insert.js";
import { along, arrowStep, movedWith } from "./moves.js";
import { words } from "./words.js";

/** Smallest radius of a field: smaller ones come by dragging. */
const LEAST = 1e-6;
/** Steps of a copy without a view. */
const BESIDE = 5;

const text = words.group;

/** @param {Bench} bench @returns {Group[]} */
export function createShapeGroups(bench) {
  const { app } = bench;
  const now = () => {
    const { document, shown } = bench.now();
    return { document, shown, shape: shapeOf(document, shown.shape) };
  };
  /** A field that edits the chosen shape. @param {(document: WholePart, name: string, value: number) => WholePart} edit */
  const editing = (edit) => ({
    change(/** @type {number} */ value, /** @type {string | undefined} */ run) {
      const { shape } = now();
      if (shape) bench.commit((document) => edit(document, shape.name, value), run);
    },
    end: () => bench.endRun(),
    cancel: (/** @type {string} */ run) => void app.store.cancel(run),
  });
  /** @param {string} name @param {string} label @param {0 | 1} axis @param {(document: WholePart, name: string, value: number) => WholePart} edit */
  const coordinate = (name, label, axis, edit) =>
    numberField(
      { label, name, prefix: symbol(axis === 0 ? "x" : "y"), min: -FAR, max: FAR, step: () => arrowStep(bench.now().document), decimals: 2, rounded: true },
      editing(edit),
    );

  const first = /** @type {const} */ ([0, 1]).map((axis) => coordinate(axis === 0 ? "shape-x" : "shape-y", axis === 0 ? "x" : "y", axis, (document, name, value) => placed(document, name, now().shown.point, axis, value)));
  const second = /** @type {const} */ ([0, 1]).map((axis) => coordinate(axis === 0 ? "shape-x2" : "shape-y2", axis === 0 ? "x" : "y", axis, (document, name, value) => placedSecond(document, name, axis, value)));
  const radius = numberField({ label: text.radius, name: "shape-radius", min: LEAST, max: FAR, step: () => arrowStep(bench.now().document), decimals: 2, rounded: true }, editing(setRadius));
  const angle = numberField({ label: text.angle, name: "shape-angle", prefix: "°", min: -360, max: 360, step: 1, decimals: 1, rounded: true }, editing(setAngle));

  const nameError = h("div", { class: "field-error", role: "alert", hidden: true });
  const name = textField({ label: text.name, name: "shape-name" }, rename);
  name.input.maxLength = LONGEST_NAME;
  name.input.addEventListener("input", () => (nameError.hidden = true));
  const kind = h("span", { class: "fact" });
  const firstRow = row("", ...first);
  const secondRow = row("", ...second);
  const radiusRow = row(text.radius, radius);
  const angleRow = row(text.angle, angle);
  for (const each of [firstRow, secondRow]) each.classList.add("place");

  const command = (/** @type {string} */ act, /** @type {string} */ label, /** @type {() => void} */ run) =>
    h("button", { type: "button", class: "command-word", "data-shape-act": act, onclick: run }, label);
  const step = (/** @type {number} */ by) => {
    const label = by < 0 ? text.previous : text.next;
    return h("button", { type: "button", class: "bare icon-only", "aria-label": label, title: label, "data-shape-act": by < 0 ? "previous" : "next", onclick: () => go(by) }, /** @type {any} */ (icon(by < 0 ? "up" : "down")));
  };
  const add = command("add", text.add, () => {
    const { shape, shown } = now();
    if (shape) void insertAfter(bench, shape.name, shown.point ?? handleCount(shape) - 1);
  });
  const remove = command("remove", text.remove, () => {
    const { shape, shown } = now();
    if (shape && shown.point !== null) removePoint(bench, shape.name, shown.point);
  });
  const pointRow = row("", { element: h("span", { class: "shape-points" }, step(-1), step(1), add, remove) });
  const carry = checkBox({ name: "shape-along", text: [text.along] }, (on) => (along.isOn = on));
  const carryRow = row("", carry);
  const uses = h("span", { class: "shape-uses" });
  const usesRow = row(text.used, { element: uses });
  const turn = h("span", { class: "shape-turn" });
  const turnRow = row(text.convert, { element: turn });
  const duplicate = command("duplicate", text.duplicate, copy);
  const body = command("body", text.body, () => {
    const { document, shape } = now();
    if (shape) bench.commit((doc) => makeBody(doc, shape.name, freshName(document.bodies.map((each) => each.name), shape.name)));
  });
  const hole = command("hole", "", () => {
    const { document, shape, shown } = now();
    const at = shape && bodyFor(document, shown.body, shape);
    if (shape && at !== null && at !== undefined) bench.commit((doc) => makeHole(doc, at, shape.name));
  });
  const fill = command("fill", "", () => {
    const { document, shape } = now();
    const use = shape && usesOf(document, shape.name).find(({ as }) => as === "hole");
    if (use) bench.commit((doc) => fillHole(doc, use.body, shape.name));
  });
  const drop = command("delete", text.delete, () => deleted(false));
  const dropAll = command("delete-all", text.deleteAll, () => deleted(true));
  const commands = h("div", { class: "shape-commands" }, duplicate, body, hole, fill, drop, dropAll);
  const note = h("p", { class: "note" }, text.none);
  const rows = h("div", {}, row(text.name, { element: name.element, error: nameError }), row(text.kind, { element: kind }), firstRow, secondRow, radiusRow, angleRow, pointRow, carryRow, usesRow, turnRow, commands);

  /** @param {string} to */
  function rename(to) {
    const { document, shape } = now();
    if (!shape) return;
    const why = whyNotName(document, shape.name, to);
    write(nameError, why ? text.names[why] : "");
    nameError.hidden = why === null;
    if (why) {
      name.set(shape.name);
      return;
    }
    bench.commit((doc) => renameShape(doc, shape.name, to));
    bench.change({ shape: to });
  }

  /** @param {number} by */
  function go(by) {
    const { shape, shown } = now();
    if (!shape) return;
    const count = handleCount(shape);
    bench.change({ point: shown.point === null ? (by > 0 ? 0 : count - 1) : (shown.point + by + count) % count });
  }

  function copy() {
    const { document, shape } = now();
    if (!shape) return;
    if (whyNotAdd(document, [shape])) return tell(whyNotAdd(document, [shape]) === "shapes" ? words.handles.mostShapes : words.handles.mostPoints);
    const as = copyName(shapeNames(document), shape.name);
    const { view } = bench.now();
    const by = view ? gridStep(view.scale) : arrowStep(document) * BESIDE;
    bench.commit((doc) => duplicateShape(doc, shape.name, as, [by, -by]));
    bench.change({ shape: as, point: null });
    app.say(text.copied(as));
  }

  /** @param {boolean} withUses */
  function deleted(withUses) {
    const { shape } = now();
    if (shape) removeShape(bench, shape.name, withUses);
  }

  /** @param {Target} target */
  function convert(target) {
    const { document, shape } = now();
    const geometry = shape && converted(shape, target);
    if (!shape) return;
    if (!geometry) return tell(text.flat);
    if (countAll(document) - countOf(shape) + countOf(geometry) > MOST_POINTS) return tell(words.handles.mostPoints);
    bench.commit((doc) => setGeometry(doc, shape.name, geometry));
    bench.change({ point: null });
    app.say(text.became(shape.name, words.kind(geometry)));
  }

  /** @param {string} said */
  function tell(said) {
    app.ui.set({ note: { tone: "plain", text: said } });
    app.say(said);
  }

  let drawnUses = "";
  let drawnTargets = "";

  /** @param {WholePart} document @param {NamedShape} shape */
  function renderUses(document, shape) {
    const found = usesOf(document, shape.name);
    const key = JSON.stringify(found.map((use) => [use, useText(document, use)]));
    if (key === drawnUses) return;
    drawnUses = key;
    uses.replaceChildren(
      ...(found.length === 0
        ? [h("span", { class: "aside" }, text.unused)]
        : found.map((use) =>
            h("button", { type: "button", class: "command-word shape-use", "data-shape-use": use.as, onclick: () => bench.change({ body: use.body, feature: use.feature }) }, useText(document, use)),
          )),
    );
  }

  /** @param {WholePart} document @param {NamedShape} shape */
  function renderTargets(document, shape) {
    const isBoundary = usesOf(document, shape.name).some(({ as }) => as === "outline" || as === "hole");
    const targets = targetsOf(shape).filter((target) => !isBoundary || target !== "polyline");
    const choices = targets.map((value) => ({ value, text: targetText(shape, value) }));
    const key = JSON.stringify([shape.name, choices]);
    turnRow.hidden = targets.length === 0;
    if (key === drawnTargets) return;
    drawnTargets = key;
    const control = select({ label: text.convert, name: "shape-turn", choices: [{ value: /** @type {Target | ""} */ (""), text: text.choose }, ...choices] }, (value) => {
      control.set("");
      if (value) convert(value);
    });
    turn.replaceChildren(control.element);
  }

  return [
    {
      name: "shape",
      heading: text.heading,
      body: h("div", { class: "shape-group" }, note, rows),
      phrase: () => now().shape?.name ?? text.phrase,
      render() {
        const { document, shown, shape } = now();
        note.hidden = shape !== undefined;
        rows.hidden = shape === undefined;
        if (!shape) return;
        const { point } = shown;
        if (name.input !== globalThis.document.activeElement) name.set(shape.name);
        write(kind, hasList(shape) ? `${words.kind(shape)}, ${text.points(handleCount(shape))}` : words.kind(shape));
        const at = hasList(shape) ? (point === null ? middleOf(shape) : pointsOf(shape)[point]) : pointsOf(shape)[0];
        write(/** @type {Node} */ (firstRow.firstElementChild), firstLabel(shape, point));
        first.forEach((field, axis) => field.set(at[axis]));
        const also = shape.kind === "segment" ? shape.to : shape.kind === "line" ? shape.direction : null;
        secondRow.hidden = also === null;
        write(/** @type {Node} */ (secondRow.firstElementChild), shape.kind === "line" ? text.direction : text.to);
        if (also) second.forEach((field, axis) => field.set(also[axis]));
        radiusRow.hidden = shape.kind !== "circle";
        if (shape.kind === "circle") radius.set(shape.radius);
        angleRow.hidden = shape.kind !== "line";
        if (shape.kind === "line") angle.set(angleOf(shape));
        pointRow.hidden = !hasList(shape);
        add.disabled = whyNotInsert(document, shape.name) !== null;
        remove.disabled = point === null || !canRemove(document, shape.name);
        renderUses(document, shape);
        renderTargets(document, shape);
        const found = usesOf(document, shape.name);
        const target = isClosed(shape) ? bodyFor(document, shown.body, shape) : null;
        const filled = found.find(({ as }) => as === "hole");
        const isOutline = found.some(({ as }) => as === "outline");
        body.hidden = !isClosed(shape) || isOutline || document.bodies.length >= MOST_BODIES;
        hole.hidden = target === null || isOutline || filled !== undefined;
        if (target !== null) write(hole, text.hole(document.bodies[target].name));
        fill.hidden = filled === undefined;
        if (filled) write(fill, text.fill(document.bodies[filled.body].name));
        carryRow.hidden = bodyShapes(document, shape.name).length < 2;
        carry.set(along.isOn);
        dropAll.hidden = !found.some(({ as }) => as === "outline" || as === "reference");
        attribute(rows, "data-shape", shape.name);
      },
    },
  ];
}

/** @param {NamedShape} shape @param {number | null} point */
function firstLabel(shape, point) {
  switch (shape.kind) {
    case "point":
      return text.at;
    case "line":
      return text.through;
    case "segment":
      return text.from;
    case "circle":
      return text.centre;
    default:
      return point === null ? text.place : text.point(point, handleCount(shape));
  }
}

/**
 * A coordinate of the first place of a shape, of the chosen point of a list, or of the middle of a whole shape, with which it moves.
 * @param {WholePart} document
 * @param {string} name
 * @param {number | null} point
 * @param {0 | 1} axis
 * @param {number} value
 */
function placed(document, name, point, axis, value) {
  const shape = shapeOf(document, name);
  if (!shape) return document;
  const isWhole = shape.kind === "circle" || (hasList(shape) && point === null);
  if (!isWhole) return setCoordinate(document, name, hasList(shape) ? (point ?? 0) : 0, axis, value);
  const by = value - middleOf(shape)[axis];
  return moveShapes(document, movedWith(document, name), axis === 0 ? [by, 0] : [0, by]);
}

/** A coordinate of the end of a segment, or of the direction of a line. @param {WholePart} document @param {string} name @param {0 | 1} axis @param {number} value */
function placedSecond(document, name, axis, value) {
  const shape = shapeOf(document, name);
  if (shape?.kind !== "line") return setCoordinate(document, name, 1, axis, value);
  const direction = /** @type {Point} */ ([...shape.direction]);
  direction[axis] = value;
  return setDirection(document, name, direction);
}

/** @param {WholePart} document @param {Use} use */
function useText({ bodies }, { as, body, feature }) {
  const { name, features = [] } = bodies[body];
  return text.uses[as](name, feature === null ? "" : (features[feature].name ?? ""));
}

/** @param {NamedShape} shape @param {Target} target */
function targetText(shape, target) {
  if (shape.kind === "curve" && target === "control") return text.targets.controlBack;
  if (shape.kind === "curve" && target === "outline") return isClosed(shape) ? text.targets.outline : text.outlineOpen;
  return shape.kind === "circle" && target === "curve" ? text.curveOfCircle : text.targets[target];
}
