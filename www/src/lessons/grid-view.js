/**
 * A figure of a grid: the transform of the features of a part pass by pass, with what happens in a column, or how far its distances are from the
 * exact ones. What it shows is the kernel's own trace.
 *
 * @import { PartDocument, Point, TransformSteps, View } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { Figure } from "../../../scripts/lib/lesson.mjs"
 * @import { FigureView, Host } from "./figure.js"
 * @import { Errors, Marks } from "./grid-known.js"
 *
 * @typedef {{document: PartDocument, pixels: number, isAnywhere: boolean}} Job
 * @typedef {{job: Job, marks: Marks, steps: TransformSteps, errors: Errors | null}} Known
 */
import "../../styles/lesson-cell.css";
import "../../styles/lesson-part.css";
import { fitting, toScreen } from "../../../js/element/plane.js";
import { segment } from "../controls/choices.js";
import { attribute, h, svg } from "../dom.js";
import { fixed } from "../format.js";
import { Lane } from "../state/lane.js";
import { shownState } from "./document.js";
import { envelopeChart, scanChart } from "./grid-chart.js";
import { centerOf, errorsOf, marksOf, measured } from "./grid-known.js";
import { fact, label, parameter } from "./parameter.js";
import { partsOf } from "./parts.js";
import { circle } from "./path.js";
import { words } from "./words-part.js";

/** Room round the grid, CSS pixels; a pixel below which numbers do not fit. */
const MARGIN = 26;
const READABLE = 17;
/** The largest error in the plane, in edges of a pixel: from any place, and from centres (Liu and others 2003, Eq. 24). */
const BOUND = Math.SQRT2;

/**
 * @param {App} app
 * @param {Host} host
 * @param {Figure} figure of the view `grid`
 * @returns {FigureView}
 */
