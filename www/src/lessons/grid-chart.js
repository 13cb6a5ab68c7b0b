/**
 * Charts of a column of a grid: the parabolas of its pixels with their lower envelope, and the searches of the paper's scan.
 *
 * @import { TransformSteps } from "../../../js/directrix.js"
 */
import { h, svg } from "../dom.js";
import { label } from "./chart-label.js";
import { words } from "./words-part.js";

/** Units of the view: the chart, room for figures on the left and below. */
const WIDTH = 560;
const HEIGHT = 150;
const LEFT = 30;
const BELOW = 18;
const ABOVE = 8;
/** Pieces of a curve from one pixel to the next, and height of a search. */
const PIECES = 6;
const SEARCH = 9;

/** @param {SVGElement} picture */
const scrolled = (picture) => h("div", { class: "part-chart-scroll" }, /** @type {any} */ (picture));

/** Of a column of so many pixels, the place of one. @param {number} count */
const across = (count) => (/** @type {number} */ at) => LEFT + ((WIDTH - LEFT - 10) * at) / Math.max(1, count - 1);

/**
 * @param {number[]} levels squared distance of each pixel of the column within its row
 * @param {number[]} corners pixels whose parabolas are on the envelope
 * @param {number} column from 1, for its name
 */
export function envelopeChart(levels, corners, column) {
  const count = levels.length;
  const x = across(count);
  const value = (/** @type {number} */ from, /** @type {number} */ at) => levels[from] + (at - from) ** 2;
  const places = Array.from({ length: (count - 1) * PIECES + 1 }, (_, n) => n / PIECES);
  const least = (/** @type {number} */ at) => corners.reduce((found, from) => Math.min(found, value(from, at)), Infinity);
  const finite = levels.filter(Number.isFinite);
  const top = Math.max(4, 1.15 * Math.max(0, ...finite, ...places.map(least).filter(Number.isFinite)));
  const y = (/** @type {number} */ level) => ABOVE + HEIGHT * (1 - level / top);
  const at = (/** @type {number} */ place, /** @type {number} */ level) => `${x(place).toFixed(1)} ${y(level).toFixed(1)}`;
  /** As far as it lies within the chart, between whose edges it leaves no gap. @param {number} from */
  const parabola = (from) => {
    const reach = Math.sqrt(Math.max(0, top - levels[from]));
    const [start, end] = [Math.max(0, from - reach), Math.min(count - 1, from + reach)];
    const steps = Math.max(2, Math.ceil((end - start) * PIECES));
    return `M${Array.from({ length: steps + 1 }, (_, n) => start + ((end - start) * n) / steps).map((place) => at(place, value(from, place))).join("L")}`;
  };
  const others = levels.flatMap((level, from) => (Number.isFinite(level) && !corners.includes(from) ? [parabola(from)] : []));
  const picture = svg(
    "svg",
    { class: "grid-chart", viewBox: `0 0 ${WIDTH} ${ABOVE + HEIGHT + BELOW}`, role: "img", "aria-label": words.envelope.picture(column) },
    svg("path", { class: "chart-axis", d: `M${at(0, top)}L${at(0, 0)}L${at(count - 1, 0)}` }),
    svg("path", { class: "grid-parabola", d: others.join("") }),
    svg("path", { class: "grid-corner", d: corners.map(parabola).join("") }),
    svg("path", { class: "grid-envelope", d: corners.length > 0 ? `M${places.map((place) => at(place, least(place))).join("L")}` : "" }),
    svg("path", { class: "grid-dots", d: levels.flatMap((level, from) => (Number.isFinite(level) ? [`M${at(from, level)}h.01`] : [])).join("") }),
    ...levels.map((_, n) => label(String(n + 1), x(n), y(0) + 14, "middle")),
    label(String(Math.round(top)), LEFT - 8, y(top) + 10, "end"),
    label("0", LEFT - 8, y(0) + 4, "end"),
  );
  return scrolled(picture);
}

/**
 * @param {number[]} levels squared distance of each pixel of the column within its row
 * @param {TransformSteps["columns"][number]["searches"]} searches
 * @param {number} column from 1, for its name
 */
export function scanChart(levels, searches, column) {
  const count = levels.length;
  const x = across(count);
  const row = (/** @type {number} */ n) => ABOVE + 30 + SEARCH * n;
  const height = row(searches.length) + BELOW;
  const bar = (/** @type {{from: number, forward: boolean}} */ { from, forward }, /** @type {number} */ length, /** @type {number} */ n) => {
    const end = Math.min(count - 1, Math.max(0, from + (forward ? length : -length)));
    return `M${x(from).toFixed(1)} ${row(n)}L${x(end).toFixed(1)} ${row(n)}`;
  };
  const picture = svg(
    "svg",
    { class: "grid-chart", viewBox: `0 0 ${WIDTH} ${height}`, role: "img", "aria-label": words.scan.picture(column) },
    ...levels.map((level, n) => label(Number.isFinite(level) ? String(level) : "∞", x(n), ABOVE + 10, "middle")),
    svg("path", { class: "chart-axis", d: `M${x(0)} ${ABOVE + 18}L${x(count - 1)} ${ABOVE + 18}` }),
    svg("path", { class: "scan-reach", d: searches.map((each, n) => bar(each, each.reach, n)).join("") }),
    svg("path", { class: "scan-count", d: searches.map((each, n) => bar(each, each.count, n)).join("") }),
    svg("path", { class: "grid-dots", d: searches.map(({ from }, n) => `M${x(from).toFixed(1)} ${row(n)}h.01`).join("") }),
    ...levels.map((_, n) => label(String(n + 1), x(n), height - 4, "middle")),
  );
  return scrolled(picture);
}
