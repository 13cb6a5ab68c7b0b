/**
 * The picture of one method: its name and what it is worth, the lines and the blend, and the line that the pointer lights.
 *
 * @import { Point, Size, View } from "../types.js"
 * @import { Result } from "./runner.js"
 */
import { attribute, h, svg, write } from "../dom.js";
import { imageData } from "../kernel.js";
import { toScreen } from "../view.js";

/** Radius of the rings at the ends of the lit line. */
const RING = 3.5;

/**
 * @typedef {object} Texts
 * @property {string} name
 * @property {(Node | string)[]} line what the method does, or what is wrong with the result
 * @property {boolean} failed
 * @property {(Node | string)[]} eta
 * @property {string} spoken what is read after all that
 */

/** @param {string} method */
export function createPicture(method) {
  const name = h("span", { class: "method-name" });
  const eta = h("span", { class: "method-eta number" });
  const line = h("span", { class: "method-line" });
  const canvas = h("canvas", {});
  const halo = svg("path", { class: "lit-halo" });
  const core = svg("path", { class: "lit-core" });
  const ends = [0, 1].map(() => svg("circle", { r: RING, class: "probe-ring" }));
  const marks = svg("svg", { class: "marks", "aria-hidden": "true" }, halo, core, ...ends);
  const frame = h("span", { class: "method-frame" }, canvas, /** @type {any} */ (marks));
  const plot = h("span", { class: "method-plot" }, frame);
  const spoken = h("span", { class: "spoken" });
  const element = h(
    "button",
    { type: "button", class: "method", tabIndex: -1, "data-method": method },
    h("span", { class: "method-head" }, name, " ", eta),
    line,
    spoken,
    plot,
  );
  /** @type {Result["picture"]} */
  let drawn = null;

  return {
    element,
    plot,
    frame,

    /** @param {Texts} texts @param {boolean} chosen */
    describe(texts, chosen) {
      write(name, texts.name);
      eta.replaceChildren(...texts.eta);
      line.replaceChildren(...texts.line);
      line.classList.toggle("failed", texts.failed);
      write(spoken, texts.spoken);
      attribute(element, "aria-current", chosen ? "true" : null);
    },

    /** @param {Result["picture"]} picture @param {Size} size */
    paint(picture, size) {
      frame.style.width = `${size.width}px`;
      frame.style.height = `${size.height}px`;
      if (picture === drawn) return;
      drawn = picture;
      if (!picture) {
        canvas.width = 0;
        return;
      }
      canvas.width = picture.width;
      canvas.height = picture.height;
      canvas.getContext("2d")?.putImageData(imageData(picture), 0, 0);
    },

    /**
     * @param {{from: Point, to: Point} | null} lit
     * @param {View} view
     * @param {Size} size
     */
    light(lit, view, size) {
      marks.style.display = lit ? "" : "none";
      if (!lit) return;
      const places = [lit.from, lit.to].map((point) => toScreen(view, size, point).map((value) => value.toFixed(1)));
      const d = `M${places.map((place) => place.join(" ")).join("L")}`;
      attribute(halo, "d", d);
      attribute(core, "d", d);
      ends.forEach((end, i) => {
        attribute(end, "cx", places[i][0]);
        attribute(end, "cy", places[i][1]);
      });
    },
  };
}
