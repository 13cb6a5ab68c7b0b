/**
 * Comparing solvers: a table of runs of the problem as it stands, their residuals, and how error and time go with the number of panels.
 *
 * @import { LaboratoryDocument } from "../document.js"
 * @import { Bench } from "../state.js"
 * @import { Curve } from "./chart.js"
 * @import { Run, Size } from "./runs.js"
 */
import "../../../styles/solvers.css";
import { attribute, h, write } from "../../dom.js";
import { download } from "../../files/download.js";
import { fileName } from "../../files/names.js";
import { fixed, milliseconds, percent } from "../../format.js";
import { numberText } from "../../space/measure.js";
import { isSameProblem, MOST } from "../document.js";
import { solverOf } from "../edits.js";
import { inSize, isNamed, MODELS } from "../models.js";
import { words as page } from "../words.js";
import { createChart } from "./chart.js";
import { csvOf } from "./csv.js";
import { createRuns, slopeOf } from "./runs.js";
import { words } from "./words.js";

/** Elements up to which runs begin by themselves when the laboratory is entered. */
const AT_ONCE = 1500;
/** Preconditioners of GMRES whose iterations are compared. */
const GMRES = /** @type {const} */ (["none", "jacobi", "ssor"]);
/** Iterations in the table of residuals that is read aloud, at most. */
const LISTED = 24;
/** Colours that are told apart by colour-blind readers as well (Okabe and Ito), on a light and on a dark ground. */
const COLORS = /** @type {const} */ ({
  light: { none: "#d55e00", jacobi: "#0072b2", ssor: "#009e73", lu: "#17191d" },
  dark: { none: "#f0883e", jacobi: "#56b4e9", ssor: "#2fc99a", lu: "#f3f4f7" },
});

