/**
 * The panel that takes shapes over: which ones, how near, with or without corners, and where they go.
 *
 * @import { FittedCurve, ShapeList } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Point } from "../types.js"
 */
import "../../styles/import.css";
import { checkBox, segment } from "../controls/choices.js";
import { row } from "../controls/row.js";
import { slider } from "../controls/slider.js";
import { h, svg, write } from "../dom.js";
import { openDocument } from "../files/open.js";
import { editable, fixed, significantText } from "../format.js";
import { openPanel } from "../frame/panel.js";
import { withCurveInside } from "../harmonic/edits.js";
import { problem } from "../painter.js";
import { curveName } from "../state/app.js";
import { putShape } from "../state/curve-edits.js";
import { isHarmonic } from "../state/look.js";
import { whole } from "../state/selection.js";
import { strings } from "../strings.js";
import { boxOf, firstChoice, isNest, MOST, sizeOf } from "./choose.js";
import { drawPreview, frameOf } from "./picture.js";
import { shapeRow } from "./shape-row.js";
import { words } from "./words.js";

/** Tolerances in per cent of the size of a shape: the ends of the slider, which goes by factors, and the first one. */
const FINEST = 0.02;
const COARSEST = 5;
const FIRST = 0.2;
const STEPS = 100;

/** An error below this share of the size is rounding. */
const EXACT = 1e-9;
/** Digits of coordinates go to a hundredth of the tolerance: more would only be in the way of editing. */
const DIGITS = 0.01;

const PREVIEW = { width: 326, height: 176 };

/** @typedef {FittedCurve | {message: string} | null} Fitted null while it is being fitted */

/**
 * @param {App} app
 * @param {string} name
 * @param {ShapeList} found at least one shape
 * @param {boolean} isList whether they are lists of points rather than a drawing, whose corners are known
 */
