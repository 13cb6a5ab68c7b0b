/**
 * The measures of all methods as bars, each on one scale for all, in tables that can be read out.
 *
 * @import { CurvesDocument } from "../types.js"
 * @import { Result } from "./runner.js"
 *
 * @typedef {object} Measure
 * @property {string} name
 * @property {(Node | string)[]} heading
 * @property {string} [note]
 * @property {(result: Result) => number | null} value
 * @property {boolean} [isFault] anything above 0 is an error
 */
import { attribute, h, write } from "../dom.js";
import { editable, fixed } from "../format.js";
import { icon, symbol } from "../icons.js";
import { faultsOf, median, METHODS } from "./methods.js";
import { words } from "./words.js";

/** What stands for a value that is not there. */
const MISSING = "\u2013";
/** Milliseconds from which a time is written without decimals. */
const WHOLE_MS = 99.95;

/** @type {readonly Measure[][]} measures that share a table */
const TABLES = [
  [{ name: "eta", heading: [`${words.eta} `, symbol("η")], note: words.etaNote, value: ({ quality }) => quality.eta }],
  [{ name: "integral", heading: [`${words.integral} `, symbol("J")], value: ({ quality }) => quality.integral }],
  [
    { name: "mean", heading: [`${words.mean} `, symbol("f")], value: ({ match }) => shown(match)?.mean ?? null },
    { name: "count", heading: [words.count], value: ({ match }) => shown(match)?.count ?? null },
  ],
  [
    { name: "crossings", heading: [words.crossed], isFault: true, value: ({ match }) => shown(match)?.crossings ?? null },
    { name: "blocked", heading: [words.hit], isFault: true, value: ({ match }) => shown(match)?.blocked ?? null },
  ],
  [{ name: "time", heading: [words.time], value: ({ times }) => median(times) }],
];

/** @param {Result["match"]} match */
const shown = (match) => match && (match.totals.pairs ?? match.totals.lines);

/** @param {HTMLElement} place */
export function createBars(place) {
  const tables = TABLES.map(createTable);
  const note = h("p", { class: "bars-note" }, words.note);
  place.append(
    h("div", { class: "bars", tabIndex: 0, role: "group", "aria-label": words.bars }, ...tables.map(({ element }) => element), note),
  );
  return {
    /**
     * @param {(Result | null)[]} results
     * @param {number} chosen
     * @param {CurvesDocument} document
     */
    render(results, chosen, document) {
      for (const table of tables) table.render(results, chosen, document);
    },
  };
}

/** @param {Measure[]} measures */
function createTable(measures) {
  const notes = measures.map(({ note = "" }) => h("span", { class: "bars-aside number" }, note));
  const columns = measures.map((measure, i) =>
    h("th", { scope: "col" }, h("span", { class: "bars-head" }, h("strong", {}, ...measure.heading), notes[i])),
  );
  const rows = METHODS.map(({ name }) => createRow(name, measures));
  const element = h(
    "table",
    { class: measures.length > 1 ? "bars-table double" : "bars-table", "data-measures": measures.map(({ name }) => name).join(" ") },
    h("thead", {}, h("tr", {}, h("th", { scope: "col", class: "bars-corner" }, h("span", { class: "spoken" }, words.method)), ...columns)),
    h("tbody", {}, ...rows.map(({ element }) => element)),
  );

  return {
    element,
    /** @param {(Result | null)[]} results @param {number} chosen @param {CurvesDocument} document */
    render(results, chosen, document) {
      measures.forEach((measure, m) => {
        const values = results.map((result) => (result ? measure.value(result) : null));
        const scale = scaleOf(measure, values, results);
        const written = writer(measure, values, document);
        notes[m].replaceChildren(...noteOf(measure, written.unit, results));
        rows.forEach((row, i) => {
          const result = results[i];
          const feasible = result === null || result.match === null || faultsOf(result.match).feasible;
          row.render(m, {
            text: values[i] === null ? (result ? MISSING : "") : written.text(values[i]),
            share: Math.max(0, values[i] ?? 0) / (scale || 1),
            chosen: i === chosen,
            broken: !feasible || result?.problem !== null && result !== null,
            fault: measure.isFault === true && (values[i] ?? 0) > 0,
            reference: measure.name === "eta" ? 1 : measure.name === "integral" ? boundOf(results) / (scale || 1) : null,
          });
        });
      });
    },
  };
}