/** @param {Bench} bench @param {HTMLElement} place */
export function createSolvers(bench, place) {
  const { app } = bench;
  const runs = createRuns(bench, bench.request);
  const about = h("p", { class: "solvers-about" });
  const told = h("p", { class: "solvers-told", hidden: true, "data-solvers-told": "" });
  const button = (/** @type {string} */ name, /** @type {string} */ label, /** @type {() => void} */ act) => h("button", { type: "button", class: "push", "data-solvers": name, onclick: act }, label);
  const run = button("run", words.run, () => (runs.running === "methods" ? runs.cancel() : compare()));
  const save = button("csv", words.csv, () => saveRows("residuals"));
  const body = h("tbody", {});
  const heads = [words.runs.method, words.runs.assembly, words.runs.solve, words.runs.iterations, words.runs.residual, words.runs.preconditioned, words.runs.error];
  const table = h(
    "table",
    { class: "solvers-table", "data-solvers-table": "" },
    h("caption", { class: "spoken" }, words.runs.heading),
    h("thead", {}, h("tr", {}, ...heads.map((head, k) => h("th", { scope: "col", class: k > 0 ? "number" : "" }, head, k === 1 || k === 2 ? h("span", { class: "solvers-unit" }, ` ${words.runs.ms}`) : null)))),
    body,
  );
  const condition = h("p", { class: "solvers-fact", "data-solvers-condition": "" });
  const residuals = createChart({
    name: "residuals",
    label: words.residuals.label,
    across: words.residuals.across,
    up: words.residuals.up,
    isLogAcross: false,
    place: (value) => words.residuals.at(value),
    value: numberText,
    say: app.say,
  });
  const listed = h("div", { class: "spoken" });
  const panels = (/** @type {number} */ value) => fixed(value, 0);
  const error = createChart({ name: "error", label: words.sizes.error.label, across: words.sizes.error.across, up: words.sizes.error.up, isLogAcross: true, place: panels, value: numberText, say: app.say });
  const time = createChart({ name: "time", label: words.sizes.time.label, across: words.sizes.time.across, up: words.sizes.time.up, isLogAcross: true, place: panels, value: (ms) => `${milliseconds(ms)} ms`, say: app.say });
  const iterations = createChart({ name: "iterations", label: words.sizes.iterations.label, across: words.sizes.iterations.across, up: words.sizes.iterations.up, isLogAcross: true, isLinearUp: true, place: panels, value: (count) => fixed(count, 0), say: app.say });
  const omegas = createChart({ name: "omegas", label: words.omegas.label, across: words.omegas.across, up: words.omegas.up, isLogAcross: false, isLinearUp: true, span: [0, 2], place: words.omegas.at, value: (count) => fixed(count, 0), say: app.say });
  const sweep = button("sweep", words.omegas.run, () => (runs.running === "omegas" ? runs.cancel() : runs.sweep(bench.now().document)));
  const omegasAbout = h("p", { class: "solvers-about" });
  const omegasTable = h("div", {});
  const sweepPart = h(
    "section",
    { class: "solvers-part", "aria-labelledby": "solvers-omegas" },
    h("div", { class: "solvers-head" }, h("h2", { id: "solvers-omegas" }, words.omegas.heading), h("div", { class: "solvers-acts" }, sweep)),
    omegasAbout,
    omegas.element,
    omegasTable,
  );
  const grow = button("grow", words.sizes.run, () => (runs.running === "sizes" ? runs.cancel() : runs.grow(bench.now().document)));
  const saveSizes = button("csv-sizes", words.csv, () => saveRows("sizes"));
  const sizesAbout = h("p", { class: "solvers-about" });
  const slope = h("p", { class: "solvers-fact", "data-solvers-slope": "" });
  const sizesTable = h("div", {});
  const charts = h("div", { class: "solvers-charts" }, error.element, iterations.element, time.element);
  const sizes = h(
    "section",
    { class: "solvers-part", "aria-labelledby": "solvers-sizes" },
    h("div", { class: "solvers-head" }, h("h2", { id: "solvers-sizes" }, words.sizes.heading), h("div", { class: "solvers-acts" }, grow, saveSizes)),
    sizesAbout,
    slope,
    charts,
    sizesTable,
  );
  const element = h(
    "div",
    { class: "solvers" },
    h(
      "section",
      { class: "solvers-part", "aria-labelledby": "solvers-runs" },
      h("div", { class: "solvers-head" }, h("h2", { id: "solvers-runs" }, words.heading), h("div", { class: "solvers-acts" }, run, save)),
      about,
      told,
      h("div", { class: "solvers-scroll" }, table),
      condition,
      residuals.element,
      listed,
      h("p", { class: "lab-note" }, words.runs.note),
    ),
    sweepPart,
    sizes,
  );
  place.append(element);
  /** The opening of a document for which runs were begun without being asked for. */
  let begun = "";
  let drawn = "";

  function compare() {
    const { document, known } = bench.now();
    if (known) runs.compare(document, known.mesh.count);
  }

  /** @param {"residuals" | "sizes"} what */
  function saveRows(what) {
    const name = `${fileName(bench.now().document.title)}-${what}.csv`;
    const rows = what === "residuals" ? residualRows(runs.found?.runs ?? []) : sizeRows(runs.series?.sizes ?? []);
    download(new Blob([csvOf(rows)], { type: "text/csv" }), name);
    app.say(words.written(name));
  }

  /** @param {Run} each @param {boolean} [isBrief] */
  const methodOf = (each, isBrief = false) => (each.method === "ssor" ? (isBrief ? "SSOR" : words.runs.methods.ssor(fixed(each.omega, 2))) : isBrief ? words.runs.methods[each.method].replace(/^GMRES, /, "") : words.runs.methods[each.method]);

  /** The rows of the table. @param {Run[]} all @param {boolean} hasExact */
  function rowsOf(all, hasExact) {
    return all.map((each) => {
      const { outcome, method, state } = each;
      const name = h("th", { scope: "row" }, key(method), methodOf(each));
      if (!outcome) return h("tr", { "data-run": method, "data-state": state }, name, h("td", { colSpan: heads.length - 1, class: "solvers-waits" }, state === "runs" ? words.runs.runs : state === "waits" ? words.runs.waits : each.reason));
      const cell = (/** @type {string} */ text) => h("td", { class: "number" }, text);
      return h(
        "tr",
        { "data-run": method, "data-state": state },
        name,
        cell(milliseconds(outcome.assembly)),
        cell(milliseconds(outcome.solve)),
        cell(method === "lu" ? words.runs.elimination : `${outcome.iterations}${outcome.converged ? "" : ` (${words.runs.notConverged})`}`),
        cell(numberText(outcome.residuals.at(-1) ?? 0)),
        cell(method === "lu" ? words.runs.elimination : numberText(outcome.preconditioned.at(-1) ?? 0)),
        cell(outcome.error === null ? (hasExact ? "" : words.runs.elimination) : numberText(outcome.error)),
      );
    });
  }

  /** @param {Run["method"]} method */
  function key(method) {
    const line = h("span", { class: "solvers-key", "aria-hidden": "true" });
    line.style.backgroundColor = COLORS[app.ui.value.theme][method];
    return line;
  }

  /** @param {Run[]} all @returns {Curve[]} */
  const curvesOf = (all) =>
    all.flatMap((each) => {
      if (!each.outcome || each.method === "lu") return [];
      const color = COLORS[app.ui.value.theme][each.method];
      return [
        { name: words.residuals.true(methodOf(each, true)), color, dashed: false, points: false, wide: each.method === "none", values: each.outcome.residuals.map(positive) },
        { name: words.residuals.preconditioned(methodOf(each, true)), color, dashed: true, points: false, values: each.outcome.preconditioned.map(positive) },
      ];
    });

  function renderRuns() {
    const { document, known } = bench.now();
    const { found } = runs;
    const isStale = found !== null && !isSameProblem(found.document, document);
    const isRunning = runs.running === "methods";
    const all = found?.runs ?? [];
    const hasExact = known?.boundary.exact != null;
    write(run, isRunning ? words.cancel : found ? words.again : words.run);
    save.disabled = !all.some(({ outcome }) => outcome);
    element.classList.toggle("stale", isStale);
    const current = all.find(({ state }) => state === "runs");
    const ready = known?.boundary.ready ?? true;
    const text = isRunning ? words.working(current ? methodOf(current) : words.runs.condition, percent(runs.progress)) : !ready ? words.faulty : isStale ? words.stale : !found && known && known.mesh.count > AT_ONCE ? words.large : "";
    run.disabled = !ready && !isRunning;
    told.hidden = text === "";
    told.classList.toggle("warning", isStale && !isRunning);
    write(told, text);
    if (known) write(about, words.about(document.title, fixed(known.mesh.count, 0), page.model.elements(known.mesh.count, known.boundary.dimension)));
    body.replaceChildren(...rowsOf(all, hasExact));
    condition.hidden = found?.condition == null;
    write(condition, found?.condition == null ? "" : `${words.runs.condition}: ${numberText(found.condition)}`);
    const curves = curvesOf(all);
    const length = Math.max(0, ...curves.map(({ values }) => values.length));
    const summary = words.residuals.summary(all.flatMap((each) => (each.outcome && each.method !== "lu" ? [words.residuals.part(methodOf(each), each.outcome.iterations, numberText(each.outcome.residuals.at(-1) ?? 0))] : [])));
    residuals.element.hidden = curves.length === 0;
    residuals.set({ places: Array.from({ length }, (_, k) => k), curves: curves.map((curve) => ({ ...curve, values: padded(curve.values, length) })) }, app.ui.value.theme, summary);
    listed.replaceChildren(...(curves.length > 0 ? [spokenTable(words.residuals.table, [words.residuals.across, ...curves.map(({ name }) => name)], sampled(length).map((k) => [String(k), ...curves.map(({ values }) => (values[k] == null ? "" : numberText(Number(values[k]))))]))] : []));
  }

  function renderSizes() {
    const { document, known } = bench.now();
    const { model } = document;
    const { series } = runs;
    const isNumbered = isNamed(model);
    const isRunning = runs.running === "sizes";
    const isStale = series !== null && !isSameFamily(series.document, document);
    grow.disabled = (!isNumbered || known?.boundary.ready === false) && !isRunning;
    write(grow, isRunning ? words.cancel : series ? words.again : words.sizes.run);
    saveSizes.disabled = !series || series.sizes.length === 0;
    const of = isNumbered ? words.sizes.about(page.model.fields[MODELS[model.kind].sizes.field].toLowerCase(), MODELS[model.kind].sizes.values.join(", ")) : words.sizes.none;
    write(sizesAbout, isRunning ? words.working(of, percent(runs.progress)) : series && isStale ? words.stale : of);
    sizes.classList.toggle("stale", isStale);
    const all = series?.sizes ?? [];
    const theme = app.ui.value.theme;
    const own = solverOf(document).preconditioner;
    const places = all.map(({ elements }) => elements);
    const errors = all.map((each) => positive(each.error));
    const measured = all.flatMap((each) => (each.error !== null && each.error > 0 ? [{ x: each.elements, y: each.error }] : []));
    const fit = slopeOf(measured);
    slope.hidden = all.length === 0;
    const bySteps = slopeOf(all.flatMap((each) => (each.error !== null && each.error > 0 ? [{ x: each.size, y: each.error }] : [])));
    const field = isNumbered ? MODELS[model.kind].sizes.field : "";
    const steps = field === "level" || bySteps === null ? "" : words.sizes.steps(page.model.fields[field].toLowerCase(), fixed(bySteps, 2));
    write(slope, fit === null ? (all.some((each) => each.error !== null) ? "" : words.sizes.noExact) : `${words.sizes.slope(fixed(fit, 2), measured.length)}${steps}`);
    charts.hidden = all.length === 0;
    error.element.hidden = measured.length === 0;
    const line = fit === null ? null : fitted(measured, fit);
    error.set(
      {
        places,
        curves: [
          { name: words.sizes.error.name, color: COLORS[theme].jacobi, dashed: false, points: true, values: errors },
          ...(fit !== null && line ? [{ name: words.sizes.error.fit(fixed(fit, 2)), color: "--text-2", dashed: true, points: false, values: places.map(line) }] : []),
        ],
      },
      theme,
      slope.textContent ?? "",
    );
    const ms = (/** @type {string} */ name, /** @type {string} */ color, /** @type {(size: Size) => number | null | undefined} */ of) => ({ name, color, dashed: false, points: true, values: all.map((each) => positive(of(each) ?? null)) });
    time.set(
      {
        places,
        curves: [
          { ...ms(words.sizes.time.assembly, "--text-2", (each) => each.outcomes[own]?.assembly), dashed: true },
          ms(words.sizes.time.gmres, COLORS[theme][own], (each) => each.outcomes[own]?.solve),
          ms(words.sizes.time.lu, COLORS[theme].lu, (each) => each.outcomes.lu?.solve),
        ],
      },
      theme,
      words.sizes.time.label,
    );
    iterations.set(
      { places, curves: GMRES.map((method) => ms(words.sizes.iterations.methods[method], COLORS[theme][method], (each) => each.outcomes[method]?.iterations)) },
      theme,
      words.sizes.iterations.label,
    );
    sizesTable.replaceChildren(...(all.length > 0 ? [spokenTable(words.sizes.table, sizeRows(all)[0].map(String), sizeRows(all).slice(1).map((row) => row.map((value) => (typeof value === "number" ? numberText(value) : value))))] : []));
  }

  function renderOmegas() {
    const { document, known } = bench.now();
    const { swept } = runs;
    const isRunning = runs.running === "omegas";
    const isStale = swept !== null && !isSameProblem(swept.document, document);
    const trials = swept?.trials ?? [];
    const best = trials.filter(({ converged }) => converged).reduce((least, each) => (least && least.iterations <= each.iterations ? least : each), /** @type {import("./runs.js").Trial | null} */ (null));
    sweep.disabled = (known?.boundary.ready === false || (known?.mesh.count ?? 0) > MOST.ssor) && !isRunning;
    write(sweep, isRunning ? words.cancel : swept ? words.again : words.omegas.run);
    sweepPart.classList.toggle("stale", isStale);
    write(omegasAbout, isRunning ? words.working(words.omegas.label, percent(runs.progress)) : isStale ? words.stale : best ? words.omegas.best(fixed(best.omega, 1), best.iterations) : words.omegas.about);
    omegas.element.hidden = trials.length === 0;
    const rows = trials.map((each) => [fixed(each.omega, 1), `${each.iterations}${each.converged ? "" : ` (${words.runs.notConverged})`}`]);
    omegas.set(
      { places: trials.map(({ omega }) => omega), curves: [{ name: words.omegas.up, color: COLORS[app.ui.value.theme].ssor, dashed: false, points: true, values: trials.map((each) => each.iterations) }] },
      app.ui.value.theme,
      omegasAbout.textContent ?? "",
    );
    omegasTable.replaceChildren(...(rows.length > 0 ? [spokenTable(words.omegas.label, [words.omegas.across, words.omegas.up], rows)] : []));
  }

  return {
    render() {
      const { document, known, isCurrent, shown } = bench.now();
      if (shown.look !== "solvers") return;
      const isReady = known !== null && isCurrent && known.solution !== null;
      // Once for each opening of a document, when its own solution is there.
      if (isReady && begun !== app.store.origin.name && known.mesh.count <= AT_ONCE) {
        begun = app.store.origin.name;
        compare();
        return;
      }
      const key = JSON.stringify([document.title, isCurrent, known?.mesh.count, known?.boundary.ready, runs.found?.runs, runs.found?.condition, runs.running, runs.progress, runs.series?.sizes, runs.swept?.trials, document.solver, app.ui.value.theme, begun]) + (runs.found && isSameProblem(runs.found.document, document)) + (runs.series && runs.series.document === document) + document.model.kind;
      if (key === drawn) return;
      drawn = key;
      attribute(element, "aria-busy", String(runs.running !== ""));
      renderRuns();
      renderOmegas();
      renderSizes();
    },
    close() {
      runs.close();
      for (const chart of [residuals, omegas, error, iterations, time]) chart.close();
    },
  };
}

