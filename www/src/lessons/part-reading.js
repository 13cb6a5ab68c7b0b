/**
 * What stands below a figure of a part: the compositions along a line with the distance of the place, or the overlap rules beside each other.
 *
 * @import { Figure } from "../../../scripts/lib/lesson.mjs"
 * @import { RuleRow } from "./part-known.js"
 * @import { Known } from "./part-view.js"
 */
import { h } from "../dom.js";
import { fixed } from "../format.js";
import { ruleChart, stackChart } from "./part-chart.js";
import { distanceOf, featureOf, materialOf } from "./part-known.js";
import { words } from "./words-part.js";

/** @param {Figure} figure @param {Known} now @returns {(HTMLElement | SVGElement)[]} */
export function readingOf({ line, feature }, { job, found, along, rows }) {
  if (!line) return [];
  const { materials = [], unit = "mm" } = job.document;
  const [x, y, u, v] = line;
  const length = Math.hypot(u - x, v - y);
  if (along) {
    const own = featureOf(job.document, feature);
    const here = found && distanceOf(found, feature[1]);
    const distance = found ? [h("dt", {}, words.along.distance(own?.name ?? "")), h("dd", { "data-lesson": "distance" }, words.unit(fixed(here ?? NaN, 2), unit))] : [];
    return [stackChart(along, materials, { length, limit: own?.to ?? NaN, here }), h("dl", {}, ...distance)];
  }
  if (rows.length === 0 || !job.place) return [];
  const name = materials[materialOf(job.document, feature)]?.name ?? "";
  const here = Math.hypot(job.place[0] - x, job.place[1] - y);
  return [ruleChart(rows, name, { length, here: here <= length ? here : null }), ruleTable(rows, name)];
}

/** @param {RuleRow[]} rows @param {string} material */
function ruleTable(rows, material) {
  const number = (/** @type {number} */ value) => (Number.isFinite(value) ? fixed(value, 3) : "");
  const least = (/** @type {number[]} */ along) => along.reduce((found, each) => (Number.isFinite(each) ? Math.min(found, each) : found), Infinity);
  const row = (/** @type {RuleRow} */ { rule, here, along }) =>
    h(
      "tr",
      {},
      h("th", { scope: "row" }, h("span", { class: `chart-key ${rule}`, "aria-hidden": "true" }), words.rules[rule]),
      h("td", { class: "number", "data-lesson": `here-${rule}` }, number(here)),
      h("td", { class: "number", "data-lesson": `least-${rule}` }, number(least(along))),
    );
  return h(
    "table",
    {},
    h("thead", {}, h("tr", {}, ...[words.own.rule, words.own.here(material), words.own.least].map((text) => h("th", { scope: "col" }, text)))),
    h("tbody", {}, ...rows.map(row)),
  );
}