export function createGridFigure(app, host, figure) {
  const { kernel } = app;
  const { surface } = host;
  const isError = figure.reading === "error";
  const canvas = h("canvas", { role: "img", width: 1, height: 1 });
  const now = svg("path", { class: "grid-now" });
  const lines = svg("path", { class: "grid-lines" });
  const features = svg("path", { class: "grid-features" });
  const frame = svg("path", { class: "grid-now-line" });
  const exact = svg("path", { class: "grid-true" });
  const numbers = svg("g", {});
  const over = svg("svg", { class: "lesson-grid", "aria-hidden": "true" }, now, lines, features, frame, exact, numbers);
  const status = h("p", { class: "lesson-status" });
  surface.element.prepend(canvas, /** @type {any} */ (over));

  /** @type {PartDocument | null} */
  let document = null;
  /** @type {Known | null} */
  let known = null;
  let pass = 0;
  let { pixels } = figure;
  let isAnywhere = true;
  let isOver = false;

  const passes = parameter({ label: words.pass, name: "pass", max: 1, step: 1 }, (next) => {
    pass = next;
    host.touched();
    render();
  });
  passes.value.classList.add("grid-pass");
  const count = parameter({ label: words.pixels, name: "pixels", min: 6, max: 64, step: 1 }, (next) => measure({ next }));
  const where = segment(
    { label: words.where, name: "lesson-where", choices: /** @type {const} */ (["centers", "anywhere"]).map((value) => ({ value, text: words.wheres[value] })) },
    (value) => measure({ anywhere: value === "anywhere" }),
  );
  const reading = h("div", { class: "cell-reading", "data-reading": figure.reading ?? "" });
  const controls = h(
    "div",
    { class: "cell-controls" },
    ...(isError ? [count.row, h("div", { class: "cell-parameter part-rule" }, label(words.where), where.element)] : [passes.row]),
    reading,
  );

  /** @type {Lane<Job, Known>} */
  const lane = new Lane({
    work: ask,
    done(found) {
      if (isOver) return;
      known = found;
      host.failed(null);
      render();
    },
    failed: host.failed,
  });

  /** @param {Job} job @param {AbortSignal} signal @returns {Promise<Known>} */
  async function ask(job, signal) {
    const control = { signal };
    const part = await kernel.part(job.document, control);
    const marks = marksOf(job.document, part.box ?? [[0, 0], [1, 1]], job.pixels);
    const input = { size: marks.size, features: marks.features };
    const steps = await kernel.transformSteps(input, control);
    if (!isError) return { job, marks, steps, errors: null };
    const digital = await kernel.distanceTransform(input, control);
    const ruler = await part.evaluate({ size: measured(marks, job.isAnywhere) }, control);
    const reach = job.document.bodies[0]?.features?.[0]?.to ?? NaN;
    return { job, marks, steps, errors: errorsOf(marks, digital, ruler.fractions[1], reach, job.isAnywhere) };
  }

  function paint() {
    const { width, height } = surface.size();
    if (!document || width < 1 || height < 1) return;
    if (known?.job.document === document && known.job.pixels === pixels && known.job.isAnywhere === isAnywhere) return render();
    lane.push({ document, pixels, isAnywhere });
  }

  /** @param {{next?: number, anywhere?: boolean}} patch */
  function measure({ next = pixels, anywhere = isAnywhere }) {
    [pixels, isAnywhere] = [next, anywhere];
    host.touched();
    delete host.element.dataset.drawn;
    paint();
  }

  /** @param {Marks} marks @returns {View} */
  const viewOf = ({ box }) => fitting(/** @type {Point[]} */ (/** @type {unknown} */ (box)), surface.size(), isError ? 12 : MARGIN);

  function render() {
    const found = known;
    const { width, height } = surface.size();
    if (!found || isOver || width < 1 || height < 1) return;
    const { marks, job } = found;
    const [nx, ny] = marks.size;
    const view = viewOf(marks);
    const cell = marks.edge * view.scale;
    const corner = (/** @type {number} */ x, /** @type {number} */ y) => toScreen(view, surface.size(), centerOf(marks, x - 0.5, y - 0.5));
    attribute(over, "viewBox", `0 0 ${width} ${height}`);
    attribute(canvas, "aria-label", host.alt());
    const box = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ w = 1, /** @type {number} */ h = 1) => {
      const [left, top] = corner(x, y);
      return `M${left.toFixed(1)} ${top.toFixed(1)}h${(w * cell).toFixed(1)}v${(h * cell).toFixed(1)}h${(-w * cell).toFixed(1)}Z`;
    };
    const rules = [
      ...Array.from({ length: nx + 1 }, (_, x) => `M${corner(x, 0).join(" ")}v${ny * cell}`),
      ...Array.from({ length: ny + 1 }, (_, y) => `M${corner(0, y).join(" ")}h${nx * cell}`),
    ];
    attribute(lines, "d", cell >= 8 ? rules.join("") : box(0, 0, nx, ny));
    const held = [...marks.features.keys()].filter((n) => marks.features[n] > 0);
    attribute(features, "d", isError ? "" : held.map((n) => box(n % nx, Math.floor(n / nx))).join(""));
    pass = Math.min(pass, nx + ny);
    passes.setMax(nx + ny);
    const column = pass > ny ? pass - ny - 1 : null;
    const said = pass === 0 ? words.before : column === null ? words.row(pass, ny) : words.column(column + 1, nx);
    passes.set(pass, said);
    const shown = isError || pass === 0 ? "" : column === null ? box(0, pass - 1, nx, 1) : box(column, 0, 1, ny);
    attribute(now, "d", shown);
    attribute(frame, "d", shown);
    attribute(exact, "d", isError ? circles(job.document, view) : "");
    numbers.replaceChildren(...(isError || cell < READABLE ? [] : texts(found, cell, corner)));
    count.set(pixels, String(pixels));
    where.set(isAnywhere ? "anywhere" : "centers");
    if (isError) drawErrors(found, view);
    else {
      status.hidden = figure.controls === "none";
      status.replaceChildren(h("span", {}, pass === 0 ? words.before : words.grid(said)));
      drawReading(found, column);
    }
    name(found, shown, corner, cell, column);
    host.element.dataset.drawn = "true";
  }

  /** Squared distances as far as they are known. @param {Known} found @param {number} cell @param {(x: number, y: number) => Point} corner */
  function texts({ marks, steps }, cell, corner) {
    const [nx, ny] = marks.size;
    return Array.from(marks.features, (feature, n) => {
      const [x, y] = [n % nx, Math.floor(n / nx)];
      const value = pass > ny && x <= pass - ny - 1 ? steps.levels[n] : y < pass ? steps.rows[n] : null;
      const [left, top] = corner(x, y);
      if (value === null || feature > 0) return null;
      const text = svg("text", { x: (left + cell / 2).toFixed(1), y: (top + cell / 2).toFixed(1), "font-size": String(Math.min(13, cell * 0.46)) });
      text.textContent = Number.isFinite(value) ? String(value) : "∞";
      return text;
    }).filter((each) => each !== null);
  }

  /** @param {PartDocument} document @param {View} view */
  function circles({ shapes = [] }, view) {
    const round = shapes.flatMap((shape) => (shape.kind === "circle" ? [circle(toScreen(view, surface.size(), shape.center), shape.radius * view.scale)] : []));
    return round.join("");
  }

  /** @param {Known} found @param {number | null} column */
  function drawReading({ marks, steps }, column) {
    const [nx, ny] = marks.size;
    if (column === null) {
      reading.replaceChildren(h("p", { class: "cell-label" }, words.none));
      return;
    }
    const own = steps.columns[column];
    const levels = Array.from({ length: ny }, (_, y) => steps.rows[y * nx + column]);
    const row = (/** @type {string} */ text, /** @type {string} */ name, /** @type {number} */ value) => fact(text, name, String(value));
    if (figure.reading === "scan") {
      const sum = (/** @type {"reach" | "count"} */ key) => own.searches.reduce((all, each) => all + each[key], 0);
      reading.replaceChildren(
        scanChart(levels, own.searches, column + 1),
        h("dl", {}, ...row(words.scan.searches, "searches", own.searches.length), ...row(words.scan.allowed, "allowed", sum("reach")), ...row(words.scan.compared, "compared", sum("count")), ...row(words.scan.all, "all", ny * (ny - 1))),
      );
      return;
    }
    reading.replaceChildren(
      envelopeChart(levels, own.corners, column + 1),
      h("dl", {}, ...row(words.envelope.parabolas, "parabolas", levels.filter(Number.isFinite).length), ...row(words.envelope.corners, "corners", own.corners.length)),
    );
  }

  /** @param {Known} found @param {View} view */
  function drawErrors({ marks, errors, job }, view) {
    if (!errors) return;
    const { width, height } = surface.size();
    const ratio = surface.zoom * (window.devicePixelRatio || 1);
    [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    const context = canvas.getContext("2d");
    if (!context) return;
    context.fillStyle = getComputedStyle(host.element).getPropertyValue("--accent");
    const step = (marks.edge * view.scale * ratio * marks.size[0]) / errors.size[0];
    const [left, top] = toScreen(view, surface.size(), centerOf(marks, -0.5, -0.5)).map((each) => each * ratio);
    errors.errors.forEach((error, n) => {
      context.globalAlpha = Math.min(1, 0.04 + (0.96 * error) / BOUND);
      const [x, y] = [left + (n % errors.size[0]) * step, top + Math.floor(n / errors.size[0]) * step];
      context.fillRect(Math.floor(x), Math.floor(y), Math.floor(x + step) - Math.floor(x), Math.floor(y + step) - Math.floor(y));
    });
    const unit = job.document.unit ?? "mm";
    const bound = job.isAnywhere ? BOUND : BOUND / 2;
    const both = (/** @type {number} */ value) => `${words.error.edges(fixed(value, 3))} = ${words.error.in(fixed(value * marks.edge, 3), unit)}`;
    reading.replaceChildren(
      h("p", { class: "grid-scale", "aria-label": words.error.picture }, "0", h("span", {}), fixed(BOUND, 3)),
      h("dl", {}, ...fact(words.error.worst, "worst", both(errors.worst)), ...fact(words.error.mean, "mean", both(errors.mean)), ...fact(words.error.bound, "bound", both(bound))),
    );
    status.hidden = true;
  }

  /** @param {Known} found @param {string} shown @param {(x: number, y: number) => Point} corner @param {number} cell @param {number | null} column */
  function name({ marks, steps }, shown, corner, cell, column) {
    const [nx, ny] = marks.size;
    const square = (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ w = 1, /** @type {number} */ h = 1) => {
      const [left, top] = corner(x, y);
      return /** @type {Point[]} */ ([[left, top], [left + w * cell, top], [left + w * cell, top + h * cell], [left, top + h * cell]]);
    };
    surface.name(
      partsOf(host.terms, {
        features: () => ({ area: [...marks.features.keys()].filter((n) => marks.features[n] > 0).map((n) => square(n % nx, Math.floor(n / nx))) }),
        pass: () => ({ area: shown === "" ? [] : [column === null ? square(0, pass - 1, nx, 1) : square(column, 0, 1, ny)] }),
        wide: () => ({ area: column === null ? [] : steps.columns[column].corners.map((y) => square(column, y)) }),
      }),
    );
  }

  return {
    status,
    controls: figure.controls === "none" ? null : controls,
    show(next) {
      document = /** @type {PartDocument} */ (/** @type {unknown} */ (next));
      [pass, pixels, isAnywhere, known] = [figure.at ?? 0, figure.pixels, true, null];
      paint();
    },
    draw: paint,
    state: () => shownState(document),
    close() {
      isOver = true;
      lane.cancel();
    },
  };
}
