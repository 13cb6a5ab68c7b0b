/** The tables of `docs/reference-curves.md`: what every method makes of every preset. */
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { root } from "./paths.mjs";

/**
 * @typedef {import("../../js/directrix.js").Directrix} Directrix
 * @typedef {import("../../js/directrix.js").CurvesDocument} CurvesDocument
 *
 * @typedef {object} Preset
 * @property {string} id
 * @property {string} title
 * @property {string} line why it matters
 * @property {CurvesDocument} document
 */

/** The page that holds the tables. */
export const referencePage = join(root, "docs/reference-curves.md");

const begin = (/** @type {string} */ name) => `<!-- ${name}: written by npm run reference -->`;
const end = (/** @type {string} */ name) => `<!-- end of ${name} -->`;

/**
 * The page with its tables made anew.
 *
 * @param {Directrix} dx
 * @returns {Promise<string>}
 */
export async function reference(dx) {
  const presets = await readPresets();
  const tables = {
    pairs: pairsTable(presets),
    greedy: greedyTable(dx, presets),
    "one-to-one": oneToOneTable(dx, presets),
    methods: methodsTable(dx, presets),
  };
  let page = await readFile(referencePage, "utf8");
  for (const [name, table] of Object.entries(tables)) {
    const [before, rest] = page.split(begin(name));
    const after = rest?.split(end(name))[1];
    if (after === undefined) throw new Error(`${referencePage} has no place for the table "${name}"`);
    page = `${before}${begin(name)}\n${table}\n${end(name)}${after}`;
  }
  return page;
}

/**
 * The presets of two plane curves with the method whose lines the tables count.
 *
 * @returns {Promise<Preset[]>}
 */
async function readPresets() {
  const read = async (/** @type {string} */ file) => JSON.parse(await readFile(join(root, "www/presets", file), "utf8"));
  /** @type {Omit<Preset, "document">[]} */
  const index = await read("index.json");
  const grown = async (/** @type {string} */ id) => {
    const document = await read(`${id}.json`);
    return { ...document, matching: { ...document.matching, method: "greedy", oneToOne: false } };
  };
  const presets = await Promise.all(index.map(async (preset) => ({ ...preset, document: await grown(preset.id) })));
  // Methods are compared on pairs; a stack is several of them, and of curves in space they see a projection.
  return presets.filter(({ document: { blend, curves } }) => blend?.kind !== "harmonic" && curves.length === 2 && curves[0].points[0].length === 2);
}

/** @param {Preset[]} presets */
function pairsTable(presets) {
  const rows = presets.map(({ id, title, line, document }) => [
    `<img src="../tests/golden/preset-${id}.png" width="120" alt="">`,
    `[${title}](../www/presets/${id}.json)`,
    document.curves.map(({ degree, points }) => `${points.length} (${degree})`).join(", "),
    document.sampling?.counts?.join(" : ") ?? "",
    line,
  ]);
  return table(["", "pair", "control points (degree)", "samples", "what it is for"], ["", "", "", "", ""], rows);
}

/**
 * @param {Directrix} dx
 * @param {Preset[]} presets
 */
function greedyTable(dx, presets) {
  const rows = presets.map(({ title, document }) => {
    const { growth, lines } = dx.match(document).totals;
    if (!growth || !lines) throw new Error(`${title} has no lines`);
    const { count, sum, mean, integral, eta, crossings, blocked, uncovered } = lines;
    return [
      title,
      `${growth.count}`,
      scientific(growth.sum),
      `${count}`,
      scientific(sum),
      scientific(mean),
      scientific(integral),
      decimals(eta),
      `${crossings}`,
      `${blocked}`,
      `${uncovered[0].length} + ${uncovered[1].length}`,
    ];
  });
  const head = ["pair", "grown", "Σ f", "lines", "Σ f", "mean f", "J", "η", "crossings", "blocked", "uncovered"];
  return table(head, ["", ...head.slice(1).map(() => "right")], rows);
}

