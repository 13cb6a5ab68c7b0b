/**
 * What the group of curves shows of one in space: its place in three coordinates, and what the matching of its projection takes for
 * granted. Loaded when a document has such curves.
 *
 * @import { App } from "../state/app.js"
 * @import { Selection } from "../types.js"
 */
import "../../styles/in-space.css";
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { h, write } from "../dom.js";
import { fixed, length } from "../format.js";
import { symbol } from "../icons.js";
import { currentMatch } from "../state/app.js";
import { changeCurve } from "../state/edits.js";
import { isInSpace } from "../state/in-space.js";
import { meanAlong, movedAlong } from "../state/in-space-edits.js";
import { movedPoints } from "../state/selection.js";
import { strings } from "../strings.js";
import { arrowStep } from "../view.js";
import { editing } from "./edit.js";
import { words } from "./in-space-words.js";

/** Largest coordinate the format allows. */
const FAR = 1e12;
/** Decimals of a coordinate as it is held. */
const DECIMALS = 12;

/**
 * @param {App} app
 * @param {HTMLElement} place the row of a curve in the plane, which this one stands in for
 * @param {HTMLElement} name the row of the name, and of the height of a curve in its plane
 * @param {() => Selection} selection
 */
export function createSpaceRows(app, place, name, selection) {
  const field = (/** @type {"x" | "y" | "z"} */ letter, /** @type {number} */ axis) =>
    numberField(
      { label: letter, name: `space-${letter}`, prefix: symbol(letter), min: -FAR, max: FAR, step: () => arrowStep(app.store.document), decimals: 2, rounded: true },
      editing(app, (document, value) => {
        const chosen = selection();
        const points = movedPoints(document, chosen);
        return changeCurve(document, chosen.curve, (curve) => movedAlong(curve, points, axis, value - meanAlong(curve, points, axis)));
      }),
    );
  const [x, y, z] = /** @type {const} */ (["x", "y", "z"]).map(field);
  const first = row("", x, y);
  const second = row("", z, { element: h("span", { class: "row-rest" }) });
  const label = /** @type {HTMLElement} */ (first.firstElementChild);
  const note = h("p", { class: "note", "data-assumed": "" });
  first.classList.add("place");
  second.classList.add("place");
  place.after(first, second, note);

  return {
    render() {
      const chosen = selection();
      const shape = app.store.document.curves[chosen.curve];
      first.hidden = second.hidden = note.hidden = !isInSpace(shape);
      write(/** @type {HTMLElement} */ (name.firstElementChild), first.hidden ? strings.curves.name : words.name);
      if (first.hidden) return;
      write(label, place.firstElementChild?.textContent ?? "");
      const points = movedPoints(app.store.document, chosen);
      [x, y, z].forEach((each, axis) => each.set(Number(meanAlong(shape, points, axis).toFixed(DECIMALS))));
      const text = assumption(app);
      // What was assumed before stands until the next result.
      if (text) write(note, text);
    },
  };
}

/**
 * The direction of the projection, how far curves are from their planes, and what lengths count.
 * @param {App} app
 */
function assumption(app) {
  const projection = currentMatch(app)?.projection;
  if (!projection) return "";
  const { normal, deviation, heights } = projection;
  const { unit } = app.store.document;
  const gap = heights.length > 1 ? length(Math.abs(heights[1] - heights[0]), unit) : null;
  return words.assumed(normal.map((part) => fixed(part, 2)).join(", "), length(deviation, unit), gap);
}
