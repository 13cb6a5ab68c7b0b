/**
 * Corners of the curves, where no normal is: each wears a mark with the bisector that stands in for it, and the status line goes from one to the
 * next and says what the matching falls short of its bound. The papers let the quality drop there without a word.
 *
 * @import { Diagnostic } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { Match, Point } from "../types.js"
 */
import "../../styles/marks.css";
import { attribute, find, svg } from "../dom.js";
import { coordinate, fixed } from "../format.js";
import { bring } from "../witness.js";
import { currentMatch, curveName } from "../state/app.js";
import { shownTotals } from "../state/lines.js";
import { inSentence } from "../strings.js";
import { toScreen } from "../view.js";
import { words } from "./corner-words.js";

/** Length of the bisector and half the width of the diamond, CSS pixels. */
const REACH = 22;
const HALF = 4.5;

/** @typedef {Diagnostic & {curve: number, at: Point, normal: Point, turn: number}} Corner */

/** The corner that was looked at last. @type {Corner | null} */
let latest = null;

/** @param {Match | null} match @returns {Corner[]} */
const cornersOf = (match) =>
  /** @type {Corner[]} */ ((match?.diagnostics ?? []).filter(({ code }) => code === "corner"));

/** @param {App} app */
export function createCorners(app) {
  const layer = svg("svg", { class: "marks corners", "aria-hidden": "true" });
  find("#overlay").before(layer);
  /** @type {SVGElement[]} */
  const marks = [];

  return {
    render() {
      const { view, size } = app.ui.value;
      const { match } = app.results.value;
      // Corners stay in sight while a curve moves, at the places of the last result.
      // A harmonic blend needs no normals.
      const corners = view && !match?.harmonic ? cornersOf(match) : [];
      while (marks.length < corners.length) {
        const ray = `M0 0V${-REACH}m-3.5 5 3.5-5 3.5 5`;
        const diamond = `M0 ${-HALF}L${HALF} 0 0 ${HALF} ${-HALF} 0Z`;
        const mark = svg(
          "g",
          { class: "corner-mark" },
          svg("path", { class: "under", d: ray }),
          svg("path", { class: "ray", d: ray }),
          svg("path", { class: "place", d: diamond }),
        );
        marks.push(mark);
        layer.append(mark);
      }
      marks.forEach((mark, index) => {
        const corner = corners[index];
        mark.style.display = corner ? "" : "none";
        if (!corner || !view) return;
        const [x, y] = toScreen(view, size, corner.at);
        const degrees = (Math.atan2(corner.normal[0], corner.normal[1]) * 180) / Math.PI;
        attribute(mark, "transform", `translate(${x.toFixed(1)} ${y.toFixed(1)}) rotate(${degrees.toFixed(1)})`);
        mark.classList.toggle("chosen", corner === latest);
      });
    },
  };
}

/** Goes to the next corner and says what stands for its normal, and what is lost. @param {App} app */
export function nextCorner(app) {
  const match = currentMatch(app);
  const corners = cornersOf(match);
  if (!match || corners.length === 0) return;
  const index = (corners.findIndex((corner) => corner === latest) + 1) % corners.length;
  const corner = corners[index];
  latest = corner;
  const eta = shownTotals(match)?.eta ?? null;
  const text = words.note(index + 1, corners.length, `${fixed(Math.abs(corner.turn), 0)}°`, eta === null ? null : `${fixed(100 * (1 - eta), 1)}\u00a0%`);
  app.ui.set({ witness: null, note: { tone: "plain", text } });
  bring(app, corner.at);
  const name = inSentence(curveName(app.store.document, corner.curve));
  app.say(`${text} ${words.place(name, coordinate(corner.at[0]), coordinate(corner.at[1]))}`);
}
