/**
 * The material along a row of cells as a chart: the fraction of the second material over the parameter, with the coefficients that it
 * follows, and what a reflection asks for beyond the middle joint.
 *
 * @import { Material } from "../../../js/directrix.js"
 * @import { Cell } from "../hyperpatch/document.js"
 * @import { Shares } from "./body-edits.js"
 */
import { h, svg } from "../dom.js";
import { fixed } from "../format.js";
import { placeOf, sampleAt } from "../hyperpatch/cell.js";
import { reflected } from "./body-edits.js";
import { words } from "./words-body.js";

/** Units of the view: a cell, a fraction of 1, room beyond 0 and 1, room for figures on the left. */
const CELL = 100;
const ONE = 96;
const BEYOND = 0.4;
const LEFT = 24;
/** Pieces of the curve in a cell. */
const PIECES = 24;

/**
 * @param {Cell[]} cells in a row along u
 * @param {Material[]} materials
 * @param {Shares | null} shares of a reflection
 */
export function rowChart(cells, materials, shares) {
  const x = (/** @type {number} */ t) => LEFT + CELL * t;
  const y = (/** @type {number} */ share) => ONE * (1 + BEYOND - share);
  const at = (/** @type {number} */ t, /** @type {number} */ share) => `${x(t).toFixed(1)} ${y(share).toFixed(1)}`;
  const end = cells.length;
  const coefficients = cells.flatMap((cell, n) => [0, 1, 2, 3].map((i) => at(n + i / 3, cell.coefficients[placeOf(i, 0, 0)].mix?.[1] ?? 0)));
  const curve = cells.flatMap((cell, n) =>
    Array.from({ length: PIECES + 1 }, (_, k) => at(n + k / PIECES, sampleAt(cell, [k / PIECES, 0, 0], materials.length).mix[1])),
  );
  const joints = Array.from({ length: end + 1 }, (_, n) => `M${at(n, 1)}L${at(n, 0)}`).join("");
  const levels = [0, 1].map((share) => `M${at(0, share)}L${at(end, share)}`).join("");
  const middle = end / 2;
  const line = (/** @type {string[]} */ points) => `M${points.join("L")}`;
  const dots = (/** @type {string[]} */ points) => points.map((point) => `M${point}h.01`).join("");
  const beyond = shares && reflected(shares);
  const isOutside = beyond !== null && (beyond < 0 || beyond > 1);
  const mirror = shares && beyond !== null ? [at(middle - 1 / 3, shares.before), at(middle, shares.at), at(middle + 1 / 3, beyond)] : [];
  const label = (/** @type {number} */ share) => {
    const text = svg("text", { x: String(LEFT - 8), y: String(y(share) + 4), "text-anchor": "end" });
    text.textContent = fixed(share, 0);
    return text;
  };
  const picture = svg(
    "svg",
    {
      class: "cell-row",
      viewBox: `0 0 ${LEFT + CELL * end + 8} ${ONE * (1 + 2 * BEYOND)}`,
      role: "img",
      "aria-label": words.row.picture(materials[1]?.name ?? ""),
    },
    svg("path", { class: "row-room", d: `M${at(0, 1)}L${at(end, 1)}L${at(end, 0)}L${at(0, 0)}Z` }),
    svg("path", { class: "row-grid", d: joints + levels }),
    ...[0, 1].map(label),
    svg("path", { class: "row-net", d: line(coefficients) }),
    svg("path", { class: "row-curve", d: line(curve) }),
    svg("path", { class: "row-dots", d: dots(coefficients) }),
    ...(mirror.length > 0
      ? [svg("path", { class: `row-mirror${isOutside ? " failed" : ""}`, d: line(mirror) }), svg("path", { class: `row-wanted${isOutside ? " failed" : ""}`, d: dots(mirror.slice(2)) })]
      : []),
  );
  return h("div", { class: "cell-row-scroll" }, /** @type {any} */ (picture));
}
