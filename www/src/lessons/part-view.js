/**
 * A figure of a part: painted from the kernel's colours, with its features, a place that is read, and a line along which compositions are shown
 * as a chart. The limit of a feature, its course and the overlap rule can be changed.
 *
 * @import { PartDocument, PartPlace, Point, RemotePart, View } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { Figure } from "../../../scripts/lib/lesson.mjs"
 * @import { FigureView, Host } from "./figure.js"
 * @import { Along, RuleRow } from "./part-known.js"
 *
 * @typedef {{document: PartDocument, place: Point | null, view: View, isMoving: boolean}} Job
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
import { fitting, toScreen } from "../../../js/element/plane.js";
import { segment } from "../controls/choices.js";
import { select } from "../controls/select.js";
import { attribute, h, svg } from "../dom.js";
import { fixed } from "../format.js";
import { Lane } from "../state/lane.js";
import { createChanging } from "./changing.js";
import { shownState } from "./document.js";
import { label, measure, parameter } from "./parameter.js";
import { COURSES, featureOf, materialOf, RULES, ruleRow, withFeature, withRule } from "./part-known.js";
import { readingOf } from "./part-reading.js";
import { lineOf, pathOf, referredTo } from "./part-shapes.js";
import { partsOf } from "./parts.js";
import { polyline } from "./path.js";
import { createPlaceHandle } from "./place-handle.js";
import { words } from "./words-part.js";

/** Room round the part, CSS pixels. */
const MARGIN = 38;
/** Pixels that are evaluated, at rest and while something is dragged. */
const MOST = 900_000;
const MOVING = 90_000;
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
  surface.element.prepend(canvas, /** @type {any} */ (over));

  /** @type {PartDocument | null} */
  let document = null;
  /** @type {PartDocument | null} */
  let first = null;
  /** @type {readonly Point[]} */
  let box = [];
  /** @type {Known | null} */
  let known = null;
  let isOver = false;

  const changing = createChanging(host, paint);
  const handle = createPlaceHandle(surface, {
    place: figure.place,
    digits: 1,
    ground: () => (document && box.length > 0 ? { view: view(), box } : null),
    changed: changing.touch,
    released: changing.rest,
    say: app.say,
  });
  const limits = figure.limit ?? [1, 2];
  const limit = parameter({ label: words.limit, name: "limit", min: limits[0], max: limits[1], step: (limits[1] - limits[0]) / STEPS }, (to) =>
    change({ to: Number(to.toPrecision(6)) }),
  );
  const course = select(
    { label: words.course, name: "lesson-course", choices: Object.entries(words.courses).map(([value, text]) => ({ value, text })) },
    (name) => change({ course: COURSES[/** @type {keyof typeof COURSES} */ (name)] }, false),
  );
  const rule = segment({ label: words.rule, name: "lesson-overlap", choices: RULES.map((value) => ({ value, text: words.rules[value] })) }, (next) => {
    if (!document) return;
    document = withRule(document, next);
    changing.touch(false);
  });
  const reading = h("div", { class: "cell-reading", "data-reading": figure.reading ?? "" });
  const controls = h(
    "div",
    { class: "cell-controls" },
    figure.limit ? limit.row : null,
    figure.courses || figure.overlap
      ? h(
          "div",
          { class: "cell-parameters" },
          figure.courses ? h("div", { class: "cell-parameter part-course" }, label(words.course), course.element) : null,
          figure.overlap ? h("div", { class: "cell-parameter part-rule" }, label(words.rule), rule.element) : null,
        )
      : null,
    reading,
  );

  /** @type {Lane<Job, Known>} */
  const lane = new Lane({
    work: ask,
    done(found) {
      if (isOver) return;
      known = found;
      host.failed(null);
      [canvas.width, canvas.height] = [found.picture.width, found.picture.height];
      canvas.getContext("2d")?.drawImage(found.picture, 0, 0);
      render();
      if (found.job.document === document && found.job.place === handle.place) host.element.dataset.drawn = "true";
    },
    failed: host.failed,
  });

  /** @param {Job} job @param {AbortSignal} signal @returns {Promise<Known>} */
  async function ask(job, signal) {
    const control = { signal };
    const part = await kernel.part(job.document, control);
    const ratio = surface.zoom * (window.devicePixelRatio || 1);
    const picture = await pictureOf(part, { view: job.view, size: surface.size(), ratio, most: job.isMoving ? MOVING : MOST }, control);
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
    return fitting(box, surface.size(), MARGIN);
  }

  function paint() {
    const { width, height } = surface.size();
    if (!document || width < 1 || height < 1) return;
    lane.push({ document, place: handle.place, view: view(), isMoving: changing.isMoving });
    drawOver();
  }

  /** @param {object} patch of the feature @param {boolean} [isDrag] */
  function change(patch, isDrag = true) {
    if (!document) return;
    document = withFeature(document, figure.feature, patch);
    changing.touch(isDrag);
  }

  function face() {
    const own = document && featureOf(document, figure.feature);
    if (!own) return;
    const unit = document?.unit ?? "mm";
    limit.set(own.to, words.unit(fixed(own.to, 1), unit));
    course.set(own.course?.kind ?? "linear");
    rule.set(document?.bodies[figure.feature[0]]?.rule ?? "repaired");
  }

  /** @param {Point} at */
  const seen = (at) => toScreen(view(), surface.size(), at);

  function drawOver() {
    if (!document) return;
    face();
    const { width, height } = surface.size();
    attribute(over, "viewBox", `0 0 ${width} ${height}`);
    const ground = { seen, scale: view().scale };
    const all = referredTo(document);
    const reference = featureOf(document, figure.feature)?.reference;
    const own = all.filter(({ name }) => name === reference);
    const draw = (/** @type {typeof all} */ some) => some.map((shape) => pathOf(shape, ground)).join("");
    attribute(shapes, "d", draw(all));
    attribute(chosen, "d", figure.limit || figure.reading ? draw(own) : "");
    const ends = figure.line ? [seen([figure.line[0], figure.line[1]]), seen([figure.line[2], figure.line[3]])] : [];
    attribute(line, "d", ends.length > 0 ? polyline(ends) : "");
    handle.render();
    const lines = (/** @type {typeof all} */ some) => ({ lines: some.map((shape) => lineOf(shape, ground)) });
    surface.name(
      partsOf(host.terms, {
        features: () => lines(all),
        feature: () => lines(own),
        section: () => ({ lines: ends.length > 0 ? [ends] : [] }),
        place: () => ({ dots: handle.place ? [seen(handle.place)] : [] }),
      }),
    );
  }

  function render() {
    drawOver();
    attribute(canvas, "aria-label", host.alt());
    const now = known;
    if (!now) return;
    const { materials = [] } = now.job.document;
    status.hidden = figure.controls === "none" || !now.job.place;
    // By the printed rule a place has what its voxel has, which the reading knows of the material of the feature.
    const printed = now.rows.find((row) => row.rule === "printed");
    const asked = materialOf(now.job.document, figure.feature);
    const fractions = now.found?.fractions ?? (printed ? materials.map((_, k) => (k === asked ? printed.here : 0)) : []);
    const shares = fractions.flatMap((fraction, k) => (fraction >= 5e-4 ? [measure(materials[k]?.name ?? "", fixed(fraction, 3), `mix-${k}`)] : []));
    status.replaceChildren(...(now.found ? shares : [h("span", {}, words.outside)]));
    const below = readingOf(figure, now);
    if (below.length > 0) reading.replaceChildren(...below);
  }

  return {
    status,
    controls: figure.controls === "none" ? null : controls,
    show(next) {
      changing.stop();
      handle.reset();
      first = document = /** @type {PartDocument} */ (/** @type {unknown} */ (next));
      void open();
    },
    draw: paint,
    state: () => shownState(document),
    close() {
      isOver = true;
      changing.stop();
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
      paint();
    } catch (error) {
      if (!isOver && asked === first) host.failed(error);
    }
  }
}