/** Whether a series of one document is one of the other as well, whatever the size of its body. @param {LaboratoryDocument} a @param {LaboratoryDocument} b */
function isSameFamily(a, b) {
  if (a.model.kind !== b.model.kind || !isNamed(a.model) || JSON.stringify(inSize(a.model, 0)) !== JSON.stringify(inSize(b.model, 0))) return false;
  return isSameProblem({ ...a, model: b.model }, b);
}

/** What a logarithmic axis can show. @param {number | null} value */
const positive = (value) => (value !== null && value > 0 ? value : null);

/** @param {(number | null)[]} values @param {number} length */
const padded = (values, length) => [...values, ...Array.from({ length: length - values.length }, () => null)];

/** Some of so many iterations, the last one among them. @param {number} length */
function sampled(length) {
  const step = Math.max(1, Math.ceil((length - 1) / LISTED));
  const found = Array.from({ length: Math.ceil(length / step) }, (_, k) => k * step);
  return found.at(-1) === length - 1 ? found : [...found, length - 1];
}

/** The straight line of a slope through the middle of points, on logarithmic axes. @param {{x: number, y: number}[]} points @param {number} slope */
function fitted(points, slope) {
  const mean = (/** @type {(point: {x: number, y: number}) => number} */ of) => points.reduce((sum, point) => sum + Math.log(of(point)), 0) / points.length;
  const [x, y] = [mean((point) => point.x), mean((point) => point.y)];
  return (/** @type {number} */ at) => Math.exp(y + slope * (Math.log(at) - x));
}