/**
 * @param {Directrix} dx
 * @param {Preset[]} presets
 */
function oneToOneTable(dx, presets) {
  const rows = presets.flatMap(({ title, document }) => {
    const { pairs, totals } = dx.match({ ...document, matching: { ...document.matching, oneToOne: true } });
    if (!totals.pairs) return [];
    const { count, sum, mean, integral, eta, crossings, blocked } = totals.pairs;
    const verified = pairs.filter((pair) => pair.verified).length;
    return [
      [title, `${count}`, scientific(sum), scientific(mean), scientific(integral), decimals(eta), `${verified}`, `${crossings}`, `${blocked}`],
    ];
  });
  const head = ["pair", "lines", "Σ f", "mean f", "J", "η", "verified", "crossings", "blocked"];
  return table(head, ["", ...head.slice(1).map(() => "right")], rows);
}

/** Every method with the words of its row. @type {[string, CurvesDocument["matching"]][]} */
const methods = [
  ["by parameter", { method: "parameter" }],
  ["best shift", { method: "shift" }],
  ["one per vertex", { method: "one-per-vertex" }],
  ["exact, Σ f", { method: "exact", objective: "sum" }],
  ["greedy", { method: "greedy" }],
  ["exact, J", { method: "exact" }],
];

/**
 * @param {Directrix} dx
 * @param {Preset[]} presets
 */
function methodsTable(dx, presets) {
  const rows = presets.flatMap(({ title, document }) =>
    methods.map(([name, own], k) => {
      const { normalWeight, distanceWeight, negative } = document.matching;
      const matching = { ...own, normalWeight, distanceWeight, negative, oneToOne: true };
      const { totals, gap, gapKind } = dx.match({ ...document, matching });
      const pair = k === 0 ? `**${title}**` : "";
      if (!totals.pairs) return [pair, name, "–", "–", "–", "–", "–", "–", "–"];
      const { count, mean, integral, eta, crossings, blocked } = totals.pairs;
      const broken = [`${crossings}`, `${blocked}`];
      return [pair, name, `${count}`, scientific(mean), scientific(integral), decimals(eta), ...broken, percent(gap, gapKind)];
    }),
  );
  const head = ["pair", "method", "lines", "mean f", "J", "η", "crossings", "blocked", "gap"];
  return table(head, ["", "", ...head.slice(2).map(() => "right")], rows);
}

/**
 * A table in Markdown.
 *
 * @param {string[]} head
 * @param {string[]} sides "right" for columns of numbers
 * @param {string[][]} rows
 */
function table(head, sides, rows) {
  const line = (/** @type {string[]} */ cells) => `| ${cells.join(" | ")} |`;
  return [line(head), `|${sides.map((side) => (side === "right" ? "---:" : "---")).join("|")}|`, ...rows.map(line)].join("\n");
}

const raised = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/**
 * Four significant figures, such as 1.397 × 10⁻³; a dash for what there is not.
 *
 * @param {number | null} value
 */
function scientific(value) {
  if (value === null) return "–";
  if (value >= 0.01 && value < 1000) return value.toPrecision(4);
  const [mantissa, exponent] = value.toExponential(3).split("e");
  const power = [...exponent.replace("+", "")].map((digit) => (digit === "-" ? "⁻" : raised[Number(digit)])).join("");
  return `${mantissa.replace("-", "−")} × 10${power}`;
}

/**
 * A gap in per cent, marked where it is one to the optimum on the curves themselves.
 *
 * @param {number | null} gap
 * @param {"refined" | "supremum" | "lattice" | null} kind
 */
function percent(gap, kind) {
  if (gap === null) return "–";
  const text = `${(100 * gap).toFixed(2).replace("-", "−").replace("−0.00", "0.00")} %`;
  return kind === "lattice" ? text : `${text} *`;
}

/** @param {number | null} value */
const decimals = (value) => (value === null ? "–" : value.toFixed(4).replace("-", "−"));
