/**
 * The greedy growth up to one of its steps: the lines that are accepted so far, drawn over the curves.
 *
 * @import { Point, View } from "../directrix.js"
 * @import { Size } from "./plane.js"
 *
 * @typedef {object} Steps
 * @property {[Point, Point][]} lines in the order in which they are accepted
 *
 * @typedef {{ steps: Steps | null, step: number, view: View, size: Size }} State
 */
import { toScreen } from "./plane.js";

const SVG = "http://www.w3.org/2000/svg";

/**
 * The lines of a growth by their ends.
 *
 * @param {import("../directrix.js").Steps} found
 * @returns {Steps}
 */
export function stepsOf({ growth, samples }) {
  return { lines: growth.map(({ from, to }) => [samples[0].points[from], samples[1].points[to]]) };
}

export class Growth {
  #lines = shape("path", "accepted");
  #halo = shape("path", "halo");
  #winner = shape("path", "winner");
  #drawn = "";

  constructor() {
    this.element = document.createElementNS(SVG, "svg");
    for (const [name, value] of Object.entries({ class: "growth", "aria-hidden": "true" })) this.element.setAttribute(name, value);
    this.element.append(this.#lines, this.#halo, this.#winner);
  }

  /** @param {State} state */
  render({ steps, step, view, size }) {
    const accepted = steps?.lines.slice(0, step) ?? [];
    const path = ([from, to] = /** @type {[Point, Point]} */ ([[0, 0], [0, 0]])) =>
      `M${[from, to].map((at) => toScreen(view, size, at).map((value) => value.toFixed(1))).join("L")}`;
    const winner = accepted.length > 0 ? path(accepted.at(-1)) : "";
    const lines = accepted.slice(0, -1).map(path).join("");
    const drawn = `${lines} ${winner}`;
    if (drawn === this.#drawn) return;
    this.#drawn = drawn;
    this.#lines.setAttribute("d", lines);
    this.#halo.setAttribute("d", winner);
    this.#winner.setAttribute("d", winner);
  }
}

/** @param {string} tag @param {string} name */
function shape(tag, name) {
  const element = document.createElementNS(SVG, tag);
  element.setAttribute("class", name);
  return element;
}
