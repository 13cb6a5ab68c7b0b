/**
 * A figure of a part: painted from the kernel's colours, with its features, a place that is read, and a line along which compositions are shown
 * as a chart. The limit of a feature, its course and the overlap rule can be changed.
 *
 * @import { PartDocument, PartPlace, Point, RemotePart, View } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument } from "../types.js"
 * @import { Figure } from "../../../scripts/lib/lesson.mjs"
 * @import { FigureView, Host } from "./figure.js"
 * @import { Part, Parts } from "./parts.js"
 * @import { Along, RuleRow } from "./part-known.js"
 *
 * @typedef {{document: PartDocument, place: Point | null, view: View}} Job
 * @typedef {object} Known
 * @property {Job} job
 * @property {HTMLCanvasElement} picture
 * @property {PartPlace | null} found at the place
 * @property {Along | null} along
 * @property {RuleRow[]} rows
 */
import "../../styles/lesson-cell.css";
import "../../styles/lesson-part.css";
import { pictureOf } from "../../../js/element/part/picture.js";
import { fitting, toPlane, toScreen } from "../../../js/element/plane.js";
import { segment } from "../controls/choices.js";
import { select } from "../controls/select.js";
import { slider } from "../controls/slider.js";
import { attribute, h, svg, write } from "../dom.js";
import { fixed } from "../format.js";
import { Lane } from "../state/lane.js";
import { ruleChart, stackChart } from "./part-chart.js";
import { COURSES, distanceOf, featureOf, materialOf, RULES, ruleRow, withFeature, withRule } from "./part-known.js";
import { createPlaceHandle } from "./place-handle.js";
import { words } from "./words-part.js";

/** Room round the part, CSS pixels. */
const MARGIN = 38;
/** Pixels that are evaluated, at rest and while something is dragged. */
const MOST = 900_000;
const MOVING = 90_000;
const IDLE = 200;
/** Steps of the slider of a limit. */
const STEPS = 100;

/**
 * @param {App} app
 * @param {Host} host
 * @param {Figure} figure of the view `part`
 * @returns {FigureView}
 */