/** @param {string} method @param {Measure[]} measures */
function createRow(method, measures) {
  const mark = h("span", { class: "bars-mark", title: words.unranked }, icon("cross", 10), h("span", { class: "spoken" }, `, ${words.infeasible}`));
  const cells = measures.map(() => {
    const bar = h("span", { class: "bar-fill" });
    const end = h("span", { class: "bar-reference" });
    const track = h("span", { class: "bar-track", "aria-hidden": "true" }, bar, end);
    const value = h("span", { class: "bar-value number" });
    return { bar, end, value, element: h("td", {}, h("span", { class: "bar-cell" }, track, value)) };
  });
  const element = h(
    "tr",
    { "data-row": method },
    h("th", { scope: "row" }, words.methods[method].name, mark),
    ...cells.map((cell) => cell.element),
  );
  return {
    element,
    /**
     * @param {number} m
     * @param {{text: string, share: number, chosen: boolean, broken: boolean, fault: boolean, reference: number | null}} shown
     */
    render(m, { text, share, chosen, broken, fault, reference }) {
      const { bar, end, value } = cells[m];
      write(value, text);
      attribute(value, "title", text === MISSING ? words.missing : null);
      bar.style.width = `${(100 * Math.min(1, share)).toFixed(2)}%`;
      end.hidden = reference === null || !(reference > 0 && reference <= 1);
      end.style.left = `${(100 * (reference ?? 0)).toFixed(2)}%`;
      element.classList.toggle("chosen", chosen);
      element.classList.toggle("broken", broken);
      cells[m].element.classList.toggle("fault", fault);
      mark.hidden = !broken;
    },
  };
}

/** @param {Measure} measure @param {(number | null)[]} values @param {(Result | null)[]} results */
function scaleOf({ name }, values, results) {
  const least = { eta: 1, integral: boundOf(results) }[name] ?? 0;
  return Math.max(least, ...values.map((value) => value ?? 0));
}

/** The upper bound of J that the exact method has. @param {(Result | null)[]} results */
const boundOf = (results) => Math.max(0, results[METHODS.length - 1]?.quality.bound ?? 0);

/**
 * How the values of a measure are written: those of f by one power of ten for all.
 * @param {Measure} measure
 * @param {(number | null)[]} values
 * @param {CurvesDocument} document
 * @returns {{text: (value: number) => string, unit: (Node | string)[]}}
 */
function writer({ name }, values, { matching, unit }) {
  if (name === "eta") return { text: (value) => fixed(value, 3), unit: [] };
  if (name === "time") return { text: (value) => fixed(value, value < WHOLE_MS ? 1 : 0), unit: [] };
  if (name !== "integral" && name !== "mean") return { text: (value) => fixed(value, 0), unit: [] };
  const largest = Math.max(...values.map((value) => Math.abs(value ?? 0)));
  const power = largest > 0 ? Math.floor(Math.log10(largest)) : 0;
  const exponent = power < -1 || power > 2 ? power : 0;
  const decimals = exponent === 0 ? Math.max(0, 2 - power) : 2;
  const weight = matching.distanceWeight;
  const nodes = [
    ...(exponent === 0 ? [] : ["× 10", h("sup", {}, fixed(exponent, 0))]),
    ...(name === "mean" || weight === 0 ? [] : [`\u00a0${unit}`, h("sup", {}, editable(-weight, 0))]),
  ];
  return { text: (value) => fixed(value / 10 ** exponent, decimals), unit: nodes };
}

/** @param {Measure} measure @param {(Node | string)[]} unit @param {(Result | null)[]} results */
function noteOf({ name, note = "" }, unit, results) {
  if (name !== "time") return unit.length > 0 ? unit : [note];
  const runs = results.flatMap((result) => (result && result.times.length > 0 ? [result.times.length] : []));
  return runs.length === 0 ? [] : [words.timeNote(Math.min(...runs), Math.max(...runs))];
}
