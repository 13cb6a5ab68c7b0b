/**
 * Charts along a line of a part: what there is of each material, one above the other, or how much there is of one by several rules.
 *
 * @import { Material } from "../../../js/directrix.js"
 * @import { Along, RuleRow } from "./part-known.js"
 */
import { h, svg } from "../dom.js";
import { fixed } from "../format.js";
import { label } from "./chart-label.js";
import { words } from "./words-part.js";

/** Units of the view: the chart, room for figures on the left and below. */
const WIDTH = 560;
const HEIGHT = 120;
const LEFT = 24;
const BELOW = 20;
const ABOVE = 8;

const x = (/** @type {number} */ share) => LEFT + (WIDTH - LEFT - 8) * share;
const y = (/** @type {number} */ fraction) => ABOVE + HEIGHT * (1 - fraction);
const at = (/** @type {number} */ share, /** @type {number} */ fraction) => `${x(share).toFixed(1)} ${y(fraction).toFixed(1)}`;

/** @param {string} name for who does not see it @param {(SVGElement | string)[]} parts @param {number} length of the line */
function framed(name, parts, length) {
  const picture = svg(
    "svg",
    { class: "part-chart", viewBox: `0 0 ${WIDTH} ${ABOVE + HEIGHT + BELOW}`, role: "img", "aria-label": name },
    ...parts,
    svg("path", { class: "chart-axis", d: `M${at(0, 1)}L${at(0, 0)}L${at(1, 0)}` }),
    label("1", LEFT - 8, y(1) + 4, "end"),
    label("0", LEFT - 8, y(0) + 4, "end"),
    label(fixed(length, 0), x(1), y(0) + 15, "end"),
    label(words.along.axis, x(0.5), y(0) + 15, "middle"),
  );
  return h("div", { class: "part-chart-scroll" }, /** @type {any} */ (picture));
}

/**
 * @param {Along} along
 * @param {readonly Material[]} materials
 * @param {{length: number, limit: number, here: number | null}} marks `limit` and `here`: distances from the start of the line
 */
export function stackChart({ fractions, body }, materials, { length, limit, here }) {
  const count = body.length;
  const inside = [...body.keys()].filter((n) => body[n] > 0);
  const sums = materials.map((_, k) => (/** @type {number} */ n) => materials.slice(0, k + 1).reduce((sum, _each, j) => sum + (fractions[j]?.[n] ?? 0), 0));
  const areas = materials.flatMap(({ color }, k) => {
    if (inside.length === 0) return [];
    const over = inside.map((n) => at(n / (count - 1), Math.min(1, sums[k](n))));
    const under = [...inside].reverse().map((n) => at(n / (count - 1), k === 0 ? 0 : Math.min(1, sums[k - 1](n))));
    const area = svg("path", { class: "chart-area", d: `M${[...over, ...under].join("L")}Z` });
    area.style.setProperty("--own", color);
    return [area];
  });
  const line = (/** @type {string} */ kind, /** @type {number} */ place) =>
    place >= 0 && place <= length ? [svg("path", { class: kind, d: `M${at(place / length, 1)}L${at(place / length, 0)}` })] : [];
  const parts = [...areas, ...line("chart-limit", limit), ...(here === null ? [] : line("chart-here", here))];
  return framed(words.along.picture("0", fixed(length, 0)), parts, length);
}

/**
 * @param {readonly RuleRow[]} rows
 * @param {string} material
 * @param {{length: number, here: number | null}} marks
 */
export function ruleChart(rows, material, { length, here }) {
  const lines = [...rows].reverse().map(({ rule, along }) => {
    const points = along.flatMap((fraction, n) => (Number.isFinite(fraction) ? [at(n / (along.length - 1), fraction)] : []));
    return svg("path", { class: `chart-rule ${rule}`, d: points.length > 0 ? `M${points.join("L")}` : "" });
  });
  const mark = here === null ? [] : [svg("path", { class: "chart-here", d: `M${at(here / length, 1)}L${at(here / length, 0)}` })];
  return framed(words.own.picture(material), [...mark, ...lines], length);
}