export function createPartFigure(app, host, figure) {
  const { kernel } = app;
  const { surface } = host;
  const canvas = h("canvas", { role: "img", width: 1, height: 1 });
  const status = h("p", { class: "lesson-status" });
  const shapes = svg("path", { class: "part-shapes" });
  const chosen = svg("path", { class: "part-chosen" });
  const line = svg("path", { class: "part-line" });
  const over = svg("svg", { class: "lesson-part", "aria-hidden": "true" }, shapes, chosen, line);
  const handle = createPlaceHandle({
    placeOf: surface.placeOf,
    at: () => place && seen(place),
    put,
    released: () => isMoving && rest(),
    moved: () => place && app.say(words.moved(fixed(place[0], 1), fixed(place[1], 1))),
  });
  const handles = h("div", { class: "lesson-handles", hidden: figure.place === null }, handle.element);
  surface.element.prepend(canvas, /** @type {any} */ (over));
  surface.element.append(handles);

  /** @type {PartDocument | null} */
  let document = null;
  /** @type {PartDocument | null} */
  let first = null;
  /** @type {readonly Point[]} */
  let box = [];
  /** @type {Known | null} */
  let known = null;
  /** @type {Point | null} */
  let place = figure.place;
  let isMoving = false;
  let isOver = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let idle;

  const limits = figure.limit ?? [1, 2];
  const limit = slider(
    { label: words.limit, name: "lesson-limit", min: limits[0], max: limits[1], step: (limits[1] - limits[0]) / STEPS },
    { change: (to) => change({ to: Number(to.toPrecision(6)) }) },
  );
  const limitText = h("span", { class: "number strong", "data-lesson": "limit" });
  const course = select(
    { label: words.course, name: "lesson-course", choices: Object.entries(words.courses).map(([value, text]) => ({ value, text })) },
    (name) => change({ course: COURSES[/** @type {keyof typeof COURSES} */ (name)] }, false),
  );
  const rule = segment({ label: words.rule, name: "lesson-overlap", choices: RULES.map((value) => ({ value, text: words.rules[value] })) }, (next) => {
    if (!document) return;
    document = withRule(document, next);
    touch(false);
  });
  const label = (/** @type {string} */ text) => h("span", { class: "cell-label" }, text);
  const reading = h("div", { class: "cell-reading", "data-reading": figure.reading ?? "" });
  const controls = h(
    "div",
    { class: "cell-controls" },
    ...(figure.limit ? [h("div", { class: "cell-parameter" }, label(words.limit), limit.element, limitText)] : []),
    ...(figure.courses || figure.overlap
      ? [h("div", { class: "cell-parameters" }, ...(figure.courses ? [h("div", { class: "cell-parameter part-course" }, label(words.course), course.element)] : []), ...(figure.overlap ? [h("div", { class: "cell-parameter part-rule" }, label(words.rule), rule.element)] : []))]
      : []),
    reading,
  );

  /** @type {Lane<Job, Known>} */
  const lane = new Lane({
    work: (job, signal) => ask(job, signal),
    done(found) {
      if (isOver) return;
      known = found;
      host.failed(null);
      [canvas.width, canvas.height] = [found.picture.width, found.picture.height];
      canvas.getContext("2d")?.drawImage(found.picture, 0, 0);
      render();
      if (found.job.document === document && found.job.place === place) host.element.dataset.drawn = "true";
    },
    failed(error) {
      if (isOver || /** @type {Error} */ (error).name === "AbortError") return;
      host.failed(error);
    },
  });

  /** @param {Job} job @param {AbortSignal} signal @returns {Promise<Known>} */
  async function ask(job, signal) {
    const control = { signal };
    const part = await kernel.part(job.document, control);
    const ratio = surface.zoom * (window.devicePixelRatio || 1);
    const picture = await pictureOf(part, { view: job.view, size: surface.size(), ratio, most: isMoving ? MOVING : MOST }, control);
    const found = job.place ? await part.probe(job.place, control) : null;
    const [a, b, c, d] = figure.line ?? [0, 0, 0, 0];
    const along = figure.reading === "along" && figure.line ? await part.along([[a, b], [c, d]], 201, control) : null;
    /** @type {RuleRow[]} */
    const rows = [];
    if (figure.reading === "rules" && figure.line && job.place) {
      const material = materialOf(job.document, figure.feature);
      const open = (/** @type {PartDocument} */ each) => /** @type {Promise<RemotePart>} */ (kernel.part(each, control));
      for (const each of RULES) rows.push(await ruleRow(open, job.document, each, material, job.place, figure.line, control));
    }
    return { job, picture, found, along, rows };
  }

  function view() {
    const size = surface.size();
    return fitting(box, size, MARGIN);
  }

  function paint() {
    const { width, height } = surface.size();
    if (!document || width < 1 || height < 1) return;
    lane.push({ document, place, view: view() });
    drawOver();
  }

  /** @param {object} patch of the feature @param {boolean} [isDrag] */
  function change(patch, isDrag = true) {
    if (!document) return;
    document = withFeature(document, figure.feature, patch);
    touch(isDrag);
  }

  /** Something is different. @param {boolean} isDrag whether more of it is about to come */
  function touch(isDrag) {
    host.touched();
    delete host.element.dataset.drawn;
    isMoving = isDrag;
    clearTimeout(idle);
    if (isDrag) idle = setTimeout(rest, IDLE);
    face();
    paint();
  }

  function rest() {
    isMoving = false;
    paint();
  }

  function face() {
    const own = document && featureOf(document, figure.feature);
    if (!own) return;
    const unit = document?.unit ?? "mm";
    limit.set(own.to);
    write(limitText, words.unit(fixed(own.to, 1), unit));
    attribute(limit.input, "aria-valuetext", words.unit(fixed(own.to, 1), unit));
    course.set(own.course?.kind ?? "linear");
    rule.set(document?.bodies[figure.feature[0]]?.rule ?? "repaired");
  }

  /** @param {Point} at */
  const seen = (at) => toScreen(view(), surface.size(), at);

  function drawOver() {
    if (!document) return;
    const { width, height } = surface.size();
    attribute(over, "viewBox", `0 0 ${width} ${height}`);
    const names = references(document);
    attribute(shapes, "d", names.map((name) => drawn(name)).join(""));
    const own = featureOf(document, figure.feature);
    attribute(chosen, "d", own && typeof own.reference === "string" && (figure.limit || figure.reading) ? drawn(own.reference) : "");
    const ends = figure.line ? [seen([figure.line[0], figure.line[1]]), seen([figure.line[2], figure.line[3]])] : [];
    attribute(line, "d", ends.length > 0 ? `M${ends.map(written).join("L")}` : "");
    if (place) handle.show(surface.zoom, words.place(fixed(place[0], 1), fixed(place[1], 1)));
    name(ends);
  }

  /** Path data of a shape. @param {string} name */
  function drawn(name) {
    const shape = document?.shapes?.find((each) => each.name === name);
    if (!shape) return "";
    if (shape.kind === "segment") return `M${[shape.from, shape.to].map((at) => written(seen(at))).join("L")}`;
    if (shape.kind === "polygon" || shape.kind === "polyline") return `M${shape.points.map((at) => written(seen(at))).join("L")}${shape.kind === "polygon" ? "Z" : ""}`;
    if (shape.kind === "circle") {
      const [x, y] = seen(shape.center);
      const radius = shape.radius * view().scale;
      return `M${x - radius} ${y}a${radius} ${radius} 0 1 0 ${2 * radius} 0a${radius} ${radius} 0 1 0 ${-2 * radius} 0Z`;
    }
    return shape.kind === "point" ? `M${written(seen(shape.at))}h.01` : "";
  }

  /** What the terms of the text mean. @param {Point[]} ends */
  function name(ends) {
    if (!document) return;
    const lines = (/** @type {string} */ shape) => pointsOf(shape);
    const own = featureOf(document, figure.feature);
    /** @type {{[name: string]: () => Part}} */
    const all = {
      features: () => ({ lines: references(/** @type {PartDocument} */ (document)).map(lines) }),
      feature: () => ({ lines: own && typeof own.reference === "string" ? [lines(own.reference)] : [] }),
      section: () => ({ lines: ends.length > 0 ? [ends] : [] }),
      place: () => ({ dots: place ? [seen(place)] : [] }),
    };
    /** @type {Parts} */
    const parts = new Map();
    for (const term of host.terms) if (all[term]) parts.set(term, all[term]());
    surface.name(parts);
  }

  /** The points of a shape on the screen. @param {string} name @returns {Point[]} */
  function pointsOf(name) {
    const shape = document?.shapes?.find((each) => each.name === name);
    if (shape?.kind === "segment") return [seen(shape.from), seen(shape.to)];
    if (shape?.kind === "polyline") return shape.points.map(seen);
    if (shape?.kind === "polygon") return [...shape.points, ...shape.points.slice(0, 1)].map(seen);
    if (shape?.kind !== "circle") return [];
    const { center, radius } = shape;
    return Array.from({ length: 65 }, (_, n) => seen([center[0] + radius * Math.cos((n * Math.PI) / 32), center[1] + radius * Math.sin((n * Math.PI) / 32)]));
  }

  function render() {
    drawOver();
    attribute(canvas, "aria-label", host.alt());
    const now = known;
    if (!now) return;
    const { materials = [], unit = "mm" } = now.job.document;
    const item = (/** @type {string} */ text, /** @type {string} */ value, /** @type {string} */ own) =>
      h("span", {}, `${text} `, h("span", { class: "strong number", "data-lesson": own }, value));
    status.hidden = figure.controls === "none" || !now.job.place;
    // By the printed rule a place has what its voxel has, which the reading knows of the material of the feature.
    const printed = now.rows.find((row) => row.rule === "printed");
    const asked = materialOf(now.job.document, figure.feature);
    const fractions = now.found?.fractions ?? (printed ? materials.map((_, k) => (k === asked ? printed.here : 0)) : []);
    const shares = fractions.flatMap((fraction, k) => (fraction >= 5e-4 ? [item(materials[k]?.name ?? "", fixed(fraction, 3), `mix-${k}`)] : []));
    status.replaceChildren(...(now.found ? shares : [h("span", {}, words.outside)]));
    const length = figure.line ? Math.hypot(figure.line[2] - figure.line[0], figure.line[3] - figure.line[1]) : 1;
    const own = featureOf(now.job.document, figure.feature);
    if (now.along) {
      const here = now.found ? distanceOf(now.found, figure.feature[1]) : null;
      const rows = now.found
        ? [h("dt", {}, words.along.distance(own?.name ?? "")), h("dd", { "data-lesson": "distance" }, words.unit(fixed(here ?? NaN, 2), unit))]
        : [];
      reading.replaceChildren(stackChart(now.along, materials, { length, limit: own?.to ?? NaN, here }), h("dl", {}, ...rows));
    } else if (now.rows.length > 0 && now.job.place && figure.line) {
      const name = materials[materialOf(now.job.document, figure.feature)]?.name ?? "";
      const here = Math.hypot(now.job.place[0] - figure.line[0], now.job.place[1] - figure.line[1]);
      reading.replaceChildren(ruleChart(now.rows, name, { length, here: here <= length ? here : null }), ruleTable(now.rows, name));
    }
  }

  /** @param {Point} at on the screen @param {boolean} isDrag */
  function put(at, isDrag) {
    const [[left, low], [right, high]] = box;
    const [x, y] = toPlane(view(), surface.size(), at);
    place = [Math.min(right, Math.max(left, x)), Math.min(high, Math.max(low, y))];
    touch(isDrag);
  }

  return {
    status,
    controls: figure.controls === "none" ? null : controls,
    show(next) {
      clearTimeout(idle);
      const given = /** @type {PartDocument} */ (/** @type {unknown} */ (next));
      [first, document, place, isMoving] = [given, given, figure.place, false];
      void open();
    },
    draw: paint,
    state: () => (document ? { document: /** @type {CurvesDocument} */ (/** @type {unknown} */ (document)), s: null, step: null } : null),
    close() {
      isOver = true;
      clearTimeout(idle);
      lane.cancel();
    },
  };

  /** The box does not change with what the reader does. */
  async function open() {
    const asked = first;
    if (!asked) return;
    try {
      const part = await kernel.part(asked);
      if (isOver || asked !== first) return;
      box = part.box ?? [[0, 0], [1, 1]];
      face();
      paint();
    } catch (error) {
      if (!isOver && asked === first) host.failed(error);
    }
  }
}

/** The shapes that features refer to by name. @param {PartDocument} document */
function references({ bodies }) {
  const all = bodies.flatMap(({ features = [] }) => features.flatMap(({ reference, references = {} }) => [reference, ...Object.values(references)]));
  return [...new Set(all.filter((each) => typeof each === "string"))];
}

/** @param {readonly number[]} at */
const written = ([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`;

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
