/**
 * The panel that takes shapes from elsewhere into the open part: which ones, as polygons or as curves, how near, and what for.
 *
 * @import { PartShape, ShapeList } from "../../../../js/directrix.js"
 * @import { App } from "../../state/app.js"
 * @import { Point } from "../../types.js"
 * @import { Purpose } from "./drawing.js"
 */
import "../../../styles/import.css";
import { checkBox, segment } from "../../controls/choices.js";
import { row } from "../../controls/row.js";
import { slider } from "../../controls/slider.js";
import { h, svg, write } from "../../dom.js";
import { editable, fixed, significantText } from "../../format.js";
import { openPanel } from "../../frame/panel.js";
import { boxOf, sizeOf } from "../../import/choose.js";
import { drawPreview, frameOf } from "../../import/picture.js";
import { shapeRow } from "../../import/shape-row.js";
import { words as common } from "../../import/words.js";
import { problem } from "../../painter.js";
import { partOf } from "../document.js";
import { thinned } from "../edits/convert.js";
import { namedFor, withImported } from "../edits/imported.js";
import { whyNotAdd } from "../edits/shapes.js";
import { extentOf } from "../state.js";
import { bodyFor } from "./drawing.js";
import { keptPoint } from "./geometry.js";
import { words } from "./import-words.js";

/** Tolerances in per cent of the size of a shape: the ends of the slider, which goes by factors, and the first one. */
const FINEST = 0.02;
const COARSEST = 5;
const FIRST = 0.2;
const STEPS = 100;
const PREVIEW = { width: 326, height: 176 };

/** @typedef {{shape: PartShape} | {message: string} | null} Made null while it is being made */

/**
 * @param {App} app whose document is a part
 * @param {string} name of the file
 * @param {ShapeList} found at least one shape
 * @param {boolean} isList whether they are lists of points rather than a drawing, whose corners are known
 */
