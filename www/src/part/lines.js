/**
 * The lines of equal fraction over the picture. They are drawn in document units, so that they follow pan and zoom without being made anew.
 *
 * @import { Isoline } from "../../../js/directrix.js"
 * @import { Bench } from "./state.js"
 */
import { attribute, svg } from "../dom.js";

/** @param {Bench} bench */
export function createLines(bench) {
  const path = svg("path", { class: "part-isolines", "data-part-isolines": "" });
  const element = svg("svg", { class: "marks", "aria-hidden": "true" }, path);
  /** @type {readonly Isoline[] | null} */
  let drawn = null;
  return {
    element,
    render() {
      const { known, view, size, shown } = bench.now();
      const isolines = shown.isolines !== null && !shown.leaves && !shown.compare ? (known?.isolines ?? null) : null;
      element.style.display = isolines && view ? "" : "none";
      if (!isolines || !view) return;
      if (isolines !== drawn) attribute(path, "d", isolines.map(pathOf).join(""));
      drawn = isolines;
      const [x, y] = [size.width / 2 - view.center[0] * view.scale, size.height / 2 + view.center[1] * view.scale];
      attribute(path, "transform", `matrix(${view.scale} 0 0 ${-view.scale} ${x} ${y})`);
    },
  };
}

/** @param {Isoline} isoline */
const pathOf = ({ lines, closed }) => lines.map((points, i) => `M${points.map(([x, y]) => `${Number(x.toPrecision(7))} ${Number(y.toPrecision(7))}`).join("L")}${closed[i] ? "Z" : ""}`).join("");
