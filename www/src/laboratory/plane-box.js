/**
 * The box by which a group picks elements of a problem in the plane: its outline, and a handle on each of its four sides.
 *
 * @import { BoxMoves, Side } from "../space/box-mark.js"
 * @import { Bounds } from "../space/vector.js"
 * @import { Point, Size, View } from "../types.js"
 */
import { attribute, h, svg } from "../dom.js";
import { sideHandle, SIDES, signOf, STEM } from "../space/box-mark.js";
import { toScreen } from "../view.js";
import { words } from "./words.js";

const FLAT = SIDES.filter(({ axis }) => axis < 2);

/** @param {BoxMoves} moves */
export function createPlaneBox(moves) {
  const coarse = matchMedia("(pointer: coarse)");
  const outline = svg("rect", { class: "lab-box" });
  const stems = FLAT.map(() => svg("path", { class: "plane-arrow" }));
  const marks = svg("svg", { class: "plane-marks", "aria-hidden": "true" }, outline, ...stems);
  /** @type {Bounds | null} */
  let box = null;
  const slides = FLAT.map((side) => sideHandle(side, words.box.label, moves, () => box, "data-flat-handle"));
  const handles = h("div", { class: "gizmo-handles box-handles", hidden: true, "data-furniture": "" }, ...slides.map(({ element }) => element));
  marks.style.display = "none";

  return {
    nodes: [/** @type {any} */ (marks), handles],
    /** @param {Bounds | null} next as it is drawn; null where there is none @param {View} view @param {Size} size */
    render(next, view, size) {
      box = next;
      marks.style.display = box ? "" : "none";
      handles.hidden = box === null;
      if (!box) return;
      const [from, to] = [toScreen(view, size, [box.min[0], box.max[1]]), toScreen(view, size, [box.max[0], box.min[1]])];
      const { min, max } = box;
      const rectangle = { x: from[0], y: from[1], width: to[0] - from[0], height: to[1] - from[1] };
      for (const [name, value] of Object.entries(rectangle)) attribute(outline, name, value.toFixed(1));
      const stem = coarse.matches ? STEM.coarse : STEM.fine;
      FLAT.forEach((side, k) => {
        const { axis, end } = side;
        const place = (end === "min" ? min : max)[axis];
        const foot = toScreen(view, size, /** @type {Point} */ ([0, 1].map((each) => (each === axis ? place : (min[each] + max[each]) / 2))));
        // The screen counts downwards.
        const outwards = /** @type {Point} */ ([0, 1].map((each) => (each === axis ? signOf(side) * (axis === 0 ? 1 : -1) : 0)));
        slides[k].direction = /** @type {Point} */ (outwards.map((value) => value * view.scale));
        const at = slides[k].put(/** @type {Point} */ (foot.map((value, each) => value + stem * outwards[each])), { size });
        attribute(stems[k], "d", `M${foot.map(round)}L${at.map(round)}`);
      });
    },
    /** Says of each side where it stands. @param {(side: Side) => {text: string, now: number, extent: readonly number[]}} of */
    describe(of) {
      FLAT.forEach((side, k) => {
        const { text, now, extent } = of(side);
        slides[k].describe(text, now, extent);
      });
    },
  };
}

/** @param {number} value */
const round = (value) => value.toFixed(1);
