/**
 * Icons: a 16 px box, 1.5 px line, round ends. All are decorative; the button carries the name.
 */
import { svg } from "./dom.js";

/** @type {{[name: string]: string}} */
const LINES = {
  undo: "M5.5 2.5 2.5 5.5l3 3M2.5 5.5h6.75a4.25 4.25 0 0 1 0 8.5H6",
  redo: "m10.5 2.5 3 3-3 3M13.5 5.5H6.75a4.25 4.25 0 0 0 0 8.5H10",
  down: "m5 6.75 3 3 3-3",
  up: "m5 9.25 3-3 3 3",
  right: "m6.5 4.5 3.5 3.5-3.5 3.5",
  minus: "M3.5 8h9",
  plus: "M3.5 8h9M8 3.5v9",
  fit: "M2.5 6V3.5a1 1 0 0 1 1-1H6M10 2.5h2.5a1 1 0 0 1 1 1V6M13.5 10v2.5a1 1 0 0 1-1 1H10M6 13.5H3.5a1 1 0 0 1-1-1V10",
  check: "m3 8.5 3.25 3.25L13 4.75",
  cross: "m4 4 8 8M12 4l-8 8",
  menu: "M2 4h12M2 8h12M2 12h12",
  more: "M3.5 8h.01M8 8h.01M12.5 8h.01",
  grid: "M2.5 5.75h11M2.5 10.25h11M5.75 2.5v11M10.25 2.5v11",
  snap: "M3.25 2.75h3v5.5a1.75 1.75 0 0 0 3.5 0v-5.5h3v5.5a4.75 4.75 0 0 1-9.5 0ZM3.25 5.5h3M9.75 5.5h3",
  turn: "M12.9 8.9A5 5 0 1 1 11.6 4.5M11.9 1.9v2.9H9",
  "align-left": "M2.75 2.5v11M5.5 5.5h8M5.5 10.5h5",
  "align-center": "M8 2.5v11M4 5.5h8M5.5 10.5h5",
  "align-right": "M13.25 2.5v11M2.5 5.5h8M5.5 10.5h5",
  "align-top": "M2.5 2.75h11M5.5 5.5v8M10.5 5.5v5",
  "align-middle": "M2.5 8h11M5.5 4v8M10.5 5.5v5",
  "align-bottom": "M2.5 13.25h11M5.5 2.5v8M10.5 5.5v5",
  "align-across": "M2.75 2.5v11M13.25 2.5v11M8 5v6",
  "align-down": "M2.5 2.75h11M2.5 13.25h11M5 8h6",
  link: "M6.5 9.5a2.75 2.75 0 0 0 3.9 0l2.3-2.3a2.75 2.75 0 0 0-3.9-3.9l-.8.8M9.5 6.5a2.75 2.75 0 0 0-3.9 0L3.3 8.8a2.75 2.75 0 0 0 3.9 3.9l.8-.8",
  panel: "M2.5 3.5h11v9h-11zM9.5 3.5v9",
};

/** @type {{[name: string]: string}} */
const SOLIDS = {
  play: "M5 3.4v9.2a.6.6 0 0 0 .92.5l7.1-4.6a.6.6 0 0 0 0-1L5.92 2.9a.6.6 0 0 0-.92.5Z",
  pause: "M4.25 3h2.5v10h-2.5zM9.25 3h2.5v10h-2.5z",
  step: "M3 3.4v9.2a.6.6 0 0 0 .92.5l6.1-4.6a.6.6 0 0 0 0-1L3.92 2.9a.6.6 0 0 0-.92.5ZM11.5 3h2v10h-2z",
};

/**
 * @param {string} name
 * @param {number} [size]
 */
export function icon(name, size = 16) {
  const box = svg("svg", { viewBox: "0 0 16 16", width: size, height: size, "aria-hidden": "true", class: "icon" });
  const solid = SOLIDS[name];
  box.append(
    solid ? svg("path", { d: solid, fill: "currentColor" }) : svg("path", { d: LINES[name] ?? "", class: "icon-line" }),
  );
  return box;
}

/** The half disc of the theme button. */
export function halfDisc() {
  const box = svg("svg", { viewBox: "0 0 16 16", width: 16, height: 16, "aria-hidden": "true", class: "icon" });
  box.append(
    svg("circle", { cx: 8, cy: 8, r: 5.75, class: "icon-line" }),
    svg("path", { d: "M8 2.25a5.75 5.75 0 0 1 0 11.5Z", fill: "currentColor" }),
  );
  return box;
}

/** The shape that marks a curve: circle and rounded square by turns, as its handles have them. @param {number} curve */
export function curveMark(curve) {
  const box = svg("svg", { viewBox: "0 0 16 16", width: 16, height: 16, "aria-hidden": "true", class: "icon" });
  box.append(
    curve % 2 === 0
      ? svg("circle", { cx: 8, cy: 8, r: 4.25, class: "icon-line" })
      : svg("rect", { x: 3.75, y: 3.75, width: 8.5, height: 8.5, rx: 1.5, class: "icon-line" }),
  );
  return box;
}

/** A symbol in mathematical italic. @param {string} letter */
export function symbol(letter) {
  const element = document.createElement("i");
  element.className = "math";
  element.textContent = letter;
  return element;
}