export function showShapes(app, name, { shapes, skipped }, isList) {
  /** Indices of the shapes that are taken, the longest chosen first. @type {number[]} */
  let chosen = firstChoice(shapes);
  /** @type {"keep" | "smooth"} */
  let corners = "keep";
  let through = false;
  let percent = FIRST;
  let open = true;
  let asked = 0;
  /** @type {Map<number, Fitted>} */
  const fits = new Map();
  /** @type {Set<number>} shapes whose curve belongs to older settings */
  const stale = new Set();
  // Drawings have their origin in a corner of the page.
  let centered = !isList;

  const rows = shapes.map((shape, index) => shapeRow(shape, index, (on) => toggle(index, on)));

  const preview = svg("svg", { class: "import-preview", viewBox: `0 0 ${PREVIEW.width} ${PREVIEW.height}`, "aria-hidden": "true" });
  const toleranceText = h("span", { class: "import-percent" });
  const tolerance = slider(
    { label: words.tolerance, name: "import-tolerance", min: 0, max: STEPS, step: 1 },
    { change: (value) => change(() => (percent = percentOf(value))) },
  );
  const cornerChoice = segment(
    {
      label: words.corners,
      name: "import-corners",
      choices: [
        { value: "keep", text: words.keep },
        { value: "smooth", text: words.smooth },
      ],
    },
    (value) => change(() => (corners = value)),
  );
  const throughBox = checkBox({ name: "import-through", text: [words.through] }, (on) => change(() => (through = on)));
  const centerBox = checkBox({ name: "import-center", text: [words.center] }, (on) => {
    centered = on;
    render();
  });
  const extent = h("p", { class: "import-note" });
  const button = (/** @type {string} */ act, /** @type {string} */ look, /** @type {() => void} */ run) =>
    h("button", { type: "button", class: look, "data-import": act, onclick: run });
  const opening = button("open", "solid", () => void openNew());
  /** The curves that the buttons speak of. @type {number[]} */
  let targets = [];
  const placing = [0, 1].map((k) => button(`place-${k}`, "outlined", () => put(targets[k])));
  const inside = button("inside", "outlined", putInside);
  const hint = h("p", { class: "import-note", "data-import-hint": "" });

  const panel = openPanel({
    name: "import",
    heading: words.heading(name),
    tall: true,
    body: [
      h("ul", { class: "import-shapes", "aria-label": words.shapes }, ...rows.map(({ element }) => element)),
      ...skippedList(),
      /** @type {any} */ (preview),
      row(words.tolerance, { element: h("span", { class: "import-tolerance" }, tolerance.element, toleranceText) }),
      row(words.corners, { element: cornerChoice.element }),
      ...(isList ? [row("", { element: throughBox.element })] : []),
      row("", { element: centerBox.element }),
      extent,
      h("div", { class: "import-commands" }, opening, ...placing, inside),
      hint,
    ],
    onclose: () => {
      open = false;
      leave();
    },
  });
  if (!panel) {
    // The panel of an earlier import was open: this one takes its place.
    showShapes(app, name, { shapes, skipped }, isList);
    return;
  }
  const leave = app.store.subscribe(render);
  app.say(words.found(shapes.length, skipped.length));
  change(() => {});

  function skippedList() {
    if (skipped.length === 0) return [];
    const items = skipped.map((each) => h("li", {}, h("b", {}, each.name), `: ${each.reason}`));
    return [h("details", { class: "import-skipped" }, h("summary", {}, words.skipped(skipped.length)), h("ul", {}, ...items))];
  }

  /** @param {number} index @param {boolean} on */
  function toggle(index, on) {
    change(() => {
      chosen = chosen.filter((each) => each !== index);
      // Of too many the one that was chosen first gives way.
      if (on) chosen = [...chosen, index].slice(-MOST);
    }, on ? [index] : []);
  }

  /**
   * Changes a setting and fits anew what it concerns: all shapes that are chosen, or the given ones.
   * @param {() => void} set
   * @param {number[]} [concerned]
   */
  function change(set, concerned) {
    set();
    if (!concerned) for (const index of fits.keys()) stale.add(index);
    asked += 1;
    render();
    void fitAll(asked);
  }

  /** @param {number} round */
  async function fitAll(round) {
    for (const index of [...chosen]) {
      if (fits.has(index) && !stale.has(index)) continue;
      const { points, corners: cornerIndices } = shapes[index];
      const size = sizeOf(points);
      /** @type {Fitted} */
      let result;
      try {
        result = await app.kernel.fitCurve(points, {
          tolerance: (percent / 100) * size,
          corners,
          through: isList && through,
          ends: "join",
          ...(isList ? {} : { cornerIndices }),
        });
      } catch (error) {
        result = { message: problem(error).message };
      }
      if (!open || round !== asked) return;
      fits.set(index, result);
      stale.delete(index);
      render();
    }
  }

  /** The chosen shapes, the smallest first. */
  function inOrder() {
    return [...chosen].sort((a, b) => shapes[a].area - shapes[b].area);
  }

  /** The chosen shapes with their curves, from the innermost out. */
  function taken() {
    return inOrder().map((index) => {
      const fitted = fits.get(index);
      const curve = fitted && "curve" in fitted && !stale.has(index) ? fitted.curve : null;
      return { shape: shapes[index], curve };
    });
  }

  function render() {
    const { document } = app.store;
    rows.forEach(({ result, box, element }, index) => {
      const on = chosen.includes(index);
      box.set(on);
      element.classList.toggle("chosen", on);
      const { text, tone } = said(index, on);
      result.className = `import-result ${tone}`;
      write(result, text);
    });
    const value = Math.round((Math.log(percent / FINEST) / Math.log(COARSEST / FINEST)) * STEPS);
    tolerance.set(value);
    tolerance.input.setAttribute("aria-valuetext", words.percent(editable(percent, 0)));
    tolerance.input.disabled = isList && through;
    write(toleranceText, words.percent(editable(percent, 0)));
    cornerChoice.set(corners);
    throughBox.set(through);
    centerBox.set(centered);

    const shown = taken();
    const all = shown.flatMap(({ shape }) => shape.points);
    preview.style.display = all.length > 0 ? "" : "none";
    if (all.length > 0) {
      const shapesShown = shown.map(({ shape, curve }, k) => ({ points: shape.points, curve: curve ?? lastCurve(k) }));
      const held = shapesShown.flatMap(({ curve }) => curve?.points ?? []);
      drawPreview(preview, frameOf([...all, ...held], PREVIEW.width, PREVIEW.height), shapesShown);
      const { low, high } = boxOf(all);
      const size = [high[0] - low[0], high[1] - low[1]].map((v) => significantText(v));
      const middle = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2].map((v) => fixed(v, 2));
      write(extent, words.place(size, document.unit, centered ? null : middle));
    }
    extent.hidden = all.length === 0;

    const ready = shown.length > 0 && shown.every(({ curve }) => curve);
    write(opening, words.open);
    opening.disabled = !ready;
    const isOne = ready && shown.length === 1;
    targets = places();
    placing.forEach((each, k) => {
      const index = targets[k];
      each.hidden = index === undefined;
      write(each, index === undefined ? "" : document.curves[index] ? words.replace(curveName(document, index)) : words.add);
      each.disabled = !isOne;
    });
    write(inside, words.addInside);
    inside.hidden = !isHarmonic(document) || document.curves.length < 2 || document.curves.length >= MOST;
    inside.disabled = !isOne;
    const several = isNest(shown.map(({ shape }) => shape)) ? words.stack : words.harmonic;
    const hinted = [words.chooseSome, "", words.chooseOne][shown.length] ?? several;
    write(hint, hinted);
    hint.hidden = hinted === "";
  }

  /** The curves that one shape may become: of a pair either or the next one, and of more curves the one that is chosen. */
  function places() {
    const { curves } = app.store.document;
    if (curves.length < 2) return Array.from({ length: curves.length + 1 }, (_, index) => index);
    return curves.length === 2 ? [0, 1] : [Math.min(app.ui.value.selection?.curve ?? 0, curves.length - 1)];
  }

  /** The curve of earlier settings, so that the picture does not flicker. @param {number} k */
  function lastCurve(k) {
    const fitted = fits.get(inOrder()[k]);
    return fitted && "curve" in fitted ? fitted.curve : null;
  }

  /** @param {number} index @param {boolean} on */
  function said(index, on) {
    const shape = shapes[index];
    const fitted = fits.get(index);
    const read = `${words.points(shape.points.length)}${shape.closed || isList ? "" : words.wasOpen}`;
    if (!on) return { text: read, tone: "" };
    if (fitted && "message" in fitted) return { text: fitted.message, tone: "import-error" };
    if (!fitted) return { text: words.fitting, tone: "" };
    const isExact = fitted.error < EXACT * sizeOf(shape.points);
    const error = isExact ? words.exact : words.error(significantText(fitted.error), app.store.document.unit);
    const text = `${words.controls(fitted.curve.points.length)}, ${error}`;
    return fitted.simple ? { text, tone: "" } : { text: `${text}. ${words.crosses}`, tone: "warning" };
  }

  /**
   * The chosen curves where they go: as they are, or about the origin.
   * @returns {{name: string, degree: number, form: "periodic", points: Point[], knots: number[]}[]}
   */
  function curves() {
    const shown = taken();
    const { low, high } = boxOf(shown.flatMap(({ shape }) => shape.points));
    const by = centered ? [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2] : [0, 0];
    return shown.flatMap(({ shape, curve }) => {
      if (!curve) return [];
      const digits = isList && through ? 12 : decimals((percent / 100) * sizeOf(shape.points));
      const points = curve.points.map(([x, y]) => /** @type {Point} */ ([rounded(x - by[0], digits), rounded(y - by[1], digits)]));
      return [{ ...curve, name: shape.name, points }];
    });
  }

  async function openNew() {
    const { unit } = app.store.document;
    const all = taken().map(({ shape }) => shape);
    const isStack = isNest(all);
    const last = Math.max(1, all.length - 1);
    // From the first material to the second: curve by curve through a stack, and else from all inner curves to the outer one.
    const graded = curves().map((curve, k) => {
      const share = isStack ? k / last : Math.floor(k / last);
      return { ...curve, composition: [{ at: 0, mix: [1 - share, share] }] };
    });
    const blend = all.length > 2 && !isStack ? { blend: { kind: "harmonic" } } : {};
    const title = name.replace(/\.\w{1,5}$/, "").slice(0, 200) || strings.untitled;
    const raw = { directrix: 1, kind: "curves", title, unit, curves: graded, matching: { method: "exact", oneToOne: true }, ...blend };
    if (await openDocument(app, raw, name, { edited: true })) {
      panel?.close();
      app.say(words.opened(title));
    }
  }

  /** @param {number} index of the curve that the shape replaces, or becomes */
  function put(index) {
    const [curve] = curves();
    if (!curve) return;
    const was = app.store.document.curves[index];
    const { name: shapeName, ...shape } = curve;
    place(index, (document) => named(putShape(document, index, shape), index, was ? undefined : shapeName));
  }

  /** Another inner curve: where it was drawn, or where there is room for it. */
  function putInside() {
    const [curve] = curves();
    if (!curve) return;
    const { document } = app.store;
    const index = document.curves.length;
    const { name: shapeName, ...shape } = curve;
    const next = centered ? withCurveInside(document, shape) : putShape(document, index, shape);
    if (next) {
      place(index, () => named(next, index, shapeName));
      return;
    }
    write(hint, words.noRoom);
    hint.hidden = false;
    app.say(words.noRoom);
  }

  /** @param {number} index @param {(document: CurvesDocument) => CurvesDocument} change */
  function place(index, change) {
    app.store.endRun();
    app.store.commit({ change });
    app.ui.set({ selection: whole(index), fitted: true, view: null });
    panel?.close();
    const { document } = app.store;
    app.say(words.placed(curveName(document, index), document.curves[index].points.length));
  }
}

/**
 * A new curve keeps the name of its shape; one that is replaced has its own.
 * @param {CurvesDocument} document
 * @param {number} index
 * @param {string | undefined} name
 * @returns {CurvesDocument}
 */
function named(document, index, name) {
  if (name === undefined) return document;
  return { ...document, curves: document.curves.map((curve, i) => (i === index ? { ...curve, name } : curve)) };
}

/** @param {number} value of the slider */
function percentOf(value) {
  return Number((FINEST * (COARSEST / FINEST) ** (value / STEPS)).toPrecision(2));
}

/** Decimal places that keep a tolerance to a hundredth. @param {number} tolerance */
const decimals = (tolerance) => Math.min(12, Math.max(0, Math.ceil(-Math.log10(tolerance * DIGITS))));

/** @param {number} value @param {number} places */
const rounded = (value, places) => Number(value.toFixed(places)) + 0;
