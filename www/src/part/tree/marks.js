/** Marks of the rows of the feature list: a 16 px box, 1.5 px line, round ends. */
import { svg } from "../../dom.js";

/** @type {{[name: string]: string}} */
const LINES = {
  body: "M3 5.5 8 2.75l5 2.75v5L8 13.25 3 10.5Z",
  standard: "M8 2.5a5.5 5.5 0 1 1 0 11 5.5 5.5 0 0 1 0-11ZM8 2.5v11M2.5 8h11",
  blend: "M8 2.5a5.5 5.5 0 1 1 0 11 5.5 5.5 0 0 1 0-11ZM8 5.25a2.75 2.75 0 1 1 0 5.5 2.75 2.75 0 0 1 0-5.5ZM8 7.9v.2",
  feature: "M2.75 2.5v10.75H13.5M2.75 4.5c4 0 4 6 9.75 6",
  shapes: "M2.75 3h5.5v5.5h-5.5zM10.75 7.25a3 3 0 1 1-3 3",
  point: "M8 6.25a1.75 1.75 0 1 1 0 3.5 1.75 1.75 0 0 1 0-3.5Z",
  line: "M2 12.5 14 3.5",
  segment: "M4 11.5 12 4.5M2.75 12.5h.01M13.25 3.5h.01",
  circle: "M8 3a5 5 0 1 1 0 10A5 5 0 0 1 8 3Z",
  polygon: "m8 2.75 5.25 4-2 6.25h-6.5l-2-6.25Z",
  polyline: "M2.5 12.5 6 5l4 5 3.5-6.5",
  curve: "M2.5 11.5C5 2 8 14 13.5 4.5",
  eye: "M1.75 8S4 3.75 8 3.75 14.25 8 14.25 8 12 12.25 8 12.25 1.75 8 1.75 8ZM8 6.25a1.75 1.75 0 1 1 0 3.5 1.75 1.75 0 0 1 0-3.5Z",
  shut: "M2 6.5c1.25 2 3.5 3.25 6 3.25s4.75-1.25 6-3.25M8 9.75v2.5M4 8.75l-1.25 2M12 8.75l1.25 2",
  fault: "M8 2.5 14 13H2ZM8 6.5v3M8 11.25h.01",
};

/** @param {string} name */
export function mark(name) {
  return svg("svg", { viewBox: "0 0 16 16", width: 16, height: 16, "aria-hidden": "true", class: "icon" }, svg("path", { d: LINES[name] ?? "", class: "icon-line" }));
}