export function showPartImport(app, name, found, isList) {
  const { shapes, skipped } = found;
  const document = () => partOf(app);
  /** @type {Set<number>} */
  const chosen = new Set(shapes.keys());
  /** @type {"polygon" | "curve"} */
  let as = "polygon";
  /** @type {Purpose} */
  let purpose = document().bodies.length === 0 ? "body" : "reference";
  let percent = FIRST;
  // Drawings have their origin in a corner of the page.
  let centered = !isList;
  let asked = 0;
  let isOpen = true;
  /** @type {Map<number, Made>} */
  const made = new Map();

  const rows = shapes.map((shape, index) =>
    shapeRow(shape, index, (on) => {
      if (on) chosen.add(index);
      else chosen.delete(index);
      change(() => {});
    }),
  );
  const preview = svg("svg", { class: "import-preview", viewBox: `0 0 ${PREVIEW.width} ${PREVIEW.height}`, "aria-hidden": "true" });
  const kind = segment(
    { label: words.as, name: "import-as", choices: /** @type {("polygon" | "curve")[]} */ (["polygon", "curve"]).map((value) => ({ value, text: words[value] })) },
    (value) => change(() => (as = value)),
  );
  const use = segment(
    { label: words.use, name: "import-use", choices: /** @type {Purpose[]} */ (["reference", "body", "hole"]).map((value) => ({ value, text: words[value] })) },
    (value) => {
      purpose = value;
      render();
    },
  );
  const toleranceText = h("span", { class: "import-percent" });
  const tolerance = slider({ label: common.tolerance, name: "import-tolerance", min: 0, max: STEPS, step: 1 }, {
    change: (value) => change(() => (percent = Number((FINEST * (COARSEST / FINEST) ** (value / STEPS)).toPrecision(2)))),
  });
  const centerBox = checkBox({ name: "import-center", text: [words.center] }, (on) => {
    centered = on;
    render();
  });
  const place = h("p", { class: "import-note" });
  const adding = h("button", { type: "button", class: "solid", "data-import": "add", onclick: add }, "");
  const hint = h("p", { class: "import-note", "data-import-hint": "" });
  const panel = openPanel({
    name: "import",
    heading: common.heading(name),
    tall: true,
    body: [
      h("ul", { class: "import-shapes", "aria-label": common.shapes }, ...rows.map(({ element }) => element)),
      ...(skipped.length === 0
        ? []
        : [h("details", { class: "import-skipped" }, h("summary", {}, common.skipped(skipped.length)), h("ul", {}, ...skipped.map((each) => h("li", {}, h("b", {}, each.name), `: ${each.reason}`))))]),
      /** @type {any} */ (preview),
      row(words.as, { element: kind.element }),
      row(common.tolerance, { element: h("span", { class: "import-tolerance" }, tolerance.element, toleranceText) }),
      row(words.use, { element: use.element }),
      row("", { element: centerBox.element }),
      place,
      h("div", { class: "import-commands" }, adding),
      hint,
    ],
    onclose: () => {
      isOpen = false;
      leave();
    },
  });
  if (!panel) {
    // The panel of an earlier import was open: this one takes its place.
    showPartImport(app, name, found, isList);
    return;
  }
  const leave = app.store.subscribe(render);
  app.say(common.found(shapes.length, skipped.length));
  change(() => {});

  /** Changes a setting and makes what is chosen anew. @param {() => void} set */
  function change(set) {
    set();
    asked += 1;
    made.clear();
    render();
    void makeAll(asked);
  }

  /** @param {number} round */
  async function makeAll(round) {
    for (const index of chosen) {
      /** @type {Made} */
      let result;
      try {
        result = { shape: await make(index) };
      } catch (error) {
        result = { message: problem(error).message };
      }
      if (!isOpen || round !== asked) return;
      made.set(index, result);
      render();
    }
  }

  /** @param {number} index @returns {Promise<PartShape>} */
  async function make(index) {
    const { points, corners: cornerIndices } = shapes[index];
    const size = sizeOf(points);
    const far = (percent / 100) * size;
    if (as === "polygon") {
      // The chain is closed, and opened again where it begins.
      const kept = thinned([...points, points[0]], far).slice(0, -1);
      return { kind: "polygon", points: (kept.length >= 3 ? kept : points).map(keptPoint) };
    }
    const { curve } = await app.kernel.fitCurve(points, { tolerance: far, corners: "keep", ends: "join", ...(isList ? {} : { cornerIndices }) });
    return { kind: "curve", degree: curve.degree, form: curve.form, points: curve.points, ...(curve.knots ? { knots: curve.knots } : {}) };
  }

  /** Where all goes to. @returns {{middle: Point, by: Point, size: [number, number]}} */
  function placeNow() {
    const { low, high } = boxOf([...chosen].flatMap((index) => shapes[index].points));
    const middle = /** @type {Point} */ ([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2]);
    const size = /** @type {[number, number]} */ ([high[0] - low[0], high[1] - low[1]]);
    if (!centered) return { middle, by: [0, 0], size };
    const extent = extentOf(document());
    const to = extent ? /** @type {Point} */ ([(extent[0][0] + extent[1][0]) / 2, (extent[0][1] + extent[1][1]) / 2]) : /** @type {Point} */ ([0, 0]);
    return { middle: to, by: [to[0] - middle[0], to[1] - middle[1]], size };
  }

  /** The chosen shapes where they go, with names of their own; null while some are being made or cannot be. */
  function taken() {
    const { by } = placeNow();
    const list = [...chosen].sort((a, b) => shapes[b].area - shapes[a].area).map((index) => {
      const found = made.get(index);
      return found && "shape" in found && "points" in found.shape ? { name: shapes[index].name, shape: found.shape, digits: decimals((percent / 100) * sizeOf(shapes[index].points)) } : null;
    });
    if (list.length === 0 || list.includes(null)) return null;
    return namedFor(
      document(),
      list.flatMap((each) => {
        if (!each || !("points" in each.shape)) return [];
        const moved = each.shape.points.map(([x, y]) => /** @type {Point} */ ([rounded(x + by[0], each.digits), rounded(y + by[1], each.digits)]));
        return [{ name: each.name, shape: /** @type {PartShape} */ ({ ...each.shape, points: moved }) }];
      }),
    );
  }

  function add() {
    const list = taken();
    if (!list || why(list)) return;
    const body = purpose === "hole" ? bodyFor(document(), null, list[0]) : null;
    app.store.endRun();
    app.store.commit({ change: (now) => /** @type {any} */ (withImported(/** @type {any} */ (now), list, purpose, body)) });
    app.ui.set({ view: null, fitted: true });
    panel?.close();
    app.say(words.added(list.length));
  }

  /** @param {readonly PartShape[]} list */
  function why(list) {
    const full = whyNotAdd(document(), list);
    if (full) return full === "shapes" ? words.mostShapes : words.mostPoints;
    return purpose === "hole" && document().bodies.length === 0 ? words.noBody : null;
  }

  function render() {
    rows.forEach(({ result, box, element }, index) => {
      const on = chosen.has(index);
      const now = made.get(index);
      box.set(on);
      element.classList.toggle("chosen", on);
      result.className = `import-result ${now && "message" in now ? "import-error" : ""}`;
      const count = now && "shape" in now && "points" in now.shape ? now.shape.points.length : shapes[index].points.length;
      write(result, now && "message" in now ? now.message : on && !now ? common.fitting : words.points(count));
    });
    kind.set(as);
    use.set(purpose);
    centerBox.set(centered);
    tolerance.set(Math.round((Math.log(percent / FINEST) / Math.log(COARSEST / FINEST)) * STEPS));
    tolerance.input.setAttribute("aria-valuetext", common.percent(editable(percent, 0)));
    write(toleranceText, common.percent(editable(percent, 0)));
    const all = [...chosen].flatMap((index) => shapes[index].points);
    preview.style.display = all.length > 0 ? "" : "none";
    place.hidden = all.length === 0;
    if (all.length > 0) {
      const shown = [...chosen].map((index) => {
        const now = made.get(index);
        const shape = now && "shape" in now ? now.shape : null;
        // A polygon is a curve of the first degree, whose control points are its own.
        const polygon = shape?.kind === "polygon" ? { degree: 1, form: /** @type {const} */ ("periodic"), points: shape.points } : null;
        return { points: shapes[index].points, curve: shape?.kind === "curve" ? shape : polygon };
      });
      drawPreview(preview, frameOf(all, PREVIEW.width, PREVIEW.height), shown);
      const { middle, size } = placeNow();
      write(place, common.place(size.map((value) => significantText(value)), document().unit ?? "mm", middle.map((value) => fixed(value, 2))));
    }
    const list = taken();
    const no = chosen.size === 0 ? words.choose : list && why(list);
    write(adding, words.add(chosen.size));
    adding.disabled = !list || no !== null;
    write(hint, no ?? (purpose === "body" && chosen.size > 1 ? words.nested : ""));
    hint.hidden = hint.textContent === "";
  }
}

/** Decimal places that keep a tolerance to a hundredth. @param {number} tolerance */
const decimals = (tolerance) => Math.min(12, Math.max(0, Math.ceil(-Math.log10(tolerance / 100))));

/** @param {number} value @param {number} places */
const rounded = (value, places) => Number(value.toFixed(places)) + 0;