/** A table for screen readers. @param {string} caption @param {readonly string[]} heads @param {(string | number)[][]} rows */
const spokenTable = (caption, heads, rows) =>
  h(
    "table",
    { class: "spoken" },
    h("caption", {}, caption),
    h("thead", {}, h("tr", {}, ...heads.map((head) => h("th", { scope: "col" }, head)))),
    h("tbody", {}, ...rows.map(([first, ...rest]) => h("tr", {}, h("th", { scope: "row" }, String(first)), ...rest.map((each) => h("td", {}, String(each)))))),
  );

/** Residuals as rows of a file. @param {Run[]} runs */
function residualRows(runs) {
  const done = runs.flatMap(({ method, outcome }) => (outcome ? [{ method, outcome }] : []));
  const length = Math.max(0, ...done.map(({ outcome }) => outcome.residuals.length));
  return [
    ["iteration", ...done.flatMap(({ method }) => [method, `${method} preconditioned`])],
    ...Array.from({ length }, (_, k) => [k, ...done.flatMap(({ outcome }) => [outcome.residuals[k] ?? "", outcome.preconditioned[k] ?? ""])]),
  ];
}

/** Sizes as rows of a file. @param {Size[]} sizes @returns {(string | number)[][]} */
function sizeRows(sizes) {
  return [
    ["panels", "largest error", "set-up ms", ...GMRES.flatMap((method) => [`${method} ms`, `${method} iterations`]), "lu ms"],
    ...sizes.map(({ elements, error, outcomes }) => [
      elements,
      error ?? "",
      outcomes.jacobi?.assembly ?? "",
      ...GMRES.flatMap((method) => [outcomes[method]?.solve ?? "", outcomes[method]?.iterations ?? ""]),
      outcomes.lu?.solve ?? "",
    ]),
  ];
}
